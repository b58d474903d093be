"""Voice and cues of a session, as the settings and the environment allow. Nothing is started here.

The first utterance or cue starts the worker. A device that turns out to be missing is reported once, by an
answer on the stream.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from typing import TYPE_CHECKING

from msgspec.structs import replace

from devices.audio.channel import (
    Channel,
    ChannelReason,
    DetectedEnvironment,
    SpeakPlace,
    choose_channel,
    ssip_address,
)
from devices.ports.audio import CuePlayer, Speaker, Urgency, Utterance
from donnie_tui.core.events import Answered, SoundSwitched, Stamped
from donnie_tui.core.hub import Hub
from donnie_tui.core.session_log import letter_by_letter
from donnie_tui.core.transcript import TranscriptFilter, UnfilteredTranscript
from donnie_tui.core.voice import Cues, Voice, VoiceScope
from donnie_tui.core.wording import Wording, name_of_language
from donnie_tui.i18n.words import Words
from donnie_tui.settings.folders import own_sounds
from donnie_tui.settings.settings import Settings, SettingSource
from language.locales import keys, languages, own_words, table

if TYPE_CHECKING:
    from devices.audio.pronunciation import SignWords, SpokenLanguage
    from devices.audio.service import AudioService
    from devices.audio.speech_dispatcher import SsipSpeaker
    from devices.ports.audio import AudioNotice, VoiceSettings

DECIDED_FOR = {
    ChannelReason.OVER_SSH: "voice-over-ssh",
    ChannelReason.SCREEN_READER: "voice-for-reader",
    ChannelReason.READERS_VOICE: "voice-after-reader",
    ChannelReason.SPEECH_DISPATCHER: "voice-by-dispatcher",
    ChannelReason.OWN_VOICE: "voice-own",
}
"""Choices that Donnie made without a setting, each with the word that changes it."""
NOTICE_FOR = {
    ChannelReason.NO_VOICE: "no-voice",
    ChannelReason.NO_SOUND_DEVICE: "no-sound-device",
    ChannelReason.NO_SPEECH_DISPATCHER: "no-speech-dispatcher",
}


def make_audible(
    settings: Settings, hub: Hub, words: Words, closing: ExitStack, *, is_linear: bool = True
) -> Audible:
    """Subscribe the voice and the cues that are requested and possible."""
    audible = Audible(settings, hub, words, is_linear=is_linear)
    closing.callback(audible.close)
    return audible


class Audible:
    """Voice and cues of a session, which may change meanwhile.

    For the main thread, except ``is_quiet_within``, which may wait; everything else returns at once.
    """

    def __init__(self, settings: Settings, hub: Hub, words: Words, *, is_linear: bool) -> None:
        self.settings, self._hub, self._words = settings, hub, words
        self._is_linear = is_linear
        self.is_on = True
        """What SOUND said last."""
        self.hushed = 0
        """The number of hushes so far; a long sequence of sounds stops when it changes."""
        self._reporting: TranscriptFilter = UnfilteredTranscript()
        self._unsubscribe = hub.subscribe(self._on_event)
        self._make()

    def _make(self) -> None:
        self._own = ExitStack()
        self._facts = DetectedEnvironment(
            is_linear=self._is_linear, has_real_robot=self.settings.robot.startswith("serial")
        )
        self.choice = choose_channel(self.settings.speech, self._facts, self.settings.speak)
        has_cues = wants_cues(self.settings, self._facts)
        speaks = self.choice.channel is Channel.TTS or self.choice.speak is not SpeakPlace.HERE
        self._speakers: list[Speaker] = []
        self._voiced: list[AudioService | SsipSpeaker] = []
        self._audio = self._worker() if speaks or has_cues else None
        self._connect_voices()
        self._cue_player: CuePlayer | None = self._audio if has_cues else None
        if self._cue_player is not None:
            self._own.callback(self._hub.subscribe(Cues(self._cue_player, is_on=self.is_on)))
        notice = NOTICE_FOR.get(self.choice.reason)
        self.notices: tuple[str, ...] = (self._words(notice),) if notice else ()
        """Sentences about requested devices that are not possible."""
        self.decided: str | None = DECIDED_FOR.get(self.choice.reason)
        """The code of the sentence about the automatic choice of the voice."""

    def _connect_voices(self) -> None:
        at_robot_only = self.choice.speak is SpeakPlace.ROBOT
        if self.choice.channel is Channel.SSIP:
            self._voice(self._ssip(), VoiceScope.ANSWERS if at_robot_only else VoiceScope.ALL)
        if self._audio is not None and self.choice.channel is Channel.TTS:
            self._voice(self._audio, VoiceScope.ALL)
        if self._audio is not None and self.choice.speak is not SpeakPlace.HERE:
            self._voice(self._audio, VoiceScope.PROGRAM)

    def _voice(self, speaker: Speaker, scope: VoiceScope) -> None:
        self._speakers.append(speaker)
        voice = Voice(
            speaker, self._words, scope, is_on=self.is_on, transcript_filter=lambda: self._reporting
        )
        self._own.callback(self._hub.subscribe(voice))

    def _worker(self) -> AudioService:
        from devices.audio.service import AudioService, AudioSettings

        settings = AudioSettings(
            voice_of(self.settings),
            cue_volumes(self.settings),
            sounds=own_sounds(os.environ),
            languages=spoken_languages(),
        )
        audio = AudioService(settings, self._report)
        self._own.callback(audio.close)
        self._voiced.append(audio)
        return audio

    def _ssip(self) -> Speaker:
        from devices.audio.speech_dispatcher import SsipSpeaker

        address = ssip_address(os.environ)
        assert address is not None  # it was reached when the channel was chosen
        speaker = SsipSpeaker(address, self._report, voice_of(self.settings), spoken_languages())
        self._own.callback(speaker.close)
        self._voiced.append(speaker)
        return speaker

    def _report(self, notice: AudioNotice) -> None:
        language = name_of_language(notice.language, self._words.language) if notice.language else ""
        self._hub.publish(Answered(self._words(notice.code.value, language=language)))

    def close(self) -> None:
        """Be silent for good."""
        self._unsubscribe()
        self._own.close()

    def speak_only(self, transcript_filter: TranscriptFilter) -> Callable[[], None]:
        """Speak only the lines that the filter prints. Returns a function that ends this."""
        self._reporting = transcript_filter
        return self.speak_everything

    def speak_everything(self) -> None:
        """Speak every sentence."""
        self._reporting = UnfilteredTranscript()

    @property
    def speaks(self) -> bool:
        """Whether answers are spoken, and not only printed."""
        return self.choice.channel is not Channel.TEXT

    @property
    def has_cues(self) -> bool:
        """Whether cues are audible now."""
        return self._cue_player is not None and self.is_on and not self._is_mute

    @property
    def why_no_cues(self) -> str:
        """The code of the sentence that says why no cue sounds now, and what to do."""
        if self._is_mute:
            return "cues-no-device"
        if self._cue_player is not None:
            return "cues-switched-off"
        is_missing = bool(self.settings.sound) and not self._facts.has_sound_device
        return "cues-no-device" if is_missing else "cues-silent"

    @property
    def echoes(self) -> bool:
        """Whether the built-in voice may speak typed keys, which it leaves to a screen reader."""
        is_own = self.choice.channel is Channel.TTS and self._facts.screen_reader is None
        return is_own and self.is_on

    def is_quiet_within(self, seconds: float) -> bool:
        """Wait until everything was said, that many seconds at most; False if that was not enough."""
        return all(each.wait_until_quiet(seconds) for each in self._voiced)

    def is_still_within(self, seconds: float) -> bool:
        """As ``is_quiet_within``, for utterances and cues."""
        audio = self._audio
        return self.is_quiet_within(seconds) and (audio is None or audio.wait_until_silent(seconds))

    def hush(self) -> None:
        """Stop all utterances so far."""
        self.hushed += 1
        for each in self._speakers:
            each.silence_speech()

    def hush_all(self) -> None:
        """Stop all utterances and cues."""
        self.hush()
        if self._cue_player is not None:
            self._cue_player.silence_cues()

    def say_printed(self, *lines: str) -> None:
        """Speak the lines that were printed before there was a voice, such as the greeting."""
        for each in self._speakers[:1] if self.speaks and self.is_on else ():
            for line in lines:
                each.say(Utterance(line, Urgency.ANSWER, self._words.language))

    def echo(self, text: str) -> None:
        """Speak typed text."""
        for each in self._speakers[:1]:
            each.say(Utterance(text, Urgency.PROGRESS, self._words.language))

    # --- changing

    def adjust(self, **changed: object) -> None:
        """Change settings, by the names of their fields."""
        sources = {**self.settings.sources, **dict.fromkeys(changed, SettingSource.OPTION)}
        self.settings = replace(self.settings, sources=sources, **changed)
        if changed.keys() & _OF_THE_CHANNEL:
            self._make_anew()
        elif changed.keys() & _OF_THE_VOICE:
            for each in self._voiced:
                each.set_voice(voice_of(self.settings))
        elif self._audio is not None:
            self._audio.set_cue_volumes(cue_volumes(self.settings))

    def move_to(self, *, is_linear: bool) -> None:
        """Close the voice before the other mode chooses its own."""
        if is_linear != self._is_linear:
            self._is_linear = is_linear
            self._make_anew()

    @property
    def _is_mute(self) -> bool:
        """Whether a device was looked for, and there is none that works."""
        return self._audio is not None and self._audio.is_mute

    def _make_anew(self) -> None:
        self._own.close()
        self._make()

    def _on_event(self, stamped: Stamped) -> None:
        if isinstance(stamped.event, SoundSwitched):
            self.is_on = stamped.event.on


_OF_THE_CHANNEL = {"speech", "speak", "sound"}
_OF_THE_VOICE = {"rate", "pitch", "volume", "punctuation"}


def wants_cues(settings: Settings, facts: DetectedEnvironment) -> bool:
    """Whether this machine can play cues, or they were asked for."""
    if not settings.sound or isinstance(settings.sound, str) or not facts.has_sound_device:
        return False
    asked_for = settings.source_of("sound") is not SettingSource.DEFAULT
    return asked_for or (facts.stdout_is_terminal and not facts.over_ssh)


def voice_of(settings: Settings) -> VoiceSettings:
    """The settings of the built-in voice."""
    from devices.ports.audio import VoiceSettings

    names = {"rate": "words_per_minute", "pitch": "pitch", "volume": "volume"}
    chosen = {name for key, name in names.items() if settings.source_of(key) is not SettingSource.DEFAULT}
    return VoiceSettings(
        settings.rate, settings.pitch, settings.volume / 100, settings.punctuation, frozenset(chosen)
    )


def cue_volumes(settings: Settings) -> dict[str, float]:
    """0 to 1 by the name of a cue."""
    return {name: percent / 100 for name, percent in settings.cues.items()}


def spoken_languages() -> Mapping[str, SpokenLanguage]:
    """The languages of the voice, by code, each with the tag of its voice."""
    from devices.audio.pronunciation import SpokenLanguage

    return {
        each: SpokenLanguage(_words(each, "voices") or (each,), _sign_words(each)) for each in languages()
    }


def _sign_words(language: str) -> SignWords | None:
    """The names of signs and numbers; None if the numbers are missing."""
    from devices.audio.pronunciation import SignWords

    minus, point, degree, degrees = (
        "".join(_words(language, each)[:1]) for each in ("minus", "point", "degree", "degrees")
    )
    if not (minus and point and degree and degrees):
        return None
    spoken = table(language, "words").get("spoken")
    digit_by_digit = isinstance(spoken, dict) and spoken.get("digit_by_digit") is True
    return SignWords(
        *(minus, point, degree, degrees, digit_by_digit),
        *(_signs(language, "signs"), _signs(language, "punctuation")),
    )


def _signs(language: str, section: str) -> Mapping[str, str]:
    signs = keys(language, "words", "spoken", section)
    return {sign: _words(language, section, sign)[0] for sign in signs if _words(language, section, sign)}


def _words(language: str, *entry: str) -> tuple[str, ...]:
    return own_words(language, "words", "spoken", *entry)


LONGEST_PASTED = 200
"""Characters of a pasted text that are said."""


class TypingEcho:
    """Speaks typed keys, for both front ends: characters, words or nothing.

    Silent if a screen reader speaks them. Call it before each change, with the text ``before`` the cursor.
    """

    def __init__(self, audible: Audible, words: Wording) -> None:
        self._audible = audible
        self._words = words

    @property
    def kind(self) -> str:
        """The spoken units; ``none`` if a screen reader speaks them."""
        return self._audible.settings.key_echo if self._audible.echoes else "none"

    def typed(self, text: str, before: str) -> None:
        """Speak a character, or a pasted text."""
        if self.kind == "characters":
            self._say(text)
        elif self.kind == "words" and text.endswith(" "):
            self._say_word(before + text)

    def deleted(self, before: str) -> None:
        """Speak the character before the cursor, which is deleted."""
        if self.kind == "characters":
            self._say(before[-1:])

    def ended(self, before: str) -> None:
        """Speak the word that Enter ends."""
        if self.kind == "words":
            self._say_word(before)

    def _say(self, text: str) -> None:
        if len(text) == 1:
            self._audible.echo(" ".join(letter_by_letter(text, self._words)))
        elif text.strip():
            self._audible.echo(text[:LONGEST_PASTED])

    def _say_word(self, line: str) -> None:
        words = line.split()
        if words:
            self._audible.echo(words[-1][:LONGEST_PASTED])
