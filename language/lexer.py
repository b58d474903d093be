"""Text to tokens: canonical terminals with their places in the learner's text.

Rule: no character is lost. A character that can't be read becomes a mistake, and its place among the tokens
is kept, so that recovery reports none of its consequences.

A token is a plain tuple, because a program has many: kind, start, end, line, column, folded text.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from functools import cache
from itertools import pairwise
from typing import TypeAlias
from unicodedata import combining, normalize

from msgspec import Struct, field

from language.diagnostics import Diagnostic, MistakeKind
from language.keywords import (
    ALSO_NAMES,
    ARGUMENTS,
    END_WORDS,
    FIRST_OF_SEVERAL,
    TERMINAL_OF_WORD,
    argument,
    languages_by_accents,
    languages_of,
    languages_of_colour,
)
from language.locales import languages
from language.source import COMMENT_MARK, DASHES, MARK, UNSEEN, column, fold, line_breaks, widthless
from language.syntax import Span
from language.tables import NONTERMINALS, RULES, TERMINALS

Token: TypeAlias = tuple[int, int, int, int, int, str]

KIND = {name: number for number, name in enumerate(TERMINALS)}
NAME, NUMBER, STRING, HELP, TOPIC = (KIND[name] for name in ("NAME", "NUMBER", "STRING", "HELP", "TOPIC"))
FOR, END, FRAGMENT = (KIND[name] for name in ("FOR", "END", "FRAGMENT"))

MOST_DIGITS = 4300
"""Of a number."""

_forms: list[tuple[str, tuple[str, ...]]] = [(NONTERMINALS[rule], parts) for rule, _, _, parts in RULES]

SENSOR_FORMS = tuple(parts for rule, parts in _forms if rule == "sensor")
"""Each sensor as its terminals: DISTANCE alone, DISTANCE with DIRECTION, POS with AXIS."""
SENSORS = frozenset(parts[0] for parts in SENSOR_FORMS)
NEEDS_NO_ARGUMENT = frozenset(KIND[parts[0]] for parts in SENSOR_FORMS if len(parts) == 1)

TAKES = {
    KIND[parts[0]]: parts[1]
    for _, parts in _forms
    if len(parts) == 2 and parts[1] in {each.terminal for each in ARGUMENTS}
}
"""The keywords that decide what the next word is."""

TAKE_EXPRESSION = tuple(
    parts[0] for rule, parts in _forms if rule == "statement" and parts[1:] == ("expression",)
)
"""The commands that are one word and a value: FW, TR, WAIT, SPEAK."""
COMPLETE_ALONE = frozenset(
    KIND[parts[0]]
    for rule, parts in _forms
    if rule == "statement" and len(parts) == 1 and parts[0] in KIND and parts[0] not in SENSORS
)
"""The commands that are complete without an argument, those of sensors apart: SCAN, HELP."""
_MAY_BE_ALONE = frozenset(KIND[parts[0]] for _, parts in _forms if len(parts) == 1 and parts[0] in KIND)

_BEFORE_NAMES = frozenset(
    KIND[first]
    for _, parts in _forms
    for first, second in pairwise(parts)
    if first in KIND and first != "SEMICOLON" and second in ("NAME", *NONTERMINALS) and second != "statements"
)
"""The terminals after which no command begins; a semicolon stands before a command or before a condition."""

_FIRST_THAT_DECIDES = FOR
_OVERLAY = 1
"""The combining class of strokes through a sign."""
_BLANK, _NEWLINE, _TEXT, _COMMENT, _OPEN, _STRANGE, _ALSO_NAME = range(-7, 0)

_SIGNS = {
    "=": "ASSIGN",
    **dict.fromkeys(("==", "<>", "<", ">", "<=", ">="), "COMPARATOR"),
    **dict.fromkeys("+-", "SIGN"),
    **dict.fromkeys("*/", "SCALE"),
    **{"(": "LPAR", ")": "RPAR", "[": "LSQB", "]": "RSQB", ",": "COMMA", ":": "COLON", ";": "SEMICOLON"},
}
_OPPOSITES = {"=": "<>", "==": "<>", "<": ">=", ">": "<=", "<=": ">", ">=": "<"}
_WRITTEN_AS = {
    **dict.fromkeys("\u2264\u2266\u2a7d", "<="),
    **dict.fromkeys("\u2265\u2267\u2a7e", ">="),
    **dict.fromkeys("\u00d7\u2715\u00b7\u22c5", "*"),
    **dict.fromkeys("\u00f7\u2044\u2215", "/"),
    "\u2261": "==",
    **dict.fromkeys(("!=", "!=="), "<>"),
}
"""Signs of mathematics and of other programming languages, and how GoDonnie writes them."""

_MARKED_SIGN = rf"(?:[=<>]=|<>|[=<>+\-*/()\[\],:;]){MARK}+"
"""A sign with a loose mark is another sign: = with a stroke through it means different."""

_OTHER_COMMENT_MARKS = ("//", "#")
"""What begins a comment in other programming languages: first in its line, or between two blanks."""
_OTHER_COMMENT = r"(?:(?<![^\r\n])(?://|#)|(?<=\s)(?://|#)(?!\S))[^\r\n]*"

_QUOTES = "\u201c\u201d\u201e\u201f"
_OTHER_STRINGS = rf"|[{_QUOTES}][^{_QUOTES}]*[{_QUOTES}]|\u2018[^\u2018\u2019\r\n]*\u2019|«[^«»\r\n]*»"
_WHOLE_COMMENT = COMMENT_MARK + r"[^\r\n]*"
_BETWEEN = rf"(?:\s|{_WHOLE_COMMENT}+)*+"
"""Possessive: a comment full of hyphens could otherwise be split into comments in millions of ways."""
_ASSIGNMENT_OR_CALL = rf"{_BETWEEN}(?:=(?!=)|\[)"
_AFTER_NAME = rf"{_BETWEEN}[=\[<>+*/-]"
"""What follows a name, and never a command without an argument."""

_single = {word: KIND[terminal] for word, terminal in TERMINAL_OF_WORD.items() if " " not in word}
_also_names = {word: _ALSO_NAME for word in _single if TERMINAL_OF_WORD[word] in ALSO_NAMES}
_fragments = {
    word: END if word in END_WORDS else FRAGMENT for word in FIRST_OF_SEVERAL if word not in _single
}
_pairs = {tuple(word.split()): KIND[terminal] for word, terminal in TERMINAL_OF_WORD.items() if " " in word}
_known = {
    " ": _BLANK,
    UNSEEN: _BLANK,
    **dict.fromkeys(("\n", "\r\n", "\r"), _NEWLINE),
    **{sign: KIND[terminal] for sign, terminal in _SIGNS.items()},
    **_single,
    **_also_names,
    **_fragments,
}


@cache
def _pieces(is_ascii: bool) -> re.Pattern[str]:
    """A simpler expression for ASCII texts: to compile the other one takes three times as long."""
    letter = r"\w" if is_ascii else rf"[\w{MARK}]"
    dashes = "--" if is_ascii else f"(?:--|[{DASHES}])"
    others = "" if is_ascii else _OTHER_STRINGS
    marked = "" if is_ascii else f"{_MARKED_SIGN}|"
    return re.compile(
        rf" +|{marked}{letter}+|\r\n?|\n|==|<>|<=|>=|{dashes}[^\r\n]*|{_OTHER_COMMENT}"
        rf"|\"[^\"]*\"|[^\S\r\n]+|'[^'\r\n]*'{others}|!==?|.",
        re.DOTALL | (re.ASCII if is_ascii else 0),
    )


class Comment(Struct, frozen=True):
    start: int
    end: int
    line: int
    before: int
    """The index of the next token; in a keyword of two words, of the token after the keyword."""


class Lexed(Struct, frozen=True):
    """All parts of a text except white space."""

    source: str
    tokens: list[Token]
    comments: list[Comment] = field(default_factory=list)
    mistakes: list[Diagnostic] = field(default_factory=list)
    flaws: list[int] = field(default_factory=list)
    """For each mistake that spoils a command, the index of its token or of the next one."""
    colours: list[Token] = field(default_factory=list)
    """The tokens that are colours."""
    open_quote: int | None = None
    """The start of a string that has no end."""
    first_line: int = 1
    """The number of the first line."""


def lex(source: str, first_line: int = 1, blamed_quote: int | None = None) -> Lexed:
    """Every token of a text.

    A string without an end ends with its line. ``blamed_quote`` is the offset of a quotation mark that begins
    such a string, whatever follows.
    """
    lexer = _Lexer(source, first_line)
    if blamed_quote is not None:
        lexer.read(0, blamed_quote)
        lexer.open_string(blamed_quote)
    lexer.read(lexer.position, len(source))
    return lexer.lexed()


def span_of(token: Token) -> Span:
    _, start, end, line, start_column, _ = token
    return Span(start, end, line, start_column)


def without_comments(text: str) -> str:
    """A text that has no strings, without its comments."""
    return re.sub(_WHOLE_COMMENT, "", text)


# --- languages -----------------------------------------------------------------------------------------


def languages_in(tokens: Iterable[Token], source: str = "") -> frozenset[str]:
    """The result of ``language_of``, and each language of a keyword that belongs to one language only."""
    tokens = tuple(tokens)
    found = [languages_of(token[5]) for token in tokens if token[5][:1].isalpha()]
    only = [possible for possible in found if len(possible) == 1]
    return frozenset({language_of(tokens, source)}).union(*only)


def language_of(tokens: Iterable[Token], source: str = "") -> str:
    """The language of most keywords that do not belong to all languages; English if there are none.

    The accents in ``source``, if given, and the words of colours decide between languages with as many
    keywords: DISTÂNCIA is Portuguese, DISTANCIA and COLOR azul are Spanish. Only words that languages write
    differently count. So a program whose other words were written anew, such as by the formatter, stays in
    its language.
    """
    tokens = [token for token in tokens if token[5][:1].isalpha()]
    votes = {language: [0, 0] for language in languages()}
    for word, count in Counter(token[5] for token in tokens).items():
        for language in languages_of(word):  # a word of all languages counts alike for each
            votes[language][0] += count
    for token in tokens if source else ():
        typed = source[token[1] : token[2]]
        for language in languages_by_accents(token[5], typed) or languages_of_colour(token[5]):
            votes[language][1] += 1
    return max(votes, key=votes.__getitem__)


class _Lexer:
    """One pass over one text."""

    def __init__(self, source: str, first_line: int) -> None:
        self._source = source
        self._folded = fold(source)
        self._widthless = widthless(self._folded)
        self._first_line = self._line = first_line
        self._margin = -1
        self._tokens: list[Token] = []
        self._comments: list[Comment] = []
        self._flaws: list[tuple[MistakeKind, int, int, int, int, int | None]] = []
        """The last of each is as in ``Lexed.flaws``, None for a mistake that spoils no command."""
        self._colours: list[int] = []
        self._open_quote: int | None = None
        self.position = 0

    def read(self, start: int, stop: int) -> None:
        """Read from ``start`` to ``stop``. One long loop, because it handles every piece of a program."""
        folded, tokens = self._folded, self._tokens
        find = _pieces(folded.isascii()).findall
        known = dict(_known)
        line, margin, position = self._line, self._margin, start
        last = tokens[-1][0] if tokens else 0
        for piece in find(folded, start, stop):
            kind = known.get(piece)
            if kind is None:
                kind = self._classified(piece, known)
            if kind >= 0:
                end = position + len(piece)
                token = (kind, position, end, line, position - margin, piece)
                if last >= _FIRST_THAT_DECIDES:
                    token = self._decided(token)
                tokens.append(token)
                last = token[0]
                position = end
            elif kind == _BLANK:
                position += len(piece)
            elif kind == _NEWLINE:
                position += len(piece)
                line += 1
                margin = position - 1
            else:
                self._line, self._margin = line, margin
                self._rare(kind, piece, position)
                line, margin, position = self._line, self._margin, self.position
                last = tokens[-1][0] if tokens else 0
                if kind == _OPEN:
                    break
        self._line, self._margin, self.position = line, margin, position
        if position < stop:
            self.read(position, stop)

    def _classified(self, piece: str, known: dict[str, int]) -> int:
        first = piece[0]
        if first.isalpha():
            kind = known.get(piece.replace(MARK, ""), NAME)
        elif first.isascii() and (first.isdigit() or first == "_"):
            return NUMBER if piece.isdigit() and piece.isascii() and len(piece) <= MOST_DIGITS else _STRANGE
        elif first == '"' or first in _QUOTES:
            return _TEXT if len(piece) > 1 else _OPEN
        elif piece[:2] == "--" or first in DASHES:
            return _COMMENT
        else:
            kind = _BLANK if piece.isspace() else _STRANGE
        known[piece] = kind
        return kind

    def _decided(self, token: Token) -> Token:
        """The token as the keyword before it requires; a second word of a keyword replaces the first."""
        before = self._tokens[-1]
        kind, start, end, line, start_column, folded = token
        text = folded.replace(MARK, "")
        terminal = TAKES.get(before[0])
        if terminal is not None:
            if kind == NAME and self._is_argument(before[0], terminal, text, end):
                if terminal == "COLOUR":
                    self._colours.append(len(self._tokens))
                return (KIND[terminal], start, end, line, start_column, text)
        elif before[0] == HELP:
            if before[3] == line and text[0].isalpha() and not self._is_target(end):
                return (TOPIC, start, end, line, start_column, text)
        elif self._is_pair(before, token, text):
            del self._tokens[-1]
            kind = TOPIC if before[0] == TOPIC else _pairs[before[5], text]
            return (kind, before[1], end, before[3], before[4], f"{before[5]} {text}")
        return token

    def _is_argument(self, taker: int, terminal: str, text: str, end: int) -> bool:
        if argument(terminal, text) is None:
            return False
        return not (taker in _MAY_BE_ALONE and self._is_target(end))

    def _is_pair(self, before: Token, token: Token, text: str) -> bool:
        if (before[5], text) not in _pairs:
            return False
        between = without_comments(self._folded[before[2] : token[1]])
        if not between.replace(UNSEEN, " ").isspace():
            return False
        if before[0] == TOPIC and before[3] != token[3]:
            return False
        return before[0] == END or not self._is_target(token[2])

    def _is_target(self, end: int) -> bool:
        """Whether an assignment or a call follows the word that ends there."""
        return re.compile(_ASSIGNMENT_OR_CALL).match(self._folded, end) is not None

    def _rare(self, kind: int, piece: str, start: int) -> None:
        self.position = end = start + len(piece)
        if kind == _TEXT:
            self._tokens.append(self._token(STRING, start, end))
            self._skip_lines(start, end)
        elif kind == _COMMENT:
            self._comments.append(Comment(start, end, self._line, len(self._tokens)))
        elif kind == _OPEN:
            self.open_string(start)
        elif kind == _ALSO_NAME:
            self._tokens.append(self._command_or_name(piece, start, end))
        elif piece[0].isascii() and (piece[0].isdigit() or piece[0] == "_"):
            self._unreadable_word(piece, start, end)
        elif piece.startswith(_OTHER_COMMENT_MARKS) and re.compile(_OTHER_COMMENT).match(self._folded, start):
            mark_end = start + (2 if piece[0] == "/" else 1)
            place = (self._line, start - self._margin, None)
            self._flaws.append((MistakeKind.UNKNOWN_CHARACTER, start, mark_end, *place))
        else:
            self._flaw(MistakeKind.UNKNOWN_CHARACTER, start, end)
            if piece[0] == "!" and len(piece) > 1:  # the rest is read as the sign that it is
                self._tokens.append(self._token(_known[piece[1:]], start + 1, end))
            elif len(piece) > 1 and not piece.endswith(MARK):
                self._tokens.append(self._token(STRING, start, end))

    def _command_or_name(self, piece: str, start: int, end: int) -> Token:
        """A word that is a command only where one may begin and nothing follows that makes it a name."""
        before = self._tokens[-1][0] if self._tokens else 0
        is_name = before in _BEFORE_NAMES or re.compile(_AFTER_NAME).match(self._folded, end) is not None
        kind = NAME if is_name else _single[piece.replace(MARK, "")]
        token = (kind, start, end, self._line, start - self._margin, piece)
        return self._decided(token) if before >= _FIRST_THAT_DECIDES else token

    def _token(self, kind: int, start: int, end: int) -> Token:
        return (kind, start, end, self._line, start - self._margin, self._folded[start:end])

    def _skip_lines(self, start: int, end: int) -> None:
        ends = line_breaks(self._folded[start:end])
        if ends:
            self._line += len(ends)
            self._margin = start + ends[-1] - 1

    def _unreadable_word(self, piece: str, start: int, end: int) -> None:
        too_large = piece.isdigit() and piece.isascii()
        if too_large and len(piece.lstrip("0")) <= MOST_DIGITS:
            self._tokens.append(self._token(NUMBER, start, end))
            return
        self._flaw(MistakeKind.NUMBER_TOO_LARGE if too_large else MistakeKind.INVALID_NAME, start, end)
        self._tokens.append(self._token(NUMBER if too_large else NAME, start, end))

    def open_string(self, start: int) -> None:
        """Read a string that begins there and ends with its line."""
        line_end = next(iter(re.compile(r"[\r\n]|\Z").finditer(self._folded, start)))
        self._open_quote = start
        self.position = line_end.start()
        self._flaw(MistakeKind.UNTERMINATED_STRING, start, self.position)
        self._tokens.append(self._token(STRING, start, self.position))

    def _flaw(self, kind: MistakeKind, start: int, end: int) -> None:
        """Add a mistake. Adjacent characters that can't be read are one mistake."""
        index = len(self._tokens)
        if self._flaws and kind is MistakeKind.UNKNOWN_CHARACTER:
            last = self._flaws[-1]
            if last[0] is kind and last[2] == start:
                self._flaws[-1] = (kind, last[1], end, *last[3:])
                return
        self._flaws.append((kind, start, end, self._line, start - self._margin, index))

    def lexed(self) -> Lexed:
        tokens = self._tokens
        if self._widthless:
            tokens = [self._seen(token) for token in tokens]
        return Lexed(
            self._source,
            tokens,
            self._comments,
            [self._diagnostic(*flaw[:-1]) for flaw in self._flaws],
            [index for *_, index in self._flaws if index is not None],
            [tokens[index] for index in self._colours],
            self._open_quote,
            self._first_line,
        )

    def _seen(self, token: Token) -> Token:
        """The token with its column counted in visible characters, and a name without loose accents."""
        kind, start, end, line, offset, text = token
        seen = column(start - offset + 1, start, self._widthless)
        return (kind, start, end, line, seen, text if kind == STRING else text.replace(MARK, ""))

    def _diagnostic(self, kind: MistakeKind, start: int, end: int, line: int, offset: int) -> Diagnostic:
        seen = column(start - offset + 1, start, self._widthless)
        limit = {"limit": MOST_DIGITS} if kind is MistakeKind.NUMBER_TOO_LARGE else {}
        found = self._source[start:end]
        meant = _sign_meant(found) if kind is MistakeKind.UNKNOWN_CHARACTER else ""
        around = self._source[max(0, start - 1) : start] + self._source[end : end + 1]
        if meant.startswith('"') and re.search(r"\w", around):
            meant = ""  # apostrophes within words: l'eau d'ici
        if kind is MistakeKind.INVALID_NAME:
            digits = len(found) - len(found.lstrip("0123456789"))
            is_word = self._folded[start + digits : end] in _single
            meant = f"{found[:digits]} {found[digits:]}" if digits and is_word else ""
        return Diagnostic(kind, Span(start, end, line, seen), found=found, meant=meant, details=limit)


def _sign_meant(found: str) -> str:
    """How GoDonnie writes a sign of another alphabet or of mathematics, or a text in other quotation marks.

    Empty for anything else. A stroke through a sign of comparison makes it the opposite.
    """
    if found in _OTHER_COMMENT_MARKS:
        return "--"
    text = re.fullmatch(r"['\u2018«]([^'\u2018\u2019«»\"]*)['\u2019»]", found)
    if text:
        return f'"{text[1]}"'
    decomposed = normalize("NFD", found)
    marks = "".join(filter(combining, decomposed))
    base = decomposed.removesuffix(marks)
    plain = _WRITTEN_AS.get(base) or normalize("NFKC", base)
    if not marks:
        return plain if plain in _SIGNS else ""
    is_struck = len(marks) == 1 and combining(marks) == _OVERLAY
    return _OPPOSITES.get(plain, "") if is_struck else ""
