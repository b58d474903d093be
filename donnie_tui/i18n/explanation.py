"""EXPLAIN: a mistake again in plain words, what would put it right, and an example of the word at hand.

Rule: whatever is known of this one mistake (what was meant, the command it is in) is told before what can be
said of all mistakes of its kind.
"""

from __future__ import annotations

import re

from donnie_tui.core.events import Error
from donnie_tui.i18n import help as helping
from donnie_tui.i18n.phrasing import Phrasing
from language import keywords
from language.diagnostics import Kind

_TELLS_ITS_FORM = {Kind.SYNTAX.value, Kind.BAD_ARGUMENT.value}
"""Kinds for which the form of the command says what is missing."""
_HINT_IS_ADVICE = {
    Kind.UNKNOWN_CHARACTER.value,
    Kind.BAD_ARGUMENT.value,
    Kind.MISSING_END.value,
    Kind.WRONG_END.value,
}
"""Kinds whose hint says more than what can be said of all of them."""
_TOPIC_OF = {
    Kind.UNDECLARED_PROCEDURE.value: "PROCEDURE",
    Kind.TOO_DEEP.value: "PROCEDURE",
    Kind.RECURSION_LIMIT.value: "IF",
}
"""What helps against a kind, whatever command it is in."""
_HAS_COMMAND = _TELLS_ITS_FORM | {Kind.MISSING_END.value, Kind.WRONG_END.value}


def explanation(error: Error, words: Phrasing) -> tuple[str, ...]:
    """What it means, what to do, and an example; a sentence each."""
    if _is_of_numbers(error):
        return words("explain-whole-numbers"), words("mend-whole-numbers")
    what = f"explain-{error.kind}-{error.code}"
    told = words(what if error.code and words.knows(what) else f"explain-{error.kind}")
    if error.kind == Kind.UNDECLARED_VARIABLE.value and error.topic == "SPEAK" and not error.meant:
        return told, *_advice(error, "", words), words("mend-text-without-quotes")
    topic = _topic(error)
    example = words("help-example", example=helping.example(topic, words)) + "." if topic else ""
    return tuple(filter(None, (told, *_advice(error, topic, words), example)))


def _is_of_numbers(error: Error) -> bool:
    """A number that is not whole: 2,5 or 2.5."""
    is_point = error.kind == Kind.UNKNOWN_CHARACTER.value and re.search(r"\d\.\d", error.source_line)
    return error.code == "whole-numbers" or bool(is_point)


def _advice(error: Error, topic: str, words: Phrasing) -> tuple[str, ...]:
    is_known = bool(error.meant) or error.code == "procedure" or error.kind in _HINT_IS_ADVICE
    hint = (error.hint,) if error.hint and is_known else ()
    if topic and error.kind in _TELLS_ITS_FORM:
        return (*hint, helping.form(topic, words))
    return hint or (words(f"mend-{error.kind}"),)


def _topic(error: Error) -> str:
    """The command of which an example helps; empty where there is none, or the advice has one."""
    if error.kind == Kind.UNKNOWN_COMMAND.value:
        return "PROCEDURE" if error.code == "procedure" else keywords.topic(error.meant) or ""
    if error.kind in _HAS_COMMAND:
        is_assignment = not error.topic and "=" in error.source_line
        return "VAR" if is_assignment else error.topic
    return _TOPIC_OF.get(error.kind, "")
