"""GoDonnie's robot at a Player server: at our own, at one that plays recorded bytes, and at bad ones."""

import socket
import struct
import threading
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import closing, suppress
from pathlib import Path

import pytest
from msgspec.structs import replace

from devices.player.codec import BANNER_SIZE, MessageReader, MessageType, PlayerMessage, banner, body_of
from devices.ports.robot import STEP, Bearing, Grip, LinkNotice, Motion, Pose, RobotProblem, StoppedBy
from donnie_tui.bootstrap import assemble
from donnie_tui.core.events import BeltShown, GripperUsed, Spoke
from donnie_tui.robot import server_link as module
from donnie_tui.robot.player_robot import STUCK, PlayerRobot
from donnie_tui.robot.server_link import RobotPart, ServerLink, WheelState
from donnie_tui.settings.settings import Settings
from sim.sensors import Device
from tests.player.recordings import sides
from tests.player.room import DONNIE_CONFIGURATION, HOST, ServedRoom, SteppedRobot
from tests.timeouts import TIMEOUT

SCENE = """
define sonar sensor ( range [ 0.02 3 ] fov 15 )
model ( name "red wall" size [ 0.1 0.5 1 ] pose [ 1.05 0 0 0 ] color "red" )
model ( name "blue wall" size [ 0.5 0.1 1 ] pose [ 0 1.55 0 0 ] color "blue" )
model ( name "green wall" size [ 0.5 0.1 1 ] pose [ 0 -1.05 0 0 ] color "green" )
model ( name "low" size [ 0.1 1 1 ] pose [ -0.55 0 0 0 ] ranger_return -1 )
position
(
  name "alice" size [ 0.1 0.1 0.2 ] pose [ 0 0 0 0 ] localization "gps"
  ranger ( sonar( pose [ 0 0 0 -45 ] ) sonar( pose [ 0.05 0 0 0 ] ) sonar( pose [ 0 0 0 45 ] )
           sonar( pose [ 0 0 0 135 ] ) sonar( pose [ 0 0 0 180 ] ) sonar( pose [ 0 0 0 -135 ] ) )
  bumper ( size [ 0.01 0.01 0.01 ] bcount 4 blength 0.1 bpose[0] [ 0.06 0.03 0 0 ] bpose[1] [ 0.06 -0.03 0 0 ]
           bpose[2] [ -0.06 0.03 0 180 ] bpose[3] [ -0.06 -0.03 0 180 ] )
  position ( name "head" size [ 0.02 0.02 0.1 ] obstacle_return 0 blob_return 0
    ranger ( sonar( pose [ 0.05 0 0 0 ] ) )
    blobfinder ( range 5 fov 60 image [ 160 120 ] colors_count 3 colors [ "red" "green" "blue" ] ) )
)
"""


SERVED = (
    DONNIE_CONFIGURATION.replace("6691", "7665").partition('driver ( name "gtts"')[0]
    + 'driver ( name "vib_belt" provides [ "7665:speech:1" "7665:dio:1" ] )'
)


class Pace:
    """A program's pace that never waits; ``on_sleep`` may make it stop."""

    def __init__(self) -> None:
        self.on_sleep: Callable[[], bool] = lambda: True

    def sleep(self, seconds: float) -> bool:
        return self.on_sleep()


class Reports:
    def __init__(self) -> None:
        self.motions: list[Motion] = []
        self.passed: list[Pose] = []
        self.on_progress: Callable[[], object] = lambda: None

    def progressed(self, motion: Motion, pose: Pose) -> None:
        self.motions.append(motion)
        self.on_progress()

    def passing(self, pose: Pose) -> None:
        self.passed.append(pose)

    def sense_failed(self, problem: RobotProblem) -> None:
        raise problem


class Driven:
    """A robot at a server of a room."""

    def __init__(
        self, folder: Path, scene: str = SCENE, configuration: str = SERVED, index: str = ""
    ) -> None:
        self.room = ServedRoom(folder, configuration, scene)
        self.pace, self.reports = Pace(), Reports()
        self.notices: list[LinkNotice] = []
        self.robot = SteppedRobot(
            self.room, self.pace, self.reports, lambda notice, _: self.notices.append(notice), index
        )
        self.link = self.robot.stepped
        self.robot.start = Pose(0, 0, 90)

    def truth(self) -> tuple[float, float, float]:
        here = self.room.stations._loop.drives["alice"].state().truth
        return here.x, here.y, here.yaw

    def end_server(self) -> None:
        self.link.let_go()
        self.room.close()

    def close(self) -> None:
        self.robot.close()
        self.room.close()


