"""A learner with a screen reader: types a lesson into ``donnie --linear`` and writes down what was heard.

Readers: ``yasr`` and ``fenrir`` speak, into a log instead of a voice; ``brltty`` shows 40 cells.
"""

from __future__ import annotations

import configparser
import json
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack, suppress
from pathlib import Path

import pexpect

from tests.readers.hearing import Phase

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent

SILENCE = 0.6
"""Seconds without a byte and without a word: the answer is over."""

PATIENCE = 20.0

EACH_LINE = {"DONNIE_ENTER": "runs"}
"""Every complete line is a lesson's command, as in a terminal."""

AS_PROMPT = {**EACH_LINE, "DONNIE_PROMPT": "answer"}
"""The last line of an answer stands before the cursor, where a braille display looks."""

BRIEF = ("--verbosity", "brief")
"""Answers fit a display of 40 cells."""

_ABOUT_ITSELF = ("pychant is not installed", "Start Fenrir")
"""What Fenrir says at its start, of itself."""

_A_KEY = 0.01
_SYSTEM_PYTHON = "/usr/bin/python3"


class Listener:
    """One session under a reader, with options and variables for Donnie."""

    def __init__(
        self, reader: str, folder: Path, options: Sequence[str], variables: Mapping[str, str]
    ) -> None:
        self._folder, self._options, self._variables = folder, options, variables
        self._log = folder / "heard.jsonl"
        self._log.touch()
        self._closing = ExitStack()
        self._program = self._write_program()
        self._heard = 0
        command = _COMMANDS[reader](self)
        self.child: pexpect.spawn[bytes] = pexpect.spawn(
            command[0], command[1:], env=self._environment(), dimensions=(24, 80), timeout=PATIENCE
        )
        self.child.delaybeforesend = None

    def take_lesson(self, commands: Sequence[str]) -> list[tuple[str, tuple[str, ...]]]:
        """What was heard, or shown, after each command, the greeting first."""
        self._settle(first=PATIENCE, until_words=True)
        greeting = self._new_words()
        return [("", greeting), *((command, self._after(command)) for command in commands)]

    def close(self) -> None:
        self.child.close(force=True)
        self._closing.close()

    def _after(self, command: str) -> tuple[str, ...]:
        for key in command:
            self.child.send(key.encode())
            time.sleep(_A_KEY)
        self._settle()
        self._new_words()  # what a reader says of typing is no answer
        self.child.send(b"\r")
        return self._answer()

    def _answer(self) -> tuple[str, ...]:
        self._settle(first=PATIENCE)
        return self._new_words()

    def _settle(self, first: float = 0.0, *, until_words: bool = False) -> None:
        """Wait until something has come (``first`` seconds at most), and then until it is silent.

        ``until_words``: until something was heard; a reader takes its time to start.
        """
        began = last = time.monotonic()
        size, has_come = self._log.stat().st_size, False
        while time.monotonic() - began < PATIENCE:
            with suppress(pexpect.TIMEOUT):
                self.child.read_nonblocking(65_536, timeout=0.05)
                last, has_come = time.monotonic(), has_come or not until_words
            if self._log.stat().st_size != size:
                size, last, has_come = self._log.stat().st_size, time.monotonic(), True
            quiet = time.monotonic() - last
            if quiet >= SILENCE and (has_come or quiet >= first):
                return

    def _new_words(self) -> tuple[str, ...]:
        lines = self._log.read_text(encoding="utf-8").splitlines()
        new, self._heard = lines[self._heard :], len(lines)
        said = (json.loads(line)["text"] for line in new)
        return tuple(text for text in said if text.strip() not in _ABOUT_ITSELF)

    # --- readers

    def yasr(self) -> list[str]:
        server = self._script("server.sh", f'exec "{sys.executable}" "{HERE / "voice.py"}" "{self._log}"')
        (self._folder / ".yasr.conf").write_text(
            "[normalkeys]\n[reviewkeys]\n[options]\ncursor tracking=full\nsynthesizer=emacspeak server\n"
            f"synthesizer port=|{server}\nkey echo=off\nshell=/bin/sh\nspecial=off\n"
            "up and down arrows=speak line\nDisableKey=6925\n"
            "[Emacspeak server]\nrate=175\npunctuation=some\n[dict]\n"
        )
        return ["yasr", str(self._program)]

    def fenrir(self) -> list[str]:
        settings = configparser.ConfigParser(interpolation=None, strict=False)
        settings.optionxform = str  # type: ignore[assignment, method-assign] # names keep their capitals
        settings.read("/etc/fenrirscreenreader/settings/settings.conf")
        for section, values in _FENRIR.items():
            settings.read_dict({section: values})
        settings.read_dict(
            {"general": {"debugFile": str(self._folder / "fenrir.log"), "shell": str(self._program)}}
        )
        path = self._folder / "fenrir.conf"
        with path.open("w") as file:
            settings.write(file)
        return [_SYSTEM_PYTHON, str(HERE / "fenrir_with_log.py"), str(HERE), "-e", "-s", str(path)]

    def brltty(self) -> list[str]:
        socket = self._folder / "display"
        (self._folder / "empty.conf").touch()
        self._background(
            "brltty", "-q", "-n", "-N", "-f", str(self._folder / "empty.conf"), "-b", "vr",
            "-d", f"server:{socket}", "-x", "sc", "-s", "no",
            "-W", str(self._folder), "-U", str(self._folder),
            "-P", str(self._folder / "pid"), "-F", str(self._folder / "prefs"), "-t", "en-nabcc",
            wait_for=self._folder / "ready",
        )  # fmt: skip
        self._background(sys.executable, "-m", "tests.readers.braille", str(socket), str(self._log))
        return [sys.executable, str(HERE / "shared_screen.py"), str(self._folder), str(self._program)]

    def _background(self, *command: str, wait_for: Path | None = None) -> None:
        shell = f'while [ ! -e "{wait_for}" ]; do sleep 0.1; done; ' if wait_for else ""
        process = subprocess.Popen(
            ["/bin/sh", "-c", f'{shell}exec "$@"', "-", *command],
            cwd=ROOT,
            env={**self._environment(), "LC_ALL": "en_US.ISO-8859-1", "HOME": str(self._folder)},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        self._closing.callback(process.wait)
        self._closing.callback(process.kill)

    def none(self) -> list[str]:
        """Nobody reads; for comparison."""
        return [str(self._program)]

    # --- the program

    def _write_program(self) -> Path:
        variables = "".join(f"export {name}={value}\n" for name, value in self._variables.items())
        options = " ".join(
            ("--linear", "--speech", "off", "--sound", "off", "--speed", "max", *self._options)
        )
        return self._script(
            "program.sh",
            f'export PYTHONPATH="{ROOT}" DONNIE_TOUR=off XDG_STATE_HOME="{self._folder}/state" '
            f'XDG_CONFIG_HOME="{self._folder}/config"\n{variables}'
            f'exec "{sys.executable}" -m donnie_tui {options}',
        )

    def _script(self, name: str, text: str) -> Path:
        path = self._folder / name
        path.write_text(f"#!/bin/bash\n{text}\n")
        path.chmod(0o755)
        return path

    def _environment(self) -> dict[str, str]:
        kept = {name: value for name, value in os.environ.items() if not name.startswith("DONNIE_")}
        for name in ("COLUMNS", "LINES"):
            kept.pop(name, None)
        return {
            **kept,
            "HOME": str(self._folder),
            "SPEECH_LOG": str(self._log),
            "TERM": "xterm-256color",
            "LC_ALL": "C.UTF-8",
        }


_COMMANDS: dict[str, Callable[[Listener], list[str]]] = {
    "yasr": Listener.yasr,
    "fenrir": Listener.fenrir,
    "brltty": Listener.brltty,
    "none": Listener.none,
}

_FENRIR = {
    "sound": {"enabled": "False", "driver": "dummyDriver"},
    "speech": {"enabled": "True", "driver": "logDriver", "autoReadIncoming": "True", "language": ""},
    "braille": {"enabled": "False", "driver": "dummyDriver"},
    "remote": {"enable": "False", "driver": "dummyDriver"},
    "keyboard": {"charEcho": "False", "charDeleteEcho": "True"},
    "general": {
        "debugMode": "File",
        "debugLevel": "0",
        "punctuationLevel": "none",
        "newLinePause": "True",
        "emoticons": "False",
        "autoSpellCheck": "False",
        "hasAttributes": "False",
    },
    "promote": {"enabled": "False"},
    "time": {"enabled": "False"},
    "focus": {"cursor": "True", "highlight": "False"},
}


def is_installed(reader: str) -> bool:
    return shutil.which(reader, path=f"{os.environ.get('PATH', '')}:/usr/sbin:/sbin") is not None


def printed_by(
    commands: Sequence[str], folder: Path, options: Sequence[str], variables: Mapping[str, str]
) -> list[tuple[tuple[str, ...], str]]:
    """The lines that answer each command, and the prompt behind them, the greeting first: with no reader."""
    folder.mkdir(exist_ok=True)
    plain = Listener.__new__(Listener)
    plain._folder, plain._options, plain._variables = folder, options, variables
    plain._log = folder / "heard.jsonl"
    program = plain._write_program()
    child: pexpect.spawn[bytes] = pexpect.spawn(
        str(program), env=plain._environment(), dimensions=(24, 400), timeout=PATIENCE, echo=False
    )
    answers = []
    for command in ("", *commands):
        if command:
            child.send(command.encode() + b"\r")
        child.expect(rb"(?:\A|\n)((?:[0-9]+)?> )")
        text = child.before.decode().replace("\r", "")
        lines = text.split("\n")
        answer = tuple(line for line in (lines[1:] if command else lines) if line)
        answers.append((answer, child.match[1].decode()))
    child.close(force=True)
    return answers


def phases_of(
    reader: str,
    commands: Sequence[str],
    folder: Path,
    options: Sequence[str] = (),
    variables: Mapping[str, str] = EACH_LINE,
) -> list[Phase]:
    """The lesson under a reader, against what it prints."""
    printed = printed_by(commands, folder / "plain", options, {**variables, "DONNIE_PROMPT": "short"})
    work = folder / reader
    work.mkdir()
    listener = Listener(reader, work, options, variables)
    try:
        heard = listener.take_lesson(commands)
    finally:
        listener.close()
    return [
        Phase(command, lines, said, prompt)
        for (lines, prompt), (command, said) in zip(printed, heard, strict=True)
    ]
