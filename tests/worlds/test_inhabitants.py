"""A world without a robot gets a Donnie, on a free place, facing north; the session says so."""

from collections.abc import Iterable
from pathlib import Path

import pytest
from msgspec import Struct

import worlds
from devices.ports.robot import STEP, Pose
from donnie_tui.i18n.words import Words
from donnie_tui.world.loading import ChosenWorld, Site, inhabited_world, robot_put_in
from sim.geometry import overlapping
from sim.parts import body_of, parts_of
from sim.world import World
from tests.unit.sim.floors import Unpaced

WORDS = Words("en", "normal")


def start(tmp_path: Path, text: str) -> Pose:
    (tmp_path / "w.world").write_text(text, encoding="utf-8")
    return inhabited_world(str(tmp_path / "w.world"), WORDS).start()


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("", (0, 0)),
        # 2 m to the east: nothing is near 0, 0
        ("model( pose [ 2 0 0 0 ] )", (0, 0)),
        # a box of 0.4 m on 0, 0: 0.2 m and the room of 0.3 m are 10 steps; north comes first
        ("model( size [ 0.4 0.4 1 ] )", (0, 10)),
        # a box whose edge is 0.35 m from 0, 0
        ("model( pose [ 0.55 0 0 0 ] size [ 0.4 0.4 1 ] )", (0, 0)),
        # floor from x = 4 to 6 m and from y = 4 to 6 m, without 0, 0
        (
            "".join(
                f"model( pose [ {x} {y} 0 0 ] size [ {w} {h} 1 ] )\n"
                for x, y, w, h in ((4, 5, 0.1, 2), (6, 5, 0.1, 2), (5, 4, 2, 0.1), (5, 6, 2, 0.1))
            ),
            (100, 100),
        ),
    ],
    ids=["nothing", "far", "a box in the middle", "a box near the middle", "walls elsewhere"],
)
def test_the_donnie_stands_at_the_free_place_that_is_nearest(
    tmp_path: Path, text: str, place: tuple[int, int]
) -> None:
    found = start(tmp_path, text)

    assert (found.x, found.y, found.heading) == (*place, 0)


@pytest.mark.parametrize("side", [0.2, 0.3, 0.4, 0.6, 0.8, 1.0])
@pytest.mark.parametrize("shift", [(0.0, 0.0), (0.05, -0.05)])
def test_it_starts_inside_of_the_room_that_is_drawn_around_its_place(
    tmp_path: Path, side: float, shift: tuple[float, float]
) -> None:
    """Rooms of ``side`` metres inside, walls of one step; the floor outside has no end."""
    (x, y), out, long = shift, (side + 0.05) / 2, side + 0.1
    walls = ((x + out, y, 0.05, long), (x - out, y, 0.05, long), (x, y + out, long, 0.05))
    text = "".join(
        f"model( pose [ {at_x} {at_y} 0 0 ] size [ {width} {depth} 0.24 ] )\n"
        for at_x, at_y, width, depth in (*walls, (x, y - out, long, 0.05))
    )
    most = side / 2 - 0.0667  # so far its middle may be from that of the room

    found = start(tmp_path, text)

    assert abs(found.x * STEP - x) <= most + 1e-9
    assert abs(found.y * STEP - y) <= most + 1e-9


@pytest.mark.parametrize("side", [0.6, 1.0, 4.0])
@pytest.mark.parametrize(("east", "north"), [(0, 0), (-1, 0), (0, -1), (-1, -1), (-0.5, 0)])
def test_it_starts_inside_of_a_room_with_a_wall_on_its_place(
    tmp_path: Path, side: float, east: float, north: float
) -> None:
    """A corner of the room, or the middle of a wall, is on 0, 0; ``side`` metres from wall to wall."""
    left, bottom, long = east * side, north * side, side + 0.05
    text = "".join(
        f"model( pose [ {left + x * side} {bottom + y * side} 0 0 ] size [ {width} {depth} 0.24 ] )\n"
        for x, y, width, depth in ((0.5, 0, long, 0.05), (0.5, 1, long, 0.05), (0, 0.5, 0.05, long))
    )
    text += f"model( pose [ {left + side} {bottom + side / 2} 0 0 ] size [ 0.05 {long} 0.24 ] )\n"

    found = start(tmp_path, text)

    assert left < found.x * STEP < left + side
    assert bottom < found.y * STEP < bottom + side


