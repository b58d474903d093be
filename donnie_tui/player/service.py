"""Clients in a session: their server in its own thread, and events about what they do with its robots.

A robot that a client has opened has a run, so that a stop or a pause holds it like a program. A stopped
robot drives again once it is reopened. A program of the learner waits until all clients have left,
and no client can open a robot while one runs: only one of them moves the world.
"""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable
from contextlib import suppress
from time import monotonic
from typing import TYPE_CHECKING

from msgspec import Struct

from devices.belt import MOTOR_PLACES
from devices.ports.robot import Pose
from donnie_tui import __version__
from donnie_tui.core.belt import MEDIUM, OFF, STRONG, WEAK
from donnie_tui.core.events import STANDING, Announced, BeltShown, Driven, Event, GripperUsed, Passing
from donnie_tui.core.hub import Hub
from donnie_tui.core.session import Busy, RunOptions, Session
from donnie_tui.core.team import Team
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.player.server import PlayerServer, ServerProblem, Stations
from donnie_tui.settings.parsing import is_loopback
from donnie_tui.settings.settings import ServedFile
from language.control import FOREVER, ControlState, ExecutionControl
from language.diagnostics import Stopped

if TYPE_CHECKING:
    from devices.ports.drive import DriveState
    from donnie_tui.core.runner import Run
    from donnie_tui.world.loading import ChosenWorld
    from language.runtime import Actions, Frame, Memory, Trace
    from sim.world import World

CLIENTS = "clients"
"""The code of announcements about clients, and the name of their runs."""
SELDOM = 1.0
"""Simulated seconds between two events about a robot that drives on."""
FRAME = 1 / 20
"""Seconds of real time between two poses for a moving picture."""
SLOWEST, SLOWEST_TURN = 0.005, 2.0
"""Metres and degrees a second below which a robot counts as standing."""
STARTING, ENDING = 20.0, 2.0
"""Seconds that the server may take."""
_LEVELS = {"A": STRONG, "B": MEDIUM, "P": 0}


class _Driving:
    """The run of a robot that clients drive: it waits until they have left."""

    def __init__(self) -> None:
        self.is_left = False

    def run(
        self, _actions: Actions, control: ExecutionControl, _memory: Memory, *, trace: Trace | None = None
    ) -> None:
        del trace  # it has no statements
        while control.sleep(FOREVER):
            pass
        if not self.is_left:
            raise Stopped

    def frames(self) -> tuple[Frame, ...]:
        return ()

    def progress(self) -> None:
        """None, as it has no statements."""


class _Robot(Struct):
    """A robot that clients have opened."""

    session: Session
    program: _Driving
    run: Run
    motion: str = STANDING
    pose: Pose | None = None
    """Of the last event."""
    at: float = 0.0
    """Its simulated time."""
    shown: Pose | None = None
    shown_at: float = 0.0


