"""Steps back through the events restore the earlier states, step by step and event by event."""

import pytest
from msgspec import structs

from devices.ports.robot import Grip, Pose
from donnie_tui.core.events import (
    TRANSIENT,
    Announced,
    BeltShown,
    CueSounded,
    Driven,
    Error,
    Event,
    GripperUsed,
    HowStarted,
    Link,
    Moved,
    Outcome,
    Passing,
    PlacedThing,
    Read,
    Reset,
    RunEnded,
    RunStarted,
    Scanned,
    SoundSwitched,
    Spoke,
    Stamped,
    Statement,
    ThingsMoved,
    Turned,
    Waited,
)
from donnie_tui.core.timeline import (
    Chronicle,
    Replay,
    Timeline,
    moments_of,
    redone_in_words,
    undone_in_words,
)
from donnie_tui.i18n.words import Words
from language.control import ExecutionControl
from tests.floor import Floor
from tests.unit.core.values import HERE

PROGRAM = 'FW 2\nTR 90\nSPEAK "hello"\nWAIT 1\nFW 3\nSTATE\nSCAN'


def happened(program: str = PROGRAM, language: str = "en") -> tuple[Floor, Timeline]:
    floor = Floor(("red", 1, 5), language=language, terminal=True)
    floor.run(program)
    return floor, Timeline([each for each in floor.stream if not isinstance(each.event, TRANSIENT)])


def test_forwards_and_backwards_give_the_same_events() -> None:
    _, timeline = happened()

    there = [timeline.forward() for _ in range(len(timeline))]
    assert timeline.forward() is None
    back = [timeline.back() for _ in range(len(timeline))]

    assert timeline.back() is None
    assert there == back[::-1] == list(timeline.events)


def test_the_place_at_a_position_does_not_depend_on_the_direction_of_the_steps() -> None:
    _, timeline = happened()

    poses = []
    while timeline.forward():
        poses.append((timeline.pose(), timeline.trail()))
    while timeline.at:
        assert poses.pop() == (timeline.pose(), timeline.trail())
        timeline.back()

    assert timeline.pose() is None
    assert timeline.trail() == ()


def test_a_step_is_a_command_with_all_its_events() -> None:
    floor, timeline = happened()

    steps = list(iter(timeline.step, ()))

    assert [[type(each.event).__name__ for each in step][-1] for step in steps[:4]] == [
        "RunStarted",
        "Announced",
        "Announced",
        "Spoke",
    ]
    assert [each for step in steps for each in step] == list(timeline.events)
    back = list(iter(timeline.step_back, ()))
    assert back[::-1] == steps
    assert floor.printed[0] == "I walked 2 steps forward."


def test_the_cue_of_success_belongs_to_the_end_and_not_to_the_last_command() -> None:
    """A step ends at the hold after the last command."""
    _, timeline = happened("FW 2")

    steps = list(iter(timeline.step, ()))

    assert [type(each.event).__name__ for each in steps[-1]] == ["CueSounded", "RunEnded"]
    assert isinstance(steps[-2][-1].event, Announced)


def test_a_huge_jump_ends_at_the_last_event() -> None:
    _, timeline = happened()

    timeline.go_to(10**9)
    assert timeline.at == len(timeline)
    timeline.go_to(-5)
    assert timeline.at == 0


def test_a_step_back_names_the_place_that_it_leads_to() -> None:
    floor, timeline = happened('FW 2\nTR 90\nSPEAK "hello"\nWAIT 1\nFW 3\nSCAN')
    timeline.go_to(len(timeline))

    said = []
    while timeline.at:
        said.append(undone_in_words(timeline.step_back(), timeline, floor.words))

    assert said == [
        "Back: end of the program. Position 3, 2.",
        "Back: looked around.",
        "Before FW 3: position 0, 2.",
        "Back: waited 1 second.",
        "Back: hello.",
        "Before TR 90: facing north.",
        "Before FW 2: position 0, 0.",
        "Back: start of test.gd.",
    ]
    assert undone_in_words((), timeline, floor.words) == "This is the start."


