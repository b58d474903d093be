"""Mistakes as sentences: what is wrong, and what would put it right, in the learner's language.

A diagnostic's ``code`` chooses among the sentences of its kind; the kind's own is the one that always
exists. Phrasing of GoDonnie are spelled in the learner's language, what was typed is quoted as it was typed.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Callable

from donnie_tui.core.harmless import printable
from donnie_tui.i18n.catalogue.signs import CODE_OF
from donnie_tui.i18n.phrasing import Phrasing
from language import keywords
from language.diagnostics import Diagnostic, Kind
from language.keywords import argument_spelling, argument_words

LONGEST_QUOTE = 24
"""Characters of what was typed that are repeated in a sentence."""

MOST_EXPECTED = 4
"""More things than these are no help to hear: the sentence names none."""

_ARGUMENTS_OF = {"direction": "DIRECTION", "axis": "AXIS", "colour": "COLOUR", "on-or-off": "SWITCH"}


def mistake(diagnostic: Diagnostic, words: Phrasing) -> str:
    """What is wrong, in one sentence."""
    make = _SENTENCE_OF.get(diagnostic.kind, _plain)
    return make(diagnostic, words)


def hint(diagnostic: Diagnostic, words: Phrasing) -> str | None:
    """What would put it right, where that is known. Of arguments there are few: all are told besides."""
    make = _HINT_OF.get(diagnostic.kind)
    if not diagnostic.meant or diagnostic.meant_at is not None or diagnostic.code == "other-end":
        return make(diagnostic, words) if make else None
    meant = words("hint-meant", meant=diagnostic.meant)
    allowed = _hint_for_argument(diagnostic, words) if diagnostic.kind is Kind.BAD_ARGUMENT else None
    return f"{meant} {allowed}" if allowed else meant


def remark(diagnostic: Diagnostic, words: Phrasing) -> str:
    """A hint of the checker as one line: what it is about, and what would be better."""
    advice = hint(diagnostic, words)
    told = mistake(diagnostic, words)
    return f"{told} {advice}" if advice else told


# --- what is wrong


def _plain(diagnostic: Diagnostic, words: Phrasing) -> str:
    """The kind's own sentence, filled with whatever the diagnostic knows."""
    kind = diagnostic.kind.value
    special = f"mistake-{kind}-{diagnostic.code}"
    code = special if diagnostic.code and words.knows(special) else f"mistake-{kind}"
    return words(code, **_values(diagnostic, words))


def _syntax(diagnostic: Diagnostic, words: Phrasing) -> str:
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


def _unknown_character(diagnostic: Diagnostic, words: Phrasing) -> str:
    return words("mistake-unknown-character", sign=_sign(diagnostic.found[:1], words))


def _bad_argument(diagnostic: Diagnostic, words: Phrasing) -> str:
    if diagnostic.code:
        return _plain(diagnostic, words)
    word = diagnostic.details.get("word")
    code = "mistake-bad-argument-of" if word else "mistake-bad-argument"
    return words(code, found=_found(diagnostic, words), word=_spelled(str(word or ""), words))


def _wrong_end(diagnostic: Diagnostic, words: Phrasing) -> str:
    code = "mistake-wrong-end" if "opener" in diagnostic.details else "mistake-wrong-end-nothing-open"
    return words(code, **_values(diagnostic, words))


def _already_declared(diagnostic: Diagnostic, words: Phrasing) -> str:
    before = "-before" if "first_line" in diagnostic.details else ""
    return words(f"mistake-already-declared{before}", **_values(diagnostic, words))


def _undeclared_variable(diagnostic: Diagnostic, words: Phrasing) -> str:
    in_procedure = "-in-procedure" if "in_procedure" in diagnostic.details else ""
    return words(f"mistake-undeclared-variable{in_procedure}", **_values(diagnostic, words))


def _robot(diagnostic: Diagnostic, words: Phrasing) -> str:
    """What the robot can't do, by the code of its problem; in general words where there are none for it."""
    code = f"problem-{diagnostic.details.get('problem', '')}"
    if not words.knows(code):
        return _plain(diagnostic, words)
    bearing = str(diagnostic.details.get("bearing", ""))
    where = f"where-{bearing.replace(' ', '-')}"
    place = words(where) if words.knows(where) else bearing
    return words(code, **{"where": place, "reason": "", **diagnostic.details})


