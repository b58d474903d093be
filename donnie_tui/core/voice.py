"""The listeners that make events audible: the voice and the cues.

SOUND OFF silences voice and cues and never the printed line; the belt has its own switch. ``SpeechWait``
makes a program wait until the voice has finished, if the learner wants that; a stop ends the wait.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum

from devices.ports.audio import Cue, CuePlayer, Speaker, Urgency, Utterance
from donnie_tui.core.events import (
    Announced,
    Answered,
    Chimed,
    CueSounded,
    Error,
    Event,
    SoundSwitched,
    Spoke,
    Stamped,
)
from donnie_tui.core.transcript import TranscriptFilter, UnfilteredTranscript, printed_lines
from donnie_tui.core.wording import Wording

_URGENCY_OF = {"waiting": Urgency.PROGRESS, "hint": Urgency.HINT, "link": Urgency.ALERT}


class VoiceScope(Enum):
    """The part of the transcript that a voice speaks."""

    ALL = "all"
    ANSWERS = "answers"
    """Everything but the words of SPEAK, which another voice speaks."""
    PROGRAM = "program"
    """The words of SPEAK alone."""


class Voice:
    """Speaks what the transcript prints."""

    def __init__(
        self,
        speaker: Speaker,
        wording: Wording,
        scope: VoiceScope = VoiceScope.ALL,
        *,
        is_on: bool = True,
        transcript_filter: Callable[[], TranscriptFilter] = UnfilteredTranscript,
    ) -> None:
        """``transcript_filter`` returns the filter that decides what is printed."""
        self._speaker = speaker
        self._transcript_filter = transcript_filter
        self._wording = wording
        self._scope = scope
        self._on = is_on

    def __call__(self, stamped: Stamped) -> None:
        if isinstance(stamped.event, SoundSwitched):
            self._switch(stamped.event.on)
        elif self._on:
            self._speak_event(stamped)

    def _speak_event(self, stamped: Stamped) -> None:
        """Speaks the printed lines of an event that belong to this voice."""
        transcript_filter = self._transcript_filter()
        if self._scope is not VoiceScope.PROGRAM:
            for line in transcript_filter.before(stamped):
                self._speaker.say(Utterance(line, Urgency.ANSWER, self._wording.language))
        if self._is_in_scope(stamped.event) and transcript_filter.passes(stamped):
            self._say(stamped)

    def _is_in_scope(self, event: Event) -> bool:
        if isinstance(event, Answered) and event.in_print_only:
            return False
        return self._scope is VoiceScope.ALL or isinstance(event, Spoke) == (
            self._scope is VoiceScope.PROGRAM
        )

    def _switch(self, on: bool) -> None:
        self._on = on
        if not on:
            self._speaker.silence_speech()

    def _say(self, stamped: Stamped) -> None:
        for line in printed_lines(stamped, self._wording):
            self._speaker.say(Utterance(line, _urgency_of(stamped.event), self._wording.language))


class Cues:
    """Plays the cues of the announcer and the front ends."""

    def __init__(self, player: CuePlayer, *, is_on: bool = True) -> None:
        self._player = player
        self._on = is_on

    def __call__(self, stamped: Stamped) -> None:
        match stamped.event:
            case SoundSwitched(on=on):
                self._on = on
                if not on:
                    self._player.silence_cues()
            case CueSounded() | Chimed() as cue if self._on:
                self._player.play(Cue(cue.name, cue.bearing, cue.steps))
            case _:
                pass


def _urgency_of(event: Event) -> Urgency:
    match event:
        case Spoke():
            return Urgency.PROGRAM
        case Error():
            return Urgency.ALERT
        case Announced(code=code):
            return _URGENCY_OF.get(code, Urgency.ANSWER)
        case Answered():
            return Urgency.ANSWER
        case _:
            return Urgency.PROGRESS


SLICE = 0.05
"""Seconds between two checks for a stop."""

LONGEST = 30.0
"""Seconds for one SPEAK, so that a slow or hanging voice blocks no program."""


class SpeechWait:
    """Lets a program wait for its voice; without a voice it does not wait."""

    def __init__(self) -> None:
        self.is_quiet_within: Callable[[float], bool] | None = None
        """Waits up to that many seconds until everything was said; False if that was too short."""
        self.waiting = 0
        """Programs that wait just now."""

    def wait(self, may_continue: Callable[[], bool]) -> None:
        """Returns once everything was said, or ``may_continue`` returns False."""
        if self.is_quiet_within is None:
            return
        self.waiting += 1
        try:
            self._wait(self.is_quiet_within, may_continue)
        finally:
            self.waiting -= 1

    def _wait(self, is_quiet_within: Callable[[float], bool], may_continue: Callable[[], bool]) -> None:
        for _ in range(round(LONGEST / SLICE)):
            if is_quiet_within(SLICE) or not may_continue():
                return
