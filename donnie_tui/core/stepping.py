"""Describes a program that is stepped through: what each step did, what is next, and the way back.

``Stepping`` keeps the holds of one run, each with its sentences and its variables. ``StepNarrator`` makes the
sentences of a hold: the statement that is next, the round of a loop, the result of a condition. It computes a
condition again, from the variables and from the sensor readings since the last hold.

If the program ran on between two holds, STEP BACK undoes event by event, with the sentences of ``timeline``.
Memory is bounded: the newest holds are kept, and only the first events of a long step are listed.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from operator import add, eq, ge, gt, le, lt, mul, ne, sub

from msgspec import Struct

from donnie_tui.core.events import Read
from donnie_tui.core.timeline import Timeline, redone_in_words, undone_in_words
from donnie_tui.core.transcript import printed_lines
from donnie_tui.core.wording import Wording
from language.diagnostics import LanguageError
from language.numbers import divide
from language.runtime import Frame
from language.source import fold_name
from language.syntax import (
    Assign,
    Binary,
    Call,
    Condition,
    Declare,
    Expression,
    For,
    If,
    Name,
    Negative,
    NumberLiteral,
    Program,
    Repeat,
    SpeakCommand,
    Statement,
    TextLiteral,
    TurnCommand,
    WaitCommand,
    WalkCommand,
    While,
    blocks_of,
)

MOST_HOLDS = 1000
MOST_CALLS = 20
"""Open calls that are remembered of a hold, the innermost ones."""
MOST_READS = 1000
"""Readings between two holds that are remembered: no statement has so many."""
MOST_UNDONE = 5
"""Events that are listed when one step is undone: a procedure that was stepped over has many."""
MOST_OPERATIONS = 5
"""Operations of an expression that are shown one by one; of a longer one the result is shown after these."""
LARGEST_SHOWN = 10**15
"""Larger results are not worked out: they are too long to read."""


class _Hold(Struct, frozen=True):
    """The program was held before a statement."""

    seq: int
    """The number of the last event before it."""
    sentences: tuple[str, ...]
    frames: tuple[Frame, ...]
    """The open calls, innermost first; the program itself is one."""
    is_next: bool
    """Whether one step led here from the hold before it."""
    worked_out: tuple[tuple[str, ...], ...] = ()
    """The results of ``worked_out`` for the statement's expressions."""

    @property
    def variables(self) -> Mapping[str, int]:
        return dict(self.frames[0].variables)


