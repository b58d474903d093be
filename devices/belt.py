"""The vibration belt: its frames and when they are sent, and the thread that owns its serial port.

A frame is ``Z`` and 35 letters, five rows of seven cells, of which only the second and the fourth row have
motors. ``A`` is always on, ``B`` every second pass of the board's loop, ``C`` every third, and so on; ``P``
is off. Source: the firmware of the original belt. ``BeltSender`` and ``BeltDetector`` take bytes and times,
and touch no port.

The thread writes what is due, and reopens the port when it is gone. Rules: no caller waits for the belt, nor
for a network that doesn't answer. What can't be sent now is never sent later. A belt that is missing or lost
is reported once, and once more when it is back. Closing turns its motors off."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable
from contextlib import suppress
from enum import Enum, auto
from math import inf
from time import monotonic

from devices.serial_ports import GONE, Notifier, PortProblem, SerialPort

BAUD = 9600
"""8N1: a frame takes 37.5 ms."""

COLUMNS, ROWS = 7, 5
CELLS = COLUMNS * ROWS
MOTORS = 14
"""Two rows of seven: the upper one first."""

OFF = (0,) * MOTORS

START = b"Z"
DARK = ord("P")
"""The letter of a cell that is off."""

LETTERS = (DARK, ord("C"), ord("B"), ord("A"))
"""By level: off, weak, medium, strong."""

RESYNC = b"Z!"
"""Ends a frame that the board may have received half of: it sends at most two error lines, and waits."""

COMPLAINTS = (b"E1\r\n", b"E2\r\n")
"""The board's errors about a byte that belongs to no frame: outside of one, and inside."""

PERIOD = 0.040
"""Seconds between two frames."""

HOLD = 0.25
"""Seconds that a motor is on at least, so that a short pulse is felt."""

AFTER_RESYNC = 0.030
"""Seconds of silence after a resync, in which the board's error lines arrive."""

ASKED_AGAIN = 3.0
"""Seconds after opening the port, when a board that was restarted by it has surely begun."""

GIVEN_UP = 4.0
"""Seconds after opening the port, when an answer would have come long ago."""

_UPPER, _LOWER = COLUMNS, 3 * COLUMNS
_COMPLAINT = ord("E")
_LONGEST_COMPLAINT = max(map(len, COMPLAINTS))


def encode_frame(levels: tuple[int, ...]) -> bytes:
    """The frame for 14 levels, 0 off to 3 strong. Raises ``ValueError`` for anything else."""
    if len(levels) != MOTORS or not all(0 <= level < len(LETTERS) for level in levels):
        raise ValueError("a belt has 14 motors with levels 0 to 3")
    cells = bytearray([DARK]) * CELLS
    letters = bytes(LETTERS[level] for level in levels)
    cells[_UPPER : _UPPER + COLUMNS] = letters[:COLUMNS]
    cells[_LOWER : _LOWER + COLUMNS] = letters[COLUMNS:]
    return START + bytes(cells)


def motor_cells(cells: bytes) -> tuple[int, ...]:
    """The cells of 35 that have motors, in the order of the levels."""
    return (*cells[_UPPER : _UPPER + COLUMNS], *cells[_LOWER : _LOWER + COLUMNS])


MOTOR_PLACES = tuple(len(START) + cell for cell in motor_cells(bytes(range(CELLS))))
"""The index of each motor's letter in a frame. Clients of Player use it as the motor's number."""


def contains_complaint(received: bytes | bytearray) -> bool:
    """Whether a belt's board sent this: no other device does."""
    return any(each in received for each in COMPLAINTS)


class ComplaintFinder:
    """Finds a complaint in what a device sends, in any chunks."""

    def __init__(self) -> None:
        self.has_found = False
        self._last = b""
        """The bytes that may begin a complaint which the next ones end."""

    def receive(self, received: bytes) -> None:
        known = self._last + received
        self.has_found = self.has_found or contains_complaint(known)
        self._last = known[-_LONGEST_COMPLAINT:]


