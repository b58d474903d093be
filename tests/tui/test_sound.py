"""The voice and the sounds at the full screen: a key ends them, and settings count at once."""

from __future__ import annotations

import pytest

from donnie_tui.commands.settings import change
from donnie_tui.core.events import Answered, Chimed, Event, Pointed
from donnie_tui.core.hub import Hub
from donnie_tui.outlets.audible import Audible
from donnie_tui.tui.screens.pages import Help, KeyMenu


async def test_any_key_ends_what_is_being_said(open_screen) -> None:  # type: ignore[no-untyped-def]
    """A key silences the voice."""
    async with open_screen() as screen:
        before = screen.app.controller.donnie.outlets.audible.hushed
        await screen.press("x")
        assert screen.app.controller.donnie.outlets.audible.hushed > before


async def test_what_the_screen_begins_with_is_said(open_screen, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    """The greeting that was printed before the voice started, and the decision about the voice."""
    said: list[str] = []
    monkeypatch.setattr(Audible, "say_printed", lambda _, *lines: said.extend(lines))
    publish = Hub.publish

    def listen(self: Hub, event: Event) -> None:
        if isinstance(event, Answered):
            said.append(event.text)
        publish(self, event)

    monkeypatch.setattr(Hub, "publish", listen)
    monkeypatch.setattr("donnie_tui.bootstrap._decided", lambda *_: ("I speak.",))
    async with open_screen() as screen:
        await screen.shows("I speak.")
        assert said == list(screen.log)
        assert len(said) == 3


@pytest.fixture
def pointed(monkeypatch):  # type: ignore[no-untyped-def]
    """The lines said about the focused item, and the cues of the front end, in their order."""
    heard: list[str] = []
    publish = Hub.publish

    def listen(self: Hub, event: Event) -> None:
        if isinstance(event, Pointed):
            heard.append(event.text)
        elif isinstance(event, Chimed):
            heard.append(f"{event.name} {event.steps}")
        publish(self, event)

    monkeypatch.setattr(Hub, "publish", listen)
    return heard


async def test_each_row_of_a_list_is_said_as_it_is_reached_and_stands_in_no_log(open_screen, pointed) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1\nREPEAT 2\nFW 1\nEND REPEAT") as screen:
        await screen.type_line("WORLDS")
        await screen.until(
            lambda: "open_floor" in "".join(pointed[-1:]), "the title and the world that it is in"
        )
        del pointed[:]
        hushed = screen.app.controller.donnie.outlets.audible.hushed
        await screen.press("down")
        await screen.until(lambda: pointed, "the next world")
        assert pointed == [screen.app.screen._fitting[screen.app.screen.rows.line].text]
        assert screen.app.controller.donnie.outlets.audible.hushed > hushed, "what was being said has ended"
        assert not any(pointed[0] in line for line in screen.log)
        await screen.press(*"qqq")
        await screen.until(lambda: pointed[-1] == "Nothing has that name.", "that nothing fits")


@pytest.mark.parametrize(
    ("keys", "kind"),
    [(("f1",), Help), (("ctrl+k",), KeyMenu)],
    ids=["help", "menu"],
)
async def test_each_row_of_the_help_and_of_the_keys_behind_a_key_is_said(
    open_screen, pointed, keys, kind
) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1") as screen:
        await screen.press(*keys)
        await screen.until(
            lambda: isinstance(screen.app.screen, kind) and screen.app.screen.rows.lines, "the rows"
        )
        rows = screen.app.screen.rows
        cells = getattr(screen.app.screen, "cells", None)  # of a table each row is said as a sentence
        lines = rows.lines if cells is None else [": ".join(row) for row in cells]
        await screen.until(lambda: pointed[-1].endswith(f". {lines[0]}"), "the title and the first")
        await screen.until(lambda: rows.has_focus, "the focus")
        del pointed[:]
        hushed = screen.app.controller.donnie.outlets.audible.hushed
        for key in ("down", "down", "up", "end", "home"):
            await screen.press(key)
        await screen.until(lambda: len(pointed) == 5, "the rows")
        second = rows._rows[2] if rows._heights[1] > 1 else lines[2]
        assert pointed == [lines[1], second, lines[1], lines[-1], lines[0]]
        assert screen.app.controller.donnie.outlets.audible.hushed > hushed, "what was being said has ended"
        assert not any(pointed[0] in line for line in screen.log)


async def test_a_row_of_the_log_is_said_only_when_the_focus_reaches_it(open_screen, pointed) -> None:  # type: ignore[no-untyped-def]
    async with open_screen() as screen:
        await screen.type_line('SPEAK "lone wolf"')
        await screen.shows("lone wolf")
        await screen.type_line("FIND wolf")
        await screen.until(lambda: sum("wolf" in line for line in screen.log) > 1, "what was found")
        await screen.pilot.pause()
        assert pointed == ["Command line."], "the answer was printed already"
        screen.main.log_rows.focus()
        await screen.press("home")
        await screen.until(lambda: pointed[-1] == screen.log[0], "the oldest row")


async def test_where_tab_leads_is_said(open_screen, pointed) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("FW 1", size=(120, 40)) as screen:
        assert pointed == [], "the screen begins in the program"
        for _ in range(5):
            await screen.press("tab")
            await screen.pilot.pause()
        await screen.until(lambda: len(pointed) == 5, "the parts")
        log = next(each for each in pointed if each.startswith("Log, line "))
        assert pointed == ["Map.", "Variables.", log, "Command line.", "Program, line 1 of 1."]

        await screen.press("ctrl+o")
        await screen.until(lambda: screen.app.screen is not screen.main, "a question")
        await screen.press("escape")
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")
        await screen.pilot.pause()
        assert pointed.count("Program, line 1 of 1.") == 1, "the focus did not move"


async def test_words_to_complete_and_questions_are_said_too(open_screen, pointed) -> None:  # type: ignore[no-untyped-def]
    async with open_screen("R") as screen:
        screen.main.editor.move_cursor((0, 1))
        await screen.press("ctrl+space")
        await screen.until(lambda: pointed, "the first word")
        first = pointed[-1]
        await screen.press("down")
        await screen.until(lambda: pointed[-1] != first, "the second")
        await screen.press("escape")
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")
        await screen.press("ctrl+o")
        await screen.until(lambda: "?" in pointed[-1] or ":" in pointed[-1], "the question")


async def test_enter_sounds_where_a_block_was_opened_or_closed(open_screen, pointed, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    """As in the linear mode."""
    monkeypatch.setattr(Audible, "has_cues", property(lambda _: True))
    async with open_screen() as screen:
        await screen.press(*"FW 1", "enter", *"REPEAT 2", "enter")
        await screen.until(lambda: len(pointed) == 1, "the block that was opened")
        await screen.press(*"FW 1", "enter", *"END REPEAT", "enter")
        await screen.until(lambda: len(pointed) == 2, "its end")
        opened, closed = pointed
        assert opened.startswith("block-opened ")
        assert closed == opened.replace("opened", "closed")


async def test_without_cues_enter_is_silent(open_screen, pointed) -> None:  # type: ignore[no-untyped-def]
    async with open_screen() as screen:
        await screen.press(*"REPEAT 2", "enter")
        await screen.pilot.pause()
        assert pointed == []


async def test_what_is_typed_is_said_by_the_own_voice_where_that_is_chosen(
    open_screen, tmp_path, monkeypatch
) -> None:  # type: ignore[no-untyped-def]
    """Keys or words are echoed."""
    monkeypatch.setattr(Audible, "echoes", property(lambda _: True))
    heard: list[str] = []
    monkeypatch.setattr(Audible, "echo", lambda _, text: heard.append(text))
    async with open_screen() as screen:
        await screen.press("a")
        assert heard == []
        change(screen.app.controller.ctx, "key_echo", "characters")
        await screen.press("b", "backspace")
        assert heard == ["b.", "b."]
        change(screen.app.controller.ctx, "key_echo", "words")
        screen.main.command_line.focus()
        await screen.pilot.pause()
        await screen.press(*"FW 1", "enter")
        assert heard[2:] == ["FW", "1"]
