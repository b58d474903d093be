"""A search for a robot can be cancelled before it begins and while it runs."""

from __future__ import annotations

import socket
from pathlib import Path

import pytest

from devices.ports.robot import RobotProblem
from devices.serial_ports import FoundPort, PortFault, PortProblem, allow_only
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.robot.search import (
    RobotOption,
    Search,
    find_port,
    robot_options,
    running_server,
    sentences_of,
)
from donnie_tui.settings.settings import Settings


class Robot:
    """Records its calls; ``meanwhile`` runs while it connects."""

    def __init__(self, search: Search | None = None) -> None:
        self.calls: list[str] = []
        self._search = search

    def connect(self) -> None:
        self.calls.append("connect")
        if self._search is not None:
            assert self._search.give_up() is True

    def give_up(self) -> None:
        self.calls.append("give up")


def test_without_a_search_there_is_nothing_to_cancel() -> None:
    search, robot = Search(), Robot()
    assert search.give_up() is False

    search.connect(robot)
    search.end()
    assert search.give_up() is False
    assert robot.calls == ["connect"]


def test_a_running_search_is_cancelled_at_once() -> None:
    search = Search()
    robot = Robot(search)

    search.connect(robot)
    assert robot.calls == ["connect", "give up"]


@pytest.mark.parametrize("is_expected_later", [False, True])
def test_a_search_that_is_about_to_begin_ends_as_it_begins(is_expected_later: bool) -> None:
    search, robot = Search(is_pending=not is_expected_later), Robot()
    if is_expected_later:
        search.expect()
    assert search.give_up() is True

    search.connect(robot)
    assert robot.calls == ["give up", "connect"]


def test_a_cancelled_search_does_not_cancel_the_next_one() -> None:
    search, robot = Search(is_pending=True), Robot()
    search.give_up()
    search.end()

    search.connect(robot)
    assert robot.calls == ["connect"]


# --- what can be chosen, and what is said


def board(device: str, stable: str, *, is_board: bool = True) -> FoundPort:
    return FoundPort(device=device, stable=stable, is_board=is_board)


def test_the_robots_to_choose_are_named_with_their_ports(tmp_path: Path) -> None:
    (tmp_path / "one").symlink_to("/dev/null")
    one, zero = board("/dev/null", str(tmp_path / "one")), board("/dev/zero", "zero")
    phone = board("/dev/phone", "phone", is_board=False)
    words = Words()
    simulator, double = words("connect-option-simulator"), words("connect-option-double")

    def offered(found: list[FoundPort], **settings: str) -> list[tuple[str, str]]:
        made = robot_options(Settings(**settings), words, lambda: tuple(found))
        assert (made[0], made[-1]) == (RobotOption("sim", simulator), RobotOption("double", double))
        return [(each.robot, each.sentence) for each in made[1:-1]]

    assert offered([]) == []
    assert offered([phone]) == []
    assert offered([zero, phone, zero]) == [("serial:zero", words("connect-option-port", port="zero"))]
    assert offered([zero], robot="player://host:1") == [
        ("serial:zero", words("connect-option-port", port="zero")),
        ("player://host:1", words("connect-option-port", port="player://host:1")),
    ]
    names = {str(tmp_path / "one"): "connect-option-port", "zero": "connect-option-board"}
    both = [(f"serial:{port}", words(code, port=port)) for port, code in names.items()]
    assert offered([one, zero], robot="serial:/dev/null") == both  # the same by another name
    assert offered([one, zero], robot="serial:/dev/full") == [
        (each, words("connect-option-board", port=each.partition(":")[2])) for each, _ in both
    ] + [("serial:/dev/full", words("connect-option-port", port="/dev/full"))]
    assert offered([one, zero], belt=str(tmp_path / "one")) == [
        ("serial:zero", words("connect-option-port", port="zero"))
    ]


