"""The scopes of a program: itself and each of its procedures, every one with variables of its own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from devices.ports.values import Frozen
from language.syntax import Call, Declare, For, Name, Procedure, Program, Statement, blocks_of


class Declared(Frozen):
    """A procedure that was declared, as a later batch finds it in the memory."""

    procedure: Procedure
    program: Program

    @property
    def typed_name(self) -> str:
        return self.program.typed(self.procedure.name.span)


class Scope(Frozen):
    """A program without its procedures, or one procedure without those that are declared in it."""

    program: Program
    procedure: Procedure | None

    @property
    def body(self) -> tuple[Statement, ...]:
        return self.program.body if self.procedure is None else self.procedure.body

    @property
    def parameters(self) -> tuple[Name, ...]:
        return () if self.procedure is None else self.procedure.parameters

    def statements(self) -> Iterator[Statement]:
        """Every statement of this scope, in no particular order; a procedure in it counts as one."""
        waiting = list(self.body)
        while waiting:
            statement = waiting.pop()
            yield statement
            if not isinstance(statement, Procedure):
                for block in blocks_of(statement):
                    waiting.extend(block)

    def declarations(self) -> Counter[str]:
        """How many parameters, VAR statements and FOR headers declare each name."""
        names = Counter(parameter.name for parameter in self.parameters)
        for statement in self.statements():
            start = statement.start if isinstance(statement, For) else statement
            if isinstance(start, Declare):
                names[start.name.name] += 1
        return names

    def calls(self) -> frozenset[str]:
        """The names of the procedures that the scope may call."""
        return frozenset(each.name.name for each in self.statements() if isinstance(each, Call))


def scopes_of(outermost: Scope) -> tuple[Scope, ...]:
    """The scope itself, then every procedure declared in it or in one of those."""
    found = [outermost]
    for scope in found:
        found.extend(
            Scope(scope.program, statement)
            for statement in scope.statements()
            if isinstance(statement, Procedure)
        )
    return tuple(found)
