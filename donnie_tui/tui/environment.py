"""The screen's environment: Textual's environment variables, and the terminal's normal screen.

``prepare`` runs before Textual is imported, which reads its switches then. The plain layout is for screen
readers: one column, and nothing that a reader would speak without need. On the normal screen the log is
shown in a pager, and its last lines stay there after the end.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, MutableMapping, Sequence
from functools import cache

from donnie_tui.commands.keys import KeyTable
from donnie_tui.i18n.first_words import early
from donnie_tui.process.confinement import may_run_programs
from donnie_tui.settings.settings import Settings

_WITHOUT_KEY_REPORTS = ("linux", "vt", "screen", "tmux")
"""How the names of terminals begin that don't know key reports: some show a letter instead."""

_WITH_COLOURS = ("xterm", "linux", "screen", "tmux")


def prepare(settings: Settings, environment: MutableMapping[str, str] = os.environ) -> None:
    """Turn off key reports and mouse pixels that only some terminals know; before Textual is imported."""
    environment.setdefault("TEXTUAL_SMOOTH_SCROLL", "0")
    environment.setdefault("TEXTUAL_ANIMATIONS", "none")
    if is_plain(settings) or environment.get("TERM", "").startswith(_WITHOUT_KEY_REPORTS):
        environment.setdefault("TEXTUAL_DISABLE_KITTY_KEY", "1")
    if _has_no_colours(environment):
        environment.setdefault("NO_COLOR", "1")
    if _has_no_size():
        environment.setdefault("COLUMNS", "80")
        environment.setdefault("LINES", "24")


def _has_no_colours(environment: Mapping[str, str]) -> bool:
    """Whether the system knows a terminal of this name, and that it has none, as a VT100."""
    if environment.get("COLORTERM") or environment.get("TERM", "").startswith(_WITH_COLOURS):
        return False  # the same, without looking it up
    try:
        import curses  # not every Python has it

        curses.setupterm(environment.get("TERM", "unknown"))
        return curses.tigetnum("colors") <= 0
    except ImportError:
        return False
    except curses.error:
        return False


def _has_no_size() -> bool:
    """Whether the terminal says it has no rows, as a serial one does.

    Rich and Textual take different numbers of rows for it then, and lay out the screen again without end.
    """
    try:
        return os.get_terminal_size(0) == (0, 0)
    except OSError:
        return False


def is_page(environment: Mapping[str, str] = os.environ) -> bool:
    """Whether a browser shows the screen: then the driver for pages is named."""
    return bool(environment.get("TEXTUAL_DRIVER"))


def wants_mouse(settings: Settings) -> bool:
    """False over SSH or with a reader: mouse reports cost bytes and disable the terminal's own selection."""
    return settings.mouse and not is_plain(settings)


def is_plain(settings: Settings) -> bool:
    """The learner's choice, else plain if a screen reader runs."""
    if settings.plain is not None:
        return settings.plain
    return _screen_reader_runs()


def first_steps(language: str, key_table: KeyTable) -> tuple[str, tuple[str, ...]]:
    """How to begin: a title for an empty program on a small screen, and what is written in the program."""
    title = with_keys("screen-start-small-page" if is_page() else "screen-start-small", language, key_table)
    return title, tuple(early(f"screen-empty-{number}", language) for number in (1, 2, 3))


def with_keys(code: str, language: str, key_table: KeyTable) -> str:
    """A sentence of the start that names the keys of RUN and HELP, or their words."""
    named = (("run", "RUN"), ("help", "HELP"))
    keys = {name: key_table.label(name, language) or word for name, word in named}
    return early(code, language).format(**keys)


def may_need_linear(environment: Mapping[str, str] = os.environ) -> bool:
    """Whether the first row offers the linear mode: over SSH, unless DONNIE_READER says yes or no.

    A screen reader that runs on this machine may be another person's.
    """
    from devices.audio.channel import is_over_ssh

    was_answered = bool(environment.get("DONNIE_READER", "").strip())
    return is_over_ssh(environment) and not is_page(environment) and not was_answered


@cache
def _screen_reader_runs() -> bool:
    """Whether a screen reader runs. Cached, since it reads all processes and is called three times."""
    from devices.audio.channel import find_screen_reader

    return find_screen_reader(os.environ) is not None


# --- the normal screen

LAST_LINES = 20
"""Lines of the log that stay on the normal screen."""

SECURE = {"LESSSECURE": "1", "PAGERSECURE": "1"}
"""With these variables less, or another pager that heeds them, runs no other program and writes no file."""


def print_last_lines(lines: Sequence[str]) -> None:
    """Print the end of the log before the shell's prompt, to be read again there."""
    from language.source import printable

    if is_page():
        return  # a browser has no such screen
    try:
        for line in lines[-LAST_LINES:]:
            sys.stdout.write(f"{printable(line)}\n")
        sys.stdout.flush()
    except (OSError, ValueError):
        return


def pager(environment: Mapping[str, str]) -> list[str] | None:
    """The command that shows a text: the one of PAGER, else less. None for Donnie's own pages.

    ``more`` is none of them: it has a key that starts a shell.
    """
    import shlex
    import shutil

    if not may_run_programs():
        return None
    try:
        wanted = [shlex.split(environment.get("PAGER", "")), ["less"]]
    except ValueError:
        wanted = [["less"]]
    return next((each for each in wanted if each and shutil.which(each[0])), None)


def run_pager(command: Sequence[str], text: str) -> None:
    """Run the pager and wait for its end. Raises ``OSError``: it can't be run, or the disk is full."""
    import subprocess
    import tempfile
    from pathlib import Path

    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "log.txt"
        file.write_text(text, encoding="utf-8", errors="replace")
        subprocess.run([*command, str(file)], check=False, env={**os.environ, **SECURE})
