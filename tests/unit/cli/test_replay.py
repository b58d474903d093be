"""``donnie replay`` of recordings that the test writes: options, the map, typed words and lost outputs."""

from __future__ import annotations

import io
import sys
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from types import SimpleNamespace as Part
from typing import Any

import pytest

from devices.ports.robot import Pose
from donnie_tui import __version__
from donnie_tui.cli import replay
from donnie_tui.cli.main import main
from donnie_tui.cli.streams import Input
from donnie_tui.core.events import (
    Answered,
    Error,
    Event,
    HowStarted,
    Moved,
    Outcome,
    RunEnded,
    RunStarted,
    Spoke,
    Stamped,
    Turned,
    as_line,
)
from donnie_tui.core.recheck import Result, Verdict
from donnie_tui.core.recording import Header, Recording
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.process.confinement import Confinement, confine
from tests.sessions.command import QUIET
from tests.sessions.here import Here

START = Pose(0, 0, 0)
ROBOT = 'position ( name "{}" size [ 0.3 0.3 0.3 ] pose [ {} 0 0 90 ] )\n'
ONE, TWO = ROBOT.format("ana", 0), ROBOT.format("ana", 0) + ROBOT.format("rui", 2)
BELT = {"steps": [1, 2, 3], "columns": {}}


