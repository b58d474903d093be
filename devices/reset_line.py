"""What restarts a board by force, its motors off: the port's own wire (DTR), or a pin of a Raspberry Pi.

Rule: a pin that can't be driven is written to the log once, and never fails what wanted it.
"""

from __future__ import annotations

import logging
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import Enum
from fnmatch import fnmatch
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from devices.serial_port import GONE

if TYPE_CHECKING:
    import serial

AUTOMATIC, DTR, NONE, GPIO = "auto", "dtr", "none", "gpio"
"""What a setting may say; a pin is ``gpio:22``."""

USUAL_PIN = 22
"""The original's, by the Raspberry Pi's own count of its GPIO lines."""

DTR_PULSE = 0.05
"""Seconds that DTR is held at either level."""
PIN_PULSE = 0.5
"""Seconds that the pin is low, as the original's own script has it."""
PIN_RISES = 0.05

_MODEL = Path("/proc/device-tree/model")
_CHIPS = Path("/dev")
_PI_PORTS = ("ttyAMA*", "ttyS0", "serial0", "serial1")

_LOG = logging.getLogger(__name__)

Pause = Callable[[float], object]


class Reset(Protocol):
    """A way to restart a board."""

    def pull(self, port: serial.SerialBase | None, pause: Pause) -> bool:
        """Do it; whether it could be done. Never raises."""


class DtrReset:
    """Lets DTR fall and rise: a board on USB restarts. Other lines have no such wire."""

    def pull(self, port: serial.SerialBase | None, pause: Pause) -> bool:
        for level in (False, True):
            try:
                port.dtr = level  # type: ignore[union-attr] # without a port it fails as without a wire
            except (*GONE, NotImplementedError, AttributeError) as error:
                _LOG.info("no reset line: %s", error)
                return False
            pause(DTR_PULSE)
        return True


class NoReset:
    """There is no such wire."""

    def pull(self, port: serial.SerialBase | None, pause: Pause) -> bool:  # noqa: ARG002 -- the interface
        return False


class PinFault(Enum):
    """Why a pin can't be driven."""

    PACKAGE = "package"
    """gpiod is not installed, or not its second version."""
    FORBIDDEN = "forbidden"
    ABSENT = "absent"
    """There is no such pin."""
    FAILED = "failed"
    """Another program drives it, or the system says something else."""


class _PinError(Exception):
    def __init__(self, fault: PinFault, reason: object) -> None:
        super().__init__(str(reason))
        self.fault = fault


class GpioReset:
    """Holds a pin of a Raspberry Pi low for half a second, by libgpiod."""

    def __init__(self, pin: int = USUAL_PIN, chips: Path = _CHIPS) -> None:
        self.pin = pin
        self._chips = chips
        self._is_told = False

    def pull(self, port: serial.SerialBase | None, pause: Pause) -> bool:  # noqa: ARG002 -- the interface
        try:
            with self._chip() as (gpiod, chip):
                self._pulse(gpiod, chip, pause)
        except _PinError as error:
            if not self._is_told:
                _LOG.warning("GPIO%d can't reset the board: %s", self.pin, error)
            self._is_told = True
            return False
        return True

    def fault(self) -> PinFault | None:
        """Why it could not be driven, as far as that is known without driving it."""
        try:
            with self._chip():
                return None
        except _PinError as error:
            return error.fault

    @property
    def _name(self) -> str:
        return f"GPIO{self.pin}"

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
        """The package, and the chip that has a line of that name. Raises ``_PinError``."""
        gpiod = _package()
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


def _package() -> Any:
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


def reset_of(setting: str, port: str, model: Path = _MODEL) -> Reset:
    """What the setting says; automatically the pin for the serial pins of a Raspberry Pi, and DTR else."""
    kind, _, pin = setting.partition(":")
    if kind == GPIO:
        return GpioReset(int(pin))
    if kind == NONE:
        return NoReset()
    return GpioReset() if kind == AUTOMATIC and _is_pi_pins(port, model) else DtrReset()


def _is_pi_pins(port: str, model: Path) -> bool:
    try:
        is_pi = "Raspberry Pi" in model.read_text(errors="replace")
    except OSError:
        return False
    names = {os.path.basename(port), os.path.basename(os.path.realpath(port))}  # noqa: PTH119
    return is_pi and any(fnmatch(name, pattern) for name in names for pattern in _PI_PORTS)
