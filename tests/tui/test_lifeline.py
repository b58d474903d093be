"""The thread that watches the output, without a screen."""

import threading
from queue import Queue
from types import SimpleNamespace

from donnie_tui.tui import lifeline
from donnie_tui.tui.lifeline import Lifeline


def test_output_that_stays_stuck_is_told_again_and_again(monkeypatch):
    """A key may have started a robot since it was told first."""
    monkeypatch.setattr(lifeline, "LOOK", 0.001)
    told, twice = list[None](), threading.Event()
    waiting: Queue[str] = Queue()
    waiting.put("what the terminal does not take")

    def on_stuck() -> None:
        told.append(None)
        if len(told) == 2:
            twice.set()

    line = Lifeline(
        halt=lambda: None,
        before_rest=lambda: None,
        tell=lambda number: None,
        on_stuck=on_stuck,
        part=lambda number: None,
        writer=lambda: SimpleNamespace(_queue=waiting, is_alive=lambda: True),
    )
    line.begin()
    try:
        assert twice.wait(30)
    finally:
        line.end()
