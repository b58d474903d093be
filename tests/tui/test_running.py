"""Running, stopping, pausing, from keys and typed words."""

import pytest
from textual import events

from donnie_tui.core.run_state import RunState
from tests.tui.conftest import COMPUTING, WAITING

SQUARE = 'REPEAT 2 TIMES\nFW 2\nTR 90\nEND REPEAT\nSPEAK "done"'


async def test_f5_and_esc_run_the_program(open_screen):
    async with open_screen(SQUARE) as screen:
        for count, key in enumerate(("f5", "escape"), 1):
            await screen.press(key)
            await screen.until(lambda n=count: screen.log.count("The program is done.") == n, key)
            await screen.idle()

        assert [line for line in screen.log if line in ("done", "I walked 2 steps forward.")] == [
            "I walked 2 steps forward.",
            "I walked 2 steps forward.",
            "done",
        ] * 2


async def test_the_map_shows_the_trail_the_start_and_where_the_robot_looks(open_screen):
    async with open_screen() as screen:
        await screen.run("FW 3 TR 90 FW 2")

        rows = [row.strip(".") for row in screen.map_rows() if row.strip(".")]
        assert rows == ["oo>", "o", "o", "A"]


async def test_a_typed_command_goes_on_where_the_robot_stands_with_the_variables_that_there_are(open_screen):
    async with open_screen() as screen:
        await screen.type_line("VAR a = 3 FW 2")
        await screen.shows("I walked 2 steps forward.")
        await screen.idle()
        await screen.type_line("FW a")
        await screen.shows("I walked 3 steps forward.")

        await screen.shows("> FW a")
        await screen.status_has("Donnie at 0, 5 facing north.")


def way(screen):
    grid = screen.app.controller.display.scene.grid
    return grid.start, grid.robot


async def test_a_program_that_cant_run_leaves_the_robot_its_trail_and_its_variables(open_screen):
    async with open_screen("FWD 2", speed=None) as screen:
        await screen.type_line("VAR a = 3 FW a")
        await screen.shows("I walked 3 steps forward.")
        await screen.idle()
        way_there = way(screen)
        await screen.type_line("watch a")
        await screen.press("f5")
        await screen.shows("I do not know FWD.")
        await screen.idle()

        await screen.status_has("Donnie at 0, 3 facing north.")
        assert way(screen) == way_there
        assert "a is 3." not in screen.log
        await screen.type_line("SPEAK a")
        await screen.shows("3")


async def test_esc_in_the_command_line_runs_the_unfinished_line(open_screen):
    async with open_screen() as screen:
        screen.main.command_line.focus()
        screen.main.command_line.value = "FW 2"
        await screen.press("escape")
        await screen.shows("I walked 2 steps forward.")

        assert screen.main.command_line.value == ""


async def test_f8_stops_a_program_without_end_and_says_where(open_screen):
    async with open_screen(COMPUTING) as screen:
        await screen.press("f5")
        await screen.reaches(RunState.RUNNING)
        await screen.until(lambda: screen.app.controller.ctx.runs.frames, "a line being run")
        await screen.press("f8")
        await screen.shows("Stopped at line ")

        await screen.idle()


async def test_ctrl_c_stops_while_something_runs(open_screen):
    async with open_screen(WAITING, speed=1.0) as screen:
        await screen.press("f5")
        await screen.reaches(RunState.RUNNING)
        await screen.press("ctrl+c")

        await screen.shows("Stopped")


async def test_ctrl_c_copies_while_nothing_runs(open_screen):
    async with open_screen("FW 1") as screen:
        await screen.press("ctrl+a", "ctrl+c")
        await screen.pilot.pause()

        assert screen.app.clipboard == "FW 1"
        assert not any("running" in line for line in screen.log)


LONG = "\n".join(["VAR a = 1", *["a = a + 1"] * 53, "WAIT 1000", *["FW 1"] * 5])
"""Sixty lines; in the 55th the program waits."""


@pytest.mark.parametrize("size", [(40, 12), (80, 24), (120, 40)], ids=str)
async def test_the_line_that_runs_is_in_sight(open_screen, size):
    """The cursor stays where it is, and is in sight again at the end."""
    async with open_screen(LONG, size=size, speed=1.0) as screen:
        await screen.press("f5")
        await screen.until(lambda: ">  55  WAIT" in screen.text or "> 55  WAIT" in screen.text, "the line")
        assert screen.main.editor.cursor_location == (0, 0)

        await screen.press("f8")
        await screen.idle()
        await screen.until(lambda: " 1  VAR a = 1" in screen.text, "the cursor")


