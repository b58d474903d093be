"""Signals: taken for a while and given back as they were; and Ctrl+Z.

The main thread takes them and gives them back. The ``Deputy``, a thread, does what they ask for: a handler
interrupts the main thread anywhere, in another handler too, so it must not take a lock. It calls ``do`` and
nothing else that could wait. A suspended process can't stop its robot, and a board drives on by itself: the
robot must stand before ``suspend`` is called. Where ``can_suspend`` says no, Ctrl+Z does nothing, and the
front end says so.
"""

from __future__ import annotations

import os
import select
import signal
import threading
from collections.abc import Callable, Mapping
from contextlib import suppress
from queue import Empty, SimpleQueue
from stat import S_ISCHR
from types import FrameType

from donnie_tui.process.confinement import may_run_programs
from donnie_tui.process.disconnection import parent_of

TYPE_CHECKING = False  # that of typing takes longer to load than all that is here
if TYPE_CHECKING:
    from typing import Self, TypeAlias

Handler: TypeAlias = Callable[[int, FrameType | None], object]


def numbers_of(*names: str) -> tuple[int, ...]:
    """The numbers of the signals that this platform has."""
    return tuple(getattr(signal, name) for name in names if hasattr(signal, name))


LEAVING = numbers_of("SIGTERM", "SIGHUP", "SIGQUIT")
"""Signals that end Donnie."""


class TakenSignals:
    """Taken from the making to ``give_back``, or the end of ``with``."""

    def __init__(self, handlers: Mapping[int, Handler]) -> None:
        """Raises ``ValueError`` outside of the main thread."""
        self._found = {number: signal.signal(number, handler) for number, handler in handlers.items()}
        self._are_taken = True

    def handler_before(self, number: int) -> Handler | None:
        """What handled this one when it was taken; None where that was no function."""
        found = self._found[number]
        return found if callable(found) else None

    def give_back(self) -> None:
        """Any number of times."""
        if self._are_taken:
            self._are_taken = False
            for number, handler in self._found.items():
                signal.signal(number, handler)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.give_back()


class WakingSignals(TakenSignals):
    """The signals also wake a thread that waits for input here, with their numbers."""

    def __init__(self, handlers: Mapping[int, Handler]) -> None:
        super().__init__(handlers)
        self._reading, self._writing = os.pipe()
        os.set_blocking(self._reading, False)
        os.set_blocking(self._writing, False)
        self._fd_before = signal.set_wakeup_fd(self._writing, warn_on_full_buffer=False)

    def fileno(self) -> int:
        """For ``select``."""
        return self._reading

    def numbers(self) -> bytes:
        """The signals since the last call, and a 0 for each nudge. Never waits."""
        try:
            return os.read(self._reading, 4096)
        except BlockingIOError:
            return b""

    def nudge(self) -> None:
        """Wake the waiting thread. From any thread."""
        with suppress(OSError):
            os.write(self._writing, b"\0")

    def give_back(self) -> None:
        if self._are_taken:
            try:
                signal.set_wakeup_fd(self._fd_before)
            except (OSError, ValueError):  # of an event loop that is closed by now
                signal.set_wakeup_fd(-1)
        super().give_back()

    def close(self) -> None:
        """After ``give_back``, once no thread waits here any more."""
        os.close(self._reading)
        os.close(self._writing)


_LAST_TASKS = 2.0
"""Seconds that ``close`` waits for what was asked for; it needs a few thousandths unless something hangs."""

Task: TypeAlias = Callable[[], object]


class Deputy:
    """Does one thing after the other. From its making to ``close``."""

    def __init__(self) -> None:
        self._tasks: SimpleQueue[Task | None] = SimpleQueue()  # its ``put`` may interrupt itself
        self._thread = threading.Thread(target=self._work, name="deputy", daemon=True)
        self._thread.start()

    def do(self, task: Task) -> None:
        """Have it done. Any thread, a signal's handler too; never waits."""
        self._tasks.put(task)

    def see_done(self, task: Task, seconds: float) -> None:
        """Do it in the deputy's thread and wait, at most so long: the caller may hold a needed lock."""
        done: SimpleQueue[None] = SimpleQueue()

        def do_and_notify() -> None:
            try:
                task()
            finally:
                done.put(None)

        self.do(do_and_notify)
        with suppress(Empty):
            done.get(timeout=seconds)

    def close(self) -> None:
        """All that was asked for is done, unless something hangs."""
        self._tasks.put(None)
        self._thread.join(_LAST_TASKS)

    def _work(self) -> None:
        while (task := self._tasks.get()) is not None:
            attempt(task)


def attempt(task: Task) -> None:
    """Do it; a failure is logged, and nothing else: the next signal must be heeded all the same."""
    try:
        task()
    except Exception:
        import logging  # slow to load, and not needed as long as all is well

        logging.getLogger(__name__).exception("what a signal asked for failed")


_STANDARD = (0, 1, 2)


def suspend() -> None:
    """Suspend the process until it is continued, if that is possible."""
    if can_suspend():
        os.kill(os.getpid(), signal.SIGSTOP)


def can_suspend() -> bool:
    """Whether anything would continue the process: a shell with job control, to which it may return.

    Not if the terminal is closed. The kernel suspends no process without such a shell by Ctrl+Z either.
    """
    return may_run_programs() and not any(map(is_hung_up, _STANDARD)) and has_shell_above()


def has_shell_above() -> bool:
    """Whether the process group is not orphaned, in the sense of POSIX, as far as its ancestors show.

    Donnie is in the group of the session's leader where it is the command of an ssh or of a new terminal.
    """
    group, session = os.getpgrp(), os.getsid(0)
    above = os.getppid()
    if group == session:
        return False
    try:
        while above > 0 and os.getpgid(above) == group:
            above = parent_of(above)
        return above > 0 and os.getsid(above) == session
    except FileNotFoundError:  # a system that does not say whose parent that is
        return True
    except OSError:  # it ended just now, or may not be inspected
        return False


def is_hung_up(number: int) -> bool:
    """Whether that file is a terminal that is gone; a pipe whose writer is done is none."""
    poll = select.poll()
    poll.register(number, 0)
    is_gone = any(mask & select.POLLHUP for _, mask in poll.poll(0))
    return is_gone and S_ISCHR(os.fstat(number).st_mode)
