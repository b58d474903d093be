"""The pages of ``donnie serve``: who gets one, what they may use, and what happens when one is gone."""

from __future__ import annotations

import asyncio
import json
import shlex
import signal
import socket
import struct
import sys
import time
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from pathlib import Path
from typing import Any

import pytest

from donnie_tui.cli import front_end
from donnie_tui.cli.main import main
from donnie_tui.i18n.words import Words
from language.call_stack import raise_recursion_limit
from tests.conftest import ROOT
from tests.free_ports import free_port
from tests.timeouts import TIMEOUT

aiohttp = pytest.importorskip("aiohttp")
pytest.importorskip("textual_serve")

from aiohttp import ClientSession, ClientWebSocketResponse, WSMsgType, WSServerHandshakeError  # noqa: E402

from donnie_tui.cli.page_server import Gate, PageServer, _logger  # noqa: E402
from donnie_tui.cli.page_session import (  # noqa: E402
    IDLE_CODE,
    PageLimits,
    _kill_group,
    as_reason,
    size_of,
)

NEVER = 10**6
"""Seconds."""
HUNG_UP, INTERRUPTED = f"signal {int(signal.SIGHUP)}", f"signal {int(signal.SIGINT)}"

DRIVER = """
import json, os, signal, sys, time

log = open(sys.argv[1], "a", buffering=1)
ignores = "ignores" in sys.argv

def signalled(number, frame):
    if "late" in sys.argv:
        print("typed", os.read(0, 99).decode().split("\\n")[-1], file=log)
    print("signal", number, file=log)
    if number == signal.SIGHUP and not ignores:
        os._exit(129)

signal.signal(signal.SIGHUP, signalled)
signal.signal(signal.SIGINT, signalled)

def write(kind, payload):
    packet = memoryview(kind + len(payload).to_bytes(4, "big") + payload)
    while packet:
        packet = packet[os.write(1, packet):]

def begin():
    os.write(1, b"__GANGLION__\\n")
    write(b"D", b"first screen")

print("a warning of a library")
sys.stdout.flush()
if {"late", "waits"} & {*sys.argv}:
    while not os.path.exists(sys.argv[1] + ".go"):
        time.sleep(0.01)
begin()
while {"late", "deaf"} & {*sys.argv}:
    signal.pause()
read = sys.stdin.buffer.read
while head := read(5):
    payload = read(int.from_bytes(head[1:], "big"))
    write(b"D", head[:1] + payload)
    if payload == b"quit":
        write(b"M", json.dumps({"type": "exit"}).encode())
        break
    if payload == b"world":
        write(b"M", json.dumps({"type": "exit"}).encode())
        write(b"D", b"wiped")
        begin()
    while payload == b"flood":
        write(b"D", b"x" * 65536)
"""
"""Speaks as Textual's driver for pages does: sends back each packet, and writes down each signal."""


class Serving:
    """A server in this process, and what it logged."""

    def __init__(self, server: PageServer, port: int, log: list[str], signals: Path) -> None:
        self.server, self.port, self.log, self._signals = server, port, log, signals
        self.origin = f"http://localhost:{port}"

    @property
    def cookie(self) -> dict[str, str]:
        gate = self.server.gate
        return {"Cookie": f"{gate.cookie_name}={gate.cookie}"}

    @property
    def signals(self) -> list[str]:
        return self._signals.read_text().splitlines() if self._signals.exists() else []

    def page(self, client: ClientSession, **changes: str) -> Any:
        """``async with`` it: the socket of a page."""
        headers = {**self.cookie, "Origin": self.origin, **changes}
        return client.ws_connect(f"{self.origin}/ws", headers=headers)


@pytest.fixture
async def client() -> AsyncIterator[ClientSession]:
    async with ClientSession(cookie_jar=aiohttp.DummyCookieJar()) as session:
        yield session


@pytest.fixture
def serving(tmp_path: Path) -> Callable[..., Any]:
    """``async with serving(sessions=1) as served``."""

    @asynccontextmanager
    async def running(
        *arguments: str, address: str = "localhost", command: list[str] | None = None, **limits: Any
    ) -> AsyncIterator[Serving]:
        log: list[str] = []
        port, signals = free_port(), tmp_path / "signals"
        driver = [sys.executable, "-I", "-S", "-c", DRIVER, str(signals), *arguments]
        chosen = PageLimits(**limits)
        server = PageServer(command or driver, Words("en"), log.append, chosen, address=address, port=port)
        await server.start()
        try:
            yield Serving(server, port, log, signals)
        finally:
            await server.close()

    return running


