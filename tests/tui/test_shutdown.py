"""The thread that waits for signals and watches the output, without a screen."""

import asyncio
import signal
import termios
import threading
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from queue import Queue
from types import SimpleNamespace
from typing import Any

import pytest

from donnie_tui.tui import shutdown
from donnie_tui.tui.shutdown import ScreenWatchdog, Shutdown
from tests.timeouts import TIMEOUT


class Recorder:
    """Records its calls, and fails each time if it has to."""

    def __init__(self, failing: bool = False, times: int = 1) -> None:
        self.all: list[int] = []
        self.enough = threading.Event()
        self._failing, self._times = failing, times

    def __call__(self, number: int = 0) -> None:
        self.all.append(number)
        if len(self.all) == self._times:
            self.enough.set()
        if self._failing:
            raise RuntimeError("it was meant to fail")


def made(
    *,
    halt: Callable[[], object] = lambda: None,
    before_rest: Callable[[], object] = lambda: None,
    notify: Callable[[int], object] = lambda number: None,
    on_stuck: Callable[[], object] = lambda: None,
    part: Callable[[int], object] = lambda number: None,
    writer: Callable[[], Any] = lambda: None,
) -> ScreenWatchdog:
    return ScreenWatchdog(
        halt=halt, before_rest=before_rest, notify=notify, on_stuck=on_stuck, part=part, writer=writer
    )


@pytest.mark.parametrize("failing", [False, True])
def test_stuck_output_is_reported_repeatedly(monkeypatch, failing):
    """A key may have started a robot since the first report, or the first report may have failed."""
    monkeypatch.setattr(shutdown, "LOOK", 0.001)
    stuck, waiting = Recorder(failing, times=2), Queue[str]()
    waiting.put("what the terminal does not take")
    line = made(on_stuck=stuck, writer=lambda: SimpleNamespace(_queue=waiting, is_alive=lambda: True))
    line.begin()
    try:
        assert stuck.enough.wait(TIMEOUT)
    finally:
        line.end()


@pytest.mark.parametrize("failing", ["halt", "notify", "part"])
def test_a_signal_ends_the_process_whatever_fails(monkeypatch, failing):
    monkeypatch.setattr(shutdown, "LOOK", 0.001)
    monkeypatch.setattr(shutdown, "LEAVE", 0.01)
    halt, notify, part = (
        Recorder(failing == "halt"),
        Recorder(failing == "notify"),
        Recorder(failing == "part", times=2),
    )
    line = made(halt=halt, notify=notify, part=part)
    line.begin()
    try:
        signal.raise_signal(signal.SIGTERM)
        assert part.enough.wait(TIMEOUT)
    finally:
        line.end()

    assert halt.all == [0]
    assert notify.all == [signal.SIGTERM]
    assert set(part.all) == {signal.SIGTERM}


def test_the_robot_is_halted_where_the_screen_can_not_be_notified(monkeypatch):
    monkeypatch.setattr(shutdown, "ANSWER", 0.0)
    halt = Recorder(times=2)
    line = made(halt=halt, notify=Recorder(failing=True))
    line.begin()
    try:
        signal.raise_signal(signal.SIGINT)
        signal.raise_signal(signal.SIGINT)
        assert halt.enough.wait(TIMEOUT)
    finally:
        line.end()


@pytest.fixture
def rested(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[str]]:
    """A suspension is recorded here instead."""
    order = list[str]()
    monkeypatch.setattr(shutdown, "can_suspend", lambda: True)
    found = signal.signal(signal.SIGTSTP, lambda *_: order.append("rest"))
    found_back = signal.signal(signal.SIGCONT, lambda *_: order.append("back"))
    yield order
    signal.signal(signal.SIGTSTP, found)
    signal.signal(signal.SIGCONT, found_back)


