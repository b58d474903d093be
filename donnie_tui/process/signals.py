"""Signals: taken for a while and restored; the end of the process in time; and Ctrl+Z.

The main thread takes and restores them. The ``Deputy``, a thread, does their work: a handler
interrupts the main thread anywhere, in another handler too, so it must not take a lock. It calls ``do`` and
nothing else that could wait. A suspended process can't stop its robot, and a board drives on: the
robot must stand before ``suspend`` is called. Where ``can_suspend`` says no, Ctrl+Z does nothing, and the
front end says so.

The main thread may hang: in a loop without end, in a call that does not return, at a lock. A signal's number
reaches the ``Watchdog`` all the same, a thread that waits for nothing that may hang. Its signals end the
process in time, whether the main thread leaves or not.
"""

from __future__ import annotations

import os
import select
import signal
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from functools import partial
from queue import Empty, SimpleQueue
from stat import S_ISCHR
from types import FrameType

from donnie_tui.process.confinement import may_run_programs
from donnie_tui.process.disconnection import parent_of

TYPE_CHECKING = False  # that of typing takes longer to load than all that is here
if TYPE_CHECKING:
    from typing import NoReturn, Self, TypeAlias

Handler: TypeAlias = Callable[[int, FrameType | None], object]


def numbers_of(*names: str) -> tuple[int, ...]:
    """The numbers of the signals that this platform has."""
    return tuple(getattr(signal, name) for name in names if hasattr(signal, name))


LEAVING = numbers_of("SIGTERM", "SIGHUP", "SIGQUIT")
"""Signals that end Donnie."""


class TakenSignals:
    """Handlers that are set until ``give_back``, or the end of ``with``."""

    def __init__(self, handlers: Mapping[int, Handler]) -> None:
        """Raises ``ValueError`` outside of the main thread."""
        self._found = {number: signal.signal(number, handler) for number, handler in handlers.items()}
        self._are_taken = True

    def handler_before(self, number: int) -> Handler | None:
        """The handler that this signal had when it was taken; None if that was no function."""
        found = self._found[number]
        return found if callable(found) else None

    def give_back(self) -> None:
        """Restore the old handlers. May be called any number of times."""
        if self._are_taken:
            self._are_taken = False
            for number, handler in self._found.items():
                signal.signal(number, handler)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.give_back()


class Nudges:
    """Wakes a thread that waits for input here. Close it once no thread waits here any more."""

    def __init__(self) -> None:
        self._reading, self._writing = os.pipe()
        os.set_blocking(self._reading, False)
        os.set_blocking(self._writing, False)

    def fileno(self) -> int:
        """The descriptor for ``select``."""
        return self._reading

    def numbers(self) -> bytes:
        """A 0 for each nudge since the last call. Never waits."""
        try:
            return os.read(self._reading, 4096)
        except BlockingIOError:
            return b""

    def nudge(self) -> None:
        """Wake the waiting thread. From any thread."""
        with suppress(OSError):
            os.write(self._writing, b"\0")

    def close(self) -> None:
        os.close(self._reading)
        os.close(self._writing)


class WakingSignals(TakenSignals, Nudges):
    """The signals also wake the waiting thread, with their numbers."""

    def __init__(self, handlers: Mapping[int, Handler]) -> None:
        Nudges.__init__(self)
        try:
            # before the handlers: else a signal in between would be handled, and its number lost
            self._fd_before = signal.set_wakeup_fd(self._writing, warn_on_full_buffer=False)
        except ValueError:
            self.close()
            raise
        TakenSignals.__init__(self, handlers)

    def give_back(self) -> None:
        if self._are_taken:
            try:
                signal.set_wakeup_fd(self._fd_before)
            except (OSError, ValueError):  # of an event loop that is closed by now
                signal.set_wakeup_fd(-1)
        super().give_back()


_LAST_TASKS = 2.0
"""Seconds that ``close`` waits for tasks, which take a few thousandths unless one hangs."""

Task: TypeAlias = Callable[[], object]


class Deputy:
    """A thread that runs tasks one after the other, until ``close``."""

    def __init__(self) -> None:
        self._tasks: SimpleQueue[Task | None] = SimpleQueue()  # its ``put`` may interrupt itself
        self._thread = threading.Thread(target=self._work, name="deputy", daemon=True)
        self._thread.start()

    def do(self, task: Task) -> None:
        """Queue a task. Any thread, also a signal's handler; never waits."""
        self._tasks.put(task)

    def see_done(self, task: Task, seconds: float) -> None:
        """Queue a task and wait for it, at most so long, as the caller may hold a needed lock."""
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
        """Wait until all tasks are done, unless one hangs."""
        self._tasks.put(None)
        self._thread.join(_LAST_TASKS)

    def _work(self) -> None:
        while (task := self._tasks.get()) is not None:
            attempt(task)


def attempt(task: Task) -> None:
    """Run a task. A failure is only logged, since the next signal must still be handled."""
    try:
        task()
    except Exception:
        import logging  # slow to load, and not needed as long as all is well

        logging.getLogger(__name__).exception("what a signal asked for failed")


