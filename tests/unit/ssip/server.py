"""A speech-dispatcher for tests: accepts connections on a Unix socket and records what it receives."""

from __future__ import annotations

import socket
import threading
from contextlib import suppress
from pathlib import Path

from devices.audio.ssip import SsipAddress
from tests.timeouts import TIMEOUT


class Server:
    """Says OK to everything. ``reports_end``: whether it reports the end of each message at once."""

    def __init__(self, folder: Path, *, reports_end: bool = True, hangs_up_after: int | None = None) -> None:
        self.address = SsipAddress(path=str(folder / "s"))
        self.commands: list[str] = []
        self.texts: list[str] = []
        self.connections = 0
        self.changed = threading.Condition()
        self._reports_end, self._hangs_up_after = reports_end, hangs_up_after
        self._listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self._listener.bind(self.address.path)
        self._listener.listen()
        self._connection: socket.socket | None = None
        threading.Thread(target=self._serve, daemon=True).start()

    def wait_for(self, *, texts: int = 0, command: str = "", connections: int = 0) -> bool:
        """Wait until so much was received. False if that takes too long."""
        with self.changed:
            return self.changed.wait_for(
                lambda: (
                    len(self.texts) >= texts
                    and (not command or command in self.commands)
                    and self.connections >= connections
                ),
                TIMEOUT,
            )

    def has_said(self, words: str) -> bool:
        """Wait for a text with these words; False if it never comes."""
        with self.changed:
            return self.changed.wait_for(lambda: any(words in each for each in self.texts[-9:]), TIMEOUT)

    def end(self, number: int) -> None:
        """Report the end of a message, numbered from 1."""
        self._answer(f"702-{number}\r\n702-1\r\n702 END\r\n")

    def close(self) -> None:
        self._listener.close()

    def kill(self) -> None:
        """As when it is killed: the socket accepts no connection, and the present one is closed."""
        for each in (self._listener, self._connection):
            if each is not None:
                with suppress(OSError):
                    each.shutdown(socket.SHUT_RDWR)
        self._listener.close()

    def _serve(self) -> None:
        with suppress(OSError):
            while True:
                self._connection, _ = self._listener.accept()
                self._note(connection=True)
                with suppress(OSError), self._connection:
                    self._serve_connection(self._connection)

    def _serve_connection(self, connection: socket.socket) -> None:
        lines = connection.makefile("r", encoding="utf-8", newline="\r\n")
        for number, each in enumerate(lines, 1):
            if self._hangs_up_after is not None and number > self._hangs_up_after:
                connection.shutdown(socket.SHUT_RDWR)
                return
            command = each.rstrip("\r\n")
            if command == "SPEAK":
                self._answer("230 OK RECEIVING DATA\r\n")
                self._take_text(lines)
            elif command == "QUIT":
                self._note(command=command)
                return
            else:
                self._note(command=command)
                self._answer("208 OK\r\n")

    def _take_text(self, lines: object) -> None:
        text = []
        for each in lines:  # type: ignore[attr-defined] # a file
            if each == ".\r\n":
                break
            text.append(each.rstrip("\r\n"))
        number = len(self.texts) + 1
        self._answer(f"225-{number}\r\n225 OK MESSAGE QUEUED\r\n")
        if self._reports_end:
            self._answer(f"701-{number}\r\n701-1\r\n701 BEGIN\r\n")
            self.end(number)
        self._note(text="\n".join(text))

    def _answer(self, words: str) -> None:
        if self._connection is not None:
            self._connection.sendall(words.encode())

    def _note(self, *, command: str = "", text: str | None = None, connection: bool = False) -> None:
        with self.changed:
            if command:
                self.commands.append(command)
            if text is not None:
                self.texts.append(text)
            self.connections += connection
            self.changed.notify_all()
