"""From one front end to the other. Apart from the bootstrap, so that a front end starts without it."""

from __future__ import annotations

from devices.ports.hints import TYPE_CHECKING

if TYPE_CHECKING:
    from donnie_tui.bootstrap import Donnie


class GoToWorld(Exception):
    """Raised by a front end that is left for the same one in another world, which can be loaded."""

    def __init__(self, name: str) -> None:
        super().__init__("world")
        self.name = name


class SwitchMode(Exception):
    """Raised by a front end that the user leaves for the other one. What was made goes with it."""

    def __init__(self, text: str, name: str | None, donnie: Donnie | None = None) -> None:
        """``donnie`` is the session to go on with, its robot where it stands; its taker closes it."""
        super().__init__("switch")
        self.text = text
        self.name = name
        self.donnie = donnie
