"""The history of typed lines, and a history file that may contain anything."""

from pathlib import Path

import pytest

from donnie_tui.core.session_log import KEPT_LINES, LARGEST_FILE, LineHistory, Recall


def test_typed_lines_are_in_the_history_of_the_next_session(tmp_path: Path) -> None:
    file = tmp_path / "new" / "history"
    past = LineHistory(str(file))
    for line in ("FW 3", "FW 3", "  ", "TR 90 "):
        past.remember(line)

    assert LineHistory(str(file)).lines == ["FW 3", "TR 90"]
    assert file.stat().st_mode & 0o077 == 0


@pytest.mark.parametrize(
    "content",
    [b"\xff\xfe\x00\x01", b"FW 3\n\x1b[2J\n", b"x" * (LARGEST_FILE + 1), b""],
    ids=["bytes", "escape", "huge", "empty"],
)
def test_a_damaged_file_is_no_obstacle(content: bytes, tmp_path: Path) -> None:
    file = tmp_path / "history"
    file.write_bytes(content)
    past = LineHistory(str(file))
    past.remember("FW 1")

    assert set(past.lines) <= {"FW 3", "FW 1"}


def test_a_folder_in_the_place_of_the_file_is_no_obstacle(tmp_path: Path) -> None:
    past = LineHistory(str(tmp_path))
    past.remember("FW 1")
    past.trim()

    assert past.lines == ["FW 1"]


def test_the_file_does_not_grow_without_end(tmp_path: Path) -> None:
    file = tmp_path / "history"
    file.write_text("".join(f"FW {number}\n" for number in range(3 * KEPT_LINES)))
    past = LineHistory(str(file))
    past.trim()

    assert (
        file.read_text().splitlines()
        == past.lines
        == [f"FW {number}" for number in range(2 * KEPT_LINES, 3 * KEPT_LINES)]
    )


def test_a_shortened_file_is_still_readable_only_by_the_learner(tmp_path: Path) -> None:
    file = tmp_path / "history"
    LineHistory(str(file)).remember("FW 1")
    with file.open("a") as out:
        out.writelines(f"FW {number}\n" for number in range(3 * KEPT_LINES))
    LineHistory(str(file)).trim()

    assert len(file.read_text().splitlines()) == KEPT_LINES
    assert file.stat().st_mode & 0o077 == 0


def test_the_end_of_the_history_is_the_line_being_typed() -> None:
    past = LineHistory()
    past.remember("one")
    past.remember("two")
    recall = Recall(past)

    assert [recall.older("dra"), recall.older("two"), recall.older("one")] == ["two", "one", None]
    assert [recall.newer("one"), recall.newer("two"), recall.newer("dra")] == ["two", "dra", None]


@pytest.mark.parametrize(("size", "lines"), [(LARGEST_FILE, ["FW 1"]), (LARGEST_FILE + 1, [])])
def test_a_file_of_four_mebibytes_is_read_and_no_larger_one(
    size: int, lines: list[str], tmp_path: Path
) -> None:
    file = tmp_path / "history"
    file.write_bytes(b"FW 1\n".rjust(size, b"\n"))

    assert LARGEST_FILE == 4 * 1024 * 1024
    assert LineHistory(str(file)).lines == lines


def test_a_line_of_two_thousand_characters_is_remembered_and_no_longer_one(tmp_path: Path) -> None:
    file = tmp_path / "history"
    past = LineHistory(str(file))
    past.remember("x" * 2001)
    past.remember("x" * 2000)
    with file.open("a") as out:
        out.write("y" * 2000 + "\n" + "z" * 2001 + "\n")

    assert past.lines == ["x" * 2000]
    assert LineHistory(str(file)).lines == ["x" * 2000, "y" * 2000]


def test_a_thousand_lines_are_remembered() -> None:
    past = LineHistory()
    for number in range(1002):
        past.remember(f"FW {number}")

    assert (past.lines[0], past.lines[-1], len(past.lines)) == ("FW 2", "FW 1001", 1000)


def test_the_file_is_shortened_only_when_it_has_more_than_twice_as_many_lines(tmp_path: Path) -> None:
    file = tmp_path / "history"
    file.write_text("".join(f"FW {number}\n" for number in range(2 * KEPT_LINES)))
    (tmp_path / "history.new").write_text("of a trim that was cut off\n")
    LineHistory(str(file)).trim()
    assert len(file.read_text().splitlines()) == 2 * KEPT_LINES

    with file.open("a") as out:
        out.write("FW 0\n")
    LineHistory(str(file)).trim()
    assert file.read_text().splitlines() == [
        *(f"FW {each}" for each in range(KEPT_LINES + 1, 2 * KEPT_LINES)),
        "FW 0",
    ]


def test_the_same_line_again_is_not_repeated_in_the_file(tmp_path: Path) -> None:
    file = tmp_path / "history"
    past = LineHistory(str(file))
    for line in ("FW 1", "FW 1 ", "FW 2", "FW 1"):
        past.remember(line)

    assert file.read_text() == "FW 1\nFW 2\nFW 1\n"


def test_a_changed_line_of_the_past_stays_changed_while_it_is_recalled() -> None:
    past = LineHistory()
    past.remember("one")
    recall = Recall(past, "draft")

    assert recall.newer("draft") is None
    assert recall.older("more") == "one"
    assert recall.newer("one!") == "more"
    assert recall.older("more") == "one!"
    assert past.lines == ["one"]


def test_a_line_is_remembered_without_blanks_around_it_unless_it_is_empty_or_the_last_one() -> None:
    past = LineHistory()
    for line in ("", " ", "FW 1", "FW 2", " FW 2 ", "FW 1"):
        past.remember(line)

    assert past.lines == ["FW 1", "FW 2", "FW 1"]
