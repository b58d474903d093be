"""Speeds, ramps and odometry of a robot, worked out by hand. One step is 0.05 m."""

from collections.abc import Sequence
from math import degrees, hypot, inf, radians, sqrt
from random import Random

import pytest

from devices.ports.robot import Grip, Motion, RobotProblem
from sim.clock import Glide, Landing
from sim.geometry import Placement, Spot
from sim.handling import Advance
from sim.scene import Drive, Limits, Localization, OdometryError, Wheels
from sim.vehicle import Odometry, Rate, Rates, Whereabouts, moving, odometry_of, rates_of, turning, walk_stops
from sim.world import World
from tests.unit.sim.floors import Diary, Unpaced, scene

# --- one speed


def test_at_one_speed_ways_and_times_are_proportional() -> None:
    course = Rate(0.5).over(9)

    assert course.seconds(3.0, 2.0) == 4.0
    assert course.further(3.0, 2.0) == 1.0
    assert course.times(5.0, [0.0, 1.0, 2.0]) == [5.0, 7.0, 9.0]
    assert course is Rate(0.5).over(3)


@pytest.mark.parametrize(
    ("rate", "ticks"), [(1.0, 20), (0.5, 40), (0.75, 27), (19.0, 2), (20.0, 1), (20.1, 1), (500.0, 1)]
)
def test_a_step_is_divided_into_ticks_of_a_twentieth_of_a_second_at_most(rate: float, ticks: int) -> None:
    course = Rate(rate).over(9)

    assert walk_stops(course, 0, 1) == pytest.approx([(i + 1) / ticks for i in range(ticks)])
    assert len(walk_stops(course, 0, 2)) == 2 * ticks
    assert walk_stops(course, 2, 2) == ()
    assert walk_stops(course, 1, 2)[-1] == 2.0
    assert walk_stops(course, 0, 1) is walk_stops(course, 0, 1)


def test_a_tick_that_began_late_ends_with_the_others() -> None:
    course = Rate(1.0).over(9)

    assert [course.next_stop(done) for done in (0.0, 0.05, 0.06, 0.999, 1.0)] == pytest.approx(
        [0.05, 0.1, 0.1, 1.0, 1.05]
    )
    assert course.next_stop(0.3 - 1e-9) == 0.35  # a rounding error
    assert walk_stops(course, 0.93, 1.02) == pytest.approx((0.95, 1.0, 1.02))


# --- ramps

SLOW = Rate(1.0, 0.5, 0.25)
"""At its top speed after 2 s and 1 step; it stands 4 s and 2 steps after that."""


@pytest.mark.parametrize(
    ("way", "seconds"),
    [(0.0, 0.0), (0.25, 1.0), (1.0, 2.0), (4.0, 5.0), (8.0, 9.0), (9.5, 11.0), (10.0, 13.0)],
)
def test_a_ramp_rises_stays_level_and_falls(way: float, seconds: float) -> None:
    course = SLOW.over(10)

    assert course.seconds(0.0, way) == pytest.approx(seconds)
    assert course.further(0.0, seconds) == pytest.approx(way)
    for other_way, at in ((0.25, 1.0), (8.0, 9.0)):
        assert course.seconds(other_way, way - other_way) == pytest.approx(seconds - at)
        assert course.further(other_way, seconds - at) == pytest.approx(way - other_way)
    assert course.times(7.0, [way, way]) == pytest.approx([7 + seconds] * 2)


def test_a_ramp_ends_where_it_was_asked_to() -> None:
    course = SLOW.over(10)

    assert (course.further(0.0, 99.0), course.further(9.0, 99.0)) == (10.0, 1.0)
    assert course.seconds(0.0, 10.5) == 13.0


@pytest.mark.parametrize("asked", [0.25, 1.0, 3.0])
def test_a_short_ramp_has_no_level_part(asked: float) -> None:
    """Twice as much time to slow down as to get faster, and twice the way: the top is below 1."""
    course, seconds = SLOW.over(asked), sqrt(2 * asked * (1 / 0.5 + 1 / 0.25))

    assert course.seconds(0.0, asked) == pytest.approx(seconds)
    assert course.seconds(0.0, asked / 3) == pytest.approx(seconds / 3)
    assert course.further(0.0, seconds / 3) == pytest.approx(asked / 3)
    assert course.further(0.0, seconds * 2 / 3) == pytest.approx(asked - 0.25 * (seconds / 3) ** 2 / 2)
    assert course.seconds(0.0, asked - 0.25 * (seconds / 3) ** 2 / 2) == pytest.approx(seconds * 2 / 3)


