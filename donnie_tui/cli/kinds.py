"""What the options write, known by how such a file begins: an earlier one may be replaced, nothing else.

Who meant to name the program to run (``--record lesson.gd``) keeps it.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

_ENOUGH = 4096
"""Bytes that are looked at."""
_BRAILLE = frozenset(range(0x20, 0x60)) | frozenset(b"\r\n\f")
"""What ASCII braille is made of."""

_BEGINNINGS: Mapping[str, tuple[bytes, ...]] = {
    "--record": (b'{"donnie_recording"',),
    "--events": (b'{"seq"',),
    "--sound": (b"RIFF",),
    "--svg": (b"<svg", b"<?xml", b"<!--", b"<!DOCTYPE svg"),
}


def may_be_replaced(option: str, path: Path) -> bool:
    """Whether nothing is there, nothing is in it, or it is what ``option`` writes; also what is no file."""
    try:
        if not path.is_file():
            return True
        with path.open("rb") as file:
            beginning = file.read(_ENOUGH)
    except FileNotFoundError:
        return True
    except (OSError, ValueError):
        return False
    return not beginning.strip() or _is_of_kind(option, beginning, path)


def _is_of_kind(option: str, beginning: bytes, path: Path) -> bool:
    if option == "--brf":
        return path.suffix.lower() in (".brf", ".brl") and _BRAILLE.issuperset(beginning)
    return beginning.removeprefix(b"\xef\xbb\xbf").lstrip().startswith(_BEGINNINGS[option])
