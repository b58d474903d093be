"""The looks: what is painted is measured, not what was meant."""

from collections.abc import Iterator

import pytest
from rich.segment import Segment

from donnie_tui.settings.settings import THEMES
from donnie_tui.tui import themes

pytestmark = pytest.mark.slow

LEAST_TEXT, LEAST_BORDER, LEAST_FLOOR = 7.0, 4.5, 3.0
FLOOR = {".", " "}
BORDERS = set("|▔▁▊▎─│┌┐└┘━┃▀▄█▌▐")
RGB = tuple(name for name in themes.NAMES if name != themes.TERMINAL)

KINDS = ("error", "obstacle", "spoke", "typed", "moved")
KIND_WORDS = ("error", "obstacle", "says", "typed", "moved")

PROGRAM = """\
PROCEDURE WALK: n DO -- a comment
SPEAK "text" FW n
END PROCEDURE
VAR n = 3 + 4
WALK [n]
TURN 90"""


def luminance(triplet) -> float:
    def linear(part: float) -> float:
        return part / 12.92 if part <= 0.03928 else ((part + 0.055) / 1.055) ** 2.4

    red, green, blue = (linear(part / 255) for part in triplet)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one, other) -> float:
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def painted(app) -> Iterator[Segment]:
    for strip in app.screen._compositor.render_strips():
        yield from strip


def is_edge_of_frame(before: str = "", text: str = "", after: str = "") -> bool:
    """Whether the middle one of three neighbours is a part of ``+-----+``, and no mark of the map."""
    return is_line(text) or (text == "+" and (is_line(before) or is_line(after)))


def is_line(text: str) -> bool:
    return len(text) > 2 and set(text) == {"-"}


def too_faint(app) -> dict[str, float]:
    """What is on the screen with too little contrast, and how much it has."""
    found = {}
    segments = [*painted(app)]
    for at, (text, style, _) in enumerate(segments):
        if not text.strip() or style is None or style.color is None or style.bgcolor is None:
            continue
        ratio = contrast(style.color.get_truecolor(), style.bgcolor.get_truecolor())
        signs = set(text.strip())
        is_border = signs <= BORDERS or is_edge_of_frame(*(each.text for each in segments[at - 1 : at + 2]))
        least = LEAST_BORDER if is_border else LEAST_FLOOR if signs <= FLOOR else LEAST_TEXT
        if ratio < least or style.dim:
            found[f"{text.strip()[:30]} {style}"] = round(ratio, 2)
    return found


@pytest.mark.parametrize("name", RGB)
async def test_every_text_that_is_painted_has_a_contrast_of_seven(open_screen, name):
    async with open_screen(PROGRAM, world="living_room", size=(120, 40)) as screen:
        screen.app.theme = name
        await screen.press("f5")
        await screen.shows("Error, line 6")
        await screen.idle()
        faint = too_faint(screen.app)
        for widget in (
            screen.main.map,
            screen.main.log_rows,
            screen.main.inspector,
            screen.main.command_line,
        ):
            widget.focus()
            await screen.pilot.pause()
            faint |= too_faint(screen.app)
        screen.main.editor.focus()
        await screen.press("shift+up", "shift+right")
        faint |= too_faint(screen.app)
        await screen.press("ctrl+a")
        faint |= too_faint(screen.app)
        for key, leave in (("f1", "escape"), ("ctrl+p", "escape"), ("ctrl+n", "escape")):
            await screen.press(key)
            await screen.until(lambda: screen.app.screen is not screen.main, key)
            await screen.painted()
            faint |= too_faint(screen.app)
            await screen.press(leave)
            await screen.until(lambda: screen.app.screen is screen.main, leave)

        assert faint == {}


