"""Programs typed with real keys: fixed, run, stepped through, recalled, saved and left."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.sessions.learner import (
    CTRL_D,
    ESC,
    HOME,
    UP,
    Learner,
    said,
)

pytestmark = pytest.mark.slow


def test_a_mistake_is_reported_with_its_line_and_the_probable_meaning(learner: Learner) -> None:
    learner.enters("FW 1", "RUN", "FWD 3", "RUN")
    learner.sees_prompt()

    assert said(learner)[3:] == [
        "Error, line 2, column 1: I do not know FWD.",
        "Line 2: FWD 3",
        "Did you mean FW?",
        "Nothing ran, line 2 was dropped.",
    ]


def test_lines_with_a_mistake_are_kept_and_fixed(learner: Learner) -> None:
    learner.enters("FW 1", "TRR 90", "RUN")
    learner.sees("Nothing ran, 2 lines wait. FIX corrects line 2.")
    learner.enters("CHANGE 2")
    learner.sees("Edit line 2, then Enter.\r\n> TRR 90")
    learner.types(HOME + "\x1b[3~" + "\r")
    learner.sees("Line 2: RR 90")
    learner.enters("CHANGE 2 TR 90", "RUN")
    learner.sees("I turned 90 degrees to the right.\r\n> ")


def test_a_forgotten_line_is_offered_again_fixed_or_unchanged(learner: Learner) -> None:
    learner.enters("FWD 3", "")
    learner.enters("FIX")
    learner.sees("Edit line 1, then Enter.\r\n> FW 3")
    learner.types("\r")
    learner.enters("", "SPEAK", "")
    learner.enters("CHANGE 2")
    learner.sees("Edit line 2, then Enter.\r\n> SPEAK")
    learner.types(" 5\r")
    learner.enters("")
    learner.sees("\n5\r\n> ")


def test_escape_and_ctrl_c_cancel_a_requested_line(learner: Learner) -> None:
    learner.enters("FW 1", "TR 90", "INSERT 1")
    for give_up in (ESC, "\x03"):
        learner.sees_prompt()
        learner.types(give_up)
        learner.sees("Nothing was changed.")
        learner.enters("LIST")
        learner.sees("1: FW 1\r\n2: TR 90\r\n")
        learner.enters("INSERT 1")
    learner.sees_prompt()
    learner.types(ESC)
    learner.enters("REPLACE FW")
    learner.sees_prompt()
    learner.types("\x03")
    learner.sees("Nothing was changed.")
    learner.enters("LIST")
    learner.sees("1: FW 1\r\n")


def test_an_empty_line_runs_pending_lines_but_not_half_a_block(learner: Learner) -> None:
    learner.enters("REPEAT 2 TIMES", "FW 1", "")
    learner.sees("REPEAT in line 1 is still open.")
    learner.enters("END REPEAT", "")
    learner.sees("I walked 1 step forward.\r\nI walked 1 step forward.\r\n> ")


def test_an_empty_line_after_an_else_if_says_which_end_is_missing(learner: Learner) -> None:
    learner.enters("IF 1 > 2 THEN", "ELSE IF 2 > 1 THEN", "END IF", "")
    learner.sees("IF in line 1 is still open.")
    learner.sees("ELSE IF needs another END IF.")


def test_escape_runs_the_unfinished_line_too(learner: Learner) -> None:
    learner.sees_prompt()
    learner.types("FW 2" + ESC)
    learner.sees("I walked 2 steps forward.")


def test_run_without_anything_to_run_says_so(learner: Learner) -> None:
    learner.enters("RUN")
    learner.sees("There is nothing to run.\r\n> ")


def test_a_run_without_output_says_that_it_is_done(learner: Learner) -> None:
    learner.enters("VAR x = 5", "RUN")
    learner.sees("Done.\r\n> ")


def test_arrow_up_restores_typed_lines_also_in_the_next_session(learner: Learner, tmp_path: Path) -> None:
    learner.enters("FW 3", "RUN", "QUIT")
    assert learner.leaves() == 0

    again = Learner(tmp_path)
    again.sees_prompt()
    again.types(UP)
    again.sees("QUIT")
    again.types(UP + UP)
    again.sees("FW 3")
    again.types("0" + ESC)
    again.sees("I walked 30 steps forward.")


def test_a_program_is_saved_and_opened(learner: Learner, tmp_path: Path) -> None:
    learner.enters("FW 3", "TR 90", "SAVE corner")
    learner.sees("Saved corner.gd, 2 lines.")
    learner.enters("NEW", "LIST")
    learner.sees("There are no lines yet.")
    learner.enters("OPEN corner", "SAVE AS other name")
    learner.sees("Saved other name.gd, 2 lines.")
    learner.enters("RUN")
    learner.sees("I turned 90 degrees to the right.")

    assert (tmp_path / "corner.gd").read_text() == "FW 3\nTR 90\n"


def test_a_file_changed_by_another_program_is_replaced_only_if_confirmed(
    learner: Learner, tmp_path: Path
) -> None:
    learner.enters("FW 3", "SAVE mine")
    learner.sees("Saved mine.gd, 1 line.")
    (tmp_path / "mine.gd").write_text("BW 1\n")
    learner.enters("FW 4", "SAVE")
    learner.sees("mine.gd was changed elsewhere. Replace it, y or n? Enter means no.")
    learner.enters("")
    learner.sees("Nothing was changed.")
    assert (tmp_path / "mine.gd").read_text() == "BW 1\n"

    learner.enters("SAVE")
    learner.sees("changed elsewhere")
    learner.enters("y")
    learner.sees("Saved mine.gd, 2 lines.")
    learner.enters("SAVE")
    learner.sees("Saved mine.gd, 2 lines.")


def test_another_file_is_replaced_only_if_confirmed(learner: Learner, tmp_path: Path) -> None:
    (tmp_path / "mine.gd").write_text("BW 1\n")
    learner.enters("FW 3", "SAVE mine")
    learner.sees("mine.gd exists. Replace it, y or n? Enter means no.")
    learner.enters("maybe")
    learner.sees("Type y or n.")
    learner.enters("")
    learner.sees("Nothing was changed.")

    assert (tmp_path / "mine.gd").read_text() == "BW 1\n"


def test_a_program_on_the_command_line_waits_to_be_run(tmp_path: Path) -> None:
    (tmp_path / "walk.gd").write_text("FW 2\n-- turn\nTR 90\n")
    learner = Learner(tmp_path, "walk.gd")
    learner.sees_prompt()

    assert said(learner) == ["Linear mode, from the option.", "Opened walk.gd, 3 lines."]


def _says(learner: Learner, line: str, answer: str) -> None:
    """The learner types a line for the held program and gets an answer."""
    learner.types(f"{line}\r")
    learner.sees(answer)


def test_a_program_is_stepped_through(learner: Learner) -> None:
    learner.enters("VAR x = 2", "FW x", "TR 90", "STEP")
    learner.sees("Line 1: VAR x = 2\r\n> ")
    _says(learner, "", "Line 2: FW x\r\n> ")
    _says(learner, "WHERE", "Position 0, 0. Facing north.\r\n> ")
    _says(learner, "", "I walked 2 steps forward.\r\nLine 3: TR 90\r\n> ")
    _says(learner, "RUN", "I turned 90 degrees to the right.\r\n> ")


def test_the_reading_place_is_the_line_where_a_program_holds(learner: Learner) -> None:
    learner.enters("FW 1", "TR 90", "FW 2", "STEP")
    learner.sees("Line 1: FW 1\r\n> ")
    _says(learner, "", "Line 2: TR 90\r\n> ")
    _says(learner, "PLACE", "Line 2 of 3, level 0.\r\n> ")
    _says(learner, "READ", "Line 2: TR 90\r\n> ")


@pytest.mark.parametrize(
    ("typed", "answer"),
    [
        (("FW 3",), "1 line did not run. RUN was missing."),
        (("REPEAT 2", "FW 1"), "2 lines did not run. END REPEAT was missing."),
    ],
    ids=["line", "open block"],
)
def test_quit_asks_once_about_lines_that_wait_and_leaves(
    learner: Learner, typed: tuple[str, ...], answer: str
) -> None:
    learner.enters(*typed, "QUIT")
    learner.sees(answer)
    learner.sees("Save first, y or n? Enter means no.")
    learner.enters("n")

    assert learner.leaves() == 0
    assert not [line for line in said(learner) if line.startswith("I ")]


@pytest.mark.parametrize("typed", [(), ("TR 90",)], ids=["opened", "typed behind it"])
def test_quit_moves_no_robot_by_a_program_that_was_only_opened(
    tmp_path: Path, typed: tuple[str, ...]
) -> None:
    (tmp_path / "walk.gd").write_text("FW 2\nREPEAT 2 TIMES\nFW 1\n")
    learner = Learner(tmp_path, "walk.gd")
    learner.enters(*typed, "QUIT")
    learner.sees(f"{3 + len(typed)} lines did not run. END REPEAT was missing.")
    if typed:
        learner.enters("n")  # not saved

    assert learner.leaves() == 0
    assert not [line for line in said(learner) if line.startswith("I ")]


def test_quit_runs_no_line_typed_after_the_opened_program_ran(tmp_path: Path) -> None:
    (tmp_path / "walk.gd").write_text("FW 2\n")
    learner = Learner(tmp_path, "walk.gd")
    learner.enters("RUN", "TR 90", "QUIT", "n")

    assert learner.leaves() == 0
    assert "1 line did not run. RUN was missing." in said(learner)
    assert "I turned 90 degrees to the right." not in said(learner)


def test_a_program_that_would_be_missed_is_asked_about_once(learner: Learner, tmp_path: Path) -> None:
    learner.enters("FW 1", "FW 2", "FW 3", "FW 4", "FW 5")
    learner.sees_prompt()
    learner.types(CTRL_D)
    learner.sees("5 lines are not saved. Save first, y or n? Enter means no.")
    learner.enters("y", "five")

    assert learner.leaves() == 0
    assert (tmp_path / "five.gd").read_text() == "FW 1\nFW 2\nFW 3\nFW 4\nFW 5\n"


def test_the_three_languages_are_all_understood_and_one_is_spoken(tmp_path: Path) -> None:
    learner = Learner(tmp_path, language="pt")
    learner.enters("PF 2", "EXECUTAR")
    learner.sees("Andei 2 passos para frente.")
    learner.enters("IDIOMA es", "AV 1", "EJECUTAR")
    learner.sees("Caminé 1 paso hacia adelante.")
    learner.enters("WHERE", "SAIR")

    assert learner.leaves() == 0
    assert said(learner)[-3:] == [
        "Posición 0, 3. Mirando al norte.",
        "Quedan guardadas 2 líneas. RECUPERAR las abre.",
        "Hasta luego.",
    ]


def test_tab_completes_names_inside_a_folder(learner: Learner, tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "walk.gd").write_text("FW 2\n")
    learner.sees_prompt()
    learner.types("OPEN mi\t")
    learner.sees("ne/")
    learner.types("w\t")
    learner.sees("alk.gd ")
    learner.types("\r")
    learner.sees("Opened walk.gd, 1 line.")


def test_tab_knows_what_may_follow_a_word_of_the_terminal(learner: Learner) -> None:
    learner.sees_prompt()
    learner.types("AROUND south\t")
    learner.sees("3 words.")
    learner.sees("AROUND south")
    learner.types("w\t")
    learner.sees("est ")
