"""The full-screen application: it owns the session and wires it to the workplace.

Rules: the screen appears first, the session is assembled behind it; programs run in their own thread and
reach the screen through the bridge's mailbox; whatever ends the application, the robot is halted and the
terminal given back. Long because everything meets here; what is done is in ``deeds``, ``files``, ``running``.
"""

from __future__ import annotations

import asyncio
import os
import signal
import sys
import time
from collections.abc import Awaitable, Callable, Iterable
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

from textual.app import App, SystemCommand
from textual.binding import Binding, BindingType
from textual.geometry import Offset
from textual.message import Message
from textual.screen import Screen
from textual.timer import Timer
from textual.widgets import TextArea

from devices.ports.robot import Pose
from donnie_tui.core.events import Answered, Outcome, Read
from donnie_tui.core.map_grid import MapGrid, floor_size
from donnie_tui.folders import state_folder
from donnie_tui.i18n.catalogue import SENTENCES
from donnie_tui.i18n.words import Words
from donnie_tui.settings import Settings
from donnie_tui.tui.actions import ACTIONS, BY_NAME, find, key_label
from donnie_tui.tui.bridge import Began, Bridge, Ended, LogLine, Mail
from donnie_tui.tui.deeds import Deeds
from donnie_tui.tui.files import Files
from donnie_tui.tui.filing import Copies
from donnie_tui.tui.running import Answer, Doing, Running
from donnie_tui.tui.screens.help import Help, help_text
from donnie_tui.tui.screens.question import Question
from donnie_tui.tui.screens.workplace import Workplace
from donnie_tui.tui.situation import (
    cell_sentence,
    doing_sentences,
    inspector_lines,
    robot_sentence,
)
from donnie_tui.tui.widgets.command_line import CommandLine
from language.control import ControlState
from language.keywords import canonical

if TYPE_CHECKING:
    from donnie_tui.bootstrap import Donnie

FRAME = 1 / 20
"""Seconds between two looks into the mailbox: the map moves at most so often."""
FLUSH = 1 / 5
"""Seconds between two writes into the log, and between two looks at the running line."""
COPY_AFTER = 1.0
"""Seconds after an edit within which it is written down."""

SHOW_CURSOR = "\x1b[?25h"

CRASHED = 1
"""Textual's return code after a fault of ours; the text is kept for the next start."""

_OFFERED = {
    Doing.READY: ("run", "step", "save", "open", "show_variables", "help", "quit"),
    Doing.RUNNING: ("stop", "pause", "slower", "faster", "show_variables", "help"),
    Doing.PAUSED: ("pause", "step", "step_over", "run_to", "stop", "show_variables", "help"),
    Doing.STOPPING: ("help",),
}
"""The keys that the bottom line shows, by what the program does."""


class Paused(Message):
    """The running program holds."""


