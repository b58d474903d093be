"""The server of ``donnie serve``: pages in a browser, each with a full screen in a process of its own.

A page can do what its learner can: write files and drive the robot. So only the holder of the link gets in.
The link has a secret, which the browser exchanges for a cookie. Without the cookie, from another host or from
another page's origin every request is refused. The size of messages is bounded. When a page is gone, its
robot stops, its text is kept and its process ends.
"""

from __future__ import annotations

import asyncio
import html
import logging
import secrets
import socket
from collections.abc import Awaitable, Callable, Sequence
from contextlib import suppress
from errno import EADDRNOTAVAIL, EAFNOSUPPORT
from functools import cache
from importlib.util import find_spec
from ipaddress import ip_address
from pathlib import Path
from string import Template
from traceback import extract_tb

from aiohttp import WSCloseCode, web

from donnie_tui.cli.page_session import FAILED_CODE, PageLimits, PageSession, as_reason, size_of
from donnie_tui.cli.streams import on_signals
from donnie_tui.core.wording import Wording
from donnie_tui.settings.parsing import is_loopback

LOCALHOST = "localhost"
_LOOPBACKS = ("127.0.0.1", "::1")

_SECRET_SIZE = 16
"""Bytes: 128 bits."""
_HTTP = 80

_PAGE = Path(__file__).parent / "page"
_LONGEST_QUOTE = 60


# --- who may come in


class Gate:
    """Checks requests against the secret, the cookie, the hosts and the origins."""

    def __init__(self, address: str, port: int) -> None:
        self._address, self._port = address, port
        self.secret = secrets.token_urlsafe(_SECRET_SIZE)
        self.cookie_name = f"donnie-{port}"
        """The cookie's name has the port, as all ports of a host share their cookies."""
        self.cookie = secrets.token_urlsafe(_SECRET_SIZE)

    @property
    def link(self) -> str:
        name = self._address
        with suppress(ValueError):
            address = ip_address(name)
            name = socket.gethostname() if address.is_unspecified else _in_host(name)
        return f"http://{name}{self._suffixes[0]}/start/{self.secret}"

    @property
    def _suffixes(self) -> tuple[str, ...]:
        with_port = f":{self._port}"
        return ("", with_port) if self._port == _HTTP else (with_port,)

    def objection(self, request: web.BaseRequest) -> tuple[str, str] | None:
        """The reason to refuse a request: the code of a sentence and its subject. None if it is accepted."""
        host = _only(request, "Host")
        if host.lower() not in self._hosts(request):
            return "serve-refused-host", host
        origin = _only(request, "Origin")
        is_socket = request.headers.get("Upgrade") is not None
        if (is_socket or "Origin" in request.headers) and origin.lower() != f"http://{host.lower()}":
            return ("serve-refused-origin", origin) if origin else ("serve-refused-no-origin", "")
        kind, _, rest = request.path.removeprefix("/").partition("/")
        if kind == "start":
            return None if _is_same(rest, self.secret) else ("serve-refused-link", "")
        if request.headers.get("Sec-Fetch-Site", "none") not in ("none", "same-origin"):
            return "serve-refused-site", ""
        cookie = request.cookies.get(self.cookie_name)
        if cookie is None:
            return "serve-refused-no-cookie", ""
        return None if _is_same(cookie, self.cookie) else ("serve-refused-cookie", "")

    def _hosts(self, request: web.BaseRequest) -> frozenset[str]:
        """The hosts under which the socket of this request may be reached.

        Other names are refused, since anyone can buy a name that points here.
        """
        ours = str((request.get_extra_info("sockname") or ("",))[0])
        names = {_in_host(ours), LOCALHOST} if is_loopback(ours) else {_in_host(ours), *_names_of_machine()}
        if not _is_unspecified(self._address):
            names.add(_in_host(self._address).lower())
        return frozenset(f"{name}{suffix}" for name in names for suffix in self._suffixes)


def _only(request: web.BaseRequest, name: str) -> str:
    """The value of a header; empty if there are none or several."""
    values = request.headers.getall(name, [])
    return values[0] if len(values) == 1 else ""


def _is_same(given: str, secret: str) -> bool:
    """Compares in constant time."""
    return secrets.compare_digest(given.encode(errors="replace"), secret.encode())


def _in_host(address: str) -> str:
    return f"[{address}]" if ":" in address else address


def _is_unspecified(address: str) -> bool:
    try:
        return ip_address(address).is_unspecified
    except ValueError:
        return False


@cache
def _names_of_machine() -> tuple[str, ...]:
    name = socket.gethostname().lower()
    return name, f"{name}.local"


# --- all pages