class BeltSender:
    """Decides which bytes are sent when; its owner writes them. Not thread-safe. ``now`` is in seconds.

    - Only the newest levels are sent. There is never a queue.
    - While a motor is on, a frame is sent every 40 ms: the board turns its motors off by itself after 25 to
      74 ms.
    - Off is one frame of ``P`` and then silence.
    - A complaint of the board is answered with a resync. A resync causes complaints of its own, so complaints
    between it and the next frame mean nothing, however late they are read.
    - A motor keeps the strongest level of the last quarter second, so that even the shortest pulse is felt.
    """

    def __init__(self) -> None:
        self._levels = OFF
        self._held_until = [(0, -inf)] * len(OFF)
        """Of each motor the strongest recent level, and until when it counts."""
        self._due = -inf
        self._is_lit = False
        """Whether the last frame had a motor on, so that another frame must follow."""
        self._must_resync = True
        self._is_framed = False
        """Whether a frame was sent since the last resync: only then a complaint means something."""

    def show(self, levels: tuple[int, ...], now: float) -> None:
        """Show these levels from now on. Raises ``ValueError`` if they are not valid."""
        encode_frame(levels)
        self._levels = levels
        for motor, level in enumerate(levels):
            if level >= self._felt_of(motor, now):
                self._held_until[motor] = (level, now + HOLD)

    def start_over(self) -> None:
        """The port was reopened: its board may be in the middle of a frame."""
        self._must_resync = True
        self._due = -inf

    def receive(self, received: bytes) -> None:
        """Take in what the board sent. Anything but a complaint is noise."""
        if _COMPLAINT in received and self._is_framed:
            self._must_resync = True

    def wait(self, now: float) -> float | None:
        """Seconds until ``next`` returns bytes; None if only ``show`` can change that."""
        if not (self._must_resync or self._is_lit or any(self._felt(now))):
            return None
        return max(0.0, self._due - now)

    def next(self, now: float) -> bytes:
        """The bytes that are due now, empty if there are none. They count as written."""
        if now < self._due:
            return b""
        if self._must_resync:
            self._must_resync = self._is_framed = False
            self._due = now + AFTER_RESYNC
            return RESYNC
        felt = self._felt(now)
        if not any(felt) and not self._is_lit:
            return b""
        self._is_lit, self._is_framed = any(felt), True
        self._due = now + PERIOD
        return encode_frame(felt)

    def is_over(self, now: float) -> bool:
        """Whether the belt is off, and the frame that turns it off was sent."""
        return not (self._is_lit or any(self._felt(now)))

    def _felt(self, now: float) -> tuple[int, ...]:
        return tuple(self._felt_of(motor, now) for motor in range(len(OFF)))

    def _felt_of(self, motor: int, now: float) -> int:
        level, until = self._held_until[motor]
        return max(self._levels[motor], level if now < until else 0)


class BeltCheck(Enum):
    """What ``BeltDetector`` asks its owner to do."""

    NOTHING = auto()
    ASK = auto()
    """Send a resync."""
    REPORT_MISSING = auto()
    """Report that no belt answers."""


class BeltDetector:
    """Finds out whether the device at the port is a belt: a robot's board, say, accepts the bytes and never
    answers. A belt answers each resync with an error line. Its board may have been starting when the first
    resync came, so a second one is sent before a missing belt is reported.
    """

    def __init__(self, now: float) -> None:
        """``now``: when the port was opened."""
        self._began = now
        self._complaints = ComplaintFinder()
        self._has_asked = self._is_over = False

    def receive(self, received: bytes) -> None:
        self._complaints.receive(received)

    def next(self, now: float) -> BeltCheck:
        """Each answer but NOTHING is given once."""
        waited = now - self._began
        if self._complaints.has_found or self._is_over or waited < ASKED_AGAIN:
            return BeltCheck.NOTHING
        if not self._has_asked:
            self._has_asked = True
            return BeltCheck.ASK
        if waited < GIVEN_UP:
            return BeltCheck.NOTHING
        self._is_over = True
        return BeltCheck.REPORT_MISSING


# --- the port and its thread

_LOG = logging.getLogger(__name__)

RETRY = 1.0
"""Seconds between two attempts to reopen a lost port."""

LONGEST_REST = 0.5
"""Seconds between two polls of a port on which nothing is due; so soon an unplugged belt is noticed."""

OPENING_TIMEOUT = 2.0
"""Seconds that the constructor waits for a device of this machine, which opens at once or never. It does not
wait for a network address."""

CLOSING_TIMEOUT = 1.0
"""Seconds that closing may take: the last pulse, and the frame that turns all motors off."""


class BeltNotice(Enum):
    """What is reported about the belt."""

    MISSING = "missing"
    """It couldn't be opened, and is not tried again."""
    FOUND = "found"
    """It was opened after the constructor had returned."""
    UNANSWERED = "unanswered"
    """The device accepts the bytes, and never answers as a belt does. It still gets them."""
    LOST = "lost"
    RESTORED = "restored"


def open_belt_port(address: str) -> SerialPort:
    """A belt's port, open at its speed. Raises ``PortProblem``."""
    return SerialPort(address, BAUD)


