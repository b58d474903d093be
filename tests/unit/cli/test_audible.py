"""Voice and cues follow the settings and the environment. What is impossible is reported in one sentence."""

import re
from collections.abc import Callable
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from types import SimpleNamespace
from typing import Any, Self

import pytest
from msgspec.structs import replace

from devices.audio.pronunciation import SignWords, SpokenLanguage
from devices.audio.service import AudioSettings
from devices.ports.audio import (
    AudioNotice,
    NoticeCode,
    Urgency,
    Utterance,
    VoiceSettings,
)
from donnie_tui.commands.preferences import find_preference, value_typed
from donnie_tui.core.events import Announced, Answered, Chimed, Event, SoundSwitched, Spoke, Stamped
from donnie_tui.core.transcript import printed_lines
from donnie_tui.core.voice import Voice, VoiceScope
from donnie_tui.i18n.words import Words
from donnie_tui.outlets import audible
from donnie_tui.outlets.audible import TypingEcho, make_audible, wants_cues
from donnie_tui.settings.settings import Settings, SettingSource
from language.locales import languages
from tests.floor import Floor
from tests.sessions.learner import until
from tests.unit.audio.known_environment import KnownEnvironment
from tests.unit.cli.listening import RecordingAudio
from tests.unit.ssip.server import Server

HOME = KnownEnvironment(
    stdout_is_terminal=True, over_ssh=False, screen_reader=None, has_voice=True, has_sound_device=True
)
ASKED = {"sound": SettingSource.OPTION}


