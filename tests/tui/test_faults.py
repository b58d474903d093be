"""What must never happen at the screen: a crash, a page of traceback, a lost line, unreadable colours."""

import os
import re
import signal
from pathlib import Path

import pytest
from textual import events
from textual.filter import Monochrome, NoColor

from donnie_tui.bootstrap import assemble
from donnie_tui.commands.keys import KeyTable
from donnie_tui.core.run_state import RunState
from donnie_tui.i18n.first_words import early
from donnie_tui.i18n.words import Words
from donnie_tui.settings.settings import Settings
from donnie_tui.tui import shutdown
from donnie_tui.tui.app import DonnieApp
from donnie_tui.tui.help_pages import help_text
from donnie_tui.tui.shutdown import FAULT
from language.locales import languages
from tests.tui.conftest import WAITING, burst

pytestmark = pytest.mark.slow

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


async def test_an_internal_fault_is_one_sentence_and_the_text_is_kept(tmp_path: Path):
    settings = Settings(speech="off", sound=False)
    app = DonnieApp(settings, assemble=lambda: assemble(settings, terminal=True), folder=tmp_path)
    left: list[str] = []
    app._print_error_renderables = lambda: left.extend(map(str, app._exit_renderables))

    def fail() -> None:
        secret = "a local value"
        raise RuntimeError(secret)

    with pytest.raises(RuntimeError):
        async with app.run_test() as pilot:
            while app.controller is None:
                await pilot.pause(0.01)
            app.main_screen.editor.load_text("FW 3")
            app.call_later(fail)
            await app._exception_event.wait()
    app.session.close()
    copies = list((tmp_path / "unsaved").glob("*.gd"))

    assert left == [early("screen-fault", "en")]
    assert app.return_code == 1
    assert [each.read_text(encoding="utf-8") for each in copies] == ["FW 3\n"]
    assert "RuntimeError" in (tmp_path / "unsaved" / FAULT).read_text(encoding="utf-8")


async def test_an_internal_fault_halts_the_robot_before_the_text_is_saved(work):
    """Keeping the text may take its time."""
    doing: list[RunState] = []

    def fail() -> None:
        raise RuntimeError

    with pytest.raises(RuntimeError):
        async with work(WAITING, speed=1.0) as desk:
            desk.app._print_error_renderables = lambda: None
            running, workspace = desk.app.controller.ctx.runs, desk.app.controller.workspace
            await desk.press("f5")
            await desk.until(lambda: running.frames, "the program is on its way")
            workspace.write_copies = lambda: doing.append(running.state)
            desk.app.call_later(fail)
            await desk.until(lambda: doing, "the fault")

    assert doing[0] in (RunState.STOPPING, RunState.READY)


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
        await desk.shows("The program is done.")

        assert desk.log.count("7") == 12000


# --- stopping and order


@pytest.mark.parametrize("key", ["f8", "ctrl+c"])
@pytest.mark.parametrize("opened", ["f1", "ctrl+p", "ctrl+s"])
async def test_a_program_is_stopped_whatever_is_in_front_of_it(work, key, opened):
    async with work(WAITING, speed=1.0) as desk:
        await desk.press("f5")
        await desk.doing(RunState.RUNNING)
        await desk.press(opened)
        await desk.until(lambda: desk.app.screen is not desk.place, "what is in front")
        await desk.press(key)
        await desk.shows("Stopped at line")


async def test_f5_runs_what_was_typed_just_before_it_and_not_what_comes_after(work):
    async with work() as desk:
        burst(desk, *"SPEAK", "space", *"12345", "f5", "6")
        await desk.shows("The program is done.")

        assert "12345" in desk.log
        assert desk.place.editor.text == "SPEAK 123456"


async def test_a_file_is_saved_with_the_last_letters(work, tmp_path):
    file = tmp_path / "mine.gd"
    file.write_text("FW 1", encoding="utf-8")
    async with work(file=file) as desk:
        desk.place.editor.go_to(1, 5)
        burst(desk, *"2345", "ctrl+s")
        await desk.shows("Saved mine.gd")

    assert file.read_text(encoding="utf-8") == "FW 12345\n"


async def test_a_typed_line_is_done_before_the_key_after_it(work):
    async with work() as desk:
        desk.place.command_line.focus()
        await desk.pilot.pause()
        burst(desk, *"SPEED", "space", "5", "enter", "f12")
        await desk.shows("Speed 10.")

        assert desk.log.index("Speed 5.") < desk.log.index("Speed 10.")


async def test_leaving_at_once_after_typing_asks_to_save(work):
    async with work() as desk:
        burst(desk, *"FW", "ctrl+q")
        await desk.until(lambda: desk.app.screen is not desk.place, "the question")

        assert desk.place.editor.text == "FW"


# --- the way to the linear mode


@pytest.mark.parametrize("word", ["LINEAR", "lineal", " Linear "])
async def test_linear_as_the_only_line_and_enter_changes_the_mode(work, word):
    async with work() as desk:
        desk.place.editor.load_text(word)
        await desk.press("enter")
        await desk.until(lambda: desk.app.session.left_for_linear, "the way out")

        assert desk.place.editor.text == ""


