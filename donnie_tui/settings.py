"""What can be chosen, and where a choice came from: command line, environment, settings file, default.

Pure: the sources are given as mappings. A value that can't be understood is told and the next source
counts; only on the command line it is an error, because there somebody is waiting for it.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping
from enum import Enum
from pathlib import Path

from devices.ports.values import field, frozen
from donnie_tui.device_settings import (
    BUMPERS_WANTED,
    COLUMNS_WANTED,
    METRES_WANTED,
    RESET_WANTED,
    ROBOT_WANTED,
    SONARS_WANTED,
    STEPS_WANTED,
    Columns,
    Sonars,
    read_bumpers,
    read_columns,
    read_metres,
    read_reset_line,
    read_robot,
    read_sonars,
    read_steps,
)
from donnie_tui.sound_settings import (
    CUES_WANTED,
    KEY_ECHO,
    PERCENT_WANTED,
    PUNCTUATION,
    RATE_WANTED,
    SOUND_WANTED,
    SPEAK,
    Sound,
    read_cues,
    read_percent,
    read_rate,
    read_sound,
)

FRONT_END_SPEED = 5.0
"""Times the real robot's pace in the front ends; ``donnie run`` is unlimited unless told otherwise."""

SLOWEST, FASTEST = 0.1, 1000.0
LARGEST_SEED = 2**63 - 1
LONGEST_PROGRESS = 3600
"""Seconds between two signs of life of a long run."""

LANGUAGES = ("en", "pt", "es")
SPEECH = ("auto", "off", "text", "ssip", "tts", "robot")
VERBOSITY = ("brief", "normal", "full")
THEMES = ("dark", "light", "contrast", "terminal")
MOTION = ("full", "reduced")


class Source(Enum):
    """Where a value came from, strongest first."""

    OPTION = "option"
    ENVIRONMENT = "environment"
    FILE = "file"
    DEFAULT = "default"


@frozen
class Notice:
    """Something about the settings that is told once: a code and its values."""

    code: str
    values: Mapping[str, str]


@frozen
class Settings:
    """The choices of one start. ``speed`` None is as fast as possible; ``events`` a file or ``-``."""

    world: str = "open_floor"
    world_folders: tuple[Path, ...] = ()
    """Folders from which worlds may include files, besides their own."""
    robot: str = "sim"
    language: str = "en"
    speed: float | None = FRONT_END_SPEED
    seed: int = 0
    speech: str = "auto"
    sound: Sound = True
    speak: str = "here"
    """Where the words of SPEAK are heard."""
    rate: int = 180
    """Words a minute of the own voice; speech-dispatcher's only if it was chosen."""
    pitch: int = 50
    volume: int = 100
    punctuation: str = "some"
    key_echo: str = "none"
    """What the own voice says of what is typed."""
    cues: Mapping[str, int] = field(default_factory=dict)
    """Volumes in percent by the name of a cue; 0 is off."""
    wait_for_speech: bool = False
    """Whether a program waits until what it says was said."""
    verbosity: str = "normal"
    events: str | None = None
    record: str | None = None
    belt: str | None = None
    """The port of the vibrating belt."""
    belt_steps: tuple[int, int, int] | None = None
    belt_columns: Columns | None = None
    wheel_radius: float | None = None
    """Of a real robot, in metres, as a calibration found it."""
    axle_length: float | None = None
    sonars: Sonars | None = None
    bumpers: tuple[bool, ...] | None = None
    reset_line: str = "auto"
    """What restarts a board by force."""
    linear: bool | None = None
    """What the settings file says; the variables and the options are weighed in ``cli.mode``."""
    theme: str = "dark"
    """The look of the full screen."""
    plain: bool | None = None
    """One column without decoration; None where a screen reader decides."""
    mouse: bool = True
    motion: str = "full"
    completion: bool = True
    """Whether the editor offers the words that may follow."""
    keys: str = ""
    """Other keys of the full screen: ``run f9, step f10``."""
    page: str = "rest"
    """This and what follows, to ``free``: how the linear mode behaves, see ``linear.habits``."""
    prompt: str = "short"
    hold: str = "off"
    editor: str = "own"
    enter: str = "waits"
    progress: str = "10"
    clock: str = "off"
    free: str = "dot"
    tour: bool = True
    """Whether the tour may be offered at the first start."""
    log: bool = False
    """Whether what is told goes to a numbered file too, as with the original's ``-l``."""
    notices: tuple[Notice, ...] = ()
    """What is to be told about the settings themselves once somebody listens."""
    sources: Mapping[str, Source] = field(default_factory=dict)
    """Where each field came from; what is not in it is a default."""

    def source_of(self, name: str) -> Source:
        return self.sources.get(name, Source.DEFAULT)


