"""The words of the commands in each language, from ``commands.toml`` of its folder."""

from __future__ import annotations

from language import locales


def words_of(name: str, language: str) -> tuple[str, ...]:
    """What the learner may type for the command ``name``: the listed word first, then others for the same.

    English where the language has none. Raises ``KeyError`` for a name that English does not have.
    """
    return locales.words(language, "commands", name)
