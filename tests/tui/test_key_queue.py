"""Keys in their turn, with queues that are emptied by hand and a clock that is moved by hand."""

import asyncio
from collections import deque
from collections.abc import Awaitable, Callable
from functools import partial
from types import SimpleNamespace

import pytest
from textual import events
from textual.widgets import Input, TextArea

from donnie_tui.commands.keys import KeyTable
from donnie_tui.i18n.words import Words
from donnie_tui.tui import keyboard
from donnie_tui.tui.keyboard import LOOKS, ROUNDS, TAKEN_LOOKS, Dialogs, Keyboard, KeyQueue
from donnie_tui.tui.run_view import Polling


class Pump:
    """What has a queue."""

    def __init__(self, parent: "Pump | None" = None) -> None:
        self._parent = parent
        self.queue: deque[Callable[[], Awaitable[None] | None]] = deque()
        self.is_closing = False

    def call_later(self, do, *given) -> bool:
        """As Textual's: False if it takes nothing any more, because it is closing."""
        if not self.is_closing:
            self.queue.append(partial(do, *given))
        return not self.is_closing

    async def work(self, most: int = 1000) -> None:
        while self.queue and most:
            most -= 1
            waiting = self.queue.popleft()()
            if waiting is not None:
                await waiting


class Timer:
    """As Textual's: what it calls runs in a task of its own, which ends when it is stopped."""

    def __init__(self, call: Callable[[], object]) -> None:
        self._call = call
        self._task: asyncio.Task | None = None

    async def ring(self) -> None:
        async def ringing() -> None:
            waiting = self._call()
            if waiting is not None:
                await waiting

        self._task = asyncio.create_task(ringing())
        await asyncio.wait([self._task])

    def stop(self) -> None:
        if self._task is not None:
            self._task.cancel()


class Application(Pump):
    """An application with a widget that has the focus, and what was done in it."""

    def __init__(self) -> None:
        super().__init__()
        self.focused = Pump(self)
        self.timers: list[Timer] = []
        self.done: list[str] = []
        self.turns = KeyQueue(self, self._feed)

    def set_timer(self, _seconds: float, call: Callable[[], object]) -> Timer:
        self.timers.append(Timer(call))
        return self.timers[-1]

    async def _feed(self, key: SimpleNamespace) -> None:
        await asyncio.sleep(0)
        self.done.append(key.name)
        if key.name.startswith("F"):
            self.turns.do(partial(self.done.append, f"{key.name} done"))

    def press(self, *names: str) -> None:
        for name in names:
            self.turns.hold(SimpleNamespace(name=name))

    def do(self, name: str) -> None:
        self.turns.do(partial(self.done.append, name))

    async def time_out(self) -> None:
        for _ in range(LOOKS):
            await self.timers[-1].ring()

    async def go_on(self) -> None:
        for _ in range(100):
            await self.focused.work()
            await self.work()


async def test_a_command_does_not_overtake_earlier_letters_on_a_slow_machine():
    app = Application()
    app.focused.call_later(app.done.append, "letter")
    app.do("run")
    for _ in range(LOOKS - 1):
        await app.timers[-1].ring()
    await app.focused.work(1)  # a step, at last
    await app.work(1)

    for _ in range(LOOKS - 1):
        await app.timers[-1].ring()

    assert app.done == ["letter"]
    await app.go_on()
    assert app.done == ["letter", "run"]


async def test_keys_after_a_command_of_a_removed_widget_are_all_handled_once():
    app = Application()
    app.do("run")
    app.focused = Pump(app)  # the other one is gone, with its queue
    app.press("a", "b", "c")
    await app.time_out()
    await app.work()

    assert app.done == ["run", "a", "b", "c"]
    assert not app.turns.is_holding


async def test_a_command_whose_widget_is_closing_takes_the_rest_of_its_way_at_once():
    app = Application()
    panel = Pump(app)
    app.focused = row = Pump(panel)
    app.do("run")
    app.press("a", "b")
    panel.is_closing, app.focused = True, Pump(app)
    await row.work()
    await app.go_on()

    assert app.done == ["run", "a", "b"]  # no timer rang


