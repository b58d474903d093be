"""Keywords of two words of which one is missing, misspelt or unknown: RIGHT, GIRAR DIRETA, GIRA DIREITA."""

from __future__ import annotations

from language.keywords import all_words, folded_word
from language.lexer import FRAGMENT, NAME
from language.nearby import Near, has_few_slips, near_keyword, nearest, nearest_pair
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
        if pair and has_few_slips(following[5], folded_word(pair).split()[1]):
            return near_keyword(pair), 2
    return (near_keyword(pairs[0]) if token[0] == FRAGMENT else None), 1
