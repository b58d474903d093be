"""The tokens that open a block and those that end it."""

from __future__ import annotations

from language.lexer import KIND

OPENERS = {KIND[name]: name for name in ("IF", "FOR", "REPEAT", "WHILE", "PROCEDURE")}
ENDS = {KIND[f"END_{name}"]: name for name in OPENERS.values()}
