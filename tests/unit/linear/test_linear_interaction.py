"""Questions, lists, files and ways out of the linear mode, with typed lines from a list."""

from __future__ import annotations

from types import SimpleNamespace as Part
from typing import Any

import pytest

from donnie_tui.commands.interaction import EnterWorld, Option, drive
from donnie_tui.i18n.words import Words
from donnie_tui.linear import conversation
from donnie_tui.linear.conversation import LinearInteraction
from donnie_tui.linear.reader import How, Typed


class Talk:
    """A conversation; what it says and does, and what is typed into it."""

    def __init__(self, *typed: str | Typed | None, is_following: bool = False) -> None:
        self.typed = [*typed]
        self.said: list[str] = []
        self.did: list[Any] = []
        words = Words()
        self.prompter: Any = Part(
            offered="", ask=self.ask, put_back=self.did.append,
            read_next=lambda: self.line(self.typed.pop(0)),
            confirm=lambda question: (question, self.typed.pop(0)),
        )  # fmt: skip
        self.console: Any = Part(
            leaving=None, nudge=lambda: self.did.append("nudged"),
            is_disturbed_within=lambda seconds, *, reading: self.did.append((seconds, reading)) or True,
        )  # fmt: skip
        ctx: Any = Part(
            say=lambda *lines: self.said.extend(lines),
            answer=lambda code, **values: self.said.append(words(code, **values)),
            donnie=Part(session=Part(name="bob")),
            workspace=Part(choose_robot=lambda name: self.did.append(("robot", name))),
        )
        self.leaving: Any = Part(world="", enter_world=self.enter, quit=lambda: self.did.append("quit"))
        self.leaving.switch_to_screen = lambda: self.did.append("screen")
        self.typed_lines: Any = Part(continuation=None)
        conversation: Any = Part(
            prompter=self.prompter, console=self.console, ctx=ctx, leaving=self.leaving,
            typed_lines=self.typed_lines, background=Part(is_following=is_following),
            printer=Part(show=lambda: self.did.append("shown")),
            streams=Part(can_edit=True, is_attended=True, apply_settings=lambda: self.did.append("applied")),
            run_loop=Part(follow=lambda runs: self.did.append(("follow", runs))),
            take_again=lambda line: self.did.append(("again", line)),
        )  # fmt: skip
        self.interaction = LinearInteraction(conversation)

    def ask(self, question: str) -> Any:
        assert not self.prompter.offered, "what stands there already is not heard"
        self.said.append(question)
        return self.typed.pop(0)

    def line(self, typed: Any) -> Typed:
        return typed if isinstance(typed, Typed) else Typed(typed, How.ENTER)

    def enter(self) -> None:
        raise EnterWorld(self.leaving.world)


@pytest.mark.parametrize(
    ("typed", "answer", "said"),
    [
        (("a",), "a", ["Why?"]),
        (("",), None, ["Why?"]),
        ((None,), None, ["Why?"]),
        (("x", "b"), "b", ["Why?", "Not x."]),
        (("x", "x", ""), None, ["Why?", "Not x.", "Not x."]),
        (("x", None), None, ["Why?", "Not x."]),
    ],
)
def test_a_wrong_answer_is_asked_for_again(
    typed: tuple[str | None, ...], answer: str | None, said: list[str]
) -> None:
    it = Talk(*typed)

    assert drive(it.interaction.ask("Why?", "old", {"x": "Not x."}.get)) == answer
    assert it.said == said


def test_without_a_check_each_answer_is_taken() -> None:
    assert drive(Talk("x").interaction.ask("Why?")) == "x"
    it = Talk("walk")
    assert drive(it.interaction.ask_file("Which?", "old.gd", list, is_new=True)) == "walk"
    assert it.said == ["Which?"]
    assert drive(Talk(True).interaction.confirm("Sure?")) == ("Sure?", True)


OPTIONS = (Option("a", "apple", number=1), Option("b", "bear", number=12), Option("c", "cat"))
ASKED, NUMBER = ["a list"], Words()("type-number")


