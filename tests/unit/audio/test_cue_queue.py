"""Which cues are played and when, and what becomes of those that wait for a worker."""

from __future__ import annotations

import pytest

from devices.audio.cues import seconds_of
from devices.audio.mixer import PLAYBACK_LATENCY, STALE_CUE, CueQueue, CueScheduler
from devices.audio.process import PlayCue, SoundReady, VoiceReady
from devices.audio.supervisor import SendRequest, WorkerSupervisor
from devices.ports.audio import Cue, Urgency, Utterance, VoiceSettings

# --- when cues may sound


def scheduled(*cues: tuple[str, float, float]) -> list[float | None]:
    """The delays of cues given as name, length and time; None for a dropped one."""
    scheduler = CueScheduler()
    return [scheduler.schedule(name, seconds, now) for name, seconds, now in cues]


def test_at_most_two_cues_sound_at_once() -> None:
    ticks = ("step-forward", 0.045, 0.0), ("turn-left", 0.055, 0.0), ("step-back", 0.05, 0.04)
    assert scheduled(*ticks) == [0.0, 0.0, None]


def test_a_third_cue_sounds_when_one_of_two_has_ended() -> None:
    ticks = ("step-forward", 0.045, 0.0), ("turn-left", 0.055, 0.0), ("step-back", 0.05, 0.046)
    assert scheduled(*ticks) == [0.0, 0.0, 0.0]


def test_cues_of_single_events_wait_for_each_other_and_are_not_dropped() -> None:
    """A step, a scan that finds three things, the end of the program: all at the same robot time."""
    found = ("found", 0.25, 0.0)
    waits = scheduled(
        ("step-forward", 0.045, 0.0), ("scan", 0.09, 0.0), found, found, found, ("done", 0.32, 0.0)
    )

    assert waits == pytest.approx([0.0, 0.0, 0.09, 0.34, 0.59, 0.84])


def test_a_queue_begins_when_one_of_two_ticks_has_ended() -> None:
    ticks = ("step-forward", 0.045, 0.0), ("belt", 0.06, 0.0)
    assert scheduled(*ticks, ("scan", 0.09, 0.0)) == pytest.approx([0.0, 0.0, 0.045])


def test_steps_sound_while_other_cues_wait() -> None:
    found, step = ("found", 0.25, 0.0), ("step-forward", 0.045, 0.3)
    assert scheduled(found, found, found, step) == pytest.approx([0.0, 0.25, 0.5, 0.0])


def test_a_queue_is_limited_and_the_end_of_the_program_still_sounds() -> None:
    waits = scheduled(*[("found", 0.25, 0.0)] * 1000, ("done", 0.32, 0.0), ("error", 0.33, 0.0))

    assert max(wait for wait in waits[:1000] if wait is not None) <= 2.0
    assert None not in waits[1000:]


@pytest.mark.parametrize(("name", "apart"), [("step-forward", 0.07), ("turn-left", 0.07), ("scan", 0.3)])
def test_cues_of_the_same_kind_keep_their_distance(name: str, apart: float) -> None:
    assert scheduled((name, 0.04, 1.0), (name, 0.04, 1.0 + apart - 0.01)) == [0.0, None]
    assert scheduled((name, 0.04, 1.0), (name, 0.04, 1.0 + apart)) == [0.0, 0.0]


def test_different_kinds_need_no_distance() -> None:
    assert scheduled(("step-forward", 0.04, 0.0), ("scan", 0.09, 0.0)) == [0.0, 0.0]


def test_a_bump_sounds_however_much_else_does() -> None:
    assert scheduled(("found", 0.25, 0.0), ("belt", 0.06, 0.0), ("bump", 0.18, 0.0)) == [0.0, 0.0, 0.0]


def test_a_second_bump_waits_its_turn() -> None:
    waits = scheduled(("bump", 0.18, 0.0), ("bump", 0.18, 0.0), ("bump", 0.18, 0.02))

    assert waits == pytest.approx([0.0, 0.07, 0.12])


