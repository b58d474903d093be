"""What the actions around the program do: lists of programs and worlds, reports, the log, the manual."""

from __future__ import annotations

from typing import TYPE_CHECKING

import worlds
from donnie_tui.core import report_text
from donnie_tui.core.world_words import world_row
from donnie_tui.tui.running import Answer
from donnie_tui.tui.screens.chooser import Choice
from donnie_tui.words import world_going
from language.source import lines_in

if TYPE_CHECKING:
    from donnie_tui.tui.host import WorkHost


class AroundDeeds:
    """One method an action. Those that ask something are coroutines."""

    def __init__(self, host: WorkHost) -> None:
        self._host = host

    async def manual(self, argument: str) -> None:
        """The language, chapter by chapter; with a word, what is said of it."""
        if argument:
            self._host.pages.show_lines(argument, self._host.words.help(argument))
        else:
            self._host.pages.show_manual()

    async def recent(self, _argument: str) -> None:
        paths = self._host.files.recent
        if not paths:
            self._host.talk.tell(Answer("screen-no-recent"))
            return
        rows = [Choice(str(path), f"{path.name}, {path.parent}") for path in paths]
        chosen = await self._host.talk.choose(self._host.words("ask-recent"), rows)
        if chosen:
            await self._host.files.open(chosen)

    async def programs(self, _argument: str) -> None:
        """The open programs; another one may be begun without closing any."""
        files, words = self._host.files, self._host.words
        rows = [
            Choice(str(at), name, is_current) for at, (name, is_current) in enumerate(files.open_programs)
        ]
        rows.append(Choice("new", words("another-program")))
        chosen = await self._host.talk.choose(words("ask-programs"), rows)
        if chosen is not None:
            files.turn_to(None if chosen == "new" else int(chosen))

    async def worlds(self, argument: str) -> None:
        """The worlds that ship, with what their authors say, and what to try there; or one by name."""
        if argument:
            await go_to_world(self._host, argument)
            return
        words, donnie = self._host.words, self._host.donnie
        if not world_going.may_leave_world(donnie):
            return
        rows = [Choice(name, world_row(name, words), name == donnie.world.name) for name in worlds.names()]
        chosen = await self._host.talk.choose(words("ask-worlds"), rows)
        if chosen:
            await go_to_world(self._host, chosen)

    async def report(self, argument: str) -> bool:
        """REPORT map map.html; with .csv a table."""
        from donnie_tui.i18n.manual import sections

        wanted = report_text.asked(argument)
        if wanted is None:
            return False
        host, words = self._host, self._host.words
        lines = tuple(lines_in(host.workplace.editor.text))
        subject = report_text.Subject(
            lines,
            host.pose,
            host.donnie.picture_now(),
            host.trail,
            words.help(None)[1:],
            sections(words),
        )
        await host.files.saving.write_beside(wanted[1], report_text.report(*wanted, subject, words))
        return True

    def tour(self, _argument: str) -> None:
        self._host.pages.show_tour()

    def open_log(self, _argument: str) -> None:
        """In the pager: there the terminal's own ways of reading work."""
        self._host.pages.show_outside(self._log_text)

    async def save_log(self, argument: str) -> None:
        """All that was told, as plain text."""
        name = argument or await self._host.talk.ask(self._host.words("ask-save-log"), value="log.txt")
        if name:
            await self._host.files.saving.write_beside(report_text.with_suffix(name, ".txt"), self._log_text)
        else:
            self._host.talk.tell(Answer("answer-unchanged"))

    @property
    def _log_text(self) -> str:
        return "".join(f"{line}\n" for line in self._host.workplace.log_rows.lines)


async def go_to_world(host: WorkHost, typed: str) -> None:
    """With the same program, once nothing is lost by it; a file of one's own may take long to be read."""
    donnie, slow = host.donnie, Answer("slow-world", {"name": typed[:40]})
    name = await host.talk.patiently(lambda: world_going.world_to_go_to(donnie, typed), slow)
    if name is not None and await host.files.are_safe_to_leave():
        host.change_world(name)
