"""The keys: named for the focused pane, changed by command and in the file, shown everywhere."""

import inspect
import re
import tomllib
from collections.abc import Iterator

import pytest
from textual._ansi_sequences import ANSI_SEQUENCES_KEYS
from textual.driver import Driver
from textual.drivers.linux_driver import LinuxDriver
from textual.events import Click, MouseDown

from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.keys import KeyTable, is_free_to_give, not_understood, with_key
from donnie_tui.commands.settings import change
from donnie_tui.core.run_state import RunState
from donnie_tui.i18n.words import Words
from donnie_tui.tui.screens.pages import KeyMenu
from donnie_tui.tui.terminal import use_mouse
from donnie_tui.tui.widgets.map_view import MapView
from tests.tui.conftest import WAITING

pytestmark = pytest.mark.slow


def kept(tmp_path) -> dict:
    return tomllib.loads((tmp_path / "config" / "donnie" / "settings.toml").read_text())


# --- the table


def test_every_key_is_one_that_terminals_send():
    """By the names that Textual gives to what comes, which differ from those of other libraries."""
    sent = {
        str(key.value) for keys in ANSI_SEQUENCES_KEYS.values() if isinstance(keys, tuple) for key in keys
    }
    unsent = {each.name: each.keys for each in COMMANDS if each.keys and not sent & {*firsts(each.keys)}}

    assert unsent == {}


def firsts(keys: tuple[str, ...]) -> Iterator[str]:
    """What is pressed first."""
    return (each.split()[0] for each in keys)


def test_the_keys_of_the_map_mean_the_same_after_the_menu_key():
    """P is the picture there; the previous thing has Backspace, which goes back in the tour too."""
    table = KeyTable()
    of_the_map = {
        key: binding.action.partition("'")[2].partition("'")[0]
        for binding in MapView.BINDINGS
        if binding.action.startswith("app.do(")
        for key in binding.key.split(",")
    }
    after_menu = {key: table.command_of(f"ctrl+k {key}") for key in of_the_map}

    assert of_the_map["backspace"] == of_the_map["p"] == "previous_thing"
    assert table.command_of("ctrl+k p") == "picture"
    differing = {key for key, name in of_the_map.items() if after_menu[key] != name}
    assert differing == {"p", "home", "equals_sign"}


async def test_the_picture_and_the_previous_thing_have_keys_everywhere(open_screen):
    async with open_screen(world="living_room") as screen:
        await screen.press("ctrl+k", "p")
        await screen.shows("The map is a picture.")
        await screen.press("ctrl+k", "n", "ctrl+k", "n")
        await screen.until(lambda: screen.main.map.is_exploring, "a thing")
        second = screen.main.map.pointer.cell
        await screen.press("ctrl+k", "backspace")
        await screen.until(lambda: screen.main.map.pointer.cell != second, "the thing before")
        await screen.press("n")
        await screen.until(lambda: screen.main.map.pointer.cell == second, "the second thing again")
        await screen.press("backspace")
        await screen.until(lambda: screen.main.map.pointer.cell != second, "the thing before again")


def test_a_key_may_be_given_to_another_action():
    table = KeyTable("step f5, nonsense f6, run ctrl+k 9")

    assert table.of("step")[0] == "f5"
    assert "f5" not in table.of("run")
    assert table.label("run", "en") == "Ctrl+K 9"
    assert table.of("pause") == ("f6",)
    assert table.command_of("f5") == "step"


@pytest.mark.parametrize("key", ["f9", "escape", "ctrl+e", "alt+x", "shift+f3", "ctrl+k 9", "ctrl+k enter"])
def test_a_key_that_types_no_character_can_be_assigned(key):
    assert is_free_to_give(key)


@pytest.mark.parametrize(
    "key",
    ["a", "enter", "tab", "up", "ctrl+c", "ctrl+k", "ctrl+p", "", "ctrl+k", "ctrl+x a", "ctrl+k escape"],
)
def test_a_key_that_is_needed_for_typing_stays(key):
    assert not is_free_to_give(key)


def test_an_invalid_key_setting_is_reported():
    assert not_understood("run f9, step a, dance f6, stop f8 , ,pause") == ("step a", "dance f6", "pause")


def test_a_later_key_setting_replaces_an_earlier_one():
    chosen = with_key("run f9, step f6", "run", "f2")
    assert chosen == "step f6, run f2"
    assert with_key(chosen, "stop", "f6") == "run f2, stop f6"
    assert with_key(chosen, "run", None) == "step f6"


# --- changing them


async def open_keys(screen) -> None:
    await screen.type_line("CHANGE KEYS")
    await screen.until(lambda: "All keys" in screen.text or "RUN: F5, Esc" in screen.text, "the list")


