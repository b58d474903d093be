"""The firmware's loop: bytes in, seconds go by, bytes out. No port, no clock, no thread.

A pass of the loop reads one byte (all there are, before it is configured), prints what the parser says about
it, sends whatever is due and always the encoders. Nothing ever stops the motors but a MOTOR frame, a reset or
a wheel at zero: that is the point.
"""

from __future__ import annotations

import struct
from collections import deque
from enum import Enum, auto

from devices.firmware_double.chassis import Chassis, Wheels
from devices.firmware_double.receiver import Receiver
from devices.firmware_double.surroundings import OpenFloor, Place, Surroundings, Switch
from devices.wire.commands import Command, frame
from devices.wire.reports import SONARS, ReportKind

PASSES = 750
"""Passes of the loop in a second, and so encoder frames and bytes read."""
BUFFER = 63
"""Bytes that wait to be read; what comes beyond them is lost."""
SETUP = 1.0
"""Seconds from the sketch's start to its first wish for a configuration, and between two of them."""
PING = 2.0
STATUS = 0.3
SENSORS = 0.02
SONAR_SHOT = 0.05
SHOTS = ((1, 4), (2, 5), (6,), (0, 3))
"""The sonars that fire together, one group after the other."""
NO_ECHO = 141
BLINK = 0.5
LOW = 7100

_CONFIG_WANTED = frame(ReportKind.CONFIG_WANTED.value, b"\x2b")
_PING = frame(ReportKind.PING.value, b"\x42")


class _Stage(Enum):
    BOOTING = auto()
    SETUP = auto()
    LOOP = auto()


