"""A program that is stepped through, in words: the statement that is next, rounds of loops, conditions.

Made anew for each run. It is told of what is read and of each statement before which the program holds; what
a condition found is computed again from the variables and from what the sensors said in between.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from devices.ports.values import Mutable
from donnie_tui.core.events import Read
from donnie_tui.core.wording import Wording
from language.diagnostics import LanguageError
from language.numbers import divide
from language.runtime import Frame
from language.source import fold_name
from language.syntax import (
    Binary,
    Condition,
    Expression,
    For,
    If,
    Name,
    Negative,
    Number,
    Program,
    Repeat,
    Statement,
    While,
    blocks_of,
)

_COMPARISONS = {
    "==": "equal",
    "<>": "different",
    "<": "less",
    ">": "greater",
    "<=": "less-or-equal",
    ">=": "greater-or-equal",
}


class _Round(Mutable):
    """A loop that the program is in."""

    loop: Statement
    calls: int
    count: int | None
    """None where nobody saw it begin."""
    total: int | None = None
    has_gone_round: bool = False

    def go_round(self) -> None:
        self.has_gone_round = True
        if self.count is not None:
            self.count += 1


class StepWords:
    """Tells one run, hold by hold."""

    def __init__(
        self, program: Program | None, lines: Sequence[str], wording: Wording, *, is_first: bool = True
    ) -> None:
        """``lines`` are those of the whole program, for what earlier batches declared.

        ``is_first``: the statement before which it holds first was never reached before, as the first one of
        all or one with a breakpoint; where somebody pauses that is not known.
        """
        self._program = program
        self._lines = lines
        self._say = wording
        self._found = dict(_by_place(program.body if program else (), 0))
        self._reads: list[int] = []
        self._rounds: list[_Round] = []
        self._before: Statement | None = None
        self._variables: Mapping[str, int] = {}
        """Those that could be seen there."""
        self._is_first = is_first
        self._level = self._calls = 0

    def heard(self, event: Read) -> None:
        """A sensor said something."""
        self._reads.append(event.value)

    def lose_count(self) -> None:
        """Statements go by without a hold: rounds are not known any more."""
        self._rounds.clear()
        self._before, self._is_first = None, False

    def held(self, line: int, column: int, frames: Sequence[Frame]) -> tuple[str, ...]:
        """The program holds before that statement: what came out of the last one, and what is next."""
        statement, level = self._found.get((line, column), (None, 0))
        variables = {fold_name(name): value for name, value in frames[0].variables} if frames else {}
        told = [*self._condition()]
        told += self._round(statement, len(frames), variables)
        told.append(self._next(statement, line, level))
        self._before, self._variables = statement, variables
        self._level, self._calls = level, len(frames)
        self._reads.clear()
        return tuple(told)

    def ended(self) -> tuple[str, ...]:
        """The program is over behind the statement before which it was held last: what came out of that."""
        return tuple(self._condition())

    # --- the statement that is next

    def _next(self, statement: Statement | None, line: int, level: int) -> str:
        text = self._text(statement, line)
        detail = self._say.detail
        with_level = statement is not None and (
            detail == "full" or (detail == "normal" and level != self._level)
        )
        return self._say("line-level" if with_level else "answer-line", line=line, level=level, text=text)

    def _text(self, statement: Statement | None, line: int) -> str:
        """The statement as typed, of a block its first words."""
        if statement is None or self._program is None:
            return self._lines[line - 1].strip() if 0 < line <= len(self._lines) else ""
        inside = next((block[0] for block in blocks_of(statement) if block), None)
        end = statement.span.end if inside is None else inside.span.start
        return " ".join(self._program.source[statement.span.start : end].split())

    # --- rounds

    def _round(self, statement: Statement | None, calls: int, variables: Mapping[str, int]) -> Iterator[str]:
        while self._rounds and not self._is_in(self._rounds[-1], statement, calls):
            self._rounds.pop()
        current = self._rounds[-1] if self._rounds else None
        if current is not None and statement is current.loop and calls == current.calls:
            current.go_round()
        elif isinstance(statement, Repeat | While | For):
            self._rounds.append(_Round(statement, calls, 1 if self._begins(statement, calls) else None))
        elif current is not None and self._before is current.loop:
            yield from self._round_in_words(current, variables)

    def _begins(self, loop: Statement, calls: int) -> bool:
        """Whether the loop begins here: what was before it was outside of it. Else it may be any round."""
        if self._before is None:
            return self._is_first
        was_inside = loop.span.start <= self._before.span.start < loop.span.end
        return calls != self._calls or not was_inside

    def _is_in(self, current: _Round, statement: Statement | None, calls: int) -> bool:
        if calls != current.calls or statement is None:
            return calls > current.calls
        return current.loop.span.start <= statement.span.start < current.loop.span.end

    def _round_in_words(self, current: _Round, variables: Mapping[str, int]) -> Iterator[str]:
        """Where the number is not known, only that it is another round."""
        if current.count is None:
            yield from (self._say("step-round-next"),) if current.has_gone_round else ()
            return
        if isinstance(current.loop, Repeat) and current.count == 1:
            current.total = self._value(current.loop.times, variables, iter(self._reads))
        code = "step-round" if current.total is None else "step-round-of"
        yield self._say(code, round=current.count, rounds=current.total)

    # --- conditions

    def _condition(self) -> Iterator[str]:
        """Told with the values of where it was asked: what is next may be behind the end of a procedure."""
        if isinstance(self._before, If | While | For):
            condition, reads = self._before.condition, iter(self._reads)
            variables = self._variables
            if isinstance(self._before, For):
                variables = {**variables, **dict(self._counted(self._before, reads))}
            left = self._value(condition.left, variables, reads)
            right = self._value(condition.right, variables, reads)
            if left is not None and right is not None:
                yield self._condition_in_words(condition, left, right)

    def _counted(self, loop: For, reads: Iterator[int]) -> Iterator[tuple[str, int]]:
        """What its variable became before the condition was asked; where nobody saw it begin, nothing."""
        current = self._rounds[-1]
        if current.count is None and not current.has_gone_round:
            return
        made = loop.step if current.has_gone_round else loop.start
        value = None if made.value is None else self._value(made.value, self._variables, reads)
        if value is not None:
            yield fold_name(made.name.name), value

    def _condition_in_words(self, condition: Condition, left: int, right: int) -> str:
        """What is: "3 greater than 2", whatever was asked."""
        is_true = {
            "==": left == right,
            "<>": left != right,
            "<": left < right,
            ">": left > right,
            "<=": left <= right,
            ">=": left >= right,
        }[condition.comparator]
        relation = "equal" if left == right else "less" if left < right else "greater"
        told = _COMPARISONS[condition.comparator] if is_true else relation
        how = self._say(f"comparison-{told}", left=left, right=right)
        return self._say("step-true" if is_true else "step-false", how=how)

    def _value(
        self, expression: Expression, variables: Mapping[str, int], reads: Iterator[int]
    ) -> int | None:
        """What an expression was just now; None where that can't be known."""
        match expression:
            case Number(value=value):
                return value
            case Name():
                return variables.get(fold_name(expression.name))
            case Negative(operand=operand):
                negated = self._value(operand, variables, reads)
                return None if negated is None else -negated
            case Binary(operator=operator):
                left = self._value(expression.left, variables, reads)
                right = self._value(expression.right, variables, reads)
                return None if left is None or right is None else _computed(operator, left, right)
            case _:
                return next(reads, None)


def _computed(operator: str, left: int, right: int) -> int | None:
    try:
        match operator:
            case "+":
                return left + right
            case "-":
                return left - right
            case "*":
                return left * right
            case _:
                return divide(left, right)
    except (LanguageError, ZeroDivisionError):
        return None


def _by_place(
    statements: tuple[Statement, ...], level: int
) -> Iterator[tuple[tuple[int, int], tuple[Statement, int]]]:
    for statement in statements:
        yield (statement.span.line, statement.span.column), (statement, level)
        for block in blocks_of(statement):
            yield from _by_place(block, level + 1)


def changes(
    watched: Sequence[str], before: Mapping[str, int], now: Mapping[str, int], wording: Wording
) -> Iterator[str]:
    """What the watched variables are now, where that is something else than before, by folded name."""
    for name in watched:
        value = now.get(fold_name(name))
        if value is not None and value != before.get(fold_name(name)):
            yield wording("variable-is", name=name, value=value)
