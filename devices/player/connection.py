"""One client's connection to a server: what it asks for, and which data it gets when.

A client that reads slowly gets the newest data: a new datum takes the place of the one of its kind that still
waits. Replies are never dropped, and each request gets exactly one.
"""

from __future__ import annotations

from itertools import count
from typing import Any, Protocol

from devices.player.codec import (
    CAN_YOU,
    LOCAL_HOST,
    Access,
    BadBody,
    DataMode,
    Interface,
    MessageReader,
    MessageType,
    PlayerMessage,
    banner,
    body_of,
    values_of,
)

MOST_WAITING = 1024
"""Data that wait for a client that wants all of them; from then on the newest of a kind replaces one."""
MOST_REPLIES = 256
"""Replies that wait; from then on nothing more is read from the client."""
MOST_RULES = 64

Key = tuple[int, int]
"""The interface and the index of a device."""

ACCEPT, REPLACE, IGNORE = 0, 1, 2


class Station(Protocol):
    """The devices of one port."""

    @property
    def port(self) -> int: ...

    @property
    def time(self) -> float:
        """Simulated seconds."""

    @property
    def drivers(self) -> dict[Key, str]:
        """The devices in the order of the configuration, each with the name of its driver."""

    def open(self, key: Key) -> bool:
        """One more subscriber. False if the device can't be opened."""

    def close(self, key: Key) -> None:
        """One less."""

    def command(self, key: Key, subtype: int, values: tuple[object, ...]) -> None: ...

    def request(self, key: Key, subtype: int, values: tuple[object, ...]) -> bytes | None:
        """The body of the reply; None for a refusal."""


class ClientConnection:
    """From the banner to ``close``."""

    def __init__(self, station: Station, version: str) -> None:
        self._station = station
        self._reader = MessageReader()
        self._first = banner(version)
        self._mode = DataMode.PUSH
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
        """What goes out now. To be called only while the client reads."""
        first, self._first = self._first, b""
        if not (self._must_go or self._is_round_open or self._mode is DataMode.PUSH):
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
            self._station.close(self._opened.pop())
        self._queue.clear()

    # --- what a client sends

    def _obey(self, message: PlayerMessage) -> None:
        key = (message.interface, message.index)
        is_server = message.interface == Interface.PLAYER
        if message.type == MessageType.COMMAND and key in self._station.drivers:
            values = _values(message)
            if values is not None:
                self._station.command(key, message.subtype, values)
        elif message.type == MessageType.REQUEST and is_server:
            self._answer(message)
        elif message.type == MessageType.REQUEST:
            values = _values(message)
            known = values is not None and message.subtype != CAN_YOU and key in self._station.drivers
            self._reply(message, self._station.request(key, message.subtype, values or ()) if known else None)
        elif is_server and message.type > MessageType.NACK:
            self._reply(message, None)

    def _answer(self, message: PlayerMessage) -> None:
        """A request to the server itself."""
        values = _values(message)
        if values is None:
            self._reply(message, None)
            return
        match message.subtype, values:
            case 1, _:
                addresses = [self._address(key) for key in self._station.drivers]
                self._reply(message, body_of(Interface.PLAYER, MessageType.ACK, 1, addresses))
            case 2, (_, _, interface, index, _):
                name = self._station.drivers.get((interface, index))
                address = self._address((interface, index))
                body = body_of(Interface.PLAYER, MessageType.ACK, 2, *address, name or "")
                self._reply(message, None if name is None else body)
            case 3, (_, _, interface, index, access, _):
                self._subscribe(message, (interface, index), access)
            case 4, _:
                self._begin_round(message)
            case 5, (mode,):
                self._mode = DataMode.PULL if mode == DataMode.PULL else DataMode.PUSH
                self._reply(message, b"")
            case 10, (*pattern, rule):
                self._set_rule(tuple(pattern), rule)
                self._reply(message, b"")
            case _:
                self._reply(message, None)

    def _subscribe(self, message: PlayerMessage, key: Key, access: int) -> None:
        name = self._station.drivers.get(key)
        is_refused = name is None
        granted = access if access in (Access.OPEN, Access.CLOSE) else int(Access.ERROR)
        if name is not None and access == Access.OPEN:
            is_refused = len(self._opened) >= MOST_WAITING or not self._station.open(key)
            if not is_refused:
                self._opened.append(key)
        elif access == Access.CLOSE and key in self._opened:
            self._opened.remove(key)
            self._station.close(key)
        if is_refused:
            body = body_of(Interface.PLAYER, MessageType.NACK, 3, *self._address(key), int(Access.ERROR), "")
            self._queue_reply(message, MessageType.NACK, body)
        else:
            granted_to = (*self._address(key), granted, name or "")
            self._reply(message, body_of(Interface.PLAYER, MessageType.ACK, 3, *granted_to))

    def _begin_round(self, message: PlayerMessage) -> None:
        """Its reply precedes all that waits."""
        waiting = dict(self._queue)
        self._queue.clear()
        self._reply(message, b"")
        self._queue.update(waiting)
        self._is_round_open = self._mode is DataMode.PULL

    def _set_rule(self, pattern: tuple[int, ...], rule: int) -> None:
        if rule in (ACCEPT, REPLACE, IGNORE) and (pattern in self._rules or len(self._rules) < MOST_RULES):
            self._rules[pattern] = rule

    def _rule(self, kind: tuple[int, ...]) -> int:
        for pattern, rule in self._rules.items():
            if all(wanted in (-1, each) for wanted, each in zip(pattern, kind, strict=True)):
                return rule
        return REPLACE

    # --- what it gets

    def _reply(self, message: PlayerMessage, body: bytes | None) -> None:
        """``None``: refused."""
        self._queue_reply(message, MessageType.NACK if body is None else MessageType.ACK, body or b"")

    def _queue_reply(self, message: PlayerMessage, type_: MessageType, body: bytes) -> None:
        reply = self._message(message.interface, message.index, type_, message.subtype, body)
        self._queue[next(self._numbers)] = reply
        self._replies += 1
        self._must_go = True

    def _message(self, interface: int, index: int, type_: int, subtype: int, body: bytes) -> PlayerMessage:
        here = (self._station.time, LOCAL_HOST, self._station.port)
        return PlayerMessage(interface, index, type_, subtype, body, *here)

    def _address(self, key: Key) -> tuple[int, int, int, int]:
        return (LOCAL_HOST, self._station.port, *key)


def _values(message: PlayerMessage) -> tuple[Any, ...] | None:
    """None if nothing is known of such a message, or its body is not what it should be."""
    try:
        return values_of(message)
    except BadBody:
        return None
