"""The linear mode as a learner has it: real keys on a real terminal, reading only what is printed."""

from __future__ import annotations

import fcntl
import os
import re
import signal
import struct
import subprocess
import sys
import termios
from pathlib import Path

import pytest

from tests.sessions.learner import Learner, until

ESC, UP, DOWN, LEFT, HOME = "\x1b", "\x1b[A", "\x1b[B", "\x1b[D", "\x1b[H"
CTRL_C, CTRL_D, CTRL_Z, BACKSPACE = "\x03", "\x04", "\x1a", "\x7f"


@pytest.fixture
def learner(tmp_path: Path) -> Learner:
    return Learner(tmp_path)


def said(learner: Learner) -> list[str]:
    """The lines without the typed ones."""
    return [line for line in learner.lines if line and not re.match(r"[0-9]*> ", line)]


def test_it_begins_with_two_lines_and_a_prompt(learner: Learner) -> None:
    learner.sees_prompt()

    assert learner.raw == b"Linear mode, from the option.\r\nHELP lists the commands.\r\n> "


def test_a_rectangle_is_typed_with_enter_and_run_with_escape(learner: Learner) -> None:
    learner.enters("PROCEDURE RECT: a, b DO", "REPEAT 2 TIMES", "FW a TR 90", "FW b TR 90", "END REPEAT")
    learner.enters("END PROCEDURE")
    learner.sees_prompt()
    learner.types("RECT [4, 2]" + ESC)
    learner.sees_prompt()

    assert [line for line in learner.lines if line.endswith("REPEAT")] == ["2> END REPEAT"]
    walks = ["I walked 4 steps forward.", "I walked 2 steps forward."] * 2
    turn = "I turned 90 degrees to the right."
    assert said(learner)[2:] == [line for walk in walks for line in (walk, turn)]


def test_the_answer_and_the_prompt_come_in_one_piece_after_the_typed_line(learner: Learner) -> None:
    learner.enters("FW 3", "RUN")
    learner.sees_prompt()

    assert learner.raw.endswith(b"> FW 3\r\n> RUN\r\nI walked 3 steps forward.\r\n> ")


def test_a_mistake_is_told_with_its_line_and_what_was_meant(learner: Learner) -> None:
    learner.enters("FW 1", "RUN", "FWD 3", "RUN")
    learner.sees_prompt()

    assert said(learner)[3:] == [
        "Error, line 2, column 1: I do not know FWD.",
        "Line 2: FWD 3",
        "Did you mean FW?",
    ]


def test_lines_with_a_mistake_are_kept_and_mended(learner: Learner) -> None:
    learner.enters("FW 1", "TRR 90", "RUN")
    learner.sees("Nothing ran. CHANGE 2 mends line 2, DELETE 2 deletes it.")
    learner.enters("CHANGE 2")
    learner.sees("Edit line 2, then Enter.\r\n> TRR 90")
    learner.types(HOME + "\x1b[3~" + "\r")
    learner.sees("Line 2: RR 90")
    learner.enters("CHANGE 2 TR 90", "RUN")
    learner.sees("I turned 90 degrees to the right.\r\n> ")


def test_an_empty_line_runs_what_waits_but_not_half_a_block(learner: Learner) -> None:
    learner.enters("REPEAT 2 TIMES", "FW 1", "")
    learner.sees("Still open: REPEAT from line 1.")
    learner.enters("END REPEAT", "")
    learner.sees("I walked 1 step forward.\r\nI walked 1 step forward.\r\n> ")


def test_escape_runs_the_unfinished_line_too(learner: Learner) -> None:
    learner.sees_prompt()
    learner.types("FW 2" + ESC)
    learner.sees("I walked 2 steps forward.")


def test_run_without_anything_to_run_says_so(learner: Learner) -> None:
    learner.enters("RUN")
    learner.sees("Nothing to run.\r\n> ")


def test_a_run_that_tells_nothing_says_that_it_is_done(learner: Learner) -> None:
    learner.enters("VAR x = 5", "RUN")
    learner.sees("Done.\r\n> ")


def test_arrow_up_brings_back_what_was_typed_also_in_the_next_session(
    learner: Learner, tmp_path: Path
) -> None:
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
    learner.sees("No lines yet.")
    learner.enters("OPEN corner", "SAVE AS other name")
    learner.sees("Saved other name.gd, 2 lines.")
    learner.enters("RUN")
    learner.sees("I turned 90 degrees to the right.")

    assert (tmp_path / "corner.gd").read_text() == "FW 3\nTR 90\n"


def test_another_file_is_replaced_only_if_wanted(learner: Learner, tmp_path: Path) -> None:
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


