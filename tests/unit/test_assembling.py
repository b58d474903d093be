"""A session as one thing: what its parts are asked for when it is stopped, rescued, connected and closed."""

from __future__ import annotations

import json
import os
import threading
from contextlib import ExitStack
from pathlib import Path
from types import SimpleNamespace as Part
from typing import Any

import pytest
from msgspec.structs import replace

from donnie_tui import bootstrap
from donnie_tui.bootstrap import Donnie, Notices, assemble
from donnie_tui.core import team
from donnie_tui.core.events import Announced, Answered, RunEnded, RunStarted, Stamped
from donnie_tui.core.program_files import DocumentError
from donnie_tui.i18n.words import Words
from donnie_tui.process import disconnection
from donnie_tui.process.confinement import Confinement, confine
from donnie_tui.settings.settings import Settings, SettingSource, resolve
from tests.timeouts import TIMEOUT


class Session:
    """Parts that note what they are asked for."""

    def __init__(self, *, is_real: bool = False, is_running: bool = False, **connection: Any) -> None:
        self.did: list[Any] = []
        closing = ExitStack()
        closing.callback(self.did.append, "closed")
        hub = Part(publish=self.did.append)
        self.team: Any = Part(
            has_unstopped_run=is_running,
            stop=lambda: self.did.append("stopped"),
            chosen=Part(hub=hub, name="bob"),
            chosen_name="bob",
        )
        self.connection: Any = Part(
            is_real=is_real, wait_until_standing=lambda: self.did.append("stands"), **connection
        )
        self.site: Any = Part(is_saved=False, world=Part())
        self.shared: Any = Part(
            get_ready=lambda: self.did.append("ready"), is_holding=True, held_by=lambda name: (name, 3)
        )
        parts: Any = (self.site, self.team, self.connection, object(), object(), object(), self.shared)
        site, team, connection, chronicle, outlets, notices, shared = parts
        self.donnie = Donnie(
            Words("en"), site, team, connection, chronicle, outlets, notices, shared, closing
        )


def test_the_notices_of_a_start_have_an_order() -> None:
    assert Notices(("a world",), ("a setting",), ("a voice",), ("a robot",)).all == (
        *("a world", "a setting", "a voice", "a robot"),
    )


def test_a_session_is_stopped_before_it_is_closed() -> None:
    it = Session()
    it.donnie.close()

    assert it.did == ["stopped", "closed"]


