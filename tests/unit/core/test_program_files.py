"""Program files are read in any likely encoding, and written so that nothing is lost."""

import errno
import os
import select
import threading
from collections.abc import Callable
from pathlib import Path

import pytest

from donnie_tui.core import program_files
from donnie_tui.core.program_files import (
    Attempted,
    BreakpointFile,
    DocumentError,
    FilesInUse,
    ProgressFile,
    RecentFiles,
    as_lines,
    changed_since,
    decode,
    file_names,
    file_to_save,
    is_same_file,
    new_file,
    page_to_save,
    program_meant,
    program_to_open,
    program_to_save,
    programs_in,
    read_program,
    read_to_the_end,
    save_question,
    saved_text,
    write_companion,
    write_program,
)


@pytest.mark.parametrize(
    ("data", "text"),
    [
        (b"", ""),
        ('SPEAK "olá"'.encode(), 'SPEAK "olá"'),
        (b"\xef\xbb\xbfFW 1", "FW 1"),
        ("CRIAR ação = 1".encode("cp1252"), "CRIAR ação = 1"),
        (b"a\x81\xe9", "a\ufffd\xe9"),
        ("\ufeffCRIAR ação = 1\r\n".encode("utf-16-le"), "CRIAR ação = 1\r\n"),
        ("\ufeffCRIAR ação = 1\r\n".encode("utf-16-be"), "CRIAR ação = 1\r\n"),
        (b"FW 1\r\nFW 2", "FW 1\r\nFW 2"),
    ],
)
def test_a_program_is_read_in_the_encoding_that_it_is_in(tmp_path: Path, data: bytes, text: str) -> None:
    path = tmp_path / "a.gd"
    path.write_bytes(data)

    assert read_program(path) == text


def test_an_unreadable_file_has_an_error_code(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(program_files, "LARGEST", 10)
    (tmp_path / "large.gd").write_bytes(b"x" * 11)
    (tmp_path / "full.gd").write_bytes(b"x" * 10)
    assert read_program(tmp_path / "full.gd") == "x" * 10
    (tmp_path / "picture.gd").write_bytes(b"\x89PNG\0")
    (tmp_path / "wide.gd").write_bytes("F".encode("utf-32"))

    codes = {}
    for name in ("large.gd", "picture.gd", "wide.gd", "none.gd", "."):
        with pytest.raises(DocumentError) as caught:
            read_program(tmp_path / name)
        codes[name] = caught.value.code

    assert codes == {
        "large.gd": "file-too-large",
        "picture.gd": "file-not-text",
        "wide.gd": "file-not-text",
        "none.gd": "file-not-found",
        ".": "file-is-folder",
    }


def test_a_device_without_an_end_is_too_large() -> None:
    if not Path("/dev/zero").exists():
        pytest.skip("needs an endless device")

    with pytest.raises(DocumentError) as caught:
        read_to_the_end(Path("/dev/zero"))

    assert caught.value.code == "file-too-large"


def test_a_name_that_is_no_path_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(DocumentError):
        read_program(tmp_path / "a\0b")


def test_a_program_is_written_as_utf8_and_keeps_its_permissions(tmp_path: Path) -> None:
    path = tmp_path / "a.gd"
    path.write_text("old")
    path.chmod(0o640)

    write_program(path, 'FALAR "olá"\n')

    assert path.read_bytes() == 'FALAR "olá"\n'.encode()
    assert path.stat().st_mode & 0o777 == 0o640
    assert [each.name for each in tmp_path.iterdir()] == ["a.gd"]


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "real.gd").write_text("old")
    link = tmp_path / "link.gd"
    link.symlink_to("real.gd")

    write_program(link, "new")

    assert link.is_symlink()
    assert (tmp_path / "real.gd").read_text() == "new"


def test_a_failed_write_is_an_error_and_leaves_no_file(tmp_path: Path) -> None:
    path = tmp_path / "a.gd"
    path.write_text("old")

    with pytest.raises(DocumentError):
        write_program(path, "\udcff")

    assert path.read_text() == "old"
    assert len(list(tmp_path.iterdir())) == 1


def test_decoding_ends_at_the_limit() -> None:
    with pytest.raises(DocumentError):
        decode(b"x" * (program_files.LARGEST + 1), "-")


