"""What is printed while the robot moves faster than a learner can listen."""

from collections.abc import Callable

import pytest

from devices.ports.robot import Pose, StoppedBy
from donnie_tui.core.events import (
    Announced,
    CueSounded,
    Error,
    Event,
    Moved,
    Outcome,
    RunEnded,
    RunStarted,
    Spoke,
    Stamped,
    Turned,
)
from donnie_tui.core.transcript import SummaryFilter, printed_lines
from donnie_tui.i18n.words import Words

HERE = Pose(0, 0, 0)
END = RunEnded(Outcome.COMPLETED, HERE, {}, 0.0)
STARTED = RunStarted("a.gd", "floor", "donnie", 0, "1")


class Listener:
    """Prints the lines of events at a time that the test chooses."""

    def __init__(
        self, language: str = "en", *, has_pace: bool = True, is_known: Callable[[Error], bool] | None = None
    ) -> None:
        self.now, self.printed, self.has_pace = 0.0, list[str](), has_pace
        self._words = Words(language)
        known = {} if is_known is None else {"is_known": is_known}
        self._summing_up = SummaryFilter(self._words, lambda: self.now, lambda: self.has_pace, **known)

    def receive(self, *events: Event, robot: str | None = None) -> None:
        for each in events:
            stamped = Stamped(1, 0.0, each, robot)
            self.printed += self._summing_up.before(stamped)
            if self._summing_up.passes(stamped):
                self.printed += printed_lines(stamped, self._words)


def walk(steps: int = 1, by: StoppedBy | None = None) -> tuple[Event, Event]:
    return Moved(f"FW {steps}", steps, steps, by, HERE, True), Announced("moved", f"Walked {steps}.")


def turn() -> tuple[Event, Event]:
    return Turned("TR 90", 90, 90, None, HERE, True), Announced("turned", "Turned.")


def test_four_movements_a_second_are_printed_and_the_others_summed_up_at_the_end() -> None:
    listener = Listener()
    for _ in range(16):
        listener.receive(*walk())
    listener.receive(END)

    assert listener.printed == ["Walked 1."] * 4 + ["12 more steps."]


def test_a_movement_is_printed_when_it_ends_if_there_is_time() -> None:
    listener = Listener()
    for number in range(5):
        listener.now = 0.25 * number
        listener.receive(*walk(number))
        assert listener.printed[-1] == f"Walked {number}."


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "3 more steps, 1 turn."),
        ("pt", "Mais 3 passos, 1 giro."),
        ("es", "3 pasos y 1 giro más."),
    ],
)
def test_steps_and_turns_are_summed_up_in_each_language(language: str, said: str) -> None:
    listener = Listener(language)
    for _ in range(4):
        listener.receive(*turn())
    listener.receive(*walk(2), *turn(), *walk(1), END)

    assert listener.printed[4:] == [said]


def test_a_known_mistake_is_not_printed_again_but_what_was_before_it_is() -> None:
    known, new = (Error("syntax", line, 1, "Wrong.", None) for line in (1, 2))
    listener = Listener(is_known=lambda error: error == known)
    for steps in range(6):
        listener.receive(*walk(steps))
    listener.receive(known, new, Spoke("so"))
    other = Listener(is_known=lambda _: True)
    other.receive(known, Spoke("so"))

    walked = [f"Walked {steps}." for steps in range(4)]
    assert listener.printed == [*walked, "9 more steps.", "Error, line 2, column 1: Wrong.", "so"]
    assert other.printed == ["so"]
    unfiltered = Listener()
    unfiltered.receive(known)
    assert unfiltered.printed == ["Error, line 1, column 1: Wrong."]


@pytest.mark.parametrize("is_new_run", [True, False])
def test_words_of_an_earlier_run_delay_no_sum(is_new_run: bool) -> None:
    listener = Listener()
    listener.receive(Spoke("so"), END, *([STARTED] if is_new_run else []))
    for steps in range(5):
        listener.receive(*walk(steps))
    listener.now = 2.0
    listener.receive(CueSounded("bump", 0.0, None))

    sums = ["7 more steps."] if is_new_run else []
    assert listener.printed == ["so", *(f"Walked {steps}." for steps in range(3)), *sums]


@pytest.mark.parametrize("place", [(), (Announced("moved", "At 0, 9."),)])
def test_a_place_is_that_of_the_last_movement_and_no_movement_of_its_own(place: tuple[Event, ...]) -> None:
    """The fourth movement is printed, its place is not: there is no room, and then it is over."""
    listener = Listener()
    for steps in range(1, 5):
        listener.receive(*walk(steps))
    listener.receive(Announced("moved", "At 0, 4."), *walk(5), *place, END)

    assert listener.printed[4:] == ["Walked 5.", *(["At 0, 9."] if place else [])]


def test_a_place_that_had_no_room_is_printed_at_the_end() -> None:
    listener = Listener()
    for steps in range(1, 5):
        listener.receive(*walk(steps))
    listener.receive(Announced("moved", "At 0, 4."), END)

    assert listener.printed[4:] == ["At 0, 4."]


