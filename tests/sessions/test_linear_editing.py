"""The whole program in the linear mode: fixed, searched, replaced, formatted, translated, moved."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from tests.sessions.command import COMMAND, QUIET, donnie, environment
from tests.sessions.typed_lines import answers_to
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow


def test_fix_replaces_a_mistake_by_the_probable_meaning(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "FW 1", "TRR 90", "RUN", "FIX", "LIST", "UNDO", "FIX", "FIX")[4:] == [
        "Line 2: TR 90",
        "1: FW 1",
        "2: TR 90",
        "Line 2: TRR 90",
        "Line 2: TR 90",
        "No mistakes were found.",
    ]


def test_error_explain_and_fix_are_about_the_first_mistake(tmp_path: Path) -> None:
    answers = answers_to(
        tmp_path, "FWD 1", "TRR 90", "SPEK 1", "RUN", "ERROR", "EXPLAIN", "FIX", "ERROR NEXT"
    )[10:]

    assert answers[:3] == ["Error, line 1, column 1: I do not know FWD.", "Line 1: FWD 1", "Did you mean FW?"]
    assert answers[6:9] == ["Line 1: FWD 1", "Line 1: FW 1", "Error, line 2, column 1: I do not know TRR."]


def test_fix_is_about_the_mistake_that_was_selected_last(tmp_path: Path) -> None:
    answers = answers_to(tmp_path, "FWD 1", "TRR 90", "RUN", "ERROR NEXT", "FIX", "LIST")

    assert answers[-3:] == ["Line 2: TR 90", "1: FWD 1", "2: TR 90"]


def test_a_single_line_forgotten_after_a_mistake_is_restored_fixed(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "FWD 1", "RUN", "FIX", "RUN")[4:] == [
        "Line 1: FW 1",
        "I walked 1 step forward.",
    ]
    assert answers_to(tmp_path, "SPEAK", "RUN", "FIX", "CHANGE 1 SPEAK 5", "RUN")[3:] == [
        "I don't know what was meant.",
        "Line 1: SPEAK 5",
        "5",
    ]


def test_a_pipe_is_no_program_and_does_not_block_the_prompt(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")

    done = donnie(tmp_path, "--linear", *QUIET, "pipe", typed="SPEAK 7\nRUN\n")
    assert done.stdout.decode().splitlines()[1:3] == ["pipe is not an ordinary file.", "7"]


def test_a_search_starts_at_the_reading_place_and_wraps_around(tmp_path: Path) -> None:
    program = ("FW 1", "TR 90", "fw 2", "RUN")
    walked = 3

    assert answers_to(tmp_path, *program, "SEARCH FW", "SEARCH AGAIN", "SEARCH AGAIN", "SEARCH xyz")[
        walked:
    ] == [
        "Line 1: FW 1",
        "Line 3: fw 2",
        "Line 1: FW 1",
        "xyz is not in the program.",
    ]


def test_replacing_a_word_everywhere_is_one_change(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "FW 1", "FW 2", "REPLACE FW", "BW", "LIST", "UNDO", "LIST") == [
        'Instead of FW, everywhere; Enter leaves it, "" deletes it:',
        "Replaced 2 times.",
        "1: BW 1",
        "2: BW 2",
        "Line 1: FW 1",
        "1: FW 1",
        "2: FW 2",
    ]


def test_a_word_without_a_replacement_stays(tmp_path: Path) -> None:
    """An empty answer, or the end of the input, changes nothing. Two quotes delete the word."""
    empty = answers_to(
        tmp_path, "FW 1 FW 2", "REPLACE FW", "", "LIST", 'REPLACE 1 "', "LIST", "REPLACE FW", '""', "LIST"
    )
    ended = donnie(tmp_path, "--linear", *QUIET, typed="FW 1\nREPLACE FW\n").stdout.decode().splitlines()

    assert empty[1:3] == ["Nothing was changed.", "1: FW 1 FW 2"]
    assert empty[-2:] == ["Replaced 2 times.", "1: 1  2"]
    assert ended[3] == "Nothing was changed."


def test_undoing_the_only_line_leaves_an_empty_program(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "FW 1", "UNDO") == ["There are no lines yet."]


def test_a_number_out_of_range_is_answered_with_the_range(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "SPEED 999999", "WHERE", "LAST 1000") == [
        "A speed is a number from 0.1 to 1000, or max.",
        "Position 0, 0. Facing north.",
        "2 answers so far.",
    ]


def test_lines_that_did_not_run_because_of_a_mistake_are_reported_at_the_end(tmp_path: Path) -> None:
    done = donnie(tmp_path, "--linear", *QUIET, typed="FW 1\nTRR 90\nRUN\n")

    assert done.stdout.decode().splitlines()[-2] == "2 lines did not run because of the mistake."


def test_settings_in_lines_of_a_file_count_only_for_that_file(tmp_path: Path) -> None:
    """As with DETAIL and LANGUAGE: no learner chose it at a prompt."""
    lines = answers_to(
        tmp_path, "SET rate 9999", "SET speech own", "SET page off", "SET bump off", "SET cue bump off"
    )

    assert "Set page: off." in " ".join(lines) or "page: off" in " ".join(lines)
    assert not (tmp_path / "config").exists()


def test_a_program_is_formatted_and_its_words_translated(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "REPEAT 2 TIMES FW 1", "END REPEAT", "FORMAT", "TRANSLATE pt", "LIST") == [
        "The program is tidy now.",
        "The program is tidy now.",
        "1: REPITA 2 VEZES",
        "2: PF 1",
        "3: FIM REPITA",
    ]


def test_an_empty_program_is_not_formatted(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "FORMAT", "TRANSLATE pt") == [
        "There are no lines yet.",
        "There are no lines yet.",
    ]


def test_a_program_with_a_mistake_is_not_formatted(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "FW 1", "FW", "FORMAT")[:1] == ["There is a mistake in line 2; fix it first."]


def test_moved_lines_are_printed_at_their_new_place(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "FW 1", "FW 2", "FW 3", "MOVE 2 3 1", "LIST", "MOVE 9 1") == [
        "Line 1: FW 2",
        "Line 2: FW 3",
        "1: FW 2",
        "2: FW 3",
        "3: FW 1",
        "There is no line 9. The last is 3.",
    ]


def test_a_program_of_a_thousand_lines_is_read_and_changed(tmp_path: Path) -> None:
    (tmp_path / "long.gd").write_text("FW 1\n" * 998 + "REPEAT 2 TIMES\nEND REPEAT\n")

    assert answers_to(tmp_path, "OPEN long", "READ 1000", "UP", "CHANGE 500 TR 90", "PLACE", "OUTLINE")[
        1:
    ] == [
        "Line 1000: END REPEAT, closes line 999.",
        "Line 999: REPEAT 2 TIMES",
        "Line 500: TR 90",
        "Line 500 of 1000, level 0.",
        "1 block.",
        "Line 999, level 0: REPEAT 2 TIMES",
    ]


def test_the_manual_is_read_chapter_by_chapter(tmp_path: Path) -> None:
    chapters = answers_to(tmp_path, "MANUAL")
    first = answers_to(tmp_path, "MANUAL 1")

    assert chapters[0] == f"{len(chapters) - 2} chapters. MANUAL 1 reads the first."
    assert chapters[-1].startswith("First steps, to read: ")
    assert all(first)
    assert len(first) > 3


def test_errors_are_visited_and_explained(tmp_path: Path) -> None:
    lines = answers_to(
        tmp_path, "FWD 1", "TR", "RUN", "ERROR", "ERROR NEXT", "ERROR NEXT", "ERROR PREVIOUS", "EXPLAIN"
    )
    start = lines.index("Nothing ran, 2 lines wait. FIX corrects line 1.") + 1

    assert [line for line in lines[start:] if not line.startswith(("Line", "Did"))] == [
        "Error, line 1, column 1: I do not know FWD.",
        *[line for line in lines[:start] if line.startswith("Error, line 2")],
        "No more errors. That is 2 of 2.",
        "Error, line 1, column 1: I do not know FWD.",
        "Donnie does not know this word.",
        "Example: FW 5.",
    ]
    assert lines[-1] == "Line 1: FWD 1"


def test_a_misspelt_command_is_reported_at_once_and_not_added_to_the_program(
    tmp_path: Path,
) -> None:
    assert answers_to(tmp_path, "FW 2", "LISTT", "WHRE", "RUN", "LIST", "FW 1", "UNDO", "LIST") == [
        "I do not know LISTT. Did you mean LIST?",
        "I do not know WHRE. Did you mean WHERE?",
        "I walked 2 steps forward.",
        "1: FW 2",
        "Your program has 1 line.",
        "1: FW 2",
    ]


def test_settings_and_its_synonyms_are_set(tmp_path: Path) -> None:
    assert (
        answers_to(tmp_path, "SETTINGS") == answers_to(tmp_path, "CONFIGURE") == answers_to(tmp_path, "SET")
    )


def test_an_interval_of_zero_seconds_switches_progress_reports_off(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "SET progress 0", "SET progress 1") == [
        "Progress reports, progress: never.",
        "Progress reports, progress: 1 second.",
    ]


def test_reports_are_written_as_pages_tables_and_text(tmp_path: Path) -> None:
    lines = answers_to(
        tmp_path, "FW 3", "RUN", "REPORT map m", "REPORT trail t.csv", "REPORT help h", "SAVE LOG l"
    )

    assert lines[1:] == ["Wrote m.html.", "Wrote t.csv.", "Wrote h.html.", "Wrote l.txt."]
    assert "<h2>The map</h2>" in (tmp_path / "m.html").read_text()
    assert (tmp_path / "t.csv").read_text() == "command,done,x,y,heading,blocked\nFW 3,3,0,3,0,no\n"
    assert "I walked 3 steps forward." in (tmp_path / "l.txt").read_text()


def test_saving_or_replacing_nothing_asks_no_question(tmp_path: Path) -> None:
    """The next line belongs to the program and is no name of a file."""
    assert answers_to(tmp_path, "SAVE", "REPLACE FW", "FW 2", "RUN", "SAVE", "REPLACE TR", "LIST") == [
        "There is nothing to save.",
        "FW is not in the program.",
        "I walked 2 steps forward.",
        "I did not understand. Type SAVE file.",
        "TR is not in the program.",
        "1: FW 2",
    ]


def test_a_missing_number_is_explained_with_its_line(tmp_path: Path) -> None:
    lines = answers_to(tmp_path, "FW", "RUN", "EXPLAIN")

    assert lines[-4:] == [
        "Something is missing or out of place.",
        "You write: FW value, or FORWARD value.",
        "Example: FW 5.",
        "Line 1: FW",
    ]


def test_a_mistake_is_explained_with_its_original_line(tmp_path: Path) -> None:
    lines = answers_to(tmp_path, "FW 2", "END REPEAT", "RUN", 'INSERT 2 SPEAK "a"', "EXPLAIN")

    assert (lines[-4], lines[-1]) == ("This END does not fit what is open.", "Line 2: END REPEAT")


@pytest.mark.parametrize("closed", ["<&-", "<&- >&-", "<&- 2>&-"])
def test_a_closed_input_is_an_empty_one(tmp_path: Path, closed: str) -> None:
    ended = subprocess.run(
        ["sh", "-c", f'exec "$@" {closed}', "sh", *COMMAND, "--linear", *QUIET],
        stdout=subprocess.PIPE,
        cwd=tmp_path,
        env=environment(tmp_path),
        timeout=TIMEOUT,
    )

    assert ended.returncode == 0
    assert (b"Goodbye." in ended.stdout) == (">&-" not in closed.split())


def test_changing_lines_that_ran_reports_that_the_whole_program_is_pending(tmp_path: Path) -> None:
    """Otherwise Enter or QUIT would move the robot by surprise."""
    lines = answers_to(tmp_path, "FW 1", "TR 90", "RUN", "TRANSLATE es", "RUN", "UNDO")
    asked = [line for line in lines if not line.startswith(("I ", "Line"))]

    assert asked == [
        "The program is tidy now.",
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


def test_one_huge_line_is_refused_once_and_the_others_run(tmp_path: Path) -> None:
    typed = b"FW 1\n" + b"x" * 3_000_000 + b"\nRUN\n" + b"y" * 1_100_000
    done = donnie(tmp_path, "--linear", *QUIET, "--speed", "max", typed=typed)
    lost = "The program is too long. That line is lost."

    assert done.stdout.decode().splitlines()[2:] == [lost, "I walked 1 step forward.", lost, "Goodbye."]


def test_an_undone_change_runs_no_line_twice(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "FW 1", "FW 2", "RUN", "CHANGE 1 FW 5", "UNDO", "FW 3", "RUN") == [
        "I walked 1 step forward.",
        "I walked 2 steps forward.",
        "Line 1: FW 5",
        "RUN runs all 2 lines again.",
        "Line 1: FW 1",
        "I walked 3 steps forward.",
    ]


def test_a_program_that_can_not_run_again_changes_nothing(tmp_path: Path) -> None:
    assert answers_to(
        tmp_path, "VAR a = 2", "FW a", "WATCH a", "RUN", "FWD 2", "AGAIN", "DELETE 3", "FW 1", "RUN"
    ) == [
        "I will say when a changes.",
        "a is 2.",
        "I walked 2 steps forward.",
        "Error, line 3, column 1: I do not know FWD.",
        "Line 3: FWD 2",
        "Did you mean FW?",
        "Line 3 is deleted.",
        "I walked 1 step forward.",
    ]


def test_deleting_a_line_reports_its_number_and_the_line_now_there(tmp_path: Path) -> None:
    """The answer has the number of the line and the line that has it now."""
    program = ("FW 1", "FW 2", "FW 3", "FW 4", "FW 5", "FW 6")
    assert answers_to(tmp_path, *program, "DELETE 2", "DELETE 1 2", "DELETE 3", "DELETE") == [
        "Line 2 is deleted.",
        "Line 2: FW 3",
        "Lines 1 to 2 are deleted.",
        "Line 1: FW 4",
        "Line 3 is deleted.",
        "Lines 1 to 2 are deleted.",
    ]


def test_answers_are_repeated_found_and_spelled_without_running_again(tmp_path: Path) -> None:
    said = answers_to(
        tmp_path, "FW 3", "TR 90", "RUN", "WHERE", "LAST", "LAST 2", "FIND walked", "LAST WORD", "WHERE"
    )

    assert said[2:] == [
        "Position 0, 3. Facing east.",
        "Position 0, 3. Facing east.",
        "I walked 3 steps forward.",
        "I turned 90 degrees to the right.",
        "1 line.",
        "I walked 3 steps forward.",
        "e, a, s, t.",
        "Position 0, 3. Facing east.",
    ]


def test_where_at_detail_full_names_the_last_movement_too(tmp_path: Path) -> None:
    said = answers_to(tmp_path, "FW 3", "RUN", "WHERE", "DETAIL full", "WHERE", "WHERE")
    place, full = "Position 0, 3. Facing north.", "FW 3: 3 steps, to 0, 3."

    assert said[1:] == [place, "Detail: full.", place, full, place, full]
