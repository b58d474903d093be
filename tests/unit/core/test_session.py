"""A session runs one program at a time, from its first event to its last."""

import gc
import threading
import tracemalloc

import pytest

from devices.ports.robot import Bearing, Pose
from donnie_tui import __version__
from donnie_tui.core import session as sessions
from donnie_tui.core.events import (
    INTERNAL,
    TRANSIENT,
    Announced,
    CueSounded,
    Error,
    Event,
    HowStarted,
    Outcome,
    Read,
    Reset,
    RunEnded,
    RunStarted,
    Sensed,
    Spoke,
    Stamped,
    Statement,
    Waited,
)
from donnie_tui.core.runner import Run
from donnie_tui.core.session import Busy, RunOptions
from donnie_tui.core.timeline import Chronicle, Timeline, Trail
from donnie_tui.core.transcript import History
from language.compiler import compile_program
from language.parser import parse
from language.syntax import Program
from tests.floor import Floor
from tests.timeouts import TIMEOUT

ENDLESS = "WHILE 1 == 1 DO WAIT 1 END WHILE"


def of(kind: type[Event], floor: Floor) -> list[Event]:
    return [each for each in floor.events if isinstance(each, kind)]


def test_a_run_begins_and_ends_with_its_events() -> None:
    floor = Floor()

    outcome = floor.run("VAR a = 2 FW a")

    assert outcome is Outcome.COMPLETED
    assert isinstance(floor.events[0], RunStarted)
    assert of(RunEnded, floor) == [RunEnded(Outcome.COMPLETED, Pose(0.0, 2.0, 0.0), {"a": 2}, 2.0)]


def test_a_program_with_mistakes_of_form_does_nothing_and_reports_all_of_them() -> None:
    floor = Floor()

    outcome = floor.run("FW 1\nFWD 2\nTR $ 90")

    assert outcome is Outcome.FAILED
    assert [(each.kind, each.line) for each in of(Error, floor) if isinstance(each, Error)] == [
        ("unknown-command", 2),
        ("unknown-character", 3),
    ]
    assert floor.session.pose == Pose(0.0, 0.0, 0.0)


def test_the_last_sentence_says_that_only_the_first_mistakes_are_reported() -> None:
    floor = Floor()

    floor.run("JUMP\n" * 101)

    assert len(of(Error, floor)) == 100
    assert floor.printed[-1] == "Only the first 100 mistakes are listed."


def test_a_mistake_of_meaning_undoes_nothing() -> None:
    floor = Floor()

    floor.run('SPEAK "a"\nFW 2\nSPEAK q\nFW 9')

    assert of(Spoke, floor) == [Spoke("a")]
    assert floor.session.pose.y == 2.0
    assert floor.printed[-3:] == [
        "Error, line 3, column 7: There is no variable q.",
        "Line 3: SPEAK q",
        "Write VAR q first.",
    ]


def test_at_detail_full_a_mistake_names_the_calls_that_led_there() -> None:
    floor = Floor(detail="full")

    floor.run("PROCEDURE A: n DO\nSPEAK 1 / n\nEND PROCEDURE\nPROCEDURE B DO\nA [0]\nEND PROCEDURE\nB []")

    assert floor.printed[-2:] == ["Called from line 5.", "Called from line 7."]


def test_pose_and_variables_stay_unless_the_run_is_fresh() -> None:
    floor = Floor(terminal=True)

    floor.run("VAR a = 2 FW a")
    floor.run("SPEAK a FW a")
    assert floor.session.pose.y == 4.0
    assert floor.session.variables == {"a": 2}

    floor.run("FW 1", fresh=True)
    assert floor.session.pose.y == 1.0
    assert floor.session.variables == {}


