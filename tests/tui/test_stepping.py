"""Stepping through a program, there and back."""

import pytest

CALLS = "PROCEDURE HOP: n DO\nFW n\nFW n\nEND PROCEDURE\nHOP [2]\nHOP [3]"


async def test_stepping_stops_before_each_line_and_the_cursor_follows(open_screen):
    async with open_screen("FW 1\nFW 2\nFW 3") as screen:
        for line in (1, 2, 3):
            await screen.press("f7")
            await screen.shows(f"Line {line}: FW {line}")
            assert screen.main.editor.line == line
            assert f"> {line}  FW {line}" in screen.text
        await screen.press("f7")
        await screen.shows("The program is done.")

        assert [line for line in screen.log if line.startswith("I walked")] == [
            "I walked 1 step forward.",
            "I walked 2 steps forward.",
            "I walked 3 steps forward.",
        ]


async def test_a_procedure_is_stepped_over_or_into_and_its_caller_is_marked(open_screen):
    async with open_screen(CALLS) as screen:
        await screen.press("f7")
        await screen.shows("Line 1:")
        await screen.press("f9")
        await screen.shows("Line 5:")
        await screen.press("f9")
        await screen.shows("Line 6: HOP [3]")
        assert screen.log.count("I walked 2 steps forward.") == 2

        await screen.press("f7")
        await screen.shows("Line 2, level 1: FW n")
        assert "> 2  FW n" in screen.text
        assert "* 6  HOP [3]" in screen.text


async def test_running_to_the_cursor_holds_at_its_line(open_screen):
    async with open_screen("FW 1\nFW 2\nFW 3\nFW 4") as screen:
        screen.main.editor.go_to(3)
        await screen.press("f10")
        await screen.shows("Line 3: FW 3")

        await screen.shows("I walked 2 steps forward.")
        assert "I walked 3 steps forward." not in screen.log


def trail(screen) -> list[str]:
    return [row.strip(".") for row in screen.map_rows() if row.strip(".")]


@pytest.mark.parametrize("key", ["f6", "f8"])
async def test_resuming_after_steps_back_continues_from_the_present(open_screen, key):
    async with open_screen("FW 3\nTR 90\nFW 4\nTR 90\nSPEAK 1\nWAIT 1000", speed=None) as screen:
        for line in ("Line 1:", "Line 2:", "Line 3:", "Line 4:", "Line 5:"):
            await screen.press("f7")
            await screen.shows(line)
        here = ["oooov", "o", "o", "A"]
        assert trail(screen) == here
        for _ in range(4):
            screen.app.controller.do("step_back")
        assert trail(screen) == ["^"]
        assert "> 1  FW 3" in screen.text and "LOOKING BACK, " in screen.text
        assert not any(f"> {line} " in screen.text for line in range(2, 7))

        await screen.press(key)

        await screen.until(lambda: trail(screen) == here, "the present")
        screen.app.controller.do("stop")
        await screen.idle()
        assert trail(screen) == here


async def test_a_slider_shows_how_far_back_one_looks_and_a_click_goes_there(open_screen):
    async with open_screen("FW 1\nFW 2\nFW 3\nFW 4", size=(80, 24)) as screen:
        await screen.press("f5")
        await screen.shows("The program is done.")
        await screen.idle()
        assert "| >" not in screen.text
        await screen.type_line("STEP BACK")
        await screen.until(lambda: "-| >" in screen.text, "the slider")
        slider = screen.main._slider
        whole = slider._at[1]
        await screen.painted()
        await screen.pilot.click(slider, offset=(4, 0))
        await screen.until(lambda: slider._at[0] == 0, "the start")
        assert screen.main.map.scale.robot == screen.main.map.scale.square_of(
            screen.main.map.scale.scene.cell_at(0, 0)
        )
        assert " < |O--" in screen.text
        await screen.pilot.click(slider, offset=(79, 0))
        await screen.until(lambda: slider._at[0] == 1, "one step")
        await screen.pilot.click(slider, offset=(1, 0))
        await screen.until(lambda: slider._at[0] == 0, "one step back")
        for _ in range(3):
            await screen.pilot.click(slider, offset=(1, 0))
        await screen.shows("This is the start.")
        await screen.painted()
        assert screen.log.count("This is the start.") == 1
        await screen.pilot.click(slider, offset=(40, 0))
        await screen.until(lambda: slider._at[0] == round(whole / 2), "the middle")
        await screen.pilot.click(slider, offset=(75, 0))
        await screen.until(lambda: "| >" not in screen.text, "the present")
        assert "LOOKING BACK" not in screen.text


