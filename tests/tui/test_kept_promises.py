"""What stays as it is while other things change: the row being read, the pace asked for, the scale."""

from contextlib import nullcontext
from types import SimpleNamespace

import pytest
from textual.app import App, ComposeResult

from donnie_tui.commands.settings import change
from donnie_tui.tui import event_queue, normal_screen
from donnie_tui.tui.event_queue import CALM, FRAME, EventReader
from donnie_tui.tui.widgets.rows import MOST_LINES, TextRows

LONG = "one two three four five six seven eight nine ten"


class Rows(App[None]):
    def compose(self) -> ComposeResult:
        yield TextRows(id="rows", follows=True)


# --- the row being read


async def test_the_line_being_read_is_still_the_one_after_a_resize():
    async with Rows().run_test(size=(30, 10)) as pilot:
        rows = pilot.app.query_one(TextRows)
        rows.append((f"{i} {LONG}", "") for i in range(9))
        rows.read_line(5)
        for width in (100, 20, 30):
            await pilot.resize_terminal(width, 10)
            await pilot.pause()
            assert rows.row_text.startswith("5 "), width


async def test_the_row_being_read_is_still_the_one_when_the_oldest_are_forgotten():
    async with Rows().run_test(size=(80, 24)) as pilot:
        rows = pilot.app.query_one(TextRows)
        rows.append((f"line {i}", "") for i in range(MOST_LINES))
        rows.read_line(MOST_LINES // 2)
        rows.append([("one more", "")])
        await pilot.pause()

        assert len(rows.lines) < MOST_LINES
        assert rows.row_text == f"line {MOST_LINES // 2}"


async def test_a_search_goes_to_the_next_older_line_and_from_the_oldest_to_the_newest():
    async with Rows().run_test(size=(80, 24)) as pilot:
        rows = pilot.app.query_one(TextRows)
        rows.append((f"{i} wall" if i % 2 else f"{i} way", "") for i in range(7))
        found = []
        for _ in range(4):
            assert rows.search("WALL")
            found.append(rows.row_text)

        assert found == ["5 wall", "3 wall", "1 wall", "5 wall"]
        assert not rows.search("gate")


# --- pace


def test_the_queue_is_read_at_the_chosen_interval(monkeypatch):
    now = SimpleNamespace(seconds=100.0)
    monkeypatch.setattr(event_queue, "time", SimpleNamespace(monotonic=lambda: now.seconds))
    due: list[float] = []
    batch = SimpleNamespace(missed=0, lines=())
    it = EventReader(
        SimpleNamespace(take=lambda: batch),
        str,
        set_timer=lambda seconds, _do: due.append(seconds) or SimpleNamespace(stop=lambda: None),
        receive=lambda _batch: None,
        write=lambda _lines: None,
    )
    for frame in (FRAME, CALM):
        it.frame = frame
        it.take()
        it.on_queued()
    assert due == pytest.approx([FRAME, CALM])


async def test_little_motion_is_a_calm_map_at_the_start_and_when_it_is_chosen(work):
    async with work(motion="reduced") as desk:
        assert desk.app.controller.events.frame == CALM
        change(desk.app.controller.ctx, "motion", "full")
        assert desk.app.controller.events.frame == FRAME
        change(desk.app.controller.ctx, "motion", "reduced")
        assert desk.app.controller.events.frame == CALM


# --- the end, and the scale


def test_the_last_twenty_lines_are_left_behind_in_their_order(capsys, monkeypatch):
    monkeypatch.delenv("TEXTUAL_DRIVER", raising=False)
    normal_screen.print_last_lines([f"line {i}" for i in range(30)])

    assert capsys.readouterr().out.splitlines() == [f"line {i}" for i in range(10, 30)]


async def test_a_pager_that_can_not_be_run_is_reported_in_a_sentence(work, monkeypatch, tmp_path):
    broken = tmp_path / "pager"
    broken.write_text("no program")
    broken.chmod(0o755)
    monkeypatch.setenv("PAGER", str(broken))
    async with work() as desk:
        monkeypatch.setattr(desk.app, "suspend", nullcontext)
        await desk.type_line("LOG")
        await desk.shows("The log can't be shown: Exec format error. SAVE LOG writes it into a file.")


async def test_a_question_closes_when_the_program_quits(work):
    """A program that was running says QUIT, and what is not saved is asked about."""
    async with work("FW 1") as desk:
        await desk.type_line("SAVE AS")
        await desk.until(lambda: desk.app.screen is not desk.place, "the name is asked")
        name = desk.app.screen
        desk.app.do("quit")
        await desk.until(lambda: desk.app.screen not in (name, desk.place), "whether to save is asked")
        assert desk.app.screen_stack == [desk.place, desk.app.screen]

        await desk.press("escape")
        await desk.until(lambda: desk.app.screen is desk.place, "no question is left")


async def test_plus_comes_nearer_and_minus_goes_further_away(work):
    async with work(world="living_room") as desk:
        view = desk.place.map
        view.focus()
        widths = {0: view.virtual_size.width}
        for key, zoom in (("plus", 1), ("minus", 0), ("minus", -1)):
            await desk.press(key)
            await desk.until(lambda zoom=zoom: view.zoom == zoom, key)
            widths[zoom] = view.virtual_size.width

        assert widths[1] > widths[0] > widths[-1]
