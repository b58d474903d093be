"""Text in six-dot braille as embossers take it: North American ASCII braille, a sign a cell.

Uncontracted, without signs for capitals; accents as Portuguese and Spanish braille have them.
"""

from __future__ import annotations

import unicodedata

ASCII = " A1B'K2L@CIF/MSP\"E3H9O6R^DJG>NTQ,*5<-U8V.%[$+X!&;:4\\0Z7(_?W]#Y)="
"""The 64 cells in the order of their dots: dot 1 counts 1, dot 2 counts 2, dot 3 counts 4 and so on."""
FULL_CELL = "="
NUMBER = "#"

_SIGNS = {",": "1", ";": "2", ":": "3", ".": "'", "-": "-", "'": "'", "_": "-", "/": "-"}
_ENGLISH_STOP = {".": "4"}
_PORTUGUESE = dict(zip("áàâãéêíóôõúüç", "($*>=</+?[)\\&", strict=True))
_SPANISH = dict(zip("áéíóúñü", "(!/+)]\\", strict=True))
_SPECIAL = {"en": _ENGLISH_STOP, "pt": _PORTUGUESE, "es": _SPANISH}


def braille(text: str, language: str) -> str:
    """The text in ``en``, ``pt`` or ``es``; what has no sign there becomes a blank."""
    cells: list[str] = []
    in_number = False
    for letter in unicodedata.normalize("NFC", text).lower():
        is_digit = "0" <= letter <= "9"
        if is_digit and not in_number:
            cells.append(NUMBER)
        cells.append(_cell(letter, language))
        in_number = is_digit
    return "".join(cells)


def _cell(letter: str, language: str) -> str:
    if "0" <= letter <= "9":
        return "JABCDEFGHI"[int(letter)]
    special = _SPECIAL[language].get(letter) or _SIGNS.get(letter)
    plain = unicodedata.normalize("NFD", letter)[0]
    return special or (plain.upper() if "a" <= plain <= "z" else " ")


def dots(cell: str) -> tuple[int, ...]:
    """The raised dots of a cell: 1, 2, 3 down the left column, 4, 5, 6 down the right one."""
    pattern = ASCII.index(cell)
    return tuple(dot for dot in range(1, 7) if pattern & 1 << (dot - 1))
