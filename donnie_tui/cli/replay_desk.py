"""Going through a recording by typed words: a step on, a step back, where, the map, on to the end.

An empty line is a step on. Words in three languages, declared once; HELP lists them. Works with lines from a
file too; on a terminal there is a prompt, and Ctrl+C ends what goes on, or the whole.
"""

from __future__ import annotations

from collections.abc import Callable

from devices.ports.values import Frozen
from donnie_tui.cli import codes
from donnie_tui.cli.ending import stopped_by_signals
from donnie_tui.cli.input import Input
from donnie_tui.cli.output import Output
from donnie_tui.cli.replay_map import ReplayMap
from donnie_tui.core.events import Answered, Stamped
from donnie_tui.core.hub import Hub, Stream
from donnie_tui.core.replay import Replay
from donnie_tui.core.retelling import told_back, told_forward
from donnie_tui.core.speeds import faster, slower, speed_words
from donnie_tui.core.telling import position_in_words
from donnie_tui.core.transcript import said_by
from donnie_tui.i18n.words import Words
from language.control import ExecutionControl
from language.source import fold_name

LONGEST_LINE = 200


class Word(Frozen):
    """One word; what it is for is ``replay-word-NAME``."""

    name: str
    en: str
    pt: str
    es: str


WORDS = (
    Word("next", "NEXT", "PRÓXIMO", "SIGUIENTE"),
    Word("back", "BACK", "VOLTAR", "VOLVER"),
    Word("go", "GO", "SEGUIR", "SEGUIR"),
    Word("faster", "FASTER", "MAIS RÁPIDO", "MÁS RÁPIDO"),
    Word("slower", "SLOWER", "MAIS DEVAGAR", "MÁS LENTO"),
    Word("where", "WHERE", "ONDE", "DÓNDE"),
    Word("map", "MAP", "MAPA", "MAPA"),
    Word("first", "START", "COMEÇO", "COMIENZO"),
    Word("last", "END", "FIM", "FIN"),
    Word("help", "HELP", "AJUDA", "AYUDA"),
    Word("quit", "QUIT", "SAIR", "SALIR"),
)
_BY_WORD = {fold_name(word): each.name for each in WORDS for word in (each.en, each.pt, each.es)}


class ReplayDesk:
    """One conversation about a recording."""

    def __init__(
        self, replay: Replay, hub: Hub, stream: Stream, words: Words, floor: ReplayMap | None
    ) -> None:
        self._replay = replay
        self._timeline = replay.timeline
        self._hub = hub
        self._stream = stream
        self._words = words
        self._floor = floor
        self._robot: str | None = None
        """Of whom something was told last."""
        self._leaving = False

    def talk(self, output: Output) -> int:
        """Until somebody leaves, or nothing more is typed."""
        typing = Input()
        self._answer("replay-steps", events=len(self._timeline))
        try:
            while not self._leaving and not output.is_broken:
                if typing.is_terminal:
                    output.text("> ")
                typed = typing.line(LONGEST_LINE)
                if typed is None:
                    break
                self._do(typed, output)
        except KeyboardInterrupt:
            return codes.STOPPED
        return codes.DONE

    def _do(self, typed: str, output: Output) -> None:
        name = _BY_WORD.get(fold_name(" ".join(typed.split()))) if typed else "next"
        if typed.isascii() and typed.isdecimal():
            self._go_to(int(typed[:9]))
        elif name is None:
            self._answer("replay-unknown-word")
        else:
            self._doings(output)[name]()

    def _doings(self, output: Output) -> dict[str, Callable[[], None]]:
        return {
            "next": self._next,
            "back": self._back,
            "go": self._go,
            "faster": lambda: self._change_speed(faster),
            "slower": lambda: self._change_speed(slower),
            "where": self._where,
            "map": lambda: self._map(output),
            "first": lambda: self._go_to(0),
            "last": lambda: self._go_to(len(self._timeline)),
            "help": self._help,
            "quit": self._quit,
        }

    # --- what the words do

    def _next(self) -> None:
        step = self._timeline.step()
        if not step:
            self._answer("replay-end")
        for stamped in step:
            self._show(stamped)
        if sentence := told_forward(step, self._words):
            self._tell(sentence)

    def _back(self) -> None:
        undone = self._timeline.step_back()
        if undone:
            self._robot = undone[0].robot
        self._tell(told_back(undone, self._timeline, self._words))

    def _go(self) -> None:
        """On to the end, until Ctrl+C."""
        self._replay.control = ExecutionControl()
        with stopped_by_signals(self._replay.control.stop):
            if self._replay.forwards(self._show):
                self._answer("replay-end")

    def _show(self, stamped: Stamped) -> None:
        self._robot = stamped.robot
        self._stream.pass_on(stamped)

    def _change_speed(self, changed: Callable[[float | None], float | None]) -> None:
        self._replay.speed = changed(self._replay.speed)
        self._answer("replay-speed", speed=speed_words(self._replay.speed, self._words))

    def _where(self) -> None:
        self._answer("replay-at", at=self._timeline.at, events=len(self._timeline))
        for robot in self._timeline.robots:
            pose = self._timeline.pose(robot)
            if pose is not None:
                self._tell(said_by(robot, position_in_words(pose, self._words), self._words))

    def _map(self, output: Output) -> None:
        rows = () if self._floor is None else self._floor.lines(self._timeline, self._robot)
        if not rows:
            self._answer("replay-no-map")
        for row in rows:
            output.line(row)

    def _go_to(self, at: int) -> None:
        self._timeline.go_to(at)
        now = self._timeline.now
        self._robot = now.robot if now is not None else None
        self._where()

    def _help(self) -> None:
        for word in WORDS:
            typed = {"en": word.en, "pt": word.pt, "es": word.es}[self._words.language]
            self._tell(f"{typed}: {self._words(f'replay-word-{word.name}')}")

    def _quit(self) -> None:
        self._leaving = True

    def _answer(self, code: str, **values: object) -> None:
        self._tell(self._words(code, **values))

    def _tell(self, sentence: str) -> None:
        self._hub.publish(Answered(sentence))
