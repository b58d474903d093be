"""The linear mode in this process. Each line typed at its prompt has an ``Outcome``.

The only module of the net that knows how the linear mode is put together.
"""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from donnie_tui.bootstrap import Donnie, assemble
from donnie_tui.commands.interaction import EnterWorld, SwitchMode
from donnie_tui.commands.preferences import Preferences
from donnie_tui.linear import console as console_module
from donnie_tui.linear.console import Console
from donnie_tui.linear.conversation import Conversation
from donnie_tui.linear.greeting import Greeting
from donnie_tui.linear.prompter import Prompter
from donnie_tui.linear.reader import Typed
from donnie_tui.process.signals import Deputy
from donnie_tui.settings.settings import Settings
from tests.parity.outcome import Outcome, Recorder
from tests.timeouts import TIMEOUT

ESCAPE = "\x1b"
_LONG = 0.2
"""Seconds: a longer wait for a key is a wait for the learner, and not for the rest of an answer."""


class _NoWatchdog:
    """Takes no signals, which belong to the process and its main thread."""

    def __init__(self, *_: object, **__: object) -> None:
        self.deputy = Deputy()

    def begin(self) -> None: ...

    def take(self) -> None: ...

    def end(self) -> None:
        self.deputy.close()


class _NoTerminal:
    """A terminal that edits lines key by key, and has no attributes to take."""

    def take(self, *, signals: bool = True) -> None: ...

    def give_back(self) -> None: ...


class ScriptedConsole(Console):
    """A keyboard and a printer for a test. ``waits`` says whether the conversation waits for a key."""

    def __init__(self) -> None:
        super().__init__(_NoTerminal())  # type: ignore[arg-type] # as much of one as is used
        self._keys = b""
        self._nudged = False
        self._changed = threading.Condition()
        self.waits = False
        self.printed = ""

    # --- for the test

    def type(self, text: str) -> None:
        with self._changed:
            self.waits = False
            self._keys += text.encode()
            self._changed.notify_all()

    # --- for the conversation

    def nudge(self) -> None:
        with self._changed:
            self.waits = False
            self._nudged = True
            self._changed.notify_all()

    def wait(self, seconds: float | None = None, *, reading: bool = False) -> bool:
        if self.when_idle is not None or (reading and self.once_idle):
            self._work_while_idle(reading)
        with self._changed:
            is_long = reading and (seconds is None or seconds > _LONG)
            self.waits = is_long and not self._nudged and not self._keys
            self._changed.notify_all()
            self._changed.wait_for(lambda: self._nudged or (reading and self._keys), seconds)
            self.waits = False
            self._nudged = False
            return reading and bool(self._keys)

    def has_input(self) -> bool:
        return bool(self._keys)

    def read(self) -> bytes:
        with self._changed:
            keys, self._keys = self._keys, b""
        return keys

    def write(self, text: str) -> None:
        self.printed += text

    def columns(self) -> int:
        return 80

    def rows(self) -> int:
        return 24

    def close(self) -> None: ...


class LinearMode:
    """A conversation in a thread of its own."""

    def __init__(self, donnie: Donnie, talk: Conversation, console: ScriptedConsole) -> None:
        self._donnie, self._console = donnie, console
        self._recorder = Recorder(donnie)
        self._questions: list[str] = []
        self.reads_answer = False
        """Whether the next line is the answer to something that was said."""
        self.left_for = ""
        self._trouble: BaseException | None = None
        self._talk = talk
        self._thread = threading.Thread(target=self._converse, name="conversation", daemon=True)

    def begin(self, text: str) -> None:
        self._text = text
        self._thread.start()
        self._wait_until_idle()
        self._recorder.take()

    def _converse(self) -> None:
        try:
            self._talk.begin(None, self._text)
            self.left_for = "end"
        except EnterWorld as going:
            self.left_for = f"world {going.name}"
        except SwitchMode:
            self.left_for = "other mode"
        except BaseException as trouble:  # noqa: BLE001 -- raised again in the test's thread
            self._trouble = trouble
        finally:
            self._console.nudge()

    def asked(self, question: str) -> None:
        """Called by the thread of the conversation when it asks and waits for the answer."""
        self._questions.append(question)

    def prepare(self, *lines: str) -> None:
        """Type lines of which nothing is compared."""
        for line in lines:
            self._enter(line)
        self._recorder.take()

    def type(self, line: str) -> Outcome:
        """Type a line; where it leads to a question, leave that without an answer."""
        before = len(self._questions)
        self._enter(line)
        published = self._recorder.take()
        asked = "".join(self._questions[before : before + 1])
        if not asked and self.reads_answer and published:
            asked = published[-1]
        after: tuple[str, ...] = ()
        if asked and not self.left_for:
            self._console.type(ESCAPE)
            self._wait_until_idle()
            after = self._recorder.take()
            published = tuple(each for each in published if each != asked)
        return Outcome(published, asked, (), after, self.left_for)

    def _enter(self, line: str) -> None:
        self._console.type(f"{line}\r")
        self._wait_until_idle()

    def _wait_until_idle(self) -> None:
        """Return once the conversation waits for a key and no program is about to hold or to end."""
        end = time.monotonic() + TIMEOUT
        while time.monotonic() < end:
            if self._trouble is not None:
                raise self._trouble
            if self.left_for or not self._thread.is_alive():
                return
            if self._console.waits and self._recorder.is_at_rest(self._talk.ctx.runs) and self._console.waits:
                return
            time.sleep(0.001)
        raise AssertionError(f"the conversation never came to rest: {self._console.printed[-500:]}")

    def close(self) -> None:
        self._console.leaving = 15
        self._donnie.team.stop()
        self._console.nudge()
        self._thread.join(TIMEOUT)
        self._recorder.close()
        self._talk.close()
        self._donnie.close()


@contextmanager
def linear_mode(settings: Settings, text: str, patched: pytest.MonkeyPatch) -> Iterator[LinearMode]:
    """A conversation about the program ``text``, which has not run yet."""
    patched.setattr(console_module, "Watchdog", _NoWatchdog)
    patched.setattr(console_module, "ReaderWatch", lambda: None)
    patched.setattr(os, "isatty", lambda _: True)
    donnie = assemble(settings, terminal=True)
    console, greeting = ScriptedConsole(), Greeting()
    greeting.was_printed, greeting.terminal = True, _NoTerminal()  # type: ignore[assignment] # as above
    talk = Conversation(donnie, console, Preferences(settings, os.environ), greeting)
    mode = LinearMode(donnie, talk, console)
    _report_questions(patched, mode)
    try:
        mode.begin(text)
        yield mode
    finally:
        mode.close()


def _report_questions(patched: pytest.MonkeyPatch, mode: LinearMode) -> None:
    """Report each question as it is asked, and each other line that is no part of the program."""
    ask_before, read_before = Prompter.ask, Prompter.read_next

    def ask(self: Prompter, question: str) -> str | None:
        mode.asked(question)
        return ask_before(self, question)

    def read_next(self: Prompter) -> Typed:
        mode.reads_answer = True
        try:
            return read_before(self)
        finally:
            mode.reads_answer = False

    patched.setattr(Prompter, "ask", ask)
    patched.setattr(Prompter, "read_next", read_next)
