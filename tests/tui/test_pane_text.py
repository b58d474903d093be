"""The texts of the help, the keys of each pane, the tour and the palette."""

from __future__ import annotations

from types import SimpleNamespace as Part

import pytest

from donnie_tui.commands.declarations import BY_NAME, COMMANDS
from donnie_tui.commands.keys import KeyTable
from donnie_tui.commands.preferences import Preferences
from donnie_tui.i18n.words import Words
from donnie_tui.settings.settings import Settings
from donnie_tui.tui import pane_text
from donnie_tui.tui.pane_text import help_lines, help_text, keys_here, palette, tour_pages
from tests.tui.test_display import Place

WORDS, TABLE = Words("en"), KeyTable()


def place(focused: str = "editor", word: str = "") -> Place:
    made = Place()
    made.editor.has_focus, made.editor.word = False, word
    getattr(made, focused).has_focus = True
    return made


IN_THE_PROGRAM = [
    *("In the program:", "Letters write, the arrows, Home and End move, Enter begins a line."),
    *("Right arrow at the end of a word: takes the word that is offered.", "F5, Esc: Runs the program."),
    *("F7: Runs one command.", "Ctrl+B: Pauses at that line, or not."),
    *("Ctrl+Space: Lists words that may follow.", "Ctrl+T: Puts what was probably meant."),
    *("Ctrl+F: Searches in the program.", "Ctrl+L: Lists the blocks.", "Ctrl+Z: Takes the last change back."),
    "Ctrl+S, F2: Saves the program.",
]
EVERYWHERE = [
    *("F8: Stops the program and Donnie.", "Ctrl+K 0: Lists the keys of this pane.", "F1: Explains a word."),
    *("Ctrl+Q: Leaves Donnie.", "Tab: the next pane. Shift+Tab: the one before."),
]
HERE = {
    "editor": IN_THE_PROGRAM,
    "map": [
        *("On the map:", "Arrows: explore it, square by square."),
        "N and P: the next thing and the one before. Home: back to Donnie.",
        "F: marks the square. W: says the way from the mark.",
        "Plus and minus: nearer and farther. A: all of the map, or follow Donnie.",
        "T: names. C: coordinates. L: what the letters mean.",
        *("Ctrl+K I: Says where Donnie is.", "Ctrl+K J: Says what is on each side."),
    ],
    "log_rows": [
        "In the log:",
        "Up and Down, Page Up and Page Down: read what was said. End: the newest line.",
        *("Ctrl+K G: Shows the whole log.", "Ctrl+K Shift+F: Finds what was said."),
        "Ctrl+K V: Writes what was said.",
    ],
    "inspector": [
        "In the variables:",
        "Up and Down, Page Up and Page Down, Home and End: read the lines.",
        *("F4: Says the variables.", "Ctrl+K &: Says what the belt shows."),
    ],
    "command_line": [
        "In the command line:",
        "Type a command of GoDonnie or a word of the help; Enter does it.",
        "Up and Down: what was typed before.",
        *("Ctrl+K Shift+Y: Says what you typed.", "F5, Esc: Runs the program."),
    ],
}


@pytest.mark.parametrize("focused", HERE)
def test_the_keys_of_a_pane_are_listed_with_those_that_work_everywhere(focused: str) -> None:
    assert [*keys_here(place(focused), WORDS, TABLE)] == [*HERE[focused], *EVERYWHERE]


def test_help_explains_the_mistakes_the_word_at_the_cursor_and_the_keys() -> None:
    here = place(word="FW")
    here.editor.mistakes = (Part(line=2, message="I do not know FWD."),)
    about = ["FW: Walks forward, in steps.", "You write: FW value, or FORWARD value.", "Example: FW 5."]
    further = "F1 again: the manual of the language. Esc goes back, from there too."
    lines = [*help_lines(here, WORDS, TABLE)]

    assert lines[: lines.index(further) + 1] == [
        *("Line 2: I do not know FWD.", *about, *IN_THE_PROGRAM, *EVERYWHERE, further)
    ]
    assert lines[lines.index(further) + 1] == "10 words for the first lesson:"
    for word in ("", "walk"):
        here.editor.word = word
        assert [*help_lines(here, WORDS, TABLE)][1] == "In the program:"
    here.editor.word, here.editor.has_focus, here.map.has_focus = "FW", False, True
    assert help_lines(here, WORDS, TABLE)[0] == "On the map:"