async def serve_until_signal(server: PageServer, on_start: Callable[[], object]) -> None:
    """Serve until a signal comes. ``on_start`` is called once it listens. Raises ``OSError``.

    If a signal finds the server hanging, the process ends all the same, and each page's session with it.
    """
    signalled, loop = asyncio.Event(), asyncio.get_running_loop()

    def note_signal() -> None:
        loop.call_soon_threadsafe(signalled.set)

    with on_signals(note_signal):
        await server.start()
        try:
            on_start()
            await signalled.wait()
        finally:
            await server.close()


class PageServer:
    """Serves pages from ``start`` to ``close``."""

    def __init__(
        self,
        command: Sequence[str],
        words: Wording,
        log: Callable[[str], object],
        limits: PageLimits,
        *,
        address: str = LOCALHOST,
        port: int,
    ) -> None:
        """``command`` is run for each page; ``log`` takes a sentence for each refusal."""
        self._command, self._words, self._log, self._limits = command, words, log, limits
        self._address, self.port = address, port
        self.gate = Gate(address, port)
        self._sessions: set[PageSession] = set()
        self._ended = asyncio.Condition()
        """Notified when a session has ended."""
        self._unproven: set[asyncio.BaseProtocol] = set()
        """Connections without an accepted request so far."""
        self._listeners: list[asyncio.Server] = []

    @property
    def is_open_to_others(self) -> bool:
        """Whether it listens on more than this machine."""
        sockets = (each.getsockname()[0] for listener in self._listeners for each in listener.sockets)
        return not all(map(is_loopback, sockets))

    async def start(self) -> None:
        """Raises ``OSError``."""
        application = web.Application(middlewares=[self._guard])
        application.router.add_get("/start/{secret}", self._give_cookie)
        application.router.add_get("/", self._show_page)
        application.router.add_get("/ws", self._serve_page)
        application.router.add_static("/static", _statics())
        application.router.add_static("/page", _PAGE)
        application.on_response_prepare.append(_add_policies)
        self._runner = web.AppRunner(
            application, access_log=None, handle_signals=False, logger=_logger(self._report_fault)
        )
        await self._runner.setup()
        try:
            for each in _LOOPBACKS if self._address == LOCALHOST else (self._address,):
                await self._listen(each)
        except OSError:
            await self.close()
            raise

    async def _listen(self, address: str) -> None:
        """Listen at an address; a machine may have only one version of the protocol."""
        try:
            server = await asyncio.get_running_loop().create_server(self._connect, address, self.port)
        except OSError as problem:
            if self._listeners and problem.errno in (EADDRNOTAVAIL, EAFNOSUPPORT):
                return
            raise
        self._listeners.append(server)

    async def close(self) -> None:
        """End all sessions; each keeps its text."""
        for each in self._listeners:
            each.close()
        sessions = [*self._sessions]
        closing = (each.close(WSCloseCode.GOING_AWAY, self._words("serve-ended")) for each in sessions)
        await asyncio.gather(*closing, *(each.end() for each in sessions), return_exceptions=True)
        await self._runner.cleanup()

    # --- connections

    def _connect(self) -> asyncio.BaseProtocol:
        server = self._runner.server
        assert server is not None
        if len(server.connections) >= self._limits.connections:
            return _Refusal()
        connection = server()
        self._unproven.add(connection)
        asyncio.get_running_loop().call_later(self._limits.first_request, self._drop, connection)
        return connection

    def _drop(self, connection: web.RequestHandler) -> None:
        if connection in self._unproven:
            self._unproven.discard(connection)
            connection.force_close()

    def _report_fault(self) -> None:
        self._log(self._words("serve-fault"))

    # --- requests

    @web.middleware
    async def _guard(
        self, request: web.Request, handler: Callable[[web.Request], Awaitable[web.StreamResponse]]
    ) -> web.StreamResponse:
        objection = self.gate.objection(request)
        if objection is None:
            self._unproven.discard(request.protocol)
            return await handler(request)
        code, about = objection
        address = str(request.remote)
        self._log(self._words(code, address=address, about=about[:_LONGEST_QUOTE]))
        response = self._note("serve-forbidden", status=web.HTTPForbidden.status_code)
        response.force_close()
        return response

    def _note(self, code: str, *, status: int = 200, refresh: str = "") -> web.Response:
        """A page with a sentence."""
        text = _template("note.html").substitute(
            language=self._words.language, refresh=refresh, sentence=html.escape(self._words(code))
        )
        return web.Response(status=status, text=text, content_type="text/html")

    async def _give_cookie(self, _: web.Request) -> web.Response:
        """Set the cookie, and let this page load the next one: a foreign page's link sends no cookie."""
        response = self._note("serve-starting", refresh='<meta http-equiv="refresh" content="0; url=/" />')
        name, cookie = self.gate.cookie_name, self.gate.cookie
        response.set_cookie(name, cookie, httponly=True, samesite="Strict", path="/")
        return response

    async def _show_page(self, request: web.Request) -> web.Response:
        nonce, words = secrets.token_urlsafe(_SECRET_SIZE), self._words
        sentences = {
            "starting": "serve-starting",
            "ended": "serve-page-ended",
            "large": "serve-large",
            "again": "serve-again",
        }
        host = html.escape(request.host)
        text = _template("page.html").substitute(
            {name: html.escape(words(code)) for name, code in sentences.items()},
            language=words.language,
            nonce=nonce,
            socket=f"ws://{host}/ws",
            font_size=min(max(_number(request, "fontsize", 16), 6), 72),
        )
        response = web.Response(text=text, content_type="text/html")
        response.headers["Content-Security-Policy"] = (
            f"{_POLICY}; script-src 'self'; style-src 'self' 'nonce-{nonce}'; font-src 'self'; "
            f"connect-src 'self' ws://{request.host}"
        )
        return response

    async def _serve_page(self, request: web.Request) -> web.StreamResponse:
        limits = self._limits
        page = web.WebSocketResponse(
            heartbeat=limits.heartbeat, max_msg_size=limits.frame, compress=False, timeout=limits.stalled
        )
        try:
            is_socket = bool(page.can_prepare(request))
        except ValueError:  # a header has non-ASCII characters
            is_socket = False
        if not is_socket:
            return web.Response(status=web.HTTPBadRequest.status_code)
        await page.prepare(request)
        if not await self._has_room():
            full = self._words("serve-full", pages=limits.sessions)
            self._log(full)
            await page.close(code=WSCloseCode.TRY_AGAIN_LATER, message=as_reason(full))
            return page
        transport = request.transport
        if transport is None:  # the page is gone
            return page
        _bound_output(transport)
        session = PageSession(self._command, page, self._words, limits, transport.abort)
        self._sessions.add(session)
        try:
            await session.start(*size_of(_number(request, "width", 80), _number(request, "height", 24)))
            await session.talk()
        except OSError as problem:
            await session.close(FAILED_CODE, problem.strerror or str(problem))
        finally:
            await asyncio.shield(self._end(session))
        return page

    async def _has_room(self) -> bool:
        """Whether another session may begin; waits a little for one that is just ending."""

        def is_clear() -> bool:
            is_full = len(self._sessions) >= self._limits.sessions
            return not is_full or not any(each.is_ending for each in self._sessions)

        with suppress(TimeoutError):
            async with asyncio.timeout(self._limits.lost), self._ended:
                await self._ended.wait_for(is_clear)
        return len(self._sessions) < self._limits.sessions

    async def _end(self, session: PageSession) -> None:
        await session.end()
        self._sessions.discard(session)
        async with self._ended:
            self._ended.notify_all()


