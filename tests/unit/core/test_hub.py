"""Every listener gets every event once and in one order, whichever thread publishes it."""

import threading
from collections.abc import Callable

import pytest

from donnie_tui.core.events import Answered, CueSounded, Event, Passing, Spoke, Stamped
from donnie_tui.core.hub import Hub, Stream
from tests.timeouts import TIMEOUT
from tests.unit.core.values import HERE


def new_hub() -> Hub:
    return Hub(lambda: 1.5)


def test_events_are_numbered_from_one_and_carry_the_robots_time() -> None:
    hub, heard = new_hub(), list[Stamped]()
    hub.subscribe(heard.append)

    hub.publish(Spoke("a"))
    hub.publish(Spoke("b"))

    assert heard == [Stamped(1, 1.5, Spoke("a")), Stamped(2, 1.5, Spoke("b"))]


def test_every_listener_gets_an_answer_after_its_event() -> None:
    hub = new_hub()
    first, second = list[Event](), list[Event]()

    def answer(stamped: Stamped) -> None:
        first.append(stamped.event)
        if isinstance(stamped.event, Spoke):
            hub.publish(CueSounded("done", 0.0, None))

    hub.subscribe(answer)
    hub.subscribe(lambda stamped: second.append(stamped.event))
    hub.publish(Spoke("a"))

    assert first == second == [Spoke("a"), CueSounded("done", 0.0, None)]


def test_a_transient_event_has_no_number() -> None:
    hub, heard = new_hub(), list[Stamped]()
    hub.subscribe(heard.append)

    hub.publish(Passing(HERE))
    hub.publish(Answered("Saved."))
    hub.publish(Spoke("a"))

    assert [each.seq for each in heard] == [0, 0, 1]


def test_an_unsubscribed_listener_gets_no_more_events() -> None:
    hub, heard = new_hub(), list[Stamped]()
    leave = hub.subscribe(heard.append)

    hub.publish(Spoke("a"))
    leave()
    hub.publish(Spoke("b"))

    assert [each.event for each in heard] == [Spoke("a")]


