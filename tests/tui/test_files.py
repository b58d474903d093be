"""Files at the screen: what it begins with, its title, and what is left behind when it ends."""

import asyncio
import threading
from contextlib import nullcontext
from pathlib import Path

import pytest
from textual.events import MouseScrollDown, MouseScrollUp
from textual.geometry import Offset

from donnie_tui.i18n.words import Words
from donnie_tui.tui.screens.file_panel import FilePanel
from tests.timeouts import TIMEOUT
from tests.tui.test_dialogs import OPEN, Showing

pytestmark = pytest.mark.slow


@pytest.fixture
def program(tmp_path: Path) -> Path:
    path = tmp_path / "walk.gd"
    path.write_text("FW 1\nTR 90\n", encoding="utf-8")
    return path


async def test_a_file_of_the_command_line_is_open_at_the_start(open_screen, program):
    async with open_screen(file=program) as screen:
        assert screen.main.editor.text == "FW 1\nTR 90"
        await screen.shows("Opened walk.gd, 2 lines.")
        assert ">Program: walk.gd " in screen.text


async def test_a_missing_file_is_reported(open_screen, tmp_path):
    async with open_screen(file=tmp_path / "none.gd") as screen:
        await screen.shows("There is no file")


async def test_esc_goes_back_from_a_question(open_screen):
    async with open_screen("FW 1") as screen:
        await screen.press("ctrl+o")
        await screen.until(lambda: screen.app.screen is not screen.main, "the question")
        await screen.press("escape")
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")

        assert screen.main.editor.text == "FW 1"
        assert screen.main.editor.has_focus


async def test_save_writes_the_file_and_the_title_says_changed_until_then(open_screen, program):
    async with open_screen(file=program) as screen:
        await screen.press("S", "P", "space")
        await screen.until(lambda: "Program: walk.gd, changed" in screen.text, "the title")
        await screen.press("ctrl+s")
        await screen.shows("Saved walk.gd")

        assert program.read_text(encoding="utf-8") == "SP FW 1\nTR 90\n"
        await screen.until(lambda: "changed" not in screen.text, "the title")


async def test_cancelling_the_question_keeps_the_program(open_screen):
    async with open_screen("FW 2") as screen:
        await screen.press("ctrl+q")
        await screen.until(lambda: screen.app.screen is not screen.main, "the question")
        await screen.press("escape")
        await screen.pilot.pause()

        assert screen.app.is_running
        assert screen.main.editor.text == "FW 2"


async def test_a_discarded_program_is_not_announced_and_restored_by_recover(open_screen, tmp_path):
    async with open_screen("FW 2") as screen:
        await screen.press("ctrl+q")
        await screen.answer("no")
        await screen.until(lambda: not screen.app.is_running, "the end")
    assert [each.read_text() for each in (tmp_path / "unsaved").iterdir()] == ["FW 2\n"]

    async with open_screen() as screen:
        await screen.type_line("RECOVER")
        await screen.shows("Your program is back, 1 line.")
        assert screen.main.editor.text == "FW 2"
        assert "A program was kept. RECOVER opens it." not in screen.log


async def test_linear_leaves_with_the_text_and_its_file_and_rescues_the_other_programs(
    open_screen, program, tmp_path
):
    async with open_screen(file=program) as screen:
        await screen.press("X")
        workspace = screen.app.controller.workspace
        workspace.turn_to(workspace.add_document())
        screen.load("FW 3")
        workspace.turn_to(workspace.documents[0])
        await screen.type_line("linear")
        await screen.until(lambda: not screen.app.is_running, "the end")

        assert screen.app.session.left_for_linear
        assert screen.main.editor.text == "XFW 1\nTR 90"
        assert screen.app.controller.workspace.document.path == program
    assert [each.read_text() for each in (tmp_path / "unsaved").iterdir()] == ["FW 3\n"]


async def test_a_saved_program_is_left_without_a_question(open_screen, program):
    async with open_screen(file=program) as screen:
        await screen.press("ctrl+q")
        await screen.until(lambda: not screen.app.is_running, "the end")

        assert screen.app.return_code == 0


async def test_typed_lines_are_copied_soon(open_screen, tmp_path):
    async with open_screen() as screen:
        await screen.press("F", "W")
        await screen.until(lambda: any((tmp_path / "unsaved").glob("*.gd")), "a copy")


