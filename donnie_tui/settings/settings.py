"""Every setting by its name, and the source of its value: command line, environment, file, default.

The sources are given as mappings. A value that can't be read is reported and the next source applies; on the
command line it is an error.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from enum import Enum
from typing import TYPE_CHECKING, Any

from msgspec import Struct, field

from donnie_tui import DETAILS
from donnie_tui.process.confinement import real_path
from donnie_tui.settings import PROFILES, SPEECH
from donnie_tui.settings.parsing import (
    BUMPERS_WANTED,
    CAMERA_WANTED,
    COLOURS_WANTED,
    COLUMNS_WANTED,
    FASTEST,
    HEADS,
    METRES_WANTED,
    PERCENTS,
    PORT_WANTED,
    RATES,
    RESET_WANTED,
    ROBOT_WANTED,
    SLOWEST,
    SONARS_WANTED,
    STEPS_WANTED,
    VIEWS,
    WHEELS_WANTED,
    ColourRanges,
    Columns,
    Notice,
    Sonars,
    Sound,
    folders_of,
    one_of,
    read_bumpers,
    read_colours,
    read_columns,
    read_cues,
    read_folders,
    read_free,
    read_language,
    read_line,
    read_metres,
    read_percent,
    read_port,
    read_ports,
    read_progress,
    read_rate,
    read_reset_line,
    read_robot,
    read_seed,
    read_sonars,
    read_sound,
    read_speech,
    read_speed,
    read_steps,
    read_switch,
    read_text,
    read_view,
    read_wheels,
)
from language.locales import ENGLISH, language_of_locale, languages
from language.source import quoted

if TYPE_CHECKING:
    from donnie_tui.core.wording import Wording

SPEAK = ("here", "robot", "both")
PUNCTUATION = ("none", "some", "all")
KEY_ECHO = ("none", "characters", "words")
THEMES = ("dark", "light", "contrast", "terminal")
MOTION = ("full", "reduced")

SOUND_WANTED = "on, off, wav:FILE"
RATE_WANTED, PERCENT_WANTED = (f"{least}-{most}" for least, most in (RATES, PERCENTS))
VIEW_WANTED = f"{VIEWS[0]}-{VIEWS[1]}"
CUES_WANTED = "NAME 0-100, NAME 0-100"


class Key(Struct, frozen=True):
    """One setting: its name on the command line, in the file and (with DONNIE_) in the environment."""

    key: str
    name: str
    read: Callable[[str], object]
    """The value of a text. Raises ``ValueError``."""
    wanted: str
    """The valid values, for the error."""
    is_example: bool = False
    """Whether ``wanted`` is only an example of its values."""

    @property
    def has_named_values(self) -> bool:
        """Whether ``wanted`` lists all of its values."""
        words = self.wanted.split(", ")
        return len(words) > 1 and not any(each.isupper() or any(map(str.isdigit, each)) for each in words)

    @property
    def option(self) -> str:
        return f"--{self.key.replace('_', '-')}"

    @property
    def variable(self) -> str:
        return f"DONNIE_{self.key.upper()}"


def _one_of(key: str, values: tuple[str, ...]) -> Key:
    """A setting that is one of a few words."""
    return Key(key, key, one_of(values), ", ".join(values))


KEYS = (
    Key("world", "world", read_text, "NAME_OR_FILE"),
    Key("worlds", "world_folders", read_folders, f"FOLDER{os.pathsep}FOLDER"),
    Key("allow", "allowed_folders", read_folders, f"FOLDER{os.pathsep}FOLDER"),
    Key("robot", "robot", read_robot, ROBOT_WANTED),
    Key("lang", "language", read_language, ", ".join(languages())),
    Key("speed", "speed", read_speed, f"{SLOWEST:g}-{FASTEST:g}, max"),
    Key("seed", "seed", read_seed, "0, 1, 2 ..."),
    Key("speech", "speech", read_speech, ", ".join(SPEECH)),
    Key("sound", "sound", read_sound, SOUND_WANTED),
    _one_of("speak", SPEAK),
    Key("rate", "rate", read_rate, RATE_WANTED),
    Key("pitch", "pitch", read_percent, PERCENT_WANTED),
    Key("volume", "volume", read_percent, PERCENT_WANTED),
    _one_of("punctuation", PUNCTUATION),
    _one_of("key_echo", KEY_ECHO),
    Key("cues", "cues", read_cues, CUES_WANTED),
    Key("wait_for_speech", "wait_for_speech", read_switch, "on, off"),
    _one_of("verbosity", DETAILS),
    Key("events", "events", read_text, "FILE, -"),
    Key("record", "record", read_text, "FILE"),
    Key("belt", "belt", read_port, PORT_WANTED),
    Key("belt_steps", "belt_steps", read_steps, STEPS_WANTED, is_example=True),
    Key("belt_columns", "belt_columns", read_columns, COLUMNS_WANTED, is_example=True),
    Key("wheel_radius", "wheel_radius", read_metres, METRES_WANTED),
    Key("axle_length", "axle_length", read_metres, METRES_WANTED),
    Key("sonars", "sonars", read_sonars, SONARS_WANTED, is_example=True),
    Key("bumpers", "bumpers", read_bumpers, BUMPERS_WANTED, is_example=True),
    _one_of("profile", PROFILES),
    Key("motors", "motors", read_wheels, WHEELS_WANTED, is_example=True),
    Key("encoders", "encoders", read_wheels, WHEELS_WANTED, is_example=True),
    _one_of("head", HEADS),
    Key("camera", "camera", read_text, CAMERA_WANTED),
    Key("camera_view", "camera_view", read_view, VIEW_WANTED),
    Key("colours", "colours", read_colours, COLOURS_WANTED, is_example=True),
    Key("reset_line", "reset_line", read_reset_line, RESET_WANTED),
    Key("linear", "linear", read_switch, "on, off"),
    _one_of("page", ("rest", "ask", "off")),
    _one_of("prompt", ("short", "none", "word", "answer")),
    _one_of("hold", ("off", "on")),
    _one_of("editor", ("own", "plain")),
    _one_of("enter", ("waits", "runs")),
    Key("progress", "progress", read_progress, "0-3600"),
    _one_of("clock", ("off", "on")),
    Key("free", "free", read_free, "dot, a-z"),
    Key("tour", "tour", read_switch, "on, off"),
    _one_of("theme", THEMES),
    Key("plain", "plain", read_switch, "on, off"),
    Key("mouse", "mouse", read_switch, "on, off"),
    _one_of("motion", MOTION),
    Key("completion", "completion", read_switch, "on, off"),
    Key("trail", "trail", read_switch, "on, off"),
    Key("rays", "rays", read_switch, "on, off"),
    Key("goals", "goals", read_switch, "on, off"),
    Key("keys", "keys", read_line, "ACTION KEY, ACTION KEY"),
)
CONFINED = Key("confined", "folder", read_text, "FOLDER")
DEVICES = Key("devices", "devices", read_ports, PORT_WANTED)
BY_KEY = {each.key: each for each in (*KEYS, CONFINED, DEVICES)}


FRONT_END_SPEED = 5.0
"""Times the real robot's pace in the front ends; ``donnie run`` is unlimited by default."""


