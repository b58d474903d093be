"""Sonars and lasers against closed forms; heights; noise; which sensor serves which bearing."""

from math import cos, hypot, inf, radians, sin
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from devices.ports.robot import Bearing, RobotProblem
from sim.geometry import Spot
from sim.rangers import Cone, Fan, fan_angles
from tests.effort import examples
from tests.unit.sim.sensing import Sensing

BODY = "size [ 0.2 0.2 0.2 ]"
ROOM = (
    "model( size [ 6 0.1 1 ] pose [ 0 2.05 0 0 ] ) model( size [ 6 0.1 1 ] pose [ 0 -1.05 0 0 ] )"
    "model( size [ 0.1 6 1 ] pose [ 3.05 0 0 0 ] ) model( size [ 0.1 6 1 ] pose [ -2.05 0 0 0 ] )"
)
"""Walls whose faces are at 3 to the east, 2 to the north, 2 to the west, 1 to the south."""


def laser(samples: int, fov: float, place: str = "0 0 0 0", robot: str = "0 0 0 0", more: str = "") -> str:
    sensor = f"sensor( range [ 0 8 ] fov {fov} samples {samples} pose [ {place} ] {more} )"
    return f"position( {BODY} pose [ {robot} ] ranger( {sensor} ) )"


def fan(it: Sensing) -> Fan:
    (found,) = it.senses.rangers
    assert isinstance(found, Fan)
    return found


def to_the_walls(x: float, y: float, angle: float) -> float:
    """Metres to the wall of the room from (x, y) in a direction."""
    dx, dy = cos(radians(angle)), sin(radians(angle))
    across = (3 - x) / dx if dx > 1e-12 else (-2 - x) / dx if dx < -1e-12 else inf
    along = (2 - y) / dy if dy > 1e-12 else (-1 - y) / dy if dy < -1e-12 else inf
    return min(across, along)


@settings(max_examples=examples(60))
@given(
    st.floats(-1.8, 2.8),
    st.floats(-0.8, 1.8),
    st.floats(-180, 180),
    st.integers(2, 200),
    st.floats(1, 360),
)
def test_every_ray_of_a_laser_measures_the_distance_to_the_wall(
    x: float, y: float, yaw: float, samples: int, fov: float
) -> None:
    it = Sensing(laser(samples, fov, robot=f"{x:.6f} {y:.6f} 0 {yaw:.6f}") + ROOM)

    rays = fan(it).rays(it.around, it.spot)

    apart = fov / (samples - 1)
    for i, ray in enumerate(rays):
        assert ray == pytest.approx(to_the_walls(x, y, yaw - fov / 2 + i * apart), abs=1e-4)


def test_the_rays_of_a_laser_go_from_its_right_border_to_its_left_one() -> None:
    assert fan(Sensing(laser(5, 180))).angles == (-90, -45, 0, 45, 90)


def test_a_laser_that_is_mounted_off_the_middle_measures_from_there() -> None:
    it = Sensing(laser(3, 180, place="0.5 0.25 0 90", robot="0 0 0 0") + ROOM)

    assert fan(it).rays(it.around, it.spot) == pytest.approx((2.5, 1.75, 2.5))


def test_a_ray_does_not_see_a_thing_beyond_its_range() -> None:
    it = Sensing(laser(3, 180).replace("[ 0 8 ]", "[ 0 2.5 ]") + ROOM)

    assert fan(it).rays(it.around, it.spot) == pytest.approx((1, inf, 2))
    assert it.senses.steps(it.around, it.spot, Bearing.FRONT) == 50


def test_a_laser_inside_a_thing_reads_nothing_but_zero() -> None:
    it = Sensing(laser(7, 90, robot="-2 0 0 0") + "model( size [ 1 1 1 ] pose [ 0.3 0 0 0 ] )")
    spot = Spot(0.3, 0.2, 0)

    assert set(fan(it).rays(it.around, spot)) == {0.0}


def test_the_distance_of_a_bearing_comes_from_the_nearest_ray_of_the_laser() -> None:
    """A pole 20 degrees to the left is ahead; one 30 degrees to the left is not."""
    for degrees, ahead, left in ((20, 1, 2), (30, 3, 1)):
        x, y = cos(radians(degrees)), sin(radians(degrees))
        pole = f"model( size [ 0.05 0.05 1 ] pose [ {x} {y} 0 0 ] )"
        it = Sensing(laser(181, 180) + ROOM + pole)

        def steps(bearing: Bearing, it: Sensing = it) -> int:
            return it.senses.steps(it.around, it.spot, bearing)

        assert steps(Bearing.FRONT) // 20 == pytest.approx(ahead, abs=1)
        assert (steps(Bearing.FRONT) < 21) == (ahead == 1)
        assert (steps(Bearing.FRONT_LEFT) < 21) == (left == 1)
        for behind in (Bearing.BACK, Bearing.BACK_LEFT, Bearing.BACK_RIGHT):
            with pytest.raises(RobotProblem):
                steps(behind)


