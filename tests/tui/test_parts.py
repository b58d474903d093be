"""The parts of the full screen, one by one: table of actions, rows, highlighting, copies."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from textual.app import App, ComposeResult
from textual.color import Color
from textual.theme import Theme
from textual.widgets import TextArea

from donnie_tui.commands.declarations import BY_NAME, COMMANDS
from donnie_tui.commands.interaction import Option
from donnie_tui.commands.lookup import find, word_of
from donnie_tui.core.document import ANOTHER_PROGRAM, Document
from donnie_tui.core.program_files import as_lines
from donnie_tui.settings.settings import SPEEDS, THEMES
from donnie_tui.tui import themes
from donnie_tui.tui.highlighting import LARGEST, LONGEST_LINE, highlights
from donnie_tui.tui.screens.dialogs import Chooser
from donnie_tui.tui.widgets.editor import Editor
from donnie_tui.tui.widgets.rows import MOST_LINES as MOST_LOGGED
from donnie_tui.tui.widgets.rows import TextRows
from language.keywords import canonical
from language.locales import languages
from tests.effort import examples

ODD_TEXTS = ("[bold]", "\x1b[31mred", "a\tb", "日本語" * 20, "", "e\u0301" * 50, "\udcff")
ODD_LETTERS = tuple('FW TR 1"“”-–\n\r\té́ação[]:=<>\u2028\x0c\udcff日')


# --- actions


@pytest.mark.parametrize("language", languages())
def test_every_word_finds_its_action_in_every_language(language):
    for action in COMMANDS:
        found = find(word_of(action, language).lower())
        assert found is not None
        assert found[0].name == action.name


def test_words_of_the_screen_are_not_godonnie_s_but_for_those_that_mean_the_same():
    shared = {"run", "help", "quit"}
    taken = [
        (action.name, language)
        for action in COMMANDS
        for language in languages()
        if action.name not in shared and canonical(word_of(action, language)) is not None
    ]

    assert taken == []


@pytest.mark.parametrize(
    "typed", ["step = 3", "speed=3", "open [2]", "FW 3", "run fw 3", "", "  ", "stopped"]
)
def test_what_godonnie_may_mean_is_left_to_godonnie(typed):
    assert find(typed) is None


@pytest.mark.parametrize(
    ("typed", "name", "argument"),
    [
        ("open my file.gd", "open", "my file.gd"),
        ("Save As  my  file", "save_as", "my  file"),
        ("SPEED 3", "speed", "3"),
        ("mais rapido", "faster", ""),
        ("STEP 3", "step", "3"),
        ("até 4", "run_to", "4"),
        ("ATE 4", "run_to", "4"),
    ],
)
def test_the_text_after_a_word_is_its_argument(typed, name, argument):
    action, rest = find(typed)

    assert (action.name, rest) == (name, argument)


def test_speeds_go_up():
    assert list(SPEEDS[:-1]) == sorted(SPEEDS[:-1])
    assert SPEEDS[-1] is None
    assert BY_NAME["quit"].keys == ("ctrl+q",)


# --- rows of text


class Rows(App[None]):
    def compose(self) -> ComposeResult:
        yield TextRows(id="rows", follows=True)


async def test_the_log_forgets_its_oldest_lines_only():
    async with Rows().run_test(size=(80, 24)) as pilot:
        rows = pilot.app.query_one(TextRows)
        rows.append((f"line {i}", "says") for i in range(MOST_LOGGED + 1))
        await pilot.pause()

        assert len(rows.lines) <= MOST_LOGGED
        assert rows.lines[-1] == f"line {MOST_LOGGED}"
        assert rows.lines[0] == f"line {MOST_LOGGED // 10}"


async def test_long_lines_are_broken_at_blanks_and_nothing_is_lost():
    async with Rows().run_test(size=(30, 10)) as pilot:
        rows = pilot.app.query_one(TextRows)
        text = "a sentence that is a good deal longer than thirty columns, " + "x" * 70
        rows.append([(text, "says")])
        await pilot.pause()
        shown = [rows._rows[i] for i in range(rows.row_count)]

        assert all(len(row) <= 29 for row in shown)
        assert "".join(shown).replace(" ", "") == f"says:{text}".replace(" ", "")


async def test_where_there_is_little_room_the_kind_stands_before_the_sentence():
    async with Rows().run_test(size=(40, 10)) as pilot:
        rows = pilot.app.query_one(TextRows)
        rows.append([("Hello.", "says"), ("Obstacle ahead.", "obstacle"), ("Ready.", "")])
        await pilot.pause()
        assert [rows.render_line(y).text.strip(" >") for y in range(3)] == [
            "says: Hello.",
            "Obstacle ahead.",
            "Ready.",
        ]

        await pilot.resize_terminal(80, 10)
        await pilot.pause()
        assert [rows.render_line(y).text.split() for y in range(2)] == [
            ["says", "Hello."],
            ["obstacle", "Obstacle", "ahead."],
        ]


async def test_rows_are_broken_anew_when_the_size_changes():
    async with Rows().run_test(size=(30, 10)) as pilot:
        rows = pilot.app.query_one(TextRows)
        rows.append([("one two three four five six seven eight nine ten", "")])
        await pilot.pause()
        narrow = rows.row_count
        await pilot.resize_terminal(100, 10)
        await pilot.pause()

        assert narrow > 1
        assert rows.row_count == 1


async def test_any_text_is_shown_without_harm():
    async with Rows().run_test(size=(40, 10)) as pilot:
        rows = pilot.app.query_one(TextRows)
        rows.append(
            (text, "k")
            for text in ["[bold]", "\x1b[31mred", "a\tb", "日本語" * 20, "", "e\u0301" * 50, "\udcff"]
        )
        await pilot.pause()

        assert "[bold]" in rows.lines


# --- editor


def test_textual_still_has_the_names_that_the_editor_fills():
    area = TextArea()

    assert callable(area._build_highlight_map)
    assert area._highlights is not None
    assert hasattr(area, "_line_cache")


class Editing(App[None]):
    def compose(self) -> ComposeResult:
        yield Editor(id="editor")


async def test_commands_numbers_texts_and_comments_look_different():
    async with Editing().run_test(size=(60, 10)) as pilot:
        editor = pilot.app.query_one(Editor)
        editor.load_text('FW 5 -- comment\nFALAR "olá" PARA FRENTE ação')
        await pilot.pause()

        assert [look for *_, look in editor._highlights[0]] == ["command", "number", "comment"]
        assert [look for *_, look in editor._highlights[1]] == ["command", "string", "command"]
        bold = [each.text for each in editor.render_line(1) if each.style is not None and each.style.bold]
        assert "".join(bold).replace(" ", "") == "FALARPARAFRENTE"


def test_looks_are_counted_in_bytes():
    assert highlights('FALAR "é" FW')[0] == [(0, 5, "command"), (6, 10, "string"), (11, 13, "command")]


LOOKS = {
    "VAR x = (3 + 4) * 2": ["VAR command", "= operator", "3 number", "+ operator", "4 number", "* operator",
                            "2 number"],
    "IF x <= 3 DO END IF": ["IF command", "<= operator", "3 number", "DO command", "END IF command"],
    "SPEAK COLOR red": ["SPEAK command", "COLOR command", "red argument"],
    "SPEAK POS X": ["SPEAK command", "POS command", "X argument"],
    "WALK [5, x]": ["5 number"],
    "PROCEDURE W: n; m DO": ["PROCEDURE command", "DO command"],
    "HELP fw": ["HELP command", "fw argument"],
    '"x': ['"x string'],
    "": [],
}  # fmt: skip


@pytest.mark.parametrize("source", LOOKS)
def test_each_part_of_a_line_has_the_look_of_its_kind_and_names_and_brackets_have_none(source):
    found = [f"{source[start:end]} {look}" for start, end, look in highlights(source).get(0, [])]
    assert found == LOOKS[source]


def test_a_huge_program_and_a_huge_line_have_no_looks():
    line = "FW 1 -- "
    longest = line + "x" * (LONGEST_LINE - len(line) - 1)
    looks = [(0, 2, "command"), (3, 4, "number")]
    found = highlights(f"{longest}\n{longest}x\nFW 1")
    assert (found[0][:2], found.get(1, []), found[2]) == (looks, [], looks)
    largest = "FW 1\n" * (LARGEST // 5)
    assert len(highlights(largest)) == LARGEST // 5
    assert highlights(f"{largest}\n") == {}


def test_a_text_over_several_lines_is_looked_at_line_by_line():
    found = highlights('SPEAK "one\ntwo" FW 1')

    assert found[0] == [(0, 5, "command"), (6, 11, "string")]
    assert found[1] == [(0, 4, "string"), (5, 7, "command"), (8, 9, "number")]


@settings(max_examples=examples(300))
@given(st.text(alphabet=st.sampled_from(ODD_LETTERS), max_size=60))
def test_any_text_has_looks_within_its_lines(text):
    lines = text.splitlines(keepends=True) or [""]
    for line, looks in highlights(text).items():
        size = len(lines[line].encode("utf-8", "surrogatepass"))
        for start, end, _ in looks:
            assert 0 <= start <= (end if end is not None else size) <= size


# --- documents in the editor


class EditorApp(App[None]):
    def compose(self) -> ComposeResult:
        yield Editor(id="editor")


@pytest.mark.parametrize("lines", [(), ("FW 1",), ("", "FW 1"), ("FW 1", ""), ("FW 1", "", ""), ("",)])
async def test_a_document_in_the_editor_keeps_its_lines(lines: tuple[str, ...]):
    document = Document()
    document.replace("".join(f"{line}\n" for line in lines), None)
    app = EditorApp()
    async with app.run_test():
        document.attach(app.query_one(Editor))
        assert (document.lines, document.is_saved) == (lines, True)
        document.rewrite("FW 9\n\n")
        assert document.lines == ("FW 9", "")
        assert document.undo() == 1
        assert document.lines == lines


async def test_undo_goes_from_the_last_key_back_to_the_program_before():
    app = EditorApp()
    async with app.run_test() as pilot:
        editor, document = app.query_one(Editor), Document()
        document.attach(editor)
        editor.focus()
        await pilot.press("F", "W")
        document.replace("BW 1\n", None)
        editor.insert("X")
        assert document.lines == ("XBW 1",)

        assert (document.undo(), document.lines) == (1, ("BW 1",))
        assert (document.undo(), document.lines) == (ANOTHER_PROGRAM, ("FW",))
        assert (document.redo(), document.lines) == (ANOTHER_PROGRAM, ("BW 1",))
        assert [each.text for each in document.versions.replaced] == ["FW\n"]


async def test_a_line_that_is_only_ended_is_undone_before_the_program():
    app = EditorApp()
    async with app.run_test():
        editor, document = app.query_one(Editor), Document()
        document.replace("FW 1\n", None)
        document.attach(editor)
        document.replace("BW 1\n", None)
        editor.insert("\n", editor.document.end)
        document.undo()

        assert editor.text == "BW 1"


async def test_breakpoints_and_the_place_come_back_from_the_editor():
    app = EditorApp()
    async with app.run_test():
        editor, document = app.query_one(Editor), Document()
        document.replace("FW 1\nFW 2\nFW 3\n", None)
        document.attach(editor)
        document.breakpoints = frozenset({3})
        document.insert(1, "FW 0")
        document.place = 2
        document.detach()

        assert (document.breakpoints, document.place) == ({4}, 2)
        assert document.lines == ("FW 0", "FW 1", "FW 2", "FW 3")


@pytest.mark.parametrize(("cursor", "after"), [(3, 3), (6, 7), (8, 7), (11, 9)])
async def test_the_cursor_stays_at_its_letter_while_a_part_is_replaced(cursor: int, after: int):
    app = EditorApp()
    async with app.run_test():
        editor, document = app.query_one(Editor), Document()
        document.replace("FW 1 TRRR 90\n", None)
        document.attach(editor)
        editor.move_cursor((0, cursor))
        document.replace_range(5, 9, "TR")

        assert (editor.text, editor.cursor_location) == ("FW 1 TR 90", (0, after))


async def test_a_word_that_is_found_is_selected():
    app = EditorApp()
    async with app.run_test():
        editor, document = app.query_one(Editor), Document()
        document.replace("FW 1\nBW 2\n", None)
        document.attach(editor)

        assert document.find_next("2") == 2
        assert (editor.selected_text, document.place) == ("2", 2)


def test_lines_end_alike_in_the_editor_however_they_ended_in_the_file():
    assert as_lines("a\r\nb\rc\n") == "a\nb\nc"


# --- lists to choose from


class Choosing(App[None]):
    """A list of names of 20 cells, each with a text about it."""

    def on_mount(self) -> None:
        choices = [Option(letter, letter * 20, detail=lambda *_: ("About",)) for letter in "ab"]
        self.push_screen(Chooser("Title", "Keys", "Nothing", choices, lambda _: None))


@pytest.mark.parametrize(
    ("width", "place"), [(63, "right"), (62, "below"), (23, "below"), (22, "nowhere")], ids=str
)
async def test_what_a_list_is_about_is_where_there_is_room_for_it(width, place):
    """At the right of a column of 22 cells if 40 more and a border fit, below if only a border does."""
    async with Choosing().run_test(size=(width, 24)) as pilot:
        await pilot.pause()
        is_below = pilot.app.screen.query_one("#listing").has_class("-below")
        is_shown = pilot.app.screen.query_one("#detail").display

        assert (is_shown, is_below) == (place != "nowhere", place == "below")


# --- looks


RGB = [each for each in themes.NAMES if each != themes.TERMINAL]
OF_COLOURS = {f"thing-{each}": each for each in themes.COLOURS}
PAINTED_AS = {
    "robot": "accent", "other": "warning", "start": "success", "goal": "warning", "trail": "success",
    "wall": "foreground", "free": "faint", "ray": "warning", "name": "foreground", "ruler": "muted",
    "outside": "warning", "note": "error", "kind": "muted", "error": "error", "warning": "warning",
    "heading": "accent", "changed": "warning", "chart": "success", "says": "accent", "typed": "success",
    "row": "on-chosen", "selected": "on-chosen", **OF_COLOURS,
}  # fmt: skip
HOW = {
    "bold": {
        "robot",
        "other",
        "start",
        "goal",
        "outside",
        "error",
        "warning",
        "heading",
        "changed",
        *OF_COLOURS,
    },
    "italic": {"note", "name", "kind", "typed"},
    "reverse": {"robot", "other"},
}


def light(colour: str) -> float:
    """Relative luminance, as the web's guidelines for contrast define it."""
    parts = [int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)]
    red, green, blue = (
        part / 12.92 if part <= 0.03928 else ((part + 0.055) / 1.055) ** 2.4 for part in parts
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one: str, other: str) -> float:
    low, high = sorted((light(one), light(other)))
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize("name", RGB)
def test_every_role_of_a_theme_can_be_read_where_it_stands(name):
    """Text at 7 to 1, borders at 4.5 and the dots of the floor at 3."""
    palette = themes._PALETTES[name]
    texts = ("foreground", "muted", "accent", "success", "warning", "error")
    for surface in ("background", "surface", "panel"):
        assert [each for each in texts if contrast(palette[each], palette[surface]) < 7] == []
    assert [each for each in themes.COLOURS if contrast(palette[each], palette["background"]) < 7] == []
    assert contrast(palette["on-chosen"], palette["chosen"]) >= 7
    assert contrast(palette["border"], palette["background"]) >= 4.5
    assert 3 <= contrast(palette["faint"], palette["background"]) < 7


