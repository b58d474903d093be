"""A bad wire: what a board says and what it is told, with bytes changed and ends cut off; seeded."""

from __future__ import annotations

from dataclasses import dataclass, field
from random import Random


@dataclass(slots=True)
class BadWire:
    """Switched on by setting a share above 0."""

    noise: float = 0.0
    """Share of the bytes, in both directions, that have one bit turned over."""
    cut: float = 0.0
    """Share of what is written to the board that loses its second half."""
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
