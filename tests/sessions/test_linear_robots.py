"""Several robots in the linear mode: the learner talks to one, each has its own program, all can run."""

import signal
import subprocess
import threading
from pathlib import Path

import pytest

from tests.sessions.command import COMMAND, QUIET, donnie, environment
from tests.sessions.learner import Learner
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow

TYPED = """ROBOTS
FW 2

ROBÔ bob
FW 3
GRIP

robots
ROBOT carol
TOGETHER
WHERE
ROBOT ALICE
STATE

STOP ALL
QUIT
"""


def test_a_program_without_output_announces_its_end(tmp_path: Path) -> None:
    """After START, which runs in the background, and after TOGETHER."""
    typed = "VAR q = 2\nSTART\nSTOP ALL\nTOGETHER\n"
    done = donnie(tmp_path, "--linear", *QUIET, "--speed", "max", "--world", "two_robots", typed=typed)

    lines = done.stdout.decode().splitlines()[2:-1]
    assert lines[0] == "alice begins."
    assert lines[-1] == "alice: Done."


def test_the_learner_selects_a_robot_and_all_run_together(tmp_path: Path) -> None:
    done = donnie(tmp_path, "--linear", *QUIET, "--speed", "max", "--world", "two_robots", typed=TYPED)

    assert done.returncode == 0
    assert done.stderr == b""
    assert done.stdout.decode().splitlines()[2:-1] == [
        "Now you talk to alice.",
        "alice: 0, 0, facing north.",
        "bob: 0, 30, facing south.",
        "alice: I walked 2 steps forward.",
        "Now you talk to bob.",
        "bob: I walked 3 steps forward.",
        "bob: There is nothing to grip.",
        "Now you talk to bob.",
        "alice: 0, 2, facing north.",
        "bob: 0, 27, facing south.",
        "There is no robot carol here. There are alice and bob.",
        "alice: I walked 2 steps forward.",
        "bob: I walked 3 steps forward.",
        "bob: There is nothing to grip.",
        "bob: Position 0, 27. Facing south.",
        "Now you talk to alice.",
        "Your program has 1 line.",
        "alice: Command 1 was FW 2, walked 2, didn't crash, position [0,2,0].",
        "No robot is running a program.",
    ]


def _lines(folder: Path, *options: str, typed: str) -> list[str]:
    """The lines of a conversation that ends by itself."""
    return donnie(folder, "--linear", *QUIET, *options, typed=typed).stdout.decode().splitlines()


def test_in_a_world_with_one_robot_nothing_is_named(tmp_path: Path) -> None:
    sentences = _lines(tmp_path, "--speed", "max", typed="ROBOTS\nFW 1\n\nGRIP\n\nQUIT\n")

    assert sentences[2:-1] == [
        "There is one robot, donnie.",
        "I walked 1 step forward.",
        "I have no gripper.",
    ]


def test_answers_about_the_world_name_their_robot(tmp_path: Path) -> None:
    typed = "ROBOT bob\nMAP\nMAP ROW 30\nAROUND\nTRAIL\nQUIT\n"
    sentences = _lines(tmp_path, "--world", "two_robots", typed=typed)

    assert [line for line in sentences if line.startswith("bob: ")] == [
        "bob: 33 by 43 steps, walls included.",
        "bob: Row 30, from -16: wall, 15 free, bob, 15 free, wall.",
        "bob: There is nothing within 10 steps.",
        "bob: I have not moved yet.",
    ]


def test_answers_about_sensors_mistakes_and_the_tour_name_their_robot(tmp_path: Path) -> None:
    typed = "ROBOT bob\nSENSORS\nNEAR\nFWD 1\n\nEXPLAIN\nTOUR\nQUIT\n"
    sentences = _lines(tmp_path, "--world", "two_robots", typed=typed)

    assert "bob has:" in sentences
    assert "bob: There is nothing within 10 steps." in sentences
    assert "bob: Donnie does not know this word." in sentences
    assert sentences[sentences.index("Welcome. Donnie is a robot in a room.") - 1] == "Now you talk to bob."


def test_a_program_with_a_mistake_does_not_begin(tmp_path: Path) -> None:
    typed = "FWD 2\nFW 1\nSTART\nDELETE 1\nSTART\nNEW\nQUIT\n"
    said = _lines(tmp_path, "--speed", "max", typed=typed)

    assert "Error, line 1, column 1: I do not know FWD." in said
    assert said.count("donnie begins.") == 1


ENDLESS = "WHILE 1 > 0 DO\nFW 1\nBW 1\nEND WHILE\n"


def test_a_program_still_running_at_the_end_of_the_lines_is_stopped_and_reported(
    tmp_path: Path,
) -> None:
    typed = f"{ENDLESS}START\nROBOT bob\nFW 2\nRUN\n"
    sentences = _lines(tmp_path, "--speed", "max", "--world", "two_robots", typed=typed)

    assert "bob: I walked 2 steps forward." in sentences
    assert sentences[-2:] == ["All robots have stopped.", "Goodbye."]


