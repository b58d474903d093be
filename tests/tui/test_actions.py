"""Every action, done by its word, by the palette and by its key."""

from collections.abc import Callable

import pytest

from donnie_tui import LANGUAGES
from donnie_tui.core.use_cases import USE_CASES, find
from donnie_tui.core.view_cases import VIEW_CASES
from donnie_tui.i18n.catalogue import SENTENCES
from donnie_tui.tui.actions import ACTIONS, BY_NAME, CASES
from donnie_tui.tui.keys import MENU, key_label
from language.keywords import canonical

ARGUMENTS = {
    "run_to": "2",
    "break_": "1",
    "speed": "7",
    "read": "2",
    "go_to": "2",
    "search": "FW",
    "find": "Donnie",
    "map": "0 0",
    "map_row": "0",
    "map_column": "0",
    "theme": "light",
    "language": "en",
    "detail": "full",
    "translate": "pt",
    "manual": "FW",
    "save_log": "told.txt",
    "save": "kept.gd",
    "save_as": "other.gd",
    "open": "kept.gd",
    "last": "1",
}
LEAVING = ("quit", "linear")


def looked_at(desk) -> tuple[object, ...]:
    """Where the focus is, and where on the map: the place is told in words of its own."""
    pointer = desk.place.map.pointer
    return desk.app.focused, pointer and pointer.here


def answers_after(desk) -> Callable[[], bool]:
    """Whether something was told, opened or gone to since then."""
    before, place = len(desk.log), looked_at(desk)

    def is_answered() -> bool:
        told = any(not line.startswith(">") for line in desk.log[before:])
        return told or desk.app.screen is not desk.place or looked_at(desk) != place

    return is_answered


PROGRAM = "VAR a = 3\nREPEAT 2 TIMES\nFW a TR 90\nEND REPEAT\nFWD 1"


@pytest.fixture(autouse=True)
def own_folders(tmp_path, monkeypatch):
    """Settings and files of a test stay its own."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.chdir(tmp_path)


async def back_to_the_workplace(desk) -> None:
    while desk.app.screen is not desk.place:
        await desk.press("escape")
        await desk.pilot.pause()


async def test_every_word_is_answered_in_the_log_or_by_a_screen_of_its_own(work):
    async with work(PROGRAM, world="living_room") as desk:
        for action in ACTIONS:
            if action.name in LEAVING or action.hidden:
                continue
            desk.app.work.load(PROGRAM)
            await desk.pilot.pause()
            desk.place.command_line.focus()
            await desk.pilot.pause()
            is_answered = answers_after(desk)
            typed = f"{action.word('en')} {ARGUMENTS.get(action.name, '')}".strip()
            desk.app.on_command_line_typed(type(desk.place.command_line).Typed(typed))
            await desk.until(is_answered, f"an answer to {action.name}")
            await back_to_the_workplace(desk)
            await desk.idle()


@pytest.mark.parametrize("language", LANGUAGES)
def test_words_of_the_screen_alone_are_nobody_else_s(language):
    for case in VIEW_CASES:
        assert canonical(case.word(language)) is None
        assert find(case.word(language), CASES) == (case, "")
        assert case.word(language) not in {each.word(language) for each in USE_CASES}


def test_every_action_has_a_purpose_and_is_reached_by_key_or_palette_and_word():
    for action in ACTIONS:
        assert f"action-{action.name}" in SENTENCES
        assert all(action.word(language) for language in LANGUAGES)
    assert {each.name for each in CASES} >= set(BY_NAME)


def test_no_key_does_two_things():
    keys = [key for action in ACTIONS for key in action.keys]

    assert sorted(keys) == sorted(set(keys))


def test_keys_are_told_as_they_are_on_the_keyboard():
    assert key_label("ctrl+k left_square_bracket") == "Ctrl+K ["
    assert key_label("escape") == "Esc"
    assert key_label("ctrl+s") == "Ctrl+S"


async def test_each_letter_behind_the_menu_key_does_its_action(work, monkeypatch):
    behind = {key: each.name for each in ACTIONS for key in each.keys if MENU in key}
    done = []
    async with work("FW 1") as desk:
        monkeypatch.setattr(desk.app.work, "do", lambda name, argument="": done.append(name))
        for key in behind:
            await desk.press(*key.split())
            await desk.until(lambda: desk.app.screen is desk.place and len(done) == len(set(done)), key)

        await desk.until(lambda: len(done) == len(behind), "all of them")
        assert done == list(behind.values())
        assert desk.app.work.text == "FW 1"


async def test_the_menu_key_lists_its_letters_and_esc_goes_back(work):
    async with work() as desk:
        await desk.press(MENU)
        await desk.until(lambda: "Ctrl+K" not in desk.screen and "Esc goes back" in desk.screen, "the menu")
        assert "A: WHOLE MAP: Shows all, or follows Donnie." in desk.screen
        await desk.press("escape")
        await desk.until(lambda: desk.app.screen is desk.place, "the workplace")
