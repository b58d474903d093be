"""How far a robot walks and turns among things, in metres and degrees worked out by hand.

The blind robot is 0.2 m long and 0.1 m wide. Its corners are sqrt(0.0125) m from its middle.
"""

from math import asin, atan2, degrees, hypot, inf

import pytest

from devices.ports.robot import STEP, Bearing, StoppedBy
from sim.geometry import Placement, Spot, Wedge, direction
from sim.ground import Ground
from sim.motion import Contact, Mover, OtherRobots, Surroundings, WalkOutcome, less_skin
from tests.unit.sim.floors import BOX_ROBOT, scene

SKIN = 1e-4
HERE = Spot(0, 0, 0)
RADIUS = hypot(0.1, 0.05)
BLIND = BOX_ROBOT + "blind( pose [ 0 0 0 0 ] )\n"
WATCHFUL = """
define sonar sensor ( range [ 0 3.0 ] fov 0.1 )
position( size [ 0.2 0.1 0.1 ] pose [ 0 0 0 0 ]
  ranger( sonar( pose [ 0.1 0 0 0 ] ) sonar( pose [ -0.1 0 0 180 ] ) ) )
"""
OCTAGON = """
position( size [ 0.128 0.128 0.12 ] block( points 8 point[0] [ 5 0 ] point[1] [ 12 0 ] point[2] [ 17 5 ]
  point[3] [ 17 12 ] point[4] [ 12 17 ] point[5] [ 5 17 ] point[6] [ 0 12 ] point[7] [ 0 5 ] z [ 0 1 ] ) )
"""
PUSHABLE = "pushable 1"


def box(left: float, bottom: float, right: float, top: float, more: str = "") -> str:
    x, y = (left + right) / 2, (bottom + top) / 2
    return f"model( size [ {right - left:.9f} {top - bottom:.9f} 1 ] pose [ {x:.9f} {y:.9f} 0 0 ] {more} )\n"


def wall(face: float, turned: int = 0, more: str = "") -> str:
    """A wall whose face is that far from the middle, in that direction."""
    x, y = direction(turned)
    far = face + 0.1
    return f"model( size [ 0.2 4 1 ] pose [ {x * far:.9f} {y * far:.9f} 0 {turned} ] {more} )\n"


def mover(text: str) -> Mover:
    return Mover(Ground(scene(text)), 0)


# --- walks


@pytest.mark.parametrize("turned", [0, 90, 180, 270])
@pytest.mark.parametrize("bearing", [Bearing.FRONT, Bearing.BACK])
@pytest.mark.parametrize("careful", [False, True])
def test_a_walk_ends_where_the_body_comes_to_a_wall(turned: int, bearing: Bearing, careful: bool) -> None:
    it = mover(BLIND + wall(0.5, turned))
    spot = Spot(0, 0, turned if bearing is Bearing.FRONT else turned + 180)

    walks = [it.walk(spot, bearing, steps, careful=careful) for steps in (0, 3, 7, 8, 50)]

    whole, bumped = [(0, None), (3, None), (7, None)], (pytest.approx(0.4 - SKIN), 7, StoppedBy.COLLISION)
    assert [(each.metres, each.steps, each.stopped_by) for each in walks] == [
        *((pytest.approx(steps * STEP), steps, stopped_by) for steps, stopped_by in whole),
        *(bumped, bumped),
    ]


@pytest.mark.parametrize(
    ("face", "steps"), [(0.606, 9), (0.594, 8), (0.556, 8), (0.544, 7), (0.21, 1), (0.19, 0)]
)
@pytest.mark.parametrize("bearing", [Bearing.FRONT, Bearing.BACK])
def test_a_sonar_ends_a_walk_while_two_steps_are_free(face: float, steps: int, bearing: Bearing) -> None:
    """It is 0.1 m before the middle, and reads whole centimetres."""
    it = mover(WATCHFUL + wall(face, 0 if bearing is Bearing.FRONT else 180))

    outcome = it.walk(HERE, bearing, 50)

    assert outcome == WalkOutcome(pytest.approx(steps * STEP), steps, StoppedBy.OBSTACLE)  # type: ignore[arg-type]


