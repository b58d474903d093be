"""The tour is offered at the first start, once: a sentence, never a question.

What remembers it is an empty file in the state folder; the setting ``tour``, off, keeps it silent. The first
prompt asks here before anything heavy is loaded, so this module loads nothing.
"""

from __future__ import annotations

import os

MARKER = "tour-was-offered"

_OFF = ("off", "no", "false", "0")

TYPE_CHECKING = False  # that of typing costs as much as the rest of the first prompt
if TYPE_CHECKING:
    from collections.abc import Mapping


def offers_tour(folder: str, environment: Mapping[str, str]) -> bool:
    """Whether it is to be offered now; the next time it is not. ``folder``: the one of the state."""
    path = f"{folder}/{MARKER}"
    if environment.get("DONNIE_TOUR", "").strip().lower() in _OFF or os.path.exists(path):  # noqa: PTH110 -- pathlib is slow to load
        return False
    try:
        os.makedirs(folder, exist_ok=True)  # noqa: PTH103
        os.close(os.open(path, os.O_WRONLY | os.O_CREAT, 0o600))
    except OSError:  # then it is offered again
        pass
    return True
