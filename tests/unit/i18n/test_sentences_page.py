"""The page for a review by ear has every sentence, with a real value in each place."""

import pytest

from donnie_tui import DETAILS
from language.locales import languages
from tests.tools.sentences import EXAMPLES, document, examples, places, rendered
from tests.unit.i18n.sentences import CODES, ENTRIES, text

TOPICS = {each.context.partition("|")[0]: each.topic for each in ENTRIES}


def places_of(code: str) -> set[str]:
    texts = (text(code, each, detail) for each in languages() for detail in DETAILS)
    return {name for each in texts for name in places(each)}


def test_every_place_has_an_example() -> None:
    """A new place needs one in ``tests/tools/sentences.toml``."""
    missing = [
        f"{code}: {name}"
        for code, topic in TOPICS.items()
        for name in places_of(code)
        if not examples(name, code, topic)
    ]

    assert missing == []


def test_every_example_is_of_a_place() -> None:
    """Else delete it in ``tests/tools/sentences.toml``."""
    wanted = {(code, name) for code in CODES for name in places_of(code)}

    of_topics = {(TOPICS[code], name) for code, name in wanted}
    assert set(EXAMPLES["everywhere"]) <= {name for _, name in wanted}
    assert {(topic, name) for topic, names in EXAMPLES["topic"].items() for name in names} <= of_topics
    assert {(code, name) for code, names in EXAMPLES["sentence"].items() for name in names} <= wanted


@pytest.mark.parametrize(
    ("language", "one", "several"),
    [("en", "step", "steps"), ("pt", "passo", "passos"), ("es", "paso", "pasos")],
)
def test_a_sentence_with_a_number_is_there_for_one_and_for_several(
    language: str, one: str, several: str
) -> None:
    first, last = rendered("walked-forward", "movement", language)

    assert f" 1 {one} " in first
    assert f" 12 {several} " in last


@pytest.mark.parametrize(("language", "word"), [("en", "END IF"), ("pt", "FIM SE"), ("es", "FIN SI")])
def test_a_value_is_in_the_language_of_the_page(language: str, word: str) -> None:
    assert word in rendered("hint-write-closer", "mistakes", language)[0]


@pytest.mark.parametrize(
    ("language", "chair", "red"),
    [
        ("en", "the chair", "the red chair"),
        ("pt", "a cadeira", "a cadeira vermelha"),
        ("es", "la silla", "la silla roja"),
    ],
)
def test_the_article_and_the_colour_agree_with_the_thing(language: str, chair: str, red: str) -> None:
    assert rendered("the-one-colour", "things", language) == (chair,)
    assert rendered("the-coloured", "things", language) == (red,)


@pytest.mark.parametrize("language", languages())
def test_the_page_has_every_sentence_and_no_empty_place(language: str) -> None:
    page = document(language)

    assert [code for code in CODES if f"\n`{code}`\n\n- " not in page] == []
    assert [line for line in page.splitlines() if "{" in line or "}" in line] == []
