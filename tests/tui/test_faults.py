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
from donnie_tui.tui import environment, shutdown
from donnie_tui.tui.app import DonnieApp
from donnie_tui.tui.pane_text import help_text
from donnie_tui.tui.shutdown import CRASHED, FAULT
from donnie_tui.tui.startup import SessionHandle
from language.locales import languages
from tests.tui.conftest import COMPUTING, WAITING, burst

pytestmark = pytest.mark.slow

COLOURED = re.compile(r"\x1b\[[0-9;]*(?:38|48);2;")


@pytest.mark.parametrize("lines", [2, 12, 13, 14, 100])
async def test_undo_of_a_paste_of_any_length_gives_the_empty_program_back(open_screen, lines):
    async with open_screen() as screen:
        for _ in range(2):
            screen.app.post_message(events.Paste("".join(f"SPEAK {i}\n" for i in range(lines))))
            await screen.until(lambda: screen.main.editor.line_count == lines + 1)
            await screen.pilot.pause()
            await screen.press("ctrl+z")
            await screen.until(lambda: screen.main.editor.text == "")
            await screen.pilot.pause()


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


async def test_a_fault_in_a_thread_of_the_screen_has_the_code_of_a_fault(tmp_path: Path):
    settings = Settings(speech="off", sound=False)
    app = DonnieApp(settings, assemble=lambda: assemble(settings, terminal=True), folder=tmp_path)
    app._print_error_renderables = lambda: None
    async with app.run_test() as pilot:
        while app.controller is None:
            await pilot.pause(0.01)
        app.panic("a page of traceback")

    assert app.return_code == CRASHED
    assert (tmp_path / "unsaved" / FAULT).exists()


async def test_an_internal_fault_halts_the_robot_before_the_text_is_saved(open_screen):
    """Keeping the text may take its time."""
    states: list[RunState] = []

    def fail() -> None:
        raise RuntimeError

    with pytest.raises(RuntimeError):
        async with open_screen(WAITING, speed=1.0) as screen:
            screen.app._print_error_renderables = lambda: None
            running, workspace = screen.app.controller.ctx.runs, screen.app.controller.workspace
            await screen.press("f5")
            await screen.until(lambda: running.frames, "the program is on its way")
            workspace.write_copies = lambda: states.append(running.state)
            screen.app.call_later(fail)
            await screen.until(lambda: states, "the fault")

    assert states[0] in (RunState.STOPPING, RunState.READY)


async def test_without_colours_the_terminal_s_own_are_left_alone(open_screen, monkeypatch):
    monkeypatch.setenv("NO_COLOR", "1")
    async with open_screen("FW 1") as screen:
        kinds = {type(each) for each in screen.app._filters}
        strips = screen.app.screen._compositor.render_strips()
        painted = "".join(strip.render(screen.app.console) for strip in strips)

    assert NoColor in kinds
    assert Monochrome not in kinds
    assert not COLOURED.search(painted)


async def test_nothing_that_was_spoken_is_missing_from_the_log(open_screen):
    async with open_screen("REPEAT 12000 TIMES\nSPEAK 7\nEND REPEAT") as screen:
        await screen.press("f5")
        await screen.shows("The program is done.")

        assert screen.log.count("7") == 12000


# --- stopping and order


@pytest.mark.parametrize("key", ["f8", "ctrl+c"])
@pytest.mark.parametrize("opened", ["f1", "ctrl+p", "ctrl+s"])
async def test_a_program_is_stopped_whatever_is_in_front_of_it(open_screen, key, opened):
    async with open_screen(WAITING, speed=1.0) as screen:
        await screen.press("f5")
        await screen.reaches(RunState.RUNNING)
        await screen.press(opened)
        await screen.until(lambda: screen.app.screen is not screen.main, "what is in front")
        await screen.press(key)
        await screen.shows("Stopped at line")


async def test_f5_runs_what_was_typed_just_before_it_and_not_what_comes_after(open_screen):
    async with open_screen() as screen:
        burst(screen, *"SPEAK", "space", *"12345", "f5", "6")
        await screen.shows("The program is done.")

        await screen.shows("12345")
        assert screen.main.editor.text == "SPEAK 123456"


