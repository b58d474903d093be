"""The canonical text of a program that is right in form."""

from __future__ import annotations

from language.formatter import formatted


def format_source(source: str, to: str | None = None) -> str:
    result = formatted(source, to)
    assert result.text is not None, result.diagnostics
    return result.text
