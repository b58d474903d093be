"""The cues that wait for a worker: planned when they can be played, and known to be over."""

from __future__ import annotations

import pytest

from devices.audio_worker.conductor import Conductor
from devices.audio_worker.messages import PlayCue, SoundReady, VoiceReady
from devices.audio_worker.steps import Send
from devices.audio_worker.waiting_cues import ON_ITS_WAY, STALE_CUE, WaitingCues
from devices.ports.audio import Cue, Urgency, Utterance
from devices.sound.tones import seconds_of
from devices.speech.voices import VoiceSettings

FOUND = seconds_of("found")


def waiting(*names: str, at: float = 0.0) -> WaitingCues:
    cues = WaitingCues({})
    for name in names:
        cues.offer(Cue(name), at)
    return cues


def taken(cues: WaitingCues, now: float) -> list[tuple[str, float]]:
    return [(order.name, order.delay) for order in cues.take(now)]


@pytest.mark.parametrize("late", [0.3, 0.9])
def test_a_worker_that_is_there_late_is_given_a_line_that_is_as_long_as_before(late: float) -> None:
    names, delays = zip(*taken(waiting("found", "found", "found"), now=late), strict=True)

    assert names == ("found", "found", "found")
    assert delays == pytest.approx((0.0, FOUND, 2 * FOUND))


def test_what_comes_behind_a_late_line_waits_for_its_end() -> None:
    cues = waiting("found", "found")
    taken(cues, now=0.9)
    cues.offer(Cue("done"), 0.9)

    assert taken(cues, now=0.9) == [("done", pytest.approx(2 * FOUND))]


def test_of_ticks_that_waited_together_one_is_heard() -> None:
    cues = waiting("step-forward")
    cues.offer(Cue("step-forward"), 0.1)
    cues.offer(Cue("step-forward"), 0.2)

    assert taken(cues, now=0.9) == [("step-forward", 0.0)]


def test_a_cue_is_over_when_it_was_heard() -> None:
    cues = waiting("done")
    assert not cues.are_over(0.0)
    taken(cues, now=0.5)

    end = 0.5 + seconds_of("done") + ON_ITS_WAY
    assert not cues.are_over(end - 0.01)
    assert cues.are_over(end + 0.01)


def test_nobody_waits_for_a_worker_that_does_not_come() -> None:
    cues = waiting("found", "found", "done")
    last = 2 * FOUND + STALE_CUE

    assert not cues.are_over(last - 0.01)
    assert cues.are_over(last + 0.01)


def test_hushed_cues_are_over() -> None:
    cues = waiting("done")
    cues.hush(0.0)

    assert cues.are_over(0.0)


@pytest.fixture
def conductor() -> Conductor:
    made = Conductor(VoiceSettings(), {})
    made.warm_up()
    made.advance(0.0)
    made.answered(SoundReady("fake"), 0.0)
    made.answered(VoiceReady(["en"]), 0.0)
    return made


def test_nothing_sounds_any_more_when_voice_and_cues_have_ended(conductor: Conductor) -> None:
    conductor.play(Cue("done"), 1.0)
    sent = [step.order for step in conductor.advance(1.0) if isinstance(step, Send)]
    assert PlayCue("done", 0.0, None, 1.0, 0.0) in sent
    assert conductor.is_quiet
    assert not conductor.is_still(1.0)
    assert conductor.is_still(2.0)

    conductor.say(Utterance("Hello.", Urgency.ANSWER, "en"), 2.0)
    assert not conductor.is_still(2.0)


def test_where_no_worker_will_ever_be_nobody_waits_for_a_cue() -> None:
    conductor = Conductor(VoiceSettings(), {})
    conductor.play(Cue("done"), 0.0)
    conductor.advance(0.0)
    assert not conductor.is_still(0.0)
    conductor.answered(SoundReady(""), 0.0)

    assert conductor.is_still(0.0)
