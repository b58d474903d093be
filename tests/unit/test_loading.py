"""Libraries are loaded with something else in the place of what they rarely need, and work as usual."""

import subprocess
import sys
from pathlib import Path

import pytest

from donnie_tui.process import LazyValue, load_with, real_module
from tests.conftest import ROOT
from tests.timeouts import TIMEOUT


def library(folder: Path, monkeypatch: pytest.MonkeyPatch, **texts: str) -> None:
    """Modules that can be imported from a folder."""
    monkeypatch.syspath_prepend(folder)
    for name, text in texts.items():
        (folder / f"{name}.py").write_text(text)
        monkeypatch.delitem(sys.modules, name, raising=False)


def printed(code: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT, timeout=TIMEOUT, check=True
    )


def test_what_is_in_the_place_of_a_module_loads_it_when_it_is_asked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    library(
        tmp_path,
        monkeypatch,
        greets="import rare_one\nfrom rare_one import word\ndef greet(): return rare_one.other, word()",
        rare_one="other = 2\ndef word(): return 'good day'",
    )
    word = LazyValue(lambda: real_module("rare_one").word)
    load_with("greets", rare_one=LazyValue(lambda: real_module("rare_one"), word=word))
    assert "rare_one" not in sys.modules

    assert sys.modules["greets"].greet() == (2, "good day")
    assert sys.modules["rare_one"].__file__ == str(tmp_path / "rare_one.py")


def test_another_thread_that_imports_meanwhile_gets_the_module(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As one that reports a fault while the physics load."""
    library(
        tmp_path,
        monkeypatch,
        loads_long="import rare_two\nanswer = rare_two.answer",
        rare_two="answer = 42",
    )
    load_with("loads_long", rare_two=LazyValue(lambda: real_module("rare_two")))

    assert sys.modules["loads_long"].answer == 42
    assert sys.modules["rare_two"].answer == 42


def test_a_library_is_loaded_as_if_there_were_no_such_module(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = "try:\n    import rare_three\nexcept ImportError:\n    rare_three = 'none'"
    library(tmp_path, monkeypatch, prefers=text, rare_three="")
    load_with("prefers", rare_three=None)

    assert sys.modules["prefers"].rare_three == "none"
    assert real_module("rare_three").__name__ == "rare_three"


def test_a_library_that_fails_leaves_what_was_loaded_before(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    library(tmp_path, monkeypatch, fails="import rare_four\nraise OSError", rare_four="")
    before = real_module("rare_four")
    with pytest.raises(OSError):
        load_with("fails", rare_four=LazyValue(lambda: None))

    assert sys.modules["rare_four"] is before


def test_an_error_of_the_physics_is_logged_under_its_name() -> None:
    """pymunk logs what its library in C reports before it ends the process."""
    done = printed(
        "import sys\n"
        "from sim.ground import _load_pymunk\n"
        "_load_pymunk()\n"
        "print('logging' in sys.modules)\n"
        "from pymunk._callbacks import _logger\n"
        "import logging\n"
        "logging.basicConfig(format='%(name)s: %(message)s')\n"
        "_logger.error('bodies overlap')\n"
    )

    assert done.stdout == "False\n"
    assert done.stderr == "pymunk._callbacks: bodies overlap\n"


def test_msgspec_still_writes_schemas() -> None:
    done = printed(
        "from donnie_tui.__main__ import _load_libraries\n"
        "_load_libraries()\n"
        "import argparse, sys, msgspec, msgspec.json\n"
        "rare = ('typing_extensions', 'msgspec.inspect', 'msgspec._json_schema', 'inspect', 'gettext')\n"
        "print([each for each in rare if each in sys.modules])\n"
        "print(msgspec.json.schema(int), msgspec.inspect.type_info(bool))\n"
    )

    assert done.stdout == "[]\n{'type': 'integer'} BoolType()\n"
