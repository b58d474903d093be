"""The linear mode: lines are typed, run and answered; nothing that stands printed is ever changed.

Rules: leaving is always possible; whatever ends the session, the robot stops, the terminal is as it was
found, and no typed program is lost.
"""

from __future__ import annotations

import contextlib
import os
import signal
from pathlib import Path

from donnie_tui import team_words
from donnie_tui.bootstrap import Donnie, Unusable, assemble
from donnie_tui.core.breakpoints import KeptBreakpoints
from donnie_tui.core.copies import Copies
from donnie_tui.core.typed_program import ProgramTooLong
from donnie_tui.core.use_cases import When
from donnie_tui.device_settings import SIMULATED
from donnie_tui.folders import BREAKPOINTS, state_folder
from donnie_tui.i18n.words import Words
from donnie_tui.linear import commands, files, greeting
from donnie_tui.linear.console import Console
from donnie_tui.linear.desk import Desk, Ends
from donnie_tui.linear.habits import Habits, of_settings
from donnie_tui.linear.holding import Goes, Wish
from donnie_tui.linear.key_echo import KeyEcho
from donnie_tui.linear.output import Output
from donnie_tui.linear.patience import SLOW, SLOW_AGAIN, aside
from donnie_tui.linear.reader import EditingReader, How, PlainReader, Typed
from donnie_tui.linear.recall import Past
from donnie_tui.linear.runs import Runs
from donnie_tui.linear.terminal import Terminal
from donnie_tui.linear.told import Told
from donnie_tui.robot_search import Search
from donnie_tui.settings import Settings
from donnie_tui.switching import SwitchMode
from language import keywords

INTERRUPTED = 130

_GOES = {"step": Goes.STEP, "step_over": Goes.OVER, "continue_": Goes.ON, "stop": Goes.STOP}
"""How a held program goes on by a word."""
_LIVE = ("stop", "stop_all", "robots", "pause", "slower", "faster", "speed", "quiet")
"""What is done at once while a program runs."""
_URGENT = ("stop", "stop_all", "pause", "quiet")
"""Also before lines that wait to be read."""


def run_linear(
    settings: Settings,
    file: Path | None,
    cause: str,
    *,
    text: str | None = None,
    donnie: Donnie | None = None,
) -> int:
    """Talk until the learner leaves; the exit code. ``cause``: see ``i18n.first_words``.

    ``text`` is the program that the other mode left, where it did, ``file`` is then only its name, and
    ``donnie`` the session that it left. Raises ``SwitchMode``, with the session, for the full screen, and
    ``Unusable`` for a world that can't be used.
    """
    habits = of_settings(settings)
    is_there = donnie is not None or settings.robot == SIMULATED
    begins_bare = file is None and not text and is_there and donnie is None
    greeting.greet(
        donnie.words.language if donnie else settings.language,
        cause,
        os.environ,
        prompt=habits.prompt_at(0) if begins_bare else None,
        tour=settings.tour,
    )
    terminal = greeting.DONE.terminal
    console = Console(terminal if isinstance(terminal, Terminal) else None)
    with contextlib.ExitStack() as closing:
        closing.callback(greeting.forget)
        closing.callback(console.close)
        ours = contextlib.ExitStack()
        closing.push(ours)
        if donnie:
            donnie.audible.move_to(is_linear=True)
        if donnie is None:
            search = Search(is_coming=not is_there)
            console.give_up = search.give_up
            words = Words(settings.language, settings.verbosity)
            search.on_slow = lambda: console.write(f"{words('connect-waiting')}\n")
            if not is_there:
                console.write(f"{words('connect-trying')}\n")
            donnie = _awaited(console, settings, search, is_there=is_there)
        console.give_up = donnie.connection.search.give_up
        ours.callback(donnie.close)
        mode = LinearMode(donnie, console, Path(state_folder(os.environ)), habits)
        closing.callback(mode.close)
        try:
            return mode.talk(file, text, offers_to_remember=cause == "word" and settings.linear is not True)
        except SwitchMode:
            ours.pop_all()
            raise


