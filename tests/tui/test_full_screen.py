"""The full screen from its start to its end, through other worlds."""

import asyncio
import sys

import pytest

from donnie_tui.settings.settings import Settings
from donnie_tui.tui import full_screen
from tests.tui.conftest import ScreenDriver

WALK = "FW 2\nTR 90\nFW 3"


def begin(monkeypatch, work_through, **settings):
    """The full screen without a terminal, and with a driver of its keys each time it starts."""

    async def worked_through(app):
        async with app.run_test(size=(80, 24)) as pilot:
            screen = ScreenDriver(app, pilot)
            await screen.until(
                lambda: app.controller is not None and not app.startup.is_opening, "the session"
            )
            await work_through(screen)

    monkeypatch.setattr(full_screen.DonnieApp, "run", lambda app, **_: asyncio.run(worked_through(app)))
    chosen = {"world": "open_floor", **settings}
    found = Settings(speed=None, speech="off", sound=False, tour=False, **chosen)
    return full_screen.run_full_screen(found, None)


def test_a_recording_is_not_lost_to_another_world(monkeypatch, tmp_path):
    """A recording has one world: a switch of the world is refused with that reason."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    for kind in ("record", "events"):
        file = tmp_path / f"run.{kind}"

        async def work_through(screen, file=file):
            await screen.run(WALK)
            await screen.type_line("WORLDS")
            await screen.shows(f"I stay in this world: {file} is being written")
            assert screen.app.screen is screen.main

            screen.app.exit(0)

        assert begin(monkeypatch, work_through, **{kind: str(file)}) == 0
        assert "3 steps" in file.read_text(encoding="utf-8")


def test_another_world_has_the_same_program(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    seen = []

    async def work_through(screen):
        seen.append((screen.app.controller.donnie.world.name, screen.main.editor.text))
        if len(seen) == 1:
            screen.load(WALK)
            screen.app.controller.change_world("maze")
        else:
            screen.app.exit(0)
        await screen.until(lambda: not screen.app.is_running, "the end")

    assert begin(monkeypatch, work_through) == 0
    assert seen == [("open_floor", ""), ("maze", WALK)]


def test_a_typed_name_selects_that_world_and_keeps_the_log_and_the_history(monkeypatch, tmp_path):
    """The new world is announced with its things. A running program is stopped first, and reported."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    seen = []

    async def work_through(screen):
        seen.append(screen.app.controller.donnie.world.name)
        if len(seen) == 1:
            await screen.type_line('SPEAK "before"')
            await screen.shows("before")
            screen.load('SPEAK "running"\nWHILE 1 == 1 DO\nWAIT 1\nEND WHILE')
            await screen.press("f5")
            await screen.shows("running")
            await screen.type_line("WORLDS living room")
        else:
            await screen.shows("5 things. WORLD says more.")
            seen.extend(screen.log)
            await screen.press("up", "up")  # the focus is where it was, and no key goes into the program
            assert screen.main.command_line.value == 'SPEAK "before"'
            screen.app.exit(0)
        await screen.until(lambda: not screen.app.is_running, "the end")

    assert begin(monkeypatch, work_through) == 0
    assert seen[:2] == ["open_floor", "living_room"]
    assert seen.index("before") < seen.index("I am going to living_room.")
    assert seen[seen.index("I am going to living_room.") - 1].startswith("Stopped at line ")
    assert seen[-3:] == [
        "This is the world living_room: Living room.",
        "42 by 42 steps, walls included.",
        "5 things. WORLD says more.",
    ]


def test_another_challenge_begins_with_an_empty_program_and_undo_restores_the_one_before(
    monkeypatch, tmp_path
):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    seen = []

    async def work_through(screen):
        seen.append((screen.app.controller.donnie.world.challenge.name, screen.main.editor.text))
        if len(seen) == 1:
            screen.load(WALK)
            await screen.type_line("NEXT CHALLENGE")
        else:
            await screen.shows(f"Your {len(WALK.splitlines())} lines are put away. UNDO brings them back.")
            await screen.type_line("UNDO")
            await screen.until(lambda: screen.main.editor.text == WALK, "the program before")
            screen.app.exit(0)
        await screen.until(lambda: not screen.app.is_running, "the end")

    assert begin(monkeypatch, work_through, world="challenge:first_walk") == 0
    assert seen == [("first_walk", ""), ("to_the_ball", "")]


def test_a_word_says_which_argument_it_does_not_take(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))

    async def work_through(screen):
        await screen.type_line("WORLD nowhere")
        await screen.shows("There is no world nowhere. WORLDS lists them.")
        await screen.type_line("WHERE 3")
        await screen.shows("WHERE takes nothing after it. Type WHERE alone.")
        await screen.type_line("LEGEND x")
        await screen.shows("LEGEND takes nothing after it. Type LEGEND alone.")
        screen.app.exit(0)

    assert begin(monkeypatch, work_through) == 0


def test_the_threads_take_turns_as_before_once_the_screen_is_left(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    found, seen = sys.getswitchinterval(), []

    async def work_through(screen):
        seen.append(sys.getswitchinterval())
        screen.app.exit(0)

    sys.setswitchinterval(0.004)
    try:
        assert begin(monkeypatch, work_through) == 0
        assert seen == [pytest.approx(full_screen.SWITCH)]
        assert sys.getswitchinterval() == pytest.approx(0.004)
    finally:
        sys.setswitchinterval(found)
