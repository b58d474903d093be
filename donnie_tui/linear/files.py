"""The words about files: OPEN, SAVE, SAVE AS, NEW, RECOVER."""

from __future__ import annotations

from pathlib import Path

from donnie_tui.core.copies import Copies, Rescued
from donnie_tui.core.documents import (
    DocumentError,
    changed_since,
    exists,
    is_same_file,
    program_to_open,
    program_to_save,
    read_program,
    saved_text,
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
    """Open what was rescued when Donnie had to leave. It is saved if its file has the same."""
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
        found, in_file = patiently(desk, lambda: _taken(copies, copy), "slow-opening", name=copy.name)
    except DocumentError as error:
        refuse(desk, error)
        return
    desk.program.replace(found.text, str(found.path) if found.path else None, in_file=in_file)
    desk.programs.bring_breakpoints()
    tell_back_again(desk)
    if desk.programs.copies.rescued():
        desk.answer("answer-rescued-more")


def _taken(copies: Copies, copy: Path) -> tuple[Rescued, str]:
    """What it holds, and what its file has now."""
    found = copies.take(copy)
    return found, saved_text(found.path) if found.path else ""


def refuse(desk: Desk, error: DocumentError) -> None:
    desk.answer(error.code, path=error.path, reason=error.reason)


def _save(desk: Desk, path: Path) -> bool:
    if not may_replace(desk, path):
        desk.answer("answer-unchanged")
        return False
    text = desk.program.text
    patiently(desk, lambda: write_program(path, text), "slow-saving", name=path.name)
    desk.program.name = str(path)
    desk.program.was_saved()
    desk.programs.keep_breakpoints()
    desk.answer("answer-saved", name=path.name, lines=len(desk.program.lines))
    return True


def may_replace(desk: Desk, path: Path) -> bool:
    """What this program did not put there is replaced only by somebody who wants it.

    Raises ``DocumentError`` where nobody can be asked.
    """
    name = desk.program.name
    is_own = name is not None and is_same_file(path, Path(name))
    if is_own and not changed_since(path, desk.program.saved_text):
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
