"""The text of a program: its blocks and levels, the places of a word in it, its mistakes and their fixes.

Everything works on any text, finished or not. ``ProgramText`` reads a program line by line: levels, the
lines that open blocks, the statements of one block, the outline. The level of a line is the number of blocks
around its first statement, as in the syntax tree; ELSE and END have the level of their block.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import chain

import msgspec

from donnie_tui.core.wording import BRAILLE_CELLS, Wording
from language import keywords
from language.diagnostics import Diagnostic, Severity
from language.lexer import lex
from language.outline import ENDS, OutlineItem, outline
from language.source import MARK, fold, fold_name, quoted
from language.tables import TERMINALS

WIDEST = 80
"""Characters of a line of the outline."""
ALIKE = 0.6
"""From this likeness on a typed line is meant to correct a wrong one."""
LONGEST_ALIKE = 300
"""Characters of a line that are compared with another one: that takes as long as both lengths multiplied."""
LONGEST_CHECKED = 50_000
"""Characters of a text that is checked for mistakes while the learner types."""


class ProgramLine(msgspec.Struct, frozen=True):
    """One line of a program."""

    number: int
    text: str
    """Without the blanks around it."""
    level: int
    closes: int = 0
    """The line that opened the block which this line's END closes; 0 for a line that begins with no END."""

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
        """Raises ``IndexError`` for a line that does not exist."""
        if not 1 <= number <= len(self.lines):
            raise IndexError(number)
        text = self.lines[number - 1].strip()
        around = self._around(number)
        ended = [each for each in around if each.end_line == number and each.is_closed]
        if ended and _begins_with_end(text):
            return ProgramLine(number, text, ended[-1].depth, ended[-1].line)
        return ProgramLine(number, text, len(around) - (_begins_with_else(text) and bool(around)))

    def openers(self, number: int) -> tuple[OutlineItem, ...]:
        """The blocks around the line, the innermost first."""
        level = self.line(number).level
        return tuple(reversed([each for each in self._around(number) if each.depth < level]))

    def opener_of(self, number: int) -> int:
        """The line that opens the block which this line's END closes or its ELSE divides; 0 for others."""
        line, around = self.line(number), self._around(number)
        is_half = bool(line.text) and not line.is_statement and bool(around)
        return line.closes or (around[-1].line if is_half else 0)

    def end_of(self, number: int) -> int:
        """The last line of the block that opens in the line, else the line itself."""
        opened = self._opened.get(number)
        return opened.end_line if opened else number

    # --- moves: the line to read next, or None

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
        """The blocks around the beginning of the line, the outermost first."""
        found: list[OutlineItem] = []
        at = self._innermost[number]
        while at is not None:
            found.append(self._blocks[at])
            at = self._outer[at]
        return found[::-1]


def _outer_blocks(blocks: Sequence[OutlineItem]) -> list[int | None]:
    """The index of the block around each block."""
    found: list[int | None] = []
    latest: dict[int, int] = {}
    for at, block in enumerate(blocks):
        found.append(latest.get(block.depth - 1))
        latest[block.depth] = at
    return found


def _innermost_blocks(blocks: Sequence[OutlineItem], lines: int) -> list[int | None]:
    """The index of the innermost block around the beginning of each line, from 1."""
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


# --- sentences


def line_in_words(line: ProgramLine, before: ProgramLine | None, wording: Wording) -> str:
    """The line, with its level where it differs from that of ``before`` (always at full, never at brief)."""
    detail = wording.detail
    changed = line.level != (before.level if before else 0)
    with_level = detail == "full" or (detail == "normal" and changed)
    text = line.text or wording("line-empty")
    if line.closes:
        text = wording("line-closes", text=text, opener=line.closes)
    return wording(
        "line-level" if with_level else "answer-line", line=line.number, level=line.level, text=text
    )


def no_such_line(count: int, number: int, wording: Wording) -> str:
    """The program, of that many lines, has no such line."""
    return wording("answer-no-line", line=number, last=count) if count else wording("no-lines")


def place_in_words(text: ProgramText, number: int, wording: Wording) -> tuple[str, ...]:
    """Which line it is of how many, and the blocks around it, the innermost first."""
    line = text.line(number)
    first = wording("place-line", line=number, lines=len(text), level=line.level)
    return (first, *(_opener_in_words(each, wording) for each in text.openers(number)))


def outline_in_words(text: ProgramText, wording: Wording) -> tuple[str, ...]:
    """How many blocks there are, then the line that opens each of them."""
    lines = text.outline_lines
    if not lines:
        return (wording("outline-none"),)
    rows = (_opening_in_words(each, wording) for each in lines)
    return (wording("outline-count", count=len(lines)), *rows)


