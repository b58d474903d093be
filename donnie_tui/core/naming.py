"""What a thing is called, with its colour: in the learner's language where its world is one of ours.

Adjectives and articles agree with the noun. What another world calls its things has no known gender, so these
get a phrase that needs none. What its author calls a thing comes before what it is: "treasure, box, yellow".
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from devices.ports.hints import TYPE_CHECKING
from donnie_tui.core.wording import Wording
from language.source import fold_name

if TYPE_CHECKING:
    from sim.picture import Thing


_DONNIE = "donnie"
_COLOURS = ("red", "green", "blue", "yellow", "orange", "pink", "gray")


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


def told_name_of(thing: Thing, wording: Wording) -> str:
    """Of this one: as its author calls it, else as ``name_of``, which is the same for all of a kind."""
    return own_name(thing.kind, thing.name, wording) or name_of(thing, wording)


def called(kind: str, name: str, wording: Wording) -> str:
    """The kind of a thing in the learner's language, else what its world calls it."""
    return noun(kind, wording) or name or kind


def own_name(kind: str, name: str, wording: Wording) -> str:
    """What its author calls it where that says more than its kind, its colour and a number; else empty.

    Of a thing of a foreign kind nothing else is told, so that is no name of its own.
    """
    word = noun(kind, wording)
    if not word or not name:
        return ""
    plain = {kind, word, *_COLOURS}
    plain |= {_agreeing(each, gender, wording) for each in _COLOURS for gender in ("m", "f")}
    return name if _words(name) - _words(" ".join(plain)) else ""


def _words(text: str) -> set[str]:
    return set(re.findall(r"[^\W\d_]+", fold_name(text)))


def noun(kind: str, wording: Wording) -> str:
    """The word for a kind of thing; empty for those of foreign worlds."""
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
    gender, own = wording(f"gender-{kind}"), own_name(kind, name, wording)
    article, colour_word = wording(f"article-{gender}"), _agreeing(colour, gender, wording)
    code = "one-colour" if colour_word == word else "coloured"  # an orange is orange
    told = wording(f"{form}-{code}", the=article, name=word, colour=colour_word)
    return wording("own-name", name=own, thing=told) if own else told


def _of_unknown_gender(form: str, name: str, colour: str, wording: Wording) -> str:
    """Portuguese has the colour agree with "cor", Spanish with "color"."""
    agreed = _agreeing(colour, wording("gender-colour"), wording)
    return wording(f"{form}-coloured-foreign", name=name, colour=agreed)


def _agreeing(colour: str, gender: str, wording: Wording) -> str:
    return wording(f"colour-{colour}-f" if gender == "f" else f"colour-{colour}")
