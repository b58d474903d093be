"""Programs hold at their breakpoints, which move with their lines. Steps back start there."""


# --- breakpoints and going back


async def test_a_program_holds_at_its_breakpoints(open_screen):
    async with open_screen('FW 1\nSPEAK "two"\nFW 1\nSPEAK "four"') as screen:
        for line in (2, 4):
            screen.main.editor.go_to(line)
            await screen.press("ctrl+b")
        await screen.shows("Breakpoint at line 4.")
        await screen.press("f5")
        await screen.shows('Line 2: SPEAK "two"')
        assert ">B2" in screen.text
        await screen.press("f6")
        await screen.shows('Line 4: SPEAK "four"')
        assert not any(line == "four" for line in screen.log)
        screen.main.editor.go_to(4)
        await screen.press("ctrl+b", "f6")
        await screen.shows("The program is done.")


async def test_a_breakpoint_goes_with_its_line(open_screen):
    async with open_screen("FW 1\nFW 2\nFW 3") as screen:
        screen.main.editor.breakpoints = frozenset({2, 3})
        screen.main.editor.move_cursor((0, 4))
        await screen.press("enter")
        assert screen.main.editor.breakpoints == {3, 4}
        await screen.press("ctrl+a", "delete")
        assert screen.main.editor.breakpoints <= {1}


async def test_a_step_back_shows_the_earlier_place_and_a_run_continues_from_the_current(open_screen):
    async with open_screen("FW 3\nTR 90\nFW 2") as screen:
        await screen.press("f5")
        await screen.shows("The program is done.")
        assert screen.app.controller.display.scene.robot == screen.app.controller.display.scene.cell_at(2, 3)
        for _ in range(8):
            screen.app.controller.do("step_back")
        await screen.shows("Before FW 3:")
        assert screen.app.controller.display.scene.robot == screen.app.controller.display.scene.cell_at(0, 0)
        await screen.type_line("FW 1")
        await screen.shows("I walked 1 step forward.")
        await screen.idle()

        assert screen.app.controller.display.scene.robot == screen.app.controller.display.scene.cell_at(3, 3)


# --- breakpoints of each program


async def test_breakpoints_are_there_again_at_the_next_start(open_screen, tmp_path):
    path = tmp_path / "walk.gd"
    path.write_text("FW 1\nFW 2\nFW 3\n", encoding="utf-8")
    async with open_screen(file=path) as screen:
        screen.main.editor.go_to(2)
        await screen.press("ctrl+b")
        await screen.shows("Breakpoint at line 2.")
    async with open_screen(file=path) as screen:
        await screen.shows("Breakpoints: 2.")
        assert screen.main.editor.breakpoints == {2}
        await screen.press("f5")
        await screen.shows("Line 2: FW 2")


async def test_each_open_program_has_its_own_breakpoints(open_screen):
    async with open_screen("FW 1\nFW 2") as screen:
        await screen.press("ctrl+b")
        await screen.shows("Breakpoint at line 1.")
        workspace = screen.app.controller.workspace
        workspace.turn_to(workspace.add_document())
        assert screen.main.editor.breakpoints == frozenset()
        workspace.turn_to(workspace.documents[0])
        assert screen.main.editor.breakpoints == {1}
