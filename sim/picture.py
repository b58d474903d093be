"""The scene as a grid of letters and a list of things, for maps and descriptions. Values only.

A cell is one step wide (more in a large world) and its middle is a whole step, so that a robot at (0, 0) is
in the middle of a cell. Walls are ``#``, free floor is ``.``, things have the letter of their kind.

``Room`` measures all distances that are reported, as the range sensors do: free steps from the edge of the
robot's body to the edge of the thing.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import ceil, floor, inf
from string import ascii_lowercase

from msgspec import Struct

from devices.ports.robot import STEP, Pose
from sim.geometry import (
    Edge,
    Point,
    Raster,
    angle_of,
    contains,
    covered,
    edges,
    edges_apart,
    nearest_on_edge,
    outline_contact,
    placed,
    seen_from,
)
from sim.parts import body_of
from sim.scene import Model, Scene

MOST_CELLS = 400
"""Cells along one side; beyond it a cell is several steps wide."""
OPEN_HALF = 30
"""Steps to each side of the robot that are shown of a floor without walls."""
LARGE = 8
"""Steps: a thing as long as this has a capital letter."""
WALL = "#"
_TAKEN = "aov"
"""Letters that a map needs for the start, the trail and the robot."""
_WALL_KINDS = ("wall", "floorplan", "room", "map")


class Thing(Struct, frozen=True, eq=False):
    """One thing of the world that is neither wall nor the robot."""

    name: str
    """Empty if the world gives none."""
    kind: str
    """The word that made it in the world's file, such as ``chair``."""
    letter: str
    colour: str
    """The word of the language for its colour."""
    x: float
    y: float
    """Its centre, in steps; of a robot the place that it turns about."""
    width: float
    """Steps from west to east."""
    depth: float
    """Steps from south to north."""
    is_robot: bool = False
    """Another robot that can be programmed; of Stage's ``position`` models not all are."""
    heading: float = 0.0
    """Compass degrees; what a robot looks at."""
    index: int = 0
    """Its number among the world's models; events about its moves use it."""
    outlines: tuple[tuple[Point, ...], ...] = ()
    """Its polygons where they lie, in steps."""

    @property
    def _compared(self) -> tuple[object, ...]:
        """All fields except ``index`` and ``outlines``: equal things look the same."""
        return tuple(getattr(self, name) for name in self.__struct_fields__[:-2])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Thing) and self._compared == other._compared

    def __hash__(self) -> int:
        return hash(self._compared)


class Drawing(Struct, frozen=True):
    """A wall, thing or robot with its outlines, in steps."""

    outlines: tuple[tuple[Point, ...], ...]
    thing: Thing | None
    """None: a wall."""
    from_bitmap: bool
    """Its outlines are the pieces of one shape."""


class Picture(Struct, frozen=True):
    """A grid. The cell in the bottom left corner has its middle at ``left``, ``bottom`` (steps)."""

    left: int
    bottom: int
    width: int
    """Cells from west to east."""
    height: int
    cell: int
    """Steps that a cell is wide and high."""
    rows: tuple[str, ...]
    """From north to south, a letter a cell."""
    things: tuple[Thing, ...]
    has_walls: bool
    """Without walls the grid is a window on an endless floor."""
    walls: tuple[tuple[Point, ...], ...] = ()
    """The polygons of the walls, in steps."""
    body: tuple[tuple[Point, ...], ...] = ()
    """The polygons of the robot itself, in steps around its middle; it looks along x."""

    def at(self, x: float, y: float) -> tuple[int, int] | None:
        """Row and column of a place given in steps, or None outside the grid."""
        column = floor((x - self.left) / self.cell + 0.5)
        row = self.height - 1 - floor((y - self.bottom) / self.cell + 0.5)
        return (row, column) if 0 <= row < self.height and 0 <= column < self.width else None


class _Shape(Struct, frozen=True):
    """A top-level model with its outlines, in steps."""

    model: Model
    outlines: tuple[tuple[Point, ...], ...]
    is_wall: bool
    left: float
    bottom: float
    right: float
    top: float

    @property
    def length(self) -> float:
        return round(max(self.right - self.left, self.top - self.bottom), 6)


def picture(scene: Scene, robot: str | None = None) -> Picture:
    """The scene as ``robot`` (the first one, if None) finds it: everything but that robot itself."""
    me = _me(scene, robot)
    shapes = tuple(_shapes(scene, me))
    letters = _letters(shape for shape in shapes if not shape.is_wall)
    left, bottom, right, top = _bounds(me, shapes)
    cell = max(1, ceil(max(right - left, top - bottom) / MOST_CELLS))
    width, height = ceil((right - left) / cell) + 1, ceil((top - bottom) / cell) + 1
    grid = _Grid(left, bottom, width, height, cell)
    for shape in sorted(shapes, key=lambda shape: not shape.is_wall):
        letter = WALL if shape.is_wall else _sized(letters[_kind(shape.model)], shape)
        grid.draw(shape, letter)
    robots = frozenset(scene.robots)
    things = tuple(_thing(shape, letters, robots) for shape in shapes if not shape.is_wall)
    has_walls = any(shape.is_wall for shape in shapes)
    walls = tuple(points for shape in shapes if shape.is_wall for points in shape.outlines)
    return Picture(left, bottom, width, height, cell, grid.rows(), things, has_walls, walls, _body(scene, me))


