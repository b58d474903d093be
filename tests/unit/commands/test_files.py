"""OPEN, SAVE, NEW, RECOVER, SAVE LOG, REPORT: no text is lost without a question."""

from __future__ import annotations

import csv
import os
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from xml.etree import ElementTree

import pytest
from PIL import Image

from donnie_tui.commands import files
from donnie_tui.commands.context import Context
from donnie_tui.commands.files import compare_with_file
from donnie_tui.commands.interaction import EnterWorld, drive
from donnie_tui.commands.lookup import words_of
from donnie_tui.core.program_files import DocumentError
from donnie_tui.core.session_log import AnswerLog, LineHistory
from tests.unit.commands.scripted import Script
from worlds import EXAMPLES

OpenScript = Callable[..., Script]

UNCHANGED = "Nothing was changed."


@pytest.fixture
def walk(tmp_path: Path) -> Path:
    path = tmp_path / "walk.gd"
    path.write_text("FW 1\nTR 90\n", encoding="utf-8")
    return path


# --- opening


def test_open_takes_the_name_after_the_word(open_script: OpenScript, walk: Path) -> None:
    script = open_script()

    assert script.answers_to(f"OPEN {walk}") == ["Opened walk.gd, 2 lines."]
    assert script.ctx.program.lines == ("FW 1", "TR 90")
    assert script.ctx.program.path == walk


def test_open_asks_for_the_name_and_rejects_a_wrong_one_at_once(open_script: OpenScript, walk: Path) -> None:
    script = open_script(answers=["none.gd", str(walk)])

    assert script.answers_to("OPEN") == ["Opened walk.gd, 2 lines."]
    assert script.interaction.asked[1].startswith("There is no file")


def test_the_beginning_of_a_name_opens_the_only_program_that_has_it(
    open_script: OpenScript, walk: Path
) -> None:
    assert open_script().answers_to("OPEN wa") == ["Opened walk.gd, 2 lines."]
    assert open_script(answers=["WA"]).answers_to("OPEN") == ["Opened walk.gd, 2 lines."]


def test_several_programs_that_begin_so_are_counted(open_script: OpenScript, walk: Path) -> None:
    walk.with_name("wall.gd").write_text("FW 9\n")

    assert open_script().answers_to("OPEN wal") == ["2 programs begin with wal."]
    script = open_script(answers=["wa", "wall"])
    assert script.answers_to("OPEN") == ["Opened wall.gd, 1 line."]
    assert script.interaction.asked[1:] == ["2 programs begin with wa. wa"]


def test_a_file_of_the_typed_name_comes_before_one_that_begins_so(
    open_script: OpenScript, walk: Path
) -> None:
    walk.with_name("wa").write_text("FW 9\n")

    assert open_script().answers_to("OPEN wa") == ["Opened wa, 1 line."]


@pytest.mark.parametrize(
    "data", [b"\xff\xfe\x00\x01", b"\r\n\r\nFW 1\r\n", 'FALAR "olá"'.encode("cp1252"), b""]
)
def test_opening_any_file_gets_an_answer(open_script: OpenScript, tmp_path: Path, data: bytes) -> None:
    (tmp_path / "odd.gd").write_bytes(data)

    assert any("odd.gd" in line for line in open_script().answers_to("OPEN odd.gd"))


# --- saving


def test_the_first_save_asks_for_a_name_and_adds_the_suffix(open_script: OpenScript, tmp_path: Path) -> None:
    script = open_script("FW 2", answers=["first"])

    assert script.answers_to("SAVE") == ["Saved first.gd, 1 line."]
    assert (tmp_path / "first.gd").read_text(encoding="utf-8") == "FW 2\n"


@pytest.mark.parametrize(
    ("answer", "last", "text"),
    [("yes", "Saved walk.gd, 1 line.", "FW 2\n"), ("no", UNCHANGED, "FW 1\nTR 90\n")],
)
def test_another_file_is_replaced_only_after_a_yes(
    open_script: OpenScript, walk: Path, answer: str, last: str, text: str
) -> None:
    script = open_script("FW 2", answers=[answer])

    assert script.answers_to(f"SAVE {walk}") == [last]
    assert script.interaction.asked[0].startswith("walk.gd exists. Replace it, y or n?")
    assert walk.read_text(encoding="utf-8") == text


