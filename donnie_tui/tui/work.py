"""One learner's work at the screen: the session, and what happens between it and the workplace.

Made once the screen is there. Rules: programs run in their own thread and reach the screen through the
bridge's mailbox; nothing here waits for them.
"""

from __future__ import annotations

import asyncio
import os
from collections.abc import Awaitable, Callable, Coroutine, Sequence
from pathlib import Path
from typing import Protocol, TypeVar

from textual.events import Event
from textual.geometry import Offset
from textual.message import Message
from textual.timer import Timer
from textual.widget import Widget

from devices.ports.robot import Pose
from donnie_tui import robot_words, sound_words
from donnie_tui.bootstrap import Donnie
from donnie_tui.core.answer_log import AnswerLog
from donnie_tui.core.breakpoints import KeptBreakpoints
from donnie_tui.core.completion import Completion, completion
from donnie_tui.core.copies import Copies
from donnie_tui.core.documents import DocumentError, write_program
from donnie_tui.core.events import Answered, Error, Outcome, Pointed
from donnie_tui.core.mistakes import LARGEST, mistakes
from donnie_tui.core.retelling import told_back
from donnie_tui.core.timeline import Timeline
from donnie_tui.core.trail import Trail
from donnie_tui.core.transcript import printable, said_by
from donnie_tui.first_start import offers_tour
from donnie_tui.folders import BREAKPOINTS
from donnie_tui.i18n.manual import manual
from donnie_tui.i18n.words import Words
from donnie_tui.settings import Settings
from donnie_tui.tui.actions import find
from donnie_tui.tui.bridge import Began, Bridge, Ended, LogLine
from donnie_tui.tui.deeds import Deeds
from donnie_tui.tui.display import Display
from donnie_tui.tui.files import Files
from donnie_tui.tui.intake import CALM, FLUSH, FRAME, Intake
from donnie_tui.tui.key_echo import KeyEcho
from donnie_tui.tui.key_table import KeyTable, not_understood
from donnie_tui.tui.keys_here import keys_here
from donnie_tui.tui.preferences import AUDIBLE, Preferences
from donnie_tui.tui.recent import Recent
from donnie_tui.tui.running import Answer, Doing, Running
from donnie_tui.tui.screens.chooser import Choice
from donnie_tui.tui.screens.help import help_text
from donnie_tui.tui.screens.workplace import Workplace
from donnie_tui.tui.watch import Watch
from language.control import ControlState
from language.keywords import canonical
from language.outline import block_depth

T = TypeVar("T")

SLOW, SLOW_AGAIN = 1.0, 10.0
"""Seconds after which something that takes long is told, and then each time again."""

_LAST_WORDS = 1.0
"""Seconds that a stopped program may take to be gone."""
CHECK_AFTER = 0.4
"""Seconds without typing after which mistakes are marked."""

PAGES, MOST_LINES = 9, 6
"""Of the tour in the catalogue."""

COPY_AFTER = 1.0
"""Seconds after an edit within which it is written down."""


class Paused(Message):
    """The running program holds."""


class Host(Protocol):
    """The application, as far as the work needs it."""

    @property
    def workplace(self) -> Workplace: ...

    @property
    def key_table(self) -> KeyTable: ...

    def post_message(self, message: Message) -> bool: ...

    def later(self, seconds: float, do: Callable[[], None]) -> Timer: ...

    def every(self, seconds: float, do: Callable[[], None]) -> Timer: ...

    def ask(
        self, asked: str, keys: str, value: str, accepts: Callable[[str], str | None] | None
    ) -> Awaitable[str | None]: ...

    def choose(
        self, title: str, keys: str, nothing: str, choices: Sequence[Choice]
    ) -> Awaitable[str | None]: ...

    def press_key(
        self, asked: str, keys: str, behind: str, accepts: Callable[[str], str | None]
    ) -> Awaitable[str | None]: ...

    def choose_word(self, words: Sequence[str], below: Offset) -> Awaitable[tuple[str, str]]: ...

    def show_help(self, title: str, lines: tuple[str, ...]) -> None: ...

    def show_outside(self, text: str) -> bool: ...

    def begin_with(self, opening: Coroutine[None, None, None]) -> None: ...

    def wear(self, settings: Settings) -> None: ...

    def enter_world(self, name: str) -> None: ...

    def repaint(self) -> None: ...

    def leave(self, code: int = 0, *, for_linear: bool = False) -> None: ...


