"""What the actions about robots, the belt and the gripper do. RUN, STOP and the keys go to the chosen robot.

The text of the editor is nobody's own: RUN gives it to whoever is talked to, and TOGETHER starts all that
were given one.
"""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

from donnie_tui.core.handling import Deed
from donnie_tui.core.team import Assigned
from donnie_tui.tui.screens.chooser import Choice
from donnie_tui.words import robot_words, team_words

if TYPE_CHECKING:
    from donnie_tui.tui.host import WorkHost


class RobotDeeds:
    """One method an action."""

    def __init__(self, host: WorkHost) -> None:
        self._host = host

    async def robots(self, _argument: str) -> None:
        """Who is there, told; and where there are several, a list to choose from."""
        team_words.tell_robots(self._host.donnie)
        if self._host.donnie.team.has_several:
            await self.robot("")

    async def robot(self, argument: str) -> None:
        """Talk to that one; without a name, to the one chosen from a list, where there are several."""
        if not argument and not self._host.donnie.team.has_several:
            team_words.tell_robots(self._host.donnie)
            return
        name = argument or await self._chosen()
        if name is None:
            return
        self._give_text()
        if team_words.choose_robot(self._host.donnie, name):
            self._host.following.robot_chosen()

    async def _chosen(self) -> str | None:
        """From a list of all, each with where it is and whether its program runs."""
        donnie = self._host.donnie
        rows = [
            Choice(name, team_words.robot_in_words(donnie, each), each is donnie.session)
            for name in donnie.team.names
            for each in (donnie.team.session(name),)
        ]
        return await self._host.talk.choose(self._host.words("ask-robot"), rows)

    def start(self, _argument: str) -> None:
        """On the screen nobody waits for a run anyway."""
        self._give_text()
        self._host.talk.tell(self._host.running.run(self._host.workplace.editor.text, self._host.files.name))

    def together(self, _argument: str) -> None:
        self._give_text()
        runs = dict(team_words.start_together(self._host.donnie))
        self._host.running.adopt(runs, self._host.donnie.team)

    def stop_all(self, _argument: str) -> None:
        others = [each for each in self._host.donnie.team.running if each is not self._host.donnie.session]
        self._host.past.to_present()
        answer = self._host.running.stop()
        if others:
            team_words.stop_all(self._host.donnie)
        else:
            self._host.talk.tell(answer)

    async def connect_to(self, argument: str) -> None:
        """Another robot, by its number or from a list. It takes some seconds, in which the screen goes on."""
        argument = argument or await self._choose_connection() or ""
        if not argument:
            return
        await asyncio.to_thread(robot_words.connect, self._host.donnie, argument)
        self._host.following.show_pose()

    async def _choose_connection(self) -> str | None:
        """The number of a robot: the simulator, the boards that are plugged in, each with its state."""
        found = await asyncio.to_thread(robot_words.choices_in_words, self._host.donnie)
        rows = [Choice(str(number), *row) for number, row in enumerate(found, 1)]
        return await self._host.talk.choose(self._host.words("ask-connect"), rows)

    def feel(self, argument: str) -> None:
        """The belt in words."""
        robot_words.feel(self._host.donnie, argument)

    def grip(self, _argument: str) -> None:
        team_words.use_gripper(self._host.donnie, Deed.GRIP)

    def release(self, _argument: str) -> None:
        team_words.use_gripper(self._host.donnie, Deed.RELEASE)

    def _give_text(self) -> None:
        """The text is the chosen robot's from now on, if there is any."""
        text = self._host.workplace.editor.text
        if text.strip():
            donnie = self._host.donnie
            donnie.team.give(donnie.session.name, Assigned(text, self._host.files.name))
