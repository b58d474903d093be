"""``donnie doctor``: checks the installation and says how to repair it, a line a finding.

It checks packages, terminal, screen reader, speech, sound, serial ports, camera and settings, and changes
nothing. A finding is a code with values. One that is not well has a remedy: the sentence ``CODE-remedy``,
unless it names another.
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

from msgspec import Struct, field

import donnie_tui
from devices.audio.channel import Channel, DetectedEnvironment, choose_channel
from devices.audio.cues import load_user_sounds, unknown_sound_files
from donnie_tui.cli.front_end import cause_of_linear, process_environment
from donnie_tui.cli.options import ExitCode, Order
from donnie_tui.cli.streams import is_terminal
from donnie_tui.core.program_files import exists
from donnie_tui.core.wording import name_of_language
from donnie_tui.i18n.translations import missing_in, mistakes
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.outlets.audible import spoken_languages, wants_cues
from donnie_tui.process.confinement import confinement
from donnie_tui.settings.folders import own_sounds, settings_file
from donnie_tui.settings.settings import KEYS, Settings, SettingSource
from donnie_tui.world.loading import choose_world
from language import keywords
from language.locales import languages
from language.source import quoted

if TYPE_CHECKING:
    from devices.serial_ports import FoundPort


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
_MOST_MISSING = 20
"""Missing texts that are named."""


class Finding(Struct, frozen=True):
    """One line. ``code`` names its sentence, and ``code-remedy`` the one after it if something is wrong."""

    code: str
    values: Mapping[str, object] = field(default_factory=dict)
    is_well: bool = True
    remedy: str = ""
    """The code of the remedy, where it is another."""


def well(code: str, **values: object) -> Finding:
    return Finding(code, values)


def amiss(code: str, **values: object) -> Finding:
    return Finding(code, values, is_well=False)


def examine(
    settings: Settings, environment: Mapping[str, str], cause_of_linear: str | None
) -> Iterator[Finding]:
    """All findings, one after the other. ``cause_of_linear`` as ``front_end`` has it."""
    python = ".".join(map(str, sys.version_info[:3]))
    yield well("doctor-version", version=donnie_tui.__version__, python=python)
    yield from look_at_packages()
    yield from look_at_languages(settings.language)
    yield from look_at_terminal(environment, cause_of_linear)
    yield from look_at_speech(settings, cause_of_linear is not None)
    yield from look_at_own_sounds(own_sounds(environment))
    yield from look_at_ports()
    yield from look_at_chosen_ports(settings)
    yield from look_at_reset(settings)
    yield from look_at_camera(settings)
    yield from look_at_settings(settings, environment)
    yield from look_at_world(settings)


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


# --- languages


def look_at_languages(spoken: str) -> Iterator[Finding]:
    """Which languages there are, what is missing in them, and what is wrong in their files."""
    names = {each: name_of_language(each, spoken) for each in languages()}
    yield well("doctor-languages", names=", ".join(names.values()))
    for mistake in mistakes():
        yield amiss("doctor-language-wrong", what=mistake)
    for language, name in names.items():
        missing = missing_in(language)
        if missing:
            listed = ", ".join((*missing[:_MOST_MISSING], *(["…"] if len(missing) > _MOST_MISSING else [])))
            yield amiss("doctor-language-missing", language=name, count=len(missing), names=listed)


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
    """The screen reader, the voice and why it was chosen; the voice is really started."""
    facts = DetectedEnvironment(is_linear=is_linear, has_real_robot=settings.robot.startswith("serial"))
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
    yield from look_at_worker(settings.language)
    yield well("doctor-cues" if wants_cues(settings, facts) else "doctor-no-cues")


def look_at_worker(spoken: str) -> Iterator[Finding]:
    """Start the audio worker silently, and report the device and the voices that it found."""
    from devices.audio.service import AudioService, AudioSettings
    from devices.ports.audio import AudioNotice

    notices: list[AudioNotice] = []
    audio = AudioService(AudioSettings(languages=spoken_languages()), notices.append)
    try:
        audio.warm_up()
        is_settled = audio.wait_until_ready(_WORKER_SECONDS)
        player, found = audio.player, audio.languages
    finally:
        audio.close()
    if not is_settled:
        yield amiss("doctor-worker-hangs", seconds=round(_WORKER_SECONDS))
        return
    yield well("doctor-player", name=player) if player else amiss("doctor-no-player")
    yield from _voices(found, spoken) if player else ()


def _voices(found: tuple[str, ...], spoken: str) -> Iterator[Finding]:
    if not found:
        yield amiss("doctor-no-voice")
    for language in languages() if found else ():
        name = name_of_language(language, spoken)
        has_voice = language in found
        yield (
            well("doctor-voice", language=name) if has_voice else amiss("doctor-voice-missing", language=name)
        )


def look_at_own_sounds(folder: Path) -> Iterator[Finding]:
    own, broken = load_user_sounds(folder)
    if own:
        yield well("doctor-own-sounds", count=len(own), names=", ".join(sorted(own)))
    for name in broken:
        yield amiss("doctor-own-sound-broken", name=name)
    for name in unknown_sound_files(folder):
        yield amiss("doctor-own-sound-unknown", name=name)


# --- serial ports


def look_at_ports(found: Callable[[], tuple[FoundPort, ...]] | None = None) -> Iterator[Finding]:
    """Which ports are plugged in and whether we may use them; ``donnie devices`` identifies the devices."""
    from devices.serial_ports import group_of, list_ports

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
    from devices.serial_ports import is_named, is_same_port, list_ports

    kind, _, port = settings.robot.partition(":")
    chosen = {"robot": port if kind == "serial" else "", "belt": settings.belt or ""}
    for setting, port in chosen.items():
        if not (port and is_named(port)) or "://" in port or os.path.exists(port):  # noqa: PTH110 -- any text may stand there
            continue
        if not any(is_same_port(port, each.device) for each in (found or list_ports)()):
            yield amiss("doctor-nothing-there", port=quoted(port), setting=setting)


def look_at_reset(settings: Settings, reset: Callable[[str, str], object] | None = None) -> Iterator[Finding]:
    """Whether the pin that restarts the robot's board can be driven, where a pin does that."""
    from devices.board_reset import GpioReset, reset_of

    kind, _, port = settings.robot.partition(":")
    line = (reset or reset_of)(settings.reset_line, port) if kind == "serial" else None
    if not isinstance(line, GpioReset):
        return
    fault = line.fault()
    if fault is None:
        yield well("doctor-reset", pin=line.pin)
    else:
        yield amiss(f"doctor-reset-{fault.value}", pin=line.pin)


