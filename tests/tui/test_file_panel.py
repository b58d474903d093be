"""The tree of programs to open, alone: its rows, its keys and its answers."""

from __future__ import annotations

from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager, nullcontext
from pathlib import Path
from typing import Any

import pytest
from textual.app import App
from textual.pilot import Pilot

from donnie_tui.i18n.words import Words
from donnie_tui.tui.screens.file_panel import FilePanel, Row


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    made = tmp_path / "home"
    (made / "sub" / "deep").mkdir(parents=True)
    (made / "empty").mkdir()
    for name in ("apple.gd", "bear.gd", "walk.gd", "sub/cat.gd", "sub/deep/dog.gd"):
        (made / name).write_text("FW 1\n")
    monkeypatch.chdir(made)
    monkeypatch.setenv("HOME", str(tmp_path))
    return made


class Opened:
    """A panel and what it has said and answered."""

    def __init__(self, text: str, recent: Sequence[Path], is_new: bool) -> None:
        self.said: list[str] = []
        self.answers: list[Any] = []
        self.app = App[None]()
        self._how = text, recent, is_new
        self.panel: FilePanel
        self.pilot: Pilot[None]

    async def begin(self) -> None:
        text, recent, is_new = self._how
        self.panel = FilePanel(
            "Which file?", text, lambda: recent, Words("en"), self.said.append,
            checking=lambda _: nullcontext(), is_new=is_new,
        )  # fmt: skip
        self.app.push_screen(self.panel, self.answers.append)
        await self.pilot.pause()
        await self.rest()

    @property
    def rows(self) -> list[str]:
        """The rows as they are painted, indented, the chosen one with its mark."""
        tree = self.panel.files
        shown = []
        for line in range(tree.last_line + 1):
            node = tree.get_node_at_line(line)
            assert node is not None
            row: Row | None = node.data
            assert row is not None
            depth = len(tree._tree_lines[line].path) - 2
            shown.append(
                "  " * depth + tree.render_label(node, tree.rich_style, tree.rich_style).plain.rstrip()
            )
        return shown

    @property
    def line(self) -> str:
        return self.panel._line.value

    @property
    def title(self) -> str:
        return str(self.panel._title.render()).strip()

    async def press(self, *keys: str) -> list[str]:
        """What is said after the keys."""
        self.said.clear()
        await self.pilot.press(*keys)
        await self.rest()
        return [*self.said]

    async def rest(self) -> None:
        await self.app.workers.wait_for_complete()
        await self.pilot.pause()
        await self.app.workers.wait_for_complete()
        await self.pilot.pause()


@asynccontextmanager
async def opened(
    text: str = "", recent: Sequence[Path] = (), *, is_new: bool = False, size: tuple[int, int] = (100, 40)
) -> AsyncIterator[Opened]:
    it = Opened(text, recent, is_new)
    async with it.app.run_test(size=size) as it.pilot:
        await it.begin()
        yield it


TREE = [
    *(" - home/  ~", "   ../  the folder above", "   apple.gd", "   bear.gd", "   walk.gd"),
    *(" + empty/", " + sub/"),
]
RECENT = [" - Recent programs", "   walk.gd", "   cat.gd  sub/"]
Steps = list[tuple[str, list[str]]]


async def check(it: Opened, steps: Steps) -> None:
    for keys, said in steps:
        assert (keys, await it.press(*keys.split())) == (keys, said)


async def test_rows_are_chosen_and_folders_opened_and_closed() -> None:
    async with opened() as it:
        assert it.said == ["Which file?"]
        assert it.rows == TREE
        await check(it, [
            ("right", []),
            ("left", []),
            ("down", ["home/, open folder"]),
            ("down", ["../, the folder above"]),
            ("down", ["apple.gd"]),
            ("right", []),
            ("end", ["sub/, closed folder"]),
            ("enter", ["sub/, open folder"]),
            ("right", ["cat.gd"]),
            ("down", ["deep/, closed folder"]),
            ("right", ["deep/, open folder"]),
            ("right", ["dog.gd"]),
            ("left", ["deep/, open folder"]),
            ("left", ["deep/, closed folder"]),
            ("left", ["sub/, open folder"]),
        ])  # fmt: skip
        assert it.rows == [*TREE[:6], ">- sub/", "     cat.gd", "   + deep/"]
        await check(it, [
            ("up", ["empty/, closed folder"]),
            ("enter", ["empty/, open folder"]),
            ("down", ["No programs here."]),
            ("enter", []),
            ("home", ["home/, open folder"]),
            ("left", ["home/, closed folder"]),
            ("left", []),
        ])  # fmt: skip
        assert it.rows == [">+ home/  ~"]
        assert it.answers == []
        await it.press("escape")
    assert it.answers == [None]


async def test_recent_programs_come_first_and_enter_chooses_the_first(home: Path) -> None:
    recent = [home / "walk.gd", home / "sub" / "cat.gd"]
    async with opened(recent=recent) as it:
        assert it.rows == [*RECENT, *TREE]
        await check(it, [("enter", ["walk.gd"]), ("down", ["cat.gd, sub/"])])
        await it.press("tab")
        assert it.line == "sub/cat.gd"
        await it.press("ctrl+u")
        await check(it, [("enter", ["walk.gd"]), ("enter", [])])
    assert it.answers == [home / "walk.gd"]


