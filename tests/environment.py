"""The environment of the tests: the same on every machine and for every person."""

from __future__ import annotations

import os
from pathlib import Path

_CLEARED = (
    # what a person chooses
    "DONNIE_", "LC_", "LANG", "XDG_", "STAGEPATH", "EDITOR", "VISUAL", "PAGER", "LESS", "INPUTRC",
    # the terminal and the way to it
    "TEXTUAL", "NO_COLOR", "FORCE_COLOR", "CLICOLOR", "COLORTERM", "COLUMNS", "LINES", "TERM_", "VTE_",
    "TMUX", "STY", "SSH_",
    # voices and sound
    "SPEECHD_", "PULSE_", "PIPEWIRE_", "ALSA_",
    # Python: a start that compiles every module again takes four times as long
    "PYTHONDONTWRITEBYTECODE", "PYTHONUNBUFFERED", "PYTHONUTF8", "PYTHONIOENCODING", "PYTHONWARNINGS",
)  # fmt: skip
"""Variables, by the beginning of their names, that Donnie or one of its libraries reads."""

CHOSEN = {
    "LANG": "C.UTF-8",
    "TERM": "xterm-256color",
    "DONNIE_ROBOT_TIMEOUTS": "20",  # a board that is simulated here may have to wait for its turn
    "DONNIE_WORLD": "open_floor",  # of every command that names no other
    "DONNIE_READER": "off",  # one may run on this machine, and others are started by the tests of readers
}
"""What every test begins with; it chooses the rest itself."""


def isolate() -> None:
    """Clears this process's environment; its children inherit what is left."""
    for name in [each for each in os.environ if each.startswith(_CLEARED)]:
        del os.environ[name]
    os.environ.update(CHOSEN)


def of_a_process(folder: Path, **changes: str) -> dict[str, str]:
    """For a process whose settings and state are kept in ``folder``, and that offers no tour."""
    return {
        **os.environ,
        "XDG_CONFIG_HOME": str(folder / "config"),
        "XDG_STATE_HOME": str(folder / "state"),
        "LC_ALL": "C.UTF-8",
        "DONNIE_TOUR": "off",
        **changes,
    }
