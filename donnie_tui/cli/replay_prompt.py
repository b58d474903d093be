"""``donnie replay --step``: a recording by typed words: forward, back, the map, on to the end.

An empty line is a step forward. HELP lists the words in the learner's language. Lines may come from a file
too; on a terminal there is a prompt, and Ctrl+C stops playing, or ends the replay.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from donnie_tui.cli.options import ExitCode
from donnie_tui.cli.streams import Input, Output, stopped_by_signals
from donnie_tui.core.events import Answered, Stamped
from donnie_tui.core.hub import Hub, Stream
from donnie_tui.core.replay import Replay, map_at, redone_in_words, rows_of, undone_in_words
from donnie_tui.core.timeline import Timeline
from donnie_tui.core.transcript import with_robot_name
from donnie_tui.core.wording import keys_of, meant, position_in_words, spelled
from donnie_tui.i18n.words import Words
from donnie_tui.settings.settings import faster_than, slower_than, speed_words
from language.control import ExecutionControl
from language.source import printable

if TYPE_CHECKING:
    from sim.picture import Picture
    from sim.scene import Scene

LONGEST_LINE = 200


class ReplayMap:
    """Each robot's picture of the floor is made once."""

    def __init__(self, scene: Scene, words: Words) -> None:
        self._scene = scene
        self._words = words
        self._pictures: dict[str | None, Picture] = {}

    def lines(self, timeline: Timeline, robot: str | None) -> tuple[str, ...]:
        """The map at this position, from north to south; empty if the place of the robot is unknown."""
        if not timeline.trail(robot):
            return ()
        scene = map_at(timeline, self._picture(robot), robot)
        rows = rows_of(scene, self._words) if scene is not None else ()
        if robot is None or not rows:
            return rows
        return (self._words("replay-map-of", robot=printable(robot)), *rows)

    def _picture(self, robot: str | None) -> Picture:
        from sim.picture import picture

        if robot not in self._pictures:
            is_known = robot in self._scene.robot_names
            self._pictures[robot] = picture(self._scene, robot if is_known else None)
        return self._pictures[robot]


class ReplayPrompt:
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
        """The robot of the last event."""
        self._leaving = False

    def talk(self, output: Output) -> int:
        """Read words until QUIT or the end of the input."""
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
            return ExitCode.STOPPED
        return ExitCode.DONE

    def _do(self, typed: str, output: Output) -> None:
        name = meant(typed, "replay") if typed else "next"
        if typed.isascii() and typed.isdecimal():
            self._go_to(int(typed[:9]))
        elif name is None:
            self._answer("replay-unknown-word")
        else:
            self._handlers(output)[name]()

    def _handlers(self, output: Output) -> dict[str, Callable[[], None]]:
        return {
            "next": self._next,
            "back": self._back,
            "go": self._go,
            "faster": lambda: self._change_speed(faster_than),
            "slower": lambda: self._change_speed(slower_than),
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
        if sentence := redone_in_words(step, self._words):
            self._say(sentence)

    def _back(self) -> None:
        undone = self._timeline.step_back()
        if undone:
            self._robot = undone[0].robot
        self._say(undone_in_words(undone, self._timeline, self._words))

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
                self._say(with_robot_name(robot, position_in_words(pose, self._words), self._words))

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
        for name in keys_of("replay"):
            word = spelled(name, self._words.language, "replay")
            self._say(f"{word}: {self._words(f'replay-word-{name}')}")

    def _quit(self) -> None:
        self._leaving = True

    def _answer(self, code: str, **values: object) -> None:
        self._say(self._words(code, **values))

    def _say(self, sentence: str) -> None:
        self._hub.publish(Answered(sentence))
