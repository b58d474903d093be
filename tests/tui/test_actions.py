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
LEAVING = ("quit", "linear", "next_challenge")


def looked_at(screen) -> tuple[object, ...]:
    """Where the focus is, and where on the map: the place has its own words."""
    pointer = screen.main.map.pointer
    return screen.app.focused, pointer and pointer.here


def answers_after(screen) -> Callable[[], bool]:
    """Whether a line was printed, a screen opened or the focus moved since then."""
    before, place = len(screen.log), looked_at(screen)

    def is_answered() -> bool:
        printed = any(not line.startswith(">") for line in screen.log[before:])
        return printed or screen.app.screen is not screen.main or looked_at(screen) != place

    return is_answered


PROGRAM = "VAR a = 3\nREPEAT 2 TIMES\nFW a TR 90\nEND REPEAT\nFWD 1"


async def back_to_the_main_screen(screen) -> None:
    while screen.app.screen is not screen.main:
        await screen.press("escape")
        await screen.pilot.pause()


async def test_every_word_is_answered_in_the_log_or_by_a_screen(open_screen):
    async with open_screen(PROGRAM, world="living_room") as screen:
        for action in COMMANDS:
            if action.name in LEAVING:
                continue
            screen.load(PROGRAM)
            await screen.pilot.pause()
            screen.main.command_line.focus()
            await screen.pilot.pause()
            is_answered = answers_after(screen)
            typed = f"{word_of(action, 'en')} {ARGUMENTS.get(action.name, '')}".strip()
            screen.app.on_command_line_typed(type(screen.main.command_line).Typed(typed))
            await screen.until(is_answered, f"an answer to {action.name}")
            await back_to_the_main_screen(screen)
            await screen.idle()


LISTED = {each.name: each for each in COMMANDS}
"""Every action once."""
ASKED = {
    "speed": ("7", "Speed 7."),
    "report": ("list words.html", "words.html"),
    "change": ("1 FW 9", "FW 9"),
    "insert": ("1 TR 45", "TR 45"),
    "move": ("5 1", "FWD 1"),
    "find": ("Donnie", "Donnie"),
    "put": ("box red 4 6", "Box"),
    "turn": ("table 90", "able"),
    "remove": ("table", "able"),
    "map_row": ("0", "0"),
    "map_column": ("0", "0"),
}
"""What needs to know more, what is answered to the question, and a part of the answer."""


@pytest.fixture
def record_commands(monkeypatch):
    """What is asked for by keys and by the palette, in its stead."""

    def instead_of(screen) -> list[str]:
        done: list[str] = []
        monkeypatch.setattr(screen.app.controller, "do", lambda name, argument=None: done.append(name))
        return done

    return instead_of


@pytest.mark.parametrize("language", languages())
def test_every_action_has_a_purpose_and_is_reached_by_its_word(language):
    for action in COMMANDS:
        assert f"action-{action.name}" in CODES
        found = find(word_of(action, language))
        assert found is not None, action
        assert (found[0].name, found[1]) == (action.name, "")


async def test_every_key_runs_its_action(open_screen, record_commands):
    """One after the other, in one burst. An action may have none: it has a word, and a row of the palette."""
    keys = [(name, key) for name, action in LISTED.items() for key in action.keys]
    async with open_screen("FW 1") as screen:
        done = record_commands(screen)
        for name, key in keys:
            before = len(done)
            burst(screen, *(pressed(part) for part in key.split()))
            await screen.until(lambda before=before: len(done) > before, f"{key} for {name}")
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")

        assert done == [name for name, _ in keys]
        assert screen.main.editor.text == "FW 1"


def pressed(key: str) -> str:
    """As Textual names what the terminal sends."""
    return key.removeprefix("shift+").upper() if key.startswith("shift+") and len(key) == 7 else key


async def test_the_word_of_every_action_makes_it_the_first_row_of_the_palette(open_screen):
    async with open_screen("FW 1") as screen:
        await screen.press("ctrl+p")
        await screen.until(lambda: getattr(screen.app.focused, "id", None) == "narrowing", "the palette")
        palette, typed = screen.app.screen, screen.app.focused
        for name, action in LISTED.items():
            typed.value = word_of(action, "en")
            await screen.until(lambda name=name: palette._fitting[0].value == name, f"{name}, the first row")


async def test_the_first_row_of_the_palette_is_done(open_screen, record_commands):
    """Also if the word and Enter come in one burst."""
    names = ["run", "save_as", "map_row", "quit"]
    async with open_screen("FW 1") as screen:
        done = record_commands(screen)
        for name in names:
            before = len(done)
            burst(screen, "ctrl+p", *letters(word_of(LISTED[name], "en")), "enter")
            await screen.until(lambda before=before: len(done) > before, f"{name}, chosen")

        assert done == names
        assert screen.main.editor.text == "FW 1"


def letters(word: str) -> list[str]:
    return ["space" if each == " " else each for each in word.lower()]


@pytest.mark.parametrize("way", ["palette", "key"])
async def test_an_action_asks_for_a_missing_argument(open_screen, way):
    assert {name for name, action in LISTED.items() if action.asked_by_key} == set(ASKED)
    async with open_screen(PROGRAM) as screen:
        for name, (answer, printed) in ASKED.items():
            before, action = len(screen.log), LISTED[name]
            if way == "key" and not action.keys:
                continue
            if way == "palette":
                burst(screen, "ctrl+p", *letters(word_of(action, "en")), "enter")
            else:
                burst(screen, *(pressed(part) for part in action.keys[0].split()))
            await screen.until(
                lambda a=action: f"{word_of(a, 'en')}, for example" in screen.text, f"asked of {name}"
            )
            await screen.answer(answer)
            await screen.until(
                lambda b=before, t=printed: any(t in line for line in screen.log[b:]), f"{printed} of {name}"
            )
            await back_to_the_main_screen(screen)
            screen.load(PROGRAM)


