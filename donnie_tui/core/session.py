"""One learner with one robot in one world: the front ends and ``donnie run`` use it.

Nothing here blocks but ``Run.wait``. One program runs at a time. The robot's pose and the variables stay from
one run to the next, unless a run is ``fresh``.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import partial
from typing import Protocol, TypeAlias

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.robot import Pace, Pose, Robot, Watcher
from donnie_tui import __version__
from donnie_tui.core.actions import MovedThings, RobotActions, RobotWatcher
from donnie_tui.core.announcer import Announcer
from donnie_tui.core.belt import BeltDisplay, BeltSettings
from donnie_tui.core.events import HowStarted, Outcome, Reset, RunStarted, Sensed
from donnie_tui.core.hub import Hub, Stream
from donnie_tui.core.runner import Readable, Run, Stage, takes_turns
from donnie_tui.core.transcript import SentencePublisher
from donnie_tui.core.voice import SpeechWait
from donnie_tui.core.wording import Wording
from language.compiler import compile_program
from language.control import ControlState, ExecutionControl
from language.diagnostics import Diagnostic, Stopped
from language.parser import Parsed, parse
from language.runtime import Frame, Memory, Runnable
from language.source import lines_in


class ResettableRobot(Robot, Protocol):
    """A robot whose world can begin anew, at a pace that can be changed."""

    speed: float | None
    """Times the real robot's pace; None is as fast as possible."""

    def reset(self) -> None: ...


LONGEST_STOP = 2.5
"""Seconds that a program may take to end after a stop."""

MakeRobot: TypeAlias = Callable[[Pace, Watcher], ResettableRobot]


class Busy(Exception):
    """A program is running already."""


class Taken(Busy):
    """A client of the Player server drives another robot of the world."""


class SessionSetup(Struct, frozen=True):
    """The parts of a session, apart from its robot and the words."""

    world: str
    seed: int
    terminal: bool
    """Whether QUIT is allowed, and a later batch may declare a name again."""
    belt: BeltSettings = BeltSettings()
    name: str | None = None
    """The robot's, where its world has several."""


class RunOptions(Struct, frozen=True):
    """How a text is run."""

    fresh: bool = False
    """Whether the robot is put back to its start and variables are forgotten, once the text was parsed
    without mistakes."""
    hooked: bool = True
    """Whether the run can be stepped."""
    trace: bool = False
    first_line: int = 1
    terminal: bool | None = None
    """Overrides the session's: the program of an editor is no terminal, the line below it is."""
    together: tuple[str, ...] = ()
    """The robots that start at the same moment."""
    driver: Runnable | None = None
    """What runs in place of a text, without turns: others drive the robot meanwhile."""


RUN_OPTIONS = RunOptions()


class _CurrentPace:
    """The pace of the program that runs now; the robot outlives the programs' controls."""

    def __init__(self) -> None:
        self.control: ExecutionControl | None = None
        self.has_waited = threading.Event()
        """Whether the program waited for its robot, or is over."""

    def sleep(self, seconds: float) -> bool:
        self.has_waited.set()
        return self.control is not None and self.control.sleep(seconds)

    def may_continue(self) -> bool:
        """Whether no stop was requested."""
        return self.control is not None and self.control.state is not ControlState.STOPPING


