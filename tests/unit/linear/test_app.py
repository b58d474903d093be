"""The linear mode from its greeting to its exit code, through several worlds, with scripted conversations."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace as Part
from typing import Any

import pytest
from msgspec.structs import replace

from donnie_tui.commands import world as world_commands
from donnie_tui.commands.interaction import EnterWorld, SwitchMode
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.linear import app
from donnie_tui.linear.console import Gone
from donnie_tui.settings.settings import Settings


class Front:
    """What happens, one after the other, in a linear mode whose conversations end as the test says."""

    def __init__(self, patched: pytest.MonkeyPatch, *ends: Any) -> None:
        self.did: list[Any] = []
        self.ends = [*ends]
        """An exit code, or what is raised, for each conversation."""
        self.problems: dict[str, BaseException] = {}
        """By the world that can't be used."""
        self.waited: dict[str, Any] = {}
        self.search: Any = None
        front = self

        class Console:
            code_when_gone = 143
            give_up: Any = None

            def __init__(self, terminal: object) -> None:
                front.did.append(f"console at {terminal}")
                front.console = self

            def write(self, text: str) -> None:
                front.did.append(text)

            def close(self) -> None:
                front.did.append("console closed")

        class Conversation:
            def __init__(
                self, donnie: Any, console: object, preferences: Any, greeting: object, state: object
            ) -> None:
                assert console is front.console
                assert greeting is front.greeting
                assert front.console.give_up == donnie.connection.search.give_up
                self.world = donnie.world
                front.did.append(f"conversation in {donnie.world} with {state}")

            def begin(self, file: str | None, text: str | None, *, offers_to_remember: bool) -> int:
                front.did.append(("begin", file, text, offers_to_remember))
                return self._end()

            def resume(self) -> int:
                front.did.append("resume")
                return self._end()

            def _end(self) -> int:
                end = front.ends.pop(0)
                if isinstance(end, BaseException):
                    raise end
                return int(end)

            def state_for_next_world(self) -> str:
                return f"state of {self.world}"

            def close(self) -> None:
                front.did.append("conversation closed")

        self.console: Any = None
        self.greeting: Any = Part(
            terminal="a terminal",
            greet=lambda *values, **named: self.did.append(("greet", values[:2], named)),
            **{each: partial_did(self.did, each) for each in ("forget", "withdraw", "end_prompt")},
        )
        patched.setattr(app, "Console", Console)
        patched.setattr(app, "Conversation", Conversation)
        patched.setattr(app, "assemble", self.assemble)
        patched.setattr(app, "run_in_background", self.wait_for)
        patched.setattr(
            world_commands, "settings_there", lambda donnie, settings, name: replace(settings, world=name)
        )

    def assemble(self, settings: Settings, *, terminal: bool, search: Any) -> Any:
        self.did.append(f"assembled {settings.world}, {terminal}")
        self.search = search
        if settings.world in self.problems:
            raise self.problems[settings.world]
        return self.donnie(settings.world, search)

    def donnie(self, world: str, search: Any = None) -> Any:
        def code_at_end(code: int, report: Callable[[str], object]) -> int:
            report("It drives on.")
            return code + 10

        return Part(
            world=world,
            words=Part(language="es"),
            outlets=Part(audible=Part(move_to=lambda *, is_linear: self.did.append(f"moved {is_linear}"))),
            connection=Part(search=search or Part(give_up=bool)),
            close=lambda: self.did.append(f"{world} closed"),
            code_at_end=code_at_end,
        )

    def wait_for(self, console: object, task: Callable[[], Any], report: Any, *, first: float) -> Any:
        assert console is self.console
        self.waited = {"report": report, "first": first, "give_up": self.console.give_up}
        return task()

    def run(self, settings: Settings, file: str | None = None, cause: str = "option", **more: Any) -> int:
        return app.run_linear(settings, file, cause, self.greeting, **more)


def partial_did(did: list[Any], name: str) -> Callable[[], None]:
    return lambda: did.append(name)


FLOOR = Settings(world="open_floor", language="pt")