class BadOption(Exception):
    """A value on the command line that can't be understood."""

    def __init__(self, key: str, value: str, wanted: str) -> None:
        super().__init__(f"{key} {value}")
        self.key = key
        self.value = value
        self.wanted = wanted


@frozen
class Key:
    """One setting: its name on the command line, in the file and (with DONNIE_) in the environment."""

    key: str
    name: str
    read: Callable[[str], object]
    """The value of a text. Raises ``ValueError``."""
    wanted: str
    """What it takes, for the error."""

    @property
    def variable(self) -> str:
        return f"DONNIE_{self.key.upper()}"


def resolve(
    options: Mapping[str, str],
    environment: Mapping[str, str],
    file: Mapping[str, object],
    *,
    default_speed: float | None = FRONT_END_SPEED,
) -> tuple[Settings, tuple[Notice, ...]]:
    """The settings that win, by ``key``. Raises ``BadOption``."""
    values: dict[str, object] = {
        "speed": default_speed,
        "language": language_of(environment),
        "world_folders": _folders(environment.get("STAGEPATH", "")),
    }
    sources: dict[str, Source] = {}
    notices = [_unknown(key) for key in file if key not in _BY_KEY]
    for each in KEYS:
        for source, told_as, given in _given(each, options, environment, file):
            try:
                values[each.name] = each.read(given)
            except ValueError:
                notices.append(_complain(each, source, told_as, given))
            else:
                sources[each.name] = source
                break
    return Settings(**values, sources=sources), tuple(notices)  # type: ignore[arg-type] # read as its field is


def language_of(environment: Mapping[str, str]) -> str:
    """The language of the locale: ``pt*`` and ``es*``, English for all others."""
    locale = next(filter(None, map(environment.get, ("LC_ALL", "LC_MESSAGES", "LANG"))), "")
    return locale[:2].lower() if locale[:2].lower() in LANGUAGES else "en"


def _given(
    each: Key, options: Mapping[str, str], environment: Mapping[str, str], file: Mapping[str, object]
) -> list[tuple[Source, str, str]]:
    """Where the key is given, strongest first: the source, what it is called there, and the text."""
    given: list[tuple[Source, str, str]] = []
    if each.key in options:
        given.append((Source.OPTION, f"--{each.key}", options[each.key]))
    if environment.get(each.variable):
        given.append((Source.ENVIRONMENT, each.variable, environment[each.variable]))
    if each.key in file:
        given.append((Source.FILE, each.key, _as_text(file[each.key])))
    return given


def _as_text(value: object) -> str:
    if isinstance(value, bool):
        return "on" if value else "off"
    return str(value) if isinstance(value, str | int | float) else repr(type(value))


def _complain(each: Key, source: Source, told_as: str, given: str) -> Notice:
    if source is Source.OPTION:
        raise BadOption(each.key, given, each.wanted)
    code = "setting-not-understood" if source is Source.FILE else "variable-not-understood"
    return Notice(code, {"name": told_as, "value": given[:40], "wanted": each.wanted})


def _unknown(key: str) -> Notice:
    return Notice("setting-unknown", {"name": key[:40]})


# --- values


def read_switch(text: str) -> bool:
    """On or off, in the ways in which files and variables write it. Raises ``ValueError``."""
    folded = text.strip().lower()
    if folded in ("on", "yes", "true", "1"):
        return True
    if folded in ("off", "no", "false", "0"):
        return False
    raise ValueError(text)


def read_speed(text: str) -> float | None:
    """Times the real robot's pace, or None for ``max``. Raises ``ValueError``."""
    if text.strip().lower() == "max":
        return None
    speed = float(text.strip().replace(",", "."))
    if math.isnan(speed) or not SLOWEST <= speed <= FASTEST:
        raise ValueError(text)
    return speed


def _read_seed(text: str) -> int:
    seed = int(text)
    if not 0 <= seed <= LARGEST_SEED:
        raise ValueError(text)
    return seed


def _read_language(text: str) -> str:
    """``pt`` also as ``pt-BR`` or ``pt_BR.UTF-8``."""
    language = text.strip().lower().replace("_", "-").split("-")[0]
    return _one_of(LANGUAGES)(language)


def _one_of(words: tuple[str, ...]) -> Callable[[str], str]:
    def read(text: str) -> str:
        folded = text.strip().lower()
        if folded not in words:
            raise ValueError(text)
        return folded

    return read


def _read_speech(text: str) -> str:
    """``on`` is the own voice, whatever would be chosen."""
    return "tts" if text.strip().lower() == "on" else _one_of(SPEECH)(text)


