"""The server on real sockets: clients that come, read slowly, send rubbish and vanish."""

import asyncio
import gc
import random
import socket
import sys
import tracemalloc
from collections.abc import AsyncIterator, Callable, Coroutine
from contextlib import asynccontextmanager, suppress
from itertools import pairwise
from pathlib import Path

import pytest

from devices.player.codec import MessageReader, MessageType, PlayerMessage, body_of
from donnie_tui.i18n.words import Words
from donnie_tui.player import server as module
from donnie_tui.player.server import PlayerServer, ServerProblem, Stations
from tests.free_ports import free_port
from tests.player.room import CONFIGURATION, HOST, Notes, stations_of, write_room
from tests.timeouts import TIMEOUT


class Room:
    """A server with its stations and what it complained of."""

    def __init__(self, folder: Path) -> None:
        self.port, self.bobs = free_port(), free_port()
        text = CONFIGURATION.replace("7665", str(self.port)).replace("7666", str(self.bobs))
        self.notes = Notes()
        self.stations: Stations = stations_of(write_room(folder, text), self.notes)
        self.complaints: list[str] = []
        self.server = PlayerServer(self.stations, HOST, "1", self.complaints.append)

    @asynccontextmanager
    async def running(self, speed: float | None = 20.0) -> AsyncIterator[None]:
        started = asyncio.Event()
        task = asyncio.create_task(self.server.run(lambda: speed, started.set))
        await started.wait()
        try:
            yield
        finally:
            task.cancel()
            with suppress(asyncio.CancelledError):
                await task

    def speed(self) -> float:
        return self.stations._loop.drives["alice"].state().velocity.ahead


