"""What is adapted to terminals, one by one: the input that is kept, the size, the cursor, the looks."""

from __future__ import annotations

import sys
from contextlib import contextmanager
from itertools import count
from threading import Event
from types import ModuleType
from types import SimpleNamespace as Part
from typing import Any

import pytest
from rich.segment import Segment
from rich.style import Style
from textual import timer as timer_module
from textual.app import App
from textual.color import Color
from textual.events import Key, Resize
from textual.geometry import Offset, Size
from textual.widgets import Input, Static, TextArea

from donnie_tui.settings.settings import Settings
from donnie_tui.tui import terminal, themes
from donnie_tui.tui.terminal import PrintableFilter, TerminalApp, take_any_bytes, use_mouse


class Mouse:
    """A driver of a terminal that writes down what it sends."""

    def __init__(self, *, uses_mouse: bool) -> None:
        self._mouse, self.sent = uses_mouse, list[str]()

    def _enable_mouse_support(self) -> None:
        assert self._mouse, "Textual's driver does nothing without it"
        self.sent.append("on")

    def _disable_mouse_support(self) -> None:
        assert self._mouse
        self.sent.append("off")

    def write(self, text: str) -> None:
        self.sent.append(text)


@pytest.mark.parametrize(
    ("before", "wanted", "sent"),
    [(False, True, ["on"]), (True, False, ["off"]), (True, True, []), (False, False, [])],
)
def test_reports_of_the_mouse_are_switched_if_they_are_to_change(
    before: bool, wanted: bool, sent: list[str]
) -> None:
    driver = Mouse(uses_mouse=before)
    use_mouse(driver, wanted=wanted)
    assert (driver.sent, driver._mouse) == (sent, wanted)
    use_mouse(object(), wanted=wanted)


def test_a_byte_of_another_encoding_is_shown_as_an_unknown_letter(monkeypatch: pytest.MonkeyPatch) -> None:
    module = ModuleType("a_driver")
    module.getincrementaldecoder = None  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "a_driver", module)
    take_any_bytes(type("Driver", (), {"__module__": "a_driver"}))
    decoder = module.getincrementaldecoder("utf-8")()
    assert (decoder.decode(b"a\xe7b"), decoder.decode(b"\xc3"), decoder.decode(b"\xa7")) == (
        "a\ufffdb",
        "",
        "ç",
    )
    other = ModuleType("another")
    monkeypatch.setitem(sys.modules, "another", other)
    take_any_bytes(type("Driver", (), {"__module__": "another"}))
    assert not hasattr(other, "getincrementaldecoder")


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("FW 1", "FW 1"),
        ("ação", "ação"),
        ("\x1b]2;title\x07", "]2;title"),
        ("a\x00b", "ab"),
        ("a\u202eb", "ab"),
    ],
)
def test_characters_that_command_a_terminal_are_taken_out_of_what_is_painted(text: str, shown: str) -> None:
    bold, control = Style(bold=True), Segment("\x1b[H", None, [(1,)])
    painted = PrintableFilter().apply([Segment(text, bold), control], Color(0, 0, 0))
    assert painted == [Segment(shown, bold), control]


# --- the application


@pytest.fixture
def app(monkeypatch: pytest.MonkeyPatch) -> TerminalApp:
    monkeypatch.delenv("NO_COLOR", raising=False)
    return TerminalApp(Settings(theme="light", plain=False))


def test_an_application_has_its_themes_no_motion_and_filtered_output(app: TerminalApp) -> None:
    assert (app.theme, app.animation_level) == ("donnie-light", "none")
    assert set(themes.NAMES) <= app.available_themes.keys()
    assert isinstance(app._filters[-1], PrintableFilter)
    assert app._painted is not None
    assert not app.is_read_by_rows
    light = themes.theme(themes.LIGHT).variables
    assert app.get_css_variables()["muted"] == app.theme_variables["muted"] == light["muted"]
    assert app.get_theme_variable_defaults()["muted"] == themes.theme(themes.DARK).variables["muted"]


