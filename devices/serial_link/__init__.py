"""A serial port with a robot at its other end, and the thread that owns it."""

from devices.serial_link.link import SerialLink

__all__ = ["SerialLink"]
