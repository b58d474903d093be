"""The real program on a real terminal, with too much of everything."""

import fcntl
import signal
import struct
import termios

import pytest

from tests.timeouts import TIMEOUT
from tests.tui.terminal import CTRL_Z, F5, F8, Terminal, falls_silent

pytestmark = pytest.mark.slow

PASTE = "\x1b[200~{}\x1b[201~"
"""As a terminal sends what is pasted."""


def send(donnie: Terminal, text: str) -> None:
    """In pieces, as a line of this size is filled only as fast as it is read."""
    for at in range(0, len(text), 1000):
        donnie.type(text[at : at + 1000])
        donnie.read(0.0)


def resize(donnie: Terminal, columns: int, rows: int) -> None:
    """A smaller terminal loses what has no room in it; one that grows has empty rows and columns."""
    donnie.screen.resize(rows, columns)
    fcntl.ioctl(donnie._master, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))


def test_five_thousand_pasted_lines_are_a_program_that_runs_and_is_undone_at_once(terminal):
    donnie = terminal("--world", "open_floor")
    send(donnie, PASTE.format("VAR a = 1\r" + "a = a + 1\r" * 4998 + "SPEAK a"))
    donnie.shows("line 5000 of 5000")
    donnie.type(F5)
    donnie.shows("says       4999")
    donnie.shows("READY")
    donnie.type(CTRL_Z)
    donnie.shows("line 1 of 1")


def test_a_program_that_prints_a_hundred_thousand_lines_comes_to_its_end(terminal):
    donnie = terminal("--world", "open_floor", "--speed", "max")
    donnie.type("FOR VAR i = 0; i < 100000; i = i + 1 DO SPEAK i END FOR SPEAK 77")
    donnie.type(F5)
    donnie.shows("says       77")
    donnie.shows("READY")
    donnie.type(F8)
    donnie.shows("Nothing is running.")
    assert len(donnie.raw) < 1_000_000, "what the terminal does not read is not sent"


@pytest.mark.parametrize("program", ["FW 1000", "WHILE 1 == 1 DO VAR x = 1 END WHILE"])
def test_the_size_may_change_to_twenty_by_five_and_back_while_a_program_runs(terminal, program):
    donnie = terminal("--world", "open_floor", "--speed", "1")
    donnie.type(program)
    donnie.shows(f"1  {program[:20]}")
    donnie.type(F5)
    donnie.shows("RUNNING x1")
    before = tuple(donnie.screen.display)
    resize(donnie, 20, 5)
    donnie.process.send_signal(signal.SIGWINCH)
    donnie.until(lambda: donnie.screen.display[0].startswith(">Program"), "the small screen")
    resize(donnie, 80, 24)
    donnie.process.send_signal(signal.SIGWINCH)
    donnie.shows("Map:")
    donnie.shows("RUNNING x1")
    donnie.type(F8)
    donnie.shows("STOPPED")
    donnie.shows(f"1  {program[:20]}")
    assert falls_silent(donnie, 1.0)
    after = donnie.screen.display
    assert [row for row, was in zip(after, before, strict=True) if was.strip() and not row.strip()] == []


def test_a_terminal_that_is_as_large_again_before_that_was_noticed_is_painted_whole(terminal):
    donnie = terminal()
    donnie.shows("F5 Run")
    assert falls_silent(donnie, 1.0)
    before = tuple(donnie.screen.display)
    resize(donnie, 20, 5)
    resize(donnie, 80, 24)
    donnie.process.send_signal(signal.SIGWINCH)

    donnie.until(lambda: tuple(donnie.screen.display) == before, "the whole screen again")


def test_a_line_of_two_hundred_thousand_letters_is_kept_and_what_is_typed_after_it_is_seen(
    terminal, tmp_path
):
    donnie = terminal("--world", "open_floor")
    send(donnie, PASTE.format("-- " + "a" * 200_000))
    donnie.type(" xyz")
    donnie.shows("xyz")
    donnie.process.send_signal(signal.SIGHUP)

    assert donnie.ended() == 128 + signal.SIGHUP
    copies = list((tmp_path / ".local/state/donnie/unsaved").glob("*.gd"))
    assert [each.read_text(encoding="utf-8") for each in copies] == [f"-- {'a' * 200_000} xyz\n"]


def test_a_terminal_that_dies_in_a_flood_ends_the_program(terminal, tmp_path):
    donnie = terminal("--world", "open_floor", "--speed", "max", controls=True)
    donnie.type('WHILE 1 == 1 DO SPEAK "again" END WHILE')
    donnie.type(F5)
    donnie.shows("says       again")
    donnie.hang_up()

    assert donnie.process.wait(TIMEOUT) == 128 + signal.SIGHUP
    copies = list((tmp_path / ".local/state/donnie/unsaved").glob("*.gd"))
    assert [each.read_text(encoding="utf-8") for each in copies] == [
        'WHILE 1 == 1 DO SPEAK "again" END WHILE\n'
    ]
