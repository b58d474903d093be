"""Bytes become keys, whatever pieces they come in."""

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from donnie_tui.linear.line_editor import Act, KeyDecoder, KeyPress
from donnie_tui.linear.reader import How, Typed
from tests.unit.linear.test_wakeups import Console, editor


def decoded(*pieces: bytes) -> list[KeyPress]:
    decoder = KeyDecoder()
    keys = [key for piece in pieces for key in decoder.feed(piece)]
    return keys + decoder.give_up_waiting()


def text(typed: str) -> KeyPress:
    return KeyPress(Act.TEXT, typed)


@pytest.mark.parametrize(
    ("data", "act"),
    [
        (b"\r", Act.ENTER),
        (b"\n", Act.ENTER),
        (b"\x1bOM", Act.ENTER),
        (b"\x7f", Act.BACKSPACE),
        (b"\x08", Act.BACKSPACE),
        (b"\x1b[3~", Act.DELETE),
        (b"\x1b[3;5~", Act.DELETE),
        (b"\x1b[8~", Act.END),
        (b"\x1bOH", Act.HOME),
        (b"\x02", Act.LEFT),
        (b"\x06", Act.RIGHT),
        (b"\x0e", Act.NEWER),
        (b"\x10", Act.OLDER),
        (b"\x1b[A", Act.OLDER),
        (b"\x1bOA", Act.OLDER),
        (b"\x1b[1;5A", Act.OLDER),
        (b"\x1b[B", Act.NEWER),
        (b"\x1b[C", Act.RIGHT),
        (b"\x1b[D", Act.LEFT),
        (b"\x1b[H", Act.HOME),
        (b"\x1b[1~", Act.HOME),
        (b"\x1b[7~", Act.HOME),
        (b"\x1bOF", Act.END),
        (b"\x1b[4~", Act.END),
        (b"\x01", Act.HOME),
        (b"\x05", Act.END),
        (b"\x0b", Act.KILL_AFTER),
        (b"\x15", Act.KILL_BEFORE),
        (b"\x17", Act.KILL_WORD),
        (b"\x03", Act.INTERRUPT),
        (b"\x04", Act.CLOSE),
        (b"\x1b", Act.ESCAPE),
    ],
)
def test_a_key_is_what_its_bytes_say(data: bytes, act: Act) -> None:
    assert decoded(data) == [KeyPress(act)]


@pytest.mark.parametrize(
    "data", [b"\x1b[5~", b"\x1b[15~", b"\x1bOP", b"\x1b[[A", b"\x1b[200~", b"\x00", b"\x1b[<0;1;1M"]
)
def test_a_key_without_a_meaning_types_nothing(data: bytes) -> None:
    assert decoded(data) == []


def test_an_escape_waits_for_what_may_follow() -> None:
    decoder = KeyDecoder()

    assert decoder.feed(b"\x1b") == []
    assert decoder.is_waiting
    assert decoder.feed(b"[A") == [KeyPress(Act.OLDER)]
    assert not decoder.is_waiting


def test_an_escape_and_the_sign_after_it_are_two_keys_if_nothing_more_comes() -> None:
    assert decoded(b"\x1b[") == [KeyPress(Act.ESCAPE), text("[")]
    assert decoded(b"\x1b[1;") == [KeyPress(Act.ESCAPE), text("[1;")]
    assert KeyDecoder().give_up_waiting() == []


def test_an_escape_before_text_is_a_key_of_its_own() -> None:
    assert decoded(b"FW 3\x1bSCAN\r") == [
        text("FW 3"),
        KeyPress(Act.ESCAPE),
        text("SCAN"),
        KeyPress(Act.ENTER),
    ]


def test_two_escapes_are_two_keys() -> None:
    assert decoded(b"\x1b\x1b") == [KeyPress(Act.ESCAPE), KeyPress(Act.ESCAPE)]


def test_a_character_may_come_in_pieces() -> None:
    assert decoded(b"a\xc3", b"\xa7\xe6", b"\xbc\xa2") == [text("a"), text("ç"), text("漢")]


def test_bytes_that_are_no_text_are_shown_as_such() -> None:
    assert decoded(b"\xff") == [text("\ufffd")]


def test_a_tab_in_what_is_pasted_is_a_blank() -> None:
    assert decoded(b"FW\t3") == [text("FW"), text(" "), text("3")]


def test_a_sequence_without_an_end_does_not_wait_forever() -> None:
    decoder = KeyDecoder()

    assert decoder.feed(b"\x1b[" + b"1" * 100)[0] == KeyPress(Act.ESCAPE)
    assert not decoder.is_waiting


@given(
    st.lists(
        st.sampled_from([b"\x1b", b"[", b"O", b"A", b"1;5", b"~", b"x", b"\xc3", b"\xa7", b"\r", b"3"]),
        max_size=30,
    )
)
def test_pieces_make_no_difference(pieces: list[bytes]) -> None:
    def typed(keys: list[KeyPress]) -> list[tuple[Act, str]]:
        """One text or several is the same."""
        return [(key.act, letter) for key in keys for letter in key.text or " "]

    assert typed(decoded(*pieces)) == typed(decoded(b"".join(pieces)))


def test_tab_completes_at_the_end_of_what_was_typed_and_is_a_blank_in_a_paste() -> None:
    assert KeyDecoder().feed(b"\t") == [KeyPress(Act.COMPLETE)]
    assert KeyDecoder().feed(b"EXP\t") == [KeyPress(Act.TEXT, "EXP"), KeyPress(Act.COMPLETE)]
    assert KeyDecoder().feed(b"FW\t3") == [
        KeyPress(Act.TEXT, "FW"),
        KeyPress(Act.TEXT, " "),
        KeyPress(Act.TEXT, "3"),
    ]


def completed(offered: str, *words: str) -> Typed:
    """The line after Tab, and Enter if it is still edited."""
    console: Any = Console(b"\t")
    reader = editor(console)

    def complete(_: str) -> tuple[str, ...]:
        console.type(b"\r")
        return words

    reader.complete = complete
    return reader.read("> ", offered)


@pytest.mark.parametrize(
    ("offered", "words", "line"),
    [
        ("rep", ("repeat",), "repeat "),
        ("FW 1 rep", ("repeat",), "FW 1 repeat "),
        ("OPEN fo", ("folder/",), "OPEN folder/"),  # there is more to choose in it
        ("repeat", ("repeat",), "repeat "),
        ("r", ("read", "real"), "rea"),
        ("x", (), "x"),
    ],
)
def test_tab_writes_as_much_as_is_certain(offered: str, words: tuple[str, ...], line: str) -> None:
    assert completed(offered, *words) == Typed(line, How.ENTER)


def test_tab_lists_the_words_of_which_nothing_more_is_certain() -> None:
    assert completed("rea", "read", "real") == Typed("rea", How.CHOICES, ("read", "real"))
