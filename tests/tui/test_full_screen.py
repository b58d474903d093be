"""The full screen from its start to its end, through other worlds."""

import asyncio
import sys

import pytest

from donnie_tui.settings.chosen import Settings
from donnie_tui.tui import full_screen
from tests.tui.conftest import Desk

WALK = "FW 2\nTR 90\nFW 3"


def begin(monkeypatch, work_through, **settings):
    """The full screen, without a terminal and with somebody at its keys each time that it comes up."""

    async def worked_through(app):
        async with app.run_test(size=(80, 24)) as pilot:
            desk = Desk(app, pilot)
            await desk.until(lambda: app.work is not None and not app.is_opening, "the session")
            await work_through(desk)

    monkeypatch.setattr(full_screen.DonnieApp, "run", lambda app, **_: asyncio.run(worked_through(app)))
    world = Settings(world="open_floor", speed=None, speech="off", sound=False, tour=False, **settings)
    return full_screen.run_full_screen(world, None)


def test_a_recording_is_not_lost_to_another_world(monkeypatch, tmp_path):
    """It is of one world: whoever records is told so, and stays."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    for kind in ("record", "events"):
        file = tmp_path / f"run.{kind}"

        async def work_through(desk, file=file):
            await desk.run(WALK)
            await desk.type_line("WORLDS")
            await desk.told(f"I stay in this world: {file} is being written")
            assert desk.app.screen is desk.place

            desk.app.exit(0)

        assert begin(monkeypatch, work_through, **{kind: str(file)}) == 0
        assert "3 steps" in file.read_text(encoding="utf-8")


def test_another_world_has_the_same_program(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    seen = []

    async def work_through(desk):
        seen.append((desk.app.work.donnie.world.name, desk.place.editor.text))
        if len(seen) == 1:
            desk.app.work.load(WALK)
            desk.app.work.change_world("maze")
        else:
            desk.app.exit(0)
        await desk.until(lambda: not desk.app.is_running, "the end")

    assert begin(monkeypatch, work_through) == 0
    assert seen == [("open_floor", ""), ("maze", WALK)]


def test_the_threads_take_turns_as_before_once_the_screen_is_left(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    found, seen = sys.getswitchinterval(), []

    async def work_through(desk):
        seen.append(sys.getswitchinterval())
        desk.app.exit(0)

    sys.setswitchinterval(0.004)
    try:
        assert begin(monkeypatch, work_through) == 0
        assert seen == [pytest.approx(full_screen.SWITCH)]
        assert sys.getswitchinterval() == pytest.approx(0.004)
    finally:
        sys.setswitchinterval(found)
