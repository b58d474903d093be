"""Donnie with a fault put in on purpose: ``python -m tests.sessions.hanging PLACE FAULT ARGUMENTS``.

Its main thread hangs at the place, once there is a file ``hang``; then there is a file ``hanging``.
"""

from __future__ import annotations

import ctypes
import sys
import time
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

HANG, HANGING = "hang", "hanging"

PLACES = {
    "linear": ("donnie_tui.linear.console", "Console", "wait"),
    "visual": ("donnie_tui.tui.shutdown", "Shutdown", "leave"),
    "close": ("donnie_tui.tui.startup", "SessionHandle", "close"),
    "run": ("donnie_tui.cli.run", "", "_await_end"),
    "calibrate": ("donnie_tui.cli.calibrate", "_Steady", "sleep"),
    "replay": ("donnie_tui.core.timeline", "Replay", "forwards"),
    "serve": ("donnie_tui.cli.page_server", "Gate", "objection"),
    "check": ("donnie_tui.cli.replay", "", "recheck"),
}


def loop() -> None:
    """Handlers of signals run, and nothing comes of it."""
    while True:
        time.sleep(0.001)


def call() -> None:
    """No handler runs, for no signal interrupts the wait for a mutex that the thread itself has."""
    lock, mutex = ctypes.CDLL(None).pthread_mutex_lock, ctypes.create_string_buffer(128)
    lock(mutex)
    lock(mutex)


FAULTS: dict[str, Callable[[], None]] = {"loop": loop, "call": call}


def put_in(place: str, fault: str) -> None:
    module, owner, name = PLACES[place]
    holder: Any = import_module(module)
    holder = getattr(holder, owner) if owner else holder
    sound = getattr(holder, name)

    def faulty(*arguments: Any, **named: Any) -> Any:
        if Path(HANG).exists():
            Path(HANGING).touch()
            FAULTS[fault]()
        return sound(*arguments, **named)

    setattr(holder, name, faulty)


if __name__ == "__main__":
    put_in(sys.argv[1], sys.argv[2])
    del sys.argv[1:3]
    from donnie_tui.__main__ import main

    sys.exit(main())
