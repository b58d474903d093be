"""One audio worker process, in a session and process group of its own.

Two threads only move lines, so neither a full pipe nor a silent one makes a caller wait: one writes what
``send`` was given, one reads the responses. Each closes its own end. Ending the worker means ending its
group: otherwise the player that it started would stay behind.
"""

from __future__ import annotations

import ctypes
import os
import queue
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import IO, Any

from devices.audio.messages import LONGEST_LINE, AudioRequest, AudioResponse, response_from, to_line

_MODULE = "devices.audio.worker"
_ROOT = Path(__file__).resolve().parent.parent.parent
"""The folder from which ``devices`` was imported; the worker imports it from there, too."""

_MOST_UNSENT = 1_000
_REAP_SECONDS = 1.0


class WorkerProcess:
    """A started worker. ``on_response`` and ``on_end`` are called by the reading thread."""

    def __init__(
        self,
        device: str,
        prefer_bundled_voice: bool,
        log: Path | None,
        sounds: Path | None,
        voices: Mapping[str, tuple[str, ...]],
        on_response: Callable[[AudioResponse], None],
        on_end: Callable[[], None],
    ) -> None:
        """Start it. The calling thread must live as long as the worker may. Raises ``OSError``.

        ``voices``: their tags by language.
        """
        self._on_response = on_response
        self._on_end = on_end
        self._unsent: queue.SimpleQueue[AudioRequest | None] = queue.SimpleQueue()
        self._process = _start(device, prefer_bundled_voice, log, sounds, voices)
        for work in (self._write, self._read):
            threading.Thread(target=work, name="audio pipe", daemon=True).start()

    @property
    def pid(self) -> int:
        """Of the worker, and of its group."""
        return self._process.pid

    def send(self, request: AudioRequest) -> None:
        """Returns at once. A worker that reads nothing is noticed by its missing responses."""
        if self._unsent.qsize() < _MOST_UNSENT:
            self._unsent.put(request)

    def kill(self) -> None:
        """End the whole group, frozen or not."""
        _kill_group(self._process)
        self._unsent.put(None)
        with suppress(subprocess.TimeoutExpired):  # the kernel holds it; nothing more can be done
            self._process.wait(_REAP_SECONDS)

    def _write(self) -> None:
        with suppress(OSError), _pipe(self._process.stdin) as requests:
            while (request := self._unsent.get()) is not None:
                requests.write(to_line(request))
                requests.flush()

    def _read(self) -> None:
        with _pipe(self._process.stdout) as responses:
            while line := responses.readline(LONGEST_LINE):
                response = response_from(line)
                if response is not None:
                    self._on_response(response)
        self._on_end()


def _start(
    device: str,
    prefer_bundled_voice: bool,
    log: Path | None,
    sounds: Path | None,
    voices: Mapping[str, tuple[str, ...]],
) -> subprocess.Popen[bytes]:
    """``-P``: a folder called ``devices`` in the learner's working directory must not be imported."""
    voice = "bundled" if prefer_bundled_voice else "system"
    folder = "" if sounds is None else str(sounds)
    preferred = " ".join(f"{language}={','.join(tags)}" for language, tags in voices.items())
    command = (sys.executable, "-P", "-m", _MODULE, device, voice, str(os.getpid()), folder, preferred)
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
        **_group_options(),
    )


def _environment() -> dict[str, str]:
    known = os.environ.get("PYTHONPATH")
    path = os.pathsep.join((str(_ROOT), known)) if known else str(_ROOT)
    return {**os.environ, "PYTHONPATH": path}


def _group_options() -> dict[str, Any]:  # Popen's arguments differ by system
    if sys.platform == "win32":
        return {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP | subprocess.CREATE_NO_WINDOW}
    return {"start_new_session": True}


def _kill_group(process: subprocess.Popen[bytes]) -> None:
    """Before it is reaped, so no other process can have its number yet."""
    if sys.platform == "win32" or process.returncode is not None:
        process.kill()
        return
    with suppress(ProcessLookupError, PermissionError):
        os.killpg(process.pid, signal.SIGKILL)


def _pipe(pipe: IO[bytes] | None) -> IO[bytes]:
    assert pipe is not None  # both were requested
    return pipe


# --- a process that ends with its parent

CAN_DIE_WITH_PARENT = sys.platform == "linux"

_PR_SET_PDEATHSIG = 1
_prctl = getattr(ctypes.CDLL(None), "prctl", None) if CAN_DIE_WITH_PARENT else None
"""Looked up early: nothing may be loaded after a fork."""


def die_with_parent() -> None:
    """Ask the system to kill this process when the thread that started it ends. Linux only."""
    if _prctl is not None:
        _prctl(_PR_SET_PDEATHSIG, int(signal.SIGKILL), 0, 0, 0)
