"""The linear mode for the commands: its questions block, and its lists are printed."""

from __future__ import annotations

from collections.abc import Callable, Coroutine, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from donnie_tui.commands.interaction import SLOW, SLOW_AGAIN, Option, drive
from donnie_tui.linear.reader import How

if TYPE_CHECKING:
    from donnie_tui.core.runner import Run
    from donnie_tui.linear.desk import Desk

T = TypeVar("T")

_LONGEST_NUMBER = 8


class LinearInteraction:
    """``commands.interaction.Interaction`` at the prompt. Nothing in it ever waits for an event loop."""

    def __init__(self, desk: Desk) -> None:
        self._desk = desk

    @property
    def can_edit(self) -> bool:
        return self._desk.ends.can_edit

    @property
    def is_attended(self) -> bool:
        return self._desk.is_attended

    # --- questions

    async def ask(
        self, question: str, text: str = "", accepts: Callable[[str], str | None] | None = None
    ) -> str | None:
        asking = self._desk.asking
        asking.offered = text
        answer = asking.answer_to(question)
        while answer and accepts is not None and (problem := accepts(answer)) is not None:
            answer = asking.answer_to(problem)
        return answer or None

    async def choose(
        self,
        question: str,  # noqa: ARG002 -- the list is read without it
        options: Sequence[Option],
        printed: Sequence[str] = (),
    ) -> str | None:
        """The number of an option, typed next, chooses it; any other line is none of this."""
        desk, by_number = self._desk, {each.number: each.value for each in options if each.number}
        desk.tell(*printed)
        if not by_number:
            return None
        desk.answer("linear-type-number")
        typed = desk.read_next()
        text = typed.text.strip()
        if typed.how is not How.ENTER or not text.isdecimal() or len(text) > _LONGEST_NUMBER:
            desk.asking.put_back(typed)
            return None
        number = int(text)
        if number not in by_number:
            desk.answer("answer-no-line", line=number, last=max(by_number))
            return None
        desk.answer("linear-listed", line=number, text=by_number[number])
        return by_number[number]

    async def confirm(self, question: str) -> bool | None:
        return self._desk.asking.decide(question)

    async def edit_line(self, question: str, text: str = "") -> str | None:
        desk = self._desk
        desk.asking.offered = text
        desk.tell(question)
        typed = desk.read_next()
        if typed.how is How.ENTER or (typed.how is How.ESCAPE and typed.text.strip()):
            return typed.text
        if typed.how is How.CLOSED or desk.console.leaving is not None:
            desk.asking.put_back(typed)
        return None

    async def show_pages(
        self,
        title: str,  # noqa: ARG002 -- the lines are read without it
        lines: Sequence[str],
        printed: Sequence[str] | None = None,
    ) -> None:
        self._desk.tell(*(lines if printed is None else printed))

    # --- time

    async def background(
        self, task: Callable[[], T], slow: str, *, may_be_left: bool = False, is_slow: bool = False
    ) -> T:
        from donnie_tui.linear.patience import aside

        desk = self._desk
        return aside(
            desk.console,
            task,
            lambda: desk.tell(slow),
            first=SLOW_AGAIN if is_slow else SLOW,
            show=desk.showing.show_told,
            may_be_left=may_be_left,
        )

    async def finish(self, task: Coroutine[Any, Any, T]) -> T:
        return await task

    async def finished(self) -> None:
        """Nothing runs while a question is asked."""

    async def follow(self, runs: Sequence[tuple[str | None, Run]]) -> bool:
        self._desk.follow(runs)
        return True

    async def wait(self, seconds: float) -> bool:
        from donnie_tui.linear.sounding import is_disturbed

        self._desk.showing.show_told()
        return is_disturbed(self._desk, seconds)

    def print_soon(self) -> None:
        self._desk.console.nudge()

    def continue_on_enter(self, more: Callable[[], Coroutine[Any, Any, None]]) -> None:
        self._desk.goes_on = lambda: drive(more())

    def setting_changed(self, key: str) -> None:  # noqa: ARG002 -- all of them are looked at
        self._desk.ends.apply_options()

    def before_robot_changes(self) -> None:
        """Each robot keeps its own document."""

    def robot_changed(self) -> None:
        self._desk.workspace.choose_robot(self._desk.session.name)

    async def type_again(self, line: str) -> None:
        self._desk.take_again(line)

    # --- ways out

    async def enter_world(self, name: str) -> None:
        """Raises ``EnterWorld``; while a program is held that is left to the loop that stops it first."""
        from donnie_tui.linear.going import depart

        self._desk.goes_to = name
        if not self._desk.beside.is_watching:
            depart(self._desk)

    async def switch_mode(self) -> None:
        from donnie_tui.linear.modes import switch_to_screen

        switch_to_screen(self._desk)

    async def quit(self) -> None:
        self._desk.quit()
