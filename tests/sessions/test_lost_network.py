"""A lost network closes no connection. The kernel's retransmissions show the loss."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import Path
from threading import Event
from threading import enumerate as threads

import pytest

from donnie_tui.core.events import Announced, Moved, Stamped
from donnie_tui.core.session import RunOptions
from donnie_tui.process import disconnection
from donnie_tui.process.disconnection import attempts, ssh_connections_of
from tests.board_on_pty import PtyBoard
from tests.sessions.real_robot import assembled, until
from tests.timeouts import TIMEOUT

BY_SSH = {"SSH_CONNECTION": "10.77.0.2 42475 10.77.0.1 40223"}
HEAD = "  sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout inode\n"
ROW = "   {n}: {here} {there} 01 000001BC:00000000 01:0000006F 000000{count:02X}     0        0 18 2 0 20\n"
OURS, THEIRS = "01004D0A:9D1F", "02004D0A:A5EB"

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.byteorder != "little", reason="the rows are from a little-endian machine"),
]


def table(count: int, here: str = OURS, there: str = THEIRS) -> str:
    """A table with another hanging connection before that of the session."""
    other = ROW.format(n=0, here=here, there="0100007F:0016", count=9)
    return HEAD + other + ROW.format(n=1, here=here, there=there, count=count)


def test_attempts_are_those_of_the_connection_of_the_session() -> None:
    assert attempts(table(3).splitlines(), ssh_connections_of(BY_SSH)) == 3
    assert attempts(table(3, there="02004D0A:A5EC").splitlines(), ssh_connections_of(BY_SSH)) == 0


def test_an_address_of_version_4_is_found_in_the_table_of_version_6() -> None:
    mapped = "0000000000000000FFFF0000"
    rows = table(5, mapped + OURS, mapped + THEIRS).splitlines()

    assert attempts(rows, ssh_connections_of(BY_SSH)) == 5


def test_an_address_of_version_6_is_found() -> None:
    ends = ssh_connections_of({"SSH_CONNECTION": "fe80::2%eth0 42475 fe80::1 40223"})
    here, there = "000080FE000000000000000001000000:9D1F", "000080FE000000000000000002000000:A5EB"

    assert attempts(table(6, here, there).splitlines(), ends) == 6


@pytest.mark.parametrize(
    "said", ["", "UNKNOWN 65535 UNKNOWN 65535", "one two", "::1 x ::1 2", "1.2.3.4 1 ::1 2"]
)
def test_a_local_session_has_no_connection(said: str) -> None:
    assert ssh_connections_of({"SSH_CONNECTION": said}) == ()


class Looks:
    """Counts the looks at the network."""

    def __init__(self) -> None:
        self.count = 0

    def attempts(self, rows: Iterable[str], ends: tuple[tuple[str, str], ...]) -> int:
        self.count += 1
        return attempts(rows, ends)

    def wait_for_more(self) -> None:
        """Wait until what followed one more look is over, and another has begun."""
        enough = self.count + 3
        assert until(lambda: self.count >= enough)


def is_moved(stamped: Stamped) -> bool:
    return isinstance(stamped.event, Moved)


def test_a_robot_of_an_unreachable_learner_is_stopped_and_that_is_reported_once(
    tmp_path: Path, robot: PtyBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "tcp"
    file.write_text(table(0), encoding="ascii")
    looks = Looks()
    monkeypatch.setattr(disconnection, "TABLES", (file, tmp_path / "missing"))
    monkeypatch.setattr(disconnection, "LOOK", 0.01)
    monkeypatch.setattr(disconnection, "attempts", looks.attempts)
    for name in ("TMUX", "STY"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("SSH_CONNECTION", BY_SSH["SSH_CONNECTION"])
    donnie, heard = assembled(robot), list[Stamped]()
    donnie.session.hub.subscribe(heard.append)
    donnie.session.hub.subscribe(lambda stamped: looks.wait_for_more() if is_moved(stamped) else None)
    try:
        run = donnie.session.start("FW 100", "test.gd", RunOptions(hooked=False))
        assert until(lambda: robot.board.is_driving)
        file.write_text(table(9), encoding="ascii")

        assert until(lambda: not robot.board.is_driving)
        assert run.wait(TIMEOUT)
        looks.wait_for_more()
        donnie.session.hub.wait_until_delivered(TIMEOUT)
        said = Announced("link", "The network did not answer, so I stopped the robot.")
        assert [each.event for each in heard].count(said) == 1
    finally:
        donnie.close()


def test_a_session_in_tmux_continues_without_the_network(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "tcp").write_text(table(9), encoding="ascii")
    monkeypatch.setattr(disconnection, "TABLES", (tmp_path / "tcp",))
    monkeypatch.setattr(disconnection, "LOOK", 0.01)
    in_tmux, in_screen = {**BY_SSH, "TMUX": "/tmp/tmux-0/donnie,1,0"}, {**BY_SSH, "STY": "1234.tty"}
    lost = Event()
    watches = [disconnection.NetworkWatch(lost.set, each) for each in (in_tmux, in_screen, {})]

    assert "network" not in [each.name for each in threads()]
    watches.append(disconnection.NetworkWatch(lost.set, BY_SSH))
    assert lost.wait(TIMEOUT)
    for each in watches:
        each.close()