def test_a_program_that_can_not_run_resets_nothing() -> None:
    floor = Floor(terminal=True)
    floor.run("VAR a = 2 FW a TR 90")
    floor.run("FW 1\nFWD 2", fresh=True)
    timeline = Timeline([each for each in floor.stream if not isinstance(each.event, TRANSIENT)])
    timeline.go_to(len(timeline))

    assert floor.session.pose == Pose(0.0, 2.0, 90.0)
    assert floor.session.variables == {"a": 2}
    assert len(timeline.trail()) > 2
    floor.run("HISTORY")
    assert floor.printed[-1] != "There is no movement so far."


def test_a_name_declared_again_in_a_terminal_is_new_and_that_is_reported() -> None:
    floor = Floor(terminal=True)

    floor.run("VAR a = 2")
    outcome = floor.run("VAR a = 3")

    assert outcome is Outcome.COMPLETED
    assert floor.printed == ["a had a value. It has a new one now."]


def test_time_begins_anew_with_each_run() -> None:
    floor = Floor()

    floor.run("FW 3")
    floor.run("WAIT 2")

    assert [each.t for each in floor.stream if isinstance(each.event, RunStarted)] == [0.0, 0.0]
    assert floor.stream[-1].t == pytest.approx(2.0)


def test_quit_ends_the_session_in_a_terminal_and_is_a_mistake_in_a_file() -> None:
    assert Floor(terminal=True).run("QUIT") is Outcome.QUIT
    assert Floor().run("QUIT") is Outcome.FAILED


def test_one_program_runs_at_a_time() -> None:
    floor = Floor(speed=1.0)
    run = floor.session.start(ENDLESS, "test.gd")

    with pytest.raises(Busy):
        floor.session.start("FW 1", "other.gd")
    with pytest.raises(Busy):
        floor.session.reset()
    floor.session.stop()

    assert run.wait(TIMEOUT)
    assert run.outcome is Outcome.STOPPED


def test_a_run_that_could_not_begin_blocks_no_other_run() -> None:
    floor = Floor()

    def fail(_: object) -> None:
        raise RuntimeError

    with pytest.raises(RuntimeError):
        floor.session.start("FW 1", "a.gd", prepare=fail)

    run = floor.session.start("FW 1", "a.gd")
    assert run.wait(TIMEOUT)
    assert run.outcome is Outcome.COMPLETED


@pytest.mark.parametrize("hooked", [True, False])
def test_a_stop_in_the_middle_of_a_movement_halts_the_robot_and_ends_the_run(hooked: bool) -> None:
    floor = Floor(speed=1.0)
    moving = threading.Event()
    floor.session.hub.subscribe(lambda stamped: moving.set() if _is_step(stamped) else None)
    run = floor.session.start("FW 1000", "test.gd", RunOptions(hooked=hooked))

    assert moving.wait(TIMEOUT)
    floor.session.stop()

    assert run.wait(TIMEOUT)
    assert run.outcome is Outcome.STOPPED
    assert "I was stopped." in floor.printed[-1]
    assert floor.session.pose.y < 1000


def _is_step(stamped: Stamped) -> bool:
    return isinstance(stamped.event, CueSounded) and stamped.event.name == "step-forward"


def test_a_trace_has_an_event_for_each_statement_before_it() -> None:
    floor = Floor()

    floor.run("REPEAT 2 TIMES\nFW 1\nEND REPEAT", trace=True)

    lines = [each.line for each in of(Statement, floor) if isinstance(each, Statement)]
    assert lines[0] == 1
    assert lines.count(2) == 2


def test_without_trace_there_are_no_statements() -> None:
    floor = Floor()
    floor.run("FW 1", hooked=True)

    assert of(Statement, floor) == []


def test_a_wait_publishes_its_seconds_and_a_negative_one_takes_no_time() -> None:
    floor = Floor()
    floor.run("WAIT 3 WAIT -3")

    assert of(Waited, floor) == [Waited(3), Waited(0)]


@pytest.mark.parametrize("command", ["FW 2000000000", "TR -2000000000", "WAIT 2000000000"])
def test_a_command_that_no_robot_can_execute_is_refused(command: str) -> None:
    floor = Floor()

    assert floor.run(command) is Outcome.FAILED
    assert [each.kind for each in of(Error, floor) if isinstance(each, Error)] == ["number-too-large"]


