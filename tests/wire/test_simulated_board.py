"""The simulated board byte by byte and pass by pass, as docs/wire-protocol.md describes the firmware."""

from __future__ import annotations

import struct
from math import cos, pi, sin

import pytest

from devices.board_simulator.board import FirmwareParser, SimulatedBoard
from devices.board_simulator.floor import AxlePose, BumperSwitch, Chassis
from devices.wire.frames import (
    CONFIGURE,
    PING,
    STOP,
    Bumpers,
    CommandKind,
    Decoder,
    Encoders,
    MotorDrive,
    Outputs,
    Pinged,
    Power,
    Ranges,
    Report,
    ReportKind,
    drive_frame,
    encode_frame,
    head_frame,
)
from tests.noisy_wire import NoisyWire

NE, NW, SE, SW = BumperSwitch.NE, BumperSwitch.NW, BumperSwitch.SE, BumperSwitch.SW


class Room:
    """What surrounds a board; it knows which way each sonar last looked."""

    def __init__(self) -> None:
        self.measured: float | None = 100.0
        self.pressed: frozenset[BumperSwitch] = frozenset()
        self.is_empty = True
        self.asked: list[tuple[int, int]] = []

    def centimetres(self, place: AxlePose, sonar: int, head: int) -> float | None:
        self.asked.append((sonar, head))
        return self.measured

    def touched(self, place: AxlePose) -> frozenset[BumperSwitch]:
        return self.pressed

    def is_free(self, place: AxlePose) -> bool:
        return self.is_empty


def started(board: SimulatedBoard) -> SimulatedBoard:
    """Configured and streaming."""
    board.advance(1.1)
    board.receive(CONFIGURE)
    board.advance(0.1)
    return board


def reports(board: SimulatedBoard, seconds: float, kind: type[Report]) -> list[Report]:
    return [each for each in Decoder().feed(board.advance(seconds)) if isinstance(each, kind)]


def last(board: SimulatedBoard, kind: type[Report], seconds: float = 0.7) -> Report:
    return reports(board, seconds, kind)[-1]


# --- bytes


@pytest.mark.parametrize(
    ("sent", "printed", "frames"),
    [
        (b"\x00\xbb\x28", ["", "", ""], []),
        (b"\xaa\xaa\x28\xbb", ["\nFOUND S0", "\nFOUND S1", "\nFOUND S1", "\nFOUND S1"], []),
        (b"\xaa\xbb\x33\x28", ["\nFOUND S0", "\nFOUND S1", "", ""], []),
        (
            b"\xaa\xbb\x00\x28\x28",
            ["\nFOUND S0", "\nFOUND S1", "\nFOUND SZ", "\nPayload overloaded\n", ""],
            [],
        ),
        (
            b"\xaa\xbb\x02\x41\x2b\x00\x41",
            [
                *("\nFOUND S0", "\nFOUND S1", "\nFOUND SZ", "", "\nPayload reveived", "\nChecksum Error!"),
                "",
            ],
            [],
        ),
        (
            PING,
            [
                *("\nFOUND S0", "\nFOUND S1", "\nFOUND SZ", "", "\nPayload reveived", "\nChecksum success!"),
            ],
            [b"\x41\x2b"],
        ),
    ],
    ids=["no frame", "AA waits for BB", "too long", "empty", "wrong checksum", "a frame"],
)
def test_the_parser_prints_what_each_byte_is_to_it(
    sent: bytes, printed: list[str], frames: list[bytes]
) -> None:
    parser = FirmwareParser()
    outputs = [parser.take(byte) for byte in sent]

    assert [each.text.decode() for each in outputs] == printed
    assert [each.frame for each in outputs if each.frame] == frames


def test_a_frame_has_at_most_fifty_bytes_and_the_next_one_is_read_too() -> None:
    parser = FirmwareParser()
    for length in (49, 1):
        frame = encode_frame(CommandKind.PING.value, bytes(length))
        assert [out.frame for out in map(parser.take, frame) if out.frame] == [b"\x41" + bytes(length)]


