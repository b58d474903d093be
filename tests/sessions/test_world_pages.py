"""The pages about worlds of all languages: what they type does what they print, in an empty folder."""

import re
import shlex
import shutil
from pathlib import Path

import pytest

from donnie_tui.i18n.words import Words
from sim.worldfile import load_world
from tests.conftest import ROOT
from tests.sessions.command import QUIET, donnie

pytestmark = pytest.mark.slow

PAGES = [("en", "docs/worlds.md"), ("pt", "docs/pt/mundos.md"), ("es", "docs/es/mundos.md")]


def blocks_of(page: str) -> list[str]:
    text = (ROOT / page).read_text(encoding="utf-8")
    return re.findall(r"^```(?:text)?\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)


@pytest.mark.parametrize(("language", "page"), PAGES)
def test_a_room_is_furnished_as_the_page_says(language: str, page: str, tmp_path: Path) -> None:
    (talk,) = (each for each in blocks_of(page) if each.startswith("> "))
    lines = talk.splitlines()
    typed = [line.removeprefix("> ") for line in lines if line.startswith("> ")]
    name = typed[-1].split()[-1]
    assert donnie(tmp_path, "world", "new", name, "--lang", language).returncode == 0

    options = ("--linear", "--lang", language, "--world", f"{name}.world", *QUIET)
    done = donnie(tmp_path, *options, typed="\n".join(typed) + "\n")

    slow = Words(language)("slow-world", name=f"{name}.world")
    printed = [line for line in done.stdout.decode().splitlines() if line != slow]  # on a busy machine
    answers = [line for line in lines if not line.startswith("> ")]
    assert printed[2 : 2 + len(answers)] == answers


@pytest.mark.parametrize(("language", "page"), PAGES)
def test_a_drawing_becomes_the_world_that_the_page_says(language: str, page: str, tmp_path: Path) -> None:
    drawing = next(each for each in blocks_of(page) if each.startswith("#"))
    text = (ROOT / page).read_text(encoding="utf-8")
    command = next(line for line in text.splitlines() if re.match(r"    donnie world new \S+ --from", line))
    _, *arguments = shlex.split(command)
    (tmp_path / arguments[arguments.index("--from") + 1]).write_text(drawing, encoding="utf-8")

    done = donnie(tmp_path, *arguments)

    assert (done.returncode, done.stderr) == (0, b"")
    for block in blocks_of(page):
        if block.startswith(f"{arguments[2]}.world"):
            assert done.stdout.decode() == block


@pytest.mark.parametrize(("language", "page"), PAGES[1:])
def test_every_thing_is_named_on_the_page(language: str, page: str) -> None:
    from donnie_tui.world.things import KINDS, word_for

    text = " ".join((ROOT / page).read_text(encoding="utf-8").split())

    assert [kind for kind in KINDS if word_for(kind, Words(language)) not in text] == []


@pytest.mark.parametrize(("language", "page"), PAGES[1:])
def test_the_files_for_paper_are_written_as_the_page_says(language: str, page: str, tmp_path: Path) -> None:
    text = (ROOT / page).read_text(encoding="utf-8")
    donnie(tmp_path, "world", "new", "sala", "--lang", language)
    commands = [
        line for line in text.splitlines() if re.match(r"    donnie world sala.world --(?:brf|svg)", line)
    ]

    assert len(commands) == 2
    assert [donnie(tmp_path, *shlex.split(each)[1:]).returncode for each in commands] == [0, 0]
    assert sorted(each.name for each in tmp_path.iterdir()) == ["sala.brf", "sala.svg", "sala.world"]


@pytest.mark.parametrize(("language", "page"), PAGES)
def test_stage_needs_what_the_page_says_from_the_folder_of_the_report(
    language: str, page: str, tmp_path: Path
) -> None:
    text = (ROOT / page).read_text(encoding="utf-8")
    *_, world = re.findall(r"^    donnie world (\w+\.world) --report", text, re.MULTILINE)
    (quoted,) = re.findall(r"^> (.*inc, .*) `?[A-Z]+`?\.$", text, re.MULTILINE)
    donnie(tmp_path, "world", "new", world, "--lang", language)

    printed = donnie(tmp_path, "world", world, "--report", "--lang", language).stdout.decode()

    (folder,) = re.findall(rf"^{re.escape(quoted)} (.*)\.$", printed, re.MULTILINE)
    for name in re.findall(r"\w+\.inc", quoted):
        shutil.copy(Path(folder, name), tmp_path)
    assert load_world(tmp_path / world).robot_names == ("donnie",)  # what the folder has is enough
