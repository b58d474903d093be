"""Linear or full screen: decided once, from what is known at the start, with the cause that is told.

The order: the option, then the variables, then the settings file, then what the terminal is.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping

from devices.ports.values import frozen
from donnie_tui.settings.readers import read_switch


@frozen
class Surroundings:
    """What the process was started in."""

    stdin_is_terminal: bool
    stdout_is_terminal: bool
    environment: Mapping[str, str]
    stderr_is_terminal: bool = True
    """The screen is painted there."""

    @property
    def is_terminal(self) -> bool:
        """A browser is one too: what paints there is named in TEXTUAL_DRIVER."""
        is_browser = bool(self.environment.get("TEXTUAL_DRIVER"))
        return is_browser or (self.stdin_is_terminal and self.stdout_is_terminal and self.stderr_is_terminal)


def surroundings(environment: Mapping[str, str]) -> Surroundings:
    """Those of this process."""
    stdin, stdout, stderr = map(_is_terminal, (sys.stdin, sys.stdout, sys.stderr))
    return Surroundings(stdin, stdout, environment, stderr)


def _is_terminal(stream: object) -> bool:
    try:
        return bool(stream is not None and stream.isatty())  # type: ignore[attr-defined] # a stream, or closed
    except ValueError:
        return False


def cause_of_linear(option: bool | None, configured: bool | None, around: Surroundings) -> str | None:
    """Why the mode is linear, a cause of the greeting; None for the full screen.

    ``option``: True for ``--linear``, False for ``--visual``. A full screen without a terminal is impossible,
    whoever asks for it.
    """
    chosen = _chosen(option, configured, around.environment)
    if chosen and chosen[0]:
        return chosen[1]
    if not around.is_terminal:
        return "no-terminal"
    if chosen is None and around.environment.get("TERM", "") in ("dumb", ""):
        return "simple-terminal"
    return None


def _chosen(
    option: bool | None, configured: bool | None, environment: Mapping[str, str]
) -> tuple[bool, str] | None:
    """What somebody chose, and where; None if nobody did."""
    if option is not None:
        return option, "option"
    variable = _by_variable(environment)
    if variable is not None:
        return variable, "variable"
    return None if configured is None else (configured, "settings")


def _by_variable(environment: Mapping[str, str]) -> bool | None:
    """``DONNIE_LINEAR`` switches on and off, ``ACCESSIBLE`` on only."""
    try:
        return read_switch(environment["DONNIE_LINEAR"])
    except (KeyError, ValueError):
        wanted = environment.get("ACCESSIBLE", "").strip().lower() not in ("", "0", "false")
        return True if wanted else None
