"""The session as the screen reaches it: loaded after the first frame, and asked at any time.

Keys, signals and faults may come before there is a session. What stops the robots works in any thread.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from donnie_tui.robot.search import Search

if TYPE_CHECKING:
    from donnie_tui.bootstrap import Donnie
    from donnie_tui.tui.controller import ScreenController


class SessionHandle:
    """Empty first, then with an assembled session, then with its controller."""

    def __init__(self, search: Search | None) -> None:
        """``search`` gives up the first search for a robot, where there is one."""
        self._search = search
        self.assembled: Donnie | None = None
        """Kept so that ``close`` ends it, too, where the learner leaves before there is a controller."""
        self.controller: ScreenController | None = None
        """None until it is loaded."""

    @property
    def runs(self) -> bool:
        """Whether any robot has something to stop."""
        controller = self.controller
        return controller is not None and (
            controller.ctx.runs.is_busy or bool(controller.donnie.team.running)
        )

    @property
    def next_world(self) -> str:
        """The world in which the screen is to come back; empty where it is not."""
        return self.controller.next_world if self.controller is not None else ""

    @property
    def left_for_linear(self) -> bool:
        return self.controller is not None and self.controller.left_for_linear

    def give_up_search(self) -> bool:
        """Cancel the search for a robot; True if there was one."""
        controller = self.controller
        search = controller.donnie.connection.search if controller is not None else self._search
        return search is not None and search.give_up()

    def halt(self) -> None:
        """Stop all robots, and cancel the search for one."""
        self.give_up_search()
        if self.controller is not None:
            self.controller.ctx.runs.note_stop()
            self.controller.donnie.team.stop()

    def stop_real_robot(self) -> bool:
        """Stop a real robot; True if it was driving."""
        return self.controller is not None and self.controller.donnie.stop_real_robot()

    def point(self, words: str) -> None:
        """Speak what the learner looks at."""
        if self.controller is not None:
            self.controller.point(words)

    def say(self, code: str, **values: object) -> None:
        """Answer with a sentence of the catalogue."""
        if self.controller is not None:
            self.controller.ctx.answer(code, **values)

    def keep_text(self) -> None:
        """Write the unsaved copies, for the next start."""
        if self.controller is not None:
            self.controller.workspace.write_copies()

    def code_at_end(self, code: int, report: Callable[[str], object]) -> int:
        """See ``Donnie``; after ``close``."""
        donnie = self.controller.donnie if self.controller is not None else self.assembled
        return code if donnie is None else donnie.code_at_end(code, report)

    def close(self) -> None:
        """After the screen is gone: nothing is left running."""
        if self.controller is not None:
            self.controller.close()
        elif self.assembled is not None:
            self.assembled.close()
