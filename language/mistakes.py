"""Mistakes of meaning as diagnostics: the place, the name as typed, and the name that was probably meant.

Some are found in the text (``checker``), the others by the program that runs: ``failure_of`` reads from what
ended the translated code what the learner did. Nothing here is loaded for a program without a mistake.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping

from language.diagnostics import Diagnostic, Kind, LanguageError, ProgramError, Refused
from language.levels import DEEPEST_CALL, Level, call_sites
from language.syntax import Call, Declare, For, Name, Procedure, Program, Span, walk
from language.translated import procedure_taking

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
    meant = _meant(program, name, own, most_compared) or _sensor_meant(program, name)
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
    from language.nearby import nearest  # only for names that there are not

    near = nearest(name.name, sorted(existing)[:most_compared])
    return _as_declared(program, near) if near else ""


def _sensor_meant(program: Program, name: Name) -> str:
    """DISTANSIA, written where no direction stands behind it and no value is given to it."""
    from language.lexer import lex
    from language.nearby import SENSORS, nearest_keyword
    from language.origin import language_of

    if re.match(r"\s*=(?!=)", program.source[name.span.end :]):
        return ""
    found = nearest_keyword(name.name, SENSORS, language_of(lex(program.source).tokens))
    return found.text if found and not found.complete else ""


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


def failure_of(
    error: BaseException, levels: list[Level], procedures: Collection[str], *, inside: bool
) -> LanguageError | None:
    """The mistake that an exception means; None if it is not the program's and must pass unchanged.

    ``procedures``: those that exist. ``inside``: the exception was raised by the translated code itself
    and not in something it called.
    """
    if isinstance(error, Refused) and levels:
        return ProgramError(_refused(error, levels[-1]), call_sites(levels))
    found = _found_by_python(error, levels, procedures) if inside else None
    return None if found is None else ProgramError(found, call_sites(levels))


def _refused(refused: Refused, level: Level) -> Diagnostic:
    node = level.unit.node(level.site)
    span = node.name.span if isinstance(node, Call) else level.unit.span(level.site)
    return diagnostic(level.unit.program, span, refused.kind, refused.details)


def _found_by_python(
    error: BaseException, levels: list[Level], procedures: Collection[str]
) -> Diagnostic | None:
    match error:
        case NameError():
            return _undeclared_at(levels, procedures)
        case ZeroDivisionError():
            return _refused(Refused(Kind.DIVISION_BY_ZERO), levels[-1])
        case IndexError():  # the deepest link has no next one
            return _refused(Refused(Kind.RECURSION_LIMIT, limit=DEEPEST_CALL), levels[-1])
        case _:
            return None


def _undeclared_at(levels: list[Level], procedures: Collection[str]) -> Diagnostic | None:
    """A name without a value: a procedure where it is called, else a variable."""
    level = levels[-1]
    unit, own = level.unit, level.variables()
    node = unit.node(level.site)
    if isinstance(node, Call):
        procedure = procedure_taking(node.name.name, len(node.arguments))
        if procedure not in level.frame.f_globals:
            return undeclared_procedure(unit.program, node.name, procedures)
    if not isinstance(node, Name) or node.name in own:
        node = unit.node(level.next_site())
    if not isinstance(node, Name):
        return None
    return undeclared_variable(unit.program, node, own, unit.typed_name, levels[0].variables())
