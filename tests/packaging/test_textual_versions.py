"""The lowest and the highest version of Textual that the distribution allows, each with its own output."""

import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from tests.conftest import ROOT
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
(ALLOWED,) = (each for each in PROJECT["dependencies"] if each.startswith("textual>="))
LOWEST = ALLOWED.removeprefix("textual>=").partition(",")[0]

UNREACHABLE = re.compile("NewConnectionError|NameResolutionError|ConnectTimeout|ProxyError|timed out", re.I)


@pytest.mark.parametrize("wanted", [f"textual=={LOWEST}", ALLOWED], ids=["lowest", "highest"])
def test_the_changed_cells_alone_are_sent(wanted: str, tmp_path: Path) -> None:
    """``fits`` is among these tests: a version whose updates have another form fails."""
    command = [sys.executable, "-m", "pip", "install", "--no-deps", "--target", str(tmp_path), wanted]
    installed = subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT)
    if installed.returncode and UNREACHABLE.search(installed.stderr):
        pytest.skip("PyPI can't be reached")
    assert installed.returncode == 0, installed.stderr

    environment = {**os.environ, "PYTHONPATH": str(tmp_path), "PYTEST_ADDOPTS": ""}
    found = subprocess.run(
        [sys.executable, "-c", "import textual; print(textual.__file__)"],
        capture_output=True, text=True, env=environment, timeout=TIMEOUT,
    )  # fmt: skip
    tests = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "tests/tui/test_terminal_output.py"],
        capture_output=True, text=True, cwd=ROOT, env=environment, timeout=TIMEOUT,
    )  # fmt: skip

    assert found.stdout.startswith(str(tmp_path))
    assert tests.returncode == 0, tests.stdout
