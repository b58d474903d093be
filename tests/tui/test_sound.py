"""The voice and the sounds at the full screen: a key ends them, and settings count at once."""

from __future__ import annotations

import pytest

from donnie_tui.commands.settings import change
from donnie_tui.core.events import Answered, Chimed, Event, Pointed
from donnie_tui.core.hub import Hub
from donnie_tui.outlets.audible import Audible
from donnie_tui.tui.screens.pages import Help, KeyMenu


async def test_any_key_ends_what_is_being_said(work) -> None:  # type: ignore[no-untyped-def]
    """A key silences the voice."""
    async with work() as desk:
        before = desk.app.controller.donnie.outlets.audible.hushed
        await desk.press("x")
        assert desk.app.controller.donnie.outlets.audible.hushed > before


async def test_what_the_screen_begins_with_is_said(work, monkeypatch) -> None:  # type: ignore[no-untyped-def]
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
    async with work() as desk:
        await desk.shows("I speak.")
        assert said == list(desk.log)
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


async def test_each_row_of_a_list_is_said_as_it_is_reached_and_stands_in_no_log(work, pointed) -> None:  # type: ignore[no-untyped-def]
    async with work("FW 1\nREPEAT 2\nFW 1\nEND REPEAT") as desk:
        await desk.type_line("WORLDS")
        await desk.until(
            lambda: "open_floor" in "".join(pointed[-1:]), "the title and the world that it is in"
        )
        del pointed[:]
        hushed = desk.app.controller.donnie.outlets.audible.hushed
        await desk.press("down")
        await desk.until(lambda: pointed, "the next world")
        assert pointed == [desk.app.screen._fitting[desk.app.screen.rows.line].text]
        assert desk.app.controller.donnie.outlets.audible.hushed > hushed, "what was being said has ended"
        assert not any(pointed[0] in line for line in desk.log)
        await desk.press(*"qqq")
        await desk.until(lambda: pointed[-1] == "Nothing of that name.", "that nothing fits")


@pytest.mark.parametrize(
    ("keys", "kind"),
    [(("f1",), Help), (("ctrl+k",), KeyMenu)],
    ids=["help", "menu"],
)
async def test_each_row_of_the_help_and_of_the_keys_behind_a_key_is_said(work, pointed, keys, kind) -> None:  # type: ignore[no-untyped-def]
    async with work("FW 1") as desk:
        await desk.press(*keys)
        await desk.until(lambda: isinstance(desk.app.screen, kind) and desk.app.screen.rows.lines, "the rows")
        rows = desk.app.screen.rows
        await desk.until(lambda: pointed[-1].endswith(f". {rows.lines[0]}"), "the title and the first")
        await desk.until(lambda: rows.has_focus, "the focus")
        del pointed[:]
        hushed = desk.app.controller.donnie.outlets.audible.hushed
        for key in ("down", "down", "up", "end", "home"):
            await desk.press(key)
        await desk.until(lambda: len(pointed) == 5, "the rows")
        second = rows._rows[2] if rows._heights[1] > 1 else rows.lines[2]
        assert pointed == [rows.lines[1], second, rows.lines[1], rows.lines[-1], rows.lines[0]]
        assert desk.app.controller.donnie.outlets.audible.hushed > hushed, "what was being said has ended"
        assert not any(pointed[0] in line for line in desk.log)


async def test_a_row_of_the_log_is_said_only_when_the_focus_reaches_it(work, pointed) -> None:  # type: ignore[no-untyped-def]
    async with work() as desk:
        await desk.type_line('SPEAK "lone wolf"')
        await desk.shows("lone wolf")
        await desk.type_line("FIND wolf")
        await desk.until(lambda: sum("wolf" in line for line in desk.log) > 1, "what was found")
        await desk.pilot.pause()
        assert pointed == ["Command line."], "the answer was printed already"
        desk.place.log_rows.focus()
        await desk.press("home")
        await desk.until(lambda: pointed[-1] == desk.log[0], "the oldest row")


async def test_where_tab_leads_is_said(work, pointed) -> None:  # type: ignore[no-untyped-def]
    async with work("FW 1", size=(120, 40)) as desk:
        assert pointed == [], "the screen begins in the program"
        for _ in range(5):
            await desk.press("tab")
            await desk.pilot.pause()
        await desk.until(lambda: len(pointed) == 5, "the parts")
        log = next(each for each in pointed if each.startswith("Log, line "))
        assert pointed == ["Map.", "Variables.", log, "Command line.", "Program, line 1 of 1."]

        await desk.press("ctrl+o")
        await desk.until(lambda: desk.app.screen is not desk.place, "a question")
        await desk.press("escape")
        await desk.until(lambda: desk.app.screen is desk.place, "the main screen")
        await desk.pilot.pause()
        assert pointed.count("Program, line 1 of 1.") == 1, "nobody went anywhere"


async def test_words_to_complete_and_questions_are_said_too(work, pointed) -> None:  # type: ignore[no-untyped-def]
    async with work("R") as desk:
        desk.place.editor.move_cursor((0, 1))
        await desk.press("ctrl+space")
        await desk.until(lambda: pointed, "the first word")
        first = pointed[-1]
        await desk.press("down")
        await desk.until(lambda: pointed[-1] != first, "the second")
        await desk.press("escape")
        await desk.until(lambda: desk.app.screen is desk.place, "the main screen")
        await desk.press("ctrl+o")
        await desk.until(lambda: "?" in pointed[-1] or ":" in pointed[-1], "the question")


async def test_enter_sounds_where_a_block_was_opened_or_closed(work, pointed, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    """As in the linear mode."""
    monkeypatch.setattr(Audible, "has_cues", property(lambda _: True))
    async with work() as desk:
        await desk.press(*"FW 1", "enter", *"REPEAT 2", "enter")
        await desk.until(lambda: len(pointed) == 1, "the block that was opened")
        await desk.press(*"FW 1", "enter", *"END REPEAT", "enter")
        await desk.until(lambda: len(pointed) == 2, "its end")
        opened, closed = pointed
        assert opened.startswith("block-opened ")
        assert closed == opened.replace("opened", "closed")


async def test_without_cues_enter_is_silent(work, pointed) -> None:  # type: ignore[no-untyped-def]
    async with work() as desk:
        await desk.press(*"REPEAT 2", "enter")
        await desk.pilot.pause()
        assert pointed == []


async def test_what_is_typed_is_said_by_the_own_voice_where_that_is_chosen(
    work, tmp_path, monkeypatch
) -> None:  # type: ignore[no-untyped-def]
    """Keys or words are echoed."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.setattr(Audible, "echoes", property(lambda _: True))
    heard: list[str] = []
    monkeypatch.setattr(Audible, "echo", lambda _, text: heard.append(text))
    async with work() as desk:
        await desk.press("a")
        assert heard == []
        change(desk.app.controller.ctx, "key_echo", "characters")
        await desk.press("b", "backspace")
        assert heard == ["b.", "b."]
        change(desk.app.controller.ctx, "key_echo", "words")
        desk.place.command_line.focus()
        await desk.pilot.pause()
        await desk.press(*"FW 1", "enter")
        assert heard[2:] == ["FW", "1"]
