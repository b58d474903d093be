"""The program as a whole in the linear mode: mended, searched, replaced, laid out, translated, moved."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from tests.patience import PATIENCE
from tests.sessions.command import COMMAND, QUIET, donnie, environment
from tests.sessions.typed_lines import told


def test_what_was_probably_meant_takes_the_place_of_a_mistake(tmp_path: Path) -> None:
    assert told(tmp_path, "FW 1", "TRR 90", "RUN", "FIX", "LIST", "UNDO", "FIX", "FIX")[4:] == [
        "Line 2: TR 90",
        "1: FW 1",
        "2: TR 90",
        "Line 2: TRR 90",
        "Line 2: TR 90",
        "No mistakes were found.",
    ]


def test_error_explain_and_fix_speak_of_the_same_mistake_the_first_one(tmp_path: Path) -> None:
    answers = told(tmp_path, "FWD 1", "TRR 90", "SPEK 1", "RUN", "ERROR", "EXPLAIN", "FIX", "ERROR NEXT")[10:]

    assert answers[:3] == ["Error, line 1, column 1: I do not know FWD.", "Line 1: FWD 1", "Did you mean FW?"]
    assert answers[6:9] == ["Line 1: FWD 1", "Line 1: FW 1", "Error, line 2, column 1: I do not know TRR."]


def test_after_going_on_to_another_mistake_that_one_is_mended(tmp_path: Path) -> None:
    answers = told(tmp_path, "FWD 1", "TRR 90", "RUN", "ERROR NEXT", "FIX", "LIST")

    assert answers[-3:] == ["Line 2: TR 90", "1: FWD 1", "2: TR 90"]


def test_a_single_line_that_was_forgotten_because_of_a_mistake_comes_back_mended(tmp_path: Path) -> None:
    assert told(tmp_path, "FWD 1", "RUN", "FIX", "RUN")[3:] == ["Line 1: FW 1", "I walked 1 step forward."]
    assert told(tmp_path, "SPEAK", "RUN", "FIX", "CHANGE 1 SPEAK 5", "RUN")[2:] == [
        "I don't know what was meant.",
        "Line 1: SPEAK 5",
        "5",
    ]


def test_a_pipe_is_no_program_and_holds_no_prompt(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")

    done = donnie(tmp_path, "--linear", *QUIET, "pipe", typed="SPEAK 7\nRUN\n")
    assert done.stdout.decode().splitlines()[1:3] == ["pipe is no text.", "7"]


def test_words_are_found_from_the_reading_place_on_and_once_round(tmp_path: Path) -> None:
    program = ("FW 1", "TR 90", "fw 2", "RUN")
    walked = 3

    assert told(tmp_path, *program, "SEARCH FW", "SEARCH AGAIN", "SEARCH AGAIN", "SEARCH xyz")[walked:] == [
        "Line 1: FW 1",
        "Line 3: fw 2",
        "Line 1: FW 1",
        "xyz is not in the program.",
    ]


def test_a_word_is_replaced_everywhere_and_that_is_one_change(tmp_path: Path) -> None:
    assert told(tmp_path, "FW 1", "FW 2", "REPLACE FW", "BW", "LIST", "UNDO", "LIST") == [
        'Instead of FW, everywhere; Enter leaves it, "" deletes it:',
        "2 times replaced.",
        "1: BW 1",
        "2: BW 2",
        "Line 1: FW 1",
        "1: FW 1",
        "2: FW 2",
    ]


def test_a_word_that_nothing_is_typed_for_stays_as_it_is(tmp_path: Path) -> None:
    """L21: an empty answer, or the end of the input, changes nothing; two quotes delete the word."""
    empty = told(
        tmp_path, "FW 1 FW 2", "REPLACE FW", "", "LIST", 'REPLACE 1 "', "LIST", "REPLACE FW", '""', "LIST"
    )
    ended = donnie(tmp_path, "--linear", *QUIET, typed="FW 1\nREPLACE FW\n").stdout.decode().splitlines()

    assert empty[1:3] == ["Nothing was changed.", "1: FW 1 FW 2"]
    assert empty[-2:] == ["2 times replaced.", "1: 1  2"]
    assert ended[3] == "Nothing was changed."


def test_the_only_line_taken_back_leaves_none(tmp_path: Path) -> None:
    assert told(tmp_path, "FW 1", "UNDO") == ["No lines yet."]


def test_what_is_out_of_range_tells_the_range(tmp_path: Path) -> None:
    assert told(tmp_path, "SPEED 999999", "WHERE", "LAST 1000") == [
        "A speed is a number from 0.1 to 1000, or max.",
        "Position 0, 0. Facing north.",
        "2 answers so far.",
    ]


def test_lines_that_a_mistake_kept_from_running_are_told_so_at_the_end(tmp_path: Path) -> None:
    done = donnie(tmp_path, "--linear", *QUIET, typed="FW 1\nTRR 90\nRUN\n")

    assert done.stdout.decode().splitlines()[-2] == "2 lines did not run because of the mistake."


def test_what_typed_lines_of_a_file_set_counts_for_them_alone(tmp_path: Path) -> None:
    """As DETAIL and LANGUAGE: nobody at a prompt chose it."""
    lines = told(
        tmp_path, "SET rate 9999", "SET speech own", "SET page off", "SET bump off", "SET cue bump off"
    )

    assert "Set page: off." in " ".join(lines) or "page: off" in " ".join(lines)
    assert not (tmp_path / "config").exists()


def test_a_program_is_laid_out_and_its_words_translated(tmp_path: Path) -> None:
    assert told(tmp_path, "REPEAT 2 TIMES FW 1", "END REPEAT", "FORMAT", "TRANSLATE pt", "LIST") == [
        "Laid out anew.",
        "Laid out anew.",
        "1: REPITA 2 VEZES",
        "2: PF 1",
        "3: FIM REPITA",
    ]


def test_where_there_are_no_lines_nothing_is_laid_out(tmp_path: Path) -> None:
    assert told(tmp_path, "FORMAT", "TRANSLATE pt") == ["No lines yet.", "No lines yet."]


def test_a_program_with_a_mistake_is_not_laid_out(tmp_path: Path) -> None:
    assert told(tmp_path, "FW 1", "FW", "FORMAT")[:1] == [
        "There is a mistake in line 2; it must be mended first."
    ]


def test_lines_are_moved_and_told_at_their_new_place(tmp_path: Path) -> None:
    assert told(tmp_path, "FW 1", "FW 2", "FW 3", "MOVE 2 3 1", "LIST", "MOVE 9 1") == [
        "Line 1: FW 2",
        "Line 2: FW 3",
        "1: FW 2",
        "2: FW 3",
        "3: FW 1",
        "There is no line 9. The last is 3.",
    ]


def test_a_program_of_a_thousand_lines_is_read_and_changed(tmp_path: Path) -> None:
    (tmp_path / "long.gd").write_text("FW 1\n" * 998 + "REPEAT 2 TIMES\nEND REPEAT\n")

    assert told(tmp_path, "OPEN long", "READ 1000", "UP", "CHANGE 500 TR 90", "PLACE", "OUTLINE")[1:] == [
        "Line 1000: END REPEAT, closes line 999.",
        "Line 999: REPEAT 2 TIMES",
        "Line 500: TR 90",
        "Line 500 of 1000, level 0.",
        "1 block.",
        "Line 999, level 0: REPEAT 2 TIMES",
    ]


def test_the_manual_is_read_chapter_by_chapter(tmp_path: Path) -> None:
    chapters = told(tmp_path, "MANUAL")
    first = told(tmp_path, "MANUAL 1")

    assert chapters[0] == f"{len(chapters) - 1} chapters. MANUAL 1 reads the first."
    assert all(first)
    assert len(first) > 3


def test_errors_are_walked_through_and_explained(tmp_path: Path) -> None:
    lines = told(
        tmp_path, "FWD 1", "TR", "RUN", "ERROR", "ERROR NEXT", "ERROR NEXT", "ERROR PREVIOUS", "EXPLAIN"
    )
    start = lines.index("Nothing ran. FIX mends line 1, CHANGE 1 changes it.") + 1

    assert [line for line in lines[start:] if not line.startswith(("Line", "Did"))] == [
        "Error, line 1, column 1: I do not know FWD.",
        *[line for line in lines[:start] if line.startswith("Error, line 2")],
        "No more errors. That is 2 of 2.",
        "Error, line 1, column 1: I do not know FWD.",
        "Donnie does not know this word.",
        "Example: FW 5.",
    ]
    assert lines[-1] == "Line 1: FWD 1"


def test_a_slip_in_a_word_of_the_terminal_is_told_at_once_and_is_no_line_of_the_program(
    tmp_path: Path,
) -> None:
    assert told(tmp_path, "FW 2", "LISTT", "AJUSTES", "RUN", "LIST", "FW 1", "UNDO", "LIST") == [
        "I do not know LISTT. Did you mean LIST?",
        "I do not know AJUSTES. Did you mean AJUSTAR?",
        "I walked 2 steps forward.",
        "1: FW 2",
        "1 line.",
        "1: FW 2",
    ]


def test_settings_and_its_synonyms_are_set(tmp_path: Path) -> None:
    assert told(tmp_path, "SETTINGS") == told(tmp_path, "CONFIGURE") == told(tmp_path, "SET")


def test_signs_of_life_are_never_given_rather_than_every_nought_seconds(tmp_path: Path) -> None:
    assert told(tmp_path, "SET progress 0", "SET progress 1") == [
        "Signs of life, progress: never.",
        "Signs of life, progress: 1 second.",
    ]


def test_reports_are_written_as_pages_tables_and_text(tmp_path: Path) -> None:
    lines = told(tmp_path, "FW 3", "RUN", "REPORT map m", "REPORT trail t.csv", "REPORT help h", "SAVE LOG l")

    assert lines[1:] == ["Wrote m.html.", "Wrote t.csv.", "Wrote h.html.", "Wrote l.txt."]
    assert "<h2>The map</h2>" in (tmp_path / "m.html").read_text()
    assert (tmp_path / "t.csv").read_text() == "command,done,x,y,heading,blocked\nFW 3,3,0,3,0,no\n"
    assert "I walked 3 steps forward." in (tmp_path / "l.txt").read_text()


def test_who_saves_nothing_or_replaces_nothing_is_asked_nothing(tmp_path: Path) -> None:
    """The line that comes next is one of the program, not a file's name."""
    assert told(tmp_path, "SAVE", "REPLACE FW", "FW 2", "RUN", "SAVE", "REPLACE TR", "LIST") == [
        "Nothing to save.",
        "FW is not in the program.",
        "I walked 2 steps forward.",
        "I did not understand. Type SAVE file.",
        "TR is not in the program.",
        "1: FW 2",
    ]


