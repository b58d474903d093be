"""The controller of the full screen: connects the session with the main screen.

Made once the session is loaded. Keys and typed lines run commands here, and events reach the panes.
"""

from __future__ import annotations

import os
from collections.abc import Awaitable, Coroutine, Mapping, Sequence
from pathlib import Path
from typing import Any

from msgspec import Struct
from textual import events
from textual.app import App
from textual.timer import Timer
from textual.widget import Widget
from textual.widgets import Input, TextArea

from donnie_tui.bootstrap import Donnie
from donnie_tui.commands.context import Context
from donnie_tui.commands.declarations import BY_NAME, Command
from donnie_tui.commands.dispatch import attempt, perform, refuse_busy, says_slip
from donnie_tui.commands.files import compare_with_file, open_file
from donnie_tui.commands.interaction import begin
from donnie_tui.commands.keys import KeyTable, not_understood
from donnie_tui.commands.lookup import find
from donnie_tui.commands.sound import chime_block
from donnie_tui.commands.world import arrive
from donnie_tui.core.completion import Completion, NextLine, completion, next_line
from donnie_tui.core.events import Pointed
from donnie_tui.core.program_text import LONGEST_CHECKED, mistakes
from donnie_tui.core.run_state import RunState
from donnie_tui.core.runner import LAST_WORDS, Run, RunRequest
from donnie_tui.core.session import Busy
from donnie_tui.core.session_log import AnswerLog, LineHistory
from donnie_tui.core.wording import Wording
from donnie_tui.core.workspace import Workspace
from donnie_tui.outlets.audible import Audible, TypingEcho
from donnie_tui.settings.folders import offers_tour
from donnie_tui.tui.display import Display
from donnie_tui.tui.event_queue import CALM, FRAME, EventBatch, EventQueue, EventReader, LogLine
from donnie_tui.tui.run_view import RunView
from donnie_tui.tui.screens.main_screen import MainScreen
from donnie_tui.tui.terminal import TerminalApp
from donnie_tui.tui.widgets.editor import Editor
from donnie_tui.tui.widgets.rows import TYPED_MARK
from language.diagnostics import MistakeKind
from language.keywords import spelling
from language.outline import block_depth
from language.source import quoted

CHECK_AFTER = 0.4
"""Seconds without typing after which mistakes are marked."""

COPY_AFTER = 1.0
"""Seconds after an edit within which a copy is written."""


class ScreenState(Struct, frozen=True):
    """The state that the screen takes into another world: the programs, the log and the typed lines."""

    log: tuple[tuple[str, str], ...]
    """The lines of the log, each with the words of its kind."""
    looks: Mapping[str, str]
    answers: AnswerLog
    typed: LineHistory
    """The lines of the command line."""
    workspace: Workspace
    watched: tuple[str, ...]
    focus: str
    """The part of the screen that had the focus."""
    is_silent: bool
    """Whether SOUND OFF was typed."""


