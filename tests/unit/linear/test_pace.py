"""Quick movements are summed up where a learner types and reads, and nowhere else."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from donnie_tui.bootstrap import assemble
from donnie_tui.commands.preferences import Preferences
from donnie_tui.linear import console as console_module
from donnie_tui.linear.conversation import Conversation
from donnie_tui.linear.greeting import Greeting
from donnie_tui.settings.settings import Settings
from tests.parity.linear_mode import ScriptedConsole, _NoWatchdog
from tests.timeouts import TIMEOUT


class StoppedClock(ScriptedConsole):
    """All movements come in one moment."""

    def now(self) -> float:
        return 0.0


@pytest.mark.parametrize(
    ("terminals", "speed", "printed"),
    [
        ({0, 1}, 1000.0, [*["I walked 1 step forward."] * 4, "6 more steps."]),
        ({0, 1}, None, ["I walked 1 step forward."] * 10),
        ({0}, 1000.0, ["I walked 1 step forward."] * 10),
        ({1}, 1000.0, ["I walked 1 step forward."] * 10),
        (set[int](), 1000.0, ["I walked 1 step forward."] * 10),
    ],
)
def test_quick_movements_are_summed_up_where_a_learner_types_and_reads(
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    terminals: set[int],
    speed: float | None,
    printed: list[str],
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    monkeypatch.setattr(console_module, "Watchdog", _NoWatchdog)
    monkeypatch.setattr(console_module, "ReaderWatch", lambda: None)
    monkeypatch.setattr(os, "isatty", lambda number: number in terminals)
    settings = Settings(world="open_floor", speed=speed, language="en", speech="off", sound=False)
    donnie = assemble(settings, terminal=True)
    talk = Conversation(donnie, StoppedClock(), Preferences(settings, os.environ), Greeting())
    try:
        run = donnie.session.start("REPEAT 10 TIMES FW 1 END REPEAT", "steps.gd")
        assert run.wait(TIMEOUT)
        donnie.session.hub.wait_until_delivered(TIMEOUT)
        lines = talk.streams.queue.take()
    finally:
        talk.close()
        donnie.close()

    assert lines == printed
