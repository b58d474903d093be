"""The words of the linear mode, declared once: what they are called, what they do, when they may be said.

HELP is made from this table: the line of a word is ``linear-word-NAME`` in the catalogue. GoDonnie's own
words are none of these, and a learner may still call a variable or a procedure as one of them is called:
``speed = 3`` and ``list [2]`` are GoDonnie.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

from donnie_tui.bootstrap import SwitchMode
from donnie_tui.core.session import Busy
from donnie_tui.linear import choices, files, lines, surroundings
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.runs import Runs
from language.source import fold_name

LARGEST_NUMBER = 10_000_000
"""No program has so many lines, and no session so many answers."""

Handler: TypeAlias = Callable[[Desk, Runs, str], bool | None]
"""Does the word with what stands behind it. False if that can't be understood."""


@dataclass(frozen=True, slots=True)
class Command:
    """One word."""

    name: str
    en: str
    pt: str
    es: str
    do: Handler
    while_held: bool = False
    """Whether it may be said while a program is held between two steps."""
    hidden: bool = False
    """Not listed."""


_AS = ("as", "como")

# --- what the words do


def _open(desk: Desk, _: Runs, rest: str) -> bool:
    if rest:
        files.open_named(desk, rest)
    return bool(rest)


def _save(desk: Desk, _: Runs, rest: str) -> None:
    """SAVE name; SAVE AS name, as in the full screen, is the same."""
    word, _blank, name = rest.partition(" ")
    files.save_named(desk, name.strip() if name and fold_name(word) in _AS else rest)


