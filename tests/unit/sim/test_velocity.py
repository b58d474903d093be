"""Robots driven by velocities: where they come, what stops them, and what their devices read in metres."""

import re
from contextlib import redirect_stdout
from io import StringIO
from math import asin, atan2, cos, degrees, hypot, isclose, radians, sin, sqrt

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from devices.ports.drive import TICK, DriveState, MetricPose, Velocity
from sim.velocity import VelocityLoop
from sim.world import World
from tests.conftest import ROOT
from tests.effort import examples
from tests.unit.sim.floors import scene

BODY = "size [ 0.2 0.2 0.2 ]"
WALL = 'model( name "wall" size [ 0.2 4 1 ] pose [ 1.1 0 0 0 ] )\n'
"""Its near side is at x = 1."""


def loop_of(text: str, seed: int = 0) -> VelocityLoop:
    return VelocityLoop(World(scene(text), seed=seed))


def driven(text: str, *, seconds: float, **velocity: float) -> DriveState:
    loop = loop_of(text)
    drive(loop, "it", **velocity)
    run(loop, seconds)
    return loop.drives["it"].state()


def drive(loop: VelocityLoop, name: str, **velocity: float) -> None:
    loop.drives[name].subscribe()
    loop.drives[name].drive(Velocity(**velocity))


def run(loop: VelocityLoop, seconds: float) -> None:
    for _ in range(round(seconds / TICK)):
        loop.advance()


def robot(more: str = "", pose: str = "0 0 0 0", name: str = "it") -> str:
    return f'position( name "{name}" {BODY} pose [ {pose} ] {more} )\n'


def at(x: float, y: float, yaw: float) -> object:
    return pytest.approx((x, y, yaw), abs=1e-9)


def place(pose: MetricPose) -> tuple[float, float, float]:
    return pose.x, pose.y, pose.yaw


# --- the way


@pytest.mark.parametrize(
    ("velocity", "seconds", "expected"),
    [
        ({"ahead": 0.3}, 2.0, (0.6, 0.0, 0.0)),
        ({"ahead": -0.3}, 2.0, (-0.6, 0.0, 0.0)),
        ({"turn": 45.0}, 4.0, (0.0, 0.0, 180.0)),
        ({"turn": -45.0}, 2.0, (0.0, 0.0, 270.0)),
        ({"ahead": 0.5, "left": 0.5}, 1.0, (0.5, 0.0, 0.0)),
    ],
    ids=["forward", "backward", "left", "right", "not sideways"],
)
def test_a_robot_goes_straight_and_turns_on_the_spot(
    velocity: dict[str, float], seconds: float, expected: tuple[float, float, float]
) -> None:
    assert place(driven(robot(), seconds=seconds, **velocity).truth) == at(*expected)


def test_both_together_are_an_arc_of_a_circle() -> None:
    """At v m/s and w rad/s the radius is v / w, and the centre is to the left."""
    radius = 0.5 / radians(45)

    quarter = driven(robot(), seconds=2.0, ahead=0.5, turn=45.0)
    whole = driven(robot(), seconds=8.0, ahead=0.5, turn=45.0)
    right = driven(robot(), seconds=2.0, ahead=0.5, turn=-45.0)

    assert place(quarter.truth) == at(radius, radius, 90)
    assert place(whole.truth)[:2] == pytest.approx((0, 0), abs=1e-9)
    assert place(right.truth) == at(radius, -radius, 270)


def test_an_omnidirectional_robot_goes_sideways_too() -> None:
    state = driven(robot('drive "omni"', "0 0 0 90"), seconds=2.0, ahead=0.3, left=0.4)

    assert place(state.truth) == at(-0.8, 0.6, 90)


def test_a_car_turns_no_tighter_than_its_wheelbase_allows() -> None:
    """On a circle of 0.5 m at 0.25 m/s it turns half a radian a second."""
    state = driven(robot('drive "car" wheelbase 0.5'), seconds=2.0, ahead=0.25, turn=90.0)

    assert place(state.truth) == at(0.5 * sin(1), 0.5 * (1 - cos(1)), degrees(1))
    assert driven(robot('drive "car" wheelbase 0.5'), seconds=2.0, turn=90.0).truth == MetricPose()


