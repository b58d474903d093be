"""What the actions about the screen itself do: the look, the layout, settings, the lists, the manual."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import worlds
from donnie_tui import sound_words
from donnie_tui.core import report_text
from donnie_tui.core.transcript import printable
from donnie_tui.core.typed_program import lines_of
from donnie_tui.settings import THEMES
from donnie_tui.tui.running import Answer
from donnie_tui.tui.screens.chooser import Choice
from language.source import fold_name

if TYPE_CHECKING:
    from donnie_tui.tui.host import WorkHost


class AroundDeeds:
    """One method an action. Those that ask something are coroutines."""

    def __init__(self, host: WorkHost) -> None:
        self._host = host

    async def theme(self, argument: str) -> None:
        await self._choose("theme", THEMES, argument)

    async def language(self, argument: str) -> None:
        await self._choose("lang", ("en", "pt", "es"), argument)

    async def detail(self, argument: str) -> None:
        await self._choose("verbosity", ("brief", "normal", "full"), argument)

    async def _choose(self, key: str, values: tuple[str, ...], typed: str) -> None:
        """One of a few values, typed in any language or chosen from a list."""
        words = self._host.words
        names = {value: words(f"value-{key}-{value}") for value in values}
        meant = {fold_name(each): value for value, name in names.items() for each in (value, name)}
        chosen = meant.get(fold_name(typed)) if typed else None
        if chosen is None:
            current = self._host.preferences.value(key)
            rows = [Choice(value, name, value == current) for value, name in names.items()]
            chosen = await self._host.choose(words(f"setting-{key}"), rows)
        if chosen is not None:
            self._host.prefer(key, chosen)

    def plain(self, _argument: str) -> None:
        self._host.prefer("plain", not self._host.workplace.is_plain)

    async def settings(self, _argument: str) -> None:
        """One setting after the other, until somebody goes back."""
        words = self._host.words
        chosen: str | None = ""
        while chosen is not None:
            rows = [
                Choice(
                    each.key, words("setting-row", name=words(f"setting-{each.key}"), value=each.told(words))
                )
                for each in self._host.preferences.all
            ]
            at = next((index for index, row in enumerate(rows) if row.value == chosen), 0)
            rows[at] = Choice(rows[at].value, rows[at].text, True)
            chosen = await self._host.choose(words("settings-title"), rows)
            if chosen is not None:
                await self._change(chosen)

    async def set(self, argument: str) -> None:
        """SET alone lists the settings, SET name asks for one, SET name value changes it."""
        name, _blank, value = argument.strip().partition(" ")
        key = self._setting(name)
        if not name:
            await self.settings("")
        elif key is None:
            self._host.tell(Answer("screen-no-setting", {"name": printable(name[:40])}))
        elif self._host.preferences.values(key):
            await self._choose(key, self._host.preferences.values(key), value.strip())
        elif value:
            self._host.prefer(key, value.strip())
        else:
            await self._change(key)

    def _setting(self, name: str) -> str | None:
        """The setting that a word means: its name in the settings file, in the list, or as SET has it."""
        words, folded = self._host.words, fold_name(name)
        keys = [each.key for each in self._host.preferences.all]
        by_name = {fold_name(each): key for key in keys for each in (key, words(f"setting-{key}"))}
        found = by_name.get(folded) or sound_words.find_setting(name)
        return found if found in keys else None

    async def _change(self, key: str) -> None:
        values = self._host.preferences.values(key)
        if values:
            await self._choose(key, values, "")
            return
        words, preferences = self._host.words, self._host.preferences

        def wrong(typed: str) -> str | None:
            return None if preferences.understands(key, typed) else words(f"setting-{key}-wanted")

        asked = words(f"setting-{key}-wanted")
        typed = await self._host.ask(asked, value=str(preferences.value(key) or ""), accepts=wrong)
        if typed is not None:
            self._host.prefer(key, typed)

    async def manual(self, argument: str) -> None:
        """The language, chapter by chapter; with a word, what is said of it."""
        if argument:
            self._host.show_lines(argument, self._host.words.help(argument))
        else:
            self._host.show_manual()

    async def recent(self, _argument: str) -> None:
        paths = self._host.files.recent
        if not paths:
            self._host.tell(Answer("screen-no-recent"))
            return
        rows = [Choice(str(path), f"{path.name}, {path.parent}") for path in paths]
        chosen = await self._host.choose(self._host.words("ask-recent"), rows)
        if chosen:
            await self._host.files.open(chosen)

    async def programs(self, _argument: str) -> None:
        """The open programs; another one may be begun without closing any."""
        files, words = self._host.files, self._host.words
        rows = [
            Choice(str(at), name, is_current) for at, (name, is_current) in enumerate(files.open_programs)
        ]
        rows.append(Choice("new", words("another-program")))
        chosen = await self._host.choose(words("ask-programs"), rows)
        if chosen is not None:
            files.turn_to(None if chosen == "new" else int(chosen))

    async def worlds(self, _argument: str) -> None:
        """The worlds that ship, with what their authors say of them."""
        words = self._host.words
        rows = [
            Choice(name, words("world-row", name=name, title=about.title, about=about.description), is_here)
            for name in worlds.names()
            for about, is_here in ((worlds.about(name, words.language), name == self._host.world_name),)
        ]
        chosen = await self._host.choose(words("ask-worlds"), rows)
        is_elsewhere = chosen is not None and chosen != self._host.world_name
        if chosen and is_elsewhere and await self._host.files.are_safe_to_leave():
            self._host.change_world(chosen)

    async def report(self, argument: str) -> None:
        """REPORT map map.html; with .csv a table."""
        wanted = report_text.asked(argument)
        if wanted is None:
            self._host.tell(Answer("action-report"))
            return
        host, words = self._host, self._host.words
        lines = tuple(lines_of(host.workplace.editor.text))
        subject = report_text.Subject(
            lines, host.pose, host.donnie.picture_now(), host.trail, words.help(None)[1:]
        )
        await host.files.write_beside(wanted[1], report_text.report(*wanted, subject, words))

    def tour(self, _argument: str) -> None:
        self._host.show_tour()

    def open_log(self, _argument: str) -> None:
        self._host.open_log()

    async def save_log(self, argument: str) -> None:
        name = argument or await self._host.ask(self._host.words("ask-save-log"), value="log.txt")
        if name and await self._host.files.may_replace(Path(name)):
            self._host.save_log(name)