async def until(condition: Callable[[], object]) -> None:
    end = time.monotonic() + TIMEOUT
    while not condition():
        assert time.monotonic() < end, "it never happened"
        await asyncio.sleep(0.01)


async def until_shown(page: ClientWebSocketResponse, shown: bytes) -> list[bytes]:
    """All that was shown, up to this."""
    seen: list[bytes] = []
    while shown not in seen:
        message = await page.receive(timeout=TIMEOUT)
        assert message.type is WSMsgType.BINARY, message
        seen.append(message.data)
    return seen


async def until_closed(page: ClientWebSocketResponse) -> tuple[int | None, str]:
    """The code and the reason."""
    while True:
        message = await page.receive(timeout=TIMEOUT)
        if message.type is WSMsgType.CLOSE:
            return message.data, str(message.extra)
        if message.type in (WSMsgType.CLOSED, WSMsgType.CLOSING, WSMsgType.ERROR):
            return page.close_code, ""


# --- who gets in


async def test_the_link_is_exchanged_for_a_cookie_that_scripts_and_other_sites_do_not_get(
    serving: Any, client: ClientSession
) -> None:
    async with serving() as served:
        async with client.get(served.server.gate.link) as answer:
            given = answer.headers["Set-Cookie"].split("; ")
            assert answer.status == 200
        assert {"HttpOnly", "SameSite=Strict", "Path=/"} <= set(given)
        async with client.get(served.origin, headers={"Cookie": given[0]}) as page:
            assert page.status == 200
        assert served.server.gate.secret not in given[0]
        assert served.log == []


async def test_each_server_has_a_secret_of_128_bits(serving: Any) -> None:
    async with serving() as one, serving() as other:
        secrets = {one.server.gate.secret, other.server.gate.secret}
        cookies = {one.server.gate.cookie, other.server.gate.cookie}

    assert len(secrets | cookies) == 4
    assert all(6 * len(each) >= 128 for each in secrets | cookies), "letters of 6 bits"


async def test_the_secret_and_the_cookie_are_in_no_title_and_nowhere_else_on_a_page(
    serving: Any, client: ClientSession
) -> None:
    async with serving() as served:
        gate, shown = served.server.gate, []
        for address, headers in (
            (served.server.gate.link, {}),
            (served.origin, served.cookie),
            (f"{served.origin}/page/page.js", served.cookie),
            (served.origin, {}),
        ):
            async with client.get(address, headers=headers) as answer:
                shown.append(await answer.text())

    assert ["<title>Donnie</title>" in each for each in shown] == [True, True, False, True]
    assert not [each for each in (*shown, *served.log) if gate.secret in each or gate.cookie in each]


ELSEWHERE = "http://attacker.example"

FOREIGN = {
    "no cookie": ({"Cookie": ""}, "it has no cookie of this server"),
    "a wrong cookie": ({"Cookie": "donnie-{port}=AAAAAAAAAAAAAAAAAAAAAA"}, "its cookie is wrong"),
    "a cookie of another server": ({"Cookie": "donnie-1={cookie}"}, "it has no cookie of this server"),
    "a name that points here": (
        {"Host": "attacker.example:{port}", "Origin": "http://attacker.example:{port}"},
        "it asks for the host attacker.example:{port}",
    ),
    "another port": ({"Host": "localhost:1"}, "it asks for the host localhost:1"),
    "a foreign page": ({"Origin": ELSEWHERE}, f"it comes from a page of {ELSEWHERE}"),
    "another port's page": ({"Origin": "http://localhost:1"}, "it comes from a page of http://localhost:1"),
    "a page without an origin": ({"Origin": "null"}, "it comes from a page of null"),
    "a picture on a foreign page": ({"Sec-Fetch-Site": "same-site"}, "it comes from another page"),
}
"""What differs from our own request, and what the log says of it."""


@pytest.mark.parametrize("path", ["/", "/static/js/textual.js", "/page/page.js", "/nothing", "/ws"])
@pytest.mark.parametrize("kind", FOREIGN)
async def test_what_is_not_ours_is_refused_with_one_line_in_the_log(
    serving: Any, client: ClientSession, kind: str, path: str
) -> None:
    async with serving(address="127.0.0.1") as served:
        values = {"port": served.port, "cookie": served.server.gate.cookie}
        changes, complaint = FOREIGN[kind]
        ours = {**served.cookie, "Host": f"localhost:{served.port}", "Origin": served.origin}
        headers = {**ours, **{name: each.format(**values) for name, each in changes.items()}}
        address = f"http://127.0.0.1:{served.port}{path}"
        if path == "/ws":
            with pytest.raises(WSServerHandshakeError) as refused:
                await client.ws_connect(address, headers=headers)
            assert refused.value.status == 403
        else:
            async with client.get(address, headers=headers) as answer:
                assert answer.status == 403

        assert served.log == [f"Refused 127.0.0.1: {complaint.format(**values)}."]
        assert served.signals == []


