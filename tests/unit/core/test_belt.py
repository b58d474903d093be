"""The belt follows the events of any robot, and is felt, audible and visible."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from devices.ports.robot import Bearing, Pose
from donnie_tui.core import belt
from donnie_tui.core.belt import (
    OFF,
    BeltDisplay,
    BeltSettings,
    bump,
    in_words,
    levels_by_bearing,
    presence,
    pulse,
    rows,
)
from donnie_tui.core.events import (
    Answered,
    BeltShown,
    CueSounded,
    Event,
    Moved,
    Outcome,
    RunEnded,
    RunStarted,
    Stamped,
)
from donnie_tui.core.hub import Hub
from donnie_tui.core.team import Team
from donnie_tui.i18n.words import Words
from donnie_tui.outlets.belt import BeltAnnouncer, ChosenBelt
from tests.floor import Floor

FRONT_ROW = (0, 0, 0, 3, 0, 0, 0)


def team_of(floor: Floor) -> Team:
    return Team([""], lambda _: floor.session, floor.session.hub._stream)


def shown(floor: Floor) -> list[tuple[int, ...]]:
    return [each.levels for each in floor.events if isinstance(each, BeltShown)]


@pytest.mark.parametrize(
    ("steps", "level"), [(0, 3), (5, 3), (6, 2), (10, 2), (11, 1), (20, 1), (21, 0), (60, 0)]
)
def test_a_nearer_thing_vibrates_more_strongly(steps: int, level: int) -> None:
    assert BeltSettings().level(steps) == level


def test_the_directions_go_round_the_body_from_the_back_over_the_left() -> None:
    order = [Bearing.BACK_LEFT, Bearing.FRONT_LEFT, Bearing.FRONT, Bearing.FRONT_RIGHT, Bearing.BACK_RIGHT]

    assert [pulse(bearing).index(3) for bearing in order] == [1, 2, 3, 4, 5]
    assert pulse(Bearing.BACK) == (3, 0, 0, 0, 0, 0, 3) * 2


def test_directions_that_share_a_column_show_the_stronger_level() -> None:
    settings = BeltSettings(columns=dict.fromkeys(Bearing, (3,)))

    assert presence({Bearing.FRONT: 1, Bearing.BACK: 2}, settings) == (0, 0, 0, 2, 0, 0, 0) * 2


def test_a_bump_is_wide() -> None:
    assert bump(Bearing.FRONT, BeltSettings()) == (0, 0, 3, 3, 3, 0, 0) * 2
    assert bump(Bearing.BACK, BeltSettings()) == (3, 3, 0, 0, 0, 3, 3) * 2


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        ("en", "Belt: front strong, front right weak."),
        ("pt", "Cinto: frente forte, frente direita fraco."),
        ("es", "Cinturón: frente fuerte, frente derecha débil."),
    ],
)
def test_felt_directions_are_described_in_words(language: str, sentence: str) -> None:
    levels = (0, 0, 0, 3, 3, 0, 0, 0, 0, 0, 3, 1, 0, 0)

    assert in_words(levels, Words(language)) == sentence
    assert levels_by_bearing(levels) == {Bearing.FRONT: 3, Bearing.FRONT_RIGHT: 1}
    assert rows(levels) == ((0, 0, 0, 3, 3, 0, 0), (0, 0, 0, 3, 1, 0, 0))


def test_an_empty_belt_is_described_too() -> None:
    assert in_words(OFF, Words()) == "Belt: nothing near."


# --- the display, moment by moment


class Display:
    """A belt whose robot measures what the test says, and what it shows and sounds."""

    def __init__(self) -> None:
        hub, self.heard = Hub(lambda: 0.0), list[Event]()
        self.distances: dict[Bearing, int] = {}
        robot: Any = SimpleNamespace(known_distances=lambda: self.distances)
        self.belt = BeltDisplay(robot, hub, BeltSettings())
        hub.subscribe(lambda stamped: self.heard.append(stamped.event))

    def news(self) -> list[object]:
        """What was shown and sounded since the last question: the upper row and the lower, or a cue."""
        found = [rows(each.levels) if isinstance(each, BeltShown) else each for each in self.heard]
        self.heard.clear()
        return found


NONE, WEAK_AHEAD, MEDIUM_AHEAD = (0,) * 7, (0, 0, 0, 1, 0, 0, 0), (0, 0, 0, 2, 0, 0, 0)


def test_what_comes_a_level_nearer_pulses_in_the_upper_row_and_sounds_at_its_side() -> None:
    display = Display()
    display.distances = {Bearing.FRONT: 20}
    display.belt.update()
    assert display.news() == []

    display.belt.switch(True)
    assert display.news() == [(WEAK_AHEAD, WEAK_AHEAD)]
    display.distances = {Bearing.FRONT: 11}
    display.belt.update()
    assert display.news() == []
    display.distances = {Bearing.FRONT: 10}
    display.belt.update()
    assert display.news() == [
        (FRONT_ROW, MEDIUM_AHEAD),
        CueSounded("belt", 0.0, 10.0),
        (MEDIUM_AHEAD, MEDIUM_AHEAD),
    ]
    display.belt.switch(False)
    assert (display.news(), display.belt.is_on) == ([(NONE, NONE)], False)


@pytest.mark.parametrize(
    ("bearing", "degrees"),
    [
        (Bearing.FRONT, 0.0),
        (Bearing.FRONT_RIGHT, 45.0),
        (Bearing.BACK_RIGHT, 135.0),
        (Bearing.BACK, 180.0),
        (Bearing.BACK_LEFT, -135.0),
        (Bearing.FRONT_LEFT, -45.0),
    ],
)
def test_an_approach_sounds_clockwise_from_the_front_up_to_the_back(bearing: Bearing, degrees: float) -> None:
    """Of two that come nearer it is the one that is nearest."""
    display = Display()
    display.distances = {**dict.fromkeys(Bearing, 20), bearing: 19}
    display.belt.switch(True)
    display.news()
    display.distances = {**dict.fromkeys(Bearing, 10), bearing: 4}
    display.belt.update()

    assert [each for each in display.news() if isinstance(each, CueSounded)] == [
        CueSounded("belt", degrees, 4.0)
    ]


def test_a_bump_is_shown_on_top_of_the_surroundings_while_the_belt_is_on() -> None:
    display = Display()
    display.belt.show_bump(Bearing.FRONT)
    assert display.news() == []

    display.distances = {Bearing.FRONT: 20}
    display.belt.switch(True)
    display.news()
    display.belt.show_bump(Bearing.FRONT)
    wide = (0, 0, 3, 3, 3, 0, 0)
    assert display.news() == [(wide, wide), (WEAK_AHEAD, WEAK_AHEAD)]


def test_a_new_start_forgets_the_surroundings_and_a_rest_stays_on() -> None:
    display = Display()
    display.distances = {Bearing.FRONT: 20}
    display.belt.switch(True)
    display.belt.rest()
    assert display.news() == [(WEAK_AHEAD, WEAK_AHEAD), (NONE, NONE)]
    display.distances = {Bearing.FRONT: 10}
    display.belt.update()
    assert display.news() == [(MEDIUM_AHEAD, MEDIUM_AHEAD)]  # nothing came nearer since

    display.belt.forget()
    assert not display.belt.is_on
    display.distances = {Bearing.FRONT: 4}
    display.belt.update()
    assert display.news() == []
    display.belt.switch(True)
    assert display.news() == [(FRONT_ROW, FRONT_ROW)]


def test_a_pulse_is_where_the_settings_have_that_direction() -> None:
    settings = BeltSettings(columns={**dict.fromkeys(Bearing, (3,)), Bearing.BACK: (0, 5)})

    assert pulse(Bearing.BACK, settings) == (3, 0, 0, 0, 0, 3, 0) * 2


def test_the_belt_follows_the_robot_towards_a_thing() -> None:
    """A thing that is a level nearer strikes the upper row. The lower row shows how near it is."""
    floor = Floor(("red", 0, 23))
    floor.run("BELT ON FW 19")

    row = {level: (0, 0, 0, level, 0, 0, 0) for level in range(4)}
    assert shown(floor) == [
        row[3] + row[1],
        row[1] * 2,
        row[3] + row[2],
        row[2] * 2,
        row[3] * 2,
        OFF,
    ]


def test_an_approaching_thing_is_sounded_on_its_side() -> None:
    floor = Floor(("red", 0, 23))
    floor.run("BELT ON FW 5")

    assert [each for each in floor.events if isinstance(each, CueSounded) and each.name == "belt"] == [
        CueSounded("belt", 0.0, 20.0)
    ]


def test_a_turn_moves_the_felt_directions_round_the_body() -> None:
    floor = Floor(("red", 0, 4))
    floor.run("BELT ON TR 45")

    assert shown(floor)[0] == FRONT_ROW * 2
    assert shown(floor)[-2] == pulse(Bearing.FRONT_LEFT)


def test_a_belt_that_is_off_feels_nothing() -> None:
    floor = Floor(("red", 0, 4))
    floor.run("FW 2 TR 90")

    assert shown(floor) == []


def test_belt_off_is_off_at_once() -> None:
    floor = Floor(("red", 0, 4))
    floor.run("BELT ON BELT OFF FW 1")

    assert shown(floor) == [FRONT_ROW * 2, OFF]


def test_after_a_pulse_the_belt_shows_the_directions_again() -> None:
    floor = Floor(("red", 0, 4))
    floor.run("BELT ON VIBRATE BL")

    assert shown(floor) == [FRONT_ROW * 2, pulse(Bearing.BACK_LEFT), FRONT_ROW * 2, OFF]


def test_the_belt_does_not_change_the_noisy_readings_of_a_program() -> None:
    """The belt takes nothing from the random source of the program's readings."""

    def happened(switched: str) -> list[Event]:
        floor = Floor(("red", 0, 30), ("blue", 25, 9), noise=0.5, seed=7)
        floor.run(f"BELT {switched} REPEAT 4 TIMES FW 2 TR 30 SPEAK DISTANCE F SPEAK DISTANCE FR END REPEAT")
        return [
            each
            for each in floor.events
            if not isinstance(each, RunStarted | BeltShown) and getattr(each, "code", "") != "belt"
            if not (isinstance(each, CueSounded) and each.name == "belt")
        ]

    assert happened("ON") == happened("OFF")


