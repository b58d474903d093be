"""Programs that hypothesis makes up: GoDonnie in three languages, right in form, wild in layout.

``programs()`` is any program; ``programs(runnable=True)`` one that ends, whose names exist when they are
reached and that wants no terminal (it may still divide by zero). ``layouts=False`` leaves out comments and
wild white space.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

from hypothesis import strategies as st

from language.keywords import ARGUMENTS, LANGUAGES, spelling

T = TypeVar("T")

NAMES = ("a", "b", "f", "t", "x", "y", "total", "n1", "ação", "frente", "turn", "do_it", "Über")
PROCEDURES = ("P", "Square", "volta", "p_2")
TEXTS = ('"hello"', '""', '"END IF -- no"', "“olá; você”", '"two\nlines"', '"It\'s"')
COMMENTS = ("-- why", "--", "---- section ----", "– END FOR", "-- ação “x", "--word")
GAPS = (" ", " ", " ", " ", "\n", "  \t", "\n\n\n", "\r\n")
DEEPEST = 3


@st.composite
def programs(
    draw: Callable[..., Any], language: str | None = None, *, runnable: bool = False, layouts: bool = True
) -> str:
    """The text of a program, in one language or in all three at once."""
    writer = _Writer(draw, language, runnable)
    writer.block(0, draw(st.integers(0, 5)))
    return _joined(draw, writer.pieces, layouts)


def _joined(draw: Callable[..., Any], pieces: list[str], layouts: bool) -> str:
    if not layouts:
        return "".join(f"{piece} " for piece in pieces)
    gap = st.sampled_from(GAPS)
    comment = st.tuples(gap, st.sampled_from(COMMENTS)).map(lambda both: f"{both[0]}{both[1]}\n")
    gaps = st.lists(
        st.integers(0, 9).flatmap(lambda number: comment if number == 0 else gap),
        min_size=len(pieces) + 1,
        max_size=len(pieces) + 1,
    )
    chosen = draw(gaps)
    return "".join(space + piece for space, piece in zip(chosen, [*pieces, ""], strict=True))


@dataclass
class _Writer:
    """Writes one program, piece by piece. A piece is a word, a keyword of two words, a sign or a text."""

    draw: Callable[..., Any]
    language: str | None
    runnable: bool
    pieces: list[str] = field(default_factory=list)
    names: list[str] = field(default_factory=list)
    """What has surely been declared here."""
    taken: list[str] = field(default_factory=list)
    """What may have been declared in this program or procedure."""
    procedures: dict[str, int] = field(default_factory=dict)
    loops: int = 0
    is_in_procedure: bool = False

    def choose(self, choices: Sequence[T]) -> T:
        chosen: T = self.draw(st.sampled_from(list(choices)))
        return chosen

    def number(self, least: int, most: int) -> int:
        chosen: int = self.draw(st.integers(least, most))
        return chosen

    def put(self, *pieces: str) -> None:
        self.pieces += pieces

    def word(self, canonical: str) -> str:
        language = self.language or self.choose(LANGUAGES)
        return self.dressed(spelling(canonical, language))

    def dressed(self, word: str) -> str:
        """In any case, with or without accents, composed or decomposed, with any blank between."""
        kind = self.number(0, 5)
        if kind == 1:
            return word.lower()
        if kind == 2:
            return unicodedata.normalize("NFD", word).title()
        if kind == 3:
            decomposed = unicodedata.normalize("NFD", word)
            return "".join(each for each in decomposed if not unicodedata.combining(each))
        return word.replace(" ", "\n\t") if kind == 4 else word

    def argument(self, terminal: str) -> str:
        rows = [each for each in ARGUMENTS if each.terminal == terminal]
        language = self.language or self.choose(LANGUAGES)
        return self.dressed(self.choose(self.choose(rows).spellings[language]))

    # --- commands ------------------------------------------------------------------------------------

    def block(self, depth: int, count: int) -> None:
        for _ in range(count):
            self.command(depth)
            if self.number(0, 7) == 0:
                self.put(";" * self.number(1, 3))

    def inner(self, depth: int) -> None:
        """The commands in a block; what is declared there may not have run afterwards."""
        names = list(self.names)
        self.block(depth + 1, self.number(0, 3))
        self.names = names

    def command(self, depth: int) -> None:
        simple = [self.speak, self.move, self.declare, self.assign, self.call, self.small, self.switch]
        blocks = [self.if_, self.repeat, self.for_, self.while_, self.procedure]
        choices = simple if depth >= DEEPEST else [*simple, *simple, *blocks]
        make = self.choose(choices)
        if make in blocks:
            self.choose(blocks)(depth)
        else:
            make()  # type: ignore[call-arg]

    def speak(self) -> None:
        self.put(self.word("SPEAK"))
        if self.number(0, 2) == 0:
            self.put(self.choose(TEXTS))
        else:
            self.expression(2)

    def move(self) -> None:
        canonical = self.choose(("FW", "FORWARD", "BW", "BACKWARD", "TR", "RIGHT TURN", "TL", "WAIT"))
        self.put(self.word(canonical))
        self.expression(1)

    def small(self) -> None:
        choices = ["SCAN", "STATE", "HISTORY", "POS", "sensor"]
        chosen = self.choose(
            choices if self.runnable else [*choices, "QUIT", "EXIT", "RUN", "HELP", "HELP word"]
        )
        if chosen == "sensor":
            self.sensor()
        elif chosen == "HELP word":
            word = self.choose(("FW", "end if", "para  frente", "anything"))
            self.put(f"{self.word('HELP')} {word}")
        else:
            self.put(self.word(chosen) + ("\n" if chosen == "HELP" else ""))

    def switch(self) -> None:
        canonical = self.choose(("SOUND", "BELT", "VIBRATE"))
        self.put(self.word(canonical), self.argument("DIRECTION" if canonical == "VIBRATE" else "SWITCH"))

    def new_name(self) -> str:
        free = [name for name in NAMES if name not in self.taken] if self.runnable else list(NAMES)
        name = self.choose(free) if free else f"z{len(self.taken)}"
        self.taken.append(name)
        return name

    def declare(self) -> None:
        name = self.new_name()
        self.put(self.word("VAR"), name)
        if self.number(0, 1):
            self.put("=")
            self.expression(2)
        self.names.append(name)

    def assign(self) -> None:
        if self.runnable and not self.names:
            self.declare()
            return
        self.put(self.name(), "=")
        self.expression(2)

    def name(self) -> str:
        name = self.choose(self.names if self.runnable else NAMES)
        return unicodedata.normalize("NFD", name) if self.number(0, 5) == 0 else name

    def call(self) -> None:
        if self.runnable and not self.procedures:
            self.speak()
            return
        name = self.choose(list(self.procedures) if self.runnable else PROCEDURES)
        count = self.procedures[name] if self.runnable else self.number(0, 3)
        self.put(name, "[")
        for index in range(count):
            if index:
                self.put(",")
            self.expression(1)
        self.put("]")

    # --- blocks --------------------------------------------------------------------------------------

    def if_(self, depth: int) -> None:
        self.put(self.word("IF"))
        self.condition()
        self.put(self.word("THEN"))
        self.inner(depth)
        if self.number(0, 1):
            self.put(self.word("ELSE"))
            self.inner(depth)
        self.put(self.word("END IF"))

    def repeat(self, depth: int) -> None:
        self.put(self.word("REPEAT"))
        if self.runnable:
            self.put(str(self.number(0, 3)))
        else:
            self.expression(1)
        self.put(self.word("TIMES"))
        if self.number(0, 3) == 0:
            self.put(self.word("DO"))
        self.inner(depth)
        self.put(self.word("END REPEAT"))

    def for_(self, depth: int) -> None:
        self.loops += 1
        name = f"i{self.loops}" if self.runnable else self.choose(NAMES)
        self.put(self.word("FOR"))
        if self.runnable or self.number(0, 2):
            self.put(self.word("VAR"))
        if self.runnable:
            limit = str(self.number(0, 3))
            self.put(name, "=", "0", ";", name, "<", limit, ";", name, "=", name, "+", "1")
        else:
            self.free_head(name)
        self.put(self.word("DO"))
        self.inner(depth)
        self.put(self.word("END FOR"))

    def free_head(self, name: str) -> None:
        self.put(name, "=")
        self.expression(1)
        self.put(";")
        self.condition()
        self.put(";", self.choose(NAMES), "=")
        self.expression(1)

    def while_(self, depth: int) -> None:
        if not self.runnable:
            self.put(self.word("WHILE"))
            self.condition()
            self.put(self.word("DO"))
            self.inner(depth)
        else:
            self.counting_while(depth)
        self.put(self.word("END WHILE"))

    def counting_while(self, depth: int) -> None:
        self.loops += 1
        name = f"w{self.loops}"
        self.put(self.word("VAR"), name, "=", str(self.number(0, 3)))
        self.put(self.word("WHILE"), name, ">", "0", self.word("DO"), name, "=", name, "-", "1")
        self.inner(depth)

    def procedure(self, depth: int) -> None:
        if self.runnable and (depth or self.is_in_procedure or len(self.procedures) == len(PROCEDURES)):
            self.repeat(depth)
            return
        free = [name for name in PROCEDURES if name not in self.procedures] if self.runnable else PROCEDURES
        name, parameters = self.choose(free), self.parameters()
        outside, self.names = (self.names, self.taken), list(parameters)
        self.taken = list(parameters)
        self.is_in_procedure = True
        self.put(self.word("PROCEDURE"), name)
        for index, parameter in enumerate(parameters):
            self.put("," if index else ":", parameter)
        self.put(self.word("DO"))
        self.inner(depth)
        self.put(self.word("END PROCEDURE"))
        (self.names, self.taken), self.is_in_procedure = outside, False
        self.procedures[name] = len(parameters)

    def parameters(self) -> list[str]:
        names = st.lists(st.sampled_from(NAMES), max_size=3, unique=True)
        chosen: list[str] = self.draw(names)
        return chosen

    # --- expressions ---------------------------------------------------------------------------------

    def condition(self) -> None:
        self.expression(1)
        self.put(self.choose(("==", "<>", "<", ">", "<=", ">=")))
        self.expression(1)

    def expression(self, depth: int) -> None:
        kind = self.number(0, 6 if depth else 3)
        if kind <= 1:
            self.put(str(self.number(0, 100)))
        elif kind == 2 and (self.names or not self.runnable):
            self.put(self.name())
        elif kind <= 3:
            self.sensor()
        elif kind == 4:
            self.put(self.choose("+-"))
            self.expression(depth - 1)
        elif kind == 5:
            self.put("(")
            self.expression(depth - 1)
            self.put(")")
        else:
            self.expression(depth - 1)
            self.put(self.choose("+-*/"))
            self.expression(depth - 1)

    def sensor(self) -> None:
        canonical = self.choose(("DISTANCE", "POS", "POSITION", "COLOR"))
        terminal = {"DISTANCE": "DIRECTION", "COLOR": "COLOUR"}.get(canonical, "AXIS")
        self.put(self.word(canonical), self.argument(terminal))
