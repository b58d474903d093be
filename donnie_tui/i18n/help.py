"""HELP: the list of commands, and for each its purpose, its form and one example, in three languages.

Forms and examples are templates: ``{REPEAT}`` is spelled in the learner's language, ``{commands}`` stands
for something else. The tests parse every example in every language.
"""

from __future__ import annotations

import re

from devices.ports.values import Frozen
from donnie_tui.i18n.phrasing import Phrasing
from language import keywords


class Entry(Frozen):
    """One command: how it is written, and used. ``leaders`` are the words that it may begin with."""

    leaders: tuple[str, ...]
    rest: str
    example: str
    """What stands behind the leader."""


ENTRIES: dict[str, Entry] = {
    "FW": Entry(("FW", "FORWARD"), "{value}", "{FW} 5"),
    "BW": Entry(("BW", "BACKWARD"), "{value}", "{BW} 5"),
    "TR": Entry(("TR", "RIGHT TURN"), "{value}", "{TR} 90"),
    "TL": Entry(("TL", "LEFT TURN"), "{value}", "{TL} 90"),
    "SPEAK": Entry(("SPEAK",), '"{text}"', '{SPEAK} "{hello}"'),
    "SCAN": Entry(("SCAN",), "", "{SCAN}"),
    "STATE": Entry(("STATE",), "", "{FW} 3 {STATE}"),
    "HISTORY": Entry(("HISTORY",), "", "{FW} 3 {TR} 90 {HISTORY}"),
    "POS": Entry(("POS", "POSITION"), "X, Y, A", "{SPEAK} {POS} X"),
    "DISTANCE": Entry(("DISTANCE",), "{direction}", "{SPEAK} {DISTANCE} F"),
    "COLOR": Entry(("COLOR",), "{colour}", "{SPEAK} {COLOR} {red}"),
    "VAR": Entry(("VAR",), "{name} = {value}", "{VAR} a = 5"),
    "IF": Entry(
        ("IF",),
        "{condition} {THEN} {commands} {ELSE} {commands} {END IF}",
        "{IF} {DISTANCE} F > 3 {THEN} {FW} 1 {ELSE} {TR} 90 {END IF}",
    ),
    "REPEAT": Entry(
        ("REPEAT",),
        "{value} {TIMES} {commands} {END REPEAT}",
        "{REPEAT} 4 {TIMES} {FW} 2 {TR} 90 {END REPEAT}",
    ),
    "WHILE": Entry(
        ("WHILE",),
        "{condition} {DO} {commands} {END WHILE}",
        "{WHILE} {DISTANCE} F > 3 {DO} {FW} 1 {END WHILE}",
    ),
    "FOR": Entry(
        ("FOR",),
        "{name} = {value}; {condition}; {name} = {value} {DO} {commands} {END FOR}",
        "{FOR} {VAR} i = 1; i <= 3; i = i + 1 {DO} {SPEAK} i {END FOR}",
    ),
    "PROCEDURE": Entry(
        ("PROCEDURE",),
        "{name}: {name} {DO} {commands} {END PROCEDURE}",
        "{PROCEDURE} P: n {DO} {FW} n {END PROCEDURE} P [3]",
    ),
    "WAIT": Entry(("WAIT",), "{value}", "{WAIT} 3"),
    "SOUND": Entry(("SOUND",), "{ON}, {OFF}", "{SOUND} {OFF}"),
    "BELT": Entry(("BELT",), "{ON}, {OFF}", "{BELT} {ON}"),
    "VIBRATE": Entry(("VIBRATE",), "{direction}", "{BELT} {ON} {VIBRATE} F"),
    "RUN": Entry(("RUN",), "", "{RUN}"),
    "HELP": Entry(("HELP",), "{word}", "{HELP} {FW}"),
    "QUIT": Entry(("QUIT", "EXIT"), "", "{QUIT}"),
}
"""By topic, in the order in which a learner needs them."""

_PLACE = re.compile(r"\{([^{}]+)\}")


def help_lines(topic: str | None, words: Phrasing) -> tuple[str, ...]:
    """The list, or what there is to say about a word of any language."""
    if topic is None:
        return _list(words)
    found = keywords.topic(topic)
    return _unknown(topic, words) if found is None else _entry(found, words)


def _list(words: Phrasing) -> tuple[str, ...]:
    first = words("help-list", count=len(ENTRIES), help=_spelled("HELP", words))
    return (first, *(_purpose(topic, words) for topic in ENTRIES))


def _purpose(topic: str, words: Phrasing) -> str:
    return words("help-purpose", word=_spelled(topic, words), purpose=words(f"purpose-{topic}"))


def _entry(topic: str, words: Phrasing) -> tuple[str, ...]:
    return (
        _purpose(topic, words),
        form(topic, words),
        words("help-example", example=example(topic, words)) + ".",
    )


def form(topic: str, words: Phrasing) -> str:
    """How the command is written, as a sentence."""
    return words("help-form", form=_forms(ENTRIES[topic], words)) + "."


def _forms(entry: Entry, words: Phrasing) -> str:
    spelled = dict.fromkeys(_spelled(leader, words) for leader in entry.leaders)
    rest = _filled(entry.rest, words)
    forms = [f"{leader} {rest}".strip() for leader in spelled]
    return forms[0] if len(forms) == 1 else words("help-or", first=forms[0], second=forms[1])


def example(topic: str, words: Phrasing) -> str:
    """A program that shows the command, in the learner's language."""
    return _filled(ENTRIES[topic].example, words)


def _filled(template: str, words: Phrasing) -> str:
    return _PLACE.sub(lambda place: _spelled(place[1], words), template)


def _spelled(place: str, words: Phrasing) -> str:
    """A keyword, a word behind one (``ON``, ``red``), or what a placeholder is called."""
    if place in ("ON", "OFF"):
        return keywords.argument_spelling(place == "ON", words.language)
    if place == "red":
        return keywords.argument_spelling(place, words.language)
    if place.islower():
        return words(f"form-{place}")
    return keywords.spelling(place, words.language)


def _unknown(topic: str, words: Phrasing) -> tuple[str, ...]:
    shown = topic[:30]
    known = {word.lower(): word for word in keywords.all_words()}
    import difflib

    near = difflib.get_close_matches(shown.lower(), known, n=1, cutoff=0.7)
    if near:
        return (words("help-unknown-near", topic=shown, near=known[near[0]]),)
    return (words("help-unknown", topic=shown, help=_spelled("HELP", words)),)
