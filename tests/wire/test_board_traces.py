"""Given the host's side of each recording, the simulated board answers as the real firmware did, timing
aside.

The recordings were made on another clock, in chunks of 20 milliseconds. A recording is divided into parts,
from one action on the board to the next. In each part the text is the same to the byte, except for a frame
that a reset cut off. Battery, bumpers, beeps and outputs have the same values. The sonars end at the same
centimetre (with a tolerance of one, as between the recordings), the wheels at the same count (with a
tolerance of 4 % and 14), and each type of frame comes as often (with a tolerance of 15 % and one chunk).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import pytest

from devices.board_simulator.board import SimulatedBoard
from devices.board_simulator.floor import AxlePose, BumperSwitch, Chassis
from devices.wire.frames import Bumpers, Decoder, Encoders, Message, Outputs, Power, Ranges, Report
from tests.noisy_wire import NoisyWire
from tests.wire.recordings import ROBOT_TRACES, RecordedRow, recording

RECORDED = Chassis(walking=(340.5, 326.6), walking_back=(340.5, 340.5), turning=(170.5, 162.0))
"""The recorded wheels turn in proportion to their PWM: 120 and 115, 120 and 120, 60 and 57 of 255."""


class Bench:
    """What surrounded the board when it was recorded."""

    def __init__(self) -> None:
        self.far: list[float | None] = [100.0] * 7
        self.pressed: set[BumperSwitch] = set()

    def centimetres(self, place: AxlePose, sonar: int, head: int) -> float | None:
        return self.far[sonar]

    def touched(self, place: AxlePose) -> frozenset[BumperSwitch]:
        return frozenset(self.pressed)

    def is_free(self, place: AxlePose) -> bool:
        return True

    def press_as(self, report: Bumpers) -> None:
        """As recorded, where no action set the bumpers: their pins float."""
        ne, n, nw, se, s, sw = report.pressed
        which = {
            BumperSwitch.NE: ne or n,
            BumperSwitch.NW: nw or n,
            BumperSwitch.SE: se or s,
            BumperSwitch.SW: sw or s,
        }
        self.pressed = {switch for switch, is_pressed in which.items() if is_pressed}

    def do(self, action: str, board: SimulatedBoard, wire: NoisyWire) -> None:
        match action.split():
            case ["range", which, far]:
                for sonar in range(7) if which == "all" else (int(which),):
                    self.far[sonar] = None if far == "none" else float(far)
            case ["bumper", which, on]:
                named = set(BumperSwitch) if which == "all" else {BumperSwitch[which]}
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
    """What the board sent from one action on it to the next."""

    seconds: float = 0.0
    sent: bytes = b""
    text: list[str] = field(default_factory=list)
    reports: list[Report] = field(default_factory=list)

    def of(self, kind: type[Report]) -> list[Report]:
        return [report for report in self.reports if isinstance(report, kind)]

    def changes(self, kind: type[Report]) -> list[Report]:
        reports = self.of(kind)
        return [b for a, b in zip([None, *reports], reports, strict=False) if a != b]


def parts(sent: list[tuple[float, bytes | None]]) -> list[Part]:
    """``None`` begins a new part."""
    found, began = [Part()], 0.0
    decoder = Decoder(lambda text: found[-1].text.append(text))
    for at, data in sent:
        if data is None:
            found[-1].seconds, began = at - began, at
            found.append(Part())
        else:
            found[-1].sent += data
            found[-1].reports += decoder.feed(data)
    found[-1].seconds = sent[-1][0] - began
    return found


def as_recorded(rows: list[RecordedRow]) -> list[Part]:
    return parts([(row.at, row.data if row.direction == "rx" else None) for row in rows])


def as_simulated(rows: list[RecordedRow]) -> list[Part]:
    """The same actions on the simulated board, at the same times."""
    bench, wire = Bench(), NoisyWire(seed=1)
    first = next(row.at for row in rows if row.direction == "rx")
    board = SimulatedBoard(bench, RECORDED, boot_loader=first - 1.001)
    touched = [part.of(Bumpers) for part in as_recorded(rows)]
    sent: list[tuple[float, bytes | None]] = []
    now, part = 0.0, 0
    for row in rows:
        sent.append((row.at, wire.to_host(board.advance(row.at - now))))
        now = row.at
        if row.direction == "rx":
            continue
        sent.append((now, None))
        part += 1
        if row.direction == "tx":
            board.receive(row.data)
        else:
            bench.do(row.action, board, wire)
        if (not row.action.startswith("bumper") and part <= 2) or row.action == "reset":
            later = [each for some in touched[part:] for each in some]
            bench.press_as(later[0]) if later else None
    return parts(sent)


@pytest.fixture(params=ROBOT_TRACES, scope="module")
def both(request: pytest.FixtureRequest, shared: Path) -> list[tuple[Part, Part]]:
    rows = recording(shared, request.param)
    pairs = list(zip(as_recorded(rows), as_simulated(rows), strict=True))
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
def test_it_reports_the_same_battery_and_beeps(both: list[tuple[Part, Part]], kind: type[Report]) -> None:
    theirs = Part(reports=[each for part, _ in both for each in part.of(kind)])
    ours = Part(reports=[each for _, part in both for each in part.of(kind)])

    assert ours.changes(kind) == theirs.changes(kind)


def test_it_reports_the_same_bumpers(both: list[tuple[Part, Part]]) -> None:
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


def test_it_sends_each_type_of_frame_as_often(both: list[tuple[Part, Part]]) -> None:
    for theirs, ours in both:
        often = {kind: len(theirs.of(kind)) for kind in map(type, theirs.reports + ours.reports)}
        for kind, count in often.items():
            chunk = 16 if kind is Encoders else 2
            assert len(ours.of(kind)) == pytest.approx(count, rel=0.15, abs=chunk), kind


def test_a_new_board_looks_ahead_with_a_full_battery_and_no_fault() -> None:
    board = SimulatedBoard()

    assert (board.head, board.millivolts) == (90, 8000)
    assert not (board.is_mute or board.is_deaf or board.is_torn)
