"""The speeds that SLOWER and FASTER choose from, and their words. None is as fast as possible."""

from __future__ import annotations

from donnie_tui.core.wording import Wording

SPEEDS: tuple[float | None, ...] = (1.0, 2.0, 5.0, 10.0, 20.0, 50.0, None)
"""Times the real robot's pace."""


def faster(speed: float | None) -> float | None:
    """The next speed above ``speed``; the fastest has none above it."""
    return next((each for each in SPEEDS if _is_faster(each, speed)), None)


def slower(speed: float | None) -> float | None:
    """The next speed below ``speed``; one that is below all of them stays."""
    below = [each for each in SPEEDS if _is_faster(speed, each)]
    return below[-1] if below else speed


def speed_words(speed: float | None, words: Wording) -> str:
    return words("speed-max") if speed is None else words("decimal", number=speed)


def _is_faster(one: float | None, other: float | None) -> bool:
    return other is not None and (one is None or one > other)
