"""The renderer with a fake engine: it reads back what it has set."""

from __future__ import annotations

import ctypes
import os
import sys
import wave
from array import array
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
        self.read: list[tuple[str, object, object, object]] = []
        """The texts, with their rate, volume and pitch."""
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
        self.read.append((text, *(self._values.get(each) for each in ("rate", "volume", "pitch"))))

    def runAndWait(self) -> None:
        with wave.open(self._path, "wb") as file:
            file.setparams((1, 2, SAMPLE_RATE, 0, "NONE", ""))
            file.writeframes(bytes(200))


@pytest.fixture
def engine(monkeypatch: pytest.MonkeyPatch) -> Engine:
    made = Engine("en", "pt-br")
    monkeypatch.setattr(worker, "_make_espeak_findable", lambda _: None)
    monkeypatch.setattr(worker, "_start_engine", lambda: made)
    monkeypatch.setitem(sys.modules, "pyttsx3.drivers._espeak", None)  # it is no espeak-ng
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


def test_a_text_is_read_with_its_rate_and_volume_and_the_first_one_before_a_voice_is_chosen(
    engine: Engine,
) -> None:
    """Only espeak-ng has a pitch; the sounds are the engine's."""
    made = Renderer(VOICES)
    samples = made.render("Hello.", "en-GB", VoiceSettings(300, 20, 0.3333))

    assert engine.read == [("a", 180, 1.0, None), ("Hello.", 300, 0.33, None)]
    assert samples == array("h", bytes(200))


