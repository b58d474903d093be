"""The messages between Donnie and its audio worker."""

from __future__ import annotations

import sys
from collections.abc import Iterator

import pytest

from devices.audio.process import (
    AudioRequest,
    AudioResponse,
    PlayCue,
    Pong,
    Say,
    Silence,
    VoiceReady,
    request_from,
    response_from,
    to_line,
)


@pytest.mark.parametrize(
    "request_sent",
    [
        Say(1, 'Olá "você"\n', "pt", 180, 50, 1.0),
        PlayCue("bump", -90.0, None, 0.5, 0.07),
        PlayCue("scan", 0.0, 3.5, 1.0, 0.0),
        Silence(2, True, False),
    ],
    ids=lambda it: type(it).__name__,
)
def test_a_request_survives_the_pipe(request_sent: AudioRequest) -> None:
    line = to_line(request_sent)

    assert line.count(b"\n") == 1
    assert request_from(line) == request_sent
    assert response_from(line) is None


@pytest.mark.parametrize("response", [VoiceReady(("en", "pt")), VoiceReady(()), Pong(3, -1, False)])
def test_a_response_survives_the_pipe(response: AudioResponse) -> None:
    assert response_from(to_line(response)) == response
    assert request_from(to_line(response)) is None


@pytest.fixture
def deep_recursion() -> Iterator[None]:
    """As a session sets it for the recursion of learners' programs."""
    limit = sys.getrecursionlimit()
    sys.setrecursionlimit(1_000_000)
    yield
    sys.setrecursionlimit(limit)


@pytest.mark.usefixtures("deep_recursion")
@pytest.mark.parametrize(
    "line",
    [
        b"",
        b"\n",
        b"ALSA lib pcm.c: Unknown PCM",
        b"[]",
        b"{}",
        b'{"is":"Dance"}',
        b'{"is":"Ping"}',
        b'{"is":["Ping"]}',
        b'{"is":"Ping","number":1,"more":2}',
        b'{"is":"Ping","number":"one"}',
        b"\xff\xfe",
        pytest.param(b"[" * 100_000, id="deep list"),
        pytest.param(b'{"a":' * 100_000, id="deep object"),
        pytest.param(b'{"is":"Ping","number":' + b'{"a":' * 100_000, id="deep field"),
        pytest.param(b'{"is":"Ping","more":' + b'{"a":' * 100_000, id="deep unknown field"),
    ],
)
def test_a_line_that_makes_no_sense_is_no_message(line: bytes) -> None:
    assert request_from(line) is None
    assert response_from(line) is None
