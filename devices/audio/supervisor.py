"""Decides what the audio worker does next: starts and restarts it, feeds it, gives it up. No I/O.

IDLE -> STARTING -> READY        the first sentence or cue starts the worker
STARTING, READY -> IDLE          it failed, and will be started again
any -> SILENT, GIVEN_UP, CLOSED  final: no device, three failures in a minute, the end

What happens comes in through the methods, each with its time. ``advance`` returns the steps to be carried
out, in order; ``next_at`` says when to call it again at the latest. ``SentenceTracker`` and ``CueQueue`` keep
what waits to sound, ``WorkerStatus`` what is known of the worker: what it has found, and by when it must
respond. The supervisor connects them.

Not thread-safe: its owner holds a lock."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from enum import Enum, auto
from types import MappingProxyType
from typing import assert_never

from msgspec import Struct

from devices.audio.mixer import CueQueue
from devices.audio.process import (
    AudioRequest,
    AudioResponse,
    Ping,
    Pong,
    Say,
    Silence,
    Silenced,
    SoundReady,
    SpeechFinished,
    SpeechRefused,
    SpeechStarted,
    VoiceReady,
)
from devices.audio.pronunciation import ENGLISH_ONLY, SpokenLanguage, sign_words, speakable_text
from devices.audio.speech_queue import QueueResult, SentenceTracker, SpokenSentence
from devices.ports.audio import AudioNotice, Cue, NoticeCode, Utterance, VoiceSettings, base_language

RESPONSE_LIMIT = 3.0
"""Seconds without a response or a frame played, after which a worker counts as frozen."""

START_LIMIT = 10.0
"""Seconds for opening the device and loading the voice, on a slow machine with a cold disk."""

SILENCE_LIMIT = 0.12
"""Seconds; silence must follow within 0.15, and killing the group takes a few milliseconds."""

PING_INTERVAL = 1.0
"""Seconds between heartbeats. They are sent only while something should sound: an idle worker may sleep."""

MOST_FAILURES = 3
FAILURE_WINDOW = 60.0


class WorkerState(Enum):
    """The state of the worker."""

    IDLE = auto()
    STARTING = auto()
    READY = auto()
    SILENT = auto()
    GIVEN_UP = auto()
    CLOSED = auto()

    @property
    def is_running(self) -> bool:
        return self in _RUNNING

    @property
    def is_final(self) -> bool:
        """Whether no worker will be started any more."""
        return self in _FINAL

    def may_become(self, state: WorkerState) -> bool:
        return state in _NEXT[self]


_S = WorkerState
_RUNNING = frozenset({_S.STARTING, _S.READY})
_FINAL = frozenset({_S.SILENT, _S.GIVEN_UP, _S.CLOSED})
_NEXT: Mapping[WorkerState, frozenset[WorkerState]] = MappingProxyType(
    {
        _S.IDLE: frozenset({_S.STARTING, _S.GIVEN_UP, _S.CLOSED}),
        _S.STARTING: frozenset({_S.READY, _S.IDLE, _S.SILENT, _S.GIVEN_UP, _S.CLOSED}),
        _S.READY: frozenset({_S.IDLE, _S.GIVEN_UP, _S.CLOSED}),
        _S.SILENT: frozenset({_S.CLOSED}),
        _S.GIVEN_UP: frozenset({_S.CLOSED}),
        _S.CLOSED: frozenset(),
    }
)


class Awaited(Enum):
    """A task that a worker must do in time."""

    START = auto()
    PONG = auto()
    SPEECH_STARTED = auto()
    SPEECH_FINISHED = auto()
    SILENCED = auto()
    PLAYBACK = auto()
    """Play frames, while the player reports that it plays."""


class Deadlines:
    """The times by which one worker must do what is awaited."""

    def __init__(self) -> None:
        self._times: dict[Awaited, float] = {}
        self._frames = -1

    def expect(self, what: Awaited, by: float) -> None:
        """An earlier deadline for the same is kept."""
        self._times.setdefault(what, by)

    def met(self, *what: Awaited) -> None:
        """It was done, or is no longer awaited."""
        for each in what:
            self._times.pop(each, None)

    def expects(self, what: Awaited) -> bool:
        return what in self._times

    def heartbeat(self, frames: int, is_playing: bool, now: float) -> None:
        """``frames``: given to the device so far, -1 if that is unknown."""
        if not is_playing or frames != self._frames:
            self.met(Awaited.PLAYBACK)
        if is_playing and frames >= 0:
            self.expect(Awaited.PLAYBACK, now + RESPONSE_LIMIT)
        self._frames = frames

    def postpone(self, seconds: float) -> None:
        """Add seconds in which this process did not run: it was suspended, or the machine was busy."""
        self._times = {what: time + seconds for what, time in self._times.items()}

    def overdue(self, now: float) -> Awaited | None:
        """What should have been done by ``now``, or None."""
        return next((what for what, time in self._times.items() if now >= time), None)

    def next_at(self) -> float | None:
        """When to check again."""
        return min(self._times.values(), default=None)


class WorkerStatus:
    """What is known of one worker, or of none yet. The next worker gets a new status."""

    def __init__(self) -> None:
        self.deadlines = Deadlines()
        self.player = ""
        """The name of the player that it opened; empty while that is unknown."""
        self.languages: tuple[str, ...] | None = None
        """The languages that it has voices for; None while that is unknown."""
        self._next_ping: float | None = None

    @property
    def is_ready(self) -> bool:
        """Whether it has reported both the device and the voices."""
        return bool(self.player) and self.languages is not None

    @property
    def has_no_voice(self) -> bool:
        """Whether it looked for voices and found none."""
        return self.languages == ()

    def can_read(self, base_language: str) -> bool:
        return base_language in (self.languages or ())

    def must_ping(self, has_sent: bool, now: float) -> bool:
        """Whether to send a heartbeat now: with every other request, and then as long as a sentence lasts.

        The response is then awaited.
        """
        is_time = self._next_ping is not None and now >= self._next_ping
        if not (is_time or has_sent) or self.deadlines.expects(Awaited.PONG):
            return False
        self._next_ping = None
        self.deadlines.expect(Awaited.PONG, now + RESPONSE_LIMIT)
        return True

    def pong_received(self, pong: Pong, is_speaking: bool, now: float) -> None:
        self.deadlines.met(Awaited.PONG)
        self.deadlines.heartbeat(pong.frames, pong.is_playing, now)
        if is_speaking or pong.is_playing:
            self._next_ping = now + PING_INTERVAL

    def next_at(self) -> float | None:
        """When to check it again."""
        times = (self.deadlines.next_at(), self._next_ping)
        return min((time for time in times if time is not None), default=None)


class FailureCounter:
    """Counts failures; three in a minute are too many."""

    def __init__(self) -> None:
        self._times: deque[float] = deque(maxlen=MOST_FAILURES)

    def add(self, now: float) -> bool:
        """One more at ``now``. True if it is time to give up."""
        self._times.append(now)
        return len(self._times) == MOST_FAILURES and now - self._times[0] <= FAILURE_WINDOW


_MOST_NOTICES = 32
"""A limit for the languages without a voice that are reported: a program may name any number."""


class StartWorker(Struct, frozen=True):
    """``prefer_bundled_voice``: the last worker died while it loaded the system's voice."""

    prefer_bundled_voice: bool


