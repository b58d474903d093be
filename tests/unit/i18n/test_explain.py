"""EXPLAIN has plain words for every kind of mistake, and its examples are GoDonnie."""

import re

import pytest

from donnie_tui import LANGUAGES
from donnie_tui.core.events import INTERNAL
from donnie_tui.i18n.catalogue.explain import SENTENCES
from language import keywords
from language.diagnostics import Kind

WORD = re.compile(r"\b[A-ZÁÂÃÇÉÊÍÓÔÕÚÑ]{2,}(?: [A-ZÁÂÃÇÉÊÍÓÔÕÚÑ]{2,})*\b")
NAMES = {"RECT", "RET", "ON"}
"""A procedure of the learner's, and an argument."""


@pytest.mark.parametrize("kind", [*(each.value for each in Kind), INTERNAL])
def test_every_kind_of_mistake_is_explained_and_mended_and_so_is_a_fault_of_ours(kind: str) -> None:
    assert {f"explain-{kind}", f"mend-{kind}"} <= set(SENTENCES)


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_words_of_the_examples_are_words_of_that_language(language: str) -> None:
    known = {*keywords.all_words(language), *NAMES, "HELP", "END", "FIM", "FIN"}
    texts = [sentence.text(language) for sentence in SENTENCES.values()]
    used = {word for text in texts for phrase in WORD.findall(text) for word in split(phrase, known)}

    assert used - known == set()


def split(phrase: str, known: set[str]) -> list[str]:
    return [phrase] if phrase in known else phrase.split()
