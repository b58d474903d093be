"""Voice and cues as the settings and the surroundings allow; what is not possible is told in one sentence."""

import re
from contextlib import ExitStack
from dataclasses import replace
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import pytest

from devices.audio_worker.service import AudioSettings
from devices.ports.audio import Utterance
from devices.speech.choose import Facts
from devices.speech.silent import SilentSpeaker
from donnie_tui import LANGUAGES
from donnie_tui.core.events import Announced, Chimed, SoundSwitched, Spoke
from donnie_tui.core.outlets import Hears, Voice
from donnie_tui.core.transcript import told_lines
from donnie_tui.i18n.words import Words
from donnie_tui.outlets import audible
from donnie_tui.outlets.audible import make_audible, wants_cues
from donnie_tui.settings.chosen import Settings, Source
from donnie_tui.words.sound_words import find_setting, read_setting
from tests.floor import Floor
from tests.sessions.learner import until
from tests.unit.ssip.server import Server

HOME = Facts(
    stdout_is_terminal=True, over_ssh=False, screen_reader=None, has_voice=True, has_sound_device=True
)
ASKED = {"sound": Source.OPTION}


class Noting(SilentSpeaker):
    """Notes what it is to say, and how often it is silenced."""

    def __init__(self) -> None:
        self.said: list[str] = []
        self.silenced = 0

    def say(self, utterance: Utterance) -> None:
        self.said.append(utterance.text)

    def silence(self) -> None:
        self.silenced += 1


def facts(**changes: object) -> Facts:
    return replace(HOME, **changes)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("settings", "around", "wanted"),
    [
        (Settings(), HOME, True),
        (Settings(sound=False), HOME, False),
        (Settings(), facts(has_sound_device=False), False),
        (Settings(), facts(over_ssh=True), False),
        (Settings(sources=ASKED), facts(over_ssh=True), True),
        (Settings(), facts(stdout_is_terminal=False), False),
        (Settings(sources=ASKED), facts(stdout_is_terminal=False), True),
    ],
)
def test_cues_are_for_who_hears_them_or_asked_for_them(
    settings: Settings, around: Facts, wanted: bool
) -> None:
    assert wants_cues(settings, around) is wanted


@pytest.mark.parametrize(
    ("speech", "around", "notices"),
    [
        ("off", HOME, ()),
        ("auto", facts(stdout_is_terminal=False), ()),
        ("auto", facts(screen_reader="orca"), ()),
        ("auto", facts(over_ssh=True), ()),
        ("ssip", HOME, ("No speech-dispatcher here. All is in print.",)),
        ("tts", facts(has_voice=False), ("No voice, espeak-ng is missing. Sounds and print work.",)),
        ("auto", facts(has_sound_device=False), ("No sound device. Everything is in print.",)),
    ],
)
def test_what_is_missing_is_told_once(
    monkeypatch: pytest.MonkeyPatch, speech: str, around: Facts, notices: tuple[str, ...]
) -> None:
    monkeypatch.setattr(audible, "look_around", lambda **_: around)
    with ExitStack() as closing:
        made = make_audible(Settings(speech=speech, sound=False), Floor().session, Words(), closing)

    assert made.notices == notices
    assert made.is_quiet_within(0)


@pytest.mark.parametrize(
    ("speech", "around", "told"),
    [
        ("auto", facts(screen_reader="orca"), "voice-for-reader"),
        ("auto", facts(over_ssh=True), "voice-over-ssh"),
        ("auto", facts(), "voice-own"),
        ("auto", facts(has_ssip=True), "voice-by-dispatcher"),
        ("auto", facts(has_ssip=True, screen_reader="orca", is_linear=False), "voice-behind-reader"),
        ("tts", facts(), None),
        ("off", facts(screen_reader="orca"), None),
        ("auto", facts(stdout_is_terminal=False), None),
    ],
)
def test_what_is_decided_unasked_has_a_sentence_with_the_word_that_changes_it(
    monkeypatch: pytest.MonkeyPatch, speech: str, around: Facts, told: str | None
) -> None:
    """V1."""
    monkeypatch.setattr(audible, "look_around", lambda **_: around)
    monkeypatch.setattr(audible._Maker, "make", lambda *_: SimpleNamespace())
    with ExitStack() as closing:
        decided = make_audible(
            Settings(speech=speech, sound=False), Floor().session, Words(), closing
        ).decided

    assert decided == told
    assert decided is None or "SET speech " in Words()(decided)


