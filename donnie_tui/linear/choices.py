"""The words about how Donnie works and what it says: LANGUAGE, DETAIL, SET, HELP."""

from __future__ import annotations

import os

from donnie_tui import LANGUAGES
from donnie_tui.core import use_cases
from donnie_tui.core.documents import DocumentError
from donnie_tui.core.typed_words import detail_named, language_named
from donnie_tui.core.use_cases import UseCase
from donnie_tui.core.view_cases import PREFERENCES
from donnie_tui.linear import habits
from donnie_tui.linear.arguments import Handler
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.runs import Runs
from donnie_tui.settings.file import remember
from donnie_tui.words import sound_words
from language import keywords
from language.source import fold_name

_KEYS = ("keys", "teclas")
_KEY_LINES = ("enter", "run", "stop", "past", "line", "word", "clear", "tab", "leave")


def _language(desk: Desk, _: Runs, typed: str) -> bool:
    """Talk another language from now on, and the next time."""
    language = language_named(typed)
    if typed and language is None:
        return False
    desk.say.language = language or desk.say.language
    if language is not None and desk.is_attended:
        _keep(desk, "lang", language)
    desk.answer("linear-language")
    return True


def _detail(desk: Desk, _: Runs, typed: str) -> bool:
    """Say more or less from now on, and the next time."""
    detail = detail_named(typed)
    if typed and detail is None:
        return False
    desk.say.detail = detail or desk.say.detail
    if detail is not None and desk.is_attended:
        _keep(desk, "verbosity", detail)
    desk.answer("linear-detail")
    return True


def _keep(desk: Desk, key: str, value: str | bool | float) -> None:
    """For the next time too."""
    try:
        remember(key, value, os.environ)
    except DocumentError as error:
        desk.answer(error.code, path=error.path, reason=error.reason)


# --- habits


def _set(desk: Desk, _: Runs, rest: str) -> bool:
    """SET alone says all, SET name one with its choices, SET name value changes it.

    What somebody chooses at a prompt is kept; typed lines of a file choose for themselves.
    """
    name, _blank, value = rest.partition(" ")
    if not name:
        for each in habits.SPELLINGS:
            _say_habit(desk, each)
        sound_words.tell_settings(desk.donnie)
        return True
    sound = sound_words.find_setting(name)
    if sound is not None:
        sound_words.set_sound(desk.donnie, sound, value.strip(), keeps=desk.is_attended)
        return True
    field = habits.find(name)
    if field is None and fold_name(name) in PREFERENCES:
        point_to(desk, PREFERENCES[fold_name(name)])
        return True
    if field is None:
        return False
    return _change(desk, field, value.strip()) if value else _say_choices(desk, field)


def point_to(desk: Desk, name: str | None) -> None:
    """What is typed here for something of the full screen; where there is nothing, where it is."""
    case = use_cases.BY_NAME.get(name or "")
    if case:
        desk.answer("linear-in-words", word=use_cases.typed_form(case, desk.say))
    elif name:
        desk.answer("linear-in-words", word=keywords.spelling(name, desk.say.language))
    else:
        desk.answer("linear-on-screen")


def _change(desk: Desk, field: str, typed: str) -> bool:
    try:
        value = habits.read(field, typed)
    except ValueError:
        return _say_choices(desk, field)
    setattr(desk.ends.habits, field, value)
    desk.ends.apply_habits()
    if desk.is_attended:
        _keep(desk, field, habits.kept_as(field, value))
    _say_habit(desk, field)
    return True


def _say_habit(desk: Desk, field: str) -> None:
    at, value = LANGUAGES.index(desk.say.language), getattr(desk.ends.habits, field)
    name = habits.SPELLINGS[field][0][at]
    if field != "progress":
        desk.answer(f"habit-{field}", name=name, value=habits.spelled(field, value, at))
    else:
        desk.answer("habit-progress" if value else "habit-progress-never", name=name, value=value)


def _say_choices(desk: Desk, field: str) -> bool:
    _say_habit(desk, field)
    desk.answer("habit-choices", choices=habits.choices(field, LANGUAGES.index(desk.say.language)))
    return True


# --- help


def say_help(desk: Desk, topic: str, own: tuple[UseCase, ...]) -> None:
    """The list, the keys, or one word. ``own``: the use cases to list."""
    folded = " ".join(fold_name(topic).split())
    asked = use_cases.find(topic)
    if not topic:
        _say_list(desk, own)
    elif folded in _KEYS:
        for line in _KEY_LINES:
            desk.answer(f"linear-keys-{line}")
    elif asked is not None and asked[0].name == "set" and _tell_setting(desk, asked[1].split(" ")[0]):
        pass
    else:
        desk.tell(*(use_cases.help_of(topic, desk.say) or desk.say.help(topic)))


def _tell_setting(desk: Desk, name: str) -> bool:
    """One setting with its choices; whether there is one of that name."""
    field, sound = habits.find(name), sound_words.find_setting(name)
    if field is not None:
        return _say_choices(desk, field)
    if sound is not None:
        sound_words.set_sound(desk.donnie, sound, "")
    return sound is not None


def _say_list(desk: Desk, own: tuple[UseCase, ...]) -> None:
    """GoDonnie's words, then ours."""
    ours = [each for each in own if not each.is_godonnie]
    desk.tell(*desk.say.help(None))
    desk.answer("linear-help", count=len(ours))
    desk.tell(*(use_cases.help_line(each, desk.say) for each in ours))
    desk.answer("linear-help-keys")


HANDLERS: dict[str, Handler] = {
    "language": _language,
    "detail": _detail,
    "set": _set,
}
