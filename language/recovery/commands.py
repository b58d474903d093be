"""Mistakes in commands: an unknown word where a command may begin, and a token that can't continue one.

A word that is near to an acceptable one is reported and read as that one.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile

from language.diagnostics import MistakeKind
from language.keywords import (
    argument,
    argument_words,
    canonical,
    canonical_of_terminal,
    is_reserved,
    spelling,
)
from language.lexer import (
    COMPLETE_ALONE,
    END,
    FRAGMENT,
    KIND,
    NAME,
    NEEDS_NO_ARGUMENT,
    NUMBER,
    SENSORS,
    STRING,
    TAKE_EXPRESSION,
    TAKES,
    Token,
)
from language.locales import ENGLISH, languages
from language.outline import ENDS, OPENERS
from language.recovery.blocks import (
    can_open,
    end_of_head,
    give_up,
    is_after_head,
    open_unknown_block,
    pair_meant,
    read_as,
    skip_command,
)
from language.recovery.reader import (
    AFTER_FIRST_NAME,
    ASSIGN,
    BEGINNERS,
    CLASSES,
    COMPARATOR,
    ELSE,
    HEAD_ENDS,
    LPAR,
    SEMICOLON,
    SIGN,
    VAR,
    Automaton,
    TokenReader,
)
from language.suggestions import (
    SAMPLES,
    Everyday,
    Suggestion,
    everyday,
    fillers_of,
    joining_word,
    nearest,
    nearest_keyword,
    nearest_pair,
    number_in_digits,
    pair_ending_with,
)
from language.tables import TERMINALS

_BEFORE_NEW_NAME = frozenset(
    KIND[name] for name in ("VAR", "PROCEDURE", "COLON", "COMMA", "FOR", "SEMICOLON")
)
_CALL_PUNCTUATION = (LPAR, *(KIND[name] for name in ("COLON", "COMMA", "RPAR")))
"""May separate the values of a call without brackets."""


_SPEAK, _COLON = KIND["SPEAK"], KIND["COLON"]
_TAKE_VALUE = frozenset(KIND[name] for name in TAKE_EXPRESSION)
_TAKE_MORE = _TAKE_VALUE | OPENERS.keys() | {VAR}
"""The words after which something else than a direction, an axis, a colour or a switch must come."""

_LONGEST_EVERYDAY_LINE = 40
"""Tokens that are looked at of a line that begins like an everyday one."""
_SCALE, _RPAR = KIND["SCALE"], KIND["RPAR"]
_BEFORE_VALUE = frozenset((SIGN, ASSIGN, COMPARATOR, _SCALE))
_AFTER_FIRST = HEAD_ENDS | {ASSIGN}
"""What comes after the first value or name of a command."""


# --- where a command may begin ------------------------------------------------------------------------


def read_unknown_command(reader: TokenReader) -> None:
    """Read a name that begins no command."""
    token = reader.token
    if _follows_taker(reader):
        _read_bad_argument(reader)
        return
    if _read_misspelt_sensor(reader) or _read_call_without_brackets(reader):
        return
    if _read_text_without_quotes(reader) or _read_filler(reader) or _read_everyday(reader):
        return
    if reader.following[0] == COMPARATOR and reader.following[5] == "==":
        _read_two_equals_signs(reader)
        return
    if _changes_shortly(reader, reader.at):
        reader.begin_command()
        reader.advance()
        _read_short_change(reader)
        return
    pair = _pair_with_misspelt_first(reader)
    near, width = (pair, 2) if pair else (_command_meant(reader, token[5]), 1)
    code = "call-brackets" if reader.following[0] == LPAR and near is None else ""
    meant = _with_number(reader, near, width) if near else _second_speak(reader)
    reader.begun = reader.at
    reader.report(MistakeKind.UNKNOWN_COMMAND, token, code, ("command",), meant, width=width)
    read_as(reader, near, width)


def _second_speak(reader: TokenReader) -> str:
    """The second SPEAK that SPEAK "a" x needs, because one SPEAK says one thing."""
    token, before = reader.token, reader.before
    if before[0] != STRING or before[3] != token[3]:
        return ""
    return f"{spelling('SPEAK', reader.language)} {reader.typed(token)}"


def _read_two_equals_signs(reader: TokenReader) -> None:
    """Read an assignment written as a comparison: ``x == 3``."""
    reader.begin_command()
    reader.advance()
    reader.report(MistakeKind.SYNTAX, reader.token, "two-equals", ("=",), "=")
    reader.mark_flaw()
    reader.automaton.feed(ASSIGN)
    reader.at += 1


def _pair_with_misspelt_first(reader: TokenReader) -> Suggestion | None:
    """GIRA DIREITA: the keyword of both words, where the second one alone is not the mistake."""
    token, following = reader.token, reader.following
    if following[0] != NAME or following[3] != token[3]:
        return None
    return nearest_pair(token[5], following[5], reader.automaton.acceptable())


def _command_meant(reader: TokenReader, typed: str) -> Suggestion | None:
    """The nearest word that leaves all ENDs as they are, or else the nearest one."""
    words = reader.automaton.acceptable()
    pair = pair_ending_with(typed, words)
    if pair:
        return pair
    fitting = frozenset(word for word in words if can_open(reader, word, 1))
    near = nearest_keyword(typed, fitting, reader.language)
    return near or nearest_keyword(typed, words, reader.language)


def has_misspelt_second(reader: TokenReader) -> bool:
    """PARA FRENT, which is no head of PARA (FOR)."""
    third = reader.tokens[min(reader.at + 2, len(reader.tokens) - 1)][0]
    return third != ASSIGN and pair_meant(reader)[1] == 2


def read_unknown_pair(reader: TokenReader) -> None:
    """Read RIGHT without TURN, GIRAR DIRETA, PARA FRENT."""
    token = reader.token
    if _follows_taker(reader):
        _read_bad_argument(reader)
        return
    near, width = pair_meant(reader)
    if width == 1 and _read_everyday(reader):
        return
    reader.begun = reader.at
    if reader.tokens[reader.at + width][0] == ASSIGN:
        _report_reserved(reader, token)
        near = None
    else:
        meant = _with_number(reader, near, width) if near else ""
        reader.report(MistakeKind.UNKNOWN_COMMAND, token, "", ("command",), meant, width=width)
    read_as(reader, near, width)


def read_stray(reader: TokenReader) -> None:
    """Read a token that begins no command and does not continue the one before."""
    token, before = reader.token, reader.before
    if _follows_taker(reader) and token[0] in (NUMBER, STRING):
        _read_bad_argument(reader)
        return
    if _is_assigned_to_keyword(reader):
        _report_assignment(reader)
    elif reader.following[0] == ASSIGN and is_reserved(token[5]):
        _report_reserved(reader, token)
    elif _follows_unknown_name(reader):
        _report_unknown_name(reader)
    else:
        code = "text-plus" if before[0] == STRING and token[0] == SIGN else ""
        code = "whole-numbers" if reader.is_decimal_comma else code
        reader.report(MistakeKind.SYNTAX, token, code, reader.automaton.expected())
    reader.at += 1
    skip_command(reader)


def _with_number(reader: TokenReader, near: Suggestion, width: int) -> str:
    """LEFT alone: the meant command with a number, where its line ends after one word of two."""
    following = reader.tokens[reader.at + width]
    is_over = following[0] == 0 or following[3] != reader.token[3]
    sample = SAMPLES.get(near.terminal, "") if is_over and " " in near.text and not near.complete else ""
    return f"{near.text} {sample}".strip()


# --- what beginners say: WALK 3, TURN LEFT, LOOP 3 ----------------------------------------------------


def _read_everyday(reader: TokenReader) -> bool:
    """If an everyday word is here, report it with the line that was probably meant."""
    line = _rest_of_line(reader)
    said = everyday([each[5] for each in line], reader.spoken_first)
    if said is None:
        return False
    meant, width = _line_meant(reader, line, said)
    reader.begun = reader.at
    reader.report(MistakeKind.UNKNOWN_COMMAND, reader.token, "everyday", ("command",), meant, width=width)
    is_opener, blocks = KIND[said.terminal] in OPENERS, len(reader.blocks)
    opens = is_opener and can_open(reader, said.terminal, said.width)
    token = reader.token
    reader.at += said.width
    skip_command(reader, may_open=is_opener)
    if opens and len(reader.blocks) == blocks:
        open_unknown_block(reader, token)
    return True


def _rest_of_line(reader: TokenReader, skipped: int = 0) -> list[Token]:
    """The tokens to the end of the line, as many as an everyday line can have, without the first ones."""
    at = reader.at + skipped
    near = reader.tokens[at : at + _LONGEST_EVERYDAY_LINE]
    return list(takewhile(lambda each: each[0] and each[3] == reader.token[3], near))


def _line_meant(reader: TokenReader, line: Sequence[Token], said: Everyday) -> tuple[str, int]:
    """What replaces how many tokens: the command with its value, or the word alone before a longer one."""
    language = said.language if reader.language == ENGLISH else reader.language
    word = spelling(canonical_of_terminal(said.terminal), language)
    if said.terminal == "SPEAK" and (text := _text_meant(reader, line[said.width :])):
        return f"{word} {text}", len(line)
    fillers = fillers_of(said.language)
    values = [at for at in range(said.width, len(line)) if line[at][5] not in fillers]
    sample = said.number or SAMPLES.get(said.terminal)
    if not values:
        return f"{word} {sample}" if sample else word, len(line)
    first, following = line[values[0]], line[values[1]] if len(values) > 1 else None
    if said.number and _begins_another(line, values[0]):
        return f"{word} {said.number}", values[0]
    is_whole = following is None or following[0] in BEGINNERS or following[0] in (SEMICOLON, VAR)
    if not is_whole or first[0] not in (NUMBER, NAME, STRING):
        return word, values[0]
    value = number_in_digits(first[5]) or reader.typed(first)
    width = values[1] if following else len(line)
    if said.terminal == "REPEAT":
        return f"{word} {value} {spelling('TIMES', language)}", width
    return f"{word} {value}", width


def _text_meant(reader: TokenReader, words: Sequence[Token]) -> str:
    """The words of a text without quotation marks, in such marks; empty for what may be anything else."""
    if not words or any(each[0] != NAME for each in words) or any(reader.declares(each[5]) for each in words):
        return ""
    return f'"{reader.source_of(words[0], words[-1])}"'


# --- words too many: SPEAK hello Donnie, FW 3 steps


def _read_text_without_quotes(reader: TokenReader) -> bool:
    """If the second word of a text without quotation marks is here, report the text."""
    if reader.at - 2 != reader.begun or reader.tokens[reader.begun][0] != _SPEAK:
        return False
    words = [reader.before, *_rest_of_line(reader)]
    text = _text_meant(reader, words) if words[0][3] == words[1][3] else ""
    if not text:
        return False
    details: dict[str, str | int] = {"written": f"{reader.typed(reader.tokens[reader.begun])} {text}"}
    width = len(words) - 1
    reader.report(MistakeKind.UNKNOWN_COMMAND, reader.token, "text-quotes", (), text, details, width)
    reader.at += width
    return True


def _read_filler(reader: TokenReader) -> bool:
    """If a word is here that beginners write after a whole command, report it with the command alone."""
    token, begun = reader.token, reader.tokens[reader.begun]
    if begun[3] != token[3] or begun[0] not in _TAKE_VALUE:
        return False
    if not _is_filler(reader, token):
        return False
    written, value = reader.source_of(begun, reader.before), reader.typed(reader.before)
    details: dict[str, str | int] = {"written": written, "word": reader.typed(token)}
    line = _rest_of_line(reader)
    width = next((at for at, each in enumerate(line) if not _is_filler(reader, each)), len(line))
    reader.report(MistakeKind.UNKNOWN_COMMAND, token, "filler", (), value, details, width)
    reader.mark_flaw()
    reader.at += width
    return True


def _is_filler(reader: TokenReader, token: Token) -> bool:
    is_declared = reader.declares(token[5])
    return not is_declared and any(token[5] in fillers_of(each) for each in languages())


# --- calls without brackets: AB 2, AB: 2, AB (2), CD --------------------------------------------------


def _read_call_without_brackets(reader: TokenReader) -> bool:
    """If a procedure's name is here, report it with the right way to call it."""
    token = reader.token
    names = reader.procedures.get(token[5])
    if names is None:
        return False
    typed, (values, width) = reader.typed(token), _values_of_call(reader)
    meant = f"{typed} [{', '.join(values)}]" if values is not None and len(values) == len(names) else ""
    reader.begun = reader.at
    details: dict[str, str | int] = {"call": f"{typed} [{', '.join(names)}]"}
    reader.report(MistakeKind.UNKNOWN_COMMAND, token, "procedure", ("command",), meant, details, width)
    read_as(reader, None, 1)
    return True