def test_control_c_stops_in_the_middle_of_a_movement(tmp_path: Path) -> None:
    learner = Learner(tmp_path, "--events", "events.jsonl", speed="1")
    events = tmp_path / "events.jsonl"
    learner.enters("FW 1", "FW 50", "RUN")
    until(lambda: '"moved"' in events.read_text() and events.read_text().count("step-forward") >= 2)
    learner.types(CTRL_C + CTRL_C)
    learner.sees("I was stopped.\r\nStopped at line 2.\r\n> ")
    learner.types("WHERE\r")
    learner.sees("Facing north.")


@pytest.mark.parametrize("after", [0.1, 0.2, 0.4, 0.8])
def test_control_c_counts_while_the_session_still_loads(after: float, tmp_path: Path) -> None:
    """Whether it comes as a key or as a signal, which drops what is typed and not read yet."""
    learner = Learner(tmp_path, speed="5")
    learner.sees_prompt()
    learner.types("WAIT 1000\r\r")
    learner.child.delaybeforesend = after
    learner.types(CTRL_C)
    learner.child.expect(rb"(Stopped|Nothing is running|Line cleared)[^\n]*\n> ")
    learner.types("WHERE\r")
    learner.sees("Facing north.")  # long before the wait would be over


def test_control_c_that_is_typed_with_the_program_stops_it(tmp_path: Path) -> None:
    learner = Learner(tmp_path, speed="5")
    learner.sees_prompt()
    learner.types("WAIT 1000\r\r" + CTRL_C)
    learner.sees("Stopped")  # at a line of it, or before its first
    learner.types("WHERE\r")
    learner.sees("Facing north.")


def test_an_endless_program_that_talks_is_stopped(learner: Learner) -> None:
    learner.enters("WHILE 1 == 1 DO", 'SPEAK "on and on"', "END WHILE", "RUN")
    learner.sees("on and on\r\non and on")
    learner.types(CTRL_C)
    learner.sees("Stopped at line ")
    learner.enters('SPEAK "well"', "RUN")
    learner.sees("well\r\n> ")


def test_control_c_where_the_terminal_takes_nothing_still_tells_where_it_stopped(tmp_path: Path) -> None:
    """Ctrl+C arrives in the middle of a write; what then waits is left out, the end of it is told."""
    (tmp_path / "flood.gd").write_text(f'WHILE 1 == 1 DO\nSPEAK "{"long " * 1000}"\nEND WHILE\n')
    learner = Learner(tmp_path, "flood.gd")
    learner.enters("RUN")
    until(lambda: _unread(learner) > 4000)
    learner.types(CTRL_C)
    learner.sees("Stopped at line ")


@pytest.mark.parametrize(
    ("word", "answer"),
    [
        ("SLOWER", "Speed "),
        ("FASTER", "Speed "),
        ("SPEED 3", "Speed 3."),
        ("ROBOTS", "There is one robot"),
        ("QUIET", "Quiet."),
        ("PAUSE", "Paused at line "),
        ("STOP ALL", "Stopped at line "),
    ],
)
def test_a_word_counts_at_once_while_a_program_talks_without_end(
    word: str, answer: str, learner: Learner
) -> None:
    """What the program has told before may be hundreds of lines; no more than a few blocks come first."""
    learner.enters("WHILE 1 == 1 DO", 'SPEAK "on and on"', "END WHILE", "RUN")
    learner.sees("on and on\r\non and on")
    learner.types(f"{word}\r")
    learner.sees(answer)
    before = learner.raw.count(b"on and on")
    learner.types(CTRL_C)
    learner.sees_prompt()

    assert before < 300


def _unread(learner: Learner) -> int:
    """Bytes that the terminal holds ready and nobody has read."""
    (count,) = struct.unpack("i", fcntl.ioctl(learner.child.fileno(), termios.FIONREAD, b"\0" * 4))
    return int(count)


def test_stop_reaches_a_program_past_other_lines_that_wait(learner: Learner) -> None:
    learner.enters("WHILE 1 == 1 DO", "WAIT 1", "END WHILE", "RUN")
    learner.sees("Waiting 1 second.")
    learner.types("FW 2\rSPEAK 77\rSTOP\r")
    learner.sees("Stopped at line ")
    learner.types("RUN\r")
    learner.sees("I walked 2 steps forward.\r\n77\r\n")


@pytest.mark.parametrize(
    ("word", "answer"),
    [("FASTER", "Speed "), ("SLOWER", "Speed "), ("SPEED 3", "Speed 3."), ("ROBOTS", "There is")],
)
def test_a_word_counts_at_once_past_other_lines_that_wait(word: str, answer: str, learner: Learner) -> None:
    learner.enters("WHILE 1 == 1 DO", "WAIT 100000", "END WHILE", "RUN")
    learner.sees("Waiting ")
    learner.types(f"FW 2\rSPEAK 77\r{word}\r")
    learner.sees(answer)
    learner.types("STOP\rRUN\r")
    learner.sees("I walked 2 steps forward.\r\n77\r\n")


