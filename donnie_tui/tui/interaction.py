"""The full screen for the commands: dialogs, pages in windows, and the panes."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine, Iterable, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from donnie_tui.commands.arguments import answered
from donnie_tui.commands.files import may_lose_all
from donnie_tui.commands.interaction import MapPane, Option
from donnie_tui.commands.keys import KeyTable
from donnie_tui.core.map_scene import Line
from donnie_tui.core.pointing import Pointer
from donnie_tui.core.runner import RunRequest
from donnie_tui.tui import patience
from donnie_tui.tui.answer import Answer

if TYPE_CHECKING:
    from donnie_tui.core.runner import Run
    from donnie_tui.tui.application import Host
    from donnie_tui.tui.host import WorkHost

T = TypeVar("T")


class ScreenInteraction:
    """``commands.interaction.Interaction`` and ``Screen`` of the application.

    A question begins with ``asyncio.sleep(0)``: a command runs at once as far as its first question, and the
    rest of it in a worker, which Textual needs for a dialog.
    """

    can_edit = is_attended = True

    def __init__(self, work: WorkHost, host: Host) -> None:
        self._work, self._host = work, host
        self._finishing = asyncio.Lock()
        self._words = work.words

    # --- questions

    async def ask(
        self, question: str, text: str = "", accepts: Callable[[str], str | None] | None = None
    ) -> str | None:
        await asyncio.sleep(0)
        return await self._host.ask(question, self._words("ask-keys"), text, accepts) or None

    async def choose(
        self,
        question: str,
        options: Sequence[Option],
        printed: Sequence[str] = (),  # noqa: ARG002 -- for front ends without lists
    ) -> str | None:
        """Options with the same text are one row."""
        rows = {each.text: each for each in reversed(options)}
        listed = [each for each in options if rows[each.text] is each]
        await asyncio.sleep(0)
        keys, nothing = self._words("chooser-keys"), self._words("palette-nothing")
        return await self._host.choose(question, keys, nothing, listed)

    async def confirm(self, question: str) -> bool | None:
        def unclear(typed: str) -> str | None:
            is_clear = not typed.strip() or answered(typed) is not None
            return None if is_clear else f"{self._words('yes-or-no')} {question}"

        await asyncio.sleep(0)
        typed = await self._host.ask(question, self._words("ask-keys"), "", unclear)
        return None if typed is None else bool(answered(typed))

    async def edit_line(self, question: str, text: str = "") -> str | None:
        return await self.ask(question, text)

    async def show_pages(
        self,
        title: str,
        lines: Sequence[str],
        printed: Sequence[str] | None = None,  # noqa: ARG002 -- for front ends without windows
    ) -> None:
        self._work.pages.show_lines(title, lines)

    # --- time

    async def background(
        self,
        task: Callable[[], T],
        slow: str,
        *,
        may_be_left: bool = False,
        is_slow: bool = False,
    ) -> T:
        """Where something else is asked for meanwhile, the log says that nothing changed."""
        del may_be_left
        await asyncio.sleep(0)
        if is_slow:
            return await asyncio.to_thread(task)
        try:
            return await patience.patiently(self._host, task, lambda: self._work.ctx.say(slow))
        except asyncio.CancelledError:
            self._work.talk.tell(Answer("answer-unchanged"))
            raise

    async def finish(self, task: Coroutine[Any, Any, T]) -> T:
        await asyncio.sleep(0)
        return await asyncio.shield(asyncio.ensure_future(self._finish(task)))

    async def _finish(self, task: Coroutine[Any, Any, T]) -> T:
        async with self._finishing:
            return await task

    async def finished(self) -> None:
        if self._finishing.locked():
            await asyncio.sleep(0)
            async with self._finishing:
                pass

    async def follow(self, runs: Sequence[tuple[str | None, Run]]) -> bool:  # noqa: ARG002 -- the screen goes on
        return False

    async def wait(self, seconds: float) -> bool:
        await asyncio.sleep(0)
        await asyncio.sleep(seconds)
        return False

    def print_soon(self) -> None:
        """The log shows every line at once."""

    def continue_on_enter(self, more: Callable[[], Coroutine[Any, Any, None]]) -> None:
        """Pages are windows here."""

    def setting_changed(self, key: str) -> None:
        self._work.apply_setting(key)

    def before_robot_changes(self) -> None:
        """The text is that robot's, if there is any."""
        if self._work.workplace.editor.text.strip():
            team = self._work.donnie.team
            team.give(team.chosen.name, RunRequest(self._work.workplace.editor.text, self._work.program_name))

    def robot_changed(self) -> None:
        self._work.run_view.robot_changed()

    async def type_again(self, line: str) -> None:
        again = self._work.typed(line)
        if again is not None:
            await asyncio.sleep(0)
            await again

    # --- ways out

    async def enter_world(self, name: str) -> None:
        self._work.change_world(name)

    async def switch_mode(self) -> None:
        self._work.switch_to_linear()

    async def quit(self) -> None:
        if await may_lose_all(self._work.ctx):
            self._work.leave()

    # --- what only a screen can do

    @property
    def map(self) -> MapPane:
        return self._work.workplace.map

    @property
    def log_text(self) -> str:
        return "".join(f"{line}\n" for line in self._work.workplace.log_rows.lines)

    def focus(self, pane: str) -> None:
        place = self._work.workplace
        panes = {"program": place.program_pane, "map": place.map_pane, "log": place.log_pane}
        if pane == "variables":
            place.toggle_inspector()
        else:
            place.go_to(panes[pane])

    async def complete(self) -> None:
        editor = self._work.workplace.editor
        editor.focus()
        found = self._work.while_typing.completion(editor.text, editor.offset_of_cursor)
        if not found.words:
            self._work.ctx.answer("screen-nothing-to-complete")
            return
        await asyncio.sleep(0)
        word, letter = await self._host.choose_word(found.words, editor.cursor_screen_offset)
        if word:
            editor.put_in_place_of(found.typed, word)
        elif letter:
            editor.insert(letter)

    def mark_mistakes(self) -> None:
        self._work.while_typing.check_now()

    def place_cursor(self, line: int, column: int) -> None:
        self._work.workplace.editor.go_to(line, column)

    def explore(self, change: Callable[[Pointer], object]) -> None:
        """With the focus on the map: the cursor is on what is said."""
        place = self._work.workplace
        if not place.map.has_focus:
            place.go_to(place.map_pane)
        place.map.explore(change)

    def show_sensor_ranges(self, lines: Iterable[Line]) -> None:
        self._work.display.show_fields(lines)

    def search_log(self, word: str) -> None:
        self._work.workplace.log_rows.search(word)

    def show_in_pager(self, text: str) -> None:
        self._work.pages.show_outside(text)

    def show_help(self) -> None:
        self._work.pages.show_help()

    def show_keys(self) -> None:
        self._work.pages.show_keys_here()

    def show_tour(self) -> None:
        self._work.pages.show_tour()

    def repaint(self) -> None:
        self._host.repaint()

    def robot_moved(self) -> None:
        self._work.run_view.robot_changed()

    def show_manual(self) -> None:
        self._work.pages.show_manual()

    @property
    def is_plain(self) -> bool:
        return self._work.workplace.is_plain

    @property
    def key_table(self) -> KeyTable:
        return self._host.key_table

    async def press_key(self, question: str, accepts: Callable[[str], str | None]) -> str | None:
        await asyncio.sleep(0)
        return await self._work.talk.press_key(question, accepts)