class ScreenController:
    """One session at the screen."""

    def __init__(self, app: TerminalApp, main_screen: MainScreen, key_table: KeyTable, ctx: Context) -> None:
        self.ctx, self.donnie, self.words = ctx, ctx.donnie, ctx.words
        self.workspace, self.answers = ctx.workspace, ctx.answers
        self.app, self.main_screen = app, main_screen
        donnie = ctx.donnie
        self.workspace.report_failure = lambda error: donnie.say("answer-not-kept", reason=error.reason)
        self.workspace.attach(main_screen.editor)
        self.display = Display(main_screen, ctx, key_table)
        queue = EventQueue(
            app.post_message, self.words, lambda: donnie.session.pose, lambda: donnie.session.name
        )
        self.events = EventReader(
            queue, self.words, set_timer=app.set_timer, receive=self._receive, write=self._write
        )
        self._key_echo = ScreenKeyEcho(donnie.outlets.audible, self.words)
        self.run_view = RunView(app, ctx, self.events, self.display, main_screen.editor)
        self.assistant = EditorAssistant(app, ctx, self.display, main_screen.editor)
        self._apply_completion()
        self._apply_motion()
        self._unsubscribe = donnie.team.stream.subscribe(queue)
        self.next_world = ""
        """The world in which the screen opens again."""
        self.left_for_linear = False

    def begin(
        self, file: Path | None, text: str | None, restored: ScreenState | None, state_folder: str
    ) -> Coroutine[None, None, None] | None:
        """Say the notices of the start; returns a coroutine that opens the first file.

        ``text``: what the other mode left, unsaved changes included.
        """
        notices, settings, opening = self.donnie.notices, self.ctx.preferences.settings, None
        self.ctx.say(*(notices.all if restored is None else notices.about_devices))
        for entry in not_understood(settings.keys):
            self.ctx.answer("keys-not-understood", entry=quoted(entry))
        if text is not None:
            self.workspace.replace(text, file, in_file="")
            opening = attempt(self.ctx, compare_with_file(self.ctx))
        elif file is not None:
            opening = attempt(self.ctx, open_file(self.ctx, str(file)))
        elif settings.tour and offers_tour(state_folder, os.environ):
            self.ctx.answer("tour-offer")
        if restored is not None:
            self._restore(restored)
        elif self.workspace.rescued():
            self.ctx.answer("answer-rescued")
        self.display.update()
        return opening

    def _restore(self, state: ScreenState) -> None:
        """Continue with the answers of the world before, and announce this one."""
        self.answers = self.ctx.answers = state.answers
        self.answers.end_answer()
        self.main_screen.command_line.have_typed(state.typed)
        self.ctx.past = state.typed
        self.ctx.runs.watched.extend(state.watched)
        arrive(self.ctx, is_silent=state.is_silent)

    @property
    def state(self) -> ScreenState:
        """The state to take into another world."""
        log = self.main_screen.log_rows
        return ScreenState(
            log.with_kinds,
            log.looks,
            self.answers,
            self.main_screen.command_line.past,
            self.workspace,
            tuple(self.ctx.runs.watched),
            self.main_screen.focus_was,
            is_silent=not self.donnie.outlets.audible.is_on,
        )

    # --- commands

    def do(self, name: str, argument: str | None = None) -> Awaitable[None] | None:
        """Run a command up to its first question; returns the rest to await.

        ``argument`` is None if a key or the palette asked for it.
        """
        self._end_answer()
        return begin(self._perform(BY_NAME[name], argument))

    async def _perform(self, command: Command, argument: str | None) -> None:
        self.main_screen.editor.suggestion = ""  # only typing continues an offered word
        if command.name not in ("undo", "redo"):
            self.main_screen.editor.finish_typed_end()
        await perform(self.ctx, command, argument)
        self.run_view.show_past()
        self.display.update()

    def look_at(self, step: int) -> None:
        """Show the moment of the run after that many steps."""
        self._end_answer()
        sentences = self.ctx.runs.look_at(step)
        if not sentences and not step:
            self.ctx.answer_once("undone-start")
        self.ctx.say(*sentences)
        self.run_view.show_past()
        self.display.update()

    def run_line(self, text: str) -> Awaitable[None] | None:
        """Run a line of the command line: a command of the screen, or one of GoDonnie."""
        self._end_answer()
        self.display.write([(f"{TYPED_MARK}{text}", "typed")])
        found = find(text)
        if found is not None:
            return self.do(found[0].name, found[1])
        if not says_slip(self.ctx, text) and not self._opens_block(text):
            try:
                self.ctx.runs.start(RunRequest(text, self.words("typed-program"), is_whole=False))
            except Busy as busy:
                refuse_busy(self.ctx, busy)
            self.display.update()
        return None

    def _end_answer(self) -> None:
        """End the current answer; the next line begins another one."""
        self.events.flush()
        self.answers.end_answer()

    def _opens_block(self, typed: str) -> bool:
        """Whether the line opens a block; then an answer says that blocks belong into the program."""
        missing = self.donnie.session.parse(typed).diagnostics
        if not missing or any(each.kind is not MistakeKind.MISSING_END for each in missing):
            return False
        closer = spelling(missing[0].expected[0], self.words.language)
        self.ctx.answer("screen-open-block", closer=closer)
        return True

    def key_pressed(self, event: events.Event, focused: Widget | None) -> None:
        """Stop the speech at any key, and speak the key if the learner wants that."""
        self.donnie.outlets.audible.hush()
        self._key_echo(event, focused)
        self.display.acted()

    # --- events

    def _receive(self, batch: EventBatch) -> None:
        """Show a batch of events; ask for the distances again if robots or things have moved."""
        self.display.receive(batch)
        self.run_view.polling.on_event()
        if batch.others or batch.things is not None:
            self.display.ask_distances()

    def _write(self, lines: Sequence[LogLine]) -> None:
        """Write lines into the log and into the answers to repeat."""
        for line in lines:
            if not line.is_repeated:
                self.answers.add_line(line.text)
        self.display.write((line.text, line.kind) for line in lines)

    def point(self, words: str) -> None:
        """Speak the pointed square or list row; any key ends it, and it is not logged."""
        self.donnie.session.hub.publish(Pointed(words))

    def on_explored(self) -> None:
        """Speak the explored square of the map, and show it in the status line."""
        pointer = self.main_screen.map.pointer
        if pointer is not None and pointer.cell is not None:
            self.point(pointer.words(self.words))
        self.display.looked()

    # --- settings

    def apply_setting(self, key: str) -> None:
        """Apply the new value of a setting to the screen."""
        if key == "lang":
            self.display.relabel()
            self.assistant.check_now()
        elif key == "completion":
            self._apply_completion()
        elif key == "motion":
            self._apply_motion()
        elif key in ("trail", "rays", "goals"):
            self.display.show_marks_of_map()
        self.app.apply_settings(self.ctx.preferences.settings)
        self.display.update()

    def _apply_completion(self) -> None:
        self.assistant.offer_words(wanted=self.ctx.preferences.settings.completion)

    def _apply_motion(self) -> None:
        self.events.frame = CALM if self.ctx.preferences.settings.motion == "reduced" else FRAME

    # --- the end

    def switch_to_linear(self) -> None:
        """Continue in the linear mode, which has the text now, so that no copy is needed."""
        self.assistant.stop_copying()
        self.workspace.hand_over()
        self.left_for_linear = True
        self.app.exit(0)

    def leave(self) -> None:
        """Leave because the learner asked for it."""
        self.assistant.stop_copying()
        self.workspace.leave_copies()
        self.app.exit(0)

    def change_world(self, name: str) -> None:
        """Enter another world with the same program."""
        self.ctx.runs.stop_to_leave()
        self.ctx.answer_entering(name)
        self.events.flush()
        self.assistant.stop_copying()
        self.next_world = name
        self.app.keep_input()  # what is typed from now on is for that world
        self.app.exit(0)

    def hand_over(self) -> Donnie:
        """Hand the session to the other mode, and end everything of the screen."""
        self.ctx.close()
        self._unsubscribe()
        self.donnie.team.stop()
        for session in self.donnie.team.sessions:
            if session.run is not None:
                session.run.wait(LAST_WORDS)
        self.workspace.write_copies()
        return self.donnie

    def close(self) -> None:
        """End programs and write copies after the screen has closed."""
        self.donnie.close()
        self.workspace.detach()
        self.workspace.write_copies()


