"""What a front end implements for the commands: questions, lists, pages, slow tasks and ways out.

``Interaction`` is for every front end, ``Screen`` for one that shows program, map and log at once.
This module imports nothing heavy: the front ends start with it.

The functions parse arguments and answers: yes and no, on and off, numbers, a line
with its text. They return None for anything else, never an empty value, so that a typing slip deletes no
line; ``read_count`` and ``read_numbers`` raise ``NotUnderstood``."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Coroutine, Generator, Iterable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from msgspec import Struct

if TYPE_CHECKING:
    from pathlib import Path

    from donnie_tui.bootstrap import Donnie
    from donnie_tui.commands.keys import KeyTable
    from donnie_tui.core.map_grid import Cell
    from donnie_tui.core.map_scene import Line, MapScale
    from donnie_tui.core.map_words import Pointer
    from donnie_tui.core.runner import Run


SLOW, SLOW_AGAIN = 1.0, 10.0
"""Seconds until a slow task is reported, and between further reports."""

T = TypeVar("T")


class NotUnderstood(Exception):
    """Raised by a handler that can't understand its argument. The dispatcher answers with the typed form."""

    def __init__(self, meant: str = "") -> None:
        """``meant``: the kind of argument that was meant, of a command that takes several."""
        self.meant = meant


class GivenUp(Exception):
    """Raised if the learner cancels a question or a slow task. The dispatcher answers."""


class EnterWorld(Exception):
    """Raised to leave this world for another one, which can be loaded."""

    def __init__(self, name: str) -> None:
        self.name = name


class SwitchMode(Exception):
    """Raised to leave this front end for the other one, with what that one takes over."""

    def __init__(self, text: str, name: str | None, donnie: Donnie | None = None) -> None:
        """``donnie`` is the session to continue with, its robot where it stands.

        The front end that takes it over closes it.
        """
        self.text = text
        self.name = name
        self.donnie = donnie


class Option(Struct, frozen=True):
    """One of several things to choose from."""

    value: str
    text: str
    is_current: bool = False
    """Whether it is the current choice."""
    number: int = 0
    """The number that chooses it from a printed list; 0 if it has none."""
    also: str = ""
    """Other words with which a learner may look for it; they are not shown."""
    columns: tuple[str, ...] = ()
    """``text`` in columns, if a list has room for them; no option has more than the first."""
    detail: Callable[[int, int], Sequence[str]] | None = None
    """Returns details for that many columns and rows, if a list has room for them."""


class Interaction(Protocol):
    """One learner at one front end. Answers go through ``Context.say`` instead."""

    @property
    def can_edit(self) -> bool:
        """Whether ``edit_line`` shows the text that is to be changed."""

    @property
    def is_attended(self) -> bool:
        """Whether a question can be answered: not where the lines come from a file."""

    async def ask(
        self,
        question: str,
        text: str = "",
        accepts: Callable[[str], str | None] | None = None,
    ) -> str | None:
        """Ask for a line, which begins with ``text`` where it is seen; None if the learner cancels.

        ``accepts`` returns what is wrong with a line, and the question is asked again.
        """

    async def ask_file(
        self, question: str, text: str, recent: Callable[[], Sequence[Path]], *, is_new: bool = False
    ) -> str | Path | None:
        """Ask for a program: its typed name, its file if it was chosen from a list, or None.

        A front end with lists shows the folders, the ``recent`` programs first. ``is_new``: the name may be
        that of a new file.
        """

    async def choose(
        self, question: str, options: Sequence[Option], printed: Sequence[str] = ()
    ) -> str | None:
        """The value of the chosen option, or None.

        A front end without lists says ``printed`` instead; options with numbers can be chosen there too.
        """

    async def confirm(self, question: str) -> bool | None:
        """Ask for yes or no. Enter alone means no; None is no answer."""

    async def edit_line(self, question: str, text: str = "") -> str | None:
        """Let the learner edit ``text``, a line of the program. None if the learner cancels."""

    async def show_pages(
        self, title: str, lines: Sequence[str], printed: Sequence[str] | None = None
    ) -> None:
        """Show a longer text. A front end without windows prints ``printed``, or ``lines``."""

    async def background(
        self, task: Callable[[], T], slow: str, *, may_be_left: bool = False, is_slow: bool = False
    ) -> T:
        """Run ``task`` in its own thread; a long one is reported with ``slow`` from time to time.

        Raises ``GivenUp`` where the learner gives up a task that ``may_be_left``. ``is_slow``: the learner
        knows that it takes some seconds.
        """

    async def finish(self, task: Coroutine[Any, Any, T]) -> T:
        """Run ``task`` to its end, whatever the learner asks for meanwhile; one such task at a time."""

    async def finished(self) -> None:
        """Wait until the task of ``finish`` has ended."""

    async def follow(self, runs: Sequence[tuple[str | None, Run]]) -> bool:
        """Wait for the end of the runs if a prompt follows them, each by its robot's name in events.

        False if the learner continues meanwhile.
        """

    async def wait(self, seconds: float) -> bool:
        """Wait for that many seconds. Returns whether the learner interrupted."""

    def continue_on_enter(self, more: Callable[[], Coroutine[Any, Any, None]]) -> None:
        """Run ``more`` if the next line is empty."""

    def setting_changed(self, key: str) -> None:
        """Apply the new value of a setting."""

    def before_robot_changes(self) -> None:
        """Keep the text for the current robot: the learner is about to choose another one."""

    def robot_changed(self) -> None:
        """The learner talks to another robot."""

    async def type_again(self, line: str) -> None:
        """Handle a line as if the learner had typed it."""

    def print_soon(self) -> None:
        """Print the answers so far, since the command takes longer. From any thread."""

    # --- ways out

    async def enter_world(self, name: str) -> None:
        """Enter a world with the same programs, unless the learner stays because of unsaved changes."""

    async def switch_mode(self) -> None:
        """Continue in the other front end."""

    async def quit(self) -> None:
        """End Donnie, unless the learner stays because of unsaved changes."""


