"""Remarks about a world that loads: what was ignored, repaired, or looks like a slip. Codes, no sentences."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum

from devices.ports.values import field, frozen


class NoteKind(Enum):
    IGNORED = "ignored"
    REPAIRED = "repaired"
    WARNING = "warning"


@frozen
class Note:
    """One remark. Codes: ``unknown-property`` (name, nearest), ``unused-property`` (name), ``not-simulated``
    (type, name), ``second-define`` (name), ``unknown-colour`` (name, nearest), ``random-colour``,
    ``lone-sensor`` (name), ``walls-made-solid`` (name), ``not-utf8`` (path), ``margin-cropped`` (path),
    ``no-robot``, ``robot-without-name`` and ``robot-renamed`` (name, alias); of a configuration file
    ``driver-not-used`` (name), ``unknown-model`` (name, nearest)."""

    kind: NoteKind
    code: str
    file: str
    line: int
    column: int
    details: Mapping[str, str | int | float] = field(default_factory=dict)


@frozen
class LoadReport:
    """What became of a world file: models by type, and everything that is worth telling."""

    files: tuple[str, ...]
    loaded: tuple[tuple[str, int], ...]
    """Built-in type and how many models of it, most frequent first."""
    notes: tuple[Note, ...]
    pictures: tuple[str, ...] = ()
    """The pictures that became walls and floors."""