def test_robots_of_one_loop_follow_their_own_velocities_for_ten_minutes() -> None:
    """A circle of 12 seconds, a way to the left, and a robot that stands."""
    text = (
        robot(name="round") + robot('drive "omni"', "0 9 0 90", "aside") + robot(pose="5 5 0 45", name="no")
    )
    loop = loop_of(text)
    drive(loop, "round", ahead=0.3, turn=30.0)
    drive(loop, "aside", left=0.01)
    drive(loop, "no")

    run(loop, 600.0)

    at_end = {name: place(each.state().truth) for name, each in loop.drives.items()}
    assert at_end["round"][:2] == pytest.approx((0.0, 0.0), abs=1e-6)
    assert at_end["aside"] == pytest.approx((-6.0, 9.0, 90.0), abs=1e-6)
    assert at_end["no"] == at(5, 5, 45)


def test_a_velocity_can_change_at_any_tick() -> None:
    loop = loop_of(robot())

    drive(loop, "it", ahead=0.5)
    run(loop, 1.0)
    drive(loop, "it", turn=-90.0)
    run(loop, 1.0)
    drive(loop, "it", ahead=0.2)
    run(loop, 0.5)

    assert place(loop.drives["it"].state().truth) == at(0.5, -0.1, 270)
    assert loop.time == pytest.approx(2.5)


@pytest.mark.parametrize("velocity", [{"ahead": float("nan")}, {"turn": float("inf")}])
def test_a_velocity_is_a_finite_number(velocity: dict[str, float]) -> None:
    with pytest.raises(ValueError, match="finite"):
        drive(loop_of(robot()), "it", **velocity)


# --- bounds


def test_without_bounds_in_the_world_those_of_stage_hold() -> None:
    """Stage: 1 m/s and 90 degrees a second."""
    assert driven(robot(), seconds=1.0, ahead=5.0).velocity == Velocity(1.0)
    assert place(driven(robot(), seconds=1.0, turn=-300.0).truth) == at(0, 0, 270)


def test_a_world_bounds_the_velocity() -> None:
    state = driven(robot("velocity_bounds [ -0.1 0.2 0 0 0 0 -10 20 ]"), seconds=1.0, ahead=9.0, turn=-90.0)

    assert state.velocity == Velocity(0.2, 0.0, -10.0)


def test_a_world_bounds_the_acceleration() -> None:
    """At 0.5 m/s2 up to 0.5 m/s in one second, 0.25 m; at 1 m/s2 to rest in half a second, 0.125 m."""
    loop = loop_of(robot("acceleration_bounds [ -1 0.5 0 0 0 0 -90 90 ]"))

    drive(loop, "it", ahead=0.5)
    run(loop, 1.0)
    gained = loop.drives["it"].state()
    drive(loop, "it")
    run(loop, 1.0)

    assert gained.velocity.ahead == pytest.approx(0.5)
    assert place(gained.truth) == at(0.25, 0, 0)
    assert place(loop.drives["it"].state().truth) == at(0.375, 0, 0)


# --- what is in the way


def test_a_wall_stops_a_robot_at_its_body() -> None:
    """Its front is 0.1 m before its centre, the wall begins at x = 1; it keeps a tenth of a millimetre."""
    before = driven(robot() + WALL, seconds=1.7, ahead=0.5)
    after = driven(robot() + WALL, seconds=3.0, ahead=0.5)

    assert not before.is_stalled
    assert place(before.truth) == at(0.85, 0, 0)
    assert after.is_stalled
    assert place(after.truth) == at(0.8999, 0, 0)


@pytest.mark.parametrize(
    ("ahead", "turn", "part"),
    [(0.15, 900.0, 0.5), (40.0, 20.0, 0.25), (40.0, 300.0, 0.75)],
    ids=["a tight arc, in pieces of 2 degrees", "a long arc, in pieces of 2 cm", "a wide arc"],
)
def test_what_lies_on_an_arc_stops_the_robot_however_fast_it_is(
    ahead: float, turn: float, part: float
) -> None:
    """The post is on the arc of one tick, and off the straight lines between a few points of it."""
    size, radius, angle = 0.002, ahead / radians(turn), radians(turn) * TICK * part
    x, y = radius * sin(angle), radius * (1 - cos(angle))
    text = (
        f'position( name "it" size [ {size} {size} 0.2 ] velocity_bounds [ -50 50 0 0 0 0 -900 900 ] )\n'
        f'model( name "post" size [ {size / 2} {size / 2} 1 ] pose [ {x} {y} 0 0 ] )\n'
    )

    state = driven(text, seconds=TICK, ahead=ahead, turn=turn)

    assert state.is_stalled
    assert hypot(state.truth.x - x, state.truth.y - y) <= 1.2 * size


