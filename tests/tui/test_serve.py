"""``donnie serve``: a page on this machine alone, and the full screen behind it."""

import asyncio
import base64
import json
import os
import shutil
import subprocess
import sys
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress
from pathlib import Path
from typing import Any
from urllib.parse import quote

import pyte
import pytest

from tests.free_ports import free_port
from tests.sessions.command import COMMAND, QUIET, environment
from tests.timeouts import TIMEOUT

aiohttp = pytest.importorskip("aiohttp")
pytest.importorskip("textual_serve")

pytestmark = pytest.mark.slow

FIRST_WORDS = "F5 runs the program."
"""Of the first frame: what is typed then waits for the session."""

ROOT = Path(__file__).resolve().parents[2]


class Server:
    """``donnie serve`` in a process and a folder of its own."""

    def __init__(self, folder: Path, *options: str) -> None:
        self.port, self.folder = free_port(), folder
        self.address = f"http://localhost:{self.port}"
        self.process = subprocess.Popen(
            [*COMMAND, "serve", "--port", str(self.port), *QUIET, "--lang", "en", *options],
            cwd=ROOT,
            env=environment(folder),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        assert self.process.stdout is not None
        self.printed: list[str] = []
        self.link = ""
        while not self.link:
            self.printed.append(self.process.stdout.readline())
            assert self.printed[-1], self.process.stderr.read()  # it ended
            self.link = next((word for word in self.printed[-1].split() if word.startswith("http")), "")

    async def session(self) -> Any:
        """A client with the cookie."""
        session = aiohttp.ClientSession()
        async with session.get(self.link) as page:
            assert page.status == 200
        return session

    @asynccontextmanager
    async def page(self, size: str = "width=80&height=24") -> AsyncIterator[Any]:
        """A page's socket."""
        async with (
            await self.session() as session,
            session.ws_connect(f"{self.address}/ws?{size}", headers={"Origin": self.address}) as terminal,
        ):
            yield terminal

    @property
    def children(self) -> list[int]:
        """The processes of the pages."""
        found = Path(f"/proc/{self.process.pid}/task/{self.process.pid}/children")
        return [int(each) for each in found.read_text().split()]

    @property
    def copies(self) -> list[str]:
        """The texts that the next start offers."""
        return [each.read_text() for each in (self.folder / "state").rglob("unsaved-*.gd")]

    def end(self) -> None:
        self.process.terminate()
        self.process.wait(TIMEOUT)


@pytest.fixture
def server(tmp_path):
    server = Server(tmp_path)
    yield server
    server.end()


@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_a_page_shows_the_full_screen(server):
    async with await server.session() as session, session.get(server.address) as page:
        assert page.status == 200
        assert "Donnie" in await page.text()
    async with server.page() as terminal:
        await until_shown(terminal, Shown(), FIRST_WORDS)


async def until(condition: Any) -> None:
    end = time.monotonic() + TIMEOUT
    while not condition():
        assert time.monotonic() < end, "it never happened"
        await asyncio.sleep(0.05)


AGAIN = 10.0
"""Seconds until a key is typed again."""


class Shown:
    """What stands on a terminal: only what changes is sent, also in the middle of a sentence."""

    def __init__(self) -> None:
        self._screen = pyte.Screen(200, 60)
        self._stream = pyte.ByteStream(self._screen)

    def feed(self, sent: bytes) -> None:
        self._stream.feed(sent)

    def __str__(self) -> str:
        return "\n".join(line.rstrip() for line in self._screen.display)

    def has(self, text: str) -> bool:
        return any(text in line for line in self._screen.display)


async def until_shown(terminal: Any, shown: Shown, text: str) -> None:
    while not shown.has(text):
        try:
            message = await terminal.receive(timeout=TIMEOUT)
        except TimeoutError:
            pytest.fail(f"never shown: {text}\n{shown}")
        if message.type in (aiohttp.WSMsgType.CLOSE, aiohttp.WSMsgType.CLOSING, aiohttp.WSMsgType.CLOSED):
            pytest.fail(f"closed before it was shown: {text}\n{shown}")
        if isinstance(message.data, bytes):
            shown.feed(message.data)


CHROMIUM = shutil.which("chromium")


@pytest.fixture
def browser(server, tmp_path):
    """The address of a page's debugger, in a headless browser that looks at the server."""
    port = free_port()
    process = subprocess.Popen(
        [
            str(CHROMIUM), "--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1000,700",
            f"--remote-debugging-port={port}", f"--user-data-dir={tmp_path / 'browser'}",
            server.link,
        ],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )  # fmt: skip
    yield f"http://localhost:{port}/json"
    process.terminate()
    process.wait(TIMEOUT)


class Page:
    """A page under a debugger: keys go in; what the server sends to it is written down."""

    def __init__(self, socket: Any, browser: str, session: Any) -> None:
        self._socket, self._browser, self._session = socket, browser, session
        self._calls = 0
        self._shown = Shown()
        self.asked: list[str] = []
        """The addresses of what the page asked for."""
        self.complaints: list[str] = []
        """Breaches of the page's policy."""

    @asynccontextmanager
    async def another(self, address: str) -> AsyncIterator["Page"]:
        """In the same browser, with the same cookies."""
        async with self._session.put(f"{self._browser}/new?{quote(address, safe='')}") as opened:
            debugger = (await opened.json())["webSocketDebuggerUrl"]
        async with self._session.ws_connect(debugger, max_msg_size=0) as socket:
            yield Page(socket, self._browser, self._session)

    async def call(self, method: str, **values: Any) -> dict[str, Any]:
        self._calls += 1
        await self._socket.send_json({"id": self._calls, "method": method, "params": values})
        while True:
            reply = await self._socket.receive_json(timeout=TIMEOUT)
            self._note(reply)
            if reply.get("id") == self._calls:
                return reply.get("result", {})

    def _note(self, reply: dict[str, Any]) -> None:
        if reply.get("method") == "Network.requestWillBeSent":
            self.asked.append(reply["params"]["request"]["url"])
        if reply.get("method") == "Network.webSocketCreated":
            self.asked.append(reply["params"]["url"])
        if reply.get("method") == "Log.entryAdded" and reply["params"]["entry"]["source"] == "security":
            self.complaints.append(reply["params"]["entry"]["text"])
        if reply.get("method") == "Network.webSocketFrameReceived":
            frame = reply["params"]["response"]
            if frame["opcode"] != 1:
                self._shown.feed(base64.b64decode(frame["payloadData"]))

    async def gets(self, text: str) -> None:
        while not self._shown.has(text):
            try:
                self._note(await self._socket.receive_json(timeout=TIMEOUT))
            except TimeoutError:
                pytest.fail(f"never shown: {text}\n{self._shown}")

    async def opened(self) -> None:
        """The page, from its beginning: the link was exchanged, and what it asks for is written down."""
        await self.call("Network.enable")
        await self.call("Log.enable")
        while not await self.value("document.getElementById('terminal') !== null"):
            pass
        await self.call("Page.reload")

    async def value(self, expression: str) -> Any:
        evaluated = await self.call("Runtime.evaluate", expression=expression)
        return evaluated.get("result", {}).get("value")  # none while another page is loaded

    async def until_title(self, title: str) -> None:
        end = time.monotonic() + TIMEOUT
        while (found := await self.value("document.title")) != title:
            assert time.monotonic() < end, found

    async def type(self, letters: str) -> None:
        """As a keyboard does, into the hidden text field that the page's terminal listens to."""
        await self.value("document.querySelector('.xterm-helper-textarea').focus()")
        for letter in letters:
            key = {
                "key": letter,
                "code": f"Key{letter.upper()}",
                "windowsVirtualKeyCode": ord(letter.upper()),
            }
            await self.call("Input.dispatchKeyEvent", type="keyDown", text=letter, **key)
            await self.call("Input.dispatchKeyEvent", type="keyUp", **key)

    async def press(self, key: str, code: int) -> None:
        for kind in ("rawKeyDown", "keyUp"):
            await self.call("Input.dispatchKeyEvent", type=kind, key=key, windowsVirtualKeyCode=code)


@asynccontextmanager
async def page_of(browser: str) -> AsyncIterator[Page]:
    end = time.monotonic() + TIMEOUT
    async with aiohttp.ClientSession() as session:
        while True:
            try:
                async with session.get(browser) as listed:
                    address = next(each for each in await listed.json() if each["type"] == "page")
                    break
            except (aiohttp.ClientError, StopIteration):
                assert time.monotonic() < end, "the browser does not start"
                await asyncio.sleep(0.1)
        async with session.ws_connect(address["webSocketDebuggerUrl"], max_msg_size=0) as socket:
            yield Page(socket, browser, session)


@pytest.mark.skipif(CHROMIUM is None, reason="needs chromium")
@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_a_browser_shows_the_main_screen_and_tab_gives_it_the_keyboard(browser):
    async with page_of(browser) as page:
        await page.opened()
        await page.gets(FIRST_WORDS)
        while await page.value("document.activeElement.tagName") != "TEXTAREA":
            await page.press("Tab", 9)
        assert await page.value("document.querySelectorAll('.xterm-text-layer').length") == 1


@pytest.mark.skipif(CHROMIUM is None, reason="needs chromium")
@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_letters_typed_in_a_browser_are_read_and_answered(browser):
    """A page begins without the focus: once it has it, the program has it too."""
    async with page_of(browser) as page:
        await page.call("Emulation.setFocusEmulationEnabled", enabled=True)
        await page.opened()
        await page.gets(FIRST_WORDS)
        while await page.value("document.querySelector('.xterm-helper-textarea') === null"):
            pass
        await page.type("fwq")
        await page.gets("I do not know fwq.")


@pytest.mark.skipif(CHROMIUM is None, reason="needs chromium")
@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_a_page_asks_this_server_alone_and_keeps_its_policy(browser, server):
    async with page_of(browser) as page:
        await page.opened()
        await page.gets(FIRST_WORDS)
        assert await page.value("document.fonts.check('16px \"Roboto Mono\"')")
        assert await page.value("document.title") == "Donnie"

        ours = (server.address, f"ws://localhost:{server.port}/ws", "data:")
        assert page.asked
        assert [each for each in page.asked if not each.startswith(ours)] == []
        assert page.complaints == []


FOREIGN_PAGE = """<!DOCTYPE html><title>foreign</title><script>
const ours = location.hash.slice(1);
const tries = [
  new Promise(done => {
    const socket = new WebSocket(`ws://${ours}/ws?width=80&height=24`);
    socket.onopen = () => done("open");
    socket.onerror = () => done("refused");
  }),
  fetch(`http://${ours}/`, {mode: "no-cors", credentials: "include"}).then(() => "answered", () => "refused"),
  fetch(`http://${ours}/`, {credentials: "include"}).then(each => each.text(), () => "refused"),
  new Promise(done => {
    const frame = document.createElement("iframe");
    frame.onload = () => done("loaded");
    frame.src = `http://${ours}/`;
    document.documentElement.append(frame);
  }),
];
Promise.all(tries).then(all => { document.title = all.join(" "); });
</script>"""
"""Of another port of this machine: for the browser the same site, which gets our cookie."""


@pytest.mark.skipif(CHROMIUM is None, reason="needs chromium")
@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_a_page_of_another_origin_gets_nothing_even_with_our_cookie(browser, server):
    from aiohttp import web

    async def foreign(_: web.Request) -> web.Response:
        return web.Response(text=FOREIGN_PAGE, content_type="text/html")

    application, port = web.Application(), free_port()
    application.router.add_get("/", foreign)
    runner = web.AppRunner(application)
    await runner.setup()
    await web.TCPSite(runner, "localhost", port).start()
    try:
        async with page_of(browser) as page:
            await page.opened()
            await page.gets(FIRST_WORDS)
            async with page.another(f"http://localhost:{port}/#localhost:{server.port}") as other:
                await other.until_title("refused refused refused loaded")
    finally:
        await runner.cleanup()
    server.end()
    log = server.process.stderr.read().splitlines()
    from_there = f"Refused ADDRESS: it comes from a page of http://localhost:{port}."
    assert {each.replace("127.0.0.1", "ADDRESS").replace("::1", "ADDRESS") for each in log} == {
        from_there,
        "Refused ADDRESS: it comes from another page.",
    }
    assert len(log) == 4


@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_a_page_that_begins_without_the_focus_takes_letters(server):
    async with server.page() as terminal:
        shown = Shown()
        await until_shown(terminal, shown, FIRST_WORDS)
        for message in (["focus"], ["stdin", "fwq"]):
            await terminal.send_json(message)
        await until_shown(terminal, shown, "I do not know fwq.")


CTRL_K, CTRL_O, CTRL_Q = "\x0b", "\x0f", "\x11"
PROGRAM = "FW 3 -- not saved"


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_no_process_shows_the_secret(server):
    async with server.page() as terminal:
        await until_shown(terminal, Shown(), FIRST_WORDS)
        secret, children = server.link.rpartition("/")[2].encode(), server.children
        assert children
        for each in (server.process.pid, *children):
            assert secret not in Path(f"/proc/{each}/cmdline").read_bytes()
            assert secret not in Path(f"/proc/{each}/environ").read_bytes()


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.parametrize("way", ["closed", "cut", "server killed"])
@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_the_text_of_a_page_that_is_gone_is_offered_at_the_next_start(tmp_path, way):
    server = Server(tmp_path)
    try:
        async with server.page() as terminal:
            shown = Shown()
            await until_shown(terminal, shown, FIRST_WORDS)
            await terminal.send_json(["focus"])
            await terminal.send_json(["stdin", PROGRAM])
            await until_shown(terminal, shown, PROGRAM)
            children = server.children
            if way == "cut":
                terminal._response.connection.transport.abort()
            elif way == "server killed":
                server.process.kill()
        await until(lambda: not any(Path(f"/proc/{each}/exe").exists() for each in children))
        assert server.copies == [f"{PROGRAM}\n"]
    finally:
        server.end()
    again = Server(tmp_path)
    try:
        async with again.page() as terminal:
            await until_shown(terminal, Shown(), "A program was kept.")
    finally:
        again.end()


@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_the_text_of_a_page_that_was_left_alone_is_offered_at_the_next_start(tmp_path, monkeypatch):
    """The time without a key is long enough for a machine of any speed to show what was typed."""
    from donnie_tui.cli.page_server import PageServer
    from donnie_tui.cli.page_session import IDLE_CODE, PageLimits
    from donnie_tui.i18n.words import Words

    for name, value in environment(tmp_path).items():
        monkeypatch.setenv(name, value)
    command, idle, codes, written = [*COMMAND, "--visual", *QUIET], 1.0, list[int](), False
    while not written:
        idle *= 2
        server = PageServer(command, Words("en"), print, PageLimits(idle=idle), port=free_port())
        await server.start()
        origin = f"http://localhost:{server.port}"
        async with aiohttp.ClientSession() as session:
            await session.get(server.gate.link)
            async with session.ws_connect(f"{origin}/ws", headers={"Origin": origin}) as terminal:
                shown, is_typed = Shown(), False
                async for message in terminal:
                    shown.feed(message.data)
                    if shown.has(FIRST_WORDS) and not is_typed:
                        is_typed = True
                        await terminal.send_json(["focus"])
                        await terminal.send_json(["stdin", PROGRAM])
                    written = written or shown.has(PROGRAM)
                codes.append(terminal.close_code)
        await server.close()
    assert set(codes) == {IDLE_CODE}
    assert [each.read_text() for each in tmp_path.rglob("unsaved-*.gd")] == [f"{PROGRAM}\n"]


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux confines")
@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_a_page_of_a_confined_server_stays_in_the_folder(tmp_path):
    """The server leaves the folder in which the name was given; its pages begin where it is then."""
    folder = tmp_path / "pupil"
    folder.mkdir()
    server = Server(tmp_path, "--confined", os.path.relpath(folder, ROOT))
    try:
        async with server.page() as terminal:
            shown = Shown()
            await until_shown(terminal, shown, FIRST_WORDS)
            await terminal.send_json(["focus"])
            await terminal.send_json(["stdin", CTRL_O])
            await until_shown(terminal, shown, "Enter takes it")
            await terminal.send_json(["stdin", "/etc/passwd\r"])
            await until_shown(terminal, shown, "/etc/passwd is not in your folder.")
    finally:
        server.end()


async def test_listening_for_other_computers_says_what_that_means(tmp_path):
    server = Server(tmp_path, "--listen", "0.0.0.0")
    server.end()
    assert server.printed[0] == (
        "Every computer that reaches this address and has the link can work as you: read and write your"
        " files, and drive your robot. The connection is not encrypted: the network can read the link and"
        " all that is typed.\n"
    )


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_a_page_that_is_cut_stops_its_robot(tmp_path):
    file = tmp_path / "events"

    def events() -> str:
        return file.read_text() if file.exists() else ""

    server = Server(tmp_path, "--events", str(file), "--speed", "1", "--sessions", "1")
    try:
        async with server.page() as terminal:
            shown = Shown()
            await until_shown(terminal, shown, FIRST_WORDS)
            await terminal.send_json(["focus"])
            await terminal.send_json(["stdin", "REPEAT 1000 TIMES TR 1 END REPEAT\x1b[15~"])
            await until(lambda: '"turned"' in events())
            children = server.children
            terminal._response.connection.transport.abort()
        await until(lambda: not any(Path(f"/proc/{each}/exe").exists() for each in children))
        last = json.loads(events().splitlines()[-1])
        assert (last["event"], last["outcome"]) == ("run_ended", "stopped")
    finally:
        server.end()


@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_a_page_does_not_offer_what_needs_a_terminal(server):
    async with server.page("width=100&height=40") as terminal:
        shown = Shown()
        await until_shown(terminal, shown, "Screen reader? In a terminal: donnie --linear")
        await terminal.send_json(["focus"])
        await terminal.send_json(["stdin", "LINEAR\r"])
        await until_shown(terminal, shown, "In a terminal only: donnie --linear")
        await terminal.send_json(["stdin", CTRL_K])
        await until_shown(terminal, shown, "WHOLE MAP")
        assert not shown.has("OPEN LOG:")
        await terminal.send_json(["stdin", "q"])
        await until_shown(terminal, shown, "Ctrl+K q does nothing.")


@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_a_page_stays_on_the_way_to_another_world(server):
    async with server.page("width=100&height=40") as terminal:
        shown = Shown()
        await until_shown(terminal, shown, FIRST_WORDS)
        await terminal.send_json(["focus"])
        await terminal.send_json(["stdin", CTRL_K])
        await until_shown(terminal, shown, "WHOLE MAP")
        await terminal.send_json(["stdin", "o"])
        await until_shown(terminal, shown, "Up and Down choose")
        await terminal.send_json(["stdin", "maze\r"])
        await until_shown(terminal, shown, "This is the world maze")
        while not shown.has("I do not know fwq"):  # a key may be lost on the way
            await terminal.send_json(["stdin", "fwq"])
            with suppress(TimeoutError):
                async with asyncio.timeout(AGAIN):
                    await until_shown(terminal, shown, "I do not know fwq")


@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_leaving_ends_the_page_and_prints_no_traceback(server):
    async with server.page() as terminal:
        await until_shown(terminal, Shown(), FIRST_WORDS)
        await terminal.send_json(["focus"])
        await terminal.send_json(["stdin", CTRL_Q])
        while (message := await terminal.receive(timeout=TIMEOUT)).type is not aiohttp.WSMsgType.CLOSE:
            assert message.type is aiohttp.WSMsgType.BINARY
        assert (message.data, message.extra) == (1000, "")
