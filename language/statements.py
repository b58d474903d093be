"""Statements of GoDonnie as statements of Python: one function for each scope.

A variable is a local variable of the function, ``v_`` and its name: where it does not exist, Python
itself says so. ``o_`` and a name is the site that declared the variable, kept only where the name could
be declared twice. ``p_``, a name and a number of arguments is a procedure, a global name. ``d`` is the
link of the open calls (``stack``).

The program is interruptible at the end of each turn of a loop, at each call and after each command: the
global ``flag`` is true when anything is wanted. Asking it is four times as cheap as drawing from a shared
iterator. The compilation for stepping asks before each statement instead, and for a loop's own line once
more after each of its turns: each line has a global of its own, ``w_`` and its number, that is None if
nothing is wanted there, or else the number of open calls up to which ``hook`` is to be called.

A procedure that is stopped returns True, and what called it does the same: that is many times as fast as
an exception that goes through thousands of open calls. Only the program itself raises it.
"""

from __future__ import annotations

import ast
from types import CodeType

from language.building import (
    Sites,
    assign,
    both,
    call,
    compare,
    constant,
    do,
    element,
    forget,
    function,
    give_back,
    load,
    loop_over,
    loop_while,
    outer,
    unless_break,
    when,
)
from language.commands import command
from language.counting import counts, turns_of
from language.expressions import VARIABLE, Bounds, Expressions
from language.scopes import Scope
from language.syntax import (
    Assign,
    Call,
    Declare,
    Expression,
    For,
    If,
    Name,
    Procedure,
    Repeat,
    Statement,
    Unused,
    While,
)
from language.units import Header, Unit

WANTED = "w_"
"""What the global that says whether a line is wanted begins with."""

OWNER = "o_"
"""What the Python name of a variable's declaration begins with."""

EARLIER = -1
"""The declaration of a variable that an earlier batch left."""

PARAMETER = -2