def test_a_program_is_found_without_its_suffix(tmp_path: Path) -> None:
    (tmp_path / "a.gd").write_text("")

    assert program_to_open(str(tmp_path / "a")) == tmp_path / "a.gd"
    assert program_to_open(str(tmp_path / "b")) == tmp_path / "b"
    assert program_to_save(f'"{tmp_path / "b"}"', FilesInUse()) == tmp_path / "b.gd"
    assert program_to_save(str(tmp_path / "b.txt"), FilesInUse()) == tmp_path / "b.txt"


def test_a_file_is_read_without_its_control_characters() -> None:
    dangerous = 'SPEAK "\x1b]0;x\x07\x9b5m"\tFW 1\x0c\u2028\r\nFW 2\n'

    assert decode(dangerous.encode(), "a.gd") == 'SPEAK " ]0;x  5m"\tFW 1  \r\nFW 2\n'


def test_a_new_file_has_the_name_that_is_printed_of_it(tmp_path: Path) -> None:
    """A terminal obeys what lists its folder, too."""
    saved = program_to_save(f"{tmp_path}/a\x1b]0;x\x07\u202eb", FilesInUse())
    assert saved == tmp_path / "a ]0;x  b.gd"

    (tmp_path / "c\x07.gd").write_text("")
    assert program_to_save(f"{tmp_path}/c\x07.gd", FilesInUse()) == tmp_path / "c\x07.gd"


