"""How many rays a second: the rays of the simulator against a loop over pymunk's ``segment_query_first``.

The same rays through the same field of boxes, interleaved; both must find the same. Ratios above 1: faster.
"""

from __future__ import annotations

import random
import statistics
import time
from math import cos, radians, sin

import pymunk

from sim.rays import Rays

ROUNDS = 41
BOXES = 200
REACH = 8.0
COUNTS = (8, 180, 600, 5000)
EVERYTHING = pymunk.ShapeFilter()


def main() -> None:
    """Measure and print."""
    space, shapes = _field()
    quick: Rays[int] = Rays(space)
    plain: Rays[int] = Rays(space, direct=False)
    for i, shape in enumerate(shapes):
        quick.own(shape, i)
        plain.own(shape, i)
    for count in COUNTS:
        _measure(quick, plain, count)


def _field() -> tuple[pymunk.Space, list[pymunk.Poly]]:
    space, chance = pymunk.Space(), random.Random(1)
    shapes = []
    for _ in range(BOXES):
        x, y = chance.uniform(-10, 10), chance.uniform(-10, 10)
        shapes.append(
            pymunk.Poly(space.static_body, [(x, y), (x + 0.4, y), (x + 0.4, y + 0.4), (x, y + 0.4)])
        )
    space.add(*shapes)
    return space, shapes


def _measure(quick: Rays[int], plain: Rays[int], count: int) -> None:
    angles = [radians(360 * i / count) for i in range(count)]
    ends = [(REACH * cos(angle), REACH * sin(angle)) for angle in angles]
    if quick.first_hits(0, 0, ends, EVERYTHING) != plain.first_hits(0, 0, ends, EVERYTHING):
        raise SystemExit("the two ways differ")
    repeats, ratios, microseconds = max(1, 2000 // count), [], []
    for _ in range(ROUNDS):
        slow, fast = _seconds(plain, ends, repeats), _seconds(quick, ends, repeats)
        ratios.append(slow / fast)
        microseconds.append(fast / repeats / count * 1e6)
    low, middle, high = statistics.quantiles(ratios, n=4)
    ray = statistics.median(microseconds)
    print(
        f"{count} rays: {middle:.2f} ({low:.2f} to {high:.2f}), target >= 2.4; {ray:.2f} microseconds a ray"
    )


def _seconds(rays: Rays[int], ends: list[tuple[float, float]], repeats: int) -> float:
    began = time.perf_counter()
    for _ in range(repeats):
        rays.first_hits(0.0, 0.0, ends, EVERYTHING)
    return time.perf_counter() - began


if __name__ == "__main__":
    main()
