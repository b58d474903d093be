"""How the core asks for sentences: by code and parameters. The sentences themselves are in i18n."""

from __future__ import annotations

from typing import Protocol

from language.diagnostics import Diagnostic


class Wording(Protocol):
    """The learner's language."""

    @property
    def language(self) -> str:
        """``en``, ``pt`` or ``es``."""

    @property
    def detail(self) -> str:
        """``brief``, ``normal`` or ``full``."""

    def __call__(self, code: str, **values: object) -> str:
        """The sentence of a code."""

    def mistake(self, diagnostic: Diagnostic) -> str:
        """What is wrong, in one sentence."""

    def hint(self, diagnostic: Diagnostic) -> str | None:
        """What would put it right, where that is known."""

    def help(self, topic: str | None) -> tuple[str, ...]:
        """The help for a word, or the list of commands; a line each."""
