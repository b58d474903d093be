"""The belt follows what the robot's sensors tell as it moves: the same with a real robot and a simulated one.

Everything goes out as ``belt`` events, and only changes do; who has no belt reads or hears them. Called in
the program's thread. Rule: the robot does and reads the same with the belt on as with it off.
"""

from __future__ import annotations

from collections.abc import Mapping

from devices.ports.robot import Bearing, Robot
from donnie_tui.core import belt
from donnie_tui.core.belt import BeltSettings, Levels
from donnie_tui.core.events import BeltShown, CueSounded
from donnie_tui.core.hub import Hub

_CUE = "belt"


class BeltFeeling:
    """What is felt of the surroundings while the belt is on."""

    def __init__(self, robot: Robot, hub: Hub, settings: BeltSettings) -> None:
        self._robot = robot
        self._hub = hub
        self._settings = settings
        self._shown: Levels = belt.OFF
        self._levels: dict[Bearing, int] = {}
        self._steps: Mapping[Bearing, int] = {}
        self.is_on = False

    def switch(self, on: bool) -> None:
        """From now on, or no longer. The surroundings are felt at once."""
        self.is_on = on
        if on:
            self.felt()
        else:
            self._show(belt.OFF)

    def forget(self) -> None:
        """Begin anew: off."""
        self.is_on = False
        self._levels, self._steps = {}, {}

    def rest(self) -> None:
        """A run is over: the motors are off until the robot moves again."""
        self._show(belt.OFF)
        self._levels, self._steps = {}, {}

    def felt(self) -> None:
        """The robot has moved a little: what changed is shown; what came a level nearer strikes first."""
        if not self.is_on:
            return
        before, self._steps = self._steps, self._robot.known_distances()
        levels = {bearing: self._settings.level(steps) for bearing, steps in self._steps.items()}
        nearer = frozenset(each for each in levels if each in before and levels[each] > self._levels[each])
        self._levels = levels
        if nearer:
            self._show(belt.approach(levels, nearer, self._settings))
            self._sound(min(nearer, key=self._steps.__getitem__))
        self._show(belt.presence(levels, self._settings))

    def bumped(self, bearing: Bearing) -> None:
        """The robot hit something there."""
        if self.is_on:
            self._show(belt.bump(bearing, self._settings))
            self._show(belt.presence(self._levels, self._settings))

    def pulse(self, bearing: Bearing) -> None:
        """One blow there, whatever is felt otherwise."""
        before = self._shown
        self._hub.publish(BeltShown(belt.pulse(bearing, self._settings)))
        self._hub.publish(BeltShown(before))

    def _show(self, levels: Levels) -> None:
        if levels != self._shown:
            self._shown = levels
            self._hub.publish(BeltShown(levels))

    def _sound(self, bearing: Bearing) -> None:
        degrees = float(bearing.value if bearing.value <= 180 else bearing.value - 360)
        self._hub.publish(CueSounded(_CUE, degrees, float(self._steps[bearing])))