def test_a_stop_during_a_walk_counts_with_the_belt_on() -> None:
    floor = Floor(("red", 0, 900))
    floor.session.hub.subscribe(
        lambda it: floor.session.stop() if it.event == CueSounded("step-forward", 0.0, None) else None
    )
    floor.run("BELT ON FW 500")

    assert [each.walked for each in floor.events if isinstance(each, Moved)] == [1]


@pytest.mark.parametrize("program", ["BELT ON FW 1", "BELT ON SPEAK q", "BELT ON QUIT", "BELT ON FW 1 / 0"])
def test_the_motors_are_off_before_the_end_of_a_run_is_published(program: str) -> None:
    floor = Floor(("red", 0, 4), terminal=True)
    floor.run(program)

    assert isinstance(floor.events[-1], RunEnded)
    assert shown(floor)[-1] == OFF


def test_the_belt_stays_switched_on_for_the_next_lines_of_a_terminal() -> None:
    floor = Floor(("red", 0, 9), terminal=True)
    floor.run("BELT ON")
    floor.stream.clear()
    floor.run("FW 1")

    assert next(each for each in floor.events if isinstance(each, BeltShown | Moved)) == BeltShown(
        (0, 0, 0, belt.MEDIUM, 0, 0, 0) * 2
    )


def test_changes_of_the_belt_are_announced_in_words_on_request() -> None:
    floor = Floor(("red", 0, 22))
    BeltAnnouncer(team_of(floor), floor.words).is_on = True
    floor.run("BELT ON FW 3 FW 2")

    assert [line for line in floor.printed if line.startswith("Belt:")] == [
        "Belt: front weak.",
        "Belt: nothing near.",
    ]


