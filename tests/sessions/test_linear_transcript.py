"""The voice says the printed lines word for word, for every word of the linear mode."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from devices.audio.pronunciation import sign_words, speakable_text
from devices.audio.speech_queue import first_sentence
from donnie_tui.outlets.audible import spoken_languages
from tests.sessions.test_linear_words import (
    DRAWN,
    ELSEWHERE,
    LANGUAGES,
    environment,
    every_word,
    quiet,
    words_of,
)
from tests.unit.ssip.server import Server

pytestmark = pytest.mark.slow

SILENCING = {"quiet", "sound"}
"""They end what is being said, and with it what waits."""


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_voice_says_the_printed_lines(tmp_path: Path, language: str) -> None:
    """From the greeting to the goodbye, in order. A line repeated within half a second is said once."""
    server = Server(tmp_path)
    lines = every_word(language, without=ELSEWHERE | DRAWN | SILENCING | {"language"})
    with subprocess.Popen(
        [*quiet(language), "--speech", "ssip"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        cwd=tmp_path,
        env=environment(tmp_path, {"SPEECHD_ADDRESS": f"unix_socket:{server.address.path}"}),
    ) as donnie:
        assert donnie.stdin is not None and donnie.stdout is not None
        for number, line in enumerate(lines):
            # the next line is typed once all is said: an alert would overtake what still waits
            marker = f"zz{number}zz"
            donnie.stdin.write(f"{line}\n{words_of('find', language)} {marker}\n".encode())
            donnie.stdin.flush()
            assert server.has_said(marker)
        donnie.stdin.close()
        output = donnie.stdout.read().decode()
    server.close()
    printed = [each for line in output.split("\n") for each in sentences(line, language)]

    assert len(printed) > 500
    assert set(printed) == set(server.texts)
    rest = iter(printed)
    assert all(each in rest for each in server.texts), "not in their order"


def sentences(line: str, language: str) -> Iterator[str]:
    """As they are handed to a voice."""
    while line:
        sentence, line = first_sentence(line)
        if said := speakable_text(sentence, sign_words(language, spoken_languages())):
            yield said
