"""The plain layout: one column, each answer once, nothing that goes by unseen."""

import pytest
from textual.app import App

from donnie_tui.core.run_state import RunState
from donnie_tui.core.session import Session
from donnie_tui.tui.screens import main_screen
from donnie_tui.tui.terminal import TerminalApp
from donnie_tui.tui.widgets import log_rows


def pictures_of(screen, monkeypatch):
    """What the screen shows from now on, each time that it is written."""
    pictures, display = [], App._display

    def write(app, above, renderable):
        if renderable is not None and not app._batch_count:  # as Textual asks before it writes
            pictures.append(screen.text)
        display(app, above, renderable)

    monkeypatch.setattr(App, "_display", write)
    return pictures


async def test_the_plain_layout_is_one_column_with_the_command_line_first(open_screen):
    async with open_screen("FW 1", plain=True) as screen:
        assert screen.app.focused is screen.main.command_line
        assert "Map:" not in screen.text
        assert not set("│─┌┐└┘▔▁") & set(screen.text)
        order = []
        for _ in range(5):
            order.append(screen.app.focused.id)
            await screen.press("tab")
            await screen.pilot.pause()

        assert order == ["command", "editor", "log", "map", "inspector"]


async def test_the_plain_layout_shows_each_answer_once_and_nothing_else(open_screen):
    """A reader says what is written: no kind, no repeated command, no sentence again in the status line."""
    async with open_screen("", plain=True) as screen:
        await screen.type_line("FW 3")
        await screen.shows("I walked 3 steps forward.")
        await screen.idle()
        await screen.until(lambda: "I walked 3 steps forward." in screen.text, "the answer")

        assert screen.status.strip() == "Command line."
        assert not any("FW 3" in line for line in screen.log)
        assert "moved" not in screen.text


async def test_in_the_plain_layout_a_command_goes_as_its_answer_comes(open_screen, monkeypatch):
    """In one picture: Fenrir says letters that go and leave nothing new."""
    monkeypatch.setattr(main_screen, "LONGEST_HELD", 600.0)
    pictures = []
    display = TerminalApp._display

    async with open_screen("", plain=True) as screen:
        monkeypatch.setattr(
            TerminalApp, "_display", lambda *given: pictures.append(screen.text) or display(*given)
        )
        await screen.press(*"FW 3")
        await screen.until(lambda: "> FW 3" in "".join(pictures[-1:]), "what is typed")
        del pictures[:-1]
        await screen.press("enter")
        await screen.until(lambda: "I walked 3 steps forward." in pictures[-1], "the answer")

        shown = [("> FW 3" in each, "I walked" in each) for each in pictures]
        assert (False, False) not in shown


@pytest.mark.parametrize(
    ("typed", "seen"),
    [("WORLDS", "living_room"), ("SAVE LOG", "log.txt"), ("HELP", "F1"), ("SHOW MAP", "####")],
)
async def test_what_a_plain_command_opens_is_painted_at_once(open_screen, monkeypatch, typed, seen):
    """It was left out while the command was held back, and the terminal showed the old screen."""
    monkeypatch.setattr(main_screen, "LONGEST_HELD", 600.0)
    async with open_screen("", plain=True, world="living_room") as screen:
        painted = pictures_of(screen, monkeypatch)
        await screen.press(*typed, "enter")
        await screen.until(lambda: seen in "".join(painted[-1:]), seen)


async def test_a_command_that_takes_longer_goes_before_its_answer(open_screen):
    async with open_screen("", plain=True, speed=1.0) as screen:
        await screen.type_line("WAIT 1000")
        await screen.until(lambda: "WAIT" not in screen.text, "an empty command line")
        await screen.press("x")
        await screen.until(lambda: "> x" in screen.text, "what is typed")


@pytest.mark.parametrize("late", [False, True], ids=["in time", "late"])
async def test_the_plain_log_shows_every_row(open_screen, monkeypatch, late):
    """Also where a page is only painted after its time is over."""
    for name in ("REST", "BREATH") if late else ():
        monkeypatch.setattr(log_rows, name, 0.0001)
    async with open_screen("", plain=True) as screen:
        painted = pictures_of(screen, monkeypatch)
        await screen.type_line(
            "REPEAT 1 TIMES FOR VAR i = 1; i <= 20; i = i + 1 DO SPEAK i END FOR END REPEAT"
        )
        await screen.until(lambda: "20." in "".join(painted[-1:]), "the last number")

        seen = {line.strip(" .") for picture in painted for line in picture.splitlines()}
        assert {str(number) for number in range(1, 21)} <= seen


async def test_the_map_has_the_plain_screen_to_itself(open_screen):
    async with open_screen("FW 1", plain=True, world="living_room") as screen:
        await screen.type_line("SHOW MAP")
        await screen.until(lambda: "####" in screen.text, "the map")

        assert screen.main.map.size.width == 80
        assert "FW 1" not in screen.text


@pytest.mark.parametrize("size", [(80, 24), (40, 12)], ids=str)
async def test_at_the_plain_command_line_the_log_is_seen_from_wherever_one_comes(open_screen, size):
    async with open_screen("FW 1", plain=True, world="living_room", size=size) as screen:
        for pane in (
            screen.main.map_pane,
            screen.main.inspector_pane,
            screen.main.program_pane,
        ):
            screen.main.go_to(pane)
            await screen.pilot.pause()
            await screen.type_line("FW 3")
            await screen.until(lambda: screen.main.log_is_seen, "the log")
        await screen.until(lambda: "I walked 3 steps forward." in screen.text, "the answer")
        screen.main.go_to(screen.main.map_pane)
        await screen.until(lambda: not screen.main.log_is_seen, "the map alone")


async def test_a_look_into_the_past_needs_nothing_to_run(open_screen):
    async with open_screen("WAIT 1000", speed=1.0) as screen:
        await screen.press("f5")
        await screen.reaches(RunState.RUNNING)
        await screen.type_line("STEP BACK")
        await screen.shows("A program is running.")
        assert isinstance(screen.app.controller.donnie.session, Session)
        await screen.press("f8")


async def test_in_the_plain_layout_the_marks_have_columns_of_their_own(open_screen):
    async with open_screen("FW 5\nTR 90", plain=True) as screen:
        editor = screen.main.editor
        editor.focus()
        editor.breakpoints = editor.breakpoints ^ {1}
        await screen.press("end")
        await screen.pilot.pause()

        assert [editor.render_line(y).text.rstrip() for y in range(3)] == [" BFW 5", "  TR 90", ""]
        assert editor.render_line(0).cell_length == editor.size.width
        assert editor.cursor_screen_offset.x == editor.content_region.x + len(" BFW 5")
        assert " BFW 5" in screen.text


async def test_the_word_plain_changes_to_it_and_back(open_screen):
    async with open_screen("FW 1") as screen:
        for is_plain in (True, False):
            await screen.type_line("PLAIN")
            await screen.until(lambda wanted=is_plain: screen.main.is_plain is wanted, "the other layout")
            await screen.until(lambda wanted=is_plain: ("Map:" in screen.text) is not wanted, "its panes")