@pytest.mark.parametrize(
    ("answer", "last", "text"),
    [("yes", "Saved walk.gd, 2 lines.", "FW 7\nTR 90\n"), ("no", UNCHANGED, "BW 1\n")],
)
@pytest.mark.parametrize("typed", ["SAVE", "SAVE walk.gd"])
def test_a_file_changed_by_another_program_is_replaced_only_after_a_yes(
    open_script: OpenScript, walk: Path, typed: str, answer: str, last: str, text: str
) -> None:
    script = open_script(answers=[answer])
    script.answers_to("OPEN walk.gd", "CHANGE 1 FW 7")
    walk.write_text("BW 1\n", encoding="utf-8")

    assert script.answers_to(typed) == [last]
    assert script.interaction.asked[0].startswith("walk.gd was changed elsewhere.")
    assert walk.read_text(encoding="utf-8") == text


def test_a_folder_that_can_not_be_written_is_reported(open_script: OpenScript) -> None:
    (answer,) = open_script("FW 2").answers_to("SAVE nowhere/a.gd")

    assert answer.startswith("I can't write")


# --- before a text is lost

WORTH_SAVING = ("FW 2",) * 5


def test_an_unsaved_program_is_closed_only_after_a_question(open_script: OpenScript, tmp_path: Path) -> None:
    script = open_script(*WORTH_SAVING, answers=["yes", "kept.gd"])

    assert script.answers_to("NEW") == ["Saved kept.gd, 5 lines.", "This is a new program."]
    assert script.ctx.program.lines == ()
    assert (tmp_path / "kept.gd").read_text(encoding="utf-8") == "FW 2\n" * 5


@pytest.mark.parametrize("answers", [[None], ["yes", None]])
def test_a_missing_answer_keeps_the_program_and_is_reported_once(
    open_script: OpenScript, answers: list[str | None]
) -> None:
    script = open_script(*WORTH_SAVING, answers=answers)

    assert script.answers_to("NEW") == [UNCHANGED]
    assert script.ctx.program.lines == WORTH_SAVING


@pytest.mark.parametrize("typed", ["SAVE", "SAVE AS", "OPEN", "SAVE LOG"])
def test_a_cancelled_question_reports_once_that_nothing_changed(open_script: OpenScript, typed: str) -> None:
    script = open_script("FW 1", answers=[None])
    script.ctx.answers.add_line("I walked 1 step forward.")

    assert script.answers_to(typed) == [UNCHANGED]
    assert len(script.interaction.asked) == 1
    assert script.ctx.program.lines == ("FW 1",)


# --- recovering


@pytest.fixture
def copies(tmp_path: Path) -> Path:
    """The folder of the copies that earlier starts left."""
    folder = tmp_path / "donnie" / "unsaved"
    folder.mkdir(parents=True)
    return folder


def test_recover_without_a_copy_says_so(open_script: OpenScript) -> None:
    assert open_script().answers_to("RECOVER") == ["There is nothing to recover."]


@pytest.mark.parametrize(("left", "is_saved"), [("FW 1\n", True), ("FW 2\n", False)])
def test_a_program_that_the_other_mode_left_is_changed_if_its_file_has_another_text(
    open_script: OpenScript, tmp_path: Path, left: str, is_saved: bool
) -> None:
    file, script = tmp_path / "it.gd", open_script()
    file.write_text("FW 1\n")
    script.ctx.workspace.replace(left, file, in_file="")

    drive(compare_with_file(script.ctx))
    assert script.ctx.program.is_saved is is_saved


def test_all_programs_of_a_crash_are_restored_one_by_one(open_script: OpenScript, copies: Path) -> None:
    for name, text, age in (("one", "FW 1\n", 1000), ("two", "FW 2\n", 2000)):
        copy = copies / f"unsaved-99999999-{name}.gd"
        copy.write_text(text)
        os.utime(copy, (age, age))
    script = open_script()

    assert script.answers_to("RECOVER") == [
        "Your program is back, 1 line.",
        "There is one more. RECOVER opens it.",
    ]
    for text in ("FW 2", "FW 1", "FW 2"):  # what was given up for the other one comes last
        assert script.ctx.program.lines == (text,)
        script.type("RECOVER")