async def test_the_slider_moves_over_lines_that_only_compute(open_screen):
    """Four steps back pass the two lines that compute, the one that walks, and one more that computes."""
    async with open_screen("VAR a = 1\nVAR b = 2\nFW 1\na = 3\nb = 4\nFW 2", size=(80, 24)) as screen:
        for line in range(1, 7):
            await screen.press("f7")
            await screen.shows(f"Line {line}:")
        seen = []
        for _ in range(4):
            screen.app.controller.do("step_back")
            seen.append(screen.main._slider._at)
        whole = seen[0][1]
        assert [at for at, _ in seen] == [whole - 1, whole - 2, whole - 3, whole - 4]
        assert {of for _, of in seen} == {whole}
        assert screen.main.status.badge == f"LOOKING BACK, {whole - 4} OF {whole}"
        for _ in range(2):
            screen.app.controller.do("step")
        assert screen.main._slider._at == (whole - 2, whole)


async def test_a_click_on_the_slider_within_a_step_of_many_things_ends_before_or_after_it(open_screen):
    text = "PROCEDURE P DO\nFW 1 TR 90 FW 1 TR 90\nEND PROCEDURE\nFW 1\nP []\nFW 2"
    async with open_screen(text, size=(80, 24)) as screen:
        for line in (1, 4, 5, 6):
            await screen.press("f9")
            await screen.shows(f"Line {line}:")
        screen.app.controller.do("step_back")
        slider = screen.main._slider
        at, whole = slider._at
        assert whole - at == 4
        screen.app.controller.ctx.runs.look_at(whole - 2)
        assert screen.app.controller.ctx.runs.past is None  # forward over all of it, to the present


async def test_what_the_next_line_computes_is_shown_after_it_and_in_the_inspector(open_screen):
    async with open_screen("VAR n = 3\nSPEAK n * 2 + 1\nFW n\nFW 1", size=(120, 40)) as screen:
        for line in (1, 2):
            await screen.press("f7")
            await screen.shows(f"Line {line}:")
        await screen.until(lambda: "> 2  SPEAK n * 2 + 1  > " in screen.text, "the sum")
        assert "n * 2 + 1 = 7" in screen.text
        rows = [row.strip() for row in screen.main.inspector.lines]
        at = rows.index("Worked out in this line:")
        assert rows[at + 1 : at + 5] == ["n * 2 + 1", "= 3 * 2 + 1", "= 6 + 1", "= 7"]

        await screen.press("f7")
        await screen.until(lambda: "> 3  FW n  > n = 3" in screen.text, "the value")
        assert "= 7" not in screen.text

        await screen.press("ctrl+k", "k")  # back, to what it was
        await screen.until(lambda: "n * 2 + 1 = 3 * 2 + 1" in screen.text or "= 7" in screen.text, "the past")
        await screen.press("f5")


async def test_the_keys_back_and_forward_are_offered_while_looking_back_at_a_finished_run(open_screen):
    async with open_screen("FW 1\nFW 2") as screen:
        await screen.press("f5")
        await screen.shows("The program is done.")
        await screen.idle()
        await screen.type_line("STEP BACK")
        await screen.until(lambda: "Ctrl+K K Back  F7 Step" in screen.text, "the keys")
