"""A room for clients of Player, as configuration and world files, and its devices without a socket."""

import asyncio
import threading
from collections.abc import Callable
from contextlib import suppress
from math import inf
from pathlib import Path

from devices.ports.robot import LinkNotice, Pace, StoppedBy, Watcher
from donnie_tui.core.events import CueSounded, GripperUsed, Spoke
from donnie_tui.player.server import PlayerServer, Stations
from donnie_tui.robot.player_robot import Advance, PlayerRobot
from donnie_tui.robot.server_link import ServerLink, WheelState
from sim.velocity import VelocityLoop
from sim.world import World
from sim.worldfile import load_configuration
from tests.free_ports import free_port
from tests.timeouts import TIMEOUT

WORLD = """
define sonar sensor ( range [ 0 5 ] fov 10 )
define robot position
(
  size [ 0.4 0.4 0.3 ]
  ranger ( sonar( pose [ 0.2 0 0 0 ] ) sonar( pose [ 0 0.2 0 90 ] )
           sonar( pose [ 0 -0.2 0 -90 ] ) sonar( pose [ -0.2 0 0 180 ] ) )
)
model ( name "room" size [ 8 6 1 ] boundary 1 gripper_return 0 )
model ( name "redbox" color "red" size [ 0.4 0.4 0.6 ] pose [ 0 0 0 0 ] fiducial_return 7 pushable 1 )
robot
(
  name "alice" pose [ -2 0 0 0 ]
  ranger ( sensor( range [ 0 8 ] fov 180 samples 181 ) )
  bumper ( bcount 2 blength 0.2 bpose[0] [ 0.24 0.1 0 0 ] bpose[1] [ 0.24 -0.1 0 0 ] )
  blobfinder ( colors_count 1 colors [ "red" ] range 5 fov 60 image [ 80 60 ] )
  fiducial ( range_max 8 range_max_id 5 fov 180 )
  gripper ( pose [ 0.3 0 0 0 ] size [ 0.1 0.2 0.2 ] )
  position ( name "head" size [ 0.1 0.1 0.1 ] pose [ 0 0 0 0 ] )
)
robot ( name "bob" pose [ -2 -2 0 0 ] )
"""
CONFIGURATION = """
driver ( name "stage" plugin "stageplugin" provides [ "7665:simulation:0" ] worldfile "room.world" )
driver ( name "stage" model "alice" provides [ "7665:position2d:0" "7665:ranger:0" "7665:ranger:1"
  "7665:bumper:0" "7665:blobfinder:0" "7665:fiducial:0" "7665:speech:0" "7665:position2d:1"
  "7665:gripper:0" ] )
driver ( name "stage" model "bob" provides [ "7666:position2d:0" "7666:ranger:0" ] )
"""

DONNIE_WORLD = """
define sonar sensor ( range [ 0 3 ] fov 15 )
position
(
  name "alice" size [ 0.2 0.2 0.2 ]
  ranger ( sonar() sonar() sonar() sonar() sonar() sonar() )
  bumper ( bcount 4 blength 0.1 bpose[0] [ 0.2 0 0 0 ] bpose[1] [ 0.2 0 0 0 ]
           bpose[2] [ -0.2 0 0 180 ] bpose[3] [ -0.2 0 0 180 ] )
  position ( name "head" size [ 0.1 0.1 0.1 ]
    ranger ( sonar() )
    blobfinder ( colors_count 1 colors [ "red" ] range 5 fov 60 image [ 160 120 ] ) )
)
"""
DONNIE_CONFIGURATION = """
driver ( name "stage" plugin "stageplugin" provides [ "6691:simulation:0" ] worldfile "room.world" )
driver ( name "stage" model "alice" provides [ "6691:position2d:0" "6691:position2d:1" "6691:ranger:0"
  "6691:ranger:1" "6691:bumper:0" "6691:blobfinder:0" "6691:speech:0" ] )
driver ( name "gtts" provides [ "6691:dio:1" ] )
"""


def write_room(folder: Path, configuration: str = CONFIGURATION, world: str = WORLD) -> Path:
    (folder / "room.world").write_text(world, encoding="utf-8")
    path = folder / "room.cfg"
    path.write_text(configuration, encoding="utf-8")
    return path


