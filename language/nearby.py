"""What a word was probably meant to be, if one of ours is near enough.

Near is one slip for a short word and up to three for a long one: a letter too many, missing, wrong (not in
words of up to three letters), or two exchanged, as Damerau and Levenshtein count. Or words are run
together: ENDIF, FW3, SOUNDON. Otherwise nothing is said: a wrong guess costs a listener more than none.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from functools import cache, lru_cache

from devices.ports.values import Frozen
from language.keywords import (
    TERMINAL_OF_WORD,
    all_words,
    argument,
    canonical,
    folded_word,
    languages_of,
    spelling,
)
from language.lexer import TAKES
from language.source import fold_name
from language.tables import TERMINALS

LONGEST = 40
"""Letters; nothing of ours is near to a longer word."""


class Near(Frozen):
    """The words as they are written, and the terminal that they begin with."""

    text: str
    terminal: str
    complete: bool = False
    """Whether more than one token was run together in it."""


def near_keyword(text: str) -> Near:
    """A keyword as it is written."""
    return Near(text, TERMINAL_OF_WORD[folded_word(text)])


def slips_allowed(length: int) -> int:
    return 0 if length < 2 else 1 if length < 6 else 2 if length < 9 else 3


def has_few_slips(typed: str, meant: str) -> bool:
    """Whether a folded word has no more slips than one of its length may have."""
    return slips_in(typed, meant) <= slips_allowed(len(typed))


def nearest(word: str, candidates: Iterable[str], preferred: Collection[str] = ()) -> str | None:
    """The candidate with the fewest slips, a preferred one if several have as few; None if none is near.

    Candidates are compared folded, and answered as given.
    """
    folded = folded_word(word)
    if len(folded) > LONGEST:
        return None
    best: tuple[int, bool, bool] | None = None
    answer = None
    allowed = slips_allowed(len(folded))
    for candidate in candidates:
        other = _folded(candidate)
        if abs(len(other) - len(folded)) > allowed:
            continue
        slips = slips_in(folded, other)
        rank = (slips, candidate not in preferred, other[:1] != folded[:1])
        if _is_near(folded, other, slips) and (best is None or rank < best):
            best, answer = rank, candidate
    return answer


SENSORS = frozenset(("DISTANCE", "POS", "COLOR"))


def nearest_keyword(word: str, terminals: frozenset[str], language: str) -> Near | None:
    """The keyword that was meant, out of those terminals of the grammar."""
    folded = fold_name(word)
    return None if len(folded) > LONGEST else _nearest_keyword(folded, terminals, language)


def pair_ending_with(second: str, terminals: frozenset[str]) -> Near | None:
    """The keyword of two words whose second one stands alone: FRENTE, DIREITA. None if there are several."""
    found = _pairs_by_second().get(fold_name(second), [])
    return found[0] if len(found) == 1 and found[0].terminal in terminals else None


def nearest_pair(first: str, second: str, terminals: frozenset[str]) -> Near | None:
    """The keyword of two words whose second one was written and whose first one is misspelt: GIRA DIREITA."""
    found = pair_ending_with(second, terminals)
    if found is None:
        return None
    written, folded = folded_word(found.text).split()[0], fold_name(first)
    is_near = len(folded) <= LONGEST and has_few_slips(folded, written)
    return found if is_near else None


@lru_cache(maxsize=2000)
def _folded(word: str) -> str:
    return folded_word(word)


@lru_cache(maxsize=1000)
def _nearest_keyword(folded: str, terminals: frozenset[str], language: str) -> Near | None:
    together = _run_together(folded, terminals)
    if together:
        return together
    written = _written()
    candidates = [each for each in all_words() if written[each] in terminals]
    preferred = [each for each in candidates if language in languages_of(each)]
    found = nearest(folded, candidates, preferred)
    return Near(_in_language(found, language), written[found]) if found else None


def _in_language(found: str, language: str) -> str:
    """A word of another language as that of the program has it: PROCEDIMENTO meant APRENDER.

    English is also that of a program without a telling word, and takes each as it is.
    """
    if language == "en" or language in languages_of(found):
        return found
    return spelling(canonical(found) or found, language)


def _is_near(folded: str, other: str, slips: int) -> bool:
    if slips > slips_allowed(len(folded)):
        return False
    if len(folded) == 2 or (len(folded) == 3 and len(other) == 3):
        return sorted(folded) == sorted(other)
    return True


def _run_together(folded: str, terminals: frozenset[str]) -> Near | None:
    pair = _pairs_without_blank().get(folded)
    if pair and pair.terminal in terminals:
        return pair
    number = re.fullmatch(r"([^\W\d_]+)(\d+)", folded)
    if number and TERMINAL_OF_WORD.get(number[1]) in terminals:
        return Near(f"{number[1].upper()} {number[2]}", TERMINAL_OF_WORD[number[1]], complete=True)
    return _keyword_and_argument(folded, terminals)


def _keyword_and_argument(folded: str, terminals: frozenset[str]) -> Near | None:
    for cut in range(len(folded) - 1, 2, -1):
        terminal = TERMINAL_OF_WORD.get(folded[:cut])
        taken = _taken_by().get(terminal or "")
        if terminal and taken and terminal in terminals and argument(taken, folded[cut:]):
            return Near(f"{folded[:cut]} {folded[cut:]}".upper(), terminal, complete=True)
    return None


@cache
def _written() -> dict[str, str]:
    return {word: TERMINAL_OF_WORD[folded_word(word)] for word in all_words()}


@cache
def _pairs_by_second() -> dict[str, list[Near]]:
    found: dict[str, list[Near]] = {}
    for text in (word for word in all_words() if " " in word):
        found.setdefault(folded_word(text).split()[1], []).append(near_keyword(text))
    return {second: pairs for second, pairs in found.items() if second not in TERMINAL_OF_WORD}


@cache
def _pairs_without_blank() -> dict[str, Near]:
    return {folded_word(word).replace(" ", ""): near_keyword(word) for word in all_words() if " " in word}


@cache
def _taken_by() -> dict[str, str]:
    return {TERMINALS[kind]: terminal for kind, terminal in TAKES.items()}


def slips_in(first: str, second: str) -> int:
    """Letters to add, drop, change or exchange with their neighbour to make one word of the other."""
    before: list[int] = []
    row = list(range(len(second) + 1))
    for i, letter in enumerate(first):
        before, last, row = row, before, [i + 1]
        for j, other in enumerate(second):
            slips = min(before[j] + (letter != other), before[j + 1] + 1, row[j] + 1)
            if i and j and letter == second[j - 1] and first[i - 1] == other:
                slips = min(slips, last[j - 1] + 1)
            row.append(slips)
    return row[-1]
