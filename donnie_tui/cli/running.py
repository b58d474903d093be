"""``donnie run``: programs from their start to their end, told in words or as events.

A signal stops every robot at once; each run then ends as it always does, with its last event.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Mapping, Sequence
from contextlib import closing
from typing import TextIO, cast

from donnie_tui.bootstrap import Donnie, assemble
from donnie_tui.cli import codes
from donnie_tui.cli.assigning import assign, read_programs
from donnie_tui.cli.ending import heard_signals, let_sound, stopped_by_signals, stopped_by_suspension
from donnie_tui.cli.order import Order
from donnie_tui.cli.output import Guarded, Output
from donnie_tui.core.events import Answered, Outcome, Stamped
from donnie_tui.core.patience import LAST_WORDS
from donnie_tui.core.runner import Run
from donnie_tui.core.team import Assigned
from donnie_tui.core.transcript import told_lines
from donnie_tui.i18n.words import Unusable
from donnie_tui.robot.search import Search
from donnie_tui.settings.chosen import Settings
from donnie_tui.settings.chosen import Source as Origin

_GLANCE = 0.5
"""Seconds between two looks for a signal where waiting can't be interrupted by one."""

_CODE_OF = {
    Outcome.COMPLETED: codes.DONE,
    Outcome.QUIT: codes.DONE,
    Outcome.FAILED: codes.FAILED,
    Outcome.STOPPED: codes.STOPPED,
}


def run(order: Order) -> int:
    """``donnie run FILE``, or ``donnie run ROBOT=FILE ROBOT=FILE``."""
    return _run(order, order.invocation.arguments.file, trace=order.invocation.arguments.trace)


def run_original(order: Order) -> int:
    """``GoDonnie -f FILE``."""
    return _run(order, [order.invocation.arguments.run], trace=False)


def _run(order: Order, files: Sequence[str], *, trace: bool) -> int:
    programs = read_programs(files, order.words)
    output = order.output
    donnie = _assembled(order)
    try:
        assigned = assign(programs, donnie.team, order.words)
        _tell_notices(order.settings, donnie, output)
        with_words = order.settings.events != "-"
        donnie.session.hub.subscribe(_printer(donnie, output, with_words=with_words))
        code = _run_to_the_end(donnie, assigned, output, trace)  # it closes behind itself
        return codes.UNUSABLE if donnie.outlets.written.lost else code
    finally:
        donnie.close()


def _assembled(order: Order) -> Donnie:
    """With its robot. A signal meanwhile ends that as a failure does: what was opened is stopped."""
    search, given_up = Search(), False

    def give_up() -> None:
        nonlocal given_up
        is_first, given_up = not given_up, True
        if is_first and not search.give_up():  # one more must not end the closing
            raise KeyboardInterrupt

    with heard_signals(give_up):
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


def _run_to_the_end(donnie: Donnie, programs: Mapping[str, Assigned], output: Output, trace: bool) -> int:
    """The worst exit code of all."""
    output.on_broken = donnie.team.stop
    with (
        stopped_by_signals(donnie.team.stop) as stopped,
        stopped_by_suspension(donnie.stop_real_robot) as rested,
        closing(donnie),  # one more signal must not end that
    ):
        started = donnie.team.start_together(programs, trace=trace, hooked=False)
        for each in started:
            _await_end(each, stopped, donnie)
        if rested.is_set():
            output.complaint(donnie.words("suspended-stopped"))
        let_sound(donnie.outlets.audible.is_still_within, stopped)
    return max(codes.FAILED if each.outcome is None else _CODE_OF[each.outcome] for each in started)


def _await_end(run: Run, stopped: threading.Event, donnie: Donnie) -> None:
    """Wait for the run. One that was stopped and can't end, because nobody reads what it says, is left,
    once its robot stands."""
    while not run.wait(_GLANCE):
        if stopped.is_set() and not run.wait(LAST_WORDS):
            _leave_at_once(donnie)


def _leave_at_once(donnie: Donnie) -> None:
    """Nothing else is closed: whatever else there is may hang as well."""
    try:
        donnie.team.stop()
        donnie.connection.close()
    finally:
        os._exit(codes.STOPPED)


def _printer(donnie: Donnie, output: Output, *, with_words: bool) -> Callable[[Stamped], None]:
    """What the program tells is what was asked for; what Donnie answers of itself is not."""

    def tell(stamped: Stamped) -> None:
        is_our_own = isinstance(stamped.event, Answered)
        for line in told_lines(stamped, donnie.words):
            if is_our_own:
                output.complaint(line)
            elif with_words:
                output.line(line)

    return tell


def _tell_notices(settings: Settings, donnie: Donnie, output: Output) -> None:
    """Of the voice only to those who chose how Donnie speaks: a run is quiet about what nobody asked for."""
    asked_for = settings.source_of("speech") is not Origin.DEFAULT
    notices = donnie.notices
    for notice in notices.all if asked_for else notices.about_world + notices.about_devices:
        output.complaint(notice)
