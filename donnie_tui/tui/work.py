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
from donnie_tui.bootstrap import Donnie
from donnie_tui.core.answer_log import AnswerLog
from donnie_tui.core.breakpoints import KeptBreakpoints
from donnie_tui.core.copies import Copies
from donnie_tui.core.harmless import printable
from donnie_tui.core.patience import LAST_WORDS
from donnie_tui.core.trail import Trail
from donnie_tui.core.use_cases import help_of
from donnie_tui.core.watching import Watch
from donnie_tui.i18n.words import Words
from donnie_tui.settings.chosen import Settings
from donnie_tui.settings.first_start import offers_tour
from donnie_tui.settings.folders import BREAKPOINTS
from donnie_tui.tui.actions import BY_NAME, DONE_HERE, find
from donnie_tui.tui.application import Host
from donnie_tui.tui.bridge import Began, Bridge, Ended, LogLine, Mail
from donnie_tui.tui.brought import Brought
from donnie_tui.tui.chosen_settings import ChosenSettings
from donnie_tui.tui.deeds import Deeds
from donnie_tui.tui.display import Display
from donnie_tui.tui.files import Files
from donnie_tui.tui.following import Following
from donnie_tui.tui.intake import Intake
from donnie_tui.tui.key_echo import KeyEcho
from donnie_tui.tui.key_table import KeyTable, not_understood
from donnie_tui.tui.pages import Pages
from donnie_tui.tui.past import Past
from donnie_tui.tui.preferences import Preferences
from donnie_tui.tui.recent import Recent
from donnie_tui.tui.running import Answer, Running
from donnie_tui.tui.talk import Talk
from donnie_tui.tui.while_typing import WhileTyping
from donnie_tui.words.world_going import stop_before_going, tell_arrival
from language.control import ControlState
from language.diagnostics import Kind
from language.keywords import canonical, spelling


