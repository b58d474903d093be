"""The files of a world: the world itself and what it includes, none from outside its folders."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from devices.ports.values import Frozen
from sim.notes import Note, NoteKind
from sim.worldfile import tree
from sim.worldfile.mistakes import Code, WorldError
from sim.worldfile.nearby import near_file, near_world, worlds_in
from sim.worldfile.parser import parse

LARGEST_FILE = 8_000_000
"""Bytes in one file; a world of 2000 models has some 200 000."""
DEEPEST_INCLUDE = 16
MOST_FILES = 200


class Placed(Frozen):
    """A statement and the file in which it stands."""

    file: str
    statement: tree.Statement


class FileReader:
    """Reads a world and its includes; ``allowed``: the folders, besides its own, that may be read."""

    def __init__(self, top: Path, allowed: tuple[Path, ...]) -> None:
        self.folders = (top.resolve().parent, *(folder.resolve() for folder in allowed))
        self.files: list[str] = []
        self.pictures: list[str] = []
        self.notes: list[Note] = []

    def read(self, path: Path) -> Iterator[Placed]:
        """All statements of the world at ``path``, includes replaced by what they include."""
        if not _is_file(path):
            raise _no_world(path)
        yield from self.statements(self._text(path, tree.Include(1, 1, str(path)), str(path)), path, ())

    def statements(self, text: str, path: Path, above: tuple[Path, ...]) -> Iterator[Placed]:
        """The statements of ``text``, which stands in ``path`` and is included from the files ``above``."""
        self.files.append(str(path))
        for statement in parse(text, str(path)):
            if isinstance(statement, tree.Include):
                yield from self._included(statement, path, (*above, path.resolve()))
            else:
                yield Placed(str(path), statement)

    def find(self, name: str, including: Path) -> Path | None:
        """The file that ``name`` means in ``including``, or None; WorldError-free, but may lie outside."""
        places = [including.resolve().parent, *self.folders]
        candidates = [folder / name for folder in places]
        existing = [path for path in candidates if _is_file(path)]
        inside = [path for path in existing if self.is_allowed(path)]
        return next(iter(inside or existing), None)

    def is_allowed(self, path: Path) -> bool:
        resolved = path.resolve()
        return any(resolved.is_relative_to(folder) for folder in self.folders)

    def _included(self, include: tree.Include, path: Path, above: tuple[Path, ...]) -> Iterator[Placed]:
        found = self._checked(include, path, above)
        yield from self.statements(self._text(found, include, str(path)), found, above)

    def _checked(self, include: tree.Include, path: Path, above: tuple[Path, ...]) -> Path:
        found = self.find(include.path, path)
        if found is None:
            nearest = near_file(include.path, (path.resolve().parent, *self.folders))
            raise self._mistake(Code.FILE_NOT_FOUND, include, path, nearest=nearest)
        if not self.is_allowed(found):
            raise self._mistake(Code.INCLUDE_OUTSIDE, include, path)
        if found.resolve() in above:
            raise self._mistake(Code.INCLUDE_CYCLE, include, path)
        if len(above) > DEEPEST_INCLUDE or len(self.files) >= MOST_FILES:
            raise WorldError(
                Code.INCLUDE_TOO_DEEP, str(path), include.line, include.column, limit=DEEPEST_INCLUDE
            )
        return found

    def _mistake(self, code: Code, include: tree.Include, path: Path, nearest: str = "") -> WorldError:
        place = (str(path), include.line, include.column)
        return WorldError(code, *place, path=include.path[:200], nearest=nearest)

    def _text(self, path: Path, include: tree.Include, file: str) -> str:
        try:
            with path.open("rb") as stream:
                data = stream.read(LARGEST_FILE + 1)
        except OSError:
            raise WorldError(
                Code.FILE_UNREADABLE, file, include.line, include.column, path=str(path)
            ) from None
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


def _no_world(path: Path) -> WorldError:
    if _is(path, Path.is_dir):
        return WorldError(Code.IS_FOLDER, str(path), path=str(path), nearest=worlds_in(path))
    return WorldError(Code.FILE_NOT_FOUND, str(path), path=str(path), nearest=near_world(path))


def _is_file(path: Path) -> bool:
    return _is(path, Path.is_file)


def _is(path: Path, what: Callable[[Path], bool]) -> bool:
    """False also for a path that no system could have."""
    try:
        return what(path)
    except (OSError, ValueError):
        return False
