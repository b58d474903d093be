"""Everything that a learner can ask a front end for, declared once: its words, what may follow them, when.

Both front ends take their words from here, the full screen adds keys. Rules: a word is none of GoDonnie's,
but for those that mean the same; no word means two things in one language; what a use case is for is the
sentence ``action-NAME``, and what may follow its word ``help-typed-ARGUMENT``, in both front ends alike.

This module imports nothing of ours until a line is looked at: the first screen needs it.
"""

from __future__ import annotations

from enum import Enum
from functools import cache

from devices.ports.hints import TYPE_CHECKING
from devices.ports.values import Frozen
from donnie_tui import LANGUAGES

if TYPE_CHECKING:
    from donnie_tui.core.wording import Wording

LONGEST_WORD = 24
"""Characters of the longest word of a use case, blanks included, with room to spare."""


class When(Enum):
    """When something may be asked for, each including the ones before."""

    IDLE = 0
    """Nothing runs."""
    HELD = 1
    """A program is held between two statements, or nothing runs."""
    ALWAYS = 2


class UseCase(Frozen):
    """One thing that can be asked for. Declared once, so that it is equal to nothing but itself."""

    __eq__ = object.__eq__
    __hash__ = object.__hash__

    name: str
    en: str
    pt: str
    es: str
    when: When = When.IDLE
    argument: str = ""
    """What may follow the word, a code of ``help-typed-``; empty if nothing may."""
    required: bool = False
    """Whether the word means nothing without its argument."""
    hidden: bool = False
    """A second word for the same: not listed again."""
    is_godonnie: bool = False
    """The word is GoDonnie's own and means the same there."""

    def word(self, language: str) -> str:
        """What is typed for it."""
        return (self.en, self.pt, self.es)[LANGUAGES.index(language)]


_HELD, _ALWAYS = When.HELD, When.ALWAYS

_HAVE_CHOICES = ("report-file",)
"""Arguments whose first word is one of a few; HELP says which, ``help-choices-ARGUMENT``."""

