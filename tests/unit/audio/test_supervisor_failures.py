"""What the supervisor decides when a worker fails: no device, no voice, no response, too many ends."""

import pytest

from devices.audio.process import (
    PlayCue,
    Pong,
    Say,
    SoundReady,
    SpeechRefused,
    SpeechStarted,
    VoiceReady,
)
from devices.audio.supervisor import (
    Awaited,
    Deadlines,
    FailureCounter,
    KillWorker,
    Notify,
    SendRequest,
    StartWorker,
    Step,
    WorkerState,
    WorkerStatus,
)
from devices.ports.audio import AudioNotice, NoticeCode
from tests.unit.audio.test_supervisor import KILL_AND_START, Supervised


@pytest.fixture
def audio() -> Supervised:
    return Supervised()


def test_a_missing_voice_is_reported_once_and_no_other_voice_reads_the_language(audio: Supervised) -> None:
    audio.become_ready("en")
    for text in ("Olá.", "Adeus."):
        audio.say(text, language="pt")
    audio.say("Hello.")
    steps = audio.steps()

    assert steps[0] == Notify(AudioNotice(NoticeCode.VOICE_MISSING, "pt"))
    assert [
        step.request.text for step in steps if isinstance(step, SendRequest) and isinstance(step.request, Say)
    ] == ["Hello."]
    audio.say("Olá de novo.", language="pt-BR")
    assert not any(isinstance(step, Notify) for step in audio.steps())


def test_a_limited_number_of_languages_without_a_voice_is_reported(audio: Supervised) -> None:
    audio.become_ready("en")
    for number in range(40):
        audio.say("Hello.", language=f"x{number}")

    assert len([step for step in audio.steps() if isinstance(step, Notify)]) == 32


