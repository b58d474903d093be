"""Holds one audio worker process, in a session and process group of its own.

The two threads here do nothing but move lines, so that neither a full pipe nor a silent one keeps anybody
waiting: one writes what ``send`` was given, one reads what comes. Each closes its own end. Ending the
worker is ending its group: the worker alone would leave the player behind that it started.
"""

from __future__ import annotations

import os
import queue
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import IO, Any

from devices.audio_worker.messages import (
    LONGEST_LINE,
    Answer,
    Hush,
    Order,
    Ping,
    PlayCue,
    Say,
    from_line,
    to_line,
)

_MODULE = "devices.audio_worker"
_ROOT = Path(__file__).resolve().parent.parent.parent
"""The folder from which ``devices`` was imported; the worker takes it from there too."""

_MOST_UNSENT = 1_000
_REAP_SECONDS = 1.0


class WorkerProcess:
    """A started worker. ``on_answer`` and ``on_end`` are called by the reading thread."""

    def __init__(
        self,
        device: str,
        prefer_bundled_voice: bool,
        log: Path | None,
        sounds: Path | None,
        on_answer: Callable[[Answer], None],
        on_end: Callable[[], None],
    ) -> None:
        """Start it. The thread that does must live as long as the worker may. Raises ``OSError``."""
        self._on_answer = on_answer
        self._on_end = on_end
        self._unsent: queue.SimpleQueue[Order | None] = queue.SimpleQueue()
        self._process = _start(device, prefer_bundled_voice, log, sounds)
        for work in (self._write, self._read):
            threading.Thread(target=work, name="audio pipe", daemon=True).start()

    @property
    def pid(self) -> int:
        """Of the worker, and of its group."""
        return self._process.pid

    def send(self, order: Order) -> None:
        """Returns at once; a worker that reads nothing is found by its missing answers."""
        if self._unsent.qsize() < _MOST_UNSENT:
            self._unsent.put(order)

    def kill(self) -> None:
        """End the whole group, frozen or not."""
        _kill_group(self._process)
        self._unsent.put(None)
        with suppress(subprocess.TimeoutExpired):  # it sits in the kernel; nothing more can be done
            self._process.wait(_REAP_SECONDS)

    def _write(self) -> None:
        with suppress(OSError), _pipe(self._process.stdin) as orders:
            while (order := self._unsent.get()) is not None:
                orders.write(to_line(order))
                orders.flush()

    def _read(self) -> None:
        with _pipe(self._process.stdout) as answers:
            while line := answers.readline(LONGEST_LINE):
                answer = from_line(line)
                if answer is not None and not isinstance(answer, Say | PlayCue | Hush | Ping):
                    self._on_answer(answer)
        self._on_end()


def _start(
    device: str, prefer_bundled_voice: bool, log: Path | None, sounds: Path | None
) -> subprocess.Popen[bytes]:
    """``-P``: a folder called ``devices`` where the learner happens to be is not ours."""
    voice = "bundled" if prefer_bundled_voice else "system"
    own = "" if sounds is None else str(sounds)
    command = (sys.executable, "-P", "-m", _MODULE, device, voice, str(os.getpid()), own)
    if log is None:
        return _popen(command, subprocess.DEVNULL)
    with log.open("wb") as file:
        return _popen(command, file)


def _popen(command: tuple[str, ...], errors: int | IO[bytes]) -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        command,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=errors,
        env=_environment(),
        **_own_group(),
    )


def _environment() -> dict[str, str]:
    known = os.environ.get("PYTHONPATH")
    path = os.pathsep.join((str(_ROOT), known)) if known else str(_ROOT)
    return {**os.environ, "PYTHONPATH": path}


def _own_group() -> dict[str, Any]:  # Popen's arguments differ by system
    if sys.platform == "win32":
        return {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP | subprocess.CREATE_NO_WINDOW}
    return {"start_new_session": True}


def _kill_group(process: subprocess.Popen[bytes]) -> None:
    """Before it is reaped, so that its number can't be anybody else's."""
    if sys.platform == "win32" or process.returncode is not None:
        process.kill()
        return
    with suppress(ProcessLookupError, PermissionError):
        os.killpg(process.pid, signal.SIGKILL)


def _pipe(pipe: IO[bytes] | None) -> IO[bytes]:
    assert pipe is not None  # both were asked for
    return pipe