async def choose(screen, *typed: str) -> None:
    await screen.press(*typed, "enter")
    await screen.pilot.pause()


async def test_an_action_gets_another_key_that_counts_at_once_and_is_kept(open_screen, tmp_path):
    async with open_screen(WAITING, speed=1.0) as screen:
        await open_keys(screen)
        await choose(screen, *"run:")
        await screen.until(lambda: "Press the key for RUN." in screen.text, "the question")
        await screen.press("ctrl+e")
        await screen.until(lambda: "RUN: Ctrl+E, F5, Esc. Runs the program." in screen.text, "the list again")
        assert screen.main.keys.words.startswith(" Ctrl+E Run")
        await screen.press("escape")
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")

        await screen.press("ctrl+e")
        await screen.reaches(RunState.RUNNING)

    assert kept(tmp_path)["keys"] == "run ctrl+e"


async def test_a_key_after_the_menu_key_can_be_chosen_too(open_screen):
    async with open_screen("SPEAK 7") as screen:
        await open_keys(screen)
        await choose(screen, *"run:")
        await screen.until(lambda: "Press the key for RUN." in screen.text, "the question")
        await screen.press("ctrl+k")
        await screen.until(lambda: "Now the key that comes after Ctrl+K." in screen.text, "the menu key")
        await screen.press("4")
        await screen.until(lambda: "RUN: Ctrl+K 4" in screen.text, "the list again")
        await screen.press("escape")
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")
        await screen.press("ctrl+k", "4")
        await screen.shows("7")


@pytest.mark.parametrize("key", ["a", "left", "enter", "tab"])
async def test_a_key_for_typing_is_refused_with_the_reason(open_screen, key):
    async with open_screen() as screen:
        await open_keys(screen)
        await choose(screen, *"run:")
        await screen.until(lambda: "Press the key for RUN." in screen.text, "the question")
        await screen.press(key)
        await screen.until(lambda: "is needed for typing" in screen.text, "the reason")
        await screen.press("escape")
        await screen.until(lambda: "RUN: F5, Esc" in screen.text, "the list again")


async def test_an_action_that_loses_its_key_is_reported(open_screen):
    async with open_screen() as screen:
        await open_keys(screen)
        await choose(screen, *"run:")
        await screen.until(lambda: "Press the key for RUN." in screen.text, "the question")
        await screen.press("f8")
        await screen.shows("STOP: no key.")
        await screen.shows("RUN: F8, F5, Esc.")


async def test_all_keys_can_be_reset(open_screen, tmp_path):
    async with open_screen() as screen:
        change(screen.app.controller.ctx, "keys", "run f9")
        await screen.shows("Keys: F9 RUN.")
        await open_keys(screen)
        await choose(screen, *"as usual")
        await screen.shows("Keys: as usual.")
        assert screen.app.key_table.of("run") == ("f5", "escape")
    assert kept(tmp_path)["keys"] == ""


async def test_invalid_keys_of_the_file_are_reported(open_screen):
    async with open_screen(keys="run f9, dance f5") as screen:
        await screen.shows("Keys of the settings: dance f5 means nothing.")
        assert screen.main.keys.words.startswith(" F9 Run")
        await screen.shows("F9 runs the program. F1 helps.")


async def test_the_help_and_the_palette_show_the_chosen_keys(open_screen):
    async with open_screen() as screen:
        change(screen.app.controller.ctx, "keys", "save f5")
        await screen.press("f1")
        await screen.until(lambda: "Letters write" in screen.text, "the help")
        assert "F5, Ctrl+S, F2: Saves the program." in screen.text
        await screen.press("escape")
        await screen.press("ctrl+p", *"saves the")
        await screen.until(lambda: re.search(r"SAVE +Saves the program. +F5", screen.text), "the palette")


async def test_a_chosen_key_for_stop_stops_at_once(open_screen):
    async with open_screen(WAITING, speed=1.0) as screen:
        change(screen.app.controller.ctx, "keys", "stop f3")
        await screen.press("f5")
        await screen.reaches(RunState.RUNNING)
        await screen.press("f3")
        await screen.reaches(RunState.READY)


# --- what can be pressed here


@pytest.mark.parametrize(
    ("pane", "heading", "line"),
    [
        ("editor", "In the program", "Ctrl+B: Pauses at that line, or not."),
        ("map", "On the map", "N and P: the next thing and the one before."),
        ("log_rows", "In the log", "End: the newest line."),
        ("command_line", "In the command line", "Up and Down: what was typed before."),
        ("inspector", "In the variables", "Up and Down, Page Up"),
    ],
)
async def test_the_keys_of_the_focused_pane_are_shown(open_screen, pane, heading, line):
    async with open_screen(size=(120, 40)) as screen:
        getattr(screen.main, pane).focus()
        await screen.pilot.pause()
        await screen.press("ctrl+k", "0")
        await screen.until(lambda: f" {heading}\n" in screen.text, "the keys")
        assert screen.text.endswith(" Esc goes back, arrows read")
        assert line in screen.text
        assert "F8: Stops the program and Donnie." in screen.text


