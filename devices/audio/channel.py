"""Which channel an utterance takes: print only, speech-dispatcher, or Donnie's own voice.

``choose_channel`` decides, by codes; their sentences are i18n's. What the learner asks for overrides the
guess, but not what is possible: without a voice or a sound device everything is only printed, and the reason
is reported.

``DetectedEnvironment`` finds the facts that the choice needs, in a few milliseconds and only when one is
asked for: a silent Donnie starts sooner. It reads files and the environment and tries one socket of this
machine. It loads no library and starts no process. So it finds what is plausible; the audio worker reports
what really works.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Mapping
from enum import Enum
from functools import cached_property
from typing import TYPE_CHECKING

from msgspec import Struct

if TYPE_CHECKING:
    from devices.audio.ssip import SsipAddress


class Channel(Enum):
    """How an utterance reaches the learner. It is printed in any case."""

    TEXT = "text"
    SSIP = "ssip"
    TTS = "tts"


class ChannelReason(Enum):
    """Why this channel."""

    ASKED_FOR = "asked-for"
    """The learner chose it."""
    NOT_A_TERMINAL = "not-a-terminal"
    OVER_SSH = "over-ssh"
    """The remote machine's loudspeaker would be the wrong one."""
    SCREEN_READER = "screen-reader"
    """A screen reader reads what is printed, so Donnie is silent."""
    READERS_VOICE = "readers-voice"
    """A screen reader runs, but can't follow a full screen: Donnie's sentences follow its own in
    speech-dispatcher."""
    SPEECH_DISPATCHER = "speech-dispatcher"
    """It is there, so it speaks; also at the learner's machine, where SSH forwards its socket."""
    NO_SPEECH_DISPATCHER = "no-speech-dispatcher"
    OWN_VOICE = "own-voice"
    NO_VOICE = "no-voice"
    NO_SOUND_DEVICE = "no-sound-device"


class SpeechOption(Enum):
    """What the learner asks for, as ``--speech`` writes it."""

    AUTO = "auto"
    OFF = "off"
    TEXT = "text"
    SSIP = "ssip"
    TTS = "tts"
    ROBOT = "robot"
    """Only SPEAK is spoken, at the robot; answers are printed."""


class SpeakPlace(Enum):
    """Where the words of SPEAK are spoken."""

    HERE = "here"
    """By the channel of the answers."""
    ROBOT = "robot"
    """By the voice of the machine that runs Donnie: over SSH that is the robot's laptop."""
    BOTH = "both"


class ChosenChannel(Struct, frozen=True):
    """A channel, and why."""

    channel: Channel
    reason: ChannelReason
    speak: SpeakPlace = SpeakPlace.HERE
    """Where SPEAK is spoken."""


def choose_channel(
    wanted: SpeechOption | str, facts: DetectedEnvironment, place: SpeakPlace | str = SpeakPlace.HERE
) -> ChosenChannel:
    """Choose. ``wanted`` and ``place`` are given as members or by their values; ``ValueError`` for others."""
    option, place = SpeechOption(wanted), SpeakPlace(place)
    answers = _channel_of_answers(option, facts)
    return ChosenChannel(
        answers.channel, answers.reason, _place_of_speak(option, facts, place, answers.channel)
    )


def _channel_of_answers(option: SpeechOption, facts: DetectedEnvironment) -> ChosenChannel:
    match option:
        case SpeechOption.OFF | SpeechOption.TEXT | SpeechOption.ROBOT:
            return ChosenChannel(Channel.TEXT, ChannelReason.ASKED_FOR)
        case SpeechOption.SSIP:
            return _ssip(facts)
        case SpeechOption.TTS:
            return _own_voice(facts, ChannelReason.ASKED_FOR)
        case SpeechOption.AUTO:
            return _guessed(facts)


