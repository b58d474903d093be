"""World files in words: what is wrong in one that can't be used, what was odd in one that can."""

from __future__ import annotations

from pathlib import PurePath
from typing import TYPE_CHECKING

from donnie_tui.i18n.catalogue.signs import CODE_OF
from donnie_tui.i18n.mistakes import either
from donnie_tui.i18n.phrasing import Phrasing
from language import keywords

if TYPE_CHECKING:
    from sim.notes import Note
    from sim.worldfile.mistakes import WorldError

_WITHOUT_PLACE = ("is-folder", "file-not-found", "file-unreadable", "file-too-large")
"""About the file as a whole, where the file is the world itself."""


def world_mistake(error: WorldError, words: Phrasing) -> str:
    """One sentence with the place."""
    message = _message(error, words)
    nearest = error.details.get("nearest")
    if nearest:
        message = words("world-meant", message=message, near=nearest)
    if error.code.value in _WITHOUT_PLACE and error.details.get("path") == error.file:
        return message
    return words("world-error-at", file=error.file, line=error.line, column=error.column, message=message)


def world_note(note: Note, words: Phrasing) -> str:
    """One remark of a load report, with its place where it has one."""
    details = dict(note.details)
    if note.code == "unknown-colour":
        details["nearest"] = _colour_in_english(str(details.get("name", ""))) or details.get("nearest", "")
    near = "-near" if details.get("nearest") and words.knows(f"note-{note.code}-near") else ""
    remark = words(f"note-{note.code}{near}", **details)
    if not note.line:
        return remark
    return words("note-at", line=note.line, file=PurePath(note.file).name, remark=remark)


def _colour_in_english(name: str) -> str:
    """World files are Stage's: of a colour in a learner's language the word that it takes."""
    colour = keywords.argument("COLOUR", name)
    return str(colour.value) if colour else ""


def _message(error: WorldError, words: Phrasing) -> str:
    expected = either([_thing(each, words) for each in error.expected], words)
    values = {"found": "", "expected": expected, "name": "", "given": "", "limit": "", "path": ""}
    found = str(error.details.get("found", ""))
    filled = {**values, **error.details, "found": _found(found, words)}
    return words(_code(error, found, expected), **filled)


def _code(error: WorldError, found: str, expected: str) -> str:
    """The sentence of the mistake; "unexpected" says what was expected where that is short."""
    code = error.code.value
    if code == "wrong-count" and not expected:
        return "world-too-many"
    if code != "unexpected" or not 0 < len(error.expected) <= 4:
        return f"world-{code}"
    return "world-unexpected-expecting" if found else "world-unexpected-end"


def _found(found: str, words: Phrasing) -> str:
    """What stands there; a lone character that nothing shows, by what it is."""
    if len(found) == 1 and not found.isprintable():
        return words("world-control-character")
    return words(CODE_OF[found]) if found in CODE_OF else found


def _thing(expected: str, words: Phrasing) -> str:
    if words.knows(f"world-expected-{expected}"):
        return words(f"world-expected-{expected}")
    return words(CODE_OF[expected]) if expected in CODE_OF else expected
