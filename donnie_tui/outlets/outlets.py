"""All outlets of a session in one value: what is heard, what is felt, what is written."""

from __future__ import annotations

from devices.ports.values import Frozen
from donnie_tui.core.belt_telling import BeltTelling
from donnie_tui.core.outlets import UntilSaid
from donnie_tui.outlets.audible import Audible
from donnie_tui.outlets.written import Written


class Outlets(Frozen):
    """They are made, and closed, by whoever makes the session."""

    audible: Audible
    """What makes a voice and sounds."""
    belt: BeltTelling
    """The belt in words."""
    written: Written
    until_said: UntilSaid
    """What programs wait at."""

    def adjust_sound(self, **changed: object) -> None:
        """Settings of voice and cues from now on, by the names of their fields."""
        self.audible.adjust(**changed)
        self.let_programs_wait()

    def let_programs_wait(self) -> None:
        """Until what they say was heard, where the learner wants that."""
        waits = self.audible.settings.wait_for_speech
        self.until_said.is_quiet_within = self.audible.is_quiet_within if waits else None
