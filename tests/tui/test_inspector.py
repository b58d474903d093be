"""The distances in the inspector: those of the place where the robot is, whether its program asked or not."""

import re

import pytest

from donnie_tui.core.events import Sensed
from donnie_tui.core.run_state import RunState
from donnie_tui.i18n.words import Words
from donnie_tui.tui.pane_text import inspector_lines


def ahead(desk) -> int:
    """What the inspector says of it."""
    return int(re.search(r"^ahead: (\d+)$", "\n".join(desk.place.inspector.lines), re.MULTILINE)[1])


def known(desk) -> list[str]:
    """What the inspector should say, in its order."""
    distances = desk.app.controller.donnie.session._robot.known_distances()
    return [str(distances[bearing]) for bearing in sorted(distances, key=lambda each: each.value)]


def shown(desk) -> list[str]:
    lines = desk.place.inspector.lines
    first = lines.index("Distances now:") + 1
    return [line.split(": ")[1] for line in lines[first : first + 6]]


async def test_the_distances_are_there_before_anything_runs(work):
    async with work(world="living_room", size=(120, 40)) as desk:
        lines = desk.place.inspector.lines

        assert lines[1:4] == ("Distances now:", "ahead: 24", "ahead right: 35")
        assert shown(desk) == known(desk)


async def test_the_distances_follow_a_moving_robot_and_are_right_where_it_stops(work):
    async with work("FW 30", world="corridor", size=(120, 40), speed=2.0) as desk:
        start = ahead(desk)
        await desk.press("f5")
        await desk.until(lambda: ahead(desk) <= start - 2, "they follow")
        assert desk.app.controller.ctx.runs.state is RunState.RUNNING

        await desk.press("f8")
        await desk.idle()

        assert shown(desk) == known(desk)


async def test_the_distances_are_right_where_a_program_holds_and_where_it_ends(work):
    async with work("FW 3\nTR 90\nFW 2", world="living_room", size=(120, 40)) as desk:
        start = shown(desk)
        desk.place.editor.go_to(3)
        await desk.press("f10")
        await desk.shows("Line 3: FW 2")
        held = shown(desk)
        assert held == known(desk) != start

        await desk.press("f6")
        await desk.shows("The program is done.")

        assert shown(desk) == known(desk) != held


async def test_the_distances_are_those_of_the_selected_robot(work):
    async with work(world="two_robots", size=(120, 40)) as desk:
        await desk.type_line("FW 4")
        await desk.shows("alice: I walked 4 steps forward.")
        await desk.idle()
        of_alice = shown(desk)
        await desk.type_line("ROBOT bob")
        await desk.shows("You talk to bob.")

        await desk.until(lambda: shown(desk) == known(desk), "those of bob")
        assert shown(desk) != of_alice


async def test_the_distances_change_when_another_robot_approaches(work):
    async with work("REPEAT 9 TIMES FW 1 END REPEAT", world="two_robots", size=(120, 40), speed=5.0) as desk:
        before = ahead(desk)
        await desk.type_line("ROBOT bob")
        await desk.shows("You talk to bob.")
        await desk.press("f5")
        await desk.doing(RunState.RUNNING)
        await desk.type_line("ROBOT alice")
        await desk.shows("You talk to alice.")

        await desk.until(lambda: ahead(desk) == before - 9, "bob has come near")


async def test_a_robot_without_rangers_has_no_distances(work):
    async with work(world="bigbob1", size=(120, 40)) as desk:
        assert desk.place.inspector.lines == ("No variables.",)


async def test_a_reader_is_not_given_each_distance_of_a_moving_robot(work):
    async with work("FW 30", world="corridor", plain=True, speed=5.0) as desk:
        session = desk.app.controller.donnie.session
        heard: list[Sensed] = []
        desk.app.controller.donnie.team.stream.subscribe(
            lambda it: heard.append(it.event) if isinstance(it.event, Sensed) else None
        )
        await desk.press("f5")
        await desk.until(lambda: session.pose.y > 3, "the robot is on its way")
        assert not any(each.distances != heard[0].distances for each in heard)
        await desk.until(lambda: "Distances now:" not in desk.place.inspector.lines, "they are not shown")

        await desk.press("f8")
        await desk.idle()

        assert shown(desk) == known(desk)


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (10**18 - 1, "999999999999999999"),
        (2**63, "922337... (19)"),
        (-(10**20 - 1), "-999999... (20)"),
        (10**4300 - 1, "999999... (4300)"),
    ],
    ids=["whole", "19", "20", "4300"],
)
def test_a_long_number_has_its_first_digits_and_how_many_there_are(value, shown):
    assert inspector_lines((), {"a": value}, {}, (), (), Words())[1] == f"a is {shown}"
