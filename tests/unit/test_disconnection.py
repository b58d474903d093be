"""Each sign that the learner is gone: a reader that closed the output, and a network that does not answer."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest

from donnie_tui.process import disconnection
from donnie_tui.process.disconnection import (
    NetworkWatch,
    ReaderWatch,
    attempts,
    parent_of,
    ssh_connections_of,
)
from donnie_tui.process.signals import TakenSignals, is_hung_up
from tests.sessions.real_robot import until
from tests.timeouts import TIMEOUT

ON_LINUX = pytest.mark.skipif(sys.platform != "linux", reason="another system says it in no file")


def readers() -> list[threading.Thread]:
    return [each for each in threading.enumerate() if each.name == "readers"]


@pytest.fixture
def hang_ups() -> Iterator[threading.Event]:
    """Look at it again and again: a handler does not run during a wait that its signal just preceded."""
    heard = threading.Event()
    with TakenSignals({signal.SIGHUP: lambda *_: heard.set()}):
        yield heard


@pytest.mark.parametrize("lost", [0, 1])
def test_an_output_without_a_reader_is_a_hang_up(
    lost: int, hang_ups: threading.Event, monkeypatch: pytest.MonkeyPatch
) -> None:
    pipe, connection = os.pipe(), socket.socketpair()
    ends = pipe[0], connection[0].detach()
    outputs = pipe[1], connection[1].detach()
    monkeypatch.setattr(disconnection, "_OUTPUTS", outputs)
    with closing(ReaderWatch()):
        assert len(readers()) == 1
        os.close(ends[lost])
        assert until(hang_ups.is_set)

    for each in (ends[1 - lost], *outputs):
        os.close(each)


def test_after_its_close_no_reader_is_watched(
    hang_ups: threading.Event, monkeypatch: pytest.MonkeyPatch
) -> None:
    reading, writing = os.pipe()
    monkeypatch.setattr(disconnection, "_OUTPUTS", (writing,))
    watch = ReaderWatch()
    own = watch._reading, watch._writing
    watch.close()
    watch.close()

    assert readers() == []
    os.close(reading)
    assert not hang_ups.is_set()
    for each in own:
        with pytest.raises(OSError):
            os.fstat(each)
    os.close(writing)


def test_a_file_and_a_closed_output_have_no_reader(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    number = os.open(tmp_path / "file", os.O_WRONLY | os.O_CREAT)
    monkeypatch.setattr(disconnection, "_OUTPUTS", (number, 9999))
    with closing(ReaderWatch()):
        assert readers() == []
    os.close(number)


def test_a_row_of_a_table_is_read_as_far_as_the_number_of_attempts() -> None:
    row = " 1: HERE THERE 01 0:0 01:6F 0000000A"
    ends = (("HERE", "THERE"),)
    assert attempts([row.rpartition(" ")[0], row], ends) == 10
    assert attempts([row], (("THERE", "HERE"),)) == 0


@pytest.mark.skipif(sys.byteorder != "little", reason="the row is from a little-endian machine")
@pytest.mark.parametrize(("count", "is_lost"), [(3, False), (4, True)])
def test_a_network_that_did_not_answer_four_times_is_lost(
    count: int, is_lost: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """After a look at a table that this kernel doesn't have, and at one that it has."""
    row = f"   1: 01004D0A:9D1F 02004D0A:A5EB 01 0:0 01:6F 0000000{count}     0 0 18 2 0 20\n"
    (tmp_path / "tcp6").write_text(row, encoding="ascii")
    monkeypatch.setattr(disconnection, "TABLES", (tmp_path / "missing", tmp_path / "tcp6"))
    monkeypatch.setattr(disconnection, "LOOK", 0.0)
    by_ssh = {"SSH_CONNECTION": "10.77.0.2 42475 10.77.0.1 40223"}
    looked, lost, row_of = threading.Event(), threading.Event(), disconnection._rows

    def rows() -> Iterator[str]:
        yield from row_of()
        if looked.is_set():
            second.set()
        looked.set()

    second = threading.Event()
    monkeypatch.setattr(disconnection, "_rows", lambda: list(rows()))
    with closing(NetworkWatch(lost.set, by_ssh)):
        assert second.wait(TIMEOUT), "it looks again"
    assert lost.is_set() == is_lost


@pytest.mark.skipif(sys.byteorder != "little", reason="the ends are those of a little-endian machine")
@pytest.mark.parametrize(
    ("words", "ends"),
    [
        (
            "10.77.0.2 42475 10.77.0.1 22",
            (
                ("01004D0A:0016", "02004D0A:A5EB"),
                ("0000000000000000FFFF000001004D0A:0016", "0000000000000000FFFF000002004D0A:A5EB"),
            ),
        ),
        (
            "fe80::1%eth0 1 2001:db8::2 65535",
            (("B80D0120000000000000000002000000:FFFF", "000080FE000000000000000001000000:0001"),),
        ),
        ("", ()),
        ("10.77.0.2 42475 10.77.0.1", ()),
        ("10.77.0.2 42475 10.77.0.1 22 7", ()),
        ("10.77.0.2 port 10.77.0.1 22", ()),
        ("here 42475 10.77.0.1 22", ()),
        ("10.77.0.2 42475 ::1 22", ()),  # of two versions
    ],
)
def test_the_ends_of_the_connection_are_written_as_in_the_tables(
    words: str, ends: tuple[tuple[str, str], ...]
) -> None:
    assert ssh_connections_of({"SSH_CONNECTION": words}) == ends


