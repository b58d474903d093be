"""What is decided about the worker, without a worker: answers and times go in, steps come out."""

import pytest

from devices.audio_worker.conductor import Conductor
from devices.audio_worker.messages import (
    Answer,
    Finished,
    Hush,
    Hushed,
    Ping,
    PlayCue,
    Pong,
    Say,
    SoundReady,
    Started,
    VoiceReady,
    from_line,
    to_line,
)
from devices.audio_worker.notices import AudioNotice, NoticeCode
from devices.audio_worker.steps import Kill, Send, Start, Step, Tell
from devices.ports.audio import Cue, Urgency, Utterance
from devices.speech.voices import VoiceSettings

KILL_AND_START = [Kill(), Start(False)]


class Stage:
    """A conductor, its clock, and the steps that it asked for."""

    def __init__(self, volumes: dict[str, float] | None = None) -> None:
        self.conductor = Conductor(VoiceSettings(), volumes or {})
        self.now = 100.0

    def say(self, text: str, urgency: Urgency = Urgency.PROGRAM, language: str = "en") -> None:
        self.conductor.say(Utterance(text, urgency, language), self.now)

    def play(self, name: str) -> None:
        self.conductor.play(Cue(name), self.now)

    def steps(self) -> list[Step]:
        """All but the heartbeat's."""
        taken = self.conductor.advance(self.now)
        return [step for step in taken if not (isinstance(step, Send) and isinstance(step.order, Ping))]

    def answer(self, *answers: Answer) -> None:
        for answer in answers:
            self.conductor.answered(answer, self.now)

    def get_ready(self, *languages: str) -> None:
        self.conductor.warm_up()
        assert self.steps() == [Start(False)]
        self.answer(SoundReady("fake"), VoiceReady(list(languages or ("en", "pt", "es"))))

    def next_say(self) -> Say:
        """The sentence that is sent now."""
        sent = [step.order for step in self.steps() if isinstance(step, Send)]
        (order,) = (order for order in sent if isinstance(order, Say))
        return order

    def hear(self, sentence: Say) -> None:
        self.answer(Started(sentence.number, 1.0), Finished(sentence.number))

    def fail(self) -> None:
        self.conductor.ended(self.now)


@pytest.fixture
def stage() -> Stage:
    return Stage()


def test_nothing_is_started_before_something_is_to_be_heard(stage: Stage) -> None:
    assert stage.steps() == []
    assert stage.conductor.next_date() is None
    assert stage.conductor.is_quiet


def test_the_first_sentence_starts_the_worker_and_waits_for_it(stage: Stage) -> None:
    stage.say("Hello.")

    assert stage.steps() == [Start(False)]
    assert stage.steps() == []
    assert not stage.conductor.is_quiet


def test_a_sentence_is_sent_in_words_for_the_ear(stage: Stage) -> None:
    stage.get_ready()
    stage.say("x=-3", language="pt")

    sentence = stage.next_say()
    assert (sentence.text, sentence.language) == ("x igual a menos 3", "pt")


def test_one_sentence_at_a_time_in_order(stage: Stage) -> None:
    stage.get_ready()
    for text in ("one", "two", "three"):
        stage.say(text)
    heard = []
    while not stage.conductor.is_quiet:
        sentence = stage.next_say()
        assert stage.steps() == []
        heard.append(sentence.text)
        stage.hear(sentence)

    assert heard == ["one", "two", "three"]


def test_the_voice_is_clamped_and_may_change_between_sentences(stage: Stage) -> None:
    stage.get_ready()
    stage.conductor.set_voice(VoiceSettings(words_per_minute=9_999, pitch=60, volume=0.5))
    stage.say("Fast.")

    sentence = stage.next_say()
    assert (sentence.words_per_minute, sentence.pitch, sentence.volume) == (450, 60, 0.5)


def test_silence_ends_the_sentence_and_forgets_what_waits(stage: Stage) -> None:
    stage.get_ready()
    stage.say("one")
    stage.say("two")
    sentence = stage.next_say()
    stage.conductor.hush_speech(stage.now)
    (step,) = stage.steps()

    assert isinstance(step, Send)
    assert isinstance(step.order, Hush)
    assert (step.order.speech, step.order.cues) == (True, False)
    assert stage.conductor.is_quiet
    stage.answer(Hushed(step.order.number), Finished(sentence.number))
    assert stage.steps() == []


def test_a_sentence_lost_with_its_worker_is_not_said_after_a_silence(stage: Stage) -> None:
    stage.get_ready()
    stage.say("one")
    stage.next_say()
    stage.fail()
    stage.conductor.hush_speech(stage.now)

    assert stage.conductor.is_quiet
    stage.steps()
    stage.answer(SoundReady("fake"), VoiceReady(["en"]))
    assert stage.steps() == []


