"""Every event can be rebuilt from its line, and no foreign line becomes an event."""

import json
from io import BytesIO, StringIO
from pathlib import Path
from typing import get_args

import pytest
from hypothesis import given
from hypothesis import strategies as st

from devices.ports.robot import Grip, Met, StoppedBy
from donnie_tui.core import recording
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
    PlacedThing,
    Read,
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
)
from donnie_tui.core.recording import (
    Damage,
    DamagedLineError,
    Header,
    NoRecordingError,
    Recording,
    stamped_in,
)
from donnie_tui.core.timeline import Timeline, undone_in_words
from donnie_tui.i18n.words import Words
from tests.unit.core.values import HERE

HOW = HowStarted("FW 1\n", 1, True, False, False, HERE, "pt", "brief", True, ("alice", "bob"))
EVENTS: tuple[Event, ...] = (
    RunStarted("a.gd", "two", "alice", 3, "0.1", HOW),
    Statement(1, 2, 3),
    Spoke('olá "x" {[ \n'),
    Announced("moved", "Andei."),
    Moved("FW 3", 3, 2, StoppedBy.OBSTACLE, HERE, True),
    Turned("TR 90", 90, 90, None, HERE, False),
    Driven("backward-left", HERE),
    Turned("TR 90", 90, 30, StoppedBy.COLLISION, HERE, True, Met("chair", "chair7", 45.0)),
    Scanned((SeenGroup("left", 30, 4, ("red", "blue")),), (SeenMark(3, "ahead", 0, 12),)),
    Read("distance", "front", 60),
    Waited(2),
    CueSounded("found", -30.0, None),
    BeltShown((0,) * 14),
    GripperUsed(Grip.GRIPPED, "box"),
    ThingsMoved((PlacedThing("box", HERE, 7),)),
    Reset(HERE),
    SoundSwitched(False),
    Link("lost", "cable"),
    Error("syntax", 1, 2, "message", None, "FWD 3", (4, 5)),
    RunEnded(Outcome.STOPPED, HERE, {"a": 10**30}, 2.5),
)


def again(stamped: Stamped) -> Stamped:
    return stamped_in(as_line(stamped, whole=True))


@pytest.mark.parametrize("event", EVENTS, ids=lambda event: type(event).__name__)
@pytest.mark.parametrize("robot", [None, "alice"])
def test_an_event_is_rebuilt_from_its_line(event: Event, robot: str | None) -> None:
    if isinstance(event, RunStarted) and robot is None:
        event = RunStarted("a.gd", "one", "donnie", 3, "0.1", None)
    stamped = Stamped(7, 1.5, event, robot)

    assert again(stamped) == stamped


@pytest.mark.parametrize("event", EVENTS, ids=lambda event: type(event).__name__)
def test_an_event_that_is_undone_has_words_of_its_own(event: Event) -> None:
    words = Words("en")

    undone = undone_in_words([Stamped(7, 1.5, event)], Timeline(()), words)

    assert undone.startswith(("Back: ", "Before "))
    assert words("undone-something") not in undone


def test_the_table_has_every_kind_of_event() -> None:
    assert {type(each) for each in EVENTS} == set(get_args(Event)) - set(TRANSIENT)


@pytest.mark.parametrize(
    "line",
    [
        "",
        "{",
        "[1]",
        '"text"',
        "null",
        '{"seq":1,"t":0,"event":"nonsense"}',
        '{"seq":1,"t":0,"event":["spoke"],"text":"a"}',
        '{"seq":1,"t":0,"event":"spoke"}',
        '{"seq":1,"t":0,"event":"spoke","text":5}',
        '{"seq":"1","t":0,"event":"spoke","text":"a"}',
        '{"seq":true,"t":0,"event":"spoke","text":"a"}',
        '{"seq":1,"t":NaN,"event":"spoke","text":"a"}',
        '{"seq":1,"t":1' + "0" * 400 + ',"event":"spoke","text":"a"}',
        '{"seq":1,"t":0,"event":"waited","seconds":1' + "0" * 5000 + "}",
        '{"seq":1,"t":0,"event":"reset","pose":{"x":0,"y":0}}',
        '{"seq":1,"t":0,"event":"reset","pose":[0,0,0]}',
        '{"seq":1,"t":0,"event":"belt","levels":["a"]}',
        '{"seq":1,"t":0,"event":"run_ended","outcome":"won","pose":{"x":0,"y":0,"heading":0}}',
        '{"seq":1,"t":0,"event":"spoke","text":"a","robot":{}}',
        '{"seq":1,"t":0,"event":"scanned","objects":' + "[" * 100_000 + "]" * 100_000 + "}",
    ],
    ids=range(20),
)
def test_a_meaningless_line_is_no_event(line: str) -> None:
    with pytest.raises(DamagedLineError):
        stamped_in(line)