class Client:
    def __init__(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self._reader, self.writer = reader, writer
        self._messages = MessageReader(10**6)
        self._got: list[PlayerMessage] = []

    @classmethod
    async def connected(cls, port: int) -> "Client":
        client = cls(*await asyncio.open_connection(HOST, port))
        assert (await client._reader.readexactly(32)).startswith(b"Player v.")
        return client

    async def next(self) -> PlayerMessage:
        while not self._got:
            data = await asyncio.wait_for(self._reader.read(65536), TIMEOUT)
            if not data:
                raise EOFError
            self._got.extend(self._messages.feed(data))
        return self._got.pop(0)

    async def ask(self, subtype: int, *values: object) -> PlayerMessage:
        self.send(1, 0, 3, subtype, *values)
        while (message := await self.next()).type not in (MessageType.ACK, MessageType.NACK):
            pass
        return message

    def send(self, interface: int, index: int, type_: int, subtype: int, *values: object) -> None:
        body = body_of(interface, type_, subtype, *values)
        self.writer.write(PlayerMessage(interface, index, type_, subtype, body).encoded())

    async def drive(self, ahead: float) -> None:
        assert (await self.ask(3, 0, 0, 4, 0, 1, "")).type == MessageType.ACK
        self.send(4, 0, 2, 1, ahead, 0.0, 0.0, 1)

    async def is_at_its_end(self) -> bool:
        with suppress(EOFError, ConnectionError):
            while True:
                await self.next()
        return True


Play = Callable[[Room], Coroutine[None, None, None]]


def play(folder: Path, story: Play, speed: float | None = 20.0, seconds: float = 120) -> Room:
    room = Room(folder)

    async def run() -> None:
        async with room.running(speed):
            await asyncio.wait_for(story(room), seconds)

    asyncio.run(run())
    return room


async def until(condition: Callable[[], bool]) -> None:
    for _ in range(100 * TIMEOUT):
        if condition():
            return
        await asyncio.sleep(0.01)
    raise AssertionError("it never came to that")


def test_a_client_drives_and_its_death_stops_the_robot(tmp_path: Path) -> None:
    async def story(room: Room) -> None:
        client = await Client.connected(room.port)
        await client.drive(0.05)
        await until(lambda: room.speed() == pytest.approx(0.05))
        client.writer.transport.abort()
        await until(lambda: room.speed() == 0.0)

    play(tmp_path, story)


def test_in_push_data_come_by_themselves(tmp_path: Path) -> None:
    async def story(room: Room) -> None:
        client = await Client.connected(room.port)
        await client.drive(0.0)
        times = [(await client.next()).time for _ in range(3)]
        assert times[2] - times[0] == pytest.approx(0.2)

    play(tmp_path, story)


def test_rubbish_ends_its_connection_and_no_other(tmp_path: Path) -> None:
    async def story(room: Room) -> None:
        good = await Client.connected(room.port)
        for _ in range(3):
            bad = await Client.connected(room.port)
            bad.writer.write(b"\xff" * 500)
            assert await bad.is_at_its_end()
        half = await Client.connected(room.port)
        half.writer.write(b"GET / HTTP/1.1\r\n")
        assert (await good.ask(1)).type == MessageType.ACK

    assert play(tmp_path, story).complaints == ["player-rubbish"]


def test_a_client_that_never_reads_delays_no_other(tmp_path: Path) -> None:
    async def story(room: Room) -> None:
        slow = await Client.connected(room.port)
        slow.writer.transport.pause_reading()  # type: ignore[attr-defined] # a socket's
        for index in (0, 1):
            slow.send(1, 0, 3, 3, 0, 0, 62, index, 1, "")
        for _ in range(20_000):
            slow.send(1, 0, 3, 1)
        quick = await Client.connected(room.port)
        for _ in range(20):
            assert (await quick.ask(1)).type == MessageType.ACK

    play(tmp_path, story)


def test_no_more_clients_than_are_allowed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MOST_CLIENTS", 2)

    async def story(room: Room) -> None:
        clients = [await Client.connected(room.port) for _ in range(2)]
        reader, _ = await asyncio.open_connection(HOST, room.port)
        with suppress(ConnectionError):
            assert await reader.read(100) == b""
        clients[0].writer.transport.abort()
        await until(lambda: len(room.server.clients) == 1)
        assert (await (await Client.connected(room.bobs)).ask(1)).type == MessageType.ACK

    assert play(tmp_path, story).complaints == ["player-full"]


def test_a_client_that_says_nothing_is_sent_away(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    async def story(room: Room) -> None:
        silent, speaking = await Client.connected(room.port), await Client.connected(room.port)
        await speaking.ask(5, 2)
        monkeypatch.setattr(module, "SILENCE", 0.3)
        assert await silent.is_at_its_end()
        assert (await speaking.ask(1)).type == MessageType.ACK

    play(tmp_path, story)


def test_a_client_that_reads_nothing_is_sent_away(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    async def story(room: Room) -> None:
        slow = await Client.connected(room.port)
        await slow.ask(3, 0, 0, 62, 1, 1, "")
        slow.writer.transport.pause_reading()  # type: ignore[attr-defined] # a socket's
        [served] = room.server.clients
        await until(lambda: not served._may_write)
        monkeypatch.setattr(module, "SILENCE", 0.2)
        await until(lambda: not room.server.clients)

    play(tmp_path, story, speed=None)


def test_five_hundred_clients_that_come_and_go_leave_nothing(tmp_path: Path) -> None:
    async def story(room: Room) -> None:
        for _ in range(500):
            (await Client.connected(room.port)).writer.transport.abort()
        await until(lambda: not room.server.clients)
        assert not room.stations.by_port[room.port].clients

    play(tmp_path, story)


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        ("en", "Port {} can't be used: another program uses it."),
        ("pt", "A porta {} não pode ser usada: está em uso."),
        ("es", "El puerto {} no se puede usar: está en uso."),
    ],
)
def test_a_port_that_is_taken_is_named(tmp_path: Path, language: str, sentence: str) -> None:
    room = Room(tmp_path)
    with socket.create_server((HOST, room.bobs)), pytest.raises(ServerProblem) as problem:
        asyncio.run(room.server.run(lambda: 1.0, lambda: None))

    found = Words(language)(problem.value.code, **problem.value.values)
    assert found == sentence.format(room.bobs)


def test_the_banner_comes_alone_and_small_messages_do_not_wait(tmp_path: Path) -> None:
    async def story(room: Room) -> None:
        loop = asyncio.get_running_loop()
        with socket.create_connection((HOST, room.port)) as client:
            client.setblocking(False)
            assert len(await loop.sock_recv(client, 1000)) == 32
            [served] = room.server.clients
            assert served._transport is not None
            theirs = served._transport.get_extra_info("socket")
            assert theirs.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY)

    play(tmp_path, story)


