"""The author's name of a thing is printed where it says more than kind and colour."""

from __future__ import annotations

from pathlib import Path

import pytest

import worlds
from donnie_tui.core.wording import coloured, own_name, the_coloured
from donnie_tui.i18n.words import Words
from sim.worldfile import load_text
from tests.sessions.command import QUIET, donnie

HUNT = """
include "donnie.inc"
include "things.inc"
donnie( name "donnie" pose [ 0 0 0 90 ] )
box( name "tesouro" pose [ 0 0.4 0 0 ] color "yellow" )
box( name "caixa azul 2" pose [ 0.5 0 0 0 ] color "blue" )
box( pose [ -0.5 0 0 0 ] color "red" )
"""


@pytest.mark.parametrize(
    ("language", "listed", "the"),
    [
        ("en", "gold, box, yellow", "gold, the yellow box"),
        ("pt", "gold, caixa amarela", "gold, a caixa amarela"),
        ("es", "gold, caja amarilla", "gold, la caja amarilla"),
    ],
)
def test_a_name_comes_before_the_kind_of_the_thing(language: str, listed: str, the: str) -> None:
    words = Words(language)

    assert coloured("box", "gold", "yellow", words) == listed
    assert the_coloured("box", "gold", "yellow", words) == the


@pytest.mark.parametrize("name", ["", "box", "Box 3", "yellow box", "caixa amarela 2", "CAIXA"])
def test_a_name_of_kind_colour_and_number_says_nothing_more(name: str) -> None:
    assert own_name("box", name, Words("pt")) == ""


def test_a_thing_of_a_foreign_kind_has_its_name_once() -> None:
    assert coloured("puck", "gold", "yellow", Words("en")) == "gold, yellow"


@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_no_thing_of_a_shipped_world_has_an_english_name_that_is_printed(language: str) -> None:
    files = sorted(Path(worlds.__file__).parent.glob("*/*.world"))
    models = [each for file in files for each in load_text(file.read_text(encoding="utf-8"), file).models]
    names = [(each.kind, each.spoken_name) for each in models if ":" not in each.spoken_name]

    assert names
    assert [name for kind, name in names if own_name(kind, name, Words(language))] == []


def test_a_treasure_is_found_by_its_name(tmp_path: Path) -> None:
    world = tmp_path / "hunt.world"
    world.write_text(HUNT, encoding="utf-8")
    typed = b"AROUND\nWORLD\nMAP 0 8\nFW 9\n\nDETAIL brief\nAROUND\n"
    done = donnie(
        tmp_path, "--linear", *QUIET, "--speed", "max", "--lang", "pt", "--world", str(world), typed=typed
    )
    said = done.stdout.decode().splitlines()

    assert "À frente: tesouro, caixa amarela, 5 passos." in said
    assert "À direita: caixa azul, 7 passos." in said
    assert "Tesouro, caixa amarela: 8 à frente." in said
    assert any(line.startswith("0, 8: tesouro") for line in said)
    assert any("tesouro, a caixa amarela" in line for line in said)
