"""The tree of programs to open, alone: its rows, its keys and its answers."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable, Iterator, Sequence
from contextlib import asynccontextmanager, nullcontext
from pathlib import Path
from typing import Any

import pytest
from textual._context import active_app
from textual.app import App
from textual.events import Click
from textual.pilot import Pilot
from textual.screen import Screen

from donnie_tui.core.program_files import ProgramEntry, programs_in
from donnie_tui.i18n.words import Words
from donnie_tui.tui.screens import file_panel
from donnie_tui.tui.screens.file_panel import FilePanel, Folder, Row, _is_same


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


# --- a panel that is not shown


class Unshown:
    """A panel whose folders are read at once, what it did, and what it said."""

    def __init__(self, home: Path, text: str = "", *, is_new: bool = False) -> None:
        self.done: list[Any] = []
        self.said: list[str] = []
        self.panel = panel = FilePanel(
            "Which file?", text, list, Words("en"), self.said.append,
            checking=lambda _: nullcontext(), is_new=is_new,
        )  # fmt: skip
        panel._home, panel._root = home, panel._folder(home)
        for each in (panel._root, self.folder("sub"), self.folder("sub/deep"), self.folder("empty")):
            each.entries = programs_in(each.path)
        panel._root.is_open = True
        panel._read = self.done.append  # type: ignore[assignment]
        panel._show = lambda: self.done.append("shown")  # type: ignore[method-assign]
        panel.dismiss = self.done.append  # type: ignore[assignment]

    def folder(self, name: str) -> Folder:
        return self.panel._folder(self.panel._home / name)

    def type(self, text: str) -> None:
        self.panel._line.value = text
        self.panel._is_typed = True
        self.done.clear()

    def does(self, call: Any) -> list[Any]:
        self.done.clear()
        call()
        return self.done


@pytest.fixture
def unshown(home: Path) -> Iterator[Callable[..., Unshown]]:
    app = App[None]()
    app._screen_stack.append(Screen[None]())
    token = active_app.set(app)
    yield lambda *given, **named: Unshown(home, *given, **named)
    active_app.reset(token)


@pytest.mark.parametrize(
    ("typed", "folder", "name", "top"),
    [
        ("ca", "", "ca", ""),
        ("sub/ca", "sub/", "ca", "sub"),
        ("  sub/deep/", "sub/deep/", "", "sub/deep"),
        ("/", "/", "", "/"),
        ("", "", "", ""),
    ],
)
async def test_what_is_typed_is_a_folder_that_is_shown_and_a_name_in_it(
    unshown: Callable[..., Unshown], home: Path, typed: str, folder: str, name: str, top: str
) -> None:
    it = unshown()
    it.panel._line.value = typed
    assert (it.panel._typed, it.panel._top()) == (("", ""), it.panel._root), "the learner typed nothing yet"
    it.type(typed)
    assert (it.panel._typed, it.panel._top().path) == ((folder, name), home / top)
    assert it.panel._top().name == (folder or "home/")
    assert it.panel._top() is it.panel._folder(home / top)


COMPLETED = {
    "a": "apple.gd",
    "APP": "apple.gd",
    "s": "sub/",
    "sub/c": "sub/cat.gd",
    "sub/d": "sub/deep/",
    "o": "odd2.gd",
    **dict.fromkeys(("", "sub/", "x", "pple", "nowhere/c", "empty/c"), ""),
}


@pytest.mark.parametrize(("typed", "completed"), COMPLETED.items())
async def test_a_name_is_completed_by_the_first_that_begins_so_and_can_be_typed(
    unshown: Callable[..., Unshown], home: Path, typed: str, completed: str
) -> None:
    it = unshown()
    odd = [
        ProgramEntry(home / f"odd{sign}.gd", f"odd{at}.gd", f"odd{at}.gd")
        for at, sign in ((1, "\n"), (2, "2"))
    ]
    it.panel._root.entries = (*it.panel._root.entries, *odd)
    assert it.panel._completed(typed) == completed
    it.panel._root.entries = None
    assert it.panel._completed("a") == ""


@pytest.mark.parametrize(
    ("typed", "opened", "fitting", "programs"),
    [
        ("", [], ["apple.gd", "bear.gd", "walk.gd", "empty/", "sub/"], ["apple.gd", "bear.gd", "walk.gd"]),
        ("a", [], ["apple.gd", "bear.gd", "walk.gd"], ["apple.gd", "bear.gd", "walk.gd"]),
        ("le pp", [], ["apple.gd"], ["apple.gd"]),
        ("a x", [], [], []),
        ("ub", [], ["sub/"], []),
        ("cat", [], [], []),
        ("cat", ["sub"], ["sub/"], ["sub/cat.gd"]),
        ("dog", ["sub"], [], []),
        ("dog", ["sub", "sub/deep"], ["sub/"], ["sub/deep/dog.gd"]),
        (" ", ["sub"], ["apple.gd", "bear.gd", "walk.gd", "empty/", "sub/"],
         ["apple.gd", "bear.gd", "sub/cat.gd", "walk.gd"]),
    ],
)  # fmt: skip
async def test_typed_letters_leave_what_has_them_and_open_folders_with_such_programs(
    unshown: Callable[..., Unshown], home: Path, typed: str, opened: list[str], fitting: list[str],
    programs: list[str],
) -> None:  # fmt: skip
    it = unshown()
    for each in opened:
        it.folder(each).is_open = True
    it.type(typed)
    assert [each.name for each in it.panel._fitting(it.panel._root)] == fitting
    assert it.panel._programs(it.panel._root) == {home / each for each in programs}
    new = unshown(is_new=True)
    new.type(typed)
    assert len(new.panel._fitting(new.panel._root)) == 5, "a new name narrows nothing"


@pytest.mark.parametrize(
    ("is_new", "typed", "recent", "shown"),
    [
        (False, "", False, ["home/"]),
        (False, "", True, ["Recent programs", "home/"]),
        (False, "walk", True, ["Recent programs", "home/"]),
        (False, "apple", True, ["home/"]),
        (False, "sub/", True, ["sub/"]),
        (True, "sub/new", True, ["Recent programs", "home/"]),
        (True, "/tmp/new", True, ["/tmp/"]),
    ],
)
async def test_recent_programs_are_above_the_folder_of_the_learner_and_a_new_name_leaves_its_tree(
    unshown: Callable[..., Unshown], home: Path, is_new: bool, typed: str, recent: bool, shown: list[str]
) -> None:
    it = unshown(is_new=is_new)
    entry = ProgramEntry(home / "walk.gd", "walk.gd", "walk.gd")
    it.panel._recent.entries = (entry,) if recent else ()
    it.type(typed)
    assert [each.name for each in it.panel._shown] == shown


@pytest.mark.parametrize(
    ("path", "as_folder", "as_file", "where"),
    [
        ("", "", "", ""),
        ("sub", "sub/", "sub", "sub/"),
        ("sub/deep", "sub/deep/", "sub/deep", "sub/deep/"),
        ("..", "{above}/", "{above}", "~"),
        ("/", "/", "/", "/"),
    ],
)
async def test_a_path_is_written_as_it_would_be_typed(
    unshown: Callable[..., Unshown], home: Path, path: str, as_folder: str, as_file: str, where: str
) -> None:
    it, full = unshown(), (home / path).resolve()
    above = str(home.parent)
    assert it.panel._written(full, is_folder=True) == as_folder.format(above=above)
    assert it.panel._written(full, is_folder=False) == as_file.format(above=above)
    assert it.panel._where(full) == where


async def test_a_row_is_taken_shown_further_left_for_the_folder_above_or_opened(
    unshown: Callable[..., Unshown], home: Path
) -> None:
    it = unshown()
    panel, sub = it.panel, it.folder("sub")
    assert it.does(lambda: panel._take(Row("apple.gd", path=home / "apple.gd"))) == [home / "apple.gd"]
    assert it.does(lambda: panel._take(Row("2 more", more=sub))) == ["shown"]
    assert (sub.most, panel._root.most) == (1000, 500)
    assert it.does(lambda: panel._take(Row("sub/", folder=sub))) == ["shown"]
    assert (sub.is_open, it.said) == (True, [])
    assert it.does(lambda: panel._take(Row("sub/", folder=sub))) == ["shown"]
    assert not sub.is_open
    unread = Folder(home / "unread", "unread/")
    assert it.does(lambda: panel._take(Row("unread/", folder=unread))) == [unread, "shown"]
    assert (unread.is_open, unread.is_reading) == (True, True)
    assert it.does(lambda: panel._open(unread)) == [], "it is being read"
    unread.is_reading, unread.entries, unread.problem = False, (), "why not"
    assert it.does(lambda: panel._open(unread)) == [unread], "it is tried again"
    assert it.does(lambda: panel._take(Row("I am reading this folder."))) == []
    it.type("sub/")
    assert it.does(lambda: panel._take(Row("../", above=home.parent))) == [
        panel._folder(home.parent),
        "shown",
    ]
    assert (panel._root.path, panel._line.value) == (home.parent, "")
    it.type("a")
    panel._take(Row("../", above=home))
    assert panel._line.value == "a"


async def test_a_new_name_goes_into_a_folder_that_is_opened_and_into_the_one_above(
    unshown: Callable[..., Unshown], home: Path
) -> None:
    it = unshown("old.gd", is_new=True)
    panel = it.panel
    it.type("new")
    for row, line in (
        (Row("sub/", folder=it.folder("sub")), "sub/new"),
        (Row("sub/", folder=it.folder("sub")), "sub/new"),  # it is closed
        (Row("deep/", folder=it.folder("sub/deep")), "sub/deep/new"),
        (Row("Recent programs", folder=panel._recent), "sub/deep/new"),
        (Row("../", above=home.parent), f"{home.parent}/new"),
        (Row("empty/", folder=it.folder("empty")), "empty/new"),
    ):
        panel._take(row)
        assert (row.text, panel._line.value, panel._line.cursor_position) == (row.text, line, len(line))


@pytest.mark.parametrize(("name", "done"), [("Enter", "submitted"), ("Tab", "completed"), ("Esc", None)])
async def test_clicks_on_the_keys_of_the_panel_do_what_they_say(name: str, done: str | None) -> None:
    async with opened() as it:
        keys, did = it.panel._keys, it.answers
        it.panel._submit = lambda: did.append("submitted")  # type: ignore[method-assign]
        it.panel.action_complete = lambda: did.append("completed")  # type: ignore[method-assign]
        x = 1 + keys.words.index(name)
        keys.on_click(Click(keys, x, 0, 0, 0, 1, False, False, False, x, keys.region.y))
        await it.rest()
        assert did == [done]


async def test_folders_are_known_by_their_path_and_have_the_real_ones_above_them(
    unshown: Callable[..., Unshown], home: Path
) -> None:
    it = unshown()
    fresh = Folder(home, "home/")
    assert (fresh.entries, fresh.problem, fresh.most, fresh.above) == (None, "", 500, None)
    assert not (fresh.is_open or fresh.is_reading)
    entry = ProgramEntry(home / "x", "x/", "x", real="/real/x")
    above = Folder(home, "home/", frozenset({"/real"}))
    made = it.panel._folder(home / "x", entry, above)
    assert (made.name, made.inside) == ("x/", {"/real", "/real/x"})
    assert it.panel._folder(home / "x") is made
    assert (it.folder("sub").name, it.folder("sub").inside) == ("sub/", frozenset())
    spoken = {Row("x/", folder=made): "x/, closed folder", Row("a", "b"): "a, b", Row("a"): "a"}
    assert {row: it.panel._spoken(row) for row in spoken} == spoken
    made.is_open = True
    assert it.panel._spoken(Row("x/", folder=made)) == "x/, open folder"


def test_rows_are_the_same_if_they_are_one_file_or_folder_or_ask_for_the_same(home: Path) -> None:
    folder, other = Folder(home, "home/"), Folder(home, "home/")
    rows = [
        Row("a", path=home), Row("a", folder=folder), Row("a", folder=other), Row("a", more=folder),
        Row("a", above=home), Row("a"),
    ]  # fmt: skip
    for at, row in enumerate(rows):
        same = [_is_same(each, row) for each in rows]
        assert same == [number == at for number in range(len(rows))]
        assert not _is_same(None, row)
    assert _is_same(Row("a", "remark", home), Row("b", path=home))


def test_above_the_top_and_above_what_is_allowed_there_is_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    assert file_panel._folder_above(Path("/a/b")) == Path("/a")
    assert file_panel._folder_above(Path("/")) is None
    monkeypatch.setattr(file_panel, "is_allowed", lambda path: path != Path("/a"))
    assert file_panel._folder_above(Path("/a/b")) is None
    monkeypatch.setattr(Path, "cwd", lambda: (_ for _ in ()).throw(FileNotFoundError()))
    assert file_panel._working_folder() == Path()
