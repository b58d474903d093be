"""The versions of a document for UNDO, and where its lines move."""

from pathlib import Path

import pytest

from donnie_tui.core import editing
from donnie_tui.core.editing import (
    Origin,
    UndoHistory,
    UnsavedText,
    Version,
    common_lines,
    followed,
    joined,
    shifted,
)


@pytest.mark.parametrize(
    ("before", "after", "common"),
    [
        ("abc", "abc", (3, 0)),
        ("abc", "axc", (1, 1)),
        ("abc", "abxc", (2, 1)),
        ("abxc", "abc", (2, 1)),
        ("aa", "aaa", (2, 0)),
        ("baa", "a", (0, 1)),
        ("abc", "xyz", (0, 0)),
        ("abc", "ab", (2, 0)),
        ("", "ab", (0, 0)),
        ("abcd", "xbcy", (0, 0)),
        ("abcd", "xcd", (0, 2)),
    ],
)
def test_two_programs_have_lines_in_common_at_both_ends(
    before: str, after: str, common: tuple[int, int]
) -> None:
    assert common_lines(before, after) == common


@pytest.mark.parametrize(
    ("before", "after", "lines"),
    [
        ("abcd", "abcd", {1, 2, 4}),
        ("abcd", "axcd", {1, 2, 4}),
        ("abcd", "xabcd", {2, 3, 5}),
        ("abcd", "abxcd", {1, 2, 5}),
        ("abcd", "acd", {1, 3}),
        ("abcd", "ad", {1, 2}),
        ("abcd", "", set()),
        ("abcd", "abcdx", {1, 2, 4}),
    ],
)
def test_lines_are_followed_where_lines_before_them_come_and_go(
    before: str, after: str, lines: set[int]
) -> None:
    assert followed({1, 2, 4}, before, after) == lines


@pytest.mark.parametrize(
    ("first", "last", "added", "lines"),
    [
        (0, 0, 1, {2, 3, 5}),
        (2, 2, 2, {1, 2, 6}),
        (1, 2, -1, {1, 3}),
        (3, 4, -1, {1, 2}),
        (4, 4, 1, {1, 2, 4}),
    ],
)
def test_lines_after_a_change_are_shifted_and_those_in_it_dropped(
    first: int, last: int, added: int, lines: set[int]
) -> None:
    assert shifted({1, 2, 4}, first, last, added) == lines


def test_each_line_of_a_text_has_its_end() -> None:
    assert [joined([]), joined(["a", ""])] == ["", "a\n\n"]


# --- versions


def version(text: str, origin: Origin | None = None) -> Version:
    return Version([*text], 0, 0, origin)


def test_undo_and_redo_exchange_a_version_for_the_one_before() -> None:
    history, asked = UndoHistory(), list[bool]()

    def now(text: str):
        return lambda is_another: asked.append(is_another) or version(text)

    assert (history.undo(now("")), history.redo(now("")), asked) == (None, None, [])
    history.add(version("a"))
    history.add_line(2)
    history.add(version("b", Origin(None, [], frozenset())))
    assert history.undo(now("c")) == version("b", Origin(None, [], frozenset()))
    assert (history.undo(now("d")), asked) == (2, [True, False])
    assert (history.redo(now("e")), asked) == (version("d"), [True, False, False])
    assert (history.undo(now("f")), asked[3:]) == (version("e"), [False])
    assert [history.redo(now("g")), history.redo(now("h")), history.redo(now("i"))] == [
        *(version("f"), version("c"), None)
    ]


@pytest.mark.parametrize("change", ["add", "add_line", "forget_undone"])
def test_a_change_leaves_nothing_to_redo(change: str) -> None:
    history = UndoHistory()
    history.add(version("a"))
    history.undo(lambda _: version("b"))
    given = {"add": [version("c")], "add_line": [1], "forget_undone": []}[change]
    getattr(history, change)(*given)

    assert history.redo(lambda _: version("d")) is None


def test_lines_that_were_dropped_are_forgotten_from_the_end() -> None:
    history = UndoHistory()
    for count in (0, 1):
        history.add_line(count)
    history.add(version("a"))
    for count in (1, 2, 3):
        history.add_line(count)
    history.forget_lines(2)
    assert [history.undo(lambda _: version("")) for _ in range(2)] == [1, version("a")]

    history.forget_lines(0)
    assert history.undo(lambda _: version("")) is None


def test_fifty_changes_can_be_undone() -> None:
    added, changed = UndoHistory(), UndoHistory()
    for count in range(51):
        added.add_line(count)
        changed.add(version(str(count)))
    found = [added.undo(lambda _: version("")) for _ in range(51)]

    assert found == [*range(50, 0, -1), None]
    assert [changed.undo(lambda _: version("")) for _ in range(51)][-2:] == [version("1"), None]


def test_of_long_programs_fewer_changes_can_be_undone(monkeypatch: pytest.MonkeyPatch) -> None:
    """At most six lines in all are kept, and always the newest version."""
    monkeypatch.setattr(editing, "MOST_LINES_KEPT", 6)
    history = UndoHistory()
    for text in ("aaa", "bbb", "ccc"):
        history.add(version(text))
    assert [history.undo(lambda _: version("")) for _ in range(3)] == [version("ccc"), version("bbb"), None]

    history.add(version("a" * 9))
    assert history.undo(lambda _: version("")) == version("a" * 9)


@pytest.mark.parametrize(("lines", "kept"), [(500_000, 2), (500_001, 1)])
def test_a_million_lines_are_kept_for_undoing(lines: int, kept: int) -> None:
    history, long = UndoHistory(), Version(["FW 1"] * lines, 0, 0)
    for each in (long, Version(["FW 1"] * 500_000, 0, 0)):
        history.add(each)

    assert sum(history.undo(lambda _: version("")) is not None for _ in range(3)) == kept


def test_of_long_undone_programs_fewer_can_be_redone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(editing, "MOST_LINES_KEPT", 6)
    history = UndoHistory()
    for text in "abc":
        history.add(version(text))
    for text in ("xxx", "yyy", "zzz"):
        history.undo(lambda _, text=text: version(text))

    assert [history.redo(lambda _: version("")) for _ in range(3)] == [version("zzz"), version("yyy"), None]


def test_unsaved_programs_that_were_replaced_are_known() -> None:
    history = UndoHistory()
    mine = Origin(Path("mine.gd"), ["a"], frozenset())
    history.add(version("a", mine))
    history.add(version("ab", mine))
    history.add(version("c"))
    history.add_line(1)
    history.add(version("d", Origin(None, [], frozenset())))
    replaced = (UnsavedText("a\nb\n", Path("mine.gd")), UnsavedText("d\n", None))
    assert history.replaced == replaced

    history.undo(lambda _: version("e", mine))
    assert history.replaced == (replaced[0], UnsavedText("e\n", Path("mine.gd")))