def test_it_starts_next_to_the_table_of_a_small_room(tmp_path: Path) -> None:
    """A table of 0.4 m on 0, 0 in a room of 1 m: between the table and the wall are 0.3 m."""
    room = "model( boundary 1 size [ 1.02 1.02 0.24 ] )\nmodel( size [ 0.4 0.4 0.3 ] )"

    found = start(tmp_path, room)

    assert max(abs(found.x), abs(found.y)) * STEP == pytest.approx(0.35)


@pytest.mark.parametrize("name", ["empty", "helloworld"])
def test_it_touches_nothing_in_the_worlds_of_the_manual_and_can_walk(name: str) -> None:
    scene = inhabited_world(name, WORDS).scene
    (index,) = scene.robots
    mine = [part.points for part in parts_of(scene) if part.root == index]
    others = [part.points for part in parts_of(scene) if part.root != index and part.solid]

    assert body_of(scene, index).radius == pytest.approx(0.0667, abs=0.003)  # an octagon 0.128 m across
    assert not any(overlapping(points, other) for points in mine for other in others)
    assert World(scene).robot(pace=Unpaced()).forward(4).walked == 4


def test_a_world_with_a_robot_stays_as_it_is() -> None:
    found = inhabited_world("living_room", WORDS)

    assert (found.text, robot_put_in(found, WORDS)) == ("", ())


def test_the_session_says_it_and_saving_the_world_would_keep_the_donnie(tmp_path: Path) -> None:
    (tmp_path / "w.world").write_text("model( pose [ 0 0 0 0 ] size [ 0.4 0.4 1 ] )", encoding="utf-8")
    found = inhabited_world(str(tmp_path / "w.world"), WORDS)

    assert robot_put_in(found, WORDS) == ("The world w.world has no robot, so I put Donnie in, at 0, 10.",)
    (tmp_path / "saved.world").write_text(Site(found).text, encoding="utf-8")
    saved = inhabited_world(str(tmp_path / "saved.world"), WORDS)
    assert (saved.text, saved.start().y * STEP) == ("", pytest.approx(0.5))


PLAIN = (float, int, str, bool, type(None))


def numbers_of(value: object) -> list[object]:
    """All values of a model, flat."""
    if isinstance(value, PLAIN):
        return [value]
    if isinstance(value, Struct):
        return [each for name in value.__struct_fields__ for each in numbers_of(getattr(value, name))]
    if isinstance(value, Iterable):
        return [each for one in value for each in numbers_of(one)]
    return [repr(value)]


@pytest.mark.parametrize(
    ("units", "box"),
    [
        ('unit_length "cm"', "size [ 40 40 100 ]"),
        ('unit_length "mm" unit_angle "radians"', "size [ 400 400 1000 ]"),
        ('unit_angle "radians"', "size [ 0.4 0.4 1 ]"),
    ],
)
def test_a_world_in_other_units_gets_the_same_donnie(tmp_path: Path, units: str, box: str) -> None:
    def inhabited(text: str) -> ChosenWorld:
        (tmp_path / "w.world").write_text(text, encoding="utf-8")
        return inhabited_world(str(tmp_path / "w.world"), WORDS)

    plain = inhabited("model( size [ 0.4 0.4 1 ] )")
    found = inhabited(f"{units.replace(' unit', chr(10) + 'unit')}\nmodel( {box} )")

    assert found.start() == plain.start() == Pose(0, 10, 0)
    for mine, other in zip(found.scene.models, plain.scene.models, strict=True):
        for here, there in zip(numbers_of(mine), numbers_of(other), strict=True):
            assert here == (pytest.approx(there, abs=1e-6) if isinstance(there, float) else there)


def test_the_worlds_that_ship_without_a_robot_are_those_two() -> None:
    put_in = [name for name in worlds.names() if inhabited_world(name, WORDS).text]

    assert put_in == ["empty", "helloworld"]
