"""Several robots on the screen: keys and typed lines reach the selected one, the others continue."""

import pytest

from devices.ports.robot import Pose
from donnie_tui.core.events import Error, Outcome, RunEnded
from donnie_tui.core.run_state import RunState
from donnie_tui.tui.event_queue import RunFinished
from tests.tui.conftest import WAITING


async def test_nothing_is_looked_at_again_and_again_for_a_robot_that_stands(open_screen):
    async with open_screen(WAITING, speed=1.0, world="two_robots") as screen:
        polling = screen.app.controller.run_view.polling
        await screen.press("f5")
        await screen.until(lambda: polling.is_on, "alice runs")

        await screen.type_line("ROBOT bob")
        await screen.shows("Now you talk to bob.")
        assert not polling.is_on
        assert screen.app.controller.ctx.runs.state is RunState.READY
        await screen.type_line("SPEAK 7")
        await screen.shows("bob: 7")
        await screen.idle()

        await screen.type_line("ROBOT alice")
        await screen.shows("Now you talk to alice.")
        assert polling.is_on

        await screen.type_line("STOP ALL")
        await screen.reaches(RunState.READY)
        assert not polling.is_on


async def test_an_end_that_comes_once_another_robot_is_talked_to_is_not_that_ones(open_screen):
    """It was on its way to the screen when the other one was chosen."""
    async with open_screen(world="two_robots") as screen:
        await screen.type_line("ROBOT bob")
        await screen.shows("Now you talk to bob.")
        rows, mistake = screen.map_rows(), Error("syntax", 2, 5, "What?", None)
        end = RunEnded(Outcome.FAILED, Pose(1.0, 1.0, 0.0), {}, 0.0)

        screen.app.post_message(RunFinished(end, (mistake,), "alice"))
        await screen.type_line("WHERE")
        await screen.until(lambda: any(line.startswith("bob: ") for line in screen.log), "where bob is")

        assert screen.map_rows() == rows
        assert screen.app.controller.ctx.errors.now is None


async def test_ctrl_c_stops_all_robots_the_key_for_stop_the_chosen_one(open_screen):
    async with open_screen(WAITING, speed=1.0, world="two_robots") as screen:
        team = screen.app.controller.donnie.team
        await screen.type_line("ROBOT bob")
        await screen.shows("Now you talk to bob.")
        await screen.type_line("TOGETHER")
        await screen.until(lambda: len(team.running) == 2, "both run")
        await screen.reaches(RunState.RUNNING)

        await screen.press("f8")
        await screen.until(lambda: [each.name for each in team.running] == ["alice"], "one runs")

        await screen.press("ctrl+c")
        await screen.until(lambda: not team.running, "none runs")


async def test_the_map_is_that_of_the_robot_that_is_talked_to(open_screen):
    async with open_screen("FW 3", world="two_robots") as screen:
        await screen.press("f5")
        await screen.shows("The program is done.")
        await screen.type_line("ROBOT bob")
        await screen.shows("Now you talk to bob.")

        scene = screen.main.map.scale.scene
        assert [each.name for each in scene.picture.things if each.is_robot] == ["alice"]
        assert list(scene.others) == ["alice"]
        assert scene.place(scene.others["alice"]) == (0, 3)
        bob = screen.app.controller.donnie.session.pose
        assert scene.place(scene.robot) == (round(bob.x), round(bob.y))

        await screen.type_line("MAP")
        await screen.shows("Alice, ")
        assert not any(line.startswith("Bob,") for line in screen.log)


async def test_a_robot_that_is_not_talked_to_stays_on_the_map_where_it_went(open_screen):
    async with open_screen("FW 3", world="two_robots") as screen:
        await screen.press("f5")
        await screen.shows("The program is done.")
        await screen.type_line("ROBOT bob")
        await screen.shows("Now you talk to bob.")
        await screen.press("f5")
        await screen.until(lambda: sum("program is done" in line for line in screen.log) == 2, "bob is done")

        scene = screen.main.map.scale.scene
        assert scene.place(scene.others["alice"]) == (0, 3)


async def test_lines_of_a_robot_have_its_name(open_screen):
    async with open_screen(WAITING, speed=1.0, world="two_robots") as screen:
        await screen.status_has("alice at 0, 0 facing north.")
        await screen.type_line("ROBOT bob")
        await screen.shows("Now you talk to bob.")
        await screen.until(lambda: "bob at 0, 30 facing south." in screen.status, "the status line")
        await screen.press("f5")
        await screen.reaches(RunState.RUNNING)
        await screen.press("f8")
        await screen.shows("bob: Stopped")
        await screen.type_line("RESET")
        await screen.shows("bob: I am back at the start.")
        await screen.run("FW 1")
        await screen.shows("bob: The program is done.")


async def test_robots_are_described_and_listed_to_choose_from(open_screen):
    async with open_screen(world="two_robots") as screen:
        await screen.type_line("ROBOTS")
        await screen.until(lambda: "Robots of this world" in screen.text, "the list")
        await screen.shows("bob: 0, 30, facing south.")
        await screen.press("down", "enter")
        await screen.shows("Now you talk to bob.")


async def test_a_world_without_a_robot_gets_a_donnie_and_the_log_says_so(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(world="empty") as screen:
        await screen.shows("The world empty has no robot, so I put Donnie in, at")
        await screen.run("FW 2")


async def test_the_verdict_comes_once_a_robot_has_ended_that_is_not_talked_to(open_screen, tmp_path):
    file = tmp_path / "it.toml"
    file.write_text(
        'format = 1\nworld = "two_robots"\n[en]\ntitle = "T"\ntask = "Do."\n[[goal]]\nsaid = "hello"\n'
    )
    async with open_screen('WAIT 1\nSPEAK "hello"', speed=1.0, world=f"challenge:{file}") as screen:
        await screen.press("f5")
        await screen.type_line("ROBOT bob")
        await screen.shows("Now you talk to bob.")

        await screen.shows("Solved, in 2 commands.")


@pytest.mark.parametrize(
    ("language", "title"),
    [("en", "alice: Map: Two robots"), ("pt", "alice: Mapa: Dois robôs"), ("es", "alice: Mapa: Dos robots")],
)
async def test_a_title_that_is_too_long_leaves_out_a_part_and_is_not_cut(open_screen, language, title):
    async with open_screen(world="two_robots", language=language) as screen:
        assert f"{title}  " in screen.text.splitlines()[0]
        await screen.pilot.resize_terminal(120, 40)
        await screen.painted()

        assert f"{title}, 31 " in screen.text.splitlines()[0]
