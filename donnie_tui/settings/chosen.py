"""What can be chosen, and where a choice came from: command line, environment, settings file, default.

Pure: the sources are given as mappings. A value that can't be understood is told and the next source
counts; only on the command line it is an error, because there somebody is waiting for it.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum

from devices.ports.values import Frozen, field
from donnie_tui import LANGUAGES
from donnie_tui.settings.devices import Columns, Sonars
from donnie_tui.settings.keys import BY_KEY, KEYS, Key
from donnie_tui.settings.readers import Sound, folders_of

FRONT_END_SPEED = 5.0
"""Times the real robot's pace in the front ends; ``donnie run`` is unlimited unless told otherwise."""


class Source(Enum):
    """Where a value came from, strongest first."""

    OPTION = "option"
    ENVIRONMENT = "environment"
    FILE = "file"
    DEFAULT = "default"


class Notice(Frozen):
    """Something about the settings that is told once: a code and its values."""

    code: str
    values: Mapping[str, str]


class Settings(Frozen):
    """The choices of one start. ``speed`` None is as fast as possible; ``events`` a file or ``-``."""

    world: str = "open_floor"
    world_folders: tuple[str, ...] = ()
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
    """What the settings file says; the variables and the options are weighed in ``cli.front_ends``."""
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
    sources: dict[str, Source] = {}
    notices = [_unknown(key) for key in file if key not in BY_KEY]
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
    code += "-example" if each.is_example else "-choice" if each.is_choice else ""
    return Notice(code, {"name": told_as, "value": given[:40], "wanted": each.wanted})


def _unknown(key: str) -> Notice:
    return Notice("setting-unknown", {"name": key[:40]})
