"""``donnie replay FILE``: a recorded run, shown again or run again.

A replay publishes to the same listeners as the run, so that it is printed, spoken and sounded in the same
way. ``--check`` runs the recording again and compares the events one by one.

``--step`` moves by typed words: forward, back, the map, on to the end. An empty line is a step forward. HELP
lists the words in the learner's language. Lines may come from a file too; on a terminal there is a prompt,
and Ctrl+C stops playing, or ends the replay."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from functools import partial
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, TextIO, cast

from msgspec import Struct

from donnie_tui import __version__
from donnie_tui.bootstrap import make_team
from donnie_tui.cli.options import ExitCode, Order
from donnie_tui.cli.programs import judge_recording
from donnie_tui.cli.streams import Guarded, Input, Output, let_sound, stopped_by_signals
from donnie_tui.core.events import Answered, Moved, RunStarted, Stamped, Turned, as_line
from donnie_tui.core.hub import Hub, Stream
from donnie_tui.core.map_scene import map_at, rows_of
from donnie_tui.core.program_files import STANDARD_OUTPUT, reason_of
from donnie_tui.core.recheck import Result, Verdict, recheck
from donnie_tui.core.recording import LARGEST, Header, NoRecordingError, Recording
from donnie_tui.core.timeline import Replay, Timeline, redone_in_words, undone_in_words
from donnie_tui.core.transcript import lines_with_robot_name, printed_lines, with_robot_name
from donnie_tui.core.wording import keys_of, meant, position_in_words, spelled
from donnie_tui.i18n.words import Unusable, Words, as_unusable
from donnie_tui.outlets.audible import make_audible
from donnie_tui.outlets.files import SessionFiles
from donnie_tui.process.confinement import OutsideError, check_name, open_bytes
from donnie_tui.settings.parsing import SIMULATED
from donnie_tui.settings.settings import faster_than, slower_than, speed_words
from donnie_tui.world.recorded import settings_of, unpacked
from language.control import ExecutionControl
from language.locales import languages
from language.source import printable, quoted

if TYPE_CHECKING:
    from donnie_tui.core.reports import Subject
    from sim.picture import Picture
    from sim.scene import Scene


LONGEST_EXCERPT = 160
"""Characters of an event that are shown where it differs."""


def run_again(order: Order, recording: Recording) -> int:
    """Run a recording again and compare. Returns 0 if all comparable events are the same, else 1."""
    header = _usable(recording, order.words)
    tone = Words()
    settings = settings_of(header, order.settings, order.words)
    with unpacked(header, order.words) as world:
        team = make_team(settings, tone, world, terminal=True)
        with stopped_by_signals(team.stop) as stopped:
            verdict = recheck(recording.events, team, tone)
            team.close()
        if stopped.is_set():
            return ExitCode.STOPPED
    _print_verdict(order, recording, header, verdict)
    return ExitCode.FAILED if verdict.result is Result.DIFFERENT else ExitCode.DONE


def _usable(recording: Recording, words: Words) -> Header:
    if recording.header is None or not recording.is_cut_off_only:
        raise Unusable(words("recheck-damaged"))
    if recording.header.robot != SIMULATED:
        raise Unusable(words("recheck-real", robot=printable(recording.header.robot)))
    return recording.header


def _print_verdict(order: Order, recording: Recording, header: Header, verdict: Verdict) -> None:
    words, line = order.words, order.output.line
    count = len(recording.events)
    at = recording.line_of(verdict.index)
    line(words(f"recheck-{verdict.result.value}", line=at, count=count))
    if verdict.result is not Result.DIFFERENT:
        return
    then = recording.events[verdict.index] if verdict.index < count else None
    line(words("recheck-then", event=_excerpt(then, words)))
    line(words("recheck-now", event=_excerpt(verdict.now, words)))
    if header.version != __version__:
        line(words("recheck-version", then=printable(header.version), now=__version__))


def _excerpt(stamped: Stamped | None, words: Words) -> str:
    if stamped is None:
        return words("recheck-nothing")
    return quoted(as_line(stamped).strip(), LONGEST_EXCERPT)


_NEAR_THE_BEGINNING = 100
"""Events in which the first run is looked for."""

FIXED = ("world", "robot", "seed", "belt", "record")
"""Options without effect on a recording."""


def replay(order: Order) -> int:
    """``donnie replay``."""
    arguments, words = order.invocation.arguments, order.words
    _refuse_what_has_no_meaning(order)
    with ExitStack() as closing:
        recording = _opened(arguments.file, words, closing)
        for damage in recording.damages:
            order.output.complaint(words(f"damaged-{damage.code}", line=damage.line, count=damage.last))
        if arguments.check:
            return run_again(order, recording)
        if any(name is not None for _, name in _files(order)):
            return _report(order, recording, closing)
        if arguments.challenge is not None:
            is_simulated = recording.header is None or recording.header.robot == SIMULATED
            return judge_recording(order, arguments.challenge, recording.events, is_simulated=is_simulated)
        telling = _Player(order, recording, closing)
        code = telling.play()
    return ExitCode.UNUSABLE if telling.has_lost else code


def _refuse_what_has_no_meaning(order: Order) -> None:
    """Raises ``Unusable`` for an option without effect on a recording."""
    arguments, given, words = order.invocation.arguments, order.invocation.options, order.words
    fixed = next((each for each in FIXED if each in given), None)
    if fixed is not None:
        raise Unusable(words("replay-fixed", option=f"--{fixed}"))
    is_played_backwards = arguments.backwards and not arguments.step  # a step has both directions
    ways = ("--check", arguments.check), ("--step", arguments.step), ("--backwards", is_played_backwards)
    chosen = [option for option, is_chosen in ways if is_chosen]
    files = [option for option, name in _files(order) if name is not None]
    if arguments.challenge is not None and not files:
        chosen.append("--challenge")
    chosen += files[:1]
    if arguments.check or arguments.challenge is not None:
        others = [
            ("--map", arguments.map),
            ("--from", arguments.start is not None),
            ("--speed", "speed" in given),
        ]
        chosen += [option for option, is_given in others if is_given]
    if "events" in given:
        chosen.append("--events")
    if len(chosen) > 1:
        raise Unusable(words("options-not-together", option=chosen[1], other=chosen[0]))


def _opened(name: str, words: Words, closing: ExitStack) -> Recording:
    path = Path(name)
    try:
        check_name(path)
        if path.exists() and not (path.is_file() or path.is_dir()):
            raise Unusable(words("file-no-file", path=name))  # a device or a pipe may have no end
        if path.is_file() and path.stat().st_size > LARGEST:
            raise Unusable(words("recording-too-large", path=name, limit=LARGEST // 1024**3))
        return Recording(closing.enter_context(open_bytes(path)))
    except NoRecordingError:
        raise Unusable(words("no-recording", path=name)) from None
    except OutsideError as problem:
        raise Unusable(words(problem.code, path=name)) from None
    except (OSError, ValueError) as problem:
        raise Unusable(words("file-unreadable", path=name, reason=reason_of(problem))) from None


# --- files about the run


class _Wanted(Struct, frozen=True):
    """A requested report, with its option."""

    option: str
    what: str
    """As in REPORT."""
    suffix: str
    """The kind of file, independent of the end of its name."""
    name: str
    """The name of the file; empty for sentences."""


_FORMS = {
    "--svg": ("run", ".svg"),
    "--png": ("run", ".png"),
    "--gif": ("run", ".gif"),
    "--swell": ("paper", ".svg"),
    "--csv": ("distances", ".csv"),
}


def _files(order: Order) -> tuple[tuple[str, str | None], ...]:
    """The options, and the files that they name, or the words of a report."""
    it = order.invocation.arguments
    pictures = ("--svg", it.svg), ("--png", it.png), ("--gif", it.gif), ("--swell", it.swell)
    return *pictures, ("--csv", it.csv), ("--report", it.report)


def _wanted(order: Order) -> Iterator[_Wanted]:
    """The requested reports. Raises ``Unusable`` for an unknown report or a wrong end of a name."""
    from donnie_tui.core.reports import asked, refusal, suffixes_of

    for option, given in _files(order):
        if given is None:
            continue
        if option != "--report":
            yield _Wanted(option, *_FORMS[option], given)
        elif (found := asked(given)) is None or refusal(given, order.words):
            raise Unusable(refusal(given, order.words))
        else:
            what, name = found
            text = ".txt" if ".txt" in suffixes_of(what) else ".svg"
            suffix = text if name == STANDARD_OUTPUT else Path(name).suffix.lower()
            yield _Wanted(option, what, suffix, name)


def _report(order: Order, recording: Recording, closing: ExitStack) -> int:
    """Write the requested files, as REPORT does, and print their content in words.

    If a file is standard output, it is alone there, and no content is said.
    """
    from donnie_tui.core.program_files import write_bytes
    from donnie_tui.core.reports import in_sentences, report

    words, line = order.words, order.output.line
    wanted = tuple(_wanted(order))
    is_taken = any(each.name == STANDARD_OUTPUT for each in wanted)
    for each in wanted:
        is_picture = each.suffix in (".png", ".gif") and each.name == STANDARD_OUTPUT
        if is_picture and order.output.is_terminal:
            raise Unusable(words("picture-at-terminal", option=each.option, file=f"run{each.suffix}"))
    (subject, *others), legend = _subjects(order, recording, closing)
    for each in wanted:
        if not each.name:
            continue
        content = report(each.what, f"report{each.suffix}", subject, words, others)
        if each.name == STANDARD_OUTPUT:
            order.output.data(content)
            continue
        with as_unusable(words):
            write_bytes(Path(each.name), content)
        (order.output.complaint if is_taken else line)(words("paper-written", path=each.name))
    if is_taken:
        return ExitCode.DONE
    if any(each.name and each.what in ("run", "paper") for each in wanted):
        for said in legend:
            line(said)
    spoken = (each.what for each in wanted if each.what == "distances" or not each.name)
    for what in dict.fromkeys(spoken):
        for about in (subject, *others):
            for said in lines_with_robot_name(about.robot, in_sentences(what, about, words), words):
                line(said)
    return ExitCode.DONE


def _subjects(
    order: Order, recording: Recording, closing: ExitStack
) -> tuple[tuple[Subject, ...], tuple[str, ...]]:
    """The subject of REPORT for each robot, and the legend of the picture with the goals of a challenge."""
    from donnie_tui.commands.lookup import words_in_lines
    from donnie_tui.core.reports import Subject
    from donnie_tui.core.timeline import Trail
    from donnie_tui.i18n.help import sections
    from donnie_tui.world.loading import choose_challenge, moved_to
    from donnie_tui.world.run_picture import (
        as_picture,
        moved_things,
        on_swell_paper,
        plot_as_png,
        run_picture,
    )
    from sim.picture import drawings, picture

    words = order.words
    if recording.header is None:
        raise Unusable(words("replay-no-map"))
    world = closing.enter_context(unpacked(recording.header, words))
    timeline = Timeline(recording.events)
    timeline.go_to(len(timeline))
    if not timeline.robots:
        raise Unusable(words("trail-none"))
    moves = Trail(most_moves=len(timeline))
    for stamped in timeline.events:
        moves.on_event(stamped)
    paths = moves.paths
    scene = moved_to(world.scene, timeline.things)
    title = words("paper-title", name=world.title(words.language))
    challenge = order.invocation.arguments.challenge
    goals = () if challenge is None else choose_challenge(challenge, words).rules.goal_places
    moved = moved_things(timeline.events, world.scene)
    drawn = run_picture(title, drawings(scene), paths, words, goals, moved)
    driven = [path.pieces[-1] for path in paths]
    names = scene.robot_names

    def about(robot: str | None) -> Subject:
        own = [each for each in timeline.events if each.robot == robot]
        lines: list[str] = []
        for each in own:
            if isinstance(each.event, RunStarted) and (how := each.event.how):
                lines[how.first_line - 1 :] = how.text.splitlines()
        return Subject(
            tuple(lines),
            timeline.pose(robot) or world.start(),
            picture(scene, robot if robot in names else next(iter(names), None)),
            moves.of(lambda: robot),
            words_in_lines(words),
            sections(words),
            own,
            run_picture=partial(as_picture, drawn),
            plot_as_png=plot_as_png,
            paper=partial(on_swell_paper, world, timeline.things, driven, words),
            robot=robot if len(timeline.robots) > 1 else None,
        )

    return tuple(map(about, timeline.robots)), drawn.sentences


# --- showing


class _Player:
    """A replay, from its first sentence to its last."""

    def __init__(self, order: Order, recording: Recording, closing: ExitStack) -> None:
        self._order = order
        self._words = order.words
        self._stream = Stream()
        self._hub = Hub(lambda: 0.0, None, self._stream)
        self._timeline = Timeline(recording.events)
        self._control = ExecutionControl()
        self._map = self._map_of(recording, closing)
        self._moved: str | None = None
        """The robots that moved in the current step."""
        self._has_moved = False
        self._written = SessionFiles(order.settings, self._hub, order.words, closing)
        self._written.events(cast(TextIO, Guarded(order.output)))
        self._written.sounds()
        with_words = order.settings.events != "-"
        of_run = Words(_first_language(recording) or order.words.language, order.words.detail)
        self._stream.subscribe(_follower(of_run))
        self._stream.subscribe(_printer(order.output, of_run, with_words=with_words))
        self._audible = make_audible(order.settings, self._hub, of_run, closing)
        self._replay = Replay(self._timeline, self._control, order.settings.speed)

    def play(self) -> int:
        arguments = self._order.invocation.arguments
        self._begin_at(arguments.start, arguments.backwards)
        self._order.output.on_broken = self._control.stop
        if arguments.step:
            return ReplayPrompt(self._replay, self._hub, self._stream, self._words, self._map).talk(
                self._order.output
            )
        with stopped_by_signals(self._control.stop) as stopped:
            to_the_end = self._play_backwards() if arguments.backwards else self._replay.forwards(self._show)
            let_sound(self._audible.is_still_within, stopped)
        return ExitCode.DONE if to_the_end else ExitCode.STOPPED

    @property
    def has_lost(self) -> bool:
        """Whether a file could not be written to its end."""
        return bool(self._written.lost)

    def _begin_at(self, seq: int | None, backwards: bool) -> None:
        """Begin just before the event of that number; backwards, just after it."""
        events = self._timeline.events
        if seq is None:
            self._timeline.go_to(len(events) if backwards else 0)
            return
        last = events[len(events) - 1].seq if events else 0
        if not 1 <= seq <= last:
            raise Unusable(self._words("replay-no-such-event", number=seq, last=last))
        index = next(index for index, each in enumerate(events) if each.seq >= seq)
        self._timeline.go_to(index + backwards)

    def _show(self, stamped: Stamped) -> None:
        self._stream.pass_on(stamped)
        if isinstance(stamped.event, Moved | Turned):
            self._moved, self._has_moved = stamped.robot, True
        if self._has_moved and self._timeline.is_between_steps:
            self._has_moved = False
            self._show_map(self._moved)

    def _play_backwards(self) -> bool:
        return self._replay.backwards(self._show_back)

    def _show_back(self, undone: tuple[Stamped, ...]) -> None:
        self._hub.publish(Answered(undone_in_words(undone, self._timeline, self._words)))
        movement = next((each for each in undone if isinstance(each.event, Moved | Turned)), None)
        if movement is not None:
            self._show_map(movement.robot)

    def _show_map(self, robot: str | None) -> None:
        for row in self._map.lines(self._timeline, robot) if self._map is not None else ():
            self._order.output.line(row)

    def _map_of(self, recording: Recording, closing: ExitStack) -> ReplayMap | None:
        """The map, if it was requested and the recording has its world."""
        arguments = self._order.invocation.arguments
        if not (arguments.map or arguments.step) or recording.header is None:
            return None
        try:
            return ReplayMap(
                closing.enter_context(unpacked(recording.header, self._words)).scene, self._words
            )
        except Unusable as unusable:
            self._order.output.complaint(unusable.sentence)
            return None


def _first_language(recording: Recording) -> str | None:
    """The language of the first run, if it is near the beginning."""
    first = islice(recording.events, _NEAR_THE_BEGINNING)
    return next(filter(None, map(_language_of, first)), None)


def _follower(of_run: Words) -> Callable[[Stamped], None]:
    """Switches the language with each run, as the recorded sentences are in the run's language."""

    def follow(stamped: Stamped) -> None:
        of_run.language = _language_of(stamped) or of_run.language

    return follow