@pytest.mark.parametrize(
    ("rate", "seconds"),
    [(Rate(1.0, 0.5, inf), 2 + 9), (Rate(1.0, inf, 0.25), 8 + 4), (Rate(2.0, 2.0, 2.0), 6)],
)
def test_one_side_of_a_ramp_may_be_missing(rate: Rate, seconds: float) -> None:
    assert rate.over(10).seconds(0.0, 10.0) == pytest.approx(seconds)
    assert rate.over(10).further(0.0, seconds) == pytest.approx(10)
    assert rate.over(10) is not rate.over(10)


def test_a_ramp_has_its_own_top_speed() -> None:
    """2 steps a second after 1 s and 1 step."""
    course = Rate(2.0, 2.0, 2.0).over(10)

    assert [course.seconds(0.0, way) for way in (1.0, 5.0, 9.0)] == pytest.approx([1, 3, 5])
    assert [course.further(0.0, seconds) for seconds in (1.0, 3.0, 5.0)] == pytest.approx([1, 5, 9])


def test_a_ramp_of_nothing_takes_no_time() -> None:
    course = SLOW.over(0)

    assert (course.seconds(0.0, 0.0), course.further(0.0, 3.0)) == (0.0, 0.0)
    assert walk_stops(course, 0.0, 0.0) == ()


@pytest.mark.parametrize(
    ("rate", "done", "stop"),
    [
        (SLOW, 0.0, 0.5 * 0.05**2 / 2),
        (SLOW, 1.0, 1.05),
        (SLOW, 4.99, 5.0),
        (SLOW, 5.0 - 1e-7, 5.05),
        (Rate(1.0, 1000.0, 1000.0), 0.949995, 1.0),  # no tick is shorter than 1e-5 steps
        (Rate(1.0, 1000.0, 1000.0), 0.94998, 0.99998),
        (Rate(1.0, 0.001, 0.001), 0.0, 1e-5),
    ],
)
def test_a_tick_of_a_ramp_ends_at_a_whole_step(rate: Rate, done: float, stop: float) -> None:
    course = rate.over(10)

    assert course.next_stop(done) == pytest.approx(stop, abs=2e-7)
    assert walk_stops(course, done, 9.0)[0] == course.next_stop(done)


def test_the_ticks_of_a_ramp_are_a_twentieth_of_a_second_apart() -> None:
    course = SLOW.over(10)
    stops = walk_stops(course, 0.0, 1.0)

    assert len(stops) == 40
    assert course.times(0.0, stops) == pytest.approx([(i + 1) / 20 for i in range(40)])
    assert stops[-1] == 1.0


# --- the rates of wheels


def limits(x: tuple[float, float], yaw: tuple[float, float]) -> Limits:
    return Limits(x, (0.0, 0.0), yaw)


@pytest.mark.parametrize(
    ("wheels", "rates"),
    [
        (None, ((1, inf, inf), (1, inf, inf), (45, inf, inf), (45, inf, inf), None)),
        (Wheels(), ((1, inf, inf), (1, inf, inf), (45, inf, inf), (45, inf, inf), None)),
        (
            Wheels(velocity_bounds=limits((-0.01, 0.025), (-15, 30))),
            ((0.5, inf, inf), (0.2, inf, inf), (15, inf, inf), (30, inf, inf), None),
        ),
        (
            Wheels(acceleration_bounds=limits((-0.0125, 0.1), (-9, 18))),
            ((1, 2, 0.25), (1, 0.25, 2), (45, 9, 18), (45, 18, 9), None),
        ),
        (
            Wheels(velocity_bounds=limits((-0.01, 0), (0, 30)), drive=Drive.OMNI),
            ((0, inf, inf), (0.2, inf, inf), (0, inf, inf), (30, inf, inf), None),
        ),
        (
            Wheels(acceleration_bounds=limits((-1, 0), (0, 9))),
            ((0, inf, inf), (0, inf, inf), (0, inf, inf), (0, inf, inf), None),
        ),
        (
            Wheels(drive=Drive.CAR, wheelbase=0.5),
            ((1, inf, inf), (1, inf, inf), (degrees(0.1), inf, inf), (degrees(0.1), inf, inf), 0.5),
        ),
        (
            Wheels(drive=Drive.CAR, wheelbase=0.01),  # no circle is smaller than a step
            ((1, inf, inf), (1, inf, inf), (45, inf, inf), (45, inf, inf), 0.05),
        ),
        (
            Wheels(
                drive=Drive.CAR,
                wheelbase=0.5,
                velocity_bounds=limits((-1, 1), (-3, 90)),
                acceleration_bounds=limits((-0.05, 0.1), (-4, 900)),
            ),
            (
                *((1, 2, 1), (1, 1, 2), (3, 4, degrees(0.1))),
                (degrees(0.1), 2 * degrees(0.1), 4),
                0.5,
            ),
        ),
    ],
)
def test_wheels_have_a_rate_to_each_side(wheels: Wheels | None, rates: Sequence[object]) -> None:
    """Velocities that are limited more than the usual ones, and what limits getting faster and slower."""
    found = rates_of(wheels)

    sides = (found.forward, found.backward, found.right, found.left)
    assert [(each.top, each.up, each.down) for each in sides] == [pytest.approx(each) for each in rates[:4]]
    assert found.bend == rates[4]
    assert (found == Rates()) is (wheels in (None, Wheels()))


