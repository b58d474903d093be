"""A command that was understood, with everything that it needs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from devices.ports.hints import TYPE_CHECKING
from devices.ports.values import Frozen
from donnie_tui.cli.arguments import Invocation
from donnie_tui.cli.output import Output
from donnie_tui.i18n.words import Words
from donnie_tui.settings.chosen import Settings

if TYPE_CHECKING:
    from donnie_tui.linear.greeting import Greeting


class Order(Frozen):
    invocation: Invocation
    settings: Settings
    words: Words
    output: Output
    environment: Mapping[str, str]
    greeting: Greeting | None = None
    """What the linear mode has printed already."""

    @property
    def outputs(self) -> tuple[tuple[str, str], ...]:
        """The options that name a file to be written, and the files."""
        return (*_written_as_it_happens(self.settings), *_pages(self.invocation))


def _written_as_it_happens(settings: Settings) -> Iterator[tuple[str, str]]:
    if settings.record is not None:
        yield "--record", settings.record
    if settings.events not in (None, "-"):
        yield "--events", str(settings.events)
    if isinstance(settings.sound, str):
        yield "--sound", settings.sound


def _pages(invocation: Invocation) -> Iterator[tuple[str, str]]:
    """What ``donnie world`` writes."""
    for option in ("svg", "brf"):
        name = getattr(invocation.arguments, option, None)
        if name:
            yield f"--{option}", name