class Notes:
    """What a session would learn of its clients."""

    def __init__(self) -> None:
        self.taken: list[tuple[str, object]] = []
        self.may_open = True

    def opened(self, name: str) -> bool:
        self.taken.append((name, "opened"))
        return self.may_open

    def left(self, name: str) -> None:
        self.taken.append((name, "left"))

    def happened(self, name: str, event: object) -> None:
        """A text that is said, the name of a sound, or the outcome of a grip."""
        taken = {Spoke: "text", CueSounded: "name", GripperUsed: "outcome"}[type(event)]
        self.taken.append((name, getattr(event, taken)))

    def vibrated(self, name: str, motor: int, letter: str) -> None:
        self.taken.append((name, (motor, letter)))

    def on_tick(self) -> None:
        pass


def stations_of(path: Path, notes: Notes | None = None, port: int = 6665) -> Stations:
    found = load_configuration(path)
    assert found.scene is not None
    return Stations(found.drivers, VelocityLoop(World(found.scene)), port, notes or Notes())


HOST = "127.0.0.1"


class ServedRoom:
    """A server in a thread of its own, on a port that was free. ``7665`` in the configuration becomes it."""

    def __init__(
        self, folder: Path, configuration: str, world: str, speed: float | None = 20.0, port: int = 0
    ) -> None:
        self.port = port or free_port()
        self.notes = Notes()
        path = write_room(folder, configuration.replace("7665", str(self.port)), world)
        self.stations = stations_of(path, self.notes)
        self._server = PlayerServer(self.stations, HOST, "1", lambda code: None)
        self.gate: Callable[[], object] = lambda: None
        """Called after each tick; the next one waits for it."""
        self._speed, self._started = speed, threading.Event()
        self._end: Callable[[], object] = lambda: None
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()
        assert self._started.wait(TIMEOUT)

    def _run(self) -> None:
        async def serve() -> None:
            running, loop = asyncio.current_task(), asyncio.get_running_loop()
            assert running is not None
            self._end = lambda: loop.call_soon_threadsafe(running.cancel)
            await self._server.run(self._pace, self._started.set)

        with suppress(asyncio.CancelledError):
            asyncio.run(serve())

    def _pace(self) -> float | None:
        self.gate()
        return self._speed

    def close(self) -> None:
        if self._thread.is_alive():
            self._end()
        self._thread.join(TIMEOUT)


class SteppedLink(ServerLink):
    """A link with which the server waits until the program has answered the newest datum."""

    _answered = inf
    """The time of the newest datum that was answered; endless while no program waits for data."""

    def wait_for_data(self, after: float) -> WheelState | None:
        with self._changed:
            self._answered = after
            self._changed.notify_all()
        return super().wait_for_data(after)

    def hold(self, time: float) -> None:
        """Return once it has answered the datum of this time, or no program waits for data."""
        with self._changed:
            self._changed.wait_for(lambda: self._answered >= time - 1e-6, TIMEOUT)

    def let_go(self) -> None:
        """No program waits for data now."""
        with self._changed:
            self._answered = inf
            self._changed.notify_all()


class SteppedRobot(PlayerRobot):
    """A robot of a room. While it moves or waits, the room makes its next tick only when it is ready."""

    def __init__(
        self,
        room: ServedRoom,
        pace: Pace,
        watcher: Watcher,
        on_notice: Callable[[LinkNotice, str], None] | None = None,
        index: str = "",
    ) -> None:
        self.stepped = SteppedLink(f"player://{HOST}:{room.port}{index}", on_notice)
        room.gate = lambda: self.stepped.hold(room.stations.by_port[room.port].time)
        super().__init__(self.stepped, pace=pace, watcher=watcher)

    def _move(self, advance: Advance, permit: int) -> StoppedBy | None:
        try:
            return super()._move(advance, permit)
        finally:
            self.stepped.let_go()

    def _wait(self, is_over: Callable[[WheelState], bool]) -> bool:
        try:
            return super()._wait(is_over)
        finally:
            self.stepped.let_go()
