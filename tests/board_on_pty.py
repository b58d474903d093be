"""A simulated board behind a device path, in real time, for programs that open serial ports. Unix only.

One thread runs the board. The path is a link, and stays the same when the board is unplugged and plugged in
again.
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

from devices.board_simulator.board import SimulatedBoard

POLL = 0.002
"""Seconds between two polls of the terminal."""
LONGEST_POLL = 0.02
"""Seconds that the board advances at once: on a busy machine its time runs slower, and never jumps."""
MOST_AT_ONCE = 4096


class PtyBoard:
    """A context manager: inside, ``path`` can be opened as a serial port."""

    def __init__(self, board: SimulatedBoard, *, slowness: float = 1.0) -> None:
        """``slowness``: seconds in which one of the board passes; a late stop is less late for it."""
        self.board, self._slowness = board, slowness
        self.received = bytearray()
        """All bytes that were written to the board."""
        self.has_battery = False
        """Whether the board runs on while it is unplugged, and is not restarted when it is plugged in."""
        self._folder = tempfile.TemporaryDirectory(prefix="donnie-double-")
        self._lock = threading.Lock()
        self._ending = threading.Event()
        self._ends: tuple[int, int] | None = None
        self._thread = threading.Thread(target=self._run, name="double", daemon=True)

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
        """Give the board a port; and power, if it has no other, so that it restarts."""
        with self._lock:
            master, slave = os.openpty()
            tty.setraw(slave)
            os.set_blocking(master, False)
            self._ends = (master, slave)
            Path(self.path).unlink(missing_ok=True)
            Path(self.path).symlink_to(os.ttyname(slave))
            if not self.has_battery:
                self.board.reset()

    def unplug(self) -> None:
        """Remove the port, also for a program that has it open."""
        with self._lock:
            ends, self._ends = self._ends, None
            Path(self.path).unlink(missing_ok=True)
            for end in ends or ():
                os.close(end)

    def disturb(self, data: bytes) -> None:
        """Give the board bytes that the host did not write: noise, or half of a frame."""
        with self._lock:
            self.board.receive(data)

    def _run(self) -> None:
        then = time.monotonic()
        while not self._ending.wait(POLL):
            now = time.monotonic()
            with self._lock:
                self._poll(min(LONGEST_POLL, now - then) / self._slowness)
            then = now

    def _poll(self, seconds: float) -> None:
        if self._ends is None:
            if self.has_battery:
                self.board.advance(seconds)
            return
        master = self._ends[0]
        if select.select([master], [], [], 0)[0]:
            data = os.read(master, MOST_AT_ONCE)
            self.received += data
            self.board.receive(data)
        sent = self.board.advance(seconds)
        with contextlib.suppress(BlockingIOError):  # the host doesn't read: a real board loses its bytes, too
            os.write(master, sent)
