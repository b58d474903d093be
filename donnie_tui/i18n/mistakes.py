"""Mistakes as sentences in the learner's language: in programs, for EXPLAIN, and in world files.

A diagnostic's ``code`` chooses among the sentences of its kind; the kind's own sentence always
exists. GoDonnie's words are spelled in the learner's language, typed text is quoted unchanged.
Details of this mistake (the probable meaning, its command) come before general advice about
its kind.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable
from functools import cache
from itertools import takewhile
from pathlib import PurePath
from typing import TYPE_CHECKING

from donnie_tui.core.events import Error
from donnie_tui.core.session_log import CODE_OF_SIGN
from donnie_tui.core.wording import Wording
from donnie_tui.i18n import help as helping
from language import keywords
from language.diagnostics import Diagnostic, MistakeKind
from language.keywords import argument_spelling, argument_words
from language.locales import ENGLISH, keys, languages
from language.locales import words as command_words
from language.source import fold_name, printable, quoted

if TYPE_CHECKING:
    from sim.scene import Note
    from sim.worldfile.mistakes import WorldError

LONGEST_QUOTE = 24
"""Characters of typed text that a sentence repeats."""

MOST_EXPECTED = 4
"""More things than these are no help: the sentence names none."""

_SAYS_WHAT_IS_MEANT = ("missing-argument", "number-word", "short-change", "text-quotes", "filler")
"""Codes whose sentence already says what was meant."""

_NAMES_NEEDED = ("missing-argument", "missing-first")
"""Codes whose sentence says what must follow the command."""

_HINT_OF_SIGN = {"--": "hint-comment", "<>": "hint-different"}
"""By the sign that was meant: what it is for, as a voice may not say it."""

_ARGUMENTS_OF = {"direction": "DIRECTION", "axis": "AXIS", "colour": "COLOUR", "on-or-off": "SWITCH"}


def mistake(diagnostic: Diagnostic, words: Wording) -> str:
    """The sentence that says what is wrong."""
    make = _SENTENCE_OF.get(diagnostic.kind, _plain)
    return make(diagnostic, words)


def hint(diagnostic: Diagnostic, words: Wording) -> str | None:
    """The fix, if it is known; for an argument with few values also all values."""
    make = _HINT_OF.get(diagnostic.kind)
    if diagnostic.meant and diagnostic.code in _SAYS_WHAT_IS_MEANT:
        return None
    if diagnostic.meant in _HINT_OF_SIGN:
        return words(_HINT_OF_SIGN[diagnostic.meant])
    is_text = diagnostic.meant.startswith('"')  # a voice says no quotation marks
    if not diagnostic.meant or diagnostic.meant_at is not None or is_text or diagnostic.code == "other-end":
        return make(diagnostic, words) if make else None
    meant = words("hint-meant", meant=diagnostic.meant)
    allowed = _hint_for_argument(diagnostic, words) if diagnostic.kind is MistakeKind.BAD_ARGUMENT else None
    return f"{meant} {allowed}" if allowed else meant


def remark(diagnostic: Diagnostic, words: Wording) -> str:
    """A hint of the checker as one line: its subject, and the better form."""
    advice = hint(diagnostic, words)
    sentence = mistake(diagnostic, words)
    return f"{sentence} {advice}" if advice else sentence


# --- what is wrong


def _plain(diagnostic: Diagnostic, words: Wording) -> str:
    """The kind's own sentence, filled with the values of the diagnostic."""
    kind = diagnostic.kind.value
    special = f"mistake-{kind}-{diagnostic.code}"
    detail, ending, other_ending = _ENDINGS.get(diagnostic.kind, ("", "", ""))
    own = f"mistake-{kind}{ending if detail in diagnostic.details else other_ending}"
    code = special if diagnostic.code and words.knows(special) else own
    return words(code, **_values(diagnostic, words))


_ENDINGS = {
    MistakeKind.BAD_ARGUMENT: ("word", "-of", ""),
    MistakeKind.WRONG_END: ("opener", "", "-nothing-open"),
    MistakeKind.ALREADY_DECLARED: ("first_line", "-before", ""),
    MistakeKind.UNDECLARED_VARIABLE: ("in_procedure", "-in-procedure", ""),
}
"""Kinds with two sentences: a detail, and the endings of their codes with it and without it."""


