"""A line that was meant for the terminal: its word is none of ours, but near to one.

Rules: a guess is made only where the line can be no GoDonnie (its first word is an unknown command there, and
nowhere else in the program), and where no word of GoDonnie is as near; a name of the learner's own is never
taken away.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from devices.ports.values import Frozen
from donnie_tui.core.use_cases import LONGEST_WORD, UseCase
from language import keywords
from language.diagnostics import Diagnostic, Kind
from language.parser import Parsed
from language.source import fold_name

LARGEST = 20_000
"""Characters of a program that is looked through for one line."""
_MOST_WORDS = 3


class Unknown(Frozen):
    """What was typed, and the word that was probably meant."""

    word: str
    meant: str


def unknown_word(
    line: str,
    lines: Sequence[str],
    cases: Sequence[UseCase],
    language: str,
    parse: Callable[[str], Parsed],
) -> Unknown | None:
    """The word of the terminal that ``line`` was meant to begin with. None where it may be GoDonnie.

    ``lines`` are those of the program before it, ``parse`` reads GoDonnie.
    """
    words = line[: _MOST_WORDS * LONGEST_WORD].split()[:_MOST_WORDS]
    if not words or not words[0].isalpha() or keywords.is_reserved(words[0]):
        return None
    if sum(map(len, lines)) + len(line) > LARGEST or _is_name_in(words[0], lines):
        return None
    near = _near(words, cases, language)
    mistake = _mistake_of(line, lines, parse) if near is not None else None
    if near is None or mistake is None or _is_nearer(mistake.meant, near):
        return None
    return near


def _is_name_in(word: str, lines: Sequence[str]) -> bool:
    return fold_name(word) in re.findall(r"\w+", fold_name(" ".join(lines)))


def _mistake_of(line: str, lines: Sequence[str], parse: Callable[[str], Parsed]) -> Diagnostic | None:
    """That the line begins with an unknown command, if it does."""
    number = len(lines) + 1
    for each in parse("\n".join((*lines, line))).diagnostics:
        if each.kind is Kind.UNKNOWN_COMMAND and each.span.line == number:
            return each if fold_name(each.found) == fold_name(line.split()[0]) else None
    return None


def _near(words: Sequence[str], cases: Sequence[UseCase], language: str) -> Unknown | None:
    """Of words that begin alike the longer one counts."""
    from language.nearby import nearest  # most lines begin with a word of GoDonnie

    of_language = [each.word(language) for each in cases]
    all_words = [*of_language, *(word for each in cases for word in (each.en, each.pt, each.es))]
    for length in range(len(words), 0, -1):
        typed = " ".join(words[:length])
        same_length = [each for each in all_words if len(each.split()) == length and len(each) > 1]
        found = nearest(typed, dict.fromkeys(same_length), of_language)
        if found is not None:
            return Unknown(typed, found)
    return None


def _is_nearer(keyword: str, near: Unknown) -> bool:
    """Whether a word of GoDonnie is as near as ours, or nearer."""
    from language.nearby import slips_in

    typed = fold_name(near.word)
    return bool(keyword) and slips_in(typed, fold_name(keyword)) <= slips_in(typed, fold_name(near.meant))