class Stepping:
    """The holds of one run."""

    def __init__(
        self,
        program: Program | None,
        lines: Sequence[str],
        wording: Wording,
        *,
        last_seq: Callable[[], int],
        is_first: bool,
    ) -> None:
        """``lines`` are those of the whole program, of which ``program`` may be a part.

        ``last_seq`` gives the number of the last event. ``is_first``: the first hold is before a statement
        that did not run before, as at a breakpoint; after a pause that is not known.
        """
        self._words = wording
        self._last_seq = last_seq
        self._narrator = StepNarrator(program, lines, wording, is_first=is_first)
        self._holds: deque[_Hold] = deque(maxlen=MOST_HOLDS)
        self._ran_on = True
        """More than one step led here from the hold before; there is none before the first one."""
        self._at: int | None = None
        """The hold to which STEP BACK has come; None is the present."""

    def on_read(self, event: Read) -> None:
        """A sensor was read, in the program's thread."""
        self._narrator.on_read(event)

    def on_end(self) -> tuple[str, ...]:
        """The sentences about the last statement, once the program has come to its end."""
        return self._narrator.on_end()

    def on_hold(self, place: tuple[int, int], frames: Sequence[Frame]) -> tuple[str, ...]:
        """The sentences of a hold before the statement at that line and column.

        They have the result of the last statement, and what is next. There are none at line 0, where the
        program is held within a statement.
        """
        if not place[0]:
            return ()
        sentences = self._narrator.on_hold(*place, frames)
        calls = tuple(frames[:MOST_CALLS])
        hold = _Hold(self._last_seq(), sentences, calls, not self._ran_on, self._narrator.worked_out)
        self._holds.append(hold)
        self._ran_on, self._at = False, None
        return sentences

    def run_on(self) -> None:
        """Notes that the program runs more than one step from here."""
        self._narrator.lose_count()
        self._ran_on = True

    def step_back(
        self, timeline: Timeline, now: Mapping[str, int], *, is_first_step: bool
    ) -> tuple[str, ...]:
        """The sentences for what one step back undoes. ``timeline`` is moved back by it.

        ``now`` are the variables of the present. ``is_first_step``: no step back was made since something
        happened.
        """
        if is_first_step or self._at is None:
            is_held = bool(self._holds) and self._holds[-1].seq >= _seq(timeline)
            self._at = len(self._holds) - 1 if is_held else len(self._holds)
        if self._at <= 0:
            return (undo_event(timeline, self._words),)
        before = self._holds[self._at - 1]
        was_stepped = self._holds[self._at].is_next if self._at < len(self._holds) else not self._ran_on
        undone = self._undo(before.seq, timeline, most=None if was_stepped else 1)
        if _seq(timeline) > before.seq:
            return undone
        later = self._holds[self._at].variables if self._at < len(self._holds) else now
        self._at -= 1
        return (*undone, *self._changed_back(before.variables, later), *before.sentences)

    def step_forward(self, timeline: Timeline) -> tuple[str, ...]:
        """The sentences for one step back towards the present. ``timeline`` is moved forward by it."""
        assert self._at is not None  # a step back comes first
        at = self._at if self._hold_at(timeline) is None else self._at + 1
        if at >= len(self._holds):
            self._at = len(self._holds)
            return redo_event(timeline, self._words)
        hold, redone = self._holds[at], list[str]()
        while _seq(timeline) < hold.seq and (hold.is_next or not redone):
            redone += redo_event(timeline, self._words)
        self._at = at
        redone = self._shortened(redone, "redone-more")
        return (*redone, *(hold.sentences if _seq(timeline) >= hold.seq else ()))

    def is_present(self, timeline: Timeline) -> bool:
        """Whether steps forward have come to the last hold, or to the last event."""
        assert self._at is not None  # a step forward comes first
        return self._at >= len(self._holds) - 1 and timeline.at == len(timeline)

    def counted(self, timeline: Timeline) -> tuple[int, int]:
        """How many steps are before that position, and how many there are. A hold without an event is one."""
        step, steps = timeline.steps
        quiet = [before.seq == hold.seq for before, hold in pairwise(self._holds)]
        return step + sum(quiet[: self._at]), steps + sum(quiet)

    def frames_at(self, timeline: Timeline) -> tuple[Frame, ...] | None:
        """The open calls at that position; None between two holds, where they are not known."""
        hold = self._hold_at(timeline)
        return None if hold is None else hold.frames

    def worked_out(self, past: Timeline | None) -> tuple[tuple[str, ...], ...]:
        """The expressions of the statement that is next, now or at that position."""
        hold = self._hold_at(past) if past is not None else self._holds[-1] if self._holds else None
        return () if hold is None else hold.worked_out

    def _hold_at(self, timeline: Timeline) -> _Hold | None:
        """The hold to which STEP BACK has come, if it is at that position."""
        if self._at is None or self._at == len(self._holds):
            return None
        hold = self._holds[self._at]
        return hold if hold.seq == _seq(timeline) else None

    def _undo(self, seq: int, timeline: Timeline, *, most: int | None) -> tuple[str, ...]:
        """Undoes all events after ``seq``, or ``most`` steps of them; a sentence each."""
        undone: list[str] = []
        while _seq(timeline) > seq and (most is None or len(undone) < most):
            undone.append(undo_event(timeline, self._words))
        return tuple(self._shortened(undone, "undone-more")) or (self._words("undone-step"),)

    def _shortened(self, lines: list[str], code: str) -> list[str]:
        """The first ones, and how many more there are."""
        more = len(lines) - MOST_UNDONE
        return lines if more <= 0 else [*lines[:MOST_UNDONE], self._words(code, count=more)]

    def _changed_back(self, then: Mapping[str, int], later: Mapping[str, int]) -> tuple[str, ...]:
        """The old values of what the step changed, and the variables that it made."""
        values, known = {fold_name(name): value for name, value in later.items()}, set(map(fold_name, then))
        again = tuple(
            self._words("variable-is", name=name, value=value)
            for name, value in then.items()
            if values.get(fold_name(name), value) != value
        )
        made = (name for name in later if fold_name(name) not in known)
        return again + tuple(self._words("variable-not-yet", name=name) for name in made)


