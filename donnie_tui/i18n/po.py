"""The files of sentences: reads, writes and checks ``messages.po``, and makes gettext's compiled file of it.

An entry has the code of its sentence as context (``walked-forward``, or ``walked-forward|brief`` for another
level of detail) and the English sentence as ``msgid``. In the compiled file the context alone is the key: a
sentence is found by its code. Standard library only: the build compiles before anything is installed.
"""

from __future__ import annotations

import re
import struct
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from gettext import c2py
from pathlib import Path
from string import Formatter
from typing import NamedTuple

from language.locales import content_of

_WIDTH = 79
"""Characters of a line, as gettext's own tools break them."""
_MAGIC = 0x950412DE
_ESCAPED = {"n": "\n", "t": "\t", '"': '"', "\\": "\\"}
_TEXT = re.compile(r'"((?:[^"\\]|\\.)*)"')
_FIELDS = ("msgctxt", "msgid", "msgstr")


class Mistake(ValueError):
    """A mistake in a file that a translator wrote, with its place."""

    def __init__(self, file: Path, line: int, what: str) -> None:
        super().__init__(f"{file}:{line}: {what}")
        self.file = file


class Entry(NamedTuple):
    """One sentence in one language."""

    context: str
    """Its code, with ``|brief`` or ``|full`` for another level of detail; empty for the header."""
    english: str
    text: str
    """The translation; empty in English, and where there is none."""
    topic: str = ""
    notes: tuple[str, ...] = ()
    """For the translator."""
    line: int = 0
    is_fuzzy: bool = False
    """Whether the English sentence has changed since: such a translation is not used."""

    @property
    def sentence(self) -> str:
        """The English sentence."""
        return self.text or self.english


# --- reading and writing


def read(file: Path) -> tuple[Entry, ...]:
    """The entries of a file, the header first. Raises ``Mistake`` or ``OSError``."""
    lines = text_of(file).splitlines()
    found: list[Entry] = []
    draft = _Draft(file)
    for number, line in enumerate(map(str.strip, lines), start=1):
        if "msgstr" in draft.fields and not line.startswith('"'):
            found.append(draft.entry())
            draft = _Draft(file)
        draft.take(number, line)
    if draft.fields:
        found.append(draft.entry())
    return tuple(found)


def text_of(file: Path) -> str:
    """The text of a file that a translator wrote. Raises ``Mistake`` or ``OSError``."""
    try:
        return content_of(str(file)).decode("utf-8-sig")
    except UnicodeDecodeError:
        raise Mistake(file, 1, "this file is not in UTF-8") from None
    except ValueError as problem:
        raise Mistake(file, 1, f"this file has {problem}") from None


class _Draft:
    """An entry while its lines are read."""

    def __init__(self, file: Path) -> None:
        self._file = file
        self.fields: dict[str, str] = {}
        self._last = ""
        self._topic = ""
        self._notes: list[str] = []
        self._line = 0
        self._is_fuzzy = False

    def take(self, number: int, line: str) -> None:
        if line.startswith("#:"):
            self._topic = line[2:].strip()
        elif line.startswith("#."):
            self._notes.append(line[2:].strip())
        elif line.startswith("#,"):
            self._is_fuzzy = "fuzzy" in line
        elif line and not line.startswith("#"):
            self._take_field(number, line)

    def _take_field(self, number: int, line: str) -> None:
        name, _, rest = ("", "", line) if line.startswith('"') else line.partition(" ")
        text = _TEXT.fullmatch(rest.strip())
        if text is None or (name or self._last) not in _FIELDS:
            raise Mistake(
                self._file,
                number,
                f"expected a comment, or one of {', '.join(_FIELDS)} with a text in quotes",
            )
        if name:
            self._last, self._line = name, self._line or number
        shown = re.sub(r"\\(.)", lambda found: _ESCAPED.get(found[1], found[0]), text[1])
        self.fields[self._last] = self.fields.get(self._last, "") + shown

    def entry(self) -> Entry:
        missing = next((each for each in ("msgid", "msgstr") if each not in self.fields), None)
        if missing:
            raise Mistake(self._file, self._line, f"this entry has no {missing}")
        return Entry(
            self.fields.get("msgctxt", ""),
            self.fields["msgid"],
            self.fields["msgstr"],
            self._topic,
            tuple(self._notes),
            self._line,
            self._is_fuzzy,
        )


def written(entries: Iterable[Entry]) -> str:
    """The text of a file, broken into lines as gettext's own tools and Poedit do."""
    return "\n".join(map(_written, entries))


def _written(entry: Entry) -> str:
    lines = [f"#. {note}" for note in entry.notes]
    lines += [f"#: {entry.topic}"] if entry.topic else []
    lines += ["#, fuzzy"] if entry.is_fuzzy else []
    lines += _field("msgctxt", entry.context) if entry.context else []
    lines += [*_field("msgid", entry.english), *_field("msgstr", entry.text)]
    return "\n".join(lines) + "\n"


