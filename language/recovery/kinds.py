"""Kinds of tokens, grouped by what they are to somebody who looks for the next command."""

from __future__ import annotations

from language.lexer import END, KIND, NAME
from language.outline import ENDS, OPENERS

ASSIGN, COMPARATOR, ELSE, LPAR, SEMICOLON, SIGN = (
    KIND[name] for name in ("ASSIGN", "COMPARATOR", "ELSE", "LPAR", "SEMICOLON", "SIGN")
)
VAR = KIND["VAR"]

BEHIND_FIRST_NAME = frozenset(KIND[name] for name in ("ASSIGN", "LSQB"))
"""Tell that the name before begins a command: an assignment or a call."""

HEAD_ENDS = frozenset(KIND[name] for name in ("THEN", "DO", "TIMES"))

SENSORS = frozenset(KIND[name] for name in ("DISTANCE", "POS", "COLOR"))

SIMPLE = frozenset(
    KIND[name]
    for name in (
        *("SPEAK", "FW", "BW", "TR", "TL", "WAIT", "SCAN", "STATE", "HISTORY"),
        *("SOUND", "BELT", "VIBRATE", "HELP", "QUIT", "RUN"),
    )
)
"""The words of commands that open no block."""

BEGINNERS = SIMPLE | OPENERS.keys() | ENDS.keys() | {ELSE, END}
"""Begin a command or end a block wherever they stand."""

COMMANDS = BEGINNERS | SENSORS | {NAME, VAR, SEMICOLON}
