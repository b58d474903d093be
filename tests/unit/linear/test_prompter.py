"""Prompts, pages and questions of the linear mode, with lines that are typed from a list."""

from __future__ import annotations

from types import SimpleNamespace as Part
from typing import Any

import pytest

from donnie_tui.core.session_log import AnswerLog
from donnie_tui.i18n.words import Words
from donnie_tui.linear.output import OutputQueue
from donnie_tui.linear.prompter import Printer, Prompter, Streams, prompt_text
from donnie_tui.linear.reader import How, Typed
from donnie_tui.settings.settings import Settings

ENTER, ESCAPE, CLOSED, INTERRUPTED = How.ENTER, How.ESCAPE, How.CLOSED, How.INTERRUPTED


@pytest.mark.parametrize(
    ("style", "depth", "prompt"),
    [
        ("short", 0, "> "), ("short", 2, "2> "), ("none", 2, ""), ("word", 0, "Donnie> "),
        ("word", 1, "Donnie 1> "), ("answer", 1, "1> "), ("answer", 0, "> "),
    ],
)  # fmt: skip
def test_a_prompt_has_the_depth_of_the_block(style: str, depth: int, prompt: str) -> None:
    assert prompt_text(Settings(prompt=style), depth) == prompt


class Front:
    """The streams of a linear mode: what is printed, and lines that are typed."""

    def __init__(
        self, *typed: str | Typed, is_attended: bool = True, is_terminal: bool = True, **settings: Any
    ) -> None:
        self.typed = [Typed(each, ENTER) if isinstance(each, str) else each for each in typed]
        self.did: list[Any] = []
        self.settings = Settings(**settings)
        self.queue = OutputQueue(lambda: None)
        self.console: Any = Part(
            interrupted=False, has_news=True, edit=lambda on: self.did.append(("edit", on)),
            take_interrupt=lambda: self.did.append("interrupt taken"),
            rest=lambda seconds: self.did.append(("rest", seconds)), now=lambda: 0.0,
        )  # fmt: skip
        self.output: Any = Part(
            block_size=3, paced=None, show=self.show, hold_newline=lambda: self.did.append("newline held")
        )
        self.editing: Any = Part(holds_newline=True, read=self.read, name="editing")
        self.plain: Any = Part(holds_newline=False, read=self.read, name="plain")
        self.streams = Streams(
            self.console, self.editing, self.plain, self.output, self.queue, lambda: self.settings,
            is_attended, is_terminal,
        )  # fmt: skip
        self.answers = AnswerLog()
        self.printer = Printer(self.streams, Words("en"), self.answers)
        self.left_out = 0

    def show(self, lines: list[str], prompt: str = "", *, to_the_end: bool = False) -> int:
        self.did.append(("show", [*lines], prompt, *(["hurry"] if to_the_end else [])))
        left_out, self.left_out = self.left_out, 0
        return left_out

    def read(self, question: str, offered: str = "") -> Typed:
        self.did.append(("read", question, *([offered] if offered else [])))
        return self.typed.pop(0)

    def put(self, *lines: str) -> None:
        for each in lines:
            self.queue.put([each])

    @property
    def shown(self) -> list[tuple[list[str], str]]:
        return [each[1:3] for each in self.did if each[0] == "show"]


# --- the streams


@pytest.mark.parametrize(
    ("settings", "can_edit", "page", "is_paced"),
    [
        ({"page": "rest"}, True, 0, True),
        ({"page": "ask"}, True, 3, False),
        ({"page": "off"}, True, 0, False),
        ({"page": "rest", "hold": "on"}, True, 1, True),
        ({"editor": "plain", "page": "ask"}, False, 3, False),
    ],
)  # fmt: skip
def test_pages_and_editing_are_as_the_settings_say(
    settings: dict[str, Any], can_edit: bool, page: int, is_paced: bool
) -> None:
    it = Front(**settings)
    streams = it.streams
    streams.apply_settings()

    assert (streams.can_edit, streams.takes_live_commands, streams.page_size) == (can_edit, can_edit, page)
    assert streams.reader is (it.editing if can_edit else it.plain)
    assert it.output.paced is is_paced
    assert it.did == [("edit", can_edit)]


def test_without_an_editor_or_a_terminal_lines_are_plain() -> None:
    it = Front(is_attended=False, is_terminal=False)
    streams = Streams(
        it.console,
        None,
        it.plain,
        it.output,
        it.queue,
        lambda: it.settings,
        is_attended=False,
        is_terminal=False,
    )
    streams.apply_settings()

    assert streams.reader is it.plain
    assert (it.output.paced, it.did) == (False, [])
    assert not it.streams.takes_live_commands


