"""The linear mode from the greeting to the exit code: one conversation after the other, each in its world.

When it ends, for any reason, the terminal is given back as it was found, and the robot is released, unless
the session continues in the full screen.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable

from msgspec.structs import replace

from donnie_tui.bootstrap import Donnie, Unusable, assemble
from donnie_tui.commands.interaction import SLOW, SLOW_AGAIN, EnterWorld, SwitchMode
from donnie_tui.commands.preferences import Preferences
from donnie_tui.i18n.words import Words
from donnie_tui.linear.console import Console, Gone, run_in_background
from donnie_tui.linear.conversation import Conversation, ConversationState
from donnie_tui.linear.greeting import Greeting
from donnie_tui.linear.prompter import prompt_text
from donnie_tui.robot.search import Search
from donnie_tui.settings.parsing import SIMULATED
from donnie_tui.settings.settings import Settings


def run_linear(
    settings: Settings,
    file: str | None,
    cause: str,
    greeting: Greeting,
    *,
    text: str | None = None,
    donnie: Donnie | None = None,
) -> int:
    """Talk with the learner until the exit code is known. ``cause``: see ``i18n.first_words``.

    ``greeting`` may have been printed already. ``text`` is the program that the other mode left, if it did;
    then ``file`` is only its name, and ``donnie`` the session that it left. Raises ``SwitchMode``, with the
    session, for the full screen, and ``Unusable`` for a world that can't be used.
    """
    is_there = donnie is not None or settings.robot == SIMULATED
    begins_bare = file is None and not text and is_there and donnie is None
    greeting.greet(
        donnie.words.language if donnie else settings.language,
        cause,
        os.environ,
        prompt=prompt_text(settings, 0) if begins_bare else None,
        tour=settings.tour,
    )
    console = Console(greeting.terminal)
    with contextlib.ExitStack() as closing:
        closing.callback(greeting.forget)
        closing.callback(console.close)
        session = contextlib.ExitStack()
        closing.push(session)
        if donnie:
            donnie.outlets.audible.move_to(is_linear=True)
        try:
            donnie = donnie or _assembled(console, settings, greeting)
        except Gone:
            return console.code_when_gone
        except Unusable:
            greeting.withdraw()
            raise
        offers = cause == "word" and settings.linear is not True
        worlds = _Worlds(donnie, console, greeting, settings, session)
        code = worlds.visit(lambda each: each.begin(file, text, offers_to_remember=offers))
        session.close()
        return worlds.donnie.code_at_end(code, lambda sentence: console.write(f"{sentence}\n"))


class _Worlds:
    """The worlds that the learner enters, with a conversation in each."""

    def __init__(
        self,
        donnie: Donnie,
        console: Console,
        greeting: Greeting,
        settings: Settings,
        session: contextlib.ExitStack,
    ) -> None:
        """``donnie`` is the first session. ``session`` closes the last one in the end, unless it continues in
        the full screen.
        """
        self.donnie = donnie
        self._console, self._greeting, self._settings = console, greeting, settings
        self._preferences = Preferences(settings, os.environ)
        self._session = session

    def visit(self, begin: Callable[[Conversation], int]) -> int:
        """Returns the exit code. ``begin`` runs the first conversation. Raises as ``run_linear`` does."""
        state: ConversationState | None = None
        while True:
            donnie = self.donnie
            self._console.give_up = donnie.connection.search.give_up
            self._session.callback(donnie.close)
            conversation = Conversation(donnie, self._console, self._preferences, self._greeting, state)
            with contextlib.closing(conversation):
                try:
                    return conversation.resume() if state else begin(conversation)
                except EnterWorld as entered:
                    self.donnie = self._enter(donnie, entered.name)
                    state = conversation.state_for_next_world()
                except SwitchMode:
                    self._session.pop_all()
                    raise

    def _enter(self, donnie: Donnie, name: str) -> Donnie:
        """The session in that world, which can be loaded; if its devices fail, one in the world before."""
        from donnie_tui.commands.world import settings_there

        before = settings_there(donnie, self._preferences.settings, self._settings.world)
        self._session.close()
        there = replace(before, world=name)
        try:
            found = _assembled(self._console, there, self._greeting)
        except Unusable as unusable:
            self._console.write(f"{unusable.sentence}\n")
            return _assembled(self._console, before, self._greeting)
        self._settings = there
        return found


def _assembled(console: Console, settings: Settings, greeting: Greeting) -> Donnie:
    """A new session. Raises ``Gone`` if the learner doesn't wait for it.

    The search for a robot and a learner's world file may take long, which is reported.
    """
    import worlds

    is_there = settings.robot == SIMULATED
    search = Search(is_pending=not is_there)
    console.give_up = search.give_up
    words = Words(settings.language, settings.verbosity)
    search.on_slow = lambda: console.write(f"{words('connect-waiting')}\n")
    if is_there and settings.world in worlds.names():
        return assemble(settings, terminal=True, search=search)
    if is_there:
        from pathlib import Path

        sentence = words("slow-world", name=Path(settings.world).name)
    else:
        console.write(f"{words('connect-trying')}\n")
        sentence = words("slow-connect")

    def report() -> None:
        greeting.end_prompt()
        console.write(f"{sentence}\n")

    first = SLOW if is_there else SLOW_AGAIN
    return run_in_background(
        console, lambda: assemble(settings, terminal=True, search=search), report, first=first
    )
