"""The files of a world and its macros: files in, a tree of built-in types with their settings out.

A world reads files of its folder, of the project that it belongs to, of the current folder if it lies in
it, and of the folders that the caller allows. As in Stage a macro's body is replayed where it is
instantiated, the base's first: own properties override, children add up, and of two macros of one name the
first wins. Unlike in Stage a macro may be used before its definition.
"""

from __future__ import annotations

import errno
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import dropwhile, takewhile
from pathlib import Path
from stat import S_ISREG

from msgspec import Struct
from msgspec.structs import replace

from donnie_tui.process.confinement import confinement, is_allowed, open_bytes, real_path
from sim.scene import Note, NoteKind
from sim.worldfile import parser
from sim.worldfile.mistakes import Code, WorldError, defining, near_file, near_name, near_world, worlds_in
from sim.worldfile.parser import WordCount, parse

LARGEST_FILE = 8_000_000
"""Bytes in one file; a world of 2000 models has some 200 000."""
DEEPEST_INCLUDE = 16
MOST_FILES = 200


class Placed(Struct, frozen=True):
    """A statement and the file in which it stands."""

    file: str
    statement: parser.Statement


class FileReader:
    """Reads a world and its includes; ``allowed``: more folders that may be read, and where it searches."""

    def __init__(self, top: Path, allowed: tuple[Path, ...]) -> None:
        own = resolved(top).parent
        self.folders = (own, *map(resolved, allowed))
        self._roots = (*self.folders, *roots_of(own))
        self.files: list[str] = []
        self.pictures: list[str] = []
        self.notes: list[Note] = []
        self._words = WordCount()

    def read(self, path: Path) -> Iterator[Placed]:
        """All statements of the world at ``path``, includes replaced by what they include."""
        if not _may_be_opened(path):
            raise _no_world(path)
        yield from self.statements(self.text_of(path), path, ())

    def statements(self, text: str, path: Path, above: tuple[Path, ...]) -> Iterator[Placed]:
        """The statements of ``text``, which stands in ``path`` and is included from the files ``above``."""
        self.files.append(str(path))
        self._words.take(text, str(path))
        for statement in parse(text, str(path)):
            if isinstance(statement, parser.Include):
                yield from self._included(statement, path, (*above, resolved(path)))
            elif isinstance(statement, parser.Property):
                yield Placed(str(path), statement)
            else:
                body = self._body(statement.body, path, above)
                yield Placed(str(path), replace(statement, body=body))

    def find(self, name: str, including: Path) -> Path | None:
        """The file that ``name`` means in ``including``, or None; it may be outside. Raises nothing.

        A name that only leads outside is answered alike whether there is such a file or not. In the allowed
        folders a file is found by its bare name, too, as Stage finds it in those of ``STAGEPATH``.
        """
        candidates = _within((resolved(including).parent, *self.folders), name)
        by_name = _within(self.folders[1:], Path(name).name)
        existing = [path for path in (*candidates, *by_name) if _may_be_opened(path)]
        inside = [path for path in existing if self.is_allowed(path)]
        if not existing and not any(map(self.is_allowed, candidates)):
            return candidates[0]
        return next(iter(inside or existing), None)

    def is_special(self, name: str, including: Path) -> bool:
        """Whether ``name`` means a pipe or a device, which ``find`` never finds."""
        found = _within((resolved(including).parent, *self.folders), name)
        return any(_is_special(each) and self.is_allowed(each) for each in found)

    def is_allowed(self, path: Path) -> bool:
        real = resolved(path)
        return any(real.is_relative_to(folder) for folder in self._roots)

    def folder_outside(self, path: Path) -> str:
        """The folder to allow for a file that may not be read; empty if the session is confined."""
        return str(resolved(path).parent) if confinement() is None else ""

    def _included(self, include: parser.Include, path: Path, above: tuple[Path, ...]) -> Iterator[Placed]:
        found = self._checked(include, path, above)
        if include.rest:
            place = (str(path), include.line, include.column)
            details = {"found": include.rest[:60]}
            self.notes.append(Note(NoteKind.WARNING, "include-rest", *place, details))
        yield from self.statements(self.text_of(found, include, str(path)), found, above)

    def _body(
        self, body: tuple[parser.Item, ...], path: Path, above: tuple[Path, ...]
    ) -> tuple[parser.Item, ...]:
        """With what it includes in place of each include."""
        return tuple(each for item in body for each in self._items(item, path, above))

    def _items(self, item: parser.Item, path: Path, above: tuple[Path, ...]) -> Iterable[parser.Item]:
        match item:
            case parser.Instance():
                yield replace(item, body=self._body(item.body, path, above))
            case parser.Include():
                for placed in self._included(item, path, (*above, resolved(path))):
                    statement = placed.statement
                    if not isinstance(statement, parser.Property | parser.Instance):
                        place = (placed.file, statement.line, statement.column)
                        raise WorldError(Code.MISPLACED, *place, found="define")
                    yield parser.Included(placed.file, statement)
            case _:
                yield item

    def _checked(self, include: parser.Include, path: Path, above: tuple[Path, ...]) -> Path:
        found = self.find(include.path, path)
        if found is None:
            if self.is_special(include.path, path):
                raise self._mistake(Code.NO_FILE, include, path)
            nearest = near_file(include.path, (resolved(path).parent, *self.folders))
            raise self._mistake(Code.FILE_NOT_FOUND, include, path, nearest=nearest)
        if not self.is_allowed(found):
            raise self._mistake(Code.INCLUDE_OUTSIDE, include, path, folder=self.folder_outside(found))
        if resolved(found) in above:
            raise self._mistake(Code.INCLUDE_CYCLE, include, path)
        place = (str(path), include.line, include.column)
        if len(above) > DEEPEST_INCLUDE:
            raise WorldError(Code.INCLUDE_TOO_DEEP, *place, limit=DEEPEST_INCLUDE)
        if len(self.files) >= MOST_FILES:
            raise WorldError(Code.TOO_MANY_FILES, *place, limit=MOST_FILES)
        return found

    def _mistake(self, code: Code, include: parser.Include, path: Path, **details: str) -> WorldError:
        return WorldError(
            code, str(path), include.line, include.column, (), path=include.path[:200], **details
        )

    def text_of(self, path: Path, include: parser.Include | None = None, file: str = "") -> str:
        """The text of a file; WorldError at the include, in ``file``, that names it."""
        try:
            with open_bytes(path) as stream:
                data = stream.read(LARGEST_FILE + 1)
        except OSError as problem:
            reason = problem.strerror or str(problem)
            place = (file, include.line, include.column) if include else (str(path), 1, 1)
            raise WorldError(Code.FILE_UNREADABLE, *place, path=str(path), reason=reason) from None
        if len(data) > LARGEST_FILE:
            raise WorldError(Code.FILE_TOO_LARGE, str(path), path=str(path), limit=LARGEST_FILE)
        return self._decoded(data, path)

    def _decoded(self, data: bytes, path: Path) -> str:
        try:
            text = data.decode("utf-8-sig")
        except UnicodeDecodeError:
            self.notes.append(Note(NoteKind.REPAIRED, "not-utf8", str(path), 1, 1, {"path": str(path)}))
            text = data.decode("latin-1")
        return text.replace("\r\n", "\n").replace("\r", "\n")


