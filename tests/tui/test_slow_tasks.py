"""A task that takes longer than a second is reported in words, while the screen stays usable."""

import asyncio
import signal
import threading

import pytest

from donnie_tui.bootstrap import assemble
from donnie_tui.commands import files, program
from donnie_tui.core import recovery
from donnie_tui.core.recovery import CopyFolder, UnsavedCopy, read_copy
from donnie_tui.core.workspace import Workspace
from donnie_tui.settings.settings import Settings
from donnie_tui.tui import run_view, startup
from tests.timeouts import TIMEOUT
from tests.tui import conftest

pytestmark = pytest.mark.slow


@pytest.fixture(autouse=True)
def soon(monkeypatch, tmp_path):
    """What is slow is slow at once."""
    monkeypatch.setattr(run_view, "SLOW", 0.01)
    monkeypatch.setattr(startup, "SLOW", 0.01)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))


@pytest.fixture
def gate():
    """Holds whatever waits for it, until it is opened; never for good."""
    gate = threading.Event()
    yield gate
    gate.set()


@pytest.fixture
def slow_saving(monkeypatch, gate):
    """Programs are saved once the gate is open."""
    save = Workspace.save

    def slowly(self, document, path, text):
        gate.wait(TIMEOUT)
        save(self, document, path, text)

    monkeypatch.setattr(Workspace, "save", slowly)
    return gate


async def _begin_saving(screen, path):
    """Saves until the report that it takes a while."""
    await screen.type_line(f"SAVE {path}")
    await screen.shows(f"Saving {path.name}, it takes a while.")


async def test_a_slow_disk_is_reported_and_blocks_no_key(open_screen, tmp_path, slow_saving):
    path = tmp_path / "walk.gd"
    async with open_screen("FW 1") as screen:
        await _begin_saving(screen, path)
        screen.main.editor.focus()
        await screen.press("x")
        await screen.until(lambda: screen.main.editor.text == "xFW 1", "the letter")
        screen.app.controller.workspace.write_copies()
        assert not path.exists()
        slow_saving.set()
        await screen.shows("Saved walk.gd, 1 line.")
        assert path.read_text() == "FW 1\n"
        assert not screen.app.controller.workspace.document.is_saved, "what was typed meanwhile is not saved"
        screen.app.controller.workspace.write_copies()
        assert _copies_in(tmp_path) == ["xFW 1"], "nor is its copy given up"


async def test_leaving_waits_for_what_is_being_saved(open_screen, tmp_path, slow_saving):
    path = tmp_path / "walk.gd"
    async with open_screen("FW 1") as screen:
        await _begin_saving(screen, path)
        await screen.press("ctrl+q")
        await screen.pilot.pause()
        assert screen.app.is_running
        assert screen.app.screen is screen.main, "nothing is asked"
        slow_saving.set()
        await screen.until(lambda: not screen.app.is_running or screen.app._exit, "the end")
        assert path.read_text() == "FW 1\n"


async def test_the_log_is_saved_to_a_slow_disk_in_the_background(open_screen, monkeypatch, tmp_path, gate):
    """What has no suffix is a text, as in the linear mode."""
    monkeypatch.setattr(files, "write_bytes", _once_open(gate, files.write_bytes))
    path = tmp_path / "my notes.txt"
    async with open_screen("FW 1") as screen:
        await screen.type_line(f'SAVE LOG "{path.with_suffix("")}"')
        await screen.shows("Writing my notes.txt, it takes a while.")
        screen.main.editor.focus()
        await screen.press("x")
        await screen.until(lambda: screen.main.editor.text == "xFW 1", "the letter")
        gate.set()
        await screen.shows("Wrote my notes.txt.")
        assert "> SAVE LOG" in path.read_text(encoding="utf-8")


def _once_open(gate, do):
    def once_open(*given):
        gate.wait(TIMEOUT)
        return do(*given)

    return once_open


def _slow_disk(monkeypatch, gate):
    """Files are read, and copies written, once the gate is open. The list names the waiting functions."""
    came = []

    def slowly(done):
        def do(*given):
            came.append(done.__name__)
            gate.wait(TIMEOUT)
            return done(*given)

        return do

    for module, name in ((recovery, "write_program"), (recovery, "read_program"), (files, "read_program")):
        monkeypatch.setattr(module, name, slowly(getattr(module, name)))
    return came


