"""A learner's language and level of detail: the wording that the core and the front ends ask.

``Unusable`` raises a sentence, where Donnie can't do what it was asked for. What words need to tell of
mistakes and of GoDonnie is loaded when it is asked: the first frame needs neither.
"""

from __future__ import annotations

from devices.ports.hints import TYPE_CHECKING
from donnie_tui.i18n.catalogue import SENTENCES
from donnie_tui.i18n.sentence import filled

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
        """The sentence of a code. Raises ``KeyError`` for a code that the catalogue lacks.

        A ``reason`` may be in the system's words.
        """
        if values.get("reason"):
            from donnie_tui.i18n.reasons import reason_told  # only when something failed

            values["reason"] = reason_told(code, str(values["reason"]), self)
        return filled(SENTENCES[code].text(self.language, self.detail), values, self.language)

    def knows(self, code: str) -> bool:
        """Whether the catalogue has the code."""
        return code in SENTENCES

    def mistake(self, diagnostic: Diagnostic) -> str:
        from donnie_tui.i18n.mistakes import mistake

        return mistake(diagnostic, self)

    def hint(self, diagnostic: Diagnostic) -> str | None:
        from donnie_tui.i18n.mistakes import hint

        return hint(diagnostic, self)

    def explanation(self, error: Error) -> tuple[str, ...]:
        from donnie_tui.i18n.explanation import explanation

        return explanation(error, self)

    def help(self, topic: str | None) -> tuple[str, ...]:
        from donnie_tui.i18n.help import help_lines

        return help_lines(topic, self)
