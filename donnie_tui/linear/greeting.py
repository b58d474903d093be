"""The first lines, the prompt and the terminal: all that comes before the rest of Donnie is loaded.

This module imports next to nothing. It prints the greeting early only if the command line is plain enough to
ask for the linear mode and nothing else; the rest is left to ``donnie_tui.cli``, and so is the search for a
robot. The terminal is taken at once, so that what is typed during the loading is neither lost nor shown
twice: it waits in the terminal until it is read.
"""

from __future__ import annotations

import os
import sys
import termios

from donnie_tui import DETAILS
from donnie_tui.i18n.first_words import early
from donnie_tui.settings import PROFILES, SPEECH
from donnie_tui.settings.folders import UNSAVED, offers_tour, state_path
from language.locales import ENGLISH, SEARCH_PATH, folders, language_of_locale

PROMPT = "> "

_NO_READER = 129
"""The exit code, as after a lost terminal."""
_HARMLESS = ("DONNIE_LANG", "DONNIE_LINEAR", "DONNIE_READER", "DONNIE_TOUR", "DONNIE_WORLD", SEARCH_PATH)
_SWITCH = ("on", "off")
PLAIN_VALUES = {
    "--lang": tuple(folders()),
    "--profile": PROFILES,
    "--speech": SPEECH,
    "--sound": _SWITCH,
    "--verbosity": DETAILS,
}
"""The values of options that have few; anything else may be refused, which is printed before the greeting."""
_LINEAR = ("--linear", "--screen-reader")
_WITH_VALUE = ("--world", "--allow", "--events")
_WITH_NUMBER = ("--speed", "--seed")
_LFLAG, _IFLAG, _CC = 3, 0, 6
"""Places in the attributes of a terminal."""


class Greeting:
    """The lines that were printed, and the terminal that was taken. A process has only one."""

    def __init__(self) -> None:
        self.was_printed = False
        self.lines: tuple[str, ...] = ()
        """What was printed, without the prompt."""
        self.has_prompt = False
        self.offered: set[bool] = set()
        """The modes that were offered as the one to begin in; each is offered once."""
        self.terminal: Terminal | None = None
        """None until it is taken."""
        self.has_reported_rescue = False
        """Whether the greeting said that a program was rescued."""

    def greet(
        self,
        language: str,
        cause: str,
        environment: os._Environ[str] | dict[str, str],
        *,
        prompt: str | None = PROMPT,
        tour: bool = True,
    ) -> None:
        """Print the lines, and ``prompt`` where there is a terminal. Does nothing the second time.

        Without a prompt only the first line is printed: the second one will be about the file. ``tour``:
        whether it may be offered in place of the hint, when Donnie starts for the first time.
        """
        if self.was_printed:
            return
        self.was_printed, self.has_prompt = True, prompt is not None and os.isatty(0)
        self.terminal = _taken_terminal() if is_editable(environment) else None
        hint = self._hint(environment, tour=tour)
        codes = (f"linear-cause-{cause}",) if prompt is None else (f"linear-cause-{cause}", hint)
        self.lines = tuple(early(code, language) for code in codes)
        text = "".join(f"{line}\n" for line in self.lines)
        _print(text + (prompt if prompt and self.has_prompt else ""))

    def _hint(self, environment: os._Environ[str] | dict[str, str], *, tour: bool) -> str:
        """The code of the most useful line before the first prompt, which has no room for more."""
        folder = state_path(environment)
        if self.has_prompt and has_rescued(f"{folder}/{UNSAVED}"):
            self.has_reported_rescue = True
            return "answer-rescued"
        offers = tour and self.has_prompt and offers_tour(folder, environment)
        return "tour-offer" if offers else "start-hint"

    def take_prompt(self) -> bool:
        """Whether the prompt was printed already; from now on it belongs to the caller."""
        had, self.has_prompt = self.has_prompt, False
        return had

    def end_prompt(self) -> None:
        """Begin a new line for a message that precedes the first question; the prompt is printed again."""
        if self.take_prompt():
            _print("\n")

    def withdraw(self) -> None:
        """Give the terminal back and begin a new line, for a command line that can't be used."""
        terminal, self.terminal = self.terminal, None
        if terminal is not None:
            terminal.give_back()
        self.end_prompt()

    def forget(self) -> None:
        """Print the greeting again the next time: the learner went to the full screen and may return."""
        self.was_printed = self.has_prompt = self.has_reported_rescue = False


