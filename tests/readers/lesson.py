"""A lesson at Donnie's command line: what a learner types, command by command, in a world with things."""

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
    "FOR VAR i = 1; i <= 12; i = i + 1 DO SPEAK i END FOR",
    "HELP FW",
    "FW 100",
    "POS",
)
"""Twelve commands for every test run."""

OF_THE_SCREEN = (
    "FW x",
    "FW 3",
    "SCAN",
    "TR 90",
    "SPEAK 2 + 3",
    "SPEAK 2 + 3",
    "STATE",
    "FOR VAR i = 1; i <= 12; i = i + 1 DO SPEAK 100 + i END FOR",
    "STATE",
    "FOR VAR i = 1; i <= 40; i = i + 1 DO SPEAK 200 + i END FOR",
    "STATE",
)
"""The mistake comes first: after other lines the linear mode counts them too. No number is printed twice:
Fenrir passes over a line that is already on the screen."""

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
    "PROCEDURE SQUARE: n DO",
    "REPEAT 4 TIMES FW n TR 90 END REPEAT",
    "END PROCEDURE",
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
    "HELP ALL",
    "LIST",
    "FOR VAR i = 1; i <= 40; i = i + 1 DO SPEAK i END FOR",
    "STATE",
    "AROUND",
    "MAP ROW 3",
    "TRAIL 3",
    "OUTLINE",
    "PLACE",
    "EXPLAIN",
    "SHOW LOG",
    "SET",
)
"""More than forty commands: ``gate.py`` measures how a reader reads them."""

OF_A_CHALLENGE = ("TASK", "GOALS", "FW 4", "HINT", "RESET", "FW 5", "RESULTS")
"""Something to do, a step short first."""

FROM_THE_TOUR = {
    "en": (
        *("TOUR", *(" ",) * 9),
        "FW 5",
        *("NEXT CHALLENGE", "TASK", "TR 90", "FW 4"),
        *("NEXT CHALLENGE", "GOALS", "FW 8", "BW 8"),
        "RESULTS",
    ),
    "pt": (
        *("PASSEIO", *(" ",) * 9),
        "PF 5",
        *("PRÓXIMO DESAFIO", "TAREFA", "GD 90", "PF 4"),
        *("PRÓXIMO DESAFIO", "METAS", "PF 8", "PT 8"),
        "RESULTADOS",
    ),
    "es": (
        *("PASEO", *(" ",) * 9),
        "AV 5",
        *("SIGUIENTE RETO", "TAREA", "GD 90", "AV 4"),
        *("SIGUIENTE RETO", "METAS", "AV 8", "RE 8"),
        "RESULTADOS",
    ),
}
"""All pages of the tour, then the first three challenges.

A blank turns the page, as nothing does, and after the last page begins the first challenge.
"""

FIRST_HOUR = {
    "en": (
        *("FW 3", "TR 90", "RUN", "WHERE"),
        *("FWD 2", "RUN", "EXPLAIN", "FIX", "RUN"),
        *("NEW", "VAR x = 1", "WHILE x < 3 DO", "FW x", "x = x + 1", "END WHILE"),
        *("STEP", "STEP", "STEP", "STEP BACK", "WHERE", "SHOW VARIABLES", "STOP"),
    ),
    "pt": (
        *("ANDAR 3", "EXECUTAR", "CORRIGIR", "GD 90", "EXECUTAR", "ONDE"),
        *("PF", "EXECUTAR", "EXPLICAR", "MUDAR 3 PF 2", "EXECUTAR"),
        *("NOVO", "CRIAR x = 1", "ENQUANTO x < 3 FAÇA", "PF x", "x = x + 1", "FIM ENQUANTO"),
        *("PASSO", "PASSO", "PASSO", "PASSO ATRÁS", "ONDE", "MOSTRAR VARIÁVEIS", "PARAR"),
    ),
    "es": (
        *("CAMINAR 3", "EJECUTAR", "CORREGIR", "GD 90", "EJECUTAR", "DÓNDE"),
        *("AV", "EJECUTAR", "EXPLICAR", "CAMBIAR 3 AV 2", "EJECUTAR"),
        *("NUEVO", "CREAR x = 1", "MIENTRAS x < 3 HACER", "AV x", "x = x + 1", "FIN MIENTRAS"),
        *("PASO", "PASO", "PASO", "PASO ATRÁS", "DÓNDE", "MOSTRAR VARIABLES", "DETENER"),
    ),
}
"""A first program, a mistake and its correction, and a program step by step, in each language."""
