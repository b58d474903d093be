"""Sentences in the learner's language and at the learner's level of detail.

The modules for mistakes and HELP are loaded on demand, as the first frame needs neither.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cache
from gettext import GNUTranslations, NullTranslations, c2py
from io import BytesIO
from typing import TYPE_CHECKING, NamedTuple

from language.locales import ENGLISH, compiled_file, content_of, folders

if TYPE_CHECKING:
    from donnie_tui.core.events import Error
    from language.diagnostics import Diagnostic


class Unusable(Exception):
    """A world, file or device that can't be used: sentences in the learner's language, most often one."""

    def __init__(self, *sentences: str) -> None:
        super().__init__(*sentences)
        self.sentences = sentences

    @property
    def sentence(self) -> str:
        """All sentences as one text."""
        return " ".join(self.sentences)

    def sentences_after(self, command: Sequence[str]) -> tuple[str, ...]:  # noqa: ARG002
        """The sentences for a learner who typed this command, without the name of the program."""
        return self.sentences


@contextmanager
def as_unusable(words: Words) -> Iterator[None]:
    """Raises ``Unusable``, in words, in place of a ``DocumentError``."""
    from donnie_tui.core.program_files import DocumentError

    try:
        yield
    except DocumentError as error:
        raise Unusable(words(error.code, path=error.path, reason=error.reason)) from None


class NotAllowed(Unusable):
    """A world that asks for a file in a folder which ``--allow`` would allow."""

    def __init__(self, sentence: str, words: Words, command: Sequence[str], folder: str) -> None:
        """``command``: what starts a session in the world, without the name of the program."""
        self._sentence, self._words, self._folder = sentence, words, folder
        super().__init__(*self.sentences_after(command))

    def sentences_after(self, command: Sequence[str]) -> tuple[str, ...]:
        import shlex

        from language.source import printable

        typed = printable(shlex.join(("donnie", *command, "--allow", self._folder)))
        return self._sentence, self._words("world-allow", command=typed)


class Words:
    """Sentences in one language, at one level of detail. Both may be changed at any time."""

    def __init__(self, language: str = "en", detail: str = "normal") -> None:
        self.language = language
        self.detail = detail

    def __call__(self, code: str, **values: object) -> str:
        """The sentence of a code. Raises ``KeyError`` for a code that English does not have.

        A ``reason`` may be the system's own message.
        """
        sentence = find(code, self.language, self.detail)
        if sentence is None:
            raise KeyError(code)
        if values.get("reason"):
            values["reason"] = self._reason(code, str(values["reason"]))
        return filled(sentence, values)

    def _reason(self, code: str, reason: str) -> str:
        """The system's reason (no such folder, disk full) in the learner's language, if it is known."""
        name = _error_names().get(reason)
        for each in (f"reason-{name}-{code}", f"reason-{name}"):
            if name and self.knows(each):
                return self(each)
        return reason

    def knows(self, code: str) -> bool:
        """Whether there is a sentence of that code."""
        return find(code, self.language) is not None

    def mistake(self, diagnostic: Diagnostic) -> str:
        from donnie_tui.i18n.mistakes import mistake

        return mistake(diagnostic, self)

    def hint(self, diagnostic: Diagnostic) -> str | None:
        from donnie_tui.i18n.mistakes import hint

        return hint(diagnostic, self)

    def explanation(self, error: Error) -> tuple[str, ...]:
        from donnie_tui.i18n.mistakes import explanation

        return explanation(error, self)

    def help(self, topic: str | None) -> tuple[str, ...]:
        from donnie_tui.i18n.help import help_lines

        return help_lines(topic, self)


@cache
def _error_names() -> dict[str, str]:
    """The names of the system's errors, such as ``ENOENT``, by the system's message."""
    import errno
    import os

    return {**_OF_RESOLVER, **{os.strerror(number): name for number, name in errno.errorcode.items()}}


_OF_RESOLVER = {
    "Name or service not known": "EAI_NONAME",
    "No address associated with hostname": "EAI_NONAME",
    "Temporary failure in name resolution": "EAI_AGAIN",
    "nodename nor servname provided, or not known": "EAI_NONAME",
    "Name does not resolve": "EAI_NONAME",
    "getaddrinfo failed": "EAI_NONAME",
}
"""What glibc, macOS, musl and Windows say of a machine that has no address; Python has no list of these."""


SOURCE, COMPILED = "messages.po", "messages.mo"
"""A language's sentences as translators edit them, and as gettext reads them."""