async def test_a_copy_of_a_crash_is_offered_and_restored_as_unsaved(open_screen, tmp_path):
    (tmp_path / "unsaved").mkdir()
    (tmp_path / "unsaved" / "unsaved-abc.gd").write_text("FW 9\nFW 8", encoding="utf-8")
    async with open_screen() as screen:
        await screen.shows("A program was kept.")
        await screen.type_line("RECOVER")
        await screen.shows("Your program is back, 2 lines.")

        assert screen.main.editor.text == "FW 9\nFW 8"
        assert "changed" in screen.text


def no_copy_is_written() -> bool:
    return all(each.name != "copies" for each in threading.enumerate())


async def test_an_unwritable_state_folder_is_reported_once(open_screen, tmp_path):
    (tmp_path / "unsaved").write_text("a file in its place")
    async with open_screen("FW 1") as screen:
        screen.app.controller.workspace.keep_copies()
        await screen.shows("What you type can't be kept safe")
        screen.main.editor.insert("FW 2")
        screen.app.controller.workspace.keep_copies()
        await screen.until(no_copy_is_written, "the second try")

        assert sum("kept safe" in line for line in screen.log) == 1


async def test_a_program_from_the_other_mode_keeps_its_file_and_its_changes(open_screen, program):
    async with open_screen("FW 1\nTR 90\nFW 7\n", file=program) as screen:
        assert screen.main.editor.text == "FW 1\nTR 90\nFW 7"
        assert "Program: walk.gd, changed" in screen.text


async def test_a_wrong_answer_to_yes_or_no_is_reported_and_typed_over(open_screen, tmp_path):
    there = tmp_path / "there.txt"
    there.write_text("kept")
    async with open_screen() as screen:
        await screen.type_line(f"SAVE LOG {there}")
        await screen.answer("perhaps")
        asked = screen.app.screen.query_one("#asked")
        await screen.until(lambda: str(asked.render()).startswith("Type y or n."), "the way to answer")
        await screen.press("n", "o", "enter")
        await screen.until(lambda: screen.app.screen is screen.main, "the answer")
        assert there.read_text() == "kept"

        await screen.type_line(f"SAVE LOG {there}")
        await screen.answer("yes")
        await screen.until(lambda: "> SAVE LOG" in there.read_text(), "the log")


# --- the tree of programs


@pytest.fixture
def lessons(tmp_path, monkeypatch):
    """Programs in the folder and in another one."""
    folder = tmp_path / "programs"
    (folder / "lessons" / "old").mkdir(parents=True)
    for name in ("square.gd", "stairs.gd", "lessons/first.gd", "lessons/old/zero.gd"):
        (folder / name).write_text(f'SPEAK "{name}"\n')
    (folder / "notes.txt").write_text("no program")
    (folder / ".hidden.gd").write_text("FW 9")
    monkeypatch.chdir(folder)
    return folder


def rows_of(screen) -> list[str]:
    """The rows of the tree that are seen, without the column of the mark."""
    region = screen.app.screen.files.region
    lines = screen.text.splitlines()[region.y : region.bottom]
    return [line[region.x + 1 : region.right].rstrip() for line in lines if line[region.x :].strip(" |")]


async def tree_of_files(screen, row: str = "stairs.gd") -> list[str]:
    await screen.until(lambda: screen.app.screen is not screen.main, "the panel")
    await screen.until(lambda: any(row in each for each in rows_of(screen)), row)
    await screen.painted()
    return rows_of(screen)


async def click_on(screen, text: str) -> None:
    lines = screen.text.splitlines()
    y = next(at for at, line in enumerate(lines) if text in line)
    await screen.pilot.click(offset=(lines[y].index(text), y))
    await screen.painted()


@pytest.mark.parametrize("size", [(80, 24), (40, 12), (20, 5)])
async def test_open_shows_the_programs_and_the_arrows_choose_one(open_screen, lessons, size):
    async with open_screen(size=size) as screen:
        await screen.press("ctrl+o")
        await screen.until(lambda: screen.app.screen is not screen.main, "the panel")
        files = screen.app.screen.files
        await screen.until(lambda: files.last_line >= 4, "the rows")
        await screen.press("down", "down", "down", "down")
        await screen.painted()
        assert "> stairs.gd" in " ".join(screen.text.split()).replace(">  ", "> ")
        await screen.press("enter")
        await screen.shows("Opened stairs.gd")


