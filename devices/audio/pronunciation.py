"""Turns printed signs into words for a voice.

A voice says what is printed, word for word; only signs that it would drop or misread are spelled out.
espeak-ng drops the minus of ``x=-3``, says nothing for ``<>``, reads the point of ``3.5`` in Portuguese as a
pause, and drops the minus of ``-3`` in Spanish (tried with ``espeak-ng -q -x``). Texts in unknown languages
only lose their control characters: no sign is read in the words of another language. The words of a language
are given from outside: this room has none.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from msgspec import Struct

from devices.ports.audio import base_language


class SignWords(Struct, frozen=True):
    """How a language reads signs."""

    minus: str
    point: str
    degree: str
    degrees: str
    digit_by_digit: bool
    """English reads the digits after the point one by one."""
    signs: Mapping[str, str]
    """Comparisons and sums."""
    punctuation: Mapping[str, str]
    """Spoken only when all signs are wanted."""


class SpokenLanguage(Struct, frozen=True):
    """What the voice has to know of a language."""

    voices: tuple[str, ...]
    """Tags of the voices that read it, such as ``pt-br``, the best one first."""
    signs: SignWords | None = None
    """None if it is unknown how signs are read."""


ENGLISH_ONLY: Mapping[str, SpokenLanguage] = {"en": SpokenLanguage(("en", "en-gb", "en-us"))}
"""By code. What there is until Donnie says which languages it speaks."""


def sign_words(language: str, known: Mapping[str, SpokenLanguage]) -> SignWords | None:
    """How a language such as ``pt`` or ``pt-BR`` reads signs; None if that is unknown."""
    spoken = known.get(language.lower()) or known.get(base_language(language))
    return spoken.signs if spoken is not None else None


_UNSPEAKABLE = re.compile(r"[\x00-\x1f\x7f-\x9f\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ud800-\udfff]+")
_DEGREES = re.compile(r"(?<!\d)(?P<number>\d++(?:[.,]\d++)?+)\s?°(?!\w)")
_DECIMAL = re.compile(r"(?<![\w.,])(?P<whole>\d+)\.(?P<fraction>\d+)(?!\w|[.,]\w)")
_MINUS = re.compile(
    r"(?<![\w)\]\-\u2212])\s?[-\u2212]\s?(?=\d)"  # a sign: "x equals -3", "(-3"
    r"|(?<![^\s(])[-\u2212](?=[^\W\d])"  # a sign before a name: "-x", never a hyphen
    r"|(?<=[\d)])\s?[-\u2212]\s?(?=[\w(])"  # a difference: "5-3", "(a)-b"
    r"|(?<=\w)\s?[-\u2212]\s?(?=\d)"  # and "x-3"
)
_COMPARISON = re.compile(r"\s?(?P<sign><=|>=|<>|!=|==|<|>|=)\s?")
_SUM = re.compile(
    r"(?<=[\w)])\s?(?P<sign>[+*])\s?(?=[\w(-])"
    r"|(?<=[\d)])(?P<slash>/)(?=[\d(])"  # "6/3", but not "and/or"
    r"|\s(?P<alone>[/+*])\s"
)
_BLANKS = re.compile(r"[ \t]+")


def speakable_text(text: str, words: SignWords | None, punctuation: str = "some") -> str:
    """``text`` as a voice should read it; without ``words`` it only loses its control characters.

    ``punctuation``: ``none`` leaves comparisons and sums to the voice, too; ``all`` spells out every sign.
    """
    speakable = _UNSPEAKABLE.sub(" ", text)
    if words is not None:
        speakable = _spell_out(speakable, words, punctuation)
    return _BLANKS.sub(" ", speakable).strip()


def _spell_out(text: str, words: SignWords, punctuation: str) -> str:
    text = _DEGREES.sub(lambda found: _degrees(found, words), text)
    if punctuation != "none":
        text = _signs_in_words(text, words)
    text = _DECIMAL.sub(lambda found: _decimal(found, words), text)
    return _every_sign(text, words) if punctuation == "all" else text


def _every_sign(text: str, words: SignWords) -> str:
    for sign, said in words.punctuation.items():
        text = text.replace(sign, f" {said} ")
    return text


def _signs_in_words(text: str, words: SignWords) -> str:
    text = _COMPARISON.sub(_sign(words), text)
    text = _SUM.sub(_sign(words), text)
    return _MINUS.sub(f" {words.minus} ", text)


def _degrees(found: re.Match[str], words: SignWords) -> str:
    number = found["number"]
    return f"{number} {words.degree if number == '1' else words.degrees}"


def _decimal(found: re.Match[str], words: SignWords) -> str:
    fraction = found["fraction"]
    digits = " ".join(fraction) if words.digit_by_digit or fraction.startswith("0") else fraction
    return f"{found['whole']} {words.point} {digits}"


def _sign(words: SignWords) -> Callable[[re.Match[str]], str]:
    def spoken(found: re.Match[str]) -> str:
        sign = next(sign for sign in found.groupdict().values() if sign)
        return f" {words.signs.get(sign, sign)} "

    return spoken
