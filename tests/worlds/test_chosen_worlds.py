"""A loaded world: remarks, robots and seeds, the start of a challenge, and where things are now."""

from pathlib import Path

import pytest
from msgspec.structs import replace

import worlds
from devices.ports.robot import Pose
from donnie_tui.core.events import PlacedThing
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.world.loading import (
    ChosenWorld,
    Site,
    ThingWatch,
    choose_challenge,
    choose_world,
    files_of,
    include_for,
    inhabited_world,
    inventory_of,
    moved_to,
    remarks,
    robot_put_in,
    scattered_by,
    solution_of,
    started_at,
    with_robot,
)
from sim.geometry import Placement
from sim.scene import Scene
from sim.world import World
from sim.worldfile import load_text
from worlds.challenges import Variant

WORDS = Words("en")
BOB = "define bob position ( size [ 0.2 0.1 0.1 ] ranger ( sensor ( ) ) )\n"
ROBOT = BOB + 'bob ( name "ann" pose [ {} 0 0 90 ] )\n'
ANN = ROBOT.format(0)


def chosen(folder: Path, text: str, name: str = "my.world") -> ChosenWorld:
    (folder / name).write_text(text, encoding="utf-8")
    return choose_world(str(folder / name), WORDS)


def scene(text: str) -> Scene:
    return load_text(text, Path("my.world"))


# --- remarks


@pytest.mark.parametrize(
    ("text", "slips"),
    [
        (ANN, 0),
        (ANN + "model ( pose [ 2 0 0 0 ] obstacle_retrun 1 )", 1),
        (ANN + 'model ( pose [ 2 0 0 0 ] color "amarelo" )', 1),
        (ANN + 'position ( pose [ 2 0 0 0 ] drive "fast" )', 1),
        (ANN + "define a model ( )\ndefine a model ( )", 1),
        (ANN + "model ( pose [ 2 0 0 0 ] block ( points 3 point[0] [ 0 0 ] point[1] [ 1 0 ] ) )", 1),
        (ANN + "model ( pose [ 2 --5 0 0 ] )", 1),
        (ANN + "model ( pose [ 2 0 0 0 ] block ( points 2 point[0] [ 0 0 ] point[1] [ 1 0 ] ) )", 1),
        (ANN + "position ( pose [ 2 0 0 0 ] ranger ( sensor ( samples 0 ) sensor ( ) ) )", 1),
        (ANN + "model ( pose [ 2 0 0 0 ] window ( ) )", 1),
        ('include "donnie.inc"; it\n' + ANN, 1),
        (ANN + "define a model ( 5 )", 1),
        (ANN + "model ( pose [ 2 0 0 0 ] size [ 1 1 1 1 ] friction 1 )", 0),
    ],
)
def test_what_has_no_effect_in_a_file_is_a_slip_and_what_is_unused_is_none(
    text: str, slips: int, tmp_path: Path
) -> None:
    found = remarks(chosen(tmp_path, text), WORDS)

    path = tmp_path / "my.world"
    assert found == ((f"1 slip in the world. donnie world {path} --report lists it.",) if slips else ())


def test_an_empty_name_of_a_picture_and_an_unknown_model_are_slips(tmp_path: Path) -> None:
    unknown = 'driver ( name "stage" provides [ "position2d:0" ] model "anne" )'
    (tmp_path / "my.cfg").write_text(f'driver ( name "stage" worldfile "my.world" )\n{unknown}')

    one = remarks(chosen(tmp_path, ANN + 'model ( pose [ 2 0 0 0 ] bitmap "" )'), WORDS)
    two = remarks(choose_world(str(tmp_path / "my.cfg"), WORDS), WORDS)
    assert [each[:7] for each in (*one, *two)] == ["1 slip ", "2 slips"]


@pytest.mark.parametrize(
    ("count", "listed", "last"), [(1, 1, ""), (3, 3, ""), (4, 3, "1 slip"), (5, 3, "2 slips")]
)
def test_three_things_with_a_robot_in_them_are_listed_and_the_others_counted(
    count: int, listed: int, last: str, tmp_path: Path
) -> None:
    boxes = 'model ( size [ 0.1 0.1 0.1 ] name "{}" )\n'
    found = remarks(chosen(tmp_path, ANN + "".join(boxes.format(f"b{at}") for at in range(count))), WORDS)

    assert found[:listed] == tuple(
        f"Robot ann and b{at} begin at the same place. Move one of them." for at in range(listed)
    )
    assert [each.partition(" in ")[0] for each in found[listed:]] == ([last] if last else [])


