"""Puts a session together: its world, its robot, its outlets, and what listens to its events.

Heavy modules are imported where they are used, so that a command loads no more than it needs.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from contextlib import ExitStack
from functools import partial
from typing import TYPE_CHECKING, TextIO, TypeAlias

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.robot import Pace, Watcher
from donnie_tui.core.events import Announced, Answered, Outcome, Read, Scanned, Stamped
from donnie_tui.core.hub import Stream
from donnie_tui.core.program_files import DocumentError, FilesInUse, ProgressFile, write_program
from donnie_tui.core.runner import Run, RunRequest
from donnie_tui.core.session import ResettableRobot, RunOptions, Session, SessionSetup
from donnie_tui.core.team import Team
from donnie_tui.core.timeline import Chronicle
from donnie_tui.core.voice import SpeechWait
from donnie_tui.core.workspace import Workspace
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.outlets.audible import Audible, make_audible
from donnie_tui.outlets.belt import BeltAnnouncer, belt_settings, connect_belt
from donnie_tui.outlets.files import Outlets, SessionFiles
from donnie_tui.process import loaded
from donnie_tui.robot.connection import Connection
from donnie_tui.robot.search import Search
from donnie_tui.settings.folders import (
    BREAKPOINTS,
    PROGRESS,
    RECENT,
    UNSAVED,
    UNSAVED_WORLD,
    is_new_decision,
    state_path,
)
from donnie_tui.settings.parsing import SERIAL, SIMULATED
from donnie_tui.settings.settings import Settings, SettingSource
from donnie_tui.world.loading import (
    ChosenWorld,
    Site,
    ThingWatch,
    files_of,
    inhabited_world,
    inventory_of,
    remarks,
    robot_put_in,
    solution_of,
    started_at,
)

if TYPE_CHECKING:
    from pathlib import Path

    from donnie_tui.core.goals import Inventory, Judgment
    from donnie_tui.world.things import Building
    from sim.ground import Looks
    from sim.picture import Drawing, Picture
    from sim.sensors import Mounted
    from sim.world import World
    from worlds.challenges import Answers, Challenge

__all__ = ["Donnie", "Unusable", "assemble", "colours_of_world", "open_workspace"]


class Notices(Struct, frozen=True):
    """The sentences that a start prints about what this session lacks."""

    about_world: tuple[str, ...]
    """Notices about mistakes in a learner's own world file."""
    about_settings: tuple[str, ...]
    about_voice: tuple[str, ...]
    about_devices: tuple[str, ...]
    """Notices about the belt and the robot."""

    @property
    def all(self) -> tuple[str, ...]:
        return self.about_world + self.about_settings + self.about_voice + self.about_devices