async def test_a_socket_must_say_from_which_page_it_comes(serving: Any, client: ClientSession) -> None:
    async with serving(address="127.0.0.1") as served:
        with pytest.raises(WSServerHandshakeError) as refused:
            await client.ws_connect(f"http://127.0.0.1:{served.port}/ws", headers=served.cookie)

        assert refused.value.status == 403
        assert served.log == ["Refused 127.0.0.1: it does not say from which page it comes."]


async def test_a_wrong_link_is_refused_and_not_printed(serving: Any, client: ClientSession) -> None:
    async with serving(address="127.0.0.1") as served:
        link = served.server.gate.link
        wrong = link[:-1] + ("B" if link.endswith("A") else "A")
        for each in (wrong, wrong[:-1], f"{link}/x", f"{served.origin}/start/%C3%A9"):
            async with client.get(each) as answer:
                assert answer.status in (403, 404)
                assert "Set-Cookie" not in answer.headers

        assert set(served.log) == {"Refused 127.0.0.1: its link is wrong."}


async def test_what_can_not_be_read_gets_one_line_and_no_traceback(serving: Any) -> None:
    async with serving(address="127.0.0.1") as served:
        reader, writer = await asyncio.open_connection("127.0.0.1", served.port)
        writer.write(b"\x16\x03\x01\xff\xfe\x00 / HTTP/9\r\n\r\n")
        answer = await asyncio.wait_for(reader.read(), TIMEOUT)
        writer.close()

        assert b" 400 " in answer.split(b"\r\n")[0]
        assert b"Traceback" not in answer
        assert len(served.log) <= 1


@pytest.mark.parametrize("path", ["/", "/ws", "/page/page.js", "/static/js/textual.js"])
async def test_a_page_that_is_closed_before_its_answer_comes_is_no_fault(serving: Any, path: str) -> None:
    """A browser is closed while it loads, in both ways that a connection can end."""
    socket_headers = (
        "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
    )
    async with serving() as it:
        for reset in (struct.pack("ii", 1, 0), struct.pack("ii", 0, 0)) * 5:
            _, writer = await asyncio.open_connection("localhost", it.port)
            headers = f"Host: localhost:{it.port}\r\nOrigin: {it.origin}\r\nCookie: {it.cookie['Cookie']}\r\n"
            writer.write(f"GET {path} HTTP/1.1\r\n{headers}{socket_headers}\r\n".encode())
            writer.get_extra_info("socket").setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, reset)
            writer.transport.abort()
        server = it.server._runner.server
        await until(lambda: not server.connections)

        assert it.log == []


def _sendfile() -> None:
    """As aiohttp calls it, where the connection ends while it sends a file."""
    raise RuntimeError("Transport is closing")


@pytest.mark.parametrize(("fails", "faults"), [(_sendfile, 0), ({}.popitem, 1), (lambda: int("x"), 1)])
def test_every_other_fault_gets_its_line(fails: Callable[[], object], faults: int) -> None:
    log = list[str]()
    logger = _logger(lambda: log.append("fault"))
    try:
        fails()
    except Exception:
        logger.exception("Unhandled exception")
    assert len(log) == faults
    logger.warning("without an exception")
    assert len(log) == faults + 1


@pytest.mark.parametrize(
    ("name", "value"), [("Sec-WebSocket-Key", b"MDEyMzQ1Njc4\xffOWFiY2RlZg=="), ("Upgrade", b"websocket\xff")]
)
async def test_a_socket_whose_header_is_not_ascii_is_refused_without_a_fault(
    serving: Any, name: str, value: bytes
) -> None:
    async with serving(address="127.0.0.1") as served:
        headers = {
            "Host": served.origin.removeprefix("http://"),
            "Origin": served.origin,
            **served.cookie,
            "Connection": "Upgrade",
            "Upgrade": "websocket",
            "Sec-WebSocket-Version": "13",
            "Sec-WebSocket-Key": "MDEyMzQ1Njc4OWFiY2RlZg==",
        }
        lines = [
            f"{key}: ".encode() + (value if key == name else text.encode()) for key, text in headers.items()
        ]
        reader, writer = await asyncio.open_connection("127.0.0.1", served.port)
        writer.write(b"\r\n".join([b"GET /ws HTTP/1.1", *lines, b"", b""]))
        answer = await asyncio.wait_for(reader.readline(), TIMEOUT)
        writer.close()

        assert b" 400 " in answer
        assert served.log == []


