"""Hints about a program that can be read: what will surely fail or do nothing when it is reached.

Rule: a hint is never a guess, and never keeps a program from running. Names (``names``) are looked
at only where the whole program is known; in the terminal an earlier batch may have declared them.
"""

from __future__ import annotations

from collections.abc import Iterator

from language import syntax
from language.diagnostics import Diagnostic, Kind, Severity
from language.keywords import argument_spelling, spelling
from language.lexer import lex
from language.syntax import Program


def check(program: Program, *, whole: bool = True) -> tuple[Diagnostic, ...]:
    """The hints, in the order of the text. ``whole`` is False for a batch of a terminal."""
    found = [*_unused_values(program), *_negative_steps(program)]
    if whole:
        from language.names import Names  # no batch of a terminal

        found += Names(program).hints()
    return tuple(sorted(found, key=lambda hint: hint.span.start))


# --- what does nothing --------------------------------------------------------------------------------


def _unused_values(program: Program) -> Iterator[Diagnostic]:
    unused = [each for each in syntax.walk(program.body) if isinstance(each, syntax.Unused)]
    language = _language_of(program) if unused else "en"
    for statement in unused:
        word, spoken = _sensor(statement.value, language)
        speak = spelling("SPEAK", language)
        yield Diagnostic(
            Kind.UNUSED_VALUE,
            statement.span,
            found=program.typed(statement.span),
            meant=f"{speak} {spoken}",
            details={"word": word, "speak": speak, "value": spoken},
            severity=Severity.HINT,
        )


def _negative_steps(program: Program) -> Iterator[Diagnostic]:
    """FW -2, which walks nowhere: learners mean the other direction."""
    for each in syntax.walk(program.body):
        match each:
            case syntax.Walk(
                direction=direction, steps=syntax.Negative(operand=syntax.Number(value=steps))
            ) if steps:
                is_forward = direction is syntax.Direction.FORWARD
                other = spelling("BW" if is_forward else "FW", _language_of(program))
                typed = program.typed(each.span)
                meant = f"{other} {steps}"
                yield Diagnostic(
                    Kind.UNUSED_VALUE, each.span, "steps", typed, meant=meant, severity=Severity.HINT
                )


def _language_of(program: Program) -> str:
    from language.origin import language_of  # few leave a sensor unread

    return language_of(lex(program.source).tokens)


def _sensor(sensor: syntax.Distance | syntax.Position | syntax.Colour, language: str) -> tuple[str, str]:
    """Its canonical word, and how it is written in full."""
    match sensor:
        case syntax.Distance(bearing=bearing):
            word, argument = "DISTANCE", argument_spelling(bearing, language)
        case syntax.Position(axis=axis):
            word, argument = "POS", argument_spelling(axis, language)
        case syntax.Colour(colour=colour):
            word, argument = "COLOR", argument_spelling(colour, language)
    return word, f"{spelling(word, language)} {argument}"