USE_CASES = (
    # --- running
    UseCase("run", "RUN", "EXECUTAR", "EJECUTAR", is_godonnie=True),
    UseCase("again", "AGAIN", "NOVAMENTE", "NUEVAMENTE"),
    UseCase("stop", "STOP", "PARAR", "DETENER", _ALWAYS),
    UseCase("pause", "PAUSE", "PAUSAR", "PAUSAR", _ALWAYS),
    UseCase("continue_", "CONTINUE", "CONTINUAR", "CONTINUAR", _ALWAYS),
    UseCase("step", "STEP", "PASSO", "PASO", _HELD),
    UseCase("step_over", "OVER", "PASSO INTEIRO", "PASO ENTERO", _HELD),
    UseCase("step_back", "STEP BACK", "PASSO ATRÁS", "PASO ATRÁS", _HELD),
    UseCase("run_to", "UNTIL", "ATÉ", "HASTA", _HELD, "line"),
    UseCase("break_", "BREAK", "PARADA", "PARADA", _ALWAYS, "line"),
    UseCase("watch", "WATCH", "VIGIAR", "VIGILAR", _ALWAYS, "variable"),
    UseCase("slower", "SLOWER", "MAIS DEVAGAR", "MÁS LENTO", _ALWAYS),
    UseCase("faster", "FASTER", "MAIS RÁPIDO", "MÁS RÁPIDO", _ALWAYS),
    UseCase("speed", "SPEED", "VELOCIDADE", "VELOCIDAD", _ALWAYS, "speed"),
    UseCase("reset", "RESET", "REINICIAR", "REINICIAR"),
    # --- files
    UseCase("open", "OPEN", "ABRIR", "ABRIR", argument="file"),
    UseCase("open", "LOAD", "CARREGAR", "CARGAR", argument="file", hidden=True),
    UseCase("save", "SAVE", "SALVAR", "GUARDAR", argument="file"),
    UseCase("save_as", "SAVE AS", "SALVAR COMO", "GUARDAR COMO", argument="file"),
    UseCase("new", "NEW", "NOVO", "NUEVO"),
    UseCase("recover", "RECOVER", "RECUPERAR", "RECUPERAR"),
    UseCase("save_log", "SAVE LOG", "SALVAR REGISTRO", "GUARDAR REGISTRO", _HELD, "text-file"),
    UseCase("report", "REPORT", "RELATÓRIO", "INFORME", _HELD, "report-file", required=True),
    # --- the program's lines
    UseCase("list", "LIST", "LISTAR", "LISTAR", _ALWAYS, "lines"),
    UseCase("change", "CHANGE", "MUDAR", "CAMBIAR", argument="line", required=True),
    UseCase("change", "EDIT", "EDITAR", "EDITAR", argument="line", required=True, hidden=True),
    UseCase("insert", "INSERT", "INSERIR", "INSERTAR", argument="line", required=True),
    UseCase("delete", "DELETE", "APAGAR", "BORRAR", argument="lines"),
    UseCase("delete", "REMOVE", "REMOVER", "ELIMINAR", argument="lines", hidden=True),
    UseCase("move", "MOVE", "MOVER", "MOVER", argument="two-lines", required=True),
    UseCase("fix", "FIX", "CORRIGIR", "CORREGIR"),
    UseCase("search", "SEARCH", "PROCURAR", "LOCALIZAR", argument="word"),
    UseCase("search_again", "SEARCH AGAIN", "PROCURAR DE NOVO", "LOCALIZAR OTRA VEZ"),
    UseCase("replace", "REPLACE", "SUBSTITUIR", "REEMPLAZAR", argument="word", required=True),
    UseCase("format", "FORMAT", "FORMATAR", "FORMATEAR"),
    UseCase("translate", "TRANSLATE", "TRADUZIR", "TRADUCIR", argument="language", required=True),
    UseCase("undo", "UNDO", "DESFAZER", "DESHACER"),
    UseCase("redo", "REDO", "REFAZER", "REHACER"),
    UseCase("read", "READ", "LER", "LEER", _ALWAYS, "line"),
    UseCase("next", "NEXT", "PRÓXIMA", "SIGUIENTE", _ALWAYS),
    UseCase("next", "N", "N", "N", _ALWAYS, hidden=True),
    UseCase("back", "BACK", "ANTERIOR", "ANTERIOR", _ALWAYS),
    UseCase("back", "B", "B", "B", _ALWAYS, hidden=True),
    UseCase("first", "FIRST", "PRIMEIRA", "PRIMERA", _ALWAYS),
    UseCase("last_line", "LAST LINE", "ÚLTIMA LINHA", "ÚLTIMA LÍNEA", _ALWAYS),
    UseCase("place", "PLACE", "LUGAR", "LUGAR", _ALWAYS),
    UseCase("up", "UP", "SUBIR", "SUBIR", _ALWAYS),
    UseCase("down", "DOWN", "DESCER", "BAJAR", _ALWAYS),
    UseCase("next_same", "NEXT SAME", "PRÓXIMA IGUAL", "SIGUIENTE IGUAL", _ALWAYS),
    UseCase("back_same", "BACK SAME", "ANTERIOR IGUAL", "ANTERIOR IGUAL", _ALWAYS),
    UseCase("outline", "OUTLINE", "ESTRUTURA", "ESTRUCTURA", _ALWAYS),
    # --- mistakes
    UseCase("error", "ERROR", "ERRO", "ERROR", _ALWAYS),
    UseCase("error_next", "ERROR NEXT", "ERRO PRÓXIMO", "ERROR SIGUIENTE", _ALWAYS),
    UseCase("error_previous", "ERROR PREVIOUS", "ERRO ANTERIOR", "ERROR ANTERIOR", _ALWAYS),
    UseCase("errors", "ERRORS", "ERROS", "ERRORES", _ALWAYS),
    UseCase("explain", "EXPLAIN", "EXPLICAR", "EXPLICAR", _ALWAYS),
    # --- what was said
    UseCase("last", "LAST", "ÚLTIMO", "ÚLTIMO", _ALWAYS, "count"),
    UseCase("last_word", "LAST WORD", "ÚLTIMA PALAVRA", "ÚLTIMA PALABRA", _ALWAYS),
    UseCase("spell", "SPELL", "SOLETRAR", "DELETREAR", _ALWAYS, "count"),
    UseCase("find", "FIND", "BUSCAR", "BUSCAR", _ALWAYS, "word", required=True),
    UseCase("typed", "TYPED", "DIGITADO", "ESCRITO", _HELD, "count"),
    UseCase("quiet", "QUIET", "SILÊNCIO", "SILENCIO", _ALWAYS),
    UseCase("cues", "CUES", "SINAIS", "SEÑALES", argument="cue"),
    # --- the robot and its world
    UseCase("where", "WHERE", "ONDE", "DÓNDE", _ALWAYS),
    UseCase("around", "AROUND", "AO REDOR", "ALREDEDOR", _ALWAYS, "compass"),
    UseCase("around", "NEAR", "PERTO", "CERCA", _ALWAYS, "compass", hidden=True),
    UseCase("map", "MAP", "MAPA", "MAPA", _ALWAYS, "square"),
    UseCase("map_row", "MAP ROW", "MAPA LINHA", "MAPA FILA", _ALWAYS, "row", required=True),
    UseCase("map_column", "MAP COLUMN", "MAPA COLUNA", "MAPA COLUMNA", _ALWAYS, "row", required=True),
    UseCase("map_picture", "MAP PICTURE", "MAPA IMAGEM", "MAPA IMAGEN", _ALWAYS),
    UseCase("trail", "TRAIL", "TRILHA", "RASTRO", _ALWAYS, "count"),
    UseCase("sensors", "SENSORS", "SENSORES", "SENSORES", _ALWAYS),
    UseCase("robots", "ROBOTS", "ROBÔS", "ROBOTS", _ALWAYS),
    UseCase("robot", "ROBOT", "ROBÔ", "ROBOT", _ALWAYS, "robot", required=True),
    UseCase("start", "START", "INICIAR", "INICIAR"),
    UseCase("together", "TOGETHER", "JUNTOS", "JUNTOS"),
    UseCase("stop_all", "STOP ALL", "PARAR TUDO", "DETENER TODO", _ALWAYS),
    UseCase("grip", "GRIP", "PEGAR", "AGARRAR"),
    UseCase("release", "RELEASE", "SOLTAR", "SOLTAR"),
    UseCase("connect", "CONNECT", "CONECTAR", "CONECTAR", argument="count"),
    UseCase("connect", "DEVICES", "DISPOSITIVOS", "DISPOSITIVOS", argument="count", hidden=True),
    UseCase("feel", "FEEL", "SENTIR", "SENTIR", _ALWAYS, "switch"),
    UseCase("world", "WORLD", "MUNDO", "MUNDO", _HELD, "world"),
    UseCase("worlds", "WORLDS", "MUNDOS", "MUNDOS", argument="world"),
    UseCase("show_program", "SHOW PROGRAM", "MOSTRAR PROGRAMA", "MOSTRAR PROGRAMA", _ALWAYS),
    UseCase("show_map", "SHOW MAP", "MOSTRAR MAPA", "MOSTRAR MAPA", _ALWAYS),
    UseCase("show_log", "SHOW LOG", "MOSTRAR REGISTRO", "MOSTRAR REGISTRO", _ALWAYS),
    UseCase("show_variables", "SHOW VARIABLES", "MOSTRAR VARIÁVEIS", "MOSTRAR VARIABLES", _ALWAYS),
    UseCase("show_variables", "VARIABLES", "VARIÁVEIS", "VARIABLES", _ALWAYS, hidden=True),
    # --- how Donnie works, help, leaving
    UseCase("language", "LANGUAGE", "IDIOMA", "IDIOMA", _ALWAYS, "language"),
    UseCase("detail", "DETAIL", "DETALHE", "DETALLE", _ALWAYS, "detail"),
    UseCase("set", "SET", "AJUSTAR", "AJUSTAR", _HELD, "setting"),
    UseCase("set", "CONFIGURE", "CONFIGURAR", "CONFIGURAR", _HELD, "setting", hidden=True),
    UseCase("tour", "TOUR", "PASSEIO", "PASEO"),
    UseCase("help", "HELP", "AJUDA", "AYUDA", _ALWAYS, "topic", is_godonnie=True),
    UseCase("manual", "MANUAL", "MANUAL", "MANUAL", _ALWAYS, "topic"),
    UseCase("linear", "LINEAR", "LINEAR", "LINEAL"),
    UseCase("visual", "VISUAL", "VISUAL", "VISUAL"),
    UseCase("quit", "QUIT", "SAIR", "SALIR", _ALWAYS, is_godonnie=True),
    UseCase("quit", "EXIT", "SAIR", "SALIR", _ALWAYS, hidden=True, is_godonnie=True),
)

