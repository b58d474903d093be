"""Where reading goes on behind a mistake, so that nothing is told that only follows from it."""

from __future__ import annotations

from language.lexer import FRAGMENT, KIND, NAME, NUMBER
from language.nearby import Near
from language.outline import OPENERS
from language.recovery.kinds import BEGINNERS, BEHIND_FIRST_NAME, HEAD_ENDS, SEMICOLON, SENSORS, SIMPLE, VAR
from language.recovery.open_blocks import Block, ends_ahead, kinds_of, mistakes_ahead
from language.recovery.reading import Reading

_HEADS = {
    "IF": ("condition", "THEN"),
    "WHILE": ("condition", "DO"),
    "REPEAT": ("expression", "TIMES"),
    "PROCEDURE": ("NAME", "DO"),
    "FOR": ("beginning", "SEMICOLON", "condition", "SEMICOLON", "step", "DO"),
}
"""What stands between the opening word and the first command of a block."""


def end_of_head(head: Block) -> str:
    """The word that ends it."""
    return _HEADS[head.read_as][-1]


def read_as(reading: Reading, near: Near | None, width: int) -> None:
    """Go on as if the meant word stood there, or else behind the command."""
    if near is None or near.complete or not can_open(reading, near.terminal, width):
        reading.at += width
        skip_command(reading, may_open=near is None)
    else:
        reading.replace(width, near.terminal)


def can_open(reading: Reading, terminal: str, width: int) -> bool:
    """Whether a word of so many tokens opens no block, or one that has its END further on."""
    if KIND[terminal] not in OPENERS:
        return True
    kinds, ahead = kinds_of(reading.blocks), ends_ahead(reading.tokens[reading.at + width :])
    return mistakes_ahead([*kinds, terminal], ahead) <= mistakes_ahead(kinds, ahead)


def give_up(reading: Reading) -> None:
    """Leave what can't be understood: the rest of the head if it is in one, or else the command."""
    if reading.head is not None:
        _skip_head(reading, reading.head)
        return
    token = reading.token
    is_in_place_of_operand = (
        reading.automaton.accepts(NUMBER) and token[3] == reading.tokens[reading.begun][3]
    )
    if is_in_place_of_operand and token[0] in SIMPLE:
        reading.at += 1
    reading.automaton.cut(reading.base)
    skip_command(reading)


def skip_command(reading: Reading, *, may_open: bool = False) -> None:
    """To where the next command may begin. The end of a head opens a block that nobody knows."""
    while not _may_begin_command(reading):
        token = reading.token
        reading.at += 1
        if may_open and token[0] in HEAD_ENDS:
            reading.blocks.append(Block("", token, "", 0))
            return


def skip_rest_of_line(reading: Reading, line: int) -> None:
    """The word of an END that nobody knows."""
    while reading.token[3] == line and not _may_begin_command(reading):
        reading.at += 1


def _may_begin_command(reading: Reading) -> bool:
    kind = reading.token[0]
    if kind in BEGINNERS or kind in (SEMICOLON, 0) or _begins_with_name(reading):
        return True
    is_first = reading.at == 0 or _is_first_of_line(reading)
    return is_first and (kind in (NAME, FRAGMENT) or kind in SENSORS)


def _begins_with_name(reading: Reading) -> bool:
    """Whether a declaration, an assignment or a call begins here."""
    kind = reading.token[0]
    return kind == VAR or (kind == NAME and reading.following[0] in BEHIND_FIRST_NAME)


def _is_first_of_line(reading: Reading) -> bool:
    return reading.before[3] != reading.token[3]


def _skip_head(reading: Reading, head: Block) -> None:
    """To the first command of the block, which counts as opened."""
    if not _move_to_head_end(reading, head):
        while not is_behind_head(reading, head):
            reading.at += 1
    if reading.token[0] in HEAD_ENDS:
        reading.at += 1
    reading.automaton.cut(head.depth)
    reading.automaton.move(_HEADS[head.read_as])
    reading.head = None


def _move_to_head_end(reading: Reading, head: Block) -> bool:
    """If a command stands in the head by mistake, move to the end of the head on the same line."""
    line, wanted = reading.token[3], KIND[end_of_head(head)]
    for at in range(reading.at + 1, len(reading.tokens)):
        kind = reading.tokens[at][0]
        if reading.tokens[at][3] != line:
            return False
        if kind == wanted:
            reading.at = at
            return True
        if kind in BEGINNERS:
            return False
    return False


def is_behind_head(reading: Reading, head: Block) -> bool:
    """Whether the first command of the block begins here, or its head ends."""
    kind = reading.token[0]
    if kind in BEGINNERS or kind in HEAD_ENDS or kind == 0:
        return True
    return head.kind != "FOR" and _is_first_of_line(reading) and _begins_with_name(reading)
