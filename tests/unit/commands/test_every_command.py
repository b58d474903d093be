"""Every command, with and without its argument, through the interaction of a script."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from donnie_tui.bootstrap import Donnie, assemble
from donnie_tui.commands.declarations import COMMANDS, Command
from donnie_tui.commands.interaction import EnterWorld, SwitchMode
from donnie_tui.commands.lookup import typed_form, word_of
from donnie_tui.core.events import Answered, RunStarted, Stamped
from donnie_tui.settings.settings import Settings
from tests.unit.commands.scripted import Quit, Script


@pytest.fixture
def donnie() -> Iterator[Donnie]:
    made = assemble(Settings(world="living_room", speech="off", sound=False, speed=None), terminal=True)
    yield made
    made.close()


def answers_to(donnie: Donnie, line: str) -> list[str]:
    """What is answered to a line; a way out and the start of a run are answers, too."""
    answers: list[str] = []

    def note(stamped: Stamped) -> None:
        if isinstance(stamped.event, Answered):
            answers.append(stamped.event.text)
        elif isinstance(stamped.event, RunStarted):
            answers.append(stamped.event.program)

    script = Script(donnie)
    script.ctx.program.add("FW 1")
    donnie.session.hub.subscribe(note)
    try:
        assert script.type(line)
    except (EnterWorld, SwitchMode, Quit) as way_out:
        answers.append(type(way_out).__name__)
    finally:
        script.ctx.close()
    return answers or script.interaction.asked


STARTING = ("run", "start", "again", "step", "step_over")
"""What these start answers, in its own thread."""


@pytest.mark.parametrize(
    "command", [each for each in COMMANDS if each.name not in STARTING], ids=lambda each: each.name
)
def test_a_command_is_answered_as_it_is_typed(donnie: Donnie, command: Command) -> None:
    assert answers_to(donnie, word_of(command, "en"))
    assert answers_to(donnie, typed_form(command, donnie.words))


@pytest.mark.parametrize(
    "command", [each for each in COMMANDS if not (each.argument or each.is_godonnie or each.is_visual)]
)
def test_what_takes_no_argument_says_so(donnie: Donnie, command: Command) -> None:
    word = word_of(command, "en")

    assert answers_to(donnie, f"{word} nonsense") == [f"{word} takes nothing after it. Type {word} alone."]


@pytest.mark.parametrize("line", ["AROUND nonsense", "LAST nonsense", "LAST 0", "MAP 1", "READ x"])
def test_a_wrong_argument_is_answered_with_an_example(donnie: Donnie, line: str) -> None:
    (answer,) = answers_to(donnie, line)

    assert answer.startswith(f"I did not understand. Type {line.split()[0]} ")