@pytest.mark.parametrize("name", themes.NAMES)
def test_what_widgets_paint_has_the_colour_of_its_role_and_is_written_so(name):
    palette, looks = themes._PALETTES[name], themes.looks(name)

    assert looks.keys() == PAINTED_AS.keys()
    for look, role in PAINTED_AS.items():
        assert looks[look].color == Color.parse(palette[role]).rich_color, look
        assert {how for how, its in HOW.items() if getattr(looks[look], how)} - {"reverse"} == {
            how for how, its in HOW.items() if look in its
        } - {"reverse"}, look
    behind = {"row": "chosen", "selected": "chosen", "ruler": "panel"}
    assert {each for each in looks if looks[each].bgcolor is not None} == behind.keys()
    assert all(looks[each].bgcolor == Color.parse(palette[role]).rich_color for each, role in behind.items())
    reversed_ = {each for each in looks if looks[each].reverse}
    assert reversed_ == HOW["reverse"] | ({"selected"} if name == themes.TERMINAL else set())
    assert [each for each in looks if looks[each].dim] == (["free"] if name == themes.TERMINAL else [])


@pytest.mark.parametrize("name", themes.NAMES)
def test_a_theme_of_textual_has_the_roles_and_names_that_textual_knows(name):
    palette, theme = themes._PALETTES[name], themes.theme(name)
    of_roles = {
        "primary": "accent",
        "secondary": "accent",
        "accent": "accent",
        "success": "success",
        "warning": "warning",
        "error": "error",
        "foreground": "foreground",
        "background": "background",
        "surface": "surface",
        "panel": "panel",
        "boost": "surface",
    }
    known = Theme(name="any", primary="#ffffff").to_color_system().generate()
    own = {"muted", "chosen", "on-chosen"}

    assert {field: getattr(theme, field) for field in of_roles} == {
        field: palette[role] for field, role in of_roles.items()
    }
    assert (theme.dark, theme.ansi) == (name != themes.LIGHT, name == themes.TERMINAL)
    assert own <= theme.variables.keys() <= own | known.keys() | {"ansi-background", "ansi-foreground"}
    assert {each: theme.variables[each] for each in own} == {each: palette[each] for each in own}
    assert theme.variables.pop("input-cursor-text-style") == "none"
    for colour in theme.variables.values():
        Color.parse(colour)
    chosen = (
        ("ansi_white", "ansi_black") if name == themes.TERMINAL else (palette["chosen"], palette["on-chosen"])
    )
    for kind in (
        "block-cursor",
        "block-cursor-blurred",
        "input-cursor",
        "input-selection",
        "screen-selection",
    ):
        assert (theme.variables[f"{kind}-background"], theme.variables[f"{kind}-foreground"]) == chosen
    assert {theme.variables[each] for each in ("text-muted", "text-disabled")} == {palette["muted"]}
    assert {theme.variables[each] for each in ("border", "border-blurred")} == {palette["border"]}
    assert (theme.variables["text"], theme.variables["block-hover-background"]) == (
        palette["foreground"],
        palette["panel"],
    )


