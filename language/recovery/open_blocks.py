"""The blocks that are open while mistakes are looked for, and what an END that fits none of them may mean."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from enum import Enum
from itertools import islice

from devices.ports.values import Mutable
from language.lexer import END, Token
from language.outline import ENDS, OPENERS

_LOOK_AHEAD = 2000
"""Openers and ENDs that are looked at before an END that does not fit is judged."""


class Block(Mutable):
    """An open block."""

    kind: str
    """``IF``, ``FOR`` ...; empty for one whose opening word is unknown."""
    token: Token
    read_as: str
    """The block of the grammar that its END will end: another one after an exchange."""
    depth: int
    """Of the automaton, behind the opening word."""


class Closing(Enum):
    """How an END is read."""

    INNERMOST = "the wrong word at the end of the innermost block"
    OUTER = "the right end of an outer block; the inner ones have none"
    EXCHANGED = "the right end of an outer block, too early; the inner one ends later"
    STRAY = "the end of nothing"


def close(blocks: list[Block], end: str, closing: Closing) -> list[str]:
    """Take the closed blocks away. Returns what to read for it: ``IF`` stands for END IF ..."""
    if closing is Closing.STRAY:
        return []
    if closing is Closing.OUTER:
        index = innermost(kinds_of(blocks), end)
        closed = [block.read_as for block in reversed(blocks[index:])]
        del blocks[index:]
        return closed
    if closing is Closing.EXCHANGED:
        for index in range(innermost(kinds_of(blocks), end), len(blocks) - 1):
            blocks[index].kind, blocks[index].token = blocks[index + 1].kind, blocks[index + 1].token
    return [blocks.pop().read_as]


def kinds_of(blocks: Sequence[Block]) -> list[str]:
    return [block.kind for block in blocks]


def best_closing(open_kinds: list[str], end: str, rest: Sequence[Token]) -> Closing:
    """The reading of an END after which the fewest mistakes follow in ``rest``."""
    ahead = ends_ahead(rest)
    left = {Closing.INNERMOST: open_kinds[:-1], Closing.STRAY: open_kinds}
    if end in open_kinds:
        index = innermost(open_kinds, end)
        left[Closing.OUTER] = open_kinds[:index]
        left[Closing.EXCHANGED] = open_kinds[:index] + open_kinds[index + 1 :]
    order = list(Closing)
    return min(left, key=lambda each: (mistakes_ahead(left[each], ahead), order.index(each)))


def ends_ahead(rest: Iterable[Token]) -> list[int]:
    """The opening words and ENDs that come next, of a long text the first ones only."""
    kinds = (token[0] for token in rest if token[0] in OPENERS or token[0] in ENDS or token[0] == END)
    return list(islice(kinds, _LOOK_AHEAD))


def mistakes_ahead(open_kinds: list[str], kinds: Sequence[int]) -> int:
    """How many ENDs do not fit if these blocks are open, and how many blocks have none."""
    stack, mistakes = list(open_kinds), 0
    for kind in kinds:
        if kind in OPENERS:
            stack.append(OPENERS[kind])
        elif stack and stack[-1] in (ENDS.get(kind, ""), ""):
            stack.pop()
        else:
            mistakes += 1
            if stack:
                stack.pop()
    return mistakes + len(stack)


def innermost(kinds: list[str], kind: str) -> int:
    """The index of the last one of a kind."""
    return len(kinds) - 1 - kinds[::-1].index(kind)
