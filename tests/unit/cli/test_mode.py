"""Linear mode or full screen, and why."""

import shlex
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from donnie_tui.cli import front_end
from donnie_tui.cli.front_end import (
    ProcessEnvironment,
    allowed_number,
    cause_of_linear,
    page_command,
    process_environment,
)
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.process.confinement import Confinement, confine
from tests.unit.i18n.sentences import CODES

TTY, PIPE = True, False

CASES = [
    # option, variables, settings file, stdin, stdout, the cause or None for the full screen
    (None, {"TERM": "xterm"}, None, TTY, TTY, None),
    (True, {"TERM": "xterm"}, None, TTY, TTY, "option"),
    (False, {"TERM": "xterm", "DONNIE_LINEAR": "1"}, True, TTY, TTY, None),
    (False, {"TERM": "dumb"}, None, TTY, TTY, None),
    (None, {"TERM": "xterm", "DONNIE_LINEAR": "1"}, None, TTY, TTY, "variable"),
    (None, {"TERM": "xterm", "DONNIE_LINEAR": "0"}, True, TTY, TTY, None),
    (None, {"TERM": "xterm", "DONNIE_LINEAR": "0", "ACCESSIBLE": "1"}, None, TTY, TTY, None),
    (None, {"TERM": "dumb", "DONNIE_LINEAR": "0"}, None, TTY, TTY, None),
    (None, {"TERM": "xterm", "ACCESSIBLE": "1"}, None, TTY, TTY, "variable"),
    (None, {"TERM": "xterm", "ACCESSIBLE": "false"}, None, TTY, TTY, None),
    (None, {"TERM": "xterm", "ACCESSIBLE": "0"}, True, TTY, TTY, "settings"),
    (None, {"TERM": "xterm"}, True, TTY, TTY, "settings"),
    (None, {"TERM": "dumb"}, False, TTY, TTY, None),
    (None, {"TERM": "dumb"}, None, TTY, TTY, "simple-terminal"),
    (None, {"TERM": "xterm"}, None, PIPE, TTY, "no-terminal"),
    (None, {"TERM": "xterm"}, None, TTY, PIPE, "no-terminal"),
    # beyond the table: there is no full screen without a terminal
    (False, {"TERM": "xterm"}, None, TTY, PIPE, "no-terminal"),
    (True, {"TERM": "xterm"}, None, PIPE, PIPE, "option"),
    (None, {"TERM": "xterm", "DONNIE_LINEAR": "perhaps", "ACCESSIBLE": ""}, None, TTY, TTY, None),
    (None, {}, None, TTY, TTY, "simple-terminal"),
    (None, {"TERM": "xterm", "ACCESSIBLE": " False "}, None, TTY, TTY, None),
    # a page in a browser is one
    (None, {"TERM": "xterm", "TEXTUAL_DRIVER": "web"}, None, PIPE, PIPE, None),
]


@pytest.mark.parametrize(("option", "variables", "configured", "stdin", "stdout", "cause"), CASES)
def test_the_mode_is_decided_in_order(
    option: bool | None,
    variables: dict[str, str],
    configured: bool | None,
    stdin: bool,
    stdout: bool,
    cause: str | None,
) -> None:
    assert cause_of_linear(option, configured, ProcessEnvironment(stdin, stdout, variables)) == cause


@pytest.mark.parametrize("option", [None, False])
def test_the_full_screen_needs_a_terminal_for_the_errors_too(option: bool | None) -> None:
    around = ProcessEnvironment(TTY, TTY, {"TERM": "xterm"}, stderr_is_terminal=PIPE)

    assert cause_of_linear(option, None, around) == "no-terminal"


def test_every_reason_has_its_first_line() -> None:
    assert {f"linear-cause-{cause}" for *_, cause in CASES if cause} <= set(CODES)


@pytest.mark.parametrize("terminal", ["stdin", "stdout", "stderr"])
def test_each_stream_of_the_process_may_be_a_terminal(terminal: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("stdin", "stdout", "stderr"):
        stream = SimpleNamespace(isatty=lambda name=name: name == terminal)
        monkeypatch.setattr(sys, name, stream)
    around = process_environment({"TERM": "x"})
    monkeypatch.undo()
    found = around.stdin_is_terminal, around.stdout_is_terminal, around.stderr_is_terminal
    assert found == tuple(name == terminal for name in ("stdin", "stdout", "stderr"))
    assert around.environment == {"TERM": "x"}


@pytest.mark.parametrize(
    ("typed", "number"),
    [
        ("1", 1),
        ("65535", 65535),
        ("000000080", 80),
        ("0", None),
        ("65536", None),
        ("0000000080", None),
        ("8x", None),
        ("-8", None),
        ("", None),
    ],
)
def test_a_number_of_an_option_has_limits_and_at_most_nine_digits(typed: str, number: int | None) -> None:
    if number is not None:
        assert allowed_number(Words(), "serve-bad-port", typed, range(1, 65536)) == number
        return
    with pytest.raises(Unusable) as bad:
        allowed_number(Words(), "serve-bad-port", typed, range(1, 65536))
    assert bad.value.sentence == f"{typed} is not a port; a port is a number from 1 to 65535."


def test_of_a_wrong_number_forty_characters_are_quoted() -> None:
    with pytest.raises(Unusable) as bad:
        allowed_number(Words(), "serve-bad-sessions", "x" * 41, range(1, 101))
    assert bad.value.sentence == f"{'x' * 39}… is not a number of pages; 1 to 100 are possible."


def test_each_page_is_started_with_the_options_of_its_server(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    given = {"world": "maze", "belt_steps": "1 2 3", "confined": str(tmp_path)}
    options = ["--visual", "--world", "maze", "--belt-steps", "1 2 3"]
    assert page_command(given) == [sys.executable, "-m", "donnie_tui", *options]
    monkeypatch.chdir(tmp_path)
    confine(Confinement(str(tmp_path)))
    try:
        assert page_command({}) == [sys.executable, "-P", "-m", "donnie_tui", "--visual"]
    finally:
        confine(None)


def test_what_serves_pages_is_installed_by_uv_where_there_is_no_pip_and_from_the_index_where_donnie_is(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(front_end, "find_spec", lambda _name: None)
    monkeypatch.setattr(front_end, "__file__", str(tmp_path / "site" / "donnie_tui" / "cli" / "front_end.py"))
    uv = ["uv", "pip", "install", "--python", sys.executable]
    assert shlex.split(front_end._installing()) == [*uv, "donnie-tui[serve]"]


def test_what_serves_pages_is_installed_by_pip_for_a_checkout(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    (tmp_path / "pyproject.toml").touch()
    monkeypatch.setattr(front_end, "find_spec", lambda name: name == "pip" or None)
    monkeypatch.setattr(front_end, "__file__", str(tmp_path / "donnie_tui" / "cli" / "front_end.py"))
    pip = [sys.executable, "-m", "pip", "install"]
    assert shlex.split(front_end._installing()) == [*pip, "--editable", f"{tmp_path.resolve()}[serve]"]
