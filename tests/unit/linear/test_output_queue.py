"""The lines between the program's thread and the one that prints."""

import threading

from donnie_tui.linear.output import OutputQueue
from tests.timeouts import TIMEOUT


def silent() -> None:
    return


def test_only_printable_text_gets_through_without_blanks_at_its_ends() -> None:
    queue = OutputQueue(silent)
    queue.put(["  a\tb \n", "\x1b[2Jx\x07", "\x00\x7f\x9b"])

    assert queue.take() == ["a b", "[2Jx"]


def test_lines_leave_the_queue_in_their_order() -> None:
    queue = OutputQueue(silent)
    queue.put(["one", "", "two"])
    queue.put(["three"])

    assert (queue.take(), queue.take()) == (["one", "two", "three"], [])


def test_only_the_first_line_wakes_a_waiting_reader() -> None:
    nudges: list[int] = []
    queue = OutputQueue(lambda: nudges.append(1))
    queue.put([""])
    queue.put(["one"])
    queue.put(["two"])

    assert len(nudges) == 1


class Noted(threading.Condition):
    """Records that a reader waits."""

    def __init__(self) -> None:
        super().__init__()
        self.waits = threading.Event()

    def wait(self, timeout: float | None = None) -> bool:
        self.waits.set()
        return super().wait(timeout)


def waits(queue: OutputQueue, robot: str | None) -> threading.Thread:
    """A program with more lines: it waits now, or has continued."""
    held = queue._changed = Noted()
    program = threading.Thread(target=queue.wait_for_room, args=(robot,), daemon=True)
    program.start()
    while program.is_alive() and not held.waits.wait(0.01):
        pass
    return program


def test_a_program_with_too_many_lines_is_held_back_until_they_are_read() -> None:
    queue = OutputQueue(silent, capacity=2)
    queue.hold_back()
    queue.put(["1", "2"])
    held = waits(queue, None)

    assert held.is_alive()
    assert queue.take(1) == ["1"]
    held.join(TIMEOUT)
    assert not held.is_alive()


def test_adding_a_line_never_waits_and_does_not_hold_another_robot() -> None:
    queue = OutputQueue(silent, capacity=2)
    queue.hold_back()
    queue.put(["1", "2", "3"], robot="alice")
    queue.put(["4"], robot="bob")
    queue.wait_for_room("bob")

    assert waits(queue, "alice").is_alive()
    assert queue.take() == ["1", "2", "3", "4"]


def test_a_stopped_program_is_held_back_no_more() -> None:
    queue = OutputQueue(silent, capacity=1)
    queue.hold_back()
    queue.put(["1"])
    held = waits(queue, None)
    queue.let_pass()
    held.join(TIMEOUT)

    assert not held.is_alive()


def test_the_answer_to_a_word_comes_before_all_that_waits() -> None:
    queue = OutputQueue(silent)
    queue.put(["1", "2"])
    queue.put_first(["Speed 2."])
    queue.put_first(["Speed 1."])

    assert queue.take(3) == ["Speed 2.", "Speed 1.", "1"]
    assert queue.take() == ["2"]


def test_the_oldest_lines_are_left_out() -> None:
    queue = OutputQueue(silent)
    queue.put(["1", "2", "3"])

    assert queue.trim(2) == 1
    assert queue.take() == ["2", "3"]
