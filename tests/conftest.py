"""Fixtures for every test, and the environment that each test has."""

import gc
import os
import signal
import sys
from collections.abc import Iterator
from itertools import count
from pathlib import Path

import pytest

from donnie_tui.i18n.translations import TABLES, compile_all
from donnie_tui.i18n.words import COMPILED, SOURCE
from language.locales import compiled_file, folders
from tests.effort import register_profiles
from tests.environment import isolate

isolate()
sys.dont_write_bytecode = False  # as in the child processes

register_profiles()

_homes = count()

for number in (signal.SIGINT, signal.SIGQUIT) if hasattr(signal, "SIGQUIT") else (signal.SIGINT,):
    if signal.getsignal(number) is signal.SIG_IGN:  # a shell ignores them for a command in the background
        signal.signal(number, signal.default_int_handler if number == signal.SIGINT else signal.SIG_DFL)

ROOT = Path(__file__).resolve().parent.parent


def pytest_configure(config: pytest.Config) -> None:
    """Compile the sentences and words of the languages where that is due, once for all workers."""
    if not hasattr(config, "workerinput") and not _is_compiled():
        mistakes = compile_all()
        if mistakes:
            raise pytest.UsageError("\n".join(map(str, mistakes)))


def _is_compiled() -> bool:
    """Whether everything is compiled and up to date."""
    sources = {SOURCE: COMPILED, **{f"{name}.toml": f"{name}.json" for name in TABLES}}
    return all(
        compiled_file(language, source, compiled) is not None
        for language, folder in folders().items()
        for source, compiled in sources.items()
        if Path(folder, source).exists()
    )


# words of which each file with such tests has one
_WORDS = {"slow": ("slow",), "hypothesis and not slow": ("hypothesis", "given")}


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Leave out files without a test of the wanted kind: to read all, each worker needs nine seconds."""
    words = _WORDS.get(config.option.markexpr, ())
    if not words or collection_path.suffix != ".py":
        return None
    text = collection_path.read_text("utf-8")
    return None if any(word in text for word in words) else True


def pytest_collection_finish() -> None:
    """Keep the collector away from thousands of collected tests: a tenth of the processor time of a run."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(20_000, 20, 20)


@pytest.fixture(scope="session", autouse=True)
def _homes_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("homes")


@pytest.fixture(autouse=True)
def _home(_homes_folder: Path) -> Iterator[None]:
    """Each test has a new home folder that does not exist yet, and no limits of a command before it.

    It must leave the working folder as it was: the next test may read the project's files.
    """
    os.environ["HOME"], here = str(_homes_folder / str(next(_homes))), Path.cwd()
    yield
    assert Path.cwd() == here, "the test changed the working folder"
    main = sys.modules.get("donnie_tui.cli.main")
    if main is not None:
        main._lift_limits()


@pytest.fixture(scope="session")
def shared() -> Path:
    """The material in the folder next to the project. Without it the test is skipped."""
    folder = ROOT.parent / "shared"
    if not folder.is_dir():
        pytest.skip("needs the shared material next to the project")
    return folder
