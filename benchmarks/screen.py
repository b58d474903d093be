"""The full screen at work: the map's bytes and time, a key to the screen, what a program loses, a long log.

Ratios of one run on one machine, each measured in turns with what it is measured against (the targets are the
specification's). Run: ``python benchmarks/screen.py``
"""

from __future__ import annotations

import asyncio
import contextlib
import io
import os
import sys
import tempfile
import time
import tracemalloc
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
os.environ["TEXTUAL_ANIMATIONS"] = "none"

from rich.console import Console, RenderableType
from textual.app import App, ComposeResult
from textual.events import Key
from textual.screen import Screen
from textual.widgets import RichLog

from devices.ports.robot import Pose
from donnie_tui.bootstrap import assemble
from donnie_tui.core.run_state import RunState
from donnie_tui.settings.settings import Settings
from donnie_tui.tui.app import DonnieApp
from donnie_tui.tui.controller import ScreenController
from donnie_tui.tui.full_screen import SWITCH
from donnie_tui.tui.widgets.rows import TextRows

FRAMES = 100
LINES = 100_000
THINGS = 1000


@contextlib.asynccontextmanager
async def screen(world: str = "living_room", size: tuple[int, int] = (120, 40)) -> AsyncIterator[DonnieApp]:
    settings = Settings(world=world, speed=None, speech="off", sound=False, plain=False)
    with tempfile.TemporaryDirectory() as folder:
        app = DonnieApp(settings, assemble=lambda: assemble(settings, terminal=True), folder=Path(folder))
        async with app.run_test(size=size) as pilot:
            while app.controller is None:
                await pilot.pause(0.01)
            await pilot.pause()
            yield app
        app.session.close()


class Bytes:
    """What the application would write to a terminal; ``whole``: cells that have not changed as well."""

    def __init__(self, app: DonnieApp, *, whole: bool) -> None:
        self.whole = whole
        self.console = Console(file=io.StringIO(), force_terminal=True, color_system="truecolor", width=200)
        self.app = app
        self.count = 0
        app._display = self._display  # type: ignore[method-assign]  # every update passes here

    def _display(self, screen: Screen[Any], renderable: RenderableType | None) -> None:  # noqa: ARG002
        if not self.whole and self.app._painted is not None:
            renderable = self.app._painted.less(renderable)
        if renderable is not None and hasattr(renderable, "render_segments"):
            self.count += len(renderable.render_segments(self.console).encode())