def test_brackets_in_a_text_do_not_count_as_nesting() -> None:
    stamped = Stamped(1, 0.0, Spoke("[{" * 1000 + '\\"'))

    assert again(stamped) == stamped


@given(st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
    max_leaves=8,
), st.sampled_from(EVENTS), st.data())  # fmt: skip
def test_a_line_with_any_value_in_a_field_is_refused_or_an_event(
    value: object, event: Event, data: st.DataObject
) -> None:
    record = json.loads(as_line(Stamped(1, 0.0, event), whole=True))
    record[data.draw(st.sampled_from(sorted(record)))] = value

    try:
        made = stamped_in(json.dumps(record))
    except DamagedLineError:
        return
    assert isinstance(made.event, get_args(Event))
    assert as_line(made, whole=True)


# --- a file of events


def head(**changes: object) -> str:
    out = StringIO()
    Header("1.2", 7, "sim", {"motors": 14}, {"name": "maze"}).write(out)
    return json.dumps({**json.loads(out.getvalue()), **changes}) + "\n"


def line(seq: int, event: Event, robot: str | None = None) -> str:
    return as_line(Stamped(seq, float(seq), event, robot), whole=True).rstrip("\n") + "\n"


BEGUN, ENDED = RunStarted("a.gd", "two", "alice", 3, "0.1"), RunEnded(Outcome.COMPLETED, HERE, {}, 1.0)


def recorded(*lines: str | bytes) -> Recording:
    return Recording(BytesIO(b"".join(each.encode() if isinstance(each, str) else each for each in lines)))


def test_a_recording_has_its_header_and_its_events() -> None:
    found = recorded(head(), line(1, BEGUN), line(2, Spoke("a")), line(3, ENDED))

    assert found.header == Header("1.2", 7, "sim", {"motors": 14}, {"name": "maze"})
    assert (found.damages, found.is_newer, found.is_cut_off_only) == ([], False, True)
    assert [each.seq for each in found.events] == [1, 2, 3]
    assert found.events[1].event == Spoke("a")
    assert [each.seq for each in found.events[-2:]] == [2, 3]
    assert [found.line_of(each) for each in (0, 2, 3)] == [2, 4, 5]


def test_long_texts_of_a_header_are_cut() -> None:
    found = recorded(head(version="v" * 50, robot="r" * 300), line(1, Reset(HERE)))

    assert found.header is not None
    assert (found.header.version, found.header.robot) == ("v" * 40, "r" * 200)


@pytest.mark.parametrize(
    ("lines", "damages"),
    [
        ((head(donnie_recording=2), line(1, Reset(HERE))), [Damage("newer", 1)]),
        ((head(donnie_recording="2"), line(1, Reset(HERE))), [Damage("header", 1)]),
        (("nothing\n", line(1, Reset(HERE))), [Damage("header", 1)]),
        ((line(1, Reset(HERE)),), [Damage("no-header", 1)]),
        ((head(), line(1, Reset(HERE)), "{}\n", line(2, Reset(HERE))), [Damage("line", 3)]),
        ((head(), line(1, Reset(HERE)), b"\xff\xfe\n", line(3, Reset(HERE))), [Damage("line", 3)]),
        ((head(), line(2, Reset(HERE))), [Damage("missing", 2, 1)]),
        ((head(), line(1, Reset(HERE)), line(5, Reset(HERE))), [Damage("missing", 3, 3)]),
        ((head(), line(1, Reset(HERE)), line(2, Reset(HERE))[:9]), [Damage("end", 3)]),
        ((head(), line(1, BEGUN)), [Damage("end", 3)]),
        ((head(), line(1, BEGUN), line(2, Reset(HERE))), []),
        ((head(), line(1, BEGUN, "alice"), line(2, ENDED, "bob")), [Damage("end", 4)]),
        ((head(), line(1, BEGUN), line(2, ENDED)[:9]), [Damage("end", 3)]),
    ],
)
def test_what_is_missing_in_a_recording_is_listed_with_its_line(
    lines: tuple[str | bytes, ...], damages: list[Damage]
) -> None:
    found = recorded(*lines)

    assert found.damages == damages
    assert found.is_newer is (damages == [Damage("newer", 1)])
    assert found.is_cut_off_only is all(each.code == "end" for each in damages)


