"""Every listener hears every event once, in one order, whoever publishes and from wherever."""

import threading

import pytest

from donnie_tui.core.events import Answered, CueSounded, Event, Passing, Spoke, Stamped
from donnie_tui.core.hub import Hub, Stream
from tests.unit.core.values import HERE


def new_hub() -> Hub:
    return Hub(lambda: 1.5)


def test_events_are_numbered_from_one_and_carry_the_robots_time() -> None:
    hub, heard = new_hub(), list[Stamped]()
    hub.subscribe(heard.append)

    hub.publish(Spoke("a"))
    hub.publish(Spoke("b"))

    assert heard == [Stamped(1, 1.5, Spoke("a")), Stamped(2, 1.5, Spoke("b"))]


def test_an_answer_to_an_event_comes_after_it_for_every_listener() -> None:
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


def test_what_is_transient_has_no_number() -> None:
    hub, heard = new_hub(), list[Stamped]()
    hub.subscribe(heard.append)

    hub.publish(Passing(HERE))
    hub.publish(Answered("Saved."))
    hub.publish(Spoke("a"))

    assert [each.seq for each in heard] == [0, 0, 1]


def test_a_listener_that_left_hears_nothing_more() -> None:
    hub, heard = new_hub(), list[Stamped]()
    leave = hub.subscribe(heard.append)

    hub.publish(Spoke("a"))
    leave()
    hub.publish(Spoke("b"))

    assert [each.event for each in heard] == [Spoke("a")]


def test_many_threads_are_heard_in_one_order_without_gaps() -> None:
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


def test_robots_share_one_numbering_and_each_event_says_whose_it_is() -> None:
    stream, heard = Stream(), list[Stamped]()
    alice = Hub(lambda: 1.0, "alice", stream)
    bob = Hub(lambda: 2.0, "bob", stream)
    alice.subscribe(heard.append)

    alice.publish(Spoke("a"))
    bob.publish(Spoke("b"))

    assert heard == [Stamped(1, 1.0, Spoke("a"), "alice"), Stamped(2, 2.0, Spoke("b"), "bob")]


def test_who_listens_to_one_robot_hears_it_first_and_no_other() -> None:
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


def test_what_a_front_end_answers_is_no_robots() -> None:
    hub, heard = Hub(lambda: 0.0, "alice"), list[Stamped]()
    hub.subscribe(heard.append)

    hub.publish(Answered("Saved."))

    assert heard[0].robot is None
