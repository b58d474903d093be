"""``donnie serve``: a page on this machine alone, and the full screen behind it."""

import asyncio
import base64
import os
import shutil
import socket
import subprocess
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pyte
import pytest

from tests.sessions.command import COMMAND, QUIET
from tests.timeouts import TIMEOUT

aiohttp = pytest.importorskip("aiohttp")
pytest.importorskip("textual_serve")

pytestmark = pytest.mark.slow

FIRST_WORDS = "F5 runs the program."

ROOT = Path(__file__).resolve().parents[2]


def free_port() -> int:
    with socket.socket() as found:
        found.bind(("localhost", 0))
        return found.getsockname()[1]


@pytest.fixture
def server(tmp_path):
    """The port of one that serves."""
    port = free_port()
    process = subprocess.Popen(
        [*COMMAND, "serve", "--port", str(port), *QUIET, "--lang", "en"],
        cwd=ROOT,
        env=os.environ | {"HOME": str(tmp_path), "DONNIE_TOUR": "off"},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    end = time.monotonic() + TIMEOUT
    while socket.socket().connect_ex(("localhost", port)):
        assert time.monotonic() < end and process.poll() is None, "it does not listen"
        time.sleep(0.05)
    yield port
    process.terminate()
    process.wait(TIMEOUT)


@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_a_page_shows_the_full_screen(server):
    address = f"http://localhost:{server}"
    async with aiohttp.ClientSession() as session:
        async with session.get(address) as page:
            assert page.status == 200
            assert "Donnie" in await page.text()
        async with session.ws_connect(f"{address}/ws?width=80&height=24") as terminal:
            await until_shown(terminal, Shown(), FIRST_WORDS)


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
            f"http://localhost:{server}/",
        ],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )  # fmt: skip
    yield f"http://localhost:{port}/json"
    process.terminate()
    process.wait(TIMEOUT)


class Page:
    """A page under a debugger: keys go in; what the server sends to it is written down."""

    def __init__(self, socket: Any) -> None:
        self._socket = socket
        self._calls = 0
        self._shown = Shown()

    async def call(self, method: str, **values: Any) -> dict[str, Any]:
        self._calls += 1
        await self._socket.send_json({"id": self._calls, "method": method, "params": values})
        while True:
            reply = await self._socket.receive_json(timeout=TIMEOUT)
            self._note(reply)
            if reply.get("id") == self._calls:
                return reply.get("result", {})

    def _note(self, reply: dict[str, Any]) -> None:
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

    async def value(self, expression: str) -> Any:
        return (await self.call("Runtime.evaluate", expression=expression))["result"].get("value")

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
            yield Page(socket)


@pytest.mark.skipif(CHROMIUM is None, reason="needs chromium")
@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_a_browser_shows_the_main_screen_and_tab_gives_it_the_keyboard(browser):
    async with page_of(browser) as page:
        await page.call("Network.enable")
        await page.call("Page.reload")
        await page.gets(FIRST_WORDS)
        while await page.value("document.activeElement.tagName") != "TEXTAREA":
            await page.press("Tab", 9)
        assert await page.value("document.querySelectorAll('.xterm-text-layer').length") == 1


@pytest.mark.skipif(CHROMIUM is None, reason="needs chromium")
@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_letters_typed_in_a_browser_are_read_and_answered(browser):
    """A page begins without the focus: once it has it, the program has it too."""
    async with page_of(browser) as page:
        await page.call("Network.enable")
        await page.call("Emulation.setFocusEmulationEnabled", enabled=True)
        await page.call("Page.reload")
        await page.gets(FIRST_WORDS)
        while await page.value("document.querySelector('.xterm-helper-textarea') === null"):
            pass
        await page.type("fwq")
        await page.gets("I do not know fwq.")


@pytest.mark.filterwarnings("ignore::ResourceWarning")
async def test_a_page_that_begins_without_the_focus_takes_letters(server):
    async with (
        aiohttp.ClientSession() as session,
        session.ws_connect(f"http://localhost:{server}/ws?width=80&height=24") as terminal,
    ):
        shown = Shown()
        await until_shown(terminal, shown, FIRST_WORDS)
        for message in (["focus"], ["stdin", "fwq"]):
            await terminal.send_json(message)
        await until_shown(terminal, shown, "I do not know fwq.")
