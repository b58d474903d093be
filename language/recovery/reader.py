"""The reader of a wrong text: its place among the tokens, the blocks open there, the mistakes found so far.

The other modules of recovery look at the reader's place and move it. Invariant: the automaton is in the
state to which the tokens before the place lead, where each mistake counts as what it was taken for.

``Automaton`` is that of the parser without a tree: its states, and which tokens it accepts in them.
``accepts`` tries the token on a copy, so the answer is exact. The rows of the table alone also allow tokens
that cause reductions and then fit nowhere.
"""

from __future__ import annotations

import re
from bisect import bisect_left, insort
from collections.abc import Collection, Iterable, Mapping
from functools import cache, cached_property
from itertools import pairwise

from msgspec import Struct

from language.diagnostics import Diagnostic, MistakeKind
from language.keywords import canonical_of_terminal
from language.lexer import (
    END,
    KIND,
    NAME,
    NUMBER,
    SENSORS,
    STRING,
    Lexed,
    Token,
    language_of,
    languages_in,
    span_of,
    without_comments,
)
from language.locales import ENGLISH
from language.outline import ENDS, OPENERS, SIMPLE
from language.source import Lines
from language.syntax import DeclaredProcedure
from language.tables import ACTIONS, GOTOS, NONTERMINALS, RULES, START, TERMINALS
from language.tables import END as END_STATE

_SCAN = KIND["SCAN"]
"""Stands for any command: the automaton accepts all commands in the same places."""

_NONTERMINAL = {name: number for number, name in enumerate(NONTERMINALS)}