def test_a_rate_of_nothing_is_refused() -> None:
    assert (moving(SLOW), turning(SLOW)) == (SLOW, SLOW)
    for command, code in ((moving, "cannot-drive"), (turning, "cannot-turn")):
        with pytest.raises(RobotProblem) as problem:
            command(Rate(0.0))
        assert problem.value.code == code


# --- odometry


def test_odometry_errs_by_a_part_of_what_is_driven_and_turned() -> None:
    believed = Odometry(along=0.1, turn=-0.2)
    left = believed.ahead(Spot(1, 2, 90), 2.0, 90.0)

    assert believed.ahead(Spot(1, 2, 90), 2.0, 0.0) == Spot(1, pytest.approx(4.2), 90)  # type: ignore[arg-type]
    assert believed.ahead(Spot(1, 2, 90), 2.0, 180.0) == Spot(1, pytest.approx(-0.2), 90)  # type: ignore[arg-type]
    assert believed.turned(Spot(1, 2, 90), 50.0) == Spot(1, 2, 130)
    assert believed.turned(Spot(1, 2, 350), 50.0) == Spot(1, 2, 30)
    assert believed.turned(Spot(1, 2, 30), -50.0) == Spot(1, 2, 350)
    assert (left.x, left.y, left.yaw) == (pytest.approx(-1.2), 2, 90)
    exact = [Odometry().is_exact, Odometry(along=0.1).is_exact, Odometry(turn=0.1).is_exact]
    assert exact == [True, False, False]


class Drawing(Random):
    """Draws 0.9, and then 0.25."""

    def __init__(self) -> None:
        super().__init__()
        self._left = [0.25, 0.9]

    def random(self) -> float:
        return self._left.pop()


def test_errors_are_drawn_between_half_of_what_the_world_says_to_both_sides() -> None:
    odom = Wheels(localization=Localization.ODOM, odom_error=OdometryError(0.1, 9.0, 0.2))

    drawn = odometry_of(odom, Drawing())

    assert (drawn.along, drawn.turn) == (pytest.approx(0.04), pytest.approx(-0.05))
    for wheels, chance in ((odom, None), (None, Drawing()), (Wheels(), Drawing())):
        assert odometry_of(wheels, chance) == Odometry()


# --- in its world


@pytest.mark.parametrize(
    ("bounds", "fastest"),
    [
        ("", 0.05 + radians(45) * hypot(0.1, 0.05)),
        ("velocity_bounds [ -0.01 0.03 0 0 0 0 -15 30 ]", 0.03 + radians(30) * hypot(0.1, 0.05)),
        ("velocity_bounds [ -0.03 0.01 0 0 0 0 -30 15 ]", 0.03 + radians(30) * hypot(0.1, 0.05)),
    ],
)
def test_no_point_of_a_robot_is_faster_than_it_drives_and_its_corners_turn(
    bounds: str, fastest: float
) -> None:
    world = World(scene(f"position( size [ 0.2 0.1 0.1 ] {bounds} )"))
    world.robot(pace=Unpaced()).get_ready()

    assert world.ground.fastest == pytest.approx(fastest)