@pytest.fixture
def here(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Here:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.chdir(tmp_path)
    return Here(capsys, monkeypatch, tmp_path)


def begun(language: str = "en", robot: str | None = None, x: int = 0) -> RunStarted:
    how = HowStarted(*("FW 2", 1, True, False, False, Pose(x, 0, 0), language), named=robot is not None)
    return RunStarted("a.gd", "w", robot or "ana", 1, __version__, how)


def walked(steps: int, pose: Pose) -> Moved:
    return Moved(f"FW {steps}", steps, steps, None, pose, forward=True)


def turned(pose: Pose) -> Turned:
    return Turned("TR 90", 90, 90, None, pose, right=True)


def ended(pose: Pose) -> RunEnded:
    return RunEnded(Outcome.COMPLETED, pose, {}, 1.0)


def write(here: Here, *events: Event | tuple[str, Event], world: str = ONE, **changes: Any) -> None:
    """Write ``a.rec``; the name of a robot may be before an event."""
    robots = [name for name in ("ana", "rui") if f'"{name}"' in world]
    files = [{"name": "0/w.world", "text": world}]
    bundle = {"name": "w", "main": "0/w.world", "robots": robots, "files": files}
    out = io.StringIO()
    Header(__version__, 1, changes.get("robot", "sim"), BELT, changes.get("bundle", bundle)).write(out)
    for seq, each in enumerate(events, 1):
        robot, event = each if isinstance(each, tuple) else (None, each)
        out.write(as_line(Stamped(seq, 0.0, event, robot), whole=True).rstrip("\n") + "\n")
    (here.folder / "a.rec").write_text(out.getvalue(), encoding="utf-8")


TWO_RUNS = (
    *(("ana", begun(robot="ana")), ("ana", walked(2, Pose(0, 2, 0))), ("ana", ended(Pose(0, 2, 0)))),
    *(("rui", begun(robot="rui", x=20)), ("rui", turned(Pose(20, 0, 90))), ("rui", ended(Pose(20, 0, 90)))),
)
TURN = (begun(), walked(2, Pose(0, 2, 0)), turned(Pose(0, 2, 90)), ended(Pose(0, 2, 90)))


# --- running it again


def judged(here: Here, verdict: Verdict, version: str = __version__) -> list[str]:
    write(here, *TURN)
    lines = list[str]()
    with (here.folder / "a.rec").open("rb") as file:
        recording = Recording(file)
        order: Any = Part(words=Words(), output=Part(line=lines.append))
        replay._print_verdict(order, recording, Header(version, 1, "sim", BELT, {}), verdict)
    return lines


@pytest.mark.parametrize(
    ("result", "index", "sentence"),
    [
        (Result.SAME, 4, "Run again: 4 events are the same."),
        (Result.STOPPED, 3, "Run again: the same up to line 5, where it was stopped."),
        (Result.STOPPED, 4, "Run again: the same up to line 6, where it was stopped."),
    ],
)
def test_what_is_not_different_is_one_sentence(here: Here, result: Result, index: int, sentence: str) -> None:
    assert judged(here, Verdict(result, index), "0.1") == [sentence]


@pytest.mark.parametrize(
    ("index", "now", "said"),
    [
        (
            *(3, Spoke("a")),
            ["Run again: line 5 differs.", 'Then: {"seq":4,', 'Now: {"seq":9,"t":0.0,"event":"spoke"'],
        ),
        (4, Spoke("a"), ["Run again: line 6 differs.", "Then: nothing", 'Now: {"seq":9,']),
        (0, None, ["Run again: line 2 differs.", 'Then: {"seq":1,', "Now: nothing"]),
    ],
)
def test_a_difference_is_shown_with_what_was_and_what_is_there(
    here: Here, index: int, now: Event | None, said: list[str]
) -> None:
    happened = None if now is None else Stamped(9, 0.0, now)
    lines = judged(here, Verdict(Result.DIFFERENT, index, happened))

    assert [line[: len(begins)] for line, begins in zip(lines, said, strict=True)] == said


def test_a_difference_from_another_version_says_so(here: Here) -> None:
    said = judged(here, Verdict(Result.DIFFERENT, 0), "0.1\x07")

    assert said[3:] == [f"It was recorded with version 0.1 ; this is {__version__}."]


# --- options that do not go together


@pytest.mark.parametrize(
    ("options", "other", "one"),
    [
        (("--check", "--map"), "--map", "--check"),
        (("--check", "--step"), "--step", "--check"),
        (("--check", "--backwards"), "--backwards", "--check"),
        (("--check", "--speed", "2"), "--speed", "--check"),
        (("--check", "--from", "2"), "--from", "--check"),
        (("--check", "--events", "b.jsonl"), "--events", "--check"),
        (("--check", "--svg", "a.svg"), "--svg", "--check"),
        (("--check", "--challenge", "first_walk"), "--challenge", "--check"),
        (("--check", "--step", "--backwards"), "--step", "--check"),
        (("--step", "--events", "-"), "--events", "--step"),
        (("--step", "--backwards", "--events", "-"), "--events", "--step"),
        (("--step", "--report", "run"), "--report", "--step"),
        (("--backwards", "--challenge", "first_walk"), "--challenge", "--backwards"),
        (("--backwards", "--png", "a.png"), "--png", "--backwards"),
        (("--challenge=first_walk", "--map"), "--map", "--challenge"),
        (("--challenge=first_walk", "--from", "0"), "--from", "--challenge"),
        (("--challenge=first_walk", "--speed", "2"), "--speed", "--challenge"),
        (("--challenge=first_walk", "--events=-"), "--events", "--challenge"),
        (("--challenge=first_walk", "--gif=a.gif", "--map"), "--map", "--gif"),
        (("--svg=a.svg", "--events", "-"), "--events", "--svg"),
        (("--csv=a.csv", "--events", "-"), "--events", "--csv"),
        (("--backwards", "--events", "-"), "--events", "--backwards"),
    ],
    ids=" ".join,
)
def test_options_that_do_not_go_together_are_refused(
    here: Here, options: tuple[str, ...], other: str, one: str
) -> None:
    assert here.replay(*options, code=2, err=[f"{other} and {one} do not go together."]) == []


@pytest.mark.parametrize(
    "options",
    [
        ("--step", "--backwards", "--from", "2", "--map", "--speed", "max"),
        ("--svg", "a.svg", "--csv", "a.csv", "--challenge", "first_walk"),
        ("--backwards", "--map", "--from", "2"),
        ("--events", "b.jsonl", "--map"),
    ],
    ids=" ".join,
)
def test_options_that_go_together_are_obeyed(here: Here, options: tuple[str, ...]) -> None:
    write(here, *TURN)

    assert here.donnie("replay", "a.rec", *options).returncode == 0


@pytest.mark.parametrize(
    "option", ["--world=maze", "--robot=double", "--seed=3", "--belt=/dev/null", "--record=b.rec"]
)
def test_an_option_without_effect_is_refused(here: Here, option: str) -> None:
    name = option.partition("=")[0]
    sentence = f"A replay shows what has happened: {name} does nothing here."

    assert here.replay(option, code=2, err=[sentence]) == []
    assert not (here.folder / "b.rec").exists()


# --- the file


def test_a_file_is_read_up_to_the_largest_size(here: Here, monkeypatch: pytest.MonkeyPatch) -> None:
    write(here, *TURN)
    size = (here.folder / "a.rec").stat().st_size
    monkeypatch.setattr(replay, "LARGEST", size)
    here.replay()

    monkeypatch.setattr(replay, "LARGEST", size - 1)
    here.replay(code=2, err=["a.rec is too large for a recording, at most 0 gigabytes."])


def test_a_confined_session_reads_no_recording_outside(here: Here) -> None:
    write(here, *TURN)
    (here.folder / "ana").mkdir()
    confine(Confinement(str(here.folder / "ana")))
    try:
        with ExitStack() as closing, pytest.raises(Unusable) as refused:
            replay._opened(f"{here.folder}/a.rec", Words(), closing)
    finally:
        confine(None)

    assert refused.value.sentence == f"{here.folder}/a.rec is not in your folder. Stay in it."


@pytest.mark.parametrize("options", [("--svg", "a.svg"), ("--csv", "a.csv"), ("--report", "run")])
def test_a_recording_in_which_nothing_happened_has_no_picture(here: Here, options: tuple[str, ...]) -> None:
    write(here)

    assert here.replay(*options, code=2, err=["I have not moved yet."]) == []
    assert not [*here.folder.glob("a.[sc]*")]


def test_a_recording_without_its_world_has_no_picture_and_no_map(here: Here) -> None:
    write(here, *TURN)
    whole = (here.folder / "a.rec").read_bytes()
    (here.folder / "a.rec").write_bytes(whole.partition(b"\n")[2])

    done = here.donnie("replay", "a.rec", "--svg", "a.svg")
    assert (done.returncode, done.err[1:]) == (2, ["There is no map here."])
    assert here.donnie("replay", "a.rec", "--step", typed="END\nMAP\n").out[-1] == "There is no map here."


def test_a_damaged_world_is_said_once_and_the_rest_is_shown(here: Here) -> None:
    write(here, *TURN, Spoke("a"), bundle={"name": "w"})

    assert here.replay("--map", err=["The world in the recording is damaged."]) == ["a"]


@pytest.mark.parametrize("option", ["--svg", "--png", "--gif", "--swell", "--csv", "--report"])
def test_a_file_without_a_name_is_refused(here: Here, option: str) -> None:
    write(here, *TURN)

    refused = f"The option {option} needs a value. The option --help says more."
    assert here.replay(option, "", code=2, err=[refused]) == []


def test_the_end_of_a_name_may_be_in_capitals(here: Here) -> None:
    write(here, *TURN)

    assert here.replay("--report", "run R.SVG")[0] == "I wrote R.SVG."
    assert (here.folder / "R.SVG").read_text().startswith("<svg ")


def test_a_run_is_described_once_though_it_is_drawn_twice(here: Here) -> None:
    write(here, *TURN)

    said = here.replay("--report", "run")
    drawn = here.replay("--svg", "a.svg", "--png", "a.png", "--report", "run")

    assert said[0] == "The path starts at 0, 0."
    assert drawn[:2] == ["I wrote a.svg.", "I wrote a.png."]
    assert drawn[-len(said) :] == said
    assert drawn.count(said[0]) == 1


# --- the map


def robots_in(said: Sequence[str]) -> list[str]:
    """For each map the sign of the robot, or its title."""
    return ["^>"[">" in line] if "." in line else line for line in said if "^" in line or ">" in line]


@pytest.mark.parametrize(
    ("options", "signs"),
    [((), ""), (("--map",), "^>"), (("--map", "--backwards"), "^^"), (("--backwards",), "")],
)
def test_a_map_follows_each_movement_in_both_directions(
    here: Here, options: tuple[str, ...], signs: str
) -> None:
    write(here, *TURN)

    assert "".join(robots_in(here.replay(*options))) == signs


def test_a_map_is_that_of_the_robot_that_moved(here: Here) -> None:
    write(here, *TWO_RUNS, world=TWO)

    for options, titles in (((), ["ana", "rui"]), (("--backwards",), ["rui", "ana"])):
        said = here.replay("--map", *options)
        assert [each for each in said if each.startswith("Map")] == [f"Map of {name}." for name in titles]


def test_a_robot_without_a_place_has_no_map(here: Here) -> None:
    write(here, Spoke("a"), begun(), Spoke("b"), ended(START))

    said = here.replay("--step", typed="NEXT\nMAP\nNEXT\nMAP\n")
    assert said[1:4] == ["a", "There is no map here.", "Start of a.gd."]
    assert robots_in(said) == ["^"]


# --- typed words


def titles(here: Here, typed: str) -> list[str]:
    said = here.replay("--step", typed=typed)
    return [each for each in said if each.startswith(("Map", "There is no map"))]


@pytest.mark.parametrize(
    ("typed", "title"),
    [
        ("MAP", "There is no map here."),
        ("NEXT\nMAP", "Map of ana."),
        ("END\nMAP", "Map of rui."),
        ("END\nBACK\nMAP", "Map of rui."),
        ("END\nBACK\nBACK\nBACK\nMAP", "There is no map here."),  # rui has not begun
        ("END\nBACK\nBACK\nBACK\nBACK\nMAP", "Map of ana."),
        ("GO\nMAP", "Map of rui."),
        ("2\nMAP", "Map of ana."),
        ("END\nSTART\nMAP", "There is no map here."),
    ],
)
def test_the_map_of_a_step_is_that_of_the_robot_of_its_event(here: Here, typed: str, title: str) -> None:
    write(here, *TWO_RUNS, world=TWO)

    assert titles(here, f"{typed}\n") == [title]


def test_at_the_start_a_step_back_leads_nowhere(here: Here) -> None:
    write(here, *TWO_RUNS, world=TWO)

    said = here.replay("--step", typed="NEXT\nBACK\nBACK\n")
    assert said[1:] == ["ana: Start of a.gd.", "ana: Back: start of a.gd.", "This is the start."]


def test_a_place_is_said_of_each_robot_that_has_begun(here: Here) -> None:
    write(here, *TWO_RUNS, world=TWO)

    assert here.replay("--step", typed="WHERE\n2\nEND\n")[1:] == [
        "Event 0 of 6.",
        *("Event 2 of 6.", "ana: Position 0, 2. Facing north."),
        *("Event 6 of 6.", "ana: Position 0, 2. Facing north.", "rui: Position 20, 0. Facing east."),
    ]


def test_nothing_is_read_after_the_word_that_leaves(here: Here) -> None:
    write(here, *TURN)

    assert here.replay("--step", typed="QUIT\nNEXT\n") == ["4 events. Enter steps forward, BACK steps back."]
    assert sys.stdin.read() == "NEXT\n"


def test_a_longer_line_is_read_in_pieces_of_two_hundred_characters(here: Here) -> None:
    write(here, *TURN)

    unknown = "I do not know that word. HELP lists them."
    assert here.replay("--step", typed="x" * 199 + "\n")[1:] == [unknown]
    assert here.replay("--step", typed="x" * 200 + "NEXT\n")[1:] == [unknown, "Start of a.gd."]


def test_at_a_terminal_each_line_has_a_prompt(here: Here, monkeypatch: pytest.MonkeyPatch) -> None:
    write(here, *TURN)
    monkeypatch.setattr(Input, "is_terminal", True)

    said = here.replay("--step", typed="NEXT\n")
    assert said == ["4 events. Enter steps forward, BACK steps back.", "> Start of a.gd.", "> "]


def test_ctrl_c_at_the_prompt_ends_the_replay(here: Here, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object) -> str:
        raise KeyboardInterrupt

    write(here, *TURN)
    monkeypatch.setattr(Input, "line", interrupted)

    assert here.donnie("replay", "a.rec", "--step").returncode == 130


# --- the language of a run

WRONG = Error("syntax", 1, 1, "", None)


EN, PT, ES = "Error, line 1", "Erro na linha 1", "Error, línea 1"


def languages_of(said: Sequence[str]) -> list[str]:
    return [each for line in said for each in (EN, PT, ES) if line.startswith(each)]


@pytest.mark.parametrize(("before", "said"), [(99, [PT, PT]), (100, [EN, PT])])
def test_the_language_of_the_first_run_is_looked_for_in_a_hundred_events(
    here: Here, before: int, said: list[str]
) -> None:
    """It is that of what comes before the run, too."""
    write(here, WRONG, *[Spoke("a")] * (before - 1), begun("pt"), WRONG, ended(START))

    assert languages_of(here.replay()) == said


def test_each_run_has_its_language_and_one_that_is_not_known_changes_nothing(here: Here) -> None:
    by_nothing = RunStarted("a.gd", "w", "ana", 1, __version__)
    runs = [(each, WRONG, ended(START)) for each in (by_nothing, begun("xx"), begun("pt"), begun("es"))]
    write(here, *(event for run in (*runs, *runs[:2]) for event in run))

    assert languages_of(here.replay()) == [PT, PT, PT, ES, ES, ES]


# --- outputs that are lost


LEFT = "NEXT\n" * 3
"""What is not read yet."""


class Broken(io.StringIO):
    """An output whose reader goes away after so many lines."""

    def __init__(self, lines: int) -> None:
        super().__init__()
        self.left = lines

    def write(self, text: str) -> int:
        self.left -= text.endswith("\n")
        if self.left < 0:
            raise BrokenPipeError
        return super().write(text)


@pytest.mark.parametrize(
    ("options", "lines", "code", "left"),
    [
        ((), 1, 130, LEFT),
        ((), 2, 0, LEFT),
        (("--backwards",), 1, 130, LEFT),
        (("--step",), 0, 0, LEFT),
        (("--step",), 2, 0, "NEXT\n"),
    ],
)
def test_without_a_reader_a_replay_ends(
    here: Here,
    monkeypatch: pytest.MonkeyPatch,
    options: tuple[str, ...],
    lines: int,
    code: int,
    left: str,
) -> None:
    write(here, begun(), Spoke("a"), Spoke("b"), ended(START))
    out = Broken(lines)
    monkeypatch.setattr(sys, "stdout", out)
    monkeypatch.setattr(sys, "stdin", io.StringIO(LEFT))

    assert main(["replay", "a.rec", *options, *QUIET]) == code
    assert len(out.getvalue().splitlines()) == lines
    assert sys.stdin.read() == left


def test_a_file_of_events_that_is_lost_is_an_error(here: Here) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("needs a device that is always full")
    write(here, begun(), Spoke("a"), ended(START))

    done = here.donnie("replay", "a.rec", "--events", "/dev/full")
    assert done.returncode == 2
    assert done.out[-1] == "a"


@pytest.mark.parametrize(("with_words", "lines", "complaints"), [(True, ["a", "b"], []), (False, [], ["b"])])
def test_next_to_the_events_on_standard_output_answers_are_complaints(
    with_words: bool, lines: list[str], complaints: list[str]
) -> None:
    printed, complained = list[str](), list[str]()
    output: Any = Part(line=printed.append, complaint=complained.append)
    show = replay._printer(output, Words(), with_words=with_words)

    for event in (Spoke("a"), Answered("b")):
        show(Stamped(0, 0.0, event))
    assert (printed, complained) == (lines, complaints)
