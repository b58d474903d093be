"""The languages: a folder each, named by its code, with tables of words and the sentences of Donnie.

``donnie_tui/i18n/locales/pt`` is all of Portuguese. DONNIE_LOCALES names more folders of such folders; a
language in one of them replaces the built-in language of that code. This module finds the folders by their
path and imports nothing of donnie_tui. It is light: the first prompt needs the codes.
"""

from __future__ import annotations

# ruff: noqa: PTH113, PTH116, PTH120, PTH123, PTH208 -- pathlib is slow to load
import os

ENGLISH = "en"
"""What is missing in a language is taken from here."""

BUILT_IN = f"{os.path.dirname(os.path.dirname(__file__))}/donnie_tui/i18n/locales"

SEARCH_PATH = "DONNIE_LOCALES"
"""The environment variable with more folders, separated as in PATH."""

DOCUMENTS = (
    f"{os.path.dirname(os.path.dirname(BUILT_IN))}/docs",
    f"{os.path.dirname(os.path.dirname(__file__))}/docs",
)
"""Where the documents are: in a wheel, in the repository."""

LARGEST = 1_000_000
"""Bytes of one file of a language; the sentences of a language have some 200 000."""

MOST_DOTS = 200
"""In a line of TOML: a key of thousands of parts takes Python's own reader minutes."""

_folders: dict[str, str] = {}
_tables: dict[tuple[str, str], dict[str, object]] = {}


def folders() -> dict[str, str]:
    """The folder of each language by its code, in no particular order."""
    if not _folders:
        for place in (BUILT_IN, *reversed(search_path())):
            _folders.update({name: f"{place}/{name}" for name in _names_in(place) if _is_code(name)})
    return _folders


def search_path() -> list[str]:
    """The folders that DONNIE_LOCALES names; the first that has a language is the one that is used."""
    return [each for each in os.environ.get(SEARCH_PATH, "").split(os.pathsep) if each]


def forget() -> None:
    """Look for the folders anew when they are wanted next."""
    _folders.clear()
    _tables.clear()


def _names_in(folder: str) -> list[str]:
    try:
        return os.listdir(folder)
    except OSError:
        return []


def _is_code(name: str) -> bool:
    """``pt``, ``pt-br``; no hidden folder, no file."""
    return name.replace("-", "").isalnum() and name.islower()


def languages() -> tuple[str, ...]:
    """The codes of all languages, by the ``rank`` of their keywords: English, then the others."""
    return tuple(sorted(folders(), key=lambda language: (_rank(language), language)))


def _rank(language: str) -> float:
    rank = table(language, "keywords").get("rank")
    return rank if isinstance(rank, int) else float("inf")


def language_of_locale(locale: str) -> str | None:
    """The language of a locale such as ``pt_BR.UTF-8``; None if there is none."""
    code = locale.partition(".")[0].lower().replace("_", "-")
    return next((each for each in (code, code.partition("-")[0]) if each in folders()), None)


def first_page(language: str) -> str:
    """The path of the document for beginners in a language, else of that in English; empty without any."""
    paths = (f"{folder}/{each}/README.md" for each in (language, ENGLISH) for folder in DOCUMENTS)
    return next((each for each in paths if os.path.isfile(each)), "")


def compiled_file(language: str, source: str, name: str) -> str | None:
    """The path of what the build made of a file of the language; None if it is missing or out of date."""
    folder = folders()[language]
    compiled = f"{folder}/compiled/{name}"
    try:
        made = os.stat(compiled).st_mtime_ns
    except OSError:
        return None
    try:
        return compiled if made >= os.stat(f"{folder}/{source}").st_mtime_ns else None
    except OSError:  # an installed Donnie has only what is compiled
        return compiled


def table(language: str, name: str) -> dict[str, object]:
    """A table of the language: ``keywords``, ``commands`` or ``words``. Empty if none can be read."""
    if (language, name) not in _tables:
        _tables[language, name] = _read(language, name)
    return _tables[language, name]


def _read(language: str, name: str) -> dict[str, object]:
    try:
        compiled = compiled_file(language, f"{name}.toml", f"{name}.json")
        if compiled is not None:
            import msgspec  # a greeting needs no table

            # no deeper than this: the decoder recurses, and programs raise the limit of Python's calls
            scalar = str | int | float | bool | None
            entry = scalar | list[scalar]
            section = dict[str, entry | dict[str, entry | dict[str, entry]]]
            found: dict[str, object] = msgspec.json.decode(
                content_of(compiled), type=dict[str, entry | section]
            )
            return found
        return toml_in(content_of(f"{folders()[language]}/{name}.toml").decode("utf-8"))
    except (OSError, ValueError, RecursionError):
        return {}


def toml_in(text: str) -> dict[str, object]:
    """The values of a TOML text. Raises ``ValueError`` with the line, and ``RecursionError``."""
    import tomllib

    for number, line in enumerate(text.split("\n"), start=1):
        if line.count(".") > MOST_DOTS:
            raise ValueError(f"too many dots (at line {number}, column 1)")
    return tomllib.loads(text)


def content_of(path: str) -> bytes:
    """A file of a language. Raises ``OSError``, ``ValueError`` where it is too large."""
    with open(path, "rb") as file:
        content = file.read(LARGEST + 1)
    if len(content) > LARGEST:
        raise ValueError(f"more than {LARGEST} bytes")
    return content


def words(language: str, name: str, *keys: str) -> tuple[str, ...]:
    """The words of an entry of a table, those of English where the language has none.

    Raises ``KeyError`` for an entry that English does not have.
    """
    found = own_words(language, name, *keys) or own_words(ENGLISH, name, *keys)
    if not found:
        raise KeyError(*keys)
    return found


def own_words(language: str, name: str, *keys: str) -> tuple[str, ...]:
    """The words of an entry in the language itself, none if it has none."""
    found = _entry(language, name, keys)
    is_list = isinstance(found, list) and all(isinstance(each, str) for each in found)
    return tuple(found) if isinstance(found, list) and is_list else ()


def keys(language: str, name: str, *section: str) -> tuple[str, ...]:
    """The keys of a section of a table."""
    found = _entry(language, name, section)
    return tuple(found) if isinstance(found, dict) else ()


def _entry(language: str, name: str, keys: tuple[str, ...]) -> object:
    found: object = table(language, name)
    for key in keys:
        found = found.get(key) if isinstance(found, dict) else None
    return found