def look_at_camera(settings: Settings) -> Iterator[Finding]:
    """Whether the camera of the settings gives a picture, and the colours that are looked for in it."""
    from devices.ports.robot import RobotProblem
    from donnie_tui.robot.connection import make_camera

    camera = make_camera(settings)
    if camera is None:
        return
    try:
        camera.look(camera.directions()[0])
    except RobotProblem as problem:
        remedy = "doctor-opencv-remedy" if problem.code == "no-opencv" else "doctor-camera-remedy"
        yield Finding(f"problem-{problem.code}", problem.values, is_well=False, remedy=remedy)
    else:
        named = [
            keywords.argument_spelling(each, settings.language).lower() for each in sorted(camera.colours)
        ]
        yield well("doctor-camera", camera=settings.camera, colours=", ".join(named))
    finally:
        camera.close()


# --- settings


def look_at_settings(settings: Settings, environment: Mapping[str, str]) -> Iterator[Finding]:
    """Where the file is, and every setting that is not a default, with its source; the limits come first."""
    limits = confinement()
    if limits is not None:
        yield well("doctor-confined", folder=limits.folder)
    path = settings_file(environment)
    yield well("doctor-settings-file" if exists(Path(path)) else "doctor-no-settings-file", path=path)
    for key in KEYS:
        source = settings.source_of(key.name)
        if source is not SettingSource.DEFAULT:
            value = (
                environment.get(key.variable, "")
                if source is SettingSource.ENVIRONMENT
                else getattr(settings, key.name)
            )
            yield well(
                f"doctor-setting-{source.value}", key=key.key, variable=key.variable, value=_short(value)
            )


def look_at_world(settings: Settings) -> Iterator[Finding]:
    """Why the chosen world can't be used, if that is so: Donnie would not start."""
    if settings.source_of("world") is SettingSource.DEFAULT:
        return
    try:
        choose_world(settings.world, Words(settings.language), settings.include_folders)
    except Unusable as unusable:
        yield amiss("doctor-world", reason=unusable.sentence)


def _short(value: object) -> str:
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, tuple):
        value = os.pathsep.join(map(str, value))
    if isinstance(value, Mapping):
        value = ", ".join(f"{name} {each}" for name, each in value.items())
    return "max" if value is None else quoted(str(value))


def doctor(order: Order) -> int:
    """Print each finding as it is made. The exit code is 0, whatever was found."""
    problems = 0
    cause = cause_of_linear(None, order.settings.linear, process_environment(order.environment))
    for finding in examine(order.settings, order.environment, cause):
        for line in _lines(finding, order.words):
            order.output.line(line)
        problems += not finding.is_well
    order.output.line(
        order.words("doctor-problems", count=problems) if problems else order.words("doctor-all-well")
    )
    return ExitCode.DONE


def _lines(finding: Finding, words: Words) -> tuple[str, ...]:
    text = words(finding.code, **finding.values)
    if finding.is_well:
        return (text,)
    remedy = words(finding.remedy or f"{finding.code}-remedy", **finding.values)
    return words("doctor-problem", text=text), words("doctor-remedy", text=remedy)
