"""How the core asks for sentences: by code and parameters. The sentences themselves are in i18n."""

from __future__ import annotations

from devices.ports.hints import TYPE_CHECKING, Protocol
from language.diagnostics import Diagnostic

if TYPE_CHECKING:
    from donnie_tui.core.events import Error


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

    def explanation(self, error: Error) -> tuple[str, ...]:
        """A mistake in plain words, and what to do, with an example where there is one; a line each."""

    def help(self, topic: str | None) -> tuple[str, ...]:
        """The help for a word, or the list of commands; a line each."""