def test_many_bumps_never_lag_far_behind() -> None:
    waits = scheduled(*(("bump", 0.18, number / 1000) for number in range(1000)))

    played = [wait for wait in waits if wait is not None]
    assert len(played) > 10
    assert max(played) <= 1.0


def test_a_fast_simulation_sounds_as_a_steady_tick() -> None:
    played = [
        wait for wait in scheduled(*(("step-forward", 0.045, n / 1000) for n in range(1000))) if wait == 0.0
    ]

    assert 13 <= len(played) <= 15


def test_a_tick_sounds_only_if_at_no_moment_of_it_two_others_sound() -> None:
    bumps = ("bump", 0.18, 0.0), ("bump", 0.18, 0.0)

    assert scheduled(*bumps, ("step-forward", 0.07, 0.0)) == [0.0, 0.07, 0.0]
    assert scheduled(*bumps, ("step-forward", 0.08, 0.0)) == [0.0, 0.07, None]


def test_after_a_silence_the_same_cue_sounds_at_once() -> None:
    scheduler = CueScheduler()
    scheduler.schedule("scan", 9.0, 0.0)
    scheduler.schedule("belt", 9.0, 0.0)
    scheduler.clear()

    assert [scheduler.schedule(name, 0.09, 0.01) for name in ("scan", "step-forward")] == [0.0, 0.0]


# --- the queue

FOUND = seconds_of("found")


def queue_of(*names: str, at: float = 0.0) -> CueQueue:
    cues = CueQueue({})
    for name in names:
        cues.offer(Cue(name), at)
    return cues


def taken(cues: CueQueue, now: float) -> list[tuple[str, float]]:
    return [(order.name, order.delay) for order in cues.take(now)]


@pytest.mark.parametrize("late", [0.3, 0.9])
def test_a_late_worker_gets_cues_with_the_same_distances(late: float) -> None:
    names, delays = zip(*taken(queue_of("found", "found", "found"), now=late), strict=True)

    assert names == ("found", "found", "found")
    assert delays == pytest.approx((0.0, FOUND, 2 * FOUND))


@pytest.mark.parametrize(("late", "second"), [(0.1, FOUND - 0.1), (0.11, FOUND)])
def test_a_worker_that_is_a_tenth_of_a_second_late_gets_the_cues_for_their_time(
    late: float, second: float
) -> None:
    assert taken(queue_of("found", "found"), now=late) == [("found", 0.0), ("found", pytest.approx(second))]


def test_a_worker_takes_nothing_where_nothing_waits() -> None:
    assert taken(queue_of(), now=9.0) == []


def test_a_new_cue_waits_for_the_end_of_a_late_queue() -> None:
    cues = queue_of("found", "found")
    taken(cues, now=0.9)
    cues.offer(Cue("done"), 0.9)

    assert taken(cues, now=0.9) == [("done", pytest.approx(2 * FOUND))]


def test_a_cue_that_comes_too_soon_after_its_like_is_not_queued() -> None:
    assert queue_of("step-forward").offer(Cue("step-forward"), 0.01) is False


def test_of_ticks_that_waited_together_one_sounds() -> None:
    cues = queue_of("step-forward")
    cues.offer(Cue("step-forward"), 0.1)
    cues.offer(Cue("step-forward"), 0.2)

    assert taken(cues, now=0.9) == [("step-forward", 0.0)]


def test_a_cue_is_over_when_it_has_sounded() -> None:
    cues = queue_of("done")
    assert not cues.are_over(0.0)
    taken(cues, now=0.5)

    end = 0.5 + seconds_of("done") + PLAYBACK_LATENCY
    assert not cues.are_over(end - 0.01)
    assert cues.are_over(end)


def test_cues_are_over_when_the_last_of_a_queue_has_sounded() -> None:
    cues = queue_of("found", "found")
    taken(cues, now=0.0)

    assert not cues.are_over(2 * FOUND)
    assert cues.are_over(2 * FOUND + PLAYBACK_LATENCY)


def test_the_cues_are_over_when_no_worker_takes_them() -> None:
    cues = queue_of("found", "found", "done")
    last = 2 * FOUND + STALE_CUE

    assert not cues.are_over(last - 0.01)
    assert cues.are_over(last + 0.01)


