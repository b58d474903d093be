"""Readers of typed lines: edited key by key on a terminal, or as plain lines from anywhere else.

Both return the same values. What is typed while a program runs stays with the system until a line is read.
"""

from __future__ import annotations

from codecs import BOM_UTF16_BE, BOM_UTF16_LE, IncrementalDecoder, getincrementaldecoder
from collections import deque
from collections.abc import Callable, Iterable
from enum import Enum, auto
from itertools import takewhile
from typing import TYPE_CHECKING, Protocol

from msgspec import Struct

from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.lookup import find, words_of
from donnie_tui.core.program_files import file_names
from donnie_tui.core.session_log import LineHistory, Recall
from donnie_tui.linear.console import Console
from donnie_tui.linear.line_editor import ESCAPE_DELAY, Act, EditLine, KeyDecoder, KeyPress
from language import keywords
from language.source import fold_name

if TYPE_CHECKING:
    from donnie_tui.commands.context import Context

LONGEST_PLAIN = 1024 * 1024
"""Bytes of a plain line; a longer one is no program and is not kept."""


class How(Enum):
    """How a line ended."""

    ENTER = auto()
    ESCAPE = auto()
    """ESC: run it at once, even if it is unfinished."""
    INTERRUPTED = auto()
    """Ctrl+C: it does not count."""
    CLOSED = auto()
    """Nothing more will come: Ctrl+D, the end of the input, or a signal to leave."""
    NEWS = auto()
    """It continues once the news is printed."""
    TOO_LONG = auto()
    """A line longer than any program's was left out."""
    CHOICES = auto()
    """Tab was pressed, and there are several words to choose from."""


class Typed(Struct, frozen=True):
    text: str
    how: How
    choices: tuple[str, ...] = ()


class Reader(Protocol):
    """A source of typed lines."""

    holds_newline: bool
    """Whether the newline that ends the typed line must still be written."""

    @property
    def has_typed(self) -> bool:
        """Whether input was read that is no whole line yet."""

    def read(self, prompt: str, offered: str = "") -> Typed:
        """The next line. ``prompt`` and ``offered``, the text to be edited, were printed already."""


