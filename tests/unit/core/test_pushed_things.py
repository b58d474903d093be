"""A pushed thing is announced with its name in the learner's language and an agreeing colour."""

from functools import partial
from pathlib import Path

import pytest

from donnie_tui.core.events import Announced
from donnie_tui.core.session import Session, SessionSetup
from donnie_tui.core.transcript import printed_lines
from donnie_tui.core.wording import coloured, shade
from donnie_tui.i18n.words import Words
from sim.picture import Thing
from sim.world import World
from sim.worldfile import load_text
from tests.timeouts import TIMEOUT

ROBOT = 'position( name "pusher" size [ 0.1 0.1 0.1 ] pose [ 0 0 0 90 ] )\n'
THING = '{kind}( name "{kind}{i}" pose [ 0 {y} 0 0 ] color "{colour}" )\n'


def push_announcements(
    words: Words, kind: str, *, count: int = 1, colour: str = "red", steps: int = 6
) -> list[str]:
    """The announcements of a robot that pushes things, which stand in a row from the fourth step on."""
    made = f"define {kind} model ( size [ 0.1 0.1 0.3 ] pushable 1 )\n"
    things = "".join(THING.format(kind=kind, i=i, y=0.2 + 0.1 * i, colour=colour) for i in range(count))
    world = World(load_text(made + ROBOT + things, Path("room.world")))
    session = Session(
        lambda pace, watcher: partial(world.robot, pace=pace, watcher=watcher)(),
        words,
        SessionSetup("room", seed=0, terminal=False),
    )
    lines: list[str] = []

    def remember(stamped: object) -> None:
        if isinstance(getattr(stamped, "event", None), Announced) and stamped.event.code == "pushed":  # type: ignore[attr-defined]
            lines.extend(printed_lines(stamped, words))  # type: ignore[arg-type]

    session.hub.subscribe(remember)
    assert session.start(f"FW {steps}", "a.gd").wait(TIMEOUT)
    return lines


@pytest.mark.parametrize("detail", ["normal", "full"])
def test_a_pushed_thing_is_announced_with_its_colour_and_its_distance(detail: str) -> None:
    assert push_announcements(Words("en", detail), "box") == ["I pushed the red box 4 steps."]


@pytest.mark.parametrize(
    ("language", "sentence"),
    [("pt", "Empurrei a caixa vermelha 4 passos."), ("es", "Empujé la caja roja 4 pasos.")],
)
def test_the_colour_agrees_with_the_noun(language: str, sentence: str) -> None:
    assert push_announcements(Words(language), "box") == [sentence]


@pytest.mark.parametrize(
    ("language", "sentence"),
    [("pt", "Empurrei puck0 de cor vermelha 4 passos."), ("es", "Empujé puck0 de color rojo 4 pasos.")],
)
def test_a_foreign_noun_has_a_phrase_without_gender(language: str, sentence: str) -> None:
    assert push_announcements(Words(language), "puck") == [sentence]


def test_detail_brief_announces_no_pushed_thing() -> None:
    assert push_announcements(Words("en", "brief"), "box") == []


def test_a_walk_that_ends_before_the_thing_announces_nothing() -> None:
    assert push_announcements(Words(), "box", steps=2) == []


def test_the_first_of_many_pushed_things_are_named_and_the_others_counted() -> None:
    lines = push_announcements(Words(), "cone", count=5, colour="blue", steps=3)

    assert lines[0] == "I pushed the blue cone 1 step."
    assert lines[-1] == "I pushed 2 more things."
    assert len(lines) == 4


@pytest.mark.parametrize(
    ("kind", "language", "phrase"),
    [
        ("table", "pt", "mesa amarela"),
        ("table", "es", "mesa amarilla"),
        ("carton", "pt", "caixinha de suco amarela"),
        ("carton", "es", "cartón de zumo amarillo"),
        ("table", "en", "table, yellow"),
    ],
)
def test_a_listed_thing_has_an_agreeing_colour(kind: str, language: str, phrase: str) -> None:
    assert coloured(kind, "", "yellow", Words(language)) == phrase


def test_an_orange_is_not_called_orange_twice() -> None:
    assert [coloured("orange", "", "orange", Words(each)) for each in ("en", "pt")] == ["orange", "laranja"]
    assert push_announcements(Words("es"), "orange", colour="orange") == ["Empujé la naranja 4 pasos."]


def test_a_colour_alone_agrees_with_its_thing() -> None:
    chair = Thing("", "chair", "c", "red", 0, 0, 1, 1)

    assert [shade(chair, Words(language)) for language in ("en", "pt", "es")] == ["red", "vermelha", "roja"]
