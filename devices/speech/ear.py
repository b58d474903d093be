"""Printed signs in words, for the ear (S12). Pure.

What is spoken is what is printed, word for word; only signs that a voice swallows or misreads are
spelled out. espeak-ng drops the minus of ``x=-3``, says nothing for ``<>``, reads the point of ``3.5`` in
Portuguese as a pause and the minus of ``-3`` in Spanish not at all (heard with ``espeak-ng -q -x``).
Unknown languages only lose their control characters: nothing is read in the words of another language.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from devices.ports.values import Frozen


class _Words(Frozen):
    minus: str
    point: str
    degree: str
    degrees: str
    digit_by_digit: bool
    """English reads the digits after the point one by one."""
    signs: tuple[tuple[str, str], ...]
    """Comparisons and sums; the longer sign first."""
    punctuation: tuple[tuple[str, str], ...]
    """What is said only when all signs are wanted."""


_ENGLISH = _Words(
    "minus", "point", "degree", "degrees", True,
    (
        ("<=", "less than or equal to"), (">=", "greater than or equal to"), ("<>", "different from"),
        ("!=", "different from"), ("==", "equals"), ("<", "less than"), (">", "greater than"),
        ("=", "equals"), ("+", "plus"), ("*", "times"), ("/", "divided by"),
    ),
    (
        (".", "full stop"), (",", "comma"), (";", "semicolon"), (":", "colon"), ("!", "exclamation mark"),
        ("?", "question mark"), ("(", "left parenthesis"), (")", "right parenthesis"),
        ("[", "left bracket"), ("]", "right bracket"), ('"', "quote"), ("-", "dash"), ("_", "underscore"),
    ),
)  # fmt: skip
_PORTUGUESE = _Words(
    "menos", "vírgula", "grau", "graus", False,
    (
        ("<=", "menor ou igual a"), (">=", "maior ou igual a"), ("<>", "diferente de"),
        ("!=", "diferente de"), ("==", "igual a"), ("<", "menor que"), (">", "maior que"),
        ("=", "igual a"), ("+", "mais"), ("*", "vezes"), ("/", "dividido por"),
    ),
    (
        (".", "ponto"), (",", "vírgula"), (";", "ponto e vírgula"), (":", "dois pontos"),
        ("!", "exclamação"), ("?", "interrogação"), ("(", "abre parêntese"), (")", "fecha parêntese"),
        ("[", "abre colchete"), ("]", "fecha colchete"), ('"', "aspas"), ("-", "traço"), ("_", "sublinhado"),
    ),
)  # fmt: skip
_SPANISH = _Words(
    "menos", "coma", "grado", "grados", False,
    (
        ("<=", "menor o igual que"), (">=", "mayor o igual que"), ("<>", "diferente de"),
        ("!=", "diferente de"), ("==", "igual a"), ("<", "menor que"), (">", "mayor que"),
        ("=", "igual a"), ("+", "más"), ("*", "por"), ("/", "dividido por"),
    ),
    (
        (".", "punto"), (",", "coma"), (";", "punto y coma"), (":", "dos puntos"), ("!", "exclamación"),
        ("?", "interrogación"), ("(", "abre paréntesis"), (")", "cierra paréntesis"),
        ("[", "abre corchete"), ("]", "cierra corchete"), ('"', "comillas"), ("-", "guion"),
        ("_", "guion bajo"),
    ),
)  # fmt: skip
_LANGUAGES = {"en": _ENGLISH, "pt": _PORTUGUESE, "es": _SPANISH}

_UNSPEAKABLE = re.compile(r"[\x00-\x1f\x7f-\x9f\u200b-\u200f\u2028-\u202e\u2060\ufeff\ud800-\udfff]+")
_DEGREES = re.compile(r"(?P<number>\d+(?:[.,]\d+)?)\s?°(?!\w)")
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


def for_the_ear(text: str, language: str, punctuation: str = "some") -> str:
    """``text`` as a voice of ``language``, such as ``en``, ``pt`` or ``pt-BR``, should read it.

    ``punctuation``: ``none`` leaves comparisons and sums to the voice too, ``all`` says every sign.
    """
    speakable = _UNSPEAKABLE.sub(" ", text)
    words = _LANGUAGES.get(re.split(r"[-_]", language.lower(), maxsplit=1)[0])
    if words is not None:
        speakable = _spell_out(speakable, words, punctuation)
    return _BLANKS.sub(" ", speakable).strip()


def _spell_out(text: str, words: _Words, punctuation: str) -> str:
    text = _DEGREES.sub(lambda found: _degrees(found, words), text)
    if punctuation != "none":
        text = _signs_in_words(text, words)
    text = _DECIMAL.sub(lambda found: _decimal(found, words), text)
    return _every_sign(text, words) if punctuation == "all" else text


def _every_sign(text: str, words: _Words) -> str:
    for sign, said in words.punctuation:
        text = text.replace(sign, f" {said} ")
    return text


def _signs_in_words(text: str, words: _Words) -> str:
    text = _COMPARISON.sub(_sign(words), text)
    text = _SUM.sub(_sign(words), text)
    return _MINUS.sub(f" {words.minus} ", text)


def _degrees(found: re.Match[str], words: _Words) -> str:
    number = found["number"]
    return f"{number} {words.degree if number == '1' else words.degrees}"


def _decimal(found: re.Match[str], words: _Words) -> str:
    fraction = found["fraction"]
    digits = " ".join(fraction) if words.digit_by_digit or fraction.startswith("0") else fraction
    return f"{found['whole']} {words.point} {digits}"


def _sign(words: _Words) -> Callable[[re.Match[str]], str]:
    spoken = dict(words.signs)
    return lambda found: f" {spoken[next(sign for sign in found.groupdict().values() if sign)]} "
