"""What a thing is called, with its colour: in the learner's language where its world is one of ours.

Adjectives and articles agree with the noun. What another world calls its things has no known gender, so these
get a phrase that needs none.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from donnie_tui.core.wording import Wording

if TYPE_CHECKING:
    from sim.picture import Thing


_DONNIE = "donnie"


def shown_name(robot: str) -> str:
    """A robot's name where it stands for itself in a map; empty for Donnie, who is called so anyway."""
    return "" if robot.lower() == _DONNIE else robot


def no_such_robot(typed: str, names: Sequence[str], most: int, wording: Wording) -> str:
    """That none is called so, and what they are called, so many of them at most."""
    shown = [*names[:most], *(["…"] if len(names) > most else [])]
    return wording("robot-unknown", name=typed[:40], names=all_of(shown, wording), count=len(names))


def all_of(names: Sequence[str], wording: Wording) -> str:
    """They as a list in words: "alice, bob and carol"."""
    if len(names) < 2:
        return "".join(names)
    code = "and-before-i" if names[-1].lower().startswith(("i", "í", "hi", "hí")) else "and"
    return wording(code, first=", ".join(names[:-1]), last=names[-1])


def name_of(thing: Thing, wording: Wording) -> str:
    """A robot's own name; a thing's kind in the learner's language where it is one of our worlds'."""
    if thing.is_robot and thing.name:
        return thing.name
    return called(thing.kind, thing.name, wording)


def called(kind: str, name: str, wording: Wording) -> str:
    """The kind of a thing in the learner's language, else what its world calls it."""
    return noun(kind, wording) or name or kind


def noun(kind: str, wording: Wording) -> str:
    """The word for a kind of thing; empty for those of foreign worlds."""
    try:
        return wording(f"thing-{kind}")
    except KeyError:
        return ""


def coloured_thing(thing: Thing, wording: Wording) -> str:
    """A thing or robot in a list: "box, red", "caixa vermelha"."""
    if thing.is_robot and thing.name:
        return _of_unknown_gender("listed", thing.name, thing.colour, wording)
    return coloured(thing.kind, thing.name, thing.colour, wording)


def coloured(kind: str, name: str, colour: str, wording: Wording) -> str:
    """What stands in a list: "box, red", "caixa vermelha", "puck de cor vermelha"."""
    return _phrase("listed", kind, name, colour, wording)


def the_coloured(kind: str, name: str, colour: str, wording: Wording) -> str:
    """In a sentence, with its article: "the red box", "a caixa vermelha", "puck de cor vermelha"."""
    return _phrase("the", kind, name, colour, wording)


def shade(thing: Thing, wording: Wording) -> str:
    """The colour alone, agreeing with what the thing is called."""
    known = not thing.is_robot and noun(thing.kind, wording)
    gender = wording(f"gender-{thing.kind}") if known else "m"
    return _agreeing(thing.colour, gender, wording)


def _phrase(form: str, kind: str, name: str, colour: str, wording: Wording) -> str:
    word = noun(kind, wording)
    if not word:
        return _of_unknown_gender(form, name or kind, colour, wording)
    gender = wording(f"gender-{kind}")
    article, colour_word = wording(f"article-{gender}"), _agreeing(colour, gender, wording)
    if colour_word == word:  # an orange is orange
        return wording(f"{form}-one-colour", the=article, name=word)
    return wording(f"{form}-coloured", the=article, name=word, colour=colour_word)


def _of_unknown_gender(form: str, name: str, colour: str, wording: Wording) -> str:
    """Portuguese has the colour agree with "cor", Spanish with "color"."""
    agreed = _agreeing(colour, wording("gender-colour"), wording)
    return wording(f"{form}-coloured-foreign", name=name, colour=agreed)


def _agreeing(colour: str, gender: str, wording: Wording) -> str:
    return wording(f"colour-{colour}-f" if gender == "f" else f"colour-{colour}")
