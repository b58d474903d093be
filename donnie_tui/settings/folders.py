"""The folders of settings and state (histories, recovery), and announcements of the first start.

Each platform has its own folders; the code that writes into a folder creates it. An empty file in the state
folder records that the tour was offered; the setting ``tour``, off, never offers it. The decision about the
voice is announced again when it changes. The first prompt needs this module, so it loads nothing heavy.
"""

from __future__ import annotations

import os
import sys

from donnie_tui.settings import OFF

TYPE_CHECKING = False  # that of typing costs as much as the rest of the first prompt
if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

SETTINGS_NAME = "settings.toml"
MACHINE_FOLDERS = {"darwin": "/Library/Application Support/donnie", "win32": r"C:\ProgramData\donnie"}
"""The folders of a whole machine's settings, which no variable can change."""
UNSAVED = "unsaved"
"""In the state folder: the folder of copies of unsaved programs."""
BREAKPOINTS = "breakpoints.txt"
"""In the state folder: the breakpoints of each program."""
PROGRESS = "challenges.txt"
"""In the state folder: the progress in challenges."""
UNSAVED_WORLD = "unsaved.world"
RECENT = "recent.txt"
"""In the state folder: the programs that were opened and saved lately."""


_own_folder: str | None = None


def keep_in(folder: str | None) -> None:
    """Keep the learner's settings and state in this folder; None: in those of the account."""
    global _own_folder
    _own_folder = folder


def machine_settings_file(platform: str = sys.platform) -> str:
    """The path of the settings of the whole machine, which only its administrator can change."""
    return f"{MACHINE_FOLDERS.get(platform, '/etc/donnie')}/{SETTINGS_NAME}"


def account_settings_file(environment: Mapping[str, str], platform: str = sys.platform) -> str:
    """The path of the settings file of the account, whether it exists or not."""
    return f"{_folder(environment, platform, 'XDG_CONFIG_HOME', '.config')}/{SETTINGS_NAME}"


def settings_file(environment: Mapping[str, str], platform: str = sys.platform) -> str:
    """The path of the learner's settings file: that of the account, unless the session is confined."""
    return (
        account_settings_file(environment, platform)
        if _own_folder is None
        else f"{_own_folder}/{SETTINGS_NAME}"
    )


def own_sounds(environment: Mapping[str, str], platform: str = sys.platform) -> Path:
    """The account's folder of sounds that replace cues."""
    from pathlib import Path

    return Path(account_settings_file(environment, platform)).parent / "sounds"


def state_path(environment: Mapping[str, str], platform: str = sys.platform) -> str:
    """The state folder: histories, texts to recover."""
    return _own_folder or _folder(environment, platform, "XDG_STATE_HOME", ".local/state")


def _folder(environment: Mapping[str, str], platform: str, variable: str, default: str) -> str:
    """The folder that the variable names. On Linux and the like a relative path counts as none."""
    home = environment.get("HOME") or environment.get("USERPROFILE") or os.curdir
    if platform == "win32":
        return f"{environment.get('APPDATA') or f'{home}/AppData/Roaming'}/donnie"
    if platform == "darwin":
        return f"{home}/Library/Application Support/donnie"
    given = environment.get(variable, "")
    return f"{given if given.startswith('/') else f'{home}/{default}'}/donnie"


def _opened(path: str, flags: int) -> int:
    if _own_folder is None:
        return os.open(path, flags, 0o600)
    from donnie_tui.process.confinement import open_descriptor  # loaded already

    return open_descriptor(path, flags, 0o600)


MARKER = "tour-was-offered"
VOICE_MARKER = "voice-was-announced"


def offers_tour(folder: str, environment: Mapping[str, str]) -> bool:
    """Whether to offer the tour now, which happens once. ``folder``: the state folder."""
    path = f"{folder}/{MARKER}"
    if environment.get("DONNIE_TOUR", "").strip().lower() in OFF or os.path.exists(path):  # noqa: PTH110 -- pathlib is slow to load
        return False
    try:
        os.makedirs(folder, exist_ok=True)  # noqa: PTH103
        os.close(_opened(path, os.O_WRONLY | os.O_CREAT))
    except OSError:  # then it is offered again
        pass
    return True


def is_new_decision(folder: str, decided: str) -> bool:
    """Whether to announce this decision about the voice now; it is announced again when it has changed."""
    path = f"{folder}/{VOICE_MARKER}"
    try:
        with open(path, encoding="utf-8", opener=_opened) as kept:
            if kept.read(len(decided) + 1) == decided:
                return False
    except (OSError, ValueError):
        pass
    try:
        os.makedirs(folder, exist_ok=True)  # noqa: PTH103
        with open(path, "w", encoding="utf-8", opener=_opened) as kept:
            kept.write(decided)
    except OSError:  # then it is announced again
        pass
    return True