def test_a_robot_at_a_wall_can_leave_it() -> None:
    loop = loop_of(robot() + WALL)
    drive(loop, "it", ahead=0.5)
    run(loop, 3.0)

    drive(loop, "it", ahead=-0.5)
    run(loop, 1.0)

    assert place(loop.drives["it"].state().truth) == at(0.3999, 0, 0)
    assert not loop.drives["it"].state().is_stalled


def test_a_turn_ends_where_the_body_touches() -> None:
    """A bar of 0.6 m turns until its corner, sqrt(0.3^2 + 0.05^2) away, comes to a wall at y = 0.2."""
    text = 'position( name "it" size [ 0.6 0.1 0.2 ] ) model( name "w" size [ 4 0.2 1 ] pose [ 0 0.3 0 0 ] )'
    corner, behind = hypot(0.3, 0.05), degrees(atan2(0.05, 0.3))

    state = driven(text, seconds=4.0, turn=45.0)

    assert state.is_stalled
    assert state.truth.yaw == pytest.approx(degrees(asin(0.2 / corner)) - behind, abs=0.021)


def test_two_robots_that_meet_stop_each_other_in_the_middle() -> None:
    loop = loop_of(robot(pose="-1 0 0 0", name="a") + robot(pose="1 0 0 180", name="b"))
    for name in "ab":
        drive(loop, name, ahead=0.5)

    run(loop, 4.0)

    a, b = (loop.drives[name].state() for name in "ab")
    assert a.is_stalled
    assert b.is_stalled
    assert b.truth.x - a.truth.x == pytest.approx(0.2, abs=2e-4)
    assert a.truth.x + b.truth.x == pytest.approx(0, abs=0.011)


def test_a_robot_pushes_what_gives_way() -> None:
    """The box begins at x = 0.4, so it is touched after 0.3 m and pushed 0.2 m of 0.5."""
    text = robot() + 'model( name "box" size [ 0.2 0.2 0.2 ] pose [ 0.5 0 0 0 ] pushable 1 )'
    loop = loop_of(text)
    drive(loop, "it", ahead=0.5)

    run(loop, 1.0)

    assert place(loop.drives["it"].state().truth) == at(0.5, 0, 0)
    assert place(loop.pose("box")) == pytest.approx((0.7, 0, 0), abs=2e-4)


@settings(max_examples=examples(40), deadline=None)
@given(st.floats(-1, 1), st.floats(-90, 90), st.floats(0, 360))
@example(1e-09, 0.0, 0.0)
def test_a_tick_as_a_whole_and_in_substeps_are_the_same(ahead: float, turn: float, yaw: float) -> None:
    """A robot with room takes a tick at once; one that stands in a floor never does.

    That one stays where it is if a tick takes it a nanometre or less: in 20 ticks that is 2e-8 metres.
    """
    floor = "model( size [ 30 30 0.1 ] )\n"
    expected = driven(robot(pose=f"0 0 0 {yaw}"), seconds=2.0, ahead=ahead, turn=turn)
    careful = driven(floor + robot(pose=f"0 0 0 {yaw}"), seconds=2.0, ahead=ahead, turn=turn)

    assert place(careful.truth)[:2] == pytest.approx(place(expected.truth)[:2], abs=2.1e-8)
    apart = abs(careful.truth.yaw - expected.truth.yaw)
    assert isclose(apart, 0, abs_tol=1e-6) or isclose(apart, 360, abs_tol=1e-6)


# --- users


def test_a_robot_without_users_stands() -> None:
    loop = loop_of(robot())
    loop.drives["it"].drive(Velocity(0.5))

    run(loop, 1.0)

    assert loop.drives["it"].state().truth == MetricPose()


def test_a_robot_stops_at_once_when_its_last_user_leaves() -> None:
    loop = loop_of(robot("acceleration_bounds [ -0.1 0.5 0 0 0 0 -90 90 ]"))
    it = loop.drives["it"]
    it.subscribe()
    drive(loop, "it", ahead=0.5)
    run(loop, 1.0)

    it.unsubscribe()
    run(loop, 1.0)
    one_left = it.state().truth.x
    it.unsubscribe()
    run(loop, 1.0)
    it.subscribe()
    run(loop, 1.0)

    assert one_left == pytest.approx(0.75)
    assert it.state().truth.x == one_left
    assert it.state().velocity == Velocity()


# --- poses


