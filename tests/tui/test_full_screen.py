"""The full screen from its start to its end, through other worlds."""

import asyncio
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import ClassVar

import pytest

from donnie_tui.commands.interaction import SwitchMode
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


# --- from one screen to the next, without a screen


class Left:
    """An application that was left in some way, in place of a real one."""

    made: ClassVar[list["Left"]] = []
    ways: ClassVar[list[dict]] = []

    def __init__(self, settings, file, *, text, assemble, search, restored, typed):
        way = {"next_world": "", "left": None, "code": None, "value": 0, "linear": False, "trouble": None}
        way |= {"fails": None} | Left.ways[len(Left.made)]
        Left.made.append(self)
        self.given = (settings, file, text, search and search.give_up(), restored, typed)
        self.assemble, self.done, self._fails = assemble, [], way["fails"]
        self.return_code, self.return_value = way["code"], way["value"]
        self.shutdown = SimpleNamespace(
            left=way["left"],
            end_watchdog=lambda: self.done.append("watchdog"),
            close_session=lambda: self.done.append("session"),
        )
        self.startup = SimpleNamespace(trouble=way["trouble"])
        self.session = SimpleNamespace(
            next_world=way["next_world"],
            left_for_linear=way["linear"],
            close=lambda: self.done.append("closed"),
            code_at_end=lambda code, report: (code, report),
        )
        self.main_screen = SimpleNamespace(
            log_rows=SimpleNamespace(lines=("one",)), editor=SimpleNamespace(text="FW 1")
        )
        document = SimpleNamespace(path=way.get("path"))
        self.controller = SimpleNamespace(
            workspace=SimpleNamespace(document=document),
            hand_over=lambda: "session",
            donnie="donnie",
            state="state",
            ctx=SimpleNamespace(preferences=SimpleNamespace(settings="preferred")),
        )
        if way.get("early"):
            self.controller = None

    def keys_not_taken(self):
        return ["key"]

    def run(self, *, mouse):
        self.done.append(f"run {mouse}")
        if self._fails:
            raise self._fails


@pytest.fixture
def leave(monkeypatch):
    """Runs the full screen; each dictionary is how an application is left. Returns what comes of it."""

    def left(*ways, settings=None, file=None, text=None, donnie=None):
        Left.made.clear()
        Left.ways[:] = ways
        return full_screen.run_full_screen(settings or Settings(plain=False), file, text=text, donnie=donnie)

    monkeypatch.setattr(full_screen, "DonnieApp", Left)
    monkeypatch.setattr(full_screen, "print_last_lines", lambda lines: Left.made[-1].done.append(lines))
    return left


@pytest.mark.parametrize(
    ("way", "code"),
    [
        ({}, 0),
        ({"value": None}, 0),
        ({"value": 3}, 3),
        ({"value": None, "code": 1}, 1),
        ({"value": 3, "code": 1}, 1),
        ({"value": 3, "code": 4}, 3),
        ({"left": (15, 1.0)}, 143),
        ({"left": (1, 1.0), "code": 1}, 129),
        ({"left": (15, 1.0), "next_world": "maze"}, 143),
    ],
)
def test_the_exit_code_is_that_of_the_screen_of_a_fault_or_of_a_signal(leave, way, code):
    assert leave(way) == (code, print)
    (app,) = Left.made
    assert app.done == ["run True", "watchdog", "session", ("one",)]


def test_the_next_world_gets_the_state_and_the_keys_that_were_not_taken(leave, monkeypatch):
    asked = []
    there = Settings(plain=True)
    monkeypatch.setattr(
        "donnie_tui.commands.world.settings_there", lambda *given: asked.append(given) or there
    )
    first, moved = Settings(plain=False), []
    audible = SimpleNamespace(move_to=lambda *, is_linear: moved.append(is_linear))
    donnie = SimpleNamespace(outlets=SimpleNamespace(audible=audible))
    leave({"next_world": "maze"}, {}, settings=first, file="a.gd", text="FW 1", donnie=donnie)
    one, two = Left.made
    assert one.given == (first, Path("a.gd"), "FW 1", None, None, [])
    assert two.given == (there, None, None, None, "state", ["key"])
    assert (asked, moved) == ([("donnie", "preferred", "maze")], [False])
    assert one.assemble() is donnie
    assert (one.done, two.done[0]) == (["run True", "watchdog", "session"], "run False")


@pytest.mark.parametrize(
    ("settings", "donnie", "is_searched"),
    [
        ({"robot": "serial:/dev/x"}, None, True),
        ({"world": "one.cfg"}, None, True),
        ({}, None, False),
        ({"robot": "serial:/dev/x"}, "donnie", False),
    ],
)
def test_a_real_robot_is_searched_for_unless_there_is_a_session(
    leave, monkeypatch, settings, donnie, is_searched
):
    assembled = []
    monkeypatch.setattr(
        "donnie_tui.bootstrap.assemble", lambda given, **named: assembled.append((given, named)) or "new"
    )
    audible = SimpleNamespace(move_to=lambda *, is_linear: None)
    session = SimpleNamespace(outlets=SimpleNamespace(audible=audible)) if donnie else None
    settings = Settings(plain=False, **settings)
    leave({}, settings=settings, donnie=session)
    (app,) = Left.made
    assert bool(app.given[3]) is is_searched
    if donnie:
        assert (app.assemble(), assembled) == (session, [])
    else:
        assert app.assemble() == "new"
        ((given, named),) = assembled
        assert (given, named["terminal"], named["is_linear"]) == (settings, True, False)
        assert (named["search"] is not None) is is_searched


def test_what_ends_the_screen_is_raised_once_the_session_is_closed(leave):
    for problem in (RuntimeError("fault"), KeyboardInterrupt()):
        with pytest.raises(type(problem)):
            leave({"fails": problem})
        assert Left.made[0].done == ["run True", "closed", "watchdog"]
    with pytest.raises(LookupError):
        leave({"trouble": LookupError("no such world"), "linear": True})
    assert Left.made[0].done == ["run True", "watchdog", "session"]
    assert leave({"linear": True, "code": 1}) == (1, print), "after a fault nothing goes on"


@pytest.mark.parametrize(
    ("way", "name", "session"),
    [
        ({}, None, "session"),
        ({"path": Path("dir/a.gd")}, "dir/a.gd", "session"),
        ({"early": True}, None, None),
    ],
)
def test_the_linear_mode_takes_the_text_its_file_and_the_session_over(leave, way, name, session):
    with pytest.raises(SwitchMode) as switched:
        leave(way | {"linear": True})
    mode = switched.value
    assert (mode.text, mode.name, mode.donnie) == ("FW 1", name, session)
    assert Left.made[0].done == ["run True", "watchdog"]
