"""Tests that are collected once: each mistake is tried in a child of the process that did.

As a plugin of pytest it runs no tests, but waits for requests and forks for each. The child puts the changed
functions in the place of the old ones, and runs the tests that the request names until one fails.
``ForkedTests`` starts such a pytest and asks it.
"""

from __future__ import annotations

import gc
import json
import os
import select
import signal
import subprocess
import sys
import time
from collections import defaultdict
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from math import inf
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any

import pytest

HASH_SEED = "0"
"""So that each process collects the same names of tests, where they come from a set."""
_PIPES = "FORKED_TESTS_PIPES"


# --- in pytest


def pytest_runtestloop(session: pytest.Session) -> bool | None:
    if _PIPES not in os.environ:
        return None
    requests, answers = map(int, os.environ.pop(_PIPES).split())
    items = {each.nodeid: each for each in session.items}
    functions = _functions_by_path()
    _send(answers, sorted(items))
    with os.fdopen(requests, encoding="utf-8") as lines:
        for line in lines:
            child = os.fork()
            if not child:
                os.setsid()
                _send(answers, {"child": os.getpid()})
                try:
                    _run(json.loads(line), items, functions, answers)
                finally:
                    os._exit(0)
            os.waitpid(child, 0)
            _send(answers, {"ended": child})
    return True


def _functions_by_path() -> dict[str, list[FunctionType]]:
    """All that there are, by the file that they are from.

    A child that looked through all objects would get a copy of all memory, as it would with a garbage
    collection that is not kept away from them.
    """
    gc.unfreeze()
    found: dict[str, list[FunctionType]] = defaultdict(list)
    for each in gc.get_objects():
        if isinstance(each, FunctionType):
            found[each.__code__.co_filename].append(each)
    gc.collect()
    gc.freeze()
    return found


def _run(
    request: dict[str, Any],
    items: dict[str, pytest.Item],
    functions: Mapping[str, Sequence[FunctionType]],
    answers: int,
) -> None:
    path = request["path"]
    if path and not (_run_anew(path) if request["is_imported"] else _replace(path, functions.get(path, ()))):
        return _send(answers, {"needs": "a new process"})
    failed: list[str] = []

    class Watch:
        def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
            if report.failed and not failed:
                failed.append(report.nodeid)
                _send(answers, {"failed": report.nodeid})

    chosen = [items[each] for each in request["names"]]
    chosen[0].config.pluginmanager.register(Watch())
    for item, following in zip(chosen, [*chosen[1:], None], strict=True):
        _send(answers, {"begins": item.nodeid})
        try:
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
        except BaseException:  # noqa: BLE001 -- of pytest, while it reports a failure
            return _send(answers, {"failed": item.nodeid})
        if failed or sum(os.times()[:4]) > request["seconds"]:
            return item.session._setupstate.teardown_exact(None)
    return None


def _replace(path: str, functions: Sequence[FunctionType]) -> bool:
    """Gives the functions from a module's file the code that its file has now. Whether one has changed."""
    if not any(getattr(each, "__file__", None) == path for each in [*sys.modules.values()]):
        return True  # it will be imported
    code = compile(Path(path).read_bytes(), path, "exec", dont_inherit=True)
    new = {(each.co_firstlineno, each.co_qualname): each for each in _outermost(code)}
    changed = False
    for each in functions:
        other = new.get((each.__code__.co_firstlineno, each.__code__.co_qualname))
        if other is not None and other != each.__code__:
            each.__code__ = other
            changed = True
    return changed


def _run_anew(path: str) -> bool:
    """Runs a module once more where it is, and gives its new values to those that imported the old ones.

    Not all have them then, and a class that is made twice is two: a test that fails is believed only if it
    passes with the unchanged module, run anew as well. Whether the module could be run.
    """
    loaded = [each for each in [*sys.modules.values()] if getattr(each, "__file__", None)]
    (module,) = [each for each in loaded if each.__file__ == path] or [None]
    if module is None:
        return True  # it will be imported
    old = dict(vars(module))
    try:
        exec(compile(Path(path).read_bytes(), path, "exec", dont_inherit=True), vars(module))
    except Exception:  # noqa: BLE001 -- a new process says so, too
        return False
    for name, value in old.items():
        new = vars(module)[name]
        if new is not value and not name.startswith("__"):
            for other in loaded:
                if vars(other).get(name) is value:
                    setattr(other, name, new)
    return True


