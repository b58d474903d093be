"""V7: what is said is what is printed, word for word, for every word of the linear mode."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from devices.speech.ear import for_the_ear
from devices.speech.policy import first_sentence
from tests.sessions.test_linear_words import DRAWN, ELSEWHERE, LANGUAGES, environment, every_word, quiet
from tests.unit.ssip.server import Server

SILENCING = {"quiet", "sound"}
"""They end what is being said, and with it what waits."""


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_is_said_is_what_is_printed(tmp_path: Path, language: str) -> None:
    """From the greeting to the goodbye, in order; the same within half a second is said once (S7)."""
    server = Server(tmp_path)
    lines = every_word(language, without=ELSEWHERE | DRAWN | SILENCING | {"language"})
    done = subprocess.run(
        [*quiet(language), "--speech", "ssip"],
        input="\n".join([*lines, ""]).encode(),
        capture_output=True,
        cwd=tmp_path,
        env=environment(tmp_path, {"SPEECHD_ADDRESS": f"unix_socket:{server.address.path}"}),
        timeout=120,
        check=True,
    )
    server.close()
    printed = [each for line in done.stdout.decode().split("\n") for each in sentences(line, language)]

    assert len(printed) > 500
    assert set(printed) == set(server.texts)
    rest = iter(printed)
    assert all(each in rest for each in server.texts), "not in their order"


def sentences(line: str, language: str) -> Iterator[str]:
    """As they are handed to a voice."""
    while line:
        sentence, line = first_sentence(line)
        if said := for_the_ear(sentence, language):
            yield said