class DonnieApp(App[int], inherit_bindings=False):
    """One learner at one terminal."""

    CSS_PATH = "styles/donnie.tcss"
    TITLE = "Donnie"
    BINDINGS: ClassVar[list[BindingType]] = [
        *(
            Binding(",".join(each.keys), f"do('{each.name}')", each.en, priority=True, show=False)
            for each in ACTIONS
            if each.keys
        ),
        Binding("ctrl+c", "do('stop', True)", show=False, priority=True),
        Binding("tab", "app.focus_next", show=False),
        Binding("shift+tab", "app.focus_previous", show=False),
    ]

    def __init__(
        self,
        settings: Settings,
        file: Path | None = None,
        *,
        text: str | None = None,
        assemble: Callable[[], Donnie],
        folder: Path | None = None,
    ) -> None:
        """``text``: what the other mode left, unsaved changes included. ``folder`` holds the copies."""
        super().__init__()
        self.animation_level = "none"
        if self.no_color:
            self.theme = "ansi-dark"
        self.words = Words(settings.language, settings.verbosity)
        self.workplace = Workplace()
        unsaved = Path(folder or state_folder(os.environ)) / "unsaved"
        self.files = Files(self, self.words, Copies(unsaved))
        self.trouble: Exception | None = None
        """What kept the session from being assembled."""
        self.left_for_linear = False
        self._file, self._text = file, text
        self._assemble = assemble
        self._donnie: Donnie | None = None
        self._deeds = Deeds(self)
        self._pose: Pose | None = None
        self._lines: list[LogLine] = []
        self._kinds: dict[str, str] = {}
        self._readings: dict[tuple[str, str], Read] = {}
        self._belt: tuple[int, ...] | None = None
        self._taken_at = self._flushed_at = -FLUSH
        self._taking: Timer | None = None
        self._flushing: Timer | None = None
        self._watching: Timer | None = None
        self._copying: Timer | None = None

    # --- beginning

    def get_default_screen(self) -> Screen[None]:
        return self.workplace

    def on_mount(self) -> None:
        self._handle_signals()
        self.app_resume_signal.subscribe(self, lambda _: self._show_cursor())
        self.workplace.map_pane.entitle(self.words("pane-map-empty"))
        self.workplace.log_pane.entitle(self.words("pane-log"))
        self.workplace.inspector_pane.entitle(self.words("pane-inspector"))
        self._note(self.words("screen-start"), self.words("screen-start-keys"))
        self.look()
        self.call_after_refresh(self._begin)

    def on_ready(self) -> None:
        self._show_cursor()

    def _show_cursor(self) -> None:
        """Textual hides the terminal's cursor; braille displays and console readers need it."""
        if self._driver is not None:
            self._driver.write(SHOW_CURSOR)

    def _begin(self) -> None:
        """The screen is there; now what it shows."""
        try:
            self._donnie = self._assemble()
        except Exception as trouble:  # noqa: BLE001 -- told by the caller, once the terminal is given back
            self.trouble = trouble
            self.exit(2)
            return
        session = self._donnie.session
        self.running = Running(session, self._paused)
        self._bridge = Bridge(self.post_message, self._donnie.words, lambda: session.pose)
        session.hub.subscribe(self._bridge)
        self._show_world(self._donnie)
        self._note(*self._donnie.notices)
        self._bring_program()
        if self.files.offers_recovery:
            self._note(self.words("screen-recovery"))
        self.look()

    def _show_world(self, donnie: Donnie) -> None:
        picture = donnie.picture()
        self._pose = donnie.session.pose
        self.workplace.show_map(MapGrid(picture, self._pose))
        width, height = floor_size(picture)
        self.workplace.map_pane.entitle(
            self.words("pane-map", world=_title(donnie), width=width, height=height)
        )

    def _bring_program(self) -> None:
        if self._text is not None:
            self.files.bring(self._text, str(self._file) if self._file else None)
        elif self._file is not None:
            self.files.open_now(str(self._file))

    @property
    def is_ready(self) -> bool:
        """Whether the session is there."""
        return self._donnie is not None

    @property
    def cursor_position(self) -> Offset:
        """Where the terminal's own cursor stands: where the widget with the focus says, at every update."""
        place = getattr(self.focused, "cursor_screen_offset", None) if self.is_running else None
        return place if isinstance(place, Offset) else Offset(0, 0)

    @cursor_position.setter
    def cursor_position(self, _place: Offset) -> None:
        """Textual's editor and input line write here, also without the focus: not what is asked."""

    # --- doing

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Actions belong to the workplace; Ctrl+C copies while nothing runs."""
        if action == "do":
            only_while_running = len(parameters) > 1
            return self.screen is self.workplace and not (only_while_running and self._doing is Doing.READY)
        return super().check_action(action, parameters)

    def action_do(self, name: str, _only_while_running: bool = False) -> None:
        """A key was pressed."""
        if (
            name == "run"
            and self.workplace.command_line.has_focus
            and self.workplace.command_line.value.strip()
        ):
            self.workplace.command_line.finish()
        else:
            self.do(name)

    def do(self, name: str, argument: str = "") -> None:
        """Do an action of the table, whichever way it was asked for."""
        if self._donnie is None and name not in ("linear", "quit", "help"):
            self._note(self.words("screen-starting"))
            return
        asking = self._deeds.do(name, argument)
        if asking is not None:
            self.run_worker(self._finish(asking), exclusive=True)

    async def _finish(self, asking: Awaitable[None]) -> None:
        """An action that asks something has its answer when it is done."""
        await asking
        self.look()

    def on_command_line_typed(self, event: CommandLine.Typed) -> None:
        """A word of the screen, or a command of GoDonnie."""
        self._note_typed(event.text)
        found = find(event.text)
        if found is not None:
            self.do(found[0].name, found[1])
        elif not self._explain(event.text):
            self._command(event.text)

    def _explain(self, typed: str) -> bool:
        """HELP with a word of the screen: what that is for."""
        words = typed.split(maxsplit=1)
        found = find(words[1]) if len(words) == 2 and canonical(words[0]) == "HELP" else None
        if found is None or canonical(words[1]) is not None:
            return False
        self.tell(Answer(f"action-{found[0].name}"))
        return True

    def _command(self, text: str) -> None:
        if self._donnie is None:
            self._note(self.words("screen-starting"))
            return
        self.tell(self.running.command(text, self.words("typed-program")))
        self.look()

    def get_system_commands(self, screen: Screen[object]) -> Iterable[SystemCommand]:
        """The command palette: the same actions again."""
        for action in ACTIONS:
            if screen is self.workplace and not action.hidden and not action.required:
                label, purpose = self.words(f"key-{action.name}"), self.words(f"action-{action.name}")
                yield SystemCommand(label, purpose, lambda name=action.name: self.do(name))

    # --- what the actions ask of the application

    @property
    def text(self) -> str:
        return self.workplace.editor.text

    def load(self, text: str) -> None:
        self.workplace.editor.load_text(text)
        self.workplace.editor.move_cursor((0, 0))
        self.look()

    def tell(self, answer: Answer | None) -> None:
        """An answer of our own: to the log and, through the hub, to the voice."""
        if answer is None:
            return
        sentence = self.words(answer.code, **answer.values)
        if self._donnie is None:
            self._note(sentence)
        else:
            self._donnie.session.hub.publish(Answered(sentence))

    def tell_position(self) -> None:
        if self._donnie is not None:
            self._donnie.session.teller.position(self._donnie.session.pose)

    def show_pose(self) -> None:
        """After a reset: the robot stands at its start."""
        if self._donnie is not None and self._doing is Doing.READY:
            self._pose = self._donnie.session.pose
            self.workplace.map.begin(self._pose)
            self._readings.clear()

    def show_help(self) -> None:
        self.push_screen(Help(self.words("help-title"), help_text(self.words)))

    async def ask(
        self, asked: str, value: str = "", accepts: Callable[[str], str | None] | None = None
    ) -> str | None:
        question = Question(asked, self.words("ask-keys"), value=value, accepts=accepts)
        return await self.push_screen_wait(question)

    def switch_to_linear(self) -> None:
        self.left_for_linear = True
        self.leave()

    def leave(self, code: int = 0) -> None:
        if not self.left_for_linear:
            self.files.give_up()
        self.exit(code)

    async def action_quit(self) -> None:
        self.do("quit")

    # --- hearing the program

    def _paused(self, state: ControlState) -> None:
        """Told in any thread."""
        if state is ControlState.PAUSED:
            self.post_message(Paused())

    def on_began(self, event: Began) -> None:
        """What waits in the mailbox is this run's: the end of the last one took everything."""
        self._pose = event.pose
        if self.running.is_program:
            self.workplace.map.begin(event.pose)
            self._readings.clear()
        if self._watching is None:
            self._watching = self.set_interval(FLUSH, self.look)
        self.look()

    def on_ended(self, event: Ended) -> None:
        self.running.ended()
        self._take()
        self._pose = event.event.pose
        self.workplace.map.move((self._pose,))
        if self._watching is not None:
            self._watching.stop()
            self._watching = None
        self.workplace.editor.mark(None)
        self._tell_end(event)
        self._write_log()
        self.look()

    def _tell_end(self, event: Ended) -> None:
        outcome = event.event.outcome
        if event.errors and self.running.is_program:
            self.workplace.editor.go_to(event.errors[0].line, event.errors[0].column)
        if outcome is Outcome.STOPPED:
            self.tell(self.running.stopped)
        elif outcome is Outcome.COMPLETED and self.running.is_program:
            self.tell(Answer("screen-done"))
        elif outcome is Outcome.QUIT:
            self.do("quit")

    def on_paused(self) -> None:
        """It holds before a statement: say which, and put the cursor there."""
        frames = self.running.frames
        if self._doing is Doing.PAUSED and frames:
            self._take()
            line = frames[0].line
            if self.running.is_program:
                self.workplace.editor.go_to(line)
                text = self.workplace.editor.document.get_line(
                    min(line, self.workplace.editor.line_count) - 1
                )
                self.tell(Answer("screen-at-line", {"line": line, "text": text.strip()}))
            self._write_log()
        self.look()

    def on_happened(self) -> None:
        """There is mail: look now, or when it is time again."""
        due = self._taken_at + FRAME - time.monotonic()
        if due <= 0:
            self._take()
        elif self._taking is None:
            self._taking = self.set_timer(due, self._take)

    def _take(self) -> None:
        if self._taking is not None:
            self._taking.stop()
            self._taking = None
        self._taken_at = time.monotonic()
        self._receive(self._bridge.take())

    def _receive(self, mail: Mail) -> None:
        if mail.poses:
            self._pose = mail.poses[-1]
            self.workplace.map.move(mail.poses)
        self._readings.update({(each.sensor, each.argument): each for each in mail.readings})
        self._belt = mail.belt or self._belt
        self._lines.extend(mail.lines)
        if mail.missed:
            self._lines.append(LogLine(self.words("screen-left-out", count=mail.missed), "answer"))
        if self._lines and self._flushing is None:
            due = self._flushed_at + FLUSH - time.monotonic()
            self._flushing = self.set_timer(due, self._write_log) if due > 0 else None
            if due <= 0:
                self._write_log()

    def _write_log(self) -> None:
        if self._flushing is not None:
            self._flushing.stop()
            self._flushing = None
        self._flushed_at = time.monotonic()
        lines, self._lines = self._lines, []
        self.workplace.log_lines((text, self._kind_words(kind)) for text, kind in lines)
        self._show_inspector()

    def _kind_words(self, kind: str) -> str:
        """What the log calls a kind; looked up once each, a flood has few kinds."""
        if kind not in self._kinds:
            code = f"kind-{kind}"
            self._kinds[kind] = self.words(code) if code in SENTENCES else kind
        return self._kinds[kind]

    def _note(self, *sentences: str) -> None:
        self.workplace.log_lines((sentence, "") for sentence in sentences)

    def _note_typed(self, text: str) -> None:
        self._write_log()
        self.workplace.log_lines([(f"> {text}", self.words("kind-typed"))])

    # --- showing

    @property
    def _doing(self) -> Doing:
        return self.running.doing if self._donnie is not None else Doing.READY

    def look(self) -> None:
        """Bring titles, marks, status line, keys and inspector up to date."""
        if not self.is_running:
            return
        self._show_titles()
        self._show_marks()
        self._say_status()
        self._show_inspector()
        self.workplace.keys.offer([self._key_entry(name) for name in _OFFERED[self._doing]])

    def _key_entry(self, name: str) -> str:
        shown_as = "continue_" if name == "pause" and self._doing is Doing.PAUSED else name
        return f"{key_label(BY_NAME[name].keys[0])} {self.words(f'key-{shown_as}')}"

    def _show_titles(self) -> None:
        code = "pane-program-changed" if self.files.is_changed else "pane-program"
        self.workplace.program_pane.entitle(self.words(code, name=self.files.name))

    def _show_marks(self) -> None:
        frames = self.running.frames if self._doing is not Doing.READY and self.running.is_program else ()
        lines = [frame.line for frame in frames]
        self.workplace.editor.mark(lines[0] if lines else None, frozenset(lines[1:]))

    def _show_inspector(self) -> None:
        if self._donnie is None:
            return
        frames = self.running.frames
        variables = {} if self._doing is not Doing.READY else self._donnie.session.variables
        lines = inspector_lines(frames, variables, list(self._readings.values()), self._belt, self.words)
        self.workplace.inspector.show(lines)

    def on_workplace_looked(self) -> None:
        self._say_status()

    def _say_status(self) -> None:
        if self._donnie is None or self._pose is None:
            self.workplace.status.say(f" {self.words('status-starting')}")
            return
        robot = robot_sentence(self._pose, self.words, self._donnie.session.teller)
        doings = doing_sentences(self._doing, self.running.speed, self.words)
        focus = self._focus_sentence()
        self.workplace.status.say(*(f" {focus} {robot} {doing}" for doing in doings))

    def _focus_sentence(self) -> str:
        place = self.workplace
        if place.map.has_focus and place.map.grid is not None and place.map.is_exploring:
            return cell_sentence(place.map.grid, place.map.cell, self.words)
        if place.map.has_focus:
            return self.words("status-map")
        if place.log_rows.has_focus:
            return self.words("status-log", line=place.log_rows.row + 1, lines=place.log_rows.row_count)
        if place.inspector.has_focus:
            return self.words("status-inspector")
        if place.command_line.has_focus:
            return self.words("status-command")
        return self.words("status-program", line=self._program_line(), lines=place.editor.line_count)

    def _program_line(self) -> int:
        """The line being run, or the one of the cursor."""
        frames = self.running.frames if self.running.is_program else ()
        return frames[0].line if frames else self.workplace.editor.line

    # --- the text

    def on_text_area_changed(self, _event: TextArea.Changed) -> None:
        self._show_titles()
        if self._copying is None:
            self._copying = self.set_timer(COPY_AFTER, self._keep_copy)

    def _keep_copy(self) -> None:
        self._copying = None
        self.files.keep_copy()

    # --- ending

    def _handle_signals(self) -> None:
        """Somebody ends the process, or the line is lost: halt, keep the text, give the terminal back."""
        loop = asyncio.get_running_loop()
        for name in ("SIGTERM", "SIGHUP"):
            number = getattr(signal, name, None)
            if number is not None:
                with suppress(NotImplementedError, RuntimeError, ValueError):
                    loop.add_signal_handler(number, self._end_by_signal, number)
        with suppress(NotImplementedError, RuntimeError, ValueError):
            loop.add_signal_handler(signal.SIGINT, self._interrupt)

    def _end_by_signal(self, number: int) -> None:
        self._halt()
        self.files.keep_copy()
        self.exit(128 + number)

    def _interrupt(self) -> None:
        self._halt()

    def _halt(self) -> None:
        if self._donnie is not None:
            self._donnie.session.stop()

    def close_session(self) -> None:
        """After the screen is gone: nothing is left running."""
        if self._donnie is not None:
            self._donnie.close()


