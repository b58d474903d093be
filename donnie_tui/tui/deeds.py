"""What each action of the table does. One method an action, by its name; ``argument`` is what was typed
after its word, empty where it came from a key. Rule: one that can't understand it answers False and does
nothing, as in the linear mode; how the word is typed is then told here.
"""

from __future__ import annotations

from collections.abc import Awaitable
from typing import TYPE_CHECKING

from donnie_tui.core import use_cases
from donnie_tui.core.speeds import speed_words
from donnie_tui.core.typed_words import number_in
from donnie_tui.core.watching import may_be_watched
from donnie_tui.tui.actions import BY_NAME
from donnie_tui.tui.deeds_around import AroundDeeds
from donnie_tui.tui.deeds_lines import LineDeeds
from donnie_tui.tui.deeds_map import MapDeeds
from donnie_tui.tui.deeds_robots import RobotDeeds
from donnie_tui.tui.deeds_settings import SettingsDeeds
from donnie_tui.tui.deeds_telling import TellingDeeds
from donnie_tui.tui.deeds_text import TextDeeds
from donnie_tui.tui.running import Answer, Doing

if TYPE_CHECKING:
    from donnie_tui.tui.host import WorkHost


class Deeds:
    """Does them. Those that ask something are coroutines."""

    def __init__(self, host: WorkHost) -> None:
        self._host = host
        self._robots = RobotDeeds(host)
        self._parts = (
            self,
            MapDeeds(host),
            TellingDeeds(host),
            TextDeeds(host),
            LineDeeds(host),
            AroundDeeds(host),
            SettingsDeeds(host),
            self._robots,
        )

    def do(self, name: str, argument: str) -> Awaitable[None] | None:
        """Do the action. Raises ``AttributeError`` for a name that is not in the table."""
        if argument and not BY_NAME[name].argument:
            self._refuse(name)
            return None
        part = next((each for each in self._parts if hasattr(each, name)), self)
        done = getattr(part, name)(argument)
        self._host.look()
        if isinstance(done, Awaitable):
            return self._finish(name, done)
        self._answer(name, done)
        return None

    async def ask_and_do(self, name: str) -> None:
        """What is typed behind its word elsewhere is asked for."""
        words, action = self._host.words, BY_NAME[name]
        example = words(f"help-typed-{action.argument}")
        asked = words("ask-argument", word=action.word(words.language), example=example)
        argument = await self._host.talk.ask(asked)
        if argument is not None and (doing := self.do(name, argument)) is not None:
            await doing

    async def _finish(self, name: str, doing: Awaitable[bool | None]) -> None:
        self._answer(name, await doing)

    def _answer(self, name: str, understood: bool | None) -> None:
        if understood is False:
            self._refuse(name)

    def _refuse(self, name: str) -> None:
        """Nobody knows what stands behind its word."""
        self._host.talk.tell_sentences(use_cases.not_understood(BY_NAME[name].case, self._host.words))

    # --- running

    @property
    def _program(self) -> tuple[str, str]:
        return self._host.workplace.editor.text, self._host.files.name

    def run(self, _argument: str) -> None:
        self._host.talk.tell(self._host.running.run(*self._program))

    def again(self, argument: str) -> None:
        self.run(argument)

    def stop(self, _argument: str) -> None:
        self._host.past.to_present()
        self._host.talk.tell(self._host.running.stop())

    def pause(self, _argument: str) -> None:
        self._host.past.to_present()
        self._host.talk.tell(self._host.running.pause_or_continue())

    def continue_(self, _argument: str) -> None:
        self._host.past.to_present()
        self._host.talk.tell(self._host.running.go_on())

    def step(self, _argument: str) -> None:
        self._host.past.to_present()
        self._host.talk.tell(self._host.running.step(*self._program))

    def step_over(self, _argument: str) -> None:
        self._host.past.to_present()
        self._host.talk.tell(self._host.running.step_over(*self._program))

    def step_back(self, _argument: str) -> None:
        self._host.past.step_back()

    def run_to(self, argument: str) -> bool:
        editor = self._host.workplace.editor
        line = number_in(argument, editor.line)
        if line is None:
            return False
        if not 1 <= line <= editor.line_count:
            self._host.talk.tell(Answer("answer-no-line", {"line": line, "last": editor.line_count}))
        else:
            self._host.past.to_present()
            self._host.talk.tell(self._host.running.run_to(line, *self._program))
        return True

    def reset(self, _argument: str) -> None:
        self._host.past.to_present()
        self._host.talk.tell(self._host.running.reset())
        self._host.following.show_pose()

    def watch(self, argument: str) -> bool:
        """A variable is told at each change; again, no more; without a name, which are."""
        if argument and not may_be_watched(argument):
            return False
        self._host.talk.tell_sentences(*self._host.watch.toggle(argument))
        return True

    # --- speed

    def faster(self, _argument: str) -> None:
        self._host.running.faster()
        self._tell_speed()

    def slower(self, _argument: str) -> None:
        self._host.running.slower()
        self._tell_speed()

    def speed(self, argument: str) -> None:
        wrong = self._host.running.set_speed(argument) if argument else None
        if wrong:
            self._host.talk.tell(wrong)
        else:
            self._tell_speed()

    def _tell_speed(self) -> None:
        speed = speed_words(self._host.running.speed, self._host.words)
        self._host.talk.tell(Answer("answer-speed", {"speed": speed}))

    # --- the robot

    def connect(self, argument: str) -> Awaitable[None] | None:
        return self._robots.connect_to(argument) if self._is_idle() else None

    # --- files

    def open(self, argument: str) -> Awaitable[None] | None:
        return self._host.files.open(argument) if self._is_idle() else None

    async def save(self, argument: str) -> None:
        await self._host.files.saving.save(argument)

    async def save_as(self, argument: str) -> None:
        await self._host.files.saving.save_as(argument)

    def new(self, _argument: str) -> Awaitable[None] | None:
        return self._host.files.new() if self._is_idle() else None

    def recover(self, _argument: str) -> Awaitable[None] | None:
        return self._host.files.recovering.recover() if self._is_idle() else None

    def _is_idle(self) -> bool:
        """Whether nothing runs; told if something does."""
        if self._host.running.doing is Doing.READY:
            return True
        self._host.talk.tell(Answer("screen-busy"))
        return False

    # --- looking

    def show_program(self, _argument: str) -> None:
        self._host.workplace.go_to(self._host.workplace.program_pane)

    def show_map(self, _argument: str) -> None:
        self._host.workplace.go_to(self._host.workplace.map_pane)

    def show_log(self, _argument: str) -> None:
        self._host.workplace.go_to(self._host.workplace.log_pane)

    def show_variables(self, _argument: str) -> None:
        self._host.workplace.toggle_inspector()

    def help(self, _argument: str) -> None:
        self._host.pages.show_help()

    def keys_here(self, _argument: str) -> None:
        self._host.pages.show_keys_here()

    # --- leaving

    def visual(self, _argument: str) -> None:
        self._host.talk.tell(Answer("screen-is-visual"))

    def linear(self, _argument: str) -> None:
        self._host.switch_to_linear()

    async def quit(self, _argument: str) -> None:
        if await self._host.files.are_safe_to_leave():
            self._host.leave()
