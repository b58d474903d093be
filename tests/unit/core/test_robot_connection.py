"""A session changes its robot: to a real one, to a server's, to a simulated board, and back."""

from __future__ import annotations

import io
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from queue import SimpleQueue
from typing import TYPE_CHECKING, Any

import pytest

from devices.board_simulator.floor import CHASSIS_2018, Chassis
from devices.board_simulator.robot import SimulatedSerialRobot
from devices.port_exchange import NOT_NEEDED
from devices.ports.robot import LinkNotice, Pace, Pose, RobotProblem, Watcher
from devices.serial_ports import FoundPort, SameBoard, allow_only
from donnie_tui.core.events import Announced, BeltShown, Event, Link, Spoke, Stamped
from donnie_tui.core.session import Busy
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.robot import connection as module
from donnie_tui.robot.board_floor import place_of
from donnie_tui.robot.connection import Connection, Guard, make_measurable
from donnie_tui.robot.player_robot import PlayerRobot
from donnie_tui.robot.search import Search
from donnie_tui.settings.settings import Settings
from donnie_tui.world.loading import inhabited_world
from tests.floor import Floor
from tests.timeouts import TIMEOUT

if TYPE_CHECKING:
    from donnie_tui.robot.search import Connectable

PORT = "/dev/robot-of-no-machine"


class RealRobot(SimulatedSerialRobot):
    """A robot at a port, with what happens to it."""

    problem: RobotProblem | None = None
    port = PORT
    may_drive_on = has_run_away = False

    def __init__(self, pace: Pace, watcher: Watcher) -> None:
        self.calls: list[str] = []
        super().__init__(pace=pace, watcher=watcher, speed=None)

    def connect(self) -> None:
        self.calls.append("connect")
        if self.problem is not None and len(self.calls) > 1:
            raise self.problem
        super().connect()

    def wait_until_standing(self) -> None:
        self.calls.append("stand")

    def close(self) -> None:
        self.calls.append("close")
        super().close()


class Connected:
    """A session on an empty floor, its connection, and the guards of its robots."""

    def __init__(self, patch: pytest.MonkeyPatch, settings: Settings) -> None:
        self.floor, self.words = Floor(), Words()
        self.session = self.floor.session
        self.robots: list[RealRobot] = []
        self.made: list[tuple[str, dict[str, Any]]] = []
        self.guards: list[Any] = []
        self.on_made: Callable[[RealRobot], object] = lambda _: None
        patch.setattr(module, "_serial_robot", self._make)
        patch.setattr(module, "Guard", self._guard)
        world = inhabited_world("corridor", self.words)
        self.start = world.start()
        self.connection = Connection(
            settings, self.words, world, self.session, found=lambda: (), stable=lambda port: port
        )

    def _make(self, port: str, settings: Settings, pace: Pace, **given: Any) -> RealRobot:
        robot = RealRobot(pace, given["watcher"])
        self.made.append((port, given))
        self.robots.append(robot)
        self.on_made(robot)
        return robot

    def _guard(self, port: str) -> Any:
        self.guards.append(port)
        return self

    def end(self, *, may_drive_on: bool) -> None:
        self.guards.append(may_drive_on)

    @property
    def links(self) -> list[Event]:
        return [each for each in self.floor.events if isinstance(each, Link)]


@pytest.fixture
def connected(monkeypatch: pytest.MonkeyPatch) -> Iterator[Connected]:
    made = Connected(monkeypatch, Settings(camera=None))
    yield made
    made.connection.close()


def test_while_the_robot_is_being_closed_each_thread_waits_and_knows_that_it_drives(
    connected: Connected,
) -> None:
    """Else a process that ends meanwhile does not report that its robot has run away."""
    connection = connected.connection
    connection.connect("serial:/dev/a")
    robot, ended = connected.robots[-1], SimpleQueue[str]()
    may_end, close = threading.Event(), robot.close

    def close_slowly() -> None:
        ended.put("begun")
        robot.has_run_away = True
        may_end.wait(TIMEOUT)
        close()

    robot.close = close_slowly  # type: ignore[method-assign]

    def drop() -> None:
        connection.close()
        ended.put("closed")

    threads = [threading.Thread(target=drop) for _ in range(2)]
    for each in threads:
        each.start()
    assert [ended.get(timeout=TIMEOUT) for _ in threads] == ["begun", "begun"]
    assert connection.has_run_away
    may_end.set()
    for each in threads:
        each.join()

    assert connection.has_run_away
    assert connected.guards == ["/dev/robot-of-no-machine", False]


