"""The manual of the language: a chapter for each part of it, then every command with its example."""

from __future__ import annotations

from donnie_tui.core.wording import Wording
from donnie_tui.i18n.catalogue.manual import CHAPTERS


def manual(words: Wording) -> tuple[str, ...]:
    """The lines, in the learner's language."""
    lines: list[str] = []
    for chapter in CHAPTERS:
        lines.append(words(f"manual-{chapter}").upper())
        lines.extend(words(f"manual-{chapter}-text").split("\n"))
        lines.append("")
    return (*lines, words("manual-commands").upper(), *words.help(None))
