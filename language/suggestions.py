"""Suggests the word that a misspelt one was probably meant to be, if a near one exists.

A word is near at a distance of one edit for a short word, up to three for a long one: a letter too many,
missing, wrong (not in words of up to three letters), or two exchanged (Damerau and Levenshtein). Or the blank
is missing: ENDIF, FW3, SOUNDON. Otherwise there is no suggestion: a wrong guess costs a listener more than
none.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence
from functools import cache, lru_cache

from msgspec import Struct

from language.diagnostics import Diagnostic, MistakeKind, mistake_at
from language.keywords import (
    TERMINAL_OF_WORD,
    all_words,
    argument,
    canonical,
    folded_word,
    languages_of,
    spelling,
)
from language.lexer import SENSORS, TAKE_EXPRESSION, TAKES, language_of, lex
from language.locales import ENGLISH, keys, languages, own_words
from language.source import fold_name
from language.syntax import Declare, For, Name, Procedure, Program, walk
from language.tables import TERMINALS

LONGEST = 40
"""Letters; no word is near to a longer one."""

SAMPLES = {**{each: "2" for each in TAKE_EXPRESSION if each != "SPEAK"}, "TR": "90", "TL": "90"}
"""By terminal: a number for a command that was typed without one."""

_MOST_COMPARED = 300
"""Names that are compared with a wrong one while a program runs."""


class Suggestion(Struct, frozen=True):
    """The suggested text, and the terminal that it begins with."""

    text: str
    terminal: str
    complete: bool = False
    """Whether the text is more than one token, typed without the blank between them."""


def suggested_keyword(text: str) -> Suggestion:
    return Suggestion(text, TERMINAL_OF_WORD[folded_word(text)])


def _edits_allowed(length: int) -> int:
    return 0 if length < 2 else 1 if length < 7 else 2 if length < 9 else 3


def is_near(typed: str, meant: str) -> bool:
    """Whether no more edits are between two folded words than the length of the first allows."""
    return edit_distance(typed, meant) <= _edits_allowed(len(typed))


def nearest(word: str, candidates: Iterable[str], preferred: Collection[str] = ()) -> str | None:
    """The candidate with the fewest edits, a preferred one if several have as few; None if none is near.

    Candidates are compared folded and returned as given.
    """
    folded = folded_word(word)
    if len(folded) > LONGEST:
        return None
    best: tuple[int, bool, bool] | None = None
    answer = None
    allowed = _edits_allowed(len(folded))
    for candidate in candidates:
        other = _folded(candidate)
        if abs(len(other) - len(folded)) > allowed:
            continue
        edits = edit_distance(folded, other)
        rank = (edits, candidate not in preferred, other[:1] != folded[:1])
        if _is_near_enough(folded, other, edits) and (best is None or rank < best):
            best, answer = rank, candidate
    return answer


def nearest_keyword(word: str, terminals: frozenset[str], language: str) -> Suggestion | None:
    """The keyword that was probably meant, one of those terminals of the grammar."""
    folded = fold_name(word)
    return None if len(folded) > LONGEST else _nearest_keyword(folded, terminals, language)


def pair_ending_with(second: str, terminals: frozenset[str]) -> Suggestion | None:
    """The keyword whose second word was typed alone: FRENTE, DIREITA. None if there are several."""
    found = _pairs_by_second().get(fold_name(second), [])
    return found[0] if len(found) == 1 and found[0].terminal in terminals else None


def nearest_pair(first: str, second: str, terminals: frozenset[str]) -> Suggestion | None:
    """The keyword whose second word was typed and whose first word is misspelt: GIRA DIREITA."""
    found = pair_ending_with(second, terminals)
    if found is None:
        return None
    right, folded = folded_word(found.text).split()[0], fold_name(first)
    return found if len(folded) <= LONGEST and is_near(folded, right) else None


@lru_cache(maxsize=2000)
def _folded(word: str) -> str:
    return folded_word(word)


@lru_cache(maxsize=1000)
def _nearest_keyword(folded: str, terminals: frozenset[str], language: str) -> Suggestion | None:
    together = _without_blank(folded, terminals)
    if together:
        return together
    terminal_of = _terminals()
    words = dict.fromkeys((*all_words(language), *all_words()))
    candidates = [each for each in words if terminal_of[each] in terminals]
    preferred = [each for each in candidates if language in languages_of(each)]
    found = nearest(folded, candidates, preferred)
    meant = _in_language(found, language) if found else ""
    return Suggestion(meant, terminal_of[found]) if found and _folded(meant) != _folded(folded) else None


def _in_language(found: str, language: str) -> str:
    """A word of another language in the language of the program: PROCEDIMENTO meant APRENDER.

    English is also the language of a program without typical words, and keeps each word.
    """
    if language == "en" or language in languages_of(found):
        return found
    return spelling(canonical(found) or found, language)


def _is_near_enough(folded: str, other: str, edits: int) -> bool:
    if edits > _edits_allowed(len(folded)):
        return False
    if len(folded) == 2 or (len(folded) == 3 and len(other) == 3):
        return sorted(folded) == sorted(other)
    return True


def _without_blank(folded: str, terminals: frozenset[str]) -> Suggestion | None:
    pair = _pairs().get(folded)
    if pair and pair.terminal in terminals:
        return pair
    number = re.fullmatch(r"([^\W\d_]+)(\d+)", folded)
    if number and TERMINAL_OF_WORD.get(number[1]) in terminals:
        return Suggestion(f"{number[1].upper()} {number[2]}", TERMINAL_OF_WORD[number[1]], complete=True)
    return _keyword_and_argument(folded, terminals)


def _keyword_and_argument(folded: str, terminals: frozenset[str]) -> Suggestion | None:
    for cut in range(len(folded) - 1, 2, -1):
        terminal = TERMINAL_OF_WORD.get(folded[:cut])
        taken = _taken_by().get(terminal or "")
        if terminal and taken and terminal in terminals and argument(taken, folded[cut:]):
            return Suggestion(f"{folded[:cut]} {folded[cut:]}".upper(), terminal, complete=True)
    return None


@cache
def _terminals() -> dict[str, str]:
    return {word: TERMINAL_OF_WORD[folded_word(word)] for word in all_words()}


@cache
def _pairs_by_second() -> dict[str, list[Suggestion]]:
    found: dict[str, list[Suggestion]] = {}
    for text in (word for word in all_words() if " " in word):
        found.setdefault(folded_word(text).split()[1], []).append(suggested_keyword(text))
    return {second: pairs for second, pairs in found.items() if second not in TERMINAL_OF_WORD}


@cache
def _pairs() -> dict[str, Suggestion]:
    return {
        folded_word(word).replace(" ", ""): suggested_keyword(word) for word in all_words() if " " in word
    }


@cache
def _taken_by() -> dict[str, str]:
    return {TERMINALS[kind]: terminal for kind, terminal in TAKES.items()}


def edit_distance(first: str, second: str) -> int:
    """Letters to add, drop, change or exchange with their neighbour to turn one word into the other."""
    before: list[int] = []
    row = list(range(len(second) + 1))
    for i, letter in enumerate(first):
        before, last, row = row, before, [i + 1]
        for j, other in enumerate(second):
            edits = min(before[j] + (letter != other), before[j + 1] + 1, row[j] + 1)
            if i and j and letter == second[j - 1] and first[i - 1] == other:
                edits = min(edits, last[j - 1] + 1)
            row.append(edits)
    return row[-1]


# --- what beginners say -------------------------------------------------------------------------------


class Everyday(Struct, frozen=True):
    """An everyday word for a word of GoDonnie, at the beginning of a line: WALK, TURN LEFT, ANDAR."""

    terminal: str
    language: str
    width: int
    """How many of the words of the line it takes."""
    number: str = ""
    """The number among these words, in digits: ANDE 3 PASSOS PARA TRÁS; or the one that they mean."""


_MOST_EVERYDAY = 8
"""Words of a line that are compared."""


def everyday(line: Sequence[str], spoken: Iterable[str] = ()) -> Everyday | None:
    """What the folded words of a line begin with; the longest, first in a language spoken."""
    found = None
    for each in (*(one for one in spoken if one != ENGLISH), *languages()):
        longest = _everyday_in(each, line)
        if longest is not None and (found is None or longest.width > found.width):
            found = longest
    return found


def _everyday_in(language: str, line: Sequence[str]) -> Everyday | None:
    """The longest phrase of one language. One number may be among its words, and then none after it."""
    phrases, fillers = _everyday_words(language), fillers_of(language)
    said, number, found = "", "", None
    for width, word in enumerate(line[:_MOST_EVERYDAY], start=1):
        digits = word if word.isdecimal() else number_in_digits(word)
        if said and not number and digits:
            number = digits
        elif word not in fillers:
            said = f"{said} {word}".strip()
            terminal, _, meant = phrases.get(said, "").partition(" ")
            is_number_after = number and line[width : width + 1] and line[width].isdecimal()
            if terminal and not is_number_after:
                found = Everyday(terminal, language, width, number or meant)
    return found


@cache
def _everyday_words(language: str) -> dict[str, str]:
    """The terminal by phrase; also with a number after it, which is meant where none is said."""
    return {
        folded_word(phrase): terminal
        for terminal in keys(language, "keywords", "everyday")
        if terminal != "fillers"
        for phrase in own_words(language, "keywords", "everyday", terminal)
    }


@cache
def fillers_of(language: str) -> frozenset[str]:
    """Folded words that beginners write between others: THE, STEPS."""
    return frozenset(map(folded_word, own_words(language, "keywords", "everyday", "fillers")))


@cache
def _joining_words() -> dict[str, str]:
    return {
        folded_word(word): f"{joined}-comparison"
        for language in languages()
        for joined in keys(language, "keywords", "joining")
        for word in own_words(language, "keywords", "joining", joined)
    }


def joining_word(word: str) -> str:
    """The code of the mistake for AND or OR between two comparisons; empty for any other word."""
    return _joining_words().get(word, "")


@cache
def _number_words() -> dict[str, str]:
    return {
        folded_word(word): digits
        for language in reversed(languages())
        for digits in keys(language, "keywords", "numbers")
        for word in own_words(language, "keywords", "numbers", digits)
    }


def number_in_digits(word: str) -> str:
    """TWO is 2; empty for any other word."""
    return _number_words().get(folded_word(word), "")


# --- names that were never declared -------------------------------------------------------------------


def undeclared_variable(
    program: Program,
    name: Name,
    own: Collection[str],
    procedure: str,
    of_program: Collection[str],
    *,
    most_compared: int | None = _MOST_COMPARED,
) -> Diagnostic:
    """The mistake, with the variable that was probably meant.

    ``own``: the variables that exist there. ``procedure``: as typed, or empty in the program itself.
    ``of_program``: the variables of the program, which a procedure does not see; the detail
    ``in_procedure`` says that the name is one of them. ``most_compared``: None for every name.
    """
    details = {"name": _typed(program, name)}
    if procedure and name.name in of_program:
        meant, details["in_procedure"] = "", procedure
    else:
        meant = _name_meant(program, name, own, most_compared) or _sensor_meant(program, name)
        digits = "" if meant else number_in_digits(name.name)
        if digits:
            return _number_in_letters(program, name, digits)
        if not meant and (spoken := _spoken_alone(program, name)):
            return _text_without_quotes(program, name, spoken)
    return mistake_at(program, name.span, MistakeKind.UNDECLARED_VARIABLE, details, meant)


def _typed(program: Program, name: Name) -> str:
    """A name without the parentheses and the sign that belong to its span."""
    return program.typed(name.span).strip("(+) \t\r\n")


def _number_in_letters(program: Program, name: Name, digits: str) -> Diagnostic:
    """FW two: with the word before the number, if there is one."""
    before = re.search(r"[^\W\d_]+[ \t]+\Z", program.source[: name.span.start])
    written = f"{before[0] if before else ''}{digits}"
    details = {"name": _typed(program, name), "written": " ".join(written.split())}
    return mistake_at(program, name.span, MistakeKind.UNDECLARED_VARIABLE, details, digits, "number-word")


def _spoken_alone(program: Program, name: Name) -> str:
    """SPEAK as it was typed, if it says this name and nothing more; else empty."""
    before = re.search(r"([^\W\d_]+)[ \t]+\Z", program.source[: name.span.start])
    is_over = re.match(r"[ \t;]*(\n|\r|--|\Z)", program.source[name.span.end :])
    is_word = len(name.name) > 1  # a name of one letter is rather a variable
    return before[1] if before and is_over and is_word and canonical(before[1]) == "SPEAK" else ""


def _text_without_quotes(program: Program, name: Name, speak: str) -> Diagnostic:
    """SPEAK hello: the text in quotation marks may be meant, or a variable."""
    typed = _typed(program, name)
    text = f'"{typed}"'
    details: dict[str, str | int] = {"name": typed, "written": f"{speak} {text}"}
    return mistake_at(program, name.span, MistakeKind.UNDECLARED_VARIABLE, details, text, "spoken")


def undeclared_procedure(
    program: Program, name: Name, existing: Collection[str], *, most_compared: int | None = _MOST_COMPARED
) -> Diagnostic:
    """The mistake, with the procedure that was probably meant. ``most_compared``: None for every name."""
    details = {"name": program.typed(name.span)}
    meant = _name_meant(program, name, existing, most_compared)
    return mistake_at(program, name.span, MistakeKind.UNDECLARED_PROCEDURE, details, meant)


def _name_meant(program: Program, name: Name, existing: Collection[str], most_compared: int | None) -> str:
    near = nearest(name.name, sorted(existing)[:most_compared])
    return _as_declared(program, near) if near else ""


def _sensor_meant(program: Program, name: Name) -> str:
    """DISTANSIA without a direction after it, and without an assignment."""
    if re.match(r"\s*=(?!=)", program.source[name.span.end :]):
        return ""
    found = nearest_keyword(name.name, SENSORS, language_of(lex(program.source).tokens, program.source))
    return found.text if found and not found.complete else ""


def _as_declared(program: Program, name: str) -> str:
    """A folded name as the learner typed it in its declaration."""
    for statement in walk(program.body):
        for declared in _declared_by(statement):
            if declared.name == name:
                return program.typed(declared.span)
    return name


def _declared_by(statement: object) -> tuple[Name, ...]:
    match statement:
        case Declare(name=name) | For(start=Declare(name=name)):
            return (name,)
        case Procedure(name=name, parameters=parameters):
            return (name, *parameters)
        case _:
            return ()