def _guessed(facts: DetectedEnvironment) -> ChosenChannel:
    if not facts.stdout_is_terminal:
        return ChosenChannel(Channel.TEXT, ChannelReason.NOT_A_TERMINAL)
    if facts.over_ssh and not facts.has_ssip:
        return ChosenChannel(Channel.TEXT, ChannelReason.OVER_SSH)
    if facts.screen_reader is not None and (facts.is_linear or not facts.has_ssip):
        return ChosenChannel(Channel.TEXT, ChannelReason.SCREEN_READER)
    if facts.has_ssip:
        with_reader = facts.screen_reader is not None
        reason = ChannelReason.READERS_VOICE if with_reader else ChannelReason.SPEECH_DISPATCHER
        return ChosenChannel(Channel.SSIP, reason)
    return _own_voice(facts, ChannelReason.OWN_VOICE)


def _ssip(facts: DetectedEnvironment) -> ChosenChannel:
    if facts.has_ssip:
        return ChosenChannel(Channel.SSIP, ChannelReason.ASKED_FOR)
    return ChosenChannel(Channel.TEXT, ChannelReason.NO_SPEECH_DISPATCHER)


def _own_voice(facts: DetectedEnvironment, reason: ChannelReason) -> ChosenChannel:
    if not facts.has_voice:
        return ChosenChannel(Channel.TEXT, ChannelReason.NO_VOICE)
    if not facts.has_sound_device:
        return ChosenChannel(Channel.TEXT, ChannelReason.NO_SOUND_DEVICE)
    return ChosenChannel(Channel.TTS, reason)


def _place_of_speak(
    option: SpeechOption, facts: DetectedEnvironment, place: SpeakPlace, channel: Channel
) -> SpeakPlace:
    if option is SpeechOption.OFF or channel is Channel.TTS:  # silent, or the same voice
        return SpeakPlace.HERE
    if not (facts.has_voice and facts.has_sound_device):
        return SpeakPlace.HERE
    is_remote = option is SpeechOption.AUTO and facts.over_ssh and facts.has_real_robot
    if option is SpeechOption.ROBOT or (is_remote and place is SpeakPlace.HERE):
        return SpeakPlace.ROBOT
    return place


_READERS = frozenset({"orca", "fenrir", "yasr", "tdsr", "emacspeak", "speakup"})
"""Readers that speak. BRLTTY alone doesn't."""

_SYSTEM_READERS = frozenset({"fenrir"})
"""Started by the system for its consoles, so it may belong to another user."""

_INTERPRETERS = ("python", "perl", "bash", "dash", "sh", "env", "tclsh")

_LIBRARY_FOLDERS = ("/usr/lib", "/usr/lib64", "/lib", "/usr/local/lib", "/opt/homebrew/lib")
_LIBRARIES = ("libespeak-ng.so.1", "libespeak-ng.1.dylib")
_YES = frozenset({"1", "true", "yes", "on"})
_NO = frozenset({"0", "false", "no", "off"})


class DetectedEnvironment:
    """The facts about this process, each found when it is first asked for."""

    def __init__(
        self,
        variables: Mapping[str, str] | None = None,
        root: str = "",
        *,
        is_linear: bool = True,
        has_real_robot: bool = False,
    ) -> None:
        """``is_linear``: output is printed in lines, which a screen reader reads by itself. ``variables`` and
        ``root`` are for tests."""
        self._variables = os.environ if variables is None else variables
        self._root = root
        self.is_linear = is_linear
        self.has_real_robot = has_real_robot

    @cached_property
    def stdout_is_terminal(self) -> bool:
        try:
            return sys.stdout.isatty()
        except (AttributeError, ValueError):  # None without a console, or closed
            return False

    @cached_property
    def over_ssh(self) -> bool:
        return is_over_ssh(self._variables)

    @cached_property
    def screen_reader(self) -> str | None:
        """Its name, such as ``orca``, or None if none was found; one may run unnoticed all the same."""
        return find_screen_reader(self._variables, self._root)

    @cached_property
    def has_voice(self) -> bool:
        """Whether pyttsx3 is installed and finds an espeak-ng library, the system's or the bundled one."""
        from importlib.util import find_spec

        if find_spec("pyttsx3") is None:
            return False
        has_bundled = find_spec("espeakng_loader") is not None
        return has_bundled or sys.platform != "linux" or _has_library(self._root)

    @cached_property
    def has_sound_device(self) -> bool:
        """Whether a sound card or a sound server is plausible. True if only a trial could show it."""
        if sys.platform != "linux" or self._variables.get("PULSE_SERVER"):
            return True
        runtime = self._variables.get("XDG_RUNTIME_DIR")
        servers = (f"{runtime}/{name}" for name in ("pulse/native", "pipewire-0"))
        if runtime and any(map(os.path.exists, servers)):  # pathlib's raises in a folder without permission
            return True
        cards = _entries(f"{self._root}/dev/snd")
        return any(each.name.startswith("pcmC") and each.name.endswith("p") for each in cards)

    @cached_property
    def has_ssip(self) -> bool:
        """Whether a speech-dispatcher that reaches the learner accepts a connection."""
        from devices.audio.ssip import is_reachable

        return is_reachable(ssip_address(self._variables))


