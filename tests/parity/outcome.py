"""The outcome of a typed line: the published lines, the question, and the next screen or mode."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from donnie_tui.bootstrap import Donnie
from donnie_tui.core.events import (
    Announced,
    Answered,
    Chimed,
    Passing,
    Pointed,
    RunEnded,
    RunStarted,
    Sensed,
    Spoke,
    Stamped,
    Waited,
    as_record,
)
from donnie_tui.core.run_controller import RunController
from language.control import ControlState

_OF_THE_SCREEN = (Passing, Sensed, Pointed, Chimed)
"""Events for moving pictures and for the focus: they depend on the clock or on the screen."""
_OF_THE_CLOCK = ("seq", "t", "seconds", "version")
"""Fields that another moment, or another version, changes."""
_SLOWNESS = re.compile(
    r".*, (it takes|wait) a while\.|.*, demora um pouco\.|(Reading|Lendo) \d+ .*"
    r"|The world .* is there\.|O mundo .* está pronto\."
)
"""What Donnie says where a machine is busy."""
_UNSTABLE = (
    ControlState.PAUSING,
    ControlState.STOPPING,
    ControlState.ENDED,
)
"""States that end by themselves."""


@dataclass(frozen=True)
class Outcome:
    """Of one line, and of leaving the question that it led to, if it led to one."""

    published: tuple[str, ...] = ()
    """A line for each sentence that was said, and one in angle brackets for each other event."""
    asked: str = ""
    """The question that was asked, or the title of the list or page that was shown."""
    listed: tuple[str, ...] = ()
    """The rows of that list or page."""
    after: tuple[str, ...] = ()
    """What was published when the question was left without an answer."""
    left_for: str = ""
    """Where the line led out of the front end: ``end``, ``other mode``, ``world NAME``."""

    def as_text(self) -> tuple[str, ...]:
        """All of it, a line each."""
        lines = list(self.published)
        lines += [f"? {self.asked}"] if self.asked else []
        lines += [f"- {each}" for each in self.listed]
        lines += [f"after: {each}" for each in self.after]
        lines += [f"leaves: {self.left_for}"] if self.left_for else []
        return tuple(lines)


@dataclass
class Recorder:
    """Listens to all robots of a session, and knows whether their programs have come to rest."""

    donnie: Donnie
    stamped: list[Stamped] = field(default_factory=list)
    _waiting: dict[str | None, int] = field(default_factory=dict)
    """For each robot, the number of WAITs in which its program is."""
    _leave: Callable[[], None] = lambda: None

    def __post_init__(self) -> None:
        self._leave = self.donnie.team.stream.subscribe(self._on_event)

    def close(self) -> None:
        self._leave()

    def _on_event(self, stamped: Stamped) -> None:
        """Runs in the publishing thread."""
        match stamped.event:
            case RunStarted() | Waited() | RunEnded():
                self._waiting[stamped.robot] = 0
            case Announced(code="waiting"):
                self._waiting[stamped.robot] = 1
            case _:
                pass
        self.stamped.append(stamped)

    def is_at_rest(self, runs: RunController) -> bool:
        """Whether every program is over, is held, or is in a WAIT that does not end during a test."""
        for name in self.donnie.team.names:
            session = self.donnie.team.session(name)
            run = session.run
            if run is None:
                continue
            state = run.control.state
            if state is ControlState.PAUSED:
                if not _is_described(runs, session.hub.robot):
                    return False
                continue
            if state in _UNSTABLE or not self._waiting.get(session.hub.robot):
                return False
        self.donnie.session.hub.wait_until_delivered()
        return True

    def take(self) -> tuple[str, ...]:
        """What was published since the last time, as lines of text."""
        taken, self.stamped = self.stamped, []
        return tuple(line for each in taken for line in _lines(each))


def _is_described(runs: RunController, robot: str | None) -> bool:
    """Whether the program's thread has said where the program is held."""
    record = runs._records.get(robot)
    if record is None or not record.is_current:
        return True
    return record.holds if record.is_steppable else record.was_described.is_set()


def _lines(stamped: Stamped) -> Iterable[str]:
    event = stamped.event
    if isinstance(event, _OF_THE_SCREEN):
        return
    if isinstance(event, Answered):
        yield from (each for each in event.text.splitlines() if not _SLOWNESS.fullmatch(each))
        return
    if isinstance(event, Spoke):
        yield f"<spoke {event.text}>"
        return
    record = {name: value for name, value in as_record(stamped).items() if name not in _OF_THE_CLOCK}
    if isinstance(event, RunStarted) and event.how is not None:
        record |= {"fresh": event.how.fresh, "text": event.how.text.rstrip().split("\n")}
    name = record.pop("event")
    yield f"<{name} {', '.join(f'{key}={value}' for key, value in record.items())}>"