def test_control_z_stops_the_robot_at_once_and_suspends_the_process_in_the_screen_s_turn(rested):
    """The handler may have interrupted the main thread while it held a lock of the output."""
    passed = Recorder()
    line = made(before_rest=lambda: rested.append("stop"), notify=passed)
    line.begin()
    try:
        signal.raise_signal(signal.SIGTSTP)
        assert (rested, passed.all) == (["stop"], [signal.SIGTSTP])
        assert line.rest()
        assert rested == ["stop", "stop", "rest", "back"]
        line.back()
        assert rested.count("back") == 1, "the signal that ended the suspension"
        signal.raise_signal(signal.SIGCONT)
        assert rested.count("back") == 1
        line.back()
        assert rested.count("back") == 2, "the process was suspended in another way"
    finally:
        line.end()


def test_control_z_without_a_shell_above_stops_no_robot_and_is_passed_to_the_screen(monkeypatch, rested):
    monkeypatch.setattr(shutdown, "can_suspend", lambda: False)
    passed = Recorder()
    line = made(before_rest=lambda: rested.append("stop"), notify=passed)
    line.begin()
    try:
        signal.raise_signal(signal.SIGTSTP)
        assert not line.rest()
    finally:
        line.end()

    assert (rested, passed.all) == ([], [signal.SIGTSTP])


def test_control_z_suspends_although_the_main_thread_holds_the_lock_of_the_stop(monkeypatch, rested):
    """The handler interrupts the main thread anywhere."""
    monkeypatch.setattr(shutdown, "LONGEST_REST", 0.01)
    held, stopped = threading.Lock(), threading.Event()

    def stop() -> None:
        with held:
            stopped.set()

    line = made(before_rest=stop)
    line.begin()
    try:
        with held:
            signal.raise_signal(signal.SIGTSTP)
        assert stopped.wait(TIMEOUT)
        with held:
            assert line.rest()
    finally:
        line.end()

    assert rested == ["rest", "back"]


# --- the session


def closing(left) -> tuple[list[str], Shutdown]:
    """A shutdown whose watchdog was left so, and what is done then."""
    done: list[str] = []
    session = SimpleNamespace(
        close=lambda: done.append("close"), stop_real_robot=lambda: True, keep_text=lambda: None
    )
    it = Shutdown(
        SimpleNamespace(_driver=None), session, Path(), stop_all=int, repaint=int, after_keys=lambda it: it()
    )
    it._watchdog = SimpleNamespace(left=left, end=lambda: done.append("end"))
    return done, it


class Watched:
    """In place of the watchdog of the end."""

    def __init__(self, done: list[str], *_given, **_named) -> None:
        self._done = done

    def __enter__(self) -> "Watched":
        self._done.append("watched")
        return self

    def leave(self, *given: object) -> None:
        self._done.append(f"leave {given}")

    def __exit__(self, *_given: object) -> None:
        self._done.append("over")


@pytest.mark.parametrize(
    ("left", "expected"),
    [(None, ["close"]), ((15, 1.5), ["watched", "leave (15, 1.5)", "close", "over"])],
    ids=["quit", "signal"],
)
def test_the_session_is_closed_and_after_a_signal_in_time(monkeypatch, left, expected):
    done, it = closing(left)
    monkeypatch.setattr(shutdown, "Watchdog", partial(Watched, done))
    it.close_session()
    assert done == expected


def test_a_screen_that_never_began_to_watch_closes_its_session():
    done, it = closing(None)
    it._watchdog = None
    it.end_watchdog()
    it.close_session()
    assert done == ["close"]


def test_the_readers_of_a_page_are_no_longer_watched_at_the_end():
    done, it = closing(None)
    it._readers = SimpleNamespace(close=lambda: done.append("readers"))
    it.end_watchdog()
    assert done == ["readers", "end"]


def test_at_the_end_the_thread_that_reads_keys_ends_too():
    _done, it = closing(None)
    it._app._driver = SimpleNamespace(exit_event=threading.Event())
    it.end_watchdog()
    assert it._app._driver.exit_event.is_set()


