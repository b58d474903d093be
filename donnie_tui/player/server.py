"""The Player server: the devices of each port, their sockets and ticks, in one asyncio loop.

The addresses of a driver are taken in their order; each gets the first free model of its type,
the robot itself before its parts. A client that reads slowly delays no other: nothing more is
written to it until it has read, and newer data replace waiting ones. Messages and the number of
clients are bounded.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING, cast

from devices.player.codec import DATA, Interface, Key, TooLong, body_of
from devices.player.connection import ClientConnection
from devices.ports.drive import TICK
from devices.serial_ports import reason_of
from donnie_tui.player.equipment import MOUNTED, STAGE, DeviceContext, Equipment, Reporter, service_of

if TYPE_CHECKING:
    from sim.scene import Model
    from sim.velocity import VelocityLoop
    from sim.worldfile import Address, Driver


class ServerProblem(Exception):
    """The code of a sentence, and its parameters."""

    def __init__(self, code: str, **values: str | int) -> None:
        self.code, self.values = code, values


class PortStation:
    """The devices of one port. See ``devices.player.connection.Station``."""

    def __init__(self, port: int, loop: VelocityLoop) -> None:
        self.port = port
        self.devices: dict[Key, Equipment] = {}
        self.clients: set[ClientConnection] = set()
        self._loop = loop

    @property
    def time(self) -> float:
        return self._loop.time

    def add(self, device: Equipment) -> None:
        """Raises ``ServerProblem`` for a second device of one address."""
        key = (device.interface, device.index)
        if key in self.devices:
            name = Interface(device.interface).name.lower()
            raise ServerProblem("player-address-twice", what=f"{self.port}:{name}:{device.index}")
        self.devices[key] = device

    def publish(self) -> None:
        """Send the data of open devices to all clients."""
        for key, device in self.devices.items():
            if device.users:
                for subtype, values in device.data():
                    body = body_of(device.interface, DATA, subtype, *values)
                    for client in self.clients:
                        client.publish(key, subtype, body)


_MOST_NAMES = 10
"""Robots that are named where a model is unknown."""


class Stations:
    """All ports of a configuration, and the world that they share."""

    def __init__(
        self, drivers: Sequence[Driver], loop: VelocityLoop, default_port: int, reporter: Reporter
    ) -> None:
        """``default_port`` is for addresses without a port. Raises ``ServerProblem``."""
        self.by_port: dict[int, PortStation] = {}
        self._drivers = drivers
        self.left_out: list[str] = []
        """Addresses of devices that Donnie doesn't offer."""
        self._scene, self._loop, self._reporter, self._default = loop.scene, loop, reporter, default_port
        given: set[int] = set()
        for driver in drivers:
            for address in driver.addresses:
                device = self._device(driver, address, given)
                if device is None:
                    self.left_out.append(f"{address.interface}:{address.index}")
                else:
                    port = self._port(address)
                    self.by_port.setdefault(port, PortStation(port, loop)).add(device)

    def step(self) -> None:
        """Run a tick: the devices' commands, the world, then the data."""
        self._reporter.on_tick()
        for station in self.by_port.values():
            for device in station.devices.values():
                device.step()
        self._loop.advance()
        for station in self.by_port.values():
            station.publish()

    def _port(self, address: Address) -> int:
        return address.port if address.has_port else self._default

    def _device(self, driver: Driver, address: Address, given: set[int]) -> Equipment | None:
        interface = address.interface
        service = service_of(interface, driver.name)
        if address.index > 0xFFFF:
            return None
        if service is not None:
            return service(self._fitting(driver, address, self._robot_of(address)))
        if driver.name != STAGE or interface not in MOUNTED:
            return None
        kind, has = MOUNTED[interface]
        for model in self._parts(driver.model):
            robot = self._scene.models[model.root].spoken_name
            if has(model) and model.index not in given and robot in self._loop.drives:
                given.add(model.index)
                return kind(self._fitting(driver, address, robot), model)
        what = f"{interface}:{address.index}"
        known = [
            each.name for each in self._scene.models if each.wheels and each.parent is None and each.name
        ]
        if driver.model and known and not self._parts(driver.model):
            names = ", ".join(known[:_MOST_NAMES])
            raise ServerProblem("player-unknown-model", name=driver.model[:60], what=what, names=names)
        raise ServerProblem("player-no-model", what=what)

    def _fitting(self, driver: Driver, address: Address, robot: str) -> DeviceContext:
        interface = Interface[address.interface.upper()]
        return DeviceContext(interface, address.index, driver.name, robot, self._loop, self._reporter)

    def _robot_of(self, address: Address) -> str:
        """The robot of that port, for devices without a model of their own."""
        port = self._port(address)
        for offer in self._drivers:
            if offer.model and any(self._port(each) == port for each in offer.addresses):
                for top in self._parts(offer.model):
                    return self._scene.models[top.root].spoken_name
        return ""

    def _parts(self, name: str) -> list[Model]:
        """The model of that name and its parts, each before its own, as the scene has them."""
        parts: list[Model] = []
        for each in self._scene.models:
            if (not parts and each.name == name) or each.parent in [part.index for part in parts]:
                parts.append(each)
        return parts


# --- sockets

MOST_CLIENTS = 64
"""Clients of all ports together."""
SILENCE = 60.0
"""Seconds within which a client must send a whole message, or read waiting data."""
_HIGH_WATER = 256 * 1024
_SHORTEST = 1e-6
"""The least seconds between two ticks, so that commands arrive before the next one."""
_LATE = 1.0
"""Seconds behind real time after which lost time is not made up for."""


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
        """``speed``: a multiple of real time; None: as fast as possible. Raises ``ServerProblem``."""
        loop = asyncio.get_running_loop()
        servers: list[asyncio.Server] = []
        try:
            for station in self._stations.by_port.values():
                try:
                    servers.append(
                        await loop.create_server(
                            partial(ClientProtocol, self, station), self._host, station.port
                        )
                    )
                except OSError as problem:
                    raise ServerProblem(
                        "serve-failed", port=station.port, reason=reason_of(problem)
                    ) from None
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
            await asyncio.sleep(max(_SHORTEST, due - loop.time()))


class ClientProtocol(asyncio.Protocol):
    """One client's socket."""

    def __init__(self, server: PlayerServer, station: PortStation) -> None:
        self._server, self._station = server, station
        self._connection = ClientConnection(station, server.version)
        self._transport: asyncio.Transport
        self._may_write = True
        self._since = 0.0
        """The time of its connection, or when it stopped reading."""

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
        if self._connection.is_behind:
            self._transport.pause_reading()

    def pause_writing(self) -> None:
        self._may_write = False
        self._since = asyncio.get_running_loop().time()

    def resume_writing(self) -> None:
        self._may_write = True
        self.pass_on()

    def connection_lost(self, exc: Exception | None) -> None:  # noqa: ARG002 -- any end is the same
        self._server.clients.discard(self)
        self._station.clients.discard(self._connection)
        self._connection.close()

    def pass_on(self) -> None:
        """Write waiting data as far as the client takes them."""
        if self._may_write and not self._transport.is_closing():
            data = self._connection.take()
            if data:
                self._transport.write(data)
            if not self._transport.is_reading():
                self._transport.resume_reading()

    def check(self, now: float) -> None:
        """Close the connection if the client was silent, or read nothing, for too long."""
        if now - self._since > SILENCE and not (self._may_write and self._connection.has_spoken):
            self.end()

    def end(self) -> None:
        self.connection_lost(None)
        self._transport.abort()
