"""The times and limits of the line. The defaults are what the firmware needs (docs/wire-protocol.md)."""

from __future__ import annotations

from devices.ports.values import Frozen


class LinkConfig(Frozen):
    """All times in seconds."""

    first_answer: float = 6.0
    """How long an opened board may be silent: it starts in two seconds, and some boot loaders are slow."""
    silence: float = 0.5
    """Without a frame for that long the link is lost; frames come 1.3 ms apart."""
    gap: float = 0.04
    """Between two frames. The board takes one byte in a pass of its loop."""
    most_outstanding: int = 63
    """Bytes that the board may not yet have read: the size of its buffer."""
    bytes_a_second: float = 700.0
    """How fast the board reads, at the least: it makes some 750 passes a second."""
    flush_pause: float = 0.1
    """After the zeros that end a half frame."""
    repeat: float = 0.2
    """The set-point is sent again that often, for nothing is acknowledged."""
    lease: float = 0.4
    """A drive that nobody renews for that long ends."""
    still: float = 0.1
    """The wheels stand once they have not counted for that long."""
    stop_again: float = 0.1
    """A stop is said again that often until they stand."""
    runaway: float = 0.5
    """Wheels that count that long after a stop are stopped by force."""
    reopen: float = 0.5
    """Between two tries to open a port that was lost."""
    tick_jump: int = 60
    """Counts in one frame that are believed only once a second frame agrees with them."""
    battery_low: int = 7100
    """Millivolts below which the battery is low, as the firmware's own alarm has it."""
    battery_fine: int = 7400
    """Millivolts from which it no longer is."""
