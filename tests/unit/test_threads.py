"""A thread that hangs, at a device or at a reader, keeps no process from its end."""

from __future__ import annotations

import os
import threading
from array import array
from collections.abc import Callable
from contextlib import suppress
from io import BytesIO
from typing import Any

import pytest

from devices.audio.players import CommandPlayer
from devices.audio.service import AudioService, AudioSettings
from devices.audio.worker import AudioWorker
from devices.belt import SerialBelt
from devices.serial_ports import Notifier
from devices.serial_robot.link import _PortOpening
from donnie_tui.outlets.files import SlowReader
from donnie_tui.process.disconnection import NetworkWatch, _end_with
from donnie_tui.process.signals import Deputy, Watchdog, end_process


def _slow_reader() -> None:
    os.close(SlowReader(1)._number)


def _last_thread() -> None:
    watchdog = Watchdog({}, part=lambda _: None)
    watchdog.deputy = Deputy()
    watchdog.leave(15)


def _last_task(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "_exit", lambda _: None)
    with suppress(RuntimeError):  # a thread that was not started is not joined
        end_process(lambda: 0, [lambda: None])


def nothing(*_: object) -> None: ...


@pytest.mark.parametrize(
    ("begin", "names"),
    [
        (lambda: SerialBelt("socket://belt:1", nothing), ["belt"]),
        (lambda: Notifier("/dev/belt", nothing).notify(), ["news /dev/belt"]),
        (lambda: AudioWorker(nothing, "none", False, {}, {}).run(BytesIO()), ["voice"]),
        (lambda: AudioService(AudioSettings(), nothing).warm_up(), ["audio writer"]),
        (lambda: _PortOpening("/dev/robot", lambda _: pytest.fail()), ["opening /dev/robot"]),
        (lambda: CommandPlayer("true", ("true",)).speak(array("h", [0]), nothing), ["player"]),
        (_slow_reader, ["slow reader"]),
        (_last_thread, ["deputy", "last"]),
        (lambda: _end_with(os.getpid()), ["hang-up"]),
        (lambda: NetworkWatch(bool, {"SSH_CONNECTION": "127.0.0.1 1 127.0.0.1 22"}), ["network"]),
    ],
)
def test_each_thread_has_a_name_and_keeps_no_process_from_its_end(
    monkeypatch: pytest.MonkeyPatch, begin: Callable[[], Any], names: list[str]
) -> None:
    """The names are for those who look into a process that hangs."""
    begun: list[threading.Thread] = []
    monkeypatch.setattr(threading.Thread, "start", lambda thread: begun.append(thread))
    monkeypatch.setattr("donnie_tui.process.disconnection.TABLES", ("/dev/null",))
    begin()

    assert [(each.name, each.daemon) for each in begun] == [(each, True) for each in names]


def test_a_last_task_keeps_no_process_from_its_end(monkeypatch: pytest.MonkeyPatch) -> None:
    begun: list[threading.Thread] = []
    monkeypatch.setattr(threading.Thread, "start", lambda thread: begun.append(thread))
    _last_task(monkeypatch)

    assert [each.daemon for each in begun] == [True]
