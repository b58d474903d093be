"""The world as the selected robot finds it now."""

from __future__ import annotations

from donnie_tui.bootstrap import assemble
from donnie_tui.settings.settings import Settings
from tests.timeouts import TIMEOUT


def test_the_other_robot_is_at_its_current_place_and_the_robot_itself_is_no_thing() -> None:
    donnie = assemble(Settings(world="two_robots", speech="off", sound=False, speed=None), terminal=True)
    try:
        assert donnie.session.start("FW 2", "a.gd").wait(TIMEOUT)
        donnie.team.choose("bob")
        robots = {thing.name: (thing.x, thing.y) for thing in donnie.picture_now().things if thing.is_robot}
    finally:
        donnie.close()
    assert list(robots) == ["alice"]
    x, y = robots["alice"]
    assert (round(x), round(y)) == (0, 2)


def test_the_picture_at_the_start_is_that_of_the_file() -> None:
    donnie = assemble(Settings(world="living_room", speech="off", sound=False), terminal=True)
    try:
        assert donnie.picture_now() == donnie.picture()
    finally:
        donnie.close()