@pytest.mark.parametrize(("x", "is_alone"), [(0.335, True), (0.33, False), (-0.335, True), (-0.33, False)])
def test_a_robot_is_alone_if_nothing_that_may_move_can_stop_it(x: float, is_alone: bool) -> None:
    """Its body reaches 0.1118 m, and it looks 3 steps farther; the thing 0.0707 m, or a bit more."""
    box = f"model( size [ 0.1 0.1 1 ] pose [ {x} 0 0 0 ] %s )"
    text = "position( size [ 0.2 0.1 0.1 ] )\n"
    movable, still = (World(scene(text + box % more)) for more in ("pushable 1", ""))
    x = abs(x)
    reach = hypot(0.1, 0.05) + 0.15 + hypot(0.05, 0.05)
    assert (x > reach) is is_alone

    assert movable.robot(pace=Unpaced()).get_ready().is_alone() is is_alone
    assert still.robot(pace=Unpaced()).get_ready().is_alone()


BOX = "model( size [ 0.1 0.1 1 ] pose [ 5 5 0 0 ] pushable 1 )\n"
COMPANY = f'position( name "it" size [ 0.2 0.1 0.1 ] pose [ 0 0 0.5 0 ] )\n{BOX}'
BOX_ROOT = 1


@pytest.mark.parametrize(("x", "is_clear"), [(0.58, True), (0.56, False), (-0.58, True), (-0.56, False)])
def test_nothing_is_in_the_way_of_the_next_tick_that_is_much_farther_than_a_step(
    x: float, is_clear: bool
) -> None:
    """0.1718 m for a step, 0.3 m and a step more; the box reaches 0.05 m to each side."""
    robot = World(scene(COMPANY)).robot(pace=Unpaced(), speed=1.0)
    vehicle = robot.get_ready()
    vehicle.mover.around.ground.put(BOX_ROOT, Placement(x, 0))
    assert not vehicle.is_clear(), "it takes no part, so that no other acts meanwhile"

    robot.join()
    assert vehicle.is_clear() is is_clear
    robot.speed = None
    vehicle.quicken()
    assert not vehicle.is_clear(), "it glides"


def test_a_clear_way_stays_clear_as_long_as_nothing_can_have_come() -> None:
    """Both may be as fast as a corner that turns: 0.3 m take 1.0885 s."""
    robot = World(scene(COMPANY)).robot(pace=Unpaced(), speed=1.0)
    vehicle, ground = robot.get_ready(), robot.get_ready().mover.around.ground
    robot.join()
    assert vehicle.is_clear()
    ground.put(BOX_ROOT, Placement(0.3, 0))

    for seconds, is_clear in ((0.5, True), (1.038, True), (1.039, False), (0.5, False)):
        vehicle.clock.seconds = seconds
        assert vehicle.is_clear() is is_clear
    ground.put(BOX_ROOT, Placement(3, 0))
    assert vehicle.is_clear()
    ground.put(BOX_ROOT, Placement(0.3, 0))
    assert vehicle.is_clear()
    ground.jump()
    assert not vehicle.is_clear()


def test_a_robot_that_moves_out_of_turn_jumps() -> None:
    robot = World(scene(COMPANY)).robot(pace=Unpaced())
    vehicle, ground = robot.get_ready(), robot.get_ready().mover.around.ground
    jumps, spot = ground.jumps, Spot(1, 2, 3)

    vehicle.go_to(Whereabouts(spot, spot))
    assert (ground.jumps, ground.place(0), vehicle.here.truth) == (jumps + 1, Placement(1, 2, 0.5, 3), spot)
    robot.join()
    vehicle.go_to(Whereabouts(Spot(2, 2, 3), spot))
    assert (ground.jumps, ground.place(0).x) == (jumps + 1, 2)
    vehicle.pass_by(Whereabouts(spot, spot))
    assert (ground.place(0).x, vehicle.here.truth.x) == (2, 1)


def test_a_robot_without_company_moves_for_itself_alone() -> None:
    vehicle = World(scene("position( size [ 0.2 0.1 0.1 ] )")).robot(pace=Unpaced()).get_ready()
    ground, spot = vehicle.mover.around.ground, Spot(1, 2, 3)

    vehicle.go_to(Whereabouts(spot, spot))

    assert (vehicle.here.truth, ground.place(0), ground.moved()) == (spot, Placement(), {})