class SettingSource(Enum):
    """The source of a value, strongest first."""

    OPTION = "option"
    ENVIRONMENT = "environment"
    FILE = "file"
    DEFAULT = "default"


class ServedFile(Struct, frozen=True):
    """The file that ``donnie player`` serves, and its address."""

    file: str
    host: str
    port: int
    """The port of robots without a port of their own."""


class Settings(Struct, frozen=True):
    """The settings of one start. ``speed`` None is as fast as possible; ``events`` a file or ``-``."""

    world: str = "first_room"
    world_folders: tuple[str, ...] = ()
    """Folders from which worlds may include files, besides their own project."""
    allowed_folders: tuple[str, ...] = ()
    """More such folders, from ``--allow``."""
    robot: str = "sim"
    language: str = "en"
    speed: float | None = FRONT_END_SPEED
    seed: int = 0
    speech: str = "auto"
    sound: Sound = True
    speak: str = "here"
    """The voice for the words of SPEAK."""
    rate: int = 180
    """Words a minute of the built-in voice; speech-dispatcher's only if it was chosen."""
    pitch: int = 50
    volume: int = 100
    punctuation: str = "some"
    key_echo: str = "none"
    """What the built-in voice speaks while the learner types."""
    cues: Mapping[str, int] = field(default_factory=dict)
    """Volumes in percent by the name of a cue; 0 is off."""
    wait_for_speech: bool = False
    """Whether a program waits for the end of its sentences."""
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
    profile: str = "auto"
    """The firmware of a real robot, and with it the senses of its wheels and its head."""
    motors: tuple[int, int] | None = None
    """Of the right and the left wheel: 1 as in the original, -1 reversed; None as in the profile."""
    encoders: tuple[int, int] | None = None
    head: str | None = None
    """The side at which the head's angle is 0; None as in the profile."""
    camera: str | None = None
    """Of a real robot: its number or device, or pictures in place of one."""
    camera_view: float | None = None
    """Degrees that its picture is wide; None as in the original."""
    colours: ColourRanges | None = None
    """The colour ranges of a calibration; None as in the original."""
    reset_line: str = "auto"
    """The pin that restarts a board."""
    linear: bool | None = None
    """The value in the settings file; ``cli.front_end`` also uses variables and options."""
    theme: str = "dark"
    """The look of the full screen."""
    plain: bool | None = None
    """One column without decoration; None if a screen reader decides."""
    mouse: bool = True
    motion: str = "full"
    completion: bool = True
    """Whether the editor offers the words that may follow."""
    trail: bool = True
    """Whether the map of the full screen shows it; so ``rays`` and ``goals``."""
    rays: bool = True
    goals: bool = True
    keys: str = ""
    """Other keys of the full screen: ``run f9, step f10``."""
    page: str = "rest"
    """This and what follows, to ``free``: how the linear mode behaves, see ``linear``."""
    prompt: str = "short"
    hold: str = "off"
    editor: str = "own"
    enter: str = "waits"
    progress: str = "10"
    clock: str = "off"
    free: str = "dot"
    tour: bool = True
    """Whether the tour may be offered at the first start."""
    served: ServedFile | None = None
    """The file served to clients."""
    log: bool = False
    """Whether every sentence also goes to a numbered file, as with the original's ``-l``."""
    notices: tuple[Notice, ...] = ()
    """Problems of the settings, reported once a front end listens."""
    sources: Mapping[str, SettingSource] = field(default_factory=dict)
    """The source of each field; a field that is not in it is a default."""

    @property
    def include_folders(self) -> tuple[str, ...]:
        """Folders from which a world may include files, besides those of its own project."""
        return (*self.allowed_folders, *self.world_folders)

    def source_of(self, name: str) -> SettingSource:
        return self.sources.get(name, SettingSource.DEFAULT)


