"""One learner's work at the screen: the session, and what happens between it and the workplace.

Made once the screen is there. It brings together those who do each part, and is what the keys and words of
the screen reach; programs run in their own threads, and nothing here waits for them.
"""

from __future__ import annotations

import os
from collections.abc import Awaitable, Sequence
from pathlib import Path

from textual.events import Event
from textual.widget import Widget

from devices.ports.robot import Pose
from donnie_tui.bootstrap import Donnie, open_workspace
from donnie_tui.commands.context import Context
from donnie_tui.commands.declarations import BY_NAME, Command
from donnie_tui.commands.dispatch import attempt, perform, says_slip
from donnie_tui.commands.files import compare_with_file, open_named
from donnie_tui.commands.interaction import begin
from donnie_tui.commands.keys import KeyTable, not_understood
from donnie_tui.commands.lookup import find
from donnie_tui.commands.preferences import Preferences
from donnie_tui.commands.world import say_arrival
from donnie_tui.core.answer_log import AnswerLog
from donnie_tui.core.runner import LAST_WORDS, RunRequest
from donnie_tui.core.session import Busy
from donnie_tui.core.workspace import Workspace
from donnie_tui.i18n.words import Words
from donnie_tui.settings.folders import offers_tour
from donnie_tui.settings.settings import Settings
from donnie_tui.tui.answer import Answer
from donnie_tui.tui.application import Host
from donnie_tui.tui.bridge import Began, Bridge, Ended, LogLine, Mail
from donnie_tui.tui.brought import Brought
from donnie_tui.tui.chosen_settings import ChosenSettings
from donnie_tui.tui.display import Display
from donnie_tui.tui.intake import Intake
from donnie_tui.tui.interaction import ScreenInteraction
from donnie_tui.tui.key_echo import KeyEcho
from donnie_tui.tui.pages import Pages
from donnie_tui.tui.run_view import RunView
from donnie_tui.tui.talk import Talk
from donnie_tui.tui.while_typing import WhileTyping
from language.diagnostics import MistakeKind
from language.keywords import spelling
from language.source import printable