def test_what_is_told_goes_to_a_speech_dispatcher_that_is_there(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    server = Server(tmp_path)
    monkeypatch.setenv("SPEECHD_ADDRESS", f"unix_socket:{server.address.path}")
    floor = Floor()
    with ExitStack() as closing:
        made = make_audible(Settings(speech="ssip", sound=False), floor.session, Words(), closing)
        floor.session.hub.publish(Spoke("Hello."))
        assert made.is_quiet_within(10)
        floor.session.hub.publish(SoundSwitched(False))
        floor.session.hub.publish(Spoke("Not heard."))
        floor.session.hub.publish(SoundSwitched(True))
        assert made.speaks
        assert made.is_quiet_within(10)
        assert made.notices == ()
    assert server.texts == ["Hello.", "Sound on."]
    server.close()


def test_a_speech_dispatcher_keeps_of_its_voice_what_nobody_chose(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Whoever has a screen reader has set it there, and hears all else as fast."""
    server = Server(tmp_path)
    monkeypatch.setenv("SPEECHD_ADDRESS", f"unix_socket:{server.address.path}")
    floor = Floor()
    with ExitStack() as closing:
        made = make_audible(Settings(speech="ssip", sound=False), floor.session, Words(), closing)
        for changed in ({"punctuation": "all"}, {"volume": 50}):
            made.adjust(**changed)
            floor.session.hub.publish(Spoke("x=1"))
            assert made.is_quiet_within(10)
    assert server.texts == ["x equals 1", "x equals 1"]
    assert [each for each in server.commands if re.search("RATE|PITCH|VOLUME", each)] == ["SET SELF VOLUME 0"]
    server.close()


class TwoVoices:
    """A speech-dispatcher and a voice of our own, in the place of real ones."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.server, self.own = Noting(), Noting()
        monkeypatch.setattr(audible, "look_around", lambda **_: facts(has_ssip=True))
        monkeypatch.setattr(audible, "ssip_address", lambda _: "somewhere")
        monkeypatch.setattr("devices.ssip.speaker.SsipSpeaker", lambda *_: self.server)
        monkeypatch.setattr("devices.audio_worker.factory.make_audio", lambda *_: Noting())
        monkeypatch.setattr("devices.audio_worker.factory.make_speaker", lambda _: self.own)


@pytest.mark.parametrize(
    ("speak", "at_server", "own"),
    [("here", ["Moved.", "Hi."], []), ("robot", ["Moved."], ["Hi."]), ("both", ["Moved.", "Hi."], ["Hi."])],
)
def test_each_voice_says_its_part_and_every_voice_is_silenced(
    monkeypatch: pytest.MonkeyPatch, speak: str, at_server: list[str], own: list[str]
) -> None:
    voices, floor = TwoVoices(monkeypatch), Floor()
    with ExitStack() as closing:
        settings = Settings(speech="ssip", speak=speak, sound=False)
        made = make_audible(settings, floor.session, Words(), closing)
        floor.session.hub.publish(Announced("moved", "Moved."))
        floor.session.hub.publish(Spoke("Hi."))
        made.hush()

    assert (voices.server.said, voices.own.said) == (at_server, own)
    assert voices.server.silenced == 1
    assert voices.own.silenced == bool(own)


@pytest.mark.parametrize("language", LANGUAGES)
def test_who_lost_the_dispatcher_is_told_what_brings_it_back(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, language: str
) -> None:
    """S6: said once, with the remedy, and that helps."""
    server = Server(tmp_path)
    monkeypatch.setenv("SPEECHD_ADDRESS", f"unix_socket:{server.address.path}")
    floor, words, told = Floor(), Words(language), list[str]()
    floor.session.hub.subscribe(lambda stamped: told.extend(told_lines(stamped, words)))
    with ExitStack() as closing:
        made = make_audible(Settings(speech="ssip", sound=False), floor.session, words, closing)
        server.go_away()
        Path(server.address.path).unlink()
        until(lambda: says(floor, "Hi.") and words("ssip-lost") in told)
        assert told.count(words("ssip-lost")) == 1

        server = Server(tmp_path)
        monkeypatch.setattr("devices.speech.probe._stdout_is_terminal", lambda: True)
        monkeypatch.setattr("devices.speech.probe.find_screen_reader", lambda *_: None)
        _, field, value = words("ssip-lost").split(". ")[-1].split()[:3]
        setting = find_setting(field)
        assert setting is not None
        made.adjust(**{setting: read_setting(setting, value)})
        says(floor, "Ho.")
        assert server.wait_for(texts=1)
        assert server.texts == ["Ho."]
    server.close()


def says(floor: Floor, sentence: str) -> bool:
    floor.session.hub.publish(Spoke(sentence))
    return True


def test_where_no_device_works_the_cues_say_so(monkeypatch: pytest.MonkeyPatch) -> None:
    """Q4: one may be there that can't be opened, which only its worker finds out."""
    monkeypatch.setattr(audible, "look_around", lambda **_: HOME)
    monkeypatch.setattr("devices.audio_worker.service.AudioSettings", partial(AudioSettings, device="none"))
    floor, told = Floor(), list[str]()
    floor.session.hub.subscribe(lambda stamped: told.extend(told_lines(stamped, Words())))
    with ExitStack() as closing:
        made = make_audible(Settings(speech="off"), floor.session, Words(), closing)
        assert made.has_cues
        floor.session.hub.publish(Chimed("bump"))
        until(lambda: not made.has_cues)

        assert made.why_no_cues == "cues-no-device"
        until(lambda: told == ["No sound device. Everything is in print."])


@pytest.mark.parametrize(
    ("speech", "is_on", "said"), [("ssip", True, ["Hi.", "Ho."]), ("ssip", False, []), ("robot", True, [])]
)
def test_what_stood_printed_before_is_said_by_who_says_the_answers(
    monkeypatch: pytest.MonkeyPatch, speech: str, is_on: bool, said: list[str]
) -> None:
    voices, floor = TwoVoices(monkeypatch), Floor()
    with ExitStack() as closing:
        made = make_audible(Settings(speech=speech, sound=False), floor.session, Words(), closing)
        if not is_on:
            floor.session.hub.publish(SoundSwitched(False))
        made.say_printed("Hi.", "Ho.")

    assert (voices.server.said, voices.own.said) == (said, [])


@pytest.mark.parametrize(
    ("hears", "heard"),
    [(Hears.ALL, ["Moved.", "Hi."]), (Hears.ANSWERS, ["Moved."]), (Hears.PROGRAM, ["Hi."])],
)
def test_the_words_of_speak_can_be_heard_elsewhere(hears: Hears, heard: list[str]) -> None:
    noting, floor = Noting(), Floor()
    floor.session.hub.subscribe(Voice(noting, Words(), hears))
    floor.session.hub.publish(Announced("moved", "Moved."))
    floor.session.hub.publish(Spoke("Hi."))
    assert noting.said == heard