async def test_a_copy_on_a_slow_disk_holds_no_typing_and_has_the_last_letters(
    open_screen, monkeypatch, tmp_path, gate
):
    came = _slow_disk(monkeypatch, gate)
    async with open_screen("FW 1") as screen:
        await screen.press("a")
        await screen.until(lambda: came, "the first copy is being written")
        await screen.press("b", "c")
        screen.app.controller.workspace.keep_copies()
        screen.app.controller.workspace.keep_copies()
        await screen.press("d")
        screen.app.controller.workspace.keep_copies()
        assert screen.main.editor.text == "abcdFW 1"
        assert len(came) == 1, "one at a time"
        gate.set()
        await screen.until(lambda: _copies_in(tmp_path) == ["abcdFW 1"], "the last letters")


async def test_a_lost_connection_leaves_the_last_copy(open_screen, monkeypatch, tmp_path, gate):
    came = _slow_disk(monkeypatch, gate)
    async with open_screen("FW 1") as screen:
        await screen.press("a")
        await screen.until(lambda: came, "a copy is being written")
        await screen.press("b")
        threading.Timer(0.1, gate.set).start()
        screen.app.shutdown.leave(signal.SIGHUP)
        assert _copies_in(tmp_path) == ["abFW 1"]


async def test_a_program_that_was_given_up_while_its_copy_was_written_is_left_for_recover(
    open_screen, monkeypatch, tmp_path, gate
):
    came = _slow_disk(monkeypatch, gate)
    async with open_screen("FW 1") as screen:
        await screen.press("a")
        await screen.until(lambda: came, "a copy is being written")
        await screen.press("ctrl+n")
        await screen.answer("no")
        await screen.shows("This is a new program.")
        gate.set()
    assert _copies_in(tmp_path) == ["aFW 1"]


async def test_leaving_while_a_copy_is_written_keeps_it_for_recover(open_screen, monkeypatch, tmp_path, gate):
    came = _slow_disk(monkeypatch, gate)
    async with open_screen("FW 1") as screen:
        await screen.press("a")
        await screen.until(lambda: came, "a copy is being written")
        await screen.press("ctrl+q")
        await screen.answer("no")
        await screen.until(lambda: not screen.app.is_running or screen.app._exit, "the end")
        gate.set()
    assert _copies_in(tmp_path) == ["aFW 1"]


async def test_a_slow_file_is_reported_and_typed_text_is_replaced_only_after_a_question(
    open_screen, monkeypatch, tmp_path, gate
):
    path = tmp_path / "walk.gd"
    path.write_text("FW 1\n")
    _slow_disk(monkeypatch, gate)
    async with open_screen() as screen:
        await screen.type_line(f"OPEN {path}")
        await screen.shows("Opening walk.gd, it takes a while.")
        screen.main.editor.focus()
        await screen.press("x")
        await screen.until(lambda: screen.main.editor.text == "x", "the letter")
        gate.set()
        await screen.answer("no")
        await screen.shows("Opened walk.gd, 1 line.")
        assert screen.main.editor.text == "FW 1"


async def test_another_command_cancels_opening_and_that_is_reported(open_screen, monkeypatch, tmp_path, gate):
    path = tmp_path / "walk.gd"
    path.write_text("FW 1\n")
    _slow_disk(monkeypatch, gate)
    read, has_read = files.read_program, threading.Event()
    monkeypatch.setattr(files, "read_program", lambda path: (read(path), has_read.set())[0])
    async with open_screen() as screen:
        await screen.type_line(f"OPEN {path}")
        await screen.shows("Opening walk.gd, it takes a while.")
        await screen.type_line("OPEN")
        await screen.shows("Nothing was changed.")
        await screen.press("escape")
        gate.set()
        await screen.until(has_read.is_set, "the file that is no longer wanted")
        await asyncio.to_thread(has_read.wait)  # what came of it is at the screen before this is
        await screen.type_line("POS")
        await screen.shows("> POS")
        assert screen.main.editor.text == ""
        assert not any(line.startswith("Opened") for line in screen.log)


