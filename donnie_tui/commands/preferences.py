"""The settings that the learner changes while Donnie runs: one value each, for both front ends.

Each is chosen by a word or from a list, applies at once, and is kept in the settings file. The value is that
of ``Settings``; a front end reads it there.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from typing import TYPE_CHECKING, Any

from msgspec import Struct
from msgspec.structs import replace

from donnie_tui import DETAILS
from donnie_tui.commands.interaction import detail_named, switched
from donnie_tui.core.wording import language_named, meant, name_of_language, spelled
from donnie_tui.settings.parsing import PERCENTS, RATES
from donnie_tui.settings.settings import (
    BY_KEY,
    KEY_ECHO,
    MOTION,
    PUNCTUATION,
    SPEAK,
    THEMES,
    Settings,
    SettingSource,
)
from language.locales import languages
from language.source import fold_name

if TYPE_CHECKING:
    from donnie_tui.i18n.words import Words

SWITCH = ("on", "off")


class Where(Enum):
    """The front ends in which a setting has an effect."""

    BOTH = "both"
    SCREEN = "screen"
    LINEAR = "linear"


class Preference(Struct, frozen=True):
    """A setting that can be changed."""

    key: str
    """Its name in the settings file."""
    values: tuple[str, ...] = ()
    """The valid values, as the settings file writes them; empty if any text is allowed."""
    where: Where = Where.BOTH
    numbers: tuple[int, int] | None = None
    """The least and the largest valid number."""
    is_audible: bool = False
    """Whether it is about voice and cues."""
    has_words: bool = True
    """Whether SET lists it in words."""
    has_sentence: bool = False
    """Whether the sentence ``preference-KEY`` says it."""
    examples: str = ""
    """Values that have no words."""


_LINEAR, _SCREEN = Where.LINEAR, Where.SCREEN

PREFERENCES = (
    Preference("page", ("rest", "ask", "off"), _LINEAR, has_sentence=True),
    Preference("prompt", ("short", "none", "word", "answer"), _LINEAR, has_sentence=True),
    Preference("hold", SWITCH, _LINEAR, has_sentence=True),
    Preference("editor", ("own", "plain"), _LINEAR, has_sentence=True),
    Preference("enter", ("waits", "runs"), _LINEAR, has_sentence=True),
    Preference("progress", where=_LINEAR, has_sentence=True, examples="0 10 60"),
    Preference("clock", SWITCH, has_sentence=True),
    Preference("free", where=_LINEAR, has_sentence=True, examples="f"),
    Preference("theme", THEMES, _SCREEN, has_words=False),
    Preference("lang", languages(), has_words=False),
    Preference("verbosity", DETAILS, has_words=False),
    Preference("speed", has_words=False),
    Preference("speech", ("auto", "off", "tts", "ssip", "robot"), is_audible=True),
    Preference("sound", SWITCH, is_audible=True, has_words=False),
    Preference("speak", SPEAK, is_audible=True),
    Preference("rate", numbers=RATES, is_audible=True),
    Preference("pitch", numbers=PERCENTS, is_audible=True),
    Preference("volume", numbers=PERCENTS, is_audible=True),
    Preference("punctuation", PUNCTUATION, is_audible=True),
    Preference("key_echo", KEY_ECHO, is_audible=True),
    Preference("cues", is_audible=True, has_words=False),
    Preference("wait_for_speech", SWITCH, is_audible=True),
    Preference("plain", SWITCH, _SCREEN, has_words=False),
    Preference("motion", MOTION, _SCREEN, has_words=False),
    Preference("mouse", SWITCH, _SCREEN, has_words=False),
    Preference("completion", SWITCH, _SCREEN, has_words=False),
    Preference("trail", SWITCH, _SCREEN, has_words=False),
    Preference("rays", SWITCH, _SCREEN, has_words=False),
    Preference("goals", SWITCH, _SCREEN, has_words=False),
    Preference("keys", where=_SCREEN, has_words=False),
)
BY_NAME = {each.key: each for each in PREFERENCES}

_HAVE_WORDS = frozenset(
    each.key for each in PREFERENCES if each.values == SWITCH or (each.has_words and each.numbers is None)
) - {"progress"}
"""Settings of which values are in ``words.toml``."""
_MEANT_BY_SWITCH = {"speech": {True: "tts", False: "off"}}


class Preferences:
    """The current settings of the session, which the learner can change."""

    def __init__(self, settings: Settings, environment: Mapping[str, str]) -> None:
        """``environment`` says where the settings file is."""
        self.settings = settings
        self._environment = environment

    def value(self, key: str) -> str:
        """The value as the settings file writes it."""
        value = getattr(self.settings, BY_KEY[key].name)
        return "max" if key == "speed" and value is None else as_text(value)

    def choose(self, key: str, text: str) -> None:
        """Set the value from a text as in the settings file. Raises ``ValueError`` for an invalid one."""
        from donnie_tui.commands.keys import not_understood  # few settings are keys

        if key == "keys" and not_understood(text):
            raise ValueError(text)
        name = BY_KEY[key].name
        changed: dict[str, Any] = {name: BY_KEY[key].read(text)}  # read as its field is
        sources = {**self.settings.sources, name: SettingSource.OPTION}
        self.settings = replace(self.settings, sources=sources, **changed)

    def keep(self, key: str) -> None:
        """Write it into the settings file. Raises ``DocumentError``."""
        from donnie_tui.settings.parsing import remember

        value = getattr(self.settings, BY_KEY[key].name)
        written = value if isinstance(value, bool | int | float) else self.value(key)
        remember(key, written, self._environment)

    # --- in words

    def in_words(self, key: str, words: Words) -> str:
        """A sentence with its name and its value."""
        preference, value = BY_NAME[key], self.value(key)
        if preference.has_sentence:
            is_never = key == "progress" and value == "0"
            code = "preference-progress-never" if is_never else f"preference-{key}"
            number = int(value) if key == "progress" else value_word(preference, value, words.language)
            return words(code, name=spelled(key, words.language, "settings"), value=number)
        if preference.has_words:
            name = spelled(key, words.language, "settings")
            return words("sound-setting", name=name, value=value_word(preference, value, words.language))
        return words("setting-row", name=label(key, words), value=self.value_label(key, words))

    def value_label(self, key: str, words: Words) -> str:
        """Its value in a list."""
        value = getattr(self.settings, BY_KEY[key].name)
        if key in ("cues", "keys") and not value:
            return words(f"setting-{key}-none")
        if key == "speed" and value is None:
            return words("speed-max")
        if isinstance(value, Mapping):
            volumes = ((spelled(cue, words.language, "cues"), volume) for cue, volume in value.items())
            return ", ".join(f"{name} {volume}" for name, volume in volumes)
        if key == "keys":
            from donnie_tui.commands.keys import keys_in_words

            return keys_in_words(str(value), words.language)
        if isinstance(value, float):
            return words("decimal", number=value)
        return value_label(BY_NAME[key], as_text(value), words) or "-"


def label(key: str, words: Words) -> str:
    """The name of a setting in a list."""
    code = f"setting-{key}"
    return words(code) if words.knows(code) else spelled(key, words.language, "settings")


def setting_word(key: str, words: Words) -> str:
    """How the name of a setting is typed: the word for it, its label, or its name in the settings file."""
    try:
        return spelled(key, words.language, "settings")
    except KeyError:
        name = label(key, words).lower()
        return key if " " in name or "," in name else name


def value_label(preference: Preference, value: str, words: Words) -> str:
    """A value in a list."""
    if preference.key == "lang":
        return name_of_language(value, words.language)
    code = f"value-{preference.key}-{value}"
    return words(code) if words.knows(code) else value_word(preference, value, words.language)


def value_word(preference: Preference, value: str, language: str) -> str:
    """How a value is typed; a value without a word is typed as the settings file has it."""
    try:
        return spelled(value, language, *_section_of(preference))
    except KeyError:
        return value


def _section_of(preference: Preference) -> tuple[str, ...]:
    """The section of ``words.toml`` with the words of its values."""
    return ("switch",) if preference.values == SWITCH else ("values", preference.key)


def find_preference(typed: str, words: Words) -> Preference | None:
    """The setting that a word of any language means, its name in the settings file, or its label."""
    folded, key = fold_name(typed), meant(typed, "settings")
    if key is not None:
        return BY_NAME["cues" if key == "cue" else key]
    return next(
        (each for each in PREFERENCES if folded in (each.key, fold_name(label(each.key, words)))), None
    )


def value_typed(preference: Preference, typed: str, words: Words) -> str | None:
    """The value, as the settings file writes it, for a word of any language; None for anything else."""
    key, is_on = preference.key, switched(typed)
    if key == "lang":
        return language_named(typed)
    if key == "verbosity":
        return detail_named(typed)
    if is_on is not None and key in _MEANT_BY_SWITCH:
        return _MEANT_BY_SWITCH[key][is_on]
    word = meant(typed, *_section_of(preference)) if key in _HAVE_WORDS else None
    if word is not None:
        return word
    for value in preference.values:
        if fold_name(typed) in (value, fold_name(value_label(preference, value, words))):
            return value
    if preference.values:
        return None
    try:
        BY_KEY[key].read(typed)
    except (ValueError, OverflowError):
        return None
    return typed


def values_in_words(preference: Preference, words: Words) -> str:
    """What the setting can be."""
    key = preference.key
    if preference.numbers is not None:
        least, most = preference.numbers
        return words("preference-numbers", least=least, most=most)
    if not preference.values and not preference.examples:
        return words(f"setting-{key}-wanted")
    values = preference.values or (("dot",) if key == "free" else ())
    typed = [value_word(preference, each, words.language) for each in values]
    return words("preference-options", choices=", ".join(filter(None, [*typed, preference.examples])))


def as_text(value: object) -> str:
    """The value as the settings file writes it."""
    if isinstance(value, bool) or value is None:
        return "on" if value else "off"
    if isinstance(value, Mapping):
        return ", ".join(f"{name} {percent}" for name, percent in value.items())
    return f"{value:g}" if isinstance(value, float) else str(value)
