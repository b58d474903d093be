"""The parts of the full screen, one by one: table of actions, rows, highlighting, copies."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from textual.app import App, ComposeResult
from textual.widgets import TextArea

from donnie_tui.commands.declarations import BY_NAME, COMMANDS
from donnie_tui.commands.interaction import Option
from donnie_tui.commands.lookup import find, word_of
from donnie_tui.core.document import ANOTHER_PROGRAM, Document
from donnie_tui.core.program_files import as_lines
from donnie_tui.settings.settings import SPEEDS
from donnie_tui.tui.highlighting import highlights
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