async def test_a_command_after_its_timeout_is_not_repeated_nor_the_next_one_early():
    app = Application()
    app.do("run")
    slow, app.focused = app.focused, Pump(app)
    await app.time_out()
    await app.work()
    app.focused.call_later(app.done.append, "letter")
    app.do("save")
    for _ in range(20):  # the first one's way, to its end
        await slow.work()
        await app.work()

    assert app.done == ["run"]
    await app.go_on()
    assert app.done == ["run", "letter", "save"]


async def test_a_command_after_another_one_waits_for_it_and_none_is_lost():
    app = Application()
    app.do("run")
    app.do("save")
    app.press("a", "F", "b")
    await app.go_on()

    assert app.done == ["run", "save", "a", "F", "F done", "b"]
    assert not app.turns.is_holding


async def test_a_step_of_a_command_counts_as_progress_and_then_all_looks_begin_again():
    app = Application()
    app.do("run")
    for _ in range(LOOKS - 1):
        await app.timers[-1].ring()
    await app.focused.work()  # it has come to the application's queue
    for _ in range(LOOKS):
        await app.timers[-1].ring()
    assert (len(app.queue), len(app.timers)) == (1, 2 * LOOKS)
    await app.timers[-1].ring()
    assert (len(app.queue), app.done) == (2, [])
    await app.work()
    assert app.done == ["run"]


async def test_the_timer_of_a_command_that_is_done_is_stopped_and_would_look_at_no_other_one():
    app, stopped = Application(), []
    app.do("run")
    first = app.timers[-1]
    first.stop = lambda: stopped.append("stopped")
    await app.go_on()
    assert (app.done, stopped) == (["run"], ["stopped"])
    app.do("save")
    app.timers.remove(first)
    for _ in range(LOOKS):
        await first.ring()
    assert (len(app.queue), len(app.timers)) == (0, 1)


async def test_a_widget_without_a_parent_passes_a_command_to_the_application():
    app = Application()
    app.focused = Pump()
    app.do("run")
    await app.go_on()
    assert app.done == ["run"]


async def test_keys_go_on_waiting_after_a_command_where_nothing_can_take_them_yet():
    app, waits = Application(), [True]
    app.turns = KeyQueue(app, app._feed, lambda: waits[0])
    app.do("run")
    app.press("a", "b")
    await app.go_on()
    assert (app.done, app.turns.is_holding) == (["run"], True)
    waits[0] = False
    app.do("save")
    await app.go_on()
    assert app.done == ["run", "save", "a", "b"]


def test_waiting_keys_that_write_nothing_are_no_text():
    queue = KeyQueue(None, None)
    for key, character in (("a", "a"), ("ctrl+a", "\x01"), ("f5", None), ("space", " "), ("enter", "\r")):
        queue.hold(events.Key(key, character))
    assert queue.held_text == "a \n"


# --- what a key does, and when


