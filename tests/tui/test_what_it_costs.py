"""What a program pays for being looked at: how often that is, and what is painted. Counts, no times."""

import asyncio
from collections.abc import Callable

import pytest
from textual.containers import Horizontal, Vertical
from textual.document._wrapped_document import WrappedDocument
from textual.dom import DOMNode
from textual.geometry import Region
from textual.message_pump import MessagePump
from textual.widget import Widget
from textual.widgets import TextArea
from textual.widgets.text_area import Selection

from donnie_tui.tui import themes
from donnie_tui.tui.highlighting import highlights
from donnie_tui.tui.run_view import SELDOM, SOON, Polling
from donnie_tui.tui.screens.main_screen import MainScreen
from donnie_tui.tui.widgets.editor import Editor
from donnie_tui.tui.widgets.map_view import MapView

pytestmark = pytest.mark.slow


class Clock:
    """Timers that go off when the time is put forward."""

    def __init__(self) -> None:
        self.now = 0.0
        self.timers: list[Timer] = []

    def later(self, seconds: float, do: Callable[[], None]) -> "Timer":
        self.timers.append(Timer(self, self.now + seconds, do))
        return self.timers[-1]

    def go_on(self, seconds: float) -> None:
        end = self.now + seconds
        while due := [each for each in self.timers if each.at <= end + 1e-9]:
            first = min(due, key=lambda each: each.at)
            self.timers.remove(first)
            self.now = first.at
            first.do()
        self.now = end


class Timer:
    def __init__(self, clock: Clock, at: float, do: Callable[[], None]) -> None:
        self.clock, self.at, self.do = clock, at, do

    def stop(self) -> None:
        if self in self.clock.timers:
            self.clock.timers.remove(self)


def begun() -> tuple[Clock, Polling, list[float]]:
    clock, looks = Clock(), list[float]()
    polling = Polling(lambda: looks.append(clock.now), clock.later)
    polling.begin()
    return clock, polling, looks


def test_a_silent_program_is_polled_once_a_second_and_wakes_nothing_else() -> None:
    clock, _, looks = begun()
    clock.go_on(SOON)
    assert looks == [SOON]
    woken = 0
    for _ in range(60 * 50):
        waiting = list(clock.timers)
        clock.go_on(1 / 50)
        woken += waiting != clock.timers

    assert SELDOM == 1.0
    assert len(looks) <= 63
    assert woken == len(looks) - 1


def test_a_talking_program_is_polled_soon_and_at_most_five_times_a_second() -> None:
    clock, polling, looks = begun()
    clock.go_on(10)
    heard_at = clock.now
    looks.clear()
    polling.on_event()
    clock.go_on(SOON)
    assert looks == [heard_at + SOON]

    looks.clear()
    for _ in range(20 * 10):
        polling.on_event()
        clock.go_on(1 / 20)
    assert 40 <= len(looks) <= 10 / SOON


def test_nothing_is_looked_at_after_the_end() -> None:
    clock, polling, looks = begun()
    polling.begin()
    assert polling.is_on
    assert len(clock.timers) == 1
    polling.end()
    polling.on_event()
    clock.go_on(10)

    assert not looks
    assert not polling.is_on


def due() -> list[asyncio.TimerHandle]:
    """What the event loop does later although nothing arrives."""
    return [each for each in asyncio.get_running_loop()._scheduled if not each.cancelled()]


@pytest.mark.parametrize(
    "keys", ["", "tab", "shift+tab", "ctrl+p", "ctrl+p a", "ctrl+o", "f1", "ctrl+g", "ctrl+k", "R E P E"]
)
async def test_whatever_is_in_front_an_idle_screen_has_nothing_due_however_long_it_waits(open_screen, keys):
    """So it writes no byte: no cursor blinks, no clock is shown, nothing is polled."""
    async with open_screen("FW 1\n", world="living_room") as screen:
        await screen.press("f5")
        await screen.shows("The program is done.")
        await screen.idle()
        await screen.press("down", *keys.split())
        await screen.painted()
        quiet = 0

        def stays_quiet() -> bool:
            """What the keys began may begin something itself."""
            nonlocal quiet
            quiet = 0 if due() else quiet + 1
            return quiet == 5

        await screen.until(stays_quiet, "nothing is due")


