"""The question whether to save first loses no line, whatever the answer is."""

from __future__ import annotations

import signal
from pathlib import Path

import pytest

from tests.sessions.learner import Learner

pytestmark = pytest.mark.slow

CTRL_C, CTRL_D, ESC = "\x03", "\x04", "\x1b"
FIVE = ("FW 1", "FW 2", "FW 3", "FW 4", "FW 5")
TEXT = "".join(f"{line}\n" for line in FIVE)
QUESTION = "Save first, y or n? Enter means no.\r\n> "
STAYS = "Not saved, so Donnie stays open.\r\n> "


def copied(folder: Path) -> list[str]:
    return sorted(each.read_text() for each in (folder / "state").rglob("unsaved-*.gd"))


@pytest.fixture
def asked(tmp_path: Path) -> Learner:
    """The learner has typed five lines and wants to leave."""
    learner = Learner(tmp_path)
    learner.enters(*FIVE)
    learner.sees_prompt()
    learner.types(CTRL_D)
    learner.sees(QUESTION)
    return learner


@pytest.mark.parametrize("answer", ["n\r", "\r"], ids=["no", "enter"])
def test_recover_restores_a_program_that_was_not_saved(asked: Learner, tmp_path: Path, answer: str) -> None:
    asked.types(answer)
    asked.sees("Not saved. RECOVER brings it back.")

    assert asked.leaves() == 0
    assert copied(tmp_path) == []
    again = Learner(tmp_path)
    again.sees("HELP lists the commands.\r\n> ")
    again.types("RECOVER\r")
    again.sees("Your program is back, 5 lines.\r\n> ")


@pytest.mark.parametrize("leaves", ["QUIT\r", CTRL_D])
def test_recover_restores_a_few_lines_that_were_left_without_a_question(tmp_path: Path, leaves: str) -> None:
    learner = Learner(tmp_path)
    learner.enters("FW 1", "RUN")
    learner.sees_prompt()
    learner.types(leaves)
    learner.sees("Goodbye.")
    assert learner.leaves() == 0

    again = Learner(tmp_path)
    again.enters("RECOVER")
    again.sees("Your program is back, 1 line.\r\n> ")
    again.types("QUIT\r")
    again.enters("n")
    again.leaves()
    once_more = Learner(tmp_path)
    once_more.enters("RECOVER")
    once_more.sees("Your program is back, 1 line.\r\n> ")


def test_an_empty_program_leaves_no_copy(tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.enters("NEW", "QUIT")
    learner.leaves()

    assert list((tmp_path / "state").rglob("left-*")) == []


IN_VAIN = {
    "interrupt": (CTRL_C,),
    "escape": (ESC,),
    "no name": ("y\r", "\r"),
    "interrupt at the name": ("y\r", CTRL_C),
    "no such folder": ("y\r", "no folder/mine\r"),
}


@pytest.mark.parametrize("answers", IN_VAIN.values(), ids=IN_VAIN)
def test_a_missing_answer_or_a_failed_save_keeps_the_program_open(
    asked: Learner, answers: tuple[str, ...]
) -> None:
    for keys in answers[:-1]:
        asked.types(keys)
        asked.sees_prompt()
    asked.types(answers[-1])
    asked.sees(STAYS)
    asked.types("LIST\r")
    asked.sees("5: FW 5\r\n> ")


def test_a_program_that_stayed_open_can_be_saved_and_left(asked: Learner, tmp_path: Path) -> None:
    asked.types(CTRL_C)
    asked.sees(STAYS)
    asked.types(CTRL_D)
    asked.sees(QUESTION)
    asked.types("y\rmine\r")

    assert asked.leaves() == 0
    assert (tmp_path / "mine.gd").read_text() == TEXT
    assert copied(tmp_path) == []


def test_quit_in_a_program_asks_as_well_and_stays(tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.enters(*FIVE, "QUIT")
    learner.sees(QUESTION)
    learner.types(CTRL_C)
    learner.sees(STAYS)
    learner.types("LIST\r")
    learner.sees("5: FW 5\r\n> ")


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
@pytest.mark.parametrize("before", ["", "y\r"], ids=["save", "name"])
def test_a_signal_to_leave_at_a_question_leaves_a_copy(
    asked: Learner, tmp_path: Path, before: str, number: int
) -> None:
    if before:
        asked.types(before)
        asked.sees_prompt()
    asked.child.kill(number)

    assert asked.leaves() == 128 + number
    assert copied(tmp_path) == [TEXT]


def test_the_end_of_the_input_at_the_question_leaves_a_copy(asked: Learner, tmp_path: Path) -> None:
    asked.types(CTRL_D)
    asked.sees("A program was kept. RECOVER opens it.")

    assert asked.leaves() == 0
    assert copied(tmp_path) == [TEXT]


def test_no_program_of_several_robots_is_lost_and_the_selection_stays(tmp_path: Path) -> None:
    learner = Learner(tmp_path, "--world", "two_robots")
    learner.enters("ROBOT alice", *FIVE, "ROBOT bob", *reversed(FIVE))
    learner.sees_prompt()
    learner.types(CTRL_D)
    learner.sees(QUESTION)
    learner.types("y\rmine\r")
    learner.sees(QUESTION)
    learner.types("y\r")
    learner.sees_prompt()
    learner.child.kill(signal.SIGTERM)

    assert learner.leaves() == 128 + signal.SIGTERM
    assert sorted([*copied(tmp_path), (tmp_path / "mine.gd").read_text()]) == sorted(
        [TEXT, "".join(f"{line}\n" for line in reversed(FIVE))]
    )


def test_a_signal_at_the_question_before_the_full_screen_leaves_a_copy_and_ends(tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.enters(*FIVE, "VISUAL")
    learner.sees("Enter means no.\r\n> ")
    learner.child.kill(signal.SIGTERM)

    assert learner.leaves() == 128 + signal.SIGTERM
    assert copied(tmp_path) == [TEXT]


def test_a_short_program_is_kept_and_offered_at_the_next_start_alone(tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.enters("FW 1", "TR 90", "FW 2", "SPEAK 4", "RUN", "QUIT")
    learner.sees("4 lines are kept. RECOVER opens them.\r\nGoodbye.")
    assert learner.leaves() == 0

    ignored = Learner(tmp_path)
    ignored.sees("A program was kept. RECOVER opens it.\r\n")
    ignored.enters("QUIT")
    assert ignored.leaves() == 0

    again = Learner(tmp_path)
    again.enters("RECOVER")
    again.sees("Your program is back, 4 lines.\r\n")
    assert "A program was kept. RECOVER opens it." not in again.lines


def test_a_program_that_was_given_up_is_not_offered(tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.enters("FW 1", "QUIT")
    learner.sees_prompt()
    learner.types("n\r")
    assert learner.leaves() == 0

    again = Learner(tmp_path)
    again.sees_prompt()
    assert "A program was kept. RECOVER opens it." not in again.lines


def test_stop_and_help_mean_themselves_in_an_open_block(tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.enters("REPEAT 2 TIMES", "STOP")
    learner.sees("Nothing is running.\r\n1 line waits. DELETE drops it.\r\n1> ")
    learner.types("HELP REPEAT\r")
    learner.sees("You write: REPEAT value TIMES commands END REPEAT.")
    learner.enters("LIST")
    learner.sees("1: REPEAT 2 TIMES\r\n1> ")