def test_what_is_said_after_a_silence_is_sent_after_it(stage: Stage) -> None:
    stage.get_ready()
    stage.say("one")
    stage.next_say()
    stage.conductor.hush_speech(stage.now)
    stage.say("two")
    orders = [type(step.order) for step in stage.steps() if isinstance(step, Send)]

    assert orders == [Hush, Say]


def test_silence_where_nothing_sounds_sends_nothing(stage: Stage) -> None:
    stage.conductor.hush_speech(stage.now)
    stage.conductor.hush_cues(stage.now)
    assert stage.steps() == []

    stage.get_ready()
    stage.conductor.hush_speech(stage.now)
    assert stage.steps() == []


def test_a_worker_that_does_not_hush_is_ended_before_the_ear_notices(stage: Stage) -> None:
    stage.get_ready()
    stage.say("one")
    stage.next_say()
    stage.conductor.hush_speech(stage.now)
    stage.steps()
    stage.now += 0.121

    assert stage.conductor.next_date() is not None
    assert stage.steps() == KILL_AND_START


def test_workers_that_do_not_hush_are_no_failures(stage: Stage) -> None:
    for _ in range(10):
        stage.conductor.warm_up()
        stage.steps()
        stage.answer(SoundReady("fake"), VoiceReady(["en"]))
        stage.say("one")
        stage.next_say()
        stage.conductor.hush_speech(stage.now)
        stage.steps()
        stage.now += 0.2

    assert stage.steps() == KILL_AND_START


def test_an_alert_cuts_progress_but_not_an_answer(stage: Stage) -> None:
    stage.get_ready()
    stage.say("Still walking.", Urgency.PROGRESS)
    stage.next_say()
    stage.say("Bump.", Urgency.ALERT)
    assert [type(step.order) for step in stage.steps() if isinstance(step, Send)] == [Hush, Say]

    stage.say("Stopped.", Urgency.ALERT)
    assert stage.steps() == []


def test_a_cue_from_before_the_worker_was_ready_is_left_out_when_it_would_mislead(stage: Stage) -> None:
    stage.play("step-forward")
    stage.play("bump")
    stage.steps()
    stage.now += 1.5
    stage.answer(SoundReady("fake"))

    assert stage.steps() == [Send(PlayCue("bump", 0.0, None, 1.0, 0.0))]


def test_an_unknown_cue_and_one_switched_off_are_not_played() -> None:
    stage = Stage(volumes={"step-forward": 0.0, "bump": 7.0})
    stage.get_ready()
    for name in ("trumpet", "step-forward", "bump"):
        stage.play(name)

    assert stage.steps() == [Send(PlayCue("bump", 0.0, None, 1.0, 0.0))]


def test_hushed_cues_are_not_sent(stage: Stage) -> None:
    stage.play("bump")
    stage.steps()
    stage.conductor.hush_cues(stage.now)
    stage.answer(SoundReady("fake"))

    assert not any(isinstance(step, Send) and isinstance(step.order, PlayCue) for step in stage.steps())


def test_a_full_backlog_is_told_once(stage: Stage) -> None:
    for number in range(20_000):
        stage.say(str(number))

    assert stage.steps() == [Tell(AudioNotice(NoticeCode.SPEECH_BACKLOG)), Start(False)]


def test_after_closing_nothing_happens(stage: Stage) -> None:
    stage.get_ready()
    stage.say("Hello.")
    stage.conductor.close()
    assert stage.steps() == [Kill()]

    stage.say("Hello.")
    stage.play("bump")
    stage.conductor.warm_up()
    stage.conductor.close()
    stage.fail()
    assert stage.steps() == []


@pytest.mark.parametrize(
    "message",
    [
        Say(1, 'Olá "você"\n\ud800', "pt", 180, 50, 1.0),
        PlayCue("bump", -90.0, None, 0.5, 0.07),
        Hush(2, True, False),
        VoiceReady(["en", "pt"]),
        Pong(3, -1, False),
    ],
)
def test_a_message_survives_the_pipe(message: Say | PlayCue | Hush | Answer) -> None:
    line = to_line(message)

    assert line.count(b"\n") == 1
    assert from_line(line) == message


@pytest.mark.parametrize(
    "line",
    [
        b"",
        b"\n",
        b"ALSA lib pcm.c: Unknown PCM",
        b"[]",
        b"{}",
        b'{"is": "Dance"}',
        b'{"is": "Ping"}',
        b'{"is": ["Ping"]}',
        b'{"is": "Ping", "number": 1, "more": 2}',
        b"\xff\xfe",
        pytest.param(b"[" * 100_000, id="deep"),
    ],
)
def test_a_line_that_makes_no_sense_is_no_message(line: bytes) -> None:
    assert from_line(line) is None
