"""Running, stopping, pausing, from keys and typed words."""

from donnie_tui.core.run_state import RunState
from tests.tui.conftest import COMPUTING, WAITING

SQUARE = 'REPEAT 2 TIMES\nFW 2\nTR 90\nEND REPEAT\nSPEAK "done"'


async def test_f5_and_esc_run_the_program(work):
    async with work(SQUARE) as desk:
        for count, key in enumerate(("f5", "escape"), 1):
            await desk.press(key)
            await desk.until(lambda n=count: desk.log.count("The program is done.") == n, key)
            await desk.idle()

        assert [line for line in desk.log if line in ("done", "I walked 2 steps forward.")] == [
            "I walked 2 steps forward.",
            "I walked 2 steps forward.",
            "done",
        ] * 2


async def test_the_map_shows_the_trail_the_start_and_where_the_robot_looks(work):
    async with work() as desk:
        await desk.run("FW 3 TR 90 FW 2")

        rows = [row.strip(".") for row in desk.map_rows() if row.strip(".")]
        assert rows == ["oo>", "o", "o", "A"]


async def test_a_typed_command_goes_on_where_the_robot_stands_with_the_variables_that_there_are(work):
    async with work() as desk:
        await desk.type_line("VAR a = 3 FW 2")
        await desk.shows("I walked 2 steps forward.")
        await desk.idle()
        await desk.type_line("FW a")
        await desk.shows("I walked 3 steps forward.")

        assert "> FW a" in desk.log
        assert "Donnie at 0, 5 facing north." in desk.status


def way(desk):
    grid = desk.app.controller.display.scene.grid
    return grid.start, grid.robot


async def test_a_program_that_cant_run_leaves_the_robot_its_trail_and_its_variables(work):
    async with work("FWD 2", speed=None) as desk:
        await desk.type_line("VAR a = 3 FW a")
        await desk.shows("I walked 3 steps forward.")
        await desk.idle()
        way_there = way(desk)
        await desk.type_line("watch a")
        await desk.press("f5")
        await desk.shows("I do not know FWD.")
        await desk.idle()

        assert "Donnie at 0, 3 facing north." in desk.status
        assert way(desk) == way_there
        assert "a is 3." not in desk.log
        await desk.type_line("SPEAK a")
        await desk.shows("3")


async def test_esc_in_the_command_line_runs_the_unfinished_line(work):
    async with work() as desk:
        desk.place.command_line.focus()
        desk.place.command_line.value = "FW 2"
        await desk.press("escape")
        await desk.shows("I walked 2 steps forward.")

        assert desk.place.command_line.value == ""


async def test_f8_stops_a_program_without_end_and_says_where(work):
    async with work(COMPUTING) as desk:
        await desk.press("f5")
        await desk.doing(RunState.RUNNING)
        await desk.until(lambda: desk.app.controller.ctx.runs.frames, "a line being run")
        await desk.press("f8")
        await desk.shows("Stopped at line ")

        await desk.idle()


async def test_ctrl_c_stops_while_something_runs(work):
    async with work(WAITING, speed=1.0) as desk:
        await desk.press("f5")
        await desk.doing(RunState.RUNNING)
        await desk.press("ctrl+c")

        await desk.shows("Stopped")


async def test_ctrl_c_copies_while_nothing_runs(work):
    async with work("FW 1") as desk:
        await desk.press("ctrl+a", "ctrl+c")
        await desk.pilot.pause()

        assert desk.app.clipboard == "FW 1"
        assert not any("running" in line for line in desk.log)


async def test_pause_holds_the_program_marks_its_line_and_goes_on(work):
    async with work(WAITING, speed=1.0) as desk:
        await desk.press("f5")
        await desk.doing(RunState.RUNNING)
        await desk.press("f6")
        await desk.doing(RunState.PAUSED)
        await desk.shows("Paused at line ")
        line = desk.app.controller.ctx.runs.frames[0].line
        await desk.until(lambda: f"> {line}  " in desk.screen, "the mark")
        assert "Paused" in desk.status
        assert desk.place.editor.line == line

        await desk.press("f6")
        await desk.doing(RunState.RUNNING)


