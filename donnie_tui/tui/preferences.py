"""What can be chosen while the screen is there: the values, how they are told, and keeping them.

Pure but for the settings file. Whoever applies a choice to the screen asks here for its value.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from devices.ports.values import Frozen, replace
from donnie_tui import DETAILS, LANGUAGES
from donnie_tui.core.documents import DocumentError
from donnie_tui.i18n.words import Words
from donnie_tui.settings import file as settings_file
from donnie_tui.settings.chosen import Settings
from donnie_tui.settings.keys import KEY_ECHO, KEYS, MOTION, PUNCTUATION, SPEAK, THEMES
from donnie_tui.tui.actions import BY_NAME
from donnie_tui.tui.key_table import not_understood, understood
from donnie_tui.tui.keys import key_label
from donnie_tui.words.sound_words import SETTINGS, cue_name

_SWITCH = ("on", "off")

CHOICES: dict[str, tuple[str, ...]] = {
    "theme": THEMES,
    "lang": LANGUAGES,
    "verbosity": DETAILS,
    "speed": (),
    "speech": tuple(map(str, SETTINGS["speech"][1])),
    "sound": _SWITCH,
    "speak": SPEAK,
    "rate": (),
    "pitch": (),
    "volume": (),
    "punctuation": PUNCTUATION,
    "key_echo": KEY_ECHO,
    "cues": (),
    "wait_for_speech": _SWITCH,
    "plain": _SWITCH,
    "motion": MOTION,
    "mouse": _SWITCH,
    "completion": _SWITCH,
    "keys": (),
}
"""What each can be; an empty one is typed."""

AUDIBLE = (
    *("sound", "speech", "speak", "rate", "pitch", "volume"),
    *("punctuation", "key_echo", "cues", "wait_for_speech"),
)
"""Those of voice and cues."""

LISTED = ("cues", "keys")
"""Those with a list of their own; where nothing was chosen, that is said."""

_KEY = {each.key: each for each in KEYS}


class Preference(Frozen):
    """One setting and what it is now."""

    key: str
    value: object

    def told(self, words: Words) -> str:
        code = f"value-{self.key}-{_as_value(self.value)}"
        if words.knows(code):
            return words(code)
        if self.key in LISTED and not self.value:
            return words(f"setting-{self.key}-none")
        if self.key == "speed" and self.value is None:
            return words("speed-max")
        if isinstance(self.value, Mapping):
            at = LANGUAGES.index(words.language)
            return ", ".join(f"{cue_name(name, at)} {percent}" for name, percent in self.value.items())
        if self.key == "keys":
            pairs = understood(str(self.value))
            language = words.language
            return ", ".join(
                f"{key_label(key, language)} {BY_NAME[name].word(language)}" for name, key in pairs
            )
        if isinstance(self.value, float):
            return words("decimal", number=self.value)
        return _as_value(self.value) or "-"


class Preferences:
    """The settings of this start, changed as somebody chooses."""

    def __init__(self, settings: Settings, environment: Mapping[str, str]) -> None:
        self.settings = settings
        self._environment = environment

    @property
    def all(self) -> tuple[Preference, ...]:
        return tuple(Preference(key, getattr(self.settings, _KEY[key].name)) for key in CHOICES)

    def value(self, key: str) -> str:
        """As it is written in the settings file."""
        return _as_value(getattr(self.settings, _KEY[key].name))

    def values(self, key: str) -> tuple[str, ...]:
        return CHOICES[key]

    def understands(self, key: str, typed: str) -> bool:
        try:
            _KEY[key].read(typed)
        except ValueError:
            return False
        return key != "keys" or not not_understood(typed)

    def choose(self, key: str, typed: str) -> object:
        """From now on; the value. Raises ``ValueError``."""
        value = _KEY[key].read(typed)
        changed: dict[str, Any] = {_KEY[key].name: value}  # read as its field is
        self.settings = replace(self.settings, **changed)
        return value

    def keep(self, key: str) -> DocumentError | None:
        """Write it into the settings file; what kept it from being written."""
        value = getattr(self.settings, _KEY[key].name)
        written = value if isinstance(value, bool | float) else _as_value(value)
        try:
            settings_file.remember(key, written, self._environment)
        except DocumentError as problem:
            return problem
        return None


def _as_value(value: object) -> str:
    if isinstance(value, bool) or value is None:
        return "on" if value else "off"
    if isinstance(value, Mapping):
        return ", ".join(f"{name} {percent}" for name, percent in value.items())
    return f"{value:g}" if isinstance(value, float) else str(value)
