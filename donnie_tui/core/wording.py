"""How the core asks for sentences; the everyday words of all languages; poses, robots and things in words.

The core asks by code and parameters; the sentences themselves are in i18n.

The everyday words are in ``words.toml`` of each language, and are understood whatever language is spoken now:
a word that switches one thing switches every thing.

Poses are given as in GoDonnie: whole numbers, cut towards zero, headings from 0 to 359, eight directions.

The things of a built-in world are named in the learner's language, and adjectives and articles agree with the
noun. The gender of another world's names is unknown, so these get a phrase that needs none. The author's name
for a thing comes before its kind: "treasure, box, yellow".
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Protocol

from devices.ports.robot import Pose
from language import locales
from language.locales import ENGLISH, language_of_locale, languages
from language.source import fold_name, quoted

if TYPE_CHECKING:
    from donnie_tui.core.events import Error
    from language.diagnostics import Diagnostic
    from sim.picture import Thing

BRAILLE_CELLS = 40
"""Characters of a line that a braille display shows whole."""


class Wording(Protocol):
    """The learner's language."""

    language: str
    """Its code, such as ``en`` or ``pt``."""
    detail: str
    """``brief``, ``normal`` or ``full``."""

    def __call__(self, code: str, **values: object) -> str:
        """The sentence of a code."""

    def knows(self, code: str) -> bool:
        """Whether there is a sentence of that code."""

    def mistake(self, diagnostic: Diagnostic) -> str:
        """One sentence that says what is wrong."""

    def hint(self, diagnostic: Diagnostic) -> str | None:
        """The fix, if it is known."""

    def explanation(self, error: Error) -> tuple[str, ...]:
        """An explanation of a mistake: what to do, with an example if there is one; a line each."""

    def help(self, topic: str | None) -> tuple[str, ...]:
        """The help for a word, or the list of commands; a line each."""


_SAME = 6
"""Decimals beyond which two places are the same: 2.9999999 steps are 3."""


def whole_steps(value: float) -> int:
    """The integer part."""
    return int(round(value, _SAME))


def compass_heading(pose: Pose) -> int:
    """Whole compass degrees, 0 to 359."""
    return whole_steps(pose.heading) % 360


COMPASS = ("north", "northeast", "east", "southeast", "south", "southwest", "west", "northwest")
SIDES = ("front", "front-right", "right", "back-right", "back", "back-left", "left", "front-left")
"""The sides of the robot, clockwise from the front."""


def compass_point(degrees: float, wording: Wording) -> str:
    """The nearest of the eight points of the compass."""
    return wording(f"compass-{COMPASS[round(degrees / 45) % 8]}")


def bearing(x: float, y: float, to_x: float, to_y: float) -> float:
    """Compass degrees from one place to another."""
    return math.degrees(math.atan2(to_x - x, to_y - y)) % 360.0


def facing(pose: Pose, wording: Wording) -> str:
    """The heading in words: "north", "o norte", or "40 degrees, near northeast"."""
    degrees = compass_heading(pose)
    point = compass_point(degrees, wording)
    if degrees % 45 == 0:
        return wording("facing-exact", point=point)
    return wording("facing-between", degrees=degrees, point=point)


def position_in_words(pose: Pose, wording: Wording) -> str:
    """A robot's place and heading."""
    x, y = whole_steps(pose.x), whole_steps(pose.y)
    return wording("position", facing=facing(pose, wording), x=x, y=y)


# --- everyday words


def spelled(key: str, language: str, *section: str) -> str:
    """An everyday word as Donnie prints it: ``north`` of the section ``compass``."""
    return locales.words(language, "words", *section, key)[0]


def meant(typed: str, *section: str) -> str | None:
    """The key of a section that a word of any language means, None for any other word."""
    return _meanings(section).get(_folded(typed))


def keys_of(*section: str) -> tuple[str, ...]:
    """Every key of a section, in the order of the English table."""
    return locales.keys(ENGLISH, "words", *section)