class Refusal(Exception):
    """Raised so that Donnie does not start: the code of a sentence and its values."""

    def __init__(self, code: str, **values: object) -> None:
        super().__init__(code)
        self.code, self.values = code, values


class BadOption(Refusal):
    """A value on the command line that can't be understood."""


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
        "world_folders": folders_of(environment.get("STAGEPATH", "")),
    }
    sources: dict[str, SettingSource] = {}
    notices = [_unknown(key) for key in file if key not in BY_KEY]
    for each in KEYS:
        for source, shown_name, given in _given(each, options, environment, file):
            try:
                values[each.name] = each.read(_checked(given))
            except ValueError:
                notices.append(_complain(each, source, shown_name, given))
            else:
                sources[each.name] = source
                break
    return Settings(**values, sources=sources), tuple(notices)  # type: ignore[arg-type] # read as its field is


# --- what a teacher allows


class SessionLimits(Struct, frozen=True):
    """The limits of a session. ``devices`` None: it may use any."""

    folder: str | None = None
    devices: tuple[str, ...] | None = None


class BadLimitsError(Refusal):
    """Unusable limits."""


def limits_of(
    machine: Mapping[str, object],
    environment: Mapping[str, str],
    account: Mapping[str, object],
    options: Mapping[str, str],
) -> SessionLimits:
    """The limits from all sources, such as the settings of the machine and of the account.

    Here the strongest source is the one furthest from the learner, and a weaker one can only limit more.
    Raises ``BadLimitsError`` also for a value that can't be read: without it a learner would be free.
    """
    limits = SessionLimits()
    variables = {
        each.key: environment[each.variable] for each in (CONFINED, DEVICES) if each.variable in environment
    }
    for source in (machine, variables, account, options):
        limits = _limited_by(source, limits)
    if limits.folder is not None and limits.devices is None:
        limits = SessionLimits(limits.folder, ())
    return limits


