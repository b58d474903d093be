"""A person without instructions does all of a first lesson: with the mouse alone, and with the keys alone."""

from __future__ import annotations

from pathlib import Path

import pytest
from textual import events

from donnie_tui.core.run_state import RunState
from tests.tui.conftest import ScreenDriver

LONG = "REPEAT 100 TIMES\nTR 90\nTL 90\nEND REPEAT\n"


async def click(screen: ScreenDriver, words: str) -> None:
    """Click on words that are seen; the wheel turns until they are, in the list that is in front."""
    await screen.painted()
    for _ in range(40):
        if words in screen.text or screen.app.screen is screen.main:
            break
        await screen.pilot._post_mouse_events([events.MouseScrollDown], offset=(30, 10))
        await screen.painted()
    await screen.until(lambda: words in screen.text, words)
    rows = screen.text.splitlines()
    y = max(y for y, row in enumerate(rows) if words in row)
    await screen.pilot.click(offset=(rows[y].index(words) + 1, y))
    await screen.pilot.pause()


@pytest.fixture
def lessons(tmp_path: Path) -> Path:
    (tmp_path / "slip.gd").write_text("FW 1\nFWD 2\n")
    (tmp_path / "turns.gd").write_text(LONG)
    return tmp_path


async def test_everything_is_done_by_mouse_alone(open_screen, lessons: Path) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(speed=2.0) as screen:
        editor = screen.main.editor
        # writes
        for word, text in (("FW", "FW"), ("3", "FW 3"), ("TR", "FW 3 TR"), ("90", "FW 3 TR 90")):
            await click(screen, "Ctrl+P All")
            await screen.until(lambda: "Type what to do" in screen.text, "the palette")
            await click(screen, "COMPLETE ")
            await screen.until(lambda: screen.app.screen.query("#completions"), "the words")
            await screen.painted()
            words = screen.app.screen.list
            at = [str(each.prompt) for each in words.options].index(word)
            words.scroll_to(y=at, animate=False)
            await screen.painted()
            await screen.pilot.click(words, offset=(1, at - words.scroll_offset.y))
            await screen.until(lambda text=text: editor.text == text, text)
        # runs
        await click(screen, "F5 Run")
        await screen.shows("I turned 90 degrees to the right.")
        await screen.idle()
        # saves
        await click(screen, "Ctrl+S Save")
        await click(screen, "Enter takes it")
        await screen.until(lambda: (lessons / "program1.gd").exists(), "the file")
        assert (lessons / "program1.gd").read_text().strip() == "FW 3 TR 90"
        # opens, slows down, stops
        await click(screen, "Ctrl+O Open")
        await click(screen, "turns.gd")
        await screen.until(lambda: editor.text == LONG.rstrip("\n"), "the program")
        await click(screen, "F5 Run")
        await screen.reaches(RunState.RUNNING)
        await click(screen, "F11 Slower")
        await screen.shows("Speed 1.")
        await click(screen, "F8 Stop")
        await screen.idle()
        # steps
        await click(screen, "F7 Step")
        await screen.shows("Line 1: REPEAT")
        await click(screen, "F7 Step")
        await screen.shows("Line 2")
        await click(screen, "F8 Stop")
        await screen.idle()
        # finds a mistake and corrects it
        await click(screen, "Ctrl+O Open")
        await click(screen, "slip.gd")
        await screen.until(lambda: editor.mistakes, "the mark")
        await click(screen, "Errors")
        await click(screen, "Line 2, FWD")
        await screen.until(lambda: editor.cursor_location[0] == 1, "the line")
        await click(screen, "Fix")
        await screen.until(lambda: editor.text == "FW 1\nFW 2", "the word that was meant")
        await click(screen, "Ctrl+S Save")
        await screen.until(lambda: (lessons / "slip.gd").read_text() == "FW 1\nFW 2\n", "the file")


async def test_everything_is_done_by_the_keys_that_are_shown(open_screen, lessons: Path) -> None:  # type: ignore[no-untyped-def]
    """Each key is on the screen when it is pressed, or known from any other program."""

    async def press(shown: str, *keys: str) -> None:
        await screen.painted()
        await screen.until(lambda: shown in screen.text, shown)
        await screen.press(*keys)
        await screen.pilot.pause()

    async with open_screen(speed=2.0) as screen:
        editor = screen.main.editor
        # writes and runs
        await screen.press(*"FW", "space", *"3", "space", *"TR", "space", *"90")
        await press("F5 Run", "f5")
        await screen.shows("I turned 90 degrees to the right.")
        await screen.idle()
        # saves
        await press("Ctrl+S Save", "ctrl+s")
        await press("Enter takes it", "enter")
        await screen.until(lambda: (lessons / "program1.gd").exists(), "the file")
        # opens, slows down, stops
        await press("Ctrl+O Open", "ctrl+o")
        await screen.until(lambda: "turns.gd" in screen.text, "the list")
        await screen.press(*"turns", "tab")
        await press("Enter takes it", "enter")
        await screen.until(lambda: editor.text == LONG.rstrip("\n"), "the program")
        await press("F5 Run", "f5")
        await screen.reaches(RunState.RUNNING)
        await press("F11 Slower", "f11")
        await screen.shows("Speed 1.")
        await press("F8 Stop", "f8")
        await screen.idle()
        # steps
        await press("F7 Step", "f7")
        await screen.shows("Line 1: REPEAT")
        await press("F7 Step", "f7")
        await screen.shows("Line 2")
        await press("F8 Stop", "f8")
        await screen.idle()
        # finds a mistake and corrects it
        await press("Ctrl+O Open", "ctrl+o")
        await screen.until(lambda: "slip.gd" in screen.text, "the list")
        await screen.press(*"slip.gd", "enter")
        await screen.until(lambda: editor.mistakes, "the mark")
        await press("Ctrl+K ! Errors", "ctrl+k", "exclamation_mark")
        await press("Enter takes it", "enter")
        await screen.until(lambda: editor.cursor_location[0] == 1, "the line")
        await press("Ctrl+T Fix", "ctrl+t")
        await screen.until(lambda: editor.text == "FW 1\nFW 2", "the word that was meant")
        await press("Ctrl+S Save", "ctrl+s")
        await screen.until(lambda: (lessons / "slip.gd").read_text() == "FW 1\nFW 2\n", "the file")