@pytest.fixture
def driven(tmp_path: Path) -> Iterator[Driven]:
    with closing(Driven(tmp_path)) as made:
        made.robot.connect()
        yield made


def wait_until(condition: Callable[[], bool]) -> None:
    tick = threading.Event()
    for _ in range(100 * TIMEOUT):
        if condition():
            return
        tick.wait(0.01)
    raise AssertionError("it never came to that")


def test_a_walk_ends_within_a_fiftieth_of_a_step_of_where_it_should(driven: Driven) -> None:
    for _ in range(4):
        assert driven.robot.forward(2).stopped_by is None

    assert driven.truth()[0] == pytest.approx(0.4, abs=0.0015)
    assert driven.robot.pose().x == pytest.approx(8, abs=1e-6)
    assert driven.robot.pose().heading == pytest.approx(90, abs=0.01)
    assert driven.reports.motions == [Motion.FORWARD] * 8


class LateLink(ServerLink):
    """Wheels that obey each speed ``late`` data later. A datum comes every ``per_datum`` seconds."""

    def __init__(self, late: int, per_datum: float) -> None:
        super().__init__(f"player://{HOST}:1")
        self._speeds, self._per_datum = deque([0.0] * (late + 1)), per_datum
        self._now = WheelState(0.0, 0.0, 0.0, 0.0, False, False)
        self.is_there = True  # type: ignore[misc]

    def wheels(self) -> WheelState:
        return self._now

    def drive(self, permit: int, speed: float, turn: float = 0.0) -> None:
        self._speeds[-1] = speed

    def wait_for_data(self, after: float) -> WheelState | None:
        self._now = replace(
            self._now,
            time=self._now.time + self._per_datum,
            x=self._now.x + self._speeds[0] * self._per_datum,
        )
        self._speeds.append(self._speeds[-1])
        self._speeds.popleft()
        return self._now


@pytest.mark.parametrize(
    ("late", "per_datum"), [(0, 0.1), (3, 0.02), (2, 0.05), (4, 0.05), (2, 0.1), (10, 0.1)]
)
@pytest.mark.parametrize("steps", range(1, 6))
def test_a_walk_does_not_end_where_the_robot_crosses_its_goal(
    steps: int, late: int, per_datum: float
) -> None:
    """On a busy machine data come late: the robot may be off by 1 mm, and by 6 mm a second of delay."""
    link = LateLink(late, per_datum)

    assert PlayerRobot(link, pace=Pace()).forward(steps).walked == steps
    for _ in range(late + 1):
        link.wait_for_data(0.0)
    assert link.wheels().x == pytest.approx(steps * STEP, abs=0.001 + 0.006 * (late + 2) * per_datum)


def test_turns_add_up(driven: Driven) -> None:
    for _ in range(5):
        assert driven.robot.turn(90).turned == 90
    assert driven.robot.turn(-400).turned == -400

    assert driven.truth()[2] == pytest.approx((360 - 450 + 400) % 360, abs=0.6)
    assert driven.robot.pose().heading == pytest.approx(90 + 450 - 400, abs=1e-6)
    assert driven.truth()[:2] == pytest.approx((0, 0), abs=1e-6)


def test_sonars_are_in_steps_by_their_direction(driven: Driven) -> None:
    """Walls are 20 steps ahead and 30 to the left; the sonar is a step ahead of the middle."""
    driven.robot.turn(-90)
    assert driven.robot.distance(Bearing.FRONT) == 29
    driven.robot.turn(90)
    assert driven.robot.distance(Bearing.FRONT) == 19
    assert driven.robot.distance(Bearing.BACK) == 60
    assert set(driven.robot.known_distances()) == set(Bearing)


def test_a_walk_ends_before_a_wall_and_at_one_that_no_sonar_sees(driven: Driven) -> None:
    ahead = driven.robot.forward(30)
    behind = driven.robot.backward(40)

    assert (ahead.stopped_by, ahead.walked) == (StoppedBy.OBSTACLE, 18)
    assert behind.stopped_by is StoppedBy.COLLISION
    assert behind.met is not None
    assert abs(behind.met.degrees) == 180
    assert driven.truth()[0] == pytest.approx(-0.45, abs=0.02)