def test_undo_takes_back_what_recover_did_and_says_so(open_script: OpenScript, copies: Path) -> None:
    (copies / "unsaved-99999999-1.gd").write_text("FW 9\n")
    script = open_script()
    script.type("RECOVER")

    assert script.answers_to("UNDO") == ["This is a new program."]
    assert script.ctx.program.lines == ()
    assert script.answers_to("REDO") == ["Your program is back, 1 line."]
    assert script.ctx.program.lines == ("FW 9",)


def test_a_recovered_program_that_was_undone_can_be_recovered_again(
    open_script: OpenScript, copies: Path
) -> None:
    (copies / "unsaved-99999999-1.gd").write_text("FW 9\n")
    script = open_script()

    assert script.answers_to("RECOVER", "UNDO", "RECOVER")[-1] == "Your program is back, 1 line."


@pytest.mark.parametrize("word", ["NEW", "RECOVER"])
def test_a_program_replaced_by_another_one_is_restored_by_recover(
    open_script: OpenScript, copies: Path, word: str
) -> None:
    (copies / "unsaved-abc.gd").write_text("FW 9", encoding="utf-8")
    script = open_script()
    script.answers_to("RECOVER", "CHANGE 1 FW 8", "NEW", "INSERT 1 FW 7", word)
    script.ctx.workspace.leave_copies()
    script.ctx.workspace.write_copies()

    assert sorted(each.read_text() for each in copies.iterdir()) == ["FW 7\n", "FW 8\n"]


# --- pages


def test_a_report_is_written_and_another_file_replaced_only_after_a_question(
    open_script: OpenScript, tmp_path: Path
) -> None:
    script = open_script("FW 1", "FW 2", answers=["no"])
    assert script.answers_to("REPORT list lines.csv") == ["Wrote lines.csv."]
    written = (tmp_path / "lines.csv").read_text()
    assert written.splitlines()[1:3] == ["1,0,FW 1", "2,0,FW 2"]

    assert script.answers_to("REPORT map lines.csv") == [UNCHANGED]
    assert (tmp_path / "lines.csv").read_text() == written


def test_a_report_of_a_run_is_a_picture_that_moves_and_of_its_distances_a_plot(
    open_script: OpenScript, tmp_path: Path
) -> None:
    script = open_script()
    script.run("FW 2\nSPEAK DISTANCE F\nFW 1")
    script.rest()
    assert script.answers_to("REPORT run run.svg") == ["Wrote run.svg."]
    assert script.answers_to("REPORT distances plot.svg") == ["Wrote plot.svg."]

    run = ElementTree.fromstring((tmp_path / "run.svg").read_text())
    space = "{http://www.w3.org/2000/svg}"
    assert [each.get("dur") for each in run.iter(f"{space}animateTransform")] == ["0.3s"] * 2
    assert "3 steps" in (run.findtext(f"{space}desc") or "")
    plot = ElementTree.fromstring((tmp_path / "plot.svg").read_text())
    assert "distance F" in [each.text for each in plot.iter(f"{space}text")]


def test_another_front_end_goes_on_with_the_path(open_script: OpenScript) -> None:
    script = open_script()
    script.run("FW 2\nTR 90\nFW 3")
    script.rest()
    ctx = script.ctx
    again = Context(ctx.donnie, ctx.interaction, ctx.workspace, AnswerLog(), LineHistory(), ctx.preferences)

    assert (again.trail.path, again.trail.rows()) == (ctx.trail.path, ctx.trail.rows())
    assert again.trail.path.lengths[-1] == 5
    again.close()


def test_pictures_of_a_run_are_what_their_names_say(open_script: OpenScript, tmp_path: Path) -> None:
    script = open_script()
    script.run("FW 2\nSPEAK DISTANCE F\nFW 1")
    script.rest()
    for what, name, form in (
        ("run", "run.png", "PNG"),
        ("run", "run.gif", "GIF"),
        ("distances", "plot.png", "PNG"),
    ):
        assert script.answers_to(f"REPORT {what} {name}") == [f"Wrote {name}."]
        assert Image.open(tmp_path / name).format == form
    assert (script.answers_to("REPORT distances d.txt"), (tmp_path / "d.txt").read_text()[:19]) == (
        ["Wrote d.txt."],
        "Distances over time",
    )


