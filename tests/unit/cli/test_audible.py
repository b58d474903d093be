"""Voice and cues follow the settings and the environment. What is impossible is reported in one sentence."""

import re
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import pytest
from msgspec.structs import replace

from devices.audio.service import AudioSettings
from devices.ports.audio import SilentSpeaker, Utterance
from donnie_tui.commands.preferences import find_preference, value_typed
from donnie_tui.core.events import Announced, Chimed, SoundSwitched, Spoke
from donnie_tui.core.outlets import Voice, VoiceScope
from donnie_tui.core.transcript import printed_lines
from donnie_tui.i18n.words import Words
from donnie_tui.outlets import audible
from donnie_tui.outlets.audible import make_audible, wants_cues
from donnie_tui.settings.settings import Settings, SettingSource
from language.locales import languages
from tests.floor import Floor
from tests.sessions.learner import until
from tests.unit.audio.known_environment import KnownEnvironment
from tests.unit.ssip.server import Server

HOME = KnownEnvironment(
    stdout_is_terminal=True, over_ssh=False, screen_reader=None, has_voice=True, has_sound_device=True
)
ASKED = {"sound": SettingSource.OPTION}


class Noting(SilentSpeaker):
    """Records what it is to say, and how often it is silenced."""

    def __init__(self) -> None:
        self.said: list[str] = []
        self.silenced = 0

    def say(self, utterance: Utterance) -> None:
        self.said.append(utterance.text)

    def silence(self) -> None:
        self.silenced += 1


def facts(**changes: object) -> KnownEnvironment:
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
def test_cues_are_on_where_they_are_audible_or_asked_for(
    settings: Settings, around: KnownEnvironment, wanted: bool
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
        (
            "tts",
            facts(has_voice=False),
            ("There is no voice, because espeak-ng is missing. Sounds and print work.",),
        ),
        ("auto", facts(has_sound_device=False), ("There is no sound device. Everything is in print.",)),
    ],
)
def test_a_missing_device_is_reported_once(
    monkeypatch: pytest.MonkeyPatch, speech: str, around: KnownEnvironment, notices: tuple[str, ...]
) -> None:
    monkeypatch.setattr(audible, "DetectedEnvironment", lambda **_: around)
    with ExitStack() as closing:
        made = make_audible(Settings(speech=speech, sound=False), Floor().session, Words(), closing)

    assert made.notices == notices
    assert made.is_quiet_within(0)


@pytest.mark.parametrize(
    ("speech", "around", "sentences"),
    [
        ("auto", facts(screen_reader="orca"), "voice-for-reader"),
        ("auto", facts(over_ssh=True), "voice-over-ssh"),
        ("auto", facts(), "voice-own"),
        ("auto", facts(has_ssip=True), "voice-by-dispatcher"),
        ("auto", facts(has_ssip=True, screen_reader="orca", is_linear=False), "voice-after-reader"),
        ("tts", facts(), None),
        ("off", facts(screen_reader="orca"), None),
        ("auto", facts(stdout_is_terminal=False), None),
    ],
)
def test_a_default_voice_is_announced_with_the_word_that_changes_it(
    monkeypatch: pytest.MonkeyPatch, speech: str, around: KnownEnvironment, sentences: str | None
) -> None:
    """The greeting says which voice was chosen without a question."""
    monkeypatch.setattr(audible, "DetectedEnvironment", lambda **_: around)
    monkeypatch.setattr(audible._AudioAssembler, "make", lambda *_: SimpleNamespace())
    with ExitStack() as closing:
        decided = make_audible(
            Settings(speech=speech, sound=False), Floor().session, Words(), closing
        ).decided

    assert decided == sentences
    assert decided is None or "SET speech " in Words()(decided)


