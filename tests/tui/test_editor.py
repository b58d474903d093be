"""The editor by itself: lines, marks, notes, words that are offered, the selection, as they are painted."""

from types import SimpleNamespace

from textual.app import App, ComposeResult
from textual.events import Key, Paste
from textual.geometry import Offset
from textual.message import Message
from textual.widgets.text_area import Selection

from donnie_tui.core.completion import Completion, NextLine
from donnie_tui.core.program_text import LineMistake
from donnie_tui.tui import themes
from donnie_tui.tui.widgets import editor as module
from donnie_tui.tui.widgets.editor import LONGEST_WRAPPED, Editor

WIDTH, HEIGHT = 40, 8


class Writing(App[None]):
    """An editor of 40 columns and 8 rows, and what it posts."""

    CSS = "Editor { border: none; padding: 0; scrollbar-size: 0 0; overflow-y: scroll; }"

    def __init__(self, text: str = "") -> None:
        super().__init__()
        self.editor = Editor(id="editor")
        self.editor.styles.width, self.editor.styles.height = WIDTH, HEIGHT
        self.text = text
        self.posted: list[Message] = []
        self.keys: list[str] = []
        """Keys that the editor has left to others."""

    def compose(self) -> ComposeResult:
        yield self.editor

    def on_mount(self) -> None:
        self.register_theme(themes.theme(themes.DARK))
        self.theme = themes.DARK
        self.editor.show(self.text, frozenset())

    def on_key(self, event: Key) -> None:
        self.keys.append(event.key)

    def on_editor_line_word_typed(self, message: Message) -> None:
        self.posted.append(message)

    on_editor_gutter_clicked = on_editor_line_finished = on_editor_line_word_typed
    on_editor_edited = on_editor_looked = on_editor_line_word_typed

    def posted_of(self, kind: type[Message]) -> list[Message]:
        return [each for each in self.posted if isinstance(each, kind)]

    @property
    def rows(self) -> list[str]:
        return [self.editor.render_line(y).text.rstrip() for y in range(HEIGHT)]


# --- what a command in the program is


COMMANDS = [
    ("FW 1\nhelp\nBW 1", (1, 4), ("help", None), ["FW 1", "BW 1"]),
    ("FW 1\nhelp fw", (1, 7), ("help", "fw"), ["FW 1", ""]),
    ("help  ", (0, 4), ("help", None), [""]),
    ("help", (0, 3), None, ["hel", "p"]),
    ("help" + " " * 75, (0, 79), ("help", None), [""]),
    ("help" + " " * 76, (0, 80), None, ["help" + " " * 76, ""]),
    ("FW 1", (0, 4), None, ["FW 1", ""]),
]


async def test_enter_after_a_line_that_is_only_a_command_takes_it_out():
    async with Writing().run_test() as pilot:
        editor = pilot.app.editor
        for text, cursor, command, left in COMMANDS:
            editor.show(text, frozenset())
            editor.move_cursor(cursor)
            pilot.app.posted.clear()
            await pilot.press("enter")
            await pilot.pause()

            found = [(each.name, each.argument) for each in pilot.app.posted_of(Editor.LineWordTyped)]
            finished = [each.row for each in pilot.app.posted_of(Editor.LineFinished)]
            assert (found, finished) == (([command], []) if command else ([], [cursor[0]]))
            assert editor.document.lines == left
            assert not command or editor.cursor_location == (cursor[0], 0)
        assert pilot.app.keys == []


async def test_undo_that_is_typed_is_taken_out_as_it_was_typed_so_that_undo_is_about_what_was_before():
    async with Writing("FW 1\n").run_test() as pilot:
        editor = pilot.app.editor
        editor.move_cursor((0, 4))
        await pilot.press("2")
        editor.move_cursor((1, 0))
        await pilot.press(*"undo", "enter")
        await pilot.pause()
        assert [each.name for each in pilot.app.posted_of(Editor.LineWordTyped)] == ["undo"]
        assert editor.document.lines == ["FW 12", ""]
        editor.undo()
        assert editor.document.lines == ["FW 1", ""]
        editor.show("undo", frozenset())  # which was not typed
        editor.move_cursor((0, 4))
        await pilot.press("enter")
        assert editor.document.lines == ["undo"]


