"""The words about several robots: their effect on the session and their answers."""

from __future__ import annotations

import threading
from collections.abc import Iterator

import pytest

from donnie_tui.bootstrap import Donnie, assemble
from donnie_tui.core import session
from donnie_tui.core.events import Answered, Stamped
from donnie_tui.core.run_controller import RunController
from donnie_tui.core.runner import RunRequest
from donnie_tui.settings.settings import Settings
from language.parser import Parsed
from tests.timeouts import TIMEOUT


@pytest.fixture
def donnie() -> Iterator[Donnie]:
    made = assemble(Settings(world="two_robots", speech="off", sound=False, speed=None), terminal=True)
    yield made
    made.close()


def answers(donnie: Donnie) -> list[str]:
    sentences: list[str] = []

    def remember(stamped: Stamped) -> None:
        if isinstance(stamped.event, Answered):
            sentences.append(stamped.event.text)

    donnie.session.hub.subscribe(remember)
    return sentences


@pytest.mark.parametrize(("text", "sentences"), [("FW 1", ["alice begins."]), ("FWD 1", [])])
def test_a_started_program_is_parsed_once_and_in_its_own_thread(
    donnie: Donnie, monkeypatch: pytest.MonkeyPatch, text: str, sentences: list[str]
) -> None:
    readers: list[threading.Thread] = []
    parse = session.parse

    def parsed(*args: object, **options: object) -> Parsed:
        readers.append(threading.current_thread())
        return parse(*args, **options)  # type: ignore[arg-type] -- as it was called

    monkeypatch.setattr(session, "parse", parsed)
    said = answers(donnie)
    runs = RunController(donnie.team, donnie.words, donnie.chronicle, has_prompt=True)
    run = runs.start_in_background(RunRequest(text, "a.gd"))

    assert run.wait(TIMEOUT)
    assert len(readers) == 1
    assert readers[0] is not threading.current_thread()
    assert said == sentences


def test_a_program_is_parsed_while_another_robot_computes_without_end(donnie: Donnie) -> None:
    endless = donnie.session.start("VAR x = 0\nWHILE 1 == 1 DO\nx = x + 1\nEND WHILE", "a.gd")
    donnie.team.choose("bob")
    run = donnie.session.start("FWD 1", "b.gd")

    assert run.wait_until_read(TIMEOUT)
    assert run.was_refused
    donnie.team.stop()
    assert endless.wait(TIMEOUT)
