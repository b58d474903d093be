"""The words about several robots: what they do at the session, and what is told of it."""

from __future__ import annotations

import threading
from collections.abc import Iterator

import pytest

from donnie_tui.bootstrap import Donnie, assemble
from donnie_tui.core import session
from donnie_tui.core.events import Answered, Stamped
from donnie_tui.settings.chosen import Settings
from donnie_tui.words import team_words
from language.parser import Parsed
from tests.patience import PATIENCE


@pytest.fixture
def donnie() -> Iterator[Donnie]:
    made = assemble(Settings(world="two_robots", speech="off", sound=False, speed=None), terminal=True)
    yield made
    made.close()


def answers(donnie: Donnie) -> list[str]:
    told: list[str] = []

    def hear(stamped: Stamped) -> None:
        if isinstance(stamped.event, Answered):
            told.append(stamped.event.text)

    donnie.session.hub.subscribe(hear)
    return told


@pytest.mark.parametrize(("text", "told"), [("FW 1", ["alice begins."]), ("FWD 1", [])])
def test_a_program_that_starts_is_read_once_and_in_its_own_thread(
    donnie: Donnie, monkeypatch: pytest.MonkeyPatch, text: str, told: list[str]
) -> None:
    readers: list[threading.Thread] = []
    parse = session.parse

    def parsed(*args: object, **options: object) -> Parsed:
        readers.append(threading.current_thread())
        return parse(*args, **options)  # type: ignore[arg-type] -- as it was called

    monkeypatch.setattr(session, "parse", parsed)
    said = answers(donnie)
    run = team_words.start(donnie, text, "a.gd")

    assert run is not None
    assert run.wait(PATIENCE)
    assert len(readers) == 1
    assert readers[0] is not threading.current_thread()
    assert said == told


def test_a_program_is_read_while_another_robot_computes_without_end(donnie: Donnie) -> None:
    endless = donnie.session.start("VAR x = 0\nWHILE 1 == 1 DO\nx = x + 1\nEND WHILE", "a.gd")
    donnie.team.choose("bob")
    run = donnie.session.start("FWD 1", "b.gd")

    assert run.wait_until_read(PATIENCE)
    assert run.was_refused
    donnie.team.stop()
    assert endless.wait(PATIENCE)
