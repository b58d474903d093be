"""The programs to open, or the place for a new one: a tree of folders, and a line for a name.

Typing narrows the tree and is completed from it; a new name does not narrow it. Up and
Down choose rows of the tree, Right and Left open and close folders there. Enter takes the row, or the
typed name: the file of that name, else the only program that fits. Folders are read in the background.
"""

from __future__ import annotations

import asyncio
import os
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from pathlib import Path
from textwrap import wrap
from typing import Any, ClassVar

from msgspec import Struct
from rich.style import Style
from rich.text import Text
from textual import work
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.geometry import Offset
from textual.screen import Screen
from textual.suggester import Suggester
from textual.widgets import Input, Static, Tree
from textual.widgets.tree import TreeNode

from donnie_tui.core.program_files import (
    DocumentError,
    ProgramEntry,
    exists,
    is_folder,
    program_to_open,
    programs_in,
)
from donnie_tui.core.wording import Wording
from donnie_tui.process.confinement import confinement, is_allowed, part_below
from donnie_tui.tui.screens.dialogs import LEAST_REST, Panel
from donnie_tui.tui.widgets.command_line import InputLine
from donnie_tui.tui.widgets.rows import BottomKeys, WheelRows
from language.source import fold_name, printable

MOST_RECENT = 5
"""Recent programs in the tree; RECENT lists all."""
MOST_SHOWN = 500
"""Rows of a folder; its last row shows as many more."""
_WIDTH, _HEIGHT = 80, 26
"""Columns and rows of the panel, at most."""


class Folder:
    """A folder of the tree; it is read when it is opened."""

    def __init__(self, path: Path, name: str, inside: frozenset[str] = frozenset()) -> None:
        """``inside``: the real paths of this folder and of those above it in the tree."""
        self.path, self.name, self.inside = path, name, inside
        self.above: Path | None = None
        """The folder above the tree, if the learner may go there."""
        self.entries: tuple[ProgramEntry, ...] | None = None
        """None until it was read."""
        self.problem = ""
        """The reason why it can't be read."""
        self.is_open = self.is_reading = False
        self.most = MOST_SHOWN


class Row(Struct, frozen=True):
    """A row of the tree; one without file or folder is a remark."""

    text: str
    remark: str = ""
    """Faint text after the name."""
    path: Path | None = None
    """The program."""
    folder: Folder | None = None
    more: Folder | None = None
    """The folder whose further rows this row shows."""
    above: Path | None = None


class FileTree(Tree[Row], WheelRows):
    """Textual's tree, in letters alone; the focus stays in the input line."""

    ICON_NODE, ICON_NODE_EXPANDED = "+ ", "- "

    def __init__(self) -> None:
        super().__init__("", id="files")
        self.can_focus = self.show_root = self.show_guides = self.auto_expand = False
        self.guide_depth = 2

    @property
    def row(self) -> Row | None:
        """The chosen row; None if none is."""
        node = self.cursor_node if self.cursor_line >= 0 else None
        return node.data if node is not None else None

    @property
    def cursor_screen_offset(self) -> Offset:
        return self.content_region.offset + Offset(0, self.cursor_line - self.scroll_offset.y)

    def choose(self, line: int) -> None:
        if self.last_line >= 0:
            self.cursor_line = line
            self.scroll_to_line(self.cursor_line, animate=False)

    def get_label_width(self, node: TreeNode[Row]) -> int:  # noqa: ARG002 -- Textual's own
        """The width of a row: the tree never scrolls sideways, so long rows are cut."""
        return 1

    def render_label(self, node: TreeNode[Row], base_style: Style, style: Style) -> Text:
        row, is_chosen = node.data, node.line == self.cursor_line
        assert row is not None
        sign = "  "
        if row.folder is not None:
            sign = self.ICON_NODE_EXPANDED if node.is_expanded else self.ICON_NODE
        label = Text(f"{'>' if is_chosen else ' '}{sign}", base_style + style, no_wrap=True)
        label.append(row.text, Style(bold=row.folder is not None))
        if row.remark:
            muted = self.get_component_rich_style("file-tree--remark", partial=True)
            label.append(f"  {row.remark}", style if is_chosen else muted)
        label.pad_right(max(0, self.size.width - label.cell_len))
        return label

    COMPONENT_CLASSES: ClassVar[set[str]] = {"file-tree--remark"}

    def choose_further(self, rows: int) -> None:
        self.choose(max(0, self.cursor_line + rows))