async def test_a_command_ends_the_block_whose_end_was_typed_a_second_time():
    async with Writing().run_test() as pilot:
        editor = pilot.app.editor
        doubled = NextLine("", "", doubled=True)
        for next_line, is_typed, lines in (
            (doubled, True, ["END", "FW"]),
            (doubled, False, ["END", "END", "FW"]),
            (NextLine("", ""), True, ["END", "END", "FW"]),
            (None, True, ["END", "END", "FW"]),
        ):
            editor.show("END\nEND\nFW", frozenset())
            editor.next_line = None if next_line is None else lambda *_, found=next_line: found
            editor.is_typed = is_typed
            editor.finish_typed_end()
            assert editor.document.lines == lines
            assert editor.is_typed is (is_typed and next_line is not doubled)


async def test_a_command_that_is_selected_is_none():
    async with Writing("help").run_test() as pilot:
        pilot.app.editor.select(0, 0, 4)
        await pilot.press("enter")
        assert pilot.app.editor.document.lines == ["", ""]
        assert pilot.app.posted_of(Editor.LineWordTyped) == []


ENTERED = [
    ("DO", (0, 2), NextLine("", "  ", "END"), ["DO", "  ", "END"], (1, 2)),
    ("  fw", (0, 4), NextLine("", ""), ["fw", ""], (1, 0)),
    ("  fw", (0, 4), NextLine("  ", "  "), ["  fw", "  "], (1, 2)),
    ("   fw", (0, 5), NextLine("  ", "  "), ["  fw", "  "], (1, 2)),
    ("fw", (0, 2), NextLine("  ", "  "), ["  fw", "  "], (1, 2)),
    ("fw  ", (0, 2), NextLine("", ""), ["fw  ", ""], (1, 0)),
    ("  fw 1", (0, 4), NextLine("", "xx"), ["  fw", "   1"], (1, 2)),
    ("  fw 1", (0, 1), NextLine("", "xx"), [" ", "  fw 1"], (1, 1)),
    ("END\nEND\nFW", (0, 3), NextLine("", "", doubled=True), ["END", "", "FW"], (1, 0)),
]


async def test_enter_writes_the_next_line_only_at_the_end_of_a_line():
    async with Writing().run_test() as pilot:
        editor = pilot.app.editor
        for text, cursor, found, lines, after in ENTERED:
            editor.show(text, frozenset())
            editor.next_line = lambda *_, found=found: found
            editor.move_cursor(cursor)
            await pilot.press("enter")

            assert (editor.document.lines, editor.cursor_location) == (lines, after)
        assert pilot.app.keys == []
        editor.show("FW 1", frozenset())
        editor.next_line = lambda *_: NextLine("", "", "END")
        editor.select(0, 0, 2)
        await pilot.press("enter")
        assert editor.document.lines == ["", " 1"], "what is selected is replaced"


async def test_without_line_numbers_enter_writes_a_new_line_and_nothing_else():
    async with Writing("DO").run_test() as pilot:
        editor = pilot.app.editor
        editor.next_line = lambda *_: NextLine("", "  ", "END")
        editor.show_line_numbers = False
        editor.move_cursor((0, 2))
        await pilot.press("enter")

        assert editor.document.lines == ["DO", ""]


# --- marks, notes


def mistake(message: str, *, is_hint: bool = False) -> LineMistake:
    return LineMistake(1, message, is_hint, 0, 0, "", 1)


