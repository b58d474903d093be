"""Random bytes from the boards of the robot and of the belt, for ``tests.tools.fuzz``."""

from __future__ import annotations

import pickle
import random
import re

from devices.belt import (
    COMPLAINTS,
    HOLD,
    MOTOR_PLACES,
    MOTORS,
    OFF,
    RESYNC,
    BeltCheck,
    BeltDetector,
    BeltSender,
)
from devices.wire.frames import HEADER, Decoder, encode_frame
from tests.simulated_belt import SimulatedBelt
from tests.tools.fuzz_files import Input
from tests.wire.bench import streaming


def make_serial(chance: random.Random) -> bytes:
    """Frames, complaints of a belt, halves of both, and noise."""
    pieces, is_belt = [], chance.randrange(2)
    for _ in range(chance.randrange(1, 30)):
        frame = encode_frame(chance.choice((0xC7, 0x41, 0x81, 0x68, 0x42, 0x66, 0x15, 0x73)), _data(chance))
        piece = chance.choice(COMPLAINTS) if is_belt and chance.randrange(4) == 0 else frame
        half = piece[: chance.randrange(len(piece))]
        noise = chance.randbytes(chance.randrange(60))
        pieces.append(chance.choice((piece, piece, half, HEADER, noise, half + noise)))
    return b"".join(pieces)


def _data(chance: random.Random) -> bytes:
    kind = chance.randrange(4)
    if kind == 0:
        return bytes((7, *chance.randbytes(7)))
    if kind == 1:
        return bytes((6, *(chance.randrange(3) for _ in range(6))))
    return chance.randbytes(8 if kind == 2 else chance.randrange(49))


def check_serial(data: Input) -> None:
    """Through the decoder in two chunkings, through a whole connection, and to a belt."""
    assert isinstance(data, bytes)
    whole, pieces = Decoder(lambda _: None), Decoder(lambda _: None)
    reports = [each for at in range(0, len(data), 7) for each in pieces.feed(data[at : at + 7])]
    assert whole.feed(data) == reports
    assert whole.held <= 54 + 200
    connection = streaming()
    now = 1.0
    for at in range(0, len(data), 20):
        now += 0.01
        connection.received(data[at : at + 20], now)
        connection.actions(now)
    check_belt(data)


# --- the belt

_FRAME = re.compile(rb"Z[A-P]{35}")
_STRENGTHS = {"P": 0, "C": 1, "B": 2, "A": 3}
_LONGEST_STEP = 60
_SHOWN_WITHIN = 0.5
_MOST_POLLS = 200
_MOST_KEPT = 1000
"""Bytes of two senders and two detectors, pickled."""


def check_belt(data: bytes) -> None:
    """The bytes are what the board sends, and they decide what is shown, when, and what the wire cuts off."""
    belt = _Belt(is_mute=len(data) % 2 == 1)
    at = 0
    while at < len(data):
        step = data[at : at + 1 + data[at] % _LONGEST_STEP]
        belt.live(step)
        at += len(step)
    belt.end(tuple(sum(data[motor::MOTORS]) % 4 for motor in range(MOTORS)))


