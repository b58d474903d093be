"""LANGUAGE, DETAIL, SET, THEME, PLAIN, CHANGE KEYS, REDRAW: changes of settings, which apply at once.

A change at a prompt or on the screen is kept in the settings file; a change by a script is not.
"""

from __future__ import annotations

from devices.ports.audio import CUES
from donnie_tui.commands.context import Context
from donnie_tui.commands.declarations import BY_NAME, COMMANDS
from donnie_tui.commands.dispatch import handles
from donnie_tui.commands.interaction import Option
from donnie_tui.commands.lookup import word_of
from donnie_tui.commands.preferences import BY_NAME as BY_KEY
from donnie_tui.commands.preferences import (
    PREFERENCES,
    Preference,
    Where,
    find_preference,
    label,
    setting_word,
    value_label,
    value_typed,
    values_in_words,
)
from donnie_tui.commands.sound import LOUD, chime, cue_meant, cue_volume_typed, cue_word
from donnie_tui.core.wording import spelled
from language.source import quoted
from language.suggestions import nearest

VOLUMES = (100, 75, 50, 25, 0)
"""Volumes of a cue to choose from; others can be typed: SET cue bump 60."""
_AS_BEFORE = ""
"""The row that restores the default keys of all commands."""


@handles("language", key="lang")
@handles("detail", key="verbosity")
@handles("theme", key="theme")
async def choose(ctx: Context, argument: str, key: str) -> None:
    """Set the typed value, or offer the values; without a list, say the current one."""
    preference = BY_KEY[key]
    if not argument:
        await _choose_from_list(ctx, preference)
        return
    _change_to_typed(ctx, preference, argument)


def _change_to_typed(ctx: Context, preference: Preference, typed: str) -> None:
    """Apply a typed value, or say which are possible."""
    value = value_typed(preference, typed, ctx.words)
    if value is None:
        ctx.refuse()
        say_with_values(ctx, preference)
    else:
        change(ctx, preference.key, value)


@handles("plain")
async def plain(ctx: Context, _: str) -> None:
    """Switch between the plain layout, one column without decoration, and the panes."""
    assert ctx.screen is not None
    change(ctx, "plain", "off" if ctx.screen.is_plain else "on")


@handles("redraw")
async def redraw(ctx: Context, _: str) -> None:
    """Paint the screen again."""
    assert ctx.screen is not None
    ctx.screen.repaint()
    ctx.answer("screen-redrawn")


# --- SET


@handles("set")
async def set_value(ctx: Context, argument: str) -> None:
    """SET lists the settings, SET name says one with its values, SET name value changes it."""
    name, _, typed = argument.partition(" ")
    if not name:
        await _list(ctx)
        return
    preference = find_preference(name, ctx.words)
    if preference is None:
        ctx.refuse()
        near = nearest(name, [setting_word(each.key, ctx.words) for each in PREFERENCES])
        if near is None:
            ctx.answer("screen-no-setting", name=quoted(name))
        else:
            ctx.answer("help-unknown-near", topic=quoted(name), near=near)
    elif preference.where is (Where.LINEAR if ctx.screen is not None else Where.SCREEN):
        ctx.answer(_only_in_other_mode(ctx))
    elif preference.key == "cues":
        await _set_cue(ctx, typed.strip())
    elif typed.strip():
        _change_to_typed(ctx, preference, typed.strip())
    else:
        await _ask_for_value(ctx, preference)


def _only_in_other_mode(ctx: Context) -> str:
    if ctx.screen is None:
        return "only-on-screen"
    return "page-no-linear" if ctx.screen.is_page else "only-in-linear-mode"