@pytest.mark.parametrize(
    ("editor", "how", "is_attended", "is_held"),
    [
        ("own", ENTER, True, True),
        ("own", ESCAPE, True, True),
        ("plain", ENTER, True, False),
        ("plain", CLOSED, True, True),
        ("own", ENTER, False, False),
        ("plain", CLOSED, False, False),
    ],
)  # fmt: skip
def test_the_newline_is_held_unless_the_terminal_has_printed_it(
    editor: str, how: How, is_attended: bool, is_held: bool
) -> None:
    it = Front(editor=editor, is_attended=is_attended)
    it.streams.end_line(Typed("", how))

    assert it.did == (["newline held"] if is_held else [])


# --- printing


def test_lines_are_printed_with_the_prompt_and_remembered() -> None:
    it = Front()
    it.put("one", "two")
    it.left_out = 5
    assert it.printer.show("> ") == 5

    assert it.did == [("show", ["one", "two"], "> ")]
    assert it.answers.last(1) == ("one", "two")
    it.put("again")
    it.printer.is_repeating = True
    it.printer.show("> ")
    assert it.answers.last(1) == ("one", "two")
    it.put("new")
    it.printer.show("> ")
    assert it.answers.last(1) == ("new",)


def test_lines_of_a_running_program_are_no_answer_yet() -> None:
    it = Front()
    it.put("one")
    it.printer.show()
    it.put("two")
    it.printer.show("> ")

    assert it.answers.last(1) == ("one", "two")


def test_the_last_line_of_an_answer_is_the_prompt_where_it_is_wanted() -> None:
    it = Front(prompt="answer")
    it.put("one", "two")
    it.printer.show("> ")
    assert (it.shown, it.printer.prompt) == ([(["one"], "two ")], "two ")

    it.did.clear()
    it.printer.prompt = None
    it.printer.show("> ")
    it.put("three")
    it.printer.show("> FW 1")
    it.put("four")
    it.printer.show()
    assert it.shown == [([], "> "), (["three"], "> FW 1"), (["four"], "")]
    assert it.printer.prompt is None


def pages(*typed: str | Typed, **settings: Any) -> Front:
    it = Front(*typed, **{"page": "ask", **settings})
    it.put(*(str(number) for number in range(1, 8)))
    it.printer.show("> ")
    return it


def test_pages_wait_for_enter_and_the_rest_follows_or_is_left() -> None:
    question = pages("", "q").shown[0][1]
    assert question == "More, 4 lines. Enter continues, Q stops. "

    it = pages("", "")
    assert [each for each, _ in it.shown] == [["1", "2", "3"], ["4", "5", "6"], ["7"]]
    assert it.shown[1][1] == "More, 1 line. Enter continues, Q stops. "
    assert it.shown[2][1] == "> "
    assert it.did.count("newline held") == 2
    for enough in ("q", "Q", "no", "n"):
        assert [each for each, _ in pages(enough).shown] == [["1", "2", "3"], []], enough
    assert [each for each, _ in pages(Typed("", CLOSED)).shown] == [["1", "2", "3"], []]
    assert [each for each, _ in pages(Typed("", ESCAPE), "q").shown] == [["1", "2", "3"], ["4", "5", "6"], []]


def test_ctrl_c_leaves_the_rest_out() -> None:
    it = Front(Typed("", INTERRUPTED), page="ask")
    it.put(*(str(number) for number in range(1, 8)))

    assert it.printer.show("> ") == 4
    assert it.console.interrupted
    assert len(it.shown) == 1


def test_a_wrong_answer_at_a_page_is_repeated_as_far_as_it_fits() -> None:
    it = pages("x" * 41, "q")
    said, question = it.shown[1]

    assert f"{'x' * 39}…" in said[0]
    assert "x" * 40 not in said[0]
    assert question == it.shown[0][1]


def test_where_each_line_waits_a_typed_line_is_kept_for_the_prompt() -> None:
    it = Front("", "FW 1", hold="on")
    it.put("1", "2", "3", "4")
    assert it.printer.show("> ") == 0

    assert it.shown == [([], "1 "), ([], "2 ")]
    assert it.printer.take_early() == Typed("FW 1", ENTER)
    assert it.printer.take_early() is None


def test_after_a_stop_nothing_waits_for_enter() -> None:
    it = Front(page="ask")
    it.put(*(str(number) for number in range(1, 8)))
    it.printer.is_hurrying = True
    it.printer.show("> ")

    assert it.did == [("show", [str(number) for number in range(1, 8)], "> ", "hurry")]


def test_without_a_learner_lines_are_printed_without_prompt_and_pages() -> None:
    it = Front(page="ask", is_attended=False)
    it.put(*(str(number) for number in range(1, 8)))
    it.printer.show("> ")

    assert it.shown == [([str(number) for number in range(1, 8)], "")]


