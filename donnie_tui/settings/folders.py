"""Where Donnie keeps what it remembers: settings in one folder, its state (histories, recoveries) in another.

Each platform has its own places. They are named here and made by whoever writes into them. The first
prompt asks whether there are settings before anything heavy is loaded, so this module loads nothing.
"""

from __future__ import annotations

import os
import sys

TYPE_CHECKING = False  # that of typing costs as much as the rest of the first prompt
if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

SETTINGS_NAME = "settings.toml"
UNSAVED = "unsaved"
"""In the state folder: the folder of the copies of what is not saved."""
BREAKPOINTS = "breakpoints.txt"
"""In the state folder: the breakpoints of each program."""


def settings_file(environment: Mapping[str, str], platform: str = sys.platform) -> str:
    """The path of the settings file, whether it exists or not."""
    return f"{_folder(environment, platform, 'XDG_CONFIG_HOME', '.config')}/{SETTINGS_NAME}"


def own_sounds(environment: Mapping[str, str], platform: str = sys.platform) -> Path:
    """The folder in which learners put sounds of their own in the place of cues."""
    from pathlib import Path

    return Path(settings_file(environment, platform)).parent / "sounds"


def state_folder(environment: Mapping[str, str], platform: str = sys.platform) -> Path:
    """The folder of what the learner did last: histories, texts to recover."""
    from pathlib import Path

    return Path(state_path(environment, platform))


def state_path(environment: Mapping[str, str], platform: str = sys.platform) -> str:
    """The same as text."""
    return _folder(environment, platform, "XDG_STATE_HOME", ".local/state")


def _folder(environment: Mapping[str, str], platform: str, variable: str, default: str) -> str:
    """On Linux and the like a relative path in the variable is to be ignored."""
    home = environment.get("HOME") or environment.get("USERPROFILE") or os.curdir
    if platform == "win32":
        return f"{environment.get('APPDATA') or f'{home}/AppData/Roaming'}/donnie"
    if platform == "darwin":
        return f"{home}/Library/Application Support/donnie"
    given = environment.get(variable, "")
    return f"{given if given.startswith('/') else f'{home}/{default}'}/donnie"