@pytest.mark.parametrize("content", ["", "\n", "no recording\n", "{}\n[]\n"])
def test_a_file_without_a_whole_line_is_no_recording(content: str) -> None:
    with pytest.raises(NoRecordingError):
        recorded(content)


def test_a_hundred_damages_are_listed_at_most() -> None:
    found = recorded(head(), *["{}\n", line(1, Reset(HERE))] * 110)

    assert [each.line for each in found.damages] == list(range(2, 202, 2))
    assert len(found.events) == 110


def test_of_too_many_events_the_first_are_read(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(recording, "MOST_EVENTS", 2)
    two = (head(), line(1, Reset(HERE)), line(2, Reset(HERE)))

    assert [each.seq for each in recorded(*two, line(3, Reset(HERE))).events] == [1, 2]
    assert recorded(*two).damages == [Damage("too-many", 3)]


def test_a_line_that_is_too_long_is_damaged_and_the_next_one_is_read(monkeypatch: pytest.MonkeyPatch) -> None:
    first = line(1, Reset(HERE))
    monkeypatch.setattr(recording, "LONGEST_LINE", len(first))
    found = recorded(head(), first, line(2, Spoke("a" * 999)), line(3, Reset(HERE)))

    assert [each.seq for each in found.events] == [1, 3]
    assert found.damages == [Damage("line", 3)]


def test_before_its_first_event_a_recording_begins_at_line_one() -> None:
    assert recorded(head()).line_of(0) == 1


# --- limits of a line and of a header


def test_a_recording_has_the_limits_of_the_documentation() -> None:
    row = "| recording | 4 GiB, 5 million events, 16 MiB a line, 12 brackets in each other |"
    limits = (recording.LARGEST, recording.MOST_EVENTS, recording.LONGEST_LINE, recording.DEEPEST)

    assert row in Path("docs/reliability.md").read_text(encoding="utf-8").splitlines()
    assert limits == (2**32, 5_000_000, 2**24, 12)
    assert recording.LONGEST_HEADER == 2 * 32 * 2**20, "a world of 32 MiB with escapes"


@pytest.mark.parametrize(("depth", "is_event"), [(12, True), (13, False)])
def test_a_line_has_twelve_brackets_in_each_other_at_most(depth: int, is_event: bool) -> None:
    """Those of the line itself are the first; fields that are unknown are ignored."""
    inner = "[" * (depth - 1) + "]" * (depth - 1)
    text = f'{{"seq":1,"t":0,"event":"spoke","text":"a","more":[{"{},[]," * 20}0],"deep":{inner}}}'

    if is_event:
        assert stamped_in(text) == Stamped(1, 0.0, Spoke("a"))
    else:
        with pytest.raises(DamagedLineError, match="too deep"):
            stamped_in(text)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("{", "no JSON"),
        ("[1]", "no object"),
        ('{"seq":1,"t":0}', "unknown event"),
        ('{"seq":1,"t":1e999,"event":"spoke","text":"a"}', "no JSON"),
        ('{"seq":1,"t":Infinity,"event":"spoke","text":"a"}', "no JSON"),
        ('{"seq":1,"t":-Infinity,"event":"spoke","text":"a"}', "no JSON"),
    ],
)
def test_a_line_that_is_no_event_says_why(text: str, reason: str) -> None:
    with pytest.raises(DamagedLineError, match=reason):
        stamped_in(text)


