"""QUIET, CUES, the key echo, and SET for voice and cues: at once, kept, and always in print too."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from devices.sound.tones import CUE_NAMES
from donnie_tui.core.events import SoundSwitched, Spoke
from donnie_tui.i18n.catalogue import SENTENCES
from donnie_tui.linear.key_echo import KeyEcho
from donnie_tui.linear.keys import Act, Key
from donnie_tui.settings.chosen import Settings, resolve
from donnie_tui.settings.folders import settings_file
from donnie_tui.words.sound_words import (
    CUE_WORDS,
    SETTINGS,
    chime_block,
    find_cue,
    find_setting,
    play_cues,
    quiet,
    set_sound,
    tell_settings,
)
from tests.patience import PATIENCE
from tests.unit.cli.listening import HOME, Listening, listening


@pytest.fixture
def home(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[Listening]:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    with listening(monkeypatch) as made:
        yield made


def kept(folder: Path) -> dict[str, object]:
    return tomllib.loads(Path(settings_file({"XDG_CONFIG_HOME": str(folder)})).read_text())


# --- V3


def test_quiet_ends_voice_and_cues_and_is_answered_in_print(home: Listening) -> None:
    home.donnie.session.hub.publish(Spoke("A long sentence."))
    quiet(home.donnie)

    assert home.ear.heard[-2:] == ["(hush)", "(no cues)"]
    assert home.printed == ["A long sentence.", "Quiet. LAST says it again."]


def test_what_comes_after_a_key_is_said(home: Listening) -> None:
    """What SPEAK says is dropped by nobody but the key that ends it."""
    for text in ("one", "two"):
        home.donnie.session.hub.publish(Spoke(text))
    home.donnie.outlets.audible.hush()
    home.donnie.session.hub.publish(Spoke("three"))

    assert home.ear.heard == ["one", "two", "(hush)", "three"]


# --- CUES


def test_every_cue_sounds_with_its_name_a_line_each(home: Listening) -> None:
    """Q1, Q2: the sound first, then its sentence."""
    waits = list(play_cues(home.donnie, ""))

    assert [each.name for each in home.ear.cues] == list(CUE_WORDS)
    assert home.printed[0] == "14 sounds. Any key ends them."
    assert home.printed[1] == "forward: A step forward."
    assert home.ear.heard[1:3] == ["[step-forward]", "forward: A step forward."]
    assert len(home.printed) == 1 + len(CUE_NAMES)
    assert min(waits) > 0


def test_a_key_ends_the_cues(home: Listening) -> None:
    for _ in play_cues(home.donnie, ""):
        home.donnie.outlets.audible.hush()

    assert home.ear.cues == []


@pytest.mark.parametrize("typed", ["bump", "COLISÃO", "choque", "Colisao"])
def test_one_cue_is_asked_for_in_any_language(home: Listening, typed: str) -> None:
    list(play_cues(home.donnie, typed))

    assert (home.ear.cues[0].name, home.printed) == ("bump", ["bump: A collision."])


def test_an_unknown_cue_is_told(home: Listening) -> None:
    assert list(play_cues(home.donnie, "trumpet")) == []
    assert home.printed == ["No sound trumpet. CUES lists all."]


def test_where_nothing_sounds_the_names_come_at_once(home: Listening) -> None:
    home.donnie.session.hub.publish(SoundSwitched(False))
    del home.printed[:]

    assert list(play_cues(home.donnie, "")) == []
    assert home.printed[0] == "Sounds are off. SOUND ON turns them on."
    assert len(home.printed) == 1 + len(CUE_NAMES)
    assert home.ear.cues == []


def test_every_cue_has_a_name_in_three_languages_and_a_sentence() -> None:
    """Q2: the registry of cues and that of their words are the same."""
    assert tuple(sorted(CUE_WORDS)) == tuple(sorted(CUE_NAMES))
    assert {f"cue-{name}" for name in CUE_NAMES} <= set(SENTENCES)
    for at in range(3):
        assert len({words[at] for words in CUE_WORDS.values()}) == len(CUE_WORDS)
    assert [find_cue(word) for words in CUE_WORDS.values() for word in words] == [
        name for name in CUE_WORDS for _ in range(3)
    ]


def test_a_block_sounds_higher_the_deeper_it_is_and_closing_sounds_otherwise(home: Listening) -> None:
    """Q1."""
    for before, after in ((0, 1), (1, 2), (2, 2), (2, 1)):
        chime_block(home.donnie, before, after)

    assert [each.name for each in home.ear.cues] == ["block-opened", "block-opened", "block-closed"]
    outer, inner, closed = (each.steps for each in home.ear.cues)
    assert outer is not None and inner is not None
    assert inner < outer  # nearer is higher
    assert closed == inner


# --- SET


@pytest.mark.parametrize(
    ("typed", "field", "value", "told", "written"),
    [
        ("rate 300", "rate", 300, "Set rate: 300.", 300),
        ("rate 9999", "rate", 450, "Set rate: 450.", 450),
        ("tom 20", "pitch", 20, "Set pitch: 20.", 20),
        ("volumen 40%", "volume", 40, "Set volume: 40.", 40),
        ("punctuation all", "punctuation", "all", "Set punctuation: all.", "all"),
        ("eco palavras", "key_echo", "words", "Set echo: words.", "words"),
        ("wait on", "wait_for_speech", True, "Set wait: on.", "on"),
        ("speech off", "speech", "off", "Set speech: off.", "off"),
        ("speech on", "speech", "tts", "Set speech: own.", "tts"),
    ],
)
def test_a_setting_counts_at_once_and_is_kept(
    home: Listening, tmp_path: Path, typed: str, field: str, value: object, told: str, written: object
) -> None:
    """V6, S11."""
    name, _, rest = typed.partition(" ")
    found = find_setting(name)
    assert found is not None
    set_sound(home.donnie, found, rest)

    assert getattr(home.donnie.outlets.audible.settings, field) == value
    assert home.printed == [told]
    assert kept(tmp_path) == {field: written}
    again, notices = resolve({}, {}, kept(tmp_path))
    assert (getattr(again, field), notices) == (value, ())


def test_rate_pitch_and_volume_reach_the_voice_that_speaks(home: Listening) -> None:
    for field, typed in (("rate", "120"), ("pitch", "10"), ("volume", "50")):
        set_sound(home.donnie, field, typed)

    voice = home.ear.voices[-1]
    assert (voice.words_per_minute, voice.pitch, voice.volume) == (120, 10, 0.5)
    assert home.ear.opened == 1  # the same worker all the time


def test_the_channel_changes_while_donnie_runs(home: Listening) -> None:
    set_sound(home.donnie, "speech", "off")
    assert not home.donnie.outlets.audible.speaks
    home.donnie.session.hub.publish(Spoke("In print."))
    assert "In print." not in home.ear.heard

    set_sound(home.donnie, "speech", "tts")
    home.donnie.session.hub.publish(Spoke("Heard."))
    assert home.ear.heard[-1] == "Heard."


def test_a_voice_made_anew_is_as_silent_as_the_one_before(home: Listening) -> None:
    home.donnie.session.hub.publish(SoundSwitched(False))
    set_sound(home.donnie, "speech", "off")
    set_sound(home.donnie, "speech", "tts")
    home.donnie.session.hub.publish(Spoke("Nobody hears this."))

    assert "Nobody hears this." not in home.ear.heard
    assert not home.donnie.outlets.audible.has_cues


@pytest.mark.parametrize(
    ("typed", "volume", "told"), [("off", 0, "off"), ("50", 50, "50"), ("on", 100, "100")]
)
def test_each_cue_has_its_volume(home: Listening, tmp_path: Path, typed: str, volume: int, told: str) -> None:
    """C6, Q2."""
    set_sound(home.donnie, "cues", f"bump {typed}")

    assert home.printed == [f"Set cue bump: {told}."]
    assert home.ear.volumes == [{"bump": volume / 100}]
    assert kept(tmp_path) == {"cues": f"bump {volume}"}


def test_the_volumes_of_other_cues_stay(home: Listening, tmp_path: Path) -> None:
    set_sound(home.donnie, "cues", "bump off")
    set_sound(home.donnie, "cues", "scan 30")

    assert resolve({}, {}, kept(tmp_path))[0].cues == {"bump": 0, "scan": 30}


@pytest.mark.parametrize("typed", ["", "fast", "nan", "x" * 10_000])
def test_a_value_that_is_none_changes_nothing_and_tells_the_choices(home: Listening, typed: str) -> None:
    set_sound(home.donnie, "rate", typed)

    assert home.printed == ["Set rate: 180.", "Choose a number, 80 to 450."]
    assert home.ear.voices == []


def test_all_settings_are_told(home: Listening) -> None:
    tell_settings(home.donnie)
    assert len(home.printed) == len(SETTINGS)


def test_programs_wait_for_the_voice_as_soon_as_that_is_wanted(home: Listening) -> None:
    """S8."""
    asked: list[float] = []
    home.ear.wait_until_quiet = lambda seconds: asked.append(seconds) is None  # type: ignore[method-assign]
    set_sound(home.donnie, "wait_for_speech", "on")
    run = home.donnie.session.start("SPEAK 1", "a.gd")
    assert run.wait(PATIENCE)
    assert asked

    set_sound(home.donnie, "wait_for_speech", "off")
    asked.clear()
    run = home.donnie.session.start("SPEAK 1", "a.gd")
    assert run.wait(PATIENCE)
    assert asked == []


# --- V5


def typed_keys(home: Listening, text: str) -> list[str]:
    echo, before = KeyEcho(home.donnie.outlets.audible, home.donnie.words), ""
    for letter in text:
        echo(Key(Act.TEXT, letter), before)
        before += letter
    echo(Key(Act.ENTER), before)
    return home.ear.heard


@pytest.mark.parametrize(
    ("kind", "heard"),
    [
        ("none", []),
        ("characters", ["capital F.", "w.", "blank.", "3."]),
        ("words", ["Fw", "3"]),
    ],
)
def test_what_is_typed_is_said_as_somebody_wants_it(home: Listening, kind: str, heard: list[str]) -> None:
    home.donnie.outlets.adjust_sound(key_echo=kind)
    assert typed_keys(home, "Fw 3") == heard


def test_a_deleted_character_is_said(home: Listening) -> None:
    home.donnie.outlets.adjust_sound(key_echo="characters")
    KeyEcho(home.donnie.outlets.audible, home.donnie.words)(Key(Act.BACKSPACE), "x <")
    assert home.ear.heard == ["less sign."]


def test_beside_a_screen_reader_no_key_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    settings = Settings(speech="tts", key_echo="characters")
    with listening(monkeypatch, replace(HOME, screen_reader="orca"), settings) as made:
        assert typed_keys(made, "FW") == []


# --- V2, SPEAK here and there; S9 in the other mode


def test_the_other_mode_may_have_another_channel(monkeypatch: pytest.MonkeyPatch) -> None:
    """A screen reader reads the lines of one mode and not the screen of the other."""
    with listening(monkeypatch, settings=Settings(speech="tts")) as made:
        before = made.ear.opened
        made.donnie.outlets.audible.move_to(is_linear=True)
        assert made.ear.opened == before
        made.donnie.outlets.audible.move_to(is_linear=False)
        assert (made.ear.opened, made.ear.closed) == (before + 1, before)