def _values_of_call(reader: TokenReader) -> tuple[list[str] | None, int]:
    """The values after the name on its line, None if not all are plain, and the tokens up to there."""
    at = end = reader.at + 1
    while reader.tokens[end][0] and reader.tokens[end][3] == reader.token[3]:
        end += 1
    line = reader.tokens[at:end]
    values: list[str] = []
    width = 1
    for at, token in enumerate(line):
        if token[0] in (NAME, NUMBER) and not _begins_another(line, at):
            values.append(reader.typed(token))
        elif token[0] not in _CALL_PUNCTUATION:
            return (values if _begins_another(line, at) else None), width
        width = at + 2
    return values, width


def _begins_another(line: Sequence[Token], at: int) -> bool:
    """Whether another command begins at that token."""
    kind = line[at][0]
    following = line[at + 1][0] if at + 1 < len(line) else 0
    return kind in BEGINNERS or kind in (SEMICOLON, VAR) or (kind == NAME and following in AFTER_FIRST_NAME)


# --- within a command ---------------------------------------------------------------------------------


def read_mistake_within(reader: TokenReader) -> None:
    """Read a token that can't continue the command."""
    token, before = reader.token, reader.before
    if before[0] in TAKES and reader.automaton.accepts(KIND[TAKES[before[0]]]):
        if token[0] in (NAME, NUMBER, STRING):
            _read_bad_argument(reader)
            return
        if before[0] not in NEEDS_NO_ARGUMENT:  # read as if the missing word were there
            report_missing_argument(reader)
            reader.automaton.feed(KIND[TAKES[before[0]]])
            reader.mark_flaw()
            return
    if _read_misspelt_sensor(reader):
        return
    may_change = before[0] == NAME and reader.automaton.accepts(ASSIGN)
    if may_change and _changes_shortly(reader, reader.at - 1):
        _read_short_change(reader)
    elif _follows_unknown_name(reader):
        _report_unknown_name(reader)
        give_up(reader)
    elif _misses_value(reader):
        _report_missing_value(reader)
    elif _is_reserved_as_name(reader):
        _report_reserved(reader, token)
        reader.tokens[reader.at] = (NAME, *token[1:])
        reader.advance()
    elif _is_assigned_to_keyword(reader):
        _report_assignment(reader)
        give_up(reader)
    elif token[0] == ASSIGN and reader.automaton.accepts(COMPARATOR):
        _read_equals_sign(reader)
    else:
        _read_unexpected(reader)


