"""What commands ask and show on the screen: the dialog of each question, its answer, what comes of it."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace as Part
from typing import Any

import pytest
from textual._context import active_app
from textual.app import App, SuspendNotSupported
from textual.screen import Screen

from donnie_tui.commands.interaction import Option, begin
from donnie_tui.commands.keys import KeyTable
from donnie_tui.core.completion import Completion
from donnie_tui.core.runner import RunRequest
from donnie_tui.i18n.words import Words
from donnie_tui.tui import interaction, run_view
from donnie_tui.tui.interaction import ScreenInteraction
from donnie_tui.tui.screens.dialogs import Chooser, Completions, Question
from donnie_tui.tui.screens.file_panel import FilePanel
from donnie_tui.tui.screens.pages import Help, KeyCapture, Tour, TourStrip
from donnie_tui.tui.widgets.command_line import CommandLine
from tests.tui.test_run_view import Recorded, Timers

WORDS = Words("en")


class Asking:
    """The interaction of a screen, what it did, and the answers that dialogs get."""

    def __init__(self, *answers: Any, is_plain: bool = False, is_small: bool = False) -> None:
        self.done: list[Any] = []
        self.answers = list(answers)
        self.dialogs: list[Any] = []
        """Dialogs that were asked, and pages that were opened."""
        self.posted: list[Any] = []
        self.spoken: list[str] = []
        self.timers = Timers()
        self.app = Part(
            post_message=self.posted.append,
            set_timer=self.timers.timer("once"),
            set_interval=self.timers.timer("again"),
            suspend=self._suspend,
            repaint=lambda: self.done.append("repaint"),
        )
        self.place = Recorded(
            "place", self.done, is_plain=is_plain, is_small=is_small, tour=None,
            program_pane="the program's", map_pane="the map's", log_pane="the log's",
            editor=Recorded("editor", self.done, has_focus=True, word="", mistakes=()),
            map=Recorded("map", self.done, has_focus=False),
            **{name: Part(has_focus=False) for name in ("inspector", "log_rows", "command_line")},
        )  # fmt: skip
        self.ctx = Recorded("ctx", self.done)
        self.controller = Recorded(
            "controller", self.done, ctx=self.ctx, display=Recorded("display", self.done),
            point=self.spoken.append,
        )  # fmt: skip
        self.screen = ScreenInteraction(
            self.app, Part(answer_of=self._answer, open=self.dialogs.append, checking=None), self.place,
            KeyTable(), WORDS,
        )  # fmt: skip
        self.screen._controller = self.controller

    async def _answer(self, dialog: Any) -> Any:
        self.dialogs.append(dialog)
        return self.answers.pop(0)

    @contextmanager
    def _suspend(self) -> Iterator[None]:
        self.done.append("suspended")
        yield
        self.done.append("resumed")

    @property
    def asked(self) -> Any:
        return self.dialogs[-1]


@pytest.fixture(autouse=True)
def active() -> Iterator[None]:
    """Widgets with a value ask for the application and its screen when they are made."""
    app = App[None]()
    app._screen_stack.append(Screen[None]())
    token = active_app.set(app)
    yield
    active_app.reset(token)


# --- questions


@pytest.mark.parametrize(("given", "answer"), [("FW 1", "FW 1"), ("", None), (None, None)])
@pytest.mark.parametrize("name", ["ask", "edit_line"])
async def test_a_question_has_its_text_and_an_empty_answer_is_none(name, given, answer):
    it = Asking(given)
    assert await getattr(it.screen, name)("Which line?", "FW 2") == answer
    question = it.asked
    assert type(question) is Question
    assert (question._asked, question._value, question._list) == ("Which line?", "FW 2", None)
    assert question._keys == "Enter answers, Esc goes back"
    question._point("said")
    assert it.spoken == ["said"]


async def test_a_question_says_what_is_wrong_with_an_answer():
    it = Asking("x")
    assert await it.screen.ask("Which line?", accepts=lambda typed: f"Not {typed}.") == "x"
    assert (it.asked._value, it.asked._accepts("x")) == ("", "Not x.")


@pytest.mark.parametrize(
    ("given", "answer"), [("yes", True), ("Y", True), ("no", False), ("", False), (None, None)]
)
@pytest.mark.parametrize("is_plain", [False, True])
async def test_yes_or_no_are_listed_but_not_in_one_column(given, answer, is_plain):
    it = Asking(given, is_plain=is_plain)
    assert await it.screen.confirm("Really?") is answer
    listed = [] if it.asked._list is None else [*it.asked._list._answers]
    assert listed == ([] if is_plain else ["yes", "no"])
    assert it.asked._keys.startswith("Enter answers, Esc") is is_plain
    wrong = [it.asked._accepts(typed) for typed in ("maybe", "yes", "n", " ", "")]
    assert wrong == [f"{WORDS('yes-or-no')} Really?", None, None, None, None]


@pytest.mark.parametrize("is_new", [False, True])
async def test_a_program_is_chosen_in_a_panel_and_in_one_column_typed(is_new):
    it = Asking(Path("a.gd"), "", "typed.gd")
    recent = lambda: [Path("b.gd")]  # noqa: E731
    assert await it.screen.ask_file("Which?", "old.gd", recent, is_new=is_new) == Path("a.gd")
    panel = it.asked
    assert type(panel) is FilePanel
    assert (panel._asked, panel._text, panel._find_recent, panel._is_new) == (
        "Which?", "old.gd", recent, is_new,
    )  # fmt: skip
    assert await it.screen.ask_file("Which?", "", recent) is None
    assert not it.asked._is_new
    it.place.is_plain = True
    assert await it.screen.ask_file("Which?", "old.gd", recent) == "typed.gd"
    assert (type(it.asked), it.asked._value) == (Question, "old.gd")


@pytest.mark.parametrize("is_plain", [False, True])
async def test_a_list_has_one_row_for_options_of_the_same_text(is_plain):
    it = Asking("b", is_plain=is_plain)
    options = [Option("a", "same"), Option("b", "other"), Option("c", "same"), Option("d", "last")]
    assert await it.screen.choose("Which?", options) == "b"
    chooser = it.asked
    assert type(chooser) is Chooser
    assert [each.value for each in chooser._choices] == ["a", "b", "d"]
    assert (chooser._title_words, chooser._nothing) == ("Which?", "Nothing has that name.")
    assert chooser._keys._all == WORDS("chooser-keys")
    assert chooser.has_class("-plain") is is_plain


async def test_a_key_is_asked_for_with_what_is_wrong_with_it():
    it = Asking("f9")
    assert await it.screen.press_key("Which key?", lambda key: f"Not {key}.") == "f9"
    capture = it.asked
    assert (type(capture), capture._asked, capture._accepts("x")) == (KeyCapture, "Which key?", "Not x.")
    assert (capture._key_words, capture._asked_after_menu) == (
        WORDS("keys-capture"), WORDS("keys-second-key")
    )  # fmt: skip


@pytest.mark.parametrize(
    ("name", "given"),
    [
        ("ask", ("Which?",)),
        ("edit_line", ("Which?",)),
        ("confirm", ("Really?",)),
        ("ask_file", ("Which?", "", list)),
        ("choose", ("Which?", [Option("a", "a")])),
        ("press_key", ("Which?", str)),
        ("background", (lambda: 1, "It takes a while.")),
        ("finish", (asyncio.sleep,)),
        ("complete", ()),
        ("type_again", ("OPEN",)),
        ("wait", (0,)),
    ],
)
async def test_a_command_runs_at_once_up_to_what_it_waits_for_and_the_rest_of_it_in_a_worker(
    monkeypatch, name, given
):
    it, waited = Asking("yes"), []
    completing(it, "REP", Completion("REP", ("REPEAT",), ("REPEAT",)))

    async def ask(*what: object) -> None:
        waited.append(what)

    monkeypatch.setattr(it.screen._dialogs, "answer_of", ask)
    monkeypatch.setattr(asyncio, "to_thread", ask)
    it.controller.run_line = ask
    sleep = asyncio.sleep
    if name == "finish":
        given = (ask("finish"),)
    elif name == "wait":
        monkeypatch.setattr(asyncio, "sleep", lambda seconds: waited.append(seconds) or sleep(seconds))
    rest = begin(getattr(it.screen, name)(*given))
    assert (rest is not None, waited) == (True, [0] if name == "wait" else [])
    await rest
    assert len(waited) == (2 if name == "wait" else 1)


# --- time


@pytest.fixture(autouse=True)
def slow(monkeypatch):
    monkeypatch.setattr(run_view, "SLOW", 1.0)
    monkeypatch.setattr(run_view, "SLOW_AGAIN", 10.0)


@pytest.mark.parametrize("is_slow", [False, True])
async def test_a_task_in_the_background_is_reported_until_it_is_done_unless_it_is_known_to_be_slow(is_slow):
    it, timers = Asking(), []

    def task() -> int:
        timers.extend(it.timers.set)
        return 5

    assert await it.screen.background(task, "It takes a while.", is_slow=is_slow) == 5
    assert [(kind, seconds) for kind, seconds, _ in timers] == (
        [] if is_slow else [("once", 1.0), ("again", 10.0)]
    )
    assert (it.timers.set, it.done) == ([], [])
    for _kind, _seconds, report in timers:
        report()
    assert it.done == [("ctx say", "It takes a while.")] * len(timers)


async def test_a_task_that_is_given_up_changed_nothing_and_a_failed_one_says_so_itself(monkeypatch):
    it = Asking()

    async def cancelled(_task: Callable[[], object]) -> None:
        raise asyncio.CancelledError

    async def failed(_task: Callable[[], object]) -> None:
        raise OSError("full")

    monkeypatch.setattr(asyncio, "to_thread", cancelled)
    with pytest.raises(asyncio.CancelledError):
        await it.screen.background(lambda: 1, "It takes a while.")
    assert (it.done, it.timers.set) == ([("ctx answer", "answer-unchanged")], [])
    monkeypatch.setattr(asyncio, "to_thread", failed)
    with pytest.raises(OSError, match="full"):
        await it.screen.background(lambda: 1, "It takes a while.")
    assert (len(it.done), it.timers.set) == (1, [])


async def test_tasks_that_must_end_come_one_after_the_other_whatever_is_given_up():
    it, order, gate = Asking(), [], asyncio.Event()

    async def save(name: str) -> str:
        order.append(f"{name} begins")
        await gate.wait()
        order.append(f"{name} ends")
        return name

    first = asyncio.ensure_future(it.screen.finish(save("one")))
    for _ in range(5):
        await asyncio.sleep(0)
    second = asyncio.ensure_future(it.screen.finish(save("two")))
    ended = asyncio.ensure_future(it.screen.finished())
    for _ in range(5):
        await asyncio.sleep(0)
    first.cancel()
    assert (order, ended.done()) == (["one begins"], False)
    gate.set()
    assert await second == "two"
    await ended
    assert order == ["one begins", "one ends", "two begins", "two ends"]
    await it.screen.finished()


async def test_the_screen_goes_on_while_a_program_runs_and_while_a_command_waits():
    it = Asking()
    assert await it.screen.follow([]) is False
    assert await it.screen.wait(0) is False
    assert it.screen.print_soon() is None
    assert it.screen.continue_on_enter(None) is None
    assert (it.done, it.screen.can_edit, it.screen.is_attended) == ([], True, True)


# --- what is passed on


@pytest.mark.parametrize(
    ("text", "path", "name"),
    [("FW 1", Path("dir/walk.gd"), "walk.gd"), ("FW 1", None, "new program"), (" \n", Path("walk.gd"), "")],
)
def test_a_robot_keeps_its_text_if_there_is_any_before_another_one_is_chosen(text, path, name):
    it, given = Asking(), []
    team = Part(chosen=Part(name="alice"), give=lambda *what: given.append(what))
    it.controller.donnie = Part(team=team)
    it.controller.workspace = Part(document=Part(path=path))
    it.place.editor.text = text
    it.screen.before_robot_changes()
    assert given == ([("alice", RunRequest(text, name))] if name else [])


async def test_a_line_that_is_typed_again_is_run_to_its_end():
    it, ended = Asking(), []

    async def rest() -> None:
        ended.append("rest")

    it.controller.run_line = lambda line: it.done.append(line) or (rest() if line == "OPEN" else None)
    await it.screen.type_again("FW 1")
    await it.screen.type_again("OPEN")
    assert (it.done, ended) == (["FW 1", "OPEN"], ["rest"])


async def test_ways_out_and_changes_reach_the_controller(monkeypatch):
    it, may_leave = Asking(), [False, True]

    async def may_lose(ctx: Any) -> bool:
        assert ctx is it.ctx
        return may_leave.pop(0)

    monkeypatch.setattr(interaction, "may_lose_all", may_lose)
    it.controller.run_view = Recorded("view", it.done)
    it.controller.assistant = Recorded("assistant", it.done)
    it.screen.setting_changed("lang")
    it.screen.robot_changed()
    await it.screen.enter_world("maze")
    await it.screen.switch_mode()
    await it.screen.quit()
    await it.screen.quit()
    it.screen.mark_mistakes()
    it.screen.place_cursor(3, 4)
    it.screen.show_sensor_ranges(["line"])
    it.screen.repaint()
    assert it.done == [
        ("controller apply_setting", "lang"), ("view robot_changed",), ("controller change_world", "maze"),
        ("controller switch_to_linear",), ("controller leave",), ("assistant check_now",),
        ("editor go_to", 3, 4), ("display show_fields", ["line"]), "repaint",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("pane", "done"),
    [
        ("program", ("place go_to", "the program's")),
        ("map", ("place go_to", "the map's")),
        ("log", ("place go_to", "the log's")),
        ("variables", ("place toggle_inspector",)),
    ],
)
def test_each_pane_gets_the_focus_and_the_variables_are_shown_or_hidden(pane, done):
    it = Asking()
    it.screen.focus(pane)
    assert it.done == [done]


@pytest.mark.parametrize("has_focus", [True, False])
def test_a_square_is_explored_with_the_focus_on_the_map(has_focus):
    it = Asking()
    it.place.map.has_focus = has_focus
    it.screen.explore(int)
    assert it.screen.map is it.place.map
    assert it.done == [*([] if has_focus else [("place go_to", "the map's")]), ("map explore", int)]


@pytest.mark.parametrize("is_found", [True, False])
def test_the_log_is_searched_and_its_title_says_what_was_found(is_found):
    it = Asking()
    it.place.log_rows = Part(
        search=lambda word: it.done.append(word) or is_found, only="says", lines=("a", "b"),
        filter=lambda kind: it.done.append(f"only {kind}"),
        with_kinds=(("a", "says"), ("b", ""), ("c", "says")),
    )  # fmt: skip
    word = "x" * 41
    it.screen.search_log(word, 3)
    it.screen.filter_log("moved")
    found = ("x" * 39 + "…", 3) if is_found else None
    assert it.done == [word, ("display entitle_log", found), "only moved", ("display entitle_log",)]
    assert (it.screen.log_filter, dict(it.screen.log_kinds)) == ("says", {"says": 2, "": 1})
    assert it.screen.log_text == "a\nb\n"


# --- words to complete


def completing(it: Asking, text: str, *found: Completion) -> list[tuple[str, int]]:
    """Completions at the fourth character of a text, one after the other. Returns what is asked."""
    asked: list[tuple[str, int]] = []
    left = list(found)

    def complete(text: str, at: int) -> Completion:
        asked.append((text, at))
        return left.pop(0)

    it.controller.assistant = Part(completion=complete)
    it.place.editor.text, it.place.editor.offset_of_cursor = text, 4
    it.place.editor.cursor_screen_offset = Part(x=3, y=7)
    it.place.room_around = lambda row: it.done.append(f"row {row}")
    return asked


@pytest.mark.parametrize(
    ("answer", "done"),
    [
        (("REPEAT", ""), [("editor put_in_place_of", "REP", "REPEAT")]),
        (("", "x"), [("editor insert", "x")]),
        (("", ""), []),
        (None, []),
    ],
)
async def test_a_chosen_word_replaces_the_typed_one_and_a_letter_is_written(answer, done):
    it = Asking(answer)
    words = ("REPEAT", "REPLACE")
    assert completing(it, "REP", Completion("REP", words, words)) == []
    await it.screen.complete()
    assert (type(it.asked), it.asked._count, it.asked._keys) == (Completions, 2, WORDS("completion-keys"))
    assert it.done == [("editor focus",), "row 7", *done]


@pytest.mark.parametrize(("after", "is_listed"), [(("DO",), True), ((), False)])
async def test_after_a_whole_word_a_blank_and_what_may_follow_it_are_offered(after, is_listed):
    it = Asking(None)
    asked = completing(it, "STEP FW", Completion("STEP", ()), Completion("", after, after))
    await it.screen.complete()
    assert asked == [("STEP FW", 4), ("STEP  FW", 5)]
    if is_listed:
        assert it.done == [("editor focus",), ("editor insert", " "), "row 7"]
    else:
        assert it.done == [("editor focus",), ("ctx answer", "screen-nothing-to-complete")]
        assert it.dialogs == []


async def test_where_nothing_was_typed_nothing_else_is_looked_for():
    it = Asking()
    assert completing(it, "    ", Completion("", ())) == []
    await it.screen.complete()
    assert it.done == [("editor focus",), ("ctx answer", "screen-nothing-to-complete")]


# --- pages


async def test_pages_are_opened_with_their_title_their_keys_and_their_lines():
    it = Asking()
    await it.screen.show_pages("Title", ["one", "two"], printed=["three"])
    it.screen.show_help(is_everything=True)
    it.screen.show_help(is_everything=False)
    it.screen.show_keys()
    it.screen.show_manual()
    page, everything, first, keys, manual = it.dialogs
    assert {type(each) for each in it.dialogs} == {Help}
    assert (page._title_words, page._lines, page._further) == ("Title", ("one", "two"), None)
    assert (everything._title_words, first._title_words) == (WORDS("help-title"),) * 2
    assert (everything._lines[0], first._lines[0]) == ("Keys and words:", "In the program:")
    assert (keys._title_words, keys._further) == ("In the program", None)
    assert keys._lines[-1] == "Tab: the next pane. Shift+Tab: the one before."
    assert (manual._title_words, manual._further) == (WORDS("manual-title"), None)
    of_pages, of_help = WORDS("page-keys"), WORDS("help-keys")
    assert [each._keys for each in it.dialogs] == [of_pages, of_help, of_help, of_pages, of_pages]
    everything._further()
    assert (it.dialogs[-1]._title_words, len(it.dialogs)) == (WORDS("manual-title"), 6)


@pytest.mark.parametrize(
    ("problem", "reason"),
    [(None, ""), (OSError(28, "No space left"), "No space left"), (OSError("odd"), "odd")],
)
def test_the_log_is_read_in_the_pager_while_the_screen_is_away(monkeypatch, problem, reason):
    it = Asking()

    def run(command: list[str], text: str) -> None:
        it.done.append((command, text))
        if problem:
            raise problem

    monkeypatch.setattr(interaction, "pager", lambda _environment: ["less"])
    monkeypatch.setattr(interaction, "run_pager", run)
    it.screen.show_in_pager("a\nb\n")
    ran = ["suspended", (["less"], "a\nb\n")]
    reported = ("ctx answer", "screen-pager-failed", ("reason", reason))
    assert it.done == [*ran, *([reported] if problem else []), "resumed"]
    assert it.dialogs == []


@pytest.mark.parametrize("command", [None, ["less"]])
def test_without_a_pager_or_a_terminal_the_log_is_a_page(monkeypatch, command):
    it = Asking()

    def no_terminal() -> None:
        raise SuspendNotSupported

    monkeypatch.setattr(interaction, "pager", lambda _environment: command)
    monkeypatch.setattr(interaction, "run_pager", lambda *_: it.done.append("ran"))
    it.app.suspend = no_terminal
    it.screen.show_in_pager("a\nb\n")
    assert (it.asked._title_words, it.asked._lines, it.done) == ("Log", ("a", "b"), [])


# --- the tour


@pytest.mark.parametrize(
    ("plain", "small", "kind"),
    [(False, False, TourStrip), (True, False, Tour), (False, True, Tour), (True, True, Tour)],
)
def test_the_tour_is_below_the_panes_where_there_is_room(plain, small, kind):
    it = Asking(is_plain=plain, is_small=small)
    it.place.show_tour = it.dialogs.append
    it.screen.show_tour()
    assert (type(it.asked), it.asked._at, len(it.asked._pages)) == (kind, 0, 9)
    it.asked._turned(4)
    it.screen.show_tour()
    assert it.asked._at == 4


def test_a_tour_that_is_shown_is_turned():
    it = Asking()
    it.place.tour = Recorded("tour", it.done)
    it.screen.show_tour()
    assert (it.done, it.dialogs) == ([("tour action_turn", 1)], [])


@pytest.mark.parametrize(("plain", "strip"), [(False, True), (True, False)])
def test_after_the_last_page_of_the_tour_the_first_challenge_begins(plain, strip):
    it = Asking(is_plain=plain)
    it.place.show_tour = it.dialogs.append
    it.screen.show_tour()
    it.asked._turned(8)
    assert (it.posted, it.done) == ([], [("display looked",)] if strip else [])
    it.done.clear()
    it.asked._turned(9)
    assert [(type(each), each.text) for each in it.posted] == [(CommandLine.Typed, "CHALLENGE 1")]
    assert it.done == ([("display looked",), ("place close_tour",)] if strip else [])
    it.screen.show_tour()
    assert it.asked._at == 0, "another tour begins anew"
