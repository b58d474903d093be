"""Colours: as a world names them, as red, green and blue, and as the word that a learner uses for them."""

from __future__ import annotations

from collections.abc import Iterable

from devices.ports.values import Frozen

FAMILIES = ("red", "green", "blue", "yellow", "orange", "pink", "gray")
"""The colour words of the language."""


class Colour(Frozen):
    """A colour of a model. Components from 0 to 1."""

    name: str
    """As the world names it; empty where it gives numbers."""
    red: float
    green: float
    blue: float
    alpha: float
    family: str
    """The word of the language for it."""

    def same(self, other: Colour) -> bool:
        """Equal as Stage's blobfinder compares: without the alpha, to a level of 255."""
        pairs = ((self.red, other.red), (self.green, other.green), (self.blue, other.blue))
        return all(abs(mine - theirs) < 1 / 255 for mine, theirs in pairs)


def colour_of(name: str, red: float, green: float, blue: float, alpha: float = 1.0) -> Colour:
    """A colour as a world file gives it."""
    return Colour(name, red, green, blue, alpha, _family(name.lower(), red, green, blue))


def families(told_apart: Iterable[tuple[Colour, ...]]) -> frozenset[str]:
    """The words of the language for what cameras tell apart, each so many colours; all where one has none."""
    cameras = tuple(told_apart)
    if not all(cameras):
        return frozenset(FAMILIES)
    return frozenset(colour.family for colours in cameras for colour in colours)


def _level(value: float) -> float:
    return min(1.0, max(0.0, value))


def _family(name: str, red: float, green: float, blue: float) -> str:
    """Every colour has one; black and white are gray."""
    if "gray" in name or "grey" in name:
        return "gray"
    if "pink" in name:
        return "pink"
    from colorsys import rgb_to_hsv  # a world that ships was read before

    return _family_of_hue(*rgb_to_hsv(_level(red), _level(green), _level(blue)))


def _family_of_hue(hue: float, saturation: float, value: float) -> str:
    if saturation < 0.15 or value < 0.15:
        return "gray"
    degrees = hue * 360
    if (degrees < 12 or degrees >= 345) and saturation < 0.5 and value > 0.6:
        return "pink"
    borders = ((12, "red"), (48, "orange"), (70, "yellow"), (165, "green"), (270, "blue"), (345, "pink"))
    return next((family for border, family in borders if degrees < border), "red")
