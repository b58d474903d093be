"""What the learner should be told about voice and sound, once each: codes; the sentences are i18n's."""

from __future__ import annotations

from enum import Enum

from devices.ports.values import Frozen


class NoticeCode(Enum):
    """Each is told at most once, ``VOICE_MISSING`` once a language."""

    NO_SOUND_DEVICE = "no-sound-device"
    """Nothing here makes a sound. Everything is in print."""
    NO_VOICE = "no-voice"
    """There are cues, but no voice: espeak-ng is missing or broken."""
    VOICE_MISSING = "voice-missing"
    """No voice reads ``language``; what is said in it is in print only."""
    AUDIO_GAVE_UP = "audio-gave-up"
    """The audio worker failed three times in a minute. Everything is in print until the next start."""
    SPEECH_BACKLOG = "speech-backlog"
    """The program speaks faster than can be said, for hours; from here on some of it is in print only."""
    SSIP_SILENT = "ssip-silent"
    """speech-dispatcher takes what is said and never tells its end: it has no sound device."""
    SSIP_LOST = "ssip-lost"
    """speech-dispatcher was lost three times in a minute. Everything is in print until the next start."""


class AudioNotice(Frozen):
    """One thing to be told."""

    code: NoticeCode
    language: str = ""
    """``en``, ``pt`` or ``es``, where the code is about one."""
