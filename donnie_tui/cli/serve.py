"""``donnie serve``: the full screen in a browser on this machine, one Donnie for each page.

There is no login, so it listens on localhost only. It needs textual-serve, an optional extra.
"""

from __future__ import annotations

import shlex
import sys
from importlib.util import find_spec

from donnie_tui.cli import codes
from donnie_tui.cli.options import Order
from donnie_tui.i18n.words import Unusable

HOST = "localhost"
LOWEST_PORT, HIGHEST_PORT = 1, 65535


def serve(order: Order) -> int:
    """Serve until it is stopped. Raises ``Unusable`` without textual-serve, or for an invalid port."""
    words = order.words
    if find_spec("textual_serve") is None:
        raise Unusable(words("serve-missing"))
    port = order.invocation.arguments.port
    if not port.isdecimal() or not LOWEST_PORT <= int(port[:6]) <= HIGHEST_PORT:
        raise Unusable(words("serve-bad-port", port=port[:20]))
    from textual_serve.server import Server

    order.output.line(words("serve-address", host=HOST, port=port))
    try:
        Server(command(order.invocation.options), host=HOST, port=int(port), title="Donnie").serve()
    except OSError as problem:
        raise Unusable(words("serve-failed", port=port, reason=problem.strerror or str(problem))) from None
    return codes.DONE


def command(options: dict[str, str]) -> str:
    """What is run for each page: the full screen with the same options."""
    given = [part for key, value in options.items() for part in (f"--{key}", value)]
    return shlex.join([sys.executable, "-m", "donnie_tui", "--visual", *given])
