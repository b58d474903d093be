"""The process: signals, suspension, lost connections, garbage collection, forked copies. No robots."""

from __future__ import annotations

import gc
import os
import sys

TYPE_CHECKING = False  # that of typing takes longer to load than all that is here
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence
    from typing import Any, TypeVar

    Given = TypeVar("Given")
    Outcome = TypeVar("Outcome")

HIGHEST_STANDARD = 2
"""Input, output and errors are 0, 1 and 2."""


WHILE_LOADING = 200_000
"""Objects until Python collects garbage: more than a start makes; collecting took a tenth of its time."""
AFTERWARDS = 20_000
"""Objects until the newer ones are collected: all that was loaded took twenty milliseconds each time."""


def load_undisturbed() -> None:
    """Collect no garbage while a start loads."""
    gc.set_threshold(WHILE_LOADING)


def loaded() -> None:
    """Collect rarely once a session is loaded. No effect without ``load_undisturbed`` before."""
    if gc.get_threshold()[0] == WHILE_LOADING:
        gc.freeze()
        gc.set_threshold(AFTERWARDS)


# --- libraries that load what they rarely need


class LazyValue:
    """Stands for a value, which is loaded on the first call or the first access to an attribute."""

    def __init__(self, load: Callable[[], Any], **known: object) -> None:
        """``known``: attributes that load nothing."""
        self._load = load
        self.__dict__.update(known)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):  # the importing of a module asks for some
            raise AttributeError(name)
        return getattr(self._load(), name)

    def __call__(self, *given: object, **named: object) -> Any:
        return self._load()(*given, **named)


def real_module(name: str) -> Any:
    """Import a module, also if a ``LazyValue`` stands for it."""
    from importlib import import_module

    if isinstance(sys.modules.get(name), LazyValue):  # in another thread than that of ``load_with``
        del sys.modules[name]
    return import_module(name)


def load_with(library: str, **in_place: object) -> None:
    """Import ``library`` while other values stand for some of the modules that it imports.

    With None the library finds no such module.
    """
    modules: dict[str, object] = sys.modules  # type: ignore[assignment] # None is Python's own way to say so
    before = {name: modules.get(name) for name in in_place}
    modules.update(in_place)
    try:
        real_module(library)
    finally:
        for name, usual in before.items():
            if usual is not None:
                modules[name] = usual
            elif name in modules and modules[name] is in_place[name]:
                del modules[name]


# --- work in copies of this process

_work: Callable[[Any], Any]
"""In a copy: the work that it does."""


def processors() -> int:
    """Return how many processors this process may use; 1 where it can't be copied."""
    if not hasattr(os, "sched_getaffinity"):
        return 1
    return len(os.sched_getaffinity(0))


def in_processes(
    work: Callable[[Given], Outcome], given: Sequence[Given], processes: int, instead: Outcome
) -> Iterator[Outcome]:
    """Yield the outcome of ``work`` for each value, in order; ``instead`` where the work ended its process.

    Each process begins as a copy of this one, in which no other thread may run. After such an end the work
    begins again at the first value without an outcome, which is then alone, so that the right one is blamed.
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
    """Ctrl+C reaches all processes of a terminal: a copy leaves it to the first one, and ends with that."""
    import signal
    import threading
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