def test_a_robot_that_was_blocked_walks_away_and_turns(driven: Driven) -> None:
    assert driven.robot.backward(40).stopped_by is StoppedBy.COLLISION
    assert driven.robot.forward(3).walked == 3
    assert driven.robot.turn(90).stopped_by is None


def test_a_wait_may_be_longer_than_a_robot_may_be_stuck(driven: Driven) -> None:
    before = driven.robot.time()

    assert driven.robot.wait(STUCK + 2.0)
    assert driven.robot.time() - before >= STUCK + 2.0 - 1e-6


def test_a_robot_that_does_not_move_is_stuck(driven: Driven) -> None:
    driven.room.stations._loop.drives["alice"].is_held = True

    assert driven.robot.forward(1).stopped_by is StoppedBy.STALL


def test_a_scan_turns_the_head_and_sees_colours_with_their_directions(driven: Driven) -> None:
    seen = driven.robot.scan()

    assert [(each.colour, round(each.steps)) for each in seen] == [("blue", 29), ("red", 19), ("green", 19)]
    assert [each.degrees for each in seen] == pytest.approx([-90, 0, 90], abs=8)
    assert driven.robot.colours >= {"red", "green", "blue"}
    head = driven.link.values(RobotPart.HEAD)
    assert head[2] == pytest.approx(0.0, abs=0.02)


def test_a_pause_stops_the_robot_and_a_continuation_lets_it_walk_on(driven: Driven) -> None:
    halted = threading.Event()

    def hold() -> bool:
        if driven.reports.motions and not halted.is_set():
            driven.link.let_go()
            wait_until(lambda: not driven.link.wheels().is_moving)
            halted.set()
        return True

    driven.pace.on_sleep = hold
    done = driven.robot.forward(5)

    assert halted.is_set()
    assert (done.walked, done.stopped_by) == (5, None)


def test_a_halt_ends_a_turn_and_the_robot_stands(driven: Driven) -> None:
    driven.reports.on_progress = driven.robot.halt
    done = driven.robot.turn(180)
    driven.robot.wait_until_standing()

    assert done.stopped_by is StoppedBy.USER
    assert 8 <= done.turned < 180
    assert not driven.link.wheels().is_moving


def test_what_is_said_and_what_the_belt_shows_reaches_the_servers_devices(driven: Driven) -> None:
    driven.robot.say("Olá")
    driven.robot.show_belt((0, 0, 0, 3, 0, 0, 0, 0, 2, 1, 0, 0, 0, 0))
    wait_until(lambda: len(driven.room.notes.taken) >= 16)

    motors = dict(each for _, each in driven.room.notes.taken if isinstance(each, tuple))
    assert ("alice", "Olá") in driven.room.notes.taken
    assert len(motors) == 14
    assert {cell: letter for cell, letter in motors.items() if letter != "P"} == {11: "A", 23: "B", 24: "C"}


def test_a_server_that_ends_is_a_lost_link_and_one_that_is_back_is_used_again(
    driven: Driven, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "AGAIN", 0.05)
    driven.reports.on_progress = driven.end_server
    assert driven.robot.forward(9).stopped_by is StoppedBy.LINK
    for command in (lambda: driven.robot.turn(9), lambda: driven.robot.wait(1), driven.robot.scan):
        with pytest.raises(RobotProblem) as problem:
            command()
        assert problem.value.code == "link-lost"
    wait_until(lambda: driven.notices == [LinkNotice.LOST])
    with closing(ServedRoom(tmp_path, SERVED, SCENE, port=driven.room.port)):
        wait_until(lambda: driven.notices == [LinkNotice.LOST, LinkNotice.RESTORED])
        driven.reports.on_progress = lambda: None
        assert driven.robot.forward(1).walked == 1


def test_the_end_of_the_robot_leaves_the_server_with_a_robot_that_stands(driven: Driven) -> None:
    def leave() -> bool:
        if driven.reports.motions:
            driven.link._shut()
        return True

    driven.pace.on_sleep = leave
    assert driven.robot.forward(9).stopped_by is StoppedBy.LINK
    drive = driven.room.stations._loop.drives["alice"]
    wait_until(lambda: drive.state().velocity.ahead == 0.0)


