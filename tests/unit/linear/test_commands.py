"""The words of the linear mode: declared once, in three languages, beside GoDonnie's and never over them."""

import re

import pytest

from donnie_tui.i18n.catalogue.linear import SENTENCES
from donnie_tui.i18n.sentence import LANGUAGES
from donnie_tui.linear.commands import COMMANDS, LISTED, Command, find
from language import keywords

WORDS = [(each, word) for each in COMMANDS for word in (each.en, each.pt, each.es)]


@pytest.mark.parametrize(("command", "word"), WORDS)
def test_no_word_is_one_of_godonnie_s(command: Command, word: str) -> None:
    assert not keywords.is_reserved(word)


@pytest.mark.parametrize(("command", "word"), WORDS)
def test_a_word_means_the_same_in_every_case_and_without_accents(command: Command, word: str) -> None:
    assert find(f"  {word.lower()}  3 ") == (command, "3")
    assert find(word.lower().replace("ú", "u").replace("ó", "o")) == (command, "")


def test_no_word_means_two_things() -> None:
    meanings = {(word, command.name) for command, word in WORDS}

    assert len({word for word, _ in meanings}) == len(meanings)


@pytest.mark.parametrize("line", ["speed = 3", "LIST [2]", "where=1", "openx", "FW 3", "", "x" * 1000])
def test_a_learner_s_own_name_is_no_word(line: str) -> None:
    assert find(line) is None


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", LISTED)
def test_the_help_of_a_word_begins_with_the_word(name: str, language: str) -> None:
    command = next(each for each in COMMANDS if each.name == name)
    word = (command.en, command.pt, command.es)[LANGUAGES.index(language)]
    text = SENTENCES[f"linear-word-{name}"].text(language)

    assert re.split(r"[ :]", text)[0] == word


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", LISTED)
def test_the_example_of_a_word_is_a_way_to_say_it(name: str, language: str) -> None:
    example = SENTENCES[f"linear-word-{name}"].text(language).partition(":")[0]
    found = find(example)

    assert found is not None
    assert found[0].name == name