def undo_event(timeline: Timeline, wording: Wording) -> str:
    """Moves the timeline back by one step of its events; the sentence for it."""
    return undone_in_words(timeline.step_back(), timeline, wording)


def redo_event(timeline: Timeline, wording: Wording) -> tuple[str, ...]:
    """Moves the timeline forward by one step of its events; the lines that were printed for it."""
    step = timeline.step()
    printed = tuple(line for each in step for line in printed_lines(each, wording))
    return printed or tuple(filter(None, (redone_in_words(step, wording),)))


def _seq(timeline: Timeline) -> int:
    return timeline.now.seq if timeline.now is not None else 0


_COMPARISONS: Mapping[str, tuple[str, Callable[[int, int], bool]]] = {
    "==": ("equal", eq),
    "<>": ("different", ne),
    "<": ("less", lt),
    ">": ("greater", gt),
    "<=": ("less-or-equal", le),
    ">=": ("greater-or-equal", ge),
}
_OPERATORS: Mapping[str, Callable[[int, int], int]] = {"+": add, "-": sub, "*": mul, "/": divide}


class _Round(Struct):
    """A loop that the program is in."""

    loop: Statement
    calls: int
    count: int | None
    """The number of the round; None if the beginning of the loop was not seen."""
    total: int | None = None
    has_gone_round: bool = False

    def go_round(self) -> None:
        self.has_gone_round = True
        if self.count is not None:
            self.count += 1