def test_a_session_begins_with_its_simulated_robot(connected: Connected) -> None:
    connection = connected.connection
    assert (connection.robot, connection.is_real, connection.is_board) == ("sim", False, False)
    assert (connection.mounted, connection.has_camera, connection.has_run_away) == (None, False, False)
    connection.wait_until_standing()
    connection.close()
    assert connection.connect("sim") == ()
    assert connected.links == []


def test_a_real_robot_is_guarded_until_it_is_left(connected: Connected) -> None:
    connection = connected.connection
    assert connection.connect(f"serial:{PORT}") == ()
    (robot,) = connected.robots
    (port, given) = connected.made[0]

    assert (port, given["start"], given["watcher"] is not None) == (PORT, connected.start, True)
    assert (connection.robot, connection.is_real, connection.is_board) == (f"serial:{PORT}", True, True)
    assert connected.links == [Link("connected", f"serial:{PORT}")]
    assert connected.guards == [PORT]
    assert robot.camera is None
    assert not connection.search.give_up()
    connection.wait_until_standing()
    assert connection.connect("sim") == ()

    assert robot.calls == ["connect", "connect", "stand", "close"]
    assert connected.guards == [PORT, False]
    assert (connection.robot, connection.is_real) == ("sim", False)
    connection.close()
    assert connected.guards == [PORT, False]


def test_a_robot_that_may_drive_on_keeps_its_guard_and_one_that_ran_away_is_remembered(
    connected: Connected,
) -> None:
    connection = connected.connection
    connection.connect(f"serial:{PORT}")
    robot = connected.robots[0]
    robot.may_drive_on = True
    assert not connection.has_run_away
    robot.has_run_away = True
    assert connection.has_run_away
    connection.close()
    assert connected.guards == [PORT, True]
    assert connection.has_run_away
    connection.connect(f"serial:{PORT}")
    assert not connection.has_run_away


@pytest.mark.parametrize("is_insisted", [False, True])
def test_a_robot_that_does_not_answer_is_left_for_the_simulator(
    connected: Connected, is_insisted: bool
) -> None:
    connection = connected.connection
    problem = RobotProblem("no-server", port=PORT, reason="Connection refused")
    connected.on_made = lambda robot: setattr(robot, "problem", problem)
    said = [
        connected.words("problem-no-server", port=PORT, reason="Connection refused"),
        connected.words("remedy-no-server"),
    ]
    if is_insisted:
        with pytest.raises(Unusable) as caught:
            connection.insist(f"serial:{PORT}")
        assert caught.value.sentence == " ".join(said)
    else:
        assert connection.connect(f"serial:{PORT}") == (*said, connected.words("connect-instead"))

    assert (connection.robot, connected.links) == ("sim", [])
    assert connected.robots[0].calls[-1] == "close"
    assert connected.guards == [PORT, False]
    assert not connection.search.give_up()
    assert str(connected.floor.run("FW 2", fresh=True)).endswith("COMPLETED")


def test_a_program_that_was_started_during_a_search_in_vain_has_stopped_by_its_end(
    connected: Connected,
) -> None:
    session = connected.session

    class Meanwhile(Search):
        def connect(self, robot: Connectable) -> None:
            session.start("WHILE 1 == 1 DO\nVAR a = 1\nEND WHILE", "a.gd")
            super().connect(robot)

    connected.on_made = lambda robot: setattr(robot, "problem", RobotProblem("no-answer", port=PORT))
    connected.connection.search = Meanwhile()
    assert connected.connection.connect(f"serial:{PORT}")[-1] == connected.words("connect-instead")

    assert (session.run, connected.connection.robot) == (None, "sim")
    assert connected.guards == [PORT, False]


