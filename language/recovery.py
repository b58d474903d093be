"""All mistakes of form in a text: one for each thing that is wrong, and none for what follows from it.

Reads the tokens as the parser does, but goes on behind a mistake. How:
1. A word that is near to one that may stand there is told, and read as if it were that word.
2. Inside the head of a block (IF to THEN) the rest of the head is skipped and the block counts as opened,
   so that its END finds it.
3. Any other command is given up, and reading goes on where the next one can begin.
4. An END that does not fit is read so that the fewest mistakes follow.
5. Nothing is told about a command in which a character could not be read; that was told already.

More than 400 lines, because all of it looks at one place in one text, and moves it.
"""

from __future__ import annotations

from bisect import bisect_left, insort
from functools import cached_property
from itertools import pairwise

from language.automaton import Automaton
from language.blocks import (
    ENDS,
    OPENERS,
    Block,
    Closing,
    best_closing,
    close,
    ends_ahead,
    kinds_of,
    mistakes_ahead,
)
from language.diagnostics import MOST_MISTAKES, Diagnostic, Kind
from language.keywords import TERMINALS as WORD_TERMINALS
from language.keywords import (
    all_words,
    argument,
    argument_words,
    folded_word,
    is_reserved,
    spelling,
)
from language.lexer import (
    DISTANCE,
    END,
    FOR,
    FRAGMENT,
    KIND,
    NAME,
    NUMBER,
    STRING,
    TAKES,
    Lexed,
    Token,
    lex,
    without_comments,
)
from language.nearby import (
    Near,
    nearest,
    nearest_keyword,
    nearest_pair,
    slips_allowed,
    slips_in,
    whole_of,
)
from language.origin import language_of, languages_in
from language.source import Lines, line_ends
from language.syntax import Span
from language.tables import TERMINALS
from language.tree import MOST_LEVELS

_ASSIGN, _LSQB, _ELSE, _SCAN, _LPAR = (KIND[name] for name in ("ASSIGN", "LSQB", "ELSE", "SCAN", "LPAR"))
_COMPARATOR, _SEMICOLON, _SIGN, _VAR = (KIND[name] for name in ("COMPARATOR", "SEMICOLON", "SIGN", "VAR"))
_HEAD_ENDS = frozenset(KIND[name] for name in ("THEN", "DO", "TIMES"))
_HEADS = {
    "IF": ("condition", "THEN"),
    "WHILE": ("condition", "DO"),
    "REPEAT": ("expression", "TIMES"),
    "PROCEDURE": ("NAME", "DO"),
    "FOR": ("beginning", "SEMICOLON", "condition", "SEMICOLON", "step", "DO"),
}
"""What stands between the opening word and the first command of a block."""
_CLASS_OF = {"DIRECTION": "direction", "AXIS": "axis", "COLOUR": "colour", "SWITCH": "on-or-off"}
_SENSORS = frozenset(KIND[name] for name in ("DISTANCE", "POS", "COLOR"))
_SIMPLE = frozenset(
    KIND[name]
    for name in (
        *("SPEAK", "FW", "BW", "TR", "TL", "WAIT", "SCAN", "STATE", "HISTORY"),
        *("SOUND", "BELT", "VIBRATE", "HELP", "QUIT", "RUN"),
    )
)
_BEGINNERS = _SIMPLE | OPENERS.keys() | ENDS.keys() | {_ELSE, END}
"""Begin a command or end a block wherever they stand."""
_COMMANDS = _BEGINNERS | _SENSORS | {NAME, _VAR, _SEMICOLON}
_BEFORE_NEW_NAME = frozenset(
    KIND[name] for name in ("VAR", "PROCEDURE", "COLON", "COMMA", "FOR", "SEMICOLON")
)
_DEEPEST = 4000
"""States of the automaton; only what is too deep anyway gets there."""