_SENTENCE_OF: dict[Kind, Callable[[Diagnostic, Phrasing], str]] = {
    Kind.SYNTAX: _syntax,
    Kind.UNKNOWN_CHARACTER: _unknown_character,
    Kind.BAD_ARGUMENT: _bad_argument,
    Kind.WRONG_END: _wrong_end,
    Kind.ALREADY_DECLARED: _already_declared,
    Kind.UNDECLARED_VARIABLE: _undeclared_variable,
    Kind.ROBOT: _robot,
}


# --- what would put it right


def _hint_by_code(diagnostic: Diagnostic, words: Phrasing) -> str | None:
    special = f"hint-{diagnostic.code}"
    if diagnostic.code and words.knows(special):
        return words(special, **_values(diagnostic, words))
    return None


def _hint_for_character(diagnostic: Diagnostic, words: Phrasing) -> str | None:
    code = {".": "hint-whole-numbers", "!": "hint-different", "'": "hint-double-quotes"}
    found = code.get(diagnostic.found[:1].replace("’", "'").replace("‘", "'"))
    return words(found) if found else None


def _hint_for_argument(diagnostic: Diagnostic, words: Phrasing) -> str | None:
    """The words that may stand there."""
    if diagnostic.code == "unseen-colour":
        colours = str(diagnostic.details.get("wanted", "")).split(", ")
        allowed = [argument_spelling(each, words.language) for each in colours if each]
    else:
        terminals = [_ARGUMENTS_OF[each] for each in diagnostic.expected if each in _ARGUMENTS_OF]
        allowed = [word for terminal in terminals for word in argument_words(terminal, words.language)]
    return words("hint-words", words=either(allowed, words)) if allowed else None


def _hint_for_closer(diagnostic: Diagnostic, words: Phrasing) -> str | None:
    return words("hint-write-closer", closer=_closer(diagnostic, words))


def _hint_for_wrong_end(diagnostic: Diagnostic, words: Phrasing) -> str | None:
    if "opener" not in diagnostic.details:
        return None
    return words("hint-expected-closer", closer=_closer(diagnostic, words))


def _hint_for_number(diagnostic: Diagnostic, words: Phrasing) -> str | None:
    """A limit of digits is small, a limit of the number itself is a large one."""
    limit = diagnostic.details.get("limit")
    if not isinstance(limit, int):
        return None
    return words("hint-digits" if limit < 100_000 else "hint-at-most", limit=limit)


def _hint_for_depth(diagnostic: Diagnostic, words: Phrasing) -> str | None:
    limit = diagnostic.details.get("limit")
    return words("hint-at-most", limit=limit) if limit else None


def _hint_for_variable(diagnostic: Diagnostic, words: Phrasing) -> str | None:
    if "in_procedure" in diagnostic.details:
        return words("hint-own-variables")
    return words("hint-declare", var=_spelled("VAR", words), name=_name(diagnostic))


def _hint_for_declared(diagnostic: Diagnostic, words: Phrasing) -> str | None:
    is_variable = diagnostic.details.get("what") == "variable"
    return words("hint-change-it", **_values(diagnostic, words)) if is_variable else None


def _hint_for_belt(_: Diagnostic, words: Phrasing) -> str:
    return words("hint-belt-on", belt=_spelled("BELT", words), on=argument_spelling(True, words.language))


