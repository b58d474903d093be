"""What the words about several robots and the gripper do, for both front ends. Answers go to the hub.

ROBOTS and ROBOT name, START (a run that nobody waits for), TOGETHER, STOP ALL, GRIP and RELEASE.
"""

from __future__ import annotations

from donnie_tui.bootstrap import Donnie
from donnie_tui.core import poses
from donnie_tui.core.handling import Deed
from donnie_tui.core.naming import no_such_robot
from donnie_tui.core.runner import Run
from donnie_tui.core.session import Busy, Session
from donnie_tui.core.team import Assigned
from donnie_tui.core.telling import facing

MOST_ROBOTS = 30
"""Robots that are told of one by one."""
LONGEST_READING = 2.0
"""Seconds; most programs are read in a few thousandths."""


def tell_robots(donnie: Donnie) -> None:
    """Who is there and where."""
    donnie.tell(*robots_in_words(donnie))


def robots_in_words(donnie: Donnie) -> tuple[str, ...]:
    """Who is there and where, a line each; the one that is talked to first."""
    team, words = donnie.team, donnie.words
    if not team.has_several:
        return (words("robots-only-one", name=team.chosen.name),)
    told = [robot_in_words(donnie, team.session(name)) for name in team.names[:MOST_ROBOTS]]
    if len(team.names) > MOST_ROBOTS:
        told.append(words("robots-more", count=len(team.names) - MOST_ROBOTS))
    return (words("robot-chosen", name=team.chosen.name), *told)


def choose_robot(donnie: Donnie, typed: str) -> bool:
    """Talk to that robot from now on. False if there is none of that name."""
    team = donnie.team
    name = team.called(typed)
    if name is None:
        sentence = no_such_robot(typed, team.names, MOST_ROBOTS, donnie.words)
        donnie.tell(sentence)
        return False
    team.choose(name)
    donnie.say("robot-chosen", name=name)
    return True


def start(donnie: Donnie, text: str, name: str) -> Run | None:
    """Run a whole program from the robot's start, and wait for nothing but to tell whether it has mistakes of
    form. None if the robot is busy."""
    session = donnie.session
    donnie.team.give(session.name, Assigned(text, name))
    session.settle()

    def tell(run: Run) -> None:
        if not run.was_refused:
            donnie.say("robot-started", name=session.name)

    try:
        run = session.start(text, name, fresh=True, hooked=False, terminal=False, when_read=tell)
    except Busy:
        donnie.say("robot-busy", name=session.name)
        return None
    run.wait_until_read(LONGEST_READING)
    return run


def start_together(donnie: Donnie) -> tuple[tuple[str, Run], ...]:
    """All robots that were given programs begin at the same moment. The runs by name, none if one is busy."""
    team = donnie.team
    team.settle()
    programs = {name: each for name, each in team.given.items() if each.text.strip()}
    busy = [session.name for session in team.running if session.name in programs]
    if not programs:
        donnie.say("robot-no-programs")
    elif busy:
        donnie.say("robot-busy", name=busy[0])
    else:
        names = tuple(name for name in team.names if name in programs)
        return tuple(zip(names, team.start_together(programs, terminal=False), strict=True))
    return ()


def stop_all(donnie: Donnie) -> None:
    """All robots, whoever is talked to."""
    donnie.say(stopped_all(donnie))


def stopped_all(donnie: Donnie) -> str:
    """Stop all robots. The code of what is answered to that."""
    is_any = bool(donnie.team.running)
    donnie.team.stop()
    return "robot-all-stopped" if is_any else "robot-now-idle"


def use_gripper(donnie: Donnie, deed: Deed) -> Run | None:
    """Close or open it; None if the robot is busy."""
    donnie.session.settle()
    try:
        return donnie.session.use_gripper(deed)
    except Busy:
        donnie.say("robot-busy", name=donnie.session.name)
        return None


def robot_in_words(donnie: Donnie, session: Session) -> str:
    """Where that robot is, and whether its program runs."""
    pose = session.pose
    return donnie.words(
        "robot-listed" if session.run is None else "robot-listed-running",
        name=session.name,
        x=poses.whole(pose.x),
        y=poses.whole(pose.y),
        facing=facing(pose, donnie.words),
    )