# --- which world


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("maz", "There is no world maz. Did you mean maze?"),
        ("Living Room", "There is no world Living Room. Did you mean living_room?"),
        ("my", "There is no world my. Did you mean my.world?"),
        ("qqqqq", "There is no world qqqqq. "),
        ("challenge:frist_walk", "There is no challenge frist_walk. Did you mean first_walk?"),
        ("challenge:qqqqq", "There is no challenge qqqqq."),
        ("no.world", "There is no file no.world."),
        ("./maze", "There is no file maze."),
        ("sub\\maze", "There is no file sub\\maze."),
    ],
)
def test_a_world_that_is_not_there_is_said_with_the_nearest_name(
    name: str, sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("my.world").write_text(ANN)
    with pytest.raises(Unusable) as refused:
        choose_world(name, WORDS)

    assert refused.value.sentences[0].startswith(sentence)


def test_the_name_of_a_world_that_ships_is_not_that_of_a_file_and_a_file_needs_no_ending(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for name in ("maze", "mine"):
        Path(name).write_text(ANN)

    ours, theirs, mine = (choose_world(name, WORDS) for name in ("maze", "./maze", "mine"))
    assert (ours.ships, ours.name, ours.path) == (True, "maze", worlds.path("maze"))
    assert (theirs.ships, theirs.name, theirs.path) == (False, "maze", "maze")
    assert (mine.ships, mine.scene.robot_names) == (False, ("ann",))


def test_a_world_has_its_title_and_is_called_by_its_file_once_it_is_changed(tmp_path: Path) -> None:
    mine, ours = chosen(tmp_path, ANN), choose_world("first_room", WORDS)

    assert (mine.title("en"), mine.about("en")) == ("my.world", None)
    about = ours.about("en")
    assert about is not None
    assert (ours.title("en"), ours.title("pt")) == (about.title, worlds.words.about("first_room", "pt").title)
    assert replace(ours, is_rebuilt=True).title("en") == "first_room"


@pytest.mark.parametrize(
    ("pose", "start"),
    [
        ("0 0 0 90", (0, 0, 0)),
        ("1 -0.5 0 0", (20, -10, 90)),
        ("0 0 0 180", (0, 0, 270)),
        ("0.1 0.3 0 -30", (2, 6, 120)),
    ],
)
def test_the_start_of_a_robot_is_in_steps_and_degrees_of_a_compass(
    pose: str, start: tuple[float, ...], tmp_path: Path
) -> None:
    it = chosen(tmp_path, ANN.replace("0 0 0 90", pose))

    assert it.start() == Pose(*start)
    assert replace(it, scene=scene("model ( )")).start() == Pose(0, 0, 0)


def test_the_files_of_a_world_are_those_that_it_was_loaded_from(tmp_path: Path) -> None:
    (tmp_path / "part.inc").write_text("define it model ( )")
    it = chosen(tmp_path, f'include "part.inc"\n{ANN}')
    main = str(tmp_path / "my.world")

    assert {*files_of(it)} == {main, str(tmp_path / "part.inc")}
    (tmp_path / "my.toml").write_text('[en]\ntitle = "T"\n')
    assert str(tmp_path / "my.toml") in files_of(it)
    assert not [each for each in files_of(choose_world("maze", WORDS)) if each.endswith(".toml")]


def test_a_site_is_saved_until_its_text_changes(tmp_path: Path) -> None:
    mine, ours = Site(chosen(tmp_path, ANN)), Site(choose_world("maze", WORDS))

    assert (mine.path, ours.path, mine.text) == (tmp_path / "my.world", None, "")
    assert (mine.past, mine.undone, mine.is_saved) == ([], [], True)
    mine.text = "x"
    assert not mine.is_saved


# --- robots and seeds


def test_a_donnie_is_written_at_the_end_of_a_world_without_a_robot(tmp_path: Path) -> None:
    it = chosen(tmp_path, "model ( pose [ 2 0 0 0 ] )\n\n\n")
    inhabited = with_robot(it, WORDS, (Path(worlds.SCENES),))

    assert inhabited.text == (
        'model ( pose [ 2 0 0 0 ] )\n\ninclude "donnie.inc"\ndonnie( name "donnie" pose [ 0 0 0 90 ] )\n'
    )
    assert (inhabited.is_robot_put_in, it.is_robot_put_in) == (True, False)
    assert len(robot_put_in(inhabited, WORDS)) == 1
    assert robot_put_in(it, WORDS) == ()
    with_ann = chosen(tmp_path, ANN)
    assert with_robot(with_ann, WORDS, ()) is with_ann


def test_a_world_that_no_robot_fits_in_is_refused(tmp_path: Path) -> None:
    """Its file is gone by the time that a robot is put in."""
    it = chosen(tmp_path, "model ( pose [ 2 0 0 0 ] )")
    Path(it.path).unlink()
    with pytest.raises(Unusable) as refused:
        with_robot(it, WORDS, (Path(worlds.SCENES),))

    assert "my.world" in refused.value.sentences[0]


def test_a_file_is_included_by_its_name_or_whole_in_other_units() -> None:
    assert include_for("donnie.inc", scene("model ( )")) == 'include "donnie.inc"'
    for units in ('unit_length "cm"', 'unit_angle "radians"'):
        assert "define donnie " in include_for("donnie.inc", scene(f"{units} model ( )"))


SCATTERED = "scatter [ -1 -1 1 1 ]\nmodel ( size [ 0.1 0.1 0.1 ] pose [ 0.95 0.95 0 0 ] )\n"


def test_a_seed_scatters_the_things_of_a_world_that_asks_for_it(tmp_path: Path) -> None:
    it = chosen(tmp_path, SCATTERED + ANN)

    def places(seed: int) -> list[tuple[float, float]]:
        found = scattered_by(seed, it, WORDS, (Path(worlds.SCENES),)).scene.models[0].pose
        return [(found.x, found.y)]

    assert places(0) == [(0.95, 0.95)]
    assert places(1) == places(1) != places(2)
    assert all(abs(side) <= 1 for seed in range(1, 9) for place in places(seed) for side in place)
    plain = chosen(tmp_path, ANN, "other.world")
    assert scattered_by(3, plain, WORDS, ()) is plain
    challenged = replace(it, challenge=choose_challenge("first_walk", WORDS).challenge)
    assert scattered_by(3, challenged, WORDS, ()) is challenged
    assert inhabited_world(it.path, WORDS, seed=1).scene.models[0].pose.x != 0.95


# --- challenges

HEAD = 'format = 1\nworld = "first_room"\n[en]\ntitle = "T"\ntask = "Do."\n'
NEAR_BALL, AT_PLACE = '[[goal]]\nat = "ball"\n', "[[goal]]\nat = [0, 5]\n"
UNREAD = "What I can't read is checked after you correct it."
NOT_TOML = "it.toml is not written as a challenge is. The guide for challenges shows how."
NO_WORLD = "Line 2: it.toml asks for the world frist_room. Did you mean first_room?"


def refused_challenge(folder: Path, text: str) -> tuple[str, ...]:
    (folder / "it.toml").write_text(text, encoding="utf-8")
    with pytest.raises(Unusable) as refused:
        choose_challenge(str(folder / "it.toml"), WORDS)
    return refused.value.sentences


@pytest.mark.parametrize(
    ("text", "sentences"),
    [
        (HEAD.replace("first", "frist") + NEAR_BALL, (NO_WORLD, UNREAD)),
        (HEAD.replace("first", "frist") + AT_PLACE, (NO_WORLD,)),
        (HEAD + AT_PLACE + "a = = 3\n", (f"Line 8: {NOT_TOML}", UNREAD)),
        (HEAD + NEAR_BALL + "a = = 3\n", (f"Line 8: {NOT_TOML}", UNREAD)),
        (HEAD + AT_PLACE + "wihtin = 3\n", ("Line 8: it.toml has the key wihtin. Did you mean within?",)),
        (
            HEAD + '[[goal]]\nat = "bal"\n',
            ("Line 7: it.toml names bal, and its world has no such thing. Did you mean ball?",),
        ),
        ('words = ["FWW"]\n' + HEAD + AT_PLACE, ("Line 1: it.toml has FWW. Did you mean FW?",)),
        ('required = ["FWW"]\n' + HEAD + AT_PLACE, ("Line 1: it.toml has FWW. Did you mean FW?",)),
        ('words = ["FW"]\nrequired = ["pf"]\n' + HEAD + AT_PLACE.replace("[0, 5]", '"x"'),
         ("Line 9: it.toml names x, and its world has no such thing. "
          "Possible are ball, chair, sofa, table, west wall, east wall, north wall, south wall.",)),
        (HEAD.replace('"first_room"', '"it.world"') + NEAR_BALL,
         ("Error, {folder}/it.world, line 1, column 5: an opening parenthesis is never closed.", UNREAD)),
        (HEAD.replace('"first_room"', '"it.world"') + AT_PLACE,
         ("Error, {folder}/it.world, line 1, column 5: an opening parenthesis is never closed.",)),
    ],
)  # fmt: skip
def test_a_challenge_that_can_not_be_used_says_each_reason(
    text: str, sentences: tuple[str, ...], tmp_path: Path
) -> None:
    (tmp_path / "it.world").write_text("bad (")

    assert refused_challenge(tmp_path, text) == tuple(each.format(folder=tmp_path) for each in sentences)


@pytest.mark.parametrize(("count", "listed"), [(19, 19), (20, 20), (25, 20)])
def test_of_many_mistakes_of_a_challenge_twenty_are_listed_in_the_order_of_their_lines(
    count: int, listed: int, tmp_path: Path
) -> None:
    keys = "".join(f"q{at}z = 1\n" for at in range(count))
    said = refused_challenge(tmp_path, keys + HEAD + AT_PLACE)

    assert [each.partition(":")[0] for each in said[:listed]] == [f"Line {at + 1}" for at in range(listed)]
    assert said[listed:] == (("Only the first 20 mistakes are listed.",) if count >= 20 else ())


def test_the_goal_of_a_challenge_without_goals_is_its_solution_which_must_be_readable(tmp_path: Path) -> None:
    (tmp_path / "it.solution.gd").write_text("FW 5")
    (tmp_path / "it.toml").write_text(HEAD)
    it = choose_challenge(str(tmp_path / "it.toml"), WORDS)
    assert solution_of(it, WORDS) == {it.scene.robot_names[0]: "FW 5"}

    (tmp_path / "it.solution.gd").unlink()
    (tmp_path / "it.solution.gd").mkdir()
    assert "it.solution.gd" in refused_challenge(tmp_path, HEAD)[0]


def test_other_robots_have_a_solution_where_there_is_one(tmp_path: Path) -> None:
    (tmp_path / "it.toml").write_text(HEAD.replace("first_room", "two_robots") + AT_PLACE)
    it = choose_challenge(str(tmp_path / "it.toml"), WORDS)
    for name, text in (("it.solution.gd", "FW 1"), ("it.bob.solution.gd", "FW 2")):
        (tmp_path / name).write_text(text)

    assert solution_of(it, WORDS) == {"alice": "FW 1", "bob": "FW 2"}
    (tmp_path / "it.bob.solution.gd").unlink()
    assert solution_of(it, WORDS) == {"alice": "FW 1"}
    (tmp_path / "it.solution.gd").unlink()
    with pytest.raises(Unusable):
        solution_of(it, WORDS)


@pytest.mark.parametrize("name", ["first_walk", "1", "The first walk", "the FIRST walk", "El primer paseo"])
def test_a_challenge_that_ships_is_chosen_by_its_name_its_number_or_its_title(name: str) -> None:
    chosen_one = choose_challenge(name, WORDS)
    started = choose_world(f"challenge:{name}", WORDS)

    assert chosen_one.challenge is not None
    assert chosen_one.challenge.name == "first_walk"
    assert started.challenge == chosen_one.challenge
    assert started.rules == chosen_one.challenge.rules
    assert (started.moves, started.before_moves is not None) == ({}, True)


def test_a_wrong_name_is_answered_in_the_sentence_that_is_asked_for() -> None:
    said = []
    for attempt in (
        lambda: choose_challenge("qqqqq", WORDS),
        lambda: choose_challenge("qqqqq", WORDS, unknown="challenge-unknown-here"),
        lambda: choose_world("challenge:qqqqq", WORDS),
        lambda: choose_world("challenge:qqqqq", WORDS, unknown="world-unknown-here"),
        lambda: choose_world("qqqqq", WORDS),
        lambda: choose_world("qqqqq", WORDS, unknown="world-unknown-here"),
    ):
        with pytest.raises(Unusable) as refused:
            attempt()
        said.append(refused.value.sentences[0])

    challenge, challenge_here, *others, world, world_here = said
    assert others == [challenge, challenge_here]
    assert len({challenge, challenge_here, world, world_here}) == 4
    assert all("qqqqq" in each for each in said)


# --- the start of a challenge

TWO = BOB + 'bob ( name "ann" pose [ 1 0 0.5 0 ] )\n'
TWO += 'bob ( name "bea" pose [ 2 0 0 45 ] )\nmodel ( name "crate" pose [ 0 2 0.1 30 ] )\n'


@pytest.mark.parametrize(
    ("variant", "ann", "bea", "crate"),
    [
        (Variant(), (1, 0, 0.5, 0), (2, 0, 0, 45), (0, 2, 0.1, 30)),
        (Variant((10, -20, "north")), (0.5, -1, 0.5, 90), (2, 0, 0, 45), (0, 2, 0.1, 30)),
        (Variant((0, 0, 30)), (0, 0, 0.5, 60), (2, 0, 0, 45), (0, 2, 0.1, 30)),
        (
            Variant(None, {"crate": (2, 4), "bea": (6, 8)}),
            (1, 0, 0.5, 0),
            (0.3, 0.4, 0, 45),
            (0.1, 0.2, 0.1, 30),
        ),
        (Variant((0, 0, "west"), {"ann": (2, 2)}), (0, 0, 0.5, -180), (2, 0, 0, 45), (0, 2, 0.1, 30)),
    ],
)
def test_a_start_puts_the_first_robot_and_things_elsewhere(
    variant: Variant, ann: tuple[float, ...], bea: tuple[float, ...], crate: tuple[float, ...], tmp_path: Path
) -> None:
    it = chosen(tmp_path, TWO)
    started = started_at(it, variant, WORDS)
    found = {each.name: each.pose for each in started.scene.models}

    for name, pose in (("ann", ann), ("bea", bea), ("crate", crate)):
        assert (found[name].x, found[name].y, found[name].z, found[name].yaw % 360) == pytest.approx(
            (*pose[:3], pose[3] % 360)
        )
    assert started.before_moves == it
    again = started_at(started, Variant(), WORDS)
    assert again.scene == it.scene
    assert (len(again.moves), again.before_moves) == (0, it)


def test_goals_know_things_robots_and_the_size_of_the_first_robot() -> None:
    it = inventory_of(scene(TWO))

    assert [each.name for each in it.items] == ["crate"]
    assert it.radius == pytest.approx(1.5)  # 4 and 2 steps: half of their middle
    assert it.robots == {"ann": Pose(20, 0, 90), "bea": Pose(40, 0, 45)}


# --- where things are now


def test_the_places_of_things_are_reported_where_they_change(tmp_path: Path) -> None:
    box = "model ( size [ 0.1 0.1 0.1 ] pushable 1 pose [ 0 {} 0 30 ] )\n"
    world = World(scene(ANN + box.format(0.2) + box.format(5)))
    watch, ann = ThingWatch(world), world.inhabitant("ann")

    assert watch() is None
    ann.forward(4)
    (placed,) = watch() or ()
    assert (placed.name, placed.index, placed.pose.x) == (world.scene.models[2].name, 2, 0)
    assert placed.pose.y == pytest.approx(
        8 - 0.634, abs=0.01
    )  # half of the turned box is 1.366, of the robot 2
    assert placed.pose.heading == 60
    assert watch() is None
    world.ground.put(2, Placement(0.1, 0.3, 0, 90.0000000001))
    assert watch() == (PlacedThing(placed.name, Pose(2, 6, 0), 2),)
    world.ground.put(2, world.scene.models[2].pose)
    assert watch() == ()
    assert watch() is None


def test_a_scene_has_its_things_where_events_say_that_they_are() -> None:
    it = scene(ANN + "model ( pose [ 1 1 0.5 10 ] )\n" * 2)
    far = [PlacedThing("x", Pose(1, 1, 0), at) for at in (-1, len(it.models))]
    now = moved_to(it, (PlacedThing("", Pose(20, -10, 30), len(it.models) - 1), *far)).models

    assert now[-1].pose == Placement(1, -0.5, 0.5, 60)
    assert [each.pose for each in now[:-1]] == [each.pose for each in it.models[:-1]]
    assert moved_to(it, (PlacedThing("", Pose(0, 40, 0), 0),)).models[0].pose == Placement(0, 2, 0, 90)
