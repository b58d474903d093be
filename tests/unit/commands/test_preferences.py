"""The settings that the learner changes: their words in each language, and their values as they are kept."""

import pytest

from donnie_tui.commands.preferences import (
    BY_NAME,
    PREFERENCES,
    Preferences,
    Where,
    find_preference,
    value_typed,
    value_word,
    values_in_words,
)
from donnie_tui.core.wording import spelled
from donnie_tui.i18n.words import Words
from donnie_tui.linear.prompter import prompt_text
from donnie_tui.settings.parsing import LONGEST_PROGRESS
from donnie_tui.settings.settings import Settings, resolve
from language.locales import languages

WORDS = Words("en")
WITH_VALUES = [
    pytest.param(each, value, id=f"{each.key}-{value}")
    for each in PREFERENCES
    if each.has_words
    for value in each.values
]
LISTED = [each for each in PREFERENCES if each.has_words]


def typed(key: str, text: str) -> str | None:
    return value_typed(BY_NAME[key], text, WORDS)


@pytest.mark.parametrize(("preference", "value"), WITH_VALUES)
def test_every_value_is_understood_in_every_language_and_from_the_settings(preference, value):
    for language in languages():
        word = value_word(preference, value, language)
        assert value_typed(preference, word, Words(language)) == value
        assert word in values_in_words(preference, Words(language))
    _, notices = resolve({}, {}, {preference.key: value})
    assert notices == ()


@pytest.mark.parametrize("preference", LISTED, ids=lambda each: each.key)
def test_every_name_is_found_in_every_language(preference):
    names = {spelled(preference.key, language, "settings").upper() for language in languages()}
    assert {find_preference(name, WORDS) for name in names} == {preference}


@pytest.mark.parametrize("preference", PREFERENCES, ids=lambda each: each.key)
def test_every_setting_has_a_label_and_a_sentence(preference):
    preferences = Preferences(Settings(), {})

    assert preferences.in_words(preference.key, WORDS).endswith(".")
    assert preferences.value_label(preference.key, WORDS)


@pytest.mark.parametrize(
    ("key", "text", "value"),
    [
        *(("progress", "0", "0"), ("progress", str(LONGEST_PROGRESS), str(LONGEST_PROGRESS))),
        *(("free", "f", "f"), ("free", "ponto", "dot"), ("page", "PERGUNTAR", "ask")),
        *(("prompt", "respuesta", "answer"), ("speech", "on", "tts"), ("speech", "não", "off")),
        *(("speech", "own", "tts"), ("speech", "robô", "robot"), ("speech", "ssip", "ssip")),
        *(("speech", "no", "off"), ("speak", "ambos", "both"), ("punctuation", "toda", "all")),
        *(("key_echo", "palavras", "words"), ("completion", "não", "off")),
    ],
)
def test_numbers_letters_and_words_of_other_languages_are_understood(key, text, value):
    assert typed(key, text) == value


@pytest.mark.parametrize(
    ("key", "text"),
    [("progress", "-1"), ("progress", "99999"), ("free", "ab"), ("free", "5"), ("page", "x"), ("hold", "")],
)
def test_what_is_no_value_is_refused(key, text):
    assert typed(key, text) is None


def test_a_wrong_value_in_the_settings_is_reported_and_the_default_counts():
    settings, notices = resolve({}, {}, {"progress": "often", "free": "~"})

    assert (settings.progress, settings.free) == (Settings().progress, Settings().free)
    assert {each.values["name"] for each in notices} == {"progress", "free"}


def test_a_setting_of_one_front_end_is_no_setting_of_the_other():
    assert {each.key for each in PREFERENCES if each.where is Where.LINEAR} == {
        *("page", "prompt", "hold", "editor", "enter", "progress", "free")
    }


@pytest.mark.parametrize(
    ("style", "prompts"),
    [
        ("short", ("> ", "2> ")),
        ("none", ("", "")),
        ("word", ("Donnie> ", "Donnie 2> ")),
        ("answer", ("> ", "2> ")),
    ],
)
def test_the_prompt_is_as_the_settings_say(style, prompts):
    settings = Settings(prompt=style)
    assert (prompt_text(settings, 0), prompt_text(settings, 2)) == prompts
