"""What can be asked for that is about the screen alone: how the map is shown, the look, the lists.

Declared like the other use cases, and never with a word of theirs. The linear mode does none of them: it says
what is typed there for the same, where there is something.
"""

from __future__ import annotations

from donnie_tui.core.use_cases import UseCase, When

_ALWAYS = When.ALWAYS

VIEW_CASES = (
    # --- the map
    UseCase("zoom_in", "ZOOM IN", "APROXIMAR", "ACERCAR", _ALWAYS),
    UseCase("zoom_out", "ZOOM OUT", "AFASTAR", "ALEJAR", _ALWAYS),
    UseCase("whole_map", "WHOLE MAP", "MAPA INTEIRO", "MAPA ENTERO", _ALWAYS),
    UseCase("names", "NAMES", "NOMES", "NOMBRES", _ALWAYS),
    UseCase("coordinates", "COORDINATES", "COORDENADAS", "COORDENADAS", _ALWAYS),
    UseCase("legend", "LEGEND", "LEGENDA", "LEYENDA", _ALWAYS),
    UseCase("next_thing", "NEXT THING", "PRÓXIMA COISA", "COSA SIGUIENTE", _ALWAYS),
    UseCase("previous_thing", "PREVIOUS THING", "COISA ANTERIOR", "COSA ANTERIOR", _ALWAYS),
    UseCase("to_robot", "TO ROBOT", "AO ROBÔ", "AL ROBOT", _ALWAYS),
    UseCase("from_here", "FROM HERE", "DAQUI", "DESDE AQUÍ", _ALWAYS),
    UseCase("to_there", "TO THERE", "ATÉ ALI", "HASTA ALLÍ", _ALWAYS),
    # --- the editor
    UseCase("complete", "COMPLETE", "COMPLETAR", "COMPLETAR", _ALWAYS),
    UseCase("go_to", "GO TO", "IR PARA", "IR A", _ALWAYS, "line"),
    UseCase("recent", "RECENT", "RECENTES", "RECIENTES"),
    UseCase("programs", "PROGRAMS", "PROGRAMAS", "PROGRAMAS"),
    # --- around
    UseCase("theme", "THEME", "TEMA", "TEMA", _ALWAYS, "theme"),
    UseCase("plain", "PLAIN", "SIMPLES", "SENCILLO", _ALWAYS),
    UseCase("redraw", "REDRAW", "REDESENHAR", "REDIBUJAR", _ALWAYS),
    UseCase("settings", "SETTINGS", "CONFIGURAÇÕES", "CONFIGURACIÓN", _ALWAYS),
    UseCase("change_keys", "CHANGE KEYS", "MUDAR TECLAS", "CAMBIAR TECLAS", _ALWAYS),
    UseCase("keys_here", "KEYS", "TECLAS", "TECLAS", _ALWAYS),
    UseCase("open_log", "LOG", "REGISTRO", "REGISTRO", _ALWAYS),
)

IN_WORDS = {
    "whole_map": "map",
    "names": "map",
    "legend": "map_picture",
    "next_thing": "map",
    "previous_thing": "map",
    "to_robot": "where",
    "from_here": "around",
    "to_there": "map",
    "coordinates": "where",
    "go_to": "read",
    "recent": "open",
    "programs": "robot",
    "settings": "set",
    "open_log": "show_log",
    "keys_here": "help",
}
"""The use cases that come to the same in words; the others are about what is seen."""

PREFERENCES = {
    "theme": "",
    "plain": "",
    "motion": "",
    "mouse": "",
    "completion": "",
    "keys": "",
    "lang": "language",
    "verbosity": "detail",
    "speed": "speed",
    "sound": "SOUND",
}
"""Settings that the full screen offers beside those of both modes, and the use case, or GoDonnie's own word,
that changes them.
"""