class SimulatedBoard:
    """An Arduino with the original firmware. It begins in its boot loader, as after power-on."""

    def __init__(
        self,
        surroundings: Surroundings | None = None,
        chassis: Chassis | None = None,
        *,
        place: Place | None = None,
        boot_loader: float = 1.0,
        passes: int = PASSES,
    ) -> None:
        """``boot_loader``: seconds before the sketch begins. Fewer ``passes`` a second than the real board's
        make it cheaper to simulate; it reads as many bytes a second all the same."""
        self.surroundings = surroundings or OpenFloor()
        self.millivolts = 8000
        self.head = 90
        """The servo's angle: 0 is full left."""
        self.is_mute = False
        """A fault: it does all that it should, and tells nothing."""
        self.is_torn = False
        """A fault: the next encoder frame is torn, half of it old and half new. Once."""
        self.is_buzzing = self.vibrates_left = self.vibrates_right = False
        self.resets = 0
        self._boot_loader = boot_loader
        self._seconds = 1.0 / passes
        self._bytes_a_pass = max(1, PASSES // passes)
        self.wheels = Wheels(chassis or Chassis(), self.surroundings, place or Place(), self._seconds)
        self._owed = 0.0
        self._begin()

    def reset(self) -> None:
        """As its button, its reset line or a brown-out does it."""
        self.resets += 1
        self.wheels.off()
        self._begin()

    @property
    def is_driving(self) -> bool:
        """Whether the motors are on."""
        return self.wheels.is_driven

    @property
    def is_configured(self) -> bool:
        return self._stage is _Stage.LOOP

    def receive(self, data: bytes) -> None:
        """Bytes that come in on the wire."""
        if self._stage is not _Stage.BOOTING:
            self._unread.extend(data[: BUFFER - len(self._unread)])

    def advance(self, seconds: float) -> bytes:
        """Let time go by. Answers the bytes that went out."""
        self._owed += seconds / self._seconds
        out = bytearray()
        while self._owed >= 1.0:
            self._owed -= 1.0
            self._pass(out)
        return b"" if self.is_mute else bytes(out)

    # --- one pass

    def _begin(self) -> None:
        self._stage = _Stage.BOOTING
        self._receiver = Receiver()
        self._unread: deque[int] = deque()
        self._time = -self._boot_loader
        self._wish_at = SETUP
        self._ping_at, self._status_at, self._sensors_at = PING, 0.0, 0.0
        self._shot_at, self._shot = 0.0, 0
        self._ranges = [0] * SONARS
        self._is_answered, self._has_moved = True, False
        self._lamps = 0b01
        self._blink_at = 0.0
        self._encoder_data = self._encoder_frame = b""

    def _pass(self, out: bytearray) -> None:
        self._time += self._seconds
        self.wheels.roll()
        match self._stage:
            case _Stage.BOOTING:
                if self._time >= 0.0:
                    self._stage = _Stage.SETUP
            case _Stage.SETUP:
                self._read(out)
                if self._stage is _Stage.SETUP and self._time >= self._wish_at:
                    self._wish_at += SETUP
                    out += _CONFIG_WANTED
            case _Stage.LOOP:
                self._loop(out)

    def _loop(self, out: bytearray) -> None:
        self._read(out)
        if self._time >= self._ping_at:
            self._ping(out)
        if self._time >= self._shot_at:
            self._shoot()
        is_status_due = self._time >= self._status_at
        if is_status_due:
            self._status_at = self._time + STATUS
            out += frame(ReportKind.OUTPUTS.value, bytes((5, self._output_bits())))
        if self._time >= self._sensors_at:
            self._sensors_at = self._time + SENSORS
            out += frame(ReportKind.RANGES.value, bytes((SONARS, *self._ranges)))
            out += frame(ReportKind.BUMPERS.value, bytes((6, *self._bumper_bits())))
        if is_status_due:
            out += frame(ReportKind.POWER.value, struct.pack("<h", self.millivolts))
        out += self._encoders()

    def _read(self, out: bytearray) -> None:
        at_once = len(self._unread) if self._stage is _Stage.SETUP else self._bytes_a_pass
        for _ in range(min(at_once, len(self._unread))):
            taken = self._receiver.take(self._unread.popleft())
            out += taken.text
            if taken.frame:
                self._obey(taken.frame[0], taken.frame[1:], out)

    def _obey(self, kind: int, data: bytes, out: bytearray) -> None:
        if kind == Command.CONFIG.value:
            self._configured()
        elif self._stage is not _Stage.LOOP:
            return
        elif kind == Command.PING.value:
            self._is_answered = True
            self._lamps |= 0b10
        elif kind == Command.MOTOR.value and len(data) == 4:
            self.wheels.drive(data)
            self._has_moved = self._has_moved or self.wheels.is_driven
        elif kind == Command.SERVO.value and len(data) == 2:
            self.head = min(180, data[1])
        elif kind == Command.OUTPUTS.value and len(data) == 1:
            self.is_buzzing, self.vibrates_left, self.vibrates_right = (
                bool(data[0] >> n & 1) for n in (2, 3, 4)
            )
        elif kind == Command.BEEP.value and len(data) == 6:
            self._beep(*struct.unpack(">HI", data), out=out)

    def _configured(self) -> None:
        if self._stage is _Stage.SETUP:
            self._stage = _Stage.LOOP
            self._shot_at = self._time + SONAR_SHOT

    def _beep(self, hertz: int, milliseconds: int, *, out: bytearray) -> None:
        told = (b"\nBeep test Start\n", b"%d" % hertz, b"\n", b"%d" % milliseconds, b"\nBeep test End\n")
        for text in told:
            out += frame(ReportKind.MESSAGE.value, text)

    # --- what is told

    def _ping(self, out: bytearray) -> None:
        self._ping_at += PING
        if not self._is_answered and self._blink_at <= 0.0:
            self._blink_at = self._time + BLINK
        self._is_answered = False
        out += _PING

    def _shoot(self) -> None:
        """One group of sonars measures; it took them no time."""
        self._shot_at += SONAR_SHOT
        for sonar in SHOTS[self._shot]:
            met = self.surroundings.centimetres(self.wheels.place, sonar, self.head)
            self._ranges[sonar] = NO_ECHO if met is None else int(met + 1e-6) & 0xFF
        self._shot = (self._shot + 1) % len(SHOTS)

    def _output_bits(self) -> int:
        bits = self._lamps | self.vibrates_right << 2 | self.vibrates_left << 3 | self.is_buzzing << 4
        self._lamps ^= 0b01 if self.millivolts < LOW or not self._lamps & 0b01 else 0
        if self._is_answered:
            self._lamps, self._blink_at = self._lamps | 0b10, 0.0
        elif 0.0 < self._blink_at <= self._time:
            self._lamps, self._blink_at = self._lamps ^ 0b10, self._time + BLINK
        else:
            self._lamps |= 0b10 if self._blink_at <= 0.0 else 0
        return bits

    def _bumper_bits(self) -> tuple[int, ...]:
        """NE, N, NW, SE, S, SW: of two that are pressed together, only the one between is told."""
        pressed = self.surroundings.touched(self.wheels.place)
        ne, nw, se, sw = (each in pressed for each in (Switch.NE, Switch.NW, Switch.SE, Switch.SW))
        n, s = ne and nw, se and sw
        return ne and not n, n, nw and not n, se and not s, s, sw and not s

    def _encoders(self) -> bytes:
        right, left = int(self.wheels.right) & 0xFFFF, int(self.wheels.left) & 0xFFFF
        if self.is_torn:
            self.is_torn, right = False, (right + 258) & 0xFFFF
        speed = 120 if self._has_moved else 0
        data = struct.pack(">HHHH", right, left, speed, speed)
        if data != self._encoder_data:
            self._encoder_data, self._encoder_frame = data, frame(ReportKind.ENCODERS.value, data)
        return self._encoder_frame
