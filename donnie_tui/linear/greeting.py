"""The first lines and the prompt, printed before anything else of Donnie is loaded.

Rules: it imports next to nothing. It greets only where the command line is so plain that nothing else can
come of it; whatever is not plain is left to the real command line, and so is a robot that has to be looked
for. The terminal is taken at once, so that what is typed while the rest is being loaded is neither lost nor
shown twice.
"""

from __future__ import annotations

import os
import sys

from donnie_tui import DETAILS
from donnie_tui.i18n.first_words import early
from donnie_tui.settings.folders import UNSAVED, offers_tour, state_path
from language.locales import ENGLISH, SEARCH_PATH, folders, language_of_locale

TYPE_CHECKING = False  # that of typing costs as much as the rest of the first prompt
if TYPE_CHECKING:
    from donnie_tui.linear.terminal import Terminal

PROMPT = "> "

_NOBODY_READS = 129
"""The exit code, as after a lost terminal."""
_HARMLESS = ("DONNIE_LANG", "DONNIE_LINEAR", "DONNIE_READER", "DONNIE_TOUR", SEARCH_PATH)
_SWITCH = ("on", "off")
PLAIN_VALUES = {
    "--lang": tuple(folders()),
    "--speech": ("auto", "text", "ssip", "tts", "robot", "off"),
    "--sound": _SWITCH,
    "--verbosity": DETAILS,
}
"""What an option takes that has few values; anything else may be refused, and is told before the greeting."""
_WITH_VALUE = ("--world", "--events")
_WITH_NUMBER = ("--speed", "--seed")


class Greeting:
    """What was printed already, and the terminal that was taken for it: there is but one of them."""

    def __init__(self) -> None:
        self.was_printed = False
        self.lines: tuple[str, ...] = ()
        """What was printed, but for the prompt."""
        self.has_prompt = False
        self.offered: set[bool] = set()
        """The modes that somebody was asked about whether to begin in them; nobody is asked twice."""
        self.terminal: Terminal | None = None
        """Once it was taken."""
        self.told_rescued = False
        """Whether it was told that a program was rescued."""

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
        whether it may be offered in the place of the hint, to somebody who is here for the first time.
        """
        if self.was_printed:
            return
        from donnie_tui.linear.terminal import is_editable

        self.was_printed, self.has_prompt = True, prompt is not None and os.isatty(0)
        if is_editable(environment):
            self.terminal = _taken_terminal()
        hint = self._hint(environment, tour=tour)
        codes = (f"linear-cause-{cause}",) if prompt is None else (f"linear-cause-{cause}", hint)
        self.lines = tuple(early(code, language) for code in codes)
        text = "".join(f"{line}\n" for line in self.lines)
        _print(text + (prompt if prompt and self.has_prompt else ""))

    def _hint(self, environment: os._Environ[str] | dict[str, str], *, tour: bool) -> str:
        """The code of what is most worth knowing before the first prompt, which has no room for more."""
        folder = state_path(environment)
        if self.has_prompt and has_rescued(f"{folder}/{UNSAVED}"):
            self.told_rescued = True
            return "answer-rescued"
        offers = tour and self.has_prompt and offers_tour(folder, environment)
        return "tour-offer" if offers else "linear-hint"

    def take_prompt(self) -> bool:
        """Whether the prompt was printed already; from now on it is somebody else's."""
        had, self.has_prompt = self.has_prompt, False
        return had

    def end_prompt(self) -> None:
        """Begin a new line, for what is to be said before anything is asked; the prompt comes again."""
        if self.take_prompt():
            _print("\n")

    def withdraw(self) -> None:
        """Give the terminal back and begin a new line, for a command line that turned out to be no use."""
        terminal, self.terminal = self.terminal, None
        if terminal is not None:
            terminal.give_back()
        self.end_prompt()

    def forget(self) -> None:
        """The conversation is over. Another one, after the full screen, is greeted anew."""
        self.was_printed = self.has_prompt = self.told_rescued = False
        self.terminal = None


def has_rescued(folder: str) -> bool:
    """Whether a crash left a copy there. The module of copies is loaded only if there may be one."""
    try:
        if not any(each.startswith("unsaved-") for each in os.listdir(folder)):  # noqa: PTH208 -- pathlib is slow
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


def _plain_options(arguments: list[str]) -> dict[str, str] | None:
    """The options and the FILE, or None where there is anything that is not obvious."""
    found: dict[str, str] = {}
    rest = iter(arguments)
    for each in rest:
        name, equals, value = each.partition("=")
        if each == "--linear":
            found[each] = ""
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
    """Variables may be wrong, and that is told before the greeting."""
    return any(name.startswith("DONNIE_") and name not in _HARMLESS for name in environment)


def _taken_terminal() -> Terminal:
    """Until somebody listens for signals, Ctrl+C is kept like any other key."""
    import atexit

    from donnie_tui.linear.terminal import Terminal

    terminal = Terminal()
    terminal.take(signals=False)
    atexit.register(terminal.give_back)
    return terminal


def _print(text: str) -> None:
    """Where nobody reads there is nothing to begin, and nobody to be told so."""
    try:
        os.write(1, text.encode())
    except OSError:
        sys.exit(_NOBODY_READS)
