"""Questions after a run. The right answers are worked out by hand from the places of the things."""

from __future__ import annotations

import pytest

from devices.ports.robot import Pose
from donnie_tui.core.events import Moved, Reset, Stamped
from donnie_tui.core.goals import Inventory, track_of
from donnie_tui.core.questions import Asked, unsensed_question
from donnie_tui.i18n.words import Words
from sim.picture import Thing
from worlds.challenges import Ask, Avoided, ChallengeQuestion, Goal, Target, Unsensed


def item(number: int, name: str, kind: str, colour: str, x: float, y: float, half: float = 0.0) -> Thing:
    """A thing with its middle there, from which it reaches ``half`` to each side."""
    return Thing(name, kind, "t", colour, x, y, 2 * half, 2 * half, index=number)


ROOM = Inventory(
    (
        item(1, "chair", "chair", "green", 10.0, 10.0, 2.0),
        item(2, "box", "box", "red", 0.0, 20.0, 1.0),
        item(3, "box 2", "box", "blue", -30.0, 0.0, 1.0),
        item(4, "", "tin", "", 0.0, -53.0),
    ),
    radius=3.0,
    robots={"donnie": Pose(0.0, 0.0, 0.0)},
)
WAY = [
    Stamped(1, 0.0, Reset(Pose(0.0, 0.0, 0.0))),
    Stamped(2, 1.0, Moved("FW", 5, 5, None, Pose(0.0, 5.0, 0.0), True)),
]


def asked(
    ask: Ask, of: str | tuple[str, ...], origin: Target = "start", tolerance: float | None = None
) -> Asked:
    return Asked(ChallengeQuestion(ask, of, origin, tolerance), track_of(ROOM, WAY))


@pytest.mark.parametrize(
    ("question", "right", "wrong"),
    [
        # From 0, 0 to 10, 10 it is northeast, 45 degrees.
        (asked("direction", "green chair"), ["45", "NE", "nordeste", "70 degrees"], ["80", "SO", "?"]),
        (asked("direction", "green chair"), ["to the north-east"], ["to the south"]),
        (asked("direction", "green chair", tolerance=10), ["40", "35", "55.0"], ["70", "34", "56"]),
        (asked("direction", "green chair", tolerance=0), ["45", "45,0", "405", "NE"], ["44", "46"]),
        (asked("direction", "green chair"), ["15", "75", "N-E", "NE.", "NE 200"], ["14", "76", "S 45", ""]),
        # From 0, 5 the box at 0, 20 is straight north; 350 is only 10 degrees off.
        (asked("direction", "red box", "end"), ["0", "350", "norte", "N"], ["90"]),
        # From 0, 0 to the box's south side at 19, less the body's 3: 16; from 0, 5 it is 11.
        (asked("distance", "red box"), ["16", "15 steps", "18", "14", "17,9"], ["19", "13", "18,1", ""]),
        (asked("distance", "red box", tolerance=0.5), ["16", "16.5", "e 16"], ["17"]),
        (asked("distance", "red box", "end"), ["11"], ["16"]),
        # From -30, 10 the nearer box is the blue one, straight south; the red one is at 72 degrees.
        (asked("direction", "box", (-30, 10)), ["180"], ["72"]),
        # From the middle of the blue box, at -30, 0, to 8, 8: hypot(38, 8) is 38.8.
        (asked("distance", "green chair", "blue box"), ["39"], ["36"]),
        (asked("count", "box"), ["2", "2.0", "there are 2", "Two.", "dois"], ["3", "some"]),
        (asked("colour", "chair"), ["green", "It is green.", "verde", "VERDE", "red,green"], ["red", ""]),
        # The chair is 11.3 - 3 away, the red box 16, the blue one 26.
        (asked("order", ("blue box", "chair", "red box")), ["2 3 1", "231", "2, 3, 1"], ["1 2 3", "2 3"]),
        (asked("order", ("blue box", "chair", "red box")), ["two three one"], ["2 3 1 1", ""]),
    ],
)  # fmt: skip
def test_an_answer_is_right_within_the_tolerance(question: Asked, right: list[str], wrong: list[str]) -> None:
    assert [each for each in right if not question.is_right(each)] == []
    assert [each for each in wrong if question.is_right(each)] == []


