"""An END alone before the first word of a block on a later line: ``END``, and below it ``REPEAT 3 TIMES``.

The two words of an END may stand on two lines, so the lexer takes them for one. Where the rest of a head
stands behind the second one, they are two.
"""

from __future__ import annotations

import re

from language.lexer import END, KIND, Token
from language.outline import ENDS
from language.recovery.kinds import BEGINNERS, HEAD_ENDS
from language.source import Lines


def part(tokens: list[Token], flaws: list[int], source: str, first_line: int) -> None:
    """Put two tokens in the place of each such one."""
    found = [at for at, token in enumerate(tokens) if token[0] in ENDS and _is_over_lines(token, source)]
    lines = Lines(source, first_line) if found else None
    for at in reversed(found):
        assert lines is not None
        kind, start, end, line, column, text = tokens[at]
        written = source[start:end]
        begin = end - len(written.split()[-1])
        own_line, own_column = lines.place(begin)
        if _has_head(tokens, at + 1, own_line):
            first, second = text.split()
            first_end = start + len(re.split(r"\W", written, maxsplit=1)[0])
            tokens[at : at + 1] = [
                (END, start, first_end, line, column, first),
                (KIND[ENDS[kind]], begin, end, own_line, own_column, second),
            ]
            flaws[:] = [each + (each > at) for each in flaws]


def _is_over_lines(token: Token, source: str) -> bool:
    return len(source[token[1] : token[2]].splitlines()) > 1


def _has_head(tokens: list[Token], at: int, line: int) -> bool:
    """Whether the rest of a head stands on that line."""
    while tokens[at][3] == line and tokens[at][0] and tokens[at][0] not in BEGINNERS:
        if tokens[at][0] in HEAD_ENDS:
            return True
        at += 1
    return False
