"""SOUND OFF silences voice and cues at once and keeps them silent. It does not affect printed lines."""

from __future__ import annotations

from contextlib import ExitStack
from types import SimpleNamespace
from typing import Any

import pytest

from devices.ports.audio import Cue, Urgency, Utterance
from devices.ports.robot import Pose
from devices.serial_ports import PortFault, PortProblem
from donnie_tui.core.belt import OFF
from donnie_tui.core.events import (
    BELT_LINK,
    Announced,
    Answered,
    BeltShown,
    Chimed,
    CueSounded,
    Error,
    Event,
    Outcome,
    Pointed,
    RunEnded,
    SoundSwitched,
    Spoke,
    Stamped,
)
from donnie_tui.core.hub import Hub
from donnie_tui.core.transcript import UnfilteredTranscript
from donnie_tui.core.voice import Cues, SpeechWait, Voice, VoiceScope
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.outlets.belt import ChosenBelt, connect_belt, refuse_shared_port
from donnie_tui.outlets.files import Outlets


class RecordingAudio:
    """A voice and a player of cues."""

    def __init__(self) -> None:
        self.heard: list[str] = []
        self.utterances: list[Utterance] = []

    def say(self, utterance: Utterance) -> None:
        self.heard.append(utterance.text)
        self.utterances.append(utterance)

    def play(self, cue: Cue) -> None:
        self.heard.append(cue.name)

    def silence_speech(self) -> None:
        self.heard.append("(hush)")

    silence_cues = silence_speech


def test_sound_off_ends_the_voice_and_later_announcements_are_only_printed() -> None:
    """SOUND ON restores the voice."""
    audio, hub = RecordingAudio(), Hub(lambda: 0.0)
    hub.subscribe(Voice(audio, Words()))
    for event in (Spoke("one"), SoundSwitched(False), Spoke("two"), SoundSwitched(True), Spoke("three")):
        hub.publish(event)

    assert audio.heard == ["one", "(hush)", "three"]


def test_sound_off_ends_the_cues_and_none_is_played_then() -> None:
    """SOUND ON restores the cues."""
    audio, hub = RecordingAudio(), Hub(lambda: 0.0)
    hub.subscribe(Cues(audio))
    for on in (True, False, True):
        hub.publish(SoundSwitched(on))
        hub.publish(CueSounded("bump", 0.0, None))
        hub.publish(Chimed("block-opened"))

    assert audio.heard == ["bump", "block-opened", "(hush)", "bump", "block-opened"]


@pytest.mark.parametrize("is_on", [True, False])
def test_sound_is_on_at_the_start_unless_it_was_switched_off_before(is_on: bool) -> None:
    audio, hub = RecordingAudio(), Hub(lambda: 0.0)
    for outlet in (
        (Voice(audio, Words()), Cues(audio))
        if is_on
        else (Voice(audio, Words(), is_on=False), Cues(audio, is_on=False))
    ):
        hub.subscribe(outlet)
    hub.publish(Spoke("one"))
    hub.publish(Chimed("block-opened"))

    assert audio.heard == (["one", "block-opened"] if is_on else [])


@pytest.mark.parametrize(
    ("event", "urgency"),
    [
        (Spoke("said"), Urgency.PROGRAM),
        (Error("unknown-command", 1, 1, "Not known.", None), Urgency.ALERT),
        (Announced("link", "lost"), Urgency.ALERT),
        (Announced("moved", "walked"), Urgency.ANSWER),
        (Announced("hint", "so"), Urgency.HINT),
        (Announced("waiting", "waits"), Urgency.PROGRESS),
        (Answered("saved"), Urgency.ANSWER),
        (Pointed("a wall"), Urgency.PROGRESS),
    ],
    ids=lambda value: type(value).__name__ if isinstance(value, Event) else value.name,
)
def test_what_is_said_first_depends_on_what_it_is(event: Event, urgency: Urgency) -> None:
    audio = RecordingAudio()
    Voice(audio, Words("pt"))(Stamped(1, 0.0, event))

    assert {(each.urgency, each.language) for each in audio.utterances} == {(urgency, "pt")}


class SummingUp(UnfilteredTranscript):
    """Leaves announcements out and sums up what it left out."""

    def before(self, stamped: Stamped) -> tuple[str, ...]:
        return () if isinstance(stamped.event, Announced) else ("2 steps.", "1 turn.")

    def passes(self, stamped: Stamped) -> bool:
        return not isinstance(stamped.event, Announced)


