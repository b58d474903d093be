"""The text of each setting, as it is written in files, variables and on the command line, and its limits."""

import os
from collections.abc import Callable

import pytest

from devices.ports.robot import Bearing
from donnie_tui.settings import parsing

FRONT, BACK, LEFT, RIGHT = Bearing.FRONT, Bearing.BACK, Bearing.FRONT_LEFT, Bearing.FRONT_RIGHT
LARGEST = 9223372036854775807

UNDERSTOOD = [
    (parsing.read_switch, {" On ": True, "yes": True, "true": True, "1": True}),
    (parsing.read_switch, {"OFF": False, "no": False, " false ": False, "0": False}),
    (parsing.read_text, {"x": "x", " ": " "}),
    (parsing.read_line, {"": "", "x": "x"}),
    (parsing.read_language, {" pt_BR.UTF-8 ": "pt", "en": "en"}),
    (parsing.read_folders, {os.pathsep.join(("/a", "", " ", "/b")): ("/a", "/b")}),
    (parsing.read_speed, {" Max ": None, "0.1": 0.1, "1000": 1000.0, " 2,5 ": 2.5}),
    (parsing.read_seed, {"0": 0, str(LARGEST): LARGEST}),
    (parsing.read_progress, {"0": "0", "3600": "3600", "007": "7"}),
    (parsing.read_free, {"dot": "dot", "f": "f", "Z": "Z"}),
    (
        parsing.read_speech,
        {
            " ON ": "tts",
            "Robot": "robot",
            "ssip": "ssip",
            "auto": "auto",
            "text": "text",
            "tts": "tts",
            "off": "off",
        },
    ),
    (parsing.read_sound, {"off": False, "on": True, " WAV:a b.wav ": "a b.wav", "wav:x": "x"}),
    (parsing.read_rate, {"79": 80, "80": 80, "450 ": 450, "451": 450, "99,6": 100, "120%": 120}),
    (parsing.read_percent, {"-1": 0, "0": 0, "100%": 100, "101": 100, "50.4": 50}),
    (parsing.read_cues, {"Step-Forward 0, bump 50%": {"step-forward": 0, "bump": 50}}),
    (
        parsing.read_robot,
        {
            " SIM ": "sim",
            "double": "double",
            "Serial": "serial",
            "SERIAL:/dev/tty": "serial:/dev/tty",
            "serial:socket://h:1": "serial:socket://h:1",
            "Player://host": "player://host:6665",
        },
    ),
    (
        parsing.read_server,
        {
            "h": "player://h:6665",
            "linux:1": "player://linux:1",
            "h:65535/": "player://h:65535",
            "h/0": "player://h:6665",
            "h:007/02": "player://h:7/2",
            "h/65535": "player://h:6665/65535",
            "a-b._c:2": "player://a-b._c:2",
            "[::1]": "player://[::1]:6665",
            "[::1]:80/1": "player://[::1]:80/1",
        },
    ),
    (
        parsing.read_port,
        {"/dev/ttyUSB0": "/dev/ttyUSB0", "socket://h:1": "socket://h:1", "RFC2217://h:1": "RFC2217://h:1"},
    ),
    (parsing.read_ports, {"": (), " a, ,socket://b:1 ": ("a", "socket://b:1")}),
    (parsing.read_steps, {"5 10 20": (5, 10, 20), "0,0,0": (0, 0, 0), "1 1000 1000": (1, 1000, 1000)}),
    (
        parsing.read_columns,
        {"Front 3, front-right 4 6,": {FRONT: (3,), RIGHT: (4, 6)}, "back 0": {BACK: (0,)}, "": {}},
    ),
    (parsing.read_metres, {"0.001": 0.001, "1": 1.0, " 0,25 ": 0.25}),
    (
        parsing.read_sonars,
        {"Front front-left NONE back back none": (FRONT, LEFT, None, BACK, BACK, None)},
    ),
    (parsing.read_bumpers, {"Front front back back back front": (True, True, False, False, False, True)}),
    (parsing.read_view, {"20": 20.0, "150": 150.0, " 53,5 ": 53.5}),
    (
        parsing.read_colours,
        {
            "red 0-179 0-0 255-255": {"red": (0, 179, 0, 0, 255, 255)},
            "VERDE 5-5 1-2 3-3,blue 0-0 0-255 0-0": {
                "green": (5, 5, 1, 2, 3, 3),
                "blue": (0, 0, 0, 255, 0, 0),
            },
        },
    ),
    (parsing.read_wheels, {"normal REVERSED": (1, -1), "reversed normal": (-1, 1)}),
    (
        parsing.read_reset_line,
        {" Auto ": "auto", "dtr": "dtr", "NONE": "none", "gpio:02": "gpio:2", "gpio:27": "gpio:27"},
    ),
]

