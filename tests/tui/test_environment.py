"""The terminal: what it knows, the end of the log on its normal screen, the pager, the end of its input."""

import curses
import os
import signal
import sys
import threading
from contextlib import nullcontext
from pathlib import Path
from types import SimpleNamespace

import pytest

from donnie_tui.settings.settings import Settings
from donnie_tui.tui import environment
from donnie_tui.tui.terminal import _stop_reading


def test_the_last_twenty_lines_are_left_behind_in_their_order(capsys, monkeypatch):
    monkeypatch.delenv("TEXTUAL_DRIVER", raising=False)
    environment.print_last_lines([f"line {i}" for i in range(30)])

    assert capsys.readouterr().out.splitlines() == [f"line {i}" for i in range(10, 30)]


def test_nothing_is_left_behind_in_a_browser_and_no_line_commands_the_terminal(capsys, monkeypatch):
    monkeypatch.setenv("TEXTUAL_DRIVER", "page")
    environment.print_last_lines(["one"])
    assert capsys.readouterr().out == ""

    monkeypatch.delenv("TEXTUAL_DRIVER")
    environment.print_last_lines(["\x1b[2J"])
    assert "\x1b" not in capsys.readouterr().out


@pytest.mark.parametrize("failing", ["write", "flush", "nothing"])
@pytest.mark.parametrize("problem", [OSError(5, "I/O error"), ValueError("closed")])
def test_a_terminal_that_is_gone_gets_no_lines_and_ends_nothing(monkeypatch, failing, problem):
    def fail(*_):
        raise problem

    written = []
    out = SimpleNamespace(
        **{"write": written.append, "flush": lambda: written.append("flushed"), failing: fail}
    )
    monkeypatch.delenv("TEXTUAL_DRIVER", raising=False)
    monkeypatch.setattr(sys, "stdout", out)
    environment.print_last_lines(["one", "two"])

    lines = ["one\n", "two\n"]
    assert written == {"write": [], "flush": lines, "nothing": [*lines, "flushed"]}[failing]


# --- what Textual reads


looked_up = []
"""The names of terminals that were looked up in the system's list, a list for each start."""


def prepared(monkeypatch, settings=None, size=(80, 24), colours=8, **variables):
    """What is set for a terminal that says these things of itself."""

    def answer(_=None):
        if isinstance(colours, Exception):
            raise colours
        return colours

    def measured(number):
        assert number == 0, "the terminal of the input"
        if size is None:
            raise OSError
        return size

    given = dict(variables)
    monkeypatch.setattr(curses, "setupterm", lambda name: asked.append(name))
    asked = []
    monkeypatch.setattr(curses, "tigetnum", lambda name: answer() if name == "colors" else None)
    monkeypatch.setattr(os, "get_terminal_size", measured)
    environment.prepare(settings or Settings(plain=False), given)
    looked_up.append(asked)
    return {name: value for name, value in given.items() if name not in variables or variables[name] != value}


ALWAYS = {"TEXTUAL_SMOOTH_SCROLL": "0", "TEXTUAL_ANIMATIONS": "none"}
NO_REPORTS, NO_COLOURS = {"TEXTUAL_DISABLE_KITTY_KEY": "1"}, {"NO_COLOR": "1"}