class Noting:
    """Records what it is to say, and how often it is silenced."""

    def __init__(self) -> None:
        self.said: list[str] = []
        self.silenced = 0

    def say(self, utterance: Utterance) -> None:
        self.said.append(utterance.text)

    def silence_speech(self) -> None:
        self.silenced += 1

    def close(self) -> None:
        """Nothing is held."""


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
        (Settings(sources=ASKED), facts(has_sound_device=False), False),
        (Settings(sound="a.wav", sources=ASKED), HOME, False),
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
        made = make_audible(Settings(speech=speech, sound=False), Floor().session.hub, Words(), closing)

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
    monkeypatch.setattr("devices.audio.service.AudioService", lambda *_: Noting())
    monkeypatch.setattr("devices.audio.speech_dispatcher.SsipSpeaker", lambda *_: Noting())
    monkeypatch.setattr(audible, "ssip_address", lambda _: "somewhere")
    with ExitStack() as closing:
        decided = make_audible(
            Settings(speech=speech, sound=False), Floor().session.hub, Words(), closing
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
        made = make_audible(Settings(speech="ssip", sound=False), floor.session.hub, Words(), closing)
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
        made = make_audible(Settings(speech="ssip", sound=False), floor.session.hub, Words(), closing)
        for changed in ({"punctuation": "all"}, {"volume": 50}):
            made.adjust(**changed)
            floor.session.hub.publish(Spoke("x=1"))
            assert made.is_quiet_within(10)
    assert server.texts == ["x equals 1", "x equals 1"]
    assert [each for each in server.commands if re.search("RATE|PITCH|VOLUME", each)] == ["SET SELF VOLUME 0"]
    server.close()


# --- one worker with the voice and the cues


class Worker(RecordingAudio):
    """Records what it was opened with, and how long it was waited for."""

    def __init__(self) -> None:
        super().__init__()
        self.settings: list[AudioSettings] = []
        self.report: Callable[[AudioNotice], None] = lambda _: None
        self.is_quiet = self.is_silent = True
        self.waited: list[tuple[str, float]] = []

    def open(self, settings: AudioSettings, report: Callable[[AudioNotice], None]) -> Self:
        self.settings.append(settings)
        self.report = report
        return self

    def wait_until_quiet(self, seconds: float) -> bool:
        self.waited.append(("voice", seconds))
        return self.is_quiet

    def wait_until_silent(self, seconds: float) -> bool:
        self.waited.append(("cues", seconds))
        return self.is_silent


class OneWorker:
    """Voice and cues of a session, with a recording worker."""

    def __init__(self, around: KnownEnvironment, settings: Settings, language: str = "en") -> None:
        self.worker, self.floor, self.closing = Worker(), Floor(), ExitStack()
        self.facts: list[dict[str, object]] = []
        with pytest.MonkeyPatch.context() as patch:
            self._patch(patch, around)
            self.audible = make_audible(settings, self.floor.session.hub, Words(language), self.closing)

    def _patch(self, patch: pytest.MonkeyPatch, around: KnownEnvironment) -> None:
        def environment(**given: object) -> KnownEnvironment:
            self.facts.append(given)
            return around

        self._around = around
        patch.setattr(audible, "DetectedEnvironment", environment)
        patch.setattr("devices.audio.service.AudioService", self.worker.open)

    def adjust(self, **changed: object) -> None:
        with pytest.MonkeyPatch.context() as patch:
            self._patch(patch, self._around)
            self.audible.adjust(**changed)

    def move_to(self, *, is_linear: bool) -> None:
        with pytest.MonkeyPatch.context() as patch:
            self._patch(patch, self._around)
            self.audible.move_to(is_linear=is_linear)

    def happens(self, *events: Event) -> None:
        for each in events:
            self.floor.session.hub.publish(each)


OFF = SoundSwitched(False)


@pytest.mark.parametrize(
    ("settings", "around", "is_mute", "events", "code"),
    [
        (Settings(), HOME, False, (), None),
        (Settings(), HOME, False, (OFF, SoundSwitched(True)), None),
        (Settings(), HOME, False, (OFF,), "cues-switched-off"),
        (Settings(), HOME, True, (), "cues-no-device"),
        (Settings(), HOME, True, (OFF,), "cues-no-device"),
        (Settings(speech="off"), facts(has_sound_device=False), False, (), "cues-no-device"),
        (Settings(speech="off", sound=False), facts(has_sound_device=False), False, (), "cues-silent"),
        (Settings(sound=False), HOME, False, (), "cues-silent"),
        (Settings(speech="off"), facts(over_ssh=True), False, (), "cues-silent"),
    ],
)
def test_why_no_cue_sounds(
    settings: Settings, around: KnownEnvironment, is_mute: bool, events: tuple[Event, ...], code: str | None
) -> None:
    made = OneWorker(around, settings)
    made.worker.is_mute = is_mute
    made.happens(*events)

    assert made.audible.has_cues is (code is None)
    assert code is None or made.audible.why_no_cues == code


@pytest.mark.parametrize(
    ("settings", "heard"),
    [
        (Settings(), ["(hush)", "(no cues)"]),
        (Settings(sound=False), ["(hush)"]),
        (Settings(speech="off"), ["(no cues)"]),
    ],
)
def test_the_voice_and_the_cues_can_be_silenced(settings: Settings, heard: list[str]) -> None:
    made = OneWorker(HOME, settings)
    made.audible.hush_all()

    assert made.worker.heard == heard
    assert made.audible.hushed == 1


@pytest.mark.parametrize(
    ("settings", "around", "events", "is_said"),
    [
        (Settings(speech="tts"), HOME, (), True),
        (Settings(speech="tts"), HOME, (OFF,), False),
        (Settings(speech="tts"), facts(screen_reader="orca"), (), False),
        (Settings(speech="off"), HOME, (), False),
        (Settings(speech="robot"), HOME, (), False),
    ],
)
def test_the_own_voice_says_typed_keys_unless_a_screen_reader_does(
    settings: Settings, around: KnownEnvironment, events: tuple[Event, ...], is_said: bool
) -> None:
    made = OneWorker(around, settings)
    made.happens(*events)

    assert made.audible.echoes is is_said


def test_a_worker_is_opened_only_for_a_voice_or_cues() -> None:
    """With the learner's voice and volumes, and all languages."""
    assert OneWorker(HOME, Settings(speech="off", sound=False)).worker.settings == []
    assert OneWorker(HOME, Settings(speech="robot", sound=False)).audible.has_cues is False
    assert OneWorker(HOME, Settings(speech="off")).audible.has_cues

    chosen = Settings(rate=300, volume=20, cues={"bump": 5}, sources={"volume": SettingSource.FILE})
    (settings,) = OneWorker(HOME, chosen).worker.settings
    assert settings.voice == VoiceSettings(300, 50, 0.2, "some", frozenset({"volume"}))
    assert settings.cue_volumes == {"bump": 0.05}
    assert set(settings.languages) == set(languages())


@pytest.mark.parametrize(("robot", "is_real"), [("serial", True), ("serial:/dev/x", True), ("sim", False)])
def test_where_speak_is_spoken_depends_on_whether_the_robot_is_real(robot: str, is_real: bool) -> None:
    made = OneWorker(HOME, Settings(robot=robot))

    assert made.facts == [{"is_linear": True, "has_real_robot": is_real}]


def test_the_end_waits_for_the_voice_and_then_for_the_cues() -> None:
    made = OneWorker(HOME, Settings())
    assert made.audible.is_still_within(2.0)
    assert made.worker.waited == [("voice", 2.0), ("cues", 2.0)]

    made.worker.is_silent = False
    assert not made.audible.is_still_within(2.0)
    assert made.audible.is_quiet_within(2.0)

    made.worker.is_silent, made.worker.is_quiet = True, False
    assert not made.audible.is_still_within(2.0)
    assert not made.audible.is_quiet_within(2.0)
    assert OneWorker(HOME, Settings(speech="off", sound=False)).audible.is_still_within(2.0)


def test_nothing_is_said_after_the_end() -> None:
    made = OneWorker(HOME, Settings())
    made.happens(Spoke("One."))
    made.closing.close()
    made.happens(Spoke("Two."), Chimed("bump"), OFF)

    assert made.worker.heard == ["One."]
    assert made.worker.closed == 1
    assert made.audible.is_on


class AnswersOnly:
    """Prints answers, and a line before each."""

    def before(self, stamped: Stamped) -> tuple[str, ...]:
        return ("Before.",) if self.passes(stamped) else ()

    def passes(self, stamped: Stamped) -> bool:
        return isinstance(stamped.event, Announced)


def test_a_voice_says_only_what_a_filter_prints_until_that_ends() -> None:
    made = OneWorker(HOME, Settings())
    end = made.audible.speak_only(AnswersOnly())
    made.happens(Spoke("Hi."), Announced("moved", "Moved."))
    end()
    made.happens(Spoke("Ho."))

    assert made.worker.heard == ["Before.", "Moved.", "Ho."]


def test_the_greeting_comes_before_typed_keys_in_the_learners_language() -> None:
    made = OneWorker(HOME, Settings(), "pt")
    made.audible.say_printed("Olá.")
    made.audible.echo("f")

    assert made.worker.utterances == [
        Utterance("Olá.", Urgency.ANSWER, "pt"),
        Utterance("f", Urgency.PROGRESS, "pt"),
    ]


def test_a_changed_setting_reaches_the_worker_and_only_another_channel_opens_a_new_one() -> None:
    made = OneWorker(HOME, Settings(speech="tts"))
    made.adjust(pitch=10)
    made.adjust(cues={"scan": 50})
    made.adjust(key_echo="words")

    assert made.worker.voices == [VoiceSettings(180, 10, 1.0, "some", frozenset({"pitch"}))]
    assert made.worker.volumes[0] == {"scan": 0.5}
    assert (len(made.worker.settings), made.worker.closed) == (1, 0)
    assert made.audible.settings.source_of("pitch") is SettingSource.OPTION
    assert made.audible.settings.source_of("rate") is SettingSource.DEFAULT

    made.adjust(sound=False)
    assert (len(made.worker.settings), made.worker.closed) == (2, 1)
    assert not made.audible.has_cues
    made.adjust(speech="off")
    assert (len(made.worker.settings), made.worker.closed) == (2, 2)
    assert not made.audible.speaks
    made.adjust(rate=100, key_echo="none")  # nothing needs it yet
    made.adjust(key_echo="words")
    made.adjust(sound=True)
    assert made.worker.settings[-1].voice.words_per_minute == 100
    assert made.audible.has_cues


@pytest.mark.parametrize(
    ("changed", "voice"),
    [
        ({"rate": 300}, VoiceSettings(300, 50, 1.0, "some", frozenset({"words_per_minute"}))),
        ({"pitch": 10}, VoiceSettings(180, 10, 1.0, "some", frozenset({"pitch"}))),
        ({"volume": 30}, VoiceSettings(180, 50, 0.3, "some", frozenset({"volume"}))),
        ({"punctuation": "all"}, VoiceSettings(180, 50, 1.0, "all", frozenset())),
        ({"cues": {"bump": 5}}, None),
    ],
)
def test_each_setting_of_the_voice_is_given_to_the_worker(
    changed: dict[str, object], voice: VoiceSettings | None
) -> None:
    made = OneWorker(HOME, Settings(speech="tts"))
    made.adjust(**changed)

    assert made.worker.voices == ([] if voice is None else [voice])
    assert made.worker.volumes == ([{"bump": 0.05}] if voice is None else [])
    assert len(made.worker.settings) == 1
    for name in ("speech", "speak", "sound"):  # these choose the voice anew
        made.adjust(**{name: getattr(made.audible.settings, name)})
    assert len(made.worker.settings) == 4


@pytest.mark.parametrize(
    ("settings", "workers"),
    [
        (Settings(speech="robot", sound=False), 1),
        (Settings(speech="off", sound=False), 0),
        (Settings(speech="off"), 1),
        (Settings(speech="tts", sound=False), 1),
        (Settings(speech="text", speak="robot", sound=False), 1),
        (Settings(speech="text", sound=False), 0),
    ],
)
def test_one_worker_is_for_answers_for_speak_and_for_cues(settings: Settings, workers: int) -> None:
    assert len(OneWorker(HOME, settings).worker.settings) == workers


def test_the_other_mode_chooses_its_voice_once() -> None:
    made = OneWorker(HOME, Settings())
    for is_linear in (True, False, False):
        made.move_to(is_linear=is_linear)

    assert [each["is_linear"] for each in made.facts] == [True, False]
    assert (len(made.worker.settings), made.worker.closed) == (2, 1)


@pytest.mark.parametrize(
    ("notice", "sentence"),
    [
        (
            AudioNotice(NoticeCode.VOICE_MISSING, "pt"),
            "There is no voice for Portuguese. It is in print only.",
        ),
        (AudioNotice(NoticeCode.NO_SOUND_DEVICE), "There is no sound device. Everything is in print."),
    ],
)
def test_what_the_worker_reports_is_an_answer(notice: AudioNotice, sentence: str) -> None:
    made = OneWorker(HOME, Settings())
    made.worker.report(notice)

    assert made.floor.events == [Answered(sentence)]


@pytest.mark.parametrize(
    ("kind", "calls", "said"),
    [
        ("characters", [("typed", "x" * 201, "")], ["x" * 200]),
        ("characters", [("typed", " \n", ""), ("typed", "", "")], []),
        ("characters", [("deleted", "abc"), ("deleted", "")], ["c."]),
        ("characters", [("ended", "FW 3")], []),
        ("words", [("typed", " ", "turn left"), ("typed", "b ", "a"), ("typed", "b", "a")], ["left", "ab"]),
        ("words", [("typed", " ", ""), ("ended", ""), ("ended", "FW 3"), ("deleted", "abc")], ["3"]),
        ("words", [("ended", "y" * 201)], ["y" * 200]),
        ("none", [("typed", "x", ""), ("typed", " ", "x"), ("deleted", "x"), ("ended", "x")], []),
    ],
)
def test_typed_text_is_said_as_its_kind_says(
    kind: str, calls: list[tuple[str, ...]], said: list[str]
) -> None:
    """Of a long text the first 200 characters."""
    heard: list[str] = []
    voice: Any = SimpleNamespace(settings=Settings(key_echo=kind), echoes=True, echo=heard.append)
    for name, *arguments in calls:
        getattr(TypingEcho(voice, Words()), name)(*arguments)

    assert heard == said


@pytest.mark.parametrize(("echoes", "kind"), [(True, "words"), (False, "none")])
def test_a_screen_reader_says_the_keys_itself(echoes: bool, kind: str) -> None:
    voice: Any = SimpleNamespace(settings=Settings(key_echo="words"), echoes=echoes)

    assert TypingEcho(voice, Words()).kind == kind


# --- two voices


class TwoVoices:
    """A speech-dispatcher and a built-in voice that replace real ones."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.server, self.own = Noting(), Noting()
        monkeypatch.setattr(audible, "DetectedEnvironment", lambda **_: facts(has_ssip=True))
        monkeypatch.setattr(audible, "ssip_address", lambda _: "somewhere")
        monkeypatch.setattr("devices.audio.speech_dispatcher.SsipSpeaker", lambda *_: self.server)
        monkeypatch.setattr("devices.audio.service.AudioService", lambda *_: self.own)


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
        made = make_audible(settings, floor.session.hub, Words(), closing)
        floor.session.hub.publish(Announced("moved", "Moved."))
        floor.session.hub.publish(Spoke("Hi."))
        made.echo("x")
        made.hush()

    assert (voices.server.said, voices.own.said) == ([*at_server, "x"], own)
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
        made = make_audible(Settings(speech="ssip", sound=False), floor.session.hub, words, closing)
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
        made = make_audible(Settings(speech="off"), floor.session.hub, Words(), closing)
        assert made.has_cues
        floor.session.hub.publish(Chimed("bump"))
        until(lambda: not made.has_cues)

        assert made.why_no_cues == "cues-no-device"
        until(lambda: sentences == ["There is no sound device. Everything is in print."])


@pytest.mark.parametrize(
    ("settings", "is_on", "said"),
    [
        (Settings(speech="ssip", speak="both"), True, ["Hi.", "Ho."]),
        (Settings(speech="ssip"), False, []),
        (Settings(speech="robot"), True, []),
    ],
)
def test_lines_printed_earlier_are_said_by_the_voice_of_the_answers(
    monkeypatch: pytest.MonkeyPatch, settings: Settings, is_on: bool, said: list[str]
) -> None:
    voices, floor = TwoVoices(monkeypatch), Floor()
    with ExitStack() as closing:
        made = make_audible(replace(settings, sound=False), floor.session.hub, Words(), closing)
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


# --- what languages bring


def test_a_language_is_spoken_with_the_words_that_it_has(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without a name for a number's parts it names no signs."""
    words: dict[tuple[str, ...], tuple[str, ...]] = {
        ("voices",): ("xx-yy", "xx"), ("minus",): ("less", "minus"), ("point",): ("dot",),
        ("degree",): ("grade",), ("degrees",): ("grades",), ("signs", "="): ("equals", "is"),
        ("signs", "+"): (), ("punctuation", ","): ("comma",),
    }  # fmt: skip
    tables: dict[str, object] = {"spoken": {"digit_by_digit": True}}

    def own_words(language: str, *entry: str) -> tuple[str, ...]:
        assert (language, *entry[:2]) == ("xx", "words", "spoken")
        return words.get(entry[2:], ())

    def keys(language: str, *entry: str) -> list[str]:
        return [each[1] for each in words if each[:1] == entry[2:] and len(each) == 2]

    monkeypatch.setattr(audible, "languages", lambda: ["xx"])
    monkeypatch.setattr(audible, "own_words", own_words)
    monkeypatch.setattr(audible, "keys", keys)
    monkeypatch.setattr(audible, "table", lambda *given: tables if given == ("xx", "words") else {})

    def spoken() -> SpokenLanguage:
        return audible.spoken_languages()["xx"]

    signs = ({"=": "equals"}, {",": "comma"})
    assert spoken() == SpokenLanguage(
        ("xx-yy", "xx"), SignWords("less", "dot", "grade", "grades", True, *signs)
    )
    for tables["spoken"] in ({"digit_by_digit": "yes"}, {}, "nothing"):
        assert spoken().signs == SignWords("less", "dot", "grade", "grades", False, *signs)
    for name in ("minus", "point", "degree", "degrees"):
        kept = words.pop((name,))
        assert spoken().signs is None
        words[name,] = kept
    del words["voices",]
    assert spoken().voices == ("xx",)
