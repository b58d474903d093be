"""Program files are read in any likely encoding, and written so that nothing is lost."""

import os
import threading
from pathlib import Path

import pytest

from donnie_tui.core import program_files
from donnie_tui.core.program_files import (
    DocumentError,
    FilesInUse,
    decode,
    program_to_open,
    program_to_save,
    read_program,
    read_to_the_end,
    write_program,
)


@pytest.mark.parametrize(
    ("data", "text"),
    [
        (b"", ""),
        ('SPEAK "olá"'.encode(), 'SPEAK "olá"'),
        (b"\xef\xbb\xbfFW 1", "FW 1"),
        ("CRIAR ação = 1".encode("cp1252"), "CRIAR ação = 1"),
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
    (tmp_path / "picture.gd").write_bytes(b"\x89PNG\0")

    codes = {}
    for name in ("large.gd", "picture.gd", "none.gd", "."):
        with pytest.raises(DocumentError) as caught:
            read_program(tmp_path / name)
        codes[name] = caught.value.code

    assert codes == {
        "large.gd": "file-too-large",
        "picture.gd": "file-not-text",
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
    assert caught.value.code == "file-not-text"


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