def test_a_robot_and_a_thing_are_put_elsewhere() -> None:
    text = robot() + WALL + 'model( name "box" size [ 0.2 0.2 0.2 ] pose [ 3 3 0 0 ] pushable 1 )'
    loop = loop_of(text)
    drive(loop, "it", ahead=0.5)

    loop.put("it", MetricPose(5, 6, 90))
    loop.put("box", MetricPose(5, 6.4, 0))
    run(loop, 1.0)

    assert place(loop.pose("it")) == at(5, 6.5, 90)
    assert place(loop.pose("box")) == pytest.approx((5, 6.7, 0), abs=2e-4)
    assert place(loop.pose("wall")) == at(1.1, 0, 0)
    for name in ("wall", "nothing"):
        with pytest.raises(KeyError):
            loop.put(name, MetricPose())


def test_a_robot_that_counts_its_wheels_begins_at_0_0_0() -> None:
    loop = loop_of(robot('localization "odom"', "3 4 0 90"))
    it = loop.drives["it"]
    drive(loop, "it", ahead=0.5)

    run(loop, 1.0)
    counted = it.state()
    it.set_odometry(MetricPose(1, 1, 180))
    it.set_pose(MetricPose(0, 0, 0))
    run(loop, 1.0)

    assert place(counted.believed) == at(0.5, 0, 0)
    assert place(counted.truth) == at(3, 4.5, 90)
    assert place(it.state().believed) == at(0.5, 1, 180)
    assert place(it.state().truth) == at(0.5, 0, 0)


def test_a_robot_that_knows_its_place_takes_no_other_for_it() -> None:
    loop = loop_of(robot(pose="3 4 0 90"))

    loop.drives["it"].set_odometry(MetricPose(1, 1, 0))

    assert place(loop.drives["it"].state().believed) == at(3, 4, 90)


# --- devices


def test_rangers_read_metres_in_the_order_of_the_file() -> None:
    """The wall is 1 m ahead: 0.9 from a sensor at the front, 1/cos(45) aslant, and 0.3 m is out of range."""
    text = (
        robot(
            'ranger( name "far" sensor( pose [ 0.1 0 0 0 ] fov 0.001 ) sensor( pose [ 0 0 0 180 ] ) )'
            'ranger( name "fan" sensor( range [ 0 3 ] samples 3 fov 90 ) )'
            'ranger( name "near" sensor( range [ 0 0.3 ] ) sensor( range [ 2 3 ] ) )'
        )
        + WALL
    )

    readings = loop_of(text).drives["it"].rangers()

    assert [each.name for each in readings] == ["far", "fan", "near"]
    assert [sensor for each in readings for sensor in each.sensors] == [
        pytest.approx(each, abs=1e-6) for each in ((0.9,), (5.0,), (sqrt(2), 1.0, sqrt(2)), (0.3,), (2.0,))
    ]


def test_noise_is_drawn_from_the_seed() -> None:
    text = robot("ranger( sensor( range [ 0 5 ] noise [ 0.1 0 0 ] ) )") + WALL

    def read(seed: int) -> float:
        return loop_of(text, seed).drives["it"].rangers()[0].sensors[0][0]

    assert read(0) == 1.0
    assert read(1) == read(1) != read(2)
    assert 0.9 <= read(1) <= 1.1


def test_bumpers_are_pressed_where_something_touches() -> None:
    """Stage's order: by the number in ``bpose[i]``."""
    bumper = "bumper( size [ 0.1 0.1 0.1 ] bcount 2 bpose[0] [ 0.1 0 0 0 ] bpose[1] [ -0.1 0 0 180 ] )"
    loop = loop_of(robot(bumper) + WALL)
    drive(loop, "it", ahead=0.5)

    before = loop.drives["it"].bumpers()
    run(loop, 3.0)

    assert [each.pressed for each in before] == [(False, False)]
    assert [each.pressed for each in loop.drives["it"].bumpers()] == [(True, False)]


def test_a_blobfinder_sees_colours_with_their_borders() -> None:
    """A board 0.2 m wide, its face 1 m ahead, from 0.4 to 0.6 m to the left. Its side is seen too."""
    finder = 'blobfinder( name "eye" range 3 fov 80 )'
    board = 'model( size [ 0.02 0.2 1 ] pose [ 1.01 0.5 0 0 ] color "tomato" )'

    ((eye,),) = [loop_of(robot(finder) + board).drives["it"].blobs()]

    (blob,) = eye.blobs
    assert eye.name == "eye"
    assert blob.colour == (255, 99, 71)
    assert blob.left == pytest.approx(degrees(atan2(0.6, 1.0)))
    assert blob.right == pytest.approx(degrees(atan2(0.4, 1.02)))
    assert blob.metres == pytest.approx(hypot(1.0, 0.4))


