"""What is told at the first start only: the tour, and what was decided about the voice. Never a question.

What remembers the tour is an empty file in the state folder; the setting ``tour``, off, keeps it silent. What
was decided about the voice is told again once it is another decision. The first prompt asks here before
anything heavy is loaded, so this module loads nothing.
"""

from __future__ import annotations

import os

from donnie_tui.settings import OFF

MARKER = "tour-was-offered"
VOICE_MARKER = "voice-was-told"

TYPE_CHECKING = False  # that of typing costs as much as the rest of the first prompt
if TYPE_CHECKING:
    from collections.abc import Mapping


def offers_tour(folder: str, environment: Mapping[str, str]) -> bool:
    """Whether it is to be offered now; the next time it is not. ``folder``: the one of the state."""
    path = f"{folder}/{MARKER}"
    if environment.get("DONNIE_TOUR", "").strip().lower() in OFF or os.path.exists(path):  # noqa: PTH110 -- pathlib is slow to load
        return False
    try:
        os.makedirs(folder, exist_ok=True)  # noqa: PTH103
        os.close(os.open(path, os.O_WRONLY | os.O_CREAT, 0o600))
    except OSError:  # then it is offered again
        pass
    return True


def is_new_decision(folder: str, decided: str) -> bool:
    """Whether this is to be told of the voice now; the next time it is not, unless it has changed."""
    path = f"{folder}/{VOICE_MARKER}"
    try:
        with open(path, encoding="utf-8") as kept:  # noqa: PTH123 -- pathlib is slow to load
            if kept.read(len(decided) + 1) == decided:
                return False
    except (OSError, ValueError):
        pass
    try:
        os.makedirs(folder, exist_ok=True)  # noqa: PTH103
        with open(path, "w", encoding="utf-8") as kept:  # noqa: PTH123
            kept.write(decided)
    except OSError:  # then it is told again
        pass
    return True