def test_a_walk_ends_without_a_reason_at_what_gives_way() -> None:
    it = mover(BLIND + box(0.3, -0.1, 0.5, 0.1, PUSHABLE))

    assert it.walk(HERE, Bearing.FRONT, 9) == WalkOutcome(pytest.approx(0.2 - SKIN), 3, None)  # type: ignore[arg-type]
    assert it.walk(HERE, Bearing.FRONT, 3) == WalkOutcome(3 * STEP, 3, None)


@pytest.mark.parametrize(("steps", "calls"), [(99, 0), (100, 1), (199, 1), (200, 2)])
def test_a_careful_walk_asks_every_hundred_steps_whether_to_go_on(steps: int, calls: int) -> None:
    it, asked = mover(BLIND), list[int]()

    def asking() -> bool:
        asked.append(1)
        return True

    assert it.walk(HERE, Bearing.FRONT, steps, asking, careful=True).steps == steps
    assert len(asked) == calls
    assert it.walk(HERE, Bearing.FRONT, steps, careful=True).steps == steps
    stopped = it.walk(HERE, Bearing.FRONT, 100, lambda: False, careful=True)
    assert stopped == WalkOutcome(0.0, 0, StoppedBy.USER)


@pytest.mark.parametrize(
    ("contact", "squarely", "way"),
    [
        (0.3, 1.0, 0.3 - SKIN),
        (0.3, 0.5, 0.3 - 2 * SKIN),
        (0.3, 0.001, 0.3 - 0.005),  # grazing, it keeps 5 mm
        (0.3, 0.0, 0.3 - 0.005),
        (SKIN / 2, 1.0, 0.0),
        (0.0, 1.0, 0.0),
        (inf, 1.0, inf),
    ],
)
def test_a_body_keeps_a_skin_across_its_way(contact: float, squarely: float, way: float) -> None:
    assert less_skin(contact, squarely) == pytest.approx(way)


# --- contacts

NEAR, FAR, ASIDE = range(2, 5)
"""After the robot and its ranger."""
ROWS = (
    BLIND
    + box(0.13, 0.01, 0.2, 0.3)
    + box(0.14, -0.3, 0.2, -0.01)
    + box(0.0, 0.07, 0.05, 0.3)
    + box(0.11, -0.1, 0.12, 0.1, "obstacle_return 0")
)


@pytest.mark.parametrize(
    ("angle", "but", "metres", "root"),
    [
        (0, (), 0.03, NEAR),
        (0, (NEAR,), 0.04, FAR),
        (0, (NEAR, FAR), inf, None),
        (0, (FAR,), 0.03, NEAR),
        (180, (), inf, None),
        (90, (), 0.02, ASIDE),
        (90, (ASIDE,), inf, None),
        (-90, (), inf, None),
    ],
)
def test_the_first_contact_is_with_the_nearest_solid_part(
    angle: float, but: tuple[int, ...], metres: float, root: int | None
) -> None:
    it = mover(ROWS)

    found = it.contact(HERE, angle, STEP, but)

    assert found.metres == pytest.approx(metres - SKIN if metres < inf else inf)
    assert (found.part.root if found.part else None) == root
    assert (found == Contact(inf, None)) is (root is None)


@pytest.mark.parametrize(
    ("length", "roots"), [(0.01, []), (0.019, []), (0.021, [NEAR]), (0.029, [NEAR]), (0.031, [NEAR, FAR])]
)
def test_on_the_way_are_the_parts_up_to_two_skins_beyond_it(length: float, roots: list[int]) -> None:
    """The widest skin is 5 mm."""
    assert [part.root for part in mover(ROWS).on_the_way(HERE, 0, length)] == roots


