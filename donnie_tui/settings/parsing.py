"""Parses the text of a setting; reads the settings files, and writes a line in them.

Each reader raises ``ValueError``. Volume and speaking rate out of range are clamped, not refused.

A damaged file never prevents a start: its mistakes are reported once, defaults apply, and the file is left as
it is. The readers check its values and not msgspec: they are texts as on the command line, and each wrong one
is reported by itself."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping
from typing import TypeAlias

from msgspec import Struct

from devices.ports.robot import NETWORK_SCHEMES, Bearing
from donnie_tui.process.confinement import make_folder, open_bytes
from donnie_tui.settings import OFF, ON, SPEECH
from donnie_tui.settings.folders import settings_file
from language.locales import language_of_locale, toml_in

Sound: TypeAlias = bool | str
"""On, off, or the WAV file into which a run's cues are written."""

SLOWEST, FASTEST = 0.1, 1000.0
LARGEST_SEED = 2**63 - 1
LONGEST_PROGRESS = 3600
"""Seconds between two signs of life of a long run."""

RATES, PERCENTS = (80, 450), (0, 100)
"""The least and the most: words a minute, and of pitch and loudness."""

_WAV = "wav:"


def read_switch(text: str) -> bool:
    """Reads on or off, in the ways in which files and variables write it."""
    folded = text.strip().lower()
    if folded not in ON + OFF:
        raise ValueError(text)
    return folded in ON


def one_of(words: tuple[str, ...]) -> Callable[[str], str]:
    """A reader of these words."""

    def read(text: str) -> str:
        folded = text.strip().lower()
        if folded not in words:
            raise ValueError(text)
        return folded

    return read


def read_text(text: str) -> str:
    """Reads any text that is not empty."""
    if not text or "\0" in text:
        raise ValueError(text)
    return text


def read_line(text: str) -> str:
    """Reads any text, also an empty one."""
    return read_text(text) if text else ""


def read_language(text: str) -> str:
    """Read a language: ``pt``, also as ``pt-BR`` or ``pt_BR.UTF-8``."""
    language = language_of_locale(text.strip())
    if language is None:
        raise ValueError(text)
    return language


def read_folders(text: str) -> tuple[str, ...]:
    """Read folders, separated as in the variable PATH."""
    folders = folders_of(read_text(text))
    if not folders:
        raise ValueError(text)
    return folders


def folders_of(text: str) -> tuple[str, ...]:
    """As ``read_folders``, of any text; an empty one has none."""
    given = (each for each in text.split(os.pathsep) if each.strip())
    return tuple(os.path.expanduser(each) for each in given)  # noqa: PTH111 -- pathlib's raises


# --- numbers


def read_speed(text: str) -> float | None:
    """Times the real robot's pace, or None for ``max``."""
    if text.strip().lower() == "max":
        return None
    speed = float(text.strip().replace(",", "."))
    if not SLOWEST <= speed <= FASTEST:  # false for nan, too
        raise ValueError(text)
    return speed


def read_seed(text: str) -> int:
    seed = int(text)
    if not 0 <= seed <= LARGEST_SEED:
        raise ValueError(text)
    return seed


def read_progress(text: str) -> str:
    if not 0 <= int(text) <= LONGEST_PROGRESS:
        raise ValueError(text)
    return str(int(text))


def read_free(text: str) -> str:
    """A letter of a braille alphabet, or ``dot``."""
    if text != "dot" and not (len(text) == 1 and text.isascii() and text.isalpha()):
        raise ValueError(text)
    return text


# --- voice and cues


def read_speech(text: str) -> str:
    """Reads which voice speaks; ``on`` is the built-in one."""
    return "tts" if text.strip().lower() == "on" else one_of(SPEECH)(text)


def read_sound(text: str) -> Sound:
    path = text.strip()[len(_WAV) :]
    if text.strip().lower().startswith(_WAV) and path and "\0" not in text:
        return path
    return read_switch(text)


