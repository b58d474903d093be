"""What the conductor can ask for, to be done by the service in the order given."""

from __future__ import annotations

from devices.audio_worker.messages import Order
from devices.audio_worker.notices import AudioNotice
from devices.ports.values import frozen


@frozen
class Start:
    """Start a worker. ``prefer_bundled_voice`` after one that died loading the system's."""

    prefer_bundled_voice: bool


@frozen
class Send:
    order: Order


@frozen
class Kill:
    """End the worker and everything that it started."""


@frozen
class Tell:
    notice: AudioNotice


Step = Start | Send | Kill | Tell
