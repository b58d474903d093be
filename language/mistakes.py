"""Mistakes of meaning as diagnostics: the place, the name as typed, and the name that was probably meant."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from language.diagnostics import Diagnostic, Kind
from language.nearby import nearest
from language.syntax import Declare, For, Name, Procedure, Program, Span, walk

_MOST_COMPARED = 300
"""Names that are compared with a wrong one while a program runs."""


def diagnostic(
    program: Program, span: Span, kind: Kind, details: Mapping[str, str | int], meant: str = ""
) -> Diagnostic:
    """A mistake at a place; what was found is the text that stands there."""
    return Diagnostic(kind, span, found=program.typed(span), meant=meant, details=details)


def undeclared_variable(
    program: Program,
    name: Name,
    own: Collection[str],
    procedure: str,
    of_program: Collection[str],
    *,
    most_compared: int | None = _MOST_COMPARED,
) -> Diagnostic:
    """``own``: the variables that exist there. ``procedure``: as typed, or empty in the program itself.

    ``of_program``: the variables of the program, which a procedure does not see; the detail
    ``in_procedure`` says that the name is one of them. ``most_compared``: None for every name.
    """
    if procedure and name.name in of_program:
        return _undeclared(program, name, Kind.UNDECLARED_VARIABLE, "", {"in_procedure": procedure})
    meant = _meant(program, name, own, most_compared)
    return _undeclared(program, name, Kind.UNDECLARED_VARIABLE, meant, {})


def undeclared_procedure(
    program: Program, name: Name, existing: Collection[str], *, most_compared: int | None = _MOST_COMPARED
) -> Diagnostic:
    meant = _meant(program, name, existing, most_compared)
    return _undeclared(program, name, Kind.UNDECLARED_PROCEDURE, meant, {})


def _undeclared(
    program: Program, name: Name, kind: Kind, meant: str, details: Mapping[str, str]
) -> Diagnostic:
    return diagnostic(program, name.span, kind, {"name": program.typed(name.span), **details}, meant)


def _meant(program: Program, name: Name, existing: Collection[str], most_compared: int | None) -> str:
    near = nearest(name.name, sorted(existing)[:most_compared])
    return _as_declared(program, near) if near else ""


def _as_declared(program: Program, name: str) -> str:
    """A folded name as the learner wrote it where it was declared."""
    for statement in walk(program.body):
        for declared in _declared_by(statement):
            if declared.name == name:
                return program.typed(declared.span)
    return name


def _declared_by(statement: object) -> tuple[Name, ...]:
    match statement:
        case Declare(name=name) | For(start=Declare(name=name)):
            return (name,)
        case Procedure(name=name, parameters=parameters):
            return (name, *parameters)
        case _:
            return ()
