"""Finds the command that a typed line asks for, and says how a command is typed and what it is for.

Rules: no word of a command is GoDonnie's, except where it means the same; no word means two things in one
language. A slip is corrected only where the line can't be GoDonnie: its first word is an unknown command
there and appears nowhere else in the program.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from functools import cache
from typing import TYPE_CHECKING

from msgspec import Struct

from donnie_tui.commands.declarations import COMMANDS, Command
from donnie_tui.core.wording import Wording
from language import locales
from language.locales import languages

if TYPE_CHECKING:
    from language.diagnostics import Diagnostic
    from language.parser import Parsed

MOST_WORDS = 3
"""Words of the longest word of a command."""
_VALUES = {
    "report-file": ("help-values-report-file", "help-values-report-picture"),
    "new-thing": ("help-values-new-thing",),
}
"""The sentences with which HELP lists the words that an argument can be."""
LARGEST_PROGRAM = 20_000
"""Characters of a program that is searched for one name."""


def words_of(name: str, language: str) -> tuple[str, ...]:
    """What the learner may type for the command ``name``: the listed word first, then others for the same.

    English where the language has none. Raises ``KeyError`` for a name that English does not have.
    """
    return locales.words(language, "commands", name)


def word_of(command: Command, language: str) -> str:
    """The word that Donnie shows for it."""
    return words_of(command.name, language)[0]


def find(line: str, commands: tuple[Command, ...] = COMMANDS) -> tuple[Command, str] | None:
    """The command that a typed line asks for, in any language, and its argument; None if it is GoDonnie.

    ``speed = 3`` and ``open [2]`` are GoDonnie: a learner may give a variable or a procedure the name of a
    command. A word that GoDonnie has too is GoDonnie's where something follows that the command does not
    take. Of two words that begin alike the longer one counts.
    """
    words, by_word = line.split(), _by_word(commands)
    for length in range(min(MOST_WORDS, len(words)), 0, -1):
        command = by_word.get(_folded(" ".join(words[:length])))
        if command is not None:
            following = line.strip().split(maxsplit=length)[length:]
            argument = following[0] if following else ""
            is_assignment = argument.startswith(("=", "["))
            is_statement = bool(argument) and command.is_godonnie and not command.argument
            is_everyday = argument[:1].isalpha() and _is_everyday(words, length)  # BACK 2 too, which is BW 2
            is_number = argument[:1] in tuple("-0123456789")
            takes_none = length == 1 and not command.argument
            is_everyday |= is_number and (command.needs_name or (takes_none and _is_everyday(words[:1], 0)))
            return None if is_assignment or is_statement or is_everyday else (command, argument)
    return None


def _is_everyday(words: Sequence[str], length: int) -> bool:
    """Whether the words are a beginner's way to say a GoDonnie statement, such as MOVE FORWARD."""
    from language.suggestions import everyday  # most lines have no such words

    said = everyday([_folded(each) for each in words])
    return said is not None and said.width > length


@cache
def _by_word(commands: tuple[Command, ...]) -> dict[str, Command]:
    return {word: each for each in reversed(commands) for word in _all_words(each)}


@cache
def _all_words(command: Command) -> tuple[str, ...]:
    """Its words in all languages, as they are compared."""
    return tuple(_folded(word) for language in languages() for word in words_of(command.name, language))


def _folded(word: str) -> str:
    """As GoDonnie compares words. Imported here: the keys are needed before the words are."""
    from language.source import fold_name

    return fold_name(word)


def line_command(line: str, above: str = "") -> tuple[Command, str] | None:
    """The command that a line of the program asks for, below the text ``above``; None if it is GoDonnie.

    So it is where a name may continue the text, as below FW alone. What is no command either, as STEP 3,
    and what a beginner says for GoDonnie, as MOVE 3, stays in the program.
    """
    found = find(line)
    if found is None or (found[1] and not found[0].argument) or _may_continue(above, line):
        return None
    word = line.split()[:-1]
    is_step_or_turn = found[1].isdecimal() and _is_everyday(word, len(word) - 1)
    return None if is_step_or_turn else found


def _may_continue(above: str, line: str) -> bool:
    from language.lexer import KIND, NAME, lex
    from language.parser import kinds_after

    if lex(line).tokens[0][0] != NAME:
        return False
    kinds = kinds_after(lex(above[-LARGEST_PROGRAM:]).tokens)
    return NAME in kinds and KIND["SPEAK"] not in kinds


# --- how a command is typed, and what it is for


def typed_form(command: Command, wording: Wording, kind: str = "") -> str:
    """How it is typed, with an example of its argument, or of that ``kind`` of argument: ``LIST 2 5``."""
    kind = kind or command.argument
    argument = wording(f"help-typed-{kind}") if kind else ""
    return " ".join(filter(None, (word_of(command, wording.language), argument)))


