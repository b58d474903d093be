"""A simulated board behind a device path, in real time, for whoever opens serial ports. Unix only.

One thread plays the board; the path is a link that stays when the board is unplugged and comes back.
"""

from __future__ import annotations

import contextlib
import os
import select
import tempfile
import threading
import time
import tty
from pathlib import Path
from types import TracebackType
from typing import Self

from devices.firmware_double.board import SimulatedBoard
from devices.firmware_double.faults import BadWire

TURN = 0.002
"""Seconds between two looks at the line."""
LONGEST_TURN = 0.02
"""Seconds that the board lives at once: on a busy machine its time goes slower, and never in leaps."""
MOST_AT_ONCE = 4096


class DoubleOnPty:
    """Use it as a context: inside, ``path`` can be opened as a serial port."""

    def __init__(self, board: SimulatedBoard, wire: BadWire | None = None) -> None:
        self.board = board
        self.heard = bytearray()
        """All that was written to the board, as it was written."""
        self._wire = wire or BadWire()
        self._folder = tempfile.TemporaryDirectory(prefix="donnie-double-")
        self._lock = threading.Lock()
        self._ending = threading.Event()
        self._ends: tuple[int, int] | None = None
        self._thread = threading.Thread(target=self._live, name="double", daemon=True)

    @property
    def path(self) -> str:
        return str(Path(self._folder.name) / "robot")

    def __enter__(self) -> Self:
        self.plug()
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._ending.set()
        self._thread.join()
        self.unplug()
        self._folder.cleanup()

    def plug(self) -> None:
        """Give the board a port, and power: it begins anew."""
        with self._lock:
            master, slave = os.openpty()
            tty.setraw(slave)
            os.set_blocking(master, False)
            self._ends = (master, slave)
            Path(self.path).unlink(missing_ok=True)
            Path(self.path).symlink_to(os.ttyname(slave))
            self.board.reset()

    def unplug(self) -> None:
        """Take the port away from whoever has it open."""
        with self._lock:
            ends, self._ends = self._ends, None
            Path(self.path).unlink(missing_ok=True)
            for end in ends or ():
                os.close(end)

    def disturb(self, data: bytes) -> None:
        """Give the board bytes that nobody wrote: noise, or half of a frame."""
        with self._lock:
            self.board.receive(data)

    def _live(self) -> None:
        then = time.monotonic()
        while not self._ending.wait(TURN):
            now = time.monotonic()
            with self._lock:
                self._turn(min(LONGEST_TURN, now - then))
            then = now

    def _turn(self, seconds: float) -> None:
        if self._ends is None:
            return
        master = self._ends[0]
        if select.select([master], [], [], 0)[0]:
            data = os.read(master, MOST_AT_ONCE)
            self.heard += data
            self.board.receive(self._wire.to_board(data))
        told = self._wire.to_host(self.board.advance(seconds))
        with contextlib.suppress(BlockingIOError):  # nobody reads: a real board's words are lost as well
            os.write(master, told)
