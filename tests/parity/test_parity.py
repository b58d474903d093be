"""Every word of the use cases has the same outcome in the linear mode and on the full screen.

Idle, while a program runs, and while one is held; alone, with what may follow it, and with what may not.
Where the two still differ, ``differences.toml`` says so, and what is decided. Nothing else may differ, and
every case that stands there must.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.lookup import words_of
from tests.parity.cases import GROUPS, HELD, IDLE, RUNNING, Group
from tests.parity.rules import is_same
from tests.parity.table import decisions, differences, outcomes, shown


@pytest.mark.parametrize("group", GROUPS, ids=lambda each: each.cases[0])
async def test_a_line_has_the_same_outcome_in_both_front_ends(group: Group, tmp_path: Path) -> None:
    known = differences()
    wrong: list[str] = []
    for case, line, linear, screen in await outcomes(group, tmp_path):
        differs = not is_same(case, line, linear, screen)
        if differs and case not in known:
            wrong.append(f"{case}\n  linear: {shown(linear)}\n  screen: {shown(screen)}")
        elif not differs and case in known:
            wrong.append(f"{case}\n  no longer differs: take it out of differences.toml (table.py does that)")
    assert not wrong, "\n".join(wrong)


def test_the_table_has_only_existing_cases_and_made_decisions() -> None:
    cases = {case for group in GROUPS for case in group.cases}
    assert [case for case in differences() if case not in cases] == []
    assert {each.decision for each in differences().values()} == set(decisions())


@pytest.mark.parametrize("situation", [IDLE, RUNNING, HELD])
def test_every_word_is_typed_in_every_situation(situation: str) -> None:
    typed = {line for group in GROUPS if _is_in(group, situation) for line in group.lines}
    commands = (each for each in COMMANDS if not each.is_visual)
    words = [word for each in commands for word in words_of(each.name, "en")]
    assert [word for word in words if not _is_typed(word, typed)] == []


def _is_in(group: Group, situation: str) -> bool:
    others = {RUNNING, HELD} - {situation}
    return situation in group.name or (situation == IDLE and not any(each in group.name for each in others))


def _is_typed(word: str, typed: set[str]) -> bool:
    return any(line == word or line.startswith(f"{word} ") for line in typed)
