"""What is pushed how far, and what a gripper takes, in metres worked out by hand.

The blind robot is 0.2 m long and 0.1 m wide. Bodies keep 0.1 mm from what they meet.
"""

from math import cos, hypot, radians, sin

import pytest

from devices.ports.robot import STEP, Grip, RobotProblem
from sim.geometry import Placement, Spot, direction
from sim.ground import Ground
from sim.handling import Advance, Hand, Pushing
from sim.motion import Mover
from tests.unit.sim.floors import BOX_ROBOT, scene

SKIN = 1e-4
ROBOT, _, FIRST, SECOND, THIRD = range(5)
"""The second model is the robot's ranger."""


class Floor:
    """A blind robot at 0, 0, and boxes as it sees them: left, bottom, right, top, and more."""

    def __init__(
        self, *boxes: tuple[float, float, float, float, str], yaw: float = 0, more: str = ""
    ) -> None:
        c, s = direction(yaw)
        text = f"{BOX_ROBOT}blind( pose [ 0 0 0 {yaw} ] )\n"
        for left, bottom, right, top, its in boxes:
            x, y = (left + right) / 2, (bottom + top) / 2
            text += f"model( size [ {right - left:.9f} {top - bottom:.9f} 1 ]"
            text += f" pose [ {c * x - s * y:.9f} {s * x + c * y:.9f} 0 {yaw} ] {its} )\n"
        self.ground = Ground(scene(text + more))
        self.pushing = Pushing(self.ground, Mover(self.ground, ROBOT))
        self.yaw = yaw

    def advance(self, length: float = STEP, angle: float = 0) -> tuple[float, dict[int, float]]:
        found = self.pushing.advance(Spot(0, 0, self.yaw), self.yaw + angle, length)
        return found.metres, dict(found.pushed)


CRATE = (0.13, -0.04, 0.23, 0.06, "pushable 1")
"""3 cm before the robot."""
WAY = 0.03 - SKIN
"""Metres up to it."""
YAWS = (0, 90, 180, 270, 30)


def wall(left: float, bottom: float = -1, top: float = 1) -> tuple[float, float, float, float, str]:
    return left, bottom, left + 0.1, top, ""


@pytest.mark.parametrize("yaw", YAWS)
@pytest.mark.parametrize(
    ("boxes", "metres", "pushed"),
    [
        ((CRATE,), STEP, {FIRST: STEP - WAY}),
        ((CRATE, wall(0.24)), WAY + 0.01 - SKIN, {FIRST: 0.01 - SKIN}),
        ((CRATE, wall(0.24, 0.05)), WAY + 0.01 - SKIN, {FIRST: 0.01 - SKIN}),
        ((CRATE, wall(0.24, -1, -0.03)), WAY + 0.01 - SKIN, {FIRST: 0.01 - SKIN}),
        ((CRATE, wall(0.24, 0.061)), STEP, {FIRST: STEP - WAY}),  # next to its way
        ((CRATE, wall(0.24, -1, -0.041)), STEP, {FIRST: STEP - WAY}),
        ((CRATE, wall(0.26)), STEP, {FIRST: STEP - WAY}),
        ((CRATE, wall(0.24, 0), wall(0.245, -1, 0)), WAY + 0.01 - SKIN, {FIRST: 0.01 - SKIN}),
        ((CRATE, wall(0.245, -1, 0), wall(0.24, 0)), WAY + 0.01 - SKIN, {FIRST: 0.01 - SKIN}),
        (
            # a third one, 5 mm after the second one, and a wall 2 mm after the third one
            (
                *(CRATE, (0.24, -0.04, 0.3, 0.06, "pushable 1")),
                *((0.305, -0.04, 0.4, 0.06, "pushable 1"), wall(0.402)),
            ),
            WAY + 0.017 - 3 * SKIN,
            {FIRST: 0.017 - 3 * SKIN, SECOND: 0.007 - 2 * SKIN, THIRD: 0.002 - SKIN},
        ),
        (
            # the first two overlap, and so move together
            (CRATE, (0.14, 0.04, 0.235, 0.2, "pushable 1"), wall(0.239, 0.1)),
            WAY + 0.004 - SKIN,
            {FIRST: 0.004 - SKIN, SECOND: 0.004 - SKIN},
        ),
        ((CRATE, wall(0.12)), 0.02 - SKIN, {}),  # the wall comes first
        ((CRATE, wall(0.23)), WAY, {}),
        ((CRATE, wall(0.2)), WAY, {}),  # it stands in the wall
        (
            (CRATE, (0.24, 0.05, 0.3, 0.2, "pushable 1")),
            STEP,
            {FIRST: STEP - WAY, SECOND: STEP - WAY - 0.01 + SKIN},
        ),
        (
            (CRATE, (0.24, 0.05, 0.3, 0.2, "pushable 1"), wall(0.305)),
            WAY + 0.01 - SKIN + 0.005 - SKIN,
            {FIRST: 0.015 - 2 * SKIN, SECOND: 0.005 - SKIN},
        ),
        (
            # the first pushes the second, and then it meets a wall itself
            (CRATE, (0.24, 0.05, 0.3, 0.2, "pushable 1"), wall(0.245, -1, 0)),
            WAY + 0.015 - SKIN,
            {FIRST: 0.015 - SKIN, SECOND: 0.005},
        ),
        ((CRATE, wall(0.248)), WAY + 0.018 - SKIN, {FIRST: 0.018 - SKIN}),
        ((CRATE, (0.14, 0.055, 0.3, 0.2, "pushable 1")), STEP, {FIRST: STEP - WAY, SECOND: STEP - WAY}),
        (
            (CRATE, (0.14, -0.2, 0.3, -0.045, "pushable 1")),  # the robot comes to it
            STEP,
            {FIRST: STEP - WAY, SECOND: 0.01 + SKIN},
        ),
        ((CRATE, (0.24, -1, 0.3, 1, "obstacle_return 0")), STEP, {FIRST: STEP - WAY}),
        (((*CRATE[:4], ""),), WAY, {}),
        (((0.13, 0.051, 0.23, 0.2, "pushable 1"),), STEP, {}),
        (((0.13, -0.2, 0.23, -0.051, "pushable 1"),), STEP, {}),
        (((0.16, -0.2, 0.23, 0.2, "pushable 1"),), STEP, {}),
        ((), STEP, {}),
    ],
)
def test_a_robot_and_what_it_pushes_move_until_one_of_them_meets_something(
    yaw: float,
    boxes: tuple[tuple[float, float, float, float, str], ...],
    metres: float,
    pushed: dict[int, float],
) -> None:
    found = Floor(*boxes, yaw=yaw).advance()

    assert found[0] == pytest.approx(metres)
    assert list(found[1]) == list(pushed)
    assert list(found[1].values()) == pytest.approx([*pushed.values()], abs=2e-7)


