"""Clients in a session: their events and sentences, stopping them, and what a program may do meanwhile."""

import socket
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path

import pexpect
import pytest

from devices.audio.channel import DetectedEnvironment, SpeakPlace, choose_channel
from devices.player.codec import MessageReader, MessageType, PlayerMessage, body_of
from devices.ports.drive import DriveState, MetricPose, Velocity
from donnie_tui.bootstrap import Donnie, assemble
from donnie_tui.cli.front_end import speaks_for_robots
from donnie_tui.core.events import (
    Announced,
    BeltShown,
    CueSounded,
    Driven,
    Event,
    GripperUsed,
    Outcome,
    RunEnded,
    RunStarted,
    Spoke,
    Stamped,
)
from donnie_tui.core.session import Busy
from donnie_tui.core.transcript import printed_lines
from donnie_tui.player.service import motion_of
from donnie_tui.settings.settings import ServedFile, Settings
from tests.free_ports import free_port
from tests.player.room import CONFIGURATION, HOST, write_room
from tests.timeouts import TIMEOUT
from tests.tui.terminal import CTRL_Q, ENTER, TAB, Terminal

BELT = """
driver ( name "vib_belt" provides [ "7665:speech:1" "7665:dio:1" ] )
driver ( name "soxplayer" provides [ "7665:sound:0" ] )
"""


class Client:
    """A program of another's, as a socket."""

    def __init__(self, port: int) -> None:
        self.socket = socket.create_connection((HOST, port), TIMEOUT)
        assert self.socket.recv(32).startswith(b"Player v.")
        self._reader = MessageReader(10**6)

    def send(self, interface: int, index: int, type_: int, subtype: int, *values: object) -> None:
        body = body_of(interface, type_, subtype, *values)
        self.socket.sendall(PlayerMessage(interface, index, type_, subtype, body).encoded())

    def open(self, interface: int, index: int = 0) -> bool:
        """Whether it was granted."""
        self.send(1, 0, 3, 3, 0, 0, interface, index, 1, "")
        while True:
            for message in self._reader.feed(self.socket.recv(65536)):
                if message.interface == 1:
                    return message.type == MessageType.ACK

    def drive(self, ahead: float, turn: float = 0.0) -> None:
        self.send(4, 0, 2, 1, ahead, 0.0, turn, 1)

    def close(self) -> None:
        self.socket.close()


class Lesson:
    """A session with clients, and its events."""

    def __init__(self, folder: Path, record: str | None = None) -> None:
        self.port, self.bobs = sorted((free_port(), free_port()))  # the lowest port is the first robot's
        text = (CONFIGURATION + BELT).replace("7665", str(self.port)).replace("7666", str(self.bobs))
        file = str(write_room(folder, text))
        settings = Settings(world=file, speech="off", sound=False, speed=20.0, record=record)
        settings = Settings(**{**_fields(settings), "served": ServedFile(file, HOST, 6665)})
        self.donnie: Donnie = assemble(settings, terminal=True)
        self.events: list[Stamped] = []
        self._changed = threading.Condition()
        self.donnie.session.hub.subscribe(self._take)

    def _take(self, stamped: Stamped) -> None:
        with self._changed:
            self.events.append(stamped)
            self._changed.notify_all()

    def wait_for(self, condition: Callable[[Event], bool], robot: str = "alice") -> Stamped:
        """The first event that is so; it is in the past from then on."""

        def found() -> Stamped | None:
            for index, each in enumerate(self.events):
                if each.robot == robot and condition(each.event):
                    del self.events[: index + 1]
                    return each
            return None

        with self._changed:
            stamped = self._changed.wait_for(found, TIMEOUT)
        assert stamped is not None
        return stamped

    def close(self) -> None:
        self.donnie.close()


def _fields(settings: Settings) -> dict[str, object]:
    return {name: getattr(settings, name) for name in settings.__struct_fields__}


@pytest.fixture
def lesson(tmp_path: Path) -> Iterator[Lesson]:
    with closing(Lesson(tmp_path)) as made:
        yield made


def is_driven(motion: str) -> Callable[[Event], bool]:
    return lambda event: isinstance(event, Driven) and event.motion == motion


def is_end(outcome: Outcome) -> Callable[[Event], bool]:
    return lambda event: isinstance(event, RunEnded) and event.outcome is outcome


def test_what_a_client_does_is_an_event_and_a_sentence(lesson: Lesson) -> None:
    with closing(Client(lesson.port)) as client:
        assert client.open(4)
        lesson.wait_for(lambda event: isinstance(event, RunStarted))
        client.drive(0.1)
        driven = lesson.wait_for(is_driven("forward"))
        said = lesson.wait_for(lambda event: isinstance(event, Announced))
        client.drive(0.0)
        stood = lesson.wait_for(is_driven("standing"))

    assert printed_lines(said, lesson.donnie.words) == ("Another program drives alice forward.",)
    assert isinstance(driven.event, Driven)
    assert isinstance(stood.event, Driven)
    assert stood.event.pose.x > driven.event.pose.x >= -40
    lesson.wait_for(is_end(Outcome.COMPLETED))