class Ending:
    """In place of the end of the process: its tasks, and the code with which it would end."""

    def __init__(self, monkeypatch):
        self.did = []
        monkeypatch.setattr(shutdown, "end_process", self._end)
        monkeypatch.setattr(shutdown, "give_back", lambda driver: self.did.append(f"given back: {driver}"))
        session = SimpleNamespace(
            keep_text=lambda: self.did.append("keep"),
            close=lambda: self.did.append("close"),
            stop_real_robot=lambda: self.did.append("stop"),
        )
        self.shutdown = Shutdown(
            SimpleNamespace(_driver="driver"), session, Path(), stop_all=int, repaint=int, after_keys=int
        )

    def _end(self, code, tasks):
        for each in tasks:
            each()
        self.did.append(code())


def test_a_screen_that_does_not_leave_ends_with_its_text_kept_and_the_terminal_given_back(monkeypatch):
    it = Ending(monkeypatch)
    it.shutdown._part(signal.SIGTERM)
    assert it.did == ["stop", "keep", "close", "given back: driver", 143]


def test_a_session_that_does_not_end_stops_its_robot_and_ends(monkeypatch):
    it = Ending(monkeypatch)
    it.shutdown._part_from_session(signal.SIGTERM)
    assert it.did == ["stop", 143]


class Begun:
    """A shutdown that has begun, with what it gave to its watchdog."""

    def __init__(self, monkeypatch, *, is_main_thread=True, is_page=False):
        self.given, self.did, self.is_driving = {}, [], False
        monkeypatch.setattr(shutdown, "ScreenWatchdog", self._watchdog)
        monkeypatch.setattr(shutdown, "ReaderWatch", lambda: "readers")
        monkeypatch.setattr(shutdown, "is_page", lambda: is_page)
        self.is_main_thread = is_main_thread
        session = SimpleNamespace(
            halt="halt", stop_real_robot=lambda: self.is_driving, say=self.did.append, left=None
        )
        self.app = SimpleNamespace(_driver=None)
        self.shutdown = Shutdown(
            self.app,
            session,
            Path(),
            stop_all=int,
            repaint=lambda: self.did.append("repaint"),
            after_keys=int,
        )
        self.shutdown.begin()

    def _watchdog(self, **given):
        self.given = given
        return SimpleNamespace(begin=self._begin, back=lambda: None, left=(15, 1.5))

    def _begin(self):
        if not self.is_main_thread:
            raise ValueError


async def test_the_watchdog_notifies_the_screen_in_its_own_thread(monkeypatch):
    it = Begun(monkeypatch)
    assert (it.shutdown.left, it.shutdown._readers) == ((15, 1.5), None)
    assert it.given["halt"] == "halt"
    assert it.given["part"] == it.shutdown._part
    it.given["notify"](signal.SIGCONT)
    assert it.did == []
    await asyncio.sleep(0)
    assert it.did == ["repaint"]


async def test_a_stuck_terminal_is_mentioned_if_that_stopped_a_robot(monkeypatch):
    it = Begun(monkeypatch)
    for it.is_driving, said in ((False, []), (True, ["stuck-stopped"])):
        assert it.given["before_rest"]() is it.is_driving
        it.given["on_stuck"]()
        await asyncio.sleep(0)
        assert it.did == said


async def test_the_thread_that_writes_is_that_of_the_driver_of_now(monkeypatch):
    it = Begun(monkeypatch)
    assert it.given["writer"]() is None
    it.app._driver = SimpleNamespace(_writer_thread="thread")
    assert it.given["writer"]() == "thread"


async def test_a_page_watches_its_readers_too(monkeypatch):
    assert Begun(monkeypatch, is_page=True).shutdown._readers == "readers"


