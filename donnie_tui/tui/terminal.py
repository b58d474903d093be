"""What the terminal is asked for, decided before Textual is loaded: it reads its own switches then.

Plain is for those who listen: one column, and nothing that a screen reader would say without need.
"""

from __future__ import annotations

import os
from collections.abc import MutableMapping
from functools import cache
from typing import Protocol, cast

from donnie_tui.settings.chosen import Settings


def is_plain(settings: Settings) -> bool:
    """As it was chosen; where nothing was, plain if a screen reader runs."""
    if settings.plain is not None:
        return settings.plain
    return _is_listened_to()


@cache
def _is_listened_to() -> bool:
    """Looked up once: it is asked three times before the first frame, and all processes are looked at."""
    from devices.speech.probe import find_screen_reader

    return find_screen_reader(os.environ) is not None


_WITHOUT_KEY_REPORTS = ("linux", "vt", "screen", "tmux")
"""How the names of terminals begin that have never heard of key reports: some show a letter instead."""


def prepare(settings: Settings, environment: MutableMapping[str, str] = os.environ) -> None:
    """No key reports or mouse pixels that only some terminals know; before Textual is imported."""
    environment.setdefault("TEXTUAL_SMOOTH_SCROLL", "0")
    environment.setdefault("TEXTUAL_ANIMATIONS", "none")
    if is_plain(settings) or environment.get("TERM", "").startswith(_WITHOUT_KEY_REPORTS):
        environment.setdefault("TEXTUAL_DISABLE_KITTY_KEY", "1")


def wants_mouse(settings: Settings) -> bool:
    """Mouse reports cost bytes over SSH and take the terminal's own selection; a reader needs neither."""
    return settings.mouse and not is_plain(settings)


class _Driver(Protocol):
    """What Textual's drivers for terminals have; a test guards the names."""

    _mouse: bool

    def _enable_mouse_support(self) -> None: ...

    def _disable_mouse_support(self) -> None: ...


def use_mouse(driver: object, *, wanted: bool) -> None:
    """From now on, or no more; does nothing where there is no terminal."""
    if not hasattr(driver, "_enable_mouse_support"):
        return
    terminal = cast(_Driver, driver)
    if wanted and not terminal._mouse:
        terminal._mouse = True
        terminal._enable_mouse_support()
    elif terminal._mouse and not wanted:
        terminal._disable_mouse_support()
        terminal._mouse = False
