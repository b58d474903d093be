"""Recordings: a header, then every event, a line of JSON each. Written as it happens, read with distrust.

The header says with what it was recorded: version, seed, settings, and the world with all its files; the
programs stand in the events that begin their runs. Rule of reading: a line that makes no sense is told with
its number and left out; what is whole counts. Lines stay in the file, so that a long recording costs little.
"""

from __future__ import annotations

import json
from array import array
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from typing import BinaryIO, TextIO, overload

from devices.ports.values import Frozen
from donnie_tui.core.events import Reset, RunEnded, RunStarted, Stamped
from donnie_tui.core.recorded_events import DamagedLineError, event_of, parse_line

FORMAT = 1
KEY = "donnie_recording"
"""The first word of the header; its value is the format."""

LARGEST = 4 * 1024**3
"""Bytes of a file that is looked through; the most events that are read have a fourth of it."""
LONGEST_HEADER = 64 * 1024 * 1024
LONGEST_LINE = 16 * 1024 * 1024
"""Bytes; a program has at most half of it."""
MOST_EVENTS = 5_000_000
MOST_DAMAGES = 100
"""Damaged lines that are told of one file."""

END = "end"
"""The damage of a recording whose end is missing, as a crash leaves it."""


class NoRecordingError(Exception):
    """A file in which nothing of a recording is whole."""


class Header(Frozen):
    """What a recording was made with."""

    version: str
    seed: int
    robot: str
    """As in the option ``--robot``."""
    belt: Mapping[str, object]
    world: Mapping[str, object]
    """The world and its files, as ``world.bundle`` has them."""

    def write(self, out: TextIO) -> None:
        """The first line. Raises ``OSError``."""
        record = {
            KEY: FORMAT,
            "version": self.version,
            "seed": self.seed,
            "robot": self.robot,
            "belt": self.belt,
            "world": self.world,
        }
        out.write(json.dumps(record, ensure_ascii=False, separators=(",", ":")) + "\n")
        out.flush()


class Damage(Frozen):
    """Something that is missing from a recording: ``code`` is ``damaged-CODE`` in the catalogue."""

    code: str
    line: int
    last: int = 0
    """Where several lines or events are meant."""


class Recording:
    """A recording that was opened. The file stays open as long as somebody reads its events."""

    def __init__(self, file: BinaryIO) -> None:
        """Look through the whole file once. Raises ``NoRecordingError``, ``OSError``."""
        self.header: Header | None = None
        """None where it is damaged."""
        self.is_newer = False
        """Whether it is of a format that is not known yet."""
        self.damages: list[Damage] = []
        """What is missing, in order; of many the first ones."""
        self._file = file
        self._places = array("Q")
        self._lines = array("Q")
        self._last_seq = 0
        self._running: set[str | None] = set()
        """The robots whose runs have not ended so far."""
        self._look_through()

    @property
    def events(self) -> Sequence[Stamped]:
        """All events that are whole, in order."""
        return _Events(self._file, self._places, self._lines)

    @property
    def is_cut_off_only(self) -> bool:
        """Whether nothing is wrong but that the end is missing."""
        return all(each.code == END for each in self.damages)

    def line_of(self, index: int) -> int:
        """The number of the line in which an event stands, from 1; of one more, the line behind the last."""
        if index < len(self._lines):
            return self._lines[index]
        return self._lines[-1] + 1 if self._lines else 1

    def _look_through(self) -> None:
        place, is_first, number = 0, True, 0
        for number, (size, line) in enumerate(_lines(self._file), 1):
            if is_first:
                self._take_header(line)
            if not (is_first and self.header):
                self._take(number, place, line, is_first)
            is_first = False
            place += size
            if len(self._places) >= MOST_EVENTS:
                self._damage("too-many", number)
                break
        if self._running and not self._was_just_told(number + 1):
            self._damage(END, number + 1)
        if not self._places and self.header is None:
            raise NoRecordingError

    def _take_header(self, line: bytes | None) -> None:
        with suppress(DamagedLineError, UnicodeDecodeError, KeyError, TypeError):
            if line is not None:
                record = parse_line(line.decode("utf-8-sig"))
                self.is_newer = _is_newer(record)
                self.header = _header(record)

    def _take(self, number: int, place: int, line: bytes | None, is_first: bool) -> None:
        stamped = _event(line) if line is None or len(line) <= LONGEST_LINE else None
        if stamped is None:
            self._damage(self._kind_of_damage(line, is_first), number)
            return
        if is_first:
            self._damage("no-header", number)
        if stamped.seq > self._last_seq + 1 and not self._was_just_told(number):
            self._damage("missing", number, stamped.seq - self._last_seq - 1)
        self._last_seq = stamped.seq
        self._note_run(stamped)
        self._places.append(place)
        self._lines.append(number)

    def _kind_of_damage(self, line: bytes | None, is_first: bool) -> str:
        if is_first:
            return "newer" if self.is_newer else "header"
        return END if line is not None and not line.endswith(b"\n") else "line"

    def _note_run(self, stamped: Stamped) -> None:
        if isinstance(stamped.event, RunStarted):
            self._running.add(stamped.robot)
        elif isinstance(stamped.event, RunEnded | Reset):
            self._running.discard(stamped.robot)

    def _was_just_told(self, number: int) -> bool:
        """Whether the line before was damaged, so that what is missing is no news."""
        return bool(self.damages) and self.damages[-1].line == number - 1

    def _damage(self, code: str, line: int, last: int = 0) -> None:
        if len(self.damages) < MOST_DAMAGES:
            self.damages.append(Damage(code, line, last))


