"""What a click does: a key of the bottom line is pressed, a square of the map is described."""

from textual.geometry import Offset


async def test_a_click_on_a_key_of_the_bottom_line_presses_it(work):
    async with work() as desk:
        desk.load("FW 2")
        at = desk.place.keys.words.index("Run") + 1
        before = desk.app.focused

        await desk.pilot.click(desk.place.keys, offset=Offset(at, 0))

        await desk.shows("I walked 2 steps forward.")
        assert desk.app.focused is before


async def test_a_click_next_to_the_keys_presses_none(work):
    async with work() as desk:
        keys = desk.place.keys
        done = []
        desk.app.controller.do = lambda name, argument=None: done.append(name)

        for at in (0, keys.words.index("  "), keys.words.index("  ") + 1):
            await desk.pilot.click(keys, offset=Offset(at, 0))
        await desk.pilot.pause()

        assert done == []


async def test_a_click_on_the_map_describes_the_square(work):
    async with work(world="living_room") as desk:
        shown = desk.place.map
        robot = shown.cursor_screen_offset - shown.content_region.offset

        await desk.pilot.click(shown, offset=robot + Offset(2 * shown._columns, -3))
        await desk.until(lambda: shown.is_exploring, "the click")

        assert desk.app.focused is shown
        await desk.until(lambda: desk.status.startswith(" Map, 2, 3: free."), "the words")


async def test_a_click_next_to_the_floor_explores_nothing(work):
    async with work(world="living_room") as desk:
        shown = desk.place.map
        shown.set_zoom(-3)
        await desk.pilot.pause()
        await desk.pilot.click(shown, offset=Offset(shown.size.width - 1, shown.size.height - 1))
        await desk.pilot.pause()

        assert not shown.is_exploring