def test_a_forgotten_number_is_explained_as_something_missing_with_its_line(tmp_path: Path) -> None:
    lines = told(tmp_path, "FW", "RUN", "EXPLAIN")

    assert lines[-4:] == [
        "Something is missing or out of place.",
        "Form: FW value, or FORWARD value.",
        "Example: FW 5.",
        "Line 1: FW",
    ]


def test_a_mistake_is_explained_with_its_own_line_though_another_stands_there_now(tmp_path: Path) -> None:
    lines = told(tmp_path, "FW 2", "END REPEAT", "RUN", 'INSERT 2 SPEAK "a"', "EXPLAIN")

    assert (lines[-4], lines[-1]) == ("This END does not fit what is open.", "Line 2: END REPEAT")


@pytest.mark.parametrize("closed", ["<&-", "<&- >&-", "<&- 2>&-"])
def test_a_closed_input_is_an_empty_one(tmp_path: Path, closed: str) -> None:
    ended = subprocess.run(
        ["sh", "-c", f'exec "$@" {closed}', "sh", *COMMAND, "--linear", *QUIET],
        stdout=subprocess.PIPE,
        cwd=tmp_path,
        env=environment(tmp_path),
        timeout=PATIENCE,
    )

    assert ended.returncode == 0
    assert (b"Goodbye." in ended.stdout) == (">&-" not in closed.split())


