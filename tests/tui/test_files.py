"""Opening, saving, beginning anew, recovering: nothing is lost without a question."""

import os
import threading
from pathlib import Path

import pytest

from tests.tui.conftest import WAITING


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


async def test_open_takes_the_name_after_the_word(work, program):
    async with work() as desk:
        await desk.type_line(f"OPEN {program}")
        await desk.shows("Opened walk.gd, 2 lines.")

        assert desk.place.editor.text == "FW 1\nTR 90"


async def test_open_asks_for_the_name_and_rejects_a_wrong_one_at_once(work, program):
    async with work() as desk:
        await desk.press("ctrl+o")
        await desk.answer(str(program.with_name("none.gd")))
        await desk.until(lambda: "There is no file" in desk.screen, "the reason")
        await desk.answer(str(program))
        await desk.shows("Opened walk.gd")

        assert desk.app.screen is desk.place


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


async def test_the_first_save_asks_for_a_name_and_adds_the_suffix(work, tmp_path):
    async with work("FW 2") as desk:
        await desk.press("ctrl+s")
        await desk.answer(str(tmp_path / "first"))
        await desk.shows("Saved first.gd")

        assert (tmp_path / "first.gd").read_text(encoding="utf-8") == "FW 2\n"


@pytest.mark.parametrize(("answer", "text"), [("sí", "FW 2\n"), ("no", "FW 1\nTR 90\n")])
async def test_another_file_is_replaced_only_after_a_yes(work, program, answer, text):
    async with work("FW 2") as desk:
        await desk.type_line(f"SAVE {program}")
        await desk.answer("perhaps")
        await desk.until(lambda: "Replace it, y or n?" in desk.screen, "the question again")
        await desk.answer(answer)
        await desk.shows("Saved walk.gd" if answer == "sí" else "Nothing was changed.")

        assert program.read_text(encoding="utf-8") == text


@pytest.mark.parametrize(("answer", "text"), [("yes", "XFW 1\nTR 90\n"), ("no", "BW 1\n")])
@pytest.mark.parametrize("word", ["SAVE", "SAVE {}"])
async def test_a_file_changed_by_another_program_is_replaced_only_after_a_yes(
    work, program, answer, text, word
):
    async with work(file=program) as desk:
        await desk.press("X")
        program.write_text("BW 1\n", encoding="utf-8")
        await desk.type_line(word.format(program))
        await desk.until(lambda: "walk.gd was changed elsewhere." in desk.screen, "the question")
        await desk.answer(answer)
        await desk.shows("Saved walk.gd" if answer == "yes" else "Nothing was changed.")

        assert program.read_text(encoding="utf-8") == text


async def test_a_folder_that_can_t_be_written_is_a_sentence(work, tmp_path):
    async with work("FW 2") as desk:
        await desk.type_line(f"SAVE {tmp_path / 'nowhere' / 'a.gd'}")

        await desk.shows("I can't write")


async def test_an_unsaved_program_is_closed_only_after_a_question(work, tmp_path):
    async with work("FW 2") as desk:
        await desk.press("ctrl+n")
        await desk.answer("yes")
        await desk.answer(str(tmp_path / "kept.gd"))
        await desk.shows("A new program.")

        assert desk.place.editor.text == ""
        assert (tmp_path / "kept.gd").read_text(encoding="utf-8") == "FW 2\n"


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


@pytest.mark.parametrize("word", ["NEW", "RECOVER"])
async def test_a_program_replaced_by_another_one_is_restored_by_recover(work, tmp_path, word):
    (tmp_path / "unsaved").mkdir()
    (tmp_path / "unsaved" / "unsaved-abc.gd").write_text("FW 9", encoding="utf-8")
    async with work() as desk:
        await desk.type_line("RECOVER")
        await desk.shows("Here it is again, 1 line.")
        desk.load("FW 8")
        await desk.type_line("NEW")
        await desk.answer("no")
        await desk.until(lambda: desk.place.editor.text == "", "the empty program")
        desk.load("FW 7")
        await desk.type_line(word)
        await desk.answer("no")
        await desk.until(lambda: desk.place.editor.text in ("", "FW 8"), "another program")

    left = [each.read_text() for each in (tmp_path / "unsaved").iterdir()]
    assert sorted(left) == ["FW 7\n", "FW 8\n"]


async def test_a_switch_to_the_linear_mode_rescues_the_other_programs(work, tmp_path):
    async with work("FW 2") as desk:
        workspace = desk.app.controller.workspace
        workspace.turn_to(workspace.add_document())
        desk.load("FW 3")
        await desk.type_line("LINEAR")
        await desk.until(lambda: not desk.app.is_running, "the end")

    assert desk.place.editor.text == "FW 3"
    assert [each.read_text() for each in (tmp_path / "unsaved").iterdir()] == ["FW 2\n"]


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


