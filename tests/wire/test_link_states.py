"""The table of the link's states, and what leads from one to the next."""

from __future__ import annotations

import struct
from collections.abc import Callable
from math import inf

import pytest

from devices.ports.robot import LinkNotice
from devices.wire.connection import BoardConnection, PortAction, Write
from devices.wire.frames import (
    CONFIGURE,
    FILLER,
    PING,
    STOP,
    MotorDrive,
    ReportKind,
    Wiring,
    drive_frame,
    encode_frame,
    head_frame,
)
from devices.wire.link_state import TRANSITIONS, LinkConfig, LinkState, LinkTrigger, next_state
from tests.wire.bench import FAR

S, H = LinkState, LinkTrigger


@pytest.mark.parametrize(
    ("state", "happening", "leads_to"),
    [
        (S.CLOSED, H.OPEN, S.OPENING),
        (S.OPENING, H.OPENED, S.WAITING),
        (S.OPENING, H.FAILED, S.LOST),
        (S.WAITING, H.READY, S.STREAMING),
        (S.WAITING, H.SILENCE, S.LOST),
        (S.WAITING, H.FAILED, S.LOST),
        (S.STREAMING, H.RESTARTED, S.WAITING),
        (S.STREAMING, H.SILENCE, S.LOST),
        (S.STREAMING, H.FAILED, S.LOST),
        (S.LOST, H.OPEN, S.OPENING),
        (S.LOST, H.FRAME_RECEIVED, S.WAITING),
        (S.LOST, H.RESTARTED, S.WAITING),
        *((state, H.CLOSE, S.CLOSED) for state in S),
    ],
)
def test_each_trigger_leads_to_its_state(state: S, happening: H, leads_to: S) -> None:
    assert next_state(state, happening) is leads_to


def test_nothing_leads_from_lost_to_streaming_but_a_greeting() -> None:
    assert {happening for (state, happening), to in TRANSITIONS.items() if to is S.STREAMING} == {H.READY}
    assert {state for (state, _), to in TRANSITIONS.items() if to is S.STREAMING} == {S.WAITING}


@pytest.mark.parametrize("act", [lambda c: c.drive(0, MotorDrive.FORWARD, FAR, 1.0), lambda c: c.stop(1.0)])
def test_a_closed_connection_drives_nothing_and_has_no_actions(
    act: Callable[[BoardConnection], object],
) -> None:
    connection = BoardConnection(LinkConfig())
    act(connection)

    assert (connection.driving_since, connection.actions(1.0)) == (None, [])


# --- at their exact times


def wheels_at(right: int, left: int) -> bytes:
    return encode_frame(ReportKind.ENCODERS.value, struct.pack(">hhHH", right, left, 0, 0))


def battery_at(millivolts: int) -> bytes:
    return encode_frame(ReportKind.POWER.value, struct.pack("<h", millivolts))


CONFIG_WANTED = encode_frame(ReportKind.CONFIG_WANTED.value, b"\x2b")
PINGED = encode_frame(ReportKind.PING.value, b"\x42")


def opened() -> BoardConnection:
    connection = BoardConnection(LinkConfig())
    connection.open()
    connection.opened(0.0)
    return connection


def written(connection: BoardConnection, *times: float) -> list[bytes]:
    """What is to be written at these times; nothing else is to be done."""
    actions = [each for now in times for each in connection.actions(now)]
    assert all(isinstance(each, Write) for each in actions)
    return [each.data for each in actions if isinstance(each, Write)]


def streaming() -> BoardConnection:
    """The board asked for its configuration at 2 s, and streams from 3 s on."""
    connection = opened()
    connection.received(CONFIG_WANTED, 2.0)
    assert written(connection, 2.0, 2.05, 2.1) == [CONFIGURE, STOP, STOP]
    connection.received(wheels_at(0, 0), 3.0)
    assert connection.take_notices() == [(LinkNotice.CONNECTED, "")]
    return connection


def test_a_board_that_does_not_answer_for_six_seconds_is_opened_again() -> None:
    connection = opened()
    assert connection.next_at(0.0) == 6.0
    assert (connection.actions(5.99), connection.state) == ([], LinkState.WAITING)
    assert written(connection, 6.0, 6.49) == [STOP, STOP]
    assert connection.state is LinkState.LOST
    assert connection.actions(6.5) == [PortAction.REOPEN]
    assert PortAction.REOPEN not in connection.actions(12.49)
    assert connection.actions(12.5) == [PortAction.REOPEN]
    assert connection.take_notices() == []
    connection.open()
    assert (connection.state, connection.actions(99.0)) == (LinkState.OPENING, [])
    connection.failed(100.0, "no port")
    assert PortAction.REOPEN not in connection.actions(100.49)
    assert connection.actions(100.5) == [PortAction.REOPEN]


