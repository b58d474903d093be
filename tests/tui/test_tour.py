"""The tour of the full screen: a page at a time, and what it says to do does what it says."""

from __future__ import annotations

import pytest

from donnie_tui.core.run_state import RunState
from donnie_tui.i18n.help import SCREEN_TOUR_PAGES
from tests.tui.conftest import WAITING


async def touring(desk) -> None:  # type: ignore[no-untyped-def]
    desk.app.controller.do("tour")
    await desk.until(lambda: "Tour, page" in desk.screen and "Enter continues" in desk.screen, "the tour")


async def closed(desk) -> None:  # type: ignore[no-untyped-def]
    await desk.until(lambda: desk.app.screen is desk.place, "the main screen")


async def turn_to(desk, page: int, key: str = "enter") -> None:  # type: ignore[no-untyped-def]
    await desk.press(key)
    await desk.until(lambda: f"Tour, page {page} of {SCREEN_TOUR_PAGES}." in desk.screen, f"page {page}")


async def test_enter_turns_the_pages_and_closes_behind_the_last_one(work) -> None:  # type: ignore[no-untyped-def]
    async with work() as desk:
        await touring(desk)
        seen = [desk.screen]
        for page in range(2, SCREEN_TOUR_PAGES + 1):
            await turn_to(desk, page)
            seen.append(desk.screen)
        await desk.press("enter")
        await closed(desk)
        await touring(desk)
        again = desk.screen

    assert len(set(seen)) == SCREEN_TOUR_PAGES
    assert "Your program drives it." in seen[0]
    assert "Have fun." in seen[-1]
    assert all(len([line for line in page.splitlines() if line.strip()]) <= 6 for page in seen)
    assert again == seen[0]


async def test_the_tour_goes_on_at_the_page_that_was_left(work) -> None:  # type: ignore[no-untyped-def]
    async with work() as desk:
        await touring(desk)
        await turn_to(desk, 2)
        await turn_to(desk, 3)
        await turn_to(desk, 2, "backspace")
        await desk.press("escape")
        await closed(desk)
        await touring(desk)

        assert "Tour, page 2" in desk.screen
        assert "You begin in the program. Type FW 3 there." in desk.screen


async def test_it_names_the_keys_as_they_are(work) -> None:  # type: ignore[no-untyped-def]
    async with work(keys="run ctrl+e") as desk:
        await touring(desk)
        await turn_to(desk, 2)

        assert "Ctrl+E runs the program, and so does Esc." in desk.screen
        assert "F8 or Ctrl+C stops Donnie" in desk.screen


@pytest.mark.parametrize(
    ("language", "first", "last"),
    [("pt", "Enter vira esta página", "Divirta-se."), ("es", "Enter pasa esta página", "Diviértete.")],
)
async def test_it_is_in_the_learner_s_language(work, language, first, last) -> None:  # type: ignore[no-untyped-def]
    async with work(language=language) as desk:
        desk.app.controller.do("tour")
        await desk.until(lambda: first in desk.screen, first)
        await desk.press(*["enter"] * (SCREEN_TOUR_PAGES - 1))
        await desk.until(lambda: last in desk.screen, last)


async def test_a_page_is_said_whole(work, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    async with work() as desk:
        said: list[str] = []
        monkeypatch.setattr(desk.app.controller, "point", said.append)
        await touring(desk)
        await desk.until(lambda: said, "the first page")

        assert said[0].startswith(f"Tour, page 1 of {SCREEN_TOUR_PAGES}.")
        assert "Donnie is a robot" in said[0]
        assert "brings it back." in said[0]


async def test_what_it_says_to_do_does_it(work) -> None:  # type: ignore[no-untyped-def]
    """Does what pages 2 to 7 say."""
    async with work(world="living_room") as desk:
        await desk.press(*"FW", "space", "3", "f5")
        await desk.shows("I walked 3 steps")
        await desk.idle()
        order = []
        for _ in range(4):
            order.append(desk.app.focused)
            await desk.press("tab")
        assert order == [desk.place.editor, desk.place.map, desk.place.log_rows, desk.place.command_line]
        await desk.press("tab", "right")
        await desk.until(lambda: "Map, 1, 3: free." in desk.status, "the square")
        await desk.press("f", "n", "w")
        await desk.shows("to -1, 28: 2 left, 25 ahead.")
        await desk.press("home")
        await desk.until(lambda: desk.place.map.pointer.cell is None, "back at the robot")
        desk.place.command_line.focus()
        for typed, shows in (("TR 90", "90 degrees"), ("WHERE", "Position 0, 3."), ("SPEED 3", "Speed 3.")):
            await desk.press(*("space" if each == " " else each for each in typed), "enter")
            await desk.shows(shows)
            await desk.idle()
        await desk.press("up")
        assert desk.place.command_line.value == "SPEED 3"
        desk.load("FWD 1")
        desk.place.editor.focus()
        await desk.until(lambda: "!" in desk.screen and "FWD" in desk.screen, "the mistake")
        await desk.press("ctrl+t")
        await desk.until(lambda: desk.place.editor.text == "FW 1", "the word that was meant")
        await desk.press("ctrl+z")
        await desk.until(lambda: desk.place.editor.text == "FWD 1", "the change taken back")


async def test_its_keys_for_running_step_by_step_do_so(work) -> None:  # type: ignore[no-untyped-def]
    async with work(f"VAR a = 1\nVAR b = 2\n{WAITING}", speed=1.0) as desk:
        await desk.press("f7")
        await desk.shows("Line 1: VAR a = 1")
        await desk.press("f7")
        await desk.shows("Line 2: VAR b = 2")
        await desk.press("f6")
        await desk.doing(RunState.RUNNING)
        await desk.press("f12")
        await desk.shows("Speed 2.")
        await desk.press("f11")
        await desk.shows("Speed 1.")
        await desk.press("ctrl+c")
        await desk.shows("Stopped at line")