async def test_recover_without_a_copy_says_so(work):
    async with work() as desk:
        await desk.type_line("RECOVER")

        await desk.shows("Nothing to recover.")


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


async def test_files_wait_while_a_program_runs(work, program):
    async with work(WAITING, speed=1.0) as desk:
        await desk.press("f5")
        await desk.type_line(f"OPEN {program}")

        await desk.shows("A program is running.")


async def test_linear_leaves_with_the_text_and_its_file(work, program):
    async with work(file=program) as desk:
        await desk.press("X")
        await desk.type_line("linear")
        await desk.until(lambda: not desk.app.is_running, "the end")

        assert desk.app.session.left_for_linear
        assert desk.place.editor.text == "XFW 1\nTR 90"
        assert desk.app.controller.workspace.document.path == program


async def test_a_program_from_the_other_mode_keeps_its_file_and_its_changes(work, program):
    async with work("FW 1\nTR 90\nFW 7\n", file=program) as desk:
        assert desk.place.editor.text == "FW 1\nTR 90\nFW 7"
        assert "Program: walk.gd, changed" in desk.screen


@pytest.mark.parametrize(
    "data", [b"\xff\xfe\x00\x01", b"\r\n\r\nFW 1\r\n", 'FALAR "olá"'.encode("cp1252"), b""]
)
async def test_opening_any_file_gets_an_answer(work, tmp_path, data):
    path = tmp_path / "odd.gd"
    path.write_bytes(data)
    async with work() as desk:
        await desk.type_line(f"OPEN {path}")

        await desk.until(lambda: any("odd.gd" in line for line in desk.log[3:]), "an answer")


async def test_the_log_replaces_a_file_only_after_a_yes(work, program):
    async with work() as desk:
        await desk.type_line(f"SAVE LOG {program}")
        await desk.answer("no")
        await desk.shows("Nothing was changed.")
        assert program.read_text(encoding="utf-8") == "FW 1\nTR 90\n"

        await desk.type_line(f"SAVE LOG {program}")
        await desk.answer("yes")
        await desk.until(lambda: "SAVE LOG" in program.read_text(encoding="utf-8"), "the log")


@pytest.mark.parametrize("word", ["SAVE LOG", "REPORT LIST"])
async def test_no_page_replaces_an_open_program(work, program, word):
    async with work(file=program) as desk:
        await desk.type_line(f"{word} {program}")
        await desk.shows("is an open program. Give another name.")

        assert desk.app.screen is desk.place
        assert program.read_text(encoding="utf-8") == "FW 1\nTR 90\n"


async def test_a_file_that_the_session_needs_is_refused_without_a_question(work, tmp_path):
    needed = tmp_path / "run.rec"
    async with work("FW 1", record=str(needed)) as desk:
        recorded = needed.read_text(encoding="utf-8")
        await desk.type_line(f"SAVE AS {needed}")
        await desk.shows("is in use here. Give another name.")
        await desk.type_line(f"REPORT MAP {needed}")
        await desk.until(lambda: sum("is in use here" in line for line in desk.log) == 2, "the second answer")

    assert recorded
    assert needed.read_text(encoding="utf-8").startswith(recorded)


async def test_all_programs_of_a_crash_are_restored_one_by_one(work, tmp_path):
    folder = tmp_path / "unsaved"
    folder.mkdir()
    for name, text, age in (("one", "FW 1\n", 1000), ("two", "FW 2\n", 2000)):
        copy = folder / f"unsaved-99999999-{name}.gd"
        copy.write_text(text)
        os.utime(copy, (age, age))
    async with work() as desk:
        await desk.shows("A program was rescued. RECOVER opens it.")
        await desk.type_line("RECOVER")
        await desk.shows("Here it is again, 1 line.")
        assert desk.place.editor.text == "FW 2"
        await desk.shows("There is one more. RECOVER opens it.")

        await desk.type_line("RECOVER")
        await desk.answer("no")
        await desk.until(lambda: desk.place.editor.text == "FW 1", "the other one")
        await desk.type_line("RECOVER")
        await desk.answer("no")
        await desk.until(lambda: desk.place.editor.text == "FW 2", "what was given up for it")


async def test_a_wrong_answer_to_yes_or_no_is_reported_and_typed_over(work, tmp_path):
    there = tmp_path / "there.gd"
    there.write_text("FW 1")
    async with work("FW 2") as desk:
        await desk.type_line(f"SAVE AS {there}")
        await desk.answer("perhaps")
        asked = desk.app.screen.query_one("#asked")
        await desk.until(lambda: str(asked.render()).startswith("Type y or n."), "the way to answer")
        await desk.press("n", "o", "enter")
        await desk.until(lambda: desk.app.screen is desk.place, "the answer")

        assert there.read_text() == "FW 1"
