"""A speech-dispatcher for tests: takes connections on a Unix socket and writes down what it was told."""

from __future__ import annotations

import socket
import threading
from contextlib import suppress
from pathlib import Path

from devices.speech.dispatcher import Address


class Server:
    """Says OK to everything. ``tells_end``: whether it tells the end of each message at once."""

    def __init__(self, folder: Path, *, tells_end: bool = True, hangs_up_after: int | None = None) -> None:
        self.address = Address(path=str(folder / "s"))
        self.commands: list[str] = []
        self.texts: list[str] = []
        self.connections = 0
        self.heard = threading.Condition()
        self._tells_end, self._hangs_up_after = tells_end, hangs_up_after
        self._listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self._listener.bind(self.address.path)
        self._listener.listen()
        self._line: socket.socket | None = None
        threading.Thread(target=self._serve, daemon=True).start()

    def wait_for(self, *, texts: int = 0, command: str = "", connections: int = 0) -> bool:
        """Wait until so much was heard; False if it never comes."""
        with self.heard:
            return self.heard.wait_for(
                lambda: (
                    len(self.texts) >= texts
                    and (not command or command in self.commands)
                    and self.connections >= connections
                ),
                10.0,
            )

    def end(self, number: int) -> None:
        """Tell the end of a message, numbered from 1."""
        self._answer(f"702-{number}\r\n702-1\r\n702 END\r\n")

    def close(self) -> None:
        self._listener.close()

    def go_away(self) -> None:
        """As when it is killed: nobody is at the socket any more, and the talk is over."""
        for each in (self._listener, self._line):
            if each is not None:
                with suppress(OSError):
                    each.shutdown(socket.SHUT_RDWR)
        self._listener.close()

    def _serve(self) -> None:
        with suppress(OSError):
            while True:
                self._line, _ = self._listener.accept()
                self._note(connection=True)
                with suppress(OSError), self._line:
                    self._converse(self._line)

    def _converse(self, line: socket.socket) -> None:
        lines = line.makefile("r", encoding="utf-8", newline="\r\n")
        for number, each in enumerate(lines, 1):
            if self._hangs_up_after is not None and number > self._hangs_up_after:
                line.shutdown(socket.SHUT_RDWR)
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
        if self._tells_end:
            self._answer(f"701-{number}\r\n701-1\r\n701 BEGIN\r\n")
            self.end(number)
        self._note(text="\n".join(text))

    def _answer(self, words: str) -> None:
        if self._line is not None:
            self._line.sendall(words.encode())

    def _note(self, *, command: str = "", text: str | None = None, connection: bool = False) -> None:
        with self.heard:
            if command:
                self.commands.append(command)
            if text is not None:
                self.texts.append(text)
            self.connections += connection
            self.heard.notify_all()