def _read_equals_sign(reader: TokenReader) -> None:
    """Read a comparison written with one equals sign, or with its signs turned: ``=>`` for ``>=``."""
    _, start, end, line, column, text = token = reader.token
    following = reader.following
    is_turned = following[1] == end and following[5] in ("<", ">")
    if is_turned:
        token = (ASSIGN, start, following[2], line, column, text + following[5])
    meant = f"{following[5]}=" if is_turned else "=="
    code = "" if is_turned else "single-equals"
    reader.report(MistakeKind.SYNTAX, token, code, ("comparison",), meant)
    reader.mark_flaw()
    reader.automaton.feed(COMPARATOR)
    reader.at += 2 if is_turned else 1


def _read_unexpected(reader: TokenReader) -> None:
    token, head, near = reader.token, reader.head, None
    details: dict[str, str | int] = {} if head is None else {"opener": head.kind}
    if _misses_end_of_head(reader):
        _report_end_of_head(reader, details)
        give_up(reader)
        return
    joining = joining_word(token[5]) if head is not None and token[0] == NAME else ""
    if token[0] in (NAME, FRAGMENT) and not joining:
        near = nearest_keyword(token[5], reader.automaton.acceptable(), reader.language)
    code = "whole-numbers" if reader.is_decimal_comma else joining
    if reader.before[0] in _TAKE_MORE and token[0] in _AFTER_FIRST:  # REPEAT TIMES, VAR = 5
        code, details["word"] = "missing-first", TERMINALS[reader.before[0]]
    elif reader.before[0] == _COLON and token[0] in HEAD_ENDS:  # PROCEDURE p: DO
        code = "no-colon"
    expected = reader.automaton.expected()
    reader.report(MistakeKind.SYNTAX, token, code, expected, near.text if near else "", details)
    if near and not near.complete:
        read_as(reader, near, 1)
    else:
        give_up(reader)


