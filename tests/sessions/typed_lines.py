"""The linear mode as it reads lines from a file: what it answers."""

from __future__ import annotations

import subprocess
from pathlib import Path

from tests.sessions.command import COMMAND, QUIET, environment
from tests.timeouts import TIMEOUT


def quiet(language: str, *options: str) -> list[str]:
    """The command that begins such a conversation, in a world with things."""
    always = ["--linear", *QUIET, "--speed", "max", "--lang", language]
    return [*COMMAND, *always, "--world", "living_room", *options]


def printed_by(folder: Path, language: str, lines: list[str], *options: str) -> list[str]:
    """What a session says that is read from a file."""
    done = subprocess.run(
        quiet(language, *options),
        input="\n".join([*lines, ""]).encode(),
        capture_output=True,
        cwd=folder,
        env=environment(folder),
        timeout=TIMEOUT,
        check=False,
    )
    assert done.returncode in (0, 1, 2), done.stderr.decode()  # as its lines were understood
    assert done.stderr == b""
    return done.stdout.decode().split("\n")


def answers_to(folder: Path, *lines: str) -> list[str]:
    """The answers, without the first two lines and the last one."""
    return printed_by(folder, "en", [*lines, "NEW"])[2:-3]