def _limited_by(source: Mapping[str, object], limits: SessionLimits) -> SessionLimits:
    devices, folder = limits.devices, limits.folder
    if DEVICES.key in source:
        given = _limit(DEVICES, source)
        allowed = devices if devices is not None or folder is None else ()
        refused = [each for each in given if allowed is not None and each not in allowed]
        if refused:
            raise BadLimitsError("devices-wider", port=refused[0])
        devices = given
    if CONFINED.key in source:
        folder = _folder_within(_limit(CONFINED, source), folder)
        devices = devices or ()
    return SessionLimits(folder, devices)


def _limit(key: Key, source: Mapping[str, object]) -> Any:
    given = source[key.key]
    try:
        if not isinstance(given, str):
            raise ValueError(given)
        return key.read(given)
    except ValueError:
        values = {"name": key.key, "value": quoted(str(given)), "wanted": key.wanted}
        raise BadLimitsError("limit-not-understood", **values) from None


def _folder_within(name: str, outer: str | None) -> str:
    """The real path of a folder that is there, and lies in ``outer``."""
    found = real_path(_with_home(name))
    if not (os.path.isabs(found) and os.path.isdir(found)):  # noqa: PTH112, PTH117 -- pathlib is slow to load
        raise BadLimitsError("confined-no-folder", path=name)
    if outer is not None and os.path.commonpath((outer, found)) != outer:
        raise BadLimitsError("confined-wider", path=name, folder=outer)
    return found


def _with_home(name: str) -> str:
    """``~`` is the home of the account, whatever the environment says."""
    if name != "~" and not name.startswith("~/"):
        return name
    import pwd  # of systems on which a session can be confined

    return pwd.getpwuid(os.getuid()).pw_dir + name[1:]


def language_of(environment: Mapping[str, str]) -> str:
    """The language of the locale, English for a locale without one."""
    locale = next(filter(None, map(environment.get, ("LC_ALL", "LC_MESSAGES", "LANG"))), "")
    return language_of_locale(locale) or ENGLISH


def _given(
    each: Key, options: Mapping[str, str], environment: Mapping[str, str], file: Mapping[str, object]
) -> list[tuple[SettingSource, str, object]]:
    """The sources that have the key, strongest first: the source, the key's name there, and the value."""
    given: list[tuple[SettingSource, str, object]] = []
    if each.key in options:
        given.append((SettingSource.OPTION, each.option, options[each.key]))
    if environment.get(each.variable):
        given.append((SettingSource.ENVIRONMENT, each.variable, environment[each.variable]))
    if each.key in file:
        given.append((SettingSource.FILE, each.key, _as_text(file[each.key])))
    return given


def _as_text(value: object) -> object:
    """The value of a settings file as the command line has it; a list or a date as it is."""
    if isinstance(value, bool):
        return "on" if value else "off"
    return str(value) if isinstance(value, str | int | float) else value


def _checked(given: object) -> str:
    """Raises ``ValueError`` for anything but a text."""
    if not isinstance(given, str):
        raise ValueError(given)
    return given


def _complain(each: Key, source: SettingSource, shown_name: str, given: object) -> Notice:
    if source is SettingSource.OPTION:
        raise BadOption("bad-option", option=each.option, value=quoted(str(given)), wanted=each.wanted)
    code = "setting-not-understood" if source is SettingSource.FILE else "variable-not-understood"
    code += "-example" if each.is_example else "-values" if each.has_named_values else ""
    return Notice(code, {"name": shown_name, "value": quoted(str(given)), "wanted": each.wanted})


def _unknown(key: str) -> Notice:
    return Notice("setting-unknown", {"name": quoted(key)})


# --- the speeds that SLOWER and FASTER choose from

SPEEDS: tuple[float | None, ...] = (1.0, 2.0, 5.0, 10.0, 20.0, 50.0, None)
"""Times the real robot's pace; None is as fast as possible."""


def faster_than(speed: float | None) -> float | None:
    """The next speed above ``speed``; the fastest has none above it."""
    return next((each for each in SPEEDS if _is_faster(each, speed)), None)


def slower_than(speed: float | None) -> float | None:
    """The next speed below ``speed``; one that is below all of them stays."""
    below = [each for each in SPEEDS if _is_faster(speed, each)]
    return below[-1] if below else speed


def speed_words(speed: float | None, words: Wording) -> str:
    return words("speed-max") if speed is None else words("decimal", number=speed)


def _is_faster(one: float | None, other: float | None) -> bool:
    return other is not None and (one is None or one > other)
