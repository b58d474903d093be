"""A port that is gone is told in a word of ours, wherever that is noticed; a stuck line is given up."""

from __future__ import annotations

import os
import termios
import threading
from contextlib import suppress

import pytest

from devices.port_talk.asking import ask
from devices.serial_port import GONE, PortFault, PortProblem, open_port
from donnie_tui.i18n.words import Words
from tests.patience import PATIENCE
from tests.unit.devices.board_line import BoardLine, opening


def test_a_port_that_goes_away_while_its_speed_is_set_is_a_problem_with_the_systems_word() -> None:
    class Stuck(BoardLine):
        def set_speed(self, baud: int) -> None:
            raise termios.error(5, "whatever")

    line = Stuck(None)
    with pytest.raises(PortProblem) as caught:
        ask("port", opening(line))
    assert (caught.value.fault, caught.value.reason) == (PortFault.ABSENT, "Input/output error")
    assert line.is_closed


def test_a_terminals_error_while_opening_is_a_problem(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_url: object, **_how: object) -> None:
        raise termios.error(5, "whatever")

    monkeypatch.setattr("serial.serial_for_url", fail)
    with pytest.raises(PortProblem) as caught:
        open_port("port", 9600)
    assert (caught.value.fault, caught.value.reason) == (PortFault.UNUSABLE, "Input/output error")


@pytest.mark.parametrize(
    "address", ["hwgrep://[", "loop://?logging=loud", "socket://robot", "rfc2217://robot"]
)
def test_an_address_that_is_not_understood_is_a_problem_in_a_word_of_ours(address: str) -> None:
    with pytest.raises(PortProblem) as caught:
        open_port(address, 9600)
    assert (caught.value.fault, caught.value.reason) == (PortFault.UNUSABLE, "Invalid argument")
    told = Words("pt")("problem-port-failed", port=address, reason=caught.value.reason)
    assert told.endswith("não se entende.")


def test_a_line_that_takes_no_bytes_is_given_up() -> None:
    """Nobody reads at its other end."""
    ours, theirs = os.openpty()
    port = open_port(os.ttyname(theirs), 9600)
    given_up = threading.Event()

    def write() -> None:
        with suppress(*GONE):
            port.write(bytes(1_000_000))
        given_up.set()

    threading.Thread(target=write, daemon=True).start()
    assert given_up.wait(PATIENCE)
    port.close()
    os.close(theirs)
    os.close(ours)
