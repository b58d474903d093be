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


@pytest.mark.parametrize(
    ("lines", "fits"),
    [
        *(([1_000_000] * 4, True), ([1_000_000] * 5, False), ([3_999_999, 1], True)),
        *(([3_999_999, 9_000_000], True), ([4_000_000, 1], False), ([3_999_999, 1, 1], False)),
    ],
)
def test_a_reader_that_does_not_read_delays_nothing_and_is_reported_when_four_megabytes_wait(
    pipe: Pipe, monkeypatch: pytest.MonkeyPatch, lines: list[int], fits: bool
) -> None:
    """The line that exceeds them may wait too, and what is reported once is reported for each later line."""
    monkeypatch.setattr(files, "LONGEST_STALL", 0.0)
    reader = SlowReader(pipe[1])
    *first, last = lines
    assert [reader.write("a" * each) for each in first] == first
    if fits:
        assert reader.write("a" * last) == last
    else:
        for _ in range(2):
            with pytest.raises(OSError, match=os.strerror(11)):
                reader.write("a" * last)
    reader.close()


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
