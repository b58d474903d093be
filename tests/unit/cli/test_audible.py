"""Voice and cues as the settings and the surroundings allow; what is not possible is told in one sentence."""

from contextlib import ExitStack
from dataclasses import replace

import pytest

from devices.speech.choose import Facts
from donnie_tui import audible
from donnie_tui.audible import make_audible, wants_cues
from donnie_tui.i18n.words import Words
from donnie_tui.settings import Settings, Source
from tests.floor import Floor

HOME = Facts(
    stdout_is_terminal=True, over_ssh=False, screen_reader=None, has_voice=True, has_sound_device=True
)
ASKED = {"sound": Source.OPTION}


def facts(**changes: object) -> Facts:
    return replace(HOME, **changes)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("settings", "around", "wanted"),
    [
        (Settings(), HOME, True),
        (Settings(sound=False), HOME, False),
        (Settings(), facts(has_sound_device=False), False),
        (Settings(), facts(over_ssh=True), False),
        (Settings(sources=ASKED), facts(over_ssh=True), True),
        (Settings(), facts(stdout_is_terminal=False), False),
        (Settings(sources=ASKED), facts(stdout_is_terminal=False), True),
    ],
)
def test_cues_are_for_who_hears_them_or_asked_for_them(
    settings: Settings, around: Facts, wanted: bool
) -> None:
    assert wants_cues(settings, around) is wanted


@pytest.mark.parametrize(
    ("speech", "around", "notices"),
    [
        ("off", HOME, ()),
        ("auto", facts(stdout_is_terminal=False), ()),
        ("auto", facts(screen_reader="orca"), ("Voice off, a screen reader runs.",)),
        ("auto", facts(over_ssh=True), ("Voice off over SSH.",)),
        ("tts", facts(has_voice=False), ("No voice, espeak-ng is missing. Sounds and print work.",)),
        ("auto", facts(has_sound_device=False), ("No sound device. Everything is in print.",)),
    ],
)
def test_what_is_missing_is_told_once(
    monkeypatch: pytest.MonkeyPatch, speech: str, around: Facts, notices: tuple[str, ...]
) -> None:
    monkeypatch.setattr(audible, "look_around", lambda: around)
    with ExitStack() as closing:
        made = make_audible(Settings(speech=speech, sound=False), Floor().session, Words(), closing)

    assert made.notices == notices
    assert made.is_quiet_within(0)