async def test_nothing_is_scrolled_after_the_learner_scrolls_or_edits_until_the_run_is_held(open_screen):
    async with open_screen(LONG, size=(40, 12), speed=1.0) as screen:
        editor, look = screen.main.editor, screen.app.controller.display.update
        await screen.press("f5")
        await screen.until(lambda: "> 55  WAIT" in screen.text, "the line")

        await screen.pilot._post_mouse_events([events.MouseScrollUp], editor)
        await screen.painted()
        top = editor.scroll_offset.y
        editor._next_scroll = 0.0
        editor.scroll_to(y=0, animate=False, immediate=True)
        look()
        await screen.painted()
        assert (editor.scroll_offset.y, top > 0) == (0, True)

        await screen.press("f6")
        await screen.reaches(RunState.PAUSED)
        await screen.until(lambda: "> 55  WAIT" in screen.text, "the line again")
        await screen.press("f6")
        await screen.reaches(RunState.RUNNING)
        editor.move_cursor((2, 0))
        await screen.press("x")
        editor._next_scroll = 0.0
        look()
        await screen.painted()
        assert "> 55  WAIT" not in screen.text
        assert " 3  xa = a + 1" in screen.text
        await screen.press("f8")
        await screen.idle()
        await screen.painted()
        assert " 3  xa = a + 1" in screen.text


async def test_a_line_that_runs_in_sight_paints_nothing_more(open_screen, monkeypatch):
    async with open_screen(LONG, size=(80, 24), speed=1.0) as screen:
        await screen.press("f5")
        await screen.until(lambda: "> 55  WAIT" in screen.text, "the line")
        await screen.painted()
        painted = []
        monkeypatch.setattr(screen.main.editor, "refresh", lambda *regions, **_: painted.append(regions))
        for _ in range(3):
            screen.main.editor._next_scroll = 0.0
            screen.main.editor.follow(55)
        assert painted == []


async def test_the_plain_layout_scrolls_no_line_into_sight(open_screen):
    """A reader would speak it."""
    async with open_screen(LONG, size=(80, 24), speed=1.0, plain=True) as screen:
        screen.main.go_to(screen.main.program_pane)
        await screen.press("f5")
        await screen.until(lambda: screen.main.editor._marks.get(55), "the mark")
        assert screen.main.editor.scroll_offset.y == 0


async def test_pause_holds_the_program_marks_its_line_and_goes_on(open_screen):
    async with open_screen(WAITING, speed=1.0) as screen:
        await screen.press("f5")
        await screen.reaches(RunState.RUNNING)
        await screen.press("f6")
        await screen.reaches(RunState.PAUSED)
        await screen.shows("Paused at line ")
        line = screen.app.controller.ctx.runs.frames[0].line
        await screen.until(lambda: f"> {line}  " in screen.text, "the mark")
        assert screen.main.status.badge == "PAUSED"
        assert screen.main.editor.line == line

        await screen.press("f6")
        await screen.reaches(RunState.RUNNING)


async def test_a_pause_leaves_the_cursor_where_the_learner_types(open_screen):
    async with open_screen(COMPUTING + "\nFW 1") as screen:
        screen.main.editor.go_to(4, 5)
        await screen.press("f5")
        await screen.reaches(RunState.RUNNING)
        await screen.press("2", "3")
        await screen.press("f6")
        await screen.shows("Paused at line ")
        await screen.until(lambda: "> 1  " in screen.text or "> 2  " in screen.text, "the mark")
        await screen.press("4")
        assert screen.main.editor.text.endswith("END WHILE\nFW 1234")

        await screen.press("f7")  # a step is followed again, also after an edit at the pause
        await screen.until(lambda: screen.main.editor.line < 4, "the line of the step")


async def test_reset_puts_the_robot_back_and_forgets_the_variables(open_screen):
    async with open_screen() as screen:
        await screen.type_line("VAR a = 3 FW a")
        await screen.shows("I walked 3 steps forward.")
        await screen.idle()
        await screen.press("ctrl+r")
        await screen.shows("I am back at the start.")
        await screen.until(lambda: "No variables." in screen.main.inspector.lines, "no variables")

        await screen.status_has("Donnie at 0, 0 facing north.")
        assert "o" not in "".join(screen.map_rows())


async def test_a_mistake_is_reported_and_the_cursor_moves_to_its_place(open_screen):
    async with open_screen("FW 1\nTR 90\n  FWD 3") as screen:
        await screen.press("f5")
        await screen.shows("Error, line 3, column 3")

        assert screen.main.editor.cursor_location == (2, 2)
        await screen.shows("Did you mean FW?")
        assert "I walked 1 step forward." not in screen.log


