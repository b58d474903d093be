"""Syntax highlighting with the language's own lexer: commands, numbers, texts, comments.

So the highlighting agrees with the parser. Ranges have the form that Textual's
editor needs: by line, in UTF-8 bytes.
"""

from __future__ import annotations

from collections import defaultdict
from typing import TypeAlias

from language.lexer import FRAGMENT, NAME, NUMBER, STRING, TOPIC, Token, lex
from language.tables import TERMINALS

Highlight: TypeAlias = tuple[int, int | None, str]
"""First byte, byte after the last (None: to the end of the line), and the name of the look."""

LARGEST = 200_000
"""Longer programs have no highlighting, since every keystroke reads the whole text."""

LONGEST_LINE = 2000
"""Longer lines have no highlighting, since the editor scans the whole line for each row of it."""

_LOOK_OF_KIND = {NAME: "", NUMBER: "number", STRING: "string", TOPIC: "argument", FRAGMENT: ""}
_LOOK_OF_TERMINAL = {
    **dict.fromkeys(("DIRECTION", "AXIS", "COLOUR", "SWITCH"), "argument"),
    **dict.fromkeys(("ASSIGN", "COMPARATOR", "SIGN", "SCALE"), "operator"),
    **dict.fromkeys(("LPAR", "RPAR", "LSQB", "RSQB", "COMMA", "COLON", "SEMICOLON"), ""),
}


def highlights(source: str) -> dict[int, list[Highlight]]:
    """The highlights of a text, by line from 0. Never raises."""
    found: dict[int, list[Highlight]] = defaultdict(list)
    if len(source) > LARGEST:
        return found
    lexed = lex(source)
    places = _Places(source)
    for token in lexed.tokens:
        look = _look(token)
        if look:
            places.add(found, token[1], token[2], look)
    for comment in lexed.comments:
        places.add(found, comment.start, comment.end, "comment")
    return found


def _look(token: Token) -> str:
    kind = token[0]
    if kind in _LOOK_OF_KIND:
        return _LOOK_OF_KIND[kind]
    name = TERMINALS[kind] if 0 <= kind < len(TERMINALS) else "SIGN"
    return _LOOK_OF_TERMINAL.get(name, "command")


class _Places:
    """Offsets as lines and bytes."""

    def __init__(self, source: str) -> None:
        self._lines = source.splitlines(keepends=True) or [""]
        self._starts = [0]
        for line in self._lines:
            self._starts.append(self._starts[-1] + len(line))
        self._line = 0

    def add(self, found: dict[int, list[Highlight]], start: int, end: int, look: str) -> None:
        """Add a range, split at line ends. Ranges mostly come in order, so the search continues."""
        while start < self._starts[self._line]:
            self._line -= 1
        while self._line + 1 < len(self._lines) and start >= self._starts[self._line + 1]:
            self._line += 1
        line = self._line
        while start < end and line < len(self._lines):
            stop = min(end, self._starts[line + 1])
            if len(self._lines[line]) <= LONGEST_LINE:
                found[line].append((self._bytes(line, start), self._bytes(line, stop), look))
            start, line = stop, line + 1

    def _bytes(self, line: int, offset: int) -> int:
        text = self._lines[line]
        return len(text[: offset - self._starts[line]].encode("utf-8", "surrogatepass"))
