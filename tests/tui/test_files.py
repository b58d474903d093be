"""Files at the screen: what it begins with, its title, and what is left behind when it ends."""

import threading
from pathlib import Path

import pytest


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


# --- the list of files


@pytest.fixture
def lessons(tmp_path):
    """Programs in the folder and in another one."""
    (tmp_path / "lessons").mkdir()
    for name in ("square.gd", "stairs.gd", "lessons/first.gd"):
        (tmp_path / name).write_text(f'SPEAK "{name}"\n')
    (tmp_path / "notes.txt").write_text("no program")
    return tmp_path


async def list_of_files(screen) -> tuple[str, ...]:
    await screen.until(lambda: screen.app.screen is not screen.main, "the question")
    listed = screen.app.screen._list
    await screen.until(lambda: listed.lines, "the list")
    await screen.painted()
    return listed.lines


@pytest.mark.parametrize("size", [(80, 24), (40, 12)])
async def test_open_lists_the_programs_and_the_arrows_choose_one(open_screen, lessons, size):
    async with open_screen(size=size) as screen:
        await screen.press("ctrl+o")
        assert await list_of_files(screen) == ("square.gd", "stairs.gd", "lessons/")
        assert "square.gd" in screen.text
        await screen.press("down", "down", "enter")
        await screen.shows("Opened stairs.gd")


async def test_enter_with_nothing_typed_chooses_the_first_of_the_list_and_then_opens_it(open_screen, lessons):
    """It said that nothing was changed, below the very list."""
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await screen.until(lambda: "square.gd" in screen.text, "the list")
        await screen.press("enter")
        await screen.until(lambda: ">square.gd" in screen.text, "the chosen row")
        await screen.press("enter")

        await screen.until(lambda: screen.app.screen is screen.main, "the program")
        assert "Program: square.gd" in screen.text


async def test_a_folder_of_the_list_leads_to_its_programs_by_mouse_too(open_screen, lessons):
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await list_of_files(screen)
        row = next(at for at, line in enumerate(screen.text.splitlines()) if line.strip() == "lessons/")
        await screen.pilot.click(offset=(3, row))
        listed = screen.app.screen._list
        await screen.until(lambda: listed.lines == ("lessons/first.gd",), "the folder")
        await screen.press("tab", "enter")
        await screen.shows("Opened first.gd")


async def test_what_is_typed_narrows_the_list_and_enter_takes_what_is_typed(open_screen, lessons):
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await list_of_files(screen)
        await screen.press(*"sq")
        listed = screen.app.screen._list
        await screen.until(lambda: listed.lines == ("square.gd",), "the fitting one")
        await screen.press(*"uare", "enter")
        await screen.shows("Opened square.gd")


async def test_save_as_shows_the_names_that_are_taken(open_screen, lessons):
    async with open_screen("FW 1") as screen:
        await screen.press("ctrl+k", "s")
        assert "stairs.gd" in await list_of_files(screen)
        await screen.press(*"mine", "enter")
        await screen.shows("Saved mine.gd")


async def test_in_the_plain_layout_the_question_has_no_list(open_screen, lessons):
    async with open_screen(plain=True) as screen:
        await screen.press("ctrl+o")
        await screen.until(lambda: screen.app.screen is not screen.main, "the question")

        assert screen.app.screen._list is None