_POLICY = "default-src 'none'; img-src data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
_POLICIES = {
    "Content-Security-Policy": _POLICY,
    "Cache-Control": "no-store",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
}


async def _add_policies(_: web.Request, response: web.StreamResponse) -> None:
    for name, value in _POLICIES.items():
        response.headers.setdefault(name, value)
    response.headers.pop("Server", None)


def _bound_output(transport: asyncio.Transport) -> None:
    """Limit the system's buffer, which would keep megabytes of old output for a slow page."""
    opened = transport.get_extra_info("socket")
    if opened is not None:
        opened.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, _OUTPUT)


_OUTPUT = 65536
"""Bytes of output that the system buffers for a page."""


def _number(request: web.Request, name: str, otherwise: int) -> int:
    try:
        return int(request.query.get(name, "")[:9])
    except ValueError:
        return otherwise


def _template(name: str) -> Template:
    return Template((_PAGE / name).read_text(encoding="utf-8"))


def _statics() -> Path:
    """The folder of textual-serve's terminal for the browser."""
    spec = find_spec("textual_serve")
    assert spec is not None and spec.origin is not None
    return Path(spec.origin).parent / "static"


class _Refusal(asyncio.Protocol):
    """Ends a connection at once."""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        if isinstance(transport, asyncio.Transport):
            transport.abort()


class _Faults(logging.Handler):
    """Logs a sentence for each fault of aiohttp, instead of a traceback; none if only the page is gone."""

    def __init__(self, report: Callable[[], object]) -> None:
        super().__init__(logging.WARNING)
        self._report = report

    def emit(self, record: logging.LogRecord) -> None:
        problem = record.exc_info[1] if record.exc_info else None
        if problem is None or not _is_of_closed_page(problem):
            self._report()


def _is_of_closed_page(problem: BaseException) -> bool:
    """Whether a page was closed before its answer came; sending a file fails in several ways then."""
    is_sending = "_sendfile" in (each.name for each in extract_tb(problem.__traceback__))
    return isinstance(problem, ConnectionError) or is_sending


def _logger(report: Callable[[], object]) -> logging.Logger:
    logger = logging.Logger("donnie.pages")  # known to no other part of the program
    logger.addHandler(_Faults(report))
    return logger
