"""Voice and cues for a session, as the settings and the surroundings allow. Nothing is started here.

The worker is woken by the first thing to be heard. What is found missing only then is told by an answer
on the stream, in print, once.
"""

from __future__ import annotations

import os
from contextlib import ExitStack
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

from devices.ports.audio import Cue, CuePlayer, Speaker, Urgency, Utterance
from devices.speech.choose import Channel, ChannelReason, Choice, Facts, SpeakPlace, choose_channel
from devices.speech.probe import look_around, ssip_address
from donnie_tui.core.events import Answered
from donnie_tui.core.hub import HasHub
from donnie_tui.core.outlets import Cues, Hears, Voice
from donnie_tui.folders import own_sounds
from donnie_tui.i18n.words import Words
from donnie_tui.settings import Settings, Source

if TYPE_CHECKING:
    from devices.audio_worker.notices import AudioNotice
    from devices.audio_worker.service import AudioService
    from devices.speech.voices import VoiceSettings

NOTICE_FOR = {
    ChannelReason.OVER_SSH: "voice-over-ssh",
    ChannelReason.SCREEN_READER: "voice-for-reader",
    ChannelReason.NO_VOICE: "no-voice",
    ChannelReason.NO_SOUND_DEVICE: "no-sound-device",
    ChannelReason.NO_SPEECH_DISPATCHER: "no-speech-dispatcher",
}


_PRINT = Choice(Channel.TEXT, ChannelReason.ASKED_FOR)


class _Sounding(Protocol):
    """What can be waited for."""

    def wait_until_quiet(self, seconds: float) -> bool: ...


@dataclass(frozen=True, slots=True)
class Audible:
    """What came of it. All of it returns at once, but for ``is_quiet_within``."""

    notices: tuple[str, ...] = ()
    """What is wanted and not possible, a sentence each."""
    choice: Choice = _PRINT
    speakers: tuple[Speaker, ...] = ()
    cue_player: CuePlayer | None = None
    _sounding: tuple[_Sounding, ...] = ()

    @property
    def speaks(self) -> bool:
        """Whether answers are heard, and not only print."""
        return self.choice.channel is not Channel.TEXT

    def is_quiet_within(self, seconds: float) -> bool:
        """Wait until everything was said, that many seconds at most; False if that was not enough."""
        return all(each.wait_until_quiet(seconds) for each in self._sounding)

    def hush(self) -> None:
        """Nothing said until now is heard any more."""
        for each in self.speakers:
            each.silence()

    def echo(self, text: str, language: str) -> None:
        """Say what was typed."""
        for each in self.speakers[:1]:
            each.say(Utterance(text, Urgency.PROGRESS, language))

    def play(self, cue: Cue) -> None:
        if self.cue_player is not None:
            self.cue_player.play(cue)


def make_audible(
    settings: Settings, session: HasHub, words: Words, closing: ExitStack, *, is_linear: bool = True
) -> Audible:
    """Add the voice and the cues that are wanted and possible. Raises ``Unusable`` where a file can't be."""
    facts = look_around(is_linear=is_linear, has_real_robot=settings.robot.startswith("serial"))
    choice = choose_channel(settings.speech, facts, settings.speak)
    return _Maker(settings, session, words, closing, choice).make(facts)


def wants_cues(settings: Settings, facts: Facts) -> bool:
    """Somebody at this machine hears them, or asked for them."""
    if not settings.sound or isinstance(settings.sound, str) or not facts.has_sound_device:
        return False
    asked_for = settings.source_of("sound") is not Source.DEFAULT
    return asked_for or (facts.stdout_is_terminal and not facts.over_ssh)


def voice_of(settings: Settings) -> VoiceSettings:
    """How the own voice sounds."""
    from devices.speech.voices import VoiceSettings

    return VoiceSettings(settings.rate, settings.pitch, settings.volume / 100, settings.punctuation)


def cue_volumes(settings: Settings) -> dict[str, float]:
    """0 to 1 by the name of a cue."""
    return {name: percent / 100 for name, percent in settings.cues.items()}


class _Maker:
    """Connects what was chosen with the stream."""

    def __init__(
        self, settings: Settings, session: HasHub, words: Words, closing: ExitStack, choice: Choice
    ) -> None:
        self._settings, self._session, self._words = settings, session, words
        self._closing, self._choice = closing, choice
        self._speakers: list[Speaker] = []
        self._sounding: list[_Sounding] = []

    def make(self, facts: Facts) -> Audible:
        cues = wants_cues(self._settings, facts)
        speaks = self._choice.channel is Channel.TTS or self._choice.speak is not SpeakPlace.HERE
        audio = self._worker() if speaks or cues else None
        self._connect_voices(audio)
        player = self._cue_player(audio if cues else None)
        notice = NOTICE_FOR.get(self._choice.reason)
        notices = (self._words(notice),) if notice else ()
        return Audible(notices, self._choice, tuple(self._speakers), player, tuple(self._sounding))

    def _connect_voices(self, audio: AudioService | None) -> None:
        from devices.audio_worker.factory import make_speaker

        match self._choice.channel:
            case Channel.TTS:
                self._voice(make_speaker(audio), Hears.ALL)
            case Channel.SSIP:
                at_robot_only = self._choice.speak is SpeakPlace.ROBOT
                self._voice(self._ssip(), Hears.ANSWERS if at_robot_only else Hears.ALL)
        if self._choice.speak is not SpeakPlace.HERE:
            self._voice(make_speaker(audio), Hears.PROGRAM)

    def _voice(self, speaker: Speaker, hears: Hears) -> None:
        self._speakers.append(speaker)
        self._session.hub.subscribe(Voice(speaker, self._words, hears))

    def _worker(self) -> AudioService:
        from devices.audio_worker.factory import make_audio
        from devices.audio_worker.service import AudioSettings

        settings = AudioSettings(
            voice_of(self._settings), cue_volumes(self._settings), sounds=own_sounds(os.environ)
        )
        audio = make_audio(settings, self._tell)
        self._closing.callback(audio.close)
        self._sounding.append(audio)
        return audio

    def _ssip(self) -> Speaker:
        from devices.ssip.speaker import SsipSpeaker

        address = ssip_address(os.environ)
        assert address is not None  # it was reached when the channel was chosen
        chosen = self._settings.source_of("rate") is not Source.DEFAULT
        voice = voice_of(self._settings) if chosen else None
        speaker = SsipSpeaker(address, self._tell, voice, self._settings.punctuation)
        self._closing.callback(speaker.close)
        self._sounding.append(speaker)
        return speaker

    def _cue_player(self, audio: AudioService | None) -> CuePlayer | None:
        if isinstance(self._settings.sound, str):
            from donnie_tui.sound_file import write_cues

            write_cues(self._settings.sound, self._session, self._words, self._closing)
        if audio is None:
            return None
        from devices.audio_worker.factory import make_cue_player

        player = make_cue_player(audio)
        self._session.hub.subscribe(Cues(player))
        return player

    def _tell(self, notice: AudioNotice) -> None:
        language = self._words(f"language-{notice.language}") if notice.language else ""
        self._session.hub.publish(Answered(self._words(notice.code.value, language=language)))
