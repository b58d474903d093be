"""Random packets of Player clients and random requests and frames of pages, for ``tests.tools.fuzz``.

Both go to the real servers: the packets without a socket, the requests and frames through one.
"""

from __future__ import annotations

import asyncio
import base64
import logging
import math
import random
import struct
import tempfile
import traceback
from collections.abc import Iterator
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

from aiohttp.http_exceptions import HttpProcessingError

from devices.player.codec import (
    ADDRESS,
    BANNER_SIZE,
    CAN_YOU,
    FORMS,
    HEADER_SIZE,
    LONGEST_REPLY,
    LONGEST_REQUEST,
    Interface,
    MessageReader,
    MessageType,
    PlayerMessage,
    TooLong,
    encode,
    values_of,
)
from donnie_tui.cli.page_server import PageServer
from donnie_tui.cli.page_session import PageLimits
from donnie_tui.i18n.words import Words
from donnie_tui.player.server import ClientProtocol, PlayerServer, Stations
from sim.velocity import VelocityLoop
from sim.world import World
from sim.worldfile import load_configuration
from tests.player.room import CONFIGURATION, Notes, write_room
from tests.tools.fuzz_files import Input, damaged

# --- packets of Player --------------------------------------------------------------------------------

_NUMBERS = (0, 1, 2, 3, 10, 255, 7665, 2**31 - 1, 2**31, 2**32 - 1)
_REALS = (0.0, 0.1, -0.3, 1.0, 90.0, 1e9, 1e308, -1e308, math.nan, math.inf, -math.inf, 5e-324)
_TEXTS = ("", "alice", "bob", "redbox", "olá", "\x1b[2J", "a" * 300, "_mp_color")
_SENT = [(interface, type_, subtype) for interface, type_, subtype in FORMS if type_ in (2, 3)]
_DEVICES = [(each.value, index) for each in Interface for index in (0, 0, 0, 1)]


def make_packets(chance: random.Random) -> bytes:
    """Right messages, with values that no one would send, then damages in some of them."""
    pieces = [_opened(chance, *device) for device in _DEVICES if chance.randrange(3)]
    pieces += [_packet(chance) for _ in range(chance.randrange(1, 40))]
    chance.shuffle(pieces)
    return b"".join(damaged(each, chance) if chance.randrange(12) == 0 else each for each in pieces)


def _opened(chance: random.Random, interface: int, index: int) -> bytes:
    access = chance.choice((1, 1, 1, 2, 3))
    body = encode(f"{ADDRESS} I t", (0, 7665, interface, index, access, ""))
    return PlayerMessage(Interface.PLAYER, 0, MessageType.REQUEST, 3, body, robot=7665).encoded()


def _packet(chance: random.Random) -> bytes:
    interface, type_, subtype = chance.choice(_SENT)
    form = FORMS[interface, type_, subtype]
    if chance.randrange(10) == 0:
        form, subtype = chance.choice((("II", CAN_YOU), (chance.choice([*FORMS.values()]), subtype)))
    if chance.randrange(20) == 0:
        type_ = chance.choice((0, 1, 4, 5, 6, 7, 2**32 - 1))
    index = chance.choice((0, 0, 0, 1, 2**32 - 1))
    body = encode(form, [*_values(form, chance)])
    return PlayerMessage(interface, index, type_, subtype, body, robot=7665).encoded()


def _values(form: str, chance: random.Random) -> Iterator[object]:
    """As many as the form has."""
    group = ""
    for letter in form.replace("64s", "s").replace(" ", ""):
        if letter == "[":
            group = letter
        elif letter == "]":
            rows = [[*_values(group[1:], chance)] for _ in range(chance.randrange(4))]
            yield [row[0] for row in rows] if len(group) == 2 else rows
            group = ""
        elif group:
            group += letter
        elif letter in "bs":
            yield chance.randbytes(64 if letter == "s" else chance.randrange(90))
        elif letter == "t":
            yield chance.choice(_TEXTS)
        elif letter == "i":
            yield chance.choice((-1, 0, 1, 2, 2**31 - 1, -(2**31)))
        elif letter == "f":
            yield chance.choice([each for each in _REALS if not 1e38 < abs(each) < math.inf])
        else:
            yield chance.choice(_NUMBERS if letter == "I" else _REALS)