def test_without_a_board_the_simulator_is_used(connected: Connected) -> None:
    said = connected.connection.connect("serial")

    words = connected.words
    assert said == (f"{words('problem-no-board')} {words('remedy-simulator')}", words("connect-instead"))
    with pytest.raises(Unusable):
        connected.connection.insist("serial")
    assert connected.connection.robot == "sim"
    assert not connected.connection.search.give_up()


def test_a_robot_is_not_changed_while_a_program_runs(connected: Connected) -> None:
    run = connected.session.start("WHILE 1 == 1 DO\nVAR a = 1\nEND WHILE", "a.gd")
    with pytest.raises(Busy):
        connected.connection.connect("double")
    with pytest.raises(Busy):
        connected.connection.insist("double")
    connected.session.stop()
    assert run.wait(TIMEOUT)
    connected.session.wait_for_stop()

    assert connected.connection.robot == "sim"
    assert connected.connection.connect("double") == ()


def test_a_simulated_board_is_as_fast_as_the_session_and_has_no_guard(connected: Connected) -> None:
    connection, session = connected.connection, connected.session
    session.speed = 7.0
    assert connection.connect("double") == ()
    assert (connection.robot, connection.is_real, connection.is_board) == ("double", False, True)
    assert session.speed == 7.0
    assert (session.pose, connected.links) == (connected.start, [Link("connected", "double")])
    session.speed = 3.0
    connection.connect("sim")

    assert session.speed == 3.0
    assert connected.guards == []


def test_a_real_robot_leaves_the_speed_of_the_simulator_as_it_is(connected: Connected) -> None:
    connected.connection.connect(f"serial:{PORT}")
    connected.session.speed = 7.0
    connected.connection.connect("sim")

    assert connected.session.speed is None  # as it began


@pytest.mark.parametrize(
    ("robot", "camera", "has_camera"),
    [("sim", "/dev/null", False), ("double", "/dev/null", True), ("double", None, False)],
)
def test_only_a_board_has_a_camera(
    monkeypatch: pytest.MonkeyPatch, robot: str, camera: str | None, has_camera: bool
) -> None:
    made = Connected(monkeypatch, Settings(camera=camera))
    made.connection.connect(robot)

    assert made.connection.has_camera is has_camera
    made.connection.close()


def test_only_what_happens_to_a_connection_later_is_reported_by_the_link(connected: Connected) -> None:
    connected.connection.connect(f"serial:{PORT}")
    report = connected.made[0][1]["on_notice"]
    for notice in LinkNotice:
        report(notice, "why")

    assert connected.links[1:] == [
        Link(each.value, "why") for each in LinkNotice if each is not LinkNotice.CONNECTED
    ]


def test_a_server_that_was_not_named_is_not_connected_to(connected: Connected) -> None:
    allow_only(["/dev/zero"])
    try:
        said = connected.connection.connect("player://localhost:6665")
    finally:
        allow_only(None)

    words = connected.words
    assert said[0] == words("problem-port-not-named", port="player://localhost:6665", reason="")
    assert said[-1] == words("connect-instead")


def test_a_slow_search_is_reported_to_whom_it_concerns_by_then(connected: Connected) -> None:
    slow: list[bool] = []
    connected.connection.connect(f"serial:{PORT}")
    connected.connection.search.on_slow = lambda: slow.append(True)
    connected.made[0][1]["on_slow"]()

    assert slow == [True]


def test_a_changed_robot_begins_where_its_world_says(connected: Connected) -> None:
    connected.floor.run("FW 3")
    stamped: list[Stamped] = []
    connected.session.hub.subscribe(stamped.append)
    connected.connection.connect("double")

    assert connected.session.pose == connected.start != Pose(0, 3, 0)


