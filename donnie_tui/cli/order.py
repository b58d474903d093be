"""A command that was understood, with everything that it needs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

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
