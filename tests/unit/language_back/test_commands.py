"""Each command is one action, and each place of an expression may hold a long one."""

from __future__ import annotations

import pytest

from devices.ports.robot import Bearing
from tests.unit.language_back.recorder import BACK_ENDS, Make, run

back_ends = pytest.mark.parametrize("make", BACK_ENDS.values(), ids=BACK_ENDS.keys())


@back_ends
@pytest.mark.parametrize(
    ("source", "action"),
    [
        ("FW 2", ("forward", 2, "FW 2")),
        ("PARA   FRENTE -1", ("forward", -1, "PARA FRENTE -1")),
        ("PT 1 + 2", ("backward", 3, "PT 1 + 2")),
        ("TR 90", ("turn_right", 90, "TR 90")),
        ("girar esquerda 45", ("turn_left", 45, "girar esquerda 45")),
        ("WAIT 3", ("wait", 3)),
        ("SPEAK 3", ("speak", 3)),
        ('SPEAK "a  b"', ("speak", "a  b")),
        ('SPEAK ""', ("speak", "")),
        ("SOUND ON", ("sound", True)),
        ("SOM DESLIGADO", ("sound", False)),
        ("BELT ON", ("belt", True)),
        ("BELT OFF", ("belt", False)),
        ("SCAN", ("scan",)),
        ("STATE", ("state",)),
        ("HISTORY", ("history",)),
        ("GRIP", ("grip",)),
        ("RELEASE", ("release",)),
        ("POS", ("announce_pose",)),
        ("HELP", ("help", None)),
        ("HELP end  if", ("help", "end if")),
    ],
)
def test_a_command_is_one_action_with_its_value(make: Make, source: str, action: tuple[object, ...]) -> None:
    outcome = run(source, make)

    assert outcome.error is None
    assert outcome.actions.done == [action]


@back_ends
def test_a_pulse_goes_to_the_motors_of_its_direction(make: Make) -> None:
    outcome = run("BELT ON VIBRATE FL VIBRATE t", make)

    assert outcome.actions.done == [
        ("belt", True),
        ("vibrate", Bearing.FRONT_LEFT),
        ("vibrate", Bearing.BACK),
    ]


@back_ends
@pytest.mark.parametrize(
    ("source", "said"),
    [
        ("IF 1 == 1 THEN END IF SPEAK 1", [1]),
        ("IF 1 == 2 THEN ELSE SPEAK 1 END IF", [1]),
        ("IF 1 == 1 THEN SPEAK 1 ELSE END IF", [1]),
        ("IF 1 == 1 THEN ELSE SPEAK 1 END IF", []),
        ("REPEAT 2 TIMES END REPEAT SPEAK 1", [1]),
        ("WHILE 1 == 2 DO END WHILE SPEAK 1", [1]),
        ("FOR VAR i = 0; i < 2; i = i + 1 DO END FOR SPEAK 1", [1]),
        ("PROCEDURE P DO END PROCEDURE P [] SPEAK 1", [1]),
    ],
)
def test_a_block_may_be_empty(make: Make, source: str, said: list[int]) -> None:
    outcome = run(source, make)

    assert outcome.error is None
    assert outcome.actions.said == said


LONG = "a" + " + 1 * (2 - a)" * 70
"""2, in more levels than Python's compiler should see at once."""


@back_ends
@pytest.mark.parametrize(
    ("source", "said"),
    [
        ("VAR b = LONG SPEAK b", [2]),
        ("VAR b b = 1 + (LONG) SPEAK b", [3]),
        ("IF LONG == 2 THEN SPEAK 1 END IF", [1]),
        ("IF 2 <> LONG THEN SPEAK 1 ELSE SPEAK 3 END IF", [3]),
        ("REPEAT LONG TIMES SPEAK 1 END REPEAT", [1, 1]),
        ("VAR n WHILE n < LONG DO n = n + 1 SPEAK n END WHILE", [1, 2]),
        ("FOR VAR i = LONG; i < 4; i = i + 1 DO SPEAK i END FOR", [2, 3]),
        ("FOR VAR i = 0; i < LONG; i = i + 1 DO SPEAK i END FOR", [0, 1]),
        ("FOR VAR i = 0; i < 4; i = i + (LONG) DO SPEAK i END FOR", [0, 2]),
        ("PROCEDURE P: b, c DO SPEAK b - c END PROCEDURE P [LONG, 5]", [-3]),
        ("PROCEDURE P: b, c DO SPEAK b - c END PROCEDURE P [5, LONG]", [3]),
        ("REPEAT 2 TIMES IF LONG > 1 THEN SPEAK LONG END IF a = 2 END REPEAT", [2, 2]),
    ],
)
def test_a_long_expression_may_stand_anywhere(make: Make, source: str, said: list[int]) -> None:
    outcome = run(f"VAR a = 2 {source.replace('LONG', LONG)}", make)

    assert outcome.error is None
    assert outcome.actions.said == said
