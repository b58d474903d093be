"""From a configuration file to the devices of each port, and their ticks.

The addresses of a driver are taken in the order written; each gets the first model of its type that is not
given away yet, the robot itself before its parts.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from devices.player.connection import ClientConnection, Key
from devices.player.interfaces import Interface
from donnie_tui.player.equipment import (
    Battery,
    BeltFrames,
    BumperBars,
    ColourFinder,
    DigitalOutputs,
    Equipment,
    HeadDevice,
    MarkReader,
    MountedDevice,
    Paddles,
    RangeFinder,
    Reporter,
    SoundDevice,
    SpeechDevice,
    Values,
    WheelDevice,
    Whole,
)

if TYPE_CHECKING:
    from sim.scene import Model
    from sim.velocity import VelocityLoop
    from sim.worldfile import Address, Driver

MOUNTED: Mapping[str, tuple[type[MountedDevice], Callable[[Model], object]]] = {
    "position2d": (WheelDevice, lambda each: each.wheels),
    "ranger": (RangeFinder, lambda each: each.sensors),
    "bumper": (BumperBars, lambda each: each.bumpers),
    "blobfinder": (ColourFinder, lambda each: each.blobfinder),
    "fiducial": (MarkReader, lambda each: each.fiducial_finder),
    "gripper": (Paddles, lambda each: each.gripper),
}
STAGE, BELT = "stage", "vib_belt"
SERVICES = frozenset({STAGE, "soxplayer", "gtts", BELT})
"""Drivers by name; what others provide is left out."""


class BadConfiguration(Exception):
    """The code of a sentence, and what it is about."""

    def __init__(self, code: str, what: str) -> None:
        super().__init__(code)
        self.code, self.what = code, what


class PortStation:
    """The devices of one port. See ``devices.player.connection.Station``."""

    def __init__(self, port: int, loop: VelocityLoop) -> None:
        self.port = port
        self.devices: dict[Key, Equipment] = {}
        self.drivers: dict[Key, str] = {}
        self.clients: set[ClientConnection] = set()
        self._loop = loop

    @property
    def time(self) -> float:
        return self._loop.time

    def add(self, device: Equipment) -> None:
        """Raises ``BadConfiguration`` for a second device of one address."""
        key = (device.interface, device.index)
        if key in self.devices:
            raise BadConfiguration("player-address-twice", f"{self.port}:{_name(*key)}")
        self.devices[key] = device
        self.drivers[key] = device.driver

    def open(self, key: Key) -> bool:
        return self.devices[key].open()

    def close(self, key: Key) -> None:
        self.devices[key].close()

    def command(self, key: Key, subtype: int, values: Values) -> None:
        device = self.devices[key]
        if device.users:
            device.command(subtype, values)

    def request(self, key: Key, subtype: int, values: Values) -> bytes | None:
        return self.devices[key].request(subtype, values)

    def publish(self) -> None:
        """The data of what is open, to all clients."""
        for key, device in self.devices.items():
            if device.users:
                for subtype, body in device.data():
                    for client in self.clients:
                        client.publish(key, subtype, body)


class Stations:
    """All ports of a configuration, and the world that they share."""

    def __init__(self, drivers: Sequence[Driver], loop: VelocityLoop, port: int, reporter: Reporter) -> None:
        """``port``: of what names no other. Raises ``BadConfiguration``."""
        self.by_port: dict[int, PortStation] = {}
        self._drivers = drivers
        self.left_out: list[str] = []
        """Addresses of what isn't offered here."""
        self._scene, self._loop, self._reporter, self._default = loop.scene, loop, reporter, port
        given: set[int] = set()
        for driver in drivers:
            for address in driver.addresses:
                device = self._device(driver, address, given)
                if device is None:
                    self.left_out.append(f"{address.interface}:{address.index}")
                else:
                    self._station(address).add(device)

    def step(self) -> None:
        """One tick: what the devices want, the world, then the data."""
        self._reporter.on_tick()
        for device in self._all():
            device.step()
        self._loop.advance()
        for station in self.by_port.values():
            station.publish()

    def _all(self) -> Iterable[Equipment]:
        return (device for station in self.by_port.values() for device in station.devices.values())

    def _station(self, address: Address) -> PortStation:
        port = self._port(address)
        return self.by_port.setdefault(port, PortStation(port, self._loop))

    def _port(self, address: Address) -> int:
        return address.port if address.has_port else self._default

    def _device(self, driver: Driver, address: Address, given: set[int]) -> Equipment | None:
        index, interface = address.index, address.interface
        if driver.name not in SERVICES or index > 0xFFFF:
            return None
        if interface == "dio":
            return DigitalOutputs(index, driver.name, self._robot_of(address), self._reporter)
        if interface == "power":
            return Battery(index, driver.name)
        if interface == "sound":
            return SoundDevice(index, driver.name, self._robot_of(address), self._reporter)
        if interface == "speech":
            kind_of_speech = BeltFrames if driver.name == BELT else SpeechDevice
            return kind_of_speech(index, driver.name, self._robot_of(address), self._reporter)
        if driver.name != STAGE:
            return None
        if interface == "simulation":
            return Whole(index, driver.name, self._loop)
        if interface not in MOUNTED:
            return None
        kind, has = MOUNTED[interface]
        for model in self._tree(driver.model):
            if has(model) and model.index not in given:
                given.add(model.index)
                root = self._scene.models[model.root]
                drive = self._loop.drives.get(root.spoken_name)
                if drive is None:
                    break
                if kind is WheelDevice and model.parent is not None:
                    kind = HeadDevice
                mounted = kind(index, driver.name, model, drive, self._loop)
                mounted.reporter = self._reporter
                return mounted
        raise BadConfiguration("player-no-model", f"{interface}:{index}")

    def _robot_of(self, address: Address) -> str:
        """The robot of that port, for what no model of its own provides."""
        port = self._port(address)
        for offer in self._drivers:
            if offer.model and any(self._port(each) == port for each in offer.addresses):
                top = next((each for each in self._scene.models if each.name == offer.model), None)
                if top is not None:
                    return self._scene.models[top.root].spoken_name
        return ""

    def _tree(self, name: str) -> Iterator[Model]:
        """The model of that name and its parts, each before its own."""
        top = next((each for each in self._scene.models if each.name == name), None)
        return iter(()) if top is None else self._below(top)

    def _below(self, model: Model) -> Iterator[Model]:
        yield model
        for child in self._scene.tree(model.root):
            if child.parent == model.index:
                yield from self._below(child)


def _name(interface: int, index: int) -> str:
    return f"{Interface(interface).name.lower()}:{index}"
