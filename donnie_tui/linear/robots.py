"""ROBOTS, ROBOT name, START, TOGETHER, STOP ALL, GRIP, RELEASE, CONNECT, FEEL.

Each robot has a program of its own: who talks to another one finds that one's lines. What runs beside the
conversation is printed as it comes, while no line is being typed; TOGETHER is watched like a run.
"""

from __future__ import annotations

from pathlib import Path

from donnie_tui.core.events import TYPED
from donnie_tui.core.handling import Deed
from donnie_tui.core.patience import SLOW_AGAIN
from donnie_tui.core.runner import Run
from donnie_tui.core.team import Assigned
from donnie_tui.core.typed_program import TypedProgram
from donnie_tui.linear.arguments import Handler, alone
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.patience import patiently
from donnie_tui.linear.runs import Runs
from donnie_tui.words import robot_words, team_words
from donnie_tui.words.silent_ends import SilentEnds

LONGEST_BEGINNING = 1.0
"""Seconds that a file of typed lines waits for a robot to set out; a program may compute first."""


def _robots(desk: Desk) -> None:
    desk.tell(*team_words.robots_in_words(desk.donnie))


def _robot(desk: Desk, _: Runs, rest: str) -> bool:
    before = desk.session.name
    if rest and team_words.choose_robot(desk.donnie, rest):
        desk.programs.change_robot(before)
        if desk.program.lines:
            desk.answer("linear-lines", lines=len(desk.program.lines))
    return bool(rest)


def _start(desk: Desk, runs: Runs, rest: str) -> bool:
    """Nothing is waited for but what a mistake of form makes of it: else the robot is busy with that."""
    text = desk.program.text
    if rest:
        return False
    if text.strip():
        ends = SilentEnds(desk.donnie, [desk.session.hub.robot])
        run = team_words.start(desk.donnie, text, _name(desk.program))
        if run is None or run.was_refused:
            ends.close()
        if run is not None and run.was_refused:
            runs.watch_deed(lambda: run)
        elif run is not None:
            desk.program.batch_ran()
            _let_begin(desk)
    else:
        desk.answer("answer-nothing-to-run")
    return True


def _let_begin(desk: Desk) -> None:
    """Lines of a file come at once: a STOP among them finds the robot on its way, each time the same."""
    if not desk.is_attended:
        desk.session.wait_until_acting(LONGEST_BEGINNING)


def _together(desk: Desk, runs: Runs, rest: str) -> bool:
    if rest:
        return False
    programs = desk.programs.by_robot()
    for name, program in programs.items():
        desk.donnie.team.give(name, Assigned(program.text, _name(program)))
    began: list[tuple[str, Run]] = []

    def start() -> tuple[tuple[str, Run], ...]:
        began.extend(team_words.start_together(desk.donnie))
        return tuple(began)

    team = desk.donnie.team
    ends = SilentEnds(desk.donnie, [team.session(each).hub.robot for each in team.given])
    runs.watch_together(start)
    ends.close()
    for name in (name for name, run in began if name in programs and not run.was_refused):
        programs[name].batch_ran()
    return True


def _stop_all(desk: Desk, runs: Runs, rest: str) -> bool:
    if not rest:
        if desk.session.run is not None:
            runs.remember_stop()
        if desk.answers_first:
            desk.answer(team_words.stopped_all(desk.donnie))
        else:
            desk.beside.stop()
    return not rest


def _use(deed: Deed) -> Handler:
    def use(desk: Desk, runs: Runs, rest: str) -> bool:
        if not rest:
            runs.watch_deed(lambda: team_words.use_gripper(desk.donnie, deed))
        return not rest

    return use


def _connect(desk: Desk, _: Runs, rest: str) -> None:
    """That it is looked for is told at once, so that it goes on is told later."""
    patiently(
        desk,
        lambda: robot_words.connect(desk.donnie, rest, desk.console.nudge),
        "slow-connect",
        first=SLOW_AGAIN,
    )


def _feel(desk: Desk, _: Runs, rest: str) -> None:
    robot_words.feel(desk.donnie, rest)


def _name(program: TypedProgram) -> str:
    return Path(program.name).name if program.name else TYPED


HANDLERS: dict[str, Handler] = {
    "robots": alone(_robots),
    "robot": _robot,
    "start": _start,
    "together": _together,
    "stop_all": _stop_all,
    "grip": _use(Deed.GRIP),
    "release": _use(Deed.RELEASE),
    "connect": _connect,
    "feel": _feel,
}
