"""``donnie replay FILE``: a recorded run told and shown again.

Told through the same listeners as the run itself, so that it is printed, spoken and sounded alike.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import ExitStack
from itertools import islice
from pathlib import Path
from typing import TextIO, cast

from devices.ports.values import Frozen
from donnie_tui import LANGUAGES
from donnie_tui.cli import codes
from donnie_tui.cli.ending import let_sound, stopped_by_signals
from donnie_tui.cli.order import Order
from donnie_tui.cli.output import Guarded, Output
from donnie_tui.cli.replay_desk import ReplayDesk
from donnie_tui.cli.replay_map import ReplayMap
from donnie_tui.core.events import Answered, Moved, RunStarted, Stamped, Turned
from donnie_tui.core.hub import Hub, Stream
from donnie_tui.core.recording import LARGEST, NoRecordingError, Recording
from donnie_tui.core.replay import Replay
from donnie_tui.core.retelling import told_back
from donnie_tui.core.timeline import Timeline
from donnie_tui.core.transcript import told_lines
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.outlets.audible import make_audible
from donnie_tui.outlets.written import Written
from donnie_tui.world.recorded import unpacked
from language.control import ExecutionControl

_NEAR_THE_BEGINNING = 100
"""Events in which the first run is looked for."""

FIXED = ("world", "robot", "seed", "belt", "record")
"""Options that mean nothing to what has happened already."""


class _Audience(Frozen):
    """Whoever listens to the replay."""

    hub: Hub


def replay(order: Order) -> int:
    """``donnie replay``."""
    arguments, words = order.invocation.arguments, order.words
    _refuse_what_has_no_meaning(order)
    with ExitStack() as closing:
        recording = _opened(arguments.file, words, closing)
        for damage in recording.damages:
            order.output.complaint(words(f"damaged-{damage.code}", line=damage.line, count=damage.last))
        if arguments.check:
            from donnie_tui.cli.rechecking import run_again

            return run_again(order, recording)
        telling = _Telling(order, recording, closing)
        code = telling.tell()
    return codes.UNUSABLE if telling.has_lost else code


def _refuse_what_has_no_meaning(order: Order) -> None:
    """Raises ``Unusable`` for an option that would do nothing: what was recorded is fixed."""
    arguments, given, words = order.invocation.arguments, order.invocation.options, order.words
    fixed = next((each for each in FIXED if each in given), None)
    if fixed is not None:
        raise Unusable(words("replay-fixed", option=f"--{fixed}"))
    ways = ("--check", arguments.check), ("--step", arguments.step), ("--backwards", arguments.backwards)
    chosen = [option for option, is_chosen in ways if is_chosen]
    if arguments.check:
        others = [
            ("--map", arguments.map),
            ("--from", arguments.start is not None),
            ("--speed", "speed" in given),
        ]
        chosen += [option for option, is_given in others if is_given]
    if "events" in given:
        chosen.append("--events")
    if len(chosen) > 1 and chosen != ["--step", "--backwards"]:
        raise Unusable(words("options-not-together", option=chosen[1], other=chosen[0]))


def _opened(name: str, words: Words, closing: ExitStack) -> Recording:
    path = Path(name)
    try:
        if path.exists() and not (path.is_file() or path.is_dir()):
            raise Unusable(words("file-no-file", path=name))  # a device or a pipe may have no end
        if path.is_file() and path.stat().st_size > LARGEST:
            raise Unusable(words("recording-too-large", path=name))
        return Recording(closing.enter_context(path.open("rb")))
    except NoRecordingError:
        raise Unusable(words("no-recording", path=name)) from None
    except (OSError, ValueError) as problem:
        reason = getattr(problem, "strerror", None) or str(problem)
        raise Unusable(words("file-unreadable", path=name, reason=reason)) from None


# --- telling


class _Telling:
    """One replay, from the first word to the last."""

    def __init__(self, order: Order, recording: Recording, closing: ExitStack) -> None:
        self._order = order
        self._words = order.words
        self._stream = Stream()
        self._hub = Hub(lambda: 0.0, None, self._stream)
        self._timeline = Timeline(recording.events)
        self._control = ExecutionControl()
        self._map = self._map_of(recording, closing)
        self._moved: str | None = None
        """Who moved in the step that is being told."""
        self._has_moved = False
        self._written = Written(order.settings, self._hub, order.words, closing)
        self._written.events(cast(TextIO, Guarded(order.output)))
        self._written.sounds()
        with_words = order.settings.events != "-"
        of_run = Words(_first_language(recording) or order.words.language, order.words.detail)
        self._stream.subscribe(_follower(of_run))
        self._stream.subscribe(_printer(order.output, of_run, with_words=with_words))
        self._audible = make_audible(order.settings, _Audience(self._hub), of_run, closing)
        self._replay = Replay(self._timeline, self._control, order.settings.speed)

    def tell(self) -> int:
        arguments = self._order.invocation.arguments
        self._begin_at(arguments.start, arguments.backwards)
        self._order.output.on_broken = self._control.stop
        if arguments.step:
            return ReplayDesk(self._replay, self._hub, self._stream, self._words, self._map).talk(
                self._order.output
            )
        with stopped_by_signals(self._control.stop) as stopped:
            to_the_end = self._play_backwards() if arguments.backwards else self._replay.forwards(self._show)
            let_sound(self._audible.is_still_within, stopped)
        return codes.DONE if to_the_end else codes.STOPPED

    @property
    def has_lost(self) -> bool:
        """Whether a file could not be written to its end."""
        return bool(self._written.lost)

    def _begin_at(self, seq: int | None, backwards: bool) -> None:
        """Just before the event of that number; backwards, behind it."""
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
        self._hub.publish(Answered(told_back(undone, self._timeline, self._words)))
        movement = next((each for each in undone if isinstance(each.event, Moved | Turned)), None)
        if movement is not None:
            self._show_map(movement.robot)

    def _show_map(self, robot: str | None) -> None:
        for row in self._map.lines(self._timeline, robot) if self._map is not None else ():
            self._order.output.line(row)

    def _map_of(self, recording: Recording, closing: ExitStack) -> ReplayMap | None:
        """Of the floor, where somebody wants to see it, and the recording still has it."""
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
    """That of the first run, where it stands near the beginning."""
    first = islice(recording.events, _NEAR_THE_BEGINNING)
    return next(filter(None, map(_language_of, first)), None)


def _follower(of_run: Words) -> Callable[[Stamped], None]:
    """What was told of a run is in its language: so is what is told around it, the frame of a mistake."""

    def follow(stamped: Stamped) -> None:
        of_run.language = _language_of(stamped) or of_run.language

    return follow


def _language_of(stamped: Stamped) -> str | None:
    event = stamped.event
    if not isinstance(event, RunStarted) or event.how is None or event.how.language not in LANGUAGES:
        return None
    return event.how.language


def _printer(output: Output, words: Words, *, with_words: bool) -> Callable[[Stamped], None]:
    """Events to standard output leave no room for words there; what is wrong is told all the same."""

    def tell(stamped: Stamped) -> None:
        for line in told_lines(stamped, words):
            if with_words:
                output.line(line)
            elif isinstance(stamped.event, Answered):
                output.complaint(line)

    return tell