@pytest.mark.parametrize(
    ("question", "text", "answer"),
    [
        (
            asked("direction", "green chair"),
            "From the start: in which direction is the green chair?",
            "It is to the northeast, 45 degrees.",
        ),
        (
            asked("distance", "red box", "end"),
            "From the robot: how many steps to the red box?",
            "It is 11 steps.",
        ),
        (asked("count", "blue box"), "How many of these are there: box, blue?", "There is 1."),
        (asked("colour", "chair"), "Which color is the chair?", "It is green."),
        (
            asked("order", ("red box", "chair"), (1, 2)),
            "From 1, 2: which is nearer? Type the numbers, the nearest first: 1 box, red; 2 chair.",
            "The order is 2 1.",
        ),
        (
            asked("distance", "green chair", "blue box"),
            "From the blue box: how many steps to the green chair?",
            "It is 39 steps.",
        ),
        (
            asked("direction", "red box", (0.6, 10)),
            "From 0.6, 10: in which direction is the red box?",
            "It is to the north, 357 degrees.",
        ),
        (
            asked("direction", "red box", (0.01, 10)),
            "From 0.01, 10: in which direction is the red box?",
            "It is to the north, 0 degrees.",
        ),
        (
            asked("order", ("blue box", "chair", "red box"), "end"),
            "From the robot: which is nearer? Type the numbers, the nearest first: 1 box, blue; 2 chair;"
            " 3 box, red.",
            "The order is 2 3 1.",
        ),
        (asked("distance", "tin"), "From the start: how many steps to tin?", "It is 50 steps."),
        (asked("distance", "chair"), "From the start: how many steps to the chair?", "It is 8 steps."),
        (
            asked("direction", "red box", "chair"),
            "From the chair: in which direction is the red box?",
            "It is to the northwest, 315 degrees.",
        ),
        (asked("count", "box"), "How many of these are there: box?", "There are 2."),
        (asked("colour", "red box"), "Which color is the box?", "It is red."),
    ],
)  # fmt: skip
def test_questions_and_right_answers_in_words(question: Asked, text: str, answer: str) -> None:
    words = Words("en")

    assert (question.text(words), question.right_answer(words)) == (text, answer)


@pytest.mark.parametrize(
    ("language", "text"),
    [
        ("pt", "Do ponto de partida: quantos passos até a cadeira?"),
        ("es", "Desde el punto de partida: ¿cuántos pasos hasta la silla?"),
    ],
)
def test_a_thing_in_a_question_has_the_article_of_its_gender(language: str, text: str) -> None:
    assert asked("distance", "chair").text(Words(language)) == text


def test_the_start_is_where_the_robot_was_before_its_first_movement() -> None:
    question = ChallengeQuestion("distance", "red box", "start")

    assert Asked(question, track_of(ROOM, WAY[1:])).right_answer(Words()) == "It is 16 steps."


@pytest.mark.parametrize(
    ("unsensed", "question"),
    [
        (Goal(at="green chair"), "Is the robot there: chair?"),
        (Goal(at=(1, 2)), "Is the robot there: 1, 2?"),
        (Goal(visited=("red box", (3, 4))), "Did the robot come to this place: red box, 3, 4?"),
        (Goal(near="chair"), "Did the robot pass close to: chair?"),
        (Goal(thing="red box", at="chair"), "Is this thing at its place: red box?"),
        (Goal(thing="red box", at=(1, 2)), "Is this thing at its place: red box?"),
        (Goal(holds="blue box"), "Does the robot hold this: blue box?"),
        (Goal(robots=("alice", "bob"), at=(1, 2)), "Did these robots meet: alice, bob?"),
        (Avoided("touch", "red box", 2.0), "Did the robot touch this: red box?"),
        (Avoided("near", "chair", 1.0), "Was it nearer than 1 step: chair?"),
        (Avoided("near", "chair", 2.6), "Was it nearer than 3 steps: chair?"),
    ],
)
def test_a_learner_is_asked_about_what_the_robot_can_not_sense(unsensed: Unsensed, question: str) -> None:
    assert unsensed_question(unsensed, ROOM, Words()) == question