@pytest.mark.parametrize(
    ("y", "is_met"), [(0.0, True), (0.055, True), (0.0701, False), (-0.055, True), (-0.0701, False)]
)
def test_a_round_body_touches_as_a_disc_of_its_corners(y: float, is_met: bool) -> None:
    """The corners of the octagon are 0.0692 m from its middle; a post is met at its near corner."""
    radius = hypot(0.064, 0.064 * 7 / 17)
    it = mover(
        OCTAGON
        + box(0.1, min(y, y + 0.3 * (1 if y >= 0 else -1)), 0.2, max(y, y + 0.3 * (1 if y >= 0 else -1)))
    )
    way = 0.1 - ((radius + SKIN) ** 2 - y * y) ** 0.5 if is_met else inf

    assert it.body.is_round
    assert it.contact(HERE, 0, STEP).metres == pytest.approx(way)


# --- turns

CORNER = degrees(atan2(0.05, 0.1))
"""The direction of the robot's left front corner."""


def corner_at(height: float) -> float:
    """Degrees until a corner is so far to the left."""
    return degrees(asin(height / RADIUS)) - CORNER


@pytest.mark.parametrize(
    ("face", "turned", "most"),
    [
        (0.1, 90, 36.87),
        (0.1, -90, 36.87),
        (0.09, 90, corner_at(0.09)),
        (0.1119, 90, None),
        (0.0504, 90, corner_at(0.0504)),
    ],
)
def test_a_turn_ends_before_a_corner_touches(face: float, turned: int, most: float | None) -> None:
    """A corner at 1, 2 of a circle turns to 2, 1: by an angle of the triangle 3, 4, 5."""
    it = mover(BLIND + wall(face, turned))
    whole = 90 if most is None else int(most - 0.02)

    for sign in (1, -1):
        assert it.turn(HERE, sign * 90) == sign * whole
        assert it.turn(HERE, sign * whole) == sign * whole
        assert it.turn(HERE, sign * (whole + 1)) == sign * min(whole + 1, whole if most else 99)
        assert it.turn_contact(HERE, sign) == pytest.approx(inf if most is None else most, abs=1e-3)
        assert it.has_free_turn(HERE, sign * whole)
        assert it.has_free_turn(HERE, sign * (whole + 1)) is (most is None)
    assert it.turn(HERE, 0) == 0


def test_a_turn_is_stopped_on_one_side_and_not_on_the_other() -> None:
    """The post touches the left front corner."""
    it = mover(BLIND + box(0.08, 0.0501, 0.2, 0.2))

    for _ in range(2):
        assert (it.turn(HERE, 90), it.turn(HERE, -90)) == (0, -90)
    assert it.turn(Spot(-1, 0, 0), 90) == 90
    assert it.turn(HERE, 90) == 0


@pytest.mark.parametrize("steps", [0.5, 2.0])
def test_a_robot_turns_when_the_thing_at_its_corner_has_gone(steps: float) -> None:
    it = mover(BLIND + box(0.08, 0.0501, 0.2, 0.2, PUSHABLE))
    assert it.turn(HERE, 90) == 0

    it.around.ground.put(2, Placement(0, steps))

    assert it.turn(HERE, 90) == 90


def test_a_round_robot_turns_next_to_what_stays_and_not_into_what_may_have_moved() -> None:
    """A corner of the octagon is 22.4 degrees from the middle of a side, which is 0.064 m away."""
    radius, corner = hypot(0.064, 0.064 * 7 / 17), degrees(atan2(7, 17))
    least = corner - degrees(asin((radius**2 - 0.0645**2) ** 0.5 / radius))

    still, movable = (mover(OCTAGON + box(0.0645, -0.3, 0.2, 0.3, each)) for each in ("", PUSHABLE))
    far = mover(OCTAGON + box(0.0645, -0.3, 0.2, 0.3) + box(5, 5, 6, 6, PUSHABLE))

    assert (still.turn_contact(HERE, 1), far.turn_contact(HERE, -1)) == (inf, inf)
    assert (still.turn(HERE, 90), far.turn(HERE, 90)) == (90, 90)
    assert movable.turn_contact(HERE, 1) == pytest.approx(least)
    assert movable.turn_contact(HERE, -1) == pytest.approx(least)


