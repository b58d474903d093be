"""Voice and cues for a session, as the settings and the surroundings allow. Nothing is started here.

The worker is woken by the first thing to be heard. What is found missing only then is told by an answer
on the stream, in print, once.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from typing import TYPE_CHECKING

from devices.speech.choose import Channel, ChannelReason, Facts, choose_channel
from devices.speech.probe import look_around
from donnie_tui.core.events import Answered
from donnie_tui.core.outlets import Cues, Voice
from donnie_tui.core.session import Session
from donnie_tui.i18n.words import Words
from donnie_tui.settings import Settings, Source

if TYPE_CHECKING:
    from devices.audio_worker.notices import AudioNotice

_NOTICE_FOR = {
    ChannelReason.OVER_SSH: "voice-over-ssh",
    ChannelReason.SCREEN_READER: "voice-for-reader",
    ChannelReason.NO_VOICE: "no-voice",
    ChannelReason.NO_SOUND_DEVICE: "no-sound-device",
}


@dataclass(frozen=True, slots=True)
class Audible:
    """What came of it."""

    notices: tuple[str, ...] = ()
    """What is wanted and not possible, a sentence each."""
    is_quiet_within: Callable[[float], bool] = lambda _: True
    """Wait until everything was said, that many seconds at most; False if that was not enough."""


def make_audible(settings: Settings, session: Session, words: Words, closing: ExitStack) -> Audible:
    """Add the voice and the cues that are wanted and possible."""
    facts = look_around()
    choice = choose_channel(settings.speech, facts)
    speaks, cues = choice.channel is Channel.TTS, wants_cues(settings, facts)
    notice = _NOTICE_FOR.get(choice.reason)
    notices = (words(notice),) if notice else ()
    if not (speaks or cues):
        return Audible(notices)
    return Audible(notices, _connect(session, words, closing, speaks=speaks, cues=cues))


def _connect(
    session: Session, words: Words, closing: ExitStack, *, speaks: bool, cues: bool
) -> Callable[[float], bool]:
    from devices.audio_worker.factory import make_audio, make_cue_player, make_speaker
    from devices.audio_worker.service import AudioSettings

    audio = make_audio(AudioSettings(), lambda notice: _tell(notice, session, words))
    closing.callback(audio.close)
    session.hub.subscribe(Voice(make_speaker(audio if speaks else None), words))
    session.hub.subscribe(Cues(make_cue_player(audio if cues else None)))
    return audio.wait_until_quiet


def wants_cues(settings: Settings, facts: Facts) -> bool:
    """Somebody at this machine hears them, or asked for them."""
    if not settings.sound or not facts.has_sound_device:
        return False
    asked_for = settings.source_of("sound") is not Source.DEFAULT
    return asked_for or (facts.stdout_is_terminal and not facts.over_ssh)


def _tell(notice: AudioNotice, session: Session, words: Words) -> None:
    language = words(f"language-{notice.language}") if notice.language else ""
    session.hub.publish(Answered(words(notice.code.value, language=language)))