def not_understood(command: Command, wording: Wording, meant: str = "") -> str:
    """The answer to an argument that the command can't understand. ``meant``: the kind that it was to be."""
    if not command.argument:
        return wording("word-takes-nothing", word=word_of(command, wording.language))
    return wording("command-example", example=typed_form(command, wording, meant))


def help_line(command: Command, wording: Wording, keys: str = "") -> str:
    """The line of HELP for it: how it is typed, its keys where there are any, its purpose."""
    in_brackets = f" ({keys})" if keys else ""
    return f"{typed_form(command, wording)}{in_brackets}: {wording(f'action-{command.name}')}"


def words_in_lines(wording: Wording) -> tuple[str, ...]:
    """The words of GoDonnie and the commands, a line each: usage, a colon, purpose."""
    commands = (help_line(each, wording) for each in COMMANDS if not each.is_visual)
    return (*wording.help(None)[1:], *commands)


def help_of(topic: str, wording: Wording) -> tuple[str, ...]:
    """HELP with the word of a command: its purpose, its form, an example. Empty for any other word."""
    found = find(topic)
    if found is None or found[0].is_godonnie:
        return ()
    command = found[0]
    form = wording("help-form", form=_form(command, wording)) + "."
    example = wording("help-example", example=typed_form(command, wording)) + "."
    values = (wording(code) for code in _VALUES.get(command.argument, ()))
    return help_line(command, wording), form, *values, example


def _form(command: Command, wording: Wording) -> str:
    """The word, with the argument that may or must follow."""
    word = word_of(command, wording.language)
    if not command.argument:
        return word
    whole = f"{word} {wording(f'help-form-{command.argument}')}"
    return whole if command.required else wording("help-or", first=word, second=whole)


# --- slips


class Unknown(Struct, frozen=True):
    """What was typed, and the word that was probably meant."""

    word: str
    meant: str


def unknown_word(
    line: str,
    lines: Sequence[str],
    language: str,
    parse: Callable[[str], Parsed],
    commands: Sequence[Command] = COMMANDS,
) -> Unknown | None:
    """The word of a command that ``line`` was meant to begin with. None if the line may be GoDonnie.

    ``lines`` are those of the program before it, ``parse`` reads GoDonnie.
    """
    from language import keywords

    words = line.split()[:MOST_WORDS]
    if not words or not words[0].isalpha() or keywords.is_reserved(words[0]):
        return None
    if sum(map(len, lines)) + len(line) > LARGEST_PROGRAM or _is_name_in(words[0], lines):
        return None
    near = _nearest_command(words, commands, language)
    mistake = _mistake_in(line, lines, parse) if near is not None else None
    if near is None or mistake is None or mistake.code == "everyday" or _is_nearer(mistake.meant, near, line):
        return None
    return near


def _is_name_in(word: str, lines: Sequence[str]) -> bool:
    return _folded(word) in re.findall(r"\w+", _folded(" ".join(lines)))


def _mistake_in(line: str, lines: Sequence[str], parse: Callable[[str], Parsed]) -> Diagnostic | None:
    """The mistake of an unknown command at the beginning of the line, or None."""
    from language.diagnostics import MistakeKind

    number = len(lines) + 1
    for each in parse("\n".join((*lines, line))).diagnostics:
        if each.kind is MistakeKind.UNKNOWN_COMMAND and each.span.line == number:
            return each if _folded(each.found) == _folded(line.split()[0]) else None
    return None


def _nearest_command(words: Sequence[str], commands: Sequence[Command], language: str) -> Unknown | None:
    """The command that is nearest to what was typed. Of words that begin alike the longer one counts."""
    from language.suggestions import nearest  # most lines begin with a word of GoDonnie

    of_language = [word for each in commands for word in words_of(each.name, language)]
    for length in range(len(words), 0, -1):
        typed = " ".join(words[:length])
        same_length = [each for each in of_language if len(each.split()) == length and len(each) > 1]
        found = nearest(typed, same_length)
        if found is not None:
            return None if _folded(found) == _folded(typed) else Unknown(typed, found)
    return None


def _is_nearer(keyword: str, near: Unknown, line: str) -> bool:
    """Whether a word of GoDonnie is as near as the command's, or nearer. RUN alone is the command."""
    from language.suggestions import edit_distance

    if _folded(keyword) == _folded(near.meant):
        return line.split() != near.word.split()
    typed = _folded(near.word)
    distance = edit_distance(typed, _folded(near.meant))
    return bool(keyword) and edit_distance(typed, _folded(keyword)) <= distance