def test_a_session_shows_its_belt_at_the_server_and_leaves_it_at_its_end(tmp_path: Path) -> None:
    room = ServedRoom(tmp_path, SERVED, SCENE)
    address = f"player://{HOST}:{room.port}"
    with closing(room):
        with closing(
            assemble(Settings(robot=address, world="open_floor", speech="off", sound=False), terminal=True)
        ) as donnie:
            donnie.session.hub.publish(BeltShown((0, 0, 0, 3, *(0,) * 10)))
            wait_until(lambda: ("alice", (11, "A")) in room.notes.taken)
            donnie.session.hub.publish(Spoke("bom dia"))
            wait_until(lambda: ("alice", "bom dia") in room.notes.taken)
            assert donnie.connection.is_real
            assert [each.robot for each in donnie.connection.options()].count(address) == 1
            kinds = [each.device for each in donnie.mounted()]
            assert [kinds.count(each) for each in (Device.RANGER, Device.EYES, Device.BUMPER)] == [7, 1, 4]
            donnie.connection.connect("sim")
            wait_until(lambda: room.notes.taken[-1] == ("alice", "left"))
            donnie.session.hub.publish(Spoke("unheard"))
        assert ("alice", "unheard") not in room.notes.taken


GRIPPING = """
model ( name "can" size [ 0.1 0.1 0.3 ] pose [ 0.3 0 0 0 ] color "gray"
        gripper_return 1 obstacle_return 0 ranger_return -1 )
position
(
  name "alice" size [ 0.3 0.3 0.3 ] pose [ 0 0 0 0 ]
  gripper ( pose [ 0.3 0 0 0 ] size [ 0.2 0.2 0.2 ] )
)
"""
GRIPPER = SERVED.partition('driver ( name "stage" model')[0] + (
    'driver ( name "stage" model "alice" provides [ "7665:position2d:0" "7665:gripper:0" ] )'
)


@pytest.fixture
def gripping(tmp_path: Path) -> Iterator[Driven]:
    with closing(Driven(tmp_path, GRIPPING, GRIPPER)) as made:
        made.robot.connect()
        yield made


def test_a_gripper_takes_a_thing_along_and_lets_it_go(gripping: Driven) -> None:
    outcomes = [gripping.robot.grip().outcome, gripping.robot.grip().outcome]
    gripping.robot.backward(4)
    outcomes += [gripping.robot.release().outcome, gripping.robot.release().outcome]
    can = gripping.room.stations._loop.pose("can")

    assert outcomes == [Grip.GRIPPED, Grip.HOLDS_ALREADY, Grip.RELEASED, Grip.HOLDS_NOTHING]
    assert (can.x, can.y) == pytest.approx((0.1, 0.0), abs=0.005)


def test_a_gripper_that_closed_on_nothing_opens_for_the_next_time(gripping: Driven) -> None:
    gripping.robot.backward(10)
    nothing = gripping.robot.grip().outcome
    state = gripping.link.values(RobotPart.GRIPPER)
    gripping.robot.forward(10)

    assert nothing is Grip.NOTHING_THERE
    assert state == (1, 0, 0)
    assert gripping.robot.grip().outcome is Grip.GRIPPED


def test_a_robot_without_a_gripper_says_so_and_a_stop_ends_gripping(driven: Driven, gripping: Driven) -> None:
    with pytest.raises(RobotProblem) as problem:
        driven.robot.grip()
    gripping.pace.on_sleep = lambda: False

    assert problem.value.code == "no-gripper"
    assert gripping.robot.grip().outcome is Grip.NOTHING_THERE


def test_a_gripper_at_a_server_that_ends_is_a_lost_link(gripping: Driven) -> None:
    gripping.pace.on_sleep = lambda: gripping.end_server() is None

    with pytest.raises(RobotProblem) as problem:
        gripping.robot.grip()
    assert problem.value.code == "link-lost"


