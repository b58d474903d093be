"""The blocks of a text, finished or not: for the prompt, and for lists and jumps in an editor.

Works on any text and ignores its mistakes. An END closes the innermost block of its kind and all open blocks
in it. An END that fits no block closes nothing.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from msgspec import Struct

from language.keywords import WORDS
from language.lexer import KIND, NAME, SENSORS, Token, lex
from language.locales import languages, words
from language.source import fold_name
from language.tables import TERMINALS


class OutlineItem(Struct, frozen=True):
    """A block: ``IF``, ``FOR``, ``REPEAT``, ``WHILE`` or ``PROCEDURE``."""

    kind: str
    name: str
    """Of a procedure, as it was typed; empty for the others."""
    line: int
    end_line: int
    """The line of its END, of the END of an outer block, or of the last word of the text."""
    depth: int
    """The number of blocks around it."""
    is_closed: bool
    """Whether it has its own END."""


class _OpenBlock(Struct, frozen=True):
    kind: str
    index: int
    """Of the token that opened it."""


def block_depth(source: str) -> int:
    """The number of blocks that are open at the end of a text."""
    blocks: list[_OpenBlock] = []
    for _ in _closed(lex(source).tokens, blocks):
        pass
    return len(blocks)


def open_block(source: str, *, first_line: int = 1) -> OutlineItem | None:
    """The innermost block that is open at the end of a text."""
    depth = block_depth(source)
    blocks = outline(source, first_line=first_line) if depth else ()
    return next((block for block in reversed(blocks) if block.depth == depth - 1), None)


def outline(source: str, *, first_line: int = 1) -> tuple[OutlineItem, ...]:
    """Every block of a text, in the order of their first words."""
    tokens = lex(source, first_line).tokens
    left_open: list[_OpenBlock] = []
    found = {
        block.index: _item(source, tokens, block, depth, end_line, is_closed)
        for block, depth, end_line, is_closed in _closed(tokens, left_open)
    }
    for depth, block in enumerate(left_open):
        found[block.index] = _item(source, tokens, block, depth, tokens[-1][3], False)
    return tuple(found[index] for index in sorted(found))


def _closed(tokens: list[Token], blocks: list[_OpenBlock]) -> Iterator[tuple[_OpenBlock, int, int, bool]]:
    """Each block as it ends, with its depth, the line of its end, whether that is its own END.

    Blocks that are open at the end of the text stay in ``blocks``.
    """
    open_kinds: Counter[str] = Counter()
    for index, token in enumerate(tokens):
        kind = ENDS.get(token[0])
        if token[0] in OPENERS and not (open_kinds["IF"] and is_split_else(tokens, index)):
            blocks.append(_OpenBlock(TERMINALS[token[0]], index))
            open_kinds[blocks[-1].kind] += 1
        elif kind is not None and open_kinds[kind]:
            is_its_own = False
            while not is_its_own:
                block = blocks.pop()
                open_kinds[block.kind] -= 1
                is_its_own = block.kind == kind
                yield block, len(blocks), token[3], is_its_own


def _item(
    source: str, tokens: list[Token], block: _OpenBlock, depth: int, end_line: int, is_closed: bool
) -> OutlineItem:
    opener, name = tokens[block.index], tokens[block.index + 1 : block.index + 2]
    is_named = block.kind == "PROCEDURE" and bool(name) and name[0][0] == NAME
    typed = source[name[0][1] : name[0][2]] if is_named else ""
    return OutlineItem(block.kind, typed, opener[3], end_line, depth, is_closed)


INDENT = "  "
"""The indentation of a block, for each level."""
OPENERS = {KIND[name]: name for name in ("IF", "FOR", "REPEAT", "WHILE", "PROCEDURE")}
ENDS = {KIND[f"END_{name}"]: name for name in OPENERS.values()}
SENSOR_WORDS = frozenset(KIND[name] for name in SENSORS)

_FIRST_WORDS = frozenset(KIND[each.terminal] for each in WORDS if each.topic == each.terminal)
SIMPLE = _FIRST_WORDS - OPENERS.keys() - SENSOR_WORDS - {KIND["VAR"]}
"""The words of commands that open no block."""

_NOT = frozenset(
    fold_name(word) for each in languages() for word in words(each, "keywords", "else", "second")
)
_BEGIN_NO_CONDITION = OPENERS.keys() | SIMPLE | {KIND["VAR"]}


def is_split_else(tokens: Sequence[Token], at: int) -> bool:
    """Whether ``SI NO`` is there, as learners write SINO: the line ends after it, or a command follows."""
    word, after = (*tokens[at + 1 : at + 3], None, None)[:2]
    if tokens[at][0] != KIND["IF"] or word is None or word[0] != NAME:
        return False
    is_over = after is None or after[3] > word[3] or after[1] == after[2] or after[0] in _BEGIN_NO_CONDITION
    return is_over and fold_name(word[5]) in _NOT