def test_events_of_many_threads_have_one_order_without_gaps() -> None:
    hub = new_hub()
    first, second = list[int](), list[int]()
    hub.subscribe(lambda stamped: first.append(stamped.seq))
    hub.subscribe(lambda stamped: second.append(stamped.seq))

    def publish() -> None:
        for _ in range(300):
            hub.publish(Spoke("x"))

    threads = [threading.Thread(target=publish) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    hub.wait_until_delivered(TIMEOUT)

    assert first == second == list(range(1, 1201))


def test_a_listener_that_fails_does_not_silence_the_stream() -> None:
    hub, heard = new_hub(), list[Stamped]()

    def fail(stamped: Stamped) -> None:
        if stamped.seq == 1:
            raise RuntimeError

    hub.subscribe(fail)
    hub.subscribe(heard.append)
    with pytest.raises(RuntimeError):
        hub.publish(Spoke("a"))
    hub.publish(Spoke("b"))

    assert heard[-1].event == Spoke("b")


def test_robots_share_one_numbering_and_each_event_names_its_robot() -> None:
    stream, heard = Stream(), list[Stamped]()
    alice = Hub(lambda: 1.0, "alice", stream)
    bob = Hub(lambda: 2.0, "bob", stream)
    alice.subscribe(heard.append)

    alice.publish(Spoke("a"))
    bob.publish(Spoke("b"))

    assert heard == [Stamped(1, 1.0, Spoke("a"), "alice"), Stamped(2, 2.0, Spoke("b"), "bob")]


def test_a_listener_of_one_robot_gets_its_events_first_and_no_others() -> None:
    stream, order = Stream(), list[str]()
    alice = Hub(lambda: 0.0, "alice", stream)
    bob = Hub(lambda: 0.0, "bob", stream)
    stream.subscribe(lambda _: order.append("everybody"))
    leave = alice.subscribe_to_own(lambda _: order.append("alice's"))

    alice.publish(Spoke("a"))
    bob.publish(Spoke("b"))
    leave()
    alice.publish(Spoke("c"))

    assert order == ["alice's", "everybody", "everybody", "everybody"]


def test_an_answer_of_a_front_end_belongs_to_no_robot() -> None:
    hub, heard = Hub(lambda: 0.0, "alice"), list[Stamped]()
    hub.subscribe(heard.append)

    hub.publish(Answered("Saved."))

    assert heard[0].robot is None


class Blocked:
    """A listener that hangs at the first event, until it is let go."""

    def __init__(self) -> None:
        self.hangs, self._go_on = threading.Event(), threading.Event()
        self.heard: list[int] = []

    def __call__(self, stamped: Stamped) -> None:
        if not self.heard:
            self.hangs.set()
            assert self._go_on.wait(TIMEOUT)
        self.heard.append(stamped.seq)

    def let_go(self) -> None:
        self._go_on.set()


def in_thread(deed: Callable[[], None], name: str | None = None) -> threading.Thread:
    thread = threading.Thread(target=deed, name=name, daemon=True)
    thread.start()
    return thread


def test_a_listener_that_hangs_holds_no_other_robot() -> None:
    stream, blocked = Stream(), Blocked()
    alice, bob = Hub(lambda: 0.0, "alice", stream), Hub(lambda: 0.0, "bob", stream)
    stream.subscribe(blocked)
    first = in_thread(lambda: alice.publish(Spoke("a")))
    assert blocked.hangs.wait(TIMEOUT)

    for _ in range(300):
        bob.publish(Spoke("b"))

    assert blocked.heard == []
    blocked.let_go()
    first.join(TIMEOUT)
    stream.wait_until_delivered(TIMEOUT)
    assert blocked.heard == list(range(1, 302))


def test_no_thread_delivers_the_events_of_others_without_end() -> None:
    """A thread of the stream delivers what another robot publishes meanwhile."""
    stream, blocked, deliverers = Stream(), Blocked(), list[int]()
    alice, bob = Hub(lambda: 0.0, "alice", stream), Hub(lambda: 0.0, "bob", stream)
    stream.subscribe(lambda _: deliverers.append(threading.get_ident()))
    stream.subscribe(blocked)
    first = in_thread(lambda: alice.publish(Spoke("a")))
    assert blocked.hangs.wait(TIMEOUT)
    bob.publish(Spoke("b"))
    bob.publish(Spoke("b"))
    blocked.let_go()
    first.join(TIMEOUT)
    stream.wait_until_delivered(TIMEOUT)

    assert deliverers[0] == first.ident
    assert not {first.ident, threading.get_ident()} & set(deliverers[1:])
    assert blocked.heard == [1, 2, 3]


class TwoAtOnce(Stream):
    """Thread ``a`` has delivered its events and waits until ``b`` hands over the remaining ones."""

    def __init__(self) -> None:
        super().__init__()
        self.handed_over, self.may_hand_over = threading.Event(), threading.Event()
        self.a_is_through = threading.Event()
        self.beginnings = 0

    def _next(self):
        found = super()._next()
        if isinstance(found, tuple):
            return found
        if threading.current_thread().name == "a":
            self.a_is_through.set()
            assert self.handed_over.wait(TIMEOUT)
        elif threading.current_thread().name == "b":
            self.handed_over.set()
            assert self.may_hand_over.wait(TIMEOUT)
        return found

    def _deliver_rest(self) -> None:
        self.beginnings += 1
        assert self.may_hand_over.wait(TIMEOUT)
        super()._deliver_rest()


def test_only_one_thread_continues_to_deliver() -> None:
    """A thread with nothing left to deliver ignores the hand-over of another thread."""
    stream, heard = TwoAtOnce(), list[Event]()
    hub = Hub(lambda: 0.0, None, stream)

    def listen(stamped: Stamped) -> None:
        heard.append(stamped.event)
        if stamped.event == Spoke("b"):
            in_thread(lambda: hub.publish(Spoke("c"))).join(TIMEOUT)

    hub.subscribe(listen)
    a = in_thread(lambda: hub.publish(Spoke("a")), "a")
    assert stream.a_is_through.wait(TIMEOUT)
    b = in_thread(lambda: hub.publish(Spoke("b")), "b")
    a.join(TIMEOUT)
    stream.may_hand_over.set()
    b.join(TIMEOUT)
    for each in threading.enumerate():
        if each.name == "stream":
            each.join(TIMEOUT)

    assert stream.beginnings == 1
    assert heard == [Spoke("a"), Spoke("b"), Spoke("c")]


def test_a_program_that_publishes_too_much_waits_after_its_event_and_delays_no_other() -> None:
    stream, heard = Stream(), list[Event]()
    waits, may_go_on = threading.Event(), threading.Event()
    alice, bob = Hub(lambda: 0.0, "alice", stream), Hub(lambda: 0.0, "bob", stream)
    stream.subscribe(lambda stamped: heard.append(stamped.event))

    def gate(robot: str | None) -> None:
        waits.set()
        assert robot == "alice"
        assert may_go_on.wait(TIMEOUT)

    stream.add_gate(gate)

    def program() -> None:
        alice.hold_back_here()
        alice.publish(Spoke("a"))
        alice.publish(Spoke("more"))

    running = in_thread(program)
    assert waits.wait(TIMEOUT)
    bob.publish(Spoke("b"))
    alice.publish(Answered("Speed 2."))

    assert heard == [Spoke("a"), Spoke("b"), Answered("Speed 2.")]
    may_go_on.set()
    running.join(TIMEOUT)
    assert heard[-1] == Spoke("more")


def test_an_answer_to_a_program_comes_before_its_next_event(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Otherwise a recording would depend on the moment of a key press."""
    monkeypatch.setattr("donnie_tui.core.hub.LONGEST_TURN", 20.0, raising=False)
    hub, blocked, heard = new_hub(), Blocked(), list[Event]()
    hub.subscribe(blocked)
    hub.subscribe(lambda stamped: heard.append(stamped.event))
    hub.subscribe(lambda stamped: hub.publish(Spoke("answer")) if stamped.event == Spoke("first") else None)
    other = in_thread(lambda: hub.publish(Answered("Speed 2.")))
    assert blocked.hangs.wait(TIMEOUT)

    def program() -> None:
        hub.hold_back_here()
        hub.publish(Spoke("first"))
        hub.publish(Spoke("next"))

    running = in_thread(program)
    while not hub._stream._waiting:
        threading.Event().wait(0.001)
    blocked.let_go()
    running.join(TIMEOUT)
    other.join(TIMEOUT)
    hub.wait_until_delivered(TIMEOUT)

    assert heard == [Answered("Speed 2."), Spoke("first"), Spoke("answer"), Spoke("next")]


def test_a_listener_that_hangs_forever_slows_a_program_but_does_not_stop_it() -> None:
    stream, blocked = Stream(), Blocked()
    alice, bob = Hub(lambda: 0.0, "alice", stream), Hub(lambda: 0.0, "bob", stream)
    stream.subscribe(blocked)
    in_thread(lambda: alice.publish(Spoke("a")))
    assert blocked.hangs.wait(TIMEOUT)

    def program() -> None:
        bob.hold_back_here()
        for _ in range(10_002):
            bob.publish(Spoke("b"))

    running = in_thread(program)
    running.join(TIMEOUT)

    assert not running.is_alive()
    blocked.let_go()


@pytest.mark.parametrize(
    ("waiting", "place", "waits"),
    [(10_000, 0, []), (10_001, 0, [0.05]), (10_000, 1, [0.5]), (10_001, 1, [0.5, 0.05])],
)
def test_a_program_waits_half_a_second_for_its_event_and_a_twentieth_for_ten_thousand_others(
    monkeypatch: pytest.MonkeyPatch, waiting: int, place: int, waits: list[float]
) -> None:
    stream, waited = Stream(), list[float]()
    monkeypatch.setattr(stream, "_wait_for", lambda _, seconds: waited.append(seconds))
    stream._waiting.extend([(1, Stamped(1, 0.0, Spoke("a")), stream.listeners())] * waiting)
    stream.wait_for_room(None, place)

    assert waited == waits
    Hub(lambda: 0.0, stream=stream).wait_until_delivered()
    assert waited == [*waits, 2.0]


def test_a_recorded_event_is_passed_on_as_it_is_and_takes_no_number() -> None:
    stream, heard = Stream(), list[Stamped]()
    stream.subscribe(heard.append)
    hub = Hub(lambda: 1.0, "alice", stream)
    recorded = Stamped(7, 3.0, Spoke("a"), "bob")
    stream.pass_on(recorded)
    hub.publish(Spoke("b"))

    assert heard == [recorded, Stamped(1, 1.0, Spoke("b"), "alice")]


def test_a_gate_holds_only_a_program_and_only_until_it_is_removed() -> None:
    hub, passed = Hub(lambda: 0.0, "alice"), list[str | None]()
    leave, leave_other = hub.add_gate(passed.append), hub.add_gate(lambda _: passed.append("other"))
    hub.publish(Spoke("before"))
    assert passed == []
    hub.hold_back_here()
    hub.publish(Spoke("a"))
    assert passed == ["alice", "other"]
    leave()
    hub.publish(Spoke("b"))
    assert passed == ["alice", "other", "other"]
    leave_other()
    hub.publish(Spoke("c"))
    hub.add_gate(passed.append)
    hub.stop_holding_back()
    hub.publish(Spoke("d"))
    assert passed == ["alice", "other", "other"]


def test_an_answer_to_an_event_waits_at_no_gate() -> None:
    """It is published during a delivery, which must go on."""
    hub, passed, heard = new_hub(), list[str | None](), list[Event]()
    hub.subscribe(lambda stamped: heard.append(stamped.event))
    hub.subscribe(lambda stamped: hub.publish(Spoke("2")) if stamped.event == Spoke("1") else None)
    hub.add_gate(passed.append)
    hub.hold_back_here()
    hub.publish(Spoke("1"))

    assert (heard, passed) == ([Spoke("1"), Spoke("2")], [None])


def test_an_event_whose_listener_failed_counts_as_delivered() -> None:
    hub, failing = new_hub(), [True]

    def fail(_: Stamped) -> None:
        if failing:
            failing.clear()
            raise RuntimeError

    hub.subscribe(fail)
    with pytest.raises(RuntimeError):
        hub.publish(Spoke("a"))
    hub.publish(Spoke("b"))

    assert (hub._stream._delivered, hub._stream._queued) == (2, 2)


def test_a_listener_that_leaves_during_a_delivery_still_gets_that_event() -> None:
    hub, heard = new_hub(), list[Stamped]()
    leaves = list[Callable[[], None]]()
    hub.subscribe(lambda _: leaves.pop()() if leaves else None)
    leaves.append(hub.subscribe(heard.append))
    hub.publish(Spoke("a"))
    hub.publish(Spoke("b"))

    assert [each.event for each in heard] == [Spoke("a")]


def test_a_failing_listener_of_the_streams_own_thread_is_logged(caplog: pytest.LogCaptureFixture) -> None:
    stream, blocked = Stream(), Blocked()
    alice, bob = Hub(lambda: 0.0, "alice", stream), Hub(lambda: 0.0, "bob", stream)
    stream.subscribe(blocked)

    def fail(stamped: Stamped) -> None:
        if stamped.event == Spoke("b"):
            raise RuntimeError("of a screen")

    stream.subscribe(fail)
    first = in_thread(lambda: alice.publish(Spoke("a")))
    assert blocked.hangs.wait(TIMEOUT)
    bob.publish(Spoke("b"))
    blocked.let_go()
    first.join(TIMEOUT)
    for each in threading.enumerate():
        if each.name == "stream":
            each.join(TIMEOUT)

    assert "a listener failed" in caplog.text
    assert "of a screen" in caplog.text
    alice.publish(Spoke("c"))
    assert blocked.heard == [1, 2, 3]