def test_a_program_grips_at_a_server(tmp_path: Path) -> None:
    room = ServedRoom(tmp_path, GRIPPER, GRIPPING)
    settings = Settings(robot=f"player://{HOST}:{room.port}", world="open_floor", speech="off", sound=False)
    used: list[Grip] = []
    with closing(room), closing(assemble(settings, terminal=True)) as donnie:
        donnie.session.hub.subscribe_to_own(
            lambda it: used.append(it.event.outcome) if isinstance(it.event, GripperUsed) else None
        )
        donnie.session.start("GRIP RELEASE", "")
        wait_until(lambda: len(used) == 2)

    assert used == [Grip.GRIPPED, Grip.RELEASED]


TWO = """
define sonar sensor ( range [ 0.02 3 ] fov 15 )
model ( name "wall" size [ 0.1 4 1 ] pose [ 1.05 0 0 0 ] color "red" )
define robot position ( size [ 0.1 0.1 0.2 ] ranger ( sonar( pose [ 0 0 0 0 ] ) )
  blobfinder ( range 5 fov 60 image [ 160 120 ] colors_count 1 colors [ "red" ] ) )
robot ( name "alice" pose [ 0 1 0 0 ] )
robot ( name "bob" pose [ 0.5 -1 0 0 ] )
"""
BOTH = """
driver ( name "stage" plugin "stageplugin" provides [ "7665:simulation:0" ] worldfile "room.world" )
driver ( name "stage" model "alice" provides [ "7665:position2d:0" "7665:ranger:0" "7665:blobfinder:0" ] )
driver ( name "stage" model "bob" provides [ "7665:position2d:1" "7665:ranger:1" "7665:blobfinder:1"
  "7665:speech:1" ] )
"""


def test_an_index_names_one_of_several_robots_on_a_port(tmp_path: Path) -> None:
    """Bob is 10 steps from the wall, Alice 20; what belongs to Alice is left alone."""
    with closing(Driven(tmp_path, TWO, BOTH, "/1")) as driven:
        driven.robot.connect()
        drives = driven.room.stations._loop.drives
        far = driven.robot.distance(Bearing.FRONT)
        [seen] = driven.robot.scan()
        walked = driven.robot.forward(2)
        driven.robot.say("bom dia")
        wait_until(lambda: any(taken == "bom dia" for _, taken in driven.room.notes.taken))
        alice, bob = (drives[name].state().truth for name in ("alice", "bob"))

    assert driven.link.name.endswith("/1")
    assert (far, seen.colour, round(seen.steps)) == (10, "red", 10)
    assert (walked.walked, bob.x) == (2, pytest.approx(0.6, abs=0.0015))
    assert (alice.x, alice.yaw) == (0.0, 0.0)
    assert ("alice", "opened") not in driven.room.notes.taken


def test_another_robot_on_the_port_is_no_head(tmp_path: Path) -> None:
    """Bob has the index that a head would have, two metres aside."""
    with closing(Driven(tmp_path, TWO, BOTH)) as driven:
        driven.robot.connect()
        [seen] = driven.robot.scan()
        bob = driven.room.stations._loop.drives["bob"].state()

    assert (seen.colour, round(seen.steps)) == ("red", 20)
    assert (bob.truth.yaw, bob.velocity.turn) == (0.0, 0.0)


def test_a_robot_of_an_index_that_is_not_there_is_named(tmp_path: Path) -> None:
    with closing(Driven(tmp_path, TWO, BOTH, "/7")) as driven, pytest.raises(RobotProblem) as problem:
        driven.robot.connect()

    assert problem.value.code == "no-wheels"
    assert problem.value.values["port"] == f"player://{HOST}:{driven.room.port}/7"


# --- other servers