async def test_marks_stand_before_the_numbers_and_sentences_after_the_lines():
    async with Writing("FW 1\nFW 2\nFW 3\nFW 4").run_test() as pilot:
        editor = pilot.app.editor
        editor.mark(2, frozenset({3}), ("3 + 4 = 7", "7"))
        editor.note({1: mistake("Wrong."), 4: mistake("Better.", is_hint=True)})
        editor.breakpoints = frozenset({3, 4})
        await pilot.pause()
        assert pilot.app.rows[:4] == [
            " !1  FW 1  ! Wrong.", "> 2  FW 2  > 3 + 4 = 7", "*B3  FW 3", " B4  FW 4  ? Better."
        ]  # fmt: skip
        assert editor.mistakes == (mistake("Wrong."), mistake("Better.", is_hint=True))
        assert editor.mistake == mistake("Wrong.")
        editor.go_to(2)
        assert editor.mistake is None
        marked = next(iter(editor.render_line(1)))
        assert (marked.text, marked.style.bold) == ("> ", True)
        note = [each for each in editor.render_line(0) if "Wrong" in each.text]
        assert [each.style.color for each in note] == [themes.looks(themes.DARK)["note"].color]
        worked = [each for each in editor.render_line(1) if "7" in each.text]
        assert [each.style.color for each in worked] == [themes.looks(themes.DARK)["kind"].color]

        editor.mark(None)
        editor.note({})
        editor.breakpoints = frozenset()
        assert pilot.app.rows[:4] == ["  1  FW 1", "  2  FW 2", "  3  FW 3", "  4  FW 4"]


NOTES = [
    (10, "x" * 21, "! " + "x" * 21),
    (10, "x" * 22, "! " + "x" * 18 + "..."),
    (21, "x" * 30, "! " + "x" * 7 + "..."),
    (22, "x" * 30, ""),
    (22, "x" * 9, "! " + "x" * 9),
    (22, "x" * 10, ""),
]


async def test_a_sentence_after_a_line_is_cut_where_twelve_columns_are_left_and_not_shown_below():
    """Of the 40 columns the numbers take five, and two are between the line and its sentence."""
    async with Writing().run_test() as pilot:
        await pilot.pause()
        for length, message, shown in NOTES:
            pilot.app.editor.show("a" * length, frozenset())
            pilot.app.editor.note({1: mistake(message)})
            assert pilot.app.rows[0] == f" !1  {'a' * length}  {shown}".rstrip()


async def test_what_a_line_works_out_is_as_long_as_there_is_room_for():
    async with Writing("a" * 16).run_test() as pilot:
        editor = pilot.app.editor
        for working, shown in (
            (("x" * 15, "short"), "x" * 15),
            (("x" * 16, "short"), "short"),
            (("x" * 18, "y" * 17), "y" * 12 + "..."),
        ):
            editor.mark(1, working=working)
            await pilot.pause()
            assert pilot.app.rows[0] == f"> 1  {'a' * 16}  > {shown}"


async def test_a_line_of_two_rows_has_its_mark_in_the_first_and_its_sentence_after_the_last():
    async with Writing("a" * 20 + " " + "b" * 20 + "\nFW").run_test() as pilot:
        editor = pilot.app.editor
        editor.mark(1)
        editor.note({1: mistake("Wrong."), 2: mistake("Too.")})
        await pilot.pause()

        assert pilot.app.rows[:3] == [
            ">!1  " + "a" * 20, "     " + "b" * 20 + "  ! Wrong.", " !2  FW  ! Too."
        ]  # fmt: skip


async def test_only_the_gutters_and_rows_that_changed_are_painted(monkeypatch):
    async with Writing("FW 1\n" + "a" * 20 + " " + "b" * 20 + "\nFW 3").run_test() as pilot:
        editor = pilot.app.editor
        await pilot.pause()
        painted = []
        monkeypatch.setattr(editor, "refresh", lambda *regions, **_: painted.append(sorted(regions)))
        editor.mark(1, frozenset({3}))
        editor.mark(2, frozenset({3}))
        editor.mark(2, frozenset({3}))
        editor.mark(9)
        editor.note({2: mistake("Wrong.")})
        editor.note({2: mistake("Wrong.")})
        editor.note({2: mistake("Wrong."), 3: mistake("New.")})
        editor.mark(9, working=("x",))
        editor.breakpoints = frozenset()
        editor.breakpoints = frozenset({1})

        first, second, third = (0, 0, 2, 1), (0, 1, 2, 1), (0, 3, 2, 1)
        assert painted == [
            [first, third], [first, second], [second, third], [(0, 1, WIDTH, 2)], [(0, 3, WIDTH, 1)], [], []
        ]  # fmt: skip


