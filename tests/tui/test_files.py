"""Files at the screen: what it begins with, its title, and what is left behind when it ends."""

import threading
from pathlib import Path

import pytest


@pytest.fixture
def program(tmp_path: Path) -> Path:
    path = tmp_path / "walk.gd"
    path.write_text("FW 1\nTR 90\n", encoding="utf-8")
    return path


async def test_a_file_of_the_command_line_is_open_at_the_start(work, program):
    async with work(file=program) as desk:
        assert desk.place.editor.text == "FW 1\nTR 90"
        assert "Opened walk.gd, 2 lines." in desk.log
        assert ">Program: walk.gd " in desk.screen


async def test_a_missing_file_is_reported(work, tmp_path):
    async with work(file=tmp_path / "none.gd") as desk:
        await desk.shows("There is no file")


async def test_esc_goes_back_from_a_question(work):
    async with work("FW 1") as desk:
        await desk.press("ctrl+o")
        await desk.until(lambda: desk.app.screen is not desk.place, "the question")
        await desk.press("escape")
        await desk.until(lambda: desk.app.screen is desk.place, "the main screen")

        assert desk.place.editor.text == "FW 1"
        assert desk.place.editor.has_focus


async def test_save_writes_the_file_and_the_title_says_changed_until_then(work, program):
    async with work(file=program) as desk:
        await desk.press("S", "P", "space")
        await desk.until(lambda: "Program: walk.gd, changed" in desk.screen, "the title")
        await desk.press("ctrl+s")
        await desk.shows("Saved walk.gd")

        assert program.read_text(encoding="utf-8") == "SP FW 1\nTR 90\n"
        await desk.until(lambda: "changed" not in desk.screen, "the title")


async def test_cancelling_the_question_keeps_the_program(work):
    async with work("FW 2") as desk:
        await desk.press("ctrl+q")
        await desk.until(lambda: desk.app.screen is not desk.place, "the question")
        await desk.press("escape")
        await desk.pilot.pause()

        assert desk.app.is_running
        assert desk.place.editor.text == "FW 2"


async def test_a_discarded_program_is_not_announced_and_restored_by_recover(work, tmp_path):
    async with work("FW 2") as desk:
        await desk.press("ctrl+q")
        await desk.answer("no")
        await desk.until(lambda: not desk.app.is_running, "the end")
    assert [each.read_text() for each in (tmp_path / "unsaved").iterdir()] == ["FW 2\n"]

    async with work() as desk:
        await desk.type_line("RECOVER")
        await desk.shows("Here it is again, 1 line.")
        assert desk.place.editor.text == "FW 2"
        assert "A program was rescued. RECOVER opens it." not in desk.log


async def test_linear_leaves_with_the_text_and_its_file_and_rescues_the_other_programs(
    work, program, tmp_path
):
    async with work(file=program) as desk:
        await desk.press("X")
        workspace = desk.app.controller.workspace
        workspace.turn_to(workspace.add_document())
        desk.load("FW 3")
        workspace.turn_to(workspace.documents[0])
        await desk.type_line("linear")
        await desk.until(lambda: not desk.app.is_running, "the end")

        assert desk.app.session.left_for_linear
        assert desk.place.editor.text == "XFW 1\nTR 90"
        assert desk.app.controller.workspace.document.path == program
    assert [each.read_text() for each in (tmp_path / "unsaved").iterdir()] == ["FW 3\n"]


async def test_a_saved_program_is_left_without_a_question(work, program):
    async with work(file=program) as desk:
        await desk.press("ctrl+q")
        await desk.until(lambda: not desk.app.is_running, "the end")

        assert desk.app.return_code == 0


async def test_typed_lines_are_copied_soon(work, tmp_path):
    async with work() as desk:
        await desk.press("F", "W")
        await desk.until(lambda: any((tmp_path / "unsaved").glob("*.gd")), "a copy")


async def test_a_copy_of_a_crash_is_offered_and_restored_as_unsaved(work, tmp_path):
    (tmp_path / "unsaved").mkdir()
    (tmp_path / "unsaved" / "unsaved-abc.gd").write_text("FW 9\nFW 8", encoding="utf-8")
    async with work() as desk:
        await desk.shows("A program was rescued.")
        await desk.type_line("RECOVER")
        await desk.shows("Here it is again, 2 lines.")

        assert desk.place.editor.text == "FW 9\nFW 8"
        assert "changed" in desk.screen


def no_copy_is_written() -> bool:
    return all(each.name != "copies" for each in threading.enumerate())


async def test_an_unwritable_state_folder_is_reported_once(work, tmp_path):
    (tmp_path / "unsaved").write_text("a file in its place")
    async with work("FW 1") as desk:
        desk.app.controller.workspace.keep_copies()
        await desk.shows("What you type can't be kept safe")
        desk.place.editor.insert("FW 2")
        desk.app.controller.workspace.keep_copies()
        await desk.until(no_copy_is_written, "the second try")

        assert sum("kept safe" in line for line in desk.log) == 1


async def test_a_program_from_the_other_mode_keeps_its_file_and_its_changes(work, program):
    async with work("FW 1\nTR 90\nFW 7\n", file=program) as desk:
        assert desk.place.editor.text == "FW 1\nTR 90\nFW 7"
        assert "Program: walk.gd, changed" in desk.screen


async def test_a_wrong_answer_to_yes_or_no_is_reported_and_typed_over(work, tmp_path):
    there = tmp_path / "there.txt"
    there.write_text("kept")
    async with work() as desk:
        await desk.type_line(f"SAVE LOG {there}")
        await desk.answer("perhaps")
        asked = desk.app.screen.query_one("#asked")
        await desk.until(lambda: str(asked.render()).startswith("Type y or n."), "the way to answer")
        await desk.press("n", "o", "enter")
        await desk.until(lambda: desk.app.screen is desk.place, "the answer")
        assert there.read_text() == "kept"

        await desk.type_line(f"SAVE LOG {there}")
        await desk.answer("yes")
        await desk.until(lambda: "> SAVE LOG" in there.read_text(), "the log")
