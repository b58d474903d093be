"""EXPLAIN has plain words for every kind of mistake, and its examples are GoDonnie."""

import re

import pytest

from donnie_tui import LANGUAGES
from donnie_tui.core.events import INTERNAL, Error
from donnie_tui.i18n.catalogue.explain import SENTENCES
from donnie_tui.i18n.words import Words
from language import keywords
from language.diagnostics import Kind
from language.parser import parse

WORD = re.compile(r"\b[A-ZÁÂÃÇÉÊÍÓÔÕÚÑ]{2,}(?: [A-ZÁÂÃÇÉÊÍÓÔÕÚÑ]{2,})*\b")
NAMES = {"RECT", "RET", "ON", "LIGADO", "ENCENDIDO"}
"""A procedure of the learner's, and an argument."""
HELP_OF_REPEAT = Words("pt").help("REPITA")[1:]
HELP_OF_PROCEDURE = Words("pt").help("APRENDER")[2]


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


def explained(text: str, language: str = "en") -> tuple[str, ...]:
    """What EXPLAIN says of the first mistake of a program, found before it runs."""
    words, each = Words(language), parse(text).diagnostics[0]
    line, column = each.span.line, each.span.column
    source = text.split("\n")[line - 1]
    topic = keywords.topic_at(source, column)
    error = Error(
        *(each.kind.value, line, column, words.mistake(each), words.hint(each)),
        *(source, (), each.code, each.meant, topic),
    )
    return words.explanation(error)


@pytest.mark.parametrize("text", ["PF 2,5", "PF 2.5", "FALAR 2,5", "REPITA 2,5 VEZES PF 1 FIM REPITA"])
def test_a_number_that_is_not_whole_is_no_matter_of_a_sign_to_take_out(text: str) -> None:
    assert explained(text, "pt") == (
        "Números são inteiros: sem vírgula.",
        "Use um inteiro: PF 2, ou PF 3.",
    )


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("REPITA 4 veses PF 2 FIM REPITA", ("Você quis dizer VEZES?", *HELP_OF_REPEAT)),
        ("PF", ("Forma: PF valor, ou PARA FRENTE valor.", "Exemplo: PF 5.")),
        ("PF 1\nREPITA 2 VEZES", ("Escreva FIM REPITA onde ele acaba.", HELP_OF_REPEAT[1])),
        ("passos = 3 +", ("Forma: CRIAR nome = valor.", "Exemplo: CRIAR a = 5.")),
        ("DANÇAR 3", ("Confira as letras: PF 3.",)),
        ("PFF 3", ("Você quis dizer PF?", "Exemplo: PF 5.")),
        ("APRENDER P FAÇA PF 1 FIM APRENDER P 2", ("Chame assim: P [].", HELP_OF_PROCEDURE)),
    ],
    ids=["meant", "end", "open", "assigned", "unknown", "near", "called"],
)
def test_what_is_known_of_the_mistake_is_told_with_an_example_of_the_word_at_hand(
    text: str, told: tuple[str, ...]
) -> None:
    assert explained(text, "pt")[1:] == told


@pytest.mark.parametrize(
    ("line", "column", "topic"),
    [
        ("FW 2 SPEAK", 11, "SPEAK"),
        ("SE 3 > 2 ENTÃO girar direita", 29, "TR"),
        ("x = 3 +", 8, ""),
        ("FW 2 SPEAK 3", 4, "FW"),
    ],
)
def test_a_mistake_is_about_the_command_word_before_it(line: str, column: int, topic: str) -> None:
    assert keywords.topic_at(line, column) == topic