REFUSED = [
    (parsing.read_switch, ("", "maybe")),
    (parsing.read_text, ("", "a\0")),
    (parsing.read_line, ("a\0",)),
    (parsing.read_language, ("xx", "")),
    (parsing.read_folders, (os.pathsep, "")),
    (parsing.read_speed, ("0.09", "1000.1", "nan", "")),
    (parsing.read_seed, ("-1", str(LARGEST + 1))),
    (parsing.read_progress, ("-1", "3601")),
    (parsing.read_free, ("ab", "5", "é", "")),
    (parsing.read_speech, ("loud",)),
    (parsing.read_sound, ("wav:", "wav:a\0", "x.wav", "wavx")),
    (parsing.read_percent, ("nan", "", "x", "5x", "%5")),
    (parsing.read_cues, ("", "a1 5", "-- 5", "bump", "bump 5,")),
    (
        parsing.read_robot,
        (
            "",
            "sim:1",
            "double:",
            "player:h",
            "ser",
            "serial:",
            "sim\0",
            "serial:\0",
            "serial:http://h",
            "http://h",
        ),
    ),
    (
        parsing.read_server,
        ("", "h:0", "h:65536", "h/65536", "h/-1", "h h", "hé", "::1", "[::1", "h:x", ":1", "h]:1"),
    ),
    (parsing.read_port, ("", "http://h", "a\0")),
    (parsing.read_steps, ("1 2", "2 1 3", "1 3 2", "-1 0 0", "1 2 1001", "1 2 3 4")),
    (parsing.read_columns, ("front 7", "front -1", "up 1", "front x")),
    (parsing.read_metres, ("0.0009", "1.01", "nan")),
    (parsing.read_sonars, ("front " * 5, "front " * 7, "front " * 5 + "up")),
    (parsing.read_bumpers, ("front " * 5, "back " * 7, "front " * 5 + "left")),
    (parsing.read_view, ("19.9", "150.1")),
    (
        parsing.read_colours,
        (
            "red 180-1 0-0 0-0",
            "red 1-180 0-0 0-0",
            "red 0-1 0-256 0-0",
            "red 0-1 0-0 0-256",
            "red 0-1 0-0 3-2",
            "red 0-1 3-2 0-0",
        ),
    ),
    (parsing.read_wheels, ("normal", "normal normal normal", "normal up", "up normal")),
    (
        parsing.read_reset_line,
        ("gpio:1", "gpio:28", "gpio:", "gpio:²", "gpio:+5", "gpio:٢٢", "gpio", "dtr:", "auto:1", "dtr:5", ""),
    ),
]


@pytest.mark.parametrize(("reader", "texts"), UNDERSTOOD, ids=lambda it: getattr(it, "__name__", ""))
def test_a_setting_is_understood_as_people_write_it(
    reader: Callable[[str], object], texts: dict[str, object]
) -> None:
    assert {text: reader(text) for text in texts} == texts


@pytest.mark.parametrize(("reader", "texts"), REFUSED, ids=lambda it: getattr(it, "__name__", ""))
def test_what_is_no_value_of_a_setting_is_refused(
    reader: Callable[[str], object], texts: tuple[str, ...]
) -> None:
    for text in texts:
        with pytest.raises(ValueError):
            pytest.fail(f"{text!r}: {reader(text)!r}")


def test_colours_are_written_as_they_are_read() -> None:
    text = "red 1-2 3-4 5-6, blue 7-8 9-10 11-12"
    assert parsing.colours_text(parsing.read_colours(text)) == text


@pytest.mark.parametrize(
    ("robot", "is_far"),
    [("sim", False), ("double", False), ("serial", True), ("serial:x", True), ("player://h:1", True)],
)
def test_a_real_robot_or_one_of_a_server_is_far(robot: str, is_far: bool) -> None:
    assert parsing.is_far(robot) is is_far


@pytest.mark.parametrize(
    ("host", "is_here"),
    [("localhost", True), ("127.0.0.2", True), ("::1", True), ("192.168.0.1", False), ("school", False)],
)
def test_only_this_machine_reaches_a_loopback_address(host: str, is_here: bool) -> None:
    assert parsing.is_loopback(host) is is_here


@pytest.mark.parametrize(
    ("server", "address", "socket"),
    [
        ("player://xbox:1", ("xbox", 1, 0), "socket://xbox:1"),
        ("player://h:1/2", ("h", 1, 2), "socket://h:1"),
        ("player://[::1]:80/3", ("::1", 80, 3), "socket://[::1]:80"),
    ],
)
def test_a_robot_of_a_server_has_an_address_and_an_index(server: str, address: object, socket: str) -> None:
    assert parsing.address_of(server) == address
    assert parsing.socket_of(server) == socket


@pytest.mark.parametrize(
    ("text", "value", "changed"),
    [
        ("", 2, "a = 2\n"),
        ("b = 1", True, "b = 1\na = true\n"),
        ("b = 1\n", False, "b = 1\na = false\n"),
        ("  a\t= 1 # old\nb = 1\n", 2.5, "a = 2.5\nb = 1\n"),
        ("[t]\na.b = 1\n", "x", 'a = "x"\n[t]\na.b = 1\n'),
        ("b = 1\n  [t]\n", "é\x7f", 'b = 1\na = "é\\u007f"\n  [t]\n'),
        ("aa = 1\n", 2, "aa = 1\na = 2\n"),
    ],
)
def test_a_setting_is_written_before_the_first_table_or_in_its_line(
    text: str, value: object, changed: str
) -> None:
    assert parsing.with_setting(text, "a", value) == changed  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("text", "line"),
    [("a = 1\nb = \n", "2"), ("a = 1\n\nb = [", "3"), ("a = " + "[" * 9000, "1")],
    ids=["line", "end", "deep"],
)
def test_a_damaged_file_is_reported_with_its_line(tmp_path, text: str, line: str) -> None:  # type: ignore[no-untyped-def]
    file = tmp_path / "settings.toml"
    file.write_text(text)
    (notice,) = parsing.read_file(str(file))[1]
    assert notice.values == {"line": line}


@pytest.mark.parametrize(("size", "codes"), [(100_000, []), (100_001, ["settings-file-too-large"])])
def test_a_file_of_a_hundred_thousand_bytes_is_read(tmp_path, size: int, codes: list[str]) -> None:  # type: ignore[no-untyped-def]
    file = tmp_path / "settings.toml"
    file.write_text("#" * size)
    notices = parsing.read_file(str(file))[1]
    assert [each.code for each in notices] == codes
    assert all(each.values == {"limit": "100 000"} for each in notices)
