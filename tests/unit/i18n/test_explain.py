"""EXPLAIN has plain words for every kind of mistake, and its examples are GoDonnie."""

import re

import pytest
from msgspec import structs

from donnie_tui.core.events import INTERNAL, Error
from donnie_tui.i18n.words import Words
from language import keywords
from language.diagnostics import MistakeKind
from language.locales import languages
from language.parser import parse
from tests.unit.i18n.sentences import CODES, codes_of, text

WORD = re.compile(r"\b[A-ZÁÂÃÇÉÊÍÓÔÕÚÑ]{2,}(?: [A-ZÁÂÃÇÉÊÍÓÔÕÚÑ]{2,})*\b")
NAMES = {"RECT", "RET", "ON", "LIGADO", "ENCENDIDO"}
"""A procedure of the learner's, and an argument."""
HELP_OF_REPEAT = Words("pt").help("REPITA")[1:]
HELP_OF_PROCEDURE = Words("pt").help("APRENDER")[2]


@pytest.mark.parametrize("kind", [*(each.value for each in MistakeKind), INTERNAL])
def test_every_kind_of_mistake_and_a_fault_of_donnie_have_an_explanation_and_advice(kind: str) -> None:
    assert {f"explain-{kind}", f"advice-{kind}"} <= set(CODES)


@pytest.mark.parametrize("language", languages())
def test_the_words_of_the_examples_are_words_of_that_language(language: str) -> None:
    known = {*keywords.all_words(language), *NAMES, "HELP", "END", "FIM", "FIN"}
    texts = [text(code, language) for code in codes_of("explain")]
    used = {word for each in texts for phrase in WORD.findall(each) for word in split(phrase, known)}

    assert used - known == set()


def split(phrase: str, known: set[str]) -> list[str]:
    return [phrase] if phrase in known else phrase.split()


def explained(source: str, language: str = "en") -> tuple[str, ...]:
    """What EXPLAIN says of the first mistake of a program, found before it runs."""
    words, each = Words(language), parse(source).diagnostics[0]
    line, column = each.span.line, each.span.column
    source_line = source.split("\n")[line - 1]
    topic = keywords.topic_at(source_line, column)
    error = Error(
        *(each.kind.value, line, column, words.mistake(each), words.hint(each)),
        *(source_line, (), each.code, each.meant, topic),
    )
    return words.explanation(error)


@pytest.mark.parametrize("source", ["PF 2,5", "PF 2.5", "FALAR 2,5", "REPITA 2,5 VEZES PF 1 FIM REPITA"])
def test_a_number_that_is_not_whole_is_explained_as_a_number(source: str) -> None:
    assert explained(source, "pt") == (
        "Os números são inteiros: sem vírgula.",
        "Use um número inteiro: PF 2, ou PF 3.",
    )


@pytest.mark.parametrize(
    ("source", "lines"),
    [
        ("REPITA 4 veses PF 2 FIM REPITA", ("Você quis dizer VEZES?", *HELP_OF_REPEAT)),
        ("PF", ("Escreve-se: PF valor, ou PARA FRENTE valor.", "Exemplo: PF 5.")),
        ("PF\nGD 90", ("Escreve-se: PF valor, ou PARA FRENTE valor.", "Exemplo: PF 5.")),
        ("PF 1\nREPITA 2 VEZES", ("Escreva FIM REPITA onde o bloco acaba.", HELP_OF_REPEAT[1])),
        ("passos = 3 +", ("Escreve-se: CRIAR nome = valor.", "Exemplo: CRIAR a = 5.")),
        ("DANÇAR 3", ("Confira as letras: PF 3.",)),
        ("PFF 3", ("Você quis dizer PF?", "Exemplo: PF 5.")),
        ("APRENDER P FAÇA PF 1 FIM APRENDER P 2", ("Chame assim: P [].", HELP_OF_PROCEDURE)),
    ],
    ids=["meant", "end", "next", "open", "assigned", "unknown", "near", "called"],
)
def test_an_explanation_has_the_details_of_the_mistake_and_an_example(
    source: str, lines: tuple[str, ...]
) -> None:
    assert explained(source, "pt")[1:] == lines


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


def explanation(kind: str, **values: str) -> tuple[str, ...]:
    return Words().explanation(structs.replace(Error(kind, 1, 1, "m", None), **values))


QUOTES = Words()("advice-text-without-quotes")