class SendRequest(Struct, frozen=True):
    request: AudioRequest


class KillWorker(Struct, frozen=True):
    """End the worker and everything that it started."""


class Notify(Struct, frozen=True):
    notice: AudioNotice


Step = StartWorker | SendRequest | KillWorker | Notify


class WorkerSupervisor:
    """What is to sound, and the worker that plays it."""

    def __init__(
        self,
        voice: VoiceSettings,
        cue_volumes: Mapping[str, float],
        languages: Mapping[str, SpokenLanguage] = ENGLISH_ONLY,
    ) -> None:
        """``cue_volumes``: 0 to 1 by the name of a cue, 1 where none is given; 0 switches it off."""
        self._voice = voice.clamped()
        self._languages = languages
        self.state = WorkerState.IDLE
        self._is_wanted = False
        self._sentences = SentenceTracker(self._new_number)
        self._cues = CueQueue(cue_volumes)
        self._worker = WorkerStatus()
        self._steps: list[Step] = []
        self._notified: set[AudioNotice] = set()
        self._failures = FailureCounter()
        self._number = 0
        self._last_silence = 0
        self._prefer_bundled_voice = False

    @property
    def player(self) -> str:
        """The name of the worker's player; empty while that is unknown, or where there is none."""
        return self._worker.player

    @property
    def languages(self) -> tuple[str, ...]:
        """The languages of the voices that were found; empty while that is unknown."""
        return self._worker.languages or ()

    @property
    def is_quiet(self) -> bool:
        """Whether no sentence is being said or waits."""
        return not self._sentences

    @property
    def is_speaking(self) -> bool:
        """Whether the worker has a sentence to say."""
        return self._sentences.current is not None

    def is_silent(self, now: float) -> bool:
        """Whether no sentence and no cue sounds or waits."""
        return self.is_quiet and self._cues.are_over(now)

    def warm_up(self) -> None:
        """Have a worker ready before there is something to play."""
        self._is_wanted = True

    def set_voice(self, voice: VoiceSettings) -> None:
        """Set the voice of later sentences."""
        self._voice = voice.clamped()

    def set_cue_volumes(self, volumes: Mapping[str, float]) -> None:
        """Set the volumes of later cues."""
        self._cues.set_volumes(volumes)

    def say(self, utterance: Utterance, now: float) -> None:
        if self.state.is_final or self._worker.has_no_voice:
            return
        if self._sentences.offer(utterance, now) is QueueResult.REFUSED:
            self._notify(NoticeCode.SPEECH_BACKLOG)
        self._is_wanted = True
        if self._sentences.is_interrupted_by(utterance):
            self._interrupt_speech(now)

    def play(self, cue: Cue, now: float) -> None:
        if not self.state.is_final and self._cues.offer(cue, now):
            self._is_wanted = True

    def silence_speech(self, now: float) -> None:
        """Drop all sentences of until now, the one that is being said included."""
        self._sentences.clear()
        self._interrupt_speech(now)

    def silence_cues(self, now: float) -> None:
        is_audible = self._cues.silence(now)
        self._silence(False, True, is_audible, now)

    def close(self) -> None:
        self._end_worker(WorkerState.CLOSED)

    def received(self, response: AudioResponse, now: float) -> None:
        """The worker has sent ``response``; one that was killed meanwhile has no effect."""
        if not self.state.is_running:
            return
        deadlines, sentences = self._worker.deadlines, self._sentences
        match response:
            case SoundReady(player=player):
                self._sound_ready(player)
            case VoiceReady(languages=languages):
                self._voice_ready(languages)
            case SpeechStarted(number=number, seconds=seconds) if sentences.is_current(number):
                deadlines.met(Awaited.SPEECH_STARTED)
                deadlines.expect(Awaited.SPEECH_FINISHED, now + seconds + RESPONSE_LIMIT)
            case SpeechFinished(number=number) if sentences.is_current(number):
                self._end_sentence()
            case SpeechRefused(number=number) if sentences.current and sentences.is_current(number):
                self._notify_missing(base_language(sentences.current.utterance.language))
                self._end_sentence()
            case Silenced(number=number) if number == self._last_silence:
                deadlines.met(Awaited.SILENCED)
            case Pong():
                self._worker.pong_received(response, self.is_speaking, now)
            case SpeechStarted() | SpeechFinished() | SpeechRefused() | Silenced():
                pass  # about something that was silenced meanwhile
            case _:
                assert_never(response)

    def ended(self, now: float) -> None:
        """The present worker ended by itself, or could not be started."""
        if self.state.is_running:
            self._failed(now)

    def was_away(self, seconds: float) -> None:
        """This process did not run for so long, so a response may lie there unread."""
        self._worker.deadlines.postpone(seconds)

    def advance(self, now: float) -> tuple[Step, ...]:
        """The steps to be carried out now."""
        self._check_deadlines(now)
        if self.state is WorkerState.IDLE and self._is_wanted:
            self._become(WorkerState.STARTING)
            self._worker.deadlines.expect(Awaited.START, now + START_LIMIT)
            self._steps.append(StartWorker(self._prefer_bundled_voice))
        if self.state.is_running:
            self._send_cues(now)
            self._send_sentence(now)
            self._send_ping(now)
        steps, self._steps = tuple(self._steps), []
        return steps

    def next_at(self) -> float | None:
        """When ``advance`` has something to do at the latest, if nothing happens before."""
        return self._worker.next_at()

    def _check_deadlines(self, now: float) -> None:
        overdue = self._worker.deadlines.overdue(now)
        if overdue is Awaited.SILENCED:  # silence comes first; a busy machine is not counted as a failure
            self._end_worker(WorkerState.IDLE)
        elif overdue is not None:
            self._failed(now)

    # --- requests to the worker

    def _send_cues(self, now: float) -> None:
        if self._worker.player:
            for request in self._cues.take(now):
                self._send(request)

    def _send_sentence(self, now: float) -> None:
        while self.state is WorkerState.READY and not self.is_speaking:
            sentence = self._sentences.take()
            if sentence is None:
                return
            utterance = sentence.utterance
            words = sign_words(utterance.language, self._languages)
            text = speakable_text(utterance.text, words, self._voice.punctuation)
            if text and self._can_read(utterance.language):
                self._send_text(sentence, text, now)

    def _send_text(self, sentence: SpokenSentence, text: str, now: float) -> None:
        self._sentences.current = sentence
        language, voice = base_language(sentence.utterance.language), self._voice
        self._send(Say(sentence.number, text, language, voice.words_per_minute, voice.pitch, voice.volume))
        self._worker.deadlines.expect(Awaited.SPEECH_STARTED, now + RESPONSE_LIMIT)

    def _send_ping(self, now: float) -> None:
        has_sent = any(isinstance(step, SendRequest) for step in self._steps)
        if self._worker.must_ping(has_sent, now):
            self._send(Ping(self._new_number()))

    def _silence(self, speech: bool, cues: bool, is_audible: bool, now: float) -> None:
        if not self.state.is_running or not is_audible:
            return
        self._last_silence = self._new_number()
        self._send(Silence(self._last_silence, speech, cues))
        self._worker.deadlines.expect(Awaited.SILENCED, now + SILENCE_LIMIT)

    def _interrupt_speech(self, now: float) -> None:
        was_speaking = self.is_speaking
        self._end_sentence()
        self._silence(True, False, was_speaking, now)

    def _end_sentence(self) -> None:
        self._sentences.current = None
        self._worker.deadlines.met(Awaited.SPEECH_STARTED, Awaited.SPEECH_FINISHED)

    def _send(self, request: AudioRequest) -> None:
        self._steps.append(SendRequest(request))

    def _new_number(self) -> int:
        self._number += 1
        return self._number

    # --- the worker's life

    def _sound_ready(self, player: str) -> None:
        if player:
            self._worker.player = player
            self._become_ready()
        else:
            self._notify(NoticeCode.NO_SOUND_DEVICE)
            self._end_worker(WorkerState.SILENT)

    def _voice_ready(self, languages: tuple[str, ...]) -> None:
        self._worker.languages = languages
        if not languages:
            self._notify(NoticeCode.NO_VOICE)
            self._sentences.clear()
        self._become_ready()

    def _become_ready(self) -> None:
        if self._worker.is_ready:
            self._worker.deadlines.met(Awaited.START)
            self._become(WorkerState.READY)

    def _failed(self, now: float) -> None:
        self._prefer_bundled_voice = self._prefer_bundled_voice or self._worker.languages is None
        self._sentences.retry()
        if self._failures.add(now):
            self._notify(NoticeCode.AUDIO_GAVE_UP)
            self._end_worker(WorkerState.GIVEN_UP)
        else:
            self._end_worker(WorkerState.IDLE)

    def _end_worker(self, state: WorkerState) -> None:
        if self.state.is_running:
            self._steps.append(KillWorker())
        self._become(state)
        self._worker = WorkerStatus()
        self._sentences.current = None
        if state.is_final:
            self._sentences.clear()
            self._cues.clear()

    def _become(self, state: WorkerState) -> None:
        if self.state.may_become(state):
            self.state = state

    # --- notices

    def _can_read(self, language: str) -> bool:
        base = base_language(language)
        can_read = self._worker.can_read(base)
        if not can_read:
            self._notify_missing(base)
        return can_read

    def _notify_missing(self, language: str) -> None:
        if len(self._notified) < _MOST_NOTICES:
            self._notify(NoticeCode.VOICE_MISSING, language)

    def _notify(self, code: NoticeCode, language: str = "") -> None:
        notice = AudioNotice(code, language)
        if notice not in self._notified:
            self._notified.add(notice)
            self._steps.append(Notify(notice))
