"""Writes every sentence with real values, for a review by ear: ``make sentences``, a page for each language.

The values are in ``sentences.toml``. The pages are in ``build/sentences``; git doesn't keep them.
"""

from __future__ import annotations

import re
import sys
import tomllib
from collections.abc import Iterator, Mapping
from itertools import groupby
from pathlib import Path
from string import Formatter

from donnie_tui import DETAILS
from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.keys import key_label
from donnie_tui.i18n import po
from donnie_tui.i18n.words import SOURCE, filled, find
from language import keywords, locales
from language.locales import BUILT_IN, ENGLISH, languages

Value = str | int | float
FOLDER = Path("build/sentences")
EXAMPLES = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))

_REFERENCE = re.compile(r"([$^&@])([\w.-]*\w)")
_OF_A_GENDER = re.compile(r"@(?:(article-m)|colour-\w+)")
_KEYS = {each.name: each.keys[0] for each in COMMANDS if each.keys}
_ENTRIES = po.read(Path(BUILT_IN, ENGLISH, SOURCE))[1:]
_TOPICS = {each.context: each.topic for each in _ENTRIES}


def document(language: str) -> str:
    """The page of one language: the sentences by topic, each with its code and its levels of detail."""
    lines = [
        f"# Every sentence: {locales.words(language, 'words', 'languages', language)[0]}",
        "",
        "The value of each place is an example. Where a word agrees with a number, the sentence is here",
        "with one thing and with several. `brief` and `full` are the other levels of detail.",
    ]
    for topic, of_topic in groupby(_ENTRIES, key=lambda each: each.topic):
        group = tuple(of_topic)
        lines += ["", f"## {topic}", "", *(note for each in group for note in each.notes)]
        for code in dict.fromkeys(each.context.partition("|")[0] for each in group):
            lines += ["", f"`{code}`", "", *_renderings(code, topic, language)]
    return "\n".join(lines) + "\n"


def _renderings(code: str, topic: str, language: str) -> Iterator[str]:
    normal = rendered(code, topic, language)
    for detail in sorted(DETAILS, key=lambda each: each != "normal"):
        texts = rendered(code, topic, language, detail)
        if detail == "normal" or texts != normal:
            label = "" if detail == "normal" else f"{detail}: "
            yield from (f"- {label}{text}".replace("\n", "\n  ") for text in texts)


def rendered(code: str, topic: str, language: str, detail: str = "normal") -> tuple[str, ...]:
    """The sentence with its values; for one thing and for several where a word agrees with their number.

    Raises ``KeyError`` for a place without an example.
    """
    sentence = find(code, language, detail)
    assert sentence is not None
    values = {name: found for name in places(sentence.text) if (found := examples(name, code, topic))}
    agrees = re.search(r"\{\w+:[^{}]*\|", sentence.text)
    rounds = max(map(len, values.values()), default=1)
    gender = _gender_of(values.get("name", ()), language)
    return tuple(
        filled(
            sentence,
            {name: _value(each[min(at, len(each) - 1)], language, gender) for name, each in values.items()},
        )
        for at in range(0 if agrees else rounds - 1, rounds)
    )


def _gender_of(name: tuple[Value, ...], language: str) -> str:
    """Of the thing that a sentence names, with which its article and its colour agree; else m."""
    thing = re.fullmatch(r"@thing-(\w+)", str(name[0])) if name else None
    return rendered(f"gender-{thing[1]}", "things", language)[0] if thing else "m"


def places(text: str) -> set[str]:
    """The names of the places of a text."""
    return {name for _, name, _, _ in Formatter().parse(text) if name}


def examples(name: str, code: str, topic: str) -> tuple[Value, ...]:
    """The values of a place in a sentence: its own, or its topic's, or the general ones; none without one."""
    tables: tuple[Mapping[str, Value | list[Value]], ...] = (
        EXAMPLES["sentence"].get(code, {}),
        EXAMPLES["topic"].get(topic, {}),
        EXAMPLES["everywhere"],
    )
    found = next((table[name] for table in tables if name in table), [])
    return tuple(found) if isinstance(found, list) else (found,)


def _value(value: Value, language: str, gender: str) -> Value:
    """A value in the words of a language; its article and its colour in that gender."""
    if not isinstance(value, str):
        return value
    if gender == "f":
        value = _OF_A_GENDER.sub(lambda found: "@article-f" if found[1] else f"{found[0]}-f", value)
    return _REFERENCE.sub(lambda found: _named(*found.groups(), language), value)


def _named(sign: str, name: str, language: str) -> str:
    match sign:
        case "$":
            return keywords.spelling(name.replace("_", " "), language)
        case "^":
            return key_label(_KEYS[name], language)
        case "&":
            table, *keys = name.split(".")
            return locales.words(language, table, *keys)[0]
        case _:
            return rendered(name, _TOPICS[name], language)[-1]


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    for each in sys.argv[1:] or languages():
        page = FOLDER / f"{each}.md"
        page.write_text(document(each), encoding="utf-8")
        print(page)
