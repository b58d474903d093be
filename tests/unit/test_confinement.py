"""What a confined process can open, make and list, whatever a path looks like."""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from donnie_tui.core.program_files import (
    DocumentError,
    FilesInUse,
    RecentFiles,
    program_to_open,
    program_to_save,
    programs_in,
    read_program,
    write_program,
)
from donnie_tui.core.recovery import CopyFolder
from donnie_tui.core.session_log import LineHistory
from donnie_tui.linear.reader import candidates
from donnie_tui.process import confinement
from donnie_tui.process.confinement import (
    Confinement,
    OpenFolder,
    OutsideError,
    check_name,
    confine,
    folder_items,
    is_allowed,
    make_folder,
    open_bytes,
    open_descriptor,
    open_text,
)

SECRET = "-- the teacher's\nFW 7\n"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """The folder of a pupil, next to a file of the teacher."""
    (tmp_path / "secret.gd").write_text(SECRET)
    (tmp_path / "ana2").mkdir()
    (tmp_path / "ana2" / "secret.gd").write_text(SECRET)
    place = tmp_path / "ana"
    (place / "sub").mkdir(parents=True)
    (place / "mine.gd").write_text("FW 1\n")
    (place / "sub" / "coração é.gd").write_text("FW 2\n")
    (place / "link.gd").symlink_to(tmp_path / "secret.gd")
    (place / "relative.gd").symlink_to("../secret.gd")
    (place / "chain.gd").symlink_to("link.gd")
    (place / "way").symlink_to(tmp_path)
    (place / "new.gd").symlink_to(tmp_path / "not-there-yet.gd")
    (place / "root").symlink_to("/proc/self/root")
    (place / "inner.gd").symlink_to("mine.gd")
    (place / "within").symlink_to("sub")
    (place / "loop.gd").symlink_to("loop.gd")
    monkeypatch.chdir(tmp_path)
    confine(Confinement(str(place)))
    yield place
    confine(None)


OUTSIDE = [
    "../secret.gd",
    "sub/../../secret.gd",
    "{outside}/secret.gd",
    "{outside}/ana2/secret.gd",
    "link.gd",
    "relative.gd",
    "chain.gd",
    "way/secret.gd",
    "way/ana/../secret.gd",
    "root/etc/passwd",
    "/proc/self/root/{outside}/secret.gd",
    "/proc/self/cwd/../secret.gd",
    "/proc/self/fd/0",
    "/proc/self/environ",
    "/dev/stdin",
    "/dev/tty",
    "//etc/passwd",
    "/etc/passwd",
    "/",
    "..",
    "new.gd",
    "./././../secret.gd",
    "“../secret.gd”",
]
INSIDE = [
    "mine.gd",
    "./mine.gd",
    "sub/../mine.gd",
    "{inside}/mine.gd",
    "way/ana/mine.gd",
    "inner.gd",
    "within/coração é.gd",
    "sub/coração é.gd",
    "/proc/self/cwd/mine.gd",
    "/proc/self/root/{inside}/mine.gd",
]


def filled(name: str, folder: Path) -> str:
    return name.format(outside=folder.parent, inside=folder)


@pytest.mark.parametrize("name", OUTSIDE)
def test_nothing_outside_is_read_or_written(name: str, folder: Path) -> None:
    name = filled(name, folder)
    with pytest.raises(DocumentError) as typed:
        program_to_open(name)
    assert typed.value.code in ("file-outside", "file-is-folder")
    plain = name.strip("“”")
    for flags in (os.O_RDONLY, os.O_WRONLY, os.O_RDWR | os.O_CREAT, os.O_WRONLY | os.O_CREAT | os.O_TRUNC):
        with pytest.raises(OutsideError):
            open_descriptor(plain, flags)
    with pytest.raises(DocumentError):
        write_program(Path(plain), "FW 9\n")
    with pytest.raises(DocumentError):
        read_program(Path(plain))
    with pytest.raises(OutsideError):
        make_folder(f"{plain}/made")

    assert (folder.parent / "secret.gd").read_text() == SECRET
    assert not (folder.parent / "not-there-yet.gd").exists()
    assert not (folder.parent / "made").exists()


