"""RUN, AGAIN, STOP, PAUSE, CONTINUE, STEP, UNTIL, BREAK, WATCH, SPEED, RESET: running a program."""

from __future__ import annotations

from collections.abc import Callable

from donnie_tui.commands.context import Context
from donnie_tui.commands.dispatch import handles, refuse_busy
from donnie_tui.commands.interaction import NotUnderstood, read_numbers
from donnie_tui.core.events import TYPED, Error, Outcome
from donnie_tui.core.run_controller import RunController
from donnie_tui.core.run_state import Begin, NothingRuns, NothingToRun, Request, RunState
from donnie_tui.core.runner import Run, RunRequest
from donnie_tui.core.session import LONGEST_STOP, Busy, Taken
from donnie_tui.settings.parsing import FASTEST, SLOWEST, read_speed
from donnie_tui.settings.settings import faster_than, slower_than, speed_words
from language.control import ExecutionControl
from language.diagnostics import MistakeKind
from language.source import fold_name

LONGEST_BEGINNING = 1.0
"""Seconds that a file of typed lines waits for a robot to set out; a program may compute first."""
DROPPING_IS_EXPLAINED = 2
"""How often in a row lines are refused before the answer also says how to drop them."""

# --- starting


@handles("run", is_whole=False)
@handles("again", is_whole=True)
async def run(ctx: Context, _: str, is_whole: bool) -> None:
    """Run the lines that have not run yet, or the whole program from the start of the world.

    A program in an editor always runs as a whole. RUN continues a held program.
    """
    if ctx.runs.is_held and not is_whole:
        ctx.runs.continue_()
    else:
        await run_program(ctx, is_whole=is_whole)


async def run_program(ctx: Context, *, is_whole: bool, begin: Begin | None = None) -> None:
    """Run the program, or its waiting lines; of the latter only new mistakes are reported."""
    is_again = not is_whole and ctx.program.refusals > 0
    if is_again and ctx.program.is_still_refused:
        _say_what_waits(ctx)
        return
    ctx.errors.known = frozenset(ctx.errors.all if is_again else ())
    try:
        started = ctx.runs.start(whole_program(ctx) if is_whole else _waiting_lines(ctx), begin=begin)
    except NothingToRun:
        ctx.answer("answer-nothing-to-run")
        return
    except Busy as busy:
        refuse_busy(ctx, busy)
        return
    if await ctx.interaction.follow([(ctx.donnie.session.hub.robot, started)]):
        _note_run(ctx, started, is_whole=is_whole)
        await _ask_questions(ctx)


async def _ask_questions(ctx: Context) -> None:
    """Ask the questions of the challenge after a run, where a person can answer."""
    if ctx.attempt is not None and ctx.attempt.has_questions and ctx.interaction.is_attended:
        from donnie_tui.commands.challenges import questions

        await questions(ctx, "")


async def run_alone(ctx: Context, line: str) -> None:
    """Run a line that is not part of the program. A running program is stopped first."""
    running = ctx.donnie.session.run
    if running is not None:
        ctx.donnie.session.stop()
        running.wait(LONGEST_STOP)
    started = ctx.runs.start(RunRequest(line, _name(ctx), len(ctx.program.lines) + 1, is_whole=False))
    await ctx.interaction.follow([(ctx.donnie.session.hub.robot, started)])


def whole_program(ctx: Context) -> RunRequest:
    """A request to run the program from the start of the world."""
    document = ctx.program
    return RunRequest(document.text, _name(ctx), breakpoints=document.breakpoints)


def _waiting_lines(ctx: Context) -> RunRequest:
    document = ctx.program
    if document.is_in_editor:
        return whole_program(ctx)
    batch = document.take_batch()
    return RunRequest(
        batch.text,
        _name(ctx),
        batch.first_line,
        is_whole=False,
        breakpoints=document.breakpoints,
        lines=document.lines,
    )


def _name(ctx: Context) -> str:
    path = ctx.program.path
    return path.name if path else TYPED


def _note_run(ctx: Context, ended: Run, *, is_whole: bool) -> None:
    """After a mistake, say in one line what ran, what waits and what was dropped."""
    program = ctx.program
    if not ended.was_refused:
        first = 1 if is_whole else program.ran + 1
        program.batch_ran()
        if ended.outcome is Outcome.FAILED and not program.is_in_editor:
            _say_what_ran(ctx, first)
    elif not is_whole:
        number = len(program.lines) - program.waiting + 1
        wrong = [each for each in ctx.errors.all if each.kind != MistakeKind.MISSING_END.value]
        lines = {_line_to_change(each): each.meant for each in reversed(wrong)}
        if not program.batch_was_refused(lines, is_unfinished=not wrong):
            ctx.answer("line-dropped", line=number)
        elif (new := ctx.errors.go_to_new()) is not None:
            kept = "lines-kept" if wrong else "lines-kept-unfinished"
            code = "lines-kept-fixable" if new.meant else kept
            ctx.answer(code, line=_line_to_change(new), lines=program.waiting)
        else:
            program.refusals -= 1
            _say_what_waits(ctx)


