"""The mistakes of a text, line by line, with what was probably meant, for the editor."""

from __future__ import annotations

from collections.abc import Iterable

from devices.ports.values import Frozen
from donnie_tui.core.wording import Wording
from language.diagnostics import Diagnostic, Severity

LARGEST = 50_000
"""Characters of a text that is checked at every pause of typing."""


class Mistake(Frozen):
    """What is wrong in one line, and what would mend it."""

    line: int
    message: str
    is_hint: bool
    start: int
    end: int
    """Offsets of what stands there, and is to be replaced."""
    meant: str
    """What to put there instead; empty where nobody knows."""
    mended_line: int
    """The line that is another one then: a word that is missing may belong at the end of the line before."""

    @property
    def put(self) -> str:
        """What is written for ``meant``: what replaces nothing stands behind a word."""
        return self.meant if self.end > self.start else f" {self.meant}"


def mistakes(found: Iterable[Diagnostic], wording: Wording) -> dict[int, Mistake]:
    """The first mistake of each line, by line."""
    by_line: dict[int, Mistake] = {}
    for each in found:
        span = each.span
        is_hint = each.severity is Severity.HINT
        message = (wording.hint(each) if is_hint else None) or wording.mistake(each)
        meant = each.meant if each.found and span.end > span.start else ""
        start, end = (
            (span.start, each.meant_end or span.end) if each.meant_at is None else (each.meant_at,) * 2
        )
        mended_line = int(each.details.get("line", span.line))
        found_there = Mistake(span.line, message, is_hint, start, end, meant, mended_line)
        by_line.setdefault(span.line, found_there)
    return by_line


def mended(text: str, mistake: Mistake) -> str:
    """The text with what was meant."""
    return text[: mistake.start] + mistake.put + text[mistake.end :]
