"""What the supervisor decides, without a worker: responses and times in, steps out."""

import pytest

from devices.audio.process import (
    AudioResponse,
    Ping,
    PlayCue,
    Say,
    Silence,
    Silenced,
    SoundReady,
    SpeechFinished,
    SpeechStarted,
    VoiceReady,
)
from devices.audio.supervisor import (
    KillWorker,
    Notify,
    SendRequest,
    StartWorker,
    Step,
    WorkerState,
    WorkerSupervisor,
)
from devices.ports.audio import AudioNotice, Cue, NoticeCode, Urgency, Utterance, VoiceSettings
from donnie_tui.outlets.audible import spoken_languages

KILL_AND_START = [KillWorker(), StartWorker(False)]


class Supervised:
    """A supervisor, its clock, and the steps that it asked for."""

    def __init__(self, volumes: dict[str, float] | None = None) -> None:
        self.supervisor = WorkerSupervisor(VoiceSettings(), volumes or {}, spoken_languages())
        self.now = 100.0

    def say(self, text: str, urgency: Urgency = Urgency.PROGRAM, language: str = "en") -> None:
        self.supervisor.say(Utterance(text, urgency, language), self.now)

    def play(self, name: str) -> None:
        self.supervisor.play(Cue(name), self.now)

    def steps(self) -> list[Step]:
        """All but the heartbeat's."""
        taken = self.supervisor.advance(self.now)
        return [
            step for step in taken if not (isinstance(step, SendRequest) and isinstance(step.request, Ping))
        ]

    def respond(self, *responses: AudioResponse) -> None:
        for response in responses:
            self.supervisor.received(response, self.now)

    def become_ready(self, *languages: str) -> None:
        self.supervisor.warm_up()
        assert self.steps() == [StartWorker(False)]
        self.respond(SoundReady("fake"), VoiceReady(languages or ("en", "pt", "es")))

    def next_say(self) -> Say:
        """Advance; the sentence that is sent."""
        sent = [step.request for step in self.steps() if isinstance(step, SendRequest)]
        (order,) = (order for order in sent if isinstance(order, Say))
        return order

    def speak(self, sentence: Say) -> None:
        self.respond(SpeechStarted(sentence.number, 1.0), SpeechFinished(sentence.number))

    def fail(self) -> None:
        self.supervisor.ended(self.now)


@pytest.fixture
def audio() -> Supervised:
    return Supervised()


def test_nothing_is_started_before_there_is_something_to_play(audio: Supervised) -> None:
    assert audio.steps() == []
    assert audio.supervisor.next_at() is None
    assert audio.supervisor.is_quiet


def test_the_first_sentence_starts_the_worker_and_waits_for_it(audio: Supervised) -> None:
    audio.say("Hello.")

    assert audio.steps() == [StartWorker(False)]
    assert audio.steps() == []
    assert not audio.supervisor.is_quiet