@pytest.mark.parametrize(
    ("event", "said"),
    [
        (CueSounded("step-forward", 0.0, None), "De volta: parte de uma caminhada. Posição 0, 1."),
        (CueSounded("turn-left", 0.0, None), "De volta: parte de um giro. Virado para o norte."),
        (CueSounded("step-back", 0.0, None), "De volta: parte de uma caminhada. Posição 0, 1."),
        (CueSounded("turn-right", 0.0, None), "De volta: parte de um giro. Virado para o norte."),
        (CueSounded("obstacle", 0.0, 1.0), "De volta: um som."),
        (Read("distance", "F", 7), "De volta: um sensor disse 7."),
        (Statement(3, 1, 0), "De volta: começo da linha 3."),
        (BeltShown((0,) * 14), "De volta: o cinto mudou."),
        (ThingsMoved(()), "De volta: objetos movidos."),
    ],
)
def test_an_unfinished_command_is_described_by_its_name(event: Event, said: str) -> None:
    here = Moved("PF 1", 1, 1, None, Pose(0, 1, 0), True)
    timeline = Timeline([Stamped(1, 0.0, here), Stamped(2, 0.0, event)])
    timeline.go_to(2)
    timeline.back()

    assert undone_in_words((timeline.events[1],), timeline, Words("pt")) == said


STARTED = RunStarted("a.gd", "world", "donnie", 0, "0")


@pytest.mark.parametrize(
    ("event", "said"),
    [
        (GripperUsed(Grip.GRIPPED, "ball"), "Back: gripped."),
        (GripperUsed(Grip.RELEASED, "ball"), "Back: let go."),
        (GripperUsed(Grip.HOLDS_NOTHING, ""), "Back: nothing let go."),
        (Error("meaning", 3, 1, "There is no x.", None), "Back: mistake in line 3."),
        (SoundSwitched(True), "Back: sound switched."),
        (Link("lost", ""), "Back: news of the connection."),
        (Waited(1), "Back: waited 1 second."),
        (STARTED, "Back: start of a.gd. Position 0, 1."),
        (structs.replace(STARTED, program="typed"), "Back: start of the program. Position 0, 1."),
        (Reset(HERE), "Back: back to the start. Position 0, 1."),
        (Spoke("Two\n lines."), "Back: Two lines."),
        (Spoke("w" * 60), f"Back: {'w' * 60}."),
        (Spoke("w" * 61), f"Back: {'w' * 59}\N{HORIZONTAL ELLIPSIS}."),
    ],
)
def test_what_is_undone_is_named(event: Event, said: str) -> None:
    timeline = Timeline(
        [
            Stamped(1, 0.0, Moved("FW 1", 1, 1, None, Pose(0, 1, 0), True)),
            Stamped(2, 0.0, event),
        ]
    )
    timeline.go_to(2)
    timeline.back()

    assert undone_in_words((timeline.events[1],), timeline, Words()) == said


def test_a_trail_begins_anew_with_a_reset() -> None:
    stamped = [
        Stamped(1, 0.0, Moved("FW 1", 1, 1, None, Pose(0, 1, 0), True)),
        Stamped(2, 0.0, Reset(HERE)),
        Stamped(3, 0.0, Moved("FW 2", 2, 2, None, Pose(0, 2, 0), True)),
    ]
    timeline = Timeline(stamped)

    timeline.go_to(3)
    assert timeline.trail() == (HERE, Pose(0, 2, 0))
    timeline.back()
    timeline.back()
    assert timeline.trail() == (Pose(0, 1, 0),)


def test_things_return_to_their_earlier_places() -> None:
    first, second = (PlacedThing("box", Pose(x, 0, 0)) for x in (1, 2))
    events = ThingsMoved((first,)), Spoke("1"), ThingsMoved((second,)), Spoke("2")
    timeline = timeline_of(*events)

    there = [timeline.things]
    while timeline.forward():
        there.append(timeline.things)
    back = [timeline.things]
    while timeline.back():
        back.append(timeline.things)

    assert there == [(), (first,), (first,), (second,), (second,)]
    assert back == there[::-1]
    assert (timeline.pose(), timeline.robots) == (None, ())


# --- where a step ends

MOVED = Moved("FW 1", 1, 1, None, Pose(0, 1, 0), True)
BELT = BeltShown((1,) * 14)


def timeline_of(*events: Event) -> Timeline:
    return Timeline([Stamped(at, 0.0, event) for at, event in enumerate(events, start=1)])


def steps_of(*events: Event) -> list[int]:
    """How many events each step has, the same forwards and backwards."""
    timeline = timeline_of(*events)
    forwards = [len(step) for step in iter(timeline.step, ())]
    backwards = [len(step) for step in iter(timeline.step_back, ())]
    assert backwards[::-1] == forwards
    return forwards