def _syntax(diagnostic: Diagnostic, words: Wording) -> str:
    if diagnostic.code in _NAMES_NEEDED:
        word, expected, example = _needed(diagnostic, words)
        return words(f"mistake-syntax-{diagnostic.code}", word=word, expected=expected, example=example)
    if diagnostic.code and words.knows(f"mistake-syntax-{diagnostic.code}"):
        return _plain(diagnostic, words)
    expected = _expected(diagnostic, words)
    if diagnostic.found and not expected:
        return words("mistake-syntax-misplaced", found=_found(diagnostic, words))
    if diagnostic.found:
        return words("mistake-syntax", found=_found(diagnostic, words), expected=expected)
    if expected:
        return words("mistake-syntax-at-end", expected=expected)
    return words("mistake-syntax-cut-off")


def _needed(diagnostic: Diagnostic, words: Wording) -> tuple[str, str, str]:
    """The command, what must follow it, and an example of both."""
    word = str(diagnostic.details["word"])
    classes, example = helping.needs(word, words)
    return _spelled(word, words), either([_thing(each, words) for each in classes], words), example


def _unknown_character(diagnostic: Diagnostic, words: Wording) -> str:
    found = unicodedata.normalize("NFC", diagnostic.found)
    if diagnostic.meant == "--":
        return words("mistake-unknown-character", sign=_found(diagnostic, words))
    marks = takewhile(unicodedata.combining, found[1:])
    return words("mistake-unknown-character", sign=_sign(found[:1] + "".join(marks), words))


def _robot(diagnostic: Diagnostic, words: Wording) -> str:
    """The sentence about what the robot can't do, by the code of its problem, else a general one."""
    code = f"problem-{diagnostic.details.get('problem', '')}"
    if not words.knows(code):
        return _plain(diagnostic, words)
    bearing = str(diagnostic.details.get("bearing", ""))
    where = f"where-{bearing.replace(' ', '-')}"
    place = words(where) if words.knows(where) else bearing
    return words(code, **{"where": place, "reason": "", **diagnostic.details})


_SENTENCE_OF: dict[MistakeKind, Callable[[Diagnostic, Wording], str]] = {
    MistakeKind.SYNTAX: _syntax,
    MistakeKind.UNKNOWN_CHARACTER: _unknown_character,
    MistakeKind.ROBOT: _robot,
}


# --- what would put it right


def _hint_by_code(diagnostic: Diagnostic, words: Wording) -> str | None:
    special = f"hint-{diagnostic.code}"
    if diagnostic.code and words.knows(special):
        return words(special, **_values(diagnostic, words))
    return None


def _hint_for_syntax(diagnostic: Diagnostic, words: Wording) -> str | None:
    if diagnostic.code == "missing-first":
        return words("help-example", example=_needed(diagnostic, words)[-1]) + "."
    return _hint_by_code(diagnostic, words)


def _hint_for_command(diagnostic: Diagnostic, words: Wording) -> str | None:
    """A command of the front ends, such as WHERE, that was written into a program."""
    advice = _hint_by_code(diagnostic, words)
    if advice is None and fold_name(diagnostic.found) in _command_words():
        return words("hint-command-alone", found=_found(diagnostic, words).upper())
    return advice


@cache
def _command_words() -> frozenset[str]:
    """The commands of one word in all languages; letters such as N are names in programs."""
    names = keys(ENGLISH, "commands")
    spelled = (
        word for each in languages() for name in names for word in command_words(each, "commands", name)
    )
    return frozenset(fold_name(word) for word in spelled if len(word) > 1)


_HINT_OF_CHARACTER = {
    ".": "hint-whole-numbers",
    **dict.fromkeys("'«»", "hint-double-quotes"),
    "#": "hint-comment",
    "%": "hint-remainder",
    "&": "hint-second-comparison",
    "|": "hint-other-comparison",
}


def _hint_for_character(diagnostic: Diagnostic, words: Wording) -> str | None:
    found = _HINT_OF_CHARACTER.get(diagnostic.found[:1].replace("’", "'").replace("‘", "'"))
    return words(found, IF=_spelled("IF", words)) if found else None


