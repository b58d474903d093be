"""Random programs that test the back ends: few names, many clashes, all kinds of loops, numbers at the limit.

Unlike those of ``programs`` they may fail when they run: names that do not exist or exist twice, divisions by
zero, wrong counts of arguments, endless loops, endless recursion. They are made from a seed, because a
hypothesis strategy that draws every word takes longer than the tests themselves.
"""

from __future__ import annotations

import re
import unicodedata
from functools import cache
from random import Random

from language.keywords import WORDS, folded_word

LARGEST = "9" * 4300
HUGE = (str(2**30 - 1), str(2**30), str(2**64), "9" * 2151, LARGEST)
SENSORS = ("DISTANCE F", "DISTANCE B", "POS x", "POS y", "COLOR red")
COMPARATORS = ("==", "<>", "<", ">", "<=", ">=")
NAMES = "abcde"
PROCEDURES = "pq"
DEEPEST = 3


class ProgramWriter:
    """Writes one program after the other."""

    def __init__(self, seed: int) -> None:
        self._random = Random(seed)
        self._names: list[str] = []
        """The names that probably exist at this place of the text."""
        self._calls: dict[str, int] = {}

    def program(self) -> str:
        """The text of a program that is right in form. It may use the names of earlier ones."""
        lines = [line for name in "ab" for line in self._maybe(0.8, self._declaration(name))]
        return "\n".join(lines + self._statements(0, self._random.randint(1, 9)))

    def _maybe(self, chance: float, *lines: str) -> list[str]:
        return list(lines) if self._random.random() < chance else []

    def _pick(self, choices: str | list[str] | tuple[str, ...]) -> str:
        return self._random.choice(choices)

    # --- statements

    def _statements(self, depth: int, count: int) -> list[str]:
        return [self._statement(depth) for _ in range(count)]

    def _body(self, depth: int) -> str:
        names = list(self._names)
        body = "\n".join(self._statements(depth + 1, self._random.randint(0, 4)))
        self._names = names
        return body

    def _statement(self, depth: int) -> str:
        kind = self._random.random()
        if kind < 0.35 and depth < DEEPEST:
            return self._block(depth)
        if kind < 0.65:
            return self._change()
        if kind < 0.75:
            return self._call()
        return self._command()

    def _change(self) -> str:
        kind = self._random.random()
        free = [each for each in NAMES if each not in self._names]
        if kind < 0.02 or (kind < 0.2 and free) or not self._names:
            return self._declaration(self._pick(free or NAMES))
        name = self._name()
        if kind < 0.4:
            return f"{name} = {name} {self._pick('+-')} {self._random.randint(0, 3)}"
        return f"{name} = {self._expression(2)}"

    def _declaration(self, name: str) -> str:
        value = f" = {self._expression(1)}" if self._random.random() < 0.8 else ""
        self._names.append(name)
        return f"VAR {name}{value}"

    def _command(self) -> str:
        if self._random.random() < 0.02:
            return self._pick(("QUIT", "RUN", "VIBRATE F"))
        word = self._pick(("SPEAK", "SPEAK", "FW", "BW", "TR", "TL", "WAIT", "plain"))
        plain = (
            "SCAN",
            "POS",
            "DISTANCE F",
            "BELT ON",
            "HISTORY",
            'SPEAK "x"',
            "STATE",
            "SOUND OFF",
            "HELP FW",
        )
        return self._pick(plain) if word == "plain" else f"{word} {self._expression(2)}"

    def _call(self) -> str:
        name = self._pick(PROCEDURES)
        if name not in self._calls and self._random.random() < 0.9:
            return self._command()
        count = self._calls.get(name, 0) + (self._random.random() < 0.05)
        return f"{name} [{', '.join(self._expression(1) for _ in range(count))}]"

    def _block(self, depth: int) -> str:
        if not self._names:
            return self._repeat(depth)
        makers = (self._if, self._repeat, self._while, self._counting_for, self._free_for, self._procedure)
        return self._random.choice(makers)(depth)

    def _if(self, depth: int) -> str:
        head = f"IF {self._condition()} THEN\n{self._body(depth)}\n"
        return head + "\n".join(self._maybe(0.5, f"ELSE\n{self._body(depth)}")) + "\nEND IF"

    def _repeat(self, depth: int) -> str:
        times = self._expression(1) if self._random.random() < 0.3 else str(self._random.randint(0, 3))
        return f"REPEAT {times} TIMES\n{self._body(depth)}\nEND REPEAT"

    def _while(self, depth: int) -> str:
        if self._random.random() < 0.3:
            return f"WHILE {self._condition()} DO\n{self._body(depth)}\nEND WHILE"
        name = self._name()
        return f"WHILE {name} < 9 DO\n{self._body(depth)}\n{name} = {name} + 1\nEND WHILE"

    def _counting_for(self, depth: int) -> str:
        free = [each for each in NAMES if each not in self._names] or list(NAMES)
        name = self._pick(free) if self._random.random() < 0.95 else self._pick(NAMES)
        limit = self._name() if self._random.random() < 0.5 else str(self._random.randint(0, 4))
        step = self._random.choice(("+ 1", "+ 1", "+ 2", "- 1", "+ 0", f"+ {LARGEST}"))
        end = self._pick((">", ">=") if "-" in step else ("<", "<="))
        start = self._pick(("0", "1", "5", LARGEST, self._expression(1)))
        head = f"FOR VAR {name} = {start}; {name} {end} {limit}; {name} = {name} {step} DO"
        names = list(self._names)
        self._names.append(name)
        body = self._body(depth)
        self._names = names
        return f"{head}\n{body}\nEND FOR"

    def _free_for(self, depth: int) -> str:
        name, word = self._name(), self._pick(("", "", "", "VAR "))
        step = self._pick((f"{name} + 1", f"{name} * 2 + 1", self._expression(2)))
        head = f"FOR {word}{name} = {self._expression(1)}; {self._condition()}; {name} = {step} DO"
        return f"{head}\n{self._body(depth)}\nEND FOR"

    def _procedure(self, depth: int) -> str:
        free = [each for each in PROCEDURES if each not in self._calls]
        if not free and self._random.random() < 0.9:
            return self._if(depth)
        name = self._pick(free or list(PROCEDURES))
        parameters = list(NAMES)[: self._random.randint(0, 2)] + self._maybe(0.03, "a")
        names, self._names = self._names, list(parameters)
        self._calls[name] = len(parameters)
        body = self._body(depth)
        self._names = names
        colon = ": " if parameters else ""
        return f"PROCEDURE {name}{colon}{', '.join(parameters)} DO\n{body}\nEND PROCEDURE"

    # --- expressions

    def _name(self) -> str:
        return self._pick(self._names) if self._names and self._random.random() < 0.99 else self._pick(NAMES)

    def _condition(self) -> str:
        return f"{self._expression(1)} {self._pick(COMPARATORS)} {self._expression(1)}"

    def _expression(self, depth: int) -> str:
        kind = self._random.random()
        if depth == 0 or kind < 0.4:
            return self._atom()
        if kind < 0.5:
            return f"(-{self._expression(depth - 1)})"
        parts = self._expression(depth - 1), self._pick("++--**/"), self._expression(depth - 1)
        return " ".join(parts) if kind < 0.8 else f"({' '.join(parts)})"

    def _atom(self) -> str:
        kind = self._random.random()
        if kind < 0.6 and self._names:
            return self._name()
        if kind < 0.75:
            return self._pick(SENSORS)
        return self._pick(HUGE) if kind > 0.98 else str(self._random.randint(0, 5))


# --- several languages


@cache
def _spellings() -> dict[str, tuple[str, ...]]:
    """Every way to write each keyword, by its folded English spelling."""
    return {
        folded_word(each.canonical): tuple(spelt for row in each.spellings.values() for spelt in row)
        for each in WORDS
    }


def mixed(program: str, chance: Random) -> str:
    """The program with each keyword in any language, in any case, with or without its accents."""
    return _KEYWORD.sub(lambda found: _respelt(found[0], chance), program)


def _respelt(word: str, chance: Random) -> str:
    spellings = _spellings().get(folded_word(word))
    if spellings is None:
        return word
    spelt = chance.choice(spellings)
    decomposed = unicodedata.normalize("NFD", spelt)
    plain = "".join(each for each in decomposed if not unicodedata.combining(each))
    blank = chance.choice((" ", " ", "\n", "\t"))
    return chance.choice((spelt, spelt, spelt.lower(), decomposed, plain)).replace(" ", blank)


_KEYWORD = re.compile(r"\b(?:END [A-Z]+|[A-Z]{2,})\b")
