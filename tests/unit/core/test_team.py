"""The robots of one world share a stream and act in a fixed order. One of them is selected."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest

from devices.board_simulator.robot import SimulatedSerialRobot
from devices.ports.robot import Pace, Watcher
from donnie_tui.core.events import TRANSIENT, Moved, Outcome, RunEnded, RunStarted, Stamped, as_line
from donnie_tui.core.hub import Stream
from donnie_tui.core.runner import Run, RunRequest
from donnie_tui.core.session import Busy, RunOptions, Session, SessionSetup
from donnie_tui.core.team import Team
from donnie_tui.core.transcript import printed_lines
from donnie_tui.i18n.words import Words
from language.compiler import compile_program
from language.parser import parse
from sim.world import World
from sim.worldfile import load_text
from tests.timeouts import TIMEOUT

_SENSORS = "".join(f"sonar( pose [ 0 0 0 {-angle} ] )\n" for angle in (0, 45, -45, 180, 135, -135))
TWO = f"""
define sonar sensor ( size [ 0.001 0.001 0.001 ] range [ 0 3.0 ] fov 15 )
define sonars ranger (
{_SENSORS})
define ideal position ( size [ 0.1 0.1 0.1 ] drive "diff" localization "gps" sonars() )
ideal( name "alice" pose [ 0 0 0 90 ] color "red" )
ideal( name "Bob" pose [ 0 1 0 -90 ] color "blue" )
"""

LONG = "REPEAT 5 TIMES SPEAK DISTANCE F FW 1 TR 90 WAIT 1 END REPEAT"


class Hall:
    """A hall with two robots that look at each other, 20 steps apart."""

    def __init__(self, speed: float | None = None) -> None:
        self.words = Words("en", "normal")
        world, self.stream_of_all = World(load_text(TWO, Path("two.world"))), Stream()

        def make(name: str) -> Session:
            robot = partial(world.robot, name, speed=speed)
            return Session(
                lambda pace, watcher: robot(pace=pace, watcher=watcher),
                self.words,
                SessionSetup("two", seed=0, terminal=True, name=name),
                stream=self.stream_of_all,
            )

        self.team = Team(("alice", "Bob"), make, self.stream_of_all, world.expect)
        self.heard: list[Stamped] = []
        self.stream_of_all.subscribe(self.heard.append)

    def run(self, alice: str, bob: str) -> list[Outcome | None]:
        runs = self.team.start_together({"Bob": RunRequest(bob, "b.gd"), "alice": RunRequest(alice, "a.gd")})
        assert all(run.wait(TIMEOUT) for run in runs)
        return [run.outcome for run in runs]

    @property
    def json(self) -> str:
        return "".join(as_line(each) for each in self.heard if not isinstance(each.event, TRANSIENT))

    @property
    def printed(self) -> list[str]:
        return [line for each in self.heard for line in printed_lines(each, self.words)]


@pytest.mark.slow
def test_a_program_that_is_being_stopped_no_longer_counts_as_running() -> None:
    hall = Hall(speed=1.0)
    assert not hall.team.has_unstopped_run

    hall.team.start_together({name: RunRequest("WAIT 1000", "w.gd") for name in ("alice", "Bob")})
    hall.team.session("alice").stop()
    assert hall.team.has_unstopped_run
    hall.team.stop()
    assert not hall.team.has_unstopped_run
    hall.team.close(TIMEOUT)


def test_robots_that_start_together_write_the_same_bytes_every_time_at_any_speed() -> None:
    streams = set()
    for number in range(60):
        hall = Hall(speed=(None, 1000.0, 400.0)[number % 3])
        hall.run(LONG, f"WAIT 1 {LONG} SPEAK 1 / 0")
        streams.add(hall.json)

    assert len(streams) == 1


def test_the_robot_with_the_least_time_acts_first_and_of_equals_the_first_one() -> None:
    hall = Hall()

    hall.run('SPEAK "a" FW 2 SPEAK "c"', 'SPEAK "b" WAIT 3 SPEAK "d"')

    spoken = [line for line in hall.printed if line.endswith(("a", "b", "c", "d")) and len(line) < 10]
    assert spoken == ["alice: a", "Bob: b", "alice: c", "Bob: d"]


def test_the_others_are_stopped_where_one_robot_can_not_begin(monkeypatch: pytest.MonkeyPatch) -> None:
    hall, begun = Hall(), list[Run]()
    begin = Run.start

    def start(run: Run, then: Callable[[Run], None]) -> None:
        if run.name == "b.gd":
            raise RuntimeError("can't start new thread")
        begun.append(run)
        begin(run, then)

    monkeypatch.setattr(Run, "start", start)
    endless = "WHILE 1 == 1 DO WAIT 1 END WHILE"
    with pytest.raises(RuntimeError):
        hall.run(endless, endless)

    assert begun[0].wait(TIMEOUT)
    assert begun[0].outcome is Outcome.STOPPED
    monkeypatch.undo()
    assert hall.run("FW 1", "FW 1") == [Outcome.COMPLETED, Outcome.COMPLETED]


def test_every_event_and_sentence_names_its_robot() -> None:
    hall = Hall()

    hall.run("FW 3", "SPEAK x")

    assert {each.robot for each in hall.heard} == {"alice", "Bob"}
    assert [each.seq for each in hall.heard if not isinstance(each.event, TRANSIENT)] == list(
        range(1, hall.heard[-1].seq + 1)
    )
    assert "alice: I walked 3 steps forward." in hall.printed
    assert "Bob: Error, line 1, column 7: There is no variable x." in hall.printed


def test_a_replacing_robot_keeps_the_name_and_no_other_waits_for_its_turns() -> None:
    hall = Hall()

    robots: list[SimulatedSerialRobot] = []

    def make(pace: Pace, watcher: Watcher) -> SimulatedSerialRobot:
        robots.append(SimulatedSerialRobot(pace=pace, watcher=watcher, speed=None))
        return robots[0]

    hall.team.chosen.change_robot(make)
    robots[0].connect()

    assert hall.run("FW 1", "WAIT 3 FW 2") == [Outcome.COMPLETED, Outcome.COMPLETED]
    assert {each.robot for each in hall.heard} == {"alice", "Bob"}
    assert {each.event.robot for each in hall.heard if isinstance(each.event, RunStarted)} == {"alice", "Bob"}
    robots[0].close()


def test_help_belongs_to_no_robot() -> None:
    hall = Hall()

    hall.run("HELP FW", "")

    assert hall.printed
    assert not any(line.startswith("alice") for line in hall.printed)


def test_robots_see_each_other_and_do_not_pass_through_each_other() -> None:
    hall = Hall()

    hall.run("FW 30", "FW 30")

    walked = {each.robot: each.event for each in hall.heard if isinstance(each.event, Moved)}
    alice, bob = walked["alice"], walked["Bob"]
    assert isinstance(alice, Moved) and isinstance(bob, Moved)
    assert alice.stopped_by is not None and bob.stopped_by is not None
    assert 14 <= alice.walked + bob.walked <= 18


def test_a_stop_of_the_team_stops_all() -> None:
    hall = Hall(speed=50.0)
    endless = "WHILE 1 == 1 DO WAIT 1 END WHILE"
    runs = hall.team.start_together({"alice": RunRequest(endless, "a"), "Bob": RunRequest(endless, "b")})

    hall.team.stop()

    assert all(run.wait(TIMEOUT) for run in runs)
    assert [run.outcome for run in runs] == [Outcome.STOPPED, Outcome.STOPPED]
    assert hall.team.running == ()


def test_one_robot_stops_and_the_other_continues() -> None:
    hall = Hall()
    endless = "WHILE 1 == 1 DO WAIT 1 END WHILE"
    alice, bob = hall.team.start_together(
        {"alice": RunRequest(endless, "a"), "Bob": RunRequest("WAIT 500 FW 1", "b")}
    )

    assert bob.wait(TIMEOUT)
    hall.team.session("alice").stop()

    assert alice.wait(TIMEOUT)
    assert (alice.outcome, bob.outcome) == (Outcome.STOPPED, Outcome.COMPLETED)


def test_the_others_can_be_stopped_while_a_program_computes_without_end() -> None:
    hall = Hall()
    runs = hall.team.start_together(
        {"alice": RunRequest("WHILE 1 == 1 DO END WHILE", "a"), "Bob": RunRequest("FW 1", "b")}
    )

    hall.team.session("Bob").stop()
    assert runs[1].wait(TIMEOUT)

    hall.team.stop()
    assert runs[0].wait(TIMEOUT)


def test_one_busy_robot_prevents_the_start_of_all() -> None:
    hall = Hall(speed=50.0)
    run = hall.team.session("Bob").start("WAIT 1000", "b")

    with pytest.raises(Busy):
        hall.team.start_together({"alice": RunRequest("FW 1", "a"), "Bob": RunRequest("FW 1", "b")})

    assert hall.team.session("alice").run is None
    run.control.stop()
    hall.team.session("Bob").stop()
    assert run.wait(TIMEOUT)
    assert hall.run("FW 1", "FW 1") == [Outcome.COMPLETED, Outcome.COMPLETED]


def test_the_first_robot_is_selected_until_another_one_is_chosen() -> None:
    team = Hall().team

    assert team.chosen.name == "alice"
    team.choose(team.called("bob") or "")
    assert team.chosen.name == "Bob"
    assert team.called("carol") is None
    with pytest.raises(KeyError):
        team.choose("carol")


def test_a_session_is_created_when_it_is_first_used() -> None:
    team = Hall().team

    assert [each.name for each in team.sessions] == []
    assert team.session("Bob").name == "Bob"
    assert [each.name for each in team.sessions] == ["Bob"]


def test_each_run_has_its_first_and_its_last_event() -> None:
    hall = Hall()

    hall.run("FW 1", "FW 2")

    assert sum(isinstance(each.event, RunStarted) for each in hall.heard) == 2
    assert sum(isinstance(each.event, RunEnded) for each in hall.heard) == 2


def test_a_chosen_speed_counts_for_each_selected_or_started_robot() -> None:
    hall = Hall(speed=5.0)
    hall.team.session("alice").speed = 500.0

    assert hall.team.choose("Bob").speed == 500.0
    hall.team.chosen.speed = None
    hall.run("WAIT 1", "WAIT 1")

    assert [each.speed for each in hall.team.sessions] == [None, None]


def test_a_world_of_several_robots_names_each_once_in_its_order() -> None:
    hall = Hall()
    team = hall.team
    assert (team.names, team.has_several, team.chosen_name, team.given) == (
        ("alice", "Bob"),
        True,
        "alice",
        {},
    )
    one = Team(("bob", "bob"), team.session, hall.stream_of_all)
    assert (one.names, one.has_several, one.called("BOB")) == (("bob",), False, "bob")
    assert team.choose("Bob") is team.chosen is team.session("Bob")
    assert team.chosen_name == "Bob"
    team.session("alice")
    assert [each.name for each in team.sessions] == ["alice", "Bob"]


@pytest.mark.parametrize(("robots", "together"), [(("Bob",), ()), (("Bob", "alice"), ("alice", "Bob"))])
def test_robots_that_start_together_begin_anew_unless_they_go_on(
    robots: tuple[str, ...], together: tuple[str, ...]
) -> None:
    hall, prepared = Hall(), list[tuple[str, bool]]()
    programs = {each: RunRequest("FW 1", f"{each}.gd") for each in robots}
    for fresh in (True, False):
        runs = hall.team.start_together(
            programs,
            fresh=fresh,
            prepare=lambda session, run: prepared.append((session.name, run.has_begun)),
        )
        assert all(run.wait(TIMEOUT) for run in runs)
        assert [run.name for run in runs] == [f"{each}.gd" for each in together or robots]
    assert hall.run("FW 1", "FW 1") == [Outcome.COMPLETED] * 2

    started = [each.event for each in hall.heard if isinstance(each.event, RunStarted)]
    hows = [each.how for each in started if each.how is not None]
    count = len(robots)
    assert [(each.fresh, each.together) for each in hows] == [
        *[(True, together)] * count,
        *[(False, together)] * count,
        *[(True, ("alice", "Bob"))] * 2,
    ]
    assert prepared == [(each, False) for each in together or robots] * 2
    assert hall.team.session("Bob").pose.y == 19


def test_an_unknown_robot_lets_no_other_start() -> None:
    hall = Hall()
    with pytest.raises(KeyError):
        hall.team.start_together({"alice": RunRequest("FW 1"), "carol": RunRequest("FW 1")})

    assert hall.heard == []


def test_robots_that_take_turns_are_expected_before_the_first_one_begins() -> None:
    expected: list[tuple[list[str], int]] = []
    hall = Hall()
    hall.team._expect = lambda names: expected.append(([*names], len(hall.heard)))
    runs = hall.team.start_together({"Bob": RunRequest("", "b"), "alice": RunRequest("", "a")})

    assert all(run.wait(TIMEOUT) for run in runs)
    assert expected == [(["alice", "Bob"], 0)]


def test_all_programs_are_stopped_and_waited_for_at_the_end() -> None:
    hall = Hall(speed=50.0)
    endless = "WHILE 1 == 1 DO WAIT 1 END WHILE"
    runs = hall.team.start_together({"alice": RunRequest(endless, "a"), "Bob": RunRequest(endless, "b")})
    assert [each.name for each in hall.team.running] == ["alice", "Bob"]
    hall.team.stop()
    hall.team.wait_for_stop()
    assert [run.is_over for run in runs] == [True, True]
    runs = hall.team.start_together({"Bob": RunRequest(endless, "b")})
    assert [each.name for each in hall.team.running] == ["Bob"]
    hall.team.close()
    assert runs[0].is_over


def test_no_robot_waits_for_one_whose_run_was_given_up() -> None:
    hall = Hall()
    alice, bob = hall.team.session("alice"), hall.team.session("Bob")
    assert hall.team._expect is not None
    hall.team._expect(("alice", "Bob"))
    alice.give_up(alice.claim("FW 1", "a.gd"))
    run = bob.start("FW 1", "b.gd")

    assert run.wait(TIMEOUT)


def test_a_robot_that_others_drive_takes_no_turns() -> None:
    hall = Hall()
    endless = parse("WHILE 1 == 1 DO END WHILE").program
    assert endless is not None
    driver = compile_program(endless, terminal=False, hooked=False)
    driven = hall.team.session("alice").start("", "player", RunOptions(driver=driver))
    run = hall.team.session("Bob").start("FW 1", "b.gd")

    assert run.wait(TIMEOUT)
    assert not driven.is_over
    hall.team.stop()
    assert driven.wait(TIMEOUT)