class Donnie(Struct, frozen=True):
    """Everything that a front end works with. ``close`` leaves nothing running."""

    words: Words
    site: Site
    """Its world, which can be changed by words."""
    team: Team
    """The robots of the world, one of them current."""
    connection: Connection
    """The connection to the robot, which can be changed."""
    chronicle: Chronicle
    """The latest events, for STEP BACK."""
    outlets: Outlets
    notices: Notices
    _shared: World
    _closing: ExitStack

    @property
    def world(self) -> ChosenWorld:
        """The world: its name, its scene and, if it is built in, title, description and task."""
        return self.site.world

    @property
    def session(self) -> Session:
        """The session of the current robot."""
        return self.team.chosen

    def publish_answers(self, *sentences: str) -> None:
        """Publish answers, which are printed, spoken and can be repeated."""
        for sentence in sentences:
            self.session.hub.publish(Answered(sentence))

    def say(self, code: str, **values: object) -> None:
        """Answer with a sentence of the catalogue."""
        self.publish_answers(self.words(code, **values))

    @property
    def in_use(self) -> FilesInUse:
        return FilesInUse((*self.outlets.written.paths, *files_of(self.world)))

    def picture(self) -> Picture:
        """The world at its start, for the current robot. Events say where everything is now."""
        from sim.picture import picture

        return picture(self.world.scene, self.team.chosen_name)

    def building(self, program: str = "") -> Building:
        """Changes the world while nothing runs. ``program``: the text of the learner's program."""
        from donnie_tui.world.things import Building

        folders = self.outlets.audible.settings.include_folders
        return Building(self.site, self._shared, folders, self.words, program)

    @property
    def holds_something(self) -> bool:
        """Whether a robot holds something in its gripper."""
        return self._shared.is_holding

    @property
    def held_thing(self) -> int | None:
        """The index of the thing in the gripper of the current robot of the world."""
        return self._shared.held_by(self.team.chosen_name)

    def rescue_world(self) -> Path | None:
        """Keep a changed, unsaved world in a file, because no question is possible. Returns the file."""
        if self.site.is_saved:
            return None
        from pathlib import Path

        from donnie_tui.process.confinement import confinement, make_folder

        held = confinement()  # a hidden folder is of no use to its learner
        file = Path(state_path(os.environ) if held is None else held.folder, UNSAVED_WORLD)
        try:
            make_folder(file.parent)
            write_program(file, self.building().text_at(file))
        except (DocumentError, OSError):
            return None
        return file

    def mounted(self) -> tuple[Mounted, ...]:
        """The devices of the current robot in its world; a board has its own."""
        from sim.sensors import mounted

        if self.connection.mounted is not None:
            return self.connection.mounted
        return () if self.connection.is_board else mounted(self.world.scene, self.session.name)

    def picture_now(self) -> Picture:
        """The world for the current robot, with other robots and things at their current places."""
        from sim.picture import picture

        return picture(self._shared.scene_now(), self.team.chosen_name)

    def drawings_now(self) -> tuple[Drawing, ...]:
        """The outlines of everything in the world at its current place."""
        from sim.picture import drawings

        return drawings(self._shared.scene_now())

    def get_ready_to_move(self) -> None:
        """Load the modules of the first movement while the prompt is idle."""
        if not self.connection.is_real:
            self._shared.get_ready()

    def stop_real_robot(self) -> bool:
        """Stop a real robot before a suspension, in which its board would drive on. True if it had a program
        that was not stopped before.

        Returns once the robot stands, or every attempt has failed.
        """
        is_first = self.connection.is_real and self.team.has_unstopped_run
        if self.connection.is_real:
            self.team.stop()
        self.connection.wait_until_standing()
        return is_first

    def stop_unreachable_robot(self) -> None:
        """Stop a real robot that the learner can't follow. Once the connection is back, the learner finds one
        sentence about it."""
        if self.stop_real_robot():
            self.session.hub.publish(Announced("link", self.words("network-stopped")))

    def code_at_end(self, code: int, report: Callable[[str], object]) -> int:
        """The exit code after ``close``: 1, with a sentence, if the real robot still drives."""
        if not self.connection.has_run_away:
            return code
        report(self.words("link-runaway"))
        return 1

    def close(self) -> None:
        """Close the session. The robots stop first; the rest may take longer."""
        self.team.stop()
        self._closing.close()


def assemble(
    settings: Settings,
    *,
    terminal: bool,
    out: TextIO | None = None,
    is_linear: bool = True,
    search: Search | None = None,
) -> Donnie:
    """Make a session from the settings. ``out`` takes the events of ``--events -``. Raises ``Unusable``.

    ``terminal``: QUIT is allowed, and a later batch may declare a name again. ``is_linear``: sentences are
    printed line by line, for a screen reader. ``search``: the search for the robot, to cancel it.
    """
    closing = ExitStack()
    try:
        donnie = _assembled(settings, closing, terminal, out, is_linear=is_linear, search=search)
    except BaseException:
        closing.close()
        raise
    donnie.outlets.let_programs_wait()
    if os.environ.get("SSH_CONNECTION"):
        from donnie_tui.process.disconnection import NetworkWatch  # only over SSH

        closing.callback(NetworkWatch(donnie.stop_unreachable_robot, os.environ).close)
    loaded()
    return donnie


