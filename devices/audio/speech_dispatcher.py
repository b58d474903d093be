"""A ``Speaker`` that speaks through speech-dispatcher's socket, and never waits for the server.

One thread owns the socket; the first utterance starts it. ``Mailbox`` carries the utterances to it. After a
loss it reconnects when there is something to say. If the server is lost three times in a minute, everything
is only printed from then on, and that is reported.
"""

from __future__ import annotations

import getpass
import select
import socket
import threading
from collections import deque
from collections.abc import Callable, Mapping
from contextlib import suppress
from functools import partial
from time import monotonic

from devices.audio import ssip
from devices.audio.pronunciation import ENGLISH_ONLY, SpokenLanguage, sign_words, speakable_text
from devices.audio.speech_queue import QueueResult, SpeechQueue, interrupts
from devices.audio.ssip import SsipAddress, SsipEvent, SsipEventKind, SsipProtocolError, SsipReply
from devices.audio.supervisor import FailureCounter
from devices.ports.audio import AudioNotice, NoticeCode, Utterance, VoiceSettings

REPLY_SECONDS = 3.0
END_SECONDS = 10.0
"""Beyond the time that a sentence needs at a slow rate: after that, a missing end means that there is no
sound."""

SECONDS_A_CHARACTER = 0.2

_SERVER_DEFAULTS = VoiceSettings()
_CONNECT_SECONDS = 1.0
_CLOSING_SECONDS = 1.0


class SsipSpeaker:
    """Speaks through the socket at ``address``."""

    def __init__(
        self,
        address: SsipAddress,
        on_notice: Callable[[AudioNotice], None],
        voice: VoiceSettings = _SERVER_DEFAULTS,
        languages: Mapping[str, SpokenLanguage] = ENGLISH_ONLY,
    ) -> None:
        """``on_notice`` must not block or raise; it is called once for each notice."""
        self._address, self._on_notice = address, on_notice
        self._punctuation, self._languages = voice.punctuation, languages
        self._mailbox = Mailbox(ssip_settings(voice))
        self._starting = threading.Lock()
        self._thread: threading.Thread | None = None
        self._notified: set[NoticeCode] = set()

    def say(self, utterance: Utterance) -> None:
        if self._mailbox.offer(utterance, monotonic()) is QueueResult.REFUSED:
            self._notify(NoticeCode.SPEECH_BACKLOG)
        if self._thread is None:
            self._start()

    def silence_speech(self) -> None:
        self._mailbox.silence()

    def set_voice(self, voice: VoiceSettings) -> None:
        """Rate, pitch, volume and punctuation of the sentences from now on."""
        self._punctuation = voice.punctuation
        self._mailbox.set_settings(ssip_settings(voice))

    @property
    def is_speaking(self) -> bool:
        return self._mailbox.speaking is not None

    def wait_until_quiet(self, seconds: float) -> bool:
        """Wait until everything was said. False if that took longer than ``seconds``."""
        return self._mailbox.wait_until_quiet(seconds)

    def close(self) -> None:
        """Be silent for good. May be called twice."""
        self._mailbox.close()
        if self._thread is not None and self._thread is not threading.current_thread():
            self._thread.join(_CLOSING_SECONDS)

    def _start(self) -> None:
        with self._starting:
            if self._thread is None and not self._mailbox.is_closed:
                self._thread = threading.Thread(target=self._run, name="ssip", daemon=True)
                self._thread.start()

    def _run(self) -> None:
        failures = FailureCounter()
        on_missing_end = partial(self._notify, NoticeCode.SSIP_SILENT)
        while self._mailbox.wait_for_work():
            try:
                with self._address.connect(_CONNECT_SECONDS) as server:
                    SsipConnection(server, self._mailbox, monotonic, on_missing_end, self._speakable).run(
                        _user()
                    )
            except (ConnectionLost, OSError, SsipProtocolError):
                self._mailbox.put_back()
                if failures.add(monotonic()):
                    self._mailbox.close()
                    self._notify(NoticeCode.SSIP_LOST)

    def _speakable(self, utterance: Utterance) -> str:
        return speakable_text(
            utterance.text, sign_words(utterance.language, self._languages), self._punctuation
        )

    def _notify(self, code: NoticeCode) -> None:
        if code not in self._notified:
            self._notified.add(code)
            self._on_notice(AudioNotice(code))


