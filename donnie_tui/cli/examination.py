"""What ``donnie doctor`` looks at: packages, terminal, reader, speech, sound, serial ports, settings.

Each look gives findings, codes with values; nothing is changed by looking. A finding that is not well has a
remedy, the sentence ``CODE-remedy``.
"""

from __future__ import annotations

import importlib.util
import os
import shutil
import sys
from collections.abc import Callable, Iterator, Mapping
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import TYPE_CHECKING

import donnie_tui
from devices.ports.values import Frozen, field
from devices.sound.own_sounds import load, unknown_names
from devices.speech.choose import Channel, choose_channel
from devices.speech.probe import look_around
from devices.speech.voices import LANGUAGES
from donnie_tui.cli.front_ends import is_terminal
from donnie_tui.core.documents import exists
from donnie_tui.outlets.audible import wants_cues
from donnie_tui.settings.chosen import Settings, Source
from donnie_tui.settings.folders import own_sounds, settings_file
from donnie_tui.settings.keys import KEYS

if TYPE_CHECKING:
    from devices.port_listing import FoundPort

PACKAGES = (
    "textual",
    "rich",
    "lark",
    "pymunk",
    "pillow",
    "pyserial",
    "pyttsx3",
    "miniaudio",
    "espeakng-loader",
)
OPTIONAL = ("miniaudio", "espeakng-loader", "pyttsx3")
"""Without these everything works, in print."""

OUR_ROOMS = ("language", "sim", "devices", "worlds")

SMALLEST = (40, 12)
"""Columns and rows that the full screen needs."""

_ROOT = Path(donnie_tui.__file__).resolve().parent.parent
_WORKER_SECONDS = 12.0


class Finding(Frozen):
    """One line. ``code`` names its sentence, and ``code-remedy`` the one behind it if something is wrong."""

    code: str
    values: Mapping[str, object] = field(default_factory=dict)
    is_well: bool = True


def well(code: str, **values: object) -> Finding:
    return Finding(code, values)


def amiss(code: str, **values: object) -> Finding:
    return Finding(code, values, is_well=False)


def examine(
    settings: Settings, environment: Mapping[str, str], cause_of_linear: str | None
) -> Iterator[Finding]:
    """All looks, one after the other. ``cause_of_linear`` as ``front_ends`` has it."""
    python = ".".join(map(str, sys.version_info[:3]))
    yield well("doctor-version", version=donnie_tui.__version__, python=python)
    yield from look_at_packages()
    yield from look_at_terminal(environment, cause_of_linear)
    yield from look_at_speech(settings, cause_of_linear is not None)
    yield from look_at_own_sounds(own_sounds(environment))
    yield from look_at_ports()
    yield from look_at_chosen_ports(settings)
    yield from look_at_reset(settings)
    yield from look_at_settings(settings, environment)


# --- packages


def look_at_packages() -> Iterator[Finding]:
    """What is installed, and whether a package of the same name as one of our rooms hides it."""
    missing = [name for name in PACKAGES if _version_of(name) is None]
    for name in missing:
        yield amiss("doctor-package-optional" if name in OPTIONAL else "doctor-package-missing", name=name)
    for room in OUR_ROOMS:
        place = _place_of(room)
        if place is not None and place.parent != _ROOT:
            yield amiss("doctor-shadowed", name=room, place=place)
    if not missing:
        yield well("doctor-packages", count=len(PACKAGES))


def _version_of(name: str) -> str | None:
    try:
        return version(name)
    except PackageNotFoundError:
        return None


def _place_of(room: str) -> Path | None:
    spec = importlib.util.find_spec(room)
    return Path(spec.origin).resolve().parent if spec and spec.origin else None


# --- terminal


def look_at_terminal(environment: Mapping[str, str], cause_of_linear: str | None) -> Iterator[Finding]:
    columns, rows = shutil.get_terminal_size((0, 0))
    name = environment.get("TERM") or "-"
    if not (is_terminal(sys.stdin) and is_terminal(sys.stdout)):
        yield well("doctor-no-terminal")
    elif columns < SMALLEST[0] or rows < SMALLEST[1]:
        yield amiss("doctor-terminal-small", name=name, columns=columns, rows=rows)
    else:
        yield well("doctor-terminal", name=name, columns=columns, rows=rows)
    encoding = (getattr(sys.stdout, "encoding", None) or "?").lower()
    if encoding.replace("-", "") not in ("utf8", "utf8sig"):
        yield amiss("doctor-encoding", encoding=encoding)
    if environment.get("NO_COLOR"):
        yield well("doctor-no-colour")
    yield well(f"doctor-mode-{cause_of_linear or 'visual'}")


# --- speech and sound


