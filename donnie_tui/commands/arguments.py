"""Parses arguments of commands that several handlers take. Raises ``NotUnderstood`` for anything else."""

from __future__ import annotations

from donnie_tui.commands.interaction import NotUnderstood
from donnie_tui.core.typed_words import count_in, numbers_in


def count(argument: str, default: int) -> int:
    """A number from 1, or ``default`` where nothing was typed."""
    found = count_in(argument, default)
    if found is None:
        raise NotUnderstood
    return found


def numbers(argument: str, *, least: int = 0, most: int) -> tuple[int, ...]:
    """From ``least`` to ``most`` whole numbers, with blanks or commas between them."""
    found = numbers_in(argument, most=most)
    if found is None or len(found) < least:
        raise NotUnderstood
    return found
