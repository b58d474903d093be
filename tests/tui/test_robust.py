"""What must never happen at the screen: a crash, a page of traceback, a lost line, unreadable colours."""

import re
from pathlib import Path

import pytest
from textual import events
from textual.filter import Monochrome, NoColor

from donnie_tui.bootstrap import assemble
from donnie_tui.i18n import first_screen
from donnie_tui.settings import Settings
from donnie_tui.tui.app import FAULT, DonnieApp

COLOURED = re.compile(r"\x1b\[[0-9;]*(?:38|48);2;")


@pytest.mark.parametrize("lines", [2, 12, 13, 14, 100])
async def test_undo_of_a_paste_of_any_length_gives_the_empty_program_back(work, lines):
    async with work() as desk:
        for _ in range(2):
            desk.app.post_message(events.Paste("".join(f"SPEAK {i}\n" for i in range(lines))))
            await desk.until(lambda: desk.place.editor.line_count == lines + 1)
            await desk.pilot.pause()
            await desk.press("ctrl+z")
            await desk.until(lambda: desk.place.editor.text == "")
            await desk.pilot.pause()


async def test_a_fault_of_ours_is_one_sentence_and_the_text_is_kept(tmp_path: Path):
    settings = Settings(speech="off", sound=False)
    app = DonnieApp(settings, assemble=lambda: assemble(settings, terminal=True), folder=tmp_path)
    left: list[str] = []
    app._print_error_renderables = lambda: left.extend(map(str, app._exit_renderables))

    def fail() -> None:
        secret = "a local value"
        raise RuntimeError(secret)

    with pytest.raises(RuntimeError):
        async with app.run_test() as pilot:
            while app.work is None:
                await pilot.pause(0.01)
            app.workplace.editor.load_text("FW 3")
            app.call_later(fail)
            await pilot.pause(0.1)
    app.close_session()
    copies = list((tmp_path / "unsaved").glob("*.gd"))

    assert left == [first_screen.FAULT[0]]
    assert app.return_code == 1
    assert [each.read_text(encoding="utf-8") for each in copies] == ["FW 3"]
    assert "RuntimeError" in (tmp_path / "unsaved" / FAULT).read_text(encoding="utf-8")


async def test_without_colours_the_terminal_s_own_are_left_alone(work, monkeypatch):
    monkeypatch.setenv("NO_COLOR", "1")
    async with work("FW 1") as desk:
        kinds = {type(each) for each in desk.app._filters}
        strips = desk.app.screen._compositor.render_strips()
        painted = "".join(strip.render(desk.app.console) for strip in strips)

    assert NoColor in kinds
    assert Monochrome not in kinds
    assert not COLOURED.search(painted)


async def test_nothing_that_was_spoken_is_missing_from_the_log(work):
    async with work("REPEAT 12000 TIMES\nSPEAK 7\nEND REPEAT") as desk:
        await desk.press("f5")
        await desk.told("The program is done.")

        assert desk.log.count("7") == 12000