def test_a_laser_with_a_full_circle_serves_every_bearing() -> None:
    it = Sensing(laser(361, 360) + ROOM)

    steps = {bearing: it.senses.steps(it.around, it.spot, bearing) for bearing in Bearing}

    assert steps[Bearing.FRONT] == int(1 / sin(radians(22)) * 100 + 0.5) // 5  # the wall to the right
    assert steps[Bearing.BACK] == 40
    assert steps[Bearing.BACK_LEFT] == int(2 / cos(radians(23)) * 100 + 0.5) // 5


SONARS = "".join(
    f"sensor( range [ 0 5 ] fov 15 pose [ 0 0 0 {yaw} ] )"
    for yaw in (90, 50, 30, 10, -10, -30, -50, -90, -130, -150, -170, 170, 150, 130)
)


def test_a_bearing_is_served_by_those_of_many_sonars_that_look_there() -> None:
    senses = Sensing(f"position( {BODY} ranger( {SONARS} ) )").senses

    def yaws(bearing: Bearing) -> list[float]:
        return [each.yaw for each in senses.at(bearing) if isinstance(each, Cone)]

    assert yaws(Bearing.FRONT) == [10, -10]
    assert yaws(Bearing.FRONT_LEFT) == [50, 30]
    assert yaws(Bearing.BACK_RIGHT) == [-130, -150]
    assert yaws(Bearing.BACK) == [-170, 170]


@pytest.mark.parametrize(("fov", "expected"), [(90, None), (200, 1.0), (360, 0.5)])
def test_a_cone_may_be_wider_than_a_half_circle(fov: float, expected: float | None) -> None:
    """A pole straight to the left, one metre away, and one behind, half a metre away."""
    poles = "model( size [ 0.02 0.02 1 ] pose [ 0 1 0 0 ] ) model( size [ 0.02 0.02 1 ] pose [ -0.5 0 0 0 ] )"
    it = Sensing(f"position( {BODY} ranger( sensor( range [ 0 3 ] fov {fov} ) ) )" + poles)
    (cone,) = it.senses.rangers

    reading = cone.centimetres(it.around, it.spot)

    assert reading == (None if expected is None else pytest.approx(expected * 100, abs=1.1))


@pytest.mark.parametrize("fov", [60, 100, 360])
@pytest.mark.parametrize(("away", "expected"), [(0.7, 99), (0.72, None)])
def test_a_cone_reaches_as_far_to_its_corners(fov: float, away: float, expected: int | None) -> None:
    """Things to all four corners, 0.7 and 0.72 times the root of 2 metres away; the range is a metre."""
    poles = " ".join(
        f"model( size [ 0.002 0.002 1 ] pose [ {x * away} {y * away} 0 0 ] )"
        for x in (1, -1)
        for y in (1, -1)
    )
    it = Sensing(f"position( {BODY} ranger( sensor( range [ 0 1 ] fov {fov} pose [ 0 0 0 45 ] ) ) )" + poles)

    assert it.senses.rangers[0].centimetres(it.around, it.spot) == (
        None if expected is None else pytest.approx(expected, abs=1)
    )


# --- heights

LOW = "model( size [ 0.2 2 0.5 ] pose [ 1.1 0 0 0 ] )"


def tall(world: str, sensor: str = "fov 15", ranger: str = "") -> Sensing:
    robot = f"position( size [ 0.4 0.4 1 ] {ranger} ranger( {ranger} sensor( range [ 0 3 ] {sensor} ) ) )"
    return Sensing(world + robot + LOW)


@pytest.mark.parametrize("sensor", ["fov 15", "fov 15 samples 7"])
def test_a_sensor_on_a_tall_robot_sees_a_low_wall_unless_heights_count(sensor: str) -> None:
    for world, ranger, expected in (
        ("", "", 100),
        ("ignore_zloc 1 ", "", 100),
        ("ignore_zloc 0 ", "", None),
        ("", "ignore_zloc 0", None),
        ("ignore_zloc 0 ", "ignore_zloc 1", 100),
    ):
        it = tall(world, sensor, ranger)
        (ranger_of,) = it.senses.rangers
        assert ranger_of.centimetres(it.around, it.spot) == expected


