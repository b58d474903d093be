"""What Tab may make of the last word that was typed: words of ours and of GoDonnie, variables, files."""

from __future__ import annotations

from pathlib import Path

import worlds
from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.lookup import find
from donnie_tui.core.map_words import compass_words
from donnie_tui.i18n.command_words import words_of
from donnie_tui.linear.desk import Desk
from language import keywords
from language.source import fold_name

MOST = 100
"""Words to choose from; nobody listens to more."""


def candidates(desk: Desk, before: str) -> tuple[str, ...]:
    """The words that the last one of ``before`` may become, as it was typed in small or capital letters."""
    blank, last = " " in before.lstrip(), before.rpartition(" ")[2]
    asked = find(before)
    if blank and asked is not None and asked[0].argument == "file":
        return _files(last)
    if not last:
        return ()
    known = [*keywords.all_words(desk.say.language), *desk.session.variables, *_arguments(desk, before)]
    if not blank:
        commands = (each for each in COMMANDS if not each.is_visual)
        known += [word for each in commands for word in words_of(each.name, desk.say.language)]
    folded = fold_name(last)
    found = sorted({_as_typed(each, last) for each in known if fold_name(each).startswith(folded)})
    return tuple(found[:MOST])


def _arguments(desk: Desk, before: str) -> tuple[str, ...]:
    """What may follow the word of the terminal with which the line begins, where these are few words."""
    found = find(before)
    argument = found[0].argument if found is not None else ""
    if argument == "compass":
        return compass_words(desk.say.language)
    if argument == "robot":
        return tuple(session.name for session in desk.donnie.team.sessions)
    return worlds.names() if argument == "world" else ()


def _as_typed(word: str, typed: str) -> str:
    return word.lower() if typed.islower() else word


def _files(typed: str) -> tuple[str, ...]:
    folder, _, name = typed.rpartition("/")
    try:
        found = sorted(Path(folder or ("/" if typed.startswith("/") else ".")).iterdir())
        names = [f"{each.name}/" if each.is_dir() else each.name for each in found]
    except OSError:
        return ()
    before = f"{folder}/" if "/" in typed else ""
    return tuple(
        before + each for each in names if each.startswith(name) and (name or not each.startswith("."))
    )[:MOST]
