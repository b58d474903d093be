"""What a line means to a program that runs, or that is held between two steps.

Rule: to a running program only few words are said, each is done at once; all other lines wait until the
program has ended.
"""

from __future__ import annotations

from donnie_tui.core.use_cases import When
from donnie_tui.linear import commands
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.holding import Goes, Wish
from donnie_tui.linear.reader import EditingReader, How, Typed
from donnie_tui.linear.recall import Past
from donnie_tui.linear.runs import Runs
from donnie_tui.linear.told import Told
from language import keywords

_GOES = {"step": Goes.STEP, "step_over": Goes.OVER, "continue_": Goes.ON, "stop": Goes.STOP}
"""How a held program goes on by a word."""
_LIVE = ("stop", "stop_all", "robots", "pause", "slower", "faster", "speed", "quiet")
"""What is done at once while a program runs."""
_URGENT = ("stop", "stop_all", "pause", "quiet")
"""Also before lines that wait to be read."""


class WhileRunning:
    """Listens while programs run."""

    def __init__(self, desk: Desk, told: Told, past: Past, editing: EditingReader | None) -> None:
        """``editing`` is None where lines can't be typed before the program has ended."""
        self._desk = desk
        self._past = past
        self._editing = editing
        self.runs = Runs(desk, told, self._wish_of, self._live)
        """The programs that are listened to."""

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
        commands.do(case, rest, self._desk, self.runs)
        return None

    def _refuse_while_held(self, line: str) -> None:
        words = line.split()
        if keywords.canonical(words[0]) == "HELP":
            commands.say_help(self._desk, " ".join(words[1:]))
        elif not commands.is_probably_ours(line, self._desk):
            self._desk.answer("linear-stepping")

    def _live(self) -> bool:
        """Do a line that was typed for the running program, if there is one. Whether it was."""
        if self._editing is None or not self._desk.ends.hears_live:
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
            commands.do(*found, self._desk, self.runs)
        finally:
            self._desk.answers_first = False
        return True


def _is_one_of(words: tuple[str, ...], line: str) -> bool:
    found = commands.find(line)
    return found is not None and found[0].name in words
