"""What the makers of longer texts (help, mistakes, worlds) need to know of a language."""

from __future__ import annotations

from typing import Protocol


class Phrasing(Protocol):
    """Sentences by code, in one language."""

    @property
    def language(self) -> str: ...

    def __call__(self, code: str, **values: object) -> str: ...

    def knows(self, code: str) -> bool:
        """Whether there is such a sentence."""