class SerialBelt:
    """A belt that any thread may show levels on; no call waits for it."""

    def __init__(
        self,
        address: str,
        on_notice: Callable[[BeltNotice, str], None],
        open_port: Callable[[str], SerialPort] = open_belt_port,
    ):
        """Opens the port. Raises ``PortProblem`` if the port is known at once to be unusable; what turns out
        later is a notice. ``on_notice`` is called in a thread of its own, with a reason or an empty
        string."""
        self._address = address
        self._notifier = Notifier(address, on_notice)
        self._open_port = open_port
        self._port: SerialPort | None = None
        self._sender = BeltSender()
        self._detector: BeltDetector | None = None
        """For the port that is open."""
        self._changed = threading.Condition()
        self._is_closing = False
        self._is_opening = self._is_awaited = True
        self._problem: Exception | None = None
        self._thread = threading.Thread(target=self._run, name="belt", daemon=True)
        self._thread.start()
        self._await_opening(0.0 if "://" in address else OPENING_TIMEOUT)

    def _await_opening(self, seconds: float) -> None:
        with self._changed:
            self._changed.wait_for(lambda: not self._is_opening, seconds)
            self._is_awaited = False
            problem = self._problem
        if problem is not None:
            raise problem

    def show(self, levels: tuple[int, ...]) -> None:
        with self._changed:
            self._sender.show(levels, monotonic())
            self._changed.notify()

    def close(self) -> None:
        """Turn the motors off, after the last pulse was felt, and close the port. A port that opens only
        later is turned off and closed then."""
        with self._changed:
            self._is_closing = True
            self._sender.show(OFF, monotonic())
            self._changed.notify()
            is_opening = self._is_opening
        if not is_opening:
            self._thread.join(CLOSING_TIMEOUT)

    # --- the belt's thread

    def _run(self) -> None:
        if not self._open_first():
            return
        while not self._is_done():
            try:
                self._poll()
            except GONE as error:
                self._lose(error)
        self._turn_off()

    def _open_first(self) -> bool:
        """Open the port for the first time. The result goes to the constructor, or to the listener."""
        port, problem = None, None
        try:
            port = self._open_port(self._address)
        except Exception as error:  # noqa: BLE001 -- the constructor raises it again
            problem = error
        with self._changed:
            self._port, self._problem, self._is_opening = port, problem, False
            is_late = not (self._is_awaited or self._is_closing)
            self._changed.notify_all()
        if is_late:
            _LOG.info("the belt's port: %s", problem or "opened")
            reason = problem.reason if isinstance(problem, PortProblem) else str(problem or "")
            self._notifier.notify(BeltNotice.MISSING if problem else BeltNotice.FOUND, reason)
        return port is not None

    def _is_done(self) -> bool:
        return self._is_closing and (self._port is None or self._sender.is_over(monotonic()))

    def _poll(self) -> None:
        port = self._port
        if port is None:
            self._reopen()
            return
        received = port.read()
        with self._changed:
            self._sender.receive(received)
        self._detect(received)
        if port.unsent:  # an earlier frame still waits in the system: leave this one out
            self._rest(PERIOD / 4)
            return
        with self._changed:
            due = self._sender.next(monotonic())
        if due:
            port.write(due)
        else:
            self._rest()

    def _detect(self, received: bytes) -> None:
        if self._detector is None:
            self._detector = BeltDetector(monotonic())
        self._detector.receive(received)
        match self._detector.next(monotonic()):
            case BeltCheck.ASK:
                with self._changed:
                    self._sender.start_over()
            case BeltCheck.REPORT_MISSING:
                self._notifier.notify(BeltNotice.UNANSWERED, "")
            case BeltCheck.NOTHING:
                pass

    def _rest(self, seconds: float | None = None) -> None:
        """Rest that long; or until something is due or shown, or the port must be polled again."""
        with self._changed:
            if self._is_done():
                return
            if seconds is None:
                seconds = self._sender.wait(monotonic())
            self._changed.wait(LONGEST_REST if seconds is None else seconds)

    def _lose(self, error: Exception) -> None:
        _LOG.info("the belt's port failed: %s", error)
        self._close_port()
        self._detector = None
        self._notifier.notify(BeltNotice.LOST, "")

    def _reopen(self) -> None:
        with self._changed:
            if self._is_closing:
                return
            self._changed.wait(RETRY)
            self._is_opening = True
        try:
            self._port = self._open_port(self._address)
        except (PortProblem, *GONE):
            return
        finally:
            with self._changed:
                self._is_opening = False
        with self._changed:
            self._sender.start_over()
        self._notifier.notify(BeltNotice.RESTORED, "")

    def _turn_off(self) -> None:
        """Writes a frame that turns everything off, as the last bytes, whatever happened before."""
        if self._port is not None:
            with suppress(*GONE):
                self._port.write(encode_frame(OFF))
        self._close_port()

    def _close_port(self) -> None:
        port, self._port = self._port, None
        if port is not None:
            with suppress(*GONE):
                port.close()