async def map_at_work(whole: bool, world: str) -> tuple[float, float]:
    """Bytes and seconds for the frames of a walk; ``whole``: the map is painted anew each time."""
    async with screen(world) as app:
        written = Bytes(app, whole=whole)
        place = app.main_screen
        began = time.process_time()
        for frame in range(FRAMES):
            pose = Pose(float(frame // 4 % 20), float(frame // 80), 90.0)
            controller_of(app).display.move((pose,))
            if whole:
                place.map.refresh()
            await asyncio.sleep(0)
            app.screen._on_timer_update()
        return float(written.count), time.process_time() - began


async def key_to_screen(busy: Callable[[DonnieApp], None] | None) -> float:
    """Seconds from a key to its letter in the command line, the median of many."""
    async with screen() as app:
        if busy is not None:
            busy(app)
        line = app.main_screen.command_line
        line.focus()
        taken = []
        for _ in range(60):
            before = line.value
            began = time.perf_counter()
            app.post_message(_key("x"))
            while line.value == before or line._painted != (line.value, line.cursor_position):
                await asyncio.sleep(0)
            taken.append(time.perf_counter() - began)
            await asyncio.sleep(0.01)
        if controller_of(app).ctx.runs.state is not RunState.READY:
            app.session.halt()
        return median(taken)


def _key(letter: str) -> Key:
    return Key(letter, letter)


def walking(app: DonnieApp) -> None:
    """The robot moves twenty times a second."""
    poses = iter(range(10**9))
    app.set_interval(
        1 / 20, lambda: controller_of(app).display.move((Pose(float(next(poses) % 20), 5.0, 90.0),))
    )


def load(app: DonnieApp, text: str) -> None:
    """Another program in the editor."""
    app.main_screen.editor.show(text, frozenset())
    controller_of(app).display.update()


def controller_of(app: DonnieApp) -> ScreenController:
    """The controller, which every screen of this benchmark has."""
    assert app.controller is not None
    return app.controller


def computing(app: DonnieApp) -> None:
    sys.setswitchinterval(SWITCH)
    load(app, "VAR x = 0\nWHILE 1 == 1 DO\nx = x + 1\nEND WHILE")
    app.do("run")


TURNS = 200_000_000
"""Ten seconds or so: beginning and ending the run are little of it, and printed by themselves."""
COUNTED = f"VAR x = 0\nREPEAT {TURNS} TIMES\nx = x + 1\nEND REPEAT"
BEGUN = 1.0
"""Seconds after which a run has begun, and its first sentences are on the screen."""


@dataclass(frozen=True)
class Lost:
    """The screen's part of the processor's time while a program only computes."""

    whole: float
    """Of the whole run, with its beginning and its end."""
    between: float
    """Of what lies between them."""
    ends: float
    """Seconds of the processor for beginning and end together, but for looking in between."""


async def lost_to_the_screen() -> Lost:
    """Both are threads under one lock. A clock would measure the machine's other work, too.

    What a terminal would get is worked out too; writing it is left to a thread that waits for the terminal.
    """
    async with screen() as app:
        Bytes(app, whole=False)
        sys.setswitchinterval(SWITCH)
        load(app, COUNTED)
        await asyncio.sleep(0.5)
        first = _spent()
        app.do("run")
        await asyncio.sleep(BEGUN)
        begun = last = _spent()
        while controller_of(app).donnie.session.run is not None:
            last = _spent()
            await asyncio.sleep(0.5)
        ended = _spent()
        between = (last[0] - begun[0]) / (last[1] - begun[1])
        ends = ended[0] - first[0] - between * (ended[1] - first[1])
        return Lost((ended[0] - first[0]) / (ended[1] - first[1]), between, ends)


def _spent() -> tuple[float, float]:
    """Seconds of the processor: of the screen's thread, and of all."""
    return time.thread_time(), time.process_time()


class Logs(App[None]):
    def __init__(self, ours: bool) -> None:
        super().__init__()
        self.ours = ours

    def compose(self) -> ComposeResult:
        yield TextRows(id="log", follows=True) if self.ours else RichLog(wrap=True)


async def log_of(ours: bool) -> tuple[float, float]:
    """Seconds to append, bytes kept."""
    app = Logs(ours)
    lines = [f"I walked {number} steps forward." for number in range(LINES)]
    async with app.run_test(size=(80, 24)) as pilot:
        await pilot.pause()
        tracemalloc.start()
        before = tracemalloc.get_traced_memory()[0]
        began = time.perf_counter()
        if ours:
            rows = app.query_one(TextRows)
            for at in range(0, LINES, 100):
                rows.append([(line, "moved") for line in lines[at : at + 100]])
        else:
            log = app.query_one(RichLog)
            for line in lines:
                log.write(line)
        taken = time.perf_counter() - began
        kept = tracemalloc.get_traced_memory()[0] - before
        tracemalloc.stop()
        return taken, float(kept)


def many_things(folder: str) -> str:
    """A world with a thousand things."""
    things = "\n".join(
        f'crate( pose [ {at % 40 * 0.6:g} {at // 40 * 0.6 + 1:g} 0 0 ] name "crate{at}" color "red" )'
        for at in range(THINGS)
    )
    path = Path(folder) / "many.world"
    path.write_text(
        "define crate model ( size [ 0.2 0.2 0.5 ] )\ndefine donnie position ( size [ 0.3 0.3 0.3 ] )\n"
        f'donnie( pose [ 0 0 0 90 ] name "donnie" )\n{things}\n'
    )
    return str(path)


def said(what: str, ratio: float, target: str) -> None:
    print(f"{what:52} {ratio:7.3f}   target {target}")


async def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        for name, world in (("living room", "living_room"), (f"{THINGS} things", many_things(folder))):
            pairs = [(await map_at_work(False, world), await map_at_work(True, world)) for _ in range(3)]
            said(
                f"map, {name}: bytes to repainting it whole", median(a[0] / b[0] for a, b in pairs), "<= .06"
            )
            said(f"map, {name}: CPU to repainting it whole", median(a[1] / b[1] for a, b in pairs), "<= .45")
            print(f"{'':52} {median(a[0] for a, _ in pairs) / FRAMES * 20 / 1000:7.2f}   kB/s at 20 Hz, <= 5")
    rounds = [
        (await key_to_screen(None), await key_to_screen(walking), await key_to_screen(computing))
        for _ in range(3)
    ]
    said("key to screen, map moving, to idle", median(b / a for a, b, _ in rounds), "<= 1.3")
    said("key to screen, program computing, to idle", median(c / a for a, _, c in rounds), "<= 2.5")
    lost = [await lost_to_the_screen() for _ in range(3)]
    said("what a program that computes loses to the screen", median(each.whole for each in lost), "<= .03")
    said("the same, between beginning and end", median(each.between for each in lost), "<= .03")
    print(f"{'beginning and end':52} {median(each.ends for each in lost) * 1000:7.0f}   ms of the processor")
    logs = [(await log_of(True), await log_of(False)) for _ in range(1)]
    said("log of 100 000 lines: append to RichLog", median(a[0] / b[0] for a, b in logs), "<= .02")
    said("log of 100 000 lines: memory to RichLog", median(a[1] / b[1] for a, b in logs), "<= .05")


if __name__ == "__main__":
    asyncio.run(main())