async def test_outside_of_the_main_thread_nothing_is_watched(monkeypatch):
    it = Begun(monkeypatch, is_main_thread=False, is_page=True)
    assert (it.shutdown.left, it.shutdown._readers) == (None, None)


def test_a_signal_after_the_end_of_the_loop_is_ignored(monkeypatch):
    async def begin():
        return Begun(monkeypatch)

    asyncio.run(begin()).given["notify"](signal.SIGCONT)


# --- what a signal does in the screen's thread


class Screen:
    """Records what is asked of the session and the screen, in order."""

    def __init__(self, folder=Path(), *, is_searching=False, runs=True, failing=()):
        self.done = []
        session = SimpleNamespace(
            is_leaving=False,
            runs=runs,
            halt=lambda: self._do("halt", failing),
            keep_text=lambda: self._do("keep", failing),
            give_up_search=lambda: is_searching,
            say=lambda code: self.done.append(f"say {code}"),
        )
        self.session = session
        self.keys = []
        self.shutdown = Shutdown(
            SimpleNamespace(exit=lambda code: self.done.append(f"exit {code}")),
            session,
            folder,
            stop_all=lambda: self.done.append("stop all"),
            repaint=lambda: self.done.append("repaint"),
            after_keys=self.keys.append,
        )

    def _do(self, name, failing):
        self.done.append(name)
        if name in failing:
            raise RuntimeError(name)


@pytest.mark.parametrize(
    ("number", "screen", "done"),
    [
        (signal.SIGINT, {}, ["stop all"]),
        (signal.SIGINT, {"is_searching": True}, []),
        (signal.SIGINT, {"runs": False}, []),
        (signal.SIGCONT, {}, ["repaint"]),
        (signal.SIGTSTP, {}, ["say suspend-impossible"]),
        (0, {}, ["say stuck-stopped"]),
    ],
)
@pytest.mark.parametrize("is_watched", [True, False])
def test_each_signal_has_its_effect_on_the_screen(number, screen, done, is_watched):
    """An interrupt gives up a search, else it stops the programs; then the watchdog halts no robot."""
    it, answered = Screen(**screen), threading.Event()
    if is_watched:
        it.shutdown._watchdog = SimpleNamespace(
            answered=answered, left=None, rest=lambda: False, back=lambda: None
        )
    it.shutdown._signalled(number)

    assert it.done == done
    assert answered.is_set() is (is_watched and number == signal.SIGINT)
    assert not it.session.is_leaving


def test_a_signal_that_ends_halts_keeps_the_text_and_leaves_after_the_typed_keys():
    it = Screen()
    it.shutdown._signalled(signal.SIGTERM)
    assert (it.done, it.session.is_leaving) == (["halt", "keep"], True)

    (leave,) = it.keys
    leave()
    assert it.done == ["halt", "keep", "keep", "exit 143"]  # 128 and the number of SIGTERM


def test_a_fault_halts_the_robots_keeps_the_text_and_is_written_down(tmp_path):
    """Whatever of this fails."""
    for failing in ((), ("halt",), ("halt", "keep")):
        folder = tmp_path / "-".join(failing) / "copies"
        folder.parent.mkdir(exist_ok=True)
        it = Screen(folder, failing=failing)
        try:
            raise LookupError("the fault")
        except LookupError:
            it.shutdown.save_from_fault()
        assert it.done == ["halt", "keep"]
        assert "LookupError: the fault" in (folder / "fault.txt").read_text()

    (tmp_path / "file").touch()
    it = Screen(tmp_path / "file")
    it.shutdown.save_from_fault()  # there is no place for it
    assert it.done == ["halt", "keep"]