class Keys:
    """A keyboard at that application, with what it said and did."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, *, is_real: bool = False) -> None:
        self.app = app = Application()
        self.unread = self.must_wait = False
        monkeypatch.setattr(keyboard, "has_unread", lambda _number: self.unread)
        self.fed: list[str] = []
        self.said: list[str] = []
        self.done: list[str] = []
        self.line = SimpleNamespace(has_focus=False, value="", finish=lambda: self.done.append("line"))
        self.place = SimpleNamespace(command_line=self.line, tour=None, is_plain=False)
        app.screen = self.place
        connection = SimpleNamespace(is_real=is_real)
        self.session = SimpleNamespace(
            controller=SimpleNamespace(
                key_pressed=lambda *_: None,
                donnie=SimpleNamespace(connection=connection),
                words=SimpleNamespace(language="en"),
                display=SimpleNamespace(acted=lambda: None),
            ),
            runs=False,
            give_up_search=lambda: False,
            say=lambda code, **_values: self.said.append(code),
        )
        self.dialogs = Dialogs(app, self.place, lambda: None)
        self.keyboard = Keyboard(
            app, self.session, self.place, KeyTable(), dialogs=self.dialogs, feed=self._feed,
            must_wait=lambda: self.must_wait, do=self.done.append,
        )  # fmt: skip

    async def _feed(self, event: events.Event) -> None:
        self.fed.append(getattr(event, "key", type(event).__name__))

    async def press(self, *keys: str) -> None:
        for key in keys:
            await self.keyboard.on_event(events.Key(key, key if len(key) == 1 else None))
            await self.app.go_on()


async def test_what_waits_for_all_keys_comes_at_the_second_look_at_the_earliest(monkeypatch):
    """What was read is handled by then."""
    keys = Keys(monkeypatch)
    keys.keyboard.when_taken(lambda: keys.done.append("done"))
    await keys.app.go_on()
    assert (keys.done, len(keys.app.timers)) == ([], 1)
    await keys.app.timers[-1].ring()
    await keys.app.go_on()
    assert keys.done == ["done"]


@pytest.mark.parametrize("what", ["unread", "must_wait"])
@pytest.mark.parametrize("looks", [3, TAKEN_LOOKS])
async def test_what_waits_for_all_keys_comes_once_they_are_taken_or_after_so_many_looks(
    monkeypatch, what, looks
):
    keys = Keys(monkeypatch)
    setattr(keys, what, True)
    keys.keyboard.when_taken(lambda: keys.done.append("done"))
    for look in range(1, looks + 1):
        await keys.app.go_on()
        assert (keys.done, len(keys.app.timers)) == ([], look)
        setattr(keys, what, look != 3 or looks != 3)
        await keys.app.timers[-1].ring()
    await keys.app.go_on()
    assert keys.done == ["done"]


async def test_a_stop_comes_at_once_and_all_else_in_its_turn(monkeypatch):
    keys = Keys(monkeypatch)
    keys.app.focused.call_later(keys.done.append, "letter")
    for name in ("run", "stop_all", "save", "stop"):
        keys.keyboard.act(name)
    assert keys.done == ["stop_all", "stop"]
    await keys.app.go_on()
    assert keys.done[2:] == ["letter", "run", "save"]


@pytest.mark.parametrize(
    ("has_focus", "value", "name", "done"),
    [
        (True, "FW 1", "run", "line"),
        (True, "  ", "run", "run"),
        (False, "FW 1", "run", "run"),
        (True, "FW 1", "step", "step"),
    ],
)
async def test_running_from_the_command_line_runs_what_is_typed_there(
    monkeypatch, has_focus, value, name, done
):
    keys = Keys(monkeypatch)
    keys.line.has_focus, keys.line.value = has_focus, value
    keys.keyboard.act(name)
    await keys.app.go_on()
    assert keys.done == [done]


@pytest.mark.parametrize(
    ("is_real", "has_gone", "pressed", "fed", "said"),
    [
        (False, False, ["escape"], ["escape"], 0),
        (False, True, ["escape"], [], 1),
        (False, True, ["escape", "escape"], ["escape"], 1),
        (False, True, ["x", "escape"], ["x", "escape"], 0),
        (True, False, ["escape"], [], 1),
        (True, False, ["escape", "escape"], ["escape"], 1),
        (True, False, ["escape", "x", "escape"], ["x"], 2),
        (True, False, ["x"], ["x"], 0),
    ],
)
async def test_esc_that_may_be_meant_for_what_has_gone_or_drives_a_real_robot_is_asked_for_again(
    monkeypatch, is_real, has_gone, pressed, fed, said
):
    keys = Keys(monkeypatch, is_real=is_real)
    if has_gone:
        keys.dialogs.note_gone()
    await keys.press(*pressed)
    assert (keys.fed, keys.said) == (fed, ["esc-again"] * said)


async def test_esc_is_not_asked_for_again_in_a_dialog_or_while_a_program_runs(monkeypatch):
    for change in ("screen", "runs"):
        keys = Keys(monkeypatch, is_real=True)
        if change == "screen":
            keys.app.screen = SimpleNamespace(call_later=keys.app.call_later)
        else:
            keys.session.runs = True
        await keys.press("escape")
        assert (keys.fed, keys.said) == (["escape"], [])


async def test_keys_wait_while_there_is_nothing_for_them_and_a_stop_does_not(monkeypatch):
    keys = Keys(monkeypatch)
    keys.must_wait = keys.session.runs = True
    await keys.press("a", "f8", "b", "backspace", "c", "enter", "ctrl+c")
    assert keys.fed == ["f8", "ctrl+c"]
    assert keys.keyboard.queue.held_text == "ac\n"
    keys.must_wait = False
    keys.keyboard.release()
    await keys.app.go_on()
    assert keys.fed[2:] == ["a", "b", "backspace", "c", "enter"]
    assert keys.keyboard.queue.held_text == ""


async def test_a_stop_gives_up_a_search_for_a_robot_and_does_nothing_more(monkeypatch):
    keys = Keys(monkeypatch)
    keys.session.give_up_search = lambda: True
    await keys.press("f8", "x")
    assert keys.fed == ["x"]


async def test_what_was_typed_and_not_taken_is_given_back(monkeypatch):
    keys = Keys(monkeypatch)
    keys.keyboard.queue.hold(events.Key("a", "a"), events.Paste("bc"))
    assert keys.keyboard.queue.held_text == "abc"
    assert [type(each) for each in keys.keyboard.queue.give_up()] == [events.Key, events.Paste]
    assert (keys.keyboard.queue.held_text, keys.keyboard.queue.give_up()) == ("", [])


async def test_esc_in_the_tour_closes_it_and_the_next_one_is_asked_for_again(monkeypatch):
    keys = Keys(monkeypatch)
    keys.place.tour = SimpleNamespace(has_focus=True)
    keys.place.close_tour = lambda: setattr(keys.place, "tour", None)
    await keys.press("escape")
    assert (keys.place.tour, keys.fed, keys.said) == (None, [], [])
    await keys.press("escape")
    assert (keys.fed, keys.said) == ([], ["esc-again"])


async def test_esc_is_asked_for_again_by_the_word_of_its_command_if_it_has_one(monkeypatch):
    keys, said = Keys(monkeypatch, is_real=True), []
    keys.session.say = lambda code, **values: said.append((code, values))
    await keys.press("escape")
    assert (keys.fed, said) == ([], [("esc-again", {"word": "RUN"})])

    keys.keyboard._key_table.choose("step escape")
    keys.dialogs.note_gone()
    await keys.press("x", "escape")
    assert said[1:] == [("esc-again", {"word": "STEP"})]
    keys = Keys(monkeypatch, is_real=True)  # in a browser LINEAR is not possible
    keys.keyboard._key_table = KeyTable("linear escape", has_terminal=False)
    keys.dialogs.note_gone()
    await keys.press("escape")
    assert (keys.fed, keys.said) == (["escape"], [])
    keys = Keys(monkeypatch)
    keys.dialogs.note_gone()
    keys.session.controller = None
    await keys.press("escape")
    assert (keys.fed, keys.said) == (["escape"], [])


@pytest.mark.parametrize(
    ("key", "has_focus", "in_front"),
    [("x", True, False), ("escape", False, False), ("escape", True, True)],
)
async def test_only_esc_in_the_tour_closes_it(monkeypatch, key, has_focus, in_front):
    keys = Keys(monkeypatch)
    keys.place.tour = SimpleNamespace(has_focus=has_focus)
    keys.place.close_tour = lambda: keys.done.append("closed")
    if in_front:
        keys.app.screen = SimpleNamespace(call_later=keys.app.call_later)
    await keys.press(key)
    assert (keys.done, keys.fed, keys.said) == ([], [key], [])


def test_keys_of_commands_come_before_those_of_widgets_but_tab_does_not():
    table = KeyTable("run f9, save ctrl+k z")
    bound = {
        key: [(each.action, each.priority) for each in found]
        for key, found in keyboard.bindings(table).key_to_bindings.items()
    }
    own = {
        "ctrl+k": [("key_menu", True)],
        "ctrl+p": [("command_palette", True)],
        "ctrl+c": [("do('stop_all', True)", True)],
        "tab": [("app.focus_next", False)],
        "shift+tab": [("app.focus_previous", False)],
    }
    commands = {"f9": "run", "f5": "run", "escape": "run", "f8": "stop", "ctrl+s": "save", "f2": "save"}

    assert {key: bound[key] for key in own} == own
    assert {key: bound[key] for key in commands} == {
        key: [(f"do('{name}')", True)] for key, name in commands.items()
    }
    assert not [key for key in bound if " " in key]
    names = [key for each in table.all.values() for key in each if " " not in key]
    assert len(bound) == len(own) + len(names)


@pytest.mark.parametrize(
    ("focused", "key", "submits"),
    [
        (Pump, "x", [False]),
        (Pump, "enter", [True]),
        (Pump, "left", [False]),
        (Input, "x", []),
        (Input, "space", []),
        (Input, "enter", [True]),
        (Input, "backspace", [False]),
        (TextArea, "x", []),
        (TextArea, "enter", [False]),
    ],
)
async def test_later_keys_wait_for_a_key_that_writes_no_letter(monkeypatch, focused, key, submits):
    """In a line Enter posts what was typed, and takes effect once that has come."""
    keys = Keys(monkeypatch)
    keys.app.focused, followed = focused(), []
    monkeypatch.setattr(keys.keyboard.queue, "follow", lambda *, submits: followed.append(submits))
    await keys.keyboard.on_event(events.Key(key, {"space": " "}.get(key, key if len(key) == 1 else None)))
    await keys.keyboard.on_event(events.Paste("text"))
    assert (keys.fed, followed) == ([key, "Paste"], submits)


@pytest.mark.parametrize(("submits", "rounds"), [(True, ROUNDS), (False, 0)])
async def test_a_key_that_submits_is_followed_through_all_queues_again(submits, rounds):
    app, passed = Application(), []
    app.turns._pass_on = lambda _pump, _command, rounds: passed.append(rounds)
    app.turns.follow(submits=submits)
    app.turns.follow(submits=submits)
    assert (passed, app.turns.is_holding) == ([rounds], True)


async def test_a_key_waits_for_the_command_before_it_whether_others_wait_or_not(monkeypatch):
    keys = Keys(monkeypatch)
    keys.keyboard.act("save")
    await keys.keyboard.on_event(events.Key("a", "a"))
    await keys.keyboard.on_event(events.Paste("bc"))
    assert (keys.fed, keys.keyboard.queue.held_text) == ([], "abc")
    await keys.app.go_on()
    assert (keys.done, keys.fed) == (["save"], ["a", "Paste"])


async def test_a_stop_is_a_key_like_others_while_nothing_runs_and_a_forwarded_one_always(monkeypatch):
    keys = Keys(monkeypatch)
    keys.must_wait = True
    await keys.press("f8", "ctrl+c")
    assert keys.fed == []
    keys.session.runs, keys.session.give_up_search = True, lambda: True
    for event in (events.Paste("f8"), forwarded := events.Key("f8", None)):
        event._forwarded = event is forwarded
        await keys.keyboard.on_event(event)
    assert keys.fed == ["f8"]


async def test_without_a_widget_with_the_focus_a_command_comes_through_the_queue_of_the_screen():
    app = Application()
    app.focused, app.screen = None, Pump(app)
    app.do("run")
    await app.screen.work(1)
    await app.work(1)
    assert (len(app.screen.queue), app.done) == (1, [])
    for _ in range(ROUNDS):
        await app.screen.work()
        await app.work()
    assert app.done == ["run"]


async def test_what_waited_long_enough_for_all_keys_comes_at_once_and_the_terminal_is_asked_for_more(
    monkeypatch,
):
    keys, asked = Keys(monkeypatch), []
    monkeypatch.setattr(keyboard, "has_unread", lambda number: asked.append(number))
    keys.keyboard.when_taken(lambda: keys.done.append("late"), 0)
    await keys.app.work(1)
    assert keys.done == ["late"]
    keys.keyboard.when_taken(lambda: None, TAKEN_LOOKS - 1)
    await keys.app.work(1)
    assert set(asked) == {0}, "the input"


# --- the keys after the menu key


class Menu:
    """The key menu of a keyboard, with what was closed and said."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, *, is_plain: bool = False) -> None:
        self.keys = keys = Keys(monkeypatch)
        self.left, self.said, self.shown = [], [], []
        keys.place.is_plain = is_plain
        keys.session.point = lambda _words: None
        keys.session.say = lambda code, **values: self.said.append((code, values))
        keys.app.push_screen = lambda menu, closed: self.shown.append((menu, closed))
        keys.keyboard.open_menu(Words("en"))
        self.menu, self.closed = self.shown[0]
        self.menu.leave = lambda: self.left.append("left")


