"""The mistakes of a text, line by line, with what was probably meant, for the editor."""

from __future__ import annotations

from collections.abc import Iterable

from devices.ports.values import frozen
from donnie_tui.core.wording import Wording
from language.diagnostics import Diagnostic, Severity

LARGEST = 50_000
"""Characters of a text that is checked at every pause of typing."""


@frozen
class Mistake:
    """What is wrong in one line, and what would mend it."""

    line: int
    message: str
    is_hint: bool
    start: int
    end: int
    """Offsets of what stands there, and is to be replaced."""
    meant: str
    """What to put there instead; empty where nobody knows."""


def mistakes(found: Iterable[Diagnostic], wording: Wording) -> dict[int, Mistake]:
    """The first mistake of each line, by line."""
    by_line: dict[int, Mistake] = {}
    for each in found:
        span = each.span
        is_hint = each.severity is Severity.HINT
        message = (wording.hint(each) if is_hint else None) or wording.mistake(each)
        meant = each.meant if each.found and span.end > span.start else ""
        end = each.meant_end or span.end
        by_line.setdefault(span.line, Mistake(span.line, message, is_hint, span.start, end, meant))
    return by_line


def mended(text: str, mistake: Mistake) -> str:
    """The text with what was meant."""
    return text[: mistake.start] + mistake.meant + text[mistake.end :]