def test_a_held_thing_turns_and_walks_along_until_it_is_released() -> None:
    """It reaches 0.3 m ahead; the wall is 0.2 m to the left, the other one 0.4 m ahead."""
    it = mover(BLIND + wall(0.2, 90) + wall(0.4))
    ends, touching = [], (((0.1, 0.1), (0.15, 0.1), (0.15, 0.1999), (0.1, 0.1999)),)
    for outlines in ((), (((0.1, -0.01), (0.3, -0.01), (0.3, 0.01), (0.1, 0.01)),), (), touching, ()):
        it.hold(outlines)
        if outlines is touching:
            assert it.turn(HERE, 90) == 0
        else:
            ends.append((it.turn(HERE, 90), it.walk(HERE, Bearing.FRONT, 9).metres, it.body.radius))

    free = (90, pytest.approx(0.3 - SKIN), pytest.approx(RADIUS))
    far = hypot(0.3, 0.01)
    held = int(degrees(asin(0.2 / far) - atan2(0.01, 0.3)) - 0.02)
    assert ends == [free, (held, pytest.approx(0.1 - SKIN), pytest.approx(far)), free, free]


# --- what is known to be free


@pytest.mark.parametrize(
    ("face", "is_free"), [(0.1500, False), (0.15005, False), (0.1502, True), (0.17, True), (0.4, True)]
)
@pytest.mark.parametrize("bearing", [Bearing.FRONT, Bearing.BACK])
def test_a_step_is_free_up_to_the_skin(face: float, is_free: bool, bearing: Bearing) -> None:
    turned = 0 if bearing is Bearing.FRONT else 180
    it = mover(BLIND + wall(face, turned))

    assert it.has_free_step(HERE, bearing) is is_free
    assert it.has_free_step(HERE, Bearing.BACK if turned == 0 else Bearing.FRONT)


@pytest.mark.parametrize("bearing", [Bearing.FRONT, Bearing.BACK])
def test_a_step_is_not_free_that_a_sonar_forbids(bearing: Bearing) -> None:
    turned = 0 if bearing is Bearing.FRONT else 180
    for face, is_blocked in ((0.195, True), (0.205, False)):
        it = mover(WATCHFUL + wall(face, turned))
        assert it.is_blocked(HERE, bearing) is is_blocked
        assert it.has_free_step(HERE, bearing) is not is_blocked
        assert not it.is_blocked(HERE, Bearing.BACK if turned == 0 else Bearing.FRONT)


def test_nothing_is_free_for_a_body_that_reaches_into_a_thing() -> None:
    """But for leaving it."""
    it = mover(BLIND + box(0.08, -0.3, 0.2, 0.3))

    assert not it.has_free_step(HERE, Bearing.BACK)
    assert not it.has_free_turn(HERE, 1)
    assert it.contact(HERE, 180, STEP).metres == inf
    assert it.contact(HERE, 0, STEP).metres == 0


@pytest.mark.parametrize(
    ("text", "guard", "walking", "turning"),
    [
        (BLIND, RADIUS + STEP + 0.01, RADIUS + 0.005 + 0.01, RADIUS + 2 * SKIN),
        (WATCHFUL, 0.1 + 2 * STEP + 0.01, 0.1 + 2 * STEP + 0.01, RADIUS + 2 * SKIN),
        ("position( size [ 2 2 1 ] )", 2**0.5 + STEP + 0.01, 2**0.5 + 0.015, 2**0.5 + 2 * SKIN),
    ],
)
def test_a_guard_is_what_a_step_or_a_sensor_reaches(
    text: str, guard: float, walking: float, turning: float
) -> None:
    """A step and a centimetre beyond the body, or two steps and a centimetre beyond the farthest sensor."""
    it = mover(text)

    assert (it.guard, it.walking_guard, it.turning_guard) == pytest.approx((guard, walking, turning))