def read_rate(text: str) -> int:
    """Read a rate of speech in words a minute."""
    return _clamped(text, *RATES)


def read_percent(text: str) -> int:
    return _clamped(text, *PERCENTS)


def read_cues(text: str) -> Mapping[str, int]:
    """The volumes of cues in percent, by name: ``step-forward 0, bump 50``."""
    volumes: dict[str, int] = {}
    for each in text.split(","):
        name, _, percent = each.strip().partition(" ")
        if not name.replace("-", "").isalpha():
            raise ValueError(text)
        volumes[name.lower()] = read_percent(percent)
    return volumes


def _clamped(text: str, lowest: int, highest: int) -> int:
    number = float(text.strip().rstrip("%").replace(",", "."))
    return round(min(max(number, lowest), highest))  # a ValueError for nan


Columns = Mapping[Bearing, tuple[int, ...]]
Sonars = tuple[Bearing | None, ...]
ColourRanges = Mapping[str, tuple[int, int, int, int, int, int]]
"""By the English word: the least and the most of hue, saturation and value."""

_BEARINGS = {each.name.lower().replace("_", "-"): each for each in Bearing}
_SENSES = {"normal": 1, "reversed": -1}
_SIDES = {"front": True, "back": False}
_COLUMNS = range(7)
_SONARS = _BUMPERS = 6
_NONE = "none"
_PINS = range(2, 28)
"""The Raspberry Pi's lines that a person can wire; 0 and 1 belong to its boards."""

SIMULATED, DOUBLE, SERIAL, PLAYER = "sim", "double", "serial", "player"
"""What ``--robot`` takes; ``serial`` alone finds the port by itself, ``serial:PORT`` names it, and
``player://HOST:PORT/INDEX`` is one of the robots of a server, the first one without ``/INDEX``."""
PLAYER_PORT = 6665

PORT_WANTED = "DEVICE, socket://HOST:PORT, rfc2217://HOST:PORT"
ROBOT_WANTED = (
    f"sim, serial, serial:{PORT_WANTED.replace(', ', ', serial:')}, double, player://HOST:PORT/INDEX"
)
STEPS_WANTED = "5 10 20"
COLUMNS_WANTED = "front 3, front-right 4, back 0 6"
METRES_WANTED = "0.001-1"
SONARS_WANTED = "front-right front front-left back-left back back-right"
WHEELS_WANTED = "normal reversed"
HEADS = ("left", "right")
RESET_WANTED = "auto, dtr, gpio:22, none"
CAMERA_WANTED = "NUMBER, /dev/videoN, FILE, FOLDER"
VIEWS = (20, 150)
"""Degrees that a camera's picture can be wide."""
COLOURS_WANTED = "red 121-11 32-255 87-255, green 56-99 169-255 17-255"
_HUES, _LEVELS = range(180), range(256)
BUMPERS_WANTED = "front front front back back back"


def read_robot(text: str) -> str:
    """Reads a robot: simulated, real, the simulated board of a real one, or a server's."""
    kind, colon, port = text.strip().partition(":")
    if kind.lower() == PLAYER and port.startswith("//"):
        return read_server(port.removeprefix("//"))
    if kind.lower() not in (SIMULATED, DOUBLE, SERIAL):
        raise ValueError(text)
    if colon and (kind.lower() != SERIAL or not read_port(port)):
        raise ValueError(text)
    return f"{kind.lower()}{colon}{port}"


def is_far(robot: str) -> bool:
    """Whether it is a real robot or a server, which must be searched for and may not answer."""
    return robot.startswith((SERIAL, PLAYER))


def is_loopback(host: str) -> bool:
    """Whether only this machine reaches that address."""
    from ipaddress import ip_address  # few starts need it

    try:
        return ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def address_of(server: str) -> tuple[str, int, int]:
    """Host, port and index of a robot ``player://HOST:PORT/INDEX``."""
    place, _, index = server.partition("://")[2].partition("/")
    host, _, port = place.rpartition(":")
    return host.strip("[]"), int(port), int(index or 0)