def _say_what_waits(ctx: Context) -> None:
    """Say where the waiting lines are still wrong, and from the second time on how to drop them."""
    program, first = ctx.program, ctx.errors.all[:1]
    program.refusals += 1
    line = _line_to_change(first[0]) if first else len(program.lines)
    ctx.answer("lines-still-wrong", line=line, lines=program.waiting)
    if program.refusals == DROPPING_IS_EXPLAINED:
        ctx.answer("delete-forgets-lines", lines=program.waiting)


def _say_what_ran(ctx: Context, first: int) -> None:
    """Say what ran of a program that began at line ``first`` and failed at a later one."""
    program, error = ctx.program, ctx.errors.all[-1] if ctx.errors.all else None
    line = (error.calls[-1] if error.calls else error.line) if error is not None else 0
    if error is None or not first <= line <= len(program.lines):
        return
    program.batch_failed(line)
    structure = program.structure
    around = structure.openers(line)
    begin = around[-1].line if around else line
    end = structure.end_of(begin)
    ran = 0 if begin < line else sum(bool(each.strip()) for each in program.lines[first - 1 : begin - 1])
    left = sum(bool(each.strip()) for each in program.lines[end:])
    is_within = not ran and (begin < line or bool(error.calls) or not _is_one_statement(ctx, line))
    if is_within:
        ctx.answer(f"line-failed-within{'-left' if left else ''}", line=error.line, unrun=left)
    elif ran or left:
        code = f"lines{'-ran' if ran else ''}-failed{'-left' if left else ''}"
        ctx.answer(code, ran=ran, line=line, unrun=left)
    else:
        ctx.answer("line-failed", line=error.line)


def _is_one_statement(ctx: Context, line: int) -> bool:
    """Whether the line is one statement without a block, so that nothing can have run before its mistake."""
    from language.syntax import walk

    program = ctx.donnie.session.parse(ctx.program.lines[line - 1]).program
    return program is not None and len(tuple(walk(program.body))) == 1


def _line_to_change(error: Error) -> int:
    return error.fixed_line or error.line


@handles("start")
async def start(ctx: Context, _: str) -> None:
    """Run the program in the background. Waits only for parsing; the answer lists the mistakes."""
    document, session = ctx.program, ctx.donnie.session
    started = ctx.runs.start_in_background(whole_program(ctx))
    if started.was_refused:
        started.wait(LONGEST_STOP)
    elif not document.is_in_editor:
        document.batch_ran()
    if not ctx.interaction.is_attended:  # a STOP in the next line of a file finds the robot on its way
        session.wait_until_acting(LONGEST_BEGINNING)


@handles("together")
async def together(ctx: Context, _: str) -> None:
    """Run the programs of all robots, starting at the same moment."""
    team, documents = ctx.donnie.team, ctx.workspace.by_robot()
    if ctx.program.is_in_editor:  # one text for all, given to the robot that is talked to
        documents = {ctx.donnie.session.name: ctx.program}
    for name, document in documents.items():
        if document.text.strip() or not document.is_in_editor:
            team.give(name, RunRequest(document.text, document.path.name if document.path else TYPED))
    try:
        runs = ctx.runs.start_together()
    except NothingToRun:
        ctx.answer("robot-no-programs")
        return
    except Taken:
        raise
    except Busy as busy:
        ctx.answer("robot-busy", name=str(busy))
        return
    if await ctx.interaction.follow([(team.session(name).hub.robot, each) for name, each in runs.items()]):
        for name, each in runs.items():
            if name in documents and not each.was_refused:
                documents[name].batch_ran()
        await _ask_questions(ctx)


# --- while it runs


@handles("stop")
async def stop(ctx: Context, _: str) -> None:
    """Stop the program and the robot."""
    try:
        ctx.runs.stop()
    except NothingRuns:
        ctx.answer("answer-nothing-runs")
        if ctx.program.is_waiting and not ctx.program.is_in_editor:
            ctx.answer("lines-wait", lines=ctx.program.waiting)


@handles("stop_all")
async def stop_all(ctx: Context, _: str) -> None:
    """Stop all robots; in a world with one robot as STOP."""
    is_any = ctx.runs.stop_all()
    if ctx.donnie.team.has_several:
        ctx.answer("robot-all-stopped" if is_any else "robot-now-idle")


@handles("pause")
async def pause(ctx: Context, _: str) -> None:
    """Hold the program, which says where it is. Its key lets a held one continue, see ``perform``."""
    if ctx.runs.state is RunState.PAUSED or not ctx.runs.pause():
        ctx.answer_of_robot("program-paused")


@handles("continue_")
async def continue_(ctx: Context, _: str) -> None:
    """Continue the held program."""
    ctx.runs.require(Request.CONTINUE)
    ctx.answer_of_robot("answer-continued")
    ctx.runs.continue_()


