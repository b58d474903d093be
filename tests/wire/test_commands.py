"""The frames to the board are the bytes that were recorded and documented."""

import pytest

from devices.wire import commands
from devices.wire.checksum import checksum
from devices.wire.commands import Drive


def test_the_checksum_is_the_dallas_one() -> None:
    assert checksum(b"123456789") == 0xA1


@pytest.mark.parametrize(
    ("drive", "frame"),
    [
        (Drive.FORWARD, "AA BB 05 28 0F 7F F0 7F CC"),
        (Drive.BACKWARD, "AA BB 05 28 F0 7F 0F 7F A6"),
        (Drive.LEFT, "AA BB 05 28 0F 66 0F 66 88"),
        (Drive.RIGHT, "AA BB 05 28 F0 66 F0 66 E2"),
        (Drive.STOP, "AA BB 05 28 00 00 00 00 C6"),
    ],
)
def test_each_drive_is_its_recorded_frame(drive: Drive, frame: str) -> None:
    assert commands.motors(drive) == bytes.fromhex(frame)


@pytest.mark.parametrize(
    ("made", "frame"),
    [
        (commands.CONFIGURE, "aabb13c03f800000000000000000000040a0000003fdef"),
        (commands.PING, "aabb02412b5c"),
        (commands.head(90), "aabb0330105a97"),
        (commands.head(0), "aabb0330100032"),
        (commands.outputs(buzzer=True), "aabb02150472"),
        (commands.outputs(vibrate_left=True), "aabb021508d1"),
        (commands.outputs(vibrate_right=True), "aabb0215108e"),
        (commands.outputs(), "aabb02150013"),
        (commands.beep(440, 300), "aabb071701b80000012c4a"),
    ],
    ids=["config", "ping", "head-90", "head-0", "buzzer", "vib-l", "vib-r", "outputs-off", "beep"],
)
def test_each_command_is_its_recorded_frame(made: bytes, frame: str) -> None:
    assert made == bytes.fromhex(frame)


@pytest.mark.parametrize("angle", [-1, 181])
def test_the_head_is_not_told_what_would_wrap(angle: int) -> None:
    with pytest.raises(ValueError, match="0 to 180"):
        commands.head(angle)


def test_a_frame_that_the_board_could_not_take_is_not_made() -> None:
    with pytest.raises(ValueError, match="too long"):
        commands.frame(0x15, bytes(50))


def test_a_beep_that_does_not_fit_its_bytes_is_not_made() -> None:
    with pytest.raises(ValueError, match="no such beep"):
        commands.beep(70_000, 1)