async def test_a_click_next_to_a_line_is_meant_for_it_and_moves_no_cursor():
    async with Writing("FW 1\n" + "a" * 20 + " " + "b" * 20 + "\nFW 3").run_test() as pilot:
        editor = pilot.app.editor
        await pilot.pause()
        for place, line in (((4, 0), 1), ((5, 0), None), ((0, 2), 2), ((0, 3), 3), ((0, 4), None)):
            editor.go_to(3, 3)
            pilot.app.posted.clear()
            await pilot.click(editor, offset=Offset(*place))

            assert [each.line for each in pilot.app.posted_of(Editor.GutterClicked)] == (
                [line] if line else []
            )
            assert (editor.cursor_location == (2, 2)) is bool(line)


STEPS = ("EXAMPLES, Enter: programs to try", "walk, then see", "FW, Enter", "EXAMPLES Enter", "OUTLINE, x")


async def test_a_click_on_a_command_among_the_first_steps_runs_it_and_moves_no_cursor():
    async with Writing().run_test() as pilot:
        editor = pilot.app.editor
        editor.show_first_steps(STEPS)
        await pilot.pause()
        for row, name in (
            (0, None),
            (1, "examples"),
            (2, None),
            (3, None),
            (4, None),
            (5, "outline"),
            (6, None),
        ):
            pilot.app.posted.clear()
            await pilot.click(editor, offset=Offset(8, row))
            commands = [(each.name, each.argument) for each in pilot.app.posted_of(Editor.LineWordTyped)]
            assert commands == ([(name, None)] if name else [])
        for change in (lambda: setattr(editor, "show_line_numbers", False), lambda: editor.insert("FW")):
            editor.show_line_numbers = True
            change()
            pilot.app.posted.clear()
            await pilot.click(editor, offset=Offset(8, 1))
            assert pilot.app.posted_of(Editor.LineWordTyped) == []


# --- the line that runs


async def test_the_line_that_runs_is_kept_in_sight_a_third_from_above_and_once_a_second(monkeypatch):
    """In eight rows a third is two."""
    now = [100.0]
    monkeypatch.setattr(module, "time", SimpleNamespace(monotonic=lambda: now[0]))
    async with Writing("\n".join(f"FW {at}" for at in range(1, 31))).run_test() as pilot:
        editor = pilot.app.editor
        await pilot.pause()
        editor.follow(20)
        assert editor.scroll_offset.y == 0, "nothing is followed yet"
        editor.begin_following()
        for seconds, line, top in (
            (0, 8, 0),
            (0, 31, 0),
            (0, 9, 6),
            (0.9, 1, 6),
            (0.1, 7, 6),
            (0, 6, 3),
            (1, 30, 22),
            (1, 1, 0),
        ):
            now[0] += seconds
            editor.follow(line)
            assert (line, editor.scroll_offset.y, editor.cursor_location) == (line, top, (0, 0))


async def test_what_the_learner_moves_is_left_alone_until_the_next_run(monkeypatch):
    now = [100.0]
    monkeypatch.setattr(module, "time", SimpleNamespace(monotonic=lambda: now[0]))

    def after(*lines: int) -> int:
        for line in lines:
            now[0] += 2
            editor.follow(line)
        return editor.scroll_offset.y

    async with Writing("\n".join(f"FW {at}" for at in range(1, 31))).run_test() as pilot:
        editor = pilot.app.editor
        await pilot.pause()
        for move in (
            lambda: editor.scroll_to(y=2, animate=False, force=True, immediate=True),
            lambda: editor.go_to(2),
        ):
            editor.go_to(1)
            editor.begin_following()
            assert after(15) == 12
            move()
            top = editor.scroll_offset.y
            assert after(28, 1) == top
            editor.end_following()
            assert editor.scroll_offset.y == top
        editor.go_to(1)
        editor.begin_following()
        assert after(15) == 12
        editor.styles.height = 6  # another size is no move of the learner
        await pilot.pause()
        assert after(3, 25) == 22
        editor.end_following()
        assert editor.scroll_offset.y == 0, "where the cursor is"
        assert after(25) == 0
        editor.begin_following()
        editor.scroll_to(y=5, animate=False, force=True, immediate=True)
        editor.begin_following()
        editor.follow(7)
        editor.end_following()
        assert editor.scroll_offset.y == 5, "nothing was scrolled"