_HINT_OF: dict[Kind, Callable[[Diagnostic, Phrasing], str | None]] = {
    Kind.SYNTAX: _hint_by_code,
    Kind.UNKNOWN_COMMAND: _hint_by_code,
    Kind.UNKNOWN_CHARACTER: _hint_for_character,
    Kind.INVALID_NAME: lambda _, words: words("hint-invalid-name"),
    Kind.RESERVED_WORD: lambda _, words: words("hint-reserved-word"),
    Kind.BAD_ARGUMENT: _hint_for_argument,
    Kind.MISSING_END: _hint_for_closer,
    Kind.WRONG_END: _hint_for_wrong_end,
    Kind.NUMBER_TOO_LARGE: _hint_for_number,
    Kind.UNDECLARED_VARIABLE: _hint_for_variable,
    Kind.UNDECLARED_PROCEDURE: lambda _, words: words(
        "hint-declare-procedure", procedure=_spelled("PROCEDURE", words)
    ),
    Kind.ALREADY_DECLARED: _hint_for_declared,
    Kind.TOO_DEEP: _hint_for_depth,
    Kind.RECURSION_LIMIT: lambda each, words: words("hint-call-depth", **_values(each, words)),
    Kind.TERMINAL_ONLY: lambda _, words: words("hint-terminal-only"),
    Kind.BELT_OFF: _hint_for_belt,
}


# --- parts of sentences


def _values(diagnostic: Diagnostic, words: Phrasing) -> dict[str, object]:
    """What the places of a sentence may be filled with."""
    values: dict[str, object] = {"name": _name(diagnostic), "limit": "", "word": "", "wanted": 0, "given": 0}
    values |= diagnostic.details
    values |= {"found": _found(diagnostic, words), "expected": _expected(diagnostic, words)}
    for key in ("opener", "word", "missing"):
        values[key] = _spelled(str(values.get(key, "")), words)
    values["closer"] = _closer(diagnostic, words)
    values |= {each: _spelled(each, words) for each in ("IF", "SPEAK", "VAR")}
    return values


def _name(diagnostic: Diagnostic) -> str:
    """The name as it was typed, else as the details have it."""
    return _shortened(diagnostic.found or str(diagnostic.details.get("name", "")))


def _closer(diagnostic: Diagnostic, words: Phrasing) -> str:
    """The word that closes what was opened."""
    opener = keywords.canonical(str(diagnostic.details.get("opener", ""))) or ""
    ends = [each for each in diagnostic.expected if each.startswith("END ")]
    return _spelled(ends[0] if ends else f"END {opener}", words)


def _expected(diagnostic: Diagnostic, words: Phrasing) -> str:
    """What was expected, as a list in words; empty if there was nothing, or too much to name."""
    if not 0 < len(diagnostic.expected) <= MOST_EXPECTED:
        return ""
    return either([_thing(each, words) for each in diagnostic.expected], words)


def either(things: list[str], words: Phrasing) -> str:
    """They as a list in words, each once."""
    distinct = list(dict.fromkeys(things))
    if len(distinct) < 2:
        return "".join(distinct)
    return words("or", first=", ".join(distinct[:-1]), last=distinct[-1])


def _thing(expected: str, words: Phrasing) -> str:
    """A word of GoDonnie, a sign, or a class of words."""
    if expected == "on-or-off":
        return either(list(argument_words("SWITCH", words.language)), words)
    code = f"class-{expected.replace(' ', '-')}"
    if expected.islower() and words.knows(code):
        return words(code)
    return _sign(expected, words) if expected in CODE_OF else _spelled(expected, words)


def _found(diagnostic: Diagnostic, words: Phrasing) -> str:
    found = " ".join(diagnostic.found.split())
    return _sign(found, words) if found in CODE_OF else _shortened(found)


def _sign(sign: str, words: Phrasing) -> str:
    if sign in CODE_OF:
        return words(CODE_OF[sign])
    shown = sign if sign.isprintable() and not unicodedata.combining(sign or " ") else ""
    return words("sign-other", sign=shown or f"U+{ord(sign or chr(0)):04X}")


def _spelled(word: str, words: Phrasing) -> str:
    """A canonical word in the learner's language, anything else as it is."""
    canonical = keywords.canonical(word)
    return keywords.spelling(canonical, words.language) if canonical else word


def _shortened(text: str) -> str:
    """As it was typed, but never long, and nothing that a terminal would obey."""
    shown = printable(" ".join(text.split()))
    return shown if len(shown) <= LONGEST_QUOTE else f"{shown[: LONGEST_QUOTE - 1]}…"
