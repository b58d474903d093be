"""Blocks in blocks and parentheses in parentheses, up to a stated limit.

Nobody nests so deeply on purpose; with the limit, whatever walks a tree may do so recursively.
"""

from __future__ import annotations

from language.diagnostics import Diagnostic, Kind
from language.lexer import END, KIND, Token, span_of
from language.outline import ENDS, OPENERS

MOST_BLOCKS = 200
MOST_PARENTHESES = 200

_LPAR, _RPAR = KIND["LPAR"], KIND["RPAR"]
_BEGIN_COMMANDS = OPENERS.keys() | {
    KIND[name] for name in ("VAR", "SPEAK", "FW", "BW", "TR", "TL", "WAIT", "ASSIGN")
}


def nested_too_deeply(tokens: list[Token]) -> tuple[Diagnostic, ...]:
    """The first block and the first parenthesis that are too deep."""
    kinds = [token[0] for token in tokens]
    found = []
    if sum(map(kinds.count, OPENERS)) > MOST_BLOCKS:
        found += _too_deep_block(tokens)
    if kinds.count(_LPAR) > MOST_PARENTHESES:
        found += _too_deep_parenthesis(tokens)
    return tuple(found)


def _too_deep_block(tokens: list[Token]) -> list[Diagnostic]:
    depth = 0
    for token in tokens:
        if token[0] in OPENERS:
            depth += 1
            if depth > MOST_BLOCKS:
                return [_too_deep(token, "blocks", MOST_BLOCKS)]
        elif token[0] in ENDS or token[0] == END:
            depth = max(0, depth - 1)
    return []


def _too_deep_parenthesis(tokens: list[Token]) -> list[Diagnostic]:
    depth = 0
    for token in tokens:
        kind = token[0]
        if kind == _LPAR:
            depth += 1
            if depth > MOST_PARENTHESES:
                return [_too_deep(token, "parentheses", MOST_PARENTHESES)]
        elif kind == _RPAR:
            depth = max(0, depth - 1)
        elif kind in _BEGIN_COMMANDS:
            depth = 0
    return []


def _too_deep(token: Token, code: str, limit: int) -> Diagnostic:
    return Diagnostic(Kind.TOO_DEEP, span_of(token), code, details={"limit": limit})
