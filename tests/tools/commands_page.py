"""Writes ``docs/commands.md`` and the words of ``docs/language.md`` from the declarations.

Run it with ``python -m tests.tools.commands_page``.

It prints which keys are free after Ctrl+K, for a new command.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from enum import Enum
from pathlib import Path
from string import ascii_lowercase, digits

from donnie_tui.commands.declarations import COMMANDS, Command, When
from donnie_tui.commands.keys import KEYS, MENU, SIGNS, key_label
from donnie_tui.commands.lookup import help_of, typed_form, word_of, words_of
from donnie_tui.core.wording import name_of_language
from donnie_tui.i18n.help import ENTRIES, forms
from donnie_tui.i18n.words import Words
from language.keywords import ARGUMENTS
from language.locales import ENGLISH, languages

FILE = Path("docs/commands.md")
LANGUAGE_FILE = Path("docs/language.md")

_TITLES = {
    "run": "Running a program",
    "files": "Files",
    "program": "The lines of the program, and its text",
    "read": "Reading the program, its mistakes, and what was said and typed",
    "sound": "Sound and belt",
    "world": "The robot's surroundings, the map, and other worlds",
    "build": "Furnishing a world",
    "robots": "The robots",
    "settings": "Settings",
    "challenges": "Challenges",
    "help": "Help, and the ways out",
}
"""The sections, by the modules of the handlers."""
_WHEN = {
    When.IDLE: " While no program runs.",
    When.HELD: " Also while a program is held.",
    When.ALWAYS: "",
}


def document() -> str:
    """The text of the page."""
    lines = [
        "# Commands",
        "",
        "What a learner can type besides GoDonnie, in the linear mode and in the command line of the full",
        "screen, with its keys there. It can be typed at any time where nothing else is said. While a",
        "program runs, the linear mode carries out only those at once that say so, and CONTINUE after",
        "PAUSE; other lines wait until the program ends or is held. The page is made by",
        "`python -m tests.tools.commands_page`.",
    ]
    words = Words(ENGLISH)
    for module, title in _TITLES.items():
        lines += ["", f"## {title}", ""]
        for command in (each for each in COMMANDS if each.module == module):
            lines += entry(command, words)
    return "\n".join(lines) + "\n"


def entry(command: Command, words: Words) -> list[str]:
    """The lines of one command."""
    labels = dict.fromkeys(key_label(each, ENGLISH) for each in command.keys)
    keys = f" ({', '.join(f'`{each}`' for each in labels)})" if labels else ""
    example = f", such as {typed_form(command, words)}" if command.argument else ""
    purpose = words(f"action-{command.name}")
    screen = " Full screen only." if command.is_visual else ""
    live = " At once while a program runs." if command.is_live else ""
    word = word_of(command, ENGLISH)
    lines = [f"- **{word}**{example}{keys}: {purpose}{screen}{_WHEN[command.when]}{live}"]
    form = next(iter(help_of(word, words)[1:2]), "")
    if command.argument and form:
        lines.append(f"  {form}")
    others = words_of(command.name, ENGLISH)[1:]
    if others:
        lines.append(f"  The same: {', '.join(others)}.")
    translated = (", ".join(words_of(command.name, each)) for each in languages() if each != ENGLISH)
    lines.append(f"  In other languages: {'; '.join(translated)}.")
    return lines


def with_words(page: str) -> str:
    """The page about the language with its section about the words as the declarations say."""
    before, heading, rest = page.partition("## Words\n")
    _, next_heading, after = rest.partition("\n## ")
    return f"{before}{heading}\n{words_section()}{next_heading}{after}"


def words_section() -> str:
    """The commands and what may follow them, a column for each language."""
    spoken = [Words(each) for each in languages()]
    english = Words(ENGLISH)
    commands = [
        (
            english(f"purpose-{topic}").rstrip("."),
            *(forms(entry.leaders, entry.rest, each) for each in spoken),
        )
        for topic, entry in ENTRIES.items()
    ]
    lines = [
        "Where two forms are the same command, the short one comes first. The section is made by",
        "`python -m tests.tools.commands_page`.",
        "",
        *_table("what it does", commands),
    ]
    for terminal, title in _ARGUMENTS.items():
        rows = [
            (_meaning(each.value), *(", ".join(each.spellings[language]) for language in languages()))
            for each in ARGUMENTS
            if each.terminal == terminal
        ]
        lines += ["", f"{title}:", "", *_table("meaning", rows)]
    return "\n".join(lines) + "\n"


_ARGUMENTS = {
    "DIRECTION": "The directions of DISTANCE and VIBRATE",
    "AXIS": "What POS says",
    "COLOUR": "The colours of COLOR",
    "SWITCH": "What follows SOUND and BELT",
}
"""By terminal of the grammar."""


def _meaning(value: Enum | str | bool) -> str:
    if isinstance(value, bool):
        return "on" if value else "off"
    return value if isinstance(value, str) else value.name.lower().replace("_", " ")


def _table(first: str, rows: Iterable[Sequence[str]]) -> list[str]:
    headings = (first, *(name_of_language(each, ENGLISH) for each in languages()))
    ruler = ["---" for _ in headings]
    return [f"| {' | '.join(each)} |" for each in (headings, ruler, *rows)]


def free_keys() -> tuple[str, ...]:
    """The keys after the menu key that no command has, as a declaration names them."""
    taken = {each for keys in KEYS.values() for each in keys}
    functions = (f"f{number}" for number in range(1, 13))
    shifted = (f"shift+{letter}" for letter in ascii_lowercase)
    after_menu = (f"{MENU} {each}" for each in (*ascii_lowercase, *shifted, *digits, *SIGNS, *functions))
    return tuple(each for each in after_menu if each not in taken)


if __name__ == "__main__":
    print("Free keys:", ", ".join(free_keys()))
    FILE.write_text(document(), encoding="utf-8")
    LANGUAGE_FILE.write_text(with_words(LANGUAGE_FILE.read_text(encoding="utf-8")), encoding="utf-8")
