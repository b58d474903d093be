"""Each program in the folders here prints exactly the text of its ``.output`` file.

A program is in the folder of its language; ``-- world: NAME`` in its first line selects its world.
The last line of ``.output`` is the outcome and the pose. After an intended change, read the difference
and write the files again with ``DONNIE_ACCEPT=1 pytest tests/programs``.
"""

import os
import re
from pathlib import Path

import pytest

from donnie_tui.bootstrap import assemble
from donnie_tui.core.events import Event, RunEnded
from donnie_tui.core.session import RunOptions
from donnie_tui.core.transcript import lines_of
from donnie_tui.settings.settings import Settings
from tests.timeouts import TIMEOUT

FOLDER = Path(__file__).parent
PROGRAMS = sorted(FOLDER.glob("*/*.gd"))


def output_of(program: Path) -> str:
    """The printed lines of a run, and its end."""
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
        assert donnie.session.start(text, program.name, RunOptions(fresh=True, hooked=False)).wait(TIMEOUT)
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
def test_a_program_prints_its_expected_output(program: Path) -> None:
    expected = program.with_suffix(".output")
    output = output_of(program)
    if os.environ.get("DONNIE_ACCEPT"):
        expected.write_text(output, encoding="utf-8")

    assert output == expected.read_text(encoding="utf-8")


def test_every_expected_output_has_its_program() -> None:
    output = {each.with_suffix("") for each in FOLDER.glob("*/*.output")}

    assert output == {each.with_suffix("") for each in PROGRAMS}


@pytest.mark.parametrize("language", ["pt", "es"])
def test_a_square_is_the_same_in_every_language(language: str) -> None:
    name = {"pt": "quadrado", "es": "cuadrado"}[language]

    output = output_of(FOLDER / language / f"{name}.gd").splitlines()

    assert output[-1] == "(completed: 0 0 0)"
