"""Blocks in a wrong text: which block an END or ELSE belongs to, and where reading resumes after a mistake.

Reading resumes so that no mistake is reported that only follows from another one. An END that does not fit
is read so that the fewest mistakes follow.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum, auto

from language.diagnostics import MistakeKind
from language.keywords import END_WORDS, all_words, folded_word, spelling
from language.lexer import FRAGMENT, KIND, NAME, NUMBER, Token
from language.outline import ENDS, OPENERS, SENSOR_WORDS, SIMPLE
from language.recovery.reader import (
    AFTER_FIRST_NAME,
    BEGINNERS,
    ELSE,
    HEAD_ENDS,
    SEMICOLON,
    VAR,
    OpenBlock,
    TokenReader,
)
from language.suggestions import Suggestion, is_near, nearest, suggested_keyword

_LOOK_AHEAD = 2000
"""How many openers and ENDs are compared to judge an END that does not fit."""

_HEADS = {
    "IF": ("condition", "THEN"),
    "WHILE": ("condition", "DO"),
    "REPEAT": ("expression", "TIMES"),
    "PROCEDURE": ("NAME", "DO"),
    "FOR": ("beginning", "SEMICOLON", "condition", "SEMICOLON", "step", "DO"),
}
"""The symbols between the opening word and the first command of a block."""


# --- END ----------------------------------------------------------------------------------------------


class _Closing(Enum):
    """How an END is read."""

    INNERMOST = auto()
    """The wrong word at the end of the innermost block."""
    OUTER = auto()
    """The right end of an outer block; the inner ones have none."""
    EXCHANGED = auto()
    """The right end of an outer block, too early; the inner one ends later."""
    STRAY = auto()
    """The end of nothing."""


def is_misspelt_end(reader: TokenReader) -> bool:
    """ENDD REPEAT at the end of a line, where a REPEAT is open."""
    token, following = reader.token, reader.following
    if not reader.blocks or OPENERS.get(following[0]) != reader.blocks[-1].kind:
        return False
    is_misspelt = any(is_near(token[5], each) for each in END_WORDS)
    return is_misspelt and following[3] == token[3] and _is_last_of_line(reader, 1)


def read_end(reader: TokenReader) -> None:
    """Read an END with its word, without it, or misspelt."""
    token = reader.token
    end, meant, width = ENDS.get(token[0], ""), "", 1
    if not end:
        end, meant, width = _end_meant(reader)
    reader.begun = reader.at
    closing = _closing(reader, token, end, meant, width)
    for read_as in _close(reader.blocks, end, closing):
        _feed_end(reader, read_as)
    reader.at += width
    if token[0] not in ENDS:  # an unknown word may follow the END
        while reader.token[3] == token[3] and not _may_begin_command(reader):
            reader.at += 1


def _end_meant(reader: TokenReader) -> tuple[str, str, int]:
    """What an END without its word means: the block, the words for it, the number of tokens typed for it."""
    near, width = pair_meant(reader)
    if near:
        return near.terminal.removeprefix("END_"), near.text, width
    following, kind = reader.following, reader.blocks[-1].kind if reader.blocks else ""
    if not kind:
        return "", "", 1
    words = spelling(f"END {kind}", reader.language)
    if following[3] == reader.token[3] and OPENERS.get(following[0]) == kind:
        return kind, words, 2
    has_unknown_word = (
        following[0] == NAME and not _is_last_of_line(reader, 0) and _is_last_of_line(reader, 1)
    )
    return "", words, 2 if has_unknown_word else 1


def _is_last_of_line(reader: TokenReader, more: int) -> bool:
    """Whether the token ``more`` places after this one is the last of the line."""
    after = reader.tokens[min(reader.at + more + 1, len(reader.tokens) - 1)]
    return after[3] != reader.token[3] or after[0] == 0


def _closing(reader: TokenReader, token: Token, end: str, meant: str, width: int) -> _Closing:
    """Decide how to read an END, and report one that does not fit."""
    if not reader.blocks:
        reader.report(MistakeKind.WRONG_END, token, "stray-end", ("command",))
        return _Closing.STRAY
    block = reader.blocks[-1]
    if token[0] in ENDS and block.kind in (end, ""):
        return _Closing.INNERMOST
    closing = _best_closing(_kinds_of(reader.blocks), end, _borders_ahead(reader, width))
    if block.kind:
        is_other = token[0] in ENDS and closing is _Closing.INNERMOST
        meant = spelling(f"END {block.kind}", reader.language) if is_other else meant
        expected, details = _about_end(block)
        code = "other-end" if is_other else ""
        reader.report(MistakeKind.WRONG_END, token, code, expected, meant, details, width)
    return _Closing.INNERMOST if token[0] not in ENDS and closing is _Closing.STRAY else closing


def _best_closing(open_kinds: list[str], end: str, ahead: Sequence[int]) -> _Closing:
    """The reading of an END after which the fewest mistakes follow ``ahead``."""
    left = {_Closing.INNERMOST: open_kinds[:-1], _Closing.STRAY: open_kinds}
    if end in open_kinds:
        index = _innermost(open_kinds, end)
        left[_Closing.OUTER] = open_kinds[:index]
        left[_Closing.EXCHANGED] = open_kinds[:index] + open_kinds[index + 1 :]
    order = list(_Closing)
    return min(left, key=lambda each: (_mistakes_ahead(left[each], ahead), order.index(each)))


def _close(blocks: list[OpenBlock], end: str, closing: _Closing) -> list[str]:
    """Remove the closed blocks. Returns what the automaton reads for them: ``IF`` stands for END IF ..."""
    if closing is _Closing.STRAY:
        return []
    if closing is _Closing.OUTER:
        index = _innermost(_kinds_of(blocks), end)
        closed = [block.read_as for block in reversed(blocks[index:])]
        del blocks[index:]
        return closed
    if closing is _Closing.EXCHANGED:
        for index in range(_innermost(_kinds_of(blocks), end), len(blocks) - 1):
            blocks[index].kind, blocks[index].token = blocks[index + 1].kind, blocks[index + 1].token
    return [blocks.pop().read_as]


def report_unclosed_blocks(reader: TokenReader) -> None:
    """Report each block that is open at the end of the text, outermost first."""
    for block in reader.blocks:
        if block.kind:
            expected, details = _about_end(block)
            code, else_if = "", reader.else_if
            if block.kind == "IF" and else_if is not None and else_if[1] > block.token[1]:
                code = "else-if"
            reader.report(MistakeKind.MISSING_END, block.token, code, expected, "", details)


def _about_end(block: OpenBlock) -> tuple[tuple[str, ...], dict[str, str | int]]:
    return (f"END {block.kind}",), {"opener": block.kind, "opener_line": block.token[3]}


def _feed_end(reader: TokenReader, read_as: str) -> None:
    if read_as:
        reader.automaton.feed(KIND[f"END_{read_as}"])


# --- ELSE ---------------------------------------------------------------------------------------------


def read_else(reader: TokenReader) -> None:
    if reader.automaton.accepts(ELSE) and reader.blocks[-1].kind == "IF":
        reader.begin_command()
        reader.advance()
        return
    reader.begun = reader.at
    reader.report(MistakeKind.SYNTAX, reader.token, "stray-else", reader.automaton.expected())
    _close_blocks_in_if(reader)
    reader.at += 1


def read_split_else(reader: TokenReader) -> None:
    """Read ``SI NO`` as SINO."""
    kind, start, _, line, column, text = reader.token
    both = (kind, start, reader.following[2], line, column, f"{text} {reader.following[5]}")
    reader.begun = reader.at
    reader.report(MistakeKind.UNKNOWN_COMMAND, both, "", ("command",), spelling("ELSE", reader.language))
    reader.replace(2, "ELSE")


def _close_blocks_in_if(reader: TokenReader) -> None:
    """End the blocks inside the innermost IF before an ELSE, if fewer mistakes follow then."""
    kinds, ahead = _kinds_of(reader.blocks), _borders_ahead(reader)
    outer = kinds[: _innermost(kinds, "IF") + 1] if "IF" in kinds else kinds
    if _mistakes_ahead(outer, ahead) >= _mistakes_ahead(kinds, ahead):
        return
    while len(reader.blocks) > len(outer):
        _feed_end(reader, reader.blocks.pop().read_as)
    if reader.automaton.accepts(ELSE):
        reader.automaton.feed(ELSE)


# --- the blocks ahead ---------------------------------------------------------------------------------


def _kinds_of(blocks: Sequence[OpenBlock]) -> list[str]:
    return [block.kind for block in blocks]


def _innermost(kinds: list[str], kind: str) -> int:
    """The index of the last one of a kind."""
    return len(kinds) - 1 - kinds[::-1].index(kind)


def _borders_ahead(reader: TokenReader, width: int = 0) -> list[int]:
    """The opening words and ENDs after ``width`` tokens; only the first ones of a long text."""
    return reader.borders_ahead(reader.at + width, _LOOK_AHEAD)


def _mistakes_ahead(open_kinds: list[str], kinds: Sequence[int]) -> int:
    """How many ENDs do not fit if these blocks are open, and how many blocks have none."""
    stack, mistakes = list(open_kinds), 0
    for kind in kinds:
        if kind in OPENERS:
            stack.append(OPENERS[kind])
        elif stack and stack[-1] in (ENDS.get(kind, ""), ""):
            stack.pop()
        else:
            mistakes += 1
            if stack:
                stack.pop()
    return mistakes + len(stack)


# --- resuming after a mistake -------------------------------------------------------------------------


def read_as(reader: TokenReader, near: Suggestion | None, width: int) -> None:
    """Resume as if the meant word were in the text, or else after the command."""
    if near is None or near.complete or not can_open(reader, near.terminal, width):
        reader.at += width
        skip_command(reader, may_open=near is None)
    else:
        reader.replace(width, near.terminal)


def can_open(reader: TokenReader, terminal: str, width: int) -> bool:
    """Whether a word of ``width`` tokens opens no block, or one whose END follows."""
    if KIND[terminal] not in OPENERS:
        return True
    kinds, ahead = _kinds_of(reader.blocks), _borders_ahead(reader, width)
    return _mistakes_ahead([*kinds, terminal], ahead) <= _mistakes_ahead(kinds, ahead)


def give_up(reader: TokenReader) -> None:
    """Skip what can't be understood: the rest of the head in a head, or else the command."""
    if reader.head is not None:
        _skip_head(reader, reader.head)
        return
    token = reader.token
    is_in_place_of_operand = reader.automaton.accepts(NUMBER) and token[3] == reader.tokens[reader.begun][3]
    if is_in_place_of_operand and token[0] in SIMPLE:
        reader.at += 1
    reader.automaton.cut(reader.base)
    skip_command(reader)


