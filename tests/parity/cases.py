"""The typed lines: every word of the use cases, alone, with right and with wrong arguments.

``GROUPS`` are the sessions: each is one program, lines that bring it into a situation, and the lines that are
compared. Words that change nothing share a session; every other line has one of its own.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from donnie_tui.commands.declarations import COMMANDS, Command
from donnie_tui.commands.lookup import words_of
from tests.conftest import ROOT

ENDING = "VAR a = 3\nREPEAT 2 TIMES\nFW 1\nEND REPEAT\nTR 10\na = a + 1\nFW 1\n"
"""A program that comes to its end."""
WAITING = "VAR a = 3\nREPEAT 2 TIMES\nFW 1\nEND REPEAT\nTR 10\na = a + 1\nWAIT 1000000\nFW 1\n"
"""One that is waiting still when a test is over."""
WRONG = "VAR a = 3\nFWD 1\nTR 10\nBKK 2\n"
"""One with two mistakes of form."""

IDLE, RUNNING, HELD = "idle", "running", "held"
SITUATIONS = {IDLE: ("AGAIN",), RUNNING: ("READ 1", "START"), HELD: ("BREAK 5", "AGAIN")}
"""The lines that reach each situation. A program that was STARTed runs in the background."""

ARGUMENTS = {
    "": ("nonsense",),
    "challenge": ("1", "nonsense"),
    "compass": ("north", "nonsense"),
    "count": ("2", "0", "99", "nonsense"),
    "cue": ("bump", "nonsense"),
    "detail": ("full", "nonsense"),
    "file": ("kept.gd", "no/such.gd"),
    "language": ("en", "nonsense"),
    "line": ("2", "99", "0", "nonsense"),
    "lines": ("2", "2 3", "3 2", "99", "nonsense"),
    "report-file": ("list list.html", "map map.csv", "map map.png", "paper sheet", "nonsense"),
    "robot": ("donnie", "nonsense"),
    "row": ("0", "999", "nonsense"),
    "setting": ("speech", "speech off", "speech nonsense", "page ask", "clock on", "theme light", "nonsense"),
    "speed": ("7", "0", "nonsense"),
    "square": ("0 0", "999 999", "1", "nonsense"),
    "switch": ("on", "off", "nonsense"),
    "text-file": ("printed.txt", "no/such.txt"),
    "topic": ("FW", "AROUND", "WALK", "moving", "sound", "nonsense"),
    "lines-or-thing": ("5 1", "5 6 1", "99 1", "5", "nonsense", "chair 2 0", "nonsense 2 0"),
    "new-thing": ("box red 4 6 AS treasure", "box 0 0", "chiar 4 6", "box", "nonsense"),
    "thing": ("nonsense", "table"),
    "thing-and-degrees": ("table 90", "nonsense 90", "nonsense"),
    "world-file": ("built", "no/such.world"),
    "variable": ("a", "1x"),
    "word": ("FW", "nonsense"),
    "world": ("open_floor", "nonsense"),
}
"""The typed arguments of a word, by the kind of its argument."""

OWN_ARGUMENTS = {
    "change": ("2 REPEAT 3 TIMES", "2", "99 FW 1", "0", "nonsense"),
    "insert": ("2 SPEAK 1", "2", "8 SPEAK 1", "99 FW 1", "nonsense"),
    "connect": ("99", "nonsense"),
    "manual": ("1", "FW", "AROUND", "nonsense"),
    "translate": ("pt", "nonsense"),
    "set": ("nonsense",),
    "detail": ("normal", "nonsense"),
}
"""The same, for words that need something else."""


def _listed(text: str) -> tuple[str, ...]:
    """The parts of a text that are separated by commas."""
    return tuple(text.split(", "))


OF_THE_MISTAKE = _listed("ERROR, ERRORS, ERROR NEXT, ERROR PREVIOUS, EXPLAIN, FIX, ERRORS, UNDO")
OF_READING = _listed(
    "READ 1, READ, READ 3, READ 99, READ 0, READ nonsense, UP, DOWN, NEXT, N, PLACE, BACK, B, FIRST, "
    "BACK, UP, DOWN, NEXT SAME, BACK SAME, LAST LINE, NEXT, PLACE, FIRST, SEARCH FW, SEARCH AGAIN, SEARCH "
    "nonsense, OUTLINE, LIST, LIST 2, LIST 2 3, LIST 3 2, LIST 99, LIST nonsense"
)
OF_WHAT_WAS_SAID = _listed(
    "WHERE, LAST, LAST 1, LAST WORD, SPELL, AROUND north, LAST, LAST 2, SPELL 2, LAST 99, LAST 0, SPELL "
    "99, SPELL nonsense, LAST nonsense, FIND wall, FIND nonsense, FIND, QUIET"
)
WHILE_WATCHED = (
    ("SPEED", "SLOWER", "FASTER", "SPEED 7", "SPEED 0", "ROBOTS", "QUIET"),
    ("STOP",),
    ("STOP ALL",),
    ("PAUSE", "CONTINUE"),
)
"""In the linear mode few words count while a program runs that is waited for; all other lines wait."""
OF_EDITING = _listed(
    "CHANGE 2 REPEAT 3 TIMES, UNDO, REDO, INSERT 8 SPEAK 1, UNDO, UNDO, UNDO, DELETE 2 3, MOVE 5 1, UNDO, "
    "DELETE 5, REDO, FORMAT, UNDO, TRANSLATE pt, UNDO, DELETE 1 99, DELETE 1 8"
)
OF_SETTINGS = _listed(
    "SET, CONFIGURE, SETTINGS, "
    "SPEED, SPEED 7, FASTER, SLOWER, SPEED 0, SET speech, SET speech off, SET speech nonsense, SET "
    "page ask, SET clock on, AROUND, SET theme light, SET nonsense, SET clock off, DETAIL, DETAIL "
    "nonsense, DETAIL full, WHERE, DETAIL brief, WHERE, LANGUAGE, LANGUAGE nonsense, LANGUAGE pt, ONDE, "
    "AO REDOR, IDIOMA en, WHERE"
)
OF_WATCHING = _listed(
    "BREAK, BREAK 2, BREAK, BREAK 2, BREAK 99, BREAK 4, WATCH, WATCH a, WATCH, WATCH 1x, WATCH a"
)
IN_PORTUGUESE = _listed(
    "ONDE, AO REDOR, AO REDOR norte, MAPA LINHA 0, TRILHA, VARIÁVEIS, LER 2, LISTAR 2, ERRO, AJUDA AO "
    "REDOR, NOVAMENTE nada, MUDAR nada, PARADA 2, VELOCIDADE 0, DETALHE nada, SALVAR REGISTRO, PAUSAR, "
    "WHERE"
)
"""Lines that are typed one after the other, since each works on what the ones before it left."""

_ALWAYS_IN_ROWS = frozenset({"last", "last_word", "spell", "find"})
_IN_ROWS_OF_THEIR_OWN = _listed(
    "error, error_next, error_previous, errors, explain, fix, undo, redo, read, next, back, first, "
    "last_line, place, up, down, next_same, back_same, outline, list, search, search_again, quiet, "
    "break_, watch, slower, faster, speed, language, detail, set"
)
_ALONE = _listed(
    "run, again, stop, pause, continue_, step, step_over, step_back, run_to, reset, start, together, "
    "stop_all, linear, visual, quit, typed"
)
"""Words that run something or end something: each has a session of its own where it can be understood."""
_ALONE_WITH = _listed(
    "CHANGE 2 REPEAT 3 TIMES, COMMENT, COMMENT 2, COMMENT 2 3, COPY, COPY 2, COPY 2 3, COPY 3 2, "
    "DELETE, DELETE 2, DELETE 2 3, EXAMPLES 2, FORMAT, INSERT 2 SPEAK 1, MOVE 5 1, "
    "MOVE 5 6 1, NEW, OPEN kept.gd, REMOVE, TRANSLATE pt, WORLD open_floor, WORLDS open_floor"
)
"""The same for words with these arguments."""


@dataclass(frozen=True)
class Group:
    """One session."""

    name: str
    text: str
    before: tuple[str, ...]
    """Lines that lead to the situation; of these nothing is compared."""
    lines: tuple[str, ...]
    language: str = "en"
    world: str = "living_room"

    @property
    def cases(self) -> tuple[str, ...]:
        """The names of the lines in the table of differences. A repeated line has a number."""
        seen: Counter[str] = Counter()
        named = []
        for line in self.lines:
            seen[line] += 1
            named.append(f"{self.name}: {line}" + (f" ({seen[line]})" if seen[line] > 1 else ""))
        return tuple(named)


def lines_of(command: Command, language: str = "en") -> tuple[str, ...]:
    """The word alone, and with each argument. A word of GoDonnie has GoDonnie's arguments."""
    word = words_of(command.name, language)[0]
    arguments = (
        ()
        if command.is_godonnie and not command.argument
        else OWN_ARGUMENTS.get(command.name, ARGUMENTS[command.argument])
    )
    return (word, *(f"{word} {each}" for each in arguments))