async def test_a_file_is_saved_with_the_last_letters(open_screen, tmp_path):
    file = tmp_path / "mine.gd"
    file.write_text("FW 1", encoding="utf-8")
    async with open_screen(file=file) as screen:
        screen.main.editor.go_to(1, 5)
        burst(screen, *"2345", "ctrl+s")
        await screen.shows("Saved mine.gd")

    assert file.read_text(encoding="utf-8") == "FW 12345\n"


async def test_a_typed_line_is_done_before_the_key_after_it(open_screen):
    async with open_screen() as screen:
        screen.main.command_line.focus()
        await screen.pilot.pause()
        burst(screen, *"SPEED", "space", "5", "enter", "f12")
        await screen.shows("Speed 10.")

        assert screen.log.index("Speed 5.") < screen.log.index("Speed 10.")


async def test_leaving_at_once_after_typing_asks_to_save(open_screen):
    async with open_screen() as screen:
        burst(screen, *"FW", "ctrl+q")
        await screen.until(lambda: "Save first, y or n?" in screen.text, "the question")

        assert screen.main.editor.text == "FW"


def test_what_was_typed_before_the_session_is_kept_once(tmp_path):
    session = SessionHandle(None, lambda: "FW 3", tmp_path / "unsaved")

    session.keep_text()
    session.keep_text()

    assert [each.read_text() for each in tmp_path.rglob("unsaved-*.gd")] == ["FW 3\n"]


# --- the way to the linear mode


PROGRAM = "FW 1"


@pytest.mark.parametrize("word", ["LINEAR", "lineal", " Linear "])
@pytest.mark.parametrize("text", ["", PROGRAM])
async def test_linear_on_a_line_of_its_own_changes_the_mode(open_screen, text, word):
    async with open_screen(text) as screen:
        type_on_last_line(screen, word)
        await screen.until(lambda: screen.app.session.left_for_linear, "the way out")

        assert screen.main.editor.text == (f"{text}\n" if text else "")


@pytest.mark.parametrize("word", ["TOUR", "passeio", "help", "AJUDA"])
async def test_the_tour_and_the_help_open_from_a_line_of_the_program(open_screen, word):
    async with open_screen(PROGRAM) as screen:
        type_on_last_line(screen, word)
        await screen.until(
            lambda: screen.app.screen is not screen.main or "Tour 1 of" in screen.text,
            "what was asked for",
        )

        assert screen.main.editor.text == f"{PROGRAM}\n"


async def test_a_challenge_is_entered_from_a_line_of_the_program(open_screen):
    async with open_screen(PROGRAM) as screen:
        type_on_last_line(screen, "challenge 2")
        await screen.until(lambda: screen.app.controller.next_world == "challenge:2", "the challenge")

        assert screen.main.editor.text == f"{PROGRAM}\n"


async def test_the_words_of_a_challenge_work_on_a_line_of_the_program(open_screen):
    async with open_screen(world="challenge:to_the_ball") as screen:
        type_on_last_line(screen, "hint")
        await screen.shows("Turn right by 90 degrees first.")
        type_on_last_line(screen, "metas")
        await screen.shows("Goal 1: ")

        assert screen.main.editor.text == ""


@pytest.mark.parametrize(
    ("language", "word", "done", "is_busy", "stop"),
    [
        ("en", "RUN", "The program is done.", "A program is running.", "STOP"),
        ("pt", "rodar", "O programa terminou.", "Um programa está em execução.", "parar"),
        ("es", "Correr", "El programa terminó.", "Un programa se está ejecutando.", "Detener"),
    ],
)
async def test_run_on_a_line_of_its_own_runs_the_program(open_screen, language, word, done, is_busy, stop):
    """While one runs that is said, and the word that stops it does so on a line, too."""
    async with open_screen("FW 1", language=language) as screen:
        type_on_last_line(screen, word)
        await screen.shows(done)
        await screen.idle()
        assert screen.main.editor.text == "FW 1\n"

        screen.load(COMPUTING)
        await screen.press("f5")
        await screen.reaches(RunState.RUNNING)
        type_on_last_line(screen, word)
        await screen.shows(is_busy)
        type_on_last_line(screen, stop)
        await screen.idle()
        assert screen.main.editor.text.rstrip("\n") == COMPUTING


