"""What the conductor can ask for, to be done by the service in the order given."""

from __future__ import annotations

from devices.audio_worker.messages import Order
from devices.audio_worker.notices import AudioNotice
from devices.ports.values import Frozen


class Start(Frozen):
    """Start a worker. ``prefer_bundled_voice`` after one that died loading the system's."""

    prefer_bundled_voice: bool


class Send(Frozen):
    order: Order


class Kill(Frozen):
    """End the worker and everything that it started."""


class Tell(Frozen):
    notice: AudioNotice


Step = Start | Send | Kill | Tell
