"""A person without instructions does all of a first lesson: with the mouse alone, and with the keys alone."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from textual import events

from donnie_tui.core.run_state import RunState
from tests.tui.conftest import ScreenDriver

LONG = "REPEAT 100 TIMES\nTR 90\nTL 90\nEND REPEAT\n"
AT_EACH_SIZE = pytest.mark.parametrize(
    "size", [(80, 24), *(pytest.param(each, marks=pytest.mark.slow) for each in ((40, 12), (120, 40)))]
)


async def click(screen: ScreenDriver, words: str) -> None:
    """Click on words that are seen; the wheel turns until they are, in the list that is in front."""
    await screen.painted()
    for _ in range(40):
        if _rows_with(screen, words) or screen.app.screen is screen.main:
            break
        await screen.pilot._post_mouse_events([events.MouseScrollDown], offset=(30, 5))
        await screen.painted()
    await screen.until(lambda: _rows_with(screen, words), words)
    y, row = _rows_with(screen, words)[-1]
    await screen.pilot.click(offset=(row.index(words) + 1, y))
    await screen.pilot.pause()


def _rows_with(screen: ScreenDriver, words: str) -> list[tuple[int, str]]:
    """The rows that have these whole words, and no longer command such as STEP BACK, each with its place."""
    whole = re.compile(rf"(?<!\w){re.escape(words)}(?!\w| [A-Z])")
    return [(y, row) for y, row in enumerate(screen.text.splitlines()) if whole.search(row)]


async def choose(screen: ScreenDriver, key: str, word: str) -> None:
    """Click on a key of the bottom line, where it has room; else on the word among all that can be done."""
    # the mistakes of the text change the keys, a moment after it was typed
    await screen.until(lambda: screen.app.controller.assistant._checking is None, "the check of the text")
    await screen.painted()
    if key in screen.main.keys.words:
        await click(screen, key)
    else:
        await click(screen, "Ctrl+P All")
        await screen.until(lambda: "Type what to do" in screen.text, "the palette")
        await click(screen, word)


@pytest.fixture
def lessons(tmp_path: Path) -> Path:
    (tmp_path / "slip.gd").write_text("FW 1\nFWD 2\n")
    (tmp_path / "turns.gd").write_text(LONG)
    return tmp_path


@pytest.mark.slow
@AT_EACH_SIZE
async def test_everything_is_done_by_mouse_alone(open_screen, lessons: Path, size) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(size=size, speed=2.0) as screen:
        editor = screen.main.editor
        # writes
        for word, text in (("FW", "FW"), ("3", "FW 3"), ("TR", "FW 3 TR"), ("90", "FW 3 TR 90")):
            await choose(screen, "Complete", "COMPLETE")
            await screen.until(lambda: screen.app.screen.query("#completions"), "the words")
            await screen.painted()
            words = screen.app.screen.list
            at = [str(each.prompt) for each in words.options].index(word)
            words.scroll_to(y=at, animate=False)
            await screen.painted()
            await screen.pilot.click(words, offset=(1, at - words.scroll_offset.y))
            await screen.until(lambda text=text: editor.text == text, text)
        # runs
        await choose(screen, "F5 Run", "RUN")
        await screen.shows("I turned 90 degrees to the right.")
        await screen.idle()
        # saves
        await choose(screen, "Ctrl+S Save", "SAVE")
        await click(screen, "Enter takes it")
        await screen.until(lambda: (lessons / "program1.gd").exists(), "the file")
        assert (lessons / "program1.gd").read_text().strip() == "FW 3 TR 90"
        # opens, slows down, stops
        await choose(screen, "Ctrl+O Open", "OPEN")
        await click(screen, "turns.gd")
        await screen.until(lambda: editor.text == LONG.rstrip("\n"), "the program")
        await choose(screen, "F5 Run", "RUN")
        await screen.reaches(RunState.RUNNING)
        await choose(screen, "F11 Slower", "SLOWER")
        await screen.shows("Speed 1.")
        await choose(screen, "F8 Stop", "STOP")
        await screen.idle()
        # steps
        await choose(screen, "F7 Step", "STEP")
        await screen.shows("Line 1: REPEAT")
        await choose(screen, "F7 Step", "STEP")
        await screen.shows("Line 2")
        await choose(screen, "F8 Stop", "STOP")
        await screen.idle()
        # finds a mistake and corrects it
        await choose(screen, "Ctrl+O Open", "OPEN")
        await click(screen, "slip.gd")
        await screen.until(lambda: editor.mistakes, "the mark")
        await choose(screen, "Errors", "ERRORS")
        await click(screen, "Line 2, FWD")
        await screen.until(lambda: editor.cursor_location[0] == 1, "the line")
        await choose(screen, "Fix", "FIX")
        await screen.until(lambda: editor.text == "FW 1\nFW 2", "the word that was meant")
        await choose(screen, "Ctrl+S Save", "SAVE")
        await screen.until(lambda: (lessons / "slip.gd").read_text() == "FW 1\nFW 2\n", "the file")


@pytest.mark.slow
@AT_EACH_SIZE
async def test_everything_is_done_by_the_keys_that_are_shown(open_screen, lessons: Path, size) -> None:  # type: ignore[no-untyped-def]
    """Each key is on the screen when it is pressed, or known from any other program."""

    async def press(shown: str, *keys: str, word: str = "") -> None:
        """Where the bottom line has no room for the key, the word among all that can be done."""
        await screen.painted()
        if word and shown not in screen.main.keys.words:
            shown, keys = "Ctrl+P All", ("ctrl+p",)
        await screen.until(lambda: shown in screen.text, shown)
        await screen.press(*keys)
        await screen.pilot.pause()
        if shown == "Ctrl+P All":
            await screen.until(lambda: "Type what to do" in screen.text, "the palette")
            await screen.press(*word.lower())
            await press("Enter takes it", "enter")

    async with open_screen(size=size, speed=2.0) as screen:
        editor = screen.main.editor
        # writes and runs
        await screen.press(*"FW", "space", *"3", "space", *"TR", "space", *"90")
        await press("F5 Run", "f5", word="run")
        await screen.shows("I turned 90 degrees to the right.")
        await screen.idle()
        # saves
        await press("Ctrl+S Save", "ctrl+s", word="save")
        await press("Enter takes it", "enter")
        await screen.until(lambda: (lessons / "program1.gd").exists(), "the file")
        # opens, slows down, stops
        await press("Ctrl+O Open", "ctrl+o", word="open")
        await screen.until(lambda: "../" in screen.text, "the list")
        await screen.press(*"turns")
        await screen.until(lambda: "turns.gd" in screen.text, "the program in the list")
        await screen.press("tab")
        await press("Enter takes it", "enter")
        await screen.until(lambda: editor.text == LONG.rstrip("\n"), "the program")
        await press("F5 Run", "f5", word="run")
        await screen.reaches(RunState.RUNNING)
        await press("F11 Slower", "f11", word="slower")
        await screen.shows("Speed 1.")
        await press("F8 Stop", "f8", word="stop")
        await screen.idle()
        # steps
        await press("F7 Step", "f7", word="step")
        await screen.shows("Line 1: REPEAT")
        await press("F7 Step", "f7", word="step")
        await screen.shows("Line 2")
        await press("F8 Stop", "f8", word="stop")
        await screen.idle()
        # finds a mistake and corrects it
        await press("Ctrl+O Open", "ctrl+o", word="open")
        await screen.until(lambda: "../" in screen.text, "the list")
        await screen.press(*"slip.gd", "enter")
        await screen.until(lambda: editor.mistakes, "the mark")
        await press("Ctrl+K ! Errors", "ctrl+k", "exclamation_mark", word="errors")
        await press("Enter takes it", "enter")
        await screen.until(lambda: editor.cursor_location[0] == 1, "the line")
        await press("Ctrl+T Fix", "ctrl+t", word="fix")
        await screen.until(lambda: editor.text == "FW 1\nFW 2", "the word that was meant")
        await press("Ctrl+S Save", "ctrl+s", word="save")
        await screen.until(lambda: (lessons / "slip.gd").read_text() == "FW 1\nFW 2\n", "the file")
