"""The belt for a session, as the settings want it.

A belt that is missing or lost is told once, and the run goes on.
"""

from __future__ import annotations

from contextlib import ExitStack

from donnie_tui.core.belt import BeltSettings
from donnie_tui.core.belt_watching import ChosenBelt
from donnie_tui.core.events import Answered
from donnie_tui.core.team import Team
from donnie_tui.device_settings import SERIAL
from donnie_tui.i18n.words import Words
from donnie_tui.settings import Settings
from donnie_tui.unusable import Unusable


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


def connect_belt(settings: Settings, team: Team, words: Words, closing: ExitStack) -> tuple[str, ...]:
    """Let the belt show what the events say. Answers what can't be done, a sentence each."""
    if settings.belt is None:
        return ()
    refuse_shared_port(settings, words)
    from devices.belt.line import BeltNews, SerialBelt, open_line
    from devices.port_listing import stable_name
    from devices.same_board import SameBoard
    from devices.serial_port import PortProblem

    def tell(news: BeltNews) -> None:
        team.chosen.hub.publish(Answered(words(f"belt-{news.value}")))

    try:
        belt = SerialBelt(stable_name(settings.belt), tell, SameBoard(open_line))
    except PortProblem as problem:
        return (words("belt-missing", port=settings.belt, reason=problem.reason),)
    closing.callback(belt.close)
    closing.callback(team.stream.subscribe(ChosenBelt(lambda: team.chosen.hub.robot, belt.show)))
    return ()