@pytest.mark.parametrize("named", [True, False])
def test_a_run_names_its_robot_only_in_a_world_of_several(named: bool) -> None:
    how = HowStarted("FW 1", 1, True, False, False, HERE, named=named)
    stamped = Stamped(1, 0.0, RunStarted("a.gd", "two", "alice", 3, "0.1", how), "alice" if named else None)

    assert again(stamped) == stamped


@pytest.mark.parametrize(
    ("first", "is_whole", "code"),
    [
        (head(), True, None),
        ("\ufeff" + head(), True, None),
        (head(donnie_recording=0), False, "header"),
        (head(donnie_recording=1.5), False, "header"),
        (head(donnie_recording=2), False, "newer"),
        (head(seed="7"), False, "header"),
        (head(world=None), False, "header"),
        ('{"donnie_recording":1}\n', False, "header"),
        ("\n", False, "header"),
    ],
)
def test_a_header_is_read_whole_or_not_at_all(first: str, is_whole: bool, code: str | None) -> None:
    found = recorded(first, line(1, Reset(HERE)))

    assert (found.header is not None) is is_whole
    assert found.damages == ([] if code is None else [Damage(code, 1)])
    assert found.is_newer is (code == "newer")
    assert [each.seq for each in found.events] == [1]


@pytest.mark.parametrize(
    ("lines", "damages"),
    [
        ((head(), "{}\n", "{}\n", line(4, Reset(HERE))), [Damage("line", 2), Damage("line", 3)]),
        (
            (head(), "{}\n", line(2, Reset(HERE)), line(4, Reset(HERE))),
            [Damage("line", 2), Damage("missing", 4, 1)],
        ),
        ((head(), line(1, BEGUN), "{}\n"), [Damage("line", 3)]),
        ((head(), line(1, BEGUN), "{}\n", line(3, Spoke("a"))), [Damage("line", 3), Damage("end", 5)]),
        (
            (head(), line(2, Reset(HERE)), line(1, Reset(HERE)), line(2, Reset(HERE))),
            [Damage("missing", 2, 1)],
        ),
        ((head(), line(1, Reset(HERE)), "{}"), [Damage("end", 3)]),
        ((head(), line(1, Reset(HERE)), "\n"), [Damage("line", 3)]),
        ((line(1, BEGUN), line(2, ENDED)), [Damage("no-header", 1)]),
    ],
)
def test_what_follows_a_damaged_line_is_not_reported_a_second_time(
    lines: tuple[str, ...], damages: list[Damage]
) -> None:
    assert recorded(*lines).damages == damages


def test_an_event_is_read_again_from_its_place_and_a_changed_file_is_noticed() -> None:
    file = BytesIO((head() + line(1, Reset(HERE)) + line(2, Spoke("a"))).encode())
    found = Recording(file)
    assert len(found.events) == 2
    assert [found.events[each].seq for each in (1, 0, -1)] == [2, 1, 2]
    assert [each.seq for each in found.events[::-1]] == [2, 1]
    assert [found.line_of(each) for each in (0, 1, 2, 9)] == [2, 3, 4, 4]
    file.seek(0)
    file.write(b" " * len(file.getvalue()))
    with pytest.raises(OSError, match="line 3 has changed"):
        found.events[1]


def test_a_header_may_be_longer_than_an_event_and_a_longer_one_is_damaged(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    first = head()
    monkeypatch.setattr(recording, "LONGEST_HEADER", len(first))
    monkeypatch.setattr(recording, "LONGEST_LINE", len(line(1, Reset(HERE))))
    assert len(first) > recording.LONGEST_LINE
    assert recorded(first, line(1, Reset(HERE))).damages == []
    monkeypatch.setattr(recording, "LONGEST_HEADER", len(first) - 1)
    assert recorded(first, line(1, Reset(HERE))).damages == [Damage("header", 1)]


def test_the_header_is_in_its_file_at_once(tmp_path: Path) -> None:
    """A session that is killed leaves it there."""
    with (tmp_path / "a.jsonl").open("w") as out:
        Header("1.2", 7, "sim", {"motors": 14}, {"name": "maze"}).write(out)
        assert json.loads((tmp_path / "a.jsonl").read_text()) == json.loads(head())