def test_a_board_that_is_configured_reads_a_byte_in_a_pass_and_keeps_sixty_three() -> None:
    """Of frames of nine bytes seven fit."""
    board = started(SimulatedBoard())
    board.receive(STOP * 20)
    sent = b"".join(board.advance(1 / 750) for _ in range(64))

    assert sent.count(b"FOUND S0") == 7
    assert sent.count(b"Checksum success!") == 63 // len(STOP)
    first = SimulatedBoard()
    first.advance(1.1)
    first.receive(CONFIGURE)
    assert b"Checksum success!" in first.advance(1 / 740)


@pytest.mark.parametrize("passes", [750, 150])
def test_a_board_of_fewer_passes_reads_as_many_bytes_a_second(passes: int) -> None:
    board = started(SimulatedBoard(passes=passes))
    board.receive(PING + drive_frame(MotorDrive.FORWARD))
    board.advance(16 / 750)

    assert board.is_driving


@pytest.mark.parametrize(
    ("passes", "boot_loader", "first"), [(4, 1.0, 8), (4, 0.0, 4), (8, 0.0, 8), (8, 0.5, 12)]
)
def test_a_board_asks_for_its_configuration_a_second_after_its_boot_loader(
    passes: int, boot_loader: float, first: int
) -> None:
    """In the pass that ends that second, and not before that time has passed."""
    board = SimulatedBoard(boot_loader=boot_loader, passes=passes)
    sent = [board.advance(0.5 / passes) for _ in range(2 * first)]

    assert sent == [b""] * (2 * first - 1) + [encode_frame(0xC7, b"\x2b")]


@pytest.mark.parametrize(("seconds", "is_read"), [(0.0, False), (0.75, False), (1.0, True), (1.75, True)])
def test_a_board_reads_nothing_until_its_boot_loader_has_ended(seconds: float, is_read: bool) -> None:
    board = SimulatedBoard(boot_loader=1.0, passes=4)
    board.advance(seconds)
    board.receive(CONFIGURE)

    assert (b"Checksum success!" in board.advance(1.0)) is is_read


def test_a_board_that_is_configured_in_the_moment_of_its_first_request_makes_none() -> None:
    board = SimulatedBoard(boot_loader=0.0, passes=4)
    board.advance(0.75)
    board.receive(CONFIGURE)
    sent = board.advance(0.25)

    assert b"Checksum success!" in sent
    assert Decoder().feed(sent) == []


# --- what it obeys


def test_before_its_configuration_a_board_obeys_nothing_and_asks_for_it_each_second() -> None:
    board = SimulatedBoard()
    board.receive(CONFIGURE)  # its boot loader reads nothing
    asked = [len(Decoder().feed(board.advance(seconds))) for seconds in (1.9, 0.2, 1.0, 1.0)]
    board.receive(drive_frame(MotorDrive.FORWARD) + head_frame(20))
    board.advance(0.1)

    assert asked == [0, 1, 1, 1]
    assert (board.is_driving, board.head) == (False, 90)


def test_a_frame_whose_data_do_not_fit_is_not_obeyed() -> None:
    board = started(SimulatedBoard())
    for kind, data in (
        (CommandKind.MOTOR, b"\x0f\x7f\xf0"),
        (CommandKind.SERVO, b"\x10"),
        (CommandKind.OUTPUTS, b"\x1c\x1c"),
        (CommandKind.BEEP, b"\x01\x00"),
    ):
        board.receive(encode_frame(kind.value, data))
        assert b"Beep" not in board.advance(0.05)

    assert (board.is_driving, board.head, board.is_buzzing) == (False, 90, False)


@pytest.mark.parametrize(("angle", "head"), [(0, 0), (20, 20), (180, 180), (200, 180)])
def test_the_head_turns_as_far_as_it_can(angle: int, head: int) -> None:
    board = started(SimulatedBoard())
    board.receive(encode_frame(CommandKind.SERVO.value, bytes((0x10, angle))))
    board.advance(0.05)

    assert board.head == head