def test_a_client_that_reads_again_gets_the_newest_data(tmp_path: Path) -> None:
    """Memory stays bounded meanwhile: the socket takes no more, and of each kind one datum waits."""

    async def story(room: Room) -> None:
        slow = await Client.connected(room.port)
        await slow.ask(10, -1, -1, -1, -1, 1)
        await slow.ask(3, 0, 0, 62, 1, 1, "")
        slow.writer.transport.pause_reading()  # type: ignore[attr-defined] # a socket's
        [served] = room.server.clients
        await until(lambda: not served._may_write)
        assert len(served._connection._queue) <= 2
        stopped_at = room.stations._loop.time
        await until(lambda: room.stations._loop.time > stopped_at + 5.0)
        assert len(served._connection._queue) <= 2
        now = room.stations._loop.time
        slow.writer.transport.resume_reading()  # type: ignore[attr-defined]
        times = [(await slow.next()).time]
        while times[-1] < now:
            times.append((await slow.next()).time)
        gaps = [after - before for before, after in pairwise(times)]
        assert max(gaps) > 4.0

    play(tmp_path, story, speed=None)


@pytest.mark.slow
def test_a_client_that_is_killed_leaves_a_robot_that_stands_and_no_other(tmp_path: Path) -> None:
    """Two processes have one robot: only the end of the last one stops it, and never the other robot."""
    program = (
        "import socket, sys\n"
        "from devices.player.codec import PlayerMessage\n"
        "from devices.player.codec import body_of\n"
        "s = socket.create_connection(('127.0.0.1', int(sys.argv[1])))\n"
        "s.sendall(PlayerMessage(1, 0, 3, 3, body_of(1, 3, 3, 0, 0, 4, 0, 1, '')).encoded())\n"
        "s.sendall(PlayerMessage(4, 0, 2, 1, body_of(4, 2, 1, 0.01, 0.0, 0.0, 1)).encoded())\n"
        "print('there', flush=True)\n"
        "while s.recv(4096): pass\n"
    )

    async def begun(port: int) -> asyncio.subprocess.Process:
        process = await asyncio.create_subprocess_exec(
            sys.executable, "-c", program, str(port), stdout=asyncio.subprocess.PIPE
        )
        assert process.stdout is not None
        assert await process.stdout.readline() == b"there\n"
        return process

    async def story(room: Room) -> None:
        def bobs_speed() -> float:
            return room.stations._loop.drives["bob"].state().velocity.ahead

        one, two, bob = await begun(room.port), await begun(room.port), await begun(room.bobs)
        await until(lambda: len(room.server.clients) == 3 and room.speed() > 0 and bobs_speed() > 0)
        one.kill()
        await until(lambda: len(room.server.clients) == 2)
        later = room.stations._loop.time + 1.0
        await until(lambda: room.stations._loop.time > later)
        assert room.speed() == pytest.approx(0.01)
        two.kill()
        await until(lambda: room.speed() == 0.0)
        assert bobs_speed() == pytest.approx(0.01)
        bob.kill()
        for each in (one, two, bob):
            await each.wait()

    play(tmp_path, story)


