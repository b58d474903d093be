"""A real ssh to a real sshd of the test, on this machine: its keys and settings in a folder of their own.

``sshd -i`` at the other end of the client's proxy command: no port, and nothing that keeps running. What ssh
and sshd do with terminals, signals and a lost line is the same as over a network.
"""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pexpect

from tests.conftest import ROOT
from tests.environment import CHOSEN
from tests.sessions.command import QUIET
from tests.timeouts import TIMEOUT

SSHD = "/usr/sbin/sshd"
_PRIVILEGE_SEPARATION = Path("/run/sshd")
"""Wanted by an sshd that root starts; a package's start script makes it, which a container has none of."""

MISSING = next((each for each in (SSHD, "ssh", "ssh-keygen") if shutil.which(each) is None), None)


class SshLine:
    """Made in ``folder``, where Donnie's settings and copies are, too."""

    def __init__(
        self, folder: Path, forced: Sequence[str] = (), *, by_key: bool = False, reader: str = "off"
    ) -> None:
        """``forced``: the options of the Donnie that is the only command, of the login or ``by_key``.

        ``reader``: the answer to whether the learner has a screen reader, empty for no answer.
        """
        self._reader = reader
        self.folder = folder
        self._forced = (
            shlex.join([sys.executable, "-P", "-m", "donnie_tui", *forced, *QUIET]) if forced else ""
        )
        if os.geteuid() == 0:
            _PRIVILEGE_SEPARATION.mkdir(mode=0o755, exist_ok=True)
        for name in ("host", "learner"):
            command = ["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", str(folder / name)]
            subprocess.run(command, check=True, stdin=subprocess.DEVNULL)
        key = (folder / "learner.pub").read_text(encoding="utf-8")
        limits = f'restrict,pty,command="{self._forced}" ' if by_key else ""
        (folder / "authorized").write_text(limits + key, encoding="utf-8")
        self._is_for_all = bool(forced) and not by_key
        (folder / "sshd_config").write_text(self._server(), encoding="utf-8")
        (folder / "ssh_config").write_text(self._client(), encoding="utf-8")

    def _server(self) -> str:
        variables = {
            "PYTHONPATH": str(ROOT),
            "XDG_STATE_HOME": str(self.folder / "state"),
            "XDG_CONFIG_HOME": str(self.folder / "config"),
            "LC_ALL": "C.UTF-8",
            "DONNIE_TOUR": "off",
            "DONNIE_READER": self._reader,
            "DONNIE_ROBOT_TIMEOUTS": CHOSEN["DONNIE_ROBOT_TIMEOUTS"],
            "DONNIE_WORLD": "open_floor",
        }
        given = " ".join(f"{name}={value}" for name, value in variables.items())
        return f"""
HostKey {self.folder}/host
AuthorizedKeysFile {self.folder}/authorized
UsePAM no
StrictModes no
PermitRootLogin yes
PasswordAuthentication no
SetEnv {given}
{f"ForceCommand {self._forced}" if self._is_for_all else ""}
"""

    def _client(self) -> str:
        return f"""
Host robot
  ProxyCommand {SSHD} -i -f {self.folder}/sshd_config
  IdentityFile {self.folder}/learner
  IdentitiesOnly yes
  StrictHostKeyChecking no
  UserKnownHostsFile {self.folder}/known_hosts
  LogLevel ERROR
  EscapeChar none
"""

    def refusal(self) -> str:
        """The reason of a refused login, if any: the account that runs the tests may be locked."""
        command = ["ssh", "-F", str(self.folder / "ssh_config"), "-T", "robot", "true"]
        done = subprocess.run(command, capture_output=True, stdin=subprocess.DEVNULL, timeout=TIMEOUT)
        if self._forced:  # then nothing else can be asked
            return "" if b"HELP" in done.stdout else done.stderr.decode()
        return done.stderr.decode() if done.returncode else ""

    def command(self, *arguments: str, terminal: bool, speech_from: str | None = None) -> list[str]:
        """``ssh robot donnie ARGUMENTS``. ``speech_from``: the forwarded socket at home."""
        first, *others = arguments
        donnie = shlex.join([sys.executable, "-m", "donnie_tui", first, *QUIET, *others])
        brought = ["-R", f"{self.folder}/voice:{speech_from}"] if speech_from else []
        heard = f"SPEECHD_ADDRESS=unix_socket:{self.folder}/voice " if speech_from else ""
        options = ["-F", str(self.folder / "ssh_config"), "-tt" if terminal else "-T", *brought]
        return ["ssh", *options, "robot", f"{heard}exec {donnie}"]

    def asked(self, command: str, typed: str) -> subprocess.CompletedProcess[bytes]:
        """What comes of that command without a terminal."""
        ssh = ["ssh", "-F", str(self.folder / "ssh_config"), "-T", "robot", *([command] if command else [])]
        return subprocess.run(ssh, input=typed.encode(), capture_output=True, timeout=TIMEOUT)

    def at_forced_terminal(self) -> pexpect.spawn[bytes]:
        """The forced command on a terminal of 80 by 24."""
        options = ["-F", str(self.folder / "ssh_config"), "-tt", "robot", "sh"]
        environment = {**os.environ, "TERM": "xterm-256color"}
        return pexpect.spawn("ssh", options, env=environment, dimensions=(24, 80), timeout=TIMEOUT)

    def at_terminal(self, *arguments: str, speech_from: str | None = None) -> pexpect.spawn[bytes]:
        """On a terminal of 80 by 24."""
        program, *rest = self.command(*arguments, terminal=True, speech_from=speech_from)
        environment = {**os.environ, "TERM": "xterm-256color"}
        return pexpect.spawn(program, rest, env=environment, dimensions=(24, 80), timeout=TIMEOUT)

    def donnies(self) -> list[int]:
        """The Donnies at the other end of this connection."""
        found = []
        for each in Path("/proc").glob("[0-9]*"):
            try:
                is_ours = str(self.folder).encode() in (each / "environ").read_bytes()
                words = (each / "cmdline").read_bytes().split(b"\0")
            except OSError:
                continue
            if is_ours and words[1:3] == [b"-m", b"donnie_tui"]:
                found.append(int(each.name))
        return found
