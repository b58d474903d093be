"""Poses, everyday words, robots and things in words: whole numbers, eight directions, articles that agree."""

from string import ascii_lowercase
from types import SimpleNamespace
from typing import Any

import pytest

from devices.ports.robot import Pose
from donnie_tui.core import wording
from donnie_tui.core.wording import (
    all_of,
    called,
    colour_initials,
    coloured,
    coloured_thing,
    compass_heading,
    compass_point,
    facing,
    keys_of,
    language_named,
    letters_of_several_colours,
    meant,
    name_of,
    name_of_language,
    no_such_robot,
    own_name,
    position_in_words,
    robot_called,
    shade,
    shown_name,
    specific_name_of,
    spelled,
    the_coloured,
    whole_steps,
    with_colour,
)
from donnie_tui.i18n.words import Words

EN, PT, ES = Words("en"), Words("pt"), Words("es")


# --- poses


@pytest.mark.parametrize(
    ("value", "whole"),
    [(2.9, 2), (-2.9, -2), (2.999999, 2), (2.9999996, 3), (-0.9999996, -1), (0.0, 0), (3.0, 3)],
)
def test_a_length_is_cut_towards_zero_unless_it_is_a_whole_one_but_for_a_millionth(
    value: float, whole: int
) -> None:
    assert whole_steps(value) == whole


@pytest.mark.parametrize(
    ("heading", "degrees"), [(0, 0), (359.9, 359), (360, 0), (359.9999999, 0), (-90, 270), (45.5, 45)]
)
def test_a_heading_is_from_0_to_359(heading: float, degrees: int) -> None:
    assert compass_heading(Pose(0, 0, heading)) == degrees


@pytest.mark.parametrize(
    ("degrees", "point"),
    [
        (0, "north"), (22, "north"), (23, "northeast"), (45, "northeast"), (90, "east"), (135, "southeast"),
        (180, "south"), (225, "southwest"), (270, "west"), (315, "northwest"), (337, "northwest"),
        (338, "north"), (359, "north"), (-45, "northwest"),
    ],
)  # fmt: skip
def test_a_direction_is_the_nearest_point_of_the_compass(degrees: float, point: str) -> None:
    assert compass_point(degrees, EN) == point


@pytest.mark.parametrize(
    ("heading", "said"),
    [
        (0, "north"), (45, "northeast"), (44, "44 degrees, near northeast"),
        (46, "46 degrees, near northeast"), (1, "1 degree, near north"),
        (359, "359 degrees, near north"), (315.4, "northwest"),
    ],
)  # fmt: skip
def test_a_robot_faces_a_point_of_the_compass_exactly_or_nearly(heading: float, said: str) -> None:
    assert facing(Pose(0, 0, heading), EN) == said
    assert position_in_words(Pose(2.7, -3.2, heading), EN) == f"Position 2, -3. Facing {said}."


# --- everyday words


def test_an_everyday_word_of_any_language_has_one_meaning() -> None:
    assert [spelled("north", each, "compass") for each in ("en", "pt", "es")] == ["north", "norte", "norte"]
    for typed in ("north", " NORTE ", "n"):
        assert meant(typed, "compass") == "north"
    assert meant("North  East", "compass") is None
    assert meant("north", "answers") is None
    assert meant("", "compass") is None
    assert keys_of("answers") == ("yes", "no")
    assert meant("PAGE   up", "keyboard") == "pageup"


@pytest.mark.parametrize(
    ("language", "spoken", "name"),
    [("pt", "en", "Portuguese"), ("en", "pt", "inglês"), ("en", "en", "English"), ("es", "es", "español")],
)
def test_a_language_has_a_name_in_each_language(language: str, spoken: str, name: str) -> None:
    assert name_of_language(language, spoken) == name


