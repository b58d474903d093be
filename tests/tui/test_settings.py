"""Settings that are chosen at the screen count at once, and the next time."""

import pytest

from donnie_tui.commands.settings import change
from tests.tui.settings_files import kept


@pytest.fixture(autouse=True)
def own_settings(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))


async def test_the_look_is_chosen_by_word_and_kept(work, tmp_path):
    async with work() as desk:
        await desk.type_line("THEME light")
        await desk.shows("Look: light.")

        assert desk.app.theme == "donnie-light"
        assert kept(tmp_path)["theme"] == "light"

        await desk.type_line("SET theme dark")
        await desk.shows("Look: dark.")
        assert desk.app.theme == "donnie-dark"


async def test_the_language_changes_everything_at_once(work):
    async with work() as desk:
        await desk.type_line("LANGUAGE pt")
        await desk.shows("Idioma: português.")
        await desk.until(lambda: "Mapa:" in desk.screen and "Registro" in desk.screen, "the titles")

        assert "Executar" in desk.screen
        assert "Pronto" in desk.status


async def test_the_settings_list_changes_one_and_comes_back(work, tmp_path):
    async with work() as desk:
        await desk.press("ctrl+k", "comma")
        await desk.until(lambda: "Settings" in desk.screen and "Look: dark." in desk.screen, "the settings")
        await desk.press(*"detail", "enter")
        await desk.until(lambda: "normal" in desk.screen and "brief" in desk.screen, "the values")
        await desk.press(*"brief", "enter")
        await desk.until(lambda: "Detail: brief." in desk.screen, "the settings again")
        await desk.press("escape")

        assert kept(tmp_path)["verbosity"] == "brief"


async def test_another_key_works_at_once(work):
    async with work('SPEAK "by another key"') as desk:
        change(desk.app.controller.ctx, "keys", "run f9")
        await desk.press("f9")
        await desk.shows("by another key")
