"""The environment that Textual finds: prepared before its import, because it reads its switches then.

The plain layout is for screen readers: one column, and nothing that a reader would speak without need.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, MutableMapping
from functools import cache

from donnie_tui.settings.settings import Settings

_WITHOUT_KEY_REPORTS = ("linux", "vt", "screen", "tmux")
"""How the names of terminals begin that don't know key reports: some show a letter instead."""


def prepare(settings: Settings, environment: MutableMapping[str, str] = os.environ) -> None:
    """No key reports or mouse pixels that only some terminals know; before Textual is imported."""
    environment.setdefault("TEXTUAL_SMOOTH_SCROLL", "0")
    environment.setdefault("TEXTUAL_ANIMATIONS", "none")
    if is_plain(settings) or environment.get("TERM", "").startswith(_WITHOUT_KEY_REPORTS):
        environment.setdefault("TEXTUAL_DISABLE_KITTY_KEY", "1")


def is_page(environment: Mapping[str, str] = os.environ) -> bool:
    """Whether a browser shows the screen: then the driver for pages is named."""
    return bool(environment.get("TEXTUAL_DRIVER"))


def wants_mouse(settings: Settings) -> bool:
    """Mouse reports cost bytes over SSH and take the terminal's own selection; a reader needs neither."""
    return settings.mouse and not is_plain(settings)


def is_plain(settings: Settings) -> bool:
    """As the learner chose; without a choice, plain if a screen reader runs."""
    if settings.plain is not None:
        return settings.plain
    return _screen_reader_runs()


@cache
def _screen_reader_runs() -> bool:
    """Looked up once: it is asked three times before the first frame, and looks at all processes."""
    from devices.audio.channel import find_screen_reader

    return find_screen_reader(os.environ) is not None