def pressed(key: str) -> events.Key:
    return events.Key(key, {"exclamation_mark": "!"}.get(key, key if len(key) == 1 else None))


@pytest.mark.parametrize(
    ("key", "done", "said"),
    [
        ("i", ["where"], []),
        ("S", ["sensors"], []),
        ("exclamation_mark", ["errors"], []),
        ("f11", ["speed"], []),
        ("enter", ["whole_map"], []),
        ("4", [], ["Ctrl+K 4"]),
        ("G", [], ["Ctrl+K G"]),
        ("f9", [], ["Ctrl+K F9"]),
        ("ctrl+k", [], ["Ctrl+K Ctrl+K"]),
    ],
)
async def test_a_key_after_the_menu_key_runs_its_command_and_closes_the_menu(monkeypatch, key, done, said):
    """Enter runs the chosen row, which is the first one, Ctrl+K A."""
    it = Menu(monkeypatch)
    await it.keys.keyboard.on_event(pressed(key))
    assert (it.keys.done, it.left) == ([], ["left"]), "in its turn"
    await it.keys.app.go_on()
    assert (it.keys.done, it.said) == (done, [("menu-no-key", {"key": each}) for each in said])
    assert it.keys.fed == []
    it.closed(None)
    assert not it.keys.dialogs.forget_gone()
    await it.keys.press("i")
    assert (it.keys.fed, it.keys.done) == (["i"], done)


