"""The main screens as pictures and as text, kept in the folder ``snapshots`` and reviewed like code.

Made anew on purpose with ``pytest tests/tui/test_screens.py --snapshot-update``.
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import pytest
from pytest_textual_snapshot import SVGImageExtension
from syrupy.assertion import SnapshotAssertion
from syrupy.extensions.single_file import SingleFileSnapshotExtension, WriteMode

from donnie_tui.robot.search import RobotOption
from donnie_tui.tui.themes import CONTRAST, DARK, LIGHT

F = TypeVar("F", bound=Callable[..., Any])
SNAPSHOTS = Path(__file__).resolve().parents[2] / "snapshots"

RECTANGLE = """\
PROCEDURE RECTANGLE: base, height DO
REPEAT 2 TIMES
  FW base TR 90
  FW height TR 90
END REPEAT
END PROCEDURE
-- five steps by three
RECTANGLE [5, 3]
SPEAK "done\""""

ONE_PANE, SMALL, LARGE, PROJECTOR = SIZES = (40, 12), (80, 24), (120, 40), (200, 60)
THEMES = (DARK, LIGHT, CONTRAST)


def by_size(size: tuple[int, int]) -> str:
    return f"{size[0]}x{size[1]}"


def looks(*sizes: tuple[int, int]) -> Callable[[F], F]:
    """At each size. The quick check has the usual size of a terminal only."""
    each = [
        pytest.param(size, id=by_size(size), marks=() if size == SMALL else pytest.mark.slow)
        for size in sizes or SIZES
    ]
    return pytest.mark.parametrize("size", each)


class InOneFolder:
    """Keeps the files in the project's folder of screens, not next to the test."""

    @classmethod
    def dirname(cls, *, test_location: Any) -> str:
        return str(SNAPSHOTS / test_location.basename)


class Picture(InOneFolder, SVGImageExtension):
    """An SVG."""


class Words(InOneFolder, SingleFileSnapshotExtension):
    """The same screen as text, which everybody can review."""

    _write_mode = WriteMode.TEXT
    _file_extension = "txt"


@pytest.fixture
def same(snapshot: SnapshotAssertion):
    """``same(screen)``: the screen is as it was kept: its text, and a picture in each theme."""

    async def compare(screen, themes: tuple[str, ...] = THEMES) -> None:
        await screen.painted()
        assert screen.text + "\n" == snapshot.use_extension(Words)
        for theme in themes:
            screen.app.theme = theme
            await screen.painted()
            assert screen.app.export_screenshot() == snapshot.use_extension(Picture)(name=theme)

    return compare


@looks()
async def test_the_start(open_screen, same, size):
    async with open_screen(size=size, world="living_room") as screen:
        await same(screen)


@looks()
async def test_a_rectangle_was_walked(open_screen, same, size):
    async with open_screen(size=size, world="living_room") as screen:
        await screen.run(RECTANGLE)
        await same(screen)


@looks()
async def test_a_pause_inside_a_procedure(open_screen, same, size):
    async with open_screen(RECTANGLE, size=size, world="living_room") as screen:
        screen.main.editor.go_to(4)
        await screen.press("f10")
        await screen.shows("Line 4, level 2: FW height")
        await same(screen)


@looks()
async def test_what_a_line_computes(open_screen, same, size):
    text = "VAR n = 3\nREPEAT 2 TIMES\nn = n * 2 + 1\nFW n\nEND REPEAT"
    async with open_screen(text, size=size, world="living_room") as screen:
        for step in ("Line 1", "Line 2", "Line 3", "Line 4", "Line 2", "Line 3, "):
            count = len([line for line in screen.log if line.startswith(step)])
            await screen.press("f7")
            await screen.until(
                lambda step=step, count=count: len([x for x in screen.log if x.startswith(step)]) > count,
                step,
            )
        await screen.until(lambda: "n * 2 + 1 = 15" in screen.text or "= 7 * 2 + 1" in screen.text, "the sum")
        if size[0] < 110:
            screen.main.toggle_inspector()
        await screen.painted()
        await same(screen)


