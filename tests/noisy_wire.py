"""A faulty wire between a host and a simulated board."""

from __future__ import annotations

from dataclasses import dataclass, field
from random import Random

from devices.board_simulator.board import PASSES, SimulatedBoard
from devices.board_simulator.floor import Floor


@dataclass(slots=True)
class NoisyWire:
    """A faulty wire between host and board: it changes bits and cuts frames, repeatably by its seed."""

    noise: float = 0.0
    """Share of the bytes, in both directions, that have one bit flipped."""
    cut: float = 0.0
    """Share of the writes to the board that lose their second half."""
    seed: int = 0
    _random: Random = field(default_factory=Random, init=False, repr=False)

    def __post_init__(self) -> None:
        self._random = Random(self.seed)

    def to_host(self, data: bytes) -> bytes:
        return self._noisy(data) if self.noise else data

    def to_board(self, data: bytes) -> bytes:
        if self.cut and self._random.random() < self.cut:
            data = data[: len(data) // 2]
        return self._noisy(data) if self.noise else data

    def _noisy(self, data: bytes) -> bytes:
        chance = self._random.random
        if not any(hit := [chance() < self.noise for _ in data]):
            return data
        return bytes(b ^ (1 << self._random.randrange(8)) if h else b for b, h in zip(data, hit, strict=True))


class WiredBoard(SimulatedBoard):
    """A simulated board at the end of such a wire."""

    def __init__(
        self,
        floor: Floor | None = None,
        *,
        boot_loader: float,
        passes: int = PASSES,
        wire: NoisyWire | None = None,
    ) -> None:
        super().__init__(floor, boot_loader=boot_loader, passes=passes)
        self.wire = wire or NoisyWire()

    def receive(self, data: bytes) -> None:
        super().receive(self.wire.to_board(data))

    def advance(self, seconds: float) -> bytes:
        return self.wire.to_host(super().advance(seconds))