def _assembled(
    settings: Settings,
    closing: ExitStack,
    terminal: bool,
    out: TextIO | None,
    *,
    is_linear: bool,
    search: Search | None,
) -> Donnie:
    """Make a session; all listeners subscribe before the robot is connected, so that they miss no event."""
    from sim.world import World

    words = Words(settings.language, settings.verbosity)
    world = inhabited_world(settings.world, words, settings.include_folders, seed=settings.seed)
    if world.challenge is not None:
        settings = replace(settings, seed=world.rules.variant[0].seed)
    speech_wait, shared = SpeechWait(), World(world.scene, seed=settings.seed)
    team = make_team(settings, words, world, terminal, speech_wait=speech_wait, shared=shared)
    connection = Connection(settings, words, world, team.chosen, search=search)
    closing.callback(connection.close)
    if team.has_several:
        _announce_hold_ups(team, shared, words, speech_wait, closing)
    chronicle = Chronicle()
    team.chosen.hub.subscribe(chronicle)
    written = _written(settings, team.chosen, words, world, out, closing)
    closing.callback(team.close)  # before its files: the last event of a stopped run is written
    audible = make_audible(settings, team.chosen.hub, words, closing, is_linear=is_linear)
    outlets = Outlets(audible, BeltAnnouncer(team, words, belt_settings(settings)), written, speech_wait)
    belt_news = connect_belt(settings, team, words, closing)
    about_robot = _connect_robot(connection, settings, words, world, terminal)
    if settings.served is not None and settings.served.file == settings.world:
        from donnie_tui.player.service import ClientService

        service = ClientService(settings.served, team, world, shared, words)
        closing.callback(service.close)
        service.start()
        about_robot += service.notices
    notices = Notices(
        (
            *robot_put_in(world, words),
            *task_on_arrival(world, words),
            *remarks(world, words),
        ),
        tuple(words(each.code, **each.values) for each in settings.notices),
        audible.notices + (_decided(audible, words) if terminal else ()),
        belt_news() + about_robot,
    )
    return Donnie(words, Site(world), team, connection, chronicle, outlets, notices, shared, closing)


def task_on_arrival(world: ChosenWorld, words: Words) -> tuple[str, ...]:
    """What the challenge asks for, if there is one, and the challenges that should be solved before."""
    if world.challenge is None:
        return ()
    from donnie_tui.core.describe import task_in_words

    solved = progress().solved
    before = [each for each in world.challenge.rules.after if each not in solved]
    titles = ", ".join(world.challenge.title_of(each, words.language) for each in before)
    advice = (words("challenge-after", titles=titles),) if titles else ()
    return (*task_in_words(world.challenge, words, world.title(words.language)), *advice)


def progress() -> ProgressFile:
    """What was done for challenges, in all sessions."""
    return ProgressFile(f"{state_path(os.environ)}/{PROGRESS}")


def _announce_hold_ups(
    team: Team, shared: World, words: Words, speech_wait: SpeechWait, closing: ExitStack
) -> None:
    """Report programs that keep their turn too long, unless they wait for their voice."""
    from donnie_tui.core.team import TurnMonitor

    turn_monitor = TurnMonitor(team, shared.turn, words, is_excused=lambda: speech_wait.waiting > 0)
    turn_monitor.watch()
    closing.callback(turn_monitor.close)


def _written(
    settings: Settings,
    session: Session,
    words: Words,
    world: ChosenWorld,
    out: TextIO | None,
    closing: ExitStack,
) -> SessionFiles:
    written = SessionFiles(settings, session.hub, words, closing)
    written.events(out)
    written.recording(world)
    written.sounds()
    written.log()
    return written


def _decided(audible: Audible, words: Words) -> tuple[str, ...]:
    """The sentences about the chosen voice and how to change it, at the first start and after a change."""
    code = audible.decided
    return (words(code),) if code and is_new_decision(state_path(os.environ), code) else ()


