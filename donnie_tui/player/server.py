"""The server's sockets and ticks, in one asyncio loop.

A client that reads slowly delays no other: nothing more is written to it until it has read, and its data are
replaced by newer ones. What a client sends is bounded, and so is how many there are.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import cast

from devices.player.codec import TooLong
from devices.player.connection import ClientConnection
from devices.ports.drive import TICK
from donnie_tui.player.stations import PortStation, Stations

MOST_CLIENTS = 64
"""Of all ports together."""
SILENCE = 60.0
"""Seconds in which a client must have sent a whole message, and one that doesn't read must have read."""
_HIGH_WATER = 256 * 1024
_LATE = 1.0
"""Seconds behind real time after which what is lost is not made up for."""


class PlayerServer:
    """Robots for clients, from ``run`` until it is cancelled."""

    def __init__(
        self, stations: Stations, host: str, version: str, complain: Callable[[str], object]
    ) -> None:
        """``complain`` gets the code of a sentence, at most once for each code."""
        self._stations, self._host, self.version = stations, host, version
        self._complain = complain
        self._complaints: set[str] = set()
        self.clients: set[ClientProtocol] = set()

    async def run(self, speed: Callable[[], float | None], on_start: Callable[[], object]) -> None:
        """``speed``: how often faster than real time; None as fast as possible. Raises ``PortRefused``."""
        loop = asyncio.get_running_loop()
        servers: list[asyncio.Server] = []
        try:
            for station in self._stations.by_port.values():
                try:
                    servers.append(await loop.create_server(self._maker(station), self._host, station.port))
                except OSError as problem:
                    raise PortRefused(station.port, problem.strerror or str(problem)) from None
            on_start()
            await self._tick(speed)
        finally:
            for server in servers:
                server.close()
            for client in tuple(self.clients):
                client.end()

    def complain(self, code: str) -> None:
        if code not in self._complaints:
            self._complaints.add(code)
            self._complain(code)

    def _maker(self, station: PortStation) -> Callable[[], ClientProtocol]:
        return lambda: ClientProtocol(self, station)

    async def _tick(self, speed: Callable[[], float | None]) -> None:
        loop = asyncio.get_running_loop()
        due = loop.time()
        while True:
            self._stations.step()
            for client in tuple(self.clients):
                client.pass_on()
                client.check(loop.time())
            times = speed()
            due = max(due + (TICK / times if times else 0.0), loop.time() - _LATE)
            await asyncio.sleep(max(0.0, due - loop.time()))


class PortRefused(Exception):
    """A port that can't be listened on, and why."""

    def __init__(self, port: int, reason: str) -> None:
        super().__init__(reason)
        self.port, self.reason = port, reason


class ClientProtocol(asyncio.Protocol):
    """One client's socket."""

    def __init__(self, server: PlayerServer, station: PortStation) -> None:
        self._server, self._station = server, station
        self._connection = ClientConnection(station, server.version)
        self._transport: asyncio.Transport | None = None
        self._may_write = True
        self._since = 0.0
        """When it connected, or stopped reading."""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self._transport = cast(asyncio.Transport, transport)
        if len(self._server.clients) >= MOST_CLIENTS:
            self._server.complain("player-full")
            self._transport.abort()
            return
        self._since = asyncio.get_running_loop().time()
        self._transport.set_write_buffer_limits(_HIGH_WATER)
        self._server.clients.add(self)
        self._station.clients.add(self._connection)
        self.pass_on()

    def data_received(self, data: bytes) -> None:
        if self not in self._server.clients:
            return
        try:
            self._connection.receive(data)
        except TooLong:
            self._server.complain("player-rubbish")
            self.end()
            return
        self.pass_on()
        if self._connection.is_behind and self._transport is not None:
            self._transport.pause_reading()

    def pause_writing(self) -> None:
        self._may_write = False
        self._since = asyncio.get_running_loop().time()

    def resume_writing(self) -> None:
        self._may_write = True
        self.pass_on()

    def connection_lost(self, exc: Exception | None) -> None:  # noqa: ARG002 -- any end is the same
        self._leave()

    def pass_on(self) -> None:
        """Write what may go out now."""
        if self._may_write and self._transport is not None and not self._transport.is_closing():
            data = self._connection.take()
            if data:
                self._transport.write(data)
            if not self._transport.is_reading():
                self._transport.resume_reading()

    def check(self, now: float) -> None:
        """Send it away if it was silent, or read nothing, for too long."""
        if now - self._since > SILENCE and not (self._may_write and self._connection.has_spoken):
            self.end()

    def end(self) -> None:
        self._leave()
        if self._transport is not None:
            self._transport.abort()

    def _leave(self) -> None:
        self._server.clients.discard(self)
        self._station.clients.discard(self._connection)
        self._connection.close()
