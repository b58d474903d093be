"""Which lines of events wait to be printed, in which order, and which are remembered."""

from __future__ import annotations

from types import SimpleNamespace as Part
from typing import Any

import pytest

from devices.ports.robot import Pose
from donnie_tui.core.events import Announced, Answered, Error, Event, Moved, Passing, Spoke, Stamped
from donnie_tui.i18n.words import Words
from donnie_tui.linear.output import LARGEST_BLOCK, URGENT, BackgroundRobots, Listener, OutputQueue

HERE = Pose(0, 0, 0)
URGENT_NEWS = Announced(min(URGENT), "urgent")


class Listening:
    def __init__(self, *, is_paced: bool = False, is_ending: bool | None = None, known: bool = False) -> None:
        self.did: list[Any] = []
        self.queue = OutputQueue(lambda: self.did.append("queued"))
        run = None if is_ending is None else Part(is_ending=is_ending)
        team = Part(running=())
        session = Part(
            run=run,
            speed=5.0,
            hub=Part(subscribe=lambda _: self.did.append("subscribed") or (lambda: self.did.append("left"))),
        )
        audible = Part(speak_only=lambda _: lambda: self.did.append("speaks all"))
        self.donnie: Any = Part(words=Words(), session=session, team=team, outlets=Part(audible=audible))
        self.console: Any = Part(now=lambda: 0.0, nudge=lambda: self.did.append("nudged"), has_news=False)
        ctx: Any = Part(donnie=self.donnie, answer=lambda code, **values: self.did.append((code, values)))
        self.background = BackgroundRobots(ctx, self.queue)
        self.listener = Listener(
            self.donnie,
            self.console,
            self.queue,
            self.background,
            is_paced=is_paced,
            is_known=lambda _: known,
        )
        self.did.clear()

    def receive(self, event: Event, robot: str | None = None) -> tuple[list[str], list[str]]:
        """The lines to print and to remember."""
        self.listener._on_event(Stamped(1, 0.0, event, robot))
        return self.queue.take(), self.queue.take_kept()


@pytest.mark.parametrize(
    ("event", "printed", "kept"),
    [
        (Spoke("a"), ["a"], ["a"]),
        (Answered("a"), ["a"], ["a"]),
        (Answered("a", is_repeated=True), ["a"], []),
        (Answered("a", at_once=True), ["a"], ["a"]),
        (Answered("a", at_once=True, is_repeated=True), ["a"], []),
        (Passing(HERE), [], []),
        (URGENT_NEWS, ["urgent"], ["urgent"]),
    ],
)
def test_what_is_printed_is_remembered_unless_it_repeats(
    event: Event, printed: list[str], kept: list[str]
) -> None:
    assert Listening().receive(event) == (printed, kept)


def test_a_mistake_that_is_known_is_neither_printed_nor_remembered() -> None:
    error = Error("k", 1, 1, "Wrong.", None)

    assert Listening().receive(error) == (["Error, line 1, column 1: Wrong."],) * 2
    assert Listening(known=True).receive(error) == ([], [])


def test_an_answer_at_once_or_in_a_flood_comes_before_all_that_wait() -> None:
    it = Listening()
    it.queue.put(["first"])
    assert it.receive(Answered("a")) == (["first", "a"], ["first", "a"])
    it.queue.put(["first"])
    assert it.receive(Answered("a", at_once=True))[0] == ["a", "first"]

    it.donnie.team.running = ("bob",)
    many = [str(number) for number in range(LARGEST_BLOCK)]
    it.queue.put(many)
    assert it.receive(Answered("a"))[0] == [*many, "a"]
    it.queue.put([*many, "one more"])
    assert it.receive(Answered("a"))[0] == ["a", *many, "one more"]
    it.queue.put([*many, "one more"])
    it.background.is_following = True
    assert it.receive(Answered("a"))[0][0] == "0"
    it.background.is_following = False
    it.donnie.team.running = ()
    it.queue.put([*many, "one more"])
    assert it.receive(Answered("a"))[0][0] == "0"


@pytest.mark.parametrize("is_ending", [None, False, True])
def test_urgent_news_come_first_while_a_program_is_stopped(is_ending: bool | None) -> None:
    it = Listening(is_ending=is_ending)
    it.queue.put(["first"])

    printed, _ = it.receive(URGENT_NEWS)
    assert printed == (["urgent", "first"] if is_ending else ["first", "urgent"])
    assert it.console.has_news