@looks()
async def test_the_list_of_worlds(open_screen, same, size):
    async with open_screen(size=size, world="living_room") as screen:
        screen.app.do("worlds")
        await screen.until(lambda: "Living room" in screen.text and "Worlds" in screen.text, "the list")
        await screen.press("down", "down")
        await screen.painted()
        await same(screen)


@looks()
async def test_a_mistake(open_screen, same, size):
    async with open_screen(RECTANGLE.replace("TR", "RIGTH"), world="living_room", size=size) as screen:
        await screen.press("f5")
        await screen.shows("Error, line 3")
        await screen.idle()
        await screen.until(lambda: screen.main.editor.mistake, "the marks beside the program")
        await same(screen)


@looks()
async def test_the_variables(open_screen, same, size):
    async with open_screen('VAR a = 5 VAR d = DISTANCE F SPEAK "ready"\nFW 1', size=size) as screen:
        await screen.press("f7", "f9", "f9", "f9")
        await screen.shows("Line 2: FW 1")
        await screen.press("f4")
        await same(screen)


@pytest.mark.parametrize("language", ["pt", "es"])
async def test_other_languages(open_screen, same, language):
    text = (
        "REPITA 2 VEZES PF 3 GD 90 FIM REPITA"
        if language == "pt"
        else "REPETIR 2 VECES AV 3 GD 90 FIN REPETIR"
    )
    async with open_screen(text, language=language, world="living_room") as screen:
        await screen.press("f5")
        await screen.shows("terminou." if language == "pt" else "terminó.")
        await same(screen, themes=(screen.app.theme,))


async def test_the_terminal_s_own_colours(open_screen, same, monkeypatch):
    monkeypatch.setenv("NO_COLOR", "1")
    async with open_screen(world="living_room") as screen:
        await screen.run(RECTANGLE)
        await same(screen, themes=(screen.app.theme,))


async def opened(screen, *keys: str, typed: str = "") -> None:
    await screen.press(*keys)
    if typed:
        await screen.type_line(typed)
    await screen.until(lambda: screen.app.screen is not screen.main, "another screen")
    await screen.pilot.pause()


@pytest.fixture
def programs(tmp_path, monkeypatch):
    """The folder of a learner, two programs of which were opened lately."""
    folder = tmp_path / "programs"
    (folder / "lessons").mkdir(parents=True)
    names = [folder / name for name in ("square.gd", "stairs.gd", "lessons/first.gd", "lessons/second.gd")]
    for each in names:
        each.write_text("FW 1\n")
    (tmp_path / "recent.txt").write_text(f"{names[2]}\n{names[0]}\n")
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.chdir(folder)
    return folder


SCREENS = {
    "palette": ("ctrl+p",),
    "menu": ("ctrl+k",),
    "settings": ("ctrl+k", "comma"),
    "manual": ("ctrl+k", "f1"),
    "words": ("ctrl+@",),
    "outline": ("ctrl+l",),
    "legend": ("ctrl+k", "l"),
    "worlds": ("ctrl+k", "o"),
    "keys": ("ctrl+k", "0"),
    "help": ("f1",),
    "programs": ("ctrl+k", "b"),
    "save": ("ctrl+s",),
    "unsaved": ("ctrl+n",),
    "replace": ("ctrl+k", "r"),
}
WORDS = {"themes": "SET theme", "languages": "LANGUAGE", "typed": "TYPED", "robots": "ROBOT"}
"""Lists that have no key."""


@looks()
@pytest.mark.parametrize("name", SCREENS)
async def test_each_screen(open_screen, same, programs, name, size):
    async with open_screen(RECTANGLE, size=size, world="living_room") as screen:
        screen.main.editor.move_cursor((2, 0))
        await opened(screen, *SCREENS[name])
        if name == "save":
            await screen.until(lambda: "stairs.gd" in screen.text, "the programs")
        await screen.painted()
        await same(screen)


