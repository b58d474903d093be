"""From one front end to the other. Apart from the bootstrap, so that a front end starts without it."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from donnie_tui.bootstrap import Donnie


class SwitchMode(Exception):
    """Raised by a front end that the user leaves for the other one. What was made goes with it."""

    def __init__(self, text: str, name: str | None, donnie: Donnie | None = None) -> None:
        """``donnie`` is the session to go on with, its robot where it stands; its taker closes it."""
        super().__init__("switch")
        self.text = text
        self.name = name
        self.donnie = donnie
