"""Restarts a robot's board by force, its motors off: by the port's DTR wire or a pin of a Raspberry Pi.

Rule: a pin that can't be driven is logged once, and never makes the caller fail."""

from __future__ import annotations

import logging
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import Enum
from fnmatch import fnmatch
from pathlib import Path
from typing import Any, Protocol

from devices.serial_ports import GONE, SerialPort

AUTOMATIC, DTR, NONE, GPIO = "auto", "dtr", "none", "gpio"
"""What the setting may say; a pin is ``gpio:22``."""

USUAL_PIN = 22
"""The original robot's, in the Raspberry Pi's own count of its GPIO lines."""

DTR_PULSE = 0.05
"""Seconds that DTR stays at either level."""
PIN_PULSE = 0.5
"""Seconds that the pin is low, as in the original's own script."""
PIN_RISES = 0.05

_MODEL = Path("/proc/device-tree/model")
_CHIPS = Path("/dev")
_PI_PORTS = ("ttyAMA*", "ttyS0", "serial0", "serial1")

_LOG = logging.getLogger(__name__)

Pause = Callable[[float], object]


class BoardReset(Protocol):
    """A way to restart a board."""

    def pull(self, port: SerialPort | None, pause: Pause) -> bool:
        """Restart it. False if that could not be done. Never raises."""


class DtrReset:
    """Lowers and raises DTR: a board on USB restarts. Other ports have no such wire."""

    def pull(self, port: SerialPort | None, pause: Pause) -> bool:
        for level in (False, True):
            try:
                port.set_dtr(level)  # type: ignore[union-attr] # without a port it fails as without a wire
            except (*GONE, NotImplementedError, AttributeError) as error:
                _LOG.info("no reset wire: %s", error)
                return False
            pause(DTR_PULSE)
        return True


class NoReset:
    """There is no such wire."""

    def pull(self, port: SerialPort | None, pause: Pause) -> bool:  # noqa: ARG002 -- the protocol's signature
        return False


class PinFault(Enum):
    """Why a pin can't be driven."""

    PACKAGE = "package"
    """gpiod is not installed, or is older than version 2."""
    FORBIDDEN = "forbidden"
    ABSENT = "absent"
    """There is no such pin."""
    FAILED = "failed"
    """Another program drives it, or the system reports another error."""


class _PinError(Exception):
    def __init__(self, fault: PinFault, reason: object) -> None:
        super().__init__(str(reason))
        self.fault = fault


class GpioReset:
    """Holds a pin of a Raspberry Pi low for half a second, through libgpiod."""

    def __init__(self, pin: int = USUAL_PIN, chips: Path = _CHIPS) -> None:
        self.pin = pin
        self._name = f"GPIO{pin}"
        self._chips = chips
        self._is_logged = False

    def pull(self, port: SerialPort | None, pause: Pause) -> bool:  # noqa: ARG002 -- the protocol's signature
        try:
            with self._chip() as (gpiod, chip):
                self._pulse(gpiod, chip, pause)
        except _PinError as error:
            if not self._is_logged:
                _LOG.warning("%s can't reset the board: %s", self._name, error)
            self._is_logged = True
            return False
        return True

    def fault(self) -> PinFault | None:
        """Why it could not be driven, as far as that is known without driving it."""
        try:
            with self._chip():
                return None
        except _PinError as error:
            return error.fault

    def _pulse(self, gpiod: Any, chip: Any, pause: Pause) -> None:
        low, high = gpiod.line.Value.INACTIVE, gpiod.line.Value.ACTIVE
        driven = gpiod.LineSettings(direction=gpiod.line.Direction.OUTPUT, output_value=low)
        try:
            with chip.request_lines(config={self._name: driven}, consumer="donnie") as line:
                try:
                    pause(PIN_PULSE)
                finally:  # a pin that stays low keeps the board from ever starting
                    line.set_value(self._name, high)
                pause(PIN_RISES)
        except OSError as error:
            raise _PinError(_fault_of(error), error) from None

    @contextmanager
    def _chip(self) -> Iterator[tuple[Any, Any]]:
        """The gpiod package, and the chip that has the pin. Raises ``_PinError``."""
        gpiod = _import_gpiod()
        failed = _PinError(PinFault.ABSENT, f"no line is called {self._name}")
        for path in sorted(self._chips.glob("gpiochip*")):
            try:
                chip = gpiod.Chip(str(path))
            except OSError as error:
                failed = _PinError(_fault_of(error), error)
                continue
            with chip:
                if _has_line(chip, self._name):
                    yield gpiod, chip
                    return
        raise failed


def _import_gpiod() -> Any:
    try:
        import gpiod
    except ImportError as error:
        raise _PinError(PinFault.PACKAGE, error) from None
    if not hasattr(gpiod, "LineSettings"):
        raise _PinError(PinFault.PACKAGE, "gpiod is older than version 2")
    return gpiod


def _has_line(chip: Any, name: str) -> bool:
    try:
        chip.line_offset_from_id(name)
    except OSError:
        return False
    return True


def _fault_of(error: OSError) -> PinFault:
    return PinFault.FORBIDDEN if isinstance(error, PermissionError) else PinFault.FAILED


def reset_of(setting: str, port: str, model: Path = _MODEL) -> BoardReset:
    """The reset that a setting names. ``auto`` is the pin on the serial pins of a Raspberry Pi, else DTR."""
    kind, _, pin = setting.partition(":")
    if kind == GPIO:
        return GpioReset(int(pin))
    if kind == NONE:
        return NoReset()
    return GpioReset() if kind == AUTOMATIC and _is_pi_port(port, model) else DtrReset()


def _is_pi_port(port: str, model: Path) -> bool:
    try:
        is_pi = "Raspberry Pi" in model.read_text(errors="replace")
    except OSError:
        return False
    names = {os.path.basename(port), os.path.basename(os.path.realpath(port))}  # noqa: PTH119
    return is_pi and any(fnmatch(name, pattern) for name in names for pattern in _PI_PORTS)
