"""The connection of a session to its robot: simulated, real, or a simulated board; and changing it.

Each change of the connection is a ``link`` event at once. A robot that is missing is reported, and the
simulator takes its place. A robot that is disconnected stands first. Ports are searched, and their modules
loaded, only for a real robot.
"""

from __future__ import annotations

import os
import stat
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.robot import LinkNotice, Pace, Pose, RobotProblem, Watcher
from donnie_tui.core.events import Link, Spoke, Stamped
from donnie_tui.core.session import Busy, ResettableRobot, Session
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.outlets.belt import ChosenBelt, refuse_shared_port
from donnie_tui.process.confinement import check_name, open_bytes
from donnie_tui.process.signals import timeout_factor
from donnie_tui.robot.search import Search
from donnie_tui.settings.parsing import DOUBLE, PLAYER, SERIAL, SIMULATED, socket_of
from donnie_tui.settings.settings import Settings
from donnie_tui.world.loading import ChosenWorld

if TYPE_CHECKING:
    import subprocess

    from devices.camera import ColourCamera
    from devices.serial_robot.config import RobotConfig
    from devices.serial_robot.robot import SerialRobot
    from donnie_tui.robot.search import Connectable, Lister, RobotOption
    from sim.sensors import Mounted


AUTOMATIC, NEWER = "auto", "2018"
"""Of the setting ``profile``."""


class _Connected(Struct):
    """The connected robot, if any, and the end of the last one."""

    robot: Connectable | None = None
    guard: Guard | None = None
    has_run_away: bool = False

    def take(self, robot: Connectable, *, is_real: bool) -> None:
        self.robot = robot
        self.guard = Guard(robot.port) if is_real else None

    def drop(self) -> None:
        """Close the robot. Each calling thread waits until it is closed, as the process may end then."""
        robot = self.robot
        if robot is None:
            return
        robot.close()
        self.has_run_away, self.robot = robot.has_run_away, None
        guard, self.guard = self.guard, None
        if guard is not None:
            guard.end(may_drive_on=robot.may_drive_on)


