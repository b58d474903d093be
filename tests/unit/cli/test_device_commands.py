"""``donnie devices`` and ``donnie stop`` with invented ports; the meant robot; its form in settings."""

from __future__ import annotations

import io
from argparse import Namespace
from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest

from devices.board_reset import GpioReset
from devices.port_exchange import DeviceKind, HaltOutcome, IdentifiedDevice
from devices.ports.robot import Bearing
from devices.serial_ports import FoundPort, PortFault, PortProblem
from donnie_tui.cli.devices import list_devices, stop
from donnie_tui.cli.options import Invocation, Order
from donnie_tui.cli.streams import Output
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.outlets.belt import belt_settings, refuse_shared_port
from donnie_tui.robot.connection import robot_config
from donnie_tui.robot.search import find_port, robot_options
from donnie_tui.settings.settings import BadOption, Settings, resolve

ROBOT = FoundPort("/dev/ttyACM0", "/dev/serial/by-id/robot", is_board=True)
BELT = FoundPort("/dev/ttyACM1", "/dev/serial/by-id/belt", is_board=True)
OTHER = FoundPort("/dev/ttyS0", "/dev/ttyS0", is_board=False)


def order(
    port: object, settings: Settings | None = None, language: str = "en", *, waits: bool = False
) -> tuple[Order, io.StringIO]:
    out = io.StringIO()
    invocation = Invocation("devices", {}, Namespace(port=port, wait=waits))
    made = Order(invocation, settings or Settings(), Words(language), Output(out, io.StringIO()), {})
    return made, out


def answers(port: str, **_how: object) -> IdentifiedDevice:
    match port:
        case ROBOT.stable:
            return IdentifiedDevice(DeviceKind.ROBOT, 8000)
        case BELT.stable:
            return IdentifiedDevice(DeviceKind.BELT)
        case "low":
            return IdentifiedDevice(DeviceKind.ROBOT, 7000)
        case "full":
            return IdentifiedDevice(DeviceKind.ROBOT, 7100)
        case "sinking":
            return IdentifiedDevice(DeviceKind.ROBOT, 7099)
        case "new":
            return IdentifiedDevice(DeviceKind.ROBOT, None)
        case "mute":
            return IdentifiedDevice(DeviceKind.NOTHING)
        case "forbidden":
            raise PortProblem(port, PortFault.FORBIDDEN, "Permission denied")
        case "driving":
            return IdentifiedDevice(DeviceKind.ROBOT, 8000, is_driving=True)
        case "busy":
            raise PortProblem(port, PortFault.BUSY, "busy")
        case _:
            raise PortProblem(port, PortFault.UNUSABLE, "Inappropriate ioctl for device")


# --- donnie devices


def test_boards_are_asked_and_other_ports_are_only_named() -> None:
    made, out = order([])

    assert list_devices(made, lambda: (ROBOT, BELT, OTHER), answers) == 0
    assert out.getvalue().splitlines() == [
        "I ask 2 ports. That restarts a board on USB.",
        "/dev/serial/by-id/robot: robot, original firmware, battery 8.0 volts.",
        "Drive it: donnie --robot serial:/dev/serial/by-id/robot",
        "/dev/serial/by-id/belt: belt.",
        "Feel it: donnie --belt /dev/serial/by-id/belt",
        "/dev/ttyS0: not an Arduino, so I did not ask.",
    ]


@pytest.mark.parametrize(
    ("port", "lines"),
    [
        (
            "low",
            ["low: robot, original firmware, battery low, 7.0 volts.", "Drive it: donnie --robot serial:low"],
        ),
        (
            "full",
            ["full: robot, original firmware, battery 7.1 volts.", "Drive it: donnie --robot serial:full"],
        ),
        (
            "sinking",
            [
                "sinking: robot, original firmware, battery low, 7.1 volts.",
                "Drive it: donnie --robot serial:sinking",
            ],
        ),
        ("new", ["new: robot, original firmware, battery unknown.", "Drive it: donnie --robot serial:new"]),
        ("mute", ["mute: nothing answers."]),
    ],
)
def test_each_answer_of_a_board_has_a_sentence(port: str, lines: list[str]) -> None:
    made, out = order([port])

    assert list_devices(made, tuple, answers) == 0
    assert out.getvalue().splitlines()[1:] == lines