@pytest.mark.parametrize(
    ("bits", "is_buzzing", "left", "right", "reported"),
    [
        *((0b00100, True, False, False, 0b10000), (0b01000, False, True, False, 0b01000)),
        *((0b10000, False, False, True, 0b00100), (0b00011, False, False, False, 0)),
    ],
)
def test_outputs_are_commanded_in_one_order_and_reported_in_another(
    bits: int, is_buzzing: bool, left: bool, right: bool, reported: int
) -> None:
    board = started(SimulatedBoard())
    board.receive(encode_frame(CommandKind.OUTPUTS.value, bytes((bits,))))
    report = last(board, Outputs)

    assert (board.is_buzzing, board.vibrates_left, board.vibrates_right) == (is_buzzing, left, right)
    assert isinstance(report, Outputs)
    assert report.bits & 0b11100 == reported


@pytest.mark.parametrize("drive", MotorDrive)
def test_the_motors_turn_as_they_are_commanded_until_a_wheel_is_at_zero(drive: MotorDrive) -> None:
    board = started(SimulatedBoard())
    board.receive(drive_frame(drive))
    board.advance(0.5)
    senses = {
        MotorDrive.STOP: (0, 0), MotorDrive.FORWARD: (1, 1), MotorDrive.BACKWARD: (-1, -1),
        MotorDrive.LEFT: (1, -1), MotorDrive.RIGHT: (-1, 1),
    }  # fmt: skip
    right, left = board.wheels.right, board.wheels.left

    assert tuple((each > 0) - (each < 0) for each in (right, left)) == senses[drive]
    assert abs(right) == pytest.approx(abs(left))
    for stopped in (b"\x0f\x7f\xf0\x00", b"\x0f\x00\xf0\x7f"):
        board.receive(encode_frame(CommandKind.MOTOR.value, stopped) + drive_frame(drive))
        board.advance(9 / 740)
        assert not board.is_driving
        board.advance(0.05)
        assert board.is_driving is (drive is not MotorDrive.STOP)


def test_a_reset_stops_the_motors_and_begins_anew() -> None:
    board = started(SimulatedBoard(Room()))
    board.receive(drive_frame(MotorDrive.FORWARD))
    board.advance(0.5)
    place = board.wheels.place
    board.reset()

    assert (board.resets, board.is_driving, board.wheels.right, board.wheels.left) == (1, False, 0.0, 0.0)
    assert board.advance(0.9) == b""
    assert board.wheels.place != AxlePose()
    assert board.wheels.place.y - place.y < 0.005


# --- what it reports


@pytest.mark.parametrize(
    ("measured", "reported"), [(None, 141), (0.0, 0), (99.9, 99), (255.0, 255), (256.0, 0), (300.0, 44)]
)
def test_a_range_is_in_whole_centimetres_and_wraps(measured: float | None, reported: int) -> None:
    room = Room()
    room.measured = measured

    assert last(started(SimulatedBoard(room)), Ranges) == Ranges((reported,) * 7)


def test_the_sonars_measure_in_four_groups_each_200_milliseconds() -> None:
    room = Room()
    board = SimulatedBoard(room)
    for _ in range(2):
        room.asked.clear()
        board.advance(1.1)
        board.receive(CONFIGURE)
        board.advance(0.43)
        assert [sonar for sonar, _ in room.asked] == [1, 4, 2, 5, 6, 0, 3] * 2
        board.advance(0.1)
        board.reset()


@pytest.mark.parametrize(("is_newer", "looks"), [(False, 30), (True, 150)])
def test_the_head_of_the_newer_firmware_is_mirrored(is_newer: bool, looks: int) -> None:
    room = Room()
    board = started(SimulatedBoard.of_2018(room) if is_newer else SimulatedBoard(room))
    board.receive(head_frame(30))
    board.advance(0.1)
    room.asked.clear()
    board.advance(0.2)

    assert {head for _, head in room.asked} == {looks}