_MOST_LOOPS = 18
"""Loops inside each other in one function; CPython allows 20."""


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
        self._terminal = terminal
        self._hooked = hooked
        self._sites = Sites()
        self._expressions = Expressions(self._sites, bounds)
        self._stored = sorted(stored)
        self._clashing = _clashing(scope, frozenset(self._stored))
        self._mortal = {
            each.start.name.name
            for each in scope.statements()
            if isinstance(each, For) and isinstance(each.start, Declare) and each.start.name.name in stored
        }
        self._known = {*self._stored, *(parameter.name for parameter in scope.parameters)} - self._mortal
        self._written: set[str] = set()
        self._out: list[ast.stmt] = []
        self._loops = 0
        self._outlined: set[str] = set()
        self._headers: list[Header] = []
        self._calls: set[tuple[str, int]] = set()
        self._lines: set[int] = set()

    def unit(self) -> Unit:
        code = self._code()
        return Unit(
            self._scope.program,
            self._scope.procedure,
            code,
            tuple(self._sites.nodes),
            tuple(self._headers),
            frozenset(self._calls),
            frozenset(self._lines),
        )

    # --- the function

    def _code(self) -> CodeType:
        procedure = self._scope.procedure
        site = 1 if procedure is None else self._sites.new(procedure)
        self._block(self._scope.body)
        body = [*self._beginning(site), *self._out]
        if procedure is None:
            names = [VARIABLE + name for name in self._stored]
            definition = function(
                site, "program", ["d", *names], [*body, give_back(site, call(site, "locals"))]
            )
        else:
            names = [VARIABLE + parameter.name for parameter in self._scope.parameters]
            definition = function(site, "procedure", ["d", *dict.fromkeys(names)], body)
        module = compile(ast.Module([definition], []), "<GoDonnie>", "exec")
        return next(code for code in module.co_consts if isinstance(code, CodeType))

    def _beginning(self, site: int) -> list[ast.stmt]:
        beginning: list[ast.stmt] = []
        if self._outlined:
            # Never runs: it only makes these names belong to the outermost function.
            names = sorted(self._outlined)
            beginning.append(
                when(site, constant(site, False), [assign(site, name, constant(site, 0)) for name in names])
            )
        parameters = {parameter.name for parameter in self._scope.parameters}
        for name in sorted(self._clashing):
            owner = EARLIER if name in self._stored else PARAMETER if name in parameters else 0
            beginning.append(assign(site, OWNER + name, constant(site, owner)))
        return beginning if self._hooked else [self._checkpoint(site), *beginning]

    # --- statements

    def _block(self, statements: tuple[Statement, ...]) -> None:
        for statement in statements:
            site = self._sites.new(statement)
            self._visit(site, statement)
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

    def _visit(self, site: int, statement: Statement) -> None:
        if self._hooked:
            self._out.append(self._hook(site, statement))

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
        if name in self._clashing:
            owner = load(site, OWNER + name)
            other = compare(site, owner, ("<>", constant(site, site)))
            self._out.append(when(site, other, [self._clash(declare.name)]))
        self._give(site, name, declare.value)
        if name in self._clashing:
            self._add(assign(site, OWNER + name, constant(site, site)))

    def _clash(self, name: Name) -> ast.stmt:
        """``if o_x: clash(o_x, ...)``: refuses, unless an earlier batch made the variable."""
        site = self._sites.new(name)
        owner = load(site, OWNER + name.name)
        typed = constant(site, self._scope.program.typed(name.span))
        return when(site, owner, [do(site, call(site, "clash", owner, typed))])

    def _assign(self, site: int, assignment: Assign) -> None:
        name = assignment.name.name
        if name not in self._known:
            checked_site = self._sites.new(assignment.name)
            self._add(do(checked_site, load(checked_site, VARIABLE + name)))
        self._give(site, name, assignment.value)

    def _give(self, site: int, name: str, value: Expression | None) -> None:
        code = constant(site, 0) if value is None else self._expressions.value(value)
        self._add(assign(site, VARIABLE + name, code))
        if name not in self._mortal:
            self._known.add(name)
        self._written.add(name)

    # --- blocks

    def _if(self, site: int, statement: If) -> None:
        test = self._expressions.test(statement.condition)
        self._add()
        before = frozenset(self._known)
        then = self._inner(statement.then)
        after_then, self._known = self._known, set(before)
        otherwise = self._inner(statement.otherwise or ())
        self._known &= after_then
        self._out.append(when(site, test, then or [_nothing(site)], otherwise))

    def _while(self, site: int, loop: While) -> None:
        outside = self._enter()
        test = self._expressions.test(loop.condition)
        prelude = self._expressions.take_prelude()
        body = [*self._inner(loop.body), *self._turn(loop)]
        if prelude:
            body = [*prelude, unless_break(site, test), *body]
            test = constant(site, True)
        self._leave(site, outside, [loop_while(site, test, body)])

    def _repeat(self, site: int, loop: Repeat) -> None:
        outside = self._enter()
        times = self._expressions.value(loop.times)
        prelude = self._expressions.take_prelude()
        body = [*self._inner(loop.body), *self._turn(loop)]
        self._leave(site, outside, [*prelude, loop_over(site, "r", call(site, "turns", times), body)])

    def _for(self, site: int, loop: For) -> None:
        name = loop.start.name.name
        if isinstance(loop.start, Declare):
            if name in self._clashing:
                self._out.append(self._clash(loop.start.name))
            self._give(site, name, loop.start.value)
            if name in self._clashing:
                self._out.append(assign(site, OWNER + name, constant(site, site)))
        else:
            self._assign(site, loop.start)
        first = self._sites.next
        self._loop_of_for(loop)
        if isinstance(loop.start, Declare):
            self._headers.append(Header(name, first, self._sites.next - 1))
            self._known.discard(name)
            self._out.append(forget(site, VARIABLE + name))
            if name in self._clashing:
                self._out.append(assign(site, OWNER + name, constant(site, 0)))

    def _loop_of_for(self, loop: For) -> None:
        outside = self._enter()
        turn_site = self._sites.new(loop)
        inside = self._inner(loop.body)
        turn = self._turn(loop, turn_site)
        if counts(loop, self._written, self._expressions):
            counting = turns_of(loop, turn_site, self._expressions)
            statements = [loop_over(turn_site, VARIABLE + loop.step.name.name, counting, [*inside, *turn])]
        else:
            statements = self._general_loop(turn_site, loop, [*inside, *turn])
        self._leave(turn_site, outside, statements)

    def _general_loop(self, site: int, loop: For, body: list[ast.stmt]) -> list[ast.stmt]:
        known = set(self._known)
        outside, self._out = self._out, body
        self._assign(self._sites.new(loop.step), loop.step)
        self._out = outside
        self._known = known
        test = self._expressions.test(loop.condition)
        prelude = self._expressions.take_prelude()
        if prelude:
            return [loop_while(site, constant(site, True), [*prelude, unless_break(site, test), *body])]
        return [loop_while(site, test, body)]

    def _enter(self) -> tuple[set[str], set[str], int]:
        """Begin a loop: what its body declares may never be declared."""
        outside = self._known, self._written, self._loops
        self._known, self._written = set(self._known), set()
        self._loops = 1 if self._loops == _MOST_LOOPS else self._loops + 1
        return outside

    def _leave(self, site: int, outside: tuple[set[str], set[str], int], loop: list[ast.stmt]) -> None:
        """End a loop; one that is nested too deep for Python becomes a function."""
        known, written, loops = outside
        self._known, self._written, self._loops = known, written | self._written, loops
        if loops == _MOST_LOOPS:
            names = sorted(_stored_names(loop))
            self._outlined |= set(names)
            declared = [outer(site, names)] if names else []
            loop = [function(site, "loop", (), [*declared, *loop]), self._called(site, "loop")]
        self._out += loop

    def _turn(self, loop: Statement, site: int | None = None) -> list[ast.stmt]:
        """The end of a turn: look whether anything is wanted."""
        site = site or self._sites.new(loop)
        return [self._hook(site, loop)] if self._hooked else [self._checkpoint(site)]

    def _hook(self, site: int, statement: Statement) -> ast.stmt:
        """``if w_line is not None and depth <= w_line and hook(line, column, depth): (end)``."""
        self._lines.add(statement.span.line)
        name = f"{WANTED}{statement.span.line}"
        line, column = constant(site, statement.span.line), constant(site, statement.span.column)
        is_wanted = compare(site, load(site, name), ("is not", constant(site, None)))
        if self._scope.procedure is None:
            is_near, depth = [], constant(site, 0)
        else:
            depth = element(site, "d", 0)
            is_near = [compare(site, depth, ("<=", load(site, name)))]
        test = both(site, is_wanted, *is_near, call(site, "hook", line, column, depth))
        return when(site, test, [self._end(site)])

    def _checkpoint(self, site: int) -> ast.stmt:
        """``if flag and check(): (end)``."""
        return when(site, both(site, load(site, "flag"), call(site, "check")), [self._end(site)])

    def _called(self, site: int, name: str, *arguments: ast.expr) -> ast.stmt:
        """``if name(...) is not None: (end)``."""
        ended = compare(site, call(site, name, *arguments), ("is not", constant(site, None)))
        return when(site, ended, [self._end(site)])

    def _end(self, site: int) -> ast.stmt:
        if self._scope.procedure is None:
            return do(site, call(site, "stop"))
        return give_back(site, constant(site, True))

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
        self._add(self._called(site, f"p_{name}_{len(arguments)}", deeper, *values))

    def _command(self, site: int, statement: Statement) -> None:
        action = command(site, statement, self._expressions, self._scope.program, terminal=self._terminal)
        self._add(do(site, action), self._checkpoint(site))


def _nothing(site: int) -> ast.stmt:
    return do(site, constant(site, None))


def _clashing(scope: Scope, stored: frozenset[str]) -> frozenset[str]:
    """The names that are declared at two places, or both here and by an earlier batch."""
    return frozenset(name for name, times in scope.declarations().items() if times > 1 or name in stored)


def _stored_names(statements: list[ast.stmt]) -> set[str]:
    """The variables that some statements assign or delete, those of functions inside them too."""
    return {
        node.id
        for statement in statements
        for node in ast.walk(statement)
        if isinstance(node, ast.Name)
        and not isinstance(node.ctx, ast.Load)
        and node.id.startswith((VARIABLE, OWNER))
    }