def test_a_typed_line_is_interrupted_by_lines_and_not_by_what_is_only_shown() -> None:
    it = Listening()
    it.receive(Spoke("a"))
    assert "nudged" not in it.did
    assert not it.console.lines_wait()

    it.listener.line_begins()
    it.receive(Passing(HERE))
    assert "nudged" not in it.did
    it.listener._on_event(Stamped(1, 0.0, Spoke("a")))
    assert it.did.count("nudged") == 1
    assert it.console.lines_wait()
    it.queue.take()
    assert not it.console.lines_wait()
    it.listener._on_event(Stamped(1, 0.0, Answered("a")))
    assert it.did.count("nudged") == 2
    it.listener.line_ended()
    it.receive(Spoke("a"))
    assert it.did.count("nudged") == 2
    it.listener.line_begins()
    assert not it.console.lines_wait()
    assert not it.console.has_news


def test_quick_movements_are_summed_up_only_for_a_learner_and_a_pace() -> None:
    moved = Announced("moved", "I walked 1 step forward.")
    for is_paced, speed, lines in ((True, 5.0, 4), (False, 5.0, 6), (True, None, 6)):
        it = Listening(is_paced=is_paced)
        it.donnie.session.speed = speed
        for _ in range(6):
            it.listener._on_event(Stamped(1, 0.0, Moved("FW 1", 1, 1, None, HERE, True)))
            it.listener._on_event(Stamped(1, 0.0, moved))
        assert len(it.queue.take()) == lines
        assert len(it.queue.take_kept()) == 6


def test_closing_leaves_the_events_and_the_voice() -> None:
    it = Listening()
    it.listener.close()

    assert it.did == ["left", "speaks all"]


# --- robots in the background


def test_after_a_stop_a_block_is_printed_and_the_rest_is_counted() -> None:
    it = Listening()
    it.queue.hold_back()
    it.queue.put(str(number) for number in range(LARGEST_BLOCK))
    it.background.trim_after_stop()
    assert (it.did, it.queue.holds_back, len(it.queue)) == (["queued"], False, LARGEST_BLOCK)

    it.did.clear()
    it.queue.put(["one", "two"])
    it.background._left_out = 3
    it.background.trim_after_stop()
    it.background.trim_after_stop()
    assert it.did == [("answer-left-out", {"lines": 5})]
    assert it.queue.take()[-1] == "two"


# --- the queue


def test_lines_are_taken_in_parts_the_first_ones_before() -> None:
    queue = OutputQueue(lambda: None)
    queue.put(["a", "b", "c"], ["kept"], "bob")
    queue.put_first(["x", "", "y"], is_kept=False)
    queue.put_first(["z"])

    assert (len(queue), queue.has_first) == (6, True)
    assert (queue.take(2), queue.take(2), queue.has_first) == (["x", "y"], ["z", "a"], False)
    assert (queue.take(0), queue.take()) == ([], ["b", "c"])
    assert (queue.take_kept(), queue.take_kept()) == (["kept", "z"], [])


def test_the_newest_lines_stay_after_a_trim() -> None:
    queue = OutputQueue(lambda: None)
    queue.put(["a", "b", "c"])

    assert (queue.trim(3), queue.trim(4), queue.trim(1), queue.take()) == (0, 0, 2, ["c"])


def test_a_robot_waits_for_its_own_lines_only_and_only_while_they_are_held_back() -> None:
    queue = OutputQueue(lambda: None, capacity=2)
    queue.put(["a", "b"], robot="bob")
    assert queue._has_room("bob")
    queue.hold_back()
    assert not queue._has_room("bob")
    assert queue._has_room("alice")
    assert queue._has_room(None)
    queue.take(1)
    assert queue._has_room("bob")
    queue.put(["c"], robot="bob")
    queue.trim(0)
    assert queue._has_room("bob")


def test_lines_that_wait_from_before_interrupt_no_typed_line() -> None:
    it = Listening()
    it.listener.line_begins()
    it.queue.put(["from before"])

    assert not it.console.lines_wait()
