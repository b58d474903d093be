"""Slips in a world file of one's own are told when it is loaded, a robot in a thing in so many words."""

from pathlib import Path

import pytest

import worlds
from donnie_tui.bootstrap import assemble
from donnie_tui.i18n.words import Words
from donnie_tui.settings.chosen import Settings
from donnie_tui.world.choice import choose_world
from donnie_tui.world.remarks import remarks
from tests.sessions import command

HEAD = 'include "donnie.inc"\ninclude "things.inc"\n'
ANA = 'donnie( name "Ana" pose [ 0 0 0 90 ] )\n'


def remarks_on(folder: Path, text: str, language: str = "en") -> tuple[str, ...]:
    file = folder / "my.world"
    file.write_text(HEAD + text, encoding="utf-8")
    words = Words(language)
    return tuple(
        each.replace(str(file), "my.world") for each in remarks(choose_world(str(file), words), words)
    )


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ('box( name "a" )', "box a"),
        ("box( )", "box"),
        ('model( name "crate" )', "crate"),
        ('ball( name "red ball" pose [ 0.1 0 0 0 ] )', "red ball"),
        ("wall( pose [ 0 0.05 0 0 ] size [ 2 0.05 0.24 ] )", "wall"),
        ('donnie( name "Bob" pose [ 0.05 0 0 0 ] )', "donnie Bob"),
    ],
)
def test_a_robot_that_begins_inside_of_something_is_told(tmp_path: Path, text: str, thing: str) -> None:
    told = f"Robot Ana begins inside {thing}. One of them needs another pose."
    assert remarks_on(tmp_path, ANA + text) == (told,)


@pytest.mark.parametrize(
    "text",
    [
        "box( pose [ 0.15 0 0 0 ] )",
        "model( size [ 2 2 1 ] boundary 1 )",
        "model( size [ 2 2 0.01 ] obstacle_return 0 )",
        'donnie( name "Bob" pose [ 0.2 0 0 0 ] )',
    ],
)
def test_what_only_surrounds_a_robot_or_stands_beside_it_is_not(tmp_path: Path, text: str) -> None:
    assert remarks_on(tmp_path, ANA + text) == ()


@pytest.mark.parametrize("name", worlds.names())
def test_in_the_worlds_that_ship_no_robot_begins_inside_of_anything(name: str) -> None:
    report = choose_world(str(worlds.path(name)), Words()).scene.report

    assert "starts-inside" not in {note.code for note in report.notes}


def test_a_colour_that_is_not_known_is_told_where_the_world_is_loaded(tmp_path: Path) -> None:
    box = "box( pose [ 1 0 0 0 ] {} )"

    assert remarks_on(tmp_path, ANA + box.format('color "amarelo"')) == (
        "1 slip in the world. donnie world my.world --report tells it.",
    )
    assert remarks_on(tmp_path, ANA + box.format('colour "red" color "golden"'), "pt") == (
        "2 deslizes no mundo. donnie world my.world --report os diz.",
    )
    assert remarks_on(tmp_path, ANA + box.format('color "random"')) == ()


def test_very_many_robots_inside_of_things_are_counted(tmp_path: Path) -> None:
    *told, last = remarks_on(tmp_path, "".join(ANA.replace("Ana", f"r{each}") for each in range(6)))

    assert len(told) == 3
    assert last == "12 slips in the world. donnie world my.world --report tells them."


def test_both_front_ends_and_a_run_have_it_among_what_is_told_at_the_start(tmp_path: Path) -> None:
    remarks_on(tmp_path, ANA + "box( )")
    donnie = assemble(
        Settings(world=str(tmp_path / "my.world"), speech="off", sound=False), terminal=True, is_linear=False
    )
    donnie.close()

    assert donnie.notices.all[0].startswith("Robot Ana begins inside box.")
    ran = command.donnie(tmp_path, "run", "-", "--world", "my.world", *command.QUIET, typed="FW 1")
    assert ran.stderr.startswith(b"Robot Ana begins inside box.")
