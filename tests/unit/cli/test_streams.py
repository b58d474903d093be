"""Standard input, output and error of the commands: what is written, lost, and read."""

from __future__ import annotations

import errno
import io
import os
import select
import sys
import threading
from collections.abc import Callable

import pytest

from donnie_tui.cli.streams import Guarded, Input, Output, is_terminal, let_sound
from tests.timeouts import TIMEOUT


class Failing(io.StringIO):
    """Fails at each write, or at the end."""

    def __init__(self, problem: Exception) -> None:
        super().__init__()
        self.problem = problem
        self.tries = 0

    def write(self, text: str) -> int:
        self.tries += 1
        raise self.problem

    def flush(self) -> None:
        raise self.problem


def test_lines_and_complaints_have_nothing_that_a_terminal_obeys() -> None:
    out, err = io.StringIO(), io.StringIO()
    output = Output(out, err)
    output.line("a\x1b[31mb")
    output.line("ação")
    output.text("as it is\x07")
    output.complaint("one", "two\x1b")

    assert "\x1b" not in out.getvalue() + err.getvalue()
    assert out.getvalue().splitlines()[1:] == ["ação", "as it is\x07"]
    assert len(err.getvalue().splitlines()) == 2
    assert err.getvalue().startswith("one\ntwo")


@pytest.mark.parametrize(
    ("problem", "reason"),
    [
        (BrokenPipeError(), None),
        (OSError(errno.ENOSPC, "No space left"), "No space left"),
        (ValueError("I/O operation on closed file"), "I/O operation on closed file"),
    ],
)
def test_output_that_is_lost_ends_once_and_has_its_reason(problem: Exception, reason: str | None) -> None:
    stream = Failing(problem)
    output, told = Output(stream, io.StringIO()), list[str]()
    output.on_broken = lambda: told.append("broken")
    guarded = Guarded(output)
    assert not guarded.closed
    assert guarded.write("four") == 4
    output.line("more")
    output.finish()

    assert (output.is_broken, output.problem, told, stream.tries, guarded.closed) == (
        True,
        reason,
        ["broken"],
        1,
        True,
    )


def test_a_complaint_that_can_t_be_written_is_lost_and_harms_nothing() -> None:
    output = Output(io.StringIO(), Failing(OSError()))
    output.complaint("a")
    output.finish()
    assert not output.is_broken


def has_some(pipe: int, within: float = 0.01) -> bool:
    return bool(select.select([pipe], [], [], within)[0])


@pytest.mark.parametrize("write", [lambda output: output.line, lambda output: output.complaint])
def test_output_is_stuck_while_nothing_reads_it(
    write: Callable[[Output], Callable[[str], None]],
) -> None:
    reading, writing = os.pipe()
    with open(writing, "w", encoding="utf-8") as pipe:  # noqa: PTH123
        output = Output(pipe, pipe)
        assert not output.is_stuck()
        writer = threading.Thread(target=write(output), args=("a" * 1_000_000,), daemon=True)
        writer.start()
        assert has_some(reading, TIMEOUT)
        assert output.is_stuck()
        while writer.is_alive():
            if has_some(reading):
                os.read(reading, 65_536)
        assert not output.is_stuck()
    os.close(reading)


def test_without_an_output_nothing_is_written(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdout", None)
    output = Output(err=io.StringIO())
    output.line("a")
    assert not output.is_broken
    output.out.close()


@pytest.mark.parametrize(
    ("typed", "longest", "lines"),
    [
        ("  one \ntwo", -1, ["one", "two", None, None]),
        ("abcdef\n", 3, ["abc", "def", "", None]),
        ("\n", -1, ["", None]),
        ("", -1, [None]),
    ],
)
def test_lines_are_read_without_blanks_around_them_until_the_end(
    monkeypatch: pytest.MonkeyPatch, typed: str, longest: int, lines: list[str | None]
) -> None:
    monkeypatch.setattr(sys, "stdin", io.StringIO(typed))
    stdin = Input()
    assert [stdin.line(longest) for _ in lines] == lines
    assert not stdin.is_terminal


def test_bytes_that_are_no_text_are_read_as_such_and_a_missing_input_is_at_its_end(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"a\xffb\n"), encoding="utf-8"))
    assert Input().line() == "a\ufffdb"
    monkeypatch.setattr(sys, "stdin", None)
    assert (Input().line(), Input().is_terminal) == (None, False)
    closed = io.StringIO("a")
    closed.close()
    monkeypatch.setattr(sys, "stdin", closed)
    assert (Input().line(), is_terminal(closed)) == (None, False)


def test_a_pseudo_terminal_is_a_terminal() -> None:
    master, slave = os.openpty()
    with open(slave, "w", encoding="utf-8") as stream, open(master, "rb"):  # noqa: PTH123 -- its number
        assert is_terminal(stream)


@pytest.mark.parametrize(("is_stopped", "still", "asked"), [(True, 9, 0), (False, 3, 3), (False, 1, 1)])
def test_voice_and_cues_are_waited_for_until_they_end_or_a_signal_comes(
    is_stopped: bool, still: int, asked: int
) -> None:
    stopped, asks = threading.Event(), list[float]()
    if is_stopped:
        stopped.set()

    def is_still(seconds: float) -> bool:
        asks.append(seconds)
        return len(asks) == still

    wait: Callable[[float], bool] = is_still
    let_sound(wait, stopped)
    assert asks == [0.05] * asked
