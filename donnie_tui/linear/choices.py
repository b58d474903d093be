"""The words about how Donnie works and what it says: SPEED, LANGUAGE, DETAIL, LAST, ERRORS, HELP."""

from __future__ import annotations

from donnie_tui.core import use_cases
from donnie_tui.core.speeds import speed_words
from donnie_tui.core.transcript import lines_of
from donnie_tui.core.use_cases import UseCase
from donnie_tui.linear.desk import Desk
from donnie_tui.settings import read_speed
from language.source import fold_name

_LANGUAGES = {
    "en": ("en", "english", "ingles"),
    "pt": ("pt", "pt-br", "portuguese", "portugues"),
    "es": ("es", "spanish", "espanhol", "espanol"),
}
_DETAILS = {
    "brief": ("brief", "short", "breve", "curto", "corto"),
    "normal": ("normal",),
    "full": ("full", "long", "completo", "cheio"),
}
_KEYS = ("keys", "teclas")
_KEY_LINES = ("enter", "run", "stop", "past", "line", "word", "clear", "leave")


def set_speed(desk: Desk, typed: str) -> bool:
    """Change the speed, where one is given, and say it. False if it is none."""
    if typed:
        try:
            desk.session.speed = read_speed(fold_name(typed))
        except ValueError:
            return False
    say_speed(desk)
    return True


def say_speed(desk: Desk) -> None:
    desk.answer("answer-speed", speed=speed_words(desk.session.speed, desk.say))


def set_language(desk: Desk, typed: str) -> bool:
    """Talk another language from now on. False if it is unknown."""
    language = _chosen(_LANGUAGES, typed)
    if typed and language is None:
        return False
    desk.say.language = language or desk.say.language
    desk.answer("linear-language")
    return True


def set_detail(desk: Desk, typed: str) -> bool:
    """Say more or less from now on. False if the level is unknown."""
    detail = _chosen(_DETAILS, typed)
    if typed and detail is None:
        return False
    desk.say.detail = detail or desk.say.detail
    desk.answer("linear-detail")
    return True


def say_again(desk: Desk, which: int) -> None:
    """The answer before this one, or the ``which``-th last."""
    if 1 <= which <= len(desk.answers):
        desk.is_repeating = True
        desk.tell(*desk.answers[-which])
    else:
        desk.answer("linear-nothing-said")


def say_errors(desk: Desk) -> None:
    """What was wrong with the last run."""
    if not desk.errors:
        desk.answer("linear-no-errors")
    for error in desk.errors:
        desk.tell(*lines_of(error, desk.say))


def say_help(desk: Desk, topic: str, own: tuple[UseCase, ...]) -> None:
    """The list, the keys, or one word. ``own``: the use cases to list."""
    folded = " ".join(fold_name(topic).split())
    asked = use_cases.find(topic)
    if not topic:
        _say_list(desk, own)
    elif folded in _KEYS:
        for line in _KEY_LINES:
            desk.answer(f"linear-keys-{line}")
    elif asked is not None and not asked[0].is_godonnie and not asked[1]:
        desk.tell(use_cases.help_line(asked[0], desk.say))
    else:
        desk.tell(*desk.say.help(topic))


def _say_list(desk: Desk, own: tuple[UseCase, ...]) -> None:
    """GoDonnie's words, then ours."""
    ours = [each for each in own if not each.is_godonnie]
    desk.tell(*desk.say.help(None))
    desk.answer("linear-help", count=len(ours))
    desk.tell(*(use_cases.help_line(each, desk.say) for each in ours))
    desk.answer("linear-help-keys")


def _chosen(table: dict[str, tuple[str, ...]], typed: str) -> str | None:
    folded = fold_name(typed)
    return next((name for name, spellings in table.items() if folded in spellings), None)