class StepNarrator:
    """Describes one run, hold by hold."""

    def __init__(
        self, program: Program | None, lines: Sequence[str], wording: Wording, *, is_first: bool = True
    ) -> None:
        """Takes the arguments of ``Stepping``."""
        self._program = program
        self._lines = lines
        self._say = wording
        self._found = dict(_by_place(program.body if program else (), 0))
        self._reads: list[int] = []
        self._rounds: list[_Round] = []
        self._before: Statement | None = None
        self._variables: Mapping[str, int] = {}
        """The variables at that statement."""
        self.worked_out: tuple[tuple[str, ...], ...] = ()
        """The expressions of that statement."""
        self._is_first = is_first
        self._level = self._calls = 0

    def on_read(self, event: Read) -> None:
        """A sensor was read. Only the first ones since a hold belong to the statement there."""
        if len(self._reads) < MOST_READS:
            self._reads.append(event.value)

    def lose_count(self) -> None:
        """Forgets the numbers of the rounds, as statements run without a hold."""
        self._rounds.clear()
        self._before, self._is_first = None, False

    def on_hold(self, line: int, column: int, frames: Sequence[Frame]) -> tuple[str, ...]:
        """The result of the last statement, and what is next. The program holds before that one."""
        statement, level = self._found.get((line, column), (None, 0))
        variables = {fold_name(name): value for name, value in frames[0].variables}
        sentences = [*self._condition()]
        sentences += self._round(statement, len(frames), variables)
        sentences.append(self._next(statement, line, level))
        self.worked_out = tuple(self._work_out(statement, variables))
        if self._say.detail == "full":
            sentences += [
                self._say("step-worked-out", expression=typed, values=", ".join(values))
                for typed, *values in self.worked_out
            ]
        self._before, self._variables = statement, variables
        self._level, self._calls = level, len(frames)
        self._reads.clear()
        return tuple(sentences)

    def on_end(self) -> tuple[str, ...]:
        """The result of the last statement, at the end of the program."""
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
        """The statement as typed; of a block its first words."""
        if statement is None:
            return self._lines[line - 1].strip() if 0 < line <= len(self._lines) else ""
        assert self._program is not None  # it has the statement
        inside = next((block[0] for block in blocks_of(statement) if block), None)
        end = statement.span.end if inside is None else inside.span.start
        return " ".join(self._program.source[statement.span.start : end].split())

    def _work_out(
        self, statement: Statement | None, variables: Mapping[str, int]
    ) -> Iterator[tuple[str, ...]]:
        """The evaluations of the statement's expressions that need no sensor."""
        expressions: tuple[Expression | TextLiteral | None, ...] = ()
        match statement:
            case Declare(value=value) | Assign(value=value) | SpeakCommand(what=value):
                expressions = (value,)
            case WalkCommand(steps=value) | TurnCommand(degrees=value) | WaitCommand(seconds=value):
                expressions = (value,)
            case Repeat(times=value) if not self._rounds[-1].has_gone_round:
                expressions = (value,)
            case Call(arguments=arguments):
                expressions = arguments
            case If(condition=condition) | While(condition=condition):
                expressions = condition.left, condition.right
            case For(start=start, step=step):
                expressions = ((step if self._rounds[-1].has_gone_round else start).value,)
        for each in expressions:
            if each is not None and not isinstance(each, TextLiteral):
                assert self._program is not None  # it has the statement
                texts = tuple(worked_out(each, self._program, variables))
                if len(texts) > 1:
                    yield texts

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
        """Whether this is the first round: the statement before was outside of the loop."""
        if self._before is None:
            return self._is_first
        return calls != self._calls or not _is_within(loop, self._before)

    def _is_in(self, current: _Round, statement: Statement | None, calls: int) -> bool:
        if calls > current.calls:
            return True
        return calls == current.calls and statement is not None and _is_within(current.loop, statement)

    def _round_in_words(self, current: _Round, variables: Mapping[str, int]) -> Iterator[str]:
        """The number of the round; where it is not known, only that it is another one."""
        if current.count is None:
            yield from (self._say("step-round-next"),) if current.has_gone_round else ()
            return
        if isinstance(current.loop, Repeat) and current.count == 1:
            current.total = self._value(current.loop.times, variables, iter(self._reads))
        code = "step-round" if current.total is None else "step-round-of"
        yield self._say(code, round=current.count, rounds=current.total)

    # --- conditions

    def _condition(self) -> Iterator[str]:
        """The condition with its values at that time, since a procedure may have ended meanwhile."""
        if isinstance(self._before, If | While | For):
            condition, reads = self._before.condition, iter(self._reads)
            variables: Mapping[str, int | None] = self._variables
            if isinstance(self._before, For):
                if self._rounds[-1].count is None and not self._rounds[-1].has_gone_round:
                    return  # it began with the start or with the step
                name, value = self._counted(self._before, reads)
                variables = {**variables, name: value}
            left = self._value(condition.left, variables, reads)
            right = self._value(condition.right, variables, reads)
            if left is not None and right is not None:
                yield self._condition_in_words(condition, left, right)

    def _counted(self, loop: For, reads: Iterator[int]) -> tuple[str, int | None]:
        """The loop's variable, and its value as set before the condition, None if it is unknown."""
        made = loop.step if self._rounds[-1].has_gone_round else loop.start
        value = 0 if made.value is None else self._value(made.value, self._variables, reads)
        return fold_name(made.name.name), value

    def _condition_in_words(self, condition: Condition, left: int, right: int) -> str:
        """The condition as written, with its values, and its result."""
        name, compare = _COMPARISONS[condition.comparator]
        how = self._say(f"comparison-{name}", left=left, right=right)
        return self._say("step-true" if compare(left, right) else "step-false", how=how)

    def _value(
        self, expression: Expression, variables: Mapping[str, int | None], reads: Iterator[int]
    ) -> int | None:
        """The current value of an expression; None if it is unknown."""
        match expression:
            case NumberLiteral(value=value):
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
        return _OPERATORS[operator](left, right)
    except (LanguageError, ZeroDivisionError):
        return None


