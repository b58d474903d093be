"""The full screen in a confined session: each word that names a file, and no other program."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from contextlib import nullcontext
from pathlib import Path

import pytest

import worlds
from donnie_tui.process.confinement import Confinement, confine
from tests.tui.terminal import Terminal

pytestmark = pytest.mark.slow


@pytest.fixture
def outside(tmp_path: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A file of the teacher; the pupil's folder, which has a link to it, is ``tmp_path``."""
    folder = tmp_path_factory.mktemp("teacher")
    (folder / "secret.gd").write_text("SPEAK 4711\n")
    (tmp_path / "link.gd").symlink_to(folder / "secret.gd")
    confine(Confinement(str(tmp_path), readable=(worlds.SCENES, worlds.MANUAL)))
    yield folder
    confine(None)


@pytest.mark.parametrize("word", ["OPEN", "SAVE", "SAVE AS", "SAVE LOG", "REPORT LIST", "WORLD", "WORLDS"])
async def test_no_word_leaves_the_folder(open_screen, outside, tmp_path, word):
    async with open_screen("FW 1") as screen:
        for name in ("link.gd", f"{outside}/secret.gd"):
            await screen.type_line(f"{word} {name}")
            await screen.until(
                lambda name=name: f"{name} is not in your folder. Stay in it." in screen.log, "refusal"
            )
        await screen.type_line(f"{word} .profile.gd")
        await screen.until(lambda: ".profile.gd is hidden. Begin without a dot." in screen.log, "the refusal")

        assert screen.main.editor.text == "FW 1"
    assert [each.name for each in outside.iterdir()] == ["secret.gd"]
    assert (outside / "secret.gd").read_text() == "SPEAK 4711\n"


async def test_a_refused_name_is_asked_again(open_screen, outside, tmp_path):
    (tmp_path / "mine.gd").write_text("FW 2\n")
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await screen.answer("link.gd")
        await screen.until(lambda: "is not in your folder." in screen.text, "the reason")
        await screen.answer("mine.gd")
        await screen.shows("Opened mine.gd")


async def test_the_programs_to_open_are_those_of_the_folder(open_screen, outside, tmp_path):
    """No row leads out, hidden ones are not shown, and a typed folder outside says so."""
    (tmp_path / "sub").mkdir()
    (tmp_path / "mine.gd").write_text("FW 2\n")
    (tmp_path / "sub" / "deep.gd").write_text("FW 3\n")
    (tmp_path / "sub" / "out").symlink_to(outside)
    (tmp_path / ".donnie").mkdir()
    (tmp_path / ".donnie" / "hidden.gd").write_text("FW 4\n")
    (tmp_path / "recent.txt").write_text(f"{outside}/secret.gd\n{tmp_path}/mine.gd\n")
    async with open_screen() as screen:
        await screen.press("ctrl+o")
        await screen.until(lambda: "sub/" in screen.text, "the programs")
        await screen.press("down", "end")
        while "sub/" not in screen.app.screen.files.row.text:
            await screen.press("up")
        await screen.press("right")
        await screen.until(lambda: "deep.gd" in screen.text, "the folder")
        files = screen.app.screen.files
        rows = [screen.app.screen._row_at(at).text for at in range(files.last_line + 1)]
        assert rows[:2] == ["Recent programs", "mine.gd"]
        assert [each for each in rows[2:] if each not in ("unsaved/", "config/")] == [
            f"{tmp_path.name}/",
            "mine.gd",
            "sub/",
            "deep.gd",
        ]

        for typed in (f"{outside}/", "../", "/", "~/", "sub/out/"):
            screen.app.screen.query_one("#answer").value = typed
            await screen.until(lambda: "is not in your folder." in " ".join(screen.text.split()), typed)
            assert "secret.gd" not in screen.text
            screen.app.screen.query_one("#answer").value = ""
            await screen.until(lambda: "deep.gd" in screen.text, "the folder")
        screen.app.screen.query_one("#answer").value = ".donnie/"
        await screen.until(lambda: "hidden. Begin without" in " ".join(screen.text.split()), "the reason")
        assert "hidden.gd" not in screen.text


async def test_a_new_program_is_saved_in_the_folder_alone(open_screen, outside, tmp_path):
    async with open_screen("FW 1") as screen:
        await screen.press("ctrl+k", "s")
        await screen.answer(f"{outside}/new.gd")
        await screen.until(
            lambda: f"{outside}/new.gd is not in your folder. Stay in it." in screen.log, "reason"
        )
        await screen.press("ctrl+k", "s")
        await screen.answer("mine")
        await screen.shows("Saved mine.gd")
    assert [each.name for each in outside.iterdir()] == ["secret.gd"]


async def test_the_log_is_on_a_page_and_no_program_starts(open_screen, outside, monkeypatch):
    monkeypatch.setenv("PAGER", "sh")
    monkeypatch.setattr(subprocess, "run", lambda *_, **__: pytest.fail("a program was started"))
    async with open_screen() as screen:
        monkeypatch.setattr(screen.app, "suspend", nullcontext)
        await screen.type_line("WHERE")
        await screen.type_line("LOG")
        await screen.until(lambda: screen.app.screen is not screen.main, "the page")
        assert "Position 0, 0. Facing north." in screen.text
        await screen.press("escape")
        await screen.until(lambda: screen.app.screen is screen.main, "the main screen")


async def test_the_pager_starts_no_shell(open_screen, monkeypatch, tmp_path):
    """Also where nothing is confined: the session may be the only command of a login."""
    pager = tmp_path / "less"
    pager.write_text(f'#!/bin/sh\necho "$LESSSECURE" "$(cat "$1")" > {tmp_path}/shown\n')
    pager.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    async with open_screen() as screen:
        monkeypatch.setattr(screen.app, "suspend", nullcontext)
        await screen.type_line("WHERE")
        await screen.type_line("LOG")
        await screen.until((tmp_path / "shown").exists, "the pager")

    assert (tmp_path / "shown").read_text().startswith("1 ")
    assert "Facing north." in (tmp_path / "shown").read_text()


async def test_without_less_the_log_is_on_a_page(open_screen, monkeypatch, tmp_path):
    """``more`` has a key that starts a shell."""
    (tmp_path / "more").write_text("#!/bin/sh\n")
    (tmp_path / "more").chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    async with open_screen() as screen:
        await screen.type_line("LOG")
        await screen.until(lambda: screen.app.screen is not screen.main, "the page")


def test_the_state_of_a_confined_screen_stays_in_its_folder(tmp_path):
    pupil = tmp_path / "ana"
    pupil.mkdir()
    screen = Terminal(["--visual", "--confined", str(pupil)], tmp_path)
    try:
        screen.shows("READY")
        screen.type("FW 12")
        screen.until(lambda: any((pupil / ".donnie" / "unsaved").glob("*.gd")), "the copy")
    finally:
        screen.close()

    assert [each.name for each in tmp_path.iterdir()] == ["ana"]