def test_a_run_of_more_than_a_thousand_moves_is_drawn_and_said_from_its_start(
    open_script: OpenScript, tmp_path: Path
) -> None:
    """600 legs on a stair of 300 steps to the north and to the east, after 7 steps to the south."""
    script = open_script()
    script.run("BW 7\nREPEAT 300 TIMES\nFW 1\nTR 90\nFW 1\nTL 90\nEND REPEAT")
    script.rest()
    script.answers_to("REPORT run run.svg")
    svg = ElementTree.fromstring((tmp_path / "run.svg").read_text())
    said = svg.findtext("{http://www.w3.org/2000/svg}desc") or ""
    shown = script.answers_to("SHOW PATH")

    assert "The path starts at 0, 0. South: 7 steps, to 0, -7. North: 1 step, to 0, -6." in said
    assert "I leave out 577 legs, to " in said  # 12 of 601 at each end are said
    assert said.endswith("East: 1 step, to 300, 293. 607 steps in all.")
    assert float(svg.attrib["height"]) < 1200
    assert shown[1:3] == ["The path starts at 0, 0.", "South: 7 steps, to 0, -7."]
    assert shown[102] == "I leave out 401 legs, to 250, 243."
    assert shown[203] == "607 steps in all."
    assert script.answers_to("REPORT trail t.txt") == ["Wrote t.txt."]
    assert (tmp_path / "t.txt").read_text().splitlines()[1] == "BW 7: 7 steps, to 0, -7."


@pytest.mark.parametrize(
    ("typed", "answer"),
    [
        ("map m.png", "A report of map can't end in .png. It can in .html, .htm, .csv, .txt."),
        (
            "distances d.gif",
            "A report of distances can't end in .gif. It can in .html, .htm, .csv, .txt, .svg, .png.",
        ),
    ],
)
def test_what_has_no_such_form_is_refused(
    open_script: OpenScript, tmp_path: Path, typed: str, answer: str
) -> None:
    assert open_script().answers_to(f"REPORT {typed}") == [answer]
    assert not [*tmp_path.glob("*.png"), *tmp_path.glob("*.gif")]


def test_a_picture_of_the_run_needs_no_more_than_its_name(open_script: OpenScript, tmp_path: Path) -> None:
    script = open_script()
    script.run("FW 2")
    script.rest()

    assert script.answers_to("REPORT lesson.svg") == ["Wrote lesson.svg."]
    assert "2 steps in all." in (tmp_path / "lesson.svg").read_text()


def test_the_driven_path_is_felt_on_a_sheet_for_swell_paper(open_script: OpenScript, tmp_path: Path) -> None:
    script = open_script()
    script.run("FW 2\nTR 90\nFW 1")
    script.rest()

    assert script.answers_to("REPORT paper sheet") == ["Wrote sheet.svg."]
    assert script.answers_to("REPORT paper sheet.png") == [
        "A report of paper can't end in .png. It can in .svg."
    ]

    sheet = (tmp_path / "sheet.svg").read_text()
    assert 'width="210mm"' in sheet
    assert sheet.count("stroke-dasharray") == 2  # the path, and its sample in the key


def test_a_run_without_a_file_is_said(open_script: OpenScript) -> None:
    script = open_script()
    assert script.answers_to("REPORT distances") == ["Nothing was measured yet."]
    script.run("VAR n = 1\nFW 2\nn = 2\nSPEAK DISTANCE F\nFW 1")
    script.rest()

    assert script.answers_to("REPORT run")[-1] == "3 steps in all."
    assert script.answers_to("REPORT distances")[1:] == [
        "The robot moves for 3 of 3 seconds, at most 1 step a second.",
        "Variables at the end: n = 2.",
    ]


def test_the_table_has_a_variable_as_it_was_at_each_moment(open_script: OpenScript, tmp_path: Path) -> None:
    script = open_script()
    script.run("VAR n = 1\nFW 2\nn = 2\nFW 1\nn = 7\nFW 1")
    script.rest()
    script.type("REPORT distances d.csv")

    assert list(csv.reader((tmp_path / "d.csv").read_text().splitlines())) == [
        ["seconds", "speed", "n"],
        ["0", "1", "1"],
        ["2", "1", "2"],
        ["3", "1", "7"],
        ["4", "1", "7"],
    ]