class EditingReader:
    """Reads keys and writes what they change, as little as that takes."""

    holds_newline = True

    def __init__(self, console: Console, past: LineHistory) -> None:
        self._console = console
        self._past = past
        self.complete: Callable[[str], tuple[str, ...]] = lambda _text: ()
        """Returns the words that the last word of a text may become."""
        self.on_key: Callable[[KeyPress, str], None] = lambda _key, _before: None
        """Called with each key before it is done, and with the text before the cursor."""
        self._decoder = KeyDecoder()
        self._keys: deque[KeyPress] = deque()

    @property
    def has_typed(self) -> bool:
        return bool(self._keys)

    def read(self, prompt: str, offered: str = "") -> Typed:
        line = EditLine(len(prompt), self._console.columns, offered)
        recall = Recall(self._past, offered)
        self._console.repaint = lambda: f"\n{prompt}{line.text}"
        try:
            if placing := line.place_cursor():
                self._console.write(placing)
            return self._edit(line, recall)
        finally:
            self._console.repaint = str

    def _edit(self, line: EditLine, recall: Recall) -> Typed:
        while True:
            typed, echo = self._do_keys(line, recall)
            if echo:
                self._console.write(echo)
            if typed:
                return typed
            if not self._more_keys(at_once=self._is_woken(line)):
                return Typed(line.text, How.CLOSED)
            if self._console.take_interrupt():
                self._forget_keys()
                return Typed(line.text, How.INTERRUPTED)
            if not self._keys and self._has_news(line):
                self._console.write(line.finish())
                return Typed(line.text, How.NEWS)

    def _is_woken(self, line: EditLine) -> bool:
        """Whether the reason for a wake-up arrived already, during another wait: it wakes only once."""
        console = self._console
        return console.interrupted or console.has_news or (not line.text and console.lines_wait())

    def _has_news(self, line: EditLine) -> bool:
        """Whether something can't wait, or waits and nothing is typed."""
        return self._console.take_news() or (not line.text and self._console.lines_wait())

    def _do_keys(self, line: EditLine, recall: Recall) -> tuple[Typed | None, str]:
        """Do the keys that wait, up to one that ends the line; what that writes goes out at once."""
        echo = ""
        while self._keys:
            key = self._keys.popleft()
            self.on_key(key, line.text_before)
            if key.act is Act.ENTER or key.act is Act.ESCAPE:
                how = How.ENTER if key.act is Act.ENTER else How.ESCAPE
                return Typed(line.text, how), echo + line.finish()
            if key.act is Act.INTERRUPT:
                return Typed(line.text, How.INTERRUPTED), echo + line.finish()
            if key.act is Act.CLOSE and not line.text:
                return Typed("", How.CLOSED), echo
            if key.act is Act.COMPLETE:
                choices, completed = self._completed(line)
                if choices:
                    return Typed(line.text, How.CHOICES, choices), echo + line.finish()
                echo += completed
            else:
                echo += _changed(line, recall, key)
        return None, echo

    def _completed(self, line: EditLine) -> tuple[tuple[str, ...], str]:
        """The words to choose from, none if there is only one; and what typing their common part writes."""
        typed = line.text_before.rpartition(" ")[2]
        found = self.complete(line.text_before)
        common = _common(found)
        if len(common) > len(typed) or len(found) == 1:
            is_whole = len(found) == 1 and not common.endswith("/")  # in a folder there is more to choose
            return (), line.complete(typed, common + (" " if is_whole else ""))
        return found, ""

    # --- while a program runs

    def take_ahead(self, is_wanted: Callable[[str], bool]) -> str | None:
        """The first whole line typed meanwhile that is wanted now, anywhere among those that wait.

        The line is not read again; the others stay as they were typed. None if there is no such line.

        Ctrl+C may come as a key, from before signals were handled: it counts like the signal, which drops
        what was typed before it.
        """
        if self._console.wait(0, reading=True):
            self._keys += self._decoder.feed(self._console.read())
        self._take_interrupt_keys()
        keys, start = list(self._keys), 0
        for end, key in enumerate(keys):
            if key.act is Act.ENTER:
                text = _plain_text(keys[start:end])
                if text is not None and is_wanted(text):
                    self._keys = deque(keys[:start] + keys[end + 1 :])
                    return text
                start = end + 1
        return None

    def _take_interrupt_keys(self) -> None:
        while any(key.act is Act.INTERRUPT for key in self._keys):
            self._console.interrupted |= self._keys.popleft().act is Act.INTERRUPT

    def _more_keys(self, *, at_once: bool) -> bool:
        """Wait for keys or a signal; ``at_once``: only look. False once nothing more will come."""
        if self._console.leaving is not None:
            return False
        waiting = self._decoder.is_waiting
        longest = ESCAPE_DELAY if waiting else None
        if self._console.wait(0 if at_once else longest, reading=True):
            data = self._console.read()
            self._keys += self._decoder.feed(data)
            return bool(data)
        if waiting and not at_once:
            self._keys += self._decoder.give_up_waiting()
        return self._console.leaving is None

    def _forget_keys(self) -> None:
        self._keys.clear()
        self._decoder = KeyDecoder()


def _plain_text(keys: Iterable[KeyPress]) -> str | None:
    """The text that these keys type; None if that depends on more than these keys."""
    text = ""
    for key in keys:
        if key.act is Act.BACKSPACE:
            text = text[:-1]
        elif key.act is Act.TEXT:
            text += key.text
        else:
            return None
    return text


def _changed(line: EditLine, recall: Recall, key: KeyPress) -> str:
    match key.act:
        case Act.TEXT:
            return line.type(key.text)
        case Act.OLDER | Act.NEWER:
            found = recall.older(line.text) if key.act is Act.OLDER else recall.newer(line.text)
            return "" if found is None else line.replace(found)
        case act:
            return line.do(act)


def _common(words: tuple[str, ...]) -> str:
    """The beginning that all of them have."""
    letters = zip(*words, strict=False)
    same = takewhile(lambda each: len(set(each)) == 1, letters)
    return "".join(each[0] for each in same)


