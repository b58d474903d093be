"""When Python collects garbage.

Not while a start loads, which makes next to none: collecting took a tenth of the time. Afterwards rarely, and
only among newer objects: each collection of everything that was loaded took twenty milliseconds.
"""

from __future__ import annotations

import gc

WHILE_LOADING = 200_000
"""More objects than a start makes."""
AFTERWARDS = 20_000
"""Objects from one look to the next."""


def load_undisturbed() -> None:
    """The process begins."""
    gc.set_threshold(WHILE_LOADING)


def loaded() -> None:
    """What a session needs is there. No effect in a process that did not begin with ``load_undisturbed``."""
    if gc.get_threshold()[0] == WHILE_LOADING:
        gc.freeze()
        gc.set_threshold(AFTERWARDS)