CODES = "*"
"""The key of a compiled file that lists all others."""

_BEGINNINGS = {"capital": str.upper, "small": str.lower}

_GROUPED = "grouped"
"""A large number with blanks between its thousands."""


class Sentence(NamedTuple):
    """A text and its language, which is English for a missing translation."""

    text: str
    language: str


def find(code: str, language: str, detail: str = "normal") -> Sentence | None:
    """The sentence of a code at a level of detail, else at the normal one; None for an unknown code."""
    for each in (language, ENGLISH):
        translations = _translations(each)
        text = translations.gettext(f"{code}|{detail}") or translations.gettext(code)
        if text:
            return Sentence(text, each)
    return None


@cache
def codes(language: str) -> tuple[str, ...]:
    """The codes of all sentences of a language; other levels of detail are like ``walked-forward|brief``."""
    return tuple(_translations(language).gettext(CODES).split("\n"))


class _Missing(NullTranslations):
    """A catalogue without sentences."""

    def gettext(self, message: str) -> str:  # noqa: ARG002
        return ""


@cache
def _translations(language: str) -> NullTranslations:
    """The sentences of a language; none without a readable file, so that English is used."""
    try:
        found = GNUTranslations(BytesIO(_compiled(language)))
    except (OSError, ValueError, LookupError, struct.error):  # the last two of a damaged compiled file
        return _Missing()
    found.add_fallback(_Missing())
    return found


def _compiled(language: str) -> bytes:
    """The content of the compiled file, or compiled now if a translator has edited the source."""
    file = compiled_file(language, SOURCE, COMPILED)
    if file is not None:
        return content_of(file)
    from pathlib import Path

    from donnie_tui.i18n import po

    entries = po.usable(Path(folders()[language], SOURCE))
    return po.compiled(entries, CODES, is_english=language == ENGLISH)


# --- filling places


def filled(sentence: Sentence, values: Mapping[str, object]) -> str:
    """The text with its placeholders filled. Raises ``KeyError`` for one without a value."""
    text, language = sentence
    if "{" not in text and "}" not in text:
        return text
    return text.format_map({name: _Place(value, language) for name, value in values.items()})


class _Place:
    """A value formatted for its placeholder."""

    __slots__ = ("_language", "_value")

    def __init__(self, value: object, language: str) -> None:
        self._value = value
        self._language = language

    def __format__(self, form: str) -> str:
        value = self._value
        if "|" in form:
            words = form.split("|")
            return words[min(_form_of(value, self._language), len(words) - 1)]
        if form in _BEGINNINGS:
            text = str(value)
            return _BEGINNINGS[form](text[:1]) + text[1:]
        if form == _GROUPED:
            return f"{value:,}".replace(",", " ") if isinstance(value, int) else str(value)
        shown = format(value, form)
        return shown.replace(".", _decimal_sign(self._language)) if isinstance(value, float) else shown


def _form_of(value: object, language: str) -> int:
    """The index of the plural form for a number; the last form for a fraction."""
    if not isinstance(value, int | float) or value != int(value):
        return -1
    return _plural_rule(language)(abs(int(value)))


@cache
def _plural_rule(language: str) -> Callable[[int], int]:
    forms = _translations(language).info().get("plural-forms", "")
    return c2py(forms.partition("plural=")[2].partition(";")[0] or "n != 1")


@cache
def _decimal_sign(language: str) -> str:
    sentence = find("decimal-sign", language)
    assert sentence is not None, "English has one"
    return sentence.text