def _opening_in_words(line: ProgramLine, wording: Wording) -> str:
    """Cuts what is longer than a line of print; READ says all of it."""
    row = wording("line-level", line=line.number, level=line.level, text=line.text)
    widest = BRAILLE_CELLS if wording.detail == "brief" else WIDEST
    return row if len(row) <= widest else f"{row[: widest - 1].rstrip()}…"


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


# --- searching


class Place(msgspec.Struct, frozen=True):
    """Where a word is: its row and its columns, from 0, without the last one. Columns of the written line."""

    row: int
    start: int
    end: int


def find_word(lines: Sequence[str], wanted: str, row: int, column: int = 0) -> Place | None:
    """The first place from there on; after the last line the search continues with the first one.

    The case of letters and their accents make no difference.
    """
    folded = fold_name(wanted)
    if not folded:
        return None
    here = [(row, column)] if row < len(lines) else []
    round_about = chain(range(row + 1, len(lines)), range(min(row + 1, len(lines))))
    order = chain(here, ((at, 0) for at in round_about))
    return next(filter(None, (_find_in_line(lines[at], folded, at, start) for at, start in order)), None)


def _find_in_line(line: str, folded: str, row: int, column: int) -> Place | None:
    """Separate accents take columns and are not compared."""
    if folded not in fold_name(line):
        return None
    columns = [at for at, character in enumerate(fold(line)) if character != MARK]
    skipped = sum(at < column for at in columns)
    at = fold_name(line).find(folded, skipped)
    if at < 0:
        return None
    end = at + len(folded)
    return Place(row, columns[at], columns[end] if end < len(columns) else len(line))


def not_found(wanted: str, wording: Wording) -> str:
    return wording("screen-not-found", word=quoted(wanted))


def not_replaceable(lines: Sequence[str], wanted: str, wording: Wording) -> str:
    """Why REPLACE finds no place: unlike SEARCH it takes a word only as it is written."""
    place = find_word(lines, wanted, 0)
    if place is None:
        return not_found(wanted, wording)
    written = quoted(lines[place.row][place.start : place.end])
    return wording("replace-otherwise", line=place.row + 1, word=written)


# --- mistakes


class LineMistake(msgspec.Struct, frozen=True):
    """What is wrong in one line, and the text that would fix it."""

    line: int
    message: str
    is_hint: bool
    start: int
    end: int
    """Offsets of the text that is to be replaced."""
    meant: str
    """What to put there instead; empty if that is not known."""
    fixed_line: int
    """The line that the fix changes: a missing word may belong at the end of the line before."""

    @property
    def replacement(self) -> str:
        """What is written for ``meant``, after a blank where it replaces nothing."""
        return self.meant if self.end > self.start else f" {self.meant}"


def mistakes(found: Iterable[Diagnostic], wording: Wording) -> dict[int, LineMistake]:
    """The first mistake of each line, by line."""
    by_line: dict[int, LineMistake] = {}
    for each in found:
        span = each.span
        is_hint = each.severity is Severity.HINT
        message = (wording.hint(each) if is_hint else None) or wording.mistake(each)
        meant = each.meant if each.found and span.end > span.start else ""
        start, end = (
            (span.start, each.meant_end or span.end)
            if each.meant_at is None
            else (each.meant_at, each.meant_end or each.meant_at)
        )
        fixed_line = int(each.details.get("line", span.line))
        found_there = LineMistake(span.line, message, is_hint, start, end, meant, fixed_line)
        by_line.setdefault(span.line, found_there)
    return by_line


def fixed(text: str, mistake: LineMistake) -> str:
    """The text with what was meant."""
    return text[: mistake.start] + mistake.replacement + text[mistake.end :]


# --- lines that are typed again


def corrected_line(
    line: str, wrong: Mapping[int, Sequence[str]], last: int, *, is_next: bool, is_refused: bool
) -> int | None:
    """The number of the wrong line that ``line`` is to replace; None if it is one more line.

    Of each ``wrong`` line its text is known, and what was probably meant.

    It is the wrong line most like it. After a refusal the very next line may also be quite another one, if
    only the ``last`` line of all was wrong; after a failed run only the very next line replaces one.
    """
    if not is_next and not is_refused:
        return None
    likeness, number = max((max(_likeness(line, each) for each in texts), at) for at, texts in wrong.items())
    if likeness >= ALIKE:
        return number
    text = line.strip()
    is_part_of_block = _begins_with_end(text) or _begins_with_else(text)
    return last if is_next and is_refused and [*wrong] == [last] and not is_part_of_block else None


def _likeness(line: str, other: str) -> float:
    """How alike two lines are: from 0 to 1, and 1 more for the same command."""
    from difflib import SequenceMatcher  # slow to load

    one, another = (fold_name(each.strip()[:LONGEST_ALIKE]) for each in (line, other))
    is_same_command = one.split()[:1] == another.split()[:1]
    return is_same_command + SequenceMatcher(None, one, another, autojunk=False).ratio()
