"""The first lines: when they may be printed at once, and in which language."""

import os
import pty
import subprocess
import sys
import termios
from collections.abc import Iterator
from pathlib import Path

import pytest

from donnie_tui.cli.options import COMMON
from donnie_tui.linear import greeting
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


@pytest.mark.parametrize("name", greeting.PLAIN_VALUES)
def test_what_options_take_is_what_the_settings_say(name: str) -> None:
    key = next(each for each in BY_KEY.values() if each.option == name)

    assert {*greeting.PLAIN_VALUES[name]} == {*key.wanted.split(", ")} - {"wav:FILE"}


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


@pytest.fixture
def terminal(monkeypatch: pytest.MonkeyPatch) -> Iterator[int]:
    """A terminal in the place of standard input."""
    controller, attached = pty.openpty()
    for name in ("tcgetattr", "tcsetattr"):
        real = getattr(termios, name)
        monkeypatch.setattr(greeting.termios, name, lambda _, *more, real=real: real(attached, *more))
    yield attached
    monkeypatch.undo()
    os.close(controller)
    os.close(attached)


@pytest.mark.parametrize("signals", [True, False])
def test_a_terminal_is_taken_key_by_key_without_echo_and_given_back(terminal: int, signals: bool) -> None:
    found = termios.tcgetattr(terminal)
    found[0] = (found[0] | termios.IXON) & ~termios.ICRNL
    found[3] |= termios.ECHO | termios.ICANON | termios.IEXTEN | termios.ISIG
    termios.tcsetattr(terminal, termios.TCSANOW, found)
    taken = greeting.Terminal()
    taken.take(signals=not signals)
    taken.take(signals=signals)

    input_, output, _, local, *_, keys = termios.tcgetattr(terminal)
    assert local & (termios.ECHO | termios.ICANON | termios.IEXTEN) == 0
    assert bool(local & termios.ISIG) is signals
    assert input_ & (termios.IXON | termios.ICRNL) == termios.ICRNL
    assert output == found[1]
    assert (keys[termios.VMIN], keys[termios.VTIME]) in ((1, 0), (b"\x01", b"\x00"))

    taken.give_back()
    assert termios.tcgetattr(terminal)[:4] == found[:4]


@pytest.mark.parametrize(
    ("number", "is_plain"),
    [("1", True), ("999", True), ("1000", False), ("0", False), ("-1", False), ("max", True)],
)
def test_only_a_plain_number_is_greeted_early(number: str, is_plain: bool, printed: list[bytes]) -> None:
    assert bool(greeting.begin(["--linear", "--speed", number], {})) is is_plain


@pytest.mark.parametrize(
    ("options", "environment", "language"),
    [
        ({}, {}, "en"),
        ({"--lang": "es"}, {"DONNIE_LANG": "pt"}, "es"),
        ({"--lang": "xx"}, {"DONNIE_LANG": "pt"}, "pt"),
        ({}, {"DONNIE_LANG": "xx", "LANG": "es_ES"}, "es"),
        ({}, {"LC_ALL": "pt_BR", "LC_MESSAGES": "es_ES", "LANG": "en"}, "pt"),
        ({}, {"LC_MESSAGES": "es_ES", "LANG": "pt"}, "es"),
        ({}, {"LC_ALL": "", "LANG": "pt"}, "pt"),
    ],
)
def test_the_language_is_that_of_the_option_the_variable_or_the_locale(
    options: dict[str, str], environment: dict[str, str], language: str
) -> None:
    assert greeting.language_of(options, environment) == language


@pytest.mark.parametrize(
    ("term", "is_editable"), [("xterm", True), ("dumb", False), ("", False), (None, False)]
)
def test_lines_are_edited_in_a_terminal_that_can_do_more_than_print(
    term: str | None, is_editable: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    environment = {} if term is None else {"TERM": term}
    for ends in ({0, 1}, {0}, {1}, set[int]()):
        monkeypatch.setattr(greeting.os, "isatty", lambda end, ends=ends: end in ends)
        assert greeting.is_editable(environment) is (is_editable and ends == {0, 1})


@pytest.fixture
def prompted(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[tuple[list[bytes], dict[str, str]]]:
    """What is written to a terminal that can only print, and its environment."""
    written: list[bytes] = []
    monkeypatch.setattr(greeting.os, "isatty", lambda _: True)
    monkeypatch.setattr(greeting.os, "write", lambda _, data: written.append(data))
    yield written, {"TERM": "dumb", "XDG_STATE_HOME": str(tmp_path)}
    monkeypatch.undo()


HINT, OFFER = "HELP lists the commands.", "TOUR"


def test_a_greeting_is_printed_once_with_the_prompt_which_then_belongs_to_another(
    prompted: tuple[list[bytes], dict[str, str]],
) -> None:
    written, environment = prompted
    it = greeting.Greeting()
    assert not it.was_printed
    it.end_prompt()
    assert written == []
    it.greet("en", "option", environment, tour=False)
    it.greet("en", "option", environment)

    assert b"".join(written).decode() == f"Linear mode, from the option.\n{HINT}\n{greeting.PROMPT}"
    assert it.lines == ("Linear mode, from the option.", HINT)
    assert it.was_printed
    assert it.terminal is None
    assert [it.take_prompt(), it.take_prompt()] == [True, False]
    it.end_prompt()
    assert len(written) == 1


def test_a_greeting_that_is_taken_back_ends_its_prompt_and_is_printed_again(
    prompted: tuple[list[bytes], dict[str, str]],
) -> None:
    written, environment = prompted
    it = greeting.Greeting()
    it.greet("en", "option", environment)
    it.withdraw()
    assert written[1:] == [b"\n"]
    it.withdraw()
    assert written[1:] == [b"\n"]

    it.forget()
    assert not (it.was_printed or it.has_prompt or it.has_reported_rescue)
    it.greet("en", "option", environment, prompt=None)
    assert written[2:] == [b"Linear mode, from the option.\n"]
    assert not it.has_prompt


def test_the_second_line_offers_the_tour_once_and_what_was_rescued_before_all(
    prompted: tuple[list[bytes], dict[str, str]], tmp_path: Path
) -> None:
    _, environment = prompted

    def second(**options: bool) -> tuple[str, bool]:
        it = greeting.Greeting()
        it.greet("en", "option", environment, **options)
        return it.lines[1], it.has_reported_rescue

    first, _ = second()
    assert OFFER in first
    assert second(tour=False) == (HINT, False)
    (folder,) = {greeting.state_path(environment)}
    unsaved = Path(folder) / greeting.UNSAVED
    unsaved.mkdir(parents=True)
    (unsaved / "unsaved-0-a.gd").write_text("FW 1")
    line, is_rescue = second()
    assert is_rescue
    assert line not in (HINT, first)