def _read_progress(text: str) -> str:
    if not 0 <= int(text) <= LONGEST_PROGRESS:
        raise ValueError(text)
    return str(int(text))


def _read_free(text: str) -> str:
    """A letter of a braille alphabet, or ``dot``."""
    if text != "dot" and not (len(text) == 1 and text.isascii() and text.isalpha()):
        raise ValueError(text)
    return text


def _read_text(text: str) -> str:
    if not text or "\0" in text:
        raise ValueError(text)
    return text


def _read_line(text: str) -> str:
    """Any, an empty one too."""
    return _read_text(text) if text else ""


def read_folders(text: str) -> tuple[Path, ...]:
    """Folders, apart as in PATH. Raises ``ValueError``."""
    folders = _folders(_read_text(text))
    if not folders:
        raise ValueError(text)
    return folders


def _folders(text: str) -> tuple[Path, ...]:
    given = (each for each in text.split(os.pathsep) if each.strip())
    return tuple(Path(os.path.expanduser(each)) for each in given)  # noqa: PTH111 -- pathlib's raises


KEYS = (
    Key("world", "world", _read_text, "NAME_OR_FILE"),
    Key("worlds", "world_folders", read_folders, f"FOLDER{os.pathsep}FOLDER"),
    Key("robot", "robot", read_robot, ROBOT_WANTED),
    Key("lang", "language", _read_language, "en, pt, es"),
    Key("speed", "speed", read_speed, f"{SLOWEST:g}-{FASTEST:g}, max"),
    Key("seed", "seed", _read_seed, "0, 1, 2 ..."),
    Key("speech", "speech", _read_speech, ", ".join(SPEECH)),
    Key("sound", "sound", read_sound, SOUND_WANTED),
    Key("speak", "speak", _one_of(SPEAK), ", ".join(SPEAK)),
    Key("rate", "rate", read_rate, RATE_WANTED),
    Key("pitch", "pitch", read_percent, PERCENT_WANTED),
    Key("volume", "volume", read_percent, PERCENT_WANTED),
    Key("punctuation", "punctuation", _one_of(PUNCTUATION), ", ".join(PUNCTUATION)),
    Key("key_echo", "key_echo", _one_of(KEY_ECHO), ", ".join(KEY_ECHO)),
    Key("cues", "cues", read_cues, CUES_WANTED),
    Key("wait_for_speech", "wait_for_speech", read_switch, "on, off"),
    Key("verbosity", "verbosity", _one_of(VERBOSITY), ", ".join(VERBOSITY)),
    Key("events", "events", _read_text, "FILE, -"),
    Key("record", "record", _read_text, "FILE"),
    Key("belt", "belt", _read_text, "PORT"),
    Key("belt_steps", "belt_steps", read_steps, STEPS_WANTED),
    Key("belt_columns", "belt_columns", read_columns, COLUMNS_WANTED),
    Key("wheel_radius", "wheel_radius", read_metres, METRES_WANTED),
    Key("axle_length", "axle_length", read_metres, METRES_WANTED),
    Key("sonars", "sonars", read_sonars, SONARS_WANTED),
    Key("bumpers", "bumpers", read_bumpers, BUMPERS_WANTED),
    Key("reset_line", "reset_line", read_reset_line, RESET_WANTED),
    Key("linear", "linear", read_switch, "on, off"),
    Key("page", "page", _one_of(("rest", "ask", "off")), "rest, ask, off"),
    Key("prompt", "prompt", _one_of(("short", "none", "word", "answer")), "short, none, word, answer"),
    Key("hold", "hold", _one_of(("off", "on")), "off, on"),
    Key("editor", "editor", _one_of(("own", "plain")), "own, plain"),
    Key("enter", "enter", _one_of(("waits", "runs")), "waits, runs"),
    Key("progress", "progress", _read_progress, "0-3600"),
    Key("clock", "clock", _one_of(("off", "on")), "off, on"),
    Key("free", "free", _read_free, "dot, a-z"),
    Key("tour", "tour", read_switch, "on, off"),
    Key("theme", "theme", _one_of(THEMES), ", ".join(THEMES)),
    Key("plain", "plain", read_switch, "on, off"),
    Key("mouse", "mouse", read_switch, "on, off"),
    Key("motion", "motion", _one_of(MOTION), ", ".join(MOTION)),
    Key("completion", "completion", read_switch, "on, off"),
    Key("keys", "keys", _read_line, "ACTION KEY, ACTION KEY"),
)
_BY_KEY = {each.key: each for each in KEYS}
