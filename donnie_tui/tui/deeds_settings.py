"""What the actions about settings do: the look, the language, voice and sounds, which key does what.

Each choice counts at once and is kept.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from donnie_tui import LANGUAGES
from donnie_tui.core.harmless import printable
from donnie_tui.core.typed_words import detail_named, language_named, switched
from donnie_tui.settings.keys import THEMES
from donnie_tui.tui.actions import ACTIONS, BY_NAME
from donnie_tui.tui.key_table import is_free_to_give, with_choice
from donnie_tui.tui.keys import key_label
from donnie_tui.tui.running import Answer
from donnie_tui.tui.screens.chooser import Choice
from donnie_tui.words import sound_words
from language.source import fold_name

if TYPE_CHECKING:
    from donnie_tui.tui.host import WorkHost

_LOUD = 100
_VOLUMES = (100, 75, 50, 25, 0)
"""Of a sound, to choose from; any other can be typed: SET cue bump 60."""
_NAMED = {"lang": language_named, "verbosity": detail_named}
"""Settings whose words are those of the linear mode."""
_AS_BEFORE = ""
"""Of the list of keys: all as they came."""


class SettingsDeeds:
    """One method an action. Those that ask something are coroutines."""

    def __init__(self, host: WorkHost) -> None:
        self._host = host

    async def theme(self, argument: str) -> None:
        await self._choose("theme", THEMES, argument)

    async def language(self, argument: str) -> None:
        await self._choose("lang", LANGUAGES, argument)

    async def detail(self, argument: str) -> None:
        await self._choose("verbosity", ("brief", "normal", "full"), argument)

    async def _choose(self, key: str, values: tuple[str, ...], typed: str) -> None:
        """One of a few values, typed in any language or chosen from a list."""
        words = self._host.words
        names = {value: words(f"value-{key}-{value}") for value in values}
        chosen = _typed_value(key, names, typed)
        if chosen is None:
            current = self._host.preferences.value(key)
            rows = [Choice(value, name, value == current) for value, name in names.items()]
            chosen = await self._host.talk.choose(words(f"setting-{key}"), rows)
        if chosen is not None:
            self._host.prefer(key, chosen)

    def plain(self, _argument: str) -> None:
        self._host.prefer("plain", not self._host.workplace.is_plain)

    def redraw(self, _argument: str) -> None:
        self._host.repaint()
        self._host.talk.tell(Answer("screen-redrawn"))

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
            chosen = await self._host.talk.choose(words("settings-title"), rows)
            if chosen is not None:
                await self._change(chosen)

    async def set(self, argument: str) -> None:
        """SET alone lists the settings, SET name asks for one, SET name value changes it."""
        name, _blank, value = argument.strip().partition(" ")
        key = self._setting(name)
        if not name:
            await self.settings("")
        elif key is None:
            self._host.talk.tell(Answer("screen-no-setting", {"name": printable(name[:40])}))
        elif key == "cues":
            await self._set_cue_typed(value.strip())
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
        if key == "cues":
            await self._choose_cues()
            return
        if key == "keys":
            await self.change_keys("")
            return
        values = self._host.preferences.values(key)
        if values:
            await self._choose(key, values, "")
            return
        words, preferences = self._host.words, self._host.preferences

        def wrong(typed: str) -> str | None:
            return None if preferences.understands(key, typed) else words(f"setting-{key}-wanted")

        asked = words(f"setting-{key}-wanted")
        typed = await self._host.talk.ask(asked, value=str(preferences.value(key) or ""), accepts=wrong)
        if typed is not None:
            self._host.prefer(key, typed)

    # --- sounds

    @property
    def _at(self) -> int:
        return LANGUAGES.index(self._host.words.language)

    async def _choose_cues(self) -> None:
        """One sound after the other, until somebody goes back."""
        chosen: str | None = ""
        while chosen is not None:
            rows = [
                Choice(each, self._cue_row(each, self._volume(each)), each == chosen)
                for each in sound_words.CUE_WORDS
            ]
            chosen = await self._host.talk.choose(self._host.words("setting-cues"), rows)
            if chosen is not None:
                await self._choose_volume(chosen)

    def _volume(self, cue: str) -> int:
        return self._host.donnie.outlets.audible.settings.cues.get(cue, _LOUD)

    def _cue_row(self, cue: str, percent: int) -> str:
        words = self._host.words
        volume = words("cue-volume", percent=percent) if percent else words("cue-volume-off")
        name = sound_words.cue_name(cue, self._at)
        return words("cue-row", name=name, meaning=words(f"cue-{cue}").rstrip("."), volume=volume)

    async def _choose_volume(self, cue: str) -> None:
        rows = [Choice(str(each), self._cue_row(cue, each), each == self._volume(cue)) for each in _VOLUMES]
        chosen = await self._host.talk.choose(self._host.words("setting-cues"), rows)
        if chosen is not None:
            self._set_cue(cue, int(chosen))

    def _set_cue(self, cue: str, percent: int) -> None:
        """From now on, and heard at once."""
        volumes: Mapping[str, int] = {**self._host.donnie.outlets.audible.settings.cues, cue: percent}
        self._host.prefer("cues", ", ".join(f"{name} {each}" for name, each in volumes.items()))
        sound_words.chime(self._host.donnie, cue)

    async def _set_cue_typed(self, typed: str) -> None:
        """``bump 50``, ``bump off``; a sound alone asks for its volume, nothing lists all."""
        word, _blank, value = typed.partition(" ")
        cue, volume = sound_words.find_cue(word), sound_words.read_cue_volume(value)
        if not word:
            await self._choose_cues()
        elif cue is None:
            self._host.talk.tell(Answer("cues-unknown", {"name": printable(word[:40])}))
        elif volume is None:
            await self._choose_volume(cue)
        else:
            self._set_cue(cue, volume)

    # --- keys

    async def change_keys(self, _argument: str) -> None:
        """One action after the other gets another key, until somebody goes back."""
        words, chosen = self._host.words, _AS_BEFORE
        while True:
            rows = [
                Choice(each.name, self._key_row(each.name), each.name == chosen) for each in self._givable
            ]
            first = [Choice(_AS_BEFORE, words("keys-as-before"))] if self._chosen_keys else []
            answer = await self._host.talk.choose(words("keys-title"), [*first, *rows])
            if answer is None:
                return
            chosen = answer
            if chosen == _AS_BEFORE:
                self._host.prefer("keys", "")
            else:
                await self._change_key(chosen)

    _givable = tuple(each for each in ACTIONS if not each.hidden)

    @property
    def _chosen_keys(self) -> str:
        return self._host.preferences.settings.keys

    def _key_row(self, name: str) -> str:
        words, word = self._host.words, BY_NAME[name].word(self._host.words.language)
        keys = self._host.key_table.labels(name, words.language) or words("keys-none")
        return words("keys-row", word=word, keys=keys, purpose=words(f"action-{name}"))

    async def _change_key(self, name: str) -> None:
        words, word = self._host.words, BY_NAME[name].word(self._host.words.language)

        def wrong(key: str) -> str | None:
            return (
                None if is_free_to_give(key) else words("keys-not-this", key=key_label(key, words.language))
            )

        key = await self._host.talk.press_key(words("keys-ask", word=word), wrong)
        if key is None:
            return
        before = self._host.key_table.action_of(key) if key else None
        self._host.prefer("keys", with_choice(self._chosen_keys, name, key or None))
        self._host.talk.tell(Answer("keys-now", {"row": self._key_row(name).partition(".")[0]}))
        if before not in (None, name):
            self._host.talk.tell(Answer("keys-now", {"row": self._key_row(str(before)).partition(".")[0]}))


def _typed_value(key: str, names: Mapping[str, str], typed: str) -> object:
    """The value that a word of the linear mode means, in any language, or one that is listed so."""
    if key in _NAMED:
        return _NAMED[key](typed)
    spoken = sound_words.read_setting(key, typed) if key in sound_words.SETTINGS else None
    return _meant(names, typed) if spoken is None else spoken


def _meant(names: Mapping[str, str], typed: str) -> str | None:
    """The value that is typed, by itself, by its name, or by any word for on and off where it has these."""
    is_on = switched(typed)
    if is_on is not None and set(names) == {"on", "off"}:
        return "on" if is_on else "off"
    folded = fold_name(typed)
    return next((value for value, name in names.items() if folded in map(fold_name, (value, name))), None)
