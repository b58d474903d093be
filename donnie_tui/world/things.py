"""Things in words, as a legend or PUT has them, and as lines of a world file: ``chair green AS throne``.

Words of all languages are understood. Lengths in world files are metres, angles degrees counter-clockwise.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path

from msgspec import Struct

import worlds
from devices.ports.robot import STEP
from donnie_tui.core.wording import Wording, coloured_thing, meant
from donnie_tui.i18n.words import Words
from language.keywords import argument, argument_words
from language.locales import languages
from language.source import fold_name
from language.suggestions import nearest
from sim.picture import Thing

KINDS = {
    "furniture.inc": ("chair", "table", "small_sofa", "large_sofa"),
    "things.inc": ("box", "ball", "cone", "post", "flower", "stone", "crystal"),
    "juice.inc": ("orange", "carton", "belt"),
}
"""The things that there are, by the files that define them."""


WALL = "wall"
WALL_HEIGHT = 0.24
"""Metres."""


class Slip(Struct, frozen=True):
    """One mistake: the code of its sentence, its place (0: nowhere) and its values."""

    code: str
    line: int = 0
    column: int = 0
    values: Mapping[str, object] = {}


class BadDrawing(Exception):
    """A drawing with mistakes, in the order of their places."""

    def __init__(self, slips: Iterable[Slip]) -> None:
        super().__init__("drawing")
        self.slips = tuple(sorted(slips, key=lambda each: (each.line, each.column)))


MOST_SLIPS = 20
"""Mistakes that are listed."""


def slips_in_words(bad: BadDrawing, file: str, words: Wording) -> tuple[str, ...]:
    """A sentence for each mistake, with its place in ``file``, and how many there are."""
    return (
        *(_slip_in_words(each, file, words) for each in bad.slips[:MOST_SLIPS]),
        words("world-new-mistakes", count=len(bad.slips)),
    )


def message_of(slip: Slip, words: Wording) -> str:
    """The sentence without a place."""
    named = {key: _kind_in_words(str(value), words) for key, value in slip.values.items() if key in _NAMED}
    known = ", ".join(words(f"thing-{kind}") for kind in kinds())
    return words(slip.code, **{"known": known, **slip.values, **named})


def _slip_in_words(slip: Slip, file: str, words: Wording) -> str:
    message = message_of(slip, words)
    if not slip.line:
        return words("drawing-error", file=file, message=message)
    return words("world-error-at", file=file, line=slip.line, column=slip.column, message=message)


_NAMED = ("thing", "other", "near")


def _kind_in_words(kind: str, words: Wording) -> str:
    if kind == WALL:
        return words("cell-wall")
    return words(f"thing-{kind}") if kind in kinds() else kind


class Description(Struct, frozen=True):
    """A thing in words: ``chair green AS throne``."""

    kind: str
    colours: tuple[str, ...] = ()
    name: str = ""
    marks: tuple[str, ...] = ()
    """The letters in the midst of the things of each colour, if the colours have some."""


def kinds() -> tuple[str, ...]:
    """The words of world files for the things that there are."""
    return tuple(kind for each in KINDS.values() for kind in each)


@cache
def _kinds_by_word() -> Mapping[str, str]:
    """By the folded words of all languages."""
    found = {kind.replace("_", " "): kind for kind in kinds()}
    for language in languages():
        words = Words(language)
        for kind in kinds():
            found.setdefault(fold_name(words(f"thing-{kind}")), kind)
    return found


@cache
def _colours_by_word() -> Mapping[str, str]:
    """By the folded words of all languages: those of GoDonnie, and as they agree with a thing."""
    found: dict[str, str] = {}
    for language in languages():
        words = Words(language)
        for typed in argument_words("COLOUR", language):
            colour = argument("COLOUR", typed)
            if colour is not None:
                key = str(colour.value)
                for word in (typed, words(f"colour-{key}"), words(f"colour-{key}-f")):
                    found.setdefault(fold_name(word), key)
    return found


def colour_meant(word: str) -> str | None:
    """The colour that a word of any language means, as GoDonnie and world files have it."""
    return _colours_by_word().get(fold_name(word))


@cache
def _walls_by_word() -> frozenset[str]:
    return frozenset(fold_name(Words(each)("cell-wall")) for each in languages())


def means_wall(word: str) -> bool:
    """Whether it is the word for a wall in any language."""
    return fold_name(word).strip() in _walls_by_word()


def thing_in_words(thing: Thing, wording: Wording) -> str:
    """A thing in a list; a wall without a name of its own with its number: "parede 2"."""
    if thing.kind != WALL:
        return coloured_thing(thing, wording)
    return re.sub(rf"^{WALL}(?=$| \d+$)", wording("cell-wall"), thing.name or WALL)


_LONGEST_KIND = 3
"""Words."""


def description_of(text: str, line: int = 0, column: int = 1) -> Description:
    """What a thing is. ``line`` and ``column``: where the text begins. Raises ``BadDrawing``."""
    found = [(each.group(), each.start()) for each in re.finditer(r"[^\s,:;.]+", text)]
    at_name = next((at for at, (word, _) in enumerate(found) if meant(word, "building") == "as"), len(found))
    words = [word for word, _ in found[:at_name]]
    kind_at, length = _place_of_kind(words)
    colours, unknown = list[str](), list[Slip]()
    marks = [
        word
        for word, following in zip(words[kind_at + length :], words[kind_at + length + 1 :], strict=False)
        if len(word) == 1 and word.isalpha() and colour_meant(following)
    ]
    for at, word in enumerate(words):
        if kind_at <= at < kind_at + length or word == "…" or word in marks:
            continue
        colour = colour_meant(word)
        if colour is None:
            unknown.append(_unknown_word(word, line, column + found[at][1]))
        else:
            colours.append(colour)
    if unknown:
        raise BadDrawing(unknown)
    if not length:
        raise BadDrawing([Slip("drawing-no-kind", line, column)])
    name = ""
    if at_name < len(found):
        word, start = found[at_name]
        name = text[start + len(word) :].strip().rstrip(".").strip()
    kind = _kinds_by_word()[_joined(words[kind_at : kind_at + length])]
    is_marked = len(marks) == len(colours)
    return Description(kind, () if "…" in words else tuple(colours), name, tuple(marks) if is_marked else ())


def _place_of_kind(words: Sequence[str]) -> tuple[int, int]:
    """Where the words for a kind of thing begin, and how many there are; 0 if there are none.

    A word that is a colour too, such as orange, is the kind only if nothing else is.
    """
    found = [
        (at, length)
        for at in range(len(words))
        for length in range(min(_LONGEST_KIND, len(words) - at), 0, -1)
        if _joined(words[at : at + length]) in _kinds_by_word()
    ]
    plain = [each for each in found if each[1] > 1 or colour_meant(words[each[0]]) is None]
    return next(iter(plain or found), (0, 0))


def _joined(words: Iterable[str]) -> str:
    return fold_name(" ".join(words)).replace("_", " ")


def _unknown_word(word: str, line: int, column: int) -> Slip:
    known = _kinds_by_word()
    parts = {part: kind for each, kind in reversed(tuple(known.items())) for part in each.split()}
    near = nearest(word, [*known, *parts, *_colours_by_word()])
    if near and near not in known:
        near = parts.get(near, near)
    values = {"word": word[:40], "near": near}
    return Slip("drawing-word-near" if near else "drawing-word", line, column, values)


# --- lines of a world file


def thing_line(kind: str, colour: str, name: str, pose: tuple[float, float, float], size: str = "") -> str:
    """A thing as a world file has it, in metres and degrees."""
    x, y, angle = pose
    parts = [f"name {quoted(name)}", f"pose [ {x:g} {y:g} 0 {angle:g} ]", size]
    parts.append(f'color "{colour}"' if colour else "")
    return f"{kind}( {' '.join(filter(None, parts))} )"


def quoted(name: str) -> str:
    """A string of a world file, which knows no escapes."""
    return '"' + "".join(each for each in name if each.isprintable() and each not in '"\\')[:60] + '"'


def world_text(used: Iterable[str], lines: Iterable[str]) -> str:
    """A world file with the includes that these lines of things need."""
    words = {each.partition("(")[0] for each in used}
    files = ["donnie.inc", "furniture.inc", "things.inc"]
    files += ["juice.inc"] if words & {*KINDS["juice.inc"]} else []
    includes = (f'include "{each}"' for each in files)
    text = "\n".join(["# A step is 0.05 m.", "", *includes, "", "resolution 0.02", "", *lines])
    return re.sub(r"\n{3,}", "\n\n", text).strip() + "\n"


@cache
def usual_sizes() -> Mapping[str, tuple[float, float, float]]:
    """Metres, by kind: from west to east, from south to north, and up."""
    from sim.worldfile import load_text  # loads the parser

    lines = [f"{kind}()" for kind in kinds()]
    text = world_text(lines, lines)
    scene = load_text(text, Path(worlds.SCENES, "sizes.world"), allowed=(Path(worlds.SCENES),))
    return {each.kind: each.size for each in scene.models}


def fitted(kind: str, width: int, depth: int, slack: int) -> tuple[int, str]:
    """The angle and the size of a thing that large (steps): its usual size if ``slack`` less at most."""
    usual = usual_sizes()[kind]
    across, along = usual[0] / STEP, usual[1] / STEP
    for angle, (mine, other) in ((0, (across, along)), (90, (along, across))):
        if -0.01 <= width - mine <= slack and -0.01 <= depth - other <= slack:
            return angle, ""
    return 0, f"size [ {width * STEP:.6g} {depth * STEP:.6g} {usual[2]:g} ]"