def test_a_sentence_is_sent_in_words_for_a_voice(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("x=-3", language="pt")

    sentence = audio.next_say()
    assert (sentence.text, sentence.language) == ("x igual a menos 3", "pt")


def test_sentences_are_sent_one_at_a_time_in_order(audio: Supervised) -> None:
    audio.become_ready()
    for text in ("one", "two", "three"):
        audio.say(text)
    sent = []
    while not audio.supervisor.is_quiet:
        sentence = audio.next_say()
        assert audio.steps() == []
        sent.append(sentence.text)
        audio.speak(sentence)

    assert sent == ["one", "two", "three"]


def test_the_voice_is_clamped_and_may_change_between_sentences(audio: Supervised) -> None:
    audio.become_ready()
    audio.supervisor.set_voice(VoiceSettings(words_per_minute=9_999, pitch=60, volume=0.5))
    audio.say("Fast.")

    sentence = audio.next_say()
    assert (sentence.words_per_minute, sentence.pitch, sentence.volume) == (450, 60, 0.5)


def test_silence_ends_the_sentence_and_drops_the_others(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("one")
    audio.say("two")
    sentence = audio.next_say()
    audio.supervisor.silence_speech(audio.now)
    (step,) = audio.steps()

    assert isinstance(step, SendRequest)
    assert isinstance(step.request, Silence)
    assert (step.request.speech, step.request.cues) == (True, False)
    assert audio.supervisor.is_quiet
    audio.respond(Silenced(step.request.number), SpeechFinished(sentence.number))
    assert audio.steps() == []


def test_silence_for_cues_leaves_the_sentence(audio: Supervised) -> None:
    audio.become_ready()
    audio.supervisor.play(Cue("done"), audio.now)
    audio.steps()
    audio.supervisor.silence_cues(audio.now)
    (step,) = audio.steps()

    assert isinstance(step, SendRequest)
    assert isinstance(step.request, Silence)
    assert (step.request.speech, step.request.cues) == (False, True)


def test_a_sentence_lost_with_its_worker_is_not_said_after_a_silence(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("one")
    audio.next_say()
    audio.fail()
    audio.supervisor.silence_speech(audio.now)

    assert audio.supervisor.is_quiet
    audio.steps()
    audio.respond(SoundReady("fake"), VoiceReady(("en",)))
    assert audio.steps() == []


def test_a_sentence_after_a_silence_is_sent_after_it(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("one")
    audio.next_say()
    audio.supervisor.silence_speech(audio.now)
    audio.say("two")
    orders = [type(step.request) for step in audio.steps() if isinstance(step, SendRequest)]

    assert orders == [Silence, Say]


def test_silence_is_not_sent_if_nothing_sounds(audio: Supervised) -> None:
    audio.supervisor.silence_speech(audio.now)
    audio.supervisor.silence_cues(audio.now)
    assert audio.steps() == []

    audio.become_ready()
    audio.supervisor.silence_speech(audio.now)
    assert audio.steps() == []


def test_a_worker_that_is_not_silent_in_time_is_killed(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("one")
    audio.next_say()
    audio.supervisor.silence_speech(audio.now)
    audio.steps()
    audio.now += 0.121

    assert audio.supervisor.next_at() is not None
    assert audio.steps() == KILL_AND_START


@pytest.mark.parametrize(
    ("later", "steps"), [(0, []), (-1, KILL_AND_START)], ids=["this silence", "another one"]
)
def test_a_worker_that_reports_the_silence_in_time_is_kept(
    audio: Supervised, later: int, steps: list[Step]
) -> None:
    audio.become_ready()
    audio.say("one")
    audio.next_say()
    audio.supervisor.silence_speech(audio.now)
    (step,) = audio.steps()
    assert isinstance(step, SendRequest)
    assert isinstance(step.request, Silence)
    audio.now += 0.119
    assert audio.steps() == []
    audio.respond(Silenced(step.request.number + later))
    audio.now += 0.002

    assert audio.steps() == steps


def test_workers_that_are_not_silent_in_time_do_not_count_as_failures(audio: Supervised) -> None:
    for _ in range(10):
        audio.supervisor.warm_up()
        audio.steps()
        audio.respond(SoundReady("fake"), VoiceReady(("en",)))
        audio.say("one")
        audio.next_say()
        audio.supervisor.silence_speech(audio.now)
        audio.steps()
        audio.now += 0.2

    assert audio.steps() == KILL_AND_START


def test_an_alert_interrupts_progress_but_not_an_answer(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("Still walking.", Urgency.PROGRESS)
    audio.next_say()
    audio.say("Bump.", Urgency.ALERT)
    assert [type(step.request) for step in audio.steps() if isinstance(step, SendRequest)] == [Silence, Say]

    audio.say("Stopped.", Urgency.ALERT)
    assert audio.steps() == []


def test_an_old_cue_from_before_the_worker_was_ready_is_dropped_except_a_bump(audio: Supervised) -> None:
    audio.play("step-forward")
    audio.play("bump")
    audio.steps()
    audio.now += 1.5
    audio.respond(SoundReady("fake"))

    assert audio.steps() == [SendRequest(PlayCue("bump", 0.0, None, 1.0, 0.0))]


def test_an_unknown_cue_and_one_that_is_switched_off_are_not_played() -> None:
    audio = Supervised(volumes={"step-forward": 0.0, "bump": 7.0})
    audio.become_ready()
    for name in ("trumpet", "step-forward", "bump"):
        audio.play(name)

    assert audio.steps() == [SendRequest(PlayCue("bump", 0.0, None, 1.0, 0.0))]


def test_silenced_cues_are_not_sent(audio: Supervised) -> None:
    audio.play("bump")
    audio.steps()
    audio.supervisor.silence_cues(audio.now)
    audio.respond(SoundReady("fake"))

    assert not any(
        isinstance(step, SendRequest) and isinstance(step.request, PlayCue) for step in audio.steps()
    )


def test_a_full_backlog_is_reported_once(audio: Supervised) -> None:
    for number in range(20_000):
        audio.say(str(number))

    assert audio.steps() == [Notify(AudioNotice(NoticeCode.SPEECH_BACKLOG)), StartWorker(False)]


def test_after_closing_nothing_happens(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("Hello.")
    audio.supervisor.close()
    assert audio.steps() == [KillWorker()]

    audio.say("Hello.")
    audio.play("bump")
    assert audio.supervisor.is_silent(audio.now)
    audio.supervisor.warm_up()
    audio.supervisor.close()
    audio.fail()
    assert audio.steps() == []
    audio.respond(SoundReady(""), VoiceReady(("en",)))
    assert audio.supervisor.state is WorkerState.CLOSED


def test_player_and_languages_are_those_of_the_present_worker(audio: Supervised) -> None:
    assert (audio.supervisor.player, audio.supervisor.languages) == ("", ())
    audio.become_ready("en", "pt")
    assert (audio.supervisor.player, audio.supervisor.languages) == ("fake", ("en", "pt"))
    audio.fail()
    assert (audio.supervisor.player, audio.supervisor.languages) == ("", ())


def test_a_worker_that_is_closed_gets_nothing_more(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("Hello.")
    audio.next_say()
    audio.supervisor.silence_speech(audio.now)
    audio.supervisor.close()
    (silence, kill) = audio.supervisor.advance(audio.now)

    assert isinstance(silence, SendRequest)
    assert isinstance(silence.request, Silence)
    assert kill == KillWorker()
    assert audio.supervisor.next_at() is None


@pytest.mark.parametrize("language", ["en", "fr"])
def test_a_sentence_without_words_is_not_sent(audio: Supervised, language: str) -> None:
    audio.become_ready()
    audio.say("\a", language=language)

    assert audio.steps() == []
    assert audio.supervisor.is_quiet


def test_a_request_is_sent_with_a_heartbeat_and_each_has_a_number_of_its_own(audio: Supervised) -> None:
    audio.become_ready()
    audio.say("one")
    requests = [step.request for step in audio.supervisor.advance(audio.now) if isinstance(step, SendRequest)]
    audio.supervisor.silence_speech(audio.now)
    audio.say("two")
    requests += [
        step.request for step in audio.supervisor.advance(audio.now) if isinstance(step, SendRequest)
    ]

    assert [type(each) for each in requests] == [Say, Ping, Silence, Say]
    numbers = [each.number for each in requests if not isinstance(each, PlayCue)]
    assert len(set(numbers)) == 4
    say, ping, silence, second = numbers
    audio.respond(SpeechFinished(say), SpeechFinished(ping), SpeechFinished(silence))
    assert audio.supervisor.is_speaking
    audio.respond(SpeechFinished(second))
    assert audio.supervisor.is_quiet


def test_cues_that_are_silenced_before_there_is_a_worker_are_dropped(audio: Supervised) -> None:
    audio.play("bump")
    audio.supervisor.silence_cues(audio.now)

    assert audio.steps() == [StartWorker(False)]
    assert audio.steps() == []


@pytest.mark.parametrize("responses", [(SoundReady("fake"), VoiceReady(("en",)))])
def test_a_worker_is_ready_whichever_it_reports_first(
    responses: tuple[AudioResponse, AudioResponse],
) -> None:
    for first, second in (responses, responses[::-1]):
        audio = Supervised()
        audio.supervisor.warm_up()
        audio.steps()
        audio.respond(first)
        assert audio.supervisor.state is WorkerState.STARTING
        audio.respond(second)
        assert audio.supervisor.state is WorkerState.READY
        audio.now += 11.0
        assert audio.steps() == []


def test_the_volumes_of_cues_may_change(audio: Supervised) -> None:
    audio.become_ready()
    audio.supervisor.set_cue_volumes({"bump": 0.5})
    audio.play("bump")

    assert audio.steps() == [SendRequest(PlayCue("bump", 0.0, None, 0.5, 0.0))]