async def test_a_container_is_not_painted(open_screen):
    async with open_screen(size=(120, 40)) as screen:
        painted = screen.main._compositor.visible_widgets
        assert not [each for each in painted if isinstance(each, Horizontal | Vertical)]
        assert len(painted) <= 13


async def test_a_number_among_the_variables_has_few_others_painted_again(open_screen, monkeypatch):
    """Textual asks each widget that is near for all of its rows."""
    asked: list[str] = []
    render_lines = Widget.render_lines

    def counted(self, crop):
        asked.append(str(self.id))
        return render_lines(self, crop)

    async with open_screen(size=(120, 40)) as screen:
        monkeypatch.setattr(Widget, "render_lines", counted)
        await screen.pilot.pause()
        asked.clear()
        screen.main.inspector.show(["Variables", "x = 1"])
        await screen.until(lambda: "inspector" in asked, "it is painted")
        await screen.pilot.pause()

        assert len(asked) <= 5
        assert not {"map", "editor", "log"} & {*asked}


async def test_a_run_that_begins_where_the_robot_stands_paints_no_more_of_the_map_than_its_row(
    open_screen, monkeypatch
):
    rows: list[int] = []
    render_line = MapView.render_line
    monkeypatch.setattr(MapView, "render_line", lambda self, y: rows.append(y) or render_line(self, y))
    async with open_screen("SPEAK 1", size=(120, 40), world="living_room") as screen:
        await screen.pilot.pause()
        assert len(rows) >= 20
        rows.clear()
        await screen.press("f5")
        await screen.shows("The program is done.")
        await screen.pilot.pause()

        assert len({*rows}) <= 1


async def test_rows_that_are_painted_again_have_the_looks_that_they_had(open_screen, monkeypatch):
    asked: list[Widget] = []
    rich_style = DOMNode.rich_style.fget
    monkeypatch.setattr(DOMNode, "rich_style", property(lambda self: asked.append(self) or rich_style(self)))
    async with open_screen(size=(120, 40), world="living_room") as screen:
        await screen.run("REPEAT 30 TIMES SPEAK 1 END REPEAT")
        rows = (screen.main.log_rows, screen.main.map, screen.main.inspector)
        painted: list[Widget] = []
        render_lines = Widget.render_lines
        monkeypatch.setattr(
            Widget, "render_lines", lambda self, crop: painted.append(self) or render_lines(self, crop)
        )
        await screen.pilot.pause()
        asked.clear()
        for each in rows:
            each.refresh()
        await screen.until(lambda: {*rows} <= {*painted}, "all are painted")
        assert not {*rows} & {*asked}

        before = screen.main.map.painted_as("wall")
        screen.app.theme = "donnie-light"
        await screen.until(
            lambda: screen.main.map.painted_as("wall") != before, "the looks of the other theme"
        )


@pytest.mark.parametrize(("selected", "most"), [(False, 0), (True, 2)])
async def test_the_selection_is_located_once_a_frame_and_not_for_each_row(
    open_screen, monkeypatch, selected, most
):
    async with open_screen("FW 1\n" + "x" * 5000) as screen:
        editor = screen.main.editor
        if selected:
            editor.selection = Selection((0, 0), (1, 3000))
        await screen.pilot.pause()
        asked, find = [], WrappedDocument.location_to_offset
        monkeypatch.setattr(WrappedDocument, "location_to_offset", lambda *of: asked.append(of) or find(*of))
        editor.refresh()
        strips = editor.render_lines(Region(0, 0, *editor.size))

        assert len(strips) > 5
        assert len(asked) <= most


