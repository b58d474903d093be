"""Yes and no, on and off have the same words wherever they are typed."""

import pytest

from donnie_tui.commands.interaction import answered, detail_named, switched
from donnie_tui.commands.preferences import BY_NAME, value_typed
from donnie_tui.commands.sound import cue_volume_typed
from donnie_tui.core.wording import language_named, spelled
from donnie_tui.i18n.words import Words
from language.locales import languages

ON = ("on", "ON", "yes", "ligado", "ligar", "sim", "encendido", "encender", "sí", "si\u0301", "si")
OFF = ("off", "no", "desligado", "desligar", "não", "nao", "apagado", "apagar")


@pytest.mark.parametrize(
    ("typed", "is_on"), [*((each, True) for each in ON), *((each, False) for each in OFF)]
)
def test_a_word_that_switches_one_thing_switches_every_thing(typed, is_on):
    assert switched(typed) is is_on
    for key in ("hold", "clock", "wait_for_speech"):
        assert value_typed(BY_NAME[key], typed, Words("en")) == ("on" if is_on else "off")
    assert value_typed(BY_NAME["speech"], typed, Words("en")) == ("tts" if is_on else "off")
    assert cue_volume_typed(typed) == (100 if is_on else 0)


@pytest.mark.parametrize("typed", ["y", "YES", "s", "sim", "sí", "si"])
def test_yes_is_understood_in_every_language(typed):
    assert answered(f" {typed} ") is True


@pytest.mark.parametrize("typed", ["n", "NO", "não", "nao"])
def test_no_is_understood_in_every_language(typed):
    assert answered(typed) is False


@pytest.mark.parametrize("typed", ["", "1", "maybe", "yesno", "on off"])
def test_anything_else_is_neither(typed):
    assert answered(typed) is None
    assert switched(typed) is None


@pytest.mark.parametrize("language", languages())
def test_offered_words_are_understood(language):
    assert switched(spelled("on", language, "switch")) is True
    assert switched(spelled("off", language, "switch")) is False


@pytest.mark.parametrize(
    ("typed", "language"),
    [("Português", "pt"), ("inglés", "en"), ("ES", "es"), ("pt-br", "pt"), ("de", None), ("", None)],
)
def test_a_language_has_a_name_in_each_language(typed, language):
    assert language_named(typed) == language


@pytest.mark.parametrize(
    ("typed", "detail"), [("breve", "brief"), ("NORMAL", "normal"), ("cheio", "full"), ("much", None)]
)
def test_a_detail_has_words_in_each_language(typed, detail):
    assert detail_named(typed) == detail