class _NameLine(InputLine):
    """The input line; the terminal's cursor is on the chosen row."""

    def __init__(self, value: str, files: FileTree, complete: Callable[[str], str]) -> None:
        self._files = files
        super().__init__(value, id="answer")
        self.suggester = _Completion(complete)

    @property
    def cursor_screen_offset(self) -> Offset:
        is_chosen = self._files.row is not None
        return self._files.cursor_screen_offset if is_chosen else super().cursor_screen_offset

    @property
    def _changed(self) -> None:
        """The changed columns, with the completion after the cursor."""
        return


class _Completion(Suggester):
    def __init__(self, complete: Callable[[str], str]) -> None:
        super().__init__(use_cache=False, case_sensitive=True)
        self._complete = complete

    async def get_suggestion(self, value: str) -> str | None:
        return self._complete(value) or None


class FilePanel(Panel[str | Path | None]):
    """Answers the typed name or the chosen file; None after Esc."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,ctrl+q", "dismiss", priority=True),
        Binding("up", "choose(-1)", priority=True),
        Binding("down", "choose(1)", priority=True),
        Binding("pageup", "page(-1)", priority=True),
        Binding("pagedown", "page(1)", priority=True),
        Binding("home", "end(False)", priority=True),
        Binding("end", "end(True)", priority=True),
        Binding("left", "fold(False)", priority=True),
        Binding("right", "fold(True)", priority=True),
        Binding("tab", "complete", priority=True),
    ]
    AUTO_FOCUS = "#answer"

    def __init__(
        self,
        question: str,
        text: str,
        recent: Callable[[], Sequence[Path]],
        words: Wording,
        point: Callable[[str], object],
        *,
        checking: Callable[[Screen[Any]], AbstractContextManager[None]],
        is_new: bool = False,
    ) -> None:
        """``point`` speaks the chosen row; ``checking``: see ``Dialogs.checking``.

        ``is_new``: see ``Interaction.ask_file``.
        """
        super().__init__()
        self._checking = checking
        self._asked, self._text, self._words, self._point = question, text, words, point
        self._find_recent, self._is_new = recent, is_new
        self.files = FileTree()
        self._line = _NameLine(text, self.files, self._completed)
        self._title = Static(f" {question}", classes="screen-title", markup=False)
        self._keys = BottomKeys(words("ask-keys-files"))
        self._panel = Vertical(id="panel")
        self._home = Path()
        self._root = Folder(self._home, "")
        """The folder that is shown if none is typed."""
        self._recent = Folder(self._home, words("ask-recent"))
        self._folders: dict[Path, Folder] = {}
        self._is_typed = False
        """Whether the learner has changed the line."""

    def compose(self) -> ComposeResult:
        with self._panel:
            yield self._title
            yield self._line
            yield self.files
        yield self._keys

    def on_mount(self) -> None:
        self._lay_out()
        self._line.select_all()  # what is proposed is typed over
        self._point(f"{self._asked} {self._text}".strip())
        self._begin()

    def on_resize(self) -> None:
        self._lay_out()

    def _lay_out(self) -> None:
        panel = self._panel
        width, height = self.fit(panel)
        columns = _WIDTH if width - LEAST_REST >= _WIDTH else width
        panel.styles.width = columns
        panel.set_class(columns == width, "-wide-as-all")
        panel.styles.height = min(_HEIGHT, height)

    @work
    async def _begin(self) -> None:
        self._home = await asyncio.to_thread(_working_folder)
        self._root = self._folder(self._home)
        self._open(self._root)
        self._show()
        found = await asyncio.to_thread(self._find_recent)
        self._recent.entries = tuple(
            ProgramEntry(each, printable(each.name), fold_name(printable(each.name)))
            for each in found[:MOST_RECENT]
        )
        self._recent.is_open = not self._is_new
        self._show()

    # --- folders

    def _folder(self, path: Path, entry: ProgramEntry | None = None, above: Folder | None = None) -> Folder:
        """The folder of a path; ``entry`` is its row in the folder ``above``."""
        if path not in self._folders:
            inside = above.inside | {entry.real} if above is not None and entry is not None else frozenset()
            name = entry.name if entry is not None else printable(f"{path.name}/")
            self._folders[path] = Folder(path, name, frozenset(inside))
        return self._folders[path]

    def _open(self, folder: Folder) -> None:
        folder.is_open = True
        is_unread = folder.entries is None or folder.problem
        if is_unread and not folder.is_reading and folder is not self._recent:
            folder.is_reading = True
            self._read(folder)

    @work
    async def _read(self, folder: Folder) -> None:
        try:
            folder.above = await asyncio.to_thread(_folder_above, folder.path)
            folder.entries = await asyncio.to_thread(programs_in, folder.path, folder.inside)
            folder.problem = ""
        except DocumentError as error:
            folder.entries = ()
            folder.problem = printable(
                self._words(error.code, path=folder.name.rstrip("/") or "/", reason=error.reason)
            )
        folder.is_reading = False
        self._show()
        if folder.problem:
            self._point(folder.problem)

    # --- what is typed

    @property
    def _typed(self) -> tuple[str, str]:
        """The typed folder with its slash, and the typed name; both empty at first."""
        before, slash, name = self._line.value.lstrip().rpartition("/") if self._is_typed else ("", "", "")
        return before + slash, name

    def _top(self) -> Folder:
        """The shown folder, in which a typed name is searched."""
        before, _name = self._typed
        if not before:
            return self._root
        folder = self._folder(_below(self._home, before))
        folder.name = printable(before)
        return folder

    def on_input_changed(self, event: Input.Changed) -> None:
        event.stop()
        if not self._is_typed and event.value == self._text:
            return
        self._is_typed = True
        self._title.update(f" {self._asked}")
        self.files.unselect()
        self._open(self._top())
        self._show()

    def _completed(self, value: str) -> str:
        """The completed line: the first name that begins with the typed letters."""
        before, slash, name = value.rpartition("/")
        folder = self._root if not slash else self._folders.get(_below(self._home, before + slash))
        entries = folder.entries if folder is not None and name else ()
        typed = fold_name(name)
        fitting = (each for each in entries or () if each.folded.startswith(typed) and _is_typable(each))
        found = next(fitting, None)
        return f"{before}{slash}{found.name}" if found is not None else ""

    def action_complete(self) -> None:
        """Write the chosen row, or the completed name, into the line."""
        row = self.files.row
        folder = row.folder.path if row is not None and row.folder is not None else None
        path = (row.path or folder or row.above) if row is not None else None
        if path is not None:
            self._write(self._written(path, is_folder=row is None or row.path is None))
        elif completed := self._completed(self._line.value):
            self._write(completed)
        elif fitting := [each for each in self._fitting(self._top()) if _is_typable(each)]:
            self._write(f"{self._typed[0]}{fitting[0].name}")

    def _written(self, path: Path, *, is_folder: bool) -> str:
        """The path as a learner would type it."""
        name = str(path.relative_to(self._home)) if path.is_relative_to(self._home) else str(path)
        return printable("" if name == "." else f"{name.rstrip('/')}/" if is_folder else name)

    def _write(self, text: str) -> None:
        self._line.value = text
        self._line.cursor_position = len(text)

    # --- the tree

    def _fitting(self, folder: Folder) -> list[ProgramEntry]:
        """The shown rows of a folder: all, unless typed letters narrow them."""
        entries, typed = folder.entries or (), self._typed[1]
        if self._is_new or not typed.strip():
            return list(entries)
        words = fold_name(typed).split()
        return [
            each
            for each in entries
            if all(word in each.folded for word in words) or (each.real and self._has_fitting(each))
        ]

    def _has_fitting(self, entry: ProgramEntry) -> bool:
        folder = self._folders.get(entry.path)
        return folder is not None and folder.is_open and bool(self._fitting(folder))

    def _programs(self, folder: Folder) -> set[Path]:
        """The shown programs of all open folders."""
        found = set()
        for each in self._fitting(folder):
            below = self._folders.get(each.path)
            if not each.real:
                found.add(each.path)
            elif below is not None and below.is_open:
                found |= self._programs(below)
        return found

    @property
    def _shown(self) -> list[Folder]:
        """The folders at the top of the tree."""
        top = self._top()
        is_in_tree = self._is_new and top.path.is_relative_to(self._root.path) and top is not self._root
        if is_in_tree:
            top = self._root
        has_recent = top is self._root and bool(self._fitting(self._recent))
        return [self._recent, top] if has_recent else [top]

    def _show(self) -> None:
        """Build all rows again; the chosen one stays chosen."""
        tree, chosen = self.files, self.files.row
        tree.unselect()
        top = tree.scroll_offset.y
        tree.clear()
        for each in self._shown:
            self._add(tree.root, each, each.name)
        lines = range(tree.last_line + 1)
        if chosen is not None:
            line = next((at for at in lines if _is_same(self._row_at(at), chosen)), None)
            if line is not None:
                tree.choose(line)
        elif top:
            tree.scroll_to(y=0, animate=False)

    def _row_at(self, line: int) -> Row | None:
        node = self.files.get_node_at_line(line)
        return node.data if node is not None else None

    def _add(self, parent: TreeNode[Row], folder: Folder, name: str) -> None:
        is_at_top = parent.is_root and folder.above is not None
        where = _short(folder.above) if folder.above is not None and is_at_top else ""
        node = parent.add("", Row(name, where, folder=folder), expand=folder.is_open)
        if not folder.is_open:
            return
        is_all = not self._typed[1].strip() or self._is_new
        if is_at_top and is_all:
            node.add_leaf("", Row("../", self._words("files-above"), above=folder.above))
        fitting = self._fitting(folder)
        for each in fitting[: folder.most]:
            if each.real:
                self._add(node, self._folder(each.path, each, folder), each.name)
            else:
                where = self._where(each.path.parent) if folder is self._recent else ""
                node.add_leaf("", Row(each.name, where, each.path))
        remark = folder.problem
        if folder.entries is None:
            remark = self._words("files-reading")
        elif not fitting and not remark:
            remark = self._words("files-none" if is_all else "palette-nothing")
        room = self.files.size.width - _depth(node) * self.files.guide_depth - 4
        for line in wrap(remark, max(8, room)):
            node.add_leaf("", Row(line))
        if len(fitting) > folder.most:
            node.add_leaf("", Row(self._words("files-more", count=len(fitting) - folder.most), more=folder))

    def _where(self, path: Path) -> str:
        is_below = path.is_relative_to(self._home)
        return self._written(path, is_folder=True) if is_below else _short(path)

    # --- keys

    def _choose(self, line: int) -> None:
        self.files.choose(line)
        self._line.refresh()
        if self.files.row is not None:
            self._point(self._spoken(self.files.row))

    def _spoken(self, row: Row) -> str:
        if row.folder is not None:
            code = "files-folder-open" if row.folder.is_open else "files-folder-closed"
            return self._words(code, name=row.text)
        return f"{row.text}, {row.remark}" if row.remark else row.text

    def action_choose(self, down: int) -> None:
        self._choose(max(0, self.files.cursor_line + down) if self.files.row is not None else 0)

    def action_page(self, down: int) -> None:
        self._choose(max(0, self.files.cursor_line + down * max(1, self.files.size.height - 1)))

    def action_end(self, last: bool) -> None:
        if self.files.row is not None:
            self._choose(self.files.last_line if last else 0)
        elif last:
            self._line.action_end()
        else:
            self._line.action_home()

    def action_fold(self, right: bool) -> None:
        """Open or close the chosen folder; without a chosen row, move in the line."""
        row, node = self.files.row, self.files.cursor_node
        if row is None or node is None:
            if right:
                self._line.action_cursor_right()
            else:
                self._line.action_cursor_left()
        elif row.folder is not None and row.folder.is_open is not right:
            self._toggle(row.folder)
        elif right and node.children:
            self._choose(self.files.cursor_line + 1)
        elif not right and node.parent is not None and not node.parent.is_root:
            self._choose(node.parent.line)

    def _toggle(self, folder: Folder) -> None:
        if folder.is_open:
            folder.is_open = False
        else:
            self._open(folder)
        self._show()
        if self.files.row is not None:
            self._point(self._spoken(self.files.row))

    # --- answers

    def on_input_submitted(self, event: Input.Submitted) -> None:
        event.stop()
        self._submit()

    def on_tree_node_selected(self, event: Tree.NodeSelected[Row]) -> None:
        """Take the clicked row, as Enter does."""
        event.stop()
        if event.node.data is not None:
            self._take(event.node.data)

    def _take(self, row: Row) -> None:
        if row.path is not None:
            self.dismiss(row.path)
        elif row.more is not None:
            row.more.most += MOST_SHOWN
            self._show()
        elif row.above is not None:
            self._go_above(row.above)
        elif row.folder is not None:
            self._toggle(row.folder)
            if self._is_new and row.folder.is_open and row.folder is not self._recent:
                self._put_into(row.folder.path)

    def _go_above(self, path: Path) -> None:
        self._root = self._folder(path)
        self._open(self._root)
        if self._is_new:
            self._put_into(path)
        elif self._typed[0]:
            self._write("")
        self._show()

    def _put_into(self, path: Path) -> None:
        """Move the new name into that folder; Enter takes it."""
        name = self._line.value.rpartition("/")[2]
        self._write(f"{self._written(path, is_folder=True)}{name}")
        self.files.unselect()

    def _submit(self) -> None:
        """Take the chosen row or the typed name. Enter alone chooses the first program."""
        row, typed = self.files.row, self._line.value.strip()
        if row is not None:
            self._take(row)
        elif typed:
            self._answer(typed)
        else:
            lines = range(self.files.last_line + 1)
            programs = (
                at for at in lines if (each := self._row_at(at)) is not None and each.path is not None
            )
            self._choose(next(programs, 0))

    @work(exclusive=True, group="answer")
    async def _answer(self, typed: str) -> None:
        """Check the typed name in the background; later keys wait."""
        with self._checking(self):
            found = await asyncio.to_thread(_named, typed)
            if found == "folder":
                self._write(typed if typed.endswith("/") else f"{typed}/")
                return
            fitting = set() if found or self._is_new else set[Path]().union(*map(self._programs, self._shown))
            if len(fitting) > 1:
                several = self._words("files-several", count=len(fitting))
                self._title.update(f" {several}")
                self._point(several)
            else:
                self.dismiss(fitting.pop() if fitting else typed)


def _working_folder() -> Path:
    try:
        return Path.cwd()
    except OSError:  # it was removed
        return Path()


def _folder_above(path: Path) -> Path | None:
    """The folder above, if the learner may go there."""
    above = path.parent
    return above if above != path and is_allowed(above) else None


def _short(path: Path) -> str:
    """The path as it is shown."""
    home = os.path.expanduser("~")  # noqa: PTH111 -- it does not fail without one
    below = part_below(home, str(path)) if confinement() is None else None
    return printable(str(path) if below is None else f"~/{below}".rstrip("/"))


def _below(home: Path, typed: str) -> Path:
    """The path of a typed folder, with its slash."""
    try:
        return home / Path(typed).expanduser()
    except RuntimeError:  # there is no such account
        return home / typed


def _named(typed: str) -> str:
    """Whether the text names a ``folder`` or a ``file``; empty for neither."""
    try:
        path = program_to_open(typed)
    except DocumentError as error:
        return "folder" if error.code == "file-is-folder" else ""
    if is_folder(path):
        return "folder"
    return "file" if exists(path) else ""


def _depth(node: TreeNode[Row]) -> int:
    return 0 if node.parent is None else 1 + _depth(node.parent)


def _is_typable(entry: ProgramEntry) -> bool:
    """Whether the shown name is the real one."""
    return entry.name.rstrip("/") == entry.path.name


def _is_same(one: Row | None, other: Row) -> bool:
    """Whether both are one file or folder, or ask for the same."""
    return one is not None and (one.path, one.folder, one.more, one.above) == (
        other.path, other.folder, other.more, other.above,
    )  # fmt: skip
