"""A conversation in the linear mode: lines are read, run and answered, from the first prompt to the goodbye.

Nothing that is printed is ever changed, and no typed program is lost, whatever ends the conversation.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Coroutine, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, TypeVar

from msgspec import Struct
from msgspec.structs import replace

from donnie_tui.bootstrap import Donnie, open_workspace
from donnie_tui.commands.context import FAILED, Context
from donnie_tui.commands.dispatch import attempt
from donnie_tui.commands.interaction import SLOW, SLOW_AGAIN, EnterWorld, Option, SwitchMode, drive
from donnie_tui.commands.preferences import Preferences
from donnie_tui.core.events import Answered
from donnie_tui.core.session_log import AnswerLog, LineHistory
from donnie_tui.core.workspace import Workspace
from donnie_tui.linear.console import Console, Gone, run_in_background
from donnie_tui.linear.greeting import Greeting, has_rescued
from donnie_tui.linear.leaving import Leaving
from donnie_tui.linear.line_editor import EditorEcho, KeyPress
from donnie_tui.linear.output import BackgroundRobots, Listener, OutputQueue, PacedOutput
from donnie_tui.linear.prompter import Printer, Prompter, Streams, prompt_text
from donnie_tui.linear.reader import EditingReader, How, PlainReader, Typed, candidates
from donnie_tui.linear.typed_lines import RunLoop, TypedLines
from donnie_tui.settings.folders import UNSAVED, state_path

if TYPE_CHECKING:
    from pathlib import Path

    from donnie_tui.core.runner import Run

T = TypeVar("T")

_LONGEST_NUMBER = 8


class ConversationState(Struct, frozen=True):
    """The state that a conversation takes into another world."""

    workspace: Workspace
    answers: AnswerLog
    past: LineHistory
    editing: EditingReader | None
    plain: PlainReader
    """With what was typed ahead."""
    watched: tuple[str, ...] = ()
    is_silent: bool = False
    script_code: int = 0
    """The exit code of a script for its lines in the worlds before."""


class Conversation:
    """Reads lines, runs and answers them, from the first prompt to the goodbye."""

    def __init__(
        self,
        donnie: Donnie,
        console: Console,
        preferences: Preferences,
        greeting: Greeting,
        state: ConversationState | None = None,
    ) -> None:
        """``state`` is that of the conversation in the world before."""
        self._donnie, self.console, self._greeting = donnie, console, greeting
        self._folder = state_path(os.environ)
        self._state = state = state or self._new_state()
        queue = OutputQueue(console.nudge)
        self.streams = streams = Streams(
            console,
            state.editing,
            state.plain,
            PacedOutput(console, paced=os.isatty(1)),
            queue,
            lambda: preferences.settings,
            is_attended=os.isatty(0),
            is_terminal=os.isatty(1),
        )
        state.workspace.begin_with(donnie.session.name)
        self.ctx = ctx = Context(
            donnie, LinearInteraction(self), state.workspace, state.answers, state.past, preferences
        )
        ctx.runs.watched.extend(state.watched)
        state.workspace.report_failure = lambda error: ctx.answer("answer-not-kept", reason=error.reason)
        self.background = BackgroundRobots(ctx, queue)
        self._listener = Listener(
            donnie,
            console,
            queue,
            self.background,
            is_paced=streams.is_attended and streams.is_terminal,
            is_known=ctx.errors.is_known,
        )
        self.printer = Printer(streams, donnie.words, state.answers)
        self.prompter = Prompter(ctx, streams, self.printer, self._listener, self.background)
        printing = (streams, self.printer, self.prompter, self.background)
        self.leaving = Leaving(ctx, *printing, greeting.offered)
        self.run_loop = RunLoop(ctx, *printing, self.leaving)
        self.typed_lines = TypedLines(ctx, streams)
        self.run_loop.turns_page = self._turns_page
        console.before_suspending = donnie.stop_real_robot
        console.last = (donnie.stop_real_robot, state.workspace.write_copies)
        console.has_run_away = lambda: donnie.connection.has_run_away
        console.on_not_suspended = self._say_not_suspended
        if streams.is_attended:
            console.on_key = donnie.outlets.audible.hush
        if state.editing:
            self._key_echo = EditorEcho(donnie.outlets.audible, donnie.words)
            state.editing.on_key = self._say_key
            state.editing.complete = partial(candidates, ctx)
        streams.apply_settings()

    def _new_state(self) -> ConversationState:
        has_terminal = self._greeting.terminal is not None
        past = LineHistory(f"{self._folder}/history" if has_terminal else None)
        editing = EditingReader(self.console, past) if has_terminal else None
        return ConversationState(
            open_workspace(self._folder), AnswerLog(), past, editing, PlainReader(self.console)
        )

    def _turns_page(self) -> bool:
        if self.typed_lines.continuation is None:
            return False
        from donnie_tui.i18n.help import STEP_PAGE

        return self.ctx.tour_page == STEP_PAGE

    def _say_key(self, key: KeyPress, before: str) -> None:
        if self._donnie.outlets.audible.echoes:
            self._key_echo(key, before)

    def close(self) -> None:
        """Unsubscribe from the session."""
        self.run_loop.close()
        self.ctx.close()
        self.prompter.copying.cancel()
        self._listener.close()

    def begin(self, file: str | None, text: str | None = None, *, offers_to_remember: bool = False) -> int:
        """Read and answer until something ends it. Returns the exit code.

        ``offers_to_remember``: the learner came from the full screen and may want to begin here next time.
        """
        return self._guarded(lambda: self._first_talk(file, text, offers_to_remember))

    def resume(self) -> int:
        """As ``begin``, in another world, with the state of the conversation before."""
        return self._guarded(self._talk_in_next_world)

    def state_for_next_world(self) -> ConversationState:
        is_silent = not self._donnie.outlets.audible.is_on
        return replace(
            self._state,
            watched=tuple(self.ctx.runs.watched),
            is_silent=is_silent,
            script_code=self._code_of_script(),
        )

    def take_again(self, line: str) -> None:
        """Take a line as if it had been typed."""
        self._state.past.remember(line)
        self.typed_lines.take(line)

    def _guarded(self, talk: Callable[[], int]) -> int:
        """Run ``talk``, and keep unsaved programs whatever ends it."""
        workspace = self._state.workspace
        try:
            return talk()
        except EnterWorld:
            workspace.write_copies()
            self.printer.show()
            if not self.streams.is_attended:  # a learner has ended the voice by typing
                self.leaving.let_speak()
            raise
        except SwitchMode:
            workspace.hand_over()
            raise
        except Gone:
            workspace.write_copies()
            self._donnie.rescue_world()
            return self.console.code_when_gone
        except BaseException:
            workspace.write_copies()
            self._donnie.rescue_world()
            raise
        finally:
            self._state.past.trim()

    def _first_talk(self, file: str | None, text: str | None, offers_to_remember: bool) -> int:
        self._donnie.outlets.audible.say_printed(*self._greeting.lines)
        is_shown = self._greeting.take_prompt()
        if text is not None:
            self._take_over(text, file)
        elif file is not None:
            from donnie_tui.commands import files

            drive(attempt(self.ctx, files.open_file(self.ctx, file)))
        self._say_notices()
        if offers_to_remember:
            self.leaving.offer_to_remember(linear=True)
        return self._take_lines(is_shown=is_shown)

    def _talk_in_next_world(self) -> int:
        from donnie_tui.commands.world import arrive

        arrive(self.ctx, is_silent=self._state.is_silent)
        self.ctx.say(*self._donnie.notices.about_devices)
        self._say_number_of_lines()
        return self._take_lines(is_shown=False)

    def _take_over(self, text: str, file: str | None) -> None:
        """Take the program that the full screen left; it is saved if its file contains the same."""
        from pathlib import Path

        from donnie_tui.core.program_files import saved_text

        path = Path(file) if file else None
        self.ctx.workspace.replace(text, path, in_file=saved_text(path) if path else "")
        self._say_number_of_lines()

    def _say_number_of_lines(self) -> None:
        if self.ctx.program.lines:
            self.ctx.answer("program-has-lines", lines=len(self.ctx.program.lines))

    def _say_notices(self) -> None:
        """Say what is missing. If the prompt is printed already, this comes with the first answer.

        Notices about the robot and the belt come at once: the learner must know which robot will move.
        """
        notices = self._donnie.notices
        self.ctx.say(*notices.all)
        self.console.has_news = bool(notices.about_devices)
        is_reported = not self.streams.is_attended or self._greeting.has_reported_rescue
        if not is_reported and has_rescued(f"{self._folder}/{UNSAVED}"):
            self.ctx.answer("answer-rescued")

    def _say_not_suspended(self) -> None:
        """Answer a Ctrl+Z that has no effect, before what a running program has said."""
        self._donnie.session.hub.publish(Answered(self._donnie.words("suspend-impossible"), at_once=True))

    def _take_lines(self, *, is_shown: bool) -> int:
        """Take lines until the exit code is known. ``is_shown``: whether the prompt is printed already."""
        if self.streams.is_attended:
            self.console.once_idle.append(self._donnie.get_ready_to_move)
        while self.leaving.code is None:
            depth = self.ctx.program.depth if self.streams.is_attended else 0
            self._take(self.prompter.read(prompt_text(self.streams.settings(), depth), shown=is_shown))
            is_shown = False
        self.leaving.say_goodbye()
        return self.leaving.code or self._code_of_script()

    def _code_of_script(self) -> int:
        """Learners correct their mistakes; a script only has an exit code to report them."""
        if self.streams.is_attended:
            return 0
        of_runs = FAILED if self.ctx.errors.had_any else 0
        return max(self._state.script_code, self.ctx.script_code, of_runs)

    def _take(self, typed: Typed) -> None:
        if self.console.leaving is not None:
            self.leaving.leave_by_signal(self.console.leaving)
            return
        match typed.how:
            case How.CLOSED:
                self.leaving.close()
            case How.INTERRUPTED:
                self.typed_lines.continuation = None
                self.leaving.interrupt(typed.text)
            case How.TOO_LONG:
                self.ctx.answer("program-too-long")
            case How.ENTER:
                self.take_again(typed.text)
            case How.ESCAPE:
                self._state.past.remember(typed.text)
                self.typed_lines.take_and_run(typed.text)
        self.leaving.enter_world()


class LinearInteraction:
    """``commands.interaction.Interaction`` at the prompt. Nothing in it ever waits for an event loop."""

    def __init__(self, conversation: Conversation) -> None:
        self._conversation = conversation

    @property
    def can_edit(self) -> bool:
        return self._conversation.streams.can_edit

    @property
    def is_attended(self) -> bool:
        return self._conversation.streams.is_attended

    # --- questions

    async def ask(
        self,
        question: str,
        text: str = "",  # noqa: ARG002 -- a screen reader would not say it
        accepts: Callable[[str], str | None] | None = None,
    ) -> str | None:
        prompter = self._conversation.prompter
        answer = prompter.ask(question)
        while answer and accepts is not None and (problem := accepts(answer)) is not None:
            answer = prompter.ask(problem)
        return answer or None

    async def ask_file(
        self,
        question: str,
        text: str,
        recent: Callable[[], Sequence[Path]],  # noqa: ARG002 -- for front ends with lists
        *,
        is_new: bool = False,  # noqa: ARG002 -- as above
    ) -> str | Path | None:
        return await self.ask(question, text)

    async def choose(
        self,
        question: str,  # noqa: ARG002 -- the list is read without it
        options: Sequence[Option],
        printed: Sequence[str] = (),
    ) -> str | None:
        """The number of an option, typed next, chooses it; Escape and any other line choose none."""
        ctx, prompter = self._conversation.ctx, self._conversation.prompter
        by_number = {each.number: each for each in options if each.number}
        ctx.say(*printed)
        if not by_number:
            return None
        ctx.answer("type-number")
        typed = prompter.read_next()
        text = typed.text.strip()
        if typed.how is How.ESCAPE and not text:
            return None
        if typed.how is not How.ENTER or not text.isdecimal() or len(text) > _LONGEST_NUMBER:
            prompter.put_back(typed)
            return None
        number = int(text)
        if number not in by_number:
            ctx.answer("answer-no-line", line=number, last=max(by_number))
            return None
        chosen = by_number[number]
        ctx.answer("numbered-line", line=number, text=chosen.text)
        return chosen.value

    async def confirm(self, question: str) -> bool | None:
        return self._conversation.prompter.confirm(question)

    async def edit_line(self, question: str, text: str = "") -> str | None:
        prompter = self._conversation.prompter
        prompter.offered = text
        self._conversation.ctx.say(question)
        typed = prompter.read_next()
        if typed.how is How.ENTER or (typed.how is How.ESCAPE and typed.text.strip()):
            return typed.text
        if typed.how is How.CLOSED or self._conversation.console.leaving is not None:
            prompter.put_back(typed)
        return None

    async def show_pages(
        self,
        title: str,  # noqa: ARG002 -- the lines are read without it
        lines: Sequence[str],
        printed: Sequence[str] | None = None,
    ) -> None:
        self._conversation.ctx.say(*(lines if printed is None else printed))

    # --- time

    async def background(
        self, task: Callable[[], T], slow: str, *, may_be_left: bool = False, is_slow: bool = False
    ) -> T:
        return run_in_background(
            self._conversation.console,
            task,
            lambda: self._conversation.ctx.say(slow),
            first=SLOW_AGAIN if is_slow else SLOW,
            show=self._conversation.printer.show,
            may_be_left=may_be_left,
        )

    async def finish(self, task: Coroutine[Any, Any, T]) -> T:
        return await task

    async def finished(self) -> None:
        """Nothing runs while a question is asked."""

    async def follow(self, runs: Sequence[tuple[str | None, Run]]) -> bool:
        self._conversation.run_loop.follow(runs)
        return True

    async def wait(self, seconds: float) -> bool:
        self._conversation.printer.show()
        return self._conversation.console.is_disturbed_within(seconds, reading=self.is_attended)

    def print_soon(self) -> None:
        self._conversation.console.nudge()

    def continue_on_enter(self, more: Callable[[], Coroutine[Any, Any, None]]) -> None:
        self._conversation.typed_lines.continuation = lambda: drive(more())

    def setting_changed(self, key: str) -> None:  # noqa: ARG002 -- all options are applied
        self._conversation.streams.apply_settings()

    def before_robot_changes(self) -> None:
        """Each robot keeps its own document."""

    def robot_changed(self) -> None:
        ctx = self._conversation.ctx
        ctx.workspace.choose_robot(ctx.donnie.session.name)

    async def type_again(self, line: str) -> None:
        self._conversation.take_again(line)

    # --- ways out

    async def enter_world(self, name: str) -> None:
        """Raises ``EnterWorld``; while a program is held, the run loop stops it first."""
        leaving = self._conversation.leaving
        leaving.world = name
        if not self._conversation.background.is_following:
            leaving.enter_world()

    async def switch_mode(self) -> None:
        self._conversation.leaving.switch_to_screen()

    async def quit(self) -> None:
        self._conversation.leaving.quit()