def _language_of(stamped: Stamped) -> str | None:
    event = stamped.event
    if not isinstance(event, RunStarted) or event.how is None or event.how.language not in languages():
        return None
    return event.how.language


def _printer(output: Output, words: Words, *, with_words: bool) -> Callable[[Stamped], None]:
    """Prints events as lines; without words only complaints, since events go to standard output."""

    def show(stamped: Stamped) -> None:
        for line in printed_lines(stamped, words):
            if with_words:
                output.line(line)
            elif isinstance(stamped.event, Answered):
                output.complaint(line)

    return show


LONGEST_LINE = 200


class ReplayMap:
    """The map at any position; each robot's picture of the floor is made once."""

    def __init__(self, scene: Scene, words: Words) -> None:
        self._scene = scene
        self._words = words
        self._pictures: dict[str | None, Picture] = {}

    def lines(self, timeline: Timeline, robot: str | None) -> tuple[str, ...]:
        """The map at this position, from north to south; empty if the place of the robot is unknown."""
        scene = map_at(timeline, self._picture(robot), robot)
        if scene is None:
            return ()
        title = () if robot is None else (self._words("replay-map-of", robot=printable(robot)),)
        return (*title, *rows_of(scene, self._words))

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
        """Plays on to the end, or until Ctrl+C."""
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
