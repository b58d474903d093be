"""What a conversation does with events: quick movements are summed up, and urgent news interrupts typing."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from donnie_tui.bootstrap import assemble
from donnie_tui.commands.preferences import Preferences
from donnie_tui.core.events import Announced
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
    with conversation(monkeypatch, tmp_path, terminals, speed) as talk:
        session = talk.ctx.donnie.session
        run = session.start("REPEAT 10 TIMES FW 1 END REPEAT", "steps.gd")
        assert run.wait(TIMEOUT)
        session.hub.wait_until_delivered(TIMEOUT)

        assert talk.streams.queue.take() == printed


@pytest.mark.parametrize(("code", "is_urgent"), [("link", True), ("moved", False)])
def test_only_what_is_said_about_the_connection_interrupts_a_line_that_is_typed(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, code: str, is_urgent: bool
) -> None:
    with conversation(monkeypatch, tmp_path, {0, 1}) as talk:
        hub = talk.ctx.donnie.session.hub
        assert not talk.console.has_news
        hub.publish(Announced(code, "Said."))
        hub.wait_until_delivered(TIMEOUT)

        assert talk.console.has_news is is_urgent


@contextmanager
def conversation(
    patched: pytest.MonkeyPatch, folder: Path, terminals: set[int], speed: float | None = None
) -> Iterator[Conversation]:
    """``terminals``: which of standard input and output are one."""
    patched.setenv("XDG_STATE_HOME", str(folder))
    patched.setattr(console_module, "Watchdog", _NoWatchdog)
    patched.setattr(console_module, "ReaderWatch", lambda: None)
    patched.setattr(os, "isatty", lambda number: number in terminals)
    settings = Settings(world="open_floor", speed=speed, language="en", speech="off", sound=False)
    donnie = assemble(settings, terminal=True)
    talk = Conversation(donnie, StoppedClock(), Preferences(settings, os.environ), Greeting())
    try:
        yield talk
    finally:
        talk.close()
        donnie.close()