def test_whoever_changes_what_has_run_is_told_that_all_of_it_waits_again(tmp_path: Path) -> None:
    """Else Enter, or QUIT, would let the robot walk by surprise."""
    lines = told(tmp_path, "FW 1", "TR 90", "RUN", "TRANSLATE es", "RUN", "UNDO")
    asked = [line for line in lines if not line.startswith(("I ", "Line"))]

    assert asked == [
        "Laid out anew.",
        "RUN runs all 2 lines again.",
        "RUN runs all 2 lines again.",
    ]


@pytest.mark.parametrize(
    "typed",
    [
        b"FW 1\rSPEAK 7\rRUN\r",
        b"FW 1\r\nSPEAK 7\r\nRUN",
        "\ufeffFW 1\r\nSPEAK 7\r\nRUN\r\n".encode("utf-16-le"),
        "\ufeffFW 1\nSPEAK 7\nRUN\n".encode("utf-16-be"),
    ],
    ids=["cr", "crlf", "utf16le", "utf16be"],
)
def test_typed_lines_end_as_on_any_system_and_may_be_utf16(tmp_path: Path, typed: bytes) -> None:
    done = donnie(tmp_path, "--linear", *QUIET, "--speed", "max", typed=typed)

    assert done.stdout.decode().splitlines()[2:] == ["I walked 1 step forward.", "7", "Goodbye."]


