"""The voice of the linear mode, recorded by a fake speech-dispatcher."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.sessions.learner import BACKSPACE, CTRL_D, Learner, until
from tests.unit.ssip.server import Server

pytestmark = pytest.mark.slow

CANCEL = "CANCEL SELF"


@pytest.fixture
def server(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[Server]:
    """It never reports an end: a sentence lasts until it is silenced."""
    made = Server(tmp_path, reports_end=False)
    monkeypatch.setenv("SPEECHD_ADDRESS", f"unix_socket:{made.address.path}")
    yield made
    made.close()


@pytest.fixture
def learner(server: Server, tmp_path: Path) -> Learner:
    return greeted(server, Learner(tmp_path, "--speech", "ssip"))


def greeted(server: Server, learner: Learner) -> Learner:
    """The session after its greeting. Later entries of the server are about the rest."""
    learner.sees_prompt()
    assert server.wait_for(texts=1)
    learner.types(f" {BACKSPACE}")
    assert server.wait_for(command=CANCEL)
    server.texts.clear()
    server.commands.clear()
    return learner


@pytest.mark.parametrize(
    ("language", "mode", "hint"),
    [
        ("en", "Linear mode, from the option.", "HELP lists the commands."),
        ("pt", "Modo linear, pedido na opção.", "AJUDA lista os comandos."),
        ("es", "Modo lineal, como pediste.", "AYUDA lista los comandos."),
    ],
)
def test_the_greeting_is_said(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, language: str, mode: str, hint: str
) -> None:
    """A learner without a screen reader hears from the voice that Donnie is there."""
    server = Server(tmp_path)
    monkeypatch.setenv("SPEECHD_ADDRESS", f"unix_socket:{server.address.path}")
    learner = Learner(tmp_path, "--speech", "ssip", language=language)
    assert server.wait_for(texts=2)
    assert server.texts == [mode, hint]
    learner.types(CTRL_D)
    learner.leaves()
    server.close()


def test_any_key_ends_what_is_being_said(server: Server, learner: Learner) -> None:
    """The voice says the answer, and any key ends it."""
    learner.types("WHERE\r")
    assert server.has_said("Position 0, 0.")
    silenced = server.commands.count(CANCEL)
    learner.sees("Facing north.\r\n> ")
    assert server.commands.count(CANCEL) == silenced

    learner.types("x")

    until(lambda: server.commands.count(CANCEL) > silenced)


def test_quiet_is_answered_in_print_and_last_repeats_the_silenced_answer(
    server: Server, learner: Learner
) -> None:
    """The voice does not say the lines after the silenced one."""
    learner.types("WHERE\r")
    learner.sees("Facing north.\r\n> ")
    assert server.wait_for(texts=1)
    learner.types("QUIET\r")
    learner.sees("Quiet. LAST says it again.\r\n> ")
    assert server.wait_for(command=CANCEL)
    learner.types("LAST\r")
    learner.sees("Position 0, 0. Facing north.\r\n> ")
    assert server.wait_for(texts=2)
    assert server.texts[:2] == ["Position 0, 0.", "Position 0, 0."]


def test_control_c_ends_program_and_voice(server: Server, tmp_path: Path) -> None:
    """The voice still says the sentences after a key. The stop ends it."""
    learner = greeted(server, Learner(tmp_path, "--speech", "ssip", speed="1"))
    learner.types('SPEAK "one" WAIT 1 SPEAK "two" WAIT 1000\r\r')
    assert server.wait_for(texts=1)
    learner.types("x")
    assert server.wait_for(command=CANCEL)
    until(lambda: "two" in server.texts)
    before = server.commands.count(CANCEL)
    learner.types("\x03")
    learner.sees("Stopped at line 1.\r\n> ")
    until(lambda: server.commands.count(CANCEL) > before)


def test_a_key_ends_the_voice_of_a_program_that_talks_without_end(server: Server, tmp_path: Path) -> None:
    """Also while its lines are printed block by block. A typed word reaches the program."""
    learner = greeted(server, Learner(tmp_path, "--speech", "ssip", speed="1"))
    learner.types('WHILE 1 == 1 DO SPEAK "hello" END WHILE\r\r')
    assert server.wait_for(texts=1)
    learner.types("x")
    assert server.wait_for(command=CANCEL)
    learner.types("\x7fQUIET\r")
    learner.sees("Quiet. LAST says it again.")
    learner.types("STOP\r")
    learner.sees("Stopped at line 1.\r\n> ")