@pytest.mark.parametrize(
    ("pressed", "reported"),
    [
        ({NE}, "NE"), ({NW}, "NW"), ({SE}, "SE"), ({SW}, "SW"),
        ({NE, NW}, "N"), ({SE, SW}, "S"), ({NE, SE}, "NE SE"), ({NE, NW, SE, SW}, "N S"), (set(), ""),
    ],
)  # fmt: skip
def test_of_two_bumpers_that_are_pressed_together_the_one_between_them_is_reported(
    pressed: set[BumperSwitch], reported: str
) -> None:
    room = Room()
    room.pressed = frozenset(pressed)
    report = last(started(SimulatedBoard(room)), Bumpers, 0.1)

    assert isinstance(report, Bumpers)
    names = zip(("NE", "N", "NW", "SE", "S", "SW"), report.pressed, strict=True)
    assert " ".join(name for name, is_pressed in names if is_pressed) == reported


def test_each_report_comes_as_often_as_the_firmware_sends_it() -> None:
    """In the three seconds after the configuration; the first outputs and sensors come at once."""
    board = SimulatedBoard()
    board.advance(1.1)
    board.receive(CONFIGURE)
    came = Decoder().feed(board.advance(3.0))
    often = {kind: sum(isinstance(each, kind) for each in came) for kind in set(map(type, came))}

    assert set(often) == {Encoders, Ranges, Bumpers, Power, Outputs, Pinged}
    assert often[Encoders] == pytest.approx(3 * 750, abs=2)
    assert (often[Power], often[Outputs], often[Pinged]) == (10, 10, 1)
    assert often[Ranges] == often[Bumpers]
    assert often[Ranges] == pytest.approx(3 / 0.02, rel=0.1)
    first = [each for each in came if not isinstance(each, Encoders)][:4]
    assert isinstance(first[0], Outputs)
    assert first[1:] == [Ranges((0,) * 7), Bumpers((False,) * 6), Power(8000)]


def test_what_is_due_is_done_in_the_pass_that_ends_its_interval(monkeypatch: pytest.MonkeyPatch) -> None:
    """Here each interval is two passes."""
    for interval in ("STATUS", "SENSORS", "SONAR_SHOT"):
        monkeypatch.setattr(f"devices.board_simulator.board.{interval}", 0.5)
    room = Room()
    board = SimulatedBoard(room, boot_loader=0.0, passes=4)
    board.advance(0.25)
    board.receive(CONFIGURE)
    board.advance(0.25)
    done = []
    for _ in range(5):
        room.asked.clear()
        kinds = {type(each) for each in Decoder().feed(board.advance(0.25))} - {Encoders}
        done.append((kinds, [sonar for sonar, _ in room.asked]))

    sent = {Outputs, Power, Ranges, Bumpers}
    assert done == [(sent, []), (set(), [1, 4]), (sent, []), (set(), [2, 5]), (sent, [])]


@pytest.mark.parametrize(("millivolts", "lamps"), [(7100, {1}), (7099, {0, 1})])
def test_the_lamp_of_an_empty_battery_blinks(millivolts: int, lamps: set[int]) -> None:
    board = started(SimulatedBoard())
    board.millivolts = millivolts
    board.advance(0.7)
    shown = reports(board, 1.5, Outputs)

    assert {each.bits & 1 for each in shown if isinstance(each, Outputs)} == lamps


@pytest.mark.parametrize(
    ("empty_for", "lamps"), [(0, "111111"), (1, "101111"), (2, "101111"), (3, "101011"), (4, "101011")]
)
def test_the_lamp_of_the_battery_stays_on_once_it_is_charged(empty_for: int, lamps: str) -> None:
    """In two passes a second, with a report in each, older than the lamp's change."""
    board = SimulatedBoard(boot_loader=0.0, passes=2)
    board.advance(0.5)
    board.receive(CONFIGURE)
    board.advance(0.5)
    shown = ""
    for number in range(len(lamps)):
        board.millivolts = 7000 if number < empty_for else 8000
        shown += "".join(
            str(each.bits & 1) for each in reports(board, 0.5, Outputs) if isinstance(each, Outputs)
        )

    assert shown == lamps


