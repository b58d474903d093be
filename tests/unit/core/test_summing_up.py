"""L34: what is told while the robot moves faster than anybody can listen."""

import pytest

from devices.ports.robot import Pose, StoppedBy
from donnie_tui.core.events import (
    Announced,
    CueSounded,
    Event,
    Moved,
    Outcome,
    RunEnded,
    Spoke,
    Stamped,
    Turned,
)
from donnie_tui.core.transcript import SummingUp, told_lines
from donnie_tui.i18n.words import Words

HERE = Pose(0, 0, 0)
END = RunEnded(Outcome.COMPLETED, HERE, {}, 0.0)


class Listener:
    """Prints what is told, at a time that the test chooses."""

    def __init__(self, language: str = "en", *, has_pace: bool = True) -> None:
        self.now, self.printed, self.has_pace = 0.0, list[str](), has_pace
        self._words = Words(language)
        self._summing_up = SummingUp(self._words, lambda: self.now, lambda: self.has_pace)

    def hear(self, *events: Event, robot: str | None = None) -> None:
        for each in events:
            stamped = Stamped(1, 0.0, each, robot)
            self.printed += self._summing_up.before(stamped)
            if self._summing_up.passes(stamped):
                self.printed += told_lines(stamped, self._words)


def walk(steps: int = 1, by: StoppedBy | None = None) -> tuple[Event, Event]:
    return Moved(f"FW {steps}", steps, steps, by, HERE, True), Announced("moved", f"Walked {steps}.")


def turn() -> tuple[Event, Event]:
    return Turned("TR 90", 90, 90, None, HERE, True), Announced("turned", "Turned.")


def test_four_movements_are_told_in_a_second_and_the_others_are_summed_up_at_the_end() -> None:
    listener = Listener()
    for _ in range(16):
        listener.hear(*walk())
    listener.hear(END)

    assert listener.printed == ["Walked 1."] * 4 + ["12 more steps."]


@pytest.mark.parametrize(
    ("language", "told"),
    [
        ("en", "3 more steps, 1 turn."),
        ("pt", "Mais 3 passos, 1 giro."),
        ("es", "3 pasos y 1 giro más."),
    ],
)
def test_steps_and_turns_are_summed_up_in_each_language(language: str, told: str) -> None:
    listener = Listener(language)
    for _ in range(4):
        listener.hear(*turn())
    listener.hear(*walk(2), *turn(), *walk(1), END)

    assert listener.printed[4:] == [told]


def test_turns_alone_are_counted() -> None:
    listener = Listener()
    for _ in range(6):
        listener.hear(*turn())
    listener.hear(END)

    assert listener.printed[4:] == ["2 more turns."]


def test_one_movement_is_told_as_it_was() -> None:
    listener = Listener()
    for steps in range(5):
        listener.hear(*walk(steps))
    listener.hear(END)

    assert listener.printed[-1] == "Walked 4."


def test_at_no_time_more_than_four_lines_are_told_in_a_second() -> None:
    listener, told_at = Listener(), list[float]()
    for number in range(400):
        listener.now = number / 16
        listener.hear(*walk())
        told_at += [listener.now] * (len(listener.printed) - len(told_at))

    assert all(later - earlier >= 1.0 for earlier, later in zip(told_at, told_at[4:], strict=False))
    assert len(told_at) > 80


def test_every_step_is_told_once_be_it_in_a_sum() -> None:
    listener = Listener()
    for number in range(97):
        listener.now = number / 11
        listener.hear(*walk())
    listener.hear(END)
    told = [int("".join(filter(str.isdigit, line))) for line in listener.printed]

    assert sum(told) == 97


@pytest.mark.parametrize(
    "news",
    [
        (Spoke("Wall!"),),
        (Announced("scan", "I see no objects."),),
        walk(1, StoppedBy.OBSTACLE),
        (Announced("hint", "X existed already."),),
    ],
    ids=["speak", "scan", "obstacle", "hint"],
)
def test_news_are_told_always_and_after_what_was_before_them(news: tuple[Event, ...]) -> None:
    listener = Listener()
    for _ in range(6):
        listener.hear(*walk())
    listener.hear(*news)
    listener.hear(*news)
    text = news[-1].text  # type: ignore[union-attr] # all of them have one

    assert listener.printed[4:] == ["2 more steps.", text, text]


def test_what_was_not_told_is_summed_up_as_soon_as_there_is_time() -> None:
    """Each step of a long walk sounds; no line has to come first."""
    listener = Listener()
    for _ in range(7):
        listener.hear(*walk())
    listener.now = 1.0
    listener.hear(CueSounded("step-forward", 0.0, None))

    assert listener.printed[4:] == ["3 more steps."]


def test_where_the_last_movement_led_is_told_with_the_sum() -> None:
    listener = Listener()
    for number in range(5):
        listener.hear(*walk(), Announced("moved", f"Position 0, {number}."))
    listener.hear(END)

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
        listener.hear(*walk(), robot="Ana")
        listener.hear(*walk(), robot="Bob")
    listener.hear(END, robot="Ana")

    assert listener.printed[4:] == ["Ana: 2 more steps.", "Bob: 2 more steps."]


def test_without_a_pace_every_line_is_told() -> None:
    listener = Listener(has_pace=False)
    for _ in range(100):
        listener.hear(*walk())

    assert listener.printed == ["Walked 1."] * 100


def test_what_was_not_told_is_summed_up_when_the_speed_becomes_unlimited() -> None:
    listener = Listener()
    for _ in range(6):
        listener.hear(*walk())
    listener.has_pace = False
    listener.hear(*walk())

    assert listener.printed[4:] == ["2 more steps.", "Walked 1."]


def test_all_who_ask_about_an_event_get_the_same_answer() -> None:
    """The voice says what is printed."""
    summing_up = SummingUp(Words("en"), lambda: 0.0, lambda: True)
    for event in [each for _ in range(6) for each in walk()]:
        stamped = Stamped(1, 0.0, event)
        asked = [(summing_up.before(stamped), summing_up.passes(stamped)) for _ in range(3)]

        assert len(set(asked)) == 1
