"""The languages as the voice reads them, from the section ``spoken`` of their ``words.toml``."""

from __future__ import annotations

from collections.abc import Mapping

from devices.audio.pronunciation import SignWords, SpokenLanguage
from language.locales import keys, languages, own_words, table


def spoken_languages() -> Mapping[str, SpokenLanguage]:
    """By code. A language that names no voice is read by one whose tag is its code."""
    return {
        each: SpokenLanguage(_words(each, "voices") or (each,), _sign_words(each)) for each in languages()
    }


def _sign_words(language: str) -> SignWords | None:
    """None where the numbers are missing: nothing is read in the words of another language."""
    minus, point, degree, degrees = (
        "".join(_words(language, each)[:1]) for each in ("minus", "point", "degree", "degrees")
    )
    if not (minus and point and degree and degrees):
        return None
    spoken = table(language, "words").get("spoken")
    digit_by_digit = isinstance(spoken, dict) and spoken.get("digit_by_digit") is True
    return SignWords(
        *(minus, point, degree, degrees, digit_by_digit),
        *(_signs(language, "signs"), _signs(language, "punctuation")),
    )


def _signs(language: str, section: str) -> Mapping[str, str]:
    signs = keys(language, "words", "spoken", section)
    return {sign: _words(language, section, sign)[0] for sign in signs if _words(language, section, sign)}


def _words(language: str, *entry: str) -> tuple[str, ...]:
    return own_words(language, "words", "spoken", *entry)
