"""Statements of GoDonnie as statements of Python: one function for each scope.

A variable is a local variable of the function, ``v_`` and its name: Python itself raises an error if it does
not exist. ``o_`` and a name is the site of the declaration that made the variable, kept only if the name
could be declared twice. ``p_``, a name and a number of arguments is a procedure, a global.
``d`` is the link of the open calls (``call_stack``).
"""

from __future__ import annotations

from types import CodeType

from language import python_code as py
from language import syntax
from language.expressions import Expressions, ValueBounds
from language.loops import Checkpoints, LoopNesting, is_counting, range_of
from language.syntax import Expression, Name, Scope, Statement


class ScopeCompiler:
    """Compiles one scope. Used once."""

    def __init__(
        self,
        scope: Scope,
        bounds: ValueBounds,
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
        self._sites = py.Sites()
        self._expressions = Expressions(self._sites, bounds)
        self._declarations = _Declarations(scope, self._sites, stored)
        in_procedure = scope.procedure is not None
        self._checkpoints = Checkpoints(in_procedure=in_procedure, hooked=hooked)
        self._nesting = LoopNesting(self._checkpoints)
        self._out: list[py.Stmt] = []
        self._headers: list[py.ForHeader] = []
        self._calls: set[tuple[str, int]] = set()

    def unit(self) -> py.Unit:
        code = self._code()
        return py.Unit(
            self._scope.program,
            self._scope.procedure,
            code,
            tuple(self._sites.nodes),
            tuple(self._headers),
            frozenset(self._calls),
            frozenset(self._checkpoints.lines),
        )

    def _code(self) -> CodeType:
        procedure = self._scope.procedure
        site = 1 if procedure is None else self._sites.new(procedure)
        self._block(self._scope.body)
        body = [
            *self._checkpoints.at_beginning(site),
            *self._nesting.at_beginning(site),
            *self._declarations.at_beginning(site),
            *self._out,
        ]
        if procedure is None:
            names = [py.VARIABLE + name for name in sorted(self._stored)]
            body.append(py.return_(site, py.call(site, "locals")))
            definition = py.function(site, "program", ["d", *names], body)
        else:
            names = [py.VARIABLE + parameter.name for parameter in self._scope.parameters]
            definition = py.function(site, "procedure", ["d", *dict.fromkeys(names)], body)
        return py.compiled(definition)

    # --- statements

    def _block(self, statements: tuple[Statement, ...]) -> None:
        for statement in statements:
            site = self._sites.new(statement)
            self._out += self._checkpoints.before(site, statement)
            self._statement(site, statement)

    def _inner(self, statements: tuple[Statement, ...]) -> list[py.Stmt]:
        """A block inside a statement."""
        outside, self._out = self._out, []
        self._block(statements)
        inside, self._out = self._out, outside
        return inside

    def _add(self, *statements: py.Stmt) -> None:
        self._out += self._expressions.take_prelude()
        self._out += statements

    def _statement(self, site: int, statement: Statement) -> None:
        match statement:
            case syntax.Declare():
                self._declare(site, statement)
            case syntax.Assign():
                self._assign(site, statement)
            case syntax.If():
                self._if(site, statement)
            case syntax.While():
                self._while(site, statement)
            case syntax.Repeat():
                self._repeat(site, statement)
            case syntax.For():
                self._for(site, statement)
            case syntax.Procedure():
                self._procedure(statement)
            case syntax.Call():
                self._call(site, statement)
            case syntax.UnusedSensor():
                pass
            case _:
                action, *arguments = self._action(site, statement)
                call = py.call(site, action, *arguments)
                self._add(py.evaluate(site, call), self._checkpoints.checkpoint(site))

    # --- variables

    def _declare(self, site: int, declare: syntax.Declare) -> None:
        name = declare.name.name
        self._out += self._declarations.refuse_other(site, declare.name)
        self._give(site, name, declare.value)
        self._out += self._declarations.keep_owner(site, name, site)

    def _assign(self, site: int, assignment: syntax.Assign) -> None:
        self._out += self._declarations.existence_check(assignment.name)
        self._give(site, assignment.name.name, assignment.value)

    def _give(self, site: int, name: str, value: Expression | None) -> None:
        code = py.constant(site, 0) if value is None else self._expressions.value(value)
        self._add(py.assign(site, py.VARIABLE + name, code))
        self._declarations.add(name)

    # --- blocks

    def _if(self, site: int, statement: syntax.If) -> None:
        test = self._expressions.test(statement.condition)
        self._add()
        declarations, before = self._declarations, set(self._declarations.known)
        then = self._inner(statement.then)
        after_then, declarations.known = declarations.known, before
        otherwise = self._inner(statement.otherwise or ())
        declarations.known &= after_then
        then = then or [py.evaluate(site, py.constant(site, None))]
        self._out.append(py.if_(site, test, then, otherwise))

    def _while(self, site: int, loop: syntax.While) -> None:
        self._enter()
        test = self._expressions.test(loop.condition)
        prelude = self._expressions.take_prelude()
        body = self._iteration(loop)
        self._leave(site, [_loop_while(site, prelude, test, body)])

    def _repeat(self, site: int, loop: syntax.Repeat) -> None:
        self._enter()
        times = self._expressions.value(loop.times)
        prelude = self._expressions.take_prelude()
        body = self._iteration(loop)
        self._leave(site, [*prelude, py.for_(site, "r", py.call(site, "iterations", times), body)])

    def _iteration(self, loop: syntax.While | syntax.Repeat) -> list[py.Stmt]:
        inside = self._inner(loop.body)
        return [*inside, *self._checkpoints.after_iteration(self._sites.new(loop), loop)]

    def _for(self, site: int, loop: syntax.For) -> None:
        if isinstance(loop.start, syntax.Assign):
            self._assign(site, loop.start)
            self._loop_of_for(loop)
            return
        name, declarations = loop.start.name.name, self._declarations
        self._out += declarations.refuse_any(loop.start.name)
        self._give(site, name, loop.start.value)
        self._out += declarations.keep_owner(site, name, site)
        first = self._sites.next
        self._loop_of_for(loop)
        # Python joins the instruction that stores the variable with the one that loads the first name of the
        # condition, and takes the place of the first for both: a mistake there counts as one in the loop.
        self._headers += [py.ForHeader(name, site, site), py.ForHeader(name, first, self._sites.next - 1)]
        declarations.remove(name)
        self._out += [py.delete(site, py.VARIABLE + name), *declarations.keep_owner(site, name, 0)]

    def _loop_of_for(self, loop: syntax.For) -> None:
        self._enter()
        site = self._sites.new(loop)
        body = [*self._inner(loop.body), *self._checkpoints.after_iteration(site, loop)]
        if is_counting(loop, self._declarations.written, self._expressions):
            counting = range_of(loop, site, self._expressions)
            statement = py.for_(site, py.VARIABLE + loop.step.name.name, counting, body)
        else:
            statement = self._general_loop(site, loop, body)
        self._leave(site, [statement])

    def _general_loop(self, site: int, loop: syntax.For, body: list[py.Stmt]) -> py.Stmt:
        outside, self._out = self._out, body
        self._assign(self._sites.new(loop.step), loop.step)
        self._out = outside
        test = self._expressions.test(loop.condition)
        return _loop_while(site, self._expressions.take_prelude(), test, body)

    def _enter(self) -> None:
        """Begin a loop."""
        self._declarations.enter()
        self._nesting.enter()

    def _leave(self, site: int, loop: list[py.Stmt]) -> None:
        """End a loop."""
        self._declarations.leave()
        self._out += self._nesting.leave(site, loop)

    # --- procedures

    def _procedure(self, procedure: syntax.Procedure) -> None:
        site = self._sites.new(procedure.name)
        number = py.constant(site, self._numbers[id(procedure)])
        self._add(py.evaluate(site, py.call(site, "may_declare", number)))
        seen: set[str] = set()
        for parameter in procedure.parameters:
            if parameter.name in seen:
                place = self._sites.new(parameter)
                typed = py.constant(place, self._scope.program.typed(parameter.span))
                clash = py.call(place, "clash", py.constant(place, py.PARAMETER), typed)
                self._add(py.evaluate(place, clash))
                return
            seen.add(parameter.name)
        self._add(py.evaluate(site, py.call(site, "declare", number)))

    def _call(self, site: int, statement: syntax.Call) -> None:
        name, arguments = statement.name.name, statement.arguments
        self._calls.add((name, len(arguments)))
        values = self._expressions.values(arguments)
        deeper = py.subscript(site, "d", 1)
        procedure = py.procedure_taking(name, len(arguments))
        self._add(self._checkpoints.called(site, procedure, deeper, *values))

    # --- commands

    def _action(self, site: int, command: syntax.Command) -> tuple[str, *tuple[py.Expr, ...]]:
        """The name of the action for a command, and its arguments."""
        value, typed = self._expressions.value, self._scope.program.typed
        match command:
            case syntax.SpeakCommand(what=what):
                code = py.constant(site, what.text) if isinstance(what, syntax.TextLiteral) else value(what)
                return "speak", code
            case syntax.WalkCommand(direction=direction, steps=steps):
                action = "forward" if direction is syntax.Direction.FORWARD else "backward"
                return action, value(steps), py.constant(site, typed(command.span))
            case syntax.TurnCommand(side=side, degrees=degrees):
                action = "turn_right" if side is syntax.Side.RIGHT else "turn_left"
                return action, value(degrees), py.constant(site, typed(command.span))
            case syntax.WaitCommand(seconds=seconds):
                return "wait", value(seconds)
            case syntax.SoundCommand(on=on):
                return "sound", py.constant(site, on)
            case syntax.BeltCommand(on=on):
                return "belt", py.constant(site, on)
            case syntax.VibrateCommand(bearing=bearing):
                return "vibrate", py.load(site, bearing.name)
            case syntax.HelpCommand(topic=topic):
                return "help", py.constant(site, topic)
            case syntax.ActionCommand(action=action):
                return (action,)
            case syntax.QuitCommand() | syntax.RunCommand() if not self._terminal:
                return "refuse_outside_terminal", py.constant(site, typed(command.span))
            case syntax.QuitCommand():
                return ("quit",)
            case syntax.RunCommand():  # the commands of a terminal are running already
                return ("do_nothing",)


def _loop_while(site: int, prelude: list[py.Stmt], test: py.Expr, body: list[py.Stmt]) -> py.Stmt:
    """A loop with a test that may need statements before it in each iteration."""
    if prelude:
        return py.while_(site, py.constant(site, True), [*prelude, py.break_unless(site, test), *body])
    return py.while_(site, test, body)


class _Declarations:
    """The variables of one scope, at the place that is being compiled."""

    def __init__(self, scope: Scope, sites: py.Sites, stored: frozenset[str]) -> None:
        """``stored``: the names that exist before it begins."""
        self._scope = scope
        self._sites = sites
        self._stored = stored
        self._parameters = {parameter.name for parameter in scope.parameters}
        declared = scope.declarations()
        self._clashing = {name for name, times in declared.items() if times > 1 or name in stored}
        """The names that are declared at two places, or both here and by an earlier batch."""
        self._mortal = {
            each.start.name.name
            for each in scope.statements()
            if isinstance(each, syntax.For)
            and isinstance(each.start, syntax.Declare)
            and each.start.name.name in stored
        }
        """Stored names that a FOR removes at its end, because it declares them again."""
        self.known = {*stored, *self._parameters} - self._mortal
        """The variables that surely exist here."""
        self.written: set[str] = set()
        """The variables declared or assigned in the innermost open loop, or in the scope if none is open."""
        self._outside: list[tuple[set[str], set[str]]] = []
        """The same two sets of the code around each open loop."""

    # --- code

    def at_beginning(self, site: int) -> list[py.Stmt]:
        """Code for the beginning of the scope: which declaration made each variable, if that is needed."""
        return [
            py.assign(site, py.OWNER + name, py.constant(site, self._owner_before(name)))
            for name in sorted(self._clashing)
        ]

    def _owner_before(self, name: str) -> int:
        if name in self._stored:
            return py.EARLIER
        return py.PARAMETER if name in self._parameters else 0

    def refuse_other(self, site: int, name: Name) -> list[py.Stmt]:
        """Code before the VAR at this site, which may run again: refuses if another one made the variable."""
        if name.name not in self._clashing:
            return []
        is_other = py.compare(site, py.load(site, py.OWNER + name.name), ("<>", py.constant(site, site)))
        return [py.if_(site, is_other, self.refuse_any(name))]

    def refuse_any(self, name: Name) -> list[py.Stmt]:
        """``if o_x: clash(o_x, ...)``: refuses, unless an earlier batch made the variable."""
        if name.name not in self._clashing:
            return []
        site = self._sites.new(name)
        owner = py.load(site, py.OWNER + name.name)
        typed = py.constant(site, self._scope.program.typed(name.span))
        return [py.if_(site, owner, [py.evaluate(site, py.call(site, "clash", owner, typed))])]

    def keep_owner(self, site: int, name: str, owner: int) -> list[py.Stmt]:
        """``o_x = owner``, if the code needs it."""
        return [py.assign(site, py.OWNER + name, py.constant(site, owner))] if name in self._clashing else []

    def existence_check(self, name: Name) -> list[py.Stmt]:
        """Code before an assignment: Python raises ``NameError`` if the variable does not exist."""
        if name.name in self.known:
            return []
        site = self._sites.new(name)
        return [py.evaluate(site, py.load(site, py.VARIABLE + name.name))]

    # --- what is known here

    def add(self, name: str) -> None:
        """A variable was declared or assigned."""
        if name not in self._mortal:
            self.known.add(name)
        self.written.add(name)

    def remove(self, name: str) -> None:
        self.known.discard(name)

    def enter(self) -> None:
        """Begin a loop. Its body may never run, so its declarations may not either."""
        self._outside.append((self.known, self.written))
        self.known, self.written = set(self.known), set()

    def leave(self) -> None:
        """End a loop."""
        self.known, written = self._outside.pop()
        self.written |= written