def _new(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        files.new_program(desk)
    return not rest


def _recover(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        files.recover(desk)
    return not rest


def _list(desk: Desk, _: Runs, rest: str) -> bool:
    given = _numbers(rest, most=2)
    if given is not None:
        lines.list_lines(desk, *_pair(given))
    return given is not None


def _delete(desk: Desk, _: Runs, rest: str) -> bool:
    given = _numbers(rest, most=2)
    if given is not None:
        lines.delete_lines(desk, *_pair(given))
    return given is not None


def _change(desk: Desk, _: Runs, rest: str) -> bool:
    number, text = _number_and_text(rest)
    if number is not None:
        lines.change_line(desk, number, text)
    return number is not None


def _insert(desk: Desk, _: Runs, rest: str) -> bool:
    number, text = _number_and_text(rest)
    if number is not None:
        lines.insert_line(desk, number, text)
    return number is not None


def _again(_: Desk, runs: Runs, rest: str) -> bool:
    if not rest:
        runs.run_all()
    return not rest


def _step(_: Desk, runs: Runs, rest: str) -> bool:
    if not rest:
        runs.run_waiting(stepping=True)
    return not rest


def _stop(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        desk.answer("linear-nothing-to-stop")
    return not rest


def _reset(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        try:
            desk.session.reset()
        except Busy:
            return False
        desk.answer("linear-start")
    return not rest


def _where(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        surroundings.say_where(desk)
    return not rest


def _map(desk: Desk, _: Runs, rest: str) -> bool:
    if rest:
        if not surroundings.is_picture(rest):
            return False
        surroundings.draw_map(desk)
    else:
        surroundings.say_map(desk)
    return True


def _world(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        surroundings.say_world(desk)
    return not rest


def _speed(desk: Desk, _: Runs, rest: str) -> bool:
    return choices.set_speed(desk, rest)


def _language(desk: Desk, _: Runs, rest: str) -> bool:
    return choices.set_language(desk, rest)


def _detail(desk: Desk, _: Runs, rest: str) -> bool:
    return choices.set_detail(desk, rest)


def _last(desk: Desk, _: Runs, rest: str) -> bool:
    given = _numbers(rest, most=1)
    if given is not None:
        choices.say_again(desk, given[0] if given else 1)
    return given is not None


def _errors(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        choices.say_errors(desk)
    return not rest


def _visual(desk: Desk, _: Runs, rest: str) -> bool:
    if rest:
        return False
    if desk.can_edit:
        desk.show_told()
        raise SwitchMode(desk.program.text, desk.program.name)
    desk.answer("linear-no-screen")
    return True


def _linear(desk: Desk, _: Runs, rest: str) -> bool:
    if not rest:
        desk.answer("linear-linear")
    return not rest


COMMANDS = (
    Command("open", "OPEN", "ABRIR", "ABRIR", _open),
    Command("save", "SAVE", "SALVAR", "GUARDAR", _save),
    Command("new", "NEW", "NOVO", "NUEVO", _new),
    Command("recover", "RECOVER", "RECUPERAR", "RECUPERAR", _recover),
    Command("list", "LIST", "LISTAR", "LISTAR", _list, while_held=True),
    Command("change", "CHANGE", "MUDAR", "CAMBIAR", _change),
    Command("insert", "INSERT", "INSERIR", "INSERTAR", _insert),
    Command("delete", "DELETE", "APAGAR", "BORRAR", _delete),
    Command("again", "AGAIN", "NOVAMENTE", "NUEVAMENTE", _again),
    Command("step", "STEP", "PASSO", "PASO", _step),
    Command("stop", "STOP", "PARAR", "DETENER", _stop),
    Command("reset", "RESET", "REINICIAR", "REINICIAR", _reset),
    Command("where", "WHERE", "ONDE", "DÓNDE", _where, while_held=True),
    Command("map", "MAP", "MAPA", "MAPA", _map, while_held=True),
    Command("world", "WORLD", "MUNDO", "MUNDO", _world, while_held=True),
    Command("speed", "SPEED", "VELOCIDADE", "VELOCIDAD", _speed, while_held=True),
    Command("language", "LANGUAGE", "IDIOMA", "IDIOMA", _language, while_held=True),
    Command("detail", "DETAIL", "DETALHE", "DETALLE", _detail, while_held=True),
    Command("last", "LAST", "ÚLTIMO", "ÚLTIMO", _last, while_held=True),
    Command("errors", "ERRORS", "ERROS", "ERRORES", _errors),
    Command("visual", "VISUAL", "VISUAL", "VISUAL", _visual),
    Command("linear", "LINEAR", "LINEAR", "LINEAL", _linear, hidden=True),
)

_BY_WORD = {fold_name(word): each for each in COMMANDS for word in (each.en, each.pt, each.es)}
NAMES = {word: each.name for word, each in _BY_WORD.items()}
"""Every word of every language, folded, and the name of what it does."""
LISTED = tuple(each.name for each in COMMANDS if not each.hidden)


def find(line: str) -> tuple[Command, str] | None:
    """The word that a line begins with, and what stands behind it; None if the line is GoDonnie."""
    word, _, rest = line.strip().partition(" ")
    command = _BY_WORD.get(fold_name(word)) if len(word) < 20 else None
    rest = rest.strip()
    if command is None or rest.startswith(("=", "[")):
        return None
    return command, rest


def do(command: Command, rest: str, desk: Desk, runs: Runs) -> None:
    """Do it; if what stands behind the word can't be understood, show how it is said."""
    if command.do(desk, runs, rest) is False:
        example = desk.say(f"linear-word-{command.name}").partition(":")[0]
        desk.answer("linear-like-this", example=example)


# --- what stands behind a word


def _numbers(rest: str, *, most: int) -> list[int] | None:
    """At most so many whole numbers, or None if there is anything else."""
    words = rest.replace(",", " ").split()
    if len(words) > most or not all(each.isdecimal() and len(each) < 9 for each in words):
        return None
    found = [int(each) for each in words]
    return found if all(each <= LARGEST_NUMBER for each in found) else None


def _pair(given: list[int]) -> tuple[int | None, int | None]:
    return (given[0] if given else None), (given[1] if len(given) > 1 else None)


def _number_and_text(rest: str) -> tuple[int | None, str]:
    word, _, text = rest.partition(" ")
    number = _numbers(word, most=1)
    return (number[0] if number else None), text.strip()