@pytest.mark.parametrize("name", INSIDE)
def test_what_is_inside_by_any_name_is_read_and_written(name: str, folder: Path) -> None:
    path = program_to_open(filled(name, folder))

    assert read_program(path).startswith("FW")
    write_program(path, "TR 90\n")
    assert read_program(path) == "TR 90\n"
    assert not list(folder.rglob(".*")), "nothing is left of the writing"


@pytest.mark.parametrize("name", ["~/secret.gd", "~root/x", "~", "~nobody-of-that-name/x.gd"])
def test_a_home_is_outside_whether_it_exists_or_not(name: str, folder: Path) -> None:
    with pytest.raises(DocumentError) as typed:
        program_to_open(name)
    assert typed.value.code == "file-outside"


@pytest.mark.parametrize("name", [".bashrc", ".ssh/authorized_keys", "sub/.hidden/a.gd", ".donnie/history"])
def test_a_hidden_name_is_refused(name: str, folder: Path) -> None:
    with pytest.raises(DocumentError) as typed:
        program_to_open(name)
    assert typed.value.code == "file-hidden"


def test_a_link_to_a_hidden_file_is_refused(folder: Path) -> None:
    (folder / ".profile").write_text("")
    (folder / "shown.gd").symlink_to(".profile")
    with pytest.raises(DocumentError) as typed:
        program_to_open("shown.gd")
    assert typed.value.code == "file-hidden"


def test_a_name_to_which_the_suffix_is_added_is_refused_as_the_link_that_it_is(folder: Path) -> None:
    (folder / "shown.gd").symlink_to(".profile")
    for name, code in (("link", "file-outside"), ("shown", "file-hidden"), ("new", "file-outside")):
        with pytest.raises(DocumentError) as saved:
            program_to_save(name, FilesInUse())
        assert saved.value.code == code
    with pytest.raises(DocumentError) as opened:
        program_to_open("link")
    assert opened.value.code == "file-outside"


def test_a_name_without_an_end_and_a_link_to_itself_are_only_refused(folder: Path) -> None:
    for name in ("x" * 5000, "loop.gd", "a/" * 3000 + "b"):
        with pytest.raises(DocumentError):
            read_program(program_to_open(name))


def test_the_folder_may_be_reached_by_a_link_itself(folder: Path) -> None:
    (folder.parent / "class").symlink_to(folder)
    confine(Confinement(str(folder.parent / "class")))

    assert read_program(program_to_open(f"{folder.parent}/class/mine.gd")) == "FW 1\n"
    assert not is_allowed(f"{folder.parent}/class/../secret.gd")


