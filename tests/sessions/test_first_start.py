"""The tour is offered at the first start only, and never in the way of a file."""

from pathlib import Path

from donnie_tui.settings.first_start import MARKER, is_new_decision, offers_tour
from tests.sessions.learner import Learner

OFFER = "New here? TOUR shows you around."


def test_it_is_offered_once(tmp_path: Path) -> None:
    folder = str(tmp_path / "state" / "donnie")

    assert [offers_tour(folder, {}) for _ in range(3)] == [True, False, False]
    assert (tmp_path / "state" / "donnie" / MARKER).exists()


def test_whoever_switched_it_off_is_never_asked_and_leaves_no_trace(tmp_path: Path) -> None:
    assert not offers_tour(str(tmp_path), {"DONNIE_TOUR": "off"})
    assert not (tmp_path / MARKER).exists()


def test_where_nothing_can_be_remembered_it_is_offered_all_the_same(tmp_path: Path) -> None:
    (tmp_path / "state").write_text("a file")

    assert offers_tour(str(tmp_path / "state" / "donnie"), {})


def test_the_linear_mode_offers_it_in_a_sentence_before_the_first_prompt(tmp_path: Path) -> None:
    first = Learner(tmp_path, DONNIE_TOUR="on")
    first.sees_prompt()
    assert first.lines[:-1] == ["Linear mode, from the option.", OFFER]  # L2: two lines
    first.types("TOUR\r")
    first.sees("Welcome. Donnie is a robot on a floor.")
    first.types("\x04")
    first.leaves()

    second = Learner(tmp_path, DONNIE_TOUR="on")
    second.sees("HELP lists the commands.\r\n> ")
    second.types("\x04")
    second.leaves()


def test_a_file_of_the_command_line_comes_first(tmp_path: Path) -> None:
    (tmp_path / "a.gd").write_text("FW 1\n")
    learner = Learner(tmp_path, "a.gd", DONNIE_TOUR="on")
    learner.sees("Opened a.gd, 1 line.\r\n> ")
    learner.types("\x04")
    learner.leaves()

    assert OFFER not in learner.lines


def test_what_was_decided_of_the_voice_is_told_once_and_again_when_it_is_another(tmp_path: Path) -> None:
    """V1."""
    folder, decisions = str(tmp_path / "state"), ("voice-own", "voice-own", "voice-over-ssh", "voice-own")
    assert [is_new_decision(folder, each) for each in decisions] == [True, False, True, True]


def test_beside_a_screen_reader_the_first_answer_says_how_to_change_that_and_the_prompt_has_two_lines(
    tmp_path: Path,
) -> None:
    """L2, V1. A later start says nothing of it."""
    decided = "Voice off, a screen reader runs. SET speech own turns it on."
    for told in ([decided], []):
        learner = Learner(tmp_path, "--speech", "auto", DONNIE_READER="1", SSH_CONNECTION="")
        learner.sees_prompt()
        assert len(learner.lines) == 3
        learner.types("RUN\r")
        learner.sees_prompt()
        assert learner.lines[3:-1] == [*told, "Nothing to run."]
        learner.types("\x04")
        learner.leaves()
