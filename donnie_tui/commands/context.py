"""What a command may use: the robots and their world, the words, the program, the answers so far."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from contextlib import suppress
from datetime import datetime
from functools import cached_property
from typing import TYPE_CHECKING

from msgspec.structs import replace

from donnie_tui.bootstrap import Donnie, Judge, progress
from donnie_tui.commands.declarations import BY_NAME
from donnie_tui.commands.interaction import Interaction, Screen
from donnie_tui.commands.lookup import word_of
from donnie_tui.commands.preferences import Preferences
from donnie_tui.core.events import (
    TRANSIENT,
    Answered,
    Chimed,
    CueSounded,
    GripperUsed,
    Moved,
    Reset,
    RunStarted,
    Spoke,
    Stamped,
    ThingsMoved,
    Turned,
    begins_anew,
)
from donnie_tui.core.program_files import Attempted
from donnie_tui.core.run_controller import RunController
from donnie_tui.core.run_state import RunErrors
from donnie_tui.core.session_log import AnswerLog
from donnie_tui.core.timeline import Trail
from donnie_tui.core.transcript import lines_with_robot_name, with_robot_name
from donnie_tui.core.wording import shown_name
from donnie_tui.i18n.words import Unusable
from donnie_tui.world.loading import CHALLENGE, solution_of

if TYPE_CHECKING:
    from donnie_tui.core.document import Document
    from donnie_tui.core.goals import Judgment
    from donnie_tui.core.map_grid import MapGrid
    from donnie_tui.core.questions import Asked
    from donnie_tui.core.session_log import LineHistory
    from donnie_tui.core.workspace import Workspace
    from worlds.challenges import Unsensed

MOST_AT_ONCE = 18
"""A longer list begins with the number of its lines."""

FAILED, UNUSABLE = 1, 2
"""Exit codes of a script: it had a mistake; it names a file that can't be used."""


class Context:
    """One learner at one front end, from the beginning of a session to its end."""

    def __init__(
        self,
        donnie: Donnie,
        interaction: Interaction,
        workspace: Workspace,
        answers: AnswerLog,
        past: LineHistory,
        preferences: Preferences,
        screen: Screen | None = None,
    ) -> None:
        """``answers`` holds earlier answers, ``past`` the lines that were typed."""
        self.donnie = donnie
        self.words = donnie.words
        self.interaction = interaction
        self.workspace = workspace
        self.answers = answers
        self.past = past
        self.preferences = preferences
        self.screen = screen
        self.tour_page = 1
        """The page where TOUR continues in the linear mode."""
        self.script_code = 0
        """The exit code of a script for what was refused so far, apart from the mistakes of its runs."""
        self.is_urgent = False
        """Whether an answer comes before what a running program has said and is not printed yet."""
        self.runs = RunController(
            donnie.team,
            donnie.words,
            donnie.chronicle,
            has_prompt=screen is None,
            can_hold=interaction.is_attended,
        )
        self.attempt: Attempt | None = None
        """What was done for the challenge of this world, if it has one."""
        if donnie.world.challenge is not None:
            self.attempt = Attempt(donnie, preferences)
            self.runs.judge = self.attempt.judge
        self.trail: Trail = donnie.chronicle.timeline().moves(lambda: donnie.session.hub.robot)
        self.errors = RunErrors(of=lambda: donnie.session.hub.robot)
        listeners = (self.trail.on_event, self.errors.on_event)
        self._unsubscribe = [donnie.team.stream.subscribe(each) for each in listeners]

    def close(self) -> None:
        """Another front end continues with the session."""
        self.runs.close()
        if self.attempt is not None:
            self.attempt.close()
        for unsubscribe in self._unsubscribe:
            unsubscribe()

    def refuse(self, code: int = FAILED) -> None:
        """Note that a line of a script was refused: the script ends with this exit code or a higher one."""
        self.script_code = max(self.script_code, code)

    @property
    def program(self) -> Document:
        """The document that the learner works with."""
        return self.workspace.document

    def map_grid(self) -> MapGrid:
        """The floor around the learner's current robot."""
        from donnie_tui.core.map_grid import MapGrid

        donnie = self.donnie
        grid = MapGrid(donnie.picture_now(), donnie.session.pose, shown_name(donnie.session.name))
        if self.attempt is not None:
            grid.mark_goals(self.attempt.challenge.rules.goal_places)
        return grid

    # --- answers

    def say(self, *lines: str, is_repeated: bool = False) -> None:
        """Answer with lines: each is printed, spoken, and remembered unless it ``is_repeated``."""
        for line in lines:
            self.donnie.session.hub.publish(Answered(line, at_once=self.is_urgent, is_repeated=is_repeated))

    def answer(self, code: str, **values: object) -> None:
        """Answer with a sentence of the catalogue."""
        self.say(self.words(code, **values))

    def answer_once(self, code: str, **values: object) -> None:
        """As ``answer``, unless that was the whole last answer: a key may be held down at a limit."""
        sentence = self.words(code, **values)
        if self.answers.last() != (sentence,):
            self.say(sentence)

    def answer_no_line(self, number: int) -> None:
        """Answer that the program has no line of that number."""
        from donnie_tui.core.program_text import no_such_line

        self.say(no_such_line(len(self.program.lines), number, self.words))

    def say_of_robot(self, *lines: str) -> None:
        """As ``say``; if there are several robots, the first line names the current one."""
        self.say(*self.of_robot(*lines))

    def of_robot(self, *lines: str) -> tuple[str, ...]:
        """The lines, with the name of the current robot if there are several."""
        return lines_with_robot_name(self.donnie.session.hub.robot, lines, self.words)

    def answer_of_robot(self, code: str, **values: object) -> None:
        """As ``answer``; if there are several robots, it names the current one."""
        self.say(with_robot_name(self.donnie.session.hub.robot, self.words(code, **values), self.words))

    def answer_entering(self, world: str) -> None:
        """Announce the world that is entered next; a challenge announces its own title."""
        if not world.startswith(CHALLENGE):
            self.answer("world-going", name=world)

    def counted(self, lines: Sequence[str]) -> tuple[str, ...]:
        """Returns the lines of a list; a long list begins with their number."""
        is_long = len(lines) > MOST_AT_ONCE
        return (*((self.words("number-of-lines", lines=len(lines)),) if is_long else ()), *lines)