def _body(scene: Scene, me: Model | None) -> tuple[tuple[Point, ...], ...]:
    """The body in steps, without the paddles of a gripper, between which there is room."""
    if me is None:
        return ()
    paddles = {
        points
        for model in scene.tree(me.index)
        if model.gripper
        for points in _from(me, tuple(model.outlines())[1:])
    }
    polygons = (points for points in body_of(scene, me.index).polygons if points not in paddles)
    return tuple(tuple((x / STEP, y / STEP) for x, y in points) for points in polygons)


def _from(me: Model, outlines: Iterable[tuple[Point, ...]]) -> Iterator[tuple[Point, ...]]:
    return (seen_from(points, me.pose.x, me.pose.y, me.pose.yaw) for points in outlines)


def drawings(scene: Scene) -> tuple[Drawing, ...]:
    """Everything that stands in the scene, as lines."""
    return tuple(
        Drawing(each.outlines, None if each.letter == WALL else each, bool(scene.models[each.index].bitmap))
        for each in all_things(scene)
    )


def all_things(scene: Scene) -> tuple[Thing, ...]:
    """Everything that stands in the scene: robots and walls too, whose letter is ``WALL``.

    Things have the letters that ``picture`` gives.
    """
    me, robots = _me(scene, None), frozenset(scene.robots)
    shapes = tuple(_shapes(scene, None, walls_around=me))
    letters = _letters(shape for shape in shapes if not shape.is_wall and shape.model is not me)
    if me is not None:
        letters.setdefault(_kind(me), "x")
    return tuple(_thing(shape, letters, robots) for shape in shapes)


def _me(scene: Scene, robot: str | None) -> Model | None:
    if robot is not None:
        return scene.robot(robot)
    return scene.models[scene.robots[0]] if scene.robots else None


def _shapes(scene: Scene, me: Model | None, walls_around: Model | None = None) -> Iterator[_Shape]:
    parts: dict[int, list[Model]] = {}
    for model in scene.models:
        parts.setdefault(model.root, []).append(model)
    for root, tree in parts.items():
        if me is None or root != me.index:
            outlines = tuple(
                tuple((x / STEP, y / STEP) for x, y in points)
                for part in tree
                if part.solid or part.seen
                for points in part.outlines()
            )
            if outlines:
                yield _shape(scene.models[root], outlines, walls_around or me)


def _shape(model: Model, outlines: tuple[tuple[Point, ...], ...], me: Model | None) -> _Shape:
    xs = [x for points in outlines for x, _ in points]
    ys = [y for points in outlines for _, y in points]
    box = (min(xs), min(ys), max(xs), max(ys))
    return _Shape(model, outlines, _is_wall(model, box, me), *box)


def is_wall(model: Model, me: Model | None) -> bool:
    """Whether descriptions and maps show it as a wall, for the robot ``me``."""
    outlines = tuple(model.outlines())
    return bool(outlines) and _shape(model, outlines, me).is_wall


def _is_wall(model: Model, box: tuple[float, float, float, float], me: Model | None) -> bool:
    """Whether it is an outline, a floor plan, named a wall, or around the robot."""
    if model.type != "model":
        return False
    if model.boundary or model.kind.lower().startswith(_WALL_KINDS) or model.name.lower().startswith("wall"):
        return True
    if me is None:
        return False
    x, y = me.pose.x / STEP, me.pose.y / STEP
    return box[0] < x < box[2] and box[1] < y < box[3]


def _bounds(me: Model | None, shapes: tuple[_Shape, ...]) -> tuple[int, int, int, int]:
    """Whole steps: everything that stands in the world, and floor around the robot where no walls are."""
    boxes = [(shape.left, shape.bottom, shape.right, shape.top) for shape in shapes]
    x, y = (me.pose.x / STEP, me.pose.y / STEP) if me is not None else (0.0, 0.0)
    around = 1 if any(shape.is_wall for shape in shapes) else OPEN_HALF
    boxes.append((x - around, y - around, x + around - 1, y + around - 1))
    lefts, bottoms, rights, tops = zip(*boxes, strict=True)
    return (
        floor(min(lefts) + 0.5 + 1e-6),
        floor(min(bottoms) + 0.5 + 1e-6),
        ceil(max(rights) - 0.5 - 1e-6),
        ceil(max(tops) - 0.5 - 1e-6),
    )