@pytest.mark.parametrize(
    ("changes", "wanted"),
    [
        ({"TERM": "xterm-256color"}, {}),
        ({"TERM": "xterm", "settings": Settings(plain=True)}, NO_REPORTS),
        *(({"TERM": name}, NO_REPORTS) for name in ("linux", "vt220", "screen-256color", "tmux-256color")),
        ({"TERM": "xterm", "colours": -1}, {}),  # it is not asked
        *(({"TERM": name, "colours": -1}, NO_REPORTS) for name in ("linux", "screen.xterm", "tmux-256color")),
        ({"TERM": "vt100", "colours": -1}, NO_REPORTS | NO_COLOURS),
        ({"TERM": "vt100", "colours": -1, "COLORTERM": "truecolor"}, NO_REPORTS),
        ({"TERM": "wyse50", "colours": 0}, NO_COLOURS),
        ({"TERM": "wyse50", "colours": 1}, {}),
        ({"TERM": "wyse50", "colours": curses.error("unknown")}, {}),
        ({"colours": -1}, NO_COLOURS),
        ({"TERM": "xterm", "size": (0, 0)}, {"COLUMNS": "80", "LINES": "24"}),
        ({"TERM": "xterm", "size": (80, 0)}, {}),
        ({"TERM": "xterm", "size": None}, {}),
        ({"TERM": "xterm", "size": (0, 0), "COLUMNS": "100"}, {"LINES": "24"}),
    ],
    ids=str,
)
def test_what_a_terminal_does_not_know_is_not_sent_to_it(monkeypatch, changes, wanted):
    """Key reports, colours, and a size of nothing, as of a serial terminal."""
    assert prepared(monkeypatch, **changes) == ALWAYS | wanted


def test_only_a_terminal_whose_colours_are_not_known_is_looked_up(monkeypatch):
    looked_up.clear()
    for variables in ({"TERM": "wyse50"}, {}, {"TERM": "xterm"}, {"TERM": "wyse50", "COLORTERM": "1"}):
        prepared(monkeypatch, **variables)

    assert looked_up == [["wyse50"], ["unknown"], [], []]


def test_variables_of_the_learner_stay(monkeypatch):
    own = {
        **dict.fromkeys(("TEXTUAL_SMOOTH_SCROLL", "TEXTUAL_ANIMATIONS", "TEXTUAL_DISABLE_KITTY_KEY"), "own"),
        **dict.fromkeys(("NO_COLOR", "COLUMNS", "LINES"), "own"),
    }
    assert prepared(monkeypatch, size=(0, 0), colours=0, TERM="vt100", **own) == {}


def test_a_python_without_curses_has_colours(monkeypatch):
    monkeypatch.setitem(sys.modules, "curses", None)
    given = {"TERM": "vt100"}
    environment.prepare(Settings(plain=False), given)

    assert "NO_COLOR" not in given


@pytest.mark.parametrize(
    ("settings", "reader", "is_plain", "has_mouse"),
    [
        (Settings(), "yes", True, False),
        (Settings(), "no", False, True),
        (Settings(plain=True), "no", True, False),
        (Settings(plain=False), "yes", False, True),
        (Settings(plain=False, mouse=False), "no", False, False),
    ],
)
def test_the_layout_is_plain_as_chosen_or_for_a_reader_and_has_no_mouse(
    monkeypatch, settings, reader, is_plain, has_mouse
):
    monkeypatch.setenv("DONNIE_READER", reader)
    environment._screen_reader_runs.cache_clear()
    try:
        assert environment.is_plain(settings) is is_plain
        assert environment.wants_mouse(settings) is has_mouse
    finally:
        environment._screen_reader_runs.cache_clear()


SSH = {"SSH_CONNECTION": "10.0.0.1 50000 10.0.0.2 22"}


@pytest.mark.parametrize(
    ("variables", "is_offered"),
    [
        ({}, False),
        (SSH, True),
        (SSH | {"DONNIE_READER": " "}, True),
        (SSH | {"DONNIE_READER": "no"}, False),
        (SSH | {"TEXTUAL_DRIVER": "page"}, False),
        (SSH | {"TEXTUAL_DRIVER": ""}, True),
    ],
)
def test_the_linear_mode_is_offered_over_ssh_unless_the_reader_is_known(variables, is_offered):
    assert environment.may_need_linear(variables) is is_offered


@pytest.mark.parametrize(
    ("labels", "title"),
    [
        ({"run": "F5", "help": "F1"}, "F5 runs, F1 helps"),
        ({"help": "F1"}, "RUN runs, F1 helps"),
        ({}, "RUN runs, HELP helps"),
    ],
)
def test_the_first_steps_name_the_keys_or_else_the_words(monkeypatch, labels, title):
    monkeypatch.setattr(
        environment, "early", lambda code, language: f"{language} {code} {{run}} runs, {{help}} helps"
    )
    table = SimpleNamespace(label=lambda name, language: labels.get(name) if language == "en" else None)
    for driver, code in (("", "screen-start-small"), ("page", "screen-start-small-page")):
        monkeypatch.setenv("TEXTUAL_DRIVER", driver)
        shown, written = environment.first_steps("en", table)

        assert shown == f"en {code} {title}"
        assert [each.split()[1] for each in written] == [f"screen-empty-{number}" for number in (1, 2, 3)]