def _hint_for_argument(diagnostic: Diagnostic, words: Wording) -> str | None:
    """The possible words at that place."""
    if diagnostic.code == "unseen-colour":
        colours = str(diagnostic.details.get("wanted", "")).split(", ")
        allowed = [argument_spelling(each, words.language) for each in colours if each]
    else:
        terminals = [_ARGUMENTS_OF[each] for each in diagnostic.expected if each in _ARGUMENTS_OF]
        allowed = [word for terminal in terminals for word in argument_words(terminal, words.language)]
    return words("hint-words", words=either(allowed, words)) if allowed else None


def _hint_for_closer(diagnostic: Diagnostic, words: Wording) -> str | None:
    if diagnostic.code == "else-if":
        return _hint_by_code(diagnostic, words)
    return words("hint-write-closer", closer=_closer(diagnostic, words))


def _hint_for_wrong_end(diagnostic: Diagnostic, words: Wording) -> str | None:
    if "opener" not in diagnostic.details:
        return None
    return words("hint-expected-closer", closer=_closer(diagnostic, words))


def _hint_for_number(diagnostic: Diagnostic, words: Wording) -> str | None:
    """A limit of digits is small, a limit of the number itself is a large one."""
    limit = diagnostic.details.get("limit")
    if not isinstance(limit, int):
        return None
    return words("hint-digits" if limit < 100_000 else "hint-at-most", limit=limit)


def _hint_for_depth(diagnostic: Diagnostic, words: Wording) -> str | None:
    limit = diagnostic.details.get("limit")
    return words("hint-at-most", limit=limit) if limit else None


def _hint_for_robot(diagnostic: Diagnostic, words: Wording) -> str | None:
    code = f"hint-{diagnostic.details.get('problem', '')}"
    return words(code) if words.knows(code) else None


def _hint_for_variable(diagnostic: Diagnostic, words: Wording) -> str | None:
    if "in_procedure" in diagnostic.details:
        return words("hint-own-variables")
    if diagnostic.code:
        return _hint_by_code(diagnostic, words)
    return words("hint-declare", var=_spelled("VAR", words), name=_name(diagnostic))


def _hint_for_declared(diagnostic: Diagnostic, words: Wording) -> str:
    is_variable = diagnostic.details.get("what") == "variable"
    return words("hint-change-it" if is_variable else "hint-reserved-word", **_values(diagnostic, words))


def _hint_for_belt(_: Diagnostic, words: Wording) -> str:
    return words("hint-belt-on", belt=_spelled("BELT", words), on=argument_spelling(True, words.language))


_HINT_OF: dict[MistakeKind, Callable[[Diagnostic, Wording], str | None]] = {
    MistakeKind.SYNTAX: _hint_for_syntax,
    MistakeKind.UNKNOWN_COMMAND: _hint_for_command,
    MistakeKind.UNKNOWN_CHARACTER: _hint_for_character,
    MistakeKind.INVALID_NAME: lambda _, words: words("hint-invalid-name"),
    MistakeKind.RESERVED_WORD: lambda _, words: words("hint-reserved-word"),
    MistakeKind.BAD_ARGUMENT: _hint_for_argument,
    MistakeKind.MISSING_END: _hint_for_closer,
    MistakeKind.WRONG_END: _hint_for_wrong_end,
    MistakeKind.NUMBER_TOO_LARGE: _hint_for_number,
    MistakeKind.UNDECLARED_VARIABLE: _hint_for_variable,
    MistakeKind.UNDECLARED_PROCEDURE: lambda _, words: words(
        "hint-declare-procedure", procedure=_spelled("PROCEDURE", words)
    ),
    MistakeKind.ALREADY_DECLARED: _hint_for_declared,
    MistakeKind.TOO_DEEP: _hint_for_depth,
    MistakeKind.ROBOT: _hint_for_robot,
    MistakeKind.RECURSION_LIMIT: lambda each, words: words("hint-call-depth", **_values(each, words)),
    MistakeKind.TERMINAL_ONLY: lambda _, words: words("hint-terminal-only"),
    MistakeKind.BELT_OFF: _hint_for_belt,
}


# --- parts of sentences


def _values(diagnostic: Diagnostic, words: Wording) -> dict[str, object]:
    """The values for the placeholders of a sentence."""
    values: dict[str, object] = {"name": diagnostic.found, "limit": "", "wanted": 0, "given": 0}
    values |= diagnostic.details
    values |= {key: quoted(str(values.get(key, "")), LONGEST_QUOTE) for key in ("name", "in_procedure")}
    values |= {"found": _found(diagnostic, words), "expected": _expected(diagnostic, words)}
    for key in ("opener", "word", "missing"):
        values[key] = _spelled(str(values.get(key, "")), words)
    values["closer"] = _closer(diagnostic, words)
    values |= {each: _spelled(each, words) for each in ("ELSE", "IF", "SPEAK", "VAR")}
    return values


