"""What a screen reader makes of the linear mode (Gate 1 of the accessibility requirements, a short lesson).

The long lesson: ``python -m tests.readers.gate yasr`` (or ``fenrir``, or ``brltty``).
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.readers.hearing import Phase, is_whole, score, shown
from tests.readers.lesson import SHORT
from tests.readers.reading import AS_PROMPT, BRIEF, is_installed, phases_of

OPTIONS = ("--world", "living_room")


def needs(reader: str) -> pytest.MarkDecorator:
    return pytest.mark.skipif(not is_installed(reader), reason=f"needs {reader}")


@needs("yasr")
def test_yasr_says_every_answer_once_in_order_and_nothing_else(tmp_path: Path) -> None:
    heard = score(phases_of("yasr", SHORT, tmp_path, OPTIONS))
    assert (heard.once, heard.in_order, heard.clean, heard.noise) == (1.0, 1.0, heard.phases, 0.0)


@needs("fenrir")
def test_fenrir_says_every_answer_once_with_little_noise(tmp_path: Path) -> None:
    heard = score(phases_of("fenrir", SHORT, tmp_path, OPTIONS))
    assert heard.once == 1.0
    assert heard.noise <= 0.05


@needs("brltty")
def test_the_last_line_of_every_answer_is_under_the_fingers(tmp_path: Path) -> None:
    """B2: a display of 40 cells shows it without a key, whole unless it leaves no room for the cursor."""
    phases = phases_of("brltty", SHORT, tmp_path, (*OPTIONS, *BRIEF), AS_PROMPT)[1:]
    assert [(each.command, each.heard[-1:]) for each in phases if not shown(each)] == []
    assert sum(map(is_whole, phases)) >= len(phases) - 1


def test_what_a_display_shows_last_counts() -> None:
    assert shown(Phase("SPEAK 5", ("4", "5"), ("SPEAK 5", "4 5", "5")))
    assert not shown(Phase("SPEAK 5", ("5",), ("5", ">")))
    assert not shown(Phase("SPEAK 5", ("5",), ()))
    long = Phase("STATE", ("a" * 41 + "b.",), ("ab.",))
    assert shown(long)
    assert not is_whole(long)


def test_what_is_heard_twice_or_besides_is_counted() -> None:
    phases = [
        Phase("FW 3", ("I walked 3 steps.",), ("I walked 3 steps.",)),
        Phase("FW 2", ("I walked 2 steps.",), ("FW 2", "I walked 2 steps.")),
        Phase("POS", ("Here.", "Facing north."), ("Here.", "Here.", "Facing north.", "2>"), "2> "),
        Phase("SCAN", ("Nothing here.",), ()),
    ]
    heard = score(phases)
    assert (heard.clean, heard.phases) == (1, 4)
    assert heard.once == 3 / 5
    assert heard.in_order == pytest.approx(11 / 13)
    assert heard.noise == pytest.approx(3 / 14)