def test_no_key_does_two_things():
    keys = [key for action in COMMANDS for key in action.keys]

    assert sorted(keys) == sorted(set(keys))


def test_keys_have_the_names_on_the_keyboard():
    assert key_label("ctrl+k left_square_bracket", "en") == "Ctrl+K ["
    assert key_label("escape", "en") == "Esc"
    assert key_label("ctrl+s", "en") == "Ctrl+S"


async def test_the_menu_key_lists_its_letters_and_esc_closes_the_list(open_screen):
    async with open_screen() as screen:
        await screen.press(MENU)
        await screen.until(lambda: "Now one of these keys" in screen.text, "the menu")
        assert "WHOLE MAP" in screen.text
        await screen.press("escape")
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")


async def test_enter_does_the_command_of_the_chosen_row_of_the_menu(open_screen):
    async with open_screen() as screen:
        await screen.press(MENU)
        await screen.until(lambda: screen.app.screen is not screen.main, "the menu")
        assert screen.app.screen.cells[2][1] == "COORDINATES"
        await screen.press("down", "down", "enter")
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")
        await screen.until(lambda: screen.main.map.has_rulers, "the numbers at the edges")


@pytest.mark.parametrize("language", ["en", "pt", "es"])
async def test_the_keys_after_the_menu_key_are_a_panel_with_columns(open_screen, language):
    """The program stays in sight next to it."""
    async with open_screen("FW 1", size=(120, 40), language=language) as screen:
        await screen.press(MENU)
        await screen.until(lambda: screen.app.screen is not screen.main, "the menu")
        await screen.painted()
        menu = screen.app.screen
        begins = {
            tuple(row.index(cell) for cell in cells)
            for row, cells in zip(menu.rows.lines, menu.cells, strict=True)
        }
        assert len(begins) == 1
        assert "FW 1" in screen.text
        assert all(len(row) < menu.rows.size.width for row in menu.rows.lines)


@pytest.mark.parametrize(("size", "plain"), [((40, 12), False), ((120, 40), True)])
async def test_a_small_screen_and_a_plain_one_list_the_keys_after_the_menu_key_as_sentences(
    open_screen, size, plain
):
    async with open_screen("FW 1", size=size, plain=plain) as screen:
        await screen.press(MENU)
        await screen.until(lambda: screen.app.screen is not screen.main, "the menu")
        await screen.until(lambda: "A: WHOLE MAP: Shows all, or" in screen.text, "a sentence")
        assert screen.app.screen.rows.region.width == size[0]


@pytest.mark.parametrize(
    ("typed", "language", "names"),
    [
        ("breakpoint", "en", {"break_"}),
        ("colour", "en", {"theme"}),
        ("exit", "en", {"quit"}),
        ("bigger", "en", {"zoom_in"}),
        ("copy", "en", {"copy", "save_as"}),
        ("comment", "en", {"comment"}),
        ("mute", "en", {"quiet", "cues", "set"}),
        ("indent", "en", {"format"}),
        ("cor", "pt", {"theme"}),
        ("maior", "pt", {"zoom_in"}),
        ("mudo", "pt", {"quiet", "cues", "set"}),
        ("copiar", "es", {"copy", "save_as"}),
        ("sangria", "es", {"format"}),
        ("cerrar", "es", {"quit"}),
        ("interrupcion", "es", {"break_"}),
        ("aumentar", "es", {"zoom_in"}),
        ("silenciar", "es", {"quiet"}),
        ("silenciar", "pt", {"quiet"}),
    ],
)
async def test_the_palette_finds_what_people_call_it_elsewhere(open_screen, typed, language, names):
    async with open_screen("FW 1", language=language) as screen:
        await screen.press("ctrl+p")
        await screen.until(lambda: screen.app.screen is not screen.main, "the palette")
        await screen.press(*typed)
        await screen.painted()

        assert {each.value for each in screen.app.screen._fitting[: len(names)]} == names


@pytest.mark.parametrize(
    ("language", "typed", "line"),
    [
        ("en", "high contrast", "> THEME high contrast"),
        ("pt", "alto contraste", "> TEMA alto contraste"),
        ("en", "maze", "> WORLD maze"),
        ("es", "laberinto", "> MUNDO maze"),
        ("pt", "movimento", "> AJUSTAR movimento"),
        ("en", "pitch", "> SET pitch"),
    ],
)
async def test_settings_looks_and_worlds_are_rows_of_the_palette(open_screen, language, typed, line):
    async with open_screen("FW 1", language=language) as screen:
        await screen.press("ctrl+p")
        await screen.until(lambda: screen.app.screen is not screen.main, "the palette")
        await screen.press(*("space" if each == " " else each for each in typed))
        await screen.painted()

        assert line in {each.value for each in screen.app.screen._fitting[:2]}


async def test_a_look_chosen_from_the_palette_is_there_at_once(open_screen):
    async with open_screen("FW 1") as screen:
        await screen.press("ctrl+p")
        await screen.until(lambda: screen.app.screen is not screen.main, "the palette")
        await screen.press(*"theme", "space", *"light", "enter")
        await screen.shows("> THEME light")
        await screen.until(lambda: screen.app.theme == "donnie-light", "the look")
