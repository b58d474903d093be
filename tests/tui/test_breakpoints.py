"""Programs hold at their breakpoints, which move with their lines. Steps back start there."""

import pytest


@pytest.fixture(autouse=True)
def own_settings(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))


# --- breakpoints and going back


async def test_a_program_holds_at_its_breakpoints(work):
    async with work('FW 1\nSPEAK "two"\nFW 1\nSPEAK "four"') as desk:
        for line in (2, 4):
            desk.place.editor.go_to(line)
            await desk.press("ctrl+b")
        await desk.shows("Breakpoint at line 4.")
        await desk.press("f5")
        await desk.shows('Line 2: SPEAK "two"')
        assert ">B2" in desk.screen
        await desk.press("f6")
        await desk.shows('Line 4: SPEAK "four"')
        assert not any(line == "four" for line in desk.log)
        desk.place.editor.go_to(4)
        await desk.press("ctrl+b", "f6")
        await desk.shows("The program is done.")


async def test_a_breakpoint_goes_with_its_line(work):
    async with work("FW 1\nFW 2\nFW 3") as desk:
        desk.place.editor.breakpoints = frozenset({2, 3})
        desk.place.editor.move_cursor((0, 4))
        await desk.press("enter")
        assert desk.place.editor.breakpoints == {3, 4}
        await desk.press("ctrl+a", "delete")
        assert desk.place.editor.breakpoints <= {1}


async def test_a_step_back_shows_the_earlier_place_and_a_run_continues_from_the_current(work):
    async with work("FW 3\nTR 90\nFW 2") as desk:
        await desk.press("f5")
        await desk.shows("The program is done.")
        assert desk.app.controller.display.scene.robot == desk.app.controller.display.scene.cell_at(2, 3)
        for _ in range(8):
            desk.app.controller.do("step_back")
        await desk.shows("Back: FW 3.")
        assert desk.app.controller.display.scene.robot == desk.app.controller.display.scene.cell_at(0, 0)
        await desk.type_line("FW 1")
        await desk.shows("I walked 1 step forward.")
        await desk.idle()

        assert desk.app.controller.display.scene.robot == desk.app.controller.display.scene.cell_at(3, 3)


# --- breakpoints of each program


async def test_breakpoints_are_there_again_at_the_next_start(work, tmp_path):
    path = tmp_path / "walk.gd"
    path.write_text("FW 1\nFW 2\nFW 3\n", encoding="utf-8")
    async with work(file=path) as desk:
        desk.place.editor.go_to(2)
        await desk.press("ctrl+b")
        await desk.shows("Breakpoint at line 2.")
    async with work(file=path) as desk:
        await desk.shows("Breakpoints: 2.")
        assert desk.place.editor.breakpoints == {2}
        await desk.press("f5")
        await desk.shows("Line 2: FW 2")


async def test_each_open_program_has_its_own_breakpoints(work):
    async with work("FW 1\nFW 2") as desk:
        await desk.press("ctrl+b")
        await desk.shows("Breakpoint at line 1.")
        workspace = desk.app.controller.workspace
        workspace.turn_to(workspace.add_document())
        assert desk.place.editor.breakpoints == frozenset()
        workspace.turn_to(workspace.documents[0])
        assert desk.place.editor.breakpoints == {1}