def worked_out(expression: Expression, program: Program, variables: Mapping[str, int]) -> Iterator[str]:
    """The expression as typed, then with the values of its variables, then operation by operation."""
    yield program.typed(expression.span)
    known = _with_values(expression, variables)
    if known != _with_values(expression, {}):
        yield _expression_text(known, program)
    for _ in range(MOST_OPERATIONS):
        operated = _operated(known)
        if operated is None:
            return
        known = operated
        yield _expression_text(known, program)
    while (operated := _operated(known)) is not None:
        known = operated
    if isinstance(known, NumberLiteral):
        yield str(known.value)


def _with_values(expression: Expression, variables: Mapping[str, int]) -> Expression:
    """The expression with numbers in place of variables that have a value; signs belong to their numbers."""
    match expression:
        case Name(name=name) if fold_name(name) in variables:
            return NumberLiteral(expression.span, variables[fold_name(name)])
        case Negative(operand=operand):
            known = _with_values(operand, variables)
            if isinstance(known, NumberLiteral):
                return NumberLiteral(expression.span, -known.value)
            return Negative(expression.span, known)
        case Binary(operator=operator, left=left, right=right):
            sides = _with_values(left, variables), _with_values(right, variables)
            return Binary(expression.span, operator, *sides)
        case _:
            return expression


def _operated(expression: Expression) -> Expression | None:
    """The expression after its first possible operation; None if there is none."""
    match expression:
        case Negative(operand=operand):
            inner = _operated(operand)
            if isinstance(inner, NumberLiteral):
                return NumberLiteral(expression.span, -inner.value)
            return None if inner is None else Negative(expression.span, inner)
        case Binary(operator=operator, left=NumberLiteral(value=one), right=NumberLiteral(value=other)):
            value = _computed(operator, one, other)
            is_shown = value is not None and abs(value) <= LARGEST_SHOWN
            return NumberLiteral(expression.span, value) if is_shown and value is not None else None
        case Binary(operator=operator, left=left, right=right):
            inner = _operated(left)
            if inner is not None:
                return Binary(expression.span, operator, inner, right)
            inner = _operated(right)
            return None if inner is None else Binary(expression.span, operator, left, inner)
        case _:
            return None


_STRENGTH = {"+": 1, "-": 1, "*": 2, "/": 2}


def _expression_text(expression: Expression, program: Program) -> str:
    """The text of an expression, with as few brackets as keep its meaning."""
    match expression:
        case NumberLiteral(value=value):
            return str(value)
        case Negative(operand=operand):
            inner = _expression_text(operand, program)
            return f"-({inner})" if isinstance(operand, Binary) else f"-{inner}"
        case Binary(operator=operator, left=left, right=right):
            after = _side(right, operator, program, is_right=True)
            return f"{_side(left, operator, program)} {operator} {after}"
        case _:
            return program.typed(expression.span)


def _side(side: Expression, operator: str, program: Program, *, is_right: bool = False) -> str:
    text = _expression_text(side, program)
    is_weaker = isinstance(side, Binary) and _STRENGTH[side.operator] < _STRENGTH[operator] + is_right
    is_signed = is_right and text.startswith("-")
    return f"({text})" if is_weaker or is_signed else text


def _is_within(loop: Statement, statement: Statement) -> bool:
    """Whether it is the loop or in it."""
    return loop.span.start <= statement.span.start < loop.span.end


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
    """A sentence for each watched variable whose value is not the one ``before``; both by folded name."""
    for name in watched:
        value = now.get(fold_name(name))
        if value is not None and value != before.get(fold_name(name)):
            yield wording("variable-is", name=name, value=value)