def test_a_conversation_begins_after_its_greeting_and_all_is_closed_at_its_end(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    it = Front(monkeypatch, 1)

    assert it.run(FLOOR) == 11
    assert it.did == [
        ("greet", ("pt", "option"), {"prompt": "> ", "tour": FLOOR.tour}),
        *("console at a terminal", "assembled open_floor, True", "conversation in open_floor with None"),
        ("begin", None, None, False),
        *("conversation closed", "open_floor closed", "It drives on.\n", "console closed", "forget"),
    ]


@pytest.mark.parametrize(
    ("changes", "file", "text", "is_living", "prompt"),
    [
        ({}, None, None, False, "> "),
        ({"prompt": "word"}, None, None, False, "Donnie> "),
        ({}, None, "", False, "> "),
        ({}, None, "FW 1", False, None),
        ({}, "a.gd", None, False, None),
        ({}, None, None, True, None),
        ({"robot": "double"}, None, None, False, None),
    ],
)
def test_the_prompt_comes_with_the_greeting_where_nothing_else_is_said_before_it(
    monkeypatch: pytest.MonkeyPatch,
    changes: dict[str, Any],
    file: str | None,
    text: str | None,
    is_living: bool,
    prompt: str | None,
) -> None:
    it = Front(monkeypatch, 0)
    donnie = it.donnie("maze") if is_living else None
    it.run(replace(FLOOR, **changes), file, text=text, donnie=donnie)

    (_, (language, _), named) = it.did[0]
    assert named["prompt"] == prompt
    assert language == ("es" if is_living else "pt")
    assert ("begin", file, text, False) in it.did
    assert ("moved True" in it.did) is is_living
    assert any(str(each).startswith("assembled") for each in it.did) is not is_living


@pytest.mark.parametrize(
    ("cause", "linear", "offers"),
    [("word", None, True), ("word", False, True), ("word", True, False), ("option", None, False)],
)
def test_after_the_word_the_learner_is_asked_whether_to_begin_here_unless_that_is_set(
    monkeypatch: pytest.MonkeyPatch, cause: str, linear: bool | None, offers: bool
) -> None:
    it = Front(monkeypatch, 0)
    it.run(replace(FLOOR, linear=linear), cause=cause)

    assert ("begin", None, None, offers) in it.did


def test_in_another_world_the_conversation_continues_with_its_state(monkeypatch: pytest.MonkeyPatch) -> None:
    it = Front(monkeypatch, EnterWorld("maze"), EnterWorld("cave"), 3)

    assert it.run(FLOOR) == 13
    assert it.did[3:-3] == [
        "conversation in open_floor with None",
        *(("begin", None, None, False), "open_floor closed", "assembled maze, True"),
        *("conversation closed", "conversation in maze with state of open_floor", "resume"),
        *("maze closed", "assembled cave, True", "conversation closed"),
        *("conversation in cave with state of maze", "resume", "conversation closed", "cave closed"),
    ]


def test_a_world_whose_devices_fail_is_left_for_the_one_before(monkeypatch: pytest.MonkeyPatch) -> None:
    it = Front(monkeypatch, EnterWorld("maze"), EnterWorld("cave"), EnterWorld("street"), 0)
    it.problems["cave"] = Unusable("The belt is missing.")

    assert it.run(FLOOR) == 10
    assembled = [each for each in it.did if str(each).startswith(("assembled", "The belt"))]
    assert assembled == [
        *("assembled open_floor, True", "assembled maze, True", "assembled cave, True"),
        *("The belt is missing.\n", "assembled maze, True", "assembled street, True"),
    ]


def test_a_world_that_can_not_be_used_takes_the_greeting_back(monkeypatch: pytest.MonkeyPatch) -> None:
    it = Front(monkeypatch)
    it.problems["open_floor"] = Unusable("It is damaged.")
    with pytest.raises(Unusable):
        it.run(FLOOR)

    assert it.did[2:] == ["assembled open_floor, True", "withdraw", "console closed", "forget"]


def test_a_signal_while_a_robot_is_looked_for_is_the_exit_code(monkeypatch: pytest.MonkeyPatch) -> None:
    it = Front(monkeypatch)
    it.problems["open_floor"] = Gone()

    assert it.run(FLOOR) == 143
    assert it.did[-2:] == ["console closed", "forget"]


def test_the_full_screen_continues_with_the_open_session(monkeypatch: pytest.MonkeyPatch) -> None:
    it = Front(monkeypatch, SwitchMode("FW 1", None))
    with pytest.raises(SwitchMode):
        it.run(FLOOR)

    assert "open_floor closed" not in it.did
    assert it.did[-3:] == ["conversation closed", "console closed", "forget"]


@pytest.mark.parametrize(
    ("changes", "said", "first", "report"),
    [
        ({"world": "my/room.world"}, [], 1.0, "Loading the world room.world, it takes a while."),
        (
            {"robot": "double"},
            ["I am looking for the robot. Please wait.\n"],
            10.0,
            "I am still looking for the robot. Ctrl+C gives up.",
        ),
    ],
)
def test_a_start_that_may_take_long_is_reported(
    monkeypatch: pytest.MonkeyPatch, changes: dict[str, str], said: list[str], first: float, report: str
) -> None:
    it = Front(monkeypatch, 0)
    it.run(replace(FLOOR, language="en", **changes))

    assert it.did[2 : 2 + len(said)] == said
    assert f"assembled {changes.get('world', 'open_floor')}, True" in it.did
    assert it.waited["first"] == first
    assert callable(it.waited["give_up"])
    it.did.clear()
    it.waited["report"]()
    it.search.on_slow()
    assert it.did == ["end_prompt", f"{report}\n", f"{Words('en')('connect-waiting')}\n"]
    assert it.search.give_up() is ("robot" in changes), "there is a robot to be looked for"
