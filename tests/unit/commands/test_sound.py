"""QUIET, CUES, the key echo, and SET for voice and cues: effective at once, saved, and printed."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest
from msgspec.structs import replace

from devices.audio.cues import CUE_NAMES
from donnie_tui.commands.preferences import PREFERENCES, Where
from donnie_tui.commands.sound import CUES, chime_block, cue_meant, cue_word
from donnie_tui.core.events import SoundSwitched, Spoke
from donnie_tui.linear.line_editor import Act, EditorEcho, KeyPress
from donnie_tui.settings.folders import settings_file
from donnie_tui.settings.settings import Settings, resolve
from language.locales import languages
from tests.timeouts import TIMEOUT
from tests.unit.cli.listening import HOME, Listening, listening
from tests.unit.commands.scripted import Script
from tests.unit.i18n.sentences import CODES


@pytest.fixture
def home(monkeypatch: pytest.MonkeyPatch) -> Iterator[Listening]:
    with listening(monkeypatch) as made:
        yield made


def kept(folder: Path) -> dict[str, object]:
    return tomllib.loads(Path(settings_file({"XDG_CONFIG_HOME": str(folder)})).read_text())


# --- QUIET


def test_quiet_ends_voice_and_cues_and_is_answered_in_print(home: Listening) -> None:
    home.donnie.session.hub.publish(Spoke("A long sentence."))
    Script(home.donnie).type("QUIET")

    assert home.audio.heard[-2:] == ["(hush)", "(no cues)"]
    assert home.printed == ["A long sentence.", "Quiet. LAST says it again."]


def test_a_sentence_after_a_key_is_said(home: Listening) -> None:
    """Only the key that ends it drops what SPEAK says."""
    for text in ("one", "two"):
        home.donnie.session.hub.publish(Spoke(text))
    home.donnie.outlets.audible.hush()
    home.donnie.session.hub.publish(Spoke("three"))

    assert home.audio.heard == ["one", "two", "(hush)", "three"]


# --- CUES


def test_every_cue_sounds_with_its_name_a_line_each(home: Listening) -> None:
    """The sound comes first, then its sentence."""
    script = Script(home.donnie)
    script.type("CUES")

    assert [each.name for each in home.audio.cues] == list(CUES)
    assert home.printed[0] == "19 sounds. Any key ends them."
    assert home.printed[1] == "forward: A step forward."
    assert home.audio.heard[1:3] == ["[step-forward]", "forward: A step forward."]
    assert len(home.printed) == 1 + len(CUE_NAMES)
    assert min(script.interaction.waited) > 0


def test_a_key_ends_the_cues(home: Listening) -> None:
    script = Script(home.donnie)
    script.interaction.when_waiting = lambda: home.donnie.outlets.audible.hush() is not None
    script.type("CUES")

    assert home.audio.cues == []


@pytest.mark.parametrize(
    ("busy", "waited"), [(0, [0.05, 0.7]), (3, [0.05] * 4 + [0.7]), (1000, [0.05] * 100 + [0.7])]
)
def test_a_cue_is_followed_by_the_next_one_once_its_name_was_said(
    home: Listening, monkeypatch: pytest.MonkeyPatch, busy: int, waited: list[float]
) -> None:
    """A voice that does not end is waited for some seconds."""
    looks = iter(range(busy))
    audible = type(home.donnie.outlets.audible)
    monkeypatch.setattr(audible, "is_quiet_within", lambda _self, _seconds: next(looks, None) is None)
    script = Script(home.donnie)
    script.type("CUES bump")

    assert script.interaction.waited == pytest.approx(waited)


def test_a_screen_reader_has_two_seconds_for_the_name_of_a_cue(monkeypatch: pytest.MonkeyPatch) -> None:
    with listening(monkeypatch, settings=Settings(speech="text", sound=True)) as made:
        script = Script(made.donnie)
        script.type("CUES")

        assert script.interaction.waited == [2.0] * (1 + len(CUE_NAMES))


@pytest.mark.parametrize(("presses_at", "sounds"), [(1, 0), (2, 0), (3, 1), (5, 2)])
def test_a_key_ends_the_cues_after_the_one_that_sounds(home: Listening, presses_at: int, sounds: int) -> None:
    """The number is said first, then each cue; the wait for each is two looks."""
    script = Script(home.donnie)
    script.interaction.when_waiting = lambda: len(script.interaction.waited) == presses_at
    script.type("CUES")

    assert len(home.audio.cues) == sounds
    assert len(script.interaction.waited) == presses_at


def test_a_stop_of_the_voice_ends_the_cues_as_a_key_does(home: Listening) -> None:
    script = Script(home.donnie)
    script.interaction.when_waiting = lambda: (
        bool(home.donnie.outlets.audible.hush()) if home.audio.cues else False
    )
    script.type("CUES")

    assert [each.name for each in home.audio.cues] == [CUES[0]]


@pytest.mark.parametrize("typed", ["bump", "COLISÃO", "choque", "Colisao"])
def test_one_cue_is_asked_for_in_any_language(home: Listening, typed: str) -> None:
    Script(home.donnie).type(f"CUES {typed}")

    assert (home.audio.cues[0].name, home.printed) == ("bump", ["bump: A collision."])


def test_an_unknown_cue_is_reported(home: Listening) -> None:
    Script(home.donnie).type("CUES trumpet")

    assert home.printed == ["No sound trumpet. CUES lists all."]


def test_the_names_of_the_cues_are_printed_at_once_where_nothing_sounds(home: Listening) -> None:
    home.donnie.session.hub.publish(SoundSwitched(False))
    del home.printed[:]

    script = Script(home.donnie)
    script.type("CUES")

    assert script.interaction.waited == []
    assert home.printed[0] == "Sounds are off. SOUND ON turns them on."
    assert len(home.printed) == 1 + len(CUE_NAMES)
    assert home.audio.cues == []


def test_every_cue_has_a_name_in_three_languages_and_a_sentence() -> None:
    """The registry of cues and that of their words agree."""
    assert tuple(sorted(CUES)) == tuple(sorted(CUE_NAMES))
    assert {f"cue-{name}" for name in CUE_NAMES} <= set(CODES)
    for language in languages():
        words = [cue_word(cue, language) for cue in CUES]
        assert len(set(words)) == len(CUES)
        assert [cue_meant(word) for word in words] == list(CUES)


def test_a_deeper_block_sounds_higher_and_its_end_sounds_different(home: Listening) -> None:
    """A deeper block has a higher tone."""
    for before, after in ((0, 1), (1, 2), (2, 2), (2, 1)):
        chime_block(home.donnie, before, after)

    assert [each.name for each in home.audio.cues] == ["block-opened", "block-opened", "block-closed"]
    outer, inner, closed = (each.steps for each in home.audio.cues)
    assert outer is not None and inner is not None
    assert inner < outer  # nearer is higher
    assert closed == inner


# --- SET


@pytest.mark.parametrize(
    ("typed", "field", "value", "said", "written"),
    [
        ("rate 300", "rate", 300, "Set rate: 300.", 300),
        ("rate 9999", "rate", 450, "Set rate: 450.", 450),
        ("tom 20", "pitch", 20, "Set pitch: 20.", 20),
        ("volumen 40%", "volume", 40, "Set volume: 40.", 40),
        ("punctuation all", "punctuation", "all", "Set punctuation: all.", "all"),
        ("eco palavras", "key_echo", "words", "Set echo: words.", "words"),
        ("wait on", "wait_for_speech", True, "Set wait: on.", True),
        ("speech off", "speech", "off", "Set speech: off.", "off"),
        ("speech on", "speech", "tts", "Set speech: own.", "tts"),
    ],
)
def test_a_setting_counts_at_once_and_is_kept(
    home: Listening, tmp_path: Path, typed: str, field: str, value: object, said: str, written: object
) -> None:
    """Rate, pitch, volume and voice count for the next sentence."""
    Script(home.donnie).type(f"SET {typed}")

    assert getattr(home.donnie.outlets.audible.settings, field) == value
    assert home.printed == [said]
    assert kept(tmp_path) == {field: written}
    again, notices = resolve({}, {}, kept(tmp_path))
    assert (getattr(again, field), notices) == (value, ())


def test_rate_pitch_and_volume_reach_the_voice_that_speaks(home: Listening) -> None:
    script = Script(home.donnie)
    for typed in ("rate 120", "pitch 10", "volume 50"):
        script.type(f"SET {typed}")

    voice = home.audio.voices[-1]
    assert (voice.words_per_minute, voice.pitch, voice.volume) == (120, 10, 0.5)
    assert home.audio.opened == 1  # the same worker all the time


def test_the_channel_changes_while_donnie_runs(home: Listening) -> None:
    Script(home.donnie).type("SET speech off")
    assert not home.donnie.outlets.audible.speaks
    home.donnie.session.hub.publish(Spoke("In print."))
    assert "In print." not in home.audio.heard

    Script(home.donnie).type("SET speech tts")
    home.donnie.session.hub.publish(Spoke("Heard."))
    assert home.audio.heard[-1] == "Heard."


def test_a_voice_made_anew_is_as_silent_as_the_one_before(home: Listening) -> None:
    home.donnie.session.hub.publish(SoundSwitched(False))
    Script(home.donnie).type("SET speech off")
    Script(home.donnie).type("SET speech tts")
    home.donnie.session.hub.publish(Spoke("Nobody hears this."))

    assert "Nobody hears this." not in home.audio.heard
    assert not home.donnie.outlets.audible.has_cues


@pytest.mark.parametrize(
    ("typed", "volume", "said"), [("off", 0, "off"), ("50", 50, "50"), ("on", 100, "100")]
)
def test_each_cue_has_its_volume(home: Listening, tmp_path: Path, typed: str, volume: int, said: str) -> None:
    """Each family of cues has its own volume."""
    Script(home.donnie).type(f"SET cue bump {typed}")

    assert home.printed == [f"Set cue bump: {said}."]
    assert home.audio.volumes == [{"bump": volume / 100}]
    assert kept(tmp_path) == {"cues": f"bump {volume}"}


def test_the_volumes_of_other_cues_stay(home: Listening, tmp_path: Path) -> None:
    script = Script(home.donnie)
    script.type("SET cue bump off")
    script.type("SET cue scan 30")

    assert resolve({}, {}, kept(tmp_path))[0].cues == {"bump": 0, "scan": 30}


@pytest.mark.parametrize("typed", ["", "fast", "nan", "x" * 10_000])
def test_a_wrong_value_changes_nothing_and_lists_the_possible_values(home: Listening, typed: str) -> None:
    Script(home.donnie).type(f"SET rate {typed}")

    assert home.printed == ["Set rate: 180.", "Choose a number, 80 to 450."]
    assert home.audio.voices == []


def test_all_settings_are_listed(home: Listening) -> None:
    Script(home.donnie).type("SET")

    listed = [each for each in PREFERENCES if each.has_words and each.where is not Where.SCREEN]
    assert len(home.printed) == len(listed)


def test_programs_wait_for_the_voice_as_soon_as_that_is_set(home: Listening) -> None:
    """SET waits is on: a program continues after its sentence was said."""
    asked: list[float] = []
    home.audio.wait_until_quiet = lambda seconds: asked.append(seconds) is None  # type: ignore[method-assign]
    Script(home.donnie).type("SET wait on")
    run = home.donnie.session.start("SPEAK 1", "a.gd")
    assert run.wait(TIMEOUT)
    assert asked

    Script(home.donnie).type("SET wait off")
    asked.clear()
    run = home.donnie.session.start("SPEAK 1", "a.gd")
    assert run.wait(TIMEOUT)
    assert asked == []


# --- key echo


def typed_keys(home: Listening, text: str) -> list[str]:
    echo, before = EditorEcho(home.donnie.outlets.audible, home.donnie.words), ""
    for letter in text:
        echo(KeyPress(Act.TEXT, letter), before)
        before += letter
    echo(KeyPress(Act.ENTER), before)
    return home.audio.heard


@pytest.mark.parametrize(
    ("kind", "heard"),
    [
        ("none", []),
        ("characters", ["capital F.", "w.", "blank.", "3."]),
        ("words", ["Fw", "3"]),
    ],
)
def test_typed_text_is_said_by_keys_or_by_words_as_set(home: Listening, kind: str, heard: list[str]) -> None:
    home.donnie.outlets.adjust_sound(key_echo=kind)
    assert typed_keys(home, "Fw 3") == heard


def test_a_deleted_character_is_said(home: Listening) -> None:
    home.donnie.outlets.adjust_sound(key_echo="characters")
    EditorEcho(home.donnie.outlets.audible, home.donnie.words)(KeyPress(Act.BACKSPACE), "x <")
    assert home.audio.heard == ["less-than sign."]


def test_no_key_is_said_while_a_screen_reader_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    settings = Settings(speech="tts", key_echo="characters")
    with listening(monkeypatch, replace(HOME, screen_reader="orca"), settings) as made:
        assert typed_keys(made, "FW") == []


# --- SPEAK on another channel, and the channel of the other mode


def test_the_other_mode_may_have_another_channel(monkeypatch: pytest.MonkeyPatch) -> None:
    """A screen reader reads the lines of one mode and not the screen of the other."""
    with listening(monkeypatch, settings=Settings(speech="tts")) as made:
        before = made.audio.opened
        made.donnie.outlets.audible.move_to(is_linear=True)
        assert made.audio.opened == before
        made.donnie.outlets.audible.move_to(is_linear=False)
        assert (made.audio.opened, made.audio.closed) == (before + 1, before)
