"""The characters that could control a terminal or can't be encoded, and their removal.

Rule: each such character becomes a blank, so that columns in the text stay the same. All code that shows,
prints or reads text uses this table.
"""

from __future__ import annotations

import re

HARMFUL = "[\x00-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\ud800-\udfff]"
"""Control characters, line ends, marks that reverse the direction of text, and halves of characters.

A pattern, compiled on first use, since a start needs none.
"""


def printable(text: str) -> str:
    """The text as one line."""
    return text if text.isprintable() else re.sub(HARMFUL, " ", text)


def cleaned(text: str) -> str:
    """The text with its lines: tabs and the language's own line ends (CR, LF) stay."""
    return text if text.isprintable() else re.sub(rf"(?![\t\r\n]){HARMFUL}", " ", text)