def has_rescued(folder: str) -> bool:
    """Whether there is an unsaved copy to offer. Loads ``core.recovery`` only if there may be one."""
    try:
        if not any(each.startswith(("unsaved-", "kept-")) for each in os.listdir(folder)):  # noqa: PTH208 -- pathlib is slow
            return False
    except OSError:
        return False
    from donnie_tui.core.recovery import CopyFolder

    return bool(CopyFolder(folder).rescued())


def begin(arguments: list[str], environment: os._Environ[str] | dict[str, str]) -> Greeting | None:
    """Greet if ``arguments`` plainly ask for the linear mode. None if nothing was printed."""
    options = _plain_options(arguments)
    if options is None or "--linear" not in options or _has_other_settings(environment):
        return None
    greeting, prompt = Greeting(), None if "FILE" in options else PROMPT
    greeting.greet(language_of(options, environment), "option", environment, prompt=prompt)
    return greeting


def language_of(options: dict[str, str], environment: os._Environ[str] | dict[str, str]) -> str:
    """The language of the options, else of ``DONNIE_LANG``, else of the locale, else English."""
    locale = environment.get("LC_ALL") or environment.get("LC_MESSAGES") or environment.get("LANG") or ""
    for given in (options.get("--lang", ""), environment.get("DONNIE_LANG", ""), locale):
        language = language_of_locale(given)
        if language is not None:
            return language
    return ENGLISH


def is_editable(environment: os._Environ[str] | dict[str, str]) -> bool:
    """Whether lines can be edited here: a terminal at both ends that knows more than printing."""
    return os.isatty(0) and os.isatty(1) and environment.get("TERM") not in (None, "", "dumb")


class Terminal:
    """Standard input as a terminal. ``take`` and ``give_back`` may be called any number of times."""

    def __init__(self) -> None:
        self._found = termios.tcgetattr(0)

    def take(self, *, signals: bool = True) -> None:
        """Key by key, without an echo by the terminal. Without ``signals`` Ctrl+C is a key like any other."""
        wanted = termios.tcgetattr(0)
        wanted[_LFLAG] &= ~(termios.ECHO | termios.ICANON | termios.IEXTEN)
        wanted[_LFLAG] = wanted[_LFLAG] | termios.ISIG if signals else wanted[_LFLAG] & ~termios.ISIG
        wanted[_IFLAG] &= ~termios.IXON  # a stray Ctrl+S would silence everything
        wanted[_IFLAG] |= termios.ICRNL
        wanted[_CC][termios.VMIN], wanted[_CC][termios.VTIME] = 1, 0
        _apply(wanted)

    def give_back(self) -> None:
        """As it was found; quietly, since the terminal may be gone."""
        try:
            _apply(self._found)
        except (termios.error, OSError):
            return


def _plain_options(arguments: list[str]) -> dict[str, str] | None:
    """The options and the FILE, or None if there is anything that is not obvious."""
    found: dict[str, str] = {}
    rest = iter(arguments)
    for each in rest:
        name, equals, value = each.partition("=")
        if each in _LINEAR:
            found["--linear"] = ""
        elif name in PLAIN_VALUES or name in _WITH_VALUE or name in _WITH_NUMBER:
            found[name] = value if equals else next(rest, "")
            if not _is_plain(name, found[name]):
                return None
        elif each.startswith("-") or "FILE" in found or not os.path.isfile(each):  # noqa: PTH113 -- pathlib is slow to load
            return None
        else:
            found["FILE"] = each
    return found


def _is_plain(name: str, value: str) -> bool:
    if name in _WITH_NUMBER:
        return value == "max" or (value.isdecimal() and len(value) < 4 and value != "0")
    return value in PLAIN_VALUES.get(name, (value,))


def _has_other_settings(environment: os._Environ[str] | dict[str, str]) -> bool:
    """Whether a variable is set that may be wrong, which is printed before the greeting."""
    return any(name.startswith("DONNIE_") and name not in _HARMLESS for name in environment)


def _taken_terminal() -> Terminal:
    """Takes the terminal. Until the console handles signals, Ctrl+C is a key like any other."""
    import atexit

    terminal = Terminal()
    terminal.take(signals=False)
    atexit.register(terminal.give_back)
    return terminal


def _print(text: str) -> None:
    """Print, and exit where the output is closed."""
    try:
        os.write(1, text.encode())
    except OSError:
        sys.exit(_NO_READER)


def _apply(attributes: list[int | list[bytes | int]]) -> None:
    termios.tcsetattr(0, termios.TCSANOW, attributes)
