"""What is decided where a worker fails: no device, no voice, no answer, gone too often."""

import pytest

from devices.audio_worker.lifetime import State
from devices.audio_worker.messages import (
    PlayCue,
    Pong,
    Refused,
    Say,
    SoundReady,
    Started,
    VoiceReady,
)
from devices.audio_worker.notices import AudioNotice, NoticeCode
from devices.audio_worker.steps import Kill, Send, Start, Step, Tell
from devices.audio_worker.watch import Failures
from tests.unit.audio.test_conductor import KILL_AND_START, Stage


@pytest.fixture
def stage() -> Stage:
    return Stage()


def test_a_missing_voice_is_told_once_and_never_read_by_another(stage: Stage) -> None:
    stage.get_ready("en")
    for text in ("Olá.", "Adeus."):
        stage.say(text, language="pt")
    stage.say("Hello.")
    steps = stage.steps()

    assert steps[0] == Tell(AudioNotice(NoticeCode.VOICE_MISSING, "pt"))
    assert [step.order.text for step in steps if isinstance(step, Send) and isinstance(step.order, Say)] == [
        "Hello."
    ]
    stage.say("Olá de novo.", language="pt-BR")
    assert not any(isinstance(step, Tell) for step in stage.steps())


def test_a_voice_that_fails_when_it_is_needed_is_told_too(stage: Stage) -> None:
    stage.get_ready()
    stage.say("Olá.", language="pt")
    stage.answer(Refused(stage.next_say().number))

    assert stage.steps() == [Tell(AudioNotice(NoticeCode.VOICE_MISSING, "pt"))]
    assert stage.conductor.is_quiet


def test_without_a_device_the_worker_is_ended_and_all_is_silent(stage: Stage) -> None:
    stage.say("Hello.")
    stage.steps()
    stage.answer(SoundReady(""), VoiceReady(["en"]))

    assert stage.steps() == [Tell(AudioNotice(NoticeCode.NO_SOUND_DEVICE)), Kill()]
    stage.say("Again.")
    stage.play("bump")
    stage.conductor.hush_speech(stage.now)
    assert stage.steps() == []
    assert stage.conductor.is_quiet
    assert stage.conductor.state is State.SILENT


def test_without_a_voice_there_are_cues(stage: Stage) -> None:
    stage.say("Hello.")
    stage.steps()
    stage.answer(SoundReady("fake"), VoiceReady([]))
    stage.say("Again.")
    stage.play("bump")

    assert stage.steps() == [
        Tell(AudioNotice(NoticeCode.NO_VOICE)),
        Send(PlayCue("bump", 0.0, None, 1.0, 0.0)),
    ]
    assert stage.conductor.is_quiet


@pytest.mark.parametrize(
    ("seconds", "steps"), [(2.9, []), (3.1, KILL_AND_START)], ids=["slow is not frozen", "frozen"]
)
def test_three_seconds_without_an_answer_are_too_many(seconds: float, steps: list[Step]) -> None:
    stage = Stage()
    stage.get_ready()
    stage.say("Hello.")
    sentence = stage.next_say()
    stage.answer(Started(sentence.number, 60.0))
    stage.now += seconds

    assert stage.steps() == steps


def test_a_player_that_stands_still_is_frozen(stage: Stage) -> None:
    stage.get_ready()
    stage.say("Hello.")
    stage.answer(Started(stage.next_say().number, 60.0))
    for _ in range(3):
        assert stage.steps() == []
        stage.answer(Pong(0, frames=4711, is_playing=True))
        stage.now += 1.0

    assert stage.steps() == KILL_AND_START


def test_a_player_that_moves_on_is_not(stage: Stage) -> None:
    stage.get_ready()
    stage.say("Hello.")
    stage.answer(Started(stage.next_say().number, 60.0))
    for seconds in range(20):
        stage.answer(Pong(0, frames=22_050 * seconds, is_playing=True))
        stage.now += 1.0
        assert stage.steps() == []


def test_a_player_without_a_heartbeat_is_judged_by_its_sentences(stage: Stage) -> None:
    stage.get_ready()
    stage.say("Hello.")
    stage.answer(Started(stage.next_say().number, 10.0))
    for _ in range(12):
        stage.answer(Pong(0, frames=-1, is_playing=True))
        stage.now += 1.0
        assert stage.steps() == []
    stage.answer(Pong(0, frames=-1, is_playing=True))
    stage.now += 1.0

    assert stage.steps() == KILL_AND_START


def test_a_sentence_lost_with_its_worker_is_said_again_once(stage: Stage) -> None:
    stage.get_ready()
    stage.say("poison")
    stage.say("next")
    sent = []
    for _ in range(2):
        sent.append(stage.next_say().text)
        stage.fail()
        assert stage.steps() == KILL_AND_START
        stage.answer(SoundReady("fake"), VoiceReady(["en"]))
        stage.now += 61

    assert [*sent, stage.next_say().text] == ["poison", "poison", "next"]


def test_three_failures_in_a_minute_are_the_end_and_told_once(stage: Stage) -> None:
    stage.get_ready()
    stage.fail()
    assert stage.steps() == KILL_AND_START
    stage.fail()
    assert stage.steps() == [Kill(), Start(True)]
    stage.fail()

    assert stage.steps() == [Tell(AudioNotice(NoticeCode.AUDIO_GAVE_UP)), Kill()]
    stage.say("Hello.")
    stage.play("bump")
    assert stage.steps() == []
    assert stage.conductor.is_quiet


def test_failures_far_apart_are_forgiven() -> None:
    failures = Failures()

    assert [failures.add(now) for now in (0.0, 50.0, 100.0, 150.0, 155.0)] == [
        False,
        False,
        False,
        False,
        True,
    ]


def test_a_worker_that_died_loading_the_voice_is_followed_by_one_with_the_bundled_voice(stage: Stage) -> None:
    stage.conductor.warm_up()
    stage.steps()
    stage.answer(SoundReady("fake"))
    stage.fail()

    assert stage.steps() == [Kill(), Start(prefer_bundled_voice=True)]


def test_a_worker_that_never_gets_ready_is_given_ten_seconds(stage: Stage) -> None:
    stage.conductor.warm_up()
    stage.steps()
    stage.now += 9.9
    assert stage.steps() == []
    stage.now += 0.2

    assert stage.steps() == [Kill(), Start(True)]


def test_time_in_which_we_stood_still_ourselves_is_no_ones_failure(stage: Stage) -> None:
    stage.get_ready()
    stage.say("Hello.")
    stage.answer(Started(stage.next_say().number, 1.0))
    stage.now += 3600.0
    stage.conductor.was_away(3600.0)

    assert stage.steps() == []


def test_an_idle_worker_is_left_asleep(stage: Stage) -> None:
    stage.get_ready()
    stage.say("Hello.")
    stage.hear(stage.next_say())
    stage.answer(Pong(0, frames=1, is_playing=False))

    assert stage.steps() == []
    assert stage.conductor.next_date() is None