def _misses_end_of_head(reader: TokenReader) -> bool:
    """Whether only THEN, DO or TIMES is missing before a command, or another of them is in its place."""
    head = reader.head
    if head is None or reader.is_at_end or not is_after_head(reader, head):
        return False
    return reader.automaton.accepts(KIND[end_of_head(head)])


def _report_end_of_head(reader: TokenReader, details: dict[str, str | int]) -> None:
    """If the command is on the next line, the missing word belongs at the end of the line before."""
    assert reader.head is not None
    token, before, word = reader.token, reader.before, end_of_head(reader.head)
    code = ""
    if token[0] not in HEAD_ENDS:
        code = "head-end" if token[3] == before[3] else "head-end-before"
        details |= {"missing": word, "line": before[3]}
    meant, expected = spelling(word, reader.language), reader.automaton.expected()
    reader.report(MistakeKind.SYNTAX, token, code, expected, meant, details)


# --- what other programming languages write: i++, i += 2, i := 2, RANDOM 5 ----------------------------------


def _changes_shortly(reader: TokenReader, at: int) -> bool:
    """Whether ``i++``, ``i += 2`` or ``i := 2`` is there, with its name at that index."""
    sign = reader.tokens[at + 1]
    if sign[0] not in (SIGN, _SCALE, _COLON):
        return False
    last = reader.tokens[at + 2]
    return sign[2] == last[1] and (last[0] == ASSIGN or (sign[0] == SIGN and last[5] == sign[5]))