@pytest.mark.parametrize("changed", [{}, {"TMUX": "x"}, {"STY": "x"}, {"SSH_CONNECTION": ""}])
def test_a_network_is_watched_unless_its_loss_ends_nothing(
    changed: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(disconnection, "TABLES", ("/missing", os.devnull))
    environment = {"SSH_CONNECTION": "10.0.0.2 1 10.0.0.1 2", **changed}
    with closing(NetworkWatch(pytest.fail, environment)):
        assert [each.daemon for each in threading.enumerate() if each.name == "network"] == (
            [] if changed else [True]
        )


def test_standard_output_and_errors_are_watched(monkeypatch: pytest.MonkeyPatch) -> None:
    looked_at = list[int]()
    monkeypatch.setattr(disconnection, "_has_reader", looked_at.append)
    with closing(ReaderWatch()):
        assert looked_at == [1, 2]


def test_without_a_table_of_the_kernel_nothing_is_watched(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(disconnection, "TABLES", ("/missing",))
    with closing(NetworkWatch(pytest.fail, {"SSH_CONNECTION": "10.0.0.2 1 10.0.0.1 2"})):
        assert "network" not in [each.name for each in threading.enumerate()]


@ON_LINUX
def test_a_process_has_the_parent_that_the_system_says() -> None:
    assert parent_of(os.getpid()) == os.getppid()


# --- the owner of the terminal


@pytest.mark.parametrize(
    ("processes", "keeper"),
    [
        ({30: (20, "5"), 20: (10, "5"), 10: (1, "7")}, 10),
        ({30: (10, "5"), 10: (1, "7")}, 10),
        ({30: (2, "5"), 2: (1, "0")}, 2),
        ({30: (20, "5"), 20: (1, "5"), 1: (0, "7")}, None),
        ({30: (1, "5"), 1: (0, "5")}, None),
        ({30: (20, "5")}, None),
        ({}, None),
    ],
)
def test_the_nearest_ancestor_on_another_terminal_owns_this_one(
    processes: dict[int, tuple[int, str]], keeper: int | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The first process of all owns none, and one that can't be inspected says nothing."""

    def looked_up(pid: int) -> tuple[int, str]:
        if pid not in processes:
            raise FileNotFoundError(pid)
        return processes[pid]

    monkeypatch.setattr(disconnection, "_parent_and_terminal", looked_up)
    assert disconnection.keeper_of(30) == keeper


@ON_LINUX
def test_our_copy_of_the_other_end_is_closed_and_the_end_of_its_owner_is_a_hang_up(
    hang_ups: threading.Event, monkeypatch: pytest.MonkeyPatch
) -> None:
    owner = subprocess.Popen(["cat"], stdin=subprocess.PIPE)
    _ours, terminal = os.openpty()
    monkeypatch.setattr(disconnection, "_own_terminal", lambda: os.ttyname(terminal))
    monkeypatch.setattr(disconnection, "keeper_of", {os.getpid(): owner.pid}.get)
    disconnection.watch_for_hang_up()
    assert is_hung_up(terminal)
    assert not hang_ups.is_set()

    owner.communicate()

    assert until(hang_ups.is_set)
    os.close(terminal)


@ON_LINUX
def test_an_owner_that_has_ended_just_now_is_a_hang_up(hang_ups: threading.Event) -> None:
    owner = subprocess.Popen(["true"])
    owner.wait()
    disconnection._end_with(owner.pid)

    assert until(hang_ups.is_set)


@ON_LINUX
def test_where_hang_ups_are_still_ignored_the_end_of_the_owner_terminates() -> None:
    owner = subprocess.Popen(["true"])
    owner.wait()
    terminated = threading.Event()
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        with TakenSignals({signal.SIGTERM: lambda *_: terminated.set()}):
            disconnection._end_with(owner.pid)
            assert until(terminated.is_set)
    finally:
        signal.signal(signal.SIGHUP, before)


@ON_LINUX
@pytest.mark.parametrize(("terminal", "keeper"), [(None, 7), ("/dev/pts/of-no-one", 7), ("", None)])
def test_without_another_end_or_its_owner_nothing_is_watched(
    terminal: str | None, keeper: int | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    ours, theirs = os.openpty()
    name = os.ttyname(theirs) if terminal == "" else terminal
    monkeypatch.setattr(disconnection, "_own_terminal", lambda: name)
    monkeypatch.setattr(disconnection, "keeper_of", lambda _pid: keeper)
    monkeypatch.setattr(disconnection, "_end_with", pytest.fail)
    disconnection.watch_for_hang_up()
    assert is_hung_up(theirs) == (terminal == "")
    os.close(theirs)
    if terminal != "":
        os.close(ours)
