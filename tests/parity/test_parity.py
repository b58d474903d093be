"""Every word of the use cases has the same outcome in the linear mode and on the full screen.

Idle, while a program runs, and while one is held; alone, with what may follow it, and with what may not.
What may differ is in ``rules.py``.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.lookup import words_of
from tests.parity.cases import GROUPS, HELD, IDLE, RUNNING, Group
from tests.parity.compare import in_linear_mode, on_full_screen
from tests.parity.rules import is_same


def _marked(group: Group) -> Any:
    """The same words while a program runs or is held take a minute more.

    The id has all the lines, so that ``-k WHERE`` finds those with that word.
    """
    is_slow = group.name in (RUNNING, HELD)
    name = f"{group.name}: {', '.join(group.lines)}"
    return pytest.param(group, marks=pytest.mark.slow if is_slow else (), id=name)


@pytest.mark.parametrize("group", map(_marked, GROUPS))
async def test_a_line_has_the_same_outcome_in_both_front_ends(group: Group, tmp_path: Path) -> None:
    linear = in_linear_mode(group, tmp_path / "linear")
    screen = await on_full_screen(group, tmp_path / "screen")
    wrong = [
        f"{case}\n  linear: {of_linear.as_text()}\n  screen: {of_screen.as_text()}"
        for case, line, of_linear, of_screen in zip(group.cases, group.lines, linear, screen, strict=True)
        if not is_same(case, line, of_linear, of_screen)
    ]

    assert not wrong, "\n".join(wrong)


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