@pytest.mark.parametrize("length", [0.0, 0.01, WAY, 0.031, 0.05])
def test_only_the_way_that_was_asked_for_is_pushed(length: float) -> None:
    metres, pushed = Floor(CRATE).advance(length)

    assert metres == pytest.approx(length)
    assert pushed == (pytest.approx({FIRST: length - WAY}) if length > WAY + 1e-9 else {})


def test_a_robot_pushes_backward_what_is_behind_it() -> None:
    floor = Floor((-0.23, -0.05, -0.13, 0.05, "pushable 1"), CRATE)

    assert floor.advance(angle=180) == (STEP, pytest.approx({FIRST: STEP - WAY}))
    assert floor.advance() == (STEP, pytest.approx({SECOND: STEP - WAY}))


@pytest.mark.parametrize("yaw", YAWS)
def test_what_is_pushed_is_moved_straight_ahead_and_asked_about_anew(yaw: float) -> None:
    floor = Floor(CRATE, yaw=yaw)
    before = floor.ground.place(FIRST)
    advance = floor.pushing.advance(Spot(0, 0, yaw), yaw, STEP)
    assert floor.pushing.advance(Spot(0, 0, yaw), yaw, STEP) is advance

    floor.pushing.take_along(advance, yaw)

    after, moved = floor.ground.place(FIRST), STEP - WAY
    assert (after.x - before.x, after.y - before.y) == pytest.approx(
        (moved * cos(radians(yaw)), moved * sin(radians(yaw)))
    )
    assert (after.yaw, after.z) == (before.yaw, before.z)
    assert floor.pushing.advance(Spot(0, 0, yaw), yaw, STEP) == Advance(STEP, ())
    floor.pushing.take_along(Advance(STEP, ()), yaw)
    assert floor.ground.place(FIRST) == after


def test_a_thing_in_a_gripper_does_not_give_way() -> None:
    floor = Floor(CRATE, more='blind( name "bob" pose [ 0 9 0 0 ] )')
    bob = floor.ground.scene.robot("bob").index
    floor.ground.attach(FIRST, bob)

    assert floor.advance() == (pytest.approx(WAY), {})
    floor.ground.attach(FIRST, None)
    assert floor.advance()[0] == STEP


# --- grippers

