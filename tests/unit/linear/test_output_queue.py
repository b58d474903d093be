"""The lines between the program's thread and the one that prints."""

import threading

from donnie_tui.linear.output import Told
from tests.patience import PATIENCE


def silent() -> None:
    return


def test_only_printable_text_gets_through_without_blanks_at_its_ends() -> None:
    told = Told(silent)
    told.put(["  a\tb \n", "\x1b[2Jx\x07", "\x00\x7f\x9b"])

    assert told.take() == ["a b", "[2Jx"]


def test_lines_leave_the_queue_in_their_order() -> None:
    told = Told(silent)
    told.put(["one", "", "two"])
    told.put(["three"])

    assert (told.take(), told.take()) == (["one", "two", "three"], [])


def test_only_the_first_line_wakes_a_waiting_reader() -> None:
    nudges: list[int] = []
    told = Told(lambda: nudges.append(1))
    told.put([""])
    told.put(["one"])
    told.put(["two"])

    assert len(nudges) == 1


class Noted(threading.Condition):
    """Records that a reader waits."""

    def __init__(self) -> None:
        super().__init__()
        self.waits = threading.Event()

    def wait(self, timeout: float | None = None) -> bool:
        self.waits.set()
        return super().wait(timeout)


def waits(told: Told, robot: str | None) -> threading.Thread:
    """A program with more lines: it waits now, or has continued."""
    held = told._changed = Noted()
    program = threading.Thread(target=told.wait_for_room, args=(robot,), daemon=True)
    program.start()
    while program.is_alive() and not held.waits.wait(0.01):
        pass
    return program


def test_a_program_with_too_many_lines_is_held_back_until_they_are_read() -> None:
    told = Told(silent, capacity=2)
    told.hold_back()
    told.put(["1", "2"])
    held = waits(told, None)

    assert held.is_alive()
    assert told.take(1) == ["1"]
    held.join(PATIENCE)
    assert not held.is_alive()


def test_adding_a_line_never_waits_and_does_not_hold_another_robot() -> None:
    told = Told(silent, capacity=2)
    told.hold_back()
    told.put(["1", "2", "3"], robot="alice")
    told.put(["4"], robot="bob")
    told.wait_for_room("bob")

    assert waits(told, "alice").is_alive()
    assert told.take() == ["1", "2", "3", "4"]


def test_a_stopped_program_is_held_back_no_more() -> None:
    told = Told(silent, capacity=1)
    told.hold_back()
    told.put(["1"])
    held = waits(told, None)
    told.let_pass()
    held.join(PATIENCE)

    assert not held.is_alive()


def test_the_answer_to_a_word_comes_before_all_that_waits() -> None:
    told = Told(silent)
    told.put(["1", "2"])
    told.put_first(["Speed 2."])
    told.put_first(["Speed 1."])

    assert told.take(3) == ["Speed 2.", "Speed 1.", "1"]
    assert told.take() == ["2"]


def test_the_oldest_lines_are_left_out() -> None:
    told = Told(silent)
    told.put(["1", "2", "3"])

    assert told.trim(2) == 1
    assert told.take() == ["2", "3"]