def test_nothing_is_far_that_is_within_the_guard() -> None:
    """0.21 m, and 0.3 m more."""
    for face, is_far in ((0.5, False), (0.52, True)):
        for turned in (0, 90, 180, 270):
            assert mover(WATCHFUL + wall(face, turned)).is_far(HERE, 0.3) is is_far
    assert mover(WATCHFUL + wall(0.3, 0, "obstacle_return 0 ranger_return -1")).is_far(HERE, 0.3)
    assert not mover(WATCHFUL + wall(0.3, 0, "obstacle_return 0")).is_far(HERE, 0.3)


# --- other robots

ROBOT = 'position( name "{}" size [ 0.1 0.1 0.1 ] pose [ {} {} 0 0 ] ranger( sonar( ) ) )\n'
MANY = WATCHFUL + ROBOT.format("bob", 1, 0) + box(0.5, 0.5, 0.6, 0.6, PUSHABLE) + wall(2, 0)
BOB, THING, WALL = 2, 4, 5


def test_another_robot_is_near_that_can_stop_the_next_step() -> None:
    """Its corners are 0.0707 m around its middle; what stops a step is at most 0.21 m away."""
    it = mover(MANY)

    assert it.is_robot_near(Spot(0.73, 0, 0), 0)
    assert not it.is_robot_near(Spot(0.71, 0, 0), 0)
    assert it.is_robot_near(Spot(0.71, 0, 0), 0.02)
    assert not it.is_robot_near(Spot(0.55, 0.4, 0), 0), "that is a thing"
    assert not mover(WATCHFUL + box(0.2, -1, 0.3, 1, PUSHABLE)).is_robot_near(HERE, 0.3)


@pytest.mark.parametrize(
    ("gap", "rest", "is_met"), [(0.06, 0.4, True), (0.06, 0.1, False), (0.09, 0.9, True), (0.09, 0.7, False)]
)
def test_another_robot_is_met_that_leaves_less_than_a_step_after_the_rest(
    gap: float, rest: float, is_met: bool
) -> None:
    it = mover(MANY)
    spot = Spot(0.95 - gap - 0.1, 0, 0)

    assert it.is_met(spot, Bearing.FRONT, rest) is is_met
    assert it.is_met(Spot(1.05 + gap + 0.1, 0, 0), Bearing.BACK, rest) is is_met
    assert not it.is_met(spot, Bearing.BACK, rest)
    assert not it.is_met(Spot(2 - gap - 0.1, 0, 0), Bearing.FRONT, rest), "that is a wall"


def test_other_robots_are_seen_unless_something_is_before_them() -> None:
    around = Surroundings(Ground(scene(MANY)), 0)
    others = OtherRobots(around)

    def nearest(x: float, y: float, yaw: float) -> tuple[float, int | None]:
        metres, part = others.nearest(Wedge(x, y, yaw, direction(yaw), direction(5), 3.0), None)
        return metres, part.root if part else None

    assert nearest(0, 0, 0) == (pytest.approx(0.95), BOB)
    assert nearest(0, 0, 45) == (inf, None)
    assert nearest(1, 1, -90) == (pytest.approx(0.95), BOB)
    assert [part.root for part in others.within(-9, -9, 9, 9)] == [BOB]
    assert others.within(-9, -9, 0.9, 9) == []
    hits = others.first_hits(0, 0, [(2, 0), (1, 1), (0, 1), (5, 0)])
    assert [(part.root if part else None, at) for part, at in hits] == [
        *((BOB, pytest.approx(0.475)), (None, 1.0), (None, 1.0)),
        (BOB, pytest.approx(0.19)),
    ]
    assert others.is_any_near(Spot(0.5, 0, 0), 0.5)
    assert not others.is_any_near(Spot(0.5, 0, 0), 0.4)


