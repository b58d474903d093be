"""The words about running: AGAIN, STOP, PAUSE, STEP, OVER, STEP BACK, UNTIL, BREAK, WATCH, SPEED, RESET."""

from __future__ import annotations

from collections.abc import Callable

from donnie_tui.core import speeds
from donnie_tui.core.holding_lines import holding_line, toggled, told_elsewhere
from donnie_tui.core.line_words import no_such_line
from donnie_tui.core.session import Busy
from donnie_tui.core.typed_words import numbers_in
from donnie_tui.core.watching import may_be_watched
from donnie_tui.linear.arguments import Handler, alone
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.runs import Runs
from donnie_tui.settings.readers import FASTEST, SLOWEST, read_speed
from language.control import ExecutionControl
from language.source import fold_name


def _again(_: Desk, runs: Runs, rest: str) -> bool:
    if not rest:
        runs.run_all()
    return not rest


def _step(desk: Desk, runs: Runs, rest: str) -> bool:
    """Where a program is held already, whoever holds it takes the word."""
    if not rest:
        _run_held(desk, runs, ExecutionControl.step)
    return not rest


def _run_held(desk: Desk, runs: Runs, begin: Callable[[ExecutionControl], None]) -> None:
    """What waits; where nothing does, the whole program once more, as AGAIN runs it."""
    if desk.program.is_waiting or not desk.program.lines:
        runs.run_waiting(begin=begin)
    elif runs.is_free():
        desk.answer("step-from-start")
        runs.run_all(begin=begin)


def _until(desk: Desk, runs: Runs, rest: str) -> bool:
    given = numbers_in(rest, most=1)
    if not given:
        return False
    line, lines = given[0], len(desk.program.lines)
    if not 1 <= line <= lines:
        desk.tell(no_such_line(lines, line, desk.say))
        return True
    at = holding_line(desk.program.text, line, desk.session.parse)
    desk.tell(*told_elsewhere(line, at, desk.say))
    if at is not None:
        _run_held(desk, runs, lambda control: control.run_to(at))
    return True


def _stop(desk: Desk, runs: Runs, rest: str) -> bool:
    if not rest and desk.session.run is None:
        desk.answer("answer-nothing-runs")
    elif not rest:
        if desk.answers_first:
            runs.stop()
        else:
            runs.stop_beside()
    return not rest


def _pause(desk: Desk, runs: Runs, rest: str) -> bool:
    """Where it is paused is told once it is held; of a program that nobody steps through, that it is."""
    run = desk.session.run
    if not rest and run is None:
        desk.answer("answer-nothing-runs")
    elif not rest and run is not None:
        desk.is_pausing = runs.tells_holds
        run.control.pause()
        if not runs.tells_holds:
            desk.answer_of_robot("linear-paused")
    return not rest


def _continue(desk: Desk) -> None:
    """One that is stepped through goes on where it is held; here it is one that nobody steps through."""
    run = desk.session.run
    if run is None:
        desk.answer("answer-nothing-runs")
    else:
        run.control.resume()
        desk.answer_of_robot("answer-continued")


def _step_back(desk: Desk) -> None:
    """What happened last, undone in words; once more goes further back."""
    is_now = desk.heard.timeline is None
    timeline = desk.heard.timeline = desk.heard.timeline or desk.donnie.chronicle.timeline()
    desk.tell(*desk.stepped.back(timeline, is_now=is_now))


def _break(desk: Desk, _: Runs, rest: str) -> bool:
    """A breakpoint there or none any more; alone: where there are any."""
    given = numbers_in(rest, most=1)
    if given is None:
        return False
    if given and not 1 <= given[0] <= len(desk.program.lines):
        desk.tell(no_such_line(len(desk.program.lines), given[0], desk.say))
    elif given:
        _toggle_breakpoint(desk, given[0])
    elif desk.program.breakpoints:
        desk.answer("break-lines", lines=", ".join(map(str, sorted(desk.program.breakpoints))))
    else:
        desk.answer("break-none")
    return True


def _toggle_breakpoint(desk: Desk, line: int) -> None:
    program = desk.program
    program.breakpoints, at = toggled(program.breakpoints, line, program.text, desk.session.parse)
    desk.tell(*told_elsewhere(line, at, desk.say))
    if at is not None:
        desk.answer("break-set" if at in program.breakpoints else "break-gone", line=at)
    desk.programs.keep_breakpoints()
    run = desk.session.run
    if run is not None:
        run.control.break_at(desk.program.breakpoints)


def _watch(desk: Desk, _: Runs, rest: str) -> bool:
    if rest and not may_be_watched(rest):
        return False
    desk.tell(*desk.watch.toggle(rest))
    return True


def _variables(desk: Desk) -> None:
    """The calls, innermost first, and the variables of the innermost; after a run what it left."""
    frames, say = desk.session.frames, desk.say
    calls = [say("call-at", name=each.procedure, line=each.line) for each in frames if each.procedure]
    variables = dict(frames[0].variables) if frames else desk.session.variables
    values = [say("variable-is", name=name, value=value) for name, value in variables.items()]
    desk.tell_list([*calls, *(values or [say("variables-none")])])


def _speed(desk: Desk, _: Runs, rest: str) -> bool:
    """Change the speed, where one is given, and say it."""
    try:
        if rest:
            desk.session.speed = read_speed(fold_name(rest))
    except ValueError:
        desk.answer("screen-bad-speed", slowest=SLOWEST, fastest=FASTEST)
        return True
    _say_speed(desk)
    return True


def _faster(desk: Desk) -> None:
    desk.session.speed = speeds.faster(desk.session.speed)
    _say_speed(desk)


def _slower(desk: Desk) -> None:
    desk.session.speed = speeds.slower(desk.session.speed)
    _say_speed(desk)


def _say_speed(desk: Desk) -> None:
    desk.answer("answer-speed", speed=speeds.speed_words(desk.session.speed, desk.say))


def _reset(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        try:
            desk.session.reset()
        except Busy:
            desk.answer("robot-busy", name=desk.session.name)
        else:
            desk.answer_of_robot("answer-reset")
    return not rest


HANDLERS: dict[str, Handler] = {
    "again": _again,
    "stop": _stop,
    "pause": _pause,
    "continue_": alone(_continue),
    "step": _step,
    "step_over": _step,
    "step_back": alone(_step_back),
    "run_to": _until,
    "break_": _break,
    "watch": _watch,
    "show_variables": alone(_variables),
    "slower": alone(_slower),
    "faster": alone(_faster),
    "speed": _speed,
    "reset": _reset,
}