_REPOSITORY = (".git", ".hg", ".svn", ".bzr")
_PROJECT = (
    *("CMakeLists.txt", "Makefile", "package.xml", "manifest.xml", "stack.xml", "pyproject.toml"),
    *("setup.py", "LICENSE", "LICENSE.txt", "LICENSE.md", "COPYING"),
    *("README", "README.txt", "README.md", "README.rst"),
)
"""Files at the root of a project, and often in its folders too."""


def roots_of(folder: Path) -> Iterator[Path]:
    """The project that a folder is part of, and the current folder if it is above it."""
    current = real_path(".")
    for root in (_project(folder), Path(current) if folder.is_relative_to(current) else None):
        if root is not None and root != root.parent and is_allowed(root):
            yield root


def _project(folder: Path) -> Path | None:
    """The nearest repository above; without one the outermost of the nearest chain of project folders."""
    above = (folder, *folder.parents)
    for each in above:
        if any(_is((each / name), Path.exists) for name in _REPOSITORY):
            return each
    chain = dropwhile(_is_plain, above)
    return next(iter([*takewhile(lambda each: not _is_plain(each), chain)][::-1]), None)


def _is_plain(folder: Path) -> bool:
    return not any(_is_file(folder / name) for name in _PROJECT)


def _no_world(path: Path) -> WorldError:
    if _is(path, Path.is_dir):
        return WorldError(Code.IS_FOLDER, str(path), path=str(path), nearest=worlds_in(path))
    if _is_special(path):
        return WorldError(Code.NO_FILE, str(path), path=str(path))
    return WorldError(Code.FILE_NOT_FOUND, str(path), path=str(path), nearest=near_world(path))


def _within(folders: Iterable[Path], name: str) -> list[Path]:
    return [folder / name for folder in folders]


def resolved(path: Path) -> Path:
    """With its links followed; a link to itself, or a path that no system could have, stays."""
    return Path(real_path(path))


def _is_special(path: Path) -> bool:
    """Whether it is there and neither a file nor a folder: a named pipe, a device."""
    return _is(path, Path.exists) and not _is_file(path) and not _is(path, Path.is_dir)