@pytest.mark.parametrize(("x", "leaps"), [(9.0, True), (0.45, False)])
@pytest.mark.parametrize(("turned", "sign"), [(0.0, 1), (180.0, -1)])
def test_a_robot_with_room_goes_at_once(x: float, leaps: bool, turned: float, sign: int) -> None:
    """4 steps, with a ramp: half a step up, half a step down, each in 2 s at half the speed."""
    wall = f"model( size [ 0.2 4 1 ] pose [ {sign * x} 0 0 0 ] )"
    vehicle = World(scene(f"position( size [ 0.2 0.1 0.1 ] ) {wall}")).robot(pace=Unpaced()).get_ready()

    assert vehicle.leap(4, Rate(0.5, 0.25, 0.25), turned) is leaps

    assert vehicle.here.truth == (Spot(pytest.approx(sign * 0.2), 0, 0) if leaps else Spot(0, 0, 0))  # type: ignore[arg-type]
    assert vehicle.here.belief == vehicle.here.truth
    assert vehicle.clock.seconds == pytest.approx(2 + 3 / 0.5 + 2 if leaps else 0)


@pytest.mark.parametrize(
    ("is_watched", "speed", "seed", "leaps"),
    [(False, None, 0, True), (True, None, 0, False), (False, 1.0, 0, False), (False, None, 1, False)],
)
def test_a_robot_leaps_if_nothing_watches_or_waits(
    is_watched: bool, speed: float | None, seed: int, leaps: bool
) -> None:
    text = 'position( size [ 0.2 0.1 0.1 ] localization "odom" )'
    watcher = Diary() if is_watched else None
    robot = World(scene(text), seed=seed).robot(pace=Unpaced(), speed=speed, watcher=watcher)

    assert robot.get_ready().leap(4, Rate(1.0), 0.0) is leaps


def test_a_robot_that_begins_anew_leaves_what_it_held() -> None:
    gripper = "gripper( pose [ 0.15 0 0 0 ] size [ 0.1 0.1 0.1 ] )"
    ball = "model( size [ 0.05 0.05 0.05 ] pose [ 0.2 0 0 0 ] gripper_return 1 )"
    vehicle = (
        World(scene(f"position( size [ 0.2 0.2 0.1 ] {gripper} ) {ball}")).robot(pace=Unpaced()).get_ready()
    )
    vehicle.grip()
    there = vehicle.ahead(vehicle.here, 1.0, 90.0)
    vehicle.go_to(there)
    assert there.truth == Spot(pytest.approx(0), pytest.approx(1), 0)  # type: ignore[arg-type]

    vehicle.begin_anew(None)

    assert (vehicle.here.truth, vehicle.hand.held) == (Spot(0, 0, 0), None)
    ((_, place),) = vehicle.mover.around.ground.moved().items()
    assert (place.x, place.y) == pytest.approx((0.2, 1.0))


def test_errors_of_odometry_change_the_belief_only() -> None:
    text = 'position( size [ 0.2 0.1 0.1 ] localization "odom" )'
    vehicle = World(scene(text)).robot(pace=Unpaced()).get_ready()
    vehicle.odometry = Odometry(0.1, -0.2)
    here = Whereabouts(Spot(1, 2, 90), Spot(3, 4, 0))

    ahead, turned = vehicle.ahead(here, 2.0, 0.0), vehicle.turned(here, 300.0)

    assert (ahead.truth, ahead.belief) == (Spot(1, 4, 90), Spot(pytest.approx(5.2), 4, 0))  # type: ignore[arg-type]
    assert (turned.truth, turned.belief) == (Spot(1, 2, 30), Spot(3, 4, 240))


GRIPPER = "gripper( pose [ 0.15 0 0 0 ] size [ 0.1 0.1 0.1 ] )"
BALL = "model( size [ 0.05 0.05 0.05 ] pose [ 0.2 0 0 0 ] gripper_return 1 )"


def test_a_robot_glides_in_company_at_unlimited_speed_with_empty_hands() -> None:
    robot = World(scene(f"position( size [ 0.2 0.2 0.1 ] {GRIPPER} ) {BALL}")).robot(pace=Unpaced())
    vehicle = robot.get_ready()
    assert not vehicle.glides
    robot.join()
    assert vehicle.glides
    robot.speed = 1.0
    assert not vehicle.glides
    robot.speed = None
    vehicle.grip()
    assert not vehicle.glides
    vehicle.release()
    assert vehicle.glides


