"""The first lines: when they may be printed at once, and in which language."""

import subprocess
import sys
from pathlib import Path

import pytest

from donnie_tui.cli.options import COMMON
from donnie_tui.linear import greeting
from donnie_tui.settings.parsing import SPEECH
from donnie_tui.settings.settings import BY_KEY


@pytest.fixture
def printed(monkeypatch: pytest.MonkeyPatch) -> list[bytes]:
    """What is written, on something that is no terminal."""
    written: list[bytes] = []
    monkeypatch.setattr(greeting.os, "isatty", lambda _: False)
    monkeypatch.setattr(greeting.os, "write", lambda _, data: written.append(data))
    return written


@pytest.mark.parametrize(
    ("arguments", "environment", "first"),
    [
        (["--linear"], {}, b"Linear mode, from the option.\nHELP lists the commands.\n"),
        (["--linear", "--lang", "pt"], {"LANG": "es_ES"}, "Modo linear, pedido na opção.\n".encode()),
        (["--lang=es", "--linear", "--world", "x"], {}, b"Modo lineal, como pediste.\n"),
        (["--linear"], {"DONNIE_LANG": "pt", "LANG": "es_ES"}, "Modo linear, pedido na opção.\n".encode()),
        (["--linear"], {"LC_ALL": "pt_BR.UTF-8", "LANG": "es"}, "Modo linear, pedido na opção.\n".encode()),
        (["--screen-reader"], {}, b"Linear mode, from the option.\nHELP lists the commands.\n"),
        (["--linear"], {"LANG": "de_DE"}, b"Linear mode, from the option.\n"),
    ],
)
def test_a_plain_command_line_is_greeted_early(
    arguments: list[str], environment: dict[str, str], first: bytes, printed: list[bytes]
) -> None:
    assert greeting.begin(arguments, environment)
    assert printed[0].startswith(first)


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["--linear", "--help"],
        ["--linear", "--what"],
        ["run", "--linear"],
        ["--linear", "no-such-file.gd"],
        ["--world", "--linear"],
        ["--linear", "--speech", "xx"],
        ["--linear", "--sound=loud"],
        ["--linear", "--lang", "xx"],
        ["--linear", "--speed", "-3"],
        ["-t"],
    ],
)
def test_any_other_command_line_is_not_greeted_early(arguments: list[str], printed: list[bytes]) -> None:
    assert not greeting.begin(arguments, {})
    assert printed == []


def test_a_variable_that_may_be_wrong_is_looked_at_first(printed: list[bytes]) -> None:
    assert not greeting.begin(["--linear"], {"DONNIE_SPEED": "fast"})


def test_a_program_on_the_command_line_gets_the_second_line(tmp_path: Path, printed: list[bytes]) -> None:
    (tmp_path / "a.gd").write_text("FW 1")
    greeting.begin(["--linear", str(tmp_path / "a.gd")], {})

    assert printed == [b"Linear mode, from the option.\n"]


def test_what_options_take_is_what_the_settings_say() -> None:
    assert set(greeting.PLAIN_VALUES["--speech"]) == set(SPEECH)


def test_the_greeting_knows_which_common_options_are_plain() -> None:
    """A new option belongs to one of the three tables of the greeting, or here, which delays the greeting."""
    late = {"robot", "camera", "record", "belt", "confined", "devices"}
    plain = {*greeting.PLAIN_VALUES, *greeting._WITH_VALUE, *greeting._WITH_NUMBER}

    assert plain == {BY_KEY[key].option for key in COMMON if key not in late}


def test_the_greeting_is_printed_once(printed: list[bytes]) -> None:
    greeted = greeting.begin(["--linear"], {})
    assert greeted
    greeted.greet("en", "option", {})

    assert len(printed) == 1


def test_greeting_loads_next_to_nothing() -> None:
    """The modules that are loaded besides those of Python's own start."""
    code = (
        "import os, sys; before = set(sys.modules); from donnie_tui.linear.greeting import begin;"
        "begin(['--linear'], os.environ); print(*sorted(set(sys.modules) - before))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = done.stdout.splitlines()[-1].split()

    others = {name for name in loaded if not name.startswith("donnie_tui")}
    assert others <= {"__future__", "termios", "language", "language.locales"}
