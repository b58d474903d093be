"""The texts of the help, the tour, the keys and the palette, in the learner's language."""

from __future__ import annotations

from donnie_tui.commands.declarations import COMMANDS, Command
from donnie_tui.commands.interaction import Option
from donnie_tui.commands.keys import MENU, PALETTE, KeyTable, key_label
from donnie_tui.commands.lookup import help_line, word_of
from donnie_tui.core.wording import Wording
from donnie_tui.i18n.help import SCREEN_TOUR_PAGES, screen_tour_page
from donnie_tui.i18n.words import Words
from donnie_tui.tui.screens.main_screen import MainScreen
from donnie_tui.tui.screens.pages import TourPage
from language.keywords import canonical

_MOST_LINES = 9

_NEAR = {
    "program": ("run", "step", "break_", "complete", "fix", "search", "outline", "undo", "save"),
    "map": ("where", "around"),
    "variables": ("show_variables", "feel"),
    "log": ("open_log", "find", "save_log"),
    "command": ("typed", "run"),
}
"""The commands that are near at hand in each pane."""
_EVERYWHERE = ("stop", "keys_here", "help", "quit")


def help_lines(place: MainScreen, words: Words, table: KeyTable) -> tuple[str, ...]:
    """The word of GoDonnie at the cursor, the keys of the focused part, then everything."""
    word = place.editor.word if place.editor.has_focus else ""
    about = words.help(word) if word and canonical(word) is not None else ()
    return (*about, *keys_here(place, words, table), words("help-further"), *help_text(words, table))


def help_text(words: Wording, table: KeyTable) -> tuple[str, ...]:
    """Every command of the screen, the typed word first: it works everywhere; then those of GoDonnie."""
    return (
        words("help-screen-words"),
        *(help_line(each, words, table.labels(each.name, words.language)) for each in _offered(table)),
        words("help-palette"),
        words("help-program-words"),
        *_program_lines(words),
    )


def _program_lines(words: Wording) -> tuple[str, ...]:
    """GoDonnie's commands, but for those that the screen has listed."""
    listed = {word_of(each, words.language) for each in COMMANDS}
    return tuple(line for line in words.help(None) if line.partition(":")[0] not in listed)


def tour_pages(words: Words, table: KeyTable) -> tuple[TourPage, ...]:
    """The pages of the tour, with the key of each command as it is now; of one without a key its word."""
    language = words.language
    keys = {each.name: table.label(each.name, language) or word_of(each, language) for each in COMMANDS}
    keys |= {"menu": key_label(MENU, language), "palette": key_label(PALETTE, language)}
    return tuple(
        TourPage(
            words("screen-tour-title", page=page, pages=SCREEN_TOUR_PAGES),
            screen_tour_page(page, words, keys),
        )
        for page in range(1, SCREEN_TOUR_PAGES + 1)
    )


def keys_here(place: MainScreen, words: Words, table: KeyTable) -> tuple[str, ...]:
    """What can be pressed where the focus is: a heading, then a line each."""
    pane = _focused_part(place)
    codes = (f"here-{pane}-{number}" for number in range(1, _MOST_LINES + 1))
    of_pane = (words(code) for code in codes if words.knows(code))
    names = (*_NEAR[pane], *_EVERYWHERE)
    commands = (
        words("here-key", keys=table.labels(name, words.language), purpose=words(f"action-{name}"))
        for name in names
        if table.of(name)
    )
    return (words(f"here-{pane}"), *of_pane, *commands, words("here-tab"))


def _focused_part(place: MainScreen) -> str:
    """The pane of the focus; the program where there is none."""
    if place.map.has_focus:
        return "map"
    if place.inspector.has_focus:
        return "variables"
    if place.log_rows.has_focus:
        return "log"
    return "command" if place.command_line.has_focus else "program"


def palette(words: Wording, table: KeyTable) -> tuple[Option, ...]:
    """Every command, with its keys."""
    return tuple(Option(each.name, _palette_row(each, words, table)) for each in _offered(table))


def _offered(table: KeyTable) -> list[Command]:
    return [each for each in COMMANDS if table.offers(each.name)]


def _palette_row(command: Command, words: Wording, table: KeyTable) -> str:
    label = table.label(command.name, words.language)
    keys = f" ({label})" if label else ""
    return f"{word_of(command, words.language)}{keys}: {words(f'action-{command.name}')}"