@cache
def _meanings(section: tuple[str, ...]) -> Mapping[tuple[str, ...], str]:
    """The meanings by folded words. A word keeps the meaning of an earlier language in all later ones."""
    found: dict[tuple[str, ...], str] = {}
    for language in languages():
        for key in keys_of(*section):
            for word in locales.words(language, "words", *section, key):
                found.setdefault(_folded(word), key)
    return found


def _folded(typed: str) -> tuple[str, ...]:
    return tuple(fold_name(typed).split())


def language_named(typed: str) -> str | None:
    """The language that a code or a word means; None if there is none."""
    named = next((each for each in languages() if _is_name(typed, each)), None)
    return named or language_of_locale(typed.strip())


def _is_name(typed: str, language: str) -> bool:
    return _folded(typed) in {_folded(name) for each in languages() for name in names_of(language, each)}


def name_of_language(language: str, spoken: str) -> str:
    """The name of a language in another one, or in itself; its code if it has no name."""
    names = names_of(language, spoken) or names_of(language, language) or names_of(language, ENGLISH)
    return names[0] if names else language


def names_of(language: str, spoken: str) -> tuple[str, ...]:
    """The names of a language in the language ``spoken``."""
    return locales.own_words(spoken, "words", "languages", language)


# --- robots and things

_DONNIE = "donnie"
_COLOURS = ("red", "green", "blue", "yellow", "orange", "pink", "gray")


def shown_name(robot: str) -> str:
    """A robot's name for the map; empty for Donnie, the default."""
    return "" if robot.lower() == _DONNIE else robot


def robot_called(typed: str, names: Sequence[str]) -> str | None:
    """The name that was typed, in any case and with or without accents."""
    if typed in names:
        return typed
    return next((name for name in names if fold_name(name) == fold_name(typed)), None)


def no_such_robot(typed: str, names: Sequence[str], most: int, wording: Wording) -> str:
    """The sentence that no robot has that name, with the first names of those there are."""
    shown = [*names[:most], *(["…"] if len(names) > most else [])]
    return wording("robot-unknown", name=quoted(typed), names=all_of(shown, wording), count=len(names))


def all_of(names: Sequence[str], wording: Wording) -> str:
    """The names as a list in words: "alice, bob and carol"."""
    if len(names) < 2:
        return "".join(names)
    code = "and-before-i" if names[-1].lower().startswith(("i", "í", "hi", "hí")) else "and"
    return wording(code, first=", ".join(names[:-1]), last=names[-1])


def name_of(thing: Thing, wording: Wording) -> str:
    """A robot's name; a thing's kind, in the learner's language if its world is built in."""
    if thing.is_robot and thing.name:
        return thing.name
    return called(thing.kind, thing.name, wording)


def specific_name_of(thing: Thing, wording: Wording) -> str:
    """The author's name for this thing, else ``name_of``, which is the same for all of a kind."""
    return own_name(thing.kind, thing.name, wording) or name_of(thing, wording)


def called(kind: str, name: str, wording: Wording) -> str:
    """The kind of a thing in the learner's language, else its name in its world."""
    return noun(kind, wording) or name or kind


def the_called(kind: str, name: str, wording: Wording) -> str:
    """The same in a sentence, with its article: "the chair", "a cadeira"; a foreign name has none."""
    word = noun(kind, wording)
    if not word:
        return name or kind
    article = wording(f"article-{wording(f'gender-{kind}')}")
    return wording("the-one-colour", the=article, name=word)


def own_name(kind: str, name: str, wording: Wording) -> str:
    """The author's name for a thing, if it says more than kind, colour and a number; else empty.

    A thing of a foreign kind has no other name, so for it this is empty.
    """
    word = noun(kind, wording)
    if not word or not name:
        return ""
    plain = {kind, word, *_COLOURS}
    plain |= {wording(f"colour-{each}{end}") for each in _COLOURS for end in ("", "-f")}
    return name if _words(name) - _words(" ".join(plain)) else ""