@pytest.mark.parametrize("address", ["0.0.0.0", "127.0.0.1", "localhost"])
async def test_it_knows_whether_other_computers_reach_it(serving: Any, address: str) -> None:
    async with serving(address=address) as served:
        assert served.server.is_open_to_others == (address == "0.0.0.0")


async def test_an_open_server_takes_its_address_for_a_host_and_no_foreign_name(
    serving: Any, client: ClientSession
) -> None:
    async with serving(address="0.0.0.0") as served:
        address = f"http://127.0.0.1:{served.port}/"
        async with client.get(address, headers=served.cookie) as answer:
            assert answer.status == 200
        foreign = {**served.cookie, "Host": f"attacker.example:{served.port}"}
        async with client.get(address, headers=foreign) as answer:
            assert answer.status == 403


# --- the page


async def test_the_page_has_a_title_and_a_language_and_asks_no_other_host(
    serving: Any, client: ClientSession
) -> None:
    async with serving() as served, client.get(served.origin, headers=served.cookie) as answer:
        page, policy = await answer.text(), answer.headers["Content-Security-Policy"]

    assert "<title>Donnie</title>" in page
    assert '<html lang="en">' in page
    assert "//" not in page.replace(f"ws://localhost:{served.port}/ws", "")
    sources = dict(each.split(maxsplit=1) for each in policy.split("; "))
    nonce = sources["style-src"].removeprefix("'self' ")
    assert sources == {
        "default-src": "'none'",
        "script-src": "'self'",
        "style-src": f"'self' {nonce}",
        "font-src": "'self'",
        "img-src": "data:",
        "connect-src": f"'self' ws://localhost:{served.port}",
        "base-uri": "'none'",
        "form-action": "'none'",
        "frame-ancestors": "'none'",
    }
    assert f'nonce="{nonce[7:-1]}"' in page


async def test_everything_that_the_page_needs_is_served_here(serving: Any, client: ClientSession) -> None:
    async with serving() as served:
        for path in (
            "static/js/textual.js",
            "static/css/xterm.css",
            "static/fonts/RobotoMono-VariableFont_wght.ttf",
            "static/fonts/RobotoMono-Italic-VariableFont_wght.ttf",
            "page/page.css",
            "page/page.js",
        ):
            async with client.get(f"{served.origin}/{path}", headers=served.cookie) as answer:
                assert answer.status == 200, path
                assert answer.headers["X-Content-Type-Options"] == "nosniff"


@pytest.mark.parametrize("path", ["/static/", "/page/", "/static/../page.py", "/page/%2e%2e/page_server.py"])
async def test_folders_and_other_files_are_not_served(serving: Any, client: ClientSession, path: str) -> None:
    async with serving(address="127.0.0.1") as served:
        reader, writer = await asyncio.open_connection("127.0.0.1", served.port)
        cookie = served.cookie["Cookie"]
        host = f"localhost:{served.port}"
        head = (f"GET {path} HTTP/1.1", f"Host: {host}", f"Cookie: {cookie}", "Connection: close", "", "")
        writer.write("\r\n".join(head).encode())
        answer = await asyncio.wait_for(reader.read(), TIMEOUT)
        writer.close()

    assert answer.split()[1] in (b"403", b"404")


# --- what a page may use


async def test_keys_go_to_the_process_and_what_it_paints_comes_back(
    serving: Any, client: ClientSession
) -> None:
    async with serving() as served, served.page(client) as page:
        await page.send_json(["stdin", "fwé"])
        await until_shown(page, "Dfwé".encode())
        await page.send_json(["resize", {"width": 100, "height": 30}])
        await until_shown(page, b'M{"type": "resize", "width": 100, "height": 30}')


async def test_what_a_page_sends_and_nothing_understands_is_ignored(
    serving: Any, client: ClientSession
) -> None:
    """Also with the limit of calls that learners' programs get, at which a deep packet would end Python."""
    raise_recursion_limit()
    garbage = [
        *("", "\x00", "{", "null", "[]", "[1]", "[" * 99_999),
        *('["stdin"]', '["stdin", 1]', '["stdin", "\\ud800"]', '["ping", {}]'),
        *('["resize", {}]', '["resize", [1, 2]]', '["resize", {"width": "x"}]'),
    ]
    async with serving() as served, served.page(client) as page:
        await until_shown(page, b"first screen")
        for each in garbage:
            await page.send_str(each)
        await page.send_bytes(b"\xff\x00")
        await page.send_json(["stdin", "still here"])
        assert await until_shown(page, b"Dstill here") == [b"Dstill here"]