@pytest.mark.parametrize(
    ("names", "name"),
    [
        ({"pt": "ixo", "xx": "Xx", "en": "Ixish"}, "ixo"),
        ({"xx": "Xx", "en": "Ixish"}, "Xx"),
        ({"en": "Ixish"}, "Ixish"),
        ({}, "xx"),
    ],
)
def test_a_language_without_a_name_in_another_has_its_own_or_the_english_one_or_its_code(
    names: dict[str, str], name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    known = {("xx", spoken): (each, "other") for spoken, each in names.items()}
    monkeypatch.setattr(wording, "names_of", lambda *asked: known.get(asked, ()))

    assert name_of_language("xx", "pt") == name


@pytest.mark.parametrize(
    ("typed", "language"),
    [
        ("Português", "pt"),
        (" PORTUGUES ", "pt"),
        ("inglês", "en"),
        ("pt_BR", "pt"),
        (" es ", "es"),
        ("x", None),
    ],
)
def test_a_language_is_meant_by_its_name_in_any_language_or_by_a_code(
    typed: str, language: str | None
) -> None:
    assert language_named(typed) == language


# --- robots


@pytest.mark.parametrize(("robot", "shown"), [("donnie", ""), ("Donnie", ""), ("bob", "bob"), ("", "")])
def test_the_usual_robot_needs_no_name_on_the_map(robot: str, shown: str) -> None:
    assert shown_name(robot) == shown


@pytest.mark.parametrize(
    ("typed", "robot"), [("Ana", "Ana"), ("ana", "ANA"), ("joao", "João"), ("JOÃO", "João"), ("bob", None)]
)
def test_a_robot_is_called_by_its_exact_name_first(typed: str, robot: str | None) -> None:
    assert robot_called(typed, ("ANA", "Ana", "João")) == robot


def test_that_there_is_no_such_robot_names_the_first_ones() -> None:
    names = ("alice", "bob", "carol")
    assert no_such_robot("x" * 41, names[:1], 2, EN) == f"There is no robot {'x' * 39}… here. There is alice."
    assert no_such_robot("x", names, 3, EN) == "There is no robot x here. There are alice, bob and carol."
    assert (
        no_such_robot("x", names, 2, EN)
        == "There is no robot x here. There are alice, bob and \N{HORIZONTAL ELLIPSIS}."
    )


@pytest.mark.parametrize(
    ("names", "said"),
    [
        ((), ""),
        (("ana",), "ana"),
        (("ana", "bob"), "ana y bob"),
        (("ana", "bob", "carol"), "ana, bob y carol"),
        (("ana", "Inés"), "ana e Inés"),
        (("ana", "íñigo"), "ana e íñigo"),
        (("ana", "Hilda"), "ana e Hilda"),
        (("ana", "Híspalis"), "ana e Híspalis"),
        (("Inés", "ana"), "Inés y ana"),
    ],
)
def test_names_are_listed_as_the_language_does_before_an_i(names: tuple[str, ...], said: str) -> None:
    assert all_of(names, ES) == said


# --- things


def thing(
    kind: str = "box", name: str = "", colour: str = "red", *, letter: str = "b", robot: bool = False
) -> Any:
    return SimpleNamespace(kind=kind, name=name, colour=colour, letter=letter, is_robot=robot)


@pytest.mark.parametrize(
    ("found", "name", "specific", "listed"),
    [
        (thing(), "caixa", "caixa", "caixa vermelha"),
        (thing(name="tesouro"), "caixa", "tesouro", "tesouro, caixa vermelha"),
        (thing(name="box 3"), "caixa", "caixa", "caixa vermelha"),
        (thing("puck", "p7"), "p7", "p7", "p7 de cor vermelha"),
        (thing("puck"), "puck", "puck", "puck de cor vermelha"),
        (thing("donnie", "bob", robot=True), "bob", "bob", "bob de cor vermelha"),
        (thing("donnie", robot=True), "donnie", "donnie", "donnie de cor vermelha"),
        (thing("box", "bob", robot=True), "bob", "bob", "bob de cor vermelha"),
        (thing("box", robot=True), "caixa", "caixa", "caixa vermelha"),
    ],
)
def test_a_thing_has_its_kind_or_name_and_a_robot_its_name(
    found: Any, name: str, specific: str, listed: str
) -> None:
    assert (name_of(found, PT), specific_name_of(found, PT), coloured_thing(found, PT)) == (
        *(name, specific, listed),
    )


@pytest.mark.parametrize(
    ("words", "kind", "colour", "listed", "the", "plain"),
    [
        (EN, "box", "red", "box, red", "the red box", "red box"),
        (PT, "box", "red", "caixa vermelha", "a caixa vermelha", "caixa vermelha"),
        (PT, "cone", "red", "cone vermelho", "o cone vermelho", "cone vermelho"),
        (ES, "box", "yellow", "caja amarilla", "la caja amarilla", "caja amarilla"),
        (PT, "orange", "orange", "laranja", "a laranja", "laranja"),
        (EN, "puck", "red", "puck, red", "puck of color red", "puck of color red"),
        (ES, "puck", "red", "puck de color rojo", "puck de color rojo", "puck de color rojo"),
    ],
)
def test_colour_and_article_agree_with_the_thing(
    words: Words, kind: str, colour: str, listed: str, the: str, plain: str
) -> None:
    assert coloured(kind, "", colour, words) == listed
    assert the_coloured(kind, "", colour, words) == the
    assert with_colour(kind, "", colour, words) == plain
    if kind != "puck":
        assert the_coloured(kind, "gold", colour, words) == f"gold, {the}"


def test_a_thing_is_called_by_its_kind_else_by_its_name() -> None:
    assert [called(*each, PT) for each in (("box", "gold"), ("puck", "gold"), ("puck", ""))] == [
        *("caixa", "gold", "puck"),
    ]
    assert [own_name(*each, PT) for each in (("puck", "gold"), ("box", ""), ("box", "caixa rosa"))] == [
        ""
    ] * 3
    assert own_name("box", "caixa do rei", PT) == "caixa do rei"


@pytest.mark.parametrize(
    ("found", "said"),
    [
        (thing(), "vermelha"),
        (thing("cone"), "vermelho"),
        (thing("puck"), "vermelho"),
        (thing("box", robot=True), "vermelho"),
    ],
)
def test_a_shade_agrees_with_its_thing_or_is_masculine(found: Any, said: str) -> None:
    assert shade(found, PT) == said


def test_each_colour_has_a_letter_of_its_own() -> None:
    plain = colour_initials(EN)
    assert (plain["red"], plain["green"], plain["blue"], plain["gray"]) == ("R", "G", "B", "A")
    taken = colour_initials(EN, "rgb")
    assert (taken["red"], taken["green"]) == ("E", "N")
    assert not {*taken.values()} & {*"RGB"}
    assert len({*plain.values()}) == len({*taken.values()}) == len(plain)
    assert [colour_initials(EN, ascii_lowercase)[each] for each in ("red", "blue")] == ["R", "B"]  # none left


def test_letters_stand_for_several_colours_where_the_things_differ() -> None:
    things = [thing(), thing(colour="blue"), thing(letter="c"), thing(letter="c")]
    robots = [thing(letter="d", robot=True), thing(letter="d", colour="blue", robot=True)]

    assert letters_of_several_colours([*things, *robots]) == {"b"}
