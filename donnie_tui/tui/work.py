"""One learner's work at the screen: the session, and what happens between it and the workplace.

Made once the screen is there. Rules: programs run in their own thread and reach the screen through the
bridge's mailbox; nothing here waits for them.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Protocol

from textual.message import Message
from textual.timer import Timer

from donnie_tui import robot_words
from donnie_tui.bootstrap import Donnie
from donnie_tui.core.events import Answered, Outcome
from donnie_tui.core.filing import Copies
from donnie_tui.i18n.words import Words
from donnie_tui.tui.actions import find
from donnie_tui.tui.bridge import Began, Bridge, Ended
from donnie_tui.tui.deeds import Deeds
from donnie_tui.tui.display import Display
from donnie_tui.tui.files import Files
from donnie_tui.tui.intake import FLUSH, Intake
from donnie_tui.tui.running import Answer, Doing, Running
from donnie_tui.tui.screens.help import help_text
from donnie_tui.tui.screens.workplace import Workplace
from language.control import ControlState
from language.keywords import canonical

_LAST_WORDS = 1.0
"""Seconds that a stopped program may take to be gone."""
COPY_AFTER = 1.0
"""Seconds after an edit within which it is written down."""


class Paused(Message):
    """The running program holds."""


class Host(Protocol):
    """The application, as far as the work needs it."""

    @property
    def workplace(self) -> Workplace: ...

    def post_message(self, message: Message) -> bool: ...

    def later(self, seconds: float, do: Callable[[], None]) -> Timer: ...

    def every(self, seconds: float, do: Callable[[], None]) -> Timer: ...

    def ask(
        self, asked: str, keys: str, value: str, accepts: Callable[[str], str | None] | None
    ) -> Awaitable[str | None]: ...

    def show_help(self, title: str, lines: tuple[str, ...]) -> None: ...

    def leave(self, code: int = 0, *, for_linear: bool = False) -> None: ...


class Work:
    """Everything that the keys and words reach."""

    def __init__(self, host: Host, donnie: Donnie, folder: Path) -> None:
        """``folder`` holds the copies of what is not saved."""
        self._host = host
        self._donnie = donnie
        self.words: Words = donnie.words
        self.workplace = host.workplace
        self.running = Running(donnie.session, self._paused)
        self.files = Files(self, self.words, Copies(folder))
        self.display = Display(self.workplace, donnie, self.running, self.files)
        session = donnie.session
        bridge = Bridge(host.post_message, self.words, lambda: session.pose)
        self._intake = Intake(
            bridge,
            self.words,
            set_timer=host.later,
            receive=self.display.receive,
            write=self.display.write,
        )
        self._deeds = Deeds(self)
        self._watching: Timer | None = None
        self._copying: Timer | None = None
        self._hear_no_more = session.hub.subscribe(bridge)

    def begin(self, file: Path | None, text: str | None) -> None:
        """Open what was asked for. ``text``: what the other mode left, unsaved changes included."""
        self.display.note(*self._donnie.notices)
        if text is not None:
            self.files.bring(text, str(file) if file else None)
        elif file is not None:
            self.files.open_now(str(file))
        if self.files.offers_recovery:
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

    # --- what the actions ask for

    @property
    def text(self) -> str:
        return self.workplace.editor.text

    def load(self, text: str) -> None:
        self.workplace.editor.load_text(text)
        self.workplace.editor.move_cursor((0, 0))
        self.look()

    def tell(self, answer: Answer | None) -> None:
        """An answer of our own: through the hub, so that it is spoken too."""
        if answer is not None:
            sentence = self.words(answer.code, **answer.values)
            self._donnie.session.hub.publish(Answered(sentence))

    async def ask(
        self, asked: str, value: str = "", accepts: Callable[[str], str | None] | None = None
    ) -> str | None:
        return await self._host.ask(asked, self.words("ask-keys"), value, accepts)

    async def connect(self, argument: str) -> None:
        """Another robot. It takes some seconds, in which the screen goes on."""
        await asyncio.to_thread(robot_words.connect, self._donnie, argument)
        self.show_pose()

    def feel(self, argument: str) -> None:
        """The belt in words."""
        robot_words.feel(self._donnie, argument)

    def tell_position(self) -> None:
        self._donnie.session.teller.position(self._donnie.session.pose)

    def show_pose(self) -> None:
        """After a reset: the robot stands at its start."""
        if self.running.doing is Doing.READY:
            self.display.begin(self._donnie.session.pose, fresh=True)

    def show_help(self) -> None:
        self._host.show_help(self.words("help-title"), help_text(self.words))

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
        self.display.begin(event.pose, fresh=self.running.is_program)
        if self._watching is None:
            self._watching = self._host.every(FLUSH, self.look)
        self.look()

    def happened(self) -> None:
        self._intake.happened()

    def paused(self) -> None:
        """It holds before a statement: say which, and put the cursor there."""
        frames = self.running.frames
        if self.running.doing is Doing.PAUSED and frames and self.running.is_program:
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
        self.running.ended()
        self._intake.take()
        self.display.move((event.event.pose,))
        if self._watching is not None:
            self._watching.stop()
            self._watching = None
        self._tell_end(event)
        self._intake.take()
        self._intake.write()
        self.look()

    def _tell_end(self, event: Ended) -> None:
        outcome = event.event.outcome
        if event.errors and self.running.is_program:
            self.workplace.editor.go_to(event.errors[0].line, event.errors[0].column)
        if outcome is Outcome.STOPPED:
            self.tell(self.running.stopped)
        elif outcome is Outcome.COMPLETED and self.running.is_program:
            self.tell(Answer("screen-done"))

    # --- the text

    def edited(self) -> None:
        """The text changed: write it down soon."""
        self.display.show_titles()
        if self._copying is None:
            self._copying = self._host.later(COPY_AFTER, self._keep_copy)

    def _keep_copy(self) -> None:
        self._copying = None
        self.files.keep_copy()

    def _forget_copy(self) -> None:
        if self._copying is not None:
            self._copying.stop()
        self.files.give_up()

    # --- ending

    def halt(self) -> None:
        self._donnie.session.stop()

    def hand_over(self) -> Donnie:
        """To the other mode: the session goes on there, what runs here ends."""
        self._hear_no_more()
        self._donnie.team.stop()
        for session in self._donnie.team.sessions:
            if session.run is not None:
                session.run.wait(_LAST_WORDS)
        return self._donnie

    def close(self) -> None:
        """After the screen is gone: nothing is left running."""
        self._donnie.close()
