"""The audio service with a worker that the test plays: what it starts, sends, takes in and reports."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from devices.audio import service as module
from devices.audio.process import (
    PlayCue,
    Say,
    Silence,
    SoundReady,
    SpeechFinished,
    SpeechStarted,
    VoiceReady,
)
from devices.audio.pronunciation import SpokenLanguage
from devices.audio.service import AudioService, AudioSettings
from devices.audio.supervisor import WorkerState
from devices.ports.audio import (
    AudioNotice,
    Cue,
    NoticeCode,
    Urgency,
    Utterance,
    VoiceSettings,
)
from tests.timeouts import TIMEOUT

ENGLISH = {"en": SpokenLanguage(("en-gb", "en"), None)}


class Worker:
    """Records what it is started with and sent, and whether it was killed."""

    def __init__(self, *given: Any, on_response: Callable[[Any], None], on_end: Callable[[], None]) -> None:
        self.given, self.respond, self.end = given, on_response, on_end
        self.pid, self.sent, self.killed = 4711, list[Any](), 0
        self.changed = threading.Condition()

    def send(self, request: Any) -> None:
        with self.changed:
            self.sent.append(request)
            self.changed.notify_all()

    def kill(self) -> None:
        with self.changed:
            self.killed += 1
            self.changed.notify_all()

    def next(self, kind: type[Any]) -> Any:
        """The next request of that kind."""

        def found() -> Any:
            for each in self.sent:
                if isinstance(each, kind):
                    self.sent.remove(each)
                    return each
            return None

        with self.changed:
            request = self.changed.wait_for(found, TIMEOUT)
        assert request is not None
        return request

    def is_ready(self) -> None:
        self.respond(SoundReady("fake"))
        self.respond(VoiceReady(("en",)))


class Service:
    def __init__(self, patch: pytest.MonkeyPatch, settings: AudioSettings) -> None:
        self.workers: list[Worker] = []
        self.problems: list[OSError] = []
        self._started = threading.Condition()
        patch.setattr(module, "WorkerProcess", self._start)
        self.notices: list[AudioNotice] = []
        self._noticed = threading.Event()
        self.audio = AudioService(settings, self._notice)

    def _notice(self, notice: AudioNotice) -> None:
        self.notices.append(notice)
        self._noticed.set()

    def _start(self, *given: Any, **callbacks: Any) -> Worker:
        with self._started:
            if self.problems:
                raise self.problems[0]
            self.workers.append(Worker(*given, **callbacks))
            self._started.notify_all()
            return self.workers[-1]

    def worker(self, number: int = 0) -> Worker:
        with self._started:
            assert self._started.wait_for(lambda: len(self.workers) > number, TIMEOUT)
        return self.workers[number]

    def is_noticed(self) -> bool:
        return self._noticed.wait(TIMEOUT)


@pytest.fixture
def service(monkeypatch: pytest.MonkeyPatch) -> Iterator[Service]:
    made = Service(monkeypatch, AudioSettings(languages=ENGLISH))
    yield made
    made.audio.close()


def test_nothing_is_started_before_it_is_needed(service: Service) -> None:
    audio = service.audio
    assert (audio.worker_pid, audio.player, audio.languages) == (None, "", ())
    assert (audio.state, audio.is_speaking, audio.is_quiet, audio.is_mute) == (
        WorkerState.IDLE, False, True, False,
    )  # fmt: skip
    assert audio.wait_until_quiet(0.0)
    assert audio.wait_until_silent(0.0)
    assert not audio.wait_until_ready(0.0)
    audio.set_voice(VoiceSettings(100))
    audio.set_cue_volumes({"bump": 0.5})
    assert service.workers == []


def test_a_worker_is_started_with_the_settings(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    settings = AudioSettings(
        device="null", log=tmp_path / "log", sounds=tmp_path / "sounds", languages=ENGLISH
    )
    made = Service(monkeypatch, settings)
    made.audio.warm_up()
    worker = made.worker()
    assert worker.given == (
        "null", False, tmp_path / "log", tmp_path / "sounds", {"en": ("en-gb", "en")},
    )  # fmt: skip
    worker.is_ready()

    assert made.audio.wait_until_ready(TIMEOUT)
    assert (made.audio.player, made.audio.languages, made.audio.worker_pid) == ("fake", ("en",), 4711)
    made.audio.close()
    assert worker.killed == 1
    assert (made.audio.worker_pid, made.audio.state, made.audio.is_mute) == (None, WorkerState.CLOSED, True)


def test_a_sentence_is_sent_and_waited_for_until_it_was_said(service: Service) -> None:
    audio = service.audio
    audio.set_voice(VoiceSettings(100, 20, 0.5))
    audio.say(Utterance("Hello.", Urgency.ANSWER, "en"))
    worker = service.worker()
    worker.is_ready()
    said = worker.next(Say)
    assert said == Say(said.number, "Hello.", "en", 100, 20, 0.5)
    assert (audio.is_speaking, audio.is_quiet) == (True, False)
    assert not audio.wait_until_quiet(0.0)
    assert not audio.wait_until_silent(0.0)
    worker.respond(SpeechStarted(said.number, 0.1))
    worker.respond(SpeechFinished(said.number))

    assert audio.wait_until_quiet(TIMEOUT)
    assert (audio.is_speaking, audio.is_quiet) == (False, True)


def test_cues_and_silences_are_sent(service: Service) -> None:
    audio = service.audio
    audio.set_cue_volumes({"bump": 0.25})
    audio.play(Cue("bump"))
    worker = service.worker()
    worker.is_ready()
    assert worker.next(PlayCue) == PlayCue("bump", 0.0, None, 0.25, 0.0)
    audio.silence_cues()
    silence = worker.next(Silence)
    assert (silence.speech, silence.cues) == (False, True)
    audio.say(Utterance("Hello.", Urgency.ANSWER, "en"))
    worker.next(Say)
    audio.silence_speech()
    silence = worker.next(Silence)
    assert (silence.speech, silence.cues) == (True, False)


def test_a_worker_that_ends_is_replaced_and_what_it_sends_later_is_ignored(service: Service) -> None:
    audio = service.audio
    audio.warm_up()
    first = service.worker()
    first.is_ready()
    assert audio.wait_until_ready(TIMEOUT)
    first.end()
    second = service.worker(1)
    first.respond(SoundReady("late"))
    first.end()
    assert audio.player != "late"
    second.is_ready()

    assert audio.wait_until_ready(TIMEOUT)
    assert (audio.player, len(service.workers)) == ("fake", 2)


def test_a_machine_that_starts_no_worker_is_given_up_and_that_is_reported_once(service: Service) -> None:
    service.problems.append(OSError(12, "Cannot allocate memory"))
    service.audio.warm_up()

    assert service.is_noticed()
    assert service.audio.wait_until_ready(TIMEOUT)
    assert (service.audio.state, service.audio.is_mute) == (WorkerState.GIVEN_UP, True)
    assert [each.code for each in service.notices] == [NoticeCode.AUDIO_GAVE_UP]


def test_a_closed_service_starts_nothing_and_may_be_closed_again(service: Service) -> None:
    service.audio.close()
    service.audio.say(Utterance("Hello.", Urgency.ANSWER, "en"))
    service.audio.close()

    assert service.audio._writer is None
    assert (service.workers, service.audio.is_mute) == ([], True)


@pytest.mark.parametrize(
    ("until", "now", "away"), [(100.0, 100.5, None), (100.0, 100.75, 1.25), (None, 900.0, None)]
)
def test_a_writer_that_oversleeps_by_half_a_second_was_suspended(
    service: Service, monkeypatch: pytest.MonkeyPatch, until: float | None, now: float, away: float | None
) -> None:
    """And by so much more all deadlines are later."""
    postponed: list[float] = []
    waits: list[float | None] = []
    monkeypatch.setattr(service.audio, "_supervisor", SimpleNamespace(was_away=postponed.append))
    monkeypatch.setattr(service.audio, "_changed", SimpleNamespace(wait=waits.append))
    times = [99.75, now]
    monkeypatch.setattr(module, "monotonic", lambda: times.pop(0))
    service.audio._sleep(until)

    assert waits == [None if until is None else 0.25]
    assert postponed == ([] if away is None else [away])
    monkeypatch.undo()