async def test_a_mistake_in_a_typed_command_leaves_the_program_alone(open_screen):
    async with open_screen("FW 1\nFW 2") as screen:
        await screen.type_line("FWD 3")
        await screen.shows("Error, line 1")

        assert screen.main.editor.cursor_location == (0, 0)


async def test_quit_in_the_program_is_a_mistake_and_in_the_command_line_leaves(open_screen):
    async with open_screen("QUIT") as screen:
        await screen.press("f5")
        await screen.shows("Error, line 1")
        screen.load("")
        await screen.type_line("quit")
        await screen.until(lambda: not screen.app.is_running, "the end")

        assert screen.app.return_code == 0


async def test_a_program_that_talks_without_end_leaves_the_keys_alive(open_screen):
    async with open_screen('WHILE 1 == 1 DO\nSPEAK "again and again"\nEND WHILE') as screen:
        await screen.press("f5")
        await screen.shows("again and again")
        await screen.press("f8")

        await screen.shows("Stopped at line")


async def test_the_inspector_names_variables_calls_and_readings(open_screen):
    async with open_screen("VAR wide = 7\nVAR d = DISTANCE F\nFW 1", size=(120, 40)) as screen:
        screen.main.editor.go_to(3)
        await screen.press("f10")
        await screen.shows("Line 3: FW 1")
        await screen.until(lambda: "distance ahead: 60" in screen.main.inspector.lines, "the reading")

        assert "*wide      7" in screen.main.inspector.lines
        assert "program, line 3" in screen.main.inspector.lines


def painted(widget, monkeypatch) -> list[int]:
    """The rows that are painted from now on."""
    rows: list[int] = []
    own = widget.render_line
    monkeypatch.setattr(widget, "render_line", lambda y: rows.append(y) or own(y))
    return rows


async def test_a_look_at_a_program_paints_only_what_is_new(open_screen, monkeypatch):
    """Five times a second: over a slow line each row that is painted in vain is felt."""
    async with open_screen("VAR x = 1\nx = 2\nx = 3\nSPEAK x", size=(120, 40)) as screen:
        await screen.press("f7", "f9", "f9")
        await screen.shows("Line 2")
        await screen.press("f9")
        await screen.shows("Line 3")
        await screen.painted()
        main_screen = screen.main
        text, variables, log = (
            painted(each, monkeypatch)
            for each in (main_screen.editor, main_screen.inspector, main_screen.log_rows)
        )

        screen.app.controller.display.update()
        await screen.painted()
        assert (text, variables, log) == ([], [], [])

        lines = list(main_screen.inspector.lines)
        main_screen.inspector.show([lines[0], f"{lines[1]}0", *lines[2:]])
        await screen.until(lambda: {main_screen.inspector.row, 1} <= set(variables), "the rows of variables")
        assert set(variables) == {main_screen.inspector.row, 1}
        assert text == []

        shown = len(main_screen.log_rows.lines)
        main_screen.log_lines([("one more line", "")])
        await screen.until(lambda: shown in log, "the row of the log")
        assert set(log) == {shown}


@pytest.mark.parametrize("size", [(80, 24), (120, 40), (40, 12)])
async def test_what_the_program_does_is_the_first_of_the_status_line_and_never_cut(open_screen, size):
    """Whatever is said after it: here the longest sentence about a mistake."""
    async with open_screen(WAITING + "\nFWD 3", speed=1.0, size=size) as screen:
        screen.app.controller.display.keep("A sentence " * 40)
        await screen.painted()
        assert [row for row in screen.text.splitlines() if row.startswith(" READY ")]
        screen.load(WAITING)
        await screen.press("f5")
        await screen.until(lambda: "\n RUNNING " in screen.text, "the running program")
        await screen.press("f6")
        await screen.until(lambda: "\n PAUSED " in screen.text, "the pause")


async def test_running_says_how_fast_and_a_stopped_program_says_so_until_the_next_one(open_screen):
    async with open_screen(WAITING, speed=5.0) as screen:
        badge = screen.main.status
        await screen.press("f5")
        await screen.until(lambda: badge.badge == "RUNNING x5", "the running program")
        await screen.press("f12")
        await screen.until(lambda: badge.badge not in ("RUNNING x5", "READY"), "another speed")
        assert badge.badge.startswith("RUNNING ")

        await screen.press("f8")
        await screen.idle()
        await screen.until(lambda: badge.badge == "STOPPED", "the stopped program")
        await screen.type_line("RESET")
        await screen.until(lambda: badge.badge == "READY", "the start")


