"""What makes events audible: the voice and the cues, each a listener.

SOUND OFF silences voice and cues and never the printed line; the belt has its own switch. ``UntilSaid`` lets
a program wait until what it says was heard, where the learner wants that; a stop ends the wait.
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
from donnie_tui.core.transcript import Telling, TellingAll, told_lines
from donnie_tui.core.wording import Wording

_URGENCY_OF = {"waiting": Urgency.PROGRESS, "hint": Urgency.HINT, "link": Urgency.ALERT}


class Hears(Enum):
    """What of the transcript a voice says."""

    ALL = "all"
    ANSWERS = "answers"
    """Everything but the words of SPEAK, which are heard elsewhere."""
    PROGRAM = "program"
    """The words of SPEAK alone."""


class Voice:
    """Says what the transcript prints."""

    def __init__(
        self,
        speaker: Speaker,
        wording: Wording,
        hears: Hears = Hears.ALL,
        *,
        is_on: bool = True,
        telling: Callable[[], Telling] = TellingAll,
    ) -> None:
        """``telling`` is asked at each event for what is printed of it."""
        self._speaker = speaker
        self._telling = telling
        self._wording = wording
        self._hears = hears
        self._on = is_on

    def __call__(self, stamped: Stamped) -> None:
        if isinstance(stamped.event, SoundSwitched):
            self._switch(stamped.event.on)
        elif self._on:
            self._tell(stamped)

    def _tell(self, stamped: Stamped) -> None:
        """What is printed, as far as it is ours."""
        telling = self._telling()
        if self._hears is not Hears.PROGRAM:
            for line in telling.before(stamped):
                self._speaker.say(Utterance(line, Urgency.ANSWER, self._wording.language))
        if self._is_ours(stamped.event) and telling.passes(stamped):
            self._say(stamped)

    def _is_ours(self, event: Event) -> bool:
        if isinstance(event, Answered) and event.in_print_only:
            return False
        return self._hears is Hears.ALL or isinstance(event, Spoke) == (self._hears is Hears.PROGRAM)

    def _switch(self, on: bool) -> None:
        self._on = on
        if not on:
            self._speaker.silence()

    def _say(self, stamped: Stamped) -> None:
        for line in told_lines(stamped, self._wording):
            self._speaker.say(Utterance(line, _urgency_of(stamped.event), self._wording.language))


class Cues:
    """Plays what the announcer or a front end chose."""

    def __init__(self, player: CuePlayer, *, is_on: bool = True) -> None:
        self._player = player
        self._on = is_on

    def __call__(self, stamped: Stamped) -> None:
        match stamped.event:
            case SoundSwitched(on=on):
                self._on = on
                if not on:
                    self._player.silence()
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
"""Seconds between two looks whether to go on."""

LONGEST = 30.0
"""Seconds for one SPEAK; a voice that takes longer, or hangs, holds nobody."""


class UntilSaid:
    """Waits for nothing until it is given a voice."""

    def __init__(self) -> None:
        self.is_quiet_within: Callable[[float], bool] | None = None
        """Waits that many seconds at most until everything was said; False if that was not enough."""
        self.waiting = 0
        """Programs that wait just now."""

    def wait(self, goes_on: Callable[[], bool]) -> None:
        """Return once everything was said, or ``goes_on`` says no."""
        if self.is_quiet_within is None:
            return
        self.waiting += 1
        try:
            self._wait(self.is_quiet_within, goes_on)
        finally:
            self.waiting -= 1

    def _wait(self, is_quiet_within: Callable[[float], bool], goes_on: Callable[[], bool]) -> None:
        for _ in range(round(LONGEST / SLICE)):
            if is_quiet_within(SLICE) or not goes_on():
                return