def _field(name: str, text: str) -> Iterator[str]:
    quoted = text.replace("\\", "\\\\").replace('"', '\\"').replace("\t", "\\t").replace("\n", "\\n")
    if len(name) + len(quoted) + 3 <= _WIDTH and "\\n" not in quoted[:-2]:
        yield f'{name} "{quoted}"'
        return
    yield f'{name} ""'
    for part in filter(None, re.split(r"(?<=\\n)", quoted)):
        row = ""
        for word in re.findall(r"[^ ]+ *| +", part):
            if row and len(row) + len(word) + 2 > _WIDTH:
                yield f'"{row}"'
                row = ""
            row += word
        yield f'"{row}"'


# --- the header


def header(entries: Iterable[Entry]) -> Mapping[str, str]:
    """The fields of the header, such as ``Plural-Forms``."""
    text = next((each.text for each in entries if not each.context and not each.english), "")
    return {name: value.strip() for name, _, value in (row.partition(":") for row in text.splitlines())}


def number_of_forms(plural_forms: str) -> int:
    """The number of plural forms of a language. Raises ``ValueError`` for an invalid rule."""
    found = re.fullmatch(r"nplurals\s*=\s*([1-9])\s*;\s*plural\s*=\s*([^;]+);?", plural_forms)
    if found is None:
        raise ValueError(plural_forms)
    c2py(found[2])
    return int(found[1])


# --- what is wrong


def mistakes(file: Path, entries: Sequence[Entry]) -> Iterator[tuple[Entry, Mistake]]:
    """Each unusable entry with its mistake; without a plural rule every entry is unusable."""
    try:
        forms = number_of_forms(header(entries).get("Plural-Forms", ""))
    except ValueError:
        for each in entries:
            yield each, Mistake(file, 1, "the header has no Plural-Forms with nplurals and plural")
        return
    seen = set[str]()
    for each in entries:
        what = _wrong_with(each, forms)
        if what is None and each.context in seen:
            what = f"{each.context or 'the header'} is here a second time"
        seen.add(each.context)
        if what is not None:
            yield each, Mistake(file, each.line, what)


def _wrong_with(entry: Entry, forms: int) -> str | None:
    if not entry.context:
        return "this entry has no msgctxt" if entry.english else None
    try:
        places, wanted = _places(entry.sentence), _places(entry.english)
    except ValueError:
        return "a brace is missing or too many"
    for name, form in places:
        number = len(form.split("|"))
        if number > 1 and number != forms:
            return f"{{{name}:{form}}} has {number} forms and needs {forms}"
    unknown = {name for name, _ in places} - {name for name, _ in wanted}
    if unknown:
        return f"{{{min(unknown)}}} is not in the English sentence"
    counted, expected = (Counter(each for each in them if "|" not in each[1]) for them in (places, wanted))
    for name, form in (expected - counted) + (counted - expected):
        return f"{{{name}{':' if form else ''}{form}}} is not here as often as in the English sentence"
    return None


def _places(text: str) -> list[tuple[str, str]]:
    """The placeholders: name and format of each."""
    return [(name, form or "") for _, name, form, _ in Formatter().parse(text) if name is not None]


def usable(file: Path) -> tuple[Entry, ...]:
    """The entries without a mistake, with a sentence, and not fuzzy. Raises ``Mistake`` or ``OSError``."""
    entries = read(file)
    wrong = {id(entry) for entry, _ in mistakes(file, entries)}
    return tuple(each for each in entries if id(each) not in wrong and each.sentence and not each.is_fuzzy)


# --- the compiled file


def compiled(entries: Iterable[Entry], list_key: str, *, is_english: bool) -> bytes:
    """The file for ``gettext.GNUTranslations``: the header, and each translated sentence by its context.

    ``list_key`` is the key of a text with all contexts, a line each: gettext can't list them.
    """
    entries = tuple(entries)
    texts = {each.context: each.sentence if is_english else each.text for each in entries}
    fields = {name.strip().lower(): value for name, value in header(entries).items()}
    if "plural-forms" in fields:  # gettext finds no rule after a blank
        fields["plural-forms"] = "".join(fields["plural-forms"].split())
    fields["content-type"] = "text/plain; charset=UTF-8"  # as the file was read
    texts[""] = "".join(f"{name}: {value}\n" for name, value in fields.items())
    texts[list_key] = "\n".join(context for context, text in texts.items() if context and text)
    pairs = sorted((key.encode(), text.encode()) for key, text in texts.items() if text)
    at = 28 + 16 * len(pairs)
    tables, strings = [], b""
    for column in (0, 1):
        for pair in pairs:
            tables += [len(pair[column]), at + len(strings)]
            strings += pair[column] + b"\0"
    head = (_MAGIC, 0, len(pairs), 28, 28 + 8 * len(pairs), 0, at)
    return struct.pack(f"<{len(head) + len(tables)}I", *head, *tables) + strings