class PlainReader:
    """Reads lines as they come; a terminal that sends them edits them by itself.

    A line ends with LF, CR or both. What begins with the mark of UTF-16 is read as that.
    """

    holds_newline = False

    def __init__(self, console: Console) -> None:
        self._console = console
        self._pending = b""
        self._utf16: IncrementalDecoder | None = None
        self._has_begun = self._is_first_line_over = False
        self._ends_with_cr = False
        self._is_lost = False
        """Whether the line that is being read is too long."""
        self._ended = False

    @property
    def has_typed(self) -> bool:
        return bool(self._pending)

    def read(self, prompt: str, offered: str = "") -> Typed:  # noqa: ARG002 -- nothing can be offered here
        while True:
            typed = self._next_line()
            if typed is not None:
                return typed
            if self._ended or self._console.leaving is not None:
                return Typed("", How.CLOSED)
            is_woken = self._console.interrupted or self._console.has_news
            if self._console.wait(0 if is_woken else None, reading=True):
                self._take(self._console.read())
            elif self._console.take_interrupt():
                return Typed("", How.INTERRUPTED)
            elif self._console.take_news():
                return Typed("", How.NEWS)

    def _take(self, data: bytes) -> None:
        self._ended = not data
        if not self._has_begun and data[:2] in (BOM_UTF16_LE, BOM_UTF16_BE):
            self._utf16 = getincrementaldecoder("utf-16")(errors="replace")
        self._has_begun = True
        if self._utf16 is not None:
            data = self._utf16.decode(data, final=self._ended).encode()
        if data:
            self._pending += self._with_one_line_end(data)

    def _with_one_line_end(self, data: bytes) -> bytes:
        """CR LF may have come in two parts."""
        rest = data.removeprefix(b"\n") if self._ends_with_cr else data
        self._ends_with_cr = data.endswith(b"\r")
        return rest.replace(b"\r\n", b"\n").replace(b"\r", b"\n")

    def _next_line(self) -> Typed | None:
        line, newline, rest = self._pending.partition(b"\n")
        self._is_lost |= len(line) > LONGEST_PLAIN
        if not newline and not (self._ended and (line or self._is_lost)):
            self._pending = b"" if self._is_lost else self._pending
            return None
        self._pending = rest
        was_lost, self._is_lost = self._is_lost, False
        return Typed("", How.TOO_LONG) if was_lost else Typed(self._decoded(line), How.ENTER)

    def _decoded(self, line: bytes) -> str:
        """As UTF-8, else in the old code page of Western European languages."""
        try:
            text = line.decode("utf-8")
        except UnicodeDecodeError:
            text = line.decode("cp1252", errors="replace")
        was_first, self._is_first_line_over = not self._is_first_line_over, True
        return text.removeprefix("\ufeff" if was_first else "")


MOST_WORDS = 100
"""Words to choose from; more would be too many to listen to."""


def candidates(ctx: Context, before: str) -> tuple[str, ...]:
    """The words that the last word of ``before`` may become, in small letters if it was typed in these."""
    blank, last = " " in before.lstrip(), before.rpartition(" ")[2]
    asked = find(before)
    if blank and asked is not None and asked[0].argument == "file":
        return file_names(last)[:MOST_WORDS]
    if not last:
        return ()
    known = [*keywords.all_words(ctx.words.language), *ctx.donnie.session.variables, *_arguments(ctx, before)]
    if not blank:
        commands = (each for each in COMMANDS if not each.is_visual)
        known += [word for each in commands for word in words_of(each.name, ctx.words.language)]
    folded = fold_name(last)
    found = sorted({_as_typed(each, last) for each in known if fold_name(each).startswith(folded)})
    return tuple(found[:MOST_WORDS])


def _arguments(ctx: Context, before: str) -> tuple[str, ...]:
    """The values of the argument of the command with which the line begins, if there are few."""
    import worlds
    from donnie_tui.core.map_words import compass_words

    found = find(before)
    argument = found[0].argument if found is not None else ""
    if argument == "compass":
        return compass_words(ctx.words.language)
    if argument == "robot":
        return tuple(session.name for session in ctx.donnie.team.sessions)
    return worlds.names() if argument == "world" else ()


def _as_typed(word: str, typed: str) -> str:
    return word.lower() if typed.islower() else word
