"""``donnie format``: the canonical layout, to standard output or in place; keywords translated on demand."""

from __future__ import annotations

from donnie_tui.cli import codes
from donnie_tui.cli.checking import complain
from donnie_tui.cli.order import Order
from donnie_tui.cli.sources import Source, read_source
from donnie_tui.core.documents import DocumentError, write_program
from donnie_tui.i18n.words import Unusable
from language.formatter import formatted


def format_files(order: Order) -> int:
    """The worst of the files counts; one with mistakes is told and left as it is."""
    return max(_format_file(order, name) for name in order.invocation.arguments.file)


def _format_file(order: Order, name: str) -> int:
    try:
        source = read_source(name, order.words)
        result = formatted(source.text, order.invocation.arguments.to)
        if result.text is None:
            complain(result.diagnostics, source, order.words, order.output)
            return codes.FAILED
        _put(result.text, source, order)
    except Unusable as unusable:
        order.output.complaint(unusable.sentence)
        return codes.UNUSABLE
    return codes.DONE


def _put(text: str, source: Source, order: Order) -> None:
    if not order.invocation.arguments.write or source.path is None:
        order.output.text(text)
        return
    try:
        if text != source.text:
            write_program(source.path, text)
    except DocumentError as error:
        raise Unusable(order.words(error.code, path=error.path, reason=error.reason)) from None