async def test_only_programs_and_folders_are_shown_hidden_ones_not(open_screen, lessons):
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        rows = await tree_of_files(screen)

        assert [each.strip() for each in rows[1:]] == [
            "../  the folder above",
            "square.gd",
            "stairs.gd",
            "+ lessons/",
        ]


async def test_recent_programs_come_first_wherever_they_are(open_screen, lessons, tmp_path_factory):
    other = tmp_path_factory.mktemp("other") / "far.gd"
    other.write_text("FW 1\n")
    async with open_screen(file=other) as screen:
        await screen.shows("Opened far.gd")
        await screen.type_line("OPEN stairs.gd")
        await screen.shows("Opened stairs.gd")
        await screen.press("ctrl+o")
        rows = await tree_of_files(screen, "square.gd")

        assert rows[0].strip() == "- Recent programs"
        assert rows[1].split()[0] == "stairs.gd"
        assert rows[2].split()[0] == "far.gd"
        await screen.press("enter", "down", "enter")
        await screen.shows("Opened far.gd")


async def test_enter_with_nothing_typed_chooses_the_first_program_and_then_opens_it(open_screen, lessons):
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await tree_of_files(screen)
        await screen.press("enter")
        await screen.until(lambda: screen.app.screen.files.row is not None, "the chosen row")
        await screen.painted()
        assert any(line.split()[:2] == [">", "square.gd"] for line in screen.text.splitlines())
        await screen.press("enter")

        await screen.until(lambda: screen.app.screen is screen.main, "the program")
        assert "Program: square.gd" in screen.text


async def test_folders_open_and_close_in_place_by_the_arrows(open_screen, lessons):
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await tree_of_files(screen)
        await screen.press("down", "end", "right")
        await tree_of_files(screen, "first.gd")
        await screen.press("right", "down", "right")
        rows = await tree_of_files(screen, "zero.gd")
        assert [each.strip(" >") for each in rows[-4:]] == ["- lessons/", "first.gd", "- old/", "zero.gd"]

        await screen.press("left")
        await screen.until(lambda: not any("zero.gd" in each for each in rows_of(screen)), "closed")
        await screen.press("left", "left")
        await screen.until(lambda: not any("first.gd" in each for each in rows_of(screen)), "closed")
        await screen.press("enter", "down", "enter")
        await screen.shows("Opened first.gd")


async def test_a_folder_and_a_program_are_opened_by_the_mouse_alone(open_screen, lessons):
    async with open_screen() as screen:
        await screen.pilot.click(screen.main.program_pane._heading, offset=(3, 0))
        await tree_of_files(screen)
        await click_on(screen, "lessons/")
        await tree_of_files(screen, "first.gd")
        await click_on(screen, "lessons/")
        await screen.until(lambda: not any("first.gd" in each for each in rows_of(screen)), "closed")
        await click_on(screen, "lessons/")
        await tree_of_files(screen, "first.gd")
        await click_on(screen, "first.gd")
        await screen.shows("Opened first.gd")


async def test_the_folder_above_is_a_row(open_screen, lessons, monkeypatch):
    monkeypatch.chdir(lessons / "lessons")
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await tree_of_files(screen, "first.gd")
        await click_on(screen, "../")
        rows = await tree_of_files(screen)
        assert any("- lessons/" in each for each in rows)
        await screen.press(*"sta", "enter")
        await screen.shows("Opened stairs.gd")


async def test_what_is_typed_narrows_the_tree_and_enter_takes_the_only_one_that_fits(open_screen, lessons):
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await tree_of_files(screen)
        await screen.press(*"sq")
        await screen.until(lambda: not any("stairs" in each for each in rows_of(screen)), "the fitting one")
        await screen.press("enter")
        await screen.shows("Opened square.gd")


async def test_a_file_of_the_typed_name_comes_before_what_fits(open_screen, lessons):
    (lessons / "sq").write_text("FW 7\n")
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await tree_of_files(screen)
        await screen.press(*"sq", "enter")
        await screen.shows("Opened sq,")