def test_one_huge_line_is_refused_once_and_the_others_are_done(tmp_path: Path) -> None:
    typed = b"FW 1\n" + b"x" * 3_000_000 + b"\nRUN\n" + b"y" * 1_100_000
    done = donnie(tmp_path, "--linear", *QUIET, "--speed", "max", typed=typed)
    lost = "The program is too long. That line is lost."

    assert done.stdout.decode().splitlines()[2:] == [lost, "I walked 1 step forward.", lost, "Goodbye."]


def test_a_change_that_is_taken_back_lets_nothing_run_twice(tmp_path: Path) -> None:
    assert told(tmp_path, "FW 1", "FW 2", "RUN", "CHANGE 1 FW 5", "UNDO", "FW 3", "RUN") == [
        "I walked 1 step forward.",
        "I walked 2 steps forward.",
        "Line 1: FW 5",
        "RUN runs all 2 lines again.",
        "Line 1: FW 1",
        "I walked 3 steps forward.",
    ]


def test_a_program_that_cant_run_again_leaves_everything_as_it_is(tmp_path: Path) -> None:
    assert told(
        tmp_path, "VAR a = 2", "FW a", "WATCH a", "RUN", "FWD 2", "AGAIN", "DELETE 3", "FW 1", "RUN"
    ) == [
        "Watching a.",
        "a is 2.",
        "I walked 2 steps forward.",
        "Error, line 3, column 1: I do not know FWD.",
        "Line 3: FWD 2",
        "Did you mean FW?",
        "Line 3 deleted.",
        "I walked 1 step forward.",
    ]


def test_what_is_deleted_is_told_by_its_number_and_what_stands_there_now(tmp_path: Path) -> None:
    """L39."""
    program = ("FW 1", "FW 2", "FW 3", "FW 4", "FW 5", "FW 6")
    assert told(tmp_path, *program, "DELETE 2", "DELETE 1 2", "DELETE 3", "DELETE") == [
        "Line 2 deleted.",
        "Line 2: FW 3",
        "Lines 1 to 2 deleted.",
        "Line 1: FW 4",
        "Line 3 deleted.",
        "Lines 1 to 2 deleted.",
    ]


def test_what_was_said_is_said_again_found_and_spelled_and_nothing_runs_again(tmp_path: Path) -> None:
    said = told(
        tmp_path, "FW 3", "TR 90", "RUN", "WHERE", "LAST", "LAST 2", "FIND walked", "LAST WORD", "WHERE"
    )

    assert said[2:] == [
        "Position 0, 3. Facing east.",
        "Position 0, 3. Facing east.",
        "I walked 3 steps forward.",
        "I turned 90 degrees to the right.",
        "1 line, the newest last.",
        "I walked 3 steps forward.",
        "e, a, s, t.",
        "Position 0, 3. Facing east.",
    ]


def test_at_detail_full_where_tells_the_last_movement_too(tmp_path: Path) -> None:
    said = told(tmp_path, "FW 3", "RUN", "WHERE", "DETAIL full", "WHERE", "WHERE")
    place, full = "Position 0, 3. Facing north.", "FW 3: 3 steps, to 0, 3."

    assert said[1:] == [place, "Detail: full.", place, full, place, full]
