"""What a line means to a program that runs, or that is held between two steps.

Rule: to a running program only few words are said, each is done at once; all other lines wait until the
program has ended.
"""

from __future__ import annotations

from donnie_tui.core.harmless import printable
from donnie_tui.core.recall import Past
from donnie_tui.core.use_cases import When
from donnie_tui.linear import commands
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.holding import Goes, Wish
from donnie_tui.linear.reader import EditingReader, How, Typed
from donnie_tui.linear.runs import Runs
from donnie_tui.linear.told import Told
from language import keywords

LONGEST_QUOTE = 30
"""Characters of a line that are told when it was not taken."""

_GOES = {"step": Goes.STEP, "step_over": Goes.OVER, "continue_": Goes.ON, "stop": Goes.STOP}
"""How a held program goes on by a word."""
_LIVE = ("stop", "stop_all", "robots", "pause", "slower", "faster", "speed", "quiet")
"""What is done at once while a program runs, also before lines that wait to be read."""


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
        """What a line means to a program that is held between two steps; any other word is done."""
        line = typed.text.strip()
        wish = _wish(typed.how, line)
        if wish is None:
            self._do_while_held(typed.how, line)
        return Wish(Goes.STOP) if self._desk.goes_to else wish

    def _do_while_held(self, how: How, line: str) -> None:
        found = commands.find(line)
        if how is How.TOO_LONG:
            self._desk.answer("linear-too-long")
        elif found is None or found[0].when is When.IDLE:
            self._refuse_while_held(line, is_word=found is not None)
        else:
            commands.do(*found, self._desk, self.runs)

    def _refuse_while_held(self, line: str, *, is_word: bool) -> None:
        words = line.split()
        if keywords.canonical(words[0]) == "HELP":
            commands.say_help(self._desk, " ".join(words[1:]))
        elif is_word or not commands.is_probably_ours(line, self._desk):
            self._desk.answer("linear-not-taken", line=printable(line[:LONGEST_QUOTE]))
            self._desk.answer("linear-stepping")

    def _live(self) -> bool:
        """Do a line that was typed for the running program, if there is one. Whether it was."""
        if self._editing is None or not self._desk.ends.hears_live:
            return False
        line = self._editing.take_ahead(self._counts_at_once)
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

    def _counts_at_once(self, line: str) -> bool:
        """Where it is asked how a held program is to go on, that word is for whoever asks."""
        found = commands.find(line)
        name = found[0].name if found is not None else ""
        return name in _LIVE or (name == "continue_" and not self.runs.tells_holds)


def _wish(how: How, line: str) -> Wish | None:
    """How the held program is to go on; None where the line says nothing about that."""
    word = keywords.canonical(line)
    if how in (How.INTERRUPTED, How.CLOSED) or word in ("QUIT", "EXIT"):
        return Wish(Goes.STOP)
    if how is How.ESCAPE or word == "RUN":
        return Wish(Goes.ON)
    if how is How.ENTER and not line:
        return Wish(Goes.STEP)
    case, rest = commands.find(line) or (None, "")
    if case is not None and case.name in _GOES and not rest:
        return Wish(_GOES[case.name])
    if case is not None and case.name == "run_to" and rest.isdecimal() and len(rest) < 9:
        return Wish(Goes.UNTIL, int(rest))
    return None