@handles("step", go_on=RunController.step)
@handles("step_over", go_on=RunController.step_over)
async def step(ctx: Context, _: str, go_on: Callable[[RunController], None]) -> None:
    """Run one statement; with OVER, a whole procedure call.

    After STEP BACK, a step goes forward in the recorded past, and the robot stays.
    """
    if ctx.runs.past is not None:
        go_on(ctx.runs)
    else:
        await _step(ctx, go_on, ExecutionControl.step)


@handles("run_to")
async def run_to(ctx: Context, argument: str) -> None:
    """Run until this line is next."""
    (line,) = read_numbers(argument, least=1, most=1)
    if not 1 <= line <= len(ctx.program.lines):
        ctx.answer_no_line(line)
        return
    at = ctx.program.pausing_line(line, ctx.donnie.session.parse)
    if at != line:
        ctx.answer("break-nowhere", line=line)
    if at is not None:
        await _step(ctx, lambda runs: runs.run_to(at), lambda control: control.run_to(at))


async def _step(ctx: Context, go_on: Callable[[RunController], None], begin: Begin) -> None:
    """Step the held program; without one, start the waiting lines, or the whole program again."""
    if ctx.runs.is_steppable:
        go_on(ctx.runs)
    elif ctx.runs.state is not RunState.READY:
        refuse_busy(ctx, Busy())
    elif ctx.program.is_waiting or not ctx.program.lines:
        await run_program(ctx, is_whole=False, begin=begin)
    else:
        ctx.answer("step-from-start")
        await run_program(ctx, is_whole=True, begin=begin)


@handles("step_back")
async def step_back(ctx: Context, _: str) -> None:
    """Go back by one event and say it; repeated, go further back."""
    ctx.say(*ctx.runs.step_back())


# --- breakpoints, variables


@handles("break_")
async def break_(ctx: Context, argument: str) -> None:
    """Set or clear the breakpoint of a line; alone, list the breakpoints."""
    given, program = read_numbers(argument, most=1), ctx.program
    line = given[0] if given else 0
    if not given:
        lines = ", ".join(map(str, sorted(program.breakpoints)))
        ctx.say(ctx.words("break-lines", lines=lines) if lines else ctx.words("break-none"))
    elif not 1 <= line <= len(program.lines):
        ctx.answer_no_line(line)
    else:
        at = program.toggle_breakpoint(line, ctx.donnie.session.parse)
        ctx.workspace.keep_breakpoints()
        if at != line:
            ctx.answer("break-nowhere", line=line)
        if at is not None:
            ctx.answer("break-set" if at in program.breakpoints else "break-gone", line=at)
        ctx.runs.break_at(program.breakpoints)


@handles("watch")
async def watch(ctx: Context, argument: str) -> None:
    """Start or stop reporting each change of a variable; alone, list the watched variables."""
    if argument and not argument.isidentifier():
        raise NotUnderstood
    ctx.say(*ctx.runs.toggle_watch(argument))


@handles("show_variables")
async def show_variables(ctx: Context, _: str) -> None:
    """Say the calls, innermost first, and the variables of the innermost; after a run its final variables."""
    if ctx.screen is not None:
        ctx.screen.focus("variables")
        return
    frames, words = ctx.runs.frames, ctx.words
    if not ctx.runs.knows_variables:
        ctx.answer("variables-past")
        return
    calls = [words("call-at", name=each.procedure, line=each.line) for each in frames if each.procedure]
    variables = dict(frames[0].variables) if frames else ctx.donnie.session.variables
    values = [words("variable-is", name=name, value=value) for name, value in variables.items()]
    ctx.say(*ctx.counted([*calls, *(values or [words("variables-none")])]))


# --- speed, start


@handles("slower", changed=slower_than)
@handles("faster", changed=faster_than)
async def slower(ctx: Context, _: str, changed: Callable[[float | None], float | None]) -> None:
    """Run slower or faster from now on."""
    ctx.donnie.session.speed = changed(ctx.donnie.session.speed)
    _say_speed(ctx)


@handles("speed")
async def speed(ctx: Context, argument: str) -> None:
    """Change the speed if one is given, and say it."""
    if argument:
        try:
            ctx.donnie.session.speed = read_speed(fold_name(argument))
        except ValueError:
            ctx.refuse()
            ctx.answer("screen-bad-speed", slowest=SLOWEST, fastest=FASTEST)
            return
    _say_speed(ctx)


def _say_speed(ctx: Context) -> None:
    ctx.answer("answer-speed", speed=speed_words(ctx.donnie.session.speed, ctx.words))


@handles("reset")
async def reset(ctx: Context, _: str) -> None:
    """Put the robot to its start, and forget the variables."""
    ctx.runs.reset()
    ctx.answer_of_robot("answer-reset")
    if ctx.screen is not None:
        ctx.screen.robot_changed()
