"""How the settings write down a belt and a real robot. Each reader takes a text and raises ``ValueError``."""

from __future__ import annotations

from collections.abc import Mapping

from devices.ports.robot import Bearing

Columns = Mapping[Bearing, tuple[int, ...]]
Sonars = tuple[Bearing | None, ...]

_BEARINGS = {each.name.lower().replace("_", "-"): each for each in Bearing}
_SIDES = {"front": True, "back": False}
_COLUMNS = range(7)
_SONARS = _BUMPERS = 6
_NONE = "none"
_PINS = range(2, 28)
"""The Raspberry Pi's lines that a person can wire; 0 and 1 belong to its boards."""

SIMULATED, DOUBLE, SERIAL = "sim", "double", "serial"
"""What ``--robot`` takes; ``serial`` alone finds the port by itself, ``serial:PORT`` names it."""

ROBOT_WANTED = "sim, serial, serial:PORT, double"
STEPS_WANTED = "5 10 20"
COLUMNS_WANTED = "front 3, front-right 4, back 0 6"
METRES_WANTED = "0.001-1"
SONARS_WANTED = "front-right front front-left back-left back back-right"
RESET_WANTED = "auto, dtr, gpio:22, none"
BUMPERS_WANTED = "front front front back back back"


def read_robot(text: str) -> str:
    """Which robot: a simulated one, a real one, or the simulated board of a real one."""
    kind, colon, port = text.strip().partition(":")
    if kind.lower() not in (SIMULATED, DOUBLE, SERIAL) or "\0" in text:
        raise ValueError(text)
    if colon and (kind.lower() != SERIAL or not port):
        raise ValueError(text)
    return f"{kind.lower()}{colon}{port}"


def read_steps(text: str) -> tuple[int, int, int]:
    """Up to how many steps something is felt strongly, medium and weakly."""
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
    """Of each of the board's six bumpers whether it is in front."""
    words = text.lower().split()
    if len(words) != _BUMPERS or not set(words) <= set(_SIDES):
        raise ValueError(text)
    return tuple(_SIDES[word] for word in words)


def read_reset_line(text: str) -> str:
    """What restarts a board by force: a pin of a Raspberry Pi, the port's own wire, or nothing."""
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