_BEGIN_EXPRESSIONS = SENSORS | {"NAME", "NUMBER", "SIGN", "LPAR"}
_CONTINUATIONS = frozenset(("SIGN", "SCALE", "TOPIC", "$END"))
CLASSES = {
    "NAME": "name",
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
            is_end = kind == KIND["$END"] and after[-1] == END_STATE
            return [*after, action] if action or is_end else None
        nonterminal, count = RULES[action][:2]
        if count:
            del after[-count:]
        after.append(GOTOS[after[-1]][nonterminal])


ASSIGN, COMPARATOR, ELSE, LPAR, SEMICOLON, SIGN, VAR = (
    KIND[name] for name in ("ASSIGN", "COMPARATOR", "ELSE", "LPAR", "SEMICOLON", "SIGN", "VAR")
)
_PROCEDURE, _COLON, _COMMA = (KIND[name] for name in ("PROCEDURE", "COLON", "COMMA"))

AFTER_FIRST_NAME = frozenset(KIND[name] for name in ("ASSIGN", "LSQB"))
"""Show that the name before begins a command: an assignment or a call."""

HEAD_ENDS = frozenset(KIND[name] for name in ("THEN", "DO", "TIMES"))

BEGINNERS = SIMPLE | OPENERS.keys() | ENDS.keys() | {ELSE, END}
"""Begin a command or end a block in any place."""

_INSERTED = ("head-end", "head-end-before")
"""Codes of mistakes where the meant word is missing after the token before."""

_FROM_TOKEN_BEFORE = ("text-quotes", "filler")
"""Codes of mistakes where the meant text replaces the token before, too."""


class OpenBlock(Struct):
    """An open block."""

    kind: str
    """``IF``, ``FOR`` ...; empty for one whose opening word is unknown."""
    token: Token
    read_as: str
    """The block of the grammar that its END will end: another one after an exchange."""
    depth: int
    """Of the automaton, after the opening word."""


class Known(Struct, frozen=True):
    """What is known before a text is read."""

    colours: frozenset[str] | None = None
    """The ones that the robot can see; None if that is unknown."""
    procedures: Mapping[str, DeclaredProcedure] = {}
    """Those declared before the text, by folded name."""
    variables: Collection[str] = ()
    """Folded names, declared before the text."""
    learner: str = ENGLISH
    """The learner's language: of words that several languages have, its word is meant."""


class TokenReader:
    """Reads the tokens of one text and collects the mistakes in it."""

    def __init__(self, lexed: Lexed, known: Known) -> None:
        self._lexed = lexed
        self._known = known
        self._flaws = list(lexed.flaws)
        self.colours = known.colours
        self.language = language_of(lexed.tokens, lexed.source)
        self.tokens = [*lexed.tokens, _end_token(lexed)]
        _split_lone_end_words(self.tokens, self._flaws, lexed)
        borders = [at for at, token in enumerate(self.tokens) if _is_border(token[0])]
        self._borders = [at - len(self.tokens) for at in borders]
        """The opening words and ENDs by their distances from the end, which stay. Only those ahead count."""
        self._kinds_of_borders = [self.tokens[at][0] for at in borders]
        self.at = 0
        """The index of the next token."""
        self.begun = 0
        """The index of the first token of the current command."""
        self.base = 1
        """The depth of the automaton before that command."""
        self.automaton = Automaton()
        self.blocks: list[OpenBlock] = []
        self.head: OpenBlock | None = None
        """The innermost block, while the place is in its head."""
        self.else_if: Token | None = None
        """The IF of the last ELSE IF."""
        self.found: list[Diagnostic] = []

    # --- looking

    @property
    def token(self) -> Token:
        return self.tokens[self.at]

    @property
    def before(self) -> Token:
        """The token before; at the beginning the one that stands for the end."""
        return self.tokens[self.at - 1]

    @property
    def following(self) -> Token:
        return self.tokens[self.at + 1]

    @property
    def is_at_end(self) -> bool:
        return self.token[0] == 0

    @property
    def is_first_of_line(self) -> bool:
        return self.at == 0 or self.before[3] != self.token[3]

    @property
    def is_decimal_comma(self) -> bool:
        """Whether the token is the comma of a number that is not whole: 2,5."""
        three = (self.before, self.token, self.following)
        return [token[0] for token in three] == [NUMBER, _COMMA, NUMBER] and (
            three[0][2] == three[1][1] and three[1][2] == three[2][1]
        )

    @cached_property
    def spoken(self) -> list[str]:
        """Every language that has a keyword in the text."""
        return sorted(languages_in(self._lexed.tokens, self._lexed.source))

    @property
    def spoken_first(self) -> tuple[str, ...]:
        """The languages in which a beginner's words are looked for first: of the text, then the learner's."""
        of_text = (each for each in (self.language, *self.spoken) if each != ENGLISH)
        return (*of_text, self._known.learner)

    @cached_property
    def procedures(self) -> dict[str, tuple[str, ...]]:
        """The names of the parameters of each procedure, declared before the text or anywhere in it."""
        before = {
            name: tuple(each.program.typed(value.span) for value in each.procedure.parameters)
            for name, each in self._known.procedures.items()
        }
        heads = (at + 1 for at, token in enumerate(self.tokens) if token[0] == _PROCEDURE)
        here = {self.tokens[at][5]: self._parameters(at + 1) for at in heads if self.tokens[at][0] == NAME}
        return before | here

    def declares(self, name: str) -> bool:
        """Whether a variable or a parameter of that folded name is declared in the text or before it."""
        return name in self._declared_names or name in self._known.variables

    @cached_property
    def _declared_names(self) -> frozenset[str]:
        pairs = pairwise(self.tokens)
        return frozenset(token[5] for before, token in pairs if before[0] in (VAR, _COLON, _COMMA))

    def _parameters(self, at: int) -> tuple[str, ...]:
        found: list[str] = []
        while self.tokens[at][0] in (_COLON, _COMMA) and self.tokens[at + 1][0] == NAME:
            found.append(self.typed(self.tokens[at + 1]))
            at += 2
        return tuple(found)

    def source_of(self, first: Token, last: Token) -> str:
        """The text from one token to another, both included, as typed."""
        return self._lexed.source[first[1] : last[2]]

    def typed(self, token: Token) -> str:
        typed = self._lexed.source[token[1] : token[2]]
        return " ".join((typed if token[0] == STRING else without_comments(typed)).split())

    # --- moving

    def begin_command(self) -> None:
        """A command begins here."""
        self.base = self.automaton.finish_command()
        self.begun = self.at

    def advance(self) -> None:
        """Consume the next token, which is accepted."""
        token = self.token
        self.automaton.feed(token[0])
        self.at += 1
        if token[0] in OPENERS:
            kind = OPENERS[token[0]]
            before = self.tokens[self.at - 2]
            if kind == "IF" and before[0] == ELSE and before[3] == token[3]:
                self.else_if = token
            self.head = OpenBlock(kind, token, kind, len(self.automaton.states))
            self.blocks.append(self.head)
        elif token[0] in HEAD_ENDS:
            self.head = None

    def borders_ahead(self, at: int, most: int) -> list[int]:
        """The kinds of that many opening words and ENDs at most, from the token ``at`` on."""
        first = bisect_left(self._borders, at - len(self.tokens))
        return self._kinds_of_borders[first : first + most]

    def replace(self, width: int, terminal: str) -> None:
        """Read ``width`` tokens as one of another kind, after a mistake was reported there."""
        _, start, _, line, column, text = self.token
        end = self.tokens[self.at + width - 1][2]
        self.tokens[self.at : self.at + width] = [(KIND[terminal], start, end, line, column, text)]
        self._flaws = [each if each <= self.at else each - width + 1 for each in self._flaws]
        self.mark_flaw()

    # --- reporting

    def mark_flaw(self) -> None:
        """Note that the rest of this command may be wrong only because of this token."""
        insort(self._flaws, self.at)

    def report(
        self,
        kind: MistakeKind,
        token: Token,
        code: str = "",
        expected: tuple[str, ...] = (),
        meant: str = "",
        details: dict[str, str | int] | None = None,
        width: int = 1,
    ) -> None:
        """Add a mistake, unless it may follow from an earlier one. ``meant`` replaces ``width`` tokens."""
        if kind is not MistakeKind.MISSING_END and self._is_flawed():
            return
        begins_before = code in _FROM_TOKEN_BEFORE
        end = self.tokens[self.at + width - 1][2] if meant and (width > 1 or begins_before) else None
        of_meant = (code, self.typed(token), expected, meant, details or {})
        meant_at = self.before[2] if code in _INSERTED else self.before[1] if begins_before else None
        self.found.append(Diagnostic(kind, span_of(token), *of_meant, meant_end=end, meant_at=meant_at))

    def _is_flawed(self) -> bool:
        """Whether a mistake in this command was reported before."""
        index = bisect_left(self._flaws, self.begun)
        if index >= len(self._flaws) or self._flaws[index] > self.at:
            return False
        flaw = self.tokens[max(self.begun, self._flaws[index] - 1)]
        return not self.automaton.is_between_commands() or flaw[3] == self.token[3]


def _is_border(kind: int) -> bool:
    return kind in OPENERS or kind in ENDS or kind == END


def _end_token(lexed: Lexed) -> Token:
    """Stands right after the last token of the text."""
    end = lexed.tokens[-1][2] if lexed.tokens else 0
    line, column = Lines(lexed.source, lexed.first_line).place(end)
    return (0, end, end, line, column, "")


def _split_lone_end_words(tokens: list[Token], flaws: list[int], lexed: Lexed) -> None:
    """Split each END alone from the first word of a block on a later line: ``END``, then ``REPEAT 3 TIMES``.

    The two words of an END may be on two lines, so the lexer reads them as one token. If the rest of a head
    follows the second word, they are two.
    """
    found = [at for at, token in enumerate(tokens) if token[0] in ENDS and _spans_lines(token, lexed.source)]
    lines = Lines(lexed.source, lexed.first_line) if found else None
    for at in reversed(found):
        assert lines is not None
        kind, start, end, line, column, text = tokens[at]
        written = lexed.source[start:end]
        begin = end - len(written.split()[-1])
        second_line, second_column = lines.place(begin)
        if _has_head(tokens, at + 1, second_line):
            first, second = text.split()
            first_end = start + len(re.split(r"\W", written, maxsplit=1)[0])
            tokens[at : at + 1] = [
                (END, start, first_end, line, column, first),
                (KIND[ENDS[kind]], begin, end, second_line, second_column, second),
            ]
            flaws[:] = [each + (each > at) for each in flaws]


def _spans_lines(token: Token, source: str) -> bool:
    return len(source[token[1] : token[2]].splitlines()) > 1


def _has_head(tokens: list[Token], at: int, line: int) -> bool:
    """Whether the rest of a head is on that line."""
    while tokens[at][3] == line and tokens[at][0] and tokens[at][0] not in BEGINNERS:
        if tokens[at][0] in HEAD_ENDS:
            return True
        at += 1
    return False
