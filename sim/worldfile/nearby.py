"""What somebody may have meant who named a file or a model that is not there: looked for in the folders of a
world. Rule: only what could be included is offered.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from difflib import get_close_matches
from itertools import islice
from pathlib import Path

MOST_FILES = 300
"""Files of a folder that are looked at."""
LONGEST = 200_000
"""Bytes of each that are searched."""
NEAR = 0.7
"""How much alike names must be, of 1."""


def near_name(name: str, known: Iterable[str]) -> str:
    """The name that is most like it, or has it as a part (``sofa`` in ``small_sofa``); empty if none is."""
    if not 0 < len(name) < 60:
        return ""
    names = sorted(known)
    close = get_close_matches(name, names, 1, NEAR)
    return next(iter([*close, *(each for each in names if name in each.split("_"))]), "")


def near_file(path: str, folders: Iterable[Path]) -> str:
    """The file to include that is called most like it."""
    by_stem = {file.stem: file.name for file in _includes(folders)}
    return by_stem.get(near_name(Path(path).stem, by_stem), "")


def defining(model: str, folders: Iterable[Path]) -> str:
    """The file to include that defines a model; empty if none does."""
    pattern = re.compile(rb"^\s*define\s+" + re.escape(model.encode()) + rb"\s", re.MULTILINE)
    return next((file.name for file in _includes(folders) if pattern.search(_start(file))), "")


def worlds_in(folder: Path) -> str:
    """The first world file in a folder."""
    return min((str(file) for file in _files(folder) if file.suffix == ".world"), default="")


def near_world(path: Path) -> str:
    """The world file in the same folder that is called most like it, but for the suffix, which all have."""
    files = (file for file in _files(path.parent) if file.suffix == ".world")
    by_stem = {file.stem: str(path.with_name(file.name)) for file in files}
    return by_stem.get(near_name(path.stem, by_stem), "")


def _includes(folders: Iterable[Path]) -> Iterator[Path]:
    for folder in dict.fromkeys(folders):
        yield from sorted(file for file in _files(folder) if file.suffix == ".inc")


def _files(folder: Path) -> tuple[Path, ...]:
    try:
        return tuple(islice(folder.iterdir(), MOST_FILES))
    except OSError:
        return ()


def _start(file: Path) -> bytes:
    try:
        if not file.is_file():
            return b""
        with file.open("rb") as stream:
            return stream.read(LONGEST)
    except OSError:
        return b""