def test_the_lamp_of_the_connection_blinks_until_a_ping_is_answered() -> None:
    def lamps(seconds: float) -> set[int]:
        return {each.bits >> 1 & 1 for each in reports(board, seconds, Outputs) if isinstance(each, Outputs)}

    board = started(SimulatedBoard())
    assert lamps(3.6) == {1}  # the first ping is not overdue
    assert lamps(2.0) == {0, 1}
    board.receive(PING)
    board.advance(0.4)
    assert lamps(1.5) == {1}


@pytest.mark.parametrize(
    ("answered_at", "dark_at"),
    [
        (None, [1.5, 5.0, 6.0, 7.0, 8.0, 9.0]),
        (2.0, [1.5, 7.0, 8.0, 9.0]),  # each answer is good for one ping
        (4.5, [1.5, 9.0]),
        (5.0, [1.5, 5.0, 9.0]),
    ],
)
def test_the_lamp_of_the_connection_changes_every_half_second_from_an_overdue_ping_on(
    answered_at: float | None, dark_at: list[float]
) -> None:
    """Two passes a second: pings at 2, 4, 6, 8 s, and a report in each pass, older than the lamp's change.

    The lamp is on since the first report; the change half a second after an overdue ping is in the next one.
    """
    board = SimulatedBoard(boot_loader=0.0, passes=2)
    board.advance(0.5)
    board.receive(CONFIGURE)
    board.advance(0.5)
    dark = []
    for now in (1.5 + each / 2 for each in range(17)):
        if now - 0.5 == answered_at:
            board.receive(PING)
        (report,) = reports(board, 0.5, Outputs)
        assert isinstance(report, Outputs)
        assert report.bits & 0b01
        if not report.bits & 0b10:
            dark.append(now)

    assert dark == dark_at


def test_the_lamp_of_the_connection_changes_no_sooner_than_in_half_a_second() -> None:
    """Eight passes a second, and a report in each third: at 0.375 s, 0.75 s and so on. The lamp changes at
    4.5, 5.25, 6, 6.75, 7.5 and 8.25 s, after the report."""
    board = SimulatedBoard(boot_loader=0.0, passes=8)
    board.advance(0.125)
    board.receive(CONFIGURE)
    seen = [each for each in Decoder().feed(board.advance(9.0 - 0.125)) if isinstance(each, Outputs)]

    dark = [0.375 * number for number, each in enumerate(seen, start=1) if not each.bits & 0b10]
    assert dark == [0.375, 4.875, 5.25, 6.375, 6.75, 7.875, 8.25]


def test_a_torn_count_is_old_and_new_and_comes_once() -> None:
    board = started(SimulatedBoard())
    board.is_torn = True

    assert reports(board, 3 / 740, Encoders) == [Encoders(258, 0), Encoders(0, 0), Encoders(0, 0)]


def test_a_mute_board_reads_and_a_deaf_one_streams() -> None:
    mute, deaf = started(SimulatedBoard()), started(SimulatedBoard())
    mute.is_mute = deaf.is_deaf = True
    for board in (mute, deaf):
        board.receive(drive_frame(MotorDrive.FORWARD))

    assert (mute.advance(0.05), mute.is_driving) == (b"", True)
    assert reports(deaf, 0.05, Encoders)
    assert not deaf.is_driving


def test_the_speeds_of_a_board_that_has_moved_are_no_speeds() -> None:
    board = started(SimulatedBoard())

    def speeds() -> tuple[int, ...]:
        frame = board.advance(1 / 740)[-13:]
        assert frame[:4] == b"\xaa\xbb\x09" + bytes((ReportKind.ENCODERS.value,))
        return struct.unpack(">HH", frame[8:12])

    assert speeds() == (0, 0)
    for drive in (MotorDrive.LEFT, MotorDrive.STOP):
        board.receive(drive_frame(drive))
        board.advance(0.05)
    assert speeds() == (120, 120)