LIFTER = """
define lifter position ( size [ 0.2 0.2 0.1 ] ranger( sensor( pose [ 0 0 0 90 ] ) )
  gripper( pose [ 0.15 0 0 0 ] size [ 0.1 0.1 0.1 ] ) )
lifter( pose [ 0 0 0 0 ] )
"""
"""The middle of the gripper is at 0.15 m, its tips are at 0.2 m; the paddles are 0.1 m apart."""


def hand(*balls: tuple[float, float], more: str = "") -> Hand:
    """Balls of 0.05 m around these places."""
    text = "".join(
        f"model( size [ 0.05 0.05 0.05 ] pose [ {x} {y} 0 0 ] gripper_return 1 )\n" for x, y in balls
    )
    return Hand(Mover(Ground(scene(LIFTER + text + more)), 0))


A, B = 3, 4


@pytest.mark.parametrize(
    ("first", "second", "taken"),
    [
        ((0.15, 0.06), (0.2095, 0), B),  # 0.035 m from the middle, and 0.0345
        ((0.15, 0.06), (0.2105, 0), A),
        ((0.15, -0.06), (0.2095, 0), B),
        ((0.15, -0.06), (0.2105, 0), A),
        ((0.2095, 0), (0.15, 0.06), A),
        ((0.2105, 0), (0.15, -0.06), B),
        ((0.2, 0.065), (0.15, 0.071), B),  # the root of 0.025 and 0.04 squared is 0.0472 m, against 0.046
        ((0.2, 0.065), (0.15, 0.073), A),
        ((0.16, 0.01), (0.14, 0.06), A),  # around the middle
        ((0.195, 0), (0.15, 0), B),  # an edge 2 cm away, and one 2.5 cm away around the middle
        ((0.24, 0), (0.24, 0.051), A),  # of equals the first
        ((0.272, 0), (0.15, 0.072), B),
        ((0.272, 0), (0.278, 0), A),
        ((0.278, 0), (0.272, 0), B),
    ],
)
def test_of_two_things_the_one_nearest_to_the_middle_of_the_gripper_is_taken(
    first: tuple[float, float], second: tuple[float, float], taken: int
) -> None:
    it = hand(first, second)

    assert it.grip(Spot(0, 0, 0)) is Grip.GRIPPED
    assert it.held == taken


@pytest.mark.parametrize(
    ("x", "y", "outcome"),
    [
        (0.2749, 0, Grip.GRIPPED),  # a step before the tips
        (0.2751, 0, Grip.NOTHING_THERE),
        (0.15, 0.0749, Grip.GRIPPED),
        (0.15, 0.0751, Grip.NOTHING_THERE),
        (0.15, -0.0749, Grip.GRIPPED),
        (0.15, -0.0751, Grip.NOTHING_THERE),
        (0.2749, 0.0749, Grip.GRIPPED),
        (0.2751, 0.0749, Grip.NOTHING_THERE),
        (0.0751, 0.0749, Grip.GRIPPED),
        (0.0749, 0.0749, Grip.NOTHING_THERE),
        (0.4, 0, Grip.NOTHING_THERE),
    ],
)
def test_a_thing_is_taken_that_comes_between_the_paddles_or_a_step_before_them(
    x: float, y: float, outcome: Grip
) -> None:
    it = hand((x, y))

    assert it.grip(Spot(0, 0, 0)) is outcome
    assert (it.held is None) is (outcome is Grip.NOTHING_THERE)
    assert it.grip(Spot(0, 0, 0)) is (Grip.HOLDS_ALREADY if it.held else Grip.NOTHING_THERE)


@pytest.mark.parametrize(
    ("start", "end", "ball"),
    [
        (Spot(0, 0, 0), Spot(1, 2, 0), Placement(1.2, 2.01, 0, 0)),
        (Spot(0, 0, 0), Spot(1, 2, 90), Placement(0.99, 2.2, 0, 90)),
        (Spot(0, 0, 0), Spot(1, 2, 180), Placement(0.8, 1.99, 0, 180)),
        (Spot(0.01, 0.02, 0), Spot(1, 2, 90), Placement(1.01, 2.19, 0, 90)),
        (Spot(0.35, 0.01, 180), Spot(0, 0, 0), Placement(0.15, 0, 0, -180)),
    ],
)
def test_a_held_thing_moves_and_turns_with_the_robot(start: Spot, end: Spot, ball: Placement) -> None:
    """It stands at 0.2, 0.01."""
    it = hand((0.2, 0.01))
    ground = it._ground
    it.carry(end)
    assert ground.moved() == {}
    assert it.grip(start) is Grip.GRIPPED

    it.carry(end)

    place = ground.place(A)
    assert (place.x, place.y, place.z, place.yaw) == pytest.approx((ball.x, ball.y, 0, ball.yaw))
    assert ground.is_attached(A)
    assert it.release() is Grip.RELEASED
    assert not ground.is_attached(A)
    assert it.release() is Grip.HOLDS_NOTHING
    it.carry(start)
    assert ground.place(A) == place