@pytest.mark.parametrize("size", [(10**8, 10**8), (0, 0), (-5, 1), (10**30, 24)])
async def test_a_screen_has_a_size_that_a_screen_may_have(
    serving: Any, client: ClientSession, size: tuple[int, int]
) -> None:
    async with serving() as served, served.page(client) as page:
        await until_shown(page, b"first screen")
        await page.send_json(["resize", {"width": size[0], "height": size[1]}])
        await page.send_json(["stdin", "end"])
        for shown in await until_shown(page, b"Dend"):
            if shown.startswith(b"M"):
                sentences = json.loads(shown[1:])
                assert 20 <= sentences["width"] <= 500
                assert 6 <= sentences["height"] <= 200


async def test_one_page_too_many_is_refused_with_a_sentence(serving: Any, client: ClientSession) -> None:
    async with serving(sessions=2) as served, served.page(client) as one, served.page(client) as other:
        await until_shown(one, b"first screen")
        await until_shown(other, b"first screen")
        async with served.page(client) as third:
            assert await until_closed(third) == (1013, "2 pages are open already. Close one first.")
        assert served.log == ["2 pages are open already. Close one first."]
        await one.send_json(["stdin", "on"])
        await until_shown(one, b"Don")


async def test_a_page_that_is_loaded_again_gets_the_place_that_it_left(
    serving: Any, client: ClientSession
) -> None:
    async with serving(sessions=1) as served:
        for _ in range(3):
            async with served.page(client) as page:
                await until_shown(page, b"first screen")
        assert served.log == []


async def test_a_frame_that_is_too_large_ends_its_page_and_no_other(
    serving: Any, client: ClientSession
) -> None:
    async with serving(frame=1000) as served, served.page(client) as page, served.page(client) as other:
        await until_shown(page, b"first screen")
        await page.send_json(["stdin", "x" * 1001])
        assert (await until_closed(page))[0] == 1009
        await until(lambda: served.signals == [HUNG_UP])
        await other.send_json(["stdin", "on"])
        await until_shown(other, b"Don")


async def test_a_page_without_a_key_for_long_ends_and_its_text_is_kept(
    serving: Any, client: ClientSession
) -> None:
    async with serving(idle=0.05) as served, served.page(client) as page:
        said = "No key for 1 minute. The text is kept: RECOVER opens it."
        assert await until_closed(page) == (IDLE_CODE, said)
        await until(lambda: not served.server._sessions)


async def test_a_connection_that_asks_for_nothing_is_closed(serving: Any) -> None:
    async with serving(address="127.0.0.1", first_request=0.05) as served:
        reader, writer = await asyncio.open_connection("127.0.0.1", served.port)
        writer.write(b"GET / HTTP/1.1\r\nHost: lo")
        assert await asyncio.wait_for(reader.read(), TIMEOUT) == b""
        writer.close()


async def test_there_are_no_more_connections_than_allowed(serving: Any) -> None:
    async with serving(address="127.0.0.1", connections=2) as served:
        opened = [await asyncio.open_connection("127.0.0.1", served.port) for _ in range(3)]
        with suppress(ConnectionResetError):
            await asyncio.wait_for(opened[2][0].read(), TIMEOUT)
        assert opened[2][0].at_eof() or opened[2][0].exception() is not None
        assert not opened[0][0].at_eof()
        for _, writer in opened:
            writer.close()


# --- when a page is gone


async def test_a_page_that_is_cut_hangs_up_its_process(serving: Any, client: ClientSession) -> None:
    async with serving() as served:
        page = await served.page(client)
        await until_shown(page, b"first screen")
        page._response.connection.transport.abort()
        await until(lambda: served.signals == [HUNG_UP])


async def test_a_page_that_takes_no_output_stops_its_robot_and_then_counts_as_gone(
    serving: Any, client: ClientSession
) -> None:
    """The client reads no more than fits into its buffers. No heartbeat would notice it."""
    async with serving(stalled=0.05, lost=0.05, heartbeat=NEVER) as served:
        page = await served.page(client)
        await page.send_json(["stdin", "flood"])
        await until(lambda: HUNG_UP in served.signals)
        assert set(served.signals[:-1]) == {INTERRUPTED}
        await page.close()


