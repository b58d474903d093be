"""Small mistakes in the solutions of the shipped challenges fail, and the verdict names the mistake.

A mistake is a line left out, a line twice, or a number that is one more or less (an angle ten degrees). The
verdicts are in the files ``solutions/NAME.verdicts``: read them after a change. ``ACCEPT_OUTPUT=1`` writes
them anew.
"""

import os
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
from msgspec.structs import replace

from donnie_tui.bootstrap import Judge
from donnie_tui.core.describe import verdict_in_words
from donnie_tui.core.events import Event, Moved, Spoke, Turned
from donnie_tui.i18n.words import Words
from donnie_tui.settings.settings import Settings
from donnie_tui.world.loading import choose_challenge
from language.parser import parse
from worlds import challenges

VERDICTS = Path(__file__).parent / "solutions"
ANGLES = {45, 90, 180, 270}
ZERO = "the second time the robot walks 0 steps"
REACH = "the gripper reaches the box from there, too"
TOLERATED = {
    "to_the_cone": {"1. FW DISTANCE F - 1, twice": ZERO},
    "along_the_corridor": {"1. FW DISTANCE F - 2, as FW DISTANCE F - 1": "the goal is to pass near the post"},
    "pink_crystal": {
        "2. FW 46, as FW 45": "the crystal is 3 steps wide, and ahead from there, too",
        "2. FW 46, as FW 47": "the crystal is 3 steps wide, and ahead from there, too",
        "7. FW DISTANCE F - 1, twice": ZERO,
    },
    "maze": {
        "3. WHILE DISTANCE F < 3 DO, as WHILE DISTANCE F < 4 DO": "a wall is at 2 steps, the box at 5",
        "6. IF DISTANCE F > 5 THEN, as IF DISTANCE F > 6 THEN": "the box is at 5 steps, a free way at 10",
    },
    "push_the_orange": {"1. FW 20, as FW 19": "bob is 20 steps wide, and pushes with his teeth"},
    "tidy_up": {"3. VAR way = DISTANCE F - 1, as VAR way = DISTANCE F - 0": REACH},
    "meet": {"1. FW DISTANCE F - 1, twice": ZERO},
    "through_the_door": {
        **dict.fromkeys(("1. FW 6, as FW 5", "1. FW 6, as FW 7"), "the door is 2 steps wider than Donnie"),
        **dict.fromkeys(("3. FW 18, as FW 17", "3. FW 18, as FW 19"), "the ball is 3 steps wide"),
        "5. FW DISTANCE F - 1, twice": ZERO,
    },
    "second_crossing": {
        **dict.fromkeys(("1. FW 48, as FW 47", "1. FW 48, as FW 49"), "the street is 9 steps wide"),
        "3. FW DISTANCE F - 1, twice": ZERO,
    },
    "orange_ball": {
        "2. TR 60, twice": "it turns until the ball is in view, however far each time",
        "5. TL 2, twice": "the ball is then 1 or 2 degrees further aside, and wide enough",
    },
}
"""The mistakes that change nothing of what the goals ask, apart from angles, and why."""


def mistakes(text: str) -> Iterator[tuple[str, str]]:
    """What is wrong, and the program."""
    lines = text.splitlines()
    for at, line in enumerate(lines):
        before, after = lines[:at], lines[at + 1 :]
        changed = [("left out", []), ("twice", [line, line])]
        for number in re.finditer(r"\d+", line):
            step = 10 if int(number[0]) in ANGLES else 1
            for value in (int(number[0]) - step, int(number[0]) + step):
                other = f"{line[: number.start()]}{value}{line[number.end() :]}"
                changed.append((f"as {other}", [other]))
        for what, instead in changed:
            program = "\n".join([*before, *instead, *after])
            if parse(program).program is not None:
                yield f"{at + 1}. {line}, {what}", program


def verdicts_of(name: str) -> dict[str, str]:
    """By mistake; empty if the program still solves the challenge."""
    found, words, settings = challenges.find(name), Words("en"), Settings()
    judge = Judge(choose_challenge(name, words), words, settings)
    said = {}
    for what, program in mistakes(found.solution().read_text(encoding="utf-8")):
        judged = judge.programs(program)
        is_solved = judged[-1].is_solved
        said[what] = "" if is_solved else verdict_in_words(judged, words)
    return said


@pytest.mark.slow
@pytest.mark.parametrize("name", challenges.names())
def test_each_small_mistake_fails_for_the_reason_that_the_verdict_says(name: str) -> None:
    said = verdicts_of(name)
    text = "".join(f"{what}: {verdict or 'Solved.'}\n" for what, verdict in said.items())
    file = VERDICTS / f"{name}.verdicts"
    if os.environ.get("ACCEPT_OUTPUT"):
        file.write_text(text, encoding="utf-8")

    assert text == file.read_text(encoding="utf-8")
    solved = {what for what, verdict in said.items() if not verdict and not is_angle(what)}
    assert solved == set(TOLERATED.get(name, {}))


@pytest.mark.parametrize(
    "name", [each for each in challenges.names() if challenges.ladders()[each] == "looking"]
)
def test_what_solves_one_start_of_a_looking_challenge_does_not_solve_the_others(name: str) -> None:
    """The commands that the solution carries out at one start, with their numbers, fail at another one."""
    found, words, settings = challenges.find(name), Words("en"), Settings()
    world, solution = choose_challenge(name, words), found.solution().read_text(encoding="utf-8")
    judge = Judge(world, words, settings)
    for start in judge.starts:
        events = judge.try_from(start, solution)
        blind = "\n".join(commands(each.event for each in events))
        free = replace(found, rules=replace(found.rules, required=()))
        others = Judge(replace(world, challenge=free), words, settings)
        verdicts = [others.programs(blind, (each,))[0] for each in others.starts]
        assert any(each.is_solved for each in verdicts)
        assert not all(each.is_solved for each in verdicts), blind


def commands(events: Iterable[Event]) -> Iterator[str]:
    """What was carried out, without sensors."""
    for event in events:
        match event:
            case Moved():
                yield f"{'FW' if event.forward else 'BW'} {event.walked}"
            case Turned():
                yield f"{'TR' if event.right else 'TL'} {event.turned}"
            case Spoke():
                yield f"SPEAK {event.text}"


def is_angle(mistake: str) -> bool:
    """Whether it only turns ten degrees too far or not far enough: most goals are about places."""
    number = re.search(r", as (?:TR|TL|STORE) \[?\d+", mistake)
    return number is not None
