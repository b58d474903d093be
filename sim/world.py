"""One world that several robots share. Deterministic: the same programs give the same run, at any speed.

From ``join`` to ``leave`` a robot takes part in the world's turns. A run that must not depend on how fast
threads start announces all robots first, with ``expect``.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from msgspec.structs import replace

from devices.ports.robot import Pace, Watcher
from sim.clock import Seat, Turns
from sim.geometry import Placement
from sim.ground import Ground, Looks
from sim.robot import SimulatedRobot
from sim.scene import Scene, moved


class _AtOnce:
    """A pace that never waits: the caller decides when the next tick is due."""

    def sleep(self, seconds: float) -> bool:  # noqa: ARG002 -- the port gives it
        return True


class World:
    """A simulated scene."""

    def __init__(self, scene: Scene, *, seed: int = 0, looks: Looks | None = None) -> None:
        """``seed``: of whatever is drawn by lot; 0 draws nothing, all is exact. ``looks``: see ``Ground``."""
        self.scene = scene
        self.seed = seed
        self.ground = Ground(scene, looks)
        """Where everything is."""
        self._turns = Turns()
        self.ground.follow(self._turns.now, self._turns.cut)
        self._seats = {index: Seat(self._turns, rank) for rank, index in enumerate(scene.robots)}
        self._robots: dict[int, SimulatedRobot] = {}

    def robot(
        self,
        name: str | None = None,
        *,
        pace: Pace,
        watcher: Watcher | None = None,
        speed: float | None = None,
    ) -> SimulatedRobot:
        """The robot called ``name``, or the world's first one. KeyError if the world has no such robot."""
        index = self._index(name)
        if index in self._robots:
            self._robots[index].go_home()  # another one stands there from now on
        robot = SimulatedRobot(
            self.ground,
            index,
            self._seats[index],
            pace=pace,
            watcher=watcher,
            speed=speed,
            seed=self.seed,
        )
        self._robots[index] = robot
        return robot

    def inhabitant(self, name: str) -> SimulatedRobot:
        """The robot of that name that was made last; where there is none, one that never waits."""
        return self._robots.get(self._index(name)) or self.robot(name, pace=_AtOnce())

    def change(self, index: int, **properties: object) -> None:
        """Change the colour or mark of a model. Only while no robot takes part."""
        models = list(self.scene.models)
        models[index] = replace(models[index], **properties)
        self.rebuild(replace(self.scene, models=tuple(models)), {each.root: each.root for each in models})

    def expect(self, names: Iterable[str]) -> None:
        """These robots take part from now on, all from the same moment, whenever their programs come.

        Each must ``leave``, its program having come or not. KeyError for a name that no robot has.
        """
        self._turns.expect([self._seats[self._index(name)] for name in names])

    def turn(self) -> tuple[str, float] | None:
        """The robot whose turn it is while others wait, and the world's time; None if none waits."""
        held = self._turns.held_by()
        return None if held is None else (self.scene.robot_names[held[0]], held[1])

    def poses(self) -> Mapping[str, Placement]:
        """The true places of all robots that were made, by name."""
        return {robot.name: robot.placement for robot in tuple(self._robots.values())}

    def moved_things(self) -> Mapping[int, Placement]:
        """The places of pushed or carried things, by the index of their (top-level) model."""
        return {root: now for root, now in self.ground.moved().items() if root not in self._seats}

    def scene_now(self) -> Scene:
        """The scene with everything where it is now, robots too."""
        return moved(self.scene, self.ground.moved())

    def get_ready(self) -> None:
        """Load and make now what the first movement would."""
        from sim import handling, motion, movement  # noqa: F401 -- loaded now, not by the first movement

        for robot in tuple(self._robots.values()):
            robot.get_ready()
        self.ground.begin()

    def reset(self) -> None:
        """Reset everything to its start. Only while no robot takes part."""
        for robot in tuple(self._robots.values()):
            robot.reset()
        self.ground.put_things_back()

    @property
    def is_holding(self) -> bool:
        """Whether a robot has something in its gripper."""
        return any(robot.holds is not None for robot in tuple(self._robots.values()))

    def held_by(self, name: str | None) -> int | None:
        """The index of the thing in the gripper of a robot; None if it holds nothing, or never began."""
        robot = self._robots.get(self._index(name)) if self.scene.robots else None
        return robot.holds if robot is not None else None

    def places_in(self, scene: Scene, index_of: Mapping[int, int]) -> Mapping[int, Placement]:
        """The places of moved things in another scene; see ``rebuild``."""
        starts = self.scene.models
        return {
            index_of[old]: place
            for old, place in self.moved_things().items()
            if old in index_of and scene.models[index_of[old]].pose == starts[old].pose
        }

    def rebuild(self, scene: Scene, index_of: Mapping[int, int]) -> None:
        """Another scene with the same robots, which stay where they are. Only while no robot takes part.

        ``index_of``: the new index of each model at the top level that is still there. Things that were
        pushed stay there, except those with another start: they are there.
        """
        ground = Ground(scene)
        for root, place in self.places_in(scene, index_of).items():
            ground.put(root, place)
        self.scene, self.ground = scene, ground
        self._seats = {index_of[old]: seat for old, seat in self._seats.items()}
        self._robots = {index_of[old]: robot for old, robot in self._robots.items()}
        for index, robot in self._robots.items():
            robot.stand_on(ground, index)

    def _index(self, name: str | None) -> int:
        if not self.scene.robots:
            raise KeyError(name or "")
        return self.scene.robots[0] if name is None else self.scene.robot(name).index
