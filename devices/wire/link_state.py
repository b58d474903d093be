"""What the line is doing, as a table: five states, and where each thing that happens leads."""

from __future__ import annotations

from enum import Enum, auto


class LinkState(Enum):
    """What the line is doing."""

    CLOSED = auto()
    OPENING = auto()
    """A port is being opened."""
    WAITING = auto()
    """The port is open; the board has not yet heeded us."""
    STREAMING = auto()
    """The board tells what it senses, and does what it is told."""
    LOST = auto()
    """It did, and no longer does, or never answered; it is looked for again and again."""


class Happening(Enum):
    """What can happen to a line."""

    OPEN = auto()
    """Somebody wants it open, or tries again."""
    OPENED = auto()
    FAILED = auto()
    """The port can't be opened, read or written."""
    READY = auto()
    """The board streams, after it was configured and told to stop."""
    RESTARTED = auto()
    """The board asks for its configuration."""
    HEARD = auto()
    """A frame came in."""
    SILENCE = auto()
    CLOSE = auto()


_S, _H = LinkState, Happening

TRANSITIONS: dict[tuple[LinkState, Happening], LinkState] = {
    (_S.CLOSED, _H.OPEN): _S.OPENING,
    (_S.LOST, _H.OPEN): _S.OPENING,
    (_S.OPENING, _H.OPENED): _S.WAITING,
    (_S.OPENING, _H.FAILED): _S.LOST,
    (_S.WAITING, _H.FAILED): _S.LOST,
    (_S.STREAMING, _H.FAILED): _S.LOST,
    (_S.WAITING, _H.READY): _S.STREAMING,
    (_S.WAITING, _H.SILENCE): _S.LOST,
    (_S.STREAMING, _H.SILENCE): _S.LOST,
    (_S.STREAMING, _H.RESTARTED): _S.WAITING,
    (_S.LOST, _H.RESTARTED): _S.WAITING,
    (_S.LOST, _H.HEARD): _S.WAITING,
    **{(state, _H.CLOSE): _S.CLOSED for state in _S},
}
"""Where each happening leads; one that is not listed changes nothing."""


def following(state: LinkState, happening: Happening) -> LinkState:
    return TRANSITIONS.get((state, happening), state)
