"""ENDs and ELSE: which block they belong to, and which ones have none."""

from __future__ import annotations

from language.diagnostics import Kind
from language.keywords import END_WORDS, spelling
from language.lexer import KIND, NAME, Token
from language.nearby import has_few_slips
from language.outline import ENDS, OPENERS
from language.recovery.going_on import skip_rest_of_line
from language.recovery.kinds import ELSE
from language.recovery.open_blocks import (
    Block,
    Closing,
    best_closing,
    close,
    ends_ahead,
    innermost,
    kinds_of,
    mistakes_ahead,
)
from language.recovery.pairs import pair_meant
from language.recovery.reading import Reading


def is_misspelt_end(reading: Reading) -> bool:
    """ENDD REPEAT at the end of a line, where a REPEAT is open."""
    token, following = reading.token, reading.following
    if not reading.blocks or OPENERS.get(following[0]) != reading.blocks[-1].kind:
        return False
    is_near = any(has_few_slips(token[5], each) for each in END_WORDS)
    return is_near and following[3] == token[3] and _ends_line(reading, 1)


def read_end(reading: Reading) -> None:
    """One with its word, one without, or a misspelt one."""
    token = reading.token
    end, meant, width = ENDS.get(token[0], ""), "", 1
    if not end:
        end, meant, width = _end_meant(reading)
    reading.begun = reading.at
    closing = _closing(reading, token, end, meant, width)
    for read_as in close(reading.blocks, end, closing):
        _feed_end(reading, read_as)
    reading.at += width
    if token[0] not in ENDS:
        skip_rest_of_line(reading, token[3])


def _end_meant(reading: Reading) -> tuple[str, str, int]:
    """For an END without its word: the block that is meant, the words for it, how many were written."""
    near, width = pair_meant(reading)
    if near and width == 2:
        return near.terminal.removeprefix("END_"), near.text, 2
    opener = OPENERS.get(reading.following[0]) if reading.following[3] == reading.token[3] else None
    if opener and reading.blocks and opener == reading.blocks[-1].kind:
        return opener, spelling(f"END {opener}", reading.language), 2
    return "", *_innermost_meant(reading)


def _innermost_meant(reading: Reading) -> tuple[str, int]:
    """For an END alone, or with one word that is none of ours: the words of the block that it ends."""
    if not reading.blocks or not reading.blocks[-1].kind:
        return "", 1
    has_word = reading.following[0] == NAME and not _ends_line(reading, 0) and _ends_line(reading, 1)
    return spelling(f"END {reading.blocks[-1].kind}", reading.language), 2 if has_word else 1


def _ends_line(reading: Reading, more: int) -> bool:
    """Whether the token so many behind this one is the last of the line."""
    behind = reading.tokens[min(reading.at + more + 1, len(reading.tokens) - 1)]
    return behind[3] != reading.token[3] or behind[0] == 0


def _closing(reading: Reading, token: Token, end: str, meant: str, width: int) -> Closing:
    """How to read an END, which is told if it does not fit."""
    if not reading.blocks:
        reading.tell(Kind.WRONG_END, token, "stray-end", ("command",))
        return Closing.STRAY
    block = reading.blocks[-1]
    if token[0] in ENDS and block.kind in (end, ""):
        return Closing.INNERMOST
    closing = best_closing(kinds_of(reading.blocks), end, reading.tokens[reading.at + width :])
    if block.kind:
        is_other = token[0] in ENDS and closing is Closing.INNERMOST
        meant = spelling(f"END {block.kind}", reading.language) if is_other else meant
        code = "other-end" if is_other else ""
        _tell_about_end(reading, Kind.WRONG_END, token, block, meant, width, code)
    return Closing.INNERMOST if token[0] not in ENDS and closing is Closing.STRAY else closing


def tell_missing_ends(reading: Reading) -> None:
    """At the end of the text: each block that is open still, outermost first."""
    for block in reading.blocks:
        if block.kind:
            _tell_about_end(reading, Kind.MISSING_END, block.token, block)


def _tell_about_end(
    reading: Reading,
    kind: Kind,
    token: Token,
    block: Block,
    meant: str = "",
    width: int = 1,
    code: str = "",
) -> None:
    details: dict[str, str | int] = {"opener": block.kind, "opener_line": block.token[3]}
    reading.tell(kind, token, code, (f"END {block.kind}",), meant, details, width=width)


def read_else(reading: Reading) -> None:
    if reading.automaton.accepts(ELSE) and reading.blocks[-1].kind == "IF":
        reading.begin()
        reading.go_on()
        return
    reading.begun = reading.at
    reading.tell(Kind.SYNTAX, reading.token, "stray-else", reading.automaton.expected())
    _close_blocks_in_if(reading)
    reading.at += 1


def read_split_else(reading: Reading) -> None:
    """``SI NO`` for SINO: read as that word."""
    kind, start, _, line, column, text = reading.token
    both = (kind, start, reading.following[2], line, column, f"{text} {reading.following[5]}")
    reading.begun = reading.at
    reading.tell(Kind.UNKNOWN_COMMAND, both, "", ("command",), spelling("ELSE", reading.language))
    reading.replace(2, "ELSE")


def _close_blocks_in_if(reading: Reading) -> None:
    """Before an ELSE: end the blocks inside the innermost IF, if fewer mistakes follow then."""
    kinds, ahead = kinds_of(reading.blocks), ends_ahead(reading.tokens[reading.at :])
    outer = kinds[: innermost(kinds, "IF") + 1] if "IF" in kinds else kinds
    if len(outer) == len(kinds) or mistakes_ahead(outer, ahead) >= mistakes_ahead(kinds, ahead):
        return
    while len(reading.blocks) > len(outer):
        _feed_end(reading, reading.blocks.pop().read_as)
    if reading.automaton.accepts(ELSE):
        reading.automaton.feed(ELSE)


def _feed_end(reading: Reading, read_as: str) -> None:
    if read_as:
        reading.automaton.feed(KIND[f"END_{read_as}"])