def _read_short_change(reader: TokenReader) -> None:
    """Report ``i++``, ``i += 2`` or ``i := 2`` after its name with the assignment, and read it as one."""
    reader.at -= 1
    name, sign, last, value, after = (*reader.tokens[reader.at : reader.at + 5], reader.tokens[-1])[:5]
    typed, amount, width = reader.typed(name), "1", 3
    if last[0] == ASSIGN:
        is_plain = value[0] in (NUMBER, NAME) and after[0] not in (SIGN, _SCALE)
        amount, width = (reader.typed(value), 4) if is_plain else ("", 3)
    start = f"{typed} =" if sign[0] == _COLON else f"{typed} = {typed} {sign[5]}"
    meant = f"{start} {amount}" if amount else ""
    written = meant or f"{start} 1"
    if sign[0] == _COLON and not amount:
        meant = start
        rest = " ".join(map(reader.typed, _rest_of_line(reader, skipped=3)))
        written = f"{start} {rest}" if rest else written
    details: dict[str, str | int] = {"written": written}
    reader.report(MistakeKind.SYNTAX, name, "short-change", ("=",), meant, details, width)
    reader.at += 1
    reader.mark_flaw()
    reader.at += 2
    reader.automaton.feed(ASSIGN)
    if last[0] != ASSIGN:
        reader.automaton.feed(NUMBER)


def _follows_unknown_name(reader: TokenReader) -> bool:
    """Whether a value follows a name that the text declares nowhere: ``RANDOM 5``."""
    token, before = reader.token, reader.before
    if token[0] not in (NUMBER, LPAR) or before[0] != NAME or before[3] != token[3]:
        return False
    return not reader.declares(before[5])


def _report_unknown_name(reader: TokenReader) -> None:
    """Report the name together with all that follows it as a value of a function would."""
    kind, start, _, line, column, text = reader.before
    at = reader.at
    if reader.token[0] == LPAR:
        while reader.tokens[at + 1][3] == line and reader.tokens[at][0] != _RPAR and reader.tokens[at + 1][0]:
            at += 1
    whole = (kind, start, reader.tokens[at][2], line, column, text)
    reader.report(MistakeKind.UNKNOWN_COMMAND, whole, "value", ("expression",))
    reader.mark_flaw()
    reader.at = at


# --- FW without its number ----------------------------------------------------------------------------


def lacks_all(reader: TokenReader) -> bool:
    """Whether the word before needs more, and another command begins here, or the text ends."""
    if reader.before[0] not in _TAKE_MORE:
        return False
    kind = reader.token[0]
    if kind == 0:
        return True
    if _is_reserved_as_name(reader):
        return False
    if kind == NAME:  # an assignment or a call, not the value
        begins = reader.following[0] in AFTER_FIRST_NAME and reader.is_first_of_line
        return begins and reader.before[0] in _TAKE_VALUE
    if reader.is_first_of_line or kind in ENDS:
        return kind in BEGINNERS or kind in (VAR, SEMICOLON)
    return kind in (SEMICOLON, ELSE, END) or (kind in BEGINNERS and kind not in COMPLETE_ALONE)


