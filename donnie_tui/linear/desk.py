"""What the words of the linear mode work with: the session, the typed program, and how to answer and to ask.

Rule: an answer goes through the hub like everything else that is told, so that it is also spoken.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from pathlib import Path

from devices.ports.values import frozen
from donnie_tui.bootstrap import Donnie
from donnie_tui.core.answer_log import LONGEST_ANSWER, AnswerLog
from donnie_tui.core.breakpoints import KeptBreakpoints
from donnie_tui.core.copies import Copies
from donnie_tui.core.documents import DocumentError
from donnie_tui.core.events import TRANSIENT, Announced, Answered, Error, RunStarted, Stamped
from donnie_tui.core.reading import ProgramText
from donnie_tui.core.session import Session
from donnie_tui.core.summing_up import SummingUp
from donnie_tui.core.timeline import Timeline
from donnie_tui.core.trail import Trail
from donnie_tui.core.transcript import said_by, told_lines
from donnie_tui.core.typed_program import TypedProgram
from donnie_tui.i18n.first_words import PROMPT
from donnie_tui.linear.console import Console
from donnie_tui.linear.habits import Habits, Page, Prompt
from donnie_tui.linear.output import LARGEST_BLOCK, Output
from donnie_tui.linear.reader import How, Reader, Typed
from donnie_tui.linear.safekeeping import Safekeeping
from donnie_tui.linear.told import Told
from language.source import fold_name

CANNOT_WAIT = ("link",)
"""Codes of announcements that are told in the middle of a line that is being typed."""

GRACE = 0.025
"""Seconds that a line waits for the ones after it, so that an answer and the prompt go out together."""

_YES = ("y", "yes", "s", "sim", "si", "sí")
_NO = ("", "n", "no", "não", "nao")
_ENOUGH = ("q", "quit", "s", "sair", "salir", "n", "no", "nao")
"""What ends an answer that is told page by page."""
MOST_LINES_COPIED = 5000
"""Lines that are written down anew with each that is typed."""


@frozen
class Ends:
    """Both ends of the conversation."""

    console: Console
    editing: Reader | None
    """Edits lines key by key; None where that is impossible."""
    plain: Reader
    output: Output
    told: Told
    prompts: bool
    """Whether somebody types: prompts are printed, and questions asked."""
    is_terminal: bool
    """Whether somebody reads, and needs rests."""


class Desk:
    """One conversation."""

    def __init__(
        self,
        donnie: Donnie,
        ends: Ends,
        copies: Copies,
        habits: Habits,
        kept_breakpoints: KeptBreakpoints,
    ) -> None:
        """``copies`` keep a program which can't be kept otherwise."""
        self.say = donnie.words
        self.donnie = donnie
        self.console = ends.console
        self.program = TypedProgram()
        self.programs: dict[str, TypedProgram] = {}
        """Those of the robots that were talked to, by name; this one's is not up to date."""
        self.copies = copies
        self._copies: dict[TypedProgram, Copies] = {}
        self.kept_breakpoints = kept_breakpoints
        self.habits = habits
        self.errors: list[Error] = []
        """Those of the last run."""
        self.error_at: int | None = None
        """Which of them was told last, from 0."""
        self.answers = AnswerLog()
        self.trail = Trail(lambda: self.session.hub.robot)
        self.place = 0
        """The line of the program that was read last, 0 before any."""
        self.read_text: ProgramText | None = None
        """The program as it was read last."""
        self.searched = ""
        """What SEARCH looked for last."""
        self.watched: list[str] = []
        """Variables, as they were typed."""
        self.is_hurrying = False
        """Whether a program was just stopped: what is told then asks for nothing."""
        self.is_pausing = False
        """Whether PAUSE was said to the running program."""
        self.answers_first = False
        """Whether a word is done that was typed while a program runs: the answer waits for nothing."""
        self.is_repeating = False
        """Whether what is told now was said before, and is not remembered again."""
        self.leaving: int | None = None
        """The exit code, once we are to leave."""
        self.next_line: Callable[[str], bool] | None = None
        """Who takes the next line in place of the program; False if it does not want it."""
        self.offered = ""
        """The text that is offered for editing."""
        self.past: list[str] = []
        """The lines typed so far, this one included."""
        self.take_again: Callable[[str], None] = _nothing
        """Does a line as if it had been typed."""
        self.timeline: Timeline | None = None
        """Where STEP BACK has come to; None once something new has happened."""
        self.tour_page = 1
        """Where TOUR goes on."""
        self._safekeeping = Safekeeping(self.console, self._unsaved, self.keep_for_later)
        self._ends = ends
        self._is_reading = self._told_beside = False
        """Whether a line is being typed, and a robot that runs beside the conversation told something."""
        self.console.lines_wait = self._lines_wait
        self._shown_prompt: str | None = None
        self._typed_early: Typed | None = None
        """A line that was typed where an answer waited for Enter."""
        self._summing_up = SummingUp(donnie.words, self.console.now, self._has_pace)
        told_as_printed = donnie.audible.tell_as(self._summing_up)
        self._unsubscribe = [self.session.hub.subscribe(self._hear), told_as_printed]

    def close(self) -> None:
        """Hear no more: somebody else goes on with the session."""
        self._safekeeping.end()
        for leave in self._unsubscribe:
            leave()

    @property
    def session(self) -> Session:
        """That of the robot which is talked to."""
        return self.donnie.session

    @property
    def has_terminal(self) -> bool:
        return self._ends.editing is not None

    @property
    def can_edit(self) -> bool:
        """Whether a text can be offered for editing."""
        return self._reader.holds_newline

    @property
    def hears_live(self) -> bool:
        """Whether lines may be typed for a program that runs: by somebody who edits them here."""
        return self.is_attended and self.can_edit

    def apply_habits(self) -> None:
        """Let the terminal and the printing be as it was chosen."""
        if self.has_terminal:
            self.console.edit(self.habits.editor)
        self._ends.output.paced = self._ends.is_terminal and self.habits.page is Page.REST

    @property
    def is_attended(self) -> bool:
        """Whether there is somebody to be asked."""
        return self._ends.prompts

    @property
    def _reader(self) -> Reader:
        editing = self._ends.editing
        return editing if editing is not None and self.habits.editor else self._ends.plain

    # --- answering

    def answer(self, code: str, **values: object) -> None:
        self.tell(self.say(code, **values))

    def answer_of_robot(self, code: str, **values: object) -> None:
        """About the robot that is talked to: with its name, where there are several."""
        self.tell(said_by(self.session.hub.robot, self.say(code, **values), self.say))

    def tell_of_robot(self, *lines: str) -> None:
        """As it is for the robot that is talked to; the first line has its name, where there are several."""
        first = [said_by(self.session.hub.robot, line, self.say) for line in lines[:1]]
        self.tell(*first, *lines[1:])

    def tell(self, *lines: str) -> None:
        for line in lines:
            self.session.hub.publish(Answered(line, at_once=self.answers_first))

    def print_now(self, code: str) -> None:
        """A sentence in print alone, while a program may tell more than is printed."""
        self._ends.told.put_first([self.say(code)], is_kept=False)

    def _hear(self, stamped: Stamped) -> None:
        """Any thread's: what the event says will be printed."""
        event = stamped.event
        if not isinstance(event, TRANSIENT):
            self.timeline = None
        if stamped.robot == self.session.hub.robot:
            self._hear_own(stamped)
        self._put(stamped)
        if self._is_reading and not isinstance(event, TRANSIENT):
            self._told_beside = True
            self.console.nudge()
        if isinstance(event, Announced) and event.code in CANNOT_WAIT:
            self.console.has_news = True
            self.console.nudge()

    def _put(self, stamped: Stamped) -> None:
        """To be printed: a sum of what was not told before, and what is told; to be remembered: all."""
        lines, before = told_lines(stamped, self.say), self._summing_up.before(stamped)
        passes = self._summing_up.passes(stamped)
        if isinstance(stamped.event, Answered) and stamped.event.at_once:
            self._ends.told.put_first(lines)
            lines, passes = (), False
        self._ends.told.put((*before, *lines) if passes else before, lines, stamped.robot)

    def _lines_wait(self) -> bool:
        return self._told_beside and bool(self._ends.told)

    def _has_pace(self) -> bool:
        """Whether somebody listens to a robot that takes its time."""
        return self._ends.prompts and self._ends.is_terminal and self.session.speed is not None

    def _hear_own(self, stamped: Stamped) -> None:
        """What the robot does that is talked to."""
        self.trail.hear(stamped)
        match stamped.event:
            case RunStarted():
                self.errors, self.error_at = [], None
            case Error() as error:
                self.errors = [*self.errors[-LONGEST_ANSWER:], error]
            case _:
                pass

    def show_told(self, prompt: str = "", *, most: int | None = None) -> int:
        """Print what was told (``most`` lines of it), then the prompt.

        How many lines were left out because of Ctrl+C.
        """
        lines, kept = self._ends.told.take(most), self._ends.told.take_kept()
        if not self.is_repeating:
            self.answers.add(kept)
        self.is_repeating = False
        if not self._ends.prompts:
            return self._ends.output.show(lines)
        return self._show_pages(lines, prompt)

    def show_block(self) -> int:
        """As ``show_told``, but a block of it, so that keys are looked for in between.

        All of it where somebody is asked page by page.
        """
        return self.show_told(most=None if self._page_size() else LARGEST_BLOCK)

    def _show_pages(self, lines: list[str], prompt: str) -> int:
        """As ``show_told``; where somebody wants to be asked, page by page."""
        size = self._page_size()
        while size and len(lines) > size:
            wants_more, lines = self._show_page(lines[:size], len(lines) - size), lines[size:]
            if self.console.interrupted:
                return len(lines)
            if not wants_more:
                lines = []
            if self._typed_early is not None:
                return 0
        if self.habits.prompt is Prompt.ANSWER and prompt.endswith(PROMPT) and lines:
            prompt = self._shown_prompt = f"{lines.pop()} "
        return self._ends.output.show(lines, prompt, to_the_end=self.is_hurrying)

    def _page_size(self) -> int:
        """Lines that come before somebody is asked for more; 0 if nobody is."""
        if self.is_hurrying:
            return 0
        if self.habits.hold:
            return 1
        return self._ends.output.block_size if self.habits.page is Page.ASK else 0

    def _show_page(self, lines: list[str], left: int) -> bool:
        """Show a page and wait for Enter. Whether more is wanted; whoever types a line wants that instead."""
        question = f"{lines.pop()} " if self.habits.hold else f"{self.say('linear-more', lines=left)} "
        self._ends.output.show(lines, question)
        typed = self._reader.read(question)
        self._after(typed)
        self.console.interrupted |= typed.how is How.INTERRUPTED
        if typed.text.strip() and fold_name(typed.text) not in _ENOUGH:
            self._typed_early = typed
        return typed.how in (How.ENTER, How.ESCAPE) and not typed.text.strip()

    # --- asking

    def read(self, prompt: str, *, shown: bool = False) -> Typed:
        """Print what was told and the prompt, unless it is ``shown`` already, and read a line."""
        while True:
            typed = self._read(prompt, shown=shown)
            if typed.how not in (How.CHOICES, How.NEWS):
                return typed
            if typed.how is How.CHOICES:
                self._tell_choices(typed)
            else:
                self.console.rest(GRACE)
            self.offered = typed.text
            shown = False

    def _read(self, prompt: str, *, shown: bool) -> Typed:
        offered, self.offered = self.offered if self.can_edit else "", ""
        self._shown_prompt, self._told_beside, self._is_reading = None, False, True
        if not shown:
            self.console.has_news = False
            self._show_whole(prompt, offered)
        self.is_hurrying = False
        early, self._typed_early = self._typed_early, None
        if early is not None:
            self._is_reading = False
            return early
        self._keep_copy()
        typed = self._reader.read(prompt if self._shown_prompt is None else self._shown_prompt, offered)
        self._is_reading = False
        self._after(typed)
        return typed

    def _tell_choices(self, typed: Typed) -> None:
        """Tab found several words: how many, and each on a line; the typed line is offered again."""
        self.answer("linear-choices", count=len(typed.choices))
        self.tell(*typed.choices)
        self.is_repeating = True

    def _after(self, typed: Typed) -> None:
        """Where the terminal has not shown Enter's new line, it is held back until there is an answer."""
        if self.can_edit or typed.how is not How.ENTER:
            self.hold_newline()

    def _show_whole(self, prompt: str, offered: str) -> None:
        """Print what was told and the prompt; after Ctrl+C, how much was left out and the prompt.

        Where a program was just stopped little is left, and it is where and why: a second Ctrl+C ends no
        more than its rests.
        """
        left_out = self.show_told(prompt + offered)
        if self.is_hurrying:
            self.console.take_interrupt()
        if left_out:
            self.console.take_interrupt()
            self.answer("answer-left-out", lines=left_out)
            self.show_told(prompt + offered)

    def hold_newline(self) -> None:
        if self._ends.prompts:
            self._ends.output.hold_newline()

    def ask(self, code: str, **values: object) -> str:
        """The answer to a question; empty if there is none."""
        self.answer(code, **values)
        typed = self.read(PROMPT)
        return typed.text.strip() if typed.how in (How.ENTER, How.ESCAPE) else ""

    def ask_yes(self, code: str, **values: object) -> bool:
        """Whether the answer is yes."""
        answer = self.ask(code, **values).casefold()
        while answer not in _YES + _NO:
            answer = self.ask("linear-yes-or-no").casefold()
        return answer in _YES

    def may_lose_program(self) -> bool:
        """Whether the typed program may be replaced; asks where somebody would miss it."""
        if not (self.is_attended and self.program.is_worth_saving):
            return True
        return self.ask_yes("linear-ask-lose", lines=len(self.program.lines))

    # --- breakpoints

    def bring_breakpoints(self) -> None:
        """Those that the file just opened had the last time."""
        program = self.program
        path = Path(program.name) if program.name else None
        program.breakpoints = self.kept_breakpoints.of(path, len(program.lines))

    def keep_breakpoints(self) -> None:
        """For the next time that this program is opened."""
        program = self.program
        self.kept_breakpoints.keep(Path(program.name) if program.name else None, program.breakpoints)

    # --- leaving

    def keep_for_later(self) -> None:
        """Save what is not saved beside everything else; quietly, since nobody may be there to hear."""
        for program in self.all_programs():
            if not program.saved and program.lines:
                path = Path(program.name) if program.name else None
                with contextlib.suppress(DocumentError, OSError):
                    self.copies_of(program).keep(program.text, path)
            else:
                self.copies_of(program).forget()

    def copies_of(self, program: TypedProgram) -> Copies:
        """Each robot's program has a copy of its own."""
        if program not in self._copies:
            self._copies[program] = self.copies.another() if self._copies else self.copies
        return self._copies[program]

    def forget_copies(self) -> None:
        """Leaving on purpose: nothing is missed."""
        self._safekeeping.end()
        for copies in self._copies.values():
            copies.forget()

    def _keep_copy(self) -> None:
        """What was typed is written down: the power may fail, Donnie may be killed."""
        is_large = sum(len(each.lines) for each in self.all_programs()) > MOST_LINES_COPIED
        if self.has_terminal and not is_large:
            self._safekeeping.look()

    def _unsaved(self) -> tuple[tuple[str, str | None], ...]:
        return tuple((each.text, each.name) for each in self.all_programs() if not each.saved)

    def all_programs(self) -> tuple[TypedProgram, ...]:
        """Of all robots, the one that is talked to first."""
        others = (each for name, each in self.programs.items() if name != self.session.name)
        return (self.program, *others)


def _nothing(_: str) -> None:
    return
