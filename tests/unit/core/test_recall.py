"""The history of typed lines, and a history file that may contain anything."""

from pathlib import Path

import pytest

from donnie_tui.core.line_history import KEPT, LARGEST_FILE, LineHistory, Recall


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
    file.write_text("".join(f"FW {number}\n" for number in range(3 * KEPT)))
    past = LineHistory(str(file))
    past.trim()

    assert (
        file.read_text().splitlines()
        == past.lines
        == [f"FW {number}" for number in range(2 * KEPT, 3 * KEPT)]
    )


def test_a_shortened_file_is_still_readable_only_by_the_learner(tmp_path: Path) -> None:
    file = tmp_path / "history"
    LineHistory(str(file)).remember("FW 1")
    with file.open("a") as out:
        out.writelines(f"FW {number}\n" for number in range(3 * KEPT))
    LineHistory(str(file)).trim()

    assert len(file.read_text().splitlines()) == KEPT
    assert file.stat().st_mode & 0o077 == 0


def test_the_end_of_the_history_is_the_line_being_typed() -> None:
    past = LineHistory()
    past.remember("one")
    past.remember("two")
    recall = Recall(past)

    assert [recall.older("dra"), recall.older("two"), recall.older("one")] == ["two", "one", None]
    assert [recall.newer("one"), recall.newer("two"), recall.newer("dra")] == ["two", "dra", None]