async def test_the_status_names_the_line_that_runs_and_the_block_around_it(open_screen):
    """Wherever the focus is, and the speed once: after RUNNING."""
    async with open_screen("FW 1\nREPEAT 2 TIMES\nWAIT 1000\nEND REPEAT", speed=5.0) as screen:
        await screen.press("f5")
        await screen.until(lambda: "Line 3 of 4, in REPEAT. Donnie at 0, 1 " in screen.text, "the line")
        assert "RUNNING x5" in screen.text and "Speed" not in screen.text
        await screen.type_line("STOP")
        await screen.idle()
        for _ in range(3):
            await screen.type_line("STEP BACK")
        await screen.until(lambda: "Line 1 of 4. Donnie at 0, 0 " in screen.text, "the line of the past")


async def test_where_no_log_is_seen_the_status_of_a_held_program_has_the_answer(open_screen):
    async with open_screen("REPEAT 2 TIMES\nWAIT 1000\nEND REPEAT", speed=1.0, size=(40, 12)) as screen:
        await screen.press("f5", "f6")
        await screen.until(lambda: " PAUSED  Paused at line 2" in screen.text, "the answer")
        await screen.press("left")
        await screen.until(lambda: " PAUSED  Line 2 of 3, in REPEAT." in screen.text, "the line")


async def test_looking_back_is_a_state_of_its_own(open_screen):
    async with open_screen() as screen:
        await screen.run("FW 1\nFW 2")
        await screen.type_line("STEP BACK")
        await screen.until(lambda: screen.main.status.badge.startswith("LOOKING BACK, "), "the way back")
        await screen.type_line("FW 1")
        await screen.until(lambda: screen.main.status.badge == "READY", "the present")


async def test_a_change_during_a_run_is_answered_once_that_the_robot_follows_the_text_before(open_screen):
    async with open_screen(WAITING, speed=1.0) as screen:
        await screen.press("f5")
        await screen.reaches(RunState.RUNNING)
        await screen.press(*"FW")
        await screen.shows("You changed the program. The robot still follows the text from before.")
        await screen.press(*"BW")
        await screen.press("f8")
        await screen.idle()
        await screen.press("x")

        assert sum("You changed the program." in line for line in screen.log) == 1


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "Program: new program, old text runs"),
        ("pt", "Programa: programa novo, roda o antigo"),
        ("es", "Programa: programa nuevo, va el viejo"),
    ],
)
async def test_the_title_says_as_long_as_it_is_so_that_another_text_runs(open_screen, language, said):
    """On a small screen too, where the log is not in sight."""
    async with open_screen(WAITING, speed=1.0, size=(40, 12), language=language) as screen:
        await screen.press("f5")
        await screen.reaches(RunState.RUNNING)
        await screen.press("end", "x")
        await screen.until(lambda: screen.text.splitlines()[0] == f">{said}", said)
        await screen.press("backspace")
        await screen.until(lambda: said not in screen.text, "the text that runs")
        await screen.press("x")
        await screen.until(lambda: said in screen.text, "another text again")
        await screen.press("f8")
        await screen.idle()
        await screen.until(lambda: said not in screen.text, "the end of the run")


@pytest.mark.parametrize("size", [(80, 24), (40, 12)])
@pytest.mark.parametrize(
    ("language", "line", "wanted"),
    [
        ("en", "FW 2", "Donnie at 0, 2 facing north."),
        ("pt", "PF 2", "Donnie em 0, 2 virado para o norte."),
        ("es", "AV 2", "Donnie en 0, 2 mirando al norte."),
    ],
)
async def test_the_status_line_says_whole_where_the_robot_is_once_a_program_is_done(
    open_screen, language, line, wanted, size
):
    """In eighty columns it left that out in Portuguese; in forty the last words had no row."""
    async with open_screen(line, language=language, size=size) as screen:
        await screen.press("f5")
        await screen.until(lambda: screen.main.map.grid and screen.log[-1].endswith((".",)), "the end")
        await screen.idle()
        await screen.until(lambda: "0, 2" in screen.status, "the place")
        await screen.painted()

        rows = screen.text.splitlines()
        begin = next(at for at, row in enumerate(rows) if row.startswith(f" {screen.main.status.badge} "))
        seen = " ".join(" ".join(rows[begin : begin + screen.main.status.size.height]).split())
        assert seen.endswith(wanted)
