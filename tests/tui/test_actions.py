"""Every action, done by its word, by the palette and by its key."""

from collections.abc import Callable

import pytest

from donnie_tui import LANGUAGES
from donnie_tui.core.use_cases import USE_CASES, find
from donnie_tui.core.view_cases import VIEW_CASES
from donnie_tui.i18n.catalogue import SENTENCES
from donnie_tui.tui.actions import ACTIONS, CASES
from donnie_tui.tui.actions import find as find_action
from donnie_tui.tui.keys import MENU, key_label
from language.keywords import canonical
from tests.tui.conftest import burst

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


LISTED = {each.name: each for each in ACTIONS if not each.hidden}
"""Every action once."""
ASKED = {
    "speed": ("7", "Speed 7."),
    "report": ("list words.html", "words.html"),
    "change": ("1 FW 9", "FW 9"),
    "insert": ("1 TR 45", "TR 45"),
    "move": ("5 1", "FWD 1"),
    "find": ("Donnie", "Donnie"),
    "map_row": ("0", "0"),
    "map_column": ("0", "0"),
}
"""What needs to know more, what is answered to the question, and something of what is told then."""


@pytest.fixture
def doing(monkeypatch):
    """What is asked of the work by keys and by the palette, in place of its being done."""

    def instead_of(desk) -> list[str]:
        done: list[str] = []
        monkeypatch.setattr(desk.app.work, "do", lambda name, argument=None: done.append(name))
        return done

    return instead_of


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_action_has_a_purpose_and_is_reached_by_its_word(language):
    for action in ACTIONS:
        assert f"action-{action.name}" in SENTENCES
        found = find_action(action.word(language))
        assert found is not None, action
        assert (found[0].name, found[1]) == (action.name, "")


async def test_every_action_is_reached_by_a_key(work, doing):
    """By all that it has, one after the other, in one burst."""
    keys = [(name, key) for name, action in LISTED.items() for key in action.keys]
    assert {name for name, _ in keys} == set(LISTED)
    async with work("FW 1") as desk:
        done = doing(desk)
        for name, key in keys:
            before = len(done)
            burst(desk, *(pressed(part) for part in key.split()))
            await desk.until(lambda before=before: len(done) > before, f"{key} for {name}")
        await desk.until(lambda: desk.app.screen is desk.place, "the workplace")

        assert done == [name for name, _ in keys]
        assert desk.app.work.text == "FW 1"


def pressed(key: str) -> str:
    """As Textual names what the terminal sends."""
    return key.removeprefix("shift+").upper() if key.startswith("shift+") and len(key) == 7 else key


async def test_every_action_is_chosen_from_the_palette_by_its_word(work, doing):
    async with work("FW 1") as desk:
        done = doing(desk)
        for name, action in LISTED.items():
            before = len(done)
            burst(desk, "ctrl+p", *letters(action.word("en")), "enter")
            await desk.until(lambda before=before: len(done) > before, f"{name}, chosen")

        assert done == list(LISTED)
        assert desk.app.work.text == "FW 1"


def letters(word: str) -> list[str]:
    return ["space" if each == " " else each for each in word.lower()]


@pytest.mark.parametrize("way", ["palette", "key"])
async def test_what_an_action_needs_to_know_is_asked(work, way):
    assert {name for name, action in LISTED.items() if action.needs_asking} == set(ASKED)
    async with work(PROGRAM) as desk:
        for name, (answer, told) in ASKED.items():
            before, action = len(desk.log), LISTED[name]
            if way == "palette":
                burst(desk, "ctrl+p", *letters(action.word("en")), "enter")
            else:
                burst(desk, *(pressed(part) for part in action.keys[0].split()))
            await desk.until(
                lambda a=action: f"{a.word('en')}, for example" in desk.screen, f"asked of {name}"
            )
            await desk.answer(answer)
            await desk.until(
                lambda b=before, t=told: any(t in line for line in desk.log[b:]), f"{told} of {name}"
            )
            await back_to_the_workplace(desk)
            desk.app.work.load(PROGRAM)


def test_no_key_does_two_things():
    keys = [key for action in ACTIONS for key in action.keys]

    assert sorted(keys) == sorted(set(keys))


def test_keys_are_told_as_they_are_on_the_keyboard():
    assert key_label("ctrl+k left_square_bracket", "en") == "Ctrl+K ["
    assert key_label("escape", "en") == "Esc"
    assert key_label("ctrl+s", "en") == "Ctrl+S"


async def test_the_menu_key_lists_its_letters_and_esc_goes_back(work):
    async with work() as desk:
        await desk.press(MENU)
        await desk.until(lambda: "Ctrl+K" not in desk.screen and "Esc goes back" in desk.screen, "the menu")
        assert "A: WHOLE MAP: Shows all, or follows Donnie." in desk.screen
        await desk.press("escape")
        await desk.until(lambda: desk.app.screen is desk.place, "the workplace")