class Session:
    """Runs programs on a robot and publishes what happens."""

    def __init__(
        self,
        make_robot: MakeRobot,
        wording: Wording,
        setup: SessionSetup,
        *,
        stream: Stream | None = None,
        speech_wait: SpeechWait | None = None,
        moved_things: MovedThings = lambda: None,
    ) -> None:
        """``stream``: the one that the robots of a world share. ``moved_things`` returns the places of the
        world's things.
        """
        self._pace = _CurrentPace()
        self._began: float | None = None
        """When the last run of this robot began, by its clock; None before the first one."""
        self.hub = Hub(self._since_began, setup.name, stream)
        self.wording = wording
        self._wording = wording
        self.sentences = SentencePublisher(self.hub, wording)
        self._setup = setup
        self._own_robot, self._speech_wait = make_robot, speech_wait
        self._moved_things = moved_things
        self._take(make_robot)
        self.name = self.hub.robot or self._robot.name
        """The robot's name in its world, also after ``change_robot``."""
        self._announcer = Announcer(self.hub, self.sentences, wording)
        self._memory = Memory()
        self._lock = threading.Lock()
        self._run: Run | None = None
        self.is_taken: Callable[[], bool] = lambda: False
        """Whether others drive robots of this world, so that no program can begin."""

    def _since_began(self) -> float:
        """Seconds of robot time; what happens before the first run happens at 0."""
        return 0.0 if self._began is None else self._robot.time() - self._began

    def _take(self, make_robot: MakeRobot) -> None:
        watcher = RobotWatcher(self.hub)
        self._robot = make_robot(self._pace, watcher)
        self._belt = watcher.belt = BeltDisplay(self._robot, self.hub, self._setup.belt)
        self._actions = RobotActions(
            self._robot,
            self.hub,
            self.sentences,
            self._belt,
            may_continue=self._pace.may_continue,
            speech_wait=self._speech_wait,
            moved_things=self._moved_things,
        )
        watcher.on_problem = self._actions.announce_problem

    # --- programs

    def parse(self, text: str, first_line: int = 1, *, fresh: bool = False) -> Parsed:
        """The program's tree, or its mistakes of form, with the colours that this robot can see.

        A robot without a camera reports that at run time. ``fresh``: nothing was declared before.
        """
        memory = Memory() if fresh else self._memory
        return parse(
            text,
            first_line=first_line,
            colours=self._robot.colours or None,
            declared=memory.procedures,
            variables=memory.variables,
            learner=self._wording.language,
        )

    def start(
        self,
        text: str,
        name: str,
        options: RunOptions = RUN_OPTIONS,
        *,
        prepare: Callable[[ExecutionControl], None] | None = None,
        each_statement: Callable[[], None] | None = None,
        when_read: Callable[[Run], None] | None = None,
    ) -> Run:
        """Runs a program. Raises ``Busy`` while another one runs.

        ``prepare`` gets the control before the first statement, for example to step from the start.
        ``each_statement`` is called before each statement, in the program's thread, if the run is hooked.
        ``when_read`` is called after parsing, before anything runs.
        """
        run = self.claim(text, name, options)
        run.control.look_before_each(each_statement if options.hooked else None)
        if when_read is not None:
            run.when_read = partial(when_read, run)
        try:
            if prepare:
                prepare(run.control)
            self.begin(run)
        except BaseException:
            self.give_up(run)
            raise
        return run

    def claim(self, text: str, name: str, options: RunOptions = RUN_OPTIONS) -> Run:
        """As ``start``, but the run waits for ``begin``: for robots that start together."""
        with self._lock:
            if self._run is not None:
                raise Busy(self.name)
            if options.driver is None and self.is_taken():
                raise Taken(self.name)
            how = HowStarted(
                text,
                options.first_line,
                options.fresh,
                self._setup.terminal if options.terminal is None else options.terminal,
                options.trace,
                self._robot.pose(),
                self.wording.language,
                self.wording.detail,
                self.hub.robot is not None,
                options.together,
            )
            if options.fresh and how.is_together:  # the world begins anew before the first of them takes part
                self._begin_anew()
            self._run = self._new_run(name, how, options)
            self._pace.control = self._run.control
            self._pace.has_waited.clear()
            return self._run

    def begin(self, run: Run) -> None:
        """Starts a run that was claimed."""
        run.start(then=self._release)

    def give_up(self, run: Run) -> None:
        """Gives up a claimed run that has not begun. One that has begun is stopped, and ends by itself."""
        if run.has_begun:
            self.stop()
            return
        self._release(run)
        if takes_turns(self._robot):
            self._robot.leave()

    def _new_run(self, name: str, how: HowStarted, options: RunOptions) -> Run:
        control = ExecutionControl()

        def read() -> Readable:
            if options.driver is not None:
                return options.driver
            parsed = self.parse(how.text, how.first_line, fresh=how.fresh)
            if parsed.program is None:
                return parsed.diagnostics
            if control.state is ControlState.STOPPING:
                raise Stopped
            return compile_program(
                parsed.program, terminal=how.terminal, hooked=options.hooked or options.trace
            )

        run = Run(
            Stage(
                self._robot,
                self._memory,
                self.hub,
                self._actions,
                self.wording,
                self._actions.publish_things,
                self._about_to_end,
            ),
            name,
            partial(self._begin, name, how, options),
            read,
            tuple(lines_in(how.text)),
            control=control,
            first_line=how.first_line,
            trace=how.trace,
        )
        run.has_turns = options.driver is None
        return run

    def _begin(self, name: str, how: HowStarted, options: RunOptions, refused: bool) -> RunStarted:
        """Prepares the run's first event, in the program's thread and in its turn."""
        how = replace(how, refused=refused)
        if how.begins_anew and not how.is_together:
            self._begin_anew()
        self._actions.begin_run()
        self._began = self._robot.time()
        how = replace(how, pose=self._robot.pose())
        can_be_repeated = how if options.driver is None else None
        return RunStarted(name, self._setup.world, self.name, self._setup.seed, __version__, can_be_repeated)

    def _about_to_end(self, outcome: Outcome) -> None:
        self._belt.rest()
        self._announcer.about_to_end(outcome)

    def _release(self, run: Run) -> None:
        with self._lock:
            if self._run is run:
                self._run = None
                self._pace.has_waited.set()

    def check(self, text: str, *, whole: bool = True) -> tuple[Diagnostic, ...]:
        """All mistakes of form, or the hints of a program that has none.

        ``whole`` is False for a batch of a terminal: earlier ones may have declared what it uses.
        """
        parsed = self.parse(text)
        if parsed.program is None:
            return parsed.diagnostics
        from language.checker import check  # only texts that are asked about

        return parsed.diagnostics + check(parsed.program, whole=whole)

    # --- the running program

    @property
    def run(self) -> Run | None:
        """The run that is not over yet."""
        return self._run

    @property
    def frames(self) -> tuple[Frame, ...]:
        run = self._run
        return run.frames() if run else ()

    def stop(self) -> None:
        """Stops the program and halts the robot. Any thread, any time."""
        run = self._run
        if run:
            run.control.stop()
            self._robot.halt()

    def wait_for_stop(self) -> bool:
        """Waits some moments at most for a stopped program to end. Returns whether no program runs."""
        run = self._run
        return run is None or not run.is_ending or run.wait(LONGEST_STOP)

    def wait_until_acting(self, seconds: float) -> None:
        """Waits for the robot's first movement or wait, or the program's end, or until the time is over."""
        self._pace.has_waited.wait(seconds)

    # --- the robot

    @property
    def takes_turns(self) -> bool:
        """Whether its robot acts in the order of a simulated world; a real one waits for no other."""
        return takes_turns(self._robot)

    @property
    def speed(self) -> float | None:
        return self._robot.speed

    @speed.setter
    def speed(self, speed: float | None) -> None:
        self._robot.speed = speed

    @property
    def pose(self) -> Pose:
        return self._robot.pose()

    def publish_distances(self) -> None:
        """Publishes the known distances around the robot, for screens. Nothing else happens."""
        self.hub.publish(Sensed(self._robot.known_distances()))

    @property
    def world(self) -> str:
        return self._setup.world

    @property
    def colours(self) -> frozenset[str]:
        return self._robot.colours

    @property
    def variables(self) -> dict[str, int]:
        """The variables of the last program."""
        return dict(self._memory.variables)

    def reset(self) -> None:
        """Puts the robot back to its start and forgets everything. Raises ``Busy`` while a program runs."""
        with self._lock:
            if self._run is not None:
                raise Busy
            self._begin_anew()
        self.hub.publish(Reset(self.pose))
        self._actions.publish_things()

    def publish_things(self) -> None:
        """Publishes where the things are, if that is not known: the world was changed."""
        self._actions.publish_things()

    def change_robot(self, make_robot: MakeRobot | None) -> None:
        """Changes to another robot, at its start and with nothing remembered. None: the first one.

        Raises ``Busy`` while a program runs, and what ``make_robot`` raises; then the old one stays.
        """
        with self._lock:
            if self._run is not None:
                raise Busy
            is_fresh, pose = self._began is None, self.pose
            self._take(make_robot or self._own_robot)
            self._began = None
            self._memory = Memory()
        if not (is_fresh and pose == self.pose):  # otherwise nothing has changed
            self.hub.publish(Reset(self.pose))

    def _begin_anew(self) -> None:
        self._robot.reset()
        self._actions.forget()
        self._memory.forget()

    def close(self, seconds: float = 1.0) -> None:
        """Stops, waits that long for the program's thread, and halts the robot."""
        run = self._run
        self.stop()
        if run:
            run.wait(seconds)
        self._robot.halt()
