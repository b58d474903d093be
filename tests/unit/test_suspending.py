"""Whether a suspended process still has a terminal that could resume it."""

import os

from donnie_tui.process.signals import is_hung_up


def test_a_terminal_that_was_closed_is_gone() -> None:
    ours, terminal = os.openpty()
    try:
        assert not is_hung_up(terminal)
        os.close(ours)
        assert is_hung_up(terminal)
    finally:
        os.close(terminal)


def test_a_pipe_with_a_closed_writer_is_no_terminal() -> None:
    reading, writing = os.pipe()
    os.close(writing)
    try:
        assert not is_hung_up(reading)
    finally:
        os.close(reading)
