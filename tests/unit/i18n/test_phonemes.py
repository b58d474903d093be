"""How espeak-ng reads the sentences: as words of their language, without spelling out a sign."""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest

from devices.audio.pronunciation import sign_words, speakable_text
from donnie_tui.outlets.audible import spoken_languages
from language.locales import languages
from tests.timeouts import TIMEOUT
from tests.unit.i18n.sentences import all_texts
from tests.unit.i18n.test_sentences import with_samples

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(shutil.which("espeak-ng") is None, reason="needs espeak-ng"),
]

VOICES = {"en": "en", "pt": "pt-br", "es": "es"}
AROUND_WORDS = ".,:;?!¿¡\"'()“”[]"
"""Signs that end or enclose words: never said."""
TO_BE_TYPED = re.compile(r"--?\w|[/\\$#^_=]|\w\.\w|\w:\w|\w,\w|^[-/]+$|\d")
"""Options, files, addresses, numbers, and signs that a sentence is about: there every sign counts."""
SWITCH = re.compile(r"\([a-z]{2,3}(-[a-z]+)?\)")
"""How espeak-ng writes that the voice of another language continues."""
STRESS = re.compile(r"[\s',_|:-]")


def spoken_lines(language: str) -> list[str]:
    """Every sentence in that language, as the voice is given it."""
    words = sign_words(language, spoken_languages())
    ours = (text for where, text in all_texts() if where.endswith(f" {language}"))
    return sorted({speakable_text(with_samples(text), words) for text in ours})


def phonemes(lines: list[str], language: str) -> str:
    done = subprocess.run(
        ["espeak-ng", "-q", "-x", "-v", VOICES[language]],
        input="\n".join(lines),
        capture_output=True,
        text=True,
        check=True,
        timeout=TIMEOUT,
    )
    return done.stdout


def sounds(text: str, language: str) -> str:
    return STRESS.sub("", phonemes([text], language))


@pytest.mark.parametrize("language", languages())
def test_every_sentence_is_read_by_the_voice_of_its_language(language: str) -> None:
    said = phonemes(spoken_lines(language), language)

    assert SWITCH.findall(said) == []
    assert len(said.split()) > 5_000


@pytest.mark.parametrize("language", ["pt", "es"])
def test_letters_that_the_voice_does_not_have_are_found(language: str) -> None:
    assert SWITCH.search(phonemes(["привет"], language))


@pytest.mark.parametrize("language", languages())
def test_signs_around_words_are_not_spelled_out(language: str) -> None:
    plain = sounds("FW", language)

    assert [sign for sign in AROUND_WORDS if sounds(f"FW{sign}", language) != plain] == []


@pytest.mark.parametrize("language", languages())
def test_signs_inside_words_are_spelled_out_only_in_typed_text(language: str) -> None:
    words = {word.strip(AROUND_WORDS) for text in spoken_lines(language) for word in text.split()}
    with_signs = sorted(word for word in words if re.search(r"\W", word) and not TO_BE_TYPED.search(word))
    spelled = [
        word
        for word in with_signs
        if not word.replace("-", "").replace("'", "").isalpha()
        or ("-" in word and sounds(word, language) != sounds(word.replace("-", " "), language))
    ]

    assert spelled == []


@pytest.mark.parametrize("language", languages())
def test_a_sign_that_is_left_to_the_voice_is_found(language: str) -> None:
    assert sounds("FW @ 3", language) != sounds("FW 3", language)