def test_the_log_replaces_a_file_only_after_a_yes(open_script: OpenScript, walk: Path) -> None:
    script = open_script(answers=["no", "yes"])
    script.ctx.answers.add_line("I walked 1 step forward.")
    assert script.answers_to("SAVE LOG walk.gd") == [UNCHANGED]
    assert walk.read_text(encoding="utf-8") == "FW 1\nTR 90\n"

    script.type("SAVE LOG walk.gd")
    assert "I walked 1 step forward." in walk.read_text(encoding="utf-8")


# --- examples


def test_an_example_is_chosen_from_a_list_and_written_in_the_learners_words(open_script: OpenScript) -> None:
    script = open_script(answers=["square"], language="pt")

    assert script.answers_to("EXEMPLOS")[-1] == "Abri Um quadrado, 4 linhas."

    assert script.ctx.program.text == "REPITA 4 VEZES\n  PF 3\n  GD 90\nFIM REPITA\n"
    assert script.ctx.program.path is None


def test_an_example_is_opened_by_its_number(open_script: OpenScript) -> None:
    script = open_script()

    assert script.answers_to("EXAMPLES 2") == ["Opened Up to the wall, 4 lines."]
    assert script.answers_to("EXAMPLES 99") == ["I did not understand. Type EXAMPLES 2."]


@pytest.mark.parametrize("name", EXAMPLES)
@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_each_example_runs_in_the_first_room_without_a_mistake(
    open_script: OpenScript, name: str, language: str
) -> None:
    script = open_script(answers=[name], language=language, world="first_room")
    script.type(words_of("examples", language)[0])

    script.type(words_of("run", language)[0])
    script.rest()

    assert script.ctx.program.lines
    assert script.ctx.errors.all == ()


def test_the_examples_are_listed_by_number_and_shown_in_the_learners_words(open_script: OpenScript) -> None:
    script = open_script(language="pt")
    said = script.answers_to("EXEMPLOS")

    offered = script.interaction.offered
    assert said == [f"{each.number}: {each.text}" for each in offered]
    assert [each.number for each in offered] == [*range(1, len(EXAMPLES) + 1)]
    assert offered[0].detail is not None
    assert offered[0].detail(40, 10) == ("REPITA 4 VEZES", "  PF 3", "  GD 90", "FIM REPITA", "")
    assert script.ctx.program.lines == ()


@pytest.mark.parametrize(("number", "title"), [(1, "A square"), (len(EXAMPLES), "Blue things")])
def test_the_first_and_the_last_example_have_a_number(
    open_script: OpenScript, number: int, title: str
) -> None:
    (said,) = open_script().answers_to(f"EXAMPLES {number}")
    assert said.startswith(f"Opened {title}, ")


# --- what is in use, in the background, or where no learner answers


def test_a_file_with_breakpoints_says_them_when_it_is_opened_again(
    open_script: OpenScript, walk: Path
) -> None:
    assert open_script().answers_to("OPEN walk", "BREAK 2", "BREAK 1", "NEW", "OPEN walk")[3:] == [
        *("This is a new program.", "Opened walk.gd, 2 lines.", "Breakpoints: 1, 2."),
    ]


def test_a_program_that_is_saved_into_the_file_to_be_opened_stays(
    open_script: OpenScript, walk: Path
) -> None:
    script = open_script(answers=["yes"])
    script.answers_to("OPEN walk", *["INSERT 1 FW 7"] * 4)

    assert script.answers_to("OPEN walk") == ["Saved walk.gd, 6 lines.", "Opened walk.gd, 6 lines."]
    assert script.ctx.program.text == walk.read_text() == "FW 7\nFW 7\nFW 7\nFW 7\nFW 1\nTR 90\n"


@pytest.mark.parametrize("typed", ["SAVE a.rec", "SAVE AS e.jsonl", "REPORT list a.rec", "SAVE LOG e.jsonl"])
def test_a_file_that_is_written_here_is_not_replaced(open_script: OpenScript, typed: str) -> None:
    script = open_script("FW 1", record="a.rec", events="e.jsonl")
    script.ctx.answers.add_line("Done.")

    assert script.answers_to(typed) == [f"{typed.split()[-1]} is in use here. Give another name."]


