"""A serial port with a robot at its other end: what imports pyserial, but for the list of ports."""

from devices.serial_link.link import SerialLink
from devices.serial_link.port import PortProblem

__all__ = ["PortProblem", "SerialLink"]