@pytest.mark.parametrize("is_there", [True, False])
@pytest.mark.parametrize("problem", [None, OSError(5, "gone")])
def test_the_terminal_is_given_back_as_far_as_it_takes_it(monkeypatch, is_there, problem):
    """The learner's shell gets its own mode, screen and cursor, and standard error waits again."""
    did = []

    def write(number, text):
        did.append((number, text))
        if problem:
            raise problem

    monkeypatch.setattr("termios.tcsetattr", lambda *given: did.append(given))
    monkeypatch.setattr(shutdown.os, "set_blocking", lambda *given: did.append(given))
    monkeypatch.setattr(shutdown.os, "write", write)
    shutdown.give_back(SimpleNamespace(fileno=7, attrs_before=["before"]) if is_there else None)
    monkeypatch.undo()

    assert did[: len(did) - 3] == ([(7, termios.TCSANOW, ["before"])] if is_there else [])
    assert [each for each in did[-3:] if each[0] == 2] == did[-3:]
    assert (did[-3][1], did[-1][1]) == (False, True)
    assert did[-2][1].startswith(b"\x1b[?1049l\x1b[?25h")


# --- what the watchdog sees of the output


class Watch:
    """A watchdog that looks on request, and what it did."""

    def __init__(self, monkeypatch, *, is_alive=True):
        self.did = []
        self.waiting, self.is_hung_up, self.is_alive = Queue(), False, is_alive
        monkeypatch.setattr(shutdown, "is_hung_up", lambda number: self.is_hung_up and number == 0)
        self.writer = SimpleNamespace(_queue=self.waiting, is_alive=lambda: self.is_alive)
        self.dog = made(
            notify=lambda number: self.did.append(("notify", number)),
            on_stuck=lambda: self.did.append("stuck"),
            writer=lambda: self.writer,
        )
        monkeypatch.setattr(self.dog, "leave", lambda number: self.did.append(("leave", number)))

    def look(self, times):
        for _ in range(times):
            self.dog._look_at_terminal()


def test_the_same_piece_of_output_at_five_more_looks_is_stuck_and_then_at_every_fifth(monkeypatch):
    it = Watch(monkeypatch)
    it.look(20)
    assert it.did == []  # nothing to write

    it.waiting.put("one")
    it.waiting.put("two")
    it.look(5)
    assert it.did == []
    it.look(1)
    assert it.did == ["stuck"]
    it.look(4)
    assert it.did == ["stuck"]
    it.look(1)
    assert it.did == ["stuck", "stuck"]

    it.waiting.get()  # it was written: the next piece has its own time
    it.look(5)
    assert it.did == ["stuck", "stuck"]
    it.look(1)
    assert it.did == ["stuck"] * 3
    it.writer = None  # the screen has none yet, or no more
    it.look(6)
    assert it.did == ["stuck"] * 3


def test_a_terminal_that_is_gone_ends_donnie_once(monkeypatch):
    for dead in (False, True):
        it = Watch(monkeypatch, is_alive=not dead)
        it.is_hung_up = not dead
        if dead:
            it.waiting.put("what no thread writes any more")
            it.look(5)
            assert it.did == []
        it.look(2)

        leaves = [each for each in it.did if each != "stuck"]
        assert leaves[:2] == [("leave", signal.SIGHUP), ("notify", signal.SIGHUP)]
        assert ("notify", signal.SIGHUP) not in leaves[2:]  # the screen leaves already
        it.dog._act_on(signal.SIGTERM)
        assert ("notify", signal.SIGTERM) not in it.did


@pytest.mark.parametrize("is_answered", [True, False])
def test_the_watchdog_halts_the_robot_where_the_screen_does_not_answer(monkeypatch, is_answered):
    monkeypatch.setattr(shutdown, "ANSWER", 0.0)
    dog, did = made(halt=lambda: None), []
    monkeypatch.setattr(dog, "deputy", SimpleNamespace(do=did.append), raising=False)  # of ``begin``
    dog._notify = lambda _number: dog.answered.set() if is_answered else None
    dog.answered.set()  # of an interrupt before
    dog._act_on(signal.SIGINT)

    assert did == ([] if is_answered else [dog._halt])
