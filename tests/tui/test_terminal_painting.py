"""What the full screen writes to a real terminal: where its cursor stands, what changed, all of it anew."""

import fcntl
import os
import signal
import struct
import termios

import pytest

from tests.tui.terminal import (
    CTRL_Q,
    ENTER,
    TAB,
    Terminal,
    falls_silent,
    under_the_cursor,
)

pytestmark = pytest.mark.slow


def test_the_terminal_s_cursor_is_visible_and_stands_at_the_focus(terminal):
    donnie = terminal()
    donnie.type("FW 1")
    donnie.shows("1  FW 1")
    donnie.until(
        lambda: (donnie.screen.cursor.x, donnie.screen.cursor.y) == (9, 1), "the cursor in the program"
    )
    donnie.type(TAB)
    donnie.shows(" Map. Donnie")
    donnie.until(lambda: under_the_cursor(donnie)[1] == "^", "the cursor at the robot")
    donnie.type(TAB)
    donnie.shows(" Log, line")
    donnie.until(lambda: under_the_cursor(donnie)[1] == ">", "the cursor at the row of the log")
    donnie.type(TAB)
    donnie.shows(" Command line.")

    donnie.until(lambda: under_the_cursor(donnie) == ("> ", " "), "the cursor in the command line")
    assert not donnie.screen.cursor.hidden


def test_the_size_of_the_terminal_may_change(terminal):
    donnie = terminal()
    for columns, rows in ((40, 12), (120, 40)):
        donnie.screen.resize(rows, columns)
        fcntl.ioctl(donnie._master, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))
        donnie.process.send_signal(signal.SIGWINCH)
        donnie.shows("READY")

    donnie.shows("No variables.")


def written_over(donnie: Terminal) -> tuple[str, ...]:
    """What the idle screen showed, before something else wrote into all of its rows."""
    assert falls_silent(donnie, 1.0)
    before = tuple(donnie.screen.display)
    donnie._stream.feed(b"".join(b"\x1b[%d;1HMessage from root" % row for row in range(1, 25)))
    return before


def test_what_something_else_wrote_over_the_screen_goes_away_when_it_is_painted_anew(terminal):
    donnie = terminal()
    before = written_over(donnie)
    donnie.type("\x0b\x1b[15~")
    donnie.shows("The screen is drawn again.")

    donnie.until(lambda: "Message from root" not in "\n".join(donnie.screen.display), "the screen anew")
    assert donnie.screen.display[:14] == list(before[:14])


def test_a_process_that_goes_on_paints_the_whole_screen(terminal):
    donnie = terminal(is_job=True)
    donnie.process.send_signal(signal.SIGTSTP)
    # read meanwhile: a process may wait with its suspension until its output was read
    donnie.until(lambda: os.waitpid(donnie.process.pid, os.WUNTRACED | os.WNOHANG)[0], "the suspension")
    before = written_over(donnie)
    donnie.process.send_signal(signal.SIGCONT)

    donnie.until(lambda: tuple(donnie.screen.display) == before, "the screen as it was")
    assert not donnie.screen.cursor.hidden


def test_after_a_change_of_size_nothing_is_left_that_something_else_wrote(terminal):
    donnie = terminal()
    written_over(donnie)
    donnie.screen.resize(24, 90)
    fcntl.ioctl(donnie._master, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 90, 0, 0))
    donnie.process.send_signal(signal.SIGWINCH)

    donnie.until(lambda: "Message from root" not in "\n".join(donnie.screen.display), "the screen anew")


def test_the_cursor_stands_right_after_what_is_typed(terminal):
    donnie = terminal()
    donnie.type("x" + TAB * 3)
    donnie.shows(" Command line.")
    donnie.type("FW 12")
    donnie.shows("> FW 12")
    donnie.until(lambda: under_the_cursor(donnie) == ("> FW 12", " "), "the cursor after the command")
    donnie.type("\x1b[D")
    donnie.until(lambda: under_the_cursor(donnie) == ("> FW 1", "2"), "the cursor at the last letter")
    donnie.type(CTRL_Q)
    donnie.shows("Save first, y or n?")
    donnie.type("maybe")
    donnie.until(lambda: under_the_cursor(donnie) == ("maybe", " "), "the cursor after the answer")


def test_everything_is_painted_again_after_another_program_had_the_terminal(terminal, tmp_path):
    """Into the same rows and columns: what is still the same was written over, too."""
    less = tmp_path / "less"
    less.write_text('#!/bin/sh\nprintf "\\033[2J\\033[1;1Hthe pager"\nread -r line\n')
    less.chmod(0o755)
    donnie = terminal("--world", "living_room", PATH=f"{tmp_path}:{os.environ['PATH']}", PAGER="less")
    donnie.type("FW 1")
    donnie.shows("1  FW 1")
    assert falls_silent(donnie, 1.0)
    before = tuple(donnie.screen.display)
    donnie.type(TAB * 3 + "LOG" + ENTER)
    donnie.shows("the pager")
    donnie.type(ENTER)

    donnie.shows("1  FW 1")
    assert falls_silent(donnie, 1.0)
    painted = tuple(donnie.screen.display)
    assert [was for was, row in zip(before, painted, strict=True) if was.strip() and not row.strip()] == []
    assert painted[0][1:] == before[0][1:]
