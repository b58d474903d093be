"""SOUND OFF silences voice and cues at once and keeps them silent. It does not affect printed lines."""

from __future__ import annotations

from devices.ports.audio import Cue, Utterance
from donnie_tui.core.events import Chimed, CueSounded, SoundSwitched, Spoke
from donnie_tui.core.hub import Hub
from donnie_tui.core.outlets import Cues, Voice
from donnie_tui.i18n.words import Words


class RecordingAudio:
    """A voice and a player of cues."""

    def __init__(self) -> None:
        self.heard: list[str] = []

    def say(self, utterance: Utterance) -> None:
        self.heard.append(utterance.text)

    def play(self, cue: Cue) -> None:
        self.heard.append(cue.name)

    def silence(self) -> None:
        self.heard.append("(hush)")

    def close(self) -> None: ...


def test_sound_off_ends_the_voice_and_later_announcements_are_only_printed() -> None:
    """SOUND ON restores the voice."""
    audio, hub = RecordingAudio(), Hub(lambda: 0.0)
    hub.subscribe(Voice(audio, Words()))
    for event in (Spoke("one"), SoundSwitched(False), Spoke("two"), SoundSwitched(True), Spoke("three")):
        hub.publish(event)

    assert audio.heard == ["one", "(hush)", "three"]


def test_sound_off_ends_the_cues_and_none_is_played_then() -> None:
    """SOUND ON restores the cues."""
    audio, hub = RecordingAudio(), Hub(lambda: 0.0)
    hub.subscribe(Cues(audio))
    for on in (True, False, True):
        hub.publish(SoundSwitched(on))
        hub.publish(CueSounded("bump", 0.0, None))
        hub.publish(Chimed("block-opened"))

    assert audio.heard == ["bump", "block-opened", "(hush)", "bump", "block-opened"]
