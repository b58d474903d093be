"""What the worker does with each request, without a device, a voice and a process of its own."""

from __future__ import annotations

import os
import signal
import sys
from array import array
from collections.abc import Callable
from io import BytesIO
from pathlib import Path
from queue import SimpleQueue

import pytest

from devices.audio import worker
from devices.audio.cues import render_cue
from devices.audio.process import (
    AudioRequest,
    AudioResponse,
    Ping,
    PlayCue,
    Pong,
    Say,
    Silence,
    Silenced,
    SoundReady,
    SpeechFinished,
    SpeechRefused,
    SpeechStarted,
    VoiceReady,
    to_line,
)
from devices.audio.worker import AudioWorker, NoVoice
from devices.ports.audio import Cue, VoiceSettings
from tests.timeouts import TIMEOUT

HELLO = Say(1, "Hello.", "en", 9_999, 60, 0.5)
USER_SOUNDS = {"done": array("d", [0.1, 0.2, 0.3])}


class FakePlayer:
    """Keeps what it was asked for, and plays a sentence at once."""

    name = "fake"
    is_playing = True

    def __init__(self) -> None:
        self.asked: list[object] = []
        self.frames: int | None = 5

    def speak(self, mono: array[int], on_end: Callable[[], None]) -> None:
        self.asked.append(mono)
        on_end()

    def cue(self, name: str, stereo: array[int], delay: float) -> None:
        self.asked.append((name, stereo, delay))

    def silence(self, speech: bool, cues: bool) -> None:
        self.asked.append((speech, cues))

    def close(self) -> None: ...


class FakeRenderer:
    languages = ("en",)

    def __init__(self, *_: object) -> None:
        self.asked: list[object] = []

    def render(self, text: str, language: str, settings: VoiceSettings) -> array[int]:
        if language != "en":
            raise NoVoice
        self.asked.append((text, settings))
        return array("h", [1] * 11_025)


def worker_with(
    player: FakePlayer | None, respond: Callable[[AudioResponse], object] = lambda _: None
) -> AudioWorker:
    made = AudioWorker(respond, "fake device", True, USER_SOUNDS, {"en": ("en",)})
    made._player = player
    return made


def answers_to(player: FakePlayer | None, *requests: AudioRequest | bytes) -> list[AudioResponse]:
    answers: list[AudioResponse] = []
    made = worker_with(player, answers.append)
    for each in requests:
        made._obey(each if isinstance(each, bytes) else to_line(each))
    return answers


def test_a_ping_is_answered_with_the_players_heartbeat() -> None:
    player = FakePlayer()
    assert answers_to(player, Ping(7)) == [Pong(7, 5, is_playing=True)]
    player.frames, player.is_playing = None, False
    assert answers_to(player, Ping(8)) == [Pong(8, -1, is_playing=False)]
    assert answers_to(None, Ping(9)) == [Pong(9, -1, is_playing=False)]


@pytest.mark.parametrize("what", [(True, False), (False, True)])
def test_a_silence_is_passed_on_and_answered(what: tuple[bool, bool]) -> None:
    player = FakePlayer()

    assert answers_to(player, Silence(3, *what)) == answers_to(None, Silence(3, *what)) == [Silenced(3)]
    assert player.asked == [what]


def test_a_cue_is_played_in_its_direction_and_volume_and_with_the_learners_sound() -> None:
    player = FakePlayer()
    requests = (PlayCue("found", -45.0, 3.0, 0.5, 0.25), PlayCue("done", 0.0, None, 1.0, 0.0))

    assert answers_to(player, *requests, PlayCue("trumpet", 0.0, None, 1.0, 0.0)) == []
    assert player.asked == [
        ("found", render_cue(Cue("found", -45.0, 3.0), 0.5), 0.25),
        ("done", render_cue(Cue("done"), 1.0, USER_SOUNDS), 0.0),
    ]
    assert answers_to(None, *requests) == []


def test_what_is_no_request_is_ignored() -> None:
    assert answers_to(FakePlayer(), b"", b"FW 3\n", b'{"is":"Nonsense"}\n') == []


def test_a_sentence_is_rendered_with_its_settings_and_played_to_its_end() -> None:
    answers: list[AudioResponse] = []
    player, renderer = FakePlayer(), FakeRenderer()
    made = worker_with(player, answers.append)
    made._speak(renderer, 0, HELLO)  # type: ignore[arg-type]

    assert renderer.asked == [("Hello.", VoiceSettings(450, 60, 0.5))]
    assert player.asked == [array("h", [1] * 11_025)]
    assert answers == [SpeechStarted(1, 0.5), SpeechFinished(1)]


@pytest.mark.parametrize("silence", [Silence(3, speech=True, cues=False), Silence(3, False, cues=True)])
def test_a_sentence_from_before_a_silence_is_not_even_rendered(silence: Silence) -> None:
    renderer, player = FakeRenderer(), FakePlayer()
    made = worker_with(player)
    made._obey(to_line(silence))
    made._speak(renderer, 0, HELLO)  # type: ignore[arg-type]

    assert bool(renderer.asked) is not silence.speech


def test_without_a_voice_a_sentence_is_refused_and_without_a_player_it_is_dropped() -> None:
    answers: list[AudioResponse] = []
    made = worker_with(None, answers.append)
    made._speak(None, 0, HELLO)
    made._speak(FakeRenderer(), 0, Say(2, "Olá.", "pt", 180, 50, 1.0))  # type: ignore[arg-type]
    made._speak(FakeRenderer(), 0, Say(3, "Hello.", "en", 180, 50, 1.0))  # type: ignore[arg-type]

    assert answers == [SpeechRefused(1), SpeechRefused(2)]