def mistakes_in(
    lexed: Lexed,
    others: tuple[Diagnostic, ...] = (),
    first_line: int = 1,
    colours: frozenset[str] | None = None,
) -> tuple[Diagnostic, ...]:
    """The mistakes in a text, together with ``others`` that are known, in the order of the text.

    ``colours`` are the ones that the robot can see, where that is known.
    """
    found = _found_in(lexed, first_line, colours)
    if lexed.open_quote is not None and len(found) > len(lexed.mistakes):
        again = _with_another_quote_open(lexed, first_line)
        found_again = _found_in(again, first_line, colours) if again else found
        found = found_again if len(found_again) <= len(found) else found
    if any(each.kind is Kind.TOO_DEEP for each in others):
        found = [each for each in found if each.kind is not Kind.TOO_DEEP]
    everything = [*others, *found]
    everything.sort(key=lambda each: each.span.start)
    return tuple(everything[:MOST_MISTAKES])


def _found_in(lexed: Lexed, first_line: int, colours: frozenset[str] | None) -> list[Diagnostic]:
    return lexed.mistakes + _Reader(lexed, first_line, colours).found()


def _with_another_quote_open(lexed: Lexed, first_line: int) -> Lexed | None:
    """The text read with the forgotten quotation mark on the first line with an odd number of them.

    Because strings may go over lines, a forgotten mark turns all later strings inside out. None if there
    is no such line.
    """
    source = lexed.source
    ends = [*line_ends(source), len(source)]
    for start, end in pairwise((0, *ends)):
        if source.count('"', start, end) % 2:
            return lex(source, first_line, source.rindex('"', start, end))
    return None


