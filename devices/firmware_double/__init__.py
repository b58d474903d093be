"""A board without a board: what the original firmware does on its serial line, in pure Python, with quirks.

It ships: a program can be tried on it, and the driver's tests drive it. It is held to recordings of the real
firmware. ``SimulatedBoard`` knows no port and no clock; ``DoubleOnPty`` gives it a device path and real time,
``VirtualLine`` gives it the driver's own line and virtual time.
"""
