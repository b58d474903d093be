"""Decides what the audio worker does next; starts, sends and kills nothing itself.

Sans-IO: what happens comes in by the methods, each with its time; ``advance`` gives back the steps to be
taken, in order, and ``next_date`` when to come back at the latest. What waits to be heard is kept by
``Sentences`` and ``WaitingCues``, what is known of the worker by ``PresentWorker``; the conductor brings
them together. ``lifetime`` draws what follows on what.

Not thread-safe: its owner holds a lock.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import assert_never

from devices.audio_worker.lifetime import State
from devices.audio_worker.messages import (
    Answer,
    Finished,
    Hush,
    Hushed,
    Order,
    Ping,
    Pong,
    Refused,
    Say,
    SoundReady,
    Started,
    VoiceReady,
)
from devices.audio_worker.notices import AudioNotice, NoticeCode
from devices.audio_worker.present_worker import PresentWorker
from devices.audio_worker.sentences import Sentence, Sentences
from devices.audio_worker.steps import Kill, Send, Start, Step, Tell
from devices.audio_worker.waiting_cues import WaitingCues
from devices.audio_worker.watch import ANSWER_LIMIT, HUSH_LIMIT, START_LIMIT, Due, Failures
from devices.ports.audio import Cue, Utterance
from devices.speech.ear import for_the_ear
from devices.speech.policy import Offer
from devices.speech.voices import VoiceSettings, base_language

_MOST_NOTICES = 32
"""Languages that are missing may come from anywhere."""


class Conductor:
    """What is to be heard, and the worker that makes it heard."""

    def __init__(self, voice: VoiceSettings, cue_volumes: Mapping[str, float]) -> None:
        """``cue_volumes``: 0 to 1 by the name of a cue, 1 where none is given; 0 leaves it out."""
        self._voice = voice.clamped()
        self._state = State.IDLE
        self._wanted = False
        self._sentences = Sentences(self._new_number)
        self._cues = WaitingCues(cue_volumes)
        self._worker = PresentWorker()
        self._steps: list[Step] = []
        self._told: set[AudioNotice] = set()
        self._failures = Failures()
        self._number = 0
        self._last_hush = 0
        self._prefer_bundled_voice = False

    @property
    def state(self) -> State:
        return self._state

    @property
    def player(self) -> str:
        """By what the worker sounds; empty while that is unknown, or where nothing does."""
        return self._worker.player

    @property
    def languages(self) -> tuple[str, ...]:
        """Of the voices that were found; none while that is unknown."""
        return self._worker.languages or ()

    @property
    def is_quiet(self) -> bool:
        """Whether nothing is being said nor waits to be said."""
        return self._state.is_for_good or not self._sentences

    @property
    def is_speaking(self) -> bool:
        """Whether the worker has a sentence to say."""
        return self._sentences.present is not None

    def is_still(self, now: float) -> bool:
        """Whether nothing is being said nor sounds, nor waits to."""
        return self.is_quiet and self._cues.are_over(now)

    def warm_up(self) -> None:
        """Have a worker ready before there is something to be heard."""
        self._wanted = True

    def set_voice(self, voice: VoiceSettings) -> None:
        """For the sentences from now on."""
        self._voice = voice.clamped()

    def set_cue_volumes(self, volumes: Mapping[str, float]) -> None:
        """For the cues from now on."""
        self._cues.set_volumes(volumes)

    def say(self, utterance: Utterance, now: float) -> None:
        if self._state.is_for_good or self._worker.has_no_voice:
            return
        if self._sentences.offer(utterance, now) is Offer.REFUSED:
            self._tell(NoticeCode.SPEECH_BACKLOG)
        self._wanted = True
        if self._sentences.are_cut_by(utterance):
            self._cut_speech(now)

    def play(self, cue: Cue, now: float) -> None:
        if not self._state.is_for_good and self._cues.offer(cue, now):
            self._wanted = True

    def hush_speech(self, now: float) -> None:
        """Nothing said until now is heard any more."""
        self._sentences.clear()
        self._cut_speech(now)

    def hush_cues(self, now: float) -> None:
        is_audible = self._cues.hush(now)
        self._hush(False, True, is_audible, now)

    def close(self) -> None:
        self._end_worker(State.CLOSED)

    def answered(self, answer: Answer, now: float) -> None:
        """The present worker said ``answer``."""
        watch, sentences = self._worker.watch, self._sentences
        match answer:
            case SoundReady(player=player):
                self._sound_came(player)
            case VoiceReady(languages=languages):
                self._voice_came(tuple(languages))
            case Started(number=number, seconds=seconds) if sentences.is_present(number):
                watch.came(Due.STARTED)
                watch.expect(Due.FINISHED, now + seconds + ANSWER_LIMIT)
            case Finished(number=number) if sentences.is_present(number):
                self._forget_sentence()
            case Refused(number=number) if sentences.present and sentences.is_present(number):
                self._tell_missing(base_language(sentences.present.utterance.language))
                self._forget_sentence()
            case Hushed(number=number) if number == self._last_hush:
                watch.came(Due.HUSHED)
            case Pong():
                self._worker.pong_came(answer, self.is_speaking, now)
            case Started() | Finished() | Refused() | Hushed():
                pass  # about something that was hushed meanwhile
            case _:
                assert_never(answer)

    def ended(self, now: float) -> None:
        """The present worker ended by itself, or could not be started."""
        if self._state.is_running:
            self._failed(now)

    def was_away(self, seconds: float) -> None:
        """Our own process stood still, so an answer may lie there unread."""
        self._worker.watch.postpone(seconds)

    def advance(self, now: float) -> tuple[Step, ...]:
        """What is to be done now."""
        self._look_at_the_clock(now)
        if self._state is State.IDLE and self._wanted:
            self._start(now)
        if self._state.is_running:
            self._send_cues(now)
            self._send_sentence(now)
            self._send_ping(now)
        steps, self._steps = tuple(self._steps), []
        return steps

    def next_date(self) -> float | None:
        """When ``advance`` has something to do at the latest, if nothing happens before."""
        return self._worker.next_date()

    def _look_at_the_clock(self, now: float) -> None:
        late = self._worker.watch.overdue(now) if self._state.is_running else None
        if late is Due.HUSHED:  # silence first; a busy machine is no failure
            self._end_worker(State.IDLE)
        elif late is not None:
            self._failed(now)

    def _start(self, now: float) -> None:
        self._become(State.STARTING)
        self._worker.watch.expect(Due.START, now + START_LIMIT)
        self._steps.append(Start(self._prefer_bundled_voice))

    def _send_cues(self, now: float) -> None:
        if self._worker.has_sound:
            for order in self._cues.take(now):
                self._send(order)

    def _send_sentence(self, now: float) -> None:
        while self._state is State.READY and not self.is_speaking:
            sentence = self._sentences.take()
            if sentence is None:
                return
            words = for_the_ear(sentence.utterance.text, sentence.utterance.language, self._voice.punctuation)
            if words and self._can_read(sentence.utterance.language):
                self._send_words(sentence, words, now)

    def _send_words(self, sentence: Sentence, words: str, now: float) -> None:
        self._sentences.begin(sentence)
        language, voice = base_language(sentence.utterance.language), self._voice
        self._send(Say(sentence.number, words, language, voice.words_per_minute, voice.pitch, voice.volume))
        self._worker.watch.expect(Due.STARTED, now + ANSWER_LIMIT)

    def _send_ping(self, now: float) -> None:
        has_sent = any(isinstance(step, Send) for step in self._steps)
        if self._worker.must_ping(has_sent, now):
            self._send(Ping(self._new_number()))

    def _sound_came(self, player: str) -> None:
        if player:
            self._worker.player = player
            self._get_ready()
        else:
            self._tell(NoticeCode.NO_SOUND_DEVICE)
            self._end_worker(State.SILENT)

    def _voice_came(self, languages: tuple[str, ...]) -> None:
        self._worker.languages = languages
        if not languages:
            self._tell(NoticeCode.NO_VOICE)
            self._sentences.clear()
        self._get_ready()

    def _get_ready(self) -> None:
        if self._worker.is_ready:
            self._worker.watch.came(Due.START)
            self._become(State.READY)

    def _can_read(self, language: str) -> bool:
        base = base_language(language)
        can_read = self._worker.can_read(base)
        if not can_read:
            self._tell_missing(base)
        return can_read

    def _cut_speech(self, now: float) -> None:
        was_speaking = self.is_speaking
        self._forget_sentence()
        self._hush(True, False, was_speaking, now)

    def _hush(self, speech: bool, cues: bool, is_audible: bool, now: float) -> None:
        if not self._state.is_running or not is_audible:
            return
        self._last_hush = self._new_number()
        self._send(Hush(self._last_hush, speech, cues))
        self._worker.watch.expect(Due.HUSHED, now + HUSH_LIMIT)

    def _failed(self, now: float) -> None:
        self._prefer_bundled_voice = self._prefer_bundled_voice or self._worker.languages is None
        self._sentences.save()
        if self._failures.add(now):
            self._tell(NoticeCode.AUDIO_GAVE_UP)
            self._end_worker(State.GIVEN_UP)
        else:
            self._end_worker(State.IDLE)

    def _end_worker(self, state: State) -> None:
        if self._state.is_running:
            self._steps.append(Kill())
        self._become(state)
        self._worker = PresentWorker()
        self._sentences.end()
        if state.is_for_good:
            self._sentences.clear()
            self._cues.clear()

    def _forget_sentence(self) -> None:
        self._sentences.end()
        self._worker.watch.came(Due.STARTED, Due.FINISHED)

    def _become(self, state: State) -> None:
        if self._state.may_become(state):
            self._state = state

    def _new_number(self) -> int:
        self._number += 1
        return self._number

    def _send(self, order: Order) -> None:
        self._steps.append(Send(order))

    def _tell(self, code: NoticeCode, language: str = "") -> None:
        notice = AudioNotice(code, language)
        if notice not in self._told:
            self._told.add(notice)
            self._steps.append(Tell(notice))

    def _tell_missing(self, language: str) -> None:
        if len(self._told) < _MOST_NOTICES:
            self._tell(NoticeCode.VOICE_MISSING, language)