@pytest.mark.parametrize("word", ["TOUR", "passeio"])
async def test_the_tour_that_the_first_lines_offer_begins_from_the_empty_program(work, word):
    async with work() as desk:
        desk.place.editor.load_text(word)
        await desk.press("enter")
        await desk.until(lambda: desk.app.screen is not desk.place, "the tour")

        assert desk.place.editor.text == ""


async def test_recover_in_the_empty_program_gives_the_copy_back(work):
    async with work() as desk:
        desk.place.editor.load_text("recover")
        await desk.press("enter")
        await desk.shows("Nothing to recover.")

        assert desk.place.editor.text == ""


async def test_linear_in_a_program_is_text(work, tmp_path):
    file = tmp_path / "mine.gd"
    file.write_text("", encoding="utf-8")
    async with work(file=file) as desk:
        burst(desk, *"LINEAR", "enter", "a")
        await desk.until(lambda: desk.place.editor.text == "LINEAR\na")

        assert not desk.app.session.left_for_linear


async def test_the_first_line_names_the_way_to_the_linear_mode(work):
    async with work() as desk:
        assert desk.log[0] == "Screen reader? Type LINEAR and Enter."


async def test_leaving_for_the_linear_mode_leaves_no_copy(work, tmp_path):
    async with work() as desk:
        await desk.press(*"FW")
        await desk.until(lambda: list(tmp_path.rglob("*.gd")), "the copy")
        await desk.type_line("LINEAR")
        await desk.until(lambda: desk.app.session.left_for_linear, "the way out")

    assert list(tmp_path.rglob("*.gd")) == []


# --- control characters

NASTY = "\x1b]0;title\x07 \x9b?25l \u202e \u2028 \x00"


async def test_pasted_control_characters_become_blanks(work):
    async with work() as desk:
        desk.app.post_message(events.Paste("FW\x1b1\n\tTR\u20282"))
        await desk.until(lambda: desk.place.editor.text == "FW 1\n\tTR 2", "the paste")
        desk.place.command_line.focus()
        await desk.pilot.pause()
        desk.app.post_message(events.Paste("FW\x1b1"))
        await desk.until(lambda: desk.place.command_line.value == "FW 1", "the second paste")


async def test_no_control_character_is_painted(work):
    async with work() as desk:
        desk.place.editor.load_text(NASTY)
        desk.place.log_lines([(NASTY, "")])
        desk.place.map_pane.entitle(NASTY)
        await desk.pilot.pause()
        painted = "".join(
            segment.text for strip in desk.app.screen._compositor.render_strips() for segment in strip
        )

    assert "title" in painted
    assert not set(NASTY) - set(" ?25l]0;titleh") & set(painted)


# --- words, keys, copies


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("doing", [RunState.READY, RunState.RUNNING, RunState.PAUSED])
async def test_help_and_quit_are_always_in_the_bottom_line(work, language, doing):
    async with work(WAITING, language=language, speed=1.0) as desk:
        if doing is not RunState.READY:
            await desk.press("f7" if doing is RunState.PAUSED else "f5")
            await desk.doing(doing)
            await desk.until(lambda: "F8" in desk.place.keys.words)

        assert "F1 " in desk.place.keys.words
        assert "Ctrl+Q " in desk.place.keys.words


@pytest.mark.parametrize(
    ("language", "asked", "nothing"),
    [
        ("en", "Type what to do", "Nothing of that name."),
        ("pt", "Digite o que fazer", "Nada com esse nome."),
        ("es", "Escribe qué hacer", "Nada con ese nombre."),
    ],
)
async def test_the_palette_speaks_the_language_and_has_no_pictures(work, language, asked, nothing):
    async with work(language=language) as desk:
        await desk.press("ctrl+p")
        await desk.until(lambda: asked in desk.screen, asked)
        seen = desk.screen
        await desk.press(*"zzzz")
        await desk.until(lambda: nothing in desk.screen, nothing)

    assert "🔎" not in seen


@pytest.mark.parametrize("language", languages())
def test_the_help_lists_each_word_once_and_the_palette(language):
    lines = help_text(Words(language), KeyTable())
    entries = [re.split(r"[:(]", line)[0].strip() for line in lines]

    assert [each for each in set(entries) if entries.count(each) > 1] == []
    assert any("Ctrl+P" in line for line in lines)


@pytest.mark.parametrize("timeout", [0.0, 60.0], ids=["halted before the screen answers", "answered"])
async def test_an_interrupt_from_elsewhere_stops_as_the_key_does(work, monkeypatch, timeout):
    monkeypatch.setattr(shutdown, "ANSWER", timeout)
    async with work(WAITING, speed=1.0) as desk:
        await desk.press("f5")
        await desk.doing(RunState.RUNNING)
        await desk.until(lambda: desk.app.controller.ctx.runs.frames)
        os.kill(os.getpid(), signal.SIGINT)
        await desk.shows("Stopped at line")
