"""What a start does not need is not loaded: looked at by name, for time can't be tested."""

import os
import subprocess
import sys
from pathlib import Path

import pexpect

from tests.conftest import ROOT
from tests.patience import PATIENCE

FRONT_END = "import donnie_tui.cli.main, donnie_tui.cli.front_ends, donnie_tui.tui.full_screen"
LINEAR = "from donnie_tui.cli.main import main; main(['--linear', '--speech', 'off', '--sound', 'off'])"


def loaded_by(code: str, folder: Path, typed: str = "") -> set[str]:
    environment = {**os.environ, "XDG_STATE_HOME": str(folder), "XDG_CONFIG_HOME": str(folder)}
    told = f"import sys; {code}; print(*sys.modules, file=sys.stderr)"
    done = subprocess.run(
        [sys.executable, "-c", told],
        input=typed,
        capture_output=True,
        text=True,
        cwd=ROOT,
        env=environment,
        timeout=60,
        check=True,
    )
    return set(done.stderr.split())


def test_the_first_frame_needs_no_session(tmp_path: Path) -> None:
    loaded = loaded_by(FRONT_END, tmp_path)

    assert "textual.app" in loaded
    assert not loaded & {
        *(
            "donnie_tui.bootstrap",
            "donnie_tui.core.session",
            "sim",
            "pymunk",
            "language",
            "worlds",
            "argparse",
        ),
        *("donnie_tui.core.use_cases", "donnie_tui.tui.actions", "donnie_tui.core.map_grid"),
    }


def test_a_silent_linear_session_in_a_world_that_ships_loads_none_of_these(tmp_path: Path) -> None:
    loaded = loaded_by(LINEAR, tmp_path, "FW 1\n\nWHERE\n")

    assert "sim.world" in loaded
    assert not loaded & {
        *("lark", "sim.worldfile", "PIL", "tempfile", "tomllib", "textual"),
        *("json", "html", "csv", "random", "base64", "importlib.util", "dataclasses", "inspect"),
        *("argparse", "gettext", "devices.port_listing", "devices.serial_port", "sim.picture"),
        *("donnie_tui.i18n.catalogue.signs", "donnie_tui.i18n.help", "donnie_tui.i18n.mistakes"),
        *("donnie_tui.linear.reports", "donnie_tui.linear.tour", "donnie_tui.core.recording"),
        *("donnie_tui.i18n.catalogue.doctor", "donnie_tui.i18n.catalogue.tui"),
    }


MOVING = {"pymunk", "sim.layout", "sim.layer", "sim.rays", "sim.movement", "sim.vehicle", "sim.sensors"}


def test_a_linear_session_that_does_not_move_loads_no_physics(tmp_path: Path) -> None:
    loaded = loaded_by(LINEAR, tmp_path, "SPEAK 2000 + 22\n\nWHERE\n")

    assert "sim.ground" in loaded
    assert not loaded & {
        *(*MOVING, "sim.pushing", "sim.meeting", "sim.motion", "sim.hand", "sim.wheels", "sim.parts"),
        *("sim.physics", "sim.sensors.eyes", "sim.sensors.rangers", "sim.sensors.senses"),
    }


def test_a_linear_session_that_moves_loads_the_physics(tmp_path: Path) -> None:
    assert loaded_by(LINEAR, tmp_path, "FW 1\n\n") >= MOVING


TO_SPEAK = "SPEAK 2000 + 22\n\n"
OURS = ("donnie_tui", "language", "sim", "devices", "worlds")
MOST_OF_OURS = 150
"""To find and open a module takes as long as to run what is in a small one. A program that speaks needs a few
less than these; a new one belongs into the module of its subject, or is loaded by who needs it."""


def test_few_modules_are_found_and_opened_for_a_program_that_speaks(tmp_path: Path) -> None:
    loaded = loaded_by(LINEAR, tmp_path, TO_SPEAK)

    assert len([each for each in loaded if each.split(".")[0] in OURS]) <= MOST_OF_OURS


NOT_TO_SPEAK = {
    *("language.mistakes", "language.names", "language.nearby", "language.origin", "language.recovery"),
    *("donnie_tui.core.step_words", "donnie_tui.core.timeline", "donnie_tui.core.reading"),
    *("donnie_tui.core.holding_up", "donnie_tui.linear.files", "donnie_tui.linear.patience"),
    *("donnie_tui.linear.key_echo", "donnie_tui.process.lost_network", "donnie_tui.core.unknown_words"),
    *("donnie_tui.world.remarks", "donnie_tui.cli.kinds", "donnie_tui.words.team_words"),
    *("devices.speech.dispatcher", "string", "shlex"),
    *("tempfile", "random", "shutil", "logging", "typing", "pickle", "_pickle", "zlib"),
    *("pathlib", "urllib.parse", "ipaddress", "fnmatch", "ntpath"),
    *("donnie_tui.core.documents", "donnie_tui.core.copies", "donnie_tui.core.in_use"),
    *("donnie_tui.cli.overwriting", "worlds.words", "colorsys", "sim.notes"),
}


def test_a_program_that_speaks_loads_none_of_these(tmp_path: Path) -> None:
    assert not loaded_by(LINEAR, tmp_path, TO_SPEAK) & NOT_TO_SPEAK


UNTIL_2022 = """
import os, sys, sim.world
write = os.write
def writes(fd, data):
    if b"2022" in bytes(data):
        with open(sys.argv[1], "w") as file:
            print(*sys.modules, file=file)
        os._exit(0)
    return write(fd, data)
os.write = writes
sim.world.World.get_ready = lambda self: None
"""
"""The modules at a program's first line; nobody waits long enough that the physics are loaded meanwhile."""


def test_nor_does_one_that_is_typed_in_a_terminal_where_lines_are_remembered(tmp_path: Path) -> None:
    (tmp_path / "donnie").mkdir()
    (tmp_path / "donnie" / "history").write_text("FW 1\n")
    child = pexpect.spawn(
        sys.executable,
        ["-c", f"{UNTIL_2022}\n{LINEAR}", str(tmp_path / "modules")],
        env={
            **os.environ,
            "TERM": "xterm",
            "XDG_STATE_HOME": str(tmp_path),
            "XDG_CONFIG_HOME": str(tmp_path),
        },
        cwd=str(ROOT),
        timeout=PATIENCE,
    )
    child.expect_exact("\n> ")
    child.send("SPEAK 2000 + 22\x1b")
    child.expect(pexpect.EOF)
    child.close()

    loaded = set((tmp_path / "modules").read_text().split())
    assert "donnie_tui.linear.edit_line" in loaded
    assert not loaded & NOT_TO_SPEAK
