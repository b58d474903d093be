"""The tokens that open a block and those that end it."""

from __future__ import annotations

from collections.abc import Sequence

from language.lexer import KIND, NAME, Token
from language.source import fold_name

OPENERS = {KIND[name]: name for name in ("IF", "FOR", "REPEAT", "WHILE", "PROCEDURE")}
ENDS = {KIND[f"END_{name}"]: name for name in OPENERS.values()}

_NOT = ("not", "nao", "no")


def is_split_else(tokens: Sequence[Token], at: int) -> bool:
    """Whether a line ends with ``SI NO`` there, which learners write for SINO: no condition follows."""
    opener, word, after = (*tokens[at : at + 3], None, None)[:3]
    if opener is None or opener[0] != KIND["IF"] or word is None or word[0] != NAME:
        return False
    ends_line = after is None or after[3] > word[3] or after[1] == after[2]
    return ends_line and fold_name(word[5]) in _NOT
