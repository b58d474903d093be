"""A learner with a screen reader types a lesson into ``donnie --linear``, or into the command line of the
plain full screen, and records what the reader said.

Readers: ``yasr``, ``fenrir`` and ``orca`` speak, into a log instead of a voice; ``brltty`` shows 40 cells.
"""

from __future__ import annotations

import configparser
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack, suppress
from dataclasses import replace
from pathlib import Path

import pexpect

from tests.readers.scoring import Phase, shown
from tests.timeouts import TIMEOUT

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent

SILENCE = 0.6
"""Seconds without a byte and without a word, after which a complete answer is over."""

LONG_SILENCE = 4.0
"""The same for an incomplete answer: on a busy machine a reader may only be late."""

SLEEPS_WITHOUT_WORK = ("yasr", "none")
"""Readers that wait for something to read, and do nothing meanwhile. The others look again and again."""

EACH_LINE = {"DONNIE_ENTER": "runs"}
"""Every complete line is a lesson's command, as in a terminal."""

AS_PROMPT = {**EACH_LINE, "DONNIE_PROMPT": "answer"}
"""The last line of an answer stands before the cursor, where a braille display looks."""

LINEAR = ("--linear",)
FULL_SCREEN = ("--visual", "--plain")
"""The modes; the command line has the focus in both."""

BRIEF = ("--verbosity", "brief")
"""Answers fit a display of 40 cells."""

_AT_A_REST = re.compile(r"(?m)^(\d+)\.$")
"""A number before a rest has a full stop. The place of a rest differs between sessions."""

_ABOUT_ITSELF = ("pychant is not installed", "Start Fenrir")
"""What Fenrir says at its start, of itself."""

_A_KEY = 0.01
_SYSTEM_PYTHON = "/usr/bin/python3"


class Listener:
    """One session under a reader, with options and variables for Donnie."""

    def __init__(
        self,
        reader: str,
        folder: Path,
        options: Sequence[str],
        variables: Mapping[str, str],
        mode: Sequence[str] = LINEAR,
    ) -> None:
        self._mode = mode
        self._reader = reader
        self._folder, self._options, self._variables = folder, options, variables
        self._log = folder / "heard.jsonl"
        self._log.touch()
        self._closing = ExitStack()
        self._program = self._write_program()
        self._heard = 0
        command = _COMMANDS[reader](self)
        self.child: pexpect.spawn[bytes] = pexpect.spawn(
            command[0], command[1:], env=self._environment(), dimensions=(24, 80), timeout=TIMEOUT
        )
        self.child.delaybeforesend = None

    def take_lesson(self, printed: Sequence[Phase]) -> list[Phase]:
        """The same phases with the spoken or shown text after each command, the greeting first."""
        greeting, *answers = printed
        self._wait_for_silence(greeting, first=TIMEOUT)
        return [self._with_output(greeting), *map(self._after, answers)]

    def close(self) -> None:
        """End the reader and the program, also where the reader holds the program's terminal open."""
        end_all(below(self.child.pid))
        self.child.close(force=True)
        self._closing.close()

    def _after(self, printed: Phase) -> Phase:
        for key in printed.command:
            self.child.send(key.encode())
            time.sleep(_A_KEY)
        self._wait_for_silence(echo=len(printed.command))
        self._new_words()  # what a reader says of typing is no answer
        self.child.send(b"\r")
        self._wait_for_silence(printed, first=TIMEOUT)
        return self._with_output(printed)

    def _with_output(self, printed: Phase) -> Phase:
        """Without the last typed letter, which YASR on a busy machine says with Enter."""
        heard = self._new_words()
        first = heard[0].strip() if heard else ""
        is_typed = first != "" and first == printed.command[-1:] and (first,) != printed.printed[:1]
        return replace(printed, heard=heard[is_typed:])

    def _wait_for_silence(self, printed: Phase | None = None, first: float = 0.0, echo: int = 0) -> None:
        """Wait for output (``first`` seconds at most), and then for silence. The silence is long unless the
        answer is complete and ``echo`` bytes of the typed text came back. While the reader or Donnie has work
        to do, or waits for a processor, it is no silence.
        """
        began = last = time.monotonic()
        size, has_come = self._log.stat().st_size, False
        while time.monotonic() - began < max(first, TIMEOUT):
            with suppress(pexpect.TIMEOUT):
                echo -= len(self.child.read_nonblocking(65_536, timeout=0.05))
                last, has_come = time.monotonic(), True
            if self._log.stat().st_size != size:
                size, last, has_come = self._log.stat().st_size, time.monotonic(), True
            if self._reader in SLEEPS_WITHOUT_WORK and any(map(is_working, below(self.child.pid))):
                last = time.monotonic()
            quiet = time.monotonic() - last
            is_over = quiet >= SILENCE and echo <= 0 and (printed is None or self._is_all(printed))
            if is_over or quiet >= (LONG_SILENCE if has_come or echo > 0 else max(first, SILENCE)):
                return

    def _is_all(self, printed: Phase) -> bool:
        so_far = replace(printed, heard=self._words_from(self._heard))
        if self._reader == "brltty":
            return not printed.printed or shown(so_far)
        return len(so_far.spoken_words) >= len(printed.printed_words)

    def _new_words(self) -> tuple[str, ...]:
        new = self._words_from(self._heard)
        self._heard = len(self._log.read_text(encoding="utf-8").splitlines())
        return new

    def _words_from(self, line: int) -> tuple[str, ...]:
        new = self._log.read_text(encoding="utf-8").splitlines()[line:]
        said = (_AT_A_REST.sub(r"\1", json.loads(each)["text"]) for each in new)
        return tuple(text for text in said if text.strip() not in ("", *_ABOUT_ITSELF))

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
        return [_SYSTEM_PYTHON, str(HERE / "fenrir.py"), str(HERE), "-e", "-s", str(path)]

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

    def orca(self) -> list[str]:
        (self._folder / "run").mkdir(mode=0o700)
        return [
            "xvfb-run", "-a", "-s", "-screen 0 1024x768x24", "dbus-run-session", "--",
            _SYSTEM_PYTHON, str(HERE / "orca_session.py"), str(self._folder), str(self._program),
        ]  # fmt: skip

    def none(self) -> list[str]:
        """No reader, for comparison."""
        return [str(self._program)]

    # --- the program

    def _write_program(self) -> Path:
        variables = "".join(f"export {name}={value}\n" for name, value in self._variables.items())
        options = " ".join(
            (*self._mode, "--speech", "off", "--sound", "off", "--speed", "max", *self._options)
        )
        return self._script(
            "program.sh",
            f'cd "{self._folder}"; unset DONNIE_READER; export PYTHONPATH="{ROOT}" DONNIE_TOUR=off '
            f'XDG_STATE_HOME="{self._folder}/state" '
            f'XDG_CONFIG_HOME="{self._folder}/config"\n{variables}'
            f'exec "{sys.executable}" -m donnie_tui {options}',
        )

    def _script(self, name: str, text: str) -> Path:
        path = self._folder / name
        path.write_text(f"#!/bin/bash\n{text}\n")
        path.chmod(0o755)
        return path

    def _environment(self) -> dict[str, str]:
        return {
            **os.environ,
            "HOME": str(self._folder),
            "SPEECH_LOG": str(self._log),
            **self._of_a_desktop(),
            "TERM": "xterm-256color",
            "LC_ALL": "C.UTF-8",
        }

    def _of_a_desktop(self) -> dict[str, str]:
        """Only Orca's reader looks at them."""
        return {
            "ORCA_START": str(self._folder / "start.jsonl"),
            "ORCA_READY": str(self._folder / "ready"),
            "XDG_RUNTIME_DIR": str(self._folder / "run"),
            "GTK_MODULES": "gail:atk-bridge",
            "NO_AT_BRIDGE": "0",
        }


