"""A learner's language and level of detail: the wording that the core and the front ends ask."""

from __future__ import annotations

from donnie_tui.i18n.catalogue import SENTENCES
from donnie_tui.i18n.help import help_lines
from donnie_tui.i18n.mistakes import hint, mistake
from donnie_tui.i18n.sentence import filled
from language.diagnostics import Diagnostic


class Words:
    """Sentences in one language, at one level of detail. Both may be changed at any time."""

    def __init__(self, language: str = "en", detail: str = "normal") -> None:
        self.language = language
        self.detail = detail

    def __call__(self, code: str, **values: object) -> str:
        """The sentence of a code. Raises ``KeyError`` for a code that the catalogue lacks."""
        return filled(SENTENCES[code].text(self.language, self.detail), values, self.language)

    def knows(self, code: str) -> bool:
        """Whether the catalogue has the code."""
        return code in SENTENCES

    def mistake(self, diagnostic: Diagnostic) -> str:
        return mistake(diagnostic, self)

    def hint(self, diagnostic: Diagnostic) -> str | None:
        return hint(diagnostic, self)

    def help(self, topic: str | None) -> tuple[str, ...]:
        return help_lines(topic, self)
