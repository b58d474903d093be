"""What a command may use: answers that are not repeated, codes of a script, and the tries of a challenge."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace as Part
from typing import Any

import pytest

from devices.ports.robot import Pose
from donnie_tui.commands.context import Attempt
from donnie_tui.core.events import (
    Announced,
    Answered,
    Chimed,
    Moved,
    Reset,
    Spoke,
    Stamped,
    Turned,
)
from tests.timeouts import TIMEOUT
from tests.unit.commands.scripted import Script
from tests.unit.commands.test_on_screen import on_screen

OpenScript = Callable[..., Script]


def said(script: Script, do: Callable[[], object]) -> list[str]:
    before = len(script.printed)
    do()
    script.donnie.session.hub.wait_until_delivered(TIMEOUT)
    return script.printed[before:]


def test_a_key_that_is_held_down_at_a_limit_is_answered_once(open_script: OpenScript) -> None:
    script = open_script()
    on_screen(script).map.zoom = 2
    nearest = "The nearest: 2 columns a square."
    assert script.answers_to("ZOOM IN") == [nearest]
    script.ctx.answers.add_lines([nearest])
    script.ctx.answers.end_answer()

    assert script.answers_to("ZOOM IN") == []
    script.ctx.answers.add_lines(["Another answer.", nearest])
    script.ctx.answers.end_answer()
    assert script.answers_to("ZOOM IN") == [nearest], "it was a part of another answer"


def test_another_world_is_announced_and_a_challenge_announces_itself(open_script: OpenScript) -> None:
    script = open_script()

    assert said(script, lambda: script.ctx.answer_entering("maze")) == ["I am going to maze."]
    assert said(script, lambda: script.ctx.answer_entering("challenge:1")) == []


def test_an_urgent_answer_comes_before_the_others_and_a_repeated_one_is_not_remembered(
    open_script: OpenScript,
) -> None:
    script, answered = open_script(), list[Answered]()

    def note(stamped: Stamped) -> None:
        if isinstance(stamped.event, Answered):
            answered.append(stamped.event)

    script.donnie.team.stream.subscribe(note)
    script.ctx.say("One.", "Two.")
    script.ctx.is_urgent = True
    script.ctx.say("Three.", is_repeated=True)
    script.donnie.session.hub.wait_until_delivered(TIMEOUT)

    assert [(each.text, each.at_once, each.is_repeated) for each in answered] == [
        *(("One.", False, False), ("Two.", False, False), ("Three.", True, True)),
    ]


def test_the_worst_code_of_a_script_counts(open_script: OpenScript) -> None:
    ctx = open_script().ctx
    codes = []
    for code in (1, 2, 1):
        ctx.refuse(code)
        codes.append(ctx.script_code)

    assert codes == [1, 2, 2]


def test_a_closed_context_follows_nothing(open_script: OpenScript) -> None:
    script = open_script(world="challenge:1")
    ctx = script.ctx
    assert ctx.attempt is not None
    ctx.close()
    events = len(ctx.attempt._events)
    script.donnie.session.start("FW 2", "a.gd").wait(TIMEOUT)
    script.donnie.session.hub.wait_until_delivered(TIMEOUT)

    assert len(ctx.attempt._events) == events
    assert ctx.trail.last_pose in (None, Pose(0, 0, 0))


# --- a try of a challenge


class Tried:
    """A challenge that is judged by what the test says."""

    def __init__(self, script: Script, patched: pytest.MonkeyPatch, *goals: object) -> None:
        assert script.ctx.attempt is not None
        self.attempt = script.ctx.attempt
        self.judged = 0
        self.chimed: list[str] = []
        self.goals = [*goals]
        hub = Part(publish=lambda event: self.chimed.append(event.name))
        patched.setattr(self.attempt, "_donnie", Part(session=Part(hub=hub)))
        patched.setattr(self.attempt, "judgment", self._judge)

    def _judge(self) -> Any:
        self.judged += 1
        return Part(of_goals=tuple(self.goals))

    def receive(self, event: Any, robot: str | None = None) -> int:
        """How often that is judged."""
        before = self.judged
        self.attempt._on_event(Stamped(1, 0.0, event, robot))
        return self.judged - before


HERE = Pose(0, 0, 0)
MOVED = Moved("FW 1", 1, 1, None, HERE, True)


def test_each_goal_that_is_met_chimes_once_until_a_new_start(
    open_script: OpenScript, monkeypatch: pytest.MonkeyPatch
) -> None:
    it = Tried(open_script(world="challenge:1"), monkeypatch, "not yet", "not yet")
    assert it.receive(MOVED) == 1
    it.goals[0] = None
    it.receive(MOVED)
    it.receive(MOVED)
    assert it.chimed == ["goal"]
    it.goals = ["not any more", None]
    it.receive(Spoke("a"))
    it.goals = [None, None]
    it.receive(MOVED)
    assert it.chimed == ["goal"] * 2, "the first one was met before"
    it.receive(Reset(HERE))
    assert it.chimed == ["goal"] * 2, "a start is quiet"
    it.receive(MOVED)
    assert it.chimed == ["goal"] * 2
    it.goals = ["not yet", "not yet"]
    it.receive(Reset(HERE))
    it.goals = [None, "not yet"]
    it.receive(MOVED)
    assert it.chimed == ["goal"] * 3


@pytest.mark.parametrize("event", [Answered("a"), Announced("moved", "a"), Chimed("goal")])
def test_only_what_may_meet_a_goal_is_judged(
    open_script: OpenScript, monkeypatch: pytest.MonkeyPatch, event: object
) -> None:
    it = Tried(open_script(world="challenge:1"), monkeypatch)

    assert it.receive(event) == 0


def test_after_many_events_goals_are_judged_at_the_end_only(
    open_script: OpenScript, monkeypatch: pytest.MonkeyPatch
) -> None:
    it = Tried(open_script(world="challenge:1"), monkeypatch)
    kept = len(it.attempt._events)
    monkeypatch.setattr(Attempt, "MOST_LIVE", kept + 2)

    assert [it.receive(MOVED) for _ in range(3)] == [1, 1, 0]
    assert Attempt.MOST_EVENTS == 100_000


def test_a_new_start_forgets_what_the_robot_did_and_not_what_the_others_did(
    open_script: OpenScript, monkeypatch: pytest.MonkeyPatch
) -> None:
    it = Tried(open_script(world="challenge:1"), monkeypatch)
    it.receive(MOVED, "alice")
    it.receive(Turned("TR 90", 90, 90, None, HERE, True), "bob")
    it.receive(Reset(HERE), "alice")

    assert [type(each.event) for each in it.attempt._events if each.robot == "bob"] == [Turned]
    assert [type(each.event) for each in it.attempt._events if each.robot == "alice"] == [Reset]
