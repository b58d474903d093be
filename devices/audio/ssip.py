"""SSIP, the protocol of speech-dispatcher: its messages, without I/O, and the address of its socket.

Source: the speech-dispatcher manual, chapter "SSIP". A reply is some lines ``NNN-text`` and a last one
``NNN text``; codes from 700 on are events about an earlier message.

The address is in ``SPEECHD_ADDRESS``, as ``unix_socket:/path`` or ``inet_socket:host:port``, which
speech-dispatcher's own clients read, too; otherwise the socket of this user is tried. With ``ssh -R`` either
reaches the learner's machine.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from contextlib import closing
from enum import Enum
from typing import TYPE_CHECKING

from msgspec import Struct

if TYPE_CHECKING:
    import socket

LONGEST_LINE = 4_096
"""Bytes; a server that sends longer lines is not a speech-dispatcher."""

_LINE = re.compile(r"(\d{3})([- ])(.*)")
_EVENTS_FROM = 700


class SsipEventKind(Enum):
    """What happened to a message."""

    BEGIN = 701
    END = 702
    CANCEL = 703


_KINDS = {each.value: each for each in SsipEventKind}


class SsipReply(Struct, frozen=True):
    """The answer to a command; ``lines`` are the texts before the last one."""

    code: int
    lines: tuple[str, ...]

    @property
    def is_ok(self) -> bool:
        return 200 <= self.code < 300


class SsipEvent(Struct, frozen=True):
    """Something happened to the message of that number."""

    kind: SsipEventKind
    message: str


class SsipProtocolError(Exception):
    """The server at the socket is not a speech-dispatcher."""


class SsipReader:
    """Decodes replies and events. Any chunking gives the same. Raises ``SsipProtocolError``."""

    def __init__(self) -> None:
        self._rest = b""
        self._lines: list[str] = []

    def feed(self, data: bytes) -> Iterator[SsipReply | SsipEvent]:
        *lines, self._rest = (self._rest + data).split(b"\n")
        if len(self._rest) > LONGEST_LINE or len(self._lines) > LONGEST_LINE:
            raise SsipProtocolError
        for line in lines:
            answer = self._decode(line.decode("utf-8", "replace").rstrip("\r"))
            if answer is not None:
                yield answer

    def _decode(self, line: str) -> SsipReply | SsipEvent | None:
        found = _LINE.fullmatch(line)
        if found is None:
            raise SsipProtocolError
        if found[2] == "-":
            self._lines.append(found[3])
            return None
        lines, self._lines = tuple(self._lines), []
        code = int(found[1])
        if code < _EVENTS_FROM:
            return SsipReply(code, lines)
        kind = _KINDS.get(code)
        return SsipEvent(kind, lines[0]) if kind and lines else None


def message_of(reply: SsipReply) -> str | None:
    """The message number in the reply to its text; None if the message was refused."""
    return reply.lines[0] if reply.is_ok and reply.lines else None


def greeting(user: str) -> tuple[bytes, ...]:
    """The commands of a new connection: the client's name, its priority, and the events it needs."""
    return (
        _command(f"SET SELF CLIENT_NAME {user}:donnie:main"),
        _command("SET SELF PRIORITY MESSAGE"),
        _command("SET SELF NOTIFICATION END ON"),
        _command("SET SELF NOTIFICATION CANCEL ON"),
    )


SPEAK = b"SPEAK\r\n"
CANCEL = b"CANCEL SELF\r\n"
QUIT = b"QUIT\r\n"


def set_language(tag: str) -> bytes:
    """The language of the following messages."""
    return _command(f"SET SELF LANGUAGE {tag}")


def set_parameter(name: str, value: int) -> bytes:
    """``RATE``, ``PITCH`` or ``VOLUME``, -100 to 100."""
    return _command(f"SET SELF {name} {value}")


def encode_text(text: str) -> bytes:
    """A message's text; a line that begins with a full stop gets a second one."""
    lines = [f".{line}" if line.startswith(".") else line for line in text.splitlines() or [""]]
    return "\r\n".join([*lines, ".", ""]).encode("utf-8", "replace")


def _command(text: str) -> bytes:
    return f"{text}\r\n".encode("utf-8", "replace")


# --- the address

_DEFAULT_PORT = 6560
_REACH_SECONDS = 0.25
"""A socket that does not accept a connection by then doesn't count as a voice."""


class SsipAddress(Struct, frozen=True):
    """A socket: ``path`` of a Unix one, or ``host`` and ``port``."""

    path: str = ""
    host: str = ""
    port: int = 0

    def connect(self, seconds: float) -> socket.socket:
        """A connected socket with that timeout. Raises ``OSError``."""
        import socket  # slow to load, and few learners have a speech-dispatcher

        if not self.path:
            return socket.create_connection((self.host, self.port), timeout=seconds)
        connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            connection.settimeout(seconds)
            connection.connect(self.path)
        except BaseException:
            connection.close()
            raise
        return connection


def find_address(variables: Mapping[str, str]) -> SsipAddress | None:
    """The address to try, or None: no address is given and this user has no socket."""
    given = variables.get("SPEECHD_ADDRESS", "")
    if given:
        return parse_address(given)
    runtime = variables.get("XDG_RUNTIME_DIR")
    path = os.path.join(runtime, "speech-dispatcher", "speechd.sock") if runtime else ""  # noqa: PTH118
    is_there = os.path.exists(path)  # noqa: PTH110 -- pathlib's raises in a folder without permission
    return SsipAddress(path=path) if is_there and _has_unix_sockets() else None


def parse_address(given: str) -> SsipAddress | None:
    """The address in ``SPEECHD_ADDRESS``; None if it can't be parsed."""
    method, _, place = given.partition(":")
    if method == "unix_socket" and place and _has_unix_sockets():
        return SsipAddress(path=place)
    if method != "inet_socket":
        return None
    host, _, port = place.rpartition(":") if ":" in place else (place, "", str(_DEFAULT_PORT))
    is_port = port.isdecimal() and 0 < int(port) < 65_536
    return SsipAddress(host=host or "127.0.0.1", port=int(port)) if is_port else None


def _has_unix_sockets() -> bool:
    import socket

    return hasattr(socket, "AF_UNIX")


def is_reachable(address: SsipAddress | None) -> bool:
    """Whether a server accepts a connection there, within a quarter of a second."""
    if address is None:
        return False
    try:
        with closing(address.connect(_REACH_SECONDS)):
            return True
    except OSError:
        return False
