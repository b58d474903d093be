"""The work, as far as actions need it: what its parts may use, and the parts themselves."""

from __future__ import annotations

from typing import Protocol

from donnie_tui.tui.following import Following
from donnie_tui.tui.pages import Pages
from donnie_tui.tui.past import Past
from donnie_tui.tui.while_typing import WhileTyping
from donnie_tui.tui.workbench import Workbench


class WorkHost(Workbench, Protocol):
    """What ``Work`` is to the deeds."""

    past: Past
    pages: Pages
    following: Following
    while_typing: WhileTyping
