"""The work, as far as actions need it: what its parts may use, and the parts themselves."""

from __future__ import annotations

from typing import Protocol

from donnie_tui.tui.pages import Pages
from donnie_tui.tui.run_view import RunView
from donnie_tui.tui.while_typing import WhileTyping
from donnie_tui.tui.workbench import Workbench


class WorkHost(Workbench, Protocol):
    """What ``Work`` is to the deeds."""

    pages: Pages
    run_view: RunView
    while_typing: WhileTyping
