"""Which channel an utterance goes out by (S9, V1): text, speech-dispatcher, or Donnie's own voice. Pure.

Codes only; the sentences that tell the choice are made elsewhere. What the user asks for wins over what
is guessed, but never over what is possible: without a voice or a sound device it is text, and why is told.
"""

from __future__ import annotations

from enum import Enum

from devices.ports.hints import Protocol
from devices.ports.values import Frozen


class Channel(Enum):
    """By what an utterance reaches the learner; its text twin is printed whatever it is."""

    TEXT = "text"
    SSIP = "ssip"
    TTS = "tts"


class ChannelReason(Enum):
    """Why this channel."""

    ASKED_FOR = "asked-for"
    """The user said so."""
    NOT_A_TERMINAL = "not-a-terminal"
    OVER_SSH = "over-ssh"
    """The far machine's loudspeaker would be the wrong one."""
    SCREEN_READER = "screen-reader"
    """A screen reader reads what is printed, so Donnie is silent."""
    READERS_VOICE = "readers-voice"
    """A screen reader runs, but can't follow a full screen: what is told goes behind it in its queue."""
    SPEECH_DISPATCHER = "speech-dispatcher"
    """It is there, so it speaks, at home too where its socket was brought here by SSH."""
    NO_SPEECH_DISPATCHER = "no-speech-dispatcher"
    OWN_VOICE = "own-voice"
    NO_VOICE = "no-voice"
    NO_SOUND_DEVICE = "no-sound-device"


class SpeechWish(Enum):
    """What the user asks for, as ``--speech`` writes it."""

    AUTO = "auto"
    OFF = "off"
    TEXT = "text"
    SSIP = "ssip"
    TTS = "tts"
    ROBOT = "robot"
    """Only SPEAK is heard, where the robot is; answers are in print."""


class SpeakPlace(Enum):
    """Where the words of SPEAK are heard."""

    HERE = "here"
    """By the channel of the answers."""
    ROBOT = "robot"
    """By the voice of the machine on which Donnie runs: over SSH that is the robot's laptop."""
    BOTH = "both"


class Surroundings(Protocol):
    """``Facts``, or what finds each of them when it is asked for."""

    @property
    def stdout_is_terminal(self) -> bool: ...

    @property
    def over_ssh(self) -> bool: ...

    @property
    def screen_reader(self) -> str | None: ...

    @property
    def has_voice(self) -> bool: ...

    @property
    def has_sound_device(self) -> bool: ...

    @property
    def has_ssip(self) -> bool: ...

    @property
    def is_linear(self) -> bool: ...

    @property
    def has_real_robot(self) -> bool: ...


class Facts(Frozen):
    """What is known about the surroundings before anything is started."""

    stdout_is_terminal: bool
    over_ssh: bool
    screen_reader: str | None
    """Its name, such as ``orca``, or None if none was found; one can never be excluded."""
    has_voice: bool
    has_sound_device: bool
    has_ssip: bool = False
    """Whether a speech-dispatcher takes our connection that is heard by the learner."""
    is_linear: bool = True
    """Whether what is told is printed in lines, which a screen reader reads by itself."""
    has_real_robot: bool = False


class Choice(Frozen):
    """A channel, and why."""

    channel: Channel
    reason: ChannelReason
    speak: SpeakPlace = SpeakPlace.HERE
    """Where SPEAK is heard."""


def choose_channel(
    wanted: SpeechWish | str, facts: Surroundings, place: SpeakPlace | str = SpeakPlace.HERE
) -> Choice:
    """Decide. ``wanted`` and ``place`` are given themselves or by their words; ``ValueError`` for others."""
    wish, place = SpeechWish(wanted), SpeakPlace(place)
    choice = _channel_of_answers(wish, facts)
    return Choice(choice.channel, choice.reason, _place_of_speak(wish, facts, place, choice.channel))


def _channel_of_answers(wish: SpeechWish, facts: Surroundings) -> Choice:
    match wish:
        case SpeechWish.OFF | SpeechWish.TEXT | SpeechWish.ROBOT:
            return Choice(Channel.TEXT, ChannelReason.ASKED_FOR)
        case SpeechWish.SSIP:
            return _ssip(facts)
        case SpeechWish.TTS:
            return _own_voice(facts, ChannelReason.ASKED_FOR)
        case SpeechWish.AUTO:
            return _guessed(facts)


def _guessed(facts: Surroundings) -> Choice:
    if not facts.stdout_is_terminal:
        return Choice(Channel.TEXT, ChannelReason.NOT_A_TERMINAL)
    if facts.over_ssh and not facts.has_ssip:
        return Choice(Channel.TEXT, ChannelReason.OVER_SSH)
    if facts.screen_reader is not None and (facts.is_linear or not facts.has_ssip):
        return Choice(Channel.TEXT, ChannelReason.SCREEN_READER)
    if facts.has_ssip:
        with_reader = facts.screen_reader is not None
        reason = ChannelReason.READERS_VOICE if with_reader else ChannelReason.SPEECH_DISPATCHER
        return Choice(Channel.SSIP, reason)
    return _own_voice(facts, ChannelReason.OWN_VOICE)


def _ssip(facts: Surroundings) -> Choice:
    if facts.has_ssip:
        return Choice(Channel.SSIP, ChannelReason.ASKED_FOR)
    return Choice(Channel.TEXT, ChannelReason.NO_SPEECH_DISPATCHER)


def _own_voice(facts: Surroundings, reason: ChannelReason) -> Choice:
    if not facts.has_voice:
        return Choice(Channel.TEXT, ChannelReason.NO_VOICE)
    if not facts.has_sound_device:
        return Choice(Channel.TEXT, ChannelReason.NO_SOUND_DEVICE)
    return Choice(Channel.TTS, reason)


def _place_of_speak(wish: SpeechWish, facts: Surroundings, place: SpeakPlace, channel: Channel) -> SpeakPlace:
    if wish is SpeechWish.OFF or channel is Channel.TTS or not (facts.has_voice and facts.has_sound_device):
        return SpeakPlace.HERE  # silent, said by that very voice, or impossible
    is_robot_listened_to = wish is SpeechWish.AUTO and facts.over_ssh and facts.has_real_robot
    if wish is SpeechWish.ROBOT or (is_robot_listened_to and place is SpeakPlace.HERE):
        return SpeakPlace.ROBOT
    return place