BY_NAME = {each.name: each for each in reversed(USE_CASES)}
"""By name; where there are two words, the one that is listed."""


def find(line: str, cases: tuple[UseCase, ...] = USE_CASES) -> tuple[UseCase, str] | None:
    """What a typed line asks for, in any language, and what follows the word; None if it is GoDonnie.

    ``speed = 3`` and ``open [2]`` are GoDonnie's: a learner may call a variable or procedure as we call
    something. Of two words that begin alike the longer one counts. ``cases`` are those to look among.
    """
    words, by_word = line[: 4 * LONGEST_WORD].split(), _by_word(cases)
    for length in range(min(3, len(words)), 0, -1):
        found = by_word.get(_folded(" ".join(words[:length])))
        if found is not None:
            behind = line.strip().split(maxsplit=length)[length:]
            rest = behind[0] if behind else ""
            return None if rest.startswith(("=", "[")) else (found, rest)
    return None


def typed_form(case: UseCase, wording: Wording) -> str:
    """How it is typed, with an example of what may follow: ``LIST 2 5``."""
    argument = wording(f"help-typed-{case.argument}") if case.argument else ""
    return " ".join(filter(None, (case.word(wording.language), argument)))


def not_understood(case: UseCase, wording: Wording) -> str:
    """What is told where nobody knows what stands behind its word."""
    if not case.argument:
        return wording("word-takes-nothing", word=case.word(wording.language))
    return wording("linear-like-this", example=typed_form(case, wording))