# --- what is offered


OFFERED = [
    ("RE", (0, 2), "RE", ("REPEAT", "REAL"), "PEAT"),
    ("R", (0, 1), "R", ("REPEAT", "REAL"), ""),
    ("R", (0, 1), "R", ("REPEAT",), "EPEAT"),
    ("", (0, 0), "", ("REPEAT",), ""),
    ("RE", (0, 1), "R", ("REPEAT",), ""),
    ("RE", (0, 2), "RE", (), ""),
]


async def test_a_word_is_offered_after_two_letters_or_one_if_it_is_the_only_one():
    async with Writing().run_test() as pilot:
        editor = pilot.app.editor
        for text, cursor, typed, words, offered in OFFERED:
            editor.show(text, frozenset())
            editor.complete = None
            editor.update_suggestion()
            assert editor.suggestion == ""
            found = Completion(typed, words)
            editor.complete = lambda *_, found=found: found
            editor.move_cursor(cursor)
            editor.update_suggestion()
            assert editor.suggestion == offered
            editor.move_cursor((0, 0))
            assert not offered or editor.suggestion == ""


async def test_a_chosen_word_stands_in_place_of_the_letters_before_the_cursor():
    async with Writing("FW 1\nFW 2 REP FW").run_test() as pilot:
        editor = pilot.app.editor
        editor.move_cursor((1, 8))
        editor.put_in_place_of("REP", "REPEAT")
        assert editor.document.lines == ["FW 1", "FW 2 REPEAT FW"]
        assert editor.cursor_location == (1, 11)


async def test_the_cursor_goes_as_near_as_there_is_text():
    async with Writing("FW 1\nFW 2").run_test() as pilot:
        editor = pilot.app.editor
        for line, column, place in (
            (1, 1, (0, 0)), (0, 0, (0, 0)), (2, 3, (1, 2)), (9, 9, (1, 4)), (1, 6, (0, 4)), (2, 5, (1, 4))
        ):  # fmt: skip
            editor.go_to(line, column)
            assert (editor.cursor_location, editor.line) == (place, place[0] + 1)


async def test_the_word_at_the_cursor_or_right_before_it():
    async with Writing("FW  ação + x").run_test() as pilot:
        for column, word in ((0, "FW"), (2, "FW"), (3, ""), (4, "ação"), (8, "ação"), (9, ""), (12, "x")):
            pilot.app.editor.move_cursor((0, column))
            assert pilot.app.editor.word == word


async def test_offsets_count_the_ends_of_lines():
    async with Writing("FW 1\n\nFW 2").run_test() as pilot:
        editor = pilot.app.editor
        places = [(0, 0), (0, 4), (1, 0), (2, 0), (2, 4)]
        assert [editor.offset_of(each) for each in places] == [0, 4, 5, 6, 10]
        assert [editor.location_of(each) for each in (0, 4, 5, 6, 10, 11)] == [*places, (2, 4)]
        editor.move_cursor((2, 1))
        assert editor.offset_of_cursor == 7


# --- changes of the text


async def test_breakpoints_move_with_their_lines_in_edits_undo_and_redo():
    async with Writing("FW 1\nFW 2\nFW 3").run_test() as pilot:
        editor = pilot.app.editor
        editor.breakpoints = frozenset({1, 3})
        editor.insert("FW 0\n", (1, 0))
        assert editor.breakpoints == {1, 4}
        editor.insert("FW 0\n", (0, 0))
        assert editor.breakpoints == {2, 5}
        editor.undo()
        editor.undo()
        assert editor.breakpoints == {1, 3}
        editor.redo()
        assert editor.breakpoints in ({1, 4}, {2, 5})
        editor.show("FW 1\nFW 2\nFW 3", frozenset({2, 3}))
        editor.delete((1, 0), (2, 0))
        assert editor.breakpoints == {2}
        editor.insert(" x", (0, 4))
        assert editor.breakpoints == {2}


