"""Decides which sentence and which cue follow an event, for all front ends.

Subscribes to the stream and publishes announcements and cues into it. Bearings of cues are degrees from the
robot's front, positive to the right.
"""

from __future__ import annotations

from devices.ports.robot import Grip, Met, Pose, Pushed, StoppedBy
from donnie_tui.core.events import (
    STANDING,
    Announced,
    Answered,
    BeltShown,
    Chimed,
    CueSounded,
    Driven,
    Error,
    GripperUsed,
    Link,
    Moved,
    Outcome,
    Passing,
    Pointed,
    Read,
    Reset,
    RunEnded,
    RunStarted,
    Scanned,
    SeenGroup,
    SeenMark,
    Sensed,
    SoundSwitched,
    Spoke,
    Stamped,
    Statement,
    ThingsMoved,
    Turned,
    Waited,
)
from donnie_tui.core.hub import Hub
from donnie_tui.core.transcript import SentencePublisher
from donnie_tui.core.wording import SIDES, Wording, called, own_name, the_coloured

LEAST_PUSH = 0.1
"""Steps. A robot that only comes up to a thing touches it, which is no push."""
MOST_PUSHED = 3
"""Things that are announced one by one."""
_CUE_OF_GRIP = {Grip.GRIPPED: "grip", Grip.RELEASED: "release"}
_OF_NO_WORLD = ("wall", "robot", "something")
"""Kinds of obstacles that are not things of a world."""