@pytest.mark.parametrize(
    ("port", "lines"),
    [
        (
            "forbidden",
            [
                "I may not use forbidden.",
                "Join the group dialout: sudo usermod -aG dialout $USER. Then log in again.",
            ],
        ),
        ("busy", ["Another program uses busy.", "Perhaps another Donnie uses it. Leave that one first."]),
        ("file", ["I can't use file: it is not a serial port."]),
    ],
)
def test_an_unusable_port_is_reported_with_its_remedy(port: str, lines: list[str]) -> None:
    made, out = order([port])

    assert list_devices(made, tuple, answers) == 2
    assert out.getvalue().splitlines()[1:] == lines


class Person(io.StringIO):
    """A terminal at which a person types."""

    def isatty(self) -> bool:
        return True


DRIVES = "driving: robot, original firmware. It moves."


def test_a_robot_that_drives_is_reported_with_the_command_that_stops_it() -> None:
    made, out = order(["driving"])

    assert list_devices(made, tuple, answers) == 1
    assert out.getvalue().splitlines()[1:] == [DRIVES, "Stop it: donnie stop driving"]


@pytest.mark.parametrize(
    ("typed", "code", "last"),
    [
        ("yes\n", 0, "The robot has stopped. Port driving."),
        ("s\n", 0, "The robot has stopped. Port driving."),
        ("no\n", 1, "Stop it: donnie stop driving"),
        ("", 1, "Stop it: donnie stop driving"),
    ],
)
def test_a_person_is_offered_to_stop_a_robot_that_drives(
    typed: str, code: int, last: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.stdin", Person(typed))
    made, out = order(["driving"])

    assert list_devices(made, tuple, answers, lambda *_, **__: HaltOutcome.STANDS) == code
    assert out.getvalue().splitlines()[1:] == [
        DRIVES,
        "Shall I stop the robot at driving? yes or no",
        last,
    ]


def test_one_robot_that_does_not_stop_makes_the_list_a_failure(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.stdin", Person("yes\nyes\n"))
    outcomes = iter([HaltOutcome.DRIVES, HaltOutcome.STANDS])
    made, out = order(["driving", "mute", "driving"])

    assert list_devices(made, tuple, answers, lambda *_, **__: next(outcomes)) == 1
    assert out.getvalue().splitlines()[-3:] == [
        "I said stop, but the robot at driving still moves. Switch it off.",
        "Shall I stop the robot at driving? yes or no",
        "The robot has stopped. Port driving.",
    ]


def test_a_port_that_can_not_be_used_counts_more_than_a_robot_that_drives() -> None:
    made, _ = order(["driving", "busy"])

    assert list_devices(made, tuple, answers) == 2


@pytest.mark.parametrize("factor", ["", "3"])
def test_a_slow_machine_has_more_time_to_ask_and_to_stop(
    factor: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DONNIE_ROBOT_TIMEOUTS", factor)
    factors: list[object] = []

    def asked(_port: str, **how: object) -> IdentifiedDevice:
        factors.append(how["factor"])
        return IdentifiedDevice(DeviceKind.NOTHING)

    def halted(_port: str, **how: object) -> HaltOutcome:
        factors.append(how["factor"])
        return HaltOutcome.STANDS

    list_devices(order(["a"])[0], tuple, asked)
    stop(order("a")[0], halted)
    assert factors == [float(factor or 1)] * 2


def test_an_unusable_plugged_port_does_not_fail_the_list() -> None:
    made, _ = order([])

    assert list_devices(made, lambda: (FoundPort("x", "busy", is_board=True),), answers) == 0


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        ("en", "No devices are plugged in. The simulator needs none."),
        ("pt", "Não há dispositivos conectados. O simulador funciona sem eles."),
        ("es", "No hay dispositivos conectados. El simulador no los necesita."),
    ],
)
def test_no_devices_is_a_sentence(language: str, sentence: str) -> None:
    made, out = order([], language=language)

    assert list_devices(made, tuple, answers) == 0
    assert out.getvalue() == f"{sentence}\n"


# --- donnie stop


@pytest.mark.parametrize(
    ("halted", "code", "sentence"),
    [
        (HaltOutcome.STANDS, 0, "The robot has stopped. Port here."),
        (
            HaltOutcome.UNCONFIRMED,
            1,
            "I said stop, but nothing answers at here. If the robot moves, switch it off.",
        ),
        (HaltOutcome.DRIVES, 1, "I said stop, but the robot at here still moves. Switch it off."),
        (
            HaltOutcome.IN_USE,
            1,
            "I said stop, but another program uses here and may go on. Stop it there.",
        ),
    ],
)
def test_only_a_robot_that_is_known_to_stand_is_a_success(
    halted: HaltOutcome, code: int, sentence: str
) -> None:
    made, out = order("here")

    assert stop(made, lambda _, **__: halted) == code
    assert out.getvalue() == f"{sentence}\n"


def test_a_stop_uses_the_restart_pin_where_the_robot_has_one(monkeypatch: pytest.MonkeyPatch) -> None:
    pulled: list[int] = []
    monkeypatch.setattr(GpioReset, "pull", lambda self, *_: not pulled.append(self.pin))

    def halted(_port: str, by_force: Callable[[], bool], **_how: object) -> HaltOutcome:
        return HaltOutcome.STANDS if by_force() else HaltOutcome.UNCONFIRMED

    outcomes = [
        stop(order("here", Settings(reset_line=line))[0], halted) for line in ("gpio:17", "dtr", "none")
    ]
    assert (outcomes, pulled) == ([0, 1, 1], [17])


def test_without_a_port_the_robot_of_the_settings_is_stopped() -> None:
    made, out = order(None, Settings(robot="serial:/dev/mine"))

    assert stop(made, lambda _, **__: HaltOutcome.STANDS) == 0
    assert out.getvalue() == "The robot has stopped. Port /dev/mine.\n"


def test_a_stop_without_a_board_does_not_suggest_the_simulator(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("donnie_tui.cli.devices.find_port", partial(find_port, found=lambda: ()))
    made, _ = order(None)

    with pytest.raises(Unusable) as said:
        stop(made, lambda _, **__: HaltOutcome.STANDS)
    assert said.value.sentence == "I can't find a robot. Is it plugged in? If a robot moves, switch it off."


def test_a_stop_for_services_waits_for_any_board_and_says_so_once(monkeypatch: pytest.MonkeyPatch) -> None:
    plugged = iter([(), (), (), (ROBOT,)])
    monkeypatch.setattr("donnie_tui.cli.devices.find_port", partial(find_port, found=lambda: next(plugged)))
    made, out = order(None, waits=True)
    paused: list[float] = []

    assert stop(made, lambda _, **__: HaltOutcome.STANDS, paused.append) == 0
    assert out.getvalue().splitlines() == [
        "I will wait for the robot, a minute at most.",
        f"The robot has stopped. Port {ROBOT.stable}.",
    ]
    assert len(paused) == 3


def test_a_stop_for_services_waits_no_longer_than_a_minute(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("donnie_tui.cli.devices.find_port", partial(find_port, found=lambda: ()))
    now = iter([100.0, 130.0, 159.0, 160.0])
    monkeypatch.setattr("donnie_tui.cli.devices.monotonic", lambda: next(now))
    made, _ = order(None, waits=True)
    paused: list[float] = []

    with pytest.raises(Unusable):
        stop(made, lambda _, **__: HaltOutcome.STANDS, paused.append)
    assert len(paused) == 2


def test_a_stop_for_services_waits_for_the_port_and_says_so_once() -> None:
    made, out = order("here", waits=True)
    answers = iter([PortFault.ABSENT, PortFault.ABSENT, HaltOutcome.STANDS])

    def halted(port: str, **_how: object) -> HaltOutcome:
        answer = next(answers)
        if isinstance(answer, PortFault):
            raise PortProblem(port, answer, "gone")
        return answer

    assert stop(made, halted, lambda _: None) == 0
    assert out.getvalue().splitlines() == [
        "I will wait for here, a minute at most.",
        "The robot has stopped. Port here.",
    ]


def test_a_robot_at_an_unusable_port_can_not_be_stopped() -> None:
    made, _ = order("gone")

    with pytest.raises(Unusable, match="I can't use gone"):
        stop(made, answers)  # type: ignore[arg-type] # it raises before it answers


# --- which robot


def test_the_one_board_that_is_no_belt_is_the_robot() -> None:
    settings = Settings(robot="serial", belt=BELT.device)

    assert find_port(settings, Words(), lambda: (ROBOT, BELT, OTHER)) == ROBOT.stable


def test_no_board_and_several_boards_are_reported() -> None:
    with pytest.raises(Unusable, match="I can't find a robot"):
        find_port(Settings(robot="serial"), Words(), lambda: (OTHER,))
    with pytest.raises(Unusable, match=r"several: .*robot, .*belt\. Choose one\. donnie devices says which"):
        find_port(Settings(robot="serial"), Words(), lambda: (ROBOT, BELT))


def test_offered_robots_are_the_simulator_the_boards_and_the_port_of_the_settings() -> None:
    offered = robot_options(Settings(robot="serial:/dev/rfcomm0"), Words(), lambda: (ROBOT, OTHER))

    assert [each.robot for each in offered] == [
        "sim",
        "serial:/dev/serial/by-id/robot",
        "serial:/dev/rfcomm0",
        "double",
    ]


def test_only_the_board_that_was_chosen_before_is_called_a_robot() -> None:
    def offered(settings: Settings, language: str = "en") -> list[str]:
        made = robot_options(settings, Words(language), lambda: (ROBOT, BELT, OTHER))
        return [each.sentence for each in made if each.robot.startswith("serial")]

    robot, belt = ROBOT.stable, BELT.stable
    assert offered(Settings()) == [f"robot or belt at {robot}", f"robot or belt at {belt}"]
    assert offered(Settings(robot=f"serial:{robot}")) == [f"robot at {robot}", f"robot or belt at {belt}"]
    assert offered(Settings(belt=BELT.device)) == [f"robot at {robot}"]
    assert offered(Settings(), "pt")[0] == f"robô ou cinto em {robot}"
    assert offered(Settings(), "es")[0] == f"robot o cinturón en {robot}"


def test_robot_and_belt_at_one_device_are_refused_under_any_names(tmp_path: Path) -> None:
    link = tmp_path / "robot"
    link.symlink_to("/dev/null")

    with pytest.raises(Unusable, match="can't both be at"):
        refuse_shared_port(Settings(robot=f"serial:{link}", belt="/dev/null"), Words())
    refuse_shared_port(Settings(robot=f"serial:{link}", belt="/dev/zero"), Words())
    refuse_shared_port(Settings(robot="sim", belt="/dev/null"), Words())


# --- settings


def test_settings_describe_a_robot_and_a_belt() -> None:
    settings, notices = resolve(
        {"belt": "/dev/belt", "robot": "SERIAL:/dev/Robot"},
        {"DONNIE_WHEEL_RADIUS": "0,0205"},
        {
            "axle_length": 0.07,
            "belt_steps": "4 8 16",
            "belt_columns": "front 2 3 4, back 0",
            "sonars": "front-right front front-left back-right back back-left",
            "bumpers": "front front front back back back",
        },
    )

    assert notices == ()
    assert (settings.belt, settings.robot) == ("/dev/belt", "serial:/dev/Robot")
    config = robot_config(settings)
    assert (config.wheel_radius, config.axle_length) == (0.0205, 0.07)
    assert config.sonars[3] is Bearing.BACK_RIGHT
    assert (config.front_bumpers, config.back_bumpers) == ({0, 1, 2}, {3, 4, 5})
    belt = belt_settings(settings)
    assert [belt.level(steps) for steps in (4, 8, 16, 17)] == [3, 2, 1, 0]
    assert belt.columns[Bearing.FRONT] == (2, 3, 4)
    assert belt.columns[Bearing.FRONT_LEFT] == (2,)


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("robot", "serial:"),
        ("robot", "sim:x"),
        ("robot", "robot"),
        ("robot", "player:host"),
        ("robot", "player://"),
        ("robot", "player://host:0"),
        ("robot", "player://host:6665/-1"),
        ("robot", "player://host:6665/x"),
        ("robot", "player://host:6665/65536"),
        ("robot", "player://host/1/2"),
        ("robot", "player://ho st:6665"),
        ("belt", ""),
        ("belt_steps", "5 10"),
        ("belt_steps", "10 5 20"),
        ("belt_steps", "a b c"),
        ("belt_columns", "front 7"),
        ("belt_columns", "up 3"),
        ("wheel_radius", "0"),
        ("axle_length", "nan"),
        ("sonars", "front front"),
        ("sonars", "front front front front front up"),
        ("bumpers", "front back"),
        ("reset_line", "gpio"),
        ("reset_line", "gpio:40"),
        ("reset_line", "dtr:1"),
        ("reset_line", "rts"),
        ("profile", "2017"),
        ("motors", "normal"),
        ("encoders", "normal backward"),
        ("head", "up"),
    ],
)
def test_a_text_that_can_not_be_understood_is_an_error_or_a_notice(key: str, value: str) -> None:
    with pytest.raises(BadOption):
        resolve({key: value}, {}, {})

    settings, notices = resolve({}, {}, {key: value})
    assert settings == Settings()
    (notice,) = notices
    said = Words()(notice.code, **notice.values)
    is_one_of_many = key in ("belt_steps", "belt_columns", "sonars", "bumpers", "motors", "encoders")
    assert said.startswith(f"The setting {key} can't be ")
    assert ("For example: " if is_one_of_many else "It takes ") in said


@pytest.mark.parametrize(
    ("given", "encoders", "motors", "is_mirrored", "is_found_out"),
    [
        ({}, (1, 1), (1, 1), False, True),
        ({"profile": "2016"}, (1, 1), (1, 1), False, False),
        ({"profile": "2018"}, (-1, -1), (1, 1), True, False),
        ({"profile": "2018", "encoders": "normal reversed", "head": "left"}, (1, -1), (1, 1), False, False),
        ({"motors": "reversed normal"}, (1, 1), (-1, 1), False, True),
        ({"encoders": "reversed reversed", "head": "right"}, (-1, -1), (1, 1), True, False),
    ],
)
def test_a_profile_and_settings_say_how_a_robot_is_wired(
    given: dict[str, str],
    encoders: tuple[int, int],
    motors: tuple[int, int],
    is_mirrored: bool,
    is_found_out: bool,
) -> None:
    config = robot_config(resolve(given, {}, {})[0])

    assert (config.wiring.encoders, config.wiring.motors) == (encoders, motors)
    assert (config.head_is_mirrored, config.finds_profile) == (is_mirrored, is_found_out)


@pytest.mark.parametrize(
    ("typed", "robot"),
    [
        ("player://localhost", "player://localhost:6665"),
        ("PLAYER://192.168.1.20:7000/", "player://192.168.1.20:7000"),
        ("player://[::1]:6666", "player://[::1]:6666"),
        ("player://[::1]", "player://[::1]:6665"),
        ("player://localhost/2", "player://localhost:6665/2"),
        ("player://localhost:7000/0", "player://localhost:7000"),
        ("player://[::1]:6666/03/", "player://[::1]:6666/3"),
    ],
)
def test_a_server_is_an_address_with_a_port(typed: str, robot: str) -> None:
    settings, _ = resolve({"robot": typed}, {}, {})

    assert settings.robot == robot
