"""The line to a board as a machine without a line: bytes, wishes and the time go in, actions come out.

It owns the states, the handshake, the stop and every time limit. Rules: a drive ends where it was told to,
when nobody renews it, when the line is lost and when the board restarts; and it is never taken up again
without somebody asking anew. Not thread-safe: its owner holds a lock.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum, auto
from math import inf
from typing import TypeAlias, assert_never

from devices.ports.robot import LinkNews
from devices.ports.values import Frozen
from devices.wire.commands import PING, Drive
from devices.wire.decoder import Decoder
from devices.wire.link_config import LinkConfig
from devices.wire.link_state import Happening, LinkState, following
from devices.wire.outbox import Outbox
from devices.wire.reports import (
    Bumpers,
    ConfigWanted,
    Encoders,
    Message,
    Outputs,
    Pinged,
    Power,
    Ranges,
    Report,
)
from devices.wire.stopping import Stopping
from devices.wire.telemetry import Instruments

News: TypeAlias = tuple[LinkNews, str]


class Need(Enum):
    """What the owner of the line has to do, besides writing."""

    FORCE = auto()
    """Stop the board by its reset line, if there is one."""
    REOPEN = auto()
    """Close the port, where it is open, and open it again."""


class Write(Frozen):
    """Bytes to be written at once, all of them."""

    data: bytes


Action: TypeAlias = Write | Need


def travelled(drive: Drive, right: int, left: int) -> float:
    """How far the wheels went in the sense of ``drive``: the mean of both, in counts."""
    match drive:
        case Drive.FORWARD:
            return (right + left) / 2
        case Drive.BACKWARD:
            return -(right + left) / 2
        case Drive.LEFT:
            return (right - left) / 2
        case Drive.RIGHT:
            return (left - right) / 2
        case Drive.STOP:
            return 0.0
        case never:
            assert_never(never)


class Connection:
    """One line to one board. All times are seconds on one clock that never goes back."""

    def __init__(self, config: LinkConfig, on_text: Callable[[str], None] | None = None) -> None:
        """``on_text`` is told the board's debug text, line by line; for a log."""
        self._config = config
        self._on_text = on_text
        self.state = LinkState.CLOSED
        self.permit = 0
        """What a drive must name: it changes whenever everything that was asked before is void."""
        self.driving_since: float | None = None
        """When the wheels were told to turn; None while they are to stand."""
        self._decoder = Decoder(self._take_text)
        self._outbox = Outbox(config)
        self._stopping = Stopping(config, self._outbox)
        self._instruments = Instruments(config)
        self.telemetry = self._instruments.telemetry(0.0, 0)
        self._drive, self._until, self._lease_ends = Drive.STOP, 0.0, inf
        self._news: list[News] = []
        self._was_up = self._is_told_lost = self._is_told_low = False
        self._has_restarted = False
        """While the line was lost, and by itself: that is what is told when it is back."""
        self._heard_at = 0.0
        self._deadline = inf
        self._greets = self._is_greeted = False
        self._millivolts: int | None = None
        self._now = 0.0

    @property
    def is_standing(self) -> bool:
        """Whether nothing is left to be done for a stop: all was said, and the wheels were seen to stand."""
        is_mute = self.state in (LinkState.CLOSED, LinkState.OPENING)
        return self._stopping.is_over and (is_mute or not self._outbox.has_stops)

    # --- the owner's side: what happened to the port

    def open(self, now: float) -> None:
        """Somebody wants the port open. ``opened`` or ``failed`` is to follow."""
        self._happens(Happening.OPEN, now)

    def opened(self, now: float) -> None:
        self._decoder = Decoder(self._take_text)
        self._outbox.clear()
        self._instruments.rebase()
        self._await_answer(now)
        self._has_restarted = False
        self._happens(Happening.OPENED, now)

    def failed(self, now: float, reason: str) -> None:
        """The port couldn't be opened, read or written. Raises nothing; it is tried again."""
        if self.state in (LinkState.OPENING, LinkState.WAITING, LinkState.STREAMING, LinkState.LOST):
            self._lose(Happening.FAILED, now, reason)
            self._deadline = now + self._config.reopen

    def received(self, data: bytes, now: float) -> None:
        """Take whatever came in."""
        if self.state in (LinkState.CLOSED, LinkState.OPENING):
            return
        self._now = now
        for report in self._decoder.feed(data):
            self._take(report, now)
        self.telemetry = self._instruments.telemetry(self._heard_at, self._decoder.bad_frames)

    def actions(self, now: float) -> list[Action]:
        """What is to be done now."""
        self._look_at_the_time(now)
        done: list[Action] = []
        if self.state in (LinkState.OPENING, LinkState.CLOSED):
            return done
        if self.state is LinkState.LOST and now >= self._deadline:
            self._deadline = now + self._config.first_answer
            return [Need.REOPEN]
        if self._stopping.goes_on(now, self._heard_at, self._instruments.moved_at):
            done.append(Need.FORCE)
        return done + self._due(now)

    def urgent(self, now: float) -> list[Action]:
        """What is due of a stop, before anybody reads what came in. Nothing is judged by the time yet, and
        no handshake goes on: what came before its last frame would be taken for the answer."""
        is_up = self.state is LinkState.STREAMING
        return self._due(now) if is_up and self._outbox.has_stops else []

    def _due(self, now: float) -> list[Action]:
        frame = self._outbox.due(now)
        if frame is None:
            return []
        self._watch_handshake()
        return [Write(frame)]

    def next_at(self, now: float) -> float:
        """When ``actions`` has something to do at the latest, if nothing comes in before."""
        times = [self._lease_ends, self._deadline, self._stopping.next_at() or inf, self._silent_at()]
        if self.state in (LinkState.WAITING, LinkState.STREAMING, LinkState.LOST):
            times.append(self._outbox.next_at(now))
        return max(now, min(times))

    def take_news(self) -> list[News]:
        """What is to be told, each thing once."""
        news, self._news = self._news, []
        return news

    # --- the robot's side: what it wants

    def drive(self, permit: int, drive: Drive, until: float, now: float) -> bool:
        """Turn the wheels that way until they ``travelled`` to ``until``; to be renewed while it goes on.

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
        self._stopping.forget()
        self._outbox.drive(drive, now)
        return True

    def stop(self, now: float) -> None:
        """Wheels off, and every permit is void."""
        self.permit += 1
        self._end_drive(now)

    def put(self, frame: bytes) -> None:
        """Have another frame sent when there is time."""
        if self.state is LinkState.STREAMING:
            self._outbox.put(frame)

    def close(self, now: float) -> None:
        """The port is closed. What was to be said on it, was."""
        self.stop(now)
        self._happens(Happening.CLOSE, now)
        self._deadline = inf
        self._was_up = self._is_told_lost = False

    # --- inside

    def _take(self, report: Report, now: float) -> None:
        self._heard_at = now
        self._instruments.heard()
        match report:
            case ConfigWanted():
                self._restarted(now)
                return
            case Encoders(right=right, left=left):
                self._instruments.counted(right, left, now)
                if self.driving_since is not None and self._has_arrived():
                    self._end_drive(now)
            case Ranges(centimetres=centimetres):
                self._instruments.measured(centimetres, now)
            case Bumpers(pressed=pressed):
                self._instruments.touched(pressed)
            case Power(millivolts=millivolts):
                self._powered(millivolts)
            case Pinged():
                self._outbox.put(PING)
            case Message(text=text):
                self._take_text(text.decode("ascii", "backslashreplace"))
            case Outputs():
                pass
            case never:
                assert_never(never)
        self._heard_frame(now)

    def _heard_frame(self, now: float) -> None:
        """A frame of a board that streams, whether or not it was asked to."""
        if self.state is LinkState.LOST:
            self._happens(Happening.HEARD, now)
            self._await_answer(now)
        if self.state is not LinkState.WAITING:
            return
        if not self._greets:
            self._outbox.flush()
            self._greet()
        elif self._is_greeted:
            self._ready(now)

    def _restarted(self, now: float) -> None:
        """The board asks for its configuration: it has just begun, its motors off and its counts at zero."""
        self._void(now)
        self._stopping.forget()
        self._instruments.rebase()
        if self.state is LinkState.STREAMING:
            self._news.append((LinkNews.RESTARTED, ""))
        self._has_restarted = self._has_restarted or self.state is LinkState.LOST
        if self.state is not LinkState.WAITING:
            self._happens(Happening.RESTARTED, now)
        self._await_answer(now)
        self._greet()

    def _greet(self) -> None:
        self._greets, self._is_greeted = True, False
        self._outbox.configure()
        self._outbox.stop()

    def _await_answer(self, now: float) -> None:
        self._greets = self._is_greeted = False
        self._deadline = now + self._config.first_answer

    def _watch_handshake(self) -> None:
        """A frame that comes once all of it was written is an answer, and none from before."""
        self._is_greeted = self._greets and self._outbox.is_empty

    def _ready(self, now: float) -> None:
        self._happens(Happening.READY, now)
        self._deadline = inf
        if not self._was_up:
            self._news.append((LinkNews.CONNECTED, ""))
        elif self._is_told_lost:
            self._news.append((LinkNews.RESTARTED if self._has_restarted else LinkNews.RESTORED, ""))
        self._was_up, self._is_told_lost, self._has_restarted = True, False, False

    def _lose(self, how: Happening, now: float, reason: str) -> None:
        self._void(now)
        self._happens(how, now)
        self._instruments.rebase()
        self.telemetry = self._instruments.telemetry(self._heard_at, self._decoder.bad_frames)
        if self._was_up and not self._is_told_lost:
            self._is_told_lost = True
            self._news.append((LinkNews.LOST, reason))

    def _void(self, now: float) -> None:
        """Nothing that was asked for before is to be done."""
        self.permit += 1
        self._end_drive(now)

    def _end_drive(self, now: float) -> None:
        self._stopping.begin(now, was_driving=self.driving_since is not None)
        self.driving_since, self._lease_ends = None, inf

    def _has_arrived(self) -> bool:
        return travelled(self._drive, self._instruments.right, self._instruments.left) >= self._until

    def _look_at_the_time(self, now: float) -> None:
        if now >= self._lease_ends:
            self._end_drive(now)
        if self.state is LinkState.STREAMING and now >= self._silent_at():
            self._lose(Happening.SILENCE, now, "silence")
            self._deadline = now + self._config.first_answer
        elif self.state is LinkState.WAITING and now >= self._deadline:
            self._lose(Happening.SILENCE, now, "no answer")
            self._deadline = now + self._config.reopen

    def _silent_at(self) -> float:
        return self._heard_at + self._config.silence if self.state is LinkState.STREAMING else inf

    def _powered(self, millivolts: int) -> None:
        """Two samples that agree; told once until it is charged."""
        is_sure, self._millivolts = millivolts == self._millivolts, millivolts
        if not is_sure:
            return
        self._instruments.powered(millivolts)
        if millivolts >= self._config.battery_fine:
            self._is_told_low = False
        elif millivolts < self._config.battery_low and not self._is_told_low:
            self._is_told_low = True
            self._news.append((LinkNews.BATTERY_LOW, f"{millivolts / 1000:.1f}"))

    def _take_text(self, text: str) -> None:
        if "Checksum Error" in text:
            self._outbox.hurry(self._now)
        if self._on_text is not None:
            self._on_text(text)

    def _happens(self, happening: Happening, now: float) -> None:
        self._now = now
        self.state = following(self.state, happening)