async def test_several_that_fit_are_counted_and_nothing_is_opened(open_screen, lessons):
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await tree_of_files(screen)
        await screen.press("s", "enter")
        await screen.until(lambda: "2 programs fit." in screen.text, "the number")
        await screen.press("t", "enter")
        await screen.shows("Opened stairs.gd")


async def test_none_that_fits_is_said_and_asked_again(open_screen, lessons):
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await tree_of_files(screen)
        await screen.press(*"xyz")
        await screen.until(lambda: "Nothing has that name." in screen.text, "the remark")
        await screen.press("enter")
        await screen.until(lambda: "There is no file xyz." in screen.text, "the reason")
        await screen.press(*"square", "enter")
        await screen.shows("Opened square.gd")


@pytest.mark.parametrize(("key", "text"), [("ctrl+o", None), ("ctrl+s", "FW 1")])
async def test_a_name_too_long_for_any_file_gets_a_sentence(open_screen, lessons, key, text):
    async with open_screen(text) as screen:
        await screen.press(key)
        await screen.until(lambda: screen.app.screen is not screen.main, "the question")
        screen.app.screen.query_one("#answer").value = "x" * 400
        await screen.press("enter")
        await screen.until(lambda: "name is too long" in " ".join(screen.text.split()), "the reason")

        assert screen.main.editor.text == (text or "")


async def test_a_typed_name_is_completed_by_tab_or_the_right_arrow(open_screen, lessons):
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await tree_of_files(screen)
        line = screen.app.screen.query_one("#answer")
        await screen.press(*"LES", "tab")
        await tree_of_files(screen, "first.gd")
        assert line.value == "lessons/"
        await screen.press("f")
        await screen.until(lambda: line._suggestion == "lessons/first.gd", "the suggestion")
        await screen.press("right")
        assert line.value == "lessons/first.gd"
        await screen.press("enter")
        await screen.shows("Opened first.gd")


async def test_a_typed_folder_is_shown(open_screen, lessons):
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await tree_of_files(screen)
        await screen.press(*"lessons", "enter")
        rows = await tree_of_files(screen, "first.gd")

        assert not any("square" in each for each in rows)
        assert screen.app.screen.query_one("#answer").value == "lessons/"


async def test_save_as_takes_the_typed_name_and_shows_the_names_that_are_taken(open_screen, lessons):
    async with open_screen("FW 1") as screen:
        await screen.press("ctrl+k", "s")
        await tree_of_files(screen)
        await screen.press(*"s", "enter")
        await screen.shows("Saved s.gd")


async def test_save_as_into_a_folder_by_keyboard(open_screen, lessons):
    async with open_screen("FW 1") as screen:
        await screen.press("ctrl+k", "s")
        await tree_of_files(screen)
        await screen.press("down", "end", "enter")
        await tree_of_files(screen, "first.gd")
        await screen.press("enter")
        await screen.shows("Saved program1.gd")

        assert (lessons / "lessons" / "program1.gd").read_text() == "FW 1\n"


async def test_save_as_into_a_folder_by_mouse_and_onto_a_program_with_a_question(open_screen, lessons):
    async with open_screen("FW 1") as screen:
        screen.app.do("save_as")
        await tree_of_files(screen)
        await click_on(screen, "lessons/")
        await tree_of_files(screen, "first.gd")
        await click_on(screen, "first.gd")
        await screen.until(lambda: "first.gd exists" in screen.text, "the question")
        await screen.answer("yes")
        await screen.shows("Saved first.gd")

        assert (lessons / "lessons" / "first.gd").read_text() == "FW 1\n"


async def test_esc_leaves_the_tree_and_says_that_nothing_changed(open_screen, lessons):
    async with open_screen("FW 1") as screen:
        await screen.press("ctrl+o")
        await tree_of_files(screen)
        await screen.press("down", "escape")
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")
        assert screen.main.editor.text == "FW 1"


async def test_a_folder_that_cannot_be_read_says_why(open_screen, lessons, monkeypatch):
    (lessons / "lessons" / "first.gd").unlink()
    import shutil

    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await tree_of_files(screen)
        shutil.rmtree(lessons / "lessons")
        await screen.press("down", "end", "right")
        await screen.until(lambda: "I can't read " in screen.text, "the reason")
        assert "o such file or folder" in " ".join(screen.text.split())  # it may have two rows
        await screen.press("left", "up", "enter")
        await screen.shows("Opened stairs.gd")