class MapPane(Protocol):
    """The map on the screen."""

    pointer: Pointer | None
    scale: MapScale | None
    shows_all: bool
    has_rulers: bool

    @property
    def zoom(self) -> int: ...

    @property
    def columns(self) -> int:
        """Columns of a square."""

    @property
    def has_names(self) -> bool: ...

    def set_zoom(self, zoom: int) -> bool:
        """Zoom as far as possible; whether that has changed the map."""

    def show_all(self, whole: bool) -> None: ...

    def show_names(self, labels: Callable[[MapScale, int], dict[Cell, str]] | None) -> None: ...

    def show_rulers(self, shown: bool) -> None: ...

    @property
    def is_picture(self) -> bool: ...

    @property
    def has_colours(self) -> bool: ...

    def show_picture(self, wanted: bool) -> None: ...


class Screen(Protocol):
    """What only a screen can do."""

    @property
    def map(self) -> MapPane: ...

    @property
    def log_text(self) -> str: ...

    def focus(self, pane: str) -> None:
        """Focus ``program``, ``map`` or ``log``; show or hide ``variables``."""

    async def complete(self) -> None:
        """Offer the words that may continue what was typed, at the cursor."""

    def mark_mistakes(self) -> None:
        """Mark the mistakes of the program as it is now."""

    def place_cursor(self, line: int, column: int) -> None:
        """Moves the cursor in the program; the focus stays."""

    def explore(self, change: Callable[[Pointer], object]) -> None:
        """Change the pointer on the map, with the focus there."""

    def show_sensor_ranges(self, lines: Iterable[Line]) -> None: ...

    def search_log(self, word: str, lines: int) -> None:
        """Go to the newest line of the log with the word; the title says how many ``lines`` were found."""

    @property
    def log_kinds(self) -> Mapping[str, int]:
        """The words of the kinds of lines in the log, each with the number of its lines."""

    @property
    def log_filter(self) -> str:
        """The kind of the lines that the log shows; empty for all."""

    def filter_log(self, kind: str) -> None:
        """Show only the lines of that kind; empty for all."""

    def show_in_pager(self, text: str) -> None: ...

    def show_help(self, *, is_everything: bool) -> None: ...

    def show_keys(self) -> None: ...

    def show_tour(self) -> None: ...

    def repaint(self) -> None: ...

    def robot_changed(self) -> None:
        """Update the screen: the robot is another one, or was placed elsewhere."""

    @property
    def is_plain(self) -> bool:
        """Whether it is one column without decoration."""

    @property
    def is_page(self) -> bool:
        """Whether it is a page in a browser, which has no terminal."""

    @property
    def key_table(self) -> KeyTable: ...

    def show_manual(self) -> None: ...

    async def press_key(self, question: str, accepts: Callable[[str], str | None]) -> str | None: ...


