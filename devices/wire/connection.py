"""The connection to a board as a state machine without I/O: bytes, requests and times in, actions out.

It owns the states, the handshake, the stop and every time limit. A drive ends at the place that it names,
when it is not renewed, when the link is lost and when the board restarts. It never resumes by itself. Not
thread-safe: its owner holds a lock.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum, auto
from math import inf
from typing import TypeAlias, assert_never

from msgspec import Struct

from devices.ports.robot import LinkNotice
from devices.wire.frames import (
    PING,
    Bumpers,
    ConfigWanted,
    Decoder,
    Encoders,
    Message,
    MotorDrive,
    Outputs,
    Pinged,
    Power,
    Ranges,
    Report,
    Wiring,
)
from devices.wire.link_state import LinkConfig, LinkState, LinkTrigger, next_state
from devices.wire.outbox import Outbox, StopSequence
from devices.wire.telemetry import TelemetryTracker


class PortAction(Enum):
    """What the owner of the port has to do, besides writing."""

    RESET = auto()
    """Restart the board by its reset wire, if there is one."""
    REOPEN = auto()
    """Close the port, where it is open, and open it again."""


class Write(Struct, frozen=True):
    """Bytes to be written at once, all of them."""

    data: bytes


Action: TypeAlias = Write | PortAction


def travelled(drive: MotorDrive, right: int, left: int) -> float:
    """How far the wheels went in the direction of ``drive``: the mean of both, in counts."""
    match drive:
        case MotorDrive.FORWARD:
            return (right + left) / 2
        case MotorDrive.BACKWARD:
            return -(right + left) / 2
        case MotorDrive.LEFT:
            return (right - left) / 2
        case MotorDrive.RIGHT:
            return (left - right) / 2
        case MotorDrive.STOP:
            return 0.0
        case never:
            assert_never(never)


class BoardConnection:
    """One connection to one board. All times are seconds on one clock that never runs backward."""

    def __init__(self, config: LinkConfig, on_text: Callable[[str], None] | None = None) -> None:
        """``on_text`` receives the board's debug text, line by line, for a log."""
        self._config = config
        self._on_text = on_text
        self.state = LinkState.CLOSED
        self.permit = 0
        """What a drive must name. It changes whenever all earlier requests become void."""
        self.driving_since: float | None = None
        """When the wheels were commanded to turn; None while they are to stand."""
        self._decoder = Decoder(self._take_text)
        self._outbox = Outbox(config)
        self._stopping = StopSequence(config, self._outbox)
        self._tracker = TelemetryTracker(config)
        self.telemetry = self._tracker.telemetry(0.0, 0)
        self._drive, self._until, self._lease_ends = MotorDrive.STOP, 0.0, inf
        self._notices: list[tuple[LinkNotice, str]] = []
        self._was_up = self._is_loss_reported = self._is_low_reported = False
        self._has_restarted = False
        """Whether the board restarted by itself while the link was lost; reported when the link is back."""
        self._received_at = 0.0
        self._deadline = inf
        self._is_greeting = self._is_greeted = False
        self._millivolts: int | None = None
        self.may_drive_on = False
        """Whether the link was lost while the wheels were to turn, and they were not stopped since."""
        self._is_runaway_reported = False

    @property
    def has_run_away(self) -> bool:
        """Whether the wheels turn although all was done that can be."""
        return self._stopping.has_failed

    @property
    def is_standing(self) -> bool:
        """Whether a stop is complete: all its frames were sent, and the wheels were seen to stand."""
        can_not_send = self.state in (LinkState.CLOSED, LinkState.OPENING)
        return self._stopping.is_over and (can_not_send or not self._outbox.has_stops)

    @property
    def longest_stop(self) -> float:
        """The most seconds to wait for a stop; without a link those of the default timeouts."""
        return (self._config if self.state is LinkState.STREAMING else LinkConfig()).longest_stop

    @property
    def is_stop_over(self) -> bool:
        """Whether the robot stands, or all was done that can be, and no notice waits for its owner."""
        return not self._notices and (self.is_standing or self._stopping.is_exhausted)

    # --- for the owner of the port: what happened to it

    def open(self) -> None:
        """The owner begins to open the port. ``opened`` or ``failed`` follows."""
        self._trigger(LinkTrigger.OPEN)

    def opened(self, now: float) -> None:
        self._decoder = Decoder(self._take_text)
        self._outbox.clear()
        self._tracker.rebase()
        self._await_answer(now)
        self._has_restarted = False
        self._trigger(LinkTrigger.OPENED)

    def failed(self, now: float, reason: str) -> None:
        """The port couldn't be opened, read or written. It will be tried again."""
        if self.state in (LinkState.OPENING, LinkState.WAITING, LinkState.STREAMING, LinkState.LOST):
            self._lose(LinkTrigger.FAILED, now, reason)
            self._deadline = now + self._config.reopen

    def received(self, data: bytes, now: float) -> None:
        """Take in the bytes that arrived."""
        if self.state in (LinkState.CLOSED, LinkState.OPENING):
            return
        for report in self._decoder.feed(data):
            self._take(report, now)
        self.telemetry = self._tracker.telemetry(self._received_at, self._decoder.bad_frames)

    def actions(self, now: float) -> list[Action]:
        """What is to be done now."""
        self._check_deadlines(now)
        done: list[Action] = []
        if self.state in (LinkState.OPENING, LinkState.CLOSED):
            return done
        if self.state is LinkState.LOST and now >= self._deadline:
            self._deadline = now + self._config.first_answer
            return [PortAction.REOPEN]
        if self._stopping.must_force(now, self._tracker.counted_at, self._tracker.changed_at):
            done.append(PortAction.RESET)
        self._report_runaway()
        return done + self._due(now)

    def urgent(self, now: float) -> list[Action]:
        """The frames of a stop that are due before the received bytes are read.

        Deadlines are not checked and the handshake does not proceed: bytes from before its last frame would
        be taken for the answer.
        """
        is_up = self.state is LinkState.STREAMING
        return self._due(now) if is_up and self._outbox.has_stops else []

    def _due(self, now: float) -> list[Action]:
        frame = self._outbox.due(now)
        if frame is None:
            return []
        self._is_greeted = self._is_greeting and self._outbox.is_empty
        return [Write(frame)]

    def next_at(self, now: float) -> float:
        """When ``actions`` has something to do at the latest, if nothing comes in before."""
        times = [self._lease_ends, self._deadline, self._stopping.next_at() or inf, self._silent_at()]
        if self.state in (LinkState.WAITING, LinkState.STREAMING, LinkState.LOST):
            times.append(self._outbox.next_at(now))
        return max(now, min(times))

    def take_notices(self) -> list[tuple[LinkNotice, str]]:
        """The notices since the last call, each with its reason or an empty string."""
        notices, self._notices = self._notices, []
        return notices

    def forced(self, now: float) -> None:
        """The owner has carried out ``PortAction.RESET``, as far as it could."""
        self._stopping.forced(now)

    def close(self, now: float) -> None:
        """The owner closes the port, after all frames were sent."""
        self.stop(now)
        self._trigger(LinkTrigger.CLOSE)
        self._deadline = inf
        self._was_up = self._is_loss_reported = False

    # --- for the robot: what it requests

    def drive(self, permit: int, drive: MotorDrive, until: float, now: float) -> bool:
        """Turn the wheels in that direction until they ``travelled`` to ``until``. It must be renewed.

        False, and nothing is driven, if the permit is void.
        """
        if permit != self.permit or self.state is not LinkState.STREAMING:
            return False
        self._drive, self._until = drive, until
        if self._has_arrived():
            if self.driving_since is not None:
                self._end_drive(now)
            return True
        self._lease_ends = now + self._config.lease
        if self.driving_since is None:
            self.driving_since = now
        self._stopping.cancel()
        self._outbox.drive(drive, now)
        return True

    def stop(self, now: float) -> None:
        """Turn the wheels off, and make every permit void."""
        self.permit += 1
        self._end_drive(now)

    def rewire(self, wiring: Wiring, now: float) -> None:
        """Stop the robot; from now on its commands and counts are those of that wiring."""
        self.stop(now)
        self._outbox.wiring, self._tracker.encoders = wiring, wiring.encoders
        self._tracker.rebase()
        self.telemetry = self._tracker.telemetry(self._received_at, self._decoder.bad_frames)

    def put(self, frame: bytes) -> None:
        """Queue another frame to be sent when there is time."""
        if self.state is LinkState.STREAMING:
            self._outbox.put(frame)

    # --- reports of the board

    def _take(self, report: Report, now: float) -> None:
        self._received_at = now
        self._tracker.frames += 1
        match report:
            case ConfigWanted():
                self._board_restarted(now)
                return
            case Encoders(right=right, left=left):
                self._tracker.count_wheels(right, left, now)
                if self.driving_since is not None and self._has_arrived():
                    self._end_drive(now)
            case Ranges(centimetres=centimetres):
                self._tracker.add_ranges(centimetres, now)
            case Bumpers(pressed=pressed):
                self._tracker.add_bumpers(pressed)
            case Power(millivolts=millivolts):
                self._take_power(millivolts)
            case Pinged():
                self._outbox.put(PING)
            case Message(text=text):
                self._take_text(text.decode("ascii", "backslashreplace"))
            case Outputs():
                pass
            case never:
                assert_never(never)
        self._continue_handshake(now)

    def _continue_handshake(self, now: float) -> None:
        """A frame came from a board that streams, perhaps without having been asked to."""
        if self.state is LinkState.LOST:
            self._trigger(LinkTrigger.FRAME_RECEIVED)
            self._await_answer(now)
        if self.state is not LinkState.WAITING:
            return
        if not self._is_greeting:
            self._outbox.flush()
            self._greet()
            self._stopping.restart(now)
        elif self._is_greeted:  # a frame that comes after the whole greeting was sent answers it
            self._ready()

    def _board_restarted(self, now: float) -> None:
        """The board asks for its configuration: it has just started, with motors off and counts at zero."""
        self.stop(now)
        self._stopping.cancel()
        self._tracker.rebase()
        if self.state is LinkState.STREAMING:
            self._notices.append((LinkNotice.RESTARTED, ""))
        self._has_restarted = self._has_restarted or self.state is LinkState.LOST
        if self.state is not LinkState.WAITING:
            self._trigger(LinkTrigger.RESTARTED)
        self._await_answer(now)
        self._greet()

    def _greet(self) -> None:
        self._is_greeting, self._is_greeted = True, False
        self._outbox.configure()
        self._outbox.stop()

    def _await_answer(self, now: float) -> None:
        self._is_greeting = self._is_greeted = False
        self._deadline = now + self._config.first_answer

    def _ready(self) -> None:
        self._trigger(LinkTrigger.READY)
        self._deadline = inf
        if not self._was_up:
            self._notices.append((LinkNotice.CONNECTED, ""))
        elif self._is_loss_reported:
            self._notices.append((LinkNotice.RESTARTED if self._has_restarted else LinkNotice.RESTORED, ""))
        self._was_up, self._is_loss_reported, self._has_restarted = True, False, False
        self.may_drive_on = False

    def _take_power(self, millivolts: int) -> None:
        """Believes two samples that agree; reports a low battery once until it is charged."""
        is_confirmed, self._millivolts = millivolts == self._millivolts, millivolts
        if not is_confirmed:
            return
        self._tracker.millivolts = millivolts
        if millivolts >= self._config.battery_fine:
            self._is_low_reported = False
        elif millivolts < self._config.battery_low and not self._is_low_reported:
            self._is_low_reported = True
            self._notices.append((LinkNotice.BATTERY_LOW, f"{millivolts / 1000:.1f}"))

    def _take_text(self, text: str) -> None:
        if "Checksum Error" in text:
            self._outbox.repeat_soon()
        if self._on_text is not None:
            self._on_text(text)

    # --- drives, deadlines, losses

    def _has_arrived(self) -> bool:
        return travelled(self._drive, self._tracker.right, self._tracker.left) >= self._until

    def _end_drive(self, now: float) -> None:
        self._stopping.begin(now, was_driving=self.driving_since is not None)
        self.driving_since, self._lease_ends = None, inf

    def _report_runaway(self) -> None:
        """Once for each stop that failed."""
        if self.has_run_away and not self._is_runaway_reported:
            self._notices.append((LinkNotice.RUNAWAY, ""))
        self._is_runaway_reported = self.has_run_away

    def _lose(self, trigger: LinkTrigger, now: float, reason: str) -> None:
        self.may_drive_on = self.may_drive_on or self.driving_since is not None or not self._stopping.is_over
        self.stop(now)
        self._stopping.lost()
        self._trigger(trigger)
        self._tracker.rebase()
        self.telemetry = self._tracker.telemetry(self._received_at, self._decoder.bad_frames)
        if self._was_up and not self._is_loss_reported:
            self._is_loss_reported = True
            self._notices.append((LinkNotice.LOST, reason))

    def _check_deadlines(self, now: float) -> None:
        if now >= self._lease_ends:
            self._end_drive(now)
        if now >= self._silent_at():
            self._lose(LinkTrigger.SILENCE, now, "silence")
            self._deadline = now + self._config.first_answer
        elif self.state is LinkState.WAITING and now >= self._deadline:
            self._lose(LinkTrigger.SILENCE, now, "no answer")
            self._deadline = now + self._config.reopen

    def _silent_at(self) -> float:
        return self._received_at + self._config.silence if self.state is LinkState.STREAMING else inf

    def _trigger(self, trigger: LinkTrigger) -> None:
        self.state = next_state(self.state, trigger)
