"""A lesson at ``donnie --linear``: what a learner types, command by command, in a world with things in it."""

from __future__ import annotations

SHORT = (
    "FW 3",
    "TR 90",
    "SCAN",
    "STATE",
    "SPEAK 2 + 3",
    "SPEAK 2 + 3",
    "FW x",
    "WHERE",
    "REPEAT 12 TIMES SPEAK 7 END REPEAT",
    "HELP FW",
    "FW 100",
    "POS",
)
"""A dozen, for every test run."""

LONG = (
    *SHORT,
    "BW 2",
    "TL 45",
    "TL 45",
    "SPEAK DISTANCE F",
    "SPEAK DISTANCE BL",
    'SPEAK "hello, Donnie"',
    "VAR steps",
    "steps = 4",
    "FW steps",
    "SPEAK steps * 2",
    "SPEAK COLOR green",
    "IF steps > 3 THEN SPEAK 1 ELSE SPEAK 0 END IF",
    "PROCEDURE SQUARE: n DO REPEAT 4 TIMES FW n TR 90 END REPEAT END PROCEDURE",
    "SQUARE [2]",
    "HISTORY",
    "FWD 3",
    "REPEAT 3 TIMES FW 1",
    "END REPEAT",
    "SPEAK 1 / 0",
    "ERRORS",
    "WAIT 1",
    "SOUND OFF",
    "SOUND ON",
    "WORLD",
    "MAP",
    "LAST",
    "SPEED 10",
    "DETAIL FULL",
    "FW 1",
    "DETAIL NORMAL",
    "HELP",
    "LIST",
    "REPEAT 40 TIMES SPEAK 8 END REPEAT",
    "STATE",
)
"""More than forty: Gate 1 of the accessibility requirements."""