class Work:
    """Everything that the keys and words reach."""

    def __init__(self, host: Host, donnie: Donnie, folder: Path, settings: Settings | None = None) -> None:
        """``folder`` holds the copies of what is not saved."""
        self._host = host
        self._donnie = donnie
        self._state_folder = folder.parent
        self.words: Words = donnie.words
        self.workplace = host.workplace
        self.watch = Watch(self.words)
        self.running = Running(
            lambda: donnie.session, self._paused, self.watch, lambda: self.workplace.editor.breakpoints
        )
        self.preferences = Preferences(settings or Settings(), os.environ)
        self.files = Files(
            self,
            self.words,
            lambda: Copies(folder),
            Recent(folder.parent / "recent.txt"),
            KeptBreakpoints(folder.parent / BREAKPOINTS),
        )
        self.display = Display(self.workplace, donnie, self.running, self.files, host.key_table)
        bridge = Bridge(
            host.post_message, self.words, lambda: donnie.session.pose, lambda: donnie.session.name
        )
        self._intake = Intake(
            bridge,
            self.words,
            set_timer=host.later,
            receive=self.display.receive,
            write=self._write,
        )
        self._key_echo = KeyEcho(donnie.audible, self.words)
        self.answers = AnswerLog()
        self.trail = Trail(lambda: self._donnie.session.hub.robot)
        self.errors: tuple[Error, ...] = ()
        """The mistakes of the last run."""
        self._timeline: Timeline | None = None
        self._checking: Timer | None = None
        self._deeds = Deeds(self)
        self._watching: Timer | None = None
        self._reading: Timer | None = None
        self._copying: Timer | None = None
        self._hear_no_more = donnie.team.stream.subscribe(bridge)
        self._follow_no_more = donnie.team.stream.subscribe(self.trail.hear)
        self._offer_words()
        self._pace_motion()

    def begin(self, file: Path | None, text: str | None) -> None:
        """Open what was asked for. ``text``: what the other mode left, unsaved changes included."""
        self.display.note(*self._donnie.notices)
        for entry in not_understood(self.preferences.settings.keys):
            self.display.note(self.words("keys-not-understood", entry=printable(entry[:40])))
        if text is not None:
            self.files.bring(text, str(file) if file else None)
            self._host.begin_with(self.files.compare())
        elif file is not None:
            self._host.begin_with(self.files.open(str(file)))
        elif self.preferences.settings.tour and offers_tour(str(self._state_folder), os.environ):
            self.tell_sentences(self.words("tour-offer"))
        if self.files.recovering.is_offered:
            self.display.note(self.words("answer-rescued"))
        self.look()

    # --- doing

    def do(self, name: str, argument: str = "") -> Awaitable[None] | None:
        """Do an action of the table. One that asks something is to be awaited."""
        return self._deeds.do(name, argument)

    def typed(self, text: str) -> Awaitable[None] | None:
        """A line of the command line: a word of the screen, or a command of GoDonnie."""
        self._intake.write()
        self.display.write([(f"> {text}", "typed")])
        found = find(text)
        if found is not None:
            return self.do(found[0].name, found[1])
        if not self._explain(text):
            self.tell(self.running.command(text, self.words("typed-program")))
            self.look()
        return None

    def _explain(self, typed: str) -> bool:
        """HELP with a word of the screen: what that is for."""
        words = typed.split(maxsplit=1)
        found = find(words[1]) if len(words) == 2 and canonical(words[0]) == "HELP" else None
        if found is None or canonical(words[1]) is not None:
            return False
        self.tell(Answer(f"action-{found[0].name}"))
        return True

    def key_pressed(self, event: Event, focused: Widget | None) -> None:
        """Any key ends what is being said, and is said itself where somebody wants that."""
        self._donnie.audible.hush()
        self._key_echo(event, focused)
        self.display.acted()

    # --- what the actions ask for

    @property
    def text(self) -> str:
        return self.workplace.editor.text

    @property
    def breakpoints(self) -> frozenset[int]:
        return self.workplace.editor.breakpoints

    def load(self, text: str, breakpoints: frozenset[int] = frozenset()) -> None:
        """Another text in the editor, with the breakpoints that it has."""
        self.workplace.editor.load_text(text)
        self.workplace.editor.set_breakpoints(breakpoints)
        self.workplace.editor.move_cursor((0, 0))
        self.look()

    def tell(self, answer: Answer | None) -> None:
        """An answer of our own: through the hub, so that it is spoken too."""
        if answer is not None:
            sentence, hub = self.words(answer.code, **answer.values), self._donnie.session.hub
            hub.publish(Answered(said_by(hub.robot if answer.of_robot else None, sentence, self.words)))

    async def ask(
        self, asked: str, value: str = "", accepts: Callable[[str], str | None] | None = None
    ) -> str | None:
        return await self._host.ask(asked, self.words("ask-keys"), value, accepts)

    async def choose(self, title: str, choices: Sequence[Choice]) -> str | None:
        return await self._host.choose(
            title, self.words("chooser-keys"), self.words("palette-nothing"), choices
        )

    async def patiently(self, do: Callable[[], T], slow: Answer) -> T:
        """Do what may take long beside the screen; ``slow`` is told if it does, again and again."""
        telling = [
            self._host.later(SLOW, lambda: self.tell(slow)),
            self._host.every(SLOW_AGAIN, lambda: self.tell(slow)),
        ]
        try:
            return await asyncio.to_thread(do)
        finally:
            for each in telling:
                each.stop()

    async def press_key(self, asked: str, accepts: Callable[[str], str | None]) -> str | None:
        return await self._host.press_key(
            asked, self.words("keys-capture"), self.words("keys-behind"), accepts
        )

    @property
    def key_table(self) -> KeyTable:
        """Which key does what."""
        return self._host.key_table

    async def choose_word(self, words: Sequence[str], below: Offset) -> tuple[str, str]:
        return await self._host.choose_word(words, below)

    def tell_sentences(self, *sentences: str) -> None:
        """Answers that are sentences already."""
        for sentence in sentences:
            self._donnie.session.hub.publish(Answered(sentence))

    @property
    def world_name(self) -> str:
        return self._donnie.world.name

    @property
    def pose(self) -> Pose:
        return self._donnie.session.pose

    def tell_world(self) -> None:
        """What its author says of it, and what stands in it."""
        about = self._donnie.world.about(self.words.language)
        if about is not None:
            self.tell(Answer("world-title", {"name": self._donnie.world.name, "title": about.title}))
            self.tell_sentences(*about.description.replace(". ", ".\n").splitlines())
        self.do("map")
        if about is not None:
            self.tell(Answer("world-task", {"task": about.task}))

    def explored(self) -> None:
        """Another square of the map: said too, and shown in the status line."""
        pointer = self.workplace.map.pointer
        if pointer is not None and pointer.cell is not None:
            self.point(pointer.words(self.words))
        self.display.looked()

    def point(self, words: str) -> None:
        """Say what somebody looks at on the map or in a list; any key ends it, and it stands in no log."""
        self._donnie.session.hub.publish(Pointed(words))

    def line_finished(self, row: int) -> None:
        """Enter was pressed in that row (from 0): a block that it opens or closes is heard."""
        text = self.text
        if self._donnie.audible.has_cues and len(text) <= LARGEST:
            lines = text.split("\n")
            depths = (block_depth("\n".join(lines[:end])) for end in (row, row + 1))
            sound_words.chime_block(self._donnie, *depths)

    def step_back(self) -> None:
        """Show what was before: where everything was, and what is undone, in words."""
        if self.running.doing not in (Doing.READY, Doing.PAUSED):
            self.tell(Answer("screen-busy"))
            return
        timeline = self._timeline = self._timeline or self._donnie.chronicle.timeline()
        undone = timeline.step_back()
        self.display.show_past(timeline)
        self.tell_sentences(told_back(undone, timeline, self.words))

    def to_present(self) -> None:
        """Whatever is done now is done from where the robot really is."""
        if self._timeline is not None:
            self._timeline.go_to(len(self._timeline))
            self.display.show_past(self._timeline)
            self._timeline = None

    # --- the text while somebody types

    def completion(self, text: str, at: int) -> Completion:
        return completion(text, at, self.words.language, self._donnie.session.colours)

    def _offer_words(self) -> None:
        self.workplace.editor.complete = self.completion if self.preferences.settings.completion else None

    def _pace_motion(self) -> None:
        self._intake.frame = CALM if self.preferences.settings.motion == "reduced" else FRAME

    def check_now(self) -> None:
        """Mark the mistakes of the text as it is."""
        self._checking = None
        text = self.text
        found = self._donnie.session.check(text) if 0 < len(text) <= LARGEST and text.strip() else ()
        self.workplace.editor.note(mistakes(found, self.words))
        self.display.say_status()

    # --- settings, log and lists

    def prefer(self, key: str, typed: object) -> None:
        """Choose a setting from now on, and keep it."""
        value = ("on" if typed else "off") if isinstance(typed, bool) else str(typed)
        if not self.preferences.understands(key, value):
            self.tell(Answer(f"setting-{key}-wanted"))
            return
        self.preferences.choose(key, value)
        self._apply(key)
        problem = self.preferences.keep(key)
        told = next(each for each in self.preferences.all if each.key == key).told(self.words)
        self.tell(Answer("setting-row", {"name": self.words(f"setting-{key}"), "value": told}))
        if problem is not None:
            self.tell(Answer(problem.code, {"path": problem.path, "reason": problem.reason}))

    def _apply(self, key: str) -> None:
        settings = self.preferences.settings
        if key == "lang":
            self.words.language = settings.language
            self.display.relabel()
            self.check_now()
        elif key == "verbosity":
            self.words.detail = settings.verbosity
        elif key == "speed":
            self._donnie.session.speed = settings.speed
        elif key in AUDIBLE:
            self._donnie.adjust_sound(**{key: getattr(settings, key)})
        elif key == "completion":
            self._offer_words()
        elif key == "motion":
            self._pace_motion()
        self._host.wear(settings)
        self.look()

    def _write(self, lines: Sequence[LogLine]) -> None:
        """Into the log, and into what can be said again."""
        for line in lines:
            self.answers.add((line.text,))
        self.display.write(lines)

    def save_log(self, name: str) -> None:
        """All that was told, as plain text."""
        try:
            write_program(Path(name).expanduser(), self.log_text)
        except DocumentError as problem:
            self.tell(Answer(problem.code, {"path": problem.path, "reason": problem.reason}))
        except (OSError, ValueError, RuntimeError) as problem:
            self.tell(Answer("file-unwritable", {"path": name, "reason": str(problem)}))
        else:
            self.tell(Answer("answer-saved", {"name": name, "lines": len(self.workplace.log_rows.lines)}))

    @property
    def log_text(self) -> str:
        return "".join(f"{line}\n" for line in self.workplace.log_rows.lines)

    def open_log(self) -> None:
        """Outside the full screen, in the pager: there the terminal's own ways of reading work."""
        if not self._host.show_outside(self.log_text):
            self.tell(Answer("screen-no-pager"))

    def repaint(self) -> None:
        self._host.repaint()

    def show_lines(self, title: str, lines: Sequence[str]) -> None:
        self._host.show_help(self.words("lines-title", title=title), tuple(lines))

    def show_tour(self) -> None:
        """Donnie in a few pages, the same as in the linear mode."""
        pages = range(1, PAGES + 1)
        codes = [f"tour-{page}-{line}" for page in pages for line in range(1, MOST_LINES + 1)]
        self.show_lines(
            self.words("tour-title"), [self.words(each) for each in filter(self.words.knows, codes)]
        )

    def change_world(self, name: str) -> None:
        """Another world, with the same program: everything begins anew there."""
        self.tell(Answer("world-going", {"name": name}))
        self._intake.take()
        self._intake.write()
        self._forget_copy()
        self._host.enter_world(name)

    def show_manual(self) -> None:
        self._host.show_help(self.words("manual-title"), manual(self.words))

    async def connect(self, argument: str) -> None:
        """Another robot, by its number or from a list. It takes some seconds, in which the screen goes on."""
        argument = argument or await self._choose_connection() or ""
        if not argument:
            return
        await asyncio.to_thread(robot_words.connect, self._donnie, argument)
        self.show_pose()

    async def _choose_connection(self) -> str | None:
        """The number of a robot: the simulator, the boards that are plugged in, each with its state."""
        found = await asyncio.to_thread(robot_words.choices_in_words, self._donnie)
        rows = [Choice(str(number), *row) for number, row in enumerate(found, 1)]
        return await self.choose(self.words("ask-connect"), rows)

    def feel(self, argument: str) -> None:
        """The belt in words."""
        robot_words.feel(self._donnie, argument)

    @property
    def donnie(self) -> Donnie:
        """The robots and their world."""
        return self._donnie

    def robot_chosen(self) -> None:
        """Another robot is talked to: the map shows its way."""
        self.running.look_again()
        self._timeline = None
        self.display.show_world()
        self.display.begin(self._donnie.session.pose, fresh=True)
        self.display.show_past(self._donnie.chronicle.timeline())
        self.look()

    def tell_position(self) -> None:
        self._donnie.session.teller.position(self._donnie.session.pose)

    def show_pose(self) -> None:
        """After a reset: the robot stands at its start."""
        if self.running.doing is Doing.READY:
            self.display.begin(self._donnie.session.pose, fresh=True)

    def show_help(self) -> None:
        """The word at the cursor of the program first, where it is one of GoDonnie's; then everything."""
        about = self._about_word() if self.workplace.editor.has_focus else ()
        here = keys_here(self.workplace, self.words, self.key_table)
        everything = help_text(self.words, self.key_table)
        self._host.show_help(self.words("help-title"), (*about, *here, *everything))

    def show_keys_here(self) -> None:
        """What can be pressed where the focus is."""
        lines = keys_here(self.workplace, self.words, self.key_table)
        self._host.show_help(self.words("lines-title", title=lines[0].rstrip(":.")), lines[1:])

    def _about_word(self) -> tuple[str, ...]:
        word = self.workplace.editor.word
        return self.words.help(word) if word and canonical(word) is not None else ()

    def linear_typed(self) -> None:
        """LINEAR was typed into an empty program: that is not meant as its text."""
        self.load("")
        self.switch_to_linear()

    def switch_to_linear(self) -> None:
        """The other mode has the text from now on: no copy is needed."""
        self._forget_copy()
        self._host.leave(for_linear=True)

    def leave(self) -> None:
        """For good, on purpose: no copy is needed."""
        self._forget_copy()
        self._host.leave()

    def look(self) -> None:
        self.display.look()

    # --- hearing the program

    def _paused(self, state: ControlState) -> None:
        """Told in any thread."""
        if state is ControlState.PAUSED:
            self._host.post_message(Paused())

    def began(self, event: Began) -> None:
        """What waits in the mailbox is this run's: the end of the last one took everything."""
        self.to_present()
        self._expect_reading(SLOW)
        self.display.begin(event.pose, fresh=self.running.is_program)
        if self._watching is None:
            self._watching = self._host.every(FLUSH, self.look)
        self.look()

    def _expect_reading(self, seconds: float) -> None:
        self._forget_reading()
        if self.running.is_program:
            self._reading = self._host.later(seconds, self._tell_reading)

    def _forget_reading(self) -> None:
        if self._reading is not None:
            self._reading.stop()
            self._reading = None

    def _tell_reading(self) -> None:
        """A huge program is still being read and checked: nothing of it has run yet."""
        if self.running.doing is Doing.RUNNING and not self.running.frames:
            self.tell(Answer("slow-reading", {"lines": self.workplace.editor.line_count}))
            self._expect_reading(SLOW_AGAIN)

    def happened(self) -> None:
        self._intake.happened()

    def paused(self) -> None:
        """It holds before a statement: say which, and put the cursor there."""
        frames = self.running.frames
        if self.running.doing is Doing.PAUSED and frames and self.running.is_program:
            self.to_present()
            self._intake.take()
            self._tell_line(frames[0].line)
            self._intake.take()
            self._intake.write()
        self.look()

    def _tell_line(self, line: int) -> None:
        editor = self.workplace.editor
        editor.go_to(line)
        text = editor.document.get_line(min(line, editor.line_count) - 1).strip()
        self.tell(Answer("answer-line", {"line": line, "text": text}))

    def ended(self, event: Ended) -> None:
        self._forget_reading()
        self.to_present()
        self.running.ended()
        self.errors = event.errors
        self._intake.take()
        self.display.move((event.event.pose,))
        if self._watching is not None:
            self._watching.stop()
            self._watching = None
        self.watch.end(self._donnie.session, event.event.variables)
        self._tell_end(event)
        self._intake.take()
        self._intake.write()
        if event.errors and self.running.is_program:
            self.display.acted()
            self.display.looked()  # the status line is about the first mistake, not the one told last
        self.look()

    def _tell_end(self, event: Ended) -> None:
        outcome = event.event.outcome
        if event.errors and self.running.is_program:
            self.workplace.editor.go_to(event.errors[0].line, event.errors[0].column)
        if outcome is Outcome.STOPPED:
            self.tell(self.running.stopped)
        elif outcome is Outcome.COMPLETED and self.running.is_program:
            self.tell(Answer("screen-done", of_robot=True))

    # --- the text

    def edited(self) -> None:
        """The text changed: write it down soon."""
        self.display.show_titles()
        if self._checking is not None:
            self._checking.stop()
        self._checking = self._host.later(CHECK_AFTER, self.check_now)
        if self._copying is None:
            self._copying = self._host.later(COPY_AFTER, self._keep_copy)

    def _keep_copy(self) -> None:
        self._copying = None
        self.files.keep_copy()

    def _forget_copy(self) -> None:
        if self._copying is not None:
            self._copying.stop()
        self.files.copies.give_up()

    # --- ending

    def halt(self) -> None:
        self._donnie.team.stop()

    def hand_over(self) -> Donnie:
        """To the other mode: the session goes on there, what runs here ends."""
        self._hear_no_more()
        self._follow_no_more()
        self._donnie.team.stop()
        for session in self._donnie.team.sessions:
            if session.run is not None:
                session.run.wait(_LAST_WORDS)
        self.files.copies.settle()
        return self._donnie

    def close(self) -> None:
        """After the screen is gone: nothing is left running, nor to be written down."""
        self._donnie.close()
        self.files.copies.settle()
