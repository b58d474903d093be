"""Scripts of commands on the real session and simulator, in folders of their own."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

from donnie_tui.bootstrap import assemble
from donnie_tui.settings.settings import Settings
from tests.unit.commands.scripted import Script


@pytest.fixture(autouse=True)
def isolated_folders(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Settings, state and files of a test are in its own folder."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def open_script() -> Iterator[Callable[..., Script]]:
    """``open_script("FW 1", "FW 2", answers=["yes"])``: the lines are the program."""
    with ExitStack() as closing:

        def open_one(
            *lines: str,
            answers: Iterable[str | None] = (),
            world: str = "open_floor",
            speed: float | None = None,
            language: str = "en",
            **others: Any,
        ) -> Script:
            settings = Settings(
                world=world, speed=speed, language=language, speech="off", sound=False, **others
            )
            donnie = assemble(settings, terminal=True)
            closing.callback(donnie.close)
            script = Script(donnie, answers)
            closing.callback(script.close)
            workspace = script.ctx.workspace
            workspace.begin_with(donnie.session.name)
            script.interaction.when_robot_changed = lambda: workspace.choose_robot(donnie.session.name)
            workspace.replace("".join(f"{line}\n" for line in lines), None, in_file="")
            return script

        yield open_one
