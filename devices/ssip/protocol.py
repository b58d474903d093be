"""SSIP, the protocol of speech-dispatcher: what is sent and what comes back. Sans-IO.

Source: the speech-dispatcher manual, chapter "SSIP". A reply is some lines ``NNN-text`` and a last one
``NNN text``; codes from 700 on are events about a message that was queued before.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from enum import Enum

from devices.ports.values import Frozen

LONGEST_LINE = 4_096
"""Bytes; a server that sends longer ones is not a speech-dispatcher."""

_LINE = re.compile(r"(\d{3})([- ])(.*)")
_EVENTS_FROM = 700


class EventKind(Enum):
    """What is told of a message."""

    BEGIN = 701
    END = 702
    CANCEL = 703


_KINDS = {each.value: each for each in EventKind}


class Reply(Frozen):
    """The answer to a command; ``lines`` are the texts before the last one."""

    code: int
    lines: tuple[str, ...]

    @property
    def is_ok(self) -> bool:
        return 200 <= self.code < 300


class Event(Frozen):
    """Something happened to the message of that number."""

    kind: EventKind
    message: str


class NotSsip(Exception):
    """What answers there is no speech-dispatcher."""


class Reader:
    """Bytes in, replies and events out; any chunking gives the same. Raises ``NotSsip``."""

    def __init__(self) -> None:
        self._rest = b""
        self._lines: list[str] = []

    def feed(self, data: bytes) -> Iterator[Reply | Event]:
        *lines, self._rest = (self._rest + data).split(b"\n")
        if len(self._rest) > LONGEST_LINE or len(self._lines) > LONGEST_LINE:
            raise NotSsip
        for line in lines:
            answer = self._line(line.decode("utf-8", "replace").rstrip("\r"))
            if answer is not None:
                yield answer

    def _line(self, line: str) -> Reply | Event | None:
        found = _LINE.fullmatch(line)
        if found is None:
            raise NotSsip
        if found[2] == "-":
            self._lines.append(found[3])
            return None
        lines, self._lines = tuple(self._lines), []
        code = int(found[1])
        return Reply(code, lines) if code < _EVENTS_FROM else _event(code, lines)


def _event(code: int, lines: tuple[str, ...]) -> Event | None:
    kind = _KINDS.get(code)
    return Event(kind, lines[0]) if kind and lines else None


def message_of(reply: Reply) -> str | None:
    """The number of the message that a reply to its text names; None if it was refused."""
    return reply.lines[0] if reply.is_ok and reply.lines else None


def greeting(user: str) -> tuple[bytes, ...]:
    """The commands of a new connection: who speaks, behind whom, and what we want to be told."""
    return (
        _command(f"SET SELF CLIENT_NAME {user}:donnie:main"),
        _command("SET SELF PRIORITY MESSAGE"),
        _command("SET SELF NOTIFICATION END ON"),
        _command("SET SELF NOTIFICATION CANCEL ON"),
    )


SPEAK = b"SPEAK\r\n"
CANCEL = b"CANCEL SELF\r\n"
QUIT = b"QUIT\r\n"


def language(tag: str) -> bytes:
    """The language of what is said from now on."""
    return _command(f"SET SELF LANGUAGE {tag}")


def setting(name: str, value: int) -> bytes:
    """``RATE``, ``PITCH`` or ``VOLUME``, -100 to 100."""
    return _command(f"SET SELF {name} {value}")


def text(words: str) -> bytes:
    """A message: a line that begins with a full stop is given a second one."""
    lines = [f".{line}" if line.startswith(".") else line for line in words.splitlines() or [""]]
    return "\r\n".join([*lines, ".", ""]).encode("utf-8", "replace")


def _command(words: str) -> bytes:
    return f"{words}\r\n".encode("utf-8", "replace")