async def test_any_name_is_shown_in_one_row_and_opened(open_screen, tmp_path):
    names = [
        "a b.gd",
        "ação é.gd",
        "esc\x1b[31m.gd",
        "line\nend.gd",
        '"quoted".gd',
        " blank.gd",
        "bad\udcff.gd",
    ]
    for at, name in enumerate(names):
        (tmp_path / name).write_text(f"FW {at}\n")
    for at, name in enumerate(names):
        async with open_screen() as screen:
            await screen.press("ctrl+o")
            await tree_of_files(screen, "a b.gd")
            panel = screen.app.screen
            row = next(
                at for at in range(panel.files.last_line + 1) if panel._row_at(at).path == tmp_path / name
            )
            assert "\x1b" not in screen.text
            panel._choose(row)
            await screen.press("enter")
            await screen.until(lambda at=at, screen=screen: screen.main.editor.text == f"FW {at}", name)


async def test_links_in_circles_are_left_out(open_screen, lessons):
    (lessons / "lessons" / "up").symlink_to(lessons)
    (lessons / "lessons" / "itself").symlink_to("itself")
    (lessons / "aside").mkdir()
    (lessons / "aside" / "back").symlink_to(lessons / "aside2")
    (lessons / "aside2").mkdir()
    (lessons / "aside2" / "forth").symlink_to(lessons / "aside")
    async with open_screen(size=(80, 40)) as screen:
        await screen.press("ctrl+o")
        await tree_of_files(screen)
        await click_on(screen, "lessons/")
        await tree_of_files(screen, "first.gd")
        await click_on(screen, "aside/")
        await tree_of_files(screen, "back/")
        await click_on(screen, "back/")
        rows = await tree_of_files(screen, "No programs here.")

        assert not any(name in each for each in rows for name in ("up/", "itself", "forth"))


async def test_a_folder_of_ten_thousand_programs_is_shown_in_parts(open_screen, tmp_path):
    many = tmp_path / "many"
    many.mkdir()
    for number in range(10_000):
        (many / f"program{number}.gd").touch()
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await tree_of_files(screen, "many/")
        await screen.press("down", "end", "right")
        await tree_of_files(screen, "program0.gd")
        files = screen.app.screen.files
        await screen.press("end")
        assert any("9500 more" in each for each in await tree_of_files(screen, "more"))
        await screen.press("enter")
        await screen.until(lambda: files.last_line > 1000, "more rows")
        await screen.press(*"9999")
        await screen.until(lambda: files.last_line < 6, "the fitting one")
        await screen.press("enter")
        await screen.shows("Opened program9999.gd")


async def test_a_slow_folder_delays_no_key(open_screen, lessons, monkeypatch):
    from donnie_tui.tui.screens import file_panel

    may_continue = threading.Event()
    read = file_panel.programs_in

    def slow(*asked):
        assert may_continue.wait(TIMEOUT)
        return read(*asked)

    monkeypatch.setattr(file_panel, "programs_in", slow)
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await screen.until(lambda: "I am reading this folder." in screen.text, "the remark")
        await screen.press(*"sta")
        assert screen.app.screen.query_one("#answer").value == "sta"
        may_continue.set()
        await tree_of_files(screen)
        await screen.press("enter")
        await screen.shows("Opened stairs.gd")


async def test_the_cursor_of_the_terminal_is_on_the_chosen_row_and_in_the_line_otherwise(
    open_screen, lessons
):
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await tree_of_files(screen)
        assert screen.app.cursor_position.y == screen.app.screen.query_one("#answer").region.y
        await screen.press("down", "down", "down")
        await screen.painted()
        assert "square.gd" in screen.text.splitlines()[screen.app.cursor_position.y]
        await screen.press("s")
        await screen.painted()
        assert screen.app.cursor_position.y == screen.app.screen.query_one("#answer").region.y


async def test_in_the_plain_layout_the_question_has_no_tree(open_screen, lessons):
    async with open_screen(plain=True) as screen:
        await screen.press("ctrl+o")
        await screen.answer("sq")
        await screen.shows("Opened square.gd")


