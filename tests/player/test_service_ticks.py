"""What becomes of robots that clients drive, without a server: each tick is a tenth of a second."""

from __future__ import annotations

import socket
from collections.abc import Iterator
from contextlib import closing
from itertools import pairwise
from pathlib import Path

import pytest

from devices.ports.drive import Velocity
from devices.ports.robot import Grip
from donnie_tui.bootstrap import assemble
from donnie_tui.core.events import (
    Announced,
    BeltShown,
    Driven,
    Event,
    GripperUsed,
    Outcome,
    Passing,
    RunEnded,
    RunStarted,
    Spoke,
)
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.player import service as module
from donnie_tui.player.service import CLIENTS, ClientService
from donnie_tui.settings.settings import ServedFile, Settings
from tests.free_ports import free_port
from tests.player.room import CONFIGURATION, HOST, write_room
from tests.timeouts import TIMEOUT


class Ticks:
    """The service of a session, whose ticks the test makes."""

    def __init__(
        self, folder: Path, patch: pytest.MonkeyPatch, text: str = CONFIGURATION, host: str = HOST
    ) -> None:
        made: list[ClientService] = []
        self.now = 100.0
        patch.setattr(module, "monotonic", lambda: self.now)
        patch.setattr(ClientService, "start", lambda service: made.append(service))
        patch.setattr(ClientService, "close", lambda _: None)
        file = str(write_room(folder, text))
        settings = Settings(world=file, speech="off", sound=False, served=ServedFile(file, host, 6665))
        self.donnie = assemble(settings, terminal=True)
        (self.service,) = made
        self.events: list[Event] = []
        self.donnie.session.hub.subscribe(lambda stamped: self.events.append(stamped.event))
        self.drive = self.service._loop.drives["alice"]

    def of(self, *kinds: type[Event]) -> list[Event]:
        """The events of these kinds since the last call; all threads have published theirs."""
        self.donnie.session.hub.wait_until_delivered(TIMEOUT)
        found = [each for each in self.events if isinstance(each, kinds)]
        self.events.clear()
        return found

    def step(self, count: int = 1) -> None:
        for _ in range(count):
            self.service.stations.step()

    def motions(self, count: int) -> list[list[str]]:
        """Those that are reported at each of so many ticks."""
        found = []
        for _ in range(count):
            self.step()
            found.append([each.motion for each in self.of(Driven) if isinstance(each, Driven)])
        return found

    def close(self) -> None:
        self.service.left("alice")
        self.service.left("bob")
        self.donnie.close()


@pytest.fixture
def ticks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Ticks]:
    with closing(Ticks(tmp_path, monkeypatch)) as made:
        yield made


def test_a_robot_that_clients_open_has_a_run_until_the_last_one_leaves(ticks: Ticks) -> None:
    assert ticks.service.opened("alice")
    run = ticks.donnie.session.run
    assert run is not None
    ticks.service.left("alice")
    assert run.wait(TIMEOUT)
    ticks.donnie.session.wait_for_stop()

    assert run.outcome is Outcome.COMPLETED
    started, ended = ticks.of(RunStarted, RunEnded)
    assert isinstance(started, RunStarted)
    assert isinstance(ended, RunEnded)
    assert (started.program, ended.outcome) == (CLIENTS, Outcome.COMPLETED)
    ticks.service.left("alice")
    ticks.service.left("carol")  # not a client
    assert ticks.service.opened("alice")


def test_a_stopped_run_has_no_completed_end(ticks: Ticks) -> None:
    ticks.service.opened("alice")
    run = ticks.donnie.session.run
    assert run is not None
    run.control.stop()
    assert run.wait(TIMEOUT)

    assert run.outcome is Outcome.STOPPED
    ticks.of()
    ticks.drive.drive(Velocity(0.1))
    ticks.step(30)
    assert ticks.of(Driven, Passing) == []
    assert ticks.drive.is_held


def test_no_robot_is_opened_while_a_program_runs_and_that_is_said(ticks: Ticks) -> None:
    run = ticks.donnie.session.start("WAIT 1000", "typed")
    for name in ("alice", "bob"):
        assert not ticks.service.opened(name)
    said = [each for each in ticks.of(Announced) if isinstance(each, Announced) and each.code == CLIENTS]
    assert said == [Announced(CLIENTS, Words()("player-busy"))] * 2  # the program says that it waits, too
    run.control.stop()
    assert run.wait(TIMEOUT)

    ticks.drive.is_held = True
    assert ticks.service.opened("bob")
    assert ticks.service.opened("alice")
    assert not ticks.drive.is_held
    assert not ticks.service.opened("alice")


def test_a_driven_robot_is_reported_at_once_and_then_once_a_second(ticks: Ticks) -> None:
    ticks.service.opened("alice")
    assert ticks.motions(3) == [[]] * 3
    ticks.drive.subscribe()
    ticks.drive.drive(Velocity(0.1))
    said = ticks.motions(25)
    begins = said.index(["forward"])
    assert begins <= 1
    assert [at - begins for at, each in enumerate(said) if each] == [0, 10, 20]
    assert {each for motions in said for each in motions} == {"forward"}

    # another motion is said when it is due, and so is that it stands
    ticks.drive.drive(Velocity(-0.1))
    later = ticks.motions(20)
    assert [each for each in later if each] == [["backward"], ["backward"]]
    ticks.drive.drive(Velocity())
    assert [each for each in ticks.motions(20) if each] == [["standing"]]
    ticks.drive.drive(Velocity(turn=45.0))
    assert [each for each in ticks.motions(5) if each] == [["left"]]


