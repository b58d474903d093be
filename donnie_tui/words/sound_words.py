"""What the words about voice and cues do, for both front ends: QUIET, CUES, and their settings for SET.

Answers go to the hub. A cue is always told in words too.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping

from donnie_tui import LANGUAGES
from donnie_tui.bootstrap import Donnie
from donnie_tui.core.documents import DocumentError
from donnie_tui.core.events import Answered, Chimed
from donnie_tui.core.typed_words import SWITCH, switched
from donnie_tui.settings.file import remember
from donnie_tui.settings.readers import PERCENTS, RATES, read_percent, read_rate
from language.source import fold_name

Spelled = tuple[str, str, str]

CUE_WORDS: Mapping[str, Spelled] = {
    "step-forward": ("forward", "frente", "adelante"),
    "step-back": ("back", "trás", "atrás"),
    "turn-right": ("right", "direita", "derecha"),
    "turn-left": ("left", "esquerda", "izquierda"),
    "obstacle": ("obstacle", "obstáculo", "obstáculo"),
    "bump": ("bump", "colisão", "choque"),
    "scan": ("scan", "olhar", "mirada"),
    "found": ("found", "achado", "hallado"),
    "belt": ("belt", "cinto", "cinturón"),
    "done": ("done", "fim", "fin"),
    "error": ("error", "erro", "error"),
    "waiting": ("waiting", "espera", "espera"),
    "block-opened": ("open", "abre", "abre"),
    "block-closed": ("close", "fecha", "cierra"),
}
"""What each cue is called when it is typed."""

_SWITCHES: Mapping[str, Mapping[bool, str | bool]] = {
    "speech": {False: "off", True: "tts"},
    "wait_for_speech": {False: False, True: True},
}
"""What off and on mean, of the settings that have them."""

SETTINGS: Mapping[str, tuple[Spelled, Mapping[object, Spelled]]] = {
    "speech": (
        ("speech", "fala", "voz"),
        {
            "auto": ("auto", "auto", "auto"),
            "off": ("off", "não", "no"),
            "tts": ("own", "própria", "propia"),
            "ssip": ("ssip", "ssip", "ssip"),
            "robot": ("robot", "robô", "robot"),
        },
    ),
    "speak": (
        ("speak", "falar", "hablar"),
        {
            "here": ("here", "aqui", "aquí"),
            "robot": ("robot", "robô", "robot"),
            "both": ("both", "ambos", "ambos"),
        },
    ),
    "rate": (("rate", "ritmo", "ritmo"), {}),
    "pitch": (("pitch", "tom", "tono"), {}),
    "volume": (("volume", "volume", "volumen"), {}),
    "punctuation": (
        ("punctuation", "pontuação", "puntuación"),
        {
            "none": ("none", "nenhuma", "ninguna"),
            "some": ("some", "alguma", "alguna"),
            "all": ("all", "toda", "toda"),
        },
    ),
    "key_echo": (
        ("echo", "eco", "eco"),
        {
            "none": ("none", "nenhum", "ninguno"),
            "characters": ("letters", "letras", "letras"),
            "words": ("words", "palavras", "palabras"),
        },
    ),
    "wait_for_speech": (("wait", "esperar", "esperar"), SWITCH),
}
"""By the field of the settings: how its name and its values are typed; numbers where there are none."""

CUE = ("cue", "sinal", "señal")
"""SET cue bump 50."""

_READ = {"rate": read_rate, "pitch": read_percent, "volume": read_percent}
_NUMBERS = {"rate": RATES, "pitch": PERCENTS, "volume": PERCENTS}
_KEPT_AS = {True: "on", False: "off"}
_LOUD, _SILENT = 100, 0

BETWEEN = 0.7
"""Seconds from the end of a cue, and of its name, to the next one."""
FOR_READERS = 2.0
"""Seconds for its name where somebody else says it."""
_GLANCE = 0.05
_LONGEST_NAME = 100
"""Glances."""


# --- QUIET


def quiet(donnie: Donnie) -> None:
    """End what is being said; the answer to that is in print alone."""
    donnie.outlets.audible.hush_all()
    donnie.session.hub.publish(Answered(donnie.words("quiet"), in_print_only=True))


# --- CUES


def play_cues(donnie: Donnie, typed: str) -> Iterator[float]:
    """Tell each cue and let it sound, or the one that was ``typed``. Gives the seconds until the next look.

    Whoever goes through it waits that long, and may leave it at any time; a hush ends it.
    """
    hushed = donnie.outlets.audible.hushed
    for seconds in _played(donnie, typed):
        yield seconds
        if donnie.outlets.audible.hushed != hushed:
            break


def _played(donnie: Donnie, typed: str) -> Iterator[float]:
    name = find_cue(typed)
    if typed and name is None:
        donnie.say("cues-unknown", name=typed[:40])
        return
    if not donnie.outlets.audible.has_cues:
        donnie.say(donnie.outlets.audible.why_no_cues)
    elif name is None:
        donnie.say("cues-count", count=len(CUE_WORDS))
        yield from _until_said(donnie)
    for each in CUE_WORDS if name is None else (name,):
        yield from _play_cue(donnie, each)


def chime(donnie: Donnie, name: str) -> None:
    """Let a cue be heard, as loud as it is set."""
    donnie.session.hub.publish(Chimed(name))


def cue_name(name: str, at: int) -> str:
    """What a cue is called in the language number ``at``."""
    return CUE_WORDS[name][at] if name in CUE_WORDS else name


def find_cue(typed: str) -> str | None:
    """The cue that a word of any language means, or its own name."""
    folded = fold_name(typed)
    words = ((name, (name, *spelled)) for name, spelled in CUE_WORDS.items())
    return next((name for name, known in words if folded in map(fold_name, known)), None)


def chime_block(donnie: Donnie, before: int, after: int) -> None:
    """The cue for so many open blocks: the deeper, the higher. Silent if their number is the same."""
    if before == after or not donnie.outlets.audible.has_cues:
        return
    from devices.sound.tones import pitch_of_level

    name = "block-opened" if after > before else "block-closed"
    donnie.session.hub.publish(Chimed(name, steps=pitch_of_level(max(before, after))))


def _play_cue(donnie: Donnie, name: str) -> Iterator[float]:
    """First the sound, then the sentence (a cue never waits for it)."""
    if donnie.outlets.audible.has_cues:
        chime(donnie, name)
    donnie.say("cues-line", name=CUE_WORDS[name][_at(donnie)], meaning=donnie.words(f"cue-{name}"))
    if donnie.outlets.audible.has_cues:
        yield from _until_said(donnie)


def _until_said(donnie: Donnie) -> Iterator[float]:
    if not donnie.outlets.audible.speaks:
        yield FOR_READERS
        return
    for _ in range(_LONGEST_NAME):
        yield _GLANCE
        if donnie.outlets.audible.is_quiet_within(0):
            break
    yield BETWEEN


# --- SET


def find_setting(typed: str) -> str | None:
    """The field that a name of any language means; ``cues`` for a single cue."""
    folded = fold_name(typed)
    if folded in map(fold_name, (*CUE, "cues")):
        return "cues"
    return next((field for field, (names, _) in SETTINGS.items() if folded in map(fold_name, names)), None)


def tell_settings(donnie: Donnie) -> None:
    for field in SETTINGS:
        _tell_setting(donnie, field)


def set_sound(donnie: Donnie, field: str, typed: str, *, keeps: bool = True) -> None:
    """Change a setting and tell it; without a value that can be understood, tell the choices.

    ``keeps``: for the next time too. Where nobody will speak with it, that is told at once.
    """
    if field == "cues":
        _set_cue(donnie, typed, keeps=keeps)
        return
    value = read_setting(field, typed)
    if value is None:
        _tell_setting(donnie, field)
        _tell_choices(donnie, field)
        return
    donnie.outlets.adjust_sound(**{field: value})
    _tell_setting(donnie, field)
    tell_what_is_missing(donnie, field)
    if keeps:
        _keep(donnie, field, _KEPT_AS[value] if isinstance(value, bool) else value)


def tell_what_is_missing(donnie: Donnie, field: str) -> None:
    """Why what was just chosen is not heard, where it is not."""
    if field in ("speech", "speak", "sound"):
        donnie.tell(*donnie.outlets.audible.notices)


def read_setting(field: str, typed: str) -> str | int | bool | None:
    """The value that a word of any language means, or a number; None for anything else."""
    folded, is_on = fold_name(typed), switched(typed)
    if is_on is not None and field in _SWITCHES:
        return _SWITCHES[field][is_on]
    for value, words in SETTINGS[field][1].items():
        if folded and folded in map(fold_name, (*words, str(value))):
            assert isinstance(value, str | bool)
            return value
    if field not in _READ or not typed:
        return None
    try:
        return _READ[field](typed)
    except (ValueError, OverflowError):
        return None


def _tell_setting(donnie: Donnie, field: str) -> None:
    at, value = _at(donnie), getattr(donnie.outlets.audible.settings, field)
    words = SETTINGS[field][1].get(value)
    spelled = words[at] if words else str(value)
    donnie.say("sound-setting", name=SETTINGS[field][0][at], value=spelled)


def _tell_choices(donnie: Donnie, field: str) -> None:
    if field in _NUMBERS:
        least, most = _NUMBERS[field]
        donnie.say("habit-numbers", least=least, most=most)
    else:
        choices = ", ".join(each[_at(donnie)] for each in SETTINGS[field][1].values())
        donnie.say("habit-choices", choices=choices)


def _set_cue(donnie: Donnie, typed: str, *, keeps: bool) -> None:
    """``bump``, ``bump off`` or ``bump 50``; alone, all of them."""
    word, _, value = typed.partition(" ")
    name = find_cue(word)
    if word and name is None:
        donnie.say("cues-unknown", name=word[:40])
        return
    volume = read_cue_volume(value) if name and value else None
    if name and volume is not None:
        volumes = {**donnie.outlets.audible.settings.cues, name: volume}
        donnie.outlets.adjust_sound(cues=volumes)
        if keeps:
            _keep(donnie, "cues", ", ".join(f"{each} {percent}" for each, percent in volumes.items()))
        chime(donnie, name)
    for each in (name,) if name else CUE_WORDS:
        _tell_cue(donnie, each)
    if value and volume is None:
        _tell_choices(donnie, "volume")


def read_cue_volume(typed: str) -> int | None:
    """In percent: a number, or on and off in any language; None for anything else."""
    is_on = switched(typed)
    if is_on is not None:
        return _LOUD if is_on else _SILENT
    try:
        return read_percent(typed)
    except (ValueError, OverflowError):
        return None


def _tell_cue(donnie: Donnie, name: str) -> None:
    at, percent = _at(donnie), donnie.outlets.audible.settings.cues.get(name, _LOUD)
    value = str(percent) if percent else SWITCH[False][at]
    donnie.say("sound-setting-cue", name=CUE[at], cue=CUE_WORDS[name][at], value=value)


def _keep(donnie: Donnie, key: str, value: str | int) -> None:
    try:
        remember(key, value, os.environ)
    except DocumentError as problem:
        donnie.say(problem.code, path=problem.path, reason=problem.reason)


def _at(donnie: Donnie) -> int:
    return LANGUAGES.index(donnie.words.language)
