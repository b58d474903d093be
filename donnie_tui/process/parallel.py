"""Work for several processes: each begins as a copy of this one, and what dies with its process is known.

Ctrl+C reaches all processes of a terminal. The copies leave it to this one, and end with it.
"""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from typing import Any, TypeVar

_Given = TypeVar("_Given")
_Outcome = TypeVar("_Outcome")
_work: Callable[[Any], Any]
"""In a copy: what it does."""


def processors() -> int:
    """Those that this process may use; 1 where it can't be copied."""
    if not hasattr(os, "sched_getaffinity"):
        return 1
    return len(os.sched_getaffinity(0))


def in_processes(
    work: Callable[[_Given], _Outcome], given: Sequence[_Given], processes: int, instead: _Outcome
) -> Iterator[_Outcome]:
    """The outcome of each, in order; ``instead`` where it ended its process.

    No other thread may run. What was given with it is done again, first alone, so that only the right one is
    blamed.
    """
    from concurrent.futures.process import BrokenProcessPool, ProcessPoolExecutor
    from multiprocessing import get_context

    done, is_alone = 0, False
    while done < len(given):
        copies = ProcessPoolExecutor(1 if is_alone else processes, get_context("fork"), _begin, (work,))
        try:
            for outcome in copies.map(_do, given[done : done + 1] if is_alone else given[done:]):
                done += 1
                yield outcome
            is_alone = False
        except BrokenProcessPool:
            if is_alone:
                done += 1
                yield instead
            is_alone = not is_alone
        finally:
            copies.shutdown(cancel_futures=True)


def _begin(work: Callable[[Any], Any]) -> None:
    from multiprocessing import parent_process

    global _work
    _work = work
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = parent_process()
    assert parent is not None

    def end_with_parent() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=end_with_parent, daemon=True).start()


def _do(given: Any) -> Any:
    return _work(given)