async def test_keys_that_read_the_menu_and_pastes_leave_it_open(monkeypatch):
    it = Menu(monkeypatch)
    reading = ["up", "down", "pageup", "pagedown", "home", "end", "escape"]
    await it.keys.press(*reading)
    await it.keys.keyboard.on_event(events.Paste("i"))
    await it.keys.app.go_on()
    assert (it.keys.fed, it.left, it.keys.done) == ([*reading, "Paste"], [], [])
    await it.keys.press("i")
    assert (it.left, it.keys.done) == (["left"], ["where"])


@pytest.mark.parametrize(("clicked", "done"), [(None, []), ("save", ["save"]), ("run", ["line"])])
async def test_a_menu_that_is_left_without_a_key_may_have_been_left_by_esc(monkeypatch, clicked, done):
    it = Menu(monkeypatch)
    it.keys.line.has_focus, it.keys.line.value = True, "FW 1"
    it.closed(clicked)
    await it.keys.app.go_on()
    assert (it.keys.done, it.left) == (done, [])
    assert it.keys.dialogs.forget_gone()
    await it.keys.press("i")
    assert it.keys.fed == ["i"]


async def test_a_menu_is_plain_in_the_plain_layout_and_says_nothing_without_a_session(monkeypatch):
    it = Menu(monkeypatch)
    assert not it.menu.has_class("-plain")
    it.keys.session.controller = None
    await it.keys.press("4")
    assert (it.said, it.left) == ([], ["left"])
    assert Menu(monkeypatch, is_plain=True).menu.has_class("-plain")