def read_without_all(reader: TokenReader) -> None:
    """Report the command that lacks what it needs, and read on as if that were there."""
    taker = reader.before
    terminal = TERMINALS[taker[0]]
    sample = SAMPLES.get(terminal)
    meant = f"{reader.typed(taker)} {sample}" if sample else ""
    details: dict[str, str | int] = {"word": canonical(taker[5]) or terminal}
    reader.report(MistakeKind.SYNTAX, taker, "missing-argument", reader.automaton.expected(), meant, details)
    if reader.is_at_end:
        return
    if reader.head is not None:
        give_up(reader)
    else:
        reader.automaton.feed(NAME)


def _misses_value(reader: TokenReader) -> bool:
    """Whether a sign is the last of its line, and a command follows."""
    begins = reader.token[0] in BEGINNERS or reader.token[0] == VAR
    return reader.before[0] in _BEFORE_VALUE and begins and reader.is_first_of_line


def _report_missing_value(reader: TokenReader) -> None:
    reader.report(MistakeKind.SYNTAX, reader.before, "missing-value", reader.automaton.expected())
    give_up(reader)


# --- reserved words -----------------------------------------------------------------------------------


def _report_reserved(reader: TokenReader, token: Token) -> None:
    reader.report(MistakeKind.RESERVED_WORD, token, details={"name": reader.typed(token)})


def _report_assignment(reader: TokenReader) -> None:
    """Report the equals sign of ``FW = 3``: the command itself is right so far."""
    word = reader.typed(reader.before)
    expected = reader.automaton.expected()
    reader.report(MistakeKind.SYNTAX, reader.token, "assigned-keyword", expected, details={"name": word})


def _is_assigned_to_keyword(reader: TokenReader) -> bool:
    """Whether an equals sign follows a keyword with which the command begins."""
    before = reader.before
    if reader.token[0] != ASSIGN or reader.at - 1 != reader.begun:
        return False
    return is_reserved(before[5]) and before[0] not in _BEFORE_NEW_NAME


def _is_reserved_as_name(reader: TokenReader) -> bool:
    """Whether a keyword is in the place of a new name, and the next token would fit the name."""
    token, before, following = reader.token, reader.before, reader.following
    if before[0] not in _BEFORE_NEW_NAME or not is_reserved(token[5]):
        return False
    if reader.automaton.accepts(NUMBER) or not reader.automaton.accepts(NAME):
        return False
    if following[0] == ASSIGN:
        return True
    beyond = Automaton()
    beyond.states = list(reader.automaton.states)
    beyond.feed(NAME)
    return before[3] == token[3] and beyond.accepts(following[0])


# --- sensors and arguments ----------------------------------------------------------------------------


def _read_misspelt_sensor(reader: TokenReader) -> bool:
    """If the name before was meant as a sensor, report it and read both words as its value: DISTANSIA F."""
    token, before = reader.token, reader.before
    if token[0] != NAME or before[0] != NAME or before[3] != token[3]:
        return False
    near = nearest_keyword(before[5], SENSORS, reader.language)
    if near is None or near.complete:
        return False
    reader.report(MistakeKind.UNKNOWN_COMMAND, before, "sensor", ("expression",), near.text)
    reader.mark_flaw()
    reader.at += 1
    return True


def _follows_taker(reader: TokenReader) -> bool:
    """Whether the word before takes a direction, an axis, a colour or a switch, on the same line."""
    return reader.before[0] in TAKES and reader.before[3] == reader.token[3]


def _read_bad_argument(reader: TokenReader) -> None:
    """Read a wrong argument, or a right one that was read as a name because an equals sign follows it."""
    token, taker = reader.token, reader.before
    terminal = TAKES[taker[0]]
    if argument(terminal, token[5]) is None:
        meant = ""
        if len(token[5]) > 2:
            preferred = argument_words(terminal, reader.language)
            words = [word for language in reader.spoken for word in argument_words(terminal, language)]
            meant = nearest(token[5], words, preferred) or ""
        _report_argument(reader, token, taker, "", meant)
    if reader.automaton.accepts(KIND[terminal]):
        reader.automaton.feed(KIND[terminal])
    reader.at += 1


def report_missing_argument(reader: TokenReader) -> None:
    _report_argument(reader, reader.before, reader.before, "missing-argument", "")


def _report_argument(reader: TokenReader, token: Token, taker: Token, code: str, meant: str) -> None:
    terminal = TAKES[taker[0]]
    details: dict[str, str | int] = {"word": TERMINALS[taker[0]]}
    if terminal == "COLOUR" and reader.colours is not None:
        details["wanted"] = ", ".join(sorted(reader.colours))
    reader.report(MistakeKind.BAD_ARGUMENT, token, code, (CLASSES[terminal],), meant, details)
