"""All mistakes of form in a text: one for each thing that is wrong, and none for its consequences.

Reads the tokens as the parser does, but continues after a mistake:
1. A word near to an acceptable one is reported and read as that word.
2. In the head of a block (IF to THEN) the rest of the head is skipped. The block counts as opened, so that
   its END finds it.
3. Any other command is skipped, and reading resumes where the next one can begin.
4. An END that does not fit is read so that the fewest mistakes follow.
5. The lexer has reported a character that can't be read, so its command gets no second mistake.

``reader`` holds the place in the text, ``blocks`` handles ENDs and ELSE and resumes after mistakes,
``commands`` handles all other tokens.
"""

from __future__ import annotations

from itertools import pairwise

from language.diagnostics import MOST_MISTAKES, Diagnostic, MistakeKind
from language.lexer import END, FOR, FRAGMENT, NAME, NEEDS_NO_ARGUMENT, TAKES, Lexed, lex
from language.outline import ENDS, SENSOR_WORDS, is_split_else
from language.recovery.blocks import (
    is_misspelt_end,
    read_else,
    read_end,
    read_split_else,
    report_unclosed_blocks,
)
from language.recovery.commands import (
    has_misspelt_second,
    lacks_all,
    read_mistake_within,
    read_stray,
    read_unknown_command,
    read_unknown_pair,
    read_without_all,
    report_missing_argument,
)
from language.recovery.reader import (
    AFTER_FIRST_NAME,
    BEGINNERS,
    ELSE,
    SEMICOLON,
    VAR,
    Known,
    TokenReader,
)
from language.source import line_breaks
from language.tree_builder import MOST_LEVELS

_BEGIN_COMMANDS = BEGINNERS | SENSOR_WORDS | {NAME, VAR, SEMICOLON}

_DEEPEST = 4000
"""States of the automaton; only a text that is too deep anyway reaches them."""


def mistakes_in(lexed: Lexed, others: tuple[Diagnostic, ...], known: Known) -> tuple[Diagnostic, ...]:
    """The mistakes in a text, together with ``others`` that were found before, in the order of the text."""
    found = _found_in(lexed, known)
    if lexed.open_quote is not None and len(found) > len(lexed.mistakes):
        again = _with_another_quote_open(lexed)
        found_again = _found_in(again, known) if again else found
        found = found_again if len(found_again) <= len(found) else found
    if any(each.kind is MistakeKind.TOO_DEEP for each in others):
        found = [each for each in found if each.kind is not MistakeKind.TOO_DEEP]
    everything = [*others, *found]
    everything.sort(key=lambda each: each.span.start)
    return tuple(everything[:MOST_MISTAKES])


def _with_another_quote_open(lexed: Lexed) -> Lexed | None:
    """The text read with the forgotten quotation mark on the first line with an odd number of them.

    Because strings may span lines, a forgotten mark turns all later strings inside out. None if there is no
    such line.
    """
    source = lexed.source
    ends = [*line_breaks(source), len(source)]
    for start, end in pairwise((0, *ends)):
        if source.count('"', start, end) % 2:
            return lex(source, lexed.first_line, source.rindex('"', start, end))
    return None


def _found_in(lexed: Lexed, known: Known) -> list[Diagnostic]:
    """Reads to the end of the text, unless there are too many mistakes before, or it is too deep."""
    reader = TokenReader(lexed, known)
    is_too_deep = False
    while not (reader.is_at_end or is_too_deep or len(reader.found) >= MOST_MISTAKES):
        _read_next(reader)
        is_too_deep = len(reader.automaton.states) > _DEEPEST
    if reader.is_at_end:
        _finish(reader)
    elif is_too_deep and not reader.found:
        reader.report(MistakeKind.TOO_DEEP, reader.token, "expression", details={"limit": MOST_LEVELS})
    return lexed.mistakes + reader.found


def _read_next(reader: TokenReader) -> None:
    if reader.automaton.is_between_commands():
        _read_between_commands(reader)
    elif lacks_all(reader):
        read_without_all(reader)
    elif reader.automaton.accepts(reader.token[0]):
        reader.advance()
    else:
        read_mistake_within(reader)


def _read_between_commands(reader: TokenReader) -> None:
    """Begin a command, or continue the one before, which may be longer."""
    kind = reader.token[0]
    if kind in ENDS or kind == END or (kind == NAME and is_misspelt_end(reader)):
        read_end(reader)
    elif kind == ELSE:
        read_else(reader)
    elif is_split_else(reader.tokens, reader.at) and reader.automaton.accepts(ELSE):
        read_split_else(reader)
    elif kind == NAME and reader.following[0] not in AFTER_FIRST_NAME:
        read_unknown_command(reader)
    elif kind == FRAGMENT or (kind == FOR and has_misspelt_second(reader)):
        read_unknown_pair(reader)
    elif not reader.automaton.accepts(kind):
        read_stray(reader)
    else:
        if kind in _BEGIN_COMMANDS:
            reader.begin_command()
        reader.advance()


def _finish(reader: TokenReader) -> None:
    """At the end of the text: report an incomplete command and the missing ENDs."""
    if not reader.automaton.is_between_commands():
        taker = reader.before[0]
        if taker in TAKES and taker not in NEEDS_NO_ARGUMENT:
            report_missing_argument(reader)
        elif lacks_all(reader):
            read_without_all(reader)
        else:
            reader.report(MistakeKind.SYNTAX, reader.token, "", reader.automaton.expected())
        if reader.head is not None:
            reader.blocks.pop()
    report_unclosed_blocks(reader)
