"""All sentences of all languages, for the tests that look at each of them."""

from collections.abc import Iterator
from pathlib import Path

from donnie_tui import DETAILS
from donnie_tui.i18n import po
from donnie_tui.i18n.words import find
from language.locales import BUILT_IN, ENGLISH, languages

ENTRIES = po.read(Path(BUILT_IN, ENGLISH, "messages.po"))[1:]
"""The English ones; another level of detail has an entry of its own."""

CODES = tuple(dict.fromkeys(each.context.partition("|")[0] for each in ENTRIES))


def codes_of(*topics: str) -> tuple[str, ...]:
    """The codes of some topics."""
    found = (each.context.partition("|")[0] for each in ENTRIES if each.topic in topics)
    return tuple(dict.fromkeys(found))


def text(code: str, language: str, detail: str = "normal") -> str:
    """The sentence with its places."""
    sentence = find(code, language, detail)
    assert sentence is not None
    assert sentence.language == language, f"{code} is missing in {language}"
    return sentence.text


def all_texts() -> Iterator[tuple[str, str]]:
    """Each line with its code, detail and language."""
    for code in CODES:
        for detail in DETAILS:
            for language in languages():
                for line in lines_of(text(code, language, detail)):
                    yield f"{code} {detail} {language}", line


def lines_of(text: str) -> list[str]:
    """A chapter of the manual has several, some of them empty, some of a program; a sentence is one."""
    return [line.strip() for line in text.split("\n") if line] if "\n" in text else [text]