async def test_a_file_of_the_command_line_that_comes_slowly_leaves_the_screen_alive(
    open_screen, monkeypatch, tmp_path, gate
):
    path = tmp_path / "walk.gd"
    path.write_text("FW 1\n")
    _slow_disk(monkeypatch, gate)
    async with open_screen(file=path) as screen:
        await screen.shows("Opening walk.gd, it takes a while.")
        await screen.type_line("POS")
        await screen.shows("> POS")
        gate.set()
        await screen.shows("Opened walk.gd, 1 line.")


async def test_a_program_comes_back_with_the_name_of_its_file(open_screen, tmp_path):
    path = tmp_path / "walk.gd"
    path.write_text("FW 1\n")
    lost = UnsavedCopy(CopyFolder(str(tmp_path / "unsaved")))
    lost.want("FW 12", path)
    lost.write()
    async with open_screen() as screen:
        await screen.type_line("RECOVER")
        await screen.shows("walk.gd is back, 1 line.")
        assert screen.app.controller.workspace.document.path == path
        assert "walk.gd, changed" in screen.text
        await screen.until(lambda: len(_copies_in(tmp_path)) == 1, "one copy, this start's own")
        await screen.press("ctrl+s")
        await screen.shows("Saved walk.gd")
        assert path.read_text() == "FW 12\n"
        await screen.until(lambda: not _copies_in(tmp_path), "no copy is needed")


def _copies_in(folder):
    return [read_copy(each).text for each in (folder / "unsaved").glob("*.gd")]


async def test_a_huge_program_that_is_being_parsed_is_reported(open_screen, monkeypatch):
    async with open_screen("WAIT 1000", speed=1.0) as screen:
        monkeypatch.setattr(type(screen.app.controller.ctx.runs), "frames", property(lambda _: ()))
        await screen.press("f5")
        await screen.shows("Reading 1 line of program.")
        await screen.press("f8")
        await screen.idle()


async def test_a_program_that_changes_during_formatting_is_not_formatted(open_screen, monkeypatch, gate):
    lay_out = program.formatted

    def slowly(text, language):
        gate.wait(TIMEOUT)
        return lay_out(text, language)

    monkeypatch.setattr(program, "formatted", slowly)
    async with open_screen("fw 1   tr 90") as screen:
        await screen.press("ctrl+k", "m")
        await screen.shows("Tidying the program, it takes a while.")
        await screen.press("home")
        screen.main.editor.insert("-- mine\n", (0, 0))
        gate.set()
        await screen.shows("The program was changed meanwhile")
        assert screen.main.editor.text == "-- mine\nfw 1   tr 90"


async def test_a_formatting_that_another_word_replaces_is_still_answered(
    open_screen, monkeypatch, gate, tmp_path
):
    monkeypatch.setattr(program, "formatted", lambda *_: gate.wait(TIMEOUT))
    async with open_screen("fw 1   tr 90") as screen:
        await screen.type_line("FORMAT")
        await screen.shows("Tidying the program, it takes a while.")
        await screen.type_line(f"SAVE {tmp_path / 'mine'}")
        await screen.shows("Nothing was changed.")
        await screen.shows("Saved mine.gd, 1 line.")
        gate.set()


async def test_a_report_is_written_to_its_end_whatever_is_asked_meanwhile(
    open_screen, monkeypatch, gate, tmp_path
):
    def slowly(path, content):
        gate.wait(TIMEOUT)
        path.write_bytes(content)

    monkeypatch.setattr(files, "write_bytes", slowly)
    async with open_screen("FW 1") as screen:
        await screen.type_line(f"REPORT list {tmp_path / 'list.html'}")
        await screen.shows("list.html, it takes a while.")
        await screen.type_line("SEARCH FW")
        await screen.shows("Line 1: FW 1")
        gate.set()
        await screen.shows("Wrote list.html.")


async def test_a_large_world_is_reported_while_it_loads_and_when_it_is_ready(open_screen, monkeypatch, gate):
    tell = startup.Startup._print

    def report_early(self, code, **values):
        tell(self, code, **values)
        gate.set()

    def slowly(settings, **others):
        gate.wait(TIMEOUT)
        return assemble(Settings(world="open_floor", speech="off", sound=False, speed=None), **others)

    monkeypatch.setattr(startup.Startup, "_print", report_early)
    monkeypatch.setattr(conftest, "assemble", slowly)
    async with open_screen(world="my/large.world") as screen:
        await screen.shows("Loading the world large.world, it takes a while.")
        await screen.shows("The world large.world is ready.")