def test_announcements_are_sent_to_a_running_speech_dispatcher(
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


def test_a_speech_dispatcher_keeps_the_voice_settings_that_were_not_chosen(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """A learner with a screen reader has set the voice there, and everything else speaks as fast."""
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
    """A speech-dispatcher and a built-in voice that replace real ones."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.server, self.own = Noting(), Noting()
        monkeypatch.setattr(audible, "DetectedEnvironment", lambda **_: facts(has_ssip=True))
        monkeypatch.setattr(audible, "ssip_address", lambda _: "somewhere")
        monkeypatch.setattr("devices.audio.speech_dispatcher.SsipSpeaker", lambda *_: self.server)
        monkeypatch.setattr("devices.audio.service.AudioService", lambda *_: Noting())
        monkeypatch.setattr("devices.audio.service.make_speaker", lambda _: self.own)


@pytest.mark.parametrize(
    ("speak", "at_server", "own"),
    [("here", ["Moved.", "Hi."], []), ("robot", ["Moved."], ["Hi."]), ("both", ["Moved.", "Hi."], ["Hi."])],
)
def test_each_voice_says_its_part_and_silence_reaches_both(
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


@pytest.mark.parametrize("language", languages())
def test_a_lost_dispatcher_is_reported_once_with_a_remedy_that_works(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, language: str
) -> None:
    """The sentence is said once, with the remedy, and the remedy helps."""
    server = Server(tmp_path)
    monkeypatch.setenv("SPEECHD_ADDRESS", f"unix_socket:{server.address.path}")
    floor, words, sentences = Floor(), Words(language), list[str]()
    floor.session.hub.subscribe(lambda stamped: sentences.extend(printed_lines(stamped, words)))
    with ExitStack() as closing:
        made = make_audible(Settings(speech="ssip", sound=False), floor.session, words, closing)
        server.kill()
        Path(server.address.path).unlink()
        until(lambda: says(floor, "Hi.") and words("ssip-lost") in sentences)
        assert sentences.count(words("ssip-lost")) == 1

        server = Server(tmp_path)
        monkeypatch.setattr("devices.audio.channel.DetectedEnvironment.stdout_is_terminal", True)
        monkeypatch.setattr("devices.audio.channel.find_screen_reader", lambda *_: None)
        _, field, value = words("ssip-lost").split(". ")[-1].split()[:3]
        setting = find_preference(field, words)
        assert setting is not None
        made.adjust(**{setting.key: value_typed(setting, value, words)})
        says(floor, "Ho.")
        assert server.wait_for(texts=1)
        assert server.texts == ["Ho."]
    server.close()


def says(floor: Floor, sentence: str) -> bool:
    floor.session.hub.publish(Spoke(sentence))
    return True


def test_the_cues_report_that_no_device_works(monkeypatch: pytest.MonkeyPatch) -> None:
    """A device may exist and not open, which only the worker finds out."""
    monkeypatch.setattr(audible, "DetectedEnvironment", lambda **_: HOME)
    monkeypatch.setattr("devices.audio.service.AudioSettings", partial(AudioSettings, device="none"))
    floor, sentences = Floor(), list[str]()
    floor.session.hub.subscribe(lambda stamped: sentences.extend(printed_lines(stamped, Words())))
    with ExitStack() as closing:
        made = make_audible(Settings(speech="off"), floor.session, Words(), closing)
        assert made.has_cues
        floor.session.hub.publish(Chimed("bump"))
        until(lambda: not made.has_cues)

        assert made.why_no_cues == "cues-no-device"
        until(lambda: sentences == ["There is no sound device. Everything is in print."])


@pytest.mark.parametrize(
    ("speech", "is_on", "said"), [("ssip", True, ["Hi.", "Ho."]), ("ssip", False, []), ("robot", True, [])]
)
def test_lines_printed_earlier_are_said_by_the_voice_of_the_answers(
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
    ("scope", "heard"),
    [(VoiceScope.ALL, ["Moved.", "Hi."]), (VoiceScope.ANSWERS, ["Moved."]), (VoiceScope.PROGRAM, ["Hi."])],
)
def test_the_words_of_speak_can_have_another_voice(scope: VoiceScope, heard: list[str]) -> None:
    noting, floor = Noting(), Floor()
    floor.session.hub.subscribe(Voice(noting, Words(), scope))
    floor.session.hub.publish(Announced("moved", "Moved."))
    floor.session.hub.publish(Spoke("Hi."))
    assert noting.said == heard
