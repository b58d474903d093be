"""Every back end runs the corpus as expected, except the programs with objects on the floor."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from language.diagnostics import QuitRequested
from language.parser import parse
from language.syntax import Axis
from tests.unit.language_back.recorder import BACK_ENDS, Make, Outcome, Recorder, run


@dataclass
class Walker(Recorder):
    """Walks on an empty floor; every sensor reads 60 and nothing has a colour."""

    x: float = 0.0
    y: float = 0.0
    heading: int = 0

    def forward(self, steps: int, command: str) -> None:
        super().forward(steps, command)
        self.x += max(0, steps) * math.sin(math.radians(self.heading))
        self.y += max(0, steps) * math.cos(math.radians(self.heading))

    def backward(self, steps: int, command: str) -> None:
        self.heading += 180
        self.forward(steps, command)
        self.heading -= 180

    def turn_right(self, degrees: int, command: str) -> None:
        self.heading += degrees

    def turn_left(self, degrees: int, command: str) -> None:
        self.heading -= degrees

    def distance(self, bearing: object) -> int:
        return 60

    def colour(self, colour: str) -> int:
        return 0

    def position(self, axis: Axis) -> int:
        x, y = int(round(self.x, 6)), int(round(self.y, 6))
        return {Axis.X: x, Axis.Y: y, Axis.ANGLE: self.heading % 360}[axis]


@dataclass(frozen=True)
class Expected:
    """The facts of an ``.expected`` file that are the language's own."""

    text: str

    def all(self, key: str) -> list[str]:
        return re.findall(rf"^{key}: ?(.*)$", self.text, re.MULTILINE)

    def one(self, key: str) -> str:
        return next(iter(self.all(key)), "")

    @property
    def said(self) -> list[str]:
        return [text.replace("\\n", "\n").replace("\\\\", "\\") for text in self.all("say")]

    @property
    def variables(self) -> dict[str, int]:
        return {
            name: int(value) for name, value in re.findall(r"^var (\S+) = (\S+)$", self.text, re.MULTILINE)
        }


def programs(shared: Path) -> Iterator[tuple[str, str, Expected]]:
    """Name, text and expectations of each program that is right in form."""
    for path in sorted((shared / "corpus").glob("*.gd")):
        expected = Expected(path.with_suffix(".expected").read_text(encoding="utf-8"))
        source = path.read_bytes().decode("utf-8")
        if parse(source).program is not None and not expected.all("object"):
            yield path.stem, source, expected


def mistakes(outcome: Outcome, expected: Expected) -> list[object]:
    found: list[object] = []
    if [str(said) for said in outcome.actions.said] != expected.said:
        found.append(outcome.actions.said)
    if not expected.variables.items() <= outcome.variables.items():
        found.append(outcome.variables)
    if any(name in outcome.variables for name in re.findall(r"^novar (\S+)$", expected.text, re.MULTILINE)):
        found.append(outcome.variables)
    if isinstance(outcome.error, QuitRequested) != (expected.one("quit") == "yes"):
        found.append(outcome.error)
    return found + wrong_error(outcome, expected.one("error"))


def wrong_error(outcome: Outcome, expected: str) -> list[object]:
    if not expected:
        return [] if outcome.error is None or isinstance(outcome.error, QuitRequested) else [outcome.error]
    kind, line, column = outcome.place
    wanted = dict(zip(*[iter(expected.split()[1:])] * 2, strict=True))
    place_found = {"line": str(line), "column": str(column)}
    right = kind == expected.split()[0] and wanted.items() <= place_found.items()
    return [] if right else [outcome.place]


@pytest.mark.parametrize("make", BACK_ENDS.values(), ids=BACK_ENDS.keys())
def test_the_corpus_has_its_expected_outcomes(shared: Path, make: Make) -> None:
    wrong: dict[str, list[object]] = {}
    for name, source, expected in programs(shared):
        x, y, heading = (expected.one("start") or "0 0 0").split()
        actions = Walker(x=float(x), y=float(y), heading=int(heading))
        outcome = run(source, make, actions=actions, terminal=expected.one("mode") == "terminal")
        if found := mistakes(outcome, expected):
            wrong[name] = found

    assert wrong == {}
