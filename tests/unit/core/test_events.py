"""The event stream as JSON is a contract: names, fields and their order."""

import io
import json
from collections.abc import Mapping
from pathlib import Path
from typing import get_args

import pytest

from devices.ports.robot import Grip, Pose, StoppedBy
from donnie_tui.core import events
from donnie_tui.core.events import (
    TRANSIENT,
    Announced,
    Answered,
    BeltShown,
    CueSounded,
    Driven,
    Error,
    Event,
    GripperUsed,
    JsonLines,
    Link,
    Moved,
    Outcome,
    Passing,
    PlacedThing,
    Read,
    RecordedEvent,
    Reset,
    RunEnded,
    RunStarted,
    Scanned,
    SeenGroup,
    SeenMark,
    SoundSwitched,
    Spoke,
    Stamped,
    Statement,
    ThingsMoved,
    Turned,
    Waited,
    as_line,
    as_record,
    event_name,
)
from tests.unit.core.values import HERE

POSE = {"x": 1.0, "y": 2.0, "heading": 90.0}

CONTRACT: list[tuple[Event, Mapping[str, object]]] = [
    (
        RunStarted("a.gd", "open_floor", "donnie", 0, "0.1.0"),
        {
            "event": "run_started",
            "program": "a.gd",
            "world": "open_floor",
            "robot": "donnie",
            "seed": 0,
            "version": "0.1.0",
        },
    ),
    (Statement(3, 5, 1), {"event": "statement", "line": 3, "column": 5, "depth": 1}),
    (Spoke("olá"), {"event": "spoke", "text": "olá"}),
    (Announced("moved", "x"), {"event": "announced", "code": "moved", "text": "x"}),
    (
        Moved("FW 3", 3, 2, StoppedBy.OBSTACLE, HERE, True),
        {
            "event": "moved",
            "command": "FW 3",
            "asked": 3,
            "walked": 2,
            "stopped_by": "obstacle",
            "pose": POSE,
        },
    ),
    (
        Turned("TR 9", 9, 9, None, HERE, True),
        {"event": "turned", "command": "TR 9", "asked": 9, "turned": 9, "stopped_by": None, "pose": POSE},
    ),
    (Driven("forward", HERE), {"event": "driven", "motion": "forward", "pose": POSE}),
    (
        Scanned((SeenGroup("left", 30, 17, ("green", "red")),), (SeenMark(None, "right", 5, 40),)),
        {
            "event": "scanned",
            "objects": [{"side": "left", "degrees": 30, "steps": 17, "colours": ["green", "red"]}],
            "marks": [{"number": None, "side": "right", "degrees": 5, "steps": 40}],
        },
    ),
    (
        Read("distance", "front", 60),
        {"event": "read", "sensor": "distance", "argument": "front", "value": 60},
    ),
    (Waited(3), {"event": "waited", "seconds": 3}),
    (CueSounded("found", -30.0, 17.0), {"event": "cue", "name": "found", "bearing": -30.0, "steps": 17.0}),
    (BeltShown((0,) * 14), {"event": "belt", "levels": [0] * 14}),
    (
        GripperUsed(Grip.GRIPPED, "box", "box", "red"),
        {"event": "gripper", "outcome": "gripped", "thing": "box"},
    ),
    (
        ThingsMoved((PlacedThing("box", HERE, 7),)),
        {"event": "things", "places": [{"name": "box", "pose": POSE}]},
    ),
    (Reset(HERE), {"event": "reset", "pose": POSE}),
    (SoundSwitched(False), {"event": "sound", "on": False}),
    (Link("lost", "unplugged"), {"event": "link", "state": "lost", "reason": "unplugged"}),
    (
        Error("syntax", 3, 5, "What.", None, "FW", (9,)),
        {"event": "error", "kind": "syntax", "line": 3, "column": 5, "message": "What.", "hint": None},
    ),
    (
        RunEnded(Outcome.COMPLETED, HERE, {"a": 1}, 2.5),
        {"event": "run_ended", "outcome": "completed", "pose": POSE, "variables": {"a": 1}, "seconds": 2.5},
    ),
]


@pytest.mark.parametrize(("event", "fields"), CONTRACT, ids=[str(each[1]["event"]) for each in CONTRACT])
def test_an_event_has_the_fields_of_the_contract_in_their_order(
    event: Event, fields: Mapping[str, object]
) -> None:
    record = as_record(Stamped(4, 1.25, event))

    assert list(record.items()) == [("seq", 4), ("t", 1.25), *fields.items()]


def test_every_event_is_either_recorded_or_transient() -> None:
    defined = {each for each in vars(events).values() if _is_kind_of_event(each)}

    assert defined == set(get_args(Event)) == {*get_args(RecordedEvent), *TRANSIENT}
    assert not set(get_args(RecordedEvent)) & set(TRANSIENT)


def _is_kind_of_event(value: object) -> bool:
    return isinstance(value, type) and issubclass(value, events._Event) and value is not events._Event


def test_every_recorded_event_is_in_the_contract_and_described() -> None:
    document = Path("docs/events.md").read_text(encoding="utf-8")

    assert {type(event) for event, _ in CONTRACT} == set(get_args(RecordedEvent))
    assert [each for each in get_args(RecordedEvent) if f"\n- `{event_name(each)}`" not in document] == []


def test_the_robot_is_named_where_a_world_has_several() -> None:
    assert list(as_record(Stamped(1, 0.0, Spoke("a"), "bob")))[:4] == ["seq", "t", "event", "robot"]


def test_a_line_is_json_and_keeps_letters_and_huge_numbers() -> None:
    ended = RunEnded(Outcome.COMPLETED, Pose(0.1 + 0.2, -0.0, 0.0), {"n": 10**300}, 0.0)

    line = as_line(Stamped(1, 0.0, ended))

    assert line.endswith("}\n")
    assert json.loads(line)["variables"]["n"] == 10**300
    assert '"x":0.3,"y":0.0' in line


def test_a_text_with_line_ends_stays_one_line() -> None:
    line = as_line(Stamped(1, 0.0, Spoke("a\nb\r\u2028ç")))

    assert line.count("\n") == 1
    assert json.loads(line)["text"] == "a\nb\r\u2028ç"


OBEYED = (
    *map(chr, (*range(0x20), *range(0x7F, 0xA0), 0x061C, 0x200E, 0x200F, 0x2028, 0x2029)),
    *map(chr, (*range(0x202A, 0x202F), *range(0x2066, 0x206A))),
)
"""What a terminal obeys, or what turns the text after it round."""


def test_a_line_has_escapes_for_all_that_a_terminal_obeys() -> None:
    text = "".join(f"a{each}b" for each in OBEYED)

    line = as_line(Stamped(1, 0.0, Spoke(text), text))

    assert [each for each in OBEYED if each in line.removesuffix("\n")] == []
    assert json.loads(line)["text"] == json.loads(line)["robot"] == text


def test_transient_events_are_not_written() -> None:
    out = io.StringIO()

    for event in (Passing(HERE), Answered("Saved."), Spoke("a")):
        JsonLines(out)(Stamped(1, 0.0, event))

    assert [json.loads(line)["event"] for line in out.getvalue().splitlines()] == ["spoke"]


class _Full(io.StringIO):
    def write(self, text: str) -> int:
        raise OSError(28, "No space left on device")


def test_a_full_disk_is_reported_once_and_ends_the_writing() -> None:
    troubles: list[OSError] = []
    listener = JsonLines(_Full(), troubles.append)

    for _ in range(3):
        listener(Stamped(1, 0.0, Spoke("a")))

    assert [trouble.errno for trouble in troubles] == [28]