async def test_the_help_begins_with_the_word_at_the_cursor_and_the_keys_of_the_pane(open_screen):
    async with open_screen("REPEAT 2 TIMES\nFW 1\nEND REPEAT") as screen:
        await screen.press("f1")
        await screen.until(lambda: screen.app.screen is not screen.main, "the help")
        rows = screen.app.screen.rows.lines
        assert rows[0].startswith("REPEAT")
        assert "In the program:" in rows[:6]


async def test_a_list_opens_at_what_is_chosen_now_and_stays_there_when_the_terminal_is_resized(open_screen):
    async with open_screen(world="factory") as screen:
        await screen.press("ctrl+k", "o")
        await screen.until(lambda: screen.app.screen is not screen.main, "the worlds")
        await screen.pilot.pause()
        assert screen.app.screen.rows.row_text.startswith("Orange-juice factory")
        await screen.pilot.resize_terminal(50, 20)
        await screen.until(lambda: screen.app.screen.rows.size.width < 60, "the new size")
        assert "Orange-juice factory" in screen.app.screen.rows.row_text


async def test_the_chosen_line_of_a_list_is_seen_as_far_as_a_small_terminal_has_room(open_screen):
    """Its first words say little: living room, easy, a room of ..."""
    async with open_screen(size=(40, 12), world="open_floor") as screen:
        await screen.press("ctrl+k", "o")
        await screen.until(lambda: screen.app.screen is not screen.main, "the worlds")
        await screen.pilot.pause()
        for _ in range(len(screen.app.screen.rows.lines)):
            rows = screen.app.screen.rows
            words = " ".join(rows.lines[rows.line].split()[:20])
            await screen.until(lambda words=words: words in " ".join(screen.text.split()), words)
            await screen.press("down")


# --- the mouse


class Terminal:
    """What counts of a driver."""

    def __init__(self, mouse: bool) -> None:
        self._mouse = mouse
        self.written: list[str] = []

    def _enable_mouse_support(self) -> None:
        assert self._mouse, "Textual's driver writes nothing otherwise"
        self.written.append("on")

    def _disable_mouse_support(self) -> None:
        assert self._mouse
        self.written.append("off")


def test_the_mouse_is_switched_while_the_screen_is_there():
    terminal = Terminal(mouse=True)
    for wanted in (True, False, False, True):
        use_mouse(terminal, wanted=wanted)

    assert terminal.written == ["off", "on"]


def test_textual_s_driver_has_what_switching_the_mouse_needs():
    assert issubclass(LinuxDriver, Driver)
    assert callable(LinuxDriver._enable_mouse_support)
    assert callable(LinuxDriver._disable_mouse_support)
    assert "self._mouse = mouse" in inspect.getsource(Driver.__init__)


async def test_home_and_end_go_to_the_ends_of_a_list(open_screen):
    async with open_screen() as screen:
        await screen.press("ctrl+k", "o")
        await screen.until(lambda: screen.app.screen is not screen.main, "the worlds")
        await screen.press("end")
        await screen.until(
            lambda: screen.app.screen.rows.row_text.startswith("BigBob's full world"), "the last one"
        )
        await screen.press("home")
        await screen.until(lambda: screen.app.screen.rows.row_text.startswith("First room"), "the first one")


async def test_a_question_and_its_keys_are_whole_on_a_small_terminal(open_screen):
    async with open_screen("FW 1", size=(40, 12)) as screen:
        await screen.press("ctrl+n")
        await screen.until(lambda: screen.app.screen is not screen.main, "the question")
        await screen.pilot.pause()
        shown = " ".join(screen.text.split())
        assert "1 line is not saved. Save first, y or n? Enter means no." in shown
        assert shown.endswith(" Enter answers, Esc goes back")
        await screen.press("escape", "ctrl+p")
        await screen.until(lambda: "Type what to do" in screen.text, "the list")
        await screen.painted()
        assert screen.text.endswith("\n Enter takes it, Esc goes back")


@pytest.mark.parametrize("size", [(40, 11), (80, 10), (20, 5)])
async def test_a_list_of_plain_rows_opens_on_the_lowest_screens(open_screen, size):
    async with open_screen("FW 1", size=size) as screen:
        await screen.type_line("THEME")
        await screen.until(lambda: "high contrast" in screen.text, "the list")
        assert screen.app.screen.rows.size.height >= 3


