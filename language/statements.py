"""Statements of GoDonnie as statements of Python: one function for each scope.

A variable is a local variable of the function, ``v_`` and its name: where it does not exist, Python
itself says so. ``o_`` and a name is the site that declared the variable, kept only where the name could
be declared twice (``declarations``). ``p_``, a name and a number of arguments is a procedure, a global name.
``d`` is the link of the open calls (``levels``). Where it can be stopped and held is in ``loops``.
"""

from __future__ import annotations

from devices.ports.hints import TYPE_CHECKING
from language.commands import command
from language.declarations import Declarations
from language.expressions import Bounds, Expressions
from language.loops import Interruption, Nesting, counts, turns_of
from language.scopes import Scope
from language.syntax import (
    Assign,
    Call,
    Declare,
    Expression,
    For,
    If,
    Procedure,
    Repeat,
    Statement,
    Unused,
    While,
)
from language.translated import (
    PARAMETER,
    VARIABLE,
    Header,
    Sites,
    Unit,
    assign,
    call,
    compiled,
    constant,
    do,
    element,
    forget,
    function,
    give_back,
    loop_over,
    loop_while,
    procedure_taking,
    unless_break,
    when,
)

if TYPE_CHECKING:
    import ast
    from types import CodeType


class ScopeTranslator:
    """Translates one scope. Used once."""

    def __init__(
        self,
        scope: Scope,
        bounds: Bounds,
        numbers: dict[int, int],
        stored: frozenset[str],
        *,
        terminal: bool,
        hooked: bool,
    ) -> None:
        """``numbers``: each procedure's unit, by the identity of its node. ``stored``: names that exist."""
        self._scope = scope
        self._numbers = numbers
        self._stored = stored
        self._terminal = terminal
        self._sites = Sites()
        self._expressions = Expressions(self._sites, bounds)
        self._declarations = Declarations(scope, self._sites, stored)
        in_procedure = scope.procedure is not None
        self._interruption = Interruption(self._sites, in_procedure=in_procedure, hooked=hooked)
        self._nesting = Nesting(self._interruption)
        self._out: list[ast.stmt] = []
        self._headers: list[Header] = []
        self._calls: set[tuple[str, int]] = set()

    def unit(self) -> Unit:
        code = self._code()
        return Unit(
            self._scope.program,
            self._scope.procedure,
            code,
            tuple(self._sites.nodes),
            tuple(self._headers),
            frozenset(self._calls),
            frozenset(self._interruption.lines),
        )

    # --- the function

    def _code(self) -> CodeType:
        procedure = self._scope.procedure
        site = 1 if procedure is None else self._sites.new(procedure)
        self._block(self._scope.body)
        body = [*self._beginning(site), *self._out]
        if procedure is None:
            names = [VARIABLE + name for name in sorted(self._stored)]
            definition = function(
                site, "program", ["d", *names], [*body, give_back(site, call(site, "locals"))]
            )
        else:
            names = [VARIABLE + parameter.name for parameter in self._scope.parameters]
            definition = function(site, "procedure", ["d", *dict.fromkeys(names)], body)
        return compiled(definition)

    def _beginning(self, site: int) -> list[ast.stmt]:
        return [
            *self._interruption.at_beginning(site),
            *self._nesting.at_beginning(site),
            *self._declarations.at_beginning(site),
        ]

    # --- statements

    def _block(self, statements: tuple[Statement, ...]) -> None:
        for statement in statements:
            site = self._sites.new(statement)
            self._out += self._interruption.before(site, statement)
            self._statement(site, statement)

    def _inner(self, statements: tuple[Statement, ...]) -> list[ast.stmt]:
        """A block inside a statement."""
        outside, self._out = self._out, []
        self._block(statements)
        inside, self._out = self._out, outside
        return inside

    def _add(self, *statements: ast.stmt) -> None:
        self._out += self._expressions.take_prelude()
        self._out += statements

    def _statement(self, site: int, statement: Statement) -> None:
        match statement:
            case Declare():
                self._declare(site, statement)
            case Assign():
                self._assign(site, statement)
            case If():
                self._if(site, statement)
            case While():
                self._while(site, statement)
            case Repeat():
                self._repeat(site, statement)
            case For():
                self._for(site, statement)
            case Procedure():
                self._procedure(statement)
            case Call():
                self._call(site, statement)
            case Unused():
                pass
            case _:
                self._command(site, statement)

    # --- variables

    def _declare(self, site: int, declare: Declare) -> None:
        name = declare.name.name
        self._out += self._declarations.refused_if_other(site, declare.name)
        self._give(site, name, declare.value)
        self._out += self._declarations.made_by(site, name, site)

    def _assign(self, site: int, assignment: Assign) -> None:
        self._out += self._declarations.asked_for(assignment.name)
        self._give(site, assignment.name.name, assignment.value)

    def _give(self, site: int, name: str, value: Expression | None) -> None:
        code = constant(site, 0) if value is None else self._expressions.value(value)
        self._add(assign(site, VARIABLE + name, code))
        self._declarations.give(name)

    # --- blocks

    def _if(self, site: int, statement: If) -> None:
        test = self._expressions.test(statement.condition)
        self._add()
        declarations, before = self._declarations, set(self._declarations.known)
        then = self._inner(statement.then)
        after_then, declarations.known = declarations.known, before
        otherwise = self._inner(statement.otherwise or ())
        declarations.known &= after_then
        self._out.append(when(site, test, then or [do(site, constant(site, None))], otherwise))

    def _while(self, site: int, loop: While) -> None:
        self._enter()
        test = self._expressions.test(loop.condition)
        prelude = self._expressions.take_prelude()
        body = self._turn(loop)
        self._leave(site, [_loop_while(site, prelude, test, body)])

    def _repeat(self, site: int, loop: Repeat) -> None:
        self._enter()
        times = self._expressions.value(loop.times)
        prelude = self._expressions.take_prelude()
        body = self._turn(loop)
        self._leave(site, [*prelude, loop_over(site, "r", call(site, "turns", times), body)])

    def _turn(self, loop: While | Repeat) -> list[ast.stmt]:
        inside = self._inner(loop.body)
        return [*inside, *self._interruption.after_turn(self._sites.new(loop), loop)]

    def _for(self, site: int, loop: For) -> None:
        if isinstance(loop.start, Assign):
            self._assign(site, loop.start)
            self._loop_of_for(loop)
            return
        name, declarations = loop.start.name.name, self._declarations
        self._out += declarations.refused_if_any(loop.start.name)
        self._give(site, name, loop.start.value)
        self._out += declarations.made_by(site, name, site)
        first = self._sites.next
        self._loop_of_for(loop)
        self._headers.append(Header(name, first, self._sites.next - 1))
        declarations.forget(name)
        self._out += [forget(site, VARIABLE + name), *declarations.made_by(site, name, 0)]

    def _loop_of_for(self, loop: For) -> None:
        self._enter()
        site = self._sites.new(loop)
        body = [*self._inner(loop.body), *self._interruption.after_turn(site, loop)]
        if counts(loop, self._declarations.written, self._expressions):
            counting = turns_of(loop, site, self._expressions)
            statement = loop_over(site, VARIABLE + loop.step.name.name, counting, body)
        else:
            statement = self._general_loop(site, loop, body)
        self._leave(site, [statement])

    def _general_loop(self, site: int, loop: For, body: list[ast.stmt]) -> ast.stmt:
        known = set(self._declarations.known)
        outside, self._out = self._out, body
        self._assign(self._sites.new(loop.step), loop.step)
        self._out = outside
        self._declarations.known = known
        test = self._expressions.test(loop.condition)
        return _loop_while(site, self._expressions.take_prelude(), test, body)

    def _enter(self) -> None:
        """Begin a loop."""
        self._declarations.enter()
        self._nesting.enter()

    def _leave(self, site: int, loop: list[ast.stmt]) -> None:
        """End a loop."""
        self._declarations.leave()
        self._out += self._nesting.leave(site, loop)

    # --- procedures and commands

    def _procedure(self, procedure: Procedure) -> None:
        site = self._sites.new(procedure.name)
        number = constant(site, self._numbers[id(procedure)])
        self._add(do(site, call(site, "may_declare", number)))
        seen: set[str] = set()
        for parameter in procedure.parameters:
            if parameter.name in seen:
                place = self._sites.new(parameter)
                typed = constant(place, self._scope.program.typed(parameter.span))
                self._add(do(place, call(place, "clash", constant(place, PARAMETER), typed)))
                return
            seen.add(parameter.name)
        self._add(do(site, call(site, "declare", number)))

    def _call(self, site: int, statement: Call) -> None:
        name, arguments = statement.name.name, statement.arguments
        self._calls.add((name, len(arguments)))
        values = self._expressions.values(arguments)
        deeper = element(site, "d", 1)
        procedure = procedure_taking(name, len(arguments))
        self._add(self._interruption.called(site, procedure, deeper, *values))

    def _command(self, site: int, statement: Statement) -> None:
        action = command(site, statement, self._expressions, self._scope.program, terminal=self._terminal)
        self._add(do(site, action), self._interruption.checkpoint(site))


def _loop_while(site: int, prelude: list[ast.stmt], test: ast.expr, body: list[ast.stmt]) -> ast.stmt:
    """A loop with a test that may need statements before it each time."""
    if prelude:
        return loop_while(site, constant(site, True), [*prelude, unless_break(site, test), *body])
    return loop_while(site, test, body)
