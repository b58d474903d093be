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

SMALL, LARGE = (80, 24), (120, 40)


CONTRAST = "donnie-contrast"


def by_size(size: tuple[int, int]) -> str:
    return f"{size[0]}x{size[1]}"


THEMES = [
    pytest.param("donnie-dark", id="dark"),
    pytest.param(CONTRAST, id="contrast", marks=pytest.mark.slow),
]


def looks(*sizes: tuple[int, int]) -> Callable[[F], F]:
    """At the usual two sizes and these, in the default and in the high-contrast theme."""

    def parametrized(test: F) -> F:
        of_size = pytest.mark.parametrize("size", [SMALL, LARGE, *sizes], ids=by_size)
        return of_size(pytest.mark.parametrize("theme", THEMES)(test))

    return parametrized


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
    """``same(desk)``: the screen is as it was kept."""

    async def compare(desk) -> None:
        await desk.pilot.pause()
        assert desk.screen + "\n" == snapshot.use_extension(Words)
        assert desk.app.export_screenshot() == snapshot.use_extension(Picture)

    return compare


@looks()
async def test_the_start(work, same, theme, size):
    async with work(size=size, world="living_room") as desk:
        desk.app.theme = theme
        await same(desk)


@looks()
async def test_a_rectangle_was_walked(work, same, theme, size):
    async with work(size=size, world="living_room") as desk:
        desk.app.theme = theme
        await desk.run(RECTANGLE)
        await same(desk)


@looks((40, 12))
async def test_a_pause_inside_a_procedure(work, same, theme, size):
    async with work(RECTANGLE, size=size, world="living_room") as desk:
        desk.app.theme = theme
        desk.place.editor.go_to(4)
        await desk.press("f10")
        await desk.shows("Line 4, level 2: FW height")
        await same(desk)


@looks()
async def test_a_mistake(work, same, theme, size):
    async with work(RECTANGLE.replace("TR", "RIGTH"), world="living_room", size=size) as desk:
        desk.app.theme = theme
        await desk.press("f5")
        await desk.shows("Error, line 3")
        await desk.idle()
        await desk.until(lambda: desk.place.editor.mistake, "the marks beside the program")
        await same(desk)


@looks()
async def test_the_variables(work, same, theme, size):
    async with work('VAR a = 5 VAR d = DISTANCE F SPEAK "ready"\nFW 1', size=size) as desk:
        desk.app.theme = theme
        await desk.press("f7", "f9", "f9", "f9")
        await desk.shows("Line 2: FW 1")
        await desk.press("f4")
        await same(desk)


@pytest.mark.parametrize("language", ["pt", "es"])
async def test_other_languages(work, same, language):
    text = (
        "REPITA 2 VEZES PF 3 GD 90 FIM REPITA"
        if language == "pt"
        else "REPETIR 2 VECES AV 3 GD 90 FIN REPETIR"
    )
    async with work(text, language=language, world="living_room") as desk:
        await desk.press("f5")
        await desk.shows("terminou." if language == "pt" else "terminó.")
        await same(desk)


async def test_the_terminal_s_own_colours(work, same, monkeypatch):
    monkeypatch.setenv("NO_COLOR", "1")
    async with work(world="living_room") as desk:
        await desk.run(RECTANGLE)
        await same(desk)


async def opened(desk, *keys: str, typed: str = "") -> None:
    await desk.press(*keys)
    if typed:
        await desk.type_line(typed)
    await desk.until(lambda: desk.app.screen is not desk.place, "another screen")
    await desk.pilot.pause()


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
    "tour": ("ctrl+k", "T"),
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
async def test_each_screen(work, same, name, theme, size):
    async with work(RECTANGLE, size=size, world="living_room") as desk:
        desk.app.theme = theme
        desk.place.editor.move_cursor((2, 0))
        await opened(desk, *SCREENS[name])
        await same(desk)


@looks()
@pytest.mark.parametrize("name", WORDS)
async def test_each_list(work, same, name, theme, size):
    async with work(RECTANGLE, size=size, world="two_robots") as desk:
        desk.app.theme = theme
        await desk.type_line("WHERE")
        await opened(desk, typed=WORDS[name])
        await same(desk)


@looks((40, 12))
async def test_changing_a_key(work, same, theme, size):
    async with work("FW 1", size=size) as desk:
        desk.app.theme = theme
        await desk.type_line("CHANGE KEYS")
        await desk.until(lambda: "RUN: F5, Esc" in desk.screen, "the list")
        await desk.press(*"run:", "enter")
        await desk.until(lambda: "Press the key for RUN." in desk.screen, "the question")
        await same(desk)


@looks()
async def test_the_map_with_names_rays_and_coordinates(work, same, theme, size):
    async with work(size=size, world="living_room") as desk:
        desk.app.theme = theme
        await desk.run("FW 3 TR 45 SPEAK DISTANCE F")
        await desk.press("ctrl+k", "c", "ctrl+k", "t")
        await desk.shows("Names on the map.")
        await desk.press("ctrl+k", "n")
        await desk.until(lambda: "Map," in desk.status, "the finger")
        await same(desk)


@looks()
async def test_the_whole_of_a_large_map(work, same, theme, size):
    async with work(world="living_room", size=size) as desk:
        desk.app.theme = theme
        await desk.press("ctrl+k", "a")
        await desk.shows("All of the map")
        await same(desk)


@looks((40, 12))
async def test_the_plain_layout(work, same, theme, size):
    async with work("FW 3", size=size, world="living_room", plain=True) as desk:
        desk.app.theme = theme
        await desk.press("f5")
        await desk.shows("The program is done.")
        await same(desk)


@looks()
async def test_mistakes_and_breakpoints_next_to_the_program(work, same, theme, size):
    async with work("FW 1\nFWD 3\nREPEAT 2 TIMES\nFW 1\nEND REPEAT", world="living_room", size=size) as desk:
        desk.app.theme = theme
        desk.place.editor.go_to(4)
        await desk.press("ctrl+b")
        await desk.until(lambda: "!2" in desk.screen, "the mark")
        await desk.shows("Breakpoint at line 4.")
        await same(desk)
