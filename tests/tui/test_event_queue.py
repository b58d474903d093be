"""What happens in a program's thread waits in a mailbox for the screen, which is woken once."""

import threading
from collections import deque
from types import SimpleNamespace

import pytest
from msgspec.structs import replace

from devices.ports.robot import Bearing, Pose, StoppedBy
from donnie_tui.commands.settings import change
from donnie_tui.core.events import (
    Announced,
    Answered,
    BeltShown,
    Driven,
    Error,
    HowStarted,
    Moved,
    Outcome,
    Passing,
    Pointed,
    Read,
    Reset,
    RunEnded,
    RunStarted,
    Scanned,
    Sensed,
    Spoke,
    Stamped,
    ThingsMoved,
    Turned,
)
from donnie_tui.i18n.words import Words
from donnie_tui.tui import event_queue
from donnie_tui.tui.event_queue import (
    CALM,
    FRAME,
    MOST_LINES,
    MOST_LOOKS,
    MOST_MEASURED,
    MOST_POSES,
    EventBatch,
    EventQueue,
    EventReader,
    EventsQueued,
    LogLine,
    RunBegan,
    RunFinished,
)

HERE = Pose(0.0, 0.0, 0.0)


def queue() -> tuple[EventQueue, list]:
    posted: list = []
    return EventQueue(posted.append, Words(), lambda: HERE), posted


def publish(listener: EventQueue, *events) -> None:
    for number, event in enumerate(events, 1):
        listener(Stamped(number, 0.0, event))


def test_the_stop_of_one_robot_is_not_the_reason_in_the_line_of_another():
    posted: list = []
    listener = EventQueue(posted.append, Words(), lambda: HERE, lambda: "alice")
    for robot, reason in (("alice", StoppedBy.OBSTACLE), ("bob", None)):
        listener(Stamped(1, 0.0, Moved("FW", 5, 2, reason, HERE, forward=True), robot))
    for robot in ("bob", "alice"):
        listener(Stamped(2, 0.0, Announced("moved", "I walked 2 steps."), robot))

    assert [(each.text, each.kind) for each in listener.take().lines] == [
        ("bob: I walked 2 steps.", "moved"),
        ("alice: I walked 2 steps.", "obstacle"),
    ]


def test_lines_wait_in_the_mailbox_and_the_screen_is_woken_once():
    listener, posted = queue()
    publish(listener, Spoke("one"), Spoke("two\nthree"), Answered("four"))

    assert [type(each) for each in posted] == [EventsQueued]
    assert [line.text for line in listener.take().lines] == ["one", "two", "three", "four"]
    assert not listener.take().lines


def test_after_a_look_the_screen_is_woken_again():
    listener, posted = queue()
    publish(listener, Spoke("one"))
    listener.take()
    publish(listener, Spoke("two"))

    assert len(posted) == 2


def test_an_interrupted_movement_is_reported_with_its_reason():
    listener, _ = queue()
    publish(
        listener,
        Moved("FW 3", 3, 1, StoppedBy.OBSTACLE, HERE, True),
        Announced("moved", "I walked only 1 step."),
        Moved("FW 3", 3, 3, None, HERE, True),
        Announced("moved", "I walked 3 steps."),
    )

    assert [line.kind for line in listener.take().lines] == ["obstacle", "moved"]


def test_a_program_that_talks_without_end_costs_no_memory_and_what_is_lost_is_counted():
    listener, posted = queue()
    for _ in range(MOST_LINES + 500):
        publish(listener, Spoke("again"))
    mail = listener.take()

    assert len(mail.lines) == MOST_LINES
    assert mail.missed == 500
    assert len(posted) == 1