def _connect_robot(
    connection: Connection, settings: Settings, words: Words, world: ChosenWorld, terminal: bool
) -> tuple[str, ...]:
    """Connect the robot of the settings, or the real one that a configuration file asks for.

    Raises ``Unusable`` if it is missing and the learner can't choose another one.
    """
    robot = settings.robot
    if world.physical_port is not None and settings.source_of("robot") is SettingSource.DEFAULT:
        robot = f"{SERIAL}:{world.physical_port}"
    if not terminal:
        connection.insist(robot)
        return ()
    missing = connection.connect(robot)
    return missing or ((words("link-connected"),) if connection.robot != SIMULATED else ())


def colours_of_world(settings: Settings, words: Words) -> frozenset[str]:
    """The colours that the world's robot distinguishes. Raises ``Unusable``."""
    world = inhabited_world(settings.world, words, settings.include_folders, seed=settings.seed)
    return make_team(settings, words, world, terminal=False).chosen.colours


def make_team(
    settings: Settings,
    words: Words,
    world: ChosenWorld,
    terminal: bool,
    *,
    speech_wait: SpeechWait | None = None,
    shared: World | None = None,
) -> Team:
    """Make the robots of a simulated world, the first one chosen."""
    from sim.world import World

    shared = shared or World(world.scene, seed=settings.seed)
    stream = Stream()
    moved_things = ThingWatch(shared)
    names = world.scene.robot_names

    def make_session(name: str) -> Session:
        make_robot = partial(_simulated_robot, shared, name, settings)
        shown_as = name if len(names) > 1 else None
        return Session(
            make_robot,
            words,
            SessionSetup(world.name, settings.seed, terminal, belt_settings(settings), shown_as),
            stream=stream,
            moved_things=moved_things,
            speech_wait=speech_wait,
        )

    return Team(names, make_session, stream, shared.expect)


def _simulated_robot(
    world: World, name: str, settings: Settings, pace: Pace, watcher: Watcher
) -> ResettableRobot:
    return world.robot(name, pace=pace, watcher=watcher, speed=settings.speed)


LONGEST_TRY = 3600.0
"""Seconds of robot time after which a judged program counts as endless."""
MOST_WORK = 20_000
"""Statements after which a judged program counts as endless."""
READING, LOOK = 10, 50
"""As how many statements a reading of a sensor counts, and one of the camera."""
MOST_SITUATIONS = 1_000
"""Places in a program, with its variables and the robot there, that are compared with later ones. A program
that comes to the same one twice is endless."""


class Start(Struct, frozen=True):
    """One of the starts of a challenge, with the world as it is there."""

    challenge: Challenge
    """With this start alone."""
    world: ChosenWorld
    room: Inventory
    looks: Looks = {}
    """What the robots of all tries saw there."""

    def judge(self, events: Iterable[Stamped], answers: Answers = None) -> Judgment:
        """As ``goals.judge``."""
        from donnie_tui.core.goals import judge

        return judge(self.challenge, self.room, events, answers)


Programs: TypeAlias = str | Mapping[str, str] | Sequence[Mapping[str, str]]
"""The program of the first robot, those of several, by the robots' names, or several such one by one."""