def test_a_fiducial_finder_knows_where_marks_look() -> None:
    """Distances are to the middle of a thing; beyond ``range_max_id`` its number is 0."""
    text = (
        robot("fiducial( range_max 8 range_max_id 3 fov 180 pose [ 0 0 0 90 ] )")
        + "model( size [ 0.2 0.2 1 ] pose [ 1 2 0 30 ] fiducial_return 7 )"
        + "model( size [ 0.2 0.2 1 ] pose [ -1 4 0 -90 ] fiducial_return 8 )"
        + "model( size [ 0.2 0.2 1 ] pose [ 0 -1 0 0 ] fiducial_return 9 )"
    )

    ((reading,),) = [loop_of(text).drives["it"].marks()]

    assert [each.number for each in reading.marks] == [0, 7]
    assert [each.metres for each in reading.marks] == pytest.approx([hypot(1, 4), hypot(1, 2)])
    assert [each.degrees for each in reading.marks] == pytest.approx(
        [degrees(atan2(1, 4)), -degrees(atan2(1, 2))]
    )
    assert [each.yaw for each in reading.marks] == pytest.approx([180, -60])


# --- the page about it

PAGE = (ROOT / "docs" / "simulation.md").read_text(encoding="utf-8")


def test_the_program_of_the_page_drives_both_robots_on_the_arcs_that_it_names() -> None:
    """2 s at 5 cm and 15 degrees a second: 30 degrees of a circle of 0.05 / radians(15) m."""
    (program,) = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    names: dict[str, object] = {}
    with redirect_stdout(StringIO()) as printed:
        exec(program, names)

    loop = names["loop"]
    assert isinstance(loop, VelocityLoop)
    radius = 0.05 / radians(15)
    ahead, left = radius * sin(radians(30)), radius * (1 - cos(radians(30)))
    alice, bob = (loop.drives[name].state().truth for name in ("alice", "bob"))
    assert (alice.x, alice.y, alice.yaw) == pytest.approx((-left, ahead, 120))  # from 0 0, to the north
    assert (bob.x, bob.y, bob.yaw) == pytest.approx((left, 1.5 - ahead, 300))  # from 0 1.5, to the south
    assert [line.split()[0] for line in printed.getvalue().splitlines()] == ["alice", "bob"]
    said = f"{radius * 100:.1f} cm radius: {ahead * 100:.1f} cm ahead, {left * 100:.1f} cm to the left."
    assert said in " ".join(PAGE.split())


# --- arcs of every kind


@pytest.mark.parametrize(
    ("ahead", "left", "turn"),
    [
        (0.5, 0.0, 45.0),
        (-0.5, 0.0, 45.0),
        (-0.5, 0.0, -45.0),
        (0.0, 0.5, 45.0),
        (0.0, -0.5, 45.0),
        (0.3, 0.4, -45.0),
        (-0.3, 0.4, 45.0),
        (0.3, -0.4, 0.0),
        (0.0, 0.0, -45.0),
    ],
)
@pytest.mark.parametrize("is_near", [False, True], ids=["at once", "in substeps"])
def test_an_omnidirectional_robot_drives_arcs_to_all_sides(
    ahead: float, left: float, turn: float, is_near: bool
) -> None:
    """In two seconds, from 1, 2 and 30 degrees on; a robot that stands in a floor drives in substeps."""
    floor = "model( size [ 30 30 0.1 ] )\n" if is_near else ""
    text = floor + robot('drive "omni"', "1 2 0 30")
    angle, way = radians(2 * turn), 2 * hypot(ahead, left)
    chord = way * (sin(angle / 2) / (angle / 2) if angle else 1.0)
    towards = radians(30) + atan2(left, ahead) + angle / 2

    state = driven(text, seconds=2.0, ahead=ahead, left=left, turn=turn)

    x, y = 1 + chord * cos(towards), 2 + chord * sin(towards)
    assert place(state.truth) == at(x, y, (30 + 2 * turn) % 360)
    assert state.velocity == Velocity(ahead, left, turn)
    assert not state.is_stalled