def ssip_settings(voice: VoiceSettings) -> dict[str, int]:
    """The settings that the learner chose, -100 to 100 as in SSIP; 180 words a minute are rate 0."""
    clamped = voice.clamped()
    difference = clamped.words_per_minute - 180
    settings = {
        "words_per_minute": ("RATE", round(difference / 2.7 if difference > 0 else float(difference))),
        "pitch": ("PITCH", 2 * clamped.pitch - 100),
        "volume": ("VOLUME", round(200 * clamped.volume) - 100),
    }
    return dict(setting for name, setting in settings.items() if name in voice.chosen)


def _user() -> str:
    try:
        return "".join(each for each in getpass.getuser() if each.isalnum()) or "donnie"
    except (OSError, KeyError):
        return "donnie"


class ConnectionLost(Exception):
    """The server is gone."""


class SsipConnection:
    """Says what is in the mailbox through a connected socket.

    The server gets one sentence at a time, and the next one when it reports the end. Without a sound device
    it accepts sentences and never reports an end: a missing end means that there is no sound.
    """

    def __init__(
        self,
        server: socket.socket,
        mailbox: Mailbox,
        now: Callable[[], float],
        on_missing_end: Callable[[], None],
        speakable: Callable[[Utterance], str] = lambda utterance: utterance.text,
    ) -> None:
        """``speakable``: the text of an utterance with its signs in words."""
        self._server, self._mailbox, self._now = server, mailbox, now
        self._on_missing_end, self._speakable = on_missing_end, speakable
        self._reader = ssip.SsipReader()
        self._replies: deque[SsipReply] = deque()
        self._events: deque[SsipEvent] = deque()
        self._language = ""
        self._message: str | None = None
        self._overdue_at = float("inf")

    def run(self, user: str) -> None:
        """Speaks until the mailbox is closed.

        Raises ``ConnectionLost``, ``OSError`` or ``SsipProtocolError``.
        """
        for command in ssip.greeting(user):
            self._request(command)
        self._mailbox.connected()
        while not self._mailbox.is_closed:
            self._do_next()
        with suppress(ConnectionLost, OSError):
            self._request(ssip.CANCEL)
            self._server.sendall(ssip.QUIT)

    def _do_next(self) -> None:
        if self._mailbox.take_silence():
            self._request(ssip.CANCEL)
            self._end_sentence()
        elif settings := self._mailbox.take_settings():
            for name, value in settings.items():
                self._request(ssip.set_parameter(name, value))
        elif (utterance := self._mailbox.take()) is not None:
            self._speak(utterance)
        elif self._events:
            event = self._events.popleft()
            if event.message == self._message and event.kind is not SsipEventKind.BEGIN:
                self._end_sentence()
        elif self._message is not None and self._now() >= self._overdue_at:
            self._on_missing_end()
            self._end_sentence()
        else:
            self._wait(None if self._message is None else max(0.0, self._overdue_at - self._now()))

    def _speak(self, utterance: Utterance) -> None:
        text = self._speakable(utterance)
        if text and utterance.language != self._language:
            self._request(ssip.set_language(utterance.language))
            self._language = utterance.language
        self._message = self._send_message(text) if text else None
        if self._message is None:
            self._end_sentence()
        else:
            self._overdue_at = self._now() + END_SECONDS + SECONDS_A_CHARACTER * len(text)

    def _send_message(self, text: str) -> str | None:
        """The message's number; None if it was refused."""
        if not self._request(ssip.SPEAK).is_ok:
            return None
        return ssip.message_of(self._request(ssip.encode_text(text)))

    def _end_sentence(self) -> None:
        self._message, self._overdue_at = None, float("inf")
        self._mailbox.said()

    def _request(self, command: bytes) -> SsipReply:
        """Send a command and wait for its reply."""
        self._server.sendall(command)
        until = self._now() + REPLY_SECONDS
        while not self._replies:
            if self._now() >= until:
                raise ConnectionLost
            self._receive([self._server], max(0.0, until - self._now()))
        return self._replies.popleft()

    def _wait(self, seconds: float | None) -> None:
        """Wait for the server or for the mailbox."""
        self._receive([self._server, self._mailbox], seconds)
        self._mailbox.clear_signal()

    def _receive(self, sources: list[socket.socket | Mailbox], seconds: float | None) -> None:
        ready, _, _ = select.select(sources, [], [], seconds)
        if self._server not in ready:
            return
        data = self._server.recv(4_096)
        if not data:
            raise ConnectionLost
        for answer in self._reader.feed(data):
            if isinstance(answer, SsipReply):
                self._replies.append(answer)
            else:
                self._events.append(answer)


