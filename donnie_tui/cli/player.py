"""``donnie player FILE.cfg``: clients of the Player robot server drive simulated robots."""

from __future__ import annotations

import asyncio
from contextlib import suppress
from ipaddress import ip_address
from pathlib import Path

from donnie_tui import __version__
from donnie_tui.cli.front_end import PORTS, number_in
from donnie_tui.cli.options import ExitCode, Order
from donnie_tui.cli.streams import on_signals
from donnie_tui.i18n.words import Unusable
from donnie_tui.player.server import PlayerServer, PortRefused
from donnie_tui.player.stations import BadConfiguration, Stations
from donnie_tui.process import loaded
from donnie_tui.world.loading import configuration_of


def serve_clients(order: Order) -> int:
    """Until a signal ends it. Raises ``Unusable``."""
    from sim.velocity import VelocityLoop
    from sim.world import World

    words, arguments, output = order.words, order.invocation.arguments, order.output
    port = number_in(words, "serve-bad-port", arguments.port, PORTS)
    found = configuration_of(Path(arguments.file), words, order.settings.include_folders)
    if found.scene is None:
        raise Unusable(words("player-real-only", path=arguments.file))

    def say(name: str, text: str) -> None:
        output.line(words("player-said", name=name, text=text))

    try:
        loop = VelocityLoop(World(found.scene, seed=order.settings.seed))
        stations = Stations(found, loop, port, say)
    except BadConfiguration as bad:
        raise Unusable(words(bad.code, what=bad.what)) from None
    if not stations.by_port:
        raise Unusable(words("player-nothing", path=arguments.file))
    if stations.left_out:
        output.complaint(words("player-left-out", names=", ".join(stations.left_out[:10])))
    server = PlayerServer(stations, arguments.host, __version__, lambda code: output.complaint(words(code)))

    def announce() -> None:
        loaded()
        if not _is_loopback(arguments.host):
            output.line(words("player-open-to-others"))
        ports = ", ".join(map(str, stations.by_port))
        output.line(words("player-serving", host=arguments.host, ports=ports))

    async def serve() -> None:
        running = asyncio.current_task()
        asyncio_loop = asyncio.get_running_loop()
        assert running is not None

        def end() -> None:
            asyncio_loop.call_soon_threadsafe(running.cancel)

        with on_signals(end):
            await server.run(order.settings.speed, announce)

    try:
        with suppress(asyncio.CancelledError):
            asyncio.run(serve())
    except PortRefused as problem:
        raise Unusable(words("player-failed", port=problem.port, reason=problem.reason)) from None
    return ExitCode.DONE


def _is_loopback(host: str) -> bool:
    try:
        return ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"
