"""Looks around for what ``choose`` wants to know: reads files and the environment, starts nothing.

A few milliseconds: no library is loaded, no process started, one socket of this machine tried. So it
finds what is plausible; what really works is told later by the audio worker. Nothing is looked for before
somebody wants to know it: who is silent starts sooner.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Mapping
from functools import cached_property

from devices.ports.hints import TYPE_CHECKING

if TYPE_CHECKING:
    from devices.speech.dispatcher import Address

_READERS = frozenset({"orca", "fenrir", "yasr", "tdsr", "emacspeak", "speakup"})
"""Readers that speak. BRLTTY alone does not."""

_SYSTEM_READERS = frozenset({"fenrir"})
"""Started by the system for its consoles, so another user's process too."""

_INTERPRETERS = ("python", "perl", "bash", "dash", "sh", "env", "tclsh")

_LIBRARY_FOLDERS = ("/usr/lib", "/usr/lib64", "/lib", "/usr/local/lib", "/opt/homebrew/lib")
_LIBRARIES = ("libespeak-ng.so.1", "libespeak-ng.1.dylib")
_YES = frozenset({"1", "true", "yes", "on"})


class Around:
    """The facts about this process's surroundings, each as it is when it is asked for first."""

    def __init__(
        self, variables: Mapping[str, str], root: str, *, is_linear: bool, has_real_robot: bool
    ) -> None:
        self._variables, self._root = variables, root
        self.is_linear = is_linear
        self.has_real_robot = has_real_robot

    @cached_property
    def stdout_is_terminal(self) -> bool:
        return _stdout_is_terminal()

    @cached_property
    def over_ssh(self) -> bool:
        return is_over_ssh(self._variables)

    @cached_property
    def screen_reader(self) -> str | None:
        return find_screen_reader(self._variables, self._root)

    @cached_property
    def has_voice(self) -> bool:
        return has_voice(self._root)

    @cached_property
    def has_sound_device(self) -> bool:
        return has_sound_device(self._variables, self._root)

    @cached_property
    def has_ssip(self) -> bool:
        from devices.speech.dispatcher import is_reachable

        return is_reachable(ssip_address(self._variables))


def look_around(
    environment: Mapping[str, str] | None = None,
    root: str = "/",
    *,
    is_linear: bool = True,
    has_real_robot: bool = False,
) -> Around:
    """What finds the facts; ``environment`` and ``root`` are for tests."""
    variables = os.environ if environment is None else environment
    return Around(variables, root, is_linear=is_linear, has_real_robot=has_real_robot)


def is_over_ssh(variables: Mapping[str, str]) -> bool:
    """Whether the learner sits at another machine."""
    return bool(variables.get("SSH_CONNECTION") or variables.get("SSH_TTY"))


def ssip_address(variables: Mapping[str, str]) -> Address | None:
    """Where a speech-dispatcher may be that the learner hears: over SSH only one that was brought along."""
    if is_over_ssh(variables) and not variables.get("SPEECHD_ADDRESS"):
        return None
    from devices.speech.dispatcher import find_address

    return find_address(variables)


def find_screen_reader(variables: Mapping[str, str], root: str = "/") -> str | None:
    """The name of a speaking screen reader that runs for this user, or None."""
    if variables.get("DONNIE_READER", "").lower() in _YES:
        return "DONNIE_READER"
    if _speakup_speaks(root):
        return "speakup"
    return next(_running_readers(root), None)


def has_voice(root: str = "/") -> bool:
    """Whether pyttsx3 is installed and finds an espeak-ng library, the system's or the bundled one."""
    from importlib.util import find_spec

    if find_spec("pyttsx3") is None:
        return False
    return find_spec("espeakng_loader") is not None or sys.platform != "linux" or _has_library(root)


def has_sound_device(variables: Mapping[str, str], root: str = "/") -> bool:
    """Whether a sound card or a sound server is plausible. Always true where only trying would tell."""
    if sys.platform != "linux" or variables.get("PULSE_SERVER"):
        return True
    runtime = variables.get("XDG_RUNTIME_DIR")
    servers = (f"{runtime}/{name}" for name in ("pulse/native", "pipewire-0"))
    if runtime and any(map(os.path.exists, servers)):  # pathlib's raises where one may not look
        return True
    return any(
        each.name.startswith("pcmC") and each.name.endswith("p") for each in _entries(f"{root}/dev/snd")
    )


def _stdout_is_terminal() -> bool:
    try:
        return sys.stdout.isatty()
    except (AttributeError, ValueError):  # None without a console, or closed
        return False


def _has_library(root: str) -> bool:
    from pathlib import Path  # slow to load, and the library comes along with most voices

    for folder in _LIBRARY_FOLDERS:
        place = Path(f"{root}{folder}")
        if any((place / name).exists() or any(place.glob(f"*/{name}")) for name in _LIBRARIES):
            return True
    return False


def _speakup_speaks(root: str) -> bool:
    synth = _read(f"{root}/sys/accessibility/speakup/synth").strip()
    return synth not in ("", "none")


def _running_readers(root: str) -> Iterator[str]:
    """All processes are looked at before the first frame: their files are read without detours."""
    own_user = os.getuid() if hasattr(os, "getuid") else -1
    for process in _entries(f"{root}/proc"):
        reader = _reader_in(process.path) if process.name.isdigit() else None
        if reader and (reader in _SYSTEM_READERS or _owner(process.path) == own_user):
            yield reader


def _entries(folder: str) -> list[os.DirEntry[str]]:
    """None where there is no such folder, or where one may not look."""
    try:
        return [*os.scandir(folder)]
    except OSError:
        return []


def _reader_in(process: str) -> str | None:
    """A reader is a program, a script that an interpreter runs, or Emacs with Emacspeak's files."""
    arguments = _read(f"{process}/cmdline").rstrip("\0").split("\0")
    if arguments == [""]:  # a kernel thread, or a process that has just ended
        return None
    found = _READERS & {*_program_names(arguments)} or _READERS & {_read(f"{process}/comm").strip().lower()}
    if found:
        return min(found)
    return "emacspeak" if any("/emacspeak/" in argument for argument in arguments[:6]) else None


def _program_names(arguments: list[str]) -> Iterator[str]:
    """The program's name and, if that is an interpreter, its script's; not the files that it was given."""
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