def test_the_help_of_the_screen_has_its_keys_and_the_words_of_godonnie() -> None:
    lines = help_text(WORDS, TABLE)
    (at,) = (at for at, each in enumerate(lines) if each == "GoDonnie:")

    assert lines[:2] == ("Keys and words:", "RUN (F5, Esc): Runs the program.")
    assert lines[at - 1] == "Ctrl+P: lists all of these to choose from."
    assert at == len(COMMANDS) + 2
    assert lines[at + 1 : at + 3] == (
        "26 commands. HELP and a word says more.", "FW: Walks forward, in steps."
    )  # fmt: skip
    assert not [each for each in lines[at + 1 :] if each.startswith(("RUN:", "HELP:", "QUIT:"))]


def test_the_palette_has_every_command_and_then_settings_looks_and_worlds() -> None:
    rows = palette(WORDS, TABLE, Preferences(Settings(), {}))
    commands, more = rows[: len(COMMANDS)], [each.text for each in rows[len(COMMANDS) :]]

    assert [each.value for each in commands] == [*BY_NAME]
    run, again = commands[:2]
    assert (run.text, run.also) == ("RUN (F5): Runs the program.", "play, start, execute")
    assert run.columns == ("RUN", "Runs the program.", "F5")
    assert (again.also, again.columns[2]) == ("", "Ctrl+K Shift+A")
    assert next(each.text for each in commands if each.value == "filter").startswith("FILTER: ")
    assert [each.text for each in rows if each.value == "> SET volume"] == [
        "SET volume: Volume of the voice: 100."
    ]
    assert {"SET motion: Motion: full.", "SET keys: Keys: as usual."} <= {*more}
    assert [each for each in more if each.startswith("THEME")] == [
        *("THEME dark: Look", "THEME light: Look", "THEME high contrast: Look"),
        "THEME the terminal's own: Look",
    ]
    assert not [each for each in more if each.startswith(("SET theme", "SET lang", "SET look"))]
    (maze,) = (each for each in rows if each.value == "> WORLD maze")
    assert (maze.text, maze.columns) == ("WORLD maze: Maze", ("WORLD maze", "Maze"))


def test_the_tour_names_the_keys_of_its_commands_or_their_words() -> None:
    pages = tour_pages(WORDS, KeyTable())

    assert [each.title for each in pages] == [f"Tour {number} of 9" for number in range(1, 10)]
    assert {each.keys for each in pages} == {"Enter continues, Esc ends"}
    said = " ".join(line for each in pages for line in each.lines)
    assert "{" not in said
    assert "Ctrl+K" in said
    assert "Ctrl+P" in said
    other = " ".join(line for each in tour_pages(WORDS, KeyTable("run f9")) for line in each.lines)
    assert "F9" in other


def test_a_chart_has_four_rows_with_the_highest_value_above_and_the_newest_at_the_right() -> None:
    histories = pane_text.Histories()
    for value in (0, 3, 1, 2):
        histories.add("a", value)

    assert histories.charts(20, WORDS) == ("a over time:", "3| *", " |   *", " |  *", "0|*")
    assert histories.charts(5, WORDS) == ("a over time:", "3|*", " |  *", " |", "1| *")
    histories.forget()
    assert histories.charts(20, WORDS) == ()
    for name, values in {
        "same": (1, 1, 1),
        "few": (1, 2),
        "large": (1, 2, 10**6),
        "just": (1, 2, 10**6 - 1),
    }.items():
        for value in values:
            histories.add(name, value)
    assert [each for each in histories.charts(20, WORDS) if each.endswith(":")] == ["just over time:"]
    for name in ("b", "c", "d"):
        for value in (1, 2, 3):
            histories.add(name, value)
    assert [each[0] for each in histories.charts(20, WORDS) if each.endswith(":")] == ["j", "b", "c"]


def test_a_value_that_stays_is_one_moment_of_a_variable() -> None:
    histories = pane_text.Histories()
    for value in (1, 1, 2, 2, 3):
        histories.look([("", [("n", value)])])

    assert histories.charts(20, WORDS)[0] == "n over time:"
    assert histories.charts(20, WORDS)[1] == "3|  *"


@pytest.mark.parametrize(
    ("value", "short"),
    [(10**18 - 1, "9" * 18), (10**18, "100000... (19)"), (-(10**18), "-100000... (19)"), (-7, "-7")],
)
def test_a_long_number_is_its_first_digits_and_how_many_there_are(value: int, short: str) -> None:
    lines = pane_text.inspector_lines((), {"n": value}, {}, (), (), WORDS)

    assert lines == ("Variables:", f"n is {short}")
