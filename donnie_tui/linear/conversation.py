"""One conversation in the linear mode: lines are typed, run and answered.

Rules: nothing that stands printed is ever changed; leaving is always possible; whatever ends the session,
the robot stops and no typed program is lost.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING

from msgspec import Struct

from donnie_tui.bootstrap import Donnie, open_workspace
from donnie_tui.commands.context import Context
from donnie_tui.commands.dispatch import attempt
from donnie_tui.commands.interaction import EnterWorld, SwitchMode, drive
from donnie_tui.commands.preferences import Preferences
from donnie_tui.core.answer_log import AnswerLog
from donnie_tui.core.line_history import LineHistory
from donnie_tui.core.workspace import Workspace
from donnie_tui.linear.console import Console, Gone
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.ends import Ends
from donnie_tui.linear.greeting import Greeting, has_rescued
from donnie_tui.linear.interaction import LinearInteraction
from donnie_tui.linear.leaving import Leaving
from donnie_tui.linear.line_editor import Key
from donnie_tui.linear.options import Options
from donnie_tui.linear.output import Output, Told
from donnie_tui.linear.reader import EditingReader, How, PlainReader, Typed
from donnie_tui.linear.run_loop import RunLoop
from donnie_tui.linear.typed_lines import TypedLines
from donnie_tui.settings.folders import UNSAVED

if TYPE_CHECKING:
    from donnie_tui.linear.line_editor import KeyEcho


class Kept(Struct, frozen=True):
    """What goes along to another world."""

    workspace: Workspace
    answers: AnswerLog
    past: LineHistory
    editing: EditingReader | None
    plain: PlainReader
    """With what was typed ahead."""
    watched: tuple[str, ...]
    is_silent: bool


class Conversation:
    """From the first prompt to the goodbye."""

    def __init__(
        self,
        donnie: Donnie,
        console: Console,
        folder: str,
        preferences: Preferences,
        greeting: Greeting,
        kept: Kept | None = None,
    ) -> None:
        """``folder`` keeps what was typed before and what could not be saved, ``kept`` what came along."""
        told, options = Told(console.nudge), Options(lambda: preferences.settings)
        self._greeting, self._folder = greeting, folder
        edits, attended = greeting.terminal is not None, os.isatty(0)
        self._past = kept.past if kept else LineHistory(f"{folder}/history" if edits else None)
        self._plain = kept.plain if kept else PlainReader(console)
        self._editing = editing = self._reader_with(kept, console) if edits else None
        output = Output(
            console,
            paced=os.isatty(1),
            of_numbers=lambda count: donnie.words("linear-numbers", count=count),
        )
        workspace = kept.workspace if kept else open_workspace(folder)
        ends = Ends(
            console,
            editing,
            self._plain,
            output,
            told,
            options,
            prompts=attended,
            is_terminal=os.isatty(1),
            offered=greeting.offered,
        )
        answers = kept.answers if kept else AnswerLog()
        self._desk = desk = Desk(donnie, ends, workspace, answers, self._past)
        desk.ctx = Context(
            donnie,
            LinearInteraction(desk),
            workspace,
            answers,
            self._past,
            preferences,
        )
        if kept:
            desk.ctx.runs.watched.extend(kept.watched)
        self._is_silent = kept is not None and kept.is_silent
        self._desk.take_again = self._take_again
        self._leaving = Leaving(self._desk)
        self._runs = RunLoop(self._desk, told, editing)
        self._desk.follow = self._runs.follow
        self._lines = TypedLines(self._desk, self._runs, self._leaving)
        self._console = console
        console.before_suspending = donnie.stop_real_robot
        if attended:
            console.on_key = donnie.outlets.audible.hush
        if editing:
            editing.on_key = self._say_key
        ends.apply_options()

    def _say_key(self, key: Key, before: str) -> None:
        if self._desk.donnie.outlets.audible.echoes:
            self._key_echo(key, before)

    @cached_property
    def _key_echo(self) -> KeyEcho:
        from donnie_tui.linear.line_editor import KeyEcho  # where the own voice speaks

        return KeyEcho(self._desk.donnie.outlets.audible, self._desk.donnie.words)

    def close(self) -> None:
        """Hear no more of the session."""
        self._runs.close()
        self._desk.close()

    def until_left(
        self, file: str | None, text: str | None = None, *, offers_to_remember: bool = False
    ) -> int:
        """Read and answer until something ends it. The exit code.

        ``offers_to_remember``: somebody came here by a word and may want to begin here the next time.
        """
        return self._kept_safe(lambda: self._talk(file, text, offers_to_remember))

    def go_on(self) -> int:
        """As ``until_left``, in another world, with what came along."""
        return self._kept_safe(self._talk_there)

    def packed(self) -> Kept:
        """What goes along to another world."""
        desk = self._desk
        return Kept(
            desk.workspace,
            desk.answers,
            self._past,
            self._editing,
            self._plain,
            tuple(desk.ctx.runs.watched),
            is_silent=not desk.donnie.outlets.audible.is_on,
        )

    def _reader_with(self, kept: Kept | None, console: Console) -> EditingReader:
        """The one that came along, or a new one."""
        reader = kept.editing if kept else None
        if reader is None:
            return EditingReader(console, self._past, self._candidates)
        reader.complete = self._candidates
        return reader

    def _kept_safe(self, talk: Callable[[], int]) -> int:
        try:
            return talk()
        except EnterWorld:
            self._desk.workspace.write_copies()
            self._desk.showing.show_told()
            if not self._desk.is_attended:  # whoever types has ended the voice by that
                self._leaving.let_speak()
            raise
        except SwitchMode:
            self._desk.workspace.hand_over()
            raise
        except Gone:
            self._desk.workspace.write_copies()
            return self._console.code_when_gone
        except BaseException:
            self._desk.workspace.write_copies()
            raise
        finally:
            self._past.trim()

    def _talk(self, file: str | None, text: str | None, offers_to_remember: bool) -> int:
        desk = self._desk
        desk.donnie.outlets.audible.say_printed(*self._greeting.lines)
        is_shown = self._greeting.take_prompt()
        if text is not None:
            self._take_over(text, file)
        elif file is not None:
            from donnie_tui.commands import files

            drive(attempt(desk.ctx, files.open_named(desk.ctx, file)))
        self._tell_notices()
        if offers_to_remember:
            from donnie_tui.linear import modes

            modes.offer_to_remember(desk, linear=True)
        return self._take_lines(is_shown=is_shown)

    def _talk_there(self) -> int:
        from donnie_tui.commands.world import say_arrival

        desk = self._desk
        say_arrival(desk.donnie, is_silent=self._is_silent)
        desk.tell(*desk.donnie.notices.about_devices)
        if desk.program.lines:
            desk.answer("linear-lines", lines=len(desk.program.lines))
        return self._take_lines(is_shown=False)

    def _take_lines(self, *, is_shown: bool) -> int:
        """``is_shown``: whether the prompt stands there already."""
        desk = self._desk
        if desk.is_attended:
            self._console.once_idle.append(desk.donnie.get_ready_to_move)
        while desk.leaving is None:
            self._take(desk.asking.read(self._prompt(), shown=is_shown))
            is_shown = False
        self._leaving.say_goodbye()
        return desk.leaving

    def _take_over(self, text: str, file: str | None) -> None:
        """The program that the full screen left; it is saved if its file says the same."""
        from pathlib import Path

        from donnie_tui.core.program_files import saved_text

        path = Path(file) if file else None
        self._desk.workspace.replace(text, path, in_file=saved_text(path) if path else "")
        if self._desk.program.lines:
            self._desk.answer("linear-lines", lines=len(self._desk.program.lines))

    def _tell_notices(self) -> None:
        """What had to be done without. Where the prompt stands already, it comes with the first answer.

        What is about the robot and the belt comes at once: whoever types must know which robot will move.
        """
        desk = self._desk
        desk.tell(*desk.donnie.notices.all)
        self._console.has_news = bool(desk.donnie.notices.about_devices)
        if desk.is_attended and not self._greeting.told_rescued and has_rescued(f"{self._folder}/{UNSAVED}"):
            desk.answer("answer-rescued")

    def _prompt(self) -> str:
        in_program = self._desk.is_attended and not self._desk.next_line
        depth = self._desk.program.depth if in_program else 0
        return self._desk.ends.options.prompt_at(depth)

    def _candidates(self, before: str) -> tuple[str, ...]:
        """For Tab. Loaded when somebody presses it."""
        from donnie_tui.linear.completion import candidates

        return candidates(self._desk, before)

    def _take(self, typed: Typed) -> None:
        if self._desk.leaving is None and self._console.leaving is not None:
            self._leaving.leave_by_signal(self._console.leaving)
            return
        match typed.how:
            case How.CLOSED:
                self._leaving.close()
            case How.INTERRUPTED:
                self._leaving.interrupt(typed.text)
            case How.TOO_LONG:
                self._desk.answer("linear-too-long")
            case How.ENTER:
                self._past.remember(typed.text)
                self._lines.take(typed.text)
            case How.ESCAPE:
                self._past.remember(typed.text)
                self._lines.take_and_run(typed.text)
        if self._desk.goes_to:
            from donnie_tui.linear.going import depart

            depart(self._desk)

    def _take_again(self, line: str) -> None:
        """A line that was typed before, chosen by its number."""
        self._past.remember(line)
        self._lines.take(line)