class Announcer:
    """Publishes the sentences and cues that follow events."""

    def __init__(self, hub: Hub, sentences: SentencePublisher, wording: Wording) -> None:
        self._hub = hub
        self._sentences = sentences
        self._say = wording
        self._is_talking = False
        """Whether the learner typed the program at a prompt. A script gets only the manual's sentences."""
        self._robot, self._motion = "", STANDING
        """The robot's name, and how a client drives it."""
        hub.subscribe_to_own(self._on_event)

    def about_to_end(self, outcome: Outcome) -> None:
        """Plays the cue of a completed run, before its last event."""
        if outcome is Outcome.COMPLETED:
            self._cue("done")

    def _on_event(self, stamped: Stamped) -> None:
        match stamped.event:
            case RunStarted(how=how, robot=robot):
                self._is_talking = how is not None and how.terminal
                self._robot, self._motion = robot, STANDING
            case Driven(motion=motion):
                self._driven(motion)
            case Moved() as moved:
                self._moved(moved)
            case Turned() as turned:
                self._turned(turned)
            case Scanned() as scanned:
                self._scanned(scanned)
            case SoundSwitched(on=on):
                self._sentences.announce("sound", "sound-on" if on else "sound-off")
            case GripperUsed() as used:
                self._gripped(used)
            case Link(state=state, reason=reason):
                self._sentences.announce("link", f"link-{state}", reason=reason)
            case Error():
                self._cue("error")
            case Announced(code="waiting"):
                self._cue("waiting")
            case Announced(code="no-gripper"):
                self._cue("nothing")
            case (
                RunEnded()
                | Statement()
                | Spoke()
                | Announced()
                | Read()
                | Waited()
                | CueSounded()
                | BeltShown()
                | ThingsMoved()
                | Reset()
                | Passing()
                | Sensed()
                | Answered()
                | Pointed()
                | Chimed()
            ):
                pass
            case never:
                from typing import assert_never  # no start comes here

                assert_never(never)

    def _moved(self, moved: Moved) -> None:
        way = "forward" if moved.forward else "backward"
        ahead = 0.0 if moved.forward else 180.0
        self._bumped(moved.stopped_by, ahead)
        self._sentences.announce("moved", _with_reason(f"walked-{way}", moved.stopped_by), steps=moved.walked)
        self._announce_obstacle("moved", moved.met)
        self._announce_pushed(moved.pushed)
        if moved.walked:
            self._announce_place("moved", moved.pose)

    def _turned(self, turned: Turned) -> None:
        to_the_right = turned.right == (turned.asked >= 0)
        side = "right" if to_the_right else "left"
        self._bumped(turned.stopped_by, 90.0 if to_the_right else -90.0)
        self._sentences.announce(
            "turned", _with_reason(f"turned-{side}", turned.stopped_by), degrees=abs(turned.turned)
        )
        self._announce_obstacle("turned", turned.met)
        self._announce_pushed(turned.pushed)
        if turned.turned:
            self._announce_place("turned", turned.pose)

    def _driven(self, motion: str) -> None:
        if motion == self._motion:
            return
        self._motion = motion
        if motion == "blocked":
            self._cue("bump", 0.0, 0.0)
        self._sentences.announce("driven", f"driven-{motion}", name=self._robot)

    def _gripped(self, used: GripperUsed) -> None:
        """Announces what the gripper took or released, under the learner's name for it."""
        kind, name = used.kind, used.thing
        thing = the_coloured(kind, name, used.colour, self._say) if used.colour and (name or kind) else name
        named = "" if thing else "-something"
        self._cue(_CUE_OF_GRIP.get(used.outcome, "nothing"))
        self._sentences.announce("gripper", f"gripper-{used.outcome.value}{named}", thing=thing)

    def _announce_pushed(self, pushed: tuple[Pushed, ...]) -> None:
        """Announces what was pushed, so that a blind learner does not look for it in its old place."""
        if self._say.detail == "brief":
            return
        felt = tuple(each for each in pushed if each.steps >= LEAST_PUSH)
        for each in felt[:MOST_PUSHED]:
            thing, steps = the_coloured(each.kind, each.name, each.colour, self._say), round(each.steps)
            code = "pushed" if steps else "pushed-little"
            self._sentences.announce("pushed", code, thing=thing, steps=steps)
        if len(felt) > MOST_PUSHED:
            self._sentences.announce("pushed", "pushed-more", count=len(felt) - MOST_PUSHED)

    def _announce_obstacle(self, code: str, met: Met | None) -> None:
        """Announces the obstacle and its side; at detail full in a script, too."""
        detail = self._say.detail
        if met is None or detail == "brief" or not (self._is_talking or detail == "full"):
            return
        where = self._say(f"around-{SIDES[round(met.degrees / 45) % 8]}")
        self._sentences.announce(code, "met", name=self._name_of(met), where=where)

    def _name_of(self, met: Met) -> str:
        """A robot's name, or a thing's kind."""
        if met.kind == "robot" and met.name:
            return met.name
        if met.kind in _OF_NO_WORLD:
            return self._say(f"met-{met.kind}")
        return own_name(met.kind, met.name, self._say) or called(met.kind, met.name, self._say)

    def _announce_place(self, code: str, pose: Pose) -> None:
        """At detail full, announces where a movement led."""
        if self._say.detail == "full":
            self._sentences.place(code, pose)

    def _bumped(self, stopped_by: StoppedBy | None, bearing: float) -> None:
        if stopped_by is StoppedBy.OBSTACLE:
            self._cue("obstacle", bearing, 1.0)
        elif stopped_by in (StoppedBy.COLLISION, StoppedBy.STALL):
            self._cue("bump", bearing, 0.0)

    def _scanned(self, scanned: Scanned) -> None:
        self._cue("scan")
        for group in scanned.objects:
            self._found(group)
            self._sentences.announce("scan", f"scan-{group.side}", **self._words_for(group))
        for mark in scanned.marks:
            self._found(mark)
            sentence = f"scan-{'far-' if mark.number is None else ''}mark-{mark.side}"
            places = {"number": mark.number, "degrees": mark.degrees, "steps": mark.steps}
            self._sentences.announce("scan", sentence, **places)
        if not (scanned.objects or scanned.marks):
            self._sentences.announce("scan", "scan-nothing")

    def _found(self, seen: SeenGroup | SeenMark) -> None:
        sign = -1.0 if seen.side == "left" else 1.0
        self._cue("found", sign * seen.degrees, float(seen.steps))

    def _words_for(self, group: SeenGroup) -> dict[str, object]:
        colours = ", ".join(self._say(f"colour-{colour}") for colour in group.colours)
        return {
            "degrees": group.degrees,
            "count": len(group.colours),
            "colours": colours,
            "steps": group.steps,
        }

    def _cue(self, name: str, bearing: float = 0.0, steps: float | None = None) -> None:
        self._hub.publish(CueSounded(name, bearing, steps))


def _with_reason(sentence: str, stopped_by: StoppedBy | None) -> str:
    """The code of the sentence for a movement that was cut short, else of the plain sentence."""
    return sentence if stopped_by is None else f"{sentence}-{stopped_by.value}"