def test_the_systems_voice_is_preferred_unless_the_bundled_one_is_wanted(
    engine: Engine, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[bool] = []
    monkeypatch.setattr(worker, "_make_espeak_findable", asked.append)
    Renderer(VOICES)
    Renderer(VOICES, prefer_bundled=True)

    assert asked == [False, True]


def test_a_text_of_blanks_is_not_given_to_the_engine(engine: Engine) -> None:
    made = Renderer(VOICES)

    assert made.render(" \n", "en", VoiceSettings()) == array("h")
    assert [text for text, *_ in engine.read] == ["a"]


@pytest.mark.parametrize("fault", ["no voice is accepted", "no sound", "no file"])
def test_an_engine_that_can_not_speak_is_no_voice(
    engine: Engine, monkeypatch: pytest.MonkeyPatch, fault: str
) -> None:
    if fault == "no voice is accepted":
        engine.setProperty("voice", "pt-br")
        engine.working.clear()
        monkeypatch.setattr(engine, "getProperty", lambda name: [] if name == "voices" else "pt-br")
    elif fault == "no sound":
        monkeypatch.setattr(Engine, "runAndWait", silent_file)
    else:
        monkeypatch.setattr(Engine, "runAndWait", lambda _: None)

    with pytest.raises(NoVoice):
        Renderer(VOICES)


def silent_file(engine: Engine) -> None:
    with wave.open(engine._path, "wb") as file:
        file.setparams((1, 2, SAMPLE_RATE, 0, "NONE", ""))


class Espeak(Engine):
    """It applies a setting at the fifth try, and is busy after each for two looks."""

    driver_name = "espeak"

    def __init__(self, *working: str) -> None:
        super().__init__(*working)
        self._values["pitch"] = 50
        self.tries: list[tuple[str, object]] = []
        self.busy = 0

    def setProperty(self, name: str, value: object) -> None:
        if name == "voice":
            return super().setProperty(name, value)
        assert not self.busy
        self.tries.append((name, value))
        self.busy = 2
        if self.tries.count((name, value)) == 5:
            super().setProperty(name, value)
        return None

    def save_to_file(self, text: str, path: str) -> None:
        assert not self.busy
        super().save_to_file(text, path)

    def runAndWait(self) -> None:
        super().runAndWait()
        self.busy = 2

    def is_playing(self) -> bool:
        self.busy = max(0, self.busy - 1)
        return self.busy > 0


def test_espeak_is_waited_for_and_each_setting_repeated_until_it_has_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    made = Espeak("en")
    monkeypatch.setattr(worker, "_make_espeak_findable", lambda _: None)
    monkeypatch.setattr(worker, "_start_engine", lambda: made)
    monkeypatch.setitem(sys.modules, "pyttsx3.drivers._espeak", SimpleNamespace(IsPlaying=made.is_playing))
    renderer = Renderer(VOICES)
    made.busy = 0
    for _ in range(2):
        renderer.render("Hello.", "en", VoiceSettings(300, 20, 0.5))

    assert made.tries == [("rate", 300)] * 5 + [("volume", 0.5)] * 5 + [("pitch", 20)] * 5
    assert made.read[1:] == [("Hello.", 300, 0.5, 20)] * 2


class Stubborn(Engine):
    """It keeps its rate, volume and pitch, and is always busy once ``is_busy``."""

    driver_name = "espeak"

    def __init__(self, *working: str) -> None:
        super().__init__(*working)
        self._values["pitch"] = 50
        self.tries: list[str] = []
        self.is_busy = False

    def setProperty(self, name: str, value: object) -> None:
        if name == "voice":
            super().setProperty(name, value)
        else:
            self.tries.append(name)


@pytest.fixture
def stubborn(monkeypatch: pytest.MonkeyPatch) -> Stubborn:
    made = Stubborn("en")
    monkeypatch.setattr(worker, "_make_espeak_findable", lambda _: None)
    monkeypatch.setattr(worker, "_start_engine", lambda: made)
    espeak = SimpleNamespace(IsPlaying=lambda: made.is_busy)
    monkeypatch.setitem(sys.modules, "pyttsx3.drivers._espeak", espeak)
    return made


def test_a_setting_that_espeak_never_takes_is_tried_five_times_and_the_text_is_read_all_the_same(
    stubborn: Stubborn,
) -> None:
    Renderer(VOICES).render("Hello.", "en", VoiceSettings(300, 20, 0.5))

    assert stubborn.tries == ["rate"] * 5 + ["volume"] * 5 + ["pitch"] * 5
    assert stubborn.read[-1] == ("Hello.", 180, 1.0, 50)


def test_espeak_is_waited_for_a_second_at_most(stubborn: Stubborn) -> None:
    """The settings are those that it has."""
    renderer, waits = Renderer(VOICES), list[float]()
    renderer._pause = SimpleNamespace(wait=waits.append)  # type: ignore[assignment]
    stubborn.is_busy = True
    renderer.render("Hello.", "en", VoiceSettings(180, 50, 1.0))

    assert waits == [0.001] * 1000
    assert stubborn.read[-1][0] == "Hello."


@pytest.mark.parametrize("system", [True, False], ids=["the system has one", "the system has none"])
@pytest.mark.parametrize("prefer_bundled", [True, False])
@pytest.mark.parametrize("bundled", [True, False], ids=["one is bundled", "none is bundled"])
def test_the_bundled_espeak_is_loaded_if_it_is_preferred_or_the_system_has_none(
    monkeypatch: pytest.MonkeyPatch, system: bool, prefer_bundled: bool, bundled: bool
) -> None:
    loaded: list[tuple[str, int]] = []

    def load(name: str, mode: int = 0) -> None:
        if not system and name == "libespeak-ng.so.1":
            raise OSError
        loaded.append((name, mode))

    def library_path() -> str:
        if not bundled:
            raise RuntimeError
        return "/bundled/library"

    loader = SimpleNamespace(get_data_path=lambda: "/bundled/data", get_library_path=library_path)
    monkeypatch.setattr(ctypes, "CDLL", load)
    monkeypatch.setitem(sys.modules, "espeakng_loader", loader)
    monkeypatch.delenv("ESPEAK_DATA_PATH", raising=False)
    worker._make_espeak_findable(prefer_bundled)
    is_used = bundled and (prefer_bundled or not system)

    assert os.environ.get("ESPEAK_DATA_PATH") == ("/bundled/data" if is_used else None)
    assert (("/bundled/library", ctypes.RTLD_GLOBAL) in loaded) is is_used


def test_what_the_driver_of_a_system_raises_means_that_there_is_no_voice(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, "pyttsx3", SimpleNamespace(init=lambda: "an engine"))
    assert worker._start_engine() == "an engine"

    def fail() -> None:
        raise KeyError

    monkeypatch.setitem(sys.modules, "pyttsx3", SimpleNamespace(init=fail))
    with pytest.raises(NoVoice):
        worker._start_engine()


@pytest.mark.parametrize(
    ("languages", "is_found"),
    [([b"pt-br"], True), (("pt_BR",), True), ([b"\xffpt-br"], True), ([b"en"], False), (None, False)],
)
def test_a_driver_gives_the_languages_of_a_voice_as_bytes_or_text_or_not_at_all(
    engine: Engine, monkeypatch: pytest.MonkeyPatch, languages: object, is_found: bool
) -> None:
    engine.working.add("Maria")
    read = engine.getProperty
    voices = [SimpleNamespace(id="en", languages=["en"]), SimpleNamespace(id="Maria", languages=languages)]
    monkeypatch.setattr(engine, "getProperty", lambda name: voices if name == "voices" else read(name))

    assert Renderer(VOICES).languages == (("en", "pt") if is_found else ("en",))
