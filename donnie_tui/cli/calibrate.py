"""``donnie calibrate``: the robot moves, a person measures, and Donnie stores the sizes in the settings file.

``donnie calibrate colour``: a person shows things to the camera, and Donnie stores the colour ranges.

However it ends, by a signal too, the robot stands before the port is closed, and the settings are unchanged
unless the measurement was completed. Measurements of a simulated board are not kept: the settings are the
real robot's.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing, contextmanager
from types import FrameType
from typing import TYPE_CHECKING, NoReturn

from msgspec import Struct

from devices.ports.robot import STEP, LinkNotice, RobotProblem, StoppedBy, TurnResult, WalkResult
from devices.serial_robot.config import RobotConfig, axle_length, wheel_radius
from devices.wire.telemetry import Telemetry
from donnie_tui.cli.options import ExitCode, Order
from donnie_tui.cli.streams import Input, let_sound, stopped_by_suspension
from donnie_tui.commands.interaction import answered
from donnie_tui.core.hub import Hub
from donnie_tui.i18n.words import Unusable, as_unusable
from donnie_tui.process.disconnection import ReaderWatch
from donnie_tui.process.signals import LEAVING, Watchdog, end_process
from donnie_tui.robot.connection import (
    Guard,
    make_camera,
    make_measurable,
    robot_config,
)
from donnie_tui.robot.search import sentences_of
from donnie_tui.settings.parsing import DOUBLE, SIMULATED, colours_text, remember
from language.keywords import argument_spelling
from language.source import quoted

if TYPE_CHECKING:
    from devices.camera import ColourCamera, ColourRange
    from devices.serial_robot.robot import SerialRobot

COLOUR = ("colour", "color", "cor")
"""The word after ``donnie calibrate``, in the spellings of the languages."""
STEPS = 20
"""A metre, so that a centimetre of a bad reading is a percent."""
DEGREES = 720
"""Two turns, for the same reason."""

FAR = 2.0
"""A measure that differs by this factor is asked again, and accepted if it is repeated."""

_SMALLEST, _LARGEST = 0.001, 1.0
"""Metres that a radius or an axle can have in the settings."""


class _Steady(Struct):
    """The pace of calibration: real time, until it is stopped."""

    ended: threading.Event

    def sleep(self, seconds: float) -> bool:
        return not self.ended.wait(seconds)


class _Measures(Struct, frozen=True):
    """In metres; None is not measured."""

    wheel_radius: float | None
    axle_length: float | None


class _Lost(Exception):
    """Raised when the robot was lost during a movement, which was reported; has the exit code."""

    def __init__(self, code: ExitCode) -> None:
        super().__init__(code)
        self.code = code


def calibrate(order: Order, made: Callable[..., SerialRobot] = make_measurable) -> int:
    """Ask, walk, ask, turn, ask, write. The exit code is 1 if nothing was measured."""
    what = getattr(order.invocation.arguments, "what", None)
    if what is not None:
        return _calibrate_colours(order, what)
    if order.invocation.options.get("robot") == SIMULATED:
        raise Unusable(order.words("calibrate-simulator"))
    try:
        sizes = _measured(order, made)
    except RobotProblem as problem:
        raise Unusable(" ".join(sentences_of(problem, order.words))) from None
    except _Lost as lost:
        order.output.line(order.words("calibrate-ended"))
        return lost.code
    except KeyboardInterrupt:
        order.output.line(order.words("calibrate-ended"))
        raise
    return _keep(order, sizes)


def _measured(order: Order, made: Callable[..., SerialRobot]) -> _Measures:
    """Measure the robot. It stands, and its port is free, when this returns or raises."""

    def report(news: LinkNotice, _reason: str) -> None:
        if news is not LinkNotice.CONNECTED:
            order.output.line(order.words(f"link-{news.value}"))

    robot = made(order.settings, order.words, _Steady(threading.Event()), report)
    with (
        _guarded(robot, is_real=order.settings.robot != DOUBLE),
        Watchdog(
            dict.fromkeys(LEAVING, _end),
            part=lambda _number: end_process(lambda: ExitCode.STOPPED, [lambda: _halted(robot)]),
        ),
        closing(ReaderWatch()),
        closing(robot),
        stopped_by_suspension(
            lambda: _halted(robot), lambda: order.output.line(order.words("suspend-impossible"))
        ),
    ):
        return _Calibration(order, robot).talk()


@contextmanager
def _guarded(robot: SerialRobot, *, is_real: bool) -> Iterator[None]:
    """Stop the robot if this process is killed, or if it was lost while it drove."""
    guard = Guard(robot.port) if is_real else None
    try:
        yield
    finally:
        if guard is not None:
            guard.end(may_drive_on=robot.may_drive_on)


def _keep(order: Order, sizes: _Measures) -> int:
    """Write the measured sizes. Raises ``Unusable``."""
    measured = {"wheel_radius": sizes.wheel_radius, "axle_length": sizes.axle_length}
    if not any(measured.values()):
        order.output.line(order.words("calibrate-nothing"))
        return ExitCode.FAILED
    is_real = order.settings.robot != DOUBLE
    for key, metres in measured.items():
        if metres is not None:
            order.output.line(order.words(f"calibrate-{key.replace('_', '-')}", millimetres=metres * 1000))
            if is_real:
                _write(order, key, metres)
    order.output.line(order.words("calibrate-kept" if is_real else "calibrate-not-kept"))
    return ExitCode.DONE


def _write(order: Order, key: str, value: float | str) -> None:
    with as_unusable(order.words):
        remember(key, value, order.environment)


class _Calibration:
    """One dialogue with the person who measures."""

    def __init__(self, order: Order, robot: SerialRobot) -> None:
        self._order = order
        self._robot = robot
        self._input = Input()
        self._config: RobotConfig = robot_config(order.settings)

    def talk(self) -> _Measures:
        """Raises ``_Lost``, and ``RobotProblem`` where nothing moves."""
        self._say("calibrate-start")
        self._robot.connect()
        radius = self._measured_radius()
        return _Measures(radius, self._measured_axle(radius or self._config.wheel_radius))

    def _measured_radius(self) -> float | None:
        counts = self._counted("calibrate-walk", STEPS, lambda: self._robot.forward(STEPS))
        asked = 100 * STEPS * STEP
        centimetres = self._ask("calibrate-ask-centimetres", asked) if counts else None
        if not counts or centimetres is None:
            return None
        return self._sound(wheel_radius(counts, self._config.counts_a_turn, centimetres / 100))

    def _measured_axle(self, radius: float) -> float | None:
        counts = self._counted("calibrate-turn", DEGREES, lambda: self._robot.turn(DEGREES))
        degrees = self._ask("calibrate-ask-degrees", DEGREES) if counts else None
        if not counts or degrees is None:
            return None
        return self._sound(axle_length(counts, self._config.counts_a_turn, radius, degrees))

    def _counted(self, code: str, amount: int, go: Callable[[], WalkResult | TurnResult]) -> float:
        """The counts of both wheels on average; 0 if this is not measured."""
        self._say(code, amount=amount)
        while line := self._input.line():
            self._say("calibrate-enter-alone")
        if line is None:
            return 0.0
        before = self._robot.telemetry
        done = go()
        if done.stopped_by is StoppedBy.LINK:
            raise _Lost(ExitCode.UNUSABLE)
        if done.stopped_by is StoppedBy.RUNAWAY:
            raise _Lost(ExitCode.FAILED)
        if done.stopped_by is StoppedBy.WRONG_WAY:
            self._say("problem-wrong-way")
            self._say("hint-wrong-way")
        if done.stopped_by is not None:
            self._say("calibrate-cut-short")
            return 0.0
        return _mean_counts(before, self._robot.telemetry)

    def _sound(self, metres: float) -> float | None:
        if _SMALLEST <= metres <= _LARGEST:
            return round(metres, 5)
        self._say("calibrate-absurd")
        return None

    # --- asking

    def _ask(self, code: str, expected: float) -> float | None:
        """Ask for a number above 0, near the expected one or typed twice; None for an empty answer."""
        self._say(code)
        doubted = 0.0
        while line := self._input.line():
            number = _number(line)
            if number and (number == doubted or expected / FAR < number < expected * FAR):
                return number
            doubted = number
            if number:
                self._say("calibrate-far", number=line, expected=round(expected))
            else:
                self._say("calibrate-number")
        return None

    def _say(self, code: str, **values: object) -> None:
        self._order.output.line(self._order.words(code, **values))


def _halted(robot: SerialRobot) -> bool:
    robot.halt()
    robot.wait_until_standing()
    return True


def _number(line: str) -> float:
    """A number above 0, with a point or a comma; 0 for anything else."""
    try:
        number = float(line.replace(",", "."))
    except ValueError:
        return 0.0
    return number if 0 < number < 1e6 else 0.0


def _mean_counts(before: Telemetry, after: Telemetry) -> float:
    return (abs(after.right - before.right) + abs(after.left - before.left)) / 2


def _end(_number: int, _frame: FrameType | None) -> NoReturn:
    """End the conversation after a signal as after Ctrl+C, so that the robot is stopped."""
    raise KeyboardInterrupt


# --- the colours of a camera


def _calibrate_colours(order: Order, what: str) -> int:
    """Measure each colour, then write the ranges. The exit code is 1 if there is nothing to keep."""
    if what.lower() not in COLOUR:
        raise Unusable(order.words("usage-unrecognized", what=quoted(what)))
    camera = make_camera(order.settings)
    if camera is None:
        raise Unusable(order.words("calibrate-no-camera"))
    with closing(camera), ExitStack() as closing_voice:
        # loaded here: the wheels are measured without a voice
        from donnie_tui.outlets.audible import make_audible

        hub = Hub(lambda: 0.0)  # for the voice alone, as no robot moves
        audible = make_audible(order.settings, hub, order.words, closing_voice)

        def say(code: str, **values: object) -> None:
            sentence = order.words(code, **values)
            order.output.line(sentence)
            audible.say_printed(sentence)

        try:
            ranges = _ColourCalibration(camera, say, order.words.language).talk()
        except RobotProblem as problem:
            raise Unusable(" ".join(sentences_of(problem, order.words))) from None
        except KeyboardInterrupt:
            order.output.line(order.words("calibrate-ended"))
            raise
        if ranges:
            _write(order, "colours", colours_text({**camera.ranges, **ranges}))
        say("calibrate-kept" if ranges else "calibrate-nothing")
        let_sound(audible.is_still_within, threading.Event())
    return ExitCode.DONE if ranges else ExitCode.FAILED


class _ColourCalibration:
    """One dialogue with a person, blind or sighted, who holds things before the camera."""

    def __init__(self, camera: ColourCamera, say: Callable[..., None], language: str) -> None:
        self._camera = camera
        self._say = say
        self._language = language
        self._input = Input()
        self._is_over = False

    def talk(self) -> dict[str, ColourRange]:
        """Run the dialogue. Returns the new ranges. Raises ``RobotProblem``."""
        self._camera.directions()
        self._say("calibrate-colour-start")
        taken: dict[str, ColourRange] = {}
        for colour in self._camera.ranges:
            measured = None if self._is_over else self._measured(colour)
            if measured is not None and self._is_wanted(colour, measured, {**self._camera.ranges, **taken}):
                taken[colour] = measured
        return taken

    def _measured(self, colour: str) -> ColourRange | None:
        """Measure a colour; None if the person skips it. Only Enter alone takes a picture."""
        from devices.camera import blobs_in, measured_range

        while True:
            self._say("calibrate-colour-show", colour=self._word(colour))
            line = self._line()
            if line is None or answered(line) is False:
                return None
            if line:
                continue
            picture = self._camera.source.picture(0)
            found = measured_range(picture)
            if found is None:
                self._say("calibrate-colour-mixed")
                continue
            hue, most_hue, saturation, _, value, _ = found
            values = {"hue": hue, "to": most_hue, "saturation": saturation, "brightness": value}
            count = len(blobs_in(picture, {colour: found}))
            self._say("calibrate-colour-found", colour=self._word(colour), count=count, **values)
            return found

    def _is_wanted(self, colour: str, measured: ColourRange, ranges: dict[str, ColourRange]) -> bool:
        """Ask before a range is replaced; repeat the question after an unclear answer."""
        from devices.camera import do_overlap

        for other, limits in ranges.items():
            if other != colour and do_overlap(measured, limits):
                self._say("calibrate-colour-overlaps", colour=self._word(colour), other=self._word(other))
        while True:
            self._say("calibrate-colour-replace", colour=self._word(colour))
            line = self._line()
            is_wanted = False if line is None else answered(line)
            if is_wanted is not None:
                return is_wanted

    def _line(self) -> str | None:
        line = self._input.line()
        self._is_over = line is None
        return line

    def _word(self, colour: str) -> str:
        return argument_spelling(colour, self._language).lower()
