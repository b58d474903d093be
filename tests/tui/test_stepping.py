"""Stepping through a program, there and back."""

import pytest

CALLS = "PROCEDURE HOP: n DO\nFW n\nFW n\nEND PROCEDURE\nHOP [2]\nHOP [3]"


async def test_stepping_stops_before_each_line_and_the_cursor_follows(work):
    async with work("FW 1\nFW 2\nFW 3") as desk:
        for line in (1, 2, 3):
            await desk.press("f7")
            await desk.shows(f"Line {line}: FW {line}")
            assert desk.place.editor.line == line
            assert f"> {line}  FW {line}" in desk.screen
        await desk.press("f7")
        await desk.shows("The program is done.")

        assert [line for line in desk.log if line.startswith("I walked")] == [
            "I walked 1 step forward.",
            "I walked 2 steps forward.",
            "I walked 3 steps forward.",
        ]


async def test_steps_print_rounds_and_conditions_forwards_and_backwards(work):
    async with work("VAR x = 1\nREPEAT 2 TIMES\nIF x > 0 THEN\nx = x + 1\nEND IF\nEND REPEAT") as desk:
        for line in (1, 2, 3, 4, 2, 3):
            await desk.press("f7")
            await desk.until(lambda line=line: desk.log[-1].startswith(f"Line {line}"), f"line {line}")
        printed = [line for line in desk.log if not line.startswith("Line ")]
        assert printed[-3:] == ["Round 1 of 2.", "Condition true: 1 greater than 0.", "Round 2 of 2."]
        for _ in range(2):
            await desk.type_line("step back")
        await desk.shows("x is 1.")

        assert desk.log[-3:] == ("x is 1.", "Condition true: 1 greater than 0.", "Line 4, level 2: x = x + 1")


async def test_the_last_step_names_the_end_of_the_loop_after_its_command(work):
    async with work("VAR x = 1\nWHILE x < 2 DO\nx = x + 1\nEND WHILE") as desk:
        for line in (1, 2, 3, 2):
            await desk.press("f7")
            await desk.until(lambda line=line: desk.log[-1].startswith(f"Line {line}"), f"line {line}")
        await desk.press("f7")
        await desk.shows("The program is done.")

        assert desk.log[-2:] == ("Condition false: 2 equal to 2.", "The program is done.")


async def test_a_step_goes_into_a_procedure_and_its_caller_is_marked(work):
    async with work(CALLS) as desk:
        await desk.press("f7")
        await desk.shows("Line 1:")
        await desk.press("f7")
        await desk.shows("Line 5:")
        await desk.press("f7")
        await desk.shows("Line 2, level 1: FW n")

        assert "> 2  FW n" in desk.screen
        assert "* 5  HOP [2]" in desk.screen


async def test_stepping_over_runs_a_procedure_as_a_whole(work):
    async with work(CALLS) as desk:
        await desk.press("f7")
        await desk.shows("Line 1:")
        await desk.press("f9")
        await desk.shows("Line 5:")
        await desk.press("f9")
        await desk.shows("Line 6: HOP [3]")

        assert desk.log.count("I walked 2 steps forward.") == 2


async def test_running_to_the_cursor_holds_at_its_line(work):
    async with work("FW 1\nFW 2\nFW 3\nFW 4") as desk:
        desk.place.editor.go_to(3)
        await desk.press("f10")
        await desk.shows("Line 3: FW 3")

        assert "I walked 2 steps forward." in desk.log
        assert "I walked 3 steps forward." not in desk.log


async def test_until_takes_a_line_and_refuses_one_that_is_not_there(work):
    async with work("FW 1\nFW 2") as desk:
        await desk.type_line("UNTIL 9")
        await desk.shows("There is no line 9.")
        await desk.type_line("UNTIL 2")

        await desk.shows("Line 2: FW 2")


def trail(desk) -> list[str]:
    return [row.strip(".") for row in desk.map_rows() if row.strip(".")]


@pytest.mark.parametrize("key", ["f6", "f7", "f8"])
async def test_resuming_after_steps_back_continues_from_the_present(work, key):
    async with work("FW 3\nTR 90\nFW 4\nTR 90\nSPEAK 1\nWAIT 1000", speed=None) as desk:
        for line in ("Line 1:", "Line 2:", "Line 3:", "Line 4:", "Line 5:"):
            await desk.press("f7")
            await desk.shows(line)
        here = ["oooov", "o", "o", "A"]
        assert trail(desk) == here
        for _ in range(4):
            desk.app.controller.do("step_back")
        assert trail(desk) == ["^"]

        await desk.press(key)

        await desk.until(lambda: trail(desk) == here, "the present")
        desk.app.controller.do("stop")
        await desk.idle()
        assert trail(desk) == here
