"""The states of the link to a board, as a table of transitions, and its times and limits."""

from __future__ import annotations

from enum import Enum, auto

from msgspec import Struct
from msgspec.structs import replace


class LinkState(Enum):
    """The state of a link."""

    CLOSED = auto()
    OPENING = auto()
    """The port is being opened."""
    WAITING = auto()
    """The port is open; the board has not yet completed the handshake."""
    STREAMING = auto()
    """The board reports its sensors and obeys commands."""
    LOST = auto()
    """The board stopped answering, or never answered; the link keeps trying."""


class LinkTrigger(Enum):
    """What can change the state of a link."""

    OPEN = auto()
    """The owner opens the port, or tries again."""
    OPENED = auto()
    FAILED = auto()
    """The port can't be opened, read or written."""
    READY = auto()
    """The board streams, after it was configured and stopped."""
    RESTARTED = auto()
    """The board asks for its configuration."""
    FRAME_RECEIVED = auto()
    SILENCE = auto()
    CLOSE = auto()


_S, _T = LinkState, LinkTrigger

TRANSITIONS: dict[tuple[LinkState, LinkTrigger], LinkState] = {
    (_S.CLOSED, _T.OPEN): _S.OPENING,
    (_S.LOST, _T.OPEN): _S.OPENING,
    (_S.OPENING, _T.OPENED): _S.WAITING,
    (_S.OPENING, _T.FAILED): _S.LOST,
    (_S.WAITING, _T.FAILED): _S.LOST,
    (_S.STREAMING, _T.FAILED): _S.LOST,
    (_S.WAITING, _T.READY): _S.STREAMING,
    (_S.WAITING, _T.SILENCE): _S.LOST,
    (_S.STREAMING, _T.SILENCE): _S.LOST,
    (_S.STREAMING, _T.RESTARTED): _S.WAITING,
    (_S.LOST, _T.RESTARTED): _S.WAITING,
    (_S.LOST, _T.FRAME_RECEIVED): _S.WAITING,
    **{(state, _T.CLOSE): _S.CLOSED for state in _S},
}
"""The state that each trigger leads to; one that is not listed changes nothing."""


def next_state(state: LinkState, trigger: LinkTrigger) -> LinkState:
    return TRANSITIONS.get((state, trigger), state)


class LinkConfig(Struct, frozen=True):
    """Times and limits of a link; times in seconds.

    The defaults are what the firmware needs (docs/wire-protocol.md).
    """

    first_answer: float = 6.0
    """How long a board may stay silent after the port was opened: it starts in two seconds, and some boot
    loaders are slow."""
    silence: float = 0.5
    """Without a frame for that long the link is lost; frames come 1.3 ms apart."""
    gap: float = 0.04
    """Between two frames to the board, which takes one byte in a pass of its loop."""
    most_outstanding: int = 63
    """Bytes that the board may not yet have read: the size of its buffer."""
    bytes_a_second: float = 700.0
    """The slowest rate at which the board reads: it makes some 750 passes a second."""
    flush_pause: float = 0.1
    """After the zeros that complete a half frame."""
    repeat: float = 0.2
    """Interval at which the drive command is repeated, because the board acknowledges nothing."""
    lease: float = 0.4
    """A drive that is not renewed for that long ends."""
    still: float = 0.1
    """The wheels stand once they have not counted for that long."""
    stop_again: float = 0.1
    """Interval at which a stop is repeated until the wheels stand."""
    runaway: float = 0.5
    """Wheels that still count that long after a stop are stopped by force."""
    force: float = 0.7
    """The longest time that a restart by force takes."""
    reopen: float = 0.5
    """Between two attempts to reopen a lost port."""
    tick_jump: int = 60
    """Counts in one frame above which a second frame must confirm them."""
    battery_low: int = 7100
    """Millivolts below which the battery is low, as in the firmware's own alarm."""
    battery_fine: int = 7400
    """Millivolts from which it is no longer low."""

    @property
    def longest_stop(self) -> float:
        """Seconds after which all was done to stop a robot that can be; 2.2 with the defaults."""
        return 3 * self.runaway + self.force

    def slower(self, factor: float) -> LinkConfig:
        """The same with longer timeouts, for a computer that lets this program wait for its turn."""
        return replace(
            self,
            first_answer=factor * self.first_answer,
            silence=factor * self.silence,
            lease=factor * self.lease,
            runaway=factor * self.runaway,
            force=factor * self.force,
        )
