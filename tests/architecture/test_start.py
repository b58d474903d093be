"""A start loads no unneeded module. The names of modules are checked, because time can't be tested."""

import os
import subprocess
import sys
from pathlib import Path

from tests.conftest import ROOT
from tests.timeouts import TIMEOUT

FRONT_END = "import donnie_tui.cli.main, donnie_tui.cli.front_end, donnie_tui.tui.full_screen"
LINEAR = "from donnie_tui.cli.main import main; main(['--linear', '--speech', 'off', '--sound', 'off'])"

UNTIL_FIRST_FRAME = """
import os
from textual.app import App
import donnie_tui.cli.front_end as front_end
import donnie_tui.i18n.words as words
from donnie_tui.cli.main import main
from donnie_tui.tui.startup import Startup

def begin(startup):
    known = ["SENTENCES"] * words._translations.cache_info().currsize
    print(*sys.modules, *known, file=sys.__stderr__)
    os._exit(0)

run = App.run
App.run = lambda app, mouse: run(app, headless=True, size=(80, 24))
front_end.process_environment = lambda found: front_end.ProcessEnvironment(True, True, found)
Startup.begin = begin
main(["--visual", "--speech", "off", "--sound", "off"])
"""
"""What a terminal has is a terminal; the session would be loaded next."""

HEAVY = {
    "lark",
    "sim.worldfile",
    "PIL",
    "textual",
    "rich",
    "serial",
    "miniaudio",
    "pyttsx3",
    "asyncio",
    "email",
    "cv2",
    "numpy",
}
"""Libraries that most starts do not need, and that take long to load."""
RARE = {
    *("pathlib", "json", "csv", "shlex", "tomllib", "statistics", "dataclasses"),
    *("donnie_tui.core.reports", "donnie_tui.core.map_words", "donnie_tui.i18n.help", "worlds.words"),
    *("donnie_tui.core.map_grid", "donnie_tui.core.map_scene", "donnie_tui.core.program_text"),
    *("devices.serial_ports", "devices.audio.pronunciation", "string"),
}
"""Loaded by the command that needs it: each session of a class would keep its own copy in memory."""
MOVING = {"pymunk", "sim.layout", "sim.rays", "sim.movement", "sim.vehicle", "sim.sensors"}
"""Loaded when a robot first moves or looks, or while the linear mode waits for its first line."""


def loaded_by(code: str, folder: Path, typed: str = "") -> set[str]:
    environment = {**os.environ, "XDG_STATE_HOME": str(folder), "XDG_CONFIG_HOME": str(folder)}
    done = subprocess.run(
        [sys.executable, "-c", f"import sys\n{code}\nprint(*sys.modules, file=sys.stderr)"],
        input=typed,
        capture_output=True,
        text=True,
        cwd=ROOT,
        env=environment,
        timeout=TIMEOUT,
        check=True,
    )
    return set(done.stderr.split())


def test_a_session_is_loaded_without_what_only_other_users_of_its_libraries_need(tmp_path: Path) -> None:
    """msgspec would load what reads types and sources, pymunk logging, and argparse the names of locales."""
    linear = ["--linear", "--speech", "off", "--sound", "off"]
    code = f"sys.argv[1:] = {linear}\nfrom donnie_tui.__main__ import main\nmain()"
    loaded = loaded_by(code, tmp_path, "FW 1\n\n")

    assert {"msgspec", "argparse", "pymunk"} <= loaded
    assert not loaded & {
        *("typing_extensions", "inspect", "ast", "dis", "msgspec.inspect", "msgspec._json_schema"),
        *("logging", "traceback", "tokenize", "locale"),
    }


def test_the_first_frame_needs_no_session(tmp_path: Path) -> None:
    loaded = loaded_by(FRONT_END, tmp_path)

    assert "textual.app" in loaded
    assert not loaded & {
        "donnie_tui.bootstrap",
        "donnie_tui.core.session",
        "sim",
        "pymunk",
        "language.keywords",
        "worlds",
    }


def test_the_first_frame_looks_up_no_sentence_and_knows_no_language_event_or_robot(tmp_path: Path) -> None:
    """All of it, as it is painted: functions load modules too."""
    loaded = loaded_by(UNTIL_FIRST_FRAME, tmp_path)

    assert {"donnie_tui.tui.app", "textual.drivers.headless_driver"} <= loaded
    assert not loaded & {
        *("language.keywords", "language.lexer", "language.syntax", "language.diagnostics"),
        *("donnie_tui.core.events", "donnie_tui.core.wording", "donnie_tui.core.map_grid"),
        *("donnie_tui.robot", "devices.serial_ports", "json", "shlex"),
        "SENTENCES",
    }


def test_a_silent_linear_session_loads_no_heavy_library(tmp_path: Path) -> None:
    loaded = loaded_by(LINEAR, tmp_path, "FW 1\n\nWHERE\n")

    assert "sim.world" in loaded
    assert not loaded & HEAVY


def test_a_linear_session_that_does_not_move_loads_no_physics(tmp_path: Path) -> None:
    loaded = loaded_by(LINEAR, tmp_path, "SPEAK 2000 + 22\n\nWHERE\n")

    assert "sim.ground" in loaded
    assert not loaded & MOVING


def test_a_linear_session_that_only_walks_and_speaks_loads_nothing_for_rare_commands(tmp_path: Path) -> None:
    loaded = loaded_by(LINEAR, tmp_path, "FW 1\nSPEAK 2000 + 22\n\n")

    assert not loaded & RARE


def test_a_linear_session_that_moves_loads_the_physics(tmp_path: Path) -> None:
    assert loaded_by(LINEAR, tmp_path, "FW 1\n\n") >= MOVING