@looks()
async def test_the_programs_to_open(open_screen, same, programs, size):
    async with open_screen(RECTANGLE, size=size, world="living_room") as screen:
        await opened(screen, "ctrl+o")
        await screen.until(lambda: screen.app.screen.files.last_line > 5, "the programs")
        await screen.press("down", "end", "right")
        await screen.until(lambda: screen.app.screen.files.last_line > 8, "the folder")
        await screen.press("down")
        await screen.painted()
        await same(screen)


@looks()
async def test_programs_that_fit_what_is_typed(open_screen, same, programs, size):
    async with open_screen(RECTANGLE, size=size, world="living_room") as screen:
        await opened(screen, "ctrl+o")
        await screen.until(lambda: screen.app.screen.files.last_line > 5, "the programs")
        await screen.press("s")
        await screen.until(
            lambda: "square.gd" in screen.text.splitlines()[screen.app.cursor_position.y], "the offer"
        )
        await screen.press("enter")
        await screen.until(lambda: "3 programs fit." in screen.text, "the number")
        await screen.painted()
        await same(screen)


@looks()
async def test_the_place_for_a_new_program(open_screen, same, programs, size):
    async with open_screen(RECTANGLE, size=size, world="living_room") as screen:
        await opened(screen, "ctrl+k", "s")
        await screen.until(lambda: "stairs.gd" in screen.text, "the folder")
        await screen.press("down", "end", "enter")
        await screen.until(lambda: "lessons/program1.gd" in screen.text, "the name in the folder")
        await screen.painted()
        await same(screen)


@looks()
@pytest.mark.parametrize("name", WORDS)
async def test_each_list(open_screen, same, name, size):
    async with open_screen(RECTANGLE, size=size, world="two_robots") as screen:
        await screen.type_line("WHERE")
        await opened(screen, typed=WORDS[name])
        await same(screen)


@looks()
async def test_the_list_of_mistakes(open_screen, same, size):
    text = "FW 1\nFWD 3\nREPEAT 2 TIMES\nFW 1\nEND REPEET\nSPEAK a"
    async with open_screen(text, size=size, world="living_room") as screen:
        await screen.until(lambda: screen.main.editor.mistakes, "the marks")
        await opened(screen, typed="ERRORS")
        await same(screen)


@looks()
async def test_changing_a_key(open_screen, same, size):
    async with open_screen("FW 1", size=size) as screen:
        await screen.type_line("CHANGE KEYS")
        await screen.until(lambda: "RUN: F5, Esc" in screen.text, "the list")
        await screen.press(*"run:", "enter")
        await screen.until(lambda: "Press the key for RUN." in screen.text, "the question")
        await same(screen)


@looks()
async def test_the_map_with_names_rays_and_coordinates(open_screen, same, size):
    async with open_screen(size=size, world="living_room") as screen:
        await screen.run("FW 3 TR 45 SPEAK DISTANCE F")
        await screen.press("ctrl+k", "c", "ctrl+k", "t")
        await screen.shows("Names on the map.")
        await screen.press("ctrl+k", "n")
        await screen.until(lambda: screen.app.focused is screen.main.map, "the finger")
        await screen.painted()
        await same(screen)


@looks()
async def test_two_robots_on_a_nearer_map(open_screen, same, size):
    """The map: things, trails, headings; in 40 columns it has the screen to itself."""
    async with open_screen("FW 2\nTR 90\nFW 3", size=size, world="two_robots") as screen:
        await screen.press("f5")
        await screen.shows("The program is done.")
        await screen.idle()
        screen.main.go_to(screen.main.map_pane)
        screen.main.map.set_zoom(1)
        await screen.painted()
        await same(screen)


@looks()
async def test_the_map_as_a_picture(open_screen, same, size):
    async with open_screen("FW 3 TR 90 FW 5", world="living_room", size=size) as screen:
        await screen.press("f5")
        await screen.shows("The program is done.")
        await screen.idle()
        screen.main.go_to(screen.main.map_pane)
        await screen.press("ctrl+k", "p")
        await screen.shows("The map is a picture.")
        await screen.painted()
        await same(screen)