async def test_only_keys_are_typing():
    async with Writing("FW 1").run_test() as pilot:
        editor = pilot.app.editor
        for change in (
            lambda: editor.show("FW 1", frozenset()),
            lambda: editor.change_lines(["FW 2"]),
            lambda: editor.replace_range(0, 2, "BW"),
            editor.undo,
            editor.redo,
        ):
            await pilot.press("x")
            assert editor.is_typed
            change()
            assert not editor.is_typed


async def test_a_very_long_line_is_one_row_that_scrolls():
    async with Writing("FW 1").run_test() as pilot:
        editor = pilot.app.editor
        editor.insert("x" * (LONGEST_WRAPPED - 4), (0, 4))
        assert editor.soft_wrap
        editor.insert("x", (0, 4))
        assert not editor.soft_wrap
        await pilot.pause()
        assert editor.render_line(0).cell_length == WIDTH
        editor.undo()
        assert editor.soft_wrap
        editor.redo()
        assert not editor.soft_wrap
        editor.show("FW 1", frozenset())
        assert editor.soft_wrap


async def test_a_change_of_lines_is_one_edit_of_what_differs():
    async with Writing("a\nb\nc").run_test() as pilot:
        editor = pilot.app.editor
        edits = []
        editor.history.record = edits.append
        for lines in (["a", "x", "c"], ["a", "x"], ["a", "x"], ["y"], []):
            editor.change_lines(lines)
            assert editor.document.lines == (lines or [""])
        changed = [(each.from_location, each.to_location, each.text) for each in edits]
        assert changed == [
            ((1, 0), (2, 0), "x\n"), ((1, 1), (2, 1), ""), ((0, 0), (1, 1), "y"), ((0, 0), (0, 1), "")
        ]  # fmt: skip


async def test_a_text_that_ends_with_its_last_line_still_does():
    async with Writing("a\nb\n").run_test() as pilot:
        editor = pilot.app.editor
        editor.change_lines(["a", "c"])
        assert editor.document.lines == ["a", "c", ""]
        editor.change_lines(["a", ""])
        assert editor.document.lines == ["a", "", ""]
        editor.show("", frozenset())
        editor.change_lines(["a"])
        assert editor.document.lines == ["a"], "an empty text has no last line to keep"


async def test_a_letter_repaints_its_line_and_what_changes_others_repaints_all(monkeypatch):
    text = "FW 1\n" + "a" * 20 + " " + "b" * 20 + "\nFW 3"
    async with Writing(text).run_test() as pilot:
        editor = pilot.app.editor
        await pilot.pause()
        painted = []
        refresh = module.TextArea.refresh

        def refreshed(self, *regions, **how):
            painted.append(tuple(map(tuple, regions)))
            return refresh(self, *regions, **how)

        monkeypatch.setattr(module.TextArea, "refresh", refreshed)
        editor.insert("x", (0, 4))
        assert painted == [((0, 0, WIDTH, 1),)]
        painted.clear()
        editor.insert("x", (2, 4))
        assert painted == [((0, 3, WIDTH, 1),)]
        painted.clear()
        editor.insert("x", (1, 41))
        assert painted == [((0, 1, WIDTH, 2),)]
        for change in (
            lambda: editor.insert("\n", (0, 0)),
            lambda: editor.insert("c" * 40, (1, 0)),
            lambda: editor.delete((0, 0), (1, 0)),
            lambda: editor.insert('SPEAK "', (0, 0)),  # the strings of the other lines end there
        ):
            painted.clear()
            change()
            assert () in painted
        editor.show("", frozenset())
        below = ((0, 1, WIDTH, HEIGHT - 1),)
        for change, is_painted in ((lambda: editor.insert("F"), True), (lambda: editor.insert("W"), False)):
            painted.clear()
            change()
            assert (below in painted) is is_painted


# --- how it looks


async def test_the_editor_has_the_colours_of_the_theme_and_leaves_tab_to_the_screen():
    async with Writing("FW 1").run_test() as pilot:
        app, editor = pilot.app, pilot.app.editor
        await pilot.pause()
        for name in (themes.DARK, themes.LIGHT):
            if name != themes.DARK:
                app.register_theme(themes.theme(name))
                app.theme = name
                await pilot.pause()
            assert editor.theme == name
            number = next(each.style for each in editor.render_line(0) if each.text == "1")
            assert number.color == themes.syntax_styles(name)["number"].color
        assert (editor.cursor_blink, editor.tab_behavior, editor.soft_wrap) == (False, "focus", True)
        editor.suggestion = "offered"
        editor.blur()
        await pilot.pause()
        assert editor.suggestion == ""


