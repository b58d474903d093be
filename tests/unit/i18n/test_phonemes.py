"""What espeak-ng makes of the sentences: words of their language, and no sign that is spelled out."""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest

from devices.speech.ear import for_the_ear
from donnie_tui import LANGUAGES
from tests.unit.i18n.test_catalogue import all_texts, with_samples

pytestmark = pytest.mark.skipif(shutil.which("espeak-ng") is None, reason="needs espeak-ng")

VOICES = {"en": "en", "pt": "pt-br", "es": "es"}
BESIDE_WORDS = ".,:;?!¿¡\"'()“”[]"
"""Signs that end or enclose words: never said."""
TO_BE_TYPED = re.compile(r"--?\w|[/\\$#^_=]|\w\.\w|\w:\w|\w,\w|^[-/]+$|\d")
"""Options, files, addresses, numbers, and signs that a sentence is about: there every sign counts."""
SWITCH = re.compile(r"\([a-z]{2,3}(-[a-z]+)?\)")
"""How espeak-ng writes that another language's voice goes on."""
STRESS = re.compile(r"[\s',_|:-]")


def heard(language: str) -> list[str]:
    """Every sentence in that language, as the voice is given it."""
    ours = (text for where, text in all_texts() if where.endswith(f" {language}"))
    return sorted({for_the_ear(with_samples(text), language) for text in ours})


def phonemes(lines: list[str], language: str) -> str:
    done = subprocess.run(
        ["espeak-ng", "-q", "-x", "-v", VOICES[language]],
        input="\n".join(lines),
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    )
    return done.stdout


def sounds(text: str, language: str) -> str:
    return STRESS.sub("", phonemes([text], language))


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_sentence_is_read_by_the_voice_of_its_language(language: str) -> None:
    said = phonemes(heard(language), language)

    assert SWITCH.findall(said) == []
    assert len(said.split()) > 5_000


@pytest.mark.parametrize("language", ["pt", "es"])
def test_letters_that_the_voice_does_not_have_would_be_noticed(language: str) -> None:
    assert SWITCH.search(phonemes(["привет"], language))


@pytest.mark.parametrize("language", LANGUAGES)
def test_signs_beside_words_are_not_spelled_out(language: str) -> None:
    plain = sounds("FW", language)

    assert [sign for sign in BESIDE_WORDS if sounds(f"FW{sign}", language) != plain] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_signs_inside_words_are_not_spelled_out_but_in_what_is_typed(language: str) -> None:
    words = {word.strip(BESIDE_WORDS) for text in heard(language) for word in text.split()}
    with_signs = sorted(word for word in words if re.search(r"\W", word) and not TO_BE_TYPED.search(word))
    spelled = [
        word
        for word in with_signs
        if not word.replace("-", "").replace("'", "").isalpha()
        or ("-" in word and sounds(word, language) != sounds(word.replace("-", " "), language))
    ]

    assert spelled == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_sign_that_is_left_to_the_voice_would_be_noticed(language: str) -> None:
    assert sounds("FW @ 3", language) != sounds("FW 3", language)
