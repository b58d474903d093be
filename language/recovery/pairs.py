"""Keywords of two words of which one is missing, misspelt or unknown: RIGHT, GIRAR DIRETA, GIRA DIREITA."""

from __future__ import annotations

from language.keywords import TERMINAL_OF_WORD, all_words, folded_word
from language.lexer import FRAGMENT, NAME
from language.nearby import Near, nearest, nearest_pair, slips_allowed, slips_in
from language.recovery.kinds import ASSIGN
from language.recovery.reading import Reading


def pair_with_misspelt_first(reading: Reading) -> Near | None:
    """GIRA DIREITA: both words together, where the second one alone is not the mistake."""
    token, following = reading.token, reading.following
    if following[0] != NAME or following[3] != token[3]:
        return None
    return nearest_pair(token[5], following[5], reading.automaton.acceptable())


def has_misspelt_second(reading: Reading) -> bool:
    """PARA FRENT, which is no head of PARA (FOR)."""
    third = reading.tokens[min(reading.at + 2, len(reading.tokens) - 1)][0]
    return third != ASSIGN and pair_meant(reading)[1] == 2


def pair_meant(reading: Reading) -> tuple[Near | None, int]:
    """The keyword that is meant whose first word stands here, and how many tokens were meant for it."""
    token, following = reading.token, reading.following
    pairs = [each for each in all_words() if folded_word(each).startswith(f"{token[5]} ")]
    if following[0] in (NAME, FRAGMENT) and following[3] == token[3]:
        pair = nearest(f"{token[5]} {following[5]}", pairs)
        if pair and _is_near(following[5], folded_word(pair).split()[1]):
            return _near(pair), 2
    return (_near(pairs[0]) if token[0] == FRAGMENT else None), 1


def _is_near(typed: str, second: str) -> bool:
    return slips_in(typed, second) <= slips_allowed(len(typed))


def _near(pair: str) -> Near:
    return Near(pair, TERMINAL_OF_WORD[folded_word(pair)])
