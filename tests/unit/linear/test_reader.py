"""Lines as they are read: bytes from a pipe, keys of an editor, and the words that Tab offers."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace as Part
from typing import Any

import pytest

from donnie_tui.core.session_log import LineHistory
from donnie_tui.i18n.words import Words
from donnie_tui.linear.line_editor import LONGEST, Act, EditLine, KeyDecoder
from donnie_tui.linear.reader import LONGEST_PLAIN, EditingReader, How, PlainReader, Typed, candidates
from tests.unit.linear.test_wakeups import Console, editor

Lines = list[tuple[str, How]]
END = ("", How.CLOSED)


class Pipe(Console):
    """Pieces that arrive one after the other, then the end of the input."""

    def __init__(self, *pieces: bytes) -> None:
        super().__init__()
        self.pieces = [*pieces, b""]

    def wait(self, seconds: float | None = None, *, reading: bool = False) -> bool:
        return reading and bool(self.pieces)

    def read(self) -> bytes:
        return self.pieces.pop(0)


def read_all(*pieces: bytes) -> Lines:
    console: Any = Pipe(*pieces)
    reader, lines = PlainReader(console), Lines()
    while lines[-1:] != [END]:
        typed = reader.read("")
        lines.append((typed.text, typed.how))
    return lines[:-1]


# --- plain lines


@pytest.mark.parametrize(
    ("pieces", "lines"),
    [
        ((), []),
        ((b"FW 1",), ["FW 1"]),
        ((b"FW 1\n",), ["FW 1"]),
        ((b"\n\nFW 1",), ["", "", "FW 1"]),
        ((b"FW", b" 1\nTR", b" 90\n"), ["FW 1", "TR 90"]),
        ((b"a\r\nb\rc\nd",), ["a", "b", "c", "d"]),
        ((b"a\r", b"\nb\r", b"c"), ["a", "b", "c"]),
        ((b"a\r", b"\n\nb"), ["a", "", "b"]),
        ((b"a\n", b"\nb"), ["a", "", "b"]),
        (("olá\n".encode(), "não".encode()), ["olá", "não"]),
        (("olá\n".encode("cp1252"), b"b"), ["olá", "b"]),
        (("\ufeffolá\nb\n".encode("utf-16-be"),), ["olá", "b"]),
        (("olá\r\nb".encode("utf-16"),), ["olá", "b"]),
        (("olá".encode("utf-16")[:3], "olá".encode("utf-16")[3:]), ["olá"]),
        (("ab".encode("utf-16")[:5],), ["a\ufffd"]),
    ],
)
def test_a_line_ends_with_any_line_end_and_has_any_usual_encoding(
    pieces: tuple[bytes, ...], lines: list[str]
) -> None:
    assert read_all(*pieces) == [(line, How.ENTER) for line in lines]


LONG = b"x" * LONGEST_PLAIN


@pytest.mark.parametrize(
    ("pieces", "lines"),
    [
        ((LONG + b"\nb\n",), [(LONG.decode(), How.ENTER), ("b", How.ENTER)]),
        ((LONG + b"x\nb\n",), [("", How.TOO_LONG), ("b", How.ENTER)]),
        ((LONG, b"x", b"y", b"z\nb\n"), [("", How.TOO_LONG), ("b", How.ENTER)]),
        ((LONG, b"xy"), [("", How.TOO_LONG)]),
    ],
    ids=["the longest", "a longer one", "in pieces", "at the end"],
)
def test_a_line_that_is_too_long_is_left_out_as_a_whole(pieces: tuple[bytes, ...], lines: Lines) -> None:
    assert read_all(*pieces) == lines


def test_of_a_line_that_is_too_long_nothing_is_kept_while_it_comes() -> None:
    console: Any = Pipe(LONG + b"x", b"y\n")
    console.leaving = 15
    reader = PlainReader(console)
    reader._take(console.read())
    assert reader.read("") == Typed("", How.CLOSED)
    assert not reader.has_typed


def test_a_signal_that_ends_donnie_ends_the_input_after_the_lines_that_came() -> None:
    console: Any = Console(b"FW 1\nFW")
    reader = PlainReader(console)
    assert reader.read("").text == "FW 1"
    assert reader.has_typed
    console.leaving = 15
    assert reader.read("") == Typed("", How.CLOSED)


def test_the_rest_of_a_line_follows_news() -> None:
    console: Any = Console(b"FW")
    console.has_news = True
    reader = PlainReader(console)
    assert reader.read("").how is How.NEWS
    console.type(b" 1\n")
    assert reader.read("") == Typed("FW 1", How.ENTER)


# --- lines that are edited


def edited(typed: bytes, *past: str, offered: str = "") -> tuple[Typed, str]:
    """The line, and what was written meanwhile."""
    console: Any = Console(typed)
    history = LineHistory(None)
    history.lines = [*past]
    found = EditingReader(console, history).read("> ", offered)
    return found, console.written


@pytest.mark.parametrize(
    ("typed", "text", "how", "written"),
    [
        (b"FW 1\r", "FW 1", How.ENTER, "FW 1"),
        (b"FW 1\x1b\x1b", "FW 1", How.ESCAPE, "FW 1"),
        (b"FW\x03 1\r", "FW", How.INTERRUPTED, "FW"),
        (b"\x04", "", How.CLOSED, ""),
        (b"ab\x01\x04\r", "b", How.ENTER, "ab\b\bb\x1b[K\b"),
        (b"\x1b[A\r", "TR 90", How.ENTER, "TR 90"),
        (b"\x1b[A\x1b[A\r", "FW 1", How.ENTER, None),
        (b"x\x1b[A\x1b[B\r", "x", How.ENTER, None),
        (b"\x1b[B\r", "", How.ENTER, ""),
    ],
)
def test_a_line_is_edited_until_a_key_ends_it(typed: bytes, text: str, how: How, written: str | None) -> None:
    found, shown = edited(typed, "FW 1", "TR 90")

    assert found == Typed(text, how)
    assert written in (shown, None)


def test_an_offered_line_that_ends_at_the_margin_is_continued_below() -> None:
    found, written = edited(b"\r", offered="x" * 78)

    assert found == Typed("x" * 78, How.ENTER)
    assert written == " \r"


class Keyboard(Console):
    """What each wait brings: bytes, or an event without a key."""

    def __init__(self, *events: bytes | str) -> None:
        super().__init__()
        self.events = [*events]

    def wait(self, seconds: float | None = None, *, reading: bool = False) -> bool:
        event = self.events.pop(0)
        for each in event.split() if isinstance(event, str) else ():
            if each == "SIGTERM":
                self.leaving = 15
            elif each == "SIGINT":
                self.interrupted = True
            elif each == "news":
                self.has_news = True
            elif each.startswith("keys:"):
                self._typed = each.removeprefix("keys:").encode()
        self._typed = event if isinstance(event, bytes) else self._typed
        return bool(self._typed)


@pytest.mark.parametrize(
    ("events", "text", "how"),
    [
        ((b"FW", b" 1\r"), "FW 1", How.ENTER),
        ((b"FW", "nudge", b" 1\r"), "FW 1", How.ENTER),
        (("nudge", b"FW\r"), "FW", How.ENTER),
        ((b"FW", "news"), "FW", How.NEWS),
        (("news",), "", How.NEWS),
        ((b"FW", "SIGTERM"), "FW", How.CLOSED),
        ((b"FW", "SIGINT"), "FW", How.INTERRUPTED),
        ((b"FW", "keys:XY SIGINT"), "FW", How.INTERRUPTED),
        ((b"FW\x1b", "nothing"), "FW", How.ESCAPE),
        ((b"\x1b", b"[A", b"\r"), "TR 90", How.ENTER),
    ],
)
def test_a_line_waits_for_keys_and_is_interrupted_by_what_can_not_wait(
    events: tuple[bytes | str, ...], text: str, how: How
) -> None:
    console: Any = Keyboard(*events)
    history = LineHistory(None)
    history.lines = ["TR 90"]
    reader = EditingReader(console, history)

    assert reader.read("> ") == Typed(text, how)
    assert not reader.has_typed, "what came with Ctrl+C is dropped"


def test_news_come_below_all_rows_of_the_line() -> None:
    console: Any = Keyboard(b"x" * 100, b"\x01", "news")

    assert EditingReader(console, LineHistory(None)).read("> ").how is How.NEWS
    assert console.written.endswith("\x1b[1B\x1b[20C"), "from column 2 of the first row to 22 of the second"


def test_what_tab_completes_is_written() -> None:
    console: Any = Keyboard(b"rep\t", b"2\r")
    reader = EditingReader(console, LineHistory(None))
    reader.complete = lambda _: ("repeat",)

    assert reader.read("> ").text == "repeat 2"
    assert console.written == "repeat 2"


def test_keys_that_were_typed_ahead_after_tab_are_done_with_it() -> None:
    console: Any = Console(b"rep\t")
    reader = editor(console)
    reader.complete = lambda _: ("repeat",)
    for more in (b"2\r", b""):
        assert reader.take_ahead(lambda _: False) is None
        console.type(more)

    assert reader.read("> ") == Typed("repeat 2", How.ENTER)


def test_a_signal_that_ends_donnie_ends_the_line_before_what_is_typed_after_it() -> None:
    console: Any = Console(b"FW 1\r")
    console.leaving = 15

    assert editor(console).read("> ", "TR") == Typed("TR", How.CLOSED)


def test_a_look_for_lines_typed_ahead_waits_for_none() -> None:
    console = Console()

    assert editor(console).take_ahead(lambda _: True) is None
    assert console.waits == []


@pytest.mark.parametrize(
    ("typed", "wanted", "found", "rest"),
    [
        (b"STOP\r", "STOP", "STOP", ""),
        (b"FW 1\rSTOP\rFW 2", "STOP", "STOP", "FW 1|FW 2"),
        (b"STOPX\x7f\r", "STOP", "STOP", ""),
        (b"STOP", "STOP", None, "STOP"),
        (b"ST\x1b[DOP\r", "STOP", None, "STOP|"),
        (b"FW 1\r", "STOP", None, "FW 1|"),
    ],
)
def test_a_wanted_line_is_taken_from_among_those_that_wait(
    typed: bytes, wanted: str, found: str | None, rest: str
) -> None:
    reader = editor(Console(typed))

    assert reader.take_ahead(lambda line: line == wanted) == found
    left = "".join("|" if key.act is Act.ENTER else key.text for key in reader._keys)
    assert left == rest


# --- words to choose from


@pytest.fixture
def offered(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., tuple[str, ...]]]:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "walk.gd").touch()
    (tmp_path / "walls").mkdir()
    team = Part(sessions=[Part(name="alice"), Part(name="bob")])
    donnie = Part(session=Part(variables={"speed": "3", "sped": "4"}), team=team)

    def offer(before: str, language: str = "en") -> tuple[str, ...]:
        ctx: Any = Part(words=Words(language), donnie=donnie)
        return candidates(ctx, before)

    yield offer


@pytest.mark.parametrize(
    ("before", "words"),
    [
        ("", ()),
        ("  ", ()),
        ("FW ", ()),
        ("repe", ("repeat",)),
        ("REPE", ("REPEAT",)),
        ("  REPE", ("REPEAT",)),
        ("FW spe", ("speak", "sped", "speed")),
        ("FW SPE", ("SPEAK", "sped", "speed")),
        ("spel", ("spell",)),
        ("FW spel", ()),
        ("ZOO", ()),
        ("OPEN wal", ("walk.gd", "walls/")),
        ("OPEN ", ("walk.gd", "walls/")),
        ("FW wal", ()),
        ("AROUND nor", ("north", "northeast", "northwest")),
        ("FW nor", ()),
        ("ROBOT bo", ("bob",)),
        ("ROBOT z", ()),
        ("WORLD maz", ("maze",)),
        ("FW maz", ()),
    ],
)
def test_tab_offers_what_may_stand_there(
    offered: Callable[..., tuple[str, ...]], before: str, words: tuple[str, ...]
) -> None:
    assert offered(before) == words


def test_no_more_words_are_offered_than_can_be_listened_to(
    offered: Callable[..., tuple[str, ...]], tmp_path: Path
) -> None:
    for number in range(120):
        (tmp_path / f"many{number:03}.gd").touch()

    assert offered("OPEN many") == tuple(f"many{number:03}.gd" for number in range(100))


# --- the edges of a line


@pytest.mark.parametrize(("length", "is_waiting"), [(31, True), (32, False)])
def test_a_sequence_waits_for_its_end_no_longer_than_any_real_one(length: int, is_waiting: bool) -> None:
    decoder = KeyDecoder()
    decoder.feed(b"\x1b[" + b"1" * (length - 2))

    assert decoder.is_waiting is is_waiting


@pytest.mark.parametrize(
    ("columns", "prompt", "typed", "written"),
    [
        (5, 7, "ab", "ab"),
        (5, 7, "abc", "abc \r"),
        (5, 5, "abcd", "abcd"),
        (5, 5, "abcde", "abcde \r"),
        (1, 0, "a", "a"),
        (1, 0, "ab", "ab \r"),
        (0, 1, "a", "a \r"),
    ],
)
def test_a_full_row_takes_the_cursor_to_the_next_one(
    columns: int, prompt: int, typed: str, written: str
) -> None:
    assert EditLine(prompt, lambda: columns).type(typed) == written


@pytest.mark.parametrize(
    ("act", "written"),
    [
        (Act.HOME, "\x1b[2A\b"),
        (Act.LEFT, "\b"),
        (Act.KILL_BEFORE, "\x1b[2A\b\x1b[J"),
        (Act.BACKSPACE, "\b\x1b[K"),
    ],
)
def test_a_line_of_several_rows_is_painted_from_the_row_that_changes(act: Act, written: str) -> None:
    line = EditLine(2, lambda: 5)
    line.type("abcdefghijk")

    assert line.do(act) == written


def test_the_last_row_of_a_line_is_reached_before_it_ends() -> None:
    line = EditLine(2, lambda: 5)
    line.type("abcdefghijk")
    assert line.finish() == ""
    line.do(Act.HOME)

    assert line.finish() == "\x1b[2B\x1b[1C"
    assert line.do(Act.RIGHT) == ""


def test_a_line_that_is_nearly_full_takes_what_fits_in_its_middle() -> None:
    line = EditLine(2, lambda: 80)
    line.type("x" * (LONGEST - 1))
    line.do(Act.HOME)
    line.type("abc")

    assert line.text == "a" + "x" * (LONGEST - 1)
    line.replace("y" * (LONGEST + 1))
    assert line.text == "y" * LONGEST


def test_a_line_that_fills_its_row_ends_in_the_next_one() -> None:
    line = EditLine(2, lambda: 5)
    line.type("abc")

    assert line.do(Act.LEFT) == "\x1b[1A\x1b[4C"
    assert line.finish() == "\x1b[1B\x1b[4D"
    line.type("d")
    line.do(Act.LEFT)
    assert line.do(Act.LEFT) == "\x1b[1A\x1b[4C"
    assert line.do(Act.RIGHT) == "\x1b[1B\x1b[4D", "no character is written over the margin"


def test_a_character_in_the_middle_of_a_line_writes_no_more_than_what_follows_it() -> None:
    line = EditLine(2, lambda: 80)
    line.type("abcd")
    line.do(Act.LEFT)

    assert line.type("x") == "xd\b"
