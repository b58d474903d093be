"""What is remarked of a world file: what was ignored or repaired, or looks like a slip. Codes only."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum

from devices.ports.values import Frozen, field


class NoteKind(Enum):
    IGNORED = "ignored"
    REPAIRED = "repaired"
    WARNING = "warning"


class Note(Frozen):
    """One remark. Codes: ``unknown-property`` (name, nearest), ``unused-property`` (name), ``not-simulated``
    (type, name), ``second-define`` (name), ``unknown-colour`` (name, nearest), ``random-colour``,
    ``lone-sensor`` (name), ``walls-made-solid`` (name), ``not-utf8`` (path), ``margin-cropped`` (path),
    ``no-robot``, ``robot-without-name`` and ``robot-renamed`` (name, alias), ``starts-inside`` (name,
    thing); of a configuration file ``driver-not-used`` (name), ``unknown-model`` (name, nearest)."""

    kind: NoteKind
    code: str
    file: str
    line: int
    column: int
    details: Mapping[str, str | int | float] = field(default_factory=dict)
