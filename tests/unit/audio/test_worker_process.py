"""The pipes to an audio worker and its start, with the test in the worker's place."""

from __future__ import annotations

import os
import queue
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from devices.audio import process as module
from devices.audio.process import Ping, Pong, SoundReady, WorkerProcess, request_from, to_line
from tests.conftest import ROOT
from tests.timeouts import TIMEOUT


class Worker:
    """The other ends of the pipes."""

    def __init__(self, patch: pytest.MonkeyPatch) -> None:
        theirs, ours = os.pipe()
        self.requests = os.fdopen(theirs, "rb")
        ours_in, theirs_out = os.pipe()
        self.responses = os.fdopen(theirs_out, "wb", buffering=0)
        self.process = SimpleNamespace(
            pid=4711, stdin=os.fdopen(ours, "wb"), stdout=os.fdopen(ours_in, "rb"), wait=self._wait
        )
        self.did: list[tuple[str, object]] = []
        self.given: list[Any] = []
        patch.setattr(module, "_start", lambda *given: self.given.append(given) or self.process)
        patch.setattr(module, "_kill_group", lambda process: self.did.append(("killed", process.pid)))
        self.received: queue.Queue[object] = queue.Queue()
        self.worker = WorkerProcess(
            "null",
            True,
            None,
            Path("sounds"),
            {"en": ("en",)},
            self.received.put,
            lambda: self.received.put("end"),
        )

    def _wait(self, seconds: float) -> None:
        self.did.append(("waited", seconds))
        raise subprocess.TimeoutExpired("worker", seconds)

    def close(self) -> None:
        self.worker._unsent.put(None)
        self.requests.close()
        self.responses.close()


@pytest.fixture
def worker(monkeypatch: pytest.MonkeyPatch) -> Iterator[Worker]:
    made = Worker(monkeypatch)
    yield made
    made.close()


def test_requests_are_lines_in_their_order(worker: Worker) -> None:
    assert worker.given == [("null", True, None, Path("sounds"), {"en": ("en",)})]
    assert worker.worker.pid == 4711
    for number in range(3):
        worker.worker.send(Ping(number))

    assert [request_from(worker.requests.readline()) for _ in range(3)] == [Ping(0), Ping(1), Ping(2)]


def test_responses_are_taken_and_other_lines_are_not(worker: Worker) -> None:
    worker.responses.write(b"ALSA lib\n" + to_line(SoundReady("fake")) + b"{}\n" + to_line(Pong(1, 2, True)))

    assert worker.received.get(timeout=TIMEOUT) == SoundReady("fake")
    assert worker.received.get(timeout=TIMEOUT) == Pong(1, 2, True)
    worker.responses.close()
    assert worker.received.get(timeout=TIMEOUT) == "end"
    assert worker.received.empty()


def test_a_killed_worker_is_waited_for_a_second_and_its_pipe_is_closed(worker: Worker) -> None:
    worker.worker.kill()

    assert worker.did == [("killed", 4711), ("waited", 1.0)]
    assert worker.requests.read() == b""


def test_a_worker_that_reads_nothing_has_a_thousand_unsent_requests_at_most(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(threading, "Thread", lambda **_: SimpleNamespace(start=lambda: None))
    made = Worker(monkeypatch)
    for number in range(1001):
        made.worker.send(Ping(number))

    assert made.worker._unsent.qsize() == 1000
    made.close()


# --- its start


@pytest.mark.parametrize("has_log", [False, True])
def test_a_worker_is_given_its_device_voice_parent_sounds_and_voices(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, has_log: bool
) -> None:
    started: list[tuple[Any, ...]] = []
    monkeypatch.setattr(subprocess, "Popen", lambda *given, **options: started.append((*given, options)))
    log = tmp_path / "log" if has_log else None
    if log is not None:
        log.write_text("of before")
    voices = {"en": ("en-gb", "en"), "pt": ("pt-br",)}
    module._start("auto", False, log, None, voices)
    module._start("null", True, log, tmp_path, {})

    me = str(os.getpid())
    begin = (sys.executable, "-P", "-m", "devices.audio.worker")
    assert [each[0] for each in started] == [
        (*begin, "auto", "system", me, "", "en=en-gb,en pt=pt-br"),
        (*begin, "null", "bundled", me, str(tmp_path), ""),
    ]
    for _, options in started:
        assert (options["stdin"], options["stdout"]) == (subprocess.PIPE, subprocess.PIPE)
        assert options["start_new_session"] is True
        if log is None:
            assert options["stderr"] == subprocess.DEVNULL
        else:
            assert (options["stderr"].name, log.read_text()) == (str(log), "")


@pytest.mark.parametrize(("known", "path"), [(None, str(ROOT)), ("/a", f"{ROOT}{os.pathsep}/a")])
def test_a_worker_imports_what_its_parent_does(
    monkeypatch: pytest.MonkeyPatch, known: str | None, path: str
) -> None:
    monkeypatch.setenv("SOMETHING", "else")
    if known is None:
        monkeypatch.delenv("PYTHONPATH", raising=False)
    else:
        monkeypatch.setenv("PYTHONPATH", known)

    assert module._environment() == {**os.environ, "PYTHONPATH": path}


def test_the_whole_group_of_a_worker_is_killed_until_it_is_reaped(monkeypatch: pytest.MonkeyPatch) -> None:
    did: list[tuple[object, ...]] = []

    def kill_group(number: int, sent: int) -> None:
        did.append((number, sent))
        raise ProcessLookupError

    monkeypatch.setattr(os, "killpg", kill_group)
    for returned in (None, 0):
        process: Any = SimpleNamespace(pid=4711, returncode=returned, kill=lambda: did.append(("alone",)))
        module._kill_group(process)

    assert did == [(4711, signal.SIGKILL), ("alone",)]