def test_a_held_thing_belongs_to_the_body() -> None:
    """Its far corners are at 0.225, 0.025, and those of the paddles at 0.2, 0.05."""
    it = hand((0.2, 0.0))
    alone = it._mover.body.radius

    it.grip(Spot(0, 0, 0))
    assert it._mover.body.radius == pytest.approx(hypot(0.225, 0.025))
    it.let_go()
    assert it._mover.body.radius == alone == pytest.approx(hypot(0.2, 0.05))
    assert it.held is None


@pytest.mark.parametrize(
    ("balls", "broken"),
    [
        ((), (False, False)),
        (((0.2, 0),), (True, False)),
        (((0.15, 0),), (False, True)),
        (((0.186, 0),), (True, False)),
        (((0.184, 0),), (True, True)),
        (((0.164, 0),), (False, True)),
        (((0.2, 0.084),), (True, False)),
        (((0.2, -0.084),), (True, False)),
        (((0.2, 0.086),), (False, False)),
        (((0.2, -0.086),), (False, False)),
        (((0.15, 0.04), (0.2, -0.04)), (True, True)),
        (((0.236, 0),), (False, False)),
        (((0.234, 0),), (True, False)),
    ],
)
def test_a_beam_at_the_tips_and_one_in_the_middle_are_broken(
    balls: tuple[tuple[float, float], ...], broken: tuple[bool, bool]
) -> None:
    """By what comes within a centimetre."""
    fixed = "model( size [ 0.3 0.3 0.05 ] pose [ 0.3 0 0 0 ] obstacle_return 0 )"

    assert hand(*balls, more=fixed).beams_broken(Spot(0, 0, 0)) == broken
    turned = hand(*((1 - y, 2 + x) for x, y in balls))
    assert turned.beams_broken(Spot(1, 2, 90)) == broken


def test_both_beams_are_broken_by_what_is_held() -> None:
    it = hand((0.26, 0))

    assert it.beams_broken(Spot(0, 0, 0)) == (False, False)
    it.grip(Spot(0, 0, 0))
    assert it.beams_broken(Spot(0, 0, 0)) == (True, True)


def test_a_hand_that_another_robot_has_filled_is_not_emptied() -> None:
    it = hand((0.2, 0), more='lifter( name "bob" pose [ 0.4 0 0 180 ] )')
    bob = Hand(Mover(it._ground, it._ground.scene.robot("bob").index))
    assert it.grip(Spot(0, 0, 0)) is Grip.GRIPPED

    assert bob.grip(Spot(0.4, 0, 180)) is Grip.NOTHING_THERE
    bob.let_go()
    assert it._ground.is_attached(A)
    it.release()
    assert bob.grip(Spot(0.4, 0, 180)) is Grip.GRIPPED


def test_a_robot_without_a_gripper_has_no_hand() -> None:
    without = Hand(Mover(Ground(scene(BOX_ROBOT + "blind( pose [ 0 0 0 0 ] )")), 0))

    for command in (without.grip, without.beams_broken):
        with pytest.raises(RobotProblem, match="no-gripper"):
            command(Spot(0, 0, 0))
    with pytest.raises(RobotProblem, match="no-gripper"):
        without.release()


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("order", [1, -1])
@pytest.mark.parametrize(("metres", "taken"), [(0.0564, B), (0.0570, A)])
def test_only_what_lies_between_the_paddles_counts_for_how_near_a_thing_is(
    side: int, order: int, metres: float, taken: int
) -> None:
    """A slope from 0, 0.06 to 0.08, 0.03 beyond the middle comes as near as 0.0562 m, but above the paddle.

    It crosses the paddle, at 0.05, at 80/3 mm: 0.0567 m from the middle.
    """
    slope = ((0, 3 if side > 0 else 0), (8, 0 if side > 0 else 3), (8, 3 if side > 0 else 0))
    points = " ".join(f"point[{i}] [ {x} {y} ]" for i, (x, y) in enumerate(slope[::order]))
    text = (
        f"model( size [ 0.08 0.03 0.05 ] pose [ 0.19 {side * 0.045} 0 0 ] gripper_return 1"
        f" block( points 3 {points} ) )\n"
        f"model( size [ 0.05 0.05 0.05 ] pose [ {0.15 + metres + 0.025} 0 0 0 ] gripper_return 1 )"
    )
    it = hand(more=text)

    assert it.grip(Spot(0, 0, 0)) is Grip.GRIPPED
    assert it.held == taken
