"""Macros replayed: statements in, a tree of built-in types with their settings out.

As in Stage a body is replayed where it is instantiated, the base's first: own properties override,
children add up, and of two macros of one name the first wins. Unlike in Stage a macro may be used above it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

from devices.ports.values import Frozen
from sim.notes import Note, NoteKind
from sim.worldfile import tree
from sim.worldfile.mistakes import Code, WorldError
from sim.worldfile.nearby import defining, near_name
from sim.worldfile.reader import Placed

MODEL_TYPES = frozenset(
    {"model", "position", "ranger", "blobfinder", "fiducial", "bumper", "gripper", "camera", "actuator"}
    | {"lightindicator", "blinkenlight"}
)
BUILT_IN = MODEL_TYPES | {"sensor", "window", "block"}
_RENAMED = {"laser": "ranger"}
"""What older versions of Stage called it."""
MOST_ENTITIES = 100_000
"""Models, sensors and blocks of a world together."""
MOST_SETTINGS = 1_000_000
DEEPEST_MODEL = 64


class Setting(Frozen):
    """A property and the file in which it stands."""

    file: str
    property: tree.Property


class Entity(Frozen):
    """One model, sensor, block or window, with everything that its macros brought."""

    type: str
    kind: str
    """The word with which it was made: the type or a macro."""
    file: str
    line: int
    column: int
    settings: Mapping[str, Setting]
    children: tuple[Entity, ...]


class _Macro(Frozen):
    file: str
    define: tree.Define


_Names = frozenset[str]

_Bodies = list[tuple[str, tuple[tree.Item, ...], _Names]]
"""Files, what stands there, and the macros in whose bodies that is."""

_NOWHERE: _Names = frozenset()


class Expander:
    """Turns the statements of a world into entities."""

    def __init__(self, types: frozenset[str] = BUILT_IN, folders: tuple[Path, ...] = ()) -> None:
        """``types``: what there is to make things of, besides macros. ``folders``: with files to include."""
        self._types = types
        self._folders = folders
        self.notes: list[Note] = []
        self.settings: dict[str, Setting] = {}
        """The properties at the top level, the last of each name."""
        self._macros: dict[str, _Macro] = {}
        self._entities = 0
        self._replayed = 0

    def expand(self, statements: Iterable[Placed]) -> tuple[Entity, ...]:
        """The entities at the top level, in order. WorldError: a type is unknown, or there is too much."""
        instances: list[tuple[str, tree.Instance]] = []
        for placed in statements:
            match placed.statement:
                case tree.Define() as define:
                    self._define(placed.file, define)
                case tree.Property() as setting:
                    self.settings[setting.name] = Setting(placed.file, setting)
                case tree.Instance() as instance:
                    instances.append((placed.file, instance))
        return tuple(self._entity(file, instance, 0, _NOWHERE) for file, instance in instances)

    def _define(self, file: str, define: tree.Define) -> None:
        if define.name in self._macros:
            details = {"name": define.name}
            note = Note(NoteKind.WARNING, "second-define", file, define.line, define.column, details)
            self.notes.append(note)
        else:
            self._macros[define.name] = _Macro(file, define)

    def _entity(self, file: str, instance: tree.Instance, depth: int, within: _Names) -> Entity:
        """``within``: the macros in whose bodies it stands."""
        self._count(file, instance, depth)
        built_in, bodies = self._bodies(file, instance, within)
        settings: dict[str, Setting] = {}
        children: list[Entity] = []
        for body_file, body, inside in bodies:
            for item in body:
                self._replayed += 1
                if isinstance(item, tree.Property):
                    settings[item.name] = Setting(body_file, item)
                else:
                    children.append(self._entity(body_file, item, depth + 1, inside))
        place = (file, instance.line, instance.column)
        return Entity(built_in, instance.type, *place, settings, tuple(children))

    def _count(self, file: str, instance: tree.Instance, depth: int) -> None:
        self._entities += 1
        if self._entities > MOST_ENTITIES or self._replayed > MOST_SETTINGS:
            raise WorldError(Code.TOO_MUCH, file, instance.line, instance.column, limit=MOST_ENTITIES)
        if depth > DEEPEST_MODEL:
            raise WorldError(Code.NESTED_TOO_DEEP, file, instance.line, instance.column, limit=DEEPEST_MODEL)

    def _bodies(self, file: str, instance: tree.Instance, within: _Names) -> tuple[str, _Bodies]:
        """The built-in type below ``instance``, and the bodies to replay, the innermost base first."""
        bodies: _Bodies = [(file, instance.body, within)]
        name, place = instance.type, (file, instance.line, instance.column)
        seen: set[str] = set()
        while (macro := self._macros.get(name)) is not None and not (name in seen and name in self._types):
            if name in seen or name in within:
                raise WorldError(Code.DEFINE_CYCLE, *place, found=name)
            seen.add(name)
            bodies.append((macro.file, macro.define.body, within | {name}))
            name = macro.define.base
            place = (macro.file, macro.define.base_line, macro.define.base_column)
        if name not in self._types:
            raise self._unknown(name, place)
        return name, bodies[::-1]

    def _unknown(self, name: str, place: tuple[str, int, int]) -> WorldError:
        if path := defining(name, self._folders):
            return WorldError(Code.MISSING_INCLUDE, *place, ("type",), found=name[:60], path=path)
        nearest = _RENAMED.get(name) or near_name(name, self._types | self._macros.keys())
        return WorldError(Code.UNKNOWN_TYPE, *place, ("type",), found=name[:60], nearest=nearest)