def test_a_voice_that_fails_when_it_is_needed_is_reported_too(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("Olá.", language="pt")
    number = audio.next_say().number
    audio.respond(SpeechRefused(number - 1))
    assert not audio.supervisor.is_quiet
    audio.respond(SpeechRefused(number))

    assert audio.steps() == [Notify(AudioNotice(NoticeCode.VOICE_MISSING, "pt"))]
    assert audio.supervisor.is_quiet


def test_without_a_device_the_worker_is_killed_and_no_other_is_started(audio: Supervised) -> None:
    audio.say("Hello.")
    audio.steps()
    audio.respond(SoundReady(""), VoiceReady(("en",)))

    assert audio.steps() == [Notify(AudioNotice(NoticeCode.NO_SOUND_DEVICE)), KillWorker()]
    audio.say("Again.")
    audio.play("bump")
    audio.supervisor.silence_speech(audio.now)
    assert audio.steps() == []
    assert audio.supervisor.is_quiet
    assert audio.supervisor.state is WorkerState.SILENT


def test_without_a_voice_cues_are_played(audio: Supervised) -> None:
    audio.say("Hello.")
    audio.steps()
    audio.respond(SoundReady("fake"), VoiceReady(()))
    audio.say("Again.")
    audio.play("bump")

    assert audio.steps() == [
        Notify(AudioNotice(NoticeCode.NO_VOICE)),
        SendRequest(PlayCue("bump", 0.0, None, 1.0, 0.0)),
    ]
    assert audio.supervisor.is_quiet


@pytest.mark.parametrize(
    ("seconds", "steps"), [(2.9, []), (3.1, KILL_AND_START)], ids=["slow is not frozen", "frozen"]
)
def test_three_seconds_without_a_response_are_a_failure(seconds: float, steps: list[Step]) -> None:
    audio = Supervised()
    audio.become_ready()
    audio.say("Hello.")
    sentence = audio.next_say()
    audio.respond(SpeechStarted(sentence.number, 60.0))
    audio.now += seconds

    assert audio.steps() == steps


def test_a_sentence_that_does_not_begin_within_three_seconds_is_a_failure(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("Hello.")
    audio.next_say()
    audio.now += 2.9
    audio.respond(Pong(0, frames=1, is_playing=False))
    assert audio.steps() == []
    audio.now += 0.1

    assert audio.steps() == KILL_AND_START


def test_a_sentence_that_does_not_end_three_seconds_after_its_time_is_a_failure(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("Hello.")
    audio.respond(SpeechStarted(audio.next_say().number, 2.0), Pong(0, frames=1, is_playing=False))
    for seconds in (2.0, 2.9):
        audio.now += seconds
        audio.respond(Pong(0, frames=1, is_playing=False))
        assert audio.steps() == []
    audio.now += 0.1

    assert audio.steps() == KILL_AND_START


def test_a_player_that_plays_no_frames_is_frozen(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("Hello.")
    audio.respond(SpeechStarted(audio.next_say().number, 60.0))
    for _ in range(3):
        assert audio.steps() == []
        audio.respond(Pong(0, frames=4711, is_playing=True))
        audio.now += 1.0

    assert audio.steps() == KILL_AND_START


def test_a_player_that_plays_frames_is_not_frozen(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("Hello.")
    audio.respond(SpeechStarted(audio.next_say().number, 60.0))
    for seconds in range(20):
        audio.respond(Pong(0, frames=22_050 * seconds, is_playing=True))
        audio.now += 1.0
        assert audio.steps() == []


def test_a_player_without_a_heartbeat_is_judged_by_its_sentences(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("Hello.")
    audio.respond(SpeechStarted(audio.next_say().number, 10.0))
    for _ in range(12):
        audio.respond(Pong(0, frames=-1, is_playing=True))
        audio.now += 1.0
        assert audio.steps() == []
    audio.respond(Pong(0, frames=-1, is_playing=True))
    audio.now += 1.0

    assert audio.steps() == KILL_AND_START


def test_a_sentence_lost_with_its_worker_is_said_again_once(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("poison")
    audio.say("next")
    sent = []
    for _ in range(2):
        sent.append(audio.next_say().text)
        audio.fail()
        assert audio.steps() == KILL_AND_START
        audio.respond(SoundReady("fake"), VoiceReady(("en",)))
        audio.now += 61

    assert [*sent, audio.next_say().text] == ["poison", "poison", "next"]


def test_three_failures_in_a_minute_are_final_and_reported_once(audio: Supervised) -> None:
    audio.become_ready()
    audio.fail()
    assert audio.steps() == KILL_AND_START
    audio.fail()
    assert audio.steps() == [KillWorker(), StartWorker(True)]
    audio.fail()

    assert audio.steps() == [Notify(AudioNotice(NoticeCode.AUDIO_GAVE_UP)), KillWorker()]
    audio.say("Hello.")
    audio.play("bump")
    assert audio.steps() == []
    assert audio.supervisor.is_quiet


def test_a_worker_that_has_ended_fails_once(audio: Supervised) -> None:
    audio.become_ready()
    for _ in range(3):
        audio.fail()

    assert audio.steps() == KILL_AND_START


def test_what_a_worker_sent_before_its_end_says_nothing_about_the_next_one(audio: Supervised) -> None:
    audio.become_ready()
    audio.fail()
    audio.respond(SoundReady("fake"), Pong(0, frames=1, is_playing=True))
    assert audio.steps() == KILL_AND_START
    audio.now += 3.1

    assert audio.supervisor.player == ""
    assert audio.steps() == []


def test_only_three_failures_within_sixty_seconds_are_final() -> None:
    failures = FailureCounter()

    assert [failures.add(now) for now in (0.0, 30.0, 60.5, 90.0, 120.6)] == [
        *(False, False, False, True, False)
    ]
    failures = FailureCounter()
    assert [failures.add(now) for now in (0.0, 30.0, 60.0)] == [False, False, True]


def test_after_a_worker_that_died_loading_the_voice_the_next_prefers_the_bundled_one(
    audio: Supervised,
) -> None:
    audio.supervisor.warm_up()
    audio.steps()
    audio.respond(SoundReady("fake"))
    audio.fail()

    assert audio.steps() == [KillWorker(), StartWorker(prefer_bundled_voice=True)]
    audio.respond(SoundReady("fake"), VoiceReady(("en",)))
    audio.fail()
    assert audio.steps() == [KillWorker(), StartWorker(prefer_bundled_voice=True)]


def test_a_worker_that_never_gets_ready_is_given_ten_seconds(audio: Supervised) -> None:
    audio.supervisor.warm_up()
    audio.steps()
    audio.now += 9.9
    assert audio.steps() == []
    audio.now += 0.2

    assert audio.steps() == [KillWorker(), StartWorker(True)]


def test_time_in_which_this_process_was_suspended_is_not_a_failure(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("Hello.")
    audio.respond(SpeechStarted(audio.next_say().number, 1.0))
    audio.now += 3600.0
    audio.supervisor.was_away(3600.0)

    assert audio.steps() == []


def test_an_idle_worker_gets_no_heartbeat(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("Hello.")
    audio.speak(audio.next_say())
    audio.respond(Pong(0, frames=1, is_playing=False))

    assert audio.steps() == []
    assert audio.supervisor.next_at() is None


# --- heartbeats


def test_a_heartbeat_is_sent_with_other_requests_and_then_each_second_while_something_sounds() -> None:
    worker = WorkerStatus()
    assert worker.next_at() is None
    assert worker.must_ping(has_sent=False, now=0.0) is False
    assert worker.must_ping(has_sent=True, now=0.0) is True
    assert worker.must_ping(has_sent=True, now=1.0) is False  # the answer is awaited
    assert worker.next_at() == 3.0
    worker.pong_received(Pong(0, frames=5, is_playing=False), True, now=2.0)

    assert worker.next_at() == 3.0
    assert worker.must_ping(has_sent=False, now=2.9) is False
    assert worker.must_ping(has_sent=False, now=3.0) is True
    assert worker.next_at() == 6.0
    worker.pong_received(Pong(0, frames=5, is_playing=False), False, now=4.0)
    assert worker.next_at() is None
    assert worker.must_ping(has_sent=False, now=99.0) is False


def test_a_player_that_plays_after_the_sentence_gets_heartbeats_too() -> None:
    worker = WorkerStatus()
    worker.pong_received(Pong(0, frames=5, is_playing=True), False, now=2.0)

    assert worker.must_ping(has_sent=False, now=3.0) is True


@pytest.mark.parametrize(
    ("heartbeats", "by"),
    [
        ([(0, True)], 3.0),
        ([(0, True), (0, True), (0, True)], 3.0),
        ([(0, True), (1, True), (1, True)], 4.0),
        ([(7, True), (7, False)], None),
        ([(7, True), (7, False), (7, True)], 5.0),
        ([(-1, True), (-1, True)], None),
        ([(7, True), (-1, True)], None),
        ([(0, False)], None),
    ],
)
def test_a_player_has_three_seconds_from_the_last_frame_that_it_played(
    heartbeats: list[tuple[int, bool]], by: float | None
) -> None:
    deadlines = Deadlines()
    for now, (frames, is_playing) in enumerate(heartbeats):
        deadlines.heartbeat(frames, is_playing, float(now))

    assert deadlines.next_at() == by
    assert deadlines.expects(Awaited.PLAYBACK) is (by is not None)
    if by is not None:
        assert deadlines.overdue(by - 0.1) is None
        assert deadlines.overdue(by) is Awaited.PLAYBACK


def test_a_worker_is_ready_when_it_has_reported_its_player_and_its_voices() -> None:
    worker = WorkerStatus()
    assert (worker.is_ready, worker.has_no_voice, worker.can_read("en")) == (False, False, False)
    worker.player = "fake"
    assert not worker.is_ready
    worker.languages = ()
    assert (worker.is_ready, worker.has_no_voice, worker.can_read("en")) == (True, True, False)
    worker.player, worker.languages = "", ("en",)
    assert (worker.is_ready, worker.has_no_voice) == (False, False)
    assert (worker.can_read("en"), worker.can_read("pt")) == (True, False)