@pytest.mark.parametrize(
    ("scope", "heard"),
    [
        (VoiceScope.ALL, ["2 steps.", "1 turn.", "word", "2 steps.", "1 turn.", "answer"]),
        (VoiceScope.ANSWERS, ["2 steps.", "1 turn.", "2 steps.", "1 turn.", "answer"]),
        (VoiceScope.PROGRAM, ["word"]),
    ],
)
def test_a_voice_says_what_the_filter_lets_pass_and_sums_up(scope: VoiceScope, heard: list[str]) -> None:
    """Not the words of SPEAK, or these alone, if another voice says the rest."""
    audio = RecordingAudio()
    voice = Voice(audio, Words(), scope, transcript_filter=SummingUp)
    for event in (Announced("moved", "walked"), Spoke("word"), Answered("answer")):
        voice(Stamped(1, 0.0, event))

    assert audio.heard == heard
    assert [each.urgency for each in audio.utterances[:2]] == (
        [Urgency.ANSWER] * 2 if scope is not VoiceScope.PROGRAM else [Urgency.PROGRAM]
    )


@pytest.mark.parametrize("scope", VoiceScope)
def test_what_is_in_print_only_is_not_said(scope: VoiceScope) -> None:
    audio = RecordingAudio()
    Voice(audio, Words(), scope)(Stamped(0, 0.0, Answered("quiet", in_print_only=True)))

    assert audio.heard == []


def test_a_program_waits_for_the_voice_only_if_the_learner_wants_that() -> None:
    settings = SimpleNamespace(wait_for_speech=False)
    audible: Any = SimpleNamespace(
        settings=settings, is_quiet_within=bool, adjust=lambda **changed: settings.__dict__.update(changed)
    )
    nothing: Any = None
    outlets = Outlets(audible, nothing, nothing, SpeechWait())
    found = []
    for waits in (True, False):
        outlets.adjust_sound(wait_for_speech=waits)
        found.append(outlets.speech_wait.is_quiet_within)

    assert found == [bool, None]


# --- news of a belt


def belt_settings_of(robot: str, belt: str | None) -> Any:
    return SimpleNamespace(robot=robot, belt=belt)


def test_without_a_belt_there_is_no_news_and_nothing_to_close() -> None:
    closing = ExitStack()
    team: Any = None

    assert connect_belt(belt_settings_of("sim", None), team, Words(), closing)() == ()


def test_a_missing_belt_is_reported_when_the_session_is_assembled_and_later_news_at_once(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from devices import belt

    kept: list[Any] = []

    def missing(port: str, news: Any, _open: object) -> None:
        kept.append(news)
        raise PortProblem(port, PortFault.ABSENT, "no such port")

    monkeypatch.setattr(belt, "SerialBelt", missing)
    hub, heard = Hub(lambda: 0.0), []
    hub.subscribe(lambda stamped: heard.append(stamped.event))
    team: Any = SimpleNamespace(chosen=SimpleNamespace(hub=hub))
    take = connect_belt(belt_settings_of("sim", "/dev/belt"), team, Words(), ExitStack())
    (news,) = kept
    news.publish("one more")

    assert heard == []
    assert take() == ("No belt at /dev/belt: no such port. I go on without it.", "one more")
    assert take() == ()
    news.publish("later")
    assert heard == [Announced(BELT_LINK, "later")]


def test_robot_and_belt_have_ports_of_their_own() -> None:
    for robot in ("sim", "serial", "serial:/dev/other", "double:/dev/ttyUSB7"):
        refuse_shared_port(belt_settings_of(robot, "/dev/ttyUSB7"), Words())
    refuse_shared_port(belt_settings_of("serial:/dev/ttyUSB7", None), Words())

    team: Any = None
    shared = belt_settings_of("serial:/dev/ttyUSB7", "/dev/ttyUSB7")
    with pytest.raises(Unusable, match="/dev/ttyUSB7"):
        refuse_shared_port(shared, Words())
    with pytest.raises(Unusable, match="/dev/ttyUSB7"):
        connect_belt(shared, team, Words(), ExitStack())


def test_only_the_chosen_robots_levels_are_shown_until_its_run_ends() -> None:
    strong, weak, shown = (3,) * 14, (1,) * 14, []
    chosen = ["alice"]
    listener = ChosenBelt(lambda: chosen[0], shown.append)
    ended = RunEnded(Outcome.COMPLETED, Pose(0, 0, 0), {}, 1.0)

    def happens(event: Any, robot: str) -> None:
        listener(Stamped(1, 0.0, event, robot))

    happens(BeltShown(weak), "bob")
    assert shown == []
    happens(BeltShown(strong), "alice")
    happens(BeltShown(strong), "alice")
    assert shown == [strong]
    chosen[0] = "bob"
    happens(Spoke("x"), "bob")
    assert shown == [strong, weak]
    happens(ended, "bob")
    assert shown == [strong, weak, OFF]
    chosen[0] = "alice"
    happens(Spoke("x"), "alice")
    assert shown[-1] == strong