class Connection:
    """One session's robot. ``connect`` blocks for some seconds; the rest returns at once."""

    def __init__(
        self,
        settings: Settings,
        words: Words,
        world: ChosenWorld,
        session: Session,
        found: Lister | None = None,
        stable: Callable[[str], str] | None = None,
        search: Search | None = None,
    ) -> None:
        """``session``: whose robot it is; it begins with a simulated one.

        ``found`` lists the ports, ``stable`` gives a port's permanent name; None: those of this machine.
        """
        self.search = search or Search()
        self._settings = settings
        self._words = words
        self._world = world
        self._session = session
        self._found, self._stable = found, stable
        self._now = _Connected()
        self._lock = threading.Lock()
        self.robot = SIMULATED
        """The connected robot, as an argument of ``--robot``."""

    @property
    def is_real(self) -> bool:
        """Whether the robot is real, outside of this process."""
        return self.robot not in (SIMULATED, DOUBLE)

    @property
    def has_run_away(self) -> bool:
        """Whether the robot still drives after every attempt to stop it, or did when it was lost."""
        robot = self._now.robot
        return self._now.has_run_away if robot is None else robot.has_run_away

    @property
    def is_board(self) -> bool:
        """Whether a board drives it, real or simulated, with a board's sensors in any world."""
        return self.robot != SIMULATED

    @property
    def mounted(self) -> tuple[Mounted, ...] | None:
        """The devices of a robot that reports them; None for others."""
        return getattr(self._now.robot, "mounted", None)

    @property
    def has_camera(self) -> bool:
        """Whether the robot is one with a camera, which may fail."""
        return self.is_board and self._settings.camera is not None

    def options(self) -> tuple[RobotOption, ...]:
        """The robots that a learner may choose among."""
        from devices.serial_ports import list_ports
        from donnie_tui.robot.search import robot_options

        return robot_options(self._settings, self._words, self._found or list_ports)

    def connect(self, robot: str) -> tuple[str, ...]:
        """Change to a robot, or to the simulated one if that fails. Returns a sentence for each problem.

        Raises ``Busy`` while a program runs.
        """
        with self._lock:
            try:
                self._change(robot)
            except (RobotProblem, Unusable) as problem:
                return (*self._sentences_of(problem), self._words("connect-instead"))
            finally:
                self.search.end()
        return ()

    def insist(self, robot: str) -> None:
        """Change to that robot, or raise ``Unusable``."""
        with self._lock:
            try:
                self._change(robot)
            except RobotProblem as problem:
                raise Unusable(" ".join(self._sentences_of(problem))) from None
            finally:
                self.search.end()

    def wait_until_standing(self) -> None:
        """Waits after a stop until the robot stands, some 2.2 s at most. For a process that rests or ends."""
        robot = self._now.robot
        if robot is not None:
            robot.wait_until_standing()

    def close(self) -> None:
        """Close the connection; the robot is stopped."""
        self._now.drop()

    # --- changing

    def _change(self, robot: str) -> None:
        if self._session.run is not None:
            raise Busy
        if self.robot != SIMULATED:
            self._back_to_simulated()
        if robot != SIMULATED:
            self._connect(robot)

    def _back_to_simulated(self) -> None:
        """Change to the simulated robot, at the speed of the simulated board."""
        speed = self._session.speed
        self._session.change_robot(None)
        self._now.drop()
        if self.robot == DOUBLE:
            self._session.speed = speed
        self.robot = SIMULATED

    def _connect(self, robot: str) -> None:
        make, name = self._maker(robot)
        made: list[Connectable] = []

        def make_and_keep(pace: Pace, watcher: Watcher) -> ResettableRobot:
            made.append(make(pace, watcher))
            return made[0]

        self._session.change_robot(make_and_keep)
        self._now.take(made[0], is_real=name.startswith(SERIAL))
        try:
            self.search.connect(made[0])
        except RobotProblem:
            self._stop_what_runs()
            self._session.change_robot(None)
            self._now.drop()
            raise
        self.robot = name
        self._session.hub.publish(Link(LinkNotice.CONNECTED.value, name))

    def _stop_what_runs(self) -> None:
        """Stop a program that was started during the search for the robot."""
        self._session.stop()
        self._session.wait_for_stop()

    def _maker(self, robot: str) -> tuple[Callable[[Pace, Watcher], Connectable], str]:
        if robot == DOUBLE:
            return self._make_double, DOUBLE
        if robot.startswith(PLAYER):
            from devices.serial_ports import PortFault, is_named

            if not is_named(socket_of(robot)):
                raise RobotProblem(PortFault.NOT_NAMED.value, port=robot)
            return lambda pace, watcher: self._make_player(robot, pace, watcher), robot
        from devices.serial_ports import list_ports, stable_name
        from donnie_tui.robot.search import find_port

        settings = replace(self._settings, robot=robot)
        port = (self._stable or stable_name)(find_port(settings, self._words, self._found or list_ports))
        name = f"{SERIAL}:{port}"
        refuse_shared_port(replace(settings, robot=name), self._words)
        return lambda pace, watcher: self._make_serial(port, pace, watcher), name

    def _make_serial(self, port: str, pace: Pace, watcher: Watcher) -> Connectable:
        robot = _serial_robot(
            port,
            self._settings,
            pace,
            watcher=watcher,
            start=self._world.start(),
            on_notice=self._report,
            on_slow=lambda: self.search.on_slow(),
        )
        robot.camera = make_camera(self._settings)
        return robot

    def _make_player(self, robot: str, pace: Pace, watcher: Watcher) -> Connectable:
        """The robot at a Player server, which also gets the sentences of the program and the belt."""
        from donnie_tui.robot.player_robot import PlayerRobot
        from donnie_tui.robot.server_link import ServerLink

        made = PlayerRobot(ServerLink(robot, self._report), pace=pace, watcher=watcher)
        made.start, made.chosen_view = self._world.start(), self._settings.camera_view

        def say(stamped: Stamped) -> None:
            if isinstance(stamped.event, Spoke):
                made.say(stamped.event.text)

        hub = self._session.hub
        made.leave = (
            hub.subscribe_to_own(say),
            hub.subscribe_to_own(ChosenBelt(lambda: hub.robot, made.show_belt)),
        )
        return made

    def _make_double(self, pace: Pace, watcher: Watcher) -> Connectable:
        from devices.board_simulator.board import QUICK_PASSES, SimulatedBoard
        from devices.board_simulator.robot import SimulatedSerialRobot
        from donnie_tui.robot.board_floor import SceneFloor, place_of

        start = self._world.start()
        make_board = SimulatedBoard.of_2018 if self._settings.profile == NEWER else SimulatedBoard
        board = make_board(
            SceneFloor(self._world.scene), place=place_of(start), boot_loader=0.0, passes=QUICK_PASSES
        )
        robot = SimulatedSerialRobot(
            board,
            robot_config(self._settings),
            pace=pace,
            watcher=watcher,
            speed=self._session.speed,
            start=start,
            on_notice=self._report,
        )
        robot.camera = make_camera(self._settings)
        return robot

    # --- reporting

    def _report(self, news: LinkNotice, reason: str) -> None:
        """Report changes of the connection; the caller of ``connect`` reports the connection itself."""
        if news is not LinkNotice.CONNECTED:
            self._session.hub.publish(Link(news.value, reason))

    def _sentences_of(self, problem: RobotProblem | Unusable) -> tuple[str, ...]:
        if isinstance(problem, Unusable):
            return (problem.sentence,)
        from donnie_tui.robot.search import sentences_of

        return sentences_of(problem, self._words)