async def test_any_command_works_on_a_line_of_the_program(open_screen, tmp_path):
    async with open_screen("FW 1\nFWD 2\nWAIT 1000", speed=1.0) as screen:
        text = "FW 1\nFWD 2\nWAIT 1000"
        type_on_last_line(screen, "save log said.txt")
        await screen.until(lambda: (tmp_path / "said.txt").exists(), "the file")
        type_on_last_line(screen, "erros")
        await screen.until(lambda: screen.app.screen is not screen.main, "the mistakes")
        await screen.press("escape")
        await screen.until(lambda: screen.app.screen is screen.main, "the program")
        type_on_last_line(screen, "dónde")
        await screen.shows("Position 0, 0")
        assert screen.main.editor.text.rstrip("\n") == text

        screen.load("FW 1\nWAIT 1000")
        type_on_last_line(screen, "step")
        await screen.shows("Line 1: FW 1")
        type_on_last_line(screen, "run")
        await screen.reaches(RunState.RUNNING)
        type_on_last_line(screen, "pause")
        await screen.shows("Paused at line 1.")
        await screen.pilot.pause()  # the cursor went to that line
        type_on_last_line(screen, "stop")
        await screen.idle()
        assert screen.main.editor.text.rstrip("\n") == "FW 1\nWAIT 1000"


async def test_undo_on_a_line_of_the_program_undoes_what_was_before_it(open_screen):
    async with open_screen("FW 1\nFW 2") as screen:
        screen.main.editor.focus()
        await screen.type_line("DELETE 1")
        await screen.until(lambda: screen.main.editor.text == "FW 2", "the change")
        screen.main.editor.focus()
        screen.main.editor.move_cursor(screen.main.editor.document.end)
        await screen.press("enter", *"undo", "enter")
        await screen.until(lambda: "undo" not in screen.main.editor.text, "the word")
        await screen.until(lambda: screen.main.editor.text == "FW 2", "the new line is undone")
        await screen.press("ctrl+end", "enter", *"undo", "enter", "ctrl+end", "enter", *"undo", "enter")
        await screen.until(lambda: screen.main.editor.text == "FW 2", "the same")


async def test_a_program_is_saved_and_opened_from_a_line_of_it(open_screen, tmp_path):
    async with open_screen("FW 1") as screen:
        type_on_last_line(screen, "save one.gd")
        await screen.until(lambda: (tmp_path / "one.gd").exists(), "the file")
        assert (tmp_path / "one.gd").read_text() == "FW 1\n"
        (tmp_path / "two.gd").write_text("FW 2\n")
        type_on_last_line(screen, "open two.gd")
        await screen.answer("no")  # the line on which that was typed is not saved
        await screen.until(lambda: screen.main.editor.text == "FW 2", "the other program")


async def test_recover_on_a_line_of_its_own_gives_the_copy_back(open_screen):
    async with open_screen() as screen:
        type_on_last_line(screen, "recover")
        await screen.shows("There is nothing to recover.")

        assert screen.main.editor.text == ""


async def test_quit_between_two_lines_is_taken_out_and_leaves(open_screen, tmp_path):
    file = tmp_path / "mine.gd"
    file.write_text("FW 1\nFW 2\n", encoding="utf-8")
    async with open_screen(file=file) as screen:
        before = screen.main.editor.text
        screen.main.editor.move_cursor((1, 0))
        burst(screen, "enter", "up", *"QUIT", "enter")
        await screen.until(
            lambda: not screen.app.is_running or screen.app.screen is not screen.main, "the end"
        )

        assert screen.main.editor.text == before


@pytest.mark.parametrize(
    "typed", ["QUIT FW 1", "SPEAK linear", "linear = 1", "tour 2", "challenge = 1", "run 2"]
)
async def test_a_word_with_other_text_on_its_line_is_text(open_screen, typed):
    async with open_screen() as screen:
        type_on_last_line(screen, typed)
        await screen.until(lambda: screen.main.editor.text == f"{typed}\n", "the line")

        assert screen.app.screen is screen.main


@pytest.mark.parametrize(("answer", "is_offered"), [("", True), ("off", False), ("on", False)])
async def test_over_ssh_the_first_row_offers_the_linear_mode(open_screen, monkeypatch, answer, is_offered):
    """A reader on this machine may be another person's, so it changes nothing."""
    monkeypatch.setenv("SSH_CONNECTION", "10.0.0.2 50000 10.0.0.1 22")
    monkeypatch.setenv("DONNIE_READER", answer)
    monkeypatch.setattr(environment, "_screen_reader_runs", lambda: True)
    async with open_screen(plain=False) as screen:
        offer = "Screen reader? Type LINEAR and Enter. Also: HELP, TOUR, RECOVER, QUIT."
        assert (screen.text.splitlines()[0].strip() == offer) is is_offered