async def test_reset_puts_the_robot_back_and_forgets_the_variables(work):
    async with work() as desk:
        await desk.type_line("VAR a = 3 FW a")
        await desk.shows("I walked 3 steps forward.")
        await desk.idle()
        await desk.press("ctrl+r")
        await desk.shows("I am back at the start.")
        await desk.until(lambda: "No variables." in desk.place.inspector.lines, "no variables")

        assert "Donnie at 0, 0 facing north." in desk.status
        assert "o" not in "".join(desk.map_rows())


async def test_a_mistake_is_reported_and_the_cursor_moves_to_its_place(work):
    async with work("FW 1\nTR 90\n  FWD 3") as desk:
        await desk.press("f5")
        await desk.shows("Error, line 3, column 3")

        assert desk.place.editor.cursor_location == (2, 2)
        assert "Did you mean FW?" in desk.log
        assert "I walked 1 step forward." not in desk.log


async def test_a_mistake_in_a_typed_command_leaves_the_program_alone(work):
    async with work("FW 1\nFW 2") as desk:
        await desk.type_line("FWD 3")
        await desk.shows("Error, line 1")

        assert desk.place.editor.cursor_location == (0, 0)


async def test_quit_in_the_program_is_a_mistake_and_in_the_command_line_leaves(work):
    async with work("QUIT") as desk:
        await desk.press("f5")
        await desk.shows("Error, line 1")
        desk.load("")
        await desk.type_line("quit")
        await desk.until(lambda: not desk.app.is_running, "the end")

        assert desk.app.return_code == 0


async def test_a_program_that_talks_without_end_leaves_the_keys_alive(work):
    async with work('WHILE 1 == 1 DO\nSPEAK "again and again"\nEND WHILE') as desk:
        await desk.press("f5")
        await desk.shows("again and again")
        await desk.press("f8")

        await desk.shows("Stopped at line")


async def test_the_inspector_names_variables_calls_and_readings(work):
    async with work("VAR wide = 7\nVAR d = DISTANCE F\nFW 1", size=(120, 40)) as desk:
        desk.place.editor.go_to(3)
        await desk.press("f10")
        await desk.shows("Line 3: FW 1")
        await desk.until(lambda: "distance ahead: 60" in desk.place.inspector.lines, "the reading")

        assert "wide is 7" in desk.place.inspector.lines
        assert "program, line 3" in desk.place.inspector.lines


def painted(widget, monkeypatch) -> list[int]:
    """The rows that are painted from now on."""
    rows: list[int] = []
    own = widget.render_line
    monkeypatch.setattr(widget, "render_line", lambda y: rows.append(y) or own(y))
    return rows


async def test_a_look_at_a_program_paints_only_what_is_new(work, monkeypatch):
    """Five times a second: over a slow line each row that is painted in vain is felt."""
    async with work("VAR x = 1\nx = 2\nx = 3\nSPEAK x", size=(120, 40)) as desk:
        await desk.press("f7", "f9", "f9")
        await desk.shows("Line 2")
        await desk.press("f9")
        await desk.shows("Line 3")
        await desk.painted()
        place = desk.place
        text, variables, log = (
            painted(each, monkeypatch) for each in (place.editor, place.inspector, place.log_rows)
        )

        desk.app.controller.display.update()
        await desk.painted()
        assert (text, variables, log) == ([], [], [])

        lines = list(place.inspector.lines)
        place.inspector.show([lines[0], f"{lines[1]}0", *lines[2:]])
        await desk.until(lambda: {place.inspector.row, 1} <= set(variables), "the rows of variables")
        assert set(variables) == {place.inspector.row, 1}
        assert text == []

        shown = len(place.log_rows.lines)
        place.log_lines([("one more line", "")])
        await desk.until(lambda: shown in log, "the row of the log")
        assert set(log) == {shown}
