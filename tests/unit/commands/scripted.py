"""A front end without a terminal: answers come from a list, and what is asked and printed is written down."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Coroutine, Iterable, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from donnie_tui.bootstrap import Donnie, open_workspace
from donnie_tui.commands.context import Context
from donnie_tui.commands.declarations import BY_NAME, When
from donnie_tui.commands.dispatch import perform, says_slip
from donnie_tui.commands.interaction import EnterWorld, Option, SwitchMode, drive
from donnie_tui.commands.lookup import find
from donnie_tui.commands.preferences import Preferences
from donnie_tui.core.events import Stamped
from donnie_tui.core.run_state import RunObserver, RunState
from donnie_tui.core.runner import RunRequest
from donnie_tui.core.session_log import AnswerLog, LineHistory
from donnie_tui.core.transcript import printed_lines
from donnie_tui.settings.folders import state_path
from tests.timeouts import TIMEOUT

if TYPE_CHECKING:
    from pathlib import Path

    from donnie_tui.core.runner import Run

T = TypeVar("T")


class Quit(Exception):
    """QUIT was typed."""


class ScriptedInteraction:
    """``Interaction`` for scripts and tests. A question without an answer in the list is given up."""

    can_edit = is_attended = True

    def __init__(self, answers: Iterable[str | None] = ()) -> None:
        self.answers = list(answers)
        self.asked: list[str] = []
        """Every question, with the texts of its options."""
        self.offered: Sequence[Option] = ()
        """The options of the last list."""
        self.tasks: list[tuple[str, bool, bool]] = []
        """Tasks in the background: the report of a slow one, whether it may be left, whether it is slow."""
        self.waited: list[float] = []
        self.changed: list[str] = []
        """The settings that changed."""
        self.activity = When.IDLE
        self.say: Callable[..., None] = lambda *_: None
        self.when_waiting: Callable[[], bool] = lambda: False
        """Whether the learner presses a key meanwhile."""
        self.until_over: Callable[[], None] | None = None
        """Waits for a run; by default the learner continues at once."""
        self.more: Callable[[], Coroutine[Any, Any, None]] | None = None
        self.when_robot_changed: Callable[[], None] = lambda: None

    def _answer(self) -> str | None:
        return self.answers.pop(0) if self.answers else None

    async def ask(
        self,
        question: str,
        text: str = "",
        accepts: Callable[[str], str | None] | None = None,
    ) -> str | None:
        self.asked.append(f"{question} {text}".strip())
        answer = self._answer()
        while answer is not None and accepts is not None and (problem := accepts(answer)) is not None:
            self.asked.append(problem)
            answer = self._answer()
        return answer

    async def ask_file(
        self, question: str, text: str, recent: Callable[[], Sequence[Path]], *, is_new: bool = False
    ) -> str | Path | None:
        del recent, is_new
        return await self.ask(question, text)

    async def choose(
        self, question: str, options: Sequence[Option], printed: Sequence[str] = ()
    ) -> str | None:
        self.asked += [question, *(each.text for each in options)]
        self.offered = options
        self.say(*printed)
        return self._answer()

    async def confirm(self, question: str) -> bool | None:
        self.asked.append(question)
        answer = self._answer()
        return None if answer is None else answer == "yes"

    async def edit_line(self, question: str, text: str = "") -> str | None:
        return await self.ask(question, text)

    async def show_pages(
        self, title: str, lines: Sequence[str], printed: Sequence[str] | None = None
    ) -> None:
        self.asked.append(title)
        self.say(*(lines if printed is None else printed))

    async def background(
        self, task: Callable[[], T], slow: str, *, may_be_left: bool = False, is_slow: bool = False
    ) -> T:
        self.tasks.append((slow, may_be_left, is_slow))
        return task()

    async def follow(self, runs: Sequence[tuple[str | None, Run]]) -> bool:
        del runs
        if self.until_over is not None:
            self.until_over()
        return self.until_over is not None

    async def finish(self, task: Coroutine[Any, Any, T]) -> T:
        return await task

    async def finished(self) -> None: ...

    async def wait(self, seconds: float) -> bool:
        self.waited.append(seconds)
        return self.when_waiting()

    def print_soon(self) -> None: ...

    def continue_on_enter(self, more: Callable[[], Coroutine[Any, Any, None]]) -> None:
        self.more = more

    def setting_changed(self, key: str) -> None:
        self.changed.append(key)

    def before_robot_changes(self) -> None: ...

    def robot_changed(self) -> None:
        self.when_robot_changed()

    async def type_again(self, line: str) -> None:
        self.asked.append(f"> {line}")

    async def enter_world(self, name: str) -> None:
        raise EnterWorld(name)

    async def switch_mode(self) -> None:
        raise SwitchMode("", None)

    async def quit(self) -> None:
        raise Quit


class Script(RunObserver):
    """Types commands as a learner, one after the other."""

    def __init__(self, donnie: Donnie, answers: Iterable[str | None] = ()) -> None:
        self.donnie = donnie
        self.interaction = ScriptedInteraction(answers)
        workspace = open_workspace(state_path(os.environ))
        preferences = Preferences(donnie.outlets.audible.settings, os.environ)
        self.ctx = Context(donnie, self.interaction, workspace, AnswerLog(), LineHistory(), preferences)
        self.interaction.say = self.ctx.say
        self.printed: list[str] = []
        """All lines so far."""
        self._changed = threading.Condition()
        self.ctx.runs.observer = self
        self._unsubscribe = donnie.team.stream.subscribe(self._on_event)

    def close(self) -> None:
        self._unsubscribe()
        self.ctx.close()

    def _on_event(self, stamped: Stamped) -> None:
        self.printed += printed_lines(stamped, self.donnie.words)

    def on_change(self) -> None:
        with self._changed:
            self._changed.notify_all()

    def type(self, line: str) -> bool:
        """Type a line. False if it is GoDonnie."""
        found = find(line)
        if found is not None:
            drive(perform(self.ctx, *found))
        is_command = found is not None or says_slip(self.ctx, line)
        self.donnie.session.hub.wait_until_delivered(TIMEOUT)
        return is_command

    def press(self, name: str) -> None:
        """Press the key of a command."""
        drive(perform(self.ctx, BY_NAME[name], None))

    def run(self, text: str) -> None:
        """Run GoDonnie where the robot stands."""
        self.ctx.runs.start(RunRequest(text, is_whole=False))

    def rest(self) -> None:
        """Wait until the program that was started is held or over."""
        runs, robot, run = self.ctx.runs, self.donnie.session.hub.robot, self.donnie.session.run
        with self._changed:
            assert self._changed.wait_for(lambda: runs.is_held or runs.has_ended(robot), TIMEOUT)
        if runs.has_ended(robot):
            assert run is None or run.wait(TIMEOUT)
            runs.sum_up(robot)
        self.donnie.session.hub.wait_until_delivered(TIMEOUT)

    def answers_to(self, *lines: str) -> list[str]:
        """What is printed while lines are typed. GoDonnie runs at once, and each line waits for a program."""
        before = len(self.printed)
        for line in lines:
            if not self.type(line):
                self.run(line)
            if self.ctx.runs.state is not RunState.READY:
                self.rest()
        return self.printed[before:]