def type_on_last_line(screen, text: str) -> None:
    editor = screen.main.editor
    editor.move_cursor(editor.document.end)
    burst(
        screen,
        *(["enter"] if editor.text else []),
        *("space" if each == " " else each for each in text),
        "enter",
    )


async def test_the_first_line_names_the_way_to_the_linear_mode(open_screen):
    async with open_screen() as screen:
        assert screen.log[0] == "Screen reader? Type LINEAR and Enter."


async def test_leaving_for_the_linear_mode_leaves_no_copy(open_screen, tmp_path):
    async with open_screen() as screen:
        await screen.press(*"FW")
        await screen.until(lambda: list(tmp_path.rglob("*.gd")), "the copy")
        await screen.type_line("LINEAR")
        await screen.until(lambda: screen.app.session.left_for_linear, "the way out")

    assert list(tmp_path.rglob("*.gd")) == []


# --- control characters

NASTY = "\x1b]0;title\x07 \x9b?25l \u202e \u2028 \x00"


async def test_pasted_control_characters_become_blanks(open_screen):
    async with open_screen() as screen:
        screen.app.post_message(events.Paste("FW\x1b1\n\tTR\u20282"))
        await screen.until(lambda: screen.main.editor.text == "FW 1\n\tTR 2", "the paste")
        screen.main.command_line.focus()
        await screen.pilot.pause()
        screen.app.post_message(events.Paste("FW\x1b1"))
        await screen.until(lambda: screen.main.command_line.value == "FW 1", "the second paste")


async def test_no_control_character_is_painted(open_screen):
    async with open_screen() as screen:
        screen.main.editor.load_text(NASTY)
        screen.main.log_lines([(NASTY, "")])
        screen.main.map_pane.entitle(NASTY)
        await screen.pilot.pause()
        painted = "".join(
            segment.text for strip in screen.app.screen._compositor.render_strips() for segment in strip
        )

    assert "title" in painted
    assert not set(NASTY) - set(" ?25l]0;titleh") & set(painted)


# --- words, keys, copies


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("state", [RunState.READY, RunState.RUNNING, RunState.PAUSED])
async def test_help_and_quit_are_always_in_the_bottom_line(open_screen, language, state):
    async with open_screen(WAITING, language=language, speed=1.0) as screen:
        if state is not RunState.READY:
            await screen.press("f7" if state is RunState.PAUSED else "f5")
            await screen.reaches(state)
            await screen.until(lambda: "F8" in screen.main.keys.words)

        assert "F1 " in screen.main.keys.words
        assert "Ctrl+Q " in screen.main.keys.words


@pytest.mark.parametrize(
    ("language", "asked", "nothing"),
    [
        ("en", "Type what to do", "Nothing has that name."),
        ("pt", "Digite o que fazer", "Nada com esse nome."),
        ("es", "Escribe qué hacer", "Nada con ese nombre."),
    ],
)
async def test_the_palette_speaks_the_language_and_has_no_pictures(open_screen, language, asked, nothing):
    async with open_screen(language=language) as screen:
        await screen.press("ctrl+p")
        await screen.until(lambda: asked in screen.text, asked)
        seen = screen.text
        await screen.press(*"zzzz")
        await screen.until(lambda: nothing in screen.text, nothing)

    assert "🔎" not in seen


@pytest.mark.parametrize("language", languages())
def test_the_help_lists_each_word_once_and_the_palette(language):
    lines = help_text(Words(language), KeyTable())
    entries = [re.split(r"[:(]", line)[0].strip() for line in lines]

    assert [each for each in set(entries) if entries.count(each) > 1] == []
    assert any("Ctrl+P" in line for line in lines)


@pytest.mark.parametrize("timeout", [0.0, 60.0], ids=["halted before the screen answers", "answered"])
async def test_an_interrupt_from_elsewhere_stops_as_the_key_does(open_screen, monkeypatch, timeout):
    monkeypatch.setattr(shutdown, "ANSWER", timeout)
    async with open_screen(WAITING, speed=1.0) as screen:
        await screen.press("f5")
        await screen.reaches(RunState.RUNNING)
        await screen.until(lambda: screen.app.controller.ctx.runs.frames)
        os.kill(os.getpid(), signal.SIGINT)
        await screen.shows("Stopped at line")