async def test_a_page_whose_process_takes_no_keys_counts_as_gone(serving: Any, client: ClientSession) -> None:
    async with serving("deaf", lost=0.05, heartbeat=NEVER) as served:
        page = await served.page(client)
        await until_shown(page, b"first screen")
        for _ in range(4):
            await page.send_json(["stdin", "x" * 2**18])  # more than pipes and buffers hold
        await until(lambda: served.signals == [HUNG_UP])
        assert await until_closed(page) == (1006, "")  # it was cut


async def test_a_page_that_is_lost_hangs_up_its_process_before_the_keys_that_wait(
    serving: Any, client: ClientSession
) -> None:
    """As after a key was held down at a process that hangs. Each of them would wait for half a second."""
    async with serving("deaf", lost=0.5, heartbeat=NEVER) as served:
        page = await served.page(client)
        await until_shown(page, b"first screen")
        await page.send_json(["stdin", "x" * 2**19])  # more than pipes and buffers hold
        for _ in range(2000):
            await page.send_json(["stdin", "x"])
        await until(lambda: served.signals == [HUNG_UP])
        await page.close()


async def test_a_page_that_answers_no_longer_counts_as_gone(serving: Any, client: ClientSession) -> None:
    """As after a pulled cable: nothing is closed."""
    async with serving(heartbeat=1) as served:
        headers = {**served.cookie, "Origin": served.origin}
        page = await client.ws_connect(f"{served.origin}/ws", headers=headers, autoping=False)
        while (message := await page.receive(timeout=TIMEOUT)).data != b"first screen":
            assert message.type is WSMsgType.PING
            await page.pong(message.data)
        await until(lambda: served.signals == [HUNG_UP])
        await page.close()


async def test_a_process_that_ignores_it_is_killed(serving: Any, client: ClientSession) -> None:
    async with serving("ignores", end=0.05, sessions=1) as served:
        async with served.page(client) as page:
            await until_shown(page, b"first screen")
        async with served.page(client) as page:
            await until_shown(page, b"first screen")


async def test_the_end_of_the_server_ends_every_page(serving: Any, client: ClientSession) -> None:
    async with serving() as served, served.page(client) as page:
        await until_shown(page, b"first screen")
        closing = asyncio.create_task(served.server.close())
        said = "donnie serve has ended. The text is kept: RECOVER opens it."
        assert await until_closed(page) == (1001, said)
        await closing
        assert served.signals == [HUNG_UP]


async def test_a_process_that_ends_closes_its_page(serving: Any, client: ClientSession) -> None:
    async with serving() as served, served.page(client) as page:
        await page.send_json(["stdin", "quit"])
        assert await until_closed(page) == (1000, "")


async def test_a_page_whose_process_can_not_start_says_why(serving: Any, client: ClientSession) -> None:
    code = "import sys; sys.exit('The world maze2 is unknown.')"
    async with serving(command=[sys.executable, "-c", code]) as served, served.page(client) as page:
        assert await until_closed(page) == (4001, "The world maze2 is unknown.")


async def test_what_was_typed_before_the_process_listens_reaches_it_although_the_page_is_gone(
    serving: Callable[..., Any], client: ClientSession, tmp_path: Path
) -> None:
    async with serving("late", late=TIMEOUT) as served:
        async with served.page(client) as page:
            await page.send_json(["stdin", "FW 1"])
            await page.send_json(["ping", "1"])
            assert await page.receive_json() == ["pong", "1"]  # the key was taken before
        (tmp_path / "signals.go").touch()
        async with asyncio.timeout(TIMEOUT), served.server._ended:
            await served.server._ended.wait_for(lambda: not served.server._sessions)

        typed, signalled = served.signals
        assert typed.endswith("FW 1")
        assert signalled == HUNG_UP


async def test_what_is_typed_before_the_process_listens_comes_in_order_as_far_as_there_is_room(
    serving: Callable[..., Any], client: ClientSession, tmp_path: Path
) -> None:
    async with serving("waits", frame=1000) as served, served.page(client) as page:
        for number in range(30):
            await page.send_json(["stdin", f"{number:3}" + "x" * 92])  # 100 bytes as a packet
        await page.send_json(["ping", "1"])
        assert await page.receive_json() == ["pong", "1"]
        (tmp_path / "signals.go").touch()
        await until_shown(page, b"first screen")
        await page.send_json(["stdin", "now"])
        *taken, last = await until_shown(page, b"Dnow")

        assert [int(each[1:4]) for each in taken] == [*range(10)]
        assert last == b"Dnow"


