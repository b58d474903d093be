"""The one catalogue of sentences, a module a topic. A code is unique over all of them (a test holds it)."""

from __future__ import annotations

from donnie_tui.i18n.catalogue import (
    answers,
    belt,
    cli,
    cues,
    devices,
    doctor,
    explain,
    files,
    help,  # noqa: A004 -- the module's own name
    linear,
    manual,
    mistakes,
    movement,
    recordings,
    robot_line,
    robots,
    scenarios,
    screen,
    signs,
    sounding,
    stepping,
    summing,
    surroundings,
    things,
    tour,
    tui,
    use_cases,
    worlds,
)
from donnie_tui.i18n.sentence import Sentence

TOPICS = (
    movement,
    recordings,
    robot_line,
    robots,
    mistakes,
    signs,
    help,
    worlds,
    scenarios,
    things,
    files,
    devices,
    doctor,
    cues,
    sounding,
    belt,
    cli,
    linear,
    tour,
    tui,
    screen,
    manual,
    use_cases,
    answers,
    explain,
    stepping,
    summing,
    surroundings,
)

SENTENCES: dict[str, Sentence] = {code: each for topic in TOPICS for code, each in topic.SENTENCES.items()}