@pytest.mark.parametrize(("lowered", "seen"), [(-0.4, False), (-0.6, True), (-0.505, False), (-0.52, True)])
def test_a_sensor_looks_from_the_middle_of_its_height_where_heights_count(lowered: float, seen: bool) -> None:
    """Stage's rule: the top of the robot, the sensor's z, and half of the sensor's own height (2 cm)."""
    it = tall("ignore_zloc 0 ", f"pose [ 0 0 {lowered} 0 ]")
    (cone,) = it.senses.rangers

    assert cone.height == pytest.approx(1 + lowered + 0.01)
    assert (cone.metres(it.around, it.spot) < inf) is seen


boxes = st.lists(
    st.tuples(st.floats(-3, 3), st.floats(-3, 3), st.floats(0.05, 1), st.integers(0, 359)), max_size=6
).map(lambda all_: [box for box in all_ if hypot(box[0], box[1]) > 1.2])


@settings(max_examples=examples(60))
@given(boxes, st.integers(0, 359))
def test_heights_change_no_ray_where_everything_is_tall(
    things: list[tuple[float, float, float, int]], yaw: int
) -> None:
    models = "".join(f"model( size [ {s} 0.3 2 ] pose [ {x} {y} 0 {a} ] )" for x, y, s, a in things)
    robot = laser(37, 360, robot=f"0 0 0 {yaw}")
    free, strict = Sensing(robot + models), Sensing("ignore_zloc 0 " + robot + models)

    rays = fan(free).rays(free.around, free.spot)

    assert fan(strict).rays(strict.around, strict.spot) == pytest.approx(rays, abs=1e-6)


# --- noise

NOISY = "range_noise 0.1 range_noise_const 0.02 angle_noise 0"


def test_noise_needs_a_random_source_and_keeps_its_bounds() -> None:
    it = Sensing(f"position( {BODY} ranger( sensor( range [ 0 5 ] {NOISY} ) ) )" + ROOM)
    (cone,) = it.senses.rangers
    chance = Random(7)

    readings = [cone.noisy(it.around, it.spot, chance) for _ in range(300)]

    assert cone.centimetres(it.around, it.spot) == 300
    assert it.senses.steps(it.around, it.spot, Bearing.FRONT) == 60
    in_range = [reading for reading in readings if reading is not None]
    assert len(in_range) == 300
    assert 268 <= min(in_range) < 280
    assert 320 < max(in_range) <= 332
    assert abs(sum(in_range) / 300 - 300) < 3


@pytest.mark.parametrize("samples", [1, 9])
def test_the_same_seed_gives_the_same_noise(samples: int) -> None:
    it = Sensing(laser(samples, 20, more="range_noise 0.1 angle_noise 5") + ROOM)

    def readings(seed: int) -> list[int]:
        chance = Random(seed)
        return [it.senses.steps(it.around, it.spot, Bearing.FRONT, chance) for _ in range(20)]

    assert readings(1) == readings(1)
    assert readings(1) != readings(2)


def test_a_sensor_without_noise_is_exact_with_any_random_source() -> None:
    it = Sensing(laser(9, 20) + ROOM)

    assert it.senses.steps(it.around, it.spot, Bearing.FRONT, Random(1)) == 60


def test_noise_can_be_written_as_one_tuple() -> None:
    it = Sensing(laser(1, 20, more="noise [ 0.1 0.02 3 ]"))
    (sensor,) = (sensor for model in it.scene.models for sensor in model.sensors)

    assert (sensor.noise.proportional, sensor.noise.constant, sensor.noise.angle) == (0.1, 0.02, 3)


class Half(Random):
    """Draws the middle between 0 and the most, and counts."""

    def __init__(self) -> None:
        super().__init__(1)
        self.draws = 0

    def uniform(self, a: float, b: float) -> float:
        assert (a, b) == (-1, 1)
        self.draws += 1
        return 0.5


@pytest.mark.parametrize("samples", [1, 3])
@pytest.mark.parametrize(
    ("noise", "expected", "draws"),
    [
        ("", 3, 0),
        ("range_noise 0.1", 3 + 0.5 * 0.1 * 3, 2),
        ("range_noise_const 0.02", 3 + 0.5 * 0.02, 2),
        ("range_noise 0.1 range_noise_const 0.02", 3 + 0.5 * 0.02 + 0.5 * 0.1 * 3, 2),
        ("angle_noise 60", 3 / cos(radians(30)), 1),
    ],
)
def test_each_part_of_the_noise_is_drawn_once_for_a_reading(
    samples: int, noise: str, expected: float, draws: int
) -> None:
    """The wall is 3 m ahead; turned by 30 degrees a ray is longer. Each ray of a laser has its own draws."""
    it = Sensing(laser(samples, 0, more=noise) + ROOM)
    (sensor,) = it.senses.rangers
    chance = Half()

    assert sensor.samples(it.around, it.spot, chance) == pytest.approx((expected,) * samples, abs=1e-4)
    assert chance.draws == (draws if draws < 2 else draws * samples)
    assert sensor.noisy(it.around, it.spot, Half()) == int(expected * 100 + 0.5)
    assert sensor.samples(it.around, it.spot, None) == pytest.approx((3,) * samples)