class Work:
    """Everything that the keys and words reach."""

    def __init__(
        self,
        host: Host,
        donnie: Donnie,
        folder: Path,
        settings: Settings | None = None,
        workspace: Workspace | None = None,
    ) -> None:
        """``folder`` is the state folder; ``workspace`` came along from another world."""
        self._host = host
        self._donnie = donnie
        self._state_folder = folder
        self.words: Words = donnie.words
        self.workplace = host.workplace
        self.talk = Talk(host, donnie)
        self.workspace = workspace or open_workspace(str(folder))
        self.workspace.report_failure = lambda error: self.talk.tell(
            Answer("answer-not-kept", {"reason": error.reason})
        )
        self.workspace.attach(self.workplace.editor)
        self.answers = AnswerLog()
        interaction = ScreenInteraction(self, host)
        past = self.workplace.command_line.past
        preferences = Preferences(settings or Settings(), os.environ)
        self.ctx = Context(
            donnie, interaction, self.workspace, self.answers, past, preferences, screen=interaction
        )
        self.display = Display(self.workplace, donnie, self.ctx.runs, self.workspace, host.key_table)
        bridge = Bridge(
            host.post_message, self.words, lambda: donnie.session.pose, lambda: donnie.session.name
        )
        self._intake = Intake(
            bridge,
            self.words,
            set_timer=host.later,
            receive=self._receive,
            write=self._write,
        )
        self._key_echo = KeyEcho(donnie.outlets.audible, self.words)
        self.pages = Pages(self, host)
        self.run_view = RunView(self, host, self._intake)
        self.while_typing = WhileTyping(self, host)
        self._chosen = ChosenSettings(self, host, self._intake, self.while_typing)
        self._unsubscribe = donnie.team.stream.subscribe(bridge)

    def begin(self, file: Path | None, text: str | None, brought: Brought | None = None) -> None:
        """Open what was asked for. ``text``: what the other mode left, unsaved changes included.

        ``brought``: what came along from another world.
        """
        notices = self._donnie.notices
        self.talk.tell_sentences(*(notices.all if brought is None else notices.about_devices))
        for entry in not_understood(self.ctx.preferences.settings.keys):
            self.talk.tell_sentences(self.words("keys-not-understood", entry=printable(entry[:40])))
        if text is not None:
            self.workspace.replace(text, file, in_file="")
            self._host.begin_with(attempt(self.ctx, compare_with_file(self.ctx)))
        elif file is not None:
            self._host.begin_with(attempt(self.ctx, open_named(self.ctx, str(file))))
        elif self.ctx.preferences.settings.tour and offers_tour(str(self._state_folder), os.environ):
            self.talk.tell_sentences(self.words("tour-offer"))
        if brought is not None:
            self._arrive(brought)
        elif self.workspace.rescued():
            self.talk.tell_sentences(self.words("answer-rescued"))
        self.look()

    def _arrive(self, brought: Brought) -> None:
        """With what was told in the world before; and that this one is there."""
        self.answers = self.ctx.answers = brought.answers
        self.answers.end_answer()
        self.workplace.command_line.have_typed(brought.typed)
        self.ctx.past = brought.typed
        self.ctx.runs.watched.extend(brought.watched)
        say_arrival(self._donnie, is_silent=brought.is_silent)

    def brought_along(self) -> Brought:
        """What goes along to another world."""
        log = self.workplace.log_rows
        return Brought(
            log.with_kinds,
            log.looks,
            self.answers,
            self.workplace.command_line.past,
            self.workspace,
            tuple(self.ctx.runs.watched),
            self.workplace.focus_was,
            is_silent=not self._donnie.outlets.audible.is_on,
        )

    # --- doing

    def do(self, name: str, argument: str | None = None) -> Awaitable[None] | None:
        """Run a command. What is left of it after its first question is to be awaited.

        ``argument`` is None where a key or the palette asked for it.
        """
        self._end_answer()
        return begin(self._perform(BY_NAME[name], argument))

    async def _perform(self, command: Command, argument: str | None) -> None:
        await perform(self.ctx, command, argument)
        self.run_view.show_past()
        self.look()

    def typed(self, text: str) -> Awaitable[None] | None:
        """A line of the command line: a word of the screen, or a command of GoDonnie."""
        self._end_answer()
        self.display.write([(f"> {text}", "typed")])
        found = find(text)
        if found is not None:
            return self.do(found[0].name, found[1])
        if not says_slip(self.ctx, text) and not self._opens_block(text):
            self._run_typed(text)
            self.look()
        return None

    def _run_typed(self, text: str) -> None:
        """Run a line of GoDonnie where the robot is, with the variables that there are."""
        try:
            self.ctx.runs.start(RunRequest(text, self.words("typed-program"), is_whole=False))
        except Busy:
            self.ctx.answer_of_robot("screen-busy")

    def _end_answer(self) -> None:
        """What is told from now on is the answer to something else."""
        self._intake.take()
        self._intake.write()
        self.answers.end_answer()

    def _opens_block(self, typed: str) -> bool:
        """Whoever types line by line, as in the linear mode, is told where there is room for that."""
        missing = self._donnie.session.parse(typed).diagnostics
        if not missing or any(each.kind is not MistakeKind.MISSING_END for each in missing):
            return False
        closer = spelling(missing[0].expected[0], self.words.language)
        self.talk.tell(Answer("screen-open-block", {"closer": closer}))
        return True

    def key_pressed(self, event: Event, focused: Widget | None) -> None:
        """Any key ends what is being said, and is said itself where somebody wants that."""
        self._donnie.outlets.audible.hush()
        self._key_echo(event, focused)
        self.display.acted()

    def _receive(self, mail: Mail) -> None:
        """What the robot senses has changed, too, where others or things are elsewhere now."""
        self.display.receive(mail)
        self.run_view.polling.on_event()
        if mail.others or mail.things is not None:
            self.ask_distances()

    def _write(self, lines: Sequence[LogLine]) -> None:
        """Into the log, and into what can be said again."""
        for line in lines:
            if not line.is_repeated:
                self.answers.add_line(line.text)
        self.display.write((line.text, line.kind) for line in lines)

    # --- what the actions ask for

    @property
    def donnie(self) -> Donnie:
        """The robots and their world."""
        return self._donnie

    @property
    def program_name(self) -> str:
        """The name of its file, where it has one."""
        path = self.workspace.document.path
        return path.name if path else self.words("new-program")

    @property
    def pose(self) -> Pose:
        return self._donnie.session.pose

    @property
    def key_table(self) -> KeyTable:
        """Which key does what."""
        return self._host.key_table

    @property
    def text(self) -> str:
        return self.workplace.editor.text

    @property
    def breakpoints(self) -> frozenset[int]:
        return self.workplace.editor.breakpoints

    def load(self, text: str, breakpoints: frozenset[int] = frozenset()) -> None:
        """Another text in the editor, with the breakpoints that it has."""
        self.workplace.editor.show(text, breakpoints)
        self.look()

    def apply_setting(self, key: str) -> None:
        """Show the session as the setting says from now on."""
        self._chosen.apply(key)

    def look(self) -> None:
        self.ask_distances()
        self.display.look()

    def ask_distances(self) -> None:
        """Have them told, where they are shown."""
        if self.display.shows_distances:
            self._donnie.session.publish_distances()

    def repaint(self) -> None:
        self._host.repaint()

    # --- what the application hears

    def explored(self) -> None:
        """Another square of the map: said too, and shown in the status line."""
        pointer = self.workplace.map.pointer
        if pointer is not None and pointer.cell is not None:
            self.talk.point(pointer.words(self.words))
        self.display.looked()

    def entered(self) -> None:
        """The focus came to another part: said too, and shown in the status line."""
        self.talk.point(self.display.focus_sentence)

    def began(self, event: Began) -> None:
        self.run_view.on_began(event)

    def happened(self) -> None:
        self._intake.happened()

    def held(self) -> None:
        self.run_view.on_held()

    def ended(self, event: Ended) -> None:
        self.run_view.on_ended(event)

    def edited(self) -> None:
        self.while_typing.edited()

    def line_finished(self, row: int) -> None:
        self.while_typing.line_finished(row)

    # --- ending

    def switch_to_linear(self) -> None:
        """The other mode has the text from now on: no copy of it is needed."""
        self.while_typing.stop_copying()
        self.workspace.hand_over()
        self._host.leave(for_linear=True)

    def leave(self) -> None:
        """For good, on purpose."""
        self.while_typing.stop_copying()
        self.workspace.leave_copies()
        self._host.leave()

    def change_world(self, name: str) -> None:
        """Another world, with the same program: everything begins anew there."""
        self.ctx.runs.stop_to_leave()
        self.ctx.answer("world-going", name=name)
        self._intake.take()
        self._intake.write()
        self.while_typing.stop_copying()
        self._host.enter_world(name)

    def halt(self) -> None:
        """All robots. Any thread."""
        self.ctx.runs.note_stop()
        self._donnie.team.stop()

    def hand_over(self) -> Donnie:
        """To the other mode: the session goes on there, what runs here ends."""
        self.ctx.close()
        self._unsubscribe()
        self._donnie.team.stop()
        for session in self._donnie.team.sessions:
            if session.run is not None:
                session.run.wait(LAST_WORDS)
        self.workspace.write_copies()
        return self._donnie

    def close(self) -> None:
        """After the screen is gone: nothing is left running, nor to be written down."""
        self._donnie.close()
        self.workspace.detach()
        self.workspace.write_copies()
