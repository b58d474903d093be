"""A language of the tests' own: English with accents, 40 % longer, and with three forms of a word.

What is missing in the code's translation shows as English without accents; what has no room breaks.
"""

from __future__ import annotations

import re
from pathlib import Path
from string import Formatter

from donnie_tui.i18n import po
from donnie_tui.i18n.po import Entry
from language.locales import BUILT_IN, ENGLISH

CODE = "zz"
ENDING = "ZU"
"""Behind every word that is typed: FWZU, END IF is ENDZU IFZU."""

_HEADER = """Language: zz
Content-Type: text/plain; charset=UTF-8
Plural-Forms: nplurals=3; plural=(n==1 ? 0 : n==2 ? 1 : 2);
"""
_LONGER = {
    **{"a": "áà", "e": "éè", "i": "íì", "o": "óò", "u": "úù"},
    **{"A": "ÁÀ", "E": "ÉÈ", "I": "ÍÌ", "O": "ÓÒ", "U": "ÚÙ", "n": "ñn", "c": "çc"},
}


def accented(text: str) -> str:
    """English text with accents, and longer."""
    return "".join(_LONGER.get(letter, letter) for letter in text)


def pseudo(english: str) -> str:
    """A sentence with its places: the words around them accented, three forms in place of two."""
    parts = []
    for literal, name, form, _ in Formatter().parse(english):
        parts.append(accented(literal).replace("{", "{{").replace("}", "}}"))
        if name is None:
            continue
        forms = (form or "").split("|")
        if len(forms) == 2:
            form = f"{accented(forms[0])}|{accented(forms[1])}-II|{accented(forms[1])}"
        parts.append(f"{{{name}:{form}}}" if form else f"{{{name}}}")
    return "".join(parts)


def typed(english: str) -> str:
    """Words that are typed, in this language."""
    return " ".join(f"{word}{ENDING}" for word in english.split())


def write_language(folder: Path, *, without: tuple[str, ...] = ()) -> Path:
    """Make the language below ``folder``, ``without`` some entries. Its own folder."""
    own = folder / CODE
    own.mkdir(parents=True)
    entries = po.read(Path(BUILT_IN, ENGLISH, "messages.po"))
    kept = [each for each in entries[1:] if each.context not in without]
    translated = [each._replace(text=pseudo(each.english)) for each in kept]
    (own / "messages.po").write_text(po.written([Entry("", "", _HEADER), *translated]), encoding="utf-8")
    for name in ("keywords", "commands", "words"):
        text = Path(BUILT_IN, ENGLISH, f"{name}.toml").read_text(encoding="utf-8")
        (own / f"{name}.toml").write_text(_translated_table(text, without), encoding="utf-8")
    return own


def _translated_table(text: str, without: tuple[str, ...]) -> str:
    lines = []
    for line in text.splitlines():
        key, equals, value = line.partition(" = ")
        if line.startswith("rank"):
            line = "rank = 9"
        elif equals and key.strip('"') in without:
            continue
        elif equals and value.startswith('["'):
            words = re.findall(r'"([^"]*)"', value)
            line = f"{key} = [{', '.join(f'{chr(34)}{typed(word)}{chr(34)}' for word in words)}]"
        lines.append(line)
    return "\n".join(lines) + "\n"