async def test_typed_letters_narrow_the_tree_and_are_completed(home: Path) -> None:
    async with opened(recent=[home / "walk.gd"]) as it:
        await check(it, [("a", []), ("enter", ["3 programs fit. Type more, or choose with Down."])])
        assert it.title == "3 programs fit. Type more, or choose with Down."
        await it.press("backspace", "b")
        assert it.title == "Which file?"
        assert it.rows == [" - home/  ~", "   bear.gd", " + sub/"]
        await it.press("tab")
        assert it.line == "bear.gd"
        await it.press("backspace", "backspace", "enter")
    assert it.answers == [home / "bear.gd"]


async def test_a_typed_folder_is_shown_and_its_names_are_completed(home: Path) -> None:
    async with opened() as it:
        await it.press("s", "u", "tab")
        assert (it.line, it.rows) == (
            "sub/",
            [" - sub/  ~/home", "   ../  the folder above", "   cat.gd", " + deep/"],
        )
        await it.press("c", "tab")
        assert (it.line, it.rows) == ("sub/cat.gd", [" - sub/  ~/home", "   cat.gd"])
        await it.press("enter")
    assert it.answers == ["sub/cat.gd"]


async def test_a_folder_that_is_entered_is_not_answered_and_its_way_leads_above() -> None:
    async with opened() as it:
        await it.press("s", "u", "b")
        await it.press("enter")
        assert (it.line, it.answers) == ("sub/", [])
        await check(it, [("down down", ["sub/, open folder", "../, the folder above"]), ("enter", [])])
        assert it.line == ""
        assert it.rows == [*TREE[:6], " - sub/", "     cat.gd", "   + deep/"]


async def test_a_name_that_fits_nothing_is_answered_as_it_was_typed() -> None:
    async with opened() as it:
        await it.press("a", "p", "left", "home", "x", "end", "y")
        assert it.line == "xapy"
        assert it.rows == [" - home/  ~", "   Nothing has that name."]
        await it.press("enter")
    assert it.answers == ["xapy"]


async def test_a_new_name_does_not_narrow_the_tree_and_goes_into_the_folder_that_is_opened(
    home: Path,
) -> None:
    async with opened("old.gd", [home / "walk.gd"], is_new=True) as it:
        assert it.said == ["Which file? old.gd"]
        assert it.rows == [" + Recent programs", *TREE]
        await it.press("n", "e", "w")
        assert (it.line, it.rows) == ("new", [" + Recent programs", *TREE])
        await check(it, [("down", ["Recent programs, closed folder"]), ("end", ["sub/, closed folder"])])
        await it.press("enter")
        assert it.line == "sub/new"
        assert it.rows[-3:] == [" - sub/", "     cat.gd", "   + deep/"]
        await it.press("down", "down", "down", "enter")
        assert it.line.endswith("/new")
        await it.press("ctrl+u", "b", "e", "a", "enter")
    assert it.answers == ["bea"]


async def test_a_page_is_chosen_and_long_lists_are_shown_in_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("donnie_tui.tui.screens.file_panel.MOST_SHOWN", 3)
    async with opened(size=(60, 12)) as it:
        await check(it, [
            ("pagedown", ["2 more"]), ("pageup", ["home/, open folder"]),
            ("down down down down down", [
                *("../, the folder above", "apple.gd", "bear.gd", "walk.gd", "2 more"),
            ]),
        ])  # fmt: skip
        await it.press("enter")
        assert it.rows[-2:] == [" + empty/", " + sub/"]


async def test_a_folder_that_can_not_be_read_says_why(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from donnie_tui.core.program_files import DocumentError

    def fail(path: Path, _inside: object) -> None:
        raise DocumentError("file-unreadable", str(path), "why not")

    monkeypatch.setattr("donnie_tui.tui.screens.file_panel.programs_in", fail)
    async with opened() as it:
        assert [each for each in it.said if "why not" in each]
        assert "why not" in " ".join(it.rows)


# --- names


@pytest.mark.parametrize(
    ("path", "shown"),
    [("{home}", "~/home"), ("{home}/sub", "~/home/sub"), ("{home}/..", "~"), ("/tmp", "/tmp")],
)
def test_a_path_below_the_account_is_short(home: Path, path: str, shown: str) -> None:
    from donnie_tui.tui.screens.file_panel import _short

    assert _short(Path(path.format(home=home)).resolve()) == shown


@pytest.mark.parametrize(
    ("typed", "what"),
    [("sub", "folder"), ("sub/", "folder"), ("apple.gd", "file"), ("apple", "file"), ("x", "")],
)
def test_a_typed_name_is_that_of_a_folder_or_a_file_or_of_neither(typed: str, what: str) -> None:
    from donnie_tui.tui.screens.file_panel import _named

    assert _named(typed) == what


def test_a_typed_folder_is_below_home_or_the_account(home: Path, tmp_path: Path) -> None:
    from donnie_tui.tui.screens.file_panel import _below

    assert _below(home, "sub/") == home / "sub"
    assert _below(home, "~/x/") == tmp_path / "x"
    assert _below(home, "/tmp/") == Path("/tmp")
    assert _below(home, "~no-such-account/") == home / "~no-such-account"
