"""One client's connection to a server: what it asks for, and which data it gets when.

A client that reads slowly gets the newest data: a new datum takes the place of the one of its kind that still
waits. Replies are never dropped, and each request gets exactly one.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import count
from typing import Protocol

from devices.player.codec import (
    CAN_YOU,
    LOCAL_HOST,
    PULL,
    Access,
    Interface,
    Key,
    MessageReader,
    MessageType,
    PlayerMessage,
    Values,
    banner,
    body_of,
    values_of,
)

MOST_WAITING = 1024
"""Data that wait for a client that wants all of them; from then on the newest of a kind replaces one."""
MOST_REPLIES = 256
"""Replies that wait; from then on nothing more is read from the client."""
MOST_RULES = 64

ACCEPT, REPLACE, IGNORE = 0, 1, 2


class ServedDevice(Protocol):
    """A device that clients open, by an interface and an index."""

    driver: str
    users: int

    def open(self) -> bool:
        """One more user. False if it can't be opened."""

    def close(self) -> None:
        """One less."""

    def command(self, subtype: int, values: Values) -> None:
        """Take a command. Called only while it has users."""

    def request(self, subtype: int, values: Values) -> Values | None:
        """The content of the reply; None for a refusal."""


class Station(Protocol):
    """The devices of one port."""

    @property
    def port(self) -> int: ...

    @property
    def time(self) -> float:
        """Simulated seconds."""

    @property
    def devices(self) -> Mapping[Key, ServedDevice]:
        """The devices in the order of the configuration."""


class ClientConnection:
    """The protocol with one client, from the banner to ``close``."""

    def __init__(self, station: Station, version: str) -> None:
        self._station = station
        self._reader = MessageReader()
        self._first = banner(version)
        self._is_pull = False
        """Whether data wait until the client asks for a round."""
        self._queue: dict[object, PlayerMessage] = {}
        self._numbers = count()
        self._replies = 0
        """Of the queue."""
        self._must_go = False
        """Whether all that waits goes out now, with a reply."""
        self._is_round_open = False
        self._rules: dict[tuple[int, ...], int] = {}
        self._opened: list[Key] = []
        self.has_spoken = False
        """Whether a whole message has come."""

    @property
    def is_behind(self) -> bool:
        """Whether so many replies wait that nothing more should be read."""
        return self._replies >= MOST_REPLIES

    def receive(self, data: bytes) -> None:
        """Raises ``TooLong``: then this connection is at its end."""
        for message in self._reader.feed(data):
            self.has_spoken = True
            self._obey(message)

    def publish(self, key: Key, subtype: int, body: bytes) -> None:
        """A datum of a device, for a client that has opened it."""
        if key not in self._opened:
            return
        kind = (*key, int(MessageType.DATA), subtype)
        rule = self._rule(kind)
        if rule == IGNORE:
            return
        place: object = kind
        if rule == ACCEPT and len(self._queue) < MOST_WAITING:
            place = next(self._numbers)
        self._queue.pop(place, None)  # the newest is the last
        self._queue[place] = self._message(*key, MessageType.DATA, subtype, body)

    def take(self) -> bytes:
        """The bytes to send now. Call it only while the client reads."""
        first, self._first = self._first, b""
        if not (self._must_go or self._is_round_open or not self._is_pull):
            return first
        queued = list(self._queue.values())
        self._queue.clear()
        self._replies, self._must_go = 0, False
        if self._is_round_open and any(each.type == MessageType.DATA for each in queued):
            self._is_round_open = False
            queued.append(PlayerMessage(Interface.PLAYER, 0, MessageType.SYNCH, 1))
        return first + b"".join(each.encoded() for each in queued)

    def close(self) -> None:
        """The client has gone, or is sent away."""
        while self._opened:
            self._station.devices[self._opened.pop()].close()
        self._queue.clear()

    # --- what a client sends

    def _obey(self, message: PlayerMessage) -> None:
        is_server, is_request = message.interface == Interface.PLAYER, message.type == MessageType.REQUEST
        device = self._station.devices.get((message.interface, message.index))
        values = values_of(message)
        if is_server and is_request:
            self._answer(message, values)
        elif is_request:
            if device is None or values is None or message.subtype == CAN_YOU:
                self._reply(message, None)
            else:
                self._reply(message, device.request(message.subtype, values))
        elif is_server and message.type > MessageType.NACK:
            self._reply(message, None)
        elif message.type == MessageType.COMMAND and device and device.users and values is not None:
            device.command(message.subtype, values)

    def _answer(self, message: PlayerMessage, values: Values | None) -> None:
        """A request to the server itself."""
        devices = self._station.devices
        reply: Values | None = None
        match message.subtype, values:
            case _, None:
                pass
            case 1, _:
                reply = ([self._address(key) for key in devices],)
            case 2, (_, _, interface, index, _) if device := devices.get((interface, index)):
                reply = (*self._address((interface, index)), device.driver)
            case 3, (_, _, interface, index, access, _):
                return self._subscribe(message, (interface, index), access)
            case 4, _:
                return self._begin_round(message)
            case 5, (mode,):
                self._is_pull, reply = mode == PULL, ()
            case 10, (*pattern, rule):
                self._set_rule(tuple(pattern), rule)
                reply = ()
        return self._reply(message, reply)

    def _subscribe(self, message: PlayerMessage, key: Key, access: int) -> None:
        device = self._station.devices.get(key)
        if device is not None and access == Access.OPEN:
            if len(self._opened) < MOST_WAITING and device.open():
                self._opened.append(key)
            else:
                device = None
        elif device is not None and access == Access.CLOSE and key in self._opened:
            self._opened.remove(key)
            device.close()
        is_right = device is not None and access in (Access.OPEN, Access.CLOSE)
        values = (*self._address(key), access if is_right else Access.ERROR, device.driver if device else "")
        self._queue_reply(message, MessageType.ACK if device else MessageType.NACK, *values)

    def _begin_round(self, message: PlayerMessage) -> None:
        """Its reply precedes all that waits."""
        waiting = dict(self._queue)
        self._queue.clear()
        self._reply(message, ())
        self._queue.update(waiting)
        self._is_round_open = self._is_pull

    def _set_rule(self, pattern: tuple[int, ...], rule: int) -> None:
        if rule in (ACCEPT, REPLACE, IGNORE) and (pattern in self._rules or len(self._rules) < MOST_RULES):
            self._rules[pattern] = rule

    def _rule(self, kind: tuple[int, ...]) -> int:
        for pattern, rule in self._rules.items():
            if all(wanted in (-1, each) for wanted, each in zip(pattern, kind, strict=True)):
                return rule
        return REPLACE

    # --- what it gets

    def _reply(self, message: PlayerMessage, values: Values | None) -> None:
        """``None``: refused."""
        self._queue_reply(message, MessageType.NACK if values is None else MessageType.ACK, *(values or ()))

    def _queue_reply(self, message: PlayerMessage, type_: MessageType, *values: object) -> None:
        body = body_of(message.interface, type_, message.subtype, *values) if values else b""
        reply = self._message(message.interface, message.index, type_, message.subtype, body)
        self._queue[next(self._numbers)] = reply
        self._replies += 1
        self._must_go = True

    def _message(self, interface: int, index: int, type_: int, subtype: int, body: bytes) -> PlayerMessage:
        here = (self._station.time, LOCAL_HOST, self._station.port)
        return PlayerMessage(interface, index, type_, subtype, body, *here)

    def _address(self, key: Key) -> tuple[int, int, int, int]:
        return (LOCAL_HOST, self._station.port, *key)