def test_a_board_that_is_silent_for_half_a_second_is_lost_and_reported_once() -> None:
    connection = streaming()
    connection.actions(3.49)
    assert connection.state is LinkState.STREAMING
    connection.actions(3.5)
    assert (connection.state, connection.take_notices()) == (LinkState.LOST, [(LinkNotice.LOST, "silence")])
    connection.actions(9.49)
    assert connection.actions(9.5) == [PortAction.REOPEN]
    connection.failed(9.6, "unplugged")
    assert connection.take_notices() == []


@pytest.mark.parametrize(
    ("frame", "notice"),
    [(wheels_at(0, 0), LinkNotice.RESTORED), (CONFIG_WANTED, LinkNotice.RESTARTED)],
    ids=["streams", "asks"],
)
def test_a_board_that_is_back_is_greeted_before_its_frames_count(frame: bytes, notice: LinkNotice) -> None:
    connection = streaming()
    connection.actions(3.5)
    connection.take_notices()
    connection.received(frame, 4.0)
    assert connection.state is LinkState.WAITING
    greeting = [*([FILLER] if notice is LinkNotice.RESTORED else []), CONFIGURE, STOP, STOP]
    times = [4.0 + each * 0.05 for each in range(12)]
    sent = []
    for now in times:
        sent += written(connection, now)
        assert connection.state is LinkState.WAITING
        if len(sent) < len(greeting):
            connection.received(wheels_at(0, 0), now)  # it may be from before the greeting
    assert sent[: len(greeting)] == greeting
    connection.received(wheels_at(0, 0), 5.0)

    assert (connection.state, connection.take_notices()) == (LinkState.STREAMING, [(notice, "")])


def test_a_board_that_restarts_is_configured_again_and_its_permits_are_void() -> None:
    connection = streaming()
    permit = connection.permit
    assert connection.drive(permit, MotorDrive.FORWARD, 100.0, 3.1)
    connection.received(CONFIG_WANTED, 3.2)

    assert connection.take_notices() == [(LinkNotice.RESTARTED, "")]
    assert (connection.state, connection.driving_since) == (LinkState.WAITING, None)
    assert not connection.drive(permit, MotorDrive.FORWARD, 100.0, 3.3)
    assert not connection.drive(connection.permit, MotorDrive.FORWARD, 100.0, 3.3)
    assert written(connection, 3.3, 3.4, 3.5) == [CONFIGURE, STOP, STOP]


def test_a_drive_ends_where_it_is_to_end_or_where_it_is_not_renewed() -> None:
    connection = streaming()
    permit = connection.permit
    assert connection.drive(permit, MotorDrive.FORWARD, 100.0, 3.0)
    assert (connection.driving_since, connection.next_at(3.0)) == (3.0, 3.0)
    assert written(connection, 3.0) == [drive_frame(MotorDrive.FORWARD)]
    connection.received(wheels_at(50, 50), 3.1)
    assert connection.drive(permit, MotorDrive.FORWARD, 100.0, 3.2)
    assert connection.driving_since == 3.0
    connection.received(wheels_at(99, 100), 3.3)
    assert connection.driving_since == 3.0
    connection.received(wheels_at(100, 100), 3.4)
    assert connection.driving_since is None
    assert connection.drive(permit, MotorDrive.FORWARD, 100.0, 3.4)
    assert connection.driving_since is None

    assert connection.drive(permit, MotorDrive.FORWARD, 200.0, 3.5)
    connection.received(wheels_at(110, 110), 3.8)
    connection.actions(3.89)
    assert connection.driving_since == 3.5
    connection.received(wheels_at(115, 115), 3.9)
    assert STOP in written(connection, 3.9)
    assert connection.driving_since is None


def test_a_drive_to_where_the_wheels_are_already_ends_the_one_before() -> None:
    connection = streaming()
    assert connection.drive(connection.permit, MotorDrive.FORWARD, 200.0, 3.0)
    assert written(connection, 3.0) == [drive_frame(MotorDrive.FORWARD)]
    connection.received(wheels_at(50, 50), 3.1)
    connection.received(wheels_at(100, 100), 3.2)
    assert connection.drive(connection.permit, MotorDrive.FORWARD, 100.0, 3.2)

    assert connection.driving_since is None
    assert written(connection, 3.2, 3.3) == [STOP, STOP]
    assert not connection.is_standing
    connection.received(wheels_at(100, 100), 3.4)
    written(connection, 3.4)
    assert connection.is_standing


