"""HELP lists every command with its purpose, and explains each by its form and an example that runs."""

import pytest

from donnie_tui.i18n.help import ENTRIES, example
from donnie_tui.i18n.words import Words
from language import keywords
from language.locales import languages
from language.parser import parse


def test_every_command_word_of_every_language_has_help() -> None:
    topics = {keywords.topic(word) for word in keywords.all_words()}

    assert topics == set(ENTRIES)


@pytest.mark.parametrize("language", languages())
def test_the_list_gives_its_length_and_then_a_command_a_line(language: str) -> None:
    first, *rest = Words(language).help(None)

    assert first.startswith(f"{len(ENTRIES)} ")
    assert len(rest) == len(ENTRIES)
    assert all(len(line) <= 60 and ": " in line and line.endswith(".") for line in rest)


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("topic", ENTRIES)
def test_an_example_is_a_program_without_mistakes(topic: str, language: str) -> None:
    parsed = parse(example(topic, Words(language)))

    assert parsed.diagnostics == ()
    assert parsed.program is not None


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("topic", ENTRIES)
def test_an_example_shows_its_command_in_the_learners_words(topic: str, language: str) -> None:
    assert keywords.spelling(topic, language) in example(topic, Words(language))


def test_help_for_a_word_has_its_purpose_its_form_and_one_example() -> None:
    assert Words("en").help("forward") == (
        "FW: Walks forward, in steps.",
        "You write: FW value, or FORWARD value.",
        "Example: FW 5.",
    )


def test_a_word_of_another_language_is_explained_in_the_learners() -> None:
    assert Words("es").help("enquanto")[0] == "MIENTRAS: Repite mientras es verdad."


def test_a_closing_word_is_explained_with_what_it_closes() -> None:
    assert Words("pt").help("fim se") == Words("pt").help("SE")


def test_a_misspelt_topic_gets_the_nearest_word() -> None:
    assert Words("en").help("REPAET") == ("I do not know REPAET. Did you mean REPEAT?",)


@pytest.mark.parametrize("topic", ["", "zzz", "x" * 10_000, "{0}", "\x1b"])
def test_the_answer_to_an_unknown_topic_is_one_short_line(topic: str) -> None:
    (line,) = Words("en").help(topic)

    assert line.startswith("I do not know")
    assert len(line) <= 80