def test_a_port_that_is_named_is_not_looked_for() -> None:
    def never() -> tuple[FoundPort, ...]:
        raise AssertionError

    assert find_port(Settings(robot="serial:/dev/a:b"), Words(), never) == "/dev/a:b"


@pytest.mark.parametrize("robot", ["serial", "sim", "double"])
def test_the_one_board_is_the_robot_and_without_one_a_remedy_is_said(robot: str) -> None:
    words = Words()
    assert find_port(Settings(robot=robot), words, lambda: (board("/dev/a", "stable"),)) == "stable"
    with pytest.raises(Unusable) as caught:
        find_port(Settings(robot=robot), words, lambda: (), remedy="remedy-calibrate")
    assert caught.value.sentence == f"{words('problem-no-board')} {words('remedy-calibrate')}"
    with pytest.raises(Unusable) as caught:
        find_port(Settings(robot=robot), words, lambda: (board("/dev/a", "b"), board("/dev/c", "d")))
    several = words("problem-many-boards", ports="b, d")
    assert caught.value.sentence == f"{several} {words('remedy-many-boards')}"


@pytest.mark.parametrize("group", ["robots", None])
def test_a_problem_is_said_with_its_remedy(monkeypatch: pytest.MonkeyPatch, group: str | None) -> None:
    asked: list[str] = []
    monkeypatch.setattr("devices.serial_ports.group_of", lambda port: asked.append(port) or group)
    words = Words()
    remedy = words("remedy-no-permission", group=group) if group else words("remedy-no-group")
    for problem in (
        PortProblem("/dev/x", PortFault.FORBIDDEN, "denied"), RobotProblem("no-permission", port="/dev/x"),
    ):  # fmt: skip
        assert sentences_of(problem, words) == (
            words("problem-no-permission", port="/dev/x", reason="denied"), remedy,
        )  # fmt: skip
    assert asked == ["/dev/x"] * 2
    assert sentences_of(RobotProblem("no-server", port="p", reason="r"), words) == (
        words("problem-no-server", port="p", reason="r"), words("remedy-no-server"),
    )  # fmt: skip
    assert sentences_of(PortProblem("/dev/x", PortFault.ABSENT, "gone"), words) == (
        words("problem-no-port", port="/dev/x", reason="gone"),
    )
    assert asked == ["/dev/x"] * 2


@pytest.mark.parametrize(
    ("said", "is_server"), [(b"Player v.3.1", True), (b"Player", False), (b"Prayer v.3", False), (b"", False)]
)
def test_a_server_of_this_machine_is_known_by_its_first_words(
    monkeypatch: pytest.MonkeyPatch, said: bytes, is_server: bool
) -> None:
    asked: list[object] = []
    here, there = socket.socketpair()
    there.sendall(said)
    there.shutdown(socket.SHUT_WR)
    monkeypatch.setattr(socket, "create_connection", lambda *given: asked.append(given) or here)

    assert running_server({}) == ("player://127.0.0.1:6665" if is_server else None)
    assert asked == [(("127.0.0.1", 6665), 1.0)]
    there.close()


@pytest.mark.parametrize(
    ("environment", "server"),
    [
        ({"DONNIE_IP": "robot"}, "player://robot:6665"),
        ({"DONNIE_IP": "robot", "DONNIE_PORT": "7000"}, "player://robot:7000"),
        ({"DONNIE_IP": "ro bot"}, None),
        ({"DONNIE_IP": "robot", "DONNIE_PORT": "x"}, None),
        ({"DONNIE_PORT": "7000"}, None),
    ],
)
def test_a_server_that_the_variables_name_is_not_asked(
    monkeypatch: pytest.MonkeyPatch, environment: dict[str, str], server: str | None
) -> None:
    def refuse(*_: object) -> None:
        raise ConnectionRefusedError

    monkeypatch.setattr(socket, "create_connection", refuse)
    assert running_server(environment) == server
    allow_only(["/dev/zero"])
    try:
        assert running_server(environment) == server
    finally:
        allow_only(None)
