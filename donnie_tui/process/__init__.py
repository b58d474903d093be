"""What happens to the process: signals, suspension, lost connections, garbage collection. No robots."""

from __future__ import annotations

import gc

HIGHEST_STANDARD = 2
"""Input, output and errors are 0, 1 and 2."""


WHILE_LOADING = 200_000
"""Objects until Python collects garbage: more than a start makes; collecting took a tenth of its time."""
AFTERWARDS = 20_000
"""Objects until the newer ones are collected: all that was loaded took twenty milliseconds each time."""


def load_undisturbed() -> None:
    """Collect no garbage while a start loads."""
    gc.set_threshold(WHILE_LOADING)


def loaded() -> None:
    """Collect rarely once a session is loaded. No effect without ``load_undisturbed`` before."""
    if gc.get_threshold()[0] == WHILE_LOADING:
        gc.freeze()
        gc.set_threshold(AFTERWARDS)