def test_the_devices_and_the_robots_to_choose_are_those_that_are_there(
    connected: Connected, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(RealRobot, "mounted", ("an eye",), raising=False)
    connected.connection.connect(f"serial:{PORT}")
    assert connected.connection.mounted == ("an eye",)
    assert [each.robot for each in connected.connection.options()] == ["sim", "double"]

    board = FoundPort(PORT, PORT, is_board=True)
    monkeypatch.setattr("devices.serial_ports.list_ports", lambda: (board,))
    search = Search()
    world = inhabited_world("corridor", connected.words)
    other = Connection(Settings(), connected.words, world, connected.session, search=search)
    assert [each.robot for each in other.options()] == ["sim", f"serial:{PORT}", "double"]
    assert other.search is search


@pytest.mark.parametrize(
    ("profile", "chassis"), [("2018", CHASSIS_2018), ("auto", Chassis()), ("2016", Chassis())]
)
def test_a_simulated_board_is_that_of_its_profile_at_the_start_of_its_world(
    monkeypatch: pytest.MonkeyPatch, profile: str, chassis: Chassis
) -> None:
    made = Connected(monkeypatch, Settings(profile=profile, camera="/dev/null"))
    made.connection.connect("double")
    robot = made.connection._now.robot

    assert isinstance(robot, SimulatedSerialRobot)
    assert robot.board.wheels.chassis == chassis
    assert robot.board.wheels.place == place_of(made.start)
    assert robot.camera is not None
    assert robot.time() == 0.0
    made.connection.close()


def test_a_server_gets_the_words_and_the_belt_of_the_program_until_its_robot_is_left(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    made = Connected(monkeypatch, Settings(camera_view=75.0))
    taken: list[object] = []
    monkeypatch.setattr(PlayerRobot, "say", lambda _, text: taken.append(text))
    monkeypatch.setattr(PlayerRobot, "show_belt", lambda _, levels: taken.append(levels))
    robot: Any = made.connection._make_player("player://host:1", _Pace(), object())  # type: ignore[arg-type]
    assert isinstance(robot, PlayerRobot)
    assert (robot.port, robot.start, robot.chosen_view) == ("player://host:1", made.start, 75.0)
    levels = (0, 0, 0, 3, *(0,) * 10)
    events: tuple[Any, ...] = (
        Spoke("hi"),
        Announced("moved", "I walked."),
        BeltShown(levels),
        BeltShown(levels),
    )
    for event in events:
        made.session.hub.publish(event)
    assert taken == ["hi", levels]
    for leave in robot.leave:
        leave()
    for event in (Spoke("ho"), BeltShown((3,) * 14)):
        made.session.hub.publish(event)
    assert taken == ["hi", levels]


def test_robot_and_belt_have_no_port_in_common(monkeypatch: pytest.MonkeyPatch) -> None:
    made = Connected(monkeypatch, Settings(belt=PORT))
    said = made.connection.connect(f"serial:{PORT}")

    assert said == (made.words("belt-same-port", port=PORT), made.words("connect-instead"))
    assert (made.robots, made.guards) == ([], [])


@pytest.mark.parametrize("is_given", [True, False])
def test_a_robot_has_the_name_that_stays_and_its_camera(
    monkeypatch: pytest.MonkeyPatch, is_given: bool
) -> None:
    made = Connected(monkeypatch, Settings(camera="/dev/null"))
    board = FoundPort("/dev/x", "/dev/x-stable", is_board=True)
    names: dict[str, Any] = {"found": lambda: (board,), "stable": lambda port: f"{port}-for-ever"}
    monkeypatch.setattr("devices.serial_ports.list_ports", names["found"])
    monkeypatch.setattr("devices.serial_ports.stable_name", names["stable"])
    world = inhabited_world("corridor", made.words)
    connection = Connection(
        Settings(camera="/dev/null"), made.words, world, made.session, **(names if is_given else {})
    )
    assert connection.connect("serial") == ()
    assert connection.robot == "serial:/dev/x-stable-for-ever"
    assert made.made[0][0] == "/dev/x-stable-for-ever"
    assert made.robots[0].camera is not None
    connection.close()


def test_a_robot_at_a_port_has_its_reset_its_measures_and_the_timeouts_of_the_computer(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("DONNIE_ROBOT_TIMEOUTS", "4")
    links: list[tuple[Any, ...]] = []
    robots: list[tuple[Any, ...]] = []
    monkeypatch.setattr(
        "devices.serial_robot.link.SerialLink", lambda *given, **more: links.append((given, more)) or "link"
    )
    monkeypatch.setattr(
        "devices.serial_robot.robot.SerialRobot",
        lambda *given, **more: robots.append((given, more)) or "robot",
    )
    settings = Settings(reset_line="gpio:17", wheel_radius=0.03)
    others: dict[str, Any] = {"watcher": object(), "start": Pose(1, 2, 3), "on_notice": object()}
    slow, pace = object(), _Pace()
    assert module._serial_robot(PORT, settings, pace, on_slow=slow, **others) == "robot"  # type: ignore[comparison-overlap]

    [((port, limits, on_notice), more)] = links
    assert (port, limits.silence, limits.first_answer, on_notice) == (PORT, 2.0, 24.0, others["on_notice"])
    assert (more["reset"].pin, more["on_slow"]) == (17, slow)
    assert isinstance(more["open_port"], SameBoard)
    [((link, config), more)] = robots
    assert (link, config.stall, config.wheel_radius) == ("link", 2.0, 0.03)
    assert more == {"pace": pace, **others}


def test_wheels_are_measured_at_a_simulated_board_or_at_a_port(monkeypatch: pytest.MonkeyPatch) -> None:
    robot = make_measurable(
        Settings(robot="double", speed=9.0, axle_length=0.08), Words(), _Pace(), lambda *_: None
    )
    assert isinstance(robot, SimulatedSerialRobot)
    assert robot.speed == 9.0
    monkeypatch.setattr(module, "_serial_robot", lambda port, *_, **__: port)
    assert make_measurable(Settings(robot=f"serial:{PORT}"), Words(), _Pace(), lambda *_: None) == PORT
    monkeypatch.setattr("devices.serial_ports.list_ports", tuple)
    words = Words()
    with pytest.raises(Unusable) as caught:
        make_measurable(Settings(robot="serial"), words, _Pace(), lambda *_: None)
    assert caught.value.sentence == f"{words('problem-no-board')} {words('remedy-calibrate')}"


class _Pace:
    def sleep(self, seconds: float) -> bool:
        return True


# --- the guard


class Process:
    def __init__(self, is_over: bool = True) -> None:
        self.stdin = io.BytesIO()
        self.stdin.close = lambda: None  # type: ignore[method-assign]
        self._is_over = is_over

    def poll(self) -> int | None:
        return 0 if self._is_over else None


@pytest.mark.parametrize(("may_drive_on", "written"), [(True, b""), (False, NOT_NEEDED)])
def test_a_guard_ends_at_once_unless_its_robot_may_drive_on(
    monkeypatch: pytest.MonkeyPatch, may_drive_on: bool, written: bytes
) -> None:
    started: list[tuple[Any, ...]] = []
    process, others = Process(is_over=False), [Process(is_over=True), Process(is_over=False)]

    def start(command: list[str], **given: object) -> Process:
        started.append((command, given))
        return process

    monkeypatch.setattr(subprocess, "Popen", start)
    monkeypatch.setattr(module, "_ENDING", others)
    guard = Guard(PORT)
    guard.end(may_drive_on=may_drive_on)

    assert started == [
        (
            [sys.executable, "-P", "-m", "devices.port_exchange", PORT],
            {
                "stdin": subprocess.PIPE, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL,
                "start_new_session": True,
            },
        )
    ]  # fmt: skip
    assert process.stdin.getvalue() == written
    assert others == [others[0], process]
    assert others[0] is not process


def test_a_robot_whose_guard_can_not_be_started_has_none(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object, **__: object) -> None:
        raise OSError(12, "Cannot allocate memory")

    monkeypatch.setattr(subprocess, "Popen", fail)
    Guard(PORT).end(may_drive_on=False)


def test_a_guard_that_is_gone_needs_no_end(monkeypatch: pytest.MonkeyPatch) -> None:
    class Gone(io.BytesIO):
        def write(self, data: Any) -> int:
            raise BrokenPipeError

    process, ending = Process(), list[Any]()
    process.stdin = Gone()
    monkeypatch.setattr(subprocess, "Popen", lambda *_, **__: process)
    monkeypatch.setattr(module, "_ENDING", ending)
    Guard(PORT).end(may_drive_on=False)

    assert ending == []
