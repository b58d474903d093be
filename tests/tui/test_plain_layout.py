"""The plain layout: one column, each answer once, nothing that goes by unseen."""

import pytest
from textual.app import App

from donnie_tui.core.run_state import RunState
from donnie_tui.core.session import Session
from donnie_tui.tui.screens import main_screen
from donnie_tui.tui.terminal import TerminalApp


@pytest.fixture(autouse=True)
def own_settings(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))


async def test_the_plain_layout_is_one_column_with_the_command_line_first(work):
    async with work("FW 1", plain=True) as desk:
        assert desk.app.focused is desk.place.command_line
        assert "Map:" not in desk.screen
        assert not set("│─┌┐└┘▔▁") & set(desk.screen)
        order = []
        for _ in range(5):
            order.append(desk.app.focused.id)
            await desk.press("tab")
            await desk.pilot.pause()

        assert order == ["command", "editor", "log", "map", "inspector"]


async def test_the_plain_layout_shows_each_answer_once_and_nothing_else(work):
    """A reader says what is written: no kind, no repeated command, no sentence again in the status line."""
    async with work("", plain=True) as desk:
        await desk.type_line("FW 3")
        await desk.shows("I walked 3 steps forward.")
        await desk.idle()
        await desk.until(lambda: "I walked 3 steps forward." in desk.screen, "the answer")

        assert desk.status.strip() == "Command line."
        assert not any("FW 3" in line for line in desk.log)
        assert "moved" not in desk.screen


async def test_in_the_plain_layout_a_command_goes_as_its_answer_comes(work, monkeypatch):
    """In one picture: Fenrir says letters that go and leave nothing new."""
    monkeypatch.setattr(main_screen, "LONGEST_HELD", 600.0)
    pictures = []
    display = TerminalApp._display

    async with work("", plain=True) as desk:
        monkeypatch.setattr(
            TerminalApp, "_display", lambda *given: pictures.append(desk.screen) or display(*given)
        )
        await desk.press(*"FW 3")
        await desk.until(lambda: "> FW 3" in "".join(pictures[-1:]), "what is typed")
        del pictures[:-1]
        await desk.press("enter")
        await desk.until(lambda: "I walked 3 steps forward." in pictures[-1], "the answer")

        shown = [("> FW 3" in each, "I walked" in each) for each in pictures]
        assert (False, False) not in shown


@pytest.mark.parametrize(
    ("typed", "seen"),
    [("WORLDS", "living_room"), ("SAVE LOG", "log.txt"), ("HELP", "F1"), ("SHOW MAP", "####")],
)
async def test_what_a_plain_command_opens_is_painted_at_once(work, monkeypatch, typed, seen):
    """It was left out while the command was held back, and the terminal showed the old screen."""
    monkeypatch.setattr(main_screen, "LONGEST_HELD", 600.0)
    async with work("", plain=True, world="living_room") as desk:
        painted = []
        display = App._display

        def paint(app, screen, renderable):
            if renderable is not None and not app._batch_count:  # as Textual asks before it writes
                painted.append(desk.screen)
            display(app, screen, renderable)

        monkeypatch.setattr(App, "_display", paint)
        await desk.press(*typed, "enter")
        await desk.until(lambda: seen in "".join(painted[-1:]), seen)


async def test_a_command_that_takes_longer_goes_before_its_answer(work):
    async with work("", plain=True, speed=1.0) as desk:
        await desk.type_line("WAIT 1000")
        await desk.until(lambda: "WAIT" not in desk.screen, "an empty command line")
        await desk.press("x")
        await desk.until(lambda: "> x" in desk.screen, "what is typed")


async def test_the_plain_log_shows_every_row(work):
    async with work("", plain=True) as desk:
        seen = set()

        def is_all_seen():
            seen.update(line.strip(" .") for line in desk.screen.splitlines())
            return "20" in seen

        await desk.type_line("REPEAT 1 TIMES FOR VAR i = 1; i <= 20; i = i + 1 DO SPEAK i END FOR END REPEAT")
        await desk.until(is_all_seen, "the last number")

        assert {str(number) for number in range(1, 21)} <= seen


async def test_the_map_has_the_plain_screen_to_itself(work):
    async with work("FW 1", plain=True, world="living_room") as desk:
        await desk.type_line("SHOW MAP")
        await desk.until(lambda: "####" in desk.screen, "the map")

        assert desk.place.map.size.width == 80
        assert "FW 1" not in desk.screen


@pytest.mark.parametrize("size", [(80, 24), (40, 12)], ids=str)
async def test_at_the_plain_command_line_the_log_is_seen_from_wherever_one_comes(work, size):
    async with work("FW 1", plain=True, world="living_room", size=size) as desk:
        for pane in (desk.place.map_pane, desk.place.inspector_pane, desk.place.program_pane):
            desk.place.go_to(pane)
            await desk.pilot.pause()
            await desk.type_line("FW 3")
            await desk.until(lambda: desk.place.log_is_seen, "the log")
        await desk.until(lambda: "I walked 3 steps forward." in desk.screen, "the answer")
        desk.place.go_to(desk.place.map_pane)
        await desk.until(lambda: not desk.place.log_is_seen, "the map alone")


async def test_a_look_into_the_past_needs_nothing_to_run(work):
    async with work("WAIT 1000", speed=1.0) as desk:
        await desk.press("f5")
        await desk.doing(RunState.RUNNING)
        await desk.type_line("STEP BACK")
        await desk.shows("A program is running.")
        assert isinstance(desk.app.controller.donnie.session, Session)
        await desk.press("f8")


async def test_in_the_plain_layout_the_marks_have_columns_of_their_own(work):
    async with work("FW 5\nTR 90", plain=True) as desk:
        editor = desk.place.editor
        editor.focus()
        editor.breakpoints = editor.breakpoints ^ {1}
        await desk.press("end")
        await desk.pilot.pause()

        assert [editor.render_line(y).text.rstrip() for y in range(3)] == [" BFW 5", "  TR 90", ""]
        assert editor.render_line(0).cell_length == editor.size.width
        assert editor.cursor_screen_offset.x == editor.content_region.x + len(" BFW 5")
        assert " BFW 5" in desk.screen
