"""Which voice reads which language, and the ranges of its settings."""

import math

import pytest

from devices.audio.worker import InstalledVoice, choose_voice
from devices.ports.audio import VoiceSettings, base_language
from donnie_tui.outlets.audible import spoken_languages

BRITISH = InstalledVoice("gmw/en", ("en-gb",))
AMERICAN = InstalledVoice("gmw/en-us", ("en-us",))
BRAZIL = InstalledVoice("roa/pt-br", ("pt-br",))
PORTUGAL = InstalledVoice("roa/pt", ("pt",))
SPAIN = InstalledVoice("roa/es", ("es",))
MBROLA = InstalledVoice("mb/mb-br1", ("pt-br",))
SAPI = InstalledVoice("HKEY_LOCAL_MACHINE/SPEECH/MARIA", ("pt_BR",))


@pytest.mark.parametrize(
    ("language", "voices", "chosen"),
    [
        ("pt", (PORTUGAL, BRAZIL), BRAZIL),
        ("pt-BR", (BRITISH, PORTUGAL), PORTUGAL),
        ("pt", (BRITISH, SPAIN), None),
        ("pt", (MBROLA,), None),
        ("pt", (SAPI,), SAPI),
        ("en", (AMERICAN, BRITISH), BRITISH),
        ("en", (AMERICAN,), AMERICAN),
        ("es", (BRITISH, SPAIN), SPAIN),
        ("fr", (BRITISH, SPAIN), None),
        ("en", (), None),
    ],
)
def test_a_language_is_read_by_its_own_voice_or_by_none(
    language: str, voices: tuple[InstalledVoice, ...], chosen: InstalledVoice | None
) -> None:
    known = spoken_languages().get(base_language(language))
    preferred = known.voices if known is not None else (language,)

    assert choose_voice(preferred, voices) == chosen


@pytest.mark.parametrize(
    ("asked", "given"),
    [
        (VoiceSettings(10, -5, -0.1), VoiceSettings(80, 0, 0.0)),
        (VoiceSettings(10_000, 500, 7.0), VoiceSettings(450, 100, 1.0)),
        (VoiceSettings(200, 40, 0.5), VoiceSettings(200, 40, 0.5)),
        (VoiceSettings(volume=math.nan), VoiceSettings()),
        (VoiceSettings(volume=math.inf), VoiceSettings(volume=1.0)),
        (VoiceSettings(punctuation="most"), VoiceSettings(punctuation="some")),
        (VoiceSettings(punctuation="all"), VoiceSettings(punctuation="all")),
        (VoiceSettings(), VoiceSettings(180, 50, 1.0, "some")),
    ],
)
def test_settings_are_clamped_and_not_refused(asked: VoiceSettings, given: VoiceSettings) -> None:
    assert asked.clamped() == given


@pytest.mark.parametrize("written", ["pt", "pt-BR", "pt_BR", "PT"])
def test_the_base_of_a_language(written: str) -> None:
    assert base_language(written) == "pt"
