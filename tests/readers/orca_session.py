"""A graphical session with a terminal that Orca reads: passes keys to the terminal, and its output on.

To be run inside ``xvfb-run`` and ``dbus-run-session``, by Debian's Python, which knows Orca. The program
starts when the terminal's window has the focus, as after its name is typed there. Keys are sent as
X events: Orca needs them to distinguish an answer from typing. Arguments: a folder to work in, the
program. The variables ``SPEECH_LOG``, ``ORCA_START`` and ``ORCA_READY`` are those of ``orca_voice``.
"""

from __future__ import annotations

import json
import os
import select
import shutil
import subprocess
import sys
import time
import tty
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROWS, COLUMNS = 24, 80
TIMEOUT = 240.0
"""As ``tests.timeouts``, which Debian's Python doesn't find."""
SILENCE = 1.5
"""Seconds of silence after which Orca has described the window."""

_START_ORCA = f"""
import runpy, sys
sys.path.insert(0, {str(HERE / "orca_voice")!r})
import speechd
sys.argv = ["orca"]
runpy.run_path({shutil.which("orca")!r}, run_name="__main__")
"""
_PROFILE = {"enableKeyEcho": False, "enableEchoByCharacter": False, "profile": ["Default", "default"]}
_SETTINGS = {
    "general": {
        **_PROFILE,
        "startingProfile": ["Default", "default"],
        "enableSpeech": True,
        "enableBraille": False,
        "enableSound": False,
        "firstStart": False,
    },
    "profiles": {"default": _PROFILE},
    "pronunciations": {},
    "keybindings": {},
}
_BUS = "/usr/libexec/at-spi-bus-launcher"


def main() -> None:
    folder, program = Path(sys.argv[1]), sys.argv[2]
    settings = folder / ".local/share/orca/user-settings.conf"
    settings.parent.mkdir(parents=True)
    settings.write_text(json.dumps(_SETTINGS))
    tty.setraw(0)
    with ExitStack() as closing:
        start(closing, "openbox")
        start(closing, _BUS, "--launch-immediately")
        start(closing, sys.executable, "-c", _START_ORCA)
        words = Path(os.environ["ORCA_START"])
        wait_until(lambda: words.exists() and words.stat().st_size > 0)
        shown = folder / "shown"
        sit_down(closing, folder, program, shown)
        wait_for_silence(words)
        Path(os.environ["ORCA_READY"]).touch()
        shown.touch()
        pass_on(shown)


def start(closing: ExitStack, *command: str) -> None:
    process = subprocess.Popen(
        command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    closing.callback(process.wait)
    closing.callback(process.kill)


def sit_down(closing: ExitStack, folder: Path, program: str, shown: Path) -> None:
    """A terminal with the focus, in which the program waits for the test to be ready."""
    waiting = folder / "waiting.sh"
    ready = os.environ["ORCA_READY"]
    waiting.write_text(f'#!/bin/sh\nwhile [ ! -e "{ready}" ]; do sleep 0.1; done\nexec "{program}"\n')
    waiting.chmod(0o755)
    recorded = f"script -qfc {waiting} {shown}"
    start(closing, "lxterminal", f"--geometry={COLUMNS}x{ROWS}", "--no-remote", "-e", recorded)
    wait_until(lambda: xdotool("search", "--onlyvisible", "--class", "lxterminal"))
    xdotool("search", "--onlyvisible", "--class", "lxterminal", "windowfocus")


def xdotool(*words: str) -> bool:
    return subprocess.run(["xdotool", *words], capture_output=True, check=False).returncode == 0


def wait_until(is_so: Callable[[], bool]) -> None:
    end = time.monotonic() + TIMEOUT
    while not is_so():
        if time.monotonic() > end:
            raise SystemExit("Orca or its terminal did not start")
        time.sleep(0.1)


def wait_for_silence(words: Path) -> None:
    """Wait until Orca is silent for a while."""
    size, since = -1, time.monotonic()
    while time.monotonic() - since < SILENCE:
        if words.stat().st_size != size:
            size, since = words.stat().st_size, time.monotonic()
        time.sleep(0.1)


def pass_on(shown: Path) -> None:
    with shown.open("rb") as output:
        while True:
            if (data := output.read()) != b"":
                os.write(1, data)
            if select.select([0], [], [], 0.02)[0]:
                keys = os.read(0, 4_096)
                if not keys:
                    return
                press(keys.decode())


def press(keys: str) -> None:
    for number, text in enumerate(keys.split("\r")):
        if number:
            xdotool("key", "--delay", "0", "Return")
        if text:
            xdotool("type", "--delay", "10", "--", text)


if __name__ == "__main__":
    main()