class PlayedServer:
    """Answers as a recorded server did: each request by its subtype, and each opened device with its data.

    ``is_silent``: it answers no request. ``delay``: seconds before the data of all but the wheels.
    """

    def __init__(
        self, messages: list[PlayerMessage], *, is_silent: bool = False, says: bytes = b"", delay: float = 0.0
    ) -> None:
        self._listener = socket.create_server((HOST, 0))
        self.port = self._listener.getsockname()[1]
        self._messages, self._is_silent = messages, is_silent
        self._says, self._delay = says or banner("3.1.1-dev"), delay
        self.got: list[PlayerMessage] = []
        self._thread = threading.Thread(target=self._serve, daemon=True)
        self._thread.start()

    def _serve(self) -> None:
        with suppress(OSError):
            connected, _ = self._listener.accept()
            with connected:
                connected.sendall(self._says)
                reader = MessageReader(1 << 20)
                while data := connected.recv(65536):
                    for message in reader.feed(data):
                        self.got.append(message)
                        self._answer(connected, message)

    def _answer(self, connected: socket.socket, message: PlayerMessage) -> None:
        if message.type != MessageType.REQUEST or self._is_silent:
            return
        kind = (message.interface, message.index, message.subtype)
        replies = [
            each
            for each in self._messages
            if each.type in (MessageType.ACK, MessageType.NACK)
            and (each.interface, each.index, each.subtype) == kind
        ]
        if message.interface == 1 and message.subtype == 3:
            replies = [each for each in replies if each.body[8:16] == message.body[8:16]]
        reply = replies[0] if replies else PlayerMessage(*kind[:2], MessageType.NACK, kind[2])
        connected.sendall(reply.encoded())
        if message.interface == 1 and message.subtype == 3 and reply.type == MessageType.ACK:
            device = (int.from_bytes(message.body[8:12]), int.from_bytes(message.body[12:16]))
            data = [
                e for e in self._messages if e.type == MessageType.DATA and (e.interface, e.index) == device
            ]
            encoded = b"".join(each.encoded() for each in data[:3])
            if self._delay and device != (4, 0):
                threading.Timer(self._delay, connected.sendall, [encoded]).start()
            else:
                connected.sendall(encoded)

    def close(self) -> None:
        self._listener.close()


def recorded(shared: Path, name: str) -> list[PlayerMessage]:
    return [each for side in sides(shared, name) if side.sender == "server" for each in side.messages()]


def test_the_bytes_of_the_real_server_are_a_robot_with_its_devices(shared: Path) -> None:
    """Of the original's world: readings as its server sent them, in the original's order."""
    messages = recorded(shared, "godonnie")
    listed = body_of(
        1,
        MessageType.ACK,
        1,
        [(0, 6691, *key) for key in ((4, 0), (4, 1), (62, 0), (62, 1), (14, 0), (7, 0))],
    )
    messages.append(PlayerMessage(1, 0, MessageType.ACK, 1, listed))
    with closing(PlayedServer(messages)) as server:
        robot = PlayerRobot(ServerLink(f"player://{HOST}:{server.port}"), pace=Pace())
        robot.connect()
        link = robot._link
        wait_until(lambda: bool(link.values(RobotPart.SONARS)))
        with closing(robot):
            first = next(
                e for e in reversed([m for m in messages if (m.interface, m.index, m.type) == (4, 0, 1)][:3])
            )
            assert set(robot.known_distances()) == set(Bearing)
            assert link.wheels().time == first.time
            assert set(link.shapes) >= {RobotPart.WHEELS, RobotPart.SONARS, RobotPart.BUMPERS}


OPENED = PlayerMessage(1, 0, MessageType.ACK, 3, body_of(1, MessageType.ACK, 3, 0, 6665, 4, 0, 1, "stage"))


def test_a_view_is_the_one_that_is_set_or_that_of_the_marks_or_of_the_original() -> None:
    """The original's is 60 degrees. A finder all round is no camera's."""
    key = PlayerMessage(1, 0, MessageType.ACK, 3, body_of(1, MessageType.ACK, 3, 0, 6665, 10, 0, 1, "x"))
    listed = body_of(1, MessageType.ACK, 1, [(0, 6665, 4, 0), (0, 6665, 10, 0)])
    at_start = PlayerMessage(4, 0, MessageType.DATA, 1, body_of(4, 1, 1, *(0.0,) * 6, 0))
    messages = [PlayerMessage(1, 0, MessageType.ACK, 1, listed), OPENED, key, at_start]

    def view(angle: float | None, chosen: float | None) -> float:
        body = struct.pack(">fff", 0.1, 4.0, angle or 0.0)
        given = [] if angle is None else [PlayerMessage(10, 0, MessageType.ACK, 2, body)]
        with closing(PlayedServer(messages + given)) as server:
            link = ServerLink(f"player://{HOST}:{server.port}")
            robot = PlayerRobot(link, pace=Pace())
            robot.chosen_view = chosen
            with closing(robot):
                robot.connect()
                return robot.view

    assert view(None, None) == 60.0
    assert view(1.5707963, None) == pytest.approx(90.0)
    assert view(6.2831853, None) == 60.0
    assert view(1.5707963, 45.0) == 45.0