# --- challenges


_BEYOND_REPAIR = ("never-", "limit-", "word-in-lesson", "word-later")
"""Prefixes of the codes of failures that no further line can repair."""
_ACTS = (RunStarted, Reset, Moved, Turned, Spoke, ThingsMoved, GripperUsed)
"""Events that may meet a goal."""


class Attempt:
    """What a learner did for a challenge since the robot was last put to its start."""

    MOST_EVENTS = 100_000
    """An endless program publishes more events; the oldest are dropped."""
    MOST_LIVE = 500
    """After that many events goals have no cue until the end, since each judgment reads all events before."""

    def __init__(self, donnie: Donnie, preferences: Preferences) -> None:
        self._judge = Judge(donnie.world, donnie.words, preferences.settings)
        self.challenge = self._judge.starts[0].challenge
        """With the goals of the first start; a goal may be where the solution ends."""
        self.room = self._judge.room
        self.hints = 0
        """Those that were given."""
        self._met = frozenset[int]()
        """The goals that were met, by their index in the file; each has its cue once."""
        self._donnie = donnie
        start = Stamped(0, 0.0, Reset(donnie.session.pose), donnie.session.hub.robot)
        self._events = deque([start], maxlen=self.MOST_EVENTS)
        self.has_questions = False
        """Whether the last run is followed by questions that were not asked yet."""
        self.is_answered = False
        """Whether all questions were."""
        self._was_asked = self._is_program = False
        """Whether the questions were asked without a solution, and whether more than a line ran last."""
        self._answers: dict[Unsensed, bool] | None = None
        """After a run of a real robot, what the learner said about what it can't sense."""
        self._is_lost = False
        """Whether the learner knows that only a new start helps."""
        self.tried: Attempted | None = None
        """The last run, until it is written."""
        self.now = self.judgment()
        """The last judgment, for a screen; it may be out of date while many events come."""
        self._unsubscribe = donnie.team.stream.subscribe(self._on_event)

    def _on_event(self, stamped: Stamped) -> None:
        is_start = isinstance(stamped.event, RunStarted | Reset)
        self._answers = None if is_start else self._answers
        if begins_anew(stamped.event):
            others = (each for each in self._events if each.robot != stamped.robot)
            self._events = deque(others, maxlen=self.MOST_EVENTS)
            self._met, self._is_lost = frozenset(), False
        if not isinstance(stamped.event, TRANSIENT):
            self._events.append(stamped)
        if isinstance(stamped.event, _ACTS) and len(self._events) <= self.MOST_LIVE:
            self._chime(self.judgment(), is_quiet=is_start)

    def _chime(self, now: Judgment, *, is_quiet: bool) -> None:
        """Note which goals are met, with a cue for new ones unless ``is_quiet``."""
        met = frozenset(at for at, each in enumerate(now.of_goals) if each is None)
        if met - self._met and not is_quiet:
            self._donnie.session.hub.publish(Chimed("goal"))
        self._met, self.now = self._met | met, now

    def judgment(self) -> Judgment:
        """The judgment of what was done from the first start."""
        answers = self._no_answers if self._answers is None else self._answers
        return self._judge.starts[0].judge(tuple(self._events), answers)

    @property
    def _no_answers(self) -> dict[Unsensed, bool] | None:
        """None unless the robot can't sense the things around it."""
        connection = self._donnie.connection
        return {} if connection.is_real or connection.is_board else None

    @property
    def unsensed(self) -> tuple[Unsensed, ...]:
        """After a run of a real robot, what it can't sense and the learner has not answered yet."""
        known = self._answers
        return () if known is None else tuple(it for it in self.challenge.rules.unsensed if it not in known)

    def judge(self, is_program: bool, is_asked: bool) -> tuple[str, ...]:
        """Judge a run, keep it as a try, and return the verdict. ``is_program``: more than a line ran.

        ``is_asked``: questions follow at once, else the learner must ask for them.

        A program that solves the challenge from the first start must solve it from the others, too. Where a
        real robot can't sense everything, the learner is asked first.
        """
        self.keep_try()
        self._answers, self._is_program = self._no_answers, is_program
        self.has_questions = bool(self.unsensed)
        code = "goals-asked" if is_asked else "goals-unasked"
        return (self._donnie.words(code),) if self.has_questions else self.judge_answered({})

    def judge_answered(self, answers: Mapping[Unsensed, bool]) -> tuple[str, ...]:
        """As ``judge``, with the learner's answers about what the robot can't sense.

        The other starts are those of the simulated world. What was not answered can be asked again.
        """
        from donnie_tui.core.describe import verdict_in_words
        from worlds import challenges

        if self._answers is not None:
            self._answers |= answers
        verdicts, words = self._judge.events(tuple(self._events), self._answers), self._donnie.words
        here, is_solved = verdicts[0], all(each.is_solved for each in verdicts)
        self.tried = Attempted(
            datetime.now().astimezone().isoformat(timespec="seconds"),
            self.challenge.name,
            is_solved,
            hints=self.hints,
            seconds=round(here.track.counts["seconds"]),
            shortest=self._shortest if is_solved else 0,
            **here.counts,
        )
        self.has_questions = self._is_to_be_asked(is_solved=is_solved)
        if not (self.has_questions or self.unsensed):
            self.keep_try()
        if is_solved:
            self._donnie.session.hub.publish(CueSounded("solved", 0.0, None))
        self._chime(here, is_quiet=is_solved)
        lines = [verdict_in_words(verdicts, words)]
        following = challenges.after(self.challenge.name) if is_solved else None
        if following is not None:
            title = challenges.find(following).text(words.language).title
            word = word_of(BY_NAME["next_challenge"], words.language)
            lines.append(words("challenge-next", word=word, title=title))
        elif self._answers is None and not is_solved and self._becomes_lost(verdicts[-1]):
            lines.append(words("challenge-again", word=word_of(BY_NAME["reset"], words.language)))
        return tuple(lines)

    @cached_property
    def _shortest(self) -> int:
        """The steps of the solution from the first start."""
        with suppress(Unusable):
            solution = solution_of(self._judge.world, self._donnie.words)
            return self._judge.programs(solution, self._judge.starts[:1])[0].counts["steps"]
        return 0

    def _becomes_lost(self, verdict: Judgment) -> bool:
        """Whether no further line can solve the challenge now. A whole program starts again by itself."""
        before = self._is_lost
        starts = [each.event for each in self._events if isinstance(each.event, RunStarted)]
        self._is_lost = any(each.code.startswith(_BEYOND_REPAIR) for each in verdict.shortfalls)
        return self._is_lost and not before and not begins_anew(starts[-1])

    def _is_to_be_asked(self, *, is_solved: bool) -> bool:
        """Whether questions are due: after the first failed program and each solution, until answered."""
        is_due = is_solved or (self._is_program and not self._was_asked)
        self._was_asked |= is_due
        return is_due and not self.is_answered and bool(self.challenge.rules.question)

    def questions(self) -> tuple[Asked, ...]:
        """The questions about the world in the state after the last run."""
        from donnie_tui.core.questions import Asked

        track = self.judgment().track
        return tuple(Asked(each, track) for each in self.challenge.rules.question)

    def keep_try(self, questions: int = 0, right: int = 0) -> None:
        """Write the last run into the progress file, with the questions that followed it."""
        self.has_questions = False
        if self.tried is not None:
            progress().add(replace(self.tried, questions=questions, right=right))
            self.tried = None

    def close(self) -> None:
        self.keep_try()
        self._unsubscribe()