class _Belt:
    """The owner of a belt. All that is received comes twice: at once, and byte by byte."""

    def __init__(self, *, is_mute: bool) -> None:
        self._is_mute = is_mute
        """Whether the board's own answers are lost."""
        self._senders = BeltSender(), BeltSender()
        self._detectors = BeltDetector(0.0), BeltDetector(0.0)
        self._board = SimulatedBelt()
        self._now = 0.0
        self._shown = [(-1.0, OFF)]
        """What was shown, and when."""
        self._sent: list[tuple[float, bytes]] = []
        self._tail = b""
        """The last bytes received."""
        self._is_known = False
        """Whether a complaint was received."""
        self._checks: list[BeltCheck] = []
        self._must_resync = True
        """At the beginning, and after a complaint about a frame."""

    def live(self, step: bytes) -> None:
        first, last = step[0], step[-1]
        if first % 3:
            number = int.from_bytes(step)
            self._show(tuple(number >> 2 * motor & 3 for motor in range(MOTORS)) if first % 5 else OFF)
        if first & 12:
            self._receive(step)
        self._poll(len(_frame_of(OFF)) if last % 4 else first % 40)
        self._now += 2 * (last / 255) ** 3  # mostly short, and beyond the seconds of a detector at times

    def end(self, levels: tuple[int, ...]) -> None:
        """The wire is good from now on: the levels are shown, and afterwards the belt is dark and silent."""
        self._show(levels)
        ends = self._now + HOLD + _SHOWN_WITHIN
        while self._now < ends:
            self._poll()
            wait = self._senders[0].wait(self._now)
            self._now = ends if wait is None else self._now + (wait or 0.01)
        if any(levels):
            moment, frame = next(each for each in reversed(self._sent) if each[1] != RESYNC)
            assert _strengths(frame) == levels
            assert self._motors_at(moment) == levels
        self._show(OFF)
        polls = 0
        while (wait := self._senders[0].wait(self._now)) is not None:
            self._now += wait
            self._poll()
            polls += 1
            assert polls < _MOST_POLLS, "the belt is never over"
        assert self._senders[0].is_over(self._now)
        assert not any(self._motors_at(self._now))
        frames = [each for _, each in self._sent if each != RESYNC]
        assert not frames or frames[-1] == _frame_of(OFF)
        assert len(pickle.dumps((self._senders, self._detectors))) <= _MOST_KEPT

    def _motors_at(self, moment: float) -> tuple[int, ...]:
        return tuple(_STRENGTHS[letter] for letter in self._board.motors(moment))

    def _show(self, levels: tuple[int, ...]) -> None:
        self._shown.append((self._now, levels))
        for sender in self._senders:
            sender.show(levels, self._now)

    def _receive(self, received: bytes) -> None:
        self._is_known |= any(each in self._tail + received for each in COMPLAINTS)
        self._tail = (self._tail + received)[-3:]
        is_framed = self._sent and self._sent[-1][1] != RESYNC
        self._must_resync |= bool(is_framed) and any(each in received for each in COMPLAINTS)
        for each in (*self._senders, *self._detectors):
            is_whole = each in (self._senders[0], self._detectors[0])
            for piece in [received] if is_whole else [bytes([byte]) for byte in received]:
                each.receive(piece)

    def _poll(self, arriving: int = 99) -> None:
        """Send what is due, of which so many bytes arrive, and take the board's answer."""
        check, other = (each.next(self._now) for each in self._detectors)
        assert check == other
        if check is not BeltCheck.NOTHING:
            assert not self._is_known, "a belt that has answered is asked or reported"
            self._checks.append(check)
            assert self._checks in ([BeltCheck.ASK], [BeltCheck.ASK, BeltCheck.REPORT_MISSING])
        if check is BeltCheck.ASK:
            for sender in self._senders:
                sender.start_over()
        is_due = self._senders[0].wait(self._now) == 0.0
        data, same = (sender.next(self._now) for sender in self._senders)
        assert data == same
        assert bool(data) == is_due
        if data:
            self._hold(data)
            self._must_resync = False
            self._sent.append((self._now, data))
            answer = self._board.feed(data[:arriving], self._now)
            self._receive(b"" if self._is_mute else answer)

    def _hold(self, data: bytes) -> None:
        """A resync or a frame: what is to be shown, or what was begun in the last quarter second."""
        if data == RESYNC:
            return
        assert not self._must_resync
        assert _FRAME.fullmatch(data), data
        wanted = self._shown[-1][1]
        recent = [levels for moment, levels in self._shown if self._now - moment < HOLD + 1e-9]
        for felt, least, *begun in zip(_strengths(data), wanted, *recent, strict=True):
            assert least <= felt <= max(least, *begun, 0)


def _strengths(frame: bytes) -> tuple[int, ...]:
    return tuple(_STRENGTHS[chr(frame[place])] for place in MOTOR_PLACES)


def _frame_of(levels: tuple[int, ...]) -> bytes:
    letters = "".join("PCBA"[level] for level in levels)
    return f"Z{'P' * 7}{letters[:7]}{'P' * 7}{letters[7:]}{'P' * 7}".encode()
