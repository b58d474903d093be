"""Control characters are removed wherever text is shown, printed, read or quoted."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from rich.segment import Segment
from textual.color import Color

from donnie_tui.core.document import Document
from donnie_tui.core.events import Spoke
from donnie_tui.core.program_files import decode
from donnie_tui.core.transcript import lines_of
from donnie_tui.i18n.words import Words
from donnie_tui.linear.output import OutputQueue
from donnie_tui.tui.terminal import PrintableFilter
from language.diagnostics import Diagnostic, MistakeKind, Span
from language.source import printable

HARMFUL = (
    *map(chr, (*range(0x20), *range(0x7F, 0xA0), 0x2028, 0x2029, *range(0x202A, 0x202F))),
    *map(chr, (*range(0x2066, 0x206A), 0xD800, 0xDFFF)),
)
WHOLE = "ação \u00a0 日本 👩\u200d🔬 שלום"
"""A blank that does not break, and what joins two signs to one, are text."""


def on_the_screen(text: str) -> str:
    return "".join(each.text for each in PrintableFilter().apply([Segment(text)], Color(0, 0, 0)))


def in_the_log(text: str) -> str:
    return " ".join(lines_of(Spoke(text), Words()))


def in_the_linear_mode(text: str) -> str:
    queue = OutputQueue(lambda: None)
    queue.put([text])
    return " ".join(queue.take())


def from_a_file(text: str) -> str:
    return decode(text.replace("\0", "").encode("utf-8", "replace"), "a.gd")  # one with a NUL is refused


def typed(text: str) -> str:
    program = Document()
    program.add(text)
    return program.text


def in_a_mistake(text: str) -> str:
    return Words().mistake(Diagnostic(MistakeKind.UNKNOWN_COMMAND, Span(0, 1, 1, 1), found=text))


EVERYWHERE = (printable, on_the_screen, in_the_log, in_the_linear_mode, from_a_file, typed, in_a_mistake)


@pytest.mark.parametrize("way", EVERYWHERE)
def test_no_output_has_a_control_character(way: Callable[[str], str]) -> None:
    kept = "\t\r\n" if way in (from_a_file, typed) else ""
    assert [each for each in HARMFUL if each in way(f"a{each}b") and each not in kept] == []


@pytest.mark.parametrize("way", EVERYWHERE)
def test_all_other_text_stays_whole(way: Callable[[str], str]) -> None:
    wanted = " ".join(WHOLE.split()) if way is in_a_mistake else WHOLE
    assert wanted in way(WHOLE)
