"""The renderer with a fake engine: it reads back what it has set."""

from __future__ import annotations

import wave
from types import SimpleNamespace

import pytest

from devices.audio import worker
from devices.audio.cues import SAMPLE_RATE
from devices.audio.worker import NoVoice, Renderer
from devices.ports.audio import VoiceSettings

VOICES = {"en": ("en",), "pt": ("pt-br",), "es": ("es",)}


class Engine:
    """As pyttsx3: it accepts unknown voices silently, and keeps the previous one."""

    driver_name = "tests"

    def __init__(self, *working: str) -> None:
        self.working = set(working)
        self._values: dict[str, object] = {"voice": "en", "rate": 180, "volume": 1.0}
        self.read_by: list[object] = []
        self._path = ""

    def getProperty(self, name: str) -> object:
        if name == "voices":
            return [SimpleNamespace(id=each, languages=[each]) for each in ("en", "pt-br", "es")]
        return self._values[name]

    def setProperty(self, name: str, value: object) -> None:
        if name != "voice" or value in self.working:
            self._values[name] = value

    def save_to_file(self, text: str, path: str) -> None:
        self._path = path
        self.read_by.append(self._values["voice"])

    def runAndWait(self) -> None:
        with wave.open(self._path, "wb") as file:
            file.setparams((1, 2, SAMPLE_RATE, 0, "NONE", ""))
            file.writeframes(bytes(200))


@pytest.fixture
def engine(monkeypatch: pytest.MonkeyPatch) -> Engine:
    made = Engine("en", "pt-br")
    monkeypatch.setattr(worker, "_make_espeak_findable", lambda _: None)
    monkeypatch.setattr(worker, "_start_engine", lambda: made)
    return made


def test_a_voice_that_is_listed_but_not_accepted_is_not_used(engine: Engine) -> None:
    del engine
    made = Renderer(VOICES)

    assert made.languages == ("en", "pt")
    with pytest.raises(NoVoice):
        made.render("Hola.", "es", VoiceSettings())


def test_a_voice_that_is_lost_later_is_not_replaced_by_the_previous_one(engine: Engine) -> None:
    made = Renderer(VOICES)
    assert made.render("Olá.", "pt", VoiceSettings())
    assert engine.read_by[-1] == "pt-br"
    made.render("Hello.", "en", VoiceSettings())
    engine.working.discard("pt-br")
    spoken = len(engine.read_by)

    with pytest.raises(NoVoice):
        made.render("Olá.", "pt", VoiceSettings())
    assert len(engine.read_by) == spoken
