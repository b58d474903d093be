"""The event stream as JSON is a contract: names, fields and their order."""

import io
import json
from collections.abc import Mapping
from pathlib import Path
from typing import get_args

import pytest

from devices.ports.robot import Grip, Met, Pose, Pushed, StoppedBy
from donnie_tui.core import events
from donnie_tui.core.events import (
    TRANSIENT,
    Announced,
    Answered,
    BeltShown,
    Chimed,
    CueSounded,
    Driven,
    Error,
    Event,
    GripperUsed,
    HowStarted,
    JsonLines,
    LineFile,
    Link,
    Moved,
    Outcome,
    Passing,
    PlacedThing,
    Pointed,
    Read,
    RecordedEvent,
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
    as_line,
    as_record,
    begins_anew,
    event_name,
    pose_of,
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

    shown = Passing(HERE), Answered("Saved."), Sensed({}), Pointed("a wall"), Chimed("block")
    for event in (*shown, Spoke("a")):
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


def test_what_is_not_in_the_stream_is_in_a_whole_record() -> None:
    met, pushed = Met("chair", "c", 0.5), (Pushed("box", "b", "red", 0.25),)
    there = Pose(1.5, 2.5, 90.0)
    moved = Moved("FW 3", 3, 2, StoppedBy.OBSTACLE, HERE, True, met, pushed, there)
    error = Error("syntax", 3, 5, "What.", None, "FW", (9,), "few", "FW 1", "FW", 2)

    assert as_record(Stamped(1, 0.0, moved))["true_pose"] == {"x": 1.5, "y": 2.5, "heading": 90.0}
    whole = as_record(Stamped(1, 0.0, moved), whole=True)
    assert list(whole)[-4:] == ["forward", "met", "pushed", "true_pose"]
    assert (whole["met"], whole["forward"]) == ({"kind": "chair", "name": "c", "degrees": 0.5}, True)
    assert "true_pose" not in as_record(Stamped(1, 0.0, CONTRACT[4][0]), whole=True)
    assert list(as_record(Stamped(1, 0.0, error), whole=True).items())[-6:] == [
        ("source_line", "FW"),
        ("calls", [9]),
        ("code", "few"),
        ("meant", "FW 1"),
        ("topic", "FW"),
        ("mended_line", 2),
    ]
    things = as_record(Stamped(1, 0.0, ThingsMoved((PlacedThing("box", HERE, 7),))), whole=True)
    assert things["places"] == [{"name": "box", "pose": POSE, "index": 7}]


def test_numbers_have_six_decimals_and_no_negative_zero() -> None:
    record = as_record(Stamped(1, 0.12345678, CueSounded("bump", -0.0000001, 1.2345674)))

    assert (record["t"], record["steps"]) == (0.123457, 1.234567)
    assert str(record["bearing"]) == "0.0"


def started(**how: object) -> RunStarted:
    given = {"text": "", "first_line": 1, "fresh": True, "terminal": False, "trace": False, "pose": HERE}
    return RunStarted("p", "w", "donnie", 0, "0", HowStarted(**(given | how)))


@pytest.mark.parametrize(
    ("event", "begins"),
    [
        (Reset(HERE), True),
        (started(), True),
        (started(fresh=False), False),
        (started(refused=True), False),
        (started(refused=True, together=("a", "b")), True),
        (started(refused=True, together=("a",)), False),
        (started(fresh=False, together=("a", "b")), False),
        (RunStarted("p", "w", "donnie", 0, "0"), False),
        (RunEnded(Outcome.COMPLETED, HERE, {}, 1.0), False),
    ],
)
def test_a_reset_or_a_fresh_run_that_is_not_refused_begins_anew(event: Event, begins: bool) -> None:
    assert begins_anew(event) is begins


@pytest.mark.parametrize(
    ("event", "pose"),
    [
        (Moved("FW 3", 3, 2, None, HERE, True), HERE),
        (Turned("TR 9", 9, 9, None, HERE, True), HERE),
        (Driven("forward", HERE), HERE),
        (RunEnded(Outcome.COMPLETED, HERE, {}, 1.0), HERE),
        (Reset(HERE), HERE),
        (started(), HERE),
        (RunStarted("p", "w", "donnie", 0, "0"), None),
        (Passing(HERE), None),
        (Spoke("a"), None),
    ],
)
def test_the_place_of_a_robot_is_in_its_movements_starts_and_ends(event: Event, pose: Pose | None) -> None:
    assert pose_of(event) == pose


def test_a_run_of_an_old_recording_was_in_english_and_alone() -> None:
    how = started().how

    assert how is not None
    assert (how.language, how.detail, how.named, how.together) == ("en", "normal", False, ())
    assert (how.is_together, how.begins_anew, how.refused) == (False, True, False)


def test_a_file_of_lines_takes_more_until_it_is_closed_or_full() -> None:
    class Counting(io.StringIO):
        flushed = 0

        def flush(self) -> None:
            self.flushed += 1

    out = Counting()
    file, full = LineFile(out), LineFile(_Full())
    file.write("a\n")
    file.write("b\n")
    full.write("a\n")

    assert (out.getvalue(), out.flushed) == ("a\nb\n", 2)
    assert (file.takes_more, full.takes_more) == (True, False)
    out.close()
    assert not file.takes_more
    JsonLines(out)(Stamped(1, 0.0, Spoke("a")))


def test_the_codes_that_events_share_are_those_of_the_contract() -> None:
    document = Path("docs/events.md").read_text(encoding="utf-8")

    for code in (events.BELT_LINK, events.INTERNAL, events.STANDING):
        assert f"`{code}`" in document