def test_what_a_client_lets_a_robot_say_is_its_speech(lesson: Lesson) -> None:
    with closing(Client(lesson.port)) as client:
        assert client.open(12)
        client.send(12, 0, 2, 1, "Olá")
        said = lesson.wait_for(lambda event: isinstance(event, Spoke))

    assert said.event == Spoke("Olá")


def test_a_stop_holds_the_robot_until_it_is_opened_anew(lesson: Lesson) -> None:
    with closing(Client(lesson.port)) as client:
        assert client.open(4)
        client.drive(0.1)
        lesson.wait_for(is_driven("forward"))
        lesson.donnie.team.stop()
        stopped = lesson.wait_for(is_end(Outcome.STOPPED)).event
        client.drive(0.1)
        client.send(12, 0, 2, 1, "")
        assert client.open(62)
    with closing(Client(lesson.port)) as another:
        assert another.open(4)
        lesson.wait_for(lambda event: isinstance(event, RunStarted))
        assert isinstance(stopped, RunEnded)
        assert lesson.donnie.session.pose.x - stopped.pose.x < 1.0
        another.drive(0.1)
        lesson.wait_for(is_driven("forward"))


def test_a_pause_holds_the_robot_and_a_continuation_lets_it_drive(lesson: Lesson) -> None:
    with closing(Client(lesson.port)) as client:
        assert client.open(4)
        client.drive(0.1)
        lesson.wait_for(is_driven("forward"))
        run = lesson.donnie.session.run
        assert run is not None
        run.control.pause()
        lesson.wait_for(is_driven("standing"))
        run.control.resume()
        lesson.wait_for(is_driven("forward"))


def test_no_program_begins_while_a_client_has_a_robot_open(lesson: Lesson) -> None:
    with closing(Client(lesson.port)) as client:
        assert client.open(4)
        for name in ("alice", "bob"):
            with pytest.raises(Busy):
                lesson.donnie.team.session(name).start("FW 1", "typed")
    lesson.wait_for(is_end(Outcome.COMPLETED))
    run = lesson.donnie.team.session("bob").start("FW 1", "typed")
    assert run.wait(TIMEOUT)
    assert run.outcome is Outcome.COMPLETED


def test_no_client_opens_a_robot_while_a_program_runs(lesson: Lesson) -> None:
    run = lesson.donnie.session.start("WAIT 1000", "typed")
    with closing(Client(lesson.port)) as client:
        assert client.open(62)
        assert not client.open(4)
        run.control.stop()
        assert run.wait(TIMEOUT)
        assert client.open(4)


def test_robots_of_two_ports_have_their_own_events(lesson: Lesson) -> None:
    with closing(Client(lesson.port)) as one, closing(Client(lesson.bobs)) as other:
        assert one.open(4)
        assert other.open(4)
        one.drive(0.1)
        other.drive(-0.1, 0.5)
        lesson.wait_for(is_driven("forward"))
        lesson.wait_for(is_driven("backward-left"), "bob")


def test_a_belt_a_sound_and_a_gripper_are_events(lesson: Lesson) -> None:
    """Motor 11 is the upper row's fourth, 25 the lower row's; the letters are those of the firmware."""
    with closing(Client(lesson.port)) as client:
        for interface, index in ((20, 1), (66, 0), (4, 0), (12, 1)):
            assert client.open(interface, index)
        client.send(20, 1, 2, 1, 11, ord("A"))
        one = lesson.wait_for(lambda event: isinstance(event, BeltShown)).event
        frame = "".join("B" if cell == 25 else "P" for cell in range(36))
        client.send(12, 1, 2, 1, frame)
        other = lesson.wait_for(lambda event: isinstance(event, BeltShown)).event
        client.send(66, 0, 2, 1, b"/etc/passwd".ljust(64, b"\0"))  # no cue, and no file is opened
        client.send(66, 0, 2, 1, b"/home/donnie/sounds/bump.wav".ljust(64, b"\0"))
        cue = lesson.wait_for(lambda event: isinstance(event, CueSounded)).event

    assert one == BeltShown((0, 0, 0, 3, 0, 0, 0, *(0,) * 7))
    assert other == BeltShown((*(0,) * 7, 0, 0, 0, 2, 0, 0, 0))
    assert cue == CueSounded("bump", 0.0, None)
    assert not any(isinstance(each.event, GripperUsed) for each in lesson.events)


def test_a_recording_replays_what_clients_did(tmp_path: Path) -> None:
    recording = tmp_path / "lesson.jsonl"
    with closing(Lesson(tmp_path, str(recording))) as lesson:
        with closing(Client(lesson.port)) as client:
            assert client.open(4)
            assert client.open(12)
            client.drive(0.1)
            lesson.wait_for(is_driven("forward"))
            client.send(12, 0, 2, 1, "hello")
            lesson.wait_for(lambda event: isinstance(event, Spoke))
        lesson.wait_for(lambda event: isinstance(event, RunEnded))
    replayed = subprocess.run(
        [sys.executable, "-m", "donnie_tui", "replay", str(recording), "--speed", "max", "--lang", "en"],
        capture_output=True,
        text=True,
        check=False,
        timeout=TIMEOUT,
    )

    assert replayed.returncode == 0, replayed.stderr
    assert replayed.stdout.splitlines() == ["Another program drives alice forward.", "alice: hello"]


