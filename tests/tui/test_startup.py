"""The start of the full screen without a screen: what is shown, loaded and said, and its session."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine
from pathlib import Path
from types import SimpleNamespace as Part
from typing import Any

import pytest

from donnie_tui.commands.keys import KeyTable
from donnie_tui.core.recovery import read_copy
from donnie_tui.settings.settings import Settings
from donnie_tui.tui import startup
from donnie_tui.tui.startup import SessionHandle, Startup
from tests.tui.test_run_view import Recorded, Timers

START = ("Screen reader? Type LINEAR and Enter.", "F5 runs the program. F1 helps.")


class Starting:
    """A start and what it did. A worker is run by the test."""

    def __init__(
        self,
        *,
        world: str = "open_floor",
        robot: str = "",
        search: Any = None,
        trouble: Exception | None = None,
        is_small: bool = False,
    ) -> None:
        self.done: list[Any] = []
        self.timers = Timers()
        self.workers: list[Coroutine[Any, Any, None]] = []
        self.groups: list[Any] = []
        self.trouble = trouble
        self.app = Recorded(
            "app", self.done, set_timer=self.timers.timer("once"), run_worker=self._run_worker,
            call_after_refresh=lambda call: self.done.append(call),
        )  # fmt: skip
        self.donnie = Recorded(
            "donnie", self.done, outlets=Part(audible=Recorded("audible", self.done)),
            get_ready_to_move="ready to move",
        )  # fmt: skip
        parts = {name: Recorded(name, self.done) for name in ("status", "editor")}
        self.logged: list[Any] = []
        panes = {
            f"{name}_pane": Recorded(f"{name} pane", self.done) for name in ("program", "map", "x", "log")
        }
        self.place = Part(
            panes=tuple(panes.values()), log_rows=Part(looks={"a": "b"}), is_small=is_small, **panes, **parts,
            log_lines=lambda lines: self.logged.extend(lines),
        )  # fmt: skip
        self.session = Part(controller=None, assembled=None)
        self.startup = Startup(
            self.app, self.session, self.place, Settings(world=world, robot=robot), search=search,
            assemble=self._assemble, start_controller=self._start,
            release_keys=lambda: self.done.append("released"),
        )  # fmt: skip

    def _run_worker(self, worker: Coroutine[Any, Any, None], **group: Any) -> None:
        self.workers.append(worker)
        self.groups.append(group)

    def _assemble(self) -> Any:
        self.done.append("assembled")
        if self.trouble:
            raise self.trouble
        return self.donnie

    def _start(self, donnie: Any) -> None:
        assert donnie is self.donnie
        self.session.controller = Part(display=Recorded("display", self.done))
        self.done.append("started")


STARTED = ["assembled", ("audible say_printed",), "started", "released", "ready to move"]


# --- the first frame


@pytest.mark.parametrize("driver", ["", "page"])
@pytest.mark.parametrize("is_small", [False, True])
def test_the_first_frame_has_titles_first_steps_and_how_to_begin(
    monkeypatch: pytest.MonkeyPatch, driver: str, is_small: bool
) -> None:
    monkeypatch.setenv("TEXTUAL_DRIVER", driver)
    it = Starting(is_small=is_small)
    it.startup.greet(KeyTable())
    titles = ("Program", "Map", "Variables", "Log")
    panes = ("program", "map", "x", "log")
    small = [call for call in it.done if call[0] == "program pane entitle"][1:]
    steps = next(call for call in it.done if call[0] == "editor show_first_steps")
    assert it.done[:5] == [
        *((f"{pane} pane entitle", title) for pane, title in zip(panes, titles, strict=True)),
        ("status say", " Starting."),
    ]
    assert len(steps[1]) == 3
    assert [title.startswith("F5 runs. F1 helps.") for _, title in small] == [True] * is_small
    greeting = ("Screen reader? In a terminal: donnie --linear", START[1]) if driver else START
    assert it.logged == [(each, "") for each in greeting]
    it.done.clear()
    it.startup.begin()
    assert it.done[1] == ("audible say_printed", *greeting)


def test_in_another_world_the_log_of_the_one_before_is_shown_in_place_of_the_greeting() -> None:
    it = Starting(is_small=True)
    it.startup.greet(KeyTable(), Part(looks={"says": "error"}, log=(("Hello", "says"),)))
    assert it.place.log_rows.looks == {"a": "b", "says": "error"}
    assert it.logged == [("Hello", "says")]
    assert it.done[4:] == [("status say", " Starting.")]
    it.done.clear()
    it.startup.begin()
    assert it.done == STARTED


# --- the session


def test_a_built_in_world_is_loaded_at_once() -> None:
    it = Starting()
    assert it.startup.holds_keys
    it.startup.begin()
    assert it.done == STARTED
    assert (it.workers, it.timers.set, it.startup.trouble, it.logged) == ([], [], None, [])
    assert not it.startup.holds_keys


@pytest.mark.parametrize("world", ["open_floor", "own.toml"])
async def test_what_can_not_be_loaded_ends_the_screen_with_its_reason(world: str) -> None:
    it = Starting(world=world, trouble=LookupError("no such world"))
    it.startup.begin()
    for each in it.workers:
        await each
    assert it.startup.trouble is it.trouble
    assert it.done == ["assembled", ("app exit", 2)]


@pytest.mark.parametrize("is_slow", [False, True])
async def test_an_own_world_is_loaded_in_the_background_and_reported_if_it_is_slow(is_slow: bool) -> None:
    it = Starting(world="worlds/own.toml")
    it.startup.begin()
    assert (len(it.workers), it.done) == (1, [])
    await asyncio.sleep(0)
    loading = asyncio.ensure_future(it.workers[0])
    await asyncio.sleep(0)
    ((kind, seconds, report),) = it.timers.set
    assert (kind, seconds) == ("once", startup.SLOW)
    if is_slow:
        report()
        sentence = "Loading the world own.toml, it takes a while."
        assert it.logged == [(sentence, "")]
        assert ("status say", f" {sentence}") in it.done
    await loading
    ready = [("donnie say", "slow-world-done", ("name", "own.toml"))]
    assert it.done[-len(STARTED) + 1 - is_slow :] == [
        *STARTED[1:-1], *(ready if is_slow else []), STARTED[-1]
    ]  # fmt: skip
    assert (it.timers.set, it.session.assembled) == ([], it.donnie)


@pytest.mark.parametrize("robot", ["serial:/dev/x", ""])
async def test_a_search_for_a_robot_is_reported_and_what_is_slow_about_it(robot: str) -> None:
    """A configuration file may ask for one: then the search says nothing before it is known."""
    search = Part()
    it = Starting(robot=robot, search=search)
    it.startup.begin()
    trying = "I am looking for the robot. Please wait."
    assert it.logged == [(trying, "")] * bool(robot)
    loading = asyncio.ensure_future(it.workers[0])
    await asyncio.sleep(0)
    it.timers.set[0][2]()
    search.on_slow()
    await loading
    assert it.logged[bool(robot) :] == [("Waiting for the robot. Ctrl+C gives up.", "")]
    assert it.done[-4:] == STARTED[1:]
    assert it.session.assembled is it.donnie


def test_a_robot_that_is_not_searched_for_is_not_reported() -> None:
    it = Starting(world="own.toml", robot="serial:/dev/x")
    it.startup.begin()
    assert it.logged == []
    it.workers[0].close()


# --- the first file


@pytest.mark.parametrize("is_slow", [False, True])
async def test_keys_wait_for_the_first_file_but_not_for_a_slow_one(is_slow: bool) -> None:
    it = Starting()
    it.startup.begin()
    it.done.clear()

    async def opening() -> None:
        it.done.append("opened")

    it.startup.open_with(opening())
    assert (it.startup.holds_keys, it.startup.is_opening, it.groups) == (True, True, [{"group": "opening"}])
    ((kind, seconds, is_late),) = it.timers.set
    assert (kind, seconds) == ("once", startup.SLOW)
    if is_slow:
        is_late()
        assert (it.startup.holds_keys, it.done) == (False, ["released"])
    await it.workers[0]
    assert it.done == [
        *(["released"] if is_slow else []), "opened", ("display update",), *([] if is_slow else ["released"])
    ]  # fmt: skip
    assert (it.startup.is_opening, it.timers.set) == (False, [])


async def test_keys_that_wait_for_a_file_are_not_released_before_there_is_a_session() -> None:
    it = Starting()

    async def opening() -> None:
        pass

    it.startup.open_with(opening())
    await it.workers[0]
    assert (it.done, it.startup.is_opening, it.startup.holds_keys) == ([], False, True)


# --- the session of each moment


class Handle:
    """A handle, and the calls of the session behind it."""

    def __init__(self, *, has_controller: bool = True, search: Any = None, **given: Any) -> None:
        self.done: list[Any] = []
        self.handle = SessionHandle(search, **given)
        connection = Part(search=Part(give_up=lambda: self.done.append("give up") or True))
        self.team = Recorded("team", self.done, running=[])
        self.donnie = Recorded(
            "donnie", self.done, connection=connection, team=self.team,
            stop_real_robot=lambda: self.done.append("stop real") or True,
            code_at_end=lambda code, report: (code + 1, report),
        )  # fmt: skip
        self.runs = Recorded("runs", self.done, is_busy=False)
        if has_controller:
            self.handle.controller = Recorded(
                "controller", self.done, donnie=self.donnie, next_world="maze", left_for_linear=True,
                ctx=Recorded("ctx", self.done, runs=self.runs),
                workspace=Recorded("workspace", self.done),
            )  # fmt: skip

    def does(self, call: Callable[[], object]) -> list[Any]:
        self.done.clear()
        call()
        return self.done


def test_before_there_is_a_session_nothing_runs_and_nothing_is_done() -> None:
    it = Handle(has_controller=False)
    handle = it.handle
    assert (handle.runs, handle.next_world, handle.left_for_linear) == (False, "", False)
    assert (handle.give_up_search(), handle.stop_real_robot(), handle.is_leaving) == (False, False, False)
    assert handle.code_at_end(3, print) == 3
    for call in (handle.halt, handle.keep_text, handle.close):
        call()
    SessionHandle(None, lambda: "FW 1").keep_text()  # there is no place for it
    handle.point("words")
    handle.say("code", name="value")
    assert it.done == []
    handle.assembled = it.donnie
    assert handle.code_at_end(3, print) == (4, print)
    assert it.does(handle.close) == [("donnie close",)]


@pytest.mark.parametrize("found", [True, False])
def test_the_first_search_can_be_given_up_before_there_is_a_session(found: bool) -> None:
    searched = []
    it = Handle(has_controller=False, search=Part(give_up=lambda: searched.append("give up") or found))
    assert it.handle.give_up_search() is found
    it.handle.halt()
    assert searched == ["give up"] * 2


def test_what_the_screen_asks_for_reaches_the_session() -> None:
    it = Handle(search=Part(give_up=None))
    handle = it.handle
    assert (handle.next_world, handle.left_for_linear, handle.code_at_end(0, print)) == (
        "maze", True, (1, print)
    )  # fmt: skip
    assert it.does(lambda: handle.point("words")) == [("controller point", "words")]
    assert it.does(lambda: handle.say("code", name=1)) == [("ctx answer", "code", ("name", 1))]
    assert it.does(handle.halt) == ["give up", ("runs note_stop",), ("team stop",)]
    assert handle.stop_real_robot() is True
    assert handle.give_up_search() is True
    assert it.does(handle.keep_text) == [("workspace write_copies",), ("donnie rescue_world",)]
    handle.assembled = Recorded("another", it.done)
    assert it.does(handle.close) == [("controller close",)]
    it.donnie.connection.search = None
    it.handle.controller.left_for_linear, it.donnie.stop_real_robot = False, lambda: False
    assert (handle.give_up_search(), handle.left_for_linear, handle.stop_real_robot()) == (False,) * 3


@pytest.mark.parametrize(
    ("is_busy", "running", "runs"), [(False, [], False), (True, [], True), (False, ["bob"], True)]
)
def test_something_runs_if_the_robot_or_another_one_does(
    is_busy: bool, running: list[str], runs: bool
) -> None:
    it = Handle()
    it.runs.is_busy, it.team.running = is_busy, running
    assert it.handle.runs is runs


@pytest.mark.parametrize(("typed", "kept"), [("FW 1", ["FW 1"]), ("FW 1\n", ["FW 1"]), (" \n", []), ("", [])])
def test_what_was_typed_before_there_is_a_session_is_kept_once_until_the_session_keeps_it(
    tmp_path: Path, typed: str, kept: list[str]
) -> None:
    def copies() -> list[str]:
        found = sorted(tmp_path.rglob("*.gd"))
        assert not any(each.read_text().endswith("\n\n") for each in found)
        return [read_copy(each).text for each in found]

    text = [typed]
    it = Handle(has_controller=False, typed=lambda: text[0], copies=tmp_path / "unsaved")
    it.handle.keep_text()
    assert copies() == kept
    if kept:
        text[0] = "FW 2"
        it.handle.keep_text()
        assert copies() == ["FW 2"]
    it.handle.controller = Handle().handle.controller
    it.handle.keep_text()
    assert copies() == []