@pytest.mark.parametrize(
    "code", ["moved", "turned", "driven", "scan", "sound", "link", "gripper", "pushed", "position", "help"]
)
def test_an_announcement_about_an_event_belongs_to_it_and_any_other_is_a_step(code: str) -> None:
    is_own = code in ("position", "help")

    assert steps_of(Spoke("1"), MOVED, Announced(code, "So it is."), Spoke("2")) == (
        [1, 1, 1, 1] if is_own else [1, 2, 1]
    )


@pytest.mark.parametrize(
    "cue", ["step-forward", "step-back", "turn-right", "turn-left", "waiting", "done", "obstacle", "bump"]
)
def test_the_cue_of_what_begins_leads_on_and_any_other_belongs_to_what_was(cue: str) -> None:
    follows = cue in ("obstacle", "bump")

    assert steps_of(Spoke("1"), CueSounded(cue, 0.0, None), Spoke("2")) == ([2, 1] if follows else [1, 2])


@pytest.mark.parametrize(
    ("events", "sizes"),
    [
        ((Statement(1, 1, 0), Read("distance", "F", 3), MOVED, Spoke("1")), [3, 1]),
        ((Announced("waiting", "I wait."), Waited(1), Spoke("1")), [2, 1]),
        ((CueSounded("step-forward", 0.0, None), BELT, ThingsMoved(()), MOVED, Spoke("1")), [4, 1]),
        ((MOVED, BELT, ThingsMoved(()), Spoke("1")), [3, 1]),
        ((BELT, BELT, Spoke("1")), [2, 1]),
        ((BELT, Spoke("1"), Statement(1, 1, 0)), [1, 1, 1]),
        ((MOVED, Statement(1, 1, 0)), [1, 1]),
    ],
)
def test_what_leads_to_an_event_and_what_follows_it_are_one_step(
    events: tuple[Event, ...], sizes: list[int]
) -> None:
    assert steps_of(*events) == sizes


def test_steps_are_counted_by_what_they_did() -> None:
    timeline = timeline_of(
        CueSounded("step-forward", 0.0, None), MOVED, BELT, Announced("moved", "1"), Spoke("1")
    )

    counted = [timeline.steps]
    while timeline.forward():
        counted.append(timeline.steps)
    assert counted == [(0, 2), (0, 2), (1, 2), (1, 2), (1, 2), (2, 2)]


def test_the_last_event_is_known_at_each_position() -> None:
    timeline = timeline_of(Spoke("1"), Spoke("2"))
    assert timeline.now is None
    for each in timeline.events:
        timeline.forward()
        assert timeline.now is each
    timeline.back()
    assert timeline.now is timeline.events[0]


@pytest.mark.parametrize(("robot", "said"), [(None, "Back: hello."), ("bob", "bob: Back: hello.")])
@pytest.mark.parametrize("cue", [CueSounded("step-forward", 0.0, None), CueSounded("bump", 0.0, None)])
def test_a_step_is_named_by_its_main_event_or_else_by_its_last(
    cue: Event, robot: str | None, said: str
) -> None:
    undone = [
        Stamped(1, 0.0, cue, robot),
        Stamped(2, 0.0, Spoke("hello"), robot),
        Stamped(3, 0.0, cue, robot),
    ]
    assert undone_in_words(undone, timeline_of(), Words()) == said

    only = [Stamped(1, 0.0, Statement(3, 1, 0)), Stamped(2, 0.0, Read("distance", "F", 7))]
    assert undone_in_words(only, timeline_of(), Words()) == "Back: a sensor said 7."


@pytest.mark.parametrize(
    ("event", "said"),
    [
        (Moved("FW 3", 3, 3, None, Pose(0, 3, 0), True), "Before FW 3: position 2, -1."),
        (Turned("TR 90", 90, 90, None, Pose(0, 3, 90), True), "Before TR 90: facing east."),
        (RunEnded(Outcome.FAILED, HERE, {}, 1.0), "Back: end of the program. Position 2, -1."),
        (Driven("left", HERE), "Back: what another program drove."),
        (Scanned(()), "Back: looked around."),
        (Waited(2), "Back: waited 2 seconds."),
    ],
)
def test_what_moved_the_robot_is_undone_with_the_place_before_it(event: Event, said: str) -> None:
    before = Stamped(1, 0.0, Reset(Pose(2.5, -1.5, 90)))
    timeline = Timeline([before, Stamped(2, 0.0, event)])
    timeline.go_to(1)

    assert undone_in_words([timeline.events[1]], timeline, Words()) == said
    assert "osition" not in undone_in_words([timeline.events[1]], timeline_of(), Words())  # it is not known


