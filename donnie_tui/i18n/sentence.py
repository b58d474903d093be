"""One sentence of the catalogue: three languages side by side, and up to three levels of detail.

Places are ``{name}``; ``{steps:step|steps}`` is the word that agrees with the number ``steps``, and
``{thing:capital}`` begins the sentence. A number with decimals is given as a ``float``, and told with the
language's own sign; text is told as it is.
"""

from __future__ import annotations

from devices.ports.hints import TypeAlias
from devices.ports.values import Frozen
from donnie_tui import LANGUAGES

_DECIMAL_SIGNS = {"en": ".", "pt": ",", "es": ","}

_BEGINNINGS = {"capital": str.upper, "small": str.lower}

Texts: TypeAlias = tuple[str, str, str]
"""English, Brazilian Portuguese, Spanish."""


class Sentence(Frozen):
    """Equal in all languages; ``brief`` and ``full`` only where they differ from the normal one."""

    en: str
    pt: str
    es: str
    brief: Texts | None = None
    full: Texts | None = None

    def text(self, language: str, detail: str = "normal") -> str:
        texts = {"brief": self.brief, "full": self.full}.get(detail) or (self.en, self.pt, self.es)
        return texts[LANGUAGES.index(language)]


class _Place:
    """A value as the place asks for it: ``{n:one|many}`` chooses a word by the number n.

    ``{text:capital}`` begins with a capital letter, ``{text:small}`` with a small one.
    """

    __slots__ = ("_decimal_sign", "_value")

    def __init__(self, value: object, decimal_sign: str) -> None:
        self._value = value
        self._decimal_sign = decimal_sign

    def __format__(self, wanted: str) -> str:
        value = self._value
        if "|" in wanted:
            one, many = wanted.split("|")
            return one if value in (1, -1) else many
        if wanted in _BEGINNINGS:
            text = str(value)
            return _BEGINNINGS[wanted](text[:1]) + text[1:]
        told = format(value, wanted)
        return told.replace(".", self._decimal_sign) if isinstance(value, float) else told


def filled(text: str, values: dict[str, object], language: str = "en") -> str:
    """The text with its places filled. Raises ``KeyError`` for a place without a value."""
    if "{" not in text and "}" not in text:
        return text
    sign = _DECIMAL_SIGNS[language]
    return text.format_map({name: _Place(value, sign) for name, value in values.items()})
