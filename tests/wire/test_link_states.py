"""The table of the link's states."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from devices.wire.connection import BoardConnection
from devices.wire.frames import MotorDrive
from devices.wire.link_state import TRANSITIONS, LinkConfig, LinkState, LinkTrigger, next_state
from tests.wire.bench import FAR

S, H = LinkState, LinkTrigger


@pytest.mark.parametrize(
    ("state", "happening", "leads_to"),
    [
        (S.CLOSED, H.OPEN, S.OPENING),
        (S.OPENING, H.OPENED, S.WAITING),
        (S.OPENING, H.FAILED, S.LOST),
        (S.WAITING, H.READY, S.STREAMING),
        (S.WAITING, H.SILENCE, S.LOST),
        (S.WAITING, H.FAILED, S.LOST),
        (S.STREAMING, H.RESTARTED, S.WAITING),
        (S.STREAMING, H.SILENCE, S.LOST),
        (S.STREAMING, H.FAILED, S.LOST),
        (S.LOST, H.OPEN, S.OPENING),
        (S.LOST, H.FRAME_RECEIVED, S.WAITING),
        (S.LOST, H.RESTARTED, S.WAITING),
        *((state, H.CLOSE, S.CLOSED) for state in S),
    ],
)
def test_each_trigger_leads_to_its_state(state: S, happening: H, leads_to: S) -> None:
    assert next_state(state, happening) is leads_to


def test_nothing_leads_from_lost_to_streaming_but_a_greeting() -> None:
    assert {happening for (state, happening), to in TRANSITIONS.items() if to is S.STREAMING} == {H.READY}
    assert {state for (state, _), to in TRANSITIONS.items() if to is S.STREAMING} == {S.WAITING}


@pytest.mark.parametrize("act", [lambda c: c.drive(0, MotorDrive.FORWARD, FAR, 1.0), lambda c: c.stop(1.0)])
def test_a_closed_connection_drives_nothing_and_has_no_actions(
    act: Callable[[BoardConnection], object],
) -> None:
    connection = BoardConnection(LinkConfig())
    act(connection)

    assert (connection.driving_since, connection.actions(1.0)) == (None, [])
