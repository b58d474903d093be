"""The first lines and the prompt, printed before anything else of Donnie is loaded.

Rules: it imports next to nothing. It greets only where the command line is so plain that nothing else can
come of it; whatever is not plain is left to the real command line, and so is a robot that has to be looked
for. The terminal is taken at once, so that what is typed while the rest is being loaded is neither lost nor
shown twice.
"""

from __future__ import annotations

import os
import sys

from donnie_tui.i18n.first_words import CAUSES, HINT, PROMPT, TOUR
from donnie_tui.settings.first_start import offers_tour
from donnie_tui.settings.folders import state_path

_LANGUAGES = ("en", "pt", "es")
_NOBODY_READS = 129
"""The exit code, as after a lost terminal."""
_HARMLESS = ("DONNIE_LANG", "DONNIE_LINEAR", "DONNIE_READER", "DONNIE_TOUR")
_SWITCH = ("on", "off")
PLAIN_VALUES = {
    "--lang": _LANGUAGES,
    "--speech": ("auto", "text", "ssip", "tts", "robot", "off"),
    "--sound": _SWITCH,
    "--verbosity": ("brief", "normal", "full"),
}
"""What an option takes that has few values; anything else may be refused, and is told before the greeting."""
_WITH_VALUE = ("--world", "--events")
_WITH_NUMBER = ("--speed", "--seed")


class Greeting:
    """What was printed already, and the terminal that was taken for it."""

    def __init__(self) -> None:
        self.was_printed = False
        self.has_prompt = False
        self.offered: set[bool] = set()
        """The modes that somebody was asked about whether to begin in them; nobody is asked twice."""
        self.terminal: object | None = None
        """A ``terminal.Terminal`` once it was taken; its type would have to be imported."""


DONE = Greeting()
"""The one greeting of this process: there is but one terminal."""


def begin(arguments: list[str], environment: os._Environ[str] | dict[str, str]) -> bool:
    """Greet if ``arguments`` plainly ask for the linear mode. False if nothing was printed."""
    options = _plain_options(arguments)
    if options is None or "--linear" not in options or _has_other_settings(environment):
        return False
    greet(
        language_of(options, environment), "option", environment, prompt=None if "FILE" in options else PROMPT
    )
    return True


def greet(
    language: str,
    cause: str,
    environment: os._Environ[str] | dict[str, str],
    *,
    prompt: str | None = PROMPT,
    tour: bool = True,
) -> None:
    """Print the lines, and ``prompt`` where there is a terminal. Does nothing the second time.

    Without a prompt only the first line is printed: the second one will be about the file. ``tour``: whether
    it may be offered in the place of the hint, to somebody who is here for the first time.
    """
    if DONE.was_printed:
        return
    from donnie_tui.linear.terminal import is_editable

    DONE.was_printed, DONE.has_prompt = True, prompt is not None and os.isatty(0)
    if is_editable(environment):
        _take_terminal()
    at = _LANGUAGES.index(language)
    is_first = tour and DONE.has_prompt and offers_tour(state_path(environment), environment)
    hint = (TOUR if is_first else HINT)[at]
    lines = CAUSES[cause][at] + "\n" + ("" if prompt is None else hint + "\n")
    _print(lines + (prompt if prompt and DONE.has_prompt else ""))


def withdraw() -> None:
    """Give the terminal back and begin a new line, for a command line that turned out not to be usable."""
    terminal, DONE.terminal = DONE.terminal, None
    if terminal is not None:
        terminal.give_back()  # type: ignore[attr-defined] # see Greeting.terminal
    end_prompt()


def end_prompt() -> None:
    """Begin a new line, for what is to be said before anything is asked; the prompt comes again."""
    if DONE.has_prompt:
        DONE.has_prompt = False
        _print("\n")


def _print(text: str) -> None:
    """Where nobody reads there is nothing to begin, and nobody to be told so."""
    try:
        os.write(1, text.encode())
    except OSError:
        sys.exit(_NOBODY_READS)


def forget() -> None:
    """The conversation is over. Another one, after the full screen, begins with a greeting of its own."""
    DONE.was_printed = DONE.has_prompt = False
    DONE.terminal = None


def language_of(options: dict[str, str], environment: os._Environ[str] | dict[str, str]) -> str:
    """The language of the options, else of ``DONNIE_LANG``, else of the locale, else English."""
    locale = environment.get("LC_ALL") or environment.get("LC_MESSAGES") or environment.get("LANG") or ""
    for given in (options.get("--lang", ""), environment.get("DONNIE_LANG", ""), locale):
        if given[:2].lower() in _LANGUAGES:
            return given[:2].lower()
    return "en"


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


def _take_terminal() -> None:
    """Until somebody listens for signals, Ctrl+C is kept like any other key."""
    import atexit

    from donnie_tui.linear.terminal import Terminal

    terminal = Terminal()
    terminal.take(signals=False)
    atexit.register(terminal.give_back)
    DONE.terminal = terminal