def socket_of(server: str) -> str:
    """The address of its port, as the devices of a session are named."""
    return "socket://" + server.partition("://")[2].partition("/")[0]


def read_server(text: str) -> str:
    """``HOST:PORT`` or ``HOST``, with or without ``/INDEX``, as the address of a robot."""
    place, _, index = text.rstrip("/").partition("/")
    host, colon, number = place.rpartition(":")
    if not colon or number.endswith("]"):  # of an address that has colons itself
        host, number = place, str(PLAYER_PORT)
    is_address = host.startswith("[") and host.endswith("]")
    is_plain = re.fullmatch(r"[\w.-]+", host, re.ASCII)
    port, robot = int(number), int(index or 0)
    if not (is_address or is_plain) or not 1 <= port <= 65535 or not 0 <= robot <= 65535:
        raise ValueError(text)
    return f"{PLAYER}://{host}:{port}" + (f"/{robot}" if robot else "")


def read_port(text: str) -> str:
    """A serial port: a device of this machine, or an address of the network."""
    scheme, is_address, _ = read_text(text).partition("://")
    if is_address and scheme.lower() not in NETWORK_SCHEMES:
        raise ValueError(text)
    return text


def read_ports(text: str) -> tuple[str, ...]:
    """Read ports, separated by commas; an empty text names none."""
    return tuple(read_port(each.strip()) for each in text.split(",") if each.strip())


def read_steps(text: str) -> tuple[int, int, int]:
    """Reads up to how many steps something is felt strongly, medium and weakly."""
    strong, medium, weak = (int(each) for each in text.replace(",", " ").split())
    if not 0 <= strong <= medium <= weak <= 1000:
        raise ValueError(text)
    return strong, medium, weak


def read_columns(text: str) -> Columns:
    """The belt's columns of the directions that are named; the others keep theirs."""
    parts = [part.split() for part in text.lower().split(",") if part.strip()]
    return {_bearing(name): tuple(_column(each) for each in columns) for name, *columns in parts}


def read_metres(text: str) -> float:
    """A length of a robot."""
    metres = float(text.strip().replace(",", "."))
    if not 0.001 <= metres <= 1:
        raise ValueError(text)
    return metres


def read_sonars(text: str) -> Sonars:
    """Where the board's six sonars look, ``none`` for one that is not fitted."""
    words = text.lower().split()
    if len(words) != _SONARS:
        raise ValueError(text)
    return tuple(None if word == _NONE else _bearing(word) for word in words)


def read_bumpers(text: str) -> tuple[bool, ...]:
    """Reads which of the board's six bumpers are in front."""
    words = text.lower().split()
    if len(words) != _BUMPERS or not set(words) <= set(_SIDES):
        raise ValueError(text)
    return tuple(_SIDES[word] for word in words)


def read_view(text: str) -> float:
    """Read the angle of view of a camera, in degrees."""
    view = float(text.strip().replace(",", "."))
    if not VIEWS[0] <= view <= VIEWS[1]:
        raise ValueError(text)
    return view


def read_colours(text: str) -> ColourRanges:
    """The ranges of colours: of each its English word, and hue, saturation and value from-to."""
    found = {}
    for each in text.lower().split(","):
        word, *ranges = each.split()
        hue, saturation, value = (_least_and_most(one) for one in ranges)
        is_right = all(one in _HUES for one in hue) and all(one in _LEVELS for one in (*saturation, *value))
        if not is_right or saturation[0] > saturation[1] or value[0] > value[1]:
            raise ValueError(each)
        found[_colour(word)] = (*hue, *saturation, *value)
    return found


def colours_text(ranges: ColourRanges) -> str:
    """The ranges as ``read_colours`` reads them."""
    return ", ".join(
        f"{word} {each[0]}-{each[1]} {each[2]}-{each[3]} {each[4]}-{each[5]}" for word, each in ranges.items()
    )


