"""The full screen from its start to its end, through other worlds."""

import asyncio
import sys

import pytest

from donnie_tui.core.run_state import RunState
from donnie_tui.settings.settings import Settings
from donnie_tui.tui import full_screen
from tests.tui.conftest import ScreenDriver

WALK = "FW 2\nTR 90\nFW 3"


def begin(monkeypatch, work_through, **settings):
    """The full screen without a terminal, and with a driver of its keys each time it starts."""

    async def worked_through(app):
        async with app.run_test(size=(80, 24)) as pilot:
            desk = ScreenDriver(app, pilot)
            await desk.until(lambda: app.controller is not None and not app.startup.is_opening, "the session")
            await work_through(desk)

    monkeypatch.setattr(full_screen.DonnieApp, "run", lambda app, **_: asyncio.run(worked_through(app)))
    world = Settings(world="open_floor", speed=None, speech="off", sound=False, tour=False, **settings)
    return full_screen.run_full_screen(world, None)


def test_a_recording_is_not_lost_to_another_world(monkeypatch, tmp_path):
    """A recording has one world: a switch of the world is refused with that reason."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    for kind in ("record", "events"):
        file = tmp_path / f"run.{kind}"

        async def work_through(desk, file=file):
            await desk.run(WALK)
            await desk.type_line("WORLDS")
            await desk.shows(f"I stay in this world: {file} is being written")
            assert desk.app.screen is desk.place

            desk.app.exit(0)

        assert begin(monkeypatch, work_through, **{kind: str(file)}) == 0
        assert "3 steps" in file.read_text(encoding="utf-8")


def test_another_world_has_the_same_program(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    seen = []

    async def work_through(desk):
        seen.append((desk.app.controller.donnie.world.name, desk.place.editor.text))
        if len(seen) == 1:
            desk.load(WALK)
            desk.app.controller.change_world("maze")
        else:
            desk.app.exit(0)
        await desk.until(lambda: not desk.app.is_running, "the end")

    assert begin(monkeypatch, work_through) == 0
    assert seen == [("open_floor", ""), ("maze", WALK)]


def test_a_typed_name_selects_that_world_and_keeps_the_log_and_the_history(monkeypatch, tmp_path):
    """The new world is announced with its things. A running program is stopped first, and reported."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    seen = []

    async def work_through(desk):
        seen.append(desk.app.controller.donnie.world.name)
        if len(seen) == 1:
            await desk.type_line('SPEAK "before"')
            await desk.shows("before")
            desk.load("WHILE 1 == 1 DO\nWAIT 1\nEND WHILE")
            await desk.press("f5")
            await desk.until(lambda: desk.app.controller.ctx.runs.state is not RunState.READY, "the run")
            await desk.type_line("WORLDS living room")
        else:
            await desk.shows("5 things. WORLD says more.")
            seen.extend(desk.log)
            await desk.press("up", "up")  # the focus is where it was, and no key goes into the program
            assert desk.place.command_line.value == 'SPEAK "before"'
            desk.app.exit(0)
        await desk.until(lambda: not desk.app.is_running, "the end")

    assert begin(monkeypatch, work_through) == 0
    assert seen[:2] == ["open_floor", "living_room"]
    assert seen.index("before") < seen.index("I go to living_room.")
    assert seen[seen.index("I go to living_room.") - 1].startswith("Stopped at line ")
    assert seen[-3:] == [
        "This is the world living_room: Living room.",
        "42 by 42 steps, walls included.",
        "5 things. WORLD says more.",
    ]


def test_a_word_says_which_argument_it_does_not_take(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))

    async def work_through(desk):
        await desk.type_line("WORLD nowhere")
        await desk.shows("There is no world nowhere. WORLDS lists them.")
        await desk.type_line("WHERE 3")
        await desk.shows("WHERE takes nothing after it. Type WHERE alone.")
        await desk.type_line("LEGEND x")
        await desk.shows("LEGEND takes nothing after it. Type LEGEND alone.")
        desk.app.exit(0)

    assert begin(monkeypatch, work_through) == 0


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