@pytest.mark.parametrize(
    ("page", "is_hurrying", "left"), [("rest", False, 2), ("ask", False, 0), ("ask", True, 2)]
)
def test_of_a_running_program_a_block_is_printed_and_with_pages_all(
    page: str, is_hurrying: bool, left: int
) -> None:
    it = Front(*([""] * 6), page=page)
    it.put(*(str(number) for number in range(20)))
    it.printer.is_hurrying = is_hurrying
    it.printer.show_block()

    assert len(it.queue) == left


# --- questions


class Asking:
    def __init__(self, *typed: str | Typed, **settings: Any) -> None:
        self.front = Front(*typed, **settings)
        self.said: list[str] = []
        words = Words("en")
        donnie = Part(session=Part(hub=Part(wait_until_delivered=lambda: None)), team=Part(running=()))
        ctx: Any = Part(
            donnie=donnie, words=words, attempt=None, workspace=Part(keep_copies=lambda: None),
            say=self.say, answer=lambda code, **values: self.said.append(words(code, **values)),
            runs=Part(say_verdict=lambda: self.said.append("verdict")),
        )  # fmt: skip
        self.ctx = ctx
        events = self.front.did
        listener: Any = Part(
            line_begins=lambda: events.append("begins"), line_ended=lambda: events.append("ended")
        )
        background: Any = Part(stop=lambda lines: events.append(("stopped", lines)), floods=False)
        self.background = background
        self.prompter = Prompter(ctx, self.front.streams, self.front.printer, listener, background)
        self.prompter.copying = Part(at_prompt=lambda: events.append("copied"))  # type: ignore[assignment]

    def say(self, *lines: str) -> None:
        self.said += lines


def test_a_line_is_read_after_the_lines_that_wait() -> None:
    it = Asking("FW 1")
    it.front.put("one")
    assert it.prompter.read("> ") == Typed("FW 1", ENTER)

    assert it.front.did == [
        *("begins", ("show", ["one"], "> "), "copied", ("read", "> "), "ended", "newline held"),
    ]
    assert it.front.console.has_news is False
    assert not it.front.queue.holds_back


def test_a_prompt_that_is_shown_already_is_not_printed_and_a_line_that_is_put_back_is_not_read() -> None:
    it = Asking("FW 1")
    it.prompter.read("> ", shown=True)
    assert it.front.did == ["begins", "copied", ("read", "> "), "ended", "newline held"]
    it.front.did.clear()
    it.prompter.put_back(Typed("FW 2", ESCAPE))
    assert it.prompter.read("> ") == Typed("FW 2", ESCAPE)
    assert it.front.did == []


def test_words_to_choose_from_and_news_are_printed_before_the_line_continues() -> None:
    it = Asking(Typed("F", How.CHOICES, ("FW", "FOR")), Typed("FX", How.NEWS), "FX 1")
    it.ctx.attempt = object()
    assert it.prompter.read("> ").text == "FX 1"

    assert it.said[0] == "verdict"
    assert it.said[2:4] == ["FW", "FOR"]
    assert it.said.count("verdict") == 3
    assert [each for each in it.front.did if each[0] == "read"] == [
        *(("read", "> "), ("read", "> ", "F"), ("read", "> ", "FX")),
    ]
    assert ("rest", 0.025) in it.front.did
    assert [prompt for _, prompt in it.front.shown] == ["> ", "> F", "> FX"]


def test_a_line_that_was_typed_at_a_page_comes_first() -> None:
    it = Asking("FW 1", hold="on")
    it.front.put("1", "2")
    assert it.prompter.read("> ") == Typed("FW 1", ENTER)
    assert it.front.did[-1] == "ended"


def test_the_prompt_is_what_was_printed_in_its_place() -> None:
    it = Asking("FW 1", prompt="answer")
    it.front.put("one")
    it.prompter.read("> ")

    assert ("read", "one ") in it.front.did


@pytest.mark.parametrize(
    ("typed", "answer", "has_ended"),
    [
        (Typed(" yes ", ENTER), "yes", False),
        (Typed("", ENTER), "", False),
        (Typed("a", ESCAPE), "a", False),
        (Typed("", ESCAPE), None, False),
        (Typed("a", INTERRUPTED), None, False),
        (Typed("a", CLOSED), None, True),
    ],
)  # fmt: skip
def test_a_question_is_answered_by_enter(typed: Typed, answer: str | None, has_ended: bool) -> None:
    it = Asking(typed)

    assert it.prompter.ask("Why?") == answer
    assert (it.said, it.prompter.has_ended) == (["Why?"], has_ended)