def test_poses_come_from_every_thread_and_wake_the_screen_once():
    listener, posted = queue()
    threads = [
        threading.Thread(target=publish, args=(listener, *[Passing(Pose(i, 0, 0)) for i in range(200)]))
        for _ in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()

    assert len(posted) == 1
    assert len(listener.take().poses) == 800


def test_unchanged_distances_do_not_wake_the_screen():
    listener, posted = queue()
    publish(listener, Sensed({Bearing.FRONT: 4}))
    assert listener.take().distances == {Bearing.FRONT: 4}

    publish(listener, Sensed({Bearing.FRONT: 4}))
    assert (listener.take(), len(posted)) == (EventBatch(), 1)

    publish(listener, Sensed({Bearing.FRONT: 3}))
    assert (listener.take().distances, len(posted)) == ({Bearing.FRONT: 3}, 2)


def test_events_of_a_run_wait_until_its_beginning_is_shown():
    """Else the way that the robot went would be wiped away with the last one's."""
    listener, posted = queue()
    publish(listener, Answered("Saved."), RunStarted("p", "w", "d", 0, "0"), Passing(HERE))
    assert listener.take() == EventBatch()

    listener.begun()
    mail = listener.take()

    assert [type(each) for each in posted] == [EventsQueued, RunBegan]
    assert ([*mail.poses], [each.text for each in mail.lines]) == ([HERE], ["Saved."])


def test_the_end_of_a_run_brings_its_mistakes():
    listener, posted = queue()
    mistake = Error("syntax", 2, 5, "What?", None)
    publish(listener, RunStarted("p", "w", "d", 0, "0"), mistake, RunEnded(Outcome.FAILED, HERE, {}, 0.0))

    assert isinstance(posted[0], RunBegan)
    assert isinstance(posted[-1], RunFinished)
    assert posted[-1].errors == (mistake,)
    publish(listener, RunEnded(Outcome.COMPLETED, HERE, {}, 0.0))
    assert posted[-1].errors == (), "each has its own"
    listener.begun()
    assert listener.take().lines[0] == LogLine("Error, line 2, column 5: What?", "error")


def test_the_end_of_another_robots_run_names_that_robot_and_has_no_mistakes_of_this_one():
    """A challenge is judged once all of its robots are done."""
    posted: list = []
    listener = EventQueue(posted.append, Words(), lambda: HERE, lambda: "alice")
    mistake = Error("syntax", 2, 5, "What?", None)
    listener(Stamped(1, 0.0, mistake, "alice"))
    for robot in ("bob", "alice"):
        listener(Stamped(1, 0.0, RunEnded(Outcome.COMPLETED, Pose(1.0, 0.0, 0.0), {}, 0.0), robot))

    ended = [each for each in posted if isinstance(each, RunFinished)]
    assert [(each.robot, each.errors) for each in ended] == [("bob", ()), ("alice", (mistake,))]
    assert [type(each) for each in posted] == [EventsQueued, RunFinished, RunFinished]
    listener.take()
    listener(Stamped(2, 0.0, RunEnded(Outcome.COMPLETED, HERE, {}, 0.0), "bob"))
    assert [type(each) for each in posted[3:]] == [RunFinished, EventsQueued], "the map shows its place"
    assert listener.take().others == {"bob": HERE}


def test_of_very_many_mistakes_readings_rays_and_places_the_newest_are_kept():
    listener, posted = queue()
    mistakes = [Error("syntax", line, 1, "What?", None) for line in range(1, 102)]
    publish(listener, *mistakes, RunEnded(Outcome.FAILED, HERE, {}, 0.0))
    assert posted[-1].errors == tuple(mistakes[1:])
    reads = [Read("distance", "front", each) for each in range(MOST_MEASURED + 1)]
    publish(listener, *(Passing(Pose(each, 0, 0)) for each in range(MOST_POSES + 1)), *reads)
    taken = listener.take()
    assert taken.measured == deque(reads[1:])
    assert taken.looks == deque(reads[-MOST_LOOKS:])
    assert [taken.poses[0].x, len(taken.poses)] == [1, MOST_POSES]


def test_readings_are_kept_by_their_sensor_and_rays_until_the_robot_moves():
    """Each time once: what was taken is not there again."""
    listener, posted = queue()
    front, left, later = (
        Read("distance", argument, steps) for argument, steps in (("F", 4), ("FL", 9), ("F", 3))
    )
    scan = Scanned(())
    publish(listener, front, left, scan, later)
    taken = listener.take()
    assert [*taken.readings.values()] == [later, left]
    assert taken.measured == deque([front, left, later])
    assert taken.looks == deque([front, left, scan, later])
    assert listener.take() == EventBatch()
    assert len(posted) == 1

    publish(listener, front, Moved("FW 1", 1, 1, None, HERE, True), left)
    taken = listener.take()
    assert [[*each] for each in (taken.looks, taken.readings.values(), taken.poses)] == [
        [left], [front, left], [HERE]
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("event", "field", "value"),
    [
        (Spoke("a"), "lines", deque([LogLine("a", "spoke")])),
        (Announced("found", "A ball."), "lines", deque([LogLine("A ball.", "found")])),
        (Answered("a"), "lines", deque([LogLine("a", "answer")])),
        (Announced("moved", "I walked."), "lines", deque([LogLine("I walked.", "moved")])),
        (Answered("a", is_repeated=True), "lines", deque([LogLine("a", "answer", is_repeated=True)])),
        (Passing(HERE), "poses", deque([HERE])),
        (Driven("forward", HERE), "poses", deque([HERE])),
        (Turned("TR 90", 90, 90, None, HERE, True), "poses", deque([HERE])),
        (Scanned(()), "looks", deque([Scanned(())])),
        (ThingsMoved(()), "things", ()),
        (Sensed({Bearing.FRONT: 4}), "distances", {Bearing.FRONT: 4}),
    ],
    ids=lambda each: type(each).__name__,
)
def test_each_kind_of_event_wakes_the_screen_and_is_taken_once(event, field, value):
    listener, posted = queue()
    publish(listener, event)

    assert [type(each) for each in posted] == [EventsQueued]
    taken = listener.take()
    assert taken == EventBatch(**{field: value})
    assert listener.take() == EventBatch()


def test_levels_of_the_belt_are_shown_with_what_comes_next_and_a_pointer_is_nothing():
    listener, posted = queue()
    publish(listener, BeltShown((3,) * 14), Pointed("A red ball."))
    assert posted == []
    publish(listener, Passing(HERE))

    assert (len(posted), listener.take().belt, listener.take().belt) == (1, (3,) * 14, None)


@pytest.mark.parametrize(
    "event",
    [
        Passing(HERE),
        Moved("FW 1", 1, 1, None, HERE, True),
        Turned("TR 90", 90, 90, None, HERE, True),
        Driven("forward", HERE),
        Reset(HERE),
    ],
    ids=lambda each: type(each).__name__,
)
def test_another_robot_is_shown_at_its_place(event):
    posted: list = []
    listener = EventQueue(posted.append, Words(), lambda: HERE, lambda: "alice")
    listener(Stamped(1, 0.0, event, "bob"))
    taken = listener.take()

    assert (taken.others, [*taken.poses], len(posted)) == ({"bob": HERE}, [], 1)
    assert listener.take() == EventBatch()
    listener(Stamped(2, 0.0, ThingsMoved(()), "bob"))
    assert listener.take().things == ()


HOW = HowStarted("FW 1", 1, True, False, False, HERE)


@pytest.mark.parametrize(("how", "fresh"), [(None, False), (HOW, True), (replace(HOW, fresh=False), False)])
def test_only_the_run_of_the_current_robot_begins_on_the_screen(how, fresh):
    posted: list = []
    listener = EventQueue(posted.append, Words(), lambda: HERE, lambda: "alice")
    for robot in ("bob", "alice"):
        listener(Stamped(1, 0.0, RunStarted("a.gd", "w", "d", 0, "0", how=how), robot))

    assert [(each.pose, each.fresh) for each in posted] == [(HERE, fresh)]


@pytest.mark.parametrize("outcome", [Outcome.QUIT, Outcome.COMPLETED])
def test_only_a_run_that_reached_quit_asks_to_quit(outcome):
    assert RunFinished(RunEnded(outcome, HERE, {}, 0.0), ()).asks_to_quit is (outcome is Outcome.QUIT)


class Clock:
    """Timers that end when the time has come."""

    def __init__(self, monkeypatch):
        self.now, self.timers, self.written, self.received = 100.0, [], [], []
        monkeypatch.setattr(event_queue, "time", SimpleNamespace(monotonic=lambda: self.now))
        self.queue, _ = queue()
        self.reader = EventReader(
            self.queue,
            Words(),
            set_timer=self._set_timer,
            receive=self.received.append,
            write=lambda lines: self.written.append([each.text for each in lines]),
        )

    def _set_timer(self, seconds, do):
        timer = SimpleNamespace(at=self.now + seconds, do=do)
        timer.stop = lambda: self.timers.remove(timer) if timer in self.timers else None
        self.timers.append(timer)
        return timer

    def pass_to(self, now):
        due = [each for each in self.timers if each.at <= now + 1e-9]
        for each in sorted(due, key=lambda timer: timer.at):
            self.now = each.at
            self.timers.remove(each)
            each.do()
        self.now = now


def test_the_log_is_written_at_once_and_then_five_times_a_second(monkeypatch):
    """Events are taken more often; what is written late is written together, and nothing twice."""
    it = Clock(monkeypatch)
    for at, text in ((100.0, "a"), (100.06, "b"), (100.07, "c"), (100.12, "d")):
        it.pass_to(at)
        publish(it.queue, Spoke(text))
        it.reader.on_queued()
    assert it.written == [["a"]]
    assert len(it.timers) == 2  # one takes, one writes

    it.pass_to(100.2)
    assert it.written == [["a"], ["b", "c", "d"]]
    assert it.timers == []
    assert len(it.received) == 4
    publish(it.queue, Spoke("e"))
    it.reader.on_queued()
    it.reader.flush()
    assert (it.written[2:], it.timers) == ([["e"]], [])

    publish(it.queue, RunStarted("p", "w", "d", 0, "0"), Passing(HERE))
    it.reader.flush()
    assert it.received[-1] == EventBatch()
    it.reader.begun()
    assert [*it.received[-1].poses] == [HERE]
    assert it.timers == []  # there is no line to write


def test_what_is_flushed_is_written_at_once_and_the_timers_that_waited_for_it_are_stopped(monkeypatch):
    it = Clock(monkeypatch)
    for at, texts in ((100.0, "a"), (100.06, "b"), (100.07, "cd")):
        it.pass_to(at)
        for text in texts:
            publish(it.queue, Spoke(text))
            it.reader.on_queued()
    assert len(it.timers) == 2  # one takes both, one writes
    it.reader.flush()
    assert (it.written, it.timers) == ([["a"], ["b", "c", "d"]], [])
    it.pass_to(100.5)
    publish(it.queue, Spoke("e"))
    it.reader.on_queued()
    assert (it.written[2:], it.timers) == ([["e"]], [])
    it.pass_to(100.5 + 2 * FRAME)
    publish(it.queue, Spoke("f"))
    it.reader.on_queued()
    it.reader.write()
    assert (it.written[3:], it.timers) == ([["f"]], [])


def test_the_number_of_lost_lines_comes_before_the_remaining_lines():
    listener, _ = queue()
    for _ in range(MOST_LINES + 500):
        publish(listener, Spoke("again"))
    written: list[LogLine] = []
    reader = EventReader(
        listener, Words(), set_timer=lambda *_: None, receive=lambda _: None, write=written.extend
    )
    reader.take()
    reader.write()

    assert [each.text for each in written[:2]] == ["500 lines were left out.", "again"]
    assert len(written) == MOST_LINES + 1


def test_two_wakeups_are_as_good_as_one():
    assert EventsQueued().can_replace(EventsQueued())
    assert not EventsQueued().can_replace(RunBegan(HERE))


def test_the_queue_is_read_at_the_chosen_interval(monkeypatch):
    now = SimpleNamespace(seconds=100.0)
    monkeypatch.setattr(event_queue, "time", SimpleNamespace(monotonic=lambda: now.seconds))
    due: list[float] = []
    batch = SimpleNamespace(missed=0, lines=())
    it = EventReader(
        SimpleNamespace(take=lambda: batch),
        str,
        set_timer=lambda seconds, _do: due.append(seconds) or SimpleNamespace(stop=lambda: None),
        receive=lambda _batch: None,
        write=lambda _lines: None,
    )
    for frame in (FRAME, CALM):
        it.frame = frame
        it.take()
        it.on_queued()
    assert due == pytest.approx([FRAME, CALM])


async def test_little_motion_is_a_calm_map_at_the_start_and_when_it_is_chosen(open_screen):
    async with open_screen(motion="reduced") as screen:
        assert screen.app.controller.events.frame == CALM
        change(screen.app.controller.ctx, "motion", "full")
        assert screen.app.controller.events.frame == FRAME
        change(screen.app.controller.ctx, "motion", "reduced")
        assert screen.app.controller.events.frame == CALM