def test_a_file_becomes_a_link_between_the_look_and_the_opening(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Another session of the same account may make links at any moment."""
    real = os.path.realpath(folder / "mine.gd")
    (folder / "mine.gd").unlink()
    (folder / "mine.gd").symlink_to(folder.parent / "secret.gd")
    monkeypatch.setattr(confinement.os.path, "realpath", lambda path, **_: real)

    for flags in (os.O_RDONLY, os.O_WRONLY | os.O_TRUNC, os.O_RDWR | os.O_CREAT):
        with pytest.raises(OutsideError):
            open_descriptor("mine.gd", flags)
    assert (folder.parent / "secret.gd").read_text() == SECRET


def test_a_folder_becomes_a_link_between_the_look_and_the_writing(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = {str(each): os.path.realpath(each) for each in (folder / "sub", folder / "sub" / "a.gd")}
    (folder / "sub").rename(folder / "elsewhere")
    (folder / "sub").symlink_to(folder.parent / "ana2")
    found = os.path.realpath
    monkeypatch.setattr(
        confinement.os.path, "realpath", lambda path, **how: before.get(str(path)) or found(path, **how)
    )
    monkeypatch.setattr(Path, "resolve", lambda path, strict=False: path)

    with pytest.raises(DocumentError):
        write_program(folder / "sub" / "a.gd", "FW 9\n")
    with pytest.raises(OSError, match="Not a directory"):
        open_descriptor(folder / "sub" / "a.gd", os.O_RDWR | os.O_CREAT)
    assert [each.name for each in (folder.parent / "ana2").iterdir()] == ["secret.gd"]


def test_what_comes_with_donnie_is_read_and_never_written(folder: Path, tmp_path: Path) -> None:
    shipped = tmp_path / "shipped"
    shipped.mkdir()
    (shipped / "a.inc").write_text("# a\n")
    (shipped / "out.inc").symlink_to(tmp_path / "secret.gd")
    confine(Confinement(str(folder), readable=(str(shipped),)))

    with open_bytes(shipped / "a.inc") as file:
        assert file.read() == b"# a\n"
    for refused, mode in ((shipped / "a.inc", "w"), (shipped / "b.inc", "w"), (shipped / "out.inc", "r")):
        with pytest.raises(OutsideError):
            open_text(refused, mode)
    for flag in (os.O_WRONLY, os.O_RDWR, os.O_CREAT, os.O_TRUNC, os.O_APPEND):
        with pytest.raises(OutsideError) as outside:
            open_descriptor(shipped / "a.inc", flag)
    assert (outside.value.errno, outside.value.filename) == (errno.EACCES, str(shipped / "a.inc"))
    assert (outside.value.path, outside.value.code) == (str(shipped / "a.inc"), "file-outside")
    with pytest.raises(OutsideError):
        check_name(shipped / "a.inc")


def test_the_history_and_the_copies_do_not_leave_by_a_link(folder: Path, tmp_path: Path) -> None:
    """A pupil who can also copy files there could have made these links."""
    (folder / ".donnie").mkdir()
    (folder / ".donnie" / "history").symlink_to(tmp_path / "secret.gd")
    LineHistory(str(folder / ".donnie" / "history")).remember("touch /tmp/x")
    assert (tmp_path / "secret.gd").read_text() == SECRET
    assert LineHistory(str(folder / ".donnie" / "history")).lines == []

    (tmp_path / "outside").mkdir()
    (tmp_path / "outside" / "unsaved-1-1.gd").write_text(SECRET)
    (folder / ".donnie" / "unsaved").symlink_to(tmp_path / "outside")
    copies = CopyFolder(str(folder / ".donnie" / "unsaved"))
    assert copies.offered() == []
    with pytest.raises(OSError, match="Permission denied"):
        copies.new_copy()


def test_recent_files_are_those_inside(folder: Path, tmp_path: Path) -> None:
    (folder / ".donnie").mkdir()
    recent = RecentFiles(str(folder / ".donnie" / "recent.txt"))
    names = [tmp_path / "secret.gd", folder / "mine.gd", folder / "link.gd", "/etc/passwd"]
    (folder / ".donnie" / "recent.txt").write_text("".join(f"{each}\n" for each in names))

    assert recent.paths() == (folder / "mine.gd",)


@pytest.mark.parametrize(
    "typed", ["../s", "way/s", "/etc/pas", "/proc/self/root/etc/pas", ".h", ".donnie/", "li", "r"]
)
def test_tab_completes_no_name_from_outside_and_no_hidden_one(typed: str, folder: Path) -> None:
    (folder / ".hidden.gd").write_text("")
    (folder / ".donnie").mkdir()

    assert candidates(None, f"OPEN {typed}") == ()  # type: ignore[arg-type] # a file name needs no context


@pytest.mark.parametrize(
    ("typed", "found"), [("m", "mine.gd"), ("sub/", "sub/coração é.gd"), ("wi", "within/")]
)
def test_tab_completes_names_inside(typed: str, found: str, folder: Path) -> None:
    assert candidates(None, f"OPEN {typed}") == (found,)  # type: ignore[arg-type] # as above


def test_a_relative_name_means_a_file_inside(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    confine(Confinement(str(folder)))
    assert Path.cwd() == folder

    monkeypatch.chdir(folder / "sub")
    confine(Confinement(str(folder)))
    assert Path.cwd() == folder / "sub"


@pytest.mark.parametrize("is_confined", [True, False])
def test_a_pipe_that_no_one_writes_into_is_refused_and_not_waited_for(
    folder: Path, tmp_path: Path, is_confined: bool
) -> None:
    confine(Confinement(str(folder)) if is_confined else None)
    os.mkfifo(folder / "pipe")
    reader = os.open(folder / "pipe", os.O_RDWR)  # with it, no one waits to open the pipe, whatever is broken

    with pytest.raises(OSError, match="pipe"):
        confinement.open_bytes(folder / "pipe")
    assert not confinement.open_bytes(folder / "mine.gd").closed
    os.close(reader)


@pytest.mark.parametrize("is_confined", [True, False])
def test_a_file_to_read_is_opened_without_waiting_and_read_with_it(
    folder: Path, is_confined: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    if not is_confined:
        confine(None)
    flags = list[int]()

    def opened(path: str, given: int) -> int:
        flags.append(given)
        return open_descriptor(path, given)

    monkeypatch.setattr(confinement, "open_descriptor", opened)
    with open_bytes(folder / "mine.gd") as file:
        assert os.get_blocking(file.fileno())
        assert not os.get_inheritable(file.fileno())
    assert [each & os.O_NONBLOCK for each in flags] == [os.O_NONBLOCK]


def test_an_unconfined_process_opens_what_it_is_given(folder: Path, tmp_path: Path) -> None:
    confine(None)

    assert read_program(program_to_open(str(tmp_path / "secret.gd"))) == SECRET
    assert is_allowed("/etc/passwd")
    assert program_to_open("~").is_absolute()


def test_only_what_is_inside_and_not_hidden_is_listed(folder: Path) -> None:
    (folder / ".hidden.gd").touch()
    os.mkfifo(folder / "pipe.gd")

    assert {each.name for each in programs_in(folder)} == {"mine.gd", "inner.gd", "sub/", "within/"}
    assert [each.name for each in programs_in(folder / "within")] == ["coração é.gd"]
    assert {*folder_items(folder)} == {
        ("mine.gd", False, False),
        ("inner.gd", False, True),
        ("sub", True, False),
        ("within", True, True),
    }
    before = [*Path("/proc/self/fd").iterdir()]
    folder_items(folder)
    os.close(open_descriptor("sub/coração é.gd", os.O_RDONLY))
    assert len([*Path("/proc/self/fd").iterdir()]) == len(before)
    confine(None)
    everywhere = {name for name, *_ in folder_items(folder)}
    assert everywhere == {
        "mine.gd",
        "inner.gd",
        "sub",
        "within",
        "link.gd",
        "relative.gd",
        "chain.gd",
        "way",
        "root",
    }


@pytest.mark.parametrize("name", ["..", "/", "way", "sub/../..", "root/etc", ".donnie"])
def test_no_other_folder_is_listed(name: str, folder: Path) -> None:
    (folder / ".donnie").mkdir()
    with pytest.raises(OutsideError):
        folder_items(str(folder / name))
    with pytest.raises(DocumentError) as problem:
        programs_in(folder / name)
    assert problem.value.code in ("file-outside", "file-hidden")


def test_a_folder_that_becomes_a_link_while_it_is_checked_is_not_followed(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def swap(_path: object) -> None:
        (folder / "sub").rename(folder / "moved")
        (folder / "sub").symlink_to(folder.parent)

    monkeypatch.setattr(confinement, "check_name", swap)
    with pytest.raises(OSError):
        folder_items(folder / "sub")


def test_an_open_folder_stays_the_same_one_while_it_is_used(folder: Path) -> None:
    with OpenFolder(folder / "sub") as place:
        (folder / "sub").rename(folder / "elsewhere")
        (folder / "sub").symlink_to(folder.parent / "ana2")
        os.close(place.open_new("new"))
        with pytest.raises(FileExistsError):
            place.open_new("new")
        assert (folder / "elsewhere" / "new").stat().st_mode & 0o777 == 0o600
        place.replace("new", "coração é.gd")
        assert (folder / "elsewhere" / "coração é.gd").read_text() == ""
        place.remove("coração é.gd")
        number = place._number
    assert not [*(folder / "elsewhere").iterdir()]
    assert number is not None
    with pytest.raises(OSError):
        os.fstat(number)
    with pytest.raises(OutsideError):
        OpenFolder(folder.parent)


def test_an_unconfined_folder_is_used_by_its_name(folder: Path) -> None:
    confine(None)
    with OpenFolder(folder / "sub") as place:
        number = place.open_new("new")
        os.write(number, b"FW 1")
        os.lseek(number, 0, os.SEEK_SET)
        assert os.read(number, 4) == b"FW 1", "it is written and read"
        os.close(number)
        place.replace("new", "old")
    assert (folder / "sub" / "old").read_text() == "FW 1"


def test_a_text_is_read_with_any_line_ends_and_written_with_one(folder: Path) -> None:
    umask = os.umask(0)
    with open_text("mine.gd", "w") as file:
        file.write("é\n")
    with open_text("new2.gd", "w") as file:
        file.write("x")
    os.umask(umask)
    assert (folder / "mine.gd").read_bytes() == b"\xc3\xa9\n"
    assert (folder / "new2.gd").stat().st_mode & 0o777 == 0o666
    (folder / "mine.gd").write_bytes(b"a\r\nb\rc\xff\n")
    with open_text("mine.gd", errors="replace") as file:
        assert file.read() == "a\nb\nc\ufffd\n"
    with open_text("mine.gd") as file, pytest.raises(UnicodeDecodeError):
        file.read()
    with open_bytes("mine.gd") as file:
        assert os.get_blocking(file.fileno())
        assert not os.get_inheritable(file.fileno())


@pytest.mark.parametrize(
    ("outer", "path", "rest"),
    [("/a", "/a", ""), ("/a", "/a/b/c", "b/c"), ("/", "/b", "b"), ("/a", "/ab", None), ("/a/b", "/a", None)],
)
def test_a_path_is_below_a_folder_by_whole_names(outer: str, path: str, rest: str | None) -> None:
    assert confinement.part_below(outer, path) == rest


def test_a_confined_session_has_a_folder_of_its_own_and_starts_no_program(folder: Path) -> None:
    held = confinement.confinement()
    assert held is not None
    assert (held.folder, held.own_folder) == (str(folder), f"{folder}/.donnie")
    assert not confinement.may_run_programs()
    confinement.check_own(folder / ".donnie" / "unsaved")
    for _ in range(2):
        make_folder(folder / ".donnie" / "unsaved")
    with pytest.raises(OutsideError):
        confinement.check_own(folder / "way" / "x")
    confine(None)
    assert confinement.may_run_programs()
    confinement.check_own("/")
    assert confinement.confinement() is None


def test_a_path_without_a_place_is_only_made_shorter(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert confinement.real_path("a/../b\0") == "b\0"
    assert confinement.real_path(folder / "within") == str(folder / "sub")
    assert not is_allowed("b\0")
    confine(None)
    (tmp_path / "gone").mkdir()
    monkeypatch.chdir(tmp_path / "gone")
    (tmp_path / "gone").rmdir()
    assert confinement.real_path("a/../b") == "b"


@pytest.mark.skipif(sys.platform != "linux", reason="another system may not have what it needs")
def test_a_session_can_be_confined_here() -> None:
    assert confinement.IS_POSSIBLE