async def test_another_world_keeps_the_page_with_its_size_and_focus(
    serving: Any, client: ClientSession
) -> None:
    """Each world has a driver of its own, which knows the first size and no focus."""
    async with serving() as served, served.page(client) as page:
        await until_shown(page, b"first screen")
        await page.send_json(["resize", {"width": 100, "height": 30}])
        await page.send_json(["focus"])
        await page.send_json(["stdin", "world"])
        await until_shown(page, b"Dworld")
        await until_shown(page, b"first screen")
        await until_shown(page, b'M{"type": "resize", "width": 100, "height": 30}')
        await until_shown(page, b'M{"type": "focus"}')
        await page.send_json(["stdin", "on"])
        await until_shown(page, b"Don")


# --- the command


@pytest.mark.parametrize(
    ("option", "complaint"),
    [
        ("--port=0", "0 is not a port; a port is a number from 1 to 65535."),
        ("--port=65536", "65536 is not a port; a port is a number from 1 to 65535."),
        ("--port=x", "x is not a port; a port is a number from 1 to 65535."),
        ("--sessions=0", "0 is not a number of pages; 1 to 100 are possible."),
        ("--sessions=²", "² is not a number of pages; 1 to 100 are possible."),
        ("--idle=-1", "-1 is not a number of minutes; 0 to 1440 are possible."),
        ("--idle=1e9", "1e9 is not a number of minutes; 0 to 1440 are possible."),
        ("--events=-", "A page can't write events to standard output. Name a file."),
        ("--record=no_such_file", "--record writes one file, so it needs --sessions 1."),
    ],
)
def test_an_option_that_can_not_be_used_is_reported(
    capsys: pytest.CaptureFixture[str], option: str, complaint: str
) -> None:
    assert main(["serve", option, "--lang", "en"]) == 2
    assert capsys.readouterr() == ("", f"{complaint}\n")


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        ("en", "Port {} can't be used: another program uses it.\n"),
        ("pt", "A porta {} não pode ser usada: está em uso.\n"),
        ("es", "El puerto {} no se puede usar: está en uso.\n"),
    ],
)
def test_a_port_that_is_taken_is_reported_before_a_link_is_printed(
    capsys: pytest.CaptureFixture[str], language: str, sentence: str
) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        assert main(["serve", f"--port={port}", "--lang", language]) == 2

    assert capsys.readouterr() == ("", sentence.format(port))


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        ("en", "Port {} of 192.0.2.1 can't be used: this machine does not have that address.\n"),
        ("pt", "A porta {} de 192.0.2.1 não pode ser usada: esta máquina não tem esse endereço.\n"),
        ("es", "El puerto {} de 192.0.2.1 no se puede usar: esta máquina no tiene esa dirección.\n"),
    ],
)
def test_an_address_of_another_machine_can_not_be_listened_on(
    capsys: pytest.CaptureFixture[str], language: str, sentence: str
) -> None:
    """The address is one that no machine has: RFC 5737 keeps it for examples."""
    port = free_port()
    assert main(["serve", "--listen=192.0.2.1", f"--port={port}", "--lang", language]) == 2

    assert capsys.readouterr() == ("", sentence.format(port))