class _Reader:
    """One reading of one text."""

    def __init__(self, lexed: Lexed, first_line: int, colours: frozenset[str] | None = None) -> None:
        self._lexed = lexed
        self._colours = colours
        self._tokens = [*lexed.tokens, _end_token(lexed, first_line)]
        self._flaws = list(lexed.flaws)
        self._language = language_of(lexed.tokens, lexed.source)
        self._automaton = Automaton()
        self._blocks: list[Block] = []
        self._head: Block | None = None
        self._at = 0
        self._begun = 0
        self._base = 1
        self._found: list[Diagnostic] = []

    def found(self) -> list[Diagnostic]:
        while not self._is_at_end() and len(self._found) < MOST_MISTAKES and not self._is_too_deep():
            self._step()
        if self._is_at_end():
            self._finish()
        elif not self._found and self._is_too_deep():
            limit: dict[str, str | int] = {"limit": MOST_LEVELS}
            self._tell(Kind.TOO_DEEP, self._tokens[self._at], "expression", details=limit)
        return self._found

    def _is_at_end(self) -> bool:
        return self._tokens[self._at][0] == 0

    def _is_too_deep(self) -> bool:
        return len(self._automaton.states) > _DEEPEST

    def _step(self) -> None:
        if self._automaton.accepts(_SCAN):
            self._begin_or_go_on()
        elif self._automaton.accepts(self._tokens[self._at][0]):
            self._go_on()
        else:
            self._mistake_within()

    # --- where a command may begin -------------------------------------------------------------------

    def _begin_or_go_on(self) -> None:
        kind, following = self._tokens[self._at][0], self._tokens[self._at + 1][0]
        if kind in ENDS or kind == END:
            self._end()
        elif kind == _ELSE:
            self._else()
        elif kind == NAME and following not in (_ASSIGN, _LSQB):
            self._unknown_command()
        elif kind == FRAGMENT or (kind == FOR and self._is_misspelt_pair()):
            self._unknown_pair()
        elif not self._automaton.accepts(kind):
            self._stray()
        else:
            if kind in _COMMANDS:
                self._begin()
            self._go_on()

    def _begin(self) -> None:
        self._base = self._automaton.settle()
        self._begun = self._at

    def _go_on(self) -> None:
        token = self._tokens[self._at]
        self._automaton.feed(token[0])
        self._at += 1
        if token[0] in OPENERS:
            kind = OPENERS[token[0]]
            self._head = Block(kind, token, kind, len(self._automaton.states))
            self._blocks.append(self._head)
        elif token[0] in _HEAD_ENDS:
            self._head = None

    def _unknown_command(self) -> None:
        token = self._tokens[self._at]
        if self._follows_taker():
            self._bad_argument()
            return
        pair = self._misspelt_pair(token)
        near, width = (pair, 2) if pair else (self._command_meant(token[5]), 1)
        code = "call-brackets" if self._tokens[self._at + 1][0] == _LPAR and near is None else ""
        self._begun = self._at
        self._tell(Kind.UNKNOWN_COMMAND, token, code, ("command",), near.text if near else "")
        self._read_as(near, width)

    def _misspelt_pair(self, token: Token) -> Near | None:
        """GIRA DIREITA: both words together, where the second one alone is not the mistake."""
        following = self._tokens[self._at + 1]
        if following[0] != NAME or following[3] != token[3]:
            return None
        return nearest_pair(token[5], following[5], self._automaton.acceptable())

    def _command_meant(self, typed: str) -> Near | None:
        """The nearest word that leaves all ENDs what they are, or else the nearest one."""
        words = self._automaton.acceptable()
        whole = whole_of(typed, words)
        if whole:
            return whole
        fitting = frozenset(word for word in words if self._can_open(word, 1))
        near = nearest_keyword(typed, fitting, self._language)
        return near or nearest_keyword(typed, words, self._language)

    def _unknown_pair(self) -> None:
        """RIGHT without TURN, GIRAR DIRETA, PARA FRENT."""
        token = self._tokens[self._at]
        near, width = self._pair_meant()
        self._begun = self._at
        following = self._tokens[self._at + width]
        if following[0] == _ASSIGN:
            self._tell(Kind.RESERVED_WORD, token, details={"name": self._typed(token)})
            near = None
        else:
            self._tell(Kind.UNKNOWN_COMMAND, token, "", ("command",), near.text if near else "")
        self._read_as(near, width)

    def _read_as(self, near: Near | None, width: int) -> None:
        """Go on as if the meant word stood there, or else behind the command."""
        if near is None or near.complete or not self._can_open(near.terminal, width):
            self._at += width
            self._skip_command(may_open=near is None)
            return
        _, start, _, line, column, text = self._tokens[self._at]
        end = self._tokens[self._at + width - 1][2]
        self._tokens[self._at : self._at + width] = [(KIND[near.terminal], start, end, line, column, text)]
        self._flaws = [each if each <= self._at else each - width + 1 for each in self._flaws]
        insort(self._flaws, self._at)

    def _can_open(self, terminal: str, width: int) -> bool:
        """Whether a word of so many tokens opens no block, or one that has its END further on."""
        if KIND[terminal] not in OPENERS:
            return True
        kinds, ahead = kinds_of(self._blocks), ends_ahead(self._tokens[self._at + width :])
        return mistakes_ahead([*kinds, terminal], ahead) <= mistakes_ahead(kinds, ahead)

    def _is_misspelt_pair(self) -> bool:
        third = self._tokens[min(self._at + 2, len(self._tokens) - 1)][0]
        return third != _ASSIGN and self._pair_meant()[1] == 2

    def _pair_meant(self) -> tuple[Near | None, int]:
        """The keyword of two words that is meant here, and how many tokens were meant for it."""
        token, following = self._tokens[self._at : self._at + 2]
        pairs = [each for each in all_words() if folded_word(each).startswith(f"{token[5]} ")]
        if following[0] in (NAME, FRAGMENT) and following[3] == token[3]:
            pair = nearest(f"{token[5]} {following[5]}", pairs)
            if pair and slips_in(following[5], folded_word(pair).split()[1]) <= slips_allowed(
                len(following[5])
            ):
                return Near(pair, WORD_TERMINALS[folded_word(pair)]), 2
        if token[0] != FRAGMENT:
            return None, 1
        return Near(pairs[0], WORD_TERMINALS[folded_word(pairs[0])]), 1

    def _stray(self) -> None:
        """Something that no command begins with, and with which the one before can't go on."""
        token, before = self._tokens[self._at], self._tokens[self._at - 1]
        if self._follows_taker() and token[0] in (NUMBER, STRING):
            self._bad_argument()
            return
        if token[0] == _ASSIGN and self._is_assigned_to_keyword(before):
            self._tell(Kind.RESERVED_WORD, before, details={"name": self._typed(before)})
        elif self._tokens[self._at + 1][0] == _ASSIGN and is_reserved(token[5]):
            self._tell(Kind.RESERVED_WORD, token, details={"name": self._typed(token)})
        else:
            code = "text-plus" if before[0] == STRING and token[0] == _SIGN else ""
            self._tell(Kind.SYNTAX, token, code, self._automaton.expected())
        self._at += 1
        self._skip_command()

    # --- ends ----------------------------------------------------------------------------------------

    def _end(self) -> None:
        token = self._tokens[self._at]
        end, meant, width = ENDS.get(token[0], ""), "", 1
        if token[0] == END:
            end, meant, width = self._end_meant()
        self._begun = self._at
        rest = self._tokens[self._at + width :]
        if not self._blocks:
            self._tell(Kind.WRONG_END, token, "stray-end", ("command",))
            closing = Closing.STRAY
        elif token[0] != END and self._blocks[-1].kind in (end, ""):
            closing = Closing.INNERMOST
        else:
            self._tell_wrong_end(token, meant)
            closing = best_closing(kinds_of(self._blocks), end, rest)
            if token[0] == END and closing is Closing.STRAY:
                closing = Closing.INNERMOST
        for read_as in close(self._blocks, end, closing):
            self._feed_end(read_as)
        self._at += width
        if token[0] == END:
            self._skip_rest_of_line(token[3])

    def _end_meant(self) -> tuple[str, str, int]:
        """For an END without its word: the block that is meant, the words for it, how many were written."""
        near, width = self._pair_meant()
        if near and width == 2:
            return near.terminal.removeprefix("END_"), near.text, 2
        opener = OPENERS.get(self._tokens[self._at + 1][0])
        if opener and self._blocks and opener == self._blocks[-1].kind:
            return opener, spelling(f"END {opener}", self._language), 2
        return "", "", 1

    def _tell_wrong_end(self, token: Token, meant: str) -> None:
        block = self._blocks[-1]
        if not block.kind:
            return
        details: dict[str, str | int] = {"opener": block.kind, "opener_line": block.token[3]}
        self._tell(Kind.WRONG_END, token, "", (f"END {block.kind}",), meant, details)

    def _feed_end(self, read_as: str) -> None:
        if read_as:
            self._automaton.feed(KIND[f"END_{read_as}"])

    def _else(self) -> None:
        if self._automaton.accepts(_ELSE) and self._blocks[-1].kind == "IF":
            self._begin()
            self._go_on()
            return
        self._begun = self._at
        self._tell(Kind.SYNTAX, self._tokens[self._at], "stray-else", self._automaton.expected())
        kinds = kinds_of(self._blocks)
        ahead = ends_ahead(self._tokens[self._at :])
        outer = kinds[: len(kinds) - kinds[::-1].index("IF")] if "IF" in kinds else kinds
        if len(outer) < len(kinds) and mistakes_ahead(outer, ahead) < mistakes_ahead(kinds, ahead):
            while len(self._blocks) > len(outer):
                self._feed_end(self._blocks.pop().read_as)
            if self._automaton.accepts(_ELSE):
                self._automaton.feed(_ELSE)
        self._at += 1

    # --- within a command ----------------------------------------------------------------------------

    def _mistake_within(self) -> None:
        token, before = self._tokens[self._at], self._tokens[self._at - 1]
        if before[0] in TAKES and self._automaton.accepts(KIND[TAKES[before[0]]]):
            if token[0] in (NAME, NUMBER, STRING):
                self._bad_argument()
                return
            if before[0] != DISTANCE:
                self._missing_argument()
                return
        if self._is_reserved_as_name():
            self._tell(Kind.RESERVED_WORD, token, details={"name": self._typed(token)})
            self._automaton.feed(NAME)
            self._at += 1
        elif token[0] == _ASSIGN and self._is_assigned_to_keyword(before):
            self._tell(Kind.RESERVED_WORD, before, details={"name": self._typed(before)})
            self._give_up()
        elif token[0] == _ASSIGN and self._automaton.accepts(_COMPARATOR):
            self._equals_sign(token)
        else:
            self._unexpected(token)

    def _equals_sign(self, token: Token) -> None:
        """A comparison written with one equals sign, or as it is spoken: ``=>`` for greater or equal."""
        _, start, end, line, column, text = token
        following = self._tokens[self._at + 1]
        is_turned = following[1] == end and following[5] in ("<", ">")
        if is_turned:
            token = (_ASSIGN, start, following[2], line, column, text + following[5])
        meant = f"{following[5]}=" if is_turned else "=="
        self._tell(Kind.SYNTAX, token, "single-equals", ("comparison",), meant)
        insort(self._flaws, self._at)
        self._automaton.feed(_COMPARATOR)
        self._at += 2 if is_turned else 1

    def _is_assigned_to_keyword(self, before: Token) -> bool:
        wants_name = before[0] in _BEFORE_NEW_NAME
        return self._at - 1 == self._begun and is_reserved(before[5]) and not wants_name

    def _unexpected(self, token: Token) -> None:
        expected = self._automaton.expected()
        near = None
        if token[0] in (NAME, FRAGMENT):
            near = nearest_keyword(token[5], self._automaton.acceptable(), self._language)
        self._tell(Kind.SYNTAX, token, "", expected, near.text if near else "")
        if near and not near.complete:
            self._read_as(near, 1)
        else:
            self._give_up()

    def _is_reserved_as_name(self) -> bool:
        """Whether a keyword stands where a new name should, and what follows would fit the name."""
        token, before, following = (
            self._tokens[self._at],
            self._tokens[self._at - 1],
            self._tokens[self._at + 1],
        )
        if before[0] not in _BEFORE_NEW_NAME or not is_reserved(token[5]):
            return False
        if not self._automaton.accepts(NAME) or self._automaton.accepts(NUMBER):
            return False
        if following[0] == _ASSIGN:
            return True
        beyond = Automaton()
        beyond.states = list(self._automaton.states)
        beyond.feed(NAME)
        return before[3] == token[3] and beyond.accepts(following[0])

    def _follows_taker(self) -> bool:
        """Whether the word before wants one like this one, on the same line."""
        before = self._tokens[self._at - 1] if self._at > self._begun else None
        return before is not None and before[0] in TAKES and before[3] == self._tokens[self._at][3]

    def _bad_argument(self) -> None:
        """Also one that was taken for a name, because an equals sign follows it: that is no mistake yet."""
        token, taker = self._tokens[self._at], self._tokens[self._at - 1]
        if argument(TAKES[taker[0]], token[5]) is None:
            self._tell_argument(token, taker, "")
        wanted = KIND[TAKES[taker[0]]]
        if self._automaton.accepts(wanted):
            self._automaton.feed(wanted)
        self._at += 1

    def _missing_argument(self) -> None:
        taker = self._tokens[self._at - 1]
        self._tell_argument(taker, taker, "missing-argument")
        self._automaton.feed(KIND[TAKES[taker[0]]])
        insort(self._flaws, self._at)

    def _tell_argument(self, token: Token, taker: Token, code: str) -> None:
        terminal = TAKES[taker[0]]
        details: dict[str, str | int] = {"word": TERMINALS[taker[0]]}
        if terminal == "COLOUR" and self._colours is not None:
            details["wanted"] = ", ".join(sorted(self._colours))
        meant = "" if code else self._argument_meant(token, terminal)
        self._tell(Kind.BAD_ARGUMENT, token, code, (_CLASS_OF[terminal],), meant, details)

    def _argument_meant(self, token: Token, terminal: str) -> str:
        if len(token[5]) <= 2:
            return ""
        preferred = argument_words(terminal, self._language)
        words = [word for language in self._spoken for word in argument_words(terminal, language)]
        return nearest(token[5], words, preferred) or ""

    @cached_property
    def _spoken(self) -> list[str]:
        return sorted(languages_in(self._lexed.tokens, self._lexed.source))

    # --- going on ------------------------------------------------------------------------------------

    def _give_up(self) -> None:
        if self._head is not None:
            self._skip_head(self._head)
            return
        token = self._tokens[self._at]
        is_in_place_of_operand = self._automaton.accepts(NUMBER) and token[3] == self._tokens[self._begun][3]
        if is_in_place_of_operand and token[0] in _SIMPLE:
            self._at += 1
        self._automaton.cut(self._base)
        self._skip_command()

    def _skip_command(self, may_open: bool = False) -> None:
        """To where the next command may begin. The end of a head opens a block that nobody knows."""
        while not self._may_begin_command():
            token = self._tokens[self._at]
            self._at += 1
            if may_open and token[0] in _HEAD_ENDS:
                self._blocks.append(Block("", token, "", 0))
                return

    def _may_begin_command(self) -> bool:
        kind = self._tokens[self._at][0]
        if kind in _BEGINNERS or kind in (_VAR, _SEMICOLON, 0):
            return True
        if kind == NAME and self._tokens[self._at + 1][0] in (_ASSIGN, _LSQB):
            return True
        is_first = self._at == 0 or self._tokens[self._at - 1][3] != self._tokens[self._at][3]
        return is_first and (kind in (NAME, FRAGMENT) or kind in _SENSORS)

    def _skip_head(self, head: Block) -> None:
        """To the first command of the block, which counts as opened."""
        if not self._is_head_ahead(head):
            while not self._is_behind_head(head):
                self._at += 1
        if self._tokens[self._at][0] in _HEAD_ENDS:
            self._at += 1
        self._automaton.cut(head.depth)
        self._automaton.move(_HEADS[head.read_as])
        self._head = None

    def _is_behind_head(self, head: Block) -> bool:
        kind = self._tokens[self._at][0]
        if kind in _BEGINNERS or kind in _HEAD_ENDS or kind == 0:
            return True
        is_first = self._tokens[self._at - 1][3] != self._tokens[self._at][3]
        begins = kind == _VAR or (kind == NAME and self._tokens[self._at + 1][0] in (_ASSIGN, _LSQB))
        return is_first and begins and head.kind != "FOR"

    def _is_head_ahead(self, head: Block) -> bool:
        """If a command stands in the head by mistake, move to the end of the head on the same line."""
        line = self._tokens[self._at][3]
        for at in range(self._at + 1, len(self._tokens)):
            kind = self._tokens[at][0]
            if kind == KIND[_HEADS[head.read_as][-1]] and self._tokens[at][3] == line:
                self._at = at
                return True
            if kind in _BEGINNERS or self._tokens[at][3] != line:
                break
        return False

    def _skip_rest_of_line(self, line: int) -> None:
        """The word of an END that nobody knows."""
        while self._tokens[self._at][3] == line and not self._may_begin_command():
            self._at += 1

    def _finish(self) -> None:
        if not self._automaton.accepts(_SCAN):
            self._tell_incomplete()
            if self._head is not None:
                self._blocks.pop()
        for block in self._blocks:
            if block.kind:
                details: dict[str, str | int] = {"opener": block.kind, "opener_line": block.token[3]}
                self._begun = self._at
                self._tell(Kind.MISSING_END, block.token, "", (f"END {block.kind}",), details=details)

    def _tell_incomplete(self) -> None:
        before = self._tokens[self._at - 1]
        if before[0] in TAKES and before[0] != DISTANCE:
            self._tell_argument(before, before, "missing-argument")
        else:
            self._tell(Kind.SYNTAX, self._tokens[self._at], "", self._automaton.expected())

    # --- telling -------------------------------------------------------------------------------------

    def _tell(
        self,
        kind: Kind,
        token: Token,
        code: str = "",
        expected: tuple[str, ...] = (),
        meant: str = "",
        details: dict[str, str | int] | None = None,
    ) -> None:
        if self._is_flawed() and kind is not Kind.MISSING_END:
            return
        _, start, end, line, column, _ = token
        span = Span(start, end, line, column)
        self._found.append(Diagnostic(kind, span, code, self._typed(token), expected, meant, details or {}))

    def _is_flawed(self) -> bool:
        """Whether something in this command was told already."""
        index = bisect_left(self._flaws, self._begun)
        if index >= len(self._flaws) or self._flaws[index] > self._at:
            return False
        is_complete = self._automaton.accepts(_SCAN)
        flaw = self._tokens[max(self._begun, self._flaws[index] - 1)]
        return not is_complete or flaw[3] == self._tokens[self._at][3]

    def _typed(self, token: Token) -> str:
        typed = self._lexed.source[token[1] : token[2]]
        return " ".join((typed if token[0] == STRING else without_comments(typed)).split())


def _end_token(lexed: Lexed, first_line: int) -> Token:
    """Stands right behind the last thing that was written."""
    end = lexed.tokens[-1][2] if lexed.tokens else 0
    line, column = Lines(lexed.source, first_line).place(end)
    return (0, end, end, line, column, "")