@pytest.mark.slow
def test_ten_thousand_connections_leave_no_memory_behind(tmp_path: Path) -> None:
    """A third of them say nothing, a third send rubbish, a third open a robot and vanish."""
    opening = PlayerMessage(1, 0, 3, 3, body_of(1, 3, 3, 0, 0, 4, 0, 1, "")).encoded()
    said = (b"", random.Random(1).randbytes(300), opening)

    def memory() -> int:
        gc.collect()
        return tracemalloc.get_traced_memory()[0]

    async def story(room: Room) -> None:
        used: list[int] = []
        for number in range(10_000):
            reader, writer = await asyncio.open_connection(HOST, room.port)
            await reader.readexactly(32)
            writer.write(said[number % 3])
            writer.transport.abort()
            if number % 2500 == 2499:
                await until(lambda: not room.server.clients)
                room.notes.taken.clear()
                used.append(memory())
        assert used[-1] - used[0] < 30_000, used
        assert not room.stations.by_port[room.port].clients

    tracemalloc.start()
    try:
        complaints = play(tmp_path, story, seconds=400).complaints
    finally:
        tracemalloc.stop()
    assert set(complaints) <= {"player-rubbish"}
    assert len(complaints) <= 1


def test_the_simulation_is_no_faster_than_it_should_be(tmp_path: Path) -> None:
    """A busy machine makes it slower, and what was lost of more than a second is not made up for."""

    async def story(room: Room) -> None:
        began, time = asyncio.get_running_loop().time(), room.stations._loop.time
        await until(lambda: room.stations._loop.time > time + 4.0)
        simulated = room.stations._loop.time - time
        assert simulated <= 20.0 * (asyncio.get_running_loop().time() - began + module._LATE) + 0.2

    play(tmp_path, story)


# --- one client, without a socket


class Transport:
    """Of a client whose socket takes everything at once."""

    def __init__(self) -> None:
        self.did: list[str] = []
        self.written = b""
        self.limit = 0
        self.is_over = self.is_paused = False

    def write(self, data: bytes) -> None:
        assert data
        self.written += data

    def abort(self) -> None:
        self.did.append("aborted")
        self.is_over = True

    def is_closing(self) -> bool:
        return self.is_over

    def is_reading(self) -> bool:
        return not self.is_paused

    def pause_reading(self) -> None:
        self.is_paused = True

    def resume_reading(self) -> None:
        self.did.append("reads again")
        self.is_paused = False

    def set_write_buffer_limits(self, high: int) -> None:
        self.limit = high


class Clients:
    """Clients of a room, and the time."""

    def __init__(self, folder: Path, patch: pytest.MonkeyPatch) -> None:
        self.room, self.now = Room(folder), 100.0
        self.sleeps: list[float] = []
        patch.setattr(module.asyncio, "get_running_loop", lambda: self)

    def time(self) -> float:
        return self.now

    def connect(self) -> tuple[module.ClientProtocol, Transport]:
        made = module.ClientProtocol(self.room.server, self.room.stations.by_port[self.room.port])
        transport = Transport()
        made.connection_made(transport)  # type: ignore[arg-type]
        return made, transport


ASKED = PlayerMessage(1, 0, MessageType.REQUEST, 1, b"").encoded()


