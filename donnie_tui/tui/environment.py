"""What the environment says to Textual, which reads its switches when it is imported."""

from __future__ import annotations

import os
from collections.abc import MutableMapping
from functools import cache

from donnie_tui.settings.settings import Settings


def is_plain(settings: Settings) -> bool:
    """As it was chosen; where nothing was, plain if a screen reader runs."""
    if settings.plain is not None:
        return settings.plain
    return _is_listened_to()


@cache
def _is_listened_to() -> bool:
    """Looked up once: it is asked three times before the first frame, and all processes are looked at."""
    from devices.audio.channel import find_screen_reader

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