def _words(text: str) -> set[str]:
    return set(re.findall(r"[^\W\d_]+", fold_name(text)))


def noun(kind: str, wording: Wording) -> str:
    """The word for a kind of thing; empty for kinds of foreign worlds."""
    try:
        return wording(f"thing-{kind}")
    except KeyError:
        return ""


def coloured_thing(thing: Thing, wording: Wording) -> str:
    """A thing or robot in a list: "box, red", "caixa vermelha", "tesouro, caixa vermelha"."""
    if thing.is_robot and thing.name:
        return _of_unknown_gender("listed", thing.name, thing.colour, wording)
    return coloured(thing.kind, thing.name, thing.colour, wording)


def coloured(kind: str, name: str, colour: str, wording: Wording) -> str:
    """The thing and its colour in a list: "box, red", "caixa vermelha", "puck de cor vermelha"."""
    return _phrase("listed", kind, name, colour, wording)


def the_coloured(kind: str, name: str, colour: str, wording: Wording) -> str:
    """The same in a sentence, with its article: "the red box", "a caixa vermelha", "puck de cor vermelha"."""
    return _phrase("the", kind, name, colour, wording)


def with_colour(kind: str, name: str, colour: str, wording: Wording) -> str:
    """The same in a sentence that has the article, or none: "red box", "caixa vermelha"."""
    return _phrase("plain", kind, name, colour, wording)


def shade(thing: Thing, wording: Wording) -> str:
    """The colour alone, agreeing with the thing's noun."""
    known = not thing.is_robot and noun(thing.kind, wording)
    gender = wording(f"gender-{thing.kind}") if known else ""
    return _agreeing(thing.colour, gender, wording)


def colour_initials(wording: Wording, taken: Iterable[str] = ()) -> dict[str, str]:
    """A capital letter for each colour, its first that is not ``taken`` and not another colour's."""
    from string import ascii_uppercase

    from language.keywords import COLOURS  # the first frame needs none

    used = {each.upper() for each in taken}
    found: dict[str, str] = {}
    for colour in COLOURS:
        name = wording(f"colour-{colour}").upper()
        wanted = (*name, *ascii_uppercase)
        found[colour] = next((each for each in wanted if each not in used and each.isalpha()), name[:1])
        used.add(found[colour])
    return found


def letters_of_several_colours(things: Iterable[Thing]) -> frozenset[str]:
    """The letters of things that differ in colour only."""
    colours: dict[str, set[str]] = {}
    for each in things:
        if not each.is_robot:
            colours.setdefault(each.letter, set()).add(each.colour)
    return frozenset(letter for letter, found in colours.items() if len(found) > 1)


def _phrase(form: str, kind: str, name: str, colour: str, wording: Wording) -> str:
    word = noun(kind, wording)
    if not word:
        return _of_unknown_gender(form, name or kind, colour, wording)
    gender, own = wording(f"gender-{kind}"), own_name(kind, name, wording)
    article, colour_word = wording(f"article-{gender}"), _agreeing(colour, gender, wording)
    code = "one-colour" if colour_word == word else "coloured"  # an orange is orange
    phrase = wording(f"{form}-{code}", the=article, name=word, colour=colour_word)
    return wording("own-name", name=own, thing=phrase) if own else phrase


def _of_unknown_gender(form: str, name: str, colour: str, wording: Wording) -> str:
    """Portuguese has the colour agree with "cor", Spanish with "color"."""
    agreed = _agreeing(colour, wording("gender-colour"), wording)
    return wording(f"{form}-coloured-foreign", name=name, colour=agreed)


def _agreeing(colour: str, gender: str, wording: Wording) -> str:
    return wording(f"colour-{colour}-f" if gender == "f" else f"colour-{colour}")
