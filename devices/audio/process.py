"""The audio worker process, in a session and process group of its own, and the messages to it and from it.

A message is one JSON object a line: requests go to the worker, responses come back. Both ends are of the same
version. A line that is no message is ignored all the same: the libraries in the worker may print, and Donnie
must not fail because of it.

Two threads only move lines, so neither a full pipe nor a silent one makes a caller wait: one writes what
``send`` was given, one reads the responses. Each closes its own end. Ending the worker means ending its
group: otherwise the player that it started would stay behind."""

from __future__ import annotations

import ctypes
import os
import queue
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Mapping
from contextlib import nullcontext, suppress
from pathlib import Path
from typing import IO, Any, TypeVar

import msgspec
from msgspec import Struct

_M = TypeVar("_M")


class _Message(Struct, frozen=True, tag_field="is", forbid_unknown_fields=True, tag=True):
    """Written with the name of its class under ``is``."""


class Say(_Message, frozen=True):
    """Speak one sentence. Answered by ``SpeechStarted`` and ``SpeechFinished``, or by ``SpeechRefused``."""

    number: int
    text: str
    language: str
    words_per_minute: int
    pitch: int
    volume: float


class PlayCue(_Message, frozen=True):
    """Play a cue in ``delay`` seconds. Not answered."""

    name: str
    bearing: float
    steps: float | None
    volume: float
    delay: float


class Silence(_Message, frozen=True):
    """Be silent at once. Answered by ``Silenced``."""

    number: int
    speech: bool
    cues: bool


class Ping(_Message, frozen=True):
    """Ask whether the worker responds. Answered by ``Pong``."""

    number: int


class SoundReady(_Message, frozen=True):
    """A player was opened; ``player`` is empty if nothing can make a sound."""

    player: str


class VoiceReady(_Message, frozen=True):
    """The voice is loaded for ``languages``; empty if there is none."""

    languages: tuple[str, ...]


class SpeechStarted(_Message, frozen=True):
    """A sentence of ``seconds`` is being played."""

    number: int
    seconds: float


class SpeechFinished(_Message, frozen=True):
    """A sentence was played to its end."""

    number: int


class SpeechRefused(_Message, frozen=True):
    """There is no voice for the sentence's language after all."""

    number: int


class Silenced(_Message, frozen=True):
    number: int


class Pong(_Message, frozen=True):
    """``frames`` is the player's heartbeat, -1 if it has none."""

    number: int
    frames: int
    is_playing: bool


AudioRequest = Say | PlayCue | Silence | Ping
AudioResponse = SoundReady | VoiceReady | SpeechStarted | SpeechFinished | SpeechRefused | Silenced | Pong

LONGEST_LINE = 65_536
"""Bytes; no message comes near it."""

_REQUESTS = msgspec.json.Decoder[AudioRequest](AudioRequest)
_RESPONSES = msgspec.json.Decoder[AudioResponse](AudioResponse)
_ENCODER = msgspec.json.Encoder()

_BEGINNING = b'{"is":"'


def to_line(message: AudioRequest | AudioResponse) -> bytes:
    """``message`` as a line with its newline. Numbers must be finite, and texts without lone surrogates."""
    return _ENCODER.encode(message) + b"\n"


def request_from(line: bytes) -> AudioRequest | None:
    """The request in ``line``, or None if there is none."""
    return _decoded(_REQUESTS, line)


def response_from(line: bytes) -> AudioResponse | None:
    """The response in ``line``, or None if there is none."""
    return _decoded(_RESPONSES, line)


def _decoded(decoder: msgspec.json.Decoder[_M], line: bytes) -> _M | None:
    """Decodes only what begins with the tag: the decoder recurses as deep as an unknown first field is
    nested, and Python's limit, which would end that, is raised for the recursion of learners' programs."""
    if not line.startswith(_BEGINNING):
        return None
    try:
        return decoder.decode(line)
    except ValueError:
        return None


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
        """The number of the worker, and of its group."""
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
    with nullcontext(subprocess.DEVNULL) if log is None else log.open("wb") as errors:
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
    """Kills the group of a process before it is reaped: no other process can have its number yet."""
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
