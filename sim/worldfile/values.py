"""The properties of a world file: which of them have an effect, their types and units, and reading them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from difflib import get_close_matches
from math import degrees
from pathlib import Path
from typing import TYPE_CHECKING

from sim.colours import FAMILIES, Colour, colour_of, folded, nearest_name, rgb
from sim.geometry import Placement
from sim.scene import Note, NoteKind
from sim.worldfile import parser
from sim.worldfile.entities import FileReader, Setting
from sim.worldfile.mistakes import Code, WorldError

if TYPE_CHECKING:
    from random import Random


def _names(text: str) -> frozenset[str]:
    return frozenset(text.split())


_USED_TUPLES = _names(
    "pose origin size color_rgba point z paddle_size noise odom_error velocity_bounds acceleration_bounds"
    " localization_origin bpose image"
)
_UNUSED_TUPLES = _names("velocity pantilt rotate center watts_size provides requires axis scatter")
_TUPLES = _USED_TUPLES | _UNUSED_TUPLES
"""What must be a tuple."""

_QUIET = _USED_TUPLES | _names(
    "range fov colors paddle_state obstacle_return ranger_return blob_return fiducial_return gripper_return"
    " boundary samples colors_count points fiducial_key pushable mass ignore_zloc pan range_min range_max"
    " range_max_id range_noise range_noise_const angle_noise wheelbase bcount blength autosnatch name color"
    " bitmap unit_length unit_angle drive localization gui_nose gui_grid gui_move gui_outline alwayson"
    " update_interval trail_length trail_interval debug map_resolution stack_children rebuild ctrl"
)
"""What has an effect here, or changes nothing that a learner could notice: read and kept, no remark."""

_UNUSED = _UNUSED_TUPLES | _names(
    "resolution type scale interval interval_sim interval_real paused speedup quit_time object_return"
    " friction threads show_data show_follow show_clock show_clock_interval show_flags show_blocks"
    " show_bboxerr show_grid show_trails show_occupancy pcam_on energy_capacity joules joules_capacity"
    " watts watts_give watts_take kjoules max_speed max_position min_position start_position enabled"
    " break_beam period dutycycle sticky_return laser_return audio channel_count plugin worldfile model alarm"
    " say texture mesh"
)
"""What has no use in a model, such as other properties of Stage: noted in the load report."""

_KNOWN = _QUIET | _UNUSED


def nearest_property(name: str) -> str:
    """The known property that was probably meant, or an empty string."""
    return next(iter(get_close_matches(name, _KNOWN, 1, 0.75)), "") if len(name) < 40 else ""


Size = tuple[float, float, float]
"""Metres along x, y and z."""

LONGEST = 1e5
"""Metres: no world is larger."""

UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001}
ANGLES = {"degrees": 1.0, "radians": degrees(1.0)}

_INDEXED = re.compile(r"(.*)\[[0-9]+\]$")


class ValueReader:
    """Reads settings of one world: knows its units, collects remarks."""

    def __init__(self) -> None:
        self.metres = 1.0
        self.degrees = 1.0
        self.notes: list[Note] = []
        self._noted: set[tuple[str, str, int, int]] = set()
        self._checked: set[int] = set()
        self._chance: Random | None = None

    def use_units(self, settings: Mapping[str, Setting]) -> None:
        self.metres = UNITS[self.one_of(settings, "unit_length", "m", tuple(UNITS))]
        self.degrees = ANGLES[self.one_of(settings, "unit_angle", "degrees", tuple(ANGLES))]

    def one_of(
        self, settings: Mapping[str, Setting], name: str, default: str, choices: tuple[str, ...]
    ) -> str:
        """The word, or the usual one and a warning for an unknown word, as in Stage."""
        word = self.string(settings, name, default)
        if word in choices:
            return word
        self._unknown_word(settings[name], word, choices, default)
        return default

    def _unknown_word(self, setting: Setting, word: str, choices: tuple[str, ...], usual: str) -> None:
        nearest = next(iter(get_close_matches(word[:60], choices, 1)), "")
        details = {"name": setting.property.name, "found": word[:60], "used": usual, "nearest": nearest}
        self.note(NoteKind.WARNING, "unknown-word", setting, **details)

    def string(self, settings: Mapping[str, Setting], name: str, default: str) -> str:
        setting = settings.get(name)
        return default if setting is None else self._string(setting, self._first(setting, "string"))

    def number(self, settings: Mapping[str, Setting], name: str, default: float) -> float:
        setting = settings.get(name)
        return default if setting is None else self._number(setting, self._first(setting, "number"))

    def at_least_zero(self, settings: Mapping[str, Setting], name: str, default: float) -> float:
        """A number; a negative one counts as zero."""
        value = self.number(settings, name, default)
        if value < 0:
            item = self._first(settings[name], "number")
            self._read_as(settings[name], item, _as_written(item), "0")
        return max(0.0, value)

    def length(self, settings: Mapping[str, Setting], name: str, default: float) -> float:
        setting = settings.get(name)
        return default if setting is None else self._length(setting, self._first(setting, "number"))

    def angle(self, settings: Mapping[str, Setting], name: str, default: float) -> float:
        return self.number(settings, name, 0.0) * self.degrees if name in settings else default

    def size(
        self, settings: Mapping[str, Setting], default: tuple[float, float, float]
    ) -> tuple[float, float, float]:
        """Two numbers leave the height as it is. A negative one mirrors the shape, as in Stage."""
        setting = settings.get("size")
        if setting is None:
            return default
        items = self._items(setting, 2, 3)
        sides = [self._length(setting, item) for item in items]
        for side, item in zip(sides, items, strict=False):
            if side < 0:
                self._read_as(setting, item, _as_written(item), f"{-side / self.metres:.10g}")
        return sides[0], sides[1], abs(sides[2]) if len(sides) > 2 else default[2]

    def place(self, settings: Mapping[str, Setting], name: str) -> Placement:
        """``pose`` and ``origin``: x y z yaw; of three numbers the third is a pose's yaw, an origin's z."""
        setting = settings.get(name)
        if setting is None:
            return Placement()
        items = self._items(setting, 3, 4)
        x, y, third = (self._length(setting, item) for item in items[:3])
        if len(items) == 4:
            return Placement(x, y, third, self._number(setting, items[3]) * self.degrees)
        if name == "origin":
            return Placement(x, y, third)
        return Placement(x, y, 0.0, self._number(setting, items[2]) * self.degrees)

    def span(
        self, settings: Mapping[str, Setting], name: str, default: tuple[float, float]
    ) -> tuple[float, float]:
        """Two lengths from 0 on, the smaller first; a warning where the file has them otherwise."""
        setting = settings.get(name)
        if setting is None:
            return default
        low, high = sorted(max(0.0, length) for length in self.pair(setting))
        return self.bounds(setting, 0, (low, high), self.metres)

    def bounds(
        self, setting: Setting, first: int, used: tuple[float, float], unit: float
    ) -> tuple[float, float]:
        """``used``, and a warning where these are not the two numbers from ``first`` on in the file."""
        items = self._items(setting, first + 2, 1000)[first : first + 2]
        if tuple(self._number(setting, item) * unit for item in items) != used:
            found = " ".join(map(_as_written, items))
            self._read_as(setting, items[0], found, " ".join(f"{each / unit:.10g}" for each in used))
        return used

    def numbers(self, setting: Setting, least: int, most: int) -> tuple[float, ...]:
        """The numbers of a tuple as they stand there, without a unit; a lone number is a tuple of one."""
        value = setting.property.value
        if isinstance(value, parser.Number):
            return (self._number(setting, value),)
        return tuple(self._number(setting, item) for item in self._items(setting, least, most))

    def whole(self, settings: Mapping[str, Setting], name: str, default: int) -> int:
        """A whole number; a fraction is cut off, as in Stage."""
        setting = settings.get(name)
        if setting is None:
            return default
        item = self._first(setting, "number")
        written = self._number(setting, item)
        if written != int(written):
            self._read_as(setting, item, _as_written(item), str(int(written)))
        return int(written)

    def limited(self, settings: Mapping[str, Setting], name: str, default: int, most: int) -> int:
        """A whole number from 0 to ``most``."""
        value = self.whole(settings, name, default)
        if not 0 <= value <= most:
            raise mistake(Code.OUT_OF_RANGE, settings[name], name=name, limit=most)
        return value

    def strings(self, setting: Setting, most: int) -> tuple[str, ...]:
        """The strings of a tuple."""
        return tuple(self._string(setting, item) for item in self._items(setting, 0, most))

    def words(self, setting: Setting, choices: tuple[str, ...], usual: str) -> tuple[str, ...]:
        """The words of a tuple, or the one word that stands there; a warning for each that is no choice."""
        value = setting.property.value
        items = (value,) if isinstance(value, parser.String) else self._items(setting, 1, 8)
        found = tuple(self._string(setting, item) for item in items)
        for word in found:
            if word not in choices:
                self._unknown_word(setting, word, choices, usual)
        return found

    def pair(self, setting: Setting) -> tuple[float, float]:
        first, second = (self._length(setting, item) for item in self._items(setting, 2, 2))
        return first, second

    def colour(self, settings: Mapping[str, Setting], default: Colour) -> Colour:
        """``color``, else ``color_rgba``."""
        if (setting := settings.get("color")) is not None:
            name = self.string(settings, "color", "")
            return self._any_colour(setting) if folded(name) == "random" else self.named_colour(setting, name)
        if (setting := settings.get("color_rgba")) is None:
            return default
        levels = [min(1.0, max(0.0, self._number(setting, item))) for item in self._items(setting, 3, 4)]
        return colour_of("", *levels)

    def named_colour(self, setting: Setting, name: str) -> Colour:
        """Red, as in Stage, and a warning, for an unknown name."""
        levels = rgb(name)
        if levels is None:
            details = {"name": name[:60], "nearest": nearest_name(name)}
            self.note(NoteKind.WARNING, "unknown-colour", setting, **details)
            return colour_of("red", 1.0, 0.0, 0.0)
        return colour_of(name, *(level / 255 for level in levels))

    def _any_colour(self, setting: Setting) -> Colour:
        """One of those that the language has a word for: the same file gives the same ones each time."""
        from random import Random  # loaded where there is chance

        self._chance = self._chance or Random(0)
        self.note(NoteKind.WARNING, "random-colour", setting)
        return self.named_colour(setting, FAMILIES[int(self._chance.random() * len(FAMILIES))])

    def colours(self, settings: Mapping[str, Setting]) -> tuple[Colour, ...]:
        setting = settings.get("colors")
        if setting is None:
            return ()
        value = setting.property.value
        items = self._items(setting, 0, 1000) if isinstance(value, parser.Tuple) else (value,)
        count = int(min(1000, max(0, self.number(settings, "colors_count", len(items)))))
        return tuple(self.named_colour(setting, self._string(setting, item)) for item in items[:count])

    def note(self, kind: NoteKind, code: str, setting: Setting, **details: str) -> None:
        place = setting.property
        self.remark(Note(kind, code, setting.file, place.line, place.column, details))

    def remark(self, note: Note) -> None:
        """A remark, once for each place: a macro is replayed often."""
        key = (note.code, note.file, note.line, note.column)
        if key not in self._noted:
            self._noted.add(key)
            self.notes.append(note)

    def check(self, settings: Mapping[str, Setting], quiet: bool = False) -> None:
        """The type of every known property; a remark for every one without effect."""
        for name, setting in settings.items():
            if id(setting.property) in self._checked:  # a macro is replayed often; its tree stays alive
                continue
            self._checked.add(id(setting.property))
            self._check(_INDEXED.sub(r"\1", name) if name.endswith("]") else name, setting, quiet)

    def _check(self, name: str, setting: Setting, quiet: bool) -> None:
        if name not in _KNOWN:
            self.note(
                NoteKind.IGNORED, "unknown-property", setting, name=name[:60], nearest=nearest_property(name)
            )
        elif name in _TUPLES and not isinstance(setting.property.value, parser.Tuple):
            raise mistake(Code.WRONG_TYPE, setting, ("tuple",), name=name)
        elif name in _UNUSED and not quiet:  # at the top level some count
            self.note(NoteKind.IGNORED, "unused-property", setting, name=name)

    def _items(self, setting: Setting, least: int, most: int) -> tuple[parser.Value, ...]:
        """The values of a tuple. Those after ``most`` have no effect, as in Stage."""
        value, name = setting.property.value, setting.property.name
        if not isinstance(value, parser.Tuple):
            raise mistake(Code.WRONG_TYPE, setting, ("tuple",), name=name)
        if len(value.items) < least:
            expected = tuple(str(count) for count in range(least, most + 1)) if most < 10 else ()
            raise mistake(Code.WRONG_COUNT, setting, expected, name=name, given=len(value.items))
        if len(value.items) > most:
            self.note(NoteKind.REPAIRED, "first-values", setting, name=name, count=str(most))
        return value.items[:most]

    def _length(self, setting: Setting, value: parser.Value) -> float:
        metres = self._number(setting, value) * self.metres
        if abs(metres) > LONGEST:
            place = (setting.file, value.line, value.column)
            raise WorldError(Code.OUT_OF_RANGE, *place, name=setting.property.name, limit=LONGEST)
        return metres

    def _first(self, setting: Setting, expected: str) -> parser.Value:
        """The one value that a property takes: of a tuple the first, as in Stage."""
        value = setting.property.value
        if not isinstance(value, parser.Tuple):
            return value
        if not value.items:
            raise mistake(Code.WRONG_TYPE, setting, (expected,), name=setting.property.name)
        if isinstance(first := value.items[0], parser.Number | parser.String):
            self._read_as(setting, value, _as_written(value), first.text)
        return first

    def _number(self, setting: Setting, value: parser.Value) -> float:
        """A number, or as much of what is written there as is one, as in Stage."""
        if isinstance(value, parser.Tuple):
            place = (setting.file, value.line, value.column)
            raise WorldError(Code.WRONG_TYPE, *place, ("number",), name=setting.property.name)
        if isinstance(value, parser.Number) and value.is_plain:
            return value.value
        number = parser.leading_number(value.text)
        parser.refuse_too_large(number, value.text, setting.file, value.line, value.column)
        self._read_as(setting, value, _as_written(value), f"{number:.10g}")
        return number

    def _string(self, setting: Setting, value: parser.Value) -> str:
        """A text; a number is one, too, in Stage."""
        if isinstance(value, parser.Tuple):
            place = (setting.file, value.line, value.column)
            raise WorldError(Code.WRONG_TYPE, *place, ("string",), name=setting.property.name)
        if isinstance(value, parser.Number):
            self._read_as(setting, value, value.text, f'"{value.text}"')
        return value.text

    def _read_as(self, setting: Setting, value: parser.Value, found: str, used: str) -> None:
        details = {"name": setting.property.name, "found": found[:60], "used": used[:60]}
        self.remark(Note(NoteKind.WARNING, "read-as", setting.file, value.line, value.column, details))


def mistake(
    code: Code, setting: Setting, expected: tuple[str, ...] = (), **details: str | int | float
) -> WorldError:
    """A mistake in the value of a property."""
    value = setting.property.value
    return WorldError(code, setting.file, value.line, value.column, expected, **details)


def named_file(reader: FileReader, setting: Setting, name: str, missing: Code, outside: Code) -> Path:
    """The file that a property names; ``missing`` and ``outside`` are its mistakes."""
    path = reader.find(name, Path(setting.file))
    if path is None:
        code = Code.NO_FILE if reader.is_special(name, Path(setting.file)) else missing
        raise mistake(code, setting, path=name[:200])
    if not reader.is_allowed(path):
        raise mistake(outside, setting, path=name[:200], folder=reader.folder_outside(path))
    return path


def plain(value: parser.Value) -> float | str | tuple[object, ...]:
    """A value as Python has it."""
    match value:
        case parser.Number():
            return value.value
        case parser.String():
            return value.text
        case parser.Tuple():
            return tuple(plain(item) for item in value.items)


def _as_written(value: parser.Value) -> str:
    match value:
        case parser.Number():
            return value.text
        case parser.String():
            return f'"{value.text}"'
        case parser.Tuple():
            return f"[ {' '.join(_as_written(item) for item in value.items[:4])} ]"