@pytest.mark.parametrize(
    ("speed", "stop_after", "landing", "count", "x", "seconds"),
    [(None, inf, Landing.WHOLE, 0, 0.3, 3.0), (20.0, 0.1, Landing.HALTED, 2, 0.0, 2.0)],
)
def test_a_glide_leads_to_its_end_or_to_a_stop(
    speed: float | None, stop_after: float, landing: Landing, count: int, x: float, seconds: float
) -> None:
    """Three ticks of a second; at 20 times the speed a slice is one."""
    robot = World(scene(COMPANY)).robot(pace=Unpaced(stop_after), speed=speed)
    robot.join()
    vehicle, ground = robot.get_ready(), robot.get_ready().mover.around.ground
    places = [Whereabouts(Spot(each, 0, 0), Spot(each, 0, 0)) for each in (0.0, 0.1, 0.2, 0.3)]

    found = vehicle.glide(places[3], 3.0, lambda: [1.0, 2.0, 3.0], lambda ticks: places[ticks], 0.2)

    assert found == (landing, count)
    assert (vehicle.here.truth.x, ground.place(0)) == (x, Placement(x, 0, 0.5, 0))
    assert vehicle.clock.seconds == seconds
    assert ground.roots_within(BOX_ROOT, x, 0, 0.01) == [0]


def test_a_glide_does_not_begin_where_another_one_is_near() -> None:
    other = 'position( name "bob" size [ 0.2 0.1 0.1 ] pose [ 0 1 0 0 ] )\n'
    world = World(scene(COMPANY + other))
    robot, bob = (world.robot(name, pace=Unpaced()) for name in ("it", "bob"))
    robot.join()
    vehicle, there = robot.get_ready(), Whereabouts(Spot(0.3, 0, 0), Spot(0.3, 0, 0))
    near = Glide(2, bob.get_ready().clock, lambda: [9.0], lambda _: Placement(), (0, 0.2, 1, 0.2), 0.2)
    assert world.ground.begin_glide(near)

    assert vehicle.glide(there, 3.0, lambda: [3.0], lambda _: there, 0.2) is None

    assert (vehicle.here.truth, vehicle.clock.seconds) == (Spot(0, 0, 0), 0.0)


def test_a_held_thing_makes_a_turning_robot_faster_at_its_end() -> None:
    text = f"position( size [ 0.2 0.2 0.1 ] {GRIPPER} ) {BALL}"
    world = World(scene(text))
    vehicle = world.robot(pace=Unpaced()).get_ready()
    alone = 0.05 + radians(45) * hypot(0.2, 0.05)
    assert world.ground.fastest == pytest.approx(alone)

    assert vehicle.grip() is Grip.GRIPPED

    assert world.ground.fastest == pytest.approx(0.05 + radians(45) * hypot(0.225, 0.025))
    assert vehicle.release() is Grip.RELEASED


def test_what_is_pushed_adds_up() -> None:
    vehicle = World(scene(COMPANY)).robot(pace=Unpaced()).get_ready()

    for metres in (0.02, 0.03):
        vehicle.take_along(Advance(0.05, ((BOX_ROOT, metres),)), 90)

    assert vehicle.pushed == {BOX_ROOT: pytest.approx(0.05)}
    place = vehicle.mover.around.ground.place(BOX_ROOT)
    assert (place.x, place.y) == pytest.approx((5, 5.05))


@pytest.mark.parametrize(("speed", "shown"), [(2.0, [0.0, 0.091, 0.2]), (1.0, [0.0, 0.08, 0.2]), (None, [])])
def test_a_moving_picture_has_twenty_poses_a_second(speed: float | None, shown: list[float]) -> None:
    """Nine tenths of a slice after the last one, at least: at twice the speed 0.09 s."""
    diary = Diary()
    vehicle = World(scene(COMPANY)).robot(pace=Unpaced(), watcher=diary, speed=speed).get_ready()

    for seconds in (0.0, 0.04, 0.08, 0.091, 0.1, 0.2, 0.21):
        vehicle.clock.seconds = seconds
        vehicle.here = Whereabouts(Spot(seconds, 0, 0), Spot(9, 9, 0))
        vehicle.show()

    assert [pose.x * 0.05 for pose in diary.passed] == pytest.approx(shown)
    vehicle.report(Motion.FORWARD)
    assert [(motion, pose.x) for motion, pose, _ in diary.progress] == [(Motion.FORWARD, pytest.approx(180))]