def test_a_pipe_is_not_opened_because_reading_it_may_wait_for_ever(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")

    with pytest.raises(DocumentError) as caught:
        read_program(program_to_open(str(tmp_path / "pipe")))
    assert caught.value.code == "file-no-file"


def test_a_command_reads_a_pipe_to_its_end(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    writing = threading.Thread(target=lambda: (tmp_path / "pipe").write_text("FW 1"))
    writing.start()

    assert read_to_the_end(tmp_path / "pipe") == "FW 1"
    writing.join()


def test_a_pipe_into_which_nothing_is_written_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    os.mkfifo(tmp_path / "pipe")
    monkeypatch.setattr(program_files, "LONGEST_SILENCE", 0.01)

    with pytest.raises(DocumentError) as caught:
        read_to_the_end(tmp_path / "pipe")

    assert caught.value.code == "file-pipe-silent"


def test_a_silent_pipe_is_waited_for_ten_seconds_and_closed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    os.mkfifo(tmp_path / "pipe")
    asked: list[tuple[int, int, float]] = []

    class Silent:
        def register(self, pipe: int, events: int) -> None:
            self.watched = pipe, events

        def poll(self, milliseconds: float) -> list[object]:
            asked.append((*self.watched, milliseconds))
            return []

    monkeypatch.setattr(select, "poll", Silent)
    assert refused(lambda: read_to_the_end(tmp_path / "pipe")) == (
        *("file-pipe-silent", str(tmp_path / "pipe"), ""),
    )
    ((pipe, events, milliseconds),) = asked
    assert (events, milliseconds) == (select.POLLIN, 10_000)
    with pytest.raises(OSError, match=os.strerror(errno.EBADF)):
        os.fstat(pipe)


def test_a_link_to_itself_is_not_replaced(tmp_path: Path) -> None:
    link = tmp_path / "self.gd"
    link.symlink_to("self.gd")

    assert refused(lambda: write_program(link, "FW 1")) == (
        *("file-unwritable", str(link), os.strerror(errno.ELOOP)),
    )
    assert link.is_symlink()


def test_an_editor_shows_no_line_after_the_last_one() -> None:
    assert [as_lines(each) for each in ("", "FW 1", "FW 1\r\nFW 2\r\n", "FW 1\n\n")] == [
        *("", "FW 1", "FW 1\nFW 2", "FW 1\n"),
    ]


def test_a_device_or_a_pipe_is_not_replaced_by_a_file(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")

    with pytest.raises(DocumentError) as caught:
        write_program(tmp_path / "pipe", "FW 2")
    assert caught.value.code == "file-no-file"
    assert (tmp_path / "pipe").is_fifo()


def test_a_folder_is_not_written(tmp_path: Path) -> None:
    with pytest.raises(DocumentError) as caught:
        write_program(tmp_path, "FW 2")
    assert caught.value.code == "file-is-folder"


def test_a_file_that_must_not_be_written_is_not_replaced(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "mine.gd"
    path.write_text("FW 1")
    monkeypatch.setattr(
        os, "access", lambda *_: False
    )  # the superuser, who may run this, may write everything

    with pytest.raises(DocumentError):
        write_program(path, "FW 2")
    assert path.read_text() == "FW 1"


def test_a_folder_is_refused_before_a_question_whether_to_replace_it(tmp_path: Path) -> None:
    with pytest.raises(DocumentError) as refused:
        program_to_save(str(tmp_path), FilesInUse())

    assert refused.value.code == "file-is-folder"


# --- which file is meant, and what a save would replace


def refused(attempt: Callable[[], object]) -> tuple[str, str, str]:
    """Why, which file, and the system's reason."""
    with pytest.raises(DocumentError) as caught:
        attempt()
    return caught.value.code, caught.value.path, caught.value.reason


def test_a_file_in_use_is_not_saved_onto_under_any_of_its_names(tmp_path: Path) -> None:
    used, link, free = (tmp_path / each for each in ("used.gd", "link.gd", "free.gd"))
    used.touch()
    link.symlink_to(used)
    in_use = FilesInUse([str(link)])

    assert str(used) in in_use
    assert str(free) not in in_use
    assert str(free) not in FilesInUse()
    assert refused(lambda: program_to_save(str(tmp_path / "used"), in_use)) == ("file-in-use", str(used), "")
    assert file_to_save(str(used), in_use, ".txt", own=used) == used
    assert refused(lambda: file_to_save(str(used), in_use, ".txt", own=link))[0] == "file-in-use"


def test_a_page_is_not_saved_onto_an_open_program(tmp_path: Path) -> None:
    program, page = tmp_path / "a.gd", tmp_path / "page.html"
    program.touch()
    open_programs = [None, tmp_path / "other.gd", program]

    assert page_to_save(str(page), open_programs, FilesInUse()) == page
    assert refused(lambda: page_to_save(str(tmp_path / "a"), open_programs, FilesInUse())) == (
        *("file-is-open", str(program), ""),
    )


@pytest.mark.parametrize("name", ["", '""', "/", "."])
def test_a_name_that_is_only_a_folder_is_refused(name: str) -> None:
    assert refused(lambda: program_to_open(name))[0] == "file-is-folder"


def test_the_file_of_a_name_comes_before_the_one_with_the_suffix(tmp_path: Path) -> None:
    for name in ("a", "a.gd"):
        (tmp_path / name).touch()

    assert program_to_open(f" \u201c{tmp_path}/a\u201d ") == tmp_path / "a"


def test_a_name_is_taken_as_it_is_typed(tmp_path: Path) -> None:
    """A blank in quotes, an account that there is not, a name that is longer than a file's can be."""
    long = tmp_path / ("x" * 300)

    assert program_to_save(f"'{tmp_path}/ a'", FilesInUse()) == tmp_path / " a.gd"
    assert program_to_open("~no-such-account/a.gd") == Path("~no-such-account/a.gd")
    assert program_to_open(str(long)) == long
    assert program_to_save(str(long), FilesInUse()) == long.with_name(long.name + ".gd")
    assert not is_same_file(long, long)


def test_a_save_asks_before_it_replaces_what_is_not_the_program_as_it_was(tmp_path: Path) -> None:
    own, other, link = (tmp_path / each for each in ("own.gd", "other.gd", "link.gd"))
    for each in (own, other):
        each.write_text("FW 1\r\nFW 2\n")
    link.symlink_to(own)
    known = "FW 1\nFW 2"

    questions = [save_question(each, own, known) for each in (own, link, other, tmp_path / "new.gd")]
    assert questions == ["", "", "ask-replace", ""]
    assert save_question(own, None, known) == "ask-replace"
    own.write_text("FW 3\n")
    assert save_question(link, own, known) == "ask-replace-changed"
    assert [changed_since(each, known) for each in (own, other, tmp_path / "new.gd")] == [True, False, False]
    assert not changed_since(tmp_path, known)
    assert [saved_text(each) for each in (own, tmp_path, tmp_path / "new.gd")] == ["FW 3\n", "", ""]


def test_an_error_names_its_file_and_the_reason(tmp_path: Path) -> None:
    (tmp_path / "a.gd").touch()
    below, zero = tmp_path / "a.gd" / "b.gd", tmp_path / "a\0b"
    no_folder, wrong = os.strerror(errno.ENOTDIR), os.strerror(errno.EINVAL)

    assert refused(lambda: read_program(below)) == ("file-unreadable", str(below), no_folder)
    assert refused(lambda: write_program(below, "")) == ("file-unwritable", str(below), no_folder)
    assert refused(lambda: read_program(zero)) == ("file-unreadable", str(zero), wrong)
    assert refused(lambda: read_program(tmp_path / "none")) == ("file-not-found", str(tmp_path / "none"), "")
    assert refused(lambda: decode(b"x" * (8 * 1024 * 1024 + 1), "-")) == ("file-too-large", "-", "8")
    code, path, reason = refused(lambda: write_program(tmp_path / "a.gd", "\udcff"))
    assert (code, path) == ("file-unwritable", str(tmp_path / "a.gd"))
    assert "surrogates not allowed" in reason


@pytest.mark.parametrize(("mask", "mode"), [(0o022, 0o644), (0o077, 0o600)])
def test_a_new_file_has_the_permissions_of_the_account(tmp_path: Path, mask: int, mode: int) -> None:
    before = os.umask(mask)
    try:
        write_program(tmp_path / "a.gd", "FW 1")
        assert os.umask(mask) == mask
    finally:
        os.umask(before)

    assert (tmp_path / "a.gd").stat().st_mode & 0o777 == mode


def test_a_write_that_fails_leaves_the_old_file_and_no_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "a.gd").write_text("old")

    def full(_number: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    failed = refused(lambda: write_program(tmp_path / "a.gd", "new"))

    assert failed == ("file-unwritable", str(tmp_path / "a.gd"), os.strerror(errno.ENOSPC))
    assert {each.name: each.read_text() for each in tmp_path.iterdir()} == {"a.gd": "old"}


def test_a_companion_has_the_first_number_that_is_free_or_the_same(tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    (tmp_path / "page-2.svg").mkdir()
    names = [write_companion(page, ".svg", data) for data in (b"one", b"two", b"one", b"two", b"three")]

    assert names == ["page-1.svg", "page-3.svg", "page-1.svg", "page-3.svg", "page-4.svg"]
    assert (tmp_path / "page-3.svg").read_bytes() == b"two"


def test_new_files_have_names_of_their_own(tmp_path: Path) -> None:
    found = list[Path]()
    for _ in range(2):
        number, path = new_file(tmp_path, "copy-", ".txt")
        os.write(number, b"x")
        os.close(number)
        found.append(path)

    assert len({*found}) == 2
    assert sorted(found) == sorted(tmp_path.glob("copy-*.txt"))
    assert {each.stat().st_mode & 0o777 for each in found} == {0o600}


# --- what is kept from one start to the next

TRY = Attempted("2026-01-02T03:04:05+00:00", "walls", True, 2, 2, 9, 8, 7, 6, 5, 4, 3, 1)


def test_a_try_is_a_line_of_values_between_tabs(tmp_path: Path) -> None:
    file = ProgressFile(str(tmp_path / "new" / "progress"))
    assert file.attempts() == ()
    file.add(TRY)

    line = "2026-01-02T03:04:05+00:00\twalls\tTrue\t2\t2\t9\t8\t7\t6\t5\t4\t3\t1\n"
    assert (tmp_path / "new" / "progress").read_text() == line
    assert file.attempts() == (TRY,)


def test_a_try_of_an_earlier_version_has_fewer_values_and_a_damaged_one_is_left_out(tmp_path: Path) -> None:
    kept = tmp_path / "progress"
    kept.write_text(
        "t1\tone\tFalse\t0\t2\t9\t8\t7\t6\n"  # without seconds, shortest and questions
        "t2\ttwo\tTrue\t1\tmany\t9\t8\t7\t6\n"
        "t3\tthree\n"
        "t4\tfour\tTrue\t2\t2\t9\t8\t7\t6\t5\t4\t3\t1\t0\n"  # of a later version
        "t5\tfive\tTrue\t2\t2\t9\t8\t7\t6\n"
    )
    file = ProgressFile(str(kept))

    first, second = file.attempts()
    assert first == Attempted("t1", "one", False, 0, 2, 9, 8, 7, 6)
    assert (first.seconds, first.shortest, first.questions, first.right) == (0, 0, 0, 0)
    assert second.name == "five"
    assert file.solved == {"five"}


def test_progress_that_cannot_be_kept_is_not_reported(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    file = ProgressFile(str(tmp_path / "file" / "progress"))
    file.add(TRY)

    assert file.attempts() == ()
    assert file.solved == frozenset()


def test_the_program_used_last_comes_first_and_twenty_are_kept(tmp_path: Path) -> None:
    recent = RecentFiles(str(tmp_path / "state" / "recent"))
    programs = [tmp_path / f"{number}.gd" for number in range(22)]
    for each in programs:
        each.touch()
        recent.add(each)
    recent.add(programs[5])

    assert recent.paths() == (programs[5], *(each for each in reversed(programs[2:]) if each != programs[5]))
    assert len(recent.paths()) == 20
    programs[10].unlink()
    assert programs[10] not in recent.paths()


@pytest.mark.parametrize(("size", "count"), [(100_000, 1), (100_001, 0)])
def test_a_list_of_programs_has_a_hundred_thousand_bytes_at_most(
    tmp_path: Path, size: int, count: int
) -> None:
    program, kept = tmp_path / "a.gd", tmp_path / "recent"
    program.touch()
    kept.write_text(f"{program}\n".ljust(size, "x"))

    assert len(RecentFiles(str(kept)).paths()) == count


@pytest.mark.parametrize(("size", "count"), [(10_000_000, 1), (10_000_001, 0)])
def test_what_was_done_for_challenges_has_ten_million_bytes_at_most(
    tmp_path: Path, size: int, count: int
) -> None:
    kept = tmp_path / "progress"
    ProgressFile(str(kept)).add(TRY)
    kept.write_text(kept.read_text().ljust(size, "x"))

    assert ProgressFile(str(kept)).attempts() == (TRY,) * count


@pytest.mark.parametrize(("size", "lines"), [(400_000, {3}), (400_001, set())])
def test_breakpoints_have_four_hundred_thousand_bytes_at_most(
    tmp_path: Path, size: int, lines: set[int]
) -> None:
    program, kept = tmp_path / "a.gd", tmp_path / "breakpoints"
    BreakpointFile(str(kept)).write(program, {3})
    kept.write_text(kept.read_text().ljust(size, "x"))

    assert BreakpointFile(str(kept)).read(program, 9) == lines


def test_two_names_are_one_file_if_they_lead_to_it(tmp_path: Path) -> None:
    one, other, link, missing = (tmp_path / each for each in ("one.gd", "other.gd", "link.gd", "missing.gd"))
    for each in (one, other):
        each.write_text("FW 1\n")
    link.symlink_to(one)

    assert is_same_file(one, link)
    assert is_same_file(missing, tmp_path / "folder" / ".." / "missing.gd")
    assert not is_same_file(one, other)
    assert not is_same_file(one, missing)
    assert not is_same_file(Path("/dev/null"), Path("/dev/null"))


def test_breakpoints_are_kept_within_their_limits(tmp_path: Path) -> None:
    program, file = tmp_path / "a.gd", BreakpointFile(str(tmp_path / "state" / "breakpoints"))
    file.write(None, [1])
    file.write(program, range(300, 0, -1))

    assert file.read(program, 1000) == frozenset(range(1, 201))
    assert file.read(program, 200) == frozenset(range(1, 201))
    assert file.read(program, 199) == frozenset(range(1, 200))
    assert file.read(None, 9) == frozenset()
    (tmp_path / "state" / "breakpoints").write_text(f"0 1 123456789 2\t{program}\n1 2\t\n3\n")
    assert file.read(program, 10**10) == frozenset()
    (tmp_path / "state" / "breakpoints").write_text(f"1 x 2\t{program}\n1 -2\t{program}\n")
    assert file.read(program, 10**10) == frozenset()
    (tmp_path / "state" / "breakpoints").write_text(f"0 1 12345678\t{program}\n")
    assert file.read(program, 10**10) == {1, 12345678}


def test_breakpoints_of_two_hundred_programs_are_kept(tmp_path: Path) -> None:
    file = BreakpointFile(str(tmp_path / "breakpoints"))
    for number in range(202):
        file.write(tmp_path / f"{number}.gd", [number + 1])

    found = [bool(file.read(tmp_path / f"{number}.gd", 999)) for number in range(202)]
    assert found == [False, False, *[True] * 200]
    file.write(tmp_path / "201.gd", [])
    assert not file.read(tmp_path / "201.gd", 999)
    assert file.read(tmp_path / "200.gd", 999) == {201}


def test_typed_names_become_files_and_folders(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "walks" / "deep").mkdir(parents=True)
    for name in ("walk.gd", "wall.gd", ".hidden", "walks/one.gd"):
        (tmp_path / name).touch()
    monkeypatch.chdir(tmp_path)

    assert file_names("wal") == ("walk.gd", "walks/", "wall.gd")
    assert file_names("") == ("walk.gd", "walks/", "wall.gd")
    assert file_names(".") == (".hidden",)
    assert file_names("walks/") == ("walks/deep/", "walks/one.gd")
    assert file_names(f"{tmp_path}/walks/o") == (f"{tmp_path}/walks/one.gd",)
    assert file_names("/tm") == tuple(
        f"/{each.name}/" if each.is_dir() else f"/{each.name}" for each in sorted(Path("/").glob("tm*"))
    )
    assert file_names("nowhere/a") == ()


# --- what there is to open


def names_in(folder: Path) -> list[str]:
    return [each.name for each in programs_in(folder)]


def test_programs_are_listed_by_their_numbers_and_before_folders(tmp_path: Path) -> None:
    for name in ("program10.gd", "program2.gd", "Ábaco.gd", "zoo.gd", "notes.txt", ".hidden.gd", "gd"):
        (tmp_path / name).touch()
    (tmp_path / "a folder.gd").mkdir()
    (tmp_path / "old").mkdir()

    assert names_in(tmp_path) == ["Ábaco.gd", "program2.gd", "program10.gd", "zoo.gd", "a folder.gd/", "old/"]


def test_links_lead_to_programs_and_folders_but_in_no_circle(tmp_path: Path) -> None:
    (tmp_path / "one" / "deep").mkdir(parents=True)
    (tmp_path / "two").mkdir()
    (tmp_path / "a.gd").touch()
    for name, target in (
        ("one/up", ".."),
        ("one/here", "."),
        ("one/other", "../two"),
        ("one/b.gd", "../a.gd"),
        ("one/none.gd", "nowhere"),
        ("one/self.gd", "self.gd"),
        ("two/back", "../one"),
    ):
        (tmp_path / name).symlink_to(target)

    assert names_in(tmp_path / "one") == ["b.gd", "deep/", "other/"]
    inside = [str(tmp_path.resolve() / "one"), str(tmp_path.resolve() / "two")]
    assert programs_in(tmp_path / "one" / "other", inside) == ()
    assert [each.name for each in programs_in(tmp_path, inside)] == ["a.gd", "one/", "two/"]


@pytest.mark.parametrize("name", ["nowhere", "a.gd"])
def test_what_is_no_folder_is_not_listed(tmp_path: Path, name: str) -> None:
    (tmp_path / "a.gd").touch()
    with pytest.raises(DocumentError) as problem:
        programs_in(tmp_path / name)

    assert problem.value.code == "file-unreadable"
    assert problem.value.reason


@pytest.mark.skipif(os.getuid() == 0, reason="root reads every folder")
def test_a_folder_without_permission_is_not_listed(tmp_path: Path) -> None:
    tmp_path.chmod(0)
    try:
        with pytest.raises(DocumentError):
            programs_in(tmp_path)
    finally:
        tmp_path.chmod(0o700)


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("sq", "square.gd"),
        ("SQ", "square.gd"),
        ("acao", "ação é.gd"),
        ("sub/de", "sub/deep.gd"),
        ("quare", "quare"),
        ("su", "su"),
        ("nowhere/x", "nowhere/x"),
    ],
)
def test_the_beginning_of_a_name_means_the_only_program_that_has_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, typed: str, meant: str
) -> None:
    (tmp_path / "sub").mkdir()
    for name in ("square.gd", "stairs.gd", "ação é.gd", "sub/deep.gd"):
        (tmp_path / name).touch()
    monkeypatch.chdir(tmp_path)
    assert str(program_meant(typed)) == meant
    with pytest.raises(DocumentError) as problem:
        program_meant("s")
    assert (problem.value.code, problem.value.reason) == ("file-several", "2")
