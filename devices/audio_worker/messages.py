"""What Donnie and its audio worker say to each other: one JSON object a line, no I/O here.

Orders go to the worker, answers come back. Both ends are ours and of the same version; a line that makes
no sense is left out all the same, since the pipe must never be what brings Donnie down.
"""

from __future__ import annotations

import json
from dataclasses import asdict

from devices.ports.values import Frozen


class Say(Frozen):
    """Speak one sentence. Answered by ``Started`` and ``Finished``, or by ``Refused``."""

    number: int
    text: str
    language: str
    words_per_minute: int
    pitch: int
    volume: float


class PlayCue(Frozen):
    """Play a cue in ``delay`` seconds. Not answered."""

    name: str
    bearing: float
    steps: float | None
    volume: float
    delay: float


class Hush(Frozen):
    """Be silent at once. Answered by ``Hushed``."""

    number: int
    speech: bool
    cues: bool


class Ping(Frozen):
    """Are you there? Answered by ``Pong``."""

    number: int


class SoundReady(Frozen):
    """A player was opened; ``player`` is empty where nothing makes a sound."""

    player: str


class VoiceReady(Frozen):
    """The voice is loaded for ``languages``; empty where there is none."""

    languages: list[str]


class Started(Frozen):
    """A sentence of ``seconds`` is being heard."""

    number: int
    seconds: float


class Finished(Frozen):
    """A sentence was heard to its end."""

    number: int


class Refused(Frozen):
    """There is no voice for the sentence's language after all."""

    number: int


class Hushed(Frozen):
    number: int


class Pong(Frozen):
    """``frames`` is the player's heartbeat, -1 if it has none."""

    number: int
    frames: int
    is_playing: bool


Order = Say | PlayCue | Hush | Ping
Answer = SoundReady | VoiceReady | Started | Finished | Refused | Hushed | Pong

_KINDS: dict[str, type[Order | Answer]] = {
    kind.__name__: kind
    for kind in (
        Say, PlayCue, Hush, Ping, SoundReady, VoiceReady, Started, Finished, Refused, Hushed, Pong,
    )
}  # fmt: skip

_BEGINNING = b'{"is": "'

LONGEST_LINE = 65_536
"""Bytes; no message comes near it."""


def to_line(message: Order | Answer) -> bytes:
    """``message`` as a line with its newline; ASCII, so that no encoding can come between."""
    return json.dumps({"is": type(message).__name__, **asdict(message)}).encode("ascii") + b"\n"


def from_line(line: bytes) -> Order | Answer | None:
    """The message in ``line``, or None if there is none in it.

    What does not begin as ours is not parsed: json recurses in C as deep as a line is nested, and Python's
    limit, which would end that, is raised for the recursion of learners' programs.
    """
    if not line.startswith(_BEGINNING):
        return None
    try:
        fields = json.loads(line)
        return _KINDS[fields.pop("is")](**fields)
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return None
