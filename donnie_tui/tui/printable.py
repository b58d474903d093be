"""Nothing but text reaches the terminal: control characters of a program or a file name are never painted.

A text with escape sequences could otherwise set the terminal's title or hide its cursor.
"""

from __future__ import annotations

import re

from rich.cells import cell_len
from rich.segment import Segment
from textual.color import Color
from textual.filter import LineFilter

from language.source import HARMFUL

_HARMFUL = re.compile(HARMFUL)


class Printable(LineFilter):
    """Blanks, where a control character has a width; nothing where it has none."""

    def apply(self, segments: list[Segment], background: Color) -> list[Segment]:  # noqa: ARG002 -- Textual's
        return [_printable(segment) for segment in segments]


def _printable(segment: Segment) -> Segment:
    text, style, control = segment
    if control or (text.isascii() and text.isprintable()) or not _HARMFUL.search(text):
        return segment
    return Segment(_HARMFUL.sub(_blank, text), style)


def _blank(found: re.Match[str]) -> str:
    return " " * cell_len(found.group())
