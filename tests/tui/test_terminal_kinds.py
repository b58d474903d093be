"""The full screen on terminals of several kinds: none is asked for what it may not know."""

import re

import pytest

from tests.tui.terminal import _KITTY, CTRL_Q, ENTER, left_as_found

pytestmark = pytest.mark.slow

KINDS = {"xterm-256color": 256, "linux": 16, "screen": 16, "tmux-256color": 256, "vt100": 0}
"""Kinds of terminal, and how many colours they know at most."""


CONTROL = re.compile(
    rb"\x1b(?:\[[0-?]*[ -/]*[@-~]|[\]P_^X][^\x07\x1b]*(?:\x07|\x1b\\)|[^\[\]P_^X])"
    rb"|[\x00-\x08\x0b\x0c\x0e-\x1a\x1c-\x1f]"
)
"""A control sequence, or a sign that moves nothing."""


PLAIN_CONTROL = re.compile(rb"\x1b\[\??[0-9;]*[A-Za-z]")
"""One that every terminal since the VT100 takes as one, whether it knows what it asks for or not."""


COLOUR = re.compile(rb"\x1b\[(?:\d+;)*(?:[349]|10)[0-8](?:;\d+)*m")
"""A colour that is set; 39 and 49 are the terminal's own."""


ASKED = (b"\x1b[?2026$p", b"\x1b[?2048$p")
"""What Textual asks before the first frame, which covers what a terminal might make of them."""


@pytest.mark.parametrize("name", KINDS)
def test_it_works_on_this_kind_of_terminal(terminal, name):
    donnie = terminal("--world", "living_room", TERM=name)
    if name != "xterm-256color":
        assert {each for each in CONTROL.findall(donnie.raw) if not PLAIN_CONTROL.fullmatch(each)} <= {*ASKED}
    assert b"8;2;" not in donnie.raw
    assert (b"8;5;" in donnie.raw) is (KINDS[name] == 256)
    assert bool(COLOUR.search(donnie.raw)) is (KINDS[name] > 0)
    donnie.shows("F5 runs the program.")
    donnie.shows("Living room")
    donnie.type('SPEAK "here"' + ENTER)
    donnie.shows("SPEAK")
    donnie.type("\x1b[15~" if name != "linux" else "\x1b[[E")
    donnie.shows("The program is done.")
    donnie.type(CTRL_Q)
    donnie.shows("Save first, y or n?")
    donnie.type("no" + ENTER)

    assert donnie.ended() == 0
    assert left_as_found(donnie)
    what_is_left = "\n".join(line.rstrip() for line in donnie.screen.display).strip()
    assert what_is_left.startswith("Screen reader?")  # the emulator has no other screen to leave for
    assert what_is_left.endswith("The program is done.")


@pytest.mark.parametrize("name", ["linux", "vt100"])
def test_the_map_as_a_picture_is_there_where_there_are_colours(terminal, name):
    """On a console a bright background is a dark one: next to a wall a thing is never the background."""
    donnie = terminal("--world", "living_room", TERM=name, COLORTERM="")
    donnie.type("\x0bp")
    donnie.shows("The map is a picture." if KINDS[name] else "There are no colors here.")
    if KINDS[name]:
        donnie.until(lambda: "▄" in donnie.screen.display[2], "half blocks")
        seen = [each for row in donnie.screen.buffer.values() for each in row.values() if each.data in "▀▄"]
        assert {each.fg for each in seen} > {"brightred", "brightgreen", "brightblue"}
        assert "brightwhite" in {each.bg for each in seen}
        assert {each.bg for each in seen if each.fg == "brightwhite"} == {"black"}
    else:
        donnie.shows("######LLLL")


def test_the_plain_layout_asks_for_no_mouse_and_no_key_reports(terminal):
    donnie = terminal("--plain", DONNIE_PLAIN="")

    assert not re.search(rb"\x1b\[\?100[0236]h", donnie.raw)
    assert not _KITTY.search(donnie.raw)
