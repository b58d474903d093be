"""Recordings: writes the header, reads events back, and finds damage. Nothing in a file is trusted.

A recording is a header, then every event, as lines of JSON written while things happen. The header says what
was used: version, seed, settings, and the world with all its files. The programs are in the events that begin
their runs.

Reading a damaged line reports its number and leaves the line out; all whole lines count. Lines stay in the
file, so that a long recording needs little memory. A line is parsed only if it is not deeply nested, since
json recurses in C. msgspec checks that every field has the type that the event gives it. A field that is left
out has its default, one that is unknown is ignored.
"""

from __future__ import annotations

import json
import re
from array import array
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from math import isfinite
from typing import BinaryIO, TextIO, TypeVar, get_args, overload

from msgspec import Struct, ValidationError, convert, structs

from donnie_tui.core.events import (
    Event,
    RecordedEvent,
    Reset,
    RunEnded,
    RunStarted,
    Stamped,
    event_name,
    json_line,
)

T = TypeVar("T")

DEEPEST = 12
"""Nested brackets in a line; Donnie writes five at most."""

_STRING = re.compile(r'"(?:[^"\\]|\\.)*+(?:"|\Z)')
"""A string that does not end takes the rest of the line, so that it is looked through once."""
_BRACKETS = re.compile(r"[\[\]{}]")


class DamagedLineError(ValueError):
    """A line that does not belong to a recording."""


class _Stamp(Struct, frozen=True):
    """The fields that all lines of events have."""

    seq: int
    t: float
    robot: str | None = None


def stamped_in(line: str) -> Stamped:
    """The event of a line. Raises ``DamagedLineError`` for a wrong name, a missing field, a wrong type.

    A run always names its robot, also in a world of one robot.
    """
    record = _record_in(line)
    kind = _KINDS.get(str(record.get("event")))
    if kind is None:
        raise DamagedLineError("unknown event")
    event, stamp = _converted(record, kind), _converted(record, _Stamp)
    is_of_one = isinstance(event, RunStarted) and not (event.how and event.how.named)
    return Stamped(stamp.seq, stamp.t, event, None if is_of_one else stamp.robot)


def _record_in(line: str) -> dict[str, object]:
    """The object in a line. The decoder of msgspec would refuse half a character, which a path may have."""
    if _is_deep(line):
        raise DamagedLineError("too deep")
    try:
        record = _DECODER.decode(line)
    except ValueError:
        raise DamagedLineError("no JSON") from None
    if not isinstance(record, dict):
        raise DamagedLineError("no object")
    return record


def _is_deep(line: str) -> bool:
    depth = 0
    for bracket in _BRACKETS.findall(_STRING.sub("", line)):
        depth += 1 if bracket in "[{" else -1
        if depth > DEEPEST:
            return True
    return False


def _finite(number: str) -> float:
    """Raises ``ValueError`` for a number that is too large, and for none."""
    found = float(number)
    if not isfinite(found):
        raise ValueError(number)
    return found


_DECODER = json.JSONDecoder(parse_float=_finite, parse_constant=_finite)
_KINDS: Mapping[str, type[Event]] = {event_name(kind): kind for kind in get_args(RecordedEvent)}
"""The kinds of events by their names."""


def _converted(record: dict[str, object], type_: type[T]) -> T:
    try:
        return convert(record, type_)
    except ValidationError as problem:
        raise DamagedLineError(str(problem)) from None


FORMAT = 1
KEY = "donnie_recording"
"""The first word of the header; its value is the format."""

LARGEST = 4 * 1024**3
"""Bytes of a file that are read; it can have at most a quarter as many events."""
LONGEST_HEADER = 64 * 1024 * 1024
LONGEST_LINE = 16 * 1024 * 1024
"""Bytes; a program has at most half of it."""
MOST_EVENTS = 5_000_000
MOST_DAMAGES = 100
"""Damaged lines of one file that are reported."""

END = "end"
"""The damage of a recording whose end is missing, as a crash leaves it."""


class NoRecordingError(Exception):
    """The file has no whole line of a recording."""


class Header(Struct, frozen=True):
    """The first line of a recording: how it was made."""

    version: str
    seed: int
    robot: str
    """As in the option ``--robot``."""
    belt: Mapping[str, object]
    world: Mapping[str, object]
    """The world and its files, as ``world.bundle`` has them."""

    def write(self, out: TextIO) -> None:
        """The first line. Raises ``OSError``."""
        out.write(json_line({KEY: FORMAT, **structs.asdict(self)}))
        out.flush()


class Damage(Struct, frozen=True):
    """A missing part of a recording. The catalogue has ``damaged-`` and the ``code``."""

    code: str
    line: int
    last: int = 0
    """The last line or event, where there are several."""


class Recording:
    """An open recording. The file must stay open while its events are read."""

    def __init__(self, file: BinaryIO) -> None:
        """Reads the whole file once. Raises ``NoRecordingError``, ``OSError``."""
        self.header: Header | None = None
        """None if it is damaged."""
        self.is_newer = False
        """Whether a newer version of Donnie wrote the format."""
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
        """Whether the missing end is the only damage."""
        return all(each.code == END for each in self.damages)

    def line_of(self, index: int) -> int:
        """The number of an event's line, from 1; after the last event, the next line."""
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
        if self._running and not self._was_just_reported(number + 1):
            self._damage(END, number + 1)
        if not self._places and self.header is None:
            raise NoRecordingError

    def _take_header(self, line: bytes | None) -> None:
        with suppress(DamagedLineError, UnicodeDecodeError):
            if line is not None:
                record = _record_in(line.decode("utf-8-sig"))
                number = record.get(KEY)
                self.is_newer = type(number) is int and number > FORMAT
                if number == FORMAT:
                    header = _converted(record, Header)
                    self.header = structs.replace(
                        header, version=header.version[:40], robot=header.robot[:200]
                    )

    def _take(self, number: int, place: int, line: bytes | None, is_first: bool) -> None:
        stamped = _event(line) if line is None or len(line) <= LONGEST_LINE else None
        if stamped is None:
            self._damage(self._kind_of_damage(line, is_first), number)
            return
        if is_first:
            self._damage("no-header", number)
        if stamped.seq > self._last_seq + 1 and not self._was_just_reported(number):
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

    def _was_just_reported(self, number: int) -> bool:
        """Whether the line before was damaged, so that missing events were reported already."""
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
        return None if line is None else stamped_in(line.decode("utf-8", "surrogatepass"))
    except (DamagedLineError, UnicodeDecodeError):
        return None
