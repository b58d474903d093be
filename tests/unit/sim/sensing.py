"""The senses of a robot in a small world, without its commands."""

from sim.geometry import Spot
from sim.ground import Ground
from sim.motion import Surroundings
from sim.scene import Scene
from sim.sensors import Senses, senses_of
from tests.unit.sim.floors import scene


class Sensing:
    """The first robot of a world, its senses, and where it stands."""

    def __init__(self, text: str) -> None:
        self.scene: Scene = scene(text)
        me = self.scene.robots[0]
        pose = self.scene.models[me].pose
        self.spot = Spot(pose.x, pose.y, pose.yaw)
        self.senses: Senses = senses_of(self.scene, me)
        self.around = Surroundings(Ground(self.scene), me)

    def name(self, model: int) -> str:
        return self.scene.models[model].name
