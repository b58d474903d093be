"""A page of ``donnie serve``: passes its keys to a process, and the process's output to the page.

The process is a full screen with Textual's driver for pages. Both ends are bounded: a page that takes no
output stops its robot and then counts as gone, and a process that takes no input is ended.
"""

from __future__ import annotations

import asyncio
import json
import os
import signal
from asyncio.subprocess import PIPE, Process
from collections.abc import Callable, Sequence
from contextlib import suppress

import msgspec
from aiohttp import WSCloseCode, WSMsgType, web
from msgspec import Struct
from textual_serve.app_service import AppService
from textual_serve.download_manager import DownloadManager

from donnie_tui.core.wording import Wording

LONGEST_REASON = 123
"""Bytes of the reason with which a WebSocket is closed."""
_LONGEST_PING = 60
IDLE_CODE, FAILED_CODE = 4000, 4001
"""Donnie's own codes for the closing of a WebSocket."""


_BEGINNING = b"__GANGLION__\n"
"""The line that Textual's driver writes before its first packet."""


class PageLimits(Struct, frozen=True):
    """The limits of pages. Times are in seconds."""

    sessions: int = 8
    idle: float = 3600
    """A page ends after so long without a key; 0 is never."""
    frame: int = 2**20
    """Bytes of one message from a page."""
    connections: int = 100
    """Open at once, with the refused ones."""
    first_request: float = 10
    """The time for a new connection to show the cookie or the link."""
    heartbeat: float = 10
    """The time between two pings; a page has half of it to answer."""
    stalled: float = 2.5
    """The robot stops after a page has taken no output for so long."""
    lost: float = 20
    """The page counts as gone after so long more."""
    late: float = 2
    """The time for a process to take the keys of a page that is gone."""
    end: float = 5
    """The time for a process to end before it is killed."""


