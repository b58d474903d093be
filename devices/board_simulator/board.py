"""The simulated board of the robot. Bytes and seconds in, bytes out; no port, no clock.

A pass of the loop reads one byte (all that wait, before it is configured), prints the parser's debug text,
and sends what is due, always including the encoders. As in the real firmware, only a MOTOR frame, a reset or
a wheel at zero stops the motors.
"""

from __future__ import annotations

import struct
from collections import deque
from enum import Enum, auto
from math import inf
from typing import Any

from msgspec import Struct

from devices.board_simulator.floor import (
    CHASSIS_2018,
    AxlePose,
    BumperSwitch,
    Chassis,
    EmptyFloor,
    Floor,
    SimulatedWheels,
)
from devices.wire.frames import HEADER, LONGEST, SONARS, CommandKind, ReportKind, checksum, encode_frame

PASSES = 750
"""Passes of the loop in a second, and so encoder frames sent and bytes read."""
QUICK_PASSES = 150
"""Passes enough to try programs with. The passes are what takes the simulator's time."""
BUFFER = 63
"""Bytes that wait to be read; the board loses what exceeds them."""
SETUP = 1.0
"""Seconds from the sketch's start to its first request for a configuration, and between two requests."""
PING = 2.0
STATUS = 0.3
SENSORS = 0.02
SONAR_SHOT = 0.05
SHOTS = ((1, 4), (2, 5), (6,), (0, 3))
"""The sonars that fire together, one group after the other."""
NO_ECHO = 141
BLINK = 0.5
CRAWL = 0.05
"""Of its speed, which the newer firmware leaves a robot whose pings are not answered."""
LOW = 7100

_CONFIG_WANTED = encode_frame(ReportKind.CONFIG_WANTED.value, b"\x2b")
_PING = encode_frame(ReportKind.PING.value, b"\x42")


class _Stage(Enum):
    BOOTING = auto()
    SETUP = auto()
    LOOP = auto()


