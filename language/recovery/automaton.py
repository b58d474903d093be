"""The parser's automaton without a tree: its states, and which tokens it accepts in them.

``accepts`` tries the token on a copy, so the answer is exact. The rows of the table alone also allow tokens
that cause reductions and then fit nowhere.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from language.keywords import canonical_of_terminal
from language.lexer import KIND, SENSORS
from language.tables import ACTIONS, END, GOTOS, NONTERMINALS, RULES, START, TERMINALS

_SCAN = KIND["SCAN"]
"""Stands for any command: the automaton accepts all commands in the same places."""

_NONTERMINAL = {name: number for number, name in enumerate(NONTERMINALS)}

_BEGIN_EXPRESSIONS = SENSORS | {"NAME", "NUMBER", "SIGN", "LPAR"}
_CONTINUATIONS = frozenset(("SIGN", "SCALE", "TOPIC", "$END"))
CLASSES = {
    "NAME": "name",
    "NUMBER": "number",
    "STRING": "text",
    "COMPARATOR": "comparison",
    "AXIS": "axis",
    "DIRECTION": "direction",
    "COLOUR": "colour",
    "SWITCH": "on-or-off",
    "$END": "end of text",
    "SIGN": "operator",
    "SCALE": "operator",
    "ASSIGN": "=",
    "LPAR": "(",
    "RPAR": ")",
    "LSQB": "[",
    "RSQB": "]",
    "COMMA": ",",
    "COLON": ":",
    "SEMICOLON": ";",
}
"""What ``Diagnostic.expected`` calls each terminal that is no keyword."""


class Automaton:
    """A stack of states."""

    def __init__(self) -> None:
        self.states = [START]

    def accepts(self, kind: int) -> bool:
        """Whether a token of this kind may come next."""
        return _shift(self.states, kind) is not None

    def is_between_commands(self) -> bool:
        """Whether the text so far is complete and a command may come next."""
        return self.accepts(_SCAN)

    def feed(self, kind: int) -> None:
        """Consume a token that is accepted."""
        states = _shift(self.states, kind)
        assert states is not None, f"{TERMINALS[kind]} is not accepted"
        self.states = states

    def finish_command(self) -> int:
        """Reduce the complete command. Returns the depth to which ``cut`` can return."""
        states = _shift(self.states, KIND["SEMICOLON"])
        assert states is not None, "only where a command may begin"
        self.states = states[:-1]
        return len(self.states)

    def cut(self, depth: int) -> None:
        """Drop the states above ``depth``."""
        del self.states[depth:]

    def move(self, symbols: Iterable[str]) -> None:
        """Consume these symbols of the grammar, as if the text contained them."""
        for symbol in symbols:
            if symbol in _NONTERMINAL:
                self.states.append(GOTOS[self.states[-1]][_NONTERMINAL[symbol]])
            else:
                self.feed(KIND[symbol])

    def acceptable(self) -> frozenset[str]:
        """The terminals that may come next."""
        return frozenset(name for kind, name in enumerate(TERMINALS) if self.accepts(kind))

    def expected(self) -> tuple[str, ...]:
        """The same in the words of ``Diagnostic.expected``, without what is always possible."""
        names = self.acceptable()
        words: list[str] = []
        if "SCAN" in names:
            words.append("command")
            names -= _begin_commands()
        elif "NUMBER" in names:
            words.append("expression")
            names -= _BEGIN_EXPRESSIONS
        if words or names - _CONTINUATIONS:
            names -= _CONTINUATIONS
        ordered = sorted(names, key=lambda name: KIND[name])
        return tuple(
            dict.fromkeys(words + [CLASSES.get(name) or canonical_of_terminal(name) for name in ordered])
        )


@cache
def _begin_commands() -> frozenset[str]:
    """What may come first in a program."""
    return Automaton().acceptable() - {"$END"}


def _shift(states: list[int], kind: int) -> list[int] | None:
    """The states after that token, or None if the automaton does not accept it."""
    after = list(states)
    while True:
        action = ACTIONS[after[-1]][kind]
        if action >= 0:
            is_end = kind == KIND["$END"] and after[-1] == END
            return [*after, action] if action or is_end else None
        nonterminal, count = RULES[action][:2]
        if count:
            del after[-count:]
        after.append(GOTOS[after[-1]][nonterminal])
