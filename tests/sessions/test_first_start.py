"""The tour is offered at the first start only, and not when a file is opened."""

from pathlib import Path

from donnie_tui.settings.folders import MARKER, is_new_decision, offers_tour
from tests.sessions.learner import Learner

OFFER = "New here? TOUR shows you around."


def test_the_tour_is_offered_once(tmp_path: Path) -> None:
    folder = str(tmp_path / "state" / "donnie")

    assert [offers_tour(folder, {}) for _ in range(3)] == [True, False, False]
    assert (tmp_path / "state" / "donnie" / MARKER).exists()


def test_a_tour_that_is_switched_off_is_not_offered_and_leaves_no_trace(tmp_path: Path) -> None:
    assert not offers_tour(str(tmp_path), {"DONNIE_TOUR": "off"})
    assert not (tmp_path / MARKER).exists()


def test_the_tour_is_offered_where_the_state_can_not_be_saved(tmp_path: Path) -> None:
    (tmp_path / "state").write_text("a file")

    assert offers_tour(str(tmp_path / "state" / "donnie"), {})


def test_the_linear_mode_offers_the_tour_before_the_first_prompt(tmp_path: Path) -> None:
    first = Learner(tmp_path, DONNIE_TOUR="on")
    first.sees_prompt()
    assert first.lines[:-1] == ["Linear mode, from the option.", OFFER]  # two lines
    first.types("TOUR\r")
    first.sees("Welcome. Donnie is a robot in a room.")
    first.types("\x04")
    first.leaves()

    second = Learner(tmp_path, DONNIE_TOUR="on")
    second.sees("HELP lists the commands.\r\n> ")
    second.types("\x04")
    second.leaves()


def test_a_file_on_the_command_line_replaces_the_offer(tmp_path: Path) -> None:
    (tmp_path / "a.gd").write_text("FW 1\n")
    learner = Learner(tmp_path, "a.gd", DONNIE_TOUR="on")
    learner.sees("Opened a.gd, 1 line.\r\n> ")
    learner.types("\x04")
    learner.leaves()

    assert OFFER not in learner.lines


def test_a_decision_about_the_voice_is_announced_once_and_again_after_a_change(tmp_path: Path) -> None:
    """The decision about the voice is announced."""
    folder, decisions = str(tmp_path / "state"), ("voice-own", "voice-own", "voice-over-ssh", "voice-own")
    assert [is_new_decision(folder, each) for each in decisions] == [True, False, True, True]


def test_with_a_screen_reader_the_first_answer_says_how_to_change_the_voice(
    tmp_path: Path,
) -> None:
    """A later start does not repeat it."""
    decided = "My voice is off, because a screen reader runs. SET speech own turns it on."
    for said in ([decided], []):
        learner = Learner(tmp_path, "--speech", "auto", DONNIE_READER="1", SSH_CONNECTION="")
        learner.sees_prompt()
        assert len(learner.lines) == 3
        learner.types("RUN\r")
        learner.sees_prompt()
        assert learner.lines[3:-1] == [*said, "There is nothing to run."]
        learner.types("\x04")
        learner.leaves()
