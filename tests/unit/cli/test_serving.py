"""``donnie player`` and ``donnie serve``: what is checked before they begin, what they say, how they end."""

from __future__ import annotations

import os
from argparse import Namespace
from collections.abc import Callable
from contextlib import nullcontext
from types import SimpleNamespace as Part
from typing import Any

import pytest

import devices.serial_ports
from devices.audio import channel
from donnie_tui import bootstrap
from donnie_tui.cli import front_end, page_server
from donnie_tui.cli.front_end import serve, serve_clients, speaks_for_robots
from donnie_tui.cli.options import Invocation, Order
from donnie_tui.core.events import Announced, Answered, Spoke, Stamped
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.settings.settings import CONFINED, DEVICES, ServedFile, Settings

Lines = list[tuple[str, str]]


class Printed:
    """Lines and complaints in their order."""

    def __init__(self) -> None:
        self.lines = Lines()

    def line(self, text: str) -> None:
        self.lines.append(("line", text))

    def complaint(self, text: str) -> None:
        self.lines.append(("complaint", text))


def order(command: str, settings: Settings | None = None, **arguments: Any) -> Order:
    invocation = Invocation(command, {"world": "maze"}, Namespace(plain=False, **arguments))
    output: Any = Printed()
    return Order(invocation, settings or Settings(), Words(), output, {})


# --- clients of Player


def player(**changes: Any) -> Order:
    values = {"file": "a.cfg", "host": "127.0.0.1", "port": "6665", "linear": False, "visual": False}
    return order("player", **{**values, **changes})


