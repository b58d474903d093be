"""Donnie's sentences spoken by speech-dispatcher: a ``Speaker`` that never waits for the server.

One thread owns the socket; it is started by the first thing to be said. A lost server is looked for again
when there is something to say; three times lost within a minute, everything is in print, and that is told.
"""

from __future__ import annotations

import getpass
import socket
import threading
from collections.abc import Callable
from functools import partial
from time import monotonic

from devices.audio_worker.notices import AudioNotice, NoticeCode
from devices.audio_worker.watch import Failures
from devices.ports.audio import Utterance
from devices.speech.dispatcher import Address
from devices.speech.policy import Offer
from devices.speech.voices import VoiceSettings
from devices.ssip.conversation import Conversation, Lost
from devices.ssip.mailbox import Mailbox
from devices.ssip.protocol import NotSsip

_ITS_OWN = VoiceSettings()
"""As the server has it."""
_CONNECT_SECONDS = 1.0
_CLOSING_SECONDS = 1.0


class SsipSpeaker:
    """Says it through the socket at ``address``."""

    def __init__(
        self,
        address: Address,
        on_notice: Callable[[AudioNotice], None],
        voice: VoiceSettings = _ITS_OWN,
    ) -> None:
        """``on_notice`` must not block nor raise; each notice comes once."""
        self._address, self._on_notice = address, on_notice
        self._punctuation = voice.punctuation
        self._mailbox = Mailbox(ssip_settings(voice))
        self._starting = threading.Lock()
        self._thread: threading.Thread | None = None
        self._told: set[NoticeCode] = set()

    def say(self, utterance: Utterance) -> None:
        if self._mailbox.offer(utterance, monotonic()) is Offer.REFUSED:
            self._tell(NoticeCode.SPEECH_BACKLOG)
        if self._thread is None:
            self._start()

    def silence(self) -> None:
        self._mailbox.hush()

    def set_voice(self, voice: VoiceSettings) -> None:
        """Rate, pitch, volume and punctuation of the sentences from now on."""
        self._punctuation = voice.punctuation
        self._mailbox.change(ssip_settings(voice))

    @property
    def is_speaking(self) -> bool:
        return self._mailbox.speaking is not None

    def wait_until_quiet(self, seconds: float) -> bool:
        """Wait until everything was said, ``seconds`` at most; False if that was not enough."""
        return self._mailbox.wait_until_quiet(seconds)

    def close(self) -> None:
        """Be silent for good. Twice is once."""
        self._mailbox.close()
        if self._thread is not None and self._thread is not threading.current_thread():
            self._thread.join(_CLOSING_SECONDS)

    def _start(self) -> None:
        with self._starting:
            if self._thread is None and not self._mailbox.is_closed:
                self._thread = threading.Thread(target=self._work, name="ssip", daemon=True)
                self._thread.start()

    def _work(self) -> None:
        failures = Failures()
        while self._mailbox.wait_for_work():
            try:
                with self._address.connect(_CONNECT_SECONDS) as line:
                    self._conversation(line).go_on(_user())
            except (Lost, OSError, NotSsip):
                self._mailbox.put_back()
                if failures.add(monotonic()):
                    self._mailbox.close()
                    self._tell(NoticeCode.SSIP_LOST)

    def _conversation(self, line: socket.socket) -> Conversation:
        told = partial(self._tell, NoticeCode.SSIP_SILENT)
        return Conversation(line, self._mailbox, monotonic, told, lambda: self._punctuation)

    def _tell(self, code: NoticeCode) -> None:
        if code not in self._told:
            self._told.add(code)
            self._on_notice(AudioNotice(code))


def ssip_settings(voice: VoiceSettings) -> dict[str, int]:
    """What was chosen of rate, pitch and volume, -100 to 100 as SSIP counts; 180 words a minute are 0."""
    clamped = voice.clamped()
    off = clamped.words_per_minute - 180
    every = {
        "words_per_minute": ("RATE", round(off / 2.7 if off > 0 else float(off))),
        "pitch": ("PITCH", 2 * clamped.pitch - 100),
        "volume": ("VOLUME", round(200 * clamped.volume) - 100),
    }
    return dict(setting for name, setting in every.items() if name in voice.chosen)


def _user() -> str:
    try:
        return "".join(each for each in getpass.getuser() if each.isalnum()) or "donnie"
    except (OSError, KeyError):
        return "donnie"
