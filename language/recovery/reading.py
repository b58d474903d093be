"""One reading of one text: the place among its tokens, the blocks that are open there, and what was found.

Whoever looks for mistakes looks at this place and moves it. The rule it keeps: the automaton stands where
the tokens before the place bring it, with each mistake read as what it was taken for.
"""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Mapping
from functools import cached_property
from types import MappingProxyType

from language.diagnostics import Diagnostic, Kind
from language.lexer import KIND, NAME, NUMBER, STRING, Lexed, Token, span_of, without_comments
from language.origin import language_of, languages_in
from language.outline import OPENERS
from language.recovery.automaton import Automaton
from language.recovery.kinds import HEAD_ENDS
from language.recovery.lone_ends import part
from language.recovery.open_blocks import Block
from language.scopes import Declared
from language.source import Lines

_NONE: Mapping[str, Declared] = MappingProxyType({})

_PROCEDURE, _COLON, _COMMA = (KIND[name] for name in ("PROCEDURE", "COLON", "COMMA"))


class Reading:
    """Made for one text, at its beginning."""

    def __init__(
        self,
        lexed: Lexed,
        first_line: int,
        colours: frozenset[str] | None,
        declared: Mapping[str, Declared] = _NONE,
    ) -> None:
        """``colours`` are the ones that the robot can see, where that is known.

        ``declared`` are the procedures that were declared before the text, by folded name.
        """
        self._lexed = lexed
        self._flaws = list(lexed.flaws)
        self.colours = colours
        self._declared = declared
        self.language = language_of(lexed.tokens, lexed.source)
        self.tokens = [*lexed.tokens, _end_token(lexed, first_line)]
        part(self.tokens, self._flaws, lexed.source, first_line)
        self.at = 0
        """The token that is read next."""
        self.begun = 0
        """The first token of the command that is read."""
        self.base = 1
        """The depth of the automaton before that command."""
        self.automaton = Automaton()
        self.blocks: list[Block] = []
        self.head: Block | None = None
        """The innermost block, while its head is read."""
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
    def is_decimal_comma(self) -> bool:
        """Whether a number that is not whole is written with a comma here: 2,5."""
        (before, _, end, *_), (comma, start, comma_end, *_), (after, begin, *_) = (
            self.before,
            self.token,
            self.following,
        )
        return (before, comma, after) == (NUMBER, _COMMA, NUMBER) and (end, comma_end) == (start, begin)

    @cached_property
    def spoken(self) -> list[str]:
        """Every language that has a keyword in the text."""
        return sorted(languages_in(self._lexed.tokens, self._lexed.source))

    @cached_property
    def procedures(self) -> dict[str, tuple[str, ...]]:
        """Of each, declared before the text or anywhere in it, the names of its values."""
        before = {
            name: tuple(each.program.typed(value.span) for value in each.procedure.parameters)
            for name, each in self._declared.items()
        }
        heads = (at + 1 for at, token in enumerate(self.tokens) if token[0] == _PROCEDURE)
        here = {self.tokens[at][5]: self._names(at + 1) for at in heads if self.tokens[at][0] == NAME}
        return before | here

    def _names(self, at: int) -> tuple[str, ...]:
        found: list[str] = []
        while self.tokens[at][0] in (_COLON, _COMMA) and self.tokens[at + 1][0] == NAME:
            found.append(self.typed(self.tokens[at + 1]))
            at += 2
        return tuple(found)

    def typed(self, token: Token) -> str:
        typed = self._lexed.source[token[1] : token[2]]
        return " ".join((typed if token[0] == STRING else without_comments(typed)).split())

    # --- moving

    def begin(self) -> None:
        """A command begins here."""
        self.base = self.automaton.settle()
        self.begun = self.at

    def go_on(self) -> None:
        """Over a token that is accepted."""
        token = self.token
        self.automaton.feed(token[0])
        self.at += 1
        if token[0] in OPENERS:
            kind = OPENERS[token[0]]
            self.head = Block(kind, token, kind, len(self.automaton.states))
            self.blocks.append(self.head)
        elif token[0] in HEAD_ENDS:
            self.head = None

    def replace(self, width: int, terminal: str) -> None:
        """Read so many tokens as one of another kind, where a mistake was told."""
        _, start, _, line, column, text = self.token
        end = self.tokens[self.at + width - 1][2]
        self.tokens[self.at : self.at + width] = [(KIND[terminal], start, end, line, column, text)]
        self._flaws = [each if each <= self.at else each - width + 1 for each in self._flaws]
        self.mark_flaw()

    # --- telling

    def mark_flaw(self) -> None:
        """What follows in this command may be wrong only because of what is here."""
        insort(self._flaws, self.at)

    def tell(
        self,
        kind: Kind,
        token: Token,
        code: str = "",
        expected: tuple[str, ...] = (),
        meant: str = "",
        details: dict[str, str | int] | None = None,
        *,
        width: int = 1,
        meant_at: int | None = None,
    ) -> None:
        """A mistake, unless it may follow from one that was told. ``width``: the words that were meant."""
        if kind is not Kind.MISSING_END and self._is_flawed():
            return
        typed = self.typed(token)
        end = self.tokens[self.at + width - 1][2] if meant and width > 1 else None
        of_meant = (code, typed, expected, meant, details or {})
        self.found.append(Diagnostic(kind, span_of(token), *of_meant, meant_end=end, meant_at=meant_at))

    def _is_flawed(self) -> bool:
        """Whether something in this command was told already."""
        index = bisect_left(self._flaws, self.begun)
        if index >= len(self._flaws) or self._flaws[index] > self.at:
            return False
        flaw = self.tokens[max(self.begun, self._flaws[index] - 1)]
        return not self.automaton.is_between_commands() or flaw[3] == self.token[3]


def _end_token(lexed: Lexed, first_line: int) -> Token:
    """Stands right behind the last thing that was written."""
    end = lexed.tokens[-1][2] if lexed.tokens else 0
    line, column = Lines(lexed.source, first_line).place(end)
    return (0, end, end, line, column, "")
