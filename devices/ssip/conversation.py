"""One connection to speech-dispatcher, from its greeting until it is lost or there is no more to say.

One sentence at a time is handed over; the next one when the server tells its end. Without a sound device
the server says OK and never tells an end: a missing end means that nothing is heard, and is told.
"""

from __future__ import annotations

import select
import socket
from collections import deque
from collections.abc import Callable
from contextlib import suppress

from devices.ports.audio import Utterance
from devices.speech.ear import for_the_ear
from devices.ssip import protocol
from devices.ssip.mailbox import Mailbox
from devices.ssip.protocol import Event, EventKind, Reply

REPLY_SECONDS = 3.0
END_SECONDS = 10.0
"""Beyond the time that a sentence needs at a slow rate, until its missing end means: no sound."""

SECONDS_A_CHARACTER = 0.2


class Lost(Exception):
    """The server is gone."""


class Conversation:
    """Says what is in the mailbox through a connected socket."""

    def __init__(
        self,
        line: socket.socket,
        mailbox: Mailbox,
        now: Callable[[], float],
        on_silence: Callable[[], None],
        punctuation: Callable[[], str] = lambda: "some",
    ) -> None:
        """``on_silence`` is told that the end of a sentence never came."""
        self._line, self._mailbox, self._now, self._on_silence = line, mailbox, now, on_silence
        self._punctuation = punctuation
        self._reader = protocol.Reader()
        self._replies: deque[Reply] = deque()
        self._events: deque[Event] = deque()
        self._language = ""
        self._message: str | None = None
        self._overdue_at = float("inf")

    def go_on(self, user: str) -> None:
        """Until the mailbox is closed. Raises ``Lost``, ``OSError`` or ``NotSsip``."""
        for command in protocol.greeting(user):
            self._ask(command)
        self._mailbox.connected()
        while not self._mailbox.is_closed:
            self._do_next()
        with suppress(Lost, OSError):
            self._ask(protocol.CANCEL)
            self._line.sendall(protocol.QUIT)

    def _do_next(self) -> None:
        if self._mailbox.take_hush():
            self._ask(protocol.CANCEL)
            self._end_sentence()
        elif settings := self._mailbox.take_settings():
            for name, value in settings.items():
                self._ask(protocol.setting(name, value))
        elif (utterance := self._mailbox.take()) is not None:
            self._speak(utterance)
        elif self._events:
            self._hear(self._events.popleft())
        elif self._message is not None and self._now() >= self._overdue_at:
            self._on_silence()
            self._end_sentence()
        else:
            self._listen(None if self._message is None else max(0.0, self._overdue_at - self._now()))

    def _speak(self, utterance: Utterance) -> None:
        words = for_the_ear(utterance.text, utterance.language, self._punctuation())
        if words and utterance.language != self._language:
            self._ask(protocol.language(utterance.language))
            self._language = utterance.language
        self._message = self._hand_over(words) if words else None
        if self._message is None:
            self._end_sentence()
        else:
            self._overdue_at = self._now() + END_SECONDS + SECONDS_A_CHARACTER * len(words)

    def _hand_over(self, words: str) -> str | None:
        """The message's number; None if it was refused."""
        if not self._ask(protocol.SPEAK).is_ok:
            return None
        return protocol.message_of(self._ask(protocol.text(words)))

    def _hear(self, event: Event) -> None:
        if event.message == self._message and event.kind is not EventKind.BEGIN:
            self._end_sentence()

    def _end_sentence(self) -> None:
        self._message, self._overdue_at = None, float("inf")
        self._mailbox.said()

    def _ask(self, command: bytes) -> Reply:
        """Send a command and wait for its reply."""
        self._line.sendall(command)
        until = self._now() + REPLY_SECONDS
        while not self._replies:
            if self._now() >= until:
                raise Lost
            self._take_from([self._line], max(0.0, until - self._now()))
        return self._replies.popleft()

    def _listen(self, seconds: float | None) -> None:
        """Take what comes, until there is something to say."""
        self._take_from([self._line, self._mailbox], seconds)
        self._mailbox.empty_signal()

    def _take_from(self, sources: list[socket.socket | Mailbox], seconds: float | None) -> None:
        ready, _, _ = select.select(sources, [], [], seconds)
        if self._line not in ready:
            return
        data = self._line.recv(4_096)
        if not data:
            raise Lost
        for answer in self._reader.feed(data):
            if isinstance(answer, Reply):
                self._replies.append(answer)
            else:
                self._events.append(answer)