def _name(diagnostic: Diagnostic) -> str:
    """The name as typed, else from the details."""
    return quoted(diagnostic.found or str(diagnostic.details.get("name", "")), LONGEST_QUOTE)


def _closer(diagnostic: Diagnostic, words: Wording) -> str:
    """The word that closes the open block."""
    opener = keywords.canonical(str(diagnostic.details.get("opener", ""))) or ""
    ends = [each for each in diagnostic.expected if each.startswith("END ")]
    return _spelled(ends[0] if ends else f"END {opener}", words)


def _expected(diagnostic: Diagnostic, words: Wording) -> str:
    """The expected tokens as a list in words; empty if there are none, or too many to name."""
    if not 0 < len(diagnostic.expected) <= MOST_EXPECTED:
        return ""
    return either([_thing(each, words) for each in diagnostic.expected], words)


def either(things: list[str], words: Wording) -> str:
    """The things as a list in words, each once."""
    distinct = list(dict.fromkeys(things))
    if len(distinct) < 2:
        return "".join(distinct)
    return words("or", first=", ".join(distinct[:-1]), last=distinct[-1])


def _thing(expected: str, words: Wording) -> str:
    """A word of GoDonnie, a sign, or a class of words."""
    if expected == "on-or-off":
        return either(list(argument_words("SWITCH", words.language)), words)
    code = f"class-{expected.replace(' ', '-')}"
    if expected.islower() and words.knows(code):
        return words(code)
    return _sign(expected, words) if expected in CODE_OF_SIGN else _spelled(expected, words)


def _found(diagnostic: Diagnostic, words: Wording) -> str:
    found = " ".join(diagnostic.found.split())
    return _sign(found, words) if found in CODE_OF_SIGN else quoted(found, LONGEST_QUOTE)


def _sign(sign: str, words: Wording) -> str:
    if sign in CODE_OF_SIGN:
        return words(CODE_OF_SIGN[sign])
    shown = sign if sign.isprintable() and not unicodedata.combining(sign[:1] or " ") else ""
    return words("sign-other", sign=shown or f"U+{ord(sign[:1] or chr(0)):04X}")


def _spelled(word: str, words: Wording) -> str:
    """A canonical word in the learner's language, anything else as it is."""
    canonical = keywords.canonical(word)
    return keywords.spelling(canonical, words.language) if canonical else word


# --- EXPLAIN

_FORM_HELPS = {MistakeKind.SYNTAX.value, MistakeKind.BAD_ARGUMENT.value}
"""Kinds for which the form of the command says what is missing."""
_HINT_IS_ADVICE = {
    MistakeKind.UNKNOWN_CHARACTER.value,
    MistakeKind.BAD_ARGUMENT.value,
    MistakeKind.MISSING_END.value,
    MistakeKind.WRONG_END.value,
    MistakeKind.ALREADY_DECLARED.value,
}
"""Kinds whose hint is better than the general advice."""
_TOPIC_OF = {
    MistakeKind.UNDECLARED_PROCEDURE.value: "PROCEDURE",
    MistakeKind.TOO_DEEP.value: "PROCEDURE",
    MistakeKind.RECURSION_LIMIT.value: "IF",
}
"""The help topic of a kind, whatever its command."""
_HAS_COMMAND = _FORM_HELPS | {MistakeKind.MISSING_END.value, MistakeKind.WRONG_END.value}


def explanation(error: Error, words: Wording) -> tuple[str, ...]:
    """The meaning of a mistake, what to do, and an example; a sentence each."""
    if _is_of_numbers(error):
        return words("explain-whole-numbers"), words("advice-whole-numbers")
    code = f"explain-{error.kind}-{error.code}"
    meaning = words(code if error.code and words.knows(code) else f"explain-{error.kind}")
    if error.code == "spoken" or (
        error.kind == MistakeKind.UNDECLARED_VARIABLE.value and error.topic == "SPEAK" and not error.meant
    ):
        return meaning, words(f"advice-{error.kind}"), words("advice-text-without-quotes")
    topic = _topic(error)
    example = words("help-example", example=helping.example(topic, words)) + "." if topic else ""
    return tuple(filter(None, (meaning, *_advice(error, topic, words), example)))