@pytest.mark.parametrize(
    ("velocity", "substeps"),
    [
        ({"ahead": 0.1}, 1),
        ({"ahead": 0.02 / TICK}, 1),
        ({"ahead": 0.021 / TICK}, 2),
        ({"ahead": -0.05 / TICK}, 3),
        ({"ahead": 0.03 / TICK, "left": -0.04 / TICK}, 3),
        ({"turn": 2.0 / TICK}, 1),
        ({"turn": -2.1 / TICK}, 2),
        ({"ahead": 0.021 / TICK, "turn": 7.0 / TICK}, 4),
        ({"ahead": 0.07 / TICK, "turn": 2.1 / TICK}, 4),
    ],
)
def test_a_tick_has_substeps_of_two_centimetres_or_two_degrees_at_most(
    velocity: dict[str, float], substeps: int
) -> None:
    loop = loop_of(robot('drive "omni" velocity_bounds [ -9 9 -9 9 0 0 -999 999 ]'))
    drive(loop, "it", **velocity)
    it = loop.drives["it"]
    assert it.substeps() == 1

    assert it.begin_tick()

    assert it.substeps() == substeps


def test_a_robot_that_gets_slower_has_the_substeps_of_its_speed() -> None:
    loop = loop_of(robot("velocity_bounds [ -9 9 0 0 0 0 -99 99 ] acceleration_bounds [ -9 9 0 0 0 0 -9 9 ]"))
    it = loop.drives["it"]
    drive(loop, "it", ahead=0.1 / TICK)
    assert it.begin_tick()
    assert it.substeps() == 5
    run(loop, 1.0)
    it.drive(Velocity())

    assert it.begin_tick()
    assert it.substeps() == 5


@pytest.mark.parametrize("sign", [1, -1])
def test_a_turn_to_either_side_ends_a_hair_before_it_touches(sign: int) -> None:
    """A corner at 2, 1 of a circle comes to 1, 2 after 36.87 degrees, of which it keeps 0.02."""
    text = f'position( name "it" size [ 0.4 0.2 0.2 ] ) model( size [ 4 0.2 1 ] pose [ 0 {0.3 * sign} 0 0 ] )'
    loop = loop_of(text)
    drive(loop, "it", turn=sign * 45.0)

    run(loop, 2.0)
    state = loop.drives["it"].state()

    assert state.is_stalled
    assert state.truth.yaw == pytest.approx(sign * (degrees(atan2(2, 1) - atan2(1, 2)) - 0.02) % 360)
    drive(loop, "it", turn=sign * -45.0)
    run(loop, 1.0)
    turned = loop.drives["it"].state()
    assert not turned.is_stalled
    assert turned.truth.yaw == pytest.approx((state.truth.yaw - sign * 45) % 360)


# --- getting faster and slower


def test_a_robot_gets_faster_in_every_direction_by_its_own_bounds() -> None:
    """After a second: 0.2 ahead, 0.3 to the right and 20 degrees a second to the left."""
    gains = "acceleration_bounds [ -0.1 0.2 -0.3 0.4 0 0 -10 20 ]"
    loop = loop_of(robot(f'drive "omni" velocity_bounds [ -9 9 -9 9 0 0 -99 99 ] {gains}'))
    drive(loop, "it", ahead=1.0, left=-1.0, turn=90.0)

    run(loop, 1.0)
    first = loop.drives["it"].state().velocity
    drive(loop, "it", ahead=-1.0, left=1.0, turn=-90.0)
    run(loop, 0.5)
    second = loop.drives["it"].state().velocity

    assert (first.ahead, first.left, first.turn) == pytest.approx((0.2, -0.3, 20))
    assert (second.ahead, second.left, second.turn) == pytest.approx((0.15, -0.1, 15))


@pytest.mark.parametrize(("left", "turn"), [(0.4, 0.0), (0.0, 45.0)])
def test_the_way_of_a_tick_is_that_of_its_mean_velocity(left: float, turn: float) -> None:
    """After two seconds of getting faster, half of the way that the last velocity would be."""
    loop = loop_of(robot('drive "omni" acceleration_bounds [ -1 1 -0.2 0.2 0 0 -22.5 22.5 ]'))
    drive(loop, "it", left=left, turn=turn)

    run(loop, 2.0)

    assert place(loop.drives["it"].state().truth) == at(0, left, turn)
    assert loop.drives["it"].state().velocity == Velocity(0.0, pytest.approx(left), pytest.approx(turn))