def test_surroundings_are_all_but_the_robot_and_what_it_stands_in() -> None:
    floor = "model( size [ 9 9 0.1 ] )\n"
    around = Surroundings(Ground(scene(MANY + floor)), 0)
    without = around.without(frozenset((0, THING)))

    def roots(found: list[object]) -> list[int]:
        return [part.root for part in found]  # type: ignore[attr-defined]

    assert around.stands_in == (WALL + 1,)
    assert roots([*around.parts]) == [BOB, THING, WALL]
    assert roots([*without.parts]) == [BOB, WALL]
    assert roots([*around.within(-9, -9, 9, 9)]) == [BOB, THING, WALL]
    assert roots([*without.within(-9, -9, 9, 9)]) == [BOB, WALL]
    assert roots([*around.near(0.5, 0, 0.5)]) == [BOB, THING]
    assert roots([*around.near(0.3, 0.1, 0.3)]) == []
    assert roots([*without.near(0.5, 0, 0.5)]) == [BOB]
    assert around.has_company
    assert not Surroundings(Ground(scene(WATCHFUL + wall(1))), 0).has_company
    assert not around.has_room(0, 0, 0.05, 0), "it stands in something"


@pytest.mark.parametrize("turned", [0, 90, 180, 270])
def test_the_room_around_a_robot_is_known_until_it_leaves_it(turned: int) -> None:
    """The wall is 1 m away, in the direction that counts as x; 0.1015 m before it the guard begins.

    From -0.2, 0.1 a circle of 1.0985 m is free.
    """
    around = Surroundings(Ground(scene(BLIND + wall(1, turned))), 0)
    around.keep(0.1)
    c, s = direction(turned)

    def at(x: float, y: float) -> tuple[float, float]:
        return c * x - s * y, s * x + c * y

    def has_room(start: tuple[float, float], end: tuple[float, float], straight: bool = False) -> bool:
        return around.has_room(*at(*start), *at(*end), straight)

    def walls_near(x: float, y: float, reach: float) -> int:
        return len(around.near(*at(x, y), reach))

    assert walls_near(0.95, 0.1, 0.1) == 1
    middle = (-0.2, 0.1)
    assert has_room(middle, (0.89, 0.1))
    assert not has_room(middle, (0.9, 0.1), straight=True)
    assert not has_room(middle, (-0.2, 1.21))
    assert has_room(middle, (-0.2, 1.21), straight=True)
    assert has_room((0.3, 0.4), (0.6, 0.6))  # from another place in the circle
    assert not has_room((0.3, 0.4), (0.85, 0.6))
    assert has_room((0.3, 0.4), (0.85, 0.6), straight=True)
    assert [walls_near(x, 0.1, 0.1) for x in (0.89, 0.92, 0.95)] == [0, 1, 1]
    assert walls_near(0.5, 0.1, 0.6) == 1  # beyond the guard
    assert has_room((-2, -2), (-2, -1))
    assert not has_room((0.8, -2), (0.95, -2))
    around.keep(0.5)
    assert not has_room(middle, (0.6, 0.1))
    assert has_room(middle, (0.45, 0.1))


def test_a_robot_has_no_room_where_something_may_have_come() -> None:
    around = Surroundings(Ground(scene(BLIND + box(0.5, -0.1, 0.7, 0.1, PUSHABLE))), 0)
    around.keep(0.1)

    assert [around.has_room(0, 0, x, 0) for x in (0.2, 0.5)] == [True, False]
    around.ground.put(2, Placement(0.6, 3))
    assert around.has_room(0, 0, 0.5, 0)
    around.ground.put(2, Placement(0.25, 0.15))
    assert not around.has_room(0, 0, 0.5, 0)


@pytest.mark.parametrize("yaw", [0, 90, 180, 270])
@pytest.mark.parametrize("bearing", [Bearing.FRONT, Bearing.BACK])
def test_a_robot_goes_exactly_straight_between_posts(yaw: int, bearing: Bearing) -> None:
    """They are 0.3 mm from its way: half a degree over a step is more."""
    c, s = direction(yaw)
    way = 1 if bearing is Bearing.FRONT else -1
    posts = [(way * (0.13 + 0.2 * i), side * 0.0503) for i in range(3) for side in (1, -1)]
    text = "".join(
        f"model( size [ 0.02 0.02 1 ] pose [ {c * x - s * y:.9f} {s * x + c * y:.9f} 0 {yaw} ] )\n"
        for x, y in ((x, y + (0.01 if y > 0 else -0.01)) for x, y in posts)
    )
    it, spot = mover(BLIND + text), Spot(0, 0, yaw)

    for careful in (False, True):
        assert it.walk(spot, bearing, 12, careful=careful).steps == 12
    assert it.has_free_step(spot, bearing)
    far = spot.ahead(3 * STEP, yaw + (0 if way > 0 else 180))
    assert it.has_free_step(far, bearing)