def _may_be_opened(path: Path) -> bool:
    """Whether it is a file, or leads through a link to itself: then opening it says so."""
    try:
        return S_ISREG(path.stat().st_mode)
    except OSError as problem:
        return problem.errno == errno.ELOOP
    except ValueError:  # a zero byte
        return False


def _is_file(path: Path) -> bool:
    return _is(path, Path.is_file)


def _is(path: Path, what: Callable[[Path], bool]) -> bool:
    """False also for a path that no system could have."""
    try:
        return what(path)
    except (OSError, ValueError):
        return False


MODEL_TYPES = frozenset(
    {"model", "position", "ranger", "blobfinder", "fiducial", "bumper", "gripper", "camera", "actuator"}
    | {"lightindicator", "blinkenlight"}
)
BUILT_IN = MODEL_TYPES | {"sensor", "window", "block"}
_RENAMED = {"laser": "ranger"}
"""What older versions of Stage called it."""
MOST_ENTITIES = 40_000
"""Models, sensors and blocks of a world together."""
MOST_SETTINGS = 1_000_000
DEEPEST_MODEL = 64


class Setting(Struct, frozen=True):
    """A property and the file in which it stands."""

    file: str
    property: parser.Property


class Entity(Struct, frozen=True):
    """One model, sensor, block or window, with everything from its macros."""

    type: str
    kind: str
    """The word with which it was made: the type or a macro."""
    file: str
    line: int
    column: int
    settings: Mapping[str, Setting]
    children: tuple[Entity, ...]


class _Macro(Struct, frozen=True):
    file: str
    define: parser.Define


_Names = frozenset[str]

_Bodies = list[tuple[str, tuple[parser.Item, ...], _Names]]
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
        instances: list[tuple[str, parser.Instance]] = []
        for placed in statements:
            match placed.statement:
                case parser.Define() as define:
                    self._define(placed.file, define)
                case parser.Property() as setting:
                    self.settings[setting.name] = Setting(placed.file, setting)
                case parser.Instance() as instance:
                    instances.append((placed.file, instance))
        entities = tuple(self._entity(file, instance, 0, _NOWHERE) for file, instance in instances)
        for name, macro in self._macros.items():
            if (mistake := macro.define.mistake) is not None:
                place = (macro.file, mistake.line, mistake.column)
                self.notes.append(Note(NoteKind.WARNING, "broken-define", *place, {"name": name}))
        return entities

    def _define(self, file: str, define: parser.Define) -> None:
        if define.name in self._macros:
            details = {"name": define.name}
            note = Note(NoteKind.WARNING, "second-define", file, define.line, define.column, details)
            self.notes.append(note)
        else:
            self._macros[define.name] = _Macro(file, define)

    def _entity(self, file: str, instance: parser.Instance, depth: int, within: _Names) -> Entity:
        """``within``: the macros in whose bodies it stands."""
        self._count(file, instance, depth)
        built_in, bodies = self._bodies(file, instance, within)
        settings: dict[str, Setting] = {}
        children: list[Entity] = []
        for body_file, body, inside in bodies:
            for item in body:
                self._replayed += 1
                item_file = body_file
                if isinstance(item, parser.Included):
                    item_file, item = item.file, item.item
                if isinstance(item, parser.Property):
                    settings[item.name] = Setting(item_file, item)
                elif isinstance(item, parser.Instance):
                    children.append(self._entity(item_file, item, depth + 1, inside))
        place = (file, instance.line, instance.column)
        return Entity(built_in, instance.type, *place, settings, tuple(children))

    def _count(self, file: str, instance: parser.Instance, depth: int) -> None:
        self._entities += 1
        place = (file, instance.line, instance.column)
        if self._entities > MOST_ENTITIES:
            raise WorldError(Code.TOO_MUCH, *place, what="entities", limit=MOST_ENTITIES)
        if self._replayed > MOST_SETTINGS:
            raise WorldError(Code.TOO_MUCH, *place, what="settings", limit=MOST_SETTINGS)
        if depth > DEEPEST_MODEL:
            raise WorldError(Code.NESTED_TOO_DEEP, *place, limit=DEEPEST_MODEL)

    def _bodies(self, file: str, instance: parser.Instance, within: _Names) -> tuple[str, _Bodies]:
        """The built-in type below ``instance``, and the bodies to replay, the innermost base first."""
        bodies: _Bodies = [(file, instance.body, within)]
        name, place = instance.type, (file, instance.line, instance.column)
        seen: set[str] = set()
        while (macro := self._macros.get(name)) is not None and not (name in seen and name in self._types):
            if name in seen or name in within:
                raise WorldError(Code.DEFINE_CYCLE, *place, found=name)
            if macro.define.mistake is not None:
                raise macro.define.mistake
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