def test_a_bound_that_forbids_standing_counts_as_0() -> None:
    text = robot("velocity_bounds [ 0.1 0.2 0 0 0 0 -20 -10 ]")

    assert driven(text, seconds=1.0, ahead=-1.0, turn=90.0).velocity == Velocity()
    assert driven(text, seconds=1.0, ahead=0.05, turn=-15.0).velocity == Velocity(0.05, 0.0, -15.0)


# --- the loop


def test_nothing_moves_while_the_loop_is_paused() -> None:
    loop = loop_of(robot())
    drive(loop, "it", ahead=0.5)
    run(loop, 1.0)
    loop.is_paused = True
    run(loop, 1.0)
    assert (loop.time, loop.pose("it").x) == pytest.approx((1.0, 0.5))

    loop.is_paused = False
    run(loop, 1.0)
    assert (loop.time, loop.pose("it").x) == pytest.approx((2.0, 1.0))


def test_a_held_robot_stands_until_it_is_released() -> None:
    loop = loop_of(robot("acceleration_bounds [ -0.5 0.5 0 0 0 0 -90 90 ]"))
    it = loop.drives["it"]
    drive(loop, "it", ahead=0.5)
    run(loop, 1.0)

    it.is_held = True
    run(loop, 1.0)
    assert (it.state().truth.x, it.state().velocity) == (pytest.approx(0.25), Velocity())
    assert it._vehicle.clock.seconds == pytest.approx(1.0)
    it.is_held = False
    run(loop, 1.0)
    assert it.state().truth.x == pytest.approx(0.5)
    assert it._vehicle.clock.seconds == pytest.approx(2.0)


def test_a_robot_that_is_left_once_too_often_has_one_user_after_the_next_one() -> None:
    loop = loop_of(robot())
    it = loop.drives["it"]
    it.unsubscribe()
    drive(loop, "it", ahead=0.5)

    run(loop, 1.0)
    assert it.state().truth.x == pytest.approx(0.5)
    it.unsubscribe()
    run(loop, 1.0)
    assert (it.state().truth.x, it._vehicle.clock.seconds) == pytest.approx((0.5, 1.0))


def test_a_reset_puts_all_back_and_the_velocities_stay() -> None:
    box = 'model( name "box" size [ 0.2 0.2 0.2 ] pose [ 3.5 4 0 0 ] pushable 1 )'
    loop = loop_of(robot('localization "odom"', "3 4 0 0") + box)
    drive(loop, "it", ahead=0.5)
    run(loop, 1.0)
    assert loop.pose("box").x > 3.6

    loop.reset()
    state = loop.drives["it"].state()
    assert (place(state.truth), place(state.believed)) == ((3, 4, 0), (0, 0, 0))
    assert place(loop.pose("box")) == (3.5, 4, 0)
    run(loop, 0.1)
    assert loop.pose("it").x == pytest.approx(3.05)


def test_poses_have_headings_from_0_to_below_360() -> None:
    loop = loop_of(robot('localization "odom"', "0 0 0 -90") + WALL.replace("0 0 ]", "0 -30 ]"))
    assert (loop.pose("it").yaw, loop.pose("wall").yaw) == (270, 330)

    loop.put("it", MetricPose(1, 2, 725))
    loop.drives["it"].set_odometry(MetricPose(3, 4, -5))

    state = loop.drives["it"].state()
    assert (place(state.truth), place(state.believed)) == ((1, 2, 5), (3, 4, 355))


def test_a_part_of_a_robot_is_no_thing_with_a_pose() -> None:
    loop = loop_of(robot('model( name "box" )'))

    with pytest.raises(KeyError):
        loop.pose("box")


# --- heads, marks and grippers


def test_a_head_looks_where_it_was_turned_and_the_body_does_not() -> None:
    """The head is 0.05 m ahead on a robot that looks to the north; the wall is 1 m to the east."""
    head = (
        'ranger( name "body" sensor( fov 0.1 pose [ 0 0 0 -90 ] ) )'
        'position( name "head" size [ 0.02 0.02 0.02 ] pose [ 0.05 0 0 0 ]'
        ' ranger( name "eye" sensor( fov 0.1 pose [ 0.01 0 0 0 ] ) ) )'
    )
    loop = loop_of(robot(head, "0 0 0 90") + WALL)
    it, (scene_head,) = loop.drives["it"], [each for each in loop.scene.models if each.name == "head"]

    def read(part: int | None = None) -> dict[str, float]:
        return {each.name: round(each.sensors[0][0], 4) for each in it.rangers(part)}

    assert read() == {"body": 1.0, "eye": 5.0}
    it.turn_head(scene_head.index, -90.0)
    assert read() == {"body": 1.0, "eye": 0.99}
    it.turn_head(scene_head.index, -150.0)
    assert read()["eye"] == pytest.approx(2 - 0.01, abs=4e-3)
    (eye,) = [each.index for each in loop.scene.models if each.name == "eye"]
    it.turn_head(scene_head.index, -90.0)
    assert read(eye) == {"eye": 0.99}
    assert read(scene_head.index) == {}


