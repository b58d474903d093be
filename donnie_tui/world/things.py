"""Things in words, as a legend or PUT has them, and as lines of a world file: ``chair green AS throne``.

Words of all languages are understood. Lengths in world files are metres, angles degrees counter-clockwise.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import cache
from itertools import zip_longest
from unicodedata import normalize

from msgspec import Struct

from donnie_tui.core.wording import Wording, coloured_thing, meant, noun
from donnie_tui.i18n.words import Unusable, Words
from language.keywords import COLOURS
from language.locales import languages
from language.source import fold, fold_name
from language.suggestions import nearest
from sim.picture import Thing

WALL = "wall"
WALL_HEIGHT = 0.24
"""Metres."""
KINDS = {
    **dict.fromkeys(("chair", "table", "small_sofa", "large_sofa"), "furniture.inc"),
    **dict.fromkeys(("box", "ball", "cone", "post", "flower", "stone", "crystal"), "things.inc"),
    **dict.fromkeys(("orange", "carton", "belt"), "juice.inc"),
    WALL: "things.inc",
}
"""What there is, by the words of world files, with the files that define it."""


class BadDescription(Unusable):
    """Words that mean no thing."""

    def __init__(self, mistakes: Mapping[int, str]) -> None:
        """``mistakes``: the sentences by their places in the text."""
        super().__init__(*mistakes.values())
        self.mistakes = mistakes


class Description(Struct, frozen=True):
    """A thing in words: ``chair green AS throne``."""

    kind: str
    colours: tuple[str, ...] = ()
    marks: Mapping[str, str] = {}
    """The colours by the letters in the midst of things that have them, if they have some."""
    name: str = ""


@cache
def _kinds() -> Mapping[str, str]:
    """By the folded words of all languages."""
    found = {kind.replace("_", " "): kind for kind in KINDS}
    for words in map(Words, languages()):
        for kind in KINDS:
            found.setdefault(fold_name(word_for(kind, words)), kind)
    return found


@cache
def _kind_in_a_text() -> re.Pattern[str]:
    known = "|".join(re.escape(each).replace(r"\ ", r"\s+") for each in sorted(_kinds(), key=len)[::-1])
    return re.compile(rf"(?<![^\s,:;.])(?:{known})(?![^\s,:;.])")


@cache
def _colours() -> Mapping[str, str]:
    """By the folded words of all languages, also as they agree with a thing."""
    every = [(Words(each), colour) for each in languages() for colour in COLOURS]
    return {
        fold_name(words(f"colour-{colour}{end}")): colour for words, colour in every for end in ("", "-f")
    }


def word_for(kind: str, wording: Wording) -> str:
    """A kind in the learner's language; of another author's world its own word."""
    return wording("cell-wall") if kind == WALL else noun(kind, wording) or kind


def thing_in_words(thing: Thing, wording: Wording) -> str:
    """A thing in a list; a wall without a name of its own with its number: "parede 2"."""
    if thing.kind != WALL:
        return coloured_thing(thing, wording)
    return re.sub(rf"^{WALL}(?=$| \d+$)", wording("cell-wall"), thing.name or WALL)


def means_wall(text: str) -> bool:
    """Whether one of the words means a wall in any language."""
    return any(_kinds().get(fold_name(each)) == WALL for each in text.split())


def split_name(text: str) -> tuple[str, str | None]:
    """The words for a thing, and its name after AS; None without AS."""
    words = re.finditer(r"\S+", text)
    as_ = next((each for each in words if meant(each[0], "building") == "as"), None)
    return (text[: as_.start()], text[as_.end() :].strip(" .")) if as_ else (text, None)


def description_of(text: str, wording: Wording) -> Description:
    """What a thing is. Raises ``BadDescription`` with all words that mean nothing.

    A word that is a colour too, such as orange, is the kind only if nothing else is.
    """
    text = normalize("NFC", text)
    found = [*_kind_in_a_text().finditer(fold(text).replace("_", " "))]
    kind = next((each for each in found if each[0] not in _colours()), next(iter(found), None))
    begin, end = kind.span() if kind else (0, 0)
    rest = [each for each in re.finditer(r"[^\s,:;.…]+", text) if not begin <= each.start() < end]
    colours, marks, mistakes = list[str](), list[str](), dict[int, str]()
    for each, following in zip_longest(rest, rest[1:]):
        colour = _colours().get(fold_name(each[0]))
        if colour:
            colours.append(colour)
        elif (
            _is_letter(each[0])
            and each.start() >= end
            and following
            and fold_name(following[0]) in _colours()
        ):
            marks.append(each[0])
        else:
            near = near_word(each[0], wording)
            code = "drawing-word-near" if near else "drawing-word"
            mistakes[each.start()] = wording(code, word=each[0][:40], near=near)
    if kind is None and not mistakes:
        known = ", ".join(word_for(each, wording) for each in KINDS if each != WALL)
        mistakes[0] = wording("drawing-no-kind", known=known)
    if kind is None or mistakes:
        raise BadDescription(mistakes)
    marked = dict(zip(marks, colours, strict=True)) if len(marks) == len(colours) else {}
    return Description(_kinds()[" ".join(kind[0].split())], () if "…" in text else tuple(colours), marked)


def _is_letter(word: str) -> bool:
    return len(word) == 1 and word.isalpha()


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
    parts = (
        f"name {quoted(name)}" if name else "",
        f"pose [ {x:g} {y:g} 0 {angle:g} ]",
        f"size [ {' '.join(f'{each:.6g}' for each in size)} ]" if size else "",
        f'color "{colour}"' if colour else "",
    )
    return f"{kind}( {' '.join(filter(None, parts))} )"


def quoted(name: str) -> str:
    """A string of a world file, which knows no escapes."""
    return '"' + "".join(each for each in name if each.isprintable() and each not in '"\\')[:60] + '"'


def world_text(*sections: Sequence[str]) -> str:
    """A world file of these lines, with the files that they need."""
    kinds = {line.partition("(")[0] for section in sections for line in section}
    files = dict.fromkeys(file for kind, file in KINDS.items() if kind in kinds)
    includes = "\n".join(f'include "{each}"' for each in ("donnie.inc", *files))
    parts = ("# A step is 0.05 m.", includes, "resolution 0.02", *map("\n".join, sections))
    return "\n\n".join(filter(None, parts)) + "\n"
