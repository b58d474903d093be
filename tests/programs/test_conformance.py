"""Each program of the conformance corpus has its expected outcome, without a process for each.

The corpus's own runner reads the expectations, makes the floors and compares; only the run is replaced. The
few programs that need the terminal are typed into the real command.
"""

from __future__ import annotations

import importlib.util
import io
import json
import sys
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

from donnie_tui.bootstrap import assemble
from donnie_tui.core.session import RunOptions
from donnie_tui.settings.settings import Settings
from tests.timeouts import TIMEOUT

COMMAND = [sys.executable, "-m", "donnie_tui"]


@pytest.fixture(scope="session")
def runner(shared: Path) -> ModuleType:
    """The corpus's own runner."""
    spec = importlib.util.spec_from_file_location("run_corpus", shared / "corpus" / "run_corpus.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_every_program_of_the_corpus_has_its_expected_outcome(
    runner: ModuleType, shared: Path, tmp_path: Path
) -> None:
    programs = sorted((shared / "corpus").glob("*.gd"))

    differences = {each.stem: found for each in programs if (found := _differences(runner, each, tmp_path))}

    assert len(programs) > 200
    assert differences == {}


def _differences(runner: ModuleType, program: Path, folder: Path) -> list[str]:
    want = runner.read_expected(program.with_suffix(".expected"))
    if want["mode"] == "terminal":
        events, done = runner.run(COMMAND, program, want, folder)
    else:
        events, done = _events_of(program, runner.world_text(want), want["lang"], folder), _NO_PROCESS
    found: list[str] = runner.differences(want, events, done)
    return found


_NO_PROCESS = SimpleNamespace(returncode=0, stderr="")


def _events_of(program: Path, world: str, language: str, folder: Path) -> list[dict[str, Any]]:
    """The output of ``donnie run --events -``."""
    file, out = folder / f"{program.stem}.world", io.StringIO()
    file.write_text(world, encoding="utf-8")
    settings = Settings(world=str(file), language=language, speed=None, speech="off", sound=False, events="-")
    donnie = assemble(settings, terminal=False, out=out)
    try:
        text = program.read_bytes().decode("utf-8-sig")
        assert donnie.session.start(text, program.name, RunOptions(fresh=True, hooked=False)).wait(TIMEOUT)
    finally:
        donnie.close()
    return [json.loads(line) for line in out.getvalue().split("\n") if line]
