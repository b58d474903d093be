"""``donnie run``: programs from their start to their end, as sentences or as events.

``FILE`` is for the first robot of the world, ``ROBOT=FILE`` for the named one. A signal stops every robot at
once; each run then ends as usual, with its last event.

No output may destroy an input: programs, recordings, settings, the world and all its files. An existing file
is replaced only if it begins like a file that the same option wrote, so ``--record lesson.gd`` keeps the
program. Two outputs are never the same file. All of this is checked before any file is opened.
"""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing
from functools import partial
from itertools import combinations, product
from pathlib import Path, PurePath
from typing import TextIO, cast

from donnie_tui.bootstrap import Donnie, assemble
from donnie_tui.cli.options import ExitCode, Order
from donnie_tui.cli.programs import by_robot, path_given, read_source, robot_and_file
from donnie_tui.cli.streams import (
    Guarded,
    Output,
    let_sound,
    on_signals,
    stopped_by_signals,
    stopped_by_suspension,
)
from donnie_tui.core.events import Answered, Outcome, Stamped
from donnie_tui.core.program_files import STANDARD_OUTPUT, is_file, is_same_file
from donnie_tui.core.runner import LAST_WORDS, Run, RunRequest
from donnie_tui.core.session import RunOptions
from donnie_tui.core.transcript import printed_lines
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.outlets.files import may_be_replaced
from donnie_tui.process.signals import longer
from donnie_tui.robot.search import Search
from donnie_tui.settings.folders import settings_file
from donnie_tui.settings.settings import Settings, SettingSource


def read_programs(arguments: Sequence[str], words: Words) -> tuple[tuple[str | None, RunRequest], ...]:
    """Read the programs of ``donnie run``: each with the robot's name, None for the first one.

    Raises ``Unusable``. A file of exactly that name wins over a robot.
    """
    parts = [robot_and_file(each) for each in arguments]
    if len(parts) > 1:
        _refuse_nameless(parts, words)
    if sum(file == "-" for _, file in parts) > 1:
        raise Unusable(words("robots-one-input"))
    return tuple((robot, _program(file, words)) for robot, file in parts)


def _refuse_nameless(parts: Sequence[tuple[str | None, str]], words: Words) -> None:
    for robot, file in parts:
        if robot is None:
            raise Unusable(words("robots-need-names", file=file))


def _program(file: str, words: Words) -> RunRequest:
    source = read_source(file, words)
    return RunRequest(source.text, PurePath(source.name).name)


def refuse_overwriting(order: Order) -> None:
    """Raises ``Unusable`` if an output is an input of the command, or the file of another output."""
    printed = [option for option, name in order.outputs if name == STANDARD_OUTPUT]
    if len(printed) > 1:
        raise Unusable(order.words("output-twice", option=printed[0], other=printed[1], path=STANDARD_OUTPUT))
    files = [each for each in order.outputs if each[1] != STANDARD_OUTPUT]
    outputs = tuple((option, path_given(name, order.words)) for option, name in files)
    for (option, path), (other, other_path) in combinations(outputs, 2):
        if is_same_file(path, other_path):
            raise Unusable(order.words("output-twice", option=option, other=other, path=path))
    own = (*_programs(order), settings_file(order.environment))
    read = [*map(Path, (*own, *_files_of_world(order, outputs)))]
    for (option, path), source in product(outputs, read):
        if is_same_file(path, source):
            raise Unusable(order.words("output-is-input", option=option, path=path))
    for option, path in outputs:
        if not may_be_replaced(option, path):
            raise Unusable(order.words("output-is-other", option=option, path=path))


def _programs(order: Order) -> Iterator[str]:
    """The possible program files: ``ROBOT=FILE`` may also be a file of that name."""
    arguments = order.invocation.arguments
    named = getattr(arguments, "file", None)
    files = [named] if isinstance(named, str) else named or []
    for each in (*files, *filter(None, [getattr(arguments, "run", None)])):
        yield each
        if "=" in each:
            yield each.partition("=")[2]


def _files_of_world(order: Order, outputs: tuple[tuple[str, Path], ...]) -> tuple[str, ...]:
    """None if no output file exists yet, or the world ships with Donnie."""
    import worlds
    from donnie_tui.world.loading import choose_world, files_of  # slow to load, and few write anything

    settings = order.settings
    name = next(iter(getattr(order.invocation.arguments, "name", None) or ()), settings.world)
    if order.invocation.command == "replay" or name in worlds.names():
        return ()
    if not any(is_file(path) for _, path in outputs):
        return ()
    return (name, *files_of(choose_world(name, order.words, settings.include_folders)))


_CHECK_INTERVAL = 0.5
"""Seconds between two checks for a signal during a wait that a signal can't interrupt."""
_LONGEST_END = 10.0
"""Seconds for a stopped run to end once its robot stands."""

_CODE_OF = {
    Outcome.COMPLETED: ExitCode.DONE,
    Outcome.QUIT: ExitCode.DONE,
    Outcome.FAILED: ExitCode.FAILED,
    Outcome.STOPPED: ExitCode.STOPPED,
}


