"""Every action, done by its word, by the palette and by its key."""

from collections.abc import Callable

import pytest

from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.keys import MENU, key_label
from donnie_tui.commands.lookup import find, word_of
from language.locales import languages
from tests.tui.conftest import burst
from tests.unit.i18n.sentences import CODES

pytestmark = pytest.mark.slow

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
    "save_log": "log.txt",
    "save": "kept.gd",
    "save_as": "other.gd",
    "open": "kept.gd",
    "last": "1",
}
LEAVING = ("quit", "linear")


def looked_at(desk) -> tuple[object, ...]:
    """Where the focus is, and where on the map: the place has its own words."""
    pointer = desk.place.map.pointer
    return desk.app.focused, pointer and pointer.here


def answers_after(desk) -> Callable[[], bool]:
    """Whether a line was printed, a screen opened or the focus moved since then."""
    before, place = len(desk.log), looked_at(desk)

    def is_answered() -> bool:
        printed = any(not line.startswith(">") for line in desk.log[before:])
        return printed or desk.app.screen is not desk.place or looked_at(desk) != place

    return is_answered


PROGRAM = "VAR a = 3\nREPEAT 2 TIMES\nFW a TR 90\nEND REPEAT\nFWD 1"


@pytest.fixture(autouse=True)
def own_folders(tmp_path, monkeypatch):
    """Settings and files of a test stay its own."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.chdir(tmp_path)


async def back_to_the_main_screen(desk) -> None:
    while desk.app.screen is not desk.place:
        await desk.press("escape")
        await desk.pilot.pause()


async def test_every_word_is_answered_in_the_log_or_by_a_screen(work):
    async with work(PROGRAM, world="living_room") as desk:
        for action in COMMANDS:
            if action.name in LEAVING:
                continue
            desk.load(PROGRAM)
            await desk.pilot.pause()
            desk.place.command_line.focus()
            await desk.pilot.pause()
            is_answered = answers_after(desk)
            typed = f"{word_of(action, 'en')} {ARGUMENTS.get(action.name, '')}".strip()
            desk.app.on_command_line_typed(type(desk.place.command_line).Typed(typed))
            await desk.until(is_answered, f"an answer to {action.name}")
            await back_to_the_main_screen(desk)
            await desk.idle()


LISTED = {each.name: each for each in COMMANDS}
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
"""What needs to know more, what is answered to the question, and a part of the answer."""


@pytest.fixture
def doing(monkeypatch):
    """What is asked of the work by keys and by the palette, in place of its being done."""

    def instead_of(desk) -> list[str]:
        done: list[str] = []
        monkeypatch.setattr(desk.app.controller, "do", lambda name, argument=None: done.append(name))
        return done

    return instead_of


@pytest.mark.parametrize("language", languages())
def test_every_action_has_a_purpose_and_is_reached_by_its_word(language):
    for action in COMMANDS:
        assert f"action-{action.name}" in CODES
        found = find(word_of(action, language))
        assert found is not None, action
        assert (found[0].name, found[1]) == (action.name, "")


async def test_every_key_runs_its_action(work, doing):
    """One after the other, in one burst. An action may have none: it has a word, and a row of the palette."""
    keys = [(name, key) for name, action in LISTED.items() for key in action.keys]
    async with work("FW 1") as desk:
        done = doing(desk)
        for name, key in keys:
            before = len(done)
            burst(desk, *(pressed(part) for part in key.split()))
            await desk.until(lambda before=before: len(done) > before, f"{key} for {name}")
        await desk.until(lambda: desk.app.screen is desk.place, "the main screen")

        assert done == [name for name, _ in keys]
        assert desk.place.editor.text == "FW 1"


def pressed(key: str) -> str:
    """As Textual names what the terminal sends."""
    return key.removeprefix("shift+").upper() if key.startswith("shift+") and len(key) == 7 else key


async def test_every_action_is_chosen_from_the_palette_by_its_word(work, doing):
    async with work("FW 1") as desk:
        done = doing(desk)
        for name, action in LISTED.items():
            before = len(done)
            burst(desk, "ctrl+p", *letters(word_of(action, "en")), "enter")
            await desk.until(lambda before=before: len(done) > before, f"{name}, chosen")

        assert done == list(LISTED)
        assert desk.place.editor.text == "FW 1"


def letters(word: str) -> list[str]:
    return ["space" if each == " " else each for each in word.lower()]


@pytest.mark.parametrize("way", ["palette", "key"])
async def test_an_action_asks_for_a_missing_argument(work, way):
    assert {name for name, action in LISTED.items() if action.asked_by_key} == set(ASKED)
    async with work(PROGRAM) as desk:
        for name, (answer, printed) in ASKED.items():
            before, action = len(desk.log), LISTED[name]
            if way == "key" and not action.keys:
                continue
            if way == "palette":
                burst(desk, "ctrl+p", *letters(word_of(action, "en")), "enter")
            else:
                burst(desk, *(pressed(part) for part in action.keys[0].split()))
            await desk.until(
                lambda a=action: f"{word_of(a, 'en')}, for example" in desk.screen, f"asked of {name}"
            )
            await desk.answer(answer)
            await desk.until(
                lambda b=before, t=printed: any(t in line for line in desk.log[b:]), f"{printed} of {name}"
            )
            await back_to_the_main_screen(desk)
            desk.load(PROGRAM)


def test_no_key_does_two_things():
    keys = [key for action in COMMANDS for key in action.keys]

    assert sorted(keys) == sorted(set(keys))


def test_keys_have_the_names_on_the_keyboard():
    assert key_label("ctrl+k left_square_bracket", "en") == "Ctrl+K ["
    assert key_label("escape", "en") == "Esc"
    assert key_label("ctrl+s", "en") == "Ctrl+S"


async def test_the_menu_key_lists_its_letters_and_esc_closes_the_list(work):
    async with work() as desk:
        await desk.press(MENU)
        await desk.until(lambda: "Ctrl+K" not in desk.screen and "Esc goes back" in desk.screen, "the menu")
        assert "A: WHOLE MAP: Shows all, or follows Donnie." in desk.screen
        await desk.press("escape")
        await desk.until(lambda: desk.app.screen is desk.place, "the main screen")
