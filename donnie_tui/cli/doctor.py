"""``donnie doctor``: what works, what was chosen and why, and the remedy for what does not, a line each."""

from __future__ import annotations

from donnie_tui.cli import codes
from donnie_tui.cli.examination import Finding, examine
from donnie_tui.cli.front_ends import cause_of_linear, surroundings
from donnie_tui.cli.order import Order
from donnie_tui.i18n.words import Words


def doctor(order: Order) -> int:
    """Tell all findings as they are made. The exit code is 0: having looked is what was asked for."""
    problems = 0
    cause = cause_of_linear(None, order.settings.linear, surroundings(order.environment))
    for finding in examine(order.settings, order.environment, cause):
        for line in _lines(finding, order.words):
            order.output.line(line)
        problems += not finding.is_well
    order.output.line(
        order.words("doctor-problems", count=problems) if problems else order.words("doctor-all-well")
    )
    return codes.DONE


def _lines(finding: Finding, words: Words) -> tuple[str, ...]:
    told = words(finding.code, **finding.values)
    if finding.is_well:
        return (told,)
    remedy = words(f"{finding.code}-remedy", **finding.values)
    return words("doctor-problem", text=told), words("doctor-remedy", text=remedy)
