"""A full screen without a terminal, on the real session and simulator at unlimited speed."""

import sys
import time

sys.setswitchinterval(0.0002)  # as the application has it: a program that computes must not starve the screen

from collections.abc import AsyncIterator, Callable, Iterator  # noqa: E402
from contextlib import asynccontextmanager  # noqa: E402
from pathlib import Path  # noqa: E402
from typing import Any  # noqa: E402

import pytest  # noqa: E402
from textual import events  # noqa: E402
from textual.pilot import Pilot  # noqa: E402

from donnie_tui.bootstrap import assemble  # noqa: E402
from donnie_tui.core.run_state import RunState  # noqa: E402
from donnie_tui.settings.settings import Settings  # noqa: E402
from donnie_tui.tui import run_view, startup  # noqa: E402
from donnie_tui.tui.app import DonnieApp  # noqa: E402
from tests.timeouts import TIMEOUT  # noqa: E402

Pilot._wait_for_screen.__defaults__ = (
    float(TIMEOUT),
)  # Textual's own thirty seconds are few on a busy machine

WAITING = "WHILE 1 == 1 DO\nWAIT 1000\nEND WHILE"
"""Without end, and idle at speed 1."""

COMPUTING = "WHILE 1 == 1 DO\nVAR x = 1\nEND WHILE"
"""Without end, and never idle."""


def burst(screen, *keys: str) -> None:
    """Keys that arrive at once."""
    for key in keys:
        screen.app.post_message(events.Key(key, {"space": " "}.get(key, key if len(key) == 1 else None)))


class ScreenDriver:
    """Drives a running application by its keys."""

    def __init__(self, app: DonnieApp, pilot: Pilot[int]) -> None:
        self.app = app
        self.pilot = pilot
        self.main = app.main_screen

    async def until(self, condition: Callable[[], Any], what: str = "") -> None:
        end = time.monotonic() + TIMEOUT
        while time.monotonic() < end:
            if condition():
                return
            if self.app.startup.trouble is not None:
                raise self.app.startup.trouble
            await self.pilot.pause(0.01)
        raise AssertionError(f"never happened: {what or condition}; the log: {self.log}")

    async def painted(self) -> None:
        """Wait until nothing is left to paint: Textual paints after the message that changed something.

        The mistakes in a typed text are marked a moment after its last letter.
        """
        controller, screen = self.app.controller, self.app.screen
        await self.until(lambda: controller is None or controller.assistant._checking is None, "the marks")
        for _ in range(2):
            await self.pilot.pause()
            await self.until(
                lambda: (
                    not (
                        screen._layout_required
                        or screen._repaint_required
                        or screen._dirty_widgets
                        or screen._compositor._dirty_regions
                    )
                ),
                "the last of the paint",
            )

    async def press(self, *keys: str) -> None:
        await self.pilot.press(*keys)

    async def type_line(self, text: str) -> None:
        """A line in the command line, and Enter."""
        self.main.command_line.focus()
        await self.until(lambda: self.main.focused is self.main.command_line, "the command line")
        self.main.command_line.value = text
        await self.press("enter")

    async def answer(self, text: str) -> None:
        """Answer the question that is asked."""
        await self.until(lambda: getattr(self.app.focused, "id", None) == "answer", "a question")
        self.app.screen.query_one("#answer").value = text
        await self.press("enter")

    async def shows(self, text: str) -> None:
        """Wait until a line of the log has this text."""
        await self.until(lambda: any(text in line for line in self.log), text)

    async def status_has(self, text: str) -> None:
        """Wait until the status line has this text."""
        await self.until(lambda: text in self.status, f"{text} in the status line")

    async def idle(self) -> None:
        await self.until(lambda: self.app.controller.ctx.runs.state is RunState.READY, "the end of the run")

    def load(self, text: str, breakpoints: frozenset[int] = frozenset()) -> None:
        """Another program in the editor."""
        self.main.editor.show(text, breakpoints)
        self.app.controller.display.update()

    async def run(self, text: str) -> None:
        """The program, run with F5 to its end."""
        self.load(text)
        await self.press("f5")
        await self.shows("The program is done.")

    async def reaches(self, state: RunState) -> None:
        await self.until(lambda: self.app.controller.ctx.runs.state is state, str(state))

    @property
    def log(self) -> tuple[str, ...]:
        return self.main.log_rows.lines

    @property
    def status(self) -> str:
        return self.main.status.words

    @property
    def text(self) -> str:
        """What is seen, as text."""
        strips = self.app.screen._compositor.render_strips()
        return "\n".join(strip.text.rstrip() for strip in strips)

    def map_rows(self) -> tuple[str, ...]:
        assert self.main.map.grid is not None
        return self.main.map.grid.rows()


@pytest.fixture(autouse=True)
def isolated_folders(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Settings and files of a test are in its own folder."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.chdir(tmp_path)


@pytest.fixture(autouse=True)
def no_reminders(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing counts as slow, however busy the machine is; a test that wants reminders sets these again."""
    monkeypatch.setattr(run_view, "SLOW", TIMEOUT)
    monkeypatch.setattr(run_view, "SLOW_AGAIN", TIMEOUT)
    monkeypatch.setattr(startup, "SLOW", TIMEOUT)


@pytest.fixture
def open_screen(tmp_path: Path):
    """``async with open_screen(text=..., size=...) as screen``."""

    @asynccontextmanager
    async def opened(
        text: str | None = None,
        *,
        file: Path | None = None,
        size: tuple[int, int] = (80, 24),
        speed: float | None = None,
        world: str = "open_floor",
        language: str = "en",
        plain: bool = False,
        tour: bool = False,
        **others: Any,
    ) -> AsyncIterator[ScreenDriver]:
        settings = Settings(
            world=world,
            speed=speed,
            speech="off",
            sound=False,
            language=language,
            plain=plain,
            tour=tour,
            **others,
        )
        app = DonnieApp(
            settings, file, text=text, assemble=lambda: assemble(settings, terminal=True), folder=tmp_path
        )
        try:
            async with app.run_test(size=size) as pilot:
                screen = ScreenDriver(app, pilot)
                await screen.until(lambda: app.controller and not app.startup.is_opening, "the session")
                await pilot.pause()
                yield screen
        finally:
            app.session.close()

    return opened


@pytest.fixture
def terminal(tmp_path: Path) -> Iterator[Callable[..., Any]]:
    """Opens terminals, with the program on them."""
    from tests.tui.terminal import Terminal  # which not every system has

    opened: list[Terminal] = []

    def open_one(
        *arguments: str,
        columns: int = 80,
        rows: int = 24,
        controls: bool = False,
        is_job: bool = False,
        until: str = "",
        has_size: bool = True,
        **environment: str,
    ) -> Terminal:
        """``until``: what it shows when it is returned; by default that it is ready."""
        opened.append(
            Terminal(list(arguments), tmp_path, columns, rows, environment, controls, is_job, has_size)
        )
        opened[-1].shows(until or ("Command line." if "--plain" in arguments else "READY"))
        return opened[-1]

    yield open_one
    for each in opened:
        each.close()
