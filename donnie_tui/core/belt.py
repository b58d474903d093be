"""The vibration belt: which motors run for a direction, at which level, and the same in words.

Seven columns go around the body: from the back over the left, the front (column 3) and the right to the back
again. Both rows show the same, except for an approach. Levels are 0 off, 1 weak, 2 medium, 3 strong. The
upper row of seven comes first.

``BeltDisplay`` follows the robot's sensors as the robot moves, real or simulated. It publishes only changes,
as ``belt`` events, so that learners without a belt can read or listen to them. It is called in the program's
thread. Rule: the belt never changes what the robot does or reads.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from msgspec import Struct, field

from devices.ports.robot import Bearing, Robot
from donnie_tui.core.events import BeltShown, CueSounded
from donnie_tui.core.hub import Hub
from donnie_tui.core.wording import Wording

COLUMNS = 7
MOTORS = 2 * COLUMNS
OFF = (0,) * MOTORS
WEAK, MEDIUM, STRONG = 1, 2, 3

Levels = tuple[int, ...]
"""14 levels."""

_COLUMNS_OF: Mapping[Bearing, tuple[int, ...]] = MappingProxyType(
    {
        Bearing.BACK: (0, 6),
        Bearing.BACK_LEFT: (1,),
        Bearing.FRONT_LEFT: (2,),
        Bearing.FRONT: (3,),
        Bearing.FRONT_RIGHT: (4,),
        Bearing.BACK_RIGHT: (5,),
    }
)
"""The columns of the original belt."""

_WORD_OF_LEVEL = {WEAK: "belt-weak", MEDIUM: "belt-medium", STRONG: "belt-strong"}


class BeltSettings(Struct, frozen=True):
    """How distances become levels, and directions columns."""

    strong: int = 5
    """Steps up to which something is felt strongly."""
    medium: int = 10
    weak: int = 20
    columns: Mapping[Bearing, tuple[int, ...]] = field(default_factory=lambda: _COLUMNS_OF)

    def level(self, steps: int) -> int:
        """How strong something that many steps away is felt."""
        limits = ((self.strong, STRONG), (self.medium, MEDIUM), (self.weak, WEAK))
        return next((level for limit, level in limits if steps <= limit), 0)


def pulse(bearing: Bearing, settings: BeltSettings | None = None) -> Levels:
    """Strong where that direction is felt, off elsewhere."""
    row = _row({bearing: STRONG}, settings or BeltSettings())
    return row + row


def presence(levels: Mapping[Bearing, int], settings: BeltSettings) -> Levels:
    """Shows obstacles: each direction at its level, both rows the same."""
    row = _row(levels, settings)
    return row + row


def approach(levels: Mapping[Bearing, int], nearer: frozenset[Bearing], settings: BeltSettings) -> Levels:
    """Shows an approach: the upper row pulses while the lower row shows the distance now."""
    struck = {**levels, **dict.fromkeys(nearer, STRONG)}
    return _row(struck, settings) + _row(levels, settings)


def bump(bearing: Bearing, settings: BeltSettings) -> Levels:
    """Shows a collision: that direction and both neighbours at full strength."""
    hit = settings.columns[bearing]
    wide = {(column + side) % COLUMNS for column in hit for side in (-1, 0, 1)}
    row = tuple(STRONG if column in wide else 0 for column in range(COLUMNS))
    return row + row


def levels_by_bearing(levels: Levels, settings: BeltSettings | None = None) -> dict[Bearing, int]:
    """The level of each direction, without those that are off. The upper row alone may pulse."""
    columns, lower = (settings or BeltSettings()).columns, levels[COLUMNS:]
    strongest = {bearing: max((lower[each] for each in columns[bearing]), default=0) for bearing in Bearing}
    return {bearing: level for bearing, level in strongest.items() if level}


def in_words(levels: Levels, wording: Wording, settings: BeltSettings | None = None) -> str:
    """The levels in words: "Belt: front strong, front right weak."."""
    parts = [
        f"{wording(f'belt-{bearing.name.lower()}')} {wording(_WORD_OF_LEVEL[level])}"
        for bearing, level in levels_by_bearing(levels, settings).items()
    ]
    return wording("belt-felt", what=", ".join(parts)) if parts else wording("belt-nothing")


def rows_in_words(levels: Levels, wording: Wording) -> tuple[str, str]:
    """Each motor's level, from the back over the left to the front (the fourth) and on to the back."""
    upper, lower = (" ".join(map(str, row)) for row in rows(levels))
    return wording("belt-upper", levels=upper), wording("belt-lower", levels=lower)


def rows(levels: Levels) -> tuple[Levels, Levels]:
    """The upper and the lower row, for a drawing: from the back over the left to the front and on."""
    return levels[:COLUMNS], levels[COLUMNS:]


def _row(levels: Mapping[Bearing, int], settings: BeltSettings) -> Levels:
    """One row of levels. Where two directions share a column, the stronger one counts."""
    row = [0] * COLUMNS
    for bearing, level in levels.items():
        for column in settings.columns[bearing]:
            row[column] = max(row[column], level)
    return tuple(row)


_CUE = "belt"


class BeltDisplay:
    """Shows the robot's surroundings on the belt while it is on."""

    def __init__(self, robot: Robot, hub: Hub, settings: BeltSettings) -> None:
        self._robot = robot
        self._hub = hub
        self._settings = settings
        self._shown: Levels = OFF
        self._levels: dict[Bearing, int] = {}
        self._steps: Mapping[Bearing, int] = {}
        self.is_on = False

    def switch(self, on: bool) -> None:
        """Switches the belt on or off; on shows the surroundings at once."""
        self.is_on = on
        if on:
            self.update()
        else:
            self._show(OFF)

    def forget(self) -> None:
        """Switches the belt off for a new start."""
        self.is_on = False
        self._levels, self._steps = {}, {}

    def rest(self) -> None:
        """Switches the motors off at the end of a run, until the robot moves again."""
        self._show(OFF)
        self._levels, self._steps = {}, {}

    def update(self) -> None:
        """Shows what changed after a small move; what came a level nearer pulses first."""
        if not self.is_on:
            return
        before, self._steps = self._steps, self._robot.known_distances()
        levels = {bearing: self._settings.level(steps) for bearing, steps in self._steps.items()}
        nearer = frozenset(each for each in levels if each in before and levels[each] > self._levels[each])
        self._levels = levels
        if nearer:
            self._show(approach(levels, nearer, self._settings))
            self._sound(min(nearer, key=self._steps.__getitem__))
        self._show(presence(levels, self._settings))

    def show_bump(self, bearing: Bearing) -> None:
        """Shows that the robot hit something there."""
        if self.is_on:
            self._show(bump(bearing, self._settings))
            self._show(presence(self._levels, self._settings))

    def pulse(self, bearing: Bearing) -> None:
        """One pulse there, on top of what the belt shows."""
        before = self._shown
        self._hub.publish(BeltShown(pulse(bearing, self._settings)))
        self._hub.publish(BeltShown(before))

    def _show(self, levels: Levels) -> None:
        if levels != self._shown:
            self._shown = levels
            self._hub.publish(BeltShown(levels))

    def _sound(self, bearing: Bearing) -> None:
        degrees = float(bearing.value if bearing.value <= 180 else bearing.value - 360)
        self._hub.publish(CueSounded(_CUE, degrees, float(self._steps[bearing])))