def _outermost(code: CodeType) -> list[CodeType]:
    """The functions of a module and its classes, but not those within functions."""
    found = []
    for each in code.co_consts:
        if isinstance(each, CodeType):
            is_function = each.co_flags & 0x2  # CO_NEWLOCALS; the body of a class has it not
            found += [each] if is_function else _outermost(each)
    return found


def _send(pipe: int, message: object) -> None:
    os.write(pipe, (json.dumps(message) + "\n").encode())


# --- in the process that asks


@dataclass
class ForkedTests:
    """A pytest that has collected the tests of a folder."""

    folder: Path
    options: Sequence[str]

    def __post_init__(self) -> None:
        theirs, self._requests = os.pipe()
        self._answers, their_answers = os.pipe()
        environment = {
            **os.environ,
            "PYTHONPATH": str(self.folder),
            "PYTHONDONTWRITEBYTECODE": "1",
            "PYTHONHASHSEED": HASH_SEED,
            _PIPES: f"{theirs} {their_answers}",
        }
        self._process = subprocess.Popen(
            [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-p", "no:xdist", "--tb=native",
             "-p", "tests.tools.forked_tests", *self.options],
            cwd=self.folder, env=environment, pass_fds=(theirs, their_answers), stdin=subprocess.DEVNULL,
            start_new_session=True,
            stdout=(self.folder / ".printed").open("wb"), stderr=subprocess.STDOUT,
        )  # fmt: skip
        os.close(theirs)
        os.close(their_answers)
        self._left = b""
        self.has_no_end = False
        """The last time: a test was ended because it took too long."""
        self.names = frozenset(self._next(3600))

    def first_failure(
        self,
        path: Path | None,
        names: Sequence[str],
        limits: Mapping[str, float],
        *,
        is_imported: bool = False,
        seconds: float = inf,
    ) -> str | None:
        """The first of the tests that fails with what the module's file says now; empty if all pass.

        One that doesn't end within its seconds in ``limits`` fails. None if no function has other code.
        ``is_imported``: the change is outside of functions. ``seconds``: of a processor; no test begins
        after them.
        """
        request = {
            "path": str(path) if path else "",
            "names": list(names),
            "is_imported": is_imported,
            "seconds": seconds,
        }
        os.write(self._requests, (json.dumps(request) + "\n").encode())
        by: str | None = ""
        self.has_no_end = False
        child, running, limit = 0, "", 600.0
        while True:
            try:
                answer = self._next(limit)
            except TimeoutError:
                self.has_no_end = not by
                by = by or running
                os.killpg(child, signal.SIGKILL)
                limit = 600.0
                continue
            match answer:
                case {"child": child}:
                    pass
                case {"begins": str(running)}:
                    limit = limits[running]
                case {"failed": str(by)}:
                    limit = 60.0
                case {"needs": _}:
                    by = None
                case {"ended": _}:
                    self._end_the_rest(child)
                    return by

    def _end_the_rest(self, child: int) -> None:
        with suppress(ProcessLookupError):
            os.killpg(child, signal.SIGKILL)

    def _next(self, seconds: float) -> Any:
        until = time.monotonic() + seconds
        while b"\n" not in self._left:
            if not select.select([self._answers], [], [], max(0.0, until - time.monotonic()))[0]:
                raise TimeoutError
            got = os.read(self._answers, 1 << 20)
            if not got:
                raise RuntimeError((self.folder / ".printed").read_text(errors="replace")[-2000:])
            self._left += got
        line, _, self._left = self._left.partition(b"\n")
        return json.loads(line)

    def close(self) -> None:
        os.close(self._requests)
        self._process.wait()