def skip_command(reader: TokenReader, *, may_open: bool = False) -> None:
    """Move to where the next command may begin. The end of a head opens a block of unknown kind."""
    if may_open:
        _skip_parts_of_head(reader)
    while not _may_begin_command(reader):
        token = reader.token
        reader.at += 1
        if may_open and token[0] in HEAD_ENDS:
            open_unknown_block(reader, token)
            return


def _skip_parts_of_head(reader: TokenReader) -> None:
    """Move to the end of a head on this line, beyond the commands and semicolons in the head of a FOR."""
    line = reader.before[3]
    for at in range(reader.at, len(reader.tokens)):
        kind = reader.tokens[at][0]
        if reader.tokens[at][3] != line or kind in BEGINNERS:
            return
        if kind in HEAD_ENDS:
            reader.at = at
            return


def open_unknown_block(reader: TokenReader, token: Token) -> None:
    """Any END closes it."""
    reader.blocks.append(OpenBlock("", token, "", 0))


def _may_begin_command(reader: TokenReader) -> bool:
    kind = reader.token[0]
    if kind in BEGINNERS or kind in (SEMICOLON, 0) or _begins_with_name(reader):
        return True
    return reader.is_first_of_line and (kind in (NAME, FRAGMENT) or kind in SENSOR_WORDS)


