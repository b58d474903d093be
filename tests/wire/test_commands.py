"""The frames to the board are the recorded and documented bytes."""

from collections.abc import Callable

import pytest

from devices.wire import frames
from devices.wire.frames import MotorDrive, checksum


def test_the_checksum_is_the_dallas_one() -> None:
    assert checksum(b"123456789") == 0xA1


@pytest.mark.parametrize(
    ("drive", "frame"),
    [
        (MotorDrive.FORWARD, "AA BB 05 28 0F 7F F0 7F CC"),
        (MotorDrive.BACKWARD, "AA BB 05 28 F0 7F 0F 7F A6"),
        (MotorDrive.LEFT, "AA BB 05 28 0F 66 0F 66 88"),
        (MotorDrive.RIGHT, "AA BB 05 28 F0 66 F0 66 E2"),
        (MotorDrive.STOP, "AA BB 05 28 00 00 00 00 C6"),
    ],
)
def test_each_drive_is_its_recorded_frame(drive: MotorDrive, frame: str) -> None:
    assert frames.drive_frame(drive) == bytes.fromhex(frame)


@pytest.mark.parametrize(
    ("made", "frame"),
    [
        (lambda: frames.CONFIGURE, "aabb13c03f800000000000000000000040a0000003fdef"),
        (lambda: frames.PING, "aabb02412b5c"),
        (lambda: frames.head_frame(90), "aabb0330105a97"),
        (lambda: frames.head_frame(0), "aabb0330100032"),
        (lambda: frames.head_frame(180)[:-1], "aabb033010b4"),
    ],
    ids=["config", "ping", "head-90", "head-0", "head-180"],
)
def test_each_command_is_its_recorded_frame(made: Callable[[], bytes], frame: str) -> None:
    assert made() == bytes.fromhex(frame)


@pytest.mark.parametrize("angle", [-1, 181])
def test_a_head_angle_that_would_wrap_is_refused(angle: int) -> None:
    with pytest.raises(ValueError, match=r"^the head turns from 0 to 180$"):
        frames.head_frame(angle)


def test_a_frame_that_is_too_long_for_the_board_is_refused() -> None:
    with pytest.raises(ValueError, match="too long"):
        frames.encode_frame(0x15, bytes(50))


@pytest.mark.parametrize(
    ("motors", "right", "left"),
    [((1, 1), 0x0F, 0xF0), ((-1, -1), 0xF0, 0x0F), ((1, -1), 0x0F, 0x0F), ((-1, 1), 0xF0, 0xF0)],
)
def test_a_reversed_motor_is_commanded_the_other_way_round(
    motors: tuple[int, int], right: int, left: int
) -> None:
    wiring, other = frames.Wiring(motors=motors), {0x0F: 0xF0, 0xF0: 0x0F}
    ahead, back = (
        frames.drive_frame(each, wiring)[4:8] for each in (MotorDrive.FORWARD, MotorDrive.BACKWARD)
    )
    assert ahead == bytes((right, 0x7F, left, 0x7F))
    assert back == bytes((other[right], 0x7F, other[left], 0x7F))
    turn = frames.drive_frame(MotorDrive.LEFT, wiring)[4:8]
    assert turn == bytes((right, 0x66, other[left], 0x66))
    assert frames.drive_frame(MotorDrive.STOP, wiring) == frames.STOP
