"""The linear mode without a terminal: a script through a pipe, whatever is in it."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from tests.sessions.command import QUIET, donnie


def test_the_output_of_a_pipe_needs_no_terminal(tmp_path: Path) -> None:
    """Only whole lines, no prompts; the words of the session work there too."""
    script = (
        "FW 3\nTR 90\n\nREPEAT 2 TIMES\nFW 1\nEND REPEAT\nRUN\nWHERE\nFWD\nRUN\nSAVE kept\nQUIT\nFW 99\nRUN\n"
    )
    done = _piped(script.encode(), tmp_path)

    assert done.stdout.decode().splitlines() == [
        "Linear mode, from the option.",
        "HELP lists the commands.",
        "I walked 3 steps forward.",
        "I turned 90 degrees to the right.",
        "I walked 1 step forward.",
        "I walked 1 step forward.",
        "Position 2, 3. Facing east.",
        "Error, line 6, column 1: I do not know FWD.",
        "Line 6: FWD",
        "Did you mean FW?",
        "Nothing ran, line 6 was dropped.",
        "Saved kept.gd, 5 lines.",
        "Goodbye.",
    ]
    assert (done.returncode, done.stderr) == (1, b"")


@pytest.mark.parametrize(
    ("script", "code"),
    [
        ("FW 1\n\nQUIT\n", 0),
        ("FW 1\nRUN\nWHERE\n", 0),
        ("FWD 1\nRUN\nQUIT\n", 1),
        ("SPEAK 1 / 0\nRUN\nSPEAK 1\nRUN\nQUIT\n", 1),
        ("FWD 1\nRUN\nWORLD corridor\nQUIT\n", 1),
        ("WHRE\nQUIT\n", 1),
        ("REPEAT 2 TIMES\nFW 1\n", 1),
        ("FWD 1\nRUN\nOPEN none.gd\nQUIT\n", 2),
    ],
    ids=["fine", "end", "mistake", "failure", "other world", "unknown word", "open block", "missing file"],
)
def test_a_script_ends_with_the_code_of_its_worst_line(script: str, code: int, tmp_path: Path) -> None:
    assert _piped(script.encode(), tmp_path).returncode == code


@pytest.mark.parametrize(
    ("script", "answer"),
    [
        ("FW 1\nQUIT\n", "1 line did not run. RUN was missing."),
        ("REPEAT 2 TIMES\nFW 1\nQUIT\n", "2 lines did not run. END REPEAT was missing."),
    ],
    ids=["line", "open block"],
)
def test_quit_runs_no_line_that_waits(script: str, answer: str, tmp_path: Path) -> None:
    done = _piped(script.encode(), tmp_path)

    assert done.stdout.decode().splitlines()[2:] == [answer, "Goodbye."]
    assert done.returncode == 1


def test_a_script_may_open_a_program_and_quit_without_running_it(tmp_path: Path) -> None:
    (tmp_path / "walk.gd").write_text("FW 2\n")
    done = _piped(b"OPEN walk.gd\nQUIT\n", tmp_path)

    assert done.stdout.decode().splitlines()[-2:] == ["1 line did not run. RUN was missing.", "Goodbye."]
    assert done.returncode == 0


def test_fix_leaves_a_line_that_failed_and_quit_repeats_nothing(tmp_path: Path) -> None:
    done = _piped(b"FW -3\nRUN\nx = 3\nRUN\nFIX\nQUIT\n", tmp_path)

    assert done.stdout.decode().splitlines()[-2:] == ["I don't know what was meant.", "Goodbye."]


def test_fix_lets_the_line_that_failed_wait_again_and_runs_it_alone(tmp_path: Path) -> None:
    done = _piped(b"FW 3\nRUN\nFW two\nRUN\nFIX\nRUN\nWHERE\nQUIT\n", tmp_path)

    assert done.stdout.decode().splitlines()[-5:] == [
        "Nothing ran, line 2 failed.",
        "Line 2: FW 2",
        "I walked 2 steps forward.",
        "Position 0, 5. Facing north.",
        "Goodbye.",
    ]


def test_a_missing_program_ends_with_2(tmp_path: Path) -> None:
    done = donnie(tmp_path, "--linear", "nofile.gd", *QUIET)

    assert done.returncode == 2
    assert b"There is no file nofile.gd." in done.stdout


def test_a_script_without_run_gets_a_hint(tmp_path: Path) -> None:
    done = _piped(b"FW 3\nFW 4\n", tmp_path)

    assert done.stdout.decode().splitlines()[2:] == ["2 lines did not run. RUN was missing.", "Goodbye."]


@pytest.mark.parametrize(
    "garbage",
    [b"\xfd\xff\x00\n\nRUN\n", b"\x1b[A\x07\n\n", b'SPEAK "\xed\xb3\xbf"\nRUN\n', b"(" * 5000 + b"\nRUN\n"],
    ids=["bytes", "keys", "surrogate", "parentheses"],
)
def test_garbage_is_answered(garbage: bytes, tmp_path: Path) -> None:
    done = _piped(garbage, tmp_path)

    assert done.returncode == (0 if b'SPEAK "' in garbage else 1)
    assert done.stderr == b""
    assert b"Error, line 1" in done.stdout or b'SPEAK "' in garbage


def _piped(script: bytes, folder: Path) -> subprocess.CompletedProcess[bytes]:
    return donnie(folder, "--linear", *QUIET, "--lang", "en", "--speed", "max", typed=script)


@pytest.mark.parametrize(
    ("language", "typed", "said"),
    [
        ("en", "FW 1", "1 line did not run. RUN was missing."),
        ("en", "REPEAT 2 TIMES\nFW 1", "2 lines did not run. END REPEAT was missing."),
        ("pt", "PF 1\nREPITA 2 VEZES\nGD 90", "3 linhas não foram executadas. Faltou FIM REPITA."),
        ("es", "SI 1 == 1 ENTONCES\nAV 1", "2 líneas no se ejecutaron. Faltó FIN SI."),
    ],
    ids=["run", "end", "fim", "fin"],
)
def test_lines_that_did_not_run_say_what_they_needed(
    language: str, typed: str, said: str, tmp_path: Path
) -> None:
    done = donnie(tmp_path, "--linear", *QUIET, "--lang", language, typed=f"{typed}\n")

    assert done.stdout.decode().splitlines()[-2] == said
