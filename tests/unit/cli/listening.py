"""A whole Donnie whose voice and cues are written down instead of heard."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager

import pytest

from devices.ports.audio import Cue, Utterance
from devices.speech.choose import Facts
from devices.speech.voices import VoiceSettings
from donnie_tui.bootstrap import Donnie, assemble
from donnie_tui.core.events import Stamped
from donnie_tui.core.transcript import told_lines
from donnie_tui.outlets import audible
from donnie_tui.settings.chosen import Settings

HOME = Facts(
    stdout_is_terminal=True, over_ssh=False, screen_reader=None, has_voice=True, has_sound_device=True
)


class Ear:
    """Takes the place of the audio worker."""

    def __init__(self) -> None:
        self.heard: list[str] = []
        """Sentences, and cues in brackets, in order."""
        self.cues: list[Cue] = []
        self.voices: list[VoiceSettings] = []
        self.volumes: list[Mapping[str, float]] = []
        self.opened = self.closed = 0
        self.is_mute = False

    def say(self, utterance: Utterance) -> None:
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
    """Donnie, what is printed, and what is heard."""

    def __init__(self, donnie: Donnie, ear: Ear) -> None:
        self.donnie, self.ear = donnie, ear
        self.printed: list[str] = []
        donnie.session.hub.subscribe(self._print)

    def _print(self, stamped: Stamped) -> None:
        self.printed += told_lines(stamped, self.donnie.words)


@contextmanager
def listening(
    monkeypatch: pytest.MonkeyPatch, around: Facts = HOME, settings: Settings | None = None
) -> Iterator[Listening]:
    """Somebody at home with a voice and a sound device."""
    ear = Ear()

    def opened(*_: object) -> Ear:
        ear.opened += 1
        return ear

    monkeypatch.setattr(audible, "look_around", lambda **_: around)
    monkeypatch.setattr("devices.audio_worker.factory.make_audio", opened)
    donnie = assemble(settings or Settings(speech="tts", speed=None), terminal=True)
    try:
        yield Listening(donnie, ear)
    finally:
        donnie.close()