@pytest.mark.parametrize(
    ("velocity", "motion"),
    [
        ((0.0, 0.0, 0.0), "standing"),
        ((0.001, 0.0, 1.0), "standing"),
        ((0.1, 0.0, 0.0), "forward"),
        ((-0.1, 0.0, 0.0), "backward"),
        ((0.0, 0.2, 0.0), "sideways"),
        ((0.0, 0.0, 10.0), "left"),
        ((0.0, 0.0, -10.0), "right"),
        ((0.1, 0.0, 10.0), "forward-left"),
        ((-0.1, 0.0, -10.0), "backward-right"),
        ((0.005, 0.2, 0.0), "forward"),
        ((-0.005, 0.0, 2.0), "backward-left"),
        ((0.0049, -0.005, 10.0), "sideways"),
        ((0.0049, 0.0049, -2.0), "right"),
        ((-0.0049, -0.0049, 1.99), "standing"),
    ],
)
def test_a_motion_has_a_word(velocity: tuple[float, float, float], motion: str) -> None:
    here = MetricPose()
    assert motion_of(DriveState(here, here, Velocity(*velocity), False)) == motion
    assert motion_of(DriveState(here, here, Velocity(*velocity), True)) == "blocked"


def test_the_start_says_where_it_listens_and_what_is_left_out(lesson: Lesson) -> None:
    assert lesson.donnie.notices.about_devices == (
        f"Programs can connect to {HOST}, port {lesson.port}, {lesson.bobs}.",
    )


@pytest.mark.slow
def test_the_linear_mode_says_what_a_client_does_and_stop_stops_it(tmp_path: Path) -> None:
    port, other = sorted((free_port(), free_port()))
    text = CONFIGURATION.replace("7665", str(port)).replace("7666", str(other))
    arguments = ["player", str(write_room(tmp_path, text)), "--linear", "--lang", "en", "--speed", "5"]
    learner = pexpect.spawn(
        sys.executable,
        ["-m", "donnie_tui", *arguments, "--speech", "off", "--sound", "off"],
        encoding="utf-8",
        timeout=TIMEOUT,
    )
    learner.expect("Programs can connect")
    with closing(Client(port)) as client:
        assert client.open(4)
        client.drive(0.05)
        learner.expect("Another program drives alice forward.")
        learner.sendline("stop")
        learner.expect("topped.")
        learner.sendline("quit")
        learner.expect(pexpect.EOF)
    learner.close()
    assert learner.exitstatus == 0


@pytest.mark.slow
def test_the_full_screen_shows_what_clients_do_and_stop_all_stops_all_robots(tmp_path: Path) -> None:
    port, other = sorted((free_port(), free_port()))
    text = CONFIGURATION.replace("7665", str(port)).replace("7666", str(other))
    file = str(write_room(tmp_path, text))
    arguments = ["player", file, "--visual", "--lang", "en", "--speed", "2"]
    screen = Terminal(arguments, tmp_path, columns=110, rows=32)
    with closing(screen):
        screen.shows("Programs can connect")
        with closing(Client(port)) as one, closing(Client(other)) as two:
            for client in (one, two):
                assert client.open(4)
                client.drive(0.02)
            screen.shows("Another program drives alice forward.")
            screen.shows("Another program drives bob forward.")
            assert one.open(12)
            one.send(12, 0, 2, 1, "bom dia")
            screen.shows("bom dia")
            screen.type(TAB * 4)
            screen.shows(" Command line.")
            screen.type("stop all" + ENTER)
            screen.shows("All robots")
            screen.shows("STOPPED")
        screen.type(CTRL_Q)
        assert screen.ended() == 0


@pytest.mark.parametrize(
    ("speech", "terminal", "reader", "speaks"),
    [
        ("off", True, None, False),
        ("text", True, None, False),
        ("auto", True, None, True),
        ("auto", False, None, False),
        ("auto", True, "orca", False),
        ("tts", False, None, True),
        ("robot", False, None, True),
    ],
)
def test_without_a_front_end_what_robots_say_is_spoken_where_the_linear_mode_would_speak(
    speech: str, terminal: bool, reader: str | None, speaks: bool
) -> None:
    facts = DetectedEnvironment({})
    facts.__dict__ |= {"stdout_is_terminal": terminal, "screen_reader": reader, "has_ssip": False}
    facts.__dict__ |= {"has_voice": True, "has_sound_device": True}

    assert speaks_for_robots(speech, facts) is speaks
    assert choose_channel("robot", facts).speak is SpeakPlace.ROBOT
