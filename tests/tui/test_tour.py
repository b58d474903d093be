"""The tour of the full screen: a page at a time, and what it says to do does what it says."""

from __future__ import annotations

import pytest

from donnie_tui.core.run_state import RunState
from donnie_tui.i18n.help import SCREEN_TOUR_PAGES
from tests.tui.conftest import WAITING

pytestmark = pytest.mark.slow


async def touring(screen) -> None:  # type: ignore[no-untyped-def]
    screen.app.controller.do("tour")
    await screen.until(lambda: "Tour " in screen.text, "the tour")


async def closed(screen) -> None:  # type: ignore[no-untyped-def]
    await screen.until(lambda: screen.app.screen is screen.main and screen.main.tour is None, "no tour")
    await screen.painted()


async def turn_to(screen, page: int, key: str = "enter") -> None:  # type: ignore[no-untyped-def]
    await screen.press(key)
    await screen.until(lambda: f"Tour {page} of {SCREEN_TOUR_PAGES}" in screen.text, f"page {page}")


async def test_enter_turns_the_pages(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(plain=True) as screen:
        await touring(screen)
        seen = [screen.text]
        for page in range(2, SCREEN_TOUR_PAGES + 1):
            await turn_to(screen, page)
            seen.append(screen.text)

    assert len(set(seen)) == SCREEN_TOUR_PAGES
    assert "Your program drives it." in seen[0]
    assert "One command solves it." in seen[-1]
    assert all(len([line for line in page.splitlines() if line.strip()]) <= 6 for page in seen)


async def test_the_tour_goes_on_at_the_page_that_was_left(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen() as screen:
        await touring(screen)
        await turn_to(screen, 2)
        await turn_to(screen, 3)
        await turn_to(screen, 2, "backspace")
        await screen.press("escape")
        await closed(screen)
        await touring(screen)

        assert "Tour 2 of" in screen.text
        assert "You begin in the program. Type FW 3 there." in screen.text


async def test_it_names_the_keys_as_they_are(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(keys="run ctrl+e") as screen:
        await touring(screen)
        await turn_to(screen, 2)

        assert "Ctrl+E runs the program, and so does Esc." in screen.text
        assert "F8 or Ctrl+C stops Donnie" in screen.text


async def test_it_is_a_strip_that_leaves_everything_usable(open_screen) -> None:  # type: ignore[no-untyped-def]
    """Five rows, and what page 2 says is done while it is there."""
    async with open_screen() as screen:
        await touring(screen)
        await screen.painted()
        assert screen.app.screen is screen.main
        assert screen.main.tour.outer_size.height == 5
        await screen.status_has(" Tour 1 of")

        await turn_to(screen, 2)
        await screen.press("tab", "tab")
        assert screen.app.focused is screen.main.editor
        await screen.press(*"FW", "space", "3", "f5")
        await screen.shows("I walked 3 steps")
        await screen.idle()
        assert screen.main.tour is not None
        screen.app.controller.do("tour")
        await screen.until(lambda: "Tour 3 of" in screen.text, "the next page")
        assert screen.app.focused is screen.main.editor


@pytest.mark.parametrize("language", ["en", "pt", "es"])
async def test_each_page_of_the_strip_has_five_rows_at_most(open_screen, language) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(language=language) as screen:
        screen.app.controller.do("tour")
        await screen.until(lambda: screen.main.tour is not None and screen.main.tour.has_focus, "the strip")
        strip = screen.main.tour
        for page in range(1, SCREEN_TOUR_PAGES + 1):
            await screen.until(lambda page=page: f" {page} " in strip.title, f"page {page}")
            await screen.painted()
            assert strip.outer_size.height <= 5
            if page < SCREEN_TOUR_PAGES:
                await screen.press("enter")


async def test_it_can_be_read_and_left_by_mouse(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1") as screen:
        await touring(screen)
        await screen.painted()
        for page, said in ((2, "Enter continues"), (3, "F8 or Ctrl+C")):
            y, row = next((y, row) for y, row in enumerate(screen.text.splitlines()) if said in row)
            await screen.pilot.click(offset=(row.index(said) + 1, y))
            await screen.until(lambda page=page: f"Tour {page} of" in screen.text, str(page))
            await screen.painted()
        y, row = next((y, row) for y, row in enumerate(screen.text.splitlines()) if "Esc ends" in row)
        await screen.pilot.click(offset=(row.index("Esc ends") + 1, y))
        await closed(screen)


async def test_esc_in_it_closes_it_and_runs_nothing(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1") as screen:
        await touring(screen)
        await screen.press("escape", "escape")
        await closed(screen)
        await screen.shows("Esc again")
        assert "I walked 1 step forward." not in screen.log
        assert screen.app.focused is screen.main.editor


@pytest.mark.parametrize(
    "of_screen", [{}, {"size": (40, 12)}, {"plain": True}], ids=["strip", "small", "plain"]
)
async def test_it_ends_in_the_first_challenge(open_screen, of_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(**of_screen) as screen:
        await touring(screen)
        for page in range(2, SCREEN_TOUR_PAGES + 1):
            await turn_to(screen, page)
        assert "Enter begins challenge 1" in " ".join(screen.text.split())
        await screen.press("enter")
        await screen.until(lambda: screen.app.controller.next_world == "challenge:1", "the challenge")


@pytest.mark.parametrize(
    ("language", "first", "last"),
    [
        ("pt", "Enter vira esta página", "Enter começa o desafio 1"),
        ("es", "Enter pasa esta página", "Enter empieza el reto 1"),
    ],
)
async def test_it_is_in_the_learner_s_language(open_screen, language, first, last) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(language=language) as screen:
        screen.app.controller.do("tour")
        await screen.until(lambda: first in screen.text, first)
        await screen.press(*["enter"] * (SCREEN_TOUR_PAGES - 1))
        await screen.until(lambda: last in screen.text, last)


@pytest.mark.parametrize(
    ("language", "heading", "state", "keys"),
    [
        ("en", "Tour {} of 9", "READY", "Enter continues, Esc ends"),
        ("pt", "Passeio {} de 9", "PRONTO", "Enter segue, Esc fecha"),
        ("es", "Paseo {} de 9", "LISTO", "Enter sigue, Esc cierra"),
    ],
)
async def test_a_page_and_its_keys_are_read_whole_in_forty_columns(  # type: ignore[no-untyped-def]
    open_screen, language, heading, state, keys
) -> None:
    """Above the state, which stays in sight."""
    async with open_screen("FW 1", size=(40, 12), language=language) as screen:
        screen.app.controller.do("tour")
        for page in range(1, SCREEN_TOUR_PAGES + 1):
            await screen.until(lambda page=page: f"{heading.format(page)}\n" in screen.text, heading)
            await screen.painted()
            tour, rows = screen.app.screen, screen.text.splitlines()
            said = " ".join(" ".join(rows[1:9]).replace(">", " ").split())
            assert said == " ".join(tour.rows.lines)
            assert rows[9].startswith(f" {state} ")
            assert rows[11] == f" {keys}"
            await screen.press("enter")


async def test_a_small_page_is_turned_and_left_by_mouse(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1", size=(40, 12)) as screen:
        await touring(screen)
        await screen.painted()
        await screen.pilot.click(offset=(3, 11))
        await screen.until(lambda: "Tour 2 of" in screen.text, "the next page")
        await screen.painted()
        await screen.pilot.click(offset=(20, 11))
        await closed(screen)


async def test_a_page_is_said_whole(open_screen, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    async with open_screen() as screen:
        said: list[str] = []
        monkeypatch.setattr(screen.app.controller, "point", said.append)
        await touring(screen)
        await screen.until(lambda: said, "the first page")

        assert said[0].startswith(f"Tour 1 of {SCREEN_TOUR_PAGES}.")
        assert "Donnie is a robot" in said[0]
        assert "brings it back." in said[0]


async def test_what_it_says_to_do_does_it(open_screen) -> None:  # type: ignore[no-untyped-def]
    """Does what pages 2 to 7 say."""
    async with open_screen(world="living_room") as screen:
        await screen.press(*"FW", "space", "3", "f5")
        await screen.shows("I walked 3 steps")
        await screen.idle()
        order = []
        for _ in range(4):
            order.append(screen.app.focused)
            await screen.press("tab")
        assert order == [
            screen.main.editor,
            screen.main.map,
            screen.main.log_rows,
            screen.main.command_line,
        ]
        screen.main.map.show_all(False)
        await screen.press("tab", "right")
        await screen.until(lambda: "Map, 1, 3: free." in screen.status, "the square")
        await screen.press("f", "n", "w")
        await screen.shows("to -1, 28: 2 left, 25 ahead.")
        await screen.press("home")
        await screen.until(lambda: screen.main.map.pointer.cell is None, "back at the robot")
        screen.main.command_line.focus()
        for typed, shows in (("TR 90", "90 degrees"), ("WHERE", "Position 0, 3."), ("SPEED 3", "Speed 3.")):
            await screen.press(*("space" if each == " " else each for each in typed), "enter")
            await screen.shows(shows)
            await screen.idle()
        await screen.press("up")
        assert screen.main.command_line.value == "SPEED 3"
        screen.load("FWD 1")
        screen.main.editor.focus()
        await screen.until(lambda: "!" in screen.text and "FWD" in screen.text, "the mistake")
        await screen.press("ctrl+t")
        await screen.until(lambda: screen.main.editor.text == "FW 1", "the word that was meant")
        await screen.press("ctrl+z")
        await screen.until(lambda: screen.main.editor.text == "FWD 1", "the change taken back")


async def test_its_keys_for_running_step_by_step_do_so(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(f"VAR a = 1\nVAR b = 2\n{WAITING}", speed=1.0) as screen:
        await screen.press("f7")
        await screen.shows("Line 1: VAR a = 1")
        await screen.press("f7")
        await screen.shows("Line 2: VAR b = 2")
        await screen.press("f6")
        await screen.reaches(RunState.RUNNING)
        await screen.press("f12")
        await screen.shows("Speed 2.")
        await screen.press("f11")
        await screen.shows("Speed 1.")
        await screen.press("ctrl+c")
        await screen.shows("Stopped at line")