def test_control_c_at_the_prompt_clears_the_line_and_never_leaves(learner: Learner) -> None:
    learner.sees_prompt()
    learner.types("FW 3")
    learner.sees("FW 3")
    learner.types(CTRL_C)
    learner.sees("Line cleared.\r\n> ")
    learner.types(CTRL_C)
    learner.sees("Nothing is running. QUIT leaves.\r\n> ")


def test_long_output_comes_in_blocks_with_a_rest_between(learner: Learner) -> None:
    learner.enters("FOR VAR i = 1; i <= 40; i = i + 1 DO SPEAK i END FOR", "RUN")
    learner.sees("40\r\n> ")

    told = said(learner)[2:]
    assert [line for line in told if line.isdigit()] == [str(number) for number in range(1, 41)]
    assert all(line.isdigit() or re.fullmatch(r"Those were \d+ numbers\.", line) for line in told)


def _says(learner: Learner, line: str, answer: str) -> None:
    """The learner says a line to the held program, and is answered."""
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


def test_quit_runs_what_waits_and_leaves(learner: Learner) -> None:
    learner.enters("FW 3", "QUIT")

    assert learner.leaves() == 0
    assert said(learner)[2:] == ["I walked 3 steps forward.", "Goodbye."]


def test_quit_leaves_the_second_time_where_the_first_could_not_be_reached(learner: Learner) -> None:
    learner.enters("FWD 3", "TRR 3", "QUIT")
    learner.sees("Nothing ran.")
    learner.enters("QUIT")

    assert learner.leaves() == 0


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
    assert said(learner)[-2:] == ["Posición 0, 3. Mirando al norte.", "Hasta luego."]


def test_letters_with_accents_and_wide_ones_are_edited_as_one(learner: Learner) -> None:
    learner.sees_prompt()
    learner.types('SPEAK "cafe\u0301é漢x' + BACKSPACE * 3 + '"' + ESC)
    learner.sees("cafe\u0301\r\n> ")