def _begins_with_name(reader: TokenReader) -> bool:
    """Whether a declaration, an assignment or a call begins here."""
    kind = reader.token[0]
    return kind == VAR or (kind == NAME and reader.following[0] in AFTER_FIRST_NAME)


def end_of_head(head: OpenBlock) -> str:
    """The word that ends it."""
    return _HEADS[head.read_as][-1]


def is_after_head(reader: TokenReader, head: OpenBlock) -> bool:
    """Whether the first command of the block begins here, or its head ends."""
    kind = reader.token[0]
    if kind in BEGINNERS or kind in HEAD_ENDS or kind == 0:
        return True
    return head.kind != "FOR" and reader.is_first_of_line and _begins_with_name(reader)


def _skip_head(reader: TokenReader, head: OpenBlock) -> None:
    """Move to the first command of the block, which counts as opened."""
    if not _move_to_head_end(reader, head):
        while not is_after_head(reader, head):
            reader.at += 1
    if reader.token[0] in HEAD_ENDS:
        reader.at += 1
    reader.automaton.cut(head.depth)
    reader.automaton.move(_HEADS[head.read_as])
    reader.head = None


def _move_to_head_end(reader: TokenReader, head: OpenBlock) -> bool:
    """If a command is in the head by mistake, move to the end of the head on the same line."""
    line, wanted = reader.token[3], KIND[end_of_head(head)]
    for at in range(reader.at + 1, len(reader.tokens)):
        kind = reader.tokens[at][0]
        if reader.tokens[at][3] != line:
            return False
        if kind == wanted:
            reader.at = at
            return True
        if kind in BEGINNERS:
            return False
    return False


# --- keywords of two words ----------------------------------------------------------------------------


def pair_meant(reader: TokenReader) -> tuple[Suggestion | None, int]:
    """The meant keyword whose first word is here, and the number of tokens typed for it: GIRAR DIRETA."""
    token, following = reader.token, reader.following
    pairs = [each for each in all_words() if folded_word(each).startswith(f"{token[5]} ")]
    if following[0] in (NAME, FRAGMENT) and following[3] == token[3]:
        pair = nearest(f"{token[5]} {following[5]}", pairs)
        if pair and is_near(following[5], folded_word(pair).split()[1]):
            return suggested_keyword(pair), 2
    return (suggested_keyword(pairs[0]) if token[0] == FRAGMENT else None), 1