@pytest.mark.parametrize("has_voice", [True, False])
def test_a_worker_reports_its_player_and_its_voices_and_then_speaks_until_its_requests_end(
    monkeypatch: pytest.MonkeyPatch, has_voice: bool
) -> None:
    answers: SimpleQueue[AudioResponse] = SimpleQueue()
    opened: list[object] = []

    def voice(*options: object) -> FakeRenderer:
        opened.append(options)
        if not has_voice:
            raise NoVoice
        return FakeRenderer()

    monkeypatch.setattr(worker, "open_player", lambda device: opened.append(device) or FakePlayer())
    monkeypatch.setattr(worker, "Renderer", voice)
    worker_with(None, answers.put).run(BytesIO(to_line(HELLO) + b"nonsense\n" + to_line(Ping(4))))

    received = [answers.get(timeout=TIMEOUT) for _ in range(5 if has_voice else 4)]
    (pong,) = (each for each in received if isinstance(each, Pong))  # the requests have their own thread
    received.remove(pong)
    spoken = [SpeechStarted(1, 0.5), SpeechFinished(1)] if has_voice else [SpeechRefused(1)]
    assert received == [SoundReady("fake"), VoiceReady(("en",) if has_voice else ()), *spoken]
    assert opened == ["fake device", ({"en": ("en",)}, True)]


def test_without_a_player_the_worker_reports_an_empty_name(monkeypatch: pytest.MonkeyPatch) -> None:
    answers: SimpleQueue[AudioResponse] = SimpleQueue()
    monkeypatch.setattr(worker, "open_player", lambda _: None)
    monkeypatch.setattr(worker, "Renderer", FakeRenderer)
    worker_with(None, answers.put).run(BytesIO())

    assert answers.get(timeout=TIMEOUT) == SoundReady("")


# --- the process


@pytest.mark.parametrize(
    ("arguments", "given"),
    [
        (
            ["auto", "system", "4711", "", "en=en,en-gb pt=pt-br"],
            ("auto", False, {}, {"en": ("en", "en-gb"), "pt": ("pt-br",)}),
        ),
        (["null", "bundled", "4711", "sounds", ""], ("null", True, {"done": array("d", [1.0])}, {})),
    ],
)
def test_the_arguments_of_the_process_are_those_of_its_worker(
    monkeypatch: pytest.MonkeyPatch, arguments: list[str], given: tuple[object, ...]
) -> None:
    calls: list[object] = []

    class Made:
        def __init__(self, respond: Callable[[AudioResponse], None], *options: object) -> None:
            calls.append(options)
            respond(Silenced(1))

        def run(self, requests: object) -> None:
            calls.append(requests)

    def user_sounds(folder: Path | None) -> tuple[dict[str, array[float]], tuple[str, ...]]:
        return ({} if folder is None else {"done": array("d", [folder == Path("sounds")])}), ()

    output = BytesIO()
    monkeypatch.setattr(sys, "argv", ["worker", *arguments])
    monkeypatch.setattr(worker, "_end_with", calls.append)
    monkeypatch.setattr(worker, "_take_streams", lambda: ("requests", output))
    monkeypatch.setattr(worker, "load_user_sounds", user_sounds)
    monkeypatch.setattr(worker, "AudioWorker", Made)
    monkeypatch.setattr(worker, "_end_group", lambda: calls.append("ended"))
    worker.main()

    assert calls == [4711, given, "requests", "ended"]
    assert output.getvalue() == to_line(Silenced(1))


def test_a_response_to_a_parent_that_is_gone_is_dropped() -> None:
    class Gone(BytesIO):
        def write(self, data: object) -> int:
            raise BrokenPipeError

    worker._responder(Gone())(Silenced(1))


@pytest.mark.parametrize(("parent", "is_ended"), [(4711, False), (4712, True)])
def test_a_worker_whose_parent_has_ended_before_it_could_notice_ends(
    monkeypatch: pytest.MonkeyPatch, parent: int, is_ended: bool
) -> None:
    calls: list[object] = []
    monkeypatch.setattr(worker, "CAN_DIE_WITH_PARENT", True)
    monkeypatch.setattr(worker, "die_with_parent", lambda: calls.append("asked"))
    monkeypatch.setattr(os, "getppid", lambda: 4711)
    monkeypatch.setattr(os, "_exit", calls.append)
    worker._end_with(parent)
    assert calls == ["asked", *([0] if is_ended else [])]

    monkeypatch.setattr(worker, "CAN_DIE_WITH_PARENT", False)
    calls.clear()
    worker._end_with(parent)
    assert calls == ["asked"]


@pytest.mark.skipif(sys.platform == "win32", reason="needs process groups")
@pytest.mark.parametrize("has_a_group", [True, False])
def test_at_its_end_the_worker_kills_its_own_group_only(
    monkeypatch: pytest.MonkeyPatch, has_a_group: bool
) -> None:
    calls: list[object] = []
    monkeypatch.setattr(os, "getpgrp", lambda: os.getpid() + (not has_a_group))
    monkeypatch.setattr(os, "killpg", lambda *killed: calls.append(killed))
    monkeypatch.setattr(os, "_exit", calls.append)
    worker._end_group()

    assert calls == [*([(os.getpid(), signal.SIGKILL)] if has_a_group else []), 0]