@pytest.fixture
def assembled(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """The settings of the session, and what happens to it. A signal comes once it listens."""
    did = list[Any]()

    def assemble(settings: Settings, *, terminal: bool) -> Any:
        did.append((settings, terminal))

        def subscribe(show: Callable[[Stamped], None]) -> None:
            for event in (
                Spoke("hello"),
                Announced("clients", "A client comes."),
                Announced("link", "not this"),
                Answered("nor this"),
            ):
                show(Stamped(1, 0.0, event, "bob" if isinstance(event, Spoke) else None))
            show(Stamped(2, 0.0, Spoke("and I")))

        hub = Part(subscribe=subscribe)
        return Part(
            session=Part(hub=hub, name="alice"),
            notices=Part(about_devices=("Listening at 6665.",)),
            close=lambda: did.append("closed"),
        )

    def on_signals(over: Callable[[], None]) -> Any:
        over()
        return nullcontext()

    monkeypatch.setattr(bootstrap, "assemble", assemble)
    monkeypatch.setattr(front_end, "on_signals", on_signals)
    monkeypatch.setattr(front_end, "speaks_for_robots", lambda speech, _facts: speech == "tts")
    return did


@pytest.mark.parametrize(("speech", "is_spoken"), [("tts", "robot"), ("text", "off")])
def test_what_robots_say_is_printed_with_their_names_until_a_signal(
    assembled: list[Any], speech: str, is_spoken: str
) -> None:
    it = player()
    it = Order(it.invocation, Settings(speech=speech), it.words, it.output, {})
    assert serve_clients(it) == 0
    (settings, terminal), end = assembled

    assert (settings.world, settings.served) == ("a.cfg", ServedFile("a.cfg", "127.0.0.1", 6665))
    assert (settings.speech, terminal, end) == (is_spoken, False, "closed")
    printed: Any = it.output
    assert printed.lines == [
        ("line", "bob says: hello"),
        ("complaint", "A client comes."),
        ("line", "alice says: and I"),
        ("line", "Listening at 6665."),
        ("line", Words()("player-ending")),
    ]


@pytest.mark.parametrize("mode", ["linear", "visual"])
def test_with_a_mode_a_front_end_shows_what_clients_do(
    monkeypatch: pytest.MonkeyPatch, assembled: list[Any], mode: str
) -> None:
    started = list[Order]()
    monkeypatch.setattr(front_end, "start", lambda it: started.append(it) or 5)

    assert serve_clients(player(**{mode: True})) == 5
    assert started[0].settings.served == ServedFile("a.cfg", "127.0.0.1", 6665)
    assert started[0].settings.world == "a.cfg"
    assert assembled == []


def test_a_player_needs_a_port(assembled: list[Any]) -> None:
    with pytest.raises(Unusable) as bad:
        serve_clients(player(port="65536"))
    assert bad.value.sentence == "65536 is not a port; a port is a number from 1 to 65535."


@pytest.mark.parametrize(
    ("speech", "chosen", "speaks"),
    [("robot", "TEXT", True), ("auto", "TEXT", False), ("auto", "TTS", True), ("auto", "SSIP", True)],
)
def test_robots_speak_where_the_linear_mode_would(
    monkeypatch: pytest.MonkeyPatch, speech: str, chosen: str, speaks: bool
) -> None:
    facts: Any = object()

    def choose(asked: str, given: object) -> Any:
        assert (asked, given) == (speech, facts)
        return Part(channel=channel.Channel[chosen])

    monkeypatch.setattr(channel, "choose_channel", choose)
    assert speaks_for_robots(speech, facts) is speaks


# --- pages


def pages(settings: Settings | None = None, **changes: Any) -> Order:
    values = {"listen": None, "port": "8000", "sessions": "8", "idle": "60"}
    return order("serve", settings, **{**values, **changes})


@pytest.fixture
def served(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """How each server was made; it announces itself and ends."""
    made = list[Any]()

    class Server:
        gate = Part(link="http://localhost:8000/start/x")
        is_open_to_others = False

        def __init__(self, command: list[str], words: Words, log: object, limits: Any, **named: Any) -> None:
            made.append((command[-3:], limits.sessions, limits.idle, named))
            self.is_open_to_others = named["address"] == "0.0.0.0"

    async def serve_it(server: Server, announce: Callable[[], None]) -> None:
        if server.gate.link == "taken":
            raise OSError(98, "Address already in use")
        announce()

    monkeypatch.setattr(front_end, "find_spec", lambda _: object())
    monkeypatch.setattr(page_server, "PageServer", Server)
    monkeypatch.setattr(page_server, "serve_until_signal", serve_it)
    return made


def test_pages_have_the_limits_of_the_options_and_an_open_server_says_so(served: list[Any]) -> None:
    for listen, address, said in (
        (None, "localhost", 1),
        ("127.0.0.1", "127.0.0.1", 1),
        ("0.0.0.0", "0.0.0.0", 2),
    ):
        it = pages(listen=listen, port="80", sessions="3", idle="0")
        assert serve(it) == 0
        printed: Any = it.output
        assert served.pop() == (*(["--visual", "--world", "maze"], 3, 0.0, {"address": address, "port": 80}),)
        assert len(printed.lines) == said
        assert printed.lines[-1] == ("line", Words()("serve-address", link="http://localhost:8000/start/x"))
    serve(pages(idle="2"))
    assert served.pop()[2] == 120.0


@pytest.mark.parametrize(
    ("changes", "settings", "sentence"),
    [
        ({"port": "0"}, Settings(), "0 is not a port; a port is a number from 1 to 65535."),
        ({"sessions": "101"}, Settings(), "101 is not a number of pages; 1 to 100 are possible."),
        ({"sessions": "0"}, Settings(), "0 is not a number of pages; 1 to 100 are possible."),
        ({"idle": "1441"}, Settings(), Words()("serve-bad-idle", value="1441", least=0, most=1440)),
        ({}, Settings(events="-"), Words()("serve-events")),
        ({}, Settings(record="a.rec"), Words()("serve-one-file", option="--record")),
    ],
)
def test_what_pages_can_not_have_is_refused(
    served: list[Any], changes: dict[str, str], settings: Settings, sentence: str
) -> None:
    with pytest.raises(Unusable) as bad:
        serve(pages(settings, **changes))
    assert (bad.value.sentence, served) == (sentence, [])


def test_a_single_page_may_write_a_file(served: list[Any]) -> None:
    assert serve(pages(Settings(record="a.rec"), sessions="1")) == 0
    assert serve(pages(sessions="100", idle="1440", port="65535")) == 0
    assert len(served) == 2


@pytest.mark.parametrize(("listen", "code"), [(None, "serve-failed"), ("127.0.0.1", "serve-failed-at")])
def test_a_server_that_can_not_listen_says_why(
    served: list[Any], monkeypatch: pytest.MonkeyPatch, listen: str | None, code: str
) -> None:
    monkeypatch.setattr(page_server.PageServer, "gate", Part(link="taken"))
    reason = devices.serial_ports.reason_of(OSError(98, "Address already in use"))
    with pytest.raises(Unusable) as bad:
        serve(pages(listen=listen))

    address = listen or "localhost"
    assert bad.value.sentence == Words()(code, address=address, port=8000, reason=reason)


def test_without_the_package_the_command_that_installs_it_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(front_end, "find_spec", lambda _: None)
    with pytest.raises(Unusable) as bad:
        serve(pages())
    assert "[serve]" in bad.value.sentence


def test_pages_are_confined_as_their_server_is(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "environ", {})
    front_end._confine_pages()
    assert os.environ == {}
    monkeypatch.setattr(front_end, "confinement", lambda: Part(folder="/home/ana"))
    for ports, more in (((), {}), (("/dev/a", "/dev/b"), {DEVICES.variable: "/dev/a,/dev/b"})):
        monkeypatch.setattr(devices.serial_ports, "named_ports", lambda ports=ports: ports)
        front_end._confine_pages()
        assert os.environ == {CONFINED.variable: "/home/ana", **more}