def test_without_textual_serve_a_checkout_names_the_command_that_installs_it_there(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(front_end, "find_spec", lambda name: None if name == "textual_serve" else object())
    assert main(["serve", "--lang", "en"]) == 2

    sentence, _, command = capsys.readouterr().err.strip().partition(": ")
    assert sentence == "This needs textual-serve"
    assert shlex.split(command) == [
        sys.executable, "-m", "pip", "install", "--editable", f"{ROOT}[serve]",
    ]  # fmt: skip


async def test_every_answer_has_a_policy_that_forbids_all_but_what_it_names(
    serving: Any, client: ClientSession
) -> None:
    async with serving() as served:
        for address, headers in (
            (served.server.gate.link, {}),
            (served.origin, {}),
            (f"{served.origin}/page/page.js", served.cookie),
            (f"{served.origin}/nothing", served.cookie),
        ):
            async with client.get(address, headers=headers) as answer:
                assert answer.headers["Content-Security-Policy"].startswith("default-src 'none'; ")


async def test_no_other_page_may_show_read_or_keep_a_page(serving: Any, client: ClientSession) -> None:
    async with serving() as served, client.get(served.origin, headers=served.cookie) as page:
        headers = page.headers

    assert headers["Cross-Origin-Opener-Policy"] == headers["Cross-Origin-Resource-Policy"] == "same-origin"
    assert headers["Cache-Control"] == "no-store"
    assert headers["Referrer-Policy"] == "no-referrer"
    assert headers["X-Content-Type-Options"] == "nosniff"
    assert headers["X-Frame-Options"] == "DENY"
    policy = headers["Content-Security-Policy"].split("; ")
    assert {"default-src 'none'", "base-uri 'none'", "form-action 'none'", "frame-ancestors 'none'"} <= set(
        policy
    )


# --- limits and names


def test_the_limits_of_a_page_are_those_of_the_documents() -> None:
    """Of the table in full-screen.md; a silent connection has half of the heartbeat more."""
    limits = PageLimits()

    assert (limits.sessions, limits.idle, limits.frame) == (8, 60 * 60, 1024 * 1024)
    assert (limits.stalled, limits.lost, limits.heartbeat * 1.5) == (2.5, 20, 15)


@pytest.mark.parametrize(
    ("asked", "given"),
    [
        ((80, 24), (80, 24)),
        ((20, 6), (20, 6)),
        ((19, 5), (20, 6)),
        ((500, 200), (500, 200)),
        ((501, 201), (500, 200)),
    ],
)
def test_a_screen_has_from_twenty_by_six_to_five_hundred_by_two_hundred(
    asked: tuple[int, int], given: tuple[int, int]
) -> None:
    assert size_of(*asked) == given


@pytest.mark.parametrize(
    ("sentence", "reason"),
    [
        ("short", b"short"),
        ("x" * 124, b"x" * 123),
        ("x" * 122 + "é", b"x" * 122),
        ("x" * 121 + "é", b"x" * 121 + "é".encode()),
        ("\ud800", b"?"),
    ],
)
def test_the_reason_of_an_end_is_cut_between_two_characters(sentence: str, reason: bytes) -> None:
    assert as_reason(sentence) == reason


@pytest.mark.parametrize(
    ("address", "port", "host"),
    [
        ("localhost", 8000, "localhost:8000"),
        ("localhost", 80, "localhost"),
        ("127.0.0.1", 8000, "127.0.0.1:8000"),
        ("::1", 8000, "[::1]:8000"),
        ("192.168.1.2", 80, "192.168.1.2"),
        ("0.0.0.0", 8000, f"{socket.gethostname()}:8000"),
        ("::", 80, socket.gethostname()),
    ],
)
def test_a_link_names_the_machine_and_its_port(address: str, port: int, host: str) -> None:
    gate = Gate(address, port)

    assert gate.link == f"http://{host}/start/{gate.secret}"
    assert gate.cookie_name == f"donnie-{port}"


@pytest.mark.parametrize(
    ("asked", "given"),
    [("", 16), ("x", 16), ("20", 20), ("6", 6), ("5", 6), ("72", 72), ("73", 72), ("-3", 6)],
)
async def test_the_letters_of_a_page_have_a_size_that_can_be_read(
    serving: Any, client: ClientSession, asked: str, given: int
) -> None:
    async with serving() as served:
        place = f"{served.origin}/?fontsize={asked}"
        async with client.get(place, headers=served.cookie) as answer:
            assert f'data-font-size="{given}"' in await answer.text()


async def test_a_page_has_the_size_that_its_socket_asks_for(serving: Any, client: ClientSession) -> None:
    shown = "import os; os.write(2, (os.environ['COLUMNS'] + ' ' + os.environ['ROWS']).encode()); os._exit(3)"
    command = [sys.executable, "-I", "-S", "-c", shown]
    async with serving(command=command) as served:
        for query, size in (
            ("", "80 24"),
            ("?width=100&height=30", "100 30"),
            ("?width=1&height=x", "20 24"),
        ):
            headers = {**served.cookie, "Origin": served.origin}
            async with client.ws_connect(f"{served.origin}/ws{query}", headers=headers) as page:
                assert await until_closed(page) == (4001, size)


async def test_with_the_session_of_a_page_what_it_has_started_is_killed() -> None:
    """The inner process keeps the pipe open as long as it lives."""
    shell = await asyncio.create_subprocess_exec(
        *("/bin/sh", "-c", "sleep 1000 & echo; wait"), stdout=asyncio.subprocess.PIPE, start_new_session=True
    )
    assert shell.stdout is not None
    await shell.stdout.readline()

    _kill_group(shell)

    assert await asyncio.wait_for(shell.stdout.read(), TIMEOUT) == b""
    assert await shell.wait() == -signal.SIGKILL