def test_silenced_cues_are_over() -> None:
    cues = queue_of("done")
    assert cues.silence(0.0) is True

    assert cues.are_over(0.0)
    assert cues.silence(0.0) is False
    assert cues.offer(Cue("done"), 0.0)
    assert taken(cues, now=0.0) == [("done", 0.0)]


def test_a_cue_that_has_sounded_is_not_silenced() -> None:
    assert queue_of("done").silence(seconds_of("done") - 0.01) is True
    assert queue_of("done").silence(seconds_of("done")) is False


@pytest.fixture
def supervisor() -> WorkerSupervisor:
    made = WorkerSupervisor(VoiceSettings(), {})
    made.warm_up()
    made.advance(0.0)
    made.received(SoundReady("fake"), 0.0)
    made.received(VoiceReady(("en",)), 0.0)
    return made


def test_the_worker_is_silent_when_voice_and_cues_have_ended(supervisor: WorkerSupervisor) -> None:
    supervisor.play(Cue("done"), 1.0)
    sent = [step.request for step in supervisor.advance(1.0) if isinstance(step, SendRequest)]
    assert PlayCue("done", 0.0, None, 1.0, 0.0) in sent
    assert supervisor.is_quiet
    assert not supervisor.is_silent(1.0)
    assert supervisor.is_silent(2.0)

    supervisor.say(Utterance("Hello.", Urgency.ANSWER, "en"), 2.0)
    assert not supervisor.is_silent(2.0)


def test_without_a_device_no_caller_waits_for_a_cue() -> None:
    supervisor = WorkerSupervisor(VoiceSettings(), {})
    supervisor.play(Cue("done"), 0.0)
    supervisor.advance(0.0)
    assert not supervisor.is_silent(0.0)
    supervisor.received(SoundReady(""), 0.0)

    assert supervisor.is_silent(0.0)


@pytest.mark.parametrize(
    ("name", "most"), [("scan", 0.5), ("obstacle", 1.0), ("found", 2.0), ("done", 3.0), ("error", 3.0)]
)
def test_a_cue_waits_only_as_long_as_it_still_says_something(name: str, most: float) -> None:
    first = "done" if name == "error" else "error"

    assert scheduled((first, most, 0.0), (name, 0.1, 0.0)) == [0.0, most]
    assert scheduled((first, most + 0.01, 0.0), (name, 0.1, 0.0)) == [0.0, None]


def test_the_queue_ends_with_the_cue_that_waits_longest() -> None:
    assert scheduled(("error", 2.0, 0.0), ("found", 0.25, 0.0), ("done", 0.32, 0.0)) == [0.0, 2.0, 2.25]


@pytest.mark.parametrize(("now", "names"), [(1.0, ["step-forward", "bump"]), (1.1, ["bump"])])
def test_what_waited_for_more_than_a_second_is_dropped_unless_it_is_a_bump(
    now: float, names: list[str]
) -> None:
    queue = CueQueue({})
    for name in ("step-forward", "bump"):
        assert queue.offer(Cue(name, 0.0, None), 0.0)

    assert queue.are_over(now) is (now > 1.0)
    assert [each.name for each in queue.take(now)] == names


def test_each_cue_has_the_volume_of_its_name() -> None:
    queue = CueQueue({"scan": 0.0, "bump": 0.25, "found": 7.0})

    assert queue.offer(Cue("scan", 0.0, None), 0.0) is False
    assert queue.offer(Cue("no such cue", 0.0, None), 0.0) is False
    assert all(queue.offer(Cue(name, 0.0, None), 0.0) for name in ("bump", "found", "done"))
    assert [(each.name, each.volume) for each in queue.take(0.0)] == [
        *(("bump", 0.25), ("found", 1.0), ("done", 1.0))
    ]
    queue.set_volumes({"bump": 0.0})
    assert not queue.offer(Cue("bump", 0.0, None), 9.0)
    assert queue.offer(Cue("scan", 0.0, None), 9.0)