class ScreenKeyEcho:
    """Speaks typed keys: in the program, in the command line and in questions.

    It gets each key and each paste before the widget with the focus.
    """

    def __init__(self, audible: Audible, words: Wording) -> None:
        self._echo = TypingEcho(audible, words)

    def __call__(self, event: events.Event, focused: Widget | None) -> None:
        before = _before_cursor(focused) if self._echo.kind != "none" else None
        if before is None:
            return
        match event:
            case events.Paste(text=text):
                self._echo.typed(text, before)
            case events.Key(key="backspace"):
                self._echo.deleted(before)
            case events.Key(key="enter"):
                self._echo.ended(before)
            case events.Key(character=str() as character) if event.is_printable:
                self._echo.typed(character, before)
            case _:
                pass


def _before_cursor(widget: Widget | None) -> str | None:
    """The text before the cursor in its line; None if nothing can be typed."""
    match widget:
        case TextArea():
            row, column = widget.cursor_location
            return widget.document.get_line(row)[:column]
        case Input():
            return widget.value[: widget.cursor_position]
        case _:
            return None


class EditorAssistant:
    """Helps while a program is typed: completion, marked mistakes, cues of blocks, and unsaved copies.

    Nothing waits for it; slow work is done a moment after the last letter.
    """

    def __init__(self, app: App[Any], ctx: Context, display: Display, editor: Editor) -> None:
        self._app, self._ctx, self._display, self._editor = app, ctx, display, editor
        self._checking: Timer | None = None
        self._copying: Timer | None = None
        self._reported: Run | None = None
        """The last run for which a change of its text was reported."""

    def edited(self) -> None:
        """Schedule a check and a copy of the changed text."""
        self._report_running()
        self._display.show_titles()
        if self._checking is not None:
            self._checking.stop()
        self._checking = self._app.set_timer(CHECK_AFTER, self.check_now)
        if self._copying is None:
            self._copying = self._app.set_timer(COPY_AFTER, self._keep_copy)

    def _report_running(self) -> None:
        """Say, once in each run, that the robot still runs the text before the change."""
        runs, run = self._ctx.runs, self._ctx.donnie.session.run
        is_running = runs.is_whole and runs.state in (RunState.RUNNING, RunState.PAUSED)
        if is_running and run is not self._reported and self._editor.is_typed:
            self._reported = run
            self._ctx.answer("edited-while-running")

    def check_now(self) -> None:
        """Mark the mistakes of the current text."""
        self._checking = None
        text, session = self._editor.text, self._ctx.donnie.session
        found = session.check(text) if len(text) <= LONGEST_CHECKED and text.strip() else ()
        self._editor.note(mistakes(found, self._ctx.words))
        self._display.show_titles()
        self._display.say_status()

    def offer_words(self, *, wanted: bool) -> None:
        """Turn the editor's suggestions, indentation and block ends on or off."""
        self._editor.complete = self.completion if wanted else None
        self._editor.next_line = self.next_line if wanted else None

    def next_line(self, lines: Sequence[str], row: int) -> NextLine:
        """The text that Enter writes at the end of that row."""
        return next_line(lines, row, self._ctx.words.language)

    def completion(self, text: str, at: int) -> Completion:
        """The possible words at that place of the text."""
        language, colours = self._ctx.words.language, self._ctx.donnie.session.colours
        return completion(text, at, language, colours)

    def line_finished(self, row: int) -> None:
        """Play the cue of a block that the finished row (from 0) opens or closes."""
        text, donnie = self._editor.text, self._ctx.donnie
        if donnie.outlets.audible.has_cues and len(text) <= LONGEST_CHECKED:
            lines = text.split("\n")
            depths = (block_depth("\n".join(lines[:end])) for end in (row, row + 1))
            chime_block(donnie, *depths)

    # --- copies

    def _keep_copy(self) -> None:
        self._copying = None
        self._ctx.workspace.keep_copies()

    def stop_copying(self) -> None:
        """Stop copying because the learner leaves; the last copies are written at the end."""
        if self._copying is not None:
            self._copying.stop()
