"""Things in words, as a legend or PUT has them, and as lines of a world file: ``chair green AS throne``.

Words of all languages are understood. Lengths in world files are metres, angles degrees counter-clockwise.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import cache
from unicodedata import normalize

from msgspec import Struct

from donnie_tui.core.wording import Wording, coloured_thing, meant, noun
from donnie_tui.i18n.words import Words
from language.keywords import COLOURS
from language.locales import languages
from language.source import fold, fold_name
from language.suggestions import nearest
from sim.picture import Thing

WALL, WALL_HEIGHT = "wall", 0.24
"""The height is in metres."""
KINDS = {
    **dict.fromkeys(("chair", "table", "small_sofa", "large_sofa"), "furniture.inc"),
    **dict.fromkeys(("box", "ball", "cone", "post", "flower", "stone", "crystal"), "things.inc"),
    **dict.fromkeys(("orange", "carton", "belt"), "juice.inc"),
    WALL: "things.inc",
}
"""What there is, by the words of world files, with the files that define it."""


class Description(Struct, frozen=True):
    """A thing in words: ``chair green AS throne``."""

    kind: str
    colours: tuple[str, ...] = ()
    marks: Mapping[str, str] = {}
    """The colours by the letters in the midst of things that have them, if they have some."""
    name: str = ""


@cache
def _meanings() -> tuple[Mapping[str, str], Mapping[str, str], re.Pattern[str]]:
    """Kinds and colours by the folded words of all languages, and what finds these and other words."""
    every = [*map(Words, reversed(languages()))]
    kinds = {fold_name(word_for(kind, words)): kind for words in every for kind in reversed(KINDS)}
    kinds |= {kind.replace("_", " "): kind for kind in KINDS}
    ends = [(words, colour, end) for words in every for colour in COLOURS for end in ("", "-f")]
    colours = {fold_name(words(f"colour-{colour}{end}")): colour for words, colour, end in ends}
    known = "|".join(re.escape(each).replace(r"\ ", r"\s+") for each in sorted(kinds, key=len, reverse=True))
    return kinds, colours, re.compile(rf"(?<![^\s,:;.])(?:{known})(?![^\s,:;.])|[^\s,:;.…]+")


def word_for(kind: str, wording: Wording) -> str:
    """A kind in the learner's language; of another author's world its own word."""
    return wording("cell-wall") if kind == WALL else noun(kind, wording) or kind


def thing_in_words(thing: Thing, wording: Wording) -> str:
    """A thing in a list."""
    return name_in_words(thing, wording) if thing.kind == WALL else coloured_thing(thing, wording)


def name_in_words(thing: Thing, wording: Wording) -> str:
    """Its name; without one of its own its kind with its number: "parede 2"."""
    kind = thing.kind.replace("_", " ")
    return re.sub(rf"^{re.escape(kind)}(?=$| \d+$)", word_for(thing.kind, wording), thing.name or kind)


def _as_in(text: str) -> re.Match[str] | None:
    """The word AS, in any language, which a name follows."""
    return next((each for each in re.finditer(r"\S+", text) if meant(each[0], "building") == "as"), None)


def with_numbers(text: str, *counts: int) -> tuple[str, tuple[int, ...]]:
    """The text without the last numbers before AS, and these: as many as the first of ``counts`` there is.

    Numbers before them are part of a name: box 2 1 0.
    """
    as_ = _as_in(text)
    places = [*re.finditer(r"(?<![^\s,])(-?\d{1,7})(?:,\s*|(?!\S))", text[: as_.start()] if as_ else text)]
    count = next((each for each in counts if each <= len(places)), 0)
    numbers = places[len(places) - count :]
    for each in reversed(numbers):
        text = text[: each.start()] + text[each.end() :]
    return " ".join(text.split()), tuple(int(each[1]) for each in numbers)


def name_in(text: str) -> str:
    """A name as world files have it, which know no escapes."""
    return "".join(each for each in text if each.isprintable() and each not in '"\\')[:60].strip(" .")


def description_of(text: str, wording: Wording) -> tuple[Description, Mapping[int, str]]:
    """What a thing is, or, by their places in the text, the sentences about all words that mean nothing.

    A word that is a colour too, such as orange, is the kind only if nothing else is.
    """
    kinds, colours, pattern = _meanings()
    text = normalize("NFC", text)
    as_ = _as_in(text)
    what, name = (text[: as_.start()], name_in(text[as_.end() :])) if as_ else (text, "")
    found = [*pattern.finditer(fold(what).replace("_", " "))]
    phrases = [fold_name(" ".join(each[0].split())) for each in found] + [""]
    of_kinds = sorted((phrase in colours, at) for at, phrase in enumerate(phrases) if phrase in kinds)
    kind = of_kinds[0][1] if of_kinds else len(found)
    shades, marks, mistakes = list[str](), list[str](), dict[int, str]()
    for at, each in enumerate(found):
        typed, phrase = what[each.start() : each.end()], phrases[at]
        if at == kind:
            continue
        if phrase in colours:
            shades.append(colours[phrase])
        elif len(typed) == 1 and typed.isalpha() and at > kind and phrases[at + 1] in colours:
            marks.append(typed)
        else:
            near = near_word(typed, wording)
            code = "drawing-second" if phrase in kinds else "drawing-word-near" if near else "drawing-word"
            mistakes[each.start()] = wording(code, word=typed[:40], near=near)
    if as_ and not name[:1].isalpha():
        mistakes[as_.start()] = wording("built-bad-name")
    if not of_kinds and not mistakes:
        known = ", ".join(word_for(each, wording) for each in KINDS if each != WALL)
        mistakes[0] = wording("drawing-no-kind", known=known)
    if mistakes:
        return Description(""), mistakes
    marked = dict(zip(marks, shades, strict=True)) if len(marks) == len(shades) else {}
    return Description(kinds[phrases[kind]], () if "…" in what else tuple(shades), marked, name), {}


def near_word(word: str, wording: Wording) -> str | None:
    """The kind or colour that was probably meant, in the learner's language; a part of its words is near."""
    kinds = [word_for(each, wording) for each in KINDS]
    colours = [wording(f"colour-{each}{end}") for each in COLOURS for end in ("", "-f")]
    meant = {part: each for each in (*colours, *kinds[::-1]) for part in (*each.split(), each)}
    return meant.get(nearest(word, meant) or "")


# --- a world file


def model_line(
    kind: str, pose: tuple[float, float, float], name: str = "", size: Sequence[float] = (), colour: str = ""
) -> str:
    """A thing, wall or robot as a world file has it."""
    x, y, angle = pose
    sides = " ".join(f"{each:.6g}" for each in size)
    parts = (f'name "{name}"', f"pose [ {x:g} {y:g} 0 {angle:g} ]", f"size [ {sides} ]", f'color "{colour}"')
    given = (part for part, is_given in zip(parts, (name, True, size, colour), strict=True) if is_given)
    return f"{kind}( {' '.join(given)} )"


def world_text(*sections: Sequence[str]) -> str:
    """A world file of these lines, which knows all kinds of things."""
    includes = "\n".join(f'include "{each}"' for each in dict.fromkeys(("donnie.inc", *KINDS.values())))
    parts = ("# A step is 0.05 m.", includes, "resolution 0.02", *map("\n".join, sections))
    return "\n\n".join(filter(None, parts)) + "\n"