@pytest.mark.parametrize("word", ["START\nWHERE", "TOGETHER"])
def test_started_lines_are_no_longer_pending(word: str, tmp_path: Path) -> None:
    typed = f"WAIT 1\nFW 1\n{word}\nSTOP ALL\nRUN\n"
    sentences = _lines(tmp_path, "--speed", "max", "--world", "two_robots", typed=typed)

    assert sentences[-2:] == ["There is nothing to run.", "Goodbye."]


def test_answers_that_a_program_delivers_are_printed_before_the_goodbye_too(tmp_path: Path) -> None:
    """A listener that published during a program's event left it to that thread: it came after the end."""
    for _ in range(5):
        sentences = _lines(
            tmp_path, "--speed", "max", "--world", "two_robots", typed="WAIT 1\nFW 1\nSTART\nSTOP ALL\nRUN\n"
        )
        assert "alice begins." in sentences
        assert sentences[-2:] == ["There is nothing to run.", "Goodbye."]


def test_ctrl_c_ends_a_pipe_with_a_robot_held_up_by_an_endless_program(
    tmp_path: Path,
) -> None:
    """The sentence says so. The next lines of the pipe are read then."""
    learner = subprocess.Popen(
        [*COMMAND, "--linear", *QUIET, "--speed", "max", "--world", "two_robots"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        cwd=tmp_path,
        env=environment(tmp_path),
    )
    assert learner.stdin and learner.stdout
    learner.stdin.write(
        b"VAR a\nWHILE 1 > 0 DO\na = a + 1\nEND WHILE\nSTART\nROBOT bob\nFW 1\nRUN\nWHERE\nQUIT\n"
    )
    learner.stdin.close()
    too_long = threading.Timer(TIMEOUT, learner.kill)
    too_long.start()
    with learner:
        sentences = iter(learner.stdout.readline, b"")
        way_out = b"The others wait for alice: it calculates and does not move. Ctrl+C stops all.\n"
        assert any(line == way_out for line in sentences)
        learner.send_signal(signal.SIGINT)
        assert [line.decode().strip() for line in sentences if b"Still" not in line] == [
            "bob: Stopped.",
            "bob: Position 0, 30. Facing south.",
            "Goodbye.",
        ]
    too_long.cancel()


def test_reset_of_a_running_robot_is_refused_with_the_reason(tmp_path: Path) -> None:
    typed = "WHILE 1 == 1 DO\nWAIT 1000\nEND WHILE\nSTART\nRESET\nSTOP ALL\n"
    said = _lines(tmp_path, "--speed", "1", typed=typed)

    assert "A program is running. STOP stops it." in said
    assert not any("RESET" in line for line in said)


def test_each_of_the_robots_started_together_reports_where_it_stopped(tmp_path: Path) -> None:
    learner = Learner(tmp_path, "--world", "two_robots", speed="1")
    learner.enters("WAIT 1000", "ROBOT bob", "FW 1", "WAIT 1000", "TOGETHER")
    learner.sees("bob: I walked 1 step forward.")
    learner.types("\x03")
    learner.sees("alice: Stopped at line 1.")
    learner.sees("bob: Stopped at line 2.")


def test_the_next_word_after_a_stop_finds_idle_robots_and_ordered_lines(
    tmp_path: Path,
) -> None:
    """Lines of a file arrive faster than a robot stops."""
    typed = "FW 1\nROBOT bob\nFW 2\nSTART\nSTOP ALL\nTOGETHER\nSTART\nSTOP\nAGAIN\nSTART\nSTOP ALL\nRESET\n"
    sentences = _lines(tmp_path, "--speed", "1", "--world", "two_robots", typed=typed)
    sentences = [line for line in sentences if not line.startswith("Still")]

    walked, stopped = "bob: I walked 2 steps forward.", "bob: I walked only 0 steps forward. I was stopped."
    assert sentences[2:-1] == [
        "Now you talk to bob.",
        "bob begins.",
        stopped,
        "All robots have stopped.",
        "alice: I walked 1 step forward.",
        walked,
        "bob begins.",
        stopped,
        "bob: Stopped at line 1.",
        walked,
        "bob begins.",
        stopped,
        "All robots have stopped.",
        "bob: I am back at the start.",
    ]


def test_the_start_of_a_robot_is_announced_before_its_first_line(tmp_path: Path) -> None:
    sentences = _lines(tmp_path, "--speed", "max", typed='SPEAK "hi"\nSTART\nSTOP ALL\n')

    assert sentences[2:4] == ["donnie begins.", "hi"]


def test_steps_of_an_earlier_program_are_not_reported_of_a_later_one(tmp_path: Path) -> None:
    typed = "VAR x = 1\nIF x > 5 THEN\nFW 1\nEND IF\nSTEP\n\n\nSTART\nSTOP ALL\nSTEP BACK\nQUIT\n"
    sentences = _lines(tmp_path, "--speed", "max", typed=typed)

    assert sentences.count("1 is greater than 5: false.") == 1
    assert sentences[-2].startswith("Back: ")