LEAVE = 3.0
"""Seconds in which Donnie leaves by itself after a signal that ends it; a robot needs up to 2.2."""
LAST = 1.5
"""Seconds for the last tasks, which run in parallel."""
_AGAIN = 0.5
"""Seconds until the end is tried again where it failed."""


def timeout_factor() -> float:
    """DONNIE_ROBOT_TIMEOUTS makes all timeouts that many times as long, on a slow or busy computer."""
    try:
        factor = float(os.environ.get("DONNIE_ROBOT_TIMEOUTS", ""))
    except ValueError:
        return 1.0
    return factor if factor > 0 else 1.0


def longer(seconds: float) -> float:
    """A deadline on a slow or busy computer; never shorter."""
    return seconds * max(1.0, timeout_factor())


class Watchdog:
    """Takes signals from ``begin`` to ``end``, both in the main thread. Some end the process in time."""

    def __init__(
        self,
        handlers: Mapping[int, Handler],
        *,
        part: Callable[[int], object],
        halt: Task = lambda: None,
        on_number: Callable[[int], object] = int,
        leave: float | None = None,
    ) -> None:
        """``part`` ends the process if the main thread doesn't within ``leave`` seconds; see ``end_process``.

        The seconds are more where ``timeout_factor`` says so.

        ``halt`` stops all robots at once, in the deputy's thread. ``on_number`` is called for each signal, in
        the thread of the watchdog or that of ``take``, and must not wait for the main thread.
        """
        self._handlers, self._part, self._halt, self._on_number = handlers, part, halt, on_number
        self._leave = longer(LEAVE if leave is None else leave)
        self._ended = threading.Event()
        self.left: tuple[int, float] | None = None
        """The first signal that ends the process, and when it came."""
        self._taking = threading.Lock()

    def begin(self) -> None:
        """Raises ``ValueError`` outside of the main thread."""
        self._signals = WakingSignals(self._handlers)
        self.deputy = Deputy()
        self._thread = threading.Thread(target=self._watch, name="watchdog", daemon=True)
        self._thread.start()

    def end(self) -> None:
        """Restore the handlers and finish all tasks. May be called any number of times."""
        if self._ended.is_set():
            return
        self._signals.give_back()
        self.take()
        self._ended.set()
        self._signals.nudge()
        self._thread.join(_LAST_TASKS)
        self.deputy.close()
        if not self._thread.is_alive():  # else it would read from whatever gets the number next
            self._signals.close()

    def __enter__(self) -> Self:
        self.begin()
        return self

    def __exit__(self, *_: object) -> None:
        self.end()

    def take(self) -> None:
        """Handle all signals that came. Any thread; when it returns, no other thread handles one."""
        is_mine = self._taking.acquire(timeout=_AGAIN)  # the other one may hang
        try:
            for number in self._signals.numbers():
                if number in LEAVING:
                    self.leave(number)
                if number:
                    attempt(partial(self._on_number, number))
        finally:
            if is_mine:
                self._taking.release()

    def leave(self, number: int, since: float | None = None) -> None:
        """End the process in time, as after that signal. Any thread."""
        self.deputy.do(self._halt)
        if self.left is None:
            self.left = number, time.monotonic() if since is None else since
            threading.Thread(target=self._end_in_time, args=self.left, name="last", daemon=True).start()

    # --- its threads

    def _watch(self) -> None:
        while not self._ended.is_set():
            self._wait()
            self.take()

    def _wait(self) -> None:
        """Waits for a signal."""
        poll = select.poll()
        poll.register(self._signals, select.POLLIN)
        poll.poll()

    def _end_in_time(self, number: int, since: float) -> None:
        is_over = self._ended.wait(max(0.0, since + self._leave - time.monotonic()))
        while not is_over:
            attempt(partial(self._part, number))
            is_over = self._ended.wait(_AGAIN)


def heeded(_number: int, _frame: FrameType | None) -> None:
    """The handler of a signal that only the watchdog handles."""


def end_process(code: Callable[[], int], last: Sequence[Task]) -> NoReturn:
    """Run the last tasks, as far as they don't hang, and end. Nothing else is closed, as it may hang, too."""
    until = time.monotonic() + longer(LAST)
    threads = [threading.Thread(target=_quietly, args=(task,), daemon=True) for task in last]
    for each in threads:
        each.start()
    for each in threads:
        each.join(max(0.0, until - time.monotonic()))
    os._exit(code())


def _quietly(task: Task) -> None:
    with suppress(Exception):  # a report could hang
        task()


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


def has_unread(number: int) -> bool:
    """Whether the terminal or pipe has input that was not read yet."""
    try:
        ready, _, _ = select.select([number], [], [], 0)
        return bool(ready) and not is_hung_up(number)
    except (OSError, ValueError):
        return False


def is_hung_up(number: int) -> bool:
    """Whether that file is a terminal that is gone; a pipe whose writer is done is none."""
    poll = select.poll()
    poll.register(number, 0)
    is_gone = any(mask & select.POLLHUP for _, mask in poll.poll(0))
    return is_gone and S_ISCHR(os.fstat(number).st_mode)