@pytest.mark.parametrize(
    ("frame", "stands"),
    [
        (battery_at(8000), False),  # says nothing of the wheels
        (wheels_at(400, 400), False),  # so far at once that a second frame must confirm it
        (wheels_at(110, 110), False),
        (wheels_at(100, 100), True),
    ],
)
def test_wheels_that_were_not_seen_for_a_while_stand_only_if_their_counts_are_the_same(
    frame: bytes, stands: bool
) -> None:
    """After a pause of the link, such as that of a network, shorter than a lost one."""
    connection = streaming()
    assert connection.drive(connection.permit, MotorDrive.FORWARD, FAR, 3.0)
    written(connection, 3.0)
    connection.received(wheels_at(50, 50), 3.1)
    connection.received(wheels_at(100, 100), 3.2)
    connection.stop(3.2)
    written(connection, 3.2, 3.21, 3.22)
    connection.received(frame, 3.5)
    written(connection, 3.5)

    assert connection.is_standing is stands


def test_the_first_counts_after_a_loss_are_no_sign_that_the_wheels_stand() -> None:
    """They only say where the wheels are; the next ones say whether they turn."""
    connection = streaming()
    assert connection.drive(connection.permit, MotorDrive.FORWARD, FAR, 3.0)
    connection.received(wheels_at(50, 50), 3.1)
    connection.actions(3.7)
    assert connection.state is LinkState.LOST
    connection.received(battery_at(8000), 4.0)
    for now in range(400, 420):
        connection.actions(now / 100)
    stands = []
    for now in (4.25, 4.3, 4.375):
        connection.received(wheels_at(500, 500), now)
        connection.actions(now)
        assert connection.state is LinkState.STREAMING
        stands.append(connection._stopping.is_over)

    assert stands == [False, False, True]


def test_a_board_that_restarts_stands_and_has_six_seconds_to_answer() -> None:
    connection = streaming()
    connection.drive(connection.permit, MotorDrive.FORWARD, 100.0, 3.0)
    written(connection, 3.0)
    epoch = connection.telemetry.epoch
    connection.received(wheels_at(7, 7), 3.05)
    connection.received(CONFIG_WANTED, 3.1)
    connection.received(wheels_at(70, 70), 3.1)
    assert (connection.telemetry.epoch > epoch, connection.telemetry.right) == (True, 7)
    assert written(connection, 3.1, 3.2, 3.3) == [CONFIGURE, STOP, STOP]
    assert connection.is_standing
    connection.take_notices()
    connection.actions(9.09)
    assert connection.state is LinkState.WAITING
    connection.actions(9.1)

    assert (connection.state, connection.take_notices()) == (LinkState.LOST, [(LinkNotice.LOST, "no answer")])


def test_a_board_that_restarted_before_its_port_was_opened_again_is_just_back() -> None:
    connection = streaming()
    connection.actions(3.5)
    connection.received(CONFIG_WANTED, 4.0)
    connection.failed(4.1, "unplugged")
    connection.take_notices()
    connection.open()
    connection.opened(5.0)
    connection.received(wheels_at(0, 0), 5.1)
    assert written(connection, 5.1, 5.25, 5.3, 5.4) == [FILLER, CONFIGURE, STOP, STOP]
    connection.received(wheels_at(0, 0), 5.5)

    assert connection.take_notices() == [(LinkNotice.RESTORED, "")]


def test_a_lost_link_forgets_what_may_have_changed_meanwhile() -> None:
    connection = streaming()
    for right in (10, 20):
        connection.received(wheels_at(right, right), 3.1)
    epoch = connection.telemetry.epoch
    connection.failed(3.2, "unplugged")
    assert (connection.telemetry.right, connection.telemetry.epoch) == (20, epoch + 1)
    connection.failed(3.3, "unplugged")
    connection.received(wheels_at(500, 500), 4.0)

    assert connection.telemetry.right == 20