@pytest.mark.parametrize("seconds", [1_000_000_000, 1_000_000_001])
def test_a_command_may_ask_for_a_milliard(seconds: int) -> None:
    outcome = Outcome.COMPLETED if seconds == 1_000_000_000 else Outcome.FAILED

    assert Floor().run(f"WAIT {seconds}") is outcome


def test_a_wait_that_is_stopped_took_less_than_it_was_to_take() -> None:
    floor, waiting = Floor(speed=1.0, terminal=True), threading.Event()
    floor.session.hub.subscribe(lambda stamped: waiting.set() if _announces(stamped, "waiting") else None)
    run = floor.session.start("WAIT 100000", "test.gd")
    assert waiting.wait(TIMEOUT)
    floor.session.stop()

    assert run.wait(TIMEOUT)
    (waited,) = of(Waited, floor)
    assert isinstance(waited, Waited)
    assert waited.seconds < 100_000


def _announces(stamped: Stamped, code: str) -> bool:
    return isinstance(stamped.event, Announced) and stamped.event.code == code


def test_a_belt_that_is_off_gives_no_pulse() -> None:
    floor = Floor()

    assert floor.run("VIBRATE F") is Outcome.FAILED
    assert floor.printed[-1] == "BELT ON switches it on."


def test_the_reading_of_a_sensor_is_published() -> None:
    floor = Floor(("red", 0, 5))
    floor.run("SPEAK DISTANCE F SPEAK COLOR RED SPEAK POS y")

    assert of(Read, floor) == [
        Read("distance", "front", 5),
        Read("colour", "red", 1),
        Read("position", "y", 0),
    ]


def test_state_quotes_the_last_movement_as_it_was_typed() -> None:
    floor = Floor(("red", 0, 4))
    floor.run("STATE fw   2 STATE FORWARD 9 STATE")

    assert floor.printed == [
        "No command executed, position [0,0,0].",
        "I walked 2 steps forward.",
        "Command 1 was fw 2, walked 2, didn't crash, position [0,2,0].",
        "I walked only 1 step forward. I found an obstacle.",
        "Command 2 was FORWARD 9, walked 1, crashed, position [0,3,0].",
    ]


def test_history_lists_every_movement() -> None:
    floor = Floor()
    floor.run("FW 2 TR 90 HISTORY")

    assert floor.printed[2:] == [
        "Command 1 was FW 2, walked 2, didn't crash, position [0,2,0].",
        "Command 2 was TR 90, turned 90, didn't crash, position [0,2,90].",
    ]


@pytest.fixture
def short_history(monkeypatch: pytest.MonkeyPatch) -> int:
    """How many movements HISTORY remembers, and a trail."""
    monkeypatch.setattr(History.__init__, "__defaults__", (50,))
    monkeypatch.setattr(Trail.__init__, "__defaults__", (lambda: None, 50))
    return 50


def test_history_forgets_the_oldest_movements_and_says_how_many(short_history: int) -> None:
    floor = Floor()
    floor.run(f"REPEAT {short_history + 3} TIMES TR 1 END REPEAT")
    before = len(floor.printed)

    floor.run("HISTORY STATE")

    listed = floor.printed[before:]
    assert listed[0] == "3 earlier movements are forgotten."
    assert listed[1].startswith("Command 4 was TR 1, turned 1")
    assert len(listed) == 1 + short_history + 1
    assert listed[-1] == listed[-2]
    assert listed[-1].startswith(f"Command {short_history + 3} was TR 1")


@pytest.mark.usefixtures("short_history")
def test_movements_without_end_take_no_more_memory() -> None:
    """Without a bound the history alone takes 80 000 bytes each time.

    The least of three: a thread that an earlier test left may take some meanwhile.
    """
    floor, chronicle = Floor(), Chronicle(most=50)
    floor.session.hub.subscribe(chronicle)
    floor.run("REPEAT 60 TIMES TR 1 END REPEAT")

    def taken() -> int:
        tracemalloc.start()
        floor.run("REPEAT 400 TIMES TR 1 END REPEAT")
        floor.stream.clear()
        gc.collect()
        bytes_now, _ = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        return bytes_now

    assert min(taken() for _ in range(3)) < 60_000


