"""A sentence of the catalogue with its values, before it is said."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct, field


class Answer(Struct, frozen=True):
    """A sentence of the catalogue, to be said."""

    code: str
    values: Mapping[str, object] = field(default_factory=dict)
    of_robot: bool = False
    """Whether it is about the robot that the learner talks to, which is named where there are several."""
