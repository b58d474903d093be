"""Runs one session of the net in both front ends."""

from __future__ import annotations

from pathlib import Path

import pytest

from donnie_tui.settings.settings import Settings
from tests.parity.cases import Group
from tests.parity.full_screen import full_screen
from tests.parity.linear_mode import linear_mode
from tests.parity.outcome import Outcome

PACE = 20.0
"""Times the real robot's pace: a WAIT lasts, and a step takes hardly any time."""


def settings_of(group: Group) -> Settings:
    """No sound, no report by the clock, and long answers without pages."""
    return Settings(
        world=group.world,
        speed=PACE,
        speech="off",
        sound=False,
        language=group.language,
        tour=False,
        plain=False,
        progress="0",
        page="off",
    )


def alone_in(folder: Path, patched: pytest.MonkeyPatch) -> None:
    """A folder without settings and with a program to open."""
    folder.mkdir(parents=True)
    (folder / "kept.gd").write_text("FW 1\nFW 2\n", encoding="utf-8")
    patched.setenv("XDG_CONFIG_HOME", str(folder / "config"))
    patched.setenv("XDG_STATE_HOME", str(folder / "state"))
    patched.chdir(folder)


def in_linear_mode(group: Group, folder: Path) -> list[Outcome]:
    with pytest.MonkeyPatch.context() as patched:
        alone_in(folder, patched)
        with linear_mode(settings_of(group), group.text, patched) as mode:
            mode.prepare(*group.before)
            return [mode.type(line) for line in group.lines]


async def on_full_screen(group: Group, folder: Path) -> list[Outcome]:
    with pytest.MonkeyPatch.context() as patched:
        alone_in(folder, patched)
        async with full_screen(settings_of(group), group.text, folder / "state") as screen:
            await screen.prepare(*group.before)
            return [await screen.type(line) for line in group.lines]