def test_a_fresh_run_has_no_history() -> None:
    floor = Floor()
    floor.run("FW 2")
    floor.run("HISTORY", fresh=True)

    assert floor.printed[-1] == "No command executed, position [0,0,0]."


def test_closing_a_session_stops_its_run() -> None:
    floor = Floor(speed=1.0)
    run = floor.session.start(ENDLESS, "test.gd")

    floor.session.close()

    assert run.is_over
    assert run.outcome is Outcome.STOPPED


def test_a_change_of_robots_is_a_reset_if_anything_was_done() -> None:
    there = Floor()
    there.session.change_robot(None)
    there.session.change_robot(None)
    assert of(Reset, there) == []

    there.run("TR 360")
    there.session.change_robot(None)
    assert of(Reset, there) == [Reset(Pose(0, 0, 0))]


def test_an_internal_fault_is_reported_and_ends_the_run(caplog: pytest.LogCaptureFixture) -> None:
    floor = Floor()

    def fail(stamped: Stamped) -> None:
        if isinstance(stamped.event, Spoke):
            raise RuntimeError("a listener of Donnie")

    floor.session.hub.subscribe(fail)
    outcome = floor.run("FW 1\nSPEAK 1")

    assert outcome is Outcome.FAILED
    assert "Something went wrong inside Donnie." in "".join(floor.printed)
    assert "a listener of Donnie" in caplog.text


@pytest.mark.parametrize(
    ("text", "line", "quoted"),
    [("FW 1\n  FW 1 / 0", 6, "FW 1 / 0"), ("FW 1\nFWD 1", 6, "FWD 1"), ("FW 1 / 0", 5, "FW 1 / 0")],
)
def test_the_lines_of_a_batch_have_their_numbers_in_the_program(text: str, line: int, quoted: str) -> None:
    floor = Floor()
    run = floor.session.start(text, "typed", RunOptions(first_line=5))
    assert run.wait(TIMEOUT)

    (error,) = of(Error, floor)
    assert isinstance(error, Error)
    assert (error.line, error.source_line) == (line, quoted)


def test_a_mistake_quotes_its_line_after_any_strange_characters() -> None:
    floor = Floor()
    floor.run('SPEAK "a\x0cb\u2028c"\r\nSPEAK q')

    assert floor.printed[-2] == "Line 2: SPEAK q"


def test_check_reports_mistakes_or_otherwise_hints() -> None:
    session = Floor().session

    assert [each.kind.value for each in session.check("FWD 1")] == ["unknown-command"]
    assert [each.severity.value for each in session.check("DISTANCE F")] == ["hint"]
    assert session.check("FW 1") == ()