def _least_and_most(text: str) -> tuple[int, int]:
    least, most = (int(each) for each in text.split("-"))
    return least, most


def _colour(word: str) -> str:
    from language.keywords import argument  # few starts have a camera

    found = argument("COLOUR", word)
    if found is None:
        raise ValueError(word)
    return str(found.value)


def read_wheels(text: str) -> tuple[int, int]:
    """Reads whether the right and the left wheel are wired as in the original."""
    right, left = (_SENSES.get(word, 0) for word in text.lower().split())
    if not (right and left):
        raise ValueError(text)
    return right, left


def read_reset_line(text: str) -> str:
    """Reads what restarts a board by force: a pin of a Raspberry Pi, the port's own wire, or nothing."""
    kind, colon, pin = text.strip().lower().partition(":")
    if kind == "gpio" and pin.isascii() and pin.isdecimal() and int(pin) in _PINS:
        return f"gpio:{int(pin)}"
    if kind not in ("auto", "dtr", "none") or colon:
        raise ValueError(text)
    return kind


def _bearing(word: str) -> Bearing:
    try:
        return _BEARINGS[word]
    except KeyError:
        raise ValueError(word) from None


def _column(word: str) -> int:
    column = int(word)
    if column not in _COLUMNS:
        raise ValueError(word)
    return column


class Notice(Struct, frozen=True):
    """A problem of the settings that is reported once: a code and its values."""

    code: str
    values: Mapping[str, str]


LARGEST_FILE = 100_000
"""Bytes; ten settings take two hundred."""


def read_file(file: str) -> tuple[dict[str, object], tuple[Notice, ...]]:
    """Reads the file: its settings, and what is wrong with it; both empty if there is none."""
    try:
        with open_bytes(file) as stream:
            data = stream.read(LARGEST_FILE + 1)
        if len(data) > LARGEST_FILE:
            return {}, (Notice("settings-file-too-large", {"limit": f"{LARGEST_FILE:,}".replace(",", " ")}),)
        text = data.decode("utf-8-sig")
    except FileNotFoundError:
        return {}, ()
    except (OSError, ValueError):
        return {}, (Notice("settings-file-unreadable", {}),)
    return _parsed(text)


def _parsed(text: str) -> tuple[dict[str, object], tuple[Notice, ...]]:
    try:
        return toml_in(text), ()
    except (ValueError, RecursionError) as damage:
        line = re.search(r"line (\d+)", str(damage))
        last = str(text.count("\n") + 1)
        return {}, (Notice("settings-file-damaged", {"line": line[1] if line else last}),)


def remember(key: str, value: str | bool | float, environment: Mapping[str, str]) -> None:
    """Write a setting into the file; other lines stay. Raises ``DocumentError``."""
    from pathlib import Path

    from donnie_tui.core.program_files import DocumentError, reason_of, write_program  # a start only reads

    path = Path(settings_file(environment))
    try:
        make_folder(path.parent)
        with open_bytes(path) as file:
            text = file.read().decode("utf-8-sig")
    except FileNotFoundError:
        text = ""
    except (OSError, ValueError) as problem:
        raise DocumentError("file-unwritable", str(path), reason_of(problem)) from None
    write_program(path, with_setting(text, key, value))


def with_setting(text: str, key: str, value: str | bool | float) -> str:
    """The text of a settings file in which ``key`` has ``value``."""
    line = f"{key} = {_as_toml(value)}"
    changed, count = re.subn(rf"^[ \t]*{re.escape(key)}[ \t]*=.*$", lambda _: line, text, flags=re.MULTILINE)
    if count:
        return changed
    first_table = re.search(r"^[ \t]*\[", text, flags=re.MULTILINE)
    at = first_table.start() if first_table else len(text)
    before = text[:at] if not text[:at] or text[:at].endswith("\n") else f"{text[:at]}\n"
    return f"{before}{line}\n{text[at:]}"


def _as_toml(value: str | bool | float) -> str:
    import json  # few starts write a setting

    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