class Guard:
    """A process that stops the robot at a port after this process has ended, also by ``kill -9``.

    Nothing is sent by the board itself: its motors turn until a stop comes.
    """

    def __init__(self, port: str) -> None:
        import subprocess

        command = [sys.executable, "-P", "-m", "devices.port_exchange", port]
        nothing = subprocess.DEVNULL
        self._process: subprocess.Popen[bytes] | None = None
        with suppress(OSError):
            self._process = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=nothing, stderr=nothing, start_new_session=True
            )

    def end(self, *, may_drive_on: bool) -> None:
        """End the guard, unless the robot may drive on: then it stops the robot when its port is back."""
        if self._process is None or self._process.stdin is None:
            return
        from devices.port_exchange import NOT_NEEDED

        with suppress(OSError), self._process.stdin as line:  # the guard may be gone
            line.write(b"" if may_drive_on else NOT_NEEDED)
        _ENDING[:] = [each for each in (*_ENDING, self._process) if each.poll() is None]


_ENDING: list[subprocess.Popen[bytes]] = []
"""Guards that may outlive this process."""


def make_measurable(
    settings: Settings, words: Words, pace: Pace, on_notice: Callable[[LinkNotice, str], None]
) -> SerialRobot:
    """The real robot of the settings, or the simulated board, without a session. Raises ``Unusable``."""
    if settings.robot == DOUBLE:
        from devices.board_simulator.robot import SimulatedSerialRobot

        return SimulatedSerialRobot(
            config=robot_config(settings), pace=pace, speed=settings.speed, on_notice=on_notice
        )
    from donnie_tui.robot.search import find_port

    port = find_port(settings, words, remedy="remedy-calibrate")
    return _serial_robot(port, settings, pace, on_notice=on_notice)


def _serial_robot(
    port: str,
    settings: Settings,
    pace: Pace,
    *,
    watcher: Watcher | None = None,
    start: Pose | None = None,
    on_notice: Callable[[LinkNotice, str], None] | None = None,
    on_slow: Callable[[], object] | None = None,
) -> SerialRobot:
    from devices.board_reset import reset_of
    from devices.serial_ports import SameBoard
    from devices.serial_robot.link import SerialLink, open_board_port
    from devices.serial_robot.robot import SerialRobot
    from devices.wire.link_state import LinkConfig

    reset = reset_of(settings.reset_line, port)
    open_port = SameBoard(open_board_port)
    factor = timeout_factor()
    config = LinkConfig().slower(factor)
    link = SerialLink(port, config, on_notice, open_port=open_port, reset=reset, on_slow=on_slow)
    robot = robot_config(settings).slower(factor)
    return SerialRobot(link, robot, pace=pace, watcher=watcher, start=start, on_notice=on_notice)


class _PictureAccess:
    """Pictures within the folder of a confined session."""

    def names_in(self, folder: str) -> list[str]:
        check_name(folder)
        return os.listdir(folder)  # noqa: PTH208 -- a text

    def read(self, path: str, most: int) -> bytes:
        check_name(path)
        if not stat.S_ISREG(os.stat(path).st_mode):  # noqa: PTH116 -- a text; a pipe would never end
            raise RobotProblem("no-picture", path=path)
        with open_bytes(path) as file:
            return file.read(most)


def make_camera(settings: Settings) -> ColourCamera | None:
    """The camera of the settings, if there is one. Nothing is opened yet."""
    if settings.camera is None:
        return None
    from devices.camera import ORIGINAL_RANGES, VIEW, ColourCamera, make_source

    view = settings.camera_view or VIEW
    source = make_source(settings.camera, view, _PictureAccess())
    return ColourCamera(source, settings.colours or ORIGINAL_RANGES, view)


def robot_config(settings: Settings) -> RobotConfig:
    """The configuration of a real robot from the settings; by default the original's."""
    from devices.serial_robot.config import RobotConfig

    config = _profiled(RobotConfig(), settings)
    if settings.wheel_radius is not None:
        config = replace(config, wheel_radius=settings.wheel_radius)
    if settings.axle_length is not None:
        config = replace(config, axle_length=settings.axle_length)
    if settings.sonars is not None:
        config = replace(config, sonars=settings.sonars)
    if settings.bumpers is not None:
        front = frozenset(bit for bit, in_front in enumerate(settings.bumpers) if in_front)
        config = replace(config, front_bumpers=front, back_bumpers=frozenset(range(6)) - front)
    return config


def _profiled(config: RobotConfig, settings: Settings) -> RobotConfig:
    """The configuration with the profile's directions of wheels and head, unless they are set."""
    if settings.profile == NEWER:
        config = config.as_of_2018()
    is_open = settings.profile == AUTOMATIC and settings.encoders is None
    wiring = replace(
        config.wiring,
        motors=settings.motors or config.wiring.motors,
        encoders=settings.encoders or config.wiring.encoders,
    )
    is_mirrored = config.head_is_mirrored if settings.head is None else settings.head == "right"
    return replace(config, wiring=wiring, finds_profile=is_open, head_is_mirrored=is_mirrored)
