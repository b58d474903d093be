"""How the linear mode begins and ends: the greeting, the terminal, the robot, and the conversation between.

Rule: whatever ends it, the terminal is as it was found and the robot is left, unless the session goes on in
the full screen.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable

from msgspec.structs import replace

from donnie_tui.bootstrap import Donnie, Unusable, assemble
from donnie_tui.commands.interaction import EnterWorld, SwitchMode
from donnie_tui.commands.preferences import Preferences
from donnie_tui.commands.world import settings_there
from donnie_tui.i18n.words import Words
from donnie_tui.linear.console import Console, Gone
from donnie_tui.linear.conversation import Conversation, Kept
from donnie_tui.linear.greeting import Greeting
from donnie_tui.linear.options import Options
from donnie_tui.robot.choice import Search
from donnie_tui.settings.folders import state_path
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
    """Talk until the learner leaves; the exit code. ``cause``: see ``i18n.first_words``.

    ``greeting`` may have been printed already. ``text`` is the program that the other mode left, where it
    did, ``file`` is then only its name, and ``donnie`` the session that it left. Raises ``SwitchMode``, with
    the session, for the full screen, and ``Unusable`` for a world that can't be used.
    """
    is_there = donnie is not None or settings.robot == SIMULATED
    begins_bare = file is None and not text and is_there and donnie is None
    greeting.greet(
        donnie.words.language if donnie else settings.language,
        cause,
        os.environ,
        prompt=Options(lambda: settings).prompt_at(0) if begins_bare else None,
        tour=settings.tour,
    )
    console = Console(greeting.terminal)
    with contextlib.ExitStack() as closing:
        closing.callback(greeting.forget)
        closing.callback(console.close)
        ours = contextlib.ExitStack()
        closing.push(ours)
        if donnie:
            donnie.outlets.audible.move_to(is_linear=True)
        try:
            donnie = donnie or _begun(console, settings, greeting, is_there=is_there)
        except Gone:
            return console.code_when_gone
        except Unusable:
            greeting.withdraw()
            raise
        stay = _Stay(console, greeting, settings, state_path(os.environ), ours)
        offers = cause == "word" and settings.linear is not True
        return stay.until_left(donnie, lambda talk: talk.until_left(file, text, offers_to_remember=offers))


class _Stay:
    """One conversation after the other, each in its world, until somebody leaves."""

    def __init__(
        self,
        console: Console,
        greeting: Greeting,
        settings: Settings,
        folder: str,
        ours: contextlib.ExitStack,
    ) -> None:
        """``ours`` closes the session that there is in the end, unless it goes on in the other mode."""
        self._console, self._greeting = console, greeting
        self._settings, self._folder = settings, folder
        self._preferences = Preferences(settings, os.environ)
        self._ours = ours

    def until_left(self, donnie: Donnie, begin: Callable[[Conversation], int]) -> int:
        """The exit code. ``begin`` is how the first one goes. Raises as ``run_linear`` does."""
        kept: Kept | None = None
        while True:
            self._console.give_up = donnie.connection.search.give_up
            self._ours.callback(donnie.close)
            talk = Conversation(donnie, self._console, self._folder, self._preferences, self._greeting, kept)
            with contextlib.closing(talk):
                try:
                    return talk.go_on() if kept else begin(talk)
                except EnterWorld as going:
                    donnie = self._move(donnie, going.name)
                    kept = talk.packed()
                except SwitchMode:
                    self._ours.pop_all()
                    raise

    def _move(self, donnie: Donnie, name: str) -> Donnie:
        """The session in that world, which can be loaded; where its devices fail, in the one before."""
        before = settings_there(donnie, self._preferences.settings, self._settings.world)
        self._ours.close()
        there = replace(before, world=name)
        try:
            found = _begun(self._console, there, self._greeting, is_there=there.robot == SIMULATED)
        except Unusable as unusable:
            self._console.write(f"{unusable.sentence}\n")
            found = _begun(self._console, before, self._greeting, is_there=before.robot == SIMULATED)
        else:
            self._settings = there
        return found


def _begun(console: Console, settings: Settings, greeting: Greeting, *, is_there: bool) -> Donnie:
    """A session of its own. Raises ``Gone`` for whoever does not wait for it."""
    search = Search(is_coming=not is_there)
    console.give_up = search.give_up
    words = Words(settings.language, settings.verbosity)
    search.on_slow = lambda: console.write(f"{words('connect-waiting')}\n")
    if not is_there:
        console.write(f"{words('connect-trying')}\n")
    return _awaited(console, settings, search, greeting, is_there=is_there)


def _awaited(
    console: Console, settings: Settings, search: Search, greeting: Greeting, *, is_there: bool
) -> Donnie:
    """A robot that is looked for and a learner's own world take as long as they take; that is said."""
    import worlds

    if is_there and settings.world in worlds.names():
        return assemble(settings, terminal=True, search=search)
    from pathlib import Path

    from donnie_tui.commands.interaction import SLOW, SLOW_AGAIN
    from donnie_tui.linear.patience import aside

    words, name = Words(settings.language, settings.verbosity), Path(settings.world).name
    sentence = words("slow-world", name=name) if is_there else words("slow-connect")

    def tell() -> None:
        greeting.end_prompt()
        console.write(f"{sentence}\n")

    first = SLOW if is_there else SLOW_AGAIN
    return aside(console, lambda: assemble(settings, terminal=True, search=search), tell, first=first)
