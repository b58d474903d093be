"""Things that robots grip and push: their announcements and their current places."""

from functools import partial
from pathlib import Path

from donnie_tui.core.events import (
    TRANSIENT,
    Announced,
    CueSounded,
    GripperUsed,
    Outcome,
    Reset,
    Stamped,
    ThingsMoved,
)
from donnie_tui.core.session import RunOptions, Session, SessionSetup
from donnie_tui.core.timeline import Timeline
from donnie_tui.core.transcript import printed_lines
from donnie_tui.i18n.words import Words
from donnie_tui.world.loading import ThingWatch
from sim.world import World
from sim.worldfile import load_text
from tests.floor import Floor
from tests.timeouts import TIMEOUT

WORLD = """
define box model ( size [ 0.05 0.05 0.2 ] gripper_return 1 )
define hand position ( size [ 0.1 0.1 0.1 ] gripper( size [ 0.1 0.1 0.1 ] pose [ 0.1 0 0 0 ] ) )
hand( name "hand" pose [ 0 0 0 90 ] )
box( name "red box" pose [ 0 0.2 0 0 ] color "red" )
"""

PUSHED = WORLD.replace("gripper_return 1", "pushable 1")


class Room:
    """A robot with a gripper, and a box four steps before it."""

    def __init__(self, text: str = WORLD) -> None:
        world = World(load_text(text, Path("room.world")))
        self.words = Words()
        self.session = Session(
            lambda pace, watcher: partial(world.robot, pace=pace, watcher=watcher)(),
            self.words,
            SessionSetup("room", seed=0, terminal=True),
            moved_things=ThingWatch(world),
        )
        self.heard: list[Stamped] = []
        self.session.hub.subscribe(self.heard.append)

    @property
    def timeline(self) -> Timeline:
        """At its end."""
        timeline = Timeline([each for each in self.heard if not isinstance(each.event, TRANSIENT)])
        timeline.go_to(len(timeline))
        return timeline

    def run(self, text: str, *, fresh: bool = False) -> None:
        assert self.session.start(text, "a.gd", RunOptions(fresh=fresh)).wait(TIMEOUT)

    @property
    def printed(self) -> list[str]:
        return [line for each in self.heard for line in printed_lines(each, self.words)]

    @property
    def cues(self) -> list[str]:
        return [each.event.name for each in self.heard if isinstance(each.event, CueSounded)]

    @property
    def places(self) -> list[tuple[float, float]]:
        """The published places of the box, in their order."""
        events = [each.event for each in self.heard if isinstance(each.event, ThingsMoved)]
        return [(round(each.pose.x, 1), round(each.pose.y, 1)) for event in events for each in event.places]


def test_a_missing_gripper_is_reported_and_the_program_goes_on() -> None:
    floor = Floor()

    outcome = floor.run("GRIP RELEASE FW 1")

    assert outcome is Outcome.COMPLETED
    assert floor.printed == ["I have no gripper.", "I have no gripper.", "I walked 1 step forward."]
    assert [each.code for each in floor.events if isinstance(each, Announced)] == [
        "no-gripper",
        "no-gripper",
        "moved",
    ]
    assert not any(isinstance(each, GripperUsed) for each in floor.events)
    cues = [each.name for each in floor.events if isinstance(each, CueSounded)]
    assert cues == ["nothing", "nothing", "step-forward", "done"]


def test_a_missing_gripper_is_a_step_of_its_own_in_a_timeline() -> None:
    floor = Floor()
    floor.run("FW 1 GRIP")
    timeline = Timeline([each for each in floor.stream if not isinstance(each.event, TRANSIENT)])
    timeline.go_to(len(timeline))

    timeline.step_back()
    undone = timeline.step_back()

    assert [each.event.text for each in undone if isinstance(each.event, Announced)] == ["I have no gripper."]


def test_a_grip_without_a_thing_in_reach_holds_nothing() -> None:
    room = Room()

    room.run("TR 180 GRIP RELEASE")

    assert room.printed[-2:] == ["There is nothing to grip.", "I hold nothing."]
    assert [each for each in room.cues if "turn" not in each] == ["nothing", "nothing", "done"]


def test_a_held_thing_moves_along_and_its_place_is_published() -> None:
    room = Room()

    room.run("FW 1 GRIP GRIP BW 5 RELEASE BW 1")

    assert [each for each in room.printed if "walked" not in each] == [
        "I hold the red box.",
        "I hold the red box already.",
        "I let go of the red box.",
    ]
    assert [each.event.outcome.value for each in room.heard if isinstance(each.event, GripperUsed)] == [
        "gripped",
        "holds-already",
        "released",
    ]
    assert [each for each in room.cues if "step" not in each] == ["grip", "nothing", "release", "done"]
    assert room.places
    x, y = room.places[-1]
    assert x == 0.0
    assert y < 4.0


def test_a_fresh_run_puts_everything_back_and_a_timeline_knows_it() -> None:
    room = Room()
    room.run("FW 1 GRIP BW 5")
    assert room.timeline.things

    room.run("FW 1", fresh=True)

    assert room.timeline.things == ()


def test_a_thing_that_is_pushed_to_the_same_place_again_is_published_again() -> None:
    room = Room(PUSHED)
    for _ in range(3):
        room.run("FW 10", fresh=True)
        assert [each.name for each in room.timeline.things] == ["red box"]

    assert len(room.places) == 3
    assert len(set(room.places)) == 1


def test_a_reset_publishes_the_returned_things() -> None:
    room = Room(PUSHED)
    room.run("FW 10")

    room.session.reset()

    assert isinstance(room.heard[-1].event, ThingsMoved)
    assert room.heard[-1].event.places == ()
    assert room.timeline.things == ()
    room.run("FW 10")
    assert room.timeline.things
    room.session.reset()
    room.session.reset()
    assert isinstance(room.heard[-1].event, Reset)


def test_a_step_back_in_the_timeline_moves_things_to_their_earlier_places() -> None:
    room = Room(PUSHED)
    room.run("FW 10")
    room.run("FW 3")
    timeline = room.timeline
    there = {}
    timeline.go_to(0)
    while timeline.forward():
        there[timeline.at] = timeline.things

    assert len(set(there.values())) == 3
    while timeline.at:
        assert timeline.things == there[timeline.at]
        timeline.back()
    assert timeline.things == ()