@pytest.mark.parametrize("name", themes.NAMES)
async def test_selected_text_has_the_colours_of_what_is_chosen_whatever_its_syntax(open_screen, name):
    """In the terminal's own look: its own two colours, the other way round."""
    async with open_screen('FW 5\n\nSPEAK "a"', size=(80, 24)) as screen:
        screen.app.theme = name
        screen.main.editor.focus()
        await screen.press("ctrl+a")
        await screen.pilot.pause()
        editor = screen.main.editor
        rows = [editor.render_line(y).crop(editor.gutter_width) for y in range(4)]
        chosen = [[each for each in row if each.style.reverse or name in RGB][:3] for row in rows]
        words = themes.theme(name).variables

        assert "".join(each.text for each in chosen[0]).startswith("FW 5")
        for segment in [*chosen[0], chosen[1][0], chosen[2][0]]:
            if not segment.text.strip() and segment is not chosen[1][0]:
                continue
            style = segment.style
            if name == themes.TERMINAL:
                assert (style.reverse, style.color.is_default, style.bgcolor.is_default) == (True,) * 3
            else:
                assert (style.color.name, style.bgcolor.name) == (words["on-chosen"], words["chosen"])


@pytest.mark.parametrize("size", [(80, 24), (40, 16)], ids=["wide", "narrow"])
@pytest.mark.parametrize("name", [*RGB, themes.TERMINAL])
async def test_each_kind_of_line_in_the_log_has_its_look_and_its_words(open_screen, name, size):
    async with open_screen("", size=size) as screen:
        screen.app.theme = name
        screen.app.controller.display.write(("Sentence.", kind) for kind in KINDS)
        screen.main.go_to(screen.main.log_pane)
        await screen.until(lambda: len(screen.main.log_rows.lines) > len(KINDS), "the log")
        screen.main.command_line.focus()
        await screen.pilot.pause()
        rows = screen.main.log_rows
        seen = [rows._segments(rows.row_count - len(KINDS) + at) for at in range(len(KINDS))]
        said = [next(each for each in row if each.text in KIND_WORDS) for row in seen]
        looks = [(each.style.color, each.style.bold, each.style.italic) for each in said]

        assert [each.text for each in said] == list(KIND_WORDS)
        assert len(set(looks)) == len(KINDS)
        if name in RGB:
            assert too_faint(screen.app) == {}


@pytest.mark.parametrize("name", RGB)
def test_a_thing_of_any_colour_can_be_seen_on_the_floor(name):
    looks, floor = themes.looks(name), _parts(themes.theme(name).background)
    found = {
        colour: contrast(looks[f"thing-{colour}"].color.get_truecolor(), floor) for colour in themes.COLOURS
    }

    assert {colour: round(ratio, 1) for colour, ratio in found.items() if ratio < LEAST_TEXT} == {}


@pytest.mark.parametrize("name", RGB)
def test_the_free_floor_is_far_dimmer_than_a_thing_or_the_robot(name):
    looks, floor = themes.looks(name), _parts(themes.theme(name).background)
    found = {
        each: contrast(looks[each].color.get_truecolor(), floor) for each in ("free", "robot", "thing-gray")
    }

    assert LEAST_FLOOR <= found["free"] <= min(found["robot"], found["thing-gray"]) / 2


def _parts(colour: str) -> tuple[int, int, int]:
    return tuple(int(colour[at : at + 2], 16) for at in (1, 3, 5))


def test_every_setting_of_the_look_is_one():
    assert tuple(map(themes.name_of, THEMES)) == themes.NAMES
    assert tuple(themes.theme(name).name for name in themes.NAMES) == themes.NAMES


@pytest.mark.parametrize("name", themes.NAMES)
@pytest.mark.parametrize("keys", [("ctrl+g",), ("down", "end", "ctrl+@")], ids=["question", "words"])
async def test_the_program_stays_visible_next_to_a_question(open_screen, name, keys):
    """In the terminal's own colours, too, which Textual can't make transparent by a percentage."""
    async with open_screen("FW 1\nREP") as screen:
        screen.app.theme = name
        await screen.press(*keys)
        await screen.until(lambda: screen.app.screen is not screen.main, "the question")
        await screen.painted()

        assert "1  FW 1" in screen.text
        assert "Map: " in screen.text
