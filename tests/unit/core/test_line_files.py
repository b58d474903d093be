"""Lines for a process that reads slowly, does not read, or closes its pipe."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from donnie_tui.outlets import files
from donnie_tui.outlets.files import SlowReader

Pipe = tuple[int, int]


@pytest.fixture
def pipe() -> Iterator[Pipe]:
    ends = os.pipe()
    yield ends
    for each in ends:
        os.close(each)


def test_all_lines_arrive_in_order_also_those_that_wait_at_the_end(pipe: Pipe) -> None:
    lines = [f"{number} {'é' * 50}\n" for number in range(5_000)]  # more than a pipe holds
    reader, read = SlowReader(pipe[1]), bytearray()

    def take() -> None:
        while not read.endswith(lines[-1].encode()):
            read.extend(os.read(pipe[0], 1_000))

    for line in lines:
        reader.write(line)
    taking = threading.Thread(target=take)
    taking.start()
    reader.close()
    taking.join()
    assert read.decode() == "".join(lines)


def test_a_reader_that_does_not_read_delays_nothing_and_is_reported_when_too_much_waits(
    pipe: Pipe, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(files, "LONGEST_STALL", 0.0)
    reader = SlowReader(pipe[1])
    line = "a line that is as long as an event\n"
    with pytest.raises(OSError, match=os.strerror(11)):
        for _ in range(2 * files.MOST_WAITING // len(line)):
            reader.write(line)
    reader.close()


def test_fewer_long_lines_are_too_much(pipe: Pipe, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(files, "LONGEST_STALL", 0.0)
    reader, taken = SlowReader(pipe[1]), 0
    with pytest.raises(OSError, match=os.strerror(11)):
        for _ in range(100):
            taken += reader.write("a" * 1_000_000)
    reader.close()
    assert taken <= files.MOST_WAITING + 1_000_000


def test_late_lines_are_not_written_into_a_file_that_is_opened_later(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The system gives the number of a closed file to the next one."""
    monkeypatch.setattr(files, "LONGEST_STALL", 0.0)
    here, there = os.pipe()
    reader = SlowReader(there)
    for _ in range(3):
        reader.write("a" * 1_000_000)
    os.read(here, 1)
    reader.close()
    os.close(there)
    number = os.open(tmp_path / "another", os.O_CREAT | os.O_WRONLY)
    taken = 1 + sum(len(piece) for piece in iter(lambda: os.read(here, 65_536), b""))
    assert number == there
    assert taken == 1_000_000
    assert os.fstat(number).st_size == 0
    os.close(here)
    os.close(number)


def test_a_reader_that_waits_at_the_end_is_not_waited_for_long(
    pipe: Pipe, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(files, "LONGEST_STALL", 0.0)
    reader = SlowReader(pipe[1])
    reader.write("a" * 1_000_000)
    reader.close()
    assert reader.closed


def test_a_closed_pipe_is_reported_like_a_full_file() -> None:
    here, there = os.pipe()
    os.close(here)
    reader = SlowReader(there)
    with pytest.raises(BrokenPipeError):
        while True:
            reader.write("a line\n")
    reader.close()
    os.close(there)