def _of_all_words() -> Iterator[Group]:
    for situation, before in SITUATIONS.items():
        text = ENDING if situation == IDLE else WAITING
        shared: list[str] = []
        for case in (each for each in COMMANDS if not each.is_visual):
            for line in (*lines_of(case), *words_of(case.name, "en")[1:]):
                if line in _ALONE_WITH or (case.name in _ALONE and not line.endswith("nonsense")):
                    yield Group(situation, text, before, (line,))
                elif case.name not in _ALWAYS_IN_ROWS and not (
                    case.name in _IN_ROWS_OF_THEIR_OWN and situation == IDLE
                ):
                    shared.append(line)
        yield from (Group(situation, text, before, tuple(each)) for each in _in_portions(shared))


def _in_portions(lines: list[str], size: int = 16) -> Iterable[list[str]]:
    return (lines[at : at + size] for at in range(0, len(lines), size))


def _of_several_robots() -> Iterator[Group]:
    text, world = "FW 1\n", "two_robots"
    yield Group(
        "two robots",
        text,
        (),
        ("ROBOTS", "ROBOT", "ROBOT nobody", "WHERE", "STOP ALL", "ROBOT bob"),
        world=world,
    )
    yield Group(
        "two robots, idle",
        text,
        ("START",),
        ("AROUND", "TRAIL", "WORLD", "MAP", "RESET", "SENSORS"),
        world=world,
    )
    waiting = "WAIT 1000000\n"
    yield Group(
        "two robots, running", waiting, ("START",), ("ROBOTS", "RUN", "RESET", "STOP ALL"), world=world
    )


