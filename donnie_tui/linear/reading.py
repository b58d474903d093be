"""The words for reading a program: READ, NEXT, BACK, FIRST, LAST LINE, PLACE, UP, DOWN, NEXT SAME, OUTLINE.

The place is the line that was read last. A move that is not possible says so and stays.
"""

from __future__ import annotations

from collections.abc import Callable

from donnie_tui.core.line_words import no_such_line
from donnie_tui.core.reading import ProgramText, line_in_words, outline_in_words, place_in_words
from donnie_tui.core.typed_words import number_in
from donnie_tui.linear.arguments import Handler, alone
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.runs import Runs


def program_text(desk: Desk) -> ProgramText:
    """The program with its levels; read anew only where it has changed."""
    lines = desk.program.lines
    if desk.read_text is None or desk.read_text.lines != lines:
        desk.read_text = ProgramText(lines)
    return desk.read_text


def go_to(desk: Desk, number: int) -> None:
    """Read line ``number`` and stay there; the level is told if it is another one than before."""
    text = program_text(desk)
    try:
        line = text.line(number)
    except IndexError:
        _refuse(desk, number)
        return
    before = text.line(desk.place) if 1 <= desk.place <= len(text) else None
    desk.place = number
    desk.tell(line_in_words(line, before, desk.say))


def _refuse(desk: Desk, number: int) -> None:
    desk.tell(no_such_line(len(desk.program.lines), number, desk.say))


def _read(desk: Desk, _: Runs, rest: str) -> bool:
    line = number_in(rest, max(1, desk.place))
    if line is not None:
        go_to(desk, line)
    return line is not None


def _step_to(name: str, where: Callable[[Desk], int]) -> Handler:
    """One line on or back; past the ends it stays, and says so."""

    def go(desk: Desk) -> None:
        number, last = where(desk), len(desk.program.lines)
        if last and not 1 <= number <= last:
            desk.answer(f"read-no-{name}")
        else:
            go_to(desk, number)

    return alone(go)


def _move(name: str, find: Callable[[ProgramText, int], int | None]) -> Handler:
    def go(desk: Desk) -> None:
        text = program_text(desk)
        if not text:
            desk.answer("linear-no-lines")
            return
        found = find(text, min(max(1, desk.place), len(text)))
        if found is None:
            desk.answer(f"read-no-{name}")
        else:
            go_to(desk, found)

    return alone(go)


def _place(desk: Desk) -> None:
    text = program_text(desk)
    if text:
        desk.tell(*place_in_words(text, min(max(1, desk.place), len(text)), desk.say))
    else:
        desk.answer("linear-no-lines")


def _outline(desk: Desk) -> None:
    desk.tell(*outline_in_words(program_text(desk), desk.say))


HANDLERS: dict[str, Handler] = {
    "read": _read,
    "next": _step_to("next", lambda desk: desk.place + 1),
    "back": _step_to("back", lambda desk: desk.place - 1),
    "first": alone(lambda desk: go_to(desk, 1)),
    "last_line": alone(lambda desk: go_to(desk, len(desk.program.lines))),
    "place": alone(_place),
    "up": _move("up", ProgramText.up),
    "down": _move("down", ProgramText.down),
    "next_same": _move("next_same", ProgramText.next_same),
    "back_same": _move("back_same", ProgramText.back_same),
    "outline": alone(_outline),
}
