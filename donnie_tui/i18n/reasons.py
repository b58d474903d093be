"""The system's reasons (no such folder, disk full) in the learner's language; the system's are English.

Rule: whoever meets an error passes on the words of the system as ``reason``; here alone they are told.
"""

from __future__ import annotations

import errno
import os
from functools import cache

from donnie_tui.i18n.phrasing import Phrasing


def reason_told(code: str, reason: str, words: Phrasing) -> str:
    """The reason in the sentence of ``code``; as it is where nobody knows it."""
    name = _names().get(reason)
    for each in (f"reason-{name}-{code}", f"reason-{name}"):
        if name and words.knows(each):
            return words(each)
    return reason


@cache
def _names() -> dict[str, str]:
    """Of the errors' numbers, by what the system says of them."""
    return {os.strerror(number): name for number, name in errno.errorcode.items()}
