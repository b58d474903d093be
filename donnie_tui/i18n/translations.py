"""The folders of the languages, for translators, for ``donnie doctor`` and for the build.

``python -m donnie_tui.i18n.translations check`` lists what is missing, and each mistake with its file and
line; ``check pt`` does so for one language. ``compile`` checks and makes what Donnie loads; ``update`` gives
every language the sentences that English has. Standard library only: the build runs this before anything is
installed.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterable, Iterator, Mapping
from itertools import chain
from pathlib import Path
from typing import Any

from donnie_tui.i18n import first_words, po
from donnie_tui.i18n.po import Mistake
from donnie_tui.i18n.words import CODES, COMPILED, SOURCE, codes
from language.locales import BUILT_IN, ENGLISH, folders, languages, search_path, table, toml_in

TABLES = ("keywords", "commands", "words")
"""The tables of words, without ``.toml``."""

_OF_ONE_LANGUAGE = ("languages", "braille")
"""Sections of ``words.toml`` whose keys a language chooses for itself."""

_EARLY_TOPIC = "start"
_COMMANDS = ("check", "compile", "update")


def main(arguments: list[str]) -> int:
    """Run one of the commands on the folders of languages; the exit code."""
    command, *chosen = arguments or [""]
    if command not in _COMMANDS or (chosen and command != "check"):
        _print(f"usage: python -m donnie_tui.i18n.translations {'|'.join(_COMMANDS)}")
        return 2
    for each in chosen:
        if each not in folders():
            _print(f"No folder {each} in {', '.join((BUILT_IN, *search_path()))}.")
            return 2
    if command == "update":
        update()
    if command != "compile":
        return _report(chosen or sorted(folders()), has_details=command == "check")
    found = compile_all()
    for mistake in found:
        _print(str(mistake))
    return 1 if any(map(is_built_in, found)) else 0


def _report(chosen: Iterable[str], *, has_details: bool) -> int:
    """Print what is missing, if wanted, then the mistakes, and last their number; the exit code."""
    found = (*mistakes(), *ambiguous_keywords())
    wrong = {each: [one for one in found if one.file.parent == Path(folders()[each])] for each in chosen}
    missing = {each: missing_in(each) for each in wrong}
    for language, names in missing.items():
        for name in names if has_details else ():
            _print(f"{language} lacks {name}")
    for mistake in chain.from_iterable(wrong.values()):
        _print(str(mistake))
    for language in wrong:
        _print(f"{language}: {len(wrong[language])} wrong, {len(missing[language])} missing")
    return 1 if any(wrong.values()) else 0


def _print(line: str) -> None:
    sys.stdout.write(f"{line}\n")


# --- mistakes


def mistakes() -> tuple[Mistake, ...]:
    """All mistakes in the files of all languages; those of the English files once."""
    english = Path(BUILT_IN, ENGLISH, SOURCE)
    try:
        known = [each.context for each in po.read(english)] if english.exists() else codes(ENGLISH)
    except Mistake as mistake:
        return (mistake,)
    known_codes = frozenset(each.partition("|")[0] for each in ("", *known))
    found = [each for folder in folders().values() for each in _mistakes_in(Path(folder), known_codes)]
    return tuple({str(each): each for each in (*found, *_shared_ranks())}.values())


def _mistakes_in(folder: Path, known_codes: frozenset[str]) -> Iterator[Mistake]:
    try:
        if (folder / SOURCE).exists():
            entries = po.read(folder / SOURCE)
            yield from (mistake for _, mistake in po.mistakes(folder / SOURCE, entries))
            for each in entries:
                if each.context.partition("|")[0] not in known_codes:
                    what = f"{each.context} is not in the English file: msgctxt stays as it is there"
                    yield Mistake(folder / SOURCE, each.line, what)
        for name in TABLES:
            file, english = folder / f"{name}.toml", Path(BUILT_IN, ENGLISH, f"{name}.toml")
            if file.exists():
                known = _read_table(english) if english.exists() else table(ENGLISH, name)
                yield from _wrong_in_table(file, _read_table(file), known)
    except Mistake as mistake:
        yield mistake


def _shared_ranks() -> Iterator[Mistake]:
    """Languages with the ``rank`` of another: which one a program is in would depend on their codes.

    If one of two languages is built in, the mistake is the other's.
    """
    owner: dict[object, str] = {}
    for language in sorted(languages(), key=lambda each: Path(folders()[each]).parent != Path(BUILT_IN)):
        rank = table(language, "keywords").get("rank")
        file = Path(folders()[language], "keywords.toml")
        if rank is not None and owner.setdefault(rank, language) != language and file.exists():
            yield Mistake(file, _line_of("rank", file), f"rank {rank} is that of {owner[rank]} already")


def ambiguous_keywords() -> Iterator[Mistake]:
    """GoDonnie words that mean something else in a language with a smaller rank, which wins."""
    from language.keywords import WORDS, word

    for each in WORDS:
        for language, spellings in each.spellings.items():
            file = Path(folders()[language], "keywords.toml")
            for spelled in spellings:
                meant = word(spelled)
                if meant is not None and meant.terminal != each.terminal and file.exists():
                    what = f"{spelled} means {meant.canonical} in another language"
                    yield Mistake(file, _line_of(each.canonical, file), what)


def _read_table(file: Path) -> dict[str, Any]:
    text = po.text_of(file)
    try:
        return toml_in(text)
    except RecursionError:
        raise Mistake(file, 1, "this file has too many brackets in each other") from None
    except ValueError as problem:
        place = re.search(r"line (\d+)", str(problem))  # else it is the end of the file
        raise Mistake(file, int(place[1]) if place else len(text.splitlines()), str(problem)) from None


def _wrong_in_table(file: Path, words: Mapping[str, Any], english: Mapping[str, Any]) -> Iterator[Mistake]:
    """Finds keys without a meaning, and in ``commands.toml`` words with two."""
    meaning_of: dict[str, str] = {}
    for key, value in words.items():
        line = _line_of(key, file)
        if key in _OF_ONE_LANGUAGE and isinstance(value, dict):
            continue
        if key not in english or type(value) is not type(english[key]):
            yield Mistake(file, line, f"{key} is not in the English file, or has another form there")
        elif isinstance(value, dict):
            yield from _wrong_in_table(file, value, english[key])
        elif isinstance(value, list) and not all(isinstance(each, str) and each.strip() for each in value):
            yield Mistake(file, line, f"{key} takes words in quotation marks")
        elif isinstance(value, list) and file.stem == "commands":
            for word in value:
                if meaning_of.setdefault(word.casefold(), key) != key:
                    yield Mistake(file, line, f"{word} is a word of {meaning_of[word.casefold()]} already")


def _line_of(key: str, file: Path) -> int:
    begins = re.compile(rf'\[?"?{re.escape(key)}"?\s*[\]=]')
    lines = enumerate(file.read_text(encoding="utf-8-sig").splitlines(), start=1)
    return next((number for number, line in lines if begins.match(line.strip())), 1)


# --- what is missing


def missing_in(language: str) -> tuple[str, ...]:
    """The missing entries: ``messages.po walked-forward``, ``keywords.toml FW in [keywords]``."""
    has = frozenset(codes(language))
    sentences = [f"{SOURCE} {code}" for code in codes(ENGLISH) if code not in has]
    words = [
        f"{name}.toml {key}"
        for name in TABLES
        for key in _without(table(ENGLISH, name), table(language, name))
    ]
    return (*sentences, *words)


def _without(english: Mapping[str, Any], other: Mapping[str, Any], section: str = "") -> Iterator[str]:
    """The keys of words that the other table lacks, each with its section."""
    for key, value in english.items():
        if isinstance(value, dict) and key not in _OF_ONE_LANGUAGE:
            yield from _without(value, other.get(key, {}), f"{section}.{key}" if section else key)
        elif isinstance(value, list) and key not in other:
            yield f"{key} in [{section}]" if section else key


# --- what Donnie loads


def compile_all() -> tuple[Mistake, ...]:
    """Compile the files of every language. Returns the mistakes.

    A mistake in a built-in folder keeps everything from being compiled. A folder from outside never does:
    if it has a mistake, only it is left out, and Donnie takes its valid entries, else English.
    """
    found = mistakes()
    if any(map(is_built_in, found)):
        return found
    wrong = {each.file.parent for each in found}
    for language, folder in folders().items():
        if Path(folder) not in wrong:
            try:
                _compile(language, Path(folder))
            except OSError:
                if Path(folder).parent == Path(BUILT_IN):
                    raise
    return found


def is_built_in(mistake: Mistake) -> bool:
    """Whether a mistake is in a language that comes with Donnie."""
    return mistake.file.parent.parent == Path(BUILT_IN)


def _compile(language: str, folder: Path) -> None:
    (folder / "compiled").mkdir(exist_ok=True)
    if (folder / SOURCE).exists():
        is_english = language == ENGLISH
        entries = po.usable(folder / SOURCE)
        _replace(folder / "compiled" / COMPILED, po.compiled(entries, CODES, is_english=is_english))
        early = [each for each in entries if each.topic == _EARLY_TOPIC]
        lines = (f"{each.context}={each.sentence if is_english else each.text}\n" for each in early)
        _replace(folder / "compiled" / first_words.FILE, "".join(lines).encode())
    for name in TABLES:
        if (folder / f"{name}.toml").exists():
            words = json.dumps(_read_table(folder / f"{name}.toml"), ensure_ascii=False)
            _replace(folder / "compiled" / f"{name}.json", words.encode())


def _replace(file: Path, content: bytes) -> None:
    """Replace the file atomically, because another Donnie may read it."""
    new = file.with_suffix(".new")
    new.write_bytes(content)
    new.replace(file)


# --- new sentences


def update() -> None:
    """Write every file of sentences anew: with those of English, in their order, and no others.

    A translation of an English sentence that has changed since is kept and marked as fuzzy.
    """
    english = po.read(Path(folders()[ENGLISH], SOURCE))
    for language, folder in folders().items():
        file = Path(folder, SOURCE)
        if language == ENGLISH:
            file.write_text(po.written(english), encoding="utf-8")
        elif file.exists():
            entries = {each.context: each for each in po.read(file)}
            kept = [_updated(each, entries.get(each.context)) for each in english[1:]]
            file.write_text(po.written((entries[""], *kept)), encoding="utf-8")


def _updated(english: po.Entry, entry: po.Entry | None) -> po.Entry:
    if entry is None:
        return english
    has_changed = entry.english != english.english and bool(entry.text)
    return english._replace(text=entry.text, is_fuzzy=entry.is_fuzzy or has_changed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
