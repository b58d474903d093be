"""Small worlds for tests, and a pace that never waits."""

from collections.abc import Iterable
from pathlib import Path

from devices.ports.robot import Motion, Pose, Watcher
from sim.robot import SimulatedRobot
from sim.scene import Scene
from sim.world import World
from sim.worldfile import load_text

STEP = 0.05
BEARINGS = (0, 45, -45, 180, 135, -135)

IDEAL = (
    """
define sonar sensor ( size [ 0.001 0.001 0.001 ] range [ 0 3.0 ] fov 15 )
define sonars ranger (
"""
    + "\n".join(f"  sonar( pose [ 0 0 0 {-bearing} ] )" for bearing in BEARINGS)
    + """
)
define eyes blobfinder ( colors_count 3 colors [ "red" "green" "blue" ] range 3.0 fov 60 image [ 160 120 ] )
define ideal position ( size [ 0.002 0.002 0.1 ] drive "diff" localization "gps" sonars() eyes() )
define thing model ( size [ 0.002 0.002 0.2 ] )
define box model ( size [ 0.1 0.1 0.2 ] )
"""
)
"""A robot without size, sensors in its centre, as the conformance programs want it."""

BOX_ROBOT = """
define sonar sensor ( range [ 0 3.0 ] fov 15 )
define box_robot position ( size [ 0.2 0.1 0.1 ] ranger( sonar( pose [ 0.1 0 0 0 ] ) ) )
define blind position ( size [ 0.2 0.1 0.1 ] ranger( sonar( pose [ 0 0 0 90 ] ) ) )
"""


class Unpaced:
    """Records how long it was asked to sleep. After ``stop_after`` seconds it answers with a stop."""

    def __init__(self, stop_after: float = float("inf")) -> None:
        self.slept: list[float] = []
        self.stop_after = stop_after

    def sleep(self, seconds: float) -> bool:
        if sum(self.slept) + seconds > self.stop_after + 1e-9:
            return False
        self.slept.append(seconds)
        return True


class Diary:
    """A watcher that records every report with the robot's time."""

    def __init__(self) -> None:
        self.progress: list[tuple[Motion, Pose, float]] = []
        self.passed: list[Pose] = []
        self.robot: SimulatedRobot | None = None

    def progressed(self, motion: Motion, pose: Pose) -> None:
        self.progress.append((motion, pose, self.robot.time() if self.robot else -1.0))

    def passing(self, pose: Pose) -> None:
        self.passed.append(pose)


def scene(text: str) -> Scene:
    return load_text(text, Path("floor.world"))


def robot(
    text: str,
    pace: Unpaced | None = None,
    watcher: Watcher | None = None,
    speed: float | None = None,
) -> SimulatedRobot:
    return World(scene(text)).robot(pace=pace or Unpaced(), watcher=watcher, speed=speed)


def ideal(
    things: Iterable[tuple[str, float, float]] = (), start: tuple[float, float, float] = (0, 0, 0)
) -> SimulatedRobot:
    """The ideal robot on a floor with small things: colour, x and y in steps."""
    x, y, heading = start
    lines = [f'ideal( name "donnie" pose [ {x * STEP:.4f} {y * STEP:.4f} 0 {90 - heading} ] color "gray" )']
    lines += [
        f'thing( name "thing{i}" pose [ {tx * STEP:.4f} {ty * STEP:.4f} 0 0 ] color "{colour}" )'
        for i, (colour, tx, ty) in enumerate(things, 1)
    ]
    return robot(IDEAL + "\n".join(lines))