@pytest.mark.parametrize(("at", "there"), [(2, 2), (0, 0), (-1, 0), (5, 5), (6, 5)])
def test_a_timeline_goes_to_a_position_from_either_side(at: int, there: int) -> None:
    timeline = timeline_of(*[MOVED] * 5)
    timeline.go_to(at)
    assert timeline.at == there
    timeline.go_to(5)
    timeline.go_to(at)
    assert timeline.at == there


@pytest.mark.parametrize(
    ("events", "robot", "said"),
    [
        ((), None, ""),
        ((STARTED,), None, "Start of a.gd."),
        ((STARTED,), "bob", "bob: Start of a.gd."),
        ((Statement(3, 1, 0), Waited(2), BELT), None, "Waited 2 seconds."),
        ((Statement(3, 1, 0), Read("distance", "F", 7)), None, "A sensor said 7."),
        ((Spoke("Hello"),), None, ""),
        ((MOVED, Announced("moved", "I walked.")), None, ""),
    ],
)
def test_what_printed_nothing_is_named_when_it_is_repeated(
    events: tuple[Event, ...], robot: str | None, said: str
) -> None:
    assert redone_in_words([Stamped(1, 0.0, each, robot) for each in events], Words()) == said


# --- the times of a replay


def started(*together: str) -> RunStarted:
    how = HowStarted("", 1, True, True, False, Pose(0, 0, 0), named=True, together=together)
    return structs.replace(STARTED, how=how)


ENDED = RunEnded(Outcome.COMPLETED, Pose(0, 0, 0), {}, 0.0)


def test_each_run_has_its_own_time_from_the_moment_at_which_it_began() -> None:
    """One after the other their times are added; robots that start together share their beginning."""
    happened: list[tuple[Event, str, float, float]] = [
        (STARTED, "alice", 0.0, 0.0),
        (Spoke("1"), "alice", 2.0, 2.0),
        (ENDED, "alice", 2.0, 2.0),
        (Spoke("2"), "alice", 9.0, 2.0),  # between the runs
        (started(), "alice", 0.0, 2.0),
        (Spoke("3"), "alice", 1.0, 3.0),
        (ENDED, "alice", 1.5, 3.5),
        (started("alice", "bob"), "alice", 0.0, 3.5),
        (Spoke("4"), "alice", 1.0, 4.5),
        (started("alice", "bob"), "bob", 0.0, 4.5),
        (Spoke("5"), "bob", 0.5, 4.5),  # at 4.0, which is over
        (Spoke("6"), "bob", 2.0, 5.5),
        (ENDED, "alice", 4.0, 7.5),
        (ENDED, "bob", 5.0, 8.5),
        (started(), "alice", 0.0, 8.5),
        (Spoke("7"), "alice", 2.0, 10.5),
        (started(), "bob", 0.0, 10.5),  # started by hand meanwhile
        (Spoke("8"), "bob", 1.0, 11.5),
        (Spoke("9"), "alice", 5.0, 13.5),
    ]
    events = [Stamped(at, t, event, robot) for at, (event, robot, t, _) in enumerate(happened, start=1)]

    assert list(moments_of(events)) == [moment for *_, moment in happened]


class Waiting(ExecutionControl):
    """Waits not at all, and is stopped at its wait of that number."""

    def __init__(self, stopped_at: int | None = None) -> None:
        super().__init__()
        self.waits: list[float] = []
        self._stopped_at = stopped_at

    def sleep(self, seconds: float) -> bool:
        self.waits.append(seconds)
        return len(self.waits) != self._stopped_at


def replayed() -> Timeline:
    """A run with steps at 1, 1, 4 and 24 seconds."""
    times = (0.0, STARTED), (1.0, MOVED), (1.0, BELT), (4.0, Spoke("1")), (24.0, Spoke("2"))
    return Timeline([Stamped(at, t, event) for at, (t, event) in enumerate(times, start=1)])


@pytest.mark.parametrize(
    ("speed", "there", "back"),
    [
        (1.0, [0, 1, 0, 3, 5], [5, 3, 1, 0]),
        (2.0, [0, 0.5, 0, 1.5, 5], [5, 1.5, 0.5, 0]),
        (10.0, [0, 0.1, 0, 0.3, 2], [2, 0.3, 0.1, 0]),
        (None, [0] * 5, [0] * 4),
    ],
)
def test_a_replay_waits_as_long_as_the_program_took_divided_by_its_speed(
    speed: float | None, there: list[float], back: list[float]
) -> None:
    """Five seconds at most; backwards step by step, so that the belt waits for nothing."""
    timeline, seen, undone = replayed(), list[Stamped](), list[tuple[Stamped, ...]]()
    forwards, backwards = Waiting(), Waiting()

    assert Replay(timeline, forwards, speed).forwards(seen.append)
    assert seen == list(timeline.events)
    assert forwards.waits == pytest.approx(there)
    assert Replay(timeline, backwards, speed).backwards(undone.append)
    assert [len(each) for each in undone] == [1, 1, 2, 1]
    assert backwards.waits == pytest.approx(back)
    assert timeline.at == 0


