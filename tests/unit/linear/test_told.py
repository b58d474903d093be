"""The lines between the program's thread and the one that prints."""

import threading

import pytest

from donnie_tui.linear.told import Told, printable


def silent() -> None:
    return


@pytest.mark.parametrize(
    ("line", "printed"),
    [
        ("I walked.", "I walked."),
        ("  a\tb \n", "a b"),
        ("\x1b[2Jx\x07", "[2Jx"),
        ("\x00\x7f\x9b", ""),
        ("\u202ex", "x"),
        ("olá, 漢字", "olá, 漢字"),
    ],
)
def test_only_printable_text_gets_through(line: str, printed: str) -> None:
    assert printable(line) == printed


def test_lines_come_out_in_the_order_in_which_they_were_told() -> None:
    told = Told(silent)
    told.put(["one", "", "two"])
    told.put(["three"])

    assert (told.take(), told.take()) == (["one", "two", "three"], [])


def test_somebody_who_waits_is_nudged_by_the_first_line_only() -> None:
    nudges: list[int] = []
    told = Told(lambda: nudges.append(1))
    told.put([""])
    told.put(["one"])
    told.put(["two"])

    assert len(nudges) == 1


def test_a_program_that_tells_too_much_is_held_back_until_somebody_reads() -> None:
    told = Told(silent, capacity=2)
    told.hold_back()
    told.put(["1", "2"])
    teller = threading.Thread(target=told.put, args=(["3"],), daemon=True)
    teller.start()
    teller.join(0.05)

    assert teller.is_alive()
    assert told.take() == ["1", "2"]
    teller.join(10)
    assert told.take() == ["3"]


def test_a_stopped_program_is_held_back_no_more() -> None:
    told = Told(silent, capacity=1)
    told.hold_back()
    told.put(["1"])
    teller = threading.Thread(target=told.put, args=(["2"],), daemon=True)
    teller.start()
    told.let_pass()
    teller.join(10)

    assert told.take() == ["1", "2"]


def test_the_oldest_lines_are_left_out() -> None:
    told = Told(silent)
    told.put(["1", "2", "3"])

    assert told.trim(2) == 1
    assert told.take() == ["2", "3"]
