"""The belt for a session, as the settings want it.

A belt that is missing or lost is told once, and the run goes on. Nobody waits for one at an address that
doesn't answer: that is told when it is known.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import ExitStack

from devices.ports.hints import TYPE_CHECKING
from donnie_tui.core.belt import BeltSettings
from donnie_tui.core.belt_telling import ChosenBelt
from donnie_tui.core.events import BELT_LINK, Announced
from donnie_tui.core.team import Team
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.settings.chosen import Settings
from donnie_tui.settings.devices import SERIAL

if TYPE_CHECKING:
    from devices.belt.line import BeltNews


def belt_settings(settings: Settings) -> BeltSettings:
    """Thresholds and columns; what is not set is as with the original."""
    usual = BeltSettings()
    strong, medium, weak = settings.belt_steps or (usual.strong, usual.medium, usual.weak)
    return BeltSettings(strong, medium, weak, {**usual.columns, **(settings.belt_columns or {})})


def refuse_shared_port(settings: Settings, words: Words) -> None:
    """Robot and belt can't have the same port. Raises ``Unusable``."""
    from devices.serial_port import is_same_port

    kind, _, port = settings.robot.partition(":")
    if kind == SERIAL and port and settings.belt and is_same_port(port, settings.belt):
        raise Unusable(words("belt-same-port", port=settings.belt))


class _News:
    """Of the belt, in words: kept while a session is put together, for nobody hears it then; events after."""

    def __init__(self, port: str, team: Team, words: Words) -> None:
        self._port, self._team, self._words = port, team, words
        self._lock = threading.Lock()
        self._kept: list[str] | None = []

    def __call__(self, news: BeltNews, reason: str) -> None:
        self.tell(self._words(f"belt-{news.value}", port=self._port, reason=reason))

    def tell(self, sentence: str) -> None:
        with self._lock:
            if self._kept is not None:
                self._kept.append(sentence)
                return
        self._team.chosen.hub.publish(Announced(BELT_LINK, sentence))

    def take(self) -> tuple[str, ...]:
        """What was kept; from now on it is events."""
        with self._lock:
            kept, self._kept = self._kept or [], None
            return tuple(kept)


def connect_belt(
    settings: Settings, team: Team, words: Words, closing: ExitStack
) -> Callable[[], tuple[str, ...]]:
    """Let the belt show what the events say. To be called once somebody listens: what was told until then, a
    sentence each."""
    if settings.belt is None:
        return tuple
    refuse_shared_port(settings, words)
    from devices.belt.line import BeltNews, SerialBelt, open_line
    from devices.port_listing import stable_name
    from devices.same_board import SameBoard
    from devices.serial_port import PortProblem

    news = _News(settings.belt, team, words)
    try:
        belt = SerialBelt(stable_name(settings.belt), news, SameBoard(open_line))
    except PortProblem as problem:
        news(BeltNews.MISSING, problem.reason)
        return news.take
    closing.callback(belt.close)
    closing.callback(team.stream.subscribe(ChosenBelt(lambda: team.chosen.hub.robot, belt.show)))
    return news.take