def test_a_robot_is_connected_when_what_it_senses_has_come(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "SETTLING", 60.0)
    keys = [(4, 0), (62, 0)]
    listed = body_of(1, MessageType.ACK, 1, [(0, 6665, *key) for key in keys])
    opened = [
        PlayerMessage(1, 0, MessageType.ACK, 3, body_of(1, MessageType.ACK, 3, 0, 6665, *key, 1, "x"))
        for key in keys
    ]
    data = [
        PlayerMessage(4, 0, MessageType.DATA, 1, body_of(4, 1, 1, *(0.0,) * 6, 0)),
        PlayerMessage(62, 0, MessageType.DATA, 1, body_of(62, 1, 1, [0.52] * 6)),
    ]
    messages = [PlayerMessage(1, 0, MessageType.ACK, 1, listed), *opened, *data]
    with closing(PlayedServer(messages, delay=0.3)) as server:
        robot = PlayerRobot(ServerLink(f"player://{HOST}:{server.port}"), pace=Pace())
        with closing(robot):
            robot.connect()
            assert robot.distance(Bearing.FRONT) == 10


LYING = struct.pack(">IIIIIIdII", 0, 0, 1, 0, 4, 1, 0.0, 0, 2**31)
LISTED = PlayerMessage(1, 0, MessageType.ACK, 1, body_of(1, MessageType.ACK, 1, [(0, 6665, 4, 0)]))
NOWHERE = PlayerMessage(4, 0, MessageType.DATA, 1, body_of(4, 1, 1, *(float("nan"),) * 6, 0))


@pytest.mark.parametrize(
    ("messages", "code", "options"),
    [
        ([PlayerMessage(1, 0, MessageType.ACK, 1, body_of(1, MessageType.ACK, 1, []))], "no-wheels", {}),
        ([], "no-answer", {"is_silent": True}),
        ([], "no-answer", {"says": b"HTTP/1.1 400 Bad Request\r\n\r\n...."}),
        ([], "no-answer", {"says": bytes(BANNER_SIZE)}),
        ([], "no-answer", {"says": banner("3") + LYING}),
        ([LISTED, OPENED, NOWHERE, LISTED], "", {}),
    ],
    ids=["no wheels", "silent", "web", "zeros", "a lying size", "a place that is no number"],
)
def test_a_server_that_is_none_is_said_to_be(
    monkeypatch: pytest.MonkeyPatch, messages: list[PlayerMessage], code: str, options: dict[str, object]
) -> None:
    monkeypatch.setattr(module, "ANSWERING", 0.02 if code == "no-answer" else TIMEOUT)
    found = ""
    with closing(PlayedServer(messages, **options)) as server:  # type: ignore[arg-type]
        robot = PlayerRobot(ServerLink(f"player://{HOST}:{server.port}"), pace=Pace())
        try:
            robot.connect()
        except RobotProblem as problem:
            found = problem.code
        pose = robot.pose()
        robot.close()
    assert found == code
    assert (pose.x, pose.y) == (0.0, 0.0)


def test_a_port_at_which_nothing_listens_is_named() -> None:
    with socket.socket() as unused:
        unused.bind((HOST, 0))
        port = unused.getsockname()[1]
        with pytest.raises(RobotProblem) as problem:
            PlayerRobot(ServerLink(f"player://{HOST}:{port}"), pace=Pace()).connect()
    assert problem.value.code == "no-server"
    assert problem.value.values["port"] == f"player://{HOST}:{port}"


def test_a_robot_that_counts_from_zero_is_at_the_start_of_its_world(tmp_path: Path) -> None:
    """It starts at 3 4, looking west: a step ahead leads west, a turn to the right makes it look north."""
    with closing(
        Driven(tmp_path, SCENE.replace("gps", "odom").replace("[ 0 0 0 0 ] loc", "[ 0.2 0.1 0 90 ] loc"))
    ) as driven:
        driven.robot.start = Pose(3.0, 4.0, 270.0)
        driven.robot.connect()
        walked = driven.robot.forward(1).pose
        turned = driven.robot.turn(90).pose

    assert (walked.x, walked.y, walked.heading) == pytest.approx((2.0, 4.0, 270.0), abs=0.05)
    assert (turned.heading + 90) % 360 == pytest.approx(90, abs=0.6)