def test_the_words_follow_the_columns_of_the_settings() -> None:
    settings = BeltSettings(columns=dict.fromkeys(Bearing, ()) | {Bearing.BACK: (3,)})

    assert in_words(presence({Bearing.BACK: 2}, settings), Words(), settings) == "Belt: back medium."


def test_one_question_describes_the_belt_without_announcing_each_change() -> None:
    floor = Floor(("red", 0, 4))
    announcer = BeltAnnouncer(team_of(floor), floor.words)
    during = list[str]()
    floor.session.hub.subscribe(
        lambda stamped: during.append(announcer.now()) if isinstance(stamped.event, Moved) else None
    )
    floor.run("BELT ON FW 1")

    assert during == ["Belt: front strong."]
    assert announcer.now() == "Belt: nothing near."
    assert not [line for line in floor.printed if line.startswith("Belt:")]


def test_the_belt_follows_only_the_selected_robot() -> None:
    chosen, felt = ["alice"], list[tuple[int, ...]]()
    watching = ChosenBelt(lambda: chosen[0], felt.append)
    strong, weak = pulse(Bearing.FRONT), (1,) * 14
    watching(Stamped(1, 0.0, BeltShown(strong), "alice"))
    watching(Stamped(2, 0.0, BeltShown(weak), "bob"))
    chosen[0] = "bob"
    watching(Stamped(3, 0.0, Answered("Now you talk to bob."), None))
    watching(Stamped(4, 0.0, RunEnded(Outcome.STOPPED, Pose(0, 0, 0), {}, 1.0), "bob"))

    assert felt == [strong, weak, OFF]


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", ("Belt: front strong.", "Upper row: 0 0 0 3 0 0 0.", "Lower row: 0 0 0 3 0 0 0.")),
        (
            "pt",
            ("Cinto: frente forte.", "Fileira de cima: 0 0 0 3 0 0 0.", "Fileira de baixo: 0 0 0 3 0 0 0."),
        ),
        (
            "es",
            ("Cinturón: frente fuerte.", "Fila de arriba: 0 0 0 3 0 0 0.", "Fila de abajo: 0 0 0 3 0 0 0."),
        ),
    ],
)
def test_each_motor_of_both_rows_can_be_described(language: str, said: tuple[str, ...]) -> None:
    floor = Floor()
    announcer = BeltAnnouncer(team_of(floor), Words(language))
    floor.session.hub.publish(BeltShown(FRONT_ROW + FRONT_ROW))

    assert announcer.rows() == said
