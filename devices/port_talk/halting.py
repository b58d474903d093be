"""Stops a robot whose program is gone: opening the port restarts a board on USB; any other is told to stop.

A board that goes on may be in the middle of a half frame: zeros end it, a pause lets the board read them,
then stop is said until its wheels are seen to stand.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum

from devices.port_talk.asking import ROBOT_BAUD
from devices.port_talk.line import Line, PortLine, hold
from devices.serial_port import GONE, PortFault, PortProblem
from devices.wire.commands import FILLER, STOP
from devices.wire.decoder import Decoder
from devices.wire.reports import ConfigWanted, Encoders, Report

FLUSH_PAUSE = 0.1
"""Seconds behind the zeros: the board reads one byte in a pass of its loop."""

REPEAT = 0.05
TWICE = 2
SILENT = 1.5
"""Seconds after which a board that says nothing is told to stop all the same; its boot loader takes one."""

STANDS = 0.3
"""Seconds of fresh frames without a count, after which the wheels stand; a silent board tells nothing."""

LONGEST = 4.0
"""A board that was restarted says so within two seconds, a slow one within three."""


class Halted(Enum):
    """What is known of the robot."""

    STANDS = "stands"
    """Its wheels were seen to stand, or its board has just begun anew."""
    UNCONFIRMED = "unconfirmed"
    """It was told to stop, and nothing answered."""
    IN_USE = "in-use"
    """It was told to stop, but another program has its port and may go on."""


class HaltTalk:
    """Listen first: a board in its boot loader stands already, and must not be disturbed there."""

    def __init__(self) -> None:
        self._decoder = Decoder()
        self._began: float | None = None
        self._flushed_at: float | None = None
        self._said_at = 0.0
        self._stops = 0
        self._streams = False
        self._began_anew = False
        self._wheels: Encoders | None = None
        self._still_since: float | None = None
        self._heard_at = 0.0
        """When the wheels were last told of."""

    def next(self, received: bytes, now: float) -> bytes:
        self._began = now if self._began is None else self._began
        for report in self._decoder.feed(received):
            self._take(report, now)
        if self._flushed_at is None:
            return self._flush(now)
        if now - self._flushed_at < FLUSH_PAUSE or now - self._said_at < REPEAT:
            return b""
        if self._stops >= TWICE and not self._streams:
            return b""
        self._said_at = now
        self._stops += 1
        return STOP

    def is_over(self, now: float) -> bool:
        return self._began is not None and (self._stands(now) or now - self._began >= LONGEST)

    def outcome(self, now: float) -> Halted:
        return Halted.STANDS if self._stands(now) else Halted.UNCONFIRMED

    def _flush(self, now: float) -> bytes:
        """Zeros, once a board streams, or has said nothing for so long that it should have."""
        if not self._streams and now - (self._began or 0.0) < SILENT:
            return b""
        self._flushed_at = self._said_at = now
        return FILLER

    def _stands(self, now: float) -> bool:
        return self._began_anew or self._is_still(now)

    def _is_still(self, now: float) -> bool:
        """The same counts, told for a while and just now."""
        since, heard_at = self._still_since, self._heard_at
        return since is not None and heard_at - since >= STANDS and now - heard_at < STANDS

    def _take(self, report: Report, now: float) -> None:
        if isinstance(report, ConfigWanted):
            self._began_anew = True
            return
        self._streams = True
        if isinstance(report, Encoders) and self._stops >= TWICE:
            self._heard_at = now
            if report != self._wheels:
                self._wheels, self._still_since = report, now


def halt(
    port: str, opened: Callable[..., Line] = PortLine, *, by_force: Callable[[], bool] = lambda: False
) -> Halted:
    """Stop the robot at the port; four seconds at most, or twice that. Raises ``PortProblem``.

    ``by_force`` restarts the board, where that can be done without opening the port; whether it did. It is
    called if words don't help.

    Where another program has the port, stop is said all the same, without listening.
    """
    try:
        line = opened(port, ROBOT_BAUD)
    except PortProblem as problem:
        if problem.fault is not PortFault.BUSY:
            raise
        _say_stop_beside(port, opened)
        return Halted.IN_USE
    try:
        outcome = _talked(line, port)
        if outcome is Halted.UNCONFIRMED and by_force():
            outcome = _talked(line, port)
        return outcome
    finally:
        line.close()


def _talked(line: Line, port: str) -> Halted:
    talk = HaltTalk()
    hold(line, talk, port)
    return talk.outcome(line.now())


def _say_stop_beside(port: str, opened: Callable[..., Line]) -> None:
    """Whatever the other program says meanwhile comes between whole frames of ours at the most."""
    line = opened(port, ROBOT_BAUD, exclusive=False)
    try:
        line.write(STOP)
        line.write(STOP)
    except GONE as problem:
        raise PortProblem(port, PortFault.BUSY, str(problem)) from None
    finally:
        line.close()
