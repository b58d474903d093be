"""What the first frame shows, and what is not computed twice before it."""

import signal
from pathlib import Path

import pytest
from textual import events
from textual.css.stylesheet import Stylesheet
from textual.design import ColorSystem
from textual.pilot import Pilot
from textual.widget import Widget

from donnie_tui.bootstrap import assemble
from donnie_tui.i18n.first_words import early
from donnie_tui.settings.settings import Settings
from donnie_tui.tui import themes
from donnie_tui.tui.app import DonnieApp
from donnie_tui.tui.widgets.rows import TextRows
from tests.timeouts import TIMEOUT


@pytest.fixture(params=[False, True], ids=["panes", "plain"])
def app(request: pytest.FixtureRequest, tmp_path: Path) -> DonnieApp:
    settings = Settings(speech="off", sound=False, plain=request.param, tour=False)
    return DonnieApp(settings, assemble=lambda: assemble(settings, terminal=True), folder=tmp_path)


async def begin(app: DonnieApp) -> None:
    try:
        async with app.run_test(size=(80, 24)) as pilot:
            await until_work(app, pilot)
    finally:
        app.session.close()


async def until_work(app: DonnieApp, pilot: Pilot[int]) -> None:
    for _ in range(100 * TIMEOUT):
        if app.controller is not None:
            return
        await pilot.pause(0.01)
    raise AssertionError("the work never began")


async def test_the_first_frame_has_the_greeting(app: DonnieApp, monkeypatch: pytest.MonkeyPatch) -> None:
    """It was painted empty: lines printed before the width was known were cut into letters."""
    painted: list[list[str]] = []
    render_lines = TextRows.render_lines

    def rendered(self, crop):
        strips = render_lines(self, crop)
        if self is app.main_screen.log_rows:
            painted.append([strip.text.strip(" >") for strip in strips])
        return strips

    monkeypatch.setattr(TextRows, "render_lines", rendered)

    await begin(app)

    assert painted[0][0] == early("screen-start", "en")


async def test_only_what_takes_the_focus_gets_its_style_twice_before_the_session(
    app: DonnieApp, monkeypatch: pytest.MonkeyPatch
) -> None:
    styled: list[str] = []
    update_nodes = Stylesheet.update_nodes

    def updated(self, nodes, animate=False):
        if app.controller is None:
            styled.extend(node.id or "" for node in nodes if isinstance(node, Widget))
        update_nodes(self, nodes, animate=animate)

    monkeypatch.setattr(Stylesheet, "update_nodes", updated)

    await begin(app)

    assert not {"main-screen", "map-pane", "inspector-pane", "log-pane"} & {*styled}
    assert app.main_screen.is_plain or "program-pane" not in styled


async def test_the_colours_of_a_theme_are_worked_out_once(
    app: DonnieApp, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Textual asks for them whenever it reads or compares a style sheet."""
    worked_out: list[ColorSystem] = []
    generate = ColorSystem.generate
    monkeypatch.setattr(ColorSystem, "generate", lambda it: worked_out.append(it) or generate(it))
    try:
        async with app.run_test(size=(80, 24)) as pilot:
            await until_work(app, pilot)
            for name in (*themes.NAMES, *themes.NAMES):
                app.theme = name
                await pilot.pause()
                assert app.theme_variables["muted"] == themes.theme(name).variables["muted"]
    finally:
        app.session.close()

    assert len(worked_out) == len(themes.NAMES) - 1  # the one of the start was there already


async def test_what_widgets_paint_row_by_row_has_no_styles_of_its_own(app: DonnieApp) -> None:
    """Each was worked out for each widget, before the first frame and whenever the focus came or went."""
    try:
        async with app.run_test(size=(80, 24)) as pilot:
            await until_work(app, pilot)
            main_screen = app.main_screen
            of_textual = {"input", "text-area", "screen"}
            for widget in (
                main_screen,
                main_screen.editor,
                main_screen.map,
                main_screen.inspector,
                main_screen.log_rows,
                main_screen.command_line,
            ):
                assert {name.partition("--")[0] for name in widget._component_styles} <= of_textual
    finally:
        app.session.close()


# --- what is typed between the first frame and the session


async def test_what_is_typed_before_the_session_is_taken_by_it(app: DonnieApp) -> None:
    begin_now, app.startup.begin = app.startup.begin, lambda: None  # type: ignore[method-assign]
    try:
        async with app.run_test(size=(80, 24)) as pilot:
            await type_early(app, pilot)
            begin_now()
            await until_work(app, pilot)
            place = app.main_screen

            def taken() -> str:  # in the plain layout the keys are for the command line
                return "\n".join(place.command_line.past.lines[:1]) if place.is_plain else place.editor.text

            expected = "FW 3" if place.is_plain else EARLY_TEXT
            for _ in range(100 * TIMEOUT):
                if taken() == expected:
                    break
                await pilot.pause(0.01)
            assert taken() == expected
    finally:
        app.session.close()


async def test_a_signal_before_the_session_keeps_what_was_typed(app: DonnieApp, tmp_path: Path) -> None:
    app.startup.begin = lambda: None  # type: ignore[method-assign]
    async with app.run_test(size=(80, 24)) as pilot:
        await type_early(app, pilot)
        app.shutdown.leave(signal.SIGTERM)

    assert [each.read_text() for each in tmp_path.rglob("unsaved-*.gd")] == [f"{EARLY_TEXT}\n"]


EARLY_TEXT = "FW 3\nBW 1\nTR 90"


async def type_early(app: DonnieApp, pilot: Pilot[int]) -> None:
    """With a slip that is taken back, and a pasted line."""
    await pilot.pause()
    for key in (*"FX", "backspace", "W", "space", "3", "enter"):
        app.post_message(events.Key(key, {"space": " ", "enter": "\r", "backspace": "\x7f"}.get(key, key)))
    app.post_message(events.Paste("BW 1\nTR 90"))
    await pilot.pause()