def help_line(case: UseCase, wording: Wording, keys: str = "") -> str:
    """The line of help for it: how it is typed, its keys where there are any, what it is for."""
    behind = f" ({keys})" if keys else ""
    return f"{typed_form(case, wording)}{behind}: {wording(f'action-{case.name}')}"


def help_of(topic: str, wording: Wording, cases: tuple[UseCase, ...] = USE_CASES) -> tuple[str, ...]:
    """What there is to say about a word of ours: what it is for, its form, an example; nothing of others."""
    found = find(topic, cases)
    if found is None or found[0].is_godonnie:
        return ()
    case = found[0]
    form = wording("help-form", form=_form(case, wording)) + "."
    example = wording("help-example", example=typed_form(case, wording)) + "."
    choices = (wording(f"help-choices-{case.argument}"),) if case.argument in _HAVE_CHOICES else ()
    return help_line(case, wording), form, *choices, example


def _form(case: UseCase, wording: Wording) -> str:
    """With what may follow, or must."""
    word = case.word(wording.language)
    if not case.argument:
        return word
    whole = f"{word} {wording(f'help-form-{case.argument}')}"
    return whole if case.required else wording("help-or", first=word, second=whole)


@cache
def _by_word(cases: tuple[UseCase, ...]) -> dict[str, UseCase]:
    return {form: each for each in reversed(cases) for form in _forms(each)}


@cache
def _forms(case: UseCase) -> tuple[str, ...]:
    """Its word in all languages, as they are compared."""
    return tuple(map(_folded, (case.en, case.pt, case.es)))


def _folded(word: str) -> str:
    """As the language compares words. Loaded when first needed: the keys are there before the words are."""
    from language.source import fold_name

    return fold_name(word)