class Judge:
    """Judges by the challenge of a world, from each of its starts.

    Without goals the end of the solution is the goal. Raises ``Unusable`` if that can't be read.
    """

    def __init__(self, world: ChosenWorld, words: Words, settings: Settings) -> None:
        from donnie_tui.core.goals import goals_of_end

        assert world.challenge is not None
        self.world, self.challenge, self.words, self._settings = world, world.challenge, words, settings
        self.starts: list[Start] = []
        solution = {} if world.rules.goal else solution_of(world, words)
        for each in world.rules.variant:
            there = started_at(world, each, words, settings.include_folders)
            rules, room = replace(world.rules, variant=(each,)), inventory_of(there.scene)
            start = Start(replace(self.challenge, rules=rules), there, room)
            if not rules.goal:
                rules = replace(rules, goal=goals_of_end(room, self.try_from(start, solution)))
                start = replace(start, challenge=replace(self.challenge, rules=rules))
            self.starts.append(start)
        self.room = self.starts[0].room

    def programs(self, given: Programs, starts: Sequence[Start] | None = None) -> tuple[Judgment, ...]:
        """Judge programs from each start (all by default), up to the first that they do not solve."""
        verdicts: list[Judgment] = []
        for each in self.starts if starts is None else starts:
            verdicts.append(each.judge(self.try_from(each, given)))
            if not verdicts[-1].is_solved:
                break
        return tuple(verdicts)

    def events(self, events: Sequence[Stamped], answers: Answers = None) -> tuple[Judgment, ...]:
        """Judge the events of runs, from the start at which the robot stood first.

        If they solve it, the same programs must solve it from the other starts. ``answers``: as ``judge``.
        """
        from donnie_tui.core.goals import track_of

        starts, rounds = self.starts, track_of(self.room, events).rounds
        stood = {robot: how.pose for each in reversed(rounds) for robot, how in each.items()}
        texts = [{robot: how.text for robot, how in each.items()} for each in rounds]
        at = next((at for at, it in enumerate(starts) if stood.items() <= it.room.robots.items()), 0)
        here = starts[at].judge(events, answers)
        if not here.is_solved:
            return (here,)
        others = self.programs(texts, [*starts[:at], *starts[at + 1 :]])
        return (*others[:at], here, *others[at:])

    def try_from(self, start: Start, programs: Programs) -> list[Stamped]:
        """Runs the programs in the world of a start, and returns what happened. Nothing of it is printed.

        Programs of several robots begin at the same moment. An endless program ends where all is as it was
        before, else by robot time and by its work, so a busy machine changes nothing.
        """
        from sim.world import World

        settings = replace(self._settings, speed=None, seed=start.challenge.rules.variant[0].seed)
        shared = World(start.world.scene, seed=settings.seed, looks=start.looks)
        team = make_team(settings, self.words, start.world, terminal=False, shared=shared)
        events, first = list[Stamped](), team.chosen_name
        given = {first: programs} if isinstance(programs, str) else programs
        rounds, is_alone, work = [given] if isinstance(given, Mapping) else given, True, Counter[str]()

        def note(stamped: Stamped) -> None:
            event, robot = stamped.event, stamped.robot or first
            events.append(stamped)
            if isinstance(event, Read | Scanned):
                work[robot] += READING if isinstance(event, Read) and event.sensor != "colour" else LOOK
            if stamped.t > LONGEST_TRY or work[robot] > MOST_WORK:
                team.session(robot).stop()

        def limit(session: Session, run: Run) -> None:
            robot, seen, noted = shared.inhabitant(session.name), set[Hashable](), 0

            def before_statement() -> None:
                nonlocal noted
                is_repeated = False
                if noted != len(events) and len(seen) < MOST_SITUATIONS and is_alone:
                    noted, now = len(events), (run.progress(), robot.situation)
                    is_repeated = now in seen and now[1] is not None
                    seen.add(now)
                work[session.name] += 1
                if is_repeated or work[session.name] > MOST_WORK:
                    session.stop()

            run.control.look_before_each(before_statement)

        team.stream.subscribe(note)
        options = RunOptions(terminal=len(rounds) > 1)
        for at, each in enumerate(rounds):
            is_alone = len(each) == 1
            requests = {name: RunRequest(text, "program") for name, text in each.items()}
            runs = team.start_together(requests, options, fresh=at == 0, prepare=limit)
            for run in runs:
                run.wait()
            if Outcome.STOPPED in [run.outcome for run in runs]:
                break
        team.close()
        return events


def open_workspace(state_folder: str) -> Workspace:
    """Make an empty workspace over the folder in which earlier starts kept their copies."""
    return Workspace(f"{state_folder}/{UNSAVED}", f"{state_folder}/{BREAKPOINTS}", f"{state_folder}/{RECENT}")