class _Events(Sequence[Stamped]):
    """The events of a file, each read when it is asked for."""

    def __init__(self, file: BinaryIO, places: array[int], lines: array[int]) -> None:
        self._file = file
        self._places = places
        self._lines = lines

    def __len__(self) -> int:
        return len(self._places)

    @overload
    def __getitem__(self, index: int) -> Stamped: ...

    @overload
    def __getitem__(self, index: slice) -> tuple[Stamped, ...]: ...

    def __getitem__(self, index: int | slice) -> Stamped | tuple[Stamped, ...]:
        if isinstance(index, slice):
            return tuple(self[each] for each in range(*index.indices(len(self))))
        self._file.seek(self._places[index])
        stamped = _event(self._file.readline(LONGEST_LINE))
        if stamped is None:
            raise OSError(f"line {self._lines[index]} has changed")
        return stamped


def _lines(file: BinaryIO) -> Iterator[tuple[int, bytes | None]]:
    """The lines with their sizes in bytes; None for one that is too long to be read."""
    file.seek(0)
    longest = LONGEST_HEADER
    while line := file.readline(longest + 1):
        size = len(line)
        if size <= longest:
            yield size, line
        else:
            while not line.endswith(b"\n") and (line := file.readline(longest)):
                size += len(line)
            yield size, None
        longest = LONGEST_LINE


def _event(line: bytes | None) -> Stamped | None:
    try:
        return None if line is None else event_of(parse_line(line.decode("utf-8", "surrogatepass")))
    except (DamagedLineError, UnicodeDecodeError):
        return None


def _is_newer(record: Mapping[str, object]) -> bool:
    number = record.get(KEY)
    return type(number) is int and number > FORMAT


def _header(record: Mapping[str, object]) -> Header | None:
    """The header that stands in a line; None for one of another format."""
    version, seed, robot = record["version"], record["seed"], record["robot"]
    belt, world = record["belt"], record["world"]
    if record[KEY] != FORMAT or not isinstance(version, str) or not isinstance(robot, str):
        return None
    if type(seed) is not int or not isinstance(belt, dict) or not isinstance(world, dict):
        return None
    return Header(version[:40], seed, robot[:200], belt, world)
