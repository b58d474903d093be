"""All names of a whole program and what they stand for: which will be missing when they are reached.

A missing name is told where it is used first, and as it was typed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from devices.ports.values import Mutable, field, replace
from language import syntax
from language.diagnostics import Diagnostic, Kind, Severity
from language.mistakes import diagnostic, undeclared_procedure, undeclared_variable
from language.syntax import Expression, Name, Program, Statement, blocks_of


class _Scope(Mutable):
    """The variables of the program, or of one procedure."""

    procedure: str = ""
    """As it was typed; empty for the program."""
    declared: set[str] = field(default_factory=set)
    used: list[Name] = field(default_factory=list)


class Names:
    """All names of one program and what they stand for."""

    def __init__(self, program: Program) -> None:
        self._program = program
        self._main = _Scope()
        self._scopes = [self._main]
        self._procedures: dict[str, list[syntax.Procedure]] = {}
        self._calls: list[syntax.Call] = []
        self._typed_only: list[syntax.Quit | syntax.RunTyped] = []
        self._read(program.body, self._main)

    def _read(self, statements: tuple[Statement, ...], scope: _Scope) -> None:
        for statement in statements:
            scope.used += _names_in(_expressions(statement))
            match statement:
                case syntax.Declare(name=name) | syntax.For(start=syntax.Declare(name=name)):
                    scope.declared.add(name.name)
                case syntax.Assign(name=name):
                    scope.used.append(name)
                case syntax.Call():
                    self._calls.append(statement)
                case syntax.Quit() | syntax.RunTyped():
                    self._typed_only.append(statement)
                case _:
                    pass
            if isinstance(statement, syntax.For):
                scope.used += [each.name for each in (statement.start, statement.step)]
            self._read_blocks(statement, scope)

    def _read_blocks(self, statement: Statement, scope: _Scope) -> None:
        if isinstance(statement, syntax.Procedure):
            self._procedures.setdefault(statement.name.name, []).append(statement)
            typed = self._program.typed(statement.name.span)
            scope = _Scope(typed, {each.name for each in statement.parameters})
            self._scopes.append(scope)
        for block in blocks_of(statement):
            self._read(block, scope)

    def hints(self) -> Iterator[Diagnostic]:
        for scope in self._scopes:
            for name in _firsts(scope.used):
                if name.name not in scope.declared:
                    yield _as_hint(self._undeclared(name, scope))
        for name in _firsts(call.name for call in self._calls):
            if name.name not in self._procedures:
                found = undeclared_procedure(self._program, name, self._procedures, most_compared=None)
                yield _as_hint(found)
        for call in self._calls:
            yield from self._about_call(call)
        for statement in self._typed_only:
            yield _as_hint(diagnostic(self._program, statement.span, Kind.TERMINAL_ONLY, {}))

    def _undeclared(self, name: Name, scope: _Scope) -> Diagnostic:
        of_program = self._main.declared
        return undeclared_variable(
            self._program, name, scope.declared, scope.procedure, of_program, most_compared=None
        )

    def _about_call(self, call: syntax.Call) -> Iterator[Diagnostic]:
        declared = self._procedures.get(call.name.name, [])
        counts = {len(each.parameters) for each in declared}
        given = len(call.arguments)
        if len(counts) == 1 and given not in counts:
            name = self._program.typed(call.name.span)
            details: dict[str, str | int] = {"name": name, "wanted": counts.pop(), "given": given}
            found = diagnostic(self._program, call.name.span, Kind.WRONG_ARGUMENT_COUNT, details)
            yield _as_hint(found)


def _as_hint(mistake: Diagnostic) -> Diagnostic:
    return replace(mistake, severity=Severity.HINT)


def _firsts(names: Iterable[Name]) -> Iterator[Name]:
    """Each name where it stands first."""
    first: dict[str, Name] = {}
    for name in names:
        known = first.setdefault(name.name, name)
        if name.span.start < known.span.start:
            first[name.name] = name
    yield from first.values()


def _expressions(statement: Statement) -> tuple[Expression, ...]:
    """What a statement itself evaluates, the blocks in it apart."""
    match statement:
        case syntax.Declare(value=value):
            return () if value is None else (value,)
        case syntax.Assign(value=value):
            return (value,)
        case syntax.Speak(what=what):
            return () if isinstance(what, syntax.Text) else (what,)
        case syntax.Walk(steps=value) | syntax.Turn(degrees=value) | syntax.Wait(seconds=value):
            return (value,)
        case syntax.If(condition=condition) | syntax.While(condition=condition):
            return (condition.left, condition.right)
        case syntax.Repeat(times=times):
            return (times,)
        case syntax.Call(arguments=arguments):
            return arguments
        case syntax.For(start=start, condition=condition, step=step):
            return (*_expressions(start), condition.left, condition.right, *_expressions(step))
        case _:
            return ()


def _names_in(expressions: Iterable[Expression]) -> Iterator[Name]:
    for expression in expressions:
        match expression:
            case Name():
                yield expression
            case syntax.Negative(operand=operand):
                yield from _names_in((operand,))
            case syntax.Binary(left=left, right=right):
                yield from _names_in((left, right))
            case _:
                pass
