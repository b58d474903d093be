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


async def test_a_procedure_is_stepped_over_or_into_and_its_caller_is_marked(work):
    async with work(CALLS) as desk:
        await desk.press("f7")
        await desk.shows("Line 1:")
        await desk.press("f9")
        await desk.shows("Line 5:")
        await desk.press("f9")
        await desk.shows("Line 6: HOP [3]")
        assert desk.log.count("I walked 2 steps forward.") == 2

        await desk.press("f7")
        await desk.shows("Line 2, level 1: FW n")
        assert "> 2  FW n" in desk.screen
        assert "* 6  HOP [3]" in desk.screen


async def test_running_to_the_cursor_holds_at_its_line(work):
    async with work("FW 1\nFW 2\nFW 3\nFW 4") as desk:
        desk.place.editor.go_to(3)
        await desk.press("f10")
        await desk.shows("Line 3: FW 3")

        assert "I walked 2 steps forward." in desk.log
        assert "I walked 3 steps forward." not in desk.log


def trail(desk) -> list[str]:
    return [row.strip(".") for row in desk.map_rows() if row.strip(".")]


@pytest.mark.parametrize("key", ["f6", "f8"])
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