@looks()
async def test_a_large_map_that_follows_the_robot(open_screen, same, size):
    async with open_screen(world="living_room", size=size) as screen:
        await screen.press("ctrl+k", "a")
        await screen.shows("The map follows")
        if size == ONE_PANE:
            screen.main.go_to(screen.main.map_pane)
        await screen.painted()
        await same(screen)


@looks()
async def test_the_plain_layout(open_screen, same, size):
    async with open_screen("FW 3", size=size, world="living_room", plain=True) as screen:
        await screen.press("f5")
        await screen.shows("The program is done.")
        await same(screen)


@looks()
async def test_mistakes_and_breakpoints_next_to_the_program(open_screen, same, size):
    async with open_screen(
        "FW 1\nFWD 3\nREPEAT 2 TIMES\nFW 1\nEND REPEAT", world="living_room", size=size
    ) as screen:
        screen.main.editor.go_to(4)
        await screen.press("ctrl+b")
        await screen.until(lambda: "!2" in screen.text, "the mark")
        await screen.shows("Breakpoint at line 4.")
        await same(screen)


@looks()
async def test_the_tour(open_screen, same, size):
    async with open_screen("FW 1", size=size, world="living_room") as screen:
        await screen.type_line("TOUR")
        await screen.until(lambda: "Tour 1 of" in screen.text, "the tour")
        await screen.press("enter")
        await screen.until(lambda: "Tour 2 of" in screen.text, "the second page")
        await screen.painted()
        await same(screen)


@looks()
async def test_charts_of_what_was_measured(open_screen, same, size):
    text = "REPEAT 6 TIMES\nFW 2\nSPEAK DISTANCE F\nEND REPEAT"
    async with open_screen(text, size=size, world="living_room") as screen:
        await screen.press("f5")
        await screen.shows("The program is done.")
        await screen.idle()
        if size != (200, 60):
            screen.main.go_to(screen.main.inspector_pane)
            await screen.press("end")
        await screen.painted()
        await same(screen)


@looks()
async def test_looking_back(open_screen, same, size):
    async with open_screen(RECTANGLE, size=size, world="living_room") as screen:
        await screen.press("f5")
        await screen.shows("The program is done.")
        await screen.idle()
        for _ in range(4):
            await screen.type_line("STEP BACK")
        await screen.until(
            lambda: sum(line.startswith(("Back: ", "Before ")) for line in screen.log) == 4, "the answers"
        )
        await screen.until(lambda: "LOOKING BACK" in screen.text, "the badge")
        await screen.painted()
        await same(screen)


@looks()
async def test_the_examples_for_an_empty_program(open_screen, same, size):
    async with open_screen(size=size, world="living_room") as screen:
        await screen.press(*"EXAMPLES", "enter")
        await screen.until(lambda: "A square" in screen.text, "the list")
        await screen.until(lambda: not screen.main.editor.mistakes, "no mark of a half typed word")
        await screen.press("down")
        await screen.painted()
        await same(screen)


@looks()
async def test_a_program_that_was_changed_while_it_runs(open_screen, same, size):
    text = "FW 1\nREPEAT 2 TIMES\n  WAIT 1000\nEND REPEAT"
    async with open_screen(text, size=size, world="living_room", speed=5.0) as screen:
        await screen.press("f5")
        await screen.shows("Waiting 1000 seconds.")
        await screen.until(lambda: "Line 3 of 4, in REPEAT" in screen.status, "the line that runs")
        await screen.press("end", "space", *"TR", "space")
        await screen.shows("You changed the program.")
        await screen.until(lambda: "TR needs" in screen.text, "the mark of the line")
        await screen.painted()
        await same(screen)


