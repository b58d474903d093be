"""What the commands do where there is a screen: which pane is focused, what is chosen from lists, answers."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from devices.ports.robot import Pose
from donnie_tui.commands.declarations import COMMANDS, When
from donnie_tui.commands.interaction import SwitchMode
from donnie_tui.commands.keys import KeyTable
from donnie_tui.core.events import Chimed, Stamped
from donnie_tui.core.map_scene import MapScale, MapScene
from donnie_tui.core.map_words import Pointer
from tests.timeouts import TIMEOUT
from tests.unit.commands.scripted import Script

OpenScript = Callable[..., Script]


class Map:
    """A map on which nothing is painted."""

    def __init__(self, script: Script) -> None:
        donnie = script.donnie
        scene = MapScene(donnie.picture_now(), Pose(0, 0, 0), donnie.session.name)
        self.pointer, self.scale = Pointer(scene), MapScale(scene)
        self.zoom, self.shows_all, self.has_rulers, self.is_picture = 0, False, False, False
        self.has_names, self.has_colours, self.columns = False, True, 2

    def set_zoom(self, zoom: int) -> bool:
        """Whether it is possible: from 0 to 2 here."""
        if 0 <= zoom <= 2:
            self.zoom = zoom
        return self.zoom == zoom

    def show_all(self, whole: bool) -> None:
        self.shows_all = whole

    def show_names(self, labels: object) -> None:
        self.has_names = labels is not None

    def show_rulers(self, shown: bool) -> None:
        self.has_rulers = shown

    def show_picture(self, wanted: bool) -> None:
        self.is_picture = wanted


class Screen:
    """Writes down what it is asked for."""

    def __init__(self, script: Script) -> None:
        self.map = Map(script)
        self.called: list[str] = []
        self.log_text, self.log_kinds, self.log_filter = "the log", {"": 1, "robot": 2, "answer": 3}, "robot"
        self.is_plain = self.is_page = False
        self.key_table = KeyTable()
        self.pressed: list[str | None] = []

    def __getattr__(self, name: str) -> Callable[..., Any]:
        def called(*values: object, **named: object) -> None:
            words = (name, *map(str, values), *(f"{key}={value}" for key, value in named.items()))
            self.called.append(" ".join(words))

        return called

    async def complete(self) -> None:
        self.called.append("complete")

    def explore(self, change: Callable[[Pointer], object]) -> None:
        self.called.append("explore")
        change(self.map.pointer)

    def show_sensor_ranges(self, lines: list[object]) -> None:
        self.called.append(f"show_sensor_ranges {bool(lines)}")

    async def press_key(self, question: str, accepts: Callable[[str], str | None]) -> str | None:
        self.called.append(question)
        while (key := self.pressed.pop(0)) and (problem := accepts(key)):
            self.called.append(problem)
        return key


def on_screen(script: Script) -> Screen:
    script.ctx.screen = Screen(script)  # type: ignore[assignment]
    return script.ctx.screen  # type: ignore[return-value]


LONG = tuple(f"FW {number}" for number in range(1, 22))
CALLED = {
    "SHOW PROGRAM": "focus program",
    "SHOW MAP": "focus map",
    "SHOW LOG": "focus log",
    "SHOW VARIABLES": "focus variables",
    "HELP": "show_help is_everything=False",
    "HELP ALL": "show_help is_everything=True",
    "HELP KEYS": "show_keys",
    "KEYS": "show_keys",
    "MANUAL": "show_manual",
    "TOUR": "show_tour",
    "COMPLETE": "complete",
    "LOG": "show_in_pager the log",
}


@pytest.mark.parametrize("typed", CALLED)
def test_a_command_goes_to_its_part_of_the_screen_and_says_nothing(
    open_script: OpenScript, typed: str
) -> None:
    script = open_script("FW 1")
    screen = on_screen(script)

    assert (script.answers_to(typed), screen.called) == ([], [CALLED[typed]])


Said = list[str]
CONVERSATIONS: dict[str, tuple[tuple[str, Said, Said, Said], ...]] = {
    "reading": (
        ("READ 2", ["Line 2: TR 90"], ["focus program"], []),
        ("SEARCH FW", ["Line 1: FW 1"], ["focus program"], []),
        ("SEARCH nope", ["nope is not in the program."], [], []),
        ("NEXT", ["Line 2: TR 90"], ["focus program"], []),
        ("NEXT", ["That is the last line."], [], []),
        ("FIND FW", ["I have not said FW."], ["search_log FW 0"], []),
        ("GO TO", [], [], ["Line:"]),
        ("GO TO 1", ["Line 1: FW 1"], ["focus program"], []),
        ("GO TO 1 2", ["I did not understand. Type GO TO 3."], [], []),
        ("GO TO 9", ["There is no line 9. The last is 2."], [], []),
        ("LIST", ["1: FW 1", "2: TR 90"], [], []),
        *((each, ["There are no errors."], [], []) for each in ("ERRORS", "ERROR", "EXPLAIN")),
        ("FIX", ["No mistakes were found."], [], []),
    ),
    "the map": (
        ("NEXT THING", ["There are no things."], [], []),
        ("PREVIOUS THING", ["There are no things."], [], []),
        ("TO ROBOT", [], ["explore"], []),
        ("FROM HERE", ["From 0, 0."], ["explore"], []),
        ("TO THERE", ["From 0, 0 to 0, 0: here."], [], []),
        ("WHOLE MAP", ["All of the map, 1 step a square."], [], []),
        ("WHOLE MAP", ["The map follows the robot, 1 step a square."], [], []),
        ("NAMES", ["Names on the map."], [], []),
        ("NAMES", ["No names on the map."], [], []),
        ("COORDINATES", ["Coordinates next to the map."], [], []),
        ("COORDINATES", ["No coordinates."], [], []),
        ("PICTURE", ["The map is a picture."], [], []),
        ("PICTURE", ["The map is in letters."], [], []),
        ("SHOW PATH", ["I have not moved yet."], [], ["Path"]),
    ),
    "settings": (
        ("REDRAW", ["The screen is drawn again."], ["repaint"], []),
        ("PLAIN", ["Plain layout: on."], [], []),
        ("THEME light", ["Look: light."], [], []),
        ("THEME zzz", ["Look: light.", "Choose: dark, light, contrast, terminal."], [], []),
        ("THEME", ["Look: light."], [], ["Look", "dark", "light", "high contrast", "the terminal's own"]),
        ("DETAIL", ["Detail: normal."], [], ["Detail", "brief", "normal", "full"]),
        ("SET prompt", ["Only in the linear mode: type LINEAR."], [], []),
        ("SET volume", [], [], ["A number from 0 to 100: 100"]),
        ("SET volume 50", ["Set volume: 50."], [], []),
        ("VISUAL", ["This is the full screen."], [], []),
    ),
    "files": (
        ("RECENT", ["No program was opened yet."], [], []),
        (
            *("PROGRAMS", [], []),
            ["Open programs", "new program, 2 lines, changed", "another, empty program"],
        ),
        ("SAVE LOG", ["Nothing was changed."], [], ["Write the log into the file: log.txt"]),
        ("SAVE", ["Nothing was changed."], [], ["Which file name? program1.gd"]),
        ("SAVE walk", ["Saved walk.gd, 2 lines."], [], []),
        ("OPEN walk", ["Opened walk.gd, 2 lines."], [], []),
        ("PROGRAMS", [], [], ["Open programs", "walk.gd, 2 lines", "another, empty program"]),
    ),
    "robot": (
        ("RESET", ["I am back at the start."], ["robot_changed"], []),
        ("ROBOTS", ["There is one robot, donnie."], [], []),
        ("PUT box red 4 6", ["Box, red: at 4, 6. From the robot: 4 right, 6 ahead."], ["robot_changed"], []),
    ),
}  # fmt: skip


@pytest.mark.parametrize("subject", CONVERSATIONS)
def test_a_command_is_answered_and_shown(open_script: OpenScript, subject: str) -> None:
    script = open_script("FW 1", "TR 90")
    screen, asked = on_screen(script), script.interaction.asked
    for typed, *expected in CONVERSATIONS[subject]:
        screen.called.clear()
        asked.clear()
        assert [typed, script.answers_to(typed), screen.called, asked] == [typed, *expected]


def test_things_are_pointed_at_one_by_one(open_script: OpenScript) -> None:
    script = open_script(world="first_room")
    screen = on_screen(script)

    def place() -> tuple[int, int]:
        pointer = screen.map.pointer
        return pointer.scene.place(pointer.here)

    script.answers_to("NEXT THING")
    first = place()
    assert script.answers_to("FROM HERE") == [f"From {first[0]}, {first[1]}."]
    script.answers_to("NEXT THING")
    second = place()
    assert second != first
    (way,) = script.answers_to("TO THERE")
    assert way.startswith(f"From {first[0]}, {first[1]} to {second[0]}, {second[1]}: ")
    script.answers_to("PREVIOUS THING")
    assert place() == first
    script.answers_to("TO ROBOT")
    assert place() == (0, 0)


def test_the_map_is_zoomed_by_one(open_script: OpenScript) -> None:
    script = open_script()
    screen = on_screen(script)

    assert script.answers_to("ZOOM IN", "ZOOM IN", "ZOOM IN", "ZOOM OUT") == [
        *("The map follows the robot, 2 columns a square.", "The map follows the robot, 2 columns a square."),
        *("The nearest: 2 columns a square.", "The map follows the robot, 2 columns a square."),
    ]
    assert screen.map.zoom == 1
    screen.map.scale = MapScale(screen.map.scale.scene, 3)
    assert script.answers_to("ZOOM OUT", "ZOOM OUT") == [
        *("The map follows the robot, 3 steps a square.", "The farthest: 3 steps a square."),
    ]


def test_a_screen_without_colours_has_no_picture(open_script: OpenScript) -> None:
    script = open_script()
    screen = on_screen(script)
    screen.map.has_colours = False

    assert script.answers_to("PICTURE") == ["There are no colors here."]
    assert not screen.map.is_picture


def test_a_legend_and_a_map_that_is_not_there_yet(open_script: OpenScript) -> None:
    script = open_script(world="first_room")
    screen = on_screen(script)

    assert script.answers_to("LEGEND")[-1] == "s is small sofa, blue."
    assert script.interaction.asked == ["Legend"]
    screen.map.pointer = screen.map.scale = None  # type: ignore[assignment]
    assert script.answers_to("LEGEND", "TO THERE") == []
    assert script.answers_to("NEXT THING") == ["There are no things."]


def test_the_sensors_are_said_and_their_reach_is_shown(open_script: OpenScript) -> None:
    script = open_script()
    screen = on_screen(script)

    assert script.answers_to("SENSORS")[0] == "Donnie has:"
    assert screen.called == ["show_sensor_ranges True"]


@pytest.mark.parametrize(("lines", "titles"), [(20, []), (21, ["Program"])])
def test_more_than_twenty_lines_are_a_page(open_script: OpenScript, lines: int, titles: list[str]) -> None:
    script = open_script(*(f"FW {number}" for number in range(1, lines + 1)))
    on_screen(script)
    said = script.answers_to("LIST")

    assert script.interaction.asked == titles
    assert said[:2] == (["21 lines.", "21 lines."] if titles else ["1: FW 1", "2: FW 2"])


# --- mistakes

WRONG = ("FW 1", "FWD 3", "TR", "SPEAK 1")
FWD = ["Error, line 2, column 1: I do not know FWD.", "Line 2: FWD 3", "Did you mean FW?"]
TR = ["Error, line 3, column 1: TR needs a number, such as TR 90.", "Line 3: TR"]
ROWS = [
    *("2 errors.", "Line 2, FWD 3: I do not know FWD."),
    "Line 3, TR: TR needs a number, such as TR 90.",
]


def test_errors_are_chosen_from_a_list_and_shown_where_they_are(open_script: OpenScript) -> None:
    script = open_script(*WRONG, answers=["3 1", None])
    script.interaction.until_over = script.rest
    screen = on_screen(script)
    assert script.answers_to("RUN")[:5] == [*FWD, *TR]

    assert script.answers_to("ERRORS", "ERRORS") == []
    assert script.interaction.asked == ROWS * 2
    assert screen.called == ["focus program", "place_cursor 3 1"]
    screen.called.clear()
    assert script.answers_to("ERROR", "ERROR NEXT") == [*FWD, *TR]
    assert screen.called == ["place_cursor 2 1", "place_cursor 3 1"]
    screen.called.clear()
    assert script.answers_to("FIX", "FIX", "FIX") == [
        *("Line 3: TR 90", "Line 2: FW 3", "No mistakes were found.")
    ]
    assert screen.called == ["mark_mistakes"] * 2


def test_a_mistake_of_the_last_run_is_listed_while_its_line_is_the_same(open_script: OpenScript) -> None:
    script = open_script("FW 1", "SPEAK 1 / 0", answers=["2 7"])
    script.interaction.until_over = script.rest
    screen = on_screen(script)
    script.answers_to("AGAIN", "ERRORS")
    assert script.interaction.asked == ["1 error.", "Error, line 2, column 7: I can't divide by zero."]
    assert screen.called == ["focus program", "place_cursor 2 7"]

    script.interaction.asked.clear()
    said = script.answers_to("CHANGE 2 FW 1", "ERRORS")
    assert script.interaction.asked == []
    assert said[2] == "Error, line 2, column 7: I can't divide by zero."


def test_errors_in_one_column_are_said(open_script: OpenScript) -> None:
    script = open_script(*WRONG)
    on_screen(script).is_plain = True

    assert script.answers_to("ERRORS") == ROWS[1:]
    assert script.interaction.asked == []


# --- lists to choose from


def test_the_log_is_filtered_by_a_kind_of_its_lines(open_script: OpenScript) -> None:
    script = open_script(answers=["answer", "", None])
    screen = on_screen(script)

    assert script.answers_to("FILTER", "FILTER", "FILTER") == [
        *("Only answer: 3 lines.", "The log shows everything."),
    ]
    assert screen.called == ["filter_log answer", "filter_log "]
    assert script.interaction.asked[:4] == [
        *("Which lines does the log show?", "everything, 6 lines.", "robot, 2 lines.", "answer, 3 lines.")
    ]


def test_in_a_world_of_two_robots_one_is_chosen_from_the_list(open_script: OpenScript) -> None:
    script = open_script(world="two_robots", answers=["bob"])
    on_screen(script)
    places = ["alice: 0, 0, facing north.", "bob: 0, 30, facing south."]

    assert script.answers_to("ROBOTS")[:3] == ["Now you talk to alice.", *places]
    assert script.interaction.asked == ["Robots of this world", *places]
    assert script.donnie.session.name == "bob"


def test_another_program_begins_empty_and_the_first_is_turned_to_again(open_script: OpenScript) -> None:
    script = open_script("FW 1", answers=["new", "0"])
    on_screen(script)

    assert script.answers_to("PROGRAMS") == ["Now new program."]
    assert script.ctx.program.lines == ()
    assert script.answers_to("PROGRAMS") == ["Now new program."]
    assert script.ctx.program.lines == ("FW 1",)
    assert script.interaction.asked[3:] == [
        *("Open programs", "new program, 1 line, changed", "new program, 1 line"),
        "another, empty program",
    ]


def test_a_recent_program_is_opened_from_the_list(open_script: OpenScript, tmp_path: Path) -> None:
    script = open_script("FW 1", answers=[str(tmp_path / "walk.gd")])
    on_screen(script)
    script.answers_to("SAVE walk", "NEW")

    assert script.answers_to("RECENT") == ["Opened walk.gd, 1 line."]
    assert script.interaction.asked == ["Recent programs", f"walk.gd, {tmp_path}"]


def test_a_setting_is_chosen_from_the_list_of_all_until_the_learner_goes_back(
    open_script: OpenScript,
) -> None:
    script = open_script(answers=["volume", "40", "theme", "light", "cues", "bump", "25", None, None])
    on_screen(script)

    said = script.answers_to("SET")
    assert [each for each in said if each in ("Set volume: 40.", "Look: light.", "Set cue bump: 25.")] == [
        *("Set volume: 40.", "Look: light.", "Set cue bump: 25.", "Set cue bump: 25.")
    ]
    assert script.interaction.changed == ["volume", "theme", "cues"]
    assert script.interaction.asked.count("Settings") == 4


def test_a_wrong_value_is_asked_again(open_script: OpenScript) -> None:
    script = open_script(answers=["loud", "40"])
    on_screen(script)
    wanted = "A number from 0 to 100:"

    assert script.answers_to("SET volume") == ["Set volume: 40."]
    assert script.interaction.asked == [f"{wanted} 100", wanted]


# --- keys


def test_a_key_is_given_to_a_command_and_all_are_as_before(open_script: OpenScript) -> None:
    script = open_script(answers=["where", "", None])
    screen = on_screen(script)
    screen.pressed = ["a", "f5"]
    chosen: list[str] = []

    def setting_changed(key: str) -> None:
        chosen.append(script.ctx.preferences.value(key))
        screen.key_table.choose(chosen[-1])

    script.interaction.setting_changed = setting_changed  # type: ignore[method-assign]
    assert script.answers_to("CHANGE KEYS") == [
        *("Keys: F5 WHERE.", "WHERE: F5, Ctrl+K I.", "RUN: Esc.", "Keys: as usual."),
    ]
    assert screen.called[0] == "Press the key for WHERE."
    assert len(screen.called) == 2, "a letter is refused"
    assert chosen == ["where f5", ""]
    rows = script.interaction.asked
    assert "RUN: F5, Esc. Runs the program." in rows
    assert rows.count("All keys as usual") == 1


def test_a_key_of_no_command_is_not_changed(open_script: OpenScript) -> None:
    script = open_script(answers=["where", None])
    on_screen(script).pressed = [None]

    assert script.answers_to("CHANGE KEYS") == []
    assert script.interaction.changed == []


# --- ways out


def test_the_linear_mode_is_left_for_but_not_from_a_page(open_script: OpenScript) -> None:
    script = open_script()
    screen = on_screen(script)
    with pytest.raises(SwitchMode):
        script.type("LINEAR")
    screen.is_page = True

    assert script.answers_to("LINEAR", "SET prompt") == ["In a terminal only: donnie --linear"] * 2


def test_plain_is_switched_off_where_it_is_on(open_script: OpenScript) -> None:
    script = open_script()
    on_screen(script).is_plain = True

    assert script.answers_to("PLAIN") == ["Plain layout: off."]


# --- what the declarations say

FLAGS: dict[str, set[str]] = {
    "asked_by_key": {
        *("speed", "report", "change", "insert", "move", "put", "turn", "remove", "find", "map_row"),
        "map_column",
    },
    "at_cursor": {"run_to", "break_"},
    "is_about_now": {"around", "map", "map_row", "map_column", "map_picture", "sensors"},
    "is_live": {"stop", "stop_all", "robots", "pause", "slower", "faster", "speed", "quiet"},
    "needs_name": {"turn"},
    "needs_terminal": {"linear", "open_log"},
    "is_godonnie": {"run", "help", "quit"},
    "required": {
        *("report", "change", "insert", "move", "replace", "translate", "find", "map_row", "map_column"),
        *("robot", "put", "turn", "remove"),
    },
    "is_visual": {
        *("zoom_in", "zoom_out", "whole_map", "picture", "names", "coordinates", "legend", "next_thing"),
        *("previous_thing", "to_robot", "from_here", "to_there", "complete", "go_to", "filter", "recent"),
        *("programs", "theme", "plain", "redraw", "change_keys", "keys_here", "open_log"),
    },
}


@pytest.mark.parametrize("flag", FLAGS)
def test_a_few_commands_are_special(flag: str) -> None:
    assert {each.name for each in COMMANDS if getattr(each, flag)} == FLAGS[flag]


@pytest.mark.parametrize("name", sorted(FLAGS["asked_by_key"]))
def test_a_key_asks_for_what_the_word_needs(open_script: OpenScript, name: str) -> None:
    script = open_script("FW 1")
    on_screen(script)
    script.press(name)

    (question,) = script.interaction.asked
    assert question.endswith(":")
    assert script.printed == ["Nothing was changed."]


def test_a_key_gives_the_line_of_the_cursor(open_script: OpenScript) -> None:
    script = open_script("FW 1", "FW 2")
    on_screen(script)
    script.ctx.program.place = 2
    script.press("break_")

    assert script.printed == ["Breakpoint at line 2."]
    assert script.ctx.program.breakpoints == {2}


@pytest.mark.parametrize("name", [each.name for each in COMMANDS if each.when is not When.ALWAYS])
def test_what_is_not_possible_now_says_so(open_script: OpenScript, name: str) -> None:
    script = open_script("WAIT 1000", speed=1.0)
    on_screen(script)
    script.type("AGAIN")
    script.press(name)
    script.donnie.session.hub.wait_until_delivered(TIMEOUT)

    said = [each for each in script.printed if each != "Waiting 1000 seconds."]  # of the program, at any time
    assert said == ["A program is running. STOP stops it."]
    assert script.interaction.asked == []
    script.type("STOP")
    script.rest()


def test_the_word_pause_lets_no_robot_move_and_its_key_continues(open_script: OpenScript) -> None:
    script = open_script("WAIT 1000", "FW 1", speed=1000.0)
    on_screen(script)
    script.type("STEP")
    script.rest()
    for _ in range(2):
        script.type("PAUSE")
        assert script.printed[-1] == "Paused. Type CONTINUE to go on."
    assert script.ctx.runs.is_held

    script.press("pause")
    script.rest()
    assert "I walked 1 step forward." in script.printed


def test_the_settings_are_listed_with_name_value_and_purpose_and_the_last_one_is_marked(
    open_script: OpenScript,
) -> None:
    script = open_script(answers=["theme", "light", None])
    on_screen(script)
    script.type("SET")

    rows = {each.value: each for each in script.interaction.offered}
    assert rows["theme"].columns[:2] == ("Look", "light")
    assert rows["speed"].columns[:2] == ("Speed", "max")
    assert [each.value for each in rows.values() if each.is_current] == ["theme"]
    assert all(len(each.columns) == 3 and each.columns[2] for each in rows.values())
    assert not {"prompt", "page"} & {*rows}, "of the linear mode"


@pytest.mark.parametrize(
    ("typed", "asked"),
    [
        ("SET speed", "A number from 0.1 to 1000, or max: max"),
        ("SET keys", "Actions and keys, such as run f9, step f10:"),
        ("SET rate", "A number from 80 to 450: 180"),
    ],
)
def test_a_value_without_a_list_is_asked_for_with_the_present_one(
    open_script: OpenScript, typed: str, asked: str
) -> None:
    script = open_script()
    on_screen(script)

    assert (script.answers_to(typed), script.interaction.asked) == ([], [asked])


def test_a_free_name_is_proposed_for_a_new_program_and_its_own_for_another(open_script: OpenScript) -> None:
    script = open_script("FW 1", answers=[None, None, None, "mine", None])
    screen, asked = on_screen(script), script.interaction.asked

    script.answers_to("SAVE")
    Path("program1.gd").write_text("FW 1\n")
    script.answers_to("SAVE AS")
    screen.is_plain = True
    script.answers_to("SAVE")
    screen.is_plain = False
    assert script.answers_to("SAVE") == ["Saved mine.gd, 1 line."]
    assert script.answers_to("SAVE AS") == ["Nothing was changed."]
    assert asked == [
        *("Which file name? program1.gd", "Which file name? program2.gd"),
        *("Which file name? Enter means none.", "Which file name? program2.gd", "Which file name? mine.gd"),
    ]
    script.answers_to("PROGRAMS")
    assert [(each.value, each.is_current) for each in script.interaction.offered] == [
        *(("0", True), ("new", False)),
    ]


def test_the_keys_are_changed_from_the_list_of_settings(open_script: OpenScript) -> None:
    script = open_script(answers=["keys", None, None])
    on_screen(script)

    assert script.answers_to("SET") == []
    assert script.interaction.asked.count("Settings") == 2
    assert "RUN: F5, Esc. Runs the program." in script.interaction.asked


@pytest.mark.parametrize(
    ("key", "said"),
    [
        ("f5", ["Keys: F5 WHERE.", "WHERE: F5, Ctrl+K I.", "RUN: Esc."]),
        ("ctrl+k i", ["Keys: Ctrl+K I WHERE.", "WHERE: Ctrl+K I."]),
    ],
)
def test_of_a_changed_key_it_is_said_which_commands_have_which_keys_now(
    open_script: OpenScript, key: str, said: list[str]
) -> None:
    script = open_script(answers=["where", None])
    screen = on_screen(script)
    screen.pressed = [key]
    script.interaction.setting_changed = lambda _: screen.key_table.choose(  # type: ignore[method-assign]
        script.ctx.preferences.value("keys")
    )

    assert script.answers_to("CHANGE KEYS") == said


def test_a_cue_sounds_once_when_its_volume_is_changed(open_script: OpenScript) -> None:
    script, chimed = open_script(), list[str]()

    def note(stamped: Stamped) -> None:
        if isinstance(stamped.event, Chimed):
            chimed.append(stamped.event.name)

    script.donnie.team.stream.subscribe(note)
    assert script.answers_to("SET cue bump 60", "SET cue bump") == ["Set cue bump: 60."] * 2
    assert chimed == ["bump"]


def test_no_world_is_offered_on_a_screen_while_this_one_is_recorded(open_script: OpenScript) -> None:
    for record in (None, "a.rec"):
        script = open_script(record=record)
        on_screen(script)
        said = script.answers_to("WORLDS")

        assert bool(script.interaction.offered) is (record is None)
        assert any(each.startswith("I stay in this world: a.rec") for each in said) is (record is not None)
