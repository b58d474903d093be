"""What the conductor can ask for, to be done by the service in the order given."""

from __future__ import annotations

from dataclasses import dataclass

from devices.audio_worker.messages import Order
from devices.audio_worker.notices import AudioNotice


@dataclass(frozen=True, slots=True)
class Start:
    """Start a worker. ``prefer_bundled_voice`` after one that died loading the system's."""

    prefer_bundled_voice: bool


@dataclass(frozen=True, slots=True)
class Send:
    order: Order


@dataclass(frozen=True, slots=True)
class Kill:
    """End the worker and everything that it started."""


@dataclass(frozen=True, slots=True)
class Tell:
    notice: AudioNotice


Step = Start | Send | Kill | Tell