def test_what_is_typed_ahead_is_not_lost(tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.types("FW 1\rFW 2\rRUN\rWHERE\r")
    learner.sees("Position 0, 3. Facing north.")

    walked = [line for line in learner.lines if line.startswith("I walked")]
    assert walked == ["I walked 1 step forward.", "I walked 2 steps forward."]


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_a_signal_to_leave_rescues_the_program(number: int, tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.enters("FW 1", "FW 2")
    learner.sees_prompt()
    learner.child.kill(number)

    assert learner.leaves() == 128 + number
    again = Learner(tmp_path)
    again.enters("RECOVER")
    again.sees("A program was rescued. RECOVER opens it.\r\nHere it is again, 2 lines.")
    again.enters("LIST")
    again.sees("1: FW 1\r\n2: FW 2\r\n> ")


def test_a_rescued_program_has_its_file_again(tmp_path: Path) -> None:
    (tmp_path / "walk.gd").write_text("FW 1\n")
    learner = Learner(tmp_path)
    learner.enters(f"OPEN {tmp_path / 'walk.gd'}", "FW 2")
    learner.sees_prompt()
    learner.child.kill(signal.SIGTERM)
    learner.leaves()
    again = Learner(tmp_path)
    again.enters("RECOVER")
    again.sees("Here walk.gd is again, 2 lines. SAVE saves it.")
    again.enters("SAVE")
    again.sees("Saved walk.gd, 2 lines.")
    assert (tmp_path / "walk.gd").read_text() == "FW 1\nFW 2\n"


def copies(folder: Path) -> list[Path]:
    return list((folder / "state").rglob("unsaved-*.gd"))


def test_what_was_typed_is_there_again_after_donnie_was_killed_in_mid_line(tmp_path: Path) -> None:
    learner = Learner(tmp_path, language="es")
    learner.types("AV 1\rGD 90\rHABL")
    learner.sees("> HABL")
    until(lambda: [each.read_text() for each in copies(tmp_path)] == ["AV 1\nGD 90\n"])
    learner.child.kill(signal.SIGKILL)
    learner.leaves()

    again = Learner(tmp_path, language="es")
    again.enters("RECUPERAR", "LISTAR")
    again.sees("1: AV 1\r\n2: GD 90\r\n> ")
    again.types(UP + UP + "\r")
    again.sees("RECUPERAR")
    again.sees("> ")
    again.types("SALIR\r")

    assert again.leaves() == 0
    assert list((tmp_path / "state").rglob("unsaved-*")) == []


def test_a_program_that_was_saved_leaves_no_copy(learner: Learner, tmp_path: Path) -> None:
    learner.enters("FW 1")
    learner.sees_prompt()
    until(lambda: list((tmp_path / "state").rglob("unsaved-*")) != [])
    learner.types("SAVE mine\r")
    learner.sees_prompt()
    until(lambda: list((tmp_path / "state").rglob("unsaved-*")) == [])


def test_a_signal_to_leave_stops_the_running_program(tmp_path: Path) -> None:
    learner = Learner(tmp_path, "--events", "events.jsonl", speed="1")
    events = tmp_path / "events.jsonl"
    learner.enters("FW 500", "RUN")
    until(lambda: events.exists() and "step-forward" in events.read_text())
    learner.child.kill(signal.SIGTERM)

    assert learner.leaves() == 128 + signal.SIGTERM
    assert '"outcome":"stopped"' in events.read_text()


# --- the terminal


def test_the_terminal_is_left_as_it_was_found(learner: Learner) -> None:
    learner.sees_prompt()
    during = termios.tcgetattr(learner.child.fileno())
    learner.types("QUIT\r")
    learner.sees("Goodbye.")
    until(lambda: termios.tcgetattr(learner.child.fileno())[3] & termios.ECHO)
    after = termios.tcgetattr(learner.child.fileno())

    assert not during[3] & (termios.ECHO | termios.ICANON)
    assert after[3] & termios.ICANON


def test_control_z_gives_the_terminal_back_until_the_session_goes_on(learner: Learner) -> None:
    learner.enters("WHERE")
    learner.sees("Facing north.\r\n> ")
    learner.types("FW 3")
    learner.sees("FW 3")
    learner.types(CTRL_Z)
    _, status = os.waitpid(learner.child.pid, os.WUNTRACED)
    while_away = termios.tcgetattr(learner.child.fileno())[3]
    learner.child.kill(signal.SIGCONT)
    learner.sees("> FW 3")
    learner.types(ESC)
    learner.sees("I walked 3 steps forward.")

    assert os.WIFSTOPPED(status)
    assert while_away & termios.ECHO


def test_nothing_but_text_is_printed_outside_of_editing(learner: Learner, tmp_path: Path) -> None:
    learner.enters(
        "HELP", "HELP KEYS", "HELP FW", "FW 3", "RUN", "LIST", "WHERE", "SPEED 7", "DETAIL full", "ERRORS"
    )
    learner.enters(
        'SPEAK "  \x1b[2J tab "', "RUN", "SAVE x", "OPEN nothing", "LAST", "FW", "RUN", "CHANGE 99", "QUIT"
    )
    assert learner.leaves() == 0
    text = learner.raw.replace(b"\r\n", b"\n").decode()

    assert not re.search(r"[\x00-\x09\x0b-\x1f\x7f]", text)
    assert not re.search(r"\n\n|\n |(?<!>) \n", text)


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
        "Saved kept.gd, 5 lines.",
        "Goodbye.",
    ]
    assert (done.returncode, done.stderr) == (0, b"")


def test_a_script_that_forgets_run_is_told(tmp_path: Path) -> None:
    done = _piped(b"FW 3\nFW 4\n", tmp_path)

    assert done.stdout.decode().splitlines()[2:] == ["2 lines did not run. RUN was missing.", "Goodbye."]


@pytest.mark.parametrize(
    "garbage",
    [b"\xfd\xff\x00\n\nRUN\n", b"\x1b[A\x07\n\n", b'SPEAK "\xed\xb3\xbf"\nRUN\n', b"(" * 5000 + b"\nRUN\n"],
    ids=["bytes", "keys", "surrogate", "parentheses"],
)
def test_garbage_is_answered(garbage: bytes, tmp_path: Path) -> None:
    done = _piped(garbage, tmp_path)

    assert done.returncode == 0
    assert done.stderr == b""
    assert b"Error, line 1" in done.stdout or b'SPEAK "' in garbage


def _piped(script: bytes, folder: Path) -> subprocess.CompletedProcess[bytes]:
    environment = {
        **os.environ,
        "XDG_STATE_HOME": str(folder / "state"),
        "XDG_CONFIG_HOME": str(folder / "config"),
        "DONNIE_TOUR": "off",
    }
    command = [
        sys.executable,
        "-m",
        "donnie_tui",
        "--linear",
        "--speech",
        "off",
        "--sound",
        "off",
        "--lang",
        "en",
    ]
    return subprocess.run(
        [*command, "--speed", "max"],
        input=script,
        capture_output=True,
        timeout=60,
        cwd=folder,
        env=environment,
    )


@pytest.mark.skipif(not Path("/proc/self/maps").exists(), reason="what a process has loaded is told there")
def test_behind_the_prompt_it_gets_ready_to_move(learner: Learner) -> None:
    learner.sees_prompt()

    until(lambda: "_chipmunk" in Path(f"/proc/{learner.child.pid}/maps").read_text())

    learner.types("\x04")
    assert learner.leaves() == 0
