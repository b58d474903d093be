"""ROBOTS, ROBOT, CONNECT: which robot the learner talks to, and its connection."""

from __future__ import annotations

import os
from functools import partial
from pathlib import Path

from donnie_tui.commands.context import Context
from donnie_tui.commands.dispatch import handles
from donnie_tui.commands.interaction import Option, count_in
from donnie_tui.core.program_files import DocumentError, exists
from donnie_tui.core.session import Busy, Session
from donnie_tui.core.wording import facing, no_such_robot, whole_steps
from donnie_tui.robot.search import RobotOption
from donnie_tui.settings.parsing import SIMULATED, remember

MOST_ROBOTS = 30
"""Robots that are listed one by one."""


# --- which robot


@handles("robots")
async def robots(ctx: Context, _: str) -> None:
    """Say which robots there are and where; offer them if there are several."""
    ctx.say(*robots_in_words(ctx))
    if ctx.donnie.team.has_several and ctx.screen is not None:
        await robot(ctx, "")


@handles("robot")
async def robot(ctx: Context, argument: str) -> None:
    """Make this robot the current one; without a name, offer the robots."""
    team, words = ctx.donnie.team, ctx.words
    if not argument and not team.has_several:
        ctx.say(*robots_in_words(ctx))
        return
    if not argument:
        listed = [(name, team.session(name)) for name in team.names]
        options = [
            Option(name, _robot_in_words(ctx, session), session is ctx.donnie.session)
            for name, session in listed
        ]
        argument = await ctx.interaction.choose(words("ask-robot"), options, robots_in_words(ctx)) or ""
    if argument:
        _choose_robot(ctx, argument)


def _choose_robot(ctx: Context, typed: str) -> None:
    team, before = ctx.donnie.team, ctx.program
    name = team.called(typed)
    if name is None:
        ctx.say(no_such_robot(typed, team.names, MOST_ROBOTS, ctx.words))
        return
    ctx.interaction.before_robot_changes()
    team.choose(name)
    ctx.answer("robot-chosen", name=name)
    ctx.interaction.robot_changed()
    if ctx.program is not before and ctx.program.lines:
        ctx.answer("program-has-lines", lines=len(ctx.program.lines))


def robots_in_words(ctx: Context) -> tuple[str, ...]:
    """The robots and their places, a line each, the current robot first."""
    team, words = ctx.donnie.team, ctx.words
    if not team.has_several:
        return (words("robots-only-one", name=team.chosen.name),)
    lines = [_robot_in_words(ctx, team.session(name)) for name in team.names[:MOST_ROBOTS]]
    if len(team.names) > MOST_ROBOTS:
        lines.append(words("robots-more", count=len(team.names) - MOST_ROBOTS))
    return (words("robot-chosen", name=team.chosen.name), *lines)


def _robot_in_words(ctx: Context, session: Session) -> str:
    """The place of a robot, and whether its program runs."""
    pose = session.pose
    return ctx.words(
        "robot-listed" if session.run is None else "robot-listed-running",
        name=session.name,
        x=whole_steps(pose.x),
        y=whole_steps(pose.y),
        facing=facing(pose, ctx.words),
    )


# --- the connection


@handles("connect")
async def connect(ctx: Context, argument: str) -> None:
    """Connect the robot with this number; without one, offer the robots found. Takes some seconds."""
    slow = ctx.words("slow-connect")
    number = count_in(argument, 0)
    if not number:
        found = await ctx.interaction.background(lambda: _connections(ctx), slow, is_slow=True)
        printed = [*(each.text for each in found), ctx.words("connect-how")]
        if argument:
            ctx.say(*printed)
        else:
            number = int(await ctx.interaction.choose(ctx.words("ask-connect"), found, printed) or 0)
    if number:
        await ctx.interaction.background(partial(_connect_to, ctx, number), slow, is_slow=True)
        if ctx.screen is not None:
            ctx.screen.robot_changed()


def _connections(ctx: Context) -> list[Option]:
    """Look for devices; the robots that can be connected, by number, with their state."""
    connection = ctx.donnie.connection
    return [
        Option(str(number), _option_in_words(ctx, number, option), option.robot == connection.robot)
        for number, option in enumerate(connection.options(), 1)
    ]


def _option_in_words(ctx: Context, number: int, option: RobotOption) -> str:
    port = "" if "://" in option.robot else option.robot.partition(":")[2]
    if option.robot == ctx.donnie.connection.robot:
        code = "connect-option-now"
    elif port and not exists(Path(port)):
        code = "connect-option-missing"
    elif port and not os.access(port, os.R_OK | os.W_OK):
        code = "connect-option-forbidden"
    else:
        code = "connect-option"
    return ctx.words(code, number=number, what=option.sentence)


def _connect_to(ctx: Context, number: int) -> None:
    """Connect the robot of that number, in its own thread. Answers are printed at once."""
    connection, options = ctx.donnie.connection, ctx.donnie.connection.options()
    if not 1 <= number <= len(options):
        ctx.refuse()
        ctx.answer("connect-unknown", number=number)
        return
    robot = options[number - 1].robot

    def say_soon(code: str) -> None:
        ctx.answer(code)
        ctx.interaction.print_soon()

    if robot != SIMULATED:
        connection.search.expect()
        connection.search.on_slow = lambda: say_soon("connect-waiting")
        say_soon("connect-trying")
    try:
        missing = connection.connect(robot)
    except Busy:
        ctx.answer("connect-busy")
        return
    ctx.say(*missing)
    if not missing:
        _keep_connection(ctx)


def _keep_connection(ctx: Context) -> None:
    """Use this connection at the next start, too. A real robot announces itself."""
    robot = ctx.donnie.connection.robot
    if robot == SIMULATED:
        ctx.answer("connect-simulator")
    try:
        remember("robot", robot, os.environ)
    except DocumentError as problem:
        ctx.answer(problem.code, path=problem.path, reason=problem.reason)