# --- the panel by itself


def asking_for_a_file(said: list[str], recent=(), **given) -> FilePanel:
    return FilePanel(
        "Which?", "", lambda: recent, Words("en"), said.append, checking=lambda _: nullcontext(), **given
    )


async def open_panel(pilot, said: list[str], **given) -> FilePanel:
    panel = asking_for_a_file(said, **given)
    await pilot.app.show(panel)
    await until(pilot, lambda: "../ the folder above" in texts_of(panel))
    return panel


async def until(pilot, condition) -> None:
    async with asyncio.timeout(TIMEOUT):
        while not condition():
            await pilot.pause(0.01)


def texts_of(panel: FilePanel) -> list[str]:
    rows = (panel._row_at(at) for at in range(panel.files.last_line + 1))
    return [" ".join(filter(None, (each.text, each.remark))) for each in rows]


@pytest.fixture
def at_home(lessons, monkeypatch):
    monkeypatch.setenv("HOME", str(lessons.parent))
    return lessons


SAID = [
    ("down down down", "square.gd"),
    ("up", "programs/, open folder"),
    ("down end down", "lessons/, closed folder"),
    ("down end home", "programs/, open folder"),
    ("down pagedown", "lessons/, closed folder"),
    ("down end pageup", "programs/, open folder"),
    ("down left right", "programs/, open folder"),
    ("down right", "../, the folder above"),
    ("down down down left", "programs/, open folder"),
    ("down down down right", "square.gd"),
    ("down end right", "lessons/, open folder"),
    ("down end enter enter", "lessons/, closed folder"),
    ("enter", "square.gd"),
]


async def test_each_row_of_the_tree_is_said_as_the_keys_reach_it(at_home):
    async with Showing().run_test(size=(80, 24)) as pilot:
        for keys, sentence in SAID:
            said: list[str] = []
            panel = await open_panel(pilot, said)
            assert said == ["Which?"]
            assert texts_of(panel) == [
                "programs/ ~", "../ the folder above", "square.gd", "stairs.gd", "lessons/"
            ]  # fmt: skip
            await pilot.press(*keys.split())
            await pilot.pause()
            assert (said[-1], pilot.app.answer) == (sentence, OPEN), keys


async def test_a_folder_that_is_open_leads_into_it_and_back(at_home):
    async with Showing().run_test(size=(80, 24)) as pilot:
        said: list[str] = []
        panel = await open_panel(pilot, said)
        await pilot.press("down", "end", "right")
        await until(pilot, lambda: panel.files.last_line == 6)
        assert texts_of(panel)[4:] == ["lessons/", "first.gd", "old/"]
        await pilot.press("right")
        assert said[-1] == "first.gd"
        await pilot.press("left")
        assert said[-1] == "lessons/, open folder"
        await pilot.press("left")
        assert texts_of(panel)[4:] == ["lessons/"]
        await pilot.press("right", "right", "enter")
        assert pilot.app.answer == at_home / "lessons" / "first.gd"


COMPLETED = [
    ("down end tab", "lessons/"),
    ("down down tab", "{above}/"),
    ("a i r tab", "stairs.gd"),
    ("x left y end z", "yxz"),
    ("x y left right z", "xyz"),
    ("l e s s o n s enter", "lessons/"),
]


async def test_tab_completes_what_is_chosen_or_typed(at_home):
    async with Showing().run_test(size=(80, 24)) as pilot:
        for keys, line in COMPLETED:
            panel = await open_panel(pilot, [])
            await pilot.press(*keys.split())
            wanted = line.format(above=at_home.parent)
            await until(pilot, lambda panel=panel, wanted=wanted: panel._line.value == wanted)
            assert pilot.app.answer == OPEN


async def test_what_is_typed_in_a_folder_narrows_that_folder(at_home):
    async with Showing().run_test(size=(80, 24)) as pilot:
        panel = await open_panel(pilot, [])
        panel._line.value = "lessons/"
        await until(pilot, lambda: "first.gd" in texts_of(panel))
        assert texts_of(panel) == ["lessons/ ~/programs", "../ the folder above", "first.gd", "old/"]
        panel._line.value = "lessons/fi"
        await pilot.pause()
        assert texts_of(panel) == ["lessons/ ~/programs", "first.gd"]
        panel._line.value = "lessons/x"
        await pilot.pause()
        assert texts_of(panel) == ["lessons/ ~/programs", Words("en")("palette-nothing")]
        panel._line.value = ""
        await pilot.pause()
        assert texts_of(panel)[2:4] == ["square.gd", "stairs.gd"]