@cache
def _room() -> Any:
    with tempfile.TemporaryDirectory() as folder:
        return load_configuration(write_room(Path(folder), CONFIGURATION))


class _Client:
    """The transport of a client that takes all at once."""

    def __init__(self) -> None:
        self.taken = bytearray()
        self.reads, self.is_cut = True, False

    def write(self, data: bytes) -> None:
        self.taken += data

    def abort(self) -> None:
        self.is_cut = True

    def is_closing(self) -> bool:
        return self.is_cut

    def is_reading(self) -> bool:
        return self.reads

    def pause_reading(self) -> None:
        self.reads = False

    def resume_reading(self) -> None:
        self.reads = True

    def set_write_buffer_limits(self, high: int) -> None: ...


def check_packets(data: Input) -> None:
    """Each request has one reply, all that is sent has its form, and no robot's pose is beyond numbers."""
    assert isinstance(data, bytes)
    asyncio.run(_serve_packets(data))


async def _serve_packets(data: bytes) -> None:
    found = _room()
    stations = Stations(found.drivers, VelocityLoop(World(found.scene)), 7665, Notes())
    server = PlayerServer(stations, "localhost", "3.1.0", lambda _: None)
    client, protocol = _Client(), ClientProtocol(server, stations.by_port[7665])
    protocol.connection_made(client)  # type: ignore[arg-type] # as much of one as is used
    chance = random.Random(len(data))
    at = 0
    while at < len(data):
        size = chance.choice((1, 40, 200, 5000))
        protocol.data_received(data[at : at + size])
        assert len(protocol._connection._reader.held) <= LONGEST_REQUEST + HEADER_SIZE
        at += size
        stations.step()
        protocol.pass_on()
    for _ in range(5):
        stations.step()
        protocol.pass_on()
    _hold_what_was_sent(bytes(client.taken), _requests(data), is_cut=client.is_cut)
    protocol.connection_lost(None)
    assert not server.clients


def _requests(data: bytes) -> int:
    """How many messages of a stream want a reply."""
    count = 0
    with suppress(TooLong):
        for each in MessageReader().feed(data):
            is_rubbish = each.type > MessageType.NACK and each.interface == Interface.PLAYER
            count += each.type == MessageType.REQUEST or is_rubbish
    return count


def _hold_what_was_sent(sent: bytes, requests: int, *, is_cut: bool) -> None:
    assert sent.startswith(b"Player v.")
    reader = MessageReader(LONGEST_REPLY)
    messages = [*reader.feed(sent[BANNER_SIZE:])]
    assert len(reader.held) == 0, "half a message was sent"
    replies = 0
    for each in messages:
        is_bare_refusal = each.type == MessageType.NACK and not each.body
        values = () if is_bare_refusal else values_of(each)
        replies += each.type in (MessageType.ACK, MessageType.NACK)
        if (each.interface, each.type) == (Interface.POSITION2D, MessageType.DATA):
            assert all(math.isfinite(float(str(value))) for value in values), f"a pose of {values}"
    assert replies <= requests if is_cut else replies == requests, f"{replies} replies to {requests} requests"


# --- requests and frames of pages ---------------------------------------------------------------------

_HEAD = (
    "GET /ws?width=80&height=24 HTTP/1.1\r\nHost: localhost:{port}\r\nOrigin: http://localhost:{port}\r\n"
    "Cookie: {cookie}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
    "Sec-WebSocket-Key: {key}\r\n\r\n"
)
_SILENCE = 0.05
"""Seconds after which a server that waits for more is left alone; nothing depends on it."""
_REFUSAL = 10.0
"""Seconds until the answer to a request without the cookie must be there."""
_TEXT, _BINARY, _CLOSE, _PING, _PONG = 1, 2, 8, 9, 10
_CONTENTS = (
    b'["stdin", "FW 1"]',
    b'["resize", {"width": 80, "height": 24}]',
    b'["focus"]',
    b"[",
    b"\xff\xfe",
)


CONNECTIONS = 20
"""Of one case, all at the same time."""
_NEXT = b"\r\n\0next\0\r\n"
"""Between the bytes of two connections."""


def make_frames(chance: random.Random) -> bytes:
    return _NEXT.join(_connection(chance) for _ in range(CONNECTIONS))


