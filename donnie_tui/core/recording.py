"""Recordings: writes the header, reads events back, and finds damage. Nothing in a file is trusted.

A recording is a header, then every event, as lines of JSON written while things happen. The header says what
was used: version, seed, settings, and the world with all its files. The programs are in the events that begin
their runs.

Reading a damaged line reports its number and leaves the line out; all whole lines count. Lines stay in the
file, so that a long recording needs little memory. A line is parsed only if it is short and not deeply
nested, since json recurses in C. Every field must have the type that the event gives it.
"""

from __future__ import annotations

import json
import re
import types
import typing
from array import array
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from enum import Enum
from functools import cache
from math import isfinite
from typing import BinaryIO, TextIO, overload

from msgspec import Struct

from donnie_tui.core.events import TRANSIENT, Event, Reset, RunEnded, RunStarted, Stamped, event_name

DEEPEST = 12
"""Nested brackets in a line; Donnie writes five at most."""

_STRING = re.compile(r'"(?:[^"\\]|\\.)*"')
_BRACKETS = re.compile(r"[\[\]{}]")


class DamagedLineError(ValueError):
    """A line that does not belong to a recording."""


def parse_line(line: str) -> dict[str, object]:
    """The object in a line. Raises ``DamagedLineError``."""
    if _is_deep(line):
        raise DamagedLineError("too deep")
    try:
        record = json.loads(line)
    except (ValueError, RecursionError):
        raise DamagedLineError("no JSON") from None
    if not isinstance(record, dict):
        raise DamagedLineError("no object")
    return record


def event_of(record: Mapping[str, object]) -> Stamped:
    """The event of a line. Raises ``DamagedLineError`` for a wrong name, a missing field, a wrong type."""
    kind = _kinds().get(str(record.get("event")))
    if kind is None:
        raise DamagedLineError("unknown event")
    event = typing.cast(Event, _made(kind, record))
    seq, t = _typed(int, record.get("seq")), _typed(float, record.get("t"))
    return Stamped(seq, t, event, _robot_of(event, record.get("robot")))


def _robot_of(event: Event, name: object) -> str | None:
    """The robot in the record. A run always names its robot, also in a world of one robot."""
    if isinstance(event, RunStarted) and not (event.how and event.how.named):
        return None
    return None if name is None else _typed(str, name)


@cache
def _kinds() -> Mapping[str, type[Struct]]:
    """The event types by their names in the stream."""
    recorded = [kind for kind in typing.get_args(Event) if kind not in TRANSIENT]
    return {event_name(kind): kind for kind in recorded}


@cache
def _types_of(kind: type[Struct]) -> Mapping[str, object]:
    hints = typing.get_type_hints(kind, localns={"ClassVar": typing.ClassVar})
    return {name: hints[name] for name in kind.__struct_fields__}


def _made(kind: type[Struct], record: object) -> object:
    """A value from an object of JSON; a field that is left out has its default."""
    if not isinstance(record, dict):
        raise DamagedLineError(f"{kind.__name__} is no object")
    given = {name: _typed(type_, record[name]) for name, type_ in _types_of(kind).items() if name in record}
    try:
        return kind(**given)
    except TypeError:
        raise DamagedLineError(f"{kind.__name__} lacks a field") from None


def _typed(type_: typing.Any, value: object) -> typing.Any:  # the types and values of any field
    """The value with that type. Raises ``DamagedLineError`` if it has another type."""
    origin, inner = typing.get_origin(type_), typing.get_args(type_)
    if origin in (types.UnionType, typing.Union):  # an optional one
        return (
            None
            if value is None
            else _typed(next(each for each in inner if each is not types.NoneType), value)
        )
    if origin is tuple and isinstance(value, list):
        return tuple(_typed(inner[0], each) for each in value)
    if origin is Mapping and isinstance(value, dict):
        return {name: _typed(inner[1], each) for name, each in value.items()}
    if isinstance(type_, type) and issubclass(type_, Struct):
        return _made(type_, value)
    if isinstance(type_, type) and issubclass(type_, Enum):
        return _member(type_, value)
    return _plain(type_, value)


def _member(type_: type[Enum], value: object) -> Enum:
    try:
        return type_(value)
    except ValueError:
        raise DamagedLineError(f"no {type_.__name__}") from None


def _plain(type_: object, value: object) -> object:
    if type_ is float and isinstance(value, int | float) and not isinstance(value, bool):
        number = _as_float(value)
        if isfinite(number):
            return number
    elif type_ in (int, str, bool) and type(value) is type_:
        return value
    raise DamagedLineError(f"a {type(value).__name__} is in the wrong place")


def _as_float(value: int | float) -> float:
    try:
        return float(value)
    except OverflowError:
        raise DamagedLineError("a number is too large") from None


def _is_deep(line: str) -> bool:
    depth = 0
    for bracket in _BRACKETS.findall(_STRING.sub("", line)):
        depth += 1 if bracket in "[{" else -1
        if depth > DEEPEST:
            return True
    return False


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
        """None where it is damaged."""
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
        return None if line is None else event_of(parse_line(line.decode("utf-8", "surrogatepass")))
    except (DamagedLineError, UnicodeDecodeError):
        return None


def _is_newer(record: Mapping[str, object]) -> bool:
    number = record.get(KEY)
    return type(number) is int and number > FORMAT


def _header(record: Mapping[str, object]) -> Header | None:
    """The header in a line; None for one of another format."""
    version, seed, robot = record["version"], record["seed"], record["robot"]
    belt, world = record["belt"], record["world"]
    if record[KEY] != FORMAT or not isinstance(version, str) or not isinstance(robot, str):
        return None
    if type(seed) is not int or not isinstance(belt, dict) or not isinstance(world, dict):
        return None
    return Header(version[:40], seed, robot[:200], belt, world)
