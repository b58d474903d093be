"""Which channel an utterance goes out by (S9, V1): text, or Donnie's own voice. Pure.

Codes only; the sentences that tell the choice are made elsewhere. What the user asks for wins over what
is guessed, but never over what is possible: without a voice or a sound device it is text, and why is told.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Channel(Enum):
    """By what an utterance reaches the learner; its text twin is printed whatever it is."""

    TEXT = "text"
    TTS = "tts"


class ChannelReason(Enum):
    """Why this channel."""

    ASKED_FOR = "asked-for"
    """The user said so: ``off``, ``text`` or ``tts``."""
    NOT_A_TERMINAL = "not-a-terminal"
    OVER_SSH = "over-ssh"
    """The far machine's loudspeaker would be the wrong one."""
    SCREEN_READER = "screen-reader"
    """A screen reader reads what is printed, so Donnie is silent."""
    OWN_VOICE = "own-voice"
    NO_VOICE = "no-voice"
    NO_SOUND_DEVICE = "no-sound-device"


class SpeechWish(Enum):
    """What the user asks for, as ``--speech`` writes it."""

    AUTO = "auto"
    OFF = "off"
    TEXT = "text"
    TTS = "tts"


@dataclass(frozen=True, slots=True)
class Facts:
    """What is known about the surroundings before anything is started."""

    stdout_is_terminal: bool
    over_ssh: bool
    screen_reader: str | None
    """Its name, such as ``orca``, or None if none was found; one can never be excluded."""
    has_voice: bool
    has_sound_device: bool


@dataclass(frozen=True, slots=True)
class Choice:
    """A channel, and why."""

    channel: Channel
    reason: ChannelReason


def choose_channel(wanted: SpeechWish | str, facts: Facts) -> Choice:
    """Decide. ``wanted`` is a ``SpeechWish`` or its word; ``ValueError`` for another word."""
    wish = SpeechWish(wanted)
    if wish in (SpeechWish.OFF, SpeechWish.TEXT):
        return Choice(Channel.TEXT, ChannelReason.ASKED_FOR)
    if wish is SpeechWish.AUTO and (reason := _why_text_is_better(facts)):
        return Choice(Channel.TEXT, reason)
    if reason := _why_there_is_no_voice(facts):
        return Choice(Channel.TEXT, reason)
    asked_for = wish is SpeechWish.TTS
    return Choice(Channel.TTS, ChannelReason.ASKED_FOR if asked_for else ChannelReason.OWN_VOICE)


def _why_text_is_better(facts: Facts) -> ChannelReason | None:
    if not facts.stdout_is_terminal:
        return ChannelReason.NOT_A_TERMINAL
    if facts.over_ssh:
        return ChannelReason.OVER_SSH
    if facts.screen_reader is not None:
        return ChannelReason.SCREEN_READER
    return None


def _why_there_is_no_voice(facts: Facts) -> ChannelReason | None:
    if not facts.has_voice:
        return ChannelReason.NO_VOICE
    if not facts.has_sound_device:
        return ChannelReason.NO_SOUND_DEVICE
    return None