async def _list(ctx: Context) -> None:
    """Offer the settings, until the learner goes back; without a list, say all of them."""
    words = ctx.words
    printed = [
        ctx.preferences.in_words(each.key, words)
        for each in PREFERENCES
        if each.has_words and each.where is not Where.SCREEN
    ]
    if ctx.screen is None:
        ctx.say(*printed)
        return
    chosen: str | None = ""
    while chosen is not None:
        rows = [
            Option(each.key, _row(ctx, each), each.key == chosen, columns=_columns(ctx, each))
            for each in PREFERENCES
            if words.knows(f"setting-{each.key}")
        ]
        chosen = await ctx.interaction.choose(words("settings-title"), rows)
        if chosen == "cues":
            await _choose_cues(ctx)
        elif chosen == "keys":
            await change_keys(ctx, "")
        elif chosen is not None:
            await _ask_for_value(ctx, BY_KEY[chosen])


def _row(ctx: Context, preference: Preference) -> str:
    key, words = preference.key, ctx.words
    return words("setting-row", name=label(key, words), value=ctx.preferences.value_label(key, words))


def _columns(ctx: Context, preference: Preference) -> tuple[str, str, str]:
    """Name, value and purpose."""
    key, words = preference.key, ctx.words
    return label(key, words), ctx.preferences.value_label(key, words), words(f"about-setting-{key}")


async def _ask_for_value(ctx: Context, preference: Preference) -> None:
    """Ask for a value, from a list or typed; without a screen, say the valid values."""
    key, words = preference.key, ctx.words
    if preference.values or ctx.screen is None:
        await _choose_from_list(ctx, preference)
        return

    def problem(typed: str) -> str | None:
        return words(f"setting-{key}-wanted") if value_typed(preference, typed, words) is None else None

    text = ctx.preferences.value(key)
    typed = await ctx.interaction.ask(words(f"setting-{key}-wanted"), text, problem)
    if typed is not None:
        change(ctx, key, typed)


async def _choose_from_list(ctx: Context, preference: Preference) -> None:
    key, words, current = preference.key, ctx.words, ctx.preferences.value(preference.key)
    options = [
        Option(value, value_label(preference, value, words), value == current) for value in preference.values
    ]
    printed = [ctx.preferences.in_words(key, words)]
    if preference.has_words:
        printed.append(values_in_words(preference, words))
    chosen = await ctx.interaction.choose(label(key, words), options, printed)
    if chosen is not None:
        change(ctx, key, chosen)


def say_with_values(ctx: Context, preference: Preference) -> None:
    """Say the setting and its valid values."""
    ctx.say(ctx.preferences.in_words(preference.key, ctx.words), values_in_words(preference, ctx.words))


def change(ctx: Context, key: str, value: str) -> None:
    """Apply a value, say it, and keep it. ``value`` is as the settings file writes it."""
    preferences = ctx.preferences
    preferences.choose(key, value)
    chosen = preferences.settings
    if key == "lang":
        ctx.words.language = chosen.language
    elif key == "verbosity":
        ctx.words.detail = chosen.verbosity
    elif key == "speed":
        ctx.donnie.session.speed = chosen.speed
    elif BY_KEY[key].is_audible:
        ctx.donnie.outlets.adjust_sound(**{key: getattr(chosen, key)})
    ctx.interaction.setting_changed(key)
    if key != "cues":
        ctx.say(preferences.in_words(key, ctx.words))
    if key in ("speech", "speak", "sound"):
        ctx.say(*ctx.donnie.outlets.audible.notices)
    if ctx.interaction.is_attended:
        preferences.keep(key)


# --- cues


async def _set_cue(ctx: Context, argument: str) -> None:
    """``bump 50``, ``bump off``: set a volume. Say the volume of a cue alone, or of all."""
    word, _, typed = argument.partition(" ")
    cue = cue_meant(word) if word else None
    if word and cue is None:
        ctx.refuse()
        ctx.answer("cues-unknown", name=quoted(word))
    elif cue is None:
        await _choose_cues(ctx)
    elif not typed:
        await _choose_volume(ctx, cue)
    else:
        volume = cue_volume_typed(typed)
        if volume is not None:
            _change_cue(ctx, cue, volume)
        else:
            ctx.say(_cue_in_words(ctx, cue), values_in_words(BY_KEY["volume"], ctx.words))