def test_a_robot_that_is_wired_in_another_way_stops_and_is_counted_and_driven_that_way() -> None:
    connection = streaming()
    connection.drive(connection.permit, MotorDrive.FORWARD, 100.0, 3.0)
    connection.received(wheels_at(10, 20), 3.05)
    permit, epoch = connection.permit, connection.telemetry.epoch
    connection.rewire(Wiring(encoders=(-1, 1), motors=(-1, -1)), 3.1)

    assert (connection.permit, connection.driving_since) == (permit + 1, None)
    assert (connection.telemetry.right, connection.telemetry.epoch) == (10, epoch + 1)
    for right, left in ((30, 20), (40, 25)):
        connection.received(wheels_at(right, left), 3.2)
    assert (connection.telemetry.right, connection.telemetry.left) == (0, 25)
    written(connection, 3.3, 3.4)
    connection.drive(connection.permit, MotorDrive.FORWARD, 100.0, 3.45)
    assert written(connection, 3.45) == [drive_frame(MotorDrive.BACKWARD)]


def test_a_low_battery_is_reported_once_until_it_is_charged_and_by_two_frames_that_agree() -> None:
    connection, noticed = streaming(), {}
    frames = (7100, 7100, 7099, 7000, 7040, 7040, 7399, 7399, 7000, 7000, 7400, 7400, 6940, 6940, 6940)
    for number, millivolts in enumerate(frames):
        connection.received(battery_at(millivolts), 3.0)
        if notices := connection.take_notices():
            noticed[number] = notices

    assert noticed == {5: [(LinkNotice.BATTERY_LOW, "7.0")], 13: [(LinkNotice.BATTERY_LOW, "6.9")]}
    connection.received(battery_at(8000), 3.0)
    assert connection.telemetry.millivolts == 6940


def test_a_ping_is_answered_and_other_frames_are_sent_only_to_a_board_that_streams() -> None:
    connection = opened()
    connection.put(head_frame(10))
    assert written(connection, 1.0) == []

    connection = streaming()
    assert written(connection, 3.0) == [STOP]  # as it repeats the drive command
    connection.put(head_frame(10))
    assert written(connection, 3.05) == [head_frame(10)]
    connection.received(PINGED, 3.1)
    assert written(connection, 3.1) == [PING]


def test_only_the_frames_of_a_stop_are_urgent() -> None:
    connection = streaming()
    connection.put(head_frame(10))
    assert connection.urgent(3.1) == []
    connection.stop(3.1)
    assert connection.urgent(3.1) == [Write(STOP)]
    assert not connection.is_standing
    assert (connection.urgent(3.2), connection.urgent(3.3)) == ([Write(STOP)], [])
    assert (connection.is_standing, connection.is_stop_over) == (True, True)

    waiting = opened()
    waiting.stop(1.0)
    assert waiting.urgent(1.0) == []


def test_a_closed_connection_has_nothing_to_do() -> None:
    connection = streaming()
    connection.drive(connection.permit, MotorDrive.FORWARD, 100.0, 3.1)
    permit = connection.permit
    connection.close(3.2)
    for right in (500, 600):
        connection.received(wheels_at(right, right), 3.3)

    assert (connection.state, connection.permit, connection.driving_since) == (
        LinkState.CLOSED, permit + 1, None,
    )  # fmt: skip
    assert (connection.actions(99.0), connection.telemetry.right) == ([], 0)
    connection.failed(99.0, "too late")
    assert (connection.state, connection.take_notices()) == (LinkState.CLOSED, [])


def test_what_a_lost_link_leaves_is_known_until_the_board_is_back() -> None:
    for is_driving in (True, False):
        connection = streaming()
        if is_driving:
            connection.drive(connection.permit, MotorDrive.FORWARD, 100.0, 3.1)
        connection.failed(3.2, "unplugged")
        assert connection.may_drive_on is is_driving
        assert connection.take_notices() == [(LinkNotice.LOST, "unplugged")]
        connection.failed(3.3, "unplugged")
        assert connection.may_drive_on is is_driving
        connection.received(wheels_at(0, 0), 4.0)
        assert written(connection, 4.0, 4.2, 4.3, 4.4) == [FILLER, CONFIGURE, STOP, STOP]
        assert connection.may_drive_on is is_driving
        connection.received(wheels_at(0, 0), 4.5)
        assert not connection.may_drive_on


def test_a_robot_that_was_just_stopped_may_drive_on_where_the_link_is_lost() -> None:
    connection = streaming()
    connection.drive(connection.permit, MotorDrive.FORWARD, 100.0, 3.1)
    connection.stop(3.2)
    connection.failed(3.2, "unplugged")

    assert connection.may_drive_on


