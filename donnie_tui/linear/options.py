"""How the linear mode behaves, as far as the settings say: pages, prompts, editing, signs of life."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum

from donnie_tui.linear.greeting import PROMPT
from donnie_tui.settings.settings import Settings


class Page(Enum):
    """What comes between two screenfuls of an answer."""

    REST = "rest"
    ASK = "ask"
    OFF = "off"


class Prompt(Enum):
    """What stands before the line that is typed."""

    SHORT = "short"
    NONE = "none"
    WORD = "word"
    ANSWER = "answer"
    """The last line of the answer, so that the cursor of a braille display stays on it."""


class Options:
    """The settings of the linear mode, as they are now."""

    def __init__(self, settings: Callable[[], Settings]) -> None:
        self._settings = settings

    @property
    def page(self) -> Page:
        return Page(self._settings().page)

    @property
    def prompt(self) -> Prompt:
        return Prompt(self._settings().prompt)

    @property
    def hold(self) -> bool:
        """Whether each line of an answer waits for Enter."""
        return self._settings().hold == "on"

    @property
    def editor(self) -> bool:
        """Whether Donnie edits lines; else the terminal does, and nothing but text is ever written."""
        return self._settings().editor == "own"

    @property
    def enter(self) -> bool:
        """Whether Enter runs each complete line at once."""
        return self._settings().enter == "runs"

    @property
    def progress(self) -> int:
        """Seconds between two signs of life of a run; 0 is never."""
        return int(self._settings().progress)

    def prompt_at(self, depth: int) -> str:
        """What stands before a line that is typed inside so many blocks."""
        level = str(depth) if depth else ""
        match self.prompt:
            case Prompt.NONE:
                return ""
            case Prompt.WORD:
                return f"{f'Donnie {level}'.strip()}{PROMPT}"
            case _:
                return f"{level}{PROMPT}"
