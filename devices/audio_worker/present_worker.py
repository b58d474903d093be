"""What is known of the worker that runs: by what it sounds, what it can read, what it owes us.

It is forgotten with the worker: the next one is another one.
"""

from __future__ import annotations

from devices.audio_worker.messages import Pong
from devices.audio_worker.watch import ANSWER_LIMIT, Due, Watch

PING_INTERVAL = 1.0
"""Seconds between heartbeats, only while something should be heard: an idle worker is left asleep."""


class PresentWorker:
    """One worker, or none yet."""

    def __init__(self) -> None:
        self.watch = Watch()
        self.player = ""
        """By what it sounds; empty while that is unknown."""
        self.languages: tuple[str, ...] | None = None
        """Of the voices that it found; None while that is unknown."""
        self._next_ping: float | None = None

    @property
    def has_sound(self) -> bool:
        return bool(self.player)

    @property
    def is_ready(self) -> bool:
        """Whether both the device and the voices have answered."""
        return self.has_sound and self.languages is not None

    @property
    def has_no_voice(self) -> bool:
        """Whether it looked for voices and found none."""
        return self.languages == ()

    def can_read(self, base_language: str) -> bool:
        return bool(self.languages) and base_language in (self.languages or ())

    def must_ping(self, has_sent: bool, now: float) -> bool:
        """Whether a heartbeat goes out now: with whatever is sent, and then as long as a sentence lasts.

        It is then expected to be answered.
        """
        is_time = self._next_ping is not None and now >= self._next_ping
        if not (is_time or has_sent) or self.watch.expects(Due.PONG):
            return False
        self._next_ping = None
        self.watch.expect(Due.PONG, now + ANSWER_LIMIT)
        return True

    def pong_came(self, pong: Pong, is_speaking: bool, now: float) -> None:
        self.watch.came(Due.PONG)
        self.watch.saw(pong.frames, pong.is_playing, now)
        if is_speaking or pong.is_playing:
            self._next_ping = now + PING_INTERVAL

    def next_date(self) -> float | None:
        """When to look at it again."""
        dates = (self.watch.next_date(), self._next_ping)
        return min((date for date in dates if date is not None), default=None)
