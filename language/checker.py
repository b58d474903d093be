"""Hints about a correct text: commands that do nothing, and mistakes that are certain when it runs.

Rule: a hint is never a guess, and never keeps a program from running. The checker looks up names only if the
whole program is known; in the terminal an earlier batch may have declared them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import assert_never

from msgspec.structs import replace

from language import syntax
from language.diagnostics import Diagnostic, MistakeKind, Severity, mistake_at
from language.keywords import argument_spelling, spelling
from language.lexer import language_of, lex
from language.syntax import Expression, Name, Program, Scope, Statement, scopes_of


def check(program: Program, *, whole: bool = True) -> tuple[Diagnostic, ...]:
    """The hints, in the order of the text. ``whole`` is False for a batch of a terminal."""
    found = [*_unused_values(program), *_negative_steps(program)]
    if whole:
        scopes = scopes_of(Scope(program, None))
        found += [*_undeclared_variables(scopes), *_wrong_calls(scopes), *_terminal_only(scopes)]
    found.sort(key=lambda mistake: mistake.span.start)
    return tuple(replace(mistake, severity=Severity.HINT) for mistake in found)


# --- commands that do nothing -------------------------------------------------------------------------


def _unused_values(program: Program) -> Iterator[Diagnostic]:
    unused = [each for each in syntax.walk(program.body) if isinstance(each, syntax.UnusedSensor)]
    language = _language_of(program) if unused else "en"
    for statement in unused:
        word, value = _sensor(statement.value, language)
        speak = spelling("SPEAK", language)
        details = {"word": word, "speak": speak, "value": value}
        yield mistake_at(program, statement.span, MistakeKind.UNUSED_VALUE, details, f"{speak} {value}")


def _negative_steps(program: Program) -> Iterator[Diagnostic]:
    """FW -2, which walks nowhere: learners mean the other direction."""
    for each in syntax.walk(program.body):
        match each:
            case syntax.WalkCommand(
                direction=direction, steps=syntax.Negative(operand=syntax.NumberLiteral(value=steps))
            ) if steps:
                is_forward = direction is syntax.Direction.FORWARD
                other = spelling("BW" if is_forward else "FW", _language_of(program))
                yield mistake_at(
                    program, each.span, MistakeKind.UNUSED_VALUE, {}, f"{other} {steps}", "steps"
                )


def _language_of(program: Program) -> str:
    return language_of(lex(program.source).tokens, program.source)


def _sensor(sensor: syntax.Sensor, language: str) -> tuple[str, str]:
    """Its canonical word, and its full spelling."""
    match sensor:
        case syntax.DistanceSensor(bearing=bearing):
            word, argument = "DISTANCE", argument_spelling(bearing, language)
        case syntax.NamedDistanceSensor(name=name):
            word, argument = "DISTANCE", f'"{name}"'
        case syntax.PositionSensor(axis=axis):
            word, argument = "POS", argument_spelling(axis, language)
        case syntax.ColourSensor(colour=colour):
            word, argument = "COLOR", argument_spelling(colour, language)
        case _ as never:
            assert_never(never)
    return word, f"{spelling(word, language)} {argument}"


# --- names --------------------------------------------------------------------------------------------


def _undeclared_variables(scopes: tuple[Scope, ...]) -> Iterator[Diagnostic]:
    """Each scope's undeclared names, at their first use."""
    from language.suggestions import undeclared_variable  # only whole programs need it

    of_program = scopes[0].declarations()
    for scope in scopes:
        declared = scope.declarations()
        procedure = scope.program.typed(scope.procedure.name.span) if scope.procedure else ""
        for name in _first_uses(name for each in scope.statements() for name in _names_used(each)):
            if name.name not in declared:
                yield undeclared_variable(
                    scope.program, name, declared, procedure, of_program, most_compared=None
                )


def _wrong_calls(scopes: tuple[Scope, ...]) -> Iterator[Diagnostic]:
    """Calls of procedures that are declared nowhere, or never with that many parameters."""
    from language.suggestions import undeclared_procedure  # only whole programs need it

    program = scopes[0].program
    counts: dict[str, set[int]] = {}
    for scope in scopes[1:]:
        assert scope.procedure is not None
        counts.setdefault(scope.procedure.name.name, set()).add(len(scope.parameters))
    calls = [each for scope in scopes for each in scope.statements() if isinstance(each, syntax.Call)]
    for name in _first_uses(call.name for call in calls):
        if name.name not in counts:
            yield undeclared_procedure(program, name, counts, most_compared=None)
    for call in calls:
        wanted, given = counts.get(call.name.name, set()), len(call.arguments)
        if len(wanted) == 1 and given not in wanted:
            span = call.name.span
            details: dict[str, str | int] = {
                "name": program.typed(span),
                "wanted": min(wanted),
                "given": given,
            }
            yield mistake_at(program, span, MistakeKind.WRONG_ARGUMENT_COUNT, details)


def _terminal_only(scopes: tuple[Scope, ...]) -> Iterator[Diagnostic]:
    for scope in scopes:
        for each in scope.statements():
            if isinstance(each, syntax.QuitCommand | syntax.RunCommand):
                yield mistake_at(scope.program, each.span, MistakeKind.TERMINAL_ONLY, {})


def _first_uses(names: Iterable[Name]) -> Iterable[Name]:
    """Each name at its first place in the text."""
    first: dict[str, Name] = {}
    for name in names:
        known = first.setdefault(name.name, name)
        if name.span.start < known.span.start:
            first[name.name] = name
    return first.values()


def _names_used(statement: Statement) -> Iterator[Name]:
    """The variables that a statement reads or assigns, without those of the blocks in it."""
    match statement:
        case syntax.Assign(name=name):
            yield name
        case syntax.For(start=start, step=step):
            yield from (start.name, step.name)
    for expression in _expressions(statement):
        yield from _names_in(expression)


def _expressions(statement: Statement) -> tuple[Expression, ...]:
    """The expressions that a statement evaluates, without those of the blocks in it."""
    match statement:
        case syntax.Declare(value=value):
            return () if value is None else (value,)
        case syntax.Assign(value=value):
            return (value,)
        case syntax.If(condition=condition) | syntax.While(condition=condition):
            return (condition.left, condition.right)
        case syntax.Call(arguments=arguments):
            return arguments
        case syntax.For(start=start, condition=condition, step=step):
            return (*_expressions(start), condition.left, condition.right, *_expressions(step))
        case syntax.Procedure():
            return ()
        case _:  # a command, or REPEAT
            parts = (getattr(statement, each) for each in statement.__struct_fields__)
            return tuple(each for each in parts if isinstance(each, Expression))


def _names_in(expression: Expression) -> Iterator[Name]:
    match expression:
        case Name():
            yield expression
        case syntax.Negative(operand=operand):
            yield from _names_in(operand)
        case syntax.Binary(left=left, right=right):
            yield from _names_in(left)
            yield from _names_in(right)