class SimulatedBoard:
    """An Arduino with the original firmware. It starts in its boot loader, as after power-on."""

    def __init__(
        self,
        floor: Floor | None = None,
        chassis: Chassis | None = None,
        *,
        place: AxlePose | None = None,
        boot_loader: float = 1.0,
        passes: int = PASSES,
    ) -> None:
        """``boot_loader``: seconds before the sketch starts. With fewer ``passes`` a second the board is
        cheaper to simulate; it reads as many bytes a second all the same."""
        self.floor = floor or EmptyFloor()
        self.millivolts = 8000
        self.head = 90
        """The servo's angle: 0 is full left."""
        self.is_mute = False
        """A fault: the board does everything, but sends nothing."""
        self.is_deaf = False
        """A fault: the board reads nothing that is sent to it, but streams and drives on."""
        self.is_torn = False
        """A fault: the next encoder frame is torn, half of it old and half new. Once."""
        self.is_buzzing = self.vibrates_left = self.vibrates_right = False
        self.resets = 0
        self.is_newer = False
        self._boot_loader = boot_loader
        self._seconds = 1.0 / passes
        self._bytes_a_pass = max(1, PASSES // passes)
        self.wheels = SimulatedWheels(chassis or Chassis(), self.floor, place or AxlePose(), self._seconds)
        self._passes_due = 0.0
        self._start()

    @classmethod
    def of_2018(cls, floor: Floor | None = None, **how: Any) -> SimulatedBoard:
        """One with the newer firmware: other speeds, both encoders count the other way, the head is mirrored,
        and it crawls while its pings are not answered."""
        board = cls(floor, CHASSIS_2018, **how)
        board.wheels.encoders = (-1, -1)
        board.is_newer = True
        return board

    def reset(self) -> None:
        """Restart, as after its button, its reset wire or a brown-out."""
        self.resets += 1
        self.wheels.reset()
        self._start()

    @property
    def is_driving(self) -> bool:
        """Whether the motors are on."""
        return self.wheels.is_driven

    def receive(self, data: bytes) -> None:
        """Take in bytes from the host."""
        if self._stage is not _Stage.BOOTING and not self.is_deaf:
            self._unread.extend(data[: BUFFER - len(self._unread)])

    def advance(self, seconds: float) -> bytes:
        """Let time pass. Returns the bytes that the board sent."""
        self._passes_due += seconds / self._seconds
        out = bytearray()
        while self._passes_due >= 1.0:
            self._passes_due -= 1.0
            self._pass(out)
        return b"" if self.is_mute else bytes(out)

    def _start(self) -> None:
        self._stage = _Stage.BOOTING
        self._parser = FirmwareParser()
        self._unread: deque[int] = deque()
        self._time = -self._boot_loader
        self._request_at = SETUP
        self._ping_at, self._status_at, self._sensors_at, self._shot_at = PING, 0.0, 0.0, inf
        self._shot = 0
        self._ranges = [0] * SONARS
        self._is_answered, self._has_moved = True, False
        self._lamps, self._blink_at = 0b01, inf
        """When the lamp of the connection changes next; infinity while it stays on."""
        self._encoder_data = self._encoder_frame = b""

    # --- one pass of the loop

    def _pass(self, out: bytearray) -> None:
        self._time += self._seconds
        self.wheels.roll()
        match self._stage:
            case _Stage.BOOTING:
                if self._time >= 0.0:
                    self._stage = _Stage.SETUP
            case _Stage.SETUP:
                self._read(out)
                if self._stage is _Stage.SETUP and self._time >= self._request_at:
                    self._request_at += SETUP
                    out += _CONFIG_WANTED
            case _Stage.LOOP:
                self._loop(out)

    def _loop(self, out: bytearray) -> None:
        self._read(out)
        if self._time >= self._ping_at:
            self._send_ping(out)
        if self._time >= self._shot_at:
            self._fire_sonars()
        is_status_due = self._time >= self._status_at
        if is_status_due:
            self._status_at = self._time + STATUS
            out += encode_frame(ReportKind.OUTPUTS.value, bytes((5, self._output_bits())))
        if self._time >= self._sensors_at:
            self._sensors_at = self._time + SENSORS
            out += encode_frame(ReportKind.RANGES.value, bytes((SONARS, *self._ranges)))
            out += encode_frame(ReportKind.BUMPERS.value, bytes((6, *self._bumper_bits())))
        if is_status_due:
            out += encode_frame(ReportKind.POWER.value, struct.pack("<h", self.millivolts))
        out += self._encoders()

    def _read(self, out: bytearray) -> None:
        at_once = len(self._unread) if self._stage is _Stage.SETUP else self._bytes_a_pass
        for _ in range(min(at_once, len(self._unread))):
            parsed = self._parser.take(self._unread.popleft())
            out += parsed.text
            if parsed.frame:
                self._obey(parsed.frame[0], parsed.frame[1:], out)

    def _obey(self, kind: int, data: bytes, out: bytearray) -> None:
        if kind == CommandKind.CONFIG.value:
            if self._stage is _Stage.SETUP:
                self._stage = _Stage.LOOP
                self._shot_at = self._time + SONAR_SHOT
        elif self._stage is not _Stage.LOOP:
            return
        elif kind == CommandKind.PING.value:
            self._is_answered = True
            self.wheels.share = 1.0
            self._lamps |= 0b10
        elif kind == CommandKind.MOTOR.value and len(data) == 4:
            self.wheels.drive(data)
            self._has_moved = self._has_moved or self.wheels.is_driven
        elif kind == CommandKind.SERVO.value and len(data) == 2:
            self.head = min(180, data[1])
        elif kind == CommandKind.OUTPUTS.value and len(data) == 1:
            self.is_buzzing, self.vibrates_left, self.vibrates_right = (
                bool(data[0] >> n & 1) for n in (2, 3, 4)
            )
        elif kind == CommandKind.BEEP.value and len(data) == 6:
            self._beep(*struct.unpack(">HI", data), out=out)

    def _beep(self, hertz: int, milliseconds: int, *, out: bytearray) -> None:
        texts = (b"\nBeep test Start\n", b"%d" % hertz, b"\n", b"%d" % milliseconds, b"\nBeep test End\n")
        for text in texts:
            out += encode_frame(ReportKind.MESSAGE.value, text)

    # --- what the board reports

    def _send_ping(self, out: bytearray) -> None:
        self._ping_at += PING
        if not self._is_answered and self._blink_at == inf:
            self._blink_at = self._time + BLINK
            self.wheels.share = CRAWL if self.is_newer else 1.0
        self._is_answered = False
        out += _PING

    def _fire_sonars(self) -> None:
        """One group of sonars measures; it takes them no time."""
        self._shot_at += SONAR_SHOT
        for sonar in SHOTS[self._shot]:
            measured = self.floor.centimetres(
                self.wheels.place, sonar, 180 - self.head if self.is_newer else self.head
            )
            self._ranges[sonar] = NO_ECHO if measured is None else int(measured + 1e-6) & 0xFF
        self._shot = (self._shot + 1) % len(SHOTS)

    def _output_bits(self) -> int:
        bits = self._lamps | self.vibrates_right << 2 | self.vibrates_left << 3 | self.is_buzzing << 4
        self._lamps ^= 0b01 if self.millivolts < LOW or not self._lamps & 0b01 else 0
        if self._is_answered:
            self._blink_at = inf
        if self._blink_at == inf:
            self._lamps |= 0b10
        elif self._blink_at <= self._time:
            self._lamps, self._blink_at = self._lamps ^ 0b10, self._time + BLINK
        return bits

    def _bumper_bits(self) -> tuple[int, ...]:
        """NE, N, NW, SE, S, SW. Of two that are pressed together, only the bit between them is set."""
        pressed = self.floor.touched(self.wheels.place)
        ne, nw = BumperSwitch.NE in pressed, BumperSwitch.NW in pressed
        se, sw = BumperSwitch.SE in pressed, BumperSwitch.SW in pressed
        n, s = ne and nw, se and sw
        return ne and not n, n, nw and not n, se and not s, s, sw and not s

    def _encoders(self) -> bytes:
        right, left = int(self.wheels.right) & 0xFFFF, int(self.wheels.left) & 0xFFFF
        if self.is_torn:
            self.is_torn, right = False, (right + 258) & 0xFFFF
        speed = 120 if self._has_moved else 0
        data = struct.pack(">HHHH", right, left, speed, speed)
        if data != self._encoder_data:
            self._encoder_data, self._encoder_frame = data, encode_frame(ReportKind.ENCODERS.value, data)
        return self._encoder_frame


# --- how the firmware reads bytes


class _ParserState(Enum):
    IDLE = auto()
    FIRST = auto()
    LENGTH = auto()
    PAYLOAD = auto()
    CHECKSUM = auto()


class ParserOutput(Struct, frozen=True):
    """What one byte caused: printed text, and a good frame's TYPE and DATA if this was its last byte."""

    text: bytes = b""
    frame: bytes = b""


_NOTHING = ParserOutput()


class FirmwareParser:
    """The parser on the board, with its quirks and the debug text that it prints.

    After AA it waits for BB for ever, and says so at each byte. It drops a LEN above 50 in silence; a LEN of
    0 swallows a byte. It reports a wrong checksum, but never answers it. Half a frame waits for its rest for
    ever.
    """

    def __init__(self) -> None:
        self._state = _ParserState.IDLE
        self._length = 0
        self._payload = bytearray()

    def take(self, byte: int) -> ParserOutput:
        match self._state:
            case _ParserState.IDLE:
                if byte != HEADER[0]:
                    return _NOTHING
                self._state = _ParserState.FIRST
                return ParserOutput(b"\nFOUND S0")
            case _ParserState.FIRST:
                if byte == HEADER[1]:
                    self._state = _ParserState.LENGTH
                return ParserOutput(b"\nFOUND S1")
            case _ParserState.LENGTH:
                return self._begin(byte)
            case _ParserState.PAYLOAD:
                return self._collect(byte)
            case _ParserState.CHECKSUM:
                return self._finish(byte)

    def _begin(self, length: int) -> ParserOutput:
        if length > LONGEST:
            self._state = _ParserState.IDLE
            return _NOTHING
        self._length = length
        self._payload.clear()
        self._state = _ParserState.PAYLOAD
        return ParserOutput(b"\nFOUND SZ")

    def _collect(self, byte: int) -> ParserOutput:
        if self._length == 0:
            self._state = _ParserState.IDLE
            return ParserOutput(b"\nPayload overloaded\n")
        self._payload.append(byte)
        if len(self._payload) < self._length:
            return _NOTHING
        self._state = _ParserState.CHECKSUM
        return ParserOutput(b"\nPayload reveived")

    def _finish(self, byte: int) -> ParserOutput:
        self._state = _ParserState.IDLE
        payload = bytes(self._payload)
        if byte != checksum(payload):
            return ParserOutput(b"\nChecksum Error!")
        return ParserOutput(b"\nChecksum success!", payload)
