"""The wild garden has its seeds, and its task is solved with each; so are tasks of the manual's worlds."""

import json
from collections.abc import Sequence
from math import hypot
from pathlib import Path

import pytest

from donnie_tui.bootstrap import make_team
from donnie_tui.core.events import Event, Moved, RunEnded, Spoke
from donnie_tui.core.recording import Header
from donnie_tui.core.session import RunOptions
from donnie_tui.i18n.words import Words
from donnie_tui.outlets.files import bundle_of
from donnie_tui.settings.settings import Settings
from donnie_tui.world.loading import ChosenWorld, inhabited_world
from donnie_tui.world.recorded import unpacked
from sim.picture import Thing, picture

WORDS = Words("en", "normal")
WILD_GARDEN = """\
WHILE COLOR orange == 0 DO
  TR 60
END WHILE
WHILE COLOR orange > 0 DO
  TL 2
END WHILE
TR 91
FW DISTANCE F - 1"""
"""The ball leaves the view 90 degrees to the right. Where nothing stands in the way, it is ahead then."""
SEEDS = range(1, 31)


def run(name: str, text: str, seed: int = 0) -> tuple[ChosenWorld, list[Event]]:
    """The world and what happened; the program ends without a mistake."""
    settings = Settings(world=name, speed=None, seed=seed)
    world = inhabited_world(name, WORDS, seed=seed)
    team = make_team(settings, WORDS, world, terminal=False)
    events: list[Event] = []
    team.chosen.hub.subscribe(lambda stamped: events.append(stamped.event))
    team.chosen.start(text, "program", RunOptions(fresh=True)).wait()
    team.close()
    assert [each.outcome.value for each in events if isinstance(each, RunEnded)] == ["completed"]
    return world, events


def moves(events: Sequence[Event]) -> list[Moved]:
    return [each for each in events if isinstance(each, Moved)]


def thing(world: ChosenWorld, kind: str, colour: str) -> Thing:
    (found,) = (each for each in picture(world.scene).things if (each.kind, each.colour) == (kind, colour))
    return found


def away(world: ChosenWorld, events: Sequence[Event], kind: str, colour: str) -> float:
    """Steps from the robot's middle at the end to that of a thing."""
    end, it = moves(events)[-1].pose, thing(world, kind, colour)
    return hypot(end.x - it.x, end.y - it.y)


# --- the worlds of the manual


def spoken(name: str, text: str) -> list[str]:
    return [each.text for each in run(name, text)[1] if isinstance(each, Spoke)]


def test_bigbob_drives_until_a_wall_is_nearer_than_twenty_steps() -> None:
    (nearest,) = spoken("bigbob4", "WHILE DISTANCE F > 19 DO\nFW 1\nEND WHILE\nSPEAK DISTANCE F")

    assert int(nearest) == 19


def test_bigbob_sees_no_orange_where_none_is_and_four_in_the_full_world() -> None:
    assert spoken("bigbob5", "SPEAK COLOR orange") == ["0"]
    assert spoken("bigbob7", "SPEAK COLOR orange") == ["4"]


def test_bigbob_counts_the_cartons_from_where_all_four_are_in_view() -> None:
    assert spoken("bigbob7", "TR 45\nFW 40\nTL 60\nSPEAK COLOR blue") == ["4"]


def test_bigbob_drives_from_the_chamber_in_the_south_west_to_that_in_the_north_west() -> None:
    _world, events = run("bigbob6", "TR 45\nFW 50\nTL 90\nFW 190")

    assert moves(events)[-1].stopped_by is None
    assert (round(moves(events)[-1].pose.x), round(moves(events)[-1].pose.y)) == (-50, 70)


def test_bigbob_sees_the_orange_and_drives_to_it() -> None:
    text = "SPEAK COLOR orange\nTR 45\nFW 60\nTL 90\nFW 3"
    world, events = run("bigbob_oranges", text)

    assert [each.text for each in events if isinstance(each, Spoke)] == ["1"]
    # 15 steps from the middle to the teeth, 1.5 to the edge of the orange
    assert 0 <= away(world, events, "orange", "orange") - 16.5 < 1
    assert all(each.stopped_by is None for each in moves(events))


def test_bigbob_walks_a_square_of_forty_steps() -> None:
    _world, events = run("bigbob_drive", "REPEAT 4 TIMES\nFW 40\nTR 90\nEND REPEAT")

    corners = [(round(each.pose.x), round(each.pose.y)) for each in moves(events)]
    assert corners == [(40, 0), (40, -40), (0, -40), (0, 0)]


