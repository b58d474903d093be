"""What is to be said through the socket, between those who say it and the thread that owns the socket.

Every call takes a lock for microseconds. Readable on ``fileno`` when there may be something to do.
"""

from __future__ import annotations

import socket
import threading
from contextlib import suppress

from devices.ports.audio import Utterance
from devices.speech.policy import Offer, SpeechQueue, cuts


class Mailbox:
    """Thread-safe. ``take`` and what follows it are the owner's of the socket, the others anybody's."""

    def __init__(self, settings: dict[str, int] | None = None) -> None:
        """``settings``: how the server is to sound, by its names; its own ways where none are given."""
        self._changed = threading.Condition()
        self._settings = settings or {}
        self._owes_settings = False
        self._queue = SpeechQueue()
        self._speaking: Utterance | None = None
        self._hushes = False
        self._is_closed = False
        self._here, self._there = socket.socketpair()
        self._here.setblocking(False)
        self._there.setblocking(False)

    # --- anybody

    def offer(self, utterance: Utterance, now: float) -> Offer:
        """Put it in its place; nothing is taken once the box is closed."""
        with self._changed:
            if self._is_closed:
                return Offer.REPEATED
            offer = self._queue.offer(utterance, now)
            if self._speaking and cuts(utterance.urgency, self._speaking.urgency):
                self._hushes = True
            self._wake()
            return offer

    def hush(self) -> None:
        """Nothing said until now is heard any more."""
        with self._changed:
            self._queue.clear()
            self._hushes = self._hushes or self._speaking is not None
            self._wake()

    def change(self, settings: dict[str, int]) -> None:
        """How the server is to sound from now on."""
        with self._changed:
            self._settings, self._owes_settings = settings, True
            self._wake()

    def close(self) -> None:
        """For good."""
        with self._changed:
            self._is_closed = True
            self._queue.clear()
            self._wake()
            self._changed.notify_all()

    @property
    def is_closed(self) -> bool:
        return self._is_closed

    @property
    def speaking(self) -> Utterance | None:
        """What the server has to say just now."""
        return self._speaking

    def wait_until_quiet(self, seconds: float) -> bool:
        with self._changed:
            return self._changed.wait_for(self._is_quiet, seconds)

    def wait_for_work(self) -> bool:
        """Wait until there is something to say. False if the box was closed."""
        with self._changed:
            self._changed.wait_for(lambda: self._is_closed or self._queue)
            return not self._is_closed

    def fileno(self) -> int:
        return self._here.fileno()

    def empty_signal(self) -> None:
        """Be readable again only after the next call of anybody."""
        with suppress(OSError):
            self._here.recv(4_096)

    # --- the owner of the socket

    def connected(self) -> None:
        """A server is there that knows nothing of how to sound."""
        with self._changed:
            self._owes_settings = bool(self._settings)

    def take_settings(self) -> dict[str, int]:
        """What the server has not been told, between two sentences; mostly nothing."""
        with self._changed:
            if not self._owes_settings or self._speaking is not None:
                return {}
            self._owes_settings = False
            return self._settings

    def take(self) -> Utterance | None:
        """The next sentence, unless one is still being said."""
        with self._changed:
            if self._speaking is None and not self._is_closed:
                self._speaking = self._queue.next()
                self._changed.notify_all()
                return self._speaking
            return None

    def take_hush(self) -> bool:
        """Whether the server is to be silent now."""
        with self._changed:
            hushes, self._hushes = self._hushes, False
            return hushes

    def said(self) -> None:
        """The sentence is over."""
        with self._changed:
            self._speaking = None
            self._changed.notify_all()

    def put_back(self) -> None:
        """The server was lost: the sentence is said again, half heard is worse than twice."""
        with self._changed:
            if self._speaking is not None and not self._hushes:
                self._queue.put_back(self._speaking)
            self._speaking, self._hushes = None, False
            self._changed.notify_all()

    def _is_quiet(self) -> bool:
        return self._is_closed or not (self._speaking or self._queue or self._hushes)

    def _wake(self) -> None:
        self._changed.notify_all()
        with suppress(OSError):  # full: it will wake up anyway
            self._there.send(b"!")
