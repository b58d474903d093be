"""What keeps text from doing anything to a terminal: one table of what it would obey or can't encode.

Rule: each such sign becomes a blank, so that places in the text stay the same. Whatever shows, prints or
reads text takes the table from here.
"""

from __future__ import annotations

import re

HARMFUL = "[\x00-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\ud800-\udfff]"
"""Control characters, ends of lines, what turns text around so that a line reads as what it is not, and
halves of characters. A pattern, made when it is needed: a start needs none."""


def printable(text: str) -> str:
    """The text as one line."""
    return text if text.isprintable() else re.sub(HARMFUL, " ", text)


def cleaned(text: str) -> str:
    """The text with its lines: tabs and the language's own line ends (CR, LF) stay."""
    return text if text.isprintable() else re.sub(rf"(?![\t\r\n]){HARMFUL}", " ", text)
