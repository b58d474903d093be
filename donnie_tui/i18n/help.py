"""HELP, the manual of GoDonnie and the tour.

HELP lists GoDonnie's commands, each with its purpose, its form and one example.

Forms and examples are templates: ``{REPEAT}`` is spelled in the learner's language, ``{commands}`` is a name
for statements. The tests parse every example in every language.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import count, takewhile
from textwrap import wrap
from types import MappingProxyType

from msgspec import Struct

from donnie_tui.core.reports import Section
from donnie_tui.core.wording import BRAILLE_CELLS, Wording
from language import keywords
from language.locales import first_page
from language.source import fold_name, quoted
from language.suggestions import SAMPLES, everyday


class HelpTopic(Struct, frozen=True):
    """The form and example of a command. ``leaders`` are the words that it may begin with."""

    leaders: tuple[str, ...]
    rest: str
    """The form after the leader."""
    example: str
    """A program that uses it."""
    other: str = ""
    """Another form after the leader."""


ENTRIES: dict[str, HelpTopic] = {
    "FW": HelpTopic(("FW", "FORWARD"), "{value}", "{FW} 5"),
    "BW": HelpTopic(("BW", "BACKWARD"), "{value}", "{BW} 5"),
    "TR": HelpTopic(("TR", "RIGHT TURN"), "{value}", "{TR} 90"),
    "TL": HelpTopic(("TL", "LEFT TURN"), "{value}", "{TL} 90"),
    "SPEAK": HelpTopic(("SPEAK",), '"{text}"', '{SPEAK} "{hello}"'),
    "SCAN": HelpTopic(("SCAN",), "", "{SCAN}"),
    "STATE": HelpTopic(("STATE",), "", "{FW} 3 {STATE}"),
    "HISTORY": HelpTopic(("HISTORY",), "", "{FW} 3 {TR} 90 {HISTORY}"),
    "POS": HelpTopic(("POS", "POSITION"), "X, Y, A", "{SPEAK} {POS} X"),
    "DISTANCE": HelpTopic(("DISTANCE",), "{direction}", "{SPEAK} {DISTANCE} F", '"{sensor}"'),
    "COLOR": HelpTopic(("COLOR",), "{colour}", "{SPEAK} {COLOR} {red}"),
    "GRIP": HelpTopic(("GRIP",), "", "{FW} 3 {GRIP}"),
    "RELEASE": HelpTopic(("RELEASE",), "", "{GRIP} {BW} 3 {RELEASE}"),
    "VAR": HelpTopic(("VAR",), "{name} = {value}", "{VAR} a = 5"),
    "IF": HelpTopic(
        ("IF",),
        "{condition} {THEN} {commands} {ELSE} {commands} {END IF}",
        "{IF} {DISTANCE} F > 3 {THEN} {FW} 1 {ELSE} {TR} 90 {END IF}",
    ),
    "REPEAT": HelpTopic(
        ("REPEAT",),
        "{value} {TIMES} {commands} {END REPEAT}",
        "{REPEAT} 4 {TIMES} {FW} 2 {TR} 90 {END REPEAT}",
    ),
    "WHILE": HelpTopic(
        ("WHILE",),
        "{condition} {DO} {commands} {END WHILE}",
        "{WHILE} {DISTANCE} F > 3 {DO} {FW} 1 {END WHILE}",
    ),
    "FOR": HelpTopic(
        ("FOR",),
        "{VAR} {name} = {value}; {condition}; {name} = {value} {DO} {commands} {END FOR}",
        "{FOR} {VAR} i = 1; i <= 3; i = i + 1 {DO} {SPEAK} i {END FOR}",
    ),
    "PROCEDURE": HelpTopic(
        ("PROCEDURE",),
        "{name}: {name} {DO} {commands} {END PROCEDURE}",
        "{PROCEDURE} P: n {DO} {FW} n {END PROCEDURE} P [3]",
    ),
    "WAIT": HelpTopic(("WAIT",), "{value}", "{WAIT} 3"),
    "SOUND": HelpTopic(("SOUND",), "{ON}, {OFF}", "{SOUND} {OFF}"),
    "BELT": HelpTopic(("BELT",), "{ON}, {OFF}", "{BELT} {ON}"),
    "VIBRATE": HelpTopic(("VIBRATE",), "{direction}", "{BELT} {ON} {VIBRATE} F"),
    "RUN": HelpTopic(("RUN",), "", "{RUN}"),
    "HELP": HelpTopic(("HELP",), "{word}", "{HELP} {FW}"),
    "QUIT": HelpTopic(("QUIT", "EXIT"), "", "{QUIT}"),
}
"""The topics, in the order in which a learner needs them."""

_NEEDS = {
    "SPEAK": (("text",), '"{hello}"'),
    "VAR": (("name",), "a = 5"),
    "IF": (("comparison",), "a > 3 {THEN}"),
    "WHILE": (("comparison",), "a > 3 {DO}"),
    "REPEAT": (("number",), "4 {TIMES}"),
    "FOR": (("name",), "{VAR} i = 1"),
    "PROCEDURE": (("name",), "P {DO}"),
}
"""By topic: the classes of words that must follow the command, and an example."""

_PLACE = re.compile(r"\{([^{}]+)\}")


def help_lines(topic: str | None, words: Wording) -> tuple[str, ...]:
    """The list of commands, or the help of a word of any language."""
    if topic is None:
        return _list(words)
    found = said_for(topic, words)
    return _unknown(topic, words) if found is None else _entry(found, words)


def said_for(typed: str, words: Wording) -> str | None:
    """The topic of a GoDonnie word, or of a beginner's word for it, such as WALK or TURN LEFT."""
    found = keywords.topic(typed)
    said = typed.split() if found is None else ()
    beginning = everyday([fold_name(each) for each in said], (words.language,))
    return beginning.terminal if beginning and beginning.width == len(said) else found


