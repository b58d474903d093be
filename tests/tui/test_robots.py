"""Several robots on the screen: keys and typed lines reach the selected one, the others continue."""

from devices.ports.robot import Pose
from donnie_tui.core.events import Error, Outcome, RunEnded
from donnie_tui.core.run_state import RunState
from donnie_tui.tui.event_queue import RunFinished
from tests.tui.conftest import WAITING


async def test_nothing_is_looked_at_again_and_again_for_a_robot_that_stands(work):
    async with work(WAITING, speed=1.0, world="two_robots") as desk:
        polling = desk.app.controller.run_view.polling
        await desk.press("f5")
        await desk.until(lambda: polling.is_on, "alice runs")

        await desk.type_line("ROBOT bob")
        await desk.shows("You talk to bob.")
        assert not polling.is_on
        assert desk.app.controller.ctx.runs.state is RunState.READY
        await desk.type_line("SPEAK 7")
        await desk.shows("bob: 7")
        await desk.idle()

        await desk.type_line("ROBOT alice")
        await desk.shows("You talk to alice.")
        assert polling.is_on

        await desk.type_line("STOP ALL")
        await desk.doing(RunState.READY)
        assert not polling.is_on


async def test_an_end_that_comes_once_another_robot_is_talked_to_is_not_that_ones(work):
    """It was on its way to the screen when the other one was chosen."""
    async with work(world="two_robots") as desk:
        await desk.type_line("ROBOT bob")
        await desk.shows("You talk to bob.")
        rows, mistake = desk.map_rows(), Error("syntax", 2, 5, "What?", None)
        end = RunEnded(Outcome.FAILED, Pose(1.0, 1.0, 0.0), {}, 0.0)

        desk.app.post_message(RunFinished(end, (mistake,), "alice"))
        await desk.type_line("WHERE")
        await desk.until(lambda: any(line.startswith("bob: ") for line in desk.log), "where bob is")

        assert desk.map_rows() == rows
        assert desk.app.controller.ctx.errors.now is None


async def test_ctrl_c_stops_all_robots_the_key_for_stop_the_chosen_one(work):
    async with work(WAITING, speed=1.0, world="two_robots") as desk:
        team = desk.app.controller.donnie.team
        await desk.type_line("ROBOT bob")
        await desk.shows("You talk to bob.")
        await desk.type_line("TOGETHER")
        await desk.until(lambda: len(team.running) == 2, "both run")
        await desk.doing(RunState.RUNNING)

        await desk.press("f8")
        await desk.until(lambda: [each.name for each in team.running] == ["alice"], "one runs")

        await desk.press("ctrl+c")
        await desk.until(lambda: not team.running, "nobody runs")


async def test_the_map_is_that_of_the_robot_that_is_talked_to(work):
    async with work("FW 3", world="two_robots") as desk:
        await desk.press("f5")
        await desk.shows("The program is done.")
        await desk.type_line("ROBOT bob")
        await desk.shows("You talk to bob.")

        scene = desk.place.map.scale.scene
        assert [each.name for each in scene.picture.things if each.is_robot] == ["alice"]
        assert list(scene.others) == ["alice"]
        assert scene.place(scene.others["alice"]) == (0, 3)
        bob = desk.app.controller.donnie.session.pose
        assert scene.place(scene.robot) == (round(bob.x), round(bob.y))

        await desk.type_line("MAP")
        await desk.shows("Alice, ")
        assert not any(line.startswith("Bob,") for line in desk.log)


async def test_a_robot_that_is_not_talked_to_stays_on_the_map_where_it_went(work):
    async with work("FW 3", world="two_robots") as desk:
        await desk.press("f5")
        await desk.shows("The program is done.")
        await desk.type_line("ROBOT bob")
        await desk.shows("You talk to bob.")
        await desk.press("f5")
        await desk.until(lambda: sum("program is done" in line for line in desk.log) == 2, "bob is done")

        scene = desk.place.map.scale.scene
        assert scene.place(scene.others["alice"]) == (0, 3)


async def test_lines_of_a_robot_have_its_name(work):
    async with work(WAITING, speed=1.0, world="two_robots") as desk:
        assert "alice at 0, 0 facing north." in desk.status
        await desk.type_line("ROBOT bob")
        await desk.shows("You talk to bob.")
        await desk.until(lambda: "bob at 0, 30 facing south." in desk.status, "the status line")
        await desk.press("f5")
        await desk.doing(RunState.RUNNING)
        await desk.press("f8")
        await desk.shows("bob: Stopped")
        await desk.type_line("RESET")
        await desk.shows("bob: I am back at the start.")
        await desk.run("FW 1")
        await desk.shows("bob: The program is done.")


async def test_robots_are_described_and_listed_to_choose_from(work):
    async with work(world="two_robots") as desk:
        await desk.type_line("ROBOTS")
        await desk.until(lambda: "Robots of this world" in desk.screen, "the list")
        await desk.shows("bob: 0, 30, facing south.")
        await desk.press("down", "enter")
        await desk.shows("You talk to bob.")