async def test_keys_wait_from_a_command_that_asks_until_its_dialog_is_there_and_until_it_is_done(monkeypatch):
    keys, released = Keys(monkeypatch), []
    dialogs = Dialogs(keys.app, keys.place, lambda: released.append("released"))
    assert not dialogs.holds_keys
    asking = dialogs.begin()
    assert (dialogs.holds_keys, len(keys.app.timers)) == (True, 1)
    dialogs.done(object())  # of an earlier command
    assert (dialogs.holds_keys, released) == (True, [])

    dialog = Pump(keys.app)
    with dialogs.checking(dialog):
        keys.app.screen = dialog
        assert dialogs.holds_keys
    assert (dialogs.holds_keys, released) == (False, ["released"])
    keys.app.screen = keys.place
    assert dialogs.holds_keys
    stopped = []
    keys.app.timers[-1].stop = lambda: stopped.append("stopped")
    dialogs.done(asking)
    assert (dialogs.holds_keys, released, stopped) == (False, ["released"] * 2, ["stopped"])


async def test_keys_wait_no_longer_than_a_moment_for_a_command_that_asks(monkeypatch):
    keys, released = Keys(monkeypatch), []
    dialogs = Dialogs(keys.app, keys.place, lambda: released.append("released"))
    dialogs.begin()
    stopped = []
    keys.app.timers[-1].stop = lambda: stopped.append("first")
    dialogs.begin()
    assert (stopped, len(keys.app.timers)) == (["first"], 2)
    await keys.app.timers[-1].ring()
    assert (dialogs.holds_keys, released) == (False, ["released"])