def _awaited(console: Console, settings: Settings, search: Search, *, is_there: bool) -> Donnie:
    """A robot that is looked for and a learner's own world take as long as they take; that is said."""
    import worlds

    if is_there and settings.world in worlds.names():
        return _assembled(settings, search)
    words, name = Words(settings.language, settings.verbosity), Path(settings.world).name
    sentence = words("slow-world", name=name) if is_there else words("slow-connect")

    def tell() -> None:
        greeting.end_prompt()
        console.write(f"{sentence}\n")

    return aside(console, lambda: _assembled(settings, search), tell, first=SLOW if is_there else SLOW_AGAIN)


def _assembled(settings: Settings, search: Search) -> Donnie:
    try:
        return assemble(settings, terminal=True, search=search)
    except Unusable:
        greeting.withdraw()
        raise


class LinearMode:
    """One conversation, from the first prompt to the goodbye."""

    def __init__(self, donnie: Donnie, console: Console, folder: Path, habits: Habits) -> None:
        """``folder`` keeps what was typed before and what could not be saved."""
        told = Told(console.nudge)
        edits, attended = greeting.DONE.terminal is not None, os.isatty(0)
        self._past = Past(folder / "history" if edits else None)
        self._editing = EditingReader(console, self._past, self._candidates) if edits else None
        output = Output(
            console,
            paced=os.isatty(1),
            of_numbers=lambda count: donnie.words("linear-numbers", count=count),
        )
        kept_breakpoints = KeptBreakpoints(folder / BREAKPOINTS)
        ends = Ends(console, self._editing, PlainReader(console), output, told, attended, os.isatty(1))
        self._desk = Desk(donnie, ends, Copies(folder / "unsaved"), habits, kept_breakpoints)
        self._desk.past = self._past.lines
        self._desk.take_again = self._take_again
        self._runs = Runs(self._desk, told, self._wish_of, self._live)
        self._console = console
        console.before_suspending = donnie.stop_real_robot
        if attended:
            console.on_key = donnie.audible.hush
        if self._editing:
            self._editing.on_key = KeyEcho(donnie.audible, donnie.words)
        self._quit_was_refused = False
        self._desk.apply_habits()

    def close(self) -> None:
        """Hear no more of the session."""
        self._runs.close()
        self._desk.close()

    # --- the conversation

    def talk(self, file: Path | None, text: str | None = None, *, offers_to_remember: bool = False) -> int:
        """Read and answer until something ends it. The exit code.

        ``offers_to_remember``: somebody came here by a word and may want to begin here the next time.
        """
        try:
            return self._talk(file, text, offers_to_remember)
        except SwitchMode:
            self._desk.forget_copies()
            raise
        except OSError:  # the terminal is gone, or nobody reads any more
            self._desk.keep_for_later()
            return 128 + (self._console.leaving or signal.SIGHUP)
        except BaseException:
            self._desk.keep_for_later()
            raise
        finally:
            self._past.trim()

    def _talk(self, file: Path | None, text: str | None, offers_to_remember: bool) -> int:
        desk = self._desk
        is_shown = greeting.DONE.has_prompt
        greeting.DONE.has_prompt = False
        if text is not None:
            self._take_over(text, file)
        elif file is not None:
            files.open_file(desk, file)
        self._tell_notices()
        if offers_to_remember:
            from donnie_tui.linear import modes

            modes.offer_to_remember(desk, linear=True)
        while desk.leaving is None:
            self._take(desk.read(self._prompt(), shown=is_shown))
            is_shown = False
        self._say_goodbye()
        return desk.leaving

    def _take_over(self, text: str, file: Path | None) -> None:
        """The program that the full screen left; it is saved if its file says the same."""
        program = self._desk.program
        program.replace(text, str(file) if file else None)
        program.saved = files.holds(file, text) if file else not text.strip()
        self._desk.bring_breakpoints()
        if program.lines:
            self._desk.answer("linear-lines", lines=len(program.lines))

    def _tell_notices(self) -> None:
        """What had to be done without. Where the prompt stands already, it comes with the first answer.

        What is about the robot and the belt comes at once: whoever types must know which robot will move.
        """
        desk = self._desk
        desk.tell(*desk.donnie.notices)
        self._console.has_news = bool(desk.donnie.about_devices)
        if desk.is_attended and desk.copies.offered():
            desk.answer("answer-rescued")

    def _prompt(self) -> str:
        in_program = self._desk.is_attended and not self._desk.next_line
        depth = self._desk.program.depth if in_program else 0
        return self._desk.habits.prompt_at(depth)

    def _candidates(self, before: str) -> tuple[str, ...]:
        """For Tab. Loaded when somebody presses it."""
        from donnie_tui.linear.completion import candidates

        return candidates(self._desk, before)

    # --- one line

    def _take(self, typed: Typed) -> None:
        if self._desk.leaving is None and self._console.leaving is not None:
            self._leave_by_signal(self._console.leaving)
            return
        match typed.how:
            case How.CLOSED:
                self._close()
            case How.INTERRUPTED:
                self._clear(typed.text)
            case How.TOO_LONG:
                self._desk.answer("linear-too-long")
            case How.ENTER:
                self._past.remember(typed.text)
                self._take_line(typed.text)
            case How.ESCAPE:
                self._past.remember(typed.text)
                self._take_line_and_run(typed.text)

    def _take_line_and_run(self, line: str) -> None:
        """ESC: what stands there is finished, and everything runs."""
        if line.strip() and self._take_line(line):
            self._runs.run_waiting()
        elif not line.strip():
            self._run()

    def _take_line(self, line: str) -> bool:
        """Do a word, or add the line to the program. Whether it was added and nothing more."""
        then, self._desk.next_line = self._desk.next_line, None
        words = line.split()
        first = keywords.canonical(words[0]) if words else None
        if then and then(line):
            pass
        elif not words:
            self._run_unless_open()
        elif first == "RUN" and len(words) == 1:
            self._run()
        elif first in ("QUIT", "EXIT") and len(words) == 1:
            self._quit(line)
        elif first == "HELP":
            commands.say_help(self._desk, " ".join(words[1:]))
        elif commands.answer_of_screen(line, self._desk):
            pass
        elif found := commands.find(line):
            commands.do(*found, self._desk, self._runs)
        elif not commands.is_probably_ours(line, self._desk):
            return self._add(line)
        return False

    def _add(self, line: str) -> bool:
        self._quit_was_refused = False
        hears_blocks = self._desk.is_attended and self._desk.donnie.audible.has_cues
        before = self._desk.program.depth if hears_blocks else 0
        try:
            self._desk.program.add(line)
        except ProgramTooLong:
            self._desk.answer("linear-too-long")
            return False
        if hears_blocks:
            from donnie_tui import sound_words

            sound_words.chime_block(self._desk.donnie, before, self._desk.program.depth)
        if self._desk.habits.enter and not self._desk.program.open_block:
            self._run()
        return True

    def _take_again(self, line: str) -> None:
        """A line that was typed before, chosen by its number."""
        self._past.remember(line)
        self._take_line(line)

    # --- running

    def _run(self) -> None:
        self._runs.run_waiting()

    def _run_unless_open(self) -> None:
        """An empty line runs what waits, but not half a block."""
        program = self._desk.program
        block = program.open_block
        if block:
            self._desk.answer("linear-still-open", opener=self._spelled(block.kind), line=block.line)
        elif program.is_waiting:
            self._run()

    def _wish_of(self, typed: Typed) -> Wish | None:
        """What a line means to a program that is held between two steps."""
        line = typed.text.strip()
        found = commands.find(line)
        canonical = keywords.canonical(line)
        if typed.how in (How.INTERRUPTED, How.CLOSED) or canonical in ("QUIT", "EXIT"):
            return Wish(Goes.STOP)
        if typed.how is How.TOO_LONG:
            self._desk.answer("linear-too-long")
            return None
        if typed.how is How.ESCAPE or canonical == "RUN":
            return Wish(Goes.ON)
        if not line:
            return Wish(Goes.STEP)
        if found is None:
            self._refuse_while_held(line)
            return None
        case, rest = found
        if case.name in _GOES and not rest:
            return Wish(_GOES[case.name])
        if case.name == "run_to" and rest.isdecimal() and len(rest) < 9:
            return Wish(Goes.UNTIL, int(rest))
        if case.when is When.IDLE:
            self._refuse_while_held(line)
            return None
        commands.do(case, rest, self._desk, self._runs)
        return None

    def _refuse_while_held(self, line: str) -> None:
        words = line.split()
        if keywords.canonical(words[0]) == "HELP":
            commands.say_help(self._desk, " ".join(words[1:]))
        elif not commands.is_probably_ours(line, self._desk):
            self._desk.answer("linear-stepping")

    def _live(self) -> bool:
        """Do a line that was typed for the running program, if there is one. Whether it was."""
        if self._editing is None or not self._desk.hears_live:
            return False
        line = self._editing.take_ahead(
            lambda typed, is_first: _is_one_of(_LIVE if is_first else _URGENT, typed)
        )
        found = commands.find(line) if line else None
        if line is None or found is None:
            return False
        self._past.remember(line)
        self._desk.answers_first = True
        try:
            commands.do(*found, self._desk, self._runs)
        finally:
            self._desk.answers_first = False
        return True

    # --- leaving

    def _quit(self, line: str) -> None:
        """QUIT runs what waits, then leaves; where that can't be run, a second one leaves all the same."""
        desk, block = self._desk, self._desk.program.open_block
        if self._quit_was_refused:
            self._leave(0)
        elif block is None:
            self._run_and_quit(line)
        elif self._add(line):
            desk.answer("linear-quit-in-block", opener=self._spelled(block.kind))

    def _run_and_quit(self, line: str) -> None:
        desk = self._desk
        self._runs.run_waiting(last=line)
        if desk.leaving is not None:
            self._leave(desk.leaving)
        self._quit_was_refused = desk.program.is_waiting

    def _spelled(self, canonical: str) -> str:
        return keywords.spelling(canonical, self._desk.say.language)

    def _close(self) -> None:
        """Ctrl+D, or the end of the input."""
        desk = self._desk
        waiting = desk.program.waiting if desk.program.is_waiting else 0
        if waiting and not desk.is_attended:
            desk.answer("linear-did-not-run", lines=waiting)
        self._leave(0)

    def _leave(self, code: int) -> None:
        """Leave, once a program that would be missed is saved or given up."""
        desk = self._desk
        desk.leaving = code
        for program in desk.all_programs():
            would_be_missed = desk.is_attended and program.is_worth_saving
            if would_be_missed and desk.ask_yes("linear-ask-save", lines=len(program.lines)):
                desk.program = program
                files.save_named(desk, "")

    def _leave_by_signal(self, number: int) -> None:
        self._desk.donnie.team.stop()
        self._desk.keep_for_later()
        self._desk.leaving = 128 + number

    def _clear(self, line: str) -> None:
        """Ctrl+C where nothing runs: it clears the line. A script is ended by it."""
        desk = self._desk
        desk.next_line = None
        if desk.donnie.team.running:
            team_words.stop_all(desk.donnie)
        elif not desk.is_attended:
            desk.leaving = INTERRUPTED
        elif line:
            desk.answer("linear-cleared")
        else:
            desk.answer("linear-nothing-to-stop")

    def _say_goodbye(self) -> None:
        if self._desk.leaving == 0:
            self._desk.answer("linear-goodbye")
        self._desk.show_told()
        if self._desk.leaving == 0:
            self._desk.forget_copies()


def _is_one_of(words: tuple[str, ...], line: str) -> bool:
    found = commands.find(line)
    return found is not None and found[0].name in words
