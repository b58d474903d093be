"""The session behind the screen, whether it is there already or not.

Rule: all of it can be asked at any time, for keys, signals and faults come when they come; what stops the
robots can be asked in any thread.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from donnie_tui.robot.search import Search

if TYPE_CHECKING:
    from donnie_tui.bootstrap import Donnie
    from donnie_tui.tui.work import Work


class SessionBehind:
    """From nothing, by way of a robot that is looked for, to the learner's work."""

    def __init__(self, search: Search | None) -> None:
        """``search``: what gives up the first search for a robot, where there is one."""
        self._search = search
        self.found: Donnie | None = None
        """What was assembled: whoever leaves before there is work must be able to close it."""
        self.work: Work | None = None
        """None until it is loaded."""

    @property
    def runs(self) -> bool:
        """Whether anything could be stopped, of whichever robot."""
        work = self.work
        return work is not None and (work.ctx.runs.is_busy or bool(work.donnie.team.running))

    def give_up_search(self) -> bool:
        """Whether a robot was looked for."""
        search = self.work.donnie.connection.search if self.work is not None else self._search
        return search is not None and search.give_up()

    def halt(self) -> None:
        """All robots, and the search for one."""
        self.give_up_search()
        if self.work is not None:
            self.work.halt()

    def stop_real_robot(self) -> bool:
        """Whether one drove."""
        return self.work is not None and self.work.donnie.stop_real_robot()

    def point(self, words: str) -> None:
        """Say what somebody looks at."""
        if self.work is not None:
            self.work.talk.point(words)

    def keep_text(self) -> None:
        """Write down what is not saved, for the next start."""
        if self.work is not None:
            self.work.workspace.write_copies()

    def close(self) -> None:
        """After the screen is gone: nothing is left running."""
        if self.work is not None:
            self.work.close()
        elif self.found is not None:
            self.found.close()
