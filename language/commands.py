"""Commands as calls of the actions: which one, and with what."""

from __future__ import annotations

from devices.ports.hints import TYPE_CHECKING
from language.expressions import Expressions
from language.syntax import (
    BeltSwitch,
    Direction,
    Help,
    History,
    Program,
    Quit,
    RunTyped,
    Scan,
    Side,
    Sound,
    Speak,
    State,
    Statement,
    TellPosition,
    Text,
    Turn,
    Vibrate,
    Wait,
    Walk,
)
from language.translated import call, constant, load

if TYPE_CHECKING:
    import ast


def command(
    site: int, statement: Statement, expressions: Expressions, program: Program, *, terminal: bool
) -> ast.expr:
    """The call that does a command."""
    value = expressions.value
    match statement:
        case Speak(what=what):
            return call(site, "speak", constant(site, what.text) if isinstance(what, Text) else value(what))
        case Walk(direction=direction, steps=steps):
            action = "forward" if direction is Direction.FORWARD else "backward"
            return call(site, action, value(steps), _typed(site, statement, program))
        case Turn(side=side, degrees=degrees):
            action = "turn_right" if side is Side.RIGHT else "turn_left"
            return call(site, action, value(degrees), _typed(site, statement, program))
        case Wait(seconds=seconds):
            return call(site, "wait", value(seconds))
        case Sound(on=on):
            return call(site, "sound", constant(site, on))
        case BeltSwitch(on=on):
            return call(site, "belt", constant(site, on))
        case Vibrate(bearing=bearing):
            return call(site, "vibrate", load(site, bearing.name))
        case Help(topic=topic):
            return call(site, "help", constant(site, topic))
        case Scan():
            return call(site, "scan")
        case State():
            return call(site, "state")
        case History():
            return call(site, "history")
        case TellPosition():
            return call(site, "tell_position")
        case Quit() | RunTyped() if not terminal:
            return call(site, "refuse_outside_terminal", _typed(site, statement, program))
        case Quit():
            return call(site, "leave")
        case RunTyped():
            return call(site, "go_on")
        case _:
            raise AssertionError(statement)


def _typed(site: int, statement: Statement, program: Program) -> ast.expr:
    return constant(site, program.typed(statement.span))