async def test_an_empty_program_shows_first_steps_below_its_first_line_until_something_is_typed():
    async with Writing().run_test() as pilot:
        editor = pilot.app.editor
        editor.show_first_steps(("Type FW 3.", "Press F5."))
        await pilot.pause()
        assert pilot.app.rows[:4] == ["  1", "     Type FW 3.", "     Press F5.", ""]
        step = next(each for each in editor.render_line(1) if "FW" in each.text)
        assert (step.style.italic, step.style.color) == (True, themes.looks(themes.DARK)["kind"].color)
        await pilot.press("F")
        assert pilot.app.rows[:2] == ["  1  F", ""]
        await pilot.press("backspace")
        assert pilot.app.rows[1] == "     Type FW 3."
        editor.show_line_numbers = False
        await pilot.pause()
        assert "Type" not in "".join(pilot.app.rows)


async def test_without_numbers_the_columns_for_marks_are_still_there():
    async with Writing("FW 1\nFW 2").run_test() as pilot:
        editor = pilot.app.editor
        editor.show_line_numbers = False
        editor.mark(2)
        await pilot.pause()
        assert (pilot.app.rows[:2], editor.gutter_width) == (["  FW 1", "> FW 2"], 2)
        assert editor.render_line(0).cell_length == WIDTH


SELECTED = [
    ((0, 1), (0, 3), ["W 1", "", ""]),
    ((0, 2), (2, 1), [" 1", " ", "BW"]),
    ((2, 4), (0, 0), ["FW 1", " ", "BW 2"]),
    ((1, 0), (1, 0), ["", " ", ""]),
]


async def test_the_selection_has_its_colours():
    """The cursor, at its last place, has them too."""
    async with Writing("FW 1\n\nBW 2").run_test() as pilot:
        editor = pilot.app.editor
        colour = themes.looks(themes.DARK)["selected"].bgcolor
        for first, last, chosen in SELECTED:
            editor.selection = Selection(first, last)
            await pilot.pause()
            rows = [[each for each in editor.render_line(y) if each.style] for y in range(3)]
            found = ["".join(each.text for each in row if each.style.bgcolor == colour) for row in rows]
            assert found == chosen


async def test_the_selection_of_a_row_that_scrolls_has_its_colours_where_it_is(monkeypatch):
    monkeypatch.setattr(module, "LONGEST_WRAPPED", 50)
    text = "0123456789" * 6
    async with Writing(text).run_test() as pilot:
        editor = pilot.app.editor
        colour = themes.looks(themes.DARK)["selected"].bgcolor
        for first, last in (((0, 50), (0, 53)), ((0, 3), (0, 53)), ((0, 3), (0, 6))):
            editor.selection = Selection(first, last)
            await pilot.pause()
            hidden = int(editor.scroll_offset.x)
            row = [each for each in editor.render_line(0) if each.style]
            assert hidden
            assert (
                "".join(each.text for each in row if each.style.bgcolor == colour)
                == (
                    text[max(first[1], hidden) : last[1] + 1]  # the cursor has it, too
                )
            )


async def test_a_change_and_a_new_place_of_the_cursor_are_posted_to_the_application():
    async with Writing("FW 1").run_test() as pilot:
        await pilot.pause()
        pilot.app.posted.clear()
        await pilot.press("right")
        await pilot.pause()
        assert [type(each) for each in pilot.app.posted] == [Editor.Looked]
        await pilot.press("x")
        await pilot.pause()
        assert pilot.app.posted_of(Editor.Edited)


async def test_pasted_text_has_no_signs_that_a_program_can_t_have():
    async with Writing().run_test() as pilot:
        pilot.app.post_message(Paste("FW\x1b 1\r\nSPEAK \u201chi\u201d"))
        await pilot.pause()
        assert "\x1b" not in pilot.app.editor.text
        assert pilot.app.editor.text.count("FW") == 1