def _title(donnie: Donnie) -> str:
    about = donnie.world.about(donnie.words.language)
    return about.title if about is not None else donnie.world.name


def run_full_screen(settings: Settings, file: Path | None, *, text: str | None = None) -> int:
    """Work at the screen until the learner leaves; the exit code.

    ``text`` is the program that the other mode left, where it did. Raises ``SwitchMode`` if the learner goes
    to the linear mode, ``Unusable`` if the world or a device can't be used.
    """
    from donnie_tui.bootstrap import SwitchMode, assemble

    sys.setswitchinterval(0.001)
    app = DonnieApp(settings, file, text=text, assemble=lambda: assemble(settings, terminal=True))
    try:
        code = app.run(mouse=_wants_mouse())
    finally:
        app.close_session()
    if app.return_code == CRASHED:
        app.files.keep_copy()
        return CRASHED
    if app.trouble is not None:
        raise app.trouble
    if app.left_for_linear:
        path = app.files.document.path
        raise SwitchMode(app.text, str(path) if path else None)
    return code or 0


def _wants_mouse() -> bool:
    """Mouse reports cost bytes over SSH and take the terminal's own selection: DONNIE_MOUSE=0 has none."""
    return os.environ.get("DONNIE_MOUSE", "").strip().lower() not in ("0", "off", "no", "false")