class Work:
    """Everything that the keys and words reach."""

    def __init__(self, host: Host, donnie: Donnie, folder: Path, settings: Settings | None = None) -> None:
        """``folder`` holds the copies of what is not saved."""
        self._host = host
        self._donnie = donnie
        self._state_folder = folder.parent
        self.words: Words = donnie.words
        self.workplace = host.workplace
        self.talk = Talk(host, donnie)
        self.watch = Watch(self.words)
        self.running = Running(
            lambda: donnie.session,
            self._paused,
            self.watch,
            lambda: self.workplace.editor.breakpoints,
            lambda: donnie.chronicle.last_seq,
        )
        self.preferences = Preferences(settings or Settings(), os.environ)
        self.files = Files(
            self,
            self.words,
            lambda: Copies(str(folder)),
            donnie.in_use,
            Recent(folder.parent / "recent.txt"),
            KeptBreakpoints(str(folder.parent / BREAKPOINTS)),
        )
        self.display = Display(self.workplace, donnie, self.running, self.files, host.key_table)
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
        self.answers = AnswerLog()
        self.trail = Trail(lambda: donnie.session.hub.robot)
        self.past = Past(self)
        self.pages = Pages(self, host)
        self.following = Following(self, host, self._intake, self.past)
        self.while_typing = WhileTyping(self, host)
        self._chosen = ChosenSettings(self, host, self._intake, self.while_typing)
        self._deeds = Deeds(self)
        hear = (bridge, self.trail.hear, self.running.hear)
        self._hear_no_more = [donnie.team.stream.subscribe(each) for each in hear]

    def begin(self, file: Path | None, text: str | None, brought: Brought | None = None) -> None:
        """Open what was asked for. ``text``: what the other mode left, unsaved changes included.

        ``brought``: what came along from another world.
        """
        notices = self._donnie.notices
        self.talk.tell_sentences(*(notices.all if brought is None else notices.about_devices))
        for entry in not_understood(self.preferences.settings.keys):
            self.talk.tell_sentences(self.words("keys-not-understood", entry=printable(entry[:40])))
        if text is not None:
            self.files.bring(text, str(file) if file else None)
            self._host.begin_with(self.files.compare())
        elif file is not None:
            self._host.begin_with(self.files.open(str(file)))
        elif self.preferences.settings.tour and offers_tour(str(self._state_folder), os.environ):
            self.talk.tell_sentences(self.words("tour-offer"))
        if brought is not None:
            self._arrive(brought)
        elif self.files.recovering.is_offered:
            self.talk.tell_sentences(self.words("answer-rescued"))
        self.look()

    def _arrive(self, brought: Brought) -> None:
        """With what was told in the world before; and that this one is there."""
        self.answers = brought.answers
        self.answers.end_answer()
        self.workplace.command_line.have_typed(brought.typed)
        self.workplace.editor.set_breakpoints(brought.breakpoints)
        self.watch.names.extend(brought.watched)
        tell_arrival(self._donnie, is_silent=brought.is_silent)

    def brought_along(self) -> Brought:
        """What goes along to another world."""
        log = self.workplace.log_rows
        return Brought(
            log.with_kinds,
            log.looks,
            self.answers,
            self.workplace.command_line.past,
            self.breakpoints,
            tuple(self.watch.names),
            self.workplace.focus_was,
            is_silent=not self._donnie.outlets.audible.is_on,
        )

    # --- doing

    def do(self, name: str, argument: str | None = None) -> Awaitable[None] | None:
        """Do an action of the table. One that asks something is to be awaited.

        ``argument`` is what was typed behind its word; None where it was a key or the palette.
        """
        self._end_answer()
        if argument is None and BY_NAME[name].needs_asking:
            return self._deeds.ask_and_do(name)
        return self._deeds.do(name, argument or "")

    def typed(self, text: str) -> Awaitable[None] | None:
        """A line of the command line: a word of the screen, or a command of GoDonnie."""
        self._end_answer()
        self.display.write([(f"> {text}", "typed")])
        found = find(text)
        if found is not None:
            return self.do(found[0].name, found[1])
        if not self._explain(text) and not self._is_slip(text) and not self._opens_block(text):
            self.talk.tell(self.running.command(text, self.words("typed-program")))
            self.look()
        return None

    def _end_answer(self) -> None:
        """What is told from now on is the answer to something else."""
        self._intake.take()
        self._intake.write()
        self.answers.end_answer()

    def _explain(self, typed: str) -> bool:
        """HELP with a word of the screen: what that is for, as in the linear mode."""
        words = typed.split(maxsplit=1)
        is_help = len(words) == 2 and canonical(words[0]) == "HELP" and canonical(words[1]) is None
        told = help_of(words[1], self.words, DONE_HERE) if is_help else ()
        self.talk.tell_sentences(*told)
        return bool(told)

    def _is_slip(self, typed: str) -> bool:
        """A slip in a word of the screen is answered with that word, as in the linear mode."""
        from donnie_tui.core.unknown_words import unknown_word

        session, lines = self._donnie.session, self.text.split("\n")
        unknown = unknown_word(typed, lines, DONE_HERE, self.words.language, session.parse)
        if unknown is not None:
            self.talk.tell(Answer("help-unknown-near", {"topic": unknown.word, "near": unknown.meant}))
        return unknown is not None

    def _opens_block(self, typed: str) -> bool:
        """Whoever types line by line, as in the linear mode, is told where there is room for that."""
        missing = self._donnie.session.parse(typed).diagnostics
        if not missing or any(each.kind is not Kind.MISSING_END for each in missing):
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
        self.following.glances.heard()
        if mail.others or mail.things is not None:
            self.ask_distances()

    def _write(self, lines: Sequence[LogLine]) -> None:
        """Into the log, and into what can be said again."""
        for line in lines:
            self.answers.add_line(line.text)
        self.display.write(lines)

    # --- what the actions ask for

    @property
    def donnie(self) -> Donnie:
        """The robots and their world."""
        return self._donnie

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
        self.workplace.editor.load_text(text)
        self.workplace.editor.set_breakpoints(breakpoints)
        self.workplace.editor.move_cursor((0, 0))
        self.look()

    def prefer(self, key: str, typed: object) -> None:
        """Choose a setting from now on, and keep it."""
        self._chosen.prefer(key, typed)

    def look(self) -> None:
        self.ask_distances()
        self.display.look()

    def ask_distances(self) -> None:
        """Have them told, where they are shown."""
        if self.display.shows_distances:
            self._donnie.session.tell_distances()

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
        self.following.began(event)

    def happened(self) -> None:
        self._intake.happened()

    def _paused(self, state: ControlState) -> None:
        """Told in any thread."""
        self.following.told(state)

    def paused(self) -> None:
        self.following.paused()

    def ended(self, event: Ended) -> None:
        self.following.ended(event)

    def edited(self) -> None:
        self.while_typing.edited()

    def line_finished(self, row: int) -> None:
        self.while_typing.line_finished(row)

    # --- ending

    def switch_to_linear(self) -> None:
        """The other mode has the text from now on: no copy of it is needed."""
        self.while_typing.hand_over_copy()
        self._host.leave(for_linear=True)

    def leave(self) -> None:
        """For good, on purpose."""
        self.while_typing.leave_copies()
        self._host.leave()

    def change_world(self, name: str) -> None:
        """Another world, with the same program: everything begins anew there."""
        self.running.note_line()
        stop_before_going(self._donnie, name)
        self._intake.take()
        self._intake.write()
        self.while_typing.give_up_copies()
        self._host.enter_world(name)

    def halt(self) -> None:
        """All robots. Any thread."""
        self.running.note_line()
        self._donnie.team.stop()

    def hand_over(self) -> Donnie:
        """To the other mode: the session goes on there, what runs here ends."""
        for hear_no_more in self._hear_no_more:
            hear_no_more()
        self._donnie.team.stop()
        for session in self._donnie.team.sessions:
            if session.run is not None:
                session.run.wait(LAST_WORDS)
        self.files.programs.settle_copies()
        return self._donnie

    def close(self) -> None:
        """After the screen is gone: nothing is left running, nor to be written down."""
        self._donnie.close()
        self.files.programs.settle_copies()
