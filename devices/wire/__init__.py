"""What goes over the robot's serial line, byte by byte: no port, no thread, no clock of its own.

Bytes and the time of day come in as values, and bytes go out as values, so that every rule of the line can
be tested without a line. Standard library only.
"""
