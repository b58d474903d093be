"""Sentences in the learner's language and at the learner's level of detail.

What makes sentences of mistakes, and HELP, is loaded when it is wanted: the first frame needs neither.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from donnie_tui.i18n.messages import filled, find

if TYPE_CHECKING:
    from donnie_tui.core.events import Error
    from language.diagnostics import Diagnostic


class Unusable(Exception):
    """A world, file or device that can't be used. ``sentence`` is in the learner's language."""

    def __init__(self, sentence: str) -> None:
        super().__init__(sentence)
        self.sentence = sentence


class Words:
    """Sentences in one language, at one level of detail. Both may be changed at any time."""

    def __init__(self, language: str = "en", detail: str = "normal") -> None:
        self.language = language
        self.detail = detail

    def __call__(self, code: str, **values: object) -> str:
        """The sentence of a code. Raises ``KeyError`` for a code that English does not have.

        A ``reason`` may be in the system's words.
        """
        sentence = find(code, self.language, self.detail)
        if sentence is None:
            raise KeyError(code)
        if values.get("reason"):
            values["reason"] = self._reason(code, str(values["reason"]))
        return filled(sentence, values)

    def _reason(self, code: str, reason: str) -> str:
        """The system's reason (no such folder, disk full) in the learner's language, where it is known."""
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
    """The names of the system's errors, such as ``ENOENT``, by what the system says of them."""
    import errno
    import os

    return {os.strerror(number): name for number, name in errno.errorcode.items()}
