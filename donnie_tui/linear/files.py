"""The words about files: OPEN, SAVE, SAVE AS, NEW, RECOVER."""

from __future__ import annotations

from pathlib import Path

from donnie_tui.core.documents import (
    DocumentError,
    changed_since,
    exists,
    program_to_open,
    program_to_save,
    read_program,
    write_program,
)
from donnie_tui.linear.arguments import Handler, alone
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.lines import tell_back_again
from donnie_tui.linear.patience import GivenUp, patiently
from donnie_tui.linear.runs import Runs


def open_named(desk: Desk, name: str) -> None:
    """Open what somebody calls ``name``, and say so, or why not."""
    try:
        path = program_to_open(name)
    except DocumentError as error:
        refuse(desk, error)
    else:
        open_file(desk, path)


def open_file(desk: Desk, path: Path) -> None:
    try:
        text = patiently(desk, lambda: read_program(path), "slow-opening", may_be_left=True, name=path.name)
    except DocumentError as error:
        refuse(desk, error)
        return
    except GivenUp:
        desk.answer("answer-unchanged")
        return
    if _may_lose_program(desk):
        desk.program.replace(text, str(path))
        desk.programs.bring_breakpoints()
        desk.answer("answer-opened", name=path.name, lines=len(desk.program.lines))
        _tell_breakpoints(desk)
    else:
        desk.answer("answer-unchanged")


def _tell_breakpoints(desk: Desk) -> None:
    """Where it will hold, of itself: nobody remembers that from the last time."""
    if desk.program.breakpoints:
        desk.answer("break-lines", lines=", ".join(map(str, sorted(desk.program.breakpoints))))


def save_named(desk: Desk, name: str) -> bool:
    """Save to what somebody calls ``name``, or where it came from. Whether it was saved."""
    if not desk.program.lines:
        desk.answer("linear-nothing-to-save")
        return False
    name = name or desk.program.name or (desk.asking.ask("linear-ask-name") if desk.is_attended else "")
    if not name:
        desk.answer("answer-unchanged")
        return False
    try:
        return _save(desk, program_to_save(name, desk.donnie.in_use))
    except DocumentError as error:
        refuse(desk, error)
        return False


def new_program(desk: Desk) -> None:
    if _may_lose_program(desk):
        desk.program.clear()
        desk.answer("answer-new")
    else:
        desk.answer("answer-unchanged")


def recover(desk: Desk) -> None:
    """Open what was rescued when Donnie had to leave. It counts as unsaved."""
    copy = desk.programs.copies.offered()
    if copy is None:
        desk.answer("answer-nothing-to-recover")
    elif not _may_lose_program(desk):
        desk.answer("answer-unchanged")
    else:
        _take_copy(desk, copy)


def _take_copy(desk: Desk, copy: Path) -> None:
    try:
        copies = desk.programs.copies_of(desk.program)
        found = patiently(desk, lambda: copies.take(copy), "slow-opening", name=copy.name)
    except DocumentError as error:
        refuse(desk, error)
        return
    desk.program.replace(found.text, str(found.path) if found.path else None)
    desk.program.saved = False
    desk.programs.bring_breakpoints()
    tell_back_again(desk)


def holds(path: Path, text: str) -> bool:
    """Whether the file has just this text."""
    try:
        return read_program(path).splitlines() == text.splitlines()
    except DocumentError:
        return False


def refuse(desk: Desk, error: DocumentError) -> None:
    desk.answer(error.code, path=error.path, reason=error.reason)


def _save(desk: Desk, path: Path) -> bool:
    if not may_replace(desk, path):
        desk.answer("answer-unchanged")
        return False
    text = desk.program.text
    patiently(desk, lambda: write_program(path, text), "slow-saving", name=path.name)
    desk.program.name, desk.program.saved = str(path), True
    desk.programs.keep_breakpoints()
    desk.answer("answer-saved", name=path.name, lines=len(desk.program.lines))
    return True


def may_replace(desk: Desk, path: Path) -> bool:
    """What this program did not put there is replaced only by somebody who wants it.

    Raises ``DocumentError`` where nobody can be asked.
    """
    is_own = str(path) == desk.program.name
    known = desk.program.saved_text
    if is_own and (known is None or not changed_since(path, known)):
        return True
    if not exists(path):
        return True
    if not desk.is_attended:
        raise DocumentError("file-exists", str(path))
    asked = "linear-ask-replace-changed" if is_own else "linear-ask-replace"
    return desk.asking.ask_yes(asked, name=path.name)


def _open(desk: Desk, _: Runs, rest: str) -> bool:
    if rest:
        open_named(desk, rest)
    return bool(rest)


def _save_word(desk: Desk, _: Runs, rest: str) -> bool:
    """Without a name where nobody can be asked for one, it is shown how it is said."""
    can_be_named = bool(rest or desk.program.name or desk.is_attended or not desk.program.lines)
    if can_be_named:
        save_named(desk, rest)
    return can_be_named


HANDLERS: dict[str, Handler] = {
    "open": _open,
    "save": _save_word,
    "save_as": _save_word,
    "new": alone(new_program),
    "recover": alone(recover),
}


def _may_lose_program(desk: Desk) -> bool:
    """Whether the typed program may be replaced; asks where somebody would miss it."""
    if not (desk.is_attended and desk.program.is_worth_saving):
        return True
    return desk.asking.ask_yes("linear-ask-lose", lines=len(desk.program.lines))
