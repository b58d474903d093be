"""The application that is not shown: where its messages, its keys and its commands go, and how it ends."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace as Part
from typing import Any

import pytest
from textual import events
from textual.app import App

from donnie_tui.commands.keys import MENU, PALETTE, KeyTable
from donnie_tui.core.events import Outcome
from donnie_tui.i18n.words import Words
from donnie_tui.settings.settings import Settings
from donnie_tui.tui import app as module
from donnie_tui.tui.app import DonnieApp
from donnie_tui.tui.shutdown import CRASHED
from tests.tui.test_run_view import Recorded


class Unshown(DonnieApp):
    """An application whose screens are those that a test names."""

    front: Any = None

    @property
    def screen(self) -> Any:
        return self.front


class Applied:
    """An application with a session, and what it did."""

    def __init__(
        self, folder: Path, *, has_session: bool = True, settings: Settings | None = None, **given: Any
    ):
        self.done: list[Any] = []
        settings = settings or Settings(speech="off", sound=False, plain=False)
        self.app = app = Unshown(settings, assemble=lambda: None, folder=folder, **given)
        app.front = app.main_screen
        self.runs = Part(is_busy=False)
        parts = {name: Recorded(name, self.done) for name in ("events", "run_view", "assistant")}
        self.display = Recorded("display", self.done, focus_sentence="Map.")
        self.interaction = Part(choose=self._choose)
        self.ctx = Recorded(
            "ctx",
            self.done,
            runs=self.runs,
            attempt=None,
            interaction=self.interaction,
            preferences="preferences",
        )
        team = Part(running=[])
        if has_session:
            app.session.controller = Recorded(
                "controller", self.done, display=self.display, ctx=self.ctx, words=Words("en"), next_world="",
                donnie=Part(session=Part(name="alice"), team=team), **parts,
            )  # fmt: skip
        app._keyboard = Recorded("keyboard", self.done, queue=Part(give_up=list))
        self.choice: str | None = None
        self.asked: list[Any] = []

    async def _choose(self, question: str, options: Any) -> str | None:
        self.asked.append((question, next(each.value for each in options)))
        return self.choice

    def does(self, call: Callable[[], object]) -> list[Any]:
        self.done.clear()
        call()
        return self.done


@pytest.fixture
def apply(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Applied]:
    for name in ("NO_COLOR", "TEXTUAL_DRIVER", "SSH_CONNECTION", "DONNIE_READER"):
        monkeypatch.delenv(name, raising=False)
    return lambda **given: Applied(tmp_path, **given)


# --- messages

HANDLED = [
    ("on_run_began", ["event"], [("run_view on_began", "event")]),
    ("on_events_queued", [], [("events on_queued",)]),
    ("on_run_state_changed", [], [("run_view on_state_changed",)]),
    ("on_editor_line_word_typed", [Part(name="help", argument="FW")], [("controller do", "help", "FW")]),
    ("on_editor_line_finished", [Part(row=3)], [("assistant line_finished", 3)]),
    ("on_editor_gutter_clicked", [Part(line=7)], [("controller do", "break_", "7")]),
    ("on_editor_edited", [], [("assistant edited",)]),
    ("on_editor_looked", [], [("display looked",)]),
    ("on_main_screen_looked", [], [("display looked",)]),
    ("on_main_screen_entered", [], [("controller point", "Map.")]),
    ("on_map_view_explored", [], [("controller on_explored",)]),
    ("on_map_view_edges_changed", [], [("display entitle_map",)]),
    ("on_slider_moved", [Part(step=4)], [("controller look_at", 4)]),
    ("on_command_line_typed", [Part(text="FW 1")], [("controller run_line", "FW 1")]),
    ("on_text_rows_read", [Part(text="row", has_focus=True)], [("controller point", "row")]),
    ("on_text_rows_read", [Part(text="row", has_focus=False)], []),
    ("on_text_rows_read", [Part(text="", has_focus=True)], []),
]


@pytest.mark.parametrize(("name", "given", "done"), HANDLED)
def test_each_message_reaches_the_part_of_the_session_that_it_is_for(apply, name, given, done) -> None:
    it = apply()
    assert it.does(lambda: getattr(it.app, name)(*given)) == done
    without = apply(has_session=False)
    without.app.main_screen.log_lines = lambda _lines: None
    assert without.does(lambda: getattr(without.app, name)(*given)) == []


@pytest.mark.parametrize("has_session", [True, False])
def test_clicks_do_what_their_keys_do(apply, has_session) -> None:
    it = apply(has_session=has_session)
    app, place = it.app, it.app.main_screen
    app.action_command_palette = lambda: it.done.append("palette")
    clicked = {
        app.on_key_line_clicked: [Part(action="run"), Part(action=PALETTE)],
        app.on_pane_title_clicked: [Part(pane=each) for each in place.panes],
        app.action_do: ["save"],
    }
    for call, given in clicked.items():
        for each in given:
            call(each)
    app.on_status_line_clicked()
    assert it.done == [
        ("keyboard act", "run"), "palette", ("keyboard act", "open"), ("keyboard act", "worlds"),
        ("keyboard act", "save"), ("keyboard act", "set"),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("attempt", "outcome", "robot", "done"),
    [
        (None, Outcome.COMPLETED, None, []),
        (Part(has_questions=False), Outcome.COMPLETED, None, []),
        (Part(has_questions=True), Outcome.COMPLETED, None, ["questions"]),
        (None, Outcome.QUIT, None, ["quit"]),
        (None, Outcome.QUIT, "alice", ["quit"]),
        (None, Outcome.QUIT, "bob", []),
        (Part(has_questions=True), Outcome.QUIT, None, ["questions", "quit"]),
    ],
)
def test_after_a_run_come_the_questions_of_its_challenge_and_a_quit_of_the_robot_itself(
    apply, attempt, outcome, robot, done
) -> None:
    it, commands = apply(), []
    it.ctx.attempt = attempt
    it.app.do = lambda name: commands.append(name)
    event = module_event(outcome, robot)
    assert it.does(lambda: it.app.on_run_finished(event)) == [("run_view on_finished", event)]
    assert commands == done
    without = apply(has_session=False)
    without.app.do = commands.append
    without.app.on_run_finished(event)
    assert commands == done


def module_event(outcome: Outcome, robot: str | None) -> Any:
    return Part(asks_to_quit=outcome is Outcome.QUIT, robot=robot)


# --- commands


def test_commands_are_run_by_the_controller_and_none_once_the_screen_leaves(apply) -> None:
    it = apply()
    assert it.does(lambda: it.app.do("help", "FW")) == [("controller do", "help", "FW")]
    assert it.does(lambda: it.app.do("run")) == [("controller do", "run", None)]
    it.app.session.is_leaving = True
    assert it.does(lambda: it.app.do("run")) == []
    assert it.does(lambda: it.app.on_command_line_typed(Part(text="FW 1"))) == []


def test_before_the_session_is_loaded_a_command_says_so_in_the_chosen_language(apply) -> None:
    for language, sentence in (("en", "One moment, Donnie is starting."), ("pt", "Um momento")):
        it, logged = apply(has_session=False, settings=Settings(plain=False, language=language)), []
        it.app.main_screen.log_lines = logged.extend
        it.app.do("run")
        assert [(text.startswith(sentence), kind) for text, kind in logged] == [(True, "")]


def test_quit_from_textual_is_the_command_and_the_menu_opens_on_the_main_screen_only(apply) -> None:
    it = apply()
    assert it.does(lambda: asyncio.run(it.app.action_quit())) == [("controller do", "quit", None)]
    it.app._await = lambda asking: it.done.append("asks") or asking.close()
    for call, done in (
        (it.app.action_key_menu, [("keyboard open_menu", it.app.controller.words)]),
        (it.app.action_command_palette, ["asks"]),
    ):
        it.app.front = it.app.main_screen
        assert it.does(call) == done
        it.app.front = "another"
        assert it.does(call) == []
    without = apply(has_session=False)
    assert without.does(without.app.action_key_menu) == []
    assert without.does(without.app.action_command_palette) == []


@pytest.mark.parametrize(
    ("choice", "done"),
    [
        (None, []),
        ("run", [("controller do", "run"), "rest"]),
        ("> SET volume", [("controller run_line", "SET volume"), "rest"]),
    ],
)
async def test_the_palette_runs_a_command_or_types_a_line_and_waits_for_it(
    apply, monkeypatch, choice, done
) -> None:
    it = apply()
    it.choice = choice

    async def rest() -> None:
        it.done.append("rest")

    for name in ("do", "run_line"):
        call = getattr(it.app.controller, name)
        monkeypatch.setattr(
            it.app.controller, name, lambda given, call=call: call(given) or rest(), raising=False
        )
    monkeypatch.setattr(
        "donnie_tui.tui.pane_text.palette", lambda *given: [Part(value=given)] if len(given) == 3 else []
    )
    await it.app._choose_command(it.app.controller)
    assert it.done == done
    assert it.asked == [
        (it.app.controller.words("palette-ask"), (it.app.controller.words, it.app.key_table, "preferences"))
    ]
    it.app.controller.do = it.app.controller.run_line = lambda _given: None
    await it.app._choose_command(it.app.controller)  # which asks nothing


@pytest.mark.parametrize(
    ("action", "parameters", "runs", "in_front", "allowed"),
    [
        ("do", ("run",), False, False, True),
        ("do", ("run",), False, True, False),
        ("do", ("stop",), False, True, False),
        ("do", ("stop",), True, True, True),
        ("do", ("stop_all", True), True, True, True),
        ("do", ("stop_all", True), True, False, True),
        ("do", ("stop_all", True), False, False, False),
        ("do", ("save",), True, True, False),
        ("key_menu", (), False, False, True),
        ("key_menu", (), False, True, False),
        ("command_palette", (), False, False, True),
        ("command_palette", (), True, True, False),
        ("copy_text", (), False, True, True),
    ],
)
def test_commands_are_for_the_main_screen_and_a_stop_is_for_any(
    apply, action, parameters, runs, in_front, allowed
) -> None:
    it = apply()
    it.runs.is_busy = runs
    it.app.front = "a dialog" if in_front else it.app.main_screen
    assert it.app.check_action(action, parameters) is allowed


async def test_the_rest_of_a_command_runs_in_a_worker_and_then_the_screen_is_updated(apply) -> None:
    it, workers = apply(), []

    async def rest(fails: bool) -> None:
        it.done.append("rest")
        if fails:
            raise LookupError

    it.app._dialogs = Part(begin=lambda: "token", done=lambda token: it.done.append(f"done {token}"))
    it.app.run_worker = lambda worker, exclusive: workers.append(worker) or it.done.append(exclusive)
    it.app._await(None)
    assert workers == []
    it.app._await(rest(False))
    assert it.done == [True]
    it.app._running = True
    await workers.pop()
    assert it.done[1:] == ["rest", "done token", ("display update",)]
    it.app._await(rest(True))
    it.done.clear()
    with pytest.raises(LookupError):
        await workers.pop()
    assert it.done == ["rest", "done token"]
    for is_running, controller in ((False, it.app.controller), (True, None)):
        it.app._await(rest(False))
        it.app._running, it.app.session.controller = is_running, controller
        it.done.clear()
        await workers.pop()
        assert it.done == ["rest", "done token"]
    it.app._running = False


# --- keys


def test_keys_that_were_not_taken_are_typed_again_in_their_order(apply) -> None:
    it = apply()
    waiting = [events.Key("a", "a"), events.Focus(), events.Paste("bc")]
    it.app._keyboard.queue.give_up = lambda: waiting
    it.app.messages_not_taken = lambda: [events.Key("enter", "\r"), None]
    again = it.app.keys_not_taken()
    assert [(each.key, each.character) for each in (again[0], again[2])] == [("a", "a"), ("enter", "\r")]
    assert (len(again), again[1].text) == (3, "bc")
    assert not any(each is other for each in again for other in waiting), "as new ones"


@pytest.mark.parametrize("has_screen", [True, False])
def test_waiting_keys_are_released_unless_the_screen_is_gone(apply, has_screen) -> None:
    it = apply()
    if has_screen:
        it.app._screen_stack.append(it.app.main_screen)
    assert it.does(it.app._release_keys) == [("keyboard release",)] * has_screen


@pytest.mark.parametrize("what", ["startup", "opening", "dialogs", "next_world", None])
def test_keys_wait_for_the_session_a_dialog_and_the_next_world(apply, what) -> None:
    typed = [events.Key("a", "a")]
    it, made = apply(), Unshown(Settings(plain=False), assemble=lambda: None, typed=typed)
    assert made._keyboard.queue.held_text == "a"
    made.session.controller = None if what == "startup" else it.app.controller
    it.app.controller.next_world = "maze" if what == "next_world" else ""
    made.startup.is_opening = what == "opening"
    made._dialogs = Part(holds_keys=what == "dialogs")
    assert made._keyboard._must_wait() is (what is not None)


# --- looks


@pytest.mark.parametrize(("plain", "shown"), [(None, []), (True, [True]), (False, [False])])
def test_settings_change_the_layout_if_one_is_chosen_the_language_and_the_keys(apply, plain, shown) -> None:
    it, set_plain, applied = apply(), [], []
    it.app.main_screen.set_plain = set_plain.append
    it.app._driver = None
    settings = Settings(plain=plain, language="pt", keys="run f9", theme="light")
    it.app.apply_settings(settings)
    assert (set_plain, it.app.theme) == (shown, "donnie-light")
    assert it.app.key_table.of("run")[0] == "f9"
    assert "f9" in it.app._bindings.key_to_bindings
    it.app.main_screen.log_lines = applied.extend
    it.app.session.controller = None
    it.app.do("run")
    assert applied[0][0].startswith("Um momento")


@pytest.mark.parametrize(
    ("plain", "focus", "first_row"),
    [(True, "log", ""), (False, "", module.early("screen-start-words", "en"))],
)
def test_the_main_screen_has_its_layout_its_focus_and_its_first_row(
    apply, monkeypatch, plain, focus, first_row
) -> None:
    monkeypatch.setattr(module, "may_need_linear", lambda: bool(first_row))
    restored = Part(focus=focus) if focus else None
    app = apply(settings=Settings(plain=plain), restored=restored).app
    place = app.main_screen
    assert (place.is_plain, app.is_read_by_rows, place._first_row) == (plain, plain, first_row)
    assert place.first_focus.id == (focus or "editor")
    assert app.get_default_screen() is place


@pytest.mark.parametrize(("driver", "has_linear"), [("page", False), ("", True)])
def test_in_a_browser_no_key_leads_to_the_linear_mode(apply, monkeypatch, driver, has_linear) -> None:
    monkeypatch.setenv("TEXTUAL_DRIVER", driver)
    monkeypatch.setattr(App, "get_driver_class", lambda _: Part(__module__="sys"), raising=False)
    app = apply(settings=Settings(plain=False, keys="linear f9")).app
    assert app.key_table.of("linear") == (("f9", *KeyTable().of("linear")) if has_linear else ())
    assert ("f9" in app._bindings.key_to_bindings) is has_linear
    assert MENU in app._bindings.key_to_bindings


@pytest.mark.parametrize(
    ("has_focus", "is_mounted", "in_front", "focused", "is_set"),
    [
        (True, True, False, None, True),
        (False, True, False, None, False),
        (True, False, False, None, False),
        (True, True, True, None, False),
        (True, True, False, "editor", False),
    ],
)
def test_a_page_that_gets_the_focus_gives_it_to_the_first_widget(
    apply, has_focus, is_mounted, in_front, focused, is_set
) -> None:
    it, set_ = apply(), []
    place = Part(is_mounted=is_mounted, focused=focused, set_focus=set_.append, first_focus="first")
    it.app.main_screen = place
    it.app.front = "another" if in_front else place
    it.app.watch_app_focus(has_focus)
    assert set_ == ["first"] * is_set


@pytest.mark.parametrize(("rendered", "done"), [("a layout", ["nothing held", "a layout"]), (None, [None])])
def test_a_new_layout_is_painted_although_painting_is_held(apply, monkeypatch, rendered, done) -> None:
    it, order = apply(), []
    it.app.main_screen.hold_nothing = lambda: order.append("nothing held")
    monkeypatch.setattr(module.TerminalApp, "_display", lambda _app, _screen, given: order.append(given))
    it.app._display("screen", rendered)
    assert order == done


# --- the beginning and the end


def test_at_the_beginning_signals_are_watched_the_learner_is_greeted_and_the_session_is_loaded(apply) -> None:
    it = apply(restored=Part(focus=""))
    app = it.app
    app.shutdown, app.startup = Recorded("shutdown", it.done), Recorded("startup", it.done, begin="begin")
    app.call_after_refresh = it.done.append
    subscribed: list[Callable[[Any], None]] = []
    app.app_resume_signal = Part(subscribe=lambda _app, call: subscribed.append(call))
    app.show_cursor = lambda: it.done.append("cursor")
    app.on_mount()
    assert it.done == [
        ("shutdown begin",), ("startup greet", app.key_table, app._restored), "begin"
    ]  # fmt: skip
    subscribed[0](app)
    assert it.done[-1] == "cursor"


@pytest.mark.parametrize(
    ("is_headless", "driver", "done"),
    [
        (True, "driver", [("shutdown end_watchdog",)]),
        (True, None, [("shutdown end_watchdog",)]),
        (False, "driver", [("driver write", "\x1b[0m\x1b[H\x1b[2J")]),
        (False, None, []),
    ],
)
def test_what_was_painted_is_erased_for_the_shell_and_without_a_terminal_nothing_is_watched_any_more(
    apply, monkeypatch, is_headless, driver, done
) -> None:
    it = apply()
    monkeypatch.setattr(type(it.app), "is_headless", is_headless)
    it.app.shutdown = Recorded("shutdown", it.done)
    it.app._driver = Recorded("driver", it.done) if driver else None
    assert it.does(it.app.on_unmount) == done
    it.app._driver = None


@pytest.mark.parametrize("is_reported", [False, True])
def test_a_fault_ends_the_screen_with_one_sentence_and_an_exit_code(apply, is_reported) -> None:
    it = apply()
    it.app.shutdown = Recorded("shutdown", it.done)
    it.app._close_messages_no_wait = lambda: it.done.append("closed")
    it.app._exit_renderables[:] = ["reported"] if is_reported else []
    it.app.panic("anything")
    assert it.done == [("shutdown save_from_fault",), "closed"]
    assert it.app._return_code == CRASHED
    (sentence,) = it.app._exit_renderables
    assert str(sentence) == ("reported" if is_reported else module.early("screen-fault", "en"))
