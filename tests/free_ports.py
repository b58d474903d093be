"""Ports of this machine for servers of tests."""

import socket

_HELD: list[socket.socket] = []


def free_port() -> int:
    """A port that only a server of this test can have, as long as this process lives.

    It is bound here and nothing listens. A server that sets ``SO_REUSEADDR``, as those of asyncio do, can
    bind it too; no other process is given it, which happened on a busy machine.
    """
    has_both = socket.has_dualstack_ipv6()
    held = socket.socket(socket.AF_INET6 if has_both else socket.AF_INET)
    if has_both:
        held.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, 0)
    held.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    held.bind(("", 0))
    _HELD.append(held)
    return int(held.getsockname()[1])