class Mailbox:
    """Carries utterances from any thread to the one that owns the socket.

    Every call takes a lock for microseconds. ``fileno`` is readable when the owner may have something to do.
    """

    def __init__(self, settings: dict[str, int] | None = None) -> None:
        """``settings``: SSIP parameters; the server's own where none are given."""
        self._changed = threading.Condition()
        self._settings = settings or {}
        self._must_send_settings = False
        self._queue = SpeechQueue()
        self._speaking: Utterance | None = None
        self._must_silence = False
        self._is_closed = False
        self._receiver, self._sender = socket.socketpair()
        self._receiver.setblocking(False)
        self._sender.setblocking(False)

    # --- for any thread

    def offer(self, utterance: Utterance, now: float) -> QueueResult:
        """Queue it; a closed mailbox accepts nothing."""
        with self._changed:
            if self._is_closed:
                return QueueResult.REPEATED
            result = self._queue.offer(utterance, now)
            if self._speaking and interrupts(utterance.urgency, self._speaking.urgency):
                self._must_silence = True
            self._wake()
            return result

    def silence(self) -> None:
        """Drop all utterances of until now, the one that is being said included."""
        with self._changed:
            self._queue.clear()
            self._must_silence = self._must_silence or self._speaking is not None
            self._wake()

    def set_settings(self, settings: dict[str, int]) -> None:
        """The SSIP parameters from now on."""
        with self._changed:
            self._settings, self._must_send_settings = settings, True
            self._wake()

    def close(self) -> None:
        """Close it for good."""
        with self._changed:
            self._is_closed = True
            self._queue.clear()
            self._wake()

    @property
    def is_closed(self) -> bool:
        return self._is_closed

    @property
    def speaking(self) -> Utterance | None:
        """What the server is saying."""
        return self._speaking

    def wait_until_quiet(self, seconds: float) -> bool:
        with self._changed:
            return self._changed.wait_for(self._is_quiet, seconds)

    # --- for the owner of the socket

    def wait_for_work(self) -> bool:
        """Wait until there is something to say. False if the mailbox was closed."""
        with self._changed:
            self._changed.wait_for(lambda: self._is_closed or self._queue)
            return not self._is_closed

    def fileno(self) -> int:
        return self._receiver.fileno()

    def clear_signal(self) -> None:
        """Make ``fileno`` unreadable until the next call of another thread."""
        with suppress(OSError):
            self._receiver.recv(4_096)

    def connected(self) -> None:
        """The server is a new one, and has no settings yet."""
        with self._changed:
            self._must_send_settings = bool(self._settings)

    def take_settings(self) -> dict[str, int]:
        """The parameters that the server doesn't have yet, between two sentences; mostly none."""
        with self._changed:
            if not self._must_send_settings or self._speaking is not None:
                return {}
            self._must_send_settings = False
            return self._settings

    def take(self) -> Utterance | None:
        """The next sentence, unless one is still being said."""
        with self._changed:
            if self._speaking is None and not self._is_closed:
                self._speaking = self._queue.next()
                self._changed.notify_all()
                return self._speaking
            return None

    def take_silence(self) -> bool:
        """Whether the server must be silent now."""
        with self._changed:
            must_silence, self._must_silence = self._must_silence, False
            return must_silence

    def said(self) -> None:
        """The sentence is over."""
        with self._changed:
            self._speaking = None
            self._changed.notify_all()

    def put_back(self) -> None:
        """The server was lost: say the sentence again, because hearing it twice is better than half of it."""
        with self._changed:
            if self._speaking is not None and not self._must_silence:
                self._queue.put_back(self._speaking)
            self._speaking, self._must_silence = None, False
            self._changed.notify_all()

    def _is_quiet(self) -> bool:
        return self._is_closed or not (self._speaking or self._queue or self._must_silence)

    def _wake(self) -> None:
        self._changed.notify_all()
        with suppress(OSError):  # full: the owner will wake up anyway
            self._sender.send(b"!")