# --- the wild garden


@pytest.mark.parametrize("seed", [0, *SEEDS])
def test_the_ball_of_the_wild_garden_is_found_with_several_seeds(seed: int) -> None:
    world, events = run("wild_garden", WILD_GARDEN, seed)

    assert away(world, events, "ball", "orange") < 5


def test_with_each_seed_the_things_of_the_wild_garden_stand_elsewhere_and_apart() -> None:
    layouts = []
    for seed in (0, *SEEDS):
        things = picture(inhabited_world("wild_garden", WORDS, seed=seed).scene).things
        layouts.append(tuple((each.x, each.y) for each in things))
        assert all(hypot(each.x, each.y) > 6 for each in things)
        assert all(
            hypot(one.x - other.x, one.y - other.y) >= 6
            for at, one in enumerate(things)
            for other in things[:at]
        )
        assert all(max(abs(each.x), abs(each.y)) <= 18 for each in things)

    assert len(set(layouts)) == 1 + len(SEEDS)
    again = picture(inhabited_world("wild_garden", WORDS, seed=1).scene).things
    assert tuple((each.x, each.y) for each in again) == layouts[1]


@pytest.mark.parametrize("first", range(31, 131, 20))
def test_with_every_seed_a_straight_way_leads_to_each_thing_of_the_wild_garden(first: int) -> None:
    """Half of Donnie's body is 1.28 steps wide."""
    for seed in range(first, first + 20):
        things = picture(inhabited_world("wild_garden", WORDS, seed=seed).scene).things
        for it in things:
            away = hypot(it.x, it.y)
            for other in things:
                along = (other.x * it.x + other.y * it.y) / away
                aside = abs(other.x * it.y - other.y * it.x) / away
                assert other is it or not 0 < along < away or aside > other.width / 2 + 1.28


def test_a_recording_has_the_garden_of_its_seed() -> None:
    settings = Settings(world="wild_garden", seed=4)
    world = inhabited_world("wild_garden", WORDS, seed=4)
    record = json.loads(json.dumps(bundle_of(world, settings).as_record()))

    with unpacked(Header("0", 4, "sim", {}, record), WORDS) as there:
        assert there.scene.models == world.scene.models


def test_a_scattered_world_of_a_learner_keeps_what_its_author_wrote(tmp_path: Path) -> None:
    file = tmp_path / "w.world"
    file.write_text(
        'include "donnie.inc" # mine\nscatter [ -2 -2 2 2 ]\nmodel( name "in" pose [ 1 1 0 0 ] )\n'
        'model( name "out" pose [ 3 1 0 0 ] )\ndonnie( pose [ 0 0 0 90 ] )\n'
    )

    world = inhabited_world(str(file), WORDS, seed=2)

    inside, outside = (
        next(each for each in world.scene.models if each.name == name) for name in ("in", "out")
    )
    assert (outside.pose.x, outside.pose.y) == (3, 1)
    assert (inside.pose.x, inside.pose.y) != (1, 1)
    assert 'include "donnie.inc" # mine\nscatter' in world.text
    assert not world.is_robot_put_in
    assert inhabited_world(str(file), WORDS).text == ""


@pytest.mark.parametrize("area", ['[ "-2" -2 2 2.0.1 ]', "[ 2 -2 -2 2 5 ]", "[ 2 2 -2 -2 ]"])
def test_a_rectangle_to_scatter_in_is_read_as_other_numbers_are(tmp_path: Path, area: str) -> None:
    """Texts are numbers, as in Stage; a fifth value has no effect; two opposite corners in any order."""
    file = tmp_path / "w.world"
    line = 'model( name "in" pose [ 1 1 0 0 ] )\ninclude "donnie.inc"\ndonnie( name "d" pose [ 0 0 0 90 ] )\n'
    file.write_text(f"scatter {area}\n{line}")

    world = inhabited_world(str(file), WORDS, seed=2)

    (inside,) = (each for each in world.scene.models if each.name == "in")
    assert (inside.pose.x, inside.pose.y) != (1, 1)
    assert {note.code for note in world.scene.report.notes} <= {"read-as", "first-values"}


def test_a_rectangle_to_scatter_in_has_no_effect_in_a_model(tmp_path: Path) -> None:
    file = tmp_path / "w.world"
    file.write_text("model(\n  scatter [ -2 -2 2 2 ]\n)\n")

    (note, *_) = inhabited_world(str(file), WORDS).scene.report.notes

    assert (note.code, note.line, note.details["name"]) == ("unused-property", 2, "scatter")
