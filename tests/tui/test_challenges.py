"""A challenge on the full screen: task and goals in the panel, the places of goals on the map."""

from __future__ import annotations

import pytest

from donnie_tui.core.map_grid import Kind
from tests.conftest import ROOT

WIDE = (120, 40)
ROUND_TRIP = "challenge:there_and_back"
"""To 0, 8 and back to 0, 0, looking north at the end."""


def panel(screen) -> str:
    return " ".join(" ".join(screen.main.inspector.lines).split())


async def test_the_panel_shows_task_and_goals_with_signs_and_words(open_screen):
    async with open_screen(world=ROUND_TRIP, size=WIDE) as screen:
        await screen.until(lambda: "Goals, 2 of 3 met:" in panel(screen), "the goals")
        assert "Goals and variables" in screen.text
        assert "Challenge: There and back." in panel(screen)
        assert "[ ] Goal 1: You did not get to 0, 8." in panel(screen)
        assert "[x] Goal 2: met." in panel(screen)

        await screen.type_line("FW 8")
        await screen.until(lambda: "[x] Goal 1: met." in panel(screen), "the goal that was met")
        assert "[ ] Goal 2: You stopped 8 steps north of 0, 0." in panel(screen)


async def test_the_plain_panel_has_words_only(open_screen):
    async with open_screen(world=ROUND_TRIP, plain=True) as screen:
        screen.app.do("show_variables")
        await screen.until(lambda: "Goal 2: met." in panel(screen), "the goals")

        assert "[" not in panel(screen)


@pytest.mark.parametrize("size", [(40, 12), (80, 24), (120, 40)], ids=str)
async def test_an_empty_program_of_a_challenge_says_the_task(open_screen, size):
    """On a small screen nothing else does, once the answer of the arrival is gone."""
    async with open_screen(world="challenge:to_the_ball", size=size) as screen:
        await screen.press("left")
        await screen.painted()
        editor = screen.main.editor
        rows = [row.removeprefix("     ") for row in screen.text.splitlines()]
        shown = " ".join(" ".join(row[: editor.size.width - 5] for row in rows).split())
        for words in ("To the ball", "Walk to the yellow ball", "Do not touch it."):
            assert words in shown
        assert "EXAMPLES, Enter" not in screen.text
        await screen.press("f")
        await screen.painted()
        assert "Walk" not in editor.render_line(2).text


async def test_the_panel_says_that_a_challenge_begins_anew(open_screen):
    async with open_screen(world=ROUND_TRIP, size=WIDE) as screen:
        await screen.type_line("FW 8")
        await screen.until(lambda: "[x] Goal 1: met." in panel(screen), "the goal that was met")
        await screen.type_line("RESET")
        await screen.until(lambda: "[ ] Goal 1:" in panel(screen), "the start")


async def test_the_panel_of_a_world_without_a_challenge_has_no_goals(open_screen):
    async with open_screen(world="first_room", size=WIDE) as screen:
        await screen.until(lambda: "No variables" in panel(screen), "the panel")

        assert "Goal" not in panel(screen)


@pytest.mark.parametrize("picture", [False, True])
async def test_the_places_of_goals_are_digits_on_the_map(open_screen, picture):
    async with open_screen(world=ROUND_TRIP, size=WIDE) as screen:
        view = screen.main.map
        view.show_picture(picture)
        scale = view.scale
        square = scale.square_of(scale.scene.cell_at(0, 8))

        assert scale.shown(square) == ("1", Kind.GOAL.value)
        row = scale.bounds.top - square.y
        painted = [view.render_line(y).text for y in range(view.size.height)]
        assert any("1" in line for line in painted), row


async def test_a_goal_of_the_map_is_said_and_explained(open_screen):
    async with open_screen(world=ROUND_TRIP) as screen:
        await screen.type_line("MAP 0 8")
        await screen.shows("0, 8: goal 1. 8 ahead.")
        screen.app.do("legend")
        await screen.until(lambda: "A digit is the place of a goal." in screen.text, "the legend")


async def test_a_program_that_solves_nothing_is_followed_by_the_questions(open_screen):
    async with open_screen(world=f"challenge:{ROOT / 'tests' / 'asking.toml'}") as screen:
        await screen.type_line("FW 1")
        await screen.shows("0 of 1 goal. You stopped 2 steps south of 0, 3.")
        assert screen.app.screen is screen.main

        await screen.run("TR 90")
        await screen.answer("yellow")
        await screen.shows("You answered 1 of 1 question right.")