def _is_of_numbers(error: Error) -> bool:
    """Whether the mistake is a number that is not whole: 2,5 or 2.5."""
    is_point = error.kind == MistakeKind.UNKNOWN_CHARACTER.value and re.search(r"\d\.\d", error.source_line)
    return error.code == "whole-numbers" or bool(is_point)


def _advice(error: Error, topic: str, words: Wording) -> tuple[str, ...]:
    is_known = bool(error.meant) or error.code == "procedure" or error.kind in _HINT_IS_ADVICE
    hint = (error.hint,) if error.hint and is_known else ()
    if topic and error.kind in _FORM_HELPS:
        return (*hint, *helping.form_sentences(topic, words))
    return hint or (words(f"advice-{error.kind}"),)


def _topic(error: Error) -> str:
    """The command of which an example helps; empty if there is none, or the advice has one."""
    if error.kind == MistakeKind.UNKNOWN_COMMAND.value:
        meant = keywords.topic(error.meant) or keywords.topic_at(error.meant, 1)
        return "PROCEDURE" if error.code == "procedure" else meant
    if error.kind in _HAS_COMMAND:
        is_assignment = not error.topic and "=" in error.source_line
        return "VAR" if is_assignment else error.topic
    return _TOPIC_OF.get(error.kind, "")


# --- world files

_WITHOUT_PLACE = ("is-folder", "file-no-file", "file-not-found", "file-unreadable", "file-too-large")
"""Codes about the file as a whole, if the file is the world itself."""


def world_mistake(error: WorldError, words: Wording) -> str:
    """A sentence with the place; control characters of the file are shown as text."""
    message = printable(_world_message(error, words))
    nearest = error.details.get("nearest")
    if nearest:
        message = words("world-meant", message=message, near=printable(str(nearest)))
    if error.code.value in _WITHOUT_PLACE and error.details.get("path") == error.file:
        return message
    return words("world-error-at", file=error.file, line=error.line, column=error.column, message=message)


def world_note(note: Note, words: Wording) -> str:
    """A remark of a load report, with its place if it has one."""
    details = dict(note.details)
    if note.code == "unknown-colour":
        details["nearest"] = _colour_in_english(str(details.get("name", ""))) or details.get("nearest", "")
    near = "-near" if details.get("nearest") and words.knows(f"note-{note.code}-near") else ""
    remark = printable(words(f"note-{note.code}{near}", **details))
    if not note.line:
        return remark
    return words("note-at", line=note.line, column=note.column, file=PurePath(note.file).name, remark=remark)


def _colour_in_english(name: str) -> str:
    """The English word of a colour in a learner's language, as world files are English."""
    colour = keywords.argument("COLOUR", name)
    return str(colour.value) if colour else ""


def _world_message(error: WorldError, words: Wording) -> str:
    expected = either([_world_thing(each, words) for each in error.expected], words)
    values = {**dict.fromkeys(("name", "given", "limit", "path", "reason"), ""), "expected": expected}
    found = str(error.details.get("found", ""))
    filled = {**values, **error.details, "found": _found_in_world(found, words)}
    return words(_world_code(error, found, expected), **filled)


def _world_code(error: WorldError, found: str, expected: str) -> str:
    """The code of the sentence; "unexpected" lists what was expected if that is short."""
    code = error.code.value
    if code == "wrong-count" and not expected:
        return "world-too-many"
    if code.endswith("-outside") and not error.details.get("folder"):
        return f"world-{code}-confined"
    if code == "too-much" and "what" in error.details:
        return f"world-too-much-{error.details['what']}"
    if code != "unexpected" or not 0 < len(error.expected) <= 4:
        return f"world-{code}"
    return "world-unexpected-expecting" if found else "world-unexpected-end"


def _found_in_world(found: str, words: Wording) -> str:
    """The text at the mistake; an invisible character by its name."""
    if len(found) == 1 and not found.isprintable():
        return words("world-control-character")
    return words(CODE_OF_SIGN[found]) if found in CODE_OF_SIGN else found


def _world_thing(expected: str, words: Wording) -> str:
    if words.knows(f"world-expected-{expected}"):
        return words(f"world-expected-{expected}")
    return words(CODE_OF_SIGN[expected]) if expected in CODE_OF_SIGN else expected