@pytest.fixture
def clients(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Clients:
    return Clients(tmp_path, monkeypatch)


def test_a_client_gets_the_banner_and_is_known_until_it_leaves(clients: Clients) -> None:
    client, transport = clients.connect()
    station = clients.room.stations.by_port[clients.room.port]
    assert transport.written.startswith(b"Player v.1")
    assert (len(transport.written), transport.limit) == (32, 256 * 1024)
    assert (clients.room.server.clients, len(station.clients)) == ({client}, 1)
    client.connection_lost(None)

    assert (clients.room.server.clients, station.clients) == (set(), set())
    client.data_received(ASKED)
    assert len(transport.written) == 32


def test_the_sixty_fifth_client_is_sent_away(clients: Clients) -> None:
    for _ in range(64):
        assert clients.connect()[1].did == []
    refused, transport = clients.connect()
    assert (transport.did, transport.written) == (["aborted"], b"")
    assert refused not in clients.room.server.clients
    refused.data_received(ASKED)
    clients.connect()

    assert clients.room.complaints == ["player-full"]


@pytest.mark.parametrize("has_spoken", [False, True])
@pytest.mark.parametrize("stops_reading", [False, True])
def test_a_client_has_a_minute_to_say_something_and_to_read_what_waits(
    clients: Clients, has_spoken: bool, stops_reading: bool
) -> None:
    client, transport = clients.connect()
    if has_spoken:
        client.data_received(ASKED)
    if stops_reading:
        clients.now = 130.0
        client.pause_writing()
    ends = 190.0 if stops_reading else 160.0
    client.check(ends)
    assert transport.did == []
    client.check(ends + 0.1)

    is_sent_away = stops_reading or not has_spoken
    assert transport.did == (["aborted"] if is_sent_away else [])
    assert (client in clients.room.server.clients) is not is_sent_away


def test_a_client_that_does_not_read_is_read_no_further_until_it_does(clients: Clients) -> None:
    client, transport = clients.connect()
    client.pause_writing()
    client.data_received(ASKED * 255)
    assert not transport.is_paused
    client.data_received(ASKED)
    assert transport.is_paused
    assert len(transport.written) == 32
    client.resume_writing()

    assert (transport.is_paused, transport.did) == (False, ["reads again"])
    replies = list(MessageReader(10**6).feed(transport.written[32:]))
    assert [each.type for each in replies] == [MessageType.ACK] * 256
    client.pass_on()
    assert transport.did == ["reads again"]


def test_nothing_is_written_to_a_client_that_is_leaving(clients: Clients) -> None:
    client, transport = clients.connect()
    transport.is_over = True
    client.data_received(ASKED)
    assert len(transport.written) == 32

    other, transport = clients.connect()
    other.data_received(b"\xff" * 500)
    assert (transport.did, clients.room.complaints) == (["aborted"], ["player-rubbish"])


@pytest.mark.parametrize(
    ("speed", "took", "sleeps"),
    [
        (1.0, [0.0, 0.0, 0.0], [0.1, 0.2, 0.3]),
        (2.0, [0.04, 0.0, 0.0], [0.01, 0.06, 0.11]),
        (1.0, [0.3, 0.0, 0.0], [1e-6, 1e-6, 1e-6]),
        (1.0, [1.5, 0.0, 0.0, 0.0, 0.6], [*[1e-6] * 4, 1e-6]),
        (None, [0.0, 0.0], [1e-6, 1e-6]),
        (0.1, [0.0], [1.0]),
    ],
)
def test_a_tick_comes_when_it_is_due_and_at_most_a_second_is_made_up_for(
    clients: Clients,
    monkeypatch: pytest.MonkeyPatch,
    speed: float | None,
    took: list[float],
    sleeps: list[float],
) -> None:
    """The clock of the test stands while the server sleeps."""
    slept: list[float] = []

    async def sleep(seconds: float) -> None:
        slept.append(seconds)
        if len(slept) == len(took):
            raise asyncio.CancelledError

    def step() -> None:
        clients.now += took[len(slept)]

    client, transport = clients.connect()
    monkeypatch.setattr(module.asyncio, "sleep", sleep)
    monkeypatch.setattr(clients.room.stations, "step", step)
    client._connection._first = b"waits"
    with pytest.raises(asyncio.CancelledError):
        clients.room.server._tick(lambda: speed).send(None)

    assert slept == pytest.approx(sleeps)
    assert transport.written.endswith(b"waits")


def test_a_second_that_was_lost_is_made_up_for_and_no_more(
    clients: Clients, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A tick of a real time of five seconds; then each takes no time."""
    slept: list[float] = []

    async def sleep(seconds: float) -> None:
        slept.append(seconds)
        if len(slept) == 13:
            raise asyncio.CancelledError

    def step() -> None:
        clients.now += 0.0 if slept else 5.0

    monkeypatch.setattr(module.asyncio, "sleep", sleep)
    monkeypatch.setattr(clients.room.stations, "step", step)
    with pytest.raises(asyncio.CancelledError):
        clients.room.server._tick(lambda: 1.0).send(None)

    assert slept[:10] == [1e-6] * 10
    assert slept[11:] == pytest.approx([0.1, 0.2])