class PageSession(AppService):
    """The process of a page, from ``start`` to ``end``."""

    def __init__(
        self,
        command: Sequence[str],
        page: web.WebSocketResponse,
        words: Wording,
        limits: PageLimits,
        abort: Callable[[], object],
    ) -> None:
        """``abort`` cuts the connection to the page."""
        super().__init__(
            "",
            write_bytes=page.send_bytes,
            write_str=page.send_str,
            close=page.close,  # type: ignore[arg-type] # what it returns is not asked for
            download_manager=DownloadManager(),
        )
        self._arguments, self._page, self._words, self._limits = command, page, words, limits
        self._abort = abort
        self.is_ending = False
        self._is_listening = False
        """Whether the process's driver reads; not before its start, nor between two worlds."""
        self._held: list[bytes] = []
        """Packets for the next driver."""
        self._all_passed = asyncio.Event()
        """Set while no key is held."""
        self._all_passed.set()
        self._size = (80, 24)
        self._has_focus = False
        self._has_painted = False
        self._complaint = b""
        """The last lines of the process's standard error."""
        self._last_key = 0.0

    # --- from the beginning to the end

    async def start(self, width: int, height: int) -> None:
        """Start the process in its own group, out of reach of the server's Ctrl+C. Raises ``OSError``."""
        self._size = width, height
        self._process = await asyncio.create_subprocess_exec(
            *self._arguments,
            stdin=PIPE,
            stdout=PIPE,
            stderr=PIPE,
            env=self._build_environment(width, height),
            start_new_session=True,
        )
        self._stdin = self._process.stdin
        self._task = asyncio.create_task(self.run())

    async def talk(self) -> None:
        """Pass on the page's messages until it is gone or was closed."""
        self._last_key = asyncio.get_running_loop().time()
        idle = asyncio.create_task(self._close_when_idle())
        try:
            async for message in self._page:
                if message.type is WSMsgType.ERROR:
                    return
                if message.type is WSMsgType.TEXT:
                    await self._take(message.data)
        finally:
            idle.cancel()

    async def end(self) -> None:
        """Hang up the process of a page that is gone, so that its robot stops and its text is kept."""
        process, task = self._process, self._task
        self.is_ending = True
        if process is None or task is None:
            return
        if process.returncode is None:
            with suppress(TimeoutError):  # what was typed before the driver began is text to keep, too
                await asyncio.wait_for(self._all_passed.wait(), self._limits.late)
        self._hang_up()
        try:
            await asyncio.wait_for(process.wait(), self._limits.end)
        except TimeoutError:
            _kill_group(process)
            await process.wait()
        await asyncio.wait({task}, timeout=self._limits.end)
        task.cancel()

    def _hang_up(self) -> None:
        _send(self._process, signal.SIGHUP if hasattr(signal, "SIGHUP") else signal.SIGTERM)

    def _lose(self) -> None:
        """Give up a page that takes no output, and release everything that waits for it."""
        self.is_ending = True
        self._abort()
        self._hang_up()

    async def _close_when_idle(self) -> None:
        loop, idle = asyncio.get_running_loop(), self._limits.idle
        if not idle:
            return
        while (rest := self._last_key + idle - loop.time()) > 0:
            await asyncio.sleep(rest)
        await self.close(IDLE_CODE, self._words("serve-idle", minutes=max(1, round(idle / 60))))

    async def close(self, code: int, sentence: str) -> None:
        """Close the page, which shows the sentence."""
        await self._page.close(code=code, message=as_reason(sentence))

    # --- from the page

    async def _take(self, data: str) -> None:
        """Handle a message of the page; ignores an invalid one."""
        try:
            message = _MESSAGES.decode(data)
        except msgspec.DecodeError:
            return
        match message:
            case ["stdin", str(typed)]:
                self._last_key = asyncio.get_running_loop().time()
                await self._pass_on(b"D", typed.encode())  # the decoder refuses half a character
            case ["resize", _Size(width=width, height=height)]:
                self._size = size_of(width, height)
                await self._report_size()
            case ["focus" | "blur" as kind]:
                self._has_focus = kind == "focus"
                await self._report(type=kind)
            case ["ping", str(sent)] if len(sent) < _LONGEST_PING:
                with suppress(ConnectionError, RuntimeError):
                    await self._page.send_json(["pong", sent])

    async def _report_size(self) -> None:
        width, height = self._size
        await self._report(type="resize", width=width, height=height)

    async def _report(self, **values: object) -> None:
        await self._pass_on(b"M", json.dumps(values).encode())

    async def _pass_on(self, kind: bytes, payload: bytes) -> None:
        """Send a packet to the process. If it takes none for long, the page is closed."""
        packet = self.encode_packet(kind, payload)  # type: ignore[arg-type] # D or M
        if not self._is_listening:
            if sum(map(len, self._held)) < self._limits.frame:
                self._held.append(packet)
                if kind == b"D":
                    self._all_passed.clear()
            return
        with suppress(ConnectionError, RuntimeError):
            self.stdin.write(packet)
            try:
                await asyncio.wait_for(self.stdin.drain(), self._limits.lost)
            except TimeoutError:
                self._lose()

    # --- from the process

    async def run(self) -> None:
        """Pass on the output of the process to its end, then close the page."""
        process = self._process
        assert process is not None and process.stdout is not None and process.stderr is not None
        complaints = asyncio.create_task(self._read_complaints(process.stderr))
        with suppress(asyncio.IncompleteReadError, ConnectionError, ValueError):
            await self._read_packets(process.stdout)
        code = await process.wait()
        await asyncio.wait({complaints}, timeout=self._limits.end)
        complaints.cancel()
        if not self.is_ending:
            self.is_ending = True
            has_failed = code and not self._has_painted
            await self.close(FAILED_CODE if has_failed else WSCloseCode.OK, self._last_line if code else "")

    async def _read_packets(self, output: asyncio.StreamReader) -> None:
        """Read the packets of each world's driver, which begins with a line and may paint after its end."""
        while await output.readline() != _BEGINNING:
            if output.at_eof():
                return
        await self._begin()
        while kind := await output.read(1):
            if kind == _BEGINNING[:1]:
                await output.readline()
                await self._begin()
                continue
            payload = await output.readexactly(int.from_bytes(await output.readexactly(4), "big"))
            if kind == b"D":
                await self.on_data(payload)
            elif kind == b"M" and json.loads(payload).get("type") == "exit":
                self._is_listening = False

    async def _begin(self) -> None:
        """Send the current size and the focus to a driver that has begun to listen."""
        self._is_listening = True
        held, self._held = self._held, []
        if self._has_painted:
            await self._report_size()
        if self._has_focus:
            await self._report(type="focus")
        for packet in held:
            self.stdin.write(packet)
        self._all_passed.set()

    async def on_data(self, payload: bytes) -> None:
        """Send output to the page. If the page takes none for long, the robot stops."""
        self._has_painted = True
        if self.is_ending:
            return
        sending = asyncio.ensure_future(self._page.send_bytes(payload))
        done, _ = await asyncio.wait({sending}, timeout=self._limits.stalled)
        if not done:
            _send(self._process, signal.SIGINT)
            done, _ = await asyncio.wait({sending}, timeout=self._limits.lost)
        if not done:
            sending.cancel()
            self._lose()
        else:
            with suppress(ConnectionError, RuntimeError):
                sending.result()

    async def _read_complaints(self, errors: asyncio.StreamReader) -> None:
        while data := await errors.read(4096):
            self._complaint = (self._complaint + data)[-4096:]

    @property
    def _last_line(self) -> str:
        return self._complaint.decode(errors="replace").strip().rpartition("\n")[2]


class _Size(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    width: int
    height: int


_MESSAGES = msgspec.json.Decoder(list[str | _Size])
"""Messages have flat types only, since the decoder recurses into nested ones."""


def size_of(width: int, height: int) -> tuple[int, int]:
    """A size within the limits of a screen."""
    return min(max(width, 20), 500), min(max(height, 6), 200)


def as_reason(sentence: str) -> bytes:
    """The reason cut to the size that a WebSocket takes, in whole characters."""
    return sentence.encode(errors="replace")[:LONGEST_REASON].decode(errors="ignore").encode()


def _send(process: Process | None, number: int) -> None:
    """Signals a process by its id: ``send_signal`` would collect one that has ended before asyncio does."""
    if process is not None and process.returncode is None:
        with suppress(ProcessLookupError):
            os.kill(process.pid, number)


def _kill_group(process: Process) -> None:
    """Kills a process and all that it has started."""
    with suppress(ProcessLookupError):
        if hasattr(signal, "SIGKILL"):
            os.killpg(process.pid, signal.SIGKILL)
        else:
            process.kill()
