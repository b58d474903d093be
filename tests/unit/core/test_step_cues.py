"""Every step and every ten degrees are a cue, at any speed of the simulation."""

from __future__ import annotations

from collections import Counter

import pytest

from donnie_tui.core.events import CueSounded
from tests.floor import Floor


@pytest.mark.parametrize("speed", [None, 100.0, 1000.0])
def test_ten_steps_are_ten_cues_and_a_right_angle_nine(speed: float | None) -> None:
    floor = Floor(speed=speed)
    floor.run("FW 10 BW 3 TR 90 TL 180")

    counted = Counter(event.name for event in floor.events if isinstance(event, CueSounded))
    assert (counted["step-forward"], counted["step-back"]) == (10, 3)
    assert (counted["turn-right"], counted["turn-left"]) == (9, 18)
