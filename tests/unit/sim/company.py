"""Several robots of one world, each with a program in its own thread, and a log of their reports."""

import threading
from collections.abc import Callable, Mapping

from devices.ports.robot import Motion, Pace, Pose
from sim.robot import SimulatedRobot
from sim.scene import Scene
from sim.world import World
from tests.timeouts import TIMEOUT
from tests.unit.sim.floors import Unpaced

Program = Callable[[SimulatedRobot], None]


class Company:
    """Runs programs together in one world and keeps one log of all robots, in the order of the reports."""

    def __init__(self, scene: Scene, *, speed: float | None = None, seed: int = 0) -> None:
        self.world = World(scene, seed=seed)
        self.log: list[object] = []
        self.passed: list[tuple[str, Pose]] = []
        self._speed = speed
        self._faults: list[BaseException] = []

    def robot(self, name: str, pace: Pace | None = None) -> SimulatedRobot:
        return self.world.robot(name, pace=pace or Unpaced(), watcher=_Notes(self, name), speed=self._speed)

    def run(self, programs: Mapping[str, Program], paces: Mapping[str, Pace] | None = None) -> list[object]:
        robots = {name: self.robot(name, (paces or {}).get(name)) for name in programs}
        threads = [
            threading.Thread(target=self._run, args=(robot, programs[name])) for name, robot in robots.items()
        ]
        self.world.expect(programs)
        for thread in reversed(threads):
            thread.start()
        for thread in threads:
            thread.join(TIMEOUT)
            assert not thread.is_alive(), "a program did not end"
        if self._faults:
            raise self._faults[0]
        return self.log

    def _run(self, robot: SimulatedRobot, program: Program) -> None:
        robot.join()
        try:
            program(robot)
        except BaseException as fault:  # noqa: BLE001 -- raised again in the thread of the test
            self._faults.append(fault)
        finally:
            robot.leave()


class _Notes:
    def __init__(self, company: Company, name: str) -> None:
        self._company = company
        self._name = name

    def progressed(self, motion: Motion, pose: Pose) -> None:
        self._company.log.append((self._name, motion, pose))

    def passing(self, pose: Pose) -> None:
        self._company.passed.append((self._name, pose))