def test_a_terminal_without_colours_has_its_own_ones_whatever_is_chosen(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("NO_COLOR", "1")
    app = TerminalApp(Settings(theme="light", plain=False))
    assert app.theme == themes.TERMINAL
    app.apply_settings(Settings(theme="dark", plain=False))
    assert app.theme == themes.TERMINAL
    assert app.ansi_color


@pytest.mark.parametrize(
    ("plain", "mouse", "sent"), [(False, True, []), (False, False, ["off"]), (True, True, ["off"])]
)
def test_settings_change_the_theme_and_the_mouse(
    app: TerminalApp, plain: bool, mouse: bool, sent: list[str]
) -> None:
    app._driver = Mouse(uses_mouse=True)  # type: ignore[assignment]
    app.apply_settings(Settings(theme="contrast", plain=plain, mouse=mouse))
    assert (app.theme, app._driver.sent) == ("donnie-contrast", sent)
    app._driver = None


def test_styles_are_read_again_only_where_the_theme_has_changed(
    app: TerminalApp, monkeypatch: pytest.MonkeyPatch
) -> None:
    read: list[bool] = []
    monkeypatch.setattr(App, "refresh_css", lambda _app, animate: read.append(animate))
    app.refresh_css()
    assert read == []
    app.theme = "donnie-dark"
    read.clear()
    app._read_with = {}
    app.refresh_css(animate=False)
    app.refresh_css()
    assert read == [False]
    assert app._read_with["muted"] == themes.theme(themes.DARK).variables["muted"]


# --- the input


@pytest.mark.parametrize("is_terminal", [True, False])
def test_what_is_typed_from_then_on_is_kept(app: TerminalApp, is_terminal: bool) -> None:
    app._driver = None
    app.keep_input()
    driver = Part(send_message=None, disable_input="own", exit_event=Event(), did=[])
    driver._key_thread = Part(join=lambda: driver.did.append(("read", driver.send_message)))
    driver._disable_mouse_support = lambda: driver.did.append("no mouse")
    if is_terminal:
        driver.attrs_before = []
    app._driver = driver  # type: ignore[assignment]
    app.keep_input()
    driver.send_message("typed")
    assert app._kept_input == ["typed"]
    if is_terminal:
        assert driver.did == ["no mouse", ("read", None)], "what was read before comes first"
        driver.disable_input()
        assert driver.did == ["no mouse", ("read", None)]
    else:
        assert driver.disable_input == "own"
    app._driver = None


async def test_what_was_read_just_before_and_arrives_while_the_screen_closes_is_kept(
    app: TerminalApp,
) -> None:
    key, other = Key("e", "e"), Resize(Size(1, 1), Size(1, 1))
    app._closing = True
    assert not app.post_message(key)
    assert app.messages_not_taken() == []

    app._driver = Part(send_message=None)  # type: ignore[assignment]
    app.keep_input()
    for each in (key, other):
        assert not app.post_message(each)
    app._driver = None
    assert app.messages_not_taken() == [key]


async def test_messages_that_were_not_handled_come_in_their_order_once_nothing_is_read_any_more(
    app: TerminalApp,
) -> None:
    joined: list[Any] = []
    one, two = Key("a", "a"), Key("b", "b")
    app._driver = Part(_key_thread=Part(join=joined.append))  # type: ignore[assignment]
    for each in (one, None):
        app._message_queue.put_nowait(each)
    app._kept_input.append(two)
    assert app.messages_not_taken() == [one, two]
    assert joined == [terminal.LONGEST_READ]
    assert app.messages_not_taken() == [two]
    app._driver = None
    app._kept_input.clear()
    assert app.messages_not_taken() == []


def test_a_driver_without_a_thread_has_nothing_to_wait_for(
    app: TerminalApp, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(type(app), "_message_queue", Part(empty=lambda: True))
    app._driver = Part(_key_thread=None)  # type: ignore[assignment]
    assert app.messages_not_taken() == []
    app._driver = None


# --- the output


class Shown(TerminalApp):
    """An application of a running screen that a test makes up."""

    front: Any = None
    is_up = True

    @property
    def screen(self) -> Any:
        return self.front

    @property
    def is_running(self) -> bool:
        return self.is_up

    @property
    def focused(self) -> Any:
        return self.front.focused


@pytest.fixture
def shown(monkeypatch: pytest.MonkeyPatch) -> Shown:
    monkeypatch.delenv("NO_COLOR", raising=False)
    made = Shown(Settings(plain=False))
    made.front = Part(focused=None, size=Size(80, 24))
    made._driver = Mouse(uses_mouse=False)  # type: ignore[assignment]
    monkeypatch.setattr(made, "refresh", lambda: made._driver.sent.append("refresh"))
    made._painted = Part(forget=lambda: made._driver.sent.append("forget"))  # type: ignore[assignment]
    return made


class Placed:
    cursor_screen_offset: object = Offset(3, 4)


@pytest.mark.parametrize(
    ("focused", "is_up", "place"),
    [
        (Placed(), True, (3, 4)),
        (Placed(), False, (0, 0)),
        (None, True, (0, 0)),
        (Part(cursor_screen_offset="odd"), True, (0, 0)),
    ],
)
def test_the_cursor_of_the_terminal_is_where_the_widget_with_the_focus_says(
    shown: Shown, focused: Any, is_up: bool, place: tuple[int, int]
) -> None:
    shown.front.focused, shown.is_up = focused, is_up
    assert shown.cursor_position == place
    shown.cursor_position = Offset(9, 9)
    assert shown.cursor_position == place


def test_the_cursor_is_shown_when_the_screen_is_ready_and_painted_anew(shown: Shown) -> None:
    shown.on_ready()
    assert shown._driver.sent == ["\x1b[?25h"]
    shown.repaint()
    assert shown._driver.sent[1:] == ["forget", "refresh", "\x1b[?25h"]
    shown._painted = None
    shown.repaint()
    assert shown._driver.sent[4:] == ["refresh", "\x1b[?25h"]
    shown._driver = None
    shown.show_cursor()


@pytest.mark.parametrize("by_rows", [True, False])
@pytest.mark.parametrize(
    ("focused", "is_typing"), [(Input, True), (TextArea, True), (Static, False), (None, False)]
)
def test_output_is_filtered_with_the_place_where_the_learner_types(
    shown: Shown, monkeypatch: pytest.MonkeyPatch, by_rows: bool, focused: Any, is_typing: bool
) -> None:
    asked: list[Any] = []
    monkeypatch.setattr(Shown, "is_read_by_rows", by_rows)
    monkeypatch.setattr(Shown, "cursor_position", Offset(1, 2))
    monkeypatch.setattr(App, "_display", lambda _app, screen, given: asked.append((screen, given)))
    shown._painted = Part(less=lambda *given, **named: asked.append((given, named)) or "less")  # type: ignore[assignment]
    screen = Part(focused=focused and focused())
    shown._display(screen, "all")  # type: ignore[arg-type]
    typing = Offset(1, 2) if is_typing else None
    assert asked == [(("all",), {"rows": by_rows, "typing": typing}), (screen, "less")]
    shown._painted = None
    shown._display(screen, "all")  # type: ignore[arg-type]
    assert asked[2:] == [(screen, "all")]


def test_after_another_program_on_the_terminal_everything_is_painted_anew(
    shown: Shown, monkeypatch: pytest.MonkeyPatch
) -> None:
    @contextmanager
    def suspend(app: Shown):
        app._driver.sent.append("suspended")
        yield
        app._driver.sent.append("resumed")

    monkeypatch.setattr(App, "suspend", suspend)
    with shown.suspend():
        shown._driver.sent.append("less")
    assert shown._driver.sent == ["suspended", "less", "resumed", "forget", "refresh", "\x1b[?25h"]
    shown._set_pointer_shape("text")
    assert len(shown._driver.sent) == 6


SIZE, OTHER = Size(80, 24), Size(100, 30)


@pytest.mark.parametrize(
    ("event", "size", "of_screen", "of_terminal", "posted", "is_repainted"),
    [
        (OTHER, SIZE, SIZE, OTHER, [], False),
        (SIZE, SIZE, SIZE, SIZE, [], True),
        (SIZE, SIZE, OTHER, SIZE, [], True),
        (SIZE, OTHER, SIZE, SIZE, [], True),
        (SIZE, None, SIZE, SIZE, [], False),
        (OTHER, SIZE, SIZE, SIZE, [SIZE], False),
        (SIZE, SIZE, SIZE, None, [], True),
    ],
)
def test_a_size_that_the_terminal_no_longer_has_is_not_used_and_one_that_is_back_is_painted(
    shown: Shown,
    event: Size,
    size: Size | None,
    of_screen: Size,
    of_terminal: Size | None,
    posted: list[Size],
    is_repainted: bool,
) -> None:
    messages: list[Any] = []
    shown.post_message = messages.append  # type: ignore[assignment]
    shown._size, shown.front.size = size, of_screen
    if of_terminal is not None:
        shown._driver._get_terminal_size = lambda: tuple(of_terminal)
    resized = Resize(event, event)
    shown.on_resize(resized)
    assert [(each.size, each.virtual_size) for each in messages] == [(each, each) for each in posted]
    assert shown._driver.sent == ["forget", *(["forget", "refresh", "\x1b[?25h"] if is_repainted else [])]
    assert (resized._no_default_action, resized._stop_propagation) == (bool(posted),) * 2


@pytest.mark.parametrize(
    ("driver", "size"),
    [
        (Part(_get_terminal_size=lambda: (80, 24)), SIZE),
        (Part(_get_terminal_size=lambda: (80, 24), _in_band_window_resize=False), SIZE),
        (Part(_get_terminal_size=lambda: (80, 24), _in_band_window_resize=True), None),
        (None, None),
    ],
)
def test_the_size_of_the_terminal_is_asked_where_it_does_not_report_it(
    driver: object, size: Size | None
) -> None:
    assert terminal._terminal_size(driver) == size


@pytest.mark.parametrize("interval", [1e-9, 0.02, 0.5])
async def test_a_timer_comes_also_if_the_computer_was_busy_when_it_began(
    interval: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The clock moves on by a second at each look, as if the process had to wait that long."""
    app = TerminalApp(Settings())
    async with app.run_test() as pilot:
        came = Event()
        monkeypatch.setattr(timer_module._time, "get_time", count(0.0, 1.0).__next__)
        app.set_timer(interval, came.set)
        for _ in range(20):
            await pilot.pause(0.01)

        assert came.is_set()