async def test_recent_programs_have_the_folders_where_they_are_and_are_closed_for_a_new_name(
    at_home, tmp_path
):
    recent = (
        at_home / "lessons" / "first.gd",
        at_home / "square.gd",
        *[tmp_path / f"{at}.gd" for at in range(5)],
    )
    async with Showing().run_test(size=(80, 24)) as pilot:
        panel = await open_panel(pilot, [], recent=recent)
        await until(pilot, lambda: texts_of(panel)[0] == "Recent programs")
        assert texts_of(panel)[1:6] == ["first.gd lessons/", "square.gd", *[f"{at}.gd ~" for at in range(3)]]
        assert texts_of(panel)[6] == "programs/ ~"
        panel = await open_panel(pilot, [], recent=recent, is_new=True)
        await until(pilot, lambda: texts_of(panel)[0] == "Recent programs")
        assert texts_of(panel)[1] == "programs/ ~"


async def test_the_wheel_and_the_cursor_of_the_terminal_follow_the_chosen_row(at_home):
    async with Showing().run_test(size=(80, 24)) as pilot:
        panel = await open_panel(pilot, [])
        files, line = panel.files, panel._line
        assert line.cursor_screen_offset == line.content_region.offset
        chosen = []
        for turn in (MouseScrollDown, MouseScrollDown, MouseScrollUp, MouseScrollUp):
            files.post_message(turn(files, 0, 0, 0, 0, 0, False, False, False))
            await pilot.pause()
            chosen.append(files.cursor_line)
            assert line.cursor_screen_offset == files.content_region.offset + Offset(0, files.cursor_line)
        assert chosen == [2, 4, 1, 0]


async def test_a_row_has_a_mark_a_sign_for_folders_and_a_fainter_remark(at_home):
    async with Showing().run_test(size=(80, 24)) as pilot:
        panel = await open_panel(pilot, [])
        await pilot.press("down", "down", "down")
        await pilot.pause()
        rows = [panel.files.render_line(y).text for y in range(6)]
        assert [each.rstrip() for each in rows] == [
            " - programs/  ~",
            "     ../  the folder above",
            "  >  square.gd", "     stairs.gd", "   + lessons/", "",
        ]  # fmt: skip
        assert {len(each) for each in rows} == {panel.files.size.width}


@pytest.mark.parametrize(
    ("size", "width", "height"),
    [((88, 40), 80, 26), ((87, 24), 87, 20), ((80, 11), 80, 8), ((80, 10), 80, 7), ((80, 6), 80, 5)],
    ids=str,
)
async def test_the_panel_leaves_eight_columns_or_none_and_the_bottom_line_has_its_keys(
    lessons, size, width, height
):
    async with Showing().run_test(size=size) as pilot:
        panel = asking_for_a_file([])
        await pilot.app.show(panel)
        await pilot.pause()
        styles = panel._panel.styles
        assert (styles.width.value, styles.height.value) == (width, height)
        assert panel._keys.region.y == size[1] - 1
        assert panel._panel.has_class("-wide-as-all") is (width == size[0])


async def test_the_screen_stays_after_a_link_to_itself_and_a_name_with_a_zero_byte(
    open_screen, tmp_path, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "loop.world").symlink_to("loop.world")
    async with open_screen() as screen:
        for typed, sentence in (
            ("WORLD loop.world", "I can't read loop.world: its link leads back to itself."),
            ("SAVE WORLD loop.world", "I can't write loop.world: its link leads back to itself."),
            ("WORLD a\0b.world", "There is no file a b.world."),
            ("WORLDS c\0d", "There is no world c d. WORLDS lists them."),
            ("OPEN a\0b.gd", "I can't read a b.gd: it is not understood."),
            ("WHERE", "Position 0, 0. Facing north."),
        ):
            await screen.type_line(typed)
            await screen.shows(sentence)

    assert (tmp_path / "loop.world").is_symlink()
