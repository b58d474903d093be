"""``donnie check`` and ``donnie format``, and reading programs from files or standard input.

``check`` prints every mistake of form and every hint, a line each; nothing runs, and no world is needed.
``format`` writes the canonical layout to standard output or in place, and translates keywords on request.
"""

from __future__ import annotations

import sys
from pathlib import Path

from msgspec import Struct

from donnie_tui.cli.options import ExitCode, Order
from donnie_tui.cli.streams import Output
from donnie_tui.core.program_files import (
    LARGEST,
    DocumentError,
    checked_path,
    decode,
    read_to_the_end,
    write_program,
)
from donnie_tui.i18n.mistakes import remark
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.process.confinement import is_allowed
from donnie_tui.settings.settings import SettingSource
from language.checker import check as hints_for
from language.diagnostics import MOST_MISTAKES, Diagnostic, Severity
from language.formatter import formatted
from language.parser import parse


class Source(Struct, frozen=True):
    """A program's text, and what it is called."""

    name: str
    text: str
    path: Path | None
    """None for standard input."""


def read_source(name: str, words: Words) -> Source:
    """Raises ``Unusable``."""
    try:
        if name == "-":
            return Source("-", _standard_input(), None)
        path = checked_path(Path(name))
        return Source(name, read_to_the_end(path), path)
    except DocumentError as error:
        raise Unusable(words(error.code, path=error.path, reason=error.reason)) from None


def _standard_input() -> str:
    if sys.stdin is None:
        return ""
    return decode(sys.stdin.buffer.read(LARGEST + 1), "-")


def check(order: Order) -> int:
    """The worst of the files counts. A folder stands for the programs in it."""
    colours = _colours(order)
    return max(_check(order, name, colours) for name in order.invocation.arguments.file)


def _check(order: Order, name: str, colours: frozenset[str] | None) -> int:
    names = programs_in(name)
    if not names:
        order.output.complaint(order.words("check-no-programs", path=name))
    return max((_check_file(order, each, colours) for each in names), default=ExitCode.UNUSABLE)


def programs_in(name: str) -> tuple[str, ...]:
    """The files of a folder that are named as programs are, by name; of anything else only itself."""
    folder = Path(name)
    try:
        if not (is_allowed(folder) and folder.is_dir()):
            return (name,)
        found = [each for each in folder.iterdir() if each.suffix.lower() == ".gd"]
        found = [each for each in found if is_allowed(each) and each.is_file()]
    except (OSError, ValueError):
        return (name,)  # reading it reports why
    return tuple(sorted(map(str, found)))


def _check_file(order: Order, name: str, colours: frozenset[str] | None) -> int:
    try:
        source = read_source(name, order.words)
    except Unusable as unusable:
        order.output.complaint(unusable.sentence)
        return ExitCode.UNUSABLE
    found = diagnostics_of(source.text, colours)
    for each in found:
        order.output.line(line_for(each, source, order.words))
    is_wrong = any(each.severity is Severity.ERROR for each in found)
    if is_wrong and len(found) >= MOST_MISTAKES:
        order.output.complaint(order.words("more-mistakes", limit=MOST_MISTAKES))
    if not found:
        order.output.complaint(order.words("check-clean", file=source.name))
    return ExitCode.FAILED if is_wrong else ExitCode.DONE


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
    """Print mistakes as complaints, where they are not what was asked for."""
    for each in diagnostics:
        output.complaint(line_for(each, source, words))


def _colours(order: Order) -> frozenset[str] | None:
    """What the robot sees, if a world was named; every colour of the language otherwise."""
    if order.settings.source_of("world") is not SettingSource.OPTION:
        return None
    from donnie_tui.bootstrap import colours_of_world

    return colours_of_world(order.settings, order.words)


def format_files(order: Order) -> int:
    """The exit code is that of the worst file; a file with mistakes is reported and left as it is."""
    return max(_format_file(order, name) for name in order.invocation.arguments.file)


def _format_file(order: Order, name: str) -> int:
    try:
        source = read_source(name, order.words)
        result = formatted(source.text, order.invocation.arguments.to)
        if result.text is None:
            complain(result.diagnostics, source, order.words, order.output)
            return ExitCode.FAILED
        _put(result.text, source, order)
    except Unusable as unusable:
        order.output.complaint(unusable.sentence)
        return ExitCode.UNUSABLE
    return ExitCode.DONE


def _put(text: str, source: Source, order: Order) -> None:
    if not order.invocation.arguments.write or source.path is None:
        order.output.text(text)
        return
    try:
        if text != source.text:
            write_program(source.path, text)
    except DocumentError as error:
        raise Unusable(order.words(error.code, path=error.path, reason=error.reason)) from None
