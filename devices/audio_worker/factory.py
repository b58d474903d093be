"""What the rest of Donnie uses: a speaker and a cue player that share one audio worker.

audio = make_audio(AudioSettings(), on_notice)     nothing is started
speaker, cues = make_speaker(audio), make_cue_player(audio)
audio.warm_up()                                    after the first prompt or frame
audio.close()                                      leaves nothing running
"""

from __future__ import annotations

from collections.abc import Callable

from devices.audio_worker.notices import AudioNotice
from devices.audio_worker.service import AudioService, AudioSettings
from devices.ports.audio import Cue, CuePlayer, Speaker, Utterance
from devices.sound.silent import SilentCuePlayer
from devices.speech.silent import SilentSpeaker


def make_audio(settings: AudioSettings, on_notice: Callable[[AudioNotice], None]) -> AudioService:
    """The worker that both share; its process starts in the background with the first thing to be heard.

    ``on_notice`` is called by a background thread, each notice once; it must not block nor raise.
    """
    return AudioService(settings, on_notice)


def make_speaker(audio: AudioService | None) -> Speaker:
    """Donnie's own voice, or a silent speaker where text is the channel (None)."""
    return SilentSpeaker() if audio is None else _WorkerSpeaker(audio)


def make_cue_player(audio: AudioService | None) -> CuePlayer:
    """Cues, or silence where there are to be none (None)."""
    return SilentCuePlayer() if audio is None else _WorkerCuePlayer(audio)


class _WorkerSpeaker:
    """Says it through the worker."""

    def __init__(self, audio: AudioService) -> None:
        self._audio = audio

    def say(self, utterance: Utterance) -> None:
        self._audio.say(utterance)

    def silence(self) -> None:
        self._audio.silence_speech()

    def close(self) -> None:
        """Be silent for good; the worker is the audio service's to close, as the cues may still need it."""
        self._audio.silence_speech()


class _WorkerCuePlayer:
    """Plays through the worker."""

    def __init__(self, audio: AudioService) -> None:
        self._audio = audio

    def play(self, cue: Cue) -> None:
        self._audio.play(cue)

    def silence(self) -> None:
        self._audio.silence_cues()

    def close(self) -> None:
        """Be silent; the worker is the audio service's to close."""
        self._audio.silence_cues()