def test_a_recording_has_the_end_of_a_run_that_is_stopped_by_closing(
    folders: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The run ends as late as it may: once closing waits for it."""
    waits, close = threading.Event(), team.Team.close

    def wait_for_the_run(robots: team.Team) -> None:
        waits.set()
        close(robots, TIMEOUT)

    def end_late(stamped: Stamped) -> None:
        if isinstance(stamped.event, RunEnded):
            waits.wait(TIMEOUT)

    monkeypatch.setattr(team.Team, "close", wait_for_the_run)
    files = {"record": "lesson.jsonl", "events": "events.jsonl"}
    donnie = assemble(Settings(world="open_floor", speech="off", sound=False, **files), terminal=True)
    donnie.session.hub.subscribe_to_own(end_late)
    donnie.session.start("WAIT 1000", "typed").wait_until_read(TIMEOUT)
    donnie.close()

    for name in files.values():
        last = json.loads((folders / name).read_text().splitlines()[-1])
        assert (last["event"], last["outcome"]) == ("run_ended", "stopped")


def test_answers_are_published_one_by_one() -> None:
    it = Session()
    it.donnie.publish_answers("One.", "Two.")
    it.donnie.say("goodbye")

    assert it.did == [Answered("One."), Answered("Two."), Answered(Words("en")("goodbye"))]


@pytest.mark.parametrize(
    ("is_real", "is_running", "did", "was_driving"),
    [
        (True, True, ["stopped", "stands"], True),
        (True, False, ["stopped", "stands"], False),
        (False, True, ["stands"], False),
    ],
)
def test_only_a_real_robot_is_stopped_and_it_is_reported_if_its_program_ran(
    is_real: bool, is_running: bool, did: list[str], was_driving: bool
) -> None:
    it = Session(is_real=is_real, is_running=is_running)
    assert it.donnie.stop_real_robot() is was_driving
    assert it.did == did
    it.did.clear()
    it.donnie.stop_unreachable_robot()

    news = [Announced("link", Words("en")("network-stopped"))] if was_driving else []
    assert it.did == [*did, *news]


@pytest.mark.parametrize(("has_run_away", "code", "said"), [(False, 130, False), (True, 1, True)])
def test_a_robot_that_still_drives_is_the_exit_code(has_run_away: bool, code: int, said: bool) -> None:
    it, reported = Session(has_run_away=has_run_away), list[str]()

    assert it.donnie.code_at_end(130, reported.append) == code
    assert reported == ([Words("en")("link-runaway")] if said else [])


@pytest.mark.parametrize(("is_real", "did"), [(True, []), (False, ["ready"])])
def test_a_simulated_robot_gets_ready_to_move(is_real: bool, did: list[str]) -> None:
    it = Session(is_real=is_real)
    it.donnie.get_ready_to_move()

    assert it.did == did
    assert it.donnie.holds_something
    assert it.donnie.held_thing == ("bob", 3)


def test_the_devices_are_those_of_the_board_or_of_the_simulated_robot() -> None:
    board = Session(mounted=("a sonar",), is_board=True)
    assert board.donnie.mounted() == ("a sonar",)
    assert Session(mounted=None, is_board=True).donnie.mounted() == ()


# --- a changed world


@pytest.fixture
def folders(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def rescued(monkeypatch: pytest.MonkeyPatch, problem: Exception | None = None) -> Path | None:
    it, building = Session(), Part(text_at=lambda file: f"world for {file.name}")
    monkeypatch.setattr(Donnie, "building", lambda _: building)
    if problem is not None:

        def fail(*_: object) -> None:
            raise problem

        monkeypatch.setattr(bootstrap, "write_program", fail)
    return it.donnie.rescue_world()


def test_a_changed_world_is_kept_where_its_learner_finds_it(
    folders: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = rescued(monkeypatch)
    assert file is not None
    assert file.parent == folders / "state" / "donnie"
    assert file.read_text() == f"world for {file.name}"
    confine(Confinement(str(folders)))
    try:
        inside = rescued(monkeypatch)
    finally:
        confine(None)
    assert inside is not None
    assert inside.parent == folders, "a hidden folder is of no use"
    it = Session()
    it.site.is_saved = True
    assert it.donnie.rescue_world() is None


@pytest.mark.parametrize("problem", [DocumentError("file-unwritable", "x"), OSError("full")])
def test_a_world_that_can_not_be_kept_harms_nothing(
    folders: Path, monkeypatch: pytest.MonkeyPatch, problem: Exception
) -> None:
    assert rescued(monkeypatch, problem) is None


# --- the robot of a start


@pytest.mark.parametrize(
    ("options", "port", "asked"),
    [
        ({}, None, "sim"),
        ({}, "/dev/x", "serial:/dev/x"),
        ({"robot": "double"}, None, "double"),
        ({"robot": "double"}, "/dev/x", "double"),
    ],
)
@pytest.mark.parametrize("terminal", [True, False])
def test_the_robot_is_that_of_the_settings_or_of_the_configuration_file(
    options: dict[str, str], port: str | None, asked: str, terminal: bool
) -> None:
    settings, _ = resolve(options, {}, {})
    did = list[str]()

    def connect(robot: str) -> tuple[str, ...]:
        did.append(f"connect {robot}")
        connection.robot = robot
        return ()

    connection: Any = Part(robot="sim", connect=connect, insist=lambda robot: did.append(f"insist {robot}"))
    world: Any = Part(physical_port=port)
    notices = bootstrap._connect_robot(connection, settings, Words("en"), world, terminal)

    assert settings.source_of("robot") is (SettingSource.OPTION if options else SettingSource.DEFAULT)
    assert did == [f"{'connect' if terminal else 'insist'} {asked}"]
    is_said = terminal and asked != "sim"
    assert notices == ((Words("en")("link-connected"),) if is_said else ())


def test_a_missing_robot_is_a_notice() -> None:
    settings, _ = resolve({"robot": "double"}, {}, {})
    connection: Any = Part(robot="double", connect=lambda _: ("No robot.",))

    assert bootstrap._connect_robot(
        connection, settings, Words("en"), Part(physical_port=None), terminal=True
    ) == ("No robot.",)


def test_a_voice_that_was_decided_on_is_said_once_for_a_learner(folders: Path) -> None:
    audible: Any = Part(decided="")
    assert bootstrap._decided(audible, Words("en")) == ()
    audible.decided = "answer-new"
    first = bootstrap._decided(audible, Words("en"))

    assert first == (Words("en")("answer-new"),)
    assert bootstrap._decided(audible, Words("en")) == ()


def test_the_sessions_of_a_world_with_one_robot_have_no_name_in_events(folders: Path) -> None:
    for world, names in (("open_floor", [None]), ("two_robots", ["alice", "bob"])):
        donnie = assemble(Settings(world=world, speech="off", sound=False), terminal=True)
        assert [donnie.team.session(each).hub.robot for each in donnie.team.names] == names
        assert donnie.team.has_several is (len(names) > 1)
        donnie.close()


def test_the_files_of_a_session_are_in_use(folders: Path) -> None:
    settings = Settings(world="open_floor", speech="off", sound=False, record="a.rec", events="e.jsonl")
    donnie = assemble(settings, terminal=True)
    try:
        assert "a.rec" in donnie.in_use
        assert "e.jsonl" in donnie.in_use
        assert "b.rec" not in donnie.in_use
    finally:
        donnie.close()


def test_the_colours_of_a_world_are_those_that_its_robot_sees() -> None:
    colours = bootstrap.colours_of_world(Settings(world="colour_garden"), Words("en"))

    assert {"red", "green", "blue"} <= {each.lower() for each in colours}


# --- opened and closed


FLOOR = Settings(world="open_floor", speech="off", sound=False)


def test_what_was_opened_is_closed_if_a_session_can_not_be_made(monkeypatch: pytest.MonkeyPatch) -> None:
    did = list[str]()

    def fail(settings: Settings, closing: ExitStack, *_: object, **__: object) -> None:
        closing.callback(did.append, "closed")
        raise KeyboardInterrupt

    monkeypatch.setattr(bootstrap, "_assembled", fail)
    with pytest.raises(KeyboardInterrupt):
        assemble(FLOOR, terminal=True)

    assert did == ["closed"]


@pytest.mark.parametrize("is_remote", [False, True])
def test_a_network_is_watched_where_there_is_one_until_the_session_is_closed(
    folders: Path, monkeypatch: pytest.MonkeyPatch, is_remote: bool
) -> None:
    did = list[Any]()

    class Watch:
        def __init__(self, on_lost: Any, environment: Any) -> None:
            did.append((on_lost, environment is os.environ))

        def close(self) -> None:
            did.append("closed")

    monkeypatch.setattr(disconnection, "NetworkWatch", Watch)
    monkeypatch.setattr(bootstrap, "loaded", lambda: did.append("loaded"))
    monkeypatch.delenv("SSH_CONNECTION", raising=False)
    if is_remote:
        monkeypatch.setenv("SSH_CONNECTION", "1.2.3.4 5 6.7.8.9 10")
    donnie = assemble(FLOOR, terminal=True)
    assert did == ([(donnie.stop_unreachable_robot, True)] if is_remote else []) + ["loaded"]
    donnie.close()

    assert did[1:] == (["loaded", "closed"] if is_remote else [])


def test_a_challenge_has_the_seed_of_its_first_start(folders: Path) -> None:
    donnie = assemble(replace(FLOOR, world="challenge:1", seed=99), terminal=True)
    try:
        seeds = list[int]()
        donnie.session.hub.subscribe(
            lambda stamped: seeds.extend(
                [stamped.event.seed] if isinstance(stamped.event, RunStarted) else []
            )
        )
        assert donnie.session.start("FW 1", "a.gd").wait(TIMEOUT)
        donnie.session.hub.wait_until_delivered(TIMEOUT)
        assert seeds == [donnie.world.rules.variant[0].seed]
    finally:
        donnie.close()


def test_the_folders_of_a_workspace_are_those_of_the_account(folders: Path) -> None:
    workspace = bootstrap.open_workspace(str(folders / "own"))
    workspace.begin_with("bob")
    workspace.replace("FW 1\n" * 6, None, in_file="")
    workspace.write_copies()

    assert [each.name for each in (folders / "own").iterdir()] == ["unsaved"]
    assert len([*(folders / "own" / "unsaved").iterdir()]) == 1


def test_a_program_that_keeps_its_turn_is_watched_unless_it_waits_for_its_voice(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    did = list[Any]()

    class Monitor:
        def __init__(self, *given: object, is_excused: Any) -> None:
            did.append(given)
            self.is_excused = is_excused

        def watch(self) -> None:
            did.append([bool(self.is_excused())])
            speech_wait.waiting = 1
            did.append([bool(self.is_excused())])

        def close(self) -> None:
            did.append("closed")

    monkeypatch.setattr(team, "TurnMonitor", Monitor)
    shared, speech_wait = Part(turn=lambda: None), Part(waiting=0)
    with ExitStack() as closing:
        bootstrap._announce_hold_ups("team", shared, "words", speech_wait, closing)  # type: ignore[arg-type]
        assert did == [("team", shared.turn, "words"), [False], [True]]

    assert did[-1] == "closed"
