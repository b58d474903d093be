"""Each program beside this file does what the ``.told`` beside it says, to the word.

A program stands in the folder of its language; ``-- world: NAME`` in its first line gives it a world.
The last line of ``.told`` is the outcome and the pose. After a change that is wanted, read the difference
and write the files anew with ``DONNIE_ACCEPT=1 pytest tests/programs``.
"""

import os
import re
from pathlib import Path

import pytest

from donnie_tui.bootstrap import assemble
from donnie_tui.core.events import Event, RunEnded
from donnie_tui.core.transcript import lines_of
from donnie_tui.settings.chosen import Settings
from tests.patience import PATIENCE

FOLDER = Path(__file__).parent
PROGRAMS = sorted(FOLDER.glob("*/*.gd"))


def told_by(program: Path) -> str:
    """What a run prints, and how it ended."""
    text = program.read_text(encoding="utf-8")
    world = re.match(r"-- world: (\w+)", text)
    settings = Settings(
        world=world[1] if world else "open_floor",
        language=language_of(program),
        speed=None,
        speech="off",
        sound=False,
    )
    donnie = assemble(settings, terminal=False)
    try:
        events: list[Event] = []
        donnie.session.hub.subscribe(lambda stamped: events.append(stamped.event))
        assert donnie.session.start(text, program.name, fresh=True, hooked=False).wait(PATIENCE)
        lines = [line for event in events for line in lines_of(event, donnie.words)]
        return "".join(f"{line}\n" for line in (*lines, ending(events[-1])))
    finally:
        donnie.close()


def language_of(program: Path) -> str:
    return program.parent.name if program.parent.name in ("pt", "es") else "en"


def ending(event: Event) -> str:
    assert isinstance(event, RunEnded)
    pose = event.pose
    return f"({event.outcome.value}: {pose.x:g} {pose.y:g} {pose.heading:g})"


@pytest.mark.parametrize("program", PROGRAMS, ids=[f"{each.parent.name}/{each.stem}" for each in PROGRAMS])
def test_a_program_does_what_is_written_beside_it(program: Path) -> None:
    expected = program.with_suffix(".told")
    told = told_by(program)
    if os.environ.get("DONNIE_ACCEPT"):
        expected.write_text(told, encoding="utf-8")

    assert told == expected.read_text(encoding="utf-8")


def test_no_expectation_is_left_over() -> None:
    told = {each.with_suffix("") for each in FOLDER.glob("*/*.told")}

    assert told == {each.with_suffix("") for each in PROGRAMS}


@pytest.mark.parametrize("language", ["pt", "es"])
def test_a_square_is_the_same_in_every_language(language: str) -> None:
    name = {"pt": "quadrado", "es": "cuadrado"}[language]

    told = told_by(FOLDER / language / f"{name}.gd").splitlines()

    assert told[-1] == "(completed: 0 0 0)"
