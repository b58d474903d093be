"""The wheel holds our packages with their data and nothing else, and what it installs starts."""

import subprocess
import sys
import venv
import zipfile
from pathlib import Path

import pytest

from language.locales import languages
from tests.conftest import ROOT
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow

ROOTS = {"donnie_tui", "language", "sim", "devices", "worlds"}


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    # isolated, as pip builds it: what is compiled already is read by what the build requires
    command = [sys.executable, "-m", "build", "--wheel", "--outdir", str(folder), str(ROOT)]
    subprocess.run(command, check=True, capture_output=True, timeout=TIMEOUT)
    return next(folder.glob("donnie_tui-*.whl"))


def test_the_roots_are_ours_alone(wheel: Path) -> None:
    roots = {name.split("/")[0] for name in zipfile.ZipFile(wheel).namelist()}

    assert {root for root in roots if not root.endswith(".dist-info")} == ROOTS


def test_every_data_file_of_the_packages_is_in_the_wheel(wheel: Path) -> None:
    tracked = subprocess.run(
        ["git", "ls-files", *ROOTS], cwd=ROOT, check=True, capture_output=True, text=True
    )

    edited = {
        name for name in tracked.stdout.split() if name.endswith((".po", ".toml")) and "/locales/" in name
    }
    assert set(tracked.stdout.split()) - edited <= set(zipfile.ZipFile(wheel).namelist())


@pytest.mark.parametrize("language", languages())
def test_the_documents_are_where_an_installed_donnie_names_them(wheel: Path, language: str) -> None:
    names = zipfile.ZipFile(wheel).namelist()

    assert f"donnie_tui/docs/{language}/README.md" in names
    assert "donnie_tui/docs/language.md" in names


@pytest.mark.parametrize("language", languages())
def test_the_wheel_has_what_is_compiled_of_each_language_and_not_what_translators_edit(
    wheel: Path, language: str
) -> None:
    folder = f"donnie_tui/i18n/locales/{language}/"
    names = {
        each.removeprefix(folder) for each in zipfile.ZipFile(wheel).namelist() if each.startswith(folder)
    }

    compiled = ("messages.mo", "start.txt", "keywords.json", "commands.json", "words.json")
    assert names == {f"compiled/{each}" for each in compiled}


def test_the_commands_are_installed(wheel: Path) -> None:
    archive = zipfile.ZipFile(wheel)
    entry_points = next(name for name in archive.namelist() if name.endswith("entry_points.txt"))
    lines = archive.read(entry_points).decode().splitlines()

    assert {"donnie", "godonnie", "GoDonnie", "donnie_player"} <= {line.split(" = ")[0] for line in lines}


def test_what_is_installed_from_the_wheel_runs_a_program(wheel: Path, tmp_path: Path) -> None:
    """The libraries are borrowed from the tests' environment; our packages come from the wheel alone."""
    venv.create(tmp_path / "env", with_pip=False, symlinks=True)
    site = next((tmp_path / "env").glob("lib/python*/site-packages"))
    zipfile.ZipFile(wheel).extractall(site)
    (site / "borrowed.pth").write_text(borrowed_libraries(tmp_path))
    program = tmp_path / "walk.gd"
    program.write_text("FW 3 SPEAK POS y")

    done = subprocess.run(
        [str(tmp_path / "env/bin/python"), "-m", "donnie_tui", "run", str(program), "--speech", "off"],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        timeout=TIMEOUT,
    )

    assert done.stdout.splitlines() == ["I walked 3 steps forward.", "3"], done.stderr


def borrowed_libraries(tmp_path: Path) -> str:
    """A folder with links to the installed libraries, without the editable install of this checkout."""
    import lark

    libraries = tmp_path / "libraries"
    libraries.mkdir()
    for each in Path(lark.__file__).parent.parent.iterdir():
        if "donnie" not in each.name.lower() and each.suffix != ".pth":
            (libraries / each.name).symlink_to(each)
    return f"{libraries}\n"