@pytest.mark.parametrize(
    ("typed", "value", "said", "is_put_back"),
    [
        ("1", "a", ["1: apple"], False),
        (" 12 ", "b", ["12: bear"], False),
        ("2", None, ["There is no line 2. The last is 12."], False),
        ("0", None, ["There is no line 0. The last is 12."], False),
        ("12345678", None, ["There is no line 12345678. The last is 12."], False),
        ("123456789", None, [], True),
        ("FW 1", None, [], True),
        ("", None, [], True),
        (Typed("", How.ESCAPE), None, [], False),
        (Typed("1", How.ESCAPE), None, [], True),
        (Typed("", How.CLOSED), None, [], True),
    ],
)
def test_the_number_of_an_option_chooses_it(
    typed: str | Typed, value: str | None, said: list[str], is_put_back: bool
) -> None:
    it = Talk(typed)

    assert drive(it.interaction.choose("Which?", OPTIONS, ASKED)) == value
    assert it.said == [*ASKED, NUMBER, *said]
    assert it.did == ([it.line(typed)] if is_put_back else [])


def test_a_list_without_numbers_is_only_read() -> None:
    it = Talk()

    assert drive(it.interaction.choose("Which?", OPTIONS[2:], ASKED)) is None
    assert (it.said, it.did) == (ASKED, [])


@pytest.mark.parametrize(
    ("typed", "leaving", "line", "is_put_back"),
    [
        (Typed("FW 1", How.ENTER), None, "FW 1", False),
        (Typed("", How.ENTER), None, "", False),
        (Typed("FW 1", How.ESCAPE), None, "FW 1", False),
        (Typed(" ", How.ESCAPE), None, None, False),
        (Typed("FW 1", How.INTERRUPTED), None, None, False),
        (Typed("", How.CLOSED), None, None, True),
        (Typed("", How.INTERRUPTED), 15, None, True),
    ],
)
def test_a_line_is_edited(typed: Typed, leaving: int | None, line: str | None, is_put_back: bool) -> None:
    it = Talk(typed)
    it.console.leaving = leaving

    assert drive(it.interaction.edit_line("Edit.", "FW 2")) == line
    assert (it.said, it.prompter.offered) == (["Edit."], "FW 2")
    assert it.did == ([typed] if is_put_back else [])


def test_pages_are_printed_as_they_are_or_as_they_are_to_be() -> None:
    it = Talk()
    drive(it.interaction.show_pages("Title", ["a"]))
    drive(it.interaction.show_pages("Title", ["a"], ["b"]))
    drive(it.interaction.show_pages("Title", ["a"], []))

    assert it.said == ["a", "b"]


def test_the_other_ways_lead_where_they_belong() -> None:
    it, runs = Talk(), [("bob", object())]
    interaction: Any = it.interaction

    async def more() -> None:
        it.did.append("more")

    assert (interaction.can_edit, interaction.is_attended) == (True, True)
    assert drive(interaction.finish(more())) is None
    assert drive(interaction.finished()) is None
    assert drive(interaction.follow(runs)) is True
    assert drive(interaction.wait(0.5)) is True
    interaction.print_soon()
    interaction.continue_on_enter(more)
    interaction.setting_changed("rate")
    interaction.before_robot_changes()
    interaction.robot_changed()
    drive(interaction.type_again("FW 1"))
    drive(interaction.switch_mode())
    drive(interaction.quit())
    it.typed_lines.continuation()

    assert it.did == [
        *("more", ("follow", runs), "shown", (0.5, True), "nudged", "applied", ("robot", "bob")),
        *(("again", "FW 1"), "screen", "quit", "more"),
    ]


def test_another_world_is_entered_at_once_or_once_the_held_program_is_stopped() -> None:
    with pytest.raises(EnterWorld) as entered:
        drive(Talk().interaction.enter_world("maze"))
    assert entered.value.name == "maze"

    it = Talk(is_following=True)
    drive(it.interaction.enter_world("maze"))
    assert it.leaving.world == "maze"


@pytest.mark.parametrize(
    ("named", "first", "may_be_left"),
    [
        ({}, 1.0, False),
        ({"may_be_left": True}, 1.0, True),
        ({"is_slow": True}, 10.0, False),
    ],
)
def test_what_may_take_long_is_reported_after_a_second_or_ten_if_it_always_does(
    monkeypatch: pytest.MonkeyPatch, named: dict[str, bool], first: float, may_be_left: bool
) -> None:
    it, given = Talk(), list[Any]()

    def run(console: object, task: Any, report: Any, **how: Any) -> Any:
        given.extend([console, how["first"], how["may_be_left"]])
        report()
        how["show"]()
        return task()

    monkeypatch.setattr(conversation, "run_in_background", run)

    assert drive(it.interaction.background(lambda: 7, "It takes long.", **named)) == 7
    assert given == [it.console, first, may_be_left]
    assert (it.said, it.did) == (["It takes long."], ["shown"])
