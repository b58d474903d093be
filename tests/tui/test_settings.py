"""Settings that are chosen at the screen count at once, and the next time."""

import re

import pytest

from donnie_tui.commands.settings import change
from donnie_tui.core.map_grid import Cell, Kind
from tests.tui.settings_files import kept


async def test_the_look_is_chosen_by_word_and_kept(open_screen, tmp_path):
    async with open_screen() as screen:
        await screen.type_line("THEME light")
        await screen.shows("Look: light.")

        assert screen.app.theme == "donnie-light"
        assert kept(tmp_path)["theme"] == "light"

        await screen.type_line("SET theme dark")
        await screen.shows("Look: dark.")
        assert screen.app.theme == "donnie-dark"


async def test_the_language_changes_everything_at_once(open_screen):
    async with open_screen() as screen:
        await screen.type_line("LANGUAGE pt")
        await screen.shows("Idioma: português.")
        await screen.until(lambda: "Mapa:" in screen.text and "Registro" in screen.text, "the titles")

        assert "Executar" in screen.text
        assert screen.main.status.badge == "PRONTO"


async def test_the_settings_list_changes_one_and_comes_back(open_screen, tmp_path):
    async with open_screen() as screen:
        await screen.press("ctrl+k", "comma")
        await screen.until(
            lambda: "Settings" in screen.text and re.search("Look +dark", screen.text), "the settings"
        )
        await screen.press(*"detail", "enter")
        await screen.until(lambda: "normal" in screen.text and "brief" in screen.text, "the values")
        await screen.press(*"brief", "enter")
        await screen.until(lambda: re.search("Detail +brief", screen.text), "the settings again")
        await screen.press("escape")

        assert kept(tmp_path)["verbosity"] == "brief"


@pytest.mark.parametrize(
    ("language", "typed", "kind"),
    [
        ("en", "SET trail off", Kind.TRAIL),
        ("pt", "AJUSTAR raios não", Kind.RAY),
        ("es", "AJUSTAR metas no", Kind.GOAL),
    ],
)
async def test_the_map_leaves_out_what_the_learner_switches_off(open_screen, tmp_path, language, typed, kind):
    marks = {Kind.TRAIL, Kind.RAY, Kind.GOAL}
    async with open_screen(world="challenge:there_and_back", size=(120, 40), language=language) as screen:

        def shown() -> set[Kind]:
            bounds = screen.main.map.scale.bounds
            rows, columns = range(bounds.bottom, bounds.top + 1), range(bounds.left, bounds.right + 1)
            return {screen.main.map.scale.scene.kind(Cell(x, y)) for x in columns for y in rows} & marks

        screen.load("FW 3\nSPEAK DISTANCE F")
        await screen.press("f5")
        await screen.until(lambda: shown() == marks, "trail, ray and goals")
        await screen.type_line(typed)
        await screen.until(lambda: shown() == marks - {kind}, "the map without them")

        assert kept(tmp_path)[kind.value + "s" * (kind is not Kind.TRAIL)] is False
        screen.app.controller.display.show_world()
        assert kind not in shown()


async def test_another_key_works_at_once(open_screen):
    async with open_screen('SPEAK "by another key"') as screen:
        change(screen.app.controller.ctx, "keys", "run f9")
        await screen.press("f9")
        await screen.shows("by another key")


@pytest.mark.parametrize(
    ("language", "rows"),
    [
        ("en", {"Look": "dark", "Language": "English", "Detail": "normal", "Speed": "max"}),
        ("pt", {"Aparência": "escuro", "Idioma": "português", "Detalhe": "normal", "Velocidade": "máxima"}),
        ("es", {"Aspecto": "oscuro", "Idioma": "español", "Detalle": "normal", "Sonido": "no"}),
    ],
)
async def test_forty_columns_have_the_values_of_settings_below_each_other(open_screen, language, rows):
    """However long the longest of the names is."""
    async with open_screen(language=language, size=(40, 16)) as screen:
        await screen.press("ctrl+k", "comma")
        await screen.until(
            lambda: re.search(" +".join(next(iter(rows.items()))), screen.text), "the settings"
        )
        lines = screen.text.splitlines()
        found = {
            (name, value): line.find(value)
            for name, value in rows.items()
            for line in lines
            if line.strip(" >").startswith(name)
        }

        assert {*found} == {*rows.items()}
        assert len({*found.values()}) == 1
        assert -1 not in found.values()
