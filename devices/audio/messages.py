"""The messages between Donnie and its audio worker: one JSON object a line. No I/O.

Requests go to the worker, responses come back. Both ends are of the same version. A line that is no message
is ignored all the same: the libraries in the worker may print, and Donnie must not fail because of it.
"""

from __future__ import annotations

from typing import TypeVar

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
    """A player was opened; ``player`` is empty where nothing can make a sound."""

    player: str


class VoiceReady(_Message, frozen=True):
    """The voice is loaded for ``languages``; empty where there is none."""

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
