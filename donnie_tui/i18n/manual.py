"""The manual of the language: a chapter for each part of it, then every command with its example."""

from __future__ import annotations

from textwrap import wrap

from donnie_tui.core.reports import Section
from donnie_tui.core.wording import Wording
from donnie_tui.i18n.catalogue.manual import CHAPTERS
from donnie_tui.i18n.help import ENTRIES

BRAILLE = 40
"""Cells of a braille display."""


def manual(words: Wording) -> tuple[str, ...]:
    """The lines, in the learner's language."""
    lines: list[str] = []
    for chapter in CHAPTERS:
        lines.append(words(f"manual-{chapter}").upper())
        lines.extend(words(f"manual-{chapter}-text").split("\n"))
        lines.append("")
    return (*lines, words("manual-commands").upper(), *words.help(None))


def sections(words: Wording) -> tuple[Section, ...]:
    """For a page with headings: the chapters, then each command with its form and an example."""
    chapters = (
        Section(words(f"manual-{each}"), tuple(filter(None, words(f"manual-{each}-text").split("\n"))))
        for each in CHAPTERS
    )
    commands = tuple(line for entry in ENTRIES for line in words.help(entry))
    return (*chapters, Section(words("manual-commands"), commands))


def chapter_lines(words: Wording, chapter: str) -> tuple[str, ...]:
    """One chapter as it is told: a sentence or a line of its program each, at detail brief broken."""
    lines = words(f"manual-{chapter}-text").replace(". ", ".\n").split("\n")
    told = (line.strip() for line in lines if line)
    if words.detail != "brief":
        return tuple(told)
    return tuple(part for line in told for part in wrap(line, BRAILLE))