def test_a_mover_is_asked_about_one_direction_after_the_other() -> None:
    it = mover(ROWS)
    ways = {0: 0.03, 90: 0.02, 180: inf, -90: inf, 45: None}

    for angle in (0, 90, 45, 0, 180, 45, 90, -90, 0):
        way = ways[angle]
        if way is not None:
            assert it.contact(HERE, angle, STEP).metres == pytest.approx(way - SKIN if way < inf else inf)
        else:
            assert it.contact(HERE, angle, STEP).metres < inf
    assert it.contact(HERE, 0, STEP).metres == pytest.approx(0.03 - SKIN)
    assert it.contact(Spot(0.01, 0, 0), 0, STEP).metres == pytest.approx(0.02 - SKIN)


@pytest.mark.parametrize(("side", "is_met"), [(-1, True), (1, False)])
def test_a_body_that_goes_aslant_meets_things_with_its_corner(side: int, is_met: bool) -> None:
    """It looks to 30 degrees and goes to 75: its left front corner is ahead, a bit to the right."""
    c, s = direction(75)
    x, y = 0.13 + 0.05, side * 0.035
    post = f"model( size [ 0.1 0.02 1 ] pose [ {c * x - s * y:.9f} {s * x + c * y:.9f} 0 75 ] )\n"
    corner = (0.1 + 0.05) / 2**0.5

    found = mover(BLIND + post).contact(Spot(0, 0, 30), 75, STEP)

    assert found.metres == pytest.approx(0.13 - corner - SKIN) if is_met else found.metres > STEP


def test_obstacles_before_a_sensor_are_solid_or_seen_and_give_no_way() -> None:
    at = "model( size [ 0.05 0.05 1 ] pose [ {} 0.2 0 0 ] {} )\n"
    kinds = ("", "ranger_return -1", "obstacle_return 0", "obstacle_return 0 ranger_return -1", PUSHABLE)
    text = BLIND + "".join(at.format(0.1 * i, kind) for i, kind in enumerate(kinds))

    it = mover(text)

    assert [part.root for part in it.barring(HERE, 0.5)] == [2, 3, 4]
    assert [part.root for part in it.touchable(Spot(0.2, 0.1, 0))] == [3]
    assert [part.root for part in it.touchable(Spot(0.3, 0.1, 0))] == [6]
    for kind in kinds:
        hidden = kind == kinds[3]
        assert mover(BLIND + at.format(0.1, kind)).is_far(HERE, 0.1) is hidden


def test_what_may_move_can_come_into_a_robot_that_was_free() -> None:
    it = mover(BLIND + box(1, 1, 1.1, 1.1, PUSHABLE) + wall(3))
    assert it.has_free_turn(HERE, 1)
    assert it.has_free_step(HERE, Bearing.FRONT)

    it.around.ground.put(2, Placement(0.1, 0))

    assert not it.has_free_turn(HERE, 1)
    assert not it.has_free_step(HERE, Bearing.FRONT)


@pytest.mark.parametrize(
    ("thing", "with_a_gripper", "without"),
    [("", True, True), (PUSHABLE, False, False), ("gripper_return 1", False, True)],
)
def test_a_robot_walks_up_to_what_it_can_push_or_grip(
    thing: str, with_a_gripper: bool, without: bool
) -> None:
    gripper = "gripper( pose [ 0.1 0 0 0 ] size [ 0.02 0.02 0.1 ] )"
    for more, is_blocked in ((gripper, with_a_gripper), ("", without)):
        it = mover(f"{WATCHFUL.rstrip().removesuffix(')')} {more} )\n{box(0.15, -0.1, 0.2, 0.1, thing)}")
        assert it.is_blocked(HERE, Bearing.FRONT) is is_blocked