@looks()
async def test_a_log_in_which_a_word_was_found(open_screen, same, size):
    """With the marks, and the number of lines."""
    async with open_screen(size=size, world="living_room") as screen:
        await screen.run(RECTANGLE)
        await screen.idle()
        await screen.type_line("FIND walked")
        await screen.shows("4 lines")
        screen.main.go_to(screen.main.log_pane)
        await screen.painted()
        await same(screen)


@looks(ONE_PANE, SMALL)
async def test_a_word_that_is_offered_in_a_block_with_its_end(open_screen, same, size):
    async with open_screen(size=size, world="living_room") as screen:
        await screen.press(
            *"REPEAT", "space", *"4", "space", *"TIMES", "enter", *"FW", "space", *"1", "enter"
        )
        await screen.press(*"REPE")
        await screen.until(lambda: [each.line for each in screen.main.editor.mistakes] == [3], "the mark")
        assert screen.main.editor.suggestion == "AT"
        await same(screen)


@looks()
async def test_the_kinds_of_lines_to_show(open_screen, same, size):
    async with open_screen(size=size, world="living_room") as screen:
        await screen.run(RECTANGLE)
        await screen.idle()
        await opened(screen, typed="FILTER")
        await screen.press("down", "down")
        await same(screen)


@looks(ONE_PANE, SMALL)
async def test_a_log_of_one_kind(open_screen, same, size):
    async with open_screen(size=size, world="living_room") as screen:
        await screen.run(RECTANGLE)
        await screen.idle()
        await opened(screen, typed="FILTER")
        await screen.press(*"turned", "enter")
        await screen.shows("Only turned: 4 lines.")
        screen.main.go_to(screen.main.log_pane)
        await same(screen)


@looks()
async def test_a_program_that_was_stopped(open_screen, same, size):
    text = "FW 1\nREPEAT 2 TIMES\n  WAIT 1000\nEND REPEAT"
    async with open_screen(text, size=size, world="living_room", speed=5.0) as screen:
        await screen.press("f5")
        await screen.shows("Waiting 1000 seconds.")
        await screen.press("f8")
        await screen.shows("Stopped at line 3.")
        await screen.idle()
        await screen.until(lambda: "STOPPED" in screen.text, "the badge")
        await same(screen)


@looks()
async def test_the_list_of_challenges(open_screen, same, size):
    async with open_screen(size=size, world="living_room") as screen:
        await opened(screen, typed="CHALLENGE")
        await screen.press("down", "down")
        await same(screen)


@looks()
async def test_the_robots_to_connect_to(open_screen, same, monkeypatch, size):
    """In use, not plugged in, and one to try: a port of this machine would be in the picture."""
    async with open_screen(size=size, world="living_room") as screen:
        connection = screen.app.controller.donnie.connection
        first, *_, last = connection.options()
        board = RobotOption("serial:/dev/ttyACM9", "robot at /dev/ttyACM9")
        monkeypatch.setattr(connection, "options", lambda: (first, board, last))
        await opened(screen, typed="CONNECT")
        await same(screen)


@looks(ONE_PANE, SMALL)
@pytest.mark.parametrize("zoom", [pytest.param(2, id="4x2"), pytest.param(3, id="6x3")])
async def test_the_largest_squares_of_the_map(open_screen, same, zoom, size):
    async with open_screen("TR 90 FW 4", size=size, world="first_room") as screen:
        await screen.press("f5")
        await screen.shows("The program is done.")
        await screen.idle()
        screen.main.go_to(screen.main.map_pane)
        screen.main.map.set_zoom(zoom)
        await same(screen)


@looks()
async def test_a_challenge(open_screen, same, size):
    """The task, the goals and their places on the map."""
    async with open_screen("TR 90", size=size, world="challenge:to_the_ball") as screen:
        await screen.press("f5")
        await screen.idle()
        await screen.until(lambda: "turned" in " ".join(screen.log), "the turn")
        screen.main.go_to(screen.main.inspector_pane if size == ONE_PANE else screen.main.program_pane)
        await screen.painted()
        await same(screen)
