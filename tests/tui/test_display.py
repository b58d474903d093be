"""What the main screen shows of a session: titles, status line, keys, marks, log. No screen is painted."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from types import SimpleNamespace as Part
from typing import Any

import pytest

from devices.ports.robot import Bearing, Pose
from donnie_tui.bootstrap import assemble
from donnie_tui.commands.keys import KeyTable
from donnie_tui.core.events import Outcome, Read, RunEnded
from donnie_tui.core.map_grid import Cell, Kind
from donnie_tui.core.map_scene import MapScene
from donnie_tui.settings.settings import Settings
from donnie_tui.tui.display import Display
from donnie_tui.tui.event_queue import EventBatch
from tests.unit.commands.scripted import Script


class Place:
    """A main screen that writes down what it is to show."""

    def __init__(self) -> None:
        self.titles: dict[str, tuple[str, ...]] = {}
        self.said: tuple[str, ...] = ()
        self.badge: tuple[str, str] = ("", "")
        self.logged: list[tuple[str, str]] = []
        self.marked: tuple[object, ...] = ()
        self.inspected: tuple[str, ...] = ()
        self.offered: list[Any] = []
        self.updated: list[frozenset[Cell]] = []
        self.done: list[str] = []
        self.scene: MapScene | None = None
        self.is_plain = self.log_is_seen = self.is_small = False
        self.tour: Any = None
        self.editor = Part(
            text="FW 1",
            mistakes=(),
            mistake=None,
            line_count=3,
            line=2,
            has_focus=True,
            show_first_steps=lambda steps: self.done.append(f"first steps {len(steps)}"),
            mark=self.mark,
            follow=lambda line: self.done.append(f"follow {line}"),
        )
        self.map = Part(
            hidden=(),
            has_focus=False,
            pointer=None,
            is_exploring=False,
            call_colours=lambda colours: self.done.append("colours"),
            update_cells=self.updated.append,
            begin=lambda cells: self.done.append("map begins"),
            restart=lambda: self.done.append("map restarts"),
        )
        self.log_rows = Part(only="", has_focus=False, row=4, row_count=9, looks={})
        self.inspector = Part(size=Part(width=30), show=self.inspect, has_focus=False)
        self.command_line = Part(has_focus=False)
        self.keys = Part(offer=self.offer)
        self.status = Part(say=self.say)
        for name in ("inspector_pane", "map_pane", "log_pane", "program_pane"):
            setattr(self, name, Part(entitle=self.entitler(name)))

    def entitler(self, name: str) -> Callable[..., None]:
        def entitle(*titles: str, corner: str = "") -> None:
            self.titles[name] = (*titles, *([corner] if corner else []))

        return entitle

    def mark(self, *marks: object) -> None:
        self.marked = marks

    def inspect(self, lines: tuple[str, ...]) -> None:
        self.inspected = lines

    def offer(self, entries: list[Any]) -> None:
        self.offered = entries

    def say(self, *choices: str, badge: str = "", colour: str = "") -> None:
        self.said, self.badge = choices, (badge, colour)

    def log_lines(self, lines: list[tuple[str, str]]) -> None:
        self.logged += lines

    def show_map(self, scene: MapScene) -> None:
        self.scene = scene

    def show_slider(self, steps: object) -> None:
        self.done.append(f"slider {steps}")


class Shown:
    def __init__(self, world: str = "open_floor", *lines: str, **others: Any) -> None:
        settings = Settings(world=world, speed=None, speech="off", sound=False, **others)
        self.donnie = assemble(settings, terminal=True)
        self.script = Script(self.donnie)
        workspace = self.script.ctx.workspace
        workspace.begin_with(self.donnie.session.name)
        workspace.replace("".join(f"{each}\n" for each in lines), None, in_file="")
        self.place, self.table = Place(), KeyTable()
        self.display = Display(self.place, self.script.ctx, self.table)  # type: ignore[arg-type]

    def close(self) -> None:
        self.script.close()
        self.donnie.close()


@pytest.fixture
def show(tmp_path: Any, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., Shown]]:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    made: list[Shown] = []

    def one(*values: str, **others: Any) -> Shown:
        made.append(Shown(*values, **others))
        return made[-1]

    yield one
    for each in made:
        each.close()


def keys(shown: Shown) -> list[str]:
    return [each.action for each in shown.place.offered]


PROGRAM = ("FW 1", "TR 90", "SPEAK 1")
AT_START = "Donnie at 0, 0 facing north."
LINE = " Program, line 2 of 3."


# --- titles


def test_map_and_program_have_their_titles(show: Callable[..., Shown]) -> None:
    shown = show("first_room", *PROGRAM)
    shown.display.look()

    assert shown.place.titles == {
        "map_pane": ("Map: First room, 31 by 31", "Map: First room", "N ^"),
        "inspector_pane": ("Variables",),
        "program_pane": ("Program: new program, changed",),
    }
    assert shown.place.done == ["colours", "first steps 3"]
    shown.display.entitle_log()
    assert shown.place.titles["log_pane"] == ("Log",)
    shown.place.log_rows.only = "says"
    shown.display.entitle_log()
    assert shown.place.titles["log_pane"] == ("Log: only says",)


def test_with_several_robots_the_titles_name_one_and_the_sides_that_are_hidden(
    show: Callable[..., Shown],
) -> None:
    shown = show("two_robots")
    shown.place.map.hidden = ("east", "north")
    shown.display.entitle_map()
    shown.display.look()

    assert shown.place.titles["map_pane"][0] == "alice: Map: more E N, Two robots, 31 by 41"
    assert shown.place.titles["map_pane"][1] == "alice: Map: more E N, Two robots"
    assert shown.place.titles["program_pane"] == ("alice: Program: new program",)
    assert shown.place.said[0] == f"{LINE} alice at 0, 0 facing north. Speed max."


def test_a_small_screen_with_an_empty_program_says_how_to_begin(show: Callable[..., Shown]) -> None:
    shown = show("open_floor")
    shown.place.is_small = True
    shown.display.look()
    assert shown.place.titles["program_pane"] == ("Program: new program",)

    shown.place.editor.text = ""
    shown.display.looked()
    assert shown.place.titles["program_pane"] == ("F5 runs. F1 helps. LINEAR: text only",)
    assert keys(shown) == [
        *("run", "help", "examples", "challenge", "quit", "open", "show_variables", "ctrl+p")
    ]
    shown.place.is_small = False
    shown.display.look()
    assert shown.place.titles["program_pane"] == ("Program: new program",)


def test_a_challenge_shows_its_goals(show: Callable[..., Shown]) -> None:
    shown = show("challenge:1", "FW 1")
    shown.display.look()

    assert shown.place.titles["inspector_pane"] == ("Goals and variables",)
    goals = [
        *("Challenge: The first walk.", "Walk 5 steps to the north.", "Goals, 0 of 1 met:"),
        "[ ] Goal 1: You stopped 5 steps south of 0, 5.",
    ]
    assert list(shown.place.inspected) == [*goals, "No variables."]
    shown.place.is_plain = True
    shown.display.look()
    assert shown.place.inspected[3] == "Goal 1: You stopped 5 steps south of 0, 5."
    shown.script.answers_to("FW 5")
    shown.place.is_plain = False
    shown.display.look()
    assert shown.place.inspected[2] == "Goals, 1 of 1 met:"
    assert shown.place.inspected[3].startswith("[x] Goal 1: ")
    assert shown.display.scene.kind(shown.display.scene.cell_at(0, 5)) is Kind.GOAL


# --- the status line


def test_the_status_line_has_focus_robot_and_speed_as_far_as_there_is_room(
    show: Callable[..., Shown],
) -> None:
    shown = show("first_room", *PROGRAM)
    shown.display.look()

    assert shown.place.said == (
        f"{LINE} {AT_START} Speed max.", f"{LINE} {AT_START}", f" {AT_START}", LINE
    )  # fmt: skip
    assert shown.place.badge == ("READY", "$success")
    shown.place.editor.has_focus = False
    shown.display.say_status()
    assert shown.place.said == (f"{LINE} {AT_START} Speed max.", f"{LINE} {AT_START}", LINE)


def test_in_one_column_the_state_is_a_sentence_and_in_the_log_only_the_focus(
    show: Callable[..., Shown],
) -> None:
    shown = show("first_room", *PROGRAM)
    shown.place.is_plain = True
    shown.display.say_status()

    assert shown.place.said == (
        f"{LINE} {AT_START} Ready, speed max.", f"{LINE} {AT_START} Ready.", f"{LINE} Ready.", LINE
    )  # fmt: skip
    assert shown.place.badge == ("", "")
    shown.display.keep("Saved")
    assert shown.place.said[-2:] == (" Saved. Ready.", " Saved. ")
    shown.place.log_is_seen = True
    shown.display.say_status()
    assert shown.place.said == (LINE,)


@pytest.mark.parametrize(
    ("part", "sentence"),
    [
        ("map", "Map."),
        ("log_rows", "Log, line 5 of 9."),
        ("inspector", "Variables."),
        ("command_line", "Command line."),
    ],
)
def test_the_focus_is_said(show: Callable[..., Shown], part: str, sentence: str) -> None:
    shown = show("first_room")
    getattr(shown.place, part).has_focus = True

    assert shown.display.focus_sentence == sentence


def test_the_focus_on_the_tour_and_on_a_square_of_the_map_is_said(show: Callable[..., Shown]) -> None:
    shown = show("first_room")
    shown.place.tour = Part(has_focus=False, title="Tour, page 1")
    assert shown.display.focus_sentence == LINE.strip()
    shown.place.tour.has_focus = True
    assert shown.display.focus_sentence == "Tour, page 1."

    shown.place.map.has_focus, shown.place.map.pointer = True, Part(words=lambda _: "3, 2: free")
    assert shown.display.focus_sentence == "Map."
    shown.place.map.is_exploring = True
    assert shown.display.focus_sentence == "Map, 3, 2: free"
    shown.place.map.has_focus = False
    assert shown.display.focus_sentence == "Tour, page 1."


WRONG = "Program, line 2 of 3: I do not know FWD."


@pytest.mark.parametrize(
    ("meant", "said", "short"),
    [
        ("FW", f"{WRONG} Ctrl+T puts FW.", (" I do not know FWD. Ctrl+T: FW.", " I do not know FWD.")),
        ("", WRONG, (" I do not know FWD.",)),
    ],
)
def test_a_mistake_at_the_cursor_is_said_with_the_key_that_corrects_it(
    show: Callable[..., Shown], meant: str, said: str, short: tuple[str, ...]
) -> None:
    shown = show("first_room", *PROGRAM)
    shown.place.editor.mistake = Part(message="I do not know FWD.", meant=meant)
    shown.place.editor.mistakes = (shown.place.editor.mistake,)
    shown.display.look()

    assert shown.place.said == (
        f" {said} {AT_START} Speed max.", f" {said} {AT_START}", f" {said}", *short
    )  # fmt: skip
    assert keys(shown) == ["run", "help", "errors", "fix", "quit", "save", "open", "ctrl+p"]
    shown.place.editor.has_focus = False
    shown.display.say_status()
    assert shown.place.said[-1] == f" {said}"


def test_an_answer_stays_until_the_learner_acts_and_looks_elsewhere(show: Callable[..., Shown]) -> None:
    shown = show("first_room", *PROGRAM)
    answered = (
        f" Yes.{LINE} {AT_START} Speed max.", f" Yes.{LINE} {AT_START}", f" Yes. {AT_START}",
        f" Yes.{LINE}", " Yes. ",
    )  # fmt: skip
    shown.display.write([("Hello", "says"), ("Yes", "answer"), ("FW 1", "typed")])
    assert shown.place.said == answered

    shown.display.looked()
    assert shown.place.said == answered
    shown.display.acted()
    shown.display.say_status()
    assert shown.place.said == answered
    shown.display.looked()
    assert shown.place.said[0] == f"{LINE} {AT_START} Speed max."
    for sentence in ("Yes!", "Yes?", "Yes:"):
        shown.display.keep(sentence)
        assert shown.place.said[-1] == f" {sentence} "
    shown.display.looked()
    assert shown.place.said[-1] == " Yes: ", "nothing was pressed since"


# --- the log


def test_lines_of_the_log_have_the_words_of_their_kinds_but_answers_have_none(
    show: Callable[..., Shown],
) -> None:
    shown = show("open_floor")
    lines = [("Hello", "spoke"), ("FW 1", "typed"), ("Yes", "answer"), ("odd", "strange")]
    shown.display.write(lines)
    assert shown.place.logged == [("Hello", "says"), ("FW 1", "typed"), ("Yes", ""), ("odd", "strange")]
    assert set(shown.place.log_rows.looks) == {"says", "typed"}

    shown.place.logged.clear()
    shown.place.is_plain = True
    shown.display.write(lines)
    assert shown.place.logged == [("Hello", "says"), ("Yes", ""), ("odd", "strange")]
    shown.place.logged.clear()
    shown.script.ctx.words.language = "pt"
    shown.place.map.is_exploring = False
    shown.display.relabel()
    shown.display.write([("Hello", "spoke")])
    assert shown.place.logged == [("Hello", "fala")]
    assert shown.place.titles["log_pane"] == ("Registro",)
    assert shown.place.titles["inspector_pane"] == ("Variáveis",)
    assert shown.place.done[-3:-1] == ["colours", "map restarts"]
    assert shown.place.offered[0].words == "Executar"


# --- events


def test_a_batch_of_events_moves_the_robot_and_shows_what_was_read(show: Callable[..., Shown]) -> None:
    shown = show("open_floor", *PROGRAM)
    reads = tuple(Read("distance", "front", each) for each in (4, 5, 9))
    walked = EventBatch(
        poses=deque([Pose(0, 1, 0), Pose(0, 2, 0)]), readings={("distance", "front"): reads[-1]},
        measured=deque(reads), looks=deque(reads[-1:]), distances={Bearing.FRONT: 7},
    )  # fmt: skip
    shown.display.receive(walked)
    shown.display.say_status()

    assert shown.place.said[0] == f"{LINE} Donnie at 0, 2 facing north. Speed max."
    assert list(shown.place.inspected) == [
        *("No variables.", "Distances now:", "ahead      -     7     -", "            left ^ right"),
        *("behind     -     -     -", "Last readings:", "distance ahead: 9"),
        *("distance ahead over time:", "9|  *", " |", " | *", "4|*"),
    ]
    assert shown.display.scene.kind(shown.display.scene.cell_at(0, 1)) is Kind.TRAIL
    assert shown.display.scene.kind(shown.display.scene.cell_at(0, 4)) is Kind.RAY
    shown.place.is_plain = True
    shown.display.look()
    assert shown.place.inspected == (
        *("No variables.", "Distances now:", "ahead: 7", "Last readings:", "distance ahead: 9"),
    )

    shown.display.begin(Pose(0, 0, 0), fresh=False)
    shown.display.look()
    assert "Last readings:" in shown.place.inspected
    shown.place.is_plain = False
    shown.display.begin(Pose(0, 0, 0), fresh=True)
    shown.display.look()
    assert shown.place.done[-2:] == ["map begins", "first steps 3"]
    assert list(shown.place.inspected)[-1] == "behind     -     -     -"
    assert shown.display.scene.kind(shown.display.scene.cell_at(0, 1)) is Kind.FREE


def test_a_run_that_was_stopped_says_so_until_the_next_begins(show: Callable[..., Shown]) -> None:
    shown = show("open_floor", *PROGRAM)
    for outcome, badge in (
        (Outcome.STOPPED, ("STOPPED", "$error")),
        (Outcome.COMPLETED, ("READY", "$success")),
        (Outcome.STOPPED, ("STOPPED", "$error")),
    ):
        shown.display.end(RunEnded(outcome, Pose(1, 1, 90), (), 0.0))
        shown.display.say_status()
        assert shown.place.badge == badge
        assert "Donnie at 1, 1 facing east." in shown.place.said[0]
    shown.display.begin(Pose(0, 0, 0), fresh=False)
    shown.display.say_status()
    assert shown.place.badge == ("READY", "$success")


def test_marks_of_the_map_are_hidden_as_the_settings_say(show: Callable[..., Shown]) -> None:
    shown = show("open_floor", trail=False)
    shown.display.receive(EventBatch(poses=deque([Pose(0, 1, 0), Pose(0, 2, 0)])))
    assert shown.display.scene.kind(shown.display.scene.cell_at(0, 1)) is Kind.FREE

    shown.script.ctx.preferences.choose("trail", "on")
    shown.display.show_marks_of_map()
    assert shown.display.scene.kind(shown.display.scene.cell_at(0, 1)) is Kind.TRAIL


# --- while a program is held


def test_a_held_program_shows_its_line_and_its_keys(show: Callable[..., Shown]) -> None:
    shown = show("open_floor", *PROGRAM)
    shown.script.answers_to("BREAK 2", "AGAIN")
    shown.display.look()

    assert shown.place.marked == (2, frozenset(), ())
    assert shown.place.badge == ("PAUSED", "$warning")
    assert shown.place.said == (*(f" Line 2 of 3. {AT_START}",) * 2, *(" Line 2 of 3.",) * 2)
    assert shown.place.inspected == ("No variables.", "Calls:", "program, line 2")
    assert keys(shown) == [
        *("pause", "help", "quit", "stop", "step", "step_back", "step_over", "run_to", "show_variables"),
        "ctrl+p",
    ]
    assert [each.words for each in shown.place.offered[:5]] == ["Continue", "Help", "Quit", "Stop", "Step"]
    shown.display.keep("Yes")
    whole = (f" Yes. Line 2 of 3. {AT_START}", f" Line 2 of 3. {AT_START}")
    assert shown.place.said == (whole[0], " Yes. Line 2 of 3.", " Yes.")
    shown.place.log_is_seen = True
    shown.display.say_status()
    assert shown.place.said == (*whole, " Line 2 of 3.", " Yes.")

    shown.script.answers_to("STEP BACK")
    shown.display.look()
    shown.display.show_slider()
    assert shown.place.badge == ("LOOKING BACK, 1 OF 2", "$warning")
    assert shown.place.marked[0] == 1
    assert shown.place.done[-1] == "slider (1, 2)"
    shown.script.answers_to("STOP")
    shown.display.look()
    assert shown.place.marked == (None, frozenset(), ())


def test_the_block_of_the_running_line_and_the_calls_are_shown(show: Callable[..., Shown]) -> None:
    lines = ("PROCEDURE Walk: n DO", "FW n", "END PROCEDURE", "REPEAT 2 TIMES", "Walk [1]", "END REPEAT")
    shown = show("open_floor", *lines)
    shown.place.editor.line_count = 6
    shown.script.answers_to("BREAK 5", "AGAIN")
    shown.display.look()
    assert " Line 5 of 6, in REPEAT." in shown.place.said

    shown.script.answers_to("BREAK 2", "CONTINUE")
    shown.display.look()
    assert " Line 2 of 6, in Walk." in shown.place.said
    assert shown.place.marked[:2] == (2, frozenset({5}))
    assert list(shown.place.inspected)[:2] == [" name  value  was", "*n         1"]
    shown.place.editor.line_count = 1
    shown.display.say_status()
    assert " Line 2 of 1." in shown.place.said
    shown.script.answers_to("STOP")


def test_after_step_back_from_the_end_the_keys_are_those_of_the_way(show: Callable[..., Shown]) -> None:
    shown = show("open_floor", *PROGRAM)
    shown.script.interaction.until_over = shown.script.rest
    shown.script.answers_to("AGAIN", "STEP BACK")
    shown.display.look()

    assert keys(shown) == ["run", "help", "quit", "step_back", "step", "show_variables", "ctrl+p"]
    assert shown.place.badge[0].startswith("LOOKING BACK, ")


def test_distances_are_not_asked_for_while_one_column_runs(show: Callable[..., Shown]) -> None:
    shown = show("open_floor", "WAIT 1000")
    assert shown.display.shows_distances
    shown.donnie.session.speed = 1.0
    shown.script.type("AGAIN")
    shown.display.look()
    assert keys(shown)[:3] == ["stop", "help", "quit"]
    assert shown.place.badge == ("RUNNING x1", "$accent")
    assert shown.display.shows_distances
    shown.place.is_plain = True
    assert not shown.display.shows_distances
    shown.script.type("STOP")
    shown.script.rest()
    assert shown.display.shows_distances


def words_of(shown: Shown, name: str) -> str:
    return next(each.words for each in shown.place.offered if each.action == name)


def test_the_bottom_line_is_written_only_when_its_keys_change(show: Callable[..., Shown]) -> None:
    shown = show("open_floor", "WAIT 1000")
    shown.display.look()
    assert keys(shown)[1:4] == ["help", "quit", "step"]
    assert words_of(shown, "step") == "Step"
    shown.place.offered = []
    shown.display.look()
    assert shown.place.offered == []

    shown.donnie.session.speed = 1.0
    shown.script.type("AGAIN")
    shown.place.editor.mistakes = (1,)
    shown.display.look()
    assert keys(shown) == ["stop", "help", "quit", "pause", "slower", "faster", "show_variables", "ctrl+p"]
    assert words_of(shown, "pause") == "Pause"
    assert words_of(shown, "stop") == "Stop"
    shown.script.ctx.program.rewrite("WAIT 2")
    shown.display.look()
    assert shown.place.titles["program_pane"] == ("Program: new program, old text runs",)
    shown.script.type("STOP")
    shown.script.rest()


def test_the_past_of_a_run_is_shown_on_the_map_for_each_robot(show: Callable[..., Shown]) -> None:
    shown = show("two_robots", "FW 3", "TR 90")
    shown.script.answers_to("AGAIN")
    shown.display.receive(EventBatch(others={"bob": Pose(5, 30, 180)}))
    assert shown.display.scene.others["bob"] == shown.display.scene.cell_at(5, 30)
    timeline = shown.donnie.chronicle.timeline()
    timeline.go_to(len(timeline.events))
    shown.display.show_past(timeline)

    assert timeline.at == len(timeline.events)
    scene = shown.display.scene
    assert scene.pose == Pose(0, 3, 90)
    assert scene.kind(scene.cell_at(0, 2)) is Kind.TRAIL
    assert "alice at 0, 3 facing east." in shown.place.said[0]
    assert shown.place.done[-2] == "map restarts"
    timeline.go_to(0)
    shown.display.show_past(timeline)
    assert timeline.at == 0
    assert "alice at 0, 0 facing north." in shown.place.said[0]


def test_in_one_column_the_past_is_a_sentence(show: Callable[..., Shown]) -> None:
    shown = show("open_floor", *PROGRAM)
    shown.place.is_plain = True
    shown.script.answers_to("BREAK 2", "AGAIN", "STEP BACK")
    shown.display.say_status()

    assert shown.place.said[1] == f" Program, line 1 of 3. {AT_START} Looking back."
    shown.script.answers_to("STOP")


def test_the_belt_is_shown_from_its_first_change_on(show: Callable[..., Shown]) -> None:
    shown = show("open_floor")
    shown.display.look()
    before = shown.place.inspected
    shown.display.receive(EventBatch(belt=(0,) * 14))
    assert len(shown.place.inspected) > len(before)
    now = shown.place.inspected
    shown.place.inspected = ()
    shown.display.receive(EventBatch(poses=deque([Pose(0, 1, 0)])))
    assert shown.place.inspected == (), "a step alone is none of its lines"
    shown.display.look()
    assert shown.place.inspected == now


def test_the_variables_of_a_program_stay_after_its_end_but_are_not_those_of_the_past(
    show: Callable[..., Shown],
) -> None:
    shown = show("open_floor", "FW 1", "VAR n = 5")
    shown.script.interaction.until_over = shown.script.rest
    shown.script.answers_to("AGAIN")
    shown.display.look()
    assert [each.split() for each in shown.place.inspected if each.endswith("5")] == [["n", "5"]]
    shown.script.answers_to("STEP BACK")
    shown.display.look()
    assert not [each for each in shown.place.inspected if each.endswith("5")]


@pytest.mark.parametrize(("width", "columns"), [(30, 29), (24, 23), (10, 23)])
def test_a_chart_is_as_wide_as_the_inspector_but_for_a_column(
    show: Callable[..., Shown], width: int, columns: int
) -> None:
    shown = show("open_floor")
    shown.place.inspector.size.width = width
    reads = tuple(Read("distance", "front", at % 2) for at in range(40))
    shown.display.receive(EventBatch(measured=deque(reads), distances={Bearing.FRONT: 1}))

    assert max(len(each) for each in shown.place.inspected if "|" in each) == columns


def test_another_robot_that_is_read_about_changes_the_map_anew(show: Callable[..., Shown]) -> None:
    shown = show("two_robots")
    shown.script.answers_to("ROBOT bob")
    shown.display.show_world()

    assert shown.place.titles["map_pane"][0].startswith("bob: ")
    assert shown.place.scene is shown.display.scene
    assert shown.display.scene.pose == Pose(0, 30, 180)