class ClientService:
    """The server from ``start`` to ``close``. Other methods are called in its thread."""

    def __init__(
        self, served: ServedFile, team: Team, world: ChosenWorld, shared: World, words: Words
    ) -> None:
        """Raises ``Unusable``."""
        from sim.velocity import VelocityLoop

        if world.stands_in_for:
            raise Unusable(words("player-real-only", path=served.file))
        self._served, self._team, self._words = served, team, words
        self._sessions = {name: team.session(name) for name in team.names}
        for session in self._sessions.values():
            session.is_taken = lambda: any(not each.run.is_over for each in tuple(self._robots.values()))
        self._loop = VelocityLoop(shared)
        try:
            self.stations = Stations(world.drivers, self._loop, served.port, self)
        except ServerProblem as problem:
            raise Unusable(words(problem.code, **problem.values)) from None
        if not self.stations.by_port:
            raise Unusable(words("player-nothing", path=served.file))
        self._robots: dict[str, _Robot] = {}
        self._belts: dict[str, list[int]] = {}
        """Levels that were not published yet."""
        self._shown_levels: dict[str, tuple[int, ...]] = {}
        self._started = threading.Event()
        self._problem: ServerProblem | None = None
        self._thread = threading.Thread(target=self._serve, name="clients", daemon=True)
        self._cancel: Callable[[], object] = lambda: None

    def start(self) -> None:
        """Raises ``Unusable`` for a port that can't be listened on."""
        self._thread.start()
        self._started.wait(STARTING)
        if self._problem is not None:
            raise Unusable(self._words(self._problem.code, **self._problem.values))

    def close(self) -> None:
        """Stop the robots, and close the connections."""
        self._cancel()
        self._thread.join(ENDING)

    @property
    def notices(self) -> tuple[str, ...]:
        """Sentences about its addresses and missing devices."""
        host, words = self._served.host, self._words
        left_out = self.stations.left_out
        return (
            *((words("player-left-out", names=", ".join(left_out[:10])),) if left_out else ()),
            *(() if is_loopback(host) else (words("player-open-to-others"),)),
            words("player-serving", host=host, ports=", ".join(map(str, self.stations.by_port))),
        )

    def _serve(self) -> None:
        async def serve() -> None:
            running, loop = asyncio.current_task(), asyncio.get_running_loop()
            assert running is not None
            self._cancel = lambda: loop.call_soon_threadsafe(running.cancel)
            server = PlayerServer(self.stations, self._served.host, __version__, self._complain)
            await server.run(lambda: self._team.chosen.speed, self._started.set)

        try:
            with suppress(asyncio.CancelledError):
                asyncio.run(serve())
        except ServerProblem as problem:
            self._problem = problem
        finally:
            self._cancel = lambda: None
            self._started.set()

    def _complain(self, code: str) -> None:
        self._team.chosen.hub.publish(Announced(CLIENTS, self._words(code)))

    # --- what clients do

    def opened(self, name: str) -> bool:
        """A client opens a robot that no other has opened. False: it can't now."""
        runs = [each.run for each in self._sessions.values()]
        if any(run is not None and run.name != CLIENTS for run in runs):
            self._complain("player-busy")
            return False
        session, program = self._sessions[name], _Driving()
        session.wait_for_stop()
        try:
            run = session.start("", CLIENTS, RunOptions(driver=program))
        except Busy:
            return False
        self._robots[name] = _Robot(session, program, run, at=self._loop.time)
        self._loop.drives[name].is_held = False
        return True

    def left(self, name: str) -> None:
        """No client has the robot open any more."""
        robot = self._robots.pop(name, None)
        self._shown_levels.pop(name, None)
        if robot is not None:
            robot.program.is_left = True
            robot.run.control.stop()

    def _hub_of(self, name: str) -> Hub:
        return self._sessions.get(name, self._team.chosen).hub

    def happened(self, name: str, event: Event) -> None:
        self._hub_of(name).publish(event)
        if isinstance(event, GripperUsed):
            self._sessions[name].publish_things()

    def vibrated(self, name: str, motor: int, letter: str) -> None:
        """A cell of the belt's frame was set; its event comes with the next tick."""
        if motor in MOTOR_PLACES:
            levels = self._belts.setdefault(name, list(self._shown_levels.get(name, OFF)))
            levels[MOTOR_PLACES.index(motor)] = _LEVELS.get(letter, WEAK)

    # --- what becomes of it

    def on_tick(self) -> None:
        """Before each tick."""
        for name, robot in tuple(self._robots.items()):
            drive = self._loop.drives[name]
            drive.is_held = robot.run.control.state is not ControlState.RUNNING
            if not robot.run.is_over:
                self._report(robot, drive.state())
        for name, levels in self._belts.items():
            if tuple(levels) != self._shown_levels.get(name, OFF):
                self._shown_levels[name] = tuple(levels)
                self._hub_of(name).publish(BeltShown(tuple(levels)))
        self._belts.clear()

    def _report(self, robot: _Robot, state: DriveState) -> None:
        motion, pose, now = motion_of(state), robot.session.pose, self._loop.time
        is_due = now - robot.at >= SELDOM
        has_changed = motion != robot.motion and (is_due or robot.motion == STANDING)
        if has_changed or (is_due and pose != robot.pose):
            robot.motion, robot.pose, robot.at = motion, pose, now
            robot.session.hub.publish(Driven(motion, pose))
            robot.session.publish_things()
        elif pose != robot.shown and monotonic() - robot.shown_at >= FRAME:
            robot.shown, robot.shown_at = pose, monotonic()
            robot.session.hub.publish(Passing(pose))


def motion_of(state: DriveState) -> str:
    """The motion of a driven robot, as in ``Driven``."""
    velocity = state.velocity
    if state.is_stalled:
        return "blocked"
    parts = []
    if abs(velocity.ahead) >= SLOWEST:
        parts.append("forward" if velocity.ahead > 0 else "backward")
    elif abs(velocity.left) >= SLOWEST:
        return "sideways"
    if abs(velocity.turn) >= SLOWEST_TURN:
        parts.append("left" if velocity.turn > 0 else "right")
    return "-".join(parts) or STANDING