def drive(coroutine: Coroutine[Any, Any, T]) -> T:
    """Run a coroutine that never waits, because the front end's questions block."""
    try:
        coroutine.send(None)
    except StopIteration as done:
        result: T = done.value
        return result
    coroutine.close()
    raise RuntimeError("a command waits in a front end whose questions block")


def begin(coroutine: Coroutine[Any, Any, None]) -> Awaitable[None] | None:
    """Run a coroutine until it first waits. Returns the rest to await, or None if it has ended.

    It waits with ``asyncio.sleep(0)`` before anything else, so that the rest may run in a task of its own.
    """
    try:
        coroutine.send(None)
    except StopIteration:
        return None
    return _Rest(coroutine)


class _Rest:
    """A coroutine that has begun."""

    def __init__(self, coroutine: Coroutine[Any, Any, None]) -> None:
        self._coroutine = coroutine

    def __await__(self) -> Generator[Any, Any, None]:
        step: Callable[[], Any] = partial(self._coroutine.send, None)
        while True:
            try:
                waited_for = step()
            except StopIteration:
                return
            try:
                sent = yield waited_for
            except BaseException as problem:  # noqa: BLE001 -- thrown into the coroutine
                step = partial(self._coroutine.throw, problem)
            else:
                step = partial(self._coroutine.send, sent)


def read_count(argument: str, default: int) -> int:
    """A number from 1, or ``default`` where nothing was typed."""
    found = count_in(argument, default)
    if found is None:
        raise NotUnderstood
    return found


def read_numbers(argument: str, *, least: int = 0, most: int) -> tuple[int, ...]:
    """Reads from ``least`` to ``most`` whole numbers, with blanks or commas between them."""
    found = numbers_in(argument, most=most)
    if found is None or len(found) < least:
        raise NotUnderstood
    return found


def detail_named(typed: str) -> str | None:
    """How much is to be printed: ``brief``, ``normal`` or ``full``; None for any other word."""
    return _meant(typed, "details")


def answered(typed: str) -> bool | None:
    """Whether the answer is yes; None if it is neither yes nor no."""
    return {"yes": True, "no": False}.get(_meant(typed, "answers") or "")


def switched(typed: str) -> bool | None:
    """Whether something is to be on; None if what was typed means neither on nor off."""
    return {"on": True, "off": False}.get(_meant(typed, "switch") or "")


NO_REPLACEMENT = '""'
"""What is typed to delete a word everywhere."""


def replacement(typed: str | None) -> str | None:
    """The text with which REPLACE replaces a word. None for no answer and for Enter alone: nothing changes.

    Two quotes delete the word, since they are not typed by mistake.
    """
    return "" if typed == NO_REPLACEMENT else typed or None


LARGEST_NUMBER = 10_000_000
"""No program has so many lines, no session so many answers, no world so many squares."""
_MOST_CHARACTERS = 8


def numbers_in(typed: str, *, most: int) -> tuple[int, ...] | None:
    """Read at most that many whole numbers, with blanks or commas between them."""
    words = typed.replace(",", " ").split()
    if len(words) > most or not all(map(_is_whole, words)):
        return None
    found = tuple(map(int, words))
    return found if all(abs(each) <= LARGEST_NUMBER for each in found) else None


def count_in(typed: str, default: int) -> int | None:
    """The only number in the text, or ``default`` if it is empty; None unless it is 1 or more."""
    found = numbers_in(typed, most=1)
    number = 0 if found is None else next(iter(found), default)
    return number if number >= 1 else None


def number_and_text(typed: str) -> tuple[int, str] | None:
    """``3 FW 2`` is line 3 with its text, which may be empty."""
    word, _blank, text = typed.partition(" ")
    found = numbers_in(word, most=1)
    return (found[0], text.strip()) if found else None


def _is_whole(word: str) -> bool:
    return len(word) <= _MOST_CHARACTERS and word.removeprefix("-").isdecimal()


def _meant(typed: str, group: str) -> str | None:
    from donnie_tui.core.wording import meant  # the first frame needs none

    return meant(typed, group)