def _connection(chance: random.Random) -> bytes:
    """A byte that says whether the cookie is there and what was damaged; then frames."""
    frames = [_frame(chance) for _ in range(chance.randrange(1, 12))]
    first = bytes([chance.choice((0, 0, 0, 1, 2, 3))])
    return first + b"".join(damaged(each, chance) if chance.randrange(6) == 0 else each for each in frames)


def _frame(chance: random.Random) -> bytes:
    code = chance.choice((_TEXT, _TEXT, _TEXT, _BINARY, 0, _PING, _PONG, _CLOSE, chance.randrange(16)))
    final, reserved = chance.choice((0x80, 0x80, 0x80, 0)), chance.choice((0, 0, 0, 0, 0x40, 0x10))
    content = chance.choice(
        (*_CONTENTS, chance.randbytes(chance.randrange(300)), b'["stdin", "' + b"a" * 3000)
    )
    said = chance.choice((len(content),) * 6 + (2**63, 2**32, len(content) + 5, 0))
    length = said if said < 126 else 126 if said < 2**16 else 127
    extended = b"" if length < 126 else struct.pack(">H" if length == 126 else ">Q", said)
    mask = chance.randbytes(4)
    is_masked = chance.randrange(12) > 0
    body = bytes(each ^ mask[at % 4] for at, each in enumerate(content)) if is_masked else content
    head = bytes([final | reserved | code, length | 0x80 * is_masked]) + extended
    return head + mask * is_masked + body


def check_frames(data: Input) -> None:
    """Without the cookie nothing comes in; whatever a page sends, the server serves on."""
    assert isinstance(data, bytes)
    asyncio.run(_serve_frames(data.split(_NEXT)))


class _Faults(logging.Handler):
    """What is logged and is not only about a request that can't be read."""

    def __init__(self) -> None:
        super().__init__(logging.WARNING)
        self.found: list[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        error = record.exc_info[1] if record.exc_info else None
        if not isinstance(error, HttpProcessingError):
            trace = traceback.format_exception(error) if error is not None else ()
            self.found.append("".join((record.getMessage(), *trace)))


async def _serve_frames(connections: list[bytes]) -> None:
    log: list[str] = []
    limits = PageLimits(frame=2000, sessions=CONNECTIONS, end=2)
    server = PageServer(["/bin/cat"], Words("en"), log.append, limits, address="127.0.0.1", port=0)
    await server.start()
    assert server._runner is not None
    faults = _Faults()
    server._runner._kwargs["logger"].addHandler(faults)
    try:
        port = server._listeners[0].sockets[0].getsockname()[1]
        server.gate._port = port
        cookie = f"{server.gate.cookie_name}={server.gate.cookie}"
        await asyncio.gather(*(_send_frames(port, cookie, each[:1], each[1:]) for each in connections))
        proper = f"GET / HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nCookie: {cookie}\r\nConnection: close\r\n\r\n"
        assert (await _answer_to(port, proper.encode())).startswith(b"HTTP/1.1 200 ")
        async with asyncio.timeout(10), server._ended:
            await server._ended.wait_for(lambda: not server._sessions)
        assert not faults.found, faults.found
    finally:
        await server.close()


async def _send_frames(port: int, cookie: str, first: bytes, frames: bytes) -> None:
    """The first byte is the one that ``_connection`` makes."""
    damage = int.from_bytes(first) % 4
    chance = random.Random(frames)
    key = base64.b64encode(chance.randbytes(16)).decode()
    wrong = (cookie, cookie[:-1], "", cookie.swapcase())[damage]
    head = _HEAD.format(port=port, cookie=wrong, key=key).encode()
    if damage == 0 and chance.randrange(4) == 0:
        head = damaged(head, chance)
    answer = await _answer_to(port, head + frames, _REFUSAL if damage else _SILENCE)
    if damage:
        assert answer, "no answer came"
        assert b" 101 " not in answer.split(b"\r\n")[0], "a page came in without the cookie"


async def _answer_to(port: int, data: bytes, patience: float = 5.0) -> bytes:
    """All that comes until the server ends the connection, or is silent for so many seconds."""
    reader, writer = await asyncio.open_connection("127.0.0.1", port)
    answer = b""
    with suppress(ConnectionError, TimeoutError):
        writer.write(data)
        await writer.drain()
        while piece := await asyncio.wait_for(reader.read(65536), patience):
            answer += piece
    writer.transport.abort()
    return answer