def test_a_mark_on_a_thing_looks_where_the_thing_was_turned_to() -> None:
    mark = 'model( name "box" size [ 0.2 0.2 1 ] pose [ 1 0 0 30 ] fiducial_return 7 pushable 1 )'
    loop = loop_of(robot("fiducial( range_max 8 range_max_id 3 fov 180 )") + mark)

    def looks() -> float:
        return loop.drives["it"].marks()[0].marks[0].yaw

    assert looks() == pytest.approx(30)
    loop.put("box", MetricPose(1.5, 0, 100))
    assert looks() == pytest.approx(100)
    (box,) = [each.index for each in loop.scene.models if each.name == "box"]
    loop.change(box, fiducial_return=9)
    assert [each.number for each in loop.drives["it"].marks()[0].marks] == [9]
    assert looks() == pytest.approx(100)


def test_a_gripper_of_a_driven_robot_carries_what_it_took() -> None:
    gripper = "gripper( pose [ 0.15 0 0 0 ] size [ 0.1 0.1 0.1 ] )"
    ball = 'model( name "ball" size [ 0.05 0.05 0.05 ] pose [ 0.2 0 0 0 ] gripper_return 1 )'
    loop = loop_of(robot(gripper) + ball)
    it = loop.drives["it"]

    assert it.beams() == (True, False)
    assert it.grip().name == "ball"
    assert it.beams() == (True, True)
    drive(loop, "it", ahead=0.5)
    run(loop, 1.0)
    assert place(loop.pose("ball")) == at(0.7, 0, 0)
    assert it.release().name == "ball"
    run(loop, 0.1)
    assert loop.pose("ball").x < 0.76


def test_rangers_say_how_strongly_things_answer() -> None:
    post = "model( size [ 0.02 0.4 1 ] pose [ 0.5 1 0 0 ] ranger_return 0.25 )\n"
    text = robot(
        "ranger( sensor( fov 0.001 ) sensor( fov 0.001 pose [ 0 1 0 0 ] ) "
        "sensor( fov 0.001 pose [ 0 0 0 180 ] ) )"
        "ranger( sensor( samples 3 fov 90 range [ 0 3 ] ) )"
    )

    one, fan = loop_of(text + WALL + post).drives["it"].rangers()

    assert one.returns == ((1.0,), (0.25,), (0.0,))
    assert one.sensors == (pytest.approx((1.0,)), pytest.approx((0.49,)), (5.0,))
    assert fan.returns == ((1.0, 1.0, 1.0),)


def test_a_blobfinder_reads_from_left_to_right() -> None:
    board = 'model( size [ 0.02 0.2 1 ] pose [ 1.01 {} 0 0 ] color "{}" )\n'
    boards = board.format(-0.4, "blue") + board.format(0.4, "red") + board.format(0, "green")

    (eye,) = loop_of(robot("blobfinder( range 3 fov 90 )") + boards).drives["it"].blobs()

    assert [each.colour for each in eye.blobs] == [(255, 0, 0), (0, 255, 0), (0, 0, 255)]
    assert all(each.left > each.right for each in eye.blobs)
    assert [each.metres for each in eye.blobs] == pytest.approx([hypot(1, 0.3), 1, hypot(1, 0.3)])


def test_each_device_reads_for_its_own_model() -> None:
    """A part is asked for by the index of its model."""
    devices = (
        'ranger( name "one" sensor( ) ) ranger( name "two" sensor( ) )'
        'bumper( name "front" bcount 1 bpose[0] [ 0.1 0 0 0 ] )'
        'blobfinder( name "eye" ) fiducial( name "mark" )'
    )
    loop = loop_of(robot(devices) + WALL)
    it, index = loop.drives["it"], {each.name: each.index for each in loop.scene.models}

    assert [each.name for each in it.rangers()] == ["one", "two"]
    for read, name in ((it.rangers, "two"), (it.bumpers, "front"), (it.blobs, "eye"), (it.marks, "mark")):
        assert [each.name for each in read(index[name])] == [name]
        assert read(index["it"]) == ()
