"""The only place that names concrete classes: a session with its world, its robot and its outlets.

What is heavy is imported where it is used, so that a command loads no more than it needs.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, TextIO

from devices.ports.robot import Pace, Watcher
from donnie_tui.audible import Audible, make_audible
from donnie_tui.core.event_stream import JsonLines
from donnie_tui.core.events import Answered
from donnie_tui.core.hub import Stream
from donnie_tui.core.session import ResettableRobot, Session
from donnie_tui.core.team import Team
from donnie_tui.core.told_log import ToldLog, next_log
from donnie_tui.i18n.words import Words
from donnie_tui.settings import Settings
from donnie_tui.tangible import belt_settings, connect_belt
from donnie_tui.unusable import Unusable
from donnie_tui.world_choice import ChosenWorld, choose_world

if TYPE_CHECKING:
    from sim.picture import Picture
    from sim.world import World

__all__ = ["Donnie", "SwitchMode", "Unusable", "assemble", "colours_of_world"]


class SwitchMode(Exception):
    """Raised by a front end that the user leaves for the other one. The program text goes with it."""

    def __init__(self, text: str, name: str | None) -> None:
        super().__init__("switch")
        self.text = text
        self.name = name


@dataclass(slots=True)
class Donnie:
    """Everything that a front end works with. ``close`` leaves nothing running."""

    team: Team
    """The robots of the world, and who of them is talked to."""
    words: Words
    notices: tuple[str, ...]
    """What had to be done without, a sentence each, to be told once at the start."""
    about_devices: tuple[str, ...]
    """Those of the notices that are about the belt and the robot."""
    world: ChosenWorld
    """Its name, scene, and title, description and task where it is one of ours."""
    _audible: Audible
    _lost: list[str]
    """The files that could not be written to their end."""
    _closing: ExitStack

    @property
    def session(self) -> Session:
        """The session of the robot that is talked to."""
        return self.team.chosen

    def picture(self) -> Picture:
        """The world as a grid of letters and a list of things. Events tell where the robot is."""
        from sim.picture import picture

        return picture(self.world.scene)

    def is_quiet_within(self, seconds: float) -> bool:
        """Wait until everything was said, that long at most; False if that was not enough."""
        return self._audible.is_quiet_within(seconds)

    @property
    def has_lost_output(self) -> bool:
        """Whether something that was asked for could not be written; it was told when that happened."""
        return bool(self._lost)

    @property
    def audible(self) -> Audible:
        """What makes a voice and sounds."""
        return self._audible

    def close(self) -> None:
        """The robots stop first, whatever else takes its time."""
        self.team.stop()
        self._closing.close()


def assemble(settings: Settings, *, terminal: bool, out: TextIO | None = None) -> Donnie:
    """A session as the settings want it. ``out`` takes the events of ``--events -``. Raises ``Unusable``.

    ``terminal``: QUIT is allowed, and a name may be declared again by a later batch.
    """
    words = Words(settings.language, settings.verbosity)
    _refuse_what_is_to_come(settings, words)
    world = _inhabited_world(settings, words)
    closing, lost = ExitStack(), list[str]()
    try:
        team = _team(settings, words, world, terminal)
        closing.callback(team.close)
        session = team.chosen
        _write_events(settings, session, words, out, lost, closing)
        _write_log(settings, session, words, closing)
        about_settings = tuple(words(each.code, **each.values) for each in settings.notices)
        audible = make_audible(settings, session, words, closing)
        about_devices = connect_belt(settings, session.hub, words, closing)
    except BaseException:
        closing.close()
        raise
    notices = about_settings + audible.notices + about_devices
    return Donnie(team, words, notices, about_devices, world, audible, lost, closing)


def colours_of_world(settings: Settings, words: Words) -> frozenset[str]:
    """The colours that the world's robot can tell apart. Raises ``Unusable``."""
    world = _inhabited_world(settings, words)
    return _team(settings, words, world, terminal=False).chosen.colours


def _inhabited_world(settings: Settings, words: Words) -> ChosenWorld:
    world = choose_world(settings.world, words, settings.world_folders)
    if not world.scene.robots:
        raise Unusable(words("world-without-robot", name=world.name))
    return world


def _refuse_what_is_to_come(settings: Settings, words: Words) -> None:
    if settings.robot != "sim":
        raise Unusable(words("robot-to-come", robot=settings.robot))
    if settings.record is not None:
        raise Unusable(words("option-to-come", option="--record"))


def _team(settings: Settings, words: Words, world: ChosenWorld, terminal: bool) -> Team:
    """The robots of the simulated world. The first one is the learner's until another one is chosen."""
    from sim.world import World

    shared, stream = World(world.scene, seed=settings.seed), Stream()
    names = tuple(dict.fromkeys(world.scene.models[index].name for index in world.scene.robots))

    def make_session(name: str) -> Session:
        make_robot = partial(_simulated_robot, shared, name, settings)
        shown_as = name if len(names) > 1 else None
        return Session(
            make_robot,
            words,
            world=world.name,
            seed=settings.seed,
            terminal=terminal,
            belt=belt_settings(settings),
            name=shown_as,
            stream=stream,
        )

    return Team(names, make_session, stream, shared.expect)


def _simulated_robot(
    world: World, name: str, settings: Settings, pace: Pace, watcher: Watcher
) -> ResettableRobot:
    return world.robot(name, pace=pace, watcher=watcher, speed=settings.speed)


def _write_events(
    settings: Settings,
    session: Session,
    words: Words,
    out: TextIO | None,
    lost: list[str],
    closing: ExitStack,
) -> None:
    if settings.events is None:
        return
    if settings.events != "-":
        out = _open_to_write(settings.events, words, closing)
    elif out is None:
        raise Unusable(words("events-need-run"))

    session.hub.subscribe(JsonLines(out, _teller_of_loss(settings.events, session, words, lost)))


def _teller_of_loss(name: str, session: Session, words: Words, lost: list[str]) -> Callable[[OSError], None]:
    """What to do when a file can't be written any more: tell it, and remember it for the exit code."""

    def tell(problem: OSError) -> None:
        lost.append(name)
        reason = problem.strerror or str(problem)
        session.hub.publish(Answered(words("file-unwritable", path=name, reason=reason)))

    return tell


def _write_log(settings: Settings, session: Session, words: Words, closing: ExitStack) -> None:
    """``Log/log_001.txt`` and so on, as the original GoDonnie did."""
    if not settings.log:
        return
    try:
        Path("Log").mkdir(exist_ok=True)
        out = _open_to_write(str(next_log(Path("Log"))), words, closing)
    except OSError as problem:
        raise Unusable(words("file-unwritable", path="Log", reason=problem.strerror)) from None
    session.hub.subscribe(ToldLog(out, words))


def _open_to_write(name: str, words: Words, closing: ExitStack) -> TextIO:
    """Lone surrogates become the escapes that JSON has for them."""
    try:
        out = Path(name).open(  # noqa: SIM115 -- closed with the session
            "w", encoding="utf-8", errors="backslashreplace", newline="\n"
        )
    except (OSError, ValueError) as problem:
        reason = getattr(problem, "strerror", None) or str(problem)
        raise Unusable(words("file-unwritable", path=name, reason=reason)) from None
    closing.callback(_close_quietly, out)
    return out


def _close_quietly(out: TextIO) -> None:
    """What could not be written was told when it was written."""
    with suppress(OSError):
        out.close()