_COMMANDS: dict[str, Callable[[Listener], list[str]]] = {
    "yasr": Listener.yasr,
    "fenrir": Listener.fenrir,
    "brltty": Listener.brltty,
    "orca": Listener.orca,
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


def below(parent: int) -> list[int]:
    """The processes that a process started, and those that they started."""
    children = defaultdict[int, list[int]](list)
    for each in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            children[int(each.read_text().rpartition(")")[2].split()[1])].append(int(each.parent.name))
    found = [parent]
    for each_pid in found:
        found.extend(children[each_pid])
    return found[1:]


def is_working(pid: int) -> bool:
    """Whether a thread of the process runs, or would if it got a processor, or waits for a disk."""
    for each in Path(f"/proc/{pid}/task").glob("*/stat"):
        with suppress(OSError):
            if each.read_text().rpartition(")")[2].split()[0] in "RD":
                return True
    return False


def end_all(pids: Sequence[int]) -> None:
    for pid in pids:
        with suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)


def printed_by(
    commands: Sequence[str], folder: Path, options: Sequence[str], variables: Mapping[str, str]
) -> list[Phase]:
    """The lines that answer each command, and the prompt behind them, the greeting first: with no reader."""
    folder.mkdir(exist_ok=True)
    plain = Listener.__new__(Listener)
    plain._mode = LINEAR
    plain._folder, plain._options, plain._variables = folder, options, variables
    plain._log = folder / "heard.jsonl"
    program = plain._write_program()
    child: pexpect.spawn[bytes] = pexpect.spawn(
        str(program), env=plain._environment(), dimensions=(24, 400), timeout=TIMEOUT, echo=False
    )
    answers = []
    for command in ("", *commands):
        if command:
            child.send(command.encode() + b"\r")
        child.expect(rb"(?:\A|\n)((?:[0-9]+)?> )")
        text = child.before.decode().replace("\r", "")
        lines = text.split("\n")
        answer = tuple(_AT_A_REST.sub(r"\1", line) for line in (lines[1:] if command else lines) if line)
        answers.append(Phase(command, answer, (), child.match[1].decode()))
    child.close(force=True)
    return answers


def phases_of(
    reader: str,
    commands: Sequence[str],
    folder: Path,
    options: Sequence[str] = (),
    variables: Mapping[str, str] = EACH_LINE,
    mode: Sequence[str] = LINEAR,
) -> list[Phase]:
    """The lesson under a reader, with the printed lines of the linear mode, the same as on the screen."""
    printed = printed_by(commands, folder / "plain", options, {**variables, "DONNIE_PROMPT": "short"})
    work = folder / reader
    work.mkdir()
    listener = Listener(reader, work, options, variables, mode)
    try:
        return listener.take_lesson(printed)
    finally:
        listener.close()