def _list(words: Wording) -> tuple[str, ...]:
    first = words("help-list", count=len(ENTRIES), help=_spelled("HELP", words))
    return (first, *(_purpose(topic, words) for topic in ENTRIES))


def _purpose(topic: str, words: Wording) -> str:
    word, code = _spelled(topic, words), f"purpose-{topic}"
    return words("help-purpose", word=word, purpose=words(code)) if words.knows(code) else f"{word}."


def _entry(topic: str, words: Wording) -> tuple[str, ...]:
    return (
        _purpose(topic, words),
        *form_sentences(topic, words),
        words("help-example", example=example(topic, words)) + ".",
    )


def form_sentences(topic: str, words: Wording) -> Iterator[str]:
    """The sentences about the form of the command."""
    entry = ENTRIES[topic]
    for each in (entry.rest, entry.other) if entry.other else (entry.rest,):
        yield words("help-form", form=forms(entry.leaders, each, words)) + "."


def forms(leaders: Sequence[str], rest: str, words: Wording) -> str:
    """Every form of the command: ``FW value, or FORWARD value``."""
    spelled = dict.fromkeys(_spelled(leader, words) for leader in leaders)
    rest = _filled(rest, words)
    forms = [f"{leader} {rest}".strip() for leader in spelled]
    return forms[0] if len(forms) == 1 else words("help-or", first=forms[0], second=forms[1])


def example(topic: str, words: Wording) -> str:
    """A program that shows the command, in the learner's language."""
    return _filled(ENTRIES[topic].example, words)


def needs(word: str, words: Wording) -> tuple[tuple[str, ...], str]:
    """The classes of words that must follow a GoDonnie word, and an example with it."""
    topic = keywords.topic(word) or ""
    classes, rest = _NEEDS.get(topic) or (("number",), SAMPLES.get(topic, ""))
    return classes, f"{_spelled(word, words)} {_filled(rest, words)}".strip()


def _filled(template: str, words: Wording) -> str:
    return _PLACE.sub(lambda place: _spelled(place[1], words), template)


def _spelled(place: str, words: Wording) -> str:
    """The spelling of a keyword, an argument (``ON``, ``red``) or a placeholder."""
    if place in ("ON", "OFF"):
        return keywords.argument_spelling(place == "ON", words.language)
    if place == "red":
        return keywords.argument_spelling(place, words.language)
    if place.islower():
        return words(f"form-{place}")
    return keywords.spelling(place, words.language)


def _unknown(topic: str, words: Wording) -> tuple[str, ...]:
    shown = quoted(topic)
    known = {word.lower(): word for word in keywords.all_words()}
    import difflib

    near = difflib.get_close_matches(shown.lower(), known, cutoff=0.7)
    if near:
        return (words("help-unknown-near", topic=shown, near=known[near[0]]),)
    return (words("help-unknown", topic=shown, help=_spelled("HELP", words)),)


# --- the manual

CHAPTERS = ("begin", "move", "look", "numbers", "decide", "repeat", "procedures", "mistakes")


def manual(words: Wording) -> tuple[str, ...]:
    """The lines of the manual, in the learner's language."""
    lines: list[str] = []
    for chapter in CHAPTERS:
        lines.append(words(f"manual-{chapter}").upper())
        lines.extend(words(f"manual-{chapter}-text").split("\n"))
        lines.append("")
    page = first_page(words.language)
    document = (words("first-page", file=page),) if page else ()
    return (*lines, words("manual-commands").upper(), *words.help(None), *document)


def sections(words: Wording) -> tuple[Section, ...]:
    """The sections of a page: the chapters, then each command with its form and an example."""
    chapters = (
        Section(words(f"manual-{each}"), tuple(filter(None, words(f"manual-{each}-text").split("\n"))))
        for each in CHAPTERS
    )
    commands = tuple(line for entry in ENTRIES for line in words.help(entry))
    return (*chapters, Section(words("manual-commands"), commands))


def chapter_lines(words: Wording, chapter: str) -> tuple[str, ...]:
    """One chapter for the linear mode: a sentence or a line of its program each, at detail brief broken."""
    lines = words(f"manual-{chapter}-text").replace(". ", ".\n").split("\n")
    stripped = (line.strip() for line in lines if line)
    if words.detail != "brief":
        return tuple(stripped)
    return tuple(part for line in stripped for part in wrap(line, BRAILLE_CELLS))


# --- the tour: ``tour-1-2`` is the second line of page 1; the full screen has its own, ``screen-tour-1-2``

TOUR_PAGES = 9
STEP_PAGE = 8
"""The page of the linear mode's tour on which the learner steps through a program."""
SCREEN_TOUR_PAGES = 9


def tour_page(number: int, words: Wording) -> tuple[str, ...]:
    """The lines of one page, from 1."""
    return _tour_lines(f"tour-{number}", words)


def screen_tour_page(number: int, words: Wording, keys: Mapping[str, str]) -> tuple[str, ...]:
    """The lines of one page of the full screen; ``keys`` are the labels of keys by their command."""
    return _tour_lines(f"screen-tour-{number}", words, keys)


def _tour_lines(page: str, words: Wording, keys: Mapping[str, str] = MappingProxyType({})) -> tuple[str, ...]:
    codes = takewhile(words.knows, (f"{page}-{line}" for line in count(1)))
    return tuple(words(each, **keys) for each in codes)
