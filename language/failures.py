"""What ended the translated code, as the learner's mistake with its place."""

from __future__ import annotations

from collections.abc import Collection

from language.diagnostics import Diagnostic, Kind, LanguageError, ProgramError, Refused
from language.levels import Level, call_sites
from language.mistakes import diagnostic, undeclared_procedure, undeclared_variable
from language.stack import DEEPEST_CALL
from language.syntax import Call, Name
from language.translated_names import procedure_taking


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
            return _undeclared(levels, procedures)
        case ZeroDivisionError():
            return _refused(Refused(Kind.DIVISION_BY_ZERO), levels[-1])
        case IndexError():  # the deepest link has no next one
            return _refused(Refused(Kind.RECURSION_LIMIT, limit=DEEPEST_CALL), levels[-1])
        case _:
            return None


def _undeclared(levels: list[Level], procedures: Collection[str]) -> Diagnostic | None:
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