def test_turns_alone_are_counted() -> None:
    listener = Listener()
    for _ in range(6):
        listener.receive(*turn())
    listener.receive(END)

    assert listener.printed[4:] == ["2 more turns."]


def test_a_sum_of_one_movement_is_its_sentence() -> None:
    listener = Listener()
    for steps in range(5):
        listener.receive(*walk(steps))
    listener.receive(END)

    assert listener.printed[-1] == "Walked 4."


def test_no_second_has_more_than_four_lines() -> None:
    listener, told_at = Listener(), list[float]()
    for number in range(400):
        listener.now = number / 16
        listener.receive(*walk())
        told_at += [listener.now] * (len(listener.printed) - len(told_at))

    assert all(later - earlier >= 1.0 for earlier, later in zip(told_at, told_at[4:], strict=False))
    assert len(told_at) > 80


def test_every_step_is_printed_once_or_counted_in_a_sum() -> None:
    listener = Listener()
    for number in range(97):
        listener.now = number / 11
        listener.receive(*walk())
    listener.receive(END)
    said = [int("".join(filter(str.isdigit, line))) for line in listener.printed]

    assert sum(said) == 97


@pytest.mark.parametrize(
    "news",
    [
        (Announced("scan", "I see no objects."),),
        walk(1, StoppedBy.OBSTACLE),
        (Announced("hint", "X had a value. It has a new one now."),),
    ],
    ids=["scan", "obstacle", "hint"],
)
def test_other_events_are_always_printed_after_the_sum_of_earlier_movements(news: tuple[Event, ...]) -> None:
    listener = Listener()
    for _ in range(6):
        listener.receive(*walk())
    listener.receive(*news)
    listener.receive(*news)
    text = news[-1].text  # type: ignore[union-attr] # all of them have one

    assert listener.printed[4:] == ["2 more steps.", text, text]


def test_nothing_comes_between_the_words_of_a_program_but_the_sum_at_its_end() -> None:
    listener = Listener()
    for _ in range(6):
        listener.receive(*walk())
    listener.receive(Spoke("Wall!"))
    listener.receive(*walk())
    listener.now = 5.0
    listener.receive(CueSounded("step-forward", 0.0, None))
    listener.receive(Spoke("Wall!"), END)

    assert listener.printed[4:] == ["Wall!", "Wall!", "3 more steps."]


def test_a_movement_of_a_program_that_speaks_is_printed_after_those_before_it() -> None:
    listener = Listener()
    listener.receive(Spoke("Go!"), *walk(), *walk(), *walk(), *turn())
    listener.now = 2.0
    listener.receive(*walk(4), END)

    assert listener.printed == ["Go!", "Walked 1.", "Walked 1.", "Walked 1.", "Turned.", "Walked 4."]


def test_unprinted_movements_are_summed_up_as_soon_as_there_is_time() -> None:
    """Each step of a long walk sounds. No line has to be printed first."""
    listener = Listener()
    for _ in range(7):
        listener.receive(*walk())
    listener.now = 1.0
    listener.receive(CueSounded("step-forward", 0.0, None))

    assert listener.printed[4:] == ["3 more steps."]


def test_the_sum_has_the_place_after_the_last_movement() -> None:
    listener = Listener()
    for number in range(5):
        listener.receive(*walk(), Announced("moved", f"Position 0, {number}."))
    listener.receive(END)

    assert listener.printed == [
        "Walked 1.",
        "Position 0, 0.",
        "Walked 1.",
        "Position 0, 1.",
        "3 more steps.",
        "Position 0, 4.",
    ]


def test_each_robot_has_its_own_sum() -> None:
    listener = Listener()
    for _ in range(4):
        listener.receive(*walk(), robot="Ana")
        listener.receive(*walk(), robot="Bob")
    listener.receive(END, robot="Ana")

    assert listener.printed[4:] == ["Ana: 2 more steps.", "Bob: 2 more steps."]


def test_every_line_is_printed_without_a_pace() -> None:
    listener = Listener(has_pace=False)
    for _ in range(100):
        listener.receive(*walk())

    assert listener.printed == ["Walked 1."] * 100


def test_unprinted_movements_are_summed_up_when_the_speed_becomes_unlimited() -> None:
    listener = Listener()
    for _ in range(6):
        listener.receive(*walk())
    listener.has_pace = False
    listener.receive(*walk())

    assert listener.printed[4:] == ["2 more steps.", "Walked 1."]


def test_every_listener_gets_the_same_answer_about_an_event() -> None:
    """The voice says what is printed."""
    summing_up = SummaryFilter(Words("en"), lambda: 0.0, lambda: True)
    for event in [each for _ in range(6) for each in walk()]:
        stamped = Stamped(1, 0.0, event)
        asked = [(summing_up.before(stamped), summing_up.passes(stamped)) for _ in range(3)]

        assert len(set(asked)) == 1
