"""Reading a program line by line with its blocks: levels, openers, siblings, the outline, the place.

Values and words only; which line is being read belongs to whoever shows it. The level of a line is the
number of blocks that its first statement is in, as in the syntax tree; ELSE and END are on the level of
the block that they belong to. Works on any text, finished or not.
"""

from __future__ import annotations

from collections.abc import Sequence

from devices.ports.values import Frozen
from donnie_tui.core.wording import Wording
from language import keywords
from language.lexer import lex
from language.outline import ENDS, OutlineItem, outline
from language.tables import TERMINALS

WIDEST = 80
"""Characters of a line of the outline."""
WIDEST_BRIEF = 40


class ProgramLine(Frozen):
    """One line of a program."""

    number: int
    text: str
    """Without the blanks around it."""
    level: int
    closes: int = 0
    """The line that opened the block which this line's END closes; 0 if it begins with no END."""

    @property
    def is_statement(self) -> bool:
        """Whether a statement begins here, and not the end or the other half of a block."""
        return bool(self.text) and not self.closes and not _begins_with_else(self.text)


class ProgramText:
    """The lines of one text with their levels. Numbers are from 1."""

    def __init__(self, lines: Sequence[str]) -> None:
        self.lines = tuple(lines)
        self._blocks = outline("\n".join(lines))
        self._outer = _outer_blocks(self._blocks)
        self._innermost = _innermost_blocks(self._blocks, len(self.lines))
        self._opened = {each.line: each for each in reversed(self._blocks)}

    def __len__(self) -> int:
        return len(self.lines)

    def line(self, number: int) -> ProgramLine:
        """Raises ``IndexError`` for a line that is not there."""
        if not 1 <= number <= len(self.lines):
            raise IndexError(number)
        text = self.lines[number - 1].strip()
        around = self._around(number)
        ended = [each for each in around if each.end_line == number and each.is_closed]
        if ended and _begins_with_end(text):
            return ProgramLine(number, text, ended[-1].depth, ended[-1].line)
        return ProgramLine(number, text, len(around) - (_begins_with_else(text) and bool(around)))

    def openers(self, number: int) -> tuple[OutlineItem, ...]:
        """The blocks that the line is in, the innermost first."""
        level = self.line(number).level
        return tuple(reversed([each for each in self._around(number) if each.depth < level]))

    # --- moves: the line to go to, or None where there is none

    def up(self, number: int) -> int | None:
        """To the line that opens the block."""
        found = self.openers(number)
        closes = self.line(number).closes
        return closes or (found[0].line if found else None)

    def down(self, number: int) -> int | None:
        """To the first line inside the block that opens here."""
        opened = self._opened.get(number)
        inside = range(number + 1, opened.end_line + 1) if opened else range(0)
        return next((each for each in inside if self.line(each).is_statement), None)

    def next_same(self, number: int) -> int | None:
        """To the next statement in the same block."""
        return self._same(number, range(number + 1, len(self.lines) + 1))

    def back_same(self, number: int) -> int | None:
        return self._same(number, range(number - 1, 0, -1))

    def _same(self, number: int, candidates: range) -> int | None:
        level = self.line(number).level
        for each in candidates:
            line = self.line(each)
            if line.text and line.level < level:
                return None
            if line.is_statement and line.level == level:
                return each
        return None

    @property
    def outline_lines(self) -> tuple[ProgramLine, ...]:
        """The lines that open a block."""
        return tuple(self.line(number) for number in sorted({each.line for each in self._blocks}))

    def _around(self, number: int) -> list[OutlineItem]:
        """The blocks that the beginning of the line is in, the outermost first."""
        found: list[OutlineItem] = []
        at = self._innermost[number]
        while at is not None:
            found.append(self._blocks[at])
            at = self._outer[at]
        return found[::-1]


def _outer_blocks(blocks: Sequence[OutlineItem]) -> list[int | None]:
    """Of each block the one around it, by number."""
    found: list[int | None] = []
    latest: dict[int, int] = {}
    for at, block in enumerate(blocks):
        found.append(latest.get(block.depth - 1))
        latest[block.depth] = at
    return found


def _innermost_blocks(blocks: Sequence[OutlineItem], lines: int) -> list[int | None]:
    """Of each line (from 1) the innermost block that it begins in."""
    found: list[int | None] = [None]
    open_blocks: list[int] = []
    following = 0
    for number in range(1, lines + 1):
        while open_blocks and blocks[open_blocks[-1]].end_line < number:
            open_blocks.pop()
        found.append(open_blocks[-1] if open_blocks else None)
        while following < len(blocks) and blocks[following].line == number:
            if blocks[following].end_line > number:
                open_blocks.append(following)
            following += 1
    return found


# --- words


def line_in_words(line: ProgramLine, before: ProgramLine | None, wording: Wording) -> str:
    """The line; its level when it is another one than ``before`` (always at full, never at brief)."""
    detail = wording.detail
    changed = line.level != (before.level if before else 0)
    with_level = detail == "full" or (detail == "normal" and changed)
    text = line.text or wording("line-empty")
    if line.closes:
        text = wording("line-closes", text=text, opener=line.closes)
    return wording(
        "line-level" if with_level else "answer-line", line=line.number, level=line.level, text=text
    )


def place_in_words(text: ProgramText, number: int, wording: Wording) -> tuple[str, ...]:
    """Which line it is of how many, and the blocks it is in, the innermost first."""
    line = text.line(number)
    first = wording("place-line", line=number, lines=len(text), level=line.level)
    return (first, *(_opener_in_words(each, wording) for each in text.openers(number)))


def outline_in_words(text: ProgramText, wording: Wording) -> tuple[str, ...]:
    """How many blocks there are, then the line that opens each."""
    lines = text.outline_lines
    if not lines:
        return (wording("outline-none"),)
    told = (_opening_in_words(each, wording) for each in lines)
    return (wording("outline-count", count=len(lines)), *told)


def _opening_in_words(line: ProgramLine, wording: Wording) -> str:
    """What is longer than a line of print is cut: READ says all of it."""
    told = wording("line-level", line=line.number, level=line.level, text=line.text)
    widest = WIDEST_BRIEF if wording.detail == "brief" else WIDEST
    return told if len(told) <= widest else f"{told[: widest - 1].rstrip()}…"


def _opener_in_words(block: OutlineItem, wording: Wording) -> str:
    kind = keywords.spelling(block.kind, wording.language)
    name = f"{kind} {block.name}".strip()
    return wording("place-in", opener=name, line=block.line)


def _begins_with_end(text: str) -> bool:
    return _first_kind(text) in ENDS


def _begins_with_else(text: str) -> bool:
    kind = _first_kind(text)
    return kind is not None and TERMINALS[kind] == "ELSE"


def _first_kind(text: str) -> int | None:
    if text[:1].upper() not in "EFS":  # END, ELSE, FIM, FIN, SE NÃO, SINO
        return None
    tokens = lex(text).tokens
    return tokens[0][0] if tokens else None
