"""What may continue a program at the cursor: words that the grammar allows, and the next line.

Inside a block its END comes first. QUIT is never offered, since it ends the lesson.
After the first line of a block the next one is indented, and the END is there already.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from itertools import chain
from typing import TypeAlias

import msgspec

from donnie_tui.core.program_text import LONGEST_CHECKED, ProgramText
from language import keywords
from language.keywords import TERMINAL_OF_WORD, WORDS, folded_word
from language.lexer import FRAGMENT, HELP, KIND, NAME, NUMBER, TAKES, Token, lex
from language.outline import ENDS, INDENT, open_block, outline
from language.parser import kinds_after
from language.source import fold_name

MOST_WORDS = 50
"""Suggestions; more are too many to listen to."""

USUAL_NUMBERS = ("1", "2", "3", "4", "5", "10", "45", "90")
"""Of steps, rounds and degrees."""
USUAL_DEGREES = ("90", "45", "180", "30", "60", "120")
"""Of a turn."""
_SIGNS = {
    "COMPARATOR": ("==", "<", ">", "<=", ">=", "<>"),
    "ASSIGN": ("=",),
    "LSQB": ("[",),
    "COLON": (":",),
}
"""Signs that continue a command, by their terminals."""
_SEPARATOR = KIND["SEMICOLON"]
"""The last of a list: few write it between two commands. In the first line of FOR it is alone there."""
_TURNS = (KIND["TR"], KIND["TL"])
_COUNTED = frozenset(
    KIND[each] for each in ("FW", "BW", "TR", "TL", "WAIT", "REPEAT", "COMPARATOR", "LSQB", "SIGN", "SCALE")
)
"""Kinds of tokens that a number follows more often than a word."""

_FIRST = (
    *("FW", "TR", "TL", "BW", "SPEAK", "REPEAT", "IF", "VAR", "FOR", "WHILE", "PROCEDURE", "WAIT"),
    *("FORWARD", "RIGHT TURN", "LEFT TURN", "BACKWARD", "DISTANCE", "COLOR", "POS"),
)
"""What beginners write most, the commonest first; the other words follow in the order of the language."""
_LAST = ("HELP", "RUN")
_NEVER = ("QUIT", "EXIT")

_VAR, _PROCEDURE, _COLON, _COMMA, _DO = (KIND[each] for each in ("VAR", "PROCEDURE", "COLON", "COMMA", "DO"))
_WORDS = frozenset(KIND[each] for each in TERMINAL_OF_WORD.values()) | {NAME}
_HALF_WORDS = (FRAGMENT, KIND["END"])
_HALVES = (*_HALF_WORDS, KIND["FOR"])
"""What a token is that may become a keyword of two words: RIGHT, END, and PARA in Portuguese."""


class Completion(msgspec.Struct, frozen=True):
    """The words that the letters before the cursor can become."""

    typed: str
    words: tuple[str, ...]
    listed: tuple[str, ...] = ()
    """The words, with usual numbers and signs if one may stand there, for a list to choose from."""


def completion(text: str, at: int, language: str, colours: Iterable[str] | None = None) -> Completion:
    """The words for the letters that end at offset ``at``. ``colours``: those that the robot can see."""
    start = _start_of_word(text, at)
    typed = text[start:at]
    if len(text) > LONGEST_CHECKED or _is_inside_string(text, at):
        return Completion(typed, ())
    folded = fold_name(typed)
    fitting = (each for each in _words(text, start, at, language, colours) if fold_name(each) != folded)
    found = tuple(dict.fromkeys(each for each in fitting if fold_name(each).startswith(folded)))
    words = tuple(_as_typed(each, typed) for each in found[:MOST_WORDS])
    return Completion(typed, words, words if typed else tuple(_listed(text[:start], words)))


def _listed(before: str, words: tuple[str, ...]) -> Iterator[str]:
    """The likelier first: a number after FW, a sensor after IF, a direction after DISTANCE."""
    tokens = lex(before).tokens
    kinds = kinds_after(tokens)
    last = tokens[-1] if tokens else None
    kind = last[0] if last is not None else None
    is_signed = last is not None and kind not in _HALF_WORDS and "\n" not in before[last[2] :]
    if kind in TAKES:
        yield from words
    if last is not None and is_signed:
        procedures, variables = _declared(tokens)
        wrong = "ASSIGN" if last[5] in procedures else "LSQB" if last[5] in variables else ""
        fitting = (signs for name, signs in _SIGNS.items() if KIND[name] in kinds and name != wrong)
        yield from chain.from_iterable(fitting)
    usual = USUAL_DEGREES if kind in _TURNS else USUAL_NUMBERS
    numbers, others = usual if NUMBER in kinds else (), () if kind in TAKES else words
    is_first_value = kind == KIND["ASSIGN"] and [each[0] for each in tokens[-3:-1]] == [_VAR, NAME]
    is_counted = kind in _COUNTED or is_first_value
    yield from (*numbers, *others) if is_counted else (*others, *numbers)
    if is_signed and _SEPARATOR in kinds:
        yield ";"


def _start_of_word(text: str, at: int) -> int:
    return at - len(re.split(r"\W", text[:at].rpartition("\n")[2])[-1])


def _is_inside_string(text: str, at: int) -> bool:
    lexed = lex(text[:at].rpartition("\n")[2])
    return lexed.open_quote is not None or bool(lexed.comments)


def _words(text: str, start: int, at: int, language: str, colours: Iterable[str] | None) -> Iterable[str]:
    before = lex(text[:start]).tokens
    last = before[-1][0] if before else None
    terminal = TAKES.get(last) if last is not None else None
    if terminal is not None:
        yield from _arguments(terminal, language, colours)
    elif last == HELP and "\n" not in text[before[-1][2] : start]:
        yield from (word for each in _ranked() for word in each.spellings[language])
        yield from keywords.all_words(language)
    else:
        if last in _HALVES:
            yield from _second_words(text[:start], before, language)
        if last not in _HALF_WORDS:
            yield from _next_words(text, start, at, before, language)


def _next_words(text: str, start: int, at: int, before: Sequence[Token], language: str) -> Iterator[str]:
    """The end of the block, then commands and names; an END that is written already comes last."""
    kinds = kinds_after(before)
    if before and "\n" in text[before[-1][2] : start] and not kinds & _WORDS:
        kinds = kinds_after(before[:-1])  # an unknown word alone in its line
    block = open_block(text[:start])
    ends = [keywords.spelling(f"END {block.kind}", language)] if block is not None else []
    rest = text[:start] + text[at:]
    is_ended = block is not None and any(
        (each.line, each.depth, each.is_closed) == (block.line, block.depth, True) for each in outline(rest)
    )
    may_end = any(kind in ENDS for kind in kinds)
    if may_end and not is_ended:
        yield from ends
    names, commands = _names(text, start, before, kinds), _keywords(kinds, language)
    yield from chain(names, commands) if NUMBER in kinds else chain(commands, names)
    if may_end:
        yield from ends


def _second_words(before: str, tokens: Sequence[Token], language: str) -> Iterator[str]:
    """The second words: after END that of the open block, after RIGHT the word TURN."""
    half = fold_name(before[tokens[-1][1] :].strip())
    kinds = kinds_after(tokens[:-1])
    block = open_block(before)
    end = f"END {block.kind}" if block is not None else ""
    for each in _ranked():
        first, *second = each.spellings[language][0].split()
        fits = KIND[each.terminal] not in ENDS or each.canonical == end
        if second and fits and fold_name(first) == half and KIND[each.terminal] in kinds:
            yield " ".join(second)


def _keywords(kinds: frozenset[int], language: str) -> Iterator[str]:
    for each in _ranked():
        if KIND[each.terminal] in kinds and KIND[each.terminal] not in ENDS:
            yield from each.spellings[language]


@cache
def _ranked() -> list[keywords.Keyword]:
    places = {word: at for at, word in enumerate(_FIRST)} | {word: len(WORDS) for word in _LAST}
    fitting = (each for each in WORDS if each.canonical not in _NEVER)
    return sorted(fitting, key=lambda each: places.get(each.canonical, len(_FIRST)))


def _arguments(terminal: str, language: str, colours: Iterable[str] | None) -> Iterable[str]:
    if terminal != "COLOUR" or colours is None:
        return keywords.argument_words(terminal, language)
    seen = set(colours)
    return (
        each
        for each in keywords.argument_words(terminal, language)
        if (found := keywords.argument(terminal, fold_name(each))) is not None and found.value in seen
    )


def _names(text: str, typed_at: int, before: Sequence[Token], kinds: frozenset[int]) -> tuple[str, ...]:
    """Variables in an expression; where a statement begins, procedures too. The nearest above come first.

    A new name, as after VAR, can't be guessed.
    """
    last = before[-1][0] if before else None
    is_new = last in (_VAR, _PROCEDURE, _COLON) or (last == _COMMA and NUMBER not in kinds)
    if NAME not in kinds or is_new:
        return ()
    procedures, variables = _declared(lex(text).tokens)
    places = (variables | procedures) if NUMBER not in kinds and _VAR in kinds else variables
    nearest = sorted(places.values(), key=lambda place: (place[0] > typed_at, -place[0]))
    return tuple(text[start:end] for start, end in nearest)


_Place: TypeAlias = tuple[int, int]
"""Where a name begins and ends."""


def _declared(tokens: Sequence[Token]) -> tuple[dict[str, _Place], dict[str, _Place]]:
    """Where procedures and variables, parameters among them, are declared, by folded name."""
    procedures: dict[str, _Place] = {}
    variables: dict[str, _Place] = {}
    in_head, before = False, None
    for kind, start, end, _line, _column, folded in tokens:
        in_head = kind not in (_DO, _VAR) and (in_head or kind == _PROCEDURE)
        if kind == NAME and before == _PROCEDURE:
            procedures.setdefault(folded, (start, end))
        elif kind == NAME and (before == _VAR or (in_head and before in (_COLON, _COMMA))):
            variables.setdefault(folded, (start, end))
        before = kind
    return procedures, variables


def _as_typed(word: str, typed: str) -> str:
    """The word in small letters if the learner typed these; a name stays as it is."""
    is_keyword = folded_word(word) in TERMINAL_OF_WORD
    return word.lower() if typed.islower() and is_keyword else word


# --- the next line


class NextLine(msgspec.Struct, frozen=True):
    """The effect of Enter on the line that it ends, and the text that it inserts."""

    before: str
    """The new indentation of the finished line: an END stands under the first line of its block."""
    indent: str
    """The indentation of the next line."""
    end: str = ""
    """The line after it: the END of the block that begins here, if that is missing."""
    doubled: bool = False
    """Whether the line after the finished one is the same END once more, for no block."""


def next_line(lines: Sequence[str], row: int, language: str) -> NextLine:
    """The line after the row (from 0) at whose end the cursor is."""
    line = lines[row]
    before, number = _indent_of(line), row + 1
    if not line.strip() or sum(map(len, lines)) > LONGEST_CHECKED:
        return NextLine(before if line.strip() else "", before)
    text = ProgramText(lines)
    if opener := text.opener_of(number):
        before = _indent_of(lines[opener - 1])
    if text.line(number).closes:
        return NextLine(before, before, doubled=_is_doubled(text, row))
    tokens = lex("\n".join(lines[:number])).tokens
    block = open_block("\n".join(lines[:number]))
    if block is None or block.line != number or KIND["SPEAK"] not in kinds_after(tokens):
        return NextLine(before, before + INDENT * bool(opener))
    is_missing = any(
        each.kind == block.kind and not each.is_closed and each.line <= number <= each.end_line
        for each in outline("\n".join(lines))
    )
    below = next((at for at in range(number + 1, len(lines) + 1) if lines[at - 1].strip()), None)
    has_room = below is None or text.opener_of(below) > 0
    end = before + _end_in_language_of(block.kind, tokens, language) if is_missing and has_room else ""
    return NextLine(before, before + INDENT, end)


def _indent_of(line: str) -> str:
    return line[: len(line) - len(line.lstrip())]


def _is_doubled(text: ProgramText, row: int) -> bool:
    """Whether the next line is the same END, and there is one too many of them."""
    words = [fold_name(" ".join(each.split())) for each in text.lines[row:]]
    same = [row + at for at, each in enumerate(words) if each == words[0]]
    return same[1:2] == [row + 1] and any(not text.line(at + 1).closes for at in same)


def _end_in_language_of(kind: str, tokens: Sequence[Token], language: str) -> str:
    """The END of the block that was opened last, in the language and the letters of its first word."""
    opener = next(each for each in reversed(tokens) if each[0] == KIND[kind])
    spoken = keywords.languages_of(opener[5])
    return keywords.spelling(f"END {kind}", language if language in spoken else min(spoken))