@pytest.mark.parametrize(
    ("key", "is_free"),
    [
        ("f1", True),
        ("f12", True),
        ("f", False),  # a letter
        ("fx", False),
        ("escape", True),
        ("insert", True),
        ("ctrl+a", True),
        ("shift+f5", True),
        ("ctrl+c", False),
        ("ctrl+p", False),
        ("ctrl+k", False),
        ("tab", False),
        ("a", False),
        ("ctrl+k a", True),
        ("ctrl+k escape", False),
        ("ctrl+k ", False),
        ("ctrl+x a", False),
        (f"ctrl+{'x' * 35}", True),
        (f"ctrl+{'x' * 36}", False),
        (f"ctrl+k {'x' * 40}", True),
        (f"ctrl+k {'x' * 41}", False),
    ],
)
def test_a_key_that_is_not_needed_to_type_may_be_given(key: str, is_free: bool) -> None:
    assert is_free_to_give(key) is is_free


def test_a_list_of_keys_keeps_what_it_means_and_reports_the_rest() -> None:
    chosen = " Where  F2, around ctrl+k  x, nothing f3,, map a, where"

    assert not_understood(chosen) == ("nothing f3", "map a", "where")
    assert with_key(chosen, "trail", "f4") == "where f2, around ctrl+k x, trail f4"
    assert with_key(chosen, "where", "f4") == "around ctrl+k x, where f4"
    assert with_key(chosen, "trail", "f2") == "around ctrl+k x, trail f2"
    assert with_key(chosen, "where", None) == "around ctrl+k x"
    assert with_key("", "where", "f4") == "where f4"


async def test_a_list_of_keys_that_is_laid_out_while_it_is_closed_does_no_harm(open_screen):
    """As after several such keys and their letters in one burst: what it has is removed before it."""
    async with open_screen() as screen:
        menu = KeyMenu({"plain": ("ctrl+k z",)}, Words(), lambda _: None)
        await screen.app.push_screen(menu)
        await menu.query("*").remove()
        menu.on_resize()
        menu.dismiss()
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")


IN_FRONT = {
    "palette": ("ctrl+p",),
    "menu": ("ctrl+k",),
    "worlds": ("ctrl+k", "o"),
    "help": ("f1",),
    "files": ("ctrl+o",),
    "question": ("ctrl+n",),
}


@pytest.mark.parametrize("size", [(40, 12), (80, 24), (120, 40), (200, 60)], ids=str)
@pytest.mark.parametrize("name", IN_FRONT)
async def test_what_the_program_does_is_seen_below_every_panel(open_screen, name, size):
    """Where a program may run meanwhile it stops, and the badge there says so."""
    async with open_screen(WAITING, size=size, speed=1.0) as screen:
        may_run = name not in ("files", "question")
        if may_run:
            await screen.press("f5")
            await screen.reaches(RunState.RUNNING)
        await screen.press(*IN_FRONT[name])
        await screen.until(lambda: screen.app.screen is not screen.main, "the panel")
        await screen.painted()
        command_line = size[1] - (4 if size[0] == 40 else 3)
        rows = screen.text.splitlines()
        assert rows[command_line + 1].startswith(" RUNNING" if may_run else " READY")
        assert name == "question" or rows[command_line].rstrip() == ">"
        if may_run:
            await screen.press("ctrl+c")
            await screen.until(lambda: "\n STOPPED" in screen.text, "the badge")
            assert screen.app.screen is not screen.main


@pytest.mark.parametrize("name", ["palette", "menu", "worlds", "files"])
async def test_a_click_next_to_a_panel_goes_back(open_screen, name):
    async with open_screen("FW 1", size=(120, 40)) as screen:
        await screen.press(*IN_FRONT[name])
        await screen.until(lambda: screen.app.screen is not screen.main, "the panel")
        await screen.painted()
        panel = screen.app.screen
        await screen.pilot.click(panel._panel, offset=(3, 0))  # its title
        await screen.painted()
        assert screen.app.screen is panel
        await screen.pilot.click(offset=(2, 20), times=1)
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")


@pytest.mark.parametrize(
    ("pressed", "clicks"), [(False, 1), (True, 2)], ids=["its release", "its second half"]
)
async def test_the_double_click_that_opens_a_panel_leaves_it_open(open_screen, pressed, clicks):
    async with open_screen("FW 1", size=(120, 40)) as screen:
        await screen.press("ctrl+p")
        await screen.until(lambda: screen.app.screen is not screen.main, "the palette")
        await screen.painted()
        panel, place = screen.app.screen, (2, 20)
        each = {"delta_x": 0, "delta_y": 0, "button": 1, "shift": False, "meta": False, "ctrl": False}
        if pressed:
            panel.post_message(MouseDown(panel, *place, **each))
        panel.post_message(Click(panel, *place, **each, chain=clicks))
        await screen.painted()

        assert screen.app.screen is panel
