"""The controller without a screen: its start, its commands, what is typed, and how it hands over and ends."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace as Part
from typing import Any

import pytest
from textual import events
from textual.widgets import Input, Static, TextArea

from devices.ports.robot import Pose
from donnie_tui.bootstrap import assemble
from donnie_tui.commands.interaction import drive
from donnie_tui.commands.keys import KeyTable
from donnie_tui.core.events import Pointed
from donnie_tui.core.program_text import LONGEST_CHECKED
from donnie_tui.core.run_state import RunState
from donnie_tui.core.runner import RunRequest
from donnie_tui.core.session_log import AnswerLog, LineHistory
from donnie_tui.settings.settings import Settings
from donnie_tui.tui import controller as module
from donnie_tui.tui.controller import EditorAssistant, ScreenController, ScreenKeyEcho, ScreenState
from donnie_tui.tui.event_queue import CALM, FRAME, EventBatch, EventsQueued, LogLine, RunBegan
from tests.timeouts import TIMEOUT
from tests.tui.test_display import Place
from tests.tui.test_run_view import Recorded, Timers
from tests.unit.commands.scripted import Script


class Editing(Recorded):
    """An editor of a text."""

    def __init__(self, done: list[Any], text: str = "") -> None:
        super().__init__(
            "editor", done, text=text, breakpoints=frozenset(), line=1, line_count=1, mistake=None,
            mistakes=(), has_focus=True, suggestion="offered", is_typed=True, complete=None, next_line=None,
        )  # fmt: skip

    def show(self, text: str, breakpoints: frozenset[int]) -> None:
        self.text, self.breakpoints = text, breakpoints


class Controlled:
    """A controller of a real session, and what it did to the screen."""

    def __init__(self, folder: Path, world: str = "open_floor", text: str = "", **others: Any) -> None:
        self.done: list[Any] = []
        self.donnie = assemble(
            Settings(world=world, speed=None, speech="off", sound=False, **others), terminal=True
        )
        self.script = Script(self.donnie)
        self.ctx = self.script.ctx
        self._donnie, self._runs = self.donnie, self.ctx.runs
        self.ctx.workspace.begin_with(self.donnie.session.name)
        self.folder, self.timers = folder, Timers()
        self.posted: list[Any] = []
        self.app = Recorded(
            "app", self.done, post_message=self.posted.append, set_timer=self.timers.timer("once"),
            set_interval=self.timers.timer("again"),
        )  # fmt: skip
        self.place = Place()
        self.place.editor = Editing(self.done, text)
        self.place.focus_was = "map"
        self.place.log_rows.with_kinds = (("Hello", "says"),)
        self.place.command_line = Part(
            has_focus=False, past=LineHistory(), have_typed=lambda past: self.done.append(("typed", past))
        )
        self.controller = ScreenController(self.app, self.place, KeyTable(), self.ctx)
        self.first_view = self.controller.run_view
        self.first_frame = self.controller.events.frame
        for name in ("display", "run_view", "assistant"):
            setattr(self.controller, name, Recorded(name, self.done))
        self.controller.run_view.polling = Recorded("polling", self.done)
        self.controller.events = Recorded("events", self.done, frame=FRAME)
        if text:
            self.ctx.workspace.replace(text, None, in_file="")
        self.done.clear()

    def said(self) -> list[str]:
        """All lines that were printed so far."""
        self.donnie.session.hub.wait_until_delivered(TIMEOUT)
        return self.script.printed

    def begin(self, **given: Any) -> Any:
        return self.controller.begin(
            **({"file": None, "text": None, "restored": None, "state_folder": str(self.folder)} | given)
        )

    def does(self, call: Callable[[], object]) -> list[Any]:
        self.done.clear()
        call()
        return self.done

    def close(self) -> None:
        """With what the test may have replaced."""
        self.ctx.runs = self._runs
        self.ctx.__dict__.pop("close", None)
        self.script.close()
        self._donnie.close()


@pytest.fixture
def control(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., Controlled]]:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    monkeypatch.delenv("DONNIE_TOUR", raising=False)
    made: list[Controlled] = []

    def one(*given: Any, **others: Any) -> Controlled:
        made.append(Controlled(tmp_path, *given, **others))
        return made[-1]

    yield one
    for each in made:
        each.close()


# --- the start


@pytest.mark.parametrize(("motion", "frame"), [("reduced", CALM), ("full", FRAME)])
@pytest.mark.parametrize("completion", [True, False])
def test_settings_count_from_the_start_and_events_reach_the_screen_until_it_is_left(
    control: Callable[..., Controlled], motion: str, frame: float, completion: bool
) -> None:
    it = control(motion=motion, completion=completion)
    assert it.first_frame == frame
    assert (it.place.editor.complete is not None) is completion
    assert isinstance(it.controller._key_echo, ScreenKeyEcho)
    pointed: list[Any] = []
    unsubscribe = it.donnie.session.hub.subscribe(lambda stamped: pointed.append(stamped.event))
    it.controller.point("here")
    it.said()
    unsubscribe()
    assert (it.posted, pointed) == ([], [Pointed("here")])
    it.ctx.say("Hello.")
    it.said()
    assert [type(each) for each in it.posted] == [EventsQueued]
    assert it.ctx.runs.observer is it.first_view
    it.controller._unsubscribe()
    it.controller._unsubscribe = lambda: None
    it.posted.clear()
    it.ctx.runs.start(RunRequest("FW 1")).wait(TIMEOUT)
    it.said()
    assert [each for each in it.posted if isinstance(each, RunBegan)] == []


TOUR = "TOUR and Enter: a first tour. SET tour off: I don't offer it."


def test_the_start_says_what_was_not_understood_and_offers_the_tour_once(
    control: Callable[..., Controlled],
) -> None:
    odd = "frobnicate ctrl+alt+shift+f9 and some more words than forty letters"
    it = control(keys=f"run f9, {odd}")
    it.ctx.words = it.controller.words = Part(__call__=None)
    said: list[Any] = []
    it.ctx.answer = lambda code, **values: said.append((code, values))
    assert it.begin() is None
    assert said == [("keys-not-understood", {"entry": odd[:39] + "…"}), ("tour-offer", {})]
    assert it.done[-1] == ("display update",)
    said.clear()
    it.begin()
    assert [code for code, _ in said] == ["keys-not-understood"]


@pytest.mark.parametrize(("tour", "offered"), [(True, True), (False, False)])
def test_the_tour_is_offered_unless_it_is_not_wanted_or_there_is_a_program(
    control: Callable[..., Controlled], tmp_path: Path, tour: bool, offered: bool
) -> None:
    it = control(tour=tour)
    codes: list[str] = []
    it.ctx.answer = lambda code, **_values: codes.append(code)
    for given in ({"text": "FW 1"}, {"file": tmp_path / "walk.gd"}):
        it.begin(**given).close()
    assert codes == []
    it.begin()
    assert codes == ["tour-offer"] * offered


def test_the_text_of_the_other_mode_is_in_the_editor_unsaved(
    control: Callable[..., Controlled], tmp_path: Path
) -> None:
    it = control()
    file = tmp_path / "walk.gd"
    file.write_text("FW 1\n")
    drive(it.begin(text="FW 2\n", file=file))
    document = it.ctx.workspace.document
    assert (it.place.editor.text, document.path, document.is_saved) == ("FW 2", file, False)


def test_a_file_is_opened_by_its_name(control: Callable[..., Controlled], tmp_path: Path) -> None:
    it = control()
    file = tmp_path / "walk.gd"
    file.write_text("FW 1\n")
    drive(it.begin(file=file))
    assert (it.place.editor.text, it.ctx.workspace.document.is_saved) == ("FW 1", True)
    assert any("walk.gd" in each for each in it.said())


@pytest.mark.parametrize("rescued", [[Path("x")], []])
@pytest.mark.parametrize("is_restored", [True, False])
def test_what_was_rescued_is_said_but_not_in_another_world_of_the_same_session(
    control: Callable[..., Controlled],
    monkeypatch: pytest.MonkeyPatch,
    rescued: list[Path],
    is_restored: bool,
) -> None:
    it = control(tour=False)
    codes, said = list[str](), list[str]()
    monkeypatch.setattr(type(it.ctx.workspace), "rescued", lambda _: rescued)
    it.ctx.answer, it.ctx.say = lambda code, **_values: codes.append(code), lambda *lines: said.extend(lines)
    it.donnie = it.controller.donnie = Part(notices=Part(all=("all",), about_devices=("devices",)))
    restored = Part() if is_restored else None
    it.controller._restore = lambda state: it.done.append(state)
    it.begin(restored=restored)
    assert (codes, said) == (
        ["answer-rescued"] if rescued and not is_restored else [], ["devices" if is_restored else "all"]
    )  # fmt: skip
    assert it.done == [*([restored] if is_restored else []), ("display update",)]


def test_another_world_continues_with_the_answers_and_the_typed_lines(
    control: Callable[..., Controlled], monkeypatch: pytest.MonkeyPatch
) -> None:
    it, answers, typed = control(tour=False), AnswerLog(), LineHistory()
    arrived: list[Any] = []
    monkeypatch.setattr(module, "arrive", lambda ctx, *, is_silent: arrived.append((ctx, is_silent)))
    answers.add_line("Hello.")
    it.ctx.runs.watched.append("m")
    state = ScreenState((), {}, answers, typed, it.ctx.workspace, ("n",), "map", is_silent=True)
    it.begin(restored=state)
    assert it.controller.answers is it.ctx.answers is answers
    assert not answers.has_begun, "the next line begins another answer"
    assert (it.ctx.past, it.ctx.runs.watched, arrived) == (typed, ["m", "n"], [(it.ctx, True)])
    assert it.done == [("typed", typed), ("display update",)]

    kept = it.controller.state
    assert (kept.log, kept.looks, kept.watched, kept.focus) == ((("Hello", "says"),), {}, ("m", "n"), "map")
    assert (kept.answers, kept.workspace, kept.typed) == (
        answers,
        it.ctx.workspace,
        it.place.command_line.past,
    )
    assert kept.is_silent is not it.donnie.outlets.audible.is_on


def test_copies_that_can_not_be_written_are_reported(control: Callable[..., Controlled]) -> None:
    it = control()
    it.ctx.workspace.report_failure(Part(reason="the disk is full"))
    assert any("the disk is full" in each for each in it.said())


# --- commands


@pytest.mark.parametrize(
    ("name", "finishes"), [("where", True), ("undo", False), ("redo", False), ("fix", True)]
)
def test_a_command_ends_the_answer_before_it_and_shows_what_has_changed(
    control: Callable[..., Controlled], monkeypatch: pytest.MonkeyPatch, name: str, finishes: bool
) -> None:
    it = control()
    performed: list[Any] = []

    async def perform(_ctx: Any, command: Any, argument: str | None) -> None:
        performed.append((command.name, argument, it.controller.answers.has_begun))

    monkeypatch.setattr(module, "perform", perform)
    it.controller.answers.add_line("Hello.")
    shown = [("run_view show_past",), ("display update",)]
    finished = [("editor finish_typed_end",)] if finishes else []
    assert it.does(lambda: it.controller.do(name, "x")) == [("events flush",), *finished, *shown]
    assert (performed, it.place.editor.suggestion) == ([(name, "x", False)], "")
    it.controller.do(name)
    assert performed[1][1] is None


@pytest.mark.parametrize(
    ("sentences", "step", "said"),
    [
        (("One step.",), 2, ["One step."]),
        ((), 0, ["Nothing is left to undo."]),
        ((), 2, []),
        (("x",), 0, ["x"]),
    ],
)
def test_the_slider_says_where_it_came_to(
    control: Callable[..., Controlled], sentences: tuple[str, ...], step: int, said: list[str]
) -> None:
    it = control()
    it.ctx.runs = Part(look_at=lambda at: sentences if at == step else None)
    lines: list[str] = []
    it.ctx.say, it.ctx.answer_once = lambda *given: lines.extend(given), lambda code: lines.append(code)
    shown = it.does(lambda: it.controller.look_at(step))
    assert lines == ["undone-start" if each.startswith("Nothing") else each for each in said]
    assert shown == [("events flush",), ("run_view show_past",), ("display update",)]


@pytest.mark.parametrize(
    ("typed", "ran", "said", "updates"),
    [
        ("FW 1", True, "", True),
        ("WHERE", False, "0, 0", True),
        ("OUTLNE", False, "OUTLINE", False),
        ("REPEAT 2 TIMES FW 1", False, "END REPEAT", False),
        ("FW", True, "", True),
    ],
)
def test_a_typed_line_is_a_command_of_the_screen_or_one_of_godonnie(
    control: Callable[..., Controlled], typed: str, ran: bool, said: str, updates: bool
) -> None:
    it, started = control(), list[Any]()
    it.ctx.runs.start = lambda request: started.append((request.text, request.is_whole, bool(request.name)))
    it.controller.run_line(typed)
    assert started == ([(typed, False, True)] if ran else [])
    assert it.done[:2] == [("events flush",), ("display write", [(f"> {typed}", "typed")])]
    assert (("display update",) in it.done) is updates
    assert not said or any(said in each for each in it.said())


def test_a_line_that_comes_while_a_program_runs_is_refused(control: Callable[..., Controlled]) -> None:
    it = control()

    def busy(_request: object) -> None:
        raise module.Busy("alice")

    it.ctx.runs.start = busy
    it.controller.run_line("FW 1")
    assert len(it.said()) == 1
    assert it.done[-1] == ("display update",)


def test_a_key_ends_the_speech_and_is_spoken(control: Callable[..., Controlled]) -> None:
    it, echoed = control(), list[Any]()
    hushed = it.donnie.outlets.audible.hushed
    it.controller._key_echo = lambda event, focused: echoed.append((event, focused))
    assert it.does(lambda: it.controller.key_pressed("event", "focused")) == [("display acted",)]
    assert (echoed, it.donnie.outlets.audible.hushed) == ([("event", "focused")], hushed + 1)


@pytest.mark.parametrize(
    ("batch", "asks"),
    [
        ({}, False),
        ({"others": {"bob": Pose(0, 0, 0)}}, True),
        ({"things": ()}, True),
        ({"poses": deque([Pose(0, 0, 0)])}, False),
    ],
)
def test_distances_are_asked_for_again_where_others_or_things_have_moved(
    control: Callable[..., Controlled], batch: dict[str, Any], asks: bool
) -> None:
    it, given = control(), EventBatch(**batch)
    assert it.does(lambda: it.controller._receive(given)) == [
        ("display receive", given), ("polling on_event",), *([("display ask_distances",)] if asks else [])
    ]  # fmt: skip


def test_lines_are_written_and_kept_to_be_repeated_unless_they_were(
    control: Callable[..., Controlled],
) -> None:
    it = control()
    written: list[Any] = []
    it.controller.display.write = lambda lines: written.extend(lines)
    it.controller._write([LogLine("One.", "says"), LogLine("Two.", "answer", is_repeated=True)])
    assert written == [("One.", "says"), ("Two.", "answer")]
    assert it.ctx.answers.last() == ("One.",)


@pytest.mark.parametrize(("cell", "said"), [((1, 2), ["here"]), (None, []), ("no map", [])])
def test_the_explored_square_is_spoken(
    control: Callable[..., Controlled], cell: object, said: list[str]
) -> None:
    it, pointed = control(), list[str]()
    it.place.map.pointer = None if cell == "no map" else Part(cell=cell, words=lambda _words: "here")
    it.controller.point = pointed.append
    assert it.does(it.controller.on_explored) == [("display looked",)]
    assert pointed == said


APPLIED = {
    "lang": [("display relabel",), ("assistant check_now",)],
    "completion": [("assistant offer_words", ("wanted", True))],
    "motion": [],
    "trail": [("display show_marks_of_map",)],
    "rays": [("display show_marks_of_map",)],
    "goals": [("display show_marks_of_map",)],
    "volume": [],
}


@pytest.mark.parametrize("key", APPLIED)
def test_a_setting_is_applied_to_what_shows_it(control: Callable[..., Controlled], key: str) -> None:
    it = control(motion="reduced")
    settings = it.ctx.preferences.settings
    assert it.does(lambda: it.controller.apply_setting(key)) == [
        *APPLIED[key], ("app apply_settings", settings), ("display update",)
    ]  # fmt: skip
    assert it.controller.events.frame == (CALM if key == "motion" else FRAME)


# --- the end


def test_the_screen_is_left_for_the_linear_mode_for_another_world_or_for_good(
    control: Callable[..., Controlled], monkeypatch: pytest.MonkeyPatch
) -> None:
    it = control()
    for name in ("hand_over", "leave_copies"):
        monkeypatch.setattr(type(it.ctx.workspace), name, lambda _, name=name: it.done.append(name))
    assert not it.controller.left_for_linear
    stopped, left = ("assistant stop_copying",), ("app exit", 0)
    assert it.does(it.controller.leave) == [stopped, "leave_copies", left]
    assert not it.controller.left_for_linear
    assert it.does(it.controller.switch_to_linear) == [stopped, "hand_over", left]
    assert (it.controller.left_for_linear, it.controller.next_world) == (True, "")
    it.ctx.runs = Recorded("runs", it.done)
    it.ctx.answer_entering = lambda name: it.done.append(name)
    assert it.does(lambda: it.controller.change_world("maze")) == [
        ("runs stop_to_leave",), "maze", ("events flush",), stopped, ("app keep_input",), left
    ]  # fmt: skip
    assert it.controller.next_world == "maze"


def test_the_session_goes_on_in_the_other_mode_once_its_programs_have_ended(
    control: Callable[..., Controlled], monkeypatch: pytest.MonkeyPatch
) -> None:
    it = control()
    monkeypatch.setattr(type(it.ctx.workspace), "write_copies", lambda _: it.done.append("copies"))
    waited: list[float] = []
    sessions = [Part(run=None), Part(run=Part(wait=waited.append))]
    team = Part(stop=lambda: it.done.append("stop"), sessions=sessions)
    it.controller.donnie = Part(team=team)
    it.ctx.close = lambda: it.done.append("ctx closed")
    it.controller._unsubscribe = lambda: it.done.append("unsubscribed")
    assert it.does(it.controller.hand_over) == ["ctx closed", "unsubscribed", "stop", "copies"]
    assert waited == [module.LAST_WORDS]
    assert it.controller.hand_over() is it.controller.donnie


def test_at_the_end_the_text_is_taken_from_the_editor_and_copied(
    control: Callable[..., Controlled], monkeypatch: pytest.MonkeyPatch
) -> None:
    it = control(text="FW 1")
    document = it.ctx.workspace.document
    monkeypatch.setattr(
        type(it.ctx.workspace), "write_copies", lambda _: it.done.append(document.is_in_editor)
    )
    it.controller.donnie = Part(close=lambda: it.done.append("closed"))
    assert it.does(it.controller.close) == ["closed", False]


# --- spoken keys


class Echo:
    def __init__(self) -> None:
        self.said: list[Any] = []
        self.kind = "characters"

    def __getattr__(self, name: str) -> Callable[..., None]:
        return lambda *given: self.said.append((name, *given))


@pytest.mark.parametrize(
    ("event", "said"),
    [
        (events.Paste("xyz"), [("typed", "xyz", "FW")]),
        (events.Key("backspace", "\x7f"), [("deleted", "FW")]),
        (events.Key("enter", "\r"), [("ended", "FW")]),
        (events.Key("a", "a"), [("typed", "a", "FW")]),
        (events.Key("space", " "), [("typed", " ", "FW")]),
        (events.Key("left", None), []),
        (events.Key("ctrl+a", "\x01"), []),
        (events.Focus(), []),
    ],
    ids=str,
)
def test_a_typed_key_is_spoken_with_the_text_before_the_cursor(
    monkeypatch: pytest.MonkeyPatch, event: events.Event, said: list[Any]
) -> None:
    echo = ScreenKeyEcho(None, None)  # type: ignore[arg-type]
    echo._echo = Echo()  # type: ignore[assignment]
    monkeypatch.setattr(module, "_before_cursor", lambda widget: "FW" if widget else None)
    echo(event, "widget")  # type: ignore[arg-type]
    assert echo._echo.said == said
    echo(event, None)
    echo._echo.kind = "none"
    echo(event, "widget")  # type: ignore[arg-type]
    assert echo._echo.said == said


def test_the_text_before_the_cursor_is_that_of_its_line_in_a_program_or_an_input_line() -> None:
    area, line = TextArea("FW 1\nBW 23"), Input()
    area.move_cursor((1, 4))
    line.__dict__.update(_reactive_value="abc")
    monkeyed = type("Line", (Input,), {"value": "abc", "cursor_position": 2})
    assert module._before_cursor(area) == "BW 2"
    assert module._before_cursor(monkeyed()) == "ab"
    assert module._before_cursor(Static()) is None
    assert module._before_cursor(None) is None


# --- help while typing


class Helped:
    """The help for a program that is typed."""

    def __init__(self, text: str = "FW 1", **of_runs: Any) -> None:
        self.done: list[Any] = []
        self.timers = Timers()
        self.editor = Editing(self.done, text)
        runs = {"is_whole": True, "state": RunState.RUNNING} | of_runs
        self.checked: list[str] = []
        self.session = Part(run=Part(), check=lambda text: self.checked.append(text) or (), colours=("red",))
        self.audible = Part(has_cues=True)
        self.donnie = Part(session=self.session, outlets=Part(audible=self.audible))
        self.ctx = Recorded(
            "ctx", self.done, runs=Part(**runs), donnie=self.donnie, words=Part(language="en"),
            workspace=Recorded("workspace", self.done),
        )  # fmt: skip
        self.assistant = EditorAssistant(
            Part(set_timer=self.timers.timer("once")), self.ctx, Recorded("display", self.done), self.editor
        )

    def does(self, call: Callable[[], object]) -> list[Any]:
        self.done.clear()
        call()
        return self.done


def test_a_changed_text_is_checked_a_moment_after_the_last_letter_and_copied_soon_after_the_first() -> None:
    it = Helped(is_whole=False)
    assistant = it.assistant
    for _ in range(3):
        assert it.does(assistant.edited) == [("display show_titles",)]
        waiting = [(seconds, call) for _, seconds, call in it.timers.set]
        assert sorted(each for each, _ in waiting) == [module.CHECK_AFTER, module.COPY_AFTER]
    check = next(call for seconds, call in waiting if seconds == module.CHECK_AFTER)
    copy = next(call for seconds, call in waiting if seconds == module.COPY_AFTER)
    shown = [("editor note", {}), ("display show_titles",), ("display say_status",)]
    assert it.does(check) == shown
    assert it.does(copy) == [("workspace keep_copies",)]
    it.timers.set.clear()
    assistant.edited()
    assert len(it.timers.set) == 2
    assistant.stop_copying()
    assert [seconds for _, seconds, _ in it.timers.set] == [module.CHECK_AFTER]
    Helped().assistant.stop_copying()


@pytest.mark.parametrize(
    ("text", "is_checked"),
    [
        ("FW 1", True),
        ("", False),
        (" \n", False),
        ("x" * LONGEST_CHECKED, True),
        ("x" * (LONGEST_CHECKED + 1), False),
    ],
    ids=["program", "empty", "blank", "longest", "longer"],
)
def test_a_text_is_checked_unless_it_is_empty_or_very_long(text: str, is_checked: bool) -> None:
    it = Helped(text)
    it.assistant.check_now()
    assert it.checked == ([text] if is_checked else [])
    assert it.done == [("editor note", {}), ("display show_titles",), ("display say_status",)]


@pytest.mark.parametrize(
    ("of_runs", "is_typed", "times"),
    [
        ({}, True, 1),
        ({"state": RunState.PAUSED}, True, 1),
        ({"state": RunState.READY}, True, 0),
        ({"state": RunState.STOPPING}, True, 0),
        ({"is_whole": False}, True, 0),
        ({}, False, 0),
    ],
)
def test_a_change_of_a_running_program_is_reported_once_in_each_run(
    of_runs: dict[str, Any], is_typed: bool, times: int
) -> None:
    it = Helped(**of_runs)
    it.editor.is_typed = is_typed
    reported = ("ctx answer", "edited-while-running")
    for _ in range(2):
        it.assistant.edited()
    assert it.done.count(reported) == times
    it.session.run = Part(another=True)
    it.assistant.edited()
    assert it.done.count(reported) == 2 * times


def test_words_and_block_ends_are_offered_as_long_as_they_are_wanted() -> None:
    it = Helped()
    it.assistant.offer_words(wanted=True)
    lines = ["REPEAT 2 TIMES"]
    assert it.editor.next_line(lines, 0) == module.next_line(lines, 0, "en")
    assert it.editor.next_line(lines, 0).end == "END REPEAT"
    assert "REPEAT" in it.editor.complete("REP", 3).words
    assert it.editor.complete("COLOR r", 7) == module.completion("COLOR r", 7, "en", ("red",))
    it.assistant.offer_words(wanted=False)
    assert (it.editor.complete, it.editor.next_line) == (None, None)


@pytest.mark.parametrize(
    ("row", "has_cues", "extra", "depths"),
    [
        (0, True, 0, (0, 1)),
        (1, True, 0, (1, 1)),
        (2, True, 0, (1, 0)),
        (0, False, 0, None),
        (0, True, 1, None),
    ],
)
def test_a_finished_line_that_opens_or_closes_a_block_has_a_cue(
    monkeypatch: pytest.MonkeyPatch, row: int, has_cues: bool, extra: int, depths: tuple[int, int] | None
) -> None:
    """But not in a very long program."""
    text = "REPEAT 2 TIMES\nFW 1\nEND REPEAT\n"
    it, chimed = Helped(text + "-" * extra * (LONGEST_CHECKED - len(text) + 1)), list[Any]()
    monkeypatch.setattr(module, "chime_block", lambda _donnie, *given: chimed.append(given))
    it.audible.has_cues = has_cues
    it.assistant.line_finished(row)
    assert chimed == ([] if depths is None else [depths])