@pytest.mark.parametrize(
    ("typed", "tasks"),
    [
        ("OPEN walk.gd", [("Opening walk.gd, it takes a while.", True, False)]),
        ("SAVE new.gd", [("Saving new.gd, it takes a while.", False, False)] * 2),
        ("REPORT list a.csv", [("Writing a.csv, it takes a while.", False, False)]),
        ("SAVE LOG a.txt", [("Writing a.txt, it takes a while.", False, False)]),
        ("WORLD maze", [("Loading the world maze, it takes a while.", False, False)]),
        ("FORMAT", [("Tidying the program, it takes a while.", True, False)]),
        ("CONNECT x", [("I am still looking for the robot. Ctrl+C gives up.", False, True)]),
    ],
)
def test_what_may_take_long_says_so(
    open_script: OpenScript, walk: Path, typed: str, tasks: list[tuple[str, bool, bool]]
) -> None:
    script = open_script("FW 1")
    script.ctx.answers.add_line("Done.")
    with suppress(EnterWorld):
        script.type(typed)

    assert script.interaction.tasks == tasks


@pytest.mark.parametrize(
    ("typed", "answer"),
    [
        ("OPEN", "I did not understand. Type OPEN file."),
        ("OPEN wal", "There is no file wal."),
        ("SAVE", "I did not understand. Type SAVE file."),
        ("SAVE walk", "walk.gd exists already. Give another name."),
        ("SAVE LOG", "I did not understand. Type SAVE LOG log.txt."),
        ("SAVE LOG walk.gd", "walk.gd exists already. Give another name."),
        ("REPORT list walk.csv", "walk.csv exists already. Give another name."),
        ("SAVE WORLD", "I did not understand. Type SAVE WORLD room."),
        ("NEW", "This is a new program."),
    ],
)
def test_a_line_of_a_file_is_not_asked_about(
    open_script: OpenScript, walk: Path, typed: str, answer: str
) -> None:
    walk.with_suffix(".csv").write_text("1,2\n")
    script = open_script(*WORTH_SAVING)
    script.interaction.is_attended = False
    script.ctx.answers.add_line("Done.")

    assert script.answers_to(typed) == [answer]
    assert script.interaction.asked == []


# --- what fails, or is given up


def failing(*_: object) -> None:
    raise DocumentError("file-unwritable", "walk.gd", "the disk is full")


FULL = "I can't write walk.gd: the disk is full."


@pytest.mark.parametrize("typed", ["SAVE walk", "SAVE AS walk"])
def test_a_program_that_can_not_be_saved_stays_unsaved(
    open_script: OpenScript, monkeypatch: pytest.MonkeyPatch, typed: str
) -> None:
    script = open_script(*WORTH_SAVING)
    monkeypatch.setattr(script.ctx.workspace, "save", failing)

    assert script.answers_to(typed) == [FULL]
    assert not script.ctx.program.is_saved
    assert script.ctx.program.path is None


def test_a_report_that_can_not_be_written_says_only_why(
    open_script: OpenScript, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(files, "write_bytes", failing)

    assert open_script("FW 1").answers_to("REPORT list a.csv") == [FULL]


@pytest.mark.parametrize("typed", ["NEW", "OPEN walk", "EXAMPLES 1", "RECOVER"])
@pytest.mark.parametrize(
    ("answers", "said"),
    [
        ([None], UNCHANGED),
        (["yes", None], UNCHANGED),
        (["yes", "nowhere/a.gd"], "I can't write nowhere/a.gd: there is no such folder."),
    ],
)
def test_a_program_is_not_left_unless_it_is_saved_or_given_up(
    open_script: OpenScript,
    walk: Path,
    copies: Path,
    typed: str,
    answers: list[str | None],
    said: str,
) -> None:
    (copies / "unsaved-99999999-1.gd").write_text("FW 9\n")
    script = open_script(*WORTH_SAVING, answers=answers)

    assert script.answers_to(typed) == [said]
    assert script.ctx.program.lines == WORTH_SAVING


@pytest.mark.parametrize(
    ("typed", "lines"),
    [("NEW", ()), ("OPEN walk", ("FW 1", "TR 90")), ("RECOVER", ("FW 9",))],
)
def test_a_program_that_is_given_up_is_left(
    open_script: OpenScript, walk: Path, copies: Path, typed: str, lines: tuple[str, ...]
) -> None:
    (copies / "unsaved-99999999-1.gd").write_text("FW 9\n")
    script = open_script(*WORTH_SAVING, answers=["no"])
    script.type(typed)

    assert script.ctx.program.lines == lines
    assert script.interaction.asked == ["5 lines are not saved. Save first, y or n? Enter means no."]
