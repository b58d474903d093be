"""The linear mode from the greeting to the exit code: one conversation after the other, each in its world.

Whatever ends it, the terminal is given back as it was found, and the robot is released, unless the session
continues in the full screen. Nothing that is printed is ever changed, and no typed program is lost.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable
from functools import partial

from msgspec import Struct
from msgspec.structs import replace

from donnie_tui.bootstrap import Donnie, Unusable, assemble, open_workspace
from donnie_tui.commands.context import Context
from donnie_tui.commands.dispatch import attempt
from donnie_tui.commands.interaction import SLOW, SLOW_AGAIN, EnterWorld, SwitchMode, drive
from donnie_tui.commands.preferences import Preferences
from donnie_tui.commands.world import settings_there
from donnie_tui.core.answer_log import AnswerLog
from donnie_tui.core.line_history import Past
from donnie_tui.core.workspace import Workspace
from donnie_tui.i18n.words import Words
from donnie_tui.linear.console import Console, Gone, run_in_background
from donnie_tui.linear.greeting import Greeting, has_rescued
from donnie_tui.linear.interaction import LinearInteraction, Prompter
from donnie_tui.linear.leaving import Leaving
from donnie_tui.linear.line_editor import Key, KeyEcho
from donnie_tui.linear.listener import BackgroundRobots, Listener, OutputQueue
from donnie_tui.linear.loop import RunLoop, TypedLines
from donnie_tui.linear.output import Options, Output, Printer, Streams
from donnie_tui.linear.reader import EditingReader, How, PlainReader, Typed, candidates
from donnie_tui.robot.choice import Search
from donnie_tui.settings.folders import UNSAVED, state_path
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
        prompt=Options(lambda: settings).prompt_at(0) if begins_bare else None,
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
        worlds = _Worlds(console, greeting, settings, session)
        return worlds.visit(donnie, lambda each: each.begin(file, text, offers_to_remember=offers))


class _Worlds:
    """The worlds that the learner enters, with a conversation in each."""

    def __init__(
        self, console: Console, greeting: Greeting, settings: Settings, session: contextlib.ExitStack
    ) -> None:
        """``session`` closes the last session in the end, unless it continues in the full screen."""
        self._console, self._greeting, self._settings = console, greeting, settings
        self._preferences = Preferences(settings, os.environ)
        self._session = session

    def visit(self, donnie: Donnie, begin: Callable[[Conversation], int]) -> int:
        """The exit code. ``begin`` runs the first conversation. Raises as ``run_linear`` does."""
        state: ConversationState | None = None
        while True:
            self._console.give_up = donnie.connection.search.give_up
            self._session.callback(donnie.close)
            conversation = Conversation(donnie, self._console, self._preferences, self._greeting, state)
            with contextlib.closing(conversation):
                try:
                    return conversation.resume() if state else begin(conversation)
                except EnterWorld as entered:
                    donnie = self._enter(donnie, entered.name)
                    state = conversation.state_for_next_world()
                except SwitchMode:
                    self._session.pop_all()
                    raise

    def _enter(self, donnie: Donnie, name: str) -> Donnie:
        """The session in that world, which can be loaded; if its devices fail, one in the world before."""
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
    search = Search(is_coming=not is_there)
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


class ConversationState(Struct, frozen=True):
    """What a conversation continues with in another world."""

    workspace: Workspace
    answers: AnswerLog
    past: Past
    editing: EditingReader | None
    plain: PlainReader
    """With what was typed ahead."""
    watched: tuple[str, ...] = ()
    is_silent: bool = False


class Conversation:
    """Reads lines, runs and answers them, from the first prompt to the goodbye."""

    def __init__(
        self,
        donnie: Donnie,
        console: Console,
        preferences: Preferences,
        greeting: Greeting,
        state: ConversationState | None = None,
    ) -> None:
        """``state`` is that of the conversation in the world before."""
        self._donnie, self.console, self._greeting = donnie, console, greeting
        self._folder = state_path(os.environ)
        self._state = state = state or self._new_state()
        queue = OutputQueue(console.nudge)
        self.streams = streams = Streams(
            console,
            state.editing,
            state.plain,
            Output(
                console,
                paced=os.isatty(1),
                of_numbers=lambda count: donnie.words("linear-numbers", count=count),
            ),
            queue,
            Options(lambda: preferences.settings),
            is_attended=os.isatty(0),
            is_terminal=os.isatty(1),
        )
        state.workspace.begin_with(donnie.session.name)
        self.ctx = ctx = Context(
            donnie, LinearInteraction(self), state.workspace, state.answers, state.past, preferences
        )
        ctx.runs.watched.extend(state.watched)
        state.workspace.report_failure = lambda error: ctx.answer("answer-not-kept", reason=error.reason)
        self.background = BackgroundRobots(ctx, queue)
        self._listener = Listener(
            donnie,
            console,
            queue,
            self.background,
            is_paced=streams.is_attended and streams.is_terminal,
        )
        self.printer = Printer(streams, donnie.words, state.answers)
        self.prompter = Prompter(ctx, streams, self.printer, self._listener, self.background)
        printing = (streams, self.printer, self.prompter, self.background)
        self.leaving = Leaving(ctx, *printing, greeting.offered)
        self.run_loop = RunLoop(ctx, *printing, self.leaving)
        self.typed_lines = TypedLines(ctx, streams, self.leaving)
        console.before_suspending = donnie.stop_real_robot
        if streams.is_attended:
            console.on_key = donnie.outlets.audible.hush
        if state.editing:
            self._key_echo = KeyEcho(donnie.outlets.audible, donnie.words)
            state.editing.on_key = self._say_key
            state.editing.complete = partial(candidates, ctx)
        streams.apply_options()

    def _new_state(self) -> ConversationState:
        has_terminal = self._greeting.terminal is not None
        past = Past(f"{self._folder}/history" if has_terminal else None)
        editing = EditingReader(self.console, past) if has_terminal else None
        return ConversationState(
            open_workspace(self._folder), AnswerLog(), past, editing, PlainReader(self.console)
        )

    def _say_key(self, key: Key, before: str) -> None:
        if self._donnie.outlets.audible.echoes:
            self._key_echo(key, before)

    def close(self) -> None:
        """Unsubscribe from the session."""
        self.run_loop.close()
        self.ctx.close()
        self.prompter.copying.cancel()
        self._listener.close()

    def begin(self, file: str | None, text: str | None = None, *, offers_to_remember: bool = False) -> int:
        """Read and answer until something ends it. The exit code.

        ``offers_to_remember``: the learner came from the full screen and may want to begin here next time.
        """
        return self._guarded(lambda: self._first_talk(file, text, offers_to_remember))

    def resume(self) -> int:
        """As ``begin``, in another world, with the state of the conversation before."""
        return self._guarded(self._talk_in_next_world)

    def state_for_next_world(self) -> ConversationState:
        is_silent = not self._donnie.outlets.audible.is_on
        return replace(self._state, watched=tuple(self.ctx.runs.watched), is_silent=is_silent)

    def take_again(self, line: str) -> None:
        """Take a line as if it had been typed."""
        self._state.past.remember(line)
        self.typed_lines.take(line)

    def _guarded(self, talk: Callable[[], int]) -> int:
        """Run ``talk``, and keep unsaved programs whatever ends it."""
        workspace = self._state.workspace
        try:
            return talk()
        except EnterWorld:
            workspace.write_copies()
            self.printer.show()
            if not self.streams.is_attended:  # a learner has ended the voice by typing
                self.leaving.let_speak()
            raise
        except SwitchMode:
            workspace.hand_over()
            raise
        except Gone:
            workspace.write_copies()
            return self.console.code_when_gone
        except BaseException:
            workspace.write_copies()
            raise
        finally:
            self._state.past.trim()

    def _first_talk(self, file: str | None, text: str | None, offers_to_remember: bool) -> int:
        self._donnie.outlets.audible.say_printed(*self._greeting.lines)
        is_shown = self._greeting.take_prompt()
        if text is not None:
            self._take_over(text, file)
        elif file is not None:
            from donnie_tui.commands import files

            drive(attempt(self.ctx, files.open_named(self.ctx, file)))
        self._say_notices()
        if offers_to_remember:
            self.leaving.offer_to_remember(linear=True)
        return self._take_lines(is_shown=is_shown)

    def _talk_in_next_world(self) -> int:
        from donnie_tui.commands.world import say_arrival

        say_arrival(self._donnie, is_silent=self._state.is_silent)
        self.ctx.say(*self._donnie.notices.about_devices)
        self._say_number_of_lines()
        return self._take_lines(is_shown=False)

    def _take_over(self, text: str, file: str | None) -> None:
        """Take the program that the full screen left; it is saved if its file contains the same."""
        from pathlib import Path

        from donnie_tui.core.program_files import saved_text

        path = Path(file) if file else None
        self.ctx.workspace.replace(text, path, in_file=saved_text(path) if path else "")
        self._say_number_of_lines()

    def _say_number_of_lines(self) -> None:
        if self.ctx.program.lines:
            self.ctx.answer("linear-lines", lines=len(self.ctx.program.lines))

    def _say_notices(self) -> None:
        """Say what is missing. If the prompt is printed already, this comes with the first answer.

        Notices about the robot and the belt come at once: the learner must know which robot will move.
        """
        notices = self._donnie.notices
        self.ctx.say(*notices.all)
        self.console.has_news = bool(notices.about_devices)
        is_reported = not self.streams.is_attended or self._greeting.has_reported_rescue
        if not is_reported and has_rescued(f"{self._folder}/{UNSAVED}"):
            self.ctx.answer("answer-rescued")

    def _take_lines(self, *, is_shown: bool) -> int:
        """Take lines until the exit code is known. ``is_shown``: whether the prompt is printed already."""
        if self.streams.is_attended:
            self.console.once_idle.append(self._donnie.get_ready_to_move)
        while self.leaving.code is None:
            depth = self.ctx.program.depth if self.streams.is_attended else 0
            self._take(self.prompter.read(self.streams.options.prompt_at(depth), shown=is_shown))
            is_shown = False
        self.leaving.say_goodbye()
        return self.leaving.code

    def _take(self, typed: Typed) -> None:
        if self.console.leaving is not None:
            self.leaving.leave_by_signal(self.console.leaving)
            return
        match typed.how:
            case How.CLOSED:
                self.leaving.close()
            case How.INTERRUPTED:
                self.typed_lines.continuation = None
                self.leaving.interrupt(typed.text)
            case How.TOO_LONG:
                self.ctx.answer("linear-too-long")
            case How.ENTER:
                self.take_again(typed.text)
            case How.ESCAPE:
                self._state.past.remember(typed.text)
                self.typed_lines.take_and_run(typed.text)
        self.leaving.enter_world()
