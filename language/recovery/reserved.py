"""Keywords that stand where the learner needs a name of his own."""

from __future__ import annotations

from language.diagnostics import Kind
from language.keywords import is_reserved
from language.lexer import KIND, NAME, NUMBER, Token
from language.recovery.automaton import Automaton
from language.recovery.kinds import ASSIGN
from language.recovery.reading import Reading

_BEFORE_NEW_NAME = frozenset(
    KIND[name] for name in ("VAR", "PROCEDURE", "COLON", "COMMA", "FOR", "SEMICOLON")
)


def tell_reserved(reading: Reading, token: Token) -> None:
    reading.tell(Kind.RESERVED_WORD, token, details={"name": reading.typed(token)})


def is_assigned_to_keyword(reading: Reading) -> bool:
    """Whether an equals sign stands behind a keyword with which the command begins."""
    before = reading.before
    if reading.token[0] != ASSIGN or reading.at - 1 != reading.begun:
        return False
    return is_reserved(before[5]) and before[0] not in _BEFORE_NEW_NAME


def is_reserved_as_name(reading: Reading) -> bool:
    """Whether a keyword stands where a new name should, and what follows would fit the name."""
    token, before, following = reading.token, reading.before, reading.following
    if before[0] not in _BEFORE_NEW_NAME or not is_reserved(token[5]):
        return False
    if not reading.automaton.accepts(NAME) or reading.automaton.accepts(NUMBER):
        return False
    if following[0] == ASSIGN:
        return True
    beyond = Automaton()
    beyond.states = list(reading.automaton.states)
    beyond.feed(NAME)
    return before[3] == token[3] and beyond.accepts(following[0])