def test_a_replay_that_is_stopped_in_a_wait_stays_before_what_comes_next() -> None:
    timeline, seen, undone = replayed(), list[Stamped](), list[tuple[Stamped, ...]]()

    assert not Replay(timeline, Waiting(stopped_at=3), 1.0).forwards(seen.append)
    assert (timeline.at, len(seen)) == (2, 2)
    timeline.go_to(5)
    assert not Replay(timeline, Waiting(stopped_at=2), 1.0).backwards(undone.append)
    assert (timeline.at, len(undone)) == (3, 2)


def test_fifty_thousand_events_are_kept_to_step_back() -> None:
    chronicle = Chronicle()
    for seq in range(1, 50_002):
        chronicle(Stamped(seq, 0.0, Spoke("a")))
    kept = chronicle.timeline().events

    assert (len(kept), kept[0].seq, kept[-1].seq) == (50_000, 2, 50_001)


def test_the_moves_up_to_a_position_include_those_that_are_forgotten() -> None:
    chronicle = Chronicle(most=2)
    for at in range(1, 6):
        chronicle(Stamped(at, 0.0, Moved(f"FW {at}", at, at, None, Pose(0, at, 0), True), "alice"))
    timeline = chronicle.timeline()

    def commands(robot: str) -> list[str]:
        return [row[0] for row in timeline.moves(lambda: robot).rows()]

    assert commands("alice") == ["FW 1", "FW 2", "FW 3", "FW 4", "FW 5"]
    assert commands("bob") == []
    timeline.back()
    assert commands("alice") == ["FW 1", "FW 2", "FW 3", "FW 4"]
    timeline.go_to(0)
    assert commands("alice") == ["FW 1", "FW 2", "FW 3"]
    kept = Timeline(timeline.events)
    kept.forward()
    assert [row[0] for row in kept.moves(lambda: "alice").rows()] == ["FW 4"]


def test_each_robot_has_its_own_place_and_is_named() -> None:
    timeline = Timeline(
        [
            Stamped(1, 0.0, Moved("FW 1", 1, 1, None, Pose(0, 1, 0), True), "alice"),
            Stamped(2, 0.0, Announced("moved", "I walked 1 step forward."), "alice"),
            Stamped(3, 0.0, Moved("FW 5", 5, 5, None, Pose(9, 5, 0), True), "bob"),
        ]
    )
    timeline.go_to(3)
    assert (timeline.pose("alice"), timeline.pose("bob")) == (Pose(0, 1, 0), Pose(9, 5, 0))
    assert timeline.robots == ("alice", "bob")

    floor = Floor()
    assert undone_in_words(timeline.step_back(), timeline, floor.words) == "bob: Back: FW 5."
    assert timeline.pose("bob") is None


def test_a_trail_of_a_position_begins_at_the_last_start_before_it() -> None:
    places = [Pose(0, at, 0) for at in range(5)]
    timeline = timeline_of(
        Moved("FW 1", 1, 1, None, places[1], True),
        started(),
        Moved("FW 1", 1, 1, None, places[2], True),
        Reset(places[0]),
        Moved("FW 1", 1, 1, None, places[3], True),
    )
    trails = []
    while timeline.forward():
        trails.append(timeline.trail())

    assert trails[0] == (places[1],)
    assert trails[3:] == [(places[0],), (places[0], places[3])]
    assert trails[2][-1] == places[2]
    assert timeline.trail("bob") == ()


def test_a_chronicle_keeps_the_newest_and_nothing_transient() -> None:
    chronicle = Chronicle(most=3)

    for number in range(1, 6):
        chronicle(Stamped(number, 0.0, Spoke(str(number))))
        chronicle(Stamped(0, 0.0, Passing(HERE)))

    assert chronicle.last_seq == 5
    assert Chronicle().last_seq == 0
    timeline = chronicle.timeline()
    assert [each.seq for each in timeline.events] == [3, 4, 5]
    assert timeline.at == 3