def look_at_speech(settings: Settings, is_linear: bool) -> Iterator[Finding]:
    """Who reads, who speaks, why, and what the voice can do: it is really started."""
    facts = look_around(is_linear=is_linear, has_real_robot=settings.robot.startswith("serial"))
    if facts.screen_reader is None:
        yield well("doctor-no-reader")
    else:
        yield well("doctor-reader", name=facts.screen_reader)
    if facts.over_ssh:
        yield well("doctor-over-ssh")
    yield well("doctor-ssip" if facts.has_ssip else "doctor-no-ssip")
    choice = choose_channel(settings.speech, facts, settings.speak)
    is_as_asked = choice.channel is not Channel.TEXT or settings.speech not in ("tts", "ssip")
    code = f"doctor-channel-{choice.channel.value}-{choice.reason.value}"
    yield well(code) if is_as_asked else amiss(code)
    yield well(f"doctor-speak-{choice.speak.value}")
    yield from look_at_worker()
    yield well("doctor-cues" if wants_cues(settings, facts) else "doctor-no-cues")


def look_at_worker() -> Iterator[Finding]:
    """Start the audio worker, silently, and tell which device and which voices it found."""
    from devices.audio_worker.factory import make_audio
    from devices.audio_worker.notices import AudioNotice
    from devices.audio_worker.service import AudioSettings

    notices: list[AudioNotice] = []
    audio = make_audio(AudioSettings(), notices.append)
    try:
        audio.warm_up()
        is_settled = audio.wait_until_ready(_WORKER_SECONDS)
        player, languages = audio.player, audio.languages
    finally:
        audio.close()
    if not is_settled:
        yield amiss("doctor-worker-hangs", seconds=round(_WORKER_SECONDS))
        return
    yield well("doctor-player", name=player) if player else amiss("doctor-no-player")
    yield from _voices(languages) if player else ()


def _voices(languages: tuple[str, ...]) -> Iterator[Finding]:
    if not languages:
        yield amiss("doctor-no-voice")
    for language in LANGUAGES if languages else ():
        code = f"doctor-voice-{language}"
        yield well(code) if language in languages else amiss(f"{code}-missing")


def look_at_own_sounds(folder: Path) -> Iterator[Finding]:
    own, broken = load(folder)
    if own:
        yield well("doctor-own-sounds", count=len(own), names=", ".join(sorted(own)))
    for name in broken:
        yield amiss("doctor-own-sound-broken", name=name)
    for name in unknown_names(folder):
        yield amiss("doctor-own-sound-unknown", name=name)


# --- serial ports


def look_at_ports(found: Callable[[], tuple[FoundPort, ...]] | None = None) -> Iterator[Finding]:
    """Which are plugged in and whether we may use them; ``donnie devices`` asks who is there."""
    from devices.port_listing import list_ports
    from devices.serial_port import group_of

    ports = (found or list_ports)()
    for port in ports:
        if os.access(port.device, os.R_OK | os.W_OK):
            yield well("doctor-port-board" if port.is_board else "doctor-port", port=port.stable)
        elif (group := group_of(port.device)) is not None:
            yield amiss("doctor-port-forbidden", port=port.stable, group=group)
        else:
            yield amiss("doctor-port-closed", port=port.stable)
    if not ports:
        yield well("doctor-no-ports")


def look_at_chosen_ports(
    settings: Settings, found: Callable[[], tuple[FoundPort, ...]] | None = None
) -> Iterator[Finding]:
    """Whether there is something where the robot and the belt are said to be; not of ports with addresses."""
    from devices.port_listing import list_ports
    from devices.serial_port import is_same_port

    chosen = {"robot": settings.robot.partition(":")[2], "belt": settings.belt or ""}
    for setting, port in chosen.items():
        if not port or "://" in port or os.path.exists(port):  # noqa: PTH110 -- any text may stand there
            continue
        if not any(is_same_port(port, each.device) for each in (found or list_ports)()):
            yield amiss("doctor-nothing-there", port=port[:40], setting=setting)


def look_at_reset(settings: Settings, reset: Callable[[str, str], object] | None = None) -> Iterator[Finding]:
    """Whether the pin that restarts the robot's board can be driven, where a pin does that."""
    from devices.reset_line import GpioReset, reset_of

    kind, _, port = settings.robot.partition(":")
    line = (reset or reset_of)(settings.reset_line, port) if kind == "serial" else None
    if not isinstance(line, GpioReset):
        return
    fault = line.fault()
    if fault is None:
        yield well("doctor-reset", pin=line.pin)
    else:
        yield amiss(f"doctor-reset-{fault.value}", pin=line.pin)


# --- settings


def look_at_settings(settings: Settings, environment: Mapping[str, str]) -> Iterator[Finding]:
    """Where the file is, and every setting that is not a default, with who won."""
    path = settings_file(environment)
    yield well("doctor-settings-file" if exists(Path(path)) else "doctor-no-settings-file", path=path)
    for key in KEYS:
        source = settings.source_of(key.name)
        if source is not Source.DEFAULT:
            told = (
                environment.get(key.variable, "")
                if source is Source.ENVIRONMENT
                else getattr(settings, key.name)
            )
            yield well(
                f"doctor-setting-{source.value}", key=key.key, variable=key.variable, value=_short(told)
            )


def _short(value: object) -> str:
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, Mapping):
        value = ", ".join(f"{name} {each}" for name, each in value.items())
    return "max" if value is None else str(value)[:40]