@pytest.mark.parametrize(
    ("kind", "values", "is_text"),
    [
        ("undeclared-variable", {"code": "spoken", "topic": "SPEAK", "meant": '"hello"'}, True),
        ("undeclared-variable", {"code": "spoken"}, True),
        ("undeclared-variable", {"topic": "SPEAK"}, True),
        ("undeclared-variable", {"topic": "SPEAK", "meant": "steps"}, False),
        ("undeclared-variable", {"topic": "FW"}, False),
        ("division-by-zero", {"topic": "SPEAK"}, False),
    ],
)
def test_an_unknown_name_after_speak_may_be_a_text_without_quotes(
    kind: str, values: dict[str, str], is_text: bool
) -> None:
    said = explanation(kind, **values)

    assert (said[-1] == QUOTES) is is_text
    if is_text:
        assert said[:-1] == (Words()(f"explain-{kind}"), Words()(f"advice-{kind}"))


@pytest.mark.parametrize(
    ("kind", "example"),
    [
        ("undeclared-procedure", "PROCEDURE P: n DO FW n END PROCEDURE P [3]"),
        ("too-deep", "PROCEDURE P: n DO FW n END PROCEDURE P [3]"),
        ("recursion-limit", "IF DISTANCE F > 3 THEN FW 1 ELSE TR 90 END IF"),
        ("division-by-zero", None),
    ],
)
def test_a_mistake_of_meaning_has_an_example_where_one_helps(kind: str, example: str | None) -> None:
    said = explanation(kind, topic="FW")

    assert said[:2] == (Words()(f"explain-{kind}"), Words()(f"advice-{kind}"))
    assert said[2:] == (() if example is None else (f"Example: {example}.",))


@pytest.mark.parametrize(
    ("kind", "values", "is_hint"),
    [
        ("unknown-character", {}, True),
        ("missing-end", {}, True),
        ("wrong-end", {}, True),
        ("bad-argument", {}, True),
        ("unknown-command", {}, False),
        ("unknown-command", {"meant": "FW"}, True),
        ("unknown-command", {"code": "procedure"}, True),
        ("undeclared-procedure", {}, False),
        ("undeclared-procedure", {"meant": "P"}, True),
    ],
)
def test_a_hint_comes_before_general_advice_where_it_is_about_this_mistake(
    kind: str, values: dict[str, str], is_hint: bool
) -> None:
    said = explanation(kind, hint="Do this.", **values)

    assert ("Do this." in said) is is_hint
    assert (Words()(f"advice-{kind}") in said) is not is_hint


@pytest.mark.parametrize("kind", ["missing-end", "wrong-end", "unknown-character", "undeclared-procedure"])
def test_without_a_hint_the_general_advice_is_given(kind: str) -> None:
    assert Words()(f"advice-{kind}") in explanation(kind, meant="P")


@pytest.mark.parametrize(
    ("meant", "example"), [("FW", "FW 5"), ("FW 3", "FW 5"), ("RIGHT TURN", "TR 90"), ("steps", None)]
)
def test_an_unknown_command_has_the_example_of_the_one_that_was_meant(
    meant: str, example: str | None
) -> None:
    said = explanation("unknown-command", meant=meant)

    assert [each for each in said if each.startswith("Example")] == (
        [f"Example: {example}."] if example else []
    )
    procedure = explanation("unknown-command", code="procedure", meant=meant)
    assert procedure[-1].startswith("Example: PROCEDURE ")


def test_a_number_with_a_point_is_explained_only_where_the_point_is_wrong() -> None:
    numbers = (Words()("explain-whole-numbers"), Words()("advice-whole-numbers"))
    assert explanation("unknown-character", source_line="FW 2.5") == numbers
    assert explanation("unknown-character", source_line="FW 2.") != numbers
    assert explanation("syntax", source_line="FW 2.5") != numbers
    assert explanation("syntax", code="whole-numbers") == numbers


@pytest.mark.parametrize(
    ("line", "topic", "example"),
    [("x = 3 +", "", "VAR a = 5"), ("x = FW 3 +", "FW", "FW 5"), ("3 +", "", None), ("FW 3 +", "FW", "FW 5")],
)
def test_a_mistake_in_an_assignment_has_the_example_of_one(
    line: str, topic: str, example: str | None
) -> None:
    said = explanation("syntax", source_line=line, topic=topic)

    assert [each for each in said if each.startswith("Example")] == (
        [f"Example: {example}."] if example else []
    )