def test_a_program_that_is_stopped_while_it_is_parsed_is_not_compiled_and_does_not_run(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """To compile a long one takes seconds."""
    floor, compiled = Floor(), list[Program]()
    monkeypatch.setattr(sessions, "compile_program", lambda program, **_: compiled.append(program))

    run = floor.session.start("SPEAK 1", "a.gd", prepare=lambda control: control.stop())

    assert run.wait(TIMEOUT)
    assert run.outcome is Outcome.STOPPED
    assert (of(Spoke, floor), compiled) == ([], [])


def test_a_stop_ends_a_history_that_is_being_printed() -> None:
    floor = Floor()
    floor.session.hub.subscribe(
        lambda stamped: floor.session.stop() if getattr(stamped.event, "code", "") == "history" else None
    )

    outcome = floor.run("REPEAT 50 TIMES FW 1 END REPEAT HISTORY")

    assert outcome is Outcome.STOPPED
    assert sum(getattr(each, "code", "") == "history" for each in floor.events) == 1


# --- what a run is given, and what is known of it


def test_a_run_says_how_it_was_started() -> None:
    floor = Floor(language="pt", detail="brief", terminal=True, seed=3)
    floor.run("FW 2")
    run = floor.session.start("SPEAK 1\nTR 90", "b.gd", RunOptions(trace=True, first_line=4, terminal=False))
    assert run.wait(TIMEOUT)

    first, second = [each for each in of(RunStarted, floor) if isinstance(each, RunStarted)]
    assert (second.program, second.world, second.robot, second.seed) == ("b.gd", "floor", "donnie", 3)
    assert second.version == __version__
    assert first.how == HowStarted("FW 2", 1, False, True, False, Pose(0, 0, 0), "pt", "brief", False, ())
    assert second.how == HowStarted(
        *("SPEAK 1\nTR 90", 4, False, False, True, Pose(0, 2, 0), "pt", "brief", False, ())
    )


@pytest.mark.parametrize(("text", "is_refused"), [("FW 1", False), ("FWD 1", True)])
def test_a_run_begins_anew_only_if_it_is_not_refused(text: str, is_refused: bool) -> None:
    floor = Floor(terminal=True)
    floor.run("VAR a = 1\nFW 3")
    floor.run(text, fresh=True)
    started = of(RunStarted, floor)[-1]

    assert isinstance(started, RunStarted)
    assert started.how is not None
    assert (started.how.fresh, started.how.refused) == (True, is_refused)
    assert started.how.pose == Pose(0, 3 if is_refused else 0, 0)
    assert floor.session.variables == ({"a": 1} if is_refused else {})


def test_a_run_that_others_drive_can_not_be_repeated_and_may_begin_while_robots_are_taken() -> None:
    floor = Floor()
    floor.session.is_taken = lambda: True
    with pytest.raises(Busy):
        floor.session.start("FW 1", "a.gd")
    assert floor.session.run is None
    driver = compile_program(parse("SPEAK 7").program, terminal=False, hooked=False)  # type: ignore[arg-type]
    run = floor.session.start("FW 1", "a.gd", RunOptions(driver=driver))
    assert run.wait(TIMEOUT)

    (started,) = of(RunStarted, floor)
    assert isinstance(started, RunStarted)
    assert (started.how, of(Spoke, floor)) == (None, [Spoke("7")])


@pytest.mark.parametrize("hooked", [True, False])
def test_each_statement_is_looked_at_before_it_runs_if_the_run_can_be_stepped(hooked: bool) -> None:
    floor, places = Floor(), list[int]()
    run = floor.session.start(
        "FW 1\nFW 2",
        "a.gd",
        RunOptions(hooked=hooked),
        each_statement=lambda: places.append(floor.session.frames[0].line),
    )
    assert run.wait(TIMEOUT)

    assert places == ([1, 2] if hooked else [])
    assert (floor.session.run, floor.session.frames) == (None, ())


@pytest.mark.parametrize(("text", "is_refused"), [("FW 1", False), ("FWD 1", True)])
def test_it_is_known_whether_a_run_was_refused_before_anything_runs(text: str, is_refused: bool) -> None:
    floor, known = Floor(), list[object]()

    def when_read(run: Run) -> None:
        known.append((run.was_refused, [each for each in floor.events if isinstance(each, RunStarted)]))

    assert floor.session.start(text, "a.gd", when_read=when_read).wait(TIMEOUT)
    assert known == [(is_refused, [])]


def test_a_claimed_run_waits_until_it_begins_and_can_be_given_up() -> None:
    floor = Floor()
    run = floor.session.claim("FW 1", "a.gd")
    assert (floor.session.run, run.has_begun, floor.events) == (run, False, [])
    with pytest.raises(Busy):
        floor.session.claim("FW 2", "b.gd")
    floor.session.give_up(run)
    assert floor.session.run is None
    run = floor.session.claim("FW 3", "c.gd")
    floor.session.begin(run)
    assert run.wait(TIMEOUT)
    assert floor.session.pose == Pose(0, 3, 0)


def test_a_run_that_has_begun_is_stopped_where_it_is_given_up() -> None:
    floor = Floor(speed=1.0)
    run = floor.session.start(ENDLESS, "a.gd")
    floor.session.give_up(run)

    assert run.wait(TIMEOUT)
    assert run.outcome is Outcome.STOPPED


def test_only_the_end_of_a_stopped_program_is_waited_for() -> None:
    floor = Floor(speed=1.0)
    assert floor.session.wait_for_stop()
    floor.session.stop()  # nothing runs
    run = floor.session.start(ENDLESS, "a.gd")
    assert floor.session.wait_for_stop()
    assert not run.is_over
    floor.session.wait_until_acting(TIMEOUT)
    assert floor.session.frames[0].line == 1
    floor.session.stop()
    assert floor.session.wait_for_stop()
    assert run.is_over


def test_nothing_of_a_robot_changes_while_a_program_runs() -> None:
    floor = Floor(speed=1.0)
    run = floor.session.start(ENDLESS, "a.gd")
    with pytest.raises(Busy):
        floor.session.change_robot(None)
    floor.session.close()
    assert run.is_over


def test_a_reset_forgets_the_past_and_is_published_with_the_place() -> None:
    floor = Floor(terminal=True)
    floor.run("VAR a = 2\nFW a")
    assert floor.session.variables == {"a": 2}
    floor.session.variables["a"] = 9
    assert floor.session.variables == {"a": 2}
    floor.session.reset()

    assert (floor.session.variables, floor.session.pose) == ({}, Pose(0, 0, 0))
    assert floor.events[-1] == Reset(Pose(0, 0, 0))
    floor.run("STATE")
    assert floor.printed[-1] == "No command executed, position [0,0,0]."


def test_what_happens_before_the_first_run_of_a_robot_happens_at_zero() -> None:
    floor = Floor()
    floor.session.hub.publish(Spoke("1"))
    floor.run("WAIT 2")
    floor.session.hub.publish(Spoke("2"))
    floor.session.change_robot(None)
    floor.session.hub.publish(Spoke("3"))

    assert [each.t for each in floor.stream if isinstance(each.event, Spoke)] == [
        0.0,
        pytest.approx(2.0),
        0.0,
    ]


def test_another_robot_knows_nothing_of_the_first_one() -> None:
    floor = Floor(terminal=True)
    floor.run("VAR a = 1\nFW 2")
    floor.session.change_robot(None)
    assert (floor.session.variables, floor.session.pose) == ({}, Pose(0, 0, 0))
    floor.run("STATE")
    assert floor.printed[-1] == "No command executed, position [0,0,0]."


def test_a_screen_can_ask_for_the_distances_the_world_and_the_pace() -> None:
    floor = Floor(("red", 0, 4))
    session = floor.session
    session.publish_distances()

    (sensed,) = of(Sensed, floor)
    assert isinstance(sensed, Sensed)
    assert sensed.distances[Bearing.FRONT] == 4
    assert (session.world, session.name, session.colours) == ("floor", "donnie", {"red", "green", "blue"})
    assert session.speed is None
    session.speed = 2.0
    assert session.speed == 2.0
    assert session.takes_turns is True


def test_a_line_knows_what_was_declared_unless_it_begins_anew() -> None:
    floor = Floor(terminal=True)
    floor.run("PROCEDURE P DO\nFW 1\nEND PROCEDURE")
    known, anew = (floor.session.parse("P", fresh=fresh).diagnostics[0] for fresh in (False, True))
    assert ((known.code, known.meant), (anew.code, anew.meant)) == (("procedure", "P []"), ("", ""))
    (mistake,) = floor.session.parse("FW 1\nFWD 1", 7).diagnostics
    assert mistake.span.line == 8
    (unseen,) = floor.session.parse("SPEAK COLOR PINK").diagnostics
    assert unseen.code == "unseen-colour"


@pytest.mark.parametrize(
    ("text", "error"),
    [
        (
            "FW 1\n  FWD 2 ",
            ("unknown-command", 2, 3, "I do not know FWD.", "Did you mean FW?", "FWD 2", (), "", "FW", "", 0),
        ),
        (
            "IF 1 < 2\nFW 1 END IF",
            (
                *("syntax", 2, 1, "I expected THEN, not FW.", "THEN belongs at the end of line 1."),
                *("FW 1 END IF", (), "head-end-before", "THEN", "IF", 1),
            ),
        ),
        (
            "SPEAK 1\nSPEAK q",
            (
                *("undeclared-variable", 2, 7, "There is no variable q.", "Write VAR q first."),
                *("SPEAK q", (), "", "", "SPEAK", 0),
            ),
        ),
        (
            "PROCEDURE P: n DO\nSPEAK 1 / n\nEND PROCEDURE\nP [0]",
            (
                *("division-by-zero", 2, 7, "I can't divide by zero.", None, "SPEAK 1 / n", (4,)),
                *("", "", "SPEAK", 0),
            ),
        ),
        (
            "FW 1 +\nTR 90",
            (
                *("syntax", 1, 6, "A value is missing after a plus sign.", None, "FW 1 +", ()),
                *("missing-value", "", "FW", 0),
            ),
        ),
    ],
)
def test_a_mistake_has_its_place_its_words_and_what_was_meant(text: str, error: tuple[object, ...]) -> None:
    floor = Floor(terminal=True)
    floor.run(text)

    assert of(Error, floor) == [Error(*error)]  # type: ignore[arg-type] -- its fields


@pytest.mark.parametrize(("count", "is_said"), [(99, False), (100, True), (101, True)])
def test_a_hundred_mistakes_may_not_be_all(count: int, is_said: bool) -> None:
    floor = Floor()
    floor.run("JUMP\n" * count)

    assert len(of(Error, floor)) == min(count, 100)
    assert (floor.printed[-1] == "Only the first 100 mistakes are listed.") is is_said


def test_an_internal_fault_is_a_mistake_in_the_first_line_of_its_batch() -> None:
    floor = Floor()

    def fail(stamped: Stamped) -> None:
        if isinstance(stamped.event, Spoke):
            raise RuntimeError

    floor.session.hub.subscribe(fail)
    run = floor.session.start("  FW 1 \nSPEAK 1", "a.gd", RunOptions(first_line=5))
    assert run.wait(TIMEOUT)

    (error,) = of(Error, floor)
    assert error == Error(INTERNAL, 5, 1, floor.words("internal-error"), None, "FW 1")
    assert isinstance(floor.events[-1], RunEnded)


def test_a_run_that_is_over_has_no_calls_and_ends_with_its_variables_in_order() -> None:
    floor = Floor()
    run = floor.session.start("VAR b = 2\nVAR a = 1\nWAIT 3\nFW 2", "a.gd")
    assert run.wait(TIMEOUT)
    (ended,) = of(RunEnded, floor)

    assert isinstance(ended, RunEnded)
    assert [*ended.variables.items()] == [("a", 1), ("b", 2)]
    assert (ended.pose, ended.outcome) == (Pose(0, 2, 0), Outcome.COMPLETED)
    assert ended.seconds > 3
    assert (run.is_over, run.frames(), run.was_refused, run.wait(0)) == (True, (), False, True)


def test_a_text_that_can_not_be_parsed_for_a_fault_of_donnie_fails_and_is_over(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    floor, read = Floor(), list[bool]()

    def fail(*_: object, **__: object) -> None:
        raise RuntimeError("of the parser")

    monkeypatch.setattr(floor.session, "parse", fail)
    run = floor.session.start("FW 1", "a.gd", when_read=lambda run: read.append(run.was_refused))
    assert run.wait(TIMEOUT)

    assert (read, run.outcome, run.was_refused, run.wait_until_read(0)) == (
        [False],
        Outcome.FAILED,
        False,
        True,
    )
    assert [type(each) for each in floor.events if not isinstance(each, TRANSIENT)][-1] is RunEnded
    assert "of the parser" in caplog.text
