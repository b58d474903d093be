"""The belt of a session: on the learner's body, and in words, on request or at every change.

Of several robots in a world only the current one drives the belt. A missing or lost belt is reported once,
and the run continues. No start waits for a belt at an address that doesn't answer.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import ExitStack
from typing import TYPE_CHECKING

from donnie_tui.core.belt import OFF, BeltSettings, Levels, in_words, rows_in_words
from donnie_tui.core.events import BELT_LINK, Announced, BeltShown, RunEnded, Stamped
from donnie_tui.core.team import Team
from donnie_tui.core.wording import Wording
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.settings.parsing import SERIAL
from donnie_tui.settings.settings import Settings

if TYPE_CHECKING:
    from devices.belt import BeltNotice


class ChosenBelt:
    """Shows the chosen robot's levels, and none after the end of its run."""

    def __init__(self, chosen: Callable[[], str | None], show: Callable[[Levels], None]) -> None:
        """``chosen`` returns the robot's name in its events, None in a world of one robot."""
        self._chosen = chosen
        self._show = show
        self._levels: dict[str | None, Levels] = {}
        self._shown = OFF

    def __call__(self, stamped: Stamped) -> None:
        match stamped.event:
            case BeltShown(levels=levels):
                self._levels[stamped.robot] = levels
            case RunEnded():
                self._levels[stamped.robot] = OFF
            case _:
                pass
        levels = self._levels.get(self._chosen(), OFF)
        if levels != self._shown:
            self._shown = levels
            self._show(levels)


class BeltAnnouncer:
    """Listens to the belt's events. ``is_on``: every change is put into words."""

    def __init__(self, team: Team, wording: Wording, settings: BeltSettings | None = None) -> None:
        self.is_on = False
        self._team = team
        self._say = wording
        self._settings = settings
        self._levels = OFF
        self._last_words = ""
        team.stream.subscribe(ChosenBelt(lambda: team.chosen.hub.robot, self._on_levels))

    def now(self) -> str:
        """The sentence about what the belt shows."""
        return in_words(self._levels, self._say, self._settings)

    def rows(self) -> tuple[str, ...]:
        """The sentence about what it shows, then both rows of motors with their levels."""
        return (self.now(), *rows_in_words(self._levels, self._say))

    def _on_levels(self, levels: Levels) -> None:
        """Announce levels; repeated pulses of the same pattern once."""
        self._levels = levels
        words = self.now()
        if self.is_on and words != self._last_words:
            self._team.chosen.hub.publish(Announced("belt", words))
        self._last_words = words


def belt_settings(settings: Settings) -> BeltSettings:
    """The thresholds and columns; by default those of the original belt."""
    usual = BeltSettings()
    strong, medium, weak = settings.belt_steps or (usual.strong, usual.medium, usual.weak)
    return BeltSettings(strong, medium, weak, {**usual.columns, **(settings.belt_columns or {})})


def refuse_shared_port(settings: Settings, words: Words) -> None:
    """Robot and belt can't have the same port. Raises ``Unusable``."""
    from devices.serial_ports import is_same_port

    kind, _, port = settings.robot.partition(":")
    if kind == SERIAL and port and settings.belt and is_same_port(port, settings.belt):
        raise Unusable(words("belt-same-port", port=settings.belt))


class _News:
    """Sentences about the belt: collected while a session is assembled, published afterwards."""

    def __init__(self, port: str, team: Team, words: Words) -> None:
        self._port, self._team, self._words = port, team, words
        self._lock = threading.Lock()
        self._kept: list[str] | None = []

    def __call__(self, news: BeltNotice, reason: str) -> None:
        self.publish(self._words(f"belt-{news.value}", port=self._port, reason=reason))

    def publish(self, sentence: str) -> None:
        with self._lock:
            if self._kept is not None:
                self._kept.append(sentence)
                return
        self._team.chosen.hub.publish(Announced(BELT_LINK, sentence))

    def take(self) -> tuple[str, ...]:
        """The notices that were kept; later ones are events."""
        with self._lock:
            kept, self._kept = self._kept or [], None
            return tuple(kept)


def connect_belt(
    settings: Settings, team: Team, words: Words, closing: ExitStack
) -> Callable[[], tuple[str, ...]]:
    """Connect the belt to the events. Call it once the listeners have subscribed. Returns the sentences
    collected until then."""
    if settings.belt is None:
        return tuple
    refuse_shared_port(settings, words)
    from devices.belt import BeltNotice, SerialBelt, open_belt_port
    from devices.serial_ports import PortFault, PortProblem, SameBoard, stable_name

    news = _News(settings.belt, team, words)
    try:
        belt = SerialBelt(stable_name(settings.belt), news, SameBoard(open_belt_port))
    except PortProblem as problem:
        if problem.fault is PortFault.NOT_NAMED:
            news.publish(words("problem-port-not-named", port=settings.belt))
        else:
            news(BeltNotice.MISSING, problem.reason)
        return news.take
    closing.callback(belt.close)
    closing.callback(team.stream.subscribe(ChosenBelt(lambda: team.chosen.hub.robot, belt.show)))
    return news.take
