"""The sentences that Donnie prints before anything else is loaded. Imports next to nothing.

``linear-cause-CAUSE`` says why the mode is linear: ``option``, ``variable`` (DONNIE_LINEAR or
ACCESSIBLE), ``settings``, ``no-terminal``, ``simple-terminal`` (TERM=dumb) or ``word`` (LINEAR was typed).
"""

from __future__ import annotations

from language.locales import ENGLISH, compiled_file

FILE = "start.txt"
"""A line ``code=sentence`` for each of them, compiled from ``messages.po``."""

_known: dict[str, dict[str, str] | None] = {}


def early(code: str, language: str) -> str:
    """A sentence of the topic ``start``, in English if the language lacks it."""
    for each in (language, ENGLISH):
        if each not in _known:
            _known[each] = _read(each)
        known = _known[each]
        if known is None:
            return _found(code, language)
        if code in known:
            return known[code]
    raise KeyError(code)


def _read(language: str) -> dict[str, str] | None:
    """None if the sentences of the language are not compiled."""
    file = compiled_file(language, "messages.po", FILE)
    if file is None:
        return None
    with open(file, encoding="utf-8") as lines:  # noqa: PTH123 -- pathlib is slow to load
        return dict(line.rstrip("\n").split("=", 1) for line in lines)


def _found(code: str, language: str) -> str:
    from donnie_tui.i18n.words import find  # slower

    sentence = find(code, language)
    if sentence is None:
        raise KeyError(code)
    return sentence.text