async def test_a_page_holds_keys_until_its_queue_is_empty_and_the_next_esc_may_be_meant_for_it(monkeypatch):
    keys, released = Keys(monkeypatch), []
    dialogs = Dialogs(keys.app, keys.place, lambda: released.append("released"))
    page, closed = Pump(keys.app), []
    keys.app.push_screen = lambda screen, callback: closed.append(callback)
    dialogs.open(page)
    keys.app.screen = page
    assert dialogs.holds_keys
    await page.work()
    assert (dialogs.holds_keys, released, dialogs.forget_gone()) == (False, ["released"], False)
    closed[0](None)
    assert dialogs.forget_gone()
    assert not dialogs.forget_gone()


async def test_a_dialog_that_is_given_up_goes_and_is_noted(monkeypatch):
    class Asked(Pump):
        def pop_until_active(self) -> None:
            left.append("popped")

        def dismiss(self) -> None:
            left.append("dismissed")

    async def given_up(_screen: Pump) -> None:
        raise asyncio.CancelledError

    async def answered(_screen: Pump) -> str:
        return "yes"

    keys, left, released = Keys(monkeypatch), [], []
    dialogs = Dialogs(keys.app, keys.place, lambda: released.append("released"))
    asked = Asked(keys.app)
    keys.app.screen_stack = [keys.place, asked]
    keys.app.push_screen_wait = given_up
    with pytest.raises(asyncio.CancelledError):
        await dialogs.answer_of(asked)
    assert (left, released, dialogs.forget_gone()) == (["popped", "dismissed"], ["released"], True)

    keys.app.screen_stack, keys.app.push_screen_wait = [keys.place], answered
    dialogs.begin()
    timers = len(keys.app.timers)
    assert await dialogs.answer_of(asked) == "yes"
    assert (left[2:], dialogs.forget_gone(), len(keys.app.timers)) == ([], True, timers + 1)
    keys.app.push_screen_wait = given_up
    with pytest.raises(asyncio.CancelledError):
        await dialogs.answer_of(asked)
    assert left[2:] == []


async def test_the_mouse_and_forwarded_keys_are_no_keys(monkeypatch):
    keys, acted = Keys(monkeypatch), []
    keys.session.controller.display.acted = lambda: acted.append("acted")
    keys.must_wait = True
    mouse = events.MouseDown(None, 0, 0, 0, 0, 1, False, False, False)
    forwarded = events.Key("a", "a")
    forwarded._forwarded = True
    for event in (mouse, forwarded, events.Focus()):
        await keys.keyboard.on_event(event)
    assert (keys.fed, acted, keys.keyboard.queue.held_text) == (["MouseDown", "a", "Focus"], ["acted"], "")
    keys.session.controller = None
    for event in (mouse, events.Key("b", "b")):
        await keys.keyboard.on_event(event)
    assert (keys.fed[3:], acted, keys.keyboard.queue.held_text) == (["MouseDown"], ["acted"], "b")


def test_the_screen_is_polled_soon_and_then_more_and_more_seldom():
    polls, timers = [], []

    def later(seconds: float, poll: Callable[[], None]) -> SimpleNamespace:
        timers.append((seconds, poll))
        return SimpleNamespace(stop=lambda: polls.append("stopped"))

    polling = Polling(lambda: polls.append("look"), later)
    polling.on_event()
    polling.end()
    assert (polling.is_on, timers, polls) == (False, [], [])
    polling.begin()
    polling.begin()
    polling.on_event()
    assert (polling.is_on, [each for each, _ in timers]) == (True, [0.2])
    for _ in range(4):
        timers[-1][1]()
    assert ([each for each, _ in timers], polls) == ([0.2, 0.4, 0.8, 1.0, 1.0], ["look"] * 4)
    polling.on_event()
    assert (timers[-1][0], polls[4:]) == (0.2, ["stopped"])
    polling.end()
    assert (polling.is_on, polls[5:]) == (False, ["stopped"])