def is_over_ssh(variables: Mapping[str, str]) -> bool:
    """Whether the learner sits at another machine."""
    return bool(variables.get("SSH_CONNECTION") or variables.get("SSH_TTY"))


def ssip_address(variables: Mapping[str, str]) -> SsipAddress | None:
    """The speech-dispatcher that may reach the learner: over SSH only one whose socket was forwarded."""
    if is_over_ssh(variables) and not variables.get("SPEECHD_ADDRESS"):
        return None
    from devices.audio.ssip import find_address

    return find_address(variables)


def find_screen_reader(variables: Mapping[str, str], root: str = "") -> str | None:
    """The name of a speaking screen reader that runs for this user, or None.

    A yes or a no in ``DONNIE_READER`` decides alone; no process is looked at then.
    """
    answer = variables.get("DONNIE_READER", "").strip().lower()
    if answer in _YES:
        return "DONNIE_READER"
    if answer in _NO:
        return None
    if _speakup_speaks(root):
        return "speakup"
    return next(_running_readers(root), None)


def _has_library(root: str) -> bool:
    from pathlib import Path  # slow to load, and most voices come with espeakng-loader

    for folder in _LIBRARY_FOLDERS:
        place = Path(f"{root}{folder}")
        if any((place / name).exists() or any(place.glob(f"*/{name}")) for name in _LIBRARIES):
            return True
    return False


def _speakup_speaks(root: str) -> bool:
    synth = _read(f"{root}/sys/accessibility/speakup/synth").strip()
    return synth not in ("", "none")


def _running_readers(root: str) -> Iterator[str]:
    """Looks at all processes before the first frame, so it reads their files directly."""
    own_user = os.getuid() if hasattr(os, "getuid") else -1
    for process in _entries(f"{root}/proc"):
        reader = _reader_in(process.path) if process.name.isdigit() else None
        if reader and (reader in _SYSTEM_READERS or _owner(process.path) == own_user):
            yield reader


def _entries(folder: str) -> list[os.DirEntry[str]]:
    """Empty if there is no such folder, or no permission."""
    try:
        return [*os.scandir(folder)]
    except OSError:
        return []


def _reader_in(process: str) -> str | None:
    """A reader is a program, a script that an interpreter runs, or Emacs with Emacspeak's files."""
    arguments = _read(f"{process}/cmdline").split("\0")
    if arguments == [""]:  # a kernel thread, or a process that has just ended
        return None
    found = _READERS & {*_program_names(arguments)} or _READERS & {_read(f"{process}/comm").strip().lower()}
    if found:
        return min(found)
    return "emacspeak" if any("/emacspeak/" in argument for argument in arguments[:6]) else None


def _program_names(arguments: list[str]) -> Iterator[str]:
    """The name of the program and, if that is an interpreter, of its script; not of the files given to it."""
    program = _bare_name(arguments[0])
    yield program
    if program.startswith(_INTERPRETERS):
        yield from [_bare_name(argument) for argument in arguments[1:] if not argument.startswith("-")][:1]


def _bare_name(path: str) -> str:
    return path.rpartition("/")[2].lower().removesuffix(".py")


def _owner(process: str) -> int | None:
    try:
        return os.stat(process).st_uid  # noqa: PTH116 -- as above
    except OSError:
        return None


def _read(path: str) -> str:
    try:
        file = os.open(path, os.O_RDONLY)
        try:
            return os.read(file, 4096).decode("utf-8", "replace")
        finally:
            os.close(file)
    except OSError:
        return ""