async def test_a_key_in_a_huge_line_wraps_nothing_and_the_cursor_is_seen(
    open_screen, monkeypatch: pytest.MonkeyPatch
) -> None:
    wrapped: list[str] = []
    monkeypatch.setattr(
        "textual.document._wrapped_document.compute_wrap_offsets",
        lambda text, *_, **__: wrapped.append(text) or [],
    )
    async with open_screen() as screen:
        editor = screen.main.editor
        screen.load(f'SPEAK "{"a" * 200_000}"\nFW 1\n')
        await screen.press("end")
        wrapped.clear()
        await screen.press("x", "y", "backspace")
        await screen.painted()

        assert wrapped == []
        assert screen.text.splitlines()[1].split()[:2] == ["1", f'{"a" * 31}"x']
        assert editor.cursor_screen_offset.x < editor.size.width

        await screen.press("shift+left", "shift+left")
        await screen.painted()
        look = themes.looks(screen.app.theme)["selected"]
        chosen = [
            each.text for each in editor.render_line(0) if each.style and each.style.bgcolor == look.bgcolor
        ]
        assert "".join(chosen) == '"x'

        screen.load("FW 1")
        assert editor.soft_wrap


def test_a_line_of_any_length_is_shown_plainly_and_the_others_are_not() -> None:
    found = highlights(f"FW 1\n{'FW 1 ' * 1000}\nFW 2 -- a\n")

    assert sorted(found) == [0, 2]


async def test_a_letter_paints_its_line_alone_and_asks_for_no_colours(open_screen, monkeypatch) -> None:
    rows: list[int] = []
    asked: list[DOMNode] = []
    render_line, rich_style = Editor.render_line, DOMNode.rich_style.fget
    async with open_screen("FW 1\nFW 2\nFW 3\n") as screen:
        await screen.press("down", "end")
        await screen.painted()
        monkeypatch.setattr(Editor, "render_line", lambda self, y: rows.append(y) or render_line(self, y))
        monkeypatch.setattr(
            DOMNode, "rich_style", property(lambda self: asked.append(self) or rich_style(self))
        )
        await screen.press("0")
        await screen.painted()

        assert screen.main.editor.text.splitlines()[1] == "FW 20"
        assert set(rows) == {1}
        assert screen.main.editor not in asked


async def test_a_letter_goes_to_the_application_on_the_shortest_way(open_screen, monkeypatch) -> None:
    passed: list[object] = []
    dispatch = MessagePump._dispatch_message

    async def counted(self, message):
        if isinstance(self, Horizontal | Vertical | MainScreen):
            passed.append(message)
        await dispatch(self, message)

    async with open_screen("FW 1") as screen:
        await screen.press("end")
        await screen.painted()
        monkeypatch.setattr(MessagePump, "_dispatch_message", counted)
        await screen.press("0")
        await screen.painted()

        assert not [each for each in passed if isinstance(each, TextArea.Changed | TextArea.SelectionChanged)]


@pytest.mark.slow
async def test_what_stays_when_a_line_is_typed_is_what_would_be_painted_now(open_screen) -> None:
    """Words are letters; a text without its end colours the lines below it, a long line moves them."""
    typed = 'ab "|enter|up| x|home|"|right|(|down|)|left|backspace|up|end|' + f"{'word ' * 20}|ctrl+z|ctrl+y"
    async with open_screen('FW 1\nSPEAK (1 +\n2) "a"\nREPEAT 2 TIMES\nFW 1\nEND REPEAT\n') as screen:
        editor = screen.main.editor
        await screen.press("down", "end", "left")
        for each in typed.split("|"):
            keys = [each] if len(each) > 1 and each.isascii() and " " not in each else list(each)
            for key in keys:
                await screen.press(key)
                await screen.painted()
                window = Region(0, 0, *editor.size)
                kept = editor.render_lines(window)
                editor.refresh()
                assert kept == editor.render_lines(window), (each, key)
        editor.replace("FW 2\nFW 3", (0, 0), editor.document.end)
        editor.replace("BW 2\nBW 3", (0, 0), (1, 4))
        await screen.painted()
        kept = editor.render_lines(window)
        editor.refresh()
        assert kept == editor.render_lines(window)
