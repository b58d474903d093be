"""The terminal's normal screen: the end of the log after the end, the pager, and the end of its input."""

import signal
import threading
from contextlib import nullcontext
from types import SimpleNamespace

import pytest

from donnie_tui.tui import environment
from donnie_tui.tui.terminal import _stop_reading


def test_the_last_twenty_lines_are_left_behind_in_their_order(capsys, monkeypatch):
    monkeypatch.delenv("TEXTUAL_DRIVER", raising=False)
    environment.print_last_lines([f"line {i}" for i in range(30)])

    assert capsys.readouterr().out.splitlines() == [f"line {i}" for i in range(10, 30)]


async def test_a_pager_that_can_not_be_run_is_reported_in_a_sentence(open_screen, monkeypatch, tmp_path):
    broken = tmp_path / "pager"
    broken.write_text("no program")
    broken.chmod(0o755)
    monkeypatch.setenv("PAGER", str(broken))
    async with open_screen() as screen:
        monkeypatch.setattr(screen.app, "suspend", nullcontext)
        await screen.type_line("LOG")
        await screen.shows("The log can't be shown: Exec format error. SAVE LOG writes it into a file.")


@pytest.fixture
def size_handler():
    """Set as Textual's driver sets one, and given back."""
    before = signal.getsignal(signal.SIGWINCH)
    signal.signal(signal.SIGWINCH, handler := lambda *_: None)
    yield handler
    signal.signal(signal.SIGWINCH, before)


def test_the_thread_that_reads_the_terminal_is_ended_and_the_size_watched_no_more(size_handler):
    done = []
    driver = SimpleNamespace(
        exit_event=threading.Event(),
        _disable_mouse_support=lambda: done.append("no mouse"),
        _key_thread=SimpleNamespace(join=lambda: done.append("joined")),
    )

    _stop_reading(driver)

    assert signal.getsignal(signal.SIGWINCH) == signal.SIG_DFL
    assert driver.exit_event.is_set()
    assert done == ["no mouse", "joined"]


def test_a_terminal_that_is_not_read_any_more_is_left_as_it_is(size_handler):
    driver = SimpleNamespace(exit_event=threading.Event())
    driver.exit_event.set()

    _stop_reading(driver)

    assert signal.getsignal(signal.SIGWINCH) is size_handler