@pytest.mark.parametrize(
    ("typed", "answer"),
    [
        (("yes",), True), (("no",), False), (("",), False), (("maybe", "y"), True), (("perhaps", ""), False),
        ((Typed("", CLOSED),), None), (("perhaps", Typed("", INTERRUPTED)), None),
        (("WHERE",), None), (("FW 3",), None),
    ],
)  # fmt: skip
def test_a_command_is_no_answer_to_yes_or_no(typed: tuple[Any, ...], answer: bool | None) -> None:
    it = Asking(*typed)
    assert it.prompter.confirm("Sure?") is answer

    assert it.said[0] == "Sure?"
    assert len(it.said) == len(typed)
    if typed[0] in ("WHERE", "FW 3"):
        assert it.prompter.read("> ") == Typed(typed[0], ENTER)


@pytest.mark.parametrize("is_hurrying", [False, True])
def test_after_ctrl_c_it_is_said_how_much_was_left_out(is_hurrying: bool) -> None:
    it = Asking("FW 1")
    it.front.left_out = 4
    it.front.printer.is_hurrying = is_hurrying
    it.prompter.read("> ")

    assert len(it.said) == 1
    assert "4" in it.said[0]
    assert it.front.did.count("interrupt taken") == 1 + is_hurrying
    assert len(it.front.shown) == 2
    assert not it.front.printer.is_hurrying


class Flooded(Asking):
    """Background robots print: so many blocks come before a key is pressed, or the flood ends."""

    def __init__(
        self, blocks: int, *, is_typing: bool = False, interrupts: bool = False, **settings: Any
    ) -> None:
        super().__init__("FW 1", **settings)
        self.ctx.donnie.team.running = ("bob",)
        self.blocks, self.is_typing = blocks, is_typing
        console, front = self.front.console, self.front
        console.leaving, console.pressed_interrupt = None, lambda: interrupts
        console.has_input = lambda: self.is_typing and self.blocks == 0
        front.editing.has_typed = False
        self.put_block()

        def show(lines: list[str], prompt: str = "", *, to_the_end: bool = False) -> int:
            shown = front.show(lines, prompt, to_the_end=to_the_end)
            if self.blocks:
                self.blocks -= 1
                self.put_block()
            return shown

        front.output.show = show

    def put_block(self) -> None:
        self.front.put("line")
        self.background.floods = self.blocks > 0 or self.is_typing


def test_a_flood_is_printed_by_blocks_until_it_ends() -> None:
    it = Flooded(2)
    it.prompter.read("> ")

    assert it.front.shown == [(["line"], ""), (["line"], ""), (["line"], "> ")]


def test_a_key_that_is_pressed_in_a_flood_leaves_the_rest_for_later() -> None:
    it = Flooded(2, is_typing=True)
    it.prompter.read("> ")

    assert it.front.shown == [(["line"], ""), (["line"], ""), ([], "> ")]


def test_what_is_typed_already_leaves_the_rest_of_a_flood_for_later_unless_an_answer_waits() -> None:
    it = Flooded(2)
    it.front.editing.has_typed = True
    it.prompter.read("> ")
    assert it.front.shown == [(["line"], ""), ([], "> ")]

    it = Flooded(1)
    it.front.editing.has_typed = True
    for lines in (["an answer"], []):
        it.front.queue._first = lines
        it.front.queue.take = lambda most=None: []  # type: ignore[method-assign]
        it.blocks, it.background.floods = 1, True
        assert it.prompter._show_flood() is not bool(lines)


def test_no_flood_is_printed_by_blocks_where_a_signal_came_or_no_learner_types() -> None:
    it = Flooded(2)
    it.front.console.leaving = 15
    it.prompter.read("> ")
    assert it.front.shown == [(["line"], "> ")]

    it = Flooded(2, is_attended=False)
    it.prompter.read("> ")
    assert it.front.shown == [(["line"], "")]


@pytest.mark.parametrize("holds_back", [False, True])
def test_robots_wait_as_before_once_a_line_was_read(holds_back: bool) -> None:
    it = Asking("FW 1")
    it.front.queue.holds_back = holds_back
    it.prompter.read("> ")

    assert it.front.queue.holds_back is holds_back


def test_ctrl_c_in_a_flood_stops_the_robots() -> None:
    it = Flooded(2, interrupts=True)
    it.front.left_out = 7
    it.prompter.read("> ")

    assert ("stopped", 7) in it.front.did
    assert it.front.shown[-1] == (["line"], "> ")


@pytest.mark.parametrize("settings", [{"page": "ask"}, {"hold": "on"}])
def test_with_pages_a_flood_is_an_answer(settings: dict[str, Any]) -> None:
    it = Flooded(2, **settings)
    it.front.typed.insert(0, Typed("", ENTER))
    it.prompter.read("> ")

    assert it.front.shown[0][1] != ""


def test_what_a_stop_left_out_of_a_flood_is_not_said_twice() -> None:
    it = Flooded(0)
    it.front.left_out = 3
    it.prompter.read("> ")

    assert ("stopped", 3) in it.front.did
    assert it.said == []