def test_a_newer_board_crawls_while_its_pings_are_not_answered() -> None:
    """It pings two seconds after its start and then every two: the second one finds the first unanswered."""
    board = SimulatedBoard.of_2018()
    started(board)
    assert (board.wheels.share, board.wheels.encoders) == (1.0, (-1, -1))
    board.advance(2.0)  # 2.2 seconds of its sketch's time
    assert board.wheels.share == 1.0
    board.advance(2.0)
    assert board.wheels.share == 0.05
    board.receive(PING)
    board.advance(0.05)
    assert board.wheels.share == 1.0

    original = started(SimulatedBoard())
    original.advance(6.0)
    assert original.wheels.share == 1.0


# --- its wheels


def rolled(board: SimulatedBoard, drive: MotorDrive = MotorDrive.FORWARD) -> tuple[float, float]:
    """The counts of half a second."""
    board.receive(drive_frame(drive))
    board.advance(0.5)
    return board.wheels.right, board.wheels.left


def test_a_wheel_that_is_stuck_does_not_count_and_moves_nothing() -> None:
    for fault, is_moved in (("is_stuck", (0, 0)), ("is_right_stuck", (0, 1)), ("is_left_stuck", (1, 0))):
        board = started(SimulatedBoard())
        setattr(board.wheels, fault, True)
        assert tuple(each > 0 for each in rolled(board)) == is_moved
        assert (board.wheels.place == AxlePose()) == (is_moved == (0, 0))


def test_swapped_motors_encoders_and_unequal_wheels_are_faults_of_one_wheel() -> None:
    board = started(SimulatedBoard())
    board.wheels.motors, board.wheels.strengths = (-1, 1), (1.0, 0.5)
    right, left = rolled(board)
    assert right == pytest.approx(-2 * left, rel=1e-3)

    board = started(SimulatedBoard())
    board.wheels.encoders = (1, -1)
    right, left = rolled(board)
    assert right == pytest.approx(-left)
    assert board.wheels.place.yaw == pytest.approx(pi / 2)


def test_a_board_whose_motors_are_off_stays_where_it_is() -> None:
    board = started(SimulatedBoard())

    assert (board.wheels.right, board.wheels.left, board.wheels.place) == (0.0, 0.0, AxlePose())


UNEQUAL = Chassis(walking=(300.0, 200.0), walking_back=(150.0, 100.0), turning=(90.0, 60.0), lag=1e-5)


@pytest.mark.parametrize(
    ("drive", "rates"),
    [
        (MotorDrive.FORWARD, (300, 200)),
        (MotorDrive.BACKWARD, (-150, -100)),
        (MotorDrive.LEFT, (90, -60)),
        (MotorDrive.RIGHT, (-90, 60)),
    ],
)
@pytest.mark.parametrize("share", [1.0, 0.05])
def test_each_wheel_has_a_speed_for_each_movement(
    drive: MotorDrive, rates: tuple[int, int], share: float
) -> None:
    board = started(SimulatedBoard(chassis=UNEQUAL))
    board.wheels.share = share
    board.receive(drive_frame(drive))
    board.advance(0.1)
    right, left = board.wheels.right, board.wheels.left
    board.advance(0.2)

    assert (board.wheels.right - right, board.wheels.left - left) == pytest.approx(
        tuple(0.2 * rate * share for rate in rates)
    )