class _Grid:
    def __init__(self, left: int, bottom: int, width: int, height: int, cell: int) -> None:
        self._raster = Raster(left, bottom, cell, width, height)
        self._cells = [bytearray(b"." * width) for _ in range(height)]

    def draw(self, shape: _Shape, letter: str) -> None:
        """Walls mark every cell that they touch, things those that they fill well, and one at least."""
        half = self._raster.cell * (0.5 - (0.02 if shape.is_wall else 0.3))
        drawn = False
        for outline in shape.outlines:
            for row, first, last in covered(outline, self._raster, half):
                self._cells[row][first : last + 1] = letter.encode() * (last + 1 - first)
                drawn = True
        if not drawn:
            row, column = self._cell((shape.left + shape.right) / 2, (shape.bottom + shape.top) / 2)
            self._cells[row][column] = ord(letter)

    def rows(self) -> tuple[str, ...]:
        return tuple(row.decode() for row in reversed(self._cells))

    def _cell(self, x: float, y: float) -> tuple[int, int]:
        it = self._raster
        row, column = floor((y - it.bottom) / it.cell + 0.5), floor((x - it.left) / it.cell + 0.5)
        return min(it.height - 1, max(0, row)), min(it.width - 1, max(0, column))


def _kind(model: Model) -> str:
    """The kind of a thing: the macro's word, else the thing's name."""
    return model.kind if model.kind != model.type else model.called or model.type


def _letters(shapes: Iterable[_Shape]) -> dict[str, str]:
    """A letter for every kind of thing: its first that is not taken yet."""
    letters: dict[str, str] = {}
    for shape in shapes:
        kind = _kind(shape.model)
        if kind not in letters:
            wanted = (*kind.lower(), *ascii_lowercase)
            taken = {*_TAKEN, *letters.values()}
            free = (letter for letter in wanted if letter in ascii_lowercase and letter not in taken)
            letters[kind] = next(free, "x")
    return letters


def _sized(letter: str, shape: _Shape) -> str:
    return letter.upper() if shape.length >= LARGE else letter


def _thing(shape: _Shape, letters: dict[str, str], robots: frozenset[int]) -> Thing:
    model = shape.model
    is_robot = model.index in robots
    x, y = (shape.left + shape.right) / 2, (shape.bottom + shape.top) / 2
    if is_robot:
        x, y = model.pose.x / STEP, model.pose.y / STEP
    return Thing(
        name=model.called,
        kind=model.kind,
        letter=WALL if shape.is_wall else _sized(letters[_kind(model)], shape),
        colour=model.colour.family,
        x=round(x, 6),
        y=round(y, 6),
        width=round(shape.right - shape.left, 6),
        depth=round(shape.top - shape.bottom, 6),
        is_robot=is_robot,
        heading=round(90.0 - model.pose.yaw, 6) % 360.0 if is_robot else 0.0,
        index=model.index,
        outlines=shape.outlines,
    )


HALF_A_CENTIMETRE = 0.1
"""In steps."""
Outlines = Sequence[Sequence[Point]]


class Room:
    """A robot at a place of a picture. Lengths are in steps, directions in compass degrees.

    As in the simulator, a thing around its middle, such as a floor drawn as a box, is not in its way.
    """

    def __init__(self, picture: Picture, pose: Pose) -> None:
        self._pose = pose
        self._body = picture.body or (((0.0, 0.0),),)
        self.walls: Outlines = [each for each in picture.walls if not contains(each, pose.x, pose.y)]
        things = (points for each in picture.things for points in each.outlines)
        self.all: Outlines = (*self.walls, *things)

    def ahead(self, outlines: Outlines, heading: float) -> float:
        """How far the robot could be moved to ``heading``, as it stands, until it touches; or infinity."""
        mine = self._edges(90.0 - heading)
        gaps = (outline_contact(mine, edges(self._seen(points, heading)))[0] for points in outlines)
        return min(gaps, default=inf)

    def nearest(self, outlines: Outlines) -> tuple[float, float]:
        """How far away its nearest edge is, and in which direction from the robot's middle."""
        theirs = [edge for points in outlines for edge in edges(self._seen(points, 90.0))]
        gap = min((edges_apart(a, b) for a in self._edges(0.0) for b in theirs), default=inf)
        x, y = min((nearest_on_edge(edge) for edge in theirs), key=_length2, default=(0.0, 0.0))
        return gap, 90.0 - angle_of(x, y)

    @staticmethod
    def whole(steps: float) -> int:
        """Whole steps of whole centimetres, as range sensors count them."""
        return floor(steps + HALF_A_CENTIMETRE)

    def _edges(self, angle: float) -> tuple[Edge, ...]:
        """The body's outline around the origin, seen in the direction ``angle``."""
        turned = 90.0 - self._pose.heading - angle
        return tuple(edge for points in self._body for edge in edges(placed(points, 0.0, 0.0, turned)))

    def _seen(self, points: Sequence[Point], heading: float) -> tuple[Point, ...]:
        return seen_from(points, self._pose.x, self._pose.y, 90.0 - heading)


def _length2(point: Point) -> float:
    return point[0] * point[0] + point[1] * point[1]