@pytest.mark.parametrize("name", themes.NAMES)
def test_things_in_sixteen_colours_are_seven_different_ones_of_them(name):
    """The sixteen of a PC, and in the terminal's own look their names."""
    parts = ("00", "aa", "55", "ff")
    sixteen = {f"#{red}{green}{blue}" for red in parts for green in parts for blue in parts}
    styles = [themes.block_of_sixteen(name, each) for each in themes.COLOURS]

    assert len({each.color for each in styles}) == len(themes.COLOURS) == 7
    assert not any(each.bold for each in styles)
    if name != themes.TERMINAL:
        assert {each.color.name for each in styles} <= sixteen


@pytest.mark.parametrize("name", themes.NAMES)
def test_the_parts_of_a_program_differ_in_weight_and_slant_too(name):
    styles = themes.syntax_styles(name)

    assert {each: (bool(it.bold), bool(it.italic)) for each, it in styles.items()} == {
        "command": (True, False),
        "argument": (True, False),
        "number": (False, False),
        "string": (False, True),
        "comment": (False, True),
        "operator": (False, False),
    }
    roles = ("accent", "success", "warning", "orange", "muted", "foreground")
    for style, role in zip(styles.values(), roles, strict=True):
        expected = None if name == themes.TERMINAL else themes._PALETTES[name][role]
        assert (style.color.name if style.color else None) == expected


def test_a_theme_that_is_none_of_donnie_s_looks_as_the_terminal_s_own():
    assert themes.looks("textual-dark") == themes.looks(themes.TERMINAL)
    assert themes.syntax_styles("textual-dark") == themes.syntax_styles(themes.TERMINAL)
    assert themes.block_of_sixteen("textual-dark", "red") == themes.block_of_sixteen(themes.TERMINAL, "red")
    assert [themes.name_of(each) for each in THEMES] == [*themes.NAMES]