def test_a_robot_with_unequal_wheels_drives_in_an_arc() -> None:
    """Its radius is half the axle times the sum of the speeds over their difference."""
    board = started(SimulatedBoard(chassis=UNEQUAL, place=AxlePose(1.0, 2.0, 0.3)))
    board.receive(drive_frame(MotorDrive.FORWARD))
    board.advance(2.0)
    radius, here = 0.068 / 2 * 500 / 100, board.wheels.place

    assert here.yaw - 0.3 == pytest.approx(
        (board.wheels.right - board.wheels.left) * 2 * pi * 0.021 / 900 / 0.068
    )
    assert here.x == pytest.approx(1.0 + radius * (sin(here.yaw) - sin(0.3)), abs=1e-7)
    assert here.y == pytest.approx(2.0 - radius * (cos(here.yaw) - cos(0.3)), abs=1e-7)


def test_a_robot_drives_as_far_as_its_wheels_turn_and_not_into_a_wall() -> None:
    """900 counts are one turn of a wheel of 21 mm; a turn on the spot moves nothing."""
    room = Room()
    board = started(SimulatedBoard(room, place=AxlePose(1.0, 2.0, pi / 3)))
    right, _ = rolled(board)
    metres = right / 900 * 2 * pi * 0.021
    assert board.wheels.place.x == pytest.approx(1.0 + metres * cos(pi / 3))
    assert board.wheels.place.y == pytest.approx(2.0 + metres * sin(pi / 3))
    board.receive(drive_frame(MotorDrive.STOP))
    board.advance(0.5)

    before, counts = board.wheels.place, board.wheels.right
    right, _ = rolled(board, MotorDrive.LEFT)
    turned = (right - counts) / 900 * 2 * pi * 0.021 * 2 / 0.068
    assert board.wheels.place.yaw == pytest.approx(before.yaw + turned)
    assert (board.wheels.place.x, board.wheels.place.y) == pytest.approx((before.x, before.y))

    room.is_empty = False
    before, counts = board.wheels.place, board.wheels.right
    rolled(board, MotorDrive.BACKWARD)
    assert board.wheels.place == before
    assert board.wheels.right < counts


def test_a_wheel_takes_two_thirds_of_a_new_speed_in_its_lag_and_then_has_it() -> None:
    board = started(SimulatedBoard(chassis=Chassis(lag=0.1, walking=(300.0, 300.0))))
    board.receive(drive_frame(MotorDrive.FORWARD))
    board.advance(9 / 750)
    assert board.is_driving
    board.advance(3.0)
    before = board.wheels.right
    board.advance(1.0)
    assert board.wheels.right - before == pytest.approx(300.0, abs=1.0)
    board.receive(STOP)
    board.advance(9 / 750)
    before = board.wheels.right
    board.advance(3.0)
    assert board.wheels.right - before == pytest.approx(30.0, rel=0.05)  # the lag's integral: 0.1 s of 300


# --- its wire


def test_a_wire_without_faults_changes_nothing() -> None:
    wire = NoisyWire()
    assert (wire.to_host(STOP), wire.to_board(STOP)) == (STOP, STOP)


def test_a_noisy_wire_flips_one_bit_of_a_byte_and_repeats_by_its_seed() -> None:
    sent = bytes(range(256)) * 4
    for all_bytes in (NoisyWire(noise=1.0).to_host(sent), NoisyWire(noise=1.0).to_board(sent)):
        assert {(a ^ b).bit_count() for a, b in zip(sent, all_bytes, strict=True)} == {1}
        assert len({a ^ b for a, b in zip(sent, all_bytes, strict=True)}) == 8
    some = [NoisyWire(noise=0.1, seed=seed).to_host(sent) for seed in (1, 1, 2)]
    assert some[0] == some[1] != some[2]
    assert 50 < sum(a != b for a, b in zip(sent, some[0], strict=True)) < 150


def test_a_cutting_wire_drops_the_second_half_of_what_the_board_is_sent() -> None:
    wire = NoisyWire(cut=1.0)
    assert wire.to_board(b"123456789") == b"1234"
    assert wire.to_host(b"123456789") == b"123456789"
    often = NoisyWire(cut=0.3)
    assert 200 < sum(often.to_board(b"12") == b"1" for _ in range(1000)) < 400