@pytest.mark.parametrize(("most", "reading"), [(3.05, 3.03), (3.02, inf), (2.9, inf)])
def test_a_reading_that_its_noise_takes_out_of_the_range_is_none(most: float, reading: float) -> None:
    """3 m, and half of 6 cm."""
    sensor = laser(1, 0, more="range_noise_const 0.06").replace("[ 0 8 ]", f"[ 0 {most} ]")
    it = Sensing(sensor + ROOM)
    (cone,) = it.senses.rangers

    assert cone.samples(it.around, it.spot, Half()) == (pytest.approx(reading),)
    assert cone.noisy(it.around, it.spot, Half()) == (None if reading == inf else 303)


def test_a_reading_is_never_below_nothing_nor_below_the_minimum_of_its_sensor() -> None:
    class Low(Half):
        def uniform(self, a: float, b: float) -> float:
            return -1.0

    thing = "model( size [ 0.1 0.1 1 ] pose [ 0.25 0 0 0 ] )"
    free, least = (
        Sensing(laser(1, 0, more="range_noise_const 1").replace("[ 0 8 ]", f"[ {low} 8 ]") + thing)
        for low in (0, 0.1)
    )

    assert free.senses.rangers[0].samples(free.around, free.spot, Low()) == (0,)
    assert free.senses.rangers[0].noisy(free.around, free.spot, Low()) == 0
    assert least.senses.rangers[0].noisy(least.around, least.spot, Low()) == 10


@pytest.mark.parametrize("fov", [10, 100, 300])
@pytest.mark.parametrize(("turned", "seen"), [(0, False), (180, True)])
def test_a_cone_can_be_turned(fov: float, turned: float, seen: bool) -> None:
    it = Sensing(laser(1, fov) + "model( size [ 0.1 0.1 1 ] pose [ -1.05 0 0 0 ] )")
    (cone,) = it.senses.rangers
    assert isinstance(cone, Cone)

    assert cone.metres(it.around, it.spot, turned) == (pytest.approx(1) if seen else inf)
    assert [part is None for _, part in cone.hits(it.around, it.spot)] == [True]


@pytest.mark.parametrize(("fov", "samples"), [(10, 1), (200, 1), (360, 1), (10, 3)])
@pytest.mark.parametrize(
    ("thing", "expected"),
    [("", 1), ("ranger_return -1", inf), ("size [ 0.1 0.1 0.1 ]", inf), ("obstacle_return 0", 1)],
)
def test_no_sensor_sees_what_is_invisible_or_below_its_height(
    fov: float, samples: int, thing: str, expected: float
) -> None:
    """It looks from 0.21 m."""
    it = Sensing(
        f"ignore_zloc 0 {laser(samples, fov)} model( size [ 0.1 0.1 1 ] pose [ 1.05 0 0 0 ] {thing} )"
    )
    (sensor,) = it.senses.rangers

    assert sensor.metres(it.around, it.spot) == pytest.approx(expected)


@pytest.mark.parametrize(("thing", "reading"), [("", 0), ("ranger_return -1", 2), ("size [ 1 1 0.1 ]", 2)])
def test_a_laser_is_inside_only_of_what_it_can_see(thing: str, reading: float) -> None:
    around = (
        f"model( size [ 1 1 1 ] pose [ 0.1 0 0 0 ] {thing} ) model( size [ 0.1 3 1 ] pose [ 2.05 0 0 0 ] )"
    )
    it = Sensing(f"ignore_zloc 0 {laser(3, 0, robot='-5 0 0 0')} {around}")

    assert fan(it).rays(it.around, Spot(0, 0, 0)) == pytest.approx((reading,) * 3)


def test_the_rays_of_a_sector_are_those_near_its_direction() -> None:
    it = fan(Sensing(laser(5, 180, more="range_noise 0.1")))

    sector = it.towards(-45, 45)
    assert sector is not None
    assert (sector.angles, sector.maximum, sector.noise.proportional) == ((-90, -45, 0), 8, 0.1)
    assert it.towards(180, 89) is None
    assert it.towards(-170, 100) == replace(it, angles=(-90, 90))


@pytest.mark.parametrize(
    ("given", "angles"),
    [
        ((10, 60, 1), (-20,)),
        ((10, 60, 2), (-20, 40)),
        ((10, 60, 3), (-20, 10, 40)),
        ((0, 360, 2), (-180, 180)),
    ],
)
def test_the_rays_of_a_laser_are_spread_evenly_over_its_view(
    given: tuple[float, float, int], angles: tuple[float, ...]
) -> None:
    assert fan_angles(*given) == angles