def test_a_paused_run_holds_its_robot(ticks: Ticks) -> None:
    ticks.service.opened("alice")
    run = ticks.donnie.session.run
    assert run is not None
    run.control.pause()
    ticks.step()
    assert ticks.drive.is_held
    run.control.resume()
    ticks.step()
    assert not ticks.drive.is_held


def test_a_moving_picture_has_twenty_poses_a_second_of_real_time(ticks: Ticks) -> None:
    ticks.service.opened("alice")
    ticks.step()
    assert len(ticks.of(Passing)) == 1, "its first place"
    ticks.step()
    assert ticks.of(Passing) == []
    ticks.drive.subscribe()
    ticks.drive.drive(Velocity(0.1))
    shown = []
    for ticks.now in (100.05, 100.06, 100.09, 100.101, 100.14, 100.16, 100.2, 100.22):
        ticks.step()
        shown.append(len(ticks.of(Passing)))
    assert sum(shown) in (3, 4)
    assert all(not (a and b) for a, b in pairwise(shown))


@pytest.mark.parametrize(
    ("letters", "levels"),
    [
        ([(11, "A")], {3: 3}),
        ([(11, "B"), (8, "C"), (14, "O")], {3: 2, 0: 1, 6: 1}),
        ([(22, "A"), (28, "B"), (7, "A"), (15, "A"), (0, "A")], {7: 3, 13: 2}),
        ([(11, "A"), (11, "P")], None),
        ([(11, "P")], None),
    ],
)
def test_a_frame_of_the_belt_is_one_event_at_the_next_tick(
    ticks: Ticks, letters: list[tuple[int, str]], levels: dict[int, int] | None
) -> None:
    for motor, letter in letters:
        ticks.service.vibrated("alice", motor, letter)
    assert ticks.of(BeltShown) == []
    ticks.step()
    shown = tuple((levels or {}).get(each, 0) for each in range(14))
    assert ticks.of(BeltShown) == ([] if levels is None else [BeltShown(shown)])
    ticks.step()
    assert ticks.of(BeltShown) == []


def test_a_belt_keeps_its_other_motors_until_its_robot_is_left(ticks: Ticks) -> None:
    service = ticks.service
    service.vibrated("alice", 11, "A")
    ticks.step()
    service.vibrated("alice", 12, "B")
    service.vibrated("", 13, "A")  # of no robot: the chosen one's events have it
    ticks.step()
    assert ticks.of(BeltShown) == [
        BeltShown((0, 0, 0, 3, *(0,) * 10)),
        BeltShown((0, 0, 0, 3, 2, *(0,) * 9)),
        BeltShown((*(0,) * 5, 3, *(0,) * 8)),
    ]
    service.vibrated("alice", 12, "B")
    ticks.step()
    assert ticks.of(BeltShown) == []
    service.left("alice")
    service.vibrated("alice", 12, "B")
    ticks.step()
    assert ticks.of(BeltShown) == [BeltShown((*(0,) * 4, 2, *(0,) * 9))]


def test_what_happens_to_a_robot_is_its_own_event(ticks: Ticks, monkeypatch: pytest.MonkeyPatch) -> None:
    published: list[str] = []
    monkeypatch.setattr(ticks.donnie.session, "publish_things", lambda: published.append("things"))
    gripped = GripperUsed(Grip.GRIPPED, "can", "", "")
    about_gripper = Announced("gripper", "I hold can.")
    for name, event in (("alice", Spoke("a")), ("", Spoke("b")), ("alice", gripped)):
        ticks.service.happened(name, event)
    ticks.service._complain("player-full")

    happened = [each for each in ticks.of(Spoke, GripperUsed, Announced) if each != about_gripper]
    assert happened == [Spoke("a"), Spoke("b"), gripped, Announced(CLIENTS, Words()("player-full"))]
    assert published == ["things"]


@pytest.mark.parametrize(("host", "is_open"), [("127.0.0.1", False), ("0.0.0.0", True)])
def test_the_notices_name_what_is_left_out_and_an_open_port(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, host: str, is_open: bool
) -> None:
    names = [f"sonar:{number}" for number in range(11)]
    more = " ".join(f'"7665:{each}"' for each in names)
    text = CONFIGURATION + f'driver ( name "stage" model "alice" provides [ {more} ] )'
    words = Words()
    with closing(Ticks(tmp_path, monkeypatch, text, host)) as made:
        assert made.service.notices == (
            words("player-left-out", names=", ".join(names[:10])),
            *([words("player-open-to-others")] if is_open else []),
            words("player-serving", host=host, ports="7665, 7666"),
        )


TWICE = CONFIGURATION.replace('"7665:ranger:1"', '"7665:ranger:0"')
NOTHING = CONFIGURATION.partition("provides")[0] + 'provides [ ] worldfile "room.world" )'


@pytest.mark.parametrize(
    ("text", "code", "values"),
    [(TWICE, "player-address-twice", "7665:ranger:0"), (NOTHING, "player-nothing", "")],
    ids=["twice", "nothing"],
)
def test_a_configuration_that_serves_nothing_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str, code: str, values: str
) -> None:
    with pytest.raises(Unusable) as caught:
        Ticks(tmp_path, monkeypatch, text)

    file = str(tmp_path / "room.cfg")
    wanted = Words()(code, **({"what": values} if values else {"path": file}))
    assert caught.value.sentence == wanted


def test_a_port_that_is_taken_prevents_the_start(tmp_path: Path) -> None:
    port = free_port()
    file = str(write_room(tmp_path, CONFIGURATION.replace("7665", str(port)).replace("7666", str(port + 1))))
    settings = Settings(world=file, speech="off", sound=False, served=ServedFile(file, HOST, 6665))
    with socket.create_server((HOST, port)), pytest.raises(Unusable) as caught:
        assemble(settings, terminal=True)

    assert caught.value.sentence == f"Port {port} can't be used: another program uses it."
