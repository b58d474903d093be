"""What SOUND OFF means: voice and cues are silent at once and stay so; the printed line is another's."""

from __future__ import annotations

from devices.ports.audio import Cue, Utterance
from donnie_tui.core.events import Chimed, CueSounded, SoundSwitched, Spoke
from donnie_tui.core.hub import Hub
from donnie_tui.core.outlets import Cues, Voice
from donnie_tui.i18n.words import Words


class Ear:
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


def test_sound_off_ends_the_voice_and_what_is_told_then_is_print_alone() -> None:
    """S11, Q3."""
    ear, hub = Ear(), Hub(lambda: 0.0)
    hub.subscribe(Voice(ear, Words()))
    for event in (Spoke("one"), SoundSwitched(False), Spoke("two"), SoundSwitched(True), Spoke("three")):
        hub.publish(event)

    assert ear.heard == ["one", "(hush)", "three"]


def test_sound_off_ends_the_cues_and_none_is_played_then() -> None:
    """Q3."""
    ear, hub = Ear(), Hub(lambda: 0.0)
    hub.subscribe(Cues(ear))
    for on in (True, False, True):
        hub.publish(SoundSwitched(on))
        hub.publish(CueSounded("bump", 0.0, None))
        hub.publish(Chimed("block-opened"))

    assert ear.heard == ["bump", "block-opened", "(hush)", "bump", "block-opened"]