def test_a_line_about_a_wrong_checksum_repeats_the_drive_at_once() -> None:
    lines: list[str] = []
    connection = streaming()
    connection._on_text = lines.append
    connection.drive(connection.permit, MotorDrive.LEFT, 100.0, 3.0)
    assert written(connection, 3.0, 3.1) == [drive_frame(MotorDrive.LEFT)]
    connection.received(b"\nChecksum Error!\n", 3.1)

    assert written(connection, 3.1) == [drive_frame(MotorDrive.LEFT)]
    assert lines == ["Checksum Error!"]


def test_a_connection_says_when_it_has_something_to_do() -> None:
    connection = BoardConnection(LinkConfig())
    assert connection.next_at(1.0) == inf
    connection.open()
    assert connection.next_at(1.0) == inf
    connection.opened(1.0)
    assert (connection.next_at(1.0), connection.next_at(9.0)) == (7.0, 9.0)

    connection = streaming()
    assert written(connection, 3.0) == [STOP]
    assert connection.next_at(3.0) == pytest.approx(3.2)  # the drive command is repeated
    assert written(connection, 3.21, 3.42) == [STOP, STOP]
    assert connection.next_at(3.42) == pytest.approx(3.5)  # then the board is silent for too long
    connection.received(wheels_at(0, 0), 3.4)
    connection.drive(connection.permit, MotorDrive.FORWARD, 100.0, 3.4)
    assert written(connection, 3.47) == [drive_frame(MotorDrive.FORWARD)]
    connection.received(wheels_at(1, 1), 3.6)
    assert written(connection, 3.68) == [drive_frame(MotorDrive.FORWARD)]
    assert connection.next_at(3.68) == pytest.approx(3.8)  # the drive was not renewed
    connection.close(3.9)
    assert written(connection, 4.0) == []

    waiting = opened()
    waiting.close(1.0)
    assert waiting.next_at(1.0) == inf


def test_a_board_that_has_restarted_is_not_reported_as_back_too() -> None:
    connection = streaming()
    connection.received(CONFIG_WANTED, 3.1)
    assert connection.take_notices() == [(LinkNotice.RESTARTED, "")]
    assert written(connection, 3.1, 3.2, 3.3) == [CONFIGURE, STOP, STOP]
    connection.received(wheels_at(0, 0), 3.4)

    assert (connection.state, connection.take_notices()) == (LinkState.STREAMING, [])
    assert connection.telemetry.frames == 4


def test_a_port_that_is_opened_again_is_sent_nothing_of_before() -> None:
    connection = streaming()
    connection.put(head_frame(10))
    connection.received(PINGED[:3], 3.05)
    connection.failed(3.1, "unplugged")
    connection.open()
    connection.opened(4.0)
    connection.received(PINGED[3:] + wheels_at(7, 7), 4.1)  # no end of the frame from before

    assert written(connection, 4.1, 4.25, 4.3, 4.4, 4.5) == [FILLER, CONFIGURE, STOP, STOP]
    assert (connection.telemetry.right, connection.telemetry.bad_frames) == (0, 0)


def test_a_text_of_the_firmware_is_a_line_for_the_log() -> None:
    lines: list[str] = []
    connection = BoardConnection(LinkConfig(), lines.append)
    connection.open()
    connection.opened(0.0)
    connection.received(encode_frame(ReportKind.MESSAGE.value, b"Beep\xff"), 1.0)

    assert lines == ["Beep\\xff"]


def test_the_times_of_a_link_are_those_of_the_documentation() -> None:
    """docs/wire-protocol.md, "What can go wrong, and what Donnie does"."""
    config = LinkConfig()

    assert (config.first_answer, config.flush_pause) == (6.0, 0.1)  # open
    assert config.tick_jump == 60  # ticks
    assert (config.gap, config.most_outstanding) == (0.04, 63)  # rate
    assert config.repeat == 0.2  # lost command
    assert config.runaway == 0.5  # stop
    assert (config.lease, config.silence) == (0.4, 0.5)  # host watchdog
    assert config.reopen == 0.5  # unplug
    assert config.longest_stop == pytest.approx(2.2, abs=0.05)  # shutdown
    slower = config.slower(4.0)
    assert slower.longest_stop == pytest.approx(8.8, abs=0.2)
    assert (slower.first_answer, slower.silence, slower.lease, slower.runaway) == (24.0, 2.0, 1.6, 2.0)
    assert (slower.gap, slower.repeat, slower.flush_pause, slower.reopen) == (0.04, 0.2, 0.1, 0.5)
