"""What the words about the program's lines do at the screen: LIST, CHANGE, INSERT, DELETE, MOVE.

The rules and the sentences are the core's; here the text of the editor becomes lines and lines a text, as one
edit of only what differs: it can be undone, and breakpoints elsewhere stay.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from donnie_tui.core import line_words
from donnie_tui.core.line_words import Edited
from donnie_tui.core.typed_program import TypedProgram
from donnie_tui.core.typed_words import number_and_text, numbers_in
from language.source import lines_in

if TYPE_CHECKING:
    from donnie_tui.tui.host import WorkHost

MOST_TOLD = 20
"""Lines that LIST tells; more are shown in a window of their own."""


class LineDeeds:
    """One method an action. Those that ask something are coroutines."""

    def __init__(self, host: WorkHost) -> None:
        self._host = host
        self._editor = host.workplace.editor

    def list(self, argument: str) -> bool:
        """All lines, one, or those from one to another."""
        given, lines, words = numbers_in(argument, most=2), lines_in(self._editor.text), self._host.words
        if given is None:
            return False
        first, last = (*given, None, None)[:2]
        told = line_words.listed(lines, first, last, words, many=MOST_TOLD)
        if len(told) > MOST_TOLD:
            self._host.talk.tell_sentences(told[0])
            self._host.pages.show_lines(words("key-show_program"), told)
        else:
            self._host.talk.tell_sentences(*told)
        return True

    async def change(self, argument: str) -> bool:
        """CHANGE 3 FW 2; without a text the line is offered for editing."""
        given = number_and_text(argument)
        if given is None:
            return False
        number, text = given
        lines = lines_in(self._editor.text)
        if not text and 1 <= number <= len(lines):
            asked = self._host.words("linear-edit", line=number)
            text = await self._host.talk.ask(asked, value=lines[number - 1].strip()) or ""
        self._edit(lambda program: line_words.changed(program, number, text, self._host.words))
        return True

    async def insert(self, argument: str) -> bool:
        """INSERT 3 FW 2; without a text it is asked for."""
        given = number_and_text(argument)
        if given is None:
            return False
        number, text = given
        if not text and 1 <= number <= len(lines_in(self._editor.text)) + 1:
            text = await self._host.talk.ask(self._host.words("linear-type-line", line=number)) or ""
        self._edit(lambda program: line_words.inserted(program, number, text, self._host.words))
        return True

    def delete(self, argument: str) -> bool:
        """The line of the cursor, one line, or those from one to another."""
        given = numbers_in(argument, most=2)
        if given is None:
            return False
        first, last = (*(given or (self._editor.line,)), None)[:2]
        self._edit(lambda program: line_words.deleted(program, first or 0, last, self._host.words))
        return True

    def move(self, argument: str) -> bool:
        """MOVE 5 2: line 5 before line 2. MOVE 5 7 2: lines 5 to 7."""
        given = numbers_in(argument, most=3)
        if given is None or len(given) < 2:
            return False
        first, last, to = given[0], given[-2], given[-1]
        self._edit(lambda program: line_words.moved(program, first, last, to, self._host.words))
        return True

    def _edit(self, edit: Callable[[TypedProgram], Edited]) -> None:
        program = TypedProgram()
        program.replace(self._editor.text, None)
        done = edit(program)
        self._editor.become(program.lines)
        if done.line is not None:
            self._editor.go_to(done.line)
        self._host.talk.tell_sentences(*done.sentences)
