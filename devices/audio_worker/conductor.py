"""Decides what the audio worker does next; starts, sends and kills nothing itself.

Sans-IO: what happens comes in by the methods, each with its time; ``advance`` gives back the steps to be
taken, in order, and ``next_date`` when to come back at the latest. One sentence at a time goes to the
worker, so that an alert waits for one sentence and no more.

    IDLE -> STARTING -> READY        the worker is started by the first thing to be heard
    STARTING, READY -> IDLE          it failed, and will be started anew
    any -> SILENT, GIVEN_UP, CLOSED  for good: no device, three failures in a minute, the end

Not thread-safe: its owner holds a lock.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum, auto
from types import MappingProxyType
from typing import assert_never

from devices.audio_worker.messages import (
    Answer,
    Finished,
    Hush,
    Hushed,
    Order,
    Ping,
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
from devices.audio_worker.watch import ANSWER_LIMIT, HUSH_LIMIT, START_LIMIT, Due, Failures, Watch
from devices.ports.audio import Cue, Utterance
from devices.ports.values import frozen
from devices.sound.cue_policy import NEVER_LEFT_OUT, CuePolicy
from devices.sound.tones import CUE_NAMES, seconds_of
from devices.speech.ear import for_the_ear
from devices.speech.policy import Offer, SpeechQueue, cuts
from devices.speech.voices import VoiceSettings, base_language

PING_INTERVAL = 1.0
"""Seconds between heartbeats, only while something should be heard: an idle worker is left asleep."""

STALE_CUE = 1.0
"""Seconds after which a cue that could not be played would only mislead. A bump is told even then."""

MOST_TRIES = 2
"""A sentence that kills two workers is not given to a third."""

_MOST_WAITING_CUES = 16


class State(Enum):
    """What there is of a worker."""

    IDLE = auto()
    STARTING = auto()
    READY = auto()
    SILENT = auto()
    GIVEN_UP = auto()
    CLOSED = auto()


_RUNNING = frozenset({State.STARTING, State.READY})
_FOR_GOOD = frozenset({State.SILENT, State.GIVEN_UP, State.CLOSED})
_NEXT: Mapping[State, frozenset[State]] = MappingProxyType(
    {
        State.IDLE: frozenset({State.STARTING, State.GIVEN_UP, State.CLOSED}),
        State.STARTING: frozenset({State.READY, State.IDLE, State.SILENT, State.GIVEN_UP, State.CLOSED}),
        State.READY: frozenset({State.IDLE, State.GIVEN_UP, State.CLOSED}),
        State.SILENT: frozenset({State.CLOSED}),
        State.GIVEN_UP: frozenset({State.CLOSED}),
        State.CLOSED: frozenset(),
    }
)


@dataclass(slots=True)
class _Sentence:
    """The one that the worker has."""

    number: int
    utterance: Utterance
    tries: int


@frozen
class _WaitingCue:
    cue: Cue
    due: float


class Conductor:
    """What is to be heard, and the worker that makes it heard."""

    def __init__(self, voice: VoiceSettings, cue_volumes: Mapping[str, float]) -> None:
        """``cue_volumes``: 0 to 1 by the name of a cue, 1 where none is given; 0 leaves it out."""
        self._voice = voice.clamped()
        self._cue_volumes = dict(cue_volumes)
        self._state = State.IDLE
        self._wanted = False
        self._queue = SpeechQueue()
        self._cue_policy = CuePolicy()
        self._cues: deque[_WaitingCue] = deque(maxlen=_MOST_WAITING_CUES)
        self._cues_sound_until = float("-inf")
        self._speaking: _Sentence | None = None
        self._retry: _Sentence | None = None
        self._steps: list[Step] = []
        self._told: set[AudioNotice] = set()
        self._failures = Failures()
        self._number = 0
        self._last_hush = 0
        self._prefer_bundled_voice = False
        self._watch = Watch()
        self._has_sound = False
        self._player = ""
        self._languages: tuple[str, ...] | None = None
        self._next_ping: float | None = None

    @property
    def state(self) -> State:
        return self._state

    @property
    def player(self) -> str:
        """By what the worker sounds; empty while that is unknown, or where nothing does."""
        return self._player if self._has_sound else ""

    @property
    def languages(self) -> tuple[str, ...]:
        """Of the voices that were found; none while that is unknown."""
        return self._languages or ()

    @property
    def is_quiet(self) -> bool:
        """Whether nothing is being said nor waits to be said."""
        return self._state in _FOR_GOOD or (not self._speaking and not self._retry and not self._queue)

    @property
    def is_speaking(self) -> bool:
        """Whether the worker has a sentence to say."""
        return self._speaking is not None

    def warm_up(self) -> None:
        """Have a worker ready before there is something to be heard."""
        self._wanted = True

    def set_voice(self, voice: VoiceSettings) -> None:
        """For the sentences from now on."""
        self._voice = voice.clamped()

    def set_cue_volumes(self, volumes: Mapping[str, float]) -> None:
        """For the cues from now on."""
        self._cue_volumes = dict(volumes)

    def say(self, utterance: Utterance, now: float) -> None:
        if self._state in _FOR_GOOD or self._languages == ():
            return
        if self._queue.offer(utterance, now) is Offer.REFUSED:
            self._tell(NoticeCode.SPEECH_BACKLOG)
        self._wanted = True
        if self._speaking and cuts(utterance.urgency, self._speaking.utterance.urgency):
            self._cut_speech(now)

    def play(self, cue: Cue, now: float) -> None:
        if self._state in _FOR_GOOD or cue.name not in CUE_NAMES or not self._volume_of(cue):
            return
        wait = self._cue_policy.admit(cue.name, seconds_of(cue.name), now)
        if wait is not None:
            self._cues.append(_WaitingCue(cue, now + wait))
            self._cues_sound_until = max(self._cues_sound_until, now + wait + seconds_of(cue.name))
            self._wanted = True

    def hush_speech(self, now: float) -> None:
        """Nothing said until now is heard any more."""
        self._queue.clear()
        self._retry = None
        self._cut_speech(now)

    def hush_cues(self, now: float) -> None:
        self._cues.clear()
        self._cue_policy.clear()
        self._hush(False, True, now < self._cues_sound_until, now)
        self._cues_sound_until = float("-inf")

    def close(self) -> None:
        self._end_worker(State.CLOSED)

    def answered(self, answer: Answer, now: float) -> None:
        """The present worker said ``answer``."""
        match answer:
            case SoundReady(player=player):
                self._sound_came(player)
            case VoiceReady(languages=languages):
                self._voice_came(tuple(languages))
            case Started(number=number, seconds=seconds) if self._is_present(number):
                self._watch.came(Due.STARTED)
                self._watch.expect(Due.FINISHED, now + seconds + ANSWER_LIMIT)
            case Finished(number=number) if self._is_present(number):
                self._forget_sentence()
            case Refused(number=number) if self._speaking and self._is_present(number):
                self._tell_missing(base_language(self._speaking.utterance.language))
                self._forget_sentence()
            case Hushed(number=number) if number == self._last_hush:
                self._watch.came(Due.HUSHED)
            case Pong():
                self._pong_came(answer, now)
            case Started() | Finished() | Refused() | Hushed():
                pass  # about something that was hushed meanwhile
            case _:
                assert_never(answer)

    def ended(self, now: float) -> None:
        """The present worker ended by itself, or could not be started."""
        if self._state in _RUNNING:
            self._failed(now)

    def was_away(self, seconds: float) -> None:
        """Our own process stood still, so an answer may lie there unread."""
        self._watch.postpone(seconds)

    def advance(self, now: float) -> tuple[Step, ...]:
        """What is to be done now."""
        self._look_at_the_clock(now)
        if self._state is State.IDLE and self._wanted:
            self._start(now)
        if self._state in _RUNNING:
            self._send_cues(now)
            self._send_sentence(now)
            self._send_ping(now)
        steps, self._steps = tuple(self._steps), []
        return steps

    def next_date(self) -> float | None:
        """When ``advance`` has something to do at the latest, if nothing happens before."""
        dates = (self._watch.next_date(), self._next_ping)
        return min((date for date in dates if date is not None), default=None)

    def _look_at_the_clock(self, now: float) -> None:
        late = self._watch.overdue(now) if self._state in _RUNNING else None
        if late is Due.HUSHED:  # silence first; a busy machine is no failure
            self._end_worker(State.IDLE)
        elif late is not None:
            self._failed(now)

    def _start(self, now: float) -> None:
        self._become(State.STARTING)
        self._watch.expect(Due.START, now + START_LIMIT)
        self._steps.append(Start(self._prefer_bundled_voice))

    def _send_cues(self, now: float) -> None:
        while self._has_sound and self._cues:
            waiting = self._cues.popleft()
            cue, late = waiting.cue, now - waiting.due
            if late <= STALE_CUE or cue.name == NEVER_LEFT_OUT:
                volume = self._volume_of(cue)
                self._send(PlayCue(cue.name, cue.bearing, cue.steps, volume, max(0.0, -late)))

    def _send_sentence(self, now: float) -> None:
        while self._state is State.READY and self._speaking is None:
            sentence, self._retry = self._retry or self._next_sentence(), None
            if sentence is None:
                return
            words = for_the_ear(sentence.utterance.text, sentence.utterance.language, self._voice.punctuation)
            if words and self._can_read(sentence.utterance.language):
                self._send_words(sentence, words, now)

    def _send_words(self, sentence: _Sentence, words: str, now: float) -> None:
        self._speaking = sentence
        language, voice = base_language(sentence.utterance.language), self._voice
        self._send(Say(sentence.number, words, language, voice.words_per_minute, voice.pitch, voice.volume))
        self._watch.expect(Due.STARTED, now + ANSWER_LIMIT)

    def _next_sentence(self) -> _Sentence | None:
        utterance = self._queue.next()
        return None if utterance is None else _Sentence(self._new_number(), utterance, tries=1)

    def _send_ping(self, now: float) -> None:
        """With whatever is sent, and then as long as a sentence lasts."""
        is_time = self._next_ping is not None and now >= self._next_ping
        has_sent = any(isinstance(step, Send) for step in self._steps)
        if (is_time or has_sent) and not self._watch.expects(Due.PONG):
            self._next_ping = None
            self._watch.expect(Due.PONG, now + ANSWER_LIMIT)
            self._send(Ping(self._new_number()))

    def _pong_came(self, pong: Pong, now: float) -> None:
        self._watch.came(Due.PONG)
        self._watch.saw(pong.frames, pong.is_playing, now)
        if self._speaking or pong.is_playing:
            self._next_ping = now + PING_INTERVAL

    def _sound_came(self, player: str) -> None:
        if player:
            self._has_sound, self._player = True, player
            self._get_ready()
        else:
            self._tell(NoticeCode.NO_SOUND_DEVICE)
            self._end_worker(State.SILENT)

    def _voice_came(self, languages: tuple[str, ...]) -> None:
        self._languages = languages
        if not languages:
            self._tell(NoticeCode.NO_VOICE)
            self._queue.clear()
            self._retry = None
        self._get_ready()

    def _get_ready(self) -> None:
        if self._has_sound and self._languages is not None:
            self._watch.came(Due.START)
            self._become(State.READY)

    def _can_read(self, language: str) -> bool:
        base = base_language(language)
        if self._languages and base in self._languages:
            return True
        self._tell_missing(base)
        return False

    def _cut_speech(self, now: float) -> None:
        was_speaking = self._speaking is not None
        self._forget_sentence()
        self._hush(True, False, was_speaking, now)

    def _hush(self, speech: bool, cues: bool, is_audible: bool, now: float) -> None:
        if self._state not in _RUNNING or not is_audible:
            return
        self._last_hush = self._new_number()
        self._steps.append(Send(Hush(self._last_hush, speech, cues)))
        self._watch.expect(Due.HUSHED, now + HUSH_LIMIT)

    def _failed(self, now: float) -> None:
        self._prefer_bundled_voice = self._prefer_bundled_voice or self._languages is None
        self._save_sentence()
        if self._failures.add(now):
            self._tell(NoticeCode.AUDIO_GAVE_UP)
            self._end_worker(State.GIVEN_UP)
        else:
            self._end_worker(State.IDLE)

    def _save_sentence(self) -> None:
        """It is said again from its beginning: heard one and a half times is better than half."""
        if self._speaking and self._speaking.tries < MOST_TRIES:
            self._retry = _Sentence(self._new_number(), self._speaking.utterance, self._speaking.tries + 1)

    def _end_worker(self, state: State) -> None:
        if self._state in _RUNNING:
            self._steps.append(Kill())
        self._become(state)
        self._forget_worker()
        if state in _FOR_GOOD:
            self._queue.clear()
            self._cues.clear()
            self._retry = None

    def _forget_worker(self) -> None:
        self._watch = Watch()
        self._speaking = None
        self._has_sound = False
        self._languages = None
        self._next_ping = None

    def _forget_sentence(self) -> None:
        self._speaking = None
        self._watch.came(Due.STARTED, Due.FINISHED)

    def _become(self, state: State) -> None:
        if state in _NEXT[self._state]:
            self._state = state

    def _is_present(self, number: int) -> bool:
        return self._speaking is not None and self._speaking.number == number

    def _new_number(self) -> int:
        self._number += 1
        return self._number

    def _send(self, order: Order) -> None:
        self._steps.append(Send(order))

    def _volume_of(self, cue: Cue) -> float:
        return min(max(self._cue_volumes.get(cue.name, 1.0), 0.0), 1.0)

    def _tell(self, code: NoticeCode, language: str = "") -> None:
        notice = AudioNotice(code, language)
        if notice not in self._told:
            self._told.add(notice)
            self._steps.append(Tell(notice))

    def _tell_missing(self, language: str) -> None:
        if len(self._told) < 32:  # languages may come from anywhere
            self._tell(NoticeCode.VOICE_MISSING, language)
