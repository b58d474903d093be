"""The number of random examples of a test: all in the slow check, a tenth in the quick one."""

from __future__ import annotations

from hypothesis import settings

OF_A_HUNDRED = {"quick": 10, "thorough": 100}
"""For each profile, how many of a hundred examples are tried."""


def register_profiles() -> None:
    """The quick check tries the same examples each time, so that it never fails by chance."""
    settings.register_profile("quick", deadline=None, max_examples=OF_A_HUNDRED["quick"], derandomize=True)
    settings.register_profile("thorough", deadline=None, max_examples=OF_A_HUNDRED["thorough"])
    settings.load_profile("quick")


def examples(number: int) -> int:
    """As many of that number as the profile tries."""
    return max(1, number * settings.default.max_examples // 100)
