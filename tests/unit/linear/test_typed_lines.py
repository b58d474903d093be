"""What a typed line does at the prompt, while a program is held, and while one runs."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace as Part
from typing import Any

import pytest

from devices.ports.robot import Pose
from donnie_tui.bootstrap import assemble
from donnie_tui.commands import sound
from donnie_tui.core.events import Outcome
from donnie_tui.core.run_state import RunState
from donnie_tui.linear.output import BackgroundRobots, OutputQueue
from donnie_tui.linear.prompter import GRACE
from donnie_tui.linear.reader import How, Typed
from donnie_tui.linear.typed_lines import RunLoop, TypedLines
from donnie_tui.settings.settings import Settings
from tests.timeouts import TIMEOUT
from tests.unit.commands.scripted import Script


class Prompt:
    """A linear front end without a terminal."""

    def __init__(self, script: Script) -> None:
        self.script, self.ctx = script, script.ctx
        self.settings = Settings()
        self.time, self.did = 0.0, list[str]()
        console = Part(
            now=lambda: self.time, leaving=None, interrupted=False, has_news=False, nudge=lambda: None
        )
        self.streams: Any = Part(
            console=console, is_attended=True, can_edit=True, takes_live_commands=True, editing=None,
            settings=lambda: self.settings, queue=OutputQueue(lambda: None),
            output=Part(hold_newline=lambda: self.did.append("newline held")),
        )  # fmt: skip
        self.lines = TypedLines(self.ctx, self.streams)
        self.leaving: Any = Part(code=None, world="", leave=lambda code: self.did.append(f"leave {code}"))
        prompter: Any = Part(
            put_back=lambda typed: self.did.append(f"put back {typed.text!r}"),
            read=lambda _: self.typed,
        )
        background: Any = Part(is_following=False, trim_after_stop=lambda: self.did.append("trimmed"))
        self.typed = Typed("", How.ENTER)
        self.loop = RunLoop(self.ctx, self.streams, Part(), prompter, background, self.leaving)  # type: ignore[arg-type]
        self.ctx.runs.observer = script

    def said(self, do: Callable[[], object]) -> list[str]:
        printed = self.script.printed
        before = len(printed)
        do()
        if self.ctx.runs.state is not RunState.READY:
            self.script.rest()
        self.script.donnie.session.hub.wait_until_delivered(TIMEOUT)
        return printed[before:]

    def take(self, line: str) -> list[str]:
        return self.said(lambda: self.lines.take(line))

    def held(self, line: str, how: How = How.ENTER) -> list[str]:
        self.typed = Typed(line, how)
        return self.said(self.loop._take_while_held)

    def reported(self) -> list[str]:
        before = len(self.script.printed)
        self.loop._report_progress()
        self.script.donnie.session.hub.wait_until_delivered(TIMEOUT)
        return self.script.printed[before:]


@pytest.fixture
def prompt(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., Prompt]]:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    made: list[Script] = []

    def one(*lines: str, world: str = "open_floor", speed: float | None = None) -> Prompt:
        settings = Settings(world=world, speed=speed, speech="off", sound=False)
        script = Script(assemble(settings, terminal=True))
        script.interaction.until_over = script.rest
        script.ctx.workspace.begin_with(script.donnie.session.name)
        script.ctx.workspace.replace("".join(f"{each}\n" for each in lines), None, in_file="")
        made.append(script)
        return Prompt(script)

    yield one
    for each in made:
        each.close()
        each.donnie.close()


# --- at the prompt


def test_lines_wait_until_an_empty_one_runs_them_but_no_part_of_a_block(
    prompt: Callable[..., Prompt],
) -> None:
    it = prompt()
    still_open = ["REPEAT in line 2 is still open."]
    for typed, answers, waiting in (
        ("FW 2", [], 1),
        ("", ["I walked 2 steps forward."], 0),
        ("", [], 0),
        ("REPEAT 2 TIMES", [], 1),
        ("  FW 1", [], 2),
        ("", still_open, 2),
        ("   ", still_open, 2),
        ("WHERE", ["Position 0, 2. Facing north."], 2),
        ("WHER", ["I do not know WHER. Did you mean WHERE?"], 2),
        ("END REPEAT", [], 3),
        ("", ["I walked 1 step forward."] * 2, 0),
        ("FWD 1", [], 1),
    ):
        assert (typed, it.take(typed), it.ctx.program.waiting) == (typed, answers, waiting)
    assert [it.lines.take(each) for each in ("FW 1", "WHERE", "WHER", "")] == [True, False, False, False]


def test_an_else_if_that_leaves_a_block_open_is_explained(prompt: Callable[..., Prompt]) -> None:
    it = prompt()
    it.take("IF 1 == 1 THEN")
    it.take("ELSE IF 2 == 2 THEN")

    assert it.take("") == ["IF in line 2 is still open.", "ELSE IF needs another END IF."]


def test_a_mistake_in_an_open_block_is_reported(prompt: Callable[..., Prompt]) -> None:
    it = prompt()
    it.take("REPEAT 2 TIMES")
    it.take("FWD 1")

    assert "Line 2: FWD 1" in it.take("")


@pytest.mark.parametrize(
    ("lines", "opener"),
    [(("REPEAT 2 TIMES", "SPEAK 1 +"), "REPEAT"), (("IF 1 == 1",), "IF"), (("REPEAT 2",), "REPEAT")],
)
def test_a_block_that_ends_within_a_line_is_only_open(
    prompt: Callable[..., Prompt], lines: tuple[str, ...], opener: str
) -> None:
    it = prompt()
    for line in lines:
        it.take(line)

    assert it.take("") == [f"{opener} in line 1 is still open."]


def test_escape_runs_all_at_once(prompt: Callable[..., Prompt]) -> None:
    it = prompt()
    it.take("FW 1")

    assert it.said(lambda: it.lines.take_and_run("FW 2")) == [
        *("I walked 1 step forward.", "I walked 2 steps forward."),
    ]
    it.take("FW 3")
    assert it.said(lambda: it.lines.take_and_run("  ")) == ["I walked 3 steps forward."]
    it.take("FW 4")
    assert it.said(lambda: it.lines.take_and_run("WHERE")) == ["Position 0, 6. Facing north."]
    assert it.ctx.program.waiting == 1


def test_where_enter_runs_each_complete_line_runs_at_once(prompt: Callable[..., Prompt]) -> None:
    it = prompt()
    it.settings = Settings(enter="runs")

    assert it.take("FW 1") == ["I walked 1 step forward."]
    assert it.take("REPEAT 2 TIMES") == it.take("FW 1") == []
    assert it.take("END REPEAT") == ["I walked 1 step forward."] * 2


def test_an_empty_line_continues_once_if_no_line_waits(prompt: Callable[..., Prompt]) -> None:
    it, called = prompt(), list[str]()
    it.lines.continuation = lambda: called.append("continued")
    it.take("FW 1")
    it.take("")
    assert called == []
    it.take("")
    it.take("")
    assert called == ["continued"]


def test_a_line_that_does_not_fit_is_refused(prompt: Callable[..., Prompt]) -> None:
    it = prompt()

    assert it.take("x" * (8 * 1024 * 1024 + 1)) == ["The program is too long. That line is lost."]
    assert it.ctx.program.lines == ()


# --- while a program is held

HELD = ("FW 1", "TR 90", "SPEAK 3")
REST = ["I turned 90 degrees to the right.", "3"]


@pytest.mark.parametrize(
    ("line", "how", "answers", "state", "did"),
    [
        ("", How.ENTER, [REST[0], "Line 3: SPEAK 3"], RunState.PAUSED, []),
        (" where ", How.ENTER, ["Position 0, 1. Facing north."], RunState.PAUSED, []),
        (
            *("FW 1", How.ENTER),
            ["I can't do this now: FW 1", "Enter continues. RUN runs the rest. STOP ends."],
            *(RunState.PAUSED, []),
        ),
        (
            *("x" * 41, How.ENTER),
            [f"I can't do this now: {'x' * 39}…", "Enter continues. RUN runs the rest. STOP ends."],
            *(RunState.PAUSED, []),
        ),
        ("STEPP", How.ENTER, ["I do not know STEPP. Did you mean STEP?"], RunState.PAUSED, []),
        ("", How.TOO_LONG, ["The program is too long. That line is lost."], RunState.PAUSED, []),
        ("QUIT", How.ENTER, [], RunState.PAUSED, ["leave 0"]),
        ("exit", How.ENTER, [], RunState.PAUSED, ["leave 0"]),
        ("RUN", How.ENTER, REST, RunState.READY, []),
        ("", How.ESCAPE, REST, RunState.READY, []),
        ("zz", How.ESCAPE, REST, RunState.READY, []),
        ("", How.INTERRUPTED, ["Stopped at line 2."], RunState.READY, []),
        ("zz", How.CLOSED, ["Stopped at line 2."], RunState.READY, []),
        ("STOP", How.ENTER, ["Stopped at line 2."], RunState.READY, []),
    ],
)
def test_a_held_program_is_continued_stepped_or_ended(
    prompt: Callable[..., Prompt], line: str, how: How, answers: list[str], state: RunState, did: list[str]
) -> None:
    it = prompt(*HELD)
    it.said(lambda: it.script.answers_to("BREAK 2", "AGAIN"))

    assert it.held(line, how) == answers
    assert (it.ctx.runs.state, it.did) == (state, did)


def test_quit_ends_a_held_program_once_donnie_leaves(prompt: Callable[..., Prompt]) -> None:
    it = prompt(*HELD)
    it.said(lambda: it.script.answers_to("BREAK 2", "AGAIN"))
    it.leaving.code = 0

    assert it.held("QUIT") == ["Stopped at line 2."]


def test_a_held_program_ends_where_another_world_is_entered_or_a_page_is_turned(
    prompt: Callable[..., Prompt],
) -> None:
    it = prompt(*HELD)
    it.said(lambda: it.script.answers_to("BREAK 2", "AGAIN"))
    it.leaving.world = "maze"
    assert it.held("WHERE") == ["Position 0, 1. Facing north.", "Stopped at line 2."]

    it = prompt(*HELD)
    it.said(lambda: it.script.answers_to("BREAK 2", "AGAIN"))
    it.loop.turns_page = lambda: True
    assert it.held("") == ["Stopped at line 2."]
    assert it.did == ["put back ''"]


def test_the_reading_place_is_the_line_at_which_the_program_is_newly_held(
    prompt: Callable[..., Prompt],
) -> None:
    it = prompt(*HELD)
    it.said(lambda: it.script.answers_to("BREAK 2", "AGAIN"))
    it.loop.on_change()
    it.held("WHERE")
    assert it.ctx.program.place == 2

    it.ctx.program.place = 1
    it.held("WHERE")
    assert it.ctx.program.place == 1
    it.held("STOP")


# --- while one runs


def test_a_command_for_the_running_program_is_taken_at_once(prompt: Callable[..., Prompt]) -> None:
    it = prompt("WAIT 1000", speed=1.0)
    typed = [None, "FW 1", "SPEED 5"]
    it.streams.editing = Part(take_ahead=lambda _: typed.pop(0))
    assert [it.loop._take_live() for _ in range(2)] == [False, False]
    assert it.loop._take_live()

    assert it.script.printed[-1] == "Speed 5."
    assert [*it.ctx.past.lines] == ["SPEED 5"]
    assert not it.ctx.is_urgent
    it.streams.takes_live_commands = False
    assert not it.loop._take_live()
    it.streams.takes_live_commands, it.streams.editing = True, None
    assert not it.loop._take_live()


LIVE = ("STOP", "STOP ALL", "ROBOTS", "PAUSE", "SLOWER", "FASTER", "SPEED 3", "QUIET", "CONTINUE")


@pytest.mark.parametrize("line", [*LIVE, "WHERE", "FW 1", "", "SAVE"])
def test_few_commands_are_for_the_running_program(prompt: Callable[..., Prompt], line: str) -> None:
    it = prompt(*HELD)
    assert it.loop._is_live(line) == (line in LIVE)


def test_continue_is_for_the_prompt_where_the_program_can_be_stepped(prompt: Callable[..., Prompt]) -> None:
    it = prompt(*HELD)
    it.said(lambda: it.script.answers_to("BREAK 2", "AGAIN"))

    assert not it.loop._is_live("CONTINUE")
    it.held("STOP")


TO, ORIGIN = Pose(3, 4, 0), Pose(0, 0, 0)
RUNNING, PAUSED = RunState.RUNNING, RunState.PAUSED


@pytest.mark.parametrize(
    ("program", "line", "state", "pose", "before", "answer"),
    [
        ("FW 5000", 1, RUNNING, ORIGIN, ORIGIN, "Still at line 1: FW 5000"),
        ("FW 5000", 1, RUNNING, Pose(0, 0.4, 0), ORIGIN, "Still at line 1: FW 5000"),
        ("FW 5000", 1, RUNNING, TO, None, "Still at line 1: FW 5000"),
        ("FW 5000", 1, RUNNING, TO, ORIGIN, "Still walking, 5 of 5000 steps."),
        ("FW 5000", 1, RUNNING, TO, Pose(3, 0, 0), "Still walking, 4 of 5000 steps."),
        ("FW 5000", 1, RUNNING, Pose(0, 1, 0), ORIGIN, "Still walking, 1 of 5000 steps."),
        ("FW a", 1, RUNNING, TO, ORIGIN, "Still walking, 5 steps so far."),
        ("TR 90", 1, RUNNING, TO, ORIGIN, "Still walking, 5 steps so far."),
        ("FW 5 FW 6", 1, RUNNING, TO, ORIGIN, "Still walking, 5 steps so far."),
        ("FW 1", 2, RUNNING, ORIGIN, ORIGIN, "Still running."),
        ("FW 1", 0, RUNNING, ORIGIN, ORIGIN, "Still reading the program."),
        ("FW 1", 1, PAUSED, TO, ORIGIN, "Paused. Type CONTINUE to go on."),
    ],
)
def test_a_report_says_how_far_the_robot_is(
    prompt: Callable[..., Prompt],
    monkeypatch: pytest.MonkeyPatch,
    program: str,
    line: int,
    state: RunState,
    pose: Pose,
    before: Pose | None,
    answer: str,
) -> None:
    it = prompt()
    it.ctx.program.add(program)
    frames = (Part(line=line),) if line else ()
    monkeypatch.setattr(it.loop, "_runs", Part(state=state, frames=frames))
    session = Part(run=object(), pose=pose)
    ctx = Part(
        donnie=Part(session=session), program=it.ctx.program, answer=it.ctx.answer,
        answer_of_robot=it.ctx.answer, trail=Part(last_pose=before),
    )  # fmt: skip
    monkeypatch.setattr(it.loop, "_ctx", ctx)

    assert it.reported() == [answer]


def test_a_report_after_the_own_run_names_a_robot_that_still_runs(
    prompt: Callable[..., Prompt], monkeypatch: pytest.MonkeyPatch
) -> None:
    it, said = prompt(), list[str]()
    running = [Part(hub=Part(robot="bob"))]
    donnie = Part(session=Part(run=None), team=Part(running=running))
    monkeypatch.setattr(it.loop, "_ctx", Part(donnie=donnie, words=it.ctx.words, say=said.append))
    it.reported()
    running.clear()
    it.reported()

    assert said == ["bob: Still running."]


# --- stopping


def test_ctrl_c_stops_and_leaves_the_line_to_a_terminal_that_has_shown_it(
    prompt: Callable[..., Prompt], monkeypatch: pytest.MonkeyPatch
) -> None:
    it = prompt()
    team = Part(stop=lambda: it.did.append("stop all"))
    donnie = Part(session=Part(stop=lambda: it.did.append("stop")), team=team)
    monkeypatch.setattr(it.loop, "_ctx", Part(donnie=donnie))
    monkeypatch.setattr(it.loop, "_runs", Part(note_stop=lambda: it.did.append("noted")))
    it.loop._on_interrupt()
    it.loop._stop_at_once()
    assert it.did == ["noted", "stop", "stop all", "noted", "stop"]

    it.did.clear()
    it.loop._stopping, it.streams.can_edit = True, False
    it.loop._on_interrupt()
    it.loop._stop_at_once()
    assert it.did == ["newline held", "stop all"]
    it.did.clear()
    it.streams.is_attended = False
    it.loop._on_interrupt()
    assert it.did == ["stop all"]


@pytest.mark.parametrize(
    ("is_real", "is_stopping", "did"),
    [(False, False, []), (True, False, ["noted", "stop", "stands"]), (True, True, ["stands"])],
)
def test_a_real_robot_stands_before_donnie_is_suspended(
    prompt: Callable[..., Prompt],
    monkeypatch: pytest.MonkeyPatch,
    is_real: bool,
    is_stopping: bool,
    did: list[str],
) -> None:
    it = prompt()
    connection = Part(is_real=is_real, wait_until_standing=lambda: it.did.append("stands"))
    donnie = Part(session=Part(stop=lambda: it.did.append("stop")), connection=connection)
    monkeypatch.setattr(it.loop, "_ctx", Part(donnie=donnie))
    monkeypatch.setattr(it.loop, "_runs", Part(note_stop=lambda: it.did.append("noted")))
    it.loop._stopping = is_stopping
    it.loop._stop_real_robot()

    assert it.did == did
    assert it.loop._was_suspended == (is_real and not is_stopping)


# --- what the loop does around a run


def test_a_typed_block_chimes_as_it_opens_and_closes_where_a_learner_types(
    prompt: Callable[..., Prompt], monkeypatch: pytest.MonkeyPatch
) -> None:
    it, chimed = prompt(), list[tuple[int, int]]()
    audible = type(it.ctx.donnie.outlets.audible)
    monkeypatch.setattr(sound, "chime_block", lambda _, before, after: chimed.append((before, after)))
    it.take("REPEAT 2 TIMES")
    assert chimed == []
    monkeypatch.setattr(audible, "has_cues", property(lambda _: True))
    for line in ("FW 1", "REPEAT 3 TIMES", "END REPEAT"):
        it.take(line)
    it.streams.is_attended = False
    it.take("END REPEAT")

    assert chimed == [(1, 1), (1, 2), (2, 1)]


def test_a_wrong_line_that_is_typed_again_is_replaced(prompt: Callable[..., Prompt]) -> None:
    it = prompt()
    for line in ("FWD 1", "TR 90", ""):
        it.take(line)

    assert it.take("FW 1") == ["Line 1 replaced. 2 lines wait."]
    assert it.ctx.program.lines == ("FW 1", "TR 90")


def test_while_runs_are_followed_their_lines_are_held_back_in_their_order(
    prompt: Callable[..., Prompt], monkeypatch: pytest.MonkeyPatch
) -> None:
    it, followed = prompt(), list[Any]()
    queue, background = it.streams.queue, it.loop._background

    def follow(run: object) -> None:
        followed.append((it.loop._robot, run, queue.holds_back, background.is_following))
        if run == "c":
            raise ZeroDivisionError

    monkeypatch.setattr(it.loop, "_follow", follow)
    it.loop._stopping, it.loop._left_out = True, 7
    runs: Any = [("alice", "a"), (None, "b"), ("bob", "c")]
    with pytest.raises(ZeroDivisionError):
        it.loop.follow(runs)

    assert followed == [("alice", "a", True, True), (None, "b", True, True), ("bob", "c", True, True)]
    assert (queue.holds_back, background.is_following) == (False, False)
    assert (it.loop._stopping, it.loop._left_out) == (False, 0)


@pytest.mark.parametrize(
    ("is_following", "is_due", "has_news"),
    [(False, True, True), (True, True, False), (False, False, False)],
)
def test_a_change_of_a_run_wakes_the_prompt_and_a_verdict_in_the_background_is_news(
    prompt: Callable[..., Prompt],
    monkeypatch: pytest.MonkeyPatch,
    is_following: bool,
    is_due: bool,
    has_news: bool,
) -> None:
    it, console = prompt(), Part(has_news=False, nudge=lambda: it.did.append("nudged"))
    monkeypatch.setattr(it.loop, "_console", console)
    monkeypatch.setattr(it.loop, "_runs", Part(is_verdict_due=is_due))
    it.loop._background.is_following = is_following
    it.loop.on_change()

    assert (it.did, console.has_news) == (["nudged"], has_news)


def test_the_place_is_the_line_of_a_hold_that_is_not_announced_yet(prompt: Callable[..., Prompt]) -> None:
    """The thread of the program may be slow: ``on_change`` was not called here."""
    it = prompt("FW 1", "TR 90", "SPEAK 3")
    it.said(lambda: it.script.answers_to("BREAK 2", "AGAIN"))

    assert it.held("COPY")[0] == "Line 3: TR 90"
    it.held("READ 1")
    assert it.held("COPY")[0] == "Line 2: FW 1", "the learner has left the line"
    it.held("STOP")


def test_before_a_stop_the_last_lines_need_not_wait_and_after_it_few_are_left(
    prompt: Callable[..., Prompt],
) -> None:
    it = prompt()
    it.streams.queue.hold_back()
    it.loop.before_stop()
    assert (it.loop._stopping, it.loop._printer.is_hurrying, it.streams.queue.holds_back) == (
        *(True, True, False),
    )
    it.loop.after_stop()
    assert it.did == ["trimmed"]


@pytest.mark.parametrize(
    ("stopping", "suspended", "outcome", "said"),
    [
        (True, True, Outcome.STOPPED, ["2 lines left out.", "SUSPENDED"]),
        (False, False, Outcome.STOPPED, []),
        (False, True, Outcome.COMPLETED, []),
    ],
)
def test_a_run_is_summed_up_with_what_was_left_out_and_that_it_was_suspended(
    prompt: Callable[..., Prompt],
    monkeypatch: pytest.MonkeyPatch,
    stopping: bool,
    suspended: bool,
    outcome: Outcome,
    said: list[str],
) -> None:
    it, summed, answers = prompt(), list[Any](), list[tuple[str, dict[str, object]]]()
    monkeypatch.setattr(it.loop, "_runs", Part(sum_up=summed.append))
    monkeypatch.setattr(it.loop, "_ctx", Part(answer=lambda code, **values: answers.append((code, values))))
    it.loop._stopping, it.loop._was_suspended, it.loop._robot = stopping, suspended, "bob"
    it.streams.queue.put(["1", "2", "3", "4", "5"])
    it.loop._sum_up(Part(outcome=outcome))  # type: ignore[arg-type]

    left_out = [("answer-left-out", {"lines": 2})] if stopping else []
    assert answers == left_out + ([("suspended-stopped", {})] if len(said) > 1 else [])
    assert summed == ["bob"]
    assert it.loop._left_out == 0
    assert len(it.streams.queue) == (3 if stopping else 5)


@pytest.mark.parametrize(
    ("progress", "first", "later"), [("0", 1e9, 1e9), ("2", 3.0, 3.0), ("3", 3.0, 3.0), ("4", 3.0, 4.0)]
)
def test_a_silent_run_is_reported_after_three_seconds_and_then_as_set(
    prompt: Callable[..., Prompt], progress: str, first: float, later: float
) -> None:
    it = prompt()
    it.settings, it.time = Settings(progress=progress), 10.0
    it.loop._expect_report(3.0)
    assert it.loop._report_due == 10.0 + first
    it.loop._expect_next_report()
    assert it.loop._report_due == 10.0 + later


@pytest.mark.parametrize(("lines", "left"), [(18, 0), (19, 1)])
def test_of_what_a_program_printed_before_it_was_held_the_last_block_is_printed(
    prompt: Callable[..., Prompt], lines: int, left: int
) -> None:
    it = prompt(*HELD)
    it.said(lambda: it.script.answers_to("BREAK 2", "AGAIN"))
    it.streams.queue.put([str(number) for number in range(lines)])
    said = it.held("WHERE")

    assert len(it.streams.queue) == 18
    assert [each for each in said if "left out" in each] == [f"{left} line was left out."] * left
    it.streams.queue.put(["of a command"])
    it.held("WHERE")
    assert len(it.streams.queue) == 19, "only a program's lines are left out"
    it.held("STOP")


@pytest.mark.parametrize(
    ("ended", "interrupted", "leaving", "held", "stopping", "is_woken"),
    [
        (False, False, None, False, False, False),
        (True, False, None, False, False, True),
        (False, True, None, False, False, True),
        (False, False, 15, False, False, True),
        (False, False, None, True, False, True),
        (False, False, None, True, True, False),
        (False, False, None, False, True, False),
        (False, True, None, True, True, True),
    ],
)
def test_what_happened_while_keys_were_looked_for_is_no_reason_to_wait(
    prompt: Callable[..., Prompt],
    monkeypatch: pytest.MonkeyPatch,
    ended: bool,
    interrupted: bool,
    leaving: int | None,
    held: bool,
    stopping: bool,
    is_woken: bool,
) -> None:
    it = prompt()
    monkeypatch.setattr(it.loop, "_runs", Part(has_ended=lambda _: ended, is_held=held))
    monkeypatch.setattr(it.loop, "_console", Part(interrupted=interrupted, leaving=leaving))
    it.loop._stopping = stopping

    assert it.loop._is_woken() is is_woken


@pytest.mark.parametrize(
    ("ended", "interrupted", "woken_after", "waits"),
    [
        (False, False, 1.0, [GRACE]),
        (False, False, 0.5, [GRACE, GRACE / 2, GRACE / 4]),
        (True, False, 1.0, []),
        (False, True, 1.0, []),
    ],
)
def test_lines_that_follow_at_once_are_waited_for(
    prompt: Callable[..., Prompt],
    monkeypatch: pytest.MonkeyPatch,
    ended: bool,
    interrupted: bool,
    woken_after: float,
    waits: list[float],
) -> None:
    it, waited = prompt(), list[float]()
    console = Part(now=lambda: it.time, interrupted=interrupted)

    def wait(seconds: float) -> None:
        waited.append(seconds)
        it.time += seconds * woken_after
        console.interrupted = len(waited) == 3

    console.wait = wait
    monkeypatch.setattr(it.loop, "_console", console)
    monkeypatch.setattr(it.loop, "_runs", Part(has_ended=lambda _: ended))
    it.loop._wait_for_more()

    assert waited == pytest.approx(waits)


@pytest.mark.parametrize(
    ("live", "lines", "stopping", "ended", "due", "did", "left_out"),
    [
        (True, 1, False, False, 5.0, ["block"], 0),
        (True, 1, True, False, 5.0, [], 0),
        (False, 1, False, False, 5.0, ["grace", "block", "later"], 2),
        (False, 1, False, True, 5.0, ["grace"], 0),
        (False, 0, False, False, 0.0, ["report", "show", "later"], 0),
        (False, 1, True, False, 0.0, ["report", "show", "later"], 0),
        (False, 0, False, False, 5.0, ["wait 1.0 keys"], 0),
        (False, 0, False, False, 0.5, ["wait 0.5 keys"], 0),
        (False, 5, True, False, 5.0, ["wait 1.0 keys"], 2),
        (False, 0, False, True, 5.0, [], 0),
    ],
)
def test_a_block_is_printed_or_progress_reported_or_waited(
    prompt: Callable[..., Prompt],
    monkeypatch: pytest.MonkeyPatch,
    live: bool,
    lines: int,
    stopping: bool,
    ended: bool,
    due: float,
    did: list[str],
    left_out: int,
) -> None:
    it = prompt()

    def note(what: str, returns: int = 0) -> Callable[[], int]:
        return lambda: it.did.append(what) or returns  # type: ignore[func-returns-value]

    it.streams.queue.put([str(number) for number in range(lines)])
    monkeypatch.setattr(it.loop, "_runs", Part(has_ended=lambda _: ended, is_held=False))
    monkeypatch.setattr(it.loop, "_printer", Part(show_block=note("block", 2), show=note("show")))
    it.streams.console.wait = lambda seconds, *, reading: it.did.append(
        f"wait {seconds} {'keys' if reading else ''}"
    )
    for name, what in (
        *(("_wait_for_more", "grace"), ("_report_progress", "report"), ("_expect_next_report", "later")),
    ):
        monkeypatch.setattr(it.loop, name, note(what))
    monkeypatch.setattr(it.loop, "_take_live", lambda: live)
    it.loop._stopping, it.loop._report_due = stopping, due
    it.loop._print_pending()

    assert (it.did, it.loop._left_out) == (did, left_out)


@pytest.mark.parametrize(
    ("leaving", "interrupts", "held", "stopping", "ends", "outcome", "did"),
    [
        (None, 0, False, False, "over", Outcome.COMPLETED, ["pending", "stand", "sum"]),
        (None, 0, False, False, "over", Outcome.QUIT, ["pending", "stand", "sum"]),
        (None, 0, False, False, "ended", Outcome.COMPLETED, ["pending", "waited 2.5", "stand", "sum"]),
        (None, 1, False, False, "over", Outcome.COMPLETED, ["interrupt", "stand", "sum"]),
        (None, 0, True, False, "over", Outcome.COMPLETED, ["ask", "stand", "sum"]),
        (None, 0, True, True, "over", Outcome.STOPPED, ["pending", "stand", "sum"]),
        (None, 2, True, True, "over", Outcome.STOPPED, ["interrupt", "interrupt", "stand", "sum"]),
        (15, 0, True, False, "over", Outcome.STOPPED, ["stop", "waited 2.5", "stand"]),
    ],
)
def test_a_run_is_followed_to_its_end_and_then_summed_up(
    prompt: Callable[..., Prompt],
    monkeypatch: pytest.MonkeyPatch,
    leaving: int | None,
    interrupts: int,
    held: bool,
    stopping: bool,
    ends: str,
    outcome: Outcome,
    did: list[str],
) -> None:
    it, left = prompt(), [interrupts]
    console = it.streams.console

    def take_interrupt() -> bool:
        left[0] -= 1
        return left[0] >= 0

    def act(what: str) -> Callable[[], None]:
        def noted() -> None:
            assert console.stop_at_once == it.loop._stop_at_once
            assert console.before_suspending == it.loop._stop_real_robot
            it.did.append(what)

        return noted

    def note(what: str) -> Callable[..., bool]:
        return lambda *given: it.did.append(" ".join(map(str, (what, *given)))) or True  # type: ignore[func-returns-value]

    class Running(Part):
        @property
        def is_over(self) -> bool:
            return ends == "over" and bool(it.did)

    console.leaving, console.take_interrupt, console.pressed_interrupt = (
        leaving,
        take_interrupt,
        take_interrupt,
    )
    runs = Part(is_held=held, has_ended=lambda _: ends == "ended" and bool(it.did))
    monkeypatch.setattr(it.loop, "_runs", runs)
    donnie = Part(stop_real_robot=bool, team=Part(wait_for_stop=note("stand")))
    monkeypatch.setattr(it.loop, "_ctx", Part(donnie=donnie))
    for name, what in (("_take_while_held", "ask"), ("_print_pending", "pending"), ("_stop", "stop")):
        monkeypatch.setattr(it.loop, name, act(what))
    monkeypatch.setattr(it.loop, "_on_interrupt", note("interrupt"))
    monkeypatch.setattr(it.loop, "_sum_up", lambda _: it.did.append("sum"))
    it.loop._stopping, it.loop._was_suspended = stopping, True
    it.loop._follow(Running(outcome=outcome, wait=note("waited")))  # type: ignore[arg-type]

    assert it.did == did
    assert it.leaving.code == (0 if outcome is Outcome.QUIT else None)
    assert console.before_suspending is donnie.stop_real_robot
    assert console.stop_at_once != it.loop._stop_at_once
    assert (it.loop._was_suspended, it.loop._report_due) == (False, 3.0)


def test_a_closed_loop_takes_no_more_changes(
    prompt: Callable[..., Prompt], monkeypatch: pytest.MonkeyPatch
) -> None:
    it = prompt()
    monkeypatch.setattr(it.loop, "_runs", Part(close=lambda: it.did.append("closed")))
    monkeypatch.setattr(it.loop, "_remove_gate", lambda: it.did.append("gate removed"))
    it.loop.close()

    assert it.did == ["closed", "gate removed"]


def test_robots_in_the_background_are_stopped_by_the_command_and_what_is_left_out_is_said_once(
    prompt: Callable[..., Prompt],
) -> None:
    it = prompt()
    background = BackgroundRobots(it.ctx, it.streams.queue)

    assert it.said(background.stop) == ["Nothing is running."]
    assert it.said(background.trim_after_stop) == []
    it.said(lambda: background.stop(4))
    assert it.said(background.trim_after_stop) == ["4 lines were left out."]
    assert it.said(background.trim_after_stop) == []
