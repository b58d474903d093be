"""``donnie replay FILE --check``: a recording run again and compared, event by event."""

from __future__ import annotations

from donnie_tui import __version__
from donnie_tui.bootstrap import make_team
from donnie_tui.cli import codes
from donnie_tui.cli.ending import stopped_by_signals
from donnie_tui.cli.order import Order
from donnie_tui.core.event_stream import as_line
from donnie_tui.core.events import Stamped
from donnie_tui.core.harmless import printable
from donnie_tui.core.recheck import Result, Verdict, recheck
from donnie_tui.core.recording import Header, Recording
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.settings.devices import SIMULATED
from donnie_tui.world.recorded import settings_of, unpacked

LONGEST_EXCERPT = 160
"""Characters of an event that are shown where it differs."""


def run_again(order: Order, recording: Recording) -> int:
    """0 if everything is the same as far as it can be compared, 1 if something differs."""
    header = _usable(recording, order.words)
    tone = Words()
    settings = settings_of(header, order.settings, order.words)
    with unpacked(header, order.words) as world:
        team = make_team(settings, tone, world, terminal=True)
        with stopped_by_signals(team.stop) as stopped:
            verdict = recheck(recording.events, team, tone)
            team.close()
        if stopped.is_set():
            return codes.STOPPED
    _tell(order, recording, header, verdict)
    return codes.FAILED if verdict.result is Result.DIFFERENT else codes.DONE


def _usable(recording: Recording, words: Words) -> Header:
    if recording.header is None or not recording.is_cut_off_only:
        raise Unusable(words("recheck-damaged"))
    if recording.header.robot != SIMULATED:
        raise Unusable(words("recheck-real", robot=printable(recording.header.robot)))
    return recording.header


def _tell(order: Order, recording: Recording, header: Header, verdict: Verdict) -> None:
    words, line = order.words, order.output.line
    count = len(recording.events)
    at = (
        recording.line_of(verdict.index)
        if verdict.index < count
        else recording.line_of(count - 1) + 1
        if count
        else 1
    )
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
    text = printable(as_line(stamped).strip())
    return text if len(text) <= LONGEST_EXCERPT else f"{text[: LONGEST_EXCERPT - 1]}…"
