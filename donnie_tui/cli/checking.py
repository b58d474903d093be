"""``donnie check``: every mistake of form and every hint, a line each; nothing runs, no world is needed."""

from __future__ import annotations

from pathlib import Path

from donnie_tui.cli import codes
from donnie_tui.cli.order import Order
from donnie_tui.cli.output import Output
from donnie_tui.cli.sources import Source, read_source
from donnie_tui.i18n.mistakes import remark
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.settings.chosen import Source as Origin
from language.checker import check as hints_for
from language.diagnostics import MOST_MISTAKES, Diagnostic, Severity
from language.parser import parse


def check(order: Order) -> int:
    """The worst of the files counts. A folder stands for the programs in it."""
    colours = _colours(order)
    return max(_check(order, name, colours) for name in order.invocation.arguments.file)


def _check(order: Order, name: str, colours: frozenset[str] | None) -> int:
    names = programs_in(name)
    if not names:
        order.output.complaint(order.words("check-no-programs", path=name))
    return max((_check_file(order, each, colours) for each in names), default=codes.UNUSABLE)


def programs_in(name: str) -> tuple[str, ...]:
    """The files of a folder that are named as programs are, by name; of anything else only itself."""
    folder = Path(name)
    try:
        if not folder.is_dir():
            return (name,)
        found = [each for each in folder.iterdir() if each.suffix.lower() == ".gd" and each.is_file()]
    except (OSError, ValueError):
        return (name,)  # reading it tells why
    return tuple(sorted(map(str, found)))


def _check_file(order: Order, name: str, colours: frozenset[str] | None) -> int:
    try:
        source = read_source(name, order.words)
    except Unusable as unusable:
        order.output.complaint(unusable.sentence)
        return codes.UNUSABLE
    found = diagnostics_of(source.text, colours)
    for each in found:
        order.output.line(line_for(each, source, order.words))
    is_wrong = any(each.severity is Severity.ERROR for each in found)
    if is_wrong and len(found) >= MOST_MISTAKES:
        order.output.complaint(order.words("more-mistakes", limit=MOST_MISTAKES))
    if not found:
        order.output.complaint(order.words("check-clean", file=source.name))
    return codes.FAILED if is_wrong else codes.DONE


def diagnostics_of(text: str, colours: frozenset[str] | None) -> tuple[Diagnostic, ...]:
    """The mistakes of form, or the hints about a program that has none."""
    parsed = parse(text, colours=colours)
    return parsed.diagnostics if parsed.program is None else hints_for(parsed.program)


def line_for(diagnostic: Diagnostic, source: Source, words: Words) -> str:
    """``FILE:LINE:COLUMN: kind: message``; the kind of a hint is ``hint``."""
    is_hint = diagnostic.severity is Severity.HINT
    kind = "hint" if is_hint else diagnostic.kind.value
    place = f"{source.name}:{diagnostic.span.line}:{diagnostic.span.column}"
    return f"{place}: {kind}: {remark(diagnostic, words)}"


def complain(diagnostics: tuple[Diagnostic, ...], source: Source, words: Words, output: Output) -> None:
    """Tell mistakes where they are not what was asked for."""
    for each in diagnostics:
        output.complaint(line_for(each, source, words))


def _colours(order: Order) -> frozenset[str] | None:
    """What the robot sees, if a world was named; every colour of the language otherwise."""
    if order.settings.source_of("world") is not Origin.OPTION:
        return None
    from donnie_tui.bootstrap import colours_of_world

    return colours_of_world(order.settings, order.words)
