"""What runs beside the conversation: robots that were STARTed, while lines are typed.

Rule: however much they tell, whoever types comes through: what waits to be printed is bounded, a key is
looked for between its blocks, and a stop leaves out all of it but the end.
"""

from __future__ import annotations

from collections.abc import Callable

from donnie_tui.bootstrap import Donnie
from donnie_tui.linear.output import LARGEST_BLOCK, Told
from language.control import ControlState

_ENDING = (ControlState.STOPPING, ControlState.ENDED)


class Beside:
    """The robots whose programs run though nobody waits for them."""

    def __init__(
        self, donnie: Donnie, told: Told, answer: Callable[..., None], stop_all: Callable[[], None]
    ) -> None:
        """``told`` waits to be printed, ``answer`` says a sentence by its code, ``stop_all`` is STOP ALL."""
        self._stop_all = stop_all
        self._left_out = 0
        """Lines that were not printed before the stop."""
        self._donnie = donnie
        self._told = told
        self._answer = answer
        self.is_watching = False
        """Whether a run is watched: what that tells and what is told of it stay in their order."""

    @property
    def is_any(self) -> bool:
        return bool(self._donnie.team.running)

    @property
    def goes_on(self) -> bool:
        """Whether one runs that was not told to stop."""
        runs = (session.run for session in self._donnie.team.running)
        return any(run is not None and run.control.state not in _ENDING for run in runs)

    @property
    def floods(self) -> bool:
        """Whether more was told than is printed at once, while there may be more any time."""
        return len(self._told) > LARGEST_BLOCK and self.is_any and not self.is_watching

    @property
    def waits_behind_answers(self) -> bool:
        """Whether what is answered to the last word is printed, and what waits was told beside."""
        return not self._told.has_first

    def stop(self, left_out: int = 0) -> None:
        """Stop all robots, and say so; ``left_out`` lines were not printed, besides those that wait now."""
        self._left_out = left_out
        self._stop_all()

    def leave_out(self) -> None:
        """After a stop: the end of what waits is printed, and how many lines were not."""
        self._told.let_pass()
        left_out = self._left_out + self._told.trim(LARGEST_BLOCK)
        self._left_out = 0
        if left_out:
            self._answer("answer-left-out", lines=left_out)