GROUPS = (
    *_of_all_words(),
    *_of_several_robots(),
    Group("name of a program", ENDING, (), ("AGAIN",)),
    Group("reading", ENDING, (), OF_READING),
    Group("said", ENDING, (), OF_WHAT_WAS_SAID),
    Group("said, running", WAITING, ("START",), OF_WHAT_WAS_SAID),
    Group("said, held", WAITING, ("BREAK 5", "AGAIN"), OF_WHAT_WAS_SAID),
    *(Group("watched", WAITING, ("AGAIN",), lines) for lines in WHILE_WATCHED),
    Group("editing", ENDING, (), OF_EDITING),
    Group("editing, idle", ENDING, ("AGAIN",), OF_EDITING),
    Group("settings", ENDING, (), OF_SETTINGS),
    Group("watching", ENDING, (), (*OF_WATCHING, "AGAIN", "CONTINUE")),
    Group("mistake", WRONG, ("AGAIN",), OF_THE_MISTAKE),
    Group("portuguese", ENDING, ("NOVAMENTE",), IN_PORTUGUESE, language="pt"),
    Group(
        "stepping",
        ENDING,
        (),
        ("STEP", "STEP", "OVER", "UNTIL 5", "STEP BACK", "STEP BACK", "SHOW VARIABLES", "STOP"),
    ),
    Group("challenge", "FW 4\n", (), ("GOALS", "AGAIN", "GOALS", "RESULTS"), world="challenge:first_walk"),
    Group(
        "challenge with questions",
        "FW 3\n",
        (),
        ("AGAIN", "QUESTIONS", "RESULTS"),
        world=f"challenge:{ROOT / 'tests' / 'asking.toml'}",
    ),
    Group("fresh", ENDING, (), ("RUN",)),
    Group(
        "fresh",
        ENDING,
        (),
        ("STOP", "PAUSE", "CONTINUE", "STEP BACK", "ERROR", "EXPLAIN", "LAST", "TYPED", "RECOVER"),
    ),
)
