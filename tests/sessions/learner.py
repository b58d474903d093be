"""A learner at a terminal: types keys into the real command and waits for what is printed."""

from __future__ import annotations

import re
import sys
import time
from pathlib import Path

import pexpect

from tests.environment import of_a_process
from tests.sessions.shell import below_shell, job_of
from tests.timeouts import TIMEOUT

ESC, UP, DOWN, LEFT, HOME = "\x1b", "\x1b[A", "\x1b[B", "\x1b[D", "\x1b[H"
CTRL_C, CTRL_D, CTRL_Z, BACKSPACE = "\x03", "\x04", "\x1a", "\x7f"


class Learner:
    """One session of ``donnie --linear`` in a folder of its own, on a terminal of 80 by 24."""

    def __init__(
        self,
        folder: Path,
        *options: str,
        speed: str = "max",
        language: str = "en",
        is_job: bool = False,
        **more: str,
    ) -> None:
        """``is_job``: a shell is above, to which Ctrl+Z leads back."""
        self._is_job = is_job
        quiet = ["--speech", "off", "--sound", "off", "--lang", language, "--speed", speed]
        command = [sys.executable, "-m", "donnie_tui", "--linear", *quiet, *options]
        first, *others = below_shell(command) if is_job else command
        self.child: pexpect.spawn[bytes] = pexpect.spawn(
            first,
            others,
            env=of_a_process(folder, **{"TERM": "xterm", **more}),
            cwd=str(folder),
            dimensions=(24, 80),
            timeout=TIMEOUT,
            echo=True,
        )
        self.child.delaybeforesend = None
        self._seen = b""

    @property
    def pid(self) -> int:
        """The process of Donnie."""
        return job_of(self.child.pid) if self._is_job else self.child.pid

    def types(self, keys: str) -> None:
        self.child.send(keys.encode())

    def enters(self, *lines: str) -> None:
        """Lines, each with Enter; the next one when the prompt is there."""
        for line in lines:
            self.sees_prompt()
            self.types(f"{line}\r")

    def sees(self, text: str) -> None:
        """Wait until ``text`` is printed, after what was seen last."""
        self.child.expect_exact(text.encode())
        self._seen += self.child.before + text.encode()

    def sees_one_of(self, *texts: str) -> None:
        """Wait until one of them is printed."""
        found = self.child.expect_exact([text.encode() for text in texts])
        self._seen += self.child.before + texts[found].encode()

    def sees_prompt(self) -> None:
        """Wait for the prompt at the beginning of a line."""
        self.child.expect(rb"(?:\A|\n)(?:[0-9]+)?> ")
        self._seen += self.child.before + self.child.match[0]

    def leaves(self) -> int | None:
        """Wait for the end: the exit code."""
        self.child.expect(pexpect.EOF)
        self._seen += self.child.before
        self.child.wait()
        self.child.close()
        return self.child.exitstatus

    @property
    def raw(self) -> bytes:
        """Every byte so far, in order."""
        return self._seen

    @property
    def lines(self) -> list[str]:
        """What was printed so far, as lines; editing undone as far as a backspace does it."""
        text = self._seen.decode().replace("\r\n", "\n")
        return re.sub(r"[^\n]\x08(?:\x1b\[K)?", "", text).split("\n")


def until(happened: object, timeout: float = TIMEOUT) -> None:
    """Wait until ``happened()`` is true, and fail if that takes too long."""
    assert callable(happened)
    end = time.monotonic() + timeout
    while not happened():
        assert time.monotonic() < end, "it did not happen"
        time.sleep(0.01)


def said(learner: Learner) -> list[str]:
    """The lines without the typed ones."""
    return [line for line in learner.lines if line and not re.match(r"[0-9]*> ", line)]
