"""The use cases: words in three languages, beside GoDonnie's, never over them; both front ends have them."""

import re

import pytest

from donnie_tui import LANGUAGES
from donnie_tui.core.report_text import asked
from donnie_tui.core.use_cases import BY_NAME, LONGEST_WORD, USE_CASES, UseCase, find, help_line, help_of
from donnie_tui.core.view_cases import IN_WORDS, PREFERENCES, VIEW_CASES
from donnie_tui.i18n.catalogue import SENTENCES
from donnie_tui.i18n.words import Words
from donnie_tui.linear.commands import HANDLED_IN, OF_CONVERSATION
from language import keywords
from language.source import fold_name

WORDS = [(each, language) for each in USE_CASES for language in LANGUAGES]


@pytest.mark.parametrize(("case", "language"), WORDS, ids=lambda each: getattr(each, "en", each))
def test_a_word_is_none_of_godonnie_s_unless_it_means_the_same(case: UseCase, language: str) -> None:
    first = case.word(language).split()[0]

    assert keywords.is_reserved(first) == case.is_godonnie


def test_no_word_means_two_things() -> None:
    meanings = {(fold_name(case.word(language)), case.name) for case, language in WORDS}

    assert len({word for word, _ in meanings}) == len(meanings)


@pytest.mark.parametrize(("case", "language"), WORDS, ids=lambda each: getattr(each, "en", each))
def test_a_word_is_found_in_every_case_and_without_accents(case: UseCase, language: str) -> None:
    word = case.word(language)
    found = [find(each) for each in (f"  {word.lower()}  3 ", fold_name(word), word.upper())]

    assert [(each[0].name, each[1]) for each in found if each] == [
        (case.name, "3"),
        (case.name, ""),
        (case.name, ""),
    ]


@pytest.mark.parametrize("line", ["speed = 3", "LIST [2]", "where=1", "openx", "FW 3", "", "x" * 1000])
def test_a_learner_s_own_name_is_no_use_case(line: str) -> None:
    assert find(line) is None


def test_of_two_words_that_begin_alike_the_longer_counts() -> None:
    assert [find(line)[0].name for line in ("SAVE x", "save as x", "Save Log x")] == [
        "save",
        "save_as",
        "save_log",
    ]


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_help_of_each_fits_forty_characters(language: str) -> None:
    """L8, B1; a braille display shows it whole."""
    lines = [help_line(each, Words(language)) for each in USE_CASES if not each.hidden]

    assert [line for line in lines if len(line) > 40] == []


def test_every_use_case_has_its_purpose_and_every_argument_its_example() -> None:
    assert {f"action-{name}" for name in BY_NAME} <= set(SENTENCES)
    assert {f"help-typed-{each.argument}" for each in USE_CASES if each.argument} <= set(SENTENCES)
    assert max(len(case.word(language)) for case, language in WORDS) <= LONGEST_WORD


def test_the_linear_mode_does_every_use_case() -> None:
    assert set(BY_NAME) == set(HANDLED_IN) | set(OF_CONVERSATION)


def test_the_full_screen_does_every_use_case() -> None:
    from donnie_tui.tui.keys import KEYS

    assert set(BY_NAME) <= set(KEYS)


def test_every_word_and_setting_of_the_full_screen_is_answered_in_the_linear_mode() -> None:
    """L4: done there, or told what is typed in its place, or that it is only for the eye."""
    from donnie_tui.linear.habits import SPELLINGS
    from donnie_tui.tui.keys import KEYS
    from donnie_tui.tui.preferences import CHOICES
    from donnie_tui.words.sound_words import SETTINGS, find_setting

    views = {each.name for each in VIEW_CASES}
    elsewhere = {*IN_WORDS.values(), *PREFERENCES.values()}

    assert set(KEYS) <= set(HANDLED_IN) | set(OF_CONVERSATION) | views
    assert set(IN_WORDS) <= views
    assert elsewhere <= {*BY_NAME, "SOUND", ""}
    assert {key for key in CHOICES if not find_setting(key)} <= {*PREFERENCES, *SETTINGS, *SPELLINGS}


def test_a_word_of_the_screen_is_found_beside_those_of_both_modes() -> None:
    words = [(each, each.word(language)) for each in VIEW_CASES for language in LANGUAGES]
    found = {word: find(word, (*USE_CASES, *VIEW_CASES)) for _, word in words}

    assert [word for case, word in words if found[word] != (case, "")] == []


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("case", [each for each in (*USE_CASES, *VIEW_CASES) if not each.is_godonnie])
def test_each_word_is_explained_with_its_form_and_an_example(case: UseCase, language: str) -> None:
    words = Words(language)
    what, form, *_, example = help_of(case.word(language), words, (*USE_CASES, *VIEW_CASES))
    word = case.word(language)

    assert what.startswith(f"{word}") or word in what
    assert word in form
    assert word in example
    assert ("," in form) == bool(case.argument and not case.required)


def test_the_form_says_what_must_follow_and_what_may() -> None:
    words = Words("en")

    assert help_of("move", words)[1:] == ("Form: MOVE line before.", "Example: MOVE 5 2.")
    assert help_of("LIST", words)[1] == "Form: LIST, or LIST first last."
    assert help_of("STEP", words)[1:] == ("Form: STEP.", "Example: STEP.")
    assert help_of("FW", words) == help_of("RUN", words) == ()


@pytest.mark.parametrize("language", LANGUAGES)
def test_help_of_report_says_of_what_there_are_reports(language: str) -> None:
    """Each word of it is understood."""
    told = help_of("REPORT", Words(language))[2]

    subjects = [asked(f"{word} x") for word in re.findall(r"\w+", told)[1:]]
    assert sorted(found[0] for found in subjects if found) == ["help", "list", "manual", "map", "trail"]
    assert len(told) <= 40
