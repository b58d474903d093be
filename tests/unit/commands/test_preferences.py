"""The settings that the learner changes: their words in each language, and their values as they are kept."""

import pytest
from msgspec.structs import replace

from donnie_tui.commands.preferences import (
    BY_NAME,
    PREFERENCES,
    Preferences,
    Where,
    find_preference,
    setting_word,
    value_typed,
    value_word,
    values_in_words,
)
from donnie_tui.core.wording import spelled
from donnie_tui.i18n.words import Words
from donnie_tui.linear.prompter import prompt_text
from donnie_tui.settings.parsing import LONGEST_PROGRESS
from donnie_tui.settings.settings import Settings, SettingSource, resolve
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


# --- the present value, as it is kept and as it is said

CHANGED = [
    # setting, value, in the settings file, in a list in English and in Portuguese
    ("cues", {}, "", "all on", "todos ligados"),
    ("cues", {"bump": 50, "scan": 0}, "bump 50, scan 0", "bump 50, scan 0", "colisão 50, olhar 0"),
    ("keys", "", "", "as usual", "as de sempre"),
    (
        *("keys", "run f9, step ctrl+k 5", "run f9, step ctrl+k 5"),
        *("F9 RUN, Ctrl+K 5 STEP", "F9 EXECUTAR, Ctrl+K 5 PASSO"),
    ),
    ("speed", 2.5, "2.5", "2.5", "2,5"),
    ("speed", 2.0, "2", "2", "2"),
    ("speed", None, "max", "max", "máxima"),
    ("volume", 30, "30", "30", "30"),
    ("sound", True, "on", "on", "ligado"),
    ("sound", False, "off", "off", "desligado"),
    ("plain", None, "off", "off", "desligado"),
    ("plain", True, "on", "on", "ligado"),
    ("theme", "contrast", "contrast", "high contrast", "alto contraste"),
    ("language", "es", "es", "Spanish", "espanhol"),
    ("free", "dot", "dot", "dot", "ponto"),
    ("free", "x", "x", "x", "x"),
]


@pytest.mark.parametrize(("name", "value", "kept", "english", "portuguese"), CHANGED)
def test_a_value_is_kept_in_english_and_listed_in_the_language(name, value, kept, english, portuguese):
    key = {"language": "lang"}.get(name, name)
    preferences = Preferences(replace(Settings(), **{name: value}), {})

    assert preferences.value(key) == kept
    assert preferences.value_label(key, Words("en")) == english
    assert preferences.value_label(key, Words("pt")) == portuguese


@pytest.mark.parametrize(
    ("key", "value", "said"),
    [
        ("progress", "0", "Progress reports, progress: never."),
        ("progress", "30", "Progress reports, progress: 30 seconds."),
        ("volume", 30, "Set volume: 30."),
        ("speed", None, "Speed: max."),
        ("page", "ask", "Long answers, page: ask."),
        ("cues", {"bump": 5}, "Sounds, each: bump 5."),
    ],
)
def test_a_setting_is_said_with_its_value(key, value, said):
    assert Preferences(replace(Settings(), **{key: value}), {}).in_words(key, WORDS) == said


@pytest.mark.parametrize(
    ("key", "said"),
    [
        ("rate", "Choose a number, 80 to 450."),
        ("volume", "Choose a number, 0 to 100."),
        ("speed", "A number from 0.1 to 1000, or max:"),
        ("free", "Choose: dot, f."),
        ("page", "Choose: rest, ask, off."),
        ("progress", "Choose: 0 10 60."),
        ("punctuation", "Choose: none, some, all."),
    ],
)
def test_what_a_setting_can_be_is_said(key, said):
    assert values_in_words(BY_NAME[key], WORDS) == said


@pytest.mark.parametrize(
    ("key", "english", "portuguese"),
    [
        ("lang", "language", "idioma"),
        ("theme", "look", "aparência"),
        ("cues", "cues", "cues"),
        ("key_echo", "echo", "eco"),
        ("goals", "goals", "metas"),
    ],
)
def test_a_setting_is_typed_by_a_word(key, english, portuguese):
    assert (setting_word(key, Words("en")), setting_word(key, Words("pt"))) == (english, portuguese)
    assert find_preference(english, Words("en")) is BY_NAME[key]
    assert find_preference(portuguese, Words("pt")) is BY_NAME[key]


@pytest.mark.parametrize(
    ("typed", "key"), [("Language", "lang"), ("LOOK", "theme"), ("key_echo", "key_echo")]
)
def test_a_setting_is_found_by_its_label_and_its_name_in_the_file(typed, key):
    assert find_preference(typed, WORDS) is BY_NAME[key]
    assert find_preference("nothing", WORDS) is None


def test_a_value_that_is_chosen_is_the_learners_own_and_a_wrong_one_is_refused():
    preferences = Preferences(Settings(speed=2.0), {})
    for key, text in (("speed", "fast"), ("keys", "dance f6"), ("progress", "-1")):
        with pytest.raises(ValueError):
            preferences.choose(key, text)
    assert preferences.settings == Settings(speed=2.0)
    for key, text in (("speed", "3"), ("keys", "run f9"), ("clock", "on")):
        preferences.choose(key, text)

    assert (preferences.settings.speed, preferences.settings.keys, preferences.settings.clock) == (
        *(3.0, "run f9", "on"),
    )
    assert {*preferences.settings.sources} >= {"speed", "keys", "clock"}
    assert preferences.settings.source_of("clock") is SettingSource.OPTION
    assert preferences.settings.source_of("volume") is SettingSource.DEFAULT
