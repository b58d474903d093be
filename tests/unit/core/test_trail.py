"""The last moves in words and as a table."""

from devices.ports.robot import Pose, StoppedBy
from donnie_tui.core.events import HowStarted, Moved, Outcome, Reset, RunEnded, RunStarted, Stamped, Turned
from donnie_tui.core.map_grid import path_in_words
from donnie_tui.core.timeline import MOVES_KEPT, Trail
from donnie_tui.i18n.words import Words

WALK = Moved("FW 3", 3, 3, None, Pose(0, 3, 0), True)
TURN = Turned("TR 90", 90, 90, None, Pose(0, 3, 90), True)
BLOCKED = Moved("FW 9", 9, 2, StoppedBy.OBSTACLE, Pose(2, 3, 90), True)


def trail(*events: object) -> Trail:
    made = Trail()
    for number, event in enumerate(events, 1):
        made.on_event(Stamped(number, 0.0, event))  # type: ignore[arg-type] # events
    return made


def test_moves_are_listed_oldest_first_with_their_final_places() -> None:
    assert trail(WALK, TURN, BLOCKED).in_words(5, Words()) == (
        "FW 3: 3 steps, to 0, 3.",
        "TR 90: now facing east.",
        "FW 9: blocked after 2 steps, at 2, 3.",
    )
    assert trail(WALK, TURN, BLOCKED).in_words(1, Words("pt")) == ("FW 9: obstáculo após 2 passos, em 2, 3.",)


def test_a_move_that_was_stopped_is_not_called_blocked() -> None:
    stopped = Moved("FW 9", 9, 2, StoppedBy.USER, Pose(0, 2, 0), True)

    assert trail(stopped).in_words(1, Words()) == ("FW 9: stopped after 2 steps, at 0, 2.",)


def test_a_trail_without_moves_says_so() -> None:
    assert trail().in_words(5, Words("es")) == ("Todavía no me moví.",)


def test_the_table_has_one_row_per_move() -> None:
    assert trail(WALK, TURN, BLOCKED).rows() == (
        ("FW 3", 3, 0, 3, 0, False),
        ("TR 90", 90, 0, 3, 90, False),
        ("FW 9", 2, 2, 3, 90, True),
    )


def test_the_last_place_is_known_without_a_move_too() -> None:
    ended = RunEnded(Outcome.COMPLETED, Pose(7, 7, 0), {}, 1.0)

    assert trail(WALK, ended).last_pose == Pose(7, 7, 0)
    assert trail().last_pose is None


def test_the_oldest_moves_are_forgotten() -> None:
    assert len(trail(*[WALK] * (MOVES_KEPT + 10)).rows()) == MOVES_KEPT


def test_each_robot_has_a_trail_of_its_own() -> None:
    talked_to = "alice"
    trail = Trail(lambda: talked_to)
    there = Moved("FW 3", 3, 3, None, Pose(0, 3, 0), True)
    trail.on_event(Stamped(1, 0.0, there, "alice"))

    assert trail.in_words(5, Words()) == ("FW 3: 3 steps, to 0, 3.",)
    talked_to = "bob"
    assert trail.in_words(5, Words()) == ("I have not moved yet.",)
    assert trail.last_pose is None


def started(pose: Pose) -> RunStarted:
    return RunStarted("program", "w", "donnie", 0, "0", HowStarted("", 1, True, False, False, pose))


def test_the_path_has_a_sentence_for_each_straight_leg_and_its_length() -> None:
    here, there = Pose(0, 0, 0), Pose(4, 3, 90)
    moves = (
        WALK,
        TURN,
        Moved("FW 2", 2, 2, None, Pose(2, 3, 90), True),
        Moved("FW 2", 2, 2, None, there, True),
    )
    back = Moved("BW 3", 3, 3, None, Pose(4, 0, 0), False)

    path = trail(started(here), *moves, back).path

    assert path_in_words(path, Words()) == (
        "The path starts at 0, 0.",
        "North: 3 steps, to 0, 3.",
        "East: 4 steps, to 4, 3.",
        "South: 3 steps, to 4, 0.",
        "10 steps in all.",
    )
    assert path_in_words(path, Words("pt"))[1] == "Norte: 3 passos, até 0, 3."
    assert path_in_words(path, Words("es"))[1] == "Norte: 3 pasos, hasta 0, 3."


def test_the_path_continues_in_the_next_run_and_begins_anew_where_the_robot_was_put() -> None:
    first = (started(Pose(0, 0, 0)), WALK)

    assert len(trail(*first, started(Pose(0, 3, 0)), BLOCKED).path) == 3
    assert trail(*first, started(Pose(9, 9, 0))).path == (Pose(9, 9, 0),)
    assert path_in_words(trail(*first, Reset(Pose(0, 0, 0))).path, Words()) == ("I have not moved yet.",)


def test_the_path_ends_as_the_robot_looks_and_only_one_that_drove_has_a_path_to_draw() -> None:
    turned = Turned("TR 90", 90, 90, None, Pose(0, 0, 90), True)

    assert trail(started(Pose(0, 0, 0)), WALK, TURN).paths == {
        None: (Pose(0, 0, 0), Pose(0, 3, 0), Pose(0, 3, 90))
    }
    assert trail(started(Pose(0, 0, 0)), turned).paths == {}