async def _choose_cues(ctx: Context) -> None:
    """Offer the cues, until the learner goes back."""
    chosen: str | None = ""
    while chosen is not None:
        rows = [Option(cue, _cue_row(ctx, cue, _volume(ctx, cue)), cue == chosen) for cue in CUES]
        printed = [_cue_in_words(ctx, cue) for cue in CUES]
        chosen = await ctx.interaction.choose(ctx.words("setting-cues"), rows, printed)
        if chosen is not None:
            await _choose_volume(ctx, chosen)


async def _choose_volume(ctx: Context, cue: str) -> None:
    rows = [Option(str(each), _cue_row(ctx, cue, each), each == _volume(ctx, cue)) for each in VOLUMES]
    chosen = await ctx.interaction.choose(ctx.words("setting-cues"), rows, [_cue_in_words(ctx, cue)])
    if chosen is not None:
        _change_cue(ctx, cue, int(chosen))


def _volume(ctx: Context, cue: str) -> int:
    return ctx.preferences.settings.cues.get(cue, LOUD)


def _cue_row(ctx: Context, cue: str, percent: int) -> str:
    words = ctx.words
    volume = words("cue-volume", percent=percent) if percent else words("cue-volume-off")
    meaning = words(f"cue-{cue}").rstrip(".")
    return words("cue-row", name=cue_word(cue, words.language), meaning=meaning, volume=volume)


def _cue_in_words(ctx: Context, cue: str) -> str:
    language, percent = ctx.words.language, _volume(ctx, cue)
    value = str(percent) if percent else spelled("off", language, "switch")
    name = spelled("cue", language, "settings")
    return ctx.words("sound-setting-cue", name=name, cue=cue_word(cue, language), value=value)


def _change_cue(ctx: Context, cue: str, percent: int) -> None:
    """Change the volume of a cue, and play the cue once."""
    volumes = {**ctx.preferences.settings.cues, cue: percent}
    change(ctx, "cues", ", ".join(f"{name} {each}" for name, each in volumes.items()))
    chime(ctx.donnie, cue)
    ctx.say(_cue_in_words(ctx, cue))


# --- keys


@handles("change_keys")
async def change_keys(ctx: Context, _: str) -> None:
    """Offer the commands, to change their keys, until the learner goes back."""
    assert ctx.screen is not None
    words, chosen, offers = ctx.words, _AS_BEFORE, ctx.screen.key_table.offers
    names = [each.name for each in COMMANDS if offers(each.name)]
    while True:
        rows = [Option(each, _key_row(ctx, each), each == chosen) for each in names]
        has_choices = bool(ctx.preferences.settings.keys)
        first = [Option(_AS_BEFORE, words("keys-as-before"))] if has_choices else []
        answer = await ctx.interaction.choose(words("keys-title"), [*first, *rows])
        if answer is None:
            return
        chosen = answer
        if chosen == _AS_BEFORE:
            change(ctx, "keys", "")
        else:
            await _change_key(ctx, chosen)


def _key_row(ctx: Context, name: str) -> str:
    assert ctx.screen is not None
    words = ctx.words
    keys = ctx.screen.key_table.labels(name, words.language) or words("keys-none")
    word = word_of(BY_NAME[name], words.language)
    return words("keys-row", word=word, keys=keys, purpose=words(f"action-{name}"))


async def _change_key(ctx: Context, name: str) -> None:
    from donnie_tui.commands.keys import is_free_to_give, key_label, with_key

    assert ctx.screen is not None
    words = ctx.words

    def problem(key: str) -> str | None:
        return None if is_free_to_give(key) else words("keys-not-this", key=key_label(key, words.language))

    question = words("keys-ask", word=word_of(BY_NAME[name], words.language))
    key = await ctx.screen.press_key(question, problem)
    if key is None:
        return
    before = ctx.screen.key_table.command_of(key) if key else None
    change(ctx, "keys", with_key(ctx.preferences.settings.keys, name, key or None))
    for each in (name, *((before,) if before not in (None, name) else ())):
        ctx.answer("keys-now", row=_key_row(ctx, str(each)).partition(".")[0])
