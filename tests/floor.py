"""A robot without size on a floor made for the test, and all events there."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from devices.ports.robot import Pace, Watcher
from donnie_tui.core.events import TRANSIENT, Event, Outcome, Stamped, as_line
from donnie_tui.core.session import RunOptions, Session, SessionSetup
from donnie_tui.core.transcript import lines_of
from donnie_tui.i18n.words import Words
from sim.robot import SimulatedRobot
from sim.scene import Scene
from sim.world import World
from sim.worldfile import load_text
from tests.timeouts import TIMEOUT


def floor(*things: tuple[str, float, float], noise: float = 0.0) -> Scene:
    """A floor without walls. A thing is a colour and a place in steps. ``noise``: of the sonars, metres."""
    models = "\n".join(
        f'thing( name "thing{number}" pose [ {x * 0.05} {y * 0.05} 0 0 ] color "{colour}" )'
        for number, (colour, x, y) in enumerate(things, 1)
    )
    return load_text(_FLOOR.replace("fov 15", f"fov 15 noise [ 0 {noise} 0 ]") + models, Path("floor.world"))


class Floor:
    """A session there, and its events."""

    def __init__(
        self,
        *things: tuple[str, float, float],
        language: str = "en",
        detail: str = "normal",
        terminal: bool = False,
        speed: float | None = None,
        noise: float = 0.0,
        seed: int = 0,
    ) -> None:
        self.words = Words(language, detail)
        make_robot = partial(_robot, floor(*things, noise=noise), speed, seed)
        self.session = Session(make_robot, self.words, SessionSetup("floor", seed, terminal))
        self.stream: list[Stamped] = []
        self.session.hub.subscribe(self.stream.append)

    def run(self, text: str, *, fresh: bool = False, hooked: bool = False, trace: bool = False) -> Outcome:
        run = self.session.start(text, "test.gd", RunOptions(fresh=fresh, hooked=hooked, trace=trace))
        assert run.wait(TIMEOUT), "the program did not end"
        assert run.outcome is not None
        return run.outcome

    @property
    def events(self) -> list[Event]:
        return [each.event for each in self.stream]

    @property
    def printed(self) -> list[str]:
        """What is printed and said."""
        return [line for event in self.events for line in lines_of(event, self.words)]

    @property
    def json(self) -> str:
        """What ``--events`` writes."""
        return "".join(as_line(each) for each in self.stream if not isinstance(each.event, TRANSIENT))


def _robot(scene: Scene, speed: float | None, seed: int, pace: Pace, watcher: Watcher) -> SimulatedRobot:
    return World(scene, seed=seed).robot(pace=pace, watcher=watcher, speed=speed)


_SENSORS = "".join(f"sonar( pose [ 0 0 0 {-angle} ] )\n" for angle in (0, 45, -45, 180, 135, -135))
_FLOOR = f"""
define sonar sensor ( size [ 0.001 0.001 0.001 ] range [ 0 3.0 ] fov 15 )
define sonars ranger (
{_SENSORS})
define eyes blobfinder ( colors_count 3 colors [ "red" "green" "blue" ] range 3.0 fov 60 image [ 160 120 ] )
define ideal position ( size [ 0.002 0.002 0.1 ] drive "diff" localization "gps" sonars() eyes() )
define thing model ( size [ 0.002 0.002 0.2 ] )
ideal( name "donnie" pose [ 0 0 0 90 ] color "gray" )
"""
