"""The simulated board, given the host's side of each recording, answers as the real firmware did.

Timing aside: the recordings were made on another clock, in chunks of 20 milliseconds. So per part of a
recording, from one thing that was done to the next, the text is the same to the byte, but for a frame that a
reset cut off; battery, bumpers, beeps and outputs tell the same values; the sonars end at the same centimetre
(one is allowed, as the recordings have it among themselves), the wheels at the same count (4 of a hundred and
14 are allowed), and each type of frame comes as often (15 of a hundred are allowed, and what fits into one
chunk).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import pytest

from devices.firmware_double.board import SimulatedBoard
from devices.firmware_double.chassis import Chassis
from devices.firmware_double.faults import BadWire
from devices.firmware_double.surroundings import Place, Switch
from devices.wire.decoder import Decoder
from devices.wire.reports import Bumpers, Encoders, Message, Outputs, Power, Ranges, Report
from tests.wire.recordings import ROBOT_TRACES, Line, recording

RECORDED = Chassis(walking=(340.5, 326.6), walking_back=(340.5, 340.5), turning=(170.5, 162.0))
"""The wheels of the recordings turn as fast as their PWM says: 120 and 115, 120 and 120, 60 and 57 of 255."""


class Bench:
    """What was put around the board when it was recorded."""

    def __init__(self) -> None:
        self.far: list[float | None] = [100.0] * 7
        self.pressed: set[Switch] = set()

    def centimetres(self, place: Place, sonar: int, head: int) -> float | None:
        return self.far[sonar]

    def touched(self, place: Place) -> frozenset[Switch]:
        return frozenset(self.pressed)

    def is_free(self, place: Place) -> bool:
        return True

    def press_as(self, told: Bumpers) -> None:
        """As the recording has it where nobody said what was pressed: pins that float."""
        ne, n, nw, se, s, sw = told.pressed
        which = {Switch.NE: ne or n, Switch.NW: nw or n, Switch.SE: se or s, Switch.SW: sw or s}
        self.pressed = {switch for switch, is_pressed in which.items() if is_pressed}

    def do(self, done: str, board: SimulatedBoard, wire: BadWire) -> None:
        match done.split():
            case ["range", which, far]:
                for sonar in range(7) if which == "all" else (int(which),):
                    self.far[sonar] = None if far == "none" else float(far)
            case ["bumper", which, on]:
                named = set(Switch) if which == "all" else {Switch[which]}
                self.pressed = self.pressed | named if on == "1" else self.pressed - named
            case ["battery", volts]:
                board.millivolts = round(float(volts) * 1000)
            case ["corrupt", share]:
                wire.noise = float(share)
            case ["reset"]:
                board.reset()
            case other:
                raise AssertionError(other)


@dataclass
class Part:
    """What the board said from one thing that was done to it to the next."""

    seconds: float = 0.0
    said: bytes = b""
    text: list[str] = field(default_factory=list)
    reports: list[Report] = field(default_factory=list)

    def of(self, kind: type[Report]) -> list[Report]:
        return [report for report in self.reports if isinstance(report, kind)]

    def changes(self, kind: type[Report]) -> list[Report]:
        told = self.of(kind)
        return [b for a, b in zip([None, *told], told, strict=False) if a != b]


def parts(said: list[tuple[float, bytes | None]]) -> list[Part]:
    """``None`` parts them."""
    found, began = [Part()], 0.0
    decoder = Decoder(lambda line: found[-1].text.append(line))
    for at, data in said:
        if data is None:
            found[-1].seconds, began = at - began, at
            found.append(Part())
        else:
            found[-1].said += data
            found[-1].reports += decoder.feed(data)
    found[-1].seconds = said[-1][0] - began
    return found


def as_recorded(lines: list[Line]) -> list[Part]:
    return parts([(line.at, line.data if line.who == "rx" else None) for line in lines])


def as_simulated(lines: list[Line]) -> list[Part]:
    """The same things done to our board, at the same times."""
    bench, wire = Bench(), BadWire(seed=1)
    first = next(line.at for line in lines if line.who == "rx")
    board = SimulatedBoard(bench, RECORDED, boot_loader=first - 1.001)
    touched = [part.of(Bumpers) for part in as_recorded(lines)]
    said: list[tuple[float, bytes | None]] = []
    now, part = 0.0, 0
    for line in lines:
        said.append((line.at, wire.to_host(board.advance(line.at - now))))
        now = line.at
        if line.who == "rx":
            continue
        said.append((now, None))
        part += 1
        if line.who == "tx":
            board.receive(line.data)
        else:
            bench.do(line.done, board, wire)
        if (not line.done.startswith("bumper") and part <= 2) or line.done == "reset":
            later = [each for some in touched[part:] for each in some]
            bench.press_as(later[0]) if later else None
    return parts(said)


@pytest.fixture(params=ROBOT_TRACES, scope="module")
def both(request: pytest.FixtureRequest, shared: Path) -> list[tuple[Part, Part]]:
    lines = recording(shared, request.param)
    pairs = list(zip(as_recorded(lines), as_simulated(lines), strict=True))
    if request.param == "robot_corrupted_line":
        pairs = [(a, b) for a, b in pairs if a.seconds > 0.2]
        for a, b in pairs:
            a.text, b.text = [], []
    return pairs


def test_it_prints_the_same_text(both: list[tuple[Part, Part]]) -> None:
    assert [ours.text for _, ours in both] == [
        [line for line in theirs.text if "\\x" not in line] for theirs, _ in both
    ]


@pytest.mark.parametrize("kind", [Power, Message])
def test_it_tells_the_same_battery_and_beeps(both: list[tuple[Part, Part]], kind: type[Report]) -> None:
    theirs = Part(reports=[each for part, _ in both for each in part.of(kind)])
    ours = Part(reports=[each for _, part in both for each in part.of(kind)])

    assert ours.changes(kind) == theirs.changes(kind)


def test_it_tells_the_same_bumpers(both: list[tuple[Part, Part]]) -> None:
    long = [(theirs, ours) for theirs, ours in both if theirs.seconds > 0.06]

    assert [ours.changes(Bumpers)[-1:] for _, ours in long] == [
        theirs.changes(Bumpers)[-1:] for theirs, _ in long
    ]


def test_its_outputs_take_the_same_values(both: list[tuple[Part, Part]]) -> None:
    theirs = {report for part, _ in both for report in part.of(Outputs)}
    ours = {report for _, part in both for report in part.of(Outputs)}

    assert ours == theirs


def test_its_wheels_come_as_far(both: list[tuple[Part, Part]]) -> None:
    for theirs, ours in ((theirs, ours) for theirs, ours in both if theirs.seconds > 0.1):
        for a, b in zip(theirs.of(Encoders)[-1:], ours.of(Encoders)[-1:], strict=True):
            assert isinstance(a, Encoders)
            assert isinstance(b, Encoders)
            assert (b.right, b.left) == (
                pytest.approx(a.right, rel=0.04, abs=14),
                pytest.approx(a.left, rel=0.04, abs=14),
            )


def test_its_sonars_end_at_the_same_centimetre(both: list[tuple[Part, Part]]) -> None:
    for theirs, ours in both:
        if theirs.seconds > 0.3:
            for a, b in zip(theirs.of(Ranges)[-1:], ours.of(Ranges)[-1:], strict=True):
                assert isinstance(a, Ranges)
                assert isinstance(b, Ranges)
                assert b.centimetres == pytest.approx(a.centimetres, abs=1)


def test_it_says_each_thing_as_often(both: list[tuple[Part, Part]]) -> None:
    for theirs, ours in both:
        often = {kind: len(theirs.of(kind)) for kind in map(type, theirs.reports + ours.reports)}
        for kind, count in often.items():
            chunk = 16 if kind is Encoders else 2
            assert len(ours.of(kind)) == pytest.approx(count, rel=0.15, abs=chunk), kind
