"""A whole Donnie whose voice and cues are recorded instead of played."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager

import pytest

from devices.ports.audio import Cue, Utterance, VoiceSettings
from donnie_tui.bootstrap import Donnie, assemble
from donnie_tui.core.events import Stamped
from donnie_tui.core.transcript import printed_lines
from donnie_tui.outlets import audible
from donnie_tui.settings.settings import Settings
from tests.unit.audio.known_environment import KnownEnvironment

HOME = KnownEnvironment(
    stdout_is_terminal=True, over_ssh=False, screen_reader=None, has_voice=True, has_sound_device=True
)


class RecordingAudio:
    """Replaces the audio worker."""

    def __init__(self) -> None:
        self.heard: list[str] = []
        """Sentences, and cues in brackets, in order."""
        self.cues: list[Cue] = []
        self.voices: list[VoiceSettings] = []
        self.volumes: list[Mapping[str, float]] = []
        self.opened = self.closed = 0
        self.is_mute = False
        self.utterances: list[Utterance] = []

    def say(self, utterance: Utterance) -> None:
        self.utterances.append(utterance)
        self.heard.append(utterance.text)

    def play(self, cue: Cue) -> None:
        self.cues.append(cue)
        self.heard.append(f"[{cue.name}]")

    def silence_speech(self) -> None:
        self.heard.append("(hush)")

    def silence_cues(self) -> None:
        self.heard.append("(no cues)")

    def set_voice(self, voice: VoiceSettings) -> None:
        self.voices.append(voice)

    def set_cue_volumes(self, volumes: Mapping[str, float]) -> None:
        self.volumes.append(volumes)

    def wait_until_quiet(self, seconds: float) -> bool:
        return True

    def close(self) -> None:
        self.closed += 1


class Listening:
    """Donnie, the printed lines, and the recorded sounds."""

    def __init__(self, donnie: Donnie, audio: RecordingAudio) -> None:
        self.donnie, self.audio = donnie, audio
        self.printed: list[str] = []
        donnie.session.hub.subscribe(self._print)

    def _print(self, stamped: Stamped) -> None:
        self.printed += printed_lines(stamped, self.donnie.words)


@contextmanager
def listening(
    monkeypatch: pytest.MonkeyPatch, around: KnownEnvironment = HOME, settings: Settings | None = None
) -> Iterator[Listening]:
    """A learner at home with a voice and a sound device."""
    audio = RecordingAudio()

    def opened(*_: object) -> RecordingAudio:
        audio.opened += 1
        return audio

    monkeypatch.setattr(audible, "DetectedEnvironment", lambda **_: around)
    monkeypatch.setattr("devices.audio.service.AudioService", opened)
    donnie = assemble(settings or Settings(speech="tts", speed=None), terminal=True)
    try:
        yield Listening(donnie, audio)
    finally:
        donnie.close()