# --- the pager


@pytest.mark.parametrize(
    ("wanted", "installed", "may_run", "command"),
    [
        ("most -s", {"most", "less"}, True, ["most", "-s"]),
        ("'my pager' -s", {"my pager", "less"}, True, ["my pager", "-s"]),
        ("most", {"less"}, True, ["less"]),
        ("most 'x", {"most", "less"}, True, ["less"]),
        ("", {"less"}, True, ["less"]),
        (None, {"less"}, True, ["less"]),
        ("", {"more"}, True, None),
        ("less", {"less"}, False, None),
    ],
)
def test_the_pager_is_the_learners_or_less_and_never_more(monkeypatch, wanted, installed, may_run, command):
    monkeypatch.setattr(environment, "may_run_programs", lambda: may_run)
    monkeypatch.setattr("shutil.which", lambda name: name if name in installed else None)

    assert environment.pager({} if wanted is None else {"PAGER": wanted}) == command


def test_a_pager_reads_the_log_in_a_file_and_may_start_nothing(monkeypatch):
    """Its exit code says nothing: less has one of its own for Ctrl+C."""
    calls = []

    def run(command, *, check, env):
        assert not check
        calls.append((command[:-1], Path(command[-1]).read_text("utf-8"), env))

    monkeypatch.setattr("subprocess.run", run)
    monkeypatch.setenv("KEPT", "yes")
    environment.run_pager(["less", "-R"], "olá \udc80\n")

    ((command, text, variables),) = calls
    assert (command, text) == (["less", "-R"], "olá ?\n")
    assert [variables[each] for each in ("LESSSECURE", "PAGERSECURE", "KEPT")] == ["1", "1", "yes"]


def test_a_pager_that_fails_has_a_reason(monkeypatch):
    def run(*_, **__):
        raise OSError(28, "No space left")

    monkeypatch.setattr("subprocess.run", run)
    with pytest.raises(OSError, match="No space left"):
        environment.run_pager(["less"], "text")


async def test_a_pager_that_can_not_be_run_is_reported_in_a_sentence(open_screen, monkeypatch, tmp_path):
    broken = tmp_path / "pager"
    broken.write_text("no program")
    broken.chmod(0o755)
    monkeypatch.setenv("PAGER", str(broken))
    async with open_screen() as screen:
        monkeypatch.setattr(screen.app, "suspend", nullcontext)
        await screen.type_line("LOG")
        await screen.shows("The log can't be shown: Exec format error. SAVE LOG writes it into a file.")


@pytest.fixture
def size_handler():
    """Set as Textual's driver sets one, and given back."""
    before = signal.getsignal(signal.SIGWINCH)
    signal.signal(signal.SIGWINCH, handler := lambda *_: None)
    yield handler
    signal.signal(signal.SIGWINCH, before)


def test_the_thread_that_reads_the_terminal_is_ended_and_the_size_watched_no_more(size_handler):
    done = []
    driver = SimpleNamespace(
        exit_event=threading.Event(),
        _disable_mouse_support=lambda: done.append("no mouse"),
        _key_thread=SimpleNamespace(join=lambda: done.append("joined")),
    )

    _stop_reading(driver)

    assert signal.getsignal(signal.SIGWINCH) == signal.SIG_DFL
    assert driver.exit_event.is_set()
    assert done == ["no mouse", "joined"]


def test_a_terminal_that_is_not_read_any_more_is_left_as_it_is(size_handler):
    driver = SimpleNamespace(exit_event=threading.Event())
    driver.exit_event.set()

    _stop_reading(driver)

    assert signal.getsignal(signal.SIGWINCH) is size_handler