def run(order: Order) -> int:
    """``donnie run FILE``, or ``donnie run ROBOT=FILE ROBOT=FILE``; with ``--challenge`` it is judged."""
    if order.invocation.arguments.challenge is not None:
        from donnie_tui.cli.programs import check_challenge  # few runs are judged

        return check_challenge(order, order.invocation.arguments.challenge, order.invocation.arguments.file)
    return _run(order, order.invocation.arguments.file, trace=order.invocation.arguments.trace)


def run_original(order: Order) -> int:
    """``GoDonnie -f FILE``."""
    return _run(order, [order.invocation.arguments.run], trace=False)


def _run(order: Order, files: Sequence[str], *, trace: bool) -> int:
    programs = read_programs(files, order.words)
    output = order.output
    donnie = _assembled(order)
    try:
        assigned = by_robot(programs, donnie.team.names, order.words)
        _print_notices(order.settings, donnie, output)
        with_words = order.settings.events != "-"
        donnie.session.hub.subscribe(_printer(donnie, output, with_words=with_words))
        code = _run_to_the_end(donnie, assigned, output, trace)  # closes the session
        code = ExitCode.FAILED if donnie.connection.has_run_away else code
        return ExitCode.UNUSABLE if donnie.outlets.written.lost else code
    finally:
        donnie.close()


def _assembled(order: Order) -> Donnie:
    """A session with its robot. A signal meanwhile counts as a failure: what was opened is stopped."""
    search, given_up = Search(), False

    def give_up() -> None:
        nonlocal given_up
        is_first, given_up = not given_up, True
        if is_first and not search.give_up():  # one more must not end the closing
            raise KeyboardInterrupt

    with on_signals(give_up):
        try:
            donnie = assemble(
                order.settings, terminal=False, out=cast(TextIO, Guarded(order.output)), search=search
            )
        except Unusable:
            if given_up:
                raise KeyboardInterrupt from None
            raise
        if given_up:  # too late for the search
            donnie.close()
            raise KeyboardInterrupt
    return donnie


def _run_to_the_end(donnie: Donnie, programs: Mapping[str, RunRequest], output: Output, trace: bool) -> int:
    """Run all programs. Returns the worst exit code."""
    output.on_broken = donnie.team.stop
    with (
        stopped_by_signals(
            donnie.team.stop, [partial(_stop_robot, donnie)], partial(_code, donnie)
        ) as stopped,
        stopped_by_suspension(
            donnie.stop_real_robot, lambda: output.complaint(donnie.words("suspend-impossible"))
        ) as rested,
        closing(donnie),  # one more signal must not end that
    ):
        started = donnie.team.start_together(programs, RunOptions(trace=trace, hooked=False))
        for each in started:
            _await_end(each, stopped, donnie, output)
        let_sound(donnie.outlets.audible.is_still_within, stopped)
    if rested.is_set():  # known for certain only now: a stop may take longer than the run that it ends
        output.complaint(donnie.words("suspended-stopped"))
    return max(ExitCode.FAILED if each.outcome is None else _CODE_OF[each.outcome] for each in started)


def _await_end(run: Run, stopped: threading.Event, donnie: Donnie, output: Output) -> None:
    """Wait for the run. Leaves a stopped run once its robot stands if nothing reads its output."""
    while not run.wait(_CHECK_INTERVAL):
        if stopped.is_set():
            donnie.connection.wait_until_standing()
            if not _wait_for_end(run, output):
                _leave_at_once(donnie)
            break
    while output.is_stuck():  # the closing would wait for it, whatever comes
        if stopped.is_set():
            _leave_at_once(donnie)


def _wait_for_end(run: Run, output: Output) -> bool:
    """Wait for the end of a stopped run. False if nothing reads the output, or it takes too long."""
    until = time.monotonic() + longer(_LONGEST_END)
    while not run.wait(LAST_WORDS):
        if output.is_stuck() or time.monotonic() > until:
            return False
    return True


def _leave_at_once(donnie: Donnie) -> None:
    """Stops the robot and ends the process. Nothing else is closed: that may hang as well."""
    try:
        _stop_robot(donnie)
    finally:
        os._exit(_code(donnie))


def _stop_robot(donnie: Donnie) -> None:
    donnie.team.stop()
    donnie.connection.close()


def _code(donnie: Donnie) -> int:
    """The exit code of a run that was stopped."""
    return ExitCode.FAILED if donnie.connection.has_run_away else ExitCode.STOPPED


def _printer(donnie: Donnie, output: Output, *, with_words: bool) -> Callable[[Stamped], None]:
    """Print what the program says; Donnie's own answers are not printed."""

    def show(stamped: Stamped) -> None:
        is_our_own = isinstance(stamped.event, Answered)
        for line in printed_lines(stamped, donnie.words):
            if is_our_own:
                output.complaint(line)
            elif with_words:
                output.line(line)

    return show


def _print_notices(settings: Settings, donnie: Donnie, output: Output) -> None:
    """Print notices; those about the voice only if a voice was chosen."""
    asked_for = settings.source_of("speech") is not SettingSource.DEFAULT
    notices = donnie.notices
    for notice in notices.all if asked_for else notices.about_world + notices.about_devices:
        output.complaint(notice)
